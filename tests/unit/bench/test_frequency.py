"""Tests of the detection of sines, the fitted waves and the bandwidths."""

from __future__ import annotations

import math

import numpy as np
import pytest

from poppet.bench.iso10094.evaluation import Evaluation
from poppet.bench.iso10094.frequency import FREQUENCY, find_sines, first_fall, fit_sine
from poppet.bench.iso10094.scale import Record, Scale

SCALE = Scale(0.0, 100.0, "V", 1e5, 7e5)
NONE = np.zeros(0)


def evaluated(*records: Record) -> Evaluation:
    return FREQUENCY.evaluate_records(records, SCALE)


def codes(evaluation: Evaluation) -> list[str]:
    return [note.code.removeprefix("bench.frequency.") for note in evaluation.notes]


def record(time: np.ndarray, setpoint: np.ndarray, outlet: np.ndarray, name: str = "r") -> Record:
    return Record(name, "frequency", time, setpoint, SCALE.pressure(outlet), NONE, NONE, NONE)


def sine(frequency: float, gain: float = 1.0, phase: float = 0.0, mean: float = 50.0, amplitude: float = 5.0) -> Record:
    time = np.arange(0.0, 6.0 / frequency, 0.01 / frequency)
    turn = 2.0 * math.pi * frequency * time
    return record(
        time, mean + amplitude * np.sin(turn), mean + gain * amplitude * np.sin(turn + phase), f"{frequency} Hz"
    )


def test_sines_of_different_frequencies_are_separated():
    time = np.arange(0.0, 14.0, 0.002)
    turn = np.where(time < 6.0, time, 6.0 + 2.5 * (time - 6.0))
    noise = np.random.default_rng(1).normal(0.0, 0.3, time.size)
    windows = find_sines(time, 50.0 + 5.0 * np.sin(2.0 * np.pi * turn) + noise)
    assert len(windows) == 2
    ends = [time[index] for part in windows for index in (part.start, part.stop - 1)]
    assert ends == pytest.approx([0.0, 6.0, 6.0, 14.0], abs=0.05)
    assert find_sines(time, np.full(time.size, 50.0)) == []


def test_wave_is_fitted_to_uneven_samples_with_drift():
    random = np.random.default_rng(2)
    time = np.sort(random.uniform(0.0, 5.0, 3000))
    turn = 2.0 * np.pi * 1.3 * time
    fitted = fit_sine(time, 3.0 + 0.2 * time + 2.0 * np.sin(turn + 0.4) + 0.3 * np.sin(3.0 * turn), 1.3)
    assert abs(fitted.value) == pytest.approx(2.0, rel=1e-3)
    assert math.atan2(fitted.value.imag, fitted.value.real) == pytest.approx(0.4, abs=1e-3)
    assert fitted.distortion == pytest.approx(0.15, rel=1e-2)


def test_gain_and_phase_of_each_row():
    evaluation = evaluated(sine(1.0), sine(2.0, 0.5, -1.0))
    first, second = evaluation.rows
    assert (first["gain_db"], first["phase"]) == pytest.approx((0.0, 0.0), abs=1e-6)
    assert second["gain_db"] == pytest.approx(20.0 * math.log10(0.5), abs=1e-4)
    assert second["phase"] == pytest.approx(-math.degrees(1.0), abs=1e-3)
    assert second["frequency"] == pytest.approx(2.0, rel=1e-6)


def test_phase_is_continuous_beyond_180_degrees():
    phases = [-0.5, -1.5, -2.5, -3.5, -4.5]
    evaluation = evaluated(*(sine(2.0**k, 0.8**k, phase) for k, phase in enumerate(phases)))
    assert [row["phase"] for row in evaluation.rows] == pytest.approx([math.degrees(p) for p in phases], abs=0.01)


