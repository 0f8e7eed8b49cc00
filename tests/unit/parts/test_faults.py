"""Faults of valves: start, input, shared equations, effect on each function, and rejected combinations."""

from __future__ import annotations

from dataclasses import replace

import casadi as ca
import numpy as np
import pytest

from poppet import (
    Chamber,
    CheckValve,
    Circuit,
    DirectionalValve,
    FlowControlValve,
    Orifice,
    PilotedCheckValve,
    PressureRegulator,
    ProportionalValve,
    QuickExhaustValve,
    ReliefValve,
    Reservoir,
    ShuttleValve,
    SpoolValve,
    TwoPressureValve,
)
from poppet.parts.faults import FAULTS, FaultEffect
from poppet.parts.spool_functions import FUNCTIONS
from poppet.report.circuit.schematic import part_caption
from poppet.signals import Constant, Steps
from refusals import refused

SIZE = {"sonic_conductance": "1 dm^3/(s bar)", "critical_ratio": 0.3}
ON_AND_OFF = Steps([0.0, 0.1, 0.3], [0.0, 1.0, 0.0])


def seat_valve(signals=None, **fields):
    """A tank behind a 3/2 valve that opens at 0.1 s and closes at 0.3 s, each in 10 ms."""
    valve = DirectionalValve(supply="net", outlet="tank", exhaust="ambient", **SIZE, **fields)
    parts = {"net": Reservoir(pressure="6 bar g"), "tank": Chamber(volume="0.5 l"), "valve": valve}
    return Circuit(parts, {"valve.command": ON_AND_OFF} if signals is None else signals)


def spool(function, signals=None, **fields):
    """Two tanks at the ports of a spool valve; its command to a is set from 0.1 to 0.3 s, that to b from 0.4 s."""
    valve = SpoolValve(supply="net", a="a", b="b", function=function, **SIZE, **fields)
    tanks = {name: Chamber(volume="0.5 l") for name in ("a", "b")}
    first, *second = FUNCTIONS[function].commands
    commands = {f"valve.{first}": ON_AND_OFF, **{f"valve.{name}": Steps([0.0, 0.4], [0.0, 1.0]) for name in second}}
    return Circuit({"net": Reservoir(pressure="6 bar g"), **tanks, "valve": valve}, commands | (signals or {}))


def positions(circuit, *times):
    recording = circuit.simulate(0.5, output_step=1e-3)
    return np.interp(times, recording.time, recording["valve.position"]).round(3).tolist()


# --- Start and input ---


def test_a_valve_without_a_fault_has_neither_input_nor_parameters_of_faults():
    circuit = seat_valve(slow_factor=3.0)
    assert [name for name in circuit.inputs if "fault" in name] == []
    assert [name for name in circuit.parameters if name.partition(".")[2] in ("fault_start", "slow_factor")] == []
    assert circuit.structure == seat_valve().structure


def test_a_healthy_valve_has_the_equations_of_a_valve_without_faults():
    """The default effect adds no operation to an expression, and changes no bit of a float."""
    healthy, x, y = FaultEffect(), ca.SX.sym("x"), ca.SX.sym("y")
    for value, other in ((ca.sin(x), y), (0.1 + 0.2, 1.0 / 3.0), (-1e-300, 1e300)):
        results = [healthy.forced(value, other, 0.0), healthy.held(value), healthy.leaking(value, other)]
        results += [value * healthy.slowness, value / healthy.slowness]
        for result in results:
            assert ca.is_equal(result, value, 9) if isinstance(value, ca.SX) else result == value


def test_all_faults_share_their_equations():
    circuits = [seat_valve(fault=fault) for fault in FAULTS]
    circuits += [seat_valve(fault="slow", slow_factor=3.0), seat_valve(fault="stuck", leak_fraction=0.5)]
    circuits += [circuits[0].with_values({"valve.fault": fault, "valve.fault_start": 0.2}) for fault in FAULTS]
    assert {circuit.structure for circuit in circuits} == {circuits[0].structure}
    assert circuits[0].structure != seat_valve().structure


def test_input_jumps_at_the_start_of_the_fault():
    recording = seat_valve(fault="leak", fault_start=0.2).simulate(0.5, output_step=0.1)
    assert recording["valve.fault"].tolist() == [0.0, 0.0, 1.0, 1.0, 1.0, 1.0]
    assert seat_valve(fault="leak").simulate(0.5, output_step=0.1)["valve.fault"].min() == 1.0


