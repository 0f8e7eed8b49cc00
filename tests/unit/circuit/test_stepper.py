"""Steppers: the digits of a run, lanes, ramps, discrete states, and arguments that are rejected."""

from __future__ import annotations

import runpy
from pathlib import Path

import numpy as np
import pytest

from poppet import Chamber, Circuit, Cylinder, Guide, Orifice, Reservoir, load
from poppet.circuit.stepper import Stepper
from poppet.core.errors import SimulationError
from poppet.engine.call import Call
from poppet.engine.problem import constant_input_problem
from poppet.engine.solve import solve
from poppet.engine.state_start import kernel_from_state
from poppet.signals import Points
from refusals import refused

EXAMPLES = Path(__file__).parents[3] / "examples"
SMOOTH = "emptying", "cylinder_cushioned", "vacuum", "valve_faults", "two_tanks"
"""Circuits without discrete states."""


@pytest.fixture
def circuit() -> Circuit:
    return Circuit(
        {
            "supply": Reservoir(pressure="6 bar g"),
            "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
            "tank": Chamber(volume="2 l", initial_pressure="2 bar", wall_conductance=0.5),
            "leak": Orifice(from_="tank", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3),
        }
    )


@pytest.fixture
def stepper(circuit) -> Stepper:
    return circuit.stepper(
        ["leak.sonic_conductance", "supply.pressure"], outputs=["tank.pressure", "leak.mass_flow_rate"]
    )


@pytest.mark.parametrize("name", SMOOTH)
def test_step_has_the_digits_of_a_run(name):
    circuit = load(EXAMPLES / f"{name}.toml")
    stepper = circuit.stepper()
    x, n = stepper.start(), len(stepper.states)
    kernel, instance = kernel_from_state(circuit.model), circuit.instance
    u = np.array(
        [dict(zip(stepper.inputs, stepper.default_inputs(), strict=True)).get(i, 0.0) for i in instance.input_names]
    )
    for _ in range(3):
        numbers = np.zeros(len(kernel.model.parameters))
        numbers[: len(circuit.model.parameters)] = instance.start()[1]
        numbers[len(circuit.model.parameters) :][:n] = x
        run = solve(constant_input_problem(kernel, numbers, x, u, np.array([0.02])))
        x = stepper.step(x, 0.02)
        assert np.array_equal(x, run.x)


def test_steps_follow_the_simulation(circuit):
    stepper = circuit.stepper(outputs=["tank.pressure"], tolerance=1e-8)
    recording = circuit.simulate("2 s", "0.1 s", relative_tolerance=1e-9)
    x, pressures = stepper.start(), []
    for _ in range(21):
        pressures.append(stepper.outputs_at(x)[0])
        x = stepper.step(x, 0.1)
    np.testing.assert_allclose(pressures, recording["tank.pressure"], rtol=1e-7)


def test_ramps_follow_the_simulation(circuit):
    driven = circuit.with_signals({"supply.pressure": Points([0.0, 0.3, 1.0], [7e5, 3e5, 8e5])})
    stepper = driven.stepper(tolerance=1e-8)
    pressure = stepper.inputs.index("supply.pressure")
    recording = driven.simulate("1 s", "0.1 s", relative_tolerance=1e-9)
    levels = recording["supply.pressure"]
    x = stepper.start()
    assert stepper.default_inputs()[pressure] == 7e5
    for k in range(10):
        u = np.array([stepper.default_inputs()] * 2)
        u[:, pressure] = levels[k : k + 2]
        x = stepper.step(x, 0.1, u=u)
    last = recording.last()
    assert dict(zip(stepper.states, x, strict=True)) == pytest.approx(
        {name: last[name] for name in stepper.states}, rel=1e-6
    )


def test_arguments_do_not_stay(stepper):
    x = stepper.start()
    first = stepper.step(x, 0.1)
    u = stepper.default_inputs()
    stepper.step(2.0 * x, 0.3, u=np.array([u, 0.9 * u]), free=[2e-9, 5e5])
    stepper.transition(x, 0.2, free=[2e-9, 5e5])
    assert np.array_equal(stepper.step(x, 0.1), first)
    assert np.array_equal(stepper.step(x, 0.1, u=u, free=stepper.free_values, t=5.0), first)


