r"""Fit of a window of samples: state at its start, and free numbers that are constant within it.

The fit minimises

.. math:: \tfrac12 (z - \bar z)^T P^{-1} (z - \bar z) + \sum_{i, k} \rho\Big(
    \frac{y_i(t_k, z) - r_{ik}}{\sigma_i}\Big)

over z = (x, theta), the state x at the start of the window and the free numbers. The arrival prior, mean :math:`\bar z`
and covariance P, is the estimate of a filter at this time. It contains all readings up to the start, and the sum the
readings r after it, so that no reading counts twice. The loss :math:`\rho` is half the square, and that of Huber for
residuals above the gate of the sensor. If these are rare, they are outliers: the fit is repeated without them.

If the model is linear and theta is constant, the result equals that of the Kalman filter over the same readings. A
filter whose numbers walk has larger standard deviations, because it forgets earlier readings; within a window, nothing
is forgotten. The fit of a *hypothesis* frees only the named faults. They have no prior then, because the filter had not
yet seen the fault; all other faults have their healthy values.

References
----------
Rao, Rawlings & Mayne 2003, IEEE Trans. Autom. Control 48, 246-258 (moving horizon estimation, arrival cost).
Baumgärtner, Frey, Hashemi & Diehl 2022, IFAC-PapersOnLine 55 (gradient condition of the arrival cost).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.identify.fit.residuals import costs_of, weights_of, whiteness
from poppet.identify.least_squares import LocalModel, search, triangular_factor
from poppet.monitoring.plan import WatchPlan
from poppet.monitoring.window_model import Samples, WindowModel, WindowRun

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

RARE = 0.05
"""Maximum fraction of outliers among the readings of a sensor; more residuals above the gate are a lack of fit."""
FLAT = 1e4
"""Standard deviation of a fault of a hypothesis, in prior standard deviations: practically no prior."""
DEPLETED = 1e-6
"""Lower limit of positive states, as a fraction of their usual size."""
FAILED = 1e6
"""Residual of readings that a failed run does not reach, in sigmas."""
GAIN = 1e-4
"""Predicted decrease of the cost at which a search ends.

