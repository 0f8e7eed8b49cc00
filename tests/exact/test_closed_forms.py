"""Simulated vessels against their closed forms, at solver tolerance up to the laminar ratio."""

from __future__ import annotations

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.laws.physics import tanks

C, B, V, T, HIGH, LOW = 1.65e-8, 0.4274, 0.2, 293.15, 7e5, 1e5
TOLERANCE = 1e-9
"""Relative tolerance of the runs; results must be within ten times it."""


def charging(thermal: str = "isothermal", **chamber: object) -> Circuit:
    return Circuit(
        {
            "supply": Reservoir(pressure=HIGH),
            "valve": Orifice(from_="supply", to="tank", sonic_conductance=C, critical_ratio=B),
            "tank": Chamber(volume=V, thermal=thermal, initial_pressure=LOW, **chamber),
        }
    )


def discharge(thermal: str, **chamber: object) -> Circuit:
    return Circuit(
        {
            "tank": Chamber(volume=V, thermal=thermal, initial_pressure=HIGH, **chamber),
            "valve": Orifice(from_="tank", to="ambient", sonic_conductance=C, critical_ratio=B),
        }
    )


def worst(found: np.ndarray, expected: np.ndarray) -> float:
    return float(np.max(np.abs(found / expected - 1.0)))


TAU = float(tanks.discharge_time_constant(V, C, T))
RATE = float(tanks.charging_rate(V, C, T, T))


def test_isothermal_choked_discharge() -> None:
    recording = discharge("isothermal").simulate(2.0 * TAU, 0.01 * TAU, TOLERANCE)
    choked = recording["tank.pressure"] * B >= LOW
    expected = tanks.isothermal_discharge_pressure(recording.time[choked], HIGH, TAU)
    assert choked.sum() > 50
    assert worst(recording["tank.pressure"][choked], expected) < 10 * TOLERANCE


def test_adiabatic_choked_discharge() -> None:
    recording = discharge("energy").simulate(2.0 * TAU, 0.01 * TAU, TOLERANCE)
    choked = recording["tank.pressure"] * B >= LOW
    expected = tanks.adiabatic_discharge_pressure(recording.time[choked], HIGH, TAU)
    assert choked.sum() > 50
    assert worst(recording["tank.pressure"][choked], expected) < 10 * TOLERANCE


def test_a_closed_gas_discharging_adiabatically_stays_on_its_isentrope() -> None:
    recording = discharge("energy").simulate(2.0 * TAU, 0.01 * TAU, TOLERANCE)
    outside = recording["tank.pressure"] >= LOW / 0.999
    expected = tanks.isentrope_temperature(recording["tank.pressure"], HIGH, T)
    assert outside.sum() > 100
    assert worst(recording["tank.temperature"][outside], expected[outside]) < 10 * TOLERANCE


def test_isothermal_charging_up_to_the_laminar_ratio() -> None:
    recording = charging().simulate(2.2 / RATE, 0.01 / RATE, TOLERANCE)
    before = recording["tank.pressure"] <= 0.999 * HIGH
    expected = tanks.charging_pressure(recording.time[before], LOW, HIGH, B, RATE)
    assert before.sum() > 100
    assert worst(recording["tank.pressure"][before], expected) < 10 * TOLERANCE


def test_adiabatic_charging_is_isothermal_charging_kappa_times_as_fast() -> None:
    recording = charging("energy").simulate(1.5 / RATE, 0.01 / RATE, TOLERANCE)
    before = recording["tank.pressure"] <= 0.999 * HIGH
    expected = tanks.charging_pressure(recording.time[before], LOW, HIGH, B, 1.4 * RATE)
    assert worst(recording["tank.pressure"][before], expected) < 10 * TOLERANCE
    warm = tanks.adiabatic_charging_temperature(recording["tank.pressure"][before], LOW, T, T)
    assert worst(recording["tank.temperature"][before], warm) < 10 * TOLERANCE


