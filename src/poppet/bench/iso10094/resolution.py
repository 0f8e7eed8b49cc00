"""The smallest change of the setpoint that moves the outlet, from a small staircase."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.bench.iso10094.evaluation import AT_LEAST, AT_MOST, Curve, Evaluation
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.shapes import rested, stairs
from poppet.series.measured.noise import noise_of

TAIL = 0.3
"""Last part of a stair, in which the outlet rests."""
MOVED = 0.25
"""Part of a stair that the outlet must move by to count as moved."""
CLEAR = 5.0
"""Standard errors of two means that no chance exceeds."""
FEWEST = 5


@dataclass(frozen=True)
class Move:
    """One motion of the outlet: where, and by how much the setpoint had changed since the one before [% FS]."""

    place: int
    change: float
    is_reversal: bool


def evaluate_resolution(records: Sequence[Record], scale: Scale) -> Evaluation:
    """Resolution and reversal threshold."""
    found = Evaluation("resolution")
    for record in records:
        _one(found, record, scale)
    for name, key, what in (
        ("resolution", "resolution", "no stair moves the outlet twice in one direction"),
        (
            "reversal_threshold",
            "reversal_threshold",
            "no staircase turns and moves the outlet on both sides of the turn",
        ),
    ):
        rows = [row for row in found.rows if key in row]
        if not rows:
            found.add(name, math.nan, reason=what)
            continue
        worst = max(rows, key=lambda row: row[key])
        found.add(name, worst[key], bound=worst[f"{key}_bound"], at=worst["setpoint"], stair=worst["stair"])
    return found


def _one(found: Evaluation, record: Record, scale: Scale) -> None:
    x, y = scale.setpoint_percent(record.setpoint), scale.percent(record.outlet)
    held = stairs(x)
    if len(held) < FEWEST:
        found.note(f"{record.name}: the setpoint is no staircase: fewer than {FEWEST} holds.")
        return
    last = [rested(record.time, part, TAIL) for part in held]
    level, answer = (np.array([float(np.mean(series[part])) for part in last]) for series in (x, y))
    stair = float(np.median(np.abs(np.diff(level))))
    least = max(MOVED * stair, CLEAR * noise_of(y) * math.sqrt(2.0 / min(part.stop - part.start for part in last)))
    row: dict[str, Any] = {"record": record.name, "setpoint": float(np.mean(level)), "stair": stair, "threshold": least}
    found.rows.append(row)
    if least > stair:
        found.note(f"{record.name}: noise hides motions below {least:.2g} % FS, more than a stair of {stair:.2g} % FS.")
    moves = _moves(level, answer, least)
    _enter(found, row, "resolution", [m.change for m in moves if not m.is_reversal], stair, least)
    _enter(found, row, "reversal_threshold", [m.change for m in moves if m.is_reversal], stair, least)
    turned = _turns(level)
    if turned and not any(m.is_reversal for m in moves):
        changed = max(float(np.ptp(level[a : b + 1])) for a, b in turned)
        row |= {"reversal_threshold": changed, "reversal_threshold_bound": AT_LEAST}
        found.note(
            f"{record.name}: after its turn the staircase goes back by {changed:.3g} % FS and does not move the outlet."
        )
    found.curves.append(Curve("setpoint", record.name, record.time, x))
    found.curves.append(Curve("outlet", record.name, record.time, y))


def _enter(found: Evaluation, row: dict[str, Any], name: str, changes: list[float], stair: float, least: float) -> None:
    """The largest change that was needed; at one stair it is a bound: finer stairs were not tried."""
    if not changes:
        return
    change = max(changes)
    is_bound = change < 1.5 * stair
    row |= {name: change, f"{name}_bound": AT_MOST if is_bound else ""}
    if is_bound and least <= stair:
        found.note(f"{name}: the outlet follows every stair of {stair:.2g} % FS; it may be finer than that.")


def _moves(level: FloatArray, answer: FloatArray, least: float) -> list[Move]:
    """Motions of the outlet; the setpoint's change counts from the stair of the last motion, or from the turn."""
    found: list[Move] = []
    # The first motion of all has no beginning: how far the setpoint was beyond an earlier one is not known.
    since, direction, is_known, has_turned = 0, 0, False, False
    for k in range(1, level.size):
        way = int(np.sign(level[k] - level[k - 1]))
        if way * direction < 0:
            since, is_known, has_turned = k - 1, True, True
        direction = way or direction
        if direction * (answer[k] - answer[k - 1]) >= least:
            if is_known:
                found.append(Move(k, abs(float(level[k] - level[since])), has_turned))
            since, is_known, has_turned = k, True, False
    return found


def _turns(level: FloatArray) -> list[tuple[int, int]]:
    """First and last stair of every part that goes back."""
    way = np.sign(np.diff(level))
    turns = np.flatnonzero(way[1:] * way[:-1] < 0.0) + 1
    ends = np.append(turns[1:], level.size - 1)[: turns.size]
    return [(int(a), int(b)) for a, b in zip(turns, ends, strict=True)]
