"""Outlet pressure against flow: droop and relief, there and back."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from poppet.bench.iso10094.evaluation import AT_LEAST, BenchTest, Curve, Evaluation, Row, largest
from poppet.bench.iso10094.plan import ROWS, Pace, Trial, held
from poppet.bench.iso10094.scale import FloatArray, Mask, Record, Scale
from poppet.bench.iso10094.shapes import at_places, branches
from poppet.bench.iso10094.sweep import caught_up, lags_of
from poppet.series.measured.noise import noise_of
from poppet.series.signals import Points

DROOP = 10.0
"""Fall of the outlet at which the capacity is read [% FS]."""
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


def flow_trial(scale: Scale, volume: float, setpoint: float, sweep: float, hold: float, load: float) -> Trial:
    """A sweep of the load to one end and back at a constant setpoint."""
    times = np.cumsum([0.0, 2.0 * hold, sweep, hold, sweep, hold])
    signal = Points(times, np.array([0.0, 0.0, load, load, 0.0, 0.0]))
    name = f"flow {'out' if load > 0 else 'in'} at {setpoint:g} % FS"
    duration = float(times[-1])
    return Trial("flow", name, held(scale, setpoint), duration, hold, sweep / ROWS, volume, load=signal)


def _trials(pace: Pace) -> list[Trial]:
    scale, sweep = pace.specimen.scale, 0.5 * pace.sweep()
    cases = ((load, setpoint) for load in (1.0, -1.0) for setpoint in pace.settings.setpoints)
    return [flow_trial(scale, pace.volume, setpoint, sweep, pace.hold, load) for load, setpoint in cases]


class Side(NamedTuple):
    """One direction of the flow: its name in rows, its sign, and the figures read from it."""

    name: str
    sign: float
    change: str
    figure: str
    hysteresis: str


SIDES = (
    Side("drawn", 1.0, "droop", "flow_droop", "flow_hysteresis"),
    Side("fed", -1.0, "rise", "relief_rise", "relief_hysteresis"),
)


class Swept(NamedTuple):
    """The outlet [% FS] of one case on an even grid of flow [kg/s], to the largest flow and back."""

    row: Row
    grid: FloatArray
    going: FloatArray
    coming: FloatArray | None


def _evaluate(found: Evaluation, records: Sequence[Record]) -> None:
    swept: dict[Side, list[Swept]] = {side: [] for side in SIDES}
    for record in records:
        x, y = found.scale.percents(record)
        still = np.abs(record.flow) <= max(NONE * float(np.max(np.abs(record.flow))), 5.0 * noise_of(record.flow))
        row: Row = {"record": record.name, "setpoint": float(np.median(x)), "outlet": _at_rest(y, still)}
        found.rows.append(row)
        for side in SIDES:
            one = _one(found, record, y, row, side)
            swept[side] += [one] if one else []
    for side in SIDES:
        _read(found, side, swept[side])
    _capacity(found)


def _at_rest(y: FloatArray, still: Mask) -> float:
    """The outlet without flow, at the end of the hold before the flow begins."""
    moving = np.flatnonzero(~still)
    before = y[: moving[0]] if moving.size and moving[0] > 3 else y[still][:10]
    return float(np.mean(before[-max(3, before.size // 5) :])) if before.size else math.nan


def _one(found: Evaluation, record: Record, y: FloatArray, row: Row, side: Side) -> Swept | None:
    """One direction of the flow in a record."""
    flow = side.sign * record.flow
    top, other = float(np.max(flow)), float(np.max(-flow))
    if top < max(LEAST_FLOW, 0.02 * other):
        return None
    row[f"largest_{side.name}"] = top
    inside = np.where(flow > 0.0, flow, 0.0)
    late = caught_up(record.time, inside, lags_of(record.time, inside, y, branches(inside, TURN * top)))
    grid = np.linspace(0.0, top, PLACES)
    going, coming = _there_and_back(inside, late, y, grid)
    if going is None:
        found.note("flow.no_rise", record.name, way=side.name)
        return None
    # Where a valve is at its limit the outlet falls at hardly less flow: no hysteresis of its regulation.
    fallen = flow[(side.sign * y < np.nanmin(side.sign * going) - FALLEN) & (flow > 0.5 * top)]
    limit = min(top, float(np.min(fallen, initial=top)))
    case = f"{row['setpoint']:.0f} % FS"
    for way, curve, end in (("going", going, top), ("coming", coming, limit)):
        if curve is not None:
            known = np.isfinite(curve) & (grid <= end)
            found.curves.append(Curve(f"{side.name} {way}", case, side.sign * grid[known], curve[known]))
    if side.sign > 0.0:
        _falls(row, late, row["outlet"] - y)
    if coming is None:
        found.note("flow.no_return", record.name, way=side.name)
        return Swept(row, grid, going, None)
    judged = (grid > 0.1 * limit) & (grid < 0.9 * limit) & np.isfinite(going) & np.isfinite(coming)
    if judged.any():
        row[f"hysteresis_{side.name}"] = float(np.max(np.abs(going - coming)[judged]))
        per_place = max(1.0, y.size / (4.0 * PLACES))
        row[f"known_to_{side.name}"] = 4.0 * noise_of(y) / math.sqrt(per_place)
    return Swept(row, grid, going, coming)


def _there_and_back(
    flow: FloatArray, late: FloatArray, y: FloatArray, grid: FloatArray
) -> tuple[FloatArray | None, FloatArray | None]:
    """The outlet on the grid, on the way to the largest flow and back."""
    top = grid[-1]
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


def _falls(row: Row, flow: FloatArray, droop: FloatArray) -> None:
    """The flow when the outlet has first fallen by so much."""
    beyond = np.flatnonzero(droop >= DROOP)
    if not beyond.size:
        row["capacity_at_least"] = float(np.max(flow))
        return
    k = int(beyond[0])
    part = (DROOP - droop[k - 1]) / (droop[k] - droop[k - 1]) if k else 0.0
    row["capacity"] = float(flow[k - 1] + part * (flow[k] - flow[k - 1])) if k else float(flow[0])


def _read(found: Evaluation, side: Side, swept: Sequence[Swept]) -> None:
    """Droop or rise at the rated flow, and the hysteresis."""
    rated = found.rated_flow
    if swept:
        rated = rated if math.isfinite(rated) else 0.5 * min(float(each.grid[-1]) for each in swept)
        found.conditions[f"flow_{side.name}"] = rated
    for row, grid, going, coming in swept:
        if rated <= grid[-1]:
            curve = going if coming is None else 0.5 * (going + coming)
            row[side.change] = float(np.interp(rated, grid, side.sign * (row["outlet"] - curve)))
        else:
            reached = float(grid[-1])
            found.note("flow.below_rated", row["record"], way=side.name, reached=reached, rated=rated)
    worst = largest(found.rows, side.change)
    if worst is None:
        found.absent(f"little_{side.name}", side.figure)
    else:
        found.add(side.figure, worst[side.change], setpoint=worst["setpoint"], flow=rated)
    widest = largest(found.rows, f"hysteresis_{side.name}")
    if widest is None:
        found.absent(f"{side.name}_one_way", side.hysteresis)
    else:
        value, least = widest[f"hysteresis_{side.name}"], widest[f"known_to_{side.name}"]
        found.add_seen(side.hysteresis, value, least, setpoint=widest["setpoint"])


def _capacity(found: Evaluation) -> None:
    """The smallest flow at which the outlet has fallen; where it never does, the smallest that was tried is a bound."""
    for key, bound in (("capacity", ""), ("capacity_at_least", AT_LEAST)):
        known = [row for row in found.rows if key in row]
        if known:
            row = min(known, key=lambda each: float(each[key]))
            found.add("flow_capacity", row[key], bound=bound, setpoint=row["setpoint"])
            return
    found.absent("none_drawn", "flow_capacity")


FLOW = BenchTest(
    "flow",
    _evaluate,
    {
        "flow_droop": "% FS", "flow_hysteresis": "% FS", "flow_capacity": "kg/s",
        "relief_rise": "% FS", "relief_hysteresis": "% FS",
    },
    {"droop": DROOP},
    trials=_trials,
    needs="flow",
    whole=("outlet", "flow"),
    smallest=("flow_capacity",),
)  # fmt: skip
