"""Models that start from a given state: the same curves as the circuit that continues, from states and times."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from poppet import Circuit, Orifice, Reservoir, load
from poppet.circuit.options import Run
from poppet.engine.call import Call
from poppet.engine.problem import Problem
from poppet.engine.state_start import kernel_from_state, model_from_state

EXAMPLES = Path(__file__).parents[3] / "examples"


# Circuits without and with sample instants; start times of timers are absolute.
@pytest.mark.parametrize(
    ("name", "middle", "end"),
    [
        ("emptying", 10.0, 40.0),
        ("cylinder_position", 0.4, 1.2),
        ("pressure_control", 1.0, 3.0),
        ("two_cylinders", 1, 4),
    ],
)
def test_continues_as_the_circuit(name, middle, end):
    circuit = load(EXAMPLES / f"{name}.toml")
    problem = circuit.problem(Run(duration=end, output_step=end / 200))
    first = Call(circuit.problem(Run(duration=middle, output_step=middle)))
    first.run()
    later = problem.grid > middle
    x, z, grid, expected = first.x, first.memory, problem.grid[later], Call(problem).run().values[:, later]
    model = model_from_state(circuit.model)
    n = len(circuit.model.states)
    kernel = kernel_from_state(circuit.model)
    numbers = np.concatenate([circuit.instance.numbers(), x[:n], z, np.zeros(len(model.inputs))])
    p = kernel.with_memory(numbers)
    x0 = kernel.start(p)
    assert np.array_equal(x0, x[:n])
    assert np.array_equal(p[len(model.parameters) :], z)
    # The segments of the signals after the time `middle`.
    stops = np.append(problem.starts[1:], end)
    kept = stops > middle
    starts = np.maximum(problem.starts[kept], middle)
    resumed = Problem(kernel, p, x0, starts, problem.courses[kept], problem.coefficients, problem.jumps[kept], grid)
    values = Call(resumed).run().values
    # Pressures and temperatures. Both runs have the tolerance 1e-6, but other steps.
    rows = [k for k, (_, unit) in enumerate(circuit.model.outputs) if unit in ("Pa", "K")]
    assert len(rows) > 1
    np.testing.assert_allclose(values[rows], expected[rows], rtol=3e-5)


def test_same_model_for_the_same_structure():
    first, second = load(EXAMPLES / "emptying.toml"), load(EXAMPLES / "emptying.toml")
    changed = second.with_values({"tank.volume": "5 l"})
    assert model_from_state(first.model) is model_from_state(changed.model)
    assert first.model.parameters == model_from_state(first.model).parameters[: len(first.model.parameters)]


def test_has_neither_quadratures_nor_balances():
    model = model_from_state(load(EXAMPLES / "emptying.toml").model)
    assert (model.size, model.n_energies, model.balances) == (len(model.states), 0, ())


def test_circuit_without_states():
    low, high = Reservoir(pressure="2 bar"), Reservoir(pressure="6 bar")
    orifice = Orifice(from_="high", to="low", sonic_conductance=1e-8, critical_ratio=0.3)
    circuit = Circuit({"low": low, "high": high, "orifice": orifice}, run=Run(duration="1 s"))
    model = model_from_state(circuit.model)
    problem = circuit.problem(circuit.run)
    assert model.parameters == (*circuit.model.parameters, *(f"input.{item.name}" for item in model.inputs))
    kernel, p = kernel_from_state(circuit.model), np.concatenate([problem.p, np.zeros(len(model.inputs))])
    derived = Problem(**{**vars(problem), "kernel": kernel, "p": p})
    assert np.array_equal(Call(derived).run().values, Call(problem).run().values)
