"""Single faults of the valves of a circuit, all of which share one compiled model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, TypeVar

from poppet.circuit.circuit import BaseCircuit
from poppet.core.errors import ErrorCollector, NameSuggestion
from poppet.parts.faults import FAULTS, HEALTHY, Valve

AnyCircuit = TypeVar("AnyCircuit", bound=BaseCircuit)

STUCK_KINDS = ("stuck_open", "stuck_closed", "stuck")
"""Faults of a stuck channel."""
NEVER = 1e9
"""Start of a fault that never begins in a run [s]."""


class ValveFault(NamedTuple):
    """Fault of a valve."""

    valve: str
    word: str

    @property
    def name(self) -> str:
        """Name of the fault, `VALVE.WORD`."""
        return f"{self.valve}.{self.word}"

    def values(self, start: float) -> dict[str, Any]:
        """Return the values of the valve with this fault from the time `start` on [s]."""
        return {f"{self.valve}.fault": self.word, f"{self.valve}.fault_start": start}


def valves_of(circuit: BaseCircuit) -> dict[str, Valve]:
    """Return the valves of a circuit that have no fault yet, by name."""
    return {name: part for name, part in circuit.parts.items() if isinstance(part, Valve) and part.fault == HEALTHY}


def read_kinds(kinds: Sequence[str]) -> tuple[str, ...]:
    """Check names of faults such as `stuck_open`, and return them in the usual order."""
    with ErrorCollector() as errors:
        for kind in kinds:
            if kind not in FAULTS:
                suggestion = NameSuggestion(kind, FAULTS)
                errors.add("fields.not_an_option", "kinds", value=kind, meaning="fault", suggestion=suggestion)
    return tuple(kind for kind in FAULTS if kind in kinds)


def split_faults(valves: Mapping[str, Valve], kinds: Sequence[str]) -> tuple[list[ValveFault], list[ValveFault]]:
    """Return the faults that the valves can have, and those that they cannot have."""
    possible: list[ValveFault] = []
    omitted: list[ValveFault] = []
    for name, valve in valves.items():
        for kind in kinds:
            (possible if kind in valve.faults else omitted).append(ValveFault(name, kind))
    return possible, omitted


def with_idle_faults(circuit: AnyCircuit, faults: Sequence[ValveFault]) -> AnyCircuit:
    """Return a copy of a circuit in which each of these valves has a fault that never begins.

    Copies with other faults then have the same compiled model.
    """
    idle = {fault.valve: fault for fault in reversed(faults)}
    values = {address: value for fault in idle.values() for address, value in fault.values(NEVER).items()}
    return circuit.with_values(values) if values else circuit
