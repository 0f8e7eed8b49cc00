"""Construction of one symbolic model from the equations of all parts of a circuit.

Parameters remain symbols, so one model is valid for all parameter values.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from graphlib import CycleError, TopologicalSorter
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.circuit.wiring import part_connections
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.units import same_dimension
from poppet.engine.model import FlowInfo, InputInfo, Model, StateInfo, StoreInfo
from poppet.parts.compound import expand_compounds
from poppet.parts.part import (
    AMBIENT,
    SELF,
    Actuator,
    ActuatorForce,
    Body,
    BodyDynamics,
    Controller,
    GasBalance,
    GasState,
    Part,
    Passage,
    PassageFlows,
    Scope,
    Selection,
    Store,
    Surroundings,
)

if TYPE_CHECKING:
    import casadi

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
    """Return the symbolic model of a circuit from the equations of its parts.

    `parameters` are the addresses of all parameters, and `connections` maps inputs to outputs.
    """
    return Tracer(parts, connections or {}, parameters).model()


def trace_program(
    parts: Mapping[str, Part], parameters: tuple[str, ...], connections: Mapping[str, str]
) -> TracedProgram:
    """Return the model of sampled controllers, with the names and selections in its equations.

    The model has relative time: the state of a timer is the time until it is due.
    """
    tracer = Tracer(parts, connections, parameters, has_relative_time=True)
    return TracedProgram(tracer.model(), tracer.labels, tuple(tracer.selections))


class TracedSelection(NamedTuple):
    """Selection (`Scope.select`) in the equations of a program.

    Row k of `values`, shape (n_cases, n_results), contains the results of case k. Expressions can contain the symbols
    of previous selections.
    """

    owner: str  # name of the part
    selection: Selection
    selector: Any
    values: Any


class TracedProgram(NamedTuple):
    """Model of sampled controllers.

    A label maps the address of a value at a sample instant to its expression and meaning (`Scope.label`). The
    expressions contain the symbols of the selections.
    """

    model: Model
    labels: dict[str, tuple[Any, str]]
    selections: tuple[TracedSelection, ...]


class TracedEquations(NamedTuple):
    """Results of the methods of all elementary parts, by the name of the part.

    `gas` contains the gas states, `rates` the derivatives of all states in the order of the state vector, and
    `connected` pairs of the symbol and the expression of each connected input.
    """

    scopes: Mapping[str, Scope]
    gas: Mapping[str, GasState]
    passages: Mapping[str, PassageFlows]
    balances: Mapping[str, GasBalance]
    dynamics: Mapping[str, BodyDynamics]
    forces: Mapping[str, ActuatorForce]
    rates: Any
    connected: Sequence[tuple[Any, Any]]


class ModelExtension(NamedTuple):
    """Integrals, each with its rate, and outputs, each with its SI unit, that are added to a model."""

    integrals: list[Any]
    outputs: dict[str, tuple[Any, str]]


class Tracer:
    """Trace of one circuit.

    A subclass can add integrals and outputs to the model.
    """

    def __init__(
        self, parts: Mapping[str, Part], connections: Mapping[str, str], parameters: tuple[str, ...],
        has_relative_time: bool = False,
    ) -> None:  # fmt: skip
        import casadi as ca

        self.has_relative_time = has_relative_time
        self.labels: dict[str, tuple[Any, str]] = {}
        self.selections: list[TracedSelection] = []

        self.ca, self.circuit_parts, self.names = ca, parts, parameters
        self.parts, self.connections, self.shown = expand_compounds(parts, connections)
        self.declared = part_connections(parts)
        self.p = ca.SX.sym("p", len(parameters))
        self.number: dict[str, Any] = dict(zip(parameters, self.p.elements(), strict=True))
        self.surroundings = Surroundings(*(self.number[name] for name in SURROUNDINGS))
        self.states = self._elements("states")
        self.symbols = {f"{name}.{s.name}": ca.SX.sym(f"{name}.{s.name}") for name, s in self.states}
        inputs = self._elements("inputs")
        # Address of the rate of change of a connected input to the address of the input.
        self.slopes = {
            f"{name}.{item.name}": f"{name}.{item.slope_of}"
            for name, item in inputs
            if f"{name}.{item.slope_of}" in self.connections
        }
        # Connected inputs are not in u: signals cannot drive them.
        connected = {*self.connections, *self.slopes}
        self.inputs = [(name, item) for name, item in inputs if f"{name}.{item.name}" not in connected]
        self.t, self.u = ca.SX.sym("t"), ca.SX.sym("u", len(self.inputs))
        self.input = {f"{name}.{item.name}": self.u[k] for k, (name, item) in enumerate(self.inputs)}
        # Placeholders: the expressions of connected inputs are available after the trace of all parts.
        self.joined = {address: ca.SX.sym(address) for address in (*self.connections, *self.slopes)}
        # The sort is stable: timers of equal rank act in the order of the parts.
        self.timers = sorted(self._elements("timers"), key=lambda element: element[1].rank)
        self.remembered = self._elements("memory")
        self.z = ca.SX.sym("z", len(self.timers) + len(self.remembered))
        self.memory_names = [f"{name}.{element.name}" for name, element in [*self.timers, *self.remembered]]
        self.memory: dict[str, Any] = dict(zip(self.memory_names, self.z.elements(), strict=True))
        tables = {"numbers": self.number, "states": self.symbols, "inputs": {**self.input, **self.joined}}
        self._owned = {kind: _by_owner(table) for kind, table in {**tables, "memory": self.memory}.items()}

    def _elements(self, kind: str) -> list[tuple[str, Any]]:
        return [(name, element) for name, part in self.parts.items() for element in getattr(part, kind)()]

    def scope(self, name: str, *, at_start: bool = False) -> Scope:
        """Return all symbols that the equations of the part `name` can use.

        If the keyword `at_start` is True, states and discrete states are omitted, because initial values cannot depend
        on them.
        """

        def select(kind: str) -> dict[str, Any]:
            return dict(self._owned[kind].get(name, {}))

        states, memory = ({}, {}) if at_start else (select("states"), select("memory"))
        body_name, motion = self.body_of(name), None
        if body_name is not None:
            body, body_scope = self.parts[body_name], self.scope(body_name, at_start=at_start)
            assert isinstance(body, Body)
            motion = body.motion(replace(body_scope, states=body.start(body_scope)) if at_start else body_scope)
        time = 0.0 if self.has_relative_time else self.t
        numbers, inputs = select("numbers"), select("inputs")
        return Scope(numbers, states, inputs, self.surroundings, memory, time, motion, self.has_relative_time)

    def _ports(self, name: str) -> dict[str, str]:
        """Return a mapping from the ports of a part to addresses of gas nodes."""
        return {port: _absolute(store, name) for port, store in self.parts[name].ports().items()}

    def body_of(self, name: str) -> str | None:
        """Return the address of the body on which a part acts, or None if it acts on no body."""
        body_name = self.parts[name].body_name()
        return None if body_name is None else _absolute(body_name, name)

    def model(self) -> Model:
        """Return the symbolic model of the circuit."""
        ca = self.ca
        scopes = {name: self.scope(name) for name in self.parts}
        gas = {name: part.gas(scopes[name]) for name, part in self.parts.items() if isinstance(part, Store)}
        gas.setdefault(AMBIENT, GasState(self.surroundings.pressure, self.surroundings.temperature))
        passages = {
            name: part.flows(scopes[name], {port: gas[store] for port, store in self._ports(name).items()})
            for name, part in self.parts.items()
            if isinstance(part, Passage)
        }
        balances, flows, stores, quadratures = self._balances(scopes, passages)
        dynamics, forces = self._dynamics(scopes, gas)
        controls = {n: part.control(scopes[n]) for n, part in self.parts.items() if isinstance(part, Controller)}
        # In the order of their outputs in a recording.
        results: tuple[Mapping[str, Any], ...] = (balances, passages, dynamics, forces, controls)
        # All inputs and outputs of elementary parts, also of the members of compound parts, with their units.
        all_outputs: dict[str, tuple[Any, str]] = {}
        rates_of: dict[str, dict[str, Any]] = {name: {} for name in self.parts}
        for name, part in self.parts.items():
            for item in part.inputs():
                all_outputs[f"{name}.{item.name}"] = scopes[name].inputs[item.name], item.unit
            for source in results:
                if name in source:
                    all_outputs |= {f"{name}.{local}": value for local, value in source[name].outputs.items()}
                    rates_of[name] |= source[name].rates
        rates = [rates_of[name][state.name] for name, state in self.states]
        bodies = [name for name, body in dynamics.items() if body.energy is not None]
        powers = []
        for name in bodies:
            first = len(self.states) + len(quadratures)
            powers.append((name, tuple(range(first, first + len(dynamics[name].powers)))))
            quadratures += dynamics[name].powers
        totals = {f"{name}.{key}": value for name, gas in balances.items() for key, value in gas.totals.items()}
        outputs = self._outputs(all_outputs) | totals
        # Hidden outputs can be connected to inputs, but are not outputs of the circuit.
        hiding: dict[str, Any] = {**passages, **controls}
        hidden = {f"{name}.{key}": value for name, result in hiding.items() for key, value in result.hidden.items()}
        all_outputs |= totals | hidden
        energies = [balances[store.name].energy for store in stores if store.has_energy]
        energies += [dynamics[name].energy for name in bodies]
        fired = ca.SX.sym("fired", len(self.timers))
        connected = self._connected(all_outputs, ca.vertcat(*rates))
        equations = TracedEquations(scopes, gas, passages, balances, dynamics, forces, ca.vertcat(*rates), connected)
        extension = self.extension(equations, len(self.states) + len(quadratures), len(outputs))
        quadratures, outputs = [*quadratures, *extension.integrals], outputs | extension.outputs
        # No expression depends on the integrals: their symbols are not used.
        x = ca.vertcat(*self.symbols.values(), ca.SX.sym("integrals", len(quadratures)))
        start, memory_start = self._starts(connected)
        expressions = {
            "rates": ca.vertcat(*rates, *quadratures),
            "outputs": ca.vertcat(*(value for value, _ in outputs.values())),
            "start": ca.vertcat(start, ca.SX.zeros(len(quadratures))),
            "energy": ca.vertcat(*energies),
            "memory_start": memory_start,
            "update": self._update(scopes, connected, fired),
        }
        inputs = []
        for name, item in self.inputs:
            default, low, high = (
                f"{name}.{value}" if isinstance(value, str) else value for value in (item.default, item.low, item.high)
            )
            delay = f"{name}.{item.delay}" if item.delay else ""
            slope_of = self.shown_address(f"{name}.{item.slope_of}") if item.slope_of else ""
            address = self.shown_address(f"{name}.{item.name}")
            inputs.append(InputInfo(address, item.unit, item.kind, default, low, high, delay, slope_of, item.at_rest))
        return Model(
            states=tuple(
                StateInfo(self.shown_address(f"{name}.{s.name}"), s.unit, s.nominal, s.tolerance, s.floor, s.positive)
                for name, s in self.states
            ),
            n_quadratures=len(quadratures),
            inputs=tuple(inputs),
            parameters=self.names,
            outputs=tuple((name, unit) for name, (_, unit) in outputs.items()),
            flows=tuple(flows),
            stores=tuple(stores),
            bodies=tuple(powers),
            symbols={"t": self.t, "x": x, "u": self.u, "p": ca.vertcat(self.p, self.z), "fired": fired},
            expressions={name: self.substitute(ca.SX(value), connected) for name, value in expressions.items()},
            memory=tuple(
                (self.shown_address(name), unit)
                for name, unit in zip(
                    self.memory_names, [*("s" for _ in self.timers), *(m.unit for _, m in self.remembered)], strict=True
                )
            ),
            n_timers=len(self.timers),
        )

    def extension(self, equations: TracedEquations, first_integral: int, first_output: int) -> ModelExtension:
        """Return integrals and outputs that are added to the model.

        `first_integral` and `first_output` are their first indices in the state vector and among the outputs.
        """
        return ModelExtension([], {})

    def shown_address(self, address: str) -> str:
        """Return the public address of an element of the circuit.

        For elements inside compound parts, the equations use other addresses.
        """
        return self.shown.get(address, address)

    def _dynamics(
        self, scopes: Mapping[str, Scope], gas: Mapping[str, GasState]
    ) -> tuple[dict[str, BodyDynamics], dict[str, ActuatorForce]]:
        """Return the equations of motion of all bodies, and the forces of all actuators.

        `scopes` contains the symbols of each part, and `gas` the gas states.
        """
        forces, dynamics = {}, {}
        for name, part in self.parts.items():
            if isinstance(part, Actuator):
                states = {SELF: gas[name]} if name in gas else {}
                states |= {port: gas[store] for port, store in self._ports(name).items()}
                forces[name] = part.actuator_force(scopes[name], states)
        for name, part in self.parts.items():
            if isinstance(part, Body):
                acting = [force for actuator, force in forces.items() if self.body_of(actuator) == name]
                total = sum(force.force for force in acting)
                dynamics[name] = part.dynamics(scopes[name], total, sum(force.friction for force in acting))
        return dynamics, forces

    def end_of(self, name: str, port: str | None) -> str | None:
        """Return the gas node at a port of a part, or None for the outside of the circuit."""
        if port is None or port == SELF:
            return None if port is None else name
        return self._ports(name)[port]

    def _balances(
        self, scopes: Mapping[str, Scope], passages: Mapping[str, PassageFlows]
    ) -> tuple[dict[str, GasBalance], list[FlowInfo], list[StoreInfo], list[Any]]:
        """Return the gas balances of all gas nodes, with their flows and the rates of integrals.

        Each flow has an integral of mass and one of enthalpy. A gas node with a mass has integrals of heat and work.
        """
        arriving: dict[str, list[tuple[Any, Any]]] = defaultdict(list)
        flows, stores = [], []
        quadratures: list[Any] = []
        for name, result in passages.items():
            for flow in result.flows:
                index = len(self.states) + len(quadratures)
                source, target = self.end_of(name, flow.source), self.end_of(name, flow.target)
                flows.append(FlowInfo(self.shown_address(f"{name}.{flow.name}"), source, target, index, index + 1))
                quadratures += [flow.mass, flow.enthalpy]
                if source is not None:
                    arriving[source].append((-flow.mass, -flow.enthalpy))
                if target is not None:
                    arriving[target].append((flow.mass, flow.enthalpy))
        balances = {
            name: part.balance(scopes[name], tuple(arriving[name]))
            for name, part in self.parts.items()
            if isinstance(part, Store)
        }
        state_index = {address: k for k, address in enumerate(self.symbols)}
        for name, balance in balances.items():
            if f"{name}.mass" in state_index:
                index = len(self.states) + len(quadratures)
                work = None if balance.work is None else index + 1
                stores.append(StoreInfo(name, state_index[f"{name}.mass"], index, balance.energy is not None, work))
                quadratures += [balance.heat] if work is None else [balance.heat, balance.work]
        return balances, flows, stores, quadratures

    # Connections and discrete states -----------------------------------------------------------------------------

    def _connected(self, all_outputs: Mapping[str, tuple[Any, str]], rates: Any) -> list[tuple[Any, Any]]:
        """Return pairs of symbol and expression for all connected inputs.

        The expressions do not contain symbols of other connected inputs. `rates` contains the state derivatives.
        """
        shown = [self.shown_address(name) for name in all_outputs]
        with ErrorCollector() as errors:
            for target, source in self.connections.items():
                if source not in all_outputs:
                    errors.extend([self._unknown_source(target, source, shown)])
        expressions = {t: self._limited(t, all_outputs[source][0]) for t, source in self.connections.items()}
        connected = self._resolve(expressions)
        with ErrorCollector() as errors:
            for target, source in self.connections.items():
                # All values are in SI: equal quantities have equal units.
                unit, input_unit = all_outputs[source][1], all_outputs[target][1]
                if target in self.declared:
                    # The unit of the input follows from a written unit, which can have another name (J, N m).
                    if input_unit and not same_dimension(unit, input_unit):
                        is_bare = input_unit == "1"
                        facts: dict[str, Any] = {"source": self.shown_address(source), "unit": unit, "is_bare": is_bare}
                        facts["given"] = "" if is_bare else input_unit
                        errors.add("wiring.condition_unit", self._place(target), **facts)
                    elif self.declared[target].is_integer and not self._is_integer(source):
                        errors.add("wiring.no_integer", self._place(target), source=self.shown_address(source))
                elif unit != input_unit:
                    facts = {"source": self.shown_address(source), "unit": unit, "wanted": input_unit}
                    errors.add("wiring.other_unit", self._place(target), **facts)
        if not self.slopes:
            return connected
        expressions = {symbol.name(): expression for symbol, expression in connected}
        x = self.ca.vertcat(*self.symbols.values())
        slopes = {}
        for address, base in self.slopes.items():
            if self.ca.depends_on(expressions[base], self.ca.vertcat(self.t, self.u, self.z)):
                raise InputError(
                    "wiring.no_slope", f"connections.{self.shown_address(base)}", source=self.connections[base]
                )
            slopes[address] = self.substitute(self.ca.jtimes(expressions[base], x, rates), connected)
        return [*connected, *self._resolve(slopes)]

    def _unknown_source(self, target: str, source: str, outputs: Sequence[str]) -> InputError:
        """Return the error of a connection from an output that does not exist.

        `outputs` contains the public addresses of all outputs.
        """
        # The inputs that conditions declare have similar names, but a condition cannot read them.
        outputs = [name for name in outputs if name not in self.declared]
        address, near = self._place(target), NameSuggestion(source, outputs)
        if target not in self.declared:
            return InputError("fields.not_an_option", address, value=source, meaning="output", suggestion=near)
        # `plc.step:clamp` is 1 during the step `clamp` of the sequence `plc`.
        output, _, step = source.partition(":")
        steps = [name.partition(":")[2] for name in outputs if name.startswith(f"{output}:")]
        if step and steps:
            owner = output.rpartition(".")[0]
            return InputError(
                "wiring.unknown_step", address, step=step, owner=owner, suggestion=NameSuggestion(step, steps)
            )
        return InputError("wiring.unknown_output", address, source=source, suggestion=near)

    def _is_integer(self, address: str) -> bool:
        """Return True if all values of an output are integers."""
        name, _, output = address.rpartition(".")
        # `plc.step:clamp` is 1 during the step `clamp` of the sequence `plc`.
        return ":" in output or (name in self.parts and output in self.parts[name].integer_outputs())

    def _place(self, target: str) -> str:
        """Return the address of the connection to an input: in its part, or in the table of connections."""
        return self.declared[target].place if target in self.declared else f"connections.{self.shown_address(target)}"

    def _limited(self, target: str, output: Any) -> casadi.SX:
        """Return the value of a connected input, clipped to the limits of the input.

        A limit that the source cannot exceed is omitted.
        """
        (name, _, local), (owner, _, own) = (end.rpartition(".") for end in (self.connections[target], target))
        lowest, highest = self.parts[name].output_ranges().get(local, (-math.inf, math.inf))
        item = next(item for item in self.parts[owner].inputs() if item.name == own)
        value: casadi.SX = self.ca.SX(output)
        if isinstance(item.low, str):
            value = self.ca.fmax(value, self.number[f"{owner}.{item.low}"])
        elif item.low > (lowest if isinstance(lowest, float) else -math.inf):
            value = self.ca.fmax(value, item.low)
        if isinstance(item.high, str):
            value = self.ca.fmin(value, self.number[f"{owner}.{item.high}"])
        elif item.high < (highest if isinstance(highest, float) else math.inf):
            value = self.ca.fmin(value, item.high)
        return value

    def _resolve(self, expressions: Mapping[str, Any]) -> list[tuple[Any, Any]]:
        """Substitute symbols of connected inputs in expressions until none of these symbols remains."""
        ca = self.ca
        dependencies = {
            target: [address for address in expressions if ca.depends_on(expression, self.joined[address])]
            for target, expression in expressions.items()
        }
        try:
            # A loop through a state or discrete state is allowed: these are separate symbols.
            order = list(TopologicalSorter(dependencies).static_order())
        except CycleError as error:
            names = [*dict.fromkeys(self.shown_address(name) for name in error.args[1])]
            raise InputError("wiring.loop", "connections", names=names) from None
        resolved: list[tuple[Any, Any]] = []
        for target in order:
            resolved.append((self.joined[target], self.substitute(expressions[target], resolved)))
        return resolved

    def substitute(self, expression: casadi.SX, connected: Sequence[tuple[Any, Any]]) -> casadi.SX:
        """Return an expression in which symbols of connected inputs are replaced by expressions.

        `connected` contains pairs of such a symbol and its expression.
        """
        if not connected or expression.is_empty():
            return expression
        symbols, values = zip(*connected, strict=True)
        substituted: casadi.SX = self.ca.substitute([expression], list(symbols), list(values))[0]
        return substituted

    def _update(self, scopes: Mapping[str, Scope], connected: Sequence[tuple[Any, Any]], fired: Any) -> casadi.SX:
        """Return expressions for the discrete states after a sample instant.

        `fired` contains a symbol for each timer, which is 1 if the timer is due. The timers act one after the other,
        each on the result of the previous one. A simultaneous timer uses the discrete states before the instant.
        """
        ca = self.ca
        index = {name: k for k, name in enumerate(self.memory_names)}
        now = self.z
        for k, (name, timer) in enumerate(self.timers):
            new = self.parts[name].update(timer.name, scopes[name])
            assert timer.name in new, f"{name}.{timer.name} does not set itself"
            labels = scopes[name].labels if self.has_relative_time else {}
            selections = scopes[name].selections if self.has_relative_time else []
            named = [value for value, _ in labels.values()]
            selected = list[Any]()
            for item in selections:
                # The selector, then the results of all cases, case by case.
                results = (case.values.get(result, 0.0) for case in item.cases for result in item.symbols)
                selected += [item.selector, *results]
            values = self.substitute(ca.vertcat(*new.values(), *named, *selected), connected)
            if not timer.is_simultaneous:
                values = ca.substitute([values], [self.z], [now])[0]
            for i, (label, (_, meaning)) in enumerate(labels.items(), len(new)):
                self.labels[f"{name}.{label}"] = values[i], meaning
            i = len(new) + len(labels)
            for selection in selections:
                n_cases, n_results = len(selection.cases), len(selection.symbols)
                table = ca.reshape(values[i + 1 : i + 1 + n_cases * n_results], n_results, n_cases).T
                self.selections.append(TracedSelection(name, selection, values[i], table))
                i += 1 + n_cases * n_results
            labels.clear()
            selections.clear()
            elements = [now[i] for i in range(now.shape[0])]
            for i, local in enumerate(new):
                j = index[f"{name}.{local}"]
                elements[j] = ca.if_else(fired[k] > 0.0, values[i], elements[j])
            now = ca.vertcat(*elements)
        return now

    # Indices and addresses ---------------------------------------------------------------------------------------

    def _starts(self, connected: Sequence[tuple[Any, Any]]) -> tuple[Any, Any]:
        """Return expressions for the initial values of states and discrete states.

        An initial value can depend on inputs. An input without a connection has its default value, and a connected
        input has the initial value of the output.
        """
        ca = self.ca
        starts = {name: part.start(self.scope(name, at_start=True)) for name, part in self.parts.items()}
        x, z = (
            ca.vertcat(*(starts[name][element.name] for name, element in elements))
            for elements in (self.states, [*self.timers, *self.remembered])
        )
        defaults = ca.vertcat(
            *(
                self.number[f"{name}.{item.default}"] if isinstance(item.default, str) else item.default
                for name, item in self.inputs
            )
        )
        symbols = [ca.vertcat(*self.symbols.values()), self.z, self.u]
        values = [x, z, defaults]
        present = [(s, ca.SX(v)) for s, v in zip(symbols, values, strict=True) if s.shape[0]]
        for _ in range(2):  # for connected inputs, then for the inputs on which these depend
            x, z = (self.substitute(self.substitute(ca.SX(start), connected), present) for start in (x, z))
        return x, z

    def _outputs(self, all_outputs: Mapping[str, tuple[Any, str]]) -> dict[str, tuple[Any, str]]:
        """Return all outputs of the circuit, in the order of the circuit file.

        For a compound part, only the outputs that it declares are included.
        """
        address_of, owned = {shown: address for address, shown in self.shown.items()}, _by_owner(all_outputs)
        result: dict[str, tuple[Any, str]] = {}
        for name, part in self.circuit_parts.items():
            if name in self.parts:
                result |= {f"{name}.{local}": value for local, value in owned.get(name, {}).items()}
            else:
                shown = [f"{name}.{local}" for local in part.outside()]  # type: ignore[attr-defined]
                result |= {address: all_outputs[address_of[address]] for address in shown}
        return result


def _by_owner(values: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    """Return values by the name of their part, and by the rest of their address.

    Those of a member of a compound part also belong to the compound part.
    """
    owned: dict[str, dict[str, Any]] = {}
    for address, value in values.items():
        end = address.find(".")
        while end >= 0:
            owned.setdefault(address[:end], {})[address[end + 1 :]] = value
            end = address.find(".", end + 1)
    return owned


def _absolute(address: str, part: str) -> str:
    """Return the address of a gas node or body from its address in a field of a part.

    Inside a compound part, an address that begins with a dot, such as `.tank`, names a member of the same compound
    part.
    """
    return f"{part.rpartition('.')[0]}{address}" if address.startswith(".") else address
