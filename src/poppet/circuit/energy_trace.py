"""Model of a circuit with the integrals of an energy audit: energy and exergy of each flow, loss, load and store.

The integrals are added to the model of the circuit, whose equations do not change. The symbols are those of
docs/energy_audit.md.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from poppet.circuit.trace import ModelExtension, TracedEquations, Tracer
from poppet.engine.model import Model
from poppet.parts.part import Flow, Part, Store

MIN_PRESSURE = 1.0
"""Lowest pressure for the exergy of a gas [Pa]; the exergy of a perfect vacuum is infinite."""
MIN_FLOW = 1e-15
"""Mass flow rate below which the temperature of a flow is not computed from its enthalpy [kg/s]."""


class EnergyTerm(NamedTuple):
    """Energy and exergy that pass one place of a circuit, or are lost there.

    `energy` and `exergy` are indices of integrals in the state vector. An index is None if the integral is always 0.
    """

    kind: str  # supply, throttling, mixing, heat, work or friction
    name: str  # address of a flow path, gas node, actuator or body
    part: str  # part of the circuit
    node: str  # gas node outside the circuit in or from which the energy flows; empty for a flow source
    energy: int | None
    exergy: int | None


class StoredTerm(NamedTuple):
    """Energy and exergy of the gas in one gas node, of a body or of a spring, as indices of outputs of the model."""

    name: str
    part: str
    energy: int
    exergy: int


class FlowTerm(NamedTuple):
    """Air through one flow path.

    `rate` is the index of the output with the mass flow rate. `net` and `forward` are indices of the integrals of the
    mass flow rate and of its positive values.
    """

    name: str  # address of the mass flow rate
    part: str
    source: str  # gas node; empty outside the circuit
    target: str
    rate: int
    net: int
    forward: int


class EnergyModel(NamedTuple):
    """Model of a circuit, and the integrals and outputs of its energy audit."""

    model: Model
    terms: tuple[EnergyTerm, ...]
    flows: tuple[FlowTerm, ...]
    stored: tuple[StoredTerm, ...]
    states: tuple[int, ...]  # outputs with the states of the model
    stored_energy: int  # integral of the time derivative of the sum of all stored terms
    stored_exergy: int
    implied: tuple[str, ...]  # gas nodes whose heat follows from their thermal law, not from a wall


def trace_energy(
    parts: Mapping[str, Part], parameters: tuple[str, ...], connections: Mapping[str, str] | None = None
) -> EnergyModel:
    """Return the model of a circuit with the integrals of an energy audit.

    `parameters` are the addresses of all parameters, and `connections` maps inputs to outputs.
    """
    tracer = _EnergyTracer(parts, connections or {}, parameters)
    model = tracer.model()
    return EnergyModel(
        model, tuple(tracer.terms), tuple(tracer.flows), tuple(tracer.stored), tracer.state_outputs,
        *tracer.stored_integrals, tuple(tracer.implied),
    )  # fmt: skip


class _EnergyTracer(Tracer):
    """Trace with the integrals and outputs of an energy audit."""

    def extension(self, equations: TracedEquations, first_integral: int, first_output: int) -> ModelExtension:
        self.equations, self.ambient = equations, self.surroundings
        self.integrals: list[Any] = []
        self.functions: list[Any] = []
        self.first_integral, self.first_output = first_integral, first_output
        self.terms: list[EnergyTerm] = []
        self.flows: list[FlowTerm] = []
        self.stored: list[StoredTerm] = []
        self.implied: list[str] = []
        self.arriving: dict[str, list[tuple[Any, Any, Any]]] = {}
        self._add_flows()
        for name, part in self.parts.items():
            if isinstance(part, Store) and f"{name}.mass" in self.symbols:
                self._add_store(name, part)
        self._add_mechanics()
        energy = sum(self.functions[term.energy - first_output] for term in self.stored)
        exergy = sum(self.functions[term.exergy - first_output] for term in self.stored)
        self.stored_integrals = self._integral(self._derivative(energy)), self._integral(self._derivative(exergy))
        self.state_outputs = tuple(self._output(symbol) for symbol in self.symbols.values())
        return ModelExtension(self.integrals, {f"audit {k}": (value, "1") for k, value in enumerate(self.functions)})

    def _integral(self, rate: Any) -> int:
        self.integrals.append(rate)
        return self.first_integral + len(self.integrals) - 1

    def _output(self, value: Any) -> int:
        self.functions.append(value)
        return self.first_output + len(self.functions) - 1

    def _add(self, kind: str, name: str, energy: Any, exergy: Any, node: str = "") -> None:
        """Add a term with the rates of energy and exergy; None stands for a rate of zero."""
        indices = (None if rate is None else self._integral(rate) for rate in (energy, exergy))
        self.terms.append(EnergyTerm(kind, name, name.partition(".")[0], node, *indices))

    def _add_stored(self, name: str, energy: Any, exergy: Any) -> None:
        self.stored.append(StoredTerm(name, name.partition(".")[0], self._output(energy), self._output(exergy)))

    def _derivative(self, value: Any) -> Any:
        """Return the time derivative of a function of states and of inputs whose slope is an input."""
        value = self.substitute(self.ca.SX(value), self.equations.connected)
        rates = self.substitute(self.equations.rates, self.equations.connected)
        x = self.ca.vertcat(*self.symbols.values())
        result = self.ca.jtimes(value, x, rates) if x.shape[0] else self.ca.SX(0.0)
        for name, item in self.inputs:
            base = self.input.get(f"{name}.{item.slope_of}")
            if base is not None:
                result = result + self.ca.jacobian(value, base) * self.input[f"{name}.{item.name}"]
        return result

    # Gas ---------------------------------------------------------------------------------------------------------

    def _add_flows(self) -> None:
        """Add throttling, and the flows from and to reservoirs and flow sources."""
        for name, result in self.equations.passages.items():
            for flow in result.flows:
                source, target = self.end_of(name, flow.source), self.end_of(name, flow.target)
                address = self.shown_address(f"{name}.{flow.name}")
                air = self._output(flow.mass), self._integral(flow.mass), self._integral(self.ca.fmax(flow.mass, 0.0))
                self.flows.append(FlowTerm(address, address.partition(".")[0], source or "", target or "", *air))
                self._add_flow(address, flow, source, target)

    def _add_flow(self, address: str, flow: Flow, source: str | None, target: str | None) -> None:
        ca, ambient = self.ca, self.ambient
        heat_capacity, mass = ambient.heat_capacity_pressure, ca.SX(flow.mass)
        is_flow = ca.fabs(mass) > MIN_FLOW
        temperature = flow.enthalpy / (heat_capacity * ca.if_else(is_flow, mass, 1.0))
        entropy = mass * heat_capacity * ca.log(ca.if_else(is_flow, temperature / ambient.temperature, 1.0))
        energy = flow.enthalpy - heat_capacity * ambient.temperature * mass
        per_logarithm = ambient.temperature * ambient.gas_constant * mass
        ends = [(source, -1.0), (target, 1.0)]
        logarithms = {node: self._pressure_logarithm(node) for node, _ in ends if node is not None}
        if source is not None and target is not None:
            throttled = per_logarithm * (logarithms[source] - logarithms[target])
            self._add("throttling", address, None, throttled)
        for (node, sign), other in zip(ends, (target, source), strict=True):
            place = other if node is None else node
            assert place is not None, f"{address} has no end"
            if node is not None and f"{node}.mass" in self.symbols:
                self.arriving.setdefault(node, []).append((sign * mass, sign * flow.enthalpy, sign * entropy))
                continue
            # Into the circuit: from the reservoir, or at the pressure of the node that a flow source feeds.
            exergy = energy - ambient.temperature * entropy + per_logarithm * logarithms[place]
            self._add("supply", address, -sign * energy, -sign * exergy, node or "")

    def _pressure_logarithm(self, node: str) -> Any:
        pressure = self.ca.fmax(self.equations.gas[node].pressure, MIN_PRESSURE)
        return self.ca.log(pressure / self.ambient.pressure)

    def _add_store(self, name: str, part: Store) -> None:
        """Add the gas in a gas node: stored exergy, heat, mixing of its inflows, and work on a valve."""
        ca, ambient, balance = self.ca, self.ambient, self.equations.balances[name]
        gas, mass = self.equations.gas[name], self.symbols[f"{name}.mass"]
        pressure, temperature, heat_capacity = gas.pressure, gas.temperature, ambient.heat_capacity_pressure
        internal = mass * ambient.heat_capacity_volume * temperature
        volume = mass * ambient.gas_constant * temperature / pressure
        thermal = heat_capacity * ca.log(temperature / ambient.temperature)
        entropy = thermal - ambient.gas_constant * ca.log(pressure / ambient.pressure)
        energy = internal + ambient.pressure * volume - mass * heat_capacity * ambient.temperature
        self._add_stored(name, energy, energy - ambient.temperature * mass * entropy)
        flows = self.arriving.get(name, [])
        growth = 0.0 if balance.work is None else -balance.work / pressure
        heat = balance.heat
        if balance.energy is None:
            self.implied.append(name)
            if "volume" in balance.outputs:  # a thermal law in a changing volume
                growth = self._derivative(volume)
                heat = self._derivative(internal) + pressure * growth - sum(enthalpy for _, enthalpy, _ in flows)
        self._add("heat", name, -heat, -heat * (1.0 - ambient.temperature / temperature))
        mixing = sum(
            enthalpy / temperature - heat_capacity * flow_mass - flow_entropy + flow_mass * thermal
            for flow_mass, enthalpy, flow_entropy in flows
        )
        self._add("mixing", name, None, ambient.temperature * mixing)
        if part.body_name() is None and (balance.work is not None or "volume" in balance.outputs):
            work = (pressure - ambient.pressure) * growth
            self._add("friction", f"{name}.work", work, work)

    # Mechanics ---------------------------------------------------------------------------------------------------

    def _add_mechanics(self) -> None:
        """Add loads, losses, and kinetic and elastic energies of bodies and actuators."""
        for name, force in self.equations.forces.items():
            for loss, power in force.losses.items():
                self._add("friction", f"{name}.{loss}", power, power)
            if not self.ca.SX(force.energy).is_zero():
                self._add_stored(f"{name}.spring", force.energy, force.energy)
        for name, body in self.equations.dynamics.items():
            for kind, powers in (("work", body.loads), ("friction", body.losses)):
                for key, power in powers.items():
                    if not self.ca.SX(power).is_zero():
                        self._add(kind, f"{name}.{key}", power, power)
            for key, kind, power in self._undivided(name):
                self._add(kind, f"{name}.{key}", power, power)
            if body.energy is not None:
                self._add_stored(f"{name}.motion", body.energy, body.energy)

    def _undivided(self, name: str) -> Iterator[tuple[str, str, Any]]:
        """Yield name, kind and power of load and losses of a body that does not divide them."""
        body = self.equations.dynamics[name]
        if body.loads or body.losses:
            return
        actuators = [force.force for actuator, force in self.equations.forces.items() if self.body_of(actuator) == name]
        power = sum(actuators) * self.parts[name].motion(self.equations.scopes[name]).velocity  # type: ignore[attr-defined]
        yield "load", "work", power - body.powers[0] if body.powers else power
        yield from (("friction", "friction", -power) for power in body.powers[1:2])
