"""A table of columns, whatever file it came from, and how instruments write their headings."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.units import is_known
from poppet.timeseries.checks import FloatArray

_TRAILING_UNIT = re.compile(r"\s*(?P<name>.*?\S)\s*(?:\[(?P<square>[^\[\]]*)\]|\((?P<round>[^()]*)\))\s*")

# How instruments and loggers spell units, in lower case; everything else is read as the house writes it.
_SPELLINGS = {
    **dict.fromkeys(("sec", "secs", "second", "seconds"), "s"),
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


def unit_of(spelling: str) -> str:
    """The unit that an instrument's spelling stands for; empty where it is none.

    Examples
    --------
    >>> unit_of("PSI"), unit_of("Deg C"), unit_of("g/min"), unit_of("filtered")
    ('psi', 'degC', 'g/min', '')
    """
    text = spelling.strip()
    known = _SPELLINGS.get(" ".join(text.lower().replace("°", "deg ").split()))
    if known:
        return known
    return text if text and is_known(text) else ""


def heading_of(text: str) -> tuple[str, str]:
    """Name and unit of a column heading.

    Examples
    --------
    >>> heading_of("P1(PSI)"), heading_of("flow (filtered)")
    (('P1', 'psi'), ('flow (filtered)', ''))
    """
    found = _TRAILING_UNIT.fullmatch(text)
    if found:
        written = found["square"] if found["square"] is not None else found["round"]
        # `(1)` counts sensors; `[1]` is how a recording writes a number without dimension.
        unit = unit_of(written) if found["square"] is not None or not written.strip().isdigit() else ""
        if unit or not written.strip():
            return found["name"], unit
    return text.strip(), ""


@dataclass(frozen=True, eq=False)
class Table:
    """Columns of numbers with names and units."""

    names: tuple[str, ...]  # without units; `column 0` and so on where the file names none
    columns: tuple[FloatArray, ...]  # each (n,), in its unit; NaN where a cell is empty
    units: tuple[str, ...]  # from the heading; empty where it states none
    notes: tuple[Note, ...] = ()  # what was guessed and what was left out
    meta: Mapping[str, Any] = field(default_factory=dict)  # what a recording of the house wrote beside its numbers
    lines: Sequence[int] = ()  # in a text, the line of each sample, counted from 1

    def index(self, wanted: str | int) -> int:
        """Where a column stands, named as in the heading or by its place."""
        if isinstance(wanted, int):
            if 0 <= wanted < len(self.names):
                return wanted
            raise InputError("table.no_place", place=wanted, names=self.names, count=len(self.names))
        places = [k for k, name in enumerate(self.names) if name == wanted.strip()]
        places = places or [k for k, name in enumerate(self.names) if name == heading_of(wanted)[0]]
        if len(places) == 1:
            return places[0]
        if places:
            raise InputError("table.ambiguous", column=wanted, places=tuple(places))
        near = NameSuggestion(wanted, self.names)
        code = "table.misspelt" if near.names else "table.unknown"  # where none is near, `near` lists them all
        raise InputError(code, column=wanted, near=near, names=self.names)


def table_of(
    columns: Mapping[str, FloatArray],
    units: Mapping[str, str],
    notes: Sequence[Note] = (),
    meta: Mapping[str, Any] | None = None,
) -> Table:
    """A table of named columns, the short ones filled up with NaN; `units` from name, as the file spells them."""
    longest = max((column.size for column in columns.values()), default=0)
    if not longest:
        raise InputError("table.no_columns")
    filled = tuple(
        np.concatenate([column, np.full(longest - column.size, np.nan)]).astype(float) for column in columns.values()
    )
    if meta:  # the names and units of a recording are exact: nothing is read into them
        # A series named as the time stays under the name of its column, so that there is one time.
        names = {column: column if name == "time" else name for column, name in meta["columns"].items()}
        said = {column: meta["units"].get(name, "") for column, name in meta["columns"].items()} | {"time": "s"}
        shown = tuple(names.get(column, column) for column in columns)
        return Table(shown, filled, tuple(said.get(column, "") for column in columns), tuple(notes), meta)
    headings = [heading_of(key) for key in columns]
    return Table(
        tuple(name for name, _ in headings),
        filled,
        tuple(unit_of(units.get(key, "")) or unit for key, (_, unit) in zip(columns, headings, strict=True)),
        tuple(notes),
    )


def seconds(column: np.ndarray[tuple[int, ...], np.dtype[np.datetime64]]) -> FloatArray:
    """Stamps of a calendar as seconds since the first.

    Examples
    --------
    >>> seconds(np.array(["2026-01-01T00:00:01", "2026-01-01T00:00:02.5"], dtype="datetime64[ms]")).tolist()
    [0.0, 1.5]
    """
    fine = column.astype("datetime64[ns]")
    there = ~np.isnat(fine)
    result = np.full(fine.shape, np.nan)
    if there.any():
        # The difference first: nanoseconds since 1970 do not fit a float.
        result[there] = (fine[there] - fine[there][0]).astype(float) * 1e-9
    return result


def groups_of(found: Mapping[str, Mapping[str, FloatArray]], group: str | int | None) -> dict[str, FloatArray]:
    """The columns of one group of a file, or of all, each then named after its group.

    Examples
    --------
    >>> sorted(groups_of({"fast": {"p": np.zeros(2)}, "slow": {"T": np.zeros(1)}}, None))
    ['fast/p', 'slow/T']
    """
    names = list(found)
    if isinstance(group, int) and 0 <= group < len(names):
        group = names[group]
    if group is not None and group not in found:
        raise InputError("table.no_group", "group", group=group, near=NameSuggestion(str(group), names))
    if isinstance(group, str) or len(names) == 1:
        return dict(found[group if isinstance(group, str) else names[0]])
    return {f"{name}/{column}": values for name in names for column, values in found[name].items()}
