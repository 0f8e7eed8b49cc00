"""Tables in text files: what separates the columns, where the numbers begin, and what stands above them."""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from poppet.ground.errors import InputError
from poppet.series.checks import FloatArray
from poppet.series.measured.columns import Table, heading_of, unit_of

_NUMBER = {
    ".": re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][+-]?\d+)?|[+-]?inf(?:inity)?", re.IGNORECASE),
    ",": re.compile(r"[+-]?(?:\d+(?:,\d+)?|,\d+)(?:[eEdD][+-]?\d+)?|[+-]?inf(?:inity)?", re.IGNORECASE),
}
_EMPTY = frozenset({"", "nan", "na", "n/a", "null", "none", "-", "--", "---"})
_SEPARATORS = ("\t", ";", ",", " ")
_WORDS = {"tab": "\t", "\\t": "\t", "space": " ", "spaces": " ", "comma": ",", "semicolon": ";"}
_SAID = {"\t": "tabs", " ": "spaces", ",": "commas", ";": "semicolons"}
# Lines by which the layout is guessed: the last ones, where numbers stand whatever is above them, and some in between.
_LAST, _BETWEEN = 60, 200

Line = tuple[int, str]
"""Number of a line in the file, counted from 1, and its text."""


@dataclass(frozen=True)
class _Layout:
    separator: str
    decimal: str
    width: int = 0
    is_numeric: tuple[bool, ...] = ()

    def cells(self, text: str) -> list[str]:
        if self.separator == " ":
            return text.split()
        return [cell.strip() for cell in next(csv.reader([text], delimiter=self.separator), [])]

    def is_number(self, cell: str) -> bool:
        return _NUMBER[self.decimal].fullmatch(cell) is not None

    def is_sample(self, text: str) -> bool:
        """True when the line has a number first, or numbers wherever the table has them.

        A line that begins like a sample and goes on with text is a sample with a mistake, not a heading.
        """
        cells = self.cells(text)
        kinds = [self.is_number(cell) for cell in cells]
        if len(cells) != self.width or not any(kinds):
            return False
        return (kinds[0] and self.is_numeric[0]) or all(
            is_number or cell.lower() in _EMPTY or not numeric
            for cell, is_number, numeric in zip(cells, kinds, self.is_numeric, strict=True)
        )


def read(
    path: Path, *, separator: str | None = None, decimal: str | None = None, header_rows: int | None = None
) -> Table:
    """Read the columns of a text file."""
    text, notes = _text(path)
    ends = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    lines = [(k, line) for k, line in enumerate(ends, start=1) if line.strip()]
    comments = [line for line in lines if line[1].lstrip().startswith("#")]
    kept = [line for line in lines if not line[1].lstrip().startswith("#")]
    if not kept:
        raise InputError("the file", "is empty.", "Give lines of numbers.")
    layout = _guess(kept, _separators(separator), _decimals(decimal))
    head, body = _parted(kept, layout, header_rows)
    names, units, heading_notes = _headings(head, comments, layout, body)
    guessed = f"The columns are separated by {_SAID.get(layout.separator, repr(layout.separator))}"
    notes += [f"{guessed}, decimal sign {layout.decimal!r}."] if separator is None or decimal is None else []
    notes += heading_notes + [comment.lstrip("# \t") for _, comment in comments]
    columns, cell_notes = _columns(body, layout, names)
    return _named(names, units, columns, notes + cell_notes)


def _named(names: list[str], units: list[str], columns: list[FloatArray], notes: list[str]) -> Table:
    if len(names) > 1 and names[-1] == "" and not np.isfinite(columns[-1]).any():
        names, units, columns = names[:-1], units[:-1], columns[:-1]  # a separator at the end of every line
    names = [name or f"column {k}" for k, name in enumerate(names)]
    return Table(tuple(names), tuple(columns), tuple(units), tuple(notes))


