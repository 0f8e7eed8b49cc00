"""Outlet pressure over a slow sweep of the setpoint: linearity, hysteresis, repeatability, zero."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from poppet.bench.iso10094.bench_settings import ROWS, Trial
from poppet.bench.iso10094.evaluation import BenchTest, Curve, Evaluation
from poppet.bench.iso10094.scale import FloatArray, Mask, Record, Scale
from poppet.bench.iso10094.shapes import Branch, at_places, branches, rested, scatter_of, stairs
from poppet.bench.iso10094.sweep import CHOSEN, caught_up, lags_of, moved_by
from poppet.bench.iso10094.uncertainty import (
    NORMAL,
    Uncertainty,
    greatest,
    mean_of,
    noise_about,
    roughness,
    smooth,
    unbiased,
)
from poppet.timeseries.signals import Points

CYCLES = 3
RANGE = (10.0, 90.0)
"""Part of the setpoint's range in which the characteristic is judged [% FS]; dead zone and ends are outside."""
SWING = 5.0
"""Smallest turn of the setpoint that ends a branch [% FS]."""
GRID = np.linspace(0.0, 100.0, 101)
INSIDE = (RANGE[0] <= GRID) & (RANGE[1] >= GRID)
HALF = 0.5
"""Samples this near to a place of the grid count there: each to one place, so that these share no noise [% FS]."""
COVERED = 0.75
"""Part of the judged range that a branch must cover."""
FEWEST_STAIRS = 8
ZERO_STEP, ZERO_SPAN, JUMP = 0.5, 3.5, 5.0
"""Rise of the outlet that leaves zero, and the range above it from which it is continued back [% FS]; a rise this much
steeper than nominal is a jump."""
STARTED, UNDER_WAY = 3.0, 0.04
"""Lags of the sweep, as parts of the range, behind which its start is over, and what is left of it then."""
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
class SetpointSweep:
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
    """The outlet on `GRID`, a row per branch, NaN where it was not."""

    up: FloatArray
    down: FloatArray
    error: float  # one standard deviation of a single value by noise [% FS]
    share: int  # neighbouring values that share their noise: places between two stairs


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
    moved, doubt = moved_by(lags) if lags else (0.0, Uncertainty(0.0))
    _straightness(found, sweep, up, down, doubt.standard)
    _accuracy(found, sweep, doubt.standard)
    _repeatability(found, sweep)
    _ends(found, every, moved, doubt.standard)
    if lags:
        found.add("sweep_lag", max(0.0, moved), doubt, time=max(0.0, float(np.mean([lag.time for lag in lags]))))
    else:
        found.absent("no_stop" if len(stopping) == len(every) else "clipped_stop", "sweep_lag")
    _curves(found, sweep, up, down)
    if every and not swept:
        found.lack("linearity", "hysteresis", "repeatability", "accuracy")


def _swept(scale: Scale, record: Record) -> SetpointSweep:
    x, y = scale.percents(record)
    cut = np.zeros(x.size, dtype=bool)
    for name in ("setpoint", "outlet"):
        cut |= record.clipped.get(name, False)
    return SetpointSweep(record.time, x, x, y, branches(x, SWING), cut)


def _on_grid(swept: Sequence[SetpointSweep]) -> Branches:
    rows: dict[int, list[FloatArray]] = {1: [], -1: []}
    shares = [1]
    for each in swept:
        for branch in each.parts:
            value, share = _branch(each, branch)
            if np.mean(np.isfinite(value[INSIDE])) >= COVERED:
                rows[branch.sign].append(value)
                shares.append(share)
    up, down = (np.array(rows[sign]).reshape(-1, GRID.size) for sign in (1, -1))
    share = max(shares)
    return Branches(up, down, roughness(np.concatenate([up, down])[:, INSIDE], share), share)


def _branch(swept: SetpointSweep, branch: Branch) -> tuple[FloatArray, int]:
    """The outlet on the grid, and the places between two stairs, whose ends are joined; one where there are none."""
    x, y = swept.late[branch.samples], swept.y[branch.samples]
    held = stairs(x)
    if len(held) >= FEWEST_STAIRS and sum(s.stop - s.start for s in held) > 0.8 * (branch.end - branch.first):
        last = [rested(swept.time[branch.samples], s, 0.2) for s in held]
        places, levels = (np.array([float(np.mean(series[s])) for s in last]) for series in (x, y))
        order = np.argsort(places)
        value = np.interp(GRID, places[order], levels[order], np.nan, np.nan)
        return value, max(1, round(float(np.median(np.diff(places[order])))))
    return at_places(x, y, GRID, HALF)[0], 1


