"""Readers of tables in text files.

`read` accepts files of other programs and adds a note on each guess. `read_exact` accepts only the format of poppet
recordings. Its error messages contain the line number.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from poppet.core.codes import Note
from poppet.core.csv_cells import unmarked_text
from poppet.core.errors import InputError
from poppet.core.files import open_input
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.tables.table import Table, heading_of, unit_of
from poppet.timeseries.tables.time_stamps import CONVERTED, convert_stamps

_NUMBER = {
    ".": re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][+-]?\d+)?|[+-]?inf(?:inity)?", re.IGNORECASE),
    ",": re.compile(r"[+-]?(?:\d+(?:,\d+)?|,\d+)(?:[eEdD][+-]?\d+)?|[+-]?inf(?:inity)?", re.IGNORECASE),
}
# Recordings can contain infinite values; NaN is an empty cell.
_EMPTY = frozenset({"", "nan", "na", "n/a", "null", "none", "-", "--", "---"})
_SEPARATORS = ("\t", ";", ",", " ")
_WORDS = {"tab": "\t", "\\t": "\t", "space": " ", "spaces": " ", "comma": ",", "semicolon": ";"}
_SAID = {"\t": "tabs", " ": "spaces", ",": "commas", ";": "semicolons"}
# Numbers of lines for guessing the layout: the last ones, which contain samples, and some before them.
_LAST, _BETWEEN = 60, 200

LARGEST_TEXT = 256 * 2**20  # limit of the size of a text file [bytes]; reading needs ten times as much memory

_OPEN = re.compile(r'(?:^|[,;\t])\s*"(?:[^"]|"")*+$')
_CLOSE = re.compile(r'(?:[^"]|"")*+"\s*(?:[,;\t]|$)')
_QUOTED_COMMA = re.compile(r'"\s*[+-]?\d*,\d+(?:[eEdD][+-]?\d+)?\s*"')
_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2}\.\d{3}")
_BELOW_THOUSAND = re.compile(r"[+-]?\d{1,3}")
_THOUSANDS_OR_LESS = re.compile(f"{_THOUSANDS.pattern}|{_BELOW_THOUSAND.pattern}")
_JUMP = 100.0  # between neighbouring values; above it, the points separate thousands and the jump is below 10
_MAX_JOINED = 20  # maximum number of newlines in a cell

Line = tuple[int, str]  # line number in the file, counted from 1, and text of the line


@dataclass(frozen=True)
class _TextLayout:
    separator: str
    decimal: str
    width: int = 0
    is_numeric: tuple[bool, ...] = ()

    def cells(self, text: str) -> list[str]:
        if self.separator == " ":
            return text.split()
        lines = io.StringIO(text, newline="") if "\n" in text else [text]
        return [cell.strip() for cell in next(csv.reader(lines, delimiter=self.separator), [])]

    def is_number(self, cell: str) -> bool:
        return _NUMBER[self.decimal].fullmatch(cell) is not None

    def has_number(self, text: str) -> bool:
        return any(map(self.is_number, self.cells(text)))

    def is_sample(self, text: str) -> bool:
        """Return True if a line contains a sample, and False for a heading.

        A line with the right number of cells is a sample if its first cell is a number. Otherwise, all cells of numeric
        columns must be numbers or empty.
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
    """Read the columns of a text file.

    The keywords `separator`, `decimal` and `header_rows` describe the file. Those that are None are detected, and notes
    report the result.
    """
    text, bad_line = _decoded_text(path)
    notes = [Note("table.latin_1")] if bad_line else []
    lines = _lines(text)
    comments = [line for line in lines if line[1].lstrip().startswith("#")]
    rest_lines = [line for line in lines if not line[1].lstrip().startswith("#")]
    if not rest_lines:
        raise InputError("table.empty")
    rest_lines, first_stamp = convert_stamps(rest_lines)
    if decimal not in (None, ".", ","):
        raise InputError("table.decimal", "decimal", value=decimal)
    separators: Sequence[str] = _SEPARATORS
    if separator is not None:
        separators = [_WORDS.get(separator.strip().lower(), separator)]
        if len(separators[0]) != 1:
            raise InputError("table.separator", "separator", value=separator)
    layout = _guess_layout(rest_lines, separators, (".", ",") if decimal is None else (decimal,))
    if header_rows is not None and (isinstance(header_rows, bool) or header_rows < 0):
        raise InputError("table.header_rows", "header_rows", value=header_rows)
    if header_rows is None:
        first = next((k for k, (_, line) in enumerate(rest_lines) if layout.is_sample(line)), None)
    else:
        first = next((k for k, (number, _) in enumerate(rest_lines) if number > header_rows), None)
        # Headings after the given number of lines are also header lines.
        while first is not None and first < len(rest_lines) and not layout.has_number(rest_lines[first][1]):
            first += 1
    if first is None or first == len(rest_lines):
        raise InputError("table.no_samples")
    head, body = rest_lines[:first], rest_lines[first:]
    names, units, heading_notes = _column_headings(head, comments, layout, body)
    if separator is None or decimal is None:
        separator_name = _SAID.get(layout.separator, repr(layout.separator))
        notes.append(Note("table.guessed", separator=separator_name, decimal=layout.decimal))
    notes += heading_notes + [Note("table.comment", text=comment.lstrip("# \t")) for _, comment in comments]
    columns, cell_notes = _columns(body, layout, names)
    if decimal is None and layout.decimal == ".":
        _reject_thousands(body, layout, names, columns)
    if len(names) > 1 and names[-1] == "" and not np.isfinite(columns[-1]).any():
        names, units, columns = names[:-1], units[:-1], columns[:-1]  # each line ends with a separator
    names = [name or f"column {k}" for k, name in enumerate(names)]
    numbered = [number for number, _ in body]
    if first_stamp:
        cells = layout.cells(body[0][1])
        stamped = next((k for k, cell in enumerate(cells) if CONVERTED.fullmatch(cell)), None)
        if stamped is not None and stamped < len(names):
            units = [*units[:stamped], "s", *units[stamped + 1 :]]
            notes.append(Note("table.time_stamps", column=names[stamped], first=first_stamp))
    return Table(tuple(names), tuple(columns), tuple(units), (*notes, *cell_notes), lines=numbered)


