"""Fits of the laws of a muscle's force: least squares over taut points, each group held out once.

In every law all numbers but one at most are linear: the one is sought on a line, the others follow from it (variable
projection). The refits without one group give both the held-out error and, as a jackknife over groups, the intervals:
what the points of one pressure or of one recording have in common does not make the intervals too narrow.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from poppet.identify.muscle.points import MusclePoints, levels
from poppet.laws.physics.muscle import ChouHannaford, ForceLaw, ForceTable, Sarosi, TonduLopez
from poppet.timeseries.checks import FloatArray

HYSTERESIS = {"hysteresis.force": "N", "hysteresis.force_per_pressure": "N/Pa"}
MOST_ROWS, ROWS = 12, 6
"""Levels of contraction that become rows of a table; where there are more, that many rows at equal distances."""
_SEARCHED = 24


class Candidate(ABC):
    """A law with its numbers free."""

    name: ClassVar[str]
    shapes: ClassVar[tuple[float, float] | None] = None
    """Range of the number that does not enter linearly."""

    def __init__(self, points: MusclePoints, which: NDArray[np.bool_] | None = None) -> None:
        self.diameter, self.length = points.nominal_diameter, points.nominal_length

    @abstractmethod
    def columns(self, pressure: FloatArray, contraction: FloatArray, shape: float) -> tuple[Any, list[FloatArray]]:
        """The part of the force that is fixed, and what the linear numbers multiply."""

    @abstractmethod
    def units(self) -> dict[str, str]:
        """Address of each number with its unit."""

    def numbers(self, linear: FloatArray, shape: float) -> list[float]:
        """The numbers as the part takes them, in the order of `units`."""
        return [*linear.tolist(), *([] if self.shapes is None else [shape])]

    @abstractmethod
    def law(self, values: Mapping[str, float]) -> ForceLaw:
        """The law of numbers by address."""


class SarosiCandidate(Candidate):
    """Sarosi's law."""

    name = "sarosi"
    shapes = (-300.0, -5.0)

    def columns(self, pressure: FloatArray, contraction: FloatArray, shape: float) -> tuple[Any, list[FloatArray]]:
        fading = np.exp(shape * contraction)
        return 0.0, [pressure * fading, fading, pressure * contraction, pressure, np.ones_like(pressure)]

    def units(self) -> dict[str, str]:
        return {f"sarosi.a{k}": unit for k, unit in enumerate(("N/Pa", "N", "1", "N/Pa", "N/Pa", "N"), 1)}

    def numbers(self, linear: FloatArray, shape: float) -> list[float]:
        return [*linear[:2].tolist(), shape, *linear[2:].tolist()]

    def law(self, values: Mapping[str, float]) -> ForceLaw:
        return Sarosi(*(values[f"sarosi.a{k}"] for k in range(1, 7)))


class BraidCandidate(Candidate):
    """Chou and Hannaford: b = 1/sin^2 of the angle is the one number, and linear."""

    name = "chou_hannaford"

    def columns(self, pressure: FloatArray, contraction: FloatArray, shape: float) -> tuple[Any, list[FloatArray]]:
        drive = 0.25 * math.pi * self.diameter**2 * pressure
        factor = 3.0 * (1.0 - (shape if self.shapes else 1.0) * contraction) ** 2
        return -drive * factor, [drive * (factor - 1.0)]

    def units(self) -> dict[str, str]:
        return {"braid_angle": "rad"}

    def numbers(self, linear: FloatArray, shape: float) -> list[float]:
        # Below 1 no angle has it: a right angle is the nearest.
        angle = math.asin(1.0 / math.sqrt(max(float(linear[0]), 1.0)))
        return [angle, *([] if self.shapes is None else [shape])]

    def law(self, values: Mapping[str, float]) -> ForceLaw:
        return ChouHannaford(self.diameter, self.length, values["braid_angle"])


