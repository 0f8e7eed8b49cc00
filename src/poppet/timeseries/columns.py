"""Columns of numbers over one time base, with names and units: what files hold and figures show."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from poppet.core.codes import Note, notes_of
from poppet.core.errors import InputError, NameSuggestion, collect
from poppet.core.note_groups import grouped
from poppet.core.notebook import HtmlMixin
from poppet.timeseries.checks import (
    FloatArray,
    first_bad_time,
    name_problems,
    numbers,
    split_heading,
)

_NO_NAMES = ("time", "slice", "list", "int")
"""Keys that cannot name a series, each with a cure of its own."""


class Columns(HtmlMixin):
    """Named columns with units over one time base, and what is known about them.

    `Recording` has the methods by which a reader works with them; files and figures need no more than this.
    The constructor trusts its arguments, since every run ends in it; `from_series` checks its own.
    """

    __slots__ = (
        "_figures",
        "_index",
        "_time",
        "_values",
        "ambient_pressure",
        "ending",
        "inner",
        "names",
        "remarks",
        "residuals",
        "statistics",
        "title",
        "units",
    )

    def __init__(
        self,
        time: FloatArray,
        names: tuple[str, ...],
        units: tuple[str, ...],
        values: FloatArray,
        *,
        title: str = "",
        notes: Iterable[Note | str] = (),
        outcome: Note | str = "",
        statistics: Mapping[str, float] | None = None,
        residuals: tuple[Any, ...] = (),
        ambient_pressure: float = 1e5,
        inner: frozenset[str] = frozenset(),
        figures: Any = None,
    ) -> None:
        # Views, so that the arrays of the caller stay as writable as they were.
        self._time, self._values = time.view(), values.view()
        self._time.flags.writeable = self._values.flags.writeable = False
        self._index: dict[str, int] | None = None
        self._figures = figures
        self.names, self.units = names, units
        self.title, self.remarks = title, notes_of(notes)
        self.ending = notes_of([outcome])[0] if outcome else None
        self.statistics: Mapping[str, float] = {} if statistics is None else statistics
        self.residuals, self.ambient_pressure, self.inner = residuals, ambient_pressure, inner

    @classmethod
    def from_series(
        cls,
        time: ArrayLike,
        series: Mapping[str, ArrayLike],
        *,
        units: Mapping[str, str] | None = None,
        title: str = "",
        notes: Iterable[Note | str] = (),
        ambient_pressure: float = 1e5,
    ) -> Self:
        """A recording of measured or computed arrays, checked.

        Parameters
        ----------
        time : (n,) array
            Finite, strictly increasing [s].
        series : mapping
            From `name [unit]`, or a name whose unit stands in `units`, to an (n,) array.
        units : mapping, optional
            From name to unit; a series named in neither place has the empty unit.
        title : str, optional
            What it is a recording of.
        notes : tuple of Note or str, optional
            What a reader should know.
        ambient_pressure : float, optional
            Absolute pressure to which gauge values refer [Pa].

        Returns
        -------
        Recording

        Raises
        ------
        InputError
            All mistakes at once: time not increasing, lengths that differ, a name given twice.
        """
        base = numbers("time", time)
        given = dict(units or {})
        headings = [split_heading(heading) for heading in series]
        names = tuple(name for name, _ in headings)
        rows = [numbers(name, row) for name, row in series.items()]
        bad_time = first_bad_time(base)
        problems = [bad_time[1]] if bad_time else []
        problems += name_problems(names, given)
        problems += [
            InputError("series.length", name=name, shape=row.shape, times=base.size)
            for name, row in zip(names, rows, strict=True)
            if row.shape != base.shape
        ]
        collect(problems)
        return cls(
            base,
            names,
            tuple(unit or given.get(name, "") for name, unit in headings),
            np.array(rows, dtype=float).reshape(len(rows), len(base)),
            title=title,
            notes=notes,
            ambient_pressure=ambient_pressure,
        )

    def fields(self) -> dict[str, Any]:
        """What the constructor takes."""
        return {
            "time": self._time,
            "names": self.names,
            "units": self.units,
            "values": self._values,
            "title": self.title,
            "notes": self.remarks,
            "outcome": self.ending or "",
            "statistics": self.statistics,
            "residuals": self.residuals,
            "ambient_pressure": self.ambient_pressure,
            "inner": self.inner,
            "figures": self.figures,
        }

    @property
    def figures(self) -> Any:
        """What an engineer asks first of a run with loads, `poppet.circuit.load_metrics.Figures`; else None."""
        if callable(self._figures):  # only now: most recordings are never asked
            self._figures = self._figures()
        return self._figures

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader should know, in words, much of a kind as one; `remarks` has all as codes with numbers."""
        return tuple(map(str, grouped(self.remarks)))

    @property
    def outcome(self) -> str:
        """How the run ended, in words; `ending` has it as a code with numbers."""
        return "" if self.ending is None else str(self.ending)

    @property
    def time(self) -> FloatArray:
        """The time base, read-only, shape (n,) [s]."""
        return self._time

    @property
    def values(self) -> FloatArray:
        """All series, read-only, shape (n_series, n), each row in its unit."""
        return self._values

    def __getitem__(self, name: str) -> FloatArray:
        row: FloatArray = self._values[self._row(name)]
        return row

    def _ipython_key_completions_(self) -> list[str]:
        """Names that an editor offers behind `recording[`."""
        return list(self.names)

    def __contains__(self, name: object) -> bool:
        return name in self.names

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)

    def _row(self, name: str) -> int:
        if self._index is None:  # only now: a fit makes thousands of recordings, and looks up little in them
            self._index = {known: i for i, known in enumerate(self.names)}
        row = self._index.get(name) if isinstance(name, str) else None
        if row is None:
            meant = "time" if name == "time" else type(name).__name__
            if meant in _NO_NAMES:
                raise InputError(f"series.key.{meant}", key=repr(name))
            raise InputError("series.unknown", name=str(name), near=NameSuggestion(str(name), self.names))
        return row

    def unit(self, name: str) -> str:
        """The unit of a series."""
        return self.units[self._row(name)]
