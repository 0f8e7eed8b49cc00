"""Interpretation of the columns of a recording: time, units, and gauge or absolute pressures.

A fact that the file does not state is a question, and never a guess.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.units import convert, quantity, same_dimension, stated_reference
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.tables.table import Table, heading_of, unit_of
from poppet.timeseries.tables.time_stamps import is_serial

Origin = Literal["file", "option", "answer", "assumed"]
"""Source of a statement: the file, an option, an answer of the user, or an assumption."""
SERIAL = "Excel days"
"""Unit of a time column with day numbers of Excel."""
TIME_UNITS, PRESSURE_UNITS = ("s", "ms", "min"), ("bar", "mbar", "kPa", "Pa", "psi")
"""Units that a question offers; others can be written."""
REFERENCES = ("gauge", "absolute")
_COLUMN_UNITS = {"time": TIME_UNITS, "temperature": ("degC", "K"), "ambient_temperature": ("degC", "K")}
"""Units that an error on the unit of a column lists, by key; those of pressures for the other keys."""
_NAME_AND_UNIT = re.compile(r"(?P<name>.+?)\s*(?:\[(?P<square>[^\]]*)\]|\((?P<round>[^)]*)\))\s*")
_TIMES = ("time", "t", "zeit", "uhrzeit", "timestamp", "zeitstempel", "elapsed")
_PRESSURES = ("p", "pressure", "druck", "tank", "kessel", "behälter", "behaelter", "vessel", "chamber")
_OTHER_PRESSURES = re.compile(
    r"supply|netz|versorgung|vordruck|ambient|umgebung|barom|luftdruck|atmos|differen|\b_?(?:dp|delta|diff|baro|atm)(?:\b|_)"
)
"""Parts of lower-case headings of pressures that are not that of the tank."""
_GAUGE = ("gauge", "gage", "rel", "relativ", "relative", "überdruck", "ueberdruck")
_ABSOLUTE = ("abs", "absolute", "absolut", "absolutdruck")


class UserStatement(NamedTuple):
    """Text of an option or an answer, and its source."""

    text: str
    origin: Origin


Statements = Mapping[str, UserStatement]


@dataclass(frozen=True)
class Question:
    """Fact that neither the file nor the user has stated."""

    key: str  # of the statement that answers it: `time`, `pressure_unit`, `volume`
    note: Note  # text of the question
    choices: tuple[str, ...] = ()  # empty: any text
    default: str = ""  # value after Enter on a terminal; only for a fact that a fit can also estimate
    is_closed: bool = False  # True if other texts than the choices are invalid


@dataclass(frozen=True, eq=False)
class RecordedColumn:
    """Column of a recording with its unit; the unit is empty while a question is open."""

    index: int
    name: str
    values: FloatArray  # (n,), as in the file
    unit: str  # complete: `ms`, `bar g`
    column_origin: Origin
    unit_origin: Origin
    questions: tuple[Question, ...] = ()

    @property
    def origins(self) -> tuple[Origin, ...]:
        """Sources of column and unit, without repetition."""
        return tuple(dict.fromkeys((self.column_origin, self.unit_origin)))


def find_column(table: Table, text: str, key: str) -> tuple[int, str]:
    """Return the index of a column and the unit that a statement such as `p_tank [bar g]` contains.

    The unit is empty if the statement contains none. A column that does not exist is an error with the address `key`.
    """
    name, unit = (text, "") if text in table.names else heading_of(text)
    if name.isascii() and name.isdigit() and name not in table.names:
        name_or_index: str | int = int(name)
    else:
        name_or_index = name
    try:
        index = table.index(name_or_index)
    except InputError as error:
        written = _NAME_AND_UNIT.fullmatch(text)
        if written and written["name"] in table.names:
            unit, units = written["square"] or written["round"] or "", _COLUMN_UNITS.get(key, PRESSURE_UNITS)
            raise InputError("question.column_unit", key, value=text, unit=unit, units=units) from None
        raise error.at(key) from None
    if not np.isfinite(table.columns[index]).any():
        raise InputError("measured.empty_column", key, value=text)
    return index, unit


def read_time(table: Table, statements: Statements) -> RecordedColumn | Question:
    """Return the column of the time with its unit, or the question which column it is.

    The column is the only one with a unit of time or a usual name whose values do not decrease. If there are several,
    it is the only one with both. `statements` can have the keys `time` and `time_unit`.
    """
    origin: Origin = "file"
    stated_unit = ""
    if statement := statements.get("time"):
        index, stated_unit = find_column(table, statement.text, "time")
        origin = statement.origin
    else:
        by_unit = [k for k, unit in enumerate(table.units) if unit and same_dimension(unit, "s")]
        by_name = [k for k, name in enumerate(table.names) if _words(name) & {*_TIMES}]
        by_either = [k for k in _filled(table) if k in by_unit or (k in by_name and not table.units[k])]
        by_either = [k for k in by_either if _is_course_of_time(table.columns[k])] or by_either
        candidates = [k for k in by_either if k in by_unit and k in by_name]
        candidates = candidates if len(by_either) > 1 and len(candidates) == 1 else by_either
        if len(candidates) != 1:
            names = tuple(table.names[k] for k in candidates or _filled(table))
            return Question("time", Note("question.time", names=names), names)
        (index,) = candidates
    name, values = table.names[index], table.columns[index]
    unit, unit_origin = _unit(table, index, "s", stated_unit, statements.get("time_unit"), origin)
    if unit and unit != SERIAL:
        convert(0.0, unit, "s")  # another quantity is an error
    questions: tuple[Question, ...] = ()
    if not unit:
        span = float(np.nanmax(values) - np.nanmin(values))
        choices = (*TIME_UNITS, SERIAL) if is_serial(values) else TIME_UNITS
        durations = {each: convert(span, each, "s") for each in TIME_UNITS}
        note = Note("question.time_unit", column=name, span=span, samples=int(values.size), durations=durations)
        questions = (Question("time_unit", note, choices),)
    return RecordedColumn(index, name, values, unit, origin, unit_origin, questions)


def find_pressure(table: Table, time: int | None, statements: Statements) -> tuple[int, Origin, str] | Question:
    """Return index, source and stated unit of the column of the tank pressure, or the question which column it is."""
    if statement := statements.get("pressure"):
        index, unit = find_column(table, statement.text, "pressure")
        return index, statement.origin, unit
    others = [k for k in _filled(table) if k != time]
    units = {k: table.units[k] or _unit_in_name(table.names[k], "Pa") for k in others}
    by_unit = [k for k in others if units[k] and same_dimension(units[k], "Pa")]
    without_unit = [k for k in others if not units[k]]
    by_name = [k for k in sorted(by_unit + without_unit) if _words(table.names[k]) & {*_PRESSURES}]
    # A unit alone decides only if no other column has the name of a pressure.
    candidates = by_unit if len(by_unit) == 1 and {*by_name} <= {*by_unit} else by_name
    if len(candidates) == 1 and not _OTHER_PRESSURES.search(table.names[candidates[0]].lower()):
        return candidates[0], "file", ""
    if not others:
        raise InputError("question.no_numbers", "pressure")
    names = tuple(table.names[k] for k in (candidates if len(candidates) > 1 else by_unit + without_unit or others))
    return Question("pressure", Note("question.pressure", names=names), names)


def read_pressure(table: Table, index: int, origin: Origin, stated_unit: str, statements: Statements) -> RecordedColumn:
    """Return a column of pressures with its unit and reference.

    The unit and the words of the heading can state both; otherwise, the column has the questions `pressure_unit` and
    `reference`. `statements` can have these keys.
    """
    name, values = table.names[index], table.columns[index]
    unit, unit_origin = _unit(table, index, "Pa", stated_unit, statements.get("pressure_unit"), origin)
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    questions: list[Question] = []
    if unit:
        quantity(f"1 {unit}", "Pa", kind="pressure", name="pressure_unit")  # another quantity is an error
    else:
        note = Note("question.pressure_unit", column=name, low=low, high=high)
        questions.append(Question("pressure_unit", note, PRESSURE_UNITS))
    reference = stated_reference(unit) if unit else ""
    statement = statements.get("reference")
    stated = _stated_option(statement.text, REFERENCES, "reference") if statement else ""
    in_heading = _reference_in_heading(name)
    if unit_origin == "file" and reference and in_heading and in_heading != reference:
        raise InputError("question.two_references", "pressure", column=name, unit=unit)
    if not reference and in_heading:
        reference, unit = in_heading, f"{unit} {in_heading[0]}" if unit else ""
    if statement and reference and stated != reference:
        raise InputError("question.reference_twice", "reference", value=statement.text, unit=unit or name)
    if not reference and statement:
        unit, reference = (f"{unit} {stated[0]}" if unit else ""), stated
        unit_origin = statement.origin if unit_origin == "file" else unit_origin
    if not reference:
        note = Note("question.reference", column=name, low=low, high=high, unit=unit)
        questions.append(Question("reference", note, REFERENCES, is_closed=True))
        unit = ""
    return RecordedColumn(index, name, values, unit, origin, unit_origin, tuple(questions))


def _stated_option(text: str, options: tuple[str, ...], key: str) -> str:
    """Return the option that a text states, by its name or its first letters."""
    matches = [option for option in options if text and option.startswith(text.lower())]
    if len(matches) != 1:
        raise InputError("fields.not_an_option", key, value=text, meaning=key, suggestion=NameSuggestion(text, options))
    return matches[0]


def _unit(
    table: Table, index: int, si: str, stated: str, statement: UserStatement | None, origin: Origin
) -> tuple[str, Origin]:
    """Return the unit of a column and its source; the unit is empty if nothing states it."""
    if statement:
        return (statement.text if statement.text == SERIAL else unit_of(statement.text) or statement.text), (
            statement.origin
        )
    if stated:
        return stated, origin
    written = table.units[index] or _unit_in_name(table.names[index], si)
    return written, "file"


def _unit_in_name(name: str, si: str) -> str:
    """Return the unit at the end of a name such as `t_ms` or `p_tank_bar`, if it belongs to the quantity `si`.

    Examples
    --------
    >>> _unit_in_name("t_ms", "s"), _unit_in_name("p_tank_bar", "Pa"), _unit_in_name("p_s", "Pa")
    ('ms', 'bar', '')
    >>> _unit_in_name("p_bar_abs", "Pa")
    'bar a'
    """
    words = name.split("_")
    units = (unit_of("_".join(words[-count:])) for count in (2, 1) if len(words) > count)
    return next((unit for unit in units if unit and same_dimension(unit, si)), "")


def _is_course_of_time(values: FloatArray) -> bool:
    """Return True if the values of a column increase and never decrease."""
    steps = np.diff(values[np.isfinite(values)])
    return bool(steps.size and steps.min() >= 0.0 and steps.max() > 0.0)


def _reference_in_heading(name: str) -> str:
    words = _words(name)
    is_gauge, is_absolute = bool(words & {*_GAUGE}), bool(words & {*_ABSOLUTE})
    return "" if is_gauge == is_absolute else "gauge" if is_gauge else "absolute"


def _words(name: str) -> set[str]:
    return {word for word in re.split(r"[\W_\d]+", name.lower()) if word}


def _filled(table: Table) -> Sequence[int]:
    """Return the indices of the columns that contain numbers."""
    return [k for k, column in enumerate(table.columns) if np.isfinite(column).any()]
