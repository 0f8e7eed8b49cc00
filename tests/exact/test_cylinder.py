"""What cylinders and bodies do where closed forms say it: gas springs, free fall, stops, sticking, break-away."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose

from poppet import Circuit
from poppet.parts import Cylinder, Joint, Mass
from poppet.timeseries.signals import Points, Steps

BORE, STROKE, DEAD, PRESSURE = 0.04, 0.2, 2e-5, 6e5
AREA = math.pi / 4 * BORE**2
MIDDLE = STROKE / 2


def spring_of_gas(body, conductance: float) -> Circuit:
    """Both sides closed, without a rod, the piston in the middle."""
    side = {"dead_volume": DEAD, "wall_conductance": conductance, "initial_pressure": PRESSURE}
    cylinder = Cylinder(body="slide", bore=BORE, stroke_length=STROKE, offset=MIDDLE, cap=side, rod=side)
    return Circuit({"slide": body, "cylinder": cylinder})


def frequency_of(recording, address: str) -> float:
    """From the crossings of zero upwards."""
    time, value = recording.time, recording[address]
    up = np.flatnonzero((value[:-1] < 0.0) & (value[1:] >= 0.0))
    crossings = time[up] - value[up] * (time[up + 1] - time[up]) / (value[up + 1] - value[up])
    return float((len(crossings) - 1) / (crossings[-1] - crossings[0]))


@pytest.mark.parametrize(("conductance", "exponent"), [(0.0, 1.4), (1e5, 1.0)])
def test_a_closed_cylinder_is_a_spring_of_gas(conductance, exponent):
    mass, volume = 3.0, DEAD + AREA * MIDDLE
    circuit = spring_of_gas(Mass(mass=mass, initial_velocity=0.005), conductance)
    recording = circuit.simulate(1.0, 1e-4, 1e-8)
    rate = 2.0 * exponent * PRESSURE * AREA**2 / volume
    assert frequency_of(recording, "slide.velocity") == pytest.approx(
        math.sqrt(rate / mass) / (2.0 * math.pi), rel=1e-3
    )


def test_a_joint_feels_the_spring_over_its_pulley():
    inertia, radius, volume = 0.02, 0.05, DEAD + AREA * MIDDLE
    circuit = spring_of_gas(Joint(inertia=inertia, pulley_radius=radius, initial_velocity=0.005 / radius), 0.0)
    rate = 2.0 * 1.4 * PRESSURE * AREA**2 / volume * radius**2
    recording = circuit.simulate(1.0, 1e-4, 1e-8)
    expected = math.sqrt(rate / inertia) / (2.0 * math.pi)
    assert frequency_of(recording, "slide.velocity") == pytest.approx(expected, rel=1e-3)
    assert recording["slide.velocity"].max() > 1e-3


def hollow(body: str = "slide", **more) -> Cylinder:
    """A cylinder that hardly pushes: a small piston without a rod between two rooms of the same pressure."""
    side = {"dead_volume": "1 m^3"}
    return Cylinder(body=body, bore="1 mm", stroke_length="10 m", offset="5 m", cap=side, rod=side, **more)


def test_free_fall_and_a_bumper_that_takes_energy():
    stop = {"position": -0.5, "stiffness": 1e7, "dissipation": 2.0}
    circuit = Circuit({"slide": Mass(mass=2.0, inclination="90 deg", lower_stop=stop), "cylinder": hollow()})
    recording = circuit.simulate(0.6, 1e-4)
    falling = recording.time < math.sqrt(2 * 0.5 / 9.80665) - 1e-3
    assert_allclose(recording["slide.position"][falling], -0.5 * 9.80665 * recording.time[falling] ** 2, atol=2e-6)
    speed = recording["slide.velocity"]
    assert 0.1 < speed.max() / -speed.min() < 0.9
    note = next(note for note in recording.remarks if note.code == "bodies.met_stop")
    assert note.facts["speed"] == pytest.approx(math.sqrt(2 * 9.80665 * 0.5), rel=1e-2)


LUGRE = {"kind": "lugre", "coulomb_force": 7.0, "static_force": 9.0, "stribeck_velocity": 0.01}


def pulled(force, friction, mass: float = 2.0, **more) -> Circuit:
    parts = {"slide": Mass(mass=mass, friction=friction, **more), "cylinder": hollow()}
    return Circuit(parts, {"slide.load_force": force})


def test_a_body_under_less_than_the_break_away_force_sticks():
    circuit = pulled(Steps([0.0], [-4.0]), LUGRE)
    recording = circuit.simulate(20.0)
    assert abs(recording["slide.position"][-1]) < 20e-6
    # At rest at where the bristles carry it, as far as a start with a jump of the load has bent them.
    assert abs(recording["slide.velocity"][-1]) < 1e-9
    assert recording["slide.friction_force"][-1] == pytest.approx(4.0, rel=1e-3)
    creeping = {**LUGRE, "kind": "stribeck", "transition_velocity": 1e-3}
    assert abs(pulled(Steps([0.0], [-4.0]), creeping).simulate(20.0)["slide.position"][-1]) > 5e-3


def test_it_breaks_away_at_the_static_force_and_slides_at_the_coulomb_force():
    circuit = pulled(Points([0.0, 10.0], [0.0, -10.0]), LUGRE)
    recording = circuit.simulate(10.0, 1e-3)
    moving = np.flatnonzero(recording["slide.velocity"] > 0.02)[0]
    assert 8.9 < recording.time[moving] < 9.2
    # Mass times acceleration is what is left of the load: friction at speed is Coulomb's.
    assert recording["slide.friction_force"][-1] == pytest.approx(7.0, rel=1e-6)


@pytest.mark.parametrize("address", ["slide.position", "slide.velocity"])
def test_friction_does_not_depend_on_the_tolerance(address):
    circuit = pulled(Points([0.0, 2.0, 4.0], [0.0, -20.0, 0.0]), LUGRE)
    loose, tight = (circuit.simulate(4.0, 1e-2, tolerance)[address] for tolerance in (1e-6, 5e-7))
    assert_allclose(loose, tight, atol=5e-3 * np.abs(tight).max())


def test_seals_rub_more_under_pressure():
    side = {"dead_volume": "1 m^3"}
    cap = side | {"initial_pressure": "5 bar"}
    cylinder = Cylinder(
        body="slide", bore="1 mm", stroke_length="10 m", offset="5 m", cap=cap, rod=side, seal_friction="10 N/bar"
    )
    circuit = Circuit(
        {"slide": Mass(mass=2.0, friction=LUGRE), "cylinder": cylinder}, {"slide.load_force": Steps([0.0], [-60.0])}
    )
    recording = circuit.simulate(0.5)
    assert recording["slide.friction_force"][-1] == pytest.approx(7.0 + 10.0 * 4.0, rel=1e-4)


def test_the_energy_of_a_body_is_what_was_done_on_it():
    circuit = pulled(Points([0.0, 2.0, 4.0], [0.0, -20.0, 5.0]), LUGRE, upper_stop={"position": 0.5})
    recording = circuit.simulate(4.0)
    motion = next(residual for residual in recording.residuals if residual.quantity == "motion")
    assert motion.is_kept
    assert motion.through > 1.0


def test_the_state_of_friction_tells_when_a_body_sticks():
    circuit = pulled(Points([0.0, 2.0, 4.0, 6.0], [0.0, -20.0, 0.0, 20.0]), LUGRE)
    recording = circuit.simulate(6.0, 1e-3)
    state, velocity = recording["slide.friction_state"], recording["slide.velocity"]
    assert set(state) == {-1.0, 0.0, 1.0}
    assert np.all(state[np.abs(velocity) < 0.9e-4] == 0.0)
    assert np.all(state[np.abs(velocity) > 1.1e-4] == np.sign(velocity[np.abs(velocity) > 1.1e-4]))
    # It holds until near the break-away force its bristles give way.
    assert 0.75 < recording.time[np.flatnonzero(state)[0]] < 0.92
