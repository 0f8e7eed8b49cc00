"""Steppers of random circuits: derivatives, steps in series and in lanes, products of transitions."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from poppet.circuit.stepper import Stepper
from poppet.core.errors import InputError

sys.path.insert(0, str(Path(__file__).parent))
from seeded_pneumatics import random_circuit

Array = NDArray[np.float64]
DT = 2e-3
FREE = ("volume", "sonic_conductance", "wall_conductance", "pressure")


def random_stepper(seed: int) -> tuple[Stepper, Array]:
    """Stepper of a random circuit with up to three free numbers and eight outputs, and the sizes of its states."""
    circuit = random_circuit(np.random.default_rng([4, seed]), np.random.default_rng([5, seed])).circuit
    generator = np.random.default_rng(seed)
    candidates = [address for address in circuit.numbers() if address.rpartition(".")[2] in FREE]
    outputs = generator.permutation(list(circuit.model.columns[0]))[:8].tolist()
    free: list[str] = []
    for address in generator.permutation(candidates)[:6].tolist():
        try:
            circuit.stepper([address], outputs=[])
        except InputError:
            continue
        free.append(address)
    sizes = np.array([state.nominal for state in circuit.model.states])
    return circuit.stepper(free[:3], outputs=outputs, tolerance=1e-8), sizes


def is_derivative(function: Callable[[Array], Array], point: Array, matrix: Array, sizes: Array) -> bool:
    """Return True if the columns of a matrix are the derivatives of a function on at least one side of a point."""
    for k, size in enumerate(sizes):
        errors = []
        for step in (1e-6 * size, -1e-6 * size):
            values = []
            for times in range(3):
                shifted = point.copy()
                shifted[k] += times * step
                values.append(function(shifted))
            difference = (4.0 * values[1] - 3.0 * values[0] - values[2]) / 2.0
            scale = np.abs(matrix * sizes).max(axis=1) * 1e-6 + 1e-12 * np.abs(values[0]) + 1e-11
            errors.append(np.abs(difference - matrix[:, k] * step) / scale)
        if np.minimum(*errors).max() > 0.01:
            return False
    return True


def violations(stepper: Stepper, sizes: Array) -> list[str]:
    """Return the properties of steps that a stepper does not have after 20 ms."""
    x, found = stepper.start(), []
    for k in range(10):
        x = stepper.step(x, DT, t=k * DT)
    sizes = np.where(np.abs(x) > 1e-3 * sizes, np.abs(x), sizes)
    # Not exactly at a kink, such as the centre of a spool.
    x = x + 1e-4 * sizes * np.random.default_rng(7).uniform(-1.0, 1.0, x.size)
    free, at = stepper.free_values, stepper.derivatives(x)

    def values(x: Array, free: Array) -> Array:
        derivatives = stepper.derivatives(x, free=free)
        return np.concatenate([derivatives.rates, derivatives.outputs])

    by_state = np.vstack([at.rates_by_state, at.outputs_by_state])
    by_free = np.vstack([at.rates_by_free, at.outputs_by_free])
    if not is_derivative(lambda shifted: values(shifted, free), x, by_state, sizes):
        found.append("derivatives by states")
    if not is_derivative(lambda shifted: values(x, shifted), free, by_free, np.abs(free)):
        found.append("derivatives by free numbers")
    memory = stepper.memory
    once = stepper.step(x, 2 * DT, t=10 * DT)
    stepper.memory = memory
    twice = stepper.step(stepper.step(x, DT, t=10 * DT), DT, t=11 * DT)
    if np.max(np.abs(once - twice) / sizes) > 1e-4:
        found.append("steps in series")
    if stepper.memory_names:
        return found
    if np.max(np.abs(stepper.steps([x, once, x], 2 * DT)[[0, 2]] - once) / sizes) > 1e-4:
        found.append("steps in lanes")
    first, both = stepper.transition(x, DT), stepper.transition(x, 2 * DT)
    second = stepper.transition(first.state, DT)
    product, scale = second.by_state @ first.by_state, sizes / sizes[:, None]
    if np.max(np.abs(product - both.by_state) * scale) > 0.1 * max(1.0, np.max(np.abs(product) * scale)):
        found.append("transitions in series")
    sensitivity = second.by_state @ first.by_free + second.by_free
    scale = free / sizes[:, None]
    if np.max(np.abs(sensitivity - both.by_free) * scale) > 0.1 * max(1.0, np.max(np.abs(sensitivity) * scale)):
        found.append("sensitivities in series")
    return found


def test_a_random_circuit() -> None:
    assert violations(*random_stepper(3)) == []


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(40))
def test_many_random_circuits(seed: int) -> None:
    assert violations(*random_stepper(seed)) == []