def _text(path: Path) -> tuple[str, list[str]]:
    content = path.read_bytes()
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return content.decode("utf-16", errors="replace"), []
    if b"\0" in content:
        raise InputError("the file", "is binary.", "Save it as text, or give it the suffix of its format.")
    try:
        return content.decode("utf-8-sig"), []
    except UnicodeDecodeError:
        return content.decode("latin-1"), ["The file is not UTF-8; it was read as Latin-1."]


def _separators(given: str | None) -> Sequence[str]:
    if given is None:
        return _SEPARATORS
    word = _WORDS.get(given.strip().lower(), given)
    if len(word) != 1:
        cure = 'Write ",", ";", "tab" or "space".'
        raise InputError(f"separator = {given!r}", "is not one character.", cure, address="separator")
    return (word,)


def _decimals(given: str | None) -> Sequence[str]:
    if given not in (None, ".", ","):
        given = f"decimal = {given!r}"
        raise InputError(given, "is no decimal sign.", 'Write "." or ",".', address="decimal")
    return (".", ",") if given is None else (given,)


def _guess(lines: Sequence[Line], separators: Sequence[str], decimals: Sequence[str]) -> _Layout:
    """The layout that reads the largest share of the lines as numbers, then the one with more columns.

    One column alone, which has no time, is the last resort.
    """
    sample = [text for _, text in (*lines[:: 1 + len(lines) // _BETWEEN], *lines[-_LAST:])]
    choices = [(s, d) for s in separators for d in decimals if s != d]
    if not choices:
        given = f"separator = {separators[0]!r} and decimal = {decimals[0]!r}"
        raise InputError(given, "are the same sign.", "Give two.", address="separator")
    scored = [_scored(sample, _Layout(*choice)) for choice in choices]
    score, layout = max(scored, key=lambda each: each[0])
    if score[1] == 0.0:
        raise InputError("the file", "holds no lines of numbers.", "Check what wrote it, and its separator.")
    return layout


def _scored(sample: Sequence[str], layout: _Layout) -> tuple[tuple[bool, float, int], _Layout]:
    rows = [layout.cells(text) for text in sample]
    with_numbers = [row for row in rows if any(layout.is_number(cell) for cell in row)]
    if not with_numbers:
        return (False, 0.0, 0), layout
    widths = [len(row) for row in with_numbers]
    width = max(sorted(set(widths)), key=widths.count)
    fitting = [row for row in with_numbers if len(row) == width]
    numbers = [sum(layout.is_number(row[k]) for row in fitting) for k in range(width)]
    empty = [sum(row[k].lower() in _EMPTY for row in fitting) for k in range(width)]
    is_numeric = tuple(n >= 0.5 * (len(fitting) - e) for n, e in zip(numbers, empty, strict=True))
    share = (sum(numbers) + sum(empty)) / (width * len(fitting)) * len(fitting) / len(rows)
    score = (width > 1 and share >= 0.5, round(share, 2), width)
    return score, _Layout(layout.separator, layout.decimal, width, is_numeric)


def _parted(lines: list[Line], layout: _Layout, header_rows: int | None) -> tuple[list[Line], list[Line]]:
    """Header and samples; a stated count that ends above the headings is mended."""
    if header_rows is not None and (isinstance(header_rows, bool) or header_rows < 0):
        given = f"header_rows = {header_rows}"
        raise InputError(given, "is not a count of lines.", "Write 0, 1, 2 ...", address="header_rows")
    if header_rows is None:
        at = next((k for k, (_, text) in enumerate(lines) if layout.is_sample(text)), None)
    else:
        at = next((k for k, (number, _) in enumerate(lines) if number > header_rows), None)
        while at is not None and at < len(lines) and not any(map(layout.is_number, layout.cells(lines[at][1]))):
            at += 1
    if at is None or at == len(lines):
        raise InputError("the file", "holds no samples.", "Give at least one line of numbers below the headings.")
    return lines[:at], lines[at:]


def _headings(
    head: list[Line], comments: list[Line], layout: _Layout, body: list[Line]
) -> tuple[list[str], list[str], list[str]]:
    """Names and units: the last header line, with a line of units below it where there is one."""
    rows = [layout.cells(text) for _, text in head]
    units = [unit_of(cell.strip("[]()")) for cell in rows[-1]] if len(rows) > 1 else []
    if len(units) == layout.width == len(rows[-2]) and all(
        unit or not cell for unit, cell in zip(units, rows[-1], strict=True)
    ):
        return [heading_of(cell)[0] for cell in rows[-2]], units, _other_lines(head[:-2])
    if rows and _fits(rows[-1], layout.width):
        cells = rows[-1] + [""] * (layout.width - len(rows[-1]))
        named = [heading_of(cell) for cell in cells]
        return [name for name, _ in named], [unit for _, unit in named], _other_lines(head[:-1])
    return _headings_of_comment(head, comments, layout, body)


def _fits(cells: list[str], width: int) -> bool:
    return len(cells) == width or (len(cells) == width - 1 and width > 2)


def _headings_of_comment(
    head: list[Line], comments: list[Line], layout: _Layout, body: list[Line]
) -> tuple[list[str], list[str], list[str]]:
    above = [text for number, text in comments if number < body[0][0]]
    cells = layout.cells(above[-1].lstrip("# \t")) if above else []
    notes = _other_lines(head)
    if len(cells) == layout.width:
        named = [heading_of(cell) for cell in cells]
        notes.append("The headings were taken from the comment above the numbers.")
        return [name for name, _ in named], [unit for _, unit in named], notes
    notes.append(f"The file names no columns; they are counted from 0 to {layout.width - 1}.")
    return [f"column {k}" for k in range(layout.width)], [""] * layout.width, notes


def _other_lines(head: list[Line]) -> list[str]:
    return [f"Header line {number}: {text.strip()}" for number, text in head]


def _columns(body: list[Line], layout: _Layout, names: list[str]) -> tuple[list[FloatArray], list[str]]:
    texts = [text for _, text in body]
    if layout.decimal == ",":
        texts = [text.replace(",", ".") for text in texts]
    delimiter = None if layout.separator == " " else layout.separator
    try:
        # The fast way; it knows no empty cells and no text.
        table = np.loadtxt(texts, delimiter=delimiter, comments=None, quotechar='"', ndmin=2)
    except ValueError:
        return _columns_cell_by_cell(body, layout, names)
    if table.shape[1] != layout.width:
        return _columns_cell_by_cell(body, layout, names)
    return [np.ascontiguousarray(column) for column in table.T], []


def _columns_cell_by_cell(body: list[Line], layout: _Layout, names: list[str]) -> tuple[list[FloatArray], list[str]]:
    rows = [(number, layout.cells(text)) for number, text in body]
    notes = []
    if len(rows) > 1 and len(rows[-1][1]) != layout.width:
        notes.append(f"The last line, {rows.pop()[0]}, is cut off; it was left out.")
    for number, cells in rows:
        if len(cells) != layout.width:
            reason = f"do not fit the {layout.width} columns."
            raise InputError(f"{len(cells)} cells", reason, "Give one cell per column.", line=number)
    columns = [
        _column([(number, cells[k]) for number, cells in rows], layout, names[k], notes) for k in range(layout.width)
    ]
    return columns, notes


def _column(cells: list[Line], layout: _Layout, name: str, notes: list[str]) -> FloatArray:
    bad = [line for line in cells if not layout.is_number(line[1]) and line[1].lower() not in _EMPTY]
    if len(bad) > 0.5 * len(cells):
        notes.append(f'Column "{name}" holds text such as "{bad[0][1]}"; it is left empty.')
        return np.full(len(cells), np.nan)
    if bad:
        number, cell = bad[0]
        given = f'cell "{cell}" of column "{name}"'
        cure = "Correct it, or leave the cell empty where nothing was measured."
        raise InputError(given, "is not a number.", cure, line=number)
    return np.array([float(_plain(text)) if layout.is_number(text) else np.nan for _, text in cells])


def _plain(cell: str) -> str:
    return cell.replace(",", ".").replace("d", "e").replace("D", "e")
