"""Bodies that actuators move: a mass on a line, a rotating joint, and a guide with a prescribed motion."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.provenance import Number
from poppet.core.symbolic import is_certain, maximum, minimum, sin, where
from poppet.laws.physics import contact, friction
from poppet.laws.physics.heat_transfer import GRAVITY
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import NumberLike, group, number, option, reference
from poppet.parts.part import Body, BodyDynamics, BodyMotion, Input, Quantities, Scope, State, Surroundings
from poppet.parts.rows import FrictionFactor

PRESLIDING = 1e-5
"""Default deflection at which dry friction breaks away [m]; assumed: seals of pneumatic cylinders have 5 to 50 um."""
PRESLIDING_ANGLE = 1e-4
"""Default deflection of a joint at which dry friction breaks away [rad]."""
LOOSER = 30.0
"""Tolerance of the motion per tolerance of the gas states."""
BRISTLES = 300.0
"""Tolerance of the bristle deflection per tolerance of the gas states.

The error is less than a thousandth of the friction force at the default tolerance. The tolerance of the motion would
need a fifth more steps without a more accurate motion."""

ELASTIC = 0.95
"""Default break-away displacement of the elasto-plastic law, as a fraction of the deflection at the Coulomb force."""
CREEP_LIMIT, CREEP_FORCE = 0.1, 0.95
"""Fractions of the Stribeck velocity and of the break-away force below which a body creeps instead of sliding.

