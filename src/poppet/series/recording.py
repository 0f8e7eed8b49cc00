"""Named series with units over one time base. Measured and simulated recordings are the same type."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from poppet.ground.codes import Note, notes_of
from poppet.ground.errors import InputError, UnitError, collect, suggestion
from poppet.ground.units import check_unit, convert, same_dimension
from poppet.series.checks import (
    FloatArray,
    first_bad_time,
    length_problems,
    name_problems,
    numbers,
    split_heading,
)

_OTHER_WAYS = {
    "time": "The time base is recording.time.",
    "slice": "Take rows of a series, recording[name][10:20], or a span of time, recording.between(1.0, 2.0).",
    "list": "Take several series with recording.select(names).",
    "int": "Name a series; recording.names lists them.",
}
"""What is meant by a key that is no name of a series."""


class Recording:
    """Named series with units over one time base.

    The constructor trusts its arguments, since every run ends in it; `from_series` and `read` check theirs.

    Parameters
    ----------
    time : (n,) array
        Strictly increasing [s].
    names : tuple of str
        Dotted names of the series, `tank.pressure`.
    units : tuple of str
        One per name.
    values : (n_series, n) array
        One row per name, in its unit.
    title : str, optional
        What it is a recording of.
    notes : tuple of Note or str, optional
        What a reader should know.
    outcome : Note or str, optional
        How the run ended.
    statistics : mapping, optional
        Counts of the run.
    residuals : tuple, optional
        Balances of the run that should be zero.
    ambient_pressure : float, optional
        Absolute pressure to which gauge values refer [Pa].

    Examples
    --------
    >>> rec = Recording.from_series([0.0, 1.0], {"tank.pressure [Pa]": [1e5, 2e5]})
    >>> rec.converted(["bar"])["tank.pressure"].tolist()
    [1.0, 2.0]
    """

    __slots__ = (
        "_index",
        "_time",
        "_values",
        "ambient_pressure",
        "ending",
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
    ) -> None:
        self._time, self._values = time.view(), values.view()
        self._time.flags.writeable = self._values.flags.writeable = False
        self._index: dict[str, int] | None = None
        self.names, self.units = names, units
        self.title, self.remarks = title, notes_of(notes)
        self.ending = notes_of([outcome])[0] if outcome else None
        self.statistics: Mapping[str, float] = {} if statistics is None else statistics
        self.residuals, self.ambient_pressure = residuals, ambient_pressure

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
    ) -> Recording:
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
        collect(problems + name_problems(names, given) + length_problems(base, names, rows))
        return cls(
            base,
            names,
            tuple(unit or given.get(name, "") for name, unit in headings),
            np.array(rows, dtype=float).reshape(len(rows), len(base)),
            title=title,
            notes=notes,
            ambient_pressure=ambient_pressure,
        )

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader should know, in words; `remarks` has it as codes with numbers."""
        return tuple(map(str, self.remarks))

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

    def __contains__(self, name: object) -> bool:
        return name in self.names

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        span = f"{self.time[0]:.6g} ... {self.time[-1]:.6g} s" if self.time.size else "no samples"
        lines = [f"Recording {self.title!r}: {self.time.size} times, {span}; {len(self)} series"]
        width = max((len(name) for name in self.names), default=0)
        for name, unit, row in zip(self.names, self.units, self._values, strict=True):
            extent = f"{np.min(row):.6g} ... {np.max(row):.6g}" if row.size else ""
            lines.append(f"  {name:<{width}}  {extent} {unit}".rstrip())
        return "\n".join(lines)

    def _row(self, name: str) -> int:
        if self._index is None:
            self._index = {known: i for i, known in enumerate(self.names)}
        row = self._index.get(name) if isinstance(name, str) else None
        if row is None:
            cure = _OTHER_WAYS.get("time" if name == "time" else type(name).__name__)
            if cure:
                raise InputError(f"recording[{name!r}]", "is not a series.", cure)
            raise InputError(f"series {name!r}", "is not in the recording.", suggestion(str(name), self.names))
        return row

    def _with(self, **changed: Any) -> Recording:
        kept: dict[str, Any] = {
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
        }
        return Recording(**(kept | changed))

    def unit(self, name: str) -> str:
        """The unit of a series.

        Parameters
        ----------
        name : str
            Of the series.

        Returns
        -------
        str
        """
        return self.units[self._row(name)]

    def last(self) -> dict[str, float]:
        """The last value of every series.

        Returns
        -------
        dict
            From name to value, in its unit.
        """
        return {name: float(row[-1]) for name, row in zip(self.names, self._values, strict=True)}

    def select(self, names: str | Iterable[str]) -> Recording:
        """Some of the series.

        Parameters
        ----------
        names : str or iterable of str
            Names or patterns, `tank.*`; the order given is the order of the result.

        Returns
        -------
        Recording
            With all its notes.

        Raises
        ------
        InputError
            A name or pattern that fits no series.
        """
        patterns = [names] if isinstance(names, str) else list(names)
        rows: dict[int, None] = {}
        for pattern in patterns:
            found = [i for i, name in enumerate(self.names) if name == pattern or fnmatchcase(name, pattern)]
            rows.update(dict.fromkeys(found or [self._row(pattern)]))
        chosen = list(rows)
        return self._with(
            names=tuple(self.names[i] for i in chosen),
            units=tuple(self.units[i] for i in chosen),
            values=self._values[chosen],
        )

    def between(self, start: float, stop: float) -> Recording:
        """The samples of a time window, both ends included.

        Parameters
        ----------
        start, stop : float
            Ends of the window [s].

        Returns
        -------
        Recording
            At least one sample.
        """
        first = int(np.searchsorted(self._time, start, side="left"))
        end = int(np.searchsorted(self._time, stop, side="right"))
        if first >= end:
            raise InputError(
                f"window = {start:.12g} ... {stop:.12g} s",
                f"holds no sample; the recording spans {self._span()}.",
                "Choose a window with samples.",
            )
        return self._with(time=self._time[first:end], values=self._values[:, first:end])

    def interpolate(self, name: str, times: ArrayLike) -> FloatArray:
        """A series at other times, straight between its samples.

        Parameters
        ----------
        name : str
            Of the series.
        times : float or (...) array
            Within the span of the recording [s].

        Returns
        -------
        (...) array
            In the unit of the series.

        Raises
        ------
        InputError
            A time outside the span, where nothing was recorded.
        """
        wanted = np.asarray(times, dtype=float)
        row = self._row(name)
        outside = ~((wanted >= self._time[0]) & (wanted <= self._time[-1]))
        if np.any(outside):
            raise InputError(
                f"time = {float(wanted[outside].flat[0]):.12g} s",
                f"lies outside the recording, which spans {self._span()}.",
                "Interpolate inside it.",
            )
        return np.asarray(np.interp(wanted, self._time, self._values[row]))

    def _span(self) -> str:
        return f"{self._time[0]:.12g} ... {self._time[-1]:.12g} s" if self._time.size else "nothing"

    def converted(self, units: Mapping[str, str] | Sequence[str]) -> Recording:
        """The same recording in other units.

        Parameters
        ----------
        units : mapping or sequence of str
            From name or pattern to unit; or units alone, each for all series of its quantity.

        Returns
        -------
        Recording

        Raises
        ------
        UnitError
            A unit that is unknown or of another quantity than the series.
        InputError
            A name or a unit that fits no series.
        """
        if isinstance(units, str):
            units = [units]
        wanted = self._named(units) if isinstance(units, Mapping) else self._fitting(units)
        values = self._values.copy()
        new = list(self.units)
        for row, unit in wanted.items():
            check_unit(unit)
            if not same_dimension(self.units[row], unit):
                given = f'series {self.names[row]!r} in "{self.units[row]}"'
                raise UnitError(given, f'does not convert to "{unit}".', "Choose a unit of its quantity.")
            values[row] = convert(values[row], self.units[row], unit, ambient_pressure=self.ambient_pressure)
            new[row] = unit
        return self._with(units=tuple(new), values=values)

    def _named(self, units: Mapping[str, str]) -> dict[int, str]:
        return {self._row(name): unit for pattern, unit in units.items() for name in self.select(pattern)}

    def _fitting(self, units: Sequence[str]) -> dict[int, str]:
        wanted: dict[int, str] = {}
        for unit in units:
            check_unit(unit)
            rows = [i for i, known in enumerate(self.units) if same_dimension(known, unit)]
            if not rows:
                given = f'unit "{unit}"'
                raise InputError(given, "fits no series of the recording.", f"It has {_listed(self.units)}.")
            wanted.update(dict.fromkeys(rows, unit))
        return wanted

    def to_pandas(self) -> Any:
        """The recording as a table.

        Returns
        -------
        pandas.DataFrame
            One column per series, the time as its index; `frame.attrs["units"]` maps name to unit.
        """
        from poppet.series.files import to_pandas

        return to_pandas(self)

    def save(self, path: str | Path) -> Path:
        """Write the recording; an existing file is replaced as a whole or not at all.

        Parameters
        ----------
        path : str or Path
            Ends in `.csv`, `.parquet` or `.mat`.

        Returns
        -------
        Path
            Where it was written.

        Notes
        -----
        CSV holds names, units and numbers, 17 digits each; Parquet and MAT also title, notes, outcome,
        statistics and ambient pressure. Residuals are not written.
        """
        from poppet.series.files import write

        return write(self, Path(path))

    @classmethod
    def read(cls, path: str | Path) -> Recording:
        """Read what `save` wrote, or a CSV file with a time column and a heading line.

        Parameters
        ----------
        path : str or Path
            Ends in `.csv`, `.parquet` or `.mat`.

        Returns
        -------
        Recording
        """
        from poppet.series.files import read

        return read(Path(path))

    def plot(self, path: str | Path | None = None, **options: Any) -> Any:
        """Draw the recording.

        Parameters
        ----------
        path : str or Path, optional
            Where to write the figure, `.png` or `.svg`.
        **options
            As `poppet.series.drawing.plots.plot_recordings` takes them, for example `select`.

        Returns
        -------
        matplotlib.figure.Figure
        """
        # The one import that goes up: a recording may be asked to draw itself, and only then.
        from poppet.series.drawing.plots import plot_recordings

        return plot_recordings({self.title: self}, path, **options)


def _listed(units: Iterable[str]) -> str:
    return ", ".join(dict.fromkeys(f'"{unit}"' for unit in units)) or "no series"
