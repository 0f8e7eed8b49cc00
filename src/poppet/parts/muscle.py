"""A pneumatic muscle: gas in a volume that follows the contraction, and the force with which it pulls."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.symbolic import maximum, where
from poppet.laws.physics.friction import bristle_rate
from poppet.laws.physics.muscle import slip_rate, taut
from poppet.parts import moving_gas
from poppet.parts.fields import (
    NumberLike,
    anr_pressure,
    anr_temperature,
    body,
    group,
    number,
    option,
    reference,
)
from poppet.parts.muscle_law import MuscleLawPart, braid_of
from poppet.parts.part import (
    AMBIENT,
    SELF,
    Actuator,
    ActuatorForce,
    GasBalance,
    GasState,
    Scope,
    State,
    Store,
    Surroundings,
)

LEAST_LEFT = 0.01
"""Part of the nominal volume that remains however far a body is moved beyond what the muscle can do."""
ELEMENTS = 4
"""Elements of a Maxwell slip model; they slip after 1/4, 2/4, ... of the way given."""
STRETCHED = 1e-9
"""Contraction below zero that is rounding."""


@dataclass(frozen=True)
class Hysteresis:
    """Force against the motion that stays when it stops: of threads on hose, of a force and a part of the pressure."""

    kind: str = option("coulomb", "maxwell", doc="law of hysteresis")
    force: NumberLike = number("N", 0.0, doc="half the width of the loop", low=0.0, note="none by default")
    force_per_pressure: NumberLike = number(
        "N/Pa", 0.0, doc="half the width of the loop per gauge pressure", low=0.0, note="none by default"
    )
    reach: NumberLike = number("m", doc="way over which the force turns round", above=0.0)


@dataclass(frozen=True)
class Limits:
    """Where the law was measured, and what the maker allows."""

    lowest_contraction: NumberLike = number("1", optional=True, doc="lowest contraction")
    highest_contraction: NumberLike = number("1", optional=True, doc="highest contraction", below=1.0)
    lowest_pressure: NumberLike = number("Pa", optional=True, doc="lowest pressure", kind="pressure", low=0.0)
    highest_pressure: NumberLike = number("Pa", optional=True, doc="highest pressure", kind="pressure", above=0.0)
    highest_force: NumberLike = number("N", optional=True, doc="highest force", above=0.0)


@dataclass(frozen=True)
class Muscle(MuscleLawPart, Store, Actuator):
    r"""A pneumatic muscle that pulls a body.

    .. math:: F = \left[p_g f_1(\varepsilon) + f_0(\varepsilon) - d\,\dot s - F_h\right]_+, \qquad
              \varepsilon = s/L_0,\quad s = \pm(x - x_0)

    .. math:: V = V_0 + L_0 \int_0^\varepsilon f_1\,d\varepsilon, \qquad
              \dot U = \sum c_p T q + h A (T_w - T) - p \dot V

    Parameters
    ----------
    body : str
        The mass, joint or guide that it pulls.
    data : str
        Library set, `dmsp_20_300`.
    direction : number
        1: pulls towards larger positions of the body; -1: towards smaller ones.
    offset : number
        Travel of the body at which the muscle has its nominal length [m].
    nominal_length, nominal_diameter : number
        Length and inner diameter without pressure and load [m].
    law : str
        `sarosi` (default), `chou_hannaford`, `tondu_lopez` or `table`.
    sarosi : group
        Numbers of Sarosi's law: a1 ... a6.
    braid_angle : number
        Angle between thread and axis at the nominal length [rad].
    end_factor : number
        k of Tondu and Lopez [1].
    force_table : mapping
        Measured lines of force over pressure: lists `contraction`, `force_per_pressure`, `passive_force`.
    volume_law : str
        `work` (default): the volume whose growth does the work of the law's force; `braid`: that of the threads.
    nominal_volume : number
        Volume of the gas at the nominal length; default that of a cylinder [m^3].
    dead_volume : number
        Volume of fittings and lines that does not change [m^3].
    damping : number
        Force per speed of contraction [N s/m].
    hysteresis : group
        Force against the motion: kind (`coulomb`, `maxwell`), force, force_per_pressure, reach.
    slack_force : number
        Half the zone of force in which the muscle goes slack [N].
    limits : group
        Where the law holds: lowest_contraction, highest_contraction, lowest_pressure, highest_pressure,
        highest_force.
    wall_conductance, wall_temperature : number
        Heat transfer h A between gas and wall [W/K], and the wall's temperature, default the ambient one [K].
    initial_pressure, initial_temperature : number
        Absolute pressure [Pa] and temperature [K] at the start.

    Notes
    -----
    With `work` the law takes out of the gas what it gives to the body, apart from damping and hysteresis, and apart
    from the passive force, which is a spring. A slack muscle hangs loose: its force is zero, its volume still that of
    the body's position, and a note says so.

    References
    ----------
    Chou & Hannaford 1996, IEEE Trans. Robotics and Automation 12, 90-102, equation (1), for the volume.

    Examples
    --------
    >>> muscle = Muscle(body="slide", data="dmsp_20_300", direction=-1)
    >>> round(muscle.force_law().force(5e5, 0.1))
    595
    >>> round(muscle.pressure_for(595.0, 0.1), -3)
    500000.0
    """

    kind: ClassVar[str] = "muscle"
    summary: ClassVar[str] = "a pneumatic muscle: gas in a volume that follows its contraction, and its pull"
    internal_outputs: ClassVar[tuple[str, ...]] = ("mass", "volume", "heat_flow_rate", "work_rate")

    body: str | None = body("the body that it pulls")
    data: Any = reference(doc="library set")
    direction: NumberLike = number("1", 1.0, doc="direction, 1 or -1", note="pulls towards larger positions")
    offset: NumberLike = number("m", 0.0, doc="travel at the nominal length", note="position zero")
    volume_law: str = option("work", "braid", doc="law of the volume")
    nominal_volume: NumberLike = number("m^3", optional=True, doc="volume at the nominal length", above=0.0)
    dead_volume: NumberLike = number("m^3", 0.0, doc="dead volume", low=0.0, note="none by default")
    damping: NumberLike = number("N s/m", 0.0, doc="damping", low=0.0, note="none by default")
    hysteresis: Any = group(Hysteresis, doc="hysteresis", optional=True)
    slack_force: NumberLike = number("N", 1.0, doc="half the zone of going slack", above=0.0, note="smooths the corner")
    limits: Any = group(Limits, doc="where the law holds")
    wall_conductance: NumberLike = number("W/K", 0.0, doc="wall conductance h A", low=0.0, note="adiabatic by default")
    wall_temperature: NumberLike = number("K", optional=True, doc="wall temperature", kind="temperature", above=0.0)
    initial_pressure: NumberLike = anr_pressure("initial pressure")
    initial_temperature: NumberLike = anr_temperature("initial temperature")

    resume: ClassVar[dict[str, str]] = {"pressure": "initial_pressure", "temperature": "initial_temperature"}

    def check(self) -> None:
        if abs(float(self.direction)) != 1.0:  # type: ignore[arg-type]
            raise InputError("bodies.direction", "direction", value=float(self.direction))  # type: ignore[arg-type]
        super().check()
        if self.volume_law == "braid" and self.braid_angle is None:
            raise InputError("muscle.law_needs", "braid_angle", choice="volume_law", value="braid")

    def structure(self) -> Hashable:
        return super().structure(), None if self.hysteresis is None else self.hysteresis.kind

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = {"wall_temperature": ambient.temperature, **super().parameters(ambient)}
        cylinder = 0.25 * math.pi * values["nominal_diameter"] ** 2 * values["nominal_length"]
        values.setdefault("nominal_volume", cylinder)
        return values

    def states(self) -> tuple[State, ...]:
        slips = {None: 0, "coulomb": 1, "maxwell": ELEMENTS}[self.hysteresis and self.hysteresis.kind]
        # A tenth of a per cent of the force is enough of what nobody knows better.
        return (*moving_gas.STATES, *(State(f"slip_{k}", "1", 1.0, 300.0, 1.0) for k in range(1, slips + 1)))

    def start(self, scope: Scope) -> dict[str, Any]:
        begun = moving_gas.begun(scope, self._volume(scope)[0])
        return {**dict.fromkeys((state.name for state in self.states()), 0.0), **begun}

    def check_start(self, travel: float) -> None:
        direction, offset, length = (float(each) for each in (self.direction, self.offset, self.nominal_length))  # type: ignore[arg-type]
        contraction = direction * (travel - offset) / length
        if contraction < -STRETCHED:
            raise InputError("muscle.stretched", "offset", excess=-contraction * length, value=offset)

    def _contraction(self, scope: Scope) -> Any:
        return scope["direction"] * (scope.body.position - scope["offset"]) / scope["nominal_length"]

    def _volume(self, scope: Scope) -> tuple[Any, Any]:
        """Volume, and the area by which it grows with the way of contraction."""
        contraction = self._contraction(scope)
        law = braid_of(scope.numbers) if self.volume_law == "braid" else self.force_law(scope.numbers)
        still = scope["nominal_volume"]
        inner, least = still + scope["nominal_length"] * law.swept(contraction), LEAST_LEFT * still
        area = where(inner > least, law.slope(contraction), 0.0)
        return scope["dead_volume"] + maximum(inner, least), area

    # Gas and force --------------------------------------------------------------------------------------------------

    def gas(self, scope: Scope) -> GasState:
        return moving_gas.state_of(scope, self._volume(scope)[0])

    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        volume, area = self._volume(scope)
        growth = area * scope["direction"] * scope.body.velocity
        return moving_gas.balance(scope, self.gas(scope), volume, growth, flows)

    def actuator_force(self, scope: Scope, gas: Mapping[str, GasState]) -> ActuatorForce:
        pressure, contraction = gas[SELF].pressure - scope.surroundings.pressure, self._contraction(scope)
        speed, rates = scope["direction"] * scope.body.velocity, dict[str, Any]()
        static = self.force_law(scope.numbers).force(pressure, contraction)
        held = scope["damping"] * speed + self._hysteresis(scope, pressure, speed, rates)
        force = taut(static - held, scope["slack_force"])
        return ActuatorForce(
            scope["direction"] * force, {"contraction": (contraction, "1"), "force": (force, "N")}, rates
        )

    def _hysteresis(self, scope: Scope, pressure: Any, speed: Any, rates: dict[str, Any]) -> Any:
        """Force against the contraction; adds the rates of its elements."""
        if self.hysteresis is None:
            return 0.0
        slips = [state.name for state in self.states()[len(moving_gas.STATES) :]]
        reach, level = scope["hysteresis.reach"], scope["hysteresis.force"]
        for k, name in enumerate(slips, 1):
            slip = scope.states[name]
            if self.hysteresis.kind == "coulomb":
                rates[name] = bristle_rate(slip, speed / reach, 1.0, 1.0)
            else:
                rates[name] = slip_rate(slip, speed, reach * k / len(slips))
        level = level + scope["hysteresis.force_per_pressure"] * maximum(pressure, 0.0)
        return level * sum(scope.states[name] for name in slips) / len(slips)

    # What a run has to say ------------------------------------------------------------------------------------------

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        time, ambient = series("time"), float(series(f"{AMBIENT}.pressure")[0])
        found = []
        for output, unit, lowest, highest in (
            ("contraction", "1", "lowest_contraction", "highest_contraction"),
            ("pressure", "Pa", "lowest_pressure", "highest_pressure"),
            ("force", "N", None, "highest_force"),
        ):
            low, high = (_limit(self.limits, each, ambient, end) for each, end in ((lowest, -1.0), (highest, 1.0)))
            values = series(f"{name}.{output}")
            beyond = np.flatnonzero((values < low) | (values > high))
            if beyond.size:
                excess = np.maximum(low - values, values - high)
                worst, first = float(values[np.argmax(excess)]), float(time[beyond[0]])
                facts = {"time": first, "worst": worst, "limit": low if worst < low else high, "unit": unit}
                found.append(Note("muscle.beyond", output, **facts))
        loose = np.flatnonzero(series(f"{name}.force") <= 0.0)
        if loose.size:
            found.append(Note("muscle.slack", "force", time=float(time[loose[0]]), rows=int(loose.size)))
        return tuple(found)


def _limit(limits: Any, name: str | None, ambient: float, end: float) -> float:
    """A limit in SI, absolute; infinite where there is none."""
    given = None if name is None else getattr(limits, name)
    return end * math.inf if given is None else float(given.absolute(ambient))