The speed is the mean between two extremes of the friction force."""
DRIFT_CYCLES = 3
"""Number of load cycles without sliding after which a drift is reported."""
STICTION_LIMIT = 0.01
"""Fraction of the Stribeck velocity below which a body counts as stuck; its bristles can still creep."""
MIN_IMPACT_SPEED = 0.01
"""Speed below which an impact on a stop is not reported [m/s] or [rad/s]."""


@dataclass(frozen=True)
class BodyStop:
    """End stop of a mass by the law of Hunt and Crossley.

    The force is k d^1.5 with the stiffness k and the depth d of penetration, multiplied by a damping factor.
    """

    position: NumberLike = number("m", doc="position of the stop")
    stiffness: NumberLike = number("N/m^1.5", 1e8, doc="contact stiffness", above=0.0, note="a rubber bumper")
    dissipation: NumberLike = number(
        "s/m",
        5.0,
        doc="contact dissipation; inverse of the speed at which damping saturates",
        low=0.0,
        note="half of the energy and more",
    )


@dataclass(frozen=True)
class JointStop:
    """End stop of a joint by the law of Hunt and Crossley.

    The torque is k d^1.5 with the stiffness k and the angle d of penetration, multiplied by a damping factor.
    """

    position: NumberLike = number("rad", doc="angle of the stop")
    stiffness: NumberLike = number("N m/rad^1.5", 1e4, doc="contact stiffness", above=0.0, note="a rubber bumper")
    dissipation: NumberLike = number(
        "s/rad",
        1.0,
        doc="contact dissipation; inverse of the speed at which damping saturates",
        low=0.0,
        note="half of the energy",
    )


BRISTLE_LAWS = ("lugre", "elasto_plastic")
"""Friction laws that stick: they have the deflection of bristles as a state."""
DRY_LAWS = ("stribeck", *BRISTLE_LAWS)
KINDS = ("none", "viscous", *DRY_LAWS)


@dataclass(frozen=True)
class BodyFriction:
    """Parameters of the friction of a mass.

    Each friction law uses only some of them.
    """

    kind: str = option("viscous", *(k for k in KINDS if k != "viscous"), doc="law of friction")
    coulomb_force: NumberLike = number("N", optional=True, doc="Coulomb friction", low=0.0)
    static_force: NumberLike = number("N", optional=True, doc="break-away friction", low=0.0)
    stribeck_velocity: NumberLike = number("m/s", "10 mm/s", doc="Stribeck velocity", above=0.0)
    viscous_coefficient: NumberLike = number("N s/m", 0.0, doc="viscous friction", low=0.0, note="none by default")
    transition_velocity: NumberLike = number(
        "m/s",
        optional=True,
        doc="velocity of full friction; scale of the change of sign of `stribeck` at zero velocity",
        above=0.0,
    )
    bristle_stiffness: NumberLike = number("N/m", optional=True, doc="bristle stiffness", above=0.0)
    bristle_damping: NumberLike = number("N s/m", optional=True, doc="bristle damping", low=0.0)
    breakaway_displacement: NumberLike = number(
        "m",
        optional=True,
        doc="elastic deflection; deflection up to which a body with `elasto_plastic` does not creep",
        above=0.0,
    )
    negative_coulomb_force: NumberLike = number(
        "N", optional=True, doc="Coulomb friction at negative velocity", low=0.0
    )
    negative_static_force: NumberLike = number(
        "N", optional=True, doc="break-away friction at negative velocity", low=0.0
    )
    negative_viscous_coefficient: NumberLike = number(
        "N s/m", optional=True, doc="viscous friction at negative velocity", low=0.0
    )
    position_factor: Any = reference(doc="factor on the friction; mapping of lists position, factor")


@dataclass(frozen=True)
class JointFriction:
    """Parameters of the friction of a joint.

    Each friction law uses only some of them.
    """

    kind: str = option("viscous", *(k for k in KINDS if k != "viscous"), doc="law of friction")
    coulomb_torque: NumberLike = number("N m", optional=True, doc="Coulomb friction", low=0.0)
    static_torque: NumberLike = number("N m", optional=True, doc="break-away friction", low=0.0)
    stribeck_velocity: NumberLike = number("rad/s", 0.1, doc="Stribeck velocity", above=0.0)
    viscous_coefficient: NumberLike = number("N m s/rad", 0.0, doc="viscous friction", low=0.0, note="none by default")
    transition_velocity: NumberLike = number(
        "rad/s",
        optional=True,
        doc="velocity of full friction; scale of the change of sign of `stribeck` at zero velocity",
        above=0.0,
    )
    bristle_stiffness: NumberLike = number("N m/rad", optional=True, doc="bristle stiffness", above=0.0)
    bristle_damping: NumberLike = number("N m s/rad", optional=True, doc="bristle damping", low=0.0)
    breakaway_displacement: NumberLike = number(
        "rad",
        optional=True,
        doc="elastic deflection; deflection up to which a body with `elasto_plastic` does not creep",
        above=0.0,
    )
    negative_coulomb_torque: NumberLike = number(
        "N m", optional=True, doc="Coulomb friction at negative velocity", low=0.0
    )
    negative_static_torque: NumberLike = number(
        "N m", optional=True, doc="break-away friction at negative velocity", low=0.0
    )
    negative_viscous_coefficient: NumberLike = number(
        "N m s/rad", optional=True, doc="viscous friction at negative velocity", low=0.0
    )
    position_factor: Any = reference(doc="factor on the friction; mapping of lists position, factor")


@dataclass(frozen=True)
class MovingBody(Body):
    """Base class of bodies that have one position or angle as coordinate, friction and end stops."""

    unit: ClassVar[str]  # of the position
    effort: ClassVar[str]  # "force" or "torque", and its unit
    effort_unit: ClassVar[str]
    inertia_name: ClassVar[str]
    presliding: ClassVar[float]
    max_depth: ClassVar[float]  # largest initial penetration of a stop
    contact: ClassVar[str] = "end_stop"  # name of the loss in `_stops`

    resume: ClassVar[dict[str, str]] = {"position": "initial_position", "velocity": "initial_velocity"}

    if TYPE_CHECKING:  # fields of the subclasses
        friction: Any
        lower_stop: Any
        upper_stop: Any
        initial_position: Any

    def list_internal_outputs(self) -> tuple[str, ...]:
        return "acceleration", f"actuator_{self.effort}", f"stop_{self.effort}", f"breakaway_{self.effort}"

    def list_outputs(self) -> tuple[str, ...]:
        """Return the names of the outputs for motion and forces, with the load."""
        load, actuator, friction, stop, breakaway = (
            f"{name}_{self.effort}" for name in ("load", "actuator", "friction", "stop", "breakaway")
        )
        names = load, "position", "velocity", "acceleration", actuator, friction, stop
        return (*names, "friction_state", breakaway) if self._law in BRISTLE_LAWS else names

    @property
    def _law(self) -> str:
        return "none" if self.friction is None else str(self.friction.kind)

    @property
    def _has_direction(self) -> bool:
        """True if the friction has other parameters at negative velocity."""
        names = (f"coulomb_{self.effort}", f"static_{self.effort}", "viscous_coefficient")
        return self._law != "none" and any(getattr(self.friction, f"negative_{name}") is not None for name in names)

    @property
    def _factor(self) -> FrictionFactor | None:
        """Factor on the friction as a function of the position, or None if the friction does not depend on it."""
        return None if self._law == "none" else self.friction.position_factor

    def check(self) -> None:
        if self.friction is not None and self.friction.position_factor is not None:
            factor = FrictionFactor.read(self.friction.position_factor, self.unit)
            object.__setattr__(self.friction, "position_factor", factor)
        if self._law in DRY_LAWS and getattr(self.friction, f"coulomb_{self.effort}") is None:
            raise InputError("bodies.no_friction_force", f"friction.coulomb_{self.effort}", law=self._law)
        if self._law == "elasto_plastic" and self.friction.breakaway_displacement is not None:
            lowest = reduce(minimum, (minimum(*pair) for pair in self._levels()))
            elastic, limit = float(self.friction.breakaway_displacement), lowest / self._bristle_stiffness()
            if is_certain(elastic >= limit) and is_certain(limit > 0.0):
                facts: dict[str, Any] = {"value": elastic, "limit": limit, "unit": self.unit}
                raise InputError("bodies.breakaway", "friction.breakaway_displacement", **facts)
        if self._law == "stribeck" and self.friction.transition_velocity is None:
            raise InputError("bodies.no_transition", "friction.transition_velocity")
        low, high = (None if s is None else float(s.position) for s in (self.lower_stop, self.upper_stop))
        if low is not None and high is not None and low >= high:
            texts = self.lower_stop.position.display(), self.upper_stop.position.display()
            raise InputError("parts.stops_exchanged", "lower_stop.position", shown=texts[0], upper=texts[1])
        start = float(self.initial_position)
        # A stop that carries a load is compressed.
        if (low is not None and start < low - self.max_depth) or (high is not None and start > high + self.max_depth):
            raise InputError("bodies.beyond_stop", "initial_position", value=start, low=low, high=high, unit=self.unit)

    def notes(self) -> tuple[Note, ...]:
        """Return a note if dry friction is specified, but the law omits it."""
        levels = [f"{sign}{level}_{self.effort}" for sign in ("", "negative_") for level in ("coulomb", "static")]
        has_law = self.friction is None or self._law in DRY_LAWS
        idle = [] if has_law else [name for name in levels if getattr(self.friction, name) is not None]
        note = Note("bodies.idle_friction", f"friction.{idle[0]}", law=self._law) if idle else None
        return super().notes() + ((note,) if note else ())

    def _levels(self) -> list[tuple[Any, Any]]:
        """Return pairs of Coulomb and static friction, or their defaults, in SI units.

        The first pair is valid at positive velocity. The second pair, at negative velocity, exists only if the friction
        depends on the direction.
        """
        names = [f"coulomb_{self.effort}", f"static_{self.effort}"]
        coulomb, static = (getattr(self.friction, name) for name in names)
        levels = [(coulomb.value, (coulomb if static is None else static).value)]
        if self._has_direction:
            opposite = [getattr(self.friction, f"negative_{name}") for name in names]
            pairs = zip(levels[0], opposite, strict=True)
            coulomb, static = (value if number is None else number.value for value, number in pairs)
            levels.append((coulomb, static))
        return levels

    def _bristle_stiffness(self) -> Any:
        """Return the bristle stiffness, or its default, in SI units."""
        if self.friction.bristle_stiffness is not None:
            return self.friction.bristle_stiffness.value
        # At least a hundredth of a newton: a friction of zero has no stiffness.
        largest = reduce(maximum, (maximum(static, coulomb) for coulomb, static in self._levels()))
        return maximum(largest, 1e-2) / self.presliding

    def largest_deflection(self, values: Mapping[str, float]) -> float:
        """Return the largest deflection of the bristles before a body with dry friction slides.

        `values` are the parameters of the body. The law must be `lugre` or `elasto_plastic`.
        """
        kinds = (f"coulomb_{self.effort}", f"static_{self.effort}")
        level = max(value for name, value in values.items() if name.endswith(kinds))
        factors = (value for name, value in values.items() if name.startswith("friction.position_factor.factor_"))
        return max(factors, default=1.0) * level / values["friction.bristle_stiffness"]

    def _friction_caption(self, numbers: CaptionNumbers) -> str:
        if self._law == "none":
            return "no friction"
        if self._law == "viscous":
            return f"friction {numbers.text(self.friction.viscous_coefficient)}"
        return (
            f"{self._law.replace('_', '-')} friction {numbers.text(getattr(self.friction, f'coulomb_{self.effort}'))}"
        )

    def numbers(self) -> dict[str, Number]:
        factor = None if self.friction is None else self.friction.position_factor
        table = {} if factor is None else factor.numbers()
        return super().numbers() | {f"friction.position_factor.{name}": value for name, value in table.items()}

    def structure(self) -> Hashable:
        stops = self.lower_stop is not None, self.upper_stop is not None
        factor = None if self._factor is None else self._factor.structure()
        return super().structure(), self._law, *stops, self._has_direction, factor

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if self._factor is not None:
            numbers = self._factor.parameters(ambient.pressure)
            values |= {f"friction.position_factor.{name}": value for name, value in numbers.items()}
        if self._has_direction:
            values.setdefault("friction.negative_viscous_coefficient", values["friction.viscous_coefficient"])
        if self._law not in DRY_LAWS:
            return values
        stiffness, breakaway = self._bristle_stiffness(), values.get("friction.breakaway_displacement")
        for prefix, (coulomb, static) in zip(("", "negative_"), self._levels(), strict=False):
            values.setdefault(f"friction.{prefix}coulomb_{self.effort}", coulomb)
            values.setdefault(f"friction.{prefix}static_{self.effort}", static)
            if self._law == "elasto_plastic":
                default = ELASTIC * minimum(coulomb, static) / stiffness if breakaway is None else breakaway
                values.setdefault(f"friction.{prefix}breakaway_displacement", default)
        if self._law in BRISTLE_LAWS:
            values.setdefault("friction.bristle_stiffness", stiffness)
            values.setdefault("friction.bristle_damping", 2.0 * (stiffness * values[self.inertia_name]) ** 0.5)
        return values

    def states(self) -> tuple[State, ...]:
        # Nominal sizes: a decimetre and a metre per second.
        result = [State("position", self.unit, 0.1, LOOSER, 0.1), State("velocity", f"{self.unit}/s", 1.0, LOOSER, 0.1)]
        if self._law in BRISTLE_LAWS:
            result.append(State("deflection", self.unit, self.presliding, BRISTLES, 1.0))
        return tuple(result)

    def inputs(self) -> tuple[Input, ...]:
        return (Input(f"load_{self.effort}", self.effort_unit, f"load_{self.effort}"),)

    def start(self, scope: Scope) -> dict[str, Any]:
        values = {"position": scope["initial_position"], "velocity": scope["initial_velocity"], "deflection": 0.0}
        return {state.name: values[state.name] for state in self.states()}

    def _dynamics(self, scope: Scope, effort: Any, added_friction: Any, weight: Any) -> BodyDynamics:
        """Return the outputs of the body, and the time derivatives of its states.

        `effort` is the total force or torque of all actuators. `added_friction` is the dry friction of their seals.
        `weight` is a constant force or torque towards smaller positions.
        """
        position, velocity, inertia = scope.states["position"], scope.states["velocity"], scope[self.inertia_name]
        rates: dict[str, Any] = {}
        friction_effort = self._friction(scope, added_friction, rates)
        stop_effort = self._stops(scope)
        load = scope.inputs[f"load_{self.effort}"]
        driving = effort - weight - load
        total = driving - friction_effort + stop_effort
        rates |= {"position": velocity, "velocity": total / inertia}
        outputs: Quantities = {
            "position": (position, self.unit),
            "velocity": (velocity, f"{self.unit}/s"),
            "acceleration": (total / inertia, f"{self.unit}/s^2"),
            f"actuator_{self.effort}": (effort, self.effort_unit),
            f"friction_{self.effort}": (friction_effort, self.effort_unit),
            f"stop_{self.effort}": (stop_effort, self.effort_unit),
        }
        if self._law in BRISTLE_LAWS:
            limit = STICTION_LIMIT * scope["friction.stribeck_velocity"]
            direction = where(velocity > 0.0, 1.0, -1.0)
            outputs["friction_state"] = (where(abs(velocity) > limit, direction, 0.0), "1")
            side = scope.states["deflection"]
            coulomb, static = (
                self._parameter(scope, f"{level}_{self.effort}", side) for level in ("coulomb", "static")
            )
            breakaway = where(coulomb > static, coulomb, static) + added_friction
            outputs[f"breakaway_{self.effort}"] = (breakaway, self.effort_unit)
        # Separate powers: the scale of an energy residual is the energy transferred, not a small difference.
        powers = driving * velocity, (stop_effort - friction_effort) * velocity
        loads = {"load": load * velocity, "weight": weight * velocity}
        losses = {"friction": friction_effort * velocity, self.contact: -stop_effort * velocity}
        return BodyDynamics(outputs, rates, 0.5 * inertia * velocity * velocity, powers, loads, losses)

    def _friction(self, scope: Scope, added: Any, rates: dict[str, Any]) -> Any:
        """Return the friction force or torque against the motion.

        `added` is additional dry friction. The time derivative of the bristle deflection, if it is a state, is added to
        `rates`.
        """
        velocity = scope.states["velocity"]
        if self._law == "none":
            return 0.0
        viscous = self._parameter(scope, "viscous_coefficient", velocity) * velocity
        if self._law == "viscous":
            return viscous
        stribeck = scope["friction.stribeck_velocity"]
        coulomb, static = (self._parameter(scope, f"{name}_{self.effort}", velocity) for name in ("coulomb", "static"))
        # Seals under pressure increase both levels.
        levels = (coulomb + added, static + added)
        if self._law == "stribeck":
            transition = scope["friction.transition_velocity"]
            return contact.stribeck_friction(velocity, *levels, stribeck, transition, 0.0) + viscous
        level = friction.sliding_level(velocity, *levels, stribeck) + 1e-9
        deflection, stiffness = scope.states["deflection"], scope["friction.bristle_stiffness"]
        if self._law == "lugre":
            rate = friction.bristle_rate(deflection, velocity, level, stiffness)
        else:
            elastic = self._parameter(scope, "breakaway_displacement", velocity) + ELASTIC * added / stiffness
            rate = friction.elasto_plastic_rate(deflection, velocity, level, stiffness, elastic)
        rates["deflection"] = rate
        damping = scope["friction.bristle_damping"]
        return friction.lugre_force(deflection, rate, velocity, stiffness, damping, stribeck) + viscous

    def _parameter(self, scope: Scope, name: str, direction: Any) -> Any:
        """Return a parameter of the friction at the present position.

        The sign of `direction` selects the value for positive or negative velocity. All parameters that depend on the
        direction are proportional to the factor on the friction.
        """
        value = scope[f"friction.{name}"]
        if self._has_direction:
            value = where(direction < 0.0, scope[f"friction.negative_{name}"], value)
        if self._factor is not None:
            prefix = "friction.position_factor."
            numbers = {name: scope[f"{prefix}{name}"] for name in self._factor.numbers()}
            value = self._factor.at(scope.states["position"], numbers) * value
        return value

    def _stops(self, scope: Scope) -> Any:
        position, velocity = scope.states["position"], scope.states["velocity"]

        def stop(name: str, sign: float) -> Any:
            if getattr(self, name) is None:
                return 0.0
            depth = sign * (position - scope[f"{name}.position"])
            return contact.stop_force(depth, sign * velocity, scope[f"{name}.stiffness"], scope[f"{name}.dissipation"])

        return stop("lower_stop", -1.0) - stop("upper_stop", 1.0)

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        position, velocity, force = (series(f"{name}.{key}") for key in ("position", "velocity", f"stop_{self.effort}"))
        stops = [math.nan if stop is None else float(stop.position) for stop in (self.lower_stop, self.upper_stop)]
        impacts = find_impacts(series("time"), position, velocity, force, stops)
        return *impact_notes("velocity", f"{self.unit}/s", impacts), *self._drift_notes(name, series)

    def _drift_notes(self, name: str, series: Callable[[str], Any]) -> Iterator[Note]:
        """Yield a note on the largest drift of the body while it sticks under an oscillating load.

        `series` is a function that returns the recorded series for the address of an output.
        """
        if self._law not in BRISTLE_LAWS:
            return
        stiffness, limit = self._bristle_stiffness(), CREEP_LIMIT * float(self.friction.stribeck_velocity)
        time, force, level = (
            series(k) for k in ("time", f"{name}.friction_{self.effort}", f"{name}.breakaway_{self.effort}")
        )
        # Without the reversible deflection of the bristles.
        displacement = series(f"{name}.position") - force / stiffness
        turns = 1 + np.flatnonzero(np.diff(np.sign(np.diff(force))))
        bounds = np.unique([0, *turns, time.size - 1])
        # Between two extremes of the force: slower than sliding and below its friction at these speeds.
        is_slow = abs(np.diff(displacement[bounds])) < limit * np.diff(time[bounds])
        is_above = np.concatenate([[0], np.cumsum(abs(force) >= CREEP_FORCE * level)])
        is_stuck = is_slow & (is_above[bounds[1:] + 1] == is_above[bounds[:-1]])
        largest, facts = 0.0, {}
        for first, after in np.flatnonzero(np.diff(is_stuck, prepend=False, append=False)).reshape(-1, 2):
            start, end = bounds[first], bounds[after]
            rows, drift = slice(start, end + 1), abs(float(displacement[end] - displacement[start]))
            breakaway = float(level[rows].max())
            if drift > max(largest, breakaway / stiffness) and after - first > 2 * DRIFT_CYCLES:
                largest = drift
                facts = {"drift": drift, "start": float(time[start]), "duration": float(time[end] - time[start])}
                facts |= {"low": float(force[rows].min()), "high": float(force[rows].max()), "level": breakaway}
        if facts:
            units = {"unit": self.unit, "effort": self.effort, "effort_unit": self.effort_unit}
            yield Note("bodies.drift" if self._law == "lugre" else "bodies.creep", "position", **facts, **units)


def impact_notes(address: str, unit: str, impacts: Sequence[tuple[float, float]]) -> tuple[Note, ...]:
    """Return a tuple with a note on the fastest of several impacts on an end stop.

    `impacts` contains the time [s] and the velocity of each impact in the unit `unit`. The result is empty if there are
    no impacts.
    """
    if not impacts:
        return ()
    time, velocity = max(impacts, key=lambda impact: abs(impact[1]))
    return (Note("bodies.met_stop", address, time=time, speed=abs(velocity), count=len(impacts), unit=unit),)


def find_impacts(
    time: Any, position: Any, velocity: Any, force: Any, stops: Sequence[float]
) -> list[tuple[float, float]]:
    """Return time and velocity of each impact of a body on its end stops.

    The arguments are the recorded motion of a run, shape (n_times,), the force of the stops, and the positions of the
    lower and the upper stop. An impact usually occurs between two rows of the recording. Its velocity is extrapolated
    by a parabola through the last three rows before it. Impacts with less than 0.01 m/s or 0.01 rad/s are omitted.
    """
    impacts = []
    for k in np.flatnonzero((force[1:] != 0.0) & (force[:-1] == 0.0)).tolist():
        impact = float(time[k]), float(velocity[k])
        gap = stops[int(impact[1] > 0.0)] - float(position[k])
        if k > 1 and gap * impact[1] > 0.0:
            # Plain floats are faster than arrays here.
            previous = [(float(time[i]) - impact[0], float(velocity[i])) for i in (k - 2, k - 1)]
            wait, speed = _extrapolate_motion(previous, impact[1], gap)
            if 0.0 <= wait <= float(time[k + 1]) - impact[0]:
                impact = impact[0] + wait, speed
        if abs(impact[1]) > MIN_IMPACT_SPEED:
            impacts.append(impact)
    return impacts


def _extrapolate_motion(previous: Sequence[tuple[float, float]], last: float, gap: float) -> tuple[float, float]:
    """Return the time in which a body travels the distance `gap`, and its final velocity.

    The velocity follows a parabola through the two pairs of time and velocity in `previous`, and through the velocity
    `last` at time zero. The result is (-1, 0) if the velocity becomes zero before.
    """
    (t0, v0), (t1, v1) = previous
    first, second = (v1 - v0) / (t1 - t0), (last - v1) / -t1
    curve = (second - first) / -t0
    slope = second - curve * t1
    wait = gap / last
    for _ in range(6):  # of Newton's method
        speed = last + wait * (slope + wait * curve)
        if speed == 0.0:
            return -1.0, 0.0
        wait -= (wait * (last + wait * (slope / 2.0 + wait * curve / 3.0)) - gap) / speed
    return wait, last + wait * (slope + wait * curve)


@dataclass(frozen=True)
class Mass(MovingBody):
    r"""Body that moves on a line.

    .. math:: m \ddot x = \sum F - F_\mathrm{friction} + F_\mathrm{stop} - m g \sin\alpha - F_\mathrm{load}

    Notes
    -----
    At an inclination :math:`\alpha` of 90 degrees, larger positions are higher.

    With the friction laws `lugre` and `elasto_plastic`, the body can stick. With `lugre`, a stuck body drifts under an
    oscillating load below the break-away force. With `elasto_plastic`, it does not drift while the deflection of the
    bristles is below the break-away displacement; at larger deflections it creeps. A note reports drift and creep. With
    `stribeck`, the friction is zero at zero velocity: a body under a load below the break-away force creeps at a speed
    of the order of the transition velocity, which therefore has no default.

    With the default bristle stiffness, the friction breaks away at a deflection of 10 um. With the default bristle
    damping, the stuck mass is critically damped. The default break-away displacement is 95 % of the deflection at the
    Coulomb force; the seal friction of actuators increases it by 95 % of the deflection at this friction.

    Examples
    --------
    >>> slide = Mass(mass="4 kg", friction={"kind": "lugre", "coulomb_force": "20 N", "static_force": "30 N"})
    >>> float(slide.friction.static_force)
    30.0
    """

    kind: ClassVar[str] = "mass"
    symbol: ClassVar[symbols.Symbol | str] = symbols.MASS
    summary: ClassVar[str] = "a body on a line: friction, end stops, inclination"
    unit: ClassVar[str] = "m"
    effort: ClassVar[str] = "force"
    effort_unit: ClassVar[str] = "N"
    inertia_name: ClassVar[str] = "mass"
    presliding: ClassVar[float] = PRESLIDING
    max_depth: ClassVar[float] = 2e-3

    mass: NumberLike = number("kg", doc="moving mass m; includes the piston", above=0.0)
    inclination: NumberLike = number("rad", 0.0, doc="inclination alpha", note="level by default")
    load_force: NumberLike = number("N", 0.0, doc="load force towards smaller positions", note="none by default")
    initial_position: NumberLike = number("m", 0.0, doc="initial position", note="zero by default")
    initial_velocity: NumberLike = number("m/s", 0.0, doc="initial velocity", note="at rest")
    friction: Any = group(BodyFriction, doc="friction", optional=True)
    lower_stop: Any = group(BodyStop, doc="end stop at small positions", optional=True)
    upper_stop: Any = group(BodyStop, doc="end stop at large positions", optional=True)

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        incline = [f"rises at {numbers.text(self.inclination)}"] if float(self.inclination) else []  # type: ignore[arg-type]
        return [numbers.text(self.mass), *incline, self._friction_caption(numbers)]

    def initial_travel(self) -> float:
        return float(self.initial_position)  # type: ignore[arg-type]

    def motion(self, scope: Scope) -> BodyMotion:
        return BodyMotion(scope.states["position"], scope.states["velocity"])

    def dynamics(self, scope: Scope, force: Any, friction: Any) -> BodyDynamics:
        return self._dynamics(scope, force, friction, scope["mass"] * GRAVITY * sin(scope["inclination"]))


@dataclass(frozen=True)
class Joint(MovingBody):
    r"""Rotating body that actuators move by a pulley.

    The travel of the actuators is the pulley radius times the angle.

    .. math:: J \ddot\varphi = r \sum F - M_\mathrm{friction} + M_\mathrm{stop} - M_\mathrm{load}

    Examples
    --------
    >>> elbow = Joint(inertia="0.02 kg m^2", pulley_radius="25 mm")
    >>> float(elbow.pulley_radius)
    0.025
    """

    kind: ClassVar[str] = "joint"
    symbol: ClassVar[symbols.Symbol | str] = symbols.JOINT
    summary: ClassVar[str] = "a rotating body: inertia, pulley, friction, end stops"
    unit: ClassVar[str] = "rad"
    effort: ClassVar[str] = "torque"
    effort_unit: ClassVar[str] = "N m"
    inertia_name: ClassVar[str] = "inertia"
    presliding: ClassVar[float] = PRESLIDING_ANGLE
    max_depth: ClassVar[float] = 0.05

    inertia: NumberLike = number("kg m^2", doc="moment of inertia J", above=0.0)
    pulley_radius: NumberLike = number("m", doc="pulley radius r", above=0.0)
    load_torque: NumberLike = number("N m", 0.0, doc="load torque towards smaller angles", note="none by default")
    initial_position: NumberLike = number("rad", 0.0, doc="initial position", note="zero by default")
    initial_velocity: NumberLike = number("rad/s", 0.0, doc="initial velocity", note="at rest")
    friction: Any = group(JointFriction, doc="friction", optional=True)
    lower_stop: Any = group(JointStop, doc="end stop at small angles", optional=True)
    upper_stop: Any = group(JointStop, doc="end stop at large angles", optional=True)

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        pulley = f"pulley {numbers.text(self.pulley_radius)}"
        return [numbers.text(self.inertia), pulley, self._friction_caption(numbers)]

    def initial_travel(self) -> float:
        return float(self.pulley_radius) * float(self.initial_position)  # type: ignore[arg-type]

    def motion(self, scope: Scope) -> BodyMotion:
        radius = scope["pulley_radius"]
        return BodyMotion(radius * scope.states["position"], radius * scope.states["velocity"])

    def dynamics(self, scope: Scope, force: Any, friction: Any) -> BodyDynamics:
        radius = scope["pulley_radius"]
        return self._dynamics(scope, radius * force, radius * friction, 0.0)


@dataclass(frozen=True)
class Guide(Body):
    """Body with a prescribed motion, for tests of actuators.

    Only a signal can drive the position: straight lines between points, or a sine.

    Examples
    --------
    >>> Guide(position="20 mm").inputs()[0].name
    'position'
    """

    kind: ClassVar[str] = "guide"
    symbol: ClassVar[symbols.Symbol | str] = symbols.GUIDE
    summary: ClassVar[str] = "a body with a prescribed motion"

    position: NumberLike = number("m", 0.0, doc="position without a signal", note="zero by default")

    def inputs(self) -> tuple[Input, ...]:
        return Input("position", "m", "position", by_signal=True), Input("velocity", "m/s", 0.0, slope_of="position")

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return ["moved by its signal"]

    def initial_travel(self) -> float:
        return float(self.position)  # type: ignore[arg-type]

    def motion(self, scope: Scope) -> BodyMotion:
        return BodyMotion(scope.inputs["position"], scope.inputs["velocity"])

    def dynamics(self, scope: Scope, force: Any, friction: Any) -> BodyDynamics:
        # The force that holds it against its actuators.
        loads = {"load": force * scope.inputs["velocity"]}
        return BodyDynamics({"holding_force": (-force, "N")}, loads=loads)
