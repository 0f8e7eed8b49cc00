"""A PID of any quantity: units of its numbers, limits and feed-forward against a plain loop, cascades, refusals."""

from __future__ import annotations

import json

import numpy as np
import pytest

from poppet import Circuit, Cylinder, Mass, Orifice, OutOfRangeError, Reservoir
from poppet.circuit.schema import circuit_schema
from poppet.core.errors import UnitError
from poppet.parts import PID
from poppet.parts.quantities import COMMANDS, QUANTITIES, gain_unit
from poppet.parts.rows import GainSchedule
from poppet.parts.sampled_loop import SampledLoop
from poppet.signals import Sine, Steps
from refusals import refused

T = 1e-3
LIMITS = {"lower_limit": -40.0, "upper_limit": 55.0}
FORCE = {"quantity": "position", "command_quantity": "force", "sample_time": T, **LIMITS}
OPENING = {"command_quantity": "opening", "gain": 1.0, "upper_limit": None}
RISING = {"derivative_filter": 1.5e-3, "integral_time": 0.02, "derivative_time": 4e-3}


@pytest.mark.parametrize(
    ("quantity", "command"),
    [*((q, "opening") for q in QUANTITIES), *zip(QUANTITIES, QUANTITIES, strict=True), ("position", "pressure")],
)
def test_numbers_inputs_and_outputs_have_the_units_of_what_they_are(quantity, command):
    limits = {} if command == "opening" else {"lower_limit": 1.0, "upper_limit": 2.0}
    part = PID(gain=1.0, quantity=quantity, command_quantity=command, feedforward=True, **limits)
    unit, given = QUANTITIES[quantity].unit, COMMANDS[command].unit
    numbers = {name: number.unit for name, number in part.numbers().items()}
    assert {numbers[name] for name in ("setpoint", "dead_band", "sensor.offset")} == {unit}
    assert {numbers[name] for name in ("bias", "initial_integral", *limits)} == {given}
    assert numbers["gain"] == gain_unit(quantity, command)
    circuit = Circuit({"c": part})
    inputs = {item.name: item.unit for item in circuit.model.inputs}
    assert inputs == {
        "c.setpoint": unit, "c.measurement": unit, "c.input_fault": "1",
        "c.automatic": "1", "c.manual_command": given, "c.feedforward": given,
    }  # fmt: skip
    outputs = dict(circuit.model.outputs)
    shown = {"c.command": given, "c.integral": given, "c.derivative": given, f"c.sensor_{quantity}": unit}
    assert shown.items() <= outputs.items()
    assert ("c.fill_command" in outputs) == ("fill_limit" in numbers) == (command == "opening")
    assert all(circuit.simulate(0.01)["c.command"] >= (1.0 if limits else -1.0))


def test_a_pressure_loop_is_what_it_was_declared():
    plain, said = PID(gain=1e-5), PID(gain=1e-5, quantity="pressure", command_quantity="opening")
    assert plain == said
    assert plain.schedule is None
    assert {n: str(v) for n, v in plain.numbers().items()} == {
        "setpoint": "0 bar g", "sample_time": "1 ms", "sensor.lag": "0 s", "sensor.offset": "0 Pa", "fill_limit": "1",
        "vent_limit": "1", "fault_time": "0.1 s", "safe_command": "0",
        "gain": "1e-05 1/Pa", "derivative_filter": "5 ms", "setpoint_weight": "1",
        "tracking_time": "0 s", "bias": "0", "dead_band": "0 Pa", "initial_integral": "0",
    }  # fmt: skip
    names = {item.name for item in plain.inputs()}
    assert names == {"setpoint", "measurement", "input_fault", "automatic", "manual_command"}


