"""Outlet pressure over a slow sweep of the setpoint: linearity, hysteresis, repeatability, zero."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from poppet.bench.iso10094.evaluation import BenchTest, Curve, Evaluation
from poppet.bench.iso10094.plan import ROWS, Trial
from poppet.bench.iso10094.scale import FloatArray, Mask, Record, Scale
from poppet.bench.iso10094.shapes import Branch, at_places, branches, rested, scatter_of, stairs
from poppet.bench.iso10094.sweep import caught_up, lags_of
from poppet.series.measured.noise import noise_of
from poppet.series.signals import Points

CYCLES = 3
RANGE = (10.0, 90.0)
"""Part of the setpoint's range in which the characteristic is judged [% FS]; dead zone and ends are outside."""
SWING = 5.0
"""Smallest turn of the setpoint that ends a branch [% FS]."""
GRID = np.linspace(0.0, 100.0, 101)
INSIDE = (RANGE[0] <= GRID) & (RANGE[1] >= GRID)
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
STOPPING = 70.0
"""Setpoint above which a sweep shows its lag: no sample there may be clipped [% FS]."""


def characteristic_trial(scale: Scale, volume: float, sweep: float, hold: float) -> Trial:
    """Slow sweeps from end to end of the setpoint's range, up and down, with a hold at each end."""
    hold = max(hold, 0.05 * sweep)
    times, values = [0.0, 2.0 * hold], [0.0, 0.0]
    for _ in range(CYCLES):
        for end in (100.0, 0.0):
            times += [times[-1] + sweep, times[-1] + sweep + hold]
            values += [end, end]
    signal = Points(times, scale.setpoint(np.array(values)))
    return Trial("characteristic", "sweep of the setpoint", signal, times[-1], hold, sweep / ROWS, volume)


@dataclass(frozen=True, eq=False)
class Swept:
    """A record in % FS, the setpoint `late` by its lag, and its branches."""

    time: FloatArray
    x: FloatArray
    late: FloatArray
    y: FloatArray
    parts: list[Branch]
    cut: Mask  # samples of setpoint or outlet that are clipped

    @property
    def is_judged(self) -> bool:
        """False where clipped samples stand in the judged range."""
        return not bool(np.any(self.cut & (self.x >= RANGE[0]) & (self.x <= RANGE[1])))


@dataclass(frozen=True, eq=False)
class Branches:
    """The outlet on `GRID`, a row per branch, NaN where it was not; one standard deviation by noise [% FS]."""

    up: FloatArray
    down: FloatArray
    error: float


def _evaluate(found: Evaluation, records: Sequence[Record]) -> None:
    every = [_swept(found.scale, record) for record in records]
    # One lag for all: the same valve at the same rate, and not every sweep stops for long enough to show it.
    stopping = [each for each in every if not np.any(each.cut & (each.x > STOPPING))]
    lags = [lag for each in stopping for lag in lags_of(each.time, each.x, each.y, each.parts)]
    every = [replace(each, late=caught_up(each.time, each.x, lags)) for each in every]
    swept = [each for each in every if each.is_judged]
    sweep = _on_grid(swept)
    up, down = (rows.mean(axis=0) if rows.size else np.full(GRID.size, np.nan) for rows in (sweep.up, sweep.down))
    found.conditions |= {
        "branches_up": len(sweep.up), "branches_down": len(sweep.down), "range": list(RANGE),
        "sweep_rate": _rate(swept), "noise": sweep.error,
    }  # fmt: skip
    _straightness(found, sweep, up, down)
    _repeatability(found, sweep)
    _ends(found, every)
    if lags:
        moved, time = (float(np.mean(values)) for values in ([lag.moved for lag in lags], [lag.time for lag in lags]))
        found.add("sweep_lag", max(0.0, moved), time=time)
    else:
        found.absent("no_stop" if len(stopping) == len(every) else "clipped_stop", "sweep_lag")
    _curves(found, sweep, up, down)
    if every and not swept:
        found.lack("linearity", "hysteresis", "repeatability", "accuracy")


