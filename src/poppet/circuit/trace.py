"""Trace parts into one flat model. Runs once for every structure; numbers stay symbols."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from graphlib import CycleError, TopologicalSorter
from typing import Any

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.engine.model import FlowInfo, InputInfo, Model, StateInfo, StoreInfo
from poppet.parts.compound import expand_compounds
from poppet.parts.part import (
    AMBIENT,
    SELF,
    Actuator,
    ActuatorForce,
    Body,
    BodyDynamics,
    BodyMotion,
    Controller,
    GasBalance,
    GasState,
    Part,
    Passage,
    PassageFlows,
    Scope,
    Store,
    Surroundings,
)

SURROUNDINGS = (
    "ambient.pressure",
    "ambient.temperature",
    "gas.gas_constant",
    "gas.isentropic_exponent",
    "gas.conductance_factor",
    "gas.ratio_shift",
)


def trace(
    parts: Mapping[str, Part], parameters: tuple[str, ...], connections: Mapping[str, str] | None = None
) -> Model:
    """Trace the parts of a circuit."""
    return _Tracer(parts, connections or {}, parameters).model()


class _Tracer:
    def __init__(self, parts: Mapping[str, Part], connections: Mapping[str, str], parameters: tuple[str, ...]) -> None:
        import casadi as ca

        self.ca, self.whole, self.names = ca, parts, parameters
        self.parts, self.connections, self.shown = expand_compounds(parts, connections)
        self.p = ca.SX.sym("p", len(parameters))
        self.number = {name: self.p[k] for k, name in enumerate(parameters)}
        self.surroundings = Surroundings(*(self.number[name] for name in SURROUNDINGS))
        self.states = self._elements("states")
        self.symbols = {f"{name}.{s.name}": ca.SX.sym(f"{name}.{s.name}") for name, s in self.states}
        every = [(name, item) for name, part in self.parts.items() for item in part.inputs()]
        # Slopes of connected inputs, by address, with the address of the input.
        self.slopes = {
            f"{name}.{item.name}": f"{name}.{item.slope_of}"
            for name, item in every
            if f"{name}.{item.slope_of}" in self.connections
        }
        given = {*self.connections, *self.slopes}
        self.inputs = [(name, item) for name, item in every if f"{name}.{item.name}" not in given]
        # Connected inputs have no place in u: nobody drives them from outside.
        self.t, self.u = ca.SX.sym("t"), ca.SX.sym("u", len(self.inputs))
        self.input = {f"{name}.{item.name}": self.u[k] for k, (name, item) in enumerate(self.inputs)}
        # Placeholders: what a connected input takes is known only when every part has been traced.
        self.joined = {address: ca.SX.sym(address) for address in (*self.connections, *self.slopes)}
        # The sort is stable: timers of one rank act in the order of the parts.
        self.timers = sorted(self._elements("timers"), key=lambda each: each[1].rank)
        self.remembered = self._elements("memory")
        self.z = ca.SX.sym("z", len(self.timers) + len(self.remembered))
        self.memory_names = [f"{name}.{each.name}" for name, each in [*self.timers, *self.remembered]]
        self.memory = {name: self.z[k] for k, name in enumerate(self.memory_names)}

    def _elements(self, kind: str) -> list[tuple[str, Any]]:
        return [(name, each) for name, part in self.parts.items() for each in getattr(part, kind)()]

    def scope(self, name: str, *, at_start: bool = False) -> Scope:
        """What a part sees; at the start neither states nor memory."""
        start = f"{name}."

        def own(values: Mapping[str, Any]) -> dict[str, Any]:
            return {key[len(start) :]: value for key, value in values.items() if key.startswith(start)}

        inputs = own({**self.input, **self.joined})
        states, memory = ({}, {}) if at_start else (own(self.symbols), own(self.memory))
        motion = self._motion(self.parts[name].body_name(), at_start)
        return Scope(own(self.number), states, inputs, self.surroundings, memory, self.t, motion)

    def _motion(self, name: str | None, at_start: bool) -> BodyMotion | None:
        """That of the body of a part."""
        if name is None:
            return None
        body = self.parts[name]
        assert isinstance(body, Body)
        scope = self.scope(name, at_start=at_start)
        return body.motion(replace(scope, states=body.start(scope)) if at_start else scope)

    def _ports(self, name: str) -> dict[str, str]:
        """Ports of a part; a member names another of the same whole with a dot in front."""
        whole = name.rpartition(".")[0]
        return {port: f"{whole}{at}" if at.startswith(".") else at for port, at in self.parts[name].ports().items()}

    def model(self) -> Model:
        ca = self.ca
        scopes = {name: self.scope(name) for name in self.parts}
        gas = {name: part.gas(scopes[name]) for name, part in self.parts.items() if isinstance(part, Store)}
        gas.setdefault(AMBIENT, GasState(self.surroundings.pressure, self.surroundings.temperature))
        passing = self._passing(scopes, gas)
        balances = self._balances(scopes, passing)
        pushes = self._pushes(scopes, gas)
        moved = self._moved(scopes, pushes)
        controls = {n: part.control(scopes[n]) for n, part in self.parts.items() if isinstance(part, Controller)}
        # The order of their outputs in a recording.
        results: tuple[Mapping[str, Any], ...] = (balances, passing, moved, pushes, controls)
        every = self._every_output(scopes, results)
        found: dict[str, dict[str, Any]] = {name: {} for name in self.parts}
        for source in results:
            for name, result in source.items():
                found[name] |= result.rates
        rates = [found[name][state.name] for name, state in self.states]
        flows, quadratures = self._quadratures(passing)
        stores = self._store_infos(balances, quadratures, len(self.states))
        bodies = [name for name, each in moved.items() if each.energy is not None]
        motions = []
        for name in bodies:
            place = len(self.states) + len(quadratures)
            motions.append((name, tuple(range(place, place + len(moved[name].powers)))))
            quadratures += moved[name].powers
        # Nothing depends on integrals, so one symbol serves them all.
        x = ca.vertcat(*self.symbols.values(), ca.SX.sym("integrals", len(quadratures)))
        totals = {f"{name}.{key}": value for name, each in balances.items() for key, value in each.totals.items()}
        outputs = self._outputs(every) | totals
        # Hidden outputs may be connected to, but are no outputs of the circuit: added after these are chosen.
        hidden = {f"{name}.{key}": value for name, each in passing.items() for key, value in each.hidden.items()}
        every |= totals | hidden
        energies = [balances[store.name].energy for store in stores if store.has_energy]
        energies += [moved[name].energy for name in bodies]
        fired = ca.SX.sym("fired", len(self.timers))
        known = self._connected(every, ca.vertcat(*rates))
        start, memory_start = self._starts(known)
        expressions = {
            "rates": ca.vertcat(*rates, *quadratures),
            "outputs": ca.vertcat(*(value for value, _ in outputs.values())),
            "start": ca.vertcat(start, ca.SX.zeros(len(quadratures))),
            "energy": ca.vertcat(*energies),
            "memory_start": memory_start,
            "update": self._update(scopes, known, fired),
        }
        return Model(
            states=tuple(
                StateInfo(self._outside(f"{name}.{s.name}"), s.unit, s.nominal, s.tolerance, s.floor, s.positive)
                for name, s in self.states
            ),
            n_quadratures=len(quadratures),
            inputs=tuple(self._input_info(name, item) for name, item in self.inputs),
            parameters=self.names,
            outputs=tuple((name, unit) for name, (_, unit) in outputs.items()),
            flows=tuple(flows),
            stores=tuple(stores),
            bodies=tuple(motions),
            symbols={"t": self.t, "x": x, "u": self.u, "p": ca.vertcat(self.p, self.z), "fired": fired},
            expressions={name: self._substituted(ca.SX(value), known) for name, value in expressions.items()},
            memory=tuple(
                (self._outside(name), unit)
                for name, unit in zip(
                    self.memory_names, [*("s" for _ in self.timers), *(m.unit for _, m in self.remembered)], strict=True
                )
            ),
            n_timers=len(self.timers),
        )

    def _outside(self, address: str) -> str:
        return self.shown.get(address, address)

    def _passing(self, scopes: Mapping[str, Scope], gas: Mapping[str, GasState]) -> dict[str, PassageFlows]:
        return {
            name: part.flows(scopes[name], {port: gas[store] for port, store in self._ports(name).items()})
            for name, part in self.parts.items()
            if isinstance(part, Passage)
        }

    def _pushes(self, scopes: Mapping[str, Scope], gas: Mapping[str, GasState]) -> dict[str, ActuatorForce]:
        result = {}
        for name, part in self.parts.items():
            if isinstance(part, Actuator):
                own = {SELF: gas[name]} if name in gas else {}
                result[name] = part.actuator_force(
                    scopes[name], own | {port: gas[at] for port, at in self._ports(name).items()}
                )
        return result

    def _moved(self, scopes: Mapping[str, Scope], pushes: Mapping[str, ActuatorForce]) -> dict[str, BodyDynamics]:
        result = {}
        for name, part in self.parts.items():
            if isinstance(part, Body):
                own = [push for other, push in pushes.items() if self.parts[other].body_name() == name]
                result[name] = part.dynamics(scopes[name], sum(p.force for p in own), sum(p.friction for p in own))
        return result

    def _end(self, name: str, port: str | None) -> str | None:
        if port is None or port == SELF:
            return None if port is None else name
        return self._ports(name)[port]

    def _balances(self, scopes: Mapping[str, Scope], passing: Mapping[str, PassageFlows]) -> dict[str, GasBalance]:
        arriving: dict[str, list[tuple[Any, Any]]] = defaultdict(list)
        for name, result in passing.items():
            for flow in result.flows:
                source, target = self._end(name, flow.source), self._end(name, flow.target)
                if source is not None:
                    arriving[source].append((-flow.mass, -flow.enthalpy))
                if target is not None:
                    arriving[target].append((flow.mass, flow.enthalpy))
        return {
            name: part.balance(scopes[name], tuple(arriving[name]))
            for name, part in self.parts.items()
            if isinstance(part, Store)
        }

    # Connections and memory --------------------------------------------------------------------------------------

    def _connected(self, every: Mapping[str, tuple[Any, str]], rates: Any) -> list[tuple[Any, Any]]:
        """Symbol of each connected input with its expression, in an order in which each needs only those before."""
        outside = [self._outside(name) for name in every]
        with ErrorCollector() as errors:
            for target, source in self.connections.items():
                if source not in every:
                    address = f"connections.{self._outside(target)}"
                    errors.add("wiring.unknown_output", address, source=source, near=NameSuggestion(source, outside))
        known = self._resolved({target: self.ca.SX(every[source][0]) for target, source in self.connections.items()})
        self._check_units(every)
        if not self.slopes:
            return known
        value = dict(zip((symbol.name() for symbol, _ in known), (each for _, each in known), strict=True))
        x = self.ca.vertcat(*self.symbols.values())
        slopes = {}
        for address, base in self.slopes.items():
            if self.ca.depends_on(value[base], self.ca.vertcat(self.t, self.u, self.z)):
                raise InputError("wiring.no_slope", f"connections.{self._outside(base)}", source=self.connections[base])
            slopes[address] = self._substituted(self.ca.jtimes(value[base], x, rates), known)
        return [*known, *self._resolved(slopes)]

    def _resolved(self, value: Mapping[str, Any]) -> list[tuple[Any, Any]]:
        """Placeholders with their expressions, which may hold each other, substituted in turn."""
        ca = self.ca
        needs = {
            target: [other for other in value if ca.depends_on(expression, self.joined[other])]
            for target, expression in value.items()
        }
        try:
            # A loop through a state or memory is none here: those are symbols of their own.
            order = list(TopologicalSorter(needs).static_order())
        except CycleError as error:
            names = [*dict.fromkeys(self._outside(name) for name in error.args[1])]
            raise InputError("wiring.loop", "connections", names=names) from None
        known: list[tuple[Any, Any]] = []
        for target in order:
            known.append((self.joined[target], self._substituted(value[target], known)))
        return known

    def _check_units(self, every: Mapping[str, tuple[Any, str]]) -> None:
        """Refuse connections of one quantity to another; all are in SI, so that equal quantities have equal units."""
        with ErrorCollector() as errors:
            for target, source in self.connections.items():
                unit, wanted = every[source][1], every[target][1]
                if unit != wanted:
                    address, shown = f"connections.{self._outside(target)}", self._outside(source)
                    errors.add("wiring.other_unit", address, source=shown, unit=unit, wanted=wanted)

    def _substituted(self, expression: Any, known: Sequence[tuple[Any, Any]]) -> Any:
        """An expression in which connected inputs are replaced by what they take."""
        if not known or expression.is_empty():
            return expression
        symbols, values = zip(*known, strict=True)
        return self.ca.substitute([expression], list(symbols), list(values))[0]

    def _update(self, scopes: Mapping[str, Scope], known: Sequence[tuple[Any, Any]], fired: Any) -> Any:
        """New memory: timers that have come act one after the other, each on what those before have left."""
        ca = self.ca
        place = {name: k for k, name in enumerate(self.memory_names)}
        # Timers that come to the same instant act in turn; the later ones see what the earlier ones have done.
        now = self.z
        for k, (name, timer) in enumerate(self.timers):
            new = self.parts[name].update(timer.name, scopes[name])
            assert timer.name in new, f"{name}.{timer.name} does not set itself"
            values = self._substituted(ca.vertcat(*new.values()), known)
            values = ca.substitute([values], [self.z], [now])[0]
            after = [now[i] for i in range(now.shape[0])]
            for i, local in enumerate(new):
                j = place[f"{name}.{local}"]
                after[j] = ca.if_else(fired[k] > 0.0, values[i], after[j])
            now = ca.vertcat(*after)
        return now

    # Bookkeeping -------------------------------------------------------------------------------------------------

    def _quadratures(self, passing: Mapping[str, PassageFlows]) -> tuple[list[FlowInfo], list[Any]]:
        flows: list[FlowInfo] = []
        quadratures: list[Any] = []
        offset = len(self.states)
        for name, result in passing.items():
            for flow in result.flows:
                place = offset + len(quadratures)
                ends = self._end(name, flow.source), self._end(name, flow.target)
                flows.append(FlowInfo(self._outside(f"{name}.{flow.name}"), *ends, place, place + 1))
                # Mass and enthalpy of a flow lie side by side: its two places follow from one.
                quadratures += [flow.mass, flow.enthalpy]
        return flows, quadratures

    def _store_infos(self, balances: Mapping[str, GasBalance], quadratures: list[Any], offset: int) -> list[StoreInfo]:
        places = {address: k for k, address in enumerate(self.symbols)}
        infos = []
        for name, balance in balances.items():
            if f"{name}.mass" in places:
                has_energy = balance.energy is not None
                place = offset + len(quadratures)
                work = None if balance.work is None else place + 1
                infos.append(StoreInfo(name, places[f"{name}.mass"], place, has_energy, work))
                quadratures += [balance.heat] if work is None else [balance.heat, balance.work]
        return infos

    def _starts(self, known: Sequence[tuple[Any, Any]]) -> tuple[Any, Any]:
        """Initial states and memory, as functions of the numbers alone.

        A start may look at inputs: a free one has the value it takes without a signal, a connected one what the other
        parts begin with.
        """
        ca = self.ca
        begun = {name: part.start(self.scope(name, at_start=True)) for name, part in self.parts.items()}

        def of(elements: Sequence[tuple[str, Any]]) -> Any:
            return ca.vertcat(*(begun[name][each.name] for name, each in elements))

        x, z = of(self.states), of([*self.timers, *self.remembered])
        defaults = ca.vertcat(
            *(
                self.number[f"{name}.{item.default}"] if isinstance(item.default, str) else item.default
                for name, item in self.inputs
            )
        )
        symbols = [ca.vertcat(*self.symbols.values()), self.z, self.u]
        values = [x, z, defaults]
        present = [(s, ca.SX(v)) for s, v in zip(symbols, values, strict=True) if s.shape[0]]
        for _ in range(2):  # once for what is connected, once for what that looks at
            x, z = (self._substituted(self._substituted(ca.SX(each), known), present) for each in (x, z))
        return x, z

    def _every_output(
        self, scopes: Mapping[str, Scope], results: tuple[Mapping[str, Any], ...]
    ) -> dict[str, tuple[Any, str]]:
        """Inputs and outputs of all elementary parts by address: of each part its inputs first."""
        result: dict[str, tuple[Any, str]] = {}
        for name, part in self.parts.items():
            for item in part.inputs():
                result[f"{name}.{item.name}"] = scopes[name].inputs[item.name], item.unit
            for source in results:
                own = source[name].outputs if name in source else {}
                result |= {f"{name}.{local}": value for local, value in own.items()}
        return result

    def _outputs(self, every: Mapping[str, tuple[Any, str]]) -> dict[str, tuple[Any, str]]:
        """Outputs of the circuit in file order; of a part made of parts those that it shows."""
        inside = {outside: address for address, outside in self.shown.items()}
        result: dict[str, tuple[Any, str]] = {}
        for name, part in self.whole.items():
            start = f"{name}."
            if name in self.parts:
                result |= {address: value for address, value in every.items() if address.startswith(start)}
            else:
                names = part.outside()  # type: ignore[attr-defined]
                result |= {f"{start}{outside}": every[inside[f"{start}{outside}"]] for outside in names}
        return result

    def _input_info(self, name: str, item: Any) -> InputInfo:
        default, low, high = (
            f"{name}.{each}" if isinstance(each, str) else each for each in (item.default, item.low, item.high)
        )
        delay = f"{name}.{item.delay}" if item.delay else ""
        slope_of = self._outside(f"{name}.{item.slope_of}") if item.slope_of else ""
        address = self._outside(f"{name}.{item.name}")
        return InputInfo(address, item.unit, item.kind, default, low, high, delay, slope_of)
