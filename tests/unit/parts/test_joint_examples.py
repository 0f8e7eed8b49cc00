"""Joints and a cylinder that a valve positions: they come to their setpoints, whatever the load."""

from __future__ import annotations

import cmath
import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest

from poppet import Circuit, Orifice, Reservoir, load
from poppet.signals import Sine, Steps

EXAMPLES = Path(__file__).parents[3] / "examples"


def late(run, series: str, start: float, end: float):
    """Mean and half the swing of a series between two times."""
    rows = run[series][(run.time > start) & (run.time < end)]
    return rows.mean(), np.ptp(rows) / 2.0


def with_numbers(name: str, **numbers):
    return load(EXAMPLES / name).with_values({key.replace("__", "."): value for key, value in numbers.items()})


@pytest.mark.parametrize("load_torque", [3.0, 5.0, 7.0])
def test_the_muscle_joint_comes_to_its_steps(load_torque):
    """Also with a load that the bias does not know: the integral takes it over."""
    run = with_numbers("muscle_joint.toml", arm__load_torque=load_torque).simulate()
    for end, wanted in ((3.0, 40.0), (5.0, 20.0)):
        mean, swing = (math.degrees(each) for each in late(run, "arm.position", end - 0.5, end))
        assert mean == pytest.approx(wanted, abs=0.06)
        assert swing < 0.2  # what the valve's dead band leaves


def test_the_muscle_joint_follows_a_sine():
    circuit = load(EXAMPLES / "muscle_joint.toml")
    turn = 2.0 * math.pi * 0.5
    wave = Sine(mean=math.radians(25.0), amplitude=math.radians(10.0), frequency=0.5)
    run = dataclasses.replace(circuit, signals={"position.setpoint": wave}).simulate("6 s")
    k = run.time >= 2.0  # two whole periods
    angle, phase = np.degrees(run["arm.position"][k])[:-1], turn * run.time[k][:-1]
    assert angle.mean() == pytest.approx(25.0, abs=0.1)
    gain = 2.0 * abs(np.mean(angle * np.exp(-1j * phase))) / 10.0
    assert 0.95 < gain < 1.05


def test_a_wrong_law_in_the_controller_leaves_no_steady_error():
    run = with_numbers("muscle_joint.toml", inverse__sarosi__a5=2.3e-3).simulate()  # 14 % less than the muscle's
    assert math.degrees(late(run, "arm.position", 2.5, 3.0)[0]) == pytest.approx(40.0, abs=0.06)


def test_the_antagonistic_joint_keeps_its_angle_while_it_stiffens():
    run = load(EXAMPLES / "antagonistic_joint.toml").simulate()
    soft, stiff = (late(run, "joint.position", *span)[0] for span in ((1.0, 1.2), (2.6, 2.9)))
    assert math.degrees(soft) == pytest.approx(15.0, abs=0.05)
    assert math.degrees(stiff) == pytest.approx(15.0, abs=0.05)
    assert math.degrees(late(run, "joint.position", 4.5, 5.0)[0]) == pytest.approx(-10.0, abs=0.05)
    mean = (run["flexor.pressure"] + run["extensor.pressure"]) / 2.0
    pushed = []
    for start, wanted in ((1.2, 3e5), (2.9, 4.5e5)):
        before = (run.time > start - 0.2) & (run.time < start)
        assert mean[before].mean() == pytest.approx(wanted, rel=0.005)
        after = (run.time > start) & (run.time < start + 0.15)
        pushed.append(run["joint.position"][before][-1] - run["joint.position"][after].min())
    assert pushed[1] < pushed[0]
    assert all(residual.is_kept for residual in run.residuals)


def test_the_cylinder_follows_its_ramps():
    run = load(EXAMPLES / "cylinder_position.toml").simulate()
    error = run["slide.position"] - run["position.setpoint"]
    assert np.abs(error).max() < 6e-3
    for end in (1.5, 3.0):
        rows = (run.time > end - 0.3) & (run.time < end)
        # The overlap and dry friction: the valve is shut, and the piston rests.
        assert np.abs(error[rows]).max() < 1e-3
        assert np.ptp(error[rows]) < 1e-4