def _straightness(found: Evaluation, sweep: Branches, up: FloatArray, down: FloatArray, lag: float) -> None:
    """Linearity and hysteresis; `lag` is the standard uncertainty of the lag that was taken out [% FS]."""
    both = INSIDE & np.isfinite(up) & np.isfinite(down)
    if np.count_nonzero(both) < FEWEST_STAIRS:
        found.absent("one_way", "linearity", "hysteresis")
        return
    x, mean, gap = GRID[both], 0.5 * (up + down)[both], (down - up)[both]
    # Ends count half, as in an integral over the range: the line does not depend on how fine the grid is.
    weight = np.ones(x.size)
    weight[[0, -1]] = math.sqrt(0.5)
    slope, offset = np.polyfit(x, mean, 1, w=weight)
    found.conditions |= {"slope": float(slope), "offset": float(offset)}
    matrix = np.vander(x, 2)
    away = np.eye(x.size) - matrix @ np.linalg.pinv(matrix * weight[:, None]) * weight
    error = sweep.error * math.sqrt(1.0 / len(sweep.up) + 1.0 / len(sweep.down))
    mean_curve, gap_curve = (smooth(x, y, e, sweep.share) for y, e in ((mean, 0.5 * error), (gap, error)))
    k, j = (int(np.argmax(np.abs(y))) for y in (away @ mean_curve.values, gap_curve.values))
    value, doubt = unbiased([mean_curve], lambda draws: np.max(np.abs(draws[0] @ away.T), axis=1))
    found.add_judged("linearity", value, doubt, at=float(x[k]))
    value, doubt = unbiased([gap_curve], lambda draws: np.max(np.abs(draws[0]), axis=1))
    # Up and down stand behind the setpoint by the same lag, on either side.
    found.add_judged("hysteresis", value, doubt.wider(2.0 * lag), at=float(x[j]))
    if gap_curve.values[j] < -NORMAL * math.hypot(doubt.standard, 2.0 * lag):
        found.note("characteristic.leads", at=float(x[j]))


def _accuracy(found: Evaluation, sweep: Branches, lag: float) -> None:
    rows = [(row[known], GRID[known]) for row, known in _known(np.concatenate([sweep.up, sweep.down]))]
    if not rows:
        found.absent("no_sweep", "accuracy")
        return
    curves = [smooth(x, row - x, sweep.error, sweep.share) for row, x in rows]
    value, doubt = unbiased(curves, lambda draws: np.max([np.max(np.abs(d), axis=1) for d in draws], axis=0))
    worst = max(range(len(rows)), key=lambda k: float(np.max(np.abs(curves[k].values))))
    place = int(np.argmax(np.abs(curves[worst].values)))
    found.add_judged("accuracy", value, doubt.wider(lag), at=float(rows[worst][1][place]))


def _known(rows: FloatArray) -> list[tuple[FloatArray, Mask]]:
    """Rows with where they are known in the judged range."""
    return [(row, INSIDE & np.isfinite(row)) for row in rows]


def _repeatability(found: Evaluation, sweep: Branches) -> None:
    ways = []
    for rows in (sweep.up, sweep.down):
        known = INSIDE & np.isfinite(rows).all(axis=0)
        if len(rows) > 1 and np.count_nonzero(known) > FEWEST_STAIRS:
            apart = rows[:, known] - rows[:, known].mean(axis=0)
            curves = [smooth(GRID[known], row, sweep.error, sweep.share) for row in apart]
            ways.append(unbiased(curves, lambda draws: np.max(np.ptp(draws, axis=0), axis=1)))
    if not ways:
        found.absent("one_cycle", "repeatability")
        return
    value, doubt, _ = greatest(*zip(*ways, strict=True))
    cycles = min(len(rows) for rows in (sweep.up, sweep.down) if len(rows) > 1)
    found.add_judged("repeatability", value, doubt, cycles=cycles)


def _ends(found: Evaluation, swept: Sequence[SetpointSweep], lag: float, error: float) -> None:
    """What happens at setpoint zero, and at the upper end where the sweep stops."""
    zero, short = [], []
    holds: dict[int, FloatArray] = {}
    is_cut = False
    for each in swept:
        x, y = each.x, each.y
        if np.any(each.cut & (x < RANGE[0])):
            is_cut = True
            continue
        for branch in each.parts:
            low, high = (branch.first, branch.end - 1)[:: branch.sign]
            if branch.sign > 0:
                zero.append(_leaves_zero(each.late[branch.samples], y[branch.samples], lag))
                if x[high] > 95.0 and not np.any(each.cut):
                    short.append(float(np.mean(y[_held_at(x, high)])) - float(x[high]))
            if abs(_level(x, low)) < ZERO_STEP:
                holds[_held_at(x, low).start] = y[_held_at(x, low)]
    # A sweep that ends at zero without a hold says nothing of it.
    longest = max((part.size for part in holds.values()), default=0)
    holds = {begin: part for begin, part in holds.items() if part.size > 0.3 * longest}
    noise = noise_about(list(holds.values()))
    offset = [(float(np.mean(part)), Uncertainty(noise.mean(part.size))) for part in holds.values()]
    for name, values, reason in (("zero_suppression", zero, "no_start"), ("zero_offset", offset, "no_zero")):
        good = [value for value in values if math.isfinite(value[0])]
        if good:
            value, doubt = mean_of([each for each, _ in good], [each for _, each in good])
            found.add(name, value, doubt.wider(error) if name == "zero_suppression" else doubt)
        else:
            found.absent("clipped" if is_cut else reason, name)
    if short and min(short) < -SHORT:
        found.note("characteristic.short", short=-min(short))


