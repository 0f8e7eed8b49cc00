r"""Uncertainty of characteristic values: noise, sampling and repetition.

Standard uncertainties follow the GUM (JCGM 100). The 95 % intervals combine normal and uniform distributions. Noise is
described by its autocovariance, because the standard deviation alone would underestimate the uncertainty of a mean of
correlated samples.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from poppet.bench.iso10094.scale import FloatArray
from poppet.timeseries.measurements.measurement import quantum_of

COVERAGE = 0.95
NORMAL = 1.959964  # half width of the 95 % interval of a normal distribution, in standard deviations
SHORT = 1.2  # variance of a mean of coloured noise relative to its estimate from a short record
LEAST_LEFT = 0.4  # smallest fraction of the slow noise that a polynomial leaves in a short record
LAGS = 24  # largest lag of the autocovariance [samples]
DRAWS = 400  # number of noise draws for the bias and the scatter of a maximum
DEGREES = 14  # highest degree of a polynomial fitted to a curve
SEED = 20


@dataclass(frozen=True)
class Uncertainty:
    """Uncertainty of a value, as the sum of a normal and a uniform distribution.

    `normal` is the standard deviation of the normal distribution, and `even` the half width of the uniform
    distribution.
    """

    normal: float
    even: float = 0.0
    # Ends of an asymmetric 95 % interval.
    ends: tuple[float, float] | None = None
    # Half width of a range of equal values in all repetitions, whose ends are as probable as its middle.
    common: float = 0.0

    @property
    def standard(self) -> float:
        """Standard uncertainty of the value, combined from all contributions."""
        return math.hypot(self.normal, self.even / math.sqrt(3.0), self.common / math.sqrt(3.0))

    def plus_normal(self, normal: float) -> Uncertainty:
        """Return the uncertainty with a further independent normal contribution.

        `normal` is the standard deviation of this contribution.
        """
        return Uncertainty(math.hypot(self.normal, normal), self.even, self.ends, self.common)

    def plus(self, addend: Uncertainty) -> Uncertainty:
        """Return the uncertainty of the sum or difference of two independent values.

        `addend` is the uncertainty of the second value. The larger of the two uniform distributions stays uniform; the
        smaller one is treated as normal.
        """
        small, even = sorted((self.even, addend.even))
        margin = NORMAL * math.hypot(addend.normal, addend.even / math.sqrt(3.0))
        ends = None if self.ends is None else (self.ends[0] - margin, self.ends[1] + margin)
        normal = math.hypot(self.normal, addend.normal, small / math.sqrt(3.0))
        return Uncertainty(normal, even, ends, self.common + addend.common)

    def interval(self, value: float) -> tuple[float, float]:
        """Return the limits of the 95 % confidence interval of the estimate `value`.

        Examples
        --------
        >>> [round(end, 3) for doubt in (Uncertainty(1.0), Uncertainty(0.0, 1.0)) for end in doubt.interval(0.0)]
        [-1.96, 1.96, -0.95, 0.95]
        """
        if self.ends is not None:
            return self.ends[0] - self.common, self.ends[1] + self.common
        half = NORMAL * self.normal
        if self.even > 0.0:
            normal = self.normal / self.even
            half, low, high = COVERAGE, 0.0, 1.0 + 3.0 * normal
            offsets = np.linspace(-1.0, 1.0, 65)  # of the uniform distribution
            for _ in range(40 if normal >= 1e-6 else 0):
                half = 0.5 * (low + high)
                probability = np.mean([_phi((half - u) / normal) - _phi((-half - u) / normal) for u in offsets])
                low, high = (half, high) if probability < COVERAGE else (low, half)
            half *= self.even
        half += self.common
        return value - half, value + half


def _phi(x: float) -> float:
    return 0.5 * (1.0 + math.erf(x / math.sqrt(2.0)))


# Noise -------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Noise:
    """Noise of a series, described by its autocovariance at lags of 0, 1, ... samples."""

    covariance: FloatArray

    @property
    def sigma(self) -> float:
        """Standard deviation of a single sample."""
        return math.sqrt(float(self.covariance[0]))

    def of(self, weights: FloatArray) -> float:
        """Return the standard deviation of a weighted sum of consecutive noisy samples.

        `weights` contains one factor per sample.
        """
        lags = min(self.covariance.size, weights.size)
        products = np.array([float(weights[k:] @ weights[: weights.size - k]) for k in range(lags)])
        products[1:] *= 2.0
        return math.sqrt(max(float(products @ self.covariance[:lags]), 0.0))

    @property
    def spread(self) -> float:
        """Standard deviation of white noise with the same effect on means of many samples."""
        total = float(self.covariance[0]) + 2.0 * float(np.sum(self.covariance[1:]))
        return math.sqrt(SHORT * max(total, 0.25 * float(self.covariance[0])))

    def mean(self, count: int) -> float:
        """Return the standard deviation of the mean of `count` consecutive samples."""
        return self.spread / math.sqrt(max(1, count))

    def at(self, turn: float) -> float:
        """Return the standard deviation of white noise with the same power at one frequency.

        `turn` is the angular frequency [rad/sample].
        """
        lags = np.arange(1, self.covariance.size)
        total = float(self.covariance[0]) + 2.0 * float(np.sum(self.covariance[1:] * np.cos(turn * lags)))
        return math.sqrt(max(total, 0.5 * float(self.covariance[0])))


def estimate_noise(parts: Sequence[FloatArray], degree: int = 1) -> Noise:
    """Estimate the common noise of several series from residuals about fitted polynomials.

    `parts` are the series, and `degree` is the degree of the polynomials.

    Examples
    --------
    >>> x = np.random.default_rng(1).normal(0.0, 0.3, 4000)
    >>> found = estimate_noise([x, x + np.linspace(0.0, 9.0, 4000)])
    >>> round(found.sigma, 2), abs(found.spread / 0.3 - 1.0) < 0.1
    (0.3, True)
    """
    residuals = []
    for part in (part for part in parts if part.size > degree + 3):
        positions = np.linspace(-1.0, 1.0, part.size)
        coefficients = np.polynomial.legendre.legfit(positions, part, degree)
        residuals.append(part - np.polynomial.legendre.legval(positions, coefficients))
    if not residuals:
        return Noise(np.zeros(1))
    count = sum(residual.size for residual in residuals)
    lags = max(1, min(LAGS, min(residual.size for residual in residuals) // 4))
    covariance = np.zeros(lags)
    for residual in residuals:
        covariance += [float(residual[k:] @ residual[: residual.size - k]) for k in range(lags)]
    covariance /= max(1, count - (degree + 1) * len(residuals))
    # The autocovariance ends at the first insignificant lag.
    small = np.flatnonzero(np.abs(covariance) < 2.0 * covariance[0] / math.sqrt(count))
    covariance = covariance[: int(small[0])] if small.size and small[0] else covariance
    # Each coefficient of a polynomial removes slow noise from all lags.
    slow = float(np.sum(covariance[1:]))
    if slow > 0.0:
        removed = (degree + 1) * len(residuals) * 2.0 * (covariance.size - 1) / count
        total = (float(covariance[0]) + 2.0 * slow) / max(1.0 - removed, LEAST_LEFT)
        covariance[1:] *= (total - float(covariance[0])) / (2.0 * slow)
    floor = max(quantum_of(part) for part in parts) ** 2 / 12.0
    covariance[0] = max(float(covariance[0]), floor)
    return Noise(covariance)


# Curves ------------------------------------------------------------------------------------------------------------


def curve_noise(rows: FloatArray, stride: int = 1) -> float:
    """Estimate the standard deviation of the noise of smooth curves.

    `rows` has shape (curves, grid points), with values on an equidistant grid. The estimate uses second differences of
    values that are `stride` grid points apart.

    Examples
    --------
    >>> x = np.random.default_rng(1).normal(0.0, 0.3, (20, 101)) + np.linspace(0.0, 1.0, 101) ** 2
    >>> abs(curve_noise(x) - 0.3) < 0.03
    True
    """
    bends = rows[:, 2 * stride :] - 2.0 * rows[:, stride:-stride] + rows[:, : -2 * stride]
    bends = np.abs(bends[np.isfinite(bends)]) / math.sqrt(6.0)
    if not bends.size:
        return 0.0
    sigma = 1.4826 * float(np.median(bends))  # the median ignores a few bends of the curve
    inliers = bends[bends <= 4.0 * sigma]
    return float(np.sqrt(np.mean(inliers**2))) if inliers.size else 0.0


@dataclass(frozen=True, eq=False)
class SmoothCurve:
    """Polynomial fitted to a noisy curve, with the standard deviation of its coefficients.

    `values` are its values at the n grid points.
    """

    values: FloatArray
    basis: FloatArray  # (n, m), orthonormal basis of the remaining noise
    sigma: float  # standard deviation of each coefficient
    # Number of selected columns of the basis; further columns contribute to the uncertainty only.
    kept: int

    def draws(self, random: np.random.Generator) -> tuple[FloatArray, FloatArray]:
        """Return random curves with the noise that remains after smoothing.

        Both arrays have one curve per row. In the first array, only the `kept` coefficients of the fit vary. In the
        second array, the coefficients that the fit omits also vary.
        """
        chance = self.sigma * random.standard_normal((DRAWS, self.basis.shape[1]))
        selected = self.values + chance[:, : self.kept] @ self.basis[:, : self.kept].T
        return selected, self.values + chance @ self.basis.T

    def error(self, weights: FloatArray) -> float:
        """Return the standard deviation of a weighted sum of the values of the curve.

        `weights` contains one factor per value.
        """
        return self.sigma * float(np.linalg.norm(weights @ self.basis))


def smooth(grid: FloatArray, values: FloatArray, sigma: float, share: float = 1.0) -> SmoothCurve:
    """Fit the polynomial of the lowest degree that represents a curve within its noise.

    `sigma` is the standard deviation of the noise of one value. Groups of `share` neighbouring values have the same
    noise, because they come from the same samples. If no polynomial fits, the result contains the original values.

    Examples
    --------
    >>> x = np.linspace(0.0, 1.0, 81)
    >>> found = smooth(x, 2.0 + x**2 + np.random.default_rng(1).normal(0.0, 0.1, 81), 0.1)
    >>> found.kept <= 4, bool(np.max(np.abs(found.values - 2.0 - x**2)) < 0.1)
    (True, True)
    """
    count = grid.size
    spread = sigma * math.sqrt(share)
    if sigma <= 1e-9 * max(1e-300, float(np.max(np.abs(values)))) or count < 8:
        return SmoothCurve(values, np.eye(count), sigma, count)
    positions = 2.0 * (grid - grid[0]) / (grid[-1] - grid[0]) - 1.0
    highest = min(DEGREES, count // 3)
    basis = np.linalg.qr(np.polynomial.legendre.legvander(positions, highest))[0]
    coefficients = basis.T @ values
    residual = float(values @ values) - np.cumsum(coefficients**2)
    parameters = np.arange(1, highest + 2)
    # Akaike's criterion for known noise.
    score = np.maximum(residual, 0.0) / spread**2 + COST * parameters
    best = int(np.argmin(score))
    freedom = (count - best - 1) / share
    if residual[best] / spread**2 > freedom + 4.0 * math.sqrt(2.0 * freedom):
        return SmoothCurve(values, np.eye(count), sigma, count)
    return SmoothCurve(
        basis[:, : best + 1] @ coefficients[: best + 1], basis[:, : best + 1 + OMITTED], spread, best + 1
    )


COST = 3.0  # penalty of a coefficient in the sum of squares, in variances of the noise
OMITTED = 3  # further coefficients that contribute to the uncertainty, because small true ones cannot be seen


def correct_noise_bias(
    curves: Sequence[SmoothCurve], functional: Callable[[list[FloatArray]], FloatArray]
) -> tuple[float, Uncertainty]:
    """Return a nonlinear function of noisy curves, corrected for the bias by noise.

    `functional` is this function, for example a maximum. Its argument is a list of arrays of shape (draws, n), one per
    curve, and its result is one value per draw. Random draws of the noise give the bias and the uncertainty.

    Examples
    --------
    >>> curve = SmoothCurve(np.zeros(81), np.eye(81), 1.0, 81)
    >>> value, doubt = correct_noise_bias([curve], lambda draws: np.max(draws[0], axis=1))
    >>> value < -2.0
    True
    """
    random = np.random.default_rng(SEED)
    biased = float(functional([curve.values[None, :] for curve in curves])[0])
    selected, complete = zip(*(curve.draws(random) for curve in curves), strict=True)
    bias = float(np.mean(functional(list(selected)))) - biased
    return biased - bias, Uncertainty(math.hypot(float(np.std(functional(list(complete)))), bias))


# Repetition --------------------------------------------------------------------------------------------------------


def mean_of(values: Sequence[float], uncertainties: Sequence[Uncertainty]) -> tuple[float, Uncertainty]:
    """Return the mean of repeated values and its uncertainty.

    The uncertainty includes the scatter of the values. The field `common` of the uncertainties is the half width of a
    range that contains the error of each value. The errors within this range are assumed to be equal in all
    repetitions. If the values differ by more than their noise, this assumption is not possible. The result is then the
    overlap of the ranges of all values.

    Examples
    --------
    >>> value, doubt = mean_of([1.0, 3.0], [Uncertainty(0.1), Uncertainty(0.1)])
    >>> value, doubt.standard > 0.9
    (2.0, True)
    >>> mean_of([1.0, 1.5], [Uncertainty(0.0, common=0.5), Uncertainty(0.0, common=0.5)])
    (1.25, Uncertainty(normal=0.0, even=0.25, ends=None, common=0.0))
    """
    if len(values) == 1:
        return float(values[0]), uncertainties[0]
    common = float(np.mean([uncertainty.common for uncertainty in uncertainties]))
    variance = float(np.mean([replace(uncertainty, common=0.0).standard ** 2 for uncertainty in uncertainties]))
    excess = max(0.0, float(np.var(values, ddof=1)) - variance * SCATTER - 2.0 * common**2)
    scatter = float(np.ptp(values)) - NORMAL * math.sqrt(2.0 * variance)
    if common > 0.0 and scatter > 0.0:
        middle = 0.5 * (max(values) + min(values))
        half_width = max(common - 0.5 * scatter, 0.0)
        return middle, Uncertainty(math.sqrt(0.5 * variance + excess / len(values)), half_width)
    return float(np.mean(values)), Uncertainty(math.sqrt((variance + excess) / len(values)), common=common)


SCATTER = 3.0  # ratio of scatter to noise variance that can occur by chance in a few repetitions


def greatest(values: Sequence[float], uncertainties: Sequence[Uncertainty]) -> tuple[float, Uncertainty, int]:
    """Return the largest of several noisy values, its uncertainty and its index.

    The largest of several noisy values is too large on average. The function therefore shrinks the values towards their
    mean if noise explains their scatter (R. DerSimonian and N. Laird, Controlled Clinical Trials 7 (1986) 177-188).
    Values that differ by much more than the noise change only slightly.

    Examples
    --------
    >>> value, doubt, place = greatest([2.0, 2.1, 2.1], [Uncertainty(0.1), Uncertainty(0.1), Uncertainty(0.1)])
    >>> round(value, 2), round(doubt.standard, 3)
    (2.07, 0.067)
    >>> round(greatest([1.0, 2.0, 9.0], [Uncertainty(0.1), Uncertainty(0.1), Uncertainty(0.1)])[0], 2)
    9.0
    """
    # A common range shifts all values alike.
    common = max(uncertainty.common for uncertainty in uncertainties)
    spread = np.array([replace(uncertainty, common=0.0).standard for uncertainty in uncertainties])
    array = np.array(values, dtype=np.float64)
    top = int(np.argmax(array))
    if array.size == 1 or not spread.min() > 0.0:
        return float(array[top]), uncertainties[top], top
    weights = spread**-2.0
    total = float(weights.sum())
    mean = float(weights @ array) / total
    freedom = array.size - 1
    excess = float(weights @ (array - mean) ** 2) - freedom - math.sqrt(2.0 * freedom)
    variance_between = max(0.0, excess / (total - float(weights @ weights) / total))
    weight = variance_between / (variance_between + spread**2)
    shrunk = mean + weight * (array - mean)
    k = int(np.argmax(shrunk))
    shift = 0.5 * (1.0 - weight[k]) * (array[k] - mean)
    error = math.hypot(math.sqrt(weight[k]) * spread[k], (1.0 - weight[k]) * total**-0.5, shift)
    return float(shrunk[k]), Uncertainty(error, common=common), k
