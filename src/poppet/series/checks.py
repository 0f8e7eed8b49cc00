"""Checks of time bases, series and their headings, shared by signals and recordings."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from numbers import Real

import numpy as np
from numpy.typing import ArrayLike, NDArray

from poppet.ground.errors import InputError, suggestion

FloatArray = NDArray[np.float64]

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
        raise InputError(f"heading {heading!r}", "is not a name with a unit.", 'Write "tank.pressure [Pa]".')
    return found["name"], (found["unit"] or "").strip()


def numbers(name: str, series: ArrayLike) -> FloatArray:
    """A series as an array of its own."""
    try:
        return np.array(series, dtype=float)
    except (TypeError, ValueError) as problem:
        raise InputError(f"{name} = {series!r:.60}", "is not a series of numbers.", "Give numbers only.") from problem


def first_bad_time(time: FloatArray) -> tuple[int, InputError] | None:
    """The first sample that breaks a time base."""
    if time.ndim != 1 or not time.size:
        given = f"time of shape {time.shape}"
        return 0, InputError(given, "is not a series of times.", "Give one or more times in a row.")
    bad = np.flatnonzero(~np.isfinite(time))
    if bad.size:
        k = int(bad[0])
        return k, InputError(f"time[{k}] = {time[k]} s", "is not finite.", "Remove that sample.")
    bad = np.flatnonzero(np.diff(time) <= 0.0)
    if not bad.size:
        return None
    k = int(bad[0])
    given = f"time[{k}] = {time[k]:.12g} s and time[{k + 1}] = {time[k + 1]:.12g} s"
    return k + 1, InputError(given, "do not increase.", "Sort the samples and keep one per time.")


def name_problems(names: tuple[str, ...], units: Mapping[str, str]) -> list[InputError]:
    """Names given twice, and units of names that are not there."""
    problems = [
        InputError(f"series {name!r}", "is given twice.", "Rename or remove one.")
        for name in dict.fromkeys(names)
        if names.count(name) > 1
    ]
    problems += [
        InputError(f"unit of {name!r}", "belongs to no series.", suggestion(name, names))
        for name in units
        if name not in names
    ]
    return problems


def length_problems(time: FloatArray, names: tuple[str, ...], rows: Sequence[FloatArray]) -> list[InputError]:
    """Series that do not fit their time base."""
    return [
        InputError(
            f"series {name!r} of shape {row.shape}",
            f"does not fit the {time.size} times.",
            "Give one value per time.",
        )
        for name, row in zip(names, rows, strict=True)
        if row.shape != time.shape
    ]


def path_problems(name: str, times: FloatArray, values: FloatArray) -> list[InputError]:
    """What is wrong with a signal given by points."""
    if times.shape != values.shape or times.ndim != 1:
        given = f"{name}: {times.size} times and {values.size} values"
        return [InputError(given, "do not belong together.", "Give one value per time.")]
    problems = []
    bad_time = first_bad_time(times)
    if bad_time:
        problems.append(bad_time[1])
    elif times[0] < 0.0:
        given = f"time[0] = {times[0]:.12g} s"
        problems.append(InputError(given, "lies before the run, which begins at 0 s.", "Shift the times."))
    bad = np.flatnonzero(~np.isfinite(values))
    if bad.size:
        given = f"value[{bad[0]}] = {values[bad[0]]}"
        problems.append(InputError(given, "is not finite.", "Remove it or mend it."))
    return [InputError(f"{name}: {problem.given}", problem.reason, problem.cure) for problem in problems]


def not_finite(**fields: float) -> list[InputError]:
    """Fields that are infinite or no number."""
    return [
        InputError(f"{name} = {value!r}", "is not a finite number.", "Give a number in SI units.")
        for name, value in fields.items()
        if not _is_finite(value)
    ]


def not_positive(unit: str, **fields: float) -> list[InputError]:
    """Fields that are not above zero."""
    return [
        InputError(f"{name} = {value!r} {unit}", "is not positive.", f"Give more than 0 {unit}.")
        for name, value in fields.items()
        if not (_is_finite(value) and value > 0.0)
    ]


def _is_finite(value: float) -> bool:
    return isinstance(value, Real) and math.isfinite(value)
