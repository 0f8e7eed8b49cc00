"""Dead-zone compensation and acceleration feedback of the PID: plain program, bumpless changes, faults, errors."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from poppet import Circuit
from poppet.laws.physics.dead_zone import add_dead_zone, remove_dead_zone
from poppet.parts import PID
from poppet.signals import Points, Sine, Steps
from refusals import refused

T = 1e-3
GAINS = {"gain": 8.0, "integral_time": 0.1, "derivative_time": 0.02, "derivative_filter": 1.5e-3}
ZONES = {"fill_dead_zone": 0.06, "vent_dead_zone": 0.1, "dead_zone_smoothing": 0.02}
ACCELERATION = {"acceleration_time": 4e-3}


def position_pid(**fields):
    return PID(**{"quantity": "position", "sample_time": T} | GAINS | fields)


def alone(part, duration=0.3, **signals):
    """Return the inputs at each instant of a controller without a plant, and the outputs until the next instant."""
    driven = {f"c.{name}": signal for name, signal in signals.items()}
    recording = Circuit({"c": part}, driven).simulate(duration, T / 2)
    inputs = {item.name for item in part.inputs()}
    series = {name: recording[f"c.{name}"][:-1:2] for name in inputs}
    outputs = [name for name in recording.names if name.partition(".")[2] not in inputs]
    return series | {name.partition(".")[2]: recording[name][1::2] for name in outputs} | {"time": recording.time[1::2]}


class PlainProgram:
    """The same law as a program of a microcontroller would have it, with a table of the valve's opening."""

    def __init__(self, part, zones=(0.0, 0.0, 1.0), acceleration_time=0.0, factor=1.0, limits=(1.0, 1.0)):
        value = {name: number.value for name, number in part.numbers().items()}
        self.k, self.ti, self.td = value["gain"], value["integral_time"], value["derivative_time"]
        self.tf, self.ta, self.fault_time = value["derivative_filter"], acceleration_time, value["fault_time"]
        self.safe = value["safe_command"]
        rising, falling, h = zones
        falling /= factor
        self.high, self.low = limits[0], -limits[1] / factor
        # The compensation as a table: its inverse is the table read backwards.
        self.of_law = [-9.0, -h, 0.0, h, 9.0]
        self.of_valve = [-9.0 - falling, -h - falling, 0.0, h + rising, 9.0 + rising]
        self.integral = self.derivative = 0.0
        self.history: list[float] = []  # valid measurements in a row
        self.speed = self.acceleration = 0.0
        self.faulty = self.count = 0
        self.was_safe = False

    def valve(self, v):
        return float(np.interp(v, self.of_law, self.of_valve))

    def law(self, u):
        return float(np.interp(u, self.of_valve, self.of_law))

    def __call__(self, w, y, auto, manual, fault, ahead=None):
        self.faulty = self.faulty + 1 if fault else 0
        is_safe = self.faulty > 0 and (self.faulty - 1) * T >= self.fault_time * (1.0 - 1e-6)
        last = self.last if self.history or fault else y
        self.derivative = (self.tf * self.derivative - self.k * self.td * (y - last)) / (self.tf + T)
        if ahead is not None:
            self.acceleration = ahead
        else:
            fade = self.tf / (self.tf + T)
            if fault or len(self.history) < 2:
                self.acceleration *= fade
                self.speed = (y - last) / T
            else:
                before, self.speed = self.speed, fade * self.speed + (y - last) / (self.tf + T)
                self.acceleration = fade * self.acceleration + (self.speed - before) / (self.tf + T)
        self.history = [] if fault else [*self.history[-1:], y]
        self.last = y
        rest = self.k * (w - y) + self.derivative - self.k * self.ta**2 * self.acceleration
        if self.was_safe and not is_safe:
            self.integral = self.law(self.safe) - rest
        v = rest + self.integral
        low, high = self.law(self.low), self.law(self.high)
        u = self.safe if is_safe else min(max(self.valve(v) if auto else manual, self.low), self.high)
        if is_safe or not auto:
            self.integral = self.law(u) - rest
        else:
            step = self.k * T / self.ti * (w - y)
            margin = min(abs(step), 0.1 * (high - low))
            step = min(step, max(high + margin - v, 0.0)) if step > 0.0 else max(step, min(low - margin - v, 0.0))
            self.integral += step + T / self.ti * (min(max(v, low), high) - v)
        self.was_safe = is_safe
        return u


