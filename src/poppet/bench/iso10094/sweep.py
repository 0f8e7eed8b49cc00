"""Lag of the outlet behind a slow sweep, measured at the end of the sweep."""

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
"""Section of a sweep for a line fit in time, as relative distances from its end."""
COMING = (0.005, 0.25)
"""Section for the outlet shortly before the end of the sweep."""
FEWEST = 6
EXTENDED = 1.6
"""Uncertainty of a line at the end of a sweep, relative to that of the mean of the last quarter."""
CHOSEN = 1.3
"""Factor for the selection of the samples by a noisy sweep."""
MOST = 0.1
"""Largest lag, relative to the duration of the sweep."""


@dataclass(frozen=True)
class Lag:
    """Lag of the outlet behind a sweep."""

    time: float  # delay, negative for a lead [s]
    moved: float  # change of the outlet after the end of the sweep, negative for a lead; unit of the outlet
    error: float  # standard uncertainty of `moved`, from noise
    rate: float  # change of the swept quantity per change of the outlet


def lags_of(time: FloatArray, x: FloatArray, y: FloatArray, parts: Sequence[Branch]) -> list[Lag]:
    """Return the lags of all sweeps that stop at their upper end."""
    pairs = zip(parts, [*parts[1:], None], strict=False)
    lags = [lag_of(time, x, y, branch, following) for branch, following in pairs if branch.sign > 0]
    return [lag for lag in lags if lag is not None]


def lag_of(time: FloatArray, x: FloatArray, y: FloatArray, branch: Branch, following: Branch | None) -> Lag | None:
    """Return the lag of a sweep, from the motion of the outlet in the hold at its end.

    The sweep stops at the intersection of its straight line with the held level, which is robust to noise. In a slow
    ramp, the delay of a linear valve is the sum of its time constants and dead times at any rate.

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
    for _ in range(2):  # the hold gives a more accurate level
        stop = _meets(time, x, branch, level, extent)
        go = _meets(time, x, following, level, extent) if following is not None else float(time[-1])
        is_still = (time > stop) & (time < go)
        level = float(np.mean(x[is_still])) if is_still.sum() > FEWEST else level
    is_held = (time > stop + 0.8 * (go - stop)) & (time < go)
    distance = np.abs(x - level) / extent
    is_coming = (distance > COMING[0]) & (distance < COMING[1]) & (time < stop) & (time >= time[branch.first])
    step = float(np.median(np.diff(time)))
    if not go - stop > FEWEST * step or min(is_held.sum(), is_coming.sum()) < FEWEST:
        return None
    # A parabola, because the characteristic can be curved.
    clock = (time[is_coming] - stop) / max(stop - time[is_coming][0], step)
    matrix = np.vander(clock, 3)
    inverse = np.linalg.pinv(matrix)
    _, rate, at_stop = (inverse @ y[is_coming]).tolist()
    rate /= max(stop - time[is_coming][0], step)
    change = float(np.mean(y[is_held]) - at_stop)
    if rate == 0.0:
        return None
    delay = change / float(rate)
    span = abs(float(time[branch.end - 1] - time[branch.first]))
    error = math.hypot(
        noise_about([y[is_held]]).mean(int(is_held.sum())), noise_about([y[is_coming]], 3).of(inverse[2])
    )
    # The uncertainty of the line also affects the stop.
    stopped = EXTENDED * noise_of(x) * abs(float(rate)) / math.sqrt(float(is_coming.sum()))
    sweep = float(np.polyfit(clock, x[is_coming], 1)[0]) / max(stop - time[is_coming][0], step)
    error = CHOSEN * math.hypot(error, stopped / max(abs(sweep), 1e-300))
    return Lag(delay, change, error, abs(sweep / float(rate))) if abs(delay) < MOST * span else None


def _meets(time: FloatArray, x: FloatArray, branch: Branch, level: float, extent: float) -> float:
    """Return the time at which the line through a branch meets a level [s]."""
    part = branch.samples
    distance = np.abs(x[part] - level) / extent
    is_inside = (distance > NEAR) & (distance < FAR)
    if np.count_nonzero(is_inside) < FEWEST:
        return math.nan
    clock = time[part][is_inside]
    rate, start = np.polyfit(clock - clock[0], x[part][is_inside], 1)
    return float(clock[0] + (level - start) / rate) if rate else math.nan


def caught_up(time: FloatArray, x: FloatArray, lags: Sequence[Lag]) -> FloatArray:
    """Return the swept value delayed by the mean lag, which corresponds to the outlet.

    An outlet that returns at the end of the sweep was ahead of it (integral action). This lead is not removed.

    An outlet that goes back when the sweep stops was ahead of it, as behind an integral: no lag to take out.
    """
    delay = float(np.mean([lag.time for lag in lags])) if lags else 0.0
    return np.interp(time - delay, time, x) if delay > 0.0 else x


def moved_by(lags: Sequence[Lag]) -> tuple[float, Uncertainty]:
    """Return the mean change of the outlet after the end of a sweep."""
    return mean_of([lag.moved for lag in lags], [Uncertainty(lag.error) for lag in lags])
