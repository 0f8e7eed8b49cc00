"""Tests of tanks whose free leak ends at its bound 0, although the true leak is small but not zero."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from exact.independent_edge_tanks import Array, EdgeTank, draw, simulate
from poppet.identify import Result, TankTest, identify_tank

C, HA, LEAK = "valve.sonic_conductance", "tank.wall_conductance", "leak.sonic_conductance"
SEED = 5552
ENDS_AT_BOUND = (1, 4, 11, 12, 17, 23)
"""Draws of the noise, of the first 25, for which the estimate of the leak is 0."""
ENDS_NEAR_BOUND = 24
"""Draw for which the search ends at a leak below 1e-6 of C."""


def leaky_tank(fraction: float) -> EdgeTank:
    """Return a discharge with a leak that is a fraction of C."""
    tank = draw(SEED)
    return replace(tank, step=0.0, leak=fraction * tank.conductance)


@cache
def true_pressure(fraction: float) -> Array:
    tank = leaky_tank(fraction)
    return simulate(tank, np.linspace(0.0, tank.duration, tank.samples))


@cache
def identify_draw(seed: int, fraction: float = 0.003) -> Result:
    """Identify one noisy recording, with a free leak."""
    tank = leaky_tank(fraction)
    pressure = true_pressure(fraction) + np.random.default_rng([31, SEED, seed]).normal(0.0, tank.noise, tank.samples)
    time = np.linspace(0.0, tank.duration, tank.samples)
    return identify_tank(
        TankTest(
            recordings={"test": {"time": time, "tank.pressure": pressure, "closes": tank.closes}},
            volume=tank.volume,
            direction="discharge",
            ambient_pressure=tank.room,
            ambient_temperature=tank.temperature,
            initial_temperature=tank.temperature,
            leak_conductance="free",
            uncertainties=0,
        )
    )


@pytest.mark.parametrize("seed", [*ENDS_AT_BOUND, ENDS_NEAR_BOUND])
def test_interval_includes_leaks_that_the_data_do_not_reject(seed: int) -> None:
    tank, parameters = leaky_tank(0.003), identify_draw(seed).parameters
    assert parameters[LEAK].verdict == "at bound"
    for name, truth in ((C, tank.conductance), (HA, tank.wall), (LEAK, tank.leak)):
        e = parameters[name]
        assert e.low <= truth <= e.high, name
        assert abs(e.value - truth) < 3.0 * e.standard_error, name


def test_interval_is_wider_on_the_side_of_a_leak() -> None:
    """A leak takes a part of the flow, so that C is smaller with a leak than without it."""
    e = identify_draw(ENDS_AT_BOUND[0]).parameters[C]
    assert e.value - e.low > 10.0 * (e.high - e.value)


@pytest.mark.slow
@pytest.mark.parametrize(("fraction", "least"), [(0.0, 22), (0.003, 22)])
def test_coverage_of_repeated_tests(fraction: float, least: int) -> None:
    tank = leaky_tank(fraction)
    estimates = [identify_draw(seed, fraction).parameters[C] for seed in range(25)]
    covered = sum(e.low <= tank.conductance <= e.high for e in estimates)
    print(f"{covered} of 25 covered")
    assert covered >= least
    assert max(abs(e.value - tank.conductance) / e.standard_error for e in estimates) < 4.0
