"""Outlet pressure over a slow sweep of the setpoint: linearity, hysteresis, repeatability, zero."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.bench.iso10094.definitions import RANGE
from poppet.bench.iso10094.evaluation import AT_MOST, Curve, Evaluation
from poppet.bench.iso10094.scale import FloatArray, Mask, Record, Scale
from poppet.bench.iso10094.shapes import Branch, at_places, branches, rested, stairs
from poppet.bench.iso10094.sweep import Lag, caught_up, lag_of
from poppet.series.measured.noise import noise_of

SWING = 5.0
"""Smallest turn of the setpoint that ends a branch [% FS]."""
GRID = np.linspace(0.0, 100.0, 101)
HALF = 1.0
"""Samples this near to a place of the grid count there [% FS]."""
COVERED = 0.75
"""Part of the judged range that a branch must cover."""
FEWEST_STAIRS = 8
ZERO_STEP, ZERO_SPAN, JUMP = 0.5, 4.0, 5.0
"""Rise of the outlet that leaves zero, and the range above it from which it is continued back [% FS]; a rise this much
steeper than nominal is a jump."""
SHORT = 5.0
"""Distance from the setpoint at which it counts as not reached [% FS]."""


@dataclass(frozen=True, eq=False)
class Sweep:
    """Branches of all cycles on one grid.

    Parameters
    ----------
    up, down : (n, m) array
        One row per branch; not a number where it was not [% FS].
    error : float
        One standard deviation of a value by noise [% FS].
    lag : Lag or None
        What was taken out.
    """

    up: FloatArray
    down: FloatArray
    error: float
    lag: Lag | None


def evaluate_characteristic(records: Sequence[Record], scale: Scale) -> Evaluation:
    """Figures of the static characteristic."""
    found = Evaluation("characteristic")
    sweep = _sweep(records, scale)
    inside = _judged_places()
    up, down = _mean(sweep.up), _mean(sweep.down)
    found.conditions |= {
        "branches_up": len(sweep.up), "branches_down": len(sweep.down), "range": list(RANGE),
        "sweep_rate": _rate(records, scale), "noise": sweep.error,
    }  # fmt: skip
    _straightness(found, sweep, up, down, inside)
    _repeatability(found, sweep, inside)
    _ends(found, records, scale, sweep)
    _curves(found, sweep, up, down)
    return found


def _sweep(records: Sequence[Record], scale: Scale) -> Sweep:
    rows: dict[int, list[FloatArray]] = {1: [], -1: []}
    errors = [0.0]
    judged = _judged_places()
    lag = _lag(records, scale)
    for record in records:
        x, y = scale.setpoint_percent(record.setpoint), scale.percent(record.outlet)
        noise = noise_of(y)
        late = caught_up(record.time, x, lag.time if lag else math.nan)
        for branch in branches(x, SWING):
            value, count = _branch(late, y, branch, record.time)
            if np.mean(np.isfinite(value[judged])) >= COVERED:
                rows[branch.sign].append(value)
                errors.append(noise / math.sqrt(max(1.0, float(np.median(count[judged])))))
    up, down = (np.array(rows[sign]).reshape(-1, GRID.size) for sign in (1, -1))
    return Sweep(up, down, max(errors), lag)


def _lag(records: Sequence[Record], scale: Scale) -> Lag | None:
    """Mean lag of all sweeps that stop at their upper end."""
    found = []
    for record in records:
        x, y = scale.setpoint_percent(record.setpoint), scale.percent(record.outlet)
        parts = branches(x, SWING)
        for k, branch in enumerate(parts):
            if branch.sign > 0:
                after = parts[k + 1] if k + 1 < len(parts) else None
                found.append(lag_of(record.time, x, y, branch, after))
    known = [lag for lag in found if lag is not None]
    if not known:
        return None
    return Lag(float(np.mean([lag.time for lag in known])), float(np.mean([lag.moved for lag in known])))


def _branch(x: FloatArray, y: FloatArray, branch: Branch, time: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The outlet on the grid; of a staircase the ends of its stairs are joined."""
    part = branch.samples
    held = [slice(branch.first + s.start, branch.first + s.stop) for s in stairs(x[part])]
    if len(held) >= FEWEST_STAIRS and sum(s.stop - s.start for s in held) > 0.8 * (branch.end - branch.first):
        last = [rested(time, s, 0.2) for s in held]
        places, levels = (np.array([float(np.mean(series[s])) for s in last]) for series in (x, y))
        order = np.argsort(places)
        value = np.interp(GRID, places[order], levels[order], np.nan, np.nan)
        return value, np.full(GRID.size, float(np.median([s.stop - s.start for s in last])))
    return at_places(x[part], y[part], GRID, HALF)


