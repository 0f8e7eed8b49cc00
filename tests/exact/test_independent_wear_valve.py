"""The rebuilt valve with wear against closed forms, and its twin against it."""

from __future__ import annotations

import numpy as np
import pytest

from exact import independent_wear_valve as truth
from exact.independent_wear_valve import AREA, DEAD_VOLUME, GAS_CONSTANT, STROKE, SUPPLY, TEMPERATURE, Wear, record
from exact.wear_valve_twin import twin
from poppet.signals import Steps

KAPPA = 1.4
CHOKED = np.sqrt(KAPPA / (GAS_CONSTANT * TEMPERATURE)) * (2 / (KAPPA + 1)) ** ((KAPPA + 1) / (2 * (KAPPA - 1)))
"""Mass flow of a choked ideal nozzle per area and pressure (Anderson, Modern Compressible Flow, eq. 5.21)."""


def test_the_bottom_chamber_empties_exponentially():
    # Choked isothermal outflow from a chamber of constant volume: p = p0 exp(-t / tau), until the piston moves.
    rows = record(np.repeat([1.0, 0.0], 50), 0.1)
    p = rows["bottom"][50:58]
    tau = (DEAD_VOLUME + AREA * STROKE) / (0.62 * 1e-5 * CHOKED * GAS_CONSTANT * TEMPERATURE)
    assert p[0] == pytest.approx(SUPPLY, rel=1e-6)
    assert rows["x"][50:58] == pytest.approx(STROKE)
    assert p == pytest.approx(p[0] * np.exp(-0.1 * np.arange(8) / tau), rel=1e-5)


def test_the_valve_opens_when_the_forces_balance():
    rows = record(np.ones(300), 0.01)
    first = int(np.flatnonzero(rows["x"] > 0)[0])
    force = truth.SPRING * truth.PRELOAD + truth.MASS * truth.GRAVITY
    balance = force / AREA + truth.ATMOSPHERE
    assert rows["bottom"][first - 1] < balance < rows["bottom"][first + 1] + 2e4
    assert rows["x"][-1] == pytest.approx(STROKE)


def test_a_leak_lowers_the_pressure_at_rest():
    # The flow through the open port equals that through the leak to the atmosphere, which is choked.
    leak = 1e-6
    p = record(np.ones(600), 0.1, Wear(bottom=leak))["bottom"][-1]
    ratio = p / SUPPLY
    port = np.sqrt(
        2 * KAPPA / (KAPPA - 1) / (GAS_CONSTANT * TEMPERATURE) * (ratio ** (2 / KAPPA) - ratio ** (1 + 1 / KAPPA))
    )
    assert 0.62 * 1e-5 * SUPPLY * port == pytest.approx(leak * p * CHOKED, rel=1e-6)


def test_growth_of_a_leak():
    rows = record(np.ones(100), 0.1, Wear(bottom_growth=1e-9, start=5.0))
    assert rows["bottom_leak"] == pytest.approx(1e-9 * np.maximum(0.1 * np.arange(100) - 5, 0), abs=1e-18)


def test_the_twin_differs_by_its_flow_law_only():
    # The area of the port is that of the sheet; the walls of the twin keep the gas isothermal.
    t = 0.1 * np.arange(600)
    opens = (t % 20 < 10).astype(float)
    rows = record(opens, 0.1)
    edges = np.flatnonzero(np.diff(opens)) + 1
    times, values = [0.0, *t[edges].tolist()], opens[[0, *edges]]
    circuit = twin({"effective_area": 0.62e-5}, 1e6)
    run = circuit.with_signals({
        "open.opening": Steps(times, values.tolist()), "close.opening": Steps(times, (1 - values).tolist())
    }).simulate(59.9, output_step=0.1)  # fmt: skip
    assert np.asarray(run["stem.position"]) == pytest.approx(rows["x"], abs=2e-3 * STROKE)
    difference = np.asarray(run["actuator.cap.pressure"]) - rows["bottom"]
    assert abs(difference).max() < 1e-3 * SUPPLY
    # It is the ellipse of ISO 6358: the largest difference is in subsonic flow.
    assert abs(difference).max() > 1e-5 * SUPPLY
