"""Test of outlet pressure versus flow: droop, relief, flow capacity and hysteresis."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from poppet.bench.iso10094.evaluation import AT_LEAST, ROWS, BenchTest, Evaluation, Pace, Row, Trial, constant_setpoint
from poppet.bench.iso10094.scale import FloatArray, Mask, Record, Scale
from poppet.bench.iso10094.shapes import Lag, branches, delay_by_lags, lags_of, values_at_points
from poppet.bench.iso10094.uncertainty import Uncertainty, correct_noise_bias, curve_noise, estimate_noise, smooth
from poppet.timeseries.measurements.measurement import noise_of
from poppet.timeseries.signals import Points

DROOP = 10.0  # fall of the outlet that defines the flow capacity [% FS]
PLACES = 81
TURN = 0.15  # reversal of the flow that ends a branch, as a fraction of the largest flow
FOLD = 0.99  # fraction of the largest flow above which a valve can be at its limit
# Distance of the outlet below its smallest value at increasing flow, at which a valve is at its limit [% FS].
FALLEN = 2.0
STILL = 0.01  # fraction of the largest flow at which a sweep begins
NONE = 1e-3  # fraction of the largest flow that counts as no flow
TOP, TOP_ERROR = 400, 5e-4  # number of averaged samples for the largest flow, and its relative uncertainty
# Grid points on each side for the outlet at a flow, smallest number of points of a curve, and change of the outlet
# around its capacity [% FS].
NEIGHBOURS, FEWEST, AROUND = 5, 10, 2.0
LEAST_FLOW = 1e-9  # flow below which there is no flow [kg/s]


def flow_trial(scale: Scale, volume: float, setpoint: float, sweep: float, hold: float, load: float) -> Trial:
    """Return a trial at constant setpoint, in which the flow rises and returns to zero.

    `load` is the flow at the end of the rise, divided by the largest flow: 1 for forward flow, -1 for relief flow. The
    trial has a hold of `hold` seconds before, between and after the two sweeps of `sweep` seconds. `setpoint` is in %
    FS, and `volume` is the outlet volume [m^3].
    """
    times = np.cumsum([0.0, 2.0 * hold, sweep, hold, sweep, hold])
    signal = Points(times, np.array([0.0, 0.0, load, load, 0.0, 0.0]))
    name = f"flow {'out' if load > 0 else 'in'} at {setpoint:g} % FS"
    return Trial(
        "flow", name, constant_setpoint(scale, setpoint), float(times[-1]), hold, sweep / ROWS, volume, load=signal
    )


def flow_trials(pace: Pace) -> list[Trial]:
    """Return one trial with forward flow and one with relief flow for each setpoint."""
    scale, sweep = pace.specimen.scale, 0.5 * pace.sweep()
    cases = ((load, setpoint) for load in (1.0, -1.0) for setpoint in pace.settings.setpoints)
    return [flow_trial(scale, pace.volume, setpoint, sweep, pace.hold, load) for load, setpoint in cases]


class FlowDirection(NamedTuple):
    """Direction of the flow: forward (`drawn`, sign +1) or relief (`fed`, sign -1).

    `change` is the table column of the pressure change: droop for forward flow, rise for relief flow. `figure` and
    `hysteresis` are the names of the characteristic values.
    """

    name: str
    direction: str  # for messages
    sign: float
    change: str
    figure: str
    hysteresis: str


SIDES = (
    FlowDirection("drawn", "forward", 1.0, "droop", "flow_droop", "flow_hysteresis"),
    FlowDirection("fed", "relief", -1.0, "rise", "relief_rise", "relief_hysteresis"),
)


class FlowSweep(NamedTuple):
    """Outlet pressure [% FS] versus flow [kg/s] in one direction, on an equidistant grid.

    `going` is the outlet at increasing flow, and `coming` the outlet at decreasing flow. `coming` is None if the record
    ends before the flow decreases to zero.
    """

    row: Row
    grid: FloatArray
    going: FloatArray
    coming: FloatArray | None
    sigma: float  # standard deviation of a single value [% FS]
    rest: Uncertainty  # uncertainty of the outlet without flow [% FS]
    judged: Mask | None  # points at which both directions are compared
    lag: float  # standard uncertainty of the removed lag, relative to the largest flow


def _evaluate(evaluation: Evaluation, records: Sequence[Record]) -> None:
    sweeps: dict[FlowDirection, list[FlowSweep]] = {side: [] for side in SIDES}
    for record in records:
        x, y = evaluation.scale.percents(record)
        is_still = np.abs(record.flow) <= max(NONE * float(np.max(np.abs(record.flow))), 5.0 * noise_of(record.flow))
        # The outlet without flow, at the end of the hold before the flow begins.
        moving = np.flatnonzero(~is_still)
        values_before = y[: moving[0]] if moving.size and moving[0] > 3 else y[is_still][:10]
        part = values_before[-max(3, values_before.size // 3) :]
        uncertainty = Uncertainty(estimate_noise([part]).mean(part.size))
        outlet = float(np.mean(part)) if part.size else math.nan
        row: Row = {"record": record.name, "setpoint": float(np.median(x)), "outlet": outlet}
        evaluation.rows.append(row)
        for side in SIDES:
            sweep = _evaluate_direction(evaluation, record, y, row, side, uncertainty)
            sweeps[side] += [sweep] if sweep else []
    for side in SIDES:
        _add_flow_values(evaluation, side, sweeps[side])
    # The smallest flow capacity of all cases. If the outlet did not fall sufficiently in any case, the smallest of the
    # tested maximum flows is a lower bound.
    for key, bound in (("capacity", ""), ("capacity_at_least", AT_LEAST)):
        rows = [row for row in evaluation.rows if key in row]
        if rows:
            row = min(rows, key=lambda candidate: float(candidate[key]))
            capacity_uncertainty = evaluation.uncertainties.get((id(row), key))
            evaluation.add("flow_capacity", row[key], capacity_uncertainty, bound=bound, setpoint=row["setpoint"])
            break
    else:
        evaluation.note_absence("none_drawn", "flow_capacity")


def _evaluate_direction(
    evaluation: Evaluation, record: Record, y: FloatArray, row: Row, side: FlowDirection, rest_uncertainty: Uncertainty
) -> FlowSweep | None:
    """Evaluate the forward flow or the relief flow of a record.

    `side` is forward or relief flow, `y` the outlet pressure [% FS], and `row` the entry of the result table for this
    record. `rest_uncertainty` is the uncertainty of the outlet pressure without flow. The result is None if the record
    has no flow in this direction, or if the flow does not rise from zero.
    """
    flow = side.sign * record.flow
    # The maximum of noisy samples is biased.
    width = max(1, min(TOP, flow.size // 100)) if noise_of(flow) > 1e-6 * float(np.ptp(flow)) else 1
    top = float(np.max(np.convolve(flow, np.full(width, 1.0 / width), "valid")))
    opposite = float(np.max(-flow))
    if top < max(LEAST_FLOW, 0.02 * opposite):
        return None
    row[f"largest_{side.name}"] = top
    clipped_flow = np.where(flow > 0.0, flow, 0.0) if width == 1 else flow
    lags = lags_of(record.time, clipped_flow, y, branches(clipped_flow, TURN * top))
    delayed = delay_by_lags(record.time, clipped_flow, lags)
    grid = np.linspace(0.0, top, PLACES)
    top_samples = np.flatnonzero(clipped_flow >= FOLD * top)
    start_samples = np.flatnonzero(clipped_flow <= STILL * top)
    earlier, later = start_samples[start_samples < top_samples[0]], start_samples[start_samples > top_samples[-1]]
    # The samples between first and last arrival at the top are excluded: the valve is at its limit.
    parts = (
        slice(int(earlier[-1]) + 1, int(top_samples[0]) + 1) if earlier.size else None,
        slice(int(top_samples[-1]), int(later[0])) if later.size else None,
    )
    half = 0.5 * top / (PLACES - 1)
    going, coming = (
        None if part is None else values_at_points(delayed[part], y[part], grid, half)[0] for part in parts
    )
    if going is None:
        evaluation.note("flow.no_rise", record.name, way=side.direction)
        return None
    # At the limit of the valve, the outlet falls at almost constant flow, which is not hysteresis.
    fallen = flow[(side.sign * y < np.nanmin(side.sign * going) - FALLEN) & (flow > 0.5 * top)]
    limit = min(top, float(np.min(fallen, initial=top)))
    case = f"{row['setpoint']:.0f} % FS"
    for direction, curve, end in (("going", going, top), ("coming", coming, limit)):
        if curve is not None:
            is_shown = grid <= end
            evaluation.add_curve(f"{side.name} {direction}", case, side.sign * grid[is_shown], curve[is_shown])
    if side.sign > 0.0:
        _set_flow_capacity(evaluation, row, record.time, delayed, row["outlet"] - y, rest_uncertainty)
        if "capacity" in row:
            uncertainty = evaluation.uncertainties[id(row), "capacity"]
            evaluation.set_value(row, "capacity", row["capacity"], uncertainty.plus_normal(_lag_error(lags)))
    curves = [curve for curve in (going, coming) if curve is not None]
    sigma = curve_noise(np.array(curves), 1)
    lag = _lag_error(lags) / top
    if coming is None:
        evaluation.note("flow.no_return", record.name, way=side.direction)
        return FlowSweep(row, grid, going, None, sigma, rest_uncertainty, None, lag)
    judged = (grid > 0.1 * limit) & (grid < 0.9 * limit) & np.isfinite(going) & np.isfinite(coming)
    if np.count_nonzero(judged) > FEWEST:
        gap = smooth(grid[judged], (going - coming)[judged], math.sqrt(2.0) * sigma)
        value, uncertainty = correct_noise_bias([gap], lambda draws: np.max(np.abs(draws[0]), axis=1))
        upper = judged & (grid > 0.5 * limit)  # usually the steeper part
        slope = abs(float(np.polyfit(grid[upper] / top, going[upper], 1)[0]))
        evaluation.set_value(row, f"hysteresis_{side.name}", value, uncertainty.plus_normal(2.0 * lag * slope))
    return FlowSweep(row, grid, going, coming, sigma, rest_uncertainty, judged, lag)


def _lag_error(lags: Sequence[Lag]) -> float:
    """Return the standard uncertainty of the flow [kg/s] from the correction for lags.

    `lags` are the measured lags of the outlet behind the sweeps.
    """
    errors = [lag.error * lag.rate for lag in lags]
    return float(np.linalg.norm(errors)) / len(errors) if errors else 0.0


def _set_flow_capacity(
    evaluation: Evaluation, row: Row, time: FloatArray, flow: FloatArray, droop: FloatArray, rest: Uncertainty
) -> None:
    """Store the flow capacity: the flow at which the outlet pressure has fallen by `DROOP`.

    `droop` is the fall of the outlet pressure [% FS], and `rest` the uncertainty of the outlet without flow. If the
    outlet falls less, the largest flow is stored as a lower bound.
    """
    noise = estimate_noise([part for part in np.array_split(droop, 40) if part.size > 8], 2)
    size = max(1, min(droop.size // 400, int((noise.spread / 0.1) ** 2))) if noise.sigma > 1e-6 else 1
    means = np.convolve(droop, np.full(size, 1.0 / size), "valid")
    fallen = np.flatnonzero(means >= DROOP)
    if not fallen.size:
        row["capacity_at_least"] = float(np.max(flow))
        return
    k = min(int(fallen[0]) + size // 2, droop.size - 1)
    if k == 0 or noise.sigma <= 1e-6:
        part = (DROOP - droop[k - 1]) / (droop[k] - droop[k - 1]) if k else 0.0
        value = float(flow[k - 1] + part * (flow[k] - flow[k - 1])) if k else float(flow[0])
        evaluation.set_value(row, "capacity", value, Uncertainty(0.0, 0.25 * abs(float(flow[k] - flow[max(k - 1, 0)]))))
        return
    # The window covers a change of the outlet by 1 to 2 %, without samples before the flow.
    slow = np.flatnonzero(means[: fallen[0]] < DROOP - AROUND)
    reach = max(8, k - (int(slow[-1]) + size // 2) if slow.size else k)
    window = slice(max(0, k - reach), min(droop.size, k + reach + 1))
    clock = time[window] - time[k]
    inverse = np.linalg.pinv(np.vander(clock, 3))
    bend, slope, level = (inverse @ (droop[window] - DROOP)).tolist()
    offset = -level / slope if slope > 0.0 else 0.0
    offset -= bend * offset * offset / slope if slope > 0.0 else 0.0
    flow_inverse = np.linalg.pinv(np.vander(clock, 2))
    rate, middle = (flow_inverse @ flow[window]).tolist()
    error = math.hypot(noise.of(inverse[2]), rest.standard) / max(slope, 1e-300)
    flow_error = estimate_noise([flow[window]]).of(flow_inverse[1])
    evaluation.set_value(row, "capacity", middle + rate * offset, Uncertainty(math.hypot(error * rate, flow_error)))


def _add_flow_values(evaluation: Evaluation, side: FlowDirection, sweeps: Sequence[FlowSweep]) -> None:
    """Add the pressure change at the rated flow, and the hysteresis, to the evaluation.

    By default, the rated flow is half of the largest flow that all sweeps reach.
    """
    rated = evaluation.rated_flow
    if sweeps:
        rated = rated if math.isfinite(rated) else 0.5 * min(float(sweep.grid[-1]) for sweep in sweeps)
        evaluation.conditions[f"flow_{side.name}"] = rated
    for sweep in sweeps:
        row, grid = sweep.row, sweep.grid
        if rated > grid[-1]:
            reached = float(grid[-1])
            evaluation.note("flow.below_rated", row["record"], way=side.direction, reached=reached, rated=rated)
            continue
        curve = sweep.going if sweep.coming is None else 0.5 * (sweep.going + sweep.coming)
        is_known = np.isfinite(curve)
        is_near = is_known & (np.abs(grid - rated) <= NEIGHBOURS * (grid[1] - grid[0]) * 1.001)
        sigma = error = sweep.sigma / math.sqrt(1.0 if sweep.coming is None else 2.0)
        if sigma <= 1e-6 or np.count_nonzero(is_near) < 4:
            outlet = float(np.interp(rated, grid[is_known], curve[is_known]))
        else:
            inverse = np.linalg.pinv(np.vander((grid[is_near] - rated) / grid[-1], 3))
            _, slope, outlet = (inverse @ curve[is_near]).tolist()
            # The default rated flow has the uncertainty of the largest flow.
            flow_error = 0.0 if math.isfinite(evaluation.rated_flow) else slope * TOP_ERROR
            lag = slope * sweep.lag if sweep.coming is None else 0.0
            error = math.hypot(sigma * float(np.linalg.norm(inverse[2])), flow_error, lag)
        evaluation.set_value(row, side.change, side.sign * (row["outlet"] - outlet), sweep.rest.plus_normal(error))
    case = ("setpoint",)
    evaluation.add_greatest(side.figure, side.change, f"little_{side.name}", conditions=case, flow=rated)
    key, reason = f"hysteresis_{side.name}", f"{side.name}_one_way"
    evaluation.add_greatest(side.hysteresis, key, reason, conditions=case, is_nonnegative=True)


FLOW = BenchTest(
    "flow", _evaluate,
    {
        "flow_droop": "% FS", "flow_hysteresis": "% FS", "flow_capacity": "kg/s",
        "relief_rise": "% FS", "relief_hysteresis": "% FS",
    },
    {"droop": DROOP}, trials=flow_trials, needs="flow", whole=("outlet", "flow"), smallest=("flow_capacity",),
)  # fmt: skip