def _judged_places() -> Mask:
    low, high = RANGE
    return (low <= GRID) & (high >= GRID)


def _mean(rows: FloatArray) -> FloatArray:
    """Mean of the branches where all of them are known."""
    return rows.mean(axis=0) if rows.size else np.full(GRID.size, np.nan)


def _straightness(found: Evaluation, sweep: Sweep, up: FloatArray, down: FloatArray, inside: Mask) -> None:
    both = inside & np.isfinite(up) & np.isfinite(down)
    if np.count_nonzero(both) < FEWEST_STAIRS:
        reason = "no sweep goes up and down over the judged range"
        for name in ("linearity", "hysteresis"):
            found.add(name, math.nan, reason=reason)
    else:
        x, mean, gap = GRID[both], 0.5 * (up + down)[both], (down - up)[both]
        # Ends count half, as in an integral over the range: the line does not depend on how fine the grid is.
        weight = np.ones(x.size)
        weight[[0, -1]] = math.sqrt(0.5)
        slope, offset = np.polyfit(x, mean, 1, w=weight)
        away = mean - slope * x - offset
        k, j = int(np.argmax(np.abs(away))), int(np.argmax(np.abs(gap)))
        found.conditions |= {"slope": float(slope), "offset": float(offset)}
        error = sweep.error / math.sqrt(max(1, min(len(sweep.up), len(sweep.down))))
        _judged(found, "linearity", abs(away[k]), 4.0 * error, at=float(x[k]))
        _judged(found, "hysteresis", abs(gap[j]), 6.0 * error, at=float(x[j]))
        if gap[j] < 0.0 and abs(gap[j]) > 6.0 * error:
            found.note(
                f"The outlet is lower on the way down than on the way up at {x[j]:.0f} % FS: it leads the setpoint."
            )
    every = np.concatenate([sweep.up, sweep.down])[:, inside]
    away = np.abs(every - GRID[inside])
    if np.isfinite(away).any():
        place = int(np.nanargmax(away))
        at = float(GRID[inside][place % away.shape[1]])
        found.add("accuracy", float(away.flat[place]), at=at)
    else:
        found.add("accuracy", math.nan, reason="no sweep covers the judged range")


def _judged(found: Evaluation, name: str, value: float, least: float, **conditions: Any) -> None:
    """A figure that is a largest difference: below what noise makes of so many places, it is a bound."""
    if value < least:
        found.note(f"{name} is below what the noise of the recording lets see, {least:.2g} % FS.")
        found.add(name, least, bound=AT_MOST, **conditions)
    else:
        found.add(name, value, **conditions)


def _repeatability(found: Evaluation, sweep: Sweep, inside: Mask) -> None:
    spreads = [np.ptp(rows[:, inside], axis=0) for rows in (sweep.up, sweep.down) if len(rows) > 1]
    values = np.concatenate(spreads) if spreads else np.zeros(0)
    values = values[np.isfinite(values)]
    if not values.size:
        found.add("repeatability", math.nan, reason="it needs at least two cycles")
        return
    cycles = min(len(rows) for rows in (sweep.up, sweep.down) if len(rows) > 1)
    _judged(found, "repeatability", float(np.max(values)), 8.0 * sweep.error, cycles=cycles)


