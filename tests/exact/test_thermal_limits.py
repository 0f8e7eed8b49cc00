"""Tests of charges whose thermal limits a coarse sensor, a small leak or the supply pressure makes equivalent."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.stats import binom

from exact.independent_edge_tanks import COARSE_CHARGE, LEAKY_ISOTHERMAL, Array, EdgeTank, draw, record, simulate
from poppet.identify import Result, TankTest, identify_tank

C, B, HA = "valve.sonic_conductance", "valve.critical_ratio", "tank.wall_conductance"
CLEAN_CHARGES = (1, 4, 6, 13)


def identify(tank: EdgeTank, time: Array, pressure: Array, **changes: Any) -> Result:
    """Identify a recording with the stated quantities of a tank."""
    return identify_tank(
        TankTest(
            recordings={"test": {"time": time, "tank.pressure": pressure, "closes": tank.closes}},
            volume=tank.volume,
            direction="charge" if tank.is_charge else "discharge",
            supply_pressure=(tank.stated_supply or tank.outside) if tank.is_charge else None,
            ambient_pressure=tank.room,
            ambient_temperature=tank.temperature,
            initial_temperature=tank.temperature,
            **changes,
        )
    )


@cache
def true_pressure(tank: EdgeTank) -> Array:
    return simulate(tank, np.linspace(0.0, tank.duration, tank.samples))


def identify_repeat(tank: EdgeTank, seed: int, **changes: Any) -> Result:
    """Identify one of several recordings of the same test, which differ in their noise."""
    shown = true_pressure(tank) + np.random.default_rng([24, seed]).normal(0.0, tank.noise, tank.samples)
    rounded = tank.step * np.round(shown / tank.step) if tank.step else shown
    return identify(tank, np.linspace(0.0, tank.duration, tank.samples), rounded, **changes)


@pytest.mark.parametrize("seed", [2, 3, 5, 7])
def test_coarse_sensor_does_not_select_a_thermal_limit(seed: int) -> None:
    result = identify_repeat(COARSE_CHARGE, seed)
    estimate = result.parameters[C]
    assert estimate.verdict != "determined"
    assert estimate.low <= COARSE_CHARGE.conductance <= estimate.high
    assert "finding.optima.heat" in {note.code for note in result.remarks}


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_small_leak_does_not_select_a_thermal_limit(seed: int) -> None:
    result = identify_repeat(LEAKY_ISOTHERMAL, seed)
    estimate = result.parameters[C]
    assert estimate.verdict != "determined"
    assert result.parameters[HA].verdict == "not determined"
    assert estimate.low <= LEAKY_ISOTHERMAL.conductance <= estimate.high
    (note,) = (note for note in result.remarks if note.code == "finding.optima.leak")
    assert note.address == C
    assert note.facts["value"] == pytest.approx(LEAKY_ISOTHERMAL.conductance, rel=0.02)
    assert note.facts["leak"] == pytest.approx(100.0 * LEAKY_ISOTHERMAL.leak / LEAKY_ISOTHERMAL.conductance, rel=0.2)


def test_leak_is_fraction_of_conductance_of_each_limit() -> None:
    """A leak of 2.9 % of the isothermal C is 4 % of the adiabatic C."""
    tank = draw(2867)
    estimate = identify(tank, *record(tank, 2867)).parameters[C]
    assert estimate.verdict != "determined"
    assert estimate.low <= tank.conductance <= estimate.high


@pytest.mark.parametrize("seed", range(4))
def test_budget_covers_leak_of_tank_that_empties(seed: int) -> None:
    """After closing at ambient pressure, warming drives gas through the leak; wall heat imitates this effect."""
    tank = draw(5552)
    parameters = identify_repeat(tank, seed).parameters
    for name, truth in ((C, tank.conductance), (B, tank.ratio), (HA, tank.wall)):
        assert abs(parameters[name].value - truth) < 3.0 * parameters[name].standard_error


def test_exact_leak_and_supply_leave_one_limit() -> None:
    result = identify_repeat(LEAKY_ISOTHERMAL, 0, uncertainties={"leak": 0, "supply_pressure": 0})
    assert "finding.optima.leak" not in {note.code for note in result.remarks}


@pytest.mark.parametrize("seed", CLEAN_CHARGES)
def test_clean_charge_remains_determined(seed: int) -> None:
    tank = replace(draw(seed, 2401), step=0.0, leak=0.0, stated_supply=None)
    estimate = identify(tank, *record(tank, seed)).parameters[C]
    assert tank.is_charge
    assert estimate.verdict == "determined"
    assert estimate.low <= tank.conductance <= estimate.high


def test_shared_ratio_has_no_wider_interval() -> None:
    """The choice between the thermal limits changes C, but not b."""
    tank = replace(draw(75, 2401), step=0.0, leak=0.0, stated_supply=None)
    result = identify(tank, *record(tank, 75), uncertainties=0)
    assert len(result.optima) > 1
    (first, *_), both = result.optima, result.parameters[B]
    assert both.high - both.low < 1.1 * (first["high"][B] - first["low"][B])


@pytest.mark.slow
@pytest.mark.parametrize(("tank", "limit"), [(COARSE_CHARGE, 2), (LEAKY_ISOTHERMAL, 0)])
def test_wrong_verdicts_of_repeated_charges(tank: EdgeTank, limit: int) -> None:
    estimates = [identify_repeat(tank, seed).parameters[C] for seed in range(40)]
    determined = [e for e in estimates if e.verdict == "determined"]
    print(f"{len(determined)} of 40 determined, {sum(e.low <= tank.conductance <= e.high for e in determined)} covered")
    assert sum(not e.low <= tank.conductance <= e.high for e in determined) <= limit


def random_coverage(count: int) -> dict[str, list[bool]]:
    """Return whether each determined value of C, b and wall conductance is covered, in random tests.

    Half of the tanks leak up to 3 % of C, and half of the charges have a supply that is off by up to 0.5 %.
    """
    covered: dict[str, list[bool]] = {C: [], B: [], HA: []}
    for seed in range(6000, 6000 + count):
        tank = draw(seed)
        parameters = identify(tank, *record(tank, seed)).parameters
        for name, truth in ((C, tank.conductance), (B, tank.ratio), (HA, tank.wall)):
            estimate = parameters[name]
            if estimate.verdict == "determined":
                assert abs(estimate.value - truth) < 5.0 * estimate.standard_error
                covered[name].append(estimate.low <= truth <= estimate.high)
    return covered


@pytest.mark.slow
def test_intervals_of_random_tests_cover_truth() -> None:
    for name, values in random_coverage(100).items():
        print(f"{name}: {sum(values)} of {len(values)} determined values covered")
        assert sum(values) >= binom.ppf(0.001, len(values), 0.93)