def test_isothermal_charging_with_a_warm_supply() -> None:
    warm = 350.0
    circuit = charging().with_values({"supply.temperature": warm})
    rate = float(tanks.charging_rate(V, C, T, warm))
    recording = circuit.simulate(1.0 / rate, 0.01 / rate, TOLERANCE)
    before = recording["tank.pressure"] <= 0.999 * HIGH
    expected = tanks.charging_pressure(recording.time[before], LOW, HIGH, B, rate)
    assert worst(recording["tank.pressure"][before], expected) < 10 * TOLERANCE


@pytest.mark.parametrize(
    ("thermal", "wall", "seconds"),
    [
        ("isothermal", 0.0, 71.11),
        ("isentrope", 0.0, 38.22),
        ("energy", 0.0, 50.79),
        ("energy", 30.0, 63.51),
        ("energy", 100.0, 68.32),
    ],
)
def test_time_from_1_to_5_bar(thermal: str, wall: float, seconds: float) -> None:
    circuit = Circuit(
        {
            "supply": Reservoir(pressure=HIGH),
            "valve": Orifice(from_="supply", to="tank", characteristic="varga2012", stroke="0.5 mm"),
            "tank": Chamber(volume=V, thermal=thermal, initial_pressure=LOW, wall_conductance=wall),
        }
    )
    recording = circuit.simulate("120 s", stop_when="tank.pressure > 5 bar")
    assert recording["tank.pressure"][-1] == pytest.approx(5e5, rel=1e-9)
    assert recording.time[-1] == pytest.approx(seconds, rel=1e-3)
    if wall == 0.0:
        final = {"isothermal": 293.15, "isentrope": 464.3, "energy": 380.009}[thermal]
        assert recording["tank.temperature"][-1] == pytest.approx(final, abs=0.05)


def test_time_to_full_converges_as_the_laminar_ratio_approaches_one() -> None:
    """The closed form is full at a finite time; with a laminar zone the rest decays. First order in its width."""
    full = float(tanks.charging_time(HIGH, LOW, HIGH, B, RATE))
    errors = []
    for ratio in (0.99, 0.999, 0.9999, 0.99999):
        recording = charging().with_values({"valve.laminar_ratio": ratio}).simulate(full, full / 10, 1e-10)
        errors.append(abs(recording["tank.pressure"][-1] / HIGH - 1.0))
    slopes = np.diff(np.log10(errors)) / -1.0
    assert np.all(slopes > 0.95), (errors, slopes)
    assert np.all(slopes < 1.1), (errors, slopes)


def test_two_isothermal_vessels_equalise_at_the_common_pressure() -> None:
    circuit = Circuit(
        {
            "left": Chamber(volume="2 l", thermal="isothermal", initial_pressure="6 bar"),
            "link": Orifice(from_="left", to="right", sonic_conductance=1e-9, critical_ratio=0.3),
            "right": Chamber(volume="3 l", thermal="isothermal", initial_pressure="1 bar"),
        }
    )
    recording = circuit.simulate("60 s")
    for name in ("left", "right"):
        assert recording[f"{name}.pressure"][-1] == pytest.approx(3e5, rel=1e-9)


def test_two_adiabatic_vessels_equalise_at_the_common_pressure_and_keep_their_energy() -> None:
    circuit = Circuit(
        {
            "left": Chamber(volume="2 l", initial_pressure="6 bar"),
            "link": Orifice(from_="left", to="right", sonic_conductance=1e-9, critical_ratio=0.3),
            "right": Chamber(volume="3 l", initial_pressure="1 bar"),
        }
    )
    recording = circuit.simulate("60 s", relative_tolerance=TOLERANCE)
    # (p V)/(kappa - 1) is the internal energy: the mean pressure does not change.
    assert recording["left.pressure"][-1] == pytest.approx(3e5, rel=1e-7)
    assert recording["right.pressure"][-1] == pytest.approx(3e5, rel=1e-7)
    # What stays behind has expanded on its isentrope; in the laminar zone some of the warmer gas mixes in.
    expected = tanks.isentrope_temperature(recording["left.pressure"], 6e5, T)
    outside = recording["right.pressure"] <= 0.999 * recording["left.pressure"]
    assert worst(recording["left.temperature"][outside], expected[outside]) < 10 * TOLERANCE
    assert recording["left.temperature"][-1] == pytest.approx(expected[-1], rel=1e-4)


