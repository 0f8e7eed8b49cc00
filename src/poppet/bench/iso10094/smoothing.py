"""An answer without its noise: each place as smooth as the answer itself is there."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from poppet.bench.iso10094.scale import FloatArray
from poppet.bench.iso10094.uncertainty import DRAWS, NORMAL, SEED, Noise, Uncertainty

WIDTHS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512)
"""Samples to either side over which parabolas are laid."""
APART = 1.0
"""Standard deviations by which a wider parabola may leave what the narrower ones allow."""
FLANKS, SPANS = (0.6, 0.8, 0.9, 0.96), (1.0, 0.5, 0.25)
"""Parts of its height from which a peak is looked at, and parts of the way to the band's edge and from there on."""
LOPSIDED = 2.0
"""Ratio of both sides of an interval from which it has ends of its own."""
CLEAR = 3.0
"""Standard deviations beyond a level at which it is crossed for sure."""
AGREED = 1.5
"""Standard deviations by which a polynomial through more samples may differ from one through fewer."""
WIDER = 1.2
"""Standard deviation of the smoothed place, over that of its parabola: what the choice of its width adds."""


@dataclass(frozen=True, eq=False)
class SmoothedSeries:
    """A series over its time, and one standard deviation of each of its values."""

    time: FloatArray
    values: FloatArray
    errors: FloatArray
    raw: FloatArray  # as recorded
    widths: NDArray[np.int64]  # samples to either side of each place that made its value
    noise: Noise

    def since(self, first: int) -> SmoothedSeries:
        """The part from a sample on."""
        cut = {name: getattr(self, name)[first:] for name in ("time", "values", "errors", "raw", "widths")}
        return replace(self, **cut)

    def summit(self) -> tuple[float, Uncertainty]:
        """Its largest value above one: of a polynomial through as much of its peak as that follows."""
        return _agreed([self._peak(flank) for flank in FLANKS])

    def _peak(self, part: float) -> tuple[float, Uncertainty]:
        """The largest value, from all samples above a part of the height of the peak."""
        k = int(np.argmax(self.values))
        flank = 1.0 + part * (float(self.values[k]) - 1.0)
        before, after = np.flatnonzero(self.values[:k] < flank), np.flatnonzero(self.values[k:] < flank)
        near = slice(int(before[-1]) + 1 if before.size else 0, k + int(after[0]) if after.size else self.values.size)
        count = near.stop - near.start
        if count < 5:
            a, b, c = np.interp([k - 1, k, k + 1], np.arange(self.values.size), self.values).tolist()
            bend = 2.0 * b - a - c
            beyond = (c - a) ** 2 / (8.0 * bend) if bend > 0.0 else 0.0
            return b + min(beyond, 0.125 * bend), Uncertainty(float(self.errors[k]), 0.03 * abs(bend))
        solved = np.linalg.pinv(np.vander(np.linspace(-1.0, 1.0, count), 5 if count > 6 else 3))
        fine = np.vander(np.linspace(-0.5, 0.5, 101), solved.shape[0])
        curve = fine @ (solved @ self.raw[near])
        top = int(np.argmax(curve))
        # The largest value of a noisy curve is too large by what more noise of the same kind adds to it.
        random = np.random.default_rng(SEED)
        drawn = fine @ solved @ random.normal(0.0, self.noise.spread, (count, DRAWS))
        bias = float(np.mean(np.max(curve[:, None] + drawn, axis=0))) - float(curve[top])
        return float(curve[top]) - bias, Uncertainty(WIDER * self.noise.of(fine[top] @ solved))

    def crossing(self, level: float, extra: float, *, last: bool = False) -> tuple[float, Uncertainty]:
        """When the series first reaches a level, or last leaves it downwards for good, and how well that is known.

        `extra` is the standard deviation of the level itself.
        """
        time = self._when(level, last=last)
        if not math.isfinite(time):
            return math.nan, Uncertainty(math.nan)
        k = int(np.clip(np.searchsorted(self.time, time), 1, self.time.size - 1))
        error = NORMAL * math.hypot(float(np.interp(time, self.time, self.errors)), extra)
        early, late = self._when(level - error, last=last), self._when(level + error, last=last)
        if last:
            early, late = late, early
        # Between two samples the answer bends away from the straight line.
        near = self.values[max(0, k - 2) : k + 2]
        slope = abs(self.values[k] - self.values[k - 1]) / (self.time[k] - self.time[k - 1])
        bend = float(np.max(np.abs(np.diff(near, 2)), initial=0.0)) / 8.0
        even = min(bend / max(slope, 1e-300), 0.5 * (self.time[k] - self.time[k - 1]))
        if not (math.isfinite(early) and math.isfinite(late)):
            return time, Uncertainty(math.nan)
        normal = (late - early) / (2.0 * NORMAL)
        is_even = max(late - time, time - early) < LOPSIDED * min(late - time, time - early) + even
        return time, Uncertainty(normal, even, None if is_even else (early - even, late + even))

    def leaving(self, band: float, extra: float) -> tuple[float, Uncertainty]:
        """When the series last leaves a band about one: on a cubic through as many samples about it as that follows."""
        away = replace(self, values=np.abs(self.values - 1.0))
        time, doubt = away.crossing(band, extra, last=True)
        if not math.isfinite(doubt.standard) or self.noise.sigma <= 0.0 or time <= self.time[0]:
            return time, doubt
        k = int(np.clip(np.searchsorted(self.time, time), 1, self.time.size - 1))
        side = 1.0 if self.values[k - 1] > 1.0 else -1.0
        lobe = side * (self.values[:k] - 1.0)
        inside, far = np.flatnonzero(lobe <= 0.0), np.flatnonzero(lobe >= 2.0 * band)
        first = int(inside[-1]) + 1 if inside.size else 0
        first += int(np.argmax(lobe[first:])) if first < k else 0
        most = k - max(first, int(far[-1]) if far.size else 0)
        found = [self._left_on_cubic(k, int(most * part), side, band) for part in SPANS]
        known = [(t, Uncertainty(WIDER * own, doubt.even)) for t, own in found if math.isfinite(t)]
        if not known:
            return time, doubt
        # The level of the band is that of the final value: what moves it moves the time as the slope there has it.
        slope = band / max(time - float(self.time[max(k - most, 0)]), 1e-300)
        at, own = _agreed(known)
        return at, own.wider(extra / slope)

    def _left_on_cubic(self, k: int, most: int, side: float, band: float) -> tuple[float, float]:
        """When a cubic through the samples about a place meets the edge of the band, and its standard uncertainty."""
        near = slice(k - most, min(k + most + 1, self.time.size))
        if near.stop - near.start < 9:
            return math.nan, math.nan
        middle, width = float(self.time[k]), float(self.time[near.stop - 1] - self.time[near.start])
        solved = np.linalg.pinv(np.vander((self.time[near] - middle) / width, 4))
        curve = solved @ (side * (self.raw[near] - 1.0))
        roots = np.roots(curve - np.array([0.0, 0.0, 0.0, band]))
        real = roots[(np.abs(roots.imag) < 1e-9) & (np.abs(roots.real) < 0.5)].real
        at = float(real[np.argmin(np.abs(real))]) if real.size else math.nan
        slope = float(np.polyval(np.polyder(curve), at)) / width
        if not slope < 0.0:
            return math.nan, math.nan
        return middle + at * width, -self.noise.of(np.vander([at], 4)[0] @ solved) / slope

    def _when(self, level: float, *, last: bool) -> float:
        """The middle between the first and the last place at which a rough series crosses a level."""
        if last:
            return self._left(level)
        above = np.flatnonzero(self.values >= level)
        if not above.size or above[0] == 0:
            return math.nan if not above.size else float(self.time[0])
        first = int(above[0])
        sure = np.flatnonzero(self.values[first:] >= level + CLEAR * self.errors[first])
        until = first + int(sure[0]) if sure.size else first
        below = np.flatnonzero(self.values[:until] < level)
        return 0.5 * (self._between(first, level) + self._between(int(below[-1]) + 1, level))

    def _left(self, level: float) -> float:
        beyond = np.flatnonzero(self.values > level)
        if not beyond.size or beyond[-1] + 1 >= self.values.size:
            return math.nan if beyond.size else float(self.time[0])
        last = int(beyond[-1]) + 1
        sure = np.flatnonzero(self.values[:last] > level + CLEAR * self.errors[last])
        since = int(sure[-1]) if sure.size else last - 1
        first = since + int(np.argmax(self.values[since:] <= level))
        return 0.5 * (self._between(first, level) + self._between(last, level))

    def _between(self, k: int, level: float) -> float:
        """When a cubic between a sample and the one before it meets a level."""
        time, b, c = self.time, float(self.values[k - 1]), float(self.values[k])
        a = float(self.values[k - 2]) if k > 1 else 2.0 * b - c
        d = float(self.values[k + 1]) if k + 1 < self.values.size else 2.0 * c - b
        s = np.linspace(0.0, 1.0, 33)
        cubic = b + 0.5 * s * ((c - a) + s * ((2.0 * a - 5.0 * b + 4.0 * c - d) + s * (3.0 * (b - c) + d - a)))
        way = np.maximum.accumulate(cubic if c > b else -cubic)
        part = float(np.interp(level if c > b else -level, way, s))
        return float(time[k - 1] + part * (time[k] - time[k - 1]))


