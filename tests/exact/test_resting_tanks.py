"""Charges of a tank whose valve opens after the first sample, from an integration that shares nothing with `poppet`."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.signal import lfilter

from poppet.identify import TankTest, identify_tank
from poppet.identify.tank.resting import rest_before_opening
from refusals import refused

GAS, KAPPA, ROOM, SUPPLY, VOLUME = 287.05, 1.4, 293.15, 7e5, 0.02
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


def test_a_rest_is_rejected_and_its_proposal_gives_the_truth():
    """The proposed time as `opens` gives C within 0.5 % and b within 0.03."""
    time, pressure = charge(1.0)
    with refused("tank.rests") as caught:
        identify_tank(tank_test(time, pressure))
    rest = caught.value.facts["rest"]
    assert rest == pytest.approx(1.0, abs=0.1)
    found = identify_tank(tank_test(time, pressure, opens=rest)).parameters
    assert found["valve.sonic_conductance"].value == pytest.approx(CONDUCTANCE, rel=0.005)
    assert found["valve.critical_ratio"].value == pytest.approx(RATIO, abs=0.03)


def random_charge(seed, rest):
    """Return times and pressures of a random charge."""
    g = np.random.default_rng(seed)
    end, n, noise = g.uniform(30.0, 90.0), int(g.integers(150, 2500)), 10.0 ** g.uniform(1.5, 3.3)
    return charge(rest, end=end, n=n, seed=seed, noise=noise, conductance=10.0 ** g.uniform(-8.4, -7.6))


def rest_of(time, pressure):
    noise = max(np.std(np.diff(pressure, 2)) / np.sqrt(6.0), 1e-9)
    return rest_before_opening(time, pressure, noise)


@pytest.mark.parametrize("count", [5, pytest.param(60, marks=pytest.mark.slow)])
def test_rests_are_found_and_clean_charges_have_none(count):
    clean = [rest_of(*random_charge(seed, 0.0)) for seed in range(2 * count)]
    found = {rest: [rest_of(*random_charge(seed, rest)) for seed in range(count)] for rest in (0.5, 1.0, 2.0)}
    counts = {rest: sum(value > 0.0 for value in values) for rest, values in found.items()}
    print(f"rests in {sum(value > 0.0 for value in clean)} of {2 * count} charges without one; of {count}: {counts}")
    assert max(clean) == 0.0
    assert counts[1.0] + counts[2.0] >= 2 * count - 2
    assert counts[0.5] >= 0.7 * count
    for rest, values in found.items():
        assert max(values) < 1.1 * rest


@pytest.mark.parametrize("lag", [0.1, 0.3, 1.0])
def test_a_lag_of_the_sensor_is_no_rest(lag):
    time, pressure = charge(0.0, noise=0.0)
    factor = np.exp(-time[1] / lag)
    slow = lfilter([1.0 - factor], [1.0, -factor], pressure - pressure[0]) + pressure[0]
    assert rest_of(time, slow + 100.0 * np.random.default_rng(3).standard_normal(time.size)) == 0.0