def test_the_temperature_after_equalising_converges_as_the_laminar_ratio_approaches_one() -> None:
    full = tanks.adiabatic_charging_temperature(HIGH, LOW, T, T)
    errors = []
    for ratio in (0.99, 0.999, 0.9999):
        recording = (
            charging("energy")
            .with_values({"valve.laminar_ratio": ratio})
            .simulate(3.0 / RATE, relative_tolerance=1e-11)
        )
        errors.append(abs(recording["tank.temperature"][-1] / full - 1.0))
    slopes = -np.diff(np.log10(errors))
    assert np.all(slopes > 0.95), (errors, slopes)
    assert np.all(slopes < 1.1), (errors, slopes)


def test_a_wall_heats_the_gas_exponentially() -> None:
    """A source of vanishing flow leaves a closed vessel: m cv dT/dt = h A (Tw - T)."""
    from poppet import FlowSource

    circuit = Circuit(
        {
            "source": FlowSource(to="tank", mass_flow_rate=0.0),
            "tank": Chamber(
                volume="10 l", initial_pressure="3 bar", initial_temperature="350 K", wall_conductance=2.0,
                wall_temperature="300 K",
            ),
        }
    )  # fmt: skip
    recording = circuit.simulate("60 s", "0.5 s", TOLERANCE)
    mass = 3e5 * 0.01 / (287.05 * 350.0)
    rate = 2.0 / (mass * 287.05 / 0.4)
    expected = 300.0 + 50.0 * np.exp(-rate * recording.time)
    assert worst(recording["tank.temperature"], expected) < 10 * TOLERANCE
    assert worst(recording["tank.pressure"], mass * 287.05 * expected / 0.01) < 10 * TOLERANCE


def test_gas_and_wall_reach_their_common_temperature() -> None:
    from poppet import FlowSource

    circuit = Circuit(
        {
            "source": FlowSource(to="tank", mass_flow_rate=0.0),
            "tank": Chamber(
                volume="10 l", initial_pressure="3 bar", initial_temperature="400 K", wall_conductance=2.0,
                wall_temperature="300 K", wall_heat_capacity="50 J/K",
            ),
        }
    )  # fmt: skip
    recording = circuit.simulate("300 s", relative_tolerance=TOLERANCE)
    gas = 3e5 * 0.01 / (287.05 * 400.0) * 287.05 / 0.4
    common = (gas * 400.0 + 50.0 * 300.0) / (gas + 50.0)
    assert recording["tank.temperature"][-1] == pytest.approx(common, rel=1e-8)
    assert recording["tank.wall_temperature"][-1] == pytest.approx(common, rel=1e-8)


@pytest.mark.parametrize("exponent", [0.9, 1.0, 1.2, 1.4])
def test_polytropic_vessel_stays_on_its_polytrope(exponent: float) -> None:
    recording = charging("polytropic", polytropic_exponent=exponent).simulate("80 s", "1 s", TOLERANCE)
    density = recording["tank.mass"] / recording["tank.mass"][0]
    assert worst(recording["tank.pressure"], LOW * density**exponent) < 1e-12
    gas_law = recording["tank.mass"] * 287.05 * recording["tank.temperature"] / V
    assert worst(recording["tank.pressure"], gas_law) < 1e-12


@pytest.mark.parametrize("thermal", ["isothermal", "isentrope", "polytropic"])
def test_other_thermal_laws_report_the_heat_they_imply(thermal: str) -> None:
    """d(m cv T) = sum H + Q, with Q integrated from the reported heat flow rate."""
    more = {"polytropic_exponent": 1.2} if thermal == "polytropic" else {}
    recording = charging(thermal, **more).simulate("60 s", "0.01 s", 1e-10)
    energy = recording["tank.mass"] * recording["tank.temperature"] * 287.05 / 0.4
    enthalpy = 1.4 / 0.4 * 287.05 * T * (recording["tank.mass"] - recording["tank.mass"][0])
    heat = recording["tank.heat_flow_rate"]
    integral = np.concatenate([[0.0], np.cumsum(0.5 * (heat[1:] + heat[:-1]) * np.diff(recording.time))])
    residual = energy - energy[0] - enthalpy - integral
    assert np.max(np.abs(residual)) < 1e-6 * (energy[-1] - energy[0])
