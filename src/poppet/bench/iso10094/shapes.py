"""Parts of a series: branches of a sweep, stairs, jumps; and what many samples say about a curve at one place."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from poppet.bench.iso10094.scale import FloatArray

_CLEAR = 6.0
"""Standard deviations of the noise that no chance exceeds in a recording."""
_FLAT = 0.3
"""Change within stairs, per change between them, above which they are no stairs."""
_STILL = 1e-6
"""Change of a setpoint between samples that is none [% FS]."""


@dataclass(frozen=True)
class Branch:
    """Samples between two turning points, `first` to `end - 1`; `sign` is +1 on the way up, -1 on the way down."""

    first: int
    end: int
    sign: int

    @property
    def samples(self) -> slice:
        """Where they stand in the series."""
        return slice(self.first, self.end)


def branches(values: FloatArray, swing: float) -> list[Branch]:
    """Rising and falling parts of a series.

    Examples
    --------
    >>> [(b.first, b.end, b.sign) for b in branches(np.array([0.0, 5.0, 4.9, 9.0, 1.0, 0.0, 6.0]), 1.0)]
    [(0, 4, 1), (3, 6, -1), (5, 7, 1)]
    """
    found: list[Branch] = []
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
            found.append(Branch(begin, top + 1, sign))
            begin, sign, top = top, -sign, k
    if sign:
        found.append(Branch(begin, top + 1, sign))
    return found


def at_places(x: FloatArray, y: FloatArray, places: FloatArray, half: float) -> tuple[FloatArray, FloatArray]:
    """A curve at given places, from straight lines through the samples near each of them.

    Examples
    --------
    >>> x = np.linspace(0.0, 1.0, 101)
    >>> at_places(x, 3.0 * x, np.array([0.5, 2.0]), 0.1)[0].round(9).tolist()
    [1.5, nan]
    """
    order = np.argsort(x, kind="stable")
    x, y = x[order], y[order]
    values, counts = np.full(places.size, np.nan), np.zeros(places.size)
    if not x.size:
        return values, counts
    first, end = np.searchsorted(x, places - half), np.searchsorted(x, places + half, side="right")
    for k, place in enumerate(places):
        if not x[0] - 1e-9 <= place <= x[-1] + 1e-9:
            continue
        near_x, near_y = x[first[k] : end[k]] - place, y[first[k] : end[k]]
        counts[k] = max(near_x.size, 1)
        spread = near_x - near_x.mean() if near_x.size else near_x
        power = float(spread @ spread)
        if near_x.size < 3 or power < 1e-6 * half**2 or near_x[0] > 0.0 or near_x[-1] < 0.0:
            values[k] = np.interp(place, x, y)
            continue
        slope = float(spread @ near_y) / power
        values[k] = near_y.mean() - slope * near_x.mean()
    return values, counts


@dataclass(frozen=True)
class Jump:
    """A step of the setpoint."""

    time: float  # [s]
    before: int  # last sample at the old value
    after: int  # first sample at the new one
    duration: float  # from one to the other [s]


def jumps(time: FloatArray, setpoint: FloatArray, least: float, *, is_exact: bool) -> list[Jump]:
    """Steps of a setpoint.

    Examples
    --------
    >>> [j.time for j in jumps(np.arange(40.0), np.repeat([0.0, 9.0], 20), 1.0, is_exact=False)]
    [19.5]
    """
    moving = np.flatnonzero(np.abs(np.diff(setpoint)) > max(_CLEAR * scatter_of(setpoint), _STILL))
    found: list[Jump] = []
    for group in np.split(moving, np.flatnonzero(np.diff(moving) > 1) + 1):
        if not group.size:
            continue
        before, after = int(group[0]), int(group[-1]) + 1
        if abs(setpoint[after] - setpoint[before]) < least:
            continue
        middle = 0.5 * (setpoint[before] + setpoint[after])
        part = slice(before, after + 1)
        rising = setpoint[after] > setpoint[before]
        level, clock = (setpoint[part], time[part]) if rising else (setpoint[part][::-1], time[part][::-1])
        instant = float(time[after]) if is_exact else float(np.interp(middle, level, clock))
        found.append(Jump(instant, before, after, float(time[after] - time[before])))
    return found


def scatter_of(setpoint: FloatArray) -> float:
    """Standard deviation of a setpoint about its neighbours, its steps left out."""
    away = np.abs(np.diff(setpoint, 2)) / math.sqrt(6.0)
    if not away.size:
        return 0.0
    sigma = float(np.quantile(away, 0.8)) / 1.28
    for _ in range(6):
        kept = away[away <= 3.0 * sigma]
        sigma = float(np.sqrt(np.mean(kept**2))) if kept.size else 0.0
    return sigma


def stairs(setpoint: FloatArray) -> list[slice]:
    """Parts of a series in which a setpoint is held.

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
    found = [slice(a, b) for a, b in pairwise(ends) if b - a >= 3]
    # A ramp with noise falls into pieces as well, but these go on rising.
    inside = sum(abs(float(_end_mean(setpoint[part]) - _end_mean(setpoint[part][::-1]))) for part in found)
    extent = sum(abs(float(np.mean(setpoint[b]) - np.mean(setpoint[a]))) for a, b in pairwise(found))
    return found if inside <= _FLAT * extent or len(found) == 1 else []


def _end_mean(values: FloatArray) -> float:
    """Mean of the last third."""
    return float(np.mean(values[-max(1, values.size // 3) :]))


def rested(time: FloatArray, part: slice, fraction: float) -> slice:
    """The last part of a hold."""
    inside = time[part]
    begin = inside[-1] - fraction * (inside[-1] - inside[0])
    return slice(min(part.start + int(np.searchsorted(inside, begin)), part.stop - 1), part.stop)
