"""Declarations of all numbers of a circuit, with units and limits."""

from __future__ import annotations

import math
import re

from poppet.circuit.circuit import BaseCircuit
from poppet.parts.fields import NumberSpec, flatten
from poppet.parts.rows import NumberTable
from poppet.parts.steps import SequenceProgram


def number_specs(circuit: BaseCircuit) -> dict[str, NumberSpec]:
    """Return the declaration of each parameter of a circuit by address.

    A declaration contains the unit and the valid range.
    """
    declared = {f"{name}.{key}": spec for name, part in circuit.parts.items() for key, spec, _ in flatten(part)}
    for name, part in circuit.parts.items():
        for table in vars(part).values():
            if isinstance(table, NumberTable | SequenceProgram):
                declared |= {f"{name}.{table.field}.{key}": spec for key, spec in table.number_specs().items()}
        for key, number in part.numbers().items():
            # Tabulated values of C and b have limits; coefficients of polynomials have none.
            match = re.search(r"\b(sonic_conductance|critical_ratio)\.(value|y\d+)$", key)
            spec = NumberSpec(number.unit, f"coefficient {key}")
            if match is not None:
                below = 1.0 if match[1] == "critical_ratio" else math.inf
                spec = NumberSpec(number.unit, f"value {key}", low=0.0, below=below)
            declared.setdefault(f"{name}.{key}", spec)
    return declared
