"""Tests of the bound for filling and venting: on tanks that are tight, leaking or fed."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.control import plant_of, tune
from poppet.parts import PID
from poppet.signals import Steps

TIME, LAG, VOLUME = 2e-3, 3e-3, 1e-3
GAS = 287.05 * 293.15
BETWEEN = "tank", "ambient"
FED = "supply", "tank"
LEVELS = 2e5, 5e5


def loop(leak=0.0, vent=5e-9, between=BETWEEN):
    """Return a loop on an isothermal volume of 1 l between 7 and 1 bar."""
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "fill": Orifice(from_="supply", to="tank", sonic_conductance=5e-9, critical_ratio=0.35, opening=0.0),
        "vent": Orifice(from_="tank", to="ambient", sonic_conductance=vent, critical_ratio=0.35, opening=0.0),
        "tank": Chamber(volume=VOLUME, thermal="isothermal", initial_pressure=LEVELS[0]),
        "c": PID(gain=1e-5, sample_time=TIME, sensor={"lag": LAG}, acts="next_sample"),
    }
    if leak:
        parts["leak"] = Orifice(from_=between[0], to=between[1], sonic_conductance=leak, critical_ratio=0.35)
    steps = Steps(np.arange(8) * 1.5, [2e5, 2.02e5, 2.0e5, 1.98e5, 5e5, 5.02e5, 5e5, 4.98e5])
    joined = {"fill.opening": "c.fill_command", "vent.opening": "c.vent_command", "c.measurement": "tank.pressure"}
    return Circuit(parts, {"c.setpoint": steps}, connections=joined)


@cache
def tuned(leak, vent, between=BETWEEN):
    return tune(loop(leak, vent, between), at=LEVELS)


def flow(conductance, upstream, downstream):
    """Return the flow after ISO 6358 as volume at tank temperature and 1 Pa per second."""
    ratio = downstream / upstream
    subsonic = np.sqrt(1.0 - ((ratio - 0.35) / 0.65) ** 2) if ratio > 0.35 else 1.0
    return conductance * upstream * 1e5 * subsonic * 1.185 * GAS / 1e5


def worst_of(pressure, side, gains, factor, plant):
    """Return Ms, Mt and the largest closed-loop pole, from the flow equation and the PI law alone."""
    leak, vent, between = plant

    def rate(p, u):
        lost = flow(leak, p, 1e5) if between is BETWEEN else -flow(leak, 7e5, p)
        return (max(u, 0.0) * flow(5e-9, 7e5, p) - factor * max(-u, 0.0) * flow(vent, p, 1e5) - lost) / VOLUME

    lost = -rate(pressure, 0.0)
    rest = lost / (rate(pressure, 1.0) + lost) if lost >= 0.0 else lost / (-lost - rate(pressure, -1.0))
    sign = 1.0 if side == "fill" else -1.0
    at = rest if rest * sign > 0.0 else 0.0
    slope = (rate(pressure, at + sign * 1e-4) - rate(pressure, at)) / (sign * 1e-4)
    decay = (rate(pressure + 10.0, at) - rate(pressure - 10.0, at)) / 20.0
    a = np.array([[decay, 0.0], [1.0 / LAG, -1.0 / LAG]])
    # Held from sample to sample: two thousand short steps instead of a matrix exponential.
    held, pushed = np.eye(2), np.zeros(2)
    for _ in range(2000):
        held, pushed = held + TIME / 2000 * a @ held, pushed + TIME / 2000 * (a @ pushed + [slope, 0.0])
    # States: pressure, sensor, command on its way, integral.
    proportional, integral = gains.gain, gains.gain * TIME / gains.integral_time
    closed = np.zeros((4, 4))
    closed[:2, :2], closed[:2, 2] = held, pushed
    closed[2, 1], closed[2, 3], closed[3, 1], closed[3, 3] = -proportional, 1.0, -integral, 1.0
    z = np.exp(2j * np.pi * np.geomspace(1e-3, 0.5 / TIME, 4000) * TIME)
    (h11, _), (h21, h22) = held
    behind = (h21 * pushed[0] / (z - h11) + pushed[1]) / (z - h22) / z
    open_loop = behind * (proportional + integral / (z - 1.0))
    peaks = np.abs(1.0 / (1.0 + open_loop)), np.abs(open_loop / (1.0 + open_loop))
    return max(map(np.max, peaks)), np.max(np.abs(np.linalg.eigvals(closed)))


PLANTS = [
    (0.0, 5e-9, BETWEEN), (1e-11, 5e-9, BETWEEN), (1e-11, 5e-8, BETWEEN), (1e-9, 5e-8, BETWEEN), (1e-10, 5e-9, FED),
]  # fmt: skip


@pytest.mark.parametrize("plant", PLANTS)
def test_filling_and_venting_keep_the_bound_on_leaking_and_tight_plant(plant):
    (point,) = tuned(*plant).points
    assert set(point.sides) == {"fill", "vent"}
    assert any(command != 0.0 for command in point.commands) == (plant[0] > 0.0)
    tight = (0.0, *plant[1:])
    found = []
    for pressure in LEVELS:
        for side in point.sides:
            peak, pole = worst_of(pressure, side, point.gains, point.vent_factor if side == "vent" else 1.0, plant)
            shown = point.margins[f"{pressure / 1e5:.4g} bar, {side}"]
            assert peak == pytest.approx(max(shown.sensitivity, shown.complementary), rel=2e-2)
            found.append(peak)
            assert pole < 1.0
            peak, pole = worst_of(pressure, side, point.gains, point.vent_factor if side == "vent" else 1.0, tight)
            assert peak < 1.5
            assert pole < 1.0
    assert max(found) == pytest.approx(1.4, rel=1e-2)


def small_steps(circuit):
    """Return final error, final oscillation and overshoot of small steps at both levels."""
    recording = circuit.simulate("12 s", "4 ms")
    time, pressure = recording.time, recording["tank.pressure"]
    error = pressure - circuit.signals["c.setpoint"].evaluate(time)
    worst = []
    for k in (1, 2, 3, 5, 6, 7):
        whole, late = ((time > 1.5 * k + begin) & (time < 1.5 * k + 1.49) for begin in (0.01, 1.19))
        sign = -np.sign(error[whole][0])  # of the step
        worst.append((np.max(np.abs(error[late])), np.ptp(pressure[late]), np.max(sign * error[whole])))
    return np.max(worst, axis=0)


@pytest.mark.parametrize(("plant", "other"), [(PLANTS[1], PLANTS[0]), (PLANTS[3], (0.0, 5e-8, BETWEEN))])
def test_small_steps_settle_on_leaking_and_tight_plant(plant, other):
    """The nonlinear loop settles with the gains of either plant on both plants."""
    for gains_of in (plant, other):
        for runs_on in (plant, other):
            error, swing, beyond = small_steps(tuned(*gains_of).applied(loop(*runs_on)))
            assert error < 20.0
            assert swing < 20.0
            assert beyond < 0.1 * 2e3


def test_gains_of_one_side_are_marked_and_fail_on_the_other():
    """Without the vent valve, only filling is bounded; with it, the bound is exceeded."""
    whole = loop(*PLANTS[2])
    fills = {target: source for target, source in whole.connections.items() if target != "vent.opening"}
    tuning = tune(replace(whole, connections=fills), at=LEVELS)
    assert tuning.bounded == "Ms, Mt <= 1.4 filling at 2, 5 bar"
    (point,) = tuning.points
    peak, pole = worst_of(5e5, "vent", point.gains, point.vent_factor, PLANTS[2])
    assert peak > 3.0
    assert pole > 1.0
    assert small_steps(tuning.applied(whole))[2] > 0.15 * 2e3


@pytest.mark.parametrize("leak", [1e-16, 1e-14, 1e-12])
def test_small_leak_is_held_at_the_operating_point(leak):
    point = plant_of(loop(leak)).operating_point(LEVELS[0])
    assert point.value == pytest.approx(LEVELS[0], rel=1e-5)
    assert point.command == pytest.approx(leak / 5e-9 * flow(1.0, 2e5, 1e5) / flow(1.0, 7e5, 2e5), rel=1e-3)
    assert set(point.models) == {"fill", "vent"}


def test_the_result_names_the_bounded_sides():
    assert tuned(*PLANTS[1]).bounded == "Ms, Mt <= 1.4 filling and venting at 2, 5 bar"
