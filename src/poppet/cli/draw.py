"""`poppet draw`: a picture of a circuit."""

from __future__ import annotations

import argparse

from poppet.cli.parser import FILE, Option

EXAMPLES = ("poppet draw valve-fill.toml -o valve-fill.svg", "poppet draw valve-fill.toml -o valve-fill.png")
OPTIONS = (FILE, Option("-o, --output PICTURE", "file to write", (".svg", ".png", ".pdf"), more={"required": True}))


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.circuit.file import load
    from poppet.report.circuit.schematic import draw_circuit

    circuit = load(options.file)
    draw_circuit(circuit, options.output)
    print(f"{options.output}: {len(circuit.parts)} parts drawn.")
    return 0
