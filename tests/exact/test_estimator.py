"""The estimator against closed forms, textbook filters written here, and differences of other solvers."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import poppet
from estimators import estimator_of
from poppet import Chamber, Circuit, Orifice
from poppet.engine.estimator_call import EstimatorCall
from poppet.engine.model import InputInfo, Model, StateInfo
from poppet.engine.problem import Outcome
from poppet.laws.physics import tanks

sys.path.insert(0, str(Path(__file__).parents[1] / "laws"))
sys.path.insert(0, str(Path(__file__).parent))
import independent_watch_tank as independent
from seeded_pneumatics import random_circuit

Array = np.ndarray


def differences(function: Callable[[Array], Array], z: Array, sizes: Array, relative: float = 1e-3) -> Array:
    """Central differences of a function, extrapolated to step zero (Richardson)."""

    def central(k: int, step: float) -> Array:
        ends = []
        for sign in (1.0, -1.0):
            changed = z.copy()
            changed[k] += sign * step
            ends.append(function(changed))
        return (ends[0] - ends[1]) / (2.0 * step)

    steps = relative * sizes
    return np.array([(4.0 * central(k, 0.5 * h) - central(k, h)) / 3.0 for k, h in enumerate(steps)]).T


# Closed form ------------------------------------------------------------------------------------------------------


def test_transition_of_a_choked_discharge_is_the_closed_form() -> None:
    volume, conductance, temperature, dt = 0.2, 1.65e-8, 293.15, 30.0
    circuit = Circuit(
        {
            "tank": Chamber(volume=volume, thermal="isothermal", initial_pressure=7e5),
            "hole": Orifice(from_="tank", to="ambient", sonic_conductance=conductance, critical_ratio=0.4),
        }
    )
    call = estimator_of(circuit, ["hole.sonic_conductance", "tank.volume"], ["tank.pressure"], 1e-9)
    x, constant = call.mean[0], float(tanks.discharge_time_constant(volume, conductance, temperature))
    assert call.advance(dt) is Outcome.DONE
    factor = np.exp(-dt / constant)
    assert call.mean[0] == pytest.approx(x * factor, rel=1e-8)
    # The state is pressure or mass; with the mass, the volume acts on the flow only, as with the pressure.
    by_conductance = -x * factor * dt / (constant * conductance)
    assert call.transition[0] == pytest.approx(
        [factor, by_conductance, x * factor * dt / (constant * volume)], rel=1e-7
    )


# Linear model -----------------------------------------------------------------------------------------------------


def linear_model(a: Array, b: Array, c: Array, d: Array) -> Model:
    """x' = a x + b (p, u), y = c x + d (p, u), with two parameters and two inputs."""
    n = len(a)
    x, u, p, t = ca.SX.sym("x", n), ca.SX.sym("u", 2), ca.SX.sym("p", 2), ca.SX.sym("t")
    v = ca.vertcat(p, u)
    expressions = {"rates": ca.DM(a) @ x + ca.DM(b) @ v, "outputs": ca.DM(c) @ x + ca.DM(d) @ v}
    expressions |= {"start": ca.SX.zeros(n), "energy": ca.SX(0, 1), "memory_start": ca.SX(0, 1)}
    return Model(
        states=tuple(StateInfo(f"x{k}", "1", 1.0, 1.0, 1.0, False) for k in range(n)),
        n_quadratures=0,
        inputs=tuple(InputInfo(f"u{k}", "1", "number", 0.0, -1e9, 1e9, "") for k in range(2)),
        parameters=("p0", "p1"),
        outputs=tuple((f"y{k}", "1") for k in range(len(c))),
        flows=(),
        stores=(),
        symbols={"x": x, "u": u, "p": p, "t": t, "fired": ca.SX(0, 1)},
        expressions={**expressions, "update": ca.SX(0, 1)},
    )


class Textbook:
    """Kalman filter of states and constant numbers with matrices, as in any textbook."""

    def __init__(self, mean: Array, covariance: Array) -> None:
        self.mean, self.covariance = mean.copy(), covariance.copy()

    def predict(self, mean: Array, transition: Array, noise: Array) -> None:
        self.mean, self.covariance = mean, transition @ self.covariance @ transition.T + noise

    def correct(self, innovation: Array, slopes: Array, noise: Array) -> float:
        s = slopes @ self.covariance @ slopes.T + noise
        gain = np.linalg.solve(s, slopes @ self.covariance).T
        self.mean = self.mean + gain @ innovation
        self.covariance = self.covariance - gain @ s @ gain.T
        return float(innovation @ np.linalg.solve(s, innovation))


