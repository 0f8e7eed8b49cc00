"""End stops, seat ramp and friction."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet.laws.physics.contact import saturation, seat_fraction, stop_force, stribeck_friction

STIFFNESS, DISSIPATION = 7.07e9, 300.0
SEAL = (10.0, 15.0, 0.01, 1e-3, 20.0)
speeds = st.floats(-5.0, 5.0)
depths = st.floats(-1e-3, 1e-4)
laws = settings(derandomize=True, deadline=None, max_examples=200)


def jacobian_at(function, *values: float) -> np.ndarray:
    symbols = [ca.SX.sym(f"v{i}") for i in range(len(values))]
    gradient = ca.jacobian(function(*symbols), ca.vertcat(*symbols))
    return np.array(ca.Function("j", symbols, [gradient])(*values)).ravel()


def test_static_stop_force_is_the_power_law():
    assert stop_force(4e-6, 0.0, STIFFNESS, DISSIPATION) == pytest.approx(STIFFNESS * 8e-9, rel=1e-14)


def test_no_force_while_apart():
    assert stop_force(-1e-9, 5.0, STIFFNESS, DISSIPATION) == 0.0


@laws
@given(depths, speeds)
def test_stop_never_pulls(depth, speed):
    assert stop_force(depth, speed, STIFFNESS, DISSIPATION) >= 0.0


@laws
@given(st.floats(1e-9, 1e-4), st.floats(1e-4, 5.0))
def test_stop_takes_energy_out(depth, speed):
    """At each depth it pushes harder while the body comes than while it leaves."""
    coming = stop_force(depth, speed, STIFFNESS, DISSIPATION)
    assert coming > stop_force(depth, 0.0, STIFFNESS, DISSIPATION)
    assert coming > stop_force(depth, -speed, STIFFNESS, DISSIPATION)


def test_stop_grows_with_depth():
    force = stop_force(np.linspace(0.0, 1e-5, 1001), 0.02, STIFFNESS, DISSIPATION)
    assert np.all(np.diff(force) > 0.0)


@pytest.mark.parametrize("depth", [-1e-6, 0.0, 1e-16, 1e-6])
def test_stop_derivatives_are_finite(depth):
    gradient = jacobian_at(lambda d, v: stop_force(d, v, STIFFNESS, DISSIPATION), depth, 0.3)
    assert np.all(np.isfinite(gradient))


def test_stop_derivatives_are_exact():
    depth, speed, step = 3e-6, 0.002, 1e-5
    gradient = jacobian_at(lambda d, v: stop_force(d, v, STIFFNESS, DISSIPATION), depth, speed)
    by_depth = [stop_force(depth * (1 + sign * step), speed, STIFFNESS, DISSIPATION) for sign in (1, -1)]
    by_speed = [stop_force(depth, speed * (1 + sign * step), STIFFNESS, DISSIPATION) for sign in (1, -1)]
    assert gradient[0] == pytest.approx((by_depth[0] - by_depth[1]) / (2 * step * depth), rel=1e-8)
    assert gradient[1] == pytest.approx((by_speed[0] - by_speed[1]) / (2 * step * speed), rel=1e-8)


def test_stop_near_first_touch_differs_from_the_power_by_nothing_that_matters():
    depth = np.array([1e-16, 1e-15, 1e-12])
    error = np.abs(stop_force(depth, 0.0, STIFFNESS, 0.0) - STIFFNESS * depth**1.5)
    assert error.max() < 2e-13


def test_a_body_rebounds_as_the_library_says():
    """20 g at 0.1 m/s leave with 0.15 of their speed; symplectic steps of 10 ns."""
    mass, step, depth, speed = 0.020, 1e-8, 0.0, 0.1
    while not (speed < 0.0 and depth <= 1e-10):
        speed -= stop_force(depth, speed, STIFFNESS, DISSIPATION) / mass * step
        depth += speed * step
    assert -speed / 0.1 == pytest.approx(0.15, abs=0.005)


@pytest.mark.parametrize(("value", "expected"), [(0.0, 0.0), (0.75, 0.6), (-0.75, -0.6), (1e8, 1.0)])
def test_saturation(value, expected):
    assert saturation(value) == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize(("stroke", "expected"), [(-3e-6, 0.0), (-2e-6, 0.0), (-1e-6, 0.5), (0.0, 1.0), (1e-3, 1.0)])
def test_seat_fraction(stroke, expected):
    assert seat_fraction(stroke, 2e-6) == pytest.approx(expected, abs=1e-15)


def test_seat_fraction_has_no_kink():
    for edge in (-2e-6, 0.0):
        assert abs(jacobian_at(lambda x: seat_fraction(x, 2e-6), edge)[0]) < 1e-6


def test_friction_at_rest_break_away_and_sliding():
    assert stribeck_friction(0.0, *SEAL) == 0.0
    assert stribeck_friction(0.005, *SEAL) == pytest.approx(10.0 + 5.0 * np.exp(-0.25) + 0.1, rel=1e-3)
    assert stribeck_friction(1.0, *SEAL) == pytest.approx(30.0, rel=1e-14)


@laws
@given(speeds)
def test_friction_is_odd_and_dissipates(speed):
    force = stribeck_friction(speed, *SEAL)
    assert force == -stribeck_friction(-speed, *SEAL)
    assert force * speed >= 0.0


@pytest.mark.parametrize(
    "function",
    [
        lambda v: stop_force(v * 1e-6, v, STIFFNESS, DISSIPATION),
        lambda v: seat_fraction(v * 1e-6, 2e-6),
        lambda v: stribeck_friction(v, *SEAL),
    ],
)
def test_floats_arrays_and_symbols_agree(function):
    values = np.array([-1.7, -0.3, 0.0, 0.004, 0.9])
    symbol = ca.SX.sym("v")
    traced = ca.Function("f", [symbol], [function(symbol)])
    array = function(values)
    scale = np.max(np.abs(array))
    assert np.max(np.abs(array - [function(float(v)) for v in values])) <= 1e-15 * scale
    assert np.max(np.abs(array - [float(traced(v)) for v in values])) <= 1e-14 * scale
