"""Energy and exergy balances, and the division of air between parts, in random circuits of all kinds of flow paths."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from poppet.audit.energy import audit_energy
from poppet.audit.energy_result import INTEGRATION as INTEGRATION_ERROR
from poppet.audit.energy_result import MIXING, THROTTLING, EnergyAudit

sys.path.insert(0, str(Path(__file__).parent))
from seeded_pneumatics import RandomCircuit, random_circuit

CLOSURE, INTEGRATION = 1e-9, 1e-5
"""Limits relative to the sum of all rows: residual or negative loss, and integration error."""
ONE_WAY = (
    "orifice", "check_valve", "relief_valve", "silencer", "filter", "directional_valve", "spool_valve", "main_stage",
    "pressure_regulator", "shuttle_valve", "two_pressure_valve", "quick_exhaust_valve", "flow_control_valve",
    "piloted_check_valve",
)  # fmt: skip
"""Parts whose throttling is not negative, because no flow drives another one."""


def audit(item: RandomCircuit) -> EnergyAudit:
    circuit = item.circuit
    return audit_energy(circuit, cycle=f"{0.1 * item.duration} s, {0.9 * item.duration} s", duration=item.duration)


def violations(item: RandomCircuit) -> list[str]:
    """Audit a circuit, and return the laws that the result violates."""
    result = audit(item)
    # A circuit that is almost at rest has rows of rounding errors.
    size = max(sum(abs(getattr(row, q)) for row in result.rows) for q in ("energy", "exergy"))
    scale = size + 1e-3
    found = [q for q in ("energy", "exergy") if abs(result.residual(q)) * size > CLOSURE * scale]
    kinds = {name: part.kind for name, part in item.circuit.parts.items()}
    for row in result.rows:
        is_loss = row.category == THROTTLING and kinds[row.part] in ONE_WAY
        if is_loss and row.exergy < -CLOSURE * scale:
            found.append(f"{row.category} of {row.name}")
    # Where a flow reverses, its temperature is between those of both gas nodes: one of them can gain exergy.
    if result.total(MIXING) < -CLOSURE * scale:
        found.append("mixing")
    integration = result.total(INTEGRATION_ERROR)
    if abs(integration) > INTEGRATION * scale:
        found.append("integration")
    air = [abs(path.forward) + abs(path.backward) for path in result.flow_paths]
    parts = sum(row.air for row in result.parts)
    if abs(parts - result.air_used) > 1e-9 * (sum(air) + 1e-8):
        found.append("air")
    if item.is_closed and (result.air_used != 0.0 or result.exergy_supplied != 0.0):
        found.append("supply of a closed circuit")
    return found


def audit_circuits(shapes: range, each: int) -> None:
    for shape in shapes:
        for number in range(each):
            item = random_circuit(np.random.default_rng([1, shape]), np.random.default_rng([2, shape, number]))
            assert violations(item) == [], (shape, number)


def test_the_balances_of_one_circuit_close() -> None:
    audit_circuits(range(1000, 1001), 2)


@pytest.mark.parametrize(("shapes", "each"), [(12, 2), pytest.param(300, 2, marks=pytest.mark.slow)])
def test_the_balances_of_random_circuits_close(shapes: int, each: int) -> None:
    audit_circuits(range(shapes), each)
