"""Tests of `to_ode`, `to_casadi` and `to_control`: values, derivatives, invalid arguments."""

from __future__ import annotations

import runpy
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from poppet import Circuit, load
from poppet.parts import Chamber, Orifice
from poppet.signals import Steps
from refusals import refused

EXAMPLES = Path(__file__).parents[3] / "examples"


def example(name):
    return load(EXAMPLES / f"{name}.toml")


@pytest.fixture(scope="module")
def vented():
    """A tank that blows off through an orifice that is closed for a while."""
    tank = Chamber(volume="1 l", initial_pressure="5 bar", wall_conductance=1.0)
    vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    return Circuit({"tank": tank, "vent": vent}, {"vent.opening": Steps([0.0, 0.2, 0.4], [1.0, 0.0, 0.5])})


# --- Plain functions -------------------------------------------------------------------------------------------------


def test_solve_ivp_gives_the_run_with_any_solver(vented):
    ode, known = vented.to_ode("1 s"), vented.simulate("1 s", relative_tolerance=1e-10)
    assert ode.states == ("tank.pressure", "tank.mass")
    assert ode.units["tank.mass"] == "kg"
    assert ode.breakpoints.tolist() == [0.0, 0.2, 0.4]
    run = solve_ivp(
        ode.f, (0.0, ode.end), ode.x0, "Radau", jac=ode.jac, rtol=1e-9, atol=1e-9 * ode.scale, max_step=0.02,
        t_eval=known.time,
    )  # fmt: skip
    found = ode.outputs(run.t, run.y)
    assert found.keys() == {name for name in known.names if "." in name} - {"ambient.pressure", "ambient.temperature"}
    for name in ("tank.pressure", "tank.temperature"):
        assert np.allclose(found[name], known[name], rtol=3e-7), np.abs(found[name] / known[name] - 1.0).max()


def test_stretches_end_at_jumps_of_signals(vented):
    ode, known = vented.to_ode("1 s"), vented.simulate("1 s", relative_tolerance=1e-11)
    t, x, ends = 0.0, ode.x0, []
    while t < ode.end:
        stretch = ode.stretch(t, x)
        # Up to its end the jump there has not happened.
        assert stretch.outputs(stretch.end, x)["vent.opening"] == stretch.outputs(t, x)["vent.opening"]
        run = solve_ivp(stretch.f, (t, stretch.end), x, "Radau", jac=stretch.jac, rtol=1e-11, atol=1e-11 * ode.scale)
        t, x = stretch.end, run.y[:, -1]
        ends.append(t)
    assert ends == [0.2, 0.4, 1.0]
    assert np.isclose(x[0], known["tank.pressure"][-1], rtol=1e-9)


def test_jacobian_equals_the_difference_quotients_of_the_rates(vented):
    ode = vented.to_ode("1 s")
    x, matrix = ode.x0, ode.jac(0.5, ode.x0)
    for k, size in enumerate(1e-5 * x):
        step = size * np.eye(2)[k]
        slope = (ode.f(0.5, x + step) - ode.f(0.5, x - step)) / (2.0 * size)
        assert np.allclose(matrix[:, k], slope, rtol=1e-6)


def test_sampled_circuits_are_integrated_between_instants():
    circuit = example("pressure_control")
    ode, known = circuit.to_ode("0.52 s"), circuit.simulate("0.52 s", relative_tolerance=1e-10)
    with refused("tools.has_instants", "regulator.sample"):
        ode.f(0.0, ode.x0)
    t, x, memory, count = 0.0, ode.x0, None, 0
    while t < ode.end:
        stretch = ode.stretch(t, x, memory)
        run = solve_ivp(stretch.f, (t, stretch.end), x, "LSODA", jac=stretch.jac, rtol=1e-10, atol=1e-10 * ode.scale)
        t, x, memory, count = stretch.end, run.y[:, -1], stretch.memory, count + 1
    assert count == 260
    assert np.isclose(stretch.outputs(t, x)["tank.pressure"], known["tank.pressure"][-1], rtol=1e-8)


# --- CasADi ----------------------------------------------------------------------------------------------------------


def test_casadi_functions_equal_the_circuit():
    model = example("pressure_control").to_casadi(
        inputs=["fill.opening", "vent.opening"], numbers=["tank.volume"], without="regulator"
    )
    assert (model.inputs, model.numbers, model.units["tank.volume"]) == (
        ("fill.opening", "vent.opening"),
        ("tank.volume",),
        "m^3",
    )
    parts = {name: part for name, part in example("pressure_control").parts.items() if name != "regulator"}
    for openings, volume in (((0.3, 0.0), 1e-3), ((0.1, 0.9), 2e-3)):
        held = {
            f"{name}.opening": Steps([0.0], [value]) for name, value in zip(("fill", "vent"), openings, strict=True)
        }
        ode = Circuit(parts, held).with_values({"tank.volume": volume}).to_ode("1 s")
        assert np.allclose(np.array(model.start([volume])).ravel(), ode.x0, rtol=1e-14)
        assert np.allclose(np.array(model.f(ode.x0, openings, volume)).ravel(), ode.f(0.0, ode.x0), rtol=1e-12)
        outputs = dict(zip(model.outputs, np.array(model.g(ode.x0, openings, volume)).ravel(), strict=True))
        known = ode.outputs(0.0, ode.x0)
        assert outputs.keys() == known.keys()
        assert np.allclose([*outputs.values()], [known[name] for name in outputs], rtol=1e-12)


