"""`poppet export fmu`: a circuit as an FMU."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from poppet.cli.assignments import assignments, listed, loaded
from poppet.cli.parser import FILE, SET, WITH, Option, tell_written
from poppet.cli.progress import Waiting

EXAMPLES = (
    "poppet export fmu valve-fill.toml -o valve.fmu",
    "poppet export fmu valve-fill.toml -o valve.fmu --fmi 3 --platform linux64,win64",
    "poppet export fmu valve-fill.toml -o valve.fmu --input bleed.opening --set run.duration=20",
)
OPTIONS = (
    FILE,
    Option("-o, --output FILE", "write the FMU", (".fmu",), more={"required": True}),
    Option("--fmi VERSION", "version of FMI", choices={"2": "FMI 2.0", "3": "FMI 3.0"}, more={"default": "2"}),
    Option("--platform LIST", "binaries for linux64, win64, darwin64, aarch64-darwin; linux64 by default"),
    Option(
        "--input ADDRESS ...",
        "an input or number that the host drives, besides the inputs with signals",
        more={"dest": "inputs"},
    ),
    Option("--name NAME", "of the model; by default the title of the circuit"),
    WITH,
    SET,
)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.deploy.fmu.origin import origin
    from poppet.deploy.fmu.package import fmu_of, write_fmu

    circuit, notes = loaded(options)
    with Waiting("The FMU is compiled"):
        fmu = fmu_of(
            circuit, options.name or "", fmi=int(options.fmi), inputs=options.inputs,
            platforms=listed(options.platform) or ("linux64",),
            resources=origin(
                Path(options.file).read_text(encoding="utf-8"), assignments(options.values), options.result
            ),
        )  # fmt: skip
    write_fmu(fmu, options.output)
    print(_text(fmu))
    for note in [*notes, *fmu.notes]:
        print(f"- {note}")
    tell_written(options.output)
    return 0


def _text(fmu: Any) -> str:
    counts = {kind: sum(v.causality == kind for v in fmu.plan.variables) for kind in ("input", "parameter", "output")}
    parts = [f"{count} {kind}{'s' * (count != 1)}" for kind, count in counts.items()]
    inputs = [v.name for v in fmu.plan.variables if v.causality == "input"]
    text = f"{', '.join(parts)}; binaries: {', '.join(fmu.platforms) or 'none'}"
    return f"{text}\ninputs: {', '.join(inputs)}" if inputs else text
