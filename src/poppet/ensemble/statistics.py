"""What runs tell: shares with intervals, moments and quantiles, influence of numbers."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from poppet.ensemble.dataset import Dataset
from poppet.ensemble.metrics import Metric

LEVELS = (0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99)
"""Quantiles of a metric."""
_Z = 1.959963984540054
"""Normal quantile of an interval of 95 %."""


@dataclass(frozen=True)
class Yield:
    """Share of runs that meet a requirement, with its interval of 95 %."""

    name: str
    text: str
    good: int
    runs: int
    low: float
    high: float

    @property
    def share(self) -> float:
        """Good runs of all."""
        return self.good / self.runs if self.runs else math.nan


@dataclass(frozen=True)
class Summary:
    """A metric over all runs, in its unit."""

    name: str
    unit: str
    count: int  # runs with a finite value
    never: int  # runs in which what is asked for never happens: infinite
    failed: int  # runs without a value
    mean: float
    sd: float
    least: float
    greatest: float
    quantiles: dict[float, float]  # of the finite values


@dataclass(frozen=True)
class TornadoRange:
    """A metric at the median of all numbers, and at the low and the high quantile of one of them."""

    address: str
    middle: float
    low: float
    high: float

    @property
    def size(self) -> float:
        """How far apart they are."""
        size = abs(self.high - self.low)
        return size if math.isfinite(size) else math.inf


def wilson(good: int, runs: int) -> tuple[float, float]:
    r"""Interval of 95 % of a share.

    .. math:: \frac{k + z^2/2}{n + z^2} \pm \frac{z}{n + z^2} \sqrt{\frac{k (n - k)}{n} + \frac{z^2}{4}}

    Parameters
    ----------
    good, runs : int
        k of n.

    Returns
    -------
    tuple of float
        Its ends; 0 and 1 without runs.

    Notes
    -----
    Wilson, J. Am. Stat. Assoc. 22 (1927) 209. Of independent runs it covers 95 % on average over shares; of a Latin
    hypercube or a scrambled Sobol sequence, which spread more evenly, more than that.

    Examples
    --------
    >>> [round(end, 4) for end in wilson(90, 100)]
    [0.8256, 0.9448]
    """
    if not runs:
        return 0.0, 1.0
    z2 = _Z * _Z
    middle = (good + 0.5 * z2) / (runs + z2)
    half = _Z / (runs + z2) * math.sqrt(good * (runs - good) / runs + 0.25 * z2)
    return max(0.0, middle - half) if good else 0.0, min(1.0, middle + half) if good < runs else 1.0


def summary_of(dataset: Dataset, metric: Metric, most: int) -> Summary:
    """A metric over all runs; its quantiles are those of the first `most` of them."""
    count = never = failed = 0
    mean = moment = 0.0
    least, greatest = math.inf, -math.inf
    first: list[np.ndarray] = []
    for shard in dataset.shards("runs", [metric.name]):
        values = shard[metric.name]
        finite = values[np.isfinite(values)]
        never += int(np.isinf(values).sum())
        failed += int(np.isnan(values).sum())
        if sum(map(len, first)) < most:
            first.append(finite)
        if finite.size:
            # Chan, Golub and LeVeque: moments of two sets make those of both.
            own, n = float(finite.mean()), finite.size
            apart = own - mean
            moment += float(((finite - own) ** 2).sum()) + apart**2 * count * n / (count + n)
            mean += apart * n / (count + n)
            count += n
            least, greatest = min(least, float(finite.min())), max(greatest, float(finite.max()))
    seen = np.concatenate(first) if first else np.empty(0)
    quantiles = dict(zip(LEVELS, np.quantile(seen, LEVELS).tolist(), strict=True)) if seen.size else {}
    if not count:
        mean = least = greatest = math.nan
    sd = math.sqrt(moment / (count - 1)) if count > 1 else math.nan
    return Summary(metric.name, metric.unit, count, never, failed, mean, sd, least, greatest, quantiles)
