"""Checks of time bases, series and their headings, shared by signals and recordings."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from numbers import Real

import numpy as np
from numpy.typing import ArrayLike, NDArray

from poppet.core.errors import InputError, NameSuggestion

FloatArray = NDArray[np.float64]
METADATA = "poppet"
"""The variable, or key, under which a recording keeps what a table of numbers cannot hold, as JSON."""

_HEADING = re.compile(r"\s*(?P<name>[^\[\]]*?)\s*(?:\[(?P<unit>[^\[\]]*)\])?\s*")


def split_heading(heading: str) -> tuple[str, str]:
    """Name and unit of a column heading.

    Examples
    --------
    >>> split_heading("tank.pressure [Pa]")
    ('tank.pressure', 'Pa')
    """
    found = _HEADING.fullmatch(heading)
    if found is None or not found["name"]:
        raise InputError("series.heading", heading=heading)
    return found["name"], (found["unit"] or "").strip()


def numbers(name: str, series: ArrayLike) -> FloatArray:
    """A series as an array of its own."""
    try:
        return np.array(series, dtype=float)
    except (TypeError, ValueError) as problem:
        raise InputError("series.numbers", name=name, series=f"{series!r:.60}") from problem


def first_bad_time(time: FloatArray, owner: str = "") -> tuple[int, InputError] | None:
    """The first sample that breaks a time base, with what is wrong about it; `owner` is whose times they are."""
    if time.ndim != 1 or not time.size:
        return 0, InputError("series.time.shape", owner=owner, shape=time.shape)
    bad = np.flatnonzero(~np.isfinite(time))
    if bad.size:
        k = int(bad[0])
        return k, InputError("series.time.not_finite", owner=owner, place=k, time=float(time[k]))
    bad = np.flatnonzero(np.diff(time) <= 0.0)
    if not bad.size:
        return None
    k = int(bad[0])
    first, then = float(time[k]), float(time[k + 1])
    problem = InputError("series.time.not_increasing", owner=owner, place=k, after=k + 1, time=first, next=then)
    return k + 1, problem


def name_problems(names: tuple[str, ...], units: Iterable[str]) -> list[InputError]:
    """Names given twice, and units of names that are not there."""
    twice = [name for name in dict.fromkeys(names) if names.count(name) > 1]
    unnamed = [name for name in units if name not in names]
    return [InputError("series.twice", name=name) for name in twice] + [
        InputError("series.no_unit_of", name=name, near=NameSuggestion(name, names)) for name in unnamed
    ]


def path_problems(owner: str, times: FloatArray, values: FloatArray) -> list[InputError]:
    """What is wrong with a signal given by points."""
    if times.shape != values.shape or times.ndim != 1:
        return [InputError("signals.lengths", owner=owner, times=times.size, values=values.size)]
    problems = []
    bad_time = first_bad_time(times, owner)
    if bad_time:
        problems.append(bad_time[1])
    elif times[0] < 0.0:
        problems.append(InputError("signals.before_run", owner=owner, time=float(times[0])))
    bad = np.flatnonzero(~np.isfinite(values))
    if bad.size:
        k = int(bad[0])
        problems.append(InputError("signals.not_finite", owner=owner, place=k, value=float(values[k])))
    return problems


def not_finite(**fields: float) -> list[InputError]:
    """Fields that are infinite or no number."""
    return [
        InputError("numbers.not_finite", name, value=value) for name, value in fields.items() if not _is_finite(value)
    ]


def not_positive(unit: str, **fields: float) -> list[InputError]:
    """Fields that are not above zero."""
    return [
        InputError("numbers.not_positive", name, value=value, unit=unit)
        for name, value in fields.items()
        if not (_is_finite(value) and value > 0.0)
    ]


def _is_finite(value: float) -> bool:
    return isinstance(value, Real) and math.isfinite(value)