@pytest.mark.parametrize("seed", range(4))
def test_filter_of_a_linear_model_is_the_textbook_filter(seed: int) -> None:
    rng, n, channels, dt = np.random.default_rng([29, seed]), 4, 3, 0.3
    a = rng.normal(size=(n, n)) - 2.0 * np.eye(n)
    a[0] *= 30.0  # stiff
    b, c, d = rng.normal(size=(n, 4)), rng.normal(size=(channels, n)), rng.normal(size=(channels, 4))
    # Free: both numbers act on one parameter, the second also on one input.
    directions, effects = np.array([[1.0, -0.5], [0.0, 2.0]]), rng.normal(size=(channels, 2))
    call = EstimatorCall(linear_model(a, b, c, d), range(channels), [1], [0], directions, effects, tolerance=1e-11)
    call.p[:], call.base[:], call.reference[:] = [0.4, 0.0], [0.3, 0.7], [1.0, 2.0]
    call.u[:, 1] = 0.2
    call.mean[:] = rng.normal(size=n + 2)
    call.mean[n:] += call.reference
    root = rng.normal(size=(n + 2, n + 2))
    call.covariance[:] = root @ root.T
    call.noise[:], call.walk[:] = rng.uniform(0.1, 1.0, channels), rng.uniform(0.0, 0.1, n + 2)
    textbook = Textbook(call.mean, call.covariance)
    touched = np.zeros((4, 2))
    touched[1], touched[2] = directions
    fixed = np.array([0.4, 0.3, 0.7, 0.2]) - touched @ call.reference
    # Exponential of the states with the free numbers and the constant inputs, which change linearly.
    everything = np.zeros((n + 4, n + 4))
    for _ in range(30):
        before, after = call.u[1, 1], rng.normal()
        call.u[:, 1] = before, after
        call.readings[:] = rng.normal(size=channels)
        missing = rng.random(channels) < 0.3
        call.readings[missing] = np.nan
        assert call.update(dt) is Outcome.DONE

        slope = np.array([0.0, 0.0, 0.0, (after - before) / dt])
        start = fixed + np.array([0.0, 0.0, 0.0, before - 0.2])
        everything[:n] = np.column_stack([a, b @ touched, b @ start, b @ slope])
        everything[n + 3, n + 2] = 1.0
        power = expm(everything * dt)
        transition = np.eye(n + 2)
        transition[:n] = power[:n, : n + 2]
        mean = textbook.mean.copy()
        mean[:n] = transition[:n] @ textbook.mean + power[:n, n + 2]
        textbook.predict(mean, transition, np.diag(call.walk * dt))
        slopes = np.column_stack([c, d @ touched + effects])
        end = fixed + np.array([0.0, 0.0, 0.0, after - 0.2])
        expected = slopes @ textbook.mean + d @ end - effects @ call.reference
        k = ~missing
        nis = textbook.correct((call.readings - expected)[k], slopes[k], np.diag(call.noise)[np.ix_(k, k)])

        sizes = np.sqrt(np.diag(textbook.covariance))
        assert np.abs((call.mean - textbook.mean) / sizes).max() < 1e-7
        assert np.abs((call.covariance - textbook.covariance) / np.outer(sizes, sizes)).max() < 1e-7
        assert call.nis == pytest.approx(nis, rel=1e-6)
        assert np.abs(call.transition - transition[:n]).max() < 1e-7
        assert np.array_equal(call.used, np.where(missing, 0.0, 1.0))


def test_filter_of_a_nonlinear_reading_is_the_iterated_filter() -> None:
    """One further linearisation, at the first correction; none if the noise hides the curvature."""
    model = linear_model(np.zeros((2, 2)), np.zeros((2, 4)), np.zeros((2, 2)), np.zeros((2, 4)))
    x, p = model.symbols["x"], model.symbols["p"]
    model.expressions["outputs"] = ca.vertcat(x[0] ** 2 + x[1], ca.exp(p[0]) + x[0])

    def reading(z: Array) -> tuple[Array, Array]:
        y = np.array([z[0] ** 2 + z[1], np.exp(z[2]) + z[0]])
        return y, np.array([[2.0 * z[0], 1.0, 0.0], [1.0, 0.0, np.exp(z[2])]])

    for noise, is_iterated in ((0.01, True), (100.0, False)):
        call = EstimatorCall(model, [0, 1], [0], [], np.eye(1), np.zeros((2, 1)))
        call.mean[:], call.covariance[:] = [1.0, 0.5, 0.2], np.diag([0.4, 0.2, 0.3])
        call.readings[:], call.noise[:] = [3.0, 3.0], noise
        prior, covariance, r = call.mean.copy(), call.covariance.copy(), noise * np.eye(2)
        assert call.correct() is Outcome.DONE
        y, slopes = reading(prior)
        innovation = np.array([3.0, 3.0]) - y
        first = Textbook(prior, covariance)
        nis = first.correct(innovation, slopes, r)
        expected = first
        if is_iterated:
            y, slopes = reading(first.mean)
            expected = Textbook(prior, covariance)
            expected.correct(np.array([3.0, 3.0]) - y - slopes @ (prior - first.mean), slopes, r)
        assert call.mean == pytest.approx(expected.mean, rel=1e-9)
        assert call.covariance == pytest.approx(expected.covariance, rel=1e-7, abs=1e-12)
        assert call.nis == pytest.approx(nis, rel=1e-9)
        assert call.innovations == pytest.approx(innovation)