def _swept(scale: Scale, record: Record) -> Swept:
    x, y = scale.percents(record)
    cut = np.zeros(x.size, dtype=bool)
    for name in ("setpoint", "outlet"):
        cut |= record.clipped.get(name, False)
    return Swept(record.time, x, x, y, branches(x, SWING), cut)


def _on_grid(swept: Sequence[Swept]) -> Branches:
    rows: dict[int, list[FloatArray]] = {1: [], -1: []}
    errors = [0.0]
    for each in swept:
        noise = noise_of(each.y)
        for branch in each.parts:
            value, count = _branch(each, branch)
            if np.mean(np.isfinite(value[INSIDE])) >= COVERED:
                rows[branch.sign].append(value)
                errors.append(noise / math.sqrt(max(1.0, float(np.median(count[INSIDE])))))
    up, down = (np.array(rows[sign]).reshape(-1, GRID.size) for sign in (1, -1))
    return Branches(up, down, max(errors))


def _branch(swept: Swept, branch: Branch) -> tuple[FloatArray, FloatArray]:
    """The outlet on the grid, and how many samples made each value; the ends of stairs are joined."""
    x, y = swept.late[branch.samples], swept.y[branch.samples]
    held = stairs(x)
    if len(held) >= FEWEST_STAIRS and sum(s.stop - s.start for s in held) > 0.8 * (branch.end - branch.first):
        last = [rested(swept.time[branch.samples], s, 0.2) for s in held]
        places, levels = (np.array([float(np.mean(series[s])) for s in last]) for series in (x, y))
        order = np.argsort(places)
        value = np.interp(GRID, places[order], levels[order], np.nan, np.nan)
        return value, np.full(GRID.size, float(np.median([s.stop - s.start for s in last])))
    return at_places(x, y, GRID, HALF)


def _straightness(found: Evaluation, sweep: Branches, up: FloatArray, down: FloatArray) -> None:
    both = INSIDE & np.isfinite(up) & np.isfinite(down)
    if np.count_nonzero(both) < FEWEST_STAIRS:
        found.absent("one_way", "linearity", "hysteresis")
    else:
        x, mean, gap = GRID[both], 0.5 * (up + down)[both], (down - up)[both]
        # Ends count half, as in an integral over the range: the line does not depend on how fine the grid is.
        weight = np.ones(x.size)
        weight[[0, -1]] = math.sqrt(0.5)
        slope, offset = np.polyfit(x, mean, 1, w=weight)
        away = mean - slope * x - offset
        k, j = int(np.argmax(np.abs(away))), int(np.argmax(np.abs(gap)))
        found.conditions |= {"slope": float(slope), "offset": float(offset)}
        # The largest of so many places: noise alone makes some four of its standard deviations, of a difference six.
        error = sweep.error / math.sqrt(max(1, min(len(sweep.up), len(sweep.down))))
        found.add_seen("linearity", abs(away[k]), 4.0 * error, at=float(x[k]))
        found.add_seen("hysteresis", abs(gap[j]), 6.0 * error, at=float(x[j]))
        if gap[j] < 0.0 and abs(gap[j]) > 6.0 * error:
            found.note("characteristic.leads", at=float(x[j]))
    away = np.abs(np.concatenate([sweep.up, sweep.down])[:, INSIDE] - GRID[INSIDE])
    if np.isfinite(away).any():
        place = int(np.nanargmax(away))
        found.add("accuracy", float(away.flat[place]), at=float(GRID[INSIDE][place % away.shape[1]]))
    else:
        found.absent("no_sweep", "accuracy")


def _repeatability(found: Evaluation, sweep: Branches) -> None:
    repeated = [rows for rows in (sweep.up, sweep.down) if len(rows) > 1]
    values = np.concatenate([np.ptp(rows[:, INSIDE], axis=0) for rows in repeated] or [np.zeros(0)])
    values = values[np.isfinite(values)]
    if values.size:
        cycles = min(len(rows) for rows in repeated)
        found.add_seen("repeatability", float(np.max(values)), 8.0 * sweep.error, cycles=cycles)
    else:
        found.absent("one_cycle", "repeatability")