def plain_loop(w, y, feed, gain, *, ti, td, tf, low, high, beta, band, quiet, bias):
    """The law as a program of a microcontroller would have it, with clamps and anti-windup."""
    integral = derivative = 0.0
    origin = last = y[0]
    commands = []
    for setpoint, measured, ahead in zip(w, y, feed, strict=True):
        e = setpoint - measured
        e = e - band if e > band else e + band if e < -band else 0.0
        derivative = (tf * derivative - gain * td * (measured - last)) / (tf + T)
        last = measured
        v = bias + gain * (e - (1.0 - beta) * (setpoint - origin)) + integral + derivative + ahead
        u = min(max(v, low), high)
        increment = gain * T / ti * (e if abs(e) > quiet else 0.0)
        margin = min(abs(increment), 0.1 * (high - low))
        increment = min(increment, max(high + margin - v, 0.0)) if increment > 0.0 else increment
        increment = max(increment, min(low - margin - v, 0.0)) if increment < 0.0 else increment
        integral += increment + T / ti * (u - v)
        commands.append(u)
    return np.array(commands)


def test_commands_of_a_position_loop_are_those_of_a_plain_loop():
    """Force per millimetre, with feed-forward into both limits: 20 N/mm over a wave of 3 mm."""
    part = PID(
        **FORCE, **RISING, gain="20 N/mm", setpoint_weight=0.7, dead_band="0.2 mm", integral_dead_band="0.8 mm",
        bias="-3 N", feedforward=True,
    )  # fmt: skip
    signals = {
        "c.measurement": Sine(1e-3, 3e-3, 7.0),
        "c.setpoint": Steps([0.0, 0.05, 0.12], [0.0, 4e-3, 1e-3]),
        "c.feedforward": Steps([0.0, 0.08, 0.16], [0.0, 35.0, -20.0]),
    }
    recording = Circuit({"c": part}, signals).simulate(0.2, T / 2)
    series = {name: recording[f"c.{name}"][:-1:2] for name in ("setpoint", "measurement", "feedforward")}
    numbers = {
        "ti": 0.02,
        "td": 4e-3,
        "tf": 1.5e-3,
        "low": -40.0,
        "high": 55.0,
        "beta": 0.7,
        "band": 2e-4,
        "quiet": 8e-4,
        "bias": -3.0,
    }
    wanted = plain_loop(*series.values(), 2e4, **numbers)
    assert np.max(np.abs(recording["c.command"][1::2] - wanted)) < 1e-6
    assert (wanted.min(), wanted.max()) == (-40.0, 55.0)  # both limits were met


def test_a_feed_forward_beyond_the_limit_does_not_wind_up():
    """A feed-forward of twice the limit for 2 s, at zero error: once it goes, the command is back within a sample."""
    part = PID(**FORCE, gain=1e3, integral_time=0.05, feedforward=True)
    signals = {"c.feedforward": Steps([0.0, 1.9998], [110.0, 0.0])}
    recording = Circuit({"c": part}, signals).simulate(3.0, T / 2)
    integral = recording["c.integral"][1::2]
    # Back-calculation takes back the excess: v = u_max at rest, so that the integral is -55 N.
    assert integral[1990] == pytest.approx(-55.0, abs=1e-6)
    assert recording["c.command"][1::2][2000] == -40.0
    # The excess beyond the lower limit is taken back with T_t = T_i: I(t) = -40 - 15 exp(-t / T_t).
    assert integral[2009] == pytest.approx(-40.0 - 15.0 * (1.0 - T / 0.05) ** 10, abs=1e-9)


