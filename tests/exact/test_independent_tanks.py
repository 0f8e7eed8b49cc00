"""The independent tank tests against closed forms, and against their own balances of mass and energy."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import cumulative_simpson

from exact.independent_tanks import (
    CP,
    CV,
    DENSITY_ANR,
    GAS_CONSTANT,
    KAPPA,
    ROOM,
    Tank,
    course,
    drawn,
    mass_flow,
    recorded,
)

PLAIN = Tank(
    is_charge=False,
    volume=0.02,
    conductance=1e-8,
    ratio=0.3,
    wall=0.0,
    begin=7e5,
    outside=1e5,
    closes=1e6,
    duration=30.0,
)
TAU = PLAIN.volume / (PLAIN.conductance * DENSITY_ANR * GAS_CONSTANT * ROOM)
ISOTHERMAL = 1e7
"""W/K, a thousand times what the flow needs for a hundredth of a kelvin."""


def test_choked_discharge_without_heat() -> None:
    time = np.linspace(0.0, 0.5 * TAU, 50)
    pressure, temperature, _ = course(PLAIN, time)
    cooling = 1.0 + 0.5 * (KAPPA - 1.0) * time / TAU
    assert pressure[-1] > PLAIN.outside / PLAIN.ratio
    assert pressure == pytest.approx(PLAIN.begin * cooling ** (-2.0 * KAPPA / (KAPPA - 1.0)), rel=1e-8)
    assert temperature == pytest.approx(ROOM * cooling**-2.0, rel=1e-8)


def test_choked_isothermal_discharge() -> None:
    time = np.linspace(0.0, 0.7 * TAU, 50)
    pressure, _, _ = course(replace(PLAIN, wall=ISOTHERMAL), time)
    assert pressure == pytest.approx(PLAIN.begin * np.exp(-time / TAU), rel=1e-6)


@pytest.mark.parametrize(("wall", "rate"), [(0.0, KAPPA), (ISOTHERMAL, 1.0)])
def test_charge_is_a_line_and_a_sine(wall: float, rate: float) -> None:
    """Adiabatic and isothermal alike, kappa times as fast without heat: the twins that pressure cannot tell apart."""
    tank = replace(PLAIN, is_charge=True, begin=2.8e5, outside=7e5, ratio=0.45, wall=wall)
    choked = (tank.ratio - 0.4) * TAU / rate
    end = choked + 0.5 * np.pi * (1.0 - tank.ratio) * TAU / rate
    time = np.array([0.0, 0.5 * choked, *np.linspace(choked, end, 40), 1.2 * end, 2.0 * end])
    angle = np.clip(rate * (time - choked) / TAU / (1.0 - tank.ratio), 0.0, 0.5 * np.pi)
    line = 0.4 + rate * np.minimum(time, choked) / TAU
    expected = tank.outside * (line + (1.0 - tank.ratio) * np.sin(angle))
    assert course(tank, time)[0] == pytest.approx(expected, rel=2e-6)


def test_twins_have_one_pressure() -> None:
    tank = replace(drawn(0), temperature_noise=None)
    assert tank.has_twin
    twin = replace(tank, conductance=KAPPA * tank.conductance, wall=ISOTHERMAL)
    time = np.linspace(0.0, tank.duration, 200)
    assert course(twin, time)[0] == pytest.approx(course(tank, time)[0], rel=1e-5)


@pytest.mark.parametrize("seed", range(8))
def test_mass_and_energy_are_conserved(seed: int) -> None:
    """With the flow and the heat added up from what was recorded, and not from what was integrated."""
    tank = drawn(seed)
    time = np.linspace(0.0, tank.closes, 20001)
    pressure, temperature, mass = course(tank, time)
    sign = 1.0 if tank.is_charge else -1.0
    upstream = np.full(time.size, tank.outside) if tank.is_charge else pressure
    hot = np.full(time.size, tank.source) if tank.is_charge else temperature
    states = zip(sign * (tank.outside - pressure), upstream, hot, strict=True)
    flow = np.array([sign * mass_flow(tank, float(drop), float(high), float(gas)) for drop, high, gas in states])
    heat = tank.wall * (ROOM - temperature)
    added = cumulative_simpson(flow, x=time, initial=0.0)
    warmed = cumulative_simpson(CP * hot * flow + heat, x=time, initial=0.0)
    assert mass - mass[0] == pytest.approx(added, abs=3e-6 * mass.max())
    energy = mass * CV * temperature
    assert energy - energy[0] == pytest.approx(warmed, abs=3e-6 * energy.max())


@pytest.mark.parametrize("seed", range(8))
def test_closed_tank_keeps_its_mass_and_goes_to_the_room(seed: int) -> None:
    tank = drawn(seed)
    time = np.array([0.0, tank.closes, *np.linspace(tank.closes, tank.duration, 9)[1:], 1e6])
    pressure, temperature, mass = course(tank, time)
    assert mass[1:] == pytest.approx(mass[1], rel=1e-9)
    assert pressure * tank.volume == pytest.approx(mass * GAS_CONSTANT * temperature, rel=1e-12)
    assert temperature[-1] == pytest.approx(ROOM if tank.wall else temperature[1], rel=1e-9)


def test_gauges_show_what_was_asked_for() -> None:
    tanks = {seed: drawn(seed) for seed in range(40)}
    fine = next(seed for seed, tank in tanks.items() if tank.offset and not tank.is_coarse)
    record, tank = recorded(tanks[fine], fine), tanks[fine]
    error = record["pressure"] - course(tank, record["time"])[0]
    assert np.mean(error) == pytest.approx(tank.offset, abs=4.0 * tank.noise / np.sqrt(error.size))
    assert np.std(error) == pytest.approx(tank.noise, rel=0.12)
    coarse = next(seed for seed, tank in tanks.items() if tank.is_coarse)
    assert np.unique(np.diff(np.unique(recorded(tanks[coarse], coarse)["pressure"]))).min() >= 0.999 * 1e6 / 1024
    assert recorded(tank, fine)["pressure"] == pytest.approx(record["pressure"], rel=0.0, abs=0.0)