def read_exact(path: Path) -> Table:
    """Read a CSV file that poppet has written, without guessing its layout.

    The file is UTF-8, with a heading line and a number in each cell. The names in the table are the complete headings
    with their units.
    """
    text, bad_line = _decoded_text(path)
    if bad_line:
        raise InputError("table.not_utf_8", line=bad_line)
    lines = _lines(text)
    if len(lines) < 2:
        raise InputError("table.no_samples" if lines else "table.empty")
    layout = _TextLayout(",", ".")
    (first, heading), body = lines[0], lines[1:]
    names = [unmarked_text(cell) for cell in layout.cells(heading)]
    if len(names) == 1 and ";" in names[0]:
        raise InputError("table.semicolons", line=first)
    table = _all_numbers([text for _, text in body], ",", len(names))
    if table is None:
        rows = [(number, layout.cells(text)) for number, text in body]
        _reject_widths(rows, len(names))
        for number, cells in rows:
            for name, cell in zip(names, cells, strict=True):
                # The Fortran form 1.5d3 is not valid here.
                if "d" in cell.lower() or not (layout.is_number(cell) or cell.lower() == "nan"):
                    raise InputError("table.cell_of_recording", cell=cell, column=name, line=number)
        raise InputError("table.not_numbers")
    return Table(tuple(names), tuple(table), ("",) * len(names), lines=[number for number, _ in body])


