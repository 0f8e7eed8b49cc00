"""Weighted least-squares search for the free parameters, in which each evaluation simulates the circuit."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import ErrorCollector
from poppet.core.tables import Field
from poppet.identify.fit.experiment import FAILED, SAMPLED_DIFFERENCE, Experiment, channels_of
from poppet.identify.fit.residuals import LOSSES, costs_of, curvatures_of, weights_of, whiteness
from poppet.identify.free_parameter import FreeParameter, by_name
from poppet.identify.least_squares import LocalModel, search, triangular_factor
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import noise_of

ROUNDS = 12
"""Maximum number of rounds of weighting. Each round estimates noise that is not stated from the last residuals."""
KICKS = 3
"""Default of the maximum number of restart rounds."""
SUSPICIOUS = 0.05
"""Probability of white residuals below which the search is restarted; a false alarm only costs time."""
JOINED = 0.1
"""Tolerances, in standard errors and in the cost, within which a point belongs to a known optimum."""
INSIDE = 0.1
"""Largest distance from a bound at which derivatives near it are computed, as a fraction of the typical size."""
NEAR = 0.01
"""Distance from a bound below which a parameter is at the bound, in standard errors."""
INEXACT = 1e-5
"""Relative error of the derivatives from finite differences."""
WIDTHS = (SAMPLED_DIFFERENCE, 0.02, 0.002)
"""Relative widths of the finite differences for sampled circuits, whose residuals are not smooth at small scale. In
fits of a complete valve, the error of the estimates was 1 % with the first width and 10 % with the last. In fits of a
loop with a steep gain, the last width gave the smaller error."""
SEARCH_FIELDS = {
    "loss": Field(choices=LOSSES, meaning="loss function"),
    "starts": Field(type="integer", low=1, high=1000, meaning="number of start points"),
    "seed": Field(type="integer", low=0, high=2**63 - 1),
    "kicks": Field(type="integer", low=0, high=1000, meaning="number of restart rounds"),
}

Places = NDArray[np.int64] | slice


@dataclass(frozen=True)
class SearchSettings:
    """Settings of the search for an optimum: loss function, start points and restarts.

    Parameters
    ----------
    loss : str
        `linear`, or a robust one: `soft_l1`, `huber`, `cauchy`.
    starts : int
        Number of start points; the first has the start values, the others are random.
    seed : int
        Seed of the random start points.
    kicks : int or None
        Maximum number of rounds of restarts near the optimum, if the residuals are not white. If it is None, the number
        is 3. For circuits with sampled controllers it is then 0, because their residuals are seldom white and their
        simulations take long.
    """

    loss: str = "linear"
    starts: int = 1
    seed: int = 0
    kicks: int | None = None

    def __post_init__(self) -> None:
        with ErrorCollector() as errors:
            for name, field in SEARCH_FIELDS.items():
                with errors.collecting():
                    if name != "kicks" or self.kicks is not None:
                        field.read(getattr(self, name), name)


class KnownOptimum(NamedTuple):
    """Optimum that an earlier search with the same residuals has reached."""

    x: FloatArray
    errors: FloatArray  # standard error of each parameter, infinite if the data are insensitive to it
    cost: float

    def contains(self, x: FloatArray, cost: float) -> bool:
        """Return True if the point `x` with the cost `cost` belongs to this optimum.

        The point belongs to the optimum if each parameter differs by at most a tenth of a standard error, and the cost
        by at most 0.1.
        """
        is_near = np.abs(x - self.x) <= JOINED * np.where(np.isfinite(self.errors), self.errors, np.inf)
        return bool(np.all(is_near)) and abs(cost - self.cost) <= JOINED


class _JoinedError(Exception):
    """Exception that ends a search when it reaches a known optimum."""


@dataclass
class Optimum:
    """Result of a search: the best point with its residuals and their derivatives.

    `residual` and `jacobian` contain one row for each sample, followed by one row for each prior.
    """

    x: FloatArray  # values of the free parameters, (n_free,), SI
    cost: float  # half the sum of squares, in sigmas
    jacobian: FloatArray  # derivatives of the weighted residuals, (n_samples, n_free), per SI unit of the parameters
    residual: FloatArray  # weighted residuals, (n_samples,)
    sigmas: list[float]  # noise of each channel, in the order of experiments and channels
    active: NDArray[np.int64]  # -1 at the lower bound, 1 at the upper, 0 between, (n_free,)
    # Jacobian near the bounds, at a point slightly inside; empty if no parameter is at a bound.
    inside: FloatArray = field(default_factory=lambda: np.zeros((0, 0)))
    interrupted: bool = False  # True if the user interrupted the search
    evaluations: int = 0  # evaluations of the residuals
    name: str = "given"  # name of the start point
    start_point: FloatArray = field(default_factory=lambda: np.zeros(0))
    fixed: Mapping[str, float] = field(default_factory=dict)  # parameters fixed in this search
    excess: float = 0.0  # evidence against this optimum: cost minus that of the lowest optimum
    limit: float = np.inf  # largest excess within the 95 % confidence region
    others: tuple[Optimum, ...] = ()  # equivalent optima
    searches: tuple[Optimum, ...] = ()  # results of all searches with the initial sigmas, in their order


@dataclass
class FitObjective:
    """Residuals of all recordings as a function of the free parameters.

    The residuals are divided by the noise. The residuals of the priors come last.
    """

    experiments: Sequence[Experiment]
    free: tuple[FreeParameter, ...]  # in the order of x
    sigmas: list[float]  # noise of each channel
    progress: Callable[[int, float], Any] | None = None  # called with the number of evaluations and the least cost
    evaluations: int = 0
    fixed: Mapping[str, float] = field(default_factory=dict)  # parameters fixed at a value, for profiles and trials
    joinable: Sequence[KnownOptimum] = ()
    # Least cost so far and its point: the result if the user interrupts the search.
    best: tuple[float, FloatArray] = field(default_factory=lambda: (np.inf, np.zeros(0)))
    # Last evaluated point, residuals at this point, half their sum of squares.
    _last_residual: tuple[bytes, FloatArray, float] = (b"", np.zeros(0), np.inf)
    _slopes: tuple[tuple[bytes, float], FloatArray] = ((b"", 0.0), np.zeros((0, 0)))  # point and width, derivatives

    def __post_init__(self) -> None:
        self.channels = channels_of(self.experiments)
        self._measured = np.concatenate([fitted.channel.values for fitted in self.channels])
        sizes = [fitted.channel.values.size for fitted in self.channels]
        self._weights = 1.0 / np.repeat(self.sigmas, sizes)
        self._priors = [(k, f.prior) for k, f in enumerate(self.free) if f.prior]

    def searched_indices(self) -> NDArray[np.int64]:
        """Return the indices of the free parameters that are not fixed."""
        return np.array([k for k, f in enumerate(self.free) if f.name not in self.fixed], dtype=np.int64)

    def cost(self, x: FloatArray, loss: str = "linear") -> float:
        """Return the cost at the point `x`.

        The cost is half the sum of the squared residuals. For a robust loss, the sum of the losses replaces the sum of
        squares.
        """
        residual = self.residual(x)
        return self._last_residual[2] if loss == "linear" else float(np.sum(costs_of(residual, loss)))

    def residual(self, x: FloatArray) -> FloatArray:
        """Return the residuals at the point `x`, divided by the noise.

        The residuals of the priors follow the residuals of the samples.
        """
        key = x.tobytes()
        if self._last_residual[0] != key:
            values = by_name(self.free, x)
            model = np.concatenate([series for e in self.experiments for series in e.outputs(values)])
            residual = (model - self._measured) * self._weights
            if self._priors:
                residual = np.append(residual, [(x[k] - prior.mean) / prior.sd for k, prior in self._priors])
            cost = 0.5 * float(residual @ residual)
            if not cost < np.inf:
                residual[~np.isfinite(residual)] = FAILED
                cost = 0.5 * float(residual @ residual)
            self._last_residual = key, residual, cost
            self.evaluations += 1
            if cost < self.best[0]:
                self.best = cost, x.copy()
            if self.progress:
                self.progress(self.evaluations, self.best[0])
        return self._last_residual[1]

    def residual_and_jacobian(self, x: FloatArray, width: float = SAMPLED_DIFFERENCE) -> tuple[FloatArray, FloatArray]:
        """Return the residuals at the point `x`, divided by the noise, and their derivatives.

        `width` is the relative step of the finite differences, which are used only for circuits with sampled
        controllers.
        """
        residual = self.residual(x)
        return residual, self._weighted_slopes(x, width)[:, :-1]

    def local_model(self, x: FloatArray, width: float, loss: str, indices: Places) -> LocalModel:
        """Return a linear model of the residuals near the point `x`, from which a search computes its next step.

        `indices` are the indices of the parameters that change, `loss` is the loss function, and `width` the relative
        step of finite differences.
        """
        columns, residual = self._weighted_slopes(x, width), self.residual(x)
        columns[:, -1] = residual
        if loss == "linear":
            triangle, force = triangular_factor(columns), residual
        else:
            force, root = residual * weights_of(residual, loss), np.sqrt(curvatures_of(residual, loss))
            rows = columns * root[:, np.newaxis]
            rows[:, -1] = force / root
            triangle = triangular_factor(rows)
        return LocalModel(triangle[:, indices], triangle[:, -1], columns[:, indices], force)

    def _weighted_slopes(self, x: FloatArray, width: float) -> FloatArray:
        """Return the derivatives of the weighted residuals at the point `x`, (n_residuals, n_free + 1).

        The last column is reserved for the residuals. `width` is the relative step of finite differences.
        """
        key = x.tobytes(), width
        if self._slopes[0] != key:
            values, indices = by_name(self.free, x), {f.name: k for k, f in enumerate(self.free)}
            # Columns are written and read whole.
            columns = np.zeros((self._measured.size + len(self._priors), x.size + 1), order="F")
            for row, (k, prior) in enumerate(self._priors, start=self._measured.size):
                columns[row, k] = 1.0 / prior.sd
            row = 0
            for experiment in self.experiments:
                free_indices = [indices[f.name] for f in experiment.free]
                for slope in experiment.slopes(values, width):
                    rows = slice(row, row + len(slope))
                    if free_indices == list(range(x.size)):
                        np.multiply(slope, self._weights[rows, np.newaxis], out=columns[rows, :-1])
                    else:
                        columns[rows, free_indices] = slope * self._weights[rows, np.newaxis]
                    row = rows.stop
            entries = columns.ravel(order="K")
            if not entries @ entries < np.inf:
                columns[~np.isfinite(columns)] = 0.0
            self._slopes = key, columns
        return self._slopes[1]


def count_restart_rounds(settings: SearchSettings, experiments: Sequence[Experiment]) -> int:
    """Return the maximum number of rounds of restarts near the optimum of a search.

    If the settings do not state it, it is 0 for circuits with sampled controllers, and `KICKS` for all others.
    """
    if settings.kicks is not None:
        return settings.kicks
    return 0 if any(experiment.samples for experiment in experiments) else KICKS


def optimise(
    experiments: Sequence[Experiment],
    free: tuple[FreeParameter, ...],
    settings: SearchSettings | None = None,
    *,
    progress: Callable[[int, float], Any] | None = None,
    sigmas: list[float] | None = None,
    fixed: Mapping[str, float] | None = None,
    start_point: FloatArray | None = None,
    joinable: Sequence[KnownOptimum] = (),
) -> Optimum:
    """Search for the parameter values with the lowest cost.

    The search begins at the start values, or at the point in the keyword `start_point`. The keyword `sigmas` is the
    noise of each channel from an earlier search, and `fixed` maps names of parameters to fixed values. The search ends
    if it reaches one of the known optima in `joinable`.
    """
    settings = settings or SearchSettings()
    stated_noise = [fitted.channel.noise for fitted in channels_of(experiments)]
    weights = sigmas or initial_sigmas(experiments)
    fixed = fixed or {}
    objective = FitObjective(experiments, free, list(weights), progress, fixed=fixed, joinable=joinable)
    first_point = [f.start for f in free] if start_point is None else start_point
    x = np.array([fixed.get(f.name, v) for f, v in zip(free, first_point, strict=True)])
    interrupted = False
    try:
        x = _search_locally(objective, x, settings)[0]
        # Profiles and trials start from the optimum: a restart is not necessary.
        x = x if fixed else _leave_false_minimum(objective, x, settings)
        for _ in range(ROUNDS - 1 if sigmas is None and not all(stated_noise) else 0):
            residual = objective.residual(x)
            # Each free parameter removes one degree of freedom.
            freedom = max(0.1, 1.0 - len(free) / max(1, residual.size))
            refined = [
                sigma if stated else sigma * float(np.sqrt(np.mean(residual[fitted.rows] ** 2) / freedom))
                for fitted, sigma, stated in zip(objective.channels, objective.sigmas, stated_noise, strict=True)
            ]
            settled = np.allclose(refined, objective.sigmas, rtol=0.02)
            objective = FitObjective(experiments, free, refined, progress, objective.evaluations, fixed)
            if settled:
                break
            x = _search_locally(objective, x, settings)[0]
    except KeyboardInterrupt:
        interrupted = True
        x = objective.best[1] if objective.best[1].size else x
    residual, jacobian = objective.residual_and_jacobian(x)
    cost = 0.5 * float(residual @ residual)
    low, high, scale = np.array([(f.low, f.high, f.scale) for f in free]).reshape(-1, 3).T
    active = np.where(x <= low + 1e-6 * scale, -1, np.where(x >= high - 1e-6 * scale, 1, 0))
    optimum = Optimum(x, cost, jacobian, residual, objective.sigmas, active)
    _mark_near_bounds(optimum, free, fixed)
    inside = _jacobian_inside(optimum, experiments, free, fixed)
    return replace(optimum, inside=inside, interrupted=interrupted, evaluations=objective.evaluations)


def _mark_near_bounds(optimum: Optimum, free: tuple[FreeParameter, ...], fixed: Mapping[str, float]) -> None:
    """Mark parameters as active if their distance from a bound is small compared with their standard error.

    A search can end slightly inside a bound, if the cost of the bound is almost the same.
    """
    for k, f in enumerate(free):
        sides = np.array([optimum.x[k] - f.low, f.high - optimum.x[k]])
        if optimum.active[k] or f.name in fixed or np.min(sides) > NEAR * INSIDE * f.scale:
            continue
        if np.min(sides) <= NEAR * _step_inside(optimum, f, k):
            optimum.active[k] = 1 if sides[1] < sides[0] else -1


def _step_inside(optimum: Optimum, f: FreeParameter, k: int) -> float:
    """Return the standard error of a parameter for white noise, at most a fraction of its typical size.

    `f` is the parameter, and `k` its index. Other parameters at a bound are treated as fixed.
    """
    norms = np.linalg.norm(optimum.jacobian, axis=0)
    others = (optimum.active == 0) & (norms > 0.0)
    others[k] = False
    basis = np.linalg.qr(optimum.jacobian[:, others] / norms[others])[0]
    column = optimum.jacobian[:, k]
    sensitivity = float(np.linalg.norm(column - basis @ (basis.T @ column)))
    return float(min(INSIDE * f.scale, INSIDE * (f.high - f.low), 1.0 / max(sensitivity, INEXACT * norms[k], 1e-300)))


def _jacobian_inside(
    optimum: Optimum, experiments: Sequence[Experiment], free: tuple[FreeParameter, ...], fixed: Mapping[str, float]
) -> FloatArray:
    """Return the Jacobian of the weighted residuals at a point slightly inside the active bounds.

    The result is empty if no parameter is at a bound. Parameters in `fixed` do not count.
    """
    point = optimum.x.copy()
    for k, f in enumerate(free):
        if optimum.active[k] and f.name not in fixed and np.any(optimum.jacobian[:, k]):
            point[k] -= optimum.active[k] * _step_inside(optimum, f, k)
    if np.array_equal(point, optimum.x):
        return np.zeros((0, 0))
    jacobian = FitObjective(experiments, free, optimum.sigmas, fixed=fixed).residual_and_jacobian(point)[1]
    # A simulation that fails there gives no derivatives.
    return np.where(np.linalg.norm(jacobian, axis=0) > 0.0, jacobian, optimum.jacobian)


def random_point(free: tuple[FreeParameter, ...], generator: np.random.Generator) -> FloatArray:
    """Return a random start point within the bounds.

    A parameter that is positive or without finite bounds is within a factor of ten of its start value.
    """
    point = []
    for f in free:
        if np.isfinite(f.low) and np.isfinite(f.high) and f.low <= 0.0:
            point.append(generator.uniform(f.low, f.high) if f.high - f.low <= 100.0 * f.scale else f.start)
        else:
            point.append(np.clip(f.start * 10.0 ** generator.uniform(-1.0, 1.0), f.low, f.high))
    return np.array(point)


def _leave_false_minimum(objective: FitObjective, x: FloatArray, settings: SearchSettings) -> FloatArray:
    """Restart a search from other points while its residuals are not white noise.

    The result is the best point. `x` is the end point of the first search. The reason for restarts is a false minimum
    of a discharge near the isothermal or the adiabatic limit, where the residuals are not white. Conductance and wall
    conductance compensate each other there.
    """
    max_rounds = count_restart_rounds(settings, objective.experiments)
    if max_rounds == 0:
        return x
    start = np.array([objective.fixed.get(f.name, f.start) for f in objective.free])
    cost, is_white = objective.cost(x), not _has_coloured_residuals(objective, x)
    for _ in range(max_rounds):
        previous_cost = cost
        # Each restart point differs in one parameter.
        points = []
        for k in objective.searched_indices():
            f = objective.free[k]
            for base, factor in ((x, 10.0), (x, 0.1), (start, 10.0), (start, 0.1), (start, 1e-3)):
                points.append(base.copy())
                points[-1][k] = np.clip((base[k] or 0.1 * f.scale) * factor, f.low, f.high)
        for point in [] if is_white else points:
            optimum, other_cost = _search_locally(objective, point, settings)
            if other_cost < cost * (1.0 - 1e-6):
                x, cost, is_white = optimum, other_cost, not _has_coloured_residuals(objective, optimum)
            if is_white:
                break
        if cost > 0.999 * previous_cost:
            break
    return x


def _has_coloured_residuals(objective: FitObjective, x: FloatArray) -> bool:
    """Return True if the residuals of any channel at the point `x` are not white noise."""
    residual = objective.residual(x)
    return any(whiteness(residual[fitted.rows]) < SUSPICIOUS for fitted in objective.channels)


def _search_locally(objective: FitObjective, x: FloatArray, settings: SearchSettings) -> tuple[FloatArray, float]:
    """Return the best point that local searches from `x` reach.

    For most circuits there is one search. For circuits with sampled controllers, the best step of the finite
    differences depends on the circuit, and a search can end at a false minimum. All steps are therefore tried, first
    from `x` and then from the best point.
    """
    if not any(experiment.samples for experiment in objective.experiments):
        return _search_downhill(objective, x, settings, SAMPLED_DIFFERENCE)
    best, cost = x, np.inf
    for _ in range(2):
        start_point = best
        for width in WIDTHS:
            point, local_cost = _search_downhill(objective, start_point, settings, width)
            if local_cost < cost:
                best, cost = point, local_cost
    return best, cost


def _search_downhill(
    objective: FitObjective, x: FloatArray, settings: SearchSettings, width: float
) -> tuple[FloatArray, float]:
    """Return the end point of one local search from `x`, and its cost.

    `width` is the relative step of finite differences, which are used only for circuits with sampled controllers.
    """
    indices = objective.searched_indices()
    if indices.size == 0:
        return x, objective.cost(x)
    units, low, high = np.array([(f.scale, f.low, f.high) for f in objective.free])[indices].T
    # A slice makes a view if no parameter is fixed.
    searched = slice(indices.size) if indices.size == x.size else indices
    joined: KnownOptimum | None = None

    def whole(searched_values: FloatArray) -> FloatArray:
        full = x.copy()
        full[indices] = searched_values
        return full

    def cost(searched_values: FloatArray) -> float:
        return objective.cost(whole(searched_values), settings.loss)

    def look(searched_values: FloatArray) -> LocalModel:
        nonlocal joined
        full = whole(searched_values)
        joined = next((optimum for optimum in objective.joinable if optimum.contains(full, objective.cost(full))), None)
        if joined is not None:
            raise _JoinedError
        return objective.local_model(full, width, settings.loss, searched)

    try:
        result = search(cost, look, x[indices], low, high, units, inexact=INEXACT)
    except _JoinedError:
        assert joined is not None
        return joined.x, joined.cost
    return whole(result.x), result.cost


def initial_sigmas(experiments: Sequence[Experiment]) -> list[float]:
    """Return the standard deviation of the noise of each channel, for the first search.

    It is stated, or estimated from the samples of the channel. An estimate is at least the noise that the resolution of
    the sensor causes.
    """
    sigmas = []
    for _, channel, _ in channels_of(experiments):
        sigma = channel.noise or float(max(noise_of(channel.values), channel.quantum / np.sqrt(12.0)))
        sigmas.append(sigma if sigma > 0.0 else 1e-6 * max(float(np.ptp(channel.values)), 1e-30))
    return sigmas
