r"""Fits of hypotheses to the readings since a fault began, with few simulations.

A hypothesis names the faults that are present. They have no prior, all other faults have their healthy values with a
small scatter. A fault can also grow at a constant rate. All hypotheses therefore have the same free values, and differ
only in the prior variances of the faults and rates. One simulation with its sensitivities predicts the minima of all
hypotheses. The search always continues with the hypothesis whose predicted minimum is lowest, by a step of Gauss and
Newton, and the new point improves the predictions of all others. The search ends when all minima are found, except of
hypotheses that are far worse than the best one.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.identify.fit.residuals import costs_of, weights_of
from poppet.monitoring.evidence import LAST, RISE_SIZE, Hypothesis, HypothesisFit, WindowEvidence
from poppet.monitoring.fault_statistics import SCATTER
from poppet.monitoring.window_model import Samples, WindowRun
from poppet.monitoring.windows import FLAT, Arrival, Window, changes_of_rates, whitening_rows

Array = NDArray[np.float64]

FAR = 12.0
"""Difference of a predicted minimum to the best one above which a hypothesis is not simulated: odds below 1e-5."""
CONVERGED = 0.1
"""Predicted decrease of the cost at which a minimum is found; the statistics are chi-squares, twice as large."""
MOST_EVALUATIONS = 60
"""Maximum number of simulations, each with its sensitivities."""
LEAST_TRIALS = 3
"""Minimum number of simulated points of each single fault, and of each hypothesis while none fits."""
ROUNDED = 1e-9
"""Relative error of a step within the limits of the values."""
SHRINK = 0.25
"""Factor on a step that does not decrease the cost."""
MOST_SHRINKS = 3
ISOLATED = 3.0
"""Difference of the residual of an outlier to those before and after it, in gates of its sensor."""
KNOWN = 3.0
"""Standard deviations from which a fault is known to be present at the start of the window."""
FAILED = 1e6
"""Residual of readings that a failed run does not reach, in sigmas."""


class _Quadratic(NamedTuple):
    """Quadratic model of the cost of the residuals."""

    cost: float
    gradient: Array  # (k,)
    curvature: Array  # (k, k)


class _LinearPoint(NamedTuple):
    """Simulated point with the cost of its residuals.

    Near a minimum, the robust model is accurate. Far from it, all residuals are large, and the model of least squares
    predicts the minimum better.
    """

    z: Array  # (k,) free values
    robust: _Quadratic
    least_squares: _Quadratic
    last: float  # mean squared residual of the last readings, robust


@dataclass(eq=False)
class _Candidate:
    """State of the search for the minimum of one hypothesis."""

    point: _LinearPoint
    cost: float  # at the point, with the prior
    predicted: float  # minimum of the quadratic model
    step: Array  # (k,) to this minimum
    factor: float = 1.0  # of the step
    is_final: bool = False  # found, or the search failed
    has_failed: bool = False


class HypothesisSearch:
    """Search for the minima of several hypotheses on one window of samples.

    Parameters
    ----------
    window : Window
        Estimator of windows, with the healthy values and the noise.
    samples : Samples
        Samples up to the end of the window.
    arrival : Arrival
        Estimate of the filter at the start of the window, before the fault.
    steps : (f,) array, optional
        Approximate size of each fault [SI].
    spread : float, optional
        Standard deviation of the time between the start of the window and the beginning of the fault [s].

    Notes
    -----
    In the hypotheses, the fault begins at the start of the window. If it began a time t later, the state at the start
    differs by t times the change of the rates due to the fault. Its covariance therefore contains this change, times
    the spread.
    """

    def __init__(
        self, window: Window, samples: Samples, arrival: Arrival, steps: Array | None = None, spread: float = 0.0
    ) -> None:
        self.window, self.evaluations = window, 0
        n, plan = window.model.n_states, window.plan
        f, n_rates = len(plan.faults), window.model.n_rates
        self._faults, self._alarms = slice(n, n + f), np.array([fault.alarm for fault in plan.faults])
        self._duration = float(samples.times[-1]) - arrival.time
        healthy = window.healthy[:f] + self._healthy_changes(arrival)
        mean, covariance = self._given_healthy_faults(arrival, healthy)
        mean[self._faults] = healthy
        covariance[self._faults], covariance[:, self._faults] = 0.0, 0.0
        covariance[self._faults, self._faults] = np.diag((SCATTER * self._alarms) ** 2)
        first_rate, faults = mean.size, np.arange(n, n + f)
        arrival = window.with_rates(arrival._replace(mean=mean, covariance=covariance))
        mean, covariance = arrival.mean, arrival.covariance
        rates = first_rate + np.arange(n_rates)
        covariance[rates, rates] = (SCATTER * self._alarms[:n_rates] / self._duration) ** 2
        if steps is not None and spread > 0.0:
            shifts = spread * steps * changes_of_rates(window, samples, arrival)
            covariance[:n, :n] += shifts @ shifts.T
        self._mean, self._free = mean, np.flatnonzero(np.diag(covariance) > 0.0)
        # Members of hypotheses: faults, and f + k for the growth of fault k.
        numbers = np.append(faults, rates)
        self._places = np.flatnonzero(np.isin(self._free, numbers))
        self._members = np.searchsorted(numbers, self._free[self._places])
        # Sizes of the members [SI] are the change at the start of the window, and the growth until its end.
        self._units = np.append(np.ones(f), np.full(n_rates, self._duration))[self._members]
        self._flat = FLAT * np.tile(plan.prior[:f], 2)[self._members] / self._units
        rows = whitening_rows(covariance[np.ix_(self._free, self._free)])
        self._prior = rows.T @ rows
        self._low, self._high = window.low[self._free], window.high[self._free]
        after = samples.times > arrival.time
        self._readings = samples.readings[after]
        self._runs = window.model.runs(samples, arrival.time, self._free, arrival.memory)
        start = np.clip(mean[self._free], self._low, self._high)
        residuals = (self._run(start).readings[1:] - self._readings) / window.noise
        limits = [ISOLATED * channel.gate for channel in plan.channels]
        outliers = [isolated(column, limit) for column, limit in zip(residuals.T, limits, strict=True)]
        self._is_measured = np.isfinite(self._readings) & ~np.stack(outliers, axis=1)
        self._noise = np.broadcast_to(window.noise, self._readings.shape)[self._is_measured]
        gates = [channel.gate for channel in plan.channels]
        self._gates = np.broadcast_to(gates, self._readings.shape)[self._is_measured]
        self._last = slice(-max(1, round(LAST * self.n_readings)), None)
        self.has_failed = False  # True if the model cannot be simulated with the healthy values
        self._starts = [self._evaluate(start)]
        if steps is not None and steps.any() and not self.has_failed:
            # Large faults are far from the healthy values.
            largest, stepped = int(np.argmax(np.abs(steps) / self._alarms)), start.copy()
            stepped[self._places[self._members == largest]] += steps[largest]
            self._starts.append(self._evaluate(np.clip(stepped, self._low, self._high)))
            if n_rates:
                stepped = start.copy()
                stepped[self._places[self._members == f + largest]] += 2.0 * steps[largest] / self._duration
                self._starts.append(self._evaluate(np.clip(stepped, self._low, self._high)))

    def _healthy_changes(self, arrival: Arrival) -> Array:
        """Return the changes of the faults before the window that are known, but too small for an alarm.

        The other faults are healthy.
        """
        change = arrival.mean[self._faults] - self.window.healthy[: self._alarms.size]
        covariance = arrival.covariance[self._faults, self._faults]
        is_known = np.abs(change) > KNOWN * np.sqrt(np.diag(covariance))
        known, others = np.flatnonzero(is_known), np.flatnonzero(~is_known)
        scatter = np.diag((SCATTER * self._alarms[others]) ** 2)
        gain = np.linalg.solve(covariance[np.ix_(others, others)] + scatter, covariance[np.ix_(others, known)])
        changes = np.zeros(change.size)
        changes[known] = change[known] - change[others] @ gain
        return np.where(np.abs(changes) < RISE_SIZE * self._alarms, changes, 0.0)

    def _given_healthy_faults(self, arrival: Arrival, healthy: Array) -> tuple[Array, Array]:
        """Return mean and covariance of an estimate, given that the faults have their healthy values.

        A nuisance such as the supply temperature can be known only together with the size of a leak. Its estimate then
        belongs to the size that the filter estimates, not to a healthy plant.
        """
        mean, covariance, faults = arrival.mean.copy(), arrival.covariance.copy(), self._faults
        change = healthy - mean[faults]
        among_faults = covariance[faults, faults]
        # A fault that is known to be present does not tell anything about the nuisances of a healthy plant.
        excess = np.maximum(change**2 - KNOWN**2 * np.diag(among_faults), 0.0)
        scatter = np.diag((SCATTER * self._alarms) ** 2 + excess)
        gain = np.linalg.solve(among_faults + scatter, covariance[faults])
        return mean + change @ gain, covariance - covariance[:, faults] @ gain

    @property
    def n_readings(self) -> int:
        """Number of readings in the window."""
        return int(np.count_nonzero(self._is_measured))

    def fit(self, hypotheses: Iterable[Hypothesis], *, is_quick: bool = False) -> dict[Hypothesis, HypothesisFit]:
        """Return the minimum of each hypothesis; it is predicted if it is far above the lowest one.

        If `is_quick`, only the lowest minimum is found, and all others are predicted.
        """
        every = tuple(range(self._alarms.size))
        candidates = {
            h: min((self._candidate(start, h) for start in self._starts), key=lambda c: c.predicted) for h in hypotheses
        }
        # With all faults free, a search could leave the range of the model: this minimum is only predicted.
        searched = [h for h in candidates if h != every or len(every) <= 2]
        trials = dict.fromkeys(searched, 0)
        limit = self.evaluations + MOST_EVALUATIONS
        while self.evaluations < limit:
            best = min(candidates[h].predicted for h in searched)
            # A prediction is no bound: flows are not linear in pressures. It excludes a single fault only after some
            # steps, and any other hypothesis if another one fits.
            margin, trials_of_all = (0.0, 0) if is_quick else (FAR, LEAST_TRIALS)
            least = {h: trials_of_all if len(h) == 1 or best >= self.n_readings else 0 for h in searched}
            unknown = [
                h for h in searched
                if not candidates[h].is_final and (candidates[h].predicted <= best + margin or trials[h] < least[h])
            ]  # fmt: skip
            if not unknown:
                break
            hypothesis = min(unknown, key=lambda h: candidates[h].predicted)
            candidate = candidates[hypothesis]
            z = candidate.point.z + candidate.factor * candidate.step
            point = self._evaluate(np.clip(z, self._low, self._high))
            trials[hypothesis] += 1
            if self._candidate(point, hypothesis).cost > candidate.cost:
                candidate.factor *= SHRINK
                candidate.is_final = candidate.has_failed = candidate.factor < SHRINK**MOST_SHRINKS
                continue
            candidates[hypothesis] = self._candidate(point, hypothesis)
            for h, present in candidates.items():
                nearer = self._candidate(point, h)
                is_nearer = nearer.predicted < present.predicted - 0.5 * CONVERGED
                # A prediction over a large distance can be too low; it does not replace a better point of the search.
                if is_nearer and (not trials.get(h) or nearer.cost < present.cost):
                    candidates[h] = nearer
        farthest = FAR + min(candidate.cost for candidate in candidates.values())
        return {h: self._result(c, h, is_searched=h in trials, farthest=farthest) for h, c in candidates.items()}

    def _candidate(self, point: _LinearPoint, hypothesis: Hypothesis) -> _Candidate:
        """Return the quadratic model of the cost of a hypothesis at a point, with its minimum."""
        prior = self._prior.copy()
        is_named = np.isin(self._members, hypothesis)
        named = self._places[is_named]
        prior[named, named] = 1.0 / self._flat[is_named] ** 2
        past = point.z - self._mean[self._free]
        penalty = 0.5 * float(past @ prior @ past)
        predicted, step = math.inf, past
        for model in (point.robust, point.least_squares):
            gradient, curvature = model.gradient + prior @ past, model.curvature + prior
            to_minimum = self._to_minimum(point.z, gradient, curvature)
            minimum = model.cost + penalty + float((gradient + 0.5 * curvature @ to_minimum) @ to_minimum)
            if minimum < predicted:
                predicted, step = minimum, to_minimum
        cost = point.robust.cost + penalty
        return _Candidate(point, cost, predicted, step, is_final=cost - predicted < CONVERGED)

    def _to_minimum(self, z: Array, gradient: Array, curvature: Array) -> Array:
        """Return the step to the minimum of a quadratic model; values that would leave their limits end there."""
        scale = 1.0 / np.sqrt(np.diag(curvature))
        step = np.asarray(-scale * np.linalg.solve(curvature * np.outer(scale, scale), scale * gradient))
        limited: Array = np.clip(z + step, self._low, self._high) - z
        is_outside = np.abs(limited - step) > ROUNDED * np.abs(step)
        if not is_outside.any():
            return step
        inside = np.flatnonzero(~is_outside)
        slopes = gradient[inside] + curvature[np.ix_(inside, np.flatnonzero(is_outside))] @ limited[is_outside]
        scale = scale[inside]
        limited[inside] = -scale * np.linalg.solve(
            curvature[np.ix_(inside, inside)] * np.outer(scale, scale), scale * slopes
        )
        return limited

    def _run(self, z: Array) -> WindowRun:
        values = self._mean.copy()
        values[self._free] = z
        return self._runs.run(values, self.window.high)

    def _evaluate(self, z: Array) -> _LinearPoint:
        run = self._run(z)
        self.evaluations += 1
        mask = self._is_measured
        residuals = (run.readings[1:][mask] - self._readings[mask]) / self._noise
        if not np.isfinite(residuals).all():
            self.has_failed = self.has_failed or self.evaluations == 1
            residuals[~np.isfinite(residuals)] = FAILED
        slopes = np.nan_to_num(run.slopes[1:][mask] / self._noise[:, None], posinf=0.0, neginf=0.0)
        costs = self._gates**2 * costs_of(residuals / self._gates, "huber")
        cost = float(np.sum(costs))
        weighted = slopes * weights_of(residuals / self._gates, "huber")[:, None]
        return _LinearPoint(
            z,
            _Quadratic(cost, weighted.T @ residuals, weighted.T @ slopes),
            _Quadratic(0.5 * float(residuals @ residuals), slopes.T @ residuals, slopes.T @ slopes),
            2.0 * float(np.mean(costs[self._last])) if costs.size else 1.0,
        )

    def _result(
        self, candidate: _Candidate, hypothesis: Hypothesis, *, is_searched: bool, farthest: float
    ) -> HypothesisFit:
        """Return the fit of a hypothesis; if its search has failed, its cost is that of the best simulated point."""
        is_known = candidate.is_final and not candidate.has_failed
        # A minimum far above the best one needs no exact value.
        is_known |= not is_searched or candidate.predicted > farthest
        step = candidate.step if is_known else np.zeros(candidate.step.size)
        z, sizes = candidate.point.z + step, np.zeros(2 * self._alarms.size)
        healthy = np.append(self.window.healthy[: self._alarms.size], np.zeros(self.window.model.n_rates))
        sizes[self._members] = self._units * (z[self._places] - healthy[self._members])
        cost = candidate.predicted if is_known else candidate.cost
        return HypothesisFit(cost, sizes[list(hypothesis)], candidate.point.last, is_known)


def isolated(residuals: Array, limit: float) -> NDArray[np.bool_]:
    """Return a mask of residuals that differ from those before and after them by more than a limit.

    They are outliers: the residuals of a fault change gradually. NaN is a missing residual.

    Examples
    --------
    >>> isolated(np.array([0.0, 1.0, 90.0, np.nan, 2.0, 3.0, 30.0, 31.0]), 10.0).nonzero()[0]
    array([2])
    """
    mask, rows = np.zeros(residuals.size, dtype=bool), np.flatnonzero(np.isfinite(residuals))
    if rows.size > 2:
        is_far = np.abs(np.diff(residuals[rows])) > limit
        # An end has one neighbour, which must not be an outlier itself.
        before = np.concatenate([[is_far[0] and not is_far[1]], is_far])
        after = np.concatenate([is_far, [is_far[-1] and not is_far[-2]]])
        mask[rows] = before & after
    return mask


def fit_hypotheses(
    window: Window,
    samples: Samples,
    arrival: Arrival,
    hypotheses: Sequence[Hypothesis],
    steps: Array | None = None,
    spread: float = 0.0,
    *,
    is_quick: bool = False,
) -> WindowEvidence | None:
    """Return the fits of hypotheses to the samples after an estimate of the filter; see `HypothesisSearch`.

    The result is None if the model cannot be simulated.
    """
    search = HypothesisSearch(window, samples, arrival, steps, spread)
    return None if search.has_failed else WindowEvidence(search.fit(hypotheses, is_quick=is_quick), search.n_readings)
