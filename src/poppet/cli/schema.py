"""`poppet schema`: the JSON schema of circuit files."""

from __future__ import annotations

import argparse
import json

from poppet.cli.parser import Option

EXAMPLES = ("poppet schema", "poppet schema -o circuit.schema.json")
OPTIONS = (Option("-o, --output FILE", "file to write instead of printing it", (".json",)),)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.ensemble.schema import file_schema
    from poppet.ground.files import write_whole

    text = json.dumps(file_schema(), indent=2)
    if options.output is None:
        print(text)
        return 0
    write_whole(options.output, lambda stream: stream.write(f"{text}\n".encode()))
    print(f"{options.output}: written. Editors check circuit files against it.")
    return 0
