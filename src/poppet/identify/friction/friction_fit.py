"""Fits of the laws of dry friction: least squares over rows of steady sliding, each group held out once.

In every law all numbers but the Stribeck velocity are linear; that one is sought on a line, from below the slowest row
to above the fastest, and what the data do not tell from its best value goes into the intervals. The refits without one
group give the held-out error. The intervals are made of what the residuals of each group add up to
(`poppet.identify.clusters`): what the samples of one recording or one stroke have in common does not make them too
narrow.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from poppet.identify.clusters import ClusterCovariance, clustered
from poppet.identify.fit.whiteness import correlation_time
from poppet.identify.friction.coordinate import COULOMB, SEAL, STATIC, STRIBECK, VISCOUS
from poppet.identify.friction.motion import STEADY, Rows
from poppet.identify.gum import coverage_factor
from poppet.timeseries.checks import FloatArray

_SEARCHED = 40
ALIKE = 1e-10
"""Least eigenvalue of the scaled normal equations below which columns cannot be told apart."""
BEYOND = 3.0
"""How far beyond the slowest and the fastest row a Stribeck velocity is sought."""
ONE_SPEED = 3.0 * STEADY
"""Spread of the speeds over their mean below which they are one."""
FEW = 0.01
"""Part of all rows below which those at a speed do not count as one."""
CHANCE = 0.01
"""Probability below which a gain of a richer law within one recording is no chance."""
FEWEST_RECORDS, FEWEST_STROKES, MOST_STROKES, MOST_POINTS, BLOCKS = 3, 6, 20, 12, 10


@dataclass(frozen=True)
class Law:
    """A law of friction, the seals' part aside."""

    name: str
    is_falling: bool = False  # from a static force to the Coulomb force
    is_viscous: bool = False

    def names(self, *, has_pressure: bool) -> list[str]:
        """Its numbers, in the order of the columns, the Stribeck velocity last."""
        wanted = (True, self.is_falling, self.is_viscous, has_pressure, self.is_falling)
        return [n for n, is_in in zip((COULOMB, STATIC, VISCOUS, SEAL, STRIBECK), wanted, strict=True) if is_in]


LAWS = {
    law.name: law
    for law in (
        Law("coulomb"),
        Law("coulomb_viscous", is_viscous=True),
        Law("stribeck", is_falling=True),
        Law("stribeck_viscous", is_falling=True, is_viscous=True),
    )
}
"""The simplest first."""


@dataclass(frozen=True, eq=False)
class Data:
    """Rows of steady sliding, what is free besides the law, and what is held out together."""

    rows: Rows
    has_pressure: bool
    free_offsets: tuple[int, ...]  # recordings whose force has an unknown zero
    axis: str
    group: NDArray[np.int_]  # of each row

    @classmethod
    def of(cls, rows: Rows, free_offsets: Sequence[int], *, has_pressure: bool) -> Data:
        """With groups: recordings where there are three, else strokes, blocks in time, or points of a table."""
        axis, group = _groups(rows)
        if axis == "recording":  # each counts alike, however long it lasted
            count = np.bincount(rows.record, rows.weight)
            rows = replace(rows, weight=rows.weight / count[rows.record] * np.mean(count[count > 0.0]))
        return cls(rows, has_pressure, tuple(free_offsets), axis, group)

    @property
    def groups(self) -> NDArray[np.int_]:
        """Their numbers."""
        return np.unique(self.group)


