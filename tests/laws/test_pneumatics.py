"""Second law and balances in random circuits of all kinds of flow paths."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from poppet.parts import KINDS
from poppet.parts.faults import Valve

sys.path.insert(0, str(Path(__file__).parent))
from seeded_pneumatics import AMBIENT, PASSAGES, WARM, RandomCircuit, entropy_production, gas_entropy, random_circuit

ROWS = 40


def violations(item: RandomCircuit) -> list[str]:
    """Simulate a circuit, and return the laws that the recording violates."""
    recording = item.circuit.simulate(item.duration, item.duration / ROWS)
    found = [] if np.isfinite(recording.values).all() else ["not finite"]
    found += [f"pressure of {node}" for node in item.stores if recording[f"{node}.pressure"].min() <= 0.0]
    found += [str(residual) for residual in recording.residuals if not residual.is_kept]
    for group in item.groups:
        productions, scales = zip(*(entropy_production(item, recording, flow) for flow in group), strict=True)
        if np.any(sum(productions) < -1e-12 * sum(scales)):
            found.append(f"entropy of {group}")
    if "compressor" in item.kinds:
        # The work is at least that of an isothermal compression.
        ideal = item.gas[0] * WARM * np.log(recording["tank0.pressure"] / AMBIENT)
        least = recording["compressor.mass_flow_rate"] * ideal
        if np.any(recording["compressor.power"] < least - 1e-9 * np.abs(least)):
            found.append("power of the compressor")
    if item.is_closed:
        total, scale = gas_entropy(item, recording)
        if np.diff(total).min() < -1e-6 * scale.max():
            found.append("total entropy")
    return found


def run_circuits(shapes: range, each: int, *, has_faults: bool = False) -> set[str]:
    """Check random circuits, and return the kinds of flow paths in them."""
    kinds: set[str] = set()
    for shape in shapes:
        for number in range(each):
            generators = np.random.default_rng([1, shape]), np.random.default_rng([2, shape, number])
            item = random_circuit(*generators, has_faults=has_faults)
            assert violations(item) == [], (shape, number)
            kinds |= item.kinds
    return kinds


def test_a_few_random_circuits_obey_the_second_law_and_keep_their_balances() -> None:
    run_circuits(range(1000, 1004), 5)


def test_a_few_random_circuits_with_faults_obey_the_second_law_and_keep_their_balances() -> None:
    run_circuits(range(2000, 2003), 5, has_faults=True)


@pytest.mark.parametrize(("shapes", "each"), [(40, 10), pytest.param(500, 10, marks=pytest.mark.slow)])
def test_random_circuits_with_faults_obey_the_second_law_and_keep_their_balances(shapes: int, each: int) -> None:
    valves = {item.kind for item in PASSAGES if issubclass(KINDS[item.kind], Valve)}
    assert run_circuits(range(3000, 3000 + shapes), each, has_faults=True) >= valves


@pytest.mark.parametrize(("shapes", "each"), [(30, 10), pytest.param(500, 20, marks=pytest.mark.slow)])
def test_random_circuits_of_all_kinds_obey_the_second_law_and_keep_their_balances(shapes: int, each: int) -> None:
    nodes = {
        "chamber",
        "reservoir",
        "cylinder",
        "muscle",
        "tube",
        "pilot_stage",
        "compressor",
        "suction_cup",
        "gripper",
        "pressure_booster",
        "rotary_actuator",
    }
    assert run_circuits(range(shapes), each) >= {item.kind for item in PASSAGES} | nodes
