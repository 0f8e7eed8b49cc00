"""Parts of a series: branches of a sweep, stairs and jumps; local values of a sampled curve."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from poppet.bench.iso10094.scale import FloatArray

_CLEAR = 6.0
"""Limit of the noise in a recording, in standard deviations."""
_FLAT = 0.3
"""Change within stairs relative to the change between them, above which a series is not a staircase."""
_STILL = 1e-6
"""Setpoint change between samples that counts as constant [% FS]."""


@dataclass(frozen=True)
class Branch:
    """Samples `first` to `end - 1` between two turning points; `sign` is +1 up, -1 down."""

    first: int
    end: int
    sign: int

    @property
    def samples(self) -> slice:
        """Slice of the samples."""
        return slice(self.first, self.end)


def branches(values: FloatArray, swing: float) -> list[Branch]:
    """Return the rising and falling parts of a series.

    Examples
    --------
    >>> [(b.first, b.end, b.sign) for b in branches(np.array([0.0, 5.0, 4.9, 9.0, 1.0, 0.0, 6.0]), 1.0)]
    [(0, 4, 1), (3, 6, -1), (5, 7, 1)]
    """
    parts: list[Branch] = []
    begin, sign, top = 0, 0, 0
    low = high = 0
    for k, value in enumerate(values.tolist()):
        if sign == 0:
            low, high = (k if value < values[low] else low), (k if value > values[high] else high)
            if values[high] - values[low] < swing:
                continue
            sign = 1 if high > low else -1
            begin, top = (low, high) if sign > 0 else (high, low)
        elif sign * (value - values[top]) >= 0.0:
            top = k
        elif sign * (values[top] - value) >= swing:
            parts.append(Branch(begin, top + 1, sign))
            begin, sign, top = top, -sign, k
    if sign:
        parts.append(Branch(begin, top + 1, sign))
    return parts


def at_places(x: FloatArray, y: FloatArray, points: FloatArray, half: float) -> tuple[FloatArray, FloatArray]:
    """Return a curve at given points, from local straight lines, and the number of samples.

    Examples
    --------
    >>> x = np.linspace(0.0, 1.0, 101)
    >>> at_places(x, 3.0 * x, np.array([0.5, 2.0]), 0.1)[0].round(9).tolist()
    [1.5, nan]
    """
    order = np.argsort(x, kind="stable")
    x, y = x[order], y[order]
    values, counts = np.full(points.size, np.nan), np.zeros(points.size)
    if not x.size:
        return values, counts
    first, end = np.searchsorted(x, points - half), np.searchsorted(x, points + half, side="right")
    for k, point in enumerate(points):
        if not x[0] - 1e-9 <= point <= x[-1] + 1e-9:
            continue
        near_x, near_y = x[first[k] : end[k]] - point, y[first[k] : end[k]]
        counts[k] = max(near_x.size, 1)
        spread = near_x - near_x.mean() if near_x.size else near_x
        power = float(spread @ spread)
        if near_x.size < 3 or power < 1e-6 * half**2 or near_x[0] > 0.0 or near_x[-1] < 0.0:
            values[k] = np.interp(point, x, y)
            continue
        slope = float(spread @ near_y) / power
        values[k] = near_y.mean() - slope * near_x.mean()
    return values, counts


@dataclass(frozen=True)
class Jump:
    """Step of the setpoint."""

    time: float  # [s]
    before: int  # last sample at the old value
    after: int  # first sample at the new one
    duration: float  # between these samples [s]


def jumps(time: FloatArray, setpoint: FloatArray, threshold: float, *, is_exact: bool) -> list[Jump]:
    """Return the steps of a setpoint.

    Examples
    --------
    >>> [j.time for j in jumps(np.arange(40.0), np.repeat([0.0, 9.0], 20), 1.0, is_exact=False)]
    [19.5]
    """
    moving = np.flatnonzero(np.abs(np.diff(setpoint)) > max(_CLEAR * scatter_of(setpoint), _STILL))
    steps: list[Jump] = []
    for group in np.split(moving, np.flatnonzero(np.diff(moving) > 1) + 1):
        if not group.size:
            continue
        last, first = int(group[0]), int(group[-1]) + 1
        if abs(setpoint[first] - setpoint[last]) < threshold:
            continue
        middle = 0.5 * (setpoint[last] + setpoint[first])
        part = slice(last, first + 1)
        rising = setpoint[first] > setpoint[last]
        level, clock = (setpoint[part], time[part]) if rising else (setpoint[part][::-1], time[part][::-1])
        instant = float(time[first]) if is_exact else float(np.interp(middle, level, clock))
        steps.append(Jump(instant, last, first, float(time[first] - time[last])))
    return steps


def scatter_of(setpoint: FloatArray) -> float:
    """Return the standard deviation of a setpoint about its neighbours, without its steps."""
    deviations = np.abs(np.diff(setpoint, 2)) / math.sqrt(6.0)
    if not deviations.size:
        return 0.0
    sigma = float(np.quantile(deviations, 0.8)) / 1.28
    for _ in range(6):
        inliers = deviations[deviations <= 3.0 * sigma]
        sigma = float(np.sqrt(np.mean(inliers**2))) if inliers.size else 0.0
    return sigma


def stairs(setpoint: FloatArray) -> list[slice]:
    """Return the parts of a series with a constant setpoint.

    Examples
    --------
    >>> stairs(np.repeat([0.0, 1.0], 20))
    [slice(0, 20, None), slice(20, 40, None)]
    """
    if setpoint.size < 3:
        return []
    limit = max(_CLEAR * scatter_of(setpoint), _STILL)
    cuts = np.flatnonzero(np.abs(np.diff(setpoint)) > limit) + 1
    ends = np.concatenate(([0], cuts, [setpoint.size])).tolist()
    holds = [slice(a, b) for a, b in pairwise(ends) if b - a >= 3]
    # A noisy ramp also splits into pieces, but their levels rise.
    change_within = sum(abs(float(_end_mean(setpoint[part]) - _end_mean(setpoint[part][::-1]))) for part in holds)
    extent = sum(abs(float(np.mean(setpoint[b]) - np.mean(setpoint[a]))) for a, b in pairwise(holds))
    return holds if change_within <= _FLAT * extent or len(holds) == 1 else []


def _end_mean(values: FloatArray) -> float:
    """Return the mean of the last third."""
    return float(np.mean(values[-max(1, values.size // 3) :]))


def rested(time: FloatArray, part: slice, fraction: float) -> slice:
    """Return the last part of a hold."""
    times = time[part]
    begin = times[-1] - fraction * (times[-1] - times[0])
    return slice(min(part.start + int(np.searchsorted(times, begin)), part.stop - 1), part.stop)
