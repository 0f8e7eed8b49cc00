"""Statistics of a filter on the healthy recording, compared with those that its model predicts."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.monitoring.baseline import Baseline
from poppet.monitoring.evidence import RISE_SIZE
from poppet.monitoring.filter import PlantFilter
from poppet.monitoring.plan import Fault
from poppet.monitoring.window_model import Samples

Array = NDArray[np.float64]

QUANTILE = 0.95
"""Quantile that is compared."""
PER_WINDOW = 20
"""Number of evaluations per window."""
INFORMED = 0.1
"""Least information of an onset on a fault, in units of the inverse square of its alarm size."""


class HealthyStatistics(NamedTuple):
    """Ratios of the statistics of the healthy recording to those that the model predicts."""

    temper: float  # factor on the variances of the fault numbers, at least 1
    healthy_nis: float  # mean normalised squared innovation of one reading
    steps: Array  # (f,) largest evidence for a step of each fault, in standard deviations with this factor
    times: Array  # (f,) times of this evidence [s]


def healthy_statistics(baseline: Baseline, samples: Samples, progress: Callable[[float], Any]) -> HealthyStatistics:
    r"""Return the statistics of a filter with this baseline on the healthy recording.

    The size of each fault, estimated as the only one by the filter or by one of its onsets, has a standard normal
    distribution in standard deviations. The joint statistic of all faults has a chi-square distribution. The temper
    factor is the largest ratio of their 95 % quantiles to the expected ones that is significant: a recording of N
    windows contains N independent values, whose mean square exceeds that of their distribution by chance. The first
    window is not used.
    """
    from scipy.special import chdtri

    plan = baseline.plan
    running, squares = PlantFilter(plan, baseline), _Squares(plan.faults)
    begin, due = float(samples.times[0]), -np.inf
    total, count = 0.0, 0
    for k, time in enumerate(samples.times.tolist()):
        running.update(time, samples.readings[k], samples.inputs[k])
        progress(k / samples.times.size)
        if time < begin + plan.window:
            continue
        if running.count:
            total, count = total + running.nis, count + running.count
        if time >= due:
            due = time + plan.window / PER_WINDOW
            squares.add(running)
    ratios = [
        float(np.quantile(values, QUANTILE)) / float(chdtri(freedom, 1.0 - QUANTILE))
        for values, freedom in squares.columns()
        if len(values) >= PER_WINDOW
    ]
    n_windows = max(1.0, float(samples.times[-1] - begin) / plan.window - 1.0)
    chance = float(chdtri(n_windows, 1.0 - QUANTILE)) / n_windows
    temper = max([1.0, *(ratio / chance for ratio in ratios)])
    steps = squares.steps / np.sqrt(temper)
    return HealthyStatistics(temper, total / count if count else 1.0, steps, squares.times)


class _Squares:
    """Squared statistics of the faults over the recording."""

    def __init__(self, faults: tuple[Fault, ...]) -> None:
        n_faults = len(faults)
        self._alarms = np.array([fault.alarm for fault in faults])
        self._directions = np.array([fault.direction for fault in faults])
        self.steps, self.times = np.zeros(n_faults), np.full(n_faults, np.nan)
        self._joint: list[float] = []
        self._estimates: list[list[float]] = [[] for _ in range(n_faults)]
        self._onsets: list[list[float]] = [[] for _ in range(n_faults)]

    def add(self, running: PlantFilter) -> None:
        """Add the present statistics of a filter."""
        posterior = running.fault_posterior()
        information = np.linalg.inv(posterior.covariance)
        gains = information @ posterior.change
        self._joint.append(float(posterior.change @ gains))
        bank = running.bank()
        for k, (alarm, direction) in enumerate(zip(self._alarms, self._directions, strict=True)):
            self._estimates[k].append(float(gains[k] ** 2 / information[k, k]))
            content, evidence = bank.gram[:, k, k], bank.numerators[:, k]
            informed = content * alarm**2 > INFORMED
            content, evidence = content[informed], evidence[informed]
            roots = evidence / np.sqrt(content)
            self._onsets[k].extend((roots**2).tolist())
            roots, sizes = (np.abs(a) if direction == 0 else direction * a for a in (roots, evidence / content))
            largest = float(np.max(roots[sizes >= RISE_SIZE * alarm], initial=0.0))
            if largest > self.steps[k]:
                self.steps[k], self.times[k] = largest, running.time

    def columns(self) -> list[tuple[list[float], int]]:
        """Return the values of each statistic, and its degrees of freedom."""
        singles = [(values, 1) for values in (*self._estimates, *self._onsets)]
        return [(self._joint, len(self._estimates)), *singles]