def _decoded_text(path: Path) -> tuple[str, int]:
    """Return the text of a file, and the number of its first line that is not UTF-8.

    The number is 0 if the whole file is UTF-8 or UTF-16. Otherwise the text is decoded as Latin-1.
    """
    with open_input(path) as file:
        content = file.read(LARGEST_TEXT + 1)
    if len(content) > LARGEST_TEXT:
        raise InputError("table.too_large", most=LARGEST_TEXT // 2**20)
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return content.decode("utf-16", errors="replace"), 0
    if b"\0" in content:
        raise InputError("table.binary")
    try:
        return content.decode("utf-8-sig"), 0
    except UnicodeDecodeError as problem:
        # Latin-1 decodes every byte, including the degree signs of older instruments.
        return content.decode("latin-1"), content.count(b"\n", 0, problem.start) + 1


def _lines(text: str) -> list[Line]:
    ends = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    lines = [(k, line) for k, line in enumerate(ends, start=1) if line.strip()]
    return _joined(lines) if '"' in text else lines


def _joined(lines: list[Line]) -> list[Line]:
    """Join lines that belong to one quoted cell, because the cell contains newlines.

    A quote without a closing quote in the next lines, such as an inch sign, is unchanged.
    """
    joined: list[Line] = []
    k = 0
    while k < len(lines):
        number, line = lines[k]
        k += 1
        if line.count('"') % 2 and _OPEN.search(line):
            for j, (_, following) in enumerate(lines[k : k + _MAX_JOINED], start=k + 1):
                if following.count('"') % 2:
                    if _CLOSE.match(following):
                        line, k = "\n".join([line, *(text for _, text in lines[k:j])]), j
                    break
        joined.append((number, line))
    return joined


def _guess_layout(lines: Sequence[Line], separators: Sequence[str], decimals: Sequence[str]) -> _TextLayout:
    """Return the column separator and decimal sign with which most cells are numbers.

    `separators` and `decimals` contain the candidates. If several pairs are equally good, the pair that gives the most
    columns is returned.
    """
    sample = [text for _, text in (*lines[:: 1 + len(lines) // _BETWEEN], *lines[-_LAST:])]
    has_quoted_commas = any(_QUOTED_COMMA.search(text) for text in sample)
    choices = [(s, d) for s in separators for d in decimals if s != d or (s == "," and has_quoted_commas)]
    if not choices:
        raise InputError("table.same_sign", "separator", sign=separators[0])
    best_score, best_layout = (False, 0.0, 0), None
    for choice in choices:
        layout = _TextLayout(*choice)
        rows = [layout.cells(text) for text in sample]
        with_numbers = [row for row in rows if any(layout.is_number(cell) for cell in row)]
        if not with_numbers:
            continue
        widths = [len(row) for row in with_numbers]
        width = max(sorted(set(widths)), key=widths.count)
        fitting = [row for row in with_numbers if len(row) == width]
        numbers = [sum(layout.is_number(row[k]) for row in fitting) for k in range(width)]
        empty = [sum(row[k].lower() in _EMPTY for row in fitting) for k in range(width)]
        is_numeric = tuple(n >= 0.5 * (len(fitting) - e) for n, e in zip(numbers, empty, strict=True))
        share = (sum(numbers) + sum(empty)) / (width * len(fitting)) * len(fitting) / len(rows)
        # A single column, which has no time, is the last choice. Rounding ignores differences of a few cells.
        score = (width > 1 and share >= 0.5, round(share, 2), width)
        if score > best_score:
            best_score, best_layout = score, _TextLayout(*choice, width, is_numeric)
    if best_layout is None or best_score[1] == 0.0:
        raise InputError("table.no_lines_of_numbers")
    return best_layout


def _column_headings(
    head: list[Line], comments: list[Line], layout: _TextLayout, body: list[Line]
) -> tuple[list[str], list[str], list[Note]]:
    """Return the names and the units of all columns, with notes.

    The names are in the last line above the values, `body`. If this line contains only units, the names are in the line
    above it. Without headings, the names come from a comment or are `column 0` and so on.
    """
    rows = [layout.cells(text) for _, text in head]
    units = [unit_of(cell.strip("[]()")) for cell in rows[-1]] if len(rows) > 1 else []
    guessed = []
    if len(units) == layout.width == len(rows[-2]) and all(
        unit or not cell for unit, cell in zip(units, rows[-1], strict=True)
    ):
        cells, head = rows[-2], head[:-2]
    elif rows and (len(rows[-1]) == layout.width or len(rows[-1]) == layout.width - 1 > 1):
        # With one heading less than columns, each line of numbers ends with a separator.
        cells, head, units = rows[-1] + [""] * (layout.width - len(rows[-1])), head[:-1], []
    else:
        comments_above = [text for number, text in comments if number < body[0][0]]
        cells, units = layout.cells(comments_above[-1].lstrip("# \t")) if comments_above else [], []
        guessed = [Note("table.headings_of_comment")]
        if len(cells) != layout.width:
            cells = [f"column {k}" for k in range(layout.width)]
            guessed = [Note("table.no_headings", last=layout.width - 1)]
    headings = [heading_of(unmarked_text(cell)) for cell in cells]
    notes = [Note("table.header_line", number=number, text=text.strip()) for number, text in head]
    return [name for name, _ in headings], units or [unit for _, unit in headings], notes + guessed


def _columns(body: list[Line], layout: _TextLayout, names: list[str]) -> tuple[list[FloatArray], list[Note]]:
    texts = [text for _, text in body]
    has_points = layout.decimal == "," and any("." in text for text in texts)  # between thousands: no numbers
    if layout.decimal == "," != layout.separator:
        texts = [text.replace(",", ".") for text in texts]
    separator = None if layout.separator == " " else layout.separator
    is_exact = not has_points and layout.decimal != layout.separator
    table = _all_numbers(texts, separator, layout.width) if is_exact else None
    if table is not None:
        return [np.ascontiguousarray(column) for column in table], []
    rows = [(number, layout.cells(text)) for number, text in body]
    notes = []
    if len(rows) > 1 and len(rows[-1][1]) != layout.width:
        notes.append(Note("table.cut_off", number=rows.pop()[0]))
    _reject_widths(rows, layout.width)
    columns = [
        _column([(number, cells[k]) for number, cells in rows], layout, names[k], notes) for k in range(layout.width)
    ]
    return columns, notes


def _reject_thousands(body: list[Line], layout: _TextLayout, names: list[str], columns: list[FloatArray]) -> None:
    """Raise an error if the points of a column seem to separate thousands.

    All numbers of such a column are integers below 1000 or have three digits behind a point. Between both forms, a
    value jumps by more than a factor of 100.
    """
    for k, column in enumerate(columns):
        sizes = np.abs(column)
        with np.errstate(invalid="ignore"):
            is_jump = np.maximum(sizes[1:], sizes[:-1]) > _JUMP * np.minimum(sizes[1:], sizes[:-1])
            jumps = np.flatnonzero(is_jump & (np.minimum(sizes[1:], sizes[:-1]) > 0.0))
        for row in jumps.tolist():
            pair = [(number, layout.cells(text)[k]) for number, text in body[row : row + 2]]
            n_pointed = sum(_THOUSANDS.fullmatch(cell) is not None for _, cell in pair)
            if n_pointed + sum(_BELOW_THOUSAND.fullmatch(cell) is not None for _, cell in pair) < 2:
                break
            if n_pointed == 1:
                cells = [layout.cells(text)[k] for _, text in body[: len(column)]]
                if all(_THOUSANDS_OR_LESS.fullmatch(cell) or cell.lower() in _EMPTY for cell in cells):
                    (first, before), (_, after) = pair
                    raise InputError("table.thousands", column=names[k], before=before, after=after, line=first)
                break


def _all_numbers(texts: list[str], delimiter: str | None, width: int) -> FloatArray | None:
    """Convert lines that contain only numbers to an array of the columns, (width, n_lines).

    This fast function is tried first. The result is None if a cell is empty or is not a number, or if a line does not
    have `width` cells.
    """
    try:
        table = np.loadtxt(texts, delimiter=delimiter, comments=None, quotechar='"', ndmin=2)
    except ValueError:
        return None
    return table.T if table.shape[1] == width else None


def _reject_widths(rows: list[tuple[int, list[str]]], width: int) -> None:
    for line, cells in rows:
        if len(cells) != width:
            raise InputError("table.cells", cells=len(cells), columns=width, line=line)


def _column(cells: list[Line], layout: _TextLayout, name: str, notes: list[Note]) -> FloatArray:
    invalid = [line for line in cells if not layout.is_number(line[1]) and line[1].lower() not in _EMPTY]
    if len(invalid) > 0.5 * len(cells):
        notes.append(Note("table.column_of_text", column=name, cell=invalid[0][1]))
        return np.full(len(cells), np.nan)
    if invalid:
        number, cell = invalid[0]
        raise InputError("table.cell", cell=cell, column=name, line=number)
    # Fortran can write 1.5d3.
    translation = str.maketrans({",": ".", "d": "e", "D": "e"})
    return np.array([float(text.translate(translation)) if layout.is_number(text) else np.nan for _, text in cells])
