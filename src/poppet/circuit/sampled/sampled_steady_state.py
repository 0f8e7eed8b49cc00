"""States at rest of circuits with sampled memory."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.linear_model import SteadyState
from poppet.circuit.newton import polished, residual_of
from poppet.circuit.sampled.kinks import kinks
from poppet.circuit.sampled.point import SampledPoint
from poppet.circuit.sampled.sample_map import eigenvalues_of, phases_of, sample_map
from poppet.core.codes import Note
from poppet.core.errors import SimulationError
from poppet.engine.call import Call
from poppet.engine.problem import RawRun, held_problem
from poppet.parts.part import NEVER

Array = NDArray[np.float64]

TRANSIENTS = (10.0, 100.0, 1000.0)
"""Lengths of transient tried one after the other [s]."""
TRANSIENT_TOLERANCE = 1e-7
MOST_ATTEMPTS = 3_000_000
ARRIVED = 1e-3
"""Distance per size within which the end of a transient belongs to a rest."""
SAME_REST = 1e-6
SETTLED, WATCHED, ROWS = 20.0, 20.0, 40_001
"""Time left to a circuit to come to its oscillation [s], time for which that is watched [s], and rows of it."""
LOOKED, LOOKS = 1.0, 12
"""Length of runs whose ends are searched for timers under way [s], and how many."""
NOTHING = 1e-9
"""Swing per size below which nothing oscillates."""


def sampled_steady_state(instance: Instance, u: Array) -> SteadyState:
    """The state at rest of a circuit with memory."""
    point = SampledPoint(instance, u)
    v, *found = _found(point)
    if v is None:
        raise SimulationError(_restless(point))
    is_stable = _is_stable(point, v)
    if not is_stable:
        found.append(Note("rest.unstable", motion=_motion(point)))
    residual, _ = residual_of(point.scaled, v, point.size)
    names = (name for name, _ in point.model.memory)
    return SteadyState(
        v[: point.n],
        dict(zip(point.model.columns[0], point.between(v).outputs.tolist(), strict=True)),
        dict(zip(point.input_names, u.tolist(), strict=True)),
        float(np.max(residual, initial=0.0)),
        tuple(found),
        dict(zip(names, point.remembered(v).tolist(), strict=True)),
        kinks(point, v),
        is_stable,
    )


def rest_near(point: SampledPoint, guess: Array) -> Array | None:
    """The rest to which Newton's method leads from a guess, without any run."""
    waiting = (point.places < point.model.n_timers) & (guess[point.n :] > 0.5 * NEVER)
    begin = guess.copy()
    # At a rest nothing is under way; a timer left at some time would be a rate of its own.
    begin[point.n :][waiting] = NEVER
    v = polished(point.scaled, begin, point.size, point.positive, conserves=False)
    return v if point.is_at_rest(v) else None


def _is_stable(point: SampledPoint, v: Array) -> bool:
    """True when what moves a little at a rest does not move more and more."""
    radius = float(np.max(np.abs(eigenvalues_of(sample_map(point, phases_of(point, v))[0])), initial=0.0))
    # Integrals and counters have eigenvalues of one, but for rounding.
    return radius <= 1.0 + SAME_REST


def _found(point: SampledPoint) -> tuple[Array, Note] | tuple[None]:
    """A rest and how it was found, or None."""
    before: Array | None = None
    durations = list(TRANSIENTS)
    while durations:
        duration = durations.pop(0)
        end, run = transient(point, duration)
        v = rest_near(point, end)
        if v is not None:
            distance = np.max(np.abs(v - end) / point.size, initial=0.0)
            if distance <= ARRIVED:
                return v, Note("rest.settled", duration=duration)
            # Where two transients lead to the same rest, it is no matter that neither has arrived.
            if before is not None and np.max(np.abs(v - before) / point.size) <= SAME_REST:
                return v, Note("rest.sought", duration=duration)
            if before is None and not _is_stable(point, v):
                # No run arrives at a rest that pushes away; twice as long confirms it as well as ten times as long.
                durations.insert(0, 2.0 * duration)
        before = v
        if not run.outcome.is_success:
            break
    return (None,)


def transient(point: SampledPoint, duration: float, grid: Array | None = None) -> tuple[Array, RawRun]:
    """Run a circuit from its start with held inputs."""
    x, p = point.first()
    times = np.array([duration]) if grid is None else grid
    limits = {"relative_tolerance": TRANSIENT_TOLERANCE, "most_attempts": MOST_ATTEMPTS}
    # A call, not `solve`: the memory at the end is wanted, which no other solver hands back.
    call = Call(held_problem(point.kernel, p, x, point.u, times, **limits))
    run = call.made()
    return point.v(run.x, call.memory), run


def oscillation(time: Array, values: Array) -> tuple[float, float]:
    """Amplitude and period of a series that goes up and down.

    Notes
    -----
    A crossing counts once the series has been a quarter of the range below the middle, so that ripple on a slow
    oscillation is not taken for it.

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
    for before, after, at in zip(values[:-1], values[1:], time[1:], strict=True):
        is_armed = is_armed or before < middle - 0.5 * amplitude
        if is_armed and before < middle <= after:
            crossings.append(at - (time[1] - time[0]) * (after - middle) / (after - before))
            is_armed = False
    period = (crossings[-1] - crossings[0]) / (len(crossings) - 1) if len(crossings) > 1 else np.inf
    return amplitude, float(period)


def _motion(point: SampledPoint) -> Note:
    """What moves most at the end of a transient."""
    time = np.linspace(SETTLED, SETTLED + WATCHED, ROWS)
    _, run = transient(point, SETTLED + WATCHED, time)
    if not run.outcome.is_success:
        return Note("rest.ends", time=run.reached, ending=Note(run.outcome.value))
    names, units = point.model.columns
    # Pressures say most; in a circuit without any, whatever moves.
    rows = [k for k, unit in enumerate(units) if unit == "Pa"] or list(range(len(units)))
    swings = []
    for k in sorted(rows, key=lambda k: -float(np.ptp(run.values[k])))[:2]:
        amplitude, period = oscillation(time, run.values[k])
        if amplitude <= NOTHING * (1.0 + float(np.max(np.abs(run.values[k])))):
            continue
        code, lasts = ("rest.swings", period) if np.isfinite(period) else ("rest.drifts", WATCHED)
        swings.append(Note(code, names[k], amplitude=amplitude, unit=units[k], period=lasts))
    return Note("rest.moves", swings=swings) if swings else Note("rest.unseen")


def _restless(point: SampledPoint) -> Note:
    motion, timers = _motion(point), _switching(point)
    return Note("rest.switched", motion=motion, timers=timers) if timers else Note("rest.banded", motion=motion)


def _switching(point: SampledPoint) -> list[str]:
    """Timers beside the clocks that are under way at one time or another, or that a tick sets."""
    found: set[int] = set()
    timers = [k for k in range(point.places.size) if point.places[k] < point.model.n_timers]
    for k in range(LOOKS if timers else 0):
        # Not a whole number of samples apart, so that something short is met as well.
        end, _ = transient(point, LOOKED + k * 1.37 * point.clock.sample_time)
        after, _, _ = point.instant(end, point.every_clock)
        found |= {int(point.places[j]) for j in timers if min(end[point.n + j], after[j]) < NEVER}
    return [point.model.memory[k][0] for k in sorted(found)]
