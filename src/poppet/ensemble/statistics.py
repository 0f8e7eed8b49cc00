"""Statistics of runs: yields, moments, quantiles and effects of parameters."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from poppet.ensemble.dataset import Dataset
from poppet.ensemble.metrics import Metric

LEVELS = (0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99)
"""Quantiles of a metric."""
_Z = 1.959963984540054
"""Normal quantile of a 95 % interval."""


@dataclass(frozen=True)
class Yield:
    """Fraction of runs that meet a requirement, with its 95 % interval."""

    name: str
    text: str
    good: int
    runs: int
    low: float
    high: float

    @property
    def share(self) -> float:
        """Fraction of good runs."""
        return self.good / self.runs if self.runs else math.nan


@dataclass(frozen=True)
class Summary:
    """Statistics of a metric over all runs, in its unit."""

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
    """Values of a metric at the medians, and at a low and a high quantile of one parameter."""

    address: str
    middle: float
    low: float
    high: float

    @property
    def size(self) -> float:
        """Absolute difference of the two values."""
        size = abs(self.high - self.low)
        return size if math.isfinite(size) else math.inf


def wilson(n_good: int, runs: int) -> tuple[float, float]:
    r"""Return the 95 % interval of a fraction.

    .. math:: \frac{k + z^2/2}{n + z^2} \pm \frac{z}{n + z^2} \sqrt{\frac{k (n - k)}{n} + \frac{z^2}{4}}

    Parameters
    ----------
    n_good, runs : int
        k of n.

    Returns
    -------
    tuple of float
        Limits of the interval; 0 and 1 without runs.

    Notes
    -----
    Wilson, J. Am. Stat. Assoc. 22 (1927) 209. The mean coverage is 95 % for independent runs. It is larger for
    a Latin hypercube or a scrambled Sobol sequence, which fill the space more evenly.

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
    """Return statistics of a metric over all runs; quantiles use the first `max_values` runs."""
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
    values_of_quantiles = np.concatenate(first) if first else np.empty(0)
    quantiles = (
        dict(zip(LEVELS, np.quantile(values_of_quantiles, LEVELS).tolist(), strict=True))
        if values_of_quantiles.size
        else {}
    )
    if not count:
        mean = least = greatest = math.nan
    sd = math.sqrt(moment / (count - 1)) if count > 1 else math.nan
    return Summary(metric.name, metric.unit, count, never, failed, mean, sd, least, greatest, quantiles)
