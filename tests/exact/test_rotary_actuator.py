"""Rotary actuator: torque, end stops, gas spring, an independent simulation, balances and exergy."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from exact.independent_machines import swing
from exact.test_cylinder import frequency_of
from poppet import Circuit, InputErrors, Orifice, Reservoir, RotaryActuator, SpoolValve, iso6358
from poppet.timeseries.signals import Points, Steps
from refusals import refused

SIDE = {"dead_volume": "10 cm^3"}
D, SWIVEL, INERTIA = 2e-5, math.pi, 0.05
PATH = {"sonic_conductance": 5e-9, "critical_ratio": 0.3}


def actuator(shaft: Any = None, side: Any = SIDE, forward: Any = None, **fields: Any) -> RotaryActuator:
    size = fields if "rated_torque" in fields else {"displacement": D, **fields}
    shaft = {"inertia": INERTIA, **(shaft or {})}
    return RotaryActuator(swivel_angle=SWIVEL, shaft=shaft, forward=forward or side, backward=side, **size)


def driven(signals: Any = None, pressure: float = 7e5, **fields: Any) -> Circuit:
    parts = {
        "supply": Reservoir(pressure=pressure),
        "valve": SpoolValve(supply="supply", a="arm.forward", b="arm.backward", **PATH),
        "arm": actuator(**fields),
    }
    return Circuit(parts, {"valve.command": Steps([0.0], [1.0])} if signals is None else signals)


@pytest.mark.parametrize(
    "size", [{"displacement": D}, {"rated_torque": 12.0}, {"rated_torque": 8.0, "rated_pressure": 4e5}]
)
def test_torque_is_displacement_times_pressure_difference(size):
    recording = driven(shaft={"friction": {"viscous_coefficient": 0.5}}, **size).simulate(5.0)
    last = recording.last()
    assert last["arm.torque"] == pytest.approx(D * 6e5, rel=1e-6)
    assert last["arm.forward.pressure"] == pytest.approx(7e5, rel=1e-6)
    # The stop carries the torque: M = k d^1.5.
    assert last["arm.shaft.position"] == pytest.approx(SWIVEL + (12.0 / 1e5) ** (2.0 / 3.0), rel=1e-5)
    assert last["arm.shaft.stop_torque"] == pytest.approx(-12.0, rel=1e-6)


def test_a_load_above_the_torque_stalls_at_the_other_end():
    shaft = {"friction": {"viscous_coefficient": 0.5}, "load_torque": 13.0, "initial_position": 1.0}
    last = driven(shaft=shaft).simulate(5.0).last()
    assert last["arm.shaft.position"] == pytest.approx(-((1.0 / 1e5) ** (2.0 / 3.0)), rel=1e-3)


@pytest.mark.parametrize(("conductance", "exponent"), [(0.0, 1.4), (1e5, 1.0)])
def test_a_closed_actuator_is_a_spring_of_gas(conductance, exponent):
    side = {"dead_volume": 1e-5, "wall_conductance": conductance, "initial_pressure": 6e5}
    shaft = {"initial_position": SWIVEL / 2, "initial_velocity": 0.05}
    recording = Circuit({"slide": actuator(shaft, side)}).simulate(1.0, 1e-4, 1e-8)
    rate = 2.0 * exponent * 6e5 * D**2 / (1e-5 + D * SWIVEL / 2)
    expected = math.sqrt(rate / INERTIA) / math.tau
    assert frequency_of(recording, "slide.shaft.velocity") == pytest.approx(expected, rel=1e-3)


def test_motion_and_pressures_agree_with_an_independent_simulation():
    law = {"V": 1e-5, "D": D, "swivel": SWIVEL, "J": INERTIA, "d": 0.3, "M": 1.0, "p": 7e5, "C": 5e-9, "b": 0.3}
    times = np.linspace(0.0, 0.18, 181)
    expected = swing(law, times)
    shaft = {"friction": {"viscous_coefficient": 0.3}, "load_torque": 1.0, "initial_position": 0.5}
    parts = {
        "supply": Reservoir(pressure=7e5), "arm": actuator(shaft),
        "fill": Orifice(from_="supply", to="arm.forward", **PATH),
        "vent": Orifice(from_="arm.backward", to="ambient", **PATH),
    }  # fmt: skip
    recording = Circuit(parts).simulate(0.18, 1e-3, 1e-8)
    assert 1.0 < expected[0].max() < SWIVEL
    names = ("shaft.position", "shaft.velocity", "forward.pressure", "backward.pressure")
    for name, series in zip(names, expected, strict=True):
        assert np.abs(recording[f"arm.{name}"] - series).max() < 3e-4 * np.abs(series).max()


def test_seal_friction_holds_a_load():
    """The gas exerts 12 N m, and the shaft sticks up to a difference of 0.5 + 2.4 N m."""
    signals = {"valve.command": Steps([0.0], [1.0]), "arm.shaft.load_torque": Points([0.0, 4.0], [12.0, 8.0])}
    shaft = {"friction": {"kind": "lugre", "coulomb_torque": 0.5}, "initial_position": 1.0}
    forward = {**SIDE, "initial_pressure": 7e5}
    circuit = driven(signals, shaft=shaft, forward=forward, seal_friction=4e-6)
    recording = circuit.simulate(4.0, 0.01)
    slides = np.abs(recording["arm.shaft.position"] - 1.0) > 1e-2
    assert recording["arm.shaft.load_torque"][slides][0] == pytest.approx(12.0 - 2.9, abs=0.15)
    assert recording["arm.shaft.breakaway_torque"][100] == pytest.approx(2.9, rel=1e-6)


def test_leakage_connects_both_chambers():
    leakage = {"sonic_conductance": 1e-10, "critical_ratio": 0.3}
    last = driven(shaft={"friction": {"viscous_coefficient": 0.5}}, leakage=leakage).simulate(100.0).last()
    pressures, temperature = (
        (last["arm.forward.pressure"], last["arm.backward.pressure"]),
        last["arm.forward.temperature"],
    )
    expected = iso6358.mass_flow_rate(*pressures, temperature, **leakage)
    assert last["arm.leakage_mass_flow_rate"] == pytest.approx(expected, rel=1e-9)
    # The valve supplies the leak.
    assert last["valve.supply_a_mass_flow_rate"] == pytest.approx(expected, rel=1e-4)


def test_balances_exergy_and_metrics_of_a_cycle():
    signals = {"valve.command": Steps([0.0, 0.1, 1.5, 3.0], [0.0, 1.0, -1.0, 1.0])}
    shaft = {"friction": {"kind": "lugre", "coulomb_torque": 0.5}, "load_torque": 2.0}
    recording = driven(signals, shaft=shaft).simulate(4.5, 1e-3)
    assert [residual for residual in recording.residuals if not residual.is_kept] == []
    assert {residual.quantity for residual in recording.residuals} == {"mass", "energy", "motion"}
    figures = recording.figures
    assert [stroke.command for stroke in figures.strokes] == ["valve.command"] * 3
    assert {arrival.body for arrival in figures.arrivals} == {"arm.shaft"}
    assert 0.0 < figures.work < figures.exergy - figures.stored
    (note,) = [note for note in recording.remarks if note.code == "bodies.met_stop"]
    assert note.address == "arm.shaft.velocity"


def test_a_settled_actuator_takes_large_steps():
    short, long = (
        driven(shaft={"friction": {"kind": "lugre", "coulomb_torque": 0.5}}).simulate(t) for t in (3.0, 3000.0)
    )
    assert long.statistics["accepted_steps"] < short.statistics["accepted_steps"] + 100


def test_a_run_continues_another_run():
    circuit = driven()
    first = circuit.simulate(0.2)
    again = circuit.resumed(first).simulate(0.1)
    for name in ("shaft.position", "shaft.velocity", "forward.pressure", "backward.temperature"):
        assert again[f"arm.{name}"][0] == pytest.approx(first[f"arm.{name}"][-1], rel=1e-9)
    # Also at an end stop, which is compressed.
    assert circuit.resumed(circuit.simulate(5.0)).simulate(0.1)["arm.shaft.position"][0] > SWIVEL


def test_inputs_addresses_and_drives():
    circuit = driven()
    assert {"arm.shaft.load_torque"} <= set(circuit.inputs)
    assert circuit.drives() == {"arm.shaft": {"valve.command": True}}
    names = set(circuit.numbers())
    assert {"arm.displacement", "arm.shaft.inertia", "arm.forward.dead_volume", "arm.end_stop.stiffness"} <= names
    assert not [name for name in names if "stop.position" in name or "pulley" in name]
    changed = circuit.with_values({"arm.displacement": 3e-5, "arm.shaft.friction.kind": "viscous"})
    assert changed.parameters["arm.vane.displacement"] == changed.parameters["arm.forward.displacement"] == 3e-5
    with refused("address.told", "arm.shaft.pulley_radius"):
        circuit.with_values({"arm.shaft.pulley_radius": 0.1})


def test_invalid_actuators_are_rejected():
    with refused("compounds.displacement_twice", "rated_torque"):
        actuator(displacement=D, rated_torque=10.0)
    with refused("fields.missing", "displacement"):
        actuator(displacement=None)
    with refused("bodies.beyond_stop", "shaft.initial_position"):
        actuator({"initial_position": 4.0})
    for name in ("displacement", "rated_torque", "rated_pressure"):
        with refused("fields.out_of_range", name):
            actuator(**{"displacement": None, "rated_torque": 1.0, name: -1.0})
    with refused("fields.not_a_table", "end_stop"):
        actuator(end_stop=3.0)
    with pytest.raises(InputErrors) as caught:
        RotaryActuator()
    addresses = {problem.address for problem in caught.value.problems}
    assert addresses == {"swivel_angle", "displacement", "shaft.inertia", "forward.dead_volume", "backward.dead_volume"}
