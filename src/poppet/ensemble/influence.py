"""First-order and total Sobol indices with confidence intervals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from poppet.ensemble.ensemble_plan import Array

RESAMPLES = 500
_SEED = 1


@dataclass(frozen=True)
class SobolIndex:
    """Fractions of the variance of a metric due to one factor, with 95 % intervals."""

    factor: str  # address of a parameter; `from_fit` for all parameters of a fit
    first: float  # first order: factor alone
    first_low: float
    first_high: float
    total: float  # with all interactions
    total_low: float
    total_high: float


def sobol_indices(values: Array, factors: Sequence[str]) -> list[SobolIndex]:
    r"""Return first-order and total indices of a metric.

    .. math::
        S_j = \frac{\overline{f_B (f_{AB_j} - f_A)}}{V}, \qquad
        S_{Tj} = \frac{\overline{(f_A - f_{AB_j})^2}}{2 V}

    Parameters
    ----------
    values : (n_factors + 2, n) array
        Metric of the runs of A, of B, and of A with the columns of each factor from B.
    factors : sequence of str
        Names of the factors.

    Returns
    -------
    list of SobolIndex
        In the order of the factors; zero if the metric does not vary.

    Notes
    -----
    Estimators of Saltelli et al., Comput. Phys. Commun. 181 (2010) 259, table 2: (b) for the first order, (f)
    by Jansen for the total. Intervals are from the percentile bootstrap over rows. The factors must be independent of
    one another. Rows with a value that is not finite are omitted.
    """
    rows = values[:, np.isfinite(values).all(axis=0)]
    n = rows.shape[1]
    if n < 2:
        return [SobolIndex(name, *[np.nan] * 6) for name in factors]
    best = _first_and_total(rows)
    random = np.random.Generator(np.random.Philox(key=_SEED))
    resamples = np.array([_first_and_total(rows[:, random.integers(n, size=n)]) for _ in range(RESAMPLES)])
    low, high = np.quantile(resamples, (0.025, 0.975), axis=0)
    return [
        SobolIndex(name, *(float(estimate[order, k]) for order in (0, 1) for estimate in (best, low, high)))
        for k, name in enumerate(factors)
    ]


def _first_and_total(rows: Array) -> Array:
    """Return first-order and total indices, (2, n_factors)."""
    # Subtract the mean: it increases the variance of the first-order estimator.
    f = rows - rows[:2].mean()
    a, b, mixed = f[0], f[1], f[2:]
    variance = f[:2].var()
    if not variance > 0.0:
        return np.zeros((2, len(mixed)))
    first, total = (b * (mixed - a)).mean(axis=1), 0.5 * ((a - mixed) ** 2).mean(axis=1)
    return np.asarray(np.stack([first, total]) / variance)
