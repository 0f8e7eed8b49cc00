"""Tests of clipped samples: they are detected with and without noise, and affected values are omitted or bounds."""

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
from poppet.bench.iso10094.valve_recordings import find_clipped_samples
from poppet.bench.iso10094.virtual_valve import VirtualValve
from poppet.signals import Points, Steps

VOLTS = Scale(0.0, 10.0, "V", 1e5, 7e5)
VALVE = VirtualValve(scale=VOLTS, time_constant=0.08, dead_time=0.016, play=1.2, droop=20.0, full_flow=0.01)
NOISES = (0.0, 200.0, 3000.0)
STEPS = Trial("step", "steps", Steps([0.0, 0.5123, 1.5123], [1.0, 9.0, 1.0]), 2.5, 0.3, 1e-3, 1e-3)
TRIANGLE = Trial("characteristic", "t", Points(20.0 * np.arange(5.0) + 2.0, [0, 10, 0, 10, 0]), 84.0, 0.0, 0.025, 1e-3)
HELD = characteristic_trial(VOLTS, 1e-3, 20.0, 2.0)
DRAWN = flow_trial(VOLTS, 1e-3, 50.0, 30.0, 2.0, 1.0)
SINES = [frequency_trial(VOLTS, 1e-3, f, 0.6, mean=50.0, amplitude=5.0) for f in (0.5, 1.0, 2.0, 5.0)]
STAIRS = resolution_trial(VOLTS, 1e-3, 0.1, 1.0, 50.0)
RESPONSES: dict[str, Record] = {}
CUT = {"bench.absent.clipped", "bench.absent.clipped_stop"}


def recorded(trial: Trial, noise: float, series: str = "", low: float = -np.inf, high: float = np.inf) -> Record:
    """Return the response to a trial with noise, rounding, and one series limited to a range."""
    record = RESPONSES.get(trial.name) or VALVE.respond(trial)
    RESPONSES[trial.name] = record
    random = np.random.default_rng(3)
    outlet = np.round((record.outlet + random.normal(0.0, noise, record.time.size)) / 15.0) * 15.0
    values = {"outlet": outlet, "setpoint": np.round(record.setpoint / 1e-3) * 1e-3, "flow": record.flow}
    if series:
        values[series] = np.clip(values[series], low, high)
    evaluation = replace(record, is_exact=False, **values)
    x, y = VOLTS.percents(evaluation)
    return replace(evaluation, clipped=find_clipped_samples({"setpoint": x, "outlet": y, "flow": evaluation.flow}))


def evaluated(*records: Record) -> tuple[Evaluation, set[str]]:
    """Return the evaluation of records, and the values that are absent because of clipped samples."""
    evaluation = TESTS[records[0].test].evaluate_records(records, VOLTS)
    assert all(map(str, evaluation.notes))
    return evaluation, {note.address for note in evaluation.notes if note.code in CUT}


@pytest.mark.parametrize("noise", NOISES)
def test_complete_records_are_not_reported_as_clipped(noise):
    for trial in (STEPS, TRIANGLE, HELD, DRAWN, STAIRS, *SINES):
        assert recorded(trial, noise).clipped == {}, trial.name


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize("ends", [(-np.inf, 5.5e5), (2e5, np.inf)])
def test_step_with_clipped_steady_state_is_not_evaluated(noise, ends):
    evaluation, absent = evaluated(recorded(STEPS, noise, "outlet", *ends))
    assert evaluation.figures == {}
    assert absent == {*TESTS["step"].units}


def test_clipped_step_turns_largest_values_into_bounds():
    small = Trial("step", "small", Steps([0.0, 0.5123, 1.5123], [1.0, 5.0, 1.0]), 2.5, 0.3, 1e-3, 1e-3)
    evaluation, absent = evaluated(recorded(STEPS, 200.0, "outlet", high=5.5e5), recorded(small, 200.0))
    assert {"delay", "rise_time_up", "response_time_down"} <= absent
    assert evaluation.figures["settling_time"].bound == "at least"


def test_clipped_peak_bounds_the_overshoot_only():
    time = np.arange(0.0, 3.0, 1e-3)
    y = 10.0 + 60.0 * np.where(time < 1.0, 0.0, 1.0 - np.exp(-8.0 * (time - 1.0)) * np.cos(20.0 * (time - 1.0)))
    x, y = np.where(time < 1.0, 1.0, 7.0), np.minimum(y, 80.0)
    cut = find_clipped_samples({"setpoint": 10.0 * x, "outlet": y})
    record = Record("r", "step", time, x, VOLTS.pressure(y), *[np.zeros(0)] * 3, is_exact=True, clipped=cut)
    evaluation, _ = evaluated(record)
    assert (evaluation.figures["overshoot"].bound, evaluation.figures["overshoot"].value) == (
        "at least",
        pytest.approx(16.7, abs=0.1),
    )
    assert evaluation.figures["delay"].bound == ""


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize("trial", [TRIANGLE, HELD])
@pytest.mark.parametrize(("series", "high"), [("outlet", 5.5e5), ("setpoint", 8.0)])
def test_clipped_characteristic_is_not_evaluated(noise, trial, series, high):
    evaluation, absent = evaluated(recorded(trial, noise, series, high=high))
    assert absent == {"linearity", "hysteresis", "repeatability", "accuracy", "sweep_lag"}
    assert set(evaluation.figures) == {"zero_suppression", "zero_offset"}


@pytest.mark.parametrize(("series", "high"), [("outlet", 6.8e5), ("setpoint", 9.6)])
def test_clipped_end_of_sweep_excludes_the_lag(series, high):
    evaluation, absent = evaluated(recorded(HELD, 0.0, series, high=high))
    assert absent == {"sweep_lag"}
    assert evaluation.figures["hysteresis"].value > 1.2  # with the lag in it


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize(("series", "ends"), [("flow", (0.0, 0.008)), ("outlet", (3.2e5, np.inf))])
def test_clipped_flow_record_is_not_evaluated(noise, series, ends):
    evaluation, absent = evaluated(recorded(DRAWN, noise, series, *ends))
    assert evaluation.figures == {}
    assert absent == {*TESTS["flow"].units}


def test_other_setpoints_bound_clipped_flow_values():
    clipped_flow = recorded(flow_trial(VOLTS, 1e-3, 75.0, 30.0, 2.0, 1.0), 200.0)
    evaluation, _ = evaluated(recorded(DRAWN, 200.0, "flow", 0.0, 0.008), clipped_flow)
    assert {name: figure.bound for name, figure in evaluation.figures.items()} == {
        "flow_droop": "at least", "flow_capacity": "at most"
    }  # fmt: skip


@pytest.mark.parametrize("noise", NOISES)
@pytest.mark.parametrize(("series", "high"), [("outlet", 4.2e5), ("setpoint", 5.3)])
def test_clipped_sines_are_not_evaluated(noise, series, high):
    evaluation, absent = evaluated(*(recorded(trial, noise, series, high=high) for trial in SINES))
    assert {"bandwidth_gain", "bandwidth_phase"} <= absent
    assert {figure.bound for figure in evaluation.figures.values()} <= {"at least"}


def test_clipped_staircase_is_not_evaluated():
    evaluation, absent = evaluated(recorded(STAIRS, 200.0, "outlet", high=4.15e5))
    assert evaluation.figures == {}
    assert absent == {"resolution", "reversal_threshold"}
