r"""How far a figure is known: from noise, sampling and repetition.

Standard uncertainties after the GUM (JCGM 100), and intervals of 95 % of what is partly normal and partly evenly
distributed. Noise is described by its autocovariance: a mean of coloured noise is not taken for better than it is.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from poppet.bench.iso10094.scale import FloatArray
from poppet.timeseries.measurements.noise import quantum_of

COVERAGE = 0.95
NORMAL = 1.959964
"""Standard deviations within which a normal distribution has 95 %."""
SHORT = 1.2
"""Variance of a mean of coloured noise over what a short record lets see of its colour."""
LAGS = 24
"""Samples over which noise is looked at for its colour."""
DRAWS = 400
"""Draws of noise from which the bias of a largest value and its scatter are known."""
DEGREES = 14
"""Highest degree of a polynomial that may stand for a curve."""
SEED = 20


@dataclass(frozen=True)
class Uncertainty:
    """What is not known of a figure: one standard deviation of its normal part, half width of its even part."""

    normal: float
    even: float = 0.0
    # Both ends of the interval of 95 %, where it does not lie evenly about the value.
    ends: tuple[float, float] | None = None

    @property
    def standard(self) -> float:
        """Standard uncertainty."""
        return math.hypot(self.normal, self.even / math.sqrt(3.0))

    def wider(self, normal: float) -> Uncertainty:
        """The same with another independent part."""
        return Uncertainty(math.hypot(self.normal, normal), self.even, self.ends)

    def plus(self, other: Uncertainty) -> Uncertainty:
        """With that of something that is added, or taken away: the wider even part stays one."""
        small, even = sorted((self.even, other.even))
        aside = NORMAL * other.standard
        ends = None if self.ends is None else (self.ends[0] - aside, self.ends[1] + aside)
        return Uncertainty(math.hypot(self.normal, other.normal, small / math.sqrt(3.0)), even, ends)

    def interval(self, value: float) -> tuple[float, float]:
        """Where the true value lies in 95 of 100 cases.

        Examples
        --------
        >>> [round(end, 3) for doubt in (Uncertainty(1.0), Uncertainty(0.0, 1.0)) for end in doubt.interval(0.0)]
        [-1.96, 1.96, -0.95, 0.95]
        """
        if self.ends is not None:
            return self.ends
        half = NORMAL * self.normal
        if self.even > 0.0:
            half = _half(self.normal / self.even) * self.even
        return value - half, value + half


def _half(normal: float) -> float:
    """Half width of 95 % of a normal and an even distribution of half width one."""
    if normal < 1e-6:
        return COVERAGE
    places = np.linspace(-1.0, 1.0, 65)
    low, high = 0.0, 1.0 + 3.0 * normal
    for _ in range(40):
        half = 0.5 * (low + high)
        inside = np.mean([_phi((half - u) / normal) - _phi((-half - u) / normal) for u in places])
        low, high = (half, high) if inside < COVERAGE else (low, half)
    return half


def _phi(x: float) -> float:
    return 0.5 * (1.0 + math.erf(x / math.sqrt(2.0)))


# Noise -------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Noise:
    """Noise of a series by its autocovariance, from lag zero on."""

    covariance: FloatArray

    @property
    def sigma(self) -> float:
        """Its standard deviation."""
        return math.sqrt(float(self.covariance[0]))

    def of(self, weights: FloatArray) -> float:
        """Standard deviation of a weighted sum of samples that follow each other."""
        lags = min(self.covariance.size, weights.size)
        own = np.array([float(weights[k:] @ weights[: weights.size - k]) for k in range(lags)])
        own[1:] *= 2.0
        return math.sqrt(max(float(own @ self.covariance[:lags]), 0.0))

    @property
    def spread(self) -> float:
        """Standard deviation that white noise would have whose means scatter alike."""
        total = float(self.covariance[0]) + 2.0 * float(np.sum(self.covariance[1:]))
        return math.sqrt(SHORT * max(total, 0.25 * float(self.covariance[0])))

    def mean(self, count: int) -> float:
        """Standard deviation of a mean of samples."""
        return self.spread / math.sqrt(max(1, count))

    def at(self, turn: float) -> float:
        """Standard deviation that white noise would have which is as strong at a frequency [rad per sample]."""
        lags = np.arange(1, self.covariance.size)
        total = float(self.covariance[0]) + 2.0 * float(np.sum(self.covariance[1:] * np.cos(turn * lags)))
        return math.sqrt(max(total, 0.5 * float(self.covariance[0])))


def noise_about(parts: Sequence[FloatArray], degree: int = 1) -> Noise:
    """The noise of series about smooth curves: what polynomials leave of them.

    Examples
    --------
    >>> x = np.random.default_rng(1).normal(0.0, 0.3, 4000)
    >>> found = noise_about([x, x + np.linspace(0.0, 9.0, 4000)])
    >>> round(found.sigma, 2), abs(found.spread / 0.3 - 1.0) < 0.1
    (0.3, True)
    """
    left = [_left(part, degree) for part in parts if part.size > degree + 3]
    if not left:
        return Noise(np.zeros(1))
    count = sum(each.size for each in left)
    lags = max(1, min(LAGS, min(each.size for each in left) // 4))
    covariance = np.zeros(lags)
    for each in left:
        covariance += [float(each[k:] @ each[: each.size - k]) for k in range(lags)]
    covariance /= max(1, count - (degree + 1) * len(left))
    # What is not told from nothing ends the colour.
    small = np.flatnonzero(np.abs(covariance) < 2.0 * covariance[0] / math.sqrt(count))
    covariance = covariance[: int(small[0])] if small.size and small[0] else covariance
    floor = max(quantum_of(part) for part in parts) ** 2 / 12.0
    covariance[0] = max(float(covariance[0]), floor)
    return Noise(covariance)


def _left(values: FloatArray, degree: int) -> FloatArray:
    place = np.linspace(-1.0, 1.0, values.size)
    return values - np.polynomial.legendre.legval(place, np.polynomial.legendre.legfit(place, values, degree))


# Curves ------------------------------------------------------------------------------------------------------------


def roughness(rows: FloatArray, stride: int = 1) -> float:
    """Standard deviation of single values of smooth curves on an even grid, from how they jump about.

    Examples
    --------
    >>> x = np.random.default_rng(1).normal(0.0, 0.3, (20, 101)) + np.linspace(0.0, 1.0, 101) ** 2
    >>> abs(roughness(x) - 0.3) < 0.03
    True
    """
    bends = rows[:, 2 * stride :] - 2.0 * rows[:, stride:-stride] + rows[:, : -2 * stride]
    bends = np.abs(bends[np.isfinite(bends)]) / math.sqrt(6.0)
    if not bends.size:
        return 0.0
    sigma = 1.4826 * float(np.median(bends))  # a bend or two of the curve itself is no noise
    kept = bends[bends <= 4.0 * sigma]
    return float(np.sqrt(np.mean(kept**2))) if kept.size else 0.0


@dataclass(frozen=True, eq=False)
class SmoothCurve:
    """A curve on a grid without its noise, and one standard deviation of what it may be beside it."""

    values: FloatArray
    basis: FloatArray  # (n, m), orthonormal: what remains of the noise lies in it
    sigma: float  # of each of its coefficients
    # Columns of the basis that the curve has. One more might have been there as well: what it would add is doubt.
    kept: int

    def draws(self, random: np.random.Generator) -> tuple[FloatArray, FloatArray]:
        """Curves that differ by what remains of the noise, a row each: of those columns, and of all."""
        chance = self.sigma * random.standard_normal((DRAWS, self.basis.shape[1]))
        own = self.values + chance[:, : self.kept] @ self.basis[:, : self.kept].T
        return own, self.values + chance @ self.basis.T

    def error(self, weights: FloatArray) -> float:
        """Standard deviation of a weighted sum of its values."""
        return self.sigma * float(np.linalg.norm(weights @ self.basis))


def smooth(grid: FloatArray, values: FloatArray, sigma: float, share: float = 1.0) -> SmoothCurve:
    """The simplest polynomial that noise does not tell from a curve; the curve itself where none is.

    `share` is the number of neighbouring values that share their noise.

    Examples
    --------
    >>> x = np.linspace(0.0, 1.0, 81)
    >>> found = smooth(x, 2.0 + x**2 + np.random.default_rng(1).normal(0.0, 0.1, 81), 0.1)
    >>> found.basis.shape[1] <= 5, bool(np.max(np.abs(found.values - 2.0 - x**2)) < 0.1)
    (True, True)
    """
    count = grid.size
    spread = sigma * math.sqrt(share)
    if sigma <= 1e-9 * max(1e-300, float(np.max(np.abs(values)))) or count < 8:
        return SmoothCurve(values, np.eye(count), sigma, count)
    place = 2.0 * (grid - grid[0]) / (grid[-1] - grid[0]) - 1.0
    highest = min(DEGREES, count // 3)
    basis = np.linalg.qr(np.polynomial.legendre.legvander(place, highest))[0]
    found = basis.T @ values
    left = float(values @ values) - np.cumsum(found**2)
    parameters = np.arange(1, highest + 2)
    # Akaike's criterion with the noise known: each coefficient has to earn what it costs.
    score = np.maximum(left, 0.0) / spread**2 + COST * parameters
    best = int(np.argmin(score))
    freedom = (count - best - 1) / share
    if left[best] / spread**2 > freedom + 4.0 * math.sqrt(2.0 * freedom):
        return SmoothCurve(values, np.eye(count), sigma, count)
    return SmoothCurve(basis[:, : best + 1] @ found[: best + 1], basis[:, : best + 2], spread, best + 1)


COST = 4.0
"""What a coefficient of a polynomial has to take off the sum of squares, in variances of the noise."""


def unbiased(
    curves: Sequence[SmoothCurve], functional: Callable[[list[FloatArray]], FloatArray]
) -> tuple[float, Uncertainty]:
    """A figure that is not linear in its curves, less the bias that noise gives it.

    `functional` takes arrays (draws, n), one of each curve, and gives a value per draw.

    Examples
    --------
    >>> curve = SmoothCurve(np.zeros(81), np.eye(81), 1.0, 81)
    >>> value, doubt = unbiased([curve], lambda draws: np.max(draws[0], axis=1))
    >>> value < -2.0
    True
    """
    random = np.random.default_rng(SEED)
    plain = float(functional([each.values[None, :] for each in curves])[0])
    own, every = zip(*(each.draws(random) for each in curves), strict=True)
    bias = float(np.mean(functional(list(own)))) - plain
    return plain - bias, Uncertainty(math.hypot(float(np.std(functional(list(every)))), bias))


# Repetition --------------------------------------------------------------------------------------------------------


def mean_of(values: Sequence[float], doubts: Sequence[Uncertainty]) -> tuple[float, Uncertainty]:
    """The mean of what was found several times, and what is not known of it: scatter counts beyond what each explains.

    Examples
    --------
    >>> value, doubt = mean_of([1.0, 3.0], [Uncertainty(0.1), Uncertainty(0.1)])
    >>> value, doubt.standard > 0.9
    (2.0, True)
    """
    if len(values) == 1:
        return float(values[0]), doubts[0]
    own = float(np.mean([doubt.standard**2 for doubt in doubts]))
    beyond = float(np.var(values, ddof=1)) - own * SCATTER
    return float(np.mean(values)), Uncertainty(math.sqrt((own + max(0.0, beyond)) / len(values)))


SCATTER = 3.0
"""Ratio of scatter to what the noise explains, as variances, that chance may make of a few repetitions."""


def greatest(values: Sequence[float], doubts: Sequence[Uncertainty]) -> tuple[float, Uncertainty, int]:
    """The largest of several values, and its place.

    Of values that noise has set apart the largest is too large. So far as they scatter no more than their noise does,
    each is drawn to their mean, by as much as is due to it (R. DerSimonian and N. Laird, Controlled Clinical Trials 7
    (1986) 177-188): values of one truth become one, values that differ stay what they are.

    Examples
    --------
    >>> value, doubt, place = greatest([2.0, 2.1, 2.1], [Uncertainty(0.1), Uncertainty(0.1), Uncertainty(0.1)])
    >>> round(value, 2), round(doubt.standard, 3)
    (2.07, 0.067)
    >>> round(greatest([1.0, 2.0, 9.0], [Uncertainty(0.1), Uncertainty(0.1), Uncertainty(0.1)])[0], 2)
    9.0
    """
    spread, every = np.array([doubt.standard for doubt in doubts]), np.array(values, dtype=np.float64)
    top = int(np.argmax(every))
    if every.size == 1 or not spread.min() > 0.0:
        return float(every[top]), doubts[top], top
    weights = spread**-2.0
    total = float(weights.sum())
    mean = float(weights @ every) / total
    apart = float(weights @ (every - mean) ** 2) - (every.size - 1)
    between = max(0.0, apart / (total - float(weights @ weights) / total))
    own = between / (between + spread**2)
    drawn = mean + own * (every - mean)
    k = int(np.argmax(drawn))
    shift = 0.5 * (1.0 - own[k]) * (every[k] - mean)
    error = math.hypot(math.sqrt(own[k]) * spread[k], (1.0 - own[k]) * total**-0.5, shift)
    return float(drawn[k]), Uncertainty(error), k