def test_start_can_change_in_a_copy():
    circuit = seat_valve(fault="stuck_closed", fault_start=0.2)
    assert positions(circuit, 0.25) == [0.0]
    assert positions(circuit.with_values({"valve.fault_start": "0.28 s"}), 0.25) == [1.0]
    assert positions(circuit.with_values({"valve.fault": "none"}), 0.25) == [1.0]


def test_a_fault_that_ends_returns_the_element_by_its_own_law():
    for name, position in (("5/2 monostable", -1.0), ("5/2 bistable", 1.0), ("5/3 closed", 0.0)):
        commands = dict.fromkeys([f"valve.{command}" for command in FUNCTIONS[name].commands], Constant(0.0))
        signals = commands | {"valve.fault": Steps([0.0, 0.1, 0.2], [0.0, 1.0, 0.0])}
        assert positions(spool(name, signals, fault="stuck_open"), 0.15, 0.3) == [1.0, position], name


@pytest.mark.parametrize(("level", "position"), [(0.0, 0.0), (0.25, 0.0), (0.75, 1.0), (1.0, 1.0)])
def test_an_element_is_stuck_from_three_quarters_of_the_input(level, position):
    circuit = seat_valve({"valve.fault": Constant(level)}, fault="stuck_open")
    assert positions(circuit, 0.5) == [position]


def test_steady_state_and_linear_model_have_the_value_of_the_input():
    at_start, later = (seat_valve({}, fault="stuck_open", fault_start=start) for start in (0.0, 1.0))
    pressures = [circuit.steady_state().y["tank.pressure"] for circuit in (at_start, later)]
    assert pressures == pytest.approx([7e5, 1e5], rel=1e-6)
    stated = later.steady_state({"valve.fault": 1.0}).y["tank.pressure"]
    assert stated == pytest.approx(7e5, rel=1e-6)
    assert "valve.fault" in later.linearise().inputs


# --- Effect on each function ---


@pytest.mark.parametrize(
    ("function", "opened", "closed"),
    [(name, 1.0, -1.0 if name.startswith("5/2") else 0.0) for name in FUNCTIONS],
)
def test_stuck_spool_stays_at_its_end(function, opened, closed):
    times = 0.2, 0.35, 0.5
    assert positions(spool(function, fault="stuck_open"), *times) == pytest.approx([opened] * 3, abs=2e-3)
    assert positions(spool(function, fault="stuck_closed"), *times) == pytest.approx([closed] * 3, abs=2e-3)


@pytest.mark.parametrize("function", FUNCTIONS)
def test_stuck_spool_keeps_its_position(function):
    recording = spool(function, fault="stuck", fault_start=0.104).simulate(0.5, output_step=1e-3)
    kept = recording["valve.position"][recording.time >= 0.104 - 1e-9]
    assert np.ptp(kept) < 1e-12
    assert -0.9 < kept[0] < 0.9


def test_spool_with_inertia_starts_from_rest_when_it_is_released():
    fault = Steps([0.0, 0.102, 0.2], [0.0, 1.0, 0.0])
    fields = {"dynamics": "second_order", "fault": "stuck"}
    moving = spool("proportional", {"valve.fault": fault}, **fields).simulate(0.5, output_step=1e-3)
    assert abs(moving["valve.position"][moving.time > 0.295][0] - 1.0) < 1e-3
    kept = moving["valve.position"][(moving.time > 0.103) & (moving.time < 0.2)]
    assert np.ptp(kept) < 1e-12
    # The step response from the position in which the spool was kept.
    still = spool("proportional", {"valve.fault": fault}, initial_position=float(kept[0]), **fields)
    still = replace(still, signals={**still.signals, "valve.command": Steps([0.0, 0.2], [float(kept[0]), 1.0])})
    expected = still.simulate(0.29, output_step=1e-3)["valve.position"]
    assert moving["valve.position"][200:291] == pytest.approx(expected[200:], abs=1e-4)


def test_hysteresis_does_not_keep_a_stuck_spool_from_its_end():
    circuit = spool("proportional", {"valve.command": Constant(0.0)}, fault="stuck_open", hysteresis=0.1)
    assert positions(circuit, 0.5) == [1.0]


def test_slow_spool_without_a_speed_limit_has_a_larger_time_constant():
    slow, fast = spool("proportional", fault="slow", slow_factor=4.0), spool("proportional", lag="20 ms")
    times = 0.11, 0.15, 0.25
    assert positions(slow, *times) == pytest.approx(positions(fast, *times), abs=1e-3)


# --- Other valves ---