WAVE = Sine(0.1, 0.02, 7.0)
LEVELS = Steps([0.0, 0.0704, 0.1502], [0.1, 0.13, 0.02])
BY_HAND = {"automatic": Steps([0.0, 0.1005, 0.1305], [1.0, 0.0, 1.0]), "manual_command": Steps([0.0], [0.35])}
FAULT = Steps([0.0, 0.0305, 0.0335, 0.1805, 0.2405], [0.0, 1.0, 0.0, 1.0, 0.0])


@pytest.mark.parametrize(
    ("fields", "options"),
    [
        (ZONES, {"zones": (0.06, 0.1, 0.02)}),
        ({"fill_dead_zone": 0.06}, {"zones": (0.06, 0.06, 0.01)}),
        ({"vent_dead_zone": 0.06}, {"zones": (0.0, 0.06, 0.01)}),
        (ZONES | {"vent_factor": 2.5}, {"zones": (0.06, 0.1, 0.02), "factor": 2.5}),
        (ZONES | {"fill_limit": 0.5, "vent_limit": 0.3}, {"zones": (0.06, 0.1, 0.02), "limits": (0.5, 0.3)}),
        (ZONES | {"safe_command": 0.25}, {"zones": (0.06, 0.1, 0.02)}),
        (ACCELERATION, {"acceleration_time": 4e-3}),
        (ZONES | ACCELERATION, {"zones": (0.06, 0.1, 0.02), "acceleration_time": 4e-3}),
    ],
)
def test_commands_are_those_of_a_plain_program(fields, options):
    part = position_pid(**fields, fault_time="20 ms")
    series = alone(part, measurement=WAVE, setpoint=LEVELS, input_fault=FAULT, **BY_HAND)
    program = PlainProgram(part, **options)
    names = ("setpoint", "measurement", "automatic", "manual_command", "input_fault")
    inputs = zip(*(series[name] for name in names), strict=True)
    commands = np.array([program(w, y, auto > 0.5, manual, fault > 0.5) for w, y, auto, manual, fault in inputs])
    assert np.max(np.abs(series["command"] - commands)) < 1e-9
    factor = options.get("factor", 1.0)
    assert np.max(np.abs(series["vent_command"] - np.clip(-factor * commands, 0.0, 1.0))) < 1e-9
    assert commands.max() > 0.3
    assert commands.min() < -0.2
    assert np.count_nonzero(commands == fields.get("safe_command", 0.0)) > 30  # the safe state


def test_an_acceleration_can_be_an_input():
    part = position_pid(**ACCELERATION, acceleration_input=True)
    signals = {"measurement": WAVE, "setpoint": Steps([0.0], [0.1]), "acceleration": Sine(0.0, 30.0, 11.0)}
    series = alone(part, **signals)
    program = PlainProgram(part, acceleration_time=4e-3)
    inputs = zip(*(series[name] for name in ("setpoint", "measurement", "acceleration")), strict=True)
    commands = np.array([program(w, y, True, 0.0, False, a) for w, y, a in inputs])
    assert np.max(np.abs(series["command"] - commands)) < 1e-9
    assert np.max(np.abs(series["acceleration_feedback"])) == pytest.approx(8.0 * 4e-3**2 * 30.0, rel=1e-2)


