"""`poppet export st`: a sampled controller as structured text for a PLC."""

from __future__ import annotations

import argparse
from pathlib import Path

from poppet.cli.assignments import listed, loaded
from poppet.cli.parser import FILE, QUIET, SET, WITH, Option, tell_written
from poppet.core.errors import InputError

EXAMPLES = (
    "poppet export st FILE.toml --part controller -o controller.st",
    "poppet export st muscle_joint.toml --part position,inverse -o cascade.st",
)
OPTIONS = (
    FILE,
    Option("--part LIST", "sampled controllers, by name, that become one block; `controller` is the only one"),
    Option("-o, --output FILE", "file to write", (".st",)),
    WITH,
    SET,
    QUIET,
)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.core.files import write_whole
    from poppet.deploy.controller import controllers
    from poppet.deploy.st.block import block_of

    circuit, _ = loaded(options)
    if not options.part:
        known = [*controllers(circuit)]
        raise InputError("deploy.no_part_named", known=known) if known else InputError("deploy.controller.none")
    named = listed(options.part)
    parts = [] if named == ["controller"] and "controller" not in circuit.parts else named
    text = block_of(circuit, parts)
    if options.output is None:
        print(text, end="")
        return 0
    write_whole(Path(options.output), lambda stream: stream.write(text.encode("ascii")))
    if not options.quiet:
        tell_written(options.output)
    return 0
