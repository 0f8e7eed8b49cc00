"""Gripper: a cylinder that closes two jaws on a workpiece."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.provenance import Number, Source
from poppet.core.symbolic import where
from poppet.laws.physics import contact
from poppet.parts import symbols
from poppet.parts.bodies import PRESLIDING, BodyFriction, MovingBody, find_impacts, impact_notes
from poppet.parts.captions import CaptionNumbers
from poppet.parts.cushion import CAP, ROD
from poppet.parts.cylinder import (
    DOUBLE,
    SINGLE,
    CylinderChamber,
    EndStop,
    Leakage,
    Piston,
    ReturnSpring,
)
from poppet.parts.fields import (
    NumberLike,
    group,
    member,
    model,
    number,
    option,
)
from poppet.parts.moving_compound import MovingCompound, values_of
from poppet.parts.part import AMBIENT, BodyDynamics, BodyMotion, Input, Scope

EXTERNAL, INTERNAL = "external", "internal"
_GAS_OUTPUTS = ("pressure", "temperature", "mass", "volume", "heat_flow_rate", "work_rate")
_PISTON_OUTPUTS = ("stop_force", "piston_position", "piston_velocity", "leakage_mass_flow_rate", "leakage_regime")
_SHARED = ("body", "stroke_length", "offset", "direction")


@dataclass(frozen=True)
class Workpiece:
    """Workpiece between the jaws: the contact of each jaw by the law of Hunt and Crossley."""

    width: NumberLike = number("m", doc="distance between the jaws at which both touch the workpiece", low=0.0)
    present: NumberLike = number(
        "1", 1.0, doc="presence; 0 without a workpiece", low=0.0, high=1.0, note="present by default"
    )
    stiffness: NumberLike = number("N/m^1.5", 1e8, doc="contact stiffness", above=0.0, note="a stiff part")
    dissipation: NumberLike = number(
        "s/m",
        5.0,
        doc="contact dissipation; inverse of the speed at which damping saturates",
        low=0.0,
        note="half of the energy and more",
    )


@dataclass(frozen=True)
class Jaws(MovingBody):  # type: ignore[misc]  # the stops are no fields
    """Two jaws that move in opposite directions.

    The jaws are a member part of `Gripper`, and both jaws together are one body. The position of this body is the
    travel of each jaw from its open end. A force on the body is the sum of the forces on both jaws, each in the
    direction of travel of its jaw.
    """

    kind: ClassVar[str] = "jaws"
    summary: ClassVar[str] = "the jaws of a gripper"
    unit: ClassVar[str] = "m"
    effort: ClassVar[str] = "force"
    effort_unit: ClassVar[str] = "N"
    inertia_name: ClassVar[str] = "mass"
    presliding: ClassVar[float] = PRESLIDING
    max_depth: ClassVar[float] = 2e-3
    contact: ClassVar[str] = "workpiece"
    lower_stop = upper_stop = None

    mass: NumberLike = number("kg", doc="moving mass of both jaws with their fingers", above=0.0)
    load_force: NumberLike = number("N", 0.0, doc="load force that opens the jaws", note="none by default")
    initial_position: NumberLike = number("m", 0.0, doc="initial travel of each jaw", low=0.0, note="open by default")
    initial_velocity: NumberLike = number("m/s", 0.0, doc="initial velocity", note="at rest")
    friction: Any = group(BodyFriction, doc="friction", optional=True)
    transmission: NumberLike = number("1", doc="travel of a jaw per travel of the piston", above=0.0)
    jaw_stroke: NumberLike = number("m", doc="stroke of each jaw", above=0.0)
    closed_opening: NumberLike = number("m", 0.0, doc="distance between the closed jaws", low=0.0)
    gripping: str = option(EXTERNAL, INTERNAL, doc="side of the workpiece on which the jaws grip")
    workpiece: Any = group(Workpiece, doc="workpiece", optional=True)

    def structure(self) -> Hashable:
        return super().structure(), self.workpiece is not None

    def inputs(self) -> tuple[Input, ...]:
        present = Input("workpiece", "1", "workpiece.present", low=0.0, high=1.0, is_flag=True)
        return super().inputs() if self.workpiece is None else (*super().inputs(), present)

    def initial_travel(self) -> float:
        return float(self.initial_position) / float(self.transmission)  # type: ignore[arg-type]

    def motion(self, scope: Scope) -> BodyMotion:
        ratio = scope["transmission"]
        return BodyMotion(scope.states["position"] / ratio, scope.states["velocity"] / ratio)

    def dynamics(self, scope: Scope, force: Any, friction: Any) -> BodyDynamics:
        ratio = scope["transmission"]
        result = self._dynamics(scope, force / ratio, friction / ratio, 0.0)
        outputs = {"opening": (self._opening(scope), "m"), "gripping_force": (self._gripping_force(scope), "N")}
        return replace(result, outputs=result.outputs | outputs)

    def _opening(self, scope: Scope) -> Any:
        return scope["closed_opening"] + 2.0 * (scope["jaw_stroke"] - scope.states["position"])

    def _gripping_force(self, scope: Scope) -> Any:
        """Return the contact force between each jaw and the workpiece."""
        if self.workpiece is None:
            return 0.0
        sign = 1.0 if self.gripping == EXTERNAL else -1.0
        depth = 0.5 * sign * (scope["workpiece.width"] - self._opening(scope))
        law = scope["workpiece.stiffness"], scope["workpiece.dissipation"]
        return scope.inputs["workpiece"] * contact.stop_force(depth, sign * scope.states["velocity"], *law)

    def _stops(self, scope: Scope) -> Any:
        # Of both jaws. The covers of the cylinder are the other end stops.
        return (-2.0 if self.gripping == EXTERNAL else 2.0) * self._gripping_force(scope)

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        # Contact with a workpiece is no impact on an end stop.
        return tuple(self._drift_notes(name, series))


@dataclass(frozen=True)
class Gripper(MovingCompound):
    r"""Gripper with two jaws that a cylinder moves in opposite directions.

    .. math:: F_g = \frac{F}{2 i}, \qquad o = o_0 + 2 (s_J - s), \qquad s = i\,y

    Notes
    -----
    F_g is the gripping force of each jaw at rest without friction, F the force of the piston, i the transmission, o the
    opening between the jaws, o_0 the opening of the closed jaws, s the travel of a jaw from its open end, s_J its
    stroke, and y the travel of the piston. Ports of other parts are connected to the chambers by the names `NAME.cap`
    and `NAME.rod`, where NAME is the name of the gripper. With the direction 1, the jaws close if the piston extends.
    The spring of a single-acting gripper retracts the piston.

    Catalogues state the gripping force of each jaw at a pressure, often 6 bar: `rated_force` and `rated_pressure` give
    the transmission i = p A/(2 F_g). A is the piston area on the side that grips.

    The jaws touch a workpiece at the opening `workpiece.width`, from outside or from inside (`gripping`). The input
    `workpiece` is 1 with a workpiece, and 0 without it.

    Examples
    --------
    >>> gripper = Gripper(
    ...     bore="20 mm", jaw_stroke="5 mm", rated_force="45 N", jaws={"mass": "0.2 kg"},
    ...     workpiece={"width": "4 mm"}, cap={"dead_volume": "1 cm^3"}, rod={"dead_volume": "1 cm^3"},
    ... )
    >>> round(float(gripper.effective_transmission), 3)
    2.094
    """

    kind: ClassVar[str] = "gripper"
    symbol: ClassVar[symbols.Symbol | str] = symbols.GRIPPER
    summary: ClassVar[str] = "a gripper: cylinder, two jaws, workpiece"
    moving: ClassVar[str] = "jaws"

    bore: NumberLike = number("m", doc="bore", above=0.0)
    rod_diameter: NumberLike = number("m", 0.0, doc="rod diameter", low=0.0, note="no rod by default")
    jaw_stroke: NumberLike = number("m", doc="stroke of each jaw", above=0.0)
    transmission: NumberLike = number("1", optional=True, doc="travel of a jaw per travel of the piston", above=0.0)
    rated_force: NumberLike = number(
        "N",
        optional=True,
        doc="gripping force of each jaw at the rated pressure; in place of `transmission`",
        above=0.0,
    )
    rated_pressure: NumberLike = number(
        "Pa", "6 bar", doc="pressure difference of `rated_force`", kind="pressure_difference", above=0.0,
        note="usual in catalogues",
    )  # fmt: skip
    closed_opening: NumberLike = number("m", 0.0, doc="distance between the closed jaws", low=0.0, note="none")
    gripping: str = option(EXTERNAL, INTERNAL, doc="side of the workpiece on which the jaws grip")
    acting: str = option(DOUBLE, SINGLE, doc="double or single acting")
    direction: NumberLike = number("1", 1.0, doc="direction, 1 or -1", note="closes while the piston extends")
    seal_friction: NumberLike = number("N/Pa", 0.0, doc="seal friction per pressure difference", low=0.0, note="none")
    model: Any = model()
    leakage: Any = group(Leakage, doc="leakage past the piston")
    spring: Any = group(ReturnSpring, doc="return spring")
    end_stop: Any = group(EndStop, doc="end stops at the covers")
    workpiece: Any = group(Workpiece, doc="workpiece", optional=True)
    jaws: Any = member(
        Jaws, doc="jaws", inherited=("transmission", "jaw_stroke", "closed_opening", "gripping", "workpiece")
    )
    cap: Any = member(
        CylinderChamber, doc="chamber at the cap", inherited=("side", "outer_diameter", "inner_diameter", *_SHARED),
        is_open=True,
    )  # fmt: skip
    rod: Any = member(
        CylinderChamber, doc="chamber at the rod", inherited=("side", "outer_diameter", "inner_diameter", *_SHARED),
        is_open=True, optional=True,
    )  # fmt: skip
    piston: Any = member(
        Piston, doc="piston and rod",
        inherited=(CAP, ROD, "cap_port", "rod_port", *_SHARED, "acting", "bore", "rod_diameter", "seal_friction",
              "end_stop", "spring", "leakage"),
    )  # fmt: skip

    inlets: ClassVar[Mapping[str, str]] = {"jaws.load_force": "jaws.load_force", "workpiece": "jaws.workpiece"}
    outlets: ClassVar[Mapping[str, str]] = {
        **{f"{side}.{name}": f"{side}.{name}" for side in (CAP, ROD) for name in _GAS_OUTPUTS},
        "force": "piston.force",
        **{name: f"piston.{name}" for name in _PISTON_OUTPUTS},
        "opening": "jaws.opening",
        "gripping_force": "jaws.gripping_force",
    }
    internal_outputs: ClassVar[tuple[str, ...]] = (
        *(f"{side}.{name}" for side in (CAP, ROD) for name in _GAS_OUTPUTS[2:]), *_PISTON_OUTPUTS,
    )  # fmt: skip
    resume: ClassVar[dict[str, str]] = {
        **{f"jaws.{name}": f"jaws.initial_{name}" for name in ("position", "velocity")},
        **{f"{side}.{name}": f"{side}.initial_{name}" for side in (CAP, ROD) for name in ("pressure", "temperature")},
    }

    @property
    def effective_transmission(self) -> Number:
        """Travel of a jaw per travel of the piston, from the rated force if that is given; 1 if both are missing."""
        if isinstance(self.transmission, Number):
            return self.transmission
        ratio = 1.0
        values = values_of(self.bore, self.rod_diameter, self.direction, self.rated_force, self.rated_pressure)
        if values is not None:
            bore, rod, direction, force, pressure = values
            towards_cap = direction * (1.0 if self.gripping == EXTERNAL else -1.0)
            area = 0.25 * math.pi * (bore**2 - where(towards_cap > 0.0, 0.0, rod**2))
            ratio = 0.5 * pressure * area / force
        return Number(ratio, "1", Source("given"))

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        size = f"{numbers.text(self.bore)}, two jaws of {numbers.text(self.jaw_stroke)}"
        grips = [] if self.workpiece is None else [f"workpiece {numbers.text(self.workpiece.width)}"]
        return [f"gripper, {self.acting} acting", size, *grips]

    def has(self, member: str) -> bool:
        return member != ROD or self.acting != SINGLE

    def outside(self) -> dict[str, str]:
        names = super().outside()
        return names if self.workpiece is not None else {key: name for key, name in names.items() if key != "workpiece"}

    def check(self) -> None:
        if abs(float(self.direction)) != 1.0:  # type: ignore[arg-type]
            raise InputError("bodies.direction", "direction", value=float(self.direction))  # type: ignore[arg-type]
        if float(self.rod_diameter) >= float(self.bore):  # type: ignore[arg-type]
            texts = self.rod_diameter.display(), self.bore.display()  # type: ignore[union-attr]
            raise InputError("cylinder.rod_too_thick", "rod_diameter", shown=texts[0], bore=texts[1])
        if self.transmission is not None and self.rated_force is not None:
            raise InputError("compounds.transmission_twice", "rated_force")
        travel, end = float(self.jaws.initial_position), float(self.jaw_stroke)  # type: ignore[arg-type]
        # A small tolerance: an end stop that carries a load is compressed.
        if not -1e-2 * end <= travel <= 1.01 * end:
            raise InputError("compounds.beyond_end", "jaws.initial_position", value=travel, stroke=end, unit="m")

    def inherited_fields(self, member: str) -> dict[str, Any]:
        if member == "jaws":
            names = ("jaw_stroke", "closed_opening", "gripping", "workpiece")
            return {"transmission": self.effective_transmission} | {name: getattr(self, name) for name in names}
        shared: dict[str, Any] = {"body": ".jaws", "direction": self.direction, "stroke_length": None, "offset": 0.0}
        if (values := values_of(self.jaw_stroke, self.direction)) is not None:
            stroke, direction = values[0] / self.effective_transmission.value, values[1]
            # The open jaws are at the cap with the direction 1, and at the other end with the direction -1.
            lengths = {"stroke_length": stroke, "offset": 0.5 * (1.0 - direction) * stroke}
            shared |= {name: Number(value, "m", Source("given")) for name, value in lengths.items()}
        if member in (CAP, ROD):
            inner = 0.0 if member == CAP else self.rod_diameter
            return shared | {"side": member, "outer_diameter": self.bore, "inner_diameter": inner}
        fields = ("acting", "bore", "rod_diameter", "seal_friction", "end_stop", "spring", "leakage")
        ends = {CAP: f".{CAP}", ROD: f".{ROD}" if self.has(ROD) else AMBIENT, "cap_port": None, "rod_port": None}
        return shared | ends | {name: getattr(self, name) for name in fields}

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        outputs = ("piston_position", "piston_velocity", "stop_force")
        position, velocity, force = (series(f"{name}.{output}") for output in outputs)
        stops = (0.0, float(self.piston.stroke_length))
        impacts = find_impacts(series("time"), position, velocity, force, stops)
        return *super().remarks(name, series), *impact_notes("piston_velocity", "m/s", impacts)