# Tank -------------------------------------------------------------------------------------------------------------

ADDRESSES = ["leak.sonic_conductance", "valve.sonic_conductance", "supply.pressure"]


def independent_step(z: Array, opening: Array, dt: float) -> Array:
    """Pressure and mass of the independent tank after dt; z contains them, then leak, valve and supply pressure."""
    tank = independent.Tank(valve=z[3], supply_pressure=z[4])
    scale = tank.volume / independent.GAS_CONSTANT
    state = np.array([[z[0]], [z[0] * scale / z[1]]])
    driven, ends = np.array([[opening[0]], [opening[1]], [z[2]]]), independent.paths(tank, 1)
    steps = 8
    for _ in range(steps):
        h = dt / steps
        first = independent.rates(tank, ends, state, driven)
        second = independent.rates(tank, ends, state + 0.5 * h * first, driven)
        third = independent.rates(tank, ends, state + 0.5 * h * second, driven)
        fourth = independent.rates(tank, ends, state + h * third, driven)
        state = state + h / 6.0 * (first + 2.0 * second + 2.0 * third + fourth)
    return np.array([state[0, 0], state[0, 0] * scale / state[1, 0]])


def test_filter_of_a_tank_is_a_textbook_filter_of_an_independent_tank() -> None:
    circuit = poppet.loads(independent.CIRCUIT)
    call = estimator_of(circuit, ADDRESSES, ["tank.pressure"], 1e-8)
    names = [item.name for item in call.kernel.model.inputs]
    assert [state.name for state in call.kernel.model.states] == ["tank.pressure", "tank.mass"]
    places, n = [names.index("valve.opening"), names.index("use.opening")], 2
    sigmas = np.array([500.0, 1e-4, 1e-10, 3e-10, 3e3])
    call.covariance[:] = np.diag(sigmas**2)
    call.noise[:], call.walk[2:] = 500.0**2, (0.01 * sigmas[2:]) ** 2
    textbook = Textbook(call.mean, call.covariance)
    openings = independent.random_openings(range(1), 150)[0]
    course = independent.simulate(independent.Tank(leak=1.2e-10), openings[None])
    rng = np.random.default_rng(29)
    for k in range(len(openings) - 1):
        call.u[:, places] = openings[k]
        call.readings[0] = course.pressure[0, k + 1] + rng.normal(scale=500.0)
        assert call.update(independent.SAMPLE_TIME) is Outcome.DONE

        def step(z: Array, k: int = k) -> Array:
            return independent_step(z, openings[k], independent.SAMPLE_TIME)

        mean, transition = textbook.mean.copy(), np.eye(5)
        mean[:n] = step(textbook.mean)
        transition[:n] = differences(step, textbook.mean, np.sqrt(np.diag(textbook.covariance)))
        textbook.predict(mean, transition, np.diag(call.walk * independent.SAMPLE_TIME))
        textbook.correct(call.readings - textbook.mean[:1], np.eye(1, 5), np.diag(call.noise))
        textbook.mean[n:] = np.maximum(textbook.mean[n:], 0.0)
        sizes = np.sqrt(np.diag(textbook.covariance))
        assert np.abs((call.mean - textbook.mean) / sizes).max() < 0.01
        assert np.abs(np.sqrt(np.diag(call.covariance)) / sizes - 1.0).max() < 0.01
    assert call.mean[2] == pytest.approx(1.2e-10, abs=4.0 * np.sqrt(call.covariance[2, 2]))


# Transitions of other circuits ------------------------------------------------------------------------------------


