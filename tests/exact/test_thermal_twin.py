"""The exact twin: gas from a fixed supply fills an adiabatic tank, and an isothermal one with kappa C."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from exact.independent_tanks import AIR, KAPPA, ROOM, Tank, course, drawn
from exact.test_independent_coverage import told
from poppet.identify import Result, TankTest, identify_tank, read_result

C, B, HA = "valve.sonic_conductance", "valve.critical_ratio", "tank.wall_conductance"
CHARGE = Tank(True, 5.517e-3, 1.872e-9, 0.3, 0.0, 101_534.0, 673_666.0, closes=46.9, duration=70.0, noise=107.0)
DISCHARGE = replace(CHARGE, is_charge=False, begin=673_666.0, outside=AIR)
ISOTHERMAL = 2e4
"""W/K, 2e4 transfer units of this tank."""


def identified(tank: Tank, *, with_temperature: bool = False, profile: tuple[str, ...] = (), **more: Any) -> Result:
    """A test of 600 samples with noise of a fixed seed."""
    generator, time = np.random.default_rng(0), np.linspace(0.0, tank.duration, 600)
    pressure, temperature, _ = course(tank, time)
    recording = {"time": time, "tank.pressure": pressure + generator.normal(0.0, tank.noise, 600)}
    if with_temperature:
        recording["tank.temperature"] = temperature + generator.normal(0.0, 0.5, 600)
    test = TankTest(
        recordings={"test": {**recording, "closes": tank.closes}},
        volume=tank.volume,
        direction="charge" if tank.is_charge else "discharge",
        supply_pressure=tank.outside if tank.is_charge else None,
        ambient_pressure=AIR,
        ambient_temperature=ROOM,
        initial_temperature=ROOM,
        **more,
    )
    return identify_tank(test, profile=profile)


def codes(result: Result) -> set[str]:
    return {note.code for note in result.remarks}


def check_twin(result: Result) -> None:
    """Neither is called determined, the interval holds both, and both are shown."""
    found = result.parameters
    assert {found[C].verdict, found[HA].verdict} == {"weak", "not determined"}
    assert found[C].low <= CHARGE.conductance < KAPPA * CHARGE.conductance <= found[C].high
    assert found[HA].low == 0.0
    assert found[HA].high > 1e3
    conductances = sorted(optimum["values"][C] for optimum in result.optima)
    assert conductances[-1] / conductances[0] == pytest.approx(KAPPA, rel=0.003)
    assert [optimum["excess"] < 1.0 for optimum in result.optima] == [True] * len(result.optima)
    assert result.optima[0]["values"] == {name: e.value for name, e in found.items()}
    (note,) = (note for note in result.remarks if note.code == "finding.optima.heat")
    assert note.address == C
    assert note.facts["factor"] == pytest.approx(KAPPA, rel=0.003)


def test_the_twins_have_the_same_pressure_at_all_times() -> None:
    time = np.linspace(0.0, CHARGE.duration, 50)
    twin = replace(CHARGE, conductance=KAPPA * CHARGE.conductance, wall=ISOTHERMAL)
    # What is left is the last hair of wall heat: 1/20000 of the difference of the two laws.
    assert np.max(np.abs(course(CHARGE, time)[0] - course(twin, time)[0])) < 20.0


@pytest.mark.parametrize("start", [1e-9, 1.9e-9, 2.6e-9, 4e-9])
@pytest.mark.parametrize("truth", ["adiabatic", "isothermal"])
def test_a_twin_is_never_determined_wherever_the_search_begins(start: float, truth: str) -> None:
    twin = replace(CHARGE, conductance=KAPPA * CHARGE.conductance, wall=ISOTHERMAL)
    tank = CHARGE if truth == "adiabatic" else twin
    check_twin(identified(tank, sonic_conductance={"start": start}))


def test_bounds_of_the_user_decide() -> None:
    result = identified(CHARGE, sonic_conductance={"start": 1.9e-9, "max": 2.2e-9})
    assert result.parameters[C].verdict == "determined"
    assert len(result.optima) == 1


def test_a_coarse_gauge_does_not_decide_by_its_steps() -> None:
    """Seed 120: a hair of wall heat imitates the steps of the tail, on one of the two branches only."""
    tank = drawn(120)
    assert tank.is_coarse
    result = identify_tank(told(tank, 120))
    assert result.parameters[C].verdict != "determined"
    assert result.parameters[C].high > 1.39 * tank.conductance


@pytest.mark.parametrize("seed", [112, 160])
def test_a_hidden_offset_does_not_decide(seed: int) -> None:
    """A hair of wall heat imitates the offset of a gauge over the tail, on one of the two branches only."""
    tank = drawn(seed)
    assert tank.has_twin
    assert tank.offset != 0.0
    found = identify_tank(told(tank, seed)).parameters[C]
    assert found.verdict != "determined"
    assert found.low <= tank.conductance < KAPPA * tank.conductance <= found.high * 1.001


@pytest.mark.parametrize("wall", [0.0, ISOTHERMAL])
def test_a_discharge_parts_the_twins(wall: float) -> None:
    result = identified(replace(DISCHARGE, wall=wall))
    found = result.parameters[C]
    assert found.verdict == "determined"
    assert found.low <= CHARGE.conductance <= found.high
    assert "finding.optima.heat" not in codes(result)


@pytest.mark.parametrize("wall", [0.0, 0.3])
def test_a_recorded_temperature_parts_the_twins(wall: float) -> None:
    found = identified(replace(CHARGE, wall=wall), with_temperature=True).parameters[C]
    assert found.verdict == "determined"
    assert found.low <= CHARGE.conductance <= found.high


def test_wall_heat_between_the_ends_parts_the_twins() -> None:
    result = identified(replace(CHARGE, wall=0.3))
    for name, truth in ((C, CHARGE.conductance), (B, CHARGE.ratio), (HA, 0.3)):
        assert result.parameters[name].verdict == "determined"
        assert result.parameters[name].low <= truth <= result.parameters[name].high
    assert len(result.optima) == 1


def test_a_known_thermal_law_decides() -> None:
    assert identified(CHARGE, wall_conductance=0.0).parameters[C].value == pytest.approx(1.872e-9, rel=0.003)
    assert identified(CHARGE, thermal="isothermal").parameters[C].value == pytest.approx(KAPPA * 1.872e-9, rel=0.003)


def test_a_profile_goes_on_to_the_twin() -> None:
    found = identified(CHARGE, profile=(C,)).parameters[C]
    assert found.low == pytest.approx(CHARGE.conductance, rel=0.003)
    assert found.high == pytest.approx(KAPPA * CHARGE.conductance, rel=0.003)


@pytest.mark.parametrize("suffix", [".toml", ".json"])
def test_a_result_file_keeps_the_optima(tmp_path: Path, suffix: str) -> None:
    result = identified(CHARGE)
    result.save(tmp_path / f"result{suffix}")
    assert read_result(tmp_path / f"result{suffix}").optima == result.optima