def test_free_numbers_act_as_changed_values(circuit, stepper):
    x = stepper.start()
    changed = circuit.with_values({"leak.sonic_conductance": 3e-9, "supply.pressure": 5e5})
    free = [3e-9, 5e5]
    other = changed.stepper(outputs=stepper.outputs)
    np.testing.assert_allclose(stepper.step(x, 0.1, free=free), other.step(x, 0.1), rtol=1e-12)
    np.testing.assert_allclose(stepper.outputs_at(x, free=free), other.outputs_at(x), rtol=1e-12)
    np.testing.assert_allclose(stepper.derivatives(x, free=free).rates, other.derivatives(x).rates, rtol=1e-12)


def test_an_input_that_follows_from_a_free_number_has_its_value(stepper):
    x, u, free = stepper.start(), stepper.default_inputs(), np.array([3e-9, 5e5])
    u[stepper.inputs.index("supply.pressure")] = 9e5
    expected = stepper.step(x, 0.1, free=free)
    assert np.array_equal(stepper.step(x, 0.1, u=u, free=free), expected)
    np.testing.assert_allclose(stepper.steps(x[np.newaxis], 0.1, u=u, free=free)[0], expected, rtol=1e-9)
    assert not np.allclose(stepper.step(x, 0.1, u=u), expected, rtol=1e-4)


@pytest.mark.parametrize("name", ["emptying", "cylinder_cushioned", "two_tanks"])
def test_lanes_equal_single_steps(name):
    circuit = load(EXAMPLES / f"{name}.toml")
    stepper = circuit.stepper()
    generator, x = np.random.default_rng(3), stepper.step(stepper.start(), 0.05)
    states = x * generator.uniform(0.98, 1.02, (11, x.size))
    low, high = stepper.default_inputs() * 0.95, stepper.default_inputs()
    u = generator.uniform(np.minimum(low, high), np.maximum(low, high), (11, low.size))
    together = stepper.steps(states, 0.02, u=u)
    single = np.array([stepper.step(state, 0.02, u=row) for state, row in zip(states, u, strict=True)])
    size = np.abs(single).max(axis=0) + np.array([s.nominal for s in circuit.model.states]) * 1e-3
    assert np.max(np.abs(together - single) / size) < 1e-6


def test_each_lane_has_its_own_numbers(stepper):
    states = np.array([stepper.start()] * 3)
    free = np.array([[1e-9, 7e5], [4e-9, 7e5], [1e-9, 4e5]])
    u = np.array([stepper.default_inputs()] * 3)
    ends = stepper.steps(states, 0.1, u=u, free=free)
    single = [stepper.step(state, 0.1, free=row) for state, row in zip(states, free, strict=True)]
    np.testing.assert_allclose(ends, single, rtol=1e-9)
    # One row applies to all lanes, and no lane at all is allowed.
    np.testing.assert_allclose(stepper.steps(states, 0.1, u=u[0], free=free[1]), [single[1]] * 3, rtol=1e-9)
    assert stepper.steps(np.zeros((0, 2)), 0.1).shape == (0, 2)


@pytest.mark.parametrize("name", ["pressure_control", "two_cylinders"])
def test_discrete_states_advance(name):
    circuit = load(EXAMPLES / f"{name}.toml").with_signals({})
    stepper, dt, count = circuit.stepper(), 0.05, 20
    recording = circuit.simulate(dt * count, dt)
    x, pressures = stepper.start(), [k for k, unit in enumerate(stepper.output_units) if unit == "Pa"]
    initial = stepper.memory.copy()
    for k in range(count):
        x = stepper.step(x, dt, t=k * dt)
    names = [stepper.outputs[k] for k in pressures]
    np.testing.assert_allclose(stepper.outputs_at(x)[pressures], [recording[n][-1] for n in names], rtol=1e-4)
    assert not np.array_equal(stepper.memory, initial)
    stepper.start()
    assert np.array_equal(stepper.memory, initial)


