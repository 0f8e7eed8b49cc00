"""Trace parts into one flat model. Runs once for every structure; numbers stay symbols."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from typing import Any

from poppet.model import FlowInfo, InputInfo, Model, StateInfo, StoreInfo
from poppet.parts.part import Balance, Flow, Gas, Part, Passage, Passing, Scope, Store, Surroundings

SURROUNDINGS = (
    "ambient.pressure",
    "ambient.temperature",
    "gas.gas_constant",
    "gas.isentropic_exponent",
    "gas.conductance_factor",
)
AMBIENT = "ambient"
"""Reserved name of the open air, to which any port may be joined."""


def trace(parts: Mapping[str, Part], parameters: tuple[str, ...]) -> Model:
    """Trace the parts of a circuit.

    Parameters
    ----------
    parts : mapping
        Name to part, in file order, wiring already checked.
    parameters : tuple of str
        Addresses of all run-time numbers, the surroundings last.

    Returns
    -------
    Model
        Symbolic model.
    """
    return _Tracer(parts, parameters).model()


class _Tracer:
    def __init__(self, parts: Mapping[str, Part], parameters: tuple[str, ...]) -> None:
        import casadi as ca

        self.ca, self.parts, self.names = ca, parts, parameters
        self.p = ca.SX.sym("p", len(parameters))
        self.number = {name: self.p[k] for k, name in enumerate(parameters)}
        self.surroundings = Surroundings(*(self.number[name] for name in SURROUNDINGS))
        self.states = [(name, state) for name, part in parts.items() for state in part.states()]
        self.inputs = [(name, item) for name, part in parts.items() for item in part.inputs()]
        stores = [name for name, part in parts.items() if isinstance(part, Store) and part.states()]
        self.passages = {name: part for name, part in parts.items() if isinstance(part, Passage)}
        self.stores = stores
        self.t, self.u = ca.SX.sym("t"), ca.SX.sym("u", len(self.inputs))

    def scope(self, name: str, states: Mapping[str, Any]) -> Scope:
        prefix = f"{name}."
        own = {key[len(prefix) :]: value for key, value in self.number.items() if key.startswith(prefix)}
        inputs = {item.name: self.u[k] for k, (part, item) in enumerate(self.inputs) if part == name}
        return Scope(own, states, inputs, self.surroundings)

    def model(self) -> Model:
        ca = self.ca
        controlled = [ca.SX.sym(f"{name}.{state.name}") for name, state in self.states]
        by_part: dict[str, dict[str, Any]] = defaultdict(dict)
        for (name, state), symbol in zip(self.states, controlled, strict=True):
            by_part[name][state.name] = symbol
        scopes = {name: self.scope(name, by_part[name]) for name in self.parts}
        passing = self._passing(scopes)
        balances = self._balances(scopes, passing)
        rates = [self._rate(name, state.name, passing, balances) for name, state in self.states]
        flows, quadratures = self._quadratures(passing)
        stores = self._store_infos(balances, quadratures, len(self.states))
        x = ca.vertcat(*controlled, ca.SX.sym("integrals", len(quadratures)))
        outputs = self._outputs(scopes, passing, balances)
        energies = [balances[store.name].energy for store in stores if store.has_energy]
        expressions = {
            "rates": ca.vertcat(*rates, *quadratures),
            "outputs": ca.vertcat(*(value for value, _ in outputs.values())),
            "start": ca.vertcat(*self._start(), *([0.0] * len(quadratures))),
            "energy": ca.vertcat(*energies),
        }
        return Model(
            states=tuple(
                StateInfo(f"{name}.{s.name}", s.unit, s.nominal, s.tolerance, s.floor, s.positive)
                for name, s in self.states
            ),
            n_quadratures=len(quadratures),
            inputs=tuple(self._input_info(name, item) for name, item in self.inputs),
            parameters=self.names,
            outputs=tuple((name, unit) for name, (_, unit) in outputs.items()),
            flows=tuple(flows),
            stores=tuple(stores),
            symbols={"t": self.t, "x": x, "u": self.u, "p": self.p},
            expressions={name: ca.SX(value) for name, value in expressions.items()},
        )

    def _passing(self, scopes: Mapping[str, Scope]) -> dict[str, Passing]:
        gas = {name: part.gas(scopes[name]) for name, part in self.parts.items() if isinstance(part, Store)}
        gas.setdefault(AMBIENT, Gas(self.surroundings.pressure, self.surroundings.temperature))
        return {
            name: part.passing(scopes[name], {port: gas[store] for port, store in part.ports().items()})
            for name, part in self.passages.items()
        }

    def _ends(self, name: str, flow: Flow) -> tuple[str | None, str | None]:
        ports = self.parts[name].ports()
        return (ports[flow.source] if flow.source else None), (ports[flow.target] if flow.target else None)

    def _balances(self, scopes: Mapping[str, Scope], passing: Mapping[str, Passing]) -> dict[str, Balance]:
        arriving: dict[str, list[tuple[Any, Any]]] = defaultdict(list)
        for name, result in passing.items():
            for flow in result.flows:
                source, target = self._ends(name, flow)
                if source is not None:
                    arriving[source].append((-flow.mass, -flow.enthalpy))
                if target is not None:
                    arriving[target].append((flow.mass, flow.enthalpy))
        return {
            name: part.balance(scopes[name], tuple(arriving[name]))
            for name, part in self.parts.items()
            if isinstance(part, Store)
        }

    def _rate(self, name: str, state: str, passing: Mapping[str, Passing], balances: Mapping[str, Balance]) -> Any:
        return (passing[name].rates if name in passing else balances[name].rates)[state]

    def _quadratures(self, passing: Mapping[str, Passing]) -> tuple[list[FlowInfo], list[Any]]:
        flows: list[FlowInfo] = []
        quadratures: list[Any] = []
        offset = len(self.states)
        for name, result in passing.items():
            for flow in result.flows:
                place = offset + len(quadratures)
                source, target = self._ends(name, flow)
                flows.append(FlowInfo(f"{name}.{flow.name}", source, target, place, place + 1))
                quadratures += [flow.mass, flow.enthalpy]
        return flows, quadratures

    def _store_infos(self, balances: Mapping[str, Balance], quadratures: list[Any], offset: int) -> list[StoreInfo]:
        places = {f"{name}.{state.name}": k for k, (name, state) in enumerate(self.states)}
        infos = []
        for name in self.stores:
            infos.append(
                StoreInfo(name, places[f"{name}.mass"], offset + len(quadratures), balances[name].energy is not None)
            )
            quadratures.append(balances[name].heat)
        return infos

    def _start(self) -> list[Any]:
        starts = {name: part.start(self.scope(name, {})) for name, part in self.parts.items()}
        return [starts[name][state.name] for name, state in self.states]

    def _outputs(
        self, scopes: Mapping[str, Scope], passing: Mapping[str, Passing], balances: Mapping[str, Balance]
    ) -> dict[str, tuple[Any, str]]:
        """Outputs of all parts in file order: of each part its inputs first."""
        result: dict[str, tuple[Any, str]] = {}
        for name, part in self.parts.items():
            own = passing[name].outputs if name in passing else balances[name].outputs
            for item in part.inputs():
                result[f"{name}.{item.name}"] = scopes[name].inputs[item.name], item.unit
            for local, value in own.items():
                result[f"{name}.{local}"] = value
        return result

    def _input_info(self, name: str, item: Any) -> InputInfo:
        default = f"{name}.{item.default}" if isinstance(item.default, str) else item.default
        delay = f"{name}.{item.delay}" if item.delay else ""
        return InputInfo(f"{name}.{item.name}", item.unit, item.kind, default, item.low, item.high, delay)
