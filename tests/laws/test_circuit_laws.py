"""Laws that every circuit keeps, whatever its numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet import Circuit
from poppet.parts import Chamber, CheckValve, Orifice, Reservoir
from poppet.timeseries.recording import Recording

few = settings(derandomize=True, deadline=None, max_examples=25)

pressures = st.floats(0.2e5, 12e5)
temperatures = st.floats(240.0, 400.0)
volumes = st.floats(1e-5, 1e-1)
conductances = st.floats(1e-10, 5e-8)
ratios = st.floats(0.1, 0.6)
indices = st.floats(0.45, 0.6)
laws = st.sampled_from(
    [
        {"thermal": "energy"},
        {"thermal": "energy", "wall_conductance": 5.0},
        {"thermal": "isothermal"},
        {"thermal": "isentrope"},
    ]
)
vessels = st.fixed_dictionaries({"volume": volumes, "initial_pressure": pressures, "initial_temperature": temperatures})
restrictions = st.fixed_dictionaries(
    {"sonic_conductance": conductances, "critical_ratio": ratios, "subsonic_index": indices}
)


def orifice(first: str, second: str, size: dict[str, float]) -> Orifice:
    return Orifice(from_=first, to=second, **size)


def two_tanks(one: dict[str, Any], two: dict[str, Any], size: dict[str, float], law: dict[str, Any]) -> Circuit:
    return Circuit({"one": Chamber(**one, **law), "joint": orifice("one", "two", size), "two": Chamber(**two, **law)})


def span(*parts: dict[str, float]) -> float:
    """A few time constants V/(C rho0 R T) of the smallest tank behind the smallest restriction."""
    volume = min(part["volume"] for part in parts if "volume" in part)
    conductance = min(part["sonic_conductance"] for part in parts if "sonic_conductance" in part)
    return 5.0 * volume / (conductance * 1.185 * 287.05 * 293.15)


@few
@given(vessels, vessels, vessels, restrictions, restrictions, restrictions)
def test_mass_and_energy_are_kept_in_a_closed_ring(one, two, three, a, b, c):
    circuit = Circuit(
        {
            "one": Chamber(**one),
            "two": Chamber(**two),
            "three": Chamber(**three),
            "a": orifice("one", "two", a),
            "b": orifice("two", "three", b),
            "c": CheckValve(from_="three", to="one", **c),
        }
    )
    recording = circuit.simulate(span(one, two, three, a, b, c))
    mass = sum(recording[f"{name}.mass"] for name in ("one", "two", "three"))
    energy = sum(
        recording[f"{name}.pressure"] * tank["volume"] / 0.4
        for name, tank in (("one", one), ("two", two), ("three", three))
    )
    assert np.abs(mass / mass[0] - 1.0).max() < 1e-12
    assert np.abs(energy / energy[0] - 1.0).max() < 1e-11
    assert all(residual.is_kept for residual in recording.residuals)


@few
@given(vessels, vessels, restrictions, laws)
def test_every_store_keeps_its_books(one, two, size, law):
    recording = two_tanks(one, two, size, law).simulate(span(one, two, size))
    names = [residual.name for residual in recording.residuals]
    assert names == (
        ["one mass", "one energy", "two mass", "two energy"] if law["thermal"] == "energy" else ["one mass", "two mass"]
    )
    assert all(residual.is_kept for residual in recording.residuals)


@few
@given(vessels, vessels, restrictions)
def test_flow_runs_from_high_to_low_pressure(one, two, size):
    recording = two_tanks(one, two, size, {"thermal": "isothermal"}).simulate(span(one, two, size))
    drop = recording["one.pressure"] - recording["two.pressure"]
    clear = np.abs(drop) > 1e-9 * recording["one.pressure"]
    assert np.all((recording["joint.mass_flow_rate"] * drop)[clear] > 0.0)


def entropy(recording: Recording, name: str) -> np.ndarray:
    """m (cp ln T - R ln p)."""
    pressure, temperature = recording[f"{name}.pressure"], recording[f"{name}.temperature"]
    return np.asarray(recording[f"{name}.mass"] * (1004.675 * np.log(temperature) - 287.05 * np.log(pressure)))


@few
@given(vessels, vessels, restrictions)
def test_entropy_never_falls_in_a_closed_adiabatic_circuit(one, two, size):
    """Second law, in the regularised zone too."""
    recording = two_tanks(one, two, size, {"thermal": "energy"}).simulate(span(one, two, size), relative_tolerance=1e-8)
    total = entropy(recording, "one") + entropy(recording, "two")
    mass = recording["one.mass"][0] + recording["two.mass"][0]
    assert np.diff(total).min() > -1e-6 * mass * 287.05
    assert total[-1] - total[0] > -1e-6 * mass * 287.05


@few
@given(pressures, volumes, volumes, restrictions, st.floats(250.0, 290.0), st.floats(300.0, 400.0))
def test_no_heat_from_cold_to_hot_at_equal_pressure(pressure, first, second, size, cold, hot):
    """Two tanks at rest at one pressure: nothing flows, whatever their temperatures."""
    one = {"volume": first, "initial_pressure": pressure, "initial_temperature": cold}
    two = {"volume": second, "initial_pressure": pressure, "initial_temperature": hot}
    recording = two_tanks(one, two, size, {"thermal": "energy"}).simulate(span(one, two, size))
    assert np.abs(recording["one.temperature"] / cold - 1.0).max() < 1e-9
    assert np.abs(recording["two.temperature"] / hot - 1.0).max() < 1e-9


@few
@given(temperatures, temperatures, st.floats(0.1, 50.0))
def test_heat_runs_from_hot_to_cold(gas, wall, conductance):
    tank = Chamber(volume=0.01, initial_temperature=gas, wall_temperature=wall, wall_conductance=conductance)
    closed = CheckValve(from_="tank", to="sink", sonic_conductance=1e-8, critical_ratio=0.3, cracking_pressure=1e8)
    recording = Circuit({"tank": tank, "valve": closed, "sink": Reservoir(pressure=1e5)}).simulate(5.0)
    temperature = recording["tank.temperature"]
    assert np.all(recording["tank.heat_flow_rate"] * (wall - temperature) >= 0.0)
    low, high = min(gas, wall), max(gas, wall)
    assert low - 1e-6 * low <= temperature.min()
    assert temperature.max() <= high + 1e-6 * high


@few
@given(vessels, vessels, restrictions, laws)
def test_turning_a_restriction_round_changes_the_sign_only(one, two, size, law):
    there = two_tanks(one, two, size, law)
    back = Circuit({**there.parts, "joint": orifice("two", "one", size)})
    duration = span(one, two, size)
    first, second = there.simulate(duration), back.simulate(duration)
    for name in ("one.pressure", "two.pressure"):
        assert second[name] == pytest.approx(first[name], rel=1e-9)
    scale = np.abs(first["joint.mass_flow_rate"]).max()
    assert second["joint.mass_flow_rate"] == pytest.approx(
        -first["joint.mass_flow_rate"], rel=1e-7, abs=1e-9 * scale + 1e-30
    )


def filling(tank: dict[str, Any], size: dict[str, float], duration: float, supply: float = 13e5) -> Recording:
    parts = {"supply": Reservoir(pressure=supply), "fill": orifice("supply", "tank", size), "tank": Chamber(**tank)}
    return Circuit(parts).simulate(duration, duration / 50.0, 1e-8)


@few
@given(vessels, restrictions, st.floats(0.05, 20.0), st.floats(0.0, 20.0))
def test_conductances_and_volume_scaled_together_leave_the_pressure(tank, size, factor, wall):
    """C, V and h A enter only as ratios: p(t) alone cannot tell their size."""
    duration = span(tank, size)
    wall = wall * tank["volume"] / 1e-2
    one = filling({**tank, "wall_conductance": wall}, size, duration)
    scaled = {**tank, "volume": factor * tank["volume"], "wall_conductance": factor * wall}
    two = filling(scaled, size | {"sonic_conductance": factor * size["sonic_conductance"]}, duration)
    assert two["tank.pressure"] == pytest.approx(one["tank.pressure"], rel=1e-7)
    assert two["tank.temperature"] == pytest.approx(one["tank.temperature"], rel=1e-7)


@few
@given(vessels, restrictions, st.floats(0.05, 20.0), laws.filter(lambda law: "wall_conductance" not in law))
def test_time_scales_with_volume_over_conductance(tank, size, factor, law):
    duration = span(tank, size)
    one = filling({**tank, **law}, size, duration)
    two = filling({**tank, **law, "volume": factor * tank["volume"]}, size, factor * duration)
    three = filling(
        {**tank, **law}, size | {"sonic_conductance": size["sonic_conductance"] / factor}, factor * duration
    )
    for other in (two, three):
        assert other["tank.pressure"] == pytest.approx(one["tank.pressure"], rel=1e-7)


@few
@given(vessels, restrictions, st.floats(0.5, 3.0))
def test_pressures_scale_together(tank, size, factor):
    """The law is homogeneous of degree one in the pressures."""
    duration = span(tank, size)
    one = filling(tank, size, duration)
    two = filling({**tank, "initial_pressure": factor * tank["initial_pressure"]}, size, duration, factor * 13e5)
    assert two["tank.pressure"] == pytest.approx(factor * one["tank.pressure"], rel=1e-7)


@few
@given(vessels, restrictions)
def test_isothermal_is_polytropic_of_exponent_one(tank, size):
    duration = span(tank, size)
    one = filling({**tank, "thermal": "isothermal"}, size, duration)
    two = filling({**tank, "thermal": "polytropic", "polytropic_exponent": 1.0}, size, duration)
    assert two["tank.pressure"] == pytest.approx(one["tank.pressure"], rel=1e-9)
    assert two["tank.temperature"] == pytest.approx(one["tank.temperature"], rel=1e-12)


@few
@given(vessels, restrictions)
def test_isentrope_is_polytropic_of_exponent_kappa(tank, size):
    duration = span(tank, size)
    one = filling({**tank, "thermal": "isentrope"}, size, duration)
    two = filling({**tank, "thermal": "polytropic", "polytropic_exponent": 1.4}, size, duration)
    assert two["tank.pressure"] == pytest.approx(one["tank.pressure"], rel=1e-9)
    assert two["tank.temperature"] == pytest.approx(one["tank.temperature"], rel=1e-9)


@few
@given(vessels, restrictions)
def test_isothermal_is_the_limit_of_a_conducting_wall(tank, size):
    """The error falls as 1/(h A): heat capacity flow of the gas over wall conductance."""
    duration = span(tank, size)
    start = tank["initial_temperature"]
    flow = size["sonic_conductance"] * 1.185 * 13e5 * 1004.675
    isothermal = filling({**tank, "thermal": "isothermal"}, size, duration)

    def error(number: float) -> float:
        wall = {"wall_conductance": number * flow, "wall_temperature": start}
        return float(
            np.abs(filling({**tank, **wall}, size, duration)["tank.pressure"] / isothermal["tank.pressure"] - 1.0).max()
        )

    errors = [error(number) for number in (1e2, 1e3)]
    assert errors[1] < 3e-3
    assert errors[1] < 0.2 * errors[0] + 1e-6


@few
@given(vessels, restrictions, st.floats(0.1, 50.0), temperatures)
def test_infinite_wall_capacity_is_a_constant_wall(tank, size, conductance, wall):
    duration = span(tank, size)
    given_wall = {"wall_conductance": conductance, "wall_temperature": wall}
    one = filling({**tank, **given_wall}, size, duration)
    two = filling({**tank, **given_wall, "wall_heat_capacity": 1e15, "outer_conductance": 1.0}, size, duration)
    assert two["tank.pressure"] == pytest.approx(one["tank.pressure"], rel=1e-7)
    assert two["tank.wall_temperature"] == pytest.approx(np.full(two.time.size, wall), rel=1e-9)


@few
@given(vessels, vessels, restrictions)
def test_two_tanks_end_at_the_pressure_of_the_mixture(one, two, size):
    """Adiabatic: p = sum(p_i V_i)/sum(V_i), the energy of the whole."""
    size = size | {"subsonic_index": 0.5}
    recording = two_tanks(one, two, size, {"thermal": "energy"}).simulate(40.0 * max(span(one, size), span(two, size)))
    total = one["initial_pressure"] * one["volume"] + two["initial_pressure"] * two["volume"]
    end = total / (one["volume"] + two["volume"])
    assert recording["one.pressure"][-1] == pytest.approx(end, rel=1e-6)
    assert recording["two.pressure"][-1] == pytest.approx(end, rel=1e-6)
