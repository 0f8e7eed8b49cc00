"""`poppet identify`: parameters with confidence intervals from recordings."""

from __future__ import annotations

import argparse
from pathlib import Path

from poppet.cli.main import INTERRUPTED
from poppet.cli.parser import QUIET, REPORT, RESULT, Option
from poppet.cli.progress import Counting, Points
from poppet.cli.summary import ask_for_drawing, hand_over
from poppet.core.errors import OutOfRangeError
from poppet.identify.methods import METHODS, imported

EXAMPLES = tuple(example for method in METHODS.values() for example in method.examples)
_OPTIONS = {item.option.usage: item.option for method in METHODS.values() for item in method.options}
OPTIONS = (
    Option("METHOD", "", choices={method.name: method.summary for method in METHODS.values()}),
    Option("FILE", "identification file (.toml), see docs/identify.md"),
    RESULT,
    REPORT,
    *(
        Option(
            usage,
            option.help,
            option.formats,
            only=[m.name for m in METHODS.values() if any(item.option.usage == usage for item in m.options)],
            more=option.keywords,
        )
        for usage, option in _OPTIONS.items()
    ),
    Option("--all", "print all findings instead of the first three"),
    QUIET,
)
FINDINGS = 3
"""Number of findings that are printed without `--all`."""


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    if options.bootstrap < 0:
        raise OutOfRangeError("cli.bootstrap", count=options.bootstrap)
    ask_for_drawing(options.report)
    method = METHODS[options.method]
    settings = {item.keyword: getattr(options, item.option.name) for item in method.options if item.keyword}
    display = (
        Points(is_quiet=options.quiet) if method.counts_points else Counting("evaluations", is_quiet=options.quiet)
    )
    with display as progress:
        stages = getattr(progress, "stages", None)
        result = method.identify(options.file, **settings, progress=progress, stages=stages)
    written = []
    for item in method.options:
        path: Path | None = getattr(options, item.option.name) if item.write else None
        if path is not None:
            imported(item.write)(result, path)
            written.append(path)
    text = imported(method.text)(result, None if options.all else FINDINGS)
    hand_over(options, result, text, lambda path: imported(method.report)(result, path), *written)
    return INTERRUPTED if result.interrupted else 0
