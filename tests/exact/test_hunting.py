"""A PID hunts against friction as textbooks say: period and amplitude against ideal stick-slip, and when it ends."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import expm

import poppet

FILE = Path(__file__).parents[2] / "examples" / "hunting.toml"
MASS, SLIDING, BREAKING, VISCOUS = 1.0, 1.0, 1.5, 0.4
GAIN, INTEGRAL, DERIVATIVE = 3.0, 4.0, 6.0


def stick_slip():
    """Half period and amplitude of the limit cycle of ideal friction: F_c while it slides, up to F_s while it sticks.

    Sliding is linear in (error, speed, command's integral); the rest is a map from one standstill to the next, which is
    followed until it repeats.
    """
    # e' = -v, v' = (K e + I - (D + c) v - F_c) / m towards positive v, I' = K_i e; the last state is one.
    a = np.zeros((4, 4))
    a[0, 1], a[2, 0] = -1.0, INTEGRAL
    a[1] = np.array([GAIN, -(DERIVATIVE + VISCOUS), 1.0, -SLIDING]) / MASS
    fine = expm(a * 1e-3)
    error, command, times = 0.5, 0.0, 0.0
    for _ in range(25):
        times = (BREAKING - command) / (INTEGRAL * error)  # stuck: the integral alone moves the command
        x = np.array([error, 0.0, BREAKING - GAIN * error, 1.0])
        while True:
            x = fine @ x
            times += 1e-3
            if x[1] <= 0.0:
                break
        # The next slide goes the other way: the same with all signs turned round.
        error, command = -x[0], -(GAIN * x[0] + x[2])
    return times, error


@cache
def run(duration="120 s", tolerance=1e-6, **changes):
    circuit = poppet.load(FILE).with_values({f"{a.replace('__', '.')}": v for a, v in changes.items()})
    recording = circuit.simulate(duration, "10 ms", tolerance)
    return recording.time, recording["slide.position"]


def cycle(time, position, since=60.0):
    """Period and amplitude of what goes up and down, from its upward crossings of the setpoint."""
    late = time >= since
    time, error = time[late], position[late] - 1.0
    k = np.flatnonzero((error[:-1] < 0.0) & (error[1:] >= 0.0))
    at = time[k] + (time[k + 1] - time[k]) * error[k] / (error[k] - error[k + 1])
    return float(np.mean(np.diff(at))), 0.5 * float(np.ptp(error))


def test_an_integral_against_static_friction_hunts():
    """Of ideal stick-slip, with stiff bristles and a narrow Stribeck curve: within a hundredth."""
    ideal = {"slide__friction__bristle_stiffness": 1e7, "slide__friction__bristle_damping": 1e7**0.5}
    half, amplitude = stick_slip()
    found = cycle(*run(slide__friction__stribeck_velocity="0.3 mm/s", **ideal))
    assert found == pytest.approx((2.0 * half, amplitude), rel=0.01)
    # The numbers of the paper, whose bristles break away after 15 um: 24.4 s and 64 mm.
    assert cycle(*run()) == pytest.approx((2.0 * half, amplitude), rel=0.03)


def test_the_hunting_does_not_depend_on_the_tolerance():
    assert cycle(*run(tolerance=5e-7)) == pytest.approx(cycle(*run()), rel=1e-5)


def test_it_ends_without_an_integral():
    """Where it then stands is less than break-away friction over the gain from the setpoint."""
    time, position = run(position__integral_time=0.0)
    assert np.ptp(position[time > 60.0]) < 1e-9
    assert 0.0 < 1.0 - position[-1] < BREAKING / GAIN


@pytest.mark.parametrize(("band", "ends"), [(40e-3, False), (80e-3, True)])
def test_it_ends_where_the_integral_rests_within_more_than_the_amplitude(band, ends):
    time, position = run(position__integral_dead_band=band)
    moved = np.ptp(position[time > 100.0])
    assert moved < 1e-9 if ends else moved > 0.1
    assert not ends or abs(position[-1] - 1.0) < band


def test_it_fades_where_friction_does_not_fall():
    time, position = run(slide__friction__static_force="1 N")
    first, last = (np.ptp(position[(time > begin) & (time < begin + 30.0)]) for begin in (30.0, 90.0))
    assert last < 0.3 * first
    assert last < 0.15 * np.ptp(run()[1][6000:])


def test_a_dead_band_of_the_whole_error_does_not_end_it_here():
    """Within the band the integral alone pushes on: the body slides through, and farther than without one."""
    assert cycle(*run(position__dead_band="80 mm"))[1] > 2.0 * cycle(*run())[1]


@cache
def cylinder(static=18.0, tolerance=1e-6, **fields):
    """Late error of a proportional loop with a cylinder behind a valve, whose gas integrates."""
    orifice = {"sonic_conductance": 1e-8, "critical_ratio": 0.45}
    side = {"dead_volume": 1e-5, "initial_pressure": 3e5, "wall_conductance": 0.5}
    friction = {"kind": "lugre", "coulomb_force": 12.0, "static_force": static, "viscous_coefficient": 60.0}
    parts = {
        "supply": poppet.Reservoir(pressure="7 bar"),
        "valve": poppet.SpoolValve(supply="supply", a="cylinder.cap", b="cylinder.rod", lag="1 ms", **orifice),
        "cylinder": poppet.Cylinder(bore="25 mm", stroke_length="0.2 m", body="slide", cap=side, rod=side),
        "slide": poppet.Mass(mass=2.0, initial_position=0.1, friction=friction),
        "c": poppet.PID(quantity="position", gain="3 1/m", sample_time="2 ms", setpoint="130 mm", **fields),
    }
    joined = {"c.measurement": "slide.position", "valve.command": "c.command"}
    recording = poppet.Circuit(parts, connections=joined).simulate("40 s", "5 ms", tolerance)
    return recording.time, recording["slide.position"] + (1.0 - 0.13)


def test_a_cylinder_hunts_without_an_integral_and_comes_to_rest_in_a_dead_band():
    """The gas is the integral: a valve open by a quarter of a per cent pushes until the piston breaks away."""
    period, amplitude = cycle(*cylinder(), since=20.0)
    assert 0.3e-3 < amplitude < 3e-3
    assert 0.5 < period < 5.0
    assert cycle(*cylinder(tolerance=5e-7), since=20.0) == pytest.approx((period, amplitude), rel=1e-3)
    for time, position in (cylinder(dead_band="2 mm"), cylinder(static=12.0)):
        assert np.ptp(position[time > 30.0]) < 1e-6
        assert abs(position[-1] - 1.0) <= 2e-3
