"""Tests of the bench with a virtual valve: results of runs and of recordings are within 1 % of the true values."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

from poppet.bench.iso10094.characteristic import characteristic_trial
from poppet.bench.iso10094.evaluation import BenchSettings, Trial
from poppet.bench.iso10094.flow import flow_trial
from poppet.bench.iso10094.frequency import frequency_trial
from poppet.bench.iso10094.resolution import resolution_trial
from poppet.bench.iso10094.run_bench import run_bench, run_recordings
from poppet.bench.iso10094.scale import Scale
from poppet.bench.iso10094.supply import leakage_trial, supply_trial
from poppet.bench.iso10094.valve_recordings import read_valve_recordings
from poppet.bench.iso10094.virtual_valve import VirtualValve
from poppet.core.codes import Note
from poppet.core.toml_file import TomlFile
from poppet.signals import Steps

WITHIN = 0.01
TIME, DEAD, ZONE, PLAY, BOW = 0.05, 0.010, 2.0, 0.8, 1.0
ONE = BenchSettings(volumes=(1e-3,), amplitudes=(80.0,))


def static(moved: np.ndarray, zone: float = ZONE, bow: float = BOW) -> np.ndarray:
    """Return the outlet versus the setpoint after the backlash, as an independent formula."""
    above = (moved - zone) * 100.0 / (100.0 - zone)
    return above + 4.0 * bow * above / 100.0 * (1.0 - above / 100.0)


def truth_of_characteristic(play: float = PLAY) -> dict[str, float]:
    place = np.linspace(10.0, 90.0, 20001)
    up, down = static(place - play / 2), static(place + play / 2)
    mean = 0.5 * (up + down)
    line = np.polyval(np.polyfit(place, mean, 1), place)
    return {
        "hysteresis": float(np.max(down - up)),
        "linearity": float(np.max(np.abs(mean - line))),
        "accuracy": float(np.max(np.abs([up - place, down - place]))),
        "zero_suppression": ZONE + play / 2,
    }


def truth_of_steps() -> dict[str, float]:
    """Return the true step times of a first order with a dead time."""
    return {
        "delay": DEAD + TIME * math.log(1.0 / 0.9),
        "rise_time_up": TIME * math.log(9.0),
        "rise_time_down": TIME * math.log(9.0),
        "response_time_up": DEAD + TIME * math.log(10.0),
        "response_time_down": DEAD + TIME * math.log(10.0),
        "settling_time": DEAD + TIME * math.log(20.0),
    }


def truth_of_sines(lowest: float) -> dict[str, float]:
    def gain(f: float) -> float:
        return -10.0 * math.log10(1.0 + (2.0 * math.pi * f * TIME) ** 2)

    def phase(f: float) -> float:
        return -(2.0 * math.pi * f * DEAD + math.atan(2.0 * math.pi * f * TIME))

    return {
        "bandwidth_gain": brentq(lambda f: gain(f) - gain(lowest) + 3.0, 0.01, 100.0),
        "bandwidth_phase": brentq(lambda f: phase(f) + math.pi / 2.0, 0.01, 100.0),
    }


def values(result) -> dict[str, float]:
    return {name: figure.value for name, figure in result.figures.items()}


def codes(result, test: str) -> list[str]:
    return [note.code for note in result.notes[test]]


def assert_close(found: dict[str, float], truth: dict[str, float], within: float = WITHIN) -> None:
    errors = {name: found.get(name, math.nan) / value - 1.0 for name, value in truth.items()}
    assert {name: error for name, error in errors.items() if not abs(error) <= within} == {}


# Driven ------------------------------------------------------------------------------------------------------------


def test_characteristic_values_equal_those_of_the_valve():
    valve = VirtualValve(time_constant=TIME, dead_time=DEAD, dead_zone=ZONE, play=PLAY, bow=BOW)
    result = run_bench(valve, ONE, ("characteristic",))
    assert_close(values(result), truth_of_characteristic())
    rate = result.conditions["characteristic"]["sweep_rate"]
    # What the sweep adds is seen at its stop and taken out: without that the hysteresis would be wrong by much more.
    top = float((static(np.array([100.0])) - static(np.array([99.9])))[0]) / 0.1
    assert result.figures["sweep_lag"].value == pytest.approx(rate * (TIME + DEAD) * top, rel=0.02)
    assert 2.0 * result.figures["sweep_lag"].value > 0.1 * PLAY


def test_offset_and_repeatability():
    valve = VirtualValve(offset=0.7, scatter=0.3)
    found = values(run_bench(valve, ONE, ("characteristic",)))
    assert_close(found, {"zero_offset": 0.7, "repeatability": 0.3, "accuracy": 1.0})


def test_steps_of_a_first_order_behind_a_dead_time():
    result = run_bench(VirtualValve(time_constant=TIME, dead_time=DEAD), tests=("step",))
    assert_close(values(result), truth_of_steps())
    assert result.figures["overshoot"].value == 0.0
    assert "hum_amplitude" not in result.figures
    slower = [row for row in result.rows["step"] if row["volume"] == 5e-3]
    assert len(slower) == 6
    for row in slower:
        assert row["rise_time"] == pytest.approx(5.0 * TIME * math.log(9.0), rel=WITHIN)


@pytest.mark.parametrize("damping", [0.2, 0.5, 0.7])
def test_overshoot_of_a_second_order(damping):
    result = run_bench(VirtualValve(time_constant=0.02, damping=damping), ONE, ("step",))
    overshoot = 100.0 * math.exp(-math.pi * damping / math.sqrt(1.0 - damping**2))
    assert_close(values(result), {"overshoot": overshoot})


def test_limit_cycle_is_reported_with_the_step():
    result = run_bench(VirtualValve(hum=0.15, hum_frequency=17.0), ONE, ("step",))
    assert_close(values(result), {"hum_amplitude": 0.15, "hum_frequency": 17.0})
    assert "bench.step.swings" in codes(result, "step")


def test_frequency_response():
    result = run_bench(VirtualValve(time_constant=TIME, dead_time=DEAD), ONE, ("frequency",))
    lowest = result.conditions["frequency"]["lowest"]
    assert_close(values(result), truth_of_sines(lowest))
    for row in result.rows["frequency"]:
        assert row["phase"] == pytest.approx(
            -math.degrees(2.0 * math.pi * row["frequency"] * DEAD + math.atan(2.0 * math.pi * row["frequency"] * TIME)),
            abs=0.5,
        )
    assert result.figures["distortion"].value < 0.01


def test_backlash_has_the_gain_of_its_describing_function():
    """The fundamental after a backlash follows Gelb & Vander Velde at a low frequency."""
    amplitude, width = 5.0, 2.0
    r = width / amplitude / 1.0
    angle = math.asin(1.0 - r)
    b = (math.pi / 2.0 + angle + (1.0 - r) * math.sqrt(1.0 - (1.0 - r) ** 2)) / math.pi
    a = -(1.0 - (1.0 - r) ** 2) / math.pi
    valve = VirtualValve(time_constant=4e-4, play=width)
    settings = replace(ONE, frequencies=(0.2,), sine_amplitude=amplitude)
    row = run_bench(valve, settings, ("frequency",)).rows["frequency"][0]
    assert row["gain"] == pytest.approx(math.hypot(a, b), rel=WITHIN)
    assert row["phase"] == pytest.approx(math.degrees(math.atan2(a, b)), rel=WITHIN)


def test_flow_and_relief():
    valve = VirtualValve(droop=20.0, rise=12.0, flow_play=0.06, full_flow=0.02)
    found = values(run_bench(valve, ONE, ("flow",)))
    truth = {
        "flow_droop": 10.0, "flow_hysteresis": 20.0 * 0.06, "flow_capacity": 0.02 * (0.5 + 0.03),
        "relief_rise": 6.0, "relief_hysteresis": 12.0 * 0.06,
    }  # fmt: skip
    assert_close(found, truth)
    rated = values(run_bench(valve, replace(ONE, rated_flow=0.004), ("flow",)))
    assert_close(rated, {"flow_droop": 4.0, "relief_rise": 2.4})


def test_supply_and_leakage():
    valve = VirtualValve(supply_sensitivity=-0.012, leak=3e-6)
    found = values(run_bench(valve, ONE, ("supply", "leakage")))
    assert_close(found, {"supply_sensitivity": -0.012, "leakage": 3e-6})


def test_resolution_within_one_stair():
    found = values(run_bench(VirtualValve(threshold=0.5), ONE, ("resolution",)))
    assert found["resolution"] == pytest.approx(0.5, abs=1e-6)
    turned = run_bench(VirtualValve(play=1.2), ONE, ("resolution",))
    assert turned.figures["reversal_threshold"].value == pytest.approx(1.2, abs=0.0501)
    assert (turned.figures["resolution"].value, turned.figures["resolution"].bound) == pytest.approx((0.05, "at most"))
    assert "bench.resolution.every_stair" in codes(turned, "resolution")


def test_absent_values_have_a_reason():
    result = run_bench(VirtualValve(play=4.0), ONE, ("resolution",))
    figure = result.figures["reversal_threshold"]
    assert (figure.value, figure.bound) == (pytest.approx(3.0), "at least")
    dead = run_bench(VirtualValve(dead_zone=99.9), replace(ONE, longest_hold=1.0), ("step",))
    assert "response_time_up" not in dead.figures
    assert Note("bench.absent.no_step", "response_time_up") in dead.notes["step"]
    assert "bench.step.short" in codes(dead, "step")


# From recordings ---------------------------------------------------------------------------------------------------

NOISE, STEP = 60.0, 15.0  # of the pressure sensor and of its converter [Pa]
VOLTS = Scale(0.0, 10.0, "V", 1e5, 7e5)


def write(folder: Path, name: str, valve: VirtualValve, trial: Trial, seed: int) -> None:
    """Write a recording in volts and gauge bars with noise and rounding."""
    record, random = valve.respond(trial), np.random.default_rng(seed)

    def rounded(series: np.ndarray, noise: float, step: float) -> np.ndarray:
        return np.round((series + random.normal(0.0, noise, series.size)) / step) * step

    columns = [
        record.time,
        rounded(record.setpoint, 5e-4, 1e-3),
        rounded(record.outlet - 1e5, NOISE, STEP) / 1e5,
        rounded(record.supply - 1e5, NOISE, STEP) / 1e5,
        rounded(record.flow, 2e-6, 1e-6) * 1e3,
        rounded(record.consumption, 2e-7, 1e-7) * 1e3,
    ]
    head = "t [s],w [V],p2 [bar g],p1 [bar g],q [g/s],q1 [g/s]"
    np.savetxt(folder / f"{name}.csv", np.stack(columns, axis=1), "%.9g", ",", header=head, comments="")


def mapping(tests: dict[str, str]) -> str:
    lines = [
        'title = "bench"',
        'full_scale = "6 bar g"',
        'setpoint_range = ["0 V", "10 V"]',
        'ambient_pressure = "1 bar"',
    ]
    for name, test in tests.items():
        lines += [
            f"[recordings.{name}]", f'test = "{test}"', f'file = "{name}.csv"', 'volume = "1 l"',
            'time = { column = "t" }', '"valve.setpoint" = { column = "w" }', '"outlet.pressure" = { column = "p2" }',
            '"supply.pressure" = { column = "p1" }', '"outlet.mass_flow_rate" = { column = "q" }',
            '"supply.mass_flow_rate" = { column = "q1" }',
        ]  # fmt: skip
    return "\n".join(lines)


def of_recordings(folder: Path, valve: VirtualValve, trials: dict[str, Trial]):
    for seed, (name, trial) in enumerate(trials.items()):
        write(folder, name, valve, trial, seed)
    path = folder / "map.toml"
    path.write_text(mapping({name: trial.kind for name, trial in trials.items()}), encoding="utf-8")
    found = read_valve_recordings(TomlFile.read(path).content, path)
    return run_recordings(found.title, found.records, found.scale, tests=list({t.kind: 0 for t in trials.values()}))


def step_of(amplitude: float, at: float, sample: float) -> Trial:
    """Return a trial with steps between two samples."""
    low, high = (float(VOLTS.setpoint(50.0 + side * amplitude / 2.0)) for side in (-1.0, 1.0))
    return Trial("step", "", Steps([0.0, 0.5 + at, 1.5 + at], [low, high, low]), 2.5 + at, 0.4, sample, 1e-3)


def test_steps_from_recordings(tmp_path):
    valve = VirtualValve(scale=VOLTS, time_constant=TIME, dead_time=DEAD)
    trials = {"large": step_of(80.0, 0.0123, 1e-3), "small": step_of(10.0, 0.0077, 1e-3)}
    result = of_recordings(tmp_path, valve, trials)
    truth = truth_of_steps()
    assert_close(values(result), {name: value for name, value in truth.items() if name != "delay"})
    assert values(result)["delay"] == pytest.approx(truth["delay"], abs=0.5e-3)  # half a sample
    assert result.figures["overshoot"].bound == "at most"
    assert result.figures["overshoot"].value < 1.0


def test_sweep_from_a_recording(tmp_path):
    valve = VirtualValve(scale=VOLTS, time_constant=TIME, dead_time=DEAD, dead_zone=ZONE, play=PLAY, bow=BOW)
    trial = characteristic_trial(VOLTS, 1e-3, 60.0, 2.0)
    result = of_recordings(tmp_path, valve, {"sweep": trial})
    found = values(result)
    assert_close(found, truth_of_characteristic())
    assert result.figures["repeatability"].bound == "at most"
    assert result.figures["repeatability"].value < 0.05


def test_flow_supply_and_leakage_from_recordings(tmp_path):
    valve = VirtualValve(
        scale=VOLTS, droop=20.0, rise=12.0, flow_play=0.06, full_flow=0.02, supply_sensitivity=0.012, leak=3e-6
    )
    trials = {
        "out": flow_trial(VOLTS, 1e-3, 50.0, 30.0, 2.0, 1.0),
        "fed": flow_trial(VOLTS, 1e-3, 50.0, 30.0, 2.0, -1.0),
        "supply": supply_trial(VOLTS, 1e-3, 25.0, 30.0, 2.0, (4e5, 9e5)),
        "rest": leakage_trial(VOLTS, 1e-3, 50.0, 2.0),
    }
    truth = {
        "flow_droop": 10.0, "flow_hysteresis": 1.2, "flow_capacity": 0.0106, "relief_rise": 6.0,
        "relief_hysteresis": 0.72, "supply_sensitivity": 0.012, "leakage": 3e-6,
    }  # fmt: skip
    assert_close(values(of_recordings(tmp_path, valve, trials)), truth)


def test_sines_from_recordings(tmp_path):
    valve = VirtualValve(scale=VOLTS, time_constant=TIME, dead_time=DEAD)
    frequencies = (0.1, 0.5, 1.0, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0, 10.0)
    trials = {
        f"f{k}": frequency_trial(VOLTS, 1e-3, f, 0.6, mean=50.0, amplitude=5.0) for k, f in enumerate(frequencies)
    }
    assert_close(values(of_recordings(tmp_path, valve, trials)), truth_of_sines(0.1))


def test_resolution_from_a_recording(tmp_path):
    result = of_recordings(
        tmp_path, VirtualValve(scale=VOLTS, threshold=0.5), {"stairs": resolution_trial(VOLTS, 1e-3, 0.1, 1.0, 50.0)}
    )
    assert result.figures["resolution"].value == pytest.approx(0.5, abs=0.01)
