"""Division of series into branches, stairs and jumps, and the lag of an outlet behind a sweep."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from poppet.bench.iso10094.scale import FloatArray, Mask
from poppet.bench.iso10094.uncertainty import Noise, Uncertainty, estimate_noise, mean_of
from poppet.timeseries.measurements.measurement import noise_of

_CLEAR = 6.0  # limit of the noise in a recording, in standard deviations
_FLAT = 0.3  # change within stairs relative to the change between them, above which a series is not a staircase
_STILL = 1e-6  # setpoint change between samples that counts as constant [% FS]


@dataclass(frozen=True)
class Branch:
    """Rising or falling section of a series between two turning points.

    `sign` is +1 if the branch rises and -1 if it falls. The branch consists of the samples `first` to `end - 1`.
    """

    first: int
    end: int
    sign: int

    @property
    def samples(self) -> slice:
        """Slice of the samples of the branch in its series."""
        return slice(self.first, self.end)


def branches(values: FloatArray, swing: float) -> list[Branch]:
    """Divide a series into rising and falling branches.

    A reversal ends a branch if the values then change by at least `swing`.

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


def values_at_points(x: FloatArray, y: FloatArray, points: FloatArray, half: float) -> tuple[FloatArray, FloatArray]:
    """Return the values of a noisy curve `y(x)` at given points.

    Each value comes from a straight line that is fitted to the samples within the distance `half` of the point. The
    second item contains the numbers of these samples. Values outside the curve are NaN.

    Examples
    --------
    >>> x = np.linspace(0.0, 1.0, 101)
    >>> values_at_points(x, 3.0 * x, np.array([0.5, 2.0]), 0.1)[0].round(9).tolist()
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
    """Sudden change (jump) of the setpoint between two samples."""

    time: float  # [s]
    before: int  # last sample at the old value
    after: int  # first sample at the new one
    duration: float  # between these samples [s]


def find_jumps(time: FloatArray, setpoint: FloatArray, threshold: float, *, is_exact: bool) -> list[Jump]:
    """Return all jumps of a setpoint that are at least as large as a threshold.

    If the keyword `is_exact` is True, a jump occurs at the first sample with the new value. Otherwise its time is
    interpolated.

    Examples
    --------
    >>> [j.time for j in find_jumps(np.arange(40.0), np.repeat([0.0, 9.0], 20), 1.0, is_exact=False)]
    [19.5]
    """
    moving = np.flatnonzero(np.abs(np.diff(setpoint)) > max(_CLEAR * setpoint_noise(setpoint), _STILL))
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


def setpoint_noise(setpoint: FloatArray) -> float:
    """Return the standard deviation of the noise of a setpoint, without its jumps."""
    deviations = np.abs(np.diff(setpoint, 2)) / math.sqrt(6.0)
    if not deviations.size:
        return 0.0
    sigma = float(np.quantile(deviations, 0.8)) / 1.28
    for _ in range(6):
        inliers = deviations[deviations <= 3.0 * sigma]
        sigma = float(np.sqrt(np.mean(inliers**2))) if inliers.size else 0.0
    return sigma


def constant_sections(setpoint: FloatArray) -> list[slice]:
    """Return the sections of a staircase in which the setpoint is constant.

    The sections are slices of the samples. The list is empty if the setpoint is not a staircase.

    Examples
    --------
    >>> constant_sections(np.repeat([0.0, 1.0], 20))
    [slice(0, 20, None), slice(20, 40, None)]
    """
    if setpoint.size < 3:
        return []
    limit = max(_CLEAR * setpoint_noise(setpoint), _STILL)
    cuts = np.flatnonzero(np.abs(np.diff(setpoint)) > limit) + 1
    ends = np.concatenate(([0], cuts, [setpoint.size])).tolist()
    holds = [slice(a, b) for a, b in pairwise(ends) if b - a >= 3]
    # A noisy ramp is also divided into sections, but the values rise within them.
    change_within = sum(abs(float(_end_mean(setpoint[part]) - _end_mean(setpoint[part][::-1]))) for part in holds)
    extent = sum(abs(float(np.mean(setpoint[b]) - np.mean(setpoint[a]))) for a, b in pairwise(holds))
    return holds if change_within <= _FLAT * extent or len(holds) == 1 else []


def _end_mean(values: FloatArray) -> float:
    """Return the mean of the last third of a series."""
    return float(np.mean(values[-max(1, values.size // 3) :]))


def unmasked_section(outside: Mask, first: int, end: int) -> slice:
    """Return the longest slice without masked samples that contains the slice `first:end`.

    `outside` is the mask; it must be False from `first` to `end - 1`.

    Examples
    --------
    >>> unmasked_section(np.array([False, True, False, False, True]), 2, 2)
    slice(2, 4, None)
    """
    earlier, later = np.flatnonzero(outside[:first]), np.flatnonzero(outside[end:])
    return slice(int(earlier[-1]) + 1 if earlier.size else 0, end + int(later[0]) if later.size else outside.size)


def steady_part(time: FloatArray, part: slice, fraction: float) -> slice:
    """Return the final part of a hold, in which the outlet is in steady state.

    `part` is the slice of the hold. `fraction` is the duration of the final part divided by the duration of the hold.
    """
    times = time[part]
    begin = times[-1] - fraction * (times[-1] - times[0])
    return slice(min(part.start + int(np.searchsorted(times, begin)), part.stop - 1), part.stop)


NEAR, FAR = 0.05, 0.6  # section of a sweep for a line fit in time, as relative distances from its end
# Sections for the outlet shortly before the end of the sweep, and the degrees of polynomials in them, in the order of
# increasing uncertainty by noise. A curved characteristic requires a narrow section or a high degree.
COMING, SECTIONS = 0.005, ((0.25, 2), (0.25, 3), (0.12, 2), (0.12, 3), (0.06, 2), (0.06, 3))
WIDE = 3  # sections for the rate
AGREES = 1.0  # permitted difference of two polynomials, in standard deviations of the difference
FEWEST = 6
EXTENDED = 1.6  # uncertainty of a line at the end of a sweep, relative to that of the mean of the last quarter
CHOSEN = 1.3  # factor for the selection of the samples by a noisy sweep
SELECTED = 1.5  # factor for the selection of the section before the end of a sweep as well
MOST = 0.1  # largest lag, relative to the duration of the sweep


@dataclass(frozen=True)
class Lag:
    """Lag of the outlet pressure behind a sweep, as delay and as pressure difference."""

    time: float  # delay, negative for a lead [s]
    moved: float  # change of the outlet after the end of the sweep, negative for a lead; unit of the outlet
    error: float  # standard uncertainty of `moved`, from noise
    shift_error: float  # standard uncertainty of the delay, as a change of the outlet
    rate: float  # change of the swept quantity per change of the outlet


def lags_of(time: FloatArray, x: FloatArray, y: FloatArray, parts: Sequence[Branch]) -> list[Lag]:
    """Return the lag of the outlet behind each rising sweep that ends in a hold.

    `x` is the swept quantity, `y` the outlet, and `parts` the branches of the sweep. Sweeps with a short hold are
    omitted.
    """
    pairs = zip(parts, [*parts[1:], None], strict=False)
    lags = [lag_of(time, x, y, branch, following) for branch, following in pairs if branch.sign > 0]
    return [lag for lag in lags if lag is not None]


def lag_of(time: FloatArray, x: FloatArray, y: FloatArray, branch: Branch, following: Branch | None) -> Lag | None:
    """Return the lag of the outlet behind a sweep, from its motion after the sweep.

    `x` is the swept quantity, `y` the outlet, and `following` the next branch. The end of the sweep is the intersection
    of a fitted straight line with the level of the hold, which is robust to noise. In a slow ramp, the delay of a
    linear valve is the sum of its time constants and dead times at any rate. The result is None if the hold is too
    short.

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
        stop = _time_of_level(time, x, branch, level, extent)
        go = _time_of_level(time, x, following, level, extent) if following is not None else float(time[-1])
        is_still = (time > stop) & (time < go)
        level = float(np.mean(x[is_still])) if is_still.sum() > FEWEST else level
    is_held = (time > stop + 0.8 * (go - stop)) & (time < go)
    step = float(np.median(np.diff(time)))
    distance = np.abs(x - level) / extent
    is_before = (distance > COMING) & (time < stop) & (time >= time[branch.first])
    if not go - stop > FEWEST * step or is_held.sum() < FEWEST:
        return None
    # A short section would underestimate correlated noise.
    noise = estimate_noise([y[is_before & (distance < max(SECTIONS)[0])]], max(SECTIONS)[1])
    held, held_error = float(np.mean(y[is_held])), noise.mean(int(is_held.sum()))
    sections = ((is_before & (distance < width), degree) for width, degree in SECTIONS)
    ends = [_end_of_sweep(time, x, y, stop, held, is_coming, degree, noise) for is_coming, degree in sections]
    valid_ends = [end for end in ends if end is not None]
    if not valid_ends:
        return None
    end = valid_ends[_first_consistent_estimate([(end.moved, end.error) for end in valid_ends])]
    # The rate needs less accuracy than the motion, but varies more in a narrow section.
    wide_ends = valid_ends[:WIDE]
    steady = wide_ends[_first_consistent_estimate([(end.rate, end.rate_error) for end in wide_ends])]
    delay = end.moved / steady.rate
    span = abs(float(time[branch.end - 1] - time[branch.first]))
    error = SELECTED * math.hypot(held_error, end.error)
    shift_error = math.hypot(error, delay * steady.rate_error)
    lag = Lag(delay, end.moved, error, shift_error, abs(steady.sweep / steady.rate))
    return lag if abs(lag.time) < MOST * span else None


