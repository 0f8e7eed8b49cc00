"""A table of results, once: as text for a terminal, as HTML for a page, as CSV for whoever calculates on."""

from __future__ import annotations

import csv
import html
import io
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Column:
    """A column of a table.

    Parameters
    ----------
    heading : str
        With its unit, `time [s]`.
    digits : str, optional
        Format of its numbers, `.2f`; text is left as it is.
    """

    heading: str
    digits: str = ""

    def show(self, value: Any) -> str:
        """A value of the column as a reader sees it."""
        if value is None:
            return "-"
        return format(value, self.digits) if self.digits and not isinstance(value, str) else str(value)


@dataclass(frozen=True)
class Table:
    """Rows of values under columns with units.

    Parameters
    ----------
    name : str
        Of a file, `tank_laws`.
    title : str
        What the table shows.
    columns : tuple of Column
        One per value of a row.
    rows : tuple of tuple
        Numbers, text or None.

    Examples
    --------
    >>> columns = Column("law"), Column("time [s]", ".1f")
    >>> print(Table("laws", "Tank laws", columns, (("isothermal", 71.111),)).text())
    law         time [s]
    isothermal      71.1
    """

    name: str
    title: str
    columns: tuple[Column, ...]
    rows: tuple[tuple[Any, ...], ...]

    def shown(self) -> list[list[str]]:
        """The rows as a reader sees them."""
        return [[column.show(v) for column, v in zip(self.columns, row, strict=True)] for row in self.rows]

    def text(self) -> str:
        """The table for a terminal."""
        headings, rows = [column.heading for column in self.columns], self.shown()
        widths = [max(map(len, cells)) for cells in zip(headings, *rows, strict=True)]
        right = [bool(column.digits) for column in self.columns]
        lines = [
            "  ".join(
                cell.rjust(width) if flush else cell.ljust(width)
                for cell, width, flush in zip(cells, widths, right, strict=True)
            )
            for cells in (headings, *rows)
        ]
        return "\n".join(line.rstrip() for line in lines)

    def csv(self) -> str:
        """The table with all digits."""
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow([column.heading for column in self.columns])
        writer.writerows(self.rows)
        return stream.getvalue()

    def html(self) -> str:
        """The table as an element of a page."""
        marks = [' class="number"' if column.digits else "" for column in self.columns]
        head = "".join(
            f'<th scope="col"{mark}>{html.escape(column.heading)}</th>'
            for column, mark in zip(self.columns, marks, strict=True)
        )
        body = "".join(
            "<tr>" + "".join(f"<td{m}>{html.escape(v)}</td>" for m, v in zip(marks, row, strict=True)) + "</tr>\n"
            for row in self.shown()
        )
        caption = f"<caption>{html.escape(self.title)}</caption>"
        return f"<table>{caption}\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}</tbody></table>\n"