def test_discrete_state_is_needed_with_its_time():
    stepper = load(EXAMPLES / "pressure_control.toml").stepper()
    x = stepper.start()
    with refused("stepper.no_time", "t"):
        stepper.step(x, 0.01)
    with refused("stepper.no_time", "t"):
        stepper.transition(x, 0.01)
    with refused("stepper.sampled", stepper.memory_names[0]):
        stepper.steps([x], 0.01)
    stepper.memory = np.zeros(1)
    with refused("stepper.shape", "memory"):
        stepper.step(x, 0.01, t=0.0)


def test_velocity_of_a_guided_body_is_the_slope_of_its_position():
    # A closed, adiabatic cylinder chamber: p V^kappa is constant.
    end = {"dead_volume": "5 cm^3", "initial_pressure": "2 bar"}
    cylinder = Cylinder(body="slide", bore="32 mm", rod_diameter="12 mm", stroke_length="0.1 m", cap=end, rod=end)
    stepper = Circuit({"cylinder": cylinder, "slide": Guide()}).stepper(outputs=["cylinder.cap.pressure"])
    assert "slide.velocity" not in stepper.inputs
    x, position = stepper.start(), stepper.inputs.index("slide.position")
    u = np.array([stepper.default_inputs()] * 2)
    before, area = stepper.outputs_at(x, u=u[0])[0], np.pi / 4.0 * 0.032**2
    u[1, position] = u[0, position] + 0.04
    after = stepper.outputs_at(stepper.step(x, 0.3, u=u), u=u[1])[0]
    volumes = 5e-6 + area * u[:, position]
    assert after == pytest.approx(before * (volumes[0] / volumes[1]) ** 1.4, rel=1e-5)


def test_circuit_without_states():
    circuit = Circuit(
        {
            "low": Reservoir(pressure="1 bar"),
            "high": Reservoir(pressure="6 bar"),
            "orifice": Orifice(from_="high", to="low", sonic_conductance=1e-8, critical_ratio=0.3),
        }
    )
    stepper = circuit.stepper(["orifice.sonic_conductance"], outputs=["orifice.mass_flow_rate"])
    x = stepper.start()
    assert stepper.step(x, 1.0).shape == (0,)
    assert stepper.outputs_at(x)[0] == pytest.approx(6e5 * 1e-8 * 1.185, rel=1e-9)
    derivatives, transition = stepper.derivatives(x), stepper.transition(x, 1.0)
    assert derivatives.outputs_by_free[0, 0] == pytest.approx(6e5 * 1.185, rel=1e-9)
    assert (derivatives.rates_by_free.shape, transition.by_state.shape, transition.by_free.shape) == (
        (0, 1),
        (0, 0),
        (0, 1),
    )
    assert stepper.steps(np.zeros((3, 0)), 1.0).shape == (3, 0)


def test_wrong_arguments(circuit, stepper):
    x, u = stepper.start(), stepper.default_inputs()
    with refused("stepper.shape", "x", shape="(3,)", expected="(2,)"):
        stepper.step([*x, 1.0], 0.1)
    with refused("stepper.shape", "u"):
        stepper.step(x, 0.1, u=u[:-1])
    with refused("stepper.shape", "u"):
        stepper.step(x, 0.1, u=np.array([u] * 3))
    with refused("stepper.shape", "free"):
        stepper.derivatives(x, free=1e-9)
    with refused("stepper.shape", "x"):
        stepper.steps(x, 0.1)
    with refused("stepper.shape", "u"):
        stepper.steps([x, x, x], 0.1, u=[u, u])
    for dt in (0.0, -1.0, np.nan, np.inf):
        with refused("stepper.duration", "dt"):
            stepper.step(x, dt)
        with refused("stepper.duration", "dt"):
            stepper.steps([x], dt)
    for bad in (0.0, -1.0, np.nan):
        with refused("stepper.state", "tank.mass"):
            stepper.step([x[0], bad], 0.1)
        with refused("stepper.state", "tank.mass"):
            stepper.steps([x, [x[0], bad]], 0.1)
    with refused("inputs.outside", "supply.pressure", given=-1.0):
        stepper.step(x, 0.1, u=np.where(np.array(stepper.inputs) == "supply.pressure", -1.0, u))
    with refused("stepper.outside", "leak.sonic_conductance", given=-1e-9):
        stepper.step(x, 0.1, free=[-1e-9, 5e5])
    with refused("names.unknown", "tank.presure"):
        circuit.stepper(outputs=["tank.presure"])
    with refused("names.unknown", "tank.volme"):
        circuit.stepper(["tank.volme"])
    with refused("stepper.tolerance", "tolerance", value=0.0):
        circuit.stepper(tolerance=0.0)


