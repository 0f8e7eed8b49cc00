"""Faults of valves against closed forms, and against circuits whose other parts have the effect of the fault."""

from __future__ import annotations

import math

import numpy as np
import pytest

from poppet import (
    Chamber,
    CheckValve,
    Circuit,
    DirectionalValve,
    FlowControlValve,
    MainStage,
    Orifice,
    PilotedCheckValve,
    PressureRegulator,
    QuickExhaustValve,
    ReliefValve,
    Reservoir,
    ShuttleValve,
    SpoolValve,
    TwoPressureValve,
)
from poppet.laws.physics import tanks
from poppet.signals import Constant, Steps

C, B, V, T, HIGH = 1.65e-8, 0.4274, 0.02, 293.15, 7e5
SIZE = {"sonic_conductance": C, "critical_ratio": B}
FRACTION = 0.2
TOLERANCE = 1e-9
"""Relative tolerance of the runs; results must be within ten times it."""
TAU = float(tanks.discharge_time_constant(V, C, T))


def tank(pressure=HIGH, volume=V):
    return Chamber(volume=volume, thermal="isothermal", initial_pressure=pressure)


def discharge(valve, signals=None, **others):
    """A tank that a valve vents into the ambient, or into reservoirs with the ambient pressure."""
    sinks = {name: Reservoir(pressure=1e5) for name in ("sink", "drain") if name in valve.ports().values()}
    return Circuit({"tank": tank(), **sinks, "valve": valve, **others}, signals or {})


VENTS = {
    "check": CheckValve(from_="tank", to="ambient", **SIZE),
    "directional": DirectionalValve(supply="tank", outlet="ambient", command=1.0, **SIZE),
    "relief": ReliefValve(from_="tank", to="ambient", set_pressure=1.2e5, accumulation=1e3, **SIZE),
    "flow control": FlowControlValve(from_="tank", to="ambient", throttle_conductance=0.0, **SIZE),
    "piloted check": PilotedCheckValve(from_="tank", to="ambient", pilot="tank", **SIZE),
    "spool": SpoolValve(supply="tank", a="sink", b="drain", function="5/2 monostable", command=1.0,
                        supply_b_conductance=0.0, exhaust_a_conductance=0.0, **SIZE),
    "spool centre": SpoolValve(supply="tank", a="sink", b="drain", function="5/3 closed", command_a=1.0, **SIZE),
    "proportional spool": SpoolValve(supply="tank", a="sink", b="drain", command=1.0, **SIZE),
    "quick exhaust": QuickExhaustValve(inlet="tank", outlet="sink", exhaust="ambient", **SIZE),
    "regulator": PressureRegulator(supply="tank", outlet="sink", setpoint=9e5, initial_position=1.0, **SIZE),
    "main stage": MainStage(supply="tank", outlet="sink", exhaust="ambient", data="varga2012",
                            pilot_pressure=7e5, initial_stroke=1e-3),
}  # fmt: skip
"""Valves that vent the tank at `supply` or `from`; the open flow path is the main one."""


@pytest.mark.parametrize("name", VENTS)
def test_a_valve_that_is_stuck_closed_ends_a_discharge(name):
    start, end = 0.2 * TAU, 1.5 * TAU
    stuck = discharge(VENTS[name]).with_values({"valve.fault": "stuck_closed", "valve.fault_start": start})
    recording = stuck.simulate(end, 0.01 * TAU, TOLERANCE)
    healthy = discharge(VENTS[name]).simulate(end, 0.01 * TAU, TOLERANCE)
    before = recording.time <= start
    limit = 10 * TOLERANCE * HIGH
    assert np.abs(recording["tank.pressure"] - healthy["tank.pressure"])[before].max() < limit
    assert healthy["tank.pressure"][-1] < 0.5 * HIGH
    closed = recording["tank.pressure"][recording.time >= start + 0.25]
    assert closed.size > 10
    assert np.ptp(closed) < 1e-12 * HIGH
    assert closed[-1] > 0.7 * HIGH