@dataclass(frozen=True)
class SweepEnd:
    """Outlet pressure at and after the end of a sweep.

    The value and the rate of the outlet at the end are extrapolated from a section before the end.
    """

    moved: float  # change of the outlet after the end: value in the hold minus value at the end
    error: float  # standard uncertainty of `moved`
    rate: float  # change of the outlet per second at the end
    rate_error: float  # standard uncertainty of `rate`
    sweep: float  # change of the swept quantity per second


def _end_of_sweep(
    time: FloatArray, x: FloatArray, y: FloatArray, stop: float, held: float, is_coming: Mask, degree: int, noise: Noise
) -> SweepEnd | None:
    """Return the rate of the outlet at the end of a sweep, and its change.

    Both come from a polynomial of degree `degree` that is fitted to the samples `is_coming` before the time `stop` [s].
    `x` is the swept quantity, and `y` the outlet. The change is the level `held` in the hold minus the outlet at the
    end of the sweep. `noise` is the noise of the outlet. The result is None if there are too few samples or the outlet
    is constant.
    """
    if is_coming.sum() < (FEWEST if degree == SECTIONS[0][1] else 2 * FEWEST):
        return None
    duration = max(stop - float(time[is_coming][0]), float(np.median(np.diff(time))))
    clock = (time[is_coming] - stop) / duration
    inverse = np.linalg.pinv(np.vander(clock, degree + 1))
    coefficients = inverse @ y[is_coming]
    rate, sweep = float(coefficients[-2]) / duration, float(np.polyfit(clock, x[is_coming], 1)[0]) / duration
    if rate == 0.0:
        return None
    # The uncertainty of the line of the swept quantity also affects the stop.
    stopped = EXTENDED * noise_of(x) * abs(rate) / math.sqrt(float(is_coming.sum())) / max(abs(sweep), 1e-300)
    moved = held - float(coefficients[-1])
    error, rate_error = math.hypot(noise.of(inverse[-1]), stopped), noise.of(inverse[-2]) / duration
    return SweepEnd(moved, error, rate, rate_error, sweep)