@pytest.mark.parametrize("kind", [ShuttleValve, TwoPressureValve, QuickExhaustValve])
@pytest.mark.parametrize(("fault", "position"), [("stuck_open", 0.0), ("stuck_closed", 1.0)])
def test_stuck_element_of_a_logic_valve_stays_at_its_seat(kind, fault, position):
    """Whatever the pressures at its ports: those of the inlets change places at 0.1 s."""
    ports = {"inlet": "first", "outlet": "load"} if kind is QuickExhaustValve else {"a": "first", "b": "second"}
    parts = {
        "first": Reservoir(pressure="0 bar g"),
        "second": Reservoir(pressure="2 bar g"),
        "load": Chamber(volume="0.1 l"),
        "link": Orifice(from_="second", to="load", **SIZE),
        "valve": kind(**{"outlet": "load", **ports}, fault=fault, initial_position=0.5, **SIZE),
    }
    circuit = Circuit(parts, {"first.pressure": Steps([0.0, 0.1], [1e5, 5e5])})
    assert positions(circuit, 0.05, 0.1, 0.2, 0.5) == [position] * 4


def test_stuck_regulator_neither_regulates_nor_relieves():
    """The load is vented from 0.1 s on; its pressure is above the setpoint before, and below it later."""
    parts = {
        "net": Reservoir(pressure="6 bar g"),
        "load": Chamber(volume="0.1 l", initial_pressure="4 bar g"),
        "vent": Orifice(from_="load", to="ambient", **SIZE),
        "valve": PressureRegulator(supply="net", outlet="load", setpoint="3 bar g", fault="stuck_closed", **SIZE),
    }
    circuit = Circuit(parts, {"vent.opening": Steps([0.0, 0.1], [0.0, 1.0])})
    recording = circuit.simulate(0.5, output_step=1e-3)
    assert abs(recording["valve.exhaust_mass_flow_rate"]).max() < 1e-12
    assert abs(recording["valve.supply_mass_flow_rate"]).max() < 1e-12
    assert recording["load.pressure"][-1] == pytest.approx(1e5, rel=1e-3)


def proportional_valve(**fields):
    valve = ProportionalValve(supply="net", outlet="tank", exhaust="ambient", data="vppm_6l", **fields)
    parts = {"net": Reservoir(pressure="8 bar g"), "tank": Chamber(volume="1 l"), "valve": valve}
    return Circuit(parts, {"valve.setpoint": Constant(4e5)})


def test_fault_of_a_proportional_valve_is_that_of_its_main_stage():
    circuit = proportional_valve(fault="stuck_closed", fault_start="0.1 s")
    recording = circuit.simulate(0.5, output_step=1e-2)
    assert recording["valve.fault"][[5, 30]].tolist() == [0.0, 1.0]
    overlap = circuit.parameters["valve.main_stage.overlap"]
    assert recording["valve.stroke"][-1] == pytest.approx(-0.5 * overlap, abs=1e-9)
    kept = recording["tank.pressure"][recording.time > 0.15]
    assert np.ptp(kept) < 1.0
    assert kept[0] < 3.5e5
    assert "valve.fault" not in proportional_valve().inputs


def test_all_faults_of_a_proportional_valve_share_their_equations():
    circuits = [proportional_valve(fault=fault) for fault in FAULTS]
    assert {circuit.structure for circuit in circuits} == {circuits[0].structure}
    slow = circuits[FAULTS.index("slow")]
    assert slow.numbers()["valve.slow_factor"].source.kind == "assumed"
    assert slow.with_values({"valve.slow_factor": 3.0}).parameters["valve.main_stage.slow_factor"] == 3.0
    assert slow.with_values({"valve.fault": "leak"}).parts["valve"].slow_factor is None


def test_errors_of_a_proportional_valve_have_its_own_addresses():
    with refused("fields.not_an_option", "fault", value="open"):
        proportional_valve(fault="open")
    with refused("fields.unknown", "main_stage.fault"):
        proportional_valve(main_stage={"fault": "slow"})
    circuit = proportional_valve(fault="slow", fault_start=0.1)
    with refused("faults.two_starts", "valve.fault_start", input="valve.fault"):
        circuit.with_signals({"valve.fault": Constant(1.0)})
    codes = [(note.code, note.address) for note in proportional_valve(fault_start=0.1).static_notes]
    assert ("faults.idle_start", "valve.fault_start") in codes


# --- Defaults, notes and errors ---


