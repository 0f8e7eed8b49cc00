"""Slow sweeps: how far the outlet lags behind because of their rate, seen where they stop."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from poppet.bench.iso10094.scale import FloatArray
from poppet.bench.iso10094.shapes import Branch
from poppet.bench.iso10094.uncertainty import Uncertainty, mean_of, noise_about
from poppet.timeseries.measurements.noise import noise_of

NEAR, FAR = 0.05, 0.6
"""Part of a sweep, as distances from its end over its range, through which a straight line in time is laid."""
COMING = (0.005, 0.25)
"""The same for the outlet just before the sweep stops."""
FEWEST = 6
EXTENDED = 1.6
"""How much worse a line is known at the end of a sweep than a mean of the samples of its last quarter."""
CHOSEN = 1.3
"""What the choice of the samples by a noisy sweep adds to that."""
MOST = 0.1
"""Part of the time of a sweep that its lag may last."""


@dataclass(frozen=True)
class Lag:
    """How far the outlet is behind a sweep."""

    time: float  # by how much it is late, below zero where it is ahead [s]
    moved: float  # what it still moved when the sweep had stopped, below zero where it was ahead; unit of the outlet
    error: float  # standard uncertainty of what it moved, from noise
    rate: float  # change of what is swept per change of the outlet that follows it


def lags_of(time: FloatArray, x: FloatArray, y: FloatArray, parts: Sequence[Branch]) -> list[Lag]:
    """The lags of all sweeps to the upper end that stop there."""
    pairs = zip(parts, [*parts[1:], None], strict=False)
    found = [lag_of(time, x, y, branch, after) for branch, after in pairs if branch.sign > 0]
    return [lag for lag in found if lag is not None]


def lag_of(time: FloatArray, x: FloatArray, y: FloatArray, branch: Branch, following: Branch | None) -> Lag | None:
    """The lag of a sweep from what the outlet does in the hold at its end.

    The sweep stops where the straight line through it meets the level that is held, which noise hardly moves. Behind a
    slow ramp a linear valve is late by the sum of its time constants and dead times, at any rate.

    Examples
    --------
    >>> t = np.linspace(0.0, 15.0, 1501)
    >>> x, y = np.minimum(t, 10.0), np.clip(t - 0.2, 0.0, 10.0)
    >>> round(lag_of(t, x, y, Branch(0, t.size, 1), None).time, 3)
    0.2
    """
    level = float(np.median(x[max(branch.first, branch.end - 3) : branch.end + 2]))
    extent = float(np.ptp(x[branch.samples]))
    for _ in range(2):  # the hold that is found says more exactly what is held
        stop = _meets(time, x, branch, level, extent)
        go = _meets(time, x, following, level, extent) if following is not None else float(time[-1])
        still = (time > stop) & (time < go)
        level = float(np.mean(x[still])) if still.sum() > FEWEST else level
    held = (time > stop + 0.8 * (go - stop)) & (time < go)
    away = np.abs(x - level) / extent
    coming = (away > COMING[0]) & (away < COMING[1]) & (time < stop) & (time >= time[branch.first])
    step = float(np.median(np.diff(time)))
    if not go - stop > FEWEST * step or min(held.sum(), coming.sum()) < FEWEST:
        return None
    # A parabola: the characteristic need not be straight.
    clock = (time[coming] - stop) / max(stop - time[coming][0], step)
    matrix = np.vander(clock, 3)
    solved = np.linalg.pinv(matrix)
    _, rate, at_stop = (solved @ y[coming]).tolist()
    rate /= max(stop - time[coming][0], step)
    moved = float(np.mean(y[held]) - at_stop)
    if rate == 0.0:
        return None
    late = moved / float(rate)
    span = abs(float(time[branch.end - 1] - time[branch.first]))
    error = math.hypot(noise_about([y[held]]).mean(int(held.sum())), noise_about([y[coming]], 3).of(solved[2]))
    # The stop, too, is only known as well as the line that leads to it.
    stopped = EXTENDED * noise_of(x) * abs(float(rate)) / math.sqrt(float(coming.sum()))
    sweep = float(np.polyfit(clock, x[coming], 1)[0]) / max(stop - time[coming][0], step)
    error = CHOSEN * math.hypot(error, stopped / max(abs(sweep), 1e-300))
    return Lag(late, moved, error, abs(sweep / float(rate))) if abs(late) < MOST * span else None


def _meets(time: FloatArray, x: FloatArray, branch: Branch, level: float, extent: float) -> float:
    """When the straight line through a branch meets a level [s]."""
    part = branch.samples
    away = np.abs(x[part] - level) / extent
    inside = (away > NEAR) & (away < FAR)
    if np.count_nonzero(inside) < FEWEST:
        return math.nan
    clock = time[part][inside]
    rate, start = np.polyfit(clock - clock[0], x[part][inside], 1)
    return float(clock[0] + (level - start) / rate) if rate else math.nan


def caught_up(time: FloatArray, x: FloatArray, lags: Sequence[Lag]) -> FloatArray:
    """What was swept a mean lag ago: to this the outlet belongs.

    An outlet that goes back when the sweep stops was ahead of it, as behind an integral: no lag to take out.
    """
    late = float(np.mean([lag.time for lag in lags])) if lags else 0.0
    return np.interp(time - late, time, x) if late > 0.0 else x


def moved_by(lags: Sequence[Lag]) -> tuple[float, Uncertainty]:
    """What the outlet still moves when a sweep stops: the mean of all lags."""
    return mean_of([lag.moved for lag in lags], [Uncertainty(lag.error) for lag in lags])
