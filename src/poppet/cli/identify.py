"""`poppet identify`: numbers with intervals from bench recordings."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.cli.main import INTERRUPTED
from poppet.cli.progress import FitProgress, PointProgress
from poppet.cli.summary import require_matplotlib, write_result
from poppet.core.errors import OutOfRangeError

if TYPE_CHECKING:
    from poppet.identify import Result

FINDINGS = 3
"""What is printed of the findings where not all are asked for."""


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    if options.bootstrap < 0:
        raise OutOfRangeError("cli.bootstrap", count=options.bootstrap)
    require_matplotlib(options.report)
    if options.method == "design":
        return _designed(options)
    with FitProgress(is_quiet=options.quiet) as counting:
        result = _identified(options, counting)
    if options.library:
        from poppet.identify.characteristic.characteristic_file import write_characteristic

        write_characteristic(result, options.library)

    def write_page(path: Path) -> None:
        from poppet.report.identification.identification_report import write_identification

        write_identification(result, path)

    write_result(options, result, summary(result, FINDINGS if not options.all else None), write_page, options.library)
    return INTERRUPTED if result.conditions.get("interrupted") else 0


def _identified(options: argparse.Namespace, progress: FitProgress) -> Result:
    """The result of the way that was asked for."""
    from poppet import identify

    way, path = options.method, Path(options.file)
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

    with PointProgress(is_quiet=options.quiet) as points:
        design = identify.identify_design(Path(options.file), progress=points)
    write_result(options, design, design_text(design), lambda path: write_design(design, path))
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
