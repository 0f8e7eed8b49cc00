"""Named series with units over one time base. Measured and simulated recordings are the same type."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from poppet.core.errors import InputError, UnitError, needed
from poppet.core.units import check_unit, convert, same_dimension
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.columns import Columns


class Recording(Columns):
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
    inner : frozenset of str, optional
        Names that a picture leaves out unless it is asked for them.
    figures : object, optional
        What `figures` shows, or a function that makes it.

    Examples
    --------
    >>> rec = Recording.from_series([0.0, 1.0], {"tank.pressure [Pa]": [1e5, 2e5]})
    >>> rec.converted(["bar"])["tank.pressure"].tolist()
    [1.0, 2.0]
    """

    __slots__ = ()

    def __repr__(self) -> str:
        span = f"{self.time[0]:.6g} ... {self.time[-1]:.6g} s" if self.time.size else "no samples"
        lines = [f"Recording {self.title!r}: {self.time.size} times, {span}; {len(self)} series"]
        width = max((len(name) for name in self.names), default=0)
        for name, unit, row in zip(self.names, self.units, self._values, strict=True):
            extent = f"{np.min(row):z.6g} ... {np.max(row):z.6g}" if row.size else ""
            lines.append(f"  {name:<{width}}  {extent} {unit}".rstrip())
        return "\n".join(lines)

    def _with(self, **changed: Any) -> Recording:
        return Recording(**(self.fields() | changed))

    def last(self) -> dict[str, float]:
        """The last value of every series by name, in its unit."""
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
        rows: dict[int, None] = {}  # a set that keeps the order
        for pattern in [names] if isinstance(names, str) else names:
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
            code = "series.window" if self._time.size else "series.window_of_nothing"
            raise InputError(code, start=start, stop=stop, **self._span())
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
        # Asked this way round, so that NaN is outside.
        outside = ~((wanted >= self._time[0]) & (wanted <= self._time[-1]))
        if np.any(outside):
            raise InputError("series.outside", time=float(wanted[outside].flat[0]), **self._span())
        return np.asarray(np.interp(wanted, self._time, self._values[row]))

    def _span(self) -> dict[str, Any]:
        return {"first": float(self._time[0]), "last": float(self._time[-1])} if self._time.size else {}

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
        if isinstance(units, str):  # its letters would be taken for units
            units = [units]
        if isinstance(units, Mapping):
            wanted = {self._row(name): unit for pattern, unit in units.items() for name in self.select(pattern)}
        else:
            wanted = self._fitting(units)
        values = self._values.copy()
        new = list(self.units)
        for row, unit in wanted.items():
            check_unit(unit)
            if not same_dimension(self.units[row], unit):
                name, own = self.names[row], self.units[row]
                raise UnitError("series.other_quantity", name=name, unit=own, asked=unit)
            values[row] = convert(values[row], self.units[row], unit, ambient_pressure=self.ambient_pressure)
            new[row] = unit
        return self._with(units=tuple(new), values=values)

    def _fitting(self, units: Sequence[str]) -> dict[int, str]:
        wanted: dict[int, str] = {}
        for unit in units:
            check_unit(unit)
            rows = [i for i, known in enumerate(self.units) if same_dimension(known, unit)]
            if not rows:
                has = tuple(dict.fromkeys(self.units))
                raise InputError("series.no_such_quantity", unit=unit, units=has)
            wanted.update(dict.fromkeys(rows, unit))
        return wanted

    def to_pandas(self) -> Any:
        """The recording as a table.

        Returns
        -------
        pandas.DataFrame
            One column per series, the time as its index; `frame.attrs["units"]` maps name to unit.
        """
        with needed("pandas", "A pandas table", "data"):
            import pandas as pd
        # Copies: a table is there to be changed, a recording is not.
        index = pd.Index(self.time.copy(), name="time")
        frame = pd.DataFrame(self.values.T.copy(), index=index, columns=list(self.names))
        frame.attrs["units"] = dict(zip(self.names, self.units, strict=True))
        return frame

    def to_xarray(self) -> Any:
        """The recording as a labelled data set.

        Returns
        -------
        xarray.Dataset
            One variable per series over the coordinate `time`, each with its unit in `attrs["units"]`; title, outcome
            and notes, in words, and the ambient pressure [Pa] in the `attrs` of the whole.
        """
        with needed("xarray", "An xarray data set", "data"):
            import xarray as xr
        # Copies, as for a table.
        series = {
            name: ("time", row.copy(), {"units": unit})
            for name, unit, row in zip(self.names, self.units, self.values, strict=True)
        }
        about: dict[str, Any] = {"title": self.title, "outcome": self.outcome, "notes": list(self.notes)}
        about["ambient_pressure"] = self.ambient_pressure
        return xr.Dataset(series, {"time": ("time", self.time.copy(), {"units": "s"})}, about)

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
        from poppet.timeseries import recording_files

        return recording_files.write(self, Path(path))

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
        from poppet.timeseries import recording_files

        return cls(**recording_files.read(Path(path)).fields())

    def plot(self, path: str | Path | None = None, **options: Any) -> Any:
        """Draw the recording.

        Parameters
        ----------
        path : str or Path, optional
            Where to write the figure, `.png` or `.svg`.
        **options
            As `poppet.timeseries.plotting.plots.plot_recordings` takes them, for example `select`.

        Returns
        -------
        matplotlib.figure.Figure
        """
        # Here, because few recordings are drawn and drawing is slow to import.
        from poppet.timeseries.plotting.plots import plot_recordings

        return plot_recordings({self.title: self}, path, **options)
