"""Tests of the coverage of intervals of C, b and wall conductance, from noisy and rounded synthetic pressures."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np
import pytest
from scipy.stats import binom

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.identify import TankTest, identify_tank

SAMPLES, ALL, FEW = 600, 500, 40
FULL_SCALE = 8e5
NOISE, STEP = 0.001 * FULL_SCALE, FULL_SCALE / 2**12
NAMES = ("valve.sonic_conductance", "valve.critical_ratio", "tank.wall_conductance")
LEAST_HEAT = 2.0
"""Least wall conductance with a two-sided interval [W/K]; below it, the bound at 0 makes the interval one-sided."""


class Trial(NamedTuple):
    """Errors of one tank test, and whether its intervals include the truth."""

    truth: tuple[float, float, float]
    errors: tuple[float, float]
    covered: tuple[bool, bool, bool]


@cache
def run_trial(seed: int) -> Trial:
    """Return the result of one test: a charge for an even seed, 10 to 200 l, one tenth without wall heat."""
    generator = np.random.default_rng([2012, seed])
    volume, conductance = 10.0 ** generator.uniform(-2.0, np.log10(0.2)), 10.0 ** generator.uniform(-9.0, -7.3)
    ratio = generator.uniform(0.2, 0.5)
    wall = generator.uniform(0.0, 100.0) if seed % 10 < 9 else 0.0
    is_charge = seed % 2 == 0
    # The duration includes choked flow and the end of the flow: tau = V / (C rho0 R T0) of an isothermal tank.
    duration = (1.8 if is_charge else 3.0) * volume / (conductance * 1.185 * 287.05 * 293.15)
    tank = Chamber(volume=volume, initial_pressure="1 bar" if is_charge else "7 bar", wall_conductance=wall)
    ports = ("supply", "tank") if is_charge else ("tank", "ambient")
    valve = Orifice(from_=ports[0], to=ports[1], sonic_conductance=conductance, critical_ratio=ratio)
    parts = {"tank": tank, "valve": valve} | ({"supply": Reservoir(pressure="7 bar")} if is_charge else {})
    exact = Circuit(parts).simulate(duration, duration / (SAMPLES - 1), 1e-9)
    noisy = exact["tank.pressure"] + generator.normal(0.0, NOISE, exact.time.size)
    recording = {
        "time": exact.time,
        "tank.pressure": STEP * np.round(noisy / STEP),
        "start": {"tank.initial_pressure": "1 bar" if is_charge else "7 bar"},
    }
    test = TankTest(
        recordings={"test": recording},
        volume=volume,
        direction="charge" if is_charge else "discharge",
        supply_pressure="7 bar" if is_charge else None,
        ambient_temperature="20 degC",
    )
    found, truth = identify_tank(test).parameters, (conductance, ratio, wall)
    errors = abs(found[NAMES[0]].value / conductance - 1.0), abs(found[NAMES[1]].value - ratio)
    covered = tuple(found[name].low <= value <= found[name].high for name, value in zip(NAMES, truth, strict=True))
    return Trial(truth, errors, covered)  # type: ignore[arg-type]


def coverage(trials: list[Trial], is_in: Callable[[float], bool]) -> tuple[int, np.ndarray]:
    """Return the number of tests with the wall conductance in a range, and the coverage of each interval."""
    hits = np.array([each.covered for each in trials if is_in(each.truth[2])])
    return len(hits), hits.sum(axis=0)


def check_medians(trials: list[Trial]) -> None:
    conductance, ratio = np.median([each.errors for each in trials], axis=0)
    assert conductance < 0.005
    assert ratio < 0.02


@pytest.mark.slow
def test_coverage_of_forty_tanks() -> None:
    """Check few tests with the limits of a binomial count of 95 % that are exceeded once in a thousand cases."""
    trials = [run_trial(seed) for seed in range(FEW)]
    check_medians(trials)
    count, hits = coverage(trials, lambda wall: wall >= LEAST_HEAT)
    assert count > 30
    assert np.all(hits >= binom.ppf(0.001, count, 0.95))


@pytest.mark.slow
def test_coverage_of_five_hundred_tanks() -> None:
    """Print the coverage, also one-sided without wall heat; `pytest -m slow -rP` shows it."""
    trials = [run_trial(seed) for seed in range(ALL)]
    check_medians(trials)
    count, hits = coverage(trials, lambda wall: wall >= LEAST_HEAT)
    print(f"covered of {count} tests with wall heat:", dict(zip(NAMES, (hits / count).round(4).tolist(), strict=True)))
    assert count > 400
    assert np.all((hits >= 0.92 * count) & (hits <= 0.98 * count))
    idle, on_bound = coverage(trials, lambda wall: wall == 0.0)
    print(f"wall conductance covered of {idle} tests without wall heat, one-sided: {on_bound[2] / idle:.3f}")
    assert idle == ALL // 10
    assert on_bound[2] >= binom.ppf(0.001, idle, 0.95)
