"""Checks of time bases, series and column headings, for signals and recordings."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from numbers import Real

import numpy as np
from numpy.typing import ArrayLike, NDArray

from poppet.core.errors import InputError, NameSuggestion

FloatArray = NDArray[np.float64]
METADATA = "poppet"  # name of the variable or key for the metadata of a recording (title, notes, units), in JSON

_HEADING = re.compile(r"\s*(?P<name>[^\[\]]*?)\s*(?:\[(?P<unit>[^\[\]]*)\])?\s*")


def split_heading(heading: str) -> tuple[str, str]:
    """Split a column heading into name and unit.

    The unit is empty if the heading has none.

    Examples
    --------
    >>> split_heading("tank.pressure [Pa]")
    ('tank.pressure', 'Pa')
    """
    match = _HEADING.fullmatch(heading)
    if match is None or not match["name"]:
        raise InputError("series.heading", heading=heading)
    return match["name"], (match["unit"] or "").strip()


def numbers(name: str, series: ArrayLike) -> FloatArray:
    """Convert a series to a new array of floats.

    If this is impossible, an error with the name of the series is raised.
    """
    try:
        return np.array(series, dtype=float)
    except (TypeError, ValueError) as problem:
        raise InputError("series.numbers", name=name, series=f"{series!r:.60}") from problem


def first_bad_time(time: FloatArray, owner: str = "") -> tuple[int, InputError] | None:
    """Return the index of the first invalid time, and the error.

    The result is None if all times are valid. Times must be a vector of at least one finite value, and must increase
    strictly. `owner` is the name of the series in the error message.
    """
    if time.ndim != 1 or not time.size:
        return 0, InputError("series.time.shape", owner=owner, shape=time.shape)
    invalid = np.flatnonzero(~np.isfinite(time))
    if invalid.size:
        k = int(invalid[0])
        return k, InputError("series.time.not_finite", owner=owner, place=k, time=float(time[k]))
    invalid = np.flatnonzero(np.diff(time) <= 0.0)
    if not invalid.size:
        return None
    k = int(invalid[0])
    first, then = float(time[k]), float(time[k + 1])
    problem = InputError("series.time.not_increasing", owner=owner, place=k, after=k + 1, time=first, next=then)
    return k + 1, problem


def name_problems(names: tuple[str, ...], units: Iterable[str]) -> list[InputError]:
    """Return the errors in the names of series.

    A name that occurs twice is an error. `units` contains names for which a unit is specified: a name in `units` but
    not in `names` is also an error.
    """
    duplicates = [name for name in dict.fromkeys(names) if names.count(name) > 1]
    unnamed = [name for name in units if name not in names]
    return [InputError("series.twice", name=name) for name in duplicates] + [
        InputError("series.no_unit_of", name=name, suggestion=NameSuggestion(name, names)) for name in unnamed
    ]


def path_problems(owner: str, times: FloatArray, values: FloatArray) -> list[InputError]:
    """Return all errors in the times and values of a signal.

    `times` and `values` must have equal lengths and be finite. Times must increase strictly and start at 0 or later.
    `owner` is the name of the signal in the error messages.
    """
    if times.shape != values.shape or times.ndim != 1:
        return [InputError("signals.lengths", owner=owner, times=times.size, values=values.size)]
    problems = []
    bad_time = first_bad_time(times, owner)
    if bad_time:
        problems.append(bad_time[1])
    elif times[0] < 0.0:
        problems.append(InputError("signals.before_run", owner=owner, time=float(times[0])))
    invalid = np.flatnonzero(~np.isfinite(values))
    if invalid.size:
        k = int(invalid[0])
        problems.append(InputError("signals.not_finite", owner=owner, place=k, value=float(values[k])))
    return problems


def not_finite(**fields: float) -> list[InputError]:
    """Return an error for each keyword argument that is not a finite number.

    The names of the arguments are the names in the errors.
    """
    return [InputError("numbers.not_finite", name, value=v) for name, v in fields.items() if not _is_finite(v)]


def not_positive(unit: str, **fields: float) -> list[InputError]:
    """Return an error for each keyword argument that is not a finite number above 0.

    The names of the arguments are the names in the errors. `unit` is the unit of all values.
    """
    return [
        InputError("numbers.not_positive", name, value=value, unit=unit)
        for name, value in fields.items()
        if not (_is_finite(value) and value > 0.0)
    ]


def _is_finite(value: float) -> bool:
    return isinstance(value, Real) and math.isfinite(value)
