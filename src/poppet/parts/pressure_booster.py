"""Pressure booster: coupled pistons that compress air with air, a reversing valve and check valves."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import InputError
from poppet.core.provenance import Number, Source
from poppet.core.symbolic import clip
from poppet.parts import symbols
from poppet.parts.bodies import Mass
from poppet.parts.captions import CaptionNumbers
from poppet.parts.cushion import CAP, ROD
from poppet.parts.cylinder import CylinderChamber, EndStop, Leakage
from poppet.parts.fields import (
    NumberLike,
    body,
    group,
    laminar_limit,
    member,
    model,
    number,
    port,
    subsonic_index_m,
)
from poppet.parts.flow_path import FlowPath, iso_flow, named_flow
from poppet.parts.moving_compound import MovingCompound, stop_at, values_of
from poppet.parts.part import (
    AMBIENT,
    Actuator,
    ActuatorForce,
    Flow,
    GasState,
    Passage,
    PassageFlows,
    Quantities,
    Scope,
    State,
    Surroundings,
)
from poppet.parts.two_positions import switching_rate

CHAMBERS = {"drive_a": CAP, "drive_b": ROD, "boost_a": CAP, "boost_b": ROD}
"""Mapping from each chamber to the side on which it is: those of the cap expand towards larger positions."""
EDGES = {
    "supply_a": ("supply", "drive_a", 1.0),
    "supply_b": ("supply", "drive_b", -1.0),
    "exhaust_a": ("drive_a", "exhaust", -1.0),
    "exhaust_b": ("drive_b", "exhaust", 1.0),
}
"""Mapping from each edge of the reversing valve to its ports, and 1 if it is open at position 0, -1 at position 1."""
CHECKS = {
    **{f"intake_{side}": ("supply", f"boost_{side}") for side in "ab"},
    **{f"delivery_{side}": (f"boost_{side}", "outlet") for side in "ab"},
}
"""Mapping from each check valve to its ports."""
TRIP_FRACTION = 0.05
"""Default distance from the ends at which the valve reverses, as a fraction of the stroke."""
_GAS_OUTPUTS = ("pressure", "temperature", "mass", "volume", "heat_flow_rate", "work_rate")
_GEOMETRY = ("body", "side", "outer_diameter", "inner_diameter", "stroke_length", "offset", "direction", "dead_volume")


@dataclass(frozen=True)
class ReversingValve(FlowPath):
    """Valve that the pistons reverse near both ends of their stroke.

    It is a member part of `PressureBooster`. At position 0, it connects the supply with chamber a and chamber b with
    the exhaust, at position 1 the other way round. All edges are closed at the middle position. The trip mechanism has
    hysteresis: between the ends, the valve keeps its position.
    """

    kind: ClassVar[str] = "reversing_valve"
    regimes: ClassVar[tuple[str, ...]] = tuple(f"{edge}_regime" for edge in EDGES)
    summary: ClassVar[str] = "reversing valve of a booster"

    supply: str | None = port("gas node of the drive air")
    drive_a: str | None = port("drive chamber a")
    drive_b: str | None = port("drive chamber b")
    exhaust: str | None = port("gas node that receives the exhaust")
    body: str | None = body("pistons")
    stroke_length: NumberLike = number("m", doc="stroke of the pistons", above=0.0)
    trip_distance: NumberLike = number("m", doc="distance from the end at which the valve reverses", above=0.0)
    switching_time: NumberLike = number("s", "10 ms", doc="switching time", above=0.0, note="a small valve")
    exhaust_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C to the exhaust", low=0.0)
    exhaust_ratio: NumberLike = number("1", optional=True, doc="critical ratio b to the exhaust", low=0.0, below=1.0)
    initial_position: NumberLike = number(
        "1", 0.0, doc="initial position of the valve", low=0.0, high=1.0, note="the pistons move to larger positions"
    )

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        values.setdefault("exhaust_conductance", values["sonic_conductance"])
        values.setdefault("exhaust_ratio", values["critical_ratio"])
        return values

    def states(self) -> tuple[State, ...]:
        return (State("position", "1", 1.0, floor=1.0),)

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"position": scope["initial_position"]}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        position = scope.states["position"]
        flows, outputs = list[Flow](), Quantities(position=(position, "1"))
        for edge, (first, second, side) in EDGES.items():
            is_supply = edge.startswith("supply")
            conductance, ratio = (
                self.size_at(scope, None) if is_supply else (scope["exhaust_conductance"], scope["exhaust_ratio"])
            )
            opening = clip(side * (1.0 - 2.0 * position), 0.0, 1.0)
            flow, edge_outputs = named_flow(scope, gas, edge, (first, second), (conductance * opening, ratio))
            flows.append(flow)
            outputs |= edge_outputs
        # The drive is -1 and 1 at the distance of the trip from both ends.
        half = 0.5 * scope["stroke_length"]
        drive = (scope.body.position - half) / (half - scope["trip_distance"])
        rate = switching_rate(position, drive, scope["switching_time"])
        return PassageFlows(tuple(flows), outputs, {"position": rate})


@dataclass(frozen=True)
class BoosterChecks(FlowPath):
    """Four equal check valves, from the supply to the boost chambers and from these to the outlet.

    It is a member part of `PressureBooster`.
    """

    kind: ClassVar[str] = "booster_checks"
    regimes: ClassVar[tuple[str, ...]] = tuple(f"{name}_regime" for name in CHECKS)
    summary: ClassVar[str] = "check valves of a booster"

    supply: str | None = port("gas node of the air that is compressed")
    outlet: str | None = port("gas node that receives the compressed air")
    boost_a: str | None = port("boost chamber a")
    boost_b: str | None = port("boost chamber b")
    cracking_pressure: NumberLike = number(
        "Pa", 0.0, doc="cracking pressure", kind="pressure_difference", low=0.0, note="none by default"
    )

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        flows, outputs = list[Flow](), Quantities()
        law = {"cracking_pressure": scope["cracking_pressure"], "one_way": True}
        for name, ends in CHECKS.items():
            states = gas[ends[0]], gas[ends[1]]
            size = self.size_at(scope, None)
            flow, check_outputs = iso_flow(
                scope, f"{name}_mass_flow_rate", ends, states, size, regime=f"{name}_regime", **law
            )
            flows.append(flow)
            outputs |= check_outputs
        for total, name in (("intake", "intake"), ("outlet", "delivery")):
            outputs[f"{total}_mass_flow_rate"] = (
                sum(outputs[f"{name}_{side}_mass_flow_rate"][0] for side in "ab"),
                "kg/s",
            )
        return PassageFlows(tuple(flows), outputs)


@dataclass(frozen=True)
class CoupledPistons(Actuator, Passage):
    """Two coupled double-acting pistons, with the leakage past each of them.

    It is a member part of `PressureBooster`. The area of the rod between the pistons is neglected.
    """

    kind: ClassVar[str] = "coupled_pistons"
    regimes: ClassVar[tuple[str, ...]] = ("drive_leakage_regime", "boost_leakage_regime")
    summary: ClassVar[str] = "pistons of a booster"

    drive_a: str | None = port("drive chamber a")
    drive_b: str | None = port("drive chamber b")
    boost_a: str | None = port("boost chamber a")
    boost_b: str | None = port("boost chamber b")
    body: str | None = body("mass of the pistons")
    bore: NumberLike = number("m", doc="bore of the boost chambers", above=0.0)
    drive_bore: NumberLike = number("m", doc="bore of the drive chambers", above=0.0)
    seal_friction: NumberLike = number("N/Pa", 0.0, doc="seal friction per pressure difference", low=0.0)
    leakage: Any = group(Leakage, doc="leakage past each piston")
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        flows, outputs = list[Flow](), Quantities()
        size = scope["leakage.sonic_conductance"], scope["leakage.critical_ratio"]
        for name in ("drive", "boost"):
            flow, leak = named_flow(scope, gas, f"{name}_leakage", (f"{name}_a", f"{name}_b"), size)
            flows.append(flow)
            outputs |= leak
        return PassageFlows(tuple(flows), outputs)

    def actuator_force(self, scope: Scope, gas: Mapping[str, GasState]) -> ActuatorForce:
        drive = gas["drive_a"].pressure - gas["drive_b"].pressure
        boost = gas["boost_a"].pressure - gas["boost_b"].pressure
        force = 0.25 * math.pi * (scope["drive_bore"] ** 2 * drive + scope["bore"] ** 2 * boost)
        friction = scope["seal_friction"] * (abs(drive) + abs(boost))
        return ActuatorForce(force, {"force": (force, "N")}, friction=friction)


@dataclass(frozen=True)
class PressureBooster(MovingCompound):
    r"""Pressure booster: drive pistons with the supply pressure compress air in boost chambers.

    .. math:: p_2 - p_a = r \, (p_1 - p_a) \text{ at stall}, \qquad A_d = (r - 1)\, A_b

    Notes
    -----
    The supply fills the boost chambers through check valves, and drives the pistons through a valve that reverses near
    both ends of the stroke. The supply pressure acts on the drive area A_d and, in the chamber that is filled, on the
    boost area A_b. The outlet pressure acts on A_b alone. Without friction and cracking pressures, the booster
    therefore stalls at the `pressure_ratio` r of gauge pressures; the reference is the pressure at the exhaust. Both
    pistons have one stroke.

    By default, the exhaust is the ambient, and the drive air comes from the supply. With a separate `drive_supply`, for
    example behind a pressure regulator, the outlet stalls at p_1 + (r - 1) (p_d - p_a), so the regulator limits the
    outlet pressure.

    The booster takes air from the supply for the outlet and for the drive, which is vented into the exhaust. The dead
    volume of each chamber is a fraction of its swept volume, and includes its lines.

    References
    ----------
    ISO 1219-1 for the symbol; Beater, Pneumatic Drives, Springer 2007, for the principle.

    Examples
    --------
    >>> booster = PressureBooster(
    ...     supply="rail", outlet="tank", pressure_ratio=2.0, bore="40 mm", stroke_length="40 mm",
    ...     piston={"mass": "0.5 kg"}, valve={"nominal_flow": "800 l/min ANR"},
    ...     checks={"nominal_flow": "800 l/min ANR"},
    ... )
    >>> booster.ports()
    {'supply': 'rail', 'outlet': 'tank', 'exhaust': 'ambient'}
    """

    kind: ClassVar[str] = "pressure_booster"
    symbol: ClassVar[symbols.Symbol | str] = symbols.PRESSURE_BOOSTER
    summary: ClassVar[str] = "compresses air with air: coupled pistons, reversing valve, check valves"
    moving: ClassVar[str] = "piston"

    supply: str | None = port("gas node at the inlet")
    outlet: str | None = port("gas node that receives the compressed air")
    exhaust: str | None = port("gas node that receives the exhaust of the drive", optional=True)
    drive_supply: str | None = port("gas node of the drive air", optional=True)
    pressure_ratio: NumberLike = number("1", doc="ratio r of gauge pressures at stall", above=1.0)
    bore: NumberLike = number("m", doc="bore of the boost chambers", above=0.0)
    stroke_length: NumberLike = number("m", doc="stroke of the pistons", above=0.0)
    dead_fraction: NumberLike = number(
        "1", 0.1, doc="dead volume of each chamber per swept volume", above=0.0, note="a compact booster"
    )
    trip_distance: NumberLike = number(
        "m", optional=True, doc="distance from the end at which the valve reverses", above=0.0
    )
    seal_friction: NumberLike = number("N/Pa", 0.0, doc="seal friction per pressure difference", low=0.0, note="none")
    model: Any = model()
    leakage: Any = group(Leakage, doc="leakage past each piston")
    end_stop: Any = group(EndStop, doc="end stops of the pistons")
    piston: Any = member(Mass, doc="mass of the pistons", inherited=("inclination", "lower_stop", "upper_stop"))
    valve: Any = member(
        ReversingValve, doc="reversing valve",
        inherited=(
            "supply", "drive_a", "drive_b", "exhaust", "body", "stroke_length", "trip_distance", "characteristic",
            "model",
        ),
    )  # fmt: skip
    checks: Any = member(
        BoosterChecks,
        doc="check valves",
        inherited=("supply", "outlet", "boost_a", "boost_b", "characteristic", "model"),
    )
    drive_a: Any = member(CylinderChamber, doc="drive chamber a", inherited=_GEOMETRY)
    drive_b: Any = member(CylinderChamber, doc="drive chamber b", inherited=_GEOMETRY)
    boost_a: Any = member(CylinderChamber, doc="boost chamber a", inherited=_GEOMETRY)
    boost_b: Any = member(CylinderChamber, doc="boost chamber b", inherited=_GEOMETRY)
    pistons: Any = member(
        CoupledPistons, doc="pistons", inherited=(*CHAMBERS, "body", "bore", "drive_bore", "seal_friction", "leakage")
    )

    inlets: ClassVar[Mapping[str, str]] = {"piston.load_force": "piston.load_force"}
    outlets: ClassVar[Mapping[str, str]] = {
        "valve_position": "valve.position",
        "force": "pistons.force",
        **{f"{name}_mass_flow_rate": f"checks.{name}_mass_flow_rate" for name in ("intake", "outlet")},
        **{f"{edge}_mass_flow_rate": f"valve.{edge}_mass_flow_rate" for edge in EDGES},
        **{f"{name}_mass_flow_rate": f"checks.{name}_mass_flow_rate" for name in CHECKS},
        **{f"{name}_leakage_mass_flow_rate": f"pistons.{name}_leakage_mass_flow_rate" for name in ("drive", "boost")},
        **{f"{chamber}.{name}": f"{chamber}.{name}" for chamber in CHAMBERS for name in _GAS_OUTPUTS},
    }
    internal_outputs: ClassVar[tuple[str, ...]] = (
        "force",
        *(f"{name}_mass_flow_rate" for name in (*EDGES, *CHECKS, "drive_leakage", "boost_leakage")),
        *(f"{chamber}.{name}" for chamber in CHAMBERS for name in _GAS_OUTPUTS[1:]),
    )
    resume: ClassVar[dict[str, str]] = {
        **{f"piston.{name}": f"piston.initial_{name}" for name in ("position", "velocity")},
        "valve_position": "valve.initial_position",
        **{f"{chamber}.{n}": f"{chamber}.initial_{n}" for chamber in CHAMBERS for n in ("pressure", "temperature")},
    }

    def ports(self) -> dict[str, str]:
        return super().ports() | ({"exhaust": AMBIENT} if self.exhaust is None else {})

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        size = f"{numbers.text(self.bore)}, stroke {numbers.text(self.stroke_length)}"
        return [f"pressure booster, 1 : {numbers.text(self.pressure_ratio)}", size]

    def check(self) -> None:
        trip, stroke = self.trip_distance, float(self.stroke_length)  # type: ignore[arg-type]
        if trip is not None and float(trip) >= 0.5 * stroke:  # type: ignore[arg-type]
            shown, whole = trip.display(), self.stroke_length.display()  # type: ignore[union-attr]
            raise InputError("compounds.trip_distance", "trip_distance", shown=shown, whole=whole)

    def inherited_fields(self, member: str) -> dict[str, Any]:
        values = self._sizes()
        if member in CHAMBERS:
            of_drive = member.startswith("drive")
            bore, dead = ("drive_bore", "drive_dead_volume") if of_drive else ("bore", "boost_dead_volume")
            ring = {"outer_diameter": values.get(bore), "inner_diameter": 0.0, "dead_volume": values.get(dead)}
            motion = {"body": ".piston", "stroke_length": self.stroke_length, "offset": 0.0, "direction": 1.0}
            return motion | ring | {"side": CHAMBERS[member]}
        match member:
            case "piston":
                lower, upper = (stop_at(position, self.end_stop) for position in (0.0, self.stroke_length))
                return {"inclination": 0.0, "lower_stop": lower, "upper_stop": upper}
            case "valve":
                supply = self.supply if self.drive_supply is None else self.drive_supply
                ends = {
                    "supply": supply,
                    "exhaust": self.exhaust or AMBIENT,
                    "drive_a": ".drive_a",
                    "drive_b": ".drive_b",
                }
                trip = {"stroke_length": self.stroke_length, "trip_distance": values.get("trip_distance", 1.0)}
                # Without a stroke, the valves have no characteristic.
                return ends | trip | {"body": ".piston", "characteristic": None, "model": None}
            case "checks":
                ends = {"supply": self.supply, "outlet": self.outlet}
                return ends | {"boost_a": ".boost_a", "boost_b": ".boost_b", "characteristic": None, "model": None}
            case _:
                names = {name: getattr(self, name) for name in ("seal_friction", "leakage")}
                sizes = {"bore": self.bore, "drive_bore": values.get("drive_bore"), "body": ".piston"}
                return {chamber: f".{chamber}" for chamber in CHAMBERS} | names | sizes

    def _sizes(self) -> dict[str, Number]:
        """Return the sizes of the members by name; the result is empty if a required field is missing or invalid."""
        arguments = values_of(self.pressure_ratio, self.bore, self.stroke_length, self.dead_fraction)
        if arguments is None:
            return {}
        ratio, bore, stroke, fraction = arguments
        trip = [TRIP_FRACTION * stroke] if self.trip_distance is None else values_of(self.trip_distance)
        drive_bore = bore * (ratio - 1.0) ** 0.5
        swept = 0.25 * math.pi * bore**2 * stroke
        lengths = {"bore": bore, "drive_bore": drive_bore} | ({} if trip is None else {"trip_distance": trip[0]})
        dead = {"boost_dead_volume": fraction * swept, "drive_dead_volume": fraction * (ratio - 1.0) * swept}
        return {
            name: Number(value, unit, Source("given"))
            for unit, sizes in {"m": lengths, "m^3": dead}.items()
            for name, value in sizes.items()
        }
