"""A pneumatic cylinder: two chambers that a piston divides, its force, its leak."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.ground.codes import Note
from poppet.ground.errors import InputError
from poppet.ground.symbolic import maximum, where
from poppet.laws.physics import contact
from poppet.parts import moving_gas
from poppet.parts.bodies import arrivals
from poppet.parts.compound import Compound
from poppet.parts.fields import (
    NumberLike,
    anr_pressure,
    anr_temperature,
    body,
    group,
    laminar_limit,
    member,
    number,
    option,
    port,
    subsonic_index_m,
)
from poppet.parts.flow_path import iso_flow
from poppet.parts.part import (
    AMBIENT,
    Actuator,
    Balance,
    Gas,
    Passage,
    Passing,
    Push,
    Quantities,
    Scope,
    State,
    Store,
    Surroundings,
)

DOUBLE, SINGLE = "double", "single"
CAP, ROD = "cap", "rod"
LEAST_LEFT = 0.01
"""Part of the dead volume that remains however far a piston is pressed into its stop."""
_TOLD = ("side", "outer_diameter", "inner_diameter", "stroke_length", "offset", "direction", "body")


def piston_position(scope: Scope, travel: Any) -> Any:
    """Distance of the piston from the cap."""
    return scope["offset"] + scope["direction"] * travel


@dataclass(frozen=True)
class CylinderChamber(Store):
    """One side of a cylinder, closed by its piston; a member of `Cylinder`.

    Parameters
    ----------
    body, side, outer_diameter, inner_diameter, stroke_length, offset, direction
        Told by the cylinder.
    dead_volume : number
        Volume with the piston at this end, lines included [m^3].
    wall_conductance : number
        Product h A of heat transfer between gas and wall [W/K].
    wall_temperature : number
        Temperature of the wall; default the ambient temperature [K].
    initial_pressure, initial_temperature : number
        Absolute pressure [Pa] and temperature [K] at the start.
    """

    kind: ClassVar[str] = "cylinder_chamber"
    summary: ClassVar[str] = "one side of a cylinder"

    body: str | None = body("body of the cylinder")
    side: str = option(CAP, ROD, doc="side")
    outer_diameter: NumberLike = number("m", doc="outer diameter of the ring under pressure", above=0.0)
    inner_diameter: NumberLike = number("m", 0.0, doc="inner diameter of the ring under pressure", low=0.0)
    stroke_length: NumberLike = number("m", doc="stroke of the piston", above=0.0)
    offset: NumberLike = number("m", 0.0, doc="piston position at body position zero")
    direction: NumberLike = number("1", 1.0, doc="direction")
    dead_volume: NumberLike = number("m^3", doc="dead volume", above=0.0)
    wall_conductance: NumberLike = number("W/K", 0.0, doc="wall conductance h A", low=0.0, note="adiabatic by default")
    wall_temperature: NumberLike = number("K", optional=True, doc="wall temperature", kind="temperature", above=0.0)
    initial_pressure: NumberLike = anr_pressure("initial pressure")
    initial_temperature: NumberLike = anr_temperature("initial temperature")

    resume: ClassVar[dict[str, str]] = {"pressure": "initial_pressure", "temperature": "initial_temperature"}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        return {"wall_temperature": ambient.temperature, **super().parameters(ambient)}

    def states(self) -> tuple[State, ...]:
        return moving_gas.STATES

    def start(self, scope: Scope) -> dict[str, Any]:
        return moving_gas.begun(scope, self._volume(scope, scope.body.position)[0])

    def gas(self, scope: Scope) -> Gas:
        return moving_gas.state_of(scope, self._volume(scope, scope.body.position)[0])

    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> Balance:
        volume, area = self._volume(scope, scope.body.position)
        growth = area * scope["direction"] * scope.body.velocity
        return moving_gas.balance(scope, self.gas(scope), volume, growth, flows)

    def _volume(self, scope: Scope, travel: Any) -> tuple[Any, Any]:
        """Volume, and the area by which it grows with the piston's way from the cap."""
        area = 0.25 * math.pi * (scope["outer_diameter"] ** 2 - scope["inner_diameter"] ** 2)
        from_cap = piston_position(scope, travel)
        depth, area_out = (from_cap, area) if self.side == CAP else (scope["stroke_length"] - from_cap, -area)
        volume, least = scope["dead_volume"] + area * depth, LEAST_LEFT * scope["dead_volume"]
        return maximum(volume, least), where(volume > least, area_out, 0.0)


@dataclass(frozen=True)
class EndStop:
    """Where the piston meets the covers, after Hunt and Crossley."""

    stiffness: NumberLike = number("N/m^1.5", 1e8, doc="contact stiffness", above=0.0, note="elastic rings")
    dissipation: NumberLike = number("s/m", 5.0, doc="contact dissipation", low=0.0, note="half of the energy and more")


