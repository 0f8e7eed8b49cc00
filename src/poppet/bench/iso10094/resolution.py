"""Test of resolution: smallest change of the setpoint that moves the outlet.

The setpoint is a small staircase.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from poppet.bench.iso10094.evaluation import AT_LEAST, AT_MOST, BenchTest, Evaluation, Row, Trial, largest
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.shapes import constant_sections, steady_part
from poppet.bench.iso10094.uncertainty import Uncertainty, estimate_noise
from poppet.timeseries.signals import Steps

# Height of a stair [% FS], number of stairs per section, and setpoint of the first stair [% FS].
STAIR, STAIRS, MIDDLE = 0.05, 60, 50.0
TAIL = 0.3  # last fraction of a stair, in which the outlet is in steady state
MOVED = 0.25  # change of the outlet that counts as a motion, as a fraction of a stair
CLEAR = 5.0  # limit of chance differences between two means, in standard errors
FEWEST = 5


def resolution_trial(scale: Scale, volume: float, stair: float, hold: float, middle: float) -> Trial:
    """Return a trial in which the setpoint is a staircase with small steps.

    The staircase goes up, down, and up again. `stair` is the height of one step, and `middle` the first setpoint [%
    FS]. `hold` is the duration of each step [s], and `volume` the outlet volume [m^3].
    """
    settling = 20.0 * hold
    directions = np.concatenate([np.ones(STAIRS), -np.ones(STAIRS), np.ones(STAIRS)])
    levels = middle + stair * np.concatenate(([0.0], np.cumsum(directions)))
    # An initial step up defines the direction of the last motion before the staircase.
    levels = np.concatenate(([middle - 10.0], levels))
    times = np.concatenate(([0.0], settling / 2.0 + np.arange(levels.size - 1) * hold))
    times[2:] += settling / 2.0
    signal = Steps(times, scale.setpoint(levels))
    name = f"stairs of {stair:g} % FS about {middle:g} % FS"
    return Trial("resolution", name, signal, times[-1] + hold, settling, hold / 50.0, volume)


def _evaluate(evaluation: Evaluation, records: Sequence[Record]) -> None:
    for record in records:
        _evaluate_record(evaluation, record)
    for name, reason in (("resolution", "no_motion"), ("reversal_threshold", "no_reversal")):
        row = largest(evaluation.rows, name)
        if row is None:
            evaluation.note_absence(reason, name)
            continue
        uncertainty, bound = evaluation.uncertainties.get((id(row), name)), row.get(f"{name}_bound", "")
        evaluation.add(name, row[name], uncertainty, bound=bound, at=row["setpoint"], stair=row["stair"])


def _evaluate_record(evaluation: Evaluation, record: Record) -> None:
    x, y = evaluation.scale.percents(record)
    holds = constant_sections(x)
    if len(holds) < FEWEST:
        evaluation.note("resolution.no_staircase", record.name, fewest=FEWEST)
        return
    last = [steady_part(record.time, part, TAIL) for part in holds]
    level, answer = (np.array([float(np.mean(series[part])) for part in last]) for series in (x, y))
    stair = float(np.median(np.abs(np.diff(level))))
    noise = estimate_noise([y[part] for part in last])
    blur = math.sqrt(2.0) * noise.mean(min(part.stop - part.start for part in last))
    least = max(MOVED * stair, CLEAR * blur)
    row: Row = {"record": record.name, "setpoint": float(np.mean(level)), "stair": stair, "threshold": least}
    evaluation.rows.append(row)
    if least > stair:
        evaluation.note("resolution.noise", record.name, least=least, stair=stair)
    changes = _largest_changes(level, answer, least)
    for name, is_reversal in (("resolution", False), ("reversal_threshold", True)):
        if is_reversal not in changes:
            continue
        change = changes[is_reversal]
        # A motion after one stair gives a bound, because smaller stairs were not tested.
        is_bound = change < 1.5 * stair
        row |= {name: change, f"{name}_bound": AT_MOST if is_bound else ""}
        # A motion by one stair must be visible; otherwise the reversal is detected late.
        if least + (3.0 * blur if is_reversal else 0.0) <= stair:
            # The change is between the last stair without motion and the first one with motion. A reversal is visible
            # only after a motion of `least`.
            middle = change - (least if is_reversal else 0.0) - 0.5 * stair
            low, high = Uncertainty(blur, 0.5 * stair).interval(middle)
            evaluation.set_value(row, name, change, Uncertainty(blur, 0.5 * stair, (max(low, 0.0), high)))
        if is_bound and least <= stair:
            evaluation.note("resolution.every_stair", name, stair=stair)
    signs = np.sign(np.diff(level))
    turns = np.flatnonzero(signs[1:] * signs[:-1] < 0.0) + 1
    if turns.size and True not in changes:
        # The largest change between a reversal and the next one.
        ends = [*turns[1:], level.size - 1]
        changed = max(float(np.ptp(level[a : b + 1])) for a, b in zip(turns, ends, strict=True))
        row |= {"reversal_threshold": changed, "reversal_threshold_bound": AT_LEAST}
        evaluation.note("resolution.no_turn", record.name, changed=changed)
    evaluation.add_curve("setpoint", record.name, record.time, x)
    evaluation.add_curve("outlet", record.name, record.time, y)


def _largest_changes(level: FloatArray, answer: FloatArray, least: float) -> dict[bool, float]:
    """Return the largest setpoint changes [% FS] that were necessary to move the outlet.

    `level` is the setpoint and `answer` the outlet on each step of the staircase. A change of the outlet by `least` or
    more is a motion. The value of the key False is the largest change since the previous motion. The value of the key
    True is the largest change since a reversal of the setpoint. The first motion is omitted unless it follows a
    reversal, because its setpoint change is unknown.
    """
    changes: dict[bool, float] = {}
    since, direction, is_known, has_turned = 0, 0, False, False
    for k in range(1, level.size):
        sign = int(np.sign(level[k] - level[k - 1]))
        if sign * direction < 0:
            since, is_known, has_turned = k - 1, True, True
        direction = sign or direction
        if direction * (answer[k] - answer[k - 1]) >= least:
            if is_known:
                changes[has_turned] = max(changes.get(has_turned, 0.0), abs(float(level[k] - level[since])))
            since, is_known, has_turned = k, True, False
    return changes


RESOLUTION = BenchTest(
    "resolution", _evaluate, {"resolution": "% FS", "reversal_threshold": "% FS"},
    trials=lambda pace: [resolution_trial(pace.specimen.scale, pace.volume, STAIR, pace.hold, MIDDLE)],
    whole=("setpoint", "outlet"),
)  # fmt: skip
