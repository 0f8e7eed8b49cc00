"""Check of a circuit with its tables for audits and ensembles, without a simulation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.coupled_run import fmu_notes
from poppet.circuit.stop_conditions import parse_stop_condition
from poppet.circuit.trace import trace
from poppet.core.codes import Note


@dataclass(frozen=True)
class CircuitCheck:
    """Result of the check of a valid circuit."""

    circuit: BaseCircuit
    outputs: Mapping[str, str]  # address to SI unit
    notes: tuple[Note, ...]

    def counts(self) -> dict[str, int]:
        """Return the numbers of parts, states, inputs, outputs and assumed parameters, by a word for one of them."""
        parts = self.circuit.parts.values()
        return {
            "part": len(parts),
            "state": sum(len(part.states()) for part in parts),
            "input": sum(len(part.inputs()) for part in parts),
            "output": len(self.outputs),
            "assumed parameter": sum(number.source.kind == "assumed" for number in self.circuit.numbers().values()),
        }


def check_circuit(circuit: BaseCircuit, *, allow_python: bool = False) -> CircuitCheck:
    """Check the model, the stop conditions, and the tables for audits and ensembles of a circuit.

    The model is not compiled. With `allow_python`, metrics can be Python functions in files; the check executes none.
    """
    notes = list(circuit.static_notes)
    outputs = dict(trace(circuit.parts, tuple(circuit.parameters), circuit.connections).outputs)
    for text in circuit.run.stop_texts:
        parse_stop_condition(text, outputs, circuit.surroundings.pressure)
    # A file without a duration is valid: the option --duration can set it.
    if circuit.run.duration is not None:
        circuit.run.grid()
    notes += fmu_notes(circuit)
    if "audit" in circuit.origin.tables:
        from poppet.audit.tariff import tariff_of

        tariff_of(circuit)
    if "ensemble" in circuit.origin.tables:
        from poppet.ensemble import plan_of

        # Metrics without uncertain parameters are for sizing.
        is_nominal = not {"runs", "parameters", "numbers", "file", "sampling"} & {*circuit.origin.tables["ensemble"]}
        plan = plan_of(circuit, allow_python=allow_python, is_nominal=is_nominal)
        functions = plan.python_functions
        notes += [*plan.notes, *([Note("ensemble.executes", functions=functions)] if functions else ())]
    return CircuitCheck(circuit, outputs, tuple(notes))
