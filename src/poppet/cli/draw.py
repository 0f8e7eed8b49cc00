"""`poppet draw`: a picture of a circuit."""

from __future__ import annotations

import argparse

from poppet.cli.output_files import PICTURES, output_path

EXAMPLES = ("poppet draw valve-fill.toml -o valve-fill.svg", "poppet draw valve-fill.toml -o valve-fill.png")


def add_options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("file", metavar="FILE", help="circuit file (.toml)")
    parser.add_argument("-o", "--output", metavar="PICTURE", required=True, help="file to write: .svg, .png or .pdf")


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    output = output_path(options.output, PICTURES)
    assert output is not None
    from poppet.circuit.file import load
    from poppet.report.circuit.picture import draw_circuit

    circuit = load(options.file)
    draw_circuit(circuit, output)
    print(f"{output}: {len(circuit.parts)} parts drawn.")
    return 0
