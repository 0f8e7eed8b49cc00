"""Named series with units over one time base, as stored in files and drawn in figures."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from poppet.core.codes import Note, notes_of
from poppet.core.errors import InputError, NameSuggestion, raise_errors
from poppet.core.note_groups import grouped
from poppet.core.notebook import HtmlMixin
from poppet.timeseries.checks import FloatArray, first_bad_time, name_problems, numbers, split_heading

_SAME_NAME = (
    "time", "names", "units", "values", "title", "statistics", "residuals", "ambient_pressure", "inner", "figures",
)  # fmt: skip
"""Names of constructor arguments whose values are in attributes with the same names."""
_NO_NAMES = ("time", "slice", "list", "int")  # invalid keys of a recording; the error of each one has its own hint


class Columns(HtmlMixin):
    """Named series with units over one time base, with notes on their origin.

    `Recording` is a subclass with more methods for users. The constructor does not check its arguments, because each
    simulation calls it. Use `from_series` for arguments that need checks.

    The arguments notes, residuals and figures can be functions without arguments, which are called on first use.
    """

    __slots__ = (
        "_figures", "_index", "_remarks", "_residuals", "_time", "_values", "ambient_pressure", "ending", "inner",
        "names", "statistics", "title", "units",
    )  # fmt: skip

    def __init__(
        self, time: FloatArray, names: tuple[str, ...], units: tuple[str, ...], values: FloatArray, *,
        title: str = "", notes: Iterable[Note | str] | Callable[[], Iterable[Note | str]] = (),
        outcome: Note | str = "", statistics: Mapping[str, float] | None = None,
        residuals: tuple[Any, ...] | Callable[[], tuple[Any, ...]] = (), ambient_pressure: float = 1e5,
        inner: frozenset[str] = frozenset(), figures: Any = None,
    ) -> None:  # fmt: skip
        # Views: the caller's arrays remain writable.
        self._time, self._values = time.view(), values.view()
        self._time.flags.writeable = self._values.flags.writeable = False
        self._index: dict[str, int] | None = None
        self._figures, self._residuals = figures, residuals
        self._remarks = notes if callable(notes) else notes_of(notes)
        self.names, self.units = names, units
        self.title = title
        self.ending = notes_of([outcome])[0] if outcome else None
        self.statistics: Mapping[str, float] = {} if statistics is None else statistics
        self.ambient_pressure, self.inner = ambient_pressure, inner

    @classmethod
    def from_series(
        cls, time: ArrayLike, series: Mapping[str, ArrayLike], *, units: Mapping[str, str] | None = None,
        title: str = "", notes: Iterable[Note | str] = (), ambient_pressure: float = 1e5,
    ) -> Self:  # fmt: skip
        """Check measured or computed arrays, and return them as a recording.

        Parameters
        ----------
        time : (n,) array
            Finite, strictly increasing [s].
        series : mapping
            Mapping from `name [unit]`, or from a name whose unit is in `units`, to an (n,) array.
        units : mapping, optional
            Mapping from name to unit. A series without a unit in its heading or in `units` has the empty unit.
        title : str, optional
            Title of the recording.
        notes : tuple of Note or str, optional
            Notes for the reader.
        ambient_pressure : float, optional
            Absolute pressure to which gauge values refer [Pa].

        Returns
        -------
        Recording

        Raises
        ------
        InputError
            If time does not increase, lengths differ or a name occurs twice; all errors are reported together.
        """
        base = numbers("time", time)
        units_by_name = dict(units or {})
        headings = [split_heading(heading) for heading in series]
        names = tuple(name for name, _ in headings)
        rows = [numbers(name, row) for name, row in series.items()]
        bad_time = first_bad_time(base)
        problems = ([bad_time[1]] if bad_time else []) + name_problems(names, units_by_name)
        problems += [
            InputError("series.length", name=name, shape=row.shape, times=base.size)
            for name, row in zip(names, rows, strict=True)
            if row.shape != base.shape
        ]
        raise_errors(problems)
        return cls(
            base, names, tuple(unit or units_by_name.get(name, "") for name, unit in headings),
            np.array(rows, dtype=float).reshape(len(rows), len(base)), title=title, notes=notes,
            ambient_pressure=ambient_pressure,
        )  # fmt: skip

    def fields(self) -> dict[str, Any]:
        """Return the constructor arguments that create an equal recording, by name."""
        arguments = {name: getattr(self, name) for name in _SAME_NAME}
        return arguments | {"notes": self.remarks, "outcome": self.ending or ""}

    def __reduce__(self) -> tuple[partial[Self], tuple[()]]:
        # Values instead of functions, which can contain compiled code.
        return partial(type(self), **self.fields()), ()

    @property
    def remarks(self) -> tuple[Note, ...]:
        """Notes of the recording as `Note` objects."""
        if callable(self._remarks):
            self._remarks = notes_of(self._remarks())
        return self._remarks

    @property
    def residuals(self) -> tuple[Any, ...]:
        """Residuals of the mass and energy balances of a simulation."""
        if callable(self._residuals):
            self._residuals = self._residuals()
        return self._residuals

    @property
    def figures(self) -> Any:
        """Load metrics of a simulation, such as strokes and air consumption.

        They are a `poppet.circuit.load_metrics.LoadMetrics`. The value is None if the circuit has no loads.
        """
        if callable(self._figures):  # evaluated on first use: most recordings do not need it
            self._figures = self._figures()
        return self._figures

    @property
    def notes(self) -> tuple[str, ...]:
        """Notes of the recording as texts.

        Three or more notes with the same message code are combined into one. `remarks` contains the same notes as
        objects.
        """
        return tuple(map(str, grouped(self.remarks)))

    @property
    def outcome(self) -> str:
        """Termination reason of a simulation as text, empty for measurements.

        `ending` contains it as a `Note`.
        """
        return "" if self.ending is None else str(self.ending)

    @property
    def time(self) -> FloatArray:
        """Time base, read-only, shape (n,) [s]."""
        return self._time

    @property
    def values(self) -> FloatArray:
        """Values of all series, read-only, shape (n_series, n).

        Each row contains one series in the unit of that series.
        """
        return self._values

    def __getitem__(self, name: str) -> FloatArray:
        row: FloatArray = self._values[self._row(name)]
        return row

    def _ipython_key_completions_(self) -> list[str]:
        """Return the names of the series, which IPython suggests after `recording[`."""
        return list(self.names)

    def __contains__(self, name: object) -> bool:
        return name in self.names

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)

    def _row(self, name: str) -> int:
        if self._index is None:  # built on first use: a fit makes thousands of recordings and reads few names
            self._index = {key: i for i, key in enumerate(self.names)}
        row = self._index.get(name) if isinstance(name, str) else None
        if row is None:
            kind = "time" if name == "time" else type(name).__name__
            if kind in _NO_NAMES:
                raise InputError(f"series.key.{kind}", key=repr(name))
            near = NameSuggestion(str(name), self.names)
            raise InputError("names.unknown", str(name), meaning="an output of the recording", suggestion=near)
        return row

    def unit(self, name: str) -> str:
        """Return the unit of the series with the given name."""
        return self.units[self._row(name)]
