"""The table of parity for a terminal, and as a page."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from poppet.deploy.parity.table import Parity
from poppet.report.html_page import document, findings, head, write_page
from poppet.report.tables import Column, Table

MEANINGS = {"all": "every output", "gas": "pressures and masses of gas"}
VERDICTS = {"rounding": "within rounding", "coarse": "step too long"}


def rows_table(of: Parity, *, is_long: bool = False) -> Table:
    """A row for each target; a long one says what ran, and what counts."""
    columns = [
        Column("target"), Column("time [ms]", ".4g"), Column("greatest difference", ".2e"), Column("of"),
        Column("limit", ".0e"), Column("compared until [s]", ".4g"), Column("states, whole run", ".1e"),
        Column("kernel changed", ".1e"), Column("verdict"),
    ]  # fmt: skip
    rows: list[tuple[str | float | None, ...]] = [("kernel", 1e3 * of.seconds, *[None] * 7)]
    rows += [
        (
            row.name,
            None if row.seconds is None else 1e3 * row.seconds,
            row.greatest,
            row.worst if row.greatest else None,
            row.target.limit if np.isfinite(row.target.limit) else None,
            None if row.why else row.until,
            row.drift,
            row.moved,
            VERDICTS.get(row.verdict, row.verdict),
        )
        for row in of.rows
    ]
    if is_long:
        columns[1:1] = [Column("what ran"), Column("what counts")]
        about = [(row.target.what, MEANINGS[row.target.of]) for row in of.rows]
        rows = [
            (row[0], *more, *row[1:])
            for row, more in zip(rows, [(f"the reference, {of.steps} steps", None), *about], strict=True)
        ]
    return Table(columns, rows, name="parity")


def outputs_table(of: Parity) -> Table:
    """A row for each output, a column for each target that was run."""
    ran = [row for row in of.rows if row.differences]
    names = list(dict.fromkeys([*of.sizes, *(name for row in ran for name in row.differences)]))
    columns = Column("output"), Column("size", ".4g"), *(Column(row.name, ".1e") for row in ran)
    rows = tuple((name, of.sizes.get(name), *(row.differences.get(name) for row in ran)) for name in names)
    return Table(columns, rows, name="outputs")


def not_run(of: Parity) -> list[str]:
    """Why targets were not run, in words."""
    return [f"{row.name}: {row.why}" for row in of.rows if row.why is not None]


def write_parity(of: Parity, path: str | Path) -> Path:
    """Write the table as one page: targets, what was not run, every output."""
    return write_page(path, lambda: parity_page(of))


def parity_page(of: Parity) -> str:
    """The page as text."""
    title = f"{of.title or 'A circuit'}: the same run by every target"
    ran = sum(row.why is None for row in of.rows)
    lead = (
        f"A run of {of.duration:.6g} s. {ran} of {len(of.rows)} targets were run beside the kernel; "
        f"{'all of them are' if of.is_well else 'not all of them are'} within their limits."
    )
    about = (
        "<p>A difference is the greatest one over the rows that are compared, by the size of the output: its greatest "
        "magnitude in the run, or what is usual for a state. What takes the kernel&#x27;s own steps is held to its "
        "digits, to those of a kernel that fuses no multiplication with an addition; another method is held to what "
        "the tolerances are worth, and there only pressures and masses count. Rows are compared as long as the kernel "
        "itself, changed by as little as such a run must differ, stays by itself. After that two runs that are both "
        "right part, and the greatest difference of a state in the whole run stands beside what these changes make of "
        "the kernel: ten times that is beyond. Within rounding: beyond the limit, and no further than ten times what "
        "the kernel makes of other rounding. Times are the best of some runs on this machine, without what is made "
        "ready before.</p>\n"
    )
    sections = [
        ("", head(title, lead)),
        ("Targets", rows_table(of, is_long=True).html() + about),
        ("Not run", findings(not_run(of))),
        ("Every output", outputs_table(of).html()),
    ]
    return document(title, sections)
