"""Pneumatic muscle: gas in a volume that depends on the contraction, and the force on a body."""

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
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import NumberLike, anr_pressure, anr_temperature, body, group, number, option, reference
from poppet.parts.moving_gas import MovingGasStore
from poppet.parts.muscle_law import MuscleLawPart, braid_of
from poppet.parts.part import AMBIENT, SELF, Actuator, ActuatorForce, GasState, Quantities, Scope, State, Surroundings

MIN_VOLUME_FRACTION = 0.01
"""Fraction of the nominal volume that remains beyond the range of the muscle."""
ELEMENTS = 4
"""Elements of a Maxwell slip model; they slip after 1/4, 2/4, ... of the reach."""
CONTRACTION_TOLERANCE = 1e-9
"""Negative contraction that counts as rounding."""


@dataclass(frozen=True)
class Hysteresis:
    """Parameters of the hysteresis of a muscle force.

    The hysteresis force opposes the motion, and remains if the motion stops. It is the sum of a constant force and a
    force that is proportional to the gauge pressure.
    """

    kind: str = option("coulomb", "maxwell", doc="law of hysteresis")
    force: NumberLike = number("N", 0.0, doc="half the width of the loop", low=0.0, note="none by default")
    force_per_pressure: NumberLike = number(
        "N/Pa", 0.0, doc="half the width of the loop per gauge pressure", low=0.0, note="none by default"
    )
    reach: NumberLike = number("m", doc="travel over which the force reverses", above=0.0)


@dataclass(frozen=True)
class Limits:
    """Measured range of the force law, and limits stated by the manufacturer.

    A note reports if a run exceeds them.
    """

    lowest_contraction: NumberLike = number("1", optional=True, doc="lowest contraction")
    highest_contraction: NumberLike = number("1", optional=True, doc="highest contraction", below=1.0)
    lowest_pressure: NumberLike = number("Pa", optional=True, doc="lowest pressure", kind="pressure", low=0.0)
    highest_pressure: NumberLike = number("Pa", optional=True, doc="highest pressure", kind="pressure", above=0.0)
    highest_force: NumberLike = number("N", optional=True, doc="highest force", above=0.0)


