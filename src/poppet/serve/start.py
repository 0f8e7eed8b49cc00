"""Start of a machine from a circuit."""

from __future__ import annotations

from typing import Any

from poppet.circuit.circuit import BaseCircuit
from poppet.core.units import quantity
from poppet.serve.clocked_periods import MachineClock
from poppet.serve.machine import Machine
from poppet.serve.machine_process import ProcessMachine
from poppet.serve.points import ServedCircuit


def start_machine(
    circuit: BaseCircuit, period: Any, speed: float = 1.0, *, has_clock: bool = True, allow_native: bool = False
) -> Machine:
    """Return a machine that runs a circuit; `poppet.Circuit.serve` describes the arguments."""
    seconds = quantity(period, "s", name="period").value
    served = ServedCircuit.of(circuit, allow_native=allow_native)
    return ProcessMachine(served, MachineClock(seconds, speed)) if has_clock else Machine(served, seconds)
