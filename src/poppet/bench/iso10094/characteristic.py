"""Test of outlet pressure versus setpoint by slow sweeps of the setpoint.

The test gives linearity, hysteresis, repeatability, accuracy and the values at setpoint zero.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from poppet.bench.iso10094.evaluation import ROWS, BenchTest, Evaluation, Trial
from poppet.bench.iso10094.scale import FloatArray, Mask, Record, Scale
from poppet.bench.iso10094.shapes import (
    CHOSEN,
    Branch,
    branches,
    constant_sections,
    delay_by_lags,
    lags_of,
    mean_lag_change,
    setpoint_noise,
    steady_part,
    unmasked_section,
    values_at_points,
)
from poppet.bench.iso10094.uncertainty import (
    NORMAL,
    Uncertainty,
    correct_noise_bias,
    curve_noise,
    estimate_noise,
    greatest,
    mean_of,
    smooth,
)
from poppet.timeseries.signals import Points

CYCLES = 3
# Range of the setpoint in which the characteristic is evaluated, without dead zone and ends [% FS].
RANGE = (10.0, 90.0)
SWING = 5.0  # smallest reversal of the setpoint that ends a branch [% FS]
GRID = np.linspace(0.0, 100.0, 101)
INSIDE = (RANGE[0] <= GRID) & (RANGE[1] >= GRID)
# Half width of the window of a grid point [% FS]; windows do not overlap, so grid points have independent noise.
HALF = 0.5
COVERED = 0.75  # fraction of the evaluated range that a branch must cover
FEWEST_STAIRS = 8
# Rise of the outlet that counts as the start, and range above it for extrapolation to the start [% FS]; ratio to the
# nominal slope above which the rise is a jump.
ZERO_STEP, ZERO_SPAN, JUMP = 0.5, 3.5, 5.0
# Number of lags after which the start of the sweep has decayed, and remaining error relative to the lag.
STARTED, UNDER_WAY = 3.0, 0.04
SLOW = 8  # polynomials along a branch that show slow noise
WIDEST = 5.0  # largest change of the setpoint between two samples of a sweep [% FS]
SHORT = 5.0  # deviation above which the setpoint is not reached [% FS]
STOPPING = 70.0  # setpoint above which clipped samples exclude a sweep from the lag [% FS]


def characteristic_trial(scale: Scale, volume: float, sweep: float, hold: float) -> Trial:
    """Return a trial with slow sweeps over the setpoint range.

    Each of the three cycles is a sweep up and a sweep down, with a hold after each sweep. `sweep` and `hold` are the
    durations of one sweep and of one hold [s], and `volume` is the outlet volume [m^3].
    """
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
    """Recorded sweep of the setpoint `x` with the outlet pressure `y`, both in % FS.

    `late` is the setpoint, delayed by the lag of the outlet. `parts` are the rising and the falling branches.
    """

    time: FloatArray
    x: FloatArray
    late: FloatArray
    y: FloatArray
    parts: list[Branch]
    cut: Mask  # samples of setpoint or outlet that are clipped


@dataclass(frozen=True, eq=False)
class Branches:
    """Outlet pressure [% FS] of all rising (`up`) and all falling (`down`) branches of sweeps.

    Each array has one row for each branch and one column for each setpoint 0, 1, ..., 100 % FS. A value is NaN if the
    branch does not reach that setpoint.
    """

    up: FloatArray
    down: FloatArray
    error: float  # one standard deviation of a single value by noise [% FS]
    share: float  # number of neighbouring values with the same noise: grid points between two stairs, slow noise


def _evaluate(evaluation: Evaluation, records: Sequence[Record]) -> None:
    all_sweeps = []
    for record in records:
        x, y = evaluation.scale.percents(record)
        cut = np.zeros(x.size, dtype=bool)
        for name in ("setpoint", "outlet"):
            cut |= record.clipped.get(name, False)
        all_sweeps.append(SetpointSweep(record.time, x, x, y, branches(x, SWING), cut))
    # All sweeps have the same lag (same valve and rate), and not every sweep ends in a sufficiently long hold.
    complete = [item for item in all_sweeps if not np.any(item.cut & (item.x > STOPPING))]
    lags = [lag for item in complete for lag in lags_of(item.time, item.x, item.y, item.parts)]
    all_sweeps = [replace(item, late=delay_by_lags(item.time, item.x, lags)) for item in all_sweeps]
    # The evaluated range must not contain clipped samples.
    evaluated = [s for s in all_sweeps if not np.any(s.cut & (s.x >= RANGE[0]) & (s.x <= RANGE[1]))]
    sweep, jump = _branch_curves(evaluated)
    if jump > WIDEST:
        evaluation.note("characteristic.jumps", jump=jump, widest=WIDEST)
    up, down = (rows.mean(axis=0) if rows.size else np.full(GRID.size, np.nan) for rows in (sweep.up, sweep.down))
    rates = []  # of the setpoint [% FS/s]
    for setpoint_sweep, branch in ((s, branch) for s in evaluated for branch in s.parts):
        x, time = setpoint_sweep.x[branch.samples], setpoint_sweep.time[branch.samples]
        indices = np.flatnonzero((x >= RANGE[0]) & (x <= RANGE[1]))
        if indices.size > 1:
            first, last = indices[0], indices[-1]
            rates.append(abs(x[last] - x[first]) / (time[last] - time[first]))
    evaluation.conditions |= {
        "branches_up": len(sweep.up), "branches_down": len(sweep.down), "range": list(RANGE),
        "sweep_rate": float(np.median(rates)) if rates else math.nan, "noise": sweep.error,
    }  # fmt: skip
    lag_change, uncertainty = mean_lag_change(lags) if lags else (0.0, Uncertainty(0.0))
    shift_error = float(np.linalg.norm([lag.shift_error for lag in lags])) / len(lags) if lags else 0.0
    _add_deviations(evaluation, sweep, up, down, shift_error)
    _add_zero_values(evaluation, all_sweeps, lag_change, uncertainty.standard)
    if lags:
        delay = max(0.0, float(np.mean([lag.time for lag in lags])))
        evaluation.add("sweep_lag", max(0.0, lag_change), uncertainty, time=delay)
    else:
        evaluation.note_absence("no_stop" if len(complete) == len(all_sweeps) else "clipped_stop", "sweep_lag")
    for name, mean_values, rows in (("up", up, sweep.up), ("down", down, sweep.down)):
        evaluation.add_curve(name, "characteristic", GRID, mean_values)
        for k, row in enumerate(rows):
            evaluation.add_curve(f"{name} {k + 1}", "cycles", GRID, row)
    evaluation.rows = [
        {"setpoint": float(x), "up": float(u), "down": float(d)}
        for x, u, d in zip(GRID[::5], up[::5], down[::5], strict=True)
        if math.isfinite(u) and math.isfinite(d)
    ]
    if all_sweeps and not evaluated:
        evaluation.limit_to_bounds("linearity", "hysteresis", "repeatability", "accuracy")


def _branch_curves(swept: Sequence[SetpointSweep]) -> tuple[Branches, float]:
    """Return the outlet pressure along all branches of the sweeps `swept`.

    Branches in which the setpoint jumps are omitted. The second item is the largest setpoint change between two samples
    [% FS] in the omitted branches.
    """
    rows: dict[int, list[FloatArray]] = {1: [], -1: []}
    shares, largest_jump = [1], 0.0
    for sweep, branch in ((item, branch) for item in swept for branch in item.parts):
        x, y = sweep.late[branch.samples], sweep.y[branch.samples]
        raw = sweep.x[branch.samples]
        in_range = (np.maximum(raw[1:], raw[:-1]) >= RANGE[0]) & (np.minimum(raw[1:], raw[:-1]) <= RANGE[1])
        jump = float(np.max(np.abs(np.diff(raw)), where=in_range, initial=0.0))
        holds = constant_sections(x)
        if len(holds) >= FEWEST_STAIRS and sum(s.stop - s.start for s in holds) > 0.8 * (branch.end - branch.first):
            ends = [steady_part(sweep.time[branch.samples], s, 0.2) for s in holds]
            setpoints, levels = (np.array([float(np.mean(series[s])) for s in ends]) for series in (x, y))
            order = np.argsort(setpoints)
            value = np.interp(GRID, setpoints[order], levels[order], np.nan, np.nan)
            share = max(1, round(float(np.median(np.diff(setpoints[order])))))  # grid points per stair
        elif jump > WIDEST:
            largest_jump = max(largest_jump, jump)
            continue
        else:
            value, share = values_at_points(x, y, GRID, HALF)[0], 1
        if np.mean(np.isfinite(value[INSIDE])) >= COVERED:
            rows[branch.sign].append(value)
            shares.append(share)
    up, down = (np.array(rows[sign]).reshape(-1, GRID.size) for sign in (1, -1))
    error = curve_noise(np.concatenate([up, down])[:, INSIDE], max(shares))
    return Branches(up, down, error, max(*shares, _noise_correlation([up, down], error))), largest_jump


def _noise_correlation(groups: Sequence[FloatArray], error: float) -> float:
    """Return the number of neighbouring grid values that share the same noise.

    Correlated noise changes slowly along a branch, so the differences between repeated branches contain larger
    low-order polynomials than independent values. The result is the power of these polynomials divided by the power
    that independent values would have. Each group contains repeated branches, one per row. `error` is the standard
    deviation of one value [% FS].
    """
    positions = np.linspace(-1.0, 1.0, np.count_nonzero(INSIDE))
    # The constant is left out: a valve that shifts from cycle to cycle is not noise.
    basis = np.linalg.qr(np.vander(positions, SLOW, increasing=True))[0][:, 1:]
    power, freedom = 0.0, 0
    for rows in (rows[:, INSIDE] for rows in groups if len(rows) > 1):
        if np.isfinite(rows).all():
            power += float(np.sum(((rows - rows.mean(axis=0)) @ basis) ** 2))
            freedom += basis.shape[1] * (len(rows) - 1)
    return power / (freedom * error**2) if freedom and error > 0.0 else 1.0


def _add_deviations(evaluation: Evaluation, sweep: Branches, up: FloatArray, down: FloatArray, lag: float) -> None:
    """Add linearity, hysteresis, accuracy and repeatability to the evaluation.

    `up` and `down` are the means of all rising and of all falling branches [% FS]. `lag` is the standard uncertainty of
    the correction for the lag of the outlet [% FS].
    """
    is_common = INSIDE & np.isfinite(up) & np.isfinite(down)
    if np.count_nonzero(is_common) < FEWEST_STAIRS:
        evaluation.note_absence("one_way", "linearity", "hysteresis")
    else:
        x, mean, gap = GRID[is_common], 0.5 * (up + down)[is_common], (down - up)[is_common]
        # The ends have half weight, as in an integral, so the line does not depend on the spacing of the grid.
        weight = np.ones(x.size)
        weight[[0, -1]] = math.sqrt(0.5)
        slope, offset = np.polyfit(x, mean, 1, w=weight)
        evaluation.conditions |= {"slope": float(slope), "offset": float(offset)}
        matrix = np.vander(x, 2)
        deviation = np.eye(x.size) - matrix @ np.linalg.pinv(matrix * weight[:, None]) * weight
        error = sweep.error * math.sqrt(1.0 / len(sweep.up) + 1.0 / len(sweep.down))
        mean_curve, gap_curve = (smooth(x, y, e, sweep.share) for y, e in ((mean, 0.5 * error), (gap, error)))
        k, j = (int(np.argmax(np.abs(y))) for y in (deviation @ mean_curve.values, gap_curve.values))
        value, uncertainty = correct_noise_bias(
            [mean_curve], lambda draws: np.max(np.abs(draws[0] @ deviation.T), axis=1)
        )
        evaluation.add_nonnegative("linearity", value, uncertainty, at=float(x[k]))
        value, uncertainty = correct_noise_bias([gap_curve], lambda draws: np.max(np.abs(draws[0]), axis=1))
        # Rising and falling branches lag by the same amount in opposite directions, so the gap has twice the error.
        evaluation.add_nonnegative("hysteresis", value, uncertainty.plus_normal(2.0 * lag), at=float(x[j]))
        if gap_curve.values[j] < -NORMAL * math.hypot(uncertainty.standard, 2.0 * lag):
            evaluation.note("characteristic.leads", at=float(x[j]))
    # The known points of each branch in the evaluated range.
    known_points = [(row, INSIDE & np.isfinite(row)) for row in np.concatenate([sweep.up, sweep.down])]
    rows = [(row[is_known], GRID[is_known]) for row, is_known in known_points]
    if rows:
        curves = [smooth(x, row - x, sweep.error, sweep.share) for row, x in rows]
        value, uncertainty = correct_noise_bias(
            curves, lambda draws: np.max([np.max(np.abs(d), axis=1) for d in draws], axis=0)
        )
        worst = max(range(len(rows)), key=lambda k: float(np.max(np.abs(curves[k].values))))
        index = int(np.argmax(np.abs(curves[worst].values)))
        evaluation.add_nonnegative("accuracy", value, uncertainty.plus_normal(lag), at=float(rows[worst][1][index]))
    else:
        evaluation.note_absence("no_sweep", "accuracy")
    spreads = []
    for branch_rows in (sweep.up, sweep.down):
        is_known = INSIDE & np.isfinite(branch_rows).all(axis=0)
        if len(branch_rows) > 1 and np.count_nonzero(is_known) > FEWEST_STAIRS:
            deviations = branch_rows[:, is_known] - branch_rows[:, is_known].mean(axis=0)
            curves = [smooth(GRID[is_known], row, sweep.error, sweep.share) for row in deviations]
            spreads.append(correct_noise_bias(curves, lambda draws: np.max(np.ptp(draws, axis=0), axis=1)))
    if spreads:
        value, uncertainty, _ = greatest(*zip(*spreads, strict=True))
        cycles = min(len(branch_rows) for branch_rows in (sweep.up, sweep.down) if len(branch_rows) > 1)
        evaluation.add_nonnegative("repeatability", value, uncertainty, cycles=cycles)
    else:
        evaluation.note_absence("one_cycle", "repeatability")


def _add_zero_values(evaluation: Evaluation, sweeps: Sequence[SetpointSweep], lag: float, error: float) -> None:
    """Add zero suppression and zero offset to the evaluation.

    Zero suppression is the setpoint at which the outlet begins to rise, and zero offset the outlet at setpoint zero.
    `lag` is the change of the outlet in the hold after a sweep, and `error` its standard uncertainty [% FS]. A note
    reports an outlet pressure that does not reach the upper end of the range.
    """
    zero, short = [], []
    holds: dict[int, FloatArray] = {}
    is_cut = False
    for sweep in sweeps:
        x, y = sweep.x, sweep.y
        if np.any(sweep.cut & (x < RANGE[0])):
            is_cut = True
            continue
        for branch in sweep.parts:
            low, high = (branch.first, branch.end - 1)[:: branch.sign]
            if branch.sign > 0:
                zero.append(_setpoint_of_first_rise(sweep.late[branch.samples], y[branch.samples], lag))
                if x[high] > 95.0 and not np.any(sweep.cut):
                    short.append(float(np.mean(y[_end_of_hold(x, high)])) - float(x[high]))
            if abs(_median_setpoint(x, low)) < ZERO_STEP:
                holds[_end_of_hold(x, low).start] = y[_end_of_hold(x, low)]
    # A sweep without a hold at zero gives no offset.
    longest = max((part.size for part in holds.values()), default=0)
    holds = {begin: part for begin, part in holds.items() if part.size > 0.3 * longest}
    noise = estimate_noise(list(holds.values()))
    offset = [(float(np.mean(part)), Uncertainty(noise.mean(part.size))) for part in holds.values()]
    for name, values, reason in (("zero_suppression", zero, "no_start"), ("zero_offset", offset, "no_zero")):
        pairs = [value for value in values if math.isfinite(value[0])]
        if pairs:
            value, uncertainty = mean_of([sweep for sweep, _ in pairs], [sweep for _, sweep in pairs])
            evaluation.add(name, value, uncertainty.plus_normal(error) if name == "zero_suppression" else uncertainty)
        else:
            evaluation.note_absence("clipped" if is_cut else reason, name)
    if short and min(short) < -SHORT:
        evaluation.note("characteristic.short", short=-min(short))


def _median_setpoint(x: FloatArray, index: int) -> float:
    """Return the median of the setpoint samples around the sample `index`.

    `x` is the setpoint. The median of up to nine samples is robust to noise.
    """
    return float(np.median(x[max(0, index - 4) : index + 5]))


def _end_of_hold(x: FloatArray, index: int) -> slice:
    """Return the final part of the hold that contains the sample `index`.

    In a hold, the setpoint `x` [% FS] is constant. The final part is the last third, without its last samples.
    """
    is_away = np.abs(x - _median_setpoint(x, index)) > max(ZERO_STEP, 5.0 * setpoint_noise(x))
    hold = unmasked_section(is_away, index, index)
    size = hold.stop - hold.start
    # The last third without the last eighth, in which a noisy setpoint may already change.
    middle = max(hold.start, hold.stop - max(1, size // 3))
    return slice(middle, max(middle + 1, hold.stop - size // 8))


def _setpoint_of_first_rise(x: FloatArray, y: FloatArray, lag: float) -> tuple[float, Uncertainty]:
    """Return the setpoint at which the outlet pressure begins to rise, with its uncertainty.

    `x` is the setpoint, `y` the outlet pressure, and `lag` the pressure by which the outlet lags behind the setpoint,
    all in % FS. After the start, the outlet needs several lags to reach the rate of the setpoint, so the fit omits
    these samples. The result is NaN if the setpoint does not start at zero or the outlet does not rise.
    """
    scatter = 5.0 * setpoint_noise(x)
    if x.size < FEWEST_STAIRS or x[0] > max(ZERO_STEP, scatter):
        return math.nan, Uncertainty(math.nan)
    begin = max(3, int(np.argmax(x > max(x[0] + 0.5 * ZERO_STEP, scatter))))
    zero = float(np.median(y[:begin])) if begin < 8 else float(np.mean(y[:begin]))
    noise = estimate_noise([y[(x > RANGE[0]) & (x < 2.5 * RANGE[0])]], 3)
    # Means of as many samples as the setpoint takes for a quarter of a per cent.
    size = max(1, int(np.count_nonzero(x < 2.0 * RANGE[0]) / (8.0 * RANGE[0]))) if noise.sigma > 1e-6 else 1
    blocks = [np.convolve(series, np.full(size, 1.0 / size), "valid")[::size] for series in (x, y - zero)]
    rise = max(ZERO_STEP, 5.0 * noise.mean(size))
    risen = np.flatnonzero(blocks[1] > rise)
    if not risen.size:
        return math.nan, Uncertainty(math.nan)
    left = float(blocks[0][risen[0]])
    start = left + STARTED * max(lag, 0.0)
    is_near = (x > start) & (x <= start + ZERO_SPAN)
    if np.count_nonzero(is_near) < 4 or np.ptp(x[is_near]) <= ZERO_SPAN / JUMP:
        return left, Uncertainty(math.nan)
    matrix = np.vander(x[is_near] - left, 2)
    inverse = np.linalg.pinv(matrix)
    slope, level = (inverse @ (y[is_near] - zero)).tolist()
    half_width = 0.5 * float(np.ptp(x[: size + 1]))
    if level > 2.0 * rise + ZERO_STEP or slope <= 0.0:  # the outlet jumps from zero
        return left, Uncertainty(0.0, max(half_width, 0.5 * float(np.median(np.abs(np.diff(x))))))
    distance = level / slope
    # Correction for a curved characteristic, whose slope changes from the start as it does at higher setpoints.
    is_further = (x > left + 2.0 * RANGE[0]) & (x <= left + 3.0 * RANGE[0])
    if np.count_nonzero(is_further) > np.count_nonzero(is_near):
        further_slope = float(np.polyfit(x[is_further], y[is_further], 1)[0])
        bend = (further_slope - slope) / float(np.mean(x[is_further]) - np.mean(x[is_near]))
        ahead, width = float(np.mean(x[is_near])) - left + distance, float(np.ptp(x[is_near]))
        distance += 0.5 * bend * (ahead**2 - width**2 / 12.0) / slope
    # The selection of the samples by a noisy start increases the uncertainty.
    error = CHOSEN * math.hypot(noise.of(inverse[1] - distance * inverse[0]), noise.mean(begin))
    return max(0.0, left - distance), Uncertainty(math.hypot(error / slope, UNDER_WAY * max(lag, 0.0)))


_FIGURES = "linearity", "hysteresis", "repeatability", "accuracy", "zero_suppression", "zero_offset", "sweep_lag"
CHARACTERISTIC = BenchTest(
    "characteristic", _evaluate, dict.fromkeys(_FIGURES, "% FS"), {"low": RANGE[0], "high": RANGE[1]},
    trials=lambda pace: [characteristic_trial(pace.specimen.scale, pace.volume, pace.sweep(), pace.hold)],
)  # fmt: skip
