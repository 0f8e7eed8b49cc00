"""Measured vessels, predicted without fitting: heat is what lies between the two textbook limits.

Discharge: HydDown validation set `Air_790kPa_21mm` (MIT). Two tanks: CHE260 laboratory,
PeterL-Engineering/CHE260_Thermodynamics_Heat_Transfer (Apache-2.0).
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, FlowSource, Orifice
from poppet.signals import SampledSignal

DATA = Path(__file__).resolve().parents[3] / "shared" / "data"
PSI = 6894.757293168
needs_data = pytest.mark.skipif(not DATA.is_dir(), reason="the measured data are not beside this checkout")

DIAMETER, LENGTH = 0.200, 0.515
AREA = np.pi * DIAMETER * LENGTH + np.pi / 2.0 * DIAMETER**2


def discharge(**thermal: Any) -> Circuit:
    """16.2 litres at 7.9 bar and 298 K through a 2.71 mm orifice with the published discharge coefficient 0.84."""
    return Circuit(
        {
            "tank": Chamber(
                volume=np.pi / 4.0 * DIAMETER**2 * LENGTH,
                initial_pressure="7.9 bar",
                initial_temperature="298 K",
                **thermal,
            ),
            "orifice": Orifice(from_="tank", to="ambient", effective_area=0.84 * np.pi / 4.0 * 2.71e-3**2),
        }
    )


def seconds_to(circuit: Circuit, pressure: float) -> float:
    return float(circuit.simulate("60 s", stop_when=f"tank.pressure < {pressure} Pa").time[-1])


@needs_data
def test_the_measured_discharge_lies_between_adiabatic_and_isothermal() -> None:
    time, bar = np.loadtxt(DATA / "tank_discharge_16l" / "pressure.csv", delimiter=",", skiprows=2).T
    measured = float(np.interp(-2.0884, -bar, time))
    adiabatic, isothermal = seconds_to(discharge(), 2.0884e5), seconds_to(discharge(thermal="isothermal"), 2.0884e5)
    assert measured == pytest.approx(19.6, abs=0.05)
    assert adiabatic == pytest.approx(17.5, abs=0.1)
    assert isothermal == pytest.approx(22.2, abs=0.1)
    assert adiabatic < measured < isothermal


@needs_data
def test_free_convection_predicts_the_measured_discharge() -> None:
    """Nu = 0.13 Ra^(1/3) over the vessel's height, inner surface as the area: 5.7 kPa rms without any fit."""
    time, bar = np.loadtxt(DATA / "tank_discharge_16l" / "pressure.csv", delimiter=",", skiprows=2).T

    def rms(circuit: Circuit) -> float:
        recording = circuit.simulate("60 s", "0.01 s")
        return float(np.sqrt(np.mean((recording.interpolate("tank.pressure", time) - 1e5 * bar) ** 2)))

    wall = {"heat_transfer": "natural", "wall_area": AREA, "height": DIAMETER, "wall_temperature": "298 K"}
    convection = rms(discharge(**wall))
    assert convection < 8e3
    assert convection < 0.5 * min(rms(discharge()), rms(discharge(thermal="isothermal")))


def filled() -> Callable[[float], float]:
    """How far the filled tank is from its record, rms over the wall conductance; the flow meter is late by 1.3 s."""
    table = np.loadtxt(DATA / "two_tanks" / "fill_left.txt", skiprows=4)
    time, gauge, flow = table[:, 0], table[:, 3] * PSI, table[:, 5] / 6e4
    late = np.maximum(time - 1.3, 0.0)
    keep = np.concatenate([[True], np.diff(late) > 0.0])

    def rms(conductance: float) -> float:
        circuit = Circuit(
            {
                "inlet": FlowSource(to="tank", temperature="23.8 degC"),
                "tank": Chamber(
                    volume="7.5 l",
                    initial_pressure=101325.0 + float(np.mean(gauge[:50])),
                    initial_temperature="23.1 degC",
                    wall_conductance=conductance,
                    wall_temperature="23.8 degC",
                ),
            },
            {"inlet.mass_flow_rate": SampledSignal(late[keep], flow[keep], "fill_left.txt")},
        )
        recording = circuit.simulate(float(time[-1]), 0.1)
        return float(np.sqrt(np.mean((recording.interpolate("tank.pressure", time) - 101325.0 - gauge) ** 2)))

    return rms


@needs_data
def test_a_recorded_mass_flow_fills_the_measured_tank() -> None:
    """7.5 litres and 8 W/K are what other runs of the rig give."""
    rms = filled()
    assert rms(8.0) < 7e3
    assert rms(0.0) > 10.0 * rms(8.0)


@needs_data
def test_two_tanks_equalise_where_their_volume_ratio_says() -> None:
    table = np.loadtxt(DATA / "two_tanks" / "equalise_solenoid.txt", skiprows=4)
    left, right = 101325.0 + table[:, 3] * PSI, 101325.0 + table[:, 4] * PSI
    jump = int(np.argmax(-(left[5:] - left[:-5])))
    before, after = slice(jump - 60, jump - 10), slice(-200, None)
    high, low, end = left[before].mean(), right[before].mean(), 0.5 * (left[after].mean() + right[after].mean())
    ratio = (high - end) / (end - low)
    assert ratio == pytest.approx(0.54, abs=0.02)
    wall = {"wall_conductance": 8.0, "initial_temperature": "24 degC", "wall_temperature": "24 degC"}
    circuit = Circuit(
        {
            "left": Chamber(volume="7.5 l", initial_pressure=high, **wall),
            "valve": Orifice(from_="left", to="right", sonic_conductance=1e-8, critical_ratio=0.3),
            "right": Chamber(volume=7.5e-3 * 0.54, initial_pressure=low, **wall),
        }
    )
    recording = circuit.simulate("600 s")
    noise = 1.7e3
    assert abs(recording["left.pressure"][-1] - end) < noise
    assert abs(recording["right.pressure"][-1] - end) < noise
