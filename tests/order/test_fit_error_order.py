"""Proportionality of the error of a fit to the noise."""

from __future__ import annotations

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice
from poppet.identify import TankTest, identify_tank

TRUTH = {"valve.sonic_conductance": 1e-8, "valve.critical_ratio": 0.35, "tank.wall_conductance": 6.0}
NOISES = (30.0, 300.0, 3000.0)
DRAWS = 4


def errors(noise: float) -> list[float]:
    """Return the root mean square of relative errors over draws that are equal for all noise levels."""
    tank = Chamber(volume="20 l", initial_pressure="7 bar", wall_conductance=TRUTH["tank.wall_conductance"])
    valve = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=TRUTH["valve.critical_ratio"])
    exact = Circuit({"tank": tank, "valve": valve}).simulate("50 s", "0.1 s", 1e-9)
    relative_errors = []
    for seed in range(DRAWS):
        scatter = np.random.default_rng(seed).normal(0.0, 1.0, exact.time.size)
        recording = {
            "time": exact.time,
            "tank.pressure": exact["tank.pressure"] + noise * scatter,
            "start": {"tank.initial_pressure": "7 bar"},
        }
        parameters = identify_tank(TankTest(recordings={"test": recording}, volume="20 l")).parameters
        relative_errors.append([parameters[name].value / value - 1.0 for name, value in TRUTH.items()])
    return np.sqrt(np.mean(np.square(relative_errors), axis=0)).tolist()


def test_error_of_a_fit_is_proportional_to_the_noise() -> None:
    table = np.log(np.array([errors(noise) for noise in NOISES]))
    for k in range(len(TRUTH)):
        slope = np.polyfit(np.log(NOISES), table[:, k], 1)[0]
        assert slope == pytest.approx(1.0, abs=0.05)
