"""The sampled PID controller: sample by sample against a plain loop, limits, bumpless changes, schedules, errors."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, OutOfRangeError, Reservoir
from poppet.parts import PID
from poppet.parts.rows import GainSchedule
from poppet.signals import Points, Sine, Steps
from refusals import refused

T = 1e-3
NUMBERS = {"gain": 2e-5, "integral_time": 0.02, "derivative_time": 4e-3, "derivative_filter": 1.5e-3}
SCHEDULE = {
    "pressure": [1.5e5, 2.5e5, 4e5],
    "gain": [1e-5, 4e-5, 2e-5],
    "integral_time": [0.02, 0.05, 0.04],
    "derivative_time": [1e-3, 0.0, 2e-3],
    "vent_factor": [2.0, 1.0, 0.5],
}


def alone(part, duration=0.2, **signals):
    """A controller without a plant: the inputs at its instants, and what it gives until the next one."""
    driven = {f"c.{name}": signal for name, signal in signals.items()}
    recording = Circuit({"c": part}, driven).simulate(duration, T / 2)
    inputs = ("setpoint", "measurement", "automatic", "manual_command")
    series = {name: recording[f"c.{name}"][:-1:2] for name in inputs}
    outputs = [name for name in recording.names if name.partition(".")[2] not in inputs]
    return series | {name.partition(".")[2]: recording[name][1::2] for name in outputs} | {"time": recording.time[1::2]}


def limited_increment(increment, command, low, high):
    """Increment of the integral that moves the command at most to a margin beyond a limit."""
    margin = min(abs(increment), 0.1 * (high - low))
    if increment > 0.0:
        return min(increment, max(high + margin - command, 0.0))
    return max(increment, min(low - margin - command, 0.0))


def plain_loop(series, *, low=-1.0, high=1.0, gains=None, beta=1.0, band=0.0, bias=0.0, tracking=0.0):
    """The same law as a program of a microcontroller would have it; commands at each instant."""
    integral = derivative = 0.0
    origin = last = series["measurement"][0]
    last_gain = last_error = None
    commands, vents = [], []
    for w, y, auto in zip(series["setpoint"], series["measurement"], series["automatic"], strict=True):
        gain, ti, td, tf, phi = gains(y)
        e = w - y
        e = e - band if e > band else e + band if e < -band else 0.0
        proportional_error = e - (1.0 - beta) * (w - origin)
        if last_gain is not None:
            integral += (last_gain - gain) * last_error
        last_gain, last_error = gain, proportional_error
        derivative = (tf * derivative - gain * td * (y - last)) / (tf + T)
        last = y
        v = bias + gain * proportional_error + integral + derivative
        floor = max(low, -1.0 / phi) if low == -1.0 and phi > 1.0 else low / phi
        u = min(max(v, floor), high)
        if auto > 0.5:
            integral += limited_increment(gain * T / ti * e, v, floor, high) + T / (tracking or ti) * (u - v)
        else:
            u = 0.3
            integral = u - (v - integral)
        commands.append(u)
        vents.append(min(max(-u * phi, 0.0), 1.0))
    return np.array(commands), np.array(vents)


WAVE = Sine(3e5, 2e5, 17.0)
LEVELS = Steps([0.0, 0.0304, 0.1102], [3.2e5, 2.6e5, 3.9e5])
SWITCH = Steps([0.0, 0.0605, 0.0905], [1.0, 0.0, 1.0])


@pytest.mark.parametrize(
    ("fields", "options"),
    [
        ({}, {}),
        ({"setpoint_weight": 0.4, "dead_band": 4e3, "bias": 0.1}, {"beta": 0.4, "band": 4e3, "bias": 0.1}),
        ({"tracking_time": 0.1, "fill_limit": 0.6, "vent_limit": 0.2}, {"tracking": 0.1, "high": 0.6, "low": -0.2}),
    ],
)
def test_commands_are_those_of_a_plain_loop(fields, options):
    series = alone(
        PID(**NUMBERS, **fields),
        measurement=WAVE,
        setpoint=LEVELS,
        automatic=SWITCH,
        manual_command=Steps([0.0], [0.3]),
    )
    fixed = tuple(NUMBERS.values())
    commands, vents = plain_loop(series, gains=lambda _: (*fixed, 1.0), **options)
    assert np.max(np.abs(series["command"] - commands)) < 1e-9
    assert np.max(np.abs(series["vent_command"] - vents)) < 1e-9
    assert np.max(np.abs(series["fill_command"] - np.maximum(commands, 0.0))) < 1e-9
    assert np.ptp(commands) > 0.3


def test_scheduled_commands_are_those_of_a_plain_loop():
    filtered = NUMBERS["derivative_filter"]
    series = alone(
        PID(schedule=SCHEDULE, derivative_filter=filtered, setpoint_weight=0.6),
        measurement=WAVE, setpoint=LEVELS, automatic=SWITCH, manual_command=Steps([0.0], [0.3]),
    )  # fmt: skip

    def gains(y):
        gain, ti, td, phi = (np.interp(y, SCHEDULE["pressure"], SCHEDULE[k]) for k in list(SCHEDULE)[1:])
        return gain, ti, td, filtered, phi

    commands, vents = plain_loop(series, gains=gains, beta=0.6)
    below = commands >= -1.0 / np.array([gains(y)[4] for y in series["measurement"]]) - 1e-12
    assert below.all()
    assert np.max(np.abs(series["command"] - commands)) < 1e-9
    assert np.max(np.abs(series["vent_command"] - vents)) < 1e-9


def test_a_command_can_come_one_sample_later():
    signals = {"measurement": WAVE, "setpoint": LEVELS}
    at_once = alone(PID(**NUMBERS), **signals)
    later = alone(PID(**NUMBERS, acts="next_sample"), **signals)
    for name in ("command", "vent_command"):
        assert np.max(np.abs(later[name][1:] - at_once[name][:-1])) < 1e-12
        assert later[name][0] == 0.0


def test_the_change_to_automatic_makes_no_bump():
    series = alone(
        PID(gain=3e-6, integral_time=0.5),
        measurement=Steps([0.0], [2e5]), setpoint=Steps([0.0], [3e5]), automatic=Steps([0.0, 0.1005], [0.0, 1.0]),
        manual_command=Steps([0.0], [0.45]),
    )  # fmt: skip
    jumps = np.abs(np.diff(series["command"]))
    # What is left is the integral of one sample: K e T / T_i.
    assert np.max(jumps) <= 3e-6 * 1e5 * T / 0.5 * 1.001
    assert series["command"][50] == 0.45


def test_a_gain_that_changes_acts_on_changes_of_the_error():
    """At zero error, with a weight below one: the command follows the integral of K over the setpoint."""
    table = {"pressure": [1.5e5, 2.5e5], "gain": [1e-6, 4e-6], "integral_time": [0.1, 0.1]}
    ramp = Points([0.0, 0.1], [1.6e5, 2.4e5])
    series = alone(PID(schedule=table, setpoint_weight=0.2), measurement=ramp, setpoint=ramp)
    # A gain that multiplied the whole weighted error would give 0.8 K (w - w_0) = 0.237 at the end.
    assert series["command"][-1] == pytest.approx(-0.8 * (1.3e-6 + 3.7e-6) / 2.0 * 0.8e5, rel=1e-2)
    assert np.max(np.abs(np.diff(series["command"]))) < 0.8 * 3.7e-6 * 0.8e5 / 100 * 1.001


def test_the_integral_does_not_wind_up():
    """A supply too weak for the setpoint: when it falls, the command leaves its limit within a few samples."""
    part = PID(gain=1e-5, integral_time=0.05)
    series = alone(part, measurement=Steps([0.0], [2e5]), setpoint=Steps([0.0, 1.4998], [6e5, 1.9e5]), duration=2.0)
    k = int(np.searchsorted(series["time"], 1.4998))
    assert np.all(series["command"][:k] == 1.0)
    # The command before its limit, K e + I with K e = 4, exceeds the limit by one increment, K e T / T_i = 0.08.
    # Without anti-windup the integral would have grown to K e t / T_i = 120.
    assert abs(series["integral"][k - 1] + 4.0 - 1.08) < 2e-3
    assert series["command"][k] == -1.0


def test_a_lagging_sensor_shows_the_past():
    # What no other part gives begins at the ambient pressure.
    part = PID(**NUMBERS, sensor={"lag": "20 ms", "offset": "0.01 bar"})
    series = alone(part, measurement=Steps([0.0], [3e5]), setpoint=Steps([0.0], [3e5]))
    wanted = 3e5 - 2e5 * np.exp(-series["time"] / 0.02)
    assert np.max(np.abs(series["sensor_pressure"] - wanted)) < 1.0


def test_an_offset_of_the_sensor_is_controlled_away_wrongly():
    part = PID(gain=1e-5, sensor={"offset": "0.01 bar"})
    series = alone(part, measurement=Steps([0.0], [3e5]), setpoint=Steps([0.0], [3.2e5]))
    assert np.max(np.abs(series["command"] - 1e-5 * (0.2e5 - 1e3))) < 1e-12


def test_a_resumed_run_goes_on():
    circuit = Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "fill": Orifice(from_="supply", to="tank", sonic_conductance=5e-9, critical_ratio=0.3),
            "leak": Orifice(from_="tank", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3),
            "tank": Chamber(volume="1 l", thermal="isothermal"),
            "c": PID(gain=5e-5, integral_time=0.2, setpoint="4 bar", sensor={"lag": "2 ms"}),
        },
        connections={"c.measurement": "tank.pressure", "fill.opening": "c.fill_command"},
    )
    whole = circuit.simulate("2 s", "0.5 s", 1e-9)
    assert whole["c.sensor_pressure"][0] == whole["tank.pressure"][0]
    half = circuit.simulate("1 s", "0.5 s", 1e-9)
    rest = circuit.simulate("1 s", "0.5 s", 1e-9, start=half)
    assert abs(rest["tank.pressure"][-1] - whole["tank.pressure"][-1]) < 0.1
    assert abs(rest["c.integral"][-1] - whole["c.integral"][-1]) < 1e-6


def test_it_holds_a_tank():
    circuit = Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "fill": Orifice(from_="supply", to="tank", sonic_conductance=5e-9, critical_ratio=0.3),
            "vent": Orifice(from_="tank", to="ambient", sonic_conductance=5e-9, critical_ratio=0.3),
            "leak": Orifice(from_="tank", to="ambient", sonic_conductance=2e-10, critical_ratio=0.3),
            "tank": Chamber(volume="1 l", wall_conductance=1.0),
            "c": PID(gain=5e-5, integral_time=0.2, setpoint="4 bar"),
        },
        connections={
            "c.measurement": "tank.pressure",
            "fill.opening": "c.fill_command",
            "vent.opening": "c.vent_command",
        },
    )
    recording = circuit.simulate("5 s", "10 ms")
    assert abs(recording["tank.pressure"][-1] - 4e5) < 20.0
    assert abs(recording["c.command"][-1] - recording["fill.opening"][-1]) < 1e-12


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({}, "pid.no_gain"),
        ({"gain": 1e-5, "sample_time": 0.0}, "fields.out_of_range"),
        ({"gain": 1e-5, "sample_time": "-1 ms"}, "fields.out_of_range"),
        ({"gain": 1e-5, "setpoint_weight": 0.5}, "pid.lasting_error"),
        ({"gain": 1e-5, "schedule": SCHEDULE}, "pid.said_twice"),
        ({"schedule": {"pressure": [1e5, 2e5], "gain": [1, 2]}}, "fields.missing"),
        ({"schedule": SCHEDULE | {"gain": [1.0]}}, "schedule.unequal_lengths"),
        ({"schedule": SCHEDULE | {"gains": [1.0]}}, "fields.unknown"),
        ({"schedule": SCHEDULE | {"gain": 3.0}}, "schedule.not_a_list"),
        ({"schedule": SCHEDULE | {"integral_time": [0.1, 0.0, 0.2]}}, "fields.out_of_range"),
        ({"schedule": 4}, "schedule.not_a_table"),
        ({"gain": 1e-5, "acts": "later"}, "fields.not_an_option"),
    ],
)
def test_errors_are_reported(fields, message):
    with refused(message):
        PID(**fields)


def test_operating_points_rise():
    part = PID(schedule=SCHEDULE | {"pressure": [2e5, 1e5, 4e5]})
    with refused("schedule.not_rising", "c.schedule.pressure", kind=OutOfRangeError):
        alone(part, measurement=WAVE)


def test_numbers_of_a_schedule_have_addresses():
    circuit = Circuit({"c": PID(schedule=SCHEDULE)})
    changed = circuit.with_values({"c.schedule.gain_2": "3 1/bar"})
    assert changed.parameters["c.schedule.gain_2"] == pytest.approx(3e-5)
    assert changed.structure == circuit.structure
    with refused("names.unknown", "c.schedule.gain_9"):
        circuit.with_values({"c.schedule.gain_9": 1.0})


def test_a_schedule_keeps_its_last_points_beyond_them():
    schedule = GainSchedule.read({"pressure": ["1 bar g", "3 bar g"], "gain": [1.0, 3.0], "integral_time": [0.1, 0.2]})
    values = schedule.parameters(1e5)
    assert [schedule.at(p, values)["gain"] for p in (0.0, 2e5, 3e5, 9e5)] == [1.0, 1.0, 2.0, 3.0]
    assert schedule.at(3e5, values)["vent_factor"] == 1.0


def test_a_copy_keeps_its_schedule():
    part = PID(schedule=SCHEDULE)
    assert dataclasses.replace(part, dead_band="0.1 bar").schedule is part.schedule
