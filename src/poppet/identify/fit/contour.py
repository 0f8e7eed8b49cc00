"""Chi-square contour over conductance and wall conductance, with the other free parameters refitted."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.identify.fit.fit_findings import error_model_of
from poppet.identify.fit.fit_plan import FitPlan, refit
from poppet.identify.fit.search import Optimum
from poppet.identify.free_parameter import FreeParameter
from poppet.identify.result import Result, mark_interrupted
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


def add_contour(plan: FitPlan, optimum: Optimum, result: Result, on_progress: Callable[[str, int, int], Any]) -> Result:
    """Add the chi-square contour over conductance and wall conductance to the result of a fit.

    A note describes each connected region of 95 % confidence. `on_progress` is called after each fit that the contour
    needs.
    """
    conductance_index, wall_index = contour_indices(plan.free)
    conductance_parameter, wall_parameter = plan.free[conductance_index], plan.free[wall_index]
    spread = error_model_of(plan, optimum)
    variance_factor = max(
        spread.variance_factor, *(spread.factor(spread.influences[k]) for k in (conductance_index, wall_index))
    )
    names, n_fits = {"conductance": conductance_parameter.name, "wall": wall_parameter.name}, 0

    def fit(start: FloatArray, **fixed: float) -> Optimum:
        nonlocal n_fits
        fitted = refit(plan, start, optimum.sigmas, {names[key]: value for key, value in fixed.items()})
        n_fits += 1
        on_progress("places of the contour", n_fits, ROWS * (COLUMNS + 2))
        return fitted

    try:
        wall_error = spread.deviation(spread.influences[wall_index])
        rows = _fit_wall_conductances(wall_parameter, optimum, wall_index, wall_error, fit, variance_factor)
        cells = [
            _fit_conductances(wall, row, (conductance_index, wall_index), conductance_parameter, fit, variance_factor)
            for wall, row in rows
        ]
    except KeyboardInterrupt:
        return mark_interrupted(result, Note("finding.stopped.contour"))
    conductances, costs = (np.array([[cell[k] for cell in row] for row in cells]) for k in (0, 1))
    contour: dict[str, Any] = {"x": conductances, "y": np.array([wall for wall, _ in rows])}
    contour["rise"] = 2.0 * (costs - min(optimum.cost, float(np.min(costs)))) / variance_factor
    for axis, parameter in (("x", conductance_parameter), ("y", wall_parameter)):
        contour |= {f"{axis}_name": parameter.name, f"{axis}_unit": parameter.unit}
    contour["best"] = float(optimum.x[conductance_index]), float(optimum.x[wall_index])
    # One note for each connected range of wall conductances in the 95 % confidence region.
    is_inside = contour["rise"] < LEVELS["95 %"]
    inside = np.flatnonzero(is_inside.any(axis=1))
    regions = [region for region in np.split(inside, np.flatnonzero(np.diff(inside) > 1) + 1) if region.size]
    notes = []
    for number, region in enumerate(regions, 1):
        x, y = conductances[region][is_inside[region]], contour["y"][region]
        facts = {"place": number, "count": len(regions), "other": wall_parameter.name}
        facts |= {"low": float(x.min()), "high": float(x.max()), "unit": conductance_parameter.unit}
        facts |= {"wall_low": float(y.min()), "wall_high": float(y.max()), "wall_unit": wall_parameter.unit}
        code = f"finding.contour.{'one' if len(regions) == 1 else 'several'}"
        notes.append(Note(code, conductance_parameter.name, **facts))
    return replace(result, remarks=(*result.remarks, *notes), series={**result.series, "contour": contour})


def contour_indices(free: Sequence[FreeParameter]) -> tuple[int, int]:
    """Return the indices of conductance and wall conductance among the free parameters.

    The conductance is a sonic conductance or an effective area.

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


def _fit_wall_conductances(
    wall_parameter: FreeParameter,
    optimum: Optimum,
    wall_index: int,
    wall_error: float,
    fit: Fit,
    variance_factor: float,
) -> list[tuple[float, Optimum]]:
    """Repeat a fit with the wall conductance fixed at each value of a grid.

    The result contains pairs of wall conductance and optimum. `fit` repeats the fit from a start point. The grid covers
    `wall_error`, the standard error, several times on both sides of the optimum. It covers all wall conductances if
    another region fits equally well.
    """
    low, high = wall_parameter.low, wall_parameter.high
    best = float(optimum.x[wall_index])
    offsets = HALF_WIDTH * wall_error * np.linspace(-1.0, 1.0, ROWS) if np.isfinite(wall_error) else np.zeros(1)
    local_grid = np.unique(np.clip(best + offsets, low, high))
    optima = [float(other.x[wall_index]) for other in (optimum, *optimum.others)]
    global_grid = np.unique(np.clip([0.0, *wall_parameter.scale * 10.0**WALL_DECADES, *optima], low, high))
    global_rows = _fit_from_neighbours(global_grid, best, optimum, fit)
    # The local grid is sufficient if no 95 % region is outside it, and if chi-square inside it is nearly parabolic:
    # at most twice the value that a parabola has at the edge.
    is_sufficient = local_grid.size >= 3
    for wall, row in global_rows.items():
        rise, is_local = 2.0 * (row.cost - optimum.cost) / variance_factor, local_grid[0] <= wall <= local_grid[-1]
        is_sufficient &= not (rise > 2.0 * HALF_WIDTH**2 if is_local else rise < LEVELS["95 %"])
    if is_sufficient:
        return sorted(_fit_from_neighbours(local_grid, best, optimum, fit).items())
    # The global grid is coarse: resolve the region of the optimum by one more point on either side.
    quarter = local_grid.size // 4
    flanks = np.setdiff1d(local_grid[[quarter, -1 - quarter]], [*global_rows])
    return sorted({**global_rows, **_fit_from_neighbours(flanks, best, optimum, fit)}.items())


def _fit_from_neighbours(walls: FloatArray, best: float, optimum: Optimum, fit: Fit) -> dict[float, Optimum]:
    """Repeat a fit with the wall conductance fixed at given values, and return the optima by wall conductance.

    `best` is the wall conductance at the optimum. The fits proceed from there in both directions. Each fit starts from
    the optimum of the neighbour that is closer to `best`.
    """
    rows: dict[float, Optimum] = {}
    for branch in (walls[walls >= best], walls[walls < best][::-1]):
        neighbour = optimum
        for wall in branch.tolist():
            neighbour = rows[wall] = fit(neighbour.x, wall=wall)
    return rows


def _fit_conductances(
    wall: float,
    row_optimum: Optimum,
    pair: tuple[int, int],
    conductance_parameter: FreeParameter,
    fit: Fit,
    variance_factor: float,
) -> list[tuple[float, float]]:
    """Repeat a fit with conductance and wall conductance fixed, for several conductances.

    `wall` is the wall conductance, and `row_optimum` its best fit, from which the conductances extend to both sides.
    The result contains pairs of conductance and cost.
    """
    conductance_index, n_parameters = pair[0], row_optimum.x.size
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
