"""Machines with step sequences against an independent simulation: order of the steps, their times, and positions."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import poppet

sys.path.insert(0, str(Path(__file__).parent))
from independent_sequences import STATES, circuit_text, condition_text, draw_machine, simulate_machine

DURATION = 2.0


def two_cylinders() -> dict[str, Any]:
    """A machine that runs A+ B+ B- A-."""
    machine = draw_machine(0)
    first, second = machine["drives"][:2]
    for drive, stroke in ((first, 0.1), (second, 0.05)):
        drive |= {"stroke": stroke, "outputs": [drive["name"].lower()], "load": 0.0}

    def limit(name: str, relation: str, millimetres: float) -> tuple[Any, ...]:
        return relation, f"slide{name}.position", 1e-3 * millimetres, f"{millimetres} mm"

    steps = {
        "A+": {"on": ["a"], "next": {"B+": limit("A", "above", 98)}},
        "B+": {"on": ["a", "b"], "next": {"B-": limit("B", "above", 48)}},
        "B-": {"on": ["a"], "next": {"A-": limit("B", "below", 2)}},
        "A-": {"on": [], "next": {"A+": limit("A", "below", 2)}},
    }
    sequence = {"sample_time": 5e-3, "outputs": ["a", "b"], "steps": steps}
    return machine | {"drives": [first, second], "sequence": sequence}


def transitions(steps: list[str]) -> list[tuple[int, str]]:
    """Return the samples at which the step changes, and the new steps."""
    return [(k, step) for k, step in enumerate(steps) if k == 0 or step != steps[k - 1]]


def compare(machine: dict[str, Any], duration: float = DURATION) -> tuple[int, int]:
    """Compare both simulations, and return the number of transitions and of those at the same sample."""
    log, rows = simulate_machine(machine, duration)
    recording = poppet.loads(circuit_text(machine, duration)).simulate()
    names, last = list(machine["sequence"]["steps"]), len(log) - 1
    steps = [names[round(number) - 1] for number in recording["plc.step"]]
    assert len(steps) == len(log)
    found, expected = transitions(steps), transitions([step for step, _, _ in log])
    # A transition at the last sample can be missing.
    count = min(len(found), len(expected))
    assert all(k >= last - 1 for k, _ in [*found[count:], *expected[count:]])
    assert [name for _, name in found[:count]] == [name for _, name in expected[:count]]
    delays = np.array([k - other for (k, _), (other, _) in zip(found[:count], expected[:count], strict=True)])
    assert np.max(np.abs(delays)) <= 1, delays
    if not delays.any():
        _, elapsed, cycles = zip(*log, strict=True)
        assert np.max(np.abs(recording["plc.elapsed"] - elapsed)[:-1]) < 1e-9
        assert np.array_equal(recording["plc.cycles"][:-1], cycles[:-1])
        for j, drive in enumerate(machine["drives"]):
            position = recording[f"slide{drive['name']}.position"]
            assert np.max(np.abs(position - rows[:, 2 + STATES * j + 4])) < 2e-6
    return count, int(np.count_nonzero(delays == 0))


def test_a_machine_with_two_cylinders_runs_its_cycle() -> None:
    count, exact = compare(two_cylinders())
    assert exact == count > 8


@pytest.mark.parametrize("seed", range(1, 21))
def test_random_sequences_on_two_to_four_cylinders(seed: int) -> None:
    count, exact = compare(draw_machine(seed))
    assert exact == count > 6


def test_the_random_sequences_have_all_forms_of_conditions_and_inputs() -> None:
    sequences = [draw_machine(seed)["sequence"] for seed in range(1, 21)]
    conditions = [condition for sequence in sequences for step in sequence["steps"].values()
                  for condition in step["next"].values()]  # fmt: skip
    text = " ".join(condition_text(condition) for condition in conditions)
    words = (
        "position >",
        "position <",
        "cap.pressure",
        "rod.pressure",
        "rail.pressure",
        "and",
        "not",
        "count",
        "elapsed",
    )
    assert [word for word in words if word not in text] == []
    assert {name for sequence in sequences for name in sequence["events"]} == {"halt", "reset", "emergency", "start"}
    assert any("timeout" in step for sequence in sequences for step in sequence["steps"].values())
