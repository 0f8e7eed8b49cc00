"""Statistics over all runs: yields, moments, quantiles and effects of parameters."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from poppet.ensemble.dataset import Dataset
from poppet.ensemble.ensemble_plan import Array
from poppet.ensemble.metrics import Metric

LEVELS = (0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99)
"""Probabilities of the quantiles of a metric."""
_Z = 1.959963984540054
"""Quantile of the standard normal distribution for a 95 % confidence interval."""


@dataclass(frozen=True)
class Yield:
    """Fraction of runs that meet a requirement, with its 95 % confidence interval."""

    name: str
    text: str
    good: int
    runs: int
    low: float
    high: float

    @property
    def share(self) -> float:
        """Fraction of runs that meet the requirement."""
        return self.good / self.runs if self.runs else math.nan


@dataclass(frozen=True)
class Summary:
    """Statistics of a metric over all runs, in the unit of the metric."""

    name: str
    unit: str
    count: int  # runs with a finite value
    never: int  # runs without the event; their value is infinite
    failed: int  # runs without a value
    mean: float
    sd: float
    least: float
    greatest: float
    quantiles: dict[float, float]  # of the finite values


@dataclass(frozen=True)
class TornadoRange:
    """Values of a metric at a low quantile, the median and a high quantile of one parameter.

    All other parameters have their medians.
    """

    address: str
    middle: float
    low: float
    high: float

    @property
    def size(self) -> float:
        """Absolute difference between the metric at the high and at the low quantile."""
        size = abs(self.high - self.low)
        return size if math.isfinite(size) else math.inf


def wilson(n_good: int, runs: int) -> tuple[float, float]:
    r"""Return the 95 % confidence interval of a fraction, by the method of Wilson.

    .. math:: \frac{k + z^2/2}{n + z^2} \pm \frac{z}{n + z^2} \sqrt{\frac{k (n - k)}{n} + \frac{z^2}{4}}

    Parameters
    ----------
    n_good, runs : int
        Number k of successful runs, and number n of all runs.

    Returns
    -------
    tuple of float
        Limits of the interval; 0 and 1 without runs.

    Notes
    -----
    z is 1.96. Source: Wilson, J. Am. Stat. Assoc. 22 (1927) 209. The mean coverage is 95 % for independent runs. It is
    larger for a Latin hypercube or a scrambled Sobol sequence, which fill the space more evenly.

    Examples
    --------
    >>> [round(end, 4) for end in wilson(90, 100)]
    [0.8256, 0.9448]
    """
    if not runs:
        return 0.0, 1.0
    z2 = _Z * _Z
    middle = (n_good + 0.5 * z2) / (runs + z2)
    half = _Z / (runs + z2) * math.sqrt(n_good * (runs - n_good) / runs + 0.25 * z2)
    return max(0.0, middle - half) if n_good else 0.0, min(1.0, middle + half) if n_good < runs else 1.0


def summary_of(dataset: Dataset, metric: Metric, max_values: int) -> Summary:
    """Return the statistics of a metric over all runs.

    To limit the memory, quantiles use only the first `max_values` values.
    """
    count = never = failed = 0
    mean = moment = 0.0
    least, greatest = math.inf, -math.inf
    first: list[np.ndarray] = []
    for shard in dataset.shards("runs", [metric.name]):
        values = shard[metric.name]
        finite = values[np.isfinite(values)]
        never += int(np.isinf(values).sum())
        failed += int(np.isnan(values).sum())
        if sum(map(len, first)) < max_values:
            first.append(finite)
        if finite.size:
            # Chan, Golub and LeVeque: combine the moments of two sets.
            shard_mean, n = float(finite.mean()), finite.size
            difference = shard_mean - mean
            moment += float(((finite - shard_mean) ** 2).sum()) + difference**2 * count * n / (count + n)
            mean += difference * n / (count + n)
            count += n
            least, greatest = min(least, float(finite.min())), max(greatest, float(finite.max()))
    sample = np.concatenate(first) if first else np.empty(0)
    quantiles = dict(zip(LEVELS, np.quantile(sample, LEVELS).tolist(), strict=True)) if sample.size else {}
    if not count:
        mean = least = greatest = math.nan
    sd = math.sqrt(moment / (count - 1)) if count > 1 else math.nan
    return Summary(metric.name, metric.unit, count, never, failed, mean, sd, least, greatest, quantiles)


# --- Sobol indices ---

RESAMPLES = 500
_SEED = 1


@dataclass(frozen=True)
class SobolIndex:
    """Sobol indices of one factor: fractions of the variance of a metric that are due to it.

    Each index has a 95 % confidence interval.
    """

    factor: str  # address of a parameter; `from_fit` for all parameters of a fit
    first: float  # first order: factor alone
    first_low: float
    first_high: float
    total: float  # with all interactions
    total_low: float
    total_high: float


def sobol_indices(values: Array, factors: Sequence[str]) -> list[SobolIndex]:
    r"""Return the first-order and total Sobol indices of a metric for each factor.

    .. math::
        S_j = \frac{\overline{f_B (f_{AB_j} - f_A)}}{V}, \qquad
        S_{Tj} = \frac{\overline{(f_A - f_{AB_j})^2}}{2 V}

    Parameters
    ----------
    values : (n_factors + 2, n) array
        Metric of the runs of two independent samples A and B, then of A with the columns of each factor from B.
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
    """Return the first-order and the total Sobol indices of a metric, (2, n_factors).

    `rows`, (n_factors + 2, n), contains the metric in the blocks A and B of the sample, then in one block for each
    factor: block A with the columns of the factor from B.
    """
    # Subtract the mean: it increases the variance of the first-order estimator.
    f = rows - rows[:2].mean()
    a, b, mixed = f[0], f[1], f[2:]
    variance = f[:2].var()
    if not variance > 0.0:
        return np.zeros((2, len(mixed)))
    first, total = (b * (mixed - a)).mean(axis=1), 0.5 * ((a - mixed) ** 2).mean(axis=1)
    return np.asarray(np.stack([first, total]) / variance)
