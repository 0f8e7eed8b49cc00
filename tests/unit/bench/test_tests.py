"""Evaluation of single tests on records made by hand: what is odd in them is said, not hidden."""

from __future__ import annotations

import math

import numpy as np
import pytest

from poppet.bench.iso10094.characteristic import evaluate_characteristic
from poppet.bench.iso10094.evaluation import Evaluation
from poppet.bench.iso10094.flow import evaluate_flow
from poppet.bench.iso10094.resolution import evaluate_resolution
from poppet.bench.iso10094.run import evaluated, run_bench, run_recordings
from poppet.bench.iso10094.scale import Record, Scale
from poppet.bench.iso10094.stand_in import StandIn
from poppet.bench.iso10094.step import crossing, evaluate_step
from poppet.bench.iso10094.supply import evaluate_leakage, evaluate_supply
from poppet.ground.errors import InputError

SCALE = Scale(1e5, 7e5, "Pa", 1e5, 7e5)
NONE = np.zeros(0)
RANDOM = np.random.default_rng(11)


def record(test: str, time, setpoint, outlet, **series) -> Record:
    time, outlet = np.asarray(time, dtype=float), np.asarray(outlet, dtype=float)
    setpoint = np.broadcast_to(np.asarray(setpoint, dtype=float), time.shape)
    extra = {name: series.pop(name, NONE) for name in ("supply", "flow", "consumption")}
    return Record(
        series.pop("name", "r"), test, time, SCALE.setpoint(setpoint), SCALE.pressure(outlet), **extra, **series
    )


def said(evaluation: Evaluation, text: str) -> bool:
    return any(text in note for note in evaluation.notes)


# Characteristic ----------------------------------------------------------------------------------------------------


def test_a_staircase_serves_as_a_sweep():
    levels = np.concatenate([np.arange(0.0, 101.0, 5.0), np.arange(95.0, -1.0, -5.0)])
    setpoint = np.repeat(np.tile(levels, 2), 40)
    up = np.repeat(np.tile(np.arange(41) <= 20, 2), 40)
    outlet = setpoint + np.where(up, -0.5, 0.5) + RANDOM.normal(0.0, 1e-3, setpoint.size)
    found = evaluate_characteristic([record("characteristic", np.arange(setpoint.size) * 0.1, setpoint, outlet)], SCALE)
    assert found.figures["hysteresis"].value == pytest.approx(1.0, abs=2e-3)
    assert found.figures["repeatability"].value < 5e-3
    assert said(found, "sweep_lag is not determined")


def test_one_way_gives_no_hysteresis_and_one_cycle_no_repeatability():
    x = np.linspace(0.0, 100.0, 2000)
    found = evaluate_characteristic([record("characteristic", np.arange(2000) * 0.05, x, x)], SCALE)
    assert set(found.figures) & {"hysteresis", "linearity", "repeatability"} == set()
    assert said(found, "hysteresis is not determined: no sweep goes up and down over the judged range.")
    assert said(found, "repeatability is not determined: it needs at least two cycles.")
    assert found.figures["accuracy"].value == pytest.approx(0.0, abs=1e-9)


def test_a_supply_that_is_too_low_is_reported():
    x = np.concatenate([np.linspace(0.0, 100.0, 2000), np.full(200, 100.0), np.linspace(100.0, 0.0, 2000)])
    found = evaluate_characteristic([record("characteristic", np.arange(x.size) * 0.05, x, np.minimum(x, 82.0))], SCALE)
    assert said(found, "The setpoint is not reached: at full setpoint the outlet stays 18 % FS below it.")


def test_an_outlet_that_leads_is_said():
    x = np.concatenate([np.linspace(0.0, 100.0, 2000), np.linspace(100.0, 0.0, 2000)])
    y = x + np.repeat([0.5, -0.5], 2000)
    found = evaluate_characteristic([record("characteristic", np.arange(4000) * 0.05, x, y)], SCALE)
    assert said(found, "it leads the setpoint")
    assert found.figures["hysteresis"].value == pytest.approx(1.0)


def test_a_jump_out_of_zero():
    x = np.concatenate([np.full(100, 0.0), np.linspace(0.0, 100.0, 4000), np.linspace(100.0, 0.0, 4000)])
    found = evaluate_characteristic(
        [record("characteristic", np.arange(x.size) * 0.05, x, np.where(x > 3.0, x, 0.0))], SCALE
    )
    assert found.figures["zero_suppression"].value == pytest.approx(3.0, abs=0.05)


# Steps -------------------------------------------------------------------------------------------------------------


