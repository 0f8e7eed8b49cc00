"""Results and errors as values of JSON: numbers with units, notes with codes, lists of limited length."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from poppet.assist.folder import Folder
from poppet.assist.limits import LIST_ROWS
from poppet.core.codes import Note
from poppet.core.errors import InputError, PoppetError, SimulationError
from poppet.core.note_groups import code_of, grouped

Json = dict[str, Any]
DIGITS = 10
"""Significant digits of numbers in results."""
ENDED = "assist.ended"
"""Code of an error that has no code of its own, for example a run that failed."""


def quantity(value: float, unit: str) -> Json:
    """Return a number with its unit.

    Examples
    --------
    >>> quantity(0.1 + 0.2, "bar")
    {'value': 0.3, 'unit': 'bar'}
    """
    return {"value": number(value), "unit": unit or "1"}


def number(value: float) -> float | str | None:
    """Return a number with 10 digits; NaN is None, and infinite values are the texts "inf" and "-inf"."""
    value = float(value)
    if math.isnan(value):
        return None
    return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else ("inf" if value > 0.0 else "-inf")


def plain(value: Any) -> Any:
    """Return a value with the types of JSON only; the end of long lists is omitted, and their length is stated."""
    if isinstance(value, Mapping):
        content: Json = {}
        for key, inner in value.items():
            content[str(key)] = plain(inner)
            if isinstance(inner, list | tuple) and len(inner) > LIST_ROWS:
                content[f"{key}_count"] = len(inner)
        return content
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, list | tuple | set | frozenset):
        return [plain(inner) for inner in list(value)[:LIST_ROWS]]
    if isinstance(value, Note):
        return note_row(value)
    if isinstance(value, bool) or value is None:
        return value
    if isinstance(value, int | float):
        return value if isinstance(value, int) else number(value)
    return str(value)


def note_row(note: Note) -> Json:
    """Return a note with its code, address and text."""
    return {"code": code_of(note), "address": note.address, "text": str(note)}


def note_rows(notes: Iterable[Note]) -> list[Json]:
    """Return notes with their codes; similar notes are combined."""
    return [note_row(note) for note in grouped(notes)][:LIST_ROWS]


def error_rows(error: PoppetError, folder: Folder | None = None) -> list[Json]:
    """Return all errors with code, address, message and hint; paths are relative to the folder."""
    show = folder.shown if folder is not None else str
    if isinstance(error, InputError):
        return [_error_row(problem, show) for problem in error.problems]
    if isinstance(error, SimulationError):
        return [{"code": error.note.code, "address": error.note.address, "message": show(str(error)), "hint": ""}]
    return [{"code": ENDED, "address": "", "message": show(str(error)), "hint": ""}]


def _error_row(problem: InputError, show: Any) -> Json:
    # An error of a whole file, such as invalid syntax, has no address in it.
    row: Json = {"code": problem.code, "address": show(problem.address or problem.file or "")}
    if problem.file:
        row["file"] = show(problem.file)
    if problem.line is not None:
        row["line"] = problem.line
    return row | {"message": show(f"{problem.given} {problem.reason}".strip()), "hint": show(problem.hint)}
