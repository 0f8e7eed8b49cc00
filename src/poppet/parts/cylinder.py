"""Pneumatic cylinder: chambers, piston, leakage and end cushions."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError
from poppet.core.symbolic import maximum, where
from poppet.laws.physics import contact
from poppet.parts import symbols
from poppet.parts.bodies import find_impacts, impact_notes
from poppet.parts.captions import CaptionNumbers
from poppet.parts.compound import Compound
from poppet.parts.cushion import CAP, MIN_DEAD_FRACTION, ROD, Cushion, cover_distance, spear_travel
from poppet.parts.fields import (
    NumberLike,
    anr_pressure,
    anr_temperature,
    body,
    group,
    laminar_limit,
    member,
    model,
    number,
    option,
    port,
    subsonic_index_m,
)
from poppet.parts.flow_path import iso_flow
from poppet.parts.moving_gas import MovingGasStore
from poppet.parts.part import (
    AMBIENT,
    Actuator,
    ActuatorForce,
    GasState,
    Passage,
    PassageFlows,
    Quantities,
    Scope,
    Surroundings,
)

DOUBLE, SINGLE = "double", "single"
_CUSHIONS = ("cap_cushion", "rod_cushion")
_SIDES = (CAP, ROD, *_CUSHIONS)
_GAS_OUTPUTS = ("pressure", "temperature", "mass", "volume", "heat_flow_rate", "work_rate")
_PISTON_OUTPUTS = ("stop_force", "piston_position", "piston_velocity", "leakage_mass_flow_rate", "leakage_regime")
_INHERITED = ("side", "outer_diameter", "inner_diameter", "stroke_length", "offset", "direction", "body")


@dataclass(frozen=True)
class CylinderChamber(MovingGasStore):
    """Gas chamber on one side of the piston.

    It is a member part of `Cylinder`.
    """

    kind: ClassVar[str] = "cylinder_chamber"
    summary: ClassVar[str] = "one side of a cylinder"

    body: str | None = body("body of the cylinder")
    side: str = option(CAP, ROD, doc="side of the piston")
    outer_diameter: NumberLike = number("m", doc="outer diameter of the ring under pressure", above=0.0)
    inner_diameter: NumberLike = number("m", 0.0, doc="inner diameter of the ring under pressure", low=0.0)
    stroke_length: NumberLike = number("m", doc="stroke of the piston", above=0.0)
    offset: NumberLike = number("m", 0.0, doc="piston position at body position zero")
    direction: NumberLike = number("1", 1.0, doc="direction")
    dead_volume: NumberLike = number("m^3", doc="volume with the piston at this end; includes lines", above=0.0)
    wall_conductance: NumberLike = number("W/K", 0.0, doc="wall conductance h A", low=0.0, note="adiabatic by default")
    wall_temperature: NumberLike = number("K", optional=True, doc="wall temperature", kind="temperature", above=0.0)
    initial_pressure: NumberLike = anr_pressure("initial pressure")
    initial_temperature: NumberLike = anr_temperature("initial temperature")

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        return {"wall_temperature": ambient.temperature, **super().parameters(ambient)}

    def volume_and_area(self, scope: Scope) -> tuple[Any, Any]:
        depth, sign = cover_distance(self.side, scope)
        if "spear_area" in scope:  # the volume at the port of a side with a cushion
            travel, closed = spear_travel(depth, scope["length"], scope["closing_length"])
            added_volume, area = scope["spear_area"] * travel, sign * scope["spear_area"] * closed
        else:
            area = 0.25 * math.pi * (scope["outer_diameter"] ** 2 - scope["inner_diameter"] ** 2)
            added_volume, area = area * depth, sign * area
        volume, smallest = scope["dead_volume"] + added_volume, MIN_DEAD_FRACTION * scope["dead_volume"]
        return maximum(volume, smallest), where(volume > smallest, area, 0.0)


@dataclass(frozen=True)
class EndStop:
    """Parameters of the contact between piston and covers, by the law of Hunt and Crossley."""

    stiffness: NumberLike = number("N/m^1.5", 1e8, doc="contact stiffness", above=0.0, note="elastic rings")
    dissipation: NumberLike = number(
        "s/m",
        5.0,
        doc="contact dissipation; inverse of the speed at which damping saturates",
        low=0.0,
        note="half of the energy and more",
    )


@dataclass(frozen=True)
class ReturnSpring:
    """Parameters of the spring that retracts the piston of a single-acting cylinder."""

    rate: NumberLike = number("N/m", 0.0, doc="spring rate", low=0.0, note="none by default")
    preload: NumberLike = number("m", 0.0, doc="compression with the piston at the cap", low=0.0, note="none")


@dataclass(frozen=True)
class Leakage:
    """Parameters of the leakage past the piston between both chambers, an ISO 6358 flow path."""

    sonic_conductance: NumberLike = number("m^3/(s Pa)", 0.0, doc="sonic conductance C", low=0.0, note="tight")
    critical_ratio: NumberLike = number("1", 0.3, doc="critical ratio b", low=0.0, below=1.0)


@dataclass(frozen=True)
class Piston(Actuator, Passage):
    """Piston and rod, which exert a force on the body.

    It is a member part of `Cylinder`, and includes the leakage past the piston.
    """

    kind: ClassVar[str] = "piston"
    regimes: ClassVar[tuple[str, ...]] = ("leakage_regime",)
    summary: ClassVar[str] = "piston and rod of a cylinder"

    cap: str | None = port("chamber at the cap")
    rod: str | None = port("chamber at the rod")
    cap_port: str | None = port("space at the port of the cap", optional=True)
    rod_port: str | None = port("space at the port of the rod's side", optional=True)
    body: str | None = body("body of the cylinder")
    acting: str = option(DOUBLE, SINGLE, doc="double or single acting")
    bore: NumberLike = number("m", doc="bore", above=0.0)
    rod_diameter: NumberLike = number("m", 0.0, doc="rod diameter", low=0.0)
    stroke_length: NumberLike = number("m", doc="stroke of the piston", above=0.0)
    offset: NumberLike = number("m", 0.0, doc="piston position at body position zero")
    direction: NumberLike = number("1", 1.0, doc="direction")
    seal_friction: NumberLike = number("N/Pa", 0.0, doc="seal friction per pressure difference", low=0.0)
    end_stop: Any = group(EndStop, doc="end stops at the covers")
    spring: Any = group(ReturnSpring, doc="return spring")
    leakage: Any = group(Leakage, doc="leakage past the piston")
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        size = scope["leakage.sonic_conductance"], scope["leakage.critical_ratio"]
        ends = (gas["cap"], gas["rod"])
        flow, outputs = iso_flow(scope, "leakage_mass_flow_rate", ("cap", "rod"), ends, size, regime="leakage_regime")
        return PassageFlows((flow,), outputs)

    def actuator_force(self, scope: Scope, gas: Mapping[str, GasState]) -> ActuatorForce:
        direction, speed = scope["direction"], scope.body.velocity
        bore_area = 0.25 * math.pi * scope["bore"] ** 2
        rod_area = 0.25 * math.pi * scope["rod_diameter"] ** 2
        depth, out = cover_distance(CAP, scope)[0], direction * speed
        # The rod chamber of a single-acting cylinder is the ambient: the same formula.
        pressures = bore_area * gas["cap"].pressure - (bore_area - rod_area) * gas["rod"].pressure
        for side, sign in ((CAP, 1.0), (ROD, -1.0)):
            if f"{side}_port" in gas:  # the port pressure acts on the spear
                size = (scope[f"{side}_cushion.{name}"] for name in ("length", "closing_length"))
                closed = spear_travel(cover_distance(side, scope)[0], *size)[1]
                area = sign * scope[f"{side}_cushion.spear_area"] * closed
                pressures = pressures + area * (gas[f"{side}_port"].pressure - gas[side].pressure)
        force = pressures - rod_area * scope.surroundings.pressure
        compression = scope["spring.preload"] + depth
        force = force - scope["spring.rate"] * compression
        stop = scope["end_stop.stiffness"], scope["end_stop.dissipation"]
        stops = contact.stop_force(-depth, -out, *stop) - contact.stop_force(depth - scope["stroke_length"], out, *stop)
        seal_friction = scope["seal_friction"] * abs(gas["cap"].pressure - gas["rod"].pressure)
        outputs: Quantities = {
            "force": (force, "N"),
            "stop_force": (stops, "N"),
            "piston_position": (depth, "m"),
            "piston_velocity": (out, "m/s"),
        }
        return ActuatorForce(
            direction * (force + stops), outputs, friction=seal_friction, losses={"end_stop": -stops * out},
            energy=0.5 * scope["spring.rate"] * compression**2,
        )  # fmt: skip


@dataclass(frozen=True)
class Cylinder(Compound):
    r"""Double-acting or single-acting pneumatic cylinder that moves a body.

    .. math:: F = p_\mathrm{cap} A - p_\mathrm{rod} (A - A_r) - p_a A_r - k (x + h)

    .. math:: \dot U = \sum c_p T q + h A (T_w - T) - p \dot V

    Notes
    -----
    In the first equation, A is the piston area, A_r the rod area, p_a the ambient pressure, k the spring rate, h the
    compression of the spring at the cap, and x the piston position. Ports of other parts are connected to the chambers
    by the names `NAME.cap` and `NAME.rod`, where NAME is the name of the cylinder. A single-acting cylinder has no rod
    chamber: its rod side is open to the ambient. `seal_friction` increases the dry friction of the body.

    On a side with a cushion, `cap` or `rod` is the volume at the port, and `cap_cushion` or `rod_cushion` the volume
    between piston and cover, which exchanges heat with the wall. Within the distance `length` of the cushion from the
    end of the stroke, its spear closes the bore, and only a throttle connects the two volumes. The dead volume of a
    side includes that of its cushion.

    The output `force` is the force on the piston, without friction and without contact with the covers. `stop_force` is
    the contact force of the covers. The gas in each chamber has one temperature. The wall conductance does not depend
    on the stroke.

    Examples
    --------
    >>> cylinder = Cylinder(body="slide", bore="25 mm", rod_diameter="10 mm", stroke_length="160 mm",
    ...                     cap={"dead_volume": "5 cm^3"}, rod={"dead_volume": "5 cm^3"})
    >>> cylinder.stores()
    ('cap', 'rod')
    """

    kind: ClassVar[str] = "cylinder"
    symbol: ClassVar[symbols.Symbol | str] = symbols.CYLINDER
    summary: ClassVar[str] = "a pneumatic cylinder: two chambers, piston, leak, end stops"

    body: str | None = body("body that it moves")
    bore: NumberLike = number("m", doc="bore", above=0.0)
    rod_diameter: NumberLike = number("m", 0.0, doc="rod diameter", low=0.0, note="no rod by default")
    stroke_length: NumberLike = number("m", doc="stroke of the piston", above=0.0)
    acting: str = option(DOUBLE, SINGLE, doc="double or single acting")
    direction: NumberLike = number("1", 1.0, doc="direction, 1 or -1", note="extends towards larger positions")
    offset: NumberLike = number("m", 0.0, doc="piston position at body position zero", note="at the cap")
    seal_friction: NumberLike = number("N/Pa", 0.0, doc="seal friction per pressure difference", low=0.0, note="none")
    model: Any = model()
    leakage: Any = group(Leakage, doc="leakage past the piston")
    spring: Any = group(ReturnSpring, doc="return spring")
    end_stop: Any = group(EndStop, doc="end stops at the covers")
    cap: Any = member(CylinderChamber, doc="chamber at the cap", inherited=_INHERITED, is_open=True)
    rod: Any = member(CylinderChamber, doc="chamber at the rod", inherited=_INHERITED, is_open=True, optional=True)
    cap_cushion: Any = member(Cushion, doc="cushion at the cap", inherited=(*_INHERITED, "port"), optional=True)
    rod_cushion: Any = member(Cushion, doc="cushion at the rod", inherited=(*_INHERITED, "port"), optional=True)
    piston: Any = member(
        Piston, doc="piston and rod",
        inherited=("cap", "rod", "cap_port", "rod_port", "body", "acting", "bore", "rod_diameter", "stroke_length",
              "offset", "direction", "seal_friction", "end_stop", "spring", "leakage"),
    )  # fmt: skip

    outlets: ClassVar[Mapping[str, str]] = {
        **{f"{side}.{name}": f"{side}.{name}" for side in _SIDES for name in _GAS_OUTPUTS},
        **{f"{side}.{name}": f"{side}.{name}" for side in _CUSHIONS for name in ("mass_flow_rate", "regime")},
        "force": "piston.force",
        **{name: f"piston.{name}" for name in _PISTON_OUTPUTS},
    }
    internal_outputs: ClassVar[tuple[str, ...]] = (
        *(f"{side}.{name}" for side in _SIDES for name in _GAS_OUTPUTS[2:]),
        *(f"{side}.{name}" for side in _CUSHIONS for name in ("temperature", "mass_flow_rate", "regime")),
        *_PISTON_OUTPUTS,
    )
    resume: ClassVar[dict[str, str]] = {
        f"{side}.{name}": f"{side}.initial_{name}" for side in _SIDES for name in ("pressure", "temperature")
    }

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        rod = f", rod {numbers.text(self.rod_diameter)}" if float(self.rod_diameter) else ""  # type: ignore[arg-type]
        size = f"{numbers.text(self.bore)}{rod}, stroke {numbers.text(self.stroke_length)}"
        turned = [] if float(self.direction) > 0.0 else ["turned round"]  # type: ignore[arg-type]
        return [f"cylinder, {self.acting} acting", size, *turned]

    def has(self, member: str) -> bool:
        if member in _CUSHIONS and getattr(self, member) is None:
            return False
        return not member.startswith(ROD) or self.acting != SINGLE

    def check(self) -> None:
        if abs(float(self.direction)) != 1.0:  # type: ignore[arg-type]
            raise InputError("bodies.direction", "direction", value=float(self.direction))  # type: ignore[arg-type]
        if float(self.rod_diameter) >= float(self.bore):  # type: ignore[arg-type]
            texts = self.rod_diameter.display(), self.bore.display()  # type: ignore[union-attr]
            raise InputError("cylinder.rod_too_thick", "rod_diameter", shown=texts[0], bore=texts[1])
        with ErrorCollector() as errors:
            for name in (name for name in _CUSHIONS if getattr(self, name) is not None):
                cushion, side = getattr(self, name), getattr(self, name.removesuffix("_cushion"))
                low, high = float(self.rod_diameter) if side is self.rod else 0.0, float(self.bore)  # type: ignore[arg-type]
                if not low < float(cushion.diameter) < high:
                    shown = cushion.diameter.display()
                    errors.add("cylinder.spear", f"{name}.diameter", shown=shown, least=low, most=high)
                limits: dict[str, Any] = {"length": self.stroke_length, "dead_volume": side.dead_volume}
                for field, limit in limits.items():
                    shown = getattr(cushion, field).display()
                    if float(getattr(cushion, field)) >= float(limit):
                        address = f"{name}.{field}"
                        errors.add(f"cylinder.cushion.{field}", address, shown=shown, whole=limit.display())

    def check_start(self, travel: float) -> None:
        offset, direction = float(self.offset), float(self.direction)  # type: ignore[arg-type]
        depth, stroke = offset + direction * travel, float(self.stroke_length)  # type: ignore[arg-type]
        # A small tolerance: a stop that carries a load is compressed.
        if not -1e-3 * stroke <= depth <= 1.001 * stroke:
            raise InputError("cylinder.beyond_cover", "stroke_length", value=depth, stroke=stroke)

    def inherited_fields(self, member: str) -> dict[str, Any]:
        common = {name: getattr(self, name) for name in ("body", "stroke_length", "offset", "direction")}
        match member:
            case "cap":
                return common | {"side": CAP, "outer_diameter": self.bore, "inner_diameter": 0.0}
            case "rod":
                return common | {"side": ROD, "outer_diameter": self.bore, "inner_diameter": self.rod_diameter}
            case "cap_cushion" | "rod_cushion":
                side = member.removesuffix("_cushion")
                return self.inherited_fields(side) | {"port": f".{side}"}
            case _:
                names = ("acting", "bore", "rod_diameter", "seal_friction", "end_stop", "spring", "leakage")
                ends: dict[str, Any] = {CAP: f".{CAP}", ROD: f".{ROD}" if self.has(ROD) else AMBIENT}
                for side in (CAP, ROD):
                    is_cushioned = self.has(f"{side}_cushion")
                    ends[f"{side}_port"] = ends[side] if is_cushioned else None
                    ends[side] = f".{side}_cushion" if is_cushioned else ends[side]
                return common | ends | {name: getattr(self, name) for name in names}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        for side in (CAP, ROD):
            name = f"{side}_cushion"
            if name not in self.members:
                continue
            for key in ("initial_pressure", "initial_temperature", "wall_temperature", "wall_conductance"):
                values.setdefault(f"{name}.{key}", values[f"{side}.{key}"])
            # The wall is between piston and cover, and the trapped volume is not at the port.
            values[f"{side}.wall_conductance"] = 0.0
            values[f"{side}.dead_volume"] -= values[f"{name}.dead_volume"]
            for key in ("length", "closing_length", "spear_area"):
                values[f"{side}.{key}"] = values[f"piston.{name}.{key}"] = values[f"{name}.{key}"]
        return values

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        outputs = ("piston_position", "piston_velocity", "stop_force")
        position, velocity, force = (series(f"{name}.{output}") for output in outputs)
        stops = (0.0, float(self.stroke_length))  # type: ignore[arg-type]
        impacts = find_impacts(series("time"), position, velocity, force, stops)
        return impact_notes("piston_velocity", "m/s", impacts)