def stepped(outlet, hold: float = 2.0, **more) -> Record:
    time = np.arange(0.0, 1.0 + hold, 0.001)
    setpoint = np.where(time < 1.0, 10.0, 60.0)
    return record("step", time, setpoint, 10.0 + 50.0 * outlet(np.maximum(time - 1.0, 0.0)), is_exact=True, **more)


def first_order(time: np.ndarray) -> np.ndarray:
    return 1.0 - np.exp(-time / 0.1)


def test_times_of_one_step():
    (row,) = evaluate_step([stepped(first_order)], SCALE).rows
    truth = {"delay": math.log(1 / 0.9), "rise_time": math.log(9.0), "response_time": math.log(10.0)}
    truth |= {"settling_time": math.log(20.0)}
    assert {name: row[name] for name in truth} == pytest.approx({k: 0.1 * v for k, v in truth.items()}, rel=1e-3)
    assert (row["direction"], row["amplitude"], row["overshoot"]) == ("up", pytest.approx(50.0), 0.0)


def test_a_record_that_ends_too_early():
    found = evaluate_step([stepped(lambda t: 1.0 - np.exp(-t / 1.0))], SCALE)
    assert said(found, "the outlet has not settled when the record ends")
    assert set(found.figures) == set()
    assert found.rows[0]["is_settled"] is False
    assert said(found, "settling_time is not determined: no step settles.")


def test_a_limit_cycle_is_no_rest():
    found = evaluate_step([stepped(lambda t: first_order(t) + 0.08 * np.sin(2.0 * np.pi * 11.0 * t))], SCALE)
    assert said(found, "the outlet does not rest but swings by +/- 4 % FS at 1")
    assert said(found, "settling_time is not determined, the swing at rest leaves the band of 5 %")
    assert found.figures["hum_amplitude"].value == pytest.approx(4.0, rel=0.01)


def test_an_outlet_that_does_not_follow():
    found = evaluate_step([stepped(lambda t: 0.05 * first_order(t))], SCALE)
    assert said(found, "moves by 2.5 % FS only; no times are given")
    assert said(found, "the setpoint is not reached, the outlet ends at 12.5 % FS")
    assert said(found, "response_time_up is not determined: no step up settles.")
    assert said(
        evaluate_step([record("step", np.arange(99.0), 50.0, 50.0 * np.ones(99))], SCALE), "makes no step of 2 % FS"
    )


def test_overshoot_below_the_noise_is_a_bound():
    noisy = stepped(lambda t: first_order(t) + RANDOM.normal(0.0, 2e-3, t.size))
    found = evaluate_step([noisy], SCALE)
    assert found.figures["overshoot"].bound == "at most"
    assert found.figures["overshoot"].value == pytest.approx(1.0, rel=0.2)


@pytest.mark.parametrize("noise", [1e-4, 1e-3, 5e-3])
def test_a_crossing_in_noise(noise):
    time = np.arange(0.0, 1.0, 0.0005)
    errors = []
    for seed in range(40):
        part = first_order(time) + np.random.default_rng(seed).normal(0.0, noise, time.size)
        errors.append(crossing(time, part, 0.9, noise) - 0.1 * math.log(10.0))
    assert abs(np.mean(errors)) < 0.002
    assert np.std(errors) < 0.006


# Resolution, flow, supply, leakage ---------------------------------------------------------------------------------


def test_stairs_below_the_noise_are_said():
    setpoint = np.repeat(50.0 + 0.05 * np.arange(30), 20)
    outlet = setpoint + RANDOM.normal(0.0, 0.3, setpoint.size)
    found = evaluate_resolution([record("resolution", np.arange(setpoint.size) * 0.1, setpoint, outlet)], SCALE)
    assert said(found, "noise hides motions below")
    assert said(
        evaluate_resolution([record("resolution", np.arange(90.0), 50.0, np.full(90, 50.0))], SCALE), "is no staircase"
    )


def test_flow_needs_its_channel_and_a_way_back():
    time = np.arange(0.0, 60.0, 0.05)
    assert said(
        evaluate_flow([record("flow", time, 50.0, np.full(time.size, 50.0))], SCALE), "the flow was not recorded"
    )
    flow = np.interp(time, [0.0, 5.0, 60.0], [0.0, 0.0, 0.02])
    found = evaluate_flow([record("flow", time, 50.0, 50.0 - 500.0 * flow, flow=flow)], SCALE)
    assert said(found, "does not come back: no hysteresis")
    assert found.figures["flow_droop"].value == pytest.approx(5.0, rel=1e-3)
    assert found.figures["flow_capacity"].value == pytest.approx(0.02, rel=1e-2)
    beyond = evaluate_flow([record("flow", time, 50.0, 50.0 - 500.0 * flow, flow=flow)], SCALE, 0.5)
    assert said(beyond, "less than the rated 0.5")
    assert "flow_droop" not in beyond.figures


