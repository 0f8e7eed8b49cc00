"""What a fit is worth: standard errors, correlations, verdicts, whiteness, information criterion."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from poppet.identify.fit.search import Optimum
from poppet.identify.fit.spread import Spread, pulls
from poppet.identify.free import Free
from poppet.identify.result import CONFIDENCE, Estimate, Verdict

Array = NDArray[np.float64]

DETERMINED, WEAK = 0.1, 0.5
"""Half the interval over the size of the number: below the first it is determined, above the second it is not."""
DETERMINED_RATIO, WEAK_RATIO = 0.05, 0.15
"""The same for dimensionless numbers of finite range, as part of it: critical ratios lie between 0.1 and 0.55."""


def covariance(optimum: Optimum) -> Array:
    """Covariance of the free numbers for white noise; those at a bound have their own variance only."""
    rows = pulls(optimum)
    dead = ~np.all(np.isfinite(rows), axis=1)
    rows[dead] = 0.0
    result = rows @ rows.T
    own = np.where(dead, np.inf, np.diag(result))
    outside = optimum.active != 0
    result[outside, :] = result[:, outside] = 0.0
    result[np.diag_indices_from(result)] = own
    return np.asarray(result)


def estimates(free: Sequence[Free], optimum: Optimum, spread: Spread) -> dict[str, Estimate]:
    """Values with 95 % intervals and verdicts."""
    from scipy.stats import t

    freedom = max(1, optimum.residual.size - optimum.x.size)
    quantile = float(t.ppf(0.5 + 0.5 * CONFIDENCE, freedom))
    errors = [spread.deviation(pull) for pull in pulls(optimum)]
    result = {}
    for f, value, error, active in zip(free, optimum.x, errors, optimum.active, strict=True):
        half = quantile * error
        low, high = max(f.low, value - half), min(f.high, value + half)
        result[f.name] = Estimate(
            float(value),
            f.unit,
            error,
            float(low),
            float(high),
            verdict(f, float(value), half, int(active)),
            f.start,
        )
    return result


def verdict(f: Free, value: float, half: float, active: int) -> Verdict:
    """Whether the data determine a number: its interval against its own size, or against its finite range."""
    if active:
        return "at bound"
    span = f.high - f.low
    is_ratio = f.unit == "1" and np.isfinite(span)
    size = span if is_ratio else max(abs(value), 1e-300)
    determined, weak = (DETERMINED_RATIO, WEAK_RATIO) if is_ratio else (DETERMINED, WEAK)
    if not np.isfinite(half) or half > weak * size:
        return "not determined"
    return "determined" if half <= determined * size else "weak"


def correlation(free: Sequence[Free], optimum: Optimum) -> dict[str, dict[str, float]]:
    """Correlations between the estimates that lie inside their bounds."""
    matrix = covariance(optimum)
    sd = np.sqrt(np.diag(matrix))
    table: dict[str, dict[str, float]] = {}
    for i, a in enumerate(free):
        row = {}
        for j, b in enumerate(free):
            if (
                i != j
                and np.isfinite(sd[i] * sd[j])
                and sd[i] * sd[j] > 0.0
                and not optimum.active[i]
                and not optimum.active[j]
            ):
                row[b.name] = float(np.clip(matrix[i, j] / (sd[i] * sd[j]), -1.0, 1.0))
        if row:
            table[a.name] = row
    return table


def aicc(pieces: Sequence[Array], n_free: int) -> float:
    """Corrected information criterion of a joint Gaussian likelihood, the variance of every channel estimated."""
    n, k = sum(piece.size for piece in pieces), n_free + len(pieces)
    log_likelihood = -sum(
        0.5 * p.size * (np.log(2.0 * np.pi * max(float(np.mean(p**2)), 1e-300)) + 1.0) for p in pieces
    )
    return float(2.0 * k - 2.0 * log_likelihood + (2.0 * k * (k + 1.0) / (n - k - 1.0) if n > k + 1 else np.inf))