CORNERS = (1e5, 7e5, 0.35 * 7e5, 1e5 / 0.35, 0.999 * 7e5, 1e5 / 0.999)
"""Pressures at which something meets: ambient, supply, choking at either valve, both ends of the regularised zone."""


@pytest.mark.parametrize(
    ("name", "without"), [("pressure_control", "regulator"), ("fill_staircase", ()), ("position_control", "position")]
)
def test_derivatives_of_both_orders_are_finite_at_every_corner(name, without):
    """The branch that is not taken has a root of nothing in it: zero times its infinite slope would be no number."""
    model = example(name).to_casadi(without=without)
    x, u, weights = (
        ca.SX.sym(s, n) for s, n in (("x", len(model.states)), ("u", len(model.inputs)), ("l", len(model.states)))
    )
    f, both = model.f(x, u, []), ca.vertcat(x, u)
    slopes = ca.Function("slopes", [x, u, weights], [ca.jacobian(f, both), ca.hessian(ca.dot(weights, f), both)[0]])
    points = 0
    for k, address in enumerate(model.inputs):
        for value in {"1": (0.0, 1.0), "Pa": CORNERS}.get(model.units[address], ()):
            for place, state in enumerate(model.states):
                for corner in {"Pa": CORNERS, "m": (0.0,), "m/s": (0.0,)}.get(model.units[state], ()):
                    at, inputs = model.x0.copy(), model.u0.copy()
                    at[place], inputs[k] = corner, value
                    found = slopes(at, inputs, np.ones(len(at)))
                    assert all(np.all(np.isfinite(np.array(each))) for each in found), (address, value, state, corner)
                    points += 1
    assert points > 20


def test_invalid_arguments_of_to_casadi_are_refused():
    circuit = example("pressure_control")
    with refused("tools.sampled", "regulator.sample"):
        circuit.to_casadi()
    with refused("fields.not_an_option", "without", value="tank"):
        circuit.to_casadi(without="tank")
    with refused("names.unknown", "tank.volum"):
        circuit.to_casadi(without="regulator", numbers=["tank.volum"])
    with refused("tools.fixed", "ambient.temperature"):
        circuit.to_casadi(without="regulator", numbers=["ambient.temperature"])
    with refused("names.unknown", "fill.openin"):
        circuit.to_casadi(without="regulator", inputs=["fill.openin"])


# --- python-control --------------------------------------------------------------------------------------------------


def test_python_control_gives_the_run():
    control = pytest.importorskip("control")
    plant = example("pressure_control")
    system = plant.to_control(without="regulator", inputs=["fill.opening", "vent.opening"], numbers=["tank.volume"])
    parts = {name: part for name, part in plant.parts.items() if name != "regulator"}
    held = Circuit(parts, {"fill.opening": Steps([0.0], [0.4]), "vent.opening": Steps([0.0], [0.1])})
    for volume in (1e-3, 2e-3):
        known = held.with_values({"tank.volume": volume}).simulate("0.5 s", "50 ms", 1e-9)
        inputs = np.repeat([[0.4], [0.1]], known.time.size, axis=1)
        start = [known["tank.pressure"][0], known["tank.mass"][0]]
        run = control.input_output_response(
            system, known.time, inputs, start, params={"tank__volume": volume}, solve_ivp_kwargs={"rtol": 1e-9}
        )
        found = run.outputs[system.find_output("tank__pressure")]
        assert np.allclose(found, known["tank.pressure"], rtol=1e-6)


def test_linear_models_convert_to_python_control():
    pytest.importorskip("control")
    circuit = example("pressure_control")
    plant = circuit.to_control(linear=True, without="regulator")
    assert plant.dt == 0
    assert "fill__opening" in plant.input_labels
    assert circuit.to_control(linear=True).dt == 2e-3
    with refused("tools.of_nonlinear", "numbers"):
        circuit.to_control(linear=True, numbers=["tank.volume"])


# --- Examples --------------------------------------------------------------------------------------------------------


def test_predictive_control_meets_its_setpoint():
    found = runpy.run_path(str(EXAMPLES / "mpc_tank_pressure.py"))["main"](duration=1.8, sample=0.05, horizon=6)
    assert found["MPC"][1] < 1.2
    assert abs(found["MPC"][0] - found["PID"][0]) < 0.1


def test_the_example_of_solve_ivp_agrees():
    functions = runpy.run_path(str(EXAMPLES / "solve_ivp.py"))
    assert functions["signals_only"]("30 s") < 1e-6
    assert functions["with_instants"]("0.52 s") < 1e-6