def smoothed(time: FloatArray, values: FloatArray, noise: Noise) -> SmoothedSeries:
    """A series by parabolas, each as wide as all narrower ones allow: the intersection of their confidence intervals.

    References
    ----------
    .. [1] A. Goldenshluger and A. Nemirovski, "On spatially adaptive estimation of nonparametric regression",
       Mathematical Methods of Statistics 6 (1997) 135-170.

    Examples
    --------
    >>> t = np.arange(0.0, 1.0, 1e-3)
    >>> y = 1.0 - np.exp(-t / 0.1)
    >>> found = smoothed(t, y + np.random.default_rng(1).normal(0.0, 0.05, t.size), Noise(np.array([0.0025])))
    >>> bool(np.std(found.values - y) < 0.6 * 0.05), round(found.crossing(0.9, 0.0)[0], 1)
    (True, 0.2)
    """
    best, errors = values.copy(), np.full(values.size, noise.sigma)
    widths = np.zeros(values.size, dtype=np.int64)
    if noise.sigma <= 1e-9 * float(np.ptp(values)):
        return SmoothedSeries(time, best, np.zeros(values.size), values, widths, noise)
    low, high = values - APART * noise.sigma, values + APART * noise.sigma
    is_open = np.ones(values.size, dtype=bool)
    for width in WIDTHS:
        if 2 * width + 1 > values.size or not is_open.any():
            break
        weights = _parabola(width)
        inner = slice(width, values.size - width)
        wide = np.convolve(values, weights, "valid")
        error = noise.of(weights)
        low[inner] = np.maximum(low[inner], wide - APART * error)
        high[inner] = np.minimum(high[inner], wide + APART * error)
        agrees = np.zeros(values.size)
        agrees[inner] = low[inner] <= high[inner]
        # What the place and most of its neighbours allow.
        sums = np.concatenate([[0.0], np.cumsum(agrees * is_open)])
        near = sums[2 * width + 1 :] - sums[: -2 * width - 1]
        is_open[inner] &= (near > width) & (agrees[inner] > 0.0)
        is_open[:width] = is_open[values.size - width :] = False
        best[inner] = np.where(is_open[inner], wide, best[inner])
        errors[is_open], widths[is_open] = error, width
    return SmoothedSeries(time, best, WIDER * errors, values, widths, noise)


def _agreed(found: Sequence[tuple[float, Uncertainty]]) -> tuple[float, Uncertainty]:
    """The first of several answers, from ever fewer samples, that the next one does not contradict."""
    for (value, doubt), (other, its) in pairwise(found):
        if abs(value - other) <= AGREED * math.hypot(doubt.standard, its.standard):
            return value, doubt
    return found[-1]


@cache
def _parabola(width: int) -> FloatArray:
    """Weights of the samples for the middle of the parabola through them; of a straight line through three."""
    place = np.arange(-width, width + 1, dtype=np.float64)
    return np.asarray(np.linalg.pinv(np.vander(place, 3 if width > 1 else 2))[-1])
