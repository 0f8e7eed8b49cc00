"""Tests of residuals for white noise, and their correlation time."""

from __future__ import annotations

import numpy as np

from poppet.timeseries.checks import FloatArray as Array

WHITE = 0.001
"""Probability below which residuals count as correlated."""
LAGS = 10
"""Number of lags of the portmanteau test."""
WHITE_SHORT, SHORT = 0.02, 100
"""Probability for short series, and their maximum size: the tests have little power there."""


def runs_probability(residual: Array) -> float:
    """Return the two-sided probability of the number of runs of one sign (Wald & Wolfowitz)."""
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


def portmanteau_probability(residual: Array) -> float:
    """Return the probability of the correlations over a few samples (Ljung & Box 1978).

    It detects a slow lack of fit that is small compared with the noise and does not change the signs.
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


def whiteness(residual: Array) -> float:
    """Return the lower probability of the runs test and the portmanteau test."""
    return min(runs_probability(residual), portmanteau_probability(residual))


def is_white(residual: Array) -> bool:
    """Return False if a test rejects that the residuals are white noise."""
    return whiteness(residual) >= (WHITE if residual.size >= SHORT else WHITE_SHORT)


def correlation_time(residual: Array) -> float:
    """Return the integrated autocorrelation time in samples, at least 1."""
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
