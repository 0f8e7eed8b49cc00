"""Tests of the effect of supply pressure on outlet pressure, and of air consumption."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from poppet.bench.iso10094.evaluation import (
    AT_MOST,
    ROWS,
    BenchTest,
    Evaluation,
    Pace,
    Row,
    Trial,
    constant_setpoint,
    largest,
)
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.shapes import branches, delay_by_lags, lags_of, values_at_points
from poppet.bench.iso10094.uncertainty import (
    NORMAL,
    Uncertainty,
    correct_noise_bias,
    curve_noise,
    estimate_noise,
    greatest,
    smooth,
)
from poppet.timeseries.measurements.measurement import noise_of
from poppet.timeseries.signals import Points

ABOVE, SPAN = 0.15, 0.4  # lowest supply of the sweep above the outlet and its extent, in FS
LOAD = 0.05  # load during the sweep, because a closed outlet would hold its pressure at any supply pressure
MARGIN = 10.0  # smallest difference between supply and outlet for the evaluation [% FS]
PLACES = 81
TURN = 0.3  # reversal of the supply pressure that ends a branch, as a fraction of its range
UNSEEN = 1e-7  # smallest change of a leakage that a flow meter resolves [kg/s]
HOLD = 0.5  # last fraction of a hold, in which a leakage is averaged
DRIFT = 0.05  # relative change between the halves of this fraction, above which a leakage is not steady


def supply_trial(
    scale: Scale, volume: float, setpoint: float, sweep: float, hold: float, ends: tuple[float, float]
) -> Trial:
    """Return a trial that sweeps the supply pressure at a constant setpoint.

    The sweep goes from the lowest pressure to the highest and back. `ends` are these pressures [Pa], `setpoint` is in %
    FS, and `sweep` and `hold` are durations [s]. The trial begins with one more sweep up and down, which is not
    recorded.
    """
    low, high = ends
    # The first cycle is not evaluated: it removes the effect of previous motions of the valve.
    times = np.cumsum([0.0, hold, sweep, sweep, sweep, hold, sweep, hold])
    return Trial(
        "supply", f"supply at {setpoint:g} % FS", constant_setpoint(scale, setpoint), float(times[-1]), float(times[3]),
        sweep / ROWS, volume, supply=Points(times, np.array([low, low, high, low, high, high, low, low])),
        load=Points([0.0], [LOAD]),
    )  # fmt: skip


def supply_trials(pace: Pace) -> list[Trial]:
    """Return one trial with sweeps of the supply pressure for each setpoint."""
    scale, sweep = pace.specimen.scale, 0.5 * pace.sweep()
    trials = []
    for setpoint in pace.settings.setpoints:
        low = float(scale.pressure(setpoint)) + ABOVE * scale.span
        ends = low, max(pace.specimen.supply, low + SPAN * scale.span)
        trials.append(supply_trial(scale, pace.volume, setpoint, sweep, pace.hold, ends))
    return trials


def leakage_trial(scale: Scale, volume: float, setpoint: float, hold: float) -> Trial:
    """Return a leakage trial: a run at constant setpoint without flow at the outlet.

    `scale` contains the ranges of setpoint and outlet pressure, and `volume` is the volume at the outlet [m^3].
    `setpoint` is in % FS, and `hold` is the settling time of the valve [s].
    """
    name, settling = f"rest at {setpoint:g} % FS", 5.0 * hold
    return Trial("leakage", name, constant_setpoint(scale, setpoint), 2.0 * settling, settling, settling / ROWS, volume)


def leakage_trials(pace: Pace) -> list[Trial]:
    """Return one leakage trial for setpoint zero and one for each setpoint of the settings."""
    setpoints = (0.0, *pace.settings.setpoints)
    return [leakage_trial(pace.specimen.scale, pace.volume, setpoint, pace.hold) for setpoint in setpoints]


def _evaluate(evaluation: Evaluation, records: Sequence[Record]) -> None:
    for record in records:
        _evaluate_record(evaluation, record)
    evaluated = [row for row in evaluation.rows if "sensitivity" in row]
    if evaluated:
        sizes, uncertainties = evaluation.values_of(evaluated, "sensitivity")
        value, uncertainty, k = greatest([abs(size) for size in sizes], uncertainties)
        conditions = {key: evaluated[k][key] for key in ("setpoint", "lowest_supply", "highest_supply")}
        signed, limit = math.copysign(value, sizes[k]), 2.0 * NORMAL * uncertainty.standard
        evaluation.add_or_bound("supply_sensitivity", signed, limit, uncertainty, **conditions)
    else:
        evaluation.note_absence("no_supply_sweep", "supply_sensitivity")
    evaluation.add_greatest("supply_hysteresis", "hysteresis", "supply_one_way", is_nonnegative=True)


def _evaluate_record(evaluation: Evaluation, record: Record) -> None:
    supply, scale = record.supply, evaluation.scale
    x, y = scale.percents(record)
    row: Row = {"record": record.name, "setpoint": float(np.median(x))}
    evaluation.rows.append(row)
    evaluated = scale.percent(supply) > float(np.median(y)) + MARGIN
    extent = float(np.ptp(supply[evaluated])) if np.count_nonzero(evaluated) > 10 else 0.0
    if extent < 0.02 * scale.span:
        evaluation.note("supply.still", record.name, extent=extent)
        return
    # Limits of the sweep, robust to noise.
    margin = 2.0 * noise_of(supply)
    low, high = float(np.min(supply[evaluated])) + margin, float(np.max(supply[evaluated])) - margin
    row |= {"lowest_supply": low, "highest_supply": high}
    grid = np.linspace(low, high, PLACES)
    values_by_sign: dict[int, list[FloatArray]] = {1: [], -1: []}
    parts = branches(supply, TURN * extent)
    lags = lags_of(record.time, supply, y, parts)
    delayed = delay_by_lags(record.time, supply, lags)
    for branch in parts:
        value, _ = values_at_points(delayed[branch.samples], y[branch.samples], grid, 0.5 * extent / (PLACES - 1))
        values_by_sign[branch.sign].append(value)
    means = {sign: np.mean(values, axis=0) for sign, values in values_by_sign.items() if values}
    for sign, mean in means.items():
        evaluation.add_curve("rising" if sign > 0 else "falling", f"{row['setpoint']:.0f} % FS", grid, mean)
    mean = np.mean(list(means.values()), axis=0)
    is_known = np.isfinite(mean)
    if np.count_nonzero(is_known) < PLACES // 2:
        evaluation.note("supply.incomplete", record.name)
        return
    all_values = np.array([value for values in values_by_sign.values() for value in values])
    sigma = curve_noise(all_values)
    # Near a reversal of the sweep, both directions still have the same values.
    inner = is_known & (np.arange(PLACES) >= PLACES // 10) & (np.arange(PLACES) < PLACES - PLACES // 10)
    centred = (grid[inner] - np.mean(grid[inner])) * 100.0 / scale.span
    slope = float(centred @ mean[inner]) / float(centred @ centred)
    # Standard error of a slope from all sweeps and grid points.
    slope_error = sigma / math.sqrt(len(all_values) * float(centred @ centred))
    evaluation.set_value(row, "sensitivity", slope, Uncertainty(slope_error))
    if len(means) == 2:
        gap_error = sigma * math.sqrt(sum(1.0 / len(values) for values in values_by_sign.values() if values))
        gap = smooth(grid[inner], (means[1] - means[-1])[inner], gap_error)
        widest, uncertainty = correct_noise_bias([gap], lambda draws: np.max(np.abs(draws[0]), axis=1))
        lag = float(np.linalg.norm([lag_of_branch.shift_error for lag_of_branch in lags])) / len(lags) if lags else 0.0
        evaluation.set_value(row, "hysteresis", widest, uncertainty.plus_normal(2.0 * lag))


def evaluate_leakage(evaluation: Evaluation, records: Sequence[Record]) -> None:
    """Add the leakage to the evaluation: the largest steady-state flow out of the supply.

    Each record gives one flow [kg/s].
    """
    for record in records:
        last = record.time >= record.time[-1] - HOLD * (record.time[-1] - record.time[0])
        clock, flow = record.time[last], record.consumption[last]
        mean = float(np.trapezoid(flow, clock) / (clock[-1] - clock[0]))
        half = flow.size // 2
        drift = abs(float(np.mean(flow[half:]) - np.mean(flow[:half])))
        error = 4.0 * noise_of(flow) / math.sqrt(max(1, half))
        x, y = (series[last] for series in evaluation.scale.percents(record))
        row: Row = {"record": record.name, "setpoint": float(np.median(x)), "outlet": float(np.mean(y))}
        noise = estimate_noise([flow]).mean(flow.size) if float(np.ptp(flow)) > 0.0 else 0.0
        evaluation.rows.append(row)
        evaluation.set_value(row, "flow", mean, Uncertainty(noise))
        row["known_to"] = max(error, drift)
        if drift > max(DRIFT * abs(mean), error) and drift > UNSEEN:
            evaluation.note("leakage.drifts", record.name)
    worst = largest(evaluation.rows, "flow")
    if worst is not None and worst["known_to"] > 0.0 and abs(worst["flow"]) < worst["known_to"]:
        evaluation.add("leakage", worst["known_to"], bound=AT_MOST, setpoint=worst["setpoint"])
    else:
        evaluation.add_greatest("leakage", "flow", "no_consumption", conditions=("setpoint",))


SUPPLY = BenchTest(
    "supply", _evaluate, {"supply_sensitivity": "1", "supply_hysteresis": "% FS"}, trials=supply_trials, needs="supply",
    whole=("outlet", "supply"),
)  # fmt: skip
LEAKAGE = BenchTest(
    "leakage", evaluate_leakage, {"leakage": "kg/s"}, trials=leakage_trials, needs="consumption", whole=("consumption",)
)
