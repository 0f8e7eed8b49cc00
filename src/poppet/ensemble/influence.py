"""Which numbers matter: first and total Sobol indices with intervals from a sample that is made for them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from poppet.ensemble.ensemble_plan import Array

RESAMPLES = 500
_SEED = 1


@dataclass(frozen=True)
class SobolIndex:
    """Part of the variance of a metric that one factor makes, with intervals of 95 %."""

    factor: str  # address of a number; `from_fit` for the joint ones together
    first: float  # by itself
    first_low: float
    first_high: float
    total: float  # with all that it does together with others
    total_low: float
    total_high: float


def sobol_indices(values: Array, factors: Sequence[str]) -> list[SobolIndex]:
    r"""First and total indices of a metric.

    .. math::
        S_j = \frac{\overline{f_B (f_{AB_j} - f_A)}}{V}, \qquad
        S_{Tj} = \frac{\overline{(f_A - f_{AB_j})^2}}{2 V}

    Parameters
    ----------
    values : (n_factors + 2, n) array
        The metric in the runs of A, of B, and of A with the columns of each factor from B.
    factors : sequence of str
        Their names.

    Returns
    -------
    list of Index
        In the order of the factors; zero where the metric does not vary.

    Notes
    -----
    Estimators of Saltelli et al., Comput. Phys. Commun. 181 (2010) 259, table 2: (b) for the first, (f), which is
    Jansen's, for the total. Intervals are those of the percentile bootstrap over rows. Valid for factors that are
    independent of one another; rows with a value that is not finite are left out.
    """
    rows = values[:, np.isfinite(values).all(axis=0)]
    n = rows.shape[1]
    if n < 2:
        return [SobolIndex(name, *[np.nan] * 6) for name in factors]
    best = _both(rows)
    random = np.random.Generator(np.random.Philox(key=_SEED))
    drawn = np.array([_both(rows[:, random.integers(n, size=n)]) for _ in range(RESAMPLES)])
    low, high = np.quantile(drawn, (0.025, 0.975), axis=0)
    return [
        SobolIndex(name, *(float(each[order, k]) for order in (0, 1) for each in (best, low, high)))
        for k, name in enumerate(factors)
    ]


def _both(rows: Array) -> Array:
    """First and total indices, (2, n_factors)."""
    # Estimates of the first are better where the mean is gone.
    f = rows - rows[:2].mean()
    a, b, mixed = f[0], f[1], f[2:]
    variance = f[:2].var()
    if not variance > 0.0:
        return np.zeros((2, len(mixed)))
    first, total = (b * (mixed - a)).mean(axis=1), 0.5 * ((a - mixed) ** 2).mean(axis=1)
    return np.asarray(np.stack([first, total]) / variance)
