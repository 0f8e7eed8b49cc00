"""Tests of the evaluation of synthetic records, with the notes on their deficiencies."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.signal import lfilter

from poppet.bench.iso10094.bench_result import TESTS
from poppet.bench.iso10094.evaluation import Evaluation
from poppet.bench.iso10094.run_bench import run_bench, run_recordings
from poppet.bench.iso10094.scale import Record, Scale
from poppet.bench.iso10094.smoothing import smooth_response
from poppet.bench.iso10094.uncertainty import Noise, estimate_noise
from poppet.bench.iso10094.virtual_valve import VirtualValve
from poppet.core.codes import Note
from poppet.core.errors import InputError

SCALE = Scale(1e5, 7e5, "Pa", 1e5, 7e5)
NONE = np.zeros(0)


def record(test: str, time, setpoint, outlet, **series) -> Record:
    time, outlet = np.asarray(time, dtype=float), np.asarray(outlet, dtype=float)
    setpoint = np.broadcast_to(np.asarray(setpoint, dtype=float), time.shape)
    extra = {name: series.pop(name, NONE) for name in ("supply", "flow", "consumption")}
    return Record(
        series.pop("name", "r"), test, time, SCALE.setpoint(setpoint), SCALE.pressure(outlet), **extra, **series
    )


def evaluated(test: str, *records: Record, rated_flow: float = math.nan) -> Evaluation:
    return TESTS[test].evaluate_records(records, SCALE, rated_flow)


def note_of(evaluation: Evaluation, code: str, address: str | None = None) -> Note | None:
    """Return the first note with a code and, if given, an address."""
    return next((n for n in evaluation.notes if n.code == f"bench.{code}" and address in (None, n.address)), None)


# Characteristic ----------------------------------------------------------------------------------------------------


def test_staircase_is_evaluated_as_sweep():
    levels = np.concatenate([np.arange(0.0, 101.0, 5.0), np.arange(95.0, -1.0, -5.0)])
    setpoint = np.repeat(np.tile(levels, 2), 40)
    up = np.repeat(np.tile(np.arange(41) <= 20, 2), 40)
    outlet = setpoint + np.where(up, -0.5, 0.5) + np.random.default_rng(11).normal(0.0, 1e-3, setpoint.size)
    evaluation = evaluated("characteristic", record("characteristic", np.arange(setpoint.size) * 0.1, setpoint, outlet))
    assert evaluation.figures["hysteresis"].value == pytest.approx(1.0, abs=2e-3)
    assert evaluation.figures["repeatability"].value < 5e-3
    assert note_of(evaluation, "absent.no_stop", "sweep_lag")


def test_single_sweep_gives_neither_hysteresis_nor_repeatability():
    x = np.linspace(0.0, 100.0, 2000)
    evaluation = evaluated("characteristic", record("characteristic", np.arange(2000) * 0.05, x, x))
    assert set(evaluation.figures) & {"hysteresis", "linearity", "repeatability"} == set()
    assert note_of(evaluation, "absent.one_way", "hysteresis")
    assert note_of(evaluation, "absent.one_cycle", "repeatability")
    assert evaluation.figures["accuracy"].value == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("noise", [0.0, 0.2])
def test_zero_offset_with_noisy_setpoint(noise):
    """The noise of 20 mV on 10 V determines the turning points of the setpoint."""
    cycle = np.concatenate([np.full(200, 0.0), np.linspace(0.0, 100.0, 2000), np.linspace(100.0, 0.0, 2000)])
    x = np.tile(cycle, 2)
    evaluation = evaluated(
        "characteristic",
        record(
            "characteristic",
            0.02 * np.arange(x.size),
            x + np.random.default_rng(11).normal(0.0, noise, x.size),
            x + 0.3,
        ),
    )
    assert evaluation.figures["zero_offset"].value == pytest.approx(0.3, abs=0.05)
    assert not note_of(evaluation, "absent.no_zero")


def test_low_supply_is_reported():
    x = np.concatenate([np.linspace(0.0, 100.0, 2000), np.full(200, 100.0), np.linspace(100.0, 0.0, 2000)])
    evaluation = evaluated("characteristic", record("characteristic", np.arange(x.size) * 0.05, x, np.minimum(x, 82.0)))
    assert note_of(evaluation, "characteristic.short").facts["short"] == pytest.approx(18.0)


def test_leading_outlet_is_reported():
    x = np.concatenate([np.linspace(0.0, 100.0, 2000), np.linspace(100.0, 0.0, 2000)])
    y = x + np.repeat([0.5, -0.5], 2000)
    evaluation = evaluated("characteristic", record("characteristic", np.arange(4000) * 0.05, x, y))
    assert note_of(evaluation, "characteristic.leads")
    assert evaluation.figures["hysteresis"].value == pytest.approx(1.0)


def test_zero_suppression_of_jump():
    x = np.concatenate([np.full(100, 0.0), np.linspace(0.0, 100.0, 4000), np.linspace(100.0, 0.0, 4000)])
    evaluation = evaluated(
        "characteristic", record("characteristic", np.arange(x.size) * 0.05, x, np.where(x > 3.0, x, 0.0))
    )
    assert evaluation.figures["zero_suppression"].value == pytest.approx(3.0, abs=0.05)


# Steps -------------------------------------------------------------------------------------------------------------


def step_record(outlet, hold: float = 2.0, **series) -> Record:
    time = np.arange(0.0, 1.0 + hold, 0.001)
    setpoint = np.where(time < 1.0, 10.0, 60.0)
    return record("step", time, setpoint, 10.0 + 50.0 * outlet(np.maximum(time - 1.0, 0.0)), is_exact=True, **series)


def first_order(time: np.ndarray) -> np.ndarray:
    return 1.0 - np.exp(-time / 0.1)


def test_times_of_first_order_step():
    (row,) = evaluated("step", step_record(first_order)).rows
    truth = {"delay": math.log(1 / 0.9), "rise_time": math.log(9.0), "response_time": math.log(10.0)}
    truth |= {"settling_time": math.log(20.0)}
    assert {name: row[name] for name in truth} == pytest.approx({k: 0.1 * v for k, v in truth.items()}, rel=1e-3)
    assert (row["direction"], row["amplitude"], row["overshoot"]) == ("up", pytest.approx(50.0), 0.0)


def test_unsettled_step_has_no_times():
    evaluation = evaluated("step", step_record(lambda t: 1.0 - np.exp(-t / 1.0)))
    assert note_of(evaluation, "step.unsettled")
    assert set(evaluation.figures) == set()
    assert evaluation.rows[0]["is_settled"] is False
    assert note_of(evaluation, "absent.unsettled", "settling_time")


def test_limit_cycle_prevents_settling_time():
    evaluation = evaluated("step", step_record(lambda t: first_order(t) + 0.08 * np.sin(2.0 * np.pi * 11.0 * t)))
    assert note_of(evaluation, "step.swings").facts["amplitude"] == pytest.approx(4.0, rel=0.01)
    assert note_of(evaluation, "step.swings_out")
    assert evaluation.figures["hum_amplitude"].value == pytest.approx(4.0, rel=0.01)


def test_outlet_without_response_is_reported():
    evaluation = evaluated("step", step_record(lambda t: 0.05 * first_order(t)))
    assert note_of(evaluation, "step.hardly").facts["moved"] == pytest.approx(2.5)
    assert note_of(evaluation, "step.short").facts["outlet"] == pytest.approx(12.5)
    assert note_of(evaluation, "absent.no_step", "response_time_up")
    assert note_of(evaluated("step", record("step", np.arange(99.0), 50.0, 50.0 * np.ones(99))), "step.none")


def test_overshoot_below_the_noise_is_a_bound():
    noisy = step_record(lambda t: first_order(t) + np.random.default_rng(11).normal(0.0, 2e-3, t.size))
    evaluation = evaluated("step", noisy)
    assert evaluation.figures["overshoot"].bound == "at most"
    assert evaluation.figures["overshoot"].value == pytest.approx(1.15, rel=0.12)  # 1.06 ... 1.27 for 12 seeds


def test_noise_does_not_delay_the_settling_time():
    """The standard deviation of the noise is 2 % of the step, so many single samples leave the band of 5 %."""
    truth, figures = 0.1 * math.log(20.0), []
    for seed in range(12):
        noise = np.random.default_rng(seed).normal(0.0, 0.02, 3000)
        evaluation = evaluated("step", step_record(lambda t, noise=noise: first_order(t) + noise))
        figures.append(evaluation.figures["settling_time"])
    assert np.mean([figure.value for figure in figures]) == pytest.approx(truth, rel=0.02)
    assert sum(figure.interval[0] <= truth <= figure.interval[1] for figure in figures) >= 10


def test_correlated_noise_of_short_recordings():
    """A line through 60 samples removes part of the noise, whose correlation decays with 0.8 per sample."""
    white = np.random.default_rng(1).normal(0.0, 1.0, (800, 160))
    coloured = lfilter([1.0], [1.0, -0.8], white)[:, 100:]
    means = [estimate_noise(list(parts)).mean(60) for parts in coloured.reshape(200, 4, 60)]
    assert np.sqrt(np.mean(np.square(means))) == pytest.approx(np.std(coloured.mean(axis=1)), rel=0.2)


@pytest.mark.parametrize("noise", [1e-4, 1e-3, 5e-3])
def test_crossing_time_is_unbiased_by_noise(noise):
    time = np.arange(0.0, 1.0, 0.0005)
    errors = []
    for seed in range(40):
        part = first_order(time) + np.random.default_rng(seed).normal(0.0, noise, time.size)
        errors.append(
            smooth_response(time, part, Noise(np.array([noise**2]))).crossing(0.9, 0.0)[0] - 0.1 * math.log(10.0)
        )
    assert abs(np.mean(errors)) < 0.002
    assert np.std(errors) < 0.006


# Resolution, flow, supply, leakage ---------------------------------------------------------------------------------


def test_stairs_below_the_noise_are_reported():
    setpoint = np.repeat(50.0 + 0.05 * np.arange(30), 20)
    outlet = setpoint + np.random.default_rng(11).normal(0.0, 0.3, setpoint.size)
    evaluation = evaluated("resolution", record("resolution", np.arange(setpoint.size) * 0.1, setpoint, outlet))
    assert note_of(evaluation, "resolution.noise")
    assert note_of(
        evaluated("resolution", record("resolution", np.arange(90.0), 50.0, np.full(90, 50.0))),
        "resolution.no_staircase",
    )


def test_missing_flow_and_missing_return_are_reported():
    time = np.arange(0.0, 60.0, 0.05)
    assert note_of(evaluated("flow", record("flow", time, 50.0, np.full(time.size, 50.0))), "unrecorded.flow")
    flow = np.interp(time, [0.0, 5.0, 60.0], [0.0, 0.0, 0.02])
    evaluation = evaluated("flow", record("flow", time, 50.0, 50.0 - 500.0 * flow, flow=flow))
    assert note_of(evaluation, "flow.no_return")
    assert evaluation.figures["flow_droop"].value == pytest.approx(5.0, rel=1e-3)
    assert evaluation.figures["flow_capacity"].value == pytest.approx(0.02, rel=1e-2)
    rated_evaluation = evaluated("flow", record("flow", time, 50.0, 50.0 - 500.0 * flow, flow=flow), rated_flow=0.5)
    assert note_of(rated_evaluation, "flow.below_rated").facts["rated"] == 0.5
    assert "flow_droop" not in rated_evaluation.figures


def test_flow_limit_does_not_count_as_hysteresis():
    """At the flow limit, the outlet falls and rises again at almost constant flow."""
    time = np.arange(0.0, 130.0, 0.05)
    opening = np.interp(time, [0.0, 5.0, 65.0, 125.0, 130.0], [0.0, 0.0, 1.4, 0.0, 0.0])
    outlet = np.where(opening < 1.0, 50.0 - opening, 49.0 - 60.0 * (opening - 1.0))
    flow = 0.01 * np.where(opening < 1.0, opening, 1.0 - 0.1 * (opening - 1.0))
    evaluation = evaluated("flow", record("flow", time, 50.0, outlet, flow=flow))
    assert evaluation.figures["flow_hysteresis"].value < 0.05
    assert evaluation.figures["flow_capacity"].value == pytest.approx(0.01, rel=0.02)


def test_constant_supply_and_noise_are_reported():
    time = np.arange(0.0, 100.0, 0.05)
    supply = np.interp(time, [0.0, 50.0, 100.0], [6e5, 9e5, 6e5])
    assert note_of(evaluated("supply", record("supply", time, 50.0, np.full(time.size, 50.0))), "unrecorded.supply")
    still = record("supply", time, 50.0, np.full(time.size, 50.0), supply=np.full(time.size, 9e5))
    assert note_of(evaluated("supply", still), "supply.still").facts["extent"] == 0.0
    noisy = record("supply", time, 50.0, 50.0 + np.random.default_rng(11).normal(0.0, 0.05, time.size), supply=supply)
    evaluation = evaluated("supply", noisy)
    assert evaluation.figures["supply_sensitivity"].bound == "at most"
    assert note_of(evaluation, "below_noise", "supply_sensitivity")


def test_supply_near_outlet_pressure_is_not_evaluated():
    time = np.arange(0.0, 100.0, 0.05)
    supply = np.interp(time, [0.0, 50.0, 100.0], [3e5, 9e5, 3e5])
    outlet = np.minimum(50.0, SCALE.percent(supply))
    (row,) = evaluated("supply", record("supply", time, 50.0, outlet, supply=supply)).rows
    assert row["sensitivity"] == pytest.approx(0.0, abs=1e-6)
    assert row["lowest_supply"] == pytest.approx(4.6e5, rel=0.01)


def test_drifting_leakage_is_reported():
    time = np.arange(0.0, 100.0, 0.1)
    drifting = record("leakage", time, 50.0, np.full(1000, 50.0), consumption=1e-5 * np.exp(-time / 50.0))
    evaluation = evaluated("leakage", drifting)
    assert note_of(evaluation, "leakage.drifts")
    none = evaluated("leakage", record("leakage", time, 50.0, np.full(1000, 50.0), consumption=np.zeros(1000)))
    assert (none.figures["leakage"].value, none.figures["leakage"].bound) == (0.0, "")
    assert note_of(evaluated("leakage", record("leakage", time, 50.0, np.full(1000, 50.0))), "unrecorded.consumption")


# All of them -------------------------------------------------------------------------------------------------------


def test_each_absent_value_has_a_reason():
    """Each characteristic value is present, or a note states the reason of its absence."""
    flat = record("", np.arange(200.0), 50.0, np.full(200, 50.0))
    for name, test in TESTS.items():
        evaluation = evaluated(name, flat)
        explained = {note.address for note in evaluation.notes if note.code.startswith("bench.absent.")}
        assert {*evaluation.figures} | explained | {"hum_amplitude", "hum_frequency"} >= {*test.units}
        assert all(math.isfinite(figure.value) for figure in evaluation.figures.values())


def test_unknown_test_is_rejected_and_missing_recording_is_reported():
    with pytest.raises(InputError) as caught:
        run_bench(VirtualValve(), tests=("frequancy",))
    assert (caught.value.code, caught.value.facts["suggestion"].names) == ("fields.not_an_option", ["frequency"])
    result = run_recordings("t", {}, SCALE, tests=("step",))
    assert result.figures == {}
    assert result.notes["bench"] == (Note("bench.not_given", "step"),)


@pytest.mark.parametrize(
    ("ends", "address"), [((1.0, 1.0, "V", 1e5, 7e5), "setpoint_range"), ((0.0, 1.0, "V", 7e5, 1e5), "full_scale")]
)
def test_falling_scale_is_rejected(ends, address):
    with pytest.raises(InputError) as caught:
        Scale(*ends)
    assert (caught.value.code, caught.value.address) == ("bench.range.scale", address)
