"""`poppet export c`: a circuit as C."""

from __future__ import annotations

import argparse
from pathlib import Path

from poppet.cli.assignments import listed, loaded
from poppet.cli.parser import FILE, QUIET, SET, WITH, Option
from poppet.core.errors import InputError

EXAMPLES = (
    "poppet export c FILE.toml -o valve",
    "poppet export c FILE.toml --substeps 100 -o valve",
    "poppet export c FILE.toml --part controller --precision single -o controller",
)
OPTIONS = (
    FILE,
    Option("-o, --output FOLDER", "folder to write; that of an earlier export is written again"),
    Option("--name NAME", "of the model; that of the file when left out"),
    Option("--substeps N", "in which each call of the fixed step is made; 1 when left out", more={"type": int}),
    Option("--part LIST", "sampled controllers alone, by name; `controller` is the only one"),
    Option(
        "--precision WORD",
        "of a controller's numbers",
        choices={"double": "64 bits", "single": "32 bits, and 64 for times"},
    ),
    WITH,
    SET,
    QUIET,
)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.deploy.c.project import c_project
    from poppet.deploy.export_files import mark, write_folder

    if options.output is None:
        raise InputError("deploy.no_folder_named")
    if options.precision and not options.part:
        raise InputError("deploy.precision")
    if options.substeps is not None and options.part:
        raise InputError("deploy.substeps_of_part")
    circuit, _ = loaded(options)
    name = options.name or Path(options.file).stem
    if options.part:
        from poppet.deploy.c.controller import c_controller

        parts = () if options.part == "controller" and "controller" not in circuit.parts else listed(options.part)
        files = c_controller(circuit, parts, name=options.name or "", precision=options.precision or "double")
    else:
        files = c_project(circuit, name, substeps=1 if options.substeps is None else options.substeps)
    # Everything is made before anything is written.
    folder = write_folder(Path(options.output), files, mark("c", circuit.title, files))
    if not options.quiet:
        print(f"{folder}: {len(files)} files.")
    return 0
