"""`poppet schema`: the JSON schema of circuit files."""

from __future__ import annotations

import argparse
import json

from poppet.cli.parser import Option

EXAMPLES = ("poppet schema", "poppet schema -o circuit.schema.json")
OPTIONS = (Option("-o, --output FILE", "file to write instead of printing it", (".json",)),)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.core.files import write_whole
    from poppet.ensemble.ensemble_schema import file_schema

    text = json.dumps(file_schema(), indent=2)
    if options.output is None:
        print(text)
        return 0
    write_whole(options.output, lambda stream: stream.write(f"{text}\n".encode()))
    print(f"{options.output}: written. Editors check circuit files against it.")
    return 0
