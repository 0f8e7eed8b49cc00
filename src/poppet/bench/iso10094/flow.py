"""Outlet pressure against flow: droop and relief, there and back."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from poppet.bench.iso10094.definitions import DROOP
from poppet.bench.iso10094.evaluation import AT_LEAST, AT_MOST, Curve, Evaluation, largest
from poppet.bench.iso10094.scale import FloatArray, Mask, Record, Scale
from poppet.bench.iso10094.shapes import at_places, branches
from poppet.bench.iso10094.sweep import caught_up, lag_of
from poppet.series.measured.noise import noise_of

PLACES = 81
TURN = 0.15
"""Part of the largest flow by which the flow must turn to end a branch."""
FOLD = 0.99
"""Part of the largest flow beyond which a valve may be at its limit."""
FALLEN = 2.0
"""Distance below all that was seen on the way to the largest flow at which a valve is at its limit [% FS]."""
STILL = 0.01
"""Part of the largest flow at which a sweep begins."""
NONE = 1e-3
"""Part of the largest flow that is none."""
LEAST_FLOW = 1e-9
"""Flows below this are none [kg/s]."""


def evaluate_flow(records: Sequence[Record], scale: Scale, rated_flow: float = math.nan) -> Evaluation:
    """Figures of flow drawn from and fed into the outlet."""
    found = Evaluation("flow")
    for record in records:
        if not record.flow.size:
            found.note(f"{record.name}: the flow was not recorded.")
            continue
        row: dict[str, Any] = {
            "record": record.name,
            "setpoint": float(np.median(scale.setpoint_percent(record.setpoint))),
        }
        found.rows.append(row)
        y = scale.percent(record.outlet)
        still = np.abs(record.flow) <= max(NONE * float(np.max(np.abs(record.flow))), 5.0 * noise_of(record.flow))
        row["outlet"] = _at_rest(y, still)
        _side(found, record, y, row, 1.0)
        _side(found, record, y, row, -1.0)
    _read_at(found, records, scale, rated_flow)
    _figures(found)
    return found


def _at_rest(y: FloatArray, still: Mask) -> float:
    """The outlet without flow, at the end of the hold before the flow begins."""
    moving = np.flatnonzero(~still)
    before = y[: moving[0]] if moving.size and moving[0] > 3 else y[still][:10]
    return float(np.mean(before[-max(3, before.size // 5) :])) if before.size else math.nan


def _side(found: Evaluation, record: Record, y: FloatArray, row: dict[str, Any], sign: float) -> None:
    """One direction: +1 drawn from the outlet, -1 fed into it."""
    name = "drawn" if sign > 0 else "fed"
    flow = sign * record.flow
    top = float(np.max(flow))
    other = float(np.max(-flow))
    if top < max(LEAST_FLOW, 0.02 * other):
        return
    row[f"largest_{name}"] = top
    inside = np.where(flow > 0.0, flow, 0.0)
    late = caught_up(record.time, inside, _late(record.time, inside, y, top))
    going, coming = _branches(inside, late, y, top)
    if going is None:
        found.note(f"{record.name}: the flow {name} does not rise slowly from none.")
        return
    grid = np.linspace(0.0, top, PLACES)
    # Where a valve is at its limit the outlet falls at hardly less flow: no hysteresis of its regulation.
    fallen = flow[(sign * y < np.nanmin(sign * going) - FALLEN) & (flow > 0.5 * top)]
    limit = min(top, float(np.min(fallen, initial=top)))
    case = f"{row['setpoint']:.0f} % FS"
    for way, curve in {"going": going, "coming": coming}.items():
        if curve is not None:
            known = np.isfinite(curve) & (grid <= (top if way == "going" else limit))
            found.curves.append(Curve(f"{name} {way}", case, sign * grid[known], curve[known]))
    row[f"_{name}"] = grid, going, coming
    if sign > 0.0:
        _capacity(row, late, row["outlet"] - y)
    if coming is None:
        found.note(f"{record.name}: the flow {name} does not come back: no hysteresis.")
        return
    judged = (grid > 0.1 * limit) & (grid < 0.9 * limit) & np.isfinite(going) & np.isfinite(coming)
    if judged.any():
        row[f"hysteresis_{name}"] = float(np.max(np.abs(going - coming)[judged]))
        per_place = max(1.0, y.size / (4.0 * PLACES))
        row[f"known_to_{name}"] = 4.0 * noise_of(y) / math.sqrt(per_place)


def _branches(
    flow: FloatArray, late: FloatArray, y: FloatArray, top: float
) -> tuple[FloatArray | None, FloatArray | None]:
    """The outlet on an even grid of flow, on the way to the largest flow and back."""
    grid = np.linspace(0.0, top, PLACES)
    near = np.flatnonzero(flow >= FOLD * top)
    still = np.flatnonzero(flow <= STILL * top)
    before, after = still[still < near[0]], still[still > near[-1]]
    # Between first and last arrival at the top a valve at its limit lets the outlet fall at hardly less flow.
    ways = (
        slice(int(before[-1]) + 1, int(near[0]) + 1) if before.size else None,
        slice(int(near[-1]), int(after[0])) if after.size else None,
    )
    half = 2.5 * top / PLACES
    going, coming = (None if way is None else at_places(late[way], y[way], grid, half)[0] for way in ways)
    return going, coming


def _late(time: FloatArray, flow: FloatArray, y: FloatArray, top: float) -> float:
    """Mean lag of the sweeps to the largest flow [s]."""
    parts = branches(flow, TURN * top)
    lags = [lag_of(time, flow, y, a, b) for a, b in pairwise([*parts, None]) if a is not None and a.sign > 0]
    return float(np.mean([lag.time for lag in lags if lag] or [math.nan]))


def _read_at(found: Evaluation, records: Sequence[Record], scale: Scale, rated_flow: float) -> None:
    """Droop and rise at the rated flow, and the flow of a given droop."""
    for name, sign in (("drawn", 1.0), ("fed", -1.0)):
        tops = [row[f"largest_{name}"] for row in found.rows if f"_{name}" in row]
        if not tops:
            continue
        flow = rated_flow if math.isfinite(rated_flow) else 0.5 * min(tops)
        found.conditions[f"flow_{name}"] = flow
        for row in found.rows:
            grid, going, coming = row.pop(f"_{name}", (None, None, None))
            if grid is None:
                continue
            curve = going if coming is None else 0.5 * (going + coming)
            change = sign * (row["outlet"] - curve)
            if flow <= grid[-1]:
                row["droop" if sign > 0 else "rise"] = float(np.interp(flow, grid, change))
            else:
                found.note(
                    f"{row['record']}: the flow {name} reaches {grid[-1]:.4g} kg/s, less than the rated {flow:.4g}."
                )


def _capacity(row: dict[str, Any], flow: FloatArray, droop: FloatArray) -> None:
    """The flow when the outlet has first fallen by so much."""
    beyond = np.flatnonzero(droop >= DROOP)
    if not beyond.size:
        row["capacity_at_least"] = float(np.max(flow))
        return
    k = int(beyond[0])
    part = (DROOP - droop[k - 1]) / (droop[k] - droop[k - 1]) if k else 0.0
    row["capacity"] = float(flow[k - 1] + part * (flow[k] - flow[k - 1])) if k else float(flow[0])


def _figures(found: Evaluation) -> None:
    rows = found.rows
    for name, key, side in (("flow_droop", "droop", "drawn"), ("relief_rise", "rise", "fed")):
        row = largest(rows, key)
        way = "drawn from" if side == "drawn" else "fed into"
        reason = f"no record has so much flow {way} the outlet"
        conditions = {"setpoint": row["setpoint"], "flow": found.conditions[f"flow_{side}"]} if row else {}
        found.add(name, row[key] if row else math.nan, reason=reason, **conditions)
        worst = largest(rows, f"hysteresis_{side}")
        hysteresis = name.split("_")[0] + "_hysteresis"
        if worst is None:
            found.add(hysteresis, math.nan, reason=f"no flow {way} the outlet goes there and back")
            continue
        least = worst[f"known_to_{side}"]
        value, bound = (worst[f"hysteresis_{side}"], "") if worst[f"hysteresis_{side}"] >= least else (least, AT_MOST)
        found.add(hysteresis, value, bound=bound, setpoint=worst["setpoint"])
    known = [row for row in rows if "capacity" in row]
    limits = [row for row in rows if "capacity_at_least" in row]
    smallest = min(known, key=lambda row: float(row["capacity"]), default=None)
    if smallest is not None:
        found.add("flow_capacity", smallest["capacity"], setpoint=smallest["setpoint"])
    elif limits:
        row = min(limits, key=lambda each: float(each["capacity_at_least"]))
        found.add("flow_capacity", row["capacity_at_least"], bound=AT_LEAST, setpoint=row["setpoint"])
    else:
        found.add("flow_capacity", math.nan, reason="no flow was drawn from the outlet")
