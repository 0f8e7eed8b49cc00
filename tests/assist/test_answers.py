"""Answers of the written tasks, from their sources in plain floats: nothing of the package is imported."""

from __future__ import annotations

import tomllib
from math import exp, log, pi, radians, sin, sqrt
from pathlib import Path

import pytest

TASKS = tomllib.loads(Path(__file__).with_name("tasks.toml").read_text(encoding="utf-8"))["task"]
RHO, R, KAPPA, G, T = 1.185, 287.05, 1.4, 9.80665, 293.15
"""Density at ANR [kg/m^3], air, gravity [m/s^2] and temperature [K]."""


def choked(conductance: float, pressure: float) -> float:
    """Mass flow rate [kg/s] by ISO 6358-1 at 20 degC, for C in dm^3/(s bar) and p1 in bar."""
    return conductance * 1e-8 * RHO * pressure * 1e5


def tau(litres: float, conductance: float) -> float:
    """Time constant of an isothermal discharge with choked flow [s]."""
    return litres * 1e-3 / (conductance * 1e-8 * RHO * R * T)


def filled(litres: float, conductance: float) -> float:
    """Time of an isothermal fill from 1 bar to 2 bar by choked flow from 8 bar [s]."""
    return litres * 1e-3 * 1e5 / (choked(conductance, 8.0) * R * T)


def helium() -> float:
    kappa, gas = 5.0 / 3.0, 2077.1
    shape = (2.0 / (kappa + 1.0)) ** ((kappa + 1.0) / (2.0 * (kappa - 1.0)))
    return 1e3 * 5e-6 * 4e5 * sqrt(kappa / (gas * T)) * shape


def middle_pressure() -> float:
    """Pressure between two equal valves with b = 0.5, of which the second is choked [bar], by bisection."""
    low, high = 3.0, 6.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        through_first = 6.0 * sqrt(1.0 - ((middle / 6.0 - 0.5) / 0.5) ** 2)
        low, high = (middle, high) if through_first > middle else (low, middle)
    return low


def charged() -> float:
    """Temperature of an adiabatic charge from 1 bar to 7 bar [degC], from the masses and the enthalpy of the supply."""
    volume, cv = 2e-3, R / (KAPPA - 1.0)
    before = 1e5 * volume / (R * T)
    # Internal energy: U1 + kappa cv T dm = U2, with U = p V / (kappa - 1).
    added = (7e5 - 1e5) * volume / (KAPPA - 1.0) / (KAPPA * cv * T)
    return 7e5 * volume / (R * (before + added)) - 273.15


ANSWERS = {
    "choked": 1e3 * choked(1.0, 7.0),
    "subsonic": 1e3 * choked(1.0, 5.0) * sqrt(1.0 - ((0.8 - 0.3) / 0.7) ** 2),
    "hot": 1e3 * choked(1.0, 7.0) * sqrt(T / (80.0 + 273.15)),
    "nominal": 500.0,
    "helium": helium(),
    "series": middle_pressure(),
    "discharge_half": tau(10.0, 0.1) * log(2.0),
    "fill_time": filled(10.0, 0.1),
    "adiabatic_time": tau(5.0, 0.2) * 2.0 / (KAPPA - 1.0) * (2.0 ** ((KAPPA - 1.0) / (2.0 * KAPPA)) - 1.0),
    "adiabatic_temperature": T * 0.5 ** ((KAPPA - 1.0) / KAPPA) - 273.15,
    "charge_temperature": charged(),
    "equalise": (7.0 * 2.0 + 1.0 * 6.0) / 8.0,
    "equalise_adiabatic": (9.0 * 1.0 + 1.0 * 3.0) / 4.0,
    "mass": 1e3 * 7e5 * 20e-3 / (R * T),
    "source": 1.0 + 1e-5 * 1e-3 * 10.0 * R * T / 20e-3,
    "cooling": 20.0 + 60.0 * exp(-3.53957242 * 2.0 / (1e5 * 10e-3 / (R * 353.15) * R / (KAPPA - 1.0))),
    "cooled_pressure": 2.0 * T / 353.15,
    "fall": 1e3 * 0.5 * G * 0.5**2,
    "terminal": 1e3 * 50.0 / 100.0,
    "incline": 0.5 * G * sin(radians(30.0)) * 1.0**2,
    "angle": 0.5 * 0.4 / 0.1 * 0.5**2 * 180.0 / pi,
    "piston_force": pi / 4.0 * 0.05**2 * 6e5,
    "load_pressure": 1e-5 * 40.0 * G / (pi / 4.0 * 0.032**2),
    "size_valve": 0.1 * filled(10.0, 0.1) / 5.0,
    "size_tank": 10.0 * 5.0 / filled(10.0, 0.1),
    "size_catalogue": min(t for t in (filled(10.0, c) for c in (0.2, 0.3)) if t < 5.0),
    "yield": (13.162352 / filled(1.0, 0.1) - 9.0) / (11.0 - 9.0),
    "identify_flow": 2.0,
    "identify_tank": 0.3,
    "leak_cost": 2 * 0.045 * 60 * 6000 * 0.12 * 0.25,
    "bag": pi / 4.0 * 3.0**2 * 5.0 / 12.0 * 60.0,
    "exergy": 6e5 * 10e-3 * log(7.0),
    "exhaust": tau(5.0, 1.0) * log(7.0 / 3.5),
    "cycle": 4 * 0.5,
    "errors": 3,
    "repair": 1e3 * choked(1.0, 7.0),
}


@pytest.mark.parametrize("task", TASKS, ids=lambda task: task["id"])
def test_the_answer_is_that_of_its_source(task):
    assert task["answer"] == pytest.approx(ANSWERS[task["id"]], rel=1e-6)
    assert task["source"]


def test_each_answer_belongs_to_a_task():
    assert {task["id"] for task in TASKS} == ANSWERS.keys()
