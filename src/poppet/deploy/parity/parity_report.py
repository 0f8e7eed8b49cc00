"""Parity table for the terminal and as an HTML report."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from poppet.deploy.parity.parity_table import Parity
from poppet.report.html_page import document, findings, head, write_page
from poppet.report.tables import Column, ReportTable

SCOPES = {"all": "every output", "gas": "pressures and masses of gas"}
VERDICTS = {"rounding": "within rounding", "coarse": "step too long"}


def results_table(parity: Parity, *, is_long: bool = False) -> ReportTable:
    """Return the parity table: one row per check.

    With `is_long`, the rows also have the descriptions and the compared outputs.
    """
    columns = [
        Column("target"), Column("time [ms]", ".4g"), Column("greatest difference", ".2e"), Column("of"),
        Column("limit", ".0e"), Column("compared until [s]", ".4g"), Column("states, whole run", ".1e"),
        Column("kernel changed", ".1e"), Column("verdict"),
    ]  # fmt: skip
    rows: list[tuple[str | float | None, ...]] = [("kernel", 1e3 * parity.seconds, *[None] * 7)]
    rows += [
        (
            row.name,
            None if row.seconds is None else 1e3 * row.seconds,
            row.greatest,
            row.worst if row.greatest else None,
            row.check.limit if np.isfinite(row.check.limit) else None,
            None if row.why else row.until,
            row.drift,
            row.moved,
            VERDICTS.get(row.verdict, row.verdict),
        )
        for row in parity.rows
    ]
    if is_long:
        columns[1:1] = [Column("what ran"), Column("what counts")]
        descriptions = [(row.check.description, SCOPES[row.check.scope]) for row in parity.rows]
        descriptions = [(f"the reference, {parity.steps} steps", ""), *descriptions]
        rows = [(row[0], *texts, *row[1:]) for row, texts in zip(rows, descriptions, strict=True)]
    return ReportTable(columns, rows, name="parity")


def outputs_table(parity: Parity) -> ReportTable:
    """Return the maximum difference of each output, with one column for each target that was run."""
    compared = [row for row in parity.rows if row.differences]
    names = list(dict.fromkeys([*parity.sizes, *(name for row in compared for name in row.differences)]))
    columns = Column("output"), Column("size", ".4g"), *(Column(row.name, ".1e") for row in compared)
    rows = tuple((name, parity.sizes.get(name), *(row.differences.get(name) for row in compared)) for name in names)
    return ReportTable(columns, rows, name="outputs")


def not_run_notes(parity: Parity) -> list[str]:
    """Return a sentence for each target that was not run, with the reason."""
    return [f"{row.name}: {row.why}" for row in parity.rows if row.why is not None]


def write_parity(parity: Parity, path: str | Path) -> Path:
    """Write the parity report: results of the targets, targets that were not run, differences of every output."""
    return write_page(path, lambda: parity_page(parity))


def parity_page(parity: Parity) -> str:
    """Return the parity report as HTML."""
    title = f"{parity.title or 'A circuit'}: comparison of all export targets"
    n_run = sum(row.why is None for row in parity.rows)
    lead = (
        f"A run of {parity.duration:.6g} s. {n_run} of {len(parity.rows)} targets were compared with the kernel; "
        f"{'all of them are' if parity.is_within_limits else 'not all of them are'} within their limits."
    )
    explanation = (
        "<p>A difference is the maximum over the compared rows, relative to the size of the output. The size is the "
        "maximum magnitude in the run, or the nominal size of a state. Targets with the steps of the kernel must agree "
        "with a kernel without fused operations (FMA) up to rounding. For other methods, the limit follows from the "
        "tolerances, and only pressures and masses are compared. The comparison ends when small changes of the kernel "
        "lead to a different run. After that, the maximum difference of a state in the whole run is compared with the "
        "effect of these changes on the kernel: the verdict is beyond if it is more than ten times as large. Within "
        "rounding means: beyond the limit, but at most ten times the effect of rounding on the kernel. Times are the "
        "best of some runs on this machine, without preparation.</p>\n"
    )
    sections = [
        ("", head(title, lead)),
        ("Targets", results_table(parity, is_long=True).html() + explanation),
        ("Not run", findings(not_run_notes(parity))),
        ("Every output", outputs_table(parity).html()),
    ]
    return document(title, sections)
