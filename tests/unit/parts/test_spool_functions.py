"""Functions of spool valves: fields, defaults, captions, symbols, and rejected combinations."""

from __future__ import annotations

from pathlib import Path

import pytest

from poppet import Chamber, Circuit, DirectionalValve, InputErrors, Reservoir, SpoolValve, Tube, load
from poppet.parts.captions import CaptionNumbers
from poppet.parts.part import GasState, Scope, Surroundings
from poppet.parts.spool_functions import FUNCTIONS, OFF, ON
from poppet.signals import Steps
from refusals import refused

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
PORTS = {"supply": "rail", "a": "first", "b": "second"}
SIZE = {"sonic_conductance": 2e-8, "critical_ratio": 0.3}
SWITCHED = [name for name in FUNCTIONS if name != "proportional"]


def valve(function: str = "proportional", **fields):
    return SpoolValve(**{**PORTS, **SIZE, "function": function, **fields})


@pytest.mark.parametrize(
    ("function", "names"),
    [
        ("proportional", ["command"]),
        ("5/2 monostable", ["command"]),
        ("5/2 bistable", ["command_a", "command_b"]),
        ("5/3 closed", ["command_a", "command_b"]),
        ("5/3 exhausted", ["command_a", "command_b"]),
        ("5/3 pressurised", ["command_a", "command_b"]),
    ],
)
def test_inputs_of_each_function(function, names):
    inputs = valve(function).inputs()
    assert [item.name for item in inputs] == names
    low = -1.0 if function == "proportional" else 0.0
    assert {(item.low, item.high, item.unit) for item in inputs} == {(low, 1.0, "1")}


@pytest.mark.parametrize(
    ("function", "commands", "position"),
    [
        ("proportional", {"command": -0.3}, -0.3),
        ("5/2 monostable", {}, -1.0),
        ("5/2 monostable", {"command": 1.0}, 1.0),
        ("5/2 bistable", {}, -1.0),
        ("5/2 bistable", {"command_a": 1.0}, 1.0),
        ("5/2 bistable", {"command_a": 1.0, "command_b": 1.0}, -1.0),
        ("5/3 closed", {}, 0.0),
        ("5/3 closed", {"command_b": 1.0}, -1.0),
        ("5/3 exhausted", {"command_a": 1.0}, 1.0),
        ("5/3 pressurised", {"command_a": 1.0, "command_b": 1.0}, 0.0),
    ],
)
def test_initial_position_is_that_of_the_commands(function, commands, position):
    assert valve(function, **commands).parameters(AIR)["initial_position"] == position
    assert valve(function, **commands, initial_position=0.5).parameters(AIR)["initial_position"] == 0.5


@pytest.mark.parametrize(
    ("function", "fields"),
    [
        ("proportional", {"command_a": 1.0}),
        ("proportional", {"pilot_a": "line"}),
        ("proportional", {"pilot_b": "line"}),
        ("proportional", {"centre_conductance": 1e-8}),
        ("5/2 monostable", {"command_a": 1.0}),
        ("5/2 monostable", {"pilot_b": "line"}),
        ("5/2 monostable", {"lag": "1 ms"}),
        ("5/2 monostable", {"dynamics": "second_order"}),
        ("5/2 bistable", {"command": 1.0}),
        ("5/2 bistable", {"hysteresis": 0.01}),
        ("5/2 bistable", {"natural_frequency": "50 Hz"}),
        ("5/3 closed", {"command": 0.0001}),
        ("5/3 closed", {"overlap": 0.1}),
        ("5/3 closed", {"centre_ratio": 0.3}),
        ("5/3 exhausted", {"exhaust_overlap": -0.1}),
        ("5/3 pressurised", {"setpoint_type": "0-10 V"}),
    ],
)
def test_fields_without_effect_are_rejected(function, fields):
    (name,) = fields
    with refused("spool.idle_field", name, function=function):
        valve(function, **fields)


def test_all_fields_without_effect_are_reported_together():
    with pytest.raises(InputErrors) as caught:
        valve("5/3 closed", command=1.0, lag="1 ms", overlap=0.1)
    assert [error.address for error in caught.value.problems] == ["lag", "command", "overlap"]


@pytest.mark.parametrize("fields", [{"pilot_pressure": "3 bar"}, {"pilot_hysteresis": "0.1 bar"}])
@pytest.mark.parametrize("function", FUNCTIONS)
def test_pilot_fields_require_a_pilot_port(function, fields):
    with refused("spool.no_pilot", next(iter(fields))):
        valve(function, **fields)


def test_pilot_must_release_above_the_ambient_pressure():
    low = valve("5/2 monostable", pilot_a="line", pilot_pressure="1.4 bar")
    with refused("spool.never_released", "pilot_pressure"):
        low.parameters(AIR)
    assert valve("5/2 monostable", pilot_a="line", pilot_pressure="1.6 bar").parameters(AIR)["pilot_pressure"] == 1.6e5


@pytest.mark.parametrize(
    ("fields", "code"),
    [
        ({"function": "5/3"}, "fields.not_an_option"),
        ({"function": ["5/3"]}, "fields.not_an_option"),
        ({"setpoint_type": {}}, "fields.not_an_option"),
        ({"function": "5/2 monostable", "command": -1.0}, "fields.out_of_range"),
        ({"function": "5/2 bistable", "command_a": 2.0}, "fields.out_of_range"),
        ({"function": "5/2 bistable", "closing_time": "0 s"}, "fields.out_of_range"),
    ],
)
def test_invalid_values(fields, code):
    with refused(code):
        valve(**fields)