@dataclass(frozen=True)
class ReturnSpring:
    """The spring that retracts a single-acting cylinder."""

    rate: NumberLike = number("N/m", 0.0, doc="spring rate", low=0.0, note="none by default")
    preload: NumberLike = number("m", 0.0, doc="compression with the piston at the cap", low=0.0, note="none")


@dataclass(frozen=True)
class Leakage:
    """The leak past the piston, as an ISO 6358 restriction."""

    sonic_conductance: NumberLike = number("m^3/(s Pa)", 0.0, doc="sonic conductance C", low=0.0, note="tight")
    critical_ratio: NumberLike = number("1", 0.3, doc="critical ratio b", low=0.0, below=1.0)


@dataclass(frozen=True)
class Piston(Actuator, Passage):
    """Piston and rod of a cylinder: its force, and its leak; a member of `Cylinder`, which tells it everything."""

    kind: ClassVar[str] = "piston"
    summary: ClassVar[str] = "piston and rod of a cylinder"

    cap: str | None = port("chamber at the cap")
    rod: str | None = port("chamber at the rod")
    body: str | None = body("body of the cylinder")
    acting: str = option(DOUBLE, SINGLE, doc="double or single acting")
    bore: NumberLike = number("m", doc="bore", above=0.0)
    rod_diameter: NumberLike = number("m", 0.0, doc="rod diameter", low=0.0)
    stroke_length: NumberLike = number("m", doc="stroke of the piston", above=0.0)
    offset: NumberLike = number("m", 0.0, doc="piston position at body position zero")
    direction: NumberLike = number("1", 1.0, doc="direction")
    seal_friction: NumberLike = number("N/Pa", 0.0, doc="friction per pressure difference", low=0.0)
    end_stop: Any = group(EndStop, doc="the end stops")
    spring: Any = group(ReturnSpring, doc="the return spring")
    leakage: Any = group(Leakage, doc="the leak past the piston")
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    def passing(self, scope: Scope, gas: Mapping[str, Gas]) -> Passing:
        size = scope["leakage.sonic_conductance"], scope["leakage.critical_ratio"]
        ends = (gas["cap"], gas["rod"])
        flow, outputs = iso_flow(scope, "leakage_mass_flow_rate", ("cap", "rod"), ends, size, regime="leakage_regime")
        return Passing((flow,), outputs)

    def push(self, scope: Scope, gas: Mapping[str, Gas]) -> Push:
        direction, travel, speed = scope["direction"], scope.body.position, scope.body.velocity
        bore_area = 0.25 * math.pi * scope["bore"] ** 2
        rod_area = 0.25 * math.pi * scope["rod_diameter"] ** 2
        depth, out = piston_position(scope, travel), direction * speed
        # With a single-acting cylinder the chamber at the rod is the open air: the same formula.
        pressures = bore_area * gas["cap"].pressure - (bore_area - rod_area) * gas["rod"].pressure
        force = pressures - rod_area * scope.surroundings.pressure
        force = force - scope["spring.rate"] * (scope["spring.preload"] + depth)
        stop = scope["end_stop.stiffness"], scope["end_stop.dissipation"]
        stops = contact.stop_force(-depth, -out, *stop) - contact.stop_force(depth - scope["stroke_length"], out, *stop)
        rubbing = scope["seal_friction"] * abs(gas["cap"].pressure - gas["rod"].pressure)
        outputs: Quantities = {
            "force": (force, "N"),
            "stop_force": (stops, "N"),
            "piston_position": (depth, "m"),
            "piston_velocity": (out, "m/s"),
        }
        return Push(direction * (force + stops), outputs, friction=rubbing)


