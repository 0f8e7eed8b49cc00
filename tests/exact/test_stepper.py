"""Steps, transitions and derivatives against closed forms and an independent tank."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.circuit.stepper import Stepper

DENSITY, WARM, GAS, EXPONENT = 1.185, 293.15, 287.0, 1.4
"""ISO 6358 reference density [kg/m^3] and temperature [K]; gas constant [J/(kg K)] and isentropic exponent of air."""
VOLUME, WALL = 2e-3, 0.8
FREE = (
    "fill.sonic_conductance",
    "leak.sonic_conductance",
    "leak.critical_ratio",
    "tank.wall_conductance",
    "supply.pressure",
)
VALUES = np.array([1e-8, 4e-9, 0.25, WALL, 7e5])
STATE = np.array([2.7e5, 2.7e5 * VOLUME / (GAS * 301.0)])
DT = 0.05


def ellipse(upstream, downstream, temperature, conductance, ratio):
    """Mass flow of ISO 6358, outside the regularised zone near equal pressures."""
    choked = upstream * conductance * DENSITY * np.sqrt(WARM / temperature)
    x = downstream / upstream
    # Comparisons of the real parts, for complex steps.
    if np.real(x) <= np.real(ratio):
        return choked
    return choked * np.sqrt(1.0 - ((x - ratio) / (1.0 - ratio)) ** 2)


def rates(x, theta):
    """Rates of pressure and mass of a tank with heat through its wall, filled from a supply, with a leak."""
    (pressure, mass), (fill, leak, ratio, wall, supply) = x, theta
    temperature = pressure * VOLUME / (mass * GAS)
    inflow = ellipse(supply, pressure, WARM, fill, 0.3)
    outflow = ellipse(pressure, 1e5, temperature, leak, ratio)
    heat_capacity = EXPONENT / (EXPONENT - 1.0) * GAS
    enthalpy = heat_capacity * (inflow * WARM - outflow * temperature) + wall * (WARM - temperature)
    return np.array([(EXPONENT - 1.0) / VOLUME * enthalpy, inflow - outflow])


def scipy_step(x, theta):
    run = solve_ivp(lambda _, z: rates(z, theta), (0.0, DT), x, "DOP853", rtol=1e-13, atol=1e-14 * np.abs(x))
    return run.y[:, -1]


def richardson(function, point, k):
    """Derivative by element k of the point, of order 6, from central differences with three steps."""

    def central(h):
        above, below = point.copy(), point.copy()
        above[k] += h
        below[k] -= h
        return (function(above) - function(below)) / (2.0 * h)

    a, b, c = (central(point[k] * h) for h in (4e-3, 2e-3, 1e-3))
    first, second = (4.0 * b - a) / 3.0, (4.0 * c - b) / 3.0
    return (16.0 * second - first) / 15.0


@pytest.fixture(scope="module")
def stepper() -> Stepper:
    circuit = Circuit(
        {
            "supply": Reservoir(pressure=7e5, temperature=WARM),
            "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
            "tank": Chamber(volume=VOLUME, wall_conductance=WALL, wall_temperature=WARM),
            "leak": Orifice(from_="tank", to="ambient", sonic_conductance=4e-9, critical_ratio=0.25),
        }
    ).with_values({"ambient.pressure": 1e5, "gas.gas_constant": GAS, "gas.isentropic_exponent": EXPONENT})
    stepper = circuit.stepper(FREE, tolerance=1e-9)
    assert stepper.states == ("tank.pressure", "tank.mass")
    assert np.array_equal(stepper.free_values, VALUES)
    return stepper


def test_step_of_an_independent_tank(stepper):
    theta = VALUES * [1.1, 0.8, 1.2, 2.0, 0.95]
    np.testing.assert_allclose(stepper.step(STATE, DT, free=theta), scipy_step(STATE, theta), rtol=1e-9)


def test_transition_of_an_independent_tank(stepper):
    transition = stepper.transition(STATE, DT)
    np.testing.assert_allclose(transition.state, scipy_step(STATE, VALUES), rtol=1e-9)
    by_state = np.array([richardson(lambda x: scipy_step(x, VALUES), STATE, k) for k in range(2)]).T
    by_free = np.array([richardson(lambda theta: scipy_step(STATE, theta), VALUES, k) for k in range(5)]).T
    size = np.abs(transition.state)[:, None]
    assert np.max(np.abs(transition.by_state - by_state) * STATE / size) < 1e-7
    assert np.max(np.abs(transition.by_free - by_free) * VALUES / size) < 1e-7
    # No derivative is zero.
    assert np.min(np.abs(by_free[0])) > 0.0


def test_derivatives_against_complex_steps(stepper):
    derivatives = stepper.derivatives(STATE)

    def complex_step(function, point):
        columns = []
        for k in range(point.size):
            shifted = point.astype(complex)
            shifted[k] += 1e-30j * point[k]
            columns.append(np.imag(function(shifted)) / (1e-30 * point[k]))
        return np.array(columns).T

    np.testing.assert_allclose(derivatives.rates, rates(STATE, VALUES), rtol=1e-12)
    by_state, by_free = complex_step(lambda x: rates(x, VALUES), STATE), complex_step(lambda p: rates(STATE, p), VALUES)
    np.testing.assert_allclose(derivatives.rates_by_state, by_state, rtol=1e-11, atol=1e-11 * np.abs(by_state).max())
    np.testing.assert_allclose(derivatives.rates_by_free, by_free, rtol=1e-11)


@pytest.mark.parametrize("dt", [0.01, 1.0])
def test_choked_emptying_has_a_closed_form(dt):
    conductance, volume = 1e-8, 5e-3
    circuit = Circuit(
        {
            "tank": Chamber(volume=volume, thermal="isothermal", wall_temperature=WARM),
            "hole": Orifice(from_="tank", to="ambient", sonic_conductance=conductance, critical_ratio=0.3),
        }
    ).with_values({"gas.gas_constant": GAS})
    stepper = circuit.stepper(["hole.sonic_conductance"], tolerance=1e-10)
    mass = np.array([9e5 * volume / (GAS * WARM)])
    # Choked at all times: p > p_ambient / b.
    rate = DENSITY * GAS * WARM / volume
    decay = math.exp(-conductance * rate * dt)
    transition = stepper.transition(mass, dt)
    np.testing.assert_allclose(transition.state, mass * decay, rtol=1e-9)
    np.testing.assert_allclose(transition.by_state, [[decay]], rtol=1e-8)
    np.testing.assert_allclose(transition.by_free, [[-rate * dt * mass[0] * decay]], rtol=1e-7)


def test_linear_inputs_have_a_closed_form():
    # Choked filling of an isothermal tank from a supply whose pressure rises linearly: the mass is a parabola.
    circuit = Circuit(
        {
            "supply": Reservoir(pressure=9e5, temperature=WARM),
            "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-9, critical_ratio=0.5),
            "tank": Chamber(volume=1e-2, thermal="isothermal", initial_pressure=1e5),
        }
    )
    stepper = circuit.stepper(tolerance=1e-9)
    u = np.array([stepper.default_inputs()] * 2)
    pressure, dt = stepper.inputs.index("supply.pressure"), 0.4
    u[:, pressure] = 8e5, 9e5
    x = stepper.start()
    expected = x + 1e-9 * DENSITY * (8e5 * dt + 0.5 * 1e5 * dt)
    np.testing.assert_allclose(stepper.step(x, dt, u=u), expected, rtol=1e-10)