def test_meter_out_keeps_both_chambers_under_pressure():
    """The exhausts of the example are throttled; against a valve of which the supplies are."""
    circuit = load(EXAMPLES / "cylinder_position.toml")
    meter_in = {"valve.nominal_flow": "175 l/min ANR", "valve.exhaust_a_conductance": "1.4 dm^3/(s bar)"}
    lowest = []
    for each in (circuit, circuit.with_values(meter_in)):
        run = each.simulate("0.7 s")
        lowest.append(min(run[f"cylinder.{side}.pressure"][run.time > 0.3].min() for side in ("cap", "rod")))
    assert lowest[0] > lowest[1] + 3e4


def test_feed_forward_halves_what_a_ramp_is_behind():
    circuit = load(EXAMPLES / "cylinder_position.toml")
    signals = {name: signal for name, signal in circuit.signals.items() if name != "position.feedforward"}
    behind = []
    for each in (circuit, dataclasses.replace(circuit, signals=signals)):
        run = each.simulate("1.5 s")
        behind.append(np.abs(run["slide.position"] - run["position.setpoint"]).max())
    assert behind[0] < 0.5 * behind[1]


def stiffness(law, pressure: float, contraction: float) -> float:
    """Torque per angle of the pair at steady pressures, each of which pulls on a radius of 25 mm [N m/rad]."""
    step = 1e-6
    slope = (law.force(pressure, contraction - step) - law.force(pressure, contraction + step)) / (2.0 * step)
    return 2.0 * 0.025**2 / 0.3 * slope


@pytest.mark.parametrize("mean", [2.5e5, 5e5])
def test_the_mean_pressure_makes_a_joint_stiff(mean):
    """With valves that keep their pressures whatever flows, the joint yields as the law says."""
    circuit = load(EXAMPLES / "antagonistic_joint.toml")
    muscles = {side: dataclasses.replace(circuit.parts[side], hysteresis=None) for side in ("flexor", "extensor")}
    parts = {"joint": dataclasses.replace(circuit.parts["joint"], friction={"viscous_coefficient": 1.0}), **muscles}
    for side in muscles:
        parts[f"{side}_air"] = Reservoir(pressure=1e5 + mean)
        size = {"sonic_conductance": "20 dm^3/(s bar)", "critical_ratio": 0.3}
        parts[f"{side}_line"] = Orifice(from_=f"{side}_air", to=side, **size)
    run = Circuit(parts, {"joint.load_torque": Steps([0.0, 1.0], [0.0, 0.1])}).simulate("4 s", "10 ms")
    expected = 0.1 / stiffness(circuit.parts["flexor"].force_law(), mean, 0.09)
    assert -run["joint.position"][-1] == pytest.approx(expected, rel=0.01)


def test_feed_forward_of_the_force_makes_the_muscle_joint_follow_a_sine():
    """Of the load, from its equation of motion, and of what the controller takes from a moving setpoint."""
    circuit, frequency, amplitude = load(EXAMPLES / "muscle_joint.toml"), 1.0, math.radians(10.0)
    number = circuit.parameters
    gain, weight = number["position.gain"], number["position.setpoint_weight"]
    s, radius = 2j * math.pi * frequency, number["arm.pulley_radius"]
    moving = number["arm.inertia"] * s**2 + number["arm.friction.viscous_coefficient"] * s
    lead = number["position.derivative_time"] * s / (1.0 + number["position.derivative_filter"] * s)
    force = moving / radius + number["muscle.damping"] * radius * s + gain * (lead + 1.0 - weight)
    signals = {
        "position.setpoint": Sine(mean=math.radians(25.0), amplitude=amplitude, frequency=frequency),
        "position.feedforward": Sine(0.0, amplitude * abs(force), frequency, phase=cmath.phase(force)),
    }
    position = dataclasses.replace(circuit.parts["position"], feedforward=True)
    fed = dataclasses.replace(circuit, parts={**circuit.parts, "position": position}, signals=signals)
    signals = dict(signals)
    del signals["position.feedforward"]
    errors = []
    for each in (fed, dataclasses.replace(circuit, signals=signals)):
        run = each.simulate("4 s")
        errors.append(np.degrees(run["arm.position"] - run["position.setpoint"])[run.time >= 2.0])
    assert np.abs(errors[0]).max() < 0.8
    assert np.abs(errors[1]).max() > 6.0
    assert [error.mean() for error in errors] == pytest.approx([0.0, 0.0], abs=0.05)