def test_the_estimate_is_the_acceleration():
    """A parabola has a constant acceleration, from the third sample on behind two filters."""
    time = T * np.arange(301)
    part = position_pid(gain=1.0, integral_time=None, derivative_time=None, **ACCELERATION)
    series = alone(part, measurement=Points(time.tolist(), (2.5 * time**2).tolist()), setpoint=Steps([0.0], [0.0]))
    estimate = series["acceleration_feedback"] / -(4e-3**2)
    assert np.all(estimate[:2] == 0.0)
    assert np.max(np.abs(estimate[40:] - 5.0)) < 1e-6


def moving(break_at, fault_at, *, jump):
    """Return a command whose measurement moves at 1 m/s, jumps by `jump` during a fault, and then moves back."""
    time = T * np.arange(301)
    motion = np.where(time < break_at, time, break_at + jump - (time - break_at))
    fault = Steps([0.0, fault_at[0], fault_at[1]], [0.0, 1.0, 0.0])
    part = position_pid(gain=1.0, integral_time=None, derivative_time=None, **ACCELERATION, fault_time="1 s")
    signals = {"measurement": Points(time.tolist(), motion.tolist()), "setpoint": Steps([0.0], [0.0])}
    return alone(part, input_fault=fault, **signals)["acceleration_feedback"]


def test_a_fault_leaves_no_kick():
    """Jump and reversal during a fault cause no acceleration; the same motion without a fault causes a large one."""
    with_fault = moving(0.1, (0.0955, 0.1045), jump=0.05)
    without = moving(0.1, (1.0, 2.0), jump=0.05)
    # A jump of 50 mm in 1 ms between two filters.
    assert np.max(np.abs(without)) > 4e-3**2 * 0.05 / (2.5e-3) ** 2 * 0.9
    assert np.max(np.abs(with_fault)) < 1e-9


def test_the_change_to_automatic_makes_no_bump():
    part = position_pid(**ZONES, **ACCELERATION, derivative_time=None)
    still = {"measurement": Steps([0.0], [0.1]), "setpoint": Steps([0.0], [0.11])}
    for manual in (-0.4, -0.05, 0.0, 0.03, 0.07, 0.45):
        by_hand = {"automatic": Steps([0.0, 0.1005], [0.0, 1.0]), "manual_command": Steps([0.0], [manual])}
        command = alone(part, **still, **by_hand)["command"]
        assert command[50] == manual
        # The integral of one sample, K e T / T_i, times the largest slope of the compensation.
        assert np.max(np.abs(np.diff(command))) <= 8.0 * 0.01 * T / 0.1 * (1.0 + 0.1 / 0.02) * 1.001


def test_the_integral_does_not_wind_up_behind_the_compensation():
    """The limits are those of the valve: the integral stops one increment beyond the limit minus the dead zone."""
    part = position_pid(gain=4.0, integral_time=0.05, derivative_time=None, **ZONES)
    setpoint = Steps([0.0, 1.4998], [0.2, 0.09])
    series = alone(part, measurement=Steps([0.0], [0.1]), setpoint=setpoint, duration=2.0)
    k = int(np.searchsorted(series["time"], 1.4998))
    proportional, increment = 4.0 * 0.1, 4.0 * 0.1 * T / 0.05
    assert np.all(series["command"][k - 100 : k] == 1.0)
    # Without the compensation in the limits, it would be 1 + K e T / T_i.
    assert series["integral"][k - 1] + proportional == pytest.approx(0.94 + increment, abs=2e-4)
    # The command falls by K (w_1 - w_2) at the first sample with the new setpoint.
    assert series["command"][k] == pytest.approx(0.94 + increment - 4.0 * 0.11 + 0.06, abs=2e-3)
    assert series["uncompensated_command"][k] == pytest.approx(series["command"][k] - 0.06, abs=1e-12)