@dataclass(frozen=True)
class Muscle(MuscleLawPart, MovingGasStore, Actuator):
    r"""Pneumatic muscle that pulls a body.

    .. math:: F = \left[p_g f_1(\varepsilon) + f_0(\varepsilon) - d\,\dot s - F_h\right]_+, \qquad
              \varepsilon = s/L_0,\quad s = \pm(x - x_0)

    .. math:: V = V_0 + L_0 \int_0^\varepsilon f_1\,d\varepsilon, \qquad
              \dot U = \sum c_p T q + h A (T_w - T) - p \dot V

    Notes
    -----
    F is the pulling force, limited to positive values, :math:`p_g` the gauge pressure, :math:`f_1` the force per gauge
    pressure, :math:`f_0` the force at zero gauge pressure, d the damping, :math:`F_h` the hysteresis, s the contraction
    distance and x the travel of the body.

    With the volume law `work`, the gas does the same work during a change of volume as the force :math:`p_g f_1` does
    on the body; :math:`f_0` acts as a spring. With `braid`, the volume is that of the cylinder that the threads
    enclose. A slack muscle has no force, but its volume still depends on the position of the body; a note then reports
    this. The default of `nominal_volume` is the volume of a cylinder, that of `wall_temperature` the ambient
    temperature.

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
    symbol: ClassVar[symbols.Symbol | str] = symbols.MUSCLE
    summary: ClassVar[str] = "a pneumatic muscle: gas in a volume that depends on its contraction, and its force"
    internal_outputs: ClassVar[tuple[str, ...]] = ("mass", "volume", "heat_flow_rate", "work_rate")

    body: str | None = body("body that it pulls")
    data: Any = reference(doc="name of a parameter set of the library")
    direction: NumberLike = number("1", 1.0, doc="direction, 1 or -1", note="pulls towards larger positions")
    offset: NumberLike = number("m", 0.0, doc="travel of the body at the nominal length", note="position zero")
    volume_law: str = option("work", "braid", doc="law of the volume")
    nominal_volume: NumberLike = number("m^3", optional=True, doc="volume at the nominal length", above=0.0)
    dead_volume: NumberLike = number("m^3", 0.0, doc="dead volume", low=0.0, note="none by default")
    damping: NumberLike = number("N s/m", 0.0, doc="damping of the contraction", low=0.0, note="none by default")
    hysteresis: Any = group(Hysteresis, doc="hysteresis", optional=True)
    slack_force: NumberLike = number(
        "N",
        1.0,
        doc="half the range of becoming slack; range of forces about zero",
        above=0.0,
        note="smooths the corner",
    )
    limits: Any = group(Limits, doc="range of the law")
    wall_conductance: NumberLike = number("W/K", 0.0, doc="wall conductance h A", low=0.0, note="adiabatic by default")
    wall_temperature: NumberLike = number("K", optional=True, doc="wall temperature", kind="temperature", above=0.0)
    initial_pressure: NumberLike = anr_pressure("initial pressure")
    initial_temperature: NumberLike = anr_temperature("initial temperature")

    def check(self) -> None:
        if abs(float(self.direction)) != 1.0:  # type: ignore[arg-type]
            raise InputError("bodies.direction", "direction", value=float(self.direction))  # type: ignore[arg-type]
        super().check()
        if self.volume_law == "braid" and self.braid_angle is None:
            raise InputError("muscle.law_needs", "braid_angle", choice="volume_law", value="braid")

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        towards = "larger" if float(self.direction) > 0.0 else "smaller"  # type: ignore[arg-type]
        size = f"{numbers.text(self.nominal_diameter)}, length {numbers.text(self.nominal_length)}"
        return [f"muscle, {self.data or self.law}", size, f"pulls towards {towards} positions"]

    def structure(self) -> Hashable:
        return super().structure(), None if self.hysteresis is None else self.hysteresis.kind

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = {"wall_temperature": ambient.temperature, **super().parameters(ambient)}
        cylinder = 0.25 * math.pi * values["nominal_diameter"] ** 2 * values["nominal_length"]
        values.setdefault("nominal_volume", cylinder)
        return values

    def states(self) -> tuple[State, ...]:
        slips = {None: 0, "coulomb": 1, "maxwell": ELEMENTS}[self.hysteresis and self.hysteresis.kind]
        # An error of 0.1 % of the force is smaller than the uncertainty of hysteresis data.
        return (*super().states(), *(State(f"slip_{k}", "1", 1.0, 300.0, 1.0) for k in range(1, slips + 1)))

    def start(self, scope: Scope) -> dict[str, Any]:
        return {**dict.fromkeys((state.name for state in self.states()), 0.0), **super().start(scope)}

    def check_start(self, travel: float) -> None:
        direction, offset, length = (float(n) for n in (self.direction, self.offset, self.nominal_length))  # type: ignore[arg-type]
        contraction = direction * (travel - offset) / length
        if contraction < -CONTRACTION_TOLERANCE:
            raise InputError("muscle.stretched", "offset", excess=-contraction * length, value=offset)

    def _contraction(self, scope: Scope) -> Any:
        return scope["direction"] * (scope.body.position - scope["offset"]) / scope["nominal_length"]

    def volume_and_area(self, scope: Scope) -> tuple[Any, Any]:
        contraction = self._contraction(scope)
        law = braid_of(scope.numbers) if self.volume_law == "braid" else self.force_law(scope.numbers)
        nominal = scope["nominal_volume"]
        volume, smallest = nominal + scope["nominal_length"] * law.swept(contraction), MIN_VOLUME_FRACTION * nominal
        area = where(volume > smallest, law.slope(contraction), 0.0)
        return scope["dead_volume"] + maximum(volume, smallest), area

    # Gas and force --------------------------------------------------------------------------------------------------

    def actuator_force(self, scope: Scope, gas: Mapping[str, GasState]) -> ActuatorForce:
        pressure, contraction = gas[SELF].pressure - scope.surroundings.pressure, self._contraction(scope)
        speed, rates = scope["direction"] * scope.body.velocity, dict[str, Any]()
        static = self.force_law(scope.numbers).force(pressure, contraction)
        resistance = scope["damping"] * speed
        if self.hysteresis is not None:
            # Rates of the elements of the Maxwell slip model, and their force against the contraction.
            slips = [state.name for state in self.states()[len(super().states()) :]]
            reach, level = scope["hysteresis.reach"], scope["hysteresis.force"]
            for k, name in enumerate(slips, 1):
                slip = scope.states[name]
                if self.hysteresis.kind == "coulomb":
                    rates[name] = bristle_rate(slip, speed / reach, 1.0, 1.0)
                else:
                    rates[name] = slip_rate(slip, speed, reach * k / len(slips))
            level = level + scope["hysteresis.force_per_pressure"] * maximum(pressure, 0.0)
            resistance = resistance + level * sum(scope.states[name] for name in slips) / len(slips)
        force = taut(static - resistance, scope["slack_force"])
        outputs: Quantities = {"contraction": (contraction, "1"), "force": (force, "N")}
        # Elastic forces, damping and hysteresis; with the volume law `braid` also its deviation from the force law.
        inside = pressure * self.volume_and_area(scope)[1] * speed - force * speed
        return ActuatorForce(scope["direction"] * force, outputs, rates, losses={"inside": inside})

    # Notes on runs --------------------------------------------------------------------------------------------------

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        time, ambient = series("time"), float(series(f"{AMBIENT}.pressure")[0])
        notes = []

        def limit(field: str, sign: float) -> float:
            number = getattr(self.limits, field) if field else None
            return sign * math.inf if number is None else float(number.absolute(ambient))

        for output, unit, lowest, highest in (
            ("contraction", "1", "lowest_contraction", "highest_contraction"),
            ("pressure", "Pa", "lowest_pressure", "highest_pressure"),
            ("force", "N", "", "highest_force"),
        ):
            low, high = limit(lowest, -1.0), limit(highest, 1.0)
            values = series(f"{name}.{output}")
            rows_outside = np.flatnonzero((values < low) | (values > high))
            if rows_outside.size:
                excess = np.maximum(low - values, values - high)
                worst, first = float(values[np.argmax(excess)]), float(time[rows_outside[0]])
                facts = {"time": first, "worst": worst, "limit": low if worst < low else high, "unit": unit}
                notes.append(Note("muscle.beyond", output, **facts))
        slack = np.flatnonzero(series(f"{name}.force") <= 0.0)
        if slack.size:
            notes.append(Note("muscle.slack", "force", time=float(time[slack[0]]), rows=int(slack.size)))
        return tuple(notes)
