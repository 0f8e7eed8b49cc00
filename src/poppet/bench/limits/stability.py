"""Stability of a valve, from poles of the linear model and runs of the nonlinear model."""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from poppet.bench.limits.limits_plan import LimitsPlan, spring_and_damping_changes
from poppet.bench.sine_rig import SineRig
from poppet.circuit.sampled.sampled_model import model_at
from poppet.circuit.sampled.sampled_steady_state import oscillation, rest_near
from poppet.core.codes import Note
from poppet.core.errors import SimulationError

Array = NDArray[np.float64]

PUSH = 5.0  # initial pressure deviation at the outlet [Pa]
WATCHED = 2.0  # duration of the run after the push [s]
ROWS_PER_SECOND = 4000
EARLY, LATE = (0.1, 0.5), (1.6, 2.0)  # time windows in which the motion is measured [s]
GROWN, DECAYED = 2.0, 0.8  # ratio of late to early amplitude that counts as growth, and as decay
LOUD, QUIET = 5.0, 0.05  # amplitude per push above which there is a limit cycle, and below which there is none
HUM = 25.0  # frequency above which a motion is one of the poppet and not of the controller [Hz]
CALM = (1.0, 4.0, 16.0, 64.0)  # factors on the damping for start values of the search for a steady state
ROUGH = 3.0  # duration of a run with controller bands [s]; the last two thirds are evaluated
UNKNOWN = complex(math.nan, math.nan)

OSCILLATES, DECAYS, MARGINAL = "oscillates", "decays", "marginal"


@dataclass(frozen=True)
class Stability:
    """Stability of a valve for one spring rate, one damping and one volume."""

    # Dominant pole of the linear model: the rightmost complex pole, or the rightmost pole if it is unstable [1/s].
    pole: complex
    is_stable: bool  # no eigenvalue outside the unit circle
    smooth: str  # motion of the nonlinear model without bands after a push: `oscillates`, `decays`, `marginal`
    smooth_amplitude: float  # amplitude of the outlet pressure late after the push [Pa]
    smooth_frequency: float  # frequency of this motion [Hz]
    amplitude: float  # amplitude of the outlet pressure with controller bands at constant setpoint [Pa]
    frequency: float  # frequency of the motion with controller bands [Hz]
    agrees: bool  # True if linear and nonlinear model without bands agree, or the motion is marginal
    note: Note | None = None

    @property
    def growth(self) -> float:
        """Growth rate of the dominant pole [1/s], negative if it decays."""
        return self.pole.real

    @property
    def pole_frequency(self) -> float:
        """Frequency of the dominant pole [Hz]."""
        return abs(self.pole.imag) / (2.0 * math.pi)

    @property
    def word(self) -> str:
        """Text of the note on this point. The text is empty if there is no note."""
        return "" if self.note is None else str(self.note)


def stability_point(plan: LimitsPlan, spring: float, damping: float, volume: float) -> Stability:
    """Compute poles and simulated motions for one spring rate, damping and volume.

    `spring` and `damping` are factors on the present values, and `volume` is the outlet volume [m^3].
    """
    changes = spring_and_damping_changes(plan, spring, damping)
    rough = math.nan, math.nan  # amplitude and frequency with the bands of the controller, at constant setpoint
    note = Note("limits.no_rest", points=None)
    with suppress(SimulationError):
        banded_rig = plan.rig(volume, changes)
        time = np.arange(1, int(ROUGH * ROWS_PER_SECOND) + 1) / ROWS_PER_SECOND
        run = banded_rig.run(0.0, 1.0, time)
        if run.outcome.is_success:
            rough = _detrended_oscillation(time, run.values[banded_rig.output], (ROUGH / 3.0, ROUGH))
    try:
        rig = plan.rig(volume, changes, bands=False)
        v: Array | None = None
        # The steady state does not depend on the damping: also search from the settled states with more damping.
        for factor in CALM:
            start = rig
            if factor != 1.0:
                start = plan.rig(volume, spring_and_damping_changes(plan, spring, damping * factor), bands=False)
            # After the parameters, the vector contains the discrete states; `v` selects those that are not clocks.
            v = rest_near(rig.point, start.point.v(start.x, start.p[start.point.numbers.size :]))
            if v is not None:
                break
    except SimulationError as error:
        v, note = None, error.note
    if v is None:
        return Stability(UNKNOWN, False, "", math.nan, math.nan, *rough, False, note)
    poles = model_at(rig.point, v).poles()
    pole = poles[np.argmax(poles.real)]
    is_stable = not pole.real > 0.0
    moving = poles[poles.imag > 0.0]
    if is_stable and moving.size:
        pole = moving[np.argmax(moving.real)]
    smooth, amplitude, frequency = _simulate_disturbance(rig, v)
    agrees = smooth == (DECAYS if is_stable else OSCILLATES) or smooth == MARGINAL
    # Differences between the linear model and the nonlinear model without and with the bands of the controller.
    finding: Note | None = None
    rough_amplitude, rough_frequency = rough
    if not agrees:
        linear = "stable" if is_stable else "unstable"
        finding = Note("limits.differs", linear=linear, full=smooth, push=PUSH, points=None)
    elif is_stable == (math.isfinite(rough_amplitude) and rough_amplitude > LOUD * PUSH):
        code = "held" if not is_stable else "hums" if rough_frequency >= HUM else "hunts"
        finding = Note(f"limits.{code}", points=None)
    return Stability(complex(pole), is_stable, smooth, amplitude, frequency, *rough, agrees, finding)


def _simulate_disturbance(rig: SineRig, v: Array) -> tuple[str, float, float]:
    """Simulate the motion after a small disturbance of the outlet pressure.

    The run starts from the steady state `v`. The result is the kind of motion (`oscillates`, `decays` or `marginal`),
    and its late amplitude [Pa] and frequency [Hz].
    """
    pushed = v.copy()
    pushed[rig.point.names.index(rig.kernel.model.columns[0][rig.output])] += PUSH
    time = np.arange(1, int(WATCHED * ROWS_PER_SECOND) + 1) / ROWS_PER_SECOND
    run = rig.from_state(pushed).run(0.0, 1.0, time)
    if not run.outcome.is_success:
        return OSCILLATES, math.nan, math.nan
    y = run.values[rig.output]
    early_amplitude, _ = _detrended_oscillation(time, y, EARLY)
    late_amplitude, frequency = _detrended_oscillation(time, y, LATE)
    if late_amplitude > LOUD * PUSH or late_amplitude > GROWN * early_amplitude > QUIET * PUSH:
        return OSCILLATES, late_amplitude, frequency
    is_decaying = late_amplitude < DECAYED * early_amplitude or late_amplitude < QUIET * PUSH
    return DECAYS if is_decaying else MARGINAL, late_amplitude, frequency


def _detrended_oscillation(time: Array, values: Array, part: tuple[float, float]) -> tuple[float, float]:
    """Return amplitude and frequency [Hz] of an oscillation without its linear trend.

    `part` contains the start and the end of the evaluated time window [s].
    """
    is_inside = (time > part[0]) & (time <= part[1])
    t, y = time[is_inside], values[is_inside]
    amplitude, period = oscillation(t, y - np.polyval(np.polyfit(t - t[0], y, 1), t - t[0]))
    return amplitude, 1.0 / period if math.isfinite(period) else math.nan
