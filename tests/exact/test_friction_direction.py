"""Friction that depends on direction and position: an independent simulation, closed forms and dissipation."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose

from exact.independent_friction import simulate_directed
from exact.test_cylinder import hollow, pulled
from poppet import Circuit
from poppet.parts import Joint, Mass
from poppet.parts.bodies import BRISTLE_LAWS, DRY_LAWS
from poppet.parts.part import Scope
from poppet.timeseries.signals import Points, Steps

MASS = 4.0
FACTOR = {"position": [-0.01, 0.0, 0.02, 0.05], "factor": [0.8, 1.0, 1.5, 0.7]}
LAW: dict[str, Any] = {
    "Fc": (10.0, 16.0), "Fs": (15.0, 19.0), "s2": (30.0, 90.0), "zba": (6e-6, 6e-6), "vs": 0.01, "vt": 2e-3,
    "s0": 1.5e6, "s1": 2000.0, "factor": (FACTOR["position"], FACTOR["factor"]),
}  # fmt: skip
COMMON = {"stribeck_velocity": 0.01, "transition_velocity": 2e-3, "bristle_stiffness": 1.5e6, "bristle_damping": 2000.0}
FORWARDS = {"coulomb_force": 10.0, "static_force": 15.0, "viscous_coefficient": 30.0}
BACKWARDS = {"negative_coulomb_force": 16.0, "negative_static_force": 19.0, "negative_viscous_coefficient": 90.0}


def friction_of(kind: str, **changes: Any) -> dict[str, Any]:
    elastic = {"breakaway_displacement": 6e-6} if kind == "elasto_plastic" else {}
    return {"kind": kind, **COMMON, **FORWARDS, **BACKWARDS, "position_factor": FACTOR, **elastic, **changes}


@pytest.mark.parametrize("kind", ["viscous", *DRY_LAWS])
def test_motion_agrees_with_an_independent_simulation(kind):
    times = np.linspace(0.0, 2.0, 201)
    corners, forces = [0.0, 0.3, 0.5, 0.9, 1.2, 1.6, 2.0], [0.0, 13.0, 26.0, 2.0, -24.0, -29.0, 20.0]
    if kind == "viscous":
        forces = [force / 10.0 for force in forces]
    expected = simulate_directed({**LAW, "kind": kind}, MASS, lambda t: np.interp(t, corners, forces), times)
    load = Points(corners, [-force for force in forces])
    recording = pulled(load, friction_of(kind), MASS).simulate(2.0, 0.01, 1e-8)
    found = [recording[f"slide.{name}"] for name in ("position", "velocity", "friction_force")]
    # Both directions, over several rows of the table.
    assert expected[1].max() > 0.01
    assert expected[1].min() < -0.01
    assert np.ptp(expected[0]) > 0.02
    for values, series in zip(found, expected, strict=True):
        assert np.abs(values - series).max() < 2e-4 * np.abs(series).max()


@pytest.mark.parametrize("kind", ["viscous", *DRY_LAWS])
def test_equal_values_in_both_directions_are_one_law(kind):
    load = Points([0.0, 0.5, 1.0], [0.0, -25.0, 25.0])
    same = {f"negative_{name}": value for name, value in FORWARDS.items()}
    constant = {"position": [0.0, 0.01], "factor": [1.0, 1.0]}
    plain = {name: value for name, value in friction_of(kind).items() if not name.startswith(("negative", "position"))}
    one, two = (
        pulled(load, friction, MASS).simulate(1.0, 0.01, 1e-8)["slide.position"]
        for friction in (plain, {**plain, **same, "position_factor": constant})
    )
    assert_allclose(two, one, atol=1e-9 * np.abs(one).max())


def test_omitted_values_at_negative_velocity_are_those_at_positive_velocity():
    friction = {"kind": "elasto_plastic", "coulomb_force": 10.0, "static_force": 15.0, "viscous_coefficient": 30.0}
    slide = Mass(mass=1.0, friction={**friction, "negative_coulomb_force": 4.0})
    values = slide.parameters(Circuit({"slide": slide, "cylinder": hollow()}).surroundings)
    assert values["friction.negative_static_force"] == 15.0
    assert values["friction.negative_viscous_coefficient"] == 30.0
    # The largest level gives the stiffness, and each direction its elastic deflection.
    assert values["friction.bristle_stiffness"] == pytest.approx(15.0 / 1e-5)
    assert values["friction.breakaway_displacement"] == pytest.approx(0.95 * 10.0 / 1.5e6)
    assert values["friction.negative_breakaway_displacement"] == pytest.approx(0.95 * 4.0 / 1.5e6)


@pytest.mark.parametrize("kind", DRY_LAWS)
@pytest.mark.parametrize(("force", "coulomb", "viscous"), [(30.0, 10.0, 30.0), (-30.0, 16.0, 90.0)])
def test_final_speed_in_both_directions(kind, force, coulomb, viscous):
    circuit = pulled(Steps([0.0], [-force]), friction_of(kind, position_factor=None), 0.1)
    recording = circuit.simulate(0.2, relative_tolerance=1e-8)
    assert recording["slide.velocity"][-1] == pytest.approx(math.copysign((30.0 - coulomb) / viscous, force), rel=1e-3)


@pytest.mark.parametrize("kind", BRISTLE_LAWS)
def test_a_body_breaks_away_at_the_static_force_of_its_direction_and_position(kind):
    for sign, static in ((1.0, 15.0), (-1.0, 19.0)):
        for position, factor in ((0.0, 1.0), (0.02, 1.5)):
            level = static * factor
            load = Points([0.0, 1.0, 3.0], [0.0, -0.9 * sign * level, -1.1 * sign * level])
            circuit = pulled(load, friction_of(kind), 0.5, initial_position=position)
            recording = circuit.simulate(3.0, 0.005)
            travel = sign * (recording["slide.position"] - position)
            force = -recording["slide.load_force"] * sign
            slides = travel > 1e-4
            assert force[slides][0] == pytest.approx(level, rel=0.03)
            assert recording["slide.breakaway_force"][100] == pytest.approx(level, rel=1e-3)


@pytest.mark.parametrize("kind", ["viscous", *DRY_LAWS])
def test_friction_never_generates_energy(kind):
    """F v >= d(s0 z^2 / 2)/dt in 20,000 random states, with a damping that satisfies the condition of Barahona."""
    generator = np.random.default_rng(7)
    slide = Mass(mass=MASS, friction=friction_of(kind))
    circuit = Circuit({"slide": slide, "cylinder": hollow()})
    values = slide.parameters(circuit.surroundings)
    smallest = math.inf
    for _ in range(20000):
        speed = generator.choice([-1.0, 1.0]) * 10.0 ** generator.uniform(-6.0, 0.5)
        states = {
            "position": generator.uniform(-0.02, 0.06), "velocity": speed, "deflection": 3e-5 * generator.uniform(-1, 1)
        }  # fmt: skip
        dynamics = slide.dynamics(Scope(values, states, {"load_force": 0.0}, circuit.surroundings), 0.0, 0.0)
        power = dynamics.outputs["friction_force"][0] * speed
        stored = 1.5e6 * states["deflection"] * dynamics.rates.get("deflection", 0.0)
        smallest = min(smallest, (power - stored) / (abs(power) + abs(stored) + 1e-12))
    assert smallest > -1e-12


def test_a_cycle_with_direction_dependent_friction_dissipates_the_work_of_both_directions():
    """Slowly there and back over 20 mm: the work is the sum of the Coulomb forces times the travel."""
    friction = friction_of("lugre", static_force=10.0, negative_static_force=16.0)
    friction |= {"viscous_coefficient": 0.0, "negative_viscous_coefficient": 0.0, "position_factor": None}
    recording = pulled(Points([0.0, 1.0, 2.0, 3.0, 4.0], [-12.0, -12.0, 20.0, 20.0, 0.0]), friction, 50.0).simulate(
        4.0, 0.001, 1e-8
    )
    velocity, force = recording["slide.velocity"], recording["slide.friction_force"]
    lost = np.trapezoid(force * velocity, recording.time)
    forwards, backwards = (np.trapezoid(np.clip(sign * velocity, 0.0, None), recording.time) for sign in (1.0, -1.0))
    assert min(forwards, backwards) > 0.01
    assert lost == pytest.approx(10.0 * forwards + 16.0 * backwards, rel=2e-3)


def test_a_joint_has_friction_by_direction_and_angle():
    friction = {
        "viscous_coefficient": 0.5, "negative_viscous_coefficient": 2.0,
        "position_factor": {"position": ["0 deg", "90 deg"], "factor": [1.0, 3.0]},
    }  # fmt: skip
    joint = Joint(inertia=0.01, pulley_radius=0.05, friction=friction, initial_velocity=-1.0, initial_position=math.pi)
    recording = Circuit({"slide": joint, "cylinder": hollow()}).simulate(1e-4, 1e-4)
    assert recording["slide.friction_torque"][0] == pytest.approx(-2.0 * 3.0)