def test_a_schedule_changes_the_vent_dead_zone_with_its_factor():
    """The dead zone is that of the vent valve: its opening is the factor times the command of the law, plus it."""
    table = {"position": [0.0, 0.2], "gain": [4.0, 4.0], "integral_time": [0.0, 0.0], "vent_factor": [1.0, 3.0]}
    table |= {"integral_time": [10.0, 10.0]}
    part = PID(quantity="position", schedule=table, sample_time=T, **ZONES)
    ramp = Points([0.0, 0.3], [0.05, 0.15])
    series = alone(part, measurement=ramp, setpoint=Steps([0.0], [0.02]))
    factor = np.interp(series["measurement"], [0.0, 0.2], [1.0, 3.0])
    v = series["uncompensated_command"]
    assert np.all(v < -0.02)
    assert np.max(np.abs(series["vent_command"] - np.minimum(-factor * v + 0.1, 1.0))) < 1e-9


def test_zero_dead_zones_and_no_acceleration_change_nothing():
    signals = {"measurement": WAVE, "setpoint": LEVELS, **BY_HAND}
    plain = alone(position_pid(), **signals)
    others = [{"fill_dead_zone": 0.0}, {"acceleration_time": 0.0}]
    for other in others:
        assert np.array_equal(alone(position_pid(**other), **signals)["command"], plain["command"])
    assert "acceleration_feedback" not in plain
    assert "uncompensated_command" not in plain
    assert not {"dead_zone_smoothing", "fill_dead_zone", "acceleration_time"} & set(position_pid().numbers())


def test_the_compensation_inverts_a_dead_zone():
    """Behind it, a valve that opens beyond its dead zones opens by the command of the law."""
    v = np.linspace(-1.0, 1.0, 4001)
    for rising, falling, h in ((0.1, 0.2, 0.02), (0.0, 0.3, 0.5), (0.05, 0.05, 1e-6)):
        u = add_dead_zone(v, rising, falling, h)
        opening = np.where(u > rising, u - rising, np.where(u < -falling, u + falling, 0.0))
        is_complete = np.abs(v) >= h
        assert np.max(np.abs(opening - v)[is_complete], initial=0.0) < 1e-15
        assert np.max(np.abs(opening - v)[~is_complete], initial=0.0) <= h
        closed = (v > 0.0) & (v < h * rising / (h + rising))
        assert np.all(np.abs(opening[closed]) < 1e-15)
        assert np.all(np.diff(u) > 0.0)
        assert np.max(np.abs(remove_dead_zone(u, rising, falling, h) - v)) < 1e-15
        # Continuous: no step exceeds the largest slope.
        steps = [b - a for a, b in pairwise(u)]
        assert max(steps) <= (v[1] - v[0]) * (1.0 + max(rising, falling) / h) * 1.001


@pytest.mark.parametrize(
    ("fields", "code", "address"),
    [
        ({"dead_zone_smoothing": 0.01}, "pid.no_dead_zone", "dead_zone_smoothing"),
        ({"fill_dead_zone": 1.0}, "fields.out_of_range", "fill_dead_zone"),
        ({"vent_dead_zone": -0.1}, "fields.out_of_range", "vent_dead_zone"),
        ({"fill_dead_zone": 0.1, "dead_zone_smoothing": 0.0}, "fields.out_of_range", "dead_zone_smoothing"),
        ({"acceleration_time": "-1 ms"}, "fields.out_of_range", "acceleration_time"),
        ({"acceleration_input": True}, "pid.unused_acceleration", "acceleration_input"),
        ({"quantity": "pressure", "acceleration_time": "1 ms"}, "pid.no_acceleration", "acceleration_time"),
        (
            {"command_quantity": "force", "lower_limit": -1, "upper_limit": 1, "vent_dead_zone": 0.1},
            "pid.other_dead_zone", "vent_dead_zone",
        ),
    ],
)  # fmt: skip
def test_errors_are_reported(fields, code, address):
    with refused(code, address):
        position_pid(**fields)
