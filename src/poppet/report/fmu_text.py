"""Texts on the FMUs of a circuit, from their model descriptions alone."""

from __future__ import annotations

from pathlib import Path

from poppet.core.number_format import aligned, printable
from poppet.cosim.description import FmuVariable
from poppet.parts.fmu import FMU

MOST_PARAMETERS = 200
"""Maximum number of parameters in the list."""


def fmu_summary(name: str, part: FMU) -> str:
    """Return a line on an FMU: version, numbers of variables and properties for co-simulation."""
    fmu = part.description
    properties = ("returns to earlier states", fmu.can_roll_back), ("interpolates inputs", fmu.can_interpolate)
    counts = f"{len(fmu.inputs)} inputs, {len(fmu.outputs)} outputs"
    texts = [f"FMI {fmu.version}.0", counts, *(text for text, is_true in properties if is_true)]
    return f"{name}: {printable(Path(part.path).name)}, {', '.join(texts)}"


def fmu_table(name: str, part: FMU) -> str:
    """Return a table of the variables of an FMU: address, name in the FMU, causality, unit, start value, meaning."""
    fmu = part.description
    parameters = [v for v in fmu.variables if v.causality == "parameter"]
    shown = parameters[:MOST_PARAMETERS]
    rows = [["address", "variable", "causality", "unit", "start", "meaning"]]
    rows += [_row(name, part, v) for v in (*fmu.inputs, *fmu.outputs, *shown)]
    omitted = len(parameters) - len(shown)
    further = f"\n  and {omitted} further parameters" if omitted else ""
    return f"{fmu_summary(name, part)}\n{aligned(rows, [4])}{further}"


def _row(name: str, part: FMU, v: FmuVariable) -> list[str]:
    address = f"{name}.{v.local}" if v.causality != "parameter" else f"{name}.start.{v.local}"
    given = part.start_.get(v.local)
    if given is not None:
        start = given if isinstance(given, str) else given.display()
    else:
        start = "" if v.start is None else v.start if isinstance(v.start, str) else f"{v.unit.to_si(v.start):.6g}"
    texts = (v.name, v.causality, v.unit.name, start, v.meaning)
    return [f"  {address}", *(printable(text)[:80] for text in texts)]
