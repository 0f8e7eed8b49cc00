"""Search of a parameter range for values that meet the requirements."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.circuit import BaseCircuit
from poppet.core.errors import InputError
from poppet.ensemble.ensemble_plan import Array, EnsemblePlan
from poppet.ensemble.executors import Progress
from poppet.ensemble.metrics import Requirement
from poppet.ensemble.shards import PreparedPlan

POINTS, STRIDE = 65, 4
"""Number of values of the grid that covers the range. Every fourth value of the grid is evaluated first."""
PIECES, PEAKS, REFINEMENTS = 17, 3, 6
"""Number of pieces around a local maximum of the margin, of refined maxima, and of refinements of each maximum.

A valid value can be between two failing ones. The final resolution is about 1e-6 of the value.
"""
ROUND_VALUES, MAX_ROUNDS = 8, 12
"""Number of values in a round that refines the end of the valid range, and maximum number of these rounds."""
RESOLUTION = 1e-5
"""Relative distance to the nearest failing value at which the refinement ends."""
OFFSETS = (1e-3, 1e-2, 1e-1)
"""Distances of the values of a round from the interpolated end, relative to the gap."""
MAX_RUNS = 4_000_000


@dataclass(frozen=True)
class Evaluations:
    """Results of all runs at several values of the parameter to be sized.

    The values are in ascending order.
    """

    values: Array
    shares: Array
    metrics: Array  # (n, n_metrics)
    margins: Array  # (n, n_requirements)
    worst: Array  # (n,) minimum of all margins relative to their bounds, for the run at the quantile

    def joined(self, other: Evaluations) -> Evaluations:
        """Return the evaluations of both objects in ascending order."""
        order = np.argsort(np.concatenate([self.values, other.values]), kind="stable")
        rows = (np.concatenate(pair)[order] for pair in zip(vars(self).values(), vars(other).values(), strict=True))
        return Evaluations(*rows)


class SizingEvaluator:
    """Function object that runs a circuit at values of the parameter to be sized.

    It returns the metrics of the runs, and the margins to the requirements.
    """

    def __init__(
        self,
        circuit: BaseCircuit,
        sweep: EnsemblePlan,
        requirements: tuple[Requirement, ...],
        free: str,
        nominal: float,
        uncertain: EnsemblePlan | None,
        share: float,
        progress: Progress | None,
    ) -> None:
        self.plan, self.requirements, self.share = sweep, requirements, share
        self.progress, self.done, self.expected = progress, 0, 0
        names = [metric.name for metric in sweep.metrics]
        self.columns = [names.index(requirement.metric) for requirement in requirements]
        # Scales for the comparison of margins with different units.
        self.sizes = np.array([max(abs(bound) for _, bound in r.bounds) or 1.0 for r in requirements])
        if uncertain is None:
            self._ready, self.draws, self._column = PreparedPlan(sweep), np.ones((1, 1)), 0
            return
        draws = uncertain.sample(0, uncertain.runs)
        addresses = uncertain.addresses
        if uncertain.runs * (POINTS + MAX_ROUNDS * ROUND_VALUES) > MAX_RUNS:
            raise InputError("size.too_many", "ensemble.runs", runs=uncertain.runs, most=MAX_RUNS // 200)
        # A parameter that is also uncertain keeps its relative spread.
        if free in addresses:
            median = uncertain.quantile(free, 0.5)
            if not median:
                raise InputError("size.about_zero", free)
            self._column, draws = addresses.index(free), draws.copy()
            draws[:, self._column] /= median
        else:
            self._column = len(addresses)
            draws, addresses = np.column_stack([draws, np.ones(len(draws))]), (*addresses, free)
        self.draws = draws
        table = replace(uncertain, sampling="file", table=(addresses, self._with(nominal)), alone={}, joint=())
        self._ready = PreparedPlan(replace(table, joint_normal=None, keep="metrics", curves=(), metrics=sweep.metrics))

    def _with(self, value: float) -> Array:
        draws = self.draws.copy()
        draws[:, self._column] *= value
        return draws

    def evaluate(self, values: Array, following: int = 0) -> Evaluations:
        """Run the circuit at some values of the parameter.

        `following` is the number of values that are expected after these, for the display of the progress.
        """
        runs = len(self.draws)
        self.expected = self.done + (len(values) + following) * runs
        self._report(0)
        rows = np.concatenate([self._with(value) for value in values])
        results = self._ready.run(rows, threads=None, progress=self._report).metrics
        self.done += len(rows)
        metrics = results.reshape(len(values), runs, -1)
        met = np.ones((len(values), runs), dtype=np.bool_)
        margins = np.empty((len(values), len(self.requirements)))
        worst = np.full((len(values), runs), np.inf)
        # Index of the worst run that must not fail.
        decides = runs - math.ceil(self.share * runs - 1e-9)
        for k, (requirement, column) in enumerate(zip(self.requirements, self.columns, strict=True)):
            met &= requirement.met(metrics[:, :, column])
            margin = np.where(np.isnan(metrics[:, :, column]), -np.inf, requirement.margin(metrics[:, :, column]))
            worst = np.minimum(worst, margin / self.sizes[k])
            margins[:, k] = np.sort(margin, axis=1)[:, decides]
        worst = np.sort(worst, axis=1)[:, decides]
        return Evaluations(np.asarray(values), met.mean(axis=1), metrics.mean(axis=1), margins, worst)

    def _report(self, completed: int) -> None:
        if self.progress is not None:
            self.progress(self.done + completed, self.expected, "runs")


def meets_requirements(results: Evaluations, share: float) -> NDArray[np.bool_]:
    """Return True for each evaluated value at which the fraction of good runs is at least `share`, (n,)."""
    return results.shares >= share - 1e-12


def search_values(evaluator: SizingEvaluator, low: float, high: float, *, largest: bool) -> Evaluations:
    """Evaluate a range of a parameter, mostly near the end of the range that meets the requirements.

    Parameters
    ----------
    evaluator : SizingEvaluator
        Function object that runs the circuit.
    low, high : float
        Ends of the range, SI.
    largest : bool
        True if the largest valid value is requested, False for the smallest.

    Returns
    -------
    Evaluations
        All evaluated values.

    Notes
    -----
    1. The range is covered by 65 values, with logarithmic spacing in a positive range. Every fourth value is evaluated,
       then the values between them, except those between two valid ones.
    2. Requirements need not be monotonic in the parameter: the three failing values with the largest local margins are
       refined, which finds narrow valid intervals between two values.
    3. The gap before the first valid value is refined. The margins on both sides give an interpolated end, and the
       values of a round are close to it on both sides. If this does not shrink the gap more than equal division does,
       for example because a metric jumps, the gap is divided equally from then on.
    """
    grid = np.geomspace(low, high, POINTS) if low > 0.0 else np.linspace(low, high, POINTS)
    results = evaluator.evaluate(grid[::STRIDE], POINTS // 2 + 3 * ROUND_VALUES)
    holds = meets_requirements(results, evaluator.share)
    gaps = [grid[STRIDE * k + 1 : STRIDE * (k + 1)] for k in range(len(holds) - 1) if not (holds[k] and holds[k + 1])]
    if gaps:
        results = results.joined(evaluator.evaluate(np.concatenate(gaps), 3 * ROUND_VALUES))
    results = _refine_peaks(evaluator, results, largest)
    return _refine_end(evaluator, results, largest)


def _refine_end(evaluator: SizingEvaluator, results: Evaluations, largest: bool) -> Evaluations:
    """Refine the gap between the end of the valid range and the next failing value, and return all evaluations."""
    is_smooth, previous_gap = True, math.inf
    for k_round in range(MAX_ROUNDS):
        holds = meets_requirements(results, evaluator.share)
        k = int(np.flatnonzero(holds)[-1 if largest else 0]) if holds.any() else -1
        neighbour = k + 1 if largest else k - 1
        if k < 0 or not 0 <= neighbour < len(holds):
            break
        valid, failing = results.values[k], results.values[neighbour]
        gap = abs(valid - failing)
        if gap <= RESOLUTION * abs(valid):
            break
        # A round of equal division has a ninth of the gap.
        is_smooth &= gap * (ROUND_VALUES + 1) <= previous_gap
        margins = results.worst[k], results.worst[neighbour]
        inner = valid + (failing - valid) * _fractions(margins if is_smooth else (math.nan, math.nan))
        inner = np.setdiff1d(inner, [valid, failing])
        if not inner.size:
            break
        results = results.joined(evaluator.evaluate(inner, max(2 - k_round, 0) * ROUND_VALUES))
        previous_gap = gap
    return results


def _fractions(margins: tuple[float, float]) -> Array:
    """Return the fractions of a gap at which the next values are evaluated.

    `margins` are the relative margins of the valid value, at 0, and of the failing value, at 1. The fractions are
    concentrated about the zero of the margin. Without finite margins of different signs, they divide the gap equally.
    """
    valid, failing = margins
    if not (math.isfinite(valid) and math.isfinite(failing) and valid >= 0.0 > failing):
        return np.linspace(0.0, 1.0, ROUND_VALUES + 2)[1:-1]
    zero = valid / (valid - failing)
    near = [zero + sign * offset for offset in OFFSETS for sign in (-1.0, 1.0)]
    fractions = np.unique([0.5 * zero, *near, 0.5 * (1.0 + zero)])
    return fractions[(fractions > 0.0) & (fractions < 1.0)]


def _refine_peaks(evaluator: SizingEvaluator, results: Evaluations, largest: bool) -> Evaluations:
    """Search near local maxima of the margin for a parameter value that meets all requirements.

    The result contains `results` and the new evaluations. The search begins at the largest margin, and its number of
    rounds is limited. If values that meet the requirements are known, only maxima below the smallest of them are
    refined; if `largest` is True, only maxima above the largest.
    """
    holds, worst = np.flatnonzero(meets_requirements(results, evaluator.share)), results.worst
    left, right = np.append(-np.inf, worst[:-1]), np.append(worst[1:], -np.inf)
    is_peak = np.isfinite(worst) & (worst >= left) & (worst >= right) & (worst > np.minimum(left, right))
    if holds.size:
        is_peak[: holds[-1] + 1] &= not largest
        is_peak[holds[0] :] &= largest
    indices = np.flatnonzero(is_peak)
    peaks = indices[np.argsort(-worst[indices], kind="stable")][:PEAKS]
    for value in results.values[peaks].tolist():
        for _ in range(REFINEMENTS):
            k = int(np.searchsorted(results.values, value))
            low, high = results.values[max(k - 1, 0)], results.values[min(k + 1, len(results.values) - 1)]
            inner = np.setdiff1d(np.linspace(low, high, PIECES + 1)[1:-1], results.values)
            refined = evaluator.evaluate(inner, ROUND_VALUES)
            previous, results = results.worst[k], results.joined(refined)
            best = int(np.argmax(refined.worst))
            if meets_requirements(refined, evaluator.share).any():
                break
            if refined.worst[best] > previous:
                value = float(refined.values[best])
            elif value in (low, high):  # an end of the range
                break
    return results