class TonduCandidate(BraidCandidate):
    """Tondu and Lopez: k as well."""

    name = "tondu_lopez"
    shapes = (0.2, 6.0)

    def units(self) -> dict[str, str]:
        return {"braid_angle": "rad", "end_factor": "1"}

    def law(self, values: Mapping[str, float]) -> ForceLaw:
        return TonduLopez(self.diameter, values["braid_angle"], values["end_factor"])


class TableCandidate(Candidate):
    """Lines over pressure at each level of contraction, straight between."""

    name = "table"

    def __init__(self, points: MusclePoints, which: NDArray[np.bool_] | None = None) -> None:
        super().__init__(points)
        taut = points.contraction[points.taut if which is None else points.taut & which]
        level = levels(taut)
        count = int(level.max()) + 1
        if count <= MOST_ROWS:
            self.rows = [float(np.mean(taut[level == k])) for k in range(count)]
        else:
            self.rows = np.linspace(float(taut.min()), float(taut.max()), ROWS).tolist()

    def columns(self, pressure: FloatArray, contraction: FloatArray, shape: float) -> tuple[Any, list[FloatArray]]:
        hats = [np.interp(contraction, self.rows, unit) for unit in np.eye(len(self.rows))]
        return 0.0, [pressure * hat for hat in hats] + hats

    def units(self) -> dict[str, str]:
        columns = {"force_per_pressure": "N/Pa", "passive_force": "N"}
        rows = range(1, len(self.rows) + 1)
        return {f"force_table.{name}_{k}": unit for name, unit in columns.items() for k in rows}

    def law(self, values: Mapping[str, float]) -> ForceLaw:
        rows = range(1, len(self.rows) + 1)
        slopes, passives = (
            [values[f"force_table.{name}_{k}"] for k in rows] for name in ("force_per_pressure", "passive_force")
        )
        return ForceTable(self.rows, slopes, passives)


CANDIDATES: dict[str, type[Candidate]] = {
    kind.name: kind for kind in (SarosiCandidate, TableCandidate, TonduCandidate, BraidCandidate)
}


@dataclass(frozen=True, eq=False)
class LawFit:
    """A law fitted to all taut points, and without each group."""

    candidate: Candidate
    points: MusclePoints
    values: Mapping[str, float]
    without: FloatArray  # numbers of the fits without each group, (n_groups, n_numbers)
    # By axis: law minus measurement of taut points by the fit without their group.
    held_out: Mapping[str, FloatArray]

    @cached_property
    def law(self) -> ForceLaw:
        """The law itself."""
        return self.candidate.law(self.values)

    def is_at_bound(self, name: str) -> bool:
        """Whether the search for the number that is not linear ended at an end of its range, or no angle fits."""
        value, shapes = self.values[name], self.candidate.shapes or ()
        at_end = name in ("sarosi.a3", "end_factor") and any(abs(value - end) < 1e-3 * abs(end) for end in shapes)
        return at_end or (name == "braid_angle" and value == 0.5 * math.pi)

    @cached_property
    def modelled(self) -> FloatArray:
        """Force at every point, hysteresis included [N]."""
        return _force(self.candidate, self.points, self.values)

    @cached_property
    def covariance(self) -> FloatArray:
        """Of the numbers: jackknife over groups."""
        count = len(self.without)
        centred = self.without - self.without.mean(axis=0)
        return np.asarray((count - 1) / count * centred.T @ centred)

    @cached_property
    def errors(self) -> FloatArray:
        """Law minus measurement of taut points [N]."""
        return np.asarray((self.modelled - self.points.force)[self.points.taut])

    @cached_property
    def score(self) -> float:
        """By which laws are ranked: root mean square of all held-out errors [N]."""
        return rms(np.concatenate([*self.held_out.values()]))


def rms(errors: FloatArray) -> float:
    """Root mean square."""
    return float(np.sqrt(np.mean(errors**2)))


