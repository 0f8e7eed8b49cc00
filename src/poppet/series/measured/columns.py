"""A table of measured columns, whatever file it came from, and how instruments write their headings."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from poppet.ground.errors import InputError, suggestion
from poppet.ground.units import is_known
from poppet.series.checks import FloatArray

_TRAILING_UNIT = re.compile(r"\s*(?P<name>.*?\S)\s*(?:\[(?P<square>[^\[\]]*)\]|\((?P<round>[^()]*)\))\s*")

# How instruments and loggers spell units, in lower case; everything else is read as the house writes it.
_SPELLINGS = {
    "sec": "s",
    "secs": "s",
    "second": "s",
    "seconds": "s",
    "msec": "ms",
    "milliseconds": "ms",
    "minutes": "min",
    "hours": "h",
    "psi": "psi",
    "psig": "psi g",
    "psia": "psi a",
    "mbar": "mbar",
    "in hg": "inHg",
    "c": "degC",
    "deg c": "degC",
    "celsius": "degC",
    "f": "degF",
    "deg f": "degF",
    "kelvin": "K",
    "lpm": "l/min",
    "slpm": "l/min N",
    "volts": "V",
}


def unit_of(spelling: str) -> str:
    """The unit that an instrument's spelling stands for.

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
    """Columns of numbers with names and units.

    Parameters
    ----------
    names : tuple of str
        Of the columns, without their units; `column 0` and so on where the file names none.
    columns : tuple of (n,) array
        One per name, in its unit; NaN where a cell is empty.
    units : tuple of str
        One per name, from the heading; empty where it states none.
    notes : tuple of str
        What was guessed and what was left out.
    """

    names: tuple[str, ...]
    columns: tuple[FloatArray, ...]
    units: tuple[str, ...]
    notes: tuple[str, ...] = ()

    def index(self, wanted: str | int) -> int:
        """Where a column stands."""
        if isinstance(wanted, int):
            if 0 <= wanted < len(self.names):
                return wanted
            cure = f"Columns are counted from 0; found: {', '.join(self.names)}."
            raise InputError(f"column {wanted}", f"is not one of the {len(self.names)} columns.", cure)
        places = [k for k, name in enumerate(self.names) if name == wanted.strip()]
        places = places or [k for k, name in enumerate(self.names) if name == heading_of(wanted)[0]]
        if len(places) == 1:
            return places[0]
        if places:
            cure = f"Name it by its place: {' or '.join(map(str, places))}."
            raise InputError(f'column "{wanted}"', "stands more than once.", cure)
        near = suggestion(wanted, self.names)
        listed = "" if near.startswith("Use one of") else f" Columns found: {', '.join(self.names)}."
        raise InputError(f'column "{wanted}"', "is not in the file.", near + listed)


def table_of(
    columns: Mapping[str, FloatArray], units: Mapping[str, str] | None = None, notes: Sequence[str] = ()
) -> Table:
    """A table of named columns, the short ones filled up with NaN."""
    longest = max((column.size for column in columns.values()), default=0)
    if not longest:
        raise InputError("the file", "holds no columns of numbers.", "Check what wrote it.")
    headings = [heading_of(key) for key in columns]
    given = units or {}
    filled = [
        np.concatenate([column, np.full(longest - column.size, np.nan)]).astype(float) for column in columns.values()
    ]
    return Table(
        tuple(name for name, _ in headings),
        tuple(filled),
        tuple(unit_of(given.get(key, "")) or unit for key, (_, unit) in zip(columns, headings, strict=True)),
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
        given = f"group = {group!r}"
        raise InputError(given, "is not in the file.", suggestion(str(group), names), address="group")
    if isinstance(group, str) or len(names) == 1:
        return dict(found[group if isinstance(group, str) else names[0]])
    return {f"{name}/{column}": values for name in names for column, values in found[name].items()}
