"""Tests of equivalent optima: an adiabatic charge with C and an isothermal charge with kappa C."""

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
"""Wall conductance with 2e4 transfer units for this tank [W/K]."""


def identify_charge(
    tank: Tank, *, with_temperature: bool = False, profile: tuple[str, ...] = (), **changes: Any
) -> Result:
    """Identify a tank from 600 samples with noise of a fixed seed."""
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
        **changes,
    )
    return identify_tank(test, profile=profile)


def finding_codes(result: Result) -> set[str]:
    return {note.code for note in result.remarks}


def check_two_optima(result: Result) -> None:
    """Check that no optimum is determined, and that interval and result include both."""
    estimates = result.parameters
    assert {estimates[C].verdict, estimates[HA].verdict} == {"weak", "not determined"}
    assert estimates[C].low <= CHARGE.conductance < KAPPA * CHARGE.conductance <= estimates[C].high
    assert estimates[HA].low == 0.0
    assert estimates[HA].high > 1e3
    conductances = sorted(optimum["values"][C] for optimum in result.optima)
    assert conductances[-1] / conductances[0] == pytest.approx(KAPPA, rel=0.003)
    assert [optimum["excess"] < 1.0 for optimum in result.optima] == [True] * len(result.optima)
    assert result.optima[0]["values"] == {name: e.value for name, e in estimates.items()}
    (note,) = (note for note in result.remarks if note.code == "finding.optima.heat")
    assert note.address == C
    assert note.facts["factor"] == pytest.approx(KAPPA, rel=0.003)


def test_equivalent_tanks_have_equal_pressure() -> None:
    time = np.linspace(0.0, CHARGE.duration, 50)
    twin = replace(CHARGE, conductance=KAPPA * CHARGE.conductance, wall=ISOTHERMAL)
    # The remaining difference is due to the wall heat: 1/20000 of the difference of the two laws.
    assert np.max(np.abs(course(CHARGE, time)[0] - course(twin, time)[0])) < 20.0


@pytest.mark.parametrize("start", [1e-9, 1.9e-9, 2.6e-9, 4e-9])
@pytest.mark.parametrize("truth", ["adiabatic", "isothermal"])
def test_equivalent_optimum_is_found_from_any_start(start: float, truth: str) -> None:
    twin = replace(CHARGE, conductance=KAPPA * CHARGE.conductance, wall=ISOTHERMAL)
    tank = CHARGE if truth == "adiabatic" else twin
    check_two_optima(identify_charge(tank, sonic_conductance={"start": start}))


def test_bounds_select_one_optimum() -> None:
    result = identify_charge(CHARGE, sonic_conductance={"start": 1.9e-9, "max": 2.2e-9})
    assert result.parameters[C].verdict == "determined"
    assert len(result.optima) == 1


def test_coarse_sensor_does_not_select_optimum() -> None:
    """Use seed 120: little wall heat has the effect of the sensor steps near one of the two optima only."""
    tank = drawn(120)
    assert tank.is_coarse
    result = identify_tank(told(tank, 120))
    assert result.parameters[C].verdict != "determined"
    assert result.parameters[C].high > 1.39 * tank.conductance


@pytest.mark.parametrize("seed", [112, 160])
def test_sensor_offset_does_not_select_optimum(seed: int) -> None:
    """Check that little wall heat, equal to a sensor offset near one optimum, does not exclude the other."""
    tank = drawn(seed)
    assert tank.has_twin
    assert tank.offset != 0.0
    estimate = identify_tank(told(tank, seed)).parameters[C]
    assert estimate.verdict != "determined"
    assert estimate.low <= tank.conductance < KAPPA * tank.conductance <= estimate.high * 1.001


@pytest.mark.parametrize("wall", [0.0, ISOTHERMAL])
def test_discharge_selects_one_optimum(wall: float) -> None:
    result = identify_charge(replace(DISCHARGE, wall=wall))
    estimate = result.parameters[C]
    assert estimate.verdict == "determined"
    assert estimate.low <= CHARGE.conductance <= estimate.high
    assert "finding.optima.heat" not in finding_codes(result)


@pytest.mark.parametrize("wall", [0.0, 0.3])
def test_recorded_temperature_selects_one_optimum(wall: float) -> None:
    estimate = identify_charge(replace(CHARGE, wall=wall), with_temperature=True).parameters[C]
    assert estimate.verdict == "determined"
    assert estimate.low <= CHARGE.conductance <= estimate.high


def test_intermediate_wall_heat_selects_one_optimum() -> None:
    result = identify_charge(replace(CHARGE, wall=0.3))
    for name, truth in ((C, CHARGE.conductance), (B, CHARGE.ratio), (HA, 0.3)):
        assert result.parameters[name].verdict == "determined"
        assert result.parameters[name].low <= truth <= result.parameters[name].high
    assert len(result.optima) == 1


def test_known_thermal_law_selects_one_optimum() -> None:
    assert identify_charge(CHARGE, wall_conductance=0.0).parameters[C].value == pytest.approx(1.872e-9, rel=0.003)
    assert identify_charge(CHARGE, thermal="isothermal").parameters[C].value == pytest.approx(
        KAPPA * 1.872e-9, rel=0.003
    )


def test_profile_includes_equivalent_optimum() -> None:
    estimate = identify_charge(CHARGE, profile=(C,)).parameters[C]
    assert estimate.low == pytest.approx(CHARGE.conductance, rel=0.003)
    assert estimate.high == pytest.approx(KAPPA * CHARGE.conductance, rel=0.003)


@pytest.mark.parametrize("suffix", [".toml", ".json"])
def test_result_file_contains_optima(tmp_path: Path, suffix: str) -> None:
    result = identify_charge(CHARGE)
    result.save(tmp_path / f"result{suffix}")
    assert read_result(tmp_path / f"result{suffix}").optima == result.optima
