"""A table of results, once: as text for a terminal, as HTML for a page, as CSV for whoever calculates on."""

from __future__ import annotations

import csv
import html
import io
from dataclasses import dataclass
from typing import Any

from poppet.core.number_format import aligned
from poppet.report.html_page import table


@dataclass(frozen=True)
class Column:
    """A column of a table."""

    heading: str  # with its unit, `time [s]`
    digits: str = ""  # format of its numbers, `.2f`; text is left as it is

    def show(self, value: Any) -> str:
        """A value of the column as a reader sees it."""
        if value is None:
            return "-"
        return format(value, self.digits) if self.digits and not isinstance(value, str) else str(value)


@dataclass(frozen=True)
class Table:
    """Rows of values under columns with units.

    Examples
    --------
    >>> columns = Column("law"), Column("time [s]", ".1f")
    >>> print(Table("laws", "Tank laws", columns, (("isothermal", 71.111),)).text())
    law         time [s]
    isothermal      71.1
    """

    name: str  # of a file, `tank_laws`
    title: str  # what the table shows
    columns: tuple[Column, ...]
    rows: tuple[tuple[Any, ...], ...]  # numbers, text or None

    @property
    def numbers(self) -> list[int]:
        """Places of the columns of numbers."""
        return [k for k, column in enumerate(self.columns) if column.digits]

    def shown(self) -> list[list[str]]:
        """The rows as a reader sees them."""
        return [[column.show(v) for column, v in zip(self.columns, row, strict=True)] for row in self.rows]

    def text(self) -> str:
        """The table for a terminal."""
        return aligned([[column.heading for column in self.columns], *self.shown()], self.numbers)

    def csv(self) -> str:
        """The table with all digits."""
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow([column.heading for column in self.columns])
        writer.writerows(self.rows)
        return stream.getvalue()

    def html(self) -> str:
        """The table as an element of a page."""
        rows = [[html.escape(cell) for cell in row] for row in self.shown()]
        return table([c.heading for c in self.columns], rows, numbers=self.numbers, caption=self.title, kind="plain")
