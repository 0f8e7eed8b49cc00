"""Least-squares fits of dry friction laws to rows of steady sliding, with cross-validation by groups.

The rows are selected from friction records. All parameters of a law except the Stribeck velocity are linear. A scalar
search finds the Stribeck velocity, from below the slowest row to above the fastest; the intervals include all
equivalent values. The refits without one group give the validation error. The intervals use the sum of the residuals
of each group (`poppet.identify.gum`). Therefore common errors of one recording or stroke do not make them too narrow.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import ErrorCollector, InputError
from poppet.identify.fit.residuals import correlation_time
from poppet.identify.friction.bristles import Bristles, fit_bristles
from poppet.identify.friction.motion import (
    STEADY,
    RecordedMotion,
    SlidingRows,
    bending_distances,
    is_steady,
    rows_of_recording,
    rows_of_table,
    stack_rows,
)
from poppet.identify.friction.pressure_terms import pressure_significance
from poppet.identify.friction.records import (
    COULOMB,
    SEAL,
    SEAL_EXCESS,
    STATIC,
    STRIBECK,
    VISCOUS,
    Coordinate,
    FrictionRecord,
)
from poppet.identify.gum import ClusterCovariance, cluster_covariance, coverage_factor
from poppet.timeseries.checks import FloatArray

_SEARCHED = 40
MIN_EIGENVALUE = 1e-10
"""Minimum eigenvalue of the scaled normal equations; below it, columns are not distinguishable."""
BEYOND = 3.0
"""Factor on the slowest and the fastest speed for the range of the Stribeck velocity."""
ONE_SPEED = 3.0 * STEADY
"""Relative spread of speeds below which they count as one."""
MIN_FRACTION = 0.01
"""Fraction of all rows below which the rows at a speed are ignored."""
CHANCE = 0.01
"""Probability below which the gain of a richer law within one recording is significant."""
FEWEST_RECORDS, FEWEST_STROKES, MOST_STROKES, MOST_POINTS, BLOCKS = 3, 6, 20, 12, 10
LUGRE = "lugre"
NARROW = 5.0
"""Ratio of speeds below which a viscous part and a Stribeck velocity are not identifiable."""
LEVELS_DIFFER, LEAST_PRESSURE = 0.1, 2e3
"""Minimum range of pressure differences for a fit of the seal friction: relative to the maximum, and absolute [Pa]."""


@dataclass(frozen=True)
class FrictionLaw:
    """Friction law of a body, with the friction of the seals that act on it."""

    name: str
    is_falling: bool = False  # True if friction falls from the static to the Coulomb force as speed rises
    is_viscous: bool = False
    has_pressure: bool = False  # True if the friction of the seals rises with the pressure
    grows: bool = False  # True if the difference between static and Coulomb force depends on the pressure

    @property
    def names(self) -> list[str]:
        """Names of the parameters of the friction law, the Stribeck velocity last."""
        flags = (True, self.is_falling, self.is_viscous, self.has_pressure, self.grows, self.is_falling)
        names = COULOMB, STATIC, VISCOUS, SEAL, SEAL_EXCESS, STRIBECK
        return [name for name, is_in in zip(names, flags, strict=True) if is_in]


LAWS = {
    law.name: law
    for law in (
        FrictionLaw("coulomb"),
        FrictionLaw("coulomb_viscous", is_viscous=True),
        FrictionLaw("stribeck", is_falling=True),
        FrictionLaw("stribeck_viscous", is_falling=True, is_viscous=True),
    )
}
"""Friction laws, the simplest first."""
GROWING_LAWS = {
    law.name: law
    for law in (
        FrictionLaw("stribeck_seal", is_falling=True, has_pressure=True, grows=True),
        FrictionLaw("stribeck_seal_viscous", is_falling=True, is_viscous=True, has_pressure=True, grows=True),
    )
}
"""Friction laws whose Stribeck excess depends on the pressure, fitted if the residuals show it."""


@dataclass(frozen=True, eq=False)
class FrictionData:
    """Samples of steady sliding for the fit of a friction law.

    The data also state for which recordings a force offset is fitted, and which groups of samples are withheld for
    validation.
    """

    rows: SlidingRows
    free_offsets: tuple[int, ...]  # recordings with an unknown offset of the force
    axis: str
    group: NDArray[np.int_]  # group of each row

    @classmethod
    def of(cls, rows: SlidingRows, free_offsets: Sequence[int]) -> FrictionData:
        """Return samples of steady sliding with groups for validation.

        `free_offsets` contains the indices of recordings with a free force offset. The groups are recordings if there
        are at least three. Otherwise they are points of a table, strokes of a recording, or blocks in time.
        """
        strokes, stroke = np.unique(rows.stroke, return_inverse=True)
        if np.unique(rows.record).size >= FEWEST_RECORDS:
            axis, group = "recording", rows.record
            count = np.bincount(group, rows.weight)  # equal weight of all recordings
            rows = replace(rows, weight=rows.weight / count[group] * np.mean(count[count > 0.0]))
        elif (rows.stroke < 0).all():
            # Alternate points: a contiguous range of a table would be an end of the law.
            axis, group = "point", np.arange(len(rows)) % MOST_POINTS
        elif strokes.size >= FEWEST_STROKES:
            # Neighbouring strokes form a group if there are more.
            axis, group = "stroke", np.asarray(stroke * min(strokes.size, MOST_STROKES) // strokes.size)
        else:
            axis, group = "block", np.arange(len(rows)) * BLOCKS // len(rows)
        return cls(rows, tuple(free_offsets), axis, group)

    @property
    def groups(self) -> NDArray[np.int_]:
        """Indices of the groups into which the samples are divided for validation."""
        return np.unique(self.group)


def _design_matrix(rows: SlidingRows, law: FrictionLaw, velocity: float, offsets: Sequence[int]) -> FloatArray:
    """Return the matrix by which linear parameters of a law are multiplied to give the friction, (n, n_parameters).

    `velocity` is the Stribeck velocity. The last columns belong to the force offsets of the recordings `offsets`.
    """
    sign = rows.sign
    columns = [sign]
    if law.is_falling:
        columns.append(sign * np.exp(-((rows.velocity / velocity) ** 2)))
    if law.is_viscous:
        columns.append(rows.velocity)
    if law.has_pressure:
        columns.append(sign * rows.pressure)
    if law.grows:
        columns.append(columns[1] * rows.pressure)
    return np.stack([*columns, *(np.where(rows.record == k, 1.0, 0.0) for k in offsets)], axis=1)


@dataclass(frozen=True, eq=False)
class LawSolution:
    """Parameters of a friction law that fit a set of samples best, with the cost."""

    law: FrictionLaw
    values: Mapping[str, float]
    offsets: Mapping[int, float]
    cost: float

    def design(self, rows: SlidingRows, offsets: Sequence[int] = ()) -> FloatArray:
        """Return the matrix that gives the friction from the linear parameters, (n, n_parameters).

        The matrix is valid for the fitted Stribeck velocity. Its last columns belong to the force offsets of the
        recordings `offsets`.
        """
        return _design_matrix(rows, self.law, self.values.get(STRIBECK, 1.0), offsets)

    def friction(self, rows: SlidingRows) -> FloatArray:
        """Return the friction of each sample according to the law [N].

        Force offsets are not included.
        """
        linear = np.array([self.values[name] for name in self.law.names if name != STRIBECK])
        if self.law.is_falling:
            linear[1] -= linear[0]  # excess of the static force
        return np.asarray(self.design(rows) @ linear)

    def force_offset(self, rows: SlidingRows) -> FloatArray:
        """Return the fitted offset of the force sensor at each sample, (n,) [N]."""
        return np.array([self.offsets.get(int(k), 0.0) for k in rows.record])

    def residuals_for(self, rows: SlidingRows, unknown: Sequence[int] = ()) -> FloatArray:
        """Return modelled minus measured friction at each sample, (n,) [N].

        `rows` contains the samples, and `unknown` the indices of recordings with free offsets. If no offset of such a
        recording was fitted, the mean of its residuals is subtracted from them.
        """
        errors = self.friction(rows) + self.force_offset(rows) - rows.friction
        for k in unknown:
            is_record = rows.record == k
            if k not in self.offsets and is_record.any():
                errors[is_record] -= np.average(errors[is_record], weights=rows.weight[is_record])
        return np.asarray(errors)


def _solve_linear(rows: SlidingRows, law: FrictionLaw, velocity: float, offsets: Sequence[int]) -> LawSolution | None:
    """Fit the linear parameters of a friction law for the Stribeck velocity `velocity`.

    No parameter is negative, except the dependence of the Stribeck excess (static minus Coulomb friction) on the
    pressure. The result is None if the samples do not determine the parameters.
    """
    matrix = _design_matrix(rows, law, velocity, offsets)
    weighted = matrix * rows.weight[:, None]
    gram, right_side = matrix.T @ weighted, rows.friction @ weighted
    sizes = np.sqrt(np.maximum(np.diag(gram), 1e-300))
    gram, right_side = gram / sizes / sizes[:, None], right_side / sizes
    if np.linalg.eigvalsh(gram)[0] < MIN_EIGENVALUE:
        return None
    count = matrix.shape[1] - len(offsets)
    is_positive = np.ones(matrix.shape[1], dtype=bool)
    for _ in range(count):
        linear = np.zeros(is_positive.size)
        linear[is_positive] = np.linalg.solve(gram[np.ix_(is_positive, is_positive)], right_side[is_positive])
        worst = int(np.argmin(linear[: count - law.grows]))
        if linear[worst] >= 0.0:
            break
        is_positive[worst] = False
    linear = np.where(is_positive, linear, 0.0) / sizes
    error = matrix @ linear - rows.friction
    cost = float(error @ (error * rows.weight))
    values = dict(zip(law.names, linear[:count].tolist(), strict=False))
    if law.is_falling:
        values[STATIC] += values[COULOMB]
        values[STRIBECK] = velocity
    zeros = dict(zip(offsets, linear[count:].tolist(), strict=True))
    return LawSolution(law, values, zeros, cost)


def find_minima(rows: SlidingRows, law: FrictionLaw, free_offsets: Sequence[int]) -> list[LawSolution]:
    """Return the fits of a law at all local minima of the cost, the best first.

    The cost is a function of the Stribeck velocity. `free_offsets` contains the indices of recordings with a free force
    offset.
    """
    from scipy.optimize import minimize_scalar

    offsets = [k for k in free_offsets if (rows.record == k).any()]
    # Upper limit: the cost without friction.
    max_cost = 2.0 * float(rows.friction @ (rows.friction * rows.weight)) + 1e-300

    def solve(logarithm: float) -> LawSolution | None:
        return _solve_linear(rows, law, math.exp(logarithm), offsets)

    def cost(logarithm: float) -> float:
        solution = solve(logarithm)
        return solution.cost if solution else max_cost

    if not law.is_falling:
        return [solution] if (solution := solve(0.0)) else []
    grid, minima = search_grid(rows), []
    costs = np.array([cost(x) for x in grid])
    is_lower, is_higher = np.diff(costs, prepend=math.inf) < 0.0, np.diff(costs, append=math.inf) >= 0.0
    for k in np.flatnonzero(is_lower & is_higher & (costs < max_cost)).tolist():
        ends = grid[max(k - 1, 0)], grid[min(k + 1, grid.size - 1)]
        best = minimize_scalar(cost, bounds=ends, method="bounded", options={"xatol": 1e-4})
        solutions = [solution for x in (best.x, grid[k]) if (solution := solve(x))]
        minima.append(min(solutions, key=lambda solution: solution.cost))
    return sorted(minima, key=lambda solution: solution.cost)


def search_grid(rows: SlidingRows) -> FloatArray:
    """Return the logarithms of the Stribeck velocities at which the search evaluates the cost."""
    speed = np.abs(rows.velocity[rows.velocity != 0.0])
    low, high = float(np.quantile(speed, 0.02)) / BEYOND, float(speed.max()) * BEYOND
    return np.linspace(math.log(low), math.log(high), _SEARCHED)


@dataclass(frozen=True, eq=False)
class FrictionLawFit:
    """Fit of a friction law to all samples, and again without each group of samples for validation."""

    data: FrictionData
    solution: LawSolution
    other_minima: tuple[LawSolution, ...]  # further minima over the Stribeck velocity
    held_out: FloatArray  # weighted mean square error of each group when it is withheld
    held_out_rms: float  # rms error of all withheld rows [N]

    @property
    def values(self) -> Mapping[str, float]:
        """Mapping from the name of each parameter of the friction law to its fitted value."""
        return self.solution.values

    @cached_property
    def errors(self) -> FloatArray:
        """Residuals of all samples: modelled minus measured friction [N]."""
        return self.solution.residuals_for(self.data.rows)

    @cached_property
    def spread(self) -> ClusterCovariance:
        """Covariance and degrees of freedom of the parameters, from the scatter between groups of samples."""
        rows, values, law = self.data.rows, self.values, self.solution.law
        if law.name == "coulomb" and self.data.axis == "recording":
            # One mean level per recording; a line versus the pressure fits the levels.
            masks = [rows.record == k for k in self.data.groups]
            errors = np.array([np.mean((rows.sign * self.errors)[mask]) for mask in masks])
            table = np.stack([np.ones(len(masks)), [np.mean(rows.pressure[mask]) for mask in masks]], axis=1)
            table = table[:, : len(values)]
            freedom = max(len(masks) - len(values), 1)
            covariance = float(errors @ errors) / freedom * np.linalg.inv(table.T @ table)
            return ClusterCovariance(covariance, np.full(len(values), float(freedom)))
        root = np.sqrt(rows.weight)
        return cluster_covariance(self.jacobian * root[:, None], self.errors * root, self.data.group, len(values))

    @cached_property
    def jacobian(self) -> FloatArray:
        """Derivatives of the modelled force at each sample.

        The first columns are derivatives with respect to the parameters of the law. The other columns are derivatives
        with respect to the force offsets.
        """
        rows, values = self.data.rows, self.values
        columns = self.solution.design(rows, [*self.solution.offsets])
        if self.solution.law.is_falling:
            # Parameters are the static force, not its excess, and the Stribeck velocity after the linear parameters.
            ratio, falling = rows.velocity / values[STRIBECK], columns[:, 1].copy()
            excess = values[STATIC] - values[COULOMB] + values.get(SEAL_EXCESS, 0.0) * rows.pressure
            slope = excess * falling * 2.0 * ratio**2 / values[STRIBECK]
            columns[:, 0] -= falling
            columns = np.insert(columns, len(values) - 1, slope, axis=1)
        return columns

    @property
    def excess_significance(self) -> float:
        """Significance of a dependence of the Stribeck excess on the pressure.

        The Stribeck excess is static minus Coulomb friction. The value is the dependence divided by the half width of
        its 99 % interval. A viscous coefficient that depends on the pressure is a nuisance parameter of this test.
        """
        if not self.solution.law.is_falling or not self.solution.law.has_pressure:
            return 0.0
        return self._pressure_statistic(self._falling, self.data.rows.velocity)

    @property
    def viscous_significance(self) -> float:
        """Significance of a viscous coefficient that depends on the pressure.

        The value is the dependence divided by the half width of its 99 % interval.
        """
        nuisances = [self._falling] if self.solution.law.is_falling else []
        return self._pressure_statistic(self.data.rows.velocity, *nuisances)

    @property
    def _falling(self) -> FloatArray:
        rows = self.data.rows
        return np.asarray(rows.sign * np.exp(-((rows.velocity / self.values[STRIBECK]) ** 2)))

    def _pressure_statistic(self, column: FloatArray, *nuisances: FloatArray) -> float:
        return pressure_significance(self.data.rows, self.jacobian, column, nuisances, self.data.group)

    @cached_property
    def residual_correlation_time(self) -> float:
        """Correlation time of the residuals, in samples. For a friction table, the value is 1."""
        return correlation_time(self.errors) if self.data.axis != "point" else 1.0

    @cached_property
    def equivalent_solutions(self) -> list[LawSolution]:
        """Fits at other Stribeck velocities that are not significantly worse.

        The effective number of samples in this test is their number divided by the correlation time of the residuals.
        """
        rows, law = self.data.rows, self.solution.law
        if not law.is_falling:
            return []
        freedom = max(len(rows) / self.residual_correlation_time - len(self.values), 1.0)
        limit = self.solution.cost * (1.0 + coverage_factor(freedom) ** 2 / freedom)
        offsets = [*self.solution.offsets]
        solutions = [_solve_linear(rows, law, math.exp(x), offsets) for x in search_grid(rows)]
        return [solution for solution in solutions if solution and solution.cost <= limit]

    def interval(self, name: str) -> tuple[float, float, float]:
        """Return the standard error of a parameter, and both ends of its 95 % interval."""
        index = list(self.values).index(name)
        error = float(np.sqrt(self.spread.covariance[index, index]))
        half = coverage_factor(float(self.spread.freedom[index])) * error if math.isfinite(error) else math.inf
        value = self.values[name]
        low, high = value - half, value + half
        if self.equivalent_solutions and name in (STRIBECK, STATIC, COULOMB):
            ends = [solution.values[name] for solution in self.equivalent_solutions]
            low, high = min(low, *ends), max(high, *ends)
            if name in (STRIBECK, STATIC) and self._is_open(0):
                low, high = (0.0, high) if name == STRIBECK else (low, math.inf)
            if name in (STRIBECK, COULOMB) and self._is_open(-1):
                low, high = (low, math.inf) if name == STRIBECK else (0.0, high)
        return error, low if name == SEAL_EXCESS else max(low, 0.0), high

    def _is_open(self, end: int) -> bool:
        """Return True if the data give no limit on the Stribeck velocity at one end of the search range.

        The fit at this end is then not significantly worse than the best fit. `end` is 0 for the lower end and -1 for
        the upper end.
        """
        last = float(search_grid(self.data.rows)[end])
        return any(abs(math.log(solution.values[STRIBECK]) - last) < 1e-9 for solution in self.equivalent_solutions)


def count_speeds(rows: SlidingRows) -> int:
    """Return the number of clearly different speeds in the samples.

    Speeds with few samples do not count. A fit needs at least one speed for each parameter of the law that depends on
    speed.
    """
    speed, count = np.sort(np.abs(rows.velocity)), 0
    while speed.size:
        n_rows = int(np.searchsorted(speed, speed[0] * (1.0 + 2.0 * ONE_SPEED), side="right"))
        count += n_rows >= MIN_FRACTION * len(rows)
        speed = speed[n_rows:]
    return count


def fit_friction_law(data: FrictionData, law: FrictionLaw) -> FrictionLawFit | None:
    """Fit a friction law to all samples, and again without each group of samples.

    The result is None if the data do not determine the parameters of the law, either with all samples or without one of
    the groups.
    """
    rows = data.rows
    if count_speeds(rows) < 1 + law.is_viscous + 2 * law.is_falling:
        return None
    minima = find_minima(rows, law, data.free_offsets)
    if not minima or len(rows) <= len(law.names) + len(data.free_offsets):
        return None
    mean_squares, errors = [], []
    for k in data.groups:
        refits = find_minima(rows.of(data.group != k), law, data.free_offsets)
        if not refits:
            return None
        withheld = rows.of(data.group == k)
        errors.append(refits[0].residuals_for(withheld, data.free_offsets))
        mean_squares.append(float(np.average(errors[-1] ** 2, weights=withheld.weight)))
    score = float(np.sqrt(np.mean(np.concatenate(errors) ** 2)))
    return FrictionLawFit(data, minima[0], tuple(minima[1:]), np.array(mean_squares), score)


def is_better(fit: FrictionLawFit, reference: FrictionLawFit) -> bool:
    """Return True if a fit predicts withheld samples significantly better than another fit.

    If the groups are recordings, Student's t test at 95 % compares the mean square errors of the recordings. For all
    other groups, an F test at 99 % compares the sums of squares, with the number of uncorrelated samples.
    """
    if fit.held_out_rms >= reference.held_out_rms:
        return False
    rows = fit.data.rows
    # A relative difference of 1e-4 of the friction is insignificant.
    negligible = 1e-8 * float(rows.friction @ (rows.friction * rows.weight))
    if fit.data.axis == "recording":
        difference = reference.held_out - fit.held_out
        error = float(np.std(difference, ddof=1)) / math.sqrt(difference.size)
        least = negligible / float(rows.weight.sum())
        return float(difference.mean()) > max(coverage_factor(difference.size - 1.0, 0.9) * error, least)
    from scipy.special import fdtrc

    numbers = len(fit.values) + len(fit.solution.offsets)
    freedom = max(len(rows) / fit.residual_correlation_time - numbers, 1.0)
    n_additional = max(len(fit.values) - len(reference.values), 1)
    gain = (reference.solution.cost - fit.solution.cost) / n_additional
    return gain > negligible and bool(
        fdtrc(n_additional, freedom, gain * freedom / max(fit.solution.cost, 1e-9 * negligible)) < CHANCE
    )


@dataclass(frozen=True, eq=False)
class FrictionFits:
    """Fits of all friction laws, with the samples and recordings that findings and report need."""

    records: tuple[FrictionRecord, ...]
    motions: tuple[RecordedMotion, ...]
    data: FrictionData
    distance: float  # median distance after a reversal before steady sliding [m]
    fits: Mapping[str, FrictionLawFit]
    requested: str  # requested law, `best` or `lugre`
    is_offset_known: bool  # True if the offset of the force is given or free
    grows: bool = False  # True if the Stribeck excess depends on the pressure beyond chance

    @property
    def coordinate(self) -> Coordinate:
        """Kind of motion of the body: translation or rotation."""
        return self.records[0].coordinate

    @property
    def is_one_way(self) -> bool:
        """True if all samples have the same direction of sliding."""
        return bool(np.ptp(self.data.rows.sign) == 0.0)

    @cached_property
    def ranked(self) -> list[str]:
        """Names of the friction laws in the order of their validation errors, the best first."""
        return sorted(self.fits, key=lambda name: self.fits[name].held_out_rms)

    @cached_property
    def equivalent(self) -> list[str]:
        """Names of the friction laws that are not significantly worse than the best law, the simplest first."""
        candidates = [name for name in self.ranked if (name in GROWING_LAWS) == self.grows]
        best = self.fits[candidates[0]]
        return [n for n, fit in self.fits.items() if n in candidates and (fit is best or not is_better(best, fit))]

    @property
    def supported(self) -> str:
        """Name of the simplest friction law that is not significantly worse than the best law."""
        return self.equivalent[0]

    @property
    def selected(self) -> str:
        """Name of the friction law that the result uses."""
        return self.supported if self.requested in ("best", LUGRE) else self.requested

    @property
    def fit(self) -> FrictionLawFit:
        """Fit of the selected friction law."""
        return self.fits[self.selected]

    @cached_property
    def speeds(self) -> tuple[float, float]:
        """2 % and 98 % quantiles of the speeds of all samples [m/s] or [rad/s]."""
        low, high = np.quantile(np.abs(self.data.rows.velocity), [0.02, 0.98]).tolist()
        return low, high

    @cached_property
    def mean_friction(self) -> float:
        """Mean magnitude of the modelled friction over all samples, which is positive [N]."""
        return max(float(np.mean(np.abs(self.fit.solution.friction(self.data.rows)))), 1e-300)

    @property
    def is_narrow(self) -> bool:
        """True if the range of speeds is too small to separate the terms of a friction law."""
        return self.speeds[1] < NARROW * self.speeds[0]

    @cached_property
    def bristles(self) -> Bristles | None:
        """Estimates of stiffness and damping of the bristles.

        The value is None if there are too few reversals.
        """
        return fit_bristles(self.motions, self.fit.values, self.fit.solution.offsets, self.distance)

    @cached_property
    def lacks_viscous_pressure_term(self) -> bool:
        """True if the residuals depend significantly on the product of pressure and speed."""
        return SEAL in self.fit.values and abs(self.fit.viscous_significance) > 1.0

    @property
    def reversals(self) -> int:
        """Number of reversals of the motion in all recordings."""
        return sum(len(motion.reversals) for motion in self.motions)


def fit_records(
    records: Sequence[FrictionRecord],
    law: str,
    offset: float | str | None,
    smoothing: float | None,
    within: tuple[float, float] | None,
    mass: float,
) -> FrictionFits:
    """Fit all friction laws to the samples of steady sliding in records.

    `law` is the requested law. `offset` is the known force offset, or `free`. `smoothing` is the window of the
    velocities [s], and `within` the range of positions. `mass` is the mass of the body, or its moment of inertia.
    """
    records = tuple(records)
    if isinstance(offset, float | int) and offset != 0.0:
        records = tuple(replace(record, force=record.force - float(offset)) for record in records)
    motions, strokes = [], 0
    for index, record in enumerate(records):
        if record.is_motion:
            motion = rows_of_recording(record, index, strokes, smoothing, mass)
        else:
            motion = rows_of_table(record, index)
        strokes = int(np.max(motion.rows.stroke, initial=strokes - 1)) + 1
        motions.append(motion)
    distances = bending_distances(motions)
    distance = float(np.median(list(distances.values()))) if distances else 0.0
    rows = stack_rows([motion.rows for motion in motions])
    distance_of_row = np.array([distances[int(k)] for k in rows.stroke])
    slides = (rows.distance > distance_of_row) & (rows.sign != 0.0) & is_steady(rows, distance_of_row)
    if within is not None:
        slides &= np.isnan(rows.position) | ((rows.position >= within[0]) & (rows.position <= within[1]))
    rows = rows.of(slides)
    free_offsets = [k for k, r in enumerate(records) if offset == "free" or (offset is None and r.is_motion)]
    with ErrorCollector() as errors:
        for first, second in itertools.combinations(records, 2):
            # An absent channel is None, which equals only None.
            if all(np.array_equal(getattr(first, n), getattr(second, n)) for n in ("force", "velocity", "position")):
                errors.add("friction.same_twice", "file", name=first.name, other=second.name)
        for k, record in enumerate(records):
            if record.body != records[0].body:
                errors.add("friction.bodies", record.name, body=record.body, other=records[0].body)
            record_rows, unit = rows.of(rows.record == k), record.coordinate.effort_unit
            levels = [np.mean(record_rows.friction[record_rows.sign == sign]) for sign in np.unique(record_rows.sign)]
            zero = np.mean(levels) if levels and k in free_offsets else 0.0
            along = record_rows.sign * (record_rows.friction - zero)
            if not record_rows.velocity.any():
                errors.add("friction.at_rest", "position" if record.is_motion else "velocity", name=record.name)
            elif k in free_offsets and len(levels) < 2:
                errors.add("friction.one_way", "offset", name=record.name, unit=unit)
            elif len(levels) > 1 and not np.ptp(record.force):
                force = float(record.force[0])
                errors.add("friction.still", record.coordinate.effort, name=record.name, value=force, unit=unit)
            elif np.mean(along) < -0.5 * np.sqrt(np.mean(along**2)):  # the friction acts along the motion
                errors.add("friction.helps", record.coordinate.effort, name=record.name)
    span = float(np.ptp(rows.pressure)) if len(rows) else 0.0
    has_pressure = span > max(LEVELS_DIFFER * float(np.max(rows.pressure, initial=0.0)), LEAST_PRESSURE)
    data = FrictionData.of(rows, free_offsets)
    candidates = {name: replace(candidate, has_pressure=has_pressure) for name, candidate in LAWS.items()}
    fits = {name: fit for name, candidate in candidates.items() if (fit := fit_friction_law(data, candidate))}
    if not fits:
        raise InputError("friction.no_law", records[0].coordinate.effort, count=len(rows))
    is_offset_known = offset is not None or any(record.is_motion for record in records)
    analysis = FrictionFits(records, tuple(motions), data, distance, fits, law, is_offset_known)
    # Laws whose Stribeck excess depends on the pressure: if the residuals show it, or if such a law is requested.
    falling = [fit for fit in fits.values() if fit.solution.law.is_falling]
    grows = bool(falling) and abs(falling[-1].excess_significance) > 1.0
    if has_pressure and (grows or law in GROWING_LAWS):
        growing = {name: fit for name, candidate in GROWING_LAWS.items() if (fit := fit_friction_law(data, candidate))}
        analysis = replace(analysis, fits={**fits, **growing}, grows=grows and bool(growing))
    if law not in ("best", LUGRE, *analysis.fits):
        raise InputError("friction.law_not_told", "law", value=law)
    return analysis


def levels_of(analysis: FrictionFits) -> list[dict[str, Any]]:
    """Return one table for each record, with its pressure and the measured and modelled mean friction."""
    solution, levels = analysis.fit.solution, []
    for k, record in enumerate(analysis.records):
        rows = analysis.data.rows.of(analysis.data.rows.record == k)
        line = float(np.mean(rows.sign * solution.friction(rows)))
        directions = [rows.of(rows.sign == sign) for sign in (1.0, -1.0) if (rows.sign == sign).any()]
        row = {
            "name": record.name,
            "pressure": float(np.mean(rows.pressure)),
            "rows": len(rows),
            "level": line - float(np.mean(rows.sign * solution.residuals_for(rows))),
            "line": line,
            "offset": solution.offsets.get(k, 0.0),
            "speeds": [float(np.mean(np.abs(one_way.velocity))) for one_way in directions],
        }
        if len(directions) == 2:
            forward, backward = directions
            row["half_of_force"] = 0.5 * float(np.mean(forward.force) - np.mean(backward.force))
            row["moves"] = 0.5 * float(np.mean(forward.pressure) - np.mean(backward.pressure))
        levels.append(row)
    return levels
