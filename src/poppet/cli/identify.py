"""`poppet identify`: numbers with intervals from bench recordings."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.cli.main import INTERRUPTED
from poppet.cli.parser import QUIET, REPORT, RESULT, Option
from poppet.cli.progress import Counting, Points
from poppet.cli.summary import ask_for_drawing, hand_over
from poppet.core.errors import OutOfRangeError

if TYPE_CHECKING:
    from poppet.identify import Result

EXAMPLES = (
    "poppet identify fit FIT.toml --compare OTHER.toml -o RESULT.toml --report REPORT.html",
    "poppet identify friction FRICTION.toml -o RESULT.toml --report REPORT.html",
    "poppet identify characteristic TESTS.toml --library valve.toml",
    "poppet identify design DESIGN.toml --report DESIGN.html",
)
WAYS = {
    "fit": "any free numbers of any circuit, from any recordings",
    "tank": "C, b and wall heat of a charge or discharge test (ISO 6358-2)",
    "flow": "C, b, m and cracking pressure of a steady flow bench (ISO 6358-1)",
    "characteristic": "C(x), b(x) from tests at known strokes",
    "muscle": "the law of a muscle's force, from a force map or recordings",
    "friction": "the law of friction, from velocity-force tables or recordings of motion",
    "design": "of tests that could be made, those that would tell most",
}
OPTIONS = (
    Option("WAY", "", choices=WAYS),
    Option("FILE", "what to identify from what (.toml), see docs/identify.md"),
    RESULT,
    REPORT,
    Option("--compare FILE", "judge another fit file against this one", only=["fit"]),
    Option("--profile ADDRESS ...", "interval by profile likelihood", only=["fit", "tank"]),
    Option("--contour", "misfit over conductance and wall heat, for the page", only=["fit", "tank"]),
    Option("--bootstrap N", "N bootstrap fits", only=["fit", "tank"], more={"type": int, "default": 0}),
    Option("--library FILE", "write C(x), b(x) for circuit files", (".toml",), only=["characteristic"]),
    Option("--all", "print all findings, not the first three only"),
    QUIET,
)
FINDINGS = 3
"""What is printed of the findings where not all are asked for."""


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    if options.bootstrap < 0:
        raise OutOfRangeError("cli.bootstrap", count=options.bootstrap)
    ask_for_drawing(options.report)
    if options.way == "design":
        return _designed(options)
    with Counting("evaluations", is_quiet=options.quiet) as counting:
        result = _identified(options, counting)
    if options.library:
        from poppet.identify.characteristic.characteristic_file import write_characteristic

        write_characteristic(result, options.library)

    def write_page(path: Path) -> None:
        from poppet.report.identification.identification_report import write_identification

        write_identification(result, path)

    hand_over(options, result, summary(result, FINDINGS if not options.all else None), write_page, options.library)
    return INTERRUPTED if result.conditions.get("interrupted") else 0


def _identified(options: argparse.Namespace, progress: Counting) -> Result:
    """The result of the way that was asked for."""
    from poppet import identify

    way, path = options.way, Path(options.file)
    if way in ("fit", "tank"):
        given: dict[str, Any] = {"profile": options.profile, "repeats": options.bootstrap, "contour": options.contour}
        given |= {"progress": progress, "stages": progress.stages}
        if way == "fit":
            return identify.identify_fit(path, compare=options.compare, **given)
        return identify.identify_tank(path, **given)
    if way == "flow":
        return identify.identify_flow(path)
    if way == "muscle":
        return identify.identify_muscle(path)
    if way == "friction":
        return identify.identify_friction(path)
    return identify.identify_characteristic(path, progress=progress)


def _designed(options: argparse.Namespace) -> int:
    """Rank tests that could be made."""
    from poppet import identify
    from poppet.report.identification.design_report import design_text, write_design

    with Points(is_quiet=options.quiet) as points:
        design = identify.identify_design(Path(options.file), progress=points)
    hand_over(options, design, design_text(design), lambda path: write_design(design, path))
    return INTERRUPTED if design.interrupted else 0


def summary(result: Result, most: int | None = None) -> str:
    """What a person reads in a terminal; `most` findings, or all."""
    from poppet.core.note_groups import grouped
    from poppet.report.identification.headline import headline, next_step, split_notes

    lines = [result.title] if result.title else []
    lines.append(headline(result, is_plain=True))
    lines += [f"Next: {step}"] if (step := next_step(result)) else []
    lines += result.lines()
    major, minor = split_notes(result.remarks)
    shown = [*major, *minor] if most is None else [*grouped(major), *grouped(minor)]
    lines += [f"- {remark}" for remark in shown[:most]]
    left = len(shown[most:]) if most is not None else 0
    lines += [f"  ({left} more: --all, the page and the result file)"] if left else []
    return "\n".join(lines)
