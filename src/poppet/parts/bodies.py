"""Bodies that actuators move: a mass on a line, a joint that turns, a guide that is moved."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.symbolic import sin, where
from poppet.laws.physics import contact, friction
from poppet.laws.physics.heat_transfer import GRAVITY
from poppet.parts.fields import NumberLike, group, number, option
from poppet.parts.part import Body, BodyDynamics, BodyMotion, Input, Quantities, Scope, State, Surroundings

PRESLIDING = 1e-5
"""Deflection at which dry friction breaks away, unless a stiffness is given [m]: assumed, as seals of pneumatic
cylinders show 5 to 50 um."""
PRESLIDING_ANGLE = 1e-4
"""The same of a joint [rad]."""
LOOSER = 30.0
"""Tolerance of the motion per tolerance of the gas."""
BRISTLES = 300.0
"""The same of the deflection behind dry friction: less than a thousandth of the force that it makes at the default
tolerance. Held as the motion is, it alone takes a fifth of the steps, and the motion comes out no better."""

STICKS = 0.01
"""Part of the Stribeck velocity up to which a body is said to stick: its bristles still bend and creep."""
SLOW = 0.01
"""Arrivals at a stop slower than this are not told [m/s] or [rad/s]."""


@dataclass(frozen=True)
class BodyStop:
    """An end stop of a mass after Hunt and Crossley: force k d^1.5, damped while in contact."""

    position: NumberLike = number("m", doc="position at which the stop is met")
    stiffness: NumberLike = number("N/m^1.5", 1e8, doc="contact stiffness", above=0.0, note="a rubber bumper")
    dissipation: NumberLike = number("s/m", 5.0, doc="contact dissipation", low=0.0, note="half of the energy and more")


@dataclass(frozen=True)
class JointStop:
    """An end stop of a joint, as that of a mass."""

    position: NumberLike = number("rad", doc="angle at which the stop is met")
    stiffness: NumberLike = number("N m/rad^1.5", 1e4, doc="contact stiffness", above=0.0, note="a rubber bumper")
    dissipation: NumberLike = number("s/rad", 1.0, doc="contact dissipation", low=0.0, note="half of the energy")


KINDS = ("none", "viscous", "stribeck", "lugre")


@dataclass(frozen=True)
class BodyFriction:
    """Friction of a mass; which numbers count depends on its kind."""

    kind: str = option("viscous", *(k for k in KINDS if k != "viscous"), doc="law of friction")
    coulomb_force: NumberLike = number("N", optional=True, doc="Coulomb friction", low=0.0)
    static_force: NumberLike = number("N", optional=True, doc="break-away friction", low=0.0)
    stribeck_velocity: NumberLike = number("m/s", "10 mm/s", doc="Stribeck velocity", above=0.0)
    viscous_coefficient: NumberLike = number("N s/m", 0.0, doc="viscous friction", low=0.0, note="none by default")
    transition_velocity: NumberLike = number("m/s", optional=True, doc="velocity of full friction", above=0.0)
    bristle_stiffness: NumberLike = number("N/m", optional=True, doc="bristle stiffness", above=0.0)
    bristle_damping: NumberLike = number("N s/m", optional=True, doc="bristle damping", low=0.0)


@dataclass(frozen=True)
class JointFriction:
    """Friction of a joint; which numbers count depends on its kind."""

    kind: str = option("viscous", *(k for k in KINDS if k != "viscous"), doc="law of friction")
    coulomb_torque: NumberLike = number("N m", optional=True, doc="Coulomb friction", low=0.0)
    static_torque: NumberLike = number("N m", optional=True, doc="break-away friction", low=0.0)
    stribeck_velocity: NumberLike = number("rad/s", 0.1, doc="Stribeck velocity", above=0.0)
    viscous_coefficient: NumberLike = number("N m s/rad", 0.0, doc="viscous friction", low=0.0, note="none by default")
    transition_velocity: NumberLike = number("rad/s", optional=True, doc="velocity of full friction", above=0.0)
    bristle_stiffness: NumberLike = number("N m/rad", optional=True, doc="bristle stiffness", above=0.0)
    bristle_damping: NumberLike = number("N m s/rad", optional=True, doc="bristle damping", low=0.0)


@dataclass(frozen=True)
class _Moving(Body):
    """What a mass and a joint share: one coordinate, its speed, friction and stops."""

    unit: ClassVar[str]  # of the position
    effort: ClassVar[str]  # "force" or "torque", and its unit
    effort_unit: ClassVar[str]
    inertia_name: ClassVar[str]
    presliding: ClassVar[float]

    resume: ClassVar[dict[str, str]] = {"position": "initial_position", "velocity": "initial_velocity"}

    if TYPE_CHECKING:  # fields of the subclasses
        friction: Any
        lower_stop: Any
        upper_stop: Any
        initial_position: Any

    def list_internal_outputs(self) -> tuple[str, ...]:
        return "acceleration", f"actuator_{self.effort}", f"stop_{self.effort}"

    @property
    def _law(self) -> str:
        return "none" if self.friction is None else str(self.friction.kind)

    def check(self) -> None:
        if self._law in ("stribeck", "lugre") and getattr(self.friction, f"coulomb_{self.effort}") is None:
            raise InputError("bodies.no_friction_force", f"friction.coulomb_{self.effort}", law=self._law)
        if self._law == "stribeck" and self.friction.transition_velocity is None:
            raise InputError("bodies.no_transition", "friction.transition_velocity")
        self._check_stops()

    def _check_stops(self) -> None:
        low, high = (None if s is None else float(s.position) for s in (self.lower_stop, self.upper_stop))
        if low is not None and high is not None and low >= high:
            shown = self.lower_stop.position.display(), self.upper_stop.position.display()
            raise InputError("parts.stops_exchanged", "lower_stop.position", shown=shown[0], upper=shown[1])
        start = float(self.initial_position)
        if (low is not None and start < low) or (high is not None and start > high):
            raise InputError("bodies.beyond_stop", "initial_position", value=start, low=low, high=high, unit=self.unit)

    def structure(self) -> Hashable:
        return super().structure(), self._law, self.lower_stop is not None, self.upper_stop is not None

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if self._law in ("stribeck", "lugre"):
            level = values[f"friction.coulomb_{self.effort}"]
            static = values.setdefault(f"friction.static_{self.effort}", level)
            if self._law == "lugre":
                # A level of zero has no stiffness; a hundredth of a newton moves nothing.
                stiffness = max(static, level, 1e-2) / self.presliding
                stiffness = values.setdefault("friction.bristle_stiffness", stiffness)
                values.setdefault("friction.bristle_damping", 2.0 * (stiffness * values[self.inertia_name]) ** 0.5)
        return values

    def states(self) -> tuple[State, ...]:
        # Usual sizes: a decimetre and a metre per second.
        result = [State("position", self.unit, 0.1, LOOSER, 0.1), State("velocity", f"{self.unit}/s", 1.0, LOOSER, 0.1)]
        if self._law == "lugre":
            result.append(State("deflection", self.unit, self.presliding, BRISTLES, 1.0))
        return tuple(result)

    def inputs(self) -> tuple[Input, ...]:
        return (Input(f"load_{self.effort}", self.effort_unit, f"load_{self.effort}"),)

    def start(self, scope: Scope) -> dict[str, Any]:
        values = {"position": scope["initial_position"], "velocity": scope["initial_velocity"], "deflection": 0.0}
        return {state.name: values[state.name] for state in self.states()}

    def _moved(self, scope: Scope, effort: Any, more_friction: Any, weight: Any) -> BodyDynamics:
        """Rates and outputs; `weight` is a constant effort towards smaller positions."""
        position, velocity, inertia = scope.states["position"], scope.states["velocity"], scope[self.inertia_name]
        rates: dict[str, Any] = {}
        rubbing = self._friction(scope, more_friction, rates)
        stopping = self._stops(scope)
        driving = effort - weight - scope.inputs[f"load_{self.effort}"]
        total = driving - rubbing + stopping
        rates |= {"position": velocity, "velocity": total / inertia}
        outputs: Quantities = {
            "position": (position, self.unit),
            "velocity": (velocity, f"{self.unit}/s"),
            "acceleration": (total / inertia, f"{self.unit}/s^2"),
            f"actuator_{self.effort}": (effort, self.effort_unit),
            f"friction_{self.effort}": (rubbing, self.effort_unit),
            f"stop_{self.effort}": (stopping, self.effort_unit),
        }
        if self._law == "lugre":
            limit = STICKS * scope["friction.stribeck_velocity"]
            way = where(velocity > 0.0, 1.0, -1.0)
            outputs["friction_state"] = (where(abs(velocity) > limit, way, 0.0), "1")
        # Apart, for what a balance may miss is measured by what went through it, and not by a small difference.
        powers = driving * velocity, (stopping - rubbing) * velocity
        return BodyDynamics(outputs, rates, 0.5 * inertia * velocity * velocity, powers)

    def _friction(self, scope: Scope, more: Any, rates: dict[str, Any]) -> Any:
        """Friction against the motion; adds the rate of the bristles."""
        velocity = scope.states["velocity"]
        if self._law == "none":
            return 0.0
        viscous = scope["friction.viscous_coefficient"] * velocity
        if self._law == "viscous":
            return viscous
        stribeck = scope["friction.stribeck_velocity"]
        # What seals under pressure add, they add to both levels.
        levels = (scope[f"friction.coulomb_{self.effort}"] + more, scope[f"friction.static_{self.effort}"] + more)
        if self._law == "stribeck":
            turning = scope["friction.transition_velocity"]
            return contact.stribeck_friction(velocity, *levels, stribeck, turning, 0.0) + viscous
        level = friction.sliding_level(velocity, *levels, stribeck) + 1e-9
        deflection, stiffness = scope.states["deflection"], scope["friction.bristle_stiffness"]
        rate = friction.bristle_rate(deflection, velocity, level, stiffness)
        rates["deflection"] = rate
        damping = scope["friction.bristle_damping"]
        return friction.lugre_force(deflection, rate, velocity, stiffness, damping, stribeck) + viscous

    def _stops(self, scope: Scope) -> Any:
        position, velocity = scope.states["position"], scope.states["velocity"]

        def held(name: str, sign: float) -> Any:
            if getattr(self, name) is None:
                return 0.0
            depth = sign * (position - scope[f"{name}.position"])
            return contact.stop_force(depth, sign * velocity, scope[f"{name}.stiffness"], scope[f"{name}.dissipation"])

        return held("lower_stop", -1.0) - held("upper_stop", 1.0)

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        position, velocity, force = (
            series(f"{name}.{each}") for each in ("position", "velocity", f"stop_{self.effort}")
        )
        stops = [math.nan if stop is None else float(stop.position) for stop in (self.lower_stop, self.upper_stop)]
        met = arrivals(series("time"), position, velocity, force, stops)
        return met_stop("velocity", f"{self.unit}/s", met)


def met_stop(address: str, unit: str, met: Sequence[tuple[float, float]]) -> tuple[Note, ...]:
    """The note on the hardest of several arrivals."""
    if not met:
        return ()
    time, velocity = max(met, key=lambda each: abs(each[1]))
    return (Note("bodies.met_stop", address, time=time, speed=abs(velocity), count=len(met), unit=unit),)


def arrivals(time: Any, position: Any, velocity: Any, force: Any, stops: Sequence[float]) -> list[tuple[float, float]]:
    """When and with which velocity each end stop is met, of the rows of a run; slow ones are a body that settles.

    Between the last row before and the stop the velocity is the parabola of the last three rows: a body that is braked
    does not meet its stop as fast as it was a row before.
    """
    found = []
    for k in np.flatnonzero((force[1:] != 0.0) & (force[:-1] == 0.0)).tolist():
        met = float(time[k]), float(velocity[k])
        gap = stops[int(met[1] > 0.0)] - float(position[k])
        if k > 1 and gap * met[1] > 0.0:
            # Plain floats: every run with a load comes by here.
            before = [(float(time[i]) - met[0], float(velocity[i])) for i in (k - 2, k - 1)]
            wait, speed = _wait_and_speed(before, met[1], gap)
            if 0.0 <= wait <= float(time[k + 1]) - met[0]:
                met = met[0] + wait, speed
        if abs(met[1]) > SLOW:
            found.append(met)
    return found


def _wait_and_speed(before: Sequence[tuple[float, float]], last: float, gap: float) -> tuple[float, float]:
    """How long it takes over a gap, and the velocity then, on the parabola through the last velocity and two before."""
    (t0, v0), (t1, v1) = before
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
class Mass(_Moving):
    r"""A body that moves on a line.

    .. math:: m \ddot x = \sum F - F_\mathrm{friction} + F_\mathrm{stop} - m g \sin\alpha - F_\mathrm{load}

    Parameters
    ----------
    mass : number
        Moving mass m, that of the piston included [kg].
    inclination : number
        Angle alpha by which larger positions lie higher: 90 degrees is straight up [rad].
    load_force : number
        Force towards smaller positions [N]; also an input.
    initial_position, initial_velocity : number
        Where it begins [m], [m/s].
    friction : group
        kind (`viscous`, `none`, `stribeck`, `lugre`) with coulomb_force, static_force, stribeck_velocity,
        viscous_coefficient; transition_velocity of `stribeck`; bristle_stiffness and bristle_damping of `lugre`.
    lower_stop, upper_stop : group
        End stops: position, stiffness, dissipation.

    Notes
    -----
    Only `lugre` sticks. `stribeck` has no force at rest, so that a body under less than the break-away force creeps at
    a speed of the order of its transition velocity, which has no default for that reason. Without a stiffness the
    bristles break away after 10 um; without a damping the stuck mass is critically damped.

    Examples
    --------
    >>> slide = Mass(mass="4 kg", friction={"kind": "lugre", "coulomb_force": "20 N", "static_force": "30 N"})
    >>> float(slide.friction.static_force)
    30.0
    """

    kind: ClassVar[str] = "mass"
    summary: ClassVar[str] = "a body on a line: friction, end stops, inclination"
    unit: ClassVar[str] = "m"
    effort: ClassVar[str] = "force"
    effort_unit: ClassVar[str] = "N"
    inertia_name: ClassVar[str] = "mass"
    presliding: ClassVar[float] = PRESLIDING

    mass: NumberLike = number("kg", doc="moving mass", above=0.0)
    inclination: NumberLike = number("rad", 0.0, doc="inclination", note="level by default")
    load_force: NumberLike = number("N", 0.0, doc="load force", note="none by default")
    initial_position: NumberLike = number("m", 0.0, doc="initial position", note="zero by default")
    initial_velocity: NumberLike = number("m/s", 0.0, doc="initial velocity", note="at rest")
    friction: Any = group(BodyFriction, doc="friction", optional=True)
    lower_stop: Any = group(BodyStop, doc="the end stop at small positions", optional=True)
    upper_stop: Any = group(BodyStop, doc="the end stop at large positions", optional=True)

    def initial_travel(self) -> float:
        return float(self.initial_position)  # type: ignore[arg-type]

    def motion(self, scope: Scope) -> BodyMotion:
        return BodyMotion(scope.states["position"], scope.states["velocity"])

    def dynamics(self, scope: Scope, force: Any, friction: Any) -> BodyDynamics:
        return self._moved(scope, force, friction, scope["mass"] * GRAVITY * sin(scope["inclination"]))


@dataclass(frozen=True)
class Joint(_Moving):
    r"""A body that turns, moved by actuators over a pulley.

    .. math:: J \ddot\varphi = r \sum F - M_\mathrm{friction} + M_\mathrm{stop} - M_\mathrm{load}

    Parameters
    ----------
    inertia : number
        Moment of inertia J [kg m^2].
    pulley_radius : number
        Radius r on which actuators act; their travel is r times the angle [m].
    load_torque : number
        Torque towards smaller angles [N m]; also an input.
    initial_position, initial_velocity : number
        Where it begins [rad], [rad/s].
    friction : group
        As that of a mass, with torques: coulomb_torque, static_torque.
    lower_stop, upper_stop : group
        End stops: position, stiffness, dissipation.

    Examples
    --------
    >>> elbow = Joint(inertia="0.02 kg m^2", pulley_radius="25 mm")
    >>> float(elbow.pulley_radius)
    0.025
    """

    kind: ClassVar[str] = "joint"
    summary: ClassVar[str] = "a body that turns: inertia, pulley, friction, end stops"
    unit: ClassVar[str] = "rad"
    effort: ClassVar[str] = "torque"
    effort_unit: ClassVar[str] = "N m"
    inertia_name: ClassVar[str] = "inertia"
    presliding: ClassVar[float] = PRESLIDING_ANGLE

    inertia: NumberLike = number("kg m^2", doc="moment of inertia", above=0.0)
    pulley_radius: NumberLike = number("m", doc="pulley radius", above=0.0)
    load_torque: NumberLike = number("N m", 0.0, doc="load torque", note="none by default")
    initial_position: NumberLike = number("rad", 0.0, doc="initial position", note="zero by default")
    initial_velocity: NumberLike = number("rad/s", 0.0, doc="initial velocity", note="at rest")
    friction: Any = group(JointFriction, doc="friction", optional=True)
    lower_stop: Any = group(JointStop, doc="the end stop at small angles", optional=True)
    upper_stop: Any = group(JointStop, doc="the end stop at large angles", optional=True)

    def initial_travel(self) -> float:
        return float(self.pulley_radius) * float(self.initial_position)  # type: ignore[arg-type]

    def motion(self, scope: Scope) -> BodyMotion:
        radius = scope["pulley_radius"]
        return BodyMotion(radius * scope.states["position"], radius * scope.states["velocity"])

    def dynamics(self, scope: Scope, force: Any, friction: Any) -> BodyDynamics:
        radius = scope["pulley_radius"]
        return self._moved(scope, radius * force, radius * friction, 0.0)


@dataclass(frozen=True)
class Guide(Body):
    """A body that is moved as its signal says, whatever the actuators do: a test bench for them.

    Parameters
    ----------
    position : number
        Position without a signal [m]; also an input, which only a signal may drive: points on straight lines or a sine.

    Examples
    --------
    >>> Guide(position="20 mm").inputs()[0].name
    'position'
    """

    kind: ClassVar[str] = "guide"
    summary: ClassVar[str] = "a body that is moved as a signal says"

    position: NumberLike = number("m", 0.0, doc="position", note="zero by default")

    def inputs(self) -> tuple[Input, ...]:
        return Input("position", "m", "position", by_signal=True), Input("velocity", "m/s", 0.0, slope_of="position")

    def initial_travel(self) -> float:
        return float(self.position)  # type: ignore[arg-type]

    def motion(self, scope: Scope) -> BodyMotion:
        return BodyMotion(scope.inputs["position"], scope.inputs["velocity"])

    def dynamics(self, scope: Scope, force: Any, friction: Any) -> BodyDynamics:
        # What holds it against its actuators.
        return BodyDynamics({"holding_force": (-force, "N")})
