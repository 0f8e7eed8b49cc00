"""`poppet check`: every mistake of circuit files, without running them."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from poppet.cli.parser import Option
from poppet.core.errors import InputError, collect
from poppet.core.note_groups import grouped

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

EXAMPLES = ("poppet check valve-fill.toml", "poppet check bench/*.toml")
OPTIONS = (Option("FILE ...", "circuit files (.toml)"),)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    problems: list[InputError] = []
    # All files are looked at, whatever is wrong with the first.
    for file in options.files:
        try:
            _check(file)
        except InputError as error:
            problems.append(error)
    collect(problems)
    return 0


def _check(file: str) -> None:
    from poppet.circuit.file import load
    from poppet.core.toml_file import TomlFile

    circuit = load(file)
    notes = list(circuit.static_notes)
    try:
        outputs = _outputs(circuit)
        if "ensemble" in circuit.origin[0]:
            from poppet.ensemble import plan_of

            notes += plan_of(circuit).notes
    except InputError as error:
        raise TomlFile.read(file).located(error) from None
    parts = circuit.parts.values()
    counts = {
        "part": len(parts),
        "state": sum(len(part.states()) for part in parts),
        "input": sum(len(part.inputs()) for part in parts),
        "output": outputs,
        "assumed number": sum(number.source.kind == "assumed" for number in circuit.numbers().values()),
    }
    listed = ", ".join(f"{count} {name}{'s' * (count != 1)}" for name, count in counts.items())
    print(f"{file}: no mistakes; {listed}.")
    for note in grouped(notes):
        print(f"note: {note}", file=sys.stderr)


def _outputs(circuit: Circuit) -> int:
    """Number of outputs; stop conditions and output times are checked against them, nothing is compiled."""
    from poppet.circuit.stop_conditions import parse_stop_condition
    from poppet.circuit.trace import trace

    outputs = dict(trace(circuit.parts, tuple(circuit.parameters), circuit.connections).outputs)
    for text in circuit.run.stop_texts:
        parse_stop_condition(text, outputs, circuit.surroundings.pressure)
    # A file without a duration is right: `--duration` may give it.
    if circuit.run.duration is not None:
        circuit.run.grid()
    return len(outputs)
