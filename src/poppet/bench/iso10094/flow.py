"""Outlet pressure against flow: droop and relief, there and back."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from poppet.bench.iso10094.bench_settings import ROWS, Pace, Trial, held
from poppet.bench.iso10094.evaluation import AT_LEAST, BenchTest, Curve, Evaluation, Row
from poppet.bench.iso10094.scale import FloatArray, Mask, Record, Scale
from poppet.bench.iso10094.shapes import at_places, branches
from poppet.bench.iso10094.sweep import Lag, caught_up, lags_of
from poppet.bench.iso10094.uncertainty import Uncertainty, greatest, noise_about, roughness, smooth, unbiased
from poppet.timeseries.measurements.noise import noise_of
from poppet.timeseries.signals import Points

DROOP = 10.0
"""Fall of the outlet at which the capacity is read [% FS]."""
PLACES = 81
TURN = 0.15
"""Part of the largest flow by which the flow must turn to end a branch."""
FOLD = 0.99
"""Part of the largest flow beyond which a valve may be at its limit."""
FALLEN = 2.0
"""Distance below all that was seen on the way to the largest flow at which a valve is at its limit [% FS]."""
STILL = 0.01
"""Part of the largest flow at which a sweep begins."""
NONE = 1e-3
"""Part of the largest flow that is none."""
TOP, TOP_ERROR = 400, 5e-4
"""Samples over which the largest flow is averaged, and how well it is known then, as a part of itself."""
NEIGHBOURS, FEWEST, AROUND = 5, 10, 2.0
"""Places of the grid to either side that tell the outlet at a flow, fewest places that make a curve, and the change of
the outlet around its capacity that is looked at [% FS]."""
LEAST_FLOW = 1e-9
"""Flows below this are none [kg/s]."""


def flow_trial(scale: Scale, volume: float, setpoint: float, sweep: float, hold: float, load: float) -> Trial:
    """A sweep of the load to one end and back at a constant setpoint."""
    times = np.cumsum([0.0, 2.0 * hold, sweep, hold, sweep, hold])
    signal = Points(times, np.array([0.0, 0.0, load, load, 0.0, 0.0]))
    name = f"flow {'out' if load > 0 else 'in'} at {setpoint:g} % FS"
    duration = float(times[-1])
    return Trial("flow", name, held(scale, setpoint), duration, hold, sweep / ROWS, volume, load=signal)


def _trials(pace: Pace) -> list[Trial]:
    scale, sweep = pace.specimen.scale, 0.5 * pace.sweep()
    cases = ((load, setpoint) for load in (1.0, -1.0) for setpoint in pace.settings.setpoints)
    return [flow_trial(scale, pace.volume, setpoint, sweep, pace.hold, load) for load, setpoint in cases]


class Side(NamedTuple):
    """One direction of the flow: its name in rows, its sign, and the figures read from it."""

    name: str
    sign: float
    change: str
    figure: str
    hysteresis: str


SIDES = (
    Side("drawn", 1.0, "droop", "flow_droop", "flow_hysteresis"),
    Side("fed", -1.0, "rise", "relief_rise", "relief_hysteresis"),
)


class FlowSweep(NamedTuple):
    """The outlet [% FS] of one case on an even grid of flow [kg/s], to the largest flow and back."""

    row: Row
    grid: FloatArray
    going: FloatArray
    coming: FloatArray | None
    sigma: float  # one standard deviation of a single value by noise [% FS]
    rest: Uncertainty  # of the outlet without flow [% FS]
    judged: Mask | None  # where there and back are compared
    lag: float  # standard uncertainty of the lag that was taken out, as a part of the largest flow


def _evaluate(found: Evaluation, records: Sequence[Record]) -> None:
    swept: dict[Side, list[FlowSweep]] = {side: [] for side in SIDES}
    for record in records:
        x, y = found.scale.percents(record)
        still = np.abs(record.flow) <= max(NONE * float(np.max(np.abs(record.flow))), 5.0 * noise_of(record.flow))
        outlet, doubt = _at_rest(y, still)
        row: Row = {"record": record.name, "setpoint": float(np.median(x)), "outlet": outlet}
        found.rows.append(row)
        for side in SIDES:
            one = _one(found, record, y, row, side, doubt)
            swept[side] += [one] if one else []
    for side in SIDES:
        _read(found, side, swept[side])
    _capacity(found)


def _at_rest(y: FloatArray, still: Mask) -> tuple[float, Uncertainty]:
    """The outlet without flow, at the end of the hold before the flow begins."""
    moving = np.flatnonzero(~still)
    before = y[: moving[0]] if moving.size and moving[0] > 3 else y[still][:10]
    part = before[-max(3, before.size // 3) :]
    return (float(np.mean(part)) if part.size else math.nan), Uncertainty(noise_about([part]).mean(part.size))


def _one(found: Evaluation, record: Record, y: FloatArray, row: Row, side: Side, rest: Uncertainty) -> FlowSweep | None:
    """One direction of the flow in a record."""
    flow = side.sign * record.flow
    # The largest of many noisy samples is larger than the flow ever was.
    width = max(1, min(TOP, flow.size // 100)) if noise_of(flow) > 1e-6 * float(np.ptp(flow)) else 1
    top = float(np.max(np.convolve(flow, np.full(width, 1.0 / width), "valid")))
    other = float(np.max(-flow))
    if top < max(LEAST_FLOW, 0.02 * other):
        return None
    row[f"largest_{side.name}"] = top
    inside = np.where(flow > 0.0, flow, 0.0) if width == 1 else flow
    lags = lags_of(record.time, inside, y, branches(inside, TURN * top))
    late = caught_up(record.time, inside, lags)
    grid = np.linspace(0.0, top, PLACES)
    going, coming = _there_and_back(inside, late, y, grid)
    if going is None:
        found.note("flow.no_rise", record.name, way=side.name)
        return None
    # Where a valve is at its limit the outlet falls at hardly less flow: no hysteresis of its regulation.
    fallen = flow[(side.sign * y < np.nanmin(side.sign * going) - FALLEN) & (flow > 0.5 * top)]
    limit = min(top, float(np.min(fallen, initial=top)))
    case = f"{row['setpoint']:.0f} % FS"
    for way, curve, end in (("going", going, top), ("coming", coming, limit)):
        if curve is not None:
            known = np.isfinite(curve) & (grid <= end)
            found.curves.append(Curve(f"{side.name} {way}", case, side.sign * grid[known], curve[known]))
    if side.sign > 0.0:
        _falls(found, row, record.time, late, row["outlet"] - y, rest)
        if "capacity" in row:
            doubt = found.doubts[id(row), "capacity"]
            found.know(row, "capacity", row["capacity"], doubt.wider(_lag_error(lags)))
    both = [curve for curve in (going, coming) if curve is not None]
    sigma = roughness(np.array(both), 1)
    lag = _lag_error(lags) / top
    if coming is None:
        found.note("flow.no_return", record.name, way=side.name)
        return FlowSweep(row, grid, going, None, sigma, rest, None, lag)
    judged = (grid > 0.1 * limit) & (grid < 0.9 * limit) & np.isfinite(going) & np.isfinite(coming)
    if np.count_nonzero(judged) > FEWEST:
        gap = smooth(grid[judged], (going - coming)[judged], math.sqrt(2.0) * sigma)
        value, doubt = unbiased([gap], lambda draws: np.max(np.abs(draws[0]), axis=1))
        upper = judged & (grid > 0.5 * limit)  # where it is steeper, as a rule
        slope = abs(float(np.polyfit(grid[upper] / top, going[upper], 1)[0]))
        found.know(row, f"hysteresis_{side.name}", value, doubt.wider(2.0 * lag * slope))
    return FlowSweep(row, grid, going, coming, sigma, rest, judged, lag)


def _lag_error(lags: Sequence[Lag]) -> float:
    """Standard uncertainty of the flow to which the outlet belongs, by that of the lag."""
    errors = [lag.error * lag.rate for lag in lags]
    return float(np.linalg.norm(errors)) / len(errors) if errors else 0.0


def _there_and_back(
    flow: FloatArray, late: FloatArray, y: FloatArray, grid: FloatArray
) -> tuple[FloatArray | None, FloatArray | None]:
    """The outlet on the grid, on the way to the largest flow and back."""
    top = grid[-1]
    near = np.flatnonzero(flow >= FOLD * top)
    still = np.flatnonzero(flow <= STILL * top)
    before, after = still[still < near[0]], still[still > near[-1]]
    # Between first and last arrival at the top a valve at its limit lets the outlet fall at hardly less flow.
    ways = (
        slice(int(before[-1]) + 1, int(near[0]) + 1) if before.size else None,
        slice(int(near[-1]), int(after[0])) if after.size else None,
    )
    half = 0.5 * top / (PLACES - 1)
    going, coming = (None if way is None else at_places(late[way], y[way], grid, half)[0] for way in ways)
    return going, coming


def _falls(
    found: Evaluation, row: Row, time: FloatArray, flow: FloatArray, droop: FloatArray, rest: Uncertainty
) -> None:
    """The flow when the outlet has first fallen by so much: where straight lines through flow and outlet meet it."""
    noise = noise_about([part for part in np.array_split(droop, 40) if part.size > 8], 2)
    size = max(1, min(droop.size // 400, int((noise.spread / 0.1) ** 2))) if noise.sigma > 1e-6 else 1
    means = np.convolve(droop, np.full(size, 1.0 / size), "valid")
    beyond = np.flatnonzero(means >= DROOP)
    if not beyond.size:
        row["capacity_at_least"] = float(np.max(flow))
        return
    k = min(int(beyond[0]) + size // 2, droop.size - 1)
    if k == 0 or noise.sigma <= 1e-6:
        part = (DROOP - droop[k - 1]) / (droop[k] - droop[k - 1]) if k else 0.0
        value = float(flow[k - 1] + part * (flow[k] - flow[k - 1])) if k else float(flow[0])
        found.know(row, "capacity", value, Uncertainty(0.0, 0.25 * abs(float(flow[k] - flow[max(k - 1, 0)]))))
        return
    # As far to either side as the outlet moves by one or two per cent, without what is before the flow began.
    slow = np.flatnonzero(means[: beyond[0]] < DROOP - AROUND)
    reach = max(8, k - (int(slow[-1]) + size // 2) if slow.size else k)
    near = slice(max(0, k - reach), min(droop.size, k + reach + 1))
    clock = time[near] - time[k]
    solved = np.linalg.pinv(np.vander(clock, 3))
    bend, slope, level = (solved @ (droop[near] - DROOP)).tolist()
    at = -level / slope if slope > 0.0 else 0.0
    at -= bend * at * at / slope if slope > 0.0 else 0.0
    own = np.linalg.pinv(np.vander(clock, 2))
    rate, middle = (own @ flow[near]).tolist()
    error = math.hypot(noise.of(solved[2]), rest.standard) / max(slope, 1e-300)
    its = noise_about([flow[near]]).of(own[1])
    found.know(row, "capacity", middle + rate * at, Uncertainty(math.hypot(error * rate, its)))


def _read(found: Evaluation, side: Side, swept: Sequence[FlowSweep]) -> None:
    """Droop or rise at the rated flow, and the hysteresis."""
    rated = found.rated_flow
    if swept:
        rated = rated if math.isfinite(rated) else 0.5 * min(float(each.grid[-1]) for each in swept)
        found.conditions[f"flow_{side.name}"] = rated
    for each in swept:
        row, grid = each.row, each.grid
        if rated <= grid[-1]:
            curve = each.going if each.coming is None else 0.5 * (each.going + each.coming)
            found.know(row, side.change, *_change(side, each, curve, rated, is_given=math.isfinite(found.rated_flow)))
        else:
            reached = float(grid[-1])
            found.note("flow.below_rated", row["record"], way=side.name, reached=reached, rated=rated)
    for key, figure, reason in (
        (side.change, side.figure, f"little_{side.name}"),
        (f"hysteresis_{side.name}", side.hysteresis, f"{side.name}_one_way"),
    ):
        rows = [row for row in found.rows if key in row]
        if not rows:
            found.absent(reason, figure)
            continue
        value, doubt, k = greatest(*found.known(rows, key))
        case = {"setpoint": rows[k]["setpoint"]} | ({"flow": rated} if key == side.change else {})
        if key == side.change:
            found.add(figure, value, doubt, **case)
        else:
            found.add_judged(figure, value, doubt, **case)


def _change(
    side: Side, swept: FlowSweep, curve: FloatArray, rated: float, *, is_given: bool
) -> tuple[float, Uncertainty]:
    """By how much the outlet falls or rises at the rated flow."""
    grid, known = swept.grid, np.isfinite(curve)
    near = known & (np.abs(grid - rated) <= NEIGHBOURS * (grid[1] - grid[0]) * 1.001)
    sigma = swept.sigma / math.sqrt(1.0 if swept.coming is None else 2.0)
    if sigma <= 1e-6 or np.count_nonzero(near) < 4:
        value = float(np.interp(rated, grid[known], curve[known]))
        return side.sign * (swept.row["outlet"] - value), swept.rest.wider(sigma)
    solved = np.linalg.pinv(np.vander((grid[near] - rated) / grid[-1], 3))
    _, slope, value = (solved @ curve[near]).tolist()
    error = sigma * float(np.linalg.norm(solved[2]))
    # Half of the largest flow is known as well as that is.
    aside = 0.0 if is_given else slope * TOP_ERROR
    lag = slope * swept.lag if swept.coming is None else 0.0
    doubt = swept.rest.wider(math.hypot(error, aside, lag))
    return side.sign * (swept.row["outlet"] - value), doubt


def _capacity(found: Evaluation) -> None:
    """The smallest flow at which the outlet has fallen; where it never does, the smallest that was tried is a bound."""
    for key, bound in (("capacity", ""), ("capacity_at_least", AT_LEAST)):
        known = [row for row in found.rows if key in row]
        if known:
            row = min(known, key=lambda each: float(each[key]))
            found.add(
                "flow_capacity", row[key], found.doubts.get((id(row), key)), bound=bound, setpoint=row["setpoint"]
            )
            return
    found.absent("none_drawn", "flow_capacity")


FLOW = BenchTest(
    "flow",
    _evaluate,
    {
        "flow_droop": "% FS", "flow_hysteresis": "% FS", "flow_capacity": "kg/s",
        "relief_rise": "% FS", "relief_hysteresis": "% FS",
    },
    {"droop": DROOP},
    trials=_trials,
    needs="flow",
    whole=("outlet", "flow"),
    smallest=("flow_capacity",),
)  # fmt: skip