def _ends(found: Evaluation, swept: Sequence[Swept]) -> None:
    """What happens at setpoint zero, and at the upper end where the sweep stops."""
    zero, offset, short = [], [], []
    is_cut = False
    for each in swept:
        x, y = each.x, each.y
        if np.any(each.cut & (x < RANGE[0])):
            is_cut = True
            continue
        for branch in each.parts:
            low, high = (branch.first, branch.end - 1)[:: branch.sign]
            if branch.sign > 0:
                zero.append(_leaves_zero(each.late[branch.samples], y[branch.samples]))
                if x[high] > 95.0 and not np.any(each.cut):
                    short.append(_held_at(x, y, high) - float(x[high]))
            if abs(_level(x, low)) < ZERO_STEP:
                offset.append(_held_at(x, y, low))
    for name, values, reason in (("zero_suppression", zero, "no_start"), ("zero_offset", offset, "no_zero")):
        good = [value for value in values if math.isfinite(value)]
        if good:
            found.add(name, float(np.mean(good)))
        else:
            found.absent("clipped" if is_cut else reason, name)
    if short and min(short) < -SHORT:
        found.note("characteristic.short", short=-min(short))


def _level(x: FloatArray, place: int) -> float:
    """The setpoint about a turn; its noise makes an extreme of any sample of a hold."""
    return float(np.median(x[max(0, place - 4) : place + 5]))


def _held_at(x: FloatArray, y: FloatArray, place: int) -> float:
    """The outlet at the end of a hold of the setpoint around a sample."""
    away = np.abs(x - _level(x, place)) > max(ZERO_STEP, 5.0 * scatter_of(x))
    before, after = np.flatnonzero(away[:place]), np.flatnonzero(away[place:])
    begin = int(before[-1]) + 1 if before.size else 0
    end = place + int(after[0]) if after.size else x.size
    # Its last third but for the last eighth, in which a setpoint with noise may have begun to leave.
    middle = max(begin, end - max(1, (end - begin) // 3))
    return float(np.mean(y[middle : max(middle + 1, end - (end - begin) // 8)]))


def _leaves_zero(x: FloatArray, y: FloatArray) -> float:
    """Setpoint at which the outlet leaves the pressure that it has at setpoint zero."""
    if x.size < FEWEST_STAIRS or x[0] > ZERO_STEP:
        return math.nan
    begin = max(3, int(np.argmax(x > max(x[0] + 0.5 * ZERO_STEP, 5.0 * scatter_of(x)))))
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


def _rate(swept: Sequence[Swept]) -> float:
    """Usual rate of the sweep [% FS/s]."""
    rates = []
    for each in swept:
        for branch in each.parts:
            x, time = each.x[branch.samples], each.time[branch.samples]
            inside = np.flatnonzero((x >= RANGE[0]) & (x <= RANGE[1]))
            if inside.size > 1:
                first, last = inside[0], inside[-1]
                rates.append(abs(x[last] - x[first]) / (time[last] - time[first]))
    return float(np.median(rates)) if rates else math.nan


def _curves(found: Evaluation, sweep: Branches, up: FloatArray, down: FloatArray) -> None:
    for name, mean, rows in (("up", up, sweep.up), ("down", down, sweep.down)):
        named = [(name, "characteristic", mean), *((f"{name} {k + 1}", "cycles", row) for k, row in enumerate(rows))]
        for label, case, values in named:
            known = np.isfinite(values)
            found.curves.append(Curve(label, case, GRID[known], values[known]))
    found.rows = [
        {"setpoint": float(x), "up": float(u), "down": float(d)}
        for x, u, d in zip(GRID[::5], up[::5], down[::5], strict=True)
        if math.isfinite(u) and math.isfinite(d)
    ]


_FIGURES = "linearity", "hysteresis", "repeatability", "accuracy", "zero_suppression", "zero_offset", "sweep_lag"
CHARACTERISTIC = BenchTest(
    "characteristic",
    _evaluate,
    dict.fromkeys(_FIGURES, "% FS"),
    {"low": RANGE[0], "high": RANGE[1]},
    trials=lambda pace: [characteristic_trial(pace.specimen.scale, pace.volume, pace.sweep(), pace.hold)],
)
