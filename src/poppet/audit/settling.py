"""Exhaust times and travels from densely sampled outputs of a run after an event."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from poppet.timeseries.checks import FloatArray

FINEST_STEP, COARSEST_STEP = 1e-4, 5e-3
"""Shortest and longest time between the samples [s]."""
RELATIVE_STEP = 1e-3
"""Ratio of the time between samples to the time since the event, within the limits of the time between samples."""
STANDSTILL = 1e-4
"""Travel during the last tenth of a run below which a body stands still [m] or [rad]."""


class Motion(NamedTuple):
    """Motion of a body from the event to the end of the run."""

    path: float  # length of the path [m] or [rad]
    net: float  # final position minus the first [m] or [rad]
    farthest: float  # largest distance from the first position [m] or [rad]
    stop_time: float  # time until the body remains at its final position [s]; infinite if it still moves


def sample_times(duration: float) -> FloatArray:
    """Return the times after the event at which outputs are sampled [s].

    They depend on the duration only, not on the output step of the circuit. The first time is 0.
    """
    first, last = FINEST_STEP / RELATIVE_STEP, COARSEST_STEP / RELATIVE_STEP
    fine = np.arange(round(first / FINEST_STEP)) * FINEST_STEP
    middle = first * (1.0 + RELATIVE_STEP) ** np.arange(math.ceil(math.log(last / first) / math.log1p(RELATIVE_STEP)))
    coarse = np.arange(last, max(duration, last) + COARSEST_STEP, COARSEST_STEP)
    times = np.concatenate([fine, middle[middle < last], coarse])
    return np.append(times[times < duration * (1.0 - 1e-9)], duration)


def time_below(time: FloatArray, excess: FloatArray) -> float:
    """Return the time from which a value remains at or below 0.

    Between two samples, the value is a cubic polynomial through four of them. The result is 0 if no sample is above 0,
    and infinite if the last sample is.

    Examples
    --------
    >>> time = np.linspace(0.0, 5.0, 501)
    >>> round(time_below(time, np.exp(-time) - 0.5), 7)
    0.6931472
    """
    high_rows = np.flatnonzero(excess > 0.0)
    if not high_rows.size:
        return 0.0
    last = int(high_rows[-1])
    if last == time.size - 1:
        return math.inf
    first = min(max(last - 1, 0), max(time.size - 4, 0))
    t, differences = time[first : first + 4].tolist(), excess[first : first + 4].tolist()
    # Newton's form of the cubic.
    for order in range(1, len(t)):
        for k in range(len(t) - 1, order - 1, -1):
            differences[k] = (differences[k] - differences[k - 1]) / (t[k] - t[k - order])
    low, high = float(time[last]), float(time[last + 1])
    # Bisection: the cubic has the signs of the samples at both ends.
    for _ in range(60):
        middle, value = 0.5 * (low + high), 0.0
        for node, difference in zip(reversed(t), reversed(differences), strict=True):
            value = value * (middle - node) + difference
        low, high = (middle, high) if value > 0.0 else (low, middle)
    return high


def motion_of(time: FloatArray, position: FloatArray, velocity: FloatArray) -> Motion:
    """Return the path, the final distance, the largest distance and the stop time of a body.

    Between two samples, the position is the cubic polynomial with the velocities of the samples, so that the path
    includes returns between them.

    Examples
    --------
    >>> time = np.linspace(0.0, 2.0 * np.pi, 201)
    >>> motion = motion_of(time, np.sin(time), np.cos(time))
    >>> round(motion.path, 6), round(motion.farthest, 6), motion.stop_time
    (4.0, 1.0, inf)
    """
    h, start, end = np.diff(time), position[:-1], position[1:]
    # Cubic x(s) = start + b s + c s^2 + d s^3 for s from 0 to 1. If the velocity changes its sign, it turns once.
    b, v = h * velocity[:-1], h * velocity[1:]
    c, d = 3.0 * (end - start) - 2.0 * b - v, b + v - 2.0 * (end - start)
    root = np.sqrt(np.maximum(c * c - 3.0 * b * d, 0.0))
    q = -(c + np.where(c >= 0.0, root, -root))  # stable for small d
    with np.errstate(divide="ignore", invalid="ignore"):
        first, second = b / q, q / (3.0 * d)
    s = np.where(b * v < 0.0, np.where((first > 0.0) & (first < 1.0), first, second), 0.0)
    turn = start + s * (b + s * (c + s * d))
    steps = np.abs(turn - start) + np.abs(end - turn)
    path, origin, last = float(steps.sum()), float(position[0]), float(position[-1])
    farthest = float(np.abs(np.concatenate([position, turn]) - origin).max())
    tail = time[1:] > time[-1] - 0.1 * (time[-1] - time[0])
    if steps[tail].sum() > STANDSTILL:
        return Motion(path, last - origin, farthest, math.inf)
    away = np.flatnonzero(np.abs(position - last) > STANDSTILL)
    stop = float(time[away[-1] + 1] - time[0]) if away.size else 0.0
    return Motion(path, last - origin, farthest, stop)
