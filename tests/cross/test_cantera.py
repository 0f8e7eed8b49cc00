"""Filling, emptying and equalising tanks against Cantera, which shares no line with this code.

Cantera integrates its own energy equation of an ideal gas (its reactors, walls and valves, by CVODES); it is told
only the mass flow rate, from the law of ISO 6358 evaluated in Python with the pressures and temperatures it has at
the moment.
"""

from __future__ import annotations

import numpy as np
import pytest

from cantera_tanks import GAS_CONSTANT, KAPPA, SIZE, advanced, ct, ideal_gas, joined, reservoir, tank
from poppet import Circuit
from poppet.parts import Chamber, Orifice, Reservoir

CONDUCTANCES = [0.0, 2.0]


WITHIN = 2e-8


def apart(circuit: Circuit, names, reactors, duration: float) -> float:
    """The largest relative difference in pressure, temperature and mass."""
    ours = circuit.simulate(duration, duration / 100.0, 1e-9)
    theirs = advanced(reactors, ours.time)
    own = [[ours[f"{name}.{quantity}"] for quantity in ("pressure", "temperature", "mass")] for name in names]
    return float(np.max(np.abs(np.moveaxis(own, -1, 0) / theirs - 1.0)))


def test_the_gas_is_the_same():
    gas = ideal_gas(1e5, 293.15)
    assert gas.density == pytest.approx(1e5 / (GAS_CONSTANT * 293.15), rel=1e-12)
    assert gas.cp_mass / gas.cv_mass == pytest.approx(KAPPA, rel=1e-12)


def charging(conductance: float) -> float:
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "fill": Orifice(from_="supply", to="tank", **SIZE),
        "tank": Chamber(volume="10 l", wall_conductance=conductance),
    }
    vessel, room = tank(0.01, 1e5), reservoir(1e5)
    keep = joined(reservoir(7e5), vessel), ct.Wall(room, vessel, U=conductance, A=1.0)
    assert keep  # else they are gone before the run
    return apart(Circuit(parts), ["tank"], [vessel], 8.0)


def discharging(conductance: float) -> float:
    parts = {
        "tank": Chamber(volume="10 l", wall_conductance=conductance, initial_pressure="7 bar"),
        "vent": Orifice(from_="tank", to="ambient", **SIZE),
    }
    vessel, room = tank(0.01, 7e5), reservoir(1e5)
    keep = joined(vessel, room), ct.Wall(room, vessel, U=conductance, A=1.0)
    assert keep  # else they are gone before the run
    return apart(Circuit(parts), ["tank"], [vessel], 15.0)


def equalising(conductance: float) -> float:
    walls = {"wall_conductance": conductance}
    parts = {
        "full": Chamber(volume="2 l", initial_pressure="7 bar", **walls),
        "warm": Chamber(volume="5 l", initial_temperature="320 K", **walls),
        "bridge": Orifice(from_="full", to="warm", **SIZE),
    }
    full, warm, room = tank(0.002, 7e5), tank(0.005, 1e5, 320.0), reservoir(1e5)
    keep = joined(full, warm), *(ct.Wall(room, vessel, U=conductance, A=1.0) for vessel in (full, warm))
    assert keep  # else they are gone before the run
    return apart(Circuit(parts), ["full", "warm"], [full, warm], 1.0)


@pytest.mark.parametrize("conductance", CONDUCTANCES)
@pytest.mark.parametrize("run", [charging, discharging, equalising])
def test_the_runs_agree(run, conductance):
    assert run(conductance) < WITHIN
