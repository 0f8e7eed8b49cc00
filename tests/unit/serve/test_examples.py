"""Served examples compared with their simulations: sequences, controllers, switches, signals and friction."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import poppet

EXAMPLES = Path(__file__).parents[3] / "examples"
SIMPLE = ("pressure_control", "two_cylinders")
LONGEST = 4.0
"""Duration of the comparison [s]."""
PERIOD = 0.01
UNSTABLE = {"position_control_banded", "regulator_parts", "muscle_joint", "antagonistic_joint"}
"""Examples in which a rounding error changes switching instants, and with them all later ones."""


def names() -> list[str]:
    circuits = [path for path in sorted(EXAMPLES.glob("*.toml")) if "[parts." in path.read_text(encoding="utf-8")]
    return [path.stem for path in circuits]


def check(name: str) -> None:
    circuit = poppet.load(EXAMPLES / f"{name}.toml")
    circuit = circuit.with_values({"run.stop_when": None}) if circuit.run.stop_texts else circuit
    duration = min(LONGEST, float(circuit.run.duration or LONGEST))
    count = round(duration / PERIOD)
    # The last row of a run is the only one without the steps of signals at its time.
    expected = circuit.simulate((count + 1) * PERIOD, PERIOD).between(0.0, (count + 0.5) * PERIOD)
    with circuit.serve(PERIOD, clock=False) as machine:
        machine.advance(count * PERIOD)
        _, rows = machine.rows()
    assert np.allclose(rows[:, 0], expected.time, rtol=1e-14)
    discrete = {
        name
        for name in expected.names
        if name.endswith(("regime", "contact", "velocity", "friction_force", "acceleration", "stop_force"))
    }
    for address in set(expected.names) - discrete:
        a, b = expected[address], rows[:, machine.row_names.index(address)]
        size = max(np.ptp(a), 1e-3 * np.abs(a).max(), 1e-12)
        # The root mean square: a switching instant can differ by a step of the solver.
        error = np.sqrt(np.mean((a - b) ** 2)) / size
        assert error < (0.2 if name in UNSTABLE else 2e-3), address


@pytest.mark.parametrize("name", SIMPLE)
def test_examples_with_controller_and_sequence(name):
    check(name)


@pytest.mark.parametrize("name", sorted(set(names()) - set(SIMPLE)))
def test_all_other_examples(name):
    check(name)
