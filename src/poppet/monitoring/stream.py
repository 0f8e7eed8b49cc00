"""Lines of a stream: JSON objects and CSV rows as tables of values by column.

The text of a stream can contain anything. A line that cannot be read raises an error, and the next line is read
independently of it.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator, Mapping
from typing import Any, BinaryIO, NamedTuple

from poppet.core.errors import ErrorCollector, InputError, InputErrors, NameSuggestion, raise_errors
from poppet.core.number_format import printable
from poppet.core.units import exact_scale, with_state
from poppet.timeseries.tables.table import heading_of

LONGEST_LINE = 2**20
"""Maximum length of a line [bytes]."""
EXCERPT = 60
"""Maximum length of the text of a line in messages."""
_EMPTY = frozenset({"", "nan", "na", "n/a", "null", "none", "-", "--", "---"})
_SEPARATORS = "\t;,"


class HeadingError(InputErrors):
    """Error of the first heading of a stream: missing columns, or units that differ from the twin file."""


def lines_of(stream: BinaryIO) -> Iterator[bytes]:
    """Yield the lines of a stream without storing longer ones.

    A line above `LONGEST_LINE` is cut behind its first byte above the limit, and the rest of the line is skipped.
    """
    while line := stream.readline(LONGEST_LINE + 1):
        piece = line
        while len(piece) > LONGEST_LINE and not piece.endswith(b"\n"):
            piece = stream.readline(LONGEST_LINE + 1)
        yield line


class _Heading(NamedTuple):
    """Heading of CSV rows."""

    separator: str
    width: int  # number of cells
    columns: Mapping[str, int]  # column name to the index of its cell


class LineReader:
    """Reader of the lines of a stream, which remembers the CSV heading.

    Parameters
    ----------
    clock : str
        Column of the time.
    units : mapping
        Mapping from all columns, including the time, to their units.
    """

    def __init__(self, clock: str, units: Mapping[str, str]) -> None:
        self.clock, self.units = clock, units
        self._heading: _Heading | None = None

    def read(self, line: bytes) -> Mapping[str, Any] | None:
        """Return the values of a line by column, or None for an empty line and for a heading.

        Raises
        ------
        HeadingError
            If the first heading lacks a column or has another unit.
        InputError
            If the line cannot be read.
        """
        if len(line) > LONGEST_LINE:
            raise InputError("stream.long_line", most=LONGEST_LINE // 2**20)
        try:
            text = line.decode("utf-8-sig").strip()
        except UnicodeDecodeError:
            text = "\0"
        if "\0" in text:
            raise InputError("stream.no_text")
        if not text:
            return None
        return object_of(text) if text.startswith("{") else self._row(text)

    def _row(self, text: str) -> Mapping[str, Any] | None:
        heading = self._heading
        # A logger that starts again repeats its heading.
        if (heading is None or self.clock in text) and self._is_heading(text):
            return None
        if heading is None:
            raise InputError("stream.no_heading", text=printable(text[:EXCERPT]), column=self.clock)
        cells = _cells(text, heading.separator)
        if len(cells) != heading.width:
            raise InputError("stream.width", text=printable(text[:EXCERPT]), count=len(cells), expected=heading.width)
        is_decimal_comma = heading.separator != ","
        return {column: _value_of(cells[k], is_decimal_comma) for column, k in heading.columns.items()}

    def _is_heading(self, text: str) -> bool:
        """Return True if a line is a heading, whose columns then apply to the next lines."""
        separator = next((mark for mark in _SEPARATORS if mark in text), ",")
        cells = _cells(text, separator)
        headings = [heading_of(cell) for cell in cells]
        if self.clock not in (*cells, *(name for name, _ in headings)):
            return False
        columns: dict[str, int] = {}
        absent, other_units = ErrorCollector(), ErrorCollector()
        for column, unit in self.units.items():
            k = next((k for k, (name, _) in enumerate(headings) if column in (cells[k], name)), None)
            if k is None:
                suggestion = NameSuggestion(column, [name for name, _ in headings])
                absent.add("stream.no_column", column, suggestion=suggestion)
            elif (written := headings[k][1]) and exact_scale(with_state(written)) != exact_scale(with_state(unit)):
                other_units.add("stream.other_unit", column, written=written, unit=unit)
            else:
                columns[column] = k
        problems = [*absent.collected, *other_units.collected]
        if problems and self._heading is None:
            raise HeadingError(problems)
        # A later line without all columns is damaged: the next rows have the present heading.
        raise_errors(absent.collected)
        self._heading = _Heading(separator, len(cells), columns)
        raise_errors(other_units.collected)
        return True


def _cells(text: str, separator: str) -> list[str]:
    try:
        return [cell.strip() for cell in next(csv.reader([text], delimiter=separator), [])]
    except csv.Error:  # a cell above the limit of the reader
        return [text]


def _value_of(cell: str, is_decimal_comma: bool) -> float | str | None:
    """Return the number in a cell, None for an empty cell, or the text itself."""
    try:
        # Only Python accepts 1_000.
        return cell if "_" in cell else float(cell.replace(",", ".", 1) if is_decimal_comma else cell)
    except ValueError:
        return None if cell.lower() in _EMPTY else cell


def object_of(text: str) -> Mapping[str, Any]:
    """Return the JSON object in a text."""
    try:
        content = json.loads(text)
    except (ValueError, RecursionError) as problem:
        why = str(problem) if isinstance(problem, ValueError) else "it has too many levels"
        raise InputError("stream.no_json", text=printable(text[:EXCERPT]), why=why) from None
    assert isinstance(content, dict)  # the text begins with a brace
    return content
