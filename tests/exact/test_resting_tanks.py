"""Charges of a tank whose valve opens after the first sample, from an integration that shares nothing with `poppet`."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from poppet.identify import TankTest, identify_tank
from refusals import refused

GAS, KAPPA, ROOM, SUPPLY, VOLUME = 287.1, 1.4, 293.15, 7e5, 0.02
CONDUCTANCE, RATIO, WALL = 0.8e-8, 0.25, 15.0


def charge(rest, *, noise=300.0, seed=1, end=40.0, n=800, conductance=CONDUCTANCE):
    """Return times and pressures of a charge that begins after `rest` seconds."""

    def rates(_, state):
        mass, energy = state
        temperature = energy / (mass * GAS / (KAPPA - 1.0))
        pressure = mass * GAS * temperature / VOLUME
        position = np.clip((pressure / SUPPLY - RATIO) / (1.0 - RATIO), 0.0, 1.0)
        flow = conductance * SUPPLY * 1.185 * np.sqrt(max(1.0 - position**2, 0.0))
        heat = WALL * (ROOM - temperature)
        return [flow, flow * KAPPA / (KAPPA - 1.0) * GAS * ROOM + heat]

    mass = 1e5 * VOLUME / (GAS * ROOM)
    start = [mass, mass * GAS / (KAPPA - 1.0) * ROOM]
    time = np.linspace(0.0, end, n)
    solution = solve_ivp(rates, (0.0, end), start, rtol=1e-9, atol=1e-12, dense_output=True)
    _, energy = solution.sol(np.maximum(time - rest, 0.0))
    pressure = energy * (KAPPA - 1.0) / VOLUME
    return time, pressure + noise * np.random.default_rng(seed).standard_normal(n)


def tank_test(time, pressure, **recording):
    """Return the test of one charge."""
    return TankTest(
        recordings={"test": {"time": time, "tank.pressure": pressure, **recording}},
        volume=VOLUME,
        direction="charge",
        supply_pressure=SUPPLY,
        ambient_pressure=1e5,
        ambient_temperature=ROOM,
        initial_temperature=ROOM,
    )
