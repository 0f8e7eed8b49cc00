"""Smoothing of a step response by parabolas; their width adapts to the curvature."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from poppet.bench.iso10094.scale import FloatArray
from poppet.bench.iso10094.shapes import unmasked_section
from poppet.bench.iso10094.uncertainty import DRAWS, NORMAL, SEED, Noise, Uncertainty

# Half widths of the fitted parabolas [samples].
WIDTHS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512)
APART = 1.0  # permitted deviation between wider and narrower parabolas, in standard deviations
# Fractions of the peak height for the fit of a peak, and fractions of the window for the fit at the band limit.
FLANKS, SPANS = (0.6, 0.8, 0.9, 0.96), (0.5, 0.25)
LOPSIDED = 2.0  # ratio of both sides of an interval, above which it is asymmetric
CLEAR = 3.0  # standard deviations beyond a level, at which the crossing is certain
MODEL = 0.5  # standard uncertainty of a polynomial by its shape, relative to the difference from the next one
AGREED = 1.0  # permitted difference of polynomials through more and fewer samples, in standard deviations
WIDER_BY = 4  # ratio of the half widths of two parabolas for the noise of their difference
WIDER = 1.2  # factor on the standard deviation of a parabola, because the width depends on the noise


@dataclass(frozen=True, eq=False)
class SmoothedSeries:
    """Smoothed step response from 0 to 1, with the standard deviation of each value."""

    time: FloatArray
    values: FloatArray
    errors: FloatArray
    raw: FloatArray  # as recorded
    widths: NDArray[np.int64]  # half width of the parabola for each value [samples]
    noise: Noise

    def from_sample(self, first: int) -> SmoothedSeries:
        """Return the series from the sample `first` to the end."""
        cut = {name: getattr(self, name)[first:] for name in ("time", "values", "errors", "raw", "widths")}
        return replace(self, **cut)

    def peak(self) -> tuple[float, Uncertainty]:
        """Return the largest value and its uncertainty, from a polynomial fitted to the peak.

        The polynomial is fitted where the overshoot above 1 exceeds a fraction of the largest overshoot.
        """
        k, estimates = int(np.argmax(self.values)), list[tuple[float, Uncertainty]]()
        for fraction in FLANKS:
            flank = 1.0 + fraction * (float(self.values[k]) - 1.0)
            window = unmasked_section(self.values < flank, k, k)
            count = window.stop - window.start
            if count < 5:
                a, b, c = np.interp([k - 1, k, k + 1], np.arange(self.values.size), self.values).tolist()
                bend = 2.0 * b - a - c
                excess = (c - a) ** 2 / (8.0 * bend) if bend > 0.0 else 0.0
                uncertainty = Uncertainty(float(self.errors[k]), common=0.05 * abs(bend))
                estimates.append((b + min(excess, 0.125 * bend), uncertainty))
                continue
            inverse = np.linalg.pinv(np.vander(np.linspace(-1.0, 1.0, count), 5 if count > 6 else 3))
            fine = np.vander(np.linspace(-0.5, 0.5, 101), inverse.shape[0])
            curve = fine @ (inverse @ self.raw[window])
            top = int(np.argmax(curve))
            # Additional noise of the same kind shows the bias of the largest value of a noisy curve.
            random = np.random.default_rng(SEED)
            samples = fine @ inverse @ random.normal(0.0, self.noise.spread, (count, DRAWS))
            bias = float(np.mean(np.max(curve[:, None] + samples, axis=0))) - float(curve[top])
            estimates.append((float(curve[top]) - bias, Uncertainty(WIDER * self.noise.of(fine[top] @ inverse))))
        return _first_agreeing_estimate(estimates)

    def crossing(self, level: float, extra: float, *, last: bool = False) -> tuple[float, Uncertainty]:
        """Return the time at which the series crosses a level [s], with its uncertainty.

        By default, it is the first rise to the level. If the keyword `last` is True, it is the last fall below the
        level. `extra` is the standard deviation of the level. The time is NaN if the series does not cross the level.
        """
        time = self._crossing_time(level, last=last)
        if not math.isfinite(time):
            return math.nan, Uncertainty(math.nan)
        k = int(np.clip(np.searchsorted(self.time, time), 1, self.time.size - 1))
        error = NORMAL * math.hypot(float(np.interp(time, self.time, self.errors)), extra)
        earliest, latest = self._crossing_time(level - error, last=last), self._crossing_time(level + error, last=last)
        if last:
            earliest, latest = latest, earliest
        # Between two samples, the response differs from a straight line.
        neighbours = self.values[max(0, k - 2) : k + 2]
        slope = abs(self.values[k] - self.values[k - 1]) / (self.time[k] - self.time[k - 1])
        bend = float(np.max(np.abs(np.diff(neighbours, 2)), initial=0.0)) / 8.0
        half_width = min(bend / max(slope, 1e-300), 0.5 * (self.time[k] - self.time[k - 1]))
        if not (math.isfinite(earliest) and math.isfinite(latest)):
            return time, Uncertainty(math.nan)
        normal = (latest - earliest) / (2.0 * NORMAL)
        is_even = max(latest - time, time - earliest) < LOPSIDED * min(latest - time, time - earliest) + half_width
        return time, Uncertainty(normal, half_width, None if is_even else (earliest - half_width, latest + half_width))

    def settling_time(self, band: float, extra: float) -> tuple[float, Uncertainty]:
        """Return the time from which the series stays within a band about 1 [s].

        The second item is the uncertainty. `band` is the half width of the band, and `extra` the standard deviation of
        the final value. The time comes from a cubic polynomial, which reduces the effect of noise.
        """
        away = replace(self, values=np.abs(self.values - 1.0))
        time, uncertainty = away.crossing(band, extra, last=True)
        is_uncertain = not math.isfinite(uncertainty.standard) or uncertainty.ends is not None
        if is_uncertain or self.noise.sigma <= 0.0 or time <= self.time[0]:
            return time, uncertainty
        k = int(np.clip(np.searchsorted(self.time, time), 1, self.time.size - 1))
        side = 1.0 if self.values[k - 1] > 1.0 else -1.0
        lobe = side * (self.values[:k] - 1.0)
        inner, outer = np.flatnonzero(lobe <= 0.0), np.flatnonzero(lobe >= 2.0 * band)
        first = int(inner[-1]) + 1 if inner.size else 0
        first += int(np.argmax(lobe[first:])) if first < k else 0
        reach = k - max(first, int(outer[-1]) if outer.size else 0)
        exits = [self._settling_time_on_cubic(k, int(reach * part), side, band) for part in SPANS]
        estimates = [(t, Uncertainty(WIDER * error, uncertainty.even)) for t, error in exits if math.isfinite(t)]
        # The band depends on the final value; its uncertainty divided by the slope is an uncertainty of the time.
        slope = band / max(time - float(self.time[max(k - reach, 0)]), 1e-300)
        exit_time, error = _first_agreeing_estimate([*estimates, (time, uncertainty)])
        return exit_time, error.plus_normal(extra / slope)

    def _settling_time_on_cubic(self, k: int, reach: int, side: float, band: float) -> tuple[float, float]:
        """Return the time at which a local cubic polynomial enters the band [s].

        The second item is its standard deviation. The polynomial is fitted to `reach` samples on either side of the
        sample `k`. `side` is +1 above and -1 below the final value. Both items are NaN if the polynomial does not enter
        the band.
        """
        window = slice(k - reach, min(k + reach + 1, self.time.size))
        if window.stop - window.start < 9:
            return math.nan, math.nan
        middle, width = float(self.time[k]), float(self.time[window.stop - 1] - self.time[window.start])
        inverse = np.linalg.pinv(np.vander((self.time[window] - middle) / width, 4))
        curve = inverse @ (side * (self.raw[window] - 1.0))
        roots = np.roots(curve - np.array([0.0, 0.0, 0.0, band]))
        real = roots[(np.abs(roots.imag) < 1e-9) & (np.abs(roots.real) < 0.5)].real
        root = float(real[np.argmin(np.abs(real))]) if real.size else math.nan
        slope = float(np.polyval(np.polyder(curve), root)) / width
        if not slope < 0.0:
            return math.nan, math.nan
        return middle + root * width, -self.noise.of(np.vander([root], 4)[0] @ inverse) / slope

    def _crossing_time(self, level: float, *, last: bool) -> float:
        """Return the time at which a noisy series crosses a level [s].

        Noise can cause several crossings, so the result is the mean of the first and the last crossing during the rise
        to the level. If the keyword `last` is True, the crossings during the final fall below the level are used.
        """
        if not last:
            risen = np.flatnonzero(self.values >= level)
            if not risen.size or risen[0] == 0:
                return float(self.time[0]) if risen.size else math.nan
            first = int(risen[0])
            certain = np.flatnonzero(self.values[first:] >= level + CLEAR * self.errors[first])
            limit = first + int(certain[0]) if certain.size else first
            final = int(np.flatnonzero(self.values[:limit] < level)[-1]) + 1
        else:
            outside_samples = np.flatnonzero(self.values > level)
            if not outside_samples.size or outside_samples[-1] + 1 >= self.values.size:
                return math.nan if outside_samples.size else float(self.time[0])
            final = int(outside_samples[-1]) + 1
            certain = np.flatnonzero(self.values[:final] > level + CLEAR * self.errors[final])
            since = int(certain[-1]) if certain.size else final - 1
            first = since + int(np.argmax(self.values[since:] <= level))
        return 0.5 * (self._time_between_samples(first, level) + self._time_between_samples(final, level))

    def _time_between_samples(self, k: int, level: float) -> float:
        """Return the time at which a cubic between two samples reaches a level [s].

        The samples are `k - 1` and `k`.
        """
        time, b, c = self.time, float(self.values[k - 1]), float(self.values[k])
        a = float(self.values[k - 2]) if k > 1 else 2.0 * b - c
        d = float(self.values[k + 1]) if k + 1 < self.values.size else 2.0 * c - b
        s = np.linspace(0.0, 1.0, 33)
        cubic = b + 0.5 * s * ((c - a) + s * ((2.0 * a - 5.0 * b + 4.0 * c - d) + s * (3.0 * (b - c) + d - a)))
        monotone = np.maximum.accumulate(cubic if c > b else -cubic)
        part = float(np.interp(level if c > b else -level, monotone, s))
        return float(time[k - 1] + part * (time[k] - time[k - 1]))


def smooth_response(time: FloatArray, values: FloatArray, noise: Noise, narrowest: int = 0) -> SmoothedSeries:
    """Smooth a series by local parabolas, whose widths adapt to the curvature.

    The method is the intersection of confidence intervals [1]_: a parabola widens while its value agrees with the
    values of the narrower parabolas. `narrowest` is the smallest half width of a parabola [samples]; the result omits
    this number of samples at the end.

    References
    ----------
    .. [1] A. Goldenshluger and A. Nemirovski, "On spatially adaptive estimation of nonparametric regression",
       Mathematical Methods of Statistics 6 (1997) 135-170.

    Examples
    --------
    >>> t = np.arange(0.0, 1.0, 1e-3)
    >>> y = 1.0 - np.exp(-t / 0.1)
    >>> found = smooth_response(t, y + np.random.default_rng(1).normal(0.0, 0.05, t.size), Noise(np.array([0.0025])))
    >>> bool(np.std(found.values - y) < 0.6 * 0.05), round(found.crossing(0.9, 0.0)[0], 1)
    (True, 0.2)
    """
    best, errors = values.copy(), np.full(values.size, noise.sigma)
    widths = np.zeros(values.size, dtype=np.int64)
    if noise.sigma <= 1e-9 * float(np.ptp(values)):
        return SmoothedSeries(time, best, np.zeros(values.size), values, widths, noise)
    is_open = np.ones(values.size, dtype=bool)
    if narrowest:
        weights, inner = parabola(narrowest), slice(narrowest, values.size - narrowest)
        best[inner] = np.convolve(values, weights, "valid")
        errors[inner], widths[inner] = noise.of(weights), narrowest
        is_open[:narrowest] = is_open[values.size - narrowest :] = False
    apart = APART * _deviation_of_wider(noise, 0)
    low, high = best - apart, best + apart
    if narrowest:
        apart = APART * _deviation_of_wider(noise, narrowest)
        low[inner], high[inner] = best[inner] - apart, best[inner] + apart
    for width in (width for width in WIDTHS if width > narrowest):
        if 2 * width + 1 > values.size or not is_open.any():
            break
        weights = parabola(width)
        inner = slice(width, values.size - width)
        fitted = np.convolve(values, weights, "valid")
        error = noise.of(weights)
        apart = APART * _deviation_of_wider(noise, width)
        low[inner] = np.maximum(low[inner], fitted - apart)
        high[inner] = np.minimum(high[inner], fitted + apart)
        agrees = np.zeros(values.size)
        agrees[inner] = low[inner] <= high[inner]
        # A wider parabola is valid if most of the neighbouring values agree with it.
        sums = np.concatenate([[0.0], np.cumsum(agrees * is_open)])
        n_agreeing = sums[2 * width + 1 :] - sums[: -2 * width - 1]
        is_open[inner] &= (n_agreeing > width) & (agrees[inner] > 0.0)
        is_open[:width] = is_open[values.size - width :] = False
        best[inner] = np.where(is_open[inner], fitted, best[inner])
        errors[is_open], widths[is_open] = error, width
    part = slice(0, values.size - narrowest)
    return SmoothedSeries(time[part], best[part], WIDER * errors[part], values[part], widths[part], noise)


def _deviation_of_wider(noise: Noise, width: int) -> float:
    """Return the standard deviation by which wider parabolas deviate from a parabola because of noise.

    `width` is the half width of this parabola in samples. For white noise, the result is the standard deviation of its
    value. Slow noise shifts narrow and wide parabolas alike, so the result is smaller.
    """
    narrow, wide = parabola(width) if width else np.ones(1), -parabola(max(WIDER_BY * width, WIDER_BY))
    middle, half = wide.size // 2, narrow.size // 2
    difference = wide.copy()
    difference[middle - half : middle + half + 1] += narrow
    white = math.sqrt(float(difference @ difference) / float(narrow @ narrow))
    return min(noise.of(difference) / white, noise.of(narrow))


def _first_agreeing_estimate(estimates: Sequence[tuple[float, Uncertainty]]) -> tuple[float, Uncertainty]:
    """Return the first estimate that agrees with the next one.

    Each estimate is a value with its uncertainty. Earlier estimates use more samples. If no pair agrees, the result is
    the last one.
    """
    for (value, uncertainty), (next_value, next_uncertainty) in pairwise(estimates):
        if abs(value - next_value) <= AGREED * math.hypot(uncertainty.standard, next_uncertainty.standard):
            return value, uncertainty.plus_normal(MODEL * abs(value - next_value))
    return estimates[-1]


@cache
def parabola(width: int) -> FloatArray:
    """Return the weights of samples for the value of a fitted parabola at its centre.

    The parabola is fitted to `width` samples on either side of the centre. For `width` = 1, a straight line is fitted.
    """
    offsets = np.arange(-width, width + 1, dtype=np.float64)
    return np.asarray(np.linalg.pinv(np.vander(offsets, 3 if width > 1 else 2))[-1])
