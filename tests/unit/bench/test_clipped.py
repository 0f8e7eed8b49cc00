"""What a sensor or converter cut off is found, with noise and without, and no figure rests on it unsaid."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from poppet.bench.iso10094.bench_result import TESTS
from poppet.bench.iso10094.characteristic import characteristic_trial
from poppet.bench.iso10094.evaluation import Evaluation, Trial
from poppet.bench.iso10094.flow import flow_trial
from poppet.bench.iso10094.frequency import frequency_trial
from poppet.bench.iso10094.resolution import resolution_trial
from poppet.bench.iso10094.scale import Record, Scale
from poppet.bench.iso10094.valve_recordings import clipped
from poppet.bench.iso10094.virtual_valve import StandIn
from poppet.signals import Points, Steps

VOLTS = Scale(0.0, 10.0, "V", 1e5, 7e5)
VALVE = StandIn(scale=VOLTS, time_constant=0.08, dead_time=0.016, play=1.2, droop=20.0, full_flow=0.01)
NOISES = (0.0, 200.0, 3000.0)
STEPS = Trial("step", "steps", Steps([0.0, 0.5123, 1.5123], [1.0, 9.0, 1.0]), 2.5, 0.3, 1e-3, 1e-3)
TRIANGLE = Trial("characteristic", "t", Points(20.0 * np.arange(5.0) + 2.0, [0, 10, 0, 10, 0]), 84.0, 0.0, 0.025, 1e-3)
HELD = characteristic_trial(VOLTS, 1e-3, 20.0, 2.0)
DRAWN = flow_trial(VOLTS, 1e-3, 50.0, 30.0, 2.0, 1.0)
SINES = [frequency_trial(VOLTS, 1e-3, f, 0.6, mean=50.0, amplitude=5.0) for f in (0.5, 1.0, 2.0, 5.0)]
STAIRS = resolution_trial(VOLTS, 1e-3, 0.1, 1.0, 50.0)
RESPONSES: dict[str, Record] = {}
CUT = {"bench.absent.clipped", "bench.absent.clipped_stop"}


def written(trial: Trial, noise: float, series: str = "", low: float = -np.inf, high: float = np.inf) -> Record:
    """As a recording has it: noise, rounded, and one series between limits."""
    record = RESPONSES.get(trial.name) or VALVE.respond(trial)
    RESPONSES[trial.name] = record
    random = np.random.default_rng(3)
    outlet = np.round((record.outlet + random.normal(0.0, noise, record.time.size)) / 15.0) * 15.0
    values = {"outlet": outlet, "setpoint": np.round(record.setpoint / 1e-3) * 1e-3, "flow": record.flow}
    if series:
        values[series] = np.clip(values[series], low, high)
    found = replace(record, is_exact=False, **values)
    x, y = VOLTS.percents(found)
    return replace(found, clipped=clipped({"setpoint": x, "outlet": y, "flow": found.flow}))


def evaluated(*records: Record) -> tuple[Evaluation, set[str]]:
    """What the records of a test show, and the figures that are absent because of clipped samples."""
    found = TESTS[records[0].test].evaluated(records, VOLTS)
    assert all(map(str, found.notes))
    return found, {note.address for note in found.notes if note.code in CUT}


@pytest.mark.parametrize("noise", NOISES)
def test_what_is_whole_is_not_suspected(noise):
    for trial in (STEPS, TRIANGLE, HELD, DRAWN, STAIRS, *SINES):
        assert written(trial, noise).clipped == {}, trial.name


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize("ends", [(-np.inf, 5.5e5), (2e5, np.inf)])
def test_no_step_is_judged_whose_rest_is_clipped(noise, ends):
    found, absent = evaluated(written(STEPS, noise, "outlet", *ends))
    assert found.figures == {}
    assert absent == {*TESTS["step"].units}


def test_other_steps_bound_what_is_the_largest():
    small = Trial("step", "small", Steps([0.0, 0.5123, 1.5123], [1.0, 5.0, 1.0]), 2.5, 0.3, 1e-3, 1e-3)
    found, absent = evaluated(written(STEPS, 200.0, "outlet", high=5.5e5), written(small, 200.0))
    assert {"delay", "rise_time_up", "response_time_down"} <= absent
    assert found.figures["settling_time"].bound == "at least"


def test_a_clipped_peak_leaves_the_times():
    time = np.arange(0.0, 3.0, 1e-3)
    y = 10.0 + 60.0 * np.where(time < 1.0, 0.0, 1.0 - np.exp(-8.0 * (time - 1.0)) * np.cos(20.0 * (time - 1.0)))
    x, y = np.where(time < 1.0, 1.0, 7.0), np.minimum(y, 80.0)
    cut = clipped({"setpoint": 10.0 * x, "outlet": y})
    record = Record("r", "step", time, x, VOLTS.pressure(y), *[np.zeros(0)] * 3, is_exact=True, clipped=cut)
    found, _ = evaluated(record)
    assert (found.figures["overshoot"].bound, found.figures["overshoot"].value) == (
        "at least",
        pytest.approx(16.7, abs=0.1),
    )
    assert found.figures["delay"].bound == ""


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize("trial", [TRIANGLE, HELD])
@pytest.mark.parametrize(("series", "high"), [("outlet", 5.5e5), ("setpoint", 8.0)])
def test_no_characteristic_is_judged_that_is_clipped(noise, trial, series, high):
    found, absent = evaluated(written(trial, noise, series, high=high))
    assert absent == {"linearity", "hysteresis", "repeatability", "accuracy", "sweep_lag"}
    assert set(found.figures) == {"zero_suppression", "zero_offset"}


@pytest.mark.parametrize(("series", "high"), [("outlet", 6.8e5), ("setpoint", 9.6)])
def test_a_clipped_end_shows_no_lag(series, high):
    found, absent = evaluated(written(HELD, 0.0, series, high=high))
    assert absent == {"sweep_lag"}
    assert found.figures["hysteresis"].value > 1.2  # with the lag in it


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize(("series", "ends"), [("flow", (0.0, 0.008)), ("outlet", (3.2e5, np.inf))])
def test_no_flow_is_judged_that_is_clipped(noise, series, ends):
    found, absent = evaluated(written(DRAWN, noise, series, *ends))
    assert found.figures == {}
    assert absent == {*TESTS["flow"].units}


def test_flow_at_other_setpoints_bounds():
    other = written(flow_trial(VOLTS, 1e-3, 75.0, 30.0, 2.0, 1.0), 200.0)
    found, _ = evaluated(written(DRAWN, 200.0, "flow", 0.0, 0.008), other)
    assert {name: figure.bound for name, figure in found.figures.items()} == {
        "flow_droop": "at least", "flow_capacity": "at most"
    }  # fmt: skip


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize(("series", "high"), [("outlet", 4.2e5), ("setpoint", 5.3)])
def test_no_sine_is_judged_that_is_clipped(noise, series, high):
    found, absent = evaluated(*(written(trial, noise, series, high=high) for trial in SINES))
    assert {"bandwidth_gain", "bandwidth_phase"} <= absent
    assert {figure.bound for figure in found.figures.values()} <= {"at least"}


def test_no_staircase_is_judged_that_is_clipped():
    found, absent = evaluated(written(STAIRS, 200.0, "outlet", high=4.15e5))
    assert found.figures == {}
    assert absent == {"resolution", "reversal_threshold"}