def cylinder_loop(**inner):
    """A cylinder on a slide between four orifices, which one command opens crosswise."""
    orifice = {"sonic_conductance": "1 dm^3/(s bar)", "critical_ratio": 0.3}
    ends = {"cap_in": ("supply", "drive.cap"), "rod_out": ("drive.rod", "ambient"),
            "rod_in": ("supply", "drive.rod"), "cap_out": ("drive.cap", "ambient")}  # fmt: skip
    side = {"dead_volume": "10 cm^3", "initial_pressure": "3 bar", "wall_conductance": 0.5}
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        **{name: Orifice(from_=a, to=b, **orifice) for name, (a, b) in ends.items()},
        "drive": Cylinder(bore="25 mm", rod_diameter="0 mm", stroke_length="0.2 m", body="slide", cap=side, rod=side),
        "slide": Mass(mass="2 kg", initial_position="0.1 m", friction={"viscous_coefficient": "60 N s/m"}),
        "c": PID(quantity="position", gain="4 1/m", sample_time="2 ms", **inner),
    }
    opened = {"cap_in": "fill", "rod_out": "fill", "rod_in": "vent", "cap_out": "vent"}
    connections = {f"{name}.opening": f"c.{way}_command" for name, way in opened.items()}
    return Circuit(
        parts,
        {"c.setpoint": Steps([0.0, 0.1], [0.1, 0.13])},
        connections=connections | {"c.measurement": "slide.position"},
    )


def test_a_position_loop_positions_a_cylinder():
    recording = cylinder_loop(sensor={"lag": "1 ms"}).simulate("3 s", "5 ms")
    assert recording["slide.position"][-1] == pytest.approx(0.13, abs=1e-5)
    assert np.max(np.abs(recording["c.sensor_position"] - recording["slide.position"])) < 1e-3
    offset = cylinder_loop(sensor={"offset": "2 mm"}).simulate("3 s", "5 ms")
    assert offset["slide.position"][-1] == pytest.approx(0.128, abs=1e-5)


def test_a_loop_further_in_meets_no_command_of_zero():
    """The inner loop samples before the outer one has: it is given the outer one's bias, not a vacuum."""
    inner = PID(gain=1e-5, setpoint="1 bar")
    outer = PID(quantity="force", command_quantity="pressure", gain="2 bar/kN", bias="3 bar", lower_limit="1 bar",
                upper_limit="2 bar g", sample_time="5 ms")  # fmt: skip
    circuit = Circuit({"inner": inner, "outer": outer}, {"outer.setpoint": Steps([0.0, 0.02], [0.0, -50.0])},
                      connections={"inner.setpoint": "outer.command"})  # fmt: skip
    recording = circuit.simulate(0.04, 1e-3)
    assert set(recording["inner.setpoint"].round(3)) == {3e5, 2.9e5}
    assert circuit.parameters["outer.upper_limit"] == pytest.approx(3e5)
    assert dict(circuit.model.outputs)["outer.command"] == "Pa"


def test_a_schedule_is_one_of_the_quantity():
    table = {"angle": ["-30 deg", "30 deg"], "gain": ["2 N m/rad", "4 N m/rad"], "integral_time": [0.1, 0.2]}
    numbers = {"command_quantity": "torque", "lower_limit": -9.0, "upper_limit": 9.0}
    part = PID(quantity="angle", schedule=table, **numbers)
    assert part.numbers()["schedule.angle_1"].unit == "rad"
    circuit = Circuit({"c": part}).with_values({"c.schedule.gain_2": "0.1 N m/deg"})
    assert circuit.parameters["c.schedule.gain_2"] == pytest.approx(18.0 / np.pi)
    values = part.schedule.parameters(1e5)
    assert part.schedule.at(0.0, values)["gain"] == pytest.approx(3.0)
    assert GainSchedule.read(part.schedule, "angle", "torque") is part.schedule
    with refused("fields.unknown", "schedule.pressure"):
        PID(quantity="angle", schedule=table | {"pressure": [1.0, 2.0]}, **numbers)
    with refused("fields.unknown", "schedule.vent_factor"):
        PID(quantity="angle", schedule=table | {"vent_factor": [1.0, 2.0]}, **numbers)
    with refused("fields.missing", "schedule.force"):
        PID(quantity="force", schedule=part.schedule, **numbers)