def _first_consistent_estimate(estimates: Sequence[tuple[float, float]]) -> int:
    """Return the index of the first estimate that agrees with all later ones.

    Each estimate is a value with its standard uncertainty. Later estimates have less bias and more noise.
    """
    for k, (value, error) in enumerate(estimates[:-1]):
        differences = ((abs(other - value), max(e**2 - error**2, 0.0) ** 0.5) for other, e in estimates[k + 1 :])
        if all(difference <= AGREES * deviation for difference, deviation in differences):
            return k
    return len(estimates) - 1


def _time_of_level(time: FloatArray, x: FloatArray, branch: Branch, level: float, extent: float) -> float:
    """Return the time at which a straight line through a branch reaches a level [s].

    `x` is the swept quantity, and `extent` the range of the sweep. The result is NaN if the branch has too few samples.
    """
    part = branch.samples
    distance = np.abs(x[part] - level) / extent
    is_inside = (distance > NEAR) & (distance < FAR)
    if np.count_nonzero(is_inside) < FEWEST:
        return math.nan
    clock = time[part][is_inside]
    rate, start = np.polyfit(clock - clock[0], x[part][is_inside], 1)
    return float(clock[0] + (level - start) / rate) if rate else math.nan


def delay_by_lags(time: FloatArray, x: FloatArray, lags: Sequence[Lag]) -> FloatArray:
    """Return the swept quantity `x`, delayed by the mean lag of the outlet.

    A negative mean lag is a lead of the outlet, for example by integral action. It is not corrected.
    """
    delay = float(np.mean([lag.time for lag in lags])) if lags else 0.0
    return np.interp(time - delay, time, x) if delay > 0.0 else x


def mean_lag_change(lags: Sequence[Lag]) -> tuple[float, Uncertainty]:
    """Return the mean change of the outlet after the end of sweeps, with its uncertainty.

    `lags` are the lags of the sweeps.
    """
    return mean_of([lag.moved for lag in lags], [Uncertainty(lag.error) for lag in lags])
