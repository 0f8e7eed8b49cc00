"""The misfit over conductance and wall heat, all other numbers fitted anew at every place."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.identify.fit.fit_findings import spread_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.search import Optimum, SearchSettings, optimise
from poppet.identify.free_parameter import FreeParameter, begun_at
from poppet.identify.result import Result
from poppet.timeseries.checks import FloatArray

ROWS = COLUMNS = 15
REACH = 4.0
"""Sigmas on either side of the best place that are shown."""
LEVELS = {"68 %": 2.296, "95 %": 5.991}
"""Chi-square of two numbers, below which the truth lies so often."""
DECADES = np.linspace(-2.5, 3.5, ROWS - 2)
"""Powers of ten of wall heat over its start where other regions are looked for: from none to an isothermal tank."""

Row = tuple[float, Optimum]


def contoured(plan: FitPlan, optimum: Optimum, result: Result, told: Callable[[str, int, int], Any]) -> Result:
    """A result with the misfit around its optimum, and wherever wall heat leaves it as small."""
    over, wall = conductance_and_wall(plan.free)
    spread = spread_of(plan.experiments, optimum, plan.settings)
    widening = max(spread.widening, *(spread.factor(spread.pulls[k]) for k in (over, wall)))
    quiet, done = SearchSettings(plan.settings.loss), 0

    def fit(x: FloatArray, **held: float) -> Optimum:
        nonlocal done
        names = {plan.free[{"over": over, "wall": wall}[key]].name: value for key, value in held.items()}
        found = optimise(plan.experiments, begun_at(plan.free, x), quiet, sigmas=optimum.sigmas, held=names)
        if found.interrupted:
            raise KeyboardInterrupt
        done += 1
        told("places of the contour", done, ROWS * (COLUMNS + 2))
        return found

    try:
        rows = _rows(plan.free[wall], optimum, wall, spread.deviation(spread.pulls[wall]), fit, widening)
        table = [_columns(row, (over, wall), plan.free[over], fit, widening) for row in rows]
    except KeyboardInterrupt:
        remarks = (*result.remarks, Note("finding.stopped.contour"))
        return replace(result, conditions={**result.conditions, "interrupted": True}, remarks=remarks)
    places, costs = (np.array([[each[k] for each in row] for row in table]) for k in (0, 1))
    rise = 2.0 * (costs - min(optimum.cost, float(np.min(costs)))) / widening
    found = {
        "x": places,
        "y": np.array([row[0] for row in rows]),
        "rise": rise,
        "x_name": plan.free[over].name,
        "x_unit": plan.free[over].unit,
        "y_name": plan.free[wall].name,
        "y_unit": plan.free[wall].unit,
        "best": (float(optimum.x[over]), float(optimum.x[wall])),
    }
    remarks = (*result.remarks, *_regions(found))
    return replace(result, remarks=remarks, series={**result.series, "contour": found})


def conductance_and_wall(free: Sequence[FreeParameter]) -> tuple[int, int]:
    """Places of the two numbers of a contour."""
    places = []
    for wanted in (("sonic_conductance", "effective_area"), ("wall_conductance",)):
        own = [k for k, f in enumerate(free) if f.address.rpartition(".")[2] in wanted]
        if not own:
            raise InputError("fit.contour", "contour", wanted=wanted[0], known=tuple(f.name for f in free))
        places.append(own[0])
    return places[0], places[1]


def _rows(
    wall: FreeParameter, optimum: Optimum, k: int, error: float, fit: Callable[..., Optimum], widening: float
) -> list[Row]:
    """Wall heats with the best fit at each: around the optimum, and over all decades where others fit as well."""
    best = float(optimum.x[k])
    near = best + REACH * error * np.linspace(-1.0, 1.0, ROWS) if np.isfinite(error) else np.array([best])
    near = np.unique(np.clip(near, wall.low, wall.high))
    others = [float(each.x[k]) for each in (optimum, *optimum.others)]
    far = np.unique(np.clip([0.0, *wall.scale * 10.0**DECADES, *others], wall.low, wall.high))
    wide = _along(far, best, optimum, fit)
    rises = {value: 2.0 * (row.cost - optimum.cost) / widening for value, row in wide}
    is_near = {value: near[0] <= value <= near[-1] for value in rises}
    # Outside its reach nothing else may fit, and inside nothing may be far worse than a parabola.
    stray = any(rise > 2.0 * REACH**2 if is_near[v] else rise < LEVELS["95 %"] for v, rise in rises.items())
    if stray or near.size < 3:
        # What lies within a decade of the optimum would be lost between the decades.
        beside = np.setdiff1d(near[[near.size // 4, -1 - near.size // 4]], [row[0] for row in wide])
        return sorted([*wide, *_along(beside, best, optimum, fit)], key=_value)
    return _along(near, best, optimum, fit)


def _value(row: Row) -> float:
    return row[0]


def _along(values: FloatArray, best: float, optimum: Optimum, fit: Callable[..., Optimum]) -> list[Row]:
    """The best fits at some values, each begun where that of its neighbour ended, away from the optimum."""
    found: list[Row] = []
    for way in (values[values >= best], values[values < best][::-1]):
        last = optimum
        for value in way:
            last = fit(last.x, wall=float(value))
            found.append((float(value), last))
    return sorted(found, key=_value)


def _columns(
    row: Row, pair: tuple[int, int], over: FreeParameter, fit: Callable[..., Optimum], widening: float
) -> list[tuple[float, float]]:
    """Conductances with their costs across the valley at some wall heat."""
    (value, floor), (k, _) = row, pair
    others = [i for i in range(floor.x.size) if i not in pair and floor.active[i] == 0]
    # The part of its slope that no other number imitates.
    own = np.linalg.qr(floor.jacobian[:, [*others, k]])[1][-1, -1]
    step = np.sqrt(widening) / max(abs(float(own)), 1e-12 / over.scale)
    best, middle = float(floor.x[k]), COLUMNS // 2
    found = {middle: (best, floor.cost)}
    for way in (1, -1):
        last = floor
        for column in range(1, middle + 1):
            place = float(np.clip(best + way * column * REACH * step / middle, over.low, over.high))
            last = fit(last.x, over=place, wall=value)
            found[middle + way * column] = place, last.cost
    return [found[column] for column in range(COLUMNS)]


def _regions(table: dict[str, Any]) -> list[Note]:
    """Every region in which 95 % of the truth lies, by neighbouring rows."""
    inside = table["rise"] < LEVELS["95 %"]
    rows = np.flatnonzero(inside.any(axis=1))
    parts = [part for part in np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1) if part.size]
    notes = []
    for place, part in enumerate(parts, 1):
        x, y = table["x"][part][inside[part]], table["y"][part]
        ends = {"low": float(x.min()), "high": float(x.max()), "unit": table["x_unit"]}
        of_wall = {"wall_low": float(y.min()), "wall_high": float(y.max()), "wall_unit": table["y_unit"]}
        facts = {"place": place, "count": len(parts), "other": table["y_name"], **ends, **of_wall}
        notes.append(Note(f"finding.contour.{'one' if len(parts) == 1 else 'several'}", table["x_name"], **facts))
    return notes