@pytest.mark.parametrize(
    ("fields", "code", "address"),
    [
        ({"setpoint": "3 N m"}, "quantity.other_quantity", "setpoint"),
        ({"setpoint": "3 bar"}, "quantity.other_quantity", "setpoint"),
        ({"dead_band": "1 Pa"}, "quantity.other_quantity", "dead_band"),
        ({"gain": "3 bar/N m"}, "quantity.unreadable_unit", "gain"),
        ({"gain": "3 1/bar"}, "quantity.other_quantity", "gain"),
        ({"sensor": {"offset": "1 mm"}}, "quantity.other_quantity", "sensor.offset"),
        ({"bias": "1 N"}, "quantity.other_quantity", "bias"),
        ({"upper_limit": "0.5"}, "quantity.no_unit", "upper_limit"),
        ({"upper_limit": None}, "pid.no_limits", "upper_limit"),
        ({"fill_limit": 0.5}, "pid.other_limits", "fill_limit"),
        ({"vent_factor": 2.0}, "pid.other_limits", "vent_factor"),
        ({"command_quantity": "opening"}, "quantity.other_quantity", "upper_limit"),
        (OPENING | {"lower_limit": -1.0}, "pid.other_limits", "lower_limit"),
        ({"quantity": "weight"}, "fields.not_an_option", "quantity"),
        ({"command_quantity": "volts"}, "fields.not_an_option", "command_quantity"),
    ],
)  # fmt: skip
def test_errors_are_reported(fields, code, address):
    right = {"quantity": "force", "command_quantity": "pressure", "gain": "2 bar/kN", "lower_limit": "1 bar",
             "upper_limit": "5 bar"}  # fmt: skip
    assert PID(**right).numbers()["gain"].value == 200.0
    with refused(code, kind=Exception) as caught:
        PID(**right | fields)
    problems = getattr(caught.value, "problems", None) or [caught.value]
    assert address in {each.address for each in problems}


def test_limits_in_the_wrong_order_are_refused():
    """Of gauge and absolute pressures only a circuit knows the order."""
    part = PID(quantity="force", command_quantity="pressure", gain=1.0, lower_limit="2 bar g", upper_limit="2.5 bar")
    with refused("pid.limits_exchanged", "c.lower_limit", kind=OutOfRangeError, upper=2.5e5):
        Circuit({"c": part})


def test_another_unit_is_refused_by_address():
    circuit = Circuit({"c": PID(**FORCE, gain="2 N/mm")})
    assert circuit.with_values({"c.gain": "3 N/cm"}).parameters["c.gain"] == 300.0
    with refused("quantity.other_quantity", "c.gain", kind=UnitError):
        circuit.with_values({"c.gain": "3 N m/mm"})
    # Defaults of another quantity do not pass for numbers of this one.
    with refused("fields.other_unit", "c.setpoint", kind=Exception):
        circuit.with_values({"c.quantity": "angle"})


@pytest.mark.parametrize("source", ["c.command", "slide.velocity", "drive.cap.pressure"])
def test_connections_of_other_units_are_refused(source):
    circuit = cylinder_loop()
    wrong = Circuit(circuit.parts, circuit.signals, connections={**circuit.connections, "c.measurement": source})
    with refused("wiring.other_unit", "connections.c.measurement", source=source, wanted="m"):
        _ = wrong.model


def test_the_note_of_an_unmeasured_loop_has_its_unit():
    notes = Circuit({"c": PID(**FORCE, gain=1.0)}).static_notes
    assert [(note.code, note.facts["unit"], note.facts["value"]) for note in notes] == [
        ("circuit.uncontrolled", "m", 0.0)
    ]


def test_the_schema_has_no_limits_that_another_quantity_does_not_have():
    fields = circuit_schema()["$defs"]["pid"]["properties"]
    assert "minimum" not in json.dumps(fields["setpoint"])
    assert "maximum" in json.dumps(fields["setpoint_weight"])
    assert fields["quantity"]["enum"] == [*QUANTITIES]
    assert {*QUANTITIES, "gain", "vent_factor"} <= set(fields["schedule"]["properties"])


def test_pictures_leave_out_what_any_sensor_shows():
    assert {f"sensor_{name}" for name in QUANTITIES} <= {*SampledLoop.internal_outputs}