def _ends(found: Evaluation, records: Sequence[Record], scale: Scale, sweep: Sweep) -> None:
    """What happens at setpoint zero, and at the upper end where the sweep stops."""
    zero, offset, short = [], [], []
    for record in records:
        x, y = scale.setpoint_percent(record.setpoint), scale.percent(record.outlet)
        late = caught_up(record.time, x, sweep.lag.time if sweep.lag else math.nan)
        for branch in branches(x, SWING):
            if branch.sign > 0:
                zero.append(_leaves_zero(late[branch.samples], y[branch.samples]))
                if x[branch.end - 1] > 95.0:
                    short.append(_held_at(x, y, branch.end - 1) - float(x[branch.end - 1]))
            if abs(x[branch.first if branch.sign > 0 else branch.end - 1]) < ZERO_STEP:
                offset.append(_held_at(x, y, branch.first if branch.sign > 0 else branch.end - 1))
    for name, values, reason in (
        ("zero_suppression", zero, "no sweep begins at setpoint zero with the outlet at rest"),
        ("zero_offset", offset, "no sweep reaches setpoint zero"),
    ):
        good = [value for value in values if math.isfinite(value)]
        found.add(name, float(np.mean(good)) if good else math.nan, reason=reason)
    if sweep.lag is None:
        found.add("sweep_lag", math.nan, reason="no sweep stops at its upper end for a while; hysteresis contains it")
    else:
        found.add("sweep_lag", max(0.0, sweep.lag.moved), time=sweep.lag.time)
    if short and min(short) < -SHORT:
        found.note(f"The setpoint is not reached: at full setpoint the outlet stays {-min(short):.3g} % FS below it.")


def _held_at(x: FloatArray, y: FloatArray, place: int) -> float:
    """The outlet at the end of a hold of the setpoint around a sample."""
    away = np.abs(x - x[place]) > ZERO_STEP
    before, after = np.flatnonzero(away[:place]), np.flatnonzero(away[place:])
    begin = int(before[-1]) + 1 if before.size else 0
    end = place + int(after[0]) if after.size else x.size
    middle = max(begin, end - max(1, (end - begin) // 3))
    return float(np.mean(y[middle : max(middle + 1, end - (end - begin) // 8)]))


def _leaves_zero(x: FloatArray, y: FloatArray) -> float:
    """Setpoint at which the outlet leaves the pressure that it has at setpoint zero."""
    if x.size < FEWEST_STAIRS or x[0] > ZERO_STEP:
        return math.nan
    begin = max(3, int(np.argmax(x > x[0] + 0.5 * ZERO_STEP)))
    zero = float(np.median(y[:begin]))
    rise = max(ZERO_STEP, 6.0 * noise_of(y))
    above = y - zero > rise
    first = int(np.argmax(above))
    if not above[first]:
        return math.nan
    beyond = np.flatnonzero(y[first:] - zero > rise + ZERO_SPAN)
    near = slice(first, first + int(beyond[0]) + 1 if beyond.size else x.size)
    if near.stop - near.start < 4 or np.ptp(x[near]) <= ZERO_SPAN / JUMP:
        return float(x[first])
    slope, level = np.polyfit(x[near] - x[first], y[near] - zero, 1)
    if level > 1.5 * rise:  # it leaves zero with a jump to where it goes on
        return float(x[first])
    return max(0.0, float(x[first] - level / slope)) if slope > 0.0 else float(x[first])


def _rate(records: Sequence[Record], scale: Scale) -> float:
    """Usual rate of the sweep [% FS/s]."""
    rates = []
    for record in records:
        x = scale.setpoint_percent(record.setpoint)
        for branch in branches(x, SWING):
            inside = np.flatnonzero((x[branch.samples] >= RANGE[0]) & (x[branch.samples] <= RANGE[1])) + branch.first
            if inside.size > 1:
                rates.append(abs(x[inside[-1]] - x[inside[0]]) / (record.time[inside[-1]] - record.time[inside[0]]))
    return float(np.median(rates)) if rates else math.nan


def _curves(found: Evaluation, sweep: Sweep, up: FloatArray, down: FloatArray) -> None:
    for name, mean, rows in (("up", up, sweep.up), ("down", down, sweep.down)):
        known = np.isfinite(mean)
        found.curves.append(Curve(name, "characteristic", GRID[known], mean[known]))
        for k, row in enumerate(rows):
            known = np.isfinite(row)
            found.curves.append(Curve(f"{name} {k + 1}", "cycles", GRID[known], row[known]))
    found.rows = [
        {"setpoint": float(x), "up": float(u), "down": float(d)}
        for x, u, d in zip(GRID[::5], up[::5], down[::5], strict=True)
        if math.isfinite(u) and math.isfinite(d)
    ]
