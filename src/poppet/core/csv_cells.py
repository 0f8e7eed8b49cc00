"""Texts in CSV files, which a spreadsheet must not execute as formulas."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Sequence
from typing import Any

_FORMULA = re.compile(r"'*[=+\-@\t\r]")
_MARKED = re.compile(r"'+[=+\-@\t\r]")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?(?:inf|nan)|-*", re.IGNORECASE)


def safe_text(text: str) -> str:
    r"""Return the text of a CSV cell, protected from execution as a spreadsheet formula.

    An apostrophe is added in front of a text that a spreadsheet would read as a formula. Numbers and dashes are
    unchanged. `unmarked_text` removes the apostrophe.

    Examples
    --------
    >>> safe_text("=HYPERLINK(1)"), safe_text("-0.5"), safe_text("tank.pressure [Pa]")
    ("'=HYPERLINK(1)", '-0.5', 'tank.pressure [Pa]')
    """
    return f"'{text}" if _FORMULA.match(text) and not _NUMBER.fullmatch(text) else text


def unmarked_text(text: str) -> str:
    """Return the text of a CSV cell without the apostrophe that `safe_text` has added."""
    return text[1:] if _MARKED.match(text) else text


def csv_text(rows: Iterable[Sequence[Any]]) -> str:
    """Return rows of cells as CSV text.

    Cells with commas, quotes or newlines are quoted. Formulas are protected by an apostrophe.

    Examples
    --------
    >>> print(csv_text([["a,b", "=c"], [1.5, -2]]), end="")
    "a,b",'=c
    1.5,-2
    """
    stream = io.StringIO()
    plain = csv.writer(stream, lineterminator="\n")
    # The usual writer does not quote a carriage return.
    quoting = csv.writer(stream, lineterminator="\n", quoting=csv.QUOTE_NONNUMERIC)
    for row in rows:
        cells = [safe_text(cell) if isinstance(cell, str) else cell for cell in row]
        has_return = any("\r" in cell for cell in cells if isinstance(cell, str))
        (quoting if has_return else plain).writerow(cells)
    return stream.getvalue()
