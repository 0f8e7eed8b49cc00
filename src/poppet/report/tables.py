"""Tables of results, which can be printed as text, HTML or CSV."""

from __future__ import annotations

import html
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from poppet.core.csv_cells import csv_text
from poppet.core.number_format import aligned

STACKED_COLUMNS = 3
"""Minimum number of columns for which narrow screens show one block per row."""


class Markup(str):
    """Text that is HTML already: a table or a page includes it unchanged.

    Any other text is escaped.
    """

    __slots__ = ()


def code(text: object, suffix: str = "") -> Markup:
    """Return a text as HTML program code, followed by the HTML text `suffix`."""
    return Markup(f"<code>{html.escape(str(text))}</code>{suffix}")


def with_detail(text: str, detail: str) -> Markup:
    """Return an HTML cell with a second line in a light colour.

    The second line is omitted if `detail` is empty.
    """
    lines = [html.escape(text), f'<span class="lead">{html.escape(detail)}</span>']
    return Markup("<br>".join(line for line, content in zip(lines, (text, detail), strict=True) if content))


@dataclass(frozen=True)
class Column:
    """Column of a table, with heading and number format.

    Examples are the heading `time [s]` and the format `.2f`. A column with a format is aligned on the right. Cells that
    are texts are not formatted.
    """

    heading: str
    digits: str = ""

    def format(self, value: Any) -> str:
        """Return a value as text, or a dash for None."""
        if value is None:
            return "-"
        return format(value, self.digits) if self.digits and not isinstance(value, str) else str(value)


def numeric(*headings: str, digits: str = "s") -> tuple[Column, ...]:
    """Return a right-aligned column for each heading.

    The keyword `digits` is the format specification of the cells in all columns, for example `.4g`. The default `s` is
    for cells that already contain text.
    """
    return tuple(Column(heading, digits) for heading in headings)


@dataclass(frozen=True)
class ReportTable:
    """Table of a report: rows of cells under headings.

    A cell is a number, text, `Markup` or None. A plain text in `columns` is the heading of a column of texts. If all
    headings are empty, the table has no header row.

    Examples
    --------
    >>> table = ReportTable(("law", Column("time [s]", ".1f")), [("isothermal", 71.111)])
    >>> print(table.text())
    law         time [s]
    isothermal      71.1
    >>> ReportTable(("", ""), [("a < b", Markup("<b>c</b>"))]).html().splitlines()[1]
    '<tr><td>a &lt; b</td><td><b>c</b></td></tr>'
    """

    columns: Sequence[Column | str]
    rows: Sequence[Sequence[Any]]
    caption: str = ""
    name: str = ""  # of a file, `tank_laws`
    css_class: str = ""

    def __bool__(self) -> bool:
        """Return True if the table has rows."""
        return bool(self.rows)

    def _columns(self) -> list[Column]:
        return [column if isinstance(column, Column) else Column(column) for column in self.columns]

    @property
    def headings(self) -> list[str]:
        """Headings of the columns."""
        return [column.heading for column in self._columns()]

    def cells(self) -> list[list[str]]:
        """Return the cells of the table as texts, row by row."""
        columns = self._columns()
        return [[column.format(value) for column, value in zip(columns, row, strict=True)] for row in self.rows]

    def text(self) -> str:
        """Return the table as text for a terminal."""
        header, cells = self.headings, self.cells()
        is_number = [k for k, column in enumerate(self._columns()) if column.digits]
        return aligned([header, *cells] if any(header) else cells, is_number)

    def csv(self) -> str:
        """Return the table as CSV text.

        Numbers have all digits.
        """
        return csv_text([self.headings, *self.rows])

    def html(self) -> str:
        """Return the table as an HTML element.

        The text is empty if the table has no rows.
        """
        if not self.rows:
            return ""
        columns, is_stacked = self._columns(), len(self.columns) >= STACKED_COLUMNS
        align = [' class="number"' if column.digits else "" for column in columns]
        headings = [html.escape(column.heading) for column in columns]
        names = [f' data-name="{text}"' if k and is_stacked and text else "" for k, text in enumerate(headings)]
        header = "".join(f'<th scope="col"{kind}>{text}</th>' for kind, text in zip(align, headings, strict=True))
        header = f"<thead><tr>{header}</tr></thead>\n" if any(headings) else ""
        header = f"<caption>{html.escape(self.caption)}</caption>\n{header}" if self.caption else header
        lines = []
        for row in self.rows:
            cells = (
                value if isinstance(value, Markup) else html.escape(column.format(value))
                for column, value in zip(columns, row, strict=True)
            )
            pairs = zip(align, names, cells, strict=True)
            lines.append(f"<tr>{''.join(f'<td{kind}{name}>{cell}</td>' for kind, name, cell in pairs)}</tr>\n")
        kinds = " ".join(filter(None, ("scroll", self.css_class, "stack" * is_stacked)))
        return f'<div class="{kinds}" tabindex="0"><table>{header}<tbody>\n{"".join(lines)}</tbody></table></div>\n'
