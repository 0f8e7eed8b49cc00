"""What the supply does to the outlet, and what the valve takes from it at rest."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from poppet.bench.iso10094.bench_settings import ROWS, Pace, Trial, held
from poppet.bench.iso10094.evaluation import AT_MOST, BenchTest, Curve, Evaluation, Row, largest
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.shapes import at_places, branches
from poppet.bench.iso10094.sweep import caught_up, lags_of
from poppet.bench.iso10094.uncertainty import NORMAL, Uncertainty, greatest, noise_about, roughness, smooth, unbiased
from poppet.timeseries.measurements.noise import noise_of
from poppet.timeseries.signals import Points

ABOVE, SPAN = 0.15, 0.4
"""Lowest supply of the sweep above the outlet and its extent, in FS."""
LOAD = 0.05
"""Load while the supply is swept: a closed outlet would hold its pressure whatever the supply does."""
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


def supply_trial(
    scale: Scale, volume: float, setpoint: float, sweep: float, hold: float, ends: tuple[float, float]
) -> Trial:
    """A sweep of the supply pressure up and down at a constant setpoint."""
    low, high = ends
    # One cycle ahead: what the valve remembers of its way to the setpoint is over.
    times = np.cumsum([0.0, hold, sweep, sweep, sweep, hold, sweep, hold])
    signal = Points(times, np.array([low, low, high, low, high, high, low, low]))
    lead, duration = float(times[3]), float(times[-1])
    return Trial(
        "supply", f"supply at {setpoint:g} % FS", held(scale, setpoint), duration, lead, sweep / ROWS, volume,
        supply=signal, load=Points([0.0], [LOAD]),
    )  # fmt: skip


def leakage_trial(scale: Scale, volume: float, setpoint: float, hold: float) -> Trial:
    """A constant setpoint with the outlet closed."""
    name, lead = f"rest at {setpoint:g} % FS", 5.0 * hold
    return Trial("leakage", name, held(scale, setpoint), 2.0 * lead, lead, lead / ROWS, volume)


def _supply_trials(pace: Pace) -> list[Trial]:
    scale, sweep = pace.specimen.scale, 0.5 * pace.sweep()
    trials = []
    for setpoint in pace.settings.setpoints:
        low = float(scale.pressure(setpoint)) + ABOVE * scale.span
        ends = low, max(pace.specimen.supply, low + SPAN * scale.span)
        trials.append(supply_trial(scale, pace.volume, setpoint, sweep, pace.hold, ends))
    return trials


def _leakage_trials(pace: Pace) -> list[Trial]:
    setpoints = (0.0, *pace.settings.setpoints)
    return [leakage_trial(pace.specimen.scale, pace.volume, setpoint, pace.hold) for setpoint in setpoints]


def _evaluate_supply(found: Evaluation, records: Sequence[Record]) -> None:
    for record in records:
        _one(found, record)
    judged = [row for row in found.rows if "sensitivity" in row]
    if judged:
        sizes, doubts = found.known(judged, "sensitivity")
        value, doubt, k = greatest([abs(size) for size in sizes], doubts)
        conditions = {key: judged[k][key] for key in ("setpoint", "lowest_supply", "highest_supply")}
        signed = math.copysign(value, sizes[k])
        found.add_seen("supply_sensitivity", signed, 2.0 * NORMAL * doubt.standard, doubt, **conditions)
    else:
        found.absent("no_supply_sweep", "supply_sensitivity")
    both = [row for row in found.rows if "hysteresis" in row]
    if both:
        value, doubt, k = greatest(*found.known(both, "hysteresis"))
        found.add_judged("supply_hysteresis", value, doubt)
    else:
        found.absent("supply_one_way", "supply_hysteresis")


def _one(found: Evaluation, record: Record) -> None:
    supply, scale = record.supply, found.scale
    x, y = scale.percents(record)
    row: Row = {"record": record.name, "setpoint": float(np.median(x))}
    found.rows.append(row)
    judged = scale.percent(supply) > float(np.median(y)) + MARGIN
    extent = float(np.ptp(supply[judged])) if np.count_nonzero(judged) > 10 else 0.0
    if extent < 0.02 * scale.span:
        found.note("supply.still", record.name, extent=extent)
        return
    # Ends of the sweep, not of its noise.
    aside = 2.0 * noise_of(supply)
    low, high = float(np.min(supply[judged])) + aside, float(np.max(supply[judged])) - aside
    row |= {"lowest_supply": low, "highest_supply": high}
    grid = np.linspace(low, high, PLACES)
    ways: dict[int, list[FloatArray]] = {1: [], -1: []}
    parts = branches(supply, TURN * extent)
    lags = lags_of(record.time, supply, y, parts)
    late = caught_up(record.time, supply, lags)
    for branch in parts:
        value, _ = at_places(late[branch.samples], y[branch.samples], grid, 0.5 * extent / (PLACES - 1))
        ways[branch.sign].append(value)
    means = {sign: np.mean(values, axis=0) for sign, values in ways.items() if values}
    for sign, mean in means.items():
        known = np.isfinite(mean)
        way, case = "rising" if sign > 0 else "falling", f"{row['setpoint']:.0f} % FS"
        found.curves.append(Curve(way, case, grid[known], mean[known]))
    mean = np.mean(list(means.values()), axis=0)
    known = np.isfinite(mean)
    if np.count_nonzero(known) < PLACES // 2:
        found.note("supply.incomplete", record.name)
        return
    every = np.array([value for values in ways.values() for value in values])
    sigma = roughness(every)
    # Where the sweep has turned, there and back have not parted yet.
    inner = known & (np.arange(PLACES) >= PLACES // 10) & (np.arange(PLACES) < PLACES - PLACES // 10)
    place = (grid[inner] - np.mean(grid[inner])) * 100.0 / scale.span
    slope = float(place @ mean[inner]) / float(place @ place)
    # Of as many sweeps, each of as many places.
    slope_error = sigma / math.sqrt(len(every) * float(place @ place))
    found.know(row, "sensitivity", slope, Uncertainty(slope_error))
    if len(means) == 2:
        own = sigma * math.sqrt(sum(1.0 / len(values) for values in ways.values() if values))
        gap = smooth(grid[inner], (means[1] - means[-1])[inner], own)
        widest, doubt = unbiased([gap], lambda draws: np.max(np.abs(draws[0]), axis=1))
        lag = float(np.linalg.norm([each.error for each in lags])) / len(lags) if lags else 0.0
        found.know(row, "hysteresis", widest, doubt.wider(2.0 * lag))


def _evaluate_leakage(found: Evaluation, records: Sequence[Record]) -> None:
    for record in records:
        last = record.time >= record.time[-1] - HOLD * (record.time[-1] - record.time[0])
        clock, flow = record.time[last], record.consumption[last]
        mean = float(np.trapezoid(flow, clock) / (clock[-1] - clock[0]))
        half = flow.size // 2
        drift = abs(float(np.mean(flow[half:]) - np.mean(flow[:half])))
        error = 4.0 * noise_of(flow) / math.sqrt(max(1, half))
        x, y = (series[last] for series in found.scale.percents(record))
        row: Row = {"record": record.name, "setpoint": float(np.median(x)), "outlet": float(np.mean(y))}
        doubt = Uncertainty(noise_about([flow]).mean(flow.size)) if float(np.ptp(flow)) > 0.0 else Uncertainty(0.0)
        found.rows.append(row)
        found.know(row, "flow", mean, doubt)
        row["known_to"] = max(error, drift)
        if drift > max(DRIFT * abs(mean), error) and drift > UNSEEN:
            found.note("leakage.drifts", record.name)
    worst = largest(found.rows, "flow")
    if worst is None:
        found.absent("no_consumption", "leakage")
        return
    is_lost = worst["known_to"] > 0.0 and abs(worst["flow"]) < worst["known_to"]
    if is_lost:
        found.add("leakage", worst["known_to"], bound=AT_MOST, setpoint=worst["setpoint"])
        return
    rows = [row for row in found.rows if "flow" in row]
    value, doubt, k = greatest(*found.known(rows, "flow"))
    found.add("leakage", value, doubt, setpoint=rows[k]["setpoint"])


SUPPLY = BenchTest(
    "supply",
    _evaluate_supply,
    {"supply_sensitivity": "1", "supply_hysteresis": "% FS"},
    trials=_supply_trials,
    needs="supply",
    whole=("outlet", "supply"),
)
LEAKAGE = BenchTest(
    "leakage",
    _evaluate_leakage,
    {"leakage": "kg/s"},
    trials=_leakage_trials,
    needs="consumption",
    whole=("consumption",),
)