@dataclass(frozen=True)
class Cylinder(Compound):
    r"""A pneumatic cylinder, double or single acting, that moves a body.

    .. math:: F = p_\mathrm{cap} A - p_\mathrm{rod} (A - A_r) - p_a A_r - k (x + h)

    .. math:: \dot U = \sum c_p T q + h A (T_w - T) - p \dot V

    Parameters
    ----------
    body : str
        The mass, joint or guide that it moves.
    bore, rod_diameter, stroke_length : number
        Bore, diameter of the rod, and stroke of the piston [m].
    acting : str
        `double` (default) or `single`: no chamber at the rod, which is open to the ambient.
    direction : number
        1: extends towards larger positions of the body; -1: turned round.
    offset : number
        Distance of the piston from the cap while the body is at position zero [m].
    seal_friction : number
        What the seals add to the body's dry friction (`stribeck`, `lugre`) per pressure difference [N/Pa].
    leakage : group
        Leak past the piston: sonic_conductance, critical_ratio.
    spring : group
        Return spring, which retracts: rate, preload.
    end_stop : group
        Covers that the piston meets: stiffness, dissipation.
    cap, rod : group
        The chambers, which ports of other parts name `NAME.cap` and `NAME.rod`: dead_volume, wall_conductance,
        wall_temperature, initial_pressure, initial_temperature.
    piston : group
        subsonic_index and laminar_ratio of its leak.

    Notes
    -----
    `force` is that on the piston before friction, covers included in `stop_force`. The gas in each chamber has one
    temperature; the wall takes heat in proportion to a constant conductance, not to the area that the piston leaves.

    Examples
    --------
    >>> cylinder = Cylinder(body="slide", bore="25 mm", rod_diameter="10 mm", stroke_length="160 mm",
    ...                     cap={"dead_volume": "5 cm^3"}, rod={"dead_volume": "5 cm^3"})
    >>> cylinder.stores()
    ('cap', 'rod')
    """

    kind: ClassVar[str] = "cylinder"
    summary: ClassVar[str] = "a pneumatic cylinder: two chambers, piston, leak, end stops"

    body: str | None = body("the body that it moves")
    bore: NumberLike = number("m", doc="bore", above=0.0)
    rod_diameter: NumberLike = number("m", 0.0, doc="rod diameter", low=0.0, note="no rod by default")
    stroke_length: NumberLike = number("m", doc="stroke of the piston", above=0.0)
    acting: str = option(DOUBLE, SINGLE, doc="double or single acting")
    direction: NumberLike = number("1", 1.0, doc="direction, 1 or -1", note="extends towards larger positions")
    offset: NumberLike = number("m", 0.0, doc="piston position at body position zero", note="at the cap")
    seal_friction: NumberLike = number("N/Pa", 0.0, doc="friction per pressure difference", low=0.0, note="none")
    leakage: Any = group(Leakage, doc="the leak past the piston")
    spring: Any = group(ReturnSpring, doc="the return spring")
    end_stop: Any = group(EndStop, doc="the end stops")
    cap: Any = member(CylinderChamber, doc="the chamber at the cap", told=_TOLD, is_open=True)
    rod: Any = member(CylinderChamber, doc="the chamber at the rod", told=_TOLD, is_open=True, optional=True)
    piston: Any = member(
        Piston, doc="piston and rod",
        told=("cap", "rod", "body", "acting", "bore", "rod_diameter", "stroke_length", "offset", "direction",
              "seal_friction", "end_stop", "spring", "leakage"),
    )  # fmt: skip

    outlets: ClassVar[Mapping[str, str]] = {
        **{
            f"{side}.{name}": f"{side}.{name}"
            for side in (CAP, ROD)
            for name in ("pressure", "temperature", "mass", "volume", "heat_flow_rate", "work_rate")
        },
        **{
            name: f"piston.{name}"
            for name in (
                *("force", "stop_force", "piston_position", "piston_velocity"),
                *("leakage_mass_flow_rate", "leakage_regime"),
            )
        },
    }
    inside: ClassVar[tuple[str, ...]] = (
        *(f"{side}.{name}" for side in (CAP, ROD) for name in ("mass", "volume", "heat_flow_rate", "work_rate")),
        *("stop_force", "piston_position", "piston_velocity", "leakage_mass_flow_rate", "leakage_regime"),
    )
    resume: ClassVar[dict[str, str]] = {
        f"{side}.{name}": f"{side}.initial_{name}" for side in (CAP, ROD) for name in ("pressure", "temperature")
    }

    def has(self, member: str) -> bool:
        return member != ROD or self.acting != SINGLE

    def check(self) -> None:
        if abs(float(self.direction)) != 1.0:  # type: ignore[arg-type]
            raise InputError("bodies.direction", "direction", value=float(self.direction))  # type: ignore[arg-type]
        if float(self.rod_diameter) >= float(self.bore):  # type: ignore[arg-type]
            shown = self.rod_diameter.display(), self.bore.display()  # type: ignore[union-attr]
            raise InputError("cylinder.rod_too_thick", "rod_diameter", shown=shown[0], bore=shown[1])

    def check_start(self, travel: float) -> None:
        offset, direction = float(self.offset), float(self.direction)  # type: ignore[arg-type]
        depth, stroke = offset + direction * travel, float(self.stroke_length)  # type: ignore[arg-type]
        # A little beyond: where a stop carries a load.
        if not -1e-3 * stroke <= depth <= 1.001 * stroke:
            raise InputError("cylinder.beyond_cover", "stroke_length", value=depth, stroke=stroke)

    def told(self, member: str) -> dict[str, Any]:
        shared = {name: getattr(self, name) for name in ("body", "stroke_length", "offset", "direction")}
        match member:
            case "cap":
                return shared | {"side": CAP, "outer_diameter": self.bore, "inner_diameter": 0.0}
            case "rod":
                return shared | {"side": ROD, "outer_diameter": self.bore, "inner_diameter": self.rod_diameter}
            case _:
                names = ("acting", "bore", "rod_diameter", "seal_friction", "end_stop", "spring", "leakage")
                ends = {"cap": f".{CAP}", "rod": f".{ROD}" if self.has(ROD) else AMBIENT}
                return shared | ends | {name: getattr(self, name) for name in names}

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        force, velocity = series(f"{name}.stop_force"), series(f"{name}.piston_velocity")
        return arrivals("piston_velocity", "m/s", force, velocity, series("time"))
