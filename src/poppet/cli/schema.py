"""`poppet schema`: the JSON schema of circuit files."""

from __future__ import annotations

import argparse
import json

from poppet.cli.output_files import output_path, write_text

EXAMPLES = ("poppet schema", "poppet schema -o circuit.schema.json")


def add_options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("-o", "--output", metavar="FILE", help="file to write (.json); printed when left out")


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    output = output_path(options.output, (".json",))
    from poppet.circuit.schema import circuit_schema

    text = json.dumps(circuit_schema(), indent=2)
    if output is None:
        print(text)
        return 0
    write_text(output, f"{text}\n")
    print(f"{output}: written. Editors check circuit files against it.")
    return 0