def _groups(rows: Rows) -> tuple[str, NDArray[np.int_]]:
    if np.unique(rows.record).size >= FEWEST_RECORDS:
        return "recording", rows.record
    if (rows.stroke < 0).all():
        # In turn: the points of a table follow no clock, and a stretch of it would be an end of the law.
        return "point", np.arange(len(rows)) % MOST_POINTS
    known, stroke = np.unique(rows.stroke, return_inverse=True)
    if known.size >= FEWEST_STROKES:
        # Of more strokes neighbours together.
        return "stroke", np.asarray(stroke * min(known.size, MOST_STROKES) // known.size)
    return "block", np.arange(len(rows)) * BLOCKS // len(rows)


def design(rows: Rows, law: Law, velocity: float, offsets: Sequence[int], *, has_pressure: bool) -> FloatArray:
    """What the linear numbers of a law multiply, shape (n_rows, n_numbers), the offsets last."""
    sign = rows.sign
    columns = [sign]
    if law.is_falling:
        columns.append(sign * np.exp(-((rows.velocity / velocity) ** 2)))
    if law.is_viscous:
        columns.append(rows.velocity)
    if has_pressure:
        columns.append(sign * rows.pressure)
    return np.stack([*columns, *(np.where(rows.record == k, 1.0, 0.0) for k in offsets)], axis=1)


@dataclass(frozen=True, eq=False)
class Solution:
    """Numbers of a law from some rows."""

    law: Law
    has_pressure: bool
    values: Mapping[str, float]
    offsets: Mapping[int, float]
    cost: float

    def friction(self, rows: Rows) -> FloatArray:
        """Of rows, without an offset [N]."""
        value = self.values
        linear = [value[COULOMB]]
        linear += [value[STATIC] - value[COULOMB]] if self.law.is_falling else []
        linear += [value[VISCOUS]] if self.law.is_viscous else []
        linear += [value[SEAL]] if self.has_pressure else []
        columns = design(rows, self.law, value.get(STRIBECK, 1.0), (), has_pressure=self.has_pressure)
        return np.asarray(columns @ np.array(linear))

    def zero(self, rows: Rows) -> FloatArray:
        """Offset of the force of each row [N]."""
        return np.array([self.offsets.get(int(k), 0.0) for k in rows.record])

    def missed(self, rows: Rows, unknown: Sequence[int] = ()) -> FloatArray:
        """Law minus measurement [N]; recordings whose offset it does not know get their own."""
        errors = self.friction(rows) + self.zero(rows) - rows.friction
        for k in unknown:
            own = rows.record == k
            if k not in self.offsets and own.any():
                errors[own] -= np.average(errors[own], weights=rows.weight[own])
        return np.asarray(errors)


def _at(rows: Rows, law: Law, velocity: float, offsets: Sequence[int], *, has_pressure: bool) -> Solution | None:
    """The best linear numbers at one Stribeck velocity, none of them below zero; None where rows leave some open."""
    matrix = design(rows, law, velocity, offsets, has_pressure=has_pressure)
    weighted = matrix * rows.weight[:, None]
    gram, wanted = matrix.T @ weighted, rows.friction @ weighted
    sizes = np.sqrt(np.maximum(np.diag(gram), 1e-300))
    gram, wanted = gram / sizes / sizes[:, None], wanted / sizes
    if np.linalg.eigvalsh(gram)[0] < ALIKE:
        return None
    count = matrix.shape[1] - len(offsets)
    kept = np.ones(matrix.shape[1], dtype=bool)
    for _ in range(count):
        linear = np.zeros(kept.size)
        linear[kept] = np.linalg.solve(gram[np.ix_(kept, kept)], wanted[kept])
        worst = int(np.argmin(linear[:count]))
        if linear[worst] >= 0.0:
            break
        kept[worst] = False
    linear = np.where(kept, linear, 0.0) / sizes
    error = matrix @ linear - rows.friction
    cost = float(error @ (error * rows.weight))
    names = law.names(has_pressure=has_pressure)
    values = dict(zip(names, linear[:count].tolist(), strict=False))
    if law.is_falling:
        values[STATIC] += values[COULOMB]
        values[STRIBECK] = velocity
    zeros = dict(zip(offsets, linear[count:].tolist(), strict=True))
    return Solution(law, has_pressure, values, zeros, cost)


def solved(rows: Rows, law: Law, free_offsets: Sequence[int], *, has_pressure: bool) -> list[Solution]:
    """The best numbers of a law, and then those at every other minimum over its Stribeck velocity."""
    offsets = [k for k in free_offsets if (rows.record == k).any()]

    def at(logarithm: float) -> Solution | None:
        return _at(rows, law, math.exp(logarithm), offsets, has_pressure=has_pressure)

    if not law.is_falling:
        return [found] if (found := at(0.0)) else []
    places = searched(rows)
    tried = [at(x) for x in places]
    # No place costs more than no friction at all.
    most = 2.0 * float(rows.friction @ (rows.friction * rows.weight)) + 1e-300
    costs = np.array([each.cost if each else most for each in tried])
    lower = np.diff(costs, prepend=math.inf) < 0.0
    higher = np.diff(costs, append=math.inf) >= 0.0
    ends = [_refined(at, places, int(k), most) for k in np.flatnonzero(lower & higher & (costs < most))]
    return sorted((each for each in ends if each), key=lambda each: each.cost)


def searched(rows: Rows) -> FloatArray:
    """Logarithms of the Stribeck velocities at which a search looks."""
    speed = np.abs(rows.velocity[rows.velocity != 0.0])
    low, high = float(np.quantile(speed, 0.02)) / BEYOND, float(speed.max()) * BEYOND
    return np.linspace(math.log(low), math.log(high), _SEARCHED)


def _refined(at: Callable[[float], Solution | None], places: FloatArray, k: int, most: float) -> Solution | None:
    """The lowest place between the neighbours of one."""
    from scipy.optimize import minimize_scalar

    ends = float(places[max(k - 1, 0)]), float(places[min(k + 1, places.size - 1)])

    def cost(x: float) -> float:
        found = at(x)
        return found.cost if found else most

    best = minimize_scalar(cost, bounds=ends, method="bounded", options={"xatol": 1e-4})
    candidates = [each for each in (at(float(best.x)), at(float(places[k]))) if each]
    return min(candidates, key=lambda each: each.cost, default=None)


@dataclass(frozen=True, eq=False)
class LawFit:
    """A law fitted to all rows, and without each group."""

    data: Data
    solution: Solution
    others: tuple[Solution, ...]  # further minima over the Stribeck velocity
    without: tuple[Solution, ...]
    held_out: FloatArray  # mean square of what is missed of each group by the fit without it, in weights
    held_out_rms: float  # of all rows [N]

    @property
    def values(self) -> Mapping[str, float]:
        """Numbers by address."""
        return self.solution.values

    @cached_property
    def errors(self) -> FloatArray:
        """Law minus measurement [N]."""
        return self.solution.missed(self.data.rows)

    @cached_property
    def spread(self) -> ClusterCovariance:
        """Covariance of the numbers and degrees of freedom of each, from the scatter of the groups."""
        if self.solution.law.name == "coulomb" and self.data.axis == "recording":
            return self._levels_spread()
        rows, value, law = self.data.rows, self.values, self.solution.law
        columns = design(
            rows, law, value.get(STRIBECK, 1.0), [*self.solution.offsets], has_pressure=self.data.has_pressure
        )
        if law.is_falling:
            # The static force instead of its excess, and the Stribeck velocity behind the linear numbers.
            ratio, falling = rows.velocity / value[STRIBECK], columns[:, 1].copy()
            bent = (value[STATIC] - value[COULOMB]) * falling * 2.0 * ratio**2 / value[STRIBECK]
            columns[:, 0] -= falling
            columns = np.insert(columns, len(value) - 1, bent, axis=1)
        root = np.sqrt(rows.weight)
        return clustered(columns * root[:, None], self.errors * root, self.data.group, len(value))

    def _levels_spread(self) -> ClusterCovariance:
        """Of a line through one level of each recording, whose scatter from it is taken as that of all."""
        rows, groups = self.data.rows, np.unique(self.data.group)
        own = [rows.record == k for k in groups]
        missed = np.array([np.mean((rows.sign * self.errors)[each]) for each in own])
        table = np.stack([np.ones(groups.size), [np.mean(rows.pressure[each]) for each in own]], axis=1)
        table = table[:, : len(self.values)]
        freedom = max(groups.size - len(self.values), 1)
        covariance = float(missed @ missed) / freedom * np.linalg.inv(table.T @ table)
        return ClusterCovariance(covariance, np.full(len(self.values), float(freedom)))

    @cached_property
    def together(self) -> float:
        """How many rows count as one, for their residuals follow each other; those of a table do not."""
        return correlation_time(self.errors) if self.data.axis != "point" else 1.0

    @cached_property
    def allowed(self) -> list[Solution]:
        """Numbers at the Stribeck velocities that the rows cannot tell from the best.

        Of residuals that follow each other fewer rows count: each `correlation_time` of them as one.
        """
        data, law = self.data, self.solution.law
        if not law.is_falling:
            return []
        freedom = max(len(data.rows) / self.together - len(self.values), 1.0)
        limit = self.solution.cost * (1.0 + coverage_factor(freedom) ** 2 / freedom)
        offsets = [*self.solution.offsets]
        found = [_at(data.rows, law, math.exp(x), offsets, has_pressure=data.has_pressure) for x in searched(data.rows)]
        return [each for each in found if each and each.cost <= limit]

    def interval(self, name: str) -> tuple[float, float, float]:
        """Standard error and ends of the interval of a number."""
        place = list(self.values).index(name)
        error = float(np.sqrt(self.spread.covariance[place, place]))
        half = coverage_factor(float(self.spread.freedom[place])) * error if math.isfinite(error) else math.inf
        value = self.values[name]
        low, high = value - half, value + half
        if self.allowed and name in (STRIBECK, STATIC, COULOMB):
            ends = [each.values[name] for each in self.allowed]
            low, high = min(low, *ends), max(high, *ends)
            if name in (STRIBECK, STATIC) and self._is_open(0):
                low, high = (0.0, high) if name == STRIBECK else (low, math.inf)
            if name in (STRIBECK, COULOMB) and self._is_open(-1):
                low, high = (low, math.inf) if name == STRIBECK else (0.0, high)
        return error, max(low, 0.0), high

    def _is_open(self, end: int) -> bool:
        """True where not even the last velocity that was searched at one end can be told from the best."""
        last = float(searched(self.data.rows)[end])
        return any(abs(math.log(each.values[STRIBECK]) - last) < 1e-9 for each in self.allowed)


def speeds_of(rows: Rows) -> int:
    """How many speeds there are that differ by more than their noise; a few rows between them make none.

    From fewer than a law has numbers of it these would be made of noise, or of what a body does between two speeds.
    """
    speed, count = np.sort(np.abs(rows.velocity)), 0
    while speed.size:
        here = int(np.searchsorted(speed, speed[0] * (1.0 + 2.0 * ONE_SPEED), side="right"))
        count += here >= FEW * len(rows)
        speed = speed[here:]
    return count


def fit_law(data: Data, law: Law) -> LawFit | None:
    """A law fitted to all rows, or None where they leave its numbers open, all of them or without one group."""
    rows, given = data.rows, {"has_pressure": data.has_pressure}
    if speeds_of(rows) < 1 + law.is_viscous + 2 * law.is_falling:
        return None
    numbers = len(law.names(**given))
    ends = solved(rows, law, data.free_offsets, **given)
    if not ends or len(rows) <= numbers + len(data.free_offsets):
        return None
    without, mean_squares, errors = [], [], []
    for k in data.groups:
        own = data.group == k
        left = solved(rows.of(~own), law, data.free_offsets, **given)
        if not left:
            return None
        without.append(left[0])
        held = rows.of(own)
        missed = left[0].missed(held, data.free_offsets)
        mean_squares.append(float(np.average(missed**2, weights=held.weight)))
        errors.append(missed)
    score = float(np.sqrt(np.mean(np.concatenate(errors) ** 2)))
    return LawFit(data, ends[0], tuple(ends[1:]), tuple(without), np.array(mean_squares), score)


def is_better(one: LawFit, other: LawFit) -> bool:
    """True where a law misses held-out groups by less than another, and by more than chance.

    Of recordings, which differ as a whole, the mean squares of each are compared, and their differences by Student's t
    at 95 %. Of strokes, blocks and points of one recording the sums of squares are, by the F test at 99 %, with as many
    rows as do not follow each other.
    """
    if one.held_out_rms >= other.held_out_rms:
        return False
    rows = one.data.rows
    # A ten-thousandth of friction decides nothing.
    nothing = 1e-8 * float(rows.friction @ (rows.friction * rows.weight))
    if one.data.axis == "recording":
        difference = other.held_out - one.held_out
        error = float(np.std(difference, ddof=1)) / math.sqrt(difference.size)
        least = nothing / float(rows.weight.sum())
        return float(difference.mean()) > max(coverage_factor(difference.size - 1.0, 0.9) * error, least)
    from scipy.special import fdtrc

    numbers = len(one.values) + len(one.solution.offsets)
    freedom = max(len(rows) / one.together - numbers, 1.0)
    more = max(len(one.values) - len(other.values), 1)
    gain = (other.solution.cost - one.solution.cost) / more
    return gain > nothing and bool(
        fdtrc(more, freedom, gain * freedom / max(one.solution.cost, 1e-9 * nothing)) < CHANCE
    )


def supported(fits: Mapping[str, LawFit]) -> tuple[str, list[str]]:
    """The simplest law that no other beats by more than chance, and those that cannot be told from the best."""
    best = min(fits, key=lambda name: fits[name].held_out_rms)
    alike = [name for name in fits if name == best or not is_better(fits[best], fits[name])]
    return alike[0], alike
