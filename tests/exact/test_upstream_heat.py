"""The heat that slow flow carries: against a second hand with exact upwinding, and against ever narrower zones."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Recording, Reservoir
from poppet.circuit.options import GasChoice
from poppet.signals import Sine

sys.path.insert(0, str(Path(__file__).parent))
from independent_tanks import Tank, course

TANK = {"volume": 2e-3, "initial_temperature": 293.15, "wall_temperature": 293.15}


def filled(laminar_ratio: float, gas: str = "air") -> Recording:
    parts = {
        "supply": Reservoir(pressure=7e5, temperature=293.15),
        "valve": valve("supply", laminar_ratio),
        "tank": Chamber(initial_pressure=1e5, wall_conductance=1.0, **TANK),
    }
    return Circuit(parts, gas=GasChoice(name=gas)).simulate(20.0, 0.01)


def two_tanks(laminar_ratio: float, gas: str = "air") -> Recording:
    parts = {
        "one": Chamber(initial_pressure=7e5, wall_conductance=1.0, **TANK | {"initial_temperature": 330.0}),
        "valve": valve("one", laminar_ratio),
        "tank": Chamber(initial_pressure=1e5, wall_conductance=0.2, **TANK),
    }
    return Circuit(parts, gas=GasChoice(name=gas)).simulate(20.0, 0.01)


def to_and_fro(laminar_ratio: float, gas: str = "air") -> Recording:
    """A tank that breathes with its supply, ten times through zero flow."""
    parts = {
        "supply": Reservoir(pressure=5e5, temperature=293.15),
        "valve": valve("supply", laminar_ratio),
        "tank": Chamber(initial_pressure=5e5, wall_conductance=0.3, **TANK),
    }
    breath = Sine(mean=5e5, amplitude=2e4, frequency=0.25)
    return Circuit(parts, gas=GasChoice(name=gas), signals={"supply.pressure": breath}).simulate(20.0, 0.01)


def valve(source: str, laminar_ratio: float) -> Orifice:
    return Orifice(from_=source, to="tank", sonic_conductance=1.2e-8, critical_ratio=0.3, laminar_ratio=laminar_ratio)


def test_tail_of_a_filling_agrees_with_exact_upwinding():
    ours = filled(0.999)
    truth = Tank(True, 2e-3, 1.2e-8, 0.3, 1.0, 1e5, 7e5, closes=20.0, duration=20.0)
    pressure, temperature, mass = course(truth, ours.time)
    assert temperature[1000] == pytest.approx(333.505, abs=0.01)
    assert ours["tank.temperature"] == pytest.approx(temperature, rel=1e-4)
    # What is left is the flow's own zone: the gas that cools draws a little flow, which takes a little drop.
    assert ours["tank.pressure"] == pytest.approx(pressure, rel=2e-4)
    assert ours["tank.mass"] == pytest.approx(mass, rel=2e-4)


@pytest.mark.parametrize("gas", ["air", "helium"])
@pytest.mark.parametrize("case", [filled, two_tanks, to_and_fro])
def test_temperatures_do_not_hang_on_the_width_of_the_zone(case, gas):
    ours, narrow = case(0.999, gas), case(0.99999, gas)
    for name in [name for name in ours.names if name.endswith(".temperature")]:
        assert ours[name] == pytest.approx(narrow[name], rel=1e-4), name


def test_breathing_passes_through_zero_flow():
    flow = to_and_fro(0.999)["valve.mass_flow_rate"]
    assert np.count_nonzero(np.diff(np.sign(flow[np.abs(flow) > 1e-9]))) >= 8
