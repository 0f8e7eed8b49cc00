"""Coverage of the confidence bands of a tank test, for the truth and for repeated samples."""

from __future__ import annotations

import numpy as np

from poppet import Chamber, Circuit, Orifice
from poppet.identify import TankTest, identify_tank

DRAWS, NOISE = 24, 500.0


def test_bands_of_a_tank_test_contain_truth_and_repetitions() -> None:
    tank = Chamber(volume="2 l", initial_pressure="7 bar", wall_conductance=1.0)
    parts = {"tank": tank, "valve": Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)}
    truth = Circuit(parts).simulate(8.0, 0.08)
    pressure, generator = truth["tank.pressure"], np.random.default_rng(7)
    coverage_of_truth, coverage_of_samples = [], []
    for _ in range(DRAWS):
        measured, repeated = pressure + generator.normal(0.0, NOISE, (2, truth.time.size))
        recording = {"time": truth.time, "tank.pressure": {"values": measured, "noise": NOISE}}
        test = TankTest(
            recordings={"a": recording},
            volume="2 l",
            wall_conductance={"start": 1.5},
            sonic_conductance={"start": 9e-9},
        )
        table = identify_tank(test).series["a.tank.pressure"]
        coverage_of_truth.append(np.mean((table["low"] <= pressure) & (pressure <= table["high"])))
        coverage_of_samples.append(np.mean((table["samples_low"] <= repeated) & (repeated <= table["samples_high"])))
        assert np.all(table["high"] - table["low"] < table["samples_high"] - table["samples_low"])
    # Each fit counts as four draws, one for each parameter; the limit is three standard deviations of their mean.
    assert 1.0 >= np.mean(coverage_of_truth) >= 0.95 - 3.0 * np.sqrt(0.95 * 0.05 / (4 * DRAWS))
    assert 0.935 <= np.mean(coverage_of_samples) <= 0.965
