"""Tests of C(x) from charges with free wall heat: C (adiabatic) and kappa C (isothermal) are equivalent."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from exact.independent_tanks import AIR, KAPPA, ROOM, Tank, course
from poppet import Circuit
from poppet.identify import Result, identify_characteristic
from poppet.identify.characteristic.stroke_tests import StrokeRecording
from poppet.identify.free_parameter import read_free
from poppet.parts import Chamber, Orifice, Reservoir
from poppet.timeseries.measurements import Channel, Measurement

SUPPLY, VOLUME, NOISE = 673_666.0, 5.517e-3, 107.0
CHARGE = Tank(True, VOLUME, 1e-9, 0.3, 0.0, AIR, SUPPLY, closes=np.inf, duration=60.0)
SIZE = {"sonic_conductance": 2e-9, "critical_ratio": 0.3}
STROKES = (0.2e-3, 0.5e-3, 0.8e-3, 1e-3)


def conductance(stroke: float) -> float:
    """Return the true C(x)."""
    return 1e-9 * (1.0 + 1e3 * stroke)


def identify_strokes(is_charge: bool, wall_start: float, *, with_temperature: bool = False) -> Result:
    parts = {
        "tank": Chamber(volume=VOLUME, wall_conductance=wall_start, initial_pressure=AIR if is_charge else SUPPLY),
        "far": Reservoir(pressure=SUPPLY if is_charge else AIR),
        "valve": Orifice(**({"from_": "far", "to": "tank"} if is_charge else {"from_": "tank", "to": "far"}), **SIZE),
    }
    bench = Circuit(parts)
    free, tests = (read_free("tank.wall_conductance", {}, bench),), []
    for k, stroke in enumerate(STROKES):
        tank = replace(CHARGE, is_charge=is_charge, conductance=conductance(stroke))
        tank = tank if is_charge else replace(tank, begin=SUPPLY, outside=AIR)
        generator, time = np.random.default_rng(k), np.linspace(0.0, tank.duration, 300)
        pressure, temperature, _ = course(tank, time)
        noisy = pressure + generator.normal(0.0, NOISE, time.size)
        channels = [Channel("tank.pressure", time, noisy, "Pa", noise=NOISE)]
        if with_temperature:
            channels.append(Channel("tank.temperature", time, temperature, "K", noise=0.5))
        measurement = Measurement(f"test {k}", tuple(channels), duration=tank.duration)
        tests.append(StrokeRecording(stroke, bench, measurement, free=free))
    assert ROOM == 293.15
    return identify_characteristic(tests, degree_conductance=1, degree_ratio=0)


def band_of_conductance(result: Result) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the curve of C and both ends of its band, relative to the true C."""
    series = result.series["sonic_conductance"]
    true = np.array([conductance(x) for x in series["x"]])
    return series["y"] / true, series["low"] / true, series["high"] / true


@pytest.mark.parametrize("wall_start", [0.3, 300.0])
def test_band_of_charges_includes_both_curves(wall_start):
    result = identify_strokes(True, wall_start)
    _, low, high = band_of_conductance(result)
    assert low.max() < 1.01
    assert high.min() > 0.99 * KAPPA
    (note,) = (note for note in result.remarks if note.code == "characteristic.twin")
    factor = note.facts["factor"]
    assert max(factor, 1.0 / factor) == pytest.approx(KAPPA, rel=0.01)
    assert "determined" not in {e.verdict for name, e in result.parameters.items() if ".k" in name}


@pytest.mark.parametrize("with_temperature", [True, False])
def test_temperature_or_discharge_selects_one_curve(with_temperature):
    result = identify_strokes(with_temperature, 300.0, with_temperature=with_temperature)
    value, low, high = band_of_conductance(result)
    np.testing.assert_allclose(value, 1.0, atol=0.02)
    assert (high - low).max() < 0.1
    assert "characteristic.twin" not in {note.code for note in result.remarks}
