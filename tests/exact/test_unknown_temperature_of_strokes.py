"""Tests of bands of C(x) if the temperature is not stated; the independent generator uses a warm ambient."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from exact import independent_tanks
from exact.independent_tanks import AIR, Tank, course
from exact.test_unknown_temperature import USUAL, WARM, generate_test
from poppet import Circuit
from poppet.identify import Result, identify_characteristic, identify_tank
from poppet.identify.characteristic.stroke_tests import StrokeRecording, common_of_result, point_of_result
from poppet.identify.free_parameter import read_free
from poppet.parts import Chamber, Orifice, Reservoir
from poppet.timeseries.measurements import Channel, Measurement

SIGMA = 3.0
STROKES = (0.2e-3, 0.5e-3, 0.8e-3, 1e-3)
WALL = 8.0
DISCHARGE = Tank(False, 5e-3, 1e-8, 0.3, WALL, 7e5, AIR, closes=np.inf, duration=15.0)


def conductance(stroke: float) -> float:
    """Return the true C(x)."""
    return 1e-8 * (1.0 + 1e3 * stroke)


def identify_strokes(warm: float, monkeypatch: pytest.MonkeyPatch, *, stated: bool = False) -> Result:
    """Identify C(x) from discharges with recorded pressures only; all temperatures are `warm`."""
    monkeypatch.setattr(independent_tanks, "ROOM", warm)
    parts = {
        "tank": Chamber(volume=DISCHARGE.volume, wall_conductance=5.0, initial_pressure=DISCHARGE.begin),
        "room": Reservoir(pressure=AIR),
        "valve": Orifice(from_="tank", to="room", sonic_conductance=2e-8, critical_ratio=0.3),
    }
    usual = ("tank.initial_temperature", "room.temperature", "ambient.temperature")
    bench = Circuit(parts).with_values(dict.fromkeys(usual, warm) if stated else {})
    free = (read_free("tank.wall_conductance", {}, bench),)
    tests, time = [], np.linspace(0.0, DISCHARGE.duration, 150)
    for k, stroke in enumerate(STROKES):
        pressure = course(replace(DISCHARGE, conductance=conductance(stroke), source=warm), time)[0]
        noisy = pressure + np.random.default_rng(k).normal(0.0, 100.0, time.size)
        channel = Channel("tank.pressure", time, noisy, "Pa", noise=100.0)
        tests.append(StrokeRecording(stroke, bench, Measurement(f"{k}", (channel,), duration=time[-1]), free=free))
    return identify_characteristic(tests, degree_conductance=1, degree_ratio=0)


def band_of_conductance(result: Result) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the curve of C and its band, relative to the true C."""
    series = result.series["sonic_conductance"]
    true = np.array([conductance(x) for x in series["x"]])
    return series["y"] / true, series["low"] / true, series["high"] / true


def room_note(result: Result) -> dict:
    (note,) = (note for note in result.remarks if note.code == "characteristic.room")
    return note.facts


@pytest.mark.parametrize("warm", [298.15, 303.15])
def test_band_includes_unknown_temperature(warm, monkeypatch):
    """Compare curve and band with the note, also for an ambient that is warmer by 10 K (three sigmas)."""
    known, guessed = identify_strokes(warm, monkeypatch, stated=True), identify_strokes(warm, monkeypatch)
    value, low, high = band_of_conductance(known)
    assert np.all((low < 1.0) & (high > 1.0))
    guess, wide_low, wide_high = band_of_conductance(guessed)
    np.testing.assert_allclose(guess / value, (warm / USUAL) ** 0.5, rtol=2e-4)
    np.testing.assert_allclose(wide_high - guess, 1.96 * guess * 0.5 * SIGMA / USUAL, rtol=0.1)
    assert np.all((wide_low < 1.0) == (warm < 300.0))
    assert np.all(guess - (high - value) > 1.0)  # without this uncertainty, the band does not include the truth
    assert "characteristic.room" not in {note.code for note in known.remarks}
    assert room_note(guessed)["percent"] == pytest.approx(50.0 / USUAL, rel=0.01)
    wall = guessed.parameters["tank.wall_conductance"]
    assert wall.value == pytest.approx(WALL * warm / USUAL, rel=0.01)
    assert wall.standard_error == pytest.approx(wall.value * SIGMA / USUAL, rel=0.2)


def test_tank_tests_share_temperature_error(monkeypatch):
    """Check that the common error is not treated as scatter of single points, which would average out."""
    monkeypatch.setattr(independent_tanks, "ROOM", WARM)
    test = generate_test(1)[1]
    untold, told = identify_tank(test), identify_tank(replace(test, ambient_temperature=WARM))
    assert common_of_result(untold, part="valve") == pytest.approx((0.5 * SIGMA / USUAL, 0.0))
    assert common_of_result(told, part="valve") == (0.0, 0.0)
    own = [point_of_result(result, 1e-3, part="valve").u_sonic_conductance for result in (untold, told)]
    assert own[0] == pytest.approx(own[1], rel=0.05)
