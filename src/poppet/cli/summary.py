"""Texts about recordings and results that several commands print."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.note_groups import grouped
from poppet.core.number_format import USUAL, aligned, digits_of
from poppet.timeseries.plotting.tube_bands import cells_of

if TYPE_CHECKING:
    from poppet.core.codes import Note
    from poppet.timeseries.recording import Recording


def in_usual_units(recording: Recording) -> Recording:
    """Return a copy of the recording in practical units, such as bar."""
    units = zip(recording.names, recording.units, strict=True)
    return recording.converted({name: USUAL[unit] for name, unit in units if unit in USUAL})


def output_table(recording: Recording, *, is_complete: bool = True) -> str:
    """Return a table with the first, last, minimum and maximum value of every output, as text.

    If the keyword `is_complete` is False, the cells of a tube have one row, with their minimum and maximum only.
    """
    tubes = {} if is_complete else cells_of(recording.names)
    groups = {group[0]: group for group in tubes.values()}
    omitted = {name for group in tubes.values() for name in group[1:]}
    rows = [["series", "unit", "first", "last", "min", "max"]]
    for name, unit, values in zip(recording.names, recording.units, recording.values, strict=True):
        if name in omitted:
            continue
        shown, all_values = name, values
        ends: tuple[float, ...] = values[0], values[-1]
        if name in groups:
            tube, _, output = name.rpartition(".")
            shown, ends = f"{tube} ... {len(groups[name])}.{output}", ()
            all_values = np.array([recording[cell] for cell in groups[name]])
        low, high = all_values.min(), all_values.max()
        cells = [digits_of(value, max(-low, high)) for value in (*ends, low, high)]
        rows.append([shown, "" if unit == "1" else unit, *[""] * (4 - len(cells)), *cells])
    return aligned(rows, range(2, 6))


def balance_sentence(recording: Recording) -> str:
    """Return a sentence on the residuals of the mass and energy balances of a simulation."""
    # An empty gas node without flow has no allowed residual.
    balances = [balance for balance in recording.residuals if balance.allowed > 0.0]
    if not balances:
        return "Balances: no gas node with a balance."
    worst = max(balances, key=lambda balance: balance.error / balance.allowed)
    verdict = "all within limits" if all(balance.is_kept for balance in balances) else "NOT all within limits"
    return (
        f"Balances: {len(balances)} checked, {verdict}; closest to its limit: {worst.name}, "
        f"residual {worst.error:.2g} {worst.unit} of {worst.allowed:.2g} {worst.unit} allowed."
    )


def run_summary(recording: Recording, *, is_complete: bool = True) -> str:
    """Return the summary of a simulation that is printed if no output file is written.

    If the keyword `is_complete` is False, the cells of a tube are one row of the table.
    """
    lines = [recording.title] if recording.title else []
    lines.append(recording.outcome)
    lines += ["", load_summary(recording)] if recording.figures else []
    if recording.time.size:
        lines += ["", extent(recording), output_table(recording, is_complete=is_complete), ""]
    lines.append(balance_sentence(recording))
    accepted, rejected = (recording.statistics.get(f"{kind}_steps", 0) for kind in ("accepted", "rejected"))
    lines.append(f"Steps: {accepted:.0f} accepted, {rejected:.0f} rejected.")
    return "\n".join(lines)


def load_summary(recording: Recording) -> str:
    """Return the tables of strokes and energies of a simulation with moved bodies as text."""
    from poppet.report.result_tables import ENERGY, STROKES, energy_table, stroke_table

    metrics = recording.figures
    strokes = [STROKES, stroke_table(metrics).text(), ""] if metrics.strokes else []
    return "\n".join([*strokes, ENERGY, energy_table(metrics).text()])


def extent(recording: Recording) -> str:
    """Return the extent of a recording as text: number of rows and outputs, and time span."""
    span = f", {recording.time[0]:.6g} ... {recording.time[-1]:.6g} s" if recording.time.size else ""
    return f"{recording.time.size} row{'s' * (recording.time.size != 1)}, {len(recording)} series{span}"


def print_notes(notes: Iterable[Note]) -> None:
    """Print notes to the standard error.

    Similar notes are combined into one.
    """
    for note in grouped(notes):
        print(f"note: {note}", file=sys.stderr)


def print_written(*paths: Path | None) -> None:
    """Print the names of the files that a command has written.

    A name that is None is ignored.
    """
    for path in paths:
        if path is not None:
            print(f"{path}: written.")


def require_matplotlib(*paths: Path | None) -> None:
    """Raise an error if a figure is requested and Matplotlib is not installed.

    Each argument in `paths` is the path of a file with figures, or None if this file is not requested. Commands call
    the function before their computation.
    """
    if any(paths):
        from poppet.timeseries.plotting.figures import style

        style("A picture")


def write_result(
    options: argparse.Namespace, result: Any, text: str, write_report: Callable[[Path], Any], *files: Path | None
) -> None:
    """Print a text, and write a result and its report to the files that the options specify.

    `write_report` writes the report to a path. After `text`, the names of all written files are printed. The further
    arguments are names of files that have already been written.
    """
    # First, so that a file that cannot be written does not lose the result of a long computation.
    print(text, flush=True)
    if options.output:
        result.save(options.output)
    if options.report:
        write_report(options.report)
    print_written(options.output, options.report, *files)
