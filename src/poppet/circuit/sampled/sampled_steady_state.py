"""Search for steady states of sampled circuits."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.linear_model import SteadyState
from poppet.circuit.newton import refine_steady_state, scaled_residual
from poppet.circuit.sampled.kinks import kink_notes
from poppet.circuit.sampled.point import SampledPoint
from poppet.circuit.sampled.sample_map import eigenvalues_of, phases_of, sample_map
from poppet.core.codes import Note
from poppet.core.errors import SimulationError
from poppet.engine.call import Call
from poppet.engine.problem import RawRun, constant_input_problem
from poppet.parts.part import NEVER

Array = NDArray[np.float64]

TRANSIENTS = (10.0, 100.0, 1000.0)
"""Durations of the successive transients [s]."""
TRANSIENT_TOLERANCE = 1e-7
MAX_ATTEMPTS = 3_000_000
ARRIVED = 1e-3
"""Distance to a steady state at which a transient has reached it, per size of the variable."""
SAME_STATE = 1e-6
SETTLING_TIME, OBSERVATION_TIME, ROWS = 20.0, 20.0, 40_001
"""Start of the evaluation of an oscillation [s], duration of the evaluation [s], and number of output times."""
RUN_TIME, RUNS = 1.0, 12
"""Minimum duration [s] and number of the transients in which running timers are searched."""
MIN_AMPLITUDE = 1e-9
"""Smallest amplitude that counts as an oscillation, relative to 1 plus the maximum of the series."""


def find_sampled_steady_state(instance: Instance, u: Array) -> SteadyState:
    """Return the steady state of a sampled circuit with constant inputs u."""
    point = SampledPoint(instance, u)
    v, *notes = _search_steady_state(point)
    if v is None:
        motion = _oscillation_note(point)
        # Timers, except clocks, that run at the end of one of several transients, or that a tick of the clocks sets.
        running: set[int] = set()
        timers = [k for k in range(point.places.size) if point.places[k] < point.model.n_timers]
        for k in range(RUNS if timers else 0):
            # At different phases of the sample, to find short events.
            end, _ = transient(point, RUN_TIME + k * 1.37 * point.clock.sample_time)
            updated, _, _ = point.instant(end, point.every_clock)
            running |= {int(point.places[j]) for j in timers if min(end[point.n + j], updated[j]) < NEVER}
        if not running:
            raise SimulationError(Note("rest.banded", motion=motion))
        names_of_timers = [point.model.memory[k][0] for k in sorted(running)]
        raise SimulationError(Note("rest.switched", motion=motion, timers=names_of_timers))
    is_stable = _is_stable(point, v)
    if not is_stable:
        notes.append(Note("rest.unstable", motion=_oscillation_note(point)))
    residual, _ = scaled_residual(point.scaled, v, point.size)
    names = (name for name, _ in point.model.memory)
    return SteadyState(
        v[: point.n],
        dict(zip(point.model.columns[0], point.between(v).outputs.tolist(), strict=True)),
        dict(zip(point.input_names, u.tolist(), strict=True)),
        float(np.max(residual, initial=0.0)),
        tuple(notes),
        dict(zip(names, point.all_discrete_states(v).tolist(), strict=True)),
        kink_notes(point, v),
        is_stable,
    )


def rest_near(point: SampledPoint, guess: Array) -> Array | None:
    """Return the steady state that Newton's method reaches from `guess`.

    The result is None if the method reaches none.
    """
    is_idle = (point.places < point.model.n_timers) & (guess[point.n :] > 0.5 * NEVER)
    start = guess.copy()
    # In a steady state no timer runs.
    start[point.n :][is_idle] = NEVER
    v = refine_steady_state(point.scaled, start, point.size, point.positive, conserves=False)
    return v if point.is_at_rest(v) else None


def _is_stable(point: SampledPoint, v: Array) -> bool:
    """Return True if small disturbances of a steady state v do not grow."""
    radius = float(np.max(np.abs(eigenvalues_of(sample_map(point, phases_of(point, v))[0])), initial=0.0))
    # Integrals and counters have eigenvalues of one with rounding errors.
    return radius <= 1.0 + SAME_STATE


def _search_steady_state(point: SampledPoint) -> tuple[Array, Note] | tuple[None]:
    """Return a steady state, and a note on the method by which it was found.

    If no steady state was found, the result contains only None.
    """
    previous: Array | None = None
    durations = list(TRANSIENTS)
    while durations:
        duration = durations.pop(0)
        end, run = transient(point, duration)
        v = rest_near(point, end)
        if v is not None:
            distance = np.max(np.abs(v - end) / point.size, initial=0.0)
            if distance <= ARRIVED:
                return v, Note("rest.settled", duration=duration)
            # Two transients with the same result confirm it, even if neither reaches it.
            if previous is not None and np.max(np.abs(v - previous) / point.size) <= SAME_STATE:
                return v, Note("rest.sought", duration=duration)
            if previous is None and not _is_stable(point, v):
                # No transient reaches an unstable state: a transient of twice the duration is enough to confirm it.
                durations.insert(0, 2.0 * duration)
        previous = v
        if not run.outcome.is_success:
            break
    return (None,)


def transient(point: SampledPoint, duration: float, grid: Array | None = None) -> tuple[Array, RawRun]:
    """Simulate a sampled circuit with constant inputs, starting from its initial state.

    The result contains the final variables v and the run. `grid` contains the output times [s]. By default, only the
    end is an output time.
    """
    x, p = point.first()
    times = np.array([duration]) if grid is None else grid
    limits = {"relative_tolerance": TRANSIENT_TOLERANCE, "most_attempts": MAX_ATTEMPTS}
    # `Call` instead of `solve`, because only `Call` returns the final discrete states.
    call = Call(constant_input_problem(point.kernel, p, x, point.u, times, **limits))
    run = call.run()
    return point.v(run.x, call.memory), run


def oscillation(time: Array, values: Array) -> tuple[float, float]:
    """Return the amplitude and the period of an oscillating series.

    The period is infinite if the series crosses its middle upwards fewer than two times.

    Notes
    -----
    An upward crossing of the middle counts if the series was a quarter of its range below it since the last crossing.
    Ripple on a slow oscillation therefore does not count.

    Examples
    --------
    >>> t = np.linspace(0.0, 10.0, 1001)
    >>> amplitude, period = oscillation(t, 3.0 + 2.0 * np.sin(2.0 * np.pi * t / 1.25))
    >>> round(amplitude, 3), round(period, 3)
    (2.0, 1.25)
    """
    low, high = float(np.min(values)), float(np.max(values))
    middle, amplitude = 0.5 * (low + high), 0.5 * (high - low)
    crossings: list[float] = []
    is_armed = False
    for value, next_value, t in zip(values[:-1], values[1:], time[1:], strict=True):
        is_armed = is_armed or value < middle - 0.5 * amplitude
        if is_armed and value < middle <= next_value:
            crossings.append(t - (time[1] - time[0]) * (next_value - middle) / (next_value - value))
            is_armed = False
    period = (crossings[-1] - crossings[0]) / (len(crossings) - 1) if len(crossings) > 1 else np.inf
    return amplitude, float(period)


def _oscillation_note(point: SampledPoint) -> Note:
    """Return a note on the largest oscillations that remain after a long transient."""
    time = np.linspace(SETTLING_TIME, SETTLING_TIME + OBSERVATION_TIME, ROWS)
    _, run = transient(point, SETTLING_TIME + OBSERVATION_TIME, time)
    if not run.outcome.is_success:
        return Note("rest.ends", time=run.reached, ending=Note(run.outcome.value))
    names, units = point.model.columns
    # Pressures, or all outputs of a circuit without pressures.
    rows = [k for k, unit in enumerate(units) if unit == "Pa"] or list(range(len(units)))
    swings = []
    for k in sorted(rows, key=lambda k: -float(np.ptp(run.values[k])))[:2]:
        amplitude, period = oscillation(time, run.values[k])
        if amplitude <= MIN_AMPLITUDE * (1.0 + float(np.max(np.abs(run.values[k])))):
            continue
        code, period = ("rest.swings", period) if np.isfinite(period) else ("rest.drifts", OBSERVATION_TIME)
        swings.append(Note(code, names[k], amplitude=amplitude, unit=units[k], period=period))
    return Note("rest.moves", swings=swings) if swings else Note("rest.unseen")
