"""Pilot stage of a pressure valve: a gas volume with a fill and a vent solenoid valve."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.codes import Note
from poppet.core.symbolic import maximum, where
from poppet.laws.physics import gas as gas_law
from poppet.parts import moving_gas, solenoid, symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import (
    NumberLike,
    anr_pressure,
    anr_temperature,
    group,
    laminar_limit,
    number,
    option,
    port,
    reference,
    subsonic_index_m,
)
from poppet.parts.flow_path import named_flow
from poppet.parts.part import (
    SELF,
    DiscreteState,
    GasBalance,
    GasState,
    Input,
    Passage,
    PassageFlows,
    Quantities,
    Scope,
    State,
    Store,
    Surroundings,
    Timer,
)
from poppet.parts.solenoid import Solenoid

VALVES = ("fill", "vent")
AVERAGED, SWITCHED = "averaged", "switched"
MIN_VOLUME_FRACTION = 0.1
"""Fraction of the volume at stroke zero that remains for any displacement."""


@dataclass(frozen=True)
class Leak:
    """Parameters of a leak of the pilot volume, an ISO 6358 flow path."""

    sonic_conductance: NumberLike = number("m^3/(s Pa)", 0.0, doc="sonic conductance C", low=0.0, note="tight")
    critical_ratio: NumberLike = number("1", 0.3, doc="critical ratio b", low=0.0, below=1.0)


@dataclass(frozen=True)
class PilotStage(Store, Passage):
    r"""Pilot volume of a pressure valve with two solenoid valves.

    .. math:: \dot U = \sum c_p T_{up} q + h A (T_w - T) - p \dot V, \qquad
              p = (\kappa - 1) \frac{U}{V}, \qquad V = V_0 + \Delta V(x)

    .. math:: \dot p = \frac{n R T}{V} (q_{fill} - q_{vent}) - \frac{n p}{V} \dot V \qquad \text{(polytropic)}

    Notes
    -----
    With the drive `averaged`, the opening of a solenoid valve is the fraction of the modulation period in which it is
    open. With `switched`, the valves open and close at the modulation frequency with their delays. :math:`\Delta V(x)`
    is the input `displacement`; the volume V is at least a tenth of `volume`. The thermal law `energy` needs the time
    derivative of the displacement: an output that is connected to it must be a function of states, and a signal must
    not jump.

    With the thermal law `polytropic`, the temperature is a function of the density alone and remains high in a filled
    volume; the gas in a valve cools within tenths of a second. A run that continues another run starts with closed
    valves and a new modulation period.

    References
    ----------
    Varga & Keski-Honkola 2012, section 2 and fig. 1, mention the pilot stage without a model.
    """

    kind: ClassVar[str] = "pilot_stage"
    symbol: ClassVar[symbols.Symbol | str] = symbols.PILOT_STAGE
    summary: ClassVar[str] = "pilot volume with fill and vent solenoids: averaged duty or switched"
    internal_outputs: ClassVar[tuple[str, ...]] = (
        "mass", "volume", "displacement", "fill_duty", "vent_duty", "fill_opening", "vent_opening",
        "fill_mass_flow_rate", "vent_mass_flow_rate", "supply_leak_mass_flow_rate", "exhaust_leak_mass_flow_rate",
    )  # fmt: skip

    supply: str | None = port("gas node that fills it")
    exhaust: str | None = port("gas node into which it is vented")
    data: Any = reference(doc="name of a parameter set of the library")
    drive: str = option(AVERAGED, SWITCHED, doc="drive of the solenoids")
    volume: NumberLike = number("m^3", doc="pilot volume at stroke zero", above=0.0)
    thermal: str = option("energy", "polytropic", doc="thermal law")
    wall_conductance: NumberLike = number("W/K", 0.0, doc="wall conductance h A", low=0.0, note="adiabatic by default")
    wall_temperature: NumberLike = number("K", optional=True, doc="wall temperature", kind="temperature", above=0.0)
    polytropic_exponent: NumberLike = number("1", 1.2, doc="polytropic exponent", low=1.0, high=1.7)
    fill: Any = group(Solenoid, doc="fill solenoid")
    vent: Any = group(Solenoid, doc="vent solenoid")
    supply_leak: Any = group(Leak, doc="leak from the supply")
    exhaust_leak: Any = group(Leak, doc="leak to the exhaust")
    fill_duty: NumberLike = number("1", 0.0, doc="duty of the fill valve", low=0.0, high=1.0, note="closed")
    vent_duty: NumberLike = number("1", 0.0, doc="duty of the vent valve", low=0.0, high=1.0, note="closed")
    displacement: NumberLike = number("m^3", 0.0, doc="addition to the volume", note="the plate at stroke zero")
    initial_pressure: NumberLike = anr_pressure("initial pressure")
    initial_temperature: NumberLike = anr_temperature("initial temperature")
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    resume: ClassVar[dict[str, str]] = {"pressure": "initial_pressure", "temperature": "initial_temperature"}

    def check(self) -> None:
        for name in VALVES:
            solenoid.check(name, getattr(self, name))

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        solenoids = f"solenoids C = {numbers.text(self.fill.sonic_conductance)}"
        return [f"pilot stage, {self.drive}", numbers.text(self.volume), solenoids]

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        return tuple(volume_notes("volume", self.volume, -float(series(f"{name}.displacement").min())))

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        return {"wall_temperature": ambient.temperature} | super().parameters(ambient)

    def structure(self) -> Hashable:
        return super().structure(), tuple(getattr(self, name).rate_limit is not None for name in VALVES)

    def _is_limited(self, name: str) -> bool:
        return self.drive == AVERAGED and getattr(self, name).rate_limit is not None

    def states(self) -> tuple[State, ...]:
        openings = [State(f"{name}_opening", "1", 1.0) for name in VALVES if self._is_limited(name)]
        energy = [State("energy", "J", 1.0, positive=True)] if self.thermal == "energy" else []
        return *energy, State("mass", "kg", 1e-5, positive=True), *openings

    def memory(self) -> tuple[DiscreteState, ...]:
        if self.drive == AVERAGED:
            return ()
        return tuple(DiscreteState(f"{name}_{key}", "1") for name in VALVES for key in solenoid.MEMORY)

    def timers(self) -> tuple[Timer, ...]:
        if self.drive == AVERAGED:
            return ()
        # After the controllers, which set the duties.
        return tuple(Timer(f"{name}_{key}", 10 + k) for name in VALVES for k, key in enumerate(solenoid.TIMERS))

    def inputs(self) -> tuple[Input, ...]:
        duties = [Input(f"{name}_duty", "1", f"{name}_duty", low=0.0, high=1.0, is_command=True) for name in VALVES]
        volume_inputs = [Input("displacement", "m^3", "displacement")]
        if self.thermal == "energy":
            volume_inputs.append(Input("displacement_rate", "m^3/s", 0.0, slope_of="displacement"))
        return *duties, *volume_inputs

    def start(self, scope: Scope) -> dict[str, Any]:
        values = moving_gas.initial_states(scope, self._volume(scope))
        if self.thermal != "energy":
            del values["energy"]
        values |= {f"{name}_opening": 0.0 for name in VALVES if self._is_limited(name)}
        if self.drive == SWITCHED:
            for name in VALVES:
                values |= {f"{name}_{key}": value for key, value in solenoid.initial_states().items()}
        return values

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        name, _, event = timer.partition("_")
        prefix = f"{name}_"
        states = {key.removeprefix(prefix): value for key, value in scope.memory.items() if key.startswith(prefix)}
        numbers = {key: scope[f"{name}.{key}"] for key in ("frequency", "opening_delay", "closing_delay")}
        new = solenoid.update(event, scope.time, states, scope.inputs[f"{name}_duty"], **numbers)
        return {f"{name}_{key}": value for key, value in new.items()}

    def gas(self, scope: Scope) -> GasState:
        initial_temperature, gas_constant = scope["initial_temperature"], scope.surroundings.gas_constant
        if self.thermal == "energy":
            return moving_gas.gas_state(scope, self._volume(scope))
        exponent = scope["polytropic_exponent"]
        density = scope.states["mass"] / self._volume(scope)
        initial_density = gas_law.density(scope["initial_pressure"], initial_temperature, gas_constant)
        temperature = initial_temperature * (density / initial_density) ** (exponent - 1.0)
        return GasState(density * gas_constant * temperature, temperature)

    def _volume(self, scope: Scope) -> Any:
        return maximum(scope["volume"] + scope.inputs["displacement"], MIN_VOLUME_FRACTION * scope["volume"])

    def _averaged(self, name: str, scope: Scope) -> Any:
        numbers = {key: scope[f"{name}.{key}"] for key in ("frequency", "opening_delay", "closing_delay")}
        return solenoid.averaged_opening(scope.inputs[f"{name}_duty"], **numbers)

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        gas = {**gas, SELF: self.gas(scope)}
        inward, outward = ("supply", SELF), (SELF, "exhaust")
        flows, outputs = [], {}
        paths = {"fill": inward, "vent": outward, "supply_leak": inward, "exhaust_leak": outward}
        for name, ends in paths.items():
            opening = 1.0
            if name in VALVES and self.drive == SWITCHED:
                opening = scope.memory[f"{name}_open"]
            elif name in VALVES:
                is_limited = self._is_limited(name)
                opening = scope.states[f"{name}_opening"] if is_limited else self._averaged(name, scope)
            size = scope[f"{name}.sonic_conductance"] * opening, scope[f"{name}.critical_ratio"]
            flow, _ = named_flow(scope, gas, name, ends, size)
            flows.append(flow)
            outputs[flow.name] = flow.mass, "kg/s"
            if name in VALVES:
                outputs[f"{name}_opening"] = opening, "1"
        rates = {}
        for name in filter(self._is_limited, VALVES):
            opening = scope.states[f"{name}_opening"]
            target = self._averaged(name, scope)
            rates[f"{name}_opening"] = solenoid.slew_rate(opening, target, scope[f"{name}.rate_limit"])
        return PassageFlows(tuple(flows), outputs, rates)

    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        gas, volume = self.gas(scope), self._volume(scope)
        if self.thermal == "energy":
            growth = where(volume > MIN_VOLUME_FRACTION * scope["volume"], scope.inputs["displacement_rate"], 0.0)
            return moving_gas.balance(scope, gas, volume, growth, flows)
        outputs: Quantities = {
            "pressure": (gas.pressure, "Pa"),
            "temperature": (gas.temperature, "K"),
            "mass": (scope.states["mass"], "kg"),
            "volume": (volume, "m^3"),
        }
        return GasBalance(outputs, {"mass": sum(mass for mass, _ in flows)}, 0.0)


def volume_notes(name: str, volume: Any, swept: float) -> list[Note]:
    """Return a list with a note if a displacement reduces a volume by more than 90 %.

    `name` is the address of the volume. `swept` is the largest reduction by the displacement [m^3]. The list is empty
    if the reduction is smaller.
    """
    if swept <= (1.0 - MIN_VOLUME_FRACTION) * float(volume):
        return []
    return [Note("valve.pilot_too_small", name, shown=volume.display(), swept_cm3=swept * 1e6)]
