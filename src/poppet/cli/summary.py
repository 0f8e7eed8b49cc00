"""What commands print of a recording, and what they do with a result."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.cli.parser import tell_written
from poppet.core.number_format import USUAL, aligned, digits_of

if TYPE_CHECKING:
    from poppet.timeseries.recording import Recording


def readable(recording: Recording) -> Recording:
    """The recording in the units in which people read."""
    series = zip(recording.names, recording.units, strict=True)
    return recording.converted({name: USUAL[unit] for name, unit in series if unit in USUAL})


def series_table(recording: Recording) -> str:
    """First, last, least and greatest value of every series."""
    rows = [["series", "unit", "first", "last", "min", "max"]]
    for name, unit, row in zip(recording.names, recording.units, recording.values, strict=True):
        low, high = row.min(), row.max()
        figures = (digits_of(figure, max(-low, high)) for figure in (row[0], row[-1], low, high))
        rows.append([name, "" if unit == "1" else unit, *figures])
    return aligned(rows, range(2, 6))


def balance_sentence(recording: Recording) -> str:
    """Whether mass and energy were conserved."""
    # A store that nothing passed through and that is empty has no limit to be near.
    balances = [balance for balance in recording.residuals if balance.allowed > 0.0]
    if not balances:
        return "Balances: no store with a balance."
    worst = max(balances, key=lambda balance: balance.error / balance.allowed)
    verdict = "all kept" if all(balance.is_kept for balance in balances) else "NOT kept"
    return (
        f"Balances: {len(balances)} checked, {verdict}; nearest to its limit {worst.name}, "
        f"residual {worst.error:.2g} {worst.unit} of {worst.allowed:.2g} {worst.unit} allowed."
    )


def run_summary(recording: Recording) -> str:
    """What a person wants to know after a run without an output file."""
    lines = [recording.title] if recording.title else []
    lines.append(recording.outcome)
    lines += ["", first_asked(recording)] if recording.figures else []
    if recording.time.size:
        lines += ["", extent(recording), series_table(recording), ""]
    lines.append(balance_sentence(recording))
    accepted, rejected = (recording.statistics.get(f"{kind}_steps", 0) for kind in ("accepted", "rejected"))
    lines.append(f"Steps: {accepted:.0f} accepted, {rejected:.0f} rejected.")
    return "\n".join(lines)


def first_asked(recording: Recording) -> str:
    """Figures of a run with loads."""
    from poppet.report.result_tables import ENERGY, STROKES, energy_table, stroke_table

    metrics = recording.figures
    strokes = [STROKES, stroke_table(metrics).text(), ""] if metrics.strokes else []
    return "\n".join([*strokes, ENERGY, energy_table(metrics).text()])


def extent(recording: Recording) -> str:
    """How much a recording holds."""
    span = f", {recording.time[0]:.6g} ... {recording.time[-1]:.6g} s" if recording.time.size else ""
    return f"{recording.time.size} row{'s' * (recording.time.size != 1)}, {len(recording)} series{span}"


def ask_for_drawing(*paths: Path | None) -> None:
    """Say that pages and pictures cannot be drawn before the work, not after it."""
    if any(paths):
        from poppet.timeseries.plotting.figures import style

        style("A picture")


def hand_over(
    options: argparse.Namespace, result: Any, text: str, write_page: Callable[[Path], Any], *others: Path | None
) -> None:
    """Write a result and its page where they were asked for, and print what a person reads."""
    if options.output:
        result.save(options.output)
    if options.report:
        write_page(options.report)
    if not options.quiet:
        print(text)
        tell_written(options.output, options.report, *others)
