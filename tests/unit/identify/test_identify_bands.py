"""Bands around the simulated output of a tank test: do they hold the truth, and samples of another run?"""

from __future__ import annotations

import numpy as np

from poppet import Chamber, Circuit, Orifice
from poppet.identify import TankTest, identify_tank

DRAWS, NOISE = 24, 500.0


def test_bands_of_a_tank_test_hold_truth_and_repetitions() -> None:
    tank = Chamber(volume="2 l", initial_pressure="7 bar", wall_conductance=1.0)
    parts = {"tank": tank, "valve": Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)}
    truth = Circuit(parts).simulate(8.0, 0.08)
    pressure, generator = truth["tank.pressure"], np.random.default_rng(7)
    held, new = [], []
    for _ in range(DRAWS):
        measured, repeated = pressure + generator.normal(0.0, NOISE, (2, truth.time.size))
        recording = {"time": truth.time, "tank.pressure": {"values": measured, "noise": NOISE}}
        test = TankTest(
            recordings={"a": recording},
            volume="2 l",
            wall_conductance={"start": 1.5},
            sonic_conductance={"start": 9e-9},
        )
        found = identify_tank(test).series["a.tank.pressure"]
        held.append(np.mean((found["low"] <= pressure) & (pressure <= found["high"])))
        new.append(np.mean((found["samples_low"] <= repeated) & (repeated <= found["samples_high"])))
        assert np.all(found["high"] - found["low"] < found["samples_high"] - found["samples_low"])
    # Each fit counts as some four draws, one for each of its numbers; the truth may miss by three of their sigmas.
    assert 1.0 >= np.mean(held) >= 0.95 - 3.0 * np.sqrt(0.95 * 0.05 / (4 * DRAWS))
    assert 0.935 <= np.mean(new) <= 0.965