def test_ramp_of_an_input_that_follows_from_a_free_number(stepper):
    x, u = stepper.start(), stepper.default_inputs()
    supply = np.array(stepper.inputs) == "supply.pressure"
    with refused("stepper.ramp", "supply.pressure"):
        stepper.transition(x, 0.1, u=[u, np.where(supply, 0.9 * u, u)])
    other = np.array(stepper.inputs) == "supply.temperature"
    ramp = np.array([u, np.where(other, 0.9 * u, u)])
    assert np.array_equal(stepper.transition(x, 0.1, u=ramp).state, stepper.step(x, 0.1, u=ramp))


@pytest.mark.parametrize("name", SMOOTH)
def test_transition_equals_replays_of_fine_steps(name):
    circuit = load(EXAMPLES / f"{name}.toml")
    stepper, dt, count = circuit.stepper(), 5e-3, 100
    x = stepper.start()
    for _ in range(4):
        x = stepper.step(x, dt)
    transition, state, product = stepper.transition(x, dt), x, np.eye(x.size)
    assert np.array_equal(transition.state, stepper.step(x, dt))
    for _ in range(count):
        part = stepper.transition(state, dt / count)
        state, product = part.state, part.by_state @ product
    # Runs with the same short steps are smooth functions of their start.
    arrays = stepper._p, x.copy(), stepper._u, np.array([dt])
    problem = constant_input_problem(kernel_from_state(circuit.model), *arrays, maximum_step=dt / count)
    script = np.empty(1000)
    assert Call(problem, script).run().accepted < script.size
    replay = Call(problem, script, replay=True)

    def end(k, step):
        problem.x0[:] = x
        problem.x0[k] += step
        replay.repeat()
        return replay.x.copy()

    sizes = np.where(circuit.kernel.positive, np.abs(x), [state.nominal for state in circuit.model.states])
    up, down = (
        np.array([(end(k, step) - end(k, 0.0)) / step for k, step in enumerate(sign * 1e-6 * sizes)]).T
        for sign in (1, -1)
    )
    both, scale = 0.5 * (up + down), np.maximum(np.abs(up), sizes[:, None] / sizes)
    # At a kink, the differences of both sides disagree.
    is_smooth = np.abs(up - down) < 1e-3 * scale
    assert is_smooth.mean() > 0.9
    assert (np.abs(product - both) / scale)[is_smooth].max() < 5e-4
    assert (np.abs(transition.by_state - both) / scale)[is_smooth].max() < 0.02


def test_transition_of_a_sampled_circuit_between_instants():
    stepper = load(EXAMPLES / "pressure_control.toml").stepper()
    x = stepper.step(stepper.start(), 0.5, t=0.0)
    memory = stepper.memory.copy()
    transition = stepper.transition(x, 1e-4, t=0.5)
    assert np.array_equal(stepper.memory, memory)
    shift = 1e-6 * np.eye(x.size)[0]
    above, below = x * (1.0 + shift), x * (1.0 - shift)
    ends = []
    for start in (above, below):
        stepper.memory = memory.copy()
        ends.append(stepper.step(start, 1e-4, t=0.5))
    column = (ends[0] - ends[1]) / (above - below)[0]
    np.testing.assert_allclose(transition.by_state[:, 0], column, rtol=1e-5)


def test_failed_step(stepper):
    with pytest.raises(SimulationError) as caught:
        stepper.step([1e300, 1e-300], 0.1)
    assert caught.value.note.code == "stepper.failed"
    # The stepper remains usable.
    assert np.isfinite(stepper.step(stepper.start(), 0.1)).all()


def test_environment_repeats_its_episodes_and_rewards_a_better_controller():
    play = runpy.run_path(str(EXAMPLES / "stepper_environment.py"))["play"]
    assert play(2.0, 3) == play(2.0, 3)
    assert play(0.1, 3) < play(2.0, 3) < 0.0
