"""Chi-square contour over conductance and wall conductance, with the other free parameters refitted."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.identify.fit.fit_findings import error_model_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.search import Optimum, SearchSettings, optimise
from poppet.identify.free_parameter import FreeParameter, with_starts
from poppet.identify.result import Result
from poppet.timeseries.checks import FloatArray

ROWS = COLUMNS = 15
HALF_WIDTH = 4.0
"""Half width of the grid about the optimum, in standard deviations."""
LEVELS = {"68 %": 2.296, "95 %": 5.991}
"""Chi-square limits of the joint confidence regions of two parameters."""
WALL_DECADES = np.linspace(-2.5, 3.5, ROWS - 2)
"""Decimal exponents of the global grid of wall conductances, relative to the scale of the parameter: from nearly
adiabatic to isothermal."""

Fit = Callable[..., Optimum]
"""Fit from a start vector, with `conductance` or `wall` or both fixed at the values of the keyword arguments."""


class RowFit(NamedTuple):
    """Best fit at one fixed wall conductance, which is one row of the contour grid."""

    wall: float
    optimum: Optimum


def add_contour(plan: FitPlan, optimum: Optimum, result: Result, on_progress: Callable[[str, int, int], Any]) -> Result:
    """Add the chi-square contour, and a note on each connected 95 % region, to a result."""
    conductance_index, wall_index = contour_indices(plan.free)
    conductance_parameter, wall_parameter = plan.free[conductance_index], plan.free[wall_index]
    spread = error_model_of(plan.experiments, optimum, plan.settings)
    variance_factor = max(
        spread.variance_factor, *(spread.factor(spread.influences[k]) for k in (conductance_index, wall_index))
    )
    parameters = {"conductance": conductance_parameter, "wall": wall_parameter}
    single_start, n_fits = SearchSettings(plan.settings.loss), 0

    def fit(start: FloatArray, **fixed: float) -> Optimum:
        nonlocal n_fits
        fixed_by_name = {parameters[key].name: value for key, value in fixed.items()}
        fitted = optimise(
            plan.experiments, with_starts(plan.free, start), single_start, sigmas=optimum.sigmas, fixed=fixed_by_name
        )
        if fitted.interrupted:
            raise KeyboardInterrupt
        n_fits += 1
        on_progress("places of the contour", n_fits, ROWS * (COLUMNS + 2))
        return fitted

    try:
        wall_error = spread.deviation(spread.influences[wall_index])
        rows = _fit_rows(wall_parameter, optimum, wall_index, wall_error, fit, variance_factor)
        cells = [
            _fit_columns(row, (conductance_index, wall_index), conductance_parameter, fit, variance_factor)
            for row in rows
        ]
    except KeyboardInterrupt:
        remarks = (*result.remarks, Note("finding.stopped.contour"))
        return replace(result, conditions={**result.conditions, "interrupted": True}, remarks=remarks)
    conductances, costs = (np.array([[cell[k] for cell in row] for row in cells]) for k in (0, 1))
    least_cost = min(optimum.cost, float(np.min(costs)))
    contour: dict[str, Any] = {"x": conductances, "y": np.array([row.wall for row in rows])}
    contour["rise"] = 2.0 * (costs - least_cost) / variance_factor
    for axis, parameter in (("x", conductance_parameter), ("y", wall_parameter)):
        contour |= {f"{axis}_name": parameter.name, f"{axis}_unit": parameter.unit}
    contour["best"] = float(optimum.x[conductance_index]), float(optimum.x[wall_index])
    remarks = (*result.remarks, *_region_notes(contour))
    return replace(result, remarks=remarks, series={**result.series, "contour": contour})


def contour_indices(free: Sequence[FreeParameter]) -> tuple[int, int]:
    """Return the indices of the conductance and the wall conductance among the free parameters.

    Raises
    ------
    InputError
        If either of them is not free.
    """
    indices = []
    for fields in (("sonic_conductance", "effective_area"), ("wall_conductance",)):
        matches = [k for k, parameter in enumerate(free) if parameter.address.rpartition(".")[2] in fields]
        if not matches:
            names = tuple(parameter.name for parameter in free)
            raise InputError("fit.contour", "contour", wanted=fields[0], known=names)
        indices.append(matches[0])
    return indices[0], indices[1]


def _fit_rows(
    wall_parameter: FreeParameter,
    optimum: Optimum,
    wall_index: int,
    wall_error: float,
    fit: Fit,
    variance_factor: float,
) -> list[RowFit]:
    """Fit at each wall conductance of a grid.

    The grid is local to the optimum, or global if another region fits equally well.
    """
    low, high = wall_parameter.low, wall_parameter.high
    best = float(optimum.x[wall_index])
    offsets = HALF_WIDTH * wall_error * np.linspace(-1.0, 1.0, ROWS) if np.isfinite(wall_error) else np.zeros(1)
    local_grid = np.unique(np.clip(best + offsets, low, high))
    optima = [float(other.x[wall_index]) for other in (optimum, *optimum.others)]
    global_grid = np.unique(np.clip([0.0, *wall_parameter.scale * 10.0**WALL_DECADES, *optima], low, high))
    global_rows = _fit_from_neighbours(global_grid, best, optimum, fit)
    if local_grid.size >= 3 and not _has_other_region(global_rows, local_grid, optimum.cost, variance_factor):
        return _fit_from_neighbours(local_grid, best, optimum, fit)
    # The global grid is coarse: resolve the region of the optimum by one more point on either side.
    quarter = local_grid.size // 4
    flanks = np.setdiff1d(local_grid[[quarter, -1 - quarter]], [row.wall for row in global_rows])
    return sorted([*global_rows, *_fit_from_neighbours(flanks, best, optimum, fit)], key=_wall_of)


def _has_other_region(
    rows: Sequence[RowFit], local_grid: FloatArray, least_cost: float, variance_factor: float
) -> bool:
    """Return True if the local grid would omit a 95 % region or distort it.

    `rows` are fits on the global grid. The result is True in two cases. In the first, a wall conductance outside the
    local grid belongs to the 95 % region. In the second, chi-square inside the local grid exceeds twice the value that
    a parabola has at the edge of the grid.
    """
    for row in rows:
        rise = 2.0 * (row.optimum.cost - least_cost) / variance_factor
        is_local = local_grid[0] <= row.wall <= local_grid[-1]
        if rise > 2.0 * HALF_WIDTH**2 if is_local else rise < LEVELS["95 %"]:
            return True
    return False


def _wall_of(row: RowFit) -> float:
    return row.wall


def _fit_from_neighbours(walls: FloatArray, best: float, optimum: Optimum, fit: Fit) -> list[RowFit]:
    """Fit at each wall conductance of `walls`, outwards from the optimum.

    Each fit starts from the result of the neighbour that is closer to the optimum.
    """
    rows: list[RowFit] = []
    for branch in (walls[walls >= best], walls[walls < best][::-1]):
        neighbour = optimum
        for wall in branch:
            neighbour = fit(neighbour.x, wall=float(wall))
            rows.append(RowFit(float(wall), neighbour))
    return sorted(rows, key=_wall_of)


def _fit_columns(
    row: RowFit, pair: tuple[int, int], conductance_parameter: FreeParameter, fit: Fit, variance_factor: float
) -> list[tuple[float, float]]:
    """Fit at conductances on both sides of the best fit of a row.

    The result contains pairs of conductance and cost.
    """
    (wall, row_optimum), (conductance_index, _) = row, pair
    n_parameters = row_optimum.x.size
    nuisances = [k for k in range(n_parameters) if k not in pair and row_optimum.active[k] == 0]
    # The last diagonal element of R is the sensitivity to the conductance that the nuisance parameters cannot absorb.
    _, r_factor = np.linalg.qr(row_optimum.jacobian[:, [*nuisances, conductance_index]])
    sensitivity = max(abs(float(r_factor[-1, -1])), 1e-12 / conductance_parameter.scale)
    sigma = np.sqrt(variance_factor) / sensitivity
    best, middle = float(row_optimum.x[conductance_index]), COLUMNS // 2
    cells = {middle: (best, row_optimum.cost)}
    for direction in (1, -1):
        neighbour = row_optimum
        for offset in range(1, middle + 1):
            conductance = best + direction * offset * HALF_WIDTH * sigma / middle
            conductance = float(np.clip(conductance, conductance_parameter.low, conductance_parameter.high))
            neighbour = fit(neighbour.x, conductance=conductance, wall=wall)
            cells[middle + direction * offset] = conductance, neighbour.cost
    return [cells[column] for column in range(COLUMNS)]


def _region_notes(contour: dict[str, Any]) -> list[Note]:
    """Return one note for each connected range of wall conductances in the 95 % confidence region."""
    is_inside = contour["rise"] < LEVELS["95 %"]
    rows = np.flatnonzero(is_inside.any(axis=1))
    regions = [region for region in np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1) if region.size]
    code = f"finding.contour.{'one' if len(regions) == 1 else 'several'}"
    notes = []
    for number, region in enumerate(regions, 1):
        conductances, walls = contour["x"][region][is_inside[region]], contour["y"][region]
        facts = {"place": number, "count": len(regions), "other": contour["y_name"]}
        facts |= {"low": float(conductances.min()), "high": float(conductances.max()), "unit": contour["x_unit"]}
        facts |= {"wall_low": float(walls.min()), "wall_high": float(walls.max()), "wall_unit": contour["y_unit"]}
        notes.append(Note(code, contour["x_name"], **facts))
    return notes