LEAKS = {
    "check": CheckValve(from_="ambient", to="tank", **SIZE),
    "directional": DirectionalValve(supply="tank", outlet="ambient", **SIZE),
    "relief": ReliefValve(from_="tank", to="ambient", set_pressure=9e5, **SIZE),
    "relief, back": ReliefValve(from_="ambient", to="tank", set_pressure=9e5, **SIZE),
    "flow control": FlowControlValve(from_="ambient", to="tank", throttle_conductance=0.0, **SIZE),
    "piloted check": PilotedCheckValve(from_="ambient", to="tank", pilot="ambient", **SIZE),
    "spool": SpoolValve(supply="tank", a="sink", b="drain", function="5/2 monostable", supply_b_conductance=0.0,
                        **SIZE),
    "spool centre": SpoolValve(supply="tank", a="sink", b="drain", function="5/3 closed",
                               supply_b_conductance=0.0, **SIZE),
    "proportional spool": SpoolValve(supply="tank", a="sink", b="drain", supply_b_conductance=0.0, **SIZE),
    "shuttle": ShuttleValve(a="drain", b="tank", outlet="sink", switching_pressure=9e5, **SIZE),
    "two pressures": TwoPressureValve(a="drain", b="tank", outlet="sink", **SIZE),
    "quick exhaust": QuickExhaustValve(inlet="tank", outlet="sink", exhaust="ambient", initial_position=1.0,
                                       switching_pressure=9e5, **SIZE),
    "regulator": PressureRegulator(supply="tank", outlet="sink", setpoint=0.9e5, **SIZE),
}  # fmt: skip
"""Valves whose closed flow path separates the tank from the ambient."""


@pytest.mark.parametrize("name", LEAKS)
def test_a_leak_is_an_isothermal_discharge_through_a_fraction_of_the_conductance(name):
    start = 0.5 * TAU
    changes = {"valve.fault": "leak", "valve.leak_fraction": FRACTION, "valve.fault_start": start}
    recording = discharge(LEAKS[name]).with_values(changes).simulate(start + 1.2 * TAU / FRACTION, 0.1 * TAU, TOLERANCE)
    pressure, time = recording["tank.pressure"], recording.time
    assert np.abs(pressure[time <= start] / HIGH - 1.0).max() < 1e-10
    choked = (time >= start) & (pressure * B >= 1e5)
    expected = tanks.isothermal_discharge_pressure(time[choked] - start, HIGH, TAU / FRACTION)
    assert choked.sum() > 50
    assert np.abs(pressure[choked] / expected - 1.0).max() < 10 * TOLERANCE


def test_input_is_the_fraction_of_a_leak():
    valve = CheckValve(from_="ambient", to="tank", fault="leak", leak_fraction=FRACTION, **SIZE)
    recording = discharge(valve, {"valve.fault": Constant(0.5)}).simulate(TAU, 0.1 * TAU, TOLERANCE)
    expected = tanks.isothermal_discharge_pressure(recording.time, HIGH, 2.0 * TAU / FRACTION)
    assert np.abs(recording["tank.pressure"] / expected - 1.0).max() < 10 * TOLERANCE


@pytest.mark.parametrize("name", [name for name in LEAKS if name not in ("shuttle", "two pressures")])
def test_a_valve_that_is_stuck_open_is_an_orifice(name):
    start = 0.5 * TAU
    stuck = discharge(LEAKS[name]).with_values({"valve.fault": "stuck_open", "valve.fault_start": start})
    recording = stuck.simulate(start + 0.8 * TAU, 0.01 * TAU, TOLERANCE)
    pressure, time = recording["tank.pressure"], recording.time
    assert np.abs(pressure[time <= start] / HIGH - 1.0).max() < 1e-10
    # From the first row at which the valve is open.
    first = int(np.argmax(time >= start + 0.1))
    later = slice(first, None)
    assert (pressure[later] * B >= 1e5).all()
    expected = tanks.isothermal_discharge_pressure(time[later] - time[first], pressure[first], TAU)
    assert np.abs(pressure[later] / expected - 1.0).max() < 10 * TOLERANCE


def test_flow_control_valve_without_its_closing_element_is_its_throttle_or_free():
    fields = {"throttle_conductance": 0.3 * C, "throttle_ratio": 0.2}
    for ends in ({"from_": "tank", "to": "ambient"}, {"from_": "ambient", "to": "tank"}):
        for fault, conductance, ratio in (("stuck_open", C, B), ("stuck_closed", 0.3 * C, 0.2)):
            valve = FlowControlValve(**ends, fault=fault, **fields, **SIZE)
            orifice = Orifice(from_="tank", to="ambient", sonic_conductance=conductance, critical_ratio=ratio)
            run = {"duration": 3.0 * TAU, "output_step": 0.05 * TAU, "relative_tolerance": TOLERANCE}
            pressures = [discharge(part).simulate(**run)["tank.pressure"] for part in (valve, orifice)]
            assert np.abs(pressures[0] - pressures[1]).max() < 10 * TOLERANCE * HIGH


