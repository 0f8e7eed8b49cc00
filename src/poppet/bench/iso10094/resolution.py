"""The smallest change of the setpoint that moves the outlet, from a small staircase."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from poppet.bench.iso10094.bench_settings import Trial
from poppet.bench.iso10094.evaluation import AT_LEAST, AT_MOST, BenchTest, Curve, Evaluation, Row, largest
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.shapes import rested, stairs
from poppet.bench.iso10094.uncertainty import Uncertainty, noise_about
from poppet.timeseries.signals import Steps

STAIR, STAIRS, MIDDLE = 0.05, 60, 50.0
"""Height of the stairs [% FS], their number from the turn on, and about what they stand [% FS]."""
TAIL = 0.3
"""Last part of a stair, in which the outlet rests."""
MOVED = 0.25
"""Part of a stair that the outlet must move by to count as moved."""
CLEAR = 5.0
"""Standard errors of two means that no chance exceeds."""
FEWEST = 5


def resolution_trial(scale: Scale, volume: float, stair: float, hold: float, middle: float) -> Trial:
    """A small staircase up, then down, then up again."""
    lead = 20.0 * hold
    ways = np.concatenate([np.ones(STAIRS), -np.ones(STAIRS), np.ones(STAIRS)])
    levels = middle + stair * np.concatenate(([0.0], np.cumsum(ways)))
    # A step up ahead: the staircase begins with the last motion in its own direction.
    levels = np.concatenate(([middle - 10.0], levels))
    times = np.concatenate(([0.0], lead / 2.0 + np.arange(levels.size - 1) * hold))
    times[2:] += lead / 2.0
    signal = Steps(times, scale.setpoint(levels))
    name = f"stairs of {stair:g} % FS about {middle:g} % FS"
    return Trial("resolution", name, signal, times[-1] + hold, lead, hold / 50.0, volume)


def _evaluate(found: Evaluation, records: Sequence[Record]) -> None:
    for record in records:
        _one(found, record)
    for name, reason in (("resolution", "no_motion"), ("reversal_threshold", "no_reversal")):
        row = largest(found.rows, name)
        if row is None:
            found.absent(reason, name)
            continue
        doubt, bound = found.doubts.get((id(row), name)), row.get(f"{name}_bound", "")
        found.add(name, row[name], doubt, bound=bound, at=row["setpoint"], stair=row["stair"])


def _one(found: Evaluation, record: Record) -> None:
    x, y = found.scale.percents(record)
    held = stairs(x)
    if len(held) < FEWEST:
        found.note("resolution.no_staircase", record.name, fewest=FEWEST)
        return
    last = [rested(record.time, part, TAIL) for part in held]
    level, answer = (np.array([float(np.mean(series[part])) for part in last]) for series in (x, y))
    stair = float(np.median(np.abs(np.diff(level))))
    noise = noise_about([y[part] for part in last])
    blur = math.sqrt(2.0) * noise.mean(min(part.stop - part.start for part in last))
    least = max(MOVED * stair, CLEAR * blur)
    row: Row = {"record": record.name, "setpoint": float(np.mean(level)), "stair": stair, "threshold": least}
    found.rows.append(row)
    if least > stair:
        found.note("resolution.noise", record.name, least=least, stair=stair)
    moves = _moves(level, answer, least)
    for name, is_reversal in (("resolution", False), ("reversal_threshold", True)):
        change = max((move.change for move in moves if move.is_reversal is is_reversal), default=math.nan)
        if math.isnan(change):
            continue
        # What one stair moves is a bound: finer ones were not tried.
        is_bound = change < 1.5 * stair
        row |= {name: change, f"{name}_bound": AT_MOST if is_bound else ""}
        # A motion by one stair must be seen, or the turn is seen late.
        if least + (3.0 * blur if is_reversal else 0.0) <= stair:
            found.know(row, name, change, _within(change, stair, least if is_reversal else 0.0, blur))
        if is_bound and least <= stair:
            found.note("resolution.every_stair", name, stair=stair)
    turned = _turns(level)
    if turned and not any(move.is_reversal for move in moves):
        changed = max(float(np.ptp(level[a : b + 1])) for a, b in turned)
        row |= {"reversal_threshold": changed, "reversal_threshold_bound": AT_LEAST}
        found.note("resolution.no_turn", record.name, changed=changed)
    found.curves += [Curve("setpoint", record.name, record.time, x), Curve("outlet", record.name, record.time, y)]


def _within(change: float, stair: float, unseen: float, blur: float) -> Uncertainty:
    """The stair before did not move the outlet: anywhere between both lies what does.

    A turn shows itself when what follows has moved by as much as is seen.
    """
    even = Uncertainty(blur, 0.5 * stair)
    low, high = even.interval(change - unseen - 0.5 * stair)
    return Uncertainty(blur, 0.5 * stair, (max(low, 0.0), high))


class Move(NamedTuple):
    """One motion of the outlet: by how much the setpoint had changed since the one before, or since its turn [% FS]."""

    change: float
    is_reversal: bool


def _moves(level: FloatArray, answer: FloatArray, least: float) -> list[Move]:
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
                found.append(Move(abs(float(level[k] - level[since])), has_turned))
            since, is_known, has_turned = k, True, False
    return found


def _turns(level: FloatArray) -> list[tuple[int, int]]:
    """First and last stair of every part that goes back."""
    way = np.sign(np.diff(level))
    turns = np.flatnonzero(way[1:] * way[:-1] < 0.0) + 1
    ends = np.append(turns[1:], level.size - 1)[: turns.size]
    return [(int(a), int(b)) for a, b in zip(turns, ends, strict=True)]


RESOLUTION = BenchTest(
    "resolution",
    _evaluate,
    {"resolution": "% FS", "reversal_threshold": "% FS"},
    trials=lambda pace: [resolution_trial(pace.specimen.scale, pace.volume, STAIR, pace.hold, MIDDLE)],
    whole=("setpoint", "outlet"),
)