def fit_law(points: MusclePoints, name: str) -> LawFit | None:
    """A law fitted to taut points, or None where these cannot tell its numbers, all of them or without one group."""
    candidate, taut = CANDIDATES[name](points), points.taut
    values = _fitted(candidate, points, taut)
    if values is None:
        return None
    held_out: dict[str, FloatArray] = {}
    without: list[list[float]] = []
    for axis, group in filter(None, (points.groups, points.crossed)):
        errors = []
        for k in np.unique(group[taut & (group >= 0)]):
            own = taut & (group == k)
            # What a table has rows for changes with what is held out.
            other_kind = candidate if axis == points.groups[0] else type(candidate)(points, ~own)
            other = _fitted(other_kind, points, taut & ~own)
            if other is None:
                return None
            errors.append((_force(other_kind, points, other) - points.force)[own])
            if axis == points.groups[0]:
                without.append([*other.values()])
        held_out[axis] = np.concatenate(errors)
    return LawFit(candidate, points, values, np.array(without), held_out)


def error_at(fit: LawFit, shift: float) -> float:
    """Root mean square of what the law misses of taut points whose pressures are moved [N]."""
    moved = replace(fit.points, pressure=fit.points.pressure + shift)
    values = _fitted(fit.candidate, moved, moved.taut)
    assert values is not None  # the points told the numbers before
    return rms((_force(fit.candidate, moved, values) - moved.force)[moved.taut])


def _force(candidate: Candidate, points: MusclePoints, values: Mapping[str, float]) -> FloatArray:
    static = candidate.law(values).force(points.pressure, points.contraction)
    if points.direction is None:
        return np.asarray(static)
    level, per_pressure = (values[name] for name in HYSTERESIS)
    return np.asarray(static - points.direction * (level + per_pressure * points.pressure))


def _fitted(candidate: Candidate, points: MusclePoints, which: NDArray[np.bool_]) -> dict[str, float] | None:
    """Numbers by address, of some of the points; None where they do not tell them all."""
    pressure, contraction, force = (each[which] for each in (points.pressure, points.contraction, points.force))
    more: list[FloatArray] = []
    if points.direction is not None:
        more = [-points.direction[which], -points.direction[which] * pressure]

    def solved(shape: float) -> tuple[float, FloatArray, int]:
        fixed, columns = candidate.columns(pressure, contraction, shape)
        matrix = np.stack([*columns, *more], axis=1)
        sizes = np.maximum(np.linalg.norm(matrix, axis=0), 1e-300)
        linear, _, rank, _ = np.linalg.lstsq(matrix / sizes, force - fixed, rcond=1e-10)
        linear = linear / sizes
        error = fixed + matrix @ linear - force
        return float(error @ error), linear, int(rank)

    shape = 0.0 if candidate.shapes is None else _best(lambda x: solved(x)[0], *candidate.shapes)
    _, linear, rank = solved(shape)
    units = candidate.units()
    if rank < linear.size or force.size <= len(units):
        return None
    own = linear.size - len(more)
    values = dict(zip(units, candidate.numbers(linear[:own], shape), strict=True))
    return values | dict(zip(HYSTERESIS, linear[own:].tolist(), strict=False))


def _best(cost: Callable[[float], float], low: float, high: float) -> float:
    """Where a cost is least, its sign that of the limits: steps of equal ratio first, then between the neighbours."""
    from scipy.optimize import minimize_scalar

    places = np.sign(low) * np.geomspace(abs(low), abs(high), _SEARCHED)
    k = int(np.argmin([cost(float(x)) for x in places]))
    ends = float(places[max(k - 1, 0)]), float(places[min(k + 1, _SEARCHED - 1)])
    return float(
        minimize_scalar(
            cost, bounds=(min(ends), max(ends)), method="bounded", options={"xatol": 1e-7 * abs(float(places[k]))}
        ).x
    )
