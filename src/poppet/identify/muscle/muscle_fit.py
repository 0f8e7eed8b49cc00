"""Least-squares fits of muscle force laws to taut points, with cross-validation by groups.

At most one parameter of a law is nonlinear: a scalar search finds it, and the others follow from it (variable
projection). The refits without one group give the validation error and, as a jackknife over groups, the intervals.
Common errors of one pressure or recording therefore do not make the intervals too narrow.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from poppet.identify.muscle.muscle_file import MusclePoints, levels
from poppet.laws.physics.muscle import ChouHannaford, ForceLaw, ForceTable, Sarosi, TonduLopez
from poppet.timeseries.checks import FloatArray

Terms = tuple[float | FloatArray, list[FloatArray]]
"""Fixed term of the force, and factors of the linear parameters."""
HYSTERESIS = {"hysteresis.force": "N", "hysteresis.force_per_pressure": "N/Pa"}
MOST_ROWS, ROWS = 12, 6
"""Maximum number of levels of contraction that become rows of a table, and number of rows for more levels."""
_SEARCHED = 24


class ForceLawCandidate(ABC):
    """Base class of the muscle force laws whose parameters can be fitted."""

    name: ClassVar[str]
    shapes: ClassVar[tuple[float, float] | None] = None
    """Range of the nonlinear parameter; None if the law has no nonlinear parameter."""

    def __init__(self, points: MusclePoints, selected: NDArray[np.bool_] | None = None) -> None:
        self.diameter, self.length = points.nominal_diameter, points.nominal_length

    @abstractmethod
    def columns(self, pressure: FloatArray, contraction: FloatArray, shape: float) -> Terms:
        """Return the terms of the force at each point: a fixed term, and the factors of the linear parameters.

        The force is the fixed term plus the sum of factor times parameter. `shape` is the nonlinear parameter of the
        law.
        """

    @abstractmethod
    def units(self) -> dict[str, str]:
        """Return the unit of each parameter of the force law, by address."""

    def numbers(self, linear: FloatArray, shape: float) -> list[float]:
        """Return the parameters of the force law in the order of `units`.

        `linear` contains the linear parameters of the fit, and `shape` the nonlinear one.
        """
        return [*linear.tolist(), *([] if self.shapes is None else [shape])]

    @abstractmethod
    def law(self, values: Mapping[str, float]) -> ForceLaw:
        """Return the force law for given parameter values.

        `values` maps addresses of parameters to values.
        """


class SarosiCandidate(ForceLawCandidate):
    """Force law of Sarosi with parameters that a fit determines."""

    name = "sarosi"
    shapes = (-300.0, -5.0)

    def columns(self, pressure: FloatArray, contraction: FloatArray, shape: float) -> Terms:
        fading = np.exp(shape * contraction)
        return 0.0, [pressure * fading, fading, pressure * contraction, pressure, np.ones_like(pressure)]

    def units(self) -> dict[str, str]:
        return {f"sarosi.a{k}": unit for k, unit in enumerate(("N/Pa", "N", "1", "N/Pa", "N/Pa", "N"), 1)}

    def numbers(self, linear: FloatArray, shape: float) -> list[float]:
        return [*linear[:2].tolist(), shape, *linear[2:].tolist()]

    def law(self, values: Mapping[str, float]) -> ForceLaw:
        return Sarosi(*(values[f"sarosi.a{k}"] for k in range(1, 7)))


class BraidCandidate(ForceLawCandidate):
    """Force law of Chou and Hannaford with parameters that a fit determines.

    The force is linear in the parameter b = 1/sin(alpha)^2, where alpha is the braid angle at rest.
    """

    name = "chou_hannaford"

    def columns(self, pressure: FloatArray, contraction: FloatArray, shape: float) -> Terms:
        drive = 0.25 * math.pi * self.diameter**2 * pressure
        factor = 3.0 * (1.0 - (shape if self.shapes else 1.0) * contraction) ** 2
        return -drive * factor, [drive * (factor - 1.0)]

    def units(self) -> dict[str, str]:
        return {"braid_angle": "rad"}

    def numbers(self, linear: FloatArray, shape: float) -> list[float]:
        # Below 1 there is no such angle; a right angle is the nearest.
        angle = math.asin(1.0 / math.sqrt(max(float(linear[0]), 1.0)))
        return [angle, *([] if self.shapes is None else [shape])]

    def law(self, values: Mapping[str, float]) -> ForceLaw:
        return ChouHannaford(self.diameter, self.length, values["braid_angle"])


class TonduCandidate(BraidCandidate):
    """Force law of Tondu and Lopez with parameters that a fit determines.

    It extends the law of Chou and Hannaford by the end factor k.
    """

    name = "tondu_lopez"
    shapes = (0.2, 6.0)

    def units(self) -> dict[str, str]:
        return {"braid_angle": "rad", "end_factor": "1"}

    def law(self, values: Mapping[str, float]) -> ForceLaw:
        return TonduLopez(self.diameter, values["braid_angle"], values["end_factor"])


class TableCandidate(ForceLawCandidate):
    """Table of forces with linear interpolation between levels of contraction, for a fit.

    At each level, the force is a linear function of the pressure.
    """

    name = "table"

    def __init__(self, points: MusclePoints, selected: NDArray[np.bool_] | None = None) -> None:
        super().__init__(points)
        taut = points.contraction[points.taut if selected is None else points.taut & selected]
        level = levels(taut)
        count = int(level.max()) + 1
        if count <= MOST_ROWS:
            self.rows = [float(np.mean(taut[level == k])) for k in range(count)]
        else:
            self.rows = np.linspace(float(taut.min()), float(taut.max()), ROWS).tolist()

    def columns(self, pressure: FloatArray, contraction: FloatArray, shape: float) -> Terms:
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


CANDIDATES: dict[str, type[ForceLawCandidate]] = {
    kind.name: kind for kind in (SarosiCandidate, TableCandidate, TonduCandidate, BraidCandidate)
}


@dataclass(frozen=True, eq=False)
class ForceLawFit:
    """Fit of a muscle force law to all points at which the muscle pulls, with refits for validation.

    Each refit omits one group of points.
    """

    candidate: ForceLawCandidate
    points: MusclePoints
    values: Mapping[str, float]
    without: FloatArray  # parameters of the fits without each group, (n_groups, n_parameters)
    # Validation errors by axis of the groups: modelled minus measured force of the withheld taut points [N].
    held_out: Mapping[str, FloatArray]

    @cached_property
    def law(self) -> ForceLaw:
        """Force law with the fitted parameters."""
        return self.candidate.law(self.values)

    def is_at_bound(self, name: str) -> bool:
        """Return True if the fitted value of the parameter `name` is a bound.

        The result is also True for the braid angle if no angle fits.
        """
        value, shapes = self.values[name], self.candidate.shapes or ()
        at_end = name in ("sarosi.a3", "end_factor") and any(abs(value - end) < 1e-3 * abs(end) for end in shapes)
        return at_end or (name == "braid_angle" and value == 0.5 * math.pi)

    @cached_property
    def modelled(self) -> FloatArray:
        """Modelled force at each point, including hysteresis, (n,) [N]."""
        return _force(self.candidate, self.points, self.values)

    @cached_property
    def covariance(self) -> FloatArray:
        """Covariance of the parameters, from refits without each group of points (jackknife)."""
        count = len(self.without)
        centred = self.without - self.without.mean(axis=0)
        return np.asarray((count - 1) / count * centred.T @ centred)

    @cached_property
    def errors(self) -> FloatArray:
        """Modelled minus measured force of the points at which the muscle pulls [N]."""
        return np.asarray((self.modelled - self.points.force)[self.points.taut])

    @cached_property
    def score(self) -> float:
        """Root mean square of all validation errors [N].

        The force law with the smallest value is the best.
        """
        return rms(np.concatenate([*self.held_out.values()]))


def rms(errors: FloatArray) -> float:
    """Return the root mean square of an array of errors."""
    return float(np.sqrt(np.mean(errors**2)))


def fit_force_law(points: MusclePoints, name: str) -> ForceLawFit | None:
    """Fit a muscle force law to the points at which the muscle pulls.

    The fit is repeated without each group of points. The result is None if the points, or the points without one group,
    do not determine the parameters of the law.
    """
    candidate, taut = CANDIDATES[name](points), points.taut
    values = _fit_parameters(candidate, points, taut)
    if values is None:
        return None
    held_out: dict[str, FloatArray] = {}
    without: list[list[float]] = []
    for axis, group in filter(None, (points.groups, points.second_groups)):
        errors = []
        for k in np.unique(group[taut & (group >= 0)]):
            withheld = taut & (group == k)
            # The rows of a table depend on the remaining points.
            refit_candidate = candidate if axis == points.groups[0] else type(candidate)(points, ~withheld)
            refit = _fit_parameters(refit_candidate, points, taut & ~withheld)
            if refit is None:
                return None
            errors.append((_force(refit_candidate, points, refit) - points.force)[withheld])
            if axis == points.groups[0]:
                without.append([*refit.values()])
        held_out[axis] = np.concatenate(errors)
    return ForceLawFit(candidate, points, values, np.array(without), held_out)


def error_at(fit: ForceLawFit, shift: float) -> float:
    """Return the rms error of a refit with all pressures increased by `shift` [N].

    The refit uses the points and the force law of `fit`.
    """
    shifted = replace(fit.points, pressure=fit.points.pressure + shift)
    values = _fit_parameters(fit.candidate, shifted, shifted.taut)
    assert values is not None  # the points determined the parameters before
    return rms((_force(fit.candidate, shifted, values) - shifted.force)[shifted.taut])


def _force(candidate: ForceLawCandidate, points: MusclePoints, values: Mapping[str, float]) -> FloatArray:
    static = candidate.law(values).force(points.pressure, points.contraction)
    if points.direction is None:
        return np.asarray(static)
    level, per_pressure = (values[name] for name in HYSTERESIS)
    return np.asarray(static - points.direction * (level + per_pressure * points.pressure))


def _fit_parameters(
    candidate: ForceLawCandidate, points: MusclePoints, selected: NDArray[np.bool_]
) -> dict[str, float] | None:
    """Return the parameters of a muscle force law, by address, that fit selected points best.

    `candidate` is the law, and `selected` the mask of the points. The result is None if they do not determine the
    parameters.
    """
    pressure, contraction, force = (array[selected] for array in (points.pressure, points.contraction, points.force))
    hysteresis: list[FloatArray] = []
    if points.direction is not None:
        hysteresis = [-points.direction[selected], -points.direction[selected] * pressure]

    def solve(shape: float) -> tuple[float, FloatArray, int]:
        fixed, columns = candidate.columns(pressure, contraction, shape)
        matrix = np.stack([*columns, *hysteresis], axis=1)
        sizes = np.maximum(np.linalg.norm(matrix, axis=0), 1e-300)
        linear, _, rank, _ = np.linalg.lstsq(matrix / sizes, force - fixed, rcond=1e-10)
        linear = linear / sizes
        error = fixed + matrix @ linear - force
        return float(error @ error), linear, int(rank)

    shape = 0.0
    if candidate.shapes is not None:
        from scipy.optimize import minimize_scalar

        # A geometric grid, because both limits have the same sign, then a local search.
        low, high = candidate.shapes
        grid = (np.sign(low) * np.geomspace(abs(low), abs(high), _SEARCHED)).tolist()
        k = int(np.argmin([solve(x)[0] for x in grid]))
        ends = sorted((grid[max(k - 1, 0)], grid[min(k + 1, _SEARCHED - 1)]))
        options = {"xatol": 1e-7 * abs(grid[k])}
        search = minimize_scalar(lambda x: solve(x)[0], bounds=ends, method="bounded", options=options)
        shape = float(search.x)
    _, linear, rank = solve(shape)
    units = candidate.units()
    if rank < linear.size or force.size <= len(units):
        return None
    n_law = linear.size - len(hysteresis)
    values = dict(zip(units, candidate.numbers(linear[:n_law], shape), strict=True))
    return values | dict(zip(HYSTERESIS, linear[n_law:].tolist(), strict=False))
