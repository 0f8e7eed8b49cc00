"""`poppet identify`: numbers with intervals from bench recordings."""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.cli.main import INTERRUPTED
from poppet.cli.output_files import output_path
from poppet.cli.progress import Counting

if TYPE_CHECKING:
    from poppet.identify import Result

EXAMPLES = (
    "poppet identify fit FIT.toml --compare OTHER.toml -o RESULT.toml --report REPORT.html",
    "poppet identify tank TANK.toml -o RESULT.toml",
    "poppet identify flow POINTS.toml --report REPORT.html",
    "poppet identify characteristic TESTS.toml --library valve.toml",
)
RESULTS, PAGES, LIBRARIES = (".toml", ".json"), (".html",), (".toml",)
OPTION_WAYS = {
    "compare": ("fit",),
    "profile": ("fit", "tank"),
    "bootstrap": ("fit", "tank"),
    "library": ("characteristic",),
}
"""Options that not every way in has."""
WAYS = {
    "fit": "any free numbers of any circuit, from any recordings",
    "tank": "C, b and wall heat of a charge or discharge test (ISO 6358-2)",
    "flow": "C, b, m and cracking pressure of a steady flow bench (ISO 6358-1)",
    "characteristic": "C(x), b(x) from tests at known strokes",
}


def add_options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    ways = "; ".join(f"{name}: {what}" for name, what in WAYS.items())
    parser.add_argument("way", metavar="WAY", choices=tuple(WAYS), help=ways)
    parser.add_argument("file", metavar="FILE", help="what to identify from what (.toml), see docs/identify.md")
    parser.add_argument("-o", "--output", metavar="FILE", help="write the result: .toml or .json")
    parser.add_argument("--report", metavar="FILE", help="write a page for people: .html")
    parser.add_argument("--compare", metavar="FILE", help="fit: judge another fit file against this one")
    parser.add_argument(
        "--profile", action="append", default=[], metavar="ADDRESS", help="fit, tank: interval by profile likelihood"
    )
    parser.add_argument("--bootstrap", type=int, default=0, metavar="N", help="fit, tank: N bootstrap fits")
    parser.add_argument("--library", metavar="FILE", help="characteristic: write it for circuit files, .toml")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    output, page = output_path(options.output, RESULTS), output_path(options.report, PAGES)
    library = output_path(options.library, LIBRARIES)
    with Counting("evaluations", is_quiet=options.quiet) as counting:
        result = _identified(options, counting)
    if output:
        result.save(output)
    if page:
        from poppet.report.identification.page import write_identification

        write_identification(result, page)
    if library:
        from poppet.identify.characteristic.file import write_characteristic

        write_characteristic(result, library)
    if not options.quiet:
        print(summary(result))
        for path in (output, page, library):
            if path:
                print(f"{path}: written.")
    return INTERRUPTED if result.conditions.get("interrupted") else 0


def _identified(options: argparse.Namespace, progress: Counting) -> Result:
    """The result of the way that was asked for."""
    way, path = options.way, Path(options.file)
    _refuse_unfit(options)
    if way == "fit":
        from poppet.identify import identify_fit

        return identify_fit(
            path,
            compare=options.compare,
            profile=options.profile,
            repeats=options.bootstrap,
            progress=progress,
            stages=progress.stages,
        )
    if way == "tank":
        from poppet.identify.tank.tank import identify_tank

        return identify_tank(
            path,
            profile=options.profile,
            repeats=options.bootstrap,
            progress=progress,
            stages=progress.stages,
        )
    if way == "flow":
        from poppet.identify.flow.file import read_flow_file
        from poppet.identify.flow.run import identify_flow

        points, choices = read_flow_file(path)
        return identify_flow(points, **choices)
    from poppet.identify.characteristic.file import read_characteristic_file
    from poppet.identify.characteristic.run import identify_characteristic

    tests, choices = read_characteristic_file(path)
    return identify_characteristic(tests, progress=progress, **choices)


def _refuse_unfit(options: argparse.Namespace) -> None:
    """Refuse options that another way in has."""
    from poppet.ground.errors import InputError, collect

    collect(
        [
            InputError(f"--{name}", f"has no meaning for `identify {options.way}`.", f"It is for: {', '.join(ways)}.")
            for name, ways in OPTION_WAYS.items()
            if getattr(options, name) and options.way not in ways
        ]
    )
    if options.bootstrap < 0:
        raise InputError(f"--bootstrap {options.bootstrap}", "is below zero.", "Give the number of fits: 200, say.")


def summary(result: Result) -> str:
    """What a person reads in a terminal."""
    from poppet.identify.result import behind

    lines = [result.title] if result.title else []
    width = max((len(name) for name in result.parameters), default=0)
    for name, e in result.parameters.items():
        unit = behind(e.unit)
        lines.append(
            f"  {name:<{width}}  {e.value:.6g} +/- {e.standard_error:.2g}{unit}  "
            f"[{e.low:.5g} ... {e.high:.5g}]  {e.verdict}"
        )
    for name, r in result.residuals.items():
        unit = behind(r.unit)
        nrmse = f"NRMSE {100.0 * r.nrmse:.2f} %, " if math.isfinite(r.nrmse) else ""
        lines.append(f"  {name}: rms {r.rms:.4g}{unit}, {nrmse}bias {r.bias:.3g}{unit}")
    lines += [f"- {sentence}" for sentence in result.findings]
    return "\n".join(lines)
