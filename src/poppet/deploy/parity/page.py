"""The table of parity for a terminal, and as a page."""

from __future__ import annotations

from pathlib import Path

from poppet.deploy.parity.table import Parity, Row
from poppet.report.page import document, findings, head, write_page
from poppet.report.tables import Column, Table

MEANINGS = {"all": "every output", "gas": "pressures and masses of gas"}


def rows_table(of: Parity) -> Table:
    """A row for each target."""
    columns = (
        Column("target"), Column("what ran"), Column("time [ms]", ".4g"), Column("greatest difference", ".2e"),
        Column("of"), Column("limit", ".0e"), Column("counted"), Column("verdict"),
    )  # fmt: skip
    rows: list[tuple[str | float | None, ...]] = [
        ("kernel", f"the reference, {of.steps} steps", 1e3 * of.seconds, None, None, None, None, None)
    ]
    for row in of.rows:
        verdict = "not run" if row.why else _verdict(row)
        seconds = None if row.seconds is None else 1e3 * row.seconds
        worst = row.worst or None
        rows.append((row.name, row.what, seconds, row.greatest, worst, row.limit, MEANINGS[row.counted], verdict))
    return Table("parity", "", columns, tuple(rows))


def _verdict(row: Row) -> str:
    if not row.is_well:
        return "beyond"
    return "within" if row.greatest is None or row.greatest <= row.limit else "within rounding"


def outputs_table(of: Parity) -> Table:
    """A row for each output, a column for each target that was run."""
    ran = [row for row in of.rows if row.differences]
    names = list(dict.fromkeys([*of.sizes, *(name for row in ran for name in row.differences)]))
    columns = Column("output"), Column("size", ".4g"), *(Column(row.name, ".1e") for row in ran)
    rows = tuple((name, of.sizes.get(name), *(row.differences.get(name) for row in ran)) for name in names)
    return Table("outputs", "", columns, rows)


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
        "<p>A difference is the greatest one over all rows, by the size of the output: its greatest magnitude in the "
        "run, or what is usual for a state. What takes the kernel&#x27;s own steps is held to its digits; another "
        "method is held to what the tolerances are worth, and there only pressures and masses count: a regime changes "
        "a hair sooner or later, and the speed of a poppet at its stop is what it is. Times are the best of some runs "
        "on this machine, without what is made ready before. Within rounding: beyond the limit, and no further than "
        "ten times what the kernel makes of a start that is moved by 1e-14; no other code can be nearer.</p>\n"
    )
    sections = [
        ("", head(title, lead)),
        ("Targets", rows_table(of).html() + about),
        ("Not run", findings(not_run(of))),
        ("Every output", outputs_table(of).html()),
    ]
    return document(title, sections)
