"""`poppet size`: the smallest or largest number with which a circuit file meets its requirements."""

from __future__ import annotations

import argparse
import sys

from poppet.cli.assignments import loaded
from poppet.cli.parser import FILE, QUIET, REPORT, RESULT, SET, WITH, Option
from poppet.cli.progress import Points
from poppet.cli.summary import ask_for_drawing, hand_over
from poppet.core.errors import InputError
from poppet.core.note_groups import grouped

EXAMPLES = (
    "poppet size ensemble.toml --free fill.sonic_conductance --meet fast",
    'poppet size ensemble.toml --free tank.volume --largest --between "0.5 l" "20 l" --yield "95 %"',
    "poppet size ensemble.toml --free tank.volume --largest --size '1 l' --size '2 l' --report size.html",
)
OPTIONS = (
    FILE,
    WITH,
    SET,
    Option("--free ADDRESS", "the number that is sought", more={"required": True}),
    Option("--meet NAME ...", "requirements of the file; all of them by default"),
    Option("--between LOW HIGH", "range to look in, with units", more={"nargs": 2, "metavar": ("LOW", "HIGH")}),
    Option("--largest", "seek the largest value instead of the smallest"),
    Option("--yield SHARE", "share of good runs, of the distributions in the file: 95 % or 0.95"),
    Option("--size SIZE ...", "a standard size: the next one that holds is named"),
    RESULT,
    REPORT,
    QUIET,
)
NONE_FOUND = 1
"""Exit code where no value of the range holds."""


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.core.toml_file import TomlFile
    from poppet.core.units import quantity
    from poppet.ensemble import size
    from poppet.report.ensemble.sizing_report import sizing_text, write_sizing

    ask_for_drawing(options.report)
    circuit, notes = loaded(options)
    asked = vars(options)["yield"]
    share = None if asked is None else quantity(asked, "1", name="--yield").value
    for note in grouped([*notes, *circuit.static_notes]):
        print(f"note: {note}", file=sys.stderr)
    try:
        with Points(is_quiet=options.quiet) as progress:
            found = size(
                circuit,
                options.free,
                meet=options.meet,
                between=tuple(options.between) if options.between else None,
                largest=options.largest,
                share=share,
                sizes=options.size,
                progress=progress,
            )
    except InputError as error:
        raise TomlFile.read(options.file).located(error) from None
    hand_over(options, found, sizing_text(found), lambda path: write_sizing(found, path))
    return 0 if found.is_met else NONE_FOUND
