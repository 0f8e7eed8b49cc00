"""What the supply does to the outlet, and what the valve takes from it at rest."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from poppet.bench.iso10094.evaluation import AT_MOST, Curve, Evaluation, largest
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.shapes import at_places, branches
from poppet.bench.iso10094.sweep import caught_up, lag_of
from poppet.series.measured.noise import noise_of

MARGIN = 10.0
"""Supply above the outlet below which the outlet is not judged [% FS]."""
PLACES = 81
TURN = 0.3
"""Part of the supply's range by which it must turn to end a branch."""
UNSEEN = 1e-7
"""Change of a leakage that no flow meter sees [kg/s]."""
HOLD = 0.5
"""Last part of a hold over which a leakage is averaged."""
DRIFT = 0.05
"""Change of a leakage between the halves of that part at which it is not at rest."""


def evaluate_supply(records: Sequence[Record], scale: Scale) -> Evaluation:
    """Figures of the pressure regulation."""
    found = Evaluation("supply")
    for record in records:
        if record.supply.size:
            _one(found, record, scale)
        else:
            found.note(f"{record.name}: the supply pressure was not recorded.")
    steepest = max(
        (row for row in found.rows if "sensitivity" in row), key=lambda r: abs(r["sensitivity"]), default=None
    )
    if steepest is None:
        reason = "no record sweeps the supply pressure well above the outlet"
        found.add("supply_sensitivity", math.nan, reason=reason)
    else:
        value, least = steepest["sensitivity"], steepest["known_to"]
        is_lost = abs(value) < least
        if is_lost:
            found.note(f"supply_sensitivity is below what the noise of the recording lets see, {least:.2g}.")
        conditions = {key: steepest[key] for key in ("setpoint", "lowest_supply", "highest_supply")}
        found.add("supply_sensitivity", least if is_lost else value, bound=AT_MOST if is_lost else "", **conditions)
    widest = largest(found.rows, "hysteresis")
    reason = "no sweep of the supply goes there and back"
    found.add("supply_hysteresis", widest["hysteresis"] if widest else math.nan, reason=reason)
    return found


def _one(found: Evaluation, record: Record, scale: Scale) -> None:
    supply, y = record.supply, scale.percent(record.outlet)
    setpoint = float(np.median(scale.setpoint_percent(record.setpoint)))
    usual = float(np.median(y))
    judged = scale.percent(supply) > usual + MARGIN
    row: dict[str, Any] = {"record": record.name, "setpoint": setpoint}
    found.rows.append(row)
    case = f"{setpoint:.0f} % FS"
    extent = float(np.ptp(supply[judged])) if np.count_nonzero(judged) > 10 else 0.0
    if extent < 0.02 * scale.span:
        found.note(f"{record.name}: the supply pressure changes by {extent:.3g} Pa only.")
        return
    low, high = float(np.min(supply[judged])), float(np.max(supply[judged]))
    row |= {"lowest_supply": low, "highest_supply": high}
    grid = np.linspace(low, high, PLACES)
    ways: dict[int, list[FloatArray]] = {1: [], -1: []}
    parts = branches(supply, TURN * extent)
    lags = [lag_of(record.time, supply, y, a, b) for a, b in pairwise([*parts, None]) if a is not None and a.sign > 0]
    late = caught_up(record.time, supply, float(np.mean([lag.time for lag in lags if lag] or [math.nan])))
    for branch in parts:
        value, _ = at_places(late[branch.samples], y[branch.samples], grid, extent / PLACES)
        ways[branch.sign].append(value)
    means = {sign: np.mean(values, axis=0) for sign, values in ways.items() if values}
    for sign, mean in means.items():
        known = np.isfinite(mean)
        found.curves.append(Curve("rising" if sign > 0 else "falling", case, grid[known], mean[known]))
    mean = np.mean(list(means.values()), axis=0)
    known = np.isfinite(mean)
    if np.count_nonzero(known) < PLACES // 2:
        found.note(f"{record.name}: the sweep of the supply is not complete.")
        return
    slope = float(np.polyfit(grid[known], mean[known], 1)[0]) * scale.span / 100.0
    noise = noise_of(y) * scale.span / 100.0
    # Standard error of a slope over an even range: sigma sqrt(12 / n) / range, three of them.
    row |= {"sensitivity": slope, "known_to": 3.0 * noise * math.sqrt(12.0 / np.count_nonzero(judged)) / extent}
    if len(means) == 2:
        row["hysteresis"] = float(np.nanmax(np.abs(means[1] - means[-1])[PLACES // 10 : -PLACES // 10]))


def evaluate_leakage(records: Sequence[Record], scale: Scale) -> Evaluation:
    """Flow from the supply at rest."""
    found = Evaluation("leakage")
    for record in records:
        if not record.consumption.size:
            found.note(f"{record.name}: the flow from the supply was not recorded.")
            continue
        held = record.time >= record.time[-1] - HOLD * (record.time[-1] - record.time[0])
        clock, flow = record.time[held], record.consumption[held]
        mean = float(np.trapezoid(flow, clock) / (clock[-1] - clock[0]))
        half = flow.size // 2
        drift = abs(float(np.mean(flow[half:]) - np.mean(flow[:half])))
        error = 4.0 * noise_of(flow) / math.sqrt(max(1, half))
        row = {
            "record": record.name,
            "setpoint": float(np.median(scale.setpoint_percent(record.setpoint[held]))),
            "outlet": float(np.mean(scale.percent(record.outlet[held]))),
            "flow": mean,
            "known_to": max(error, drift),
        }
        found.rows.append(row)
        if drift > max(DRIFT * abs(mean), error) and drift > UNSEEN:
            found.note(f"{record.name}: the flow from the supply still changes at the end of the hold.")
    worst = largest(found.rows, "flow")
    if worst is None:
        found.add("leakage", math.nan, reason="the flow from the supply was not recorded")
    else:
        is_lost = worst["known_to"] > 0.0 and abs(worst["flow"]) < worst["known_to"]
        value = worst["known_to"] if is_lost else worst["flow"]
        found.add("leakage", value, bound=AT_MOST if is_lost else "", setpoint=worst["setpoint"])
    return found