def test_the_limit_of_a_valve_is_no_hysteresis():
    """Beyond its largest flow the outlet falls at hardly less flow, there and back."""
    time = np.arange(0.0, 130.0, 0.05)
    opening = np.interp(time, [0.0, 5.0, 65.0, 125.0, 130.0], [0.0, 0.0, 1.4, 0.0, 0.0])
    outlet = np.where(opening < 1.0, 50.0 - opening, 49.0 - 60.0 * (opening - 1.0))
    flow = 0.01 * np.where(opening < 1.0, opening, 1.0 - 0.1 * (opening - 1.0))
    found = evaluate_flow([record("flow", time, 50.0, outlet, flow=flow)], SCALE)
    assert found.figures["flow_hysteresis"].value < 0.05
    assert found.figures["flow_capacity"].value == pytest.approx(0.01, rel=0.02)


def test_supply_without_a_sweep_or_below_the_noise():
    time = np.arange(0.0, 100.0, 0.05)
    supply = np.interp(time, [0.0, 50.0, 100.0], [6e5, 9e5, 6e5])
    assert said(evaluate_supply([record("supply", time, 50.0, np.full(time.size, 50.0))], SCALE), "was not recorded")
    still = record("supply", time, 50.0, np.full(time.size, 50.0), supply=np.full(time.size, 9e5))
    assert said(evaluate_supply([still], SCALE), "changes by 0 Pa only")
    noisy = record("supply", time, 50.0, 50.0 + RANDOM.normal(0.0, 0.05, time.size), supply=supply)
    found = evaluate_supply([noisy], SCALE)
    assert found.figures["supply_sensitivity"].bound == "at most"
    assert said(found, "supply_sensitivity is below what the noise of the recording lets see")


def test_a_supply_close_to_the_outlet_is_not_judged():
    time = np.arange(0.0, 100.0, 0.05)
    supply = np.interp(time, [0.0, 50.0, 100.0], [3e5, 9e5, 3e5])
    outlet = np.minimum(50.0, SCALE.percent(supply))
    (row,) = evaluate_supply([record("supply", time, 50.0, outlet, supply=supply)], SCALE).rows
    assert row["sensitivity"] == pytest.approx(0.0, abs=1e-6)
    assert row["lowest_supply"] == pytest.approx(4.6e5, rel=0.01)


def test_a_leakage_that_still_changes_is_said():
    time = np.arange(0.0, 100.0, 0.1)
    drifting = record("leakage", time, 50.0, np.full(1000, 50.0), consumption=1e-5 * np.exp(-time / 50.0))
    found = evaluate_leakage([drifting], SCALE)
    assert said(found, "still changes at the end of the hold")
    none = evaluate_leakage([record("leakage", time, 50.0, np.full(1000, 50.0), consumption=np.zeros(1000))], SCALE)
    assert (none.figures["leakage"].value, none.figures["leakage"].bound) == (0.0, "")
    assert said(evaluate_leakage([record("leakage", time, 50.0, np.full(1000, 50.0))], SCALE), "was not recorded")


# All of them -------------------------------------------------------------------------------------------------------


def test_every_missing_figure_has_its_reason():
    """Whatever the records lack: a figure is there or its name stands in a note."""
    from poppet.bench.iso10094.definitions import DEFINITIONS, TESTS

    flat = record("", np.arange(200.0), 50.0, np.full(200, 50.0))
    for test in TESTS:
        found = evaluated(test, [flat], SCALE)
        names = {d.name for d in DEFINITIONS.values() if d.test == test} - {"hum_amplitude", "hum_frequency"}
        assert {
            name for name in names if name not in found.figures and not said(found, f"{name} is not determined")
        } == set()
        assert all(math.isfinite(figure.value) for figure in found.figures.values())


def test_unknown_and_missing_tests():
    with pytest.raises(InputError, match="Did you mean frequency"):
        run_bench(StandIn(), tests=("frequancy",))
    result = run_recordings("t", {}, SCALE, tests=("step",))
    assert result.figures == {}
    assert result.notes["bench"] == ("step: no recording of this test was given.",)


def test_a_scale_must_rise():
    with pytest.raises(InputError, match="does not rise"):
        Scale(1.0, 1.0, "V", 1e5, 7e5)
    with pytest.raises(InputError, match="full scale"):
        Scale(0.0, 1.0, "V", 7e5, 1e5)
