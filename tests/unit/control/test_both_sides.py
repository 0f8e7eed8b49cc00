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
        leak_flow = flow(leak, p, 1e5) if between is BETWEEN else -flow(leak, 7e5, p)
        return (max(u, 0.0) * flow(5e-9, 7e5, p) - factor * max(-u, 0.0) * flow(vent, p, 1e5) - leak_flow) / VOLUME

    leak_flow = -rate(pressure, 0.0)
    rest_command = (
        leak_flow / (rate(pressure, 1.0) + leak_flow)
        if leak_flow >= 0.0
        else leak_flow / (-leak_flow - rate(pressure, -1.0))
    )
    sign = 1.0 if side == "fill" else -1.0
    command = rest_command if rest_command * sign > 0.0 else 0.0
    slope = (rate(pressure, command + sign * 1e-4) - rate(pressure, command)) / (sign * 1e-4)
    decay = (rate(pressure + 10.0, command) - rate(pressure - 10.0, command)) / 20.0
    a = np.array([[decay, 0.0], [1.0 / LAG, -1.0 / LAG]])
    # Held from sample to sample: two thousand short steps instead of a matrix exponential.
    propagation, forced = np.eye(2), np.zeros(2)
    for _ in range(2000):
        propagation, forced = (
            propagation + TIME / 2000 * a @ propagation,
            forced + TIME / 2000 * (a @ forced + [slope, 0.0]),
        )
    # States: pressure, sensor, command on its way, integral.
    proportional, integral = gains.gain, gains.gain * TIME / gains.integral_time
    closed = np.zeros((4, 4))
    closed[:2, :2], closed[:2, 2] = propagation, forced
    closed[2, 1], closed[2, 3], closed[3, 1], closed[3, 3] = -proportional, 1.0, -integral, 1.0
    z = np.exp(2j * np.pi * np.geomspace(1e-3, 0.5 / TIME, 4000) * TIME)
    (h11, _), (h21, h22) = propagation
    behind = (h21 * forced[0] / (z - h11) + forced[1]) / (z - h22) / z
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
    checked = []
    for pressure in LEVELS:
        for side in point.sides:
            peak, pole = worst_of(pressure, side, point.gains, point.vent_factor if side == "vent" else 1.0, plant)
            reported = point.margins[f"{pressure / 1e5:.4g} bar, {side}"]
            assert peak == pytest.approx(max(reported.sensitivity, reported.complementary), rel=2e-2)
            checked.append(peak)
            assert pole < 1.0
            peak, pole = worst_of(pressure, side, point.gains, point.vent_factor if side == "vent" else 1.0, tight)
            assert peak < 1.5
            assert pole < 1.0
    assert max(checked) == pytest.approx(1.4, rel=1e-2)


def small_steps(circuit):
    """Return final error, final oscillation and overshoot of small steps at both levels."""
    recording = circuit.simulate("12 s", "4 ms")
    time, pressure = recording.time, recording["tank.pressure"]
    error = pressure - circuit.signals["c.setpoint"].evaluate(time)
    worst = []
    for k in (1, 2, 3, 5, 6, 7):
        steps, settled = ((time > 1.5 * k + begin) & (time < 1.5 * k + 1.49) for begin in (0.01, 1.19))
        sign = -np.sign(error[steps][0])  # of the step
        worst.append((np.max(np.abs(error[settled])), np.ptp(pressure[settled]), np.max(sign * error[steps])))
    return np.max(worst, axis=0)


@pytest.mark.parametrize(("plant", "other"), [(PLANTS[1], PLANTS[0]), (PLANTS[3], (0.0, 5e-8, BETWEEN))])
def test_small_steps_settle_on_leaking_and_tight_plant(plant, other):
    """The nonlinear loop settles with the gains of either plant on both plants."""
    for gains_of in (plant, other):
        for runs_on in (plant, other):
            error, swing, overshoot = small_steps(tuned(*gains_of).applied(loop(*runs_on)))
            assert error < 20.0
            assert swing < 20.0
            assert overshoot < 0.1 * 2e3


def test_gains_of_one_side_are_marked_and_fail_on_the_other():
    """Without the vent valve, only filling is bounded; with it, the bound is exceeded."""
    two_sided = loop(*PLANTS[2])
    fills = {target: source for target, source in two_sided.connections.items() if target != "vent.opening"}
    tuning = tune(replace(two_sided, connections=fills), at=LEVELS)
    assert tuning.bound_text == "Ms, Mt <= 1.4 filling at 2, 5 bar"
    (point,) = tuning.points
    peak, pole = worst_of(5e5, "vent", point.gains, point.vent_factor, PLANTS[2])
    assert peak > 3.0
    assert pole > 1.0
    assert small_steps(tuning.applied(two_sided))[2] > 0.15 * 2e3


@pytest.mark.parametrize("leak", [1e-16, 1e-14, 1e-12])
def test_small_leak_is_held_at_the_operating_point(leak):
    point = plant_of(loop(leak)).operating_point(LEVELS[0])
    assert point.value == pytest.approx(LEVELS[0], rel=1e-5)
    assert point.command == pytest.approx(leak / 5e-9 * flow(1.0, 2e5, 1e5) / flow(1.0, 7e5, 2e5), rel=1e-3)
    assert set(point.models) == {"fill", "vent"}


def test_the_result_names_the_bounded_sides():
    assert tuned(*PLANTS[1]).bound_text == "Ms, Mt <= 1.4 filling and venting at 2, 5 bar"
