"""Check of a circuit with all tables of its file, without a simulation."""

from __future__ import annotations

from poppet.circuit.circuit import BaseCircuit
from poppet.core.errors import ErrorCollector
from poppet.report.circuit.check import CircuitCheck, check_circuit
from poppet.serve.modbus_map import map_of_circuit
from poppet.serve.points import ServedCircuit


def check_file(circuit: BaseCircuit, *, allow_python: bool = False) -> CircuitCheck:
    """Check a circuit as `check_circuit` does, and its table `[modbus]`; their errors are raised together."""
    with ErrorCollector() as errors:
        with errors.collecting():
            check = check_circuit(circuit, allow_python=allow_python)
        if "modbus" in circuit.origin.tables:
            with errors.collecting():
                map_of_circuit(ServedCircuit.of(circuit, allow_native=True))  # executes nothing
    return check
