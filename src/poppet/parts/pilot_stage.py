"""The pilot stage: a volume under the membrane, filled and vented by two solenoid valves."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.codes import Note
from poppet.core.symbolic import maximum, where
from poppet.laws.physics import gas as gas_law
from poppet.parts import moving_gas, solenoid
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
from poppet.parts.orifice import way
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
LEAST_LEFT = 0.1
"""Part of the volume at stroke zero that remains, however far the plate goes."""


@dataclass(frozen=True)
class Leak:
    """A leak, as an ISO 6358 restriction."""

    sonic_conductance: NumberLike = number("m^3/(s Pa)", 0.0, doc="sonic conductance C", low=0.0, note="tight")
    critical_ratio: NumberLike = number("1", 0.3, doc="critical ratio b", low=0.0, below=1.0)


@dataclass(frozen=True)
class PilotStage(Store, Passage):
    r"""The pilot volume of a pressure valve with its two solenoid valves.

    .. math:: \dot U = \sum c_p T_{up} q + h A (T_w - T) - p \dot V, \qquad
              p = (\kappa - 1) \frac{U}{V}, \qquad V = V_0 + \Delta V(x)

    .. math:: \dot p = \frac{n R T}{V} (q_{fill} - q_{vent}) - \frac{n p}{V} \dot V \qquad \text{(polytropic)}

    Parameters
    ----------
    supply, exhaust : str
        Stores from which it is filled and into which it is vented.
    data : str
        A library set; fields given here override it.
    drive : str
        `averaged` (default): each duty opens its valve by the fraction that it is open on average. `switched`: the
        valves switch at their frequency, with their delays.
    volume : number
        Volume at stroke zero [m^3].
    thermal : str
        `energy` (default, the first equation) or `polytropic` (the second).
    wall_conductance : number
        Product h A of heat transfer between gas and wall, for `energy` [W/K].
    wall_temperature : number
        Temperature of the wall; default the ambient temperature [K].
    polytropic_exponent : number
        Exponent n, for `polytropic`.
    fill, vent : group
        The solenoid valves: sonic_conductance, critical_ratio, frequency, opening_delay, closing_delay, rate_limit.
    supply_leak, exhaust_leak : group
        Leaks from the supply into the volume and from it to the exhaust.
    fill_duty, vent_duty : number
        Duties without a signal, 0..1; also inputs.
    displacement : number
        What the main stage adds to the volume, without a signal [m^3]; also an input.
    initial_pressure, initial_temperature : number
        Absolute pressure [Pa] and temperature [K] at the start.
    subsonic_index, laminar_ratio : number
        Subsonic index m of all its passages, and pressure ratio at which the regularised zone begins.

    Notes
    -----
    At the smallest volume that is left, a tenth of `volume`, the displacement has no further effect. How fast it
    changes, which `energy` needs, follows from what it is connected to, a function of states, or from its signal, which
    must not jump. The temperature of `polytropic` is a function of the density alone, so that it stays high in a filled
    volume; the gas of a real one cools within tenths of a second. A resumed run begins with closed valves and a new
    period.

    References
    ----------
    Varga & Keski-Honkola 2012, section 2 and fig. 1: named, not modelled there.
    """

    kind: ClassVar[str] = "pilot_stage"
    summary: ClassVar[str] = "pilot volume with fill and vent solenoids: averaged duty or switched"
    internal_outputs: ClassVar[tuple[str, ...]] = (
        "mass", "volume", "displacement", "fill_duty", "vent_duty", "fill_opening", "vent_opening",
        "fill_mass_flow_rate", "vent_mass_flow_rate", "supply_leak_mass_flow_rate", "exhaust_leak_mass_flow_rate",
    )  # fmt: skip

    supply: str | None = port("store from which it is filled")
    exhaust: str | None = port("store into which it is vented")
    data: Any = reference(doc="library set")
    drive: str = option(AVERAGED, SWITCHED, doc="drive")
    volume: NumberLike = number("m^3", doc="pilot volume at stroke zero", above=0.0)
    thermal: str = option("energy", "polytropic", doc="thermal law")
    wall_conductance: NumberLike = number("W/K", 0.0, doc="wall conductance h A", low=0.0, note="adiabatic by default")
    wall_temperature: NumberLike = number("K", optional=True, doc="wall temperature", kind="temperature", above=0.0)
    polytropic_exponent: NumberLike = number("1", 1.2, doc="polytropic exponent", low=1.0, high=1.7)
    fill: Any = group(Solenoid, doc="the solenoid valve that fills")
    vent: Any = group(Solenoid, doc="the solenoid valve that vents")
    supply_leak: Any = group(Leak, doc="the leak from the supply")
    exhaust_leak: Any = group(Leak, doc="the leak to the exhaust")
    fill_duty: NumberLike = number("1", 0.0, doc="duty of the filling valve", low=0.0, high=1.0, note="closed")
    vent_duty: NumberLike = number("1", 0.0, doc="duty of the venting valve", low=0.0, high=1.0, note="closed")
    displacement: NumberLike = number("m^3", 0.0, doc="added to the volume", note="the plate at stroke zero")
    initial_pressure: NumberLike = anr_pressure("initial pressure")
    initial_temperature: NumberLike = anr_temperature("initial temperature")
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    resume: ClassVar[dict[str, str]] = {"pressure": "initial_pressure", "temperature": "initial_temperature"}

    def check(self) -> None:
        for name in VALVES:
            solenoid.check(name, getattr(self, name))

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        return tuple(too_small("volume", self.volume, -float(series(f"{name}.displacement").min())))

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
        return tuple(DiscreteState(f"{name}_{each}", "1") for name in VALVES for each in solenoid.MEMORY)

    def timers(self) -> tuple[Timer, ...]:
        if self.drive == AVERAGED:
            return ()
        # After the controllers, whose duties they take.
        return tuple(Timer(f"{name}_{each}", 10 + k) for name in VALVES for k, each in enumerate(solenoid.TIMERS))

    def inputs(self) -> tuple[Input, ...]:
        duties = [Input(f"{name}_duty", "1", f"{name}_duty", low=0.0, high=1.0) for name in VALVES]
        moved = [Input("displacement", "m^3", "displacement")]
        if self.thermal == "energy":
            moved.append(Input("displacement_rate", "m^3/s", 0.0, slope_of="displacement"))
        return *duties, *moved

    def start(self, scope: Scope) -> dict[str, Any]:
        values = moving_gas.begun(scope, self._volume(scope))
        if self.thermal != "energy":
            del values["energy"]
        values |= {f"{name}_opening": 0.0 for name in VALVES if self._is_limited(name)}
        if self.drive == SWITCHED:
            for name in VALVES:
                values |= {f"{name}_{key}": value for key, value in solenoid.at_rest().items()}
        return values

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        name, _, what = timer.partition("_")
        own = {key.removeprefix(f"{name}_"): value for key, value in scope.memory.items() if key.startswith(f"{name}_")}
        numbers = {key: scope[f"{name}.{key}"] for key in ("frequency", "opening_delay", "closing_delay")}
        new = solenoid.update(what, scope.time, own, scope.inputs[f"{name}_duty"], **numbers)
        return {f"{name}_{key}": value for key, value in new.items()}

    def gas(self, scope: Scope) -> GasState:
        first, gas_constant = scope["initial_temperature"], scope.surroundings.gas_constant
        if self.thermal == "energy":
            return moving_gas.state_of(scope, self._volume(scope))
        exponent = scope["polytropic_exponent"]
        density = scope.states["mass"] / self._volume(scope)
        at_start = gas_law.density(scope["initial_pressure"], first, gas_constant)
        temperature = first * (density / at_start) ** (exponent - 1.0)
        return GasState(density * gas_constant * temperature, temperature)

    def _volume(self, scope: Scope) -> Any:
        return maximum(scope["volume"] + scope.inputs["displacement"], LEAST_LEFT * scope["volume"])

    def _opening(self, name: str, scope: Scope) -> Any:
        if self.drive == SWITCHED:
            return scope.memory[f"{name}_open"]
        return scope.states[f"{name}_opening"] if self._is_limited(name) else self._averaged(name, scope)

    def _averaged(self, name: str, scope: Scope) -> Any:
        numbers = {key: scope[f"{name}.{key}"] for key in ("frequency", "opening_delay", "closing_delay")}
        return solenoid.averaged_opening(scope.inputs[f"{name}_duty"], **numbers)

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        at = {**gas, SELF: self.gas(scope)}
        inward, outward = ("supply", SELF), (SELF, "exhaust")
        flows, outputs = [], {}
        ways = {"fill": inward, "vent": outward, "supply_leak": inward, "exhaust_leak": outward}
        for name, ends in ways.items():
            opening = self._opening(name, scope) if name in VALVES else 1.0
            size = scope[f"{name}.sonic_conductance"] * opening, scope[f"{name}.critical_ratio"]
            flow, _ = way(scope, at, name, ends, size)
            flows.append(flow)
            outputs[flow.name] = flow.mass, "kg/s"
            if name in VALVES:
                outputs[f"{name}_opening"] = opening, "1"
        rates = {
            f"{name}_opening": solenoid.slewed(
                scope.states[f"{name}_opening"], self._averaged(name, scope), scope[f"{name}.rate_limit"]
            )
            for name in VALVES
            if self._is_limited(name)
        }
        return PassageFlows(tuple(flows), outputs, rates)

    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        gas, volume = self.gas(scope), self._volume(scope)
        if self.thermal == "energy":
            growth = where(volume > LEAST_LEFT * scope["volume"], scope.inputs["displacement_rate"], 0.0)
            return moving_gas.balance(scope, gas, volume, growth, flows)
        outputs: Quantities = {
            "pressure": (gas.pressure, "Pa"),
            "temperature": (gas.temperature, "K"),
            "mass": (scope.states["mass"], "kg"),
            "volume": (volume, "m^3"),
        }
        return GasBalance(outputs, {"mass": sum(mass for mass, _ in flows)}, 0.0)


def too_small(name: str, volume: Any, swept: float) -> list[Note]:
    """The note on a volume that the plate takes up nearly whole."""
    if swept <= (1.0 - LEAST_LEFT) * float(volume):
        return []
    return [Note("valve.pilot_too_small", name, shown=volume.display(), swept_cm3=swept * 1e6)]