It corresponds to 0.01 standard deviations. The error of the integration changes the cost by more."""
ROUNDING = 1e-12
"""Least variance of a combination of values in the arrival prior, relative to their variances."""
IMPROBABLE = 1e-3
"""Probability below which a fit is bad, so that the search is repeated from other start points."""
LARGE = 3.0, 30.0
"""Changes of the faults at these start points, in alarm sizes."""


class Arrival(NamedTuple):
    """Estimate at the start of a window, which contains all readings up to this time."""

    time: float  # [s]
    mean: Array  # (n + m,) state and free numbers
    covariance: Array  # (n + m, n + m); values with a variance of zero are known
    memory: Array = np.zeros(0)  # discrete state, (n_memory,)
    squares: float = 0.0  # sum of squared innovations of the filter up to this time


@dataclass(frozen=True, eq=False)
class WindowFit:
    """Result of the fit of a window; its values are z = (x, theta), the state at the start and the free numbers.

    Parameters
    ----------
    start : ndarray
        State at the start of the window, (n,).
    theta : ndarray
        Free numbers, (m,), also those with a fixed value.
    free : ndarray
        Indices of the fitted values in z, (k,).
    covariance : ndarray
        Covariance of the fitted values, (k, k).
    arrival : Arrival
        Estimate at the end of the window, with which a filter can continue.
    times : ndarray
        Times of the readings [s].
    residuals : ndarray
        Reading of the model minus reading in sigmas, (n_times, n_channels), NaN for missing readings.
    slopes : ndarray
        Derivatives of the residuals by the fitted values, (n_times, n_channels, k).
    used : ndarray
        1 for readings that the fit uses, 0 for missing ones, -1 for outliers, (n_times, n_channels).
    cost : float
        Minimum of the cost. An outlier has the cost of a residual at the gate, so that hypotheses are comparable.
    prior_cost : float
        Part of the cost that belongs to the arrival prior.
    freedom : int
        Degrees of freedom of `cost`: number of readings used, less the number of values without a prior.
    is_complete : bool
        False if the model could not be simulated to the end of the window.
    evaluations : int
        Number of evaluations of the model with its sensitivities.
    """

    start: Array
    theta: Array
    free: Integers
    covariance: Array
    arrival: Arrival
    times: Array
    residuals: Array
    slopes: Array = field(repr=False)
    used: NDArray[np.int8]
    cost: float
    prior_cost: float
    freedom: int
    is_complete: bool
    evaluations: int

    @property
    def sigmas(self) -> Array:
        """Standard deviations of the free numbers, (m,); 0 for those with a fixed value."""
        n = self.start.size
        sigmas = np.zeros(n + self.theta.size)
        sigmas[self.free] = np.sqrt(np.diag(self.covariance))
        return sigmas[n:]

    @cached_property
    def probability(self) -> float:
        """Probability of larger residuals than these if the model and the noise are correct."""
        from scipy.special import chdtrc

        squares = float(np.sum(self.residuals[self.used == 1] ** 2)) + 2.0 * self.prior_cost
        return float(chdtrc(self.freedom, squares)) if self.is_complete and self.freedom > 0 else 0.0

    @cached_property
    def whiteness(self) -> Array:
        """Probability that the residuals of each channel are white noise, (n_channels,)."""
        columns = zip(self.residuals.T, self.used.T, strict=True)
        return np.array([whiteness(series[status == 1]) for series, status in columns])


class Window:
    """Estimator of windows of samples.

    Parameters
    ----------
    plan : WatchPlan
        Sensors, inputs and free numbers.
    healthy : ndarray, optional
        Healthy values of the free numbers, (m,); by default those of the circuit.
    noise : ndarray, optional
        Standard deviations of the readings, (n_channels,); by default those of the plan.
    tolerance : float, optional
        Relative tolerance of the integration; by default that of the runs of the circuit.
    grows : bool, optional
        True if faults can change at constant rates within a window; the values of its model are then (x, theta, rates).
    """

    def __init__(
        self,
        plan: WatchPlan,
        *,
        healthy: Array | None = None,
        noise: Array | None = None,
        tolerance: float | None = None,
        grows: bool = False,
    ) -> None:
        tolerance = plan.tolerance if tolerance is None else tolerance
        self.plan, self.model = plan, WindowModel(plan, tolerance=tolerance, grows=grows)
        self.healthy = plan.reference if healthy is None else healthy
        self.noise = np.array([channel.noise for channel in plan.channels]) if noise is None else noise
        states, n = plan.instance.model.states, self.model.n_states
        floors = [DEPLETED * state.nominal if state.positive else -np.inf for state in states]
        # A fault grows in its direction.
        directions = np.array([fault.direction for fault in plan.faults])[: self.model.n_rates]
        self.low = np.concatenate([floors, plan.low, np.where(directions > 0, 0.0, -np.inf)])
        self.high = np.concatenate([np.full(n, np.inf), plan.high, np.where(directions < 0, 0.0, np.inf)])
        self._faults = {fault.name: n + k for k, fault in enumerate(plan.faults)}

    def fit(
        self,
        samples: Samples,
        arrival: Arrival,
        *,
        free: Sequence[str] | None = None,
        scatter: float = 0.0,
        begin: Array | None = None,
    ) -> WindowFit:
        """Fit all values, or those of a hypothesis.

        Parameters
        ----------
        samples : Samples
            Samples up to the end of the window. Readings up to the arrival time are not used.
        arrival : Arrival
            Estimate at the start of the window.
        free : sequence of str, optional
            Names of the faults of a hypothesis. Without it, all values are free.
        scatter : float, optional
            Standard deviation of the other faults of a hypothesis from their healthy values, in alarm sizes.
        begin : ndarray, optional
            Free numbers from which the search starts, (m,); by default the mean of the arrival prior, and the healthy
            values for a hypothesis.

        Returns
        -------
        WindowFit
        """
        n, mean, covariance = self.model.n_states, arrival.mean.copy(), arrival.covariance.copy()
        if free is not None:
            faults = np.array([*self._faults.values()], dtype=np.int64)
            members = np.array([self._faults[name] for name in free], dtype=np.int64)
            mean[faults] = self.healthy[faults - n]
            covariance[faults], covariance[:, faults] = 0.0, 0.0
            covariance[faults, faults] = [(scatter * fault.alarm) ** 2 for fault in self.plan.faults]
            covariance[members, members] = (FLAT * self.plan.prior[members - n]) ** 2
        prior = arrival._replace(mean=mean, covariance=covariance)
        problem = _WindowProblem(self, samples, prior, 0 if free is None else len(free))
        first = mean.copy()
        if begin is not None:
            first[n:] = begin
        best = problem.fit(first)
        if free and best.probability < IMPROBABLE:
            for start in self._large_changes(members, first):
                fit = problem.fit(start)
                best = fit if fit.cost < best.cost else best
        return best

    def with_rates(self, arrival: Arrival) -> Arrival:
        """Return an estimate with the growth rates of this window, which are known to be zero."""
        count = self.model.n_rates
        covariance = np.pad(arrival.covariance, (0, count))
        return arrival._replace(mean=np.pad(arrival.mean, (0, count)), covariance=covariance)

    def _large_changes(self, members: Integers, first: Array) -> list[Array]:
        """Return start points with large changes of the named faults within their directions and limits."""
        n = self.model.n_states
        starts: list[Array] = []
        directions = np.array([self.plan.faults[k - n].direction for k in members])
        alarms = np.array([self.plan.faults[k - n].alarm for k in members])
        for size in LARGE:
            for sign in (1.0, -1.0):
                start = first.copy()
                start[members] = self.healthy[members - n] + size * alarms * np.where(directions == 0, sign, directions)
                start[members] = np.clip(start[members], self.low[members], self.high[members])
                if not any(np.array_equal(start, start_point) for start_point in starts):
                    starts.append(start)
        return starts


class _WindowProblem:
    """Cost of one window as a function of its free values."""

    def __init__(self, window: Window, samples: Samples, arrival: Arrival, n_flat: int) -> None:
        self.window, self.arrival, self.n_flat = window, arrival, n_flat
        self.free = np.flatnonzero(np.diag(arrival.covariance) > 0.0)
        self.runs = window.model.runs(samples, arrival.time, self.free, arrival.memory)
        is_later = samples.times > arrival.time
        self.times, self.readings = samples.times[is_later], samples.readings[is_later]
        self.measured = np.isfinite(self.readings)
        self.gates = np.broadcast_to([channel.gate for channel in window.plan.channels], self.readings.shape)
        self.low, self.high = window.low[self.free], window.high[self.free]
        covariance = arrival.covariance[np.ix_(self.free, self.free)]
        self.scale, self.prior = np.sqrt(np.diag(covariance)), whitening_rows(covariance)
        self._last: tuple[bytes, WindowRun] = b"", WindowRun(*[np.zeros(0)] * 5)
        self.evaluations = 0

    def fit(self, first: Array) -> WindowFit:
        """Search from the point `first`, (n + m,), and then without the outliers."""
        mask = self.measured
        z = self._search(np.clip(first[self.free], self.low, self.high), mask)
        residuals = self._residuals(z)
        outliers = mask & (np.abs(residuals) > self.gates)
        outliers &= np.count_nonzero(outliers, axis=0) <= RARE * np.count_nonzero(mask, axis=0)
        if outliers.any():
            mask = mask & ~outliers
            z = self._search(z, mask)
        return self._result(z, mask)

    def _search(self, begin: Array, mask: NDArray[np.bool_]) -> Array:
        prior, mean, gates = self.prior, self.arrival.mean[self.free], self.gates[mask]

        def cost(z: Array) -> float:
            past = prior @ (z - mean)
            return self._data_cost(self._residuals(z), mask) + 0.5 * float(past @ past)

        def look(z: Array) -> LocalModel:
            residual = self._residuals(z)[mask]
            slopes = np.nan_to_num(self._run(z).slopes[1:][mask] / self._noise[mask][:, None], posinf=0.0, neginf=0.0)
            # Weights as curvature: far from the optimum, all residuals are above the gate, and the loss has none.
            weights = weights_of(residual / gates, "huber")
            force, root = residual * weights, np.sqrt(weights)
            past = prior @ (z - mean)
            columns = np.empty((residual.size + past.size, z.size + 1), order="F")
            columns[: residual.size, :-1], columns[: residual.size, -1] = slopes * root[:, None], residual * root
            columns[residual.size :, :-1], columns[residual.size :, -1] = prior, past
            triangle = triangular_factor(columns)
            jacobian = np.vstack([slopes, prior])
            return LocalModel(triangle[:, :-1], triangle[:, -1], jacobian, np.append(force, past))

        # Large units: the prior limits the steps, and a fault can change by any factor.
        precision = 2.0 * GAIN / max(1, int(np.count_nonzero(mask)))
        return search(cost, look, begin, self.low, self.high, 1e3 * self.scale, precision=precision).x

    @cached_property
    def _noise(self) -> Array:
        return np.broadcast_to(self.window.noise, self.readings.shape)

    def _data_cost(self, residuals: Array, mask: NDArray[np.bool_]) -> float:
        gates = self.gates[mask]
        return float(gates**2 @ costs_of(residuals[mask] / gates, "huber"))

    def _run(self, z: Array) -> WindowRun:
        """Return the run at the fitted values z, (k,); the last one is stored, because a search requests it twice."""
        key = z.tobytes()
        if self._last[0] != key:
            values = self.arrival.mean.copy()
            values[self.free] = z
            self._last = key, self.runs.run(values, self.window.high)
            self.evaluations += 1
        return self._last[1]

    def _residuals(self, z: Array) -> Array:
        """Return the residuals in sigmas, (n_times, n_channels); missing readings have a residual of NaN."""
        residuals = (self._run(z).readings[1:] - self.readings) / self.window.noise
        residuals[self.measured & ~np.isfinite(residuals)] = FAILED
        return residuals

    def _result(self, z: Array, mask: NDArray[np.bool_]) -> WindowFit:
        run, residuals = self._run(z), self._residuals(z)
        slopes = run.slopes[1:] / self._noise[:, :, None]
        past = self.prior @ (z - self.arrival.mean[self.free])
        prior_cost = 0.5 * float(past @ past)
        outliers = self.measured & ~mask
        data_cost = self._data_cost(residuals, mask) + 0.5 * float(np.sum(self.gates[outliers] ** 2))
        rows = np.vstack([slopes[mask & (np.abs(residuals) <= self.gates)], self.prior])
        is_complete = bool(np.isfinite(run.end).all())
        covariance = _inverse(np.nan_to_num(rows))
        n, values = self.window.model.n_states, self.arrival.mean.copy()
        values[self.free] = z
        end, n_rates = values.copy(), self.window.model.n_rates
        m = values.size - n - n_rates
        transition = np.zeros((values.size, self.free.size))
        transition[self.free, np.arange(self.free.size)] = 1.0
        transition[:n] = run.end_slopes
        end[:n] = run.end
        # The faults have grown until the end.
        duration, grown = float(self.times[-1]) - self.arrival.time, n + np.arange(n_rates)
        end[grown] += duration * values[n + m :]
        transition[grown] += duration * transition[n + m :]
        arrival = Arrival(float(self.times[-1]), end, transition @ covariance @ transition.T, run.end_memory)
        status = mask.astype(np.int8) - outliers.astype(np.int8)
        return WindowFit(
            values[:n], values[n:], self.free, covariance, arrival, self.times, residuals, slopes, status,
            prior_cost + data_cost, prior_cost, int(np.count_nonzero(mask)) - self.n_flat, is_complete,
            self.evaluations,
        )  # fmt: skip


def changes_of_rates(window: Window, samples: Samples, arrival: Arrival) -> Array:
    """Return the derivatives of the rates of the states by the faults at the start of a window, (n, f)."""
    n, f = window.model.n_states, len(window.plan.faults)
    first = int(np.searchsorted(samples.times, arrival.time, side="right")) + 1
    begin = Samples(*(values[:first] for values in samples))
    runs = window.model.runs(begin, arrival.time, n + np.arange(f), arrival.memory)
    slopes: Array = runs.run(arrival.mean, window.high).end_slopes / (samples.times[first - 1] - arrival.time)
    return slopes


def whitening_rows(covariance: Array) -> Array:
    """Return rows whose inner products are the inverse of a covariance, (k, k).

    The state of a damped plant is soon a function of theta, except for rounding errors. The variance in each direction
    is therefore at least that of their size.
    """
    scale = np.sqrt(np.diag(covariance))
    variances, directions = np.linalg.eigh(covariance / np.outer(scale, scale))
    return np.asarray((directions / np.sqrt(np.maximum(variances, ROUNDING))).T / scale)


def _inverse(rows: Array) -> Array:
    """Return the inverse of the inner products of the columns of `rows`, (k, k)."""
    sizes = np.sqrt(np.sum(rows * rows, axis=0))
    factor = np.linalg.inv(triangular_factor(np.asfortranarray(rows / sizes))) / sizes[:, None]
    return np.asarray(factor @ factor.T)