# --- Motion of the closing element ---


@pytest.mark.parametrize(
    ("valve", "travel"),
    [
        (DirectionalValve(supply="tank", outlet="ambient", switching_time="20 ms", closing_time="50 ms", **SIZE), 1.0),
        (SpoolValve(supply="tank", a="sink", b="drain", function="5/2 monostable", switching_time="20 ms",
                    closing_time="50 ms", **SIZE), 2.0),
    ],
    ids=["directional", "spool"],
)  # fmt: skip
def test_a_slow_valve_switches_in_a_multiple_of_its_times(valve, travel):
    factor, on, off = 3.0, 0.1, 0.4
    changes = {"valve.fault": "slow", "valve.slow_factor": factor}
    command = {"valve.command": Steps([0.0, on, off], [0.0, 1.0, 0.0])}
    recording = discharge(valve, command).with_values(changes).simulate(0.7, 1e-3, TOLERANCE)
    start = recording["valve.position"][0]
    for event, duration, begin, end in ((on, 0.02, 0.0, travel), (off, 0.05, travel, 0.0)):
        # Linear up to the last fiftieth of the travel.
        fraction = (recording.time - event) / (factor * duration)
        linear = (fraction > 0.0) & (fraction < 0.97)
        expected = start + begin + (end - begin) * fraction[linear]
        assert linear.sum() > 50
        assert np.abs(recording["valve.position"][linear] - expected).max() < 1e-7


def test_a_stuck_spool_stops_exactly_at_the_start_of_the_fault():
    """The integrator restarts there: at a tolerance of 1e-3, the position is that of the uniform motion."""
    valve = DirectionalValve(supply="tank", outlet="ambient", switching_time="20 ms", **SIZE)
    command = {"valve.command": Steps([0.0, 0.1], [0.0, 1.0])}
    for start in (0.1037, 0.1111, 0.1183):
        changes = {"valve.fault": "stuck", "valve.fault_start": start}
        recording = discharge(valve, command).with_values(changes).simulate(1.0, 0.1, 1e-3)
        assert recording["valve.position"][-1] == pytest.approx((start - 0.1) / 0.02, rel=1e-12)


def stage(**fields):
    """A main stage between prescribed pressures; its plate moves freely."""
    parts = {
        "net": Reservoir(pressure=HIGH),
        "load": Reservoir(pressure=3e5),
        "valve": MainStage(supply="net", outlet="load", exhaust="ambient", data="varga2012", **fields),
    }
    return Circuit(parts, {"valve.pilot_pressure": Steps([0.0, 0.05, 0.25], [1e5, 5e5, 2.5e5])})


def test_a_slow_plate_moves_as_the_healthy_one_in_a_multiple_of_the_time():
    factor, end = 3.0, 0.35
    slow = stage(fault="slow", slow_factor=factor)
    times = [factor * t for t in (0.0, 0.05, 0.25)]
    slow = slow.with_signals({"valve.pilot_pressure": Steps(times, [1e5, 5e5, 2.5e5])})
    stretched = slow.simulate(factor * end, factor * 1e-3, TOLERANCE)
    healthy = stage().simulate(end, 1e-3, TOLERANCE)
    assert np.ptp(healthy["valve.stroke"]) > 1e-4
    assert stretched["valve.stroke"] == pytest.approx(healthy["valve.stroke"], abs=1e-9)
    assert factor * stretched["valve.velocity"] == pytest.approx(healthy["valve.velocity"], abs=1e-5)


@pytest.mark.parametrize(("fault", "target"), [("stuck_open", 1e-3), ("stuck_closed", -2.5e-6)])
def test_a_stuck_plate_moves_like_a_critically_damped_oscillator(fault, target):
    start = 0.1
    circuit = stage(fault=fault, fault_start=start)
    recording = circuit.simulate(0.2, 1e-4, TOLERANCE)
    area, mass = (circuit.parameters[f"valve.{name}"] for name in ("plate_area", "moving_mass"))
    omega = math.sqrt(area * 1e5 / (1e-3 + 5e-5) / mass)
    time = recording.time[recording.time >= start] - start
    stroke = recording["valve.stroke"][recording.time >= start]
    expected = target + (stroke[0] - target) * (1.0 + omega * time) * np.exp(-omega * time)
    assert abs(stroke[0] - target) > 1e-4
    assert np.abs(stroke - expected).max() < 1e-8
