"""Table of numeric columns from a file of any format, and units in the spelling of instruments."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.units import is_known, same_dimension
from poppet.timeseries.checks import FloatArray

_TRAILING_UNIT = re.compile(r"\s*(?P<name>.*?\S)\s*(?:\[(?P<square>[^\[\]]*)\]|\((?P<round>[^()]*)\))\s*")
_UNIT_AFTER_IN = re.compile(
    r"\s*(?P<name>.*?\S)(?: +in +|(?P<stroke> +/ +|(?<=\b[pt])/))(?P<unit>\S+(?: ?/ ?\S+)?(?: \S+)?)\s*"
)
"""Heading with a unit after "in" or a stroke (DIN 461): `p in bar`, `Druck / mbar`, `t/s`."""
_TIME_BEFORE_STROKE = re.compile(r"(?:.*\W)?(?:t|time|zeit|uhrzeit|elapsed|dauer|duration)", re.IGNORECASE)
"""Name before a stroke and a unit of time; after other names, such as in `strokes / min`, the text can be a rate."""

# Unit spellings of instruments and loggers, in lower case. Other spellings must be those of poppet.
_SPELLINGS = {
    **dict.fromkeys(("sec", "secs", "second", "seconds", "sek", "sek.", "sekunden"), "s"),
    **dict.fromkeys(("msec", "milliseconds"), "ms"),
    "minutes": "min",
    "hours": "h",
    "psi": "psi",
    "psig": "psi g",
    "psia": "psi a",
    "mbar": "mbar",
    "in hg": "inHg",
    **dict.fromkeys(("c", "deg c", "celsius"), "degC"),
    **dict.fromkeys(("f", "deg f"), "degF"),
    "kelvin": "K",
    "lpm": "l/min",
    "slpm": "l/min N",
    "volts": "V",
}
_GAUGE, _ABSOLUTE = ("g", "ü", "ue", "rel", "rel.", "relativ", "relative"), ("a", "abs", "abs.", "absolut")
_WITH_REFERENCE = re.compile(
    r"(?P<unit>[kMmh]?bar|[kMh]?Pa|psi)[ _]*\(?(?P<reference>" + "|".join(map(re.escape, _GAUGE + _ABSOLUTE)) + r")\)?",
    re.IGNORECASE,
)
"""Pressure unit with the reference in the spelling of loggers, such as `bar_rel` or `bar ü`."""


def unit_of(spelling: str) -> str:
    """Convert the spelling of a unit by an instrument, such as `PSI`, to the spelling of poppet.

    The result is empty if the text is not a unit.

    Examples
    --------
    >>> unit_of("PSI"), unit_of("Deg C"), unit_of("g/min"), unit_of("bar_rel"), unit_of("filtered")
    ('psi', 'degC', 'g/min', 'bar g', '')
    """
    text = spelling.strip()
    if match := _WITH_REFERENCE.fullmatch(text):
        unit = match["unit"] if is_known(match["unit"]) else match["unit"].lower()
        return f"{unit} {'g' if match['reference'].lower() in _GAUGE else 'a'}" if is_known(unit) else ""
    unit = _SPELLINGS.get(" ".join(text.lower().replace("°", "deg ").split()))
    if unit:
        return unit
    return text if text and is_known(text) else ""


def heading_of(text: str) -> tuple[str, str]:
    """Split the heading of a column into name and unit.

    The unit is empty if the heading contains none.

    Examples
    --------
    >>> heading_of("P1(PSI)"), heading_of("flow (filtered)"), heading_of("p in bar")
    (('P1', 'psi'), ('flow (filtered)', ''), ('p', 'bar'))
    """
    match = _TRAILING_UNIT.fullmatch(text)
    if match:
        written = match["square"] if match["square"] is not None else match["round"]
        # `(1)` is a sensor number; `[1]` is the unit of a dimensionless series in a recording.
        unit = unit_of(written) if match["square"] is not None or not written.strip().isdigit() else ""
        if unit or not written.strip():
            return match["name"], unit
    written_out = _UNIT_AFTER_IN.fullmatch(text)
    if written_out and (unit := unit_of(written_out["unit"].replace(" /", "/").replace("/ ", "/"))):
        is_rate = written_out["stroke"] and same_dimension(unit, "s")
        if not is_rate or _TIME_BEFORE_STROKE.fullmatch(written_out["name"]):
            return written_out["name"], unit
    return text.strip(), ""


@dataclass(frozen=True, eq=False)
class Table:
    """Numeric columns of a data file, with names, units and notes."""

    names: tuple[str, ...]  # without units; `column 0` and so on if the file has no names
    columns: tuple[FloatArray, ...]  # each (n,), in its unit; NaN for an empty cell
    units: tuple[str, ...]  # from the heading; empty if it has no unit
    notes: tuple[Note, ...] = ()  # guesses and omitted content
    meta: Mapping[str, Any] = field(default_factory=dict)  # metadata of a poppet recording
    lines: Sequence[int] = ()  # of a text file: line of each sample, counted from 1

    def index(self, column: str | int) -> int:
        """Return the index of a column; `column` is its heading or its index.

        A column that does not exist raises an error.
        """
        if isinstance(column, int):
            if 0 <= column < len(self.names):
                return column
            raise InputError("table.no_place", place=column, names=self.names, count=len(self.names))
        indices = [k for k, name in enumerate(self.names) if name == column.strip()]
        indices = indices or [k for k, name in enumerate(self.names) if name == heading_of(column)[0]]
        if len(indices) == 1:
            return indices[0]
        if indices:
            raise InputError("table.ambiguous", column=column, places=tuple(indices))
        suggestion = NameSuggestion(column, self.names)
        code = "table.misspelt" if suggestion.names else "table.unknown"  # if unknown, `near` lists all names
        raise InputError(code, column=column, suggestion=suggestion, names=self.names)


def table_of(
    columns: Mapping[str, FloatArray], units: Mapping[str, str], notes: Sequence[Note] = (),
    meta: Mapping[str, Any] | None = None,
) -> Table:  # fmt: skip
    """Return a table of named columns with equal lengths.

    NaN is added at the end of shorter columns. `units` maps names to units in the spelling of the file, and `meta` is
    the metadata of a poppet recording.
    """
    longest = max((column.size for column in columns.values()), default=0)
    if not longest:
        raise InputError("table.no_columns")
    filled = tuple(
        np.concatenate([column, np.full(longest - column.size, np.nan)]).astype(float) for column in columns.values()
    )
    if meta:  # names and units of a recording are exact
        # A series with the name `time` keeps its column name, so there is one time column.
        names = {column: column if name == "time" else name for column, name in meta["columns"].items()}
        unit_by_column = {column: meta["units"].get(name, "") for column, name in meta["columns"].items()}
        unit_by_column["time"] = "s"
        column_names = tuple(names.get(column, column) for column in columns)
        column_units = tuple(unit_by_column.get(column, "") for column in columns)
        return Table(column_names, filled, column_units, tuple(notes), meta)
    headings = [heading_of(key) for key in columns]
    column_units = tuple(unit_of(units.get(key, "")) or unit for key, (_, unit) in zip(columns, headings, strict=True))
    return Table(tuple(name for name, _ in headings), filled, column_units, tuple(notes))


def seconds(column: np.ndarray[tuple[int, ...], np.dtype[np.datetime64]]) -> FloatArray:
    """Convert calendar times to seconds since the first time.

    Examples
    --------
    >>> seconds(np.array(["2026-01-01T00:00:01", "2026-01-01T00:00:02.5"], dtype="datetime64[ms]")).tolist()
    [0.0, 1.5]
    """
    fine = column.astype("datetime64[ns]")
    is_time = ~np.isnat(fine)
    result = np.full(fine.shape, np.nan)
    if is_time.any():
        # The difference comes first: a float cannot represent nanoseconds since 1970.
        result[is_time] = (fine[is_time] - fine[is_time][0]).astype(float) * 1e-9
    return result


def groups_of(groups: Mapping[str, Mapping[str, FloatArray]], group: str | int | None) -> dict[str, FloatArray]:
    """Return the columns of one group, or of all groups, of a file.

    `groups` contains all groups of the file. `group` is the name or the index of one of them. If it is None and the
    file has several groups, the result contains all columns, and each name begins with the name of the group.

    Examples
    --------
    >>> sorted(groups_of({"fast": {"p": np.zeros(2)}, "slow": {"T": np.zeros(1)}}, None))
    ['fast/p', 'slow/T']
    """
    names = list(groups)
    if isinstance(group, int) and 0 <= group < len(names):
        group = names[group]
    if group is not None and group not in groups:
        near = NameSuggestion(str(group), names)
        raise InputError("fields.not_an_option", "group", value=group, meaning="group of the file", suggestion=near)
    if isinstance(group, str) or len(names) == 1:
        return dict(groups[group if isinstance(group, str) else names[0]])
    return {f"{name}/{column}": values for name in names for column, values in groups[name].items()}
