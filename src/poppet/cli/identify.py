"""Command `poppet identify`: estimation of parameters with confidence intervals from recordings."""

from __future__ import annotations

import argparse
from pathlib import Path

from poppet.cli.main import INTERRUPTED, WRONG_INPUT
from poppet.cli.parser import MEASURED
from poppet.cli.progress import FitProgress, PointProgress
from poppet.cli.summary import require_matplotlib, write_result
from poppet.core.errors import InputError
from poppet.core.plugins import import_object
from poppet.core.tables import Field
from poppet.identify.methods import METHODS

FINDINGS = 3
"""Maximum number of findings that are printed without the option `--all`."""


def execute(options: argparse.Namespace) -> int:
    """Run the command `identify`, print or write its result, and return the exit code."""
    Field(unit="1", low=0.0, meaning="number of bootstrap fits").read(options.bootstrap, "--bootstrap")
    require_matplotlib(options.report)
    method = METHODS[options.method]
    if getattr(options, "recording", None):
        from poppet.cli.identify_recording import describe_recording

        if not describe_recording(options):
            return WRONG_INPUT
    elif options.file is None:
        message = "the following arguments are required: FILE"
        raise InputError("cli.usage", program="poppet identify", message=message)
    elif options.method == "tank" and Path(options.file).suffix.lower() in MEASURED:
        raise InputError("question.is_recording", path=options.file)
    settings = {item.keyword: getattr(options, item.option.name) for item in method.options if item.keyword}
    display = PointProgress if method.counts_points else FitProgress
    with display(is_quiet=options.quiet) as progress:
        stages = getattr(progress, "stages", None)
        result = method.identify(options.file, **settings, progress=progress, stages=stages)
    written = []
    for item in method.options:
        path: Path | None = getattr(options, item.option.name) if item.write else None
        if path is not None:
            import_object(item.write)(result, path)
            written.append(path)
    text = import_object(method.text)(result, None if options.all else FINDINGS)
    write_result(options, result, text, lambda path: import_object(method.report)(result, path), *written)
    return INTERRUPTED if result.interrupted else 0