def test_defaults_are_assumed_and_follow_the_fault():
    valve = seat_valve(fault="slow").parts["valve"]
    assert (valve.slow_factor.value, valve.slow_factor.source.kind) == (10.0, "assumed")
    assert valve.leak_fraction is None
    leaking = replace(valve, fault="leak")
    assert (leaking.slow_factor, leaking.leak_fraction.value) == (None, 0.05)
    assert replace(valve, slow_factor=3.0, fault="none").slow_factor.value == 3.0


def test_start_without_a_fault_has_a_note():
    codes = [note.code for note in seat_valve(fault_start=1.0).static_notes]
    assert "faults.idle_start" in codes
    recording = seat_valve(fault="leak", fault_start=2.0).simulate(0.5)
    assert "faults.after_end" in [note.code for note in recording.remarks]


def test_unknown_fault_is_rejected():
    with refused("fields.not_an_option", "fault", value="stuck_opne"):
        seat_valve(fault="stuck_opne")


def test_two_starts_are_rejected():
    with refused("faults.two_starts", "valve.fault_start", input="valve.fault", time=0.1):
        seat_valve({"valve.fault": Constant(1.0)}, fault="leak", fault_start=0.1)


@pytest.mark.parametrize(
    ("kind", "fields"),
    [
        (CheckValve, {}),
        (ReliefValve, {"set_pressure": "3 bar g"}),
        (FlowControlValve, {"throttle_conductance": 1e-9}),
        (PilotedCheckValve, {"pilot": "pilot"}),
    ],
)
@pytest.mark.parametrize("fault", ["stuck", "slow"])
def test_an_opening_without_a_position_can_neither_be_kept_nor_slowed_down(kind, fields, fault):
    with refused("faults.not_possible", "fault", fault=fault, possible=["stuck_open", "stuck_closed", "leak"]):
        kind(from_="tank", to="ambient", fault=fault, **fields, **SIZE)


def test_fault_cannot_have_a_signal_and_be_connected():
    circuit = seat_valve(fault="leak", fault_start=0.1)
    with refused("faults.two_starts", "valve.fault_start"):
        replace(circuit, connections={"valve.fault": "valve.position"})


def test_a_connected_fault_follows_its_source():
    """The valve leaks as far as another one is open."""
    circuit = seat_valve(fault="leak")
    parts = {**circuit.parts, "other": DirectionalValve(supply="net", outlet="tank", command=1.0, **SIZE)}
    circuit = Circuit(parts, circuit.signals, connections={"valve.fault": "other.position"})
    recording = circuit.simulate(0.05, output_step=1e-3)
    assert recording["valve.fault"] == pytest.approx(recording["other.position"])


def test_a_healthy_valve_has_no_input_for_a_fault():
    with refused("faults.no_input", "signals.valve.fault", valve="valve"):
        seat_valve({"valve.fault": Constant(1.0)})
    with refused("faults.no_input", "connections.valve.fault", valve="valve"):
        replace(seat_valve(), connections={"valve.fault": "valve.position"})


def test_a_result_and_a_drawing_name_the_fault():
    circuit = seat_valve(fault="stuck_closed", fault_start="20 ms")
    (note,) = (note for note in circuit.static_notes if note.code == "faults.present")
    assert (note.address, note.facts["fault"], note.facts["start"]) == ("valve.fault", "stuck_closed", "20 ms")
    assert "fault: stuck closed" in part_caption(circuit, "valve")
    assert not any("fault" in line for line in part_caption(seat_valve(), "valve"))
    codes = [(note.code, note.address) for note in proportional_valve(fault="leak").static_notes]
    assert codes.count(("faults.present", "valve.fault")) == 1


@pytest.mark.parametrize("build", [seat_valve, proportional_valve], ids=["valve", "compound"])
def test_an_uncertain_start_shifts_the_breakpoint_of_each_run(build):
    circuit = build(fault="stuck_open", fault_start=0.05).with_values({"run.duration": 0.2})
    parameters = {"valve.fault_start": {"distribution": "uniform", "low": 0.03, "high": 0.15}}
    metrics = {"end": {"of": "tank.pressure", "metric": "mean"}}
    rows = circuit.ensemble(runs=3, parameters=parameters, metrics=metrics).dataset.columns("runs")
    assert len(set(rows["end"])) == 3
    for start, end in zip(rows["valve.fault_start"], rows["end"], strict=True):
        single = circuit.with_values({"valve.fault_start": float(start)}).simulate()
        pressure = single["tank.pressure"]
        assert end == pytest.approx(np.trapezoid(pressure, single.time) / single.time[-1], rel=1e-6)
