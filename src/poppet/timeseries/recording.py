"""Recording of measured or simulated series with units over one time base."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatchcase
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from poppet.core.errors import InputError, UnitError, needed
from poppet.core.units import check_unit, convert, same_dimension
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.columns import Columns

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.figure import Figure


class Recording(Columns):
    """Measured or simulated series with units over one time base.

    The constructor does not check its arguments, because each simulation calls it. `from_series` and `read` check
    their data.

    Parameters
    ----------
    time : (n,) array
        Strictly increasing [s].
    names : tuple of str
        Dotted names of the series, `tank.pressure`.
    units : tuple of str
        Unit of each series, in the order of `names`.
    values : (n_series, n) array
        Values of each series in its unit, one row per name.
    title : str, optional
        Title of the recording.
    notes : iterable of Note or str, or callable, optional
        Notes for the reader, or a function that computes them on first use.
    outcome : Note or str, optional
        Termination reason of the run.
    statistics : mapping, optional
        Counts of the simulation, for example of solver steps.
    residuals : tuple or callable, optional
        Residuals of the mass and energy balances, or a function that computes them on first use.
    ambient_pressure : float, optional
        Absolute pressure to which gauge values refer [Pa].
    inner : frozenset of str, optional
        Names of the internal outputs, which figures omit by default.
    figures : object, optional
        Load metrics (see the property `figures`), or a function that computes them on first use.

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
        """Return the last value of each series by name.

        The value is in the unit of the series.
        """
        return {name: float(row[-1]) for name, row in zip(self.names, self._values, strict=True)}

    def select(self, names: str | Iterable[str]) -> Recording:
        """Return a recording with only the selected series.

        Parameters
        ----------
        names : str or iterable of str
            Names or patterns, `tank.*`, in the order of the result.

        Returns
        -------
        Recording
            Selected series with all notes.

        Raises
        ------
        InputError
            If a name or pattern matches no series.
        """
        rows: dict[int, None] = {}  # an ordered set
        for pattern in [names] if isinstance(names, str) else names:
            matches = [i for i, name in enumerate(self.names) if name == pattern or fnmatchcase(name, pattern)]
            rows.update(dict.fromkeys(matches or [self._row(pattern)]))
        selected = list(rows)
        return self._with(
            names=tuple(self.names[i] for i in selected),
            units=tuple(self.units[i] for i in selected),
            values=self._values[selected],
        )

    def between(self, start: float, stop: float) -> Recording:
        """Return the samples of a time window as a recording.

        Samples at both limits of the window are included.

        Parameters
        ----------
        start, stop : float
            Limits of the window [s].

        Returns
        -------
        Recording
            Recording with at least one sample.
        """
        first = int(np.searchsorted(self._time, start, side="left"))
        end = int(np.searchsorted(self._time, stop, side="right"))
        if first >= end:
            code = "series.window" if self._time.size else "series.window_of_nothing"
            raise InputError(code, start=start, stop=stop, **self._span())
        return self._with(time=self._time[first:end], values=self._values[:, first:end])

    def interpolate(self, name: str, times: ArrayLike) -> FloatArray:
        """Return the values of a series at given times by linear interpolation.

        Parameters
        ----------
        name : str
            Name of the series.
        times : float or (...) array
            Times within the span of the recording [s].

        Returns
        -------
        (...) array
            Values in the unit of the series.

        Raises
        ------
        InputError
            If a time is outside the span.
        """
        requested = np.asarray(times, dtype=float)
        row = self._row(name)
        # The negated condition is also true for NaN.
        is_outside = ~((requested >= self._time[0]) & (requested <= self._time[-1]))
        if np.any(is_outside):
            raise InputError("series.outside", time=float(requested[is_outside].flat[0]), **self._span())
        return np.asarray(np.interp(requested, self._time, self._values[row]))

    def _span(self) -> dict[str, Any]:
        return {"first": float(self._time[0]), "last": float(self._time[-1])} if self._time.size else {}

    def converted(self, units: Mapping[str, str] | Sequence[str]) -> Recording:
        """Return a copy of the recording with series converted to other units.

        Parameters
        ----------
        units : mapping or sequence of str
            Mapping from name or pattern to unit, or a list of units. A unit in a list applies to all series of the same
            quantity.

        Returns
        -------
        Recording

        Raises
        ------
        UnitError
            If a unit is unknown or does not have the dimension of the series.
        InputError
            If a name or a unit matches no series.
        """
        if isinstance(units, str):  # a string is also a sequence of letters
            units = [units]
        if isinstance(units, Mapping):
            unit_by_row = {self._row(name): unit for pattern, unit in units.items() for name in self.select(pattern)}
        else:
            unit_by_row = {}
            for unit in units:
                check_unit(unit)
                rows = [i for i, row_unit in enumerate(self.units) if same_dimension(row_unit, unit)]
                if not rows:
                    raise InputError("series.no_such_quantity", unit=unit, units=tuple(dict.fromkeys(self.units)))
                unit_by_row.update(dict.fromkeys(rows, unit))
        values = self._values.copy()
        row_units = list(self.units)
        for row, unit in unit_by_row.items():
            check_unit(unit)
            if not same_dimension(self.units[row], unit):
                name, row_unit = self.names[row], self.units[row]
                raise UnitError("series.other_quantity", name=name, unit=row_unit, asked=unit)
            values[row] = convert(values[row], self.units[row], unit, ambient_pressure=self.ambient_pressure)
            row_units[row] = unit
        return self._with(units=tuple(row_units), values=values)

    def to_pandas(self) -> pandas.DataFrame:
        """Return the recording as a pandas table.

        Returns
        -------
        pandas.DataFrame
            Table with one column per series and the time as index; `frame.attrs["units"]` maps name to unit.
        """
        with needed("pandas", "A pandas table", "data"):
            import pandas as pd
        # Copies: the table is mutable, the recording is not.
        index = pd.Index(self.time.copy(), name="time")
        frame = pd.DataFrame(self.values.T.copy(), index=index, columns=list(self.names))
        frame.attrs["units"] = dict(zip(self.names, self.units, strict=True))
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """Return the recording as an xarray data set.

        Returns
        -------
        xarray.Dataset
            Data set with one variable per series over the coordinate `time`, each with its unit in `attrs["units"]`.
            The `attrs` of the data set contain title, outcome, notes and ambient pressure [Pa].
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
        """Write the recording to a file.

        The method replaces an existing file completely or not at all.

        Parameters
        ----------
        path : str or Path
            Path that ends in `.csv`, `.parquet` or `.mat`.

        Returns
        -------
        Path
            Path of the written file.

        Notes
        -----
        A CSV file contains names, units and values with 17 digits. Parquet and MAT files also contain title, notes,
        outcome, statistics and ambient pressure. Residuals are not written.
        """
        from poppet.timeseries import recording_files

        return recording_files.write(self, Path(path))

    @classmethod
    def read(cls, path: str | Path) -> Recording:
        """Read a file written by `save`, or a CSV file with a heading line and a time column.

        Parameters
        ----------
        path : str or Path
            Path that ends in `.csv`, `.parquet` or `.mat`.

        Returns
        -------
        Recording
        """
        from poppet.timeseries import recording_files

        return cls(**recording_files.read(Path(path)).fields())

    def plot(self, path: str | Path | None = None, **options: Any) -> Figure:
        """Draw the series over time, in one panel for each quantity.

        Parameters
        ----------
        path : str or Path, optional
            Path of the figure, `.png` or `.svg`.
        **options
            Options of `poppet.timeseries.plotting.plots.plot_recordings`, for example `select`.

        Returns
        -------
        matplotlib.figure.Figure
        """
        # Imported here: few recordings are drawn, and the import is slow.
        from poppet.timeseries.plotting.plots import plot_recordings

        return plot_recordings({self.title: self}, path, **options)
