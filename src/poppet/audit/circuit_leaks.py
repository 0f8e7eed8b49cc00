"""Leaks of a circuit: air and exergy that they cost in one machine cycle."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

from poppet.audit.energy_result import EnergyAudit, LeakRow
from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion, SimulationError

LEAKAGE = "leakage_mass_flow_rate"
"""End of the names of flow paths that exist only as leaks, such as the leakage past a piston."""
LEAK_FIELDS = ("leak_conductance", "exhaust_leak_conductance", "leak_fraction")
"""Parameters of leaks past the closing element of a valve."""
SMALLEST = 1e-9
"""Fraction of the supplied air below which a leak is omitted."""
_Circuit = TypeVar("_Circuit", bound=BaseCircuit)


def find_leaks(
    circuit: _Circuit,
    audit: EnergyAudit,
    audit_circuit: Callable[[_Circuit], EnergyAudit],
    addresses: Sequence[str] = (),
) -> tuple[tuple[LeakRow, ...], tuple[Note, ...]]:
    """Return the leaks of a circuit, and notes on leaks without result.

    Parameters
    ----------
    circuit : Circuit
        The audited circuit.
    audit : EnergyAudit
        Audit of the circuit.
    audit_circuit : callable
        Function that audits a changed circuit in the same way.
    addresses : sequence of str, optional
        Parts or flow paths that are leaks, for example an orifice that models a loose fitting.

    Returns
    -------
    tuple
        Leaks, with the largest first; and notes.

    Raises
    ------
    InputError
        If an address is neither a flow path nor a part with flow paths.

    Notes
    -----
    The air of a leakage past a piston, and of the flow paths in `addresses`, is the volume that flows through them in
    both directions. A leak past the closing element of a valve shares its flow path with the useful flow. Its air is
    therefore the difference to a simulated cycle without this leak.
    """
    rows = list(_leak_paths(audit, addresses))
    notes = []
    for part, values in _repairs(circuit).items():
        try:
            repaired = audit_circuit(circuit.with_values(values))
        except (InputError, SimulationError) as error:
            notes.append(Note("leaks.no_result", part, reason=str(error)))
            continue
        air = audit.air_used - repaired.air_used
        rows.append(_row(audit, part.partition(".")[0], part, air, audit.exergy_supplied - repaired.exergy_supplied))
    rows = [row for row in rows if abs(row.air) > SMALLEST * abs(audit.air_used)]
    return tuple(sorted(rows, key=lambda row: -row.air)), tuple(notes)


def _leak_paths(audit: EnergyAudit, addresses: Sequence[str]) -> Iterator[LeakRow]:
    """Yield the flow paths that are leaks by their name, or because the user says so."""
    names = {path.name.removesuffix("mass_flow_rate").rstrip("._") for path in audit.flow_paths}
    names |= {path.part for path in audit.flow_paths}
    for address in addresses:
        if address not in names and address not in (path.name for path in audit.flow_paths):
            near = NameSuggestion(address, names)
            raise InputError("names.unknown", address, meaning="a flow path or a part with flow paths", suggestion=near)
    for path in audit.flow_paths:
        short = path.name.removesuffix("mass_flow_rate").rstrip("._")
        if path.name.endswith(LEAKAGE) or {path.name, short, path.part} & set(addresses):
            yield _row(audit, path.part, path.name, path.forward + path.backward, path.throttling)


def _repairs(circuit: BaseCircuit) -> dict[str, dict[str, float]]:
    """Return the values without leak of each part whose closing element leaks."""
    repairs: dict[str, dict[str, float]] = defaultdict(dict)
    for address, value in circuit.parameters.items():
        part, _, field = address.rpartition(".")
        if field in LEAK_FIELDS and value > 0.0:
            repairs[part][address] = 0.0
    return repairs


def _row(audit: EnergyAudit, part: str, flow_path: str, air: float, exergy: float) -> LeakRow:
    tariff = audit.tariff
    cost = math.nan if tariff is None else tariff.cost(air) * tariff.cycles_per_year(audit.cycle.duration)
    return LeakRow(part, flow_path, air, exergy, cost)