def test_bandwidth_is_that_of_the_first_amplitude():
    records = [sine(f, 1.0 / (1.0 + f)) for f in (0.1, 1.0, 2.0)] + [
        sine(f, 1.0, amplitude=20.0) for f in (0.1, 1.0, 2.0)
    ]
    evaluation = evaluated(*records)
    assert len({curve.case for curve in evaluation.curves}) == 2
    assert 0.1 < evaluation.figures["bandwidth_gain"].value < 1.0
    assert evaluation.figures["bandwidth_gain"].conditions["amplitude"] == pytest.approx(5.0)


def test_bandwidth_above_the_highest_frequency_is_a_bound():
    evaluation = evaluated(sine(1.0), sine(2.0, 0.99, -0.1))
    figure = evaluation.figures["bandwidth_phase"]
    assert (figure.value, figure.bound) == (pytest.approx(2.0), "at least")
    (note,) = [note for note in evaluation.notes if note.address == "bandwidth_phase"]
    assert note.code == "bench.frequency.low_phase"
    assert (note.facts["level"], note.facts["highest"]) == (-90.0, pytest.approx(2.0))


def test_sines_without_evaluation_are_reported():
    slow = record(np.arange(0.0, 1.0, 0.01), np.linspace(0.0, 100.0, 100), np.linspace(0.0, 100.0, 100))
    evaluation = evaluated(slow)
    assert evaluation.figures == {}
    assert codes(evaluation)[0] == "no_sine"
    noisy = sine(1.0, 1e-5)
    shaken = record(noisy.time, noisy.setpoint, 50.0 + np.random.default_rng(3).normal(0.0, 1.0, noisy.time.size))
    assert "lost" in codes(evaluated(shaken))
    coarse = sine(1.0)
    sparse = record(coarse.time[::20], coarse.setpoint[::20], SCALE.percent(coarse.outlet)[::20])
    assert "few_samples" in codes(evaluated(sparse))


def test_only_steady_periods_are_evaluated():
    time = np.arange(0.0, 12.0, 0.005)
    turn = 2.0 * np.pi * time
    transient = 20.0 * np.exp(-2.0 * time)
    evaluation = evaluated(record(time, 50.0 + 5.0 * np.sin(turn), 50.0 + 3.0 * np.sin(turn) + transient))
    assert evaluation.rows[0]["gain"] == pytest.approx(0.6, rel=0.01)
    assert evaluation.rows[0]["periods"] < 11


@pytest.mark.parametrize("spacing", [10, 5])
def test_interpolated_bandwidth_of_first_order(spacing):
    frequency = np.logspace(-1.0, 1.0, 2 * spacing + 1)
    corner = 1.37
    gain = -10.0 * np.log10(1.0 + (frequency / corner) ** 2)
    exact = corner * math.sqrt(10.0**0.3 - 1.0)
    assert first_fall(frequency, gain, -3.0) == pytest.approx(exact, rel=0.005)
    assert math.isnan(first_fall(frequency, gain, -90.0))
    assert math.isnan(first_fall(frequency, gain, 1.0))


@pytest.mark.parametrize("phase", [0.0, 0.3, 1.6, 3.14, -1.0])
@pytest.mark.parametrize("count", [3, 4])
def test_few_clean_periods_are_steady(count, phase):
    """All periods count as steady at any initial phase."""
    time = np.arange(0.0, count, 0.01)
    x, y = (50.0 + size * np.sin(2.0 * np.pi * time + phase - lag) for size, lag in ((5.0, 0.0), (4.0, 0.5)))
    evaluation = evaluated(record(time, x, y))
    assert [(row["periods"], round(row["gain"], 6)) for row in evaluation.rows] == [(count, 0.8)]
    assert not any(note.code.startswith("bench.frequency.") for note in evaluation.notes)


def test_transient_leaves_too_few_steady_periods():
    time = np.arange(0.0, 3.0, 0.01)
    x = 50.0 + 5.0 * np.sin(2.0 * np.pi * time)
    evaluation = evaluated(record(time, x, x - 4.0 * np.exp(-3.0 * time)))
    (note,) = (note for note in evaluation.notes if note.code == "bench.frequency.unsteady")
    assert (note.facts["count"], note.facts["total"], str(note)[:1]) == (2, 3, "r")