def scipy_step(call: EstimatorCall, z: Array, dt: float, method: str) -> Array:
    """States after dt by a solver of SciPy with the rates of the model."""
    n = len(call.kernel.model.states)
    p, u, rates = call.p.copy(), call._block[:0], np.empty(n)
    touched = call.base + call.directions @ (z[n:] - call.reference)
    p[call._places], u = touched[: call._places.size], call.u[0].copy()
    u[call._inputs] = touched[call._places.size :]

    def rates_at(t: float, x: Array) -> Array:
        call.kernel.call("rates", np.array([t]), np.ascontiguousarray(x), u, p, rates)
        return rates.copy()

    solution = solve_ivp(rates_at, (0.0, dt), z[:n], method, rtol=1e-10, atol=1e-13 * np.abs(z[:n]) + 1e-16)
    assert solution.success
    return solution.y[:, -1]


def compare_transition(call: EstimatorCall, dt: float, relative: float = 1e-4, method: str = "Radau") -> float:
    """Largest difference of the transition from differences of SciPy, relative to the largest element of its row.

    All changes are relative to sizes, those of states near zero to their nominal values. Rows below 0.1 count as 0.1.
    """
    n, before = len(call.kernel.model.states), call.mean.copy()
    nominal = [state.nominal for state in call.kernel.model.states]
    sizes = np.abs(before)
    sizes[:n] = np.maximum(sizes[:n], nominal)
    sizes[n:] = np.where(sizes[n:] > 0.0, sizes[n:], 1.0)
    assert call.advance(dt) is Outcome.DONE
    numeric = differences(lambda z: scipy_step(call, z, dt, method), before, sizes, relative)
    error = np.abs(call.transition - numeric) * sizes / sizes[:n, None]
    scale = np.abs(numeric * sizes / sizes[:n, None]).max(axis=1, keepdims=True)
    return float((error / np.maximum(scale, 0.1)).max())


def free_of(circuit: Circuit, count: int, rng: Any) -> list[str]:
    """Addresses of some numbers that act on the model."""
    chosen: list[str] = []
    names = [name for name in circuit.numbers() if name.endswith(("conductance", "volume", "cracking_pressure"))]
    for name in rng.permutation(names).tolist():
        try:
            estimator_of(circuit, [*chosen, name], [])
        except poppet.PoppetError:
            continue
        chosen.append(name)
        if len(chosen) == count:
            break
    return chosen


@pytest.mark.parametrize("shape", [3000, 3001, 3004])
def test_transition_of_random_circuits_equals_differences_of_another_solver(shape: int) -> None:
    item = random_circuit(np.random.default_rng([1, shape]), np.random.default_rng([2, shape, 0]))
    addresses = free_of(item.circuit, 2, np.random.default_rng(shape))
    for tolerance, error in ((1e-6, 5e-3), (1e-9, 3e-4)):
        call = estimator_of(item.circuit, addresses, [], tolerance)
        # Away from the start, where pressures of many circuits are equal.
        assert call.advance(0.013 * item.duration) is Outcome.DONE
        assert compare_transition(call, 0.01 * item.duration) < error


CYLINDER = """
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"

[parts.valve]
kind = "spool_valve"
supply = "supply"
a = "cylinder.cap"
b = "cylinder.rod"
exhaust_a = "ambient"
exhaust_b = "ambient"
nominal_flow = "300 l/min ANR"

[parts.cylinder]
kind = "cylinder"
bore = "32 mm"
rod_diameter = "12 mm"
stroke_length = "200 mm"
body = "slide"
cap = {dead_volume = "8 cm^3", wall_conductance = "0.5 W/K"}
rod = {dead_volume = "8 cm^3", wall_conductance = "0.5 W/K", initial_pressure = "6 bar g"}

[parts.slide]
kind = "mass"
mass = "10 kg"
friction = {kind = "lugre", coulomb_force = "25 N", static_force = "40 N", viscous_coefficient = "60 N s/m"}
"""


@pytest.mark.parametrize("begin", [0.02, 0.1, 0.2, 0.217])
def test_transition_of_a_cylinder_with_friction_equals_differences_of_another_solver(begin: float) -> None:
    """At break-away, during acceleration, in motion with steps longer than the lags, and with impact on a stop."""
    circuit = poppet.loads(CYLINDER)
    for tolerance, error in ((1e-6, 5e-3), (1e-9, 1e-4)):
        call = estimator_of(circuit, ["slide.friction.coulomb_force", "supply.pressure"], [], tolerance)
        call.u[:, [item.name for item in call.kernel.model.inputs].index("valve.command")] = 0.8
        assert call.advance(begin) is Outcome.DONE
        assert compare_transition(call, 0.01) < error