def test_defaults_of_times():
    values = valve("5/2 bistable").parameters(AIR)
    assert (values["switching_time"], values["closing_time"]) == (0.01, 0.01)
    assert valve("5/2 bistable", switching_time="25 ms").parameters(AIR)["closing_time"] == 0.025
    # A proportional valve has no limit of its speed.
    assert valve().switching_time is None
    assert "command_a" not in valve().numbers()


def test_function_of_a_circuit_can_change():
    parts = {"rail": Reservoir(pressure="7 bar"), "first": Chamber(volume="1 l"), "second": Chamber(volume="1 l")}
    circuit = Circuit({**parts, "valve": valve()})
    for function in (*SWITCHED, "proportional"):
        circuit = circuit.with_values({"valve.function": function})
        assert circuit.parts["valve"] == valve(function)
    with refused("spool.idle_field", "valve.lag"):
        circuit.with_values({"valve.lag": "1 ms"}).with_values({"valve.function": "5/2 bistable"})


def test_thresholds_of_commands():
    closed = valve("5/3 closed")
    for command, moves in ((ON + 0.01, True), (ON - 0.01, False)):
        assert (speed(closed, 0.0, command_a=command) > 0.0) is moves
    for command, moves in ((OFF - 0.01, True), (OFF + 0.01, False)):
        assert (speed(closed, 1.0, command_a=command) < 0.0) is moves


def speed(part, position, **commands):
    gas = dict.fromkeys(("supply", "a", "b", "exhaust_a", "exhaust_b"), GasState(1e5, 293.15))
    inputs = dict.fromkeys((item.name for item in part.inputs()), 0.0) | commands
    return part.flows(Scope(part.parameters(AIR), {"position": position}, inputs, AIR), gas).rates["position"]


def test_flow_capacity_at_the_centre():
    gas = {"supply": GasState(7e5, 293.15), "a": GasState(4e5, 293.15), "b": GasState(4e5, 293.15)}
    gas |= dict.fromkeys(("exhaust_a", "exhaust_b"), GasState(1e5, 293.15))

    def exhaust_flow(position, **fields):
        part = valve("5/3 exhausted", **fields)
        scope = Scope(part.parameters(AIR), {"position": position}, {"command_a": 0.0, "command_b": 0.0}, AIR)
        return part.flows(scope, gas).outputs["exhaust_b_mass_flow_rate"][0]

    full = exhaust_flow(1.0)
    assert exhaust_flow(0.0) == full
    assert exhaust_flow(0.0, centre_conductance=5e-9) == pytest.approx(0.25 * full, rel=1e-12)
    assert exhaust_flow(1.0, centre_conductance=5e-9) == full
    assert exhaust_flow(0.5, centre_conductance=5e-9) == pytest.approx(0.625 * full, rel=1e-12)
    assert exhaust_flow(0.0, centre_ratio=0.26) == full  # choked
    assert exhaust_flow(0.0, centre_ratio=0.1) < full
    assert exhaust_flow(-0.5, centre_conductance=5e-9) == 0.0


def test_captions():
    def lines(part):
        return part.caption(CaptionNumbers(part.parameters(AIR).__getitem__))

    monostable = valve("5/2 monostable", pilot_a="line", pilot_pressure="3 bar g", switching_time="20 ms")
    assert lines(monostable) == [
        "5/2 monostable", "C = 2 dm³/(s bar)", "b = 0.3", "switches in 0.02 s", "pilots at 3 bar g",
    ]  # fmt: skip
    assert lines(valve("5/3 closed"))[-1] == "switches in 0.01 s*"
    assert lines(valve())[0] == "5/3, nothing open at the centre"


def test_each_function_has_its_own_symbol():
    drawn = {
        valve(function, **pilots).symbol_for(False)
        for function in FUNCTIONS
        for pilots in ({}, *([{"pilot_a": "line"}] if function in SWITCHED else []))
    }
    assert len(drawn) == len(FUNCTIONS) + len(SWITCHED)
    assert valve().symbol_for(True) is SpoolValve.symbol


def test_pilot_can_be_a_port_of_the_valve():
    parts = {"rail": Reservoir(pressure="7 bar"), "first": Chamber(volume="1 l"), "second": Chamber(volume="1 l")}
    holding = valve("5/2 monostable", pilot_a="first", pilot_pressure="3 bar")
    circuit = Circuit({**parts, "valve": holding}, {"valve.command": Steps([0.0, 0.5], [1.0, 0.0])})
    recording = circuit.simulate(1.5, 1e-2)
    assert recording["first.pressure"][50] > 3e5
    # The pressure at port a holds the valve without its command.
    assert recording["valve.position"][-1] == pytest.approx(1.0, abs=1e-6)


def test_a_tube_can_end_at_a_pilot_port():
    parts = {
        "rail": Reservoir(pressure="7 bar"), "first": Chamber(volume="1 l"), "second": Chamber(volume="1 l"),
        "start": DirectionalValve(supply="rail", outlet="line", exhaust="ambient", **SIZE),
        "line": Tube(from_="start.outlet", to="valve.pilot_a", length="5 m", bore="4 mm", cells=4),
        "valve": valve("5/2 monostable", pilot_a="line"),
    }  # fmt: skip
    recording = Circuit(parts, {"start.command": Steps([0.0, 0.1], [0.0, 1.0])}).simulate(0.5, 1e-3)
    position = recording["valve.position"]
    assert position[100] == -1.0
    assert position[-1] == pytest.approx(1.0, abs=1e-6)
    # The last cell of the tube switches the valve.
    switched = recording.time[position > -0.99][0]
    assert switched == pytest.approx(recording.time[recording["line.4.pressure"] > 3.5e5][0], abs=2e-3)


def test_a_pilot_valve_drives_the_body_of_the_cylinder():
    circuit = load(Path(__file__).parents[3] / "examples" / "piloted_valve.toml")
    assert {"extend.command", "retract.command"} <= set(circuit.drives()["slide"])