def _level(x: FloatArray, place: int) -> float:
    """The setpoint about a turn; its noise makes an extreme of any sample of a hold."""
    return float(np.median(x[max(0, place - 4) : place + 5]))


def _held_at(x: FloatArray, place: int) -> slice:
    """The end of a hold of the setpoint around a sample."""
    away = np.abs(x - _level(x, place)) > max(ZERO_STEP, 5.0 * scatter_of(x))
    before, after = np.flatnonzero(away[:place]), np.flatnonzero(away[place:])
    begin = int(before[-1]) + 1 if before.size else 0
    end = place + int(after[0]) if after.size else x.size
    # Its last third but for the last eighth, in which a setpoint with noise may have begun to leave.
    middle = max(begin, end - max(1, (end - begin) // 3))
    return slice(middle, max(middle + 1, end - (end - begin) // 8))


NOWHERE = (math.nan, Uncertainty(math.nan))


def _leaves_zero(x: FloatArray, y: FloatArray, lag: float) -> tuple[float, Uncertainty]:
    """Setpoint at which the outlet leaves the pressure that it has at setpoint zero.

    It is some lags further on before it moves as fast as the setpoint.
    """
    scatter = 5.0 * scatter_of(x)
    if x.size < FEWEST_STAIRS or x[0] > max(ZERO_STEP, scatter):
        return NOWHERE
    begin = max(3, int(np.argmax(x > max(x[0] + 0.5 * ZERO_STEP, scatter))))
    zero = float(np.median(y[:begin])) if begin < 8 else float(np.mean(y[:begin]))
    noise = noise_about([y[(x > RANGE[0]) & (x < 2.5 * RANGE[0])]], 3)
    # Means of as many samples as the setpoint takes for a quarter of a per cent.
    size = max(1, int(np.count_nonzero(x < 2.0 * RANGE[0]) / (8.0 * RANGE[0]))) if noise.sigma > 1e-6 else 1
    blocks = [np.convolve(series, np.full(size, 1.0 / size), "valid")[::size] for series in (x, y - zero)]
    rise = max(ZERO_STEP, 5.0 * noise.mean(size))
    above = np.flatnonzero(blocks[1] > rise)
    if not above.size:
        return NOWHERE
    left = float(blocks[0][above[0]])
    start = left + STARTED * max(lag, 0.0)
    near = (x > start) & (x <= start + ZERO_SPAN)
    if np.count_nonzero(near) < 4 or np.ptp(x[near]) <= ZERO_SPAN / JUMP:
        return left, Uncertainty(math.nan)
    matrix = np.vander(x[near] - left, 2)
    solved = np.linalg.pinv(matrix)
    slope, level = (solved @ (y[near] - zero)).tolist()
    even = 0.5 * float(np.ptp(x[: size + 1]))
    if level > 2.0 * rise + ZERO_STEP or slope <= 0.0:  # it leaves zero with a jump to where it goes on
        return left, Uncertainty(0.0, max(even, 0.5 * float(np.median(np.abs(np.diff(x))))))
    back = level / slope
    # A characteristic that bends: where the rise begins it is as much steeper or flatter as further up.
    further = (x > left + 2.0 * RANGE[0]) & (x <= left + 3.0 * RANGE[0])
    if np.count_nonzero(further) > np.count_nonzero(near):
        bend = (float(np.polyfit(x[further], y[further], 1)[0]) - slope) / float(np.mean(x[further]) - np.mean(x[near]))
        ahead, width = float(np.mean(x[near])) - left + back, float(np.ptp(x[near]))
        back += 0.5 * bend * (ahead**2 - width**2 / 12.0) / slope
    # The choice of the samples by a noisy start adds to it.
    error = CHOSEN * math.hypot(noise.of(solved[1] - back * solved[0]), noise.mean(begin))
    return max(0.0, left - back), Uncertainty(math.hypot(error / slope, UNDER_WAY * max(lag, 0.0)))


def _rate(swept: Sequence[SetpointSweep]) -> float:
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
