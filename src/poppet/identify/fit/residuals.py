"""Residuals of a fit: loss functions, tests for white noise, correlation time, rounding.

References
----------
Triggs, McLauchlan, Hartley & Fitzgibbon 2000, Bundle adjustment, in: Vision Algorithms: Theory and Practice, Lecture
Notes in Computer Science 1883, 298-372, section 4.3 (second-order weights of robust losses).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from poppet.timeseries.checks import FloatArray

LOSSES = ("linear", "soft_l1", "huber", "cauchy")
FLAT = 1e-16
"""Minimum curvature of a loss, relative to that of half a square."""


def costs_of(residual: FloatArray, loss: str) -> FloatArray:
    """Return the contribution of each weighted residual to the cost.

    For the linear loss it is half the square. For a robust loss it is half of rho in SciPy's notation.
    """
    squares = residual**2
    if loss == "soft_l1":
        squares = 2.0 * (np.sqrt(1.0 + squares) - 1.0)
    elif loss == "huber":
        squares = np.where(squares <= 1.0, squares, 2.0 * np.sqrt(squares) - 1.0)
    elif loss == "cauchy":
        squares = np.log1p(squares)
    return np.asarray(0.5 * squares)


def weights_of(residual: FloatArray, loss: str) -> FloatArray:
    """Return the factor by which a robust loss weights each residual in the gradient of the cost.

    The factor is rho' in SciPy's notation; it is 1 for the linear loss.
    """
    if loss == "soft_l1":
        return np.asarray(1.0 / np.sqrt(1.0 + residual**2))
    if loss == "huber":
        return np.asarray(1.0 / np.maximum(1.0, np.abs(residual)))
    return np.asarray(1.0 / (1.0 + residual**2)) if loss == "cauchy" else np.ones(residual.size)


def curvatures_of(residual: FloatArray, loss: str) -> FloatArray:
    """Return the factor by which a robust loss weights each residual in the curvature of the cost.

    The factor is rho' + 2 r^2 rho'' in SciPy's notation, with a positive lower limit.
    """
    weights = weights_of(residual, loss)
    if loss == "soft_l1":
        weights = weights**3
    elif loss == "huber":
        weights = np.where(weights < 1.0, 0.0, 1.0)
    elif loss == "cauchy":
        weights = 2.0 * weights**2 - weights
    return np.asarray(np.maximum(weights, FLAT))


# White noise ----------------------------------------------------------------------------------------------------------

WHITE = 0.001
"""Probability below which residuals count as correlated."""
LAGS = 10
"""Number of lags of the portmanteau test."""
WHITE_SHORT, SHORT = 0.02, 100
"""Probability for short series, and their maximum size: the tests have little power there."""


def runs_probability(residual: FloatArray) -> float:
    """Return the two-sided p-value of the runs test (Wald & Wolfowitz).

    A run is a sequence of residuals on the same side of the median. A small p-value indicates a lack of fit.
    """
    from scipy.special import erfc

    # Use the median: a bias is not a correlation and has a separate test.
    signs = residual[residual != 0.0] > np.median(residual)
    n1, n2 = int(signs.sum()), int((~signs).sum())
    if n1 < 5 or n2 < 5:
        return 1.0
    runs = 1 + int(np.count_nonzero(signs[1:] != signs[:-1]))
    mean = 1.0 + 2.0 * n1 * n2 / (n1 + n2)
    variance = (mean - 1.0) * (mean - 2.0) / (n1 + n2 - 1.0)
    return float(erfc(abs(runs - mean) / np.sqrt(2.0 * variance)))


def portmanteau_probability(residual: FloatArray) -> float:
    """Return the p-value of a test of the autocorrelations at small lags (Ljung & Box 1978).

    The test detects a slow lack of fit that is too small, compared with the noise, to change the signs of residuals.
    """
    from scipy.special import chdtrc

    n, lags = residual.size, min(LAGS, residual.size // 5)
    centred = residual - residual.mean()
    variance = float(centred @ centred)
    if lags < 1 or variance <= 0.0:
        return 1.0
    rho = [float(centred[k:] @ centred[:-k]) / variance for k in range(1, lags + 1)]
    statistic = n * (n + 2.0) * sum(r * r / (n - k) for k, r in enumerate(rho, start=1))
    return float(chdtrc(lags, statistic))


def whiteness(residual: FloatArray) -> float:
    """Return the smaller p-value of two tests for white noise: runs test and portmanteau test.

    A small value is evidence that the residuals are not white noise.
    """
    return min(runs_probability(residual), portmanteau_probability(residual))


def is_white(residual: FloatArray) -> bool:
    """Return True unless a test shows that the residuals are not white noise."""
    return whiteness(residual) >= (WHITE if residual.size >= SHORT else WHITE_SHORT)


def correlation_time(residual: FloatArray) -> float:
    """Return the autocorrelation time of residuals, in samples, which is at least 1.

    It is the number of samples that corresponds to one independent value.
    """
    centred = residual - residual.mean()
    variance = float(centred @ centred)
    if variance <= 0.0 or residual.size < 8:
        return 1.0
    total = 1.0
    for lag in range(1, residual.size // 3):
        rho = float(centred[lag:] @ centred[:-lag]) / variance
        if rho < 0.05:  # beyond, the noise of the correlations would add up
            break
        total += 2.0 * rho
    return float(min(total, residual.size / 3.0))


# Rounding -------------------------------------------------------------------------------------------------------------

HARMONICS = 24
"""Number of harmonics of the rounding error; the omitted harmonics contain 2 % of the variance."""
QUIET = 1e-3
"""Relative amplitude below which noise suppresses a harmonic."""


class Staircase(NamedTuple):
    r"""Rounding error of a coarse sensor, if noise is too small to average it out.

    .. math:: e(x) = \sum_h a_h \sin\Big(\frac{2 \pi h x}{q} + \varphi_h\Big), \qquad
        a_h = \frac{q}{\pi h} \exp\Big(-\frac{2 \pi^2 h^2 \sigma^2}{q^2}\Big)

    x is the value before rounding, q the resolution step, sigma the noise, h the order of the harmonic, and phi_h its
    phase. `waves`, (2 n_harmonics, n), gives the variance of a weighted sum of e: multiply `waves` by the weights and
    add the squares of the products. `square` is the variance of e. Without noise and drift, this variance is q^2/12,
    and the error is equal in all samples.

    References
    ----------
    JCGM 100:2008 (GUM), F.2.2.1; Widrow & Kollar 2008, Quantization Noise, chapter 4 (sigma of the dither).
    """

    waves: FloatArray
    square: float

    def excess(self, weights: FloatArray) -> float:
        """Return the variance of a weighted sum of rounding errors, minus the variance for independent errors.

        `weights` contains the factor on each sample. The independent errors have the same size.
        """
        return float(np.sum((self.waves @ weights) ** 2)) - self.square * float(weights @ weights)


def staircase(values: FloatArray, quantum: float, noise: float) -> Staircase | None:
    """Return a model of the rounding errors in readings of coarse resolution.

    `quantum` is the resolution, and `noise` the standard deviation of the noise. The result is None if the noise hides
    the steps.
    """
    order = np.arange(1, HARMONICS + 1)
    smooth = np.exp(-2.0 * (np.pi * order * noise / quantum) ** 2)
    order, smooth = order[smooth > QUIET], smooth[smooth > QUIET]
    if not order.size:
        return None
    phase = 2.0 * np.pi / quantum * order[:, None] * values
    size = (quantum / np.pi * smooth / order / np.sqrt(2.0))[:, None]
    return Staircase(np.vstack([size * np.cos(phase), size * np.sin(phase)]), float(np.sum(size**2)))
