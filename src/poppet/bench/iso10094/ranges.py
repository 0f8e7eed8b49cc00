"""Full scale, setpoint range and other choices as people write them."""

from __future__ import annotations

import math
from contextlib import suppress
from typing import Any

from poppet.bench.iso10094.scale import Scale
from poppet.core.errors import InputError
from poppet.core.units import Quantity, quantity

ELECTRIC = {"V": (0.0, 10.0), "A": (0.004, 0.020), "1": (0.0, 1.0)}
"""Usual ranges of setpoints that are no pressures, by their SI unit."""


def pressure(given: Any, ambient: float, name: str) -> float:
    """A pressure as it is written.

    Examples
    --------
    >>> pressure("6 bar g", 1e5, "supply")
    700000.0
    """
    value = _absolute(quantity(given, "Pa", kind="pressure", name=name), ambient)
    if value < 0.0:
        raise InputError("bench.range.vacuum", name, given=given)
    return value


def _absolute(read: Quantity, ambient: float) -> float:
    return read.value + (ambient if read.reference == "gauge" else 0.0)


def pressure_range(given: Any, ambient: float, name: str = "full_scale") -> tuple[float, float]:
    """A range of pressures: both ends, or its upper end above the ambient pressure.

    Examples
    --------
    >>> pressure_range("6 bar g", 1e5), pressure_range(["1 bar g", "6 bar g"], 1e5)
    ((100000.0, 700000.0), (200000.0, 700000.0))
    """
    parts = [part.strip() for part in given.split(",")] if isinstance(given, str) else given
    parts = parts if isinstance(parts, list | tuple) else [parts]
    if len(parts) not in (1, 2):
        raise InputError("bench.range.ends", name, given=given)
    low, high = [ambient, *(pressure(part, ambient, name) for part in parts)][-2:]
    if low >= high:
        raise InputError("bench.range.falls", name, given=given)
    return low, high


def setpoint_scale(given: Any, full_scale: tuple[float, float], ambient: float, unit: str = "Pa") -> Scale:
    """The scale of a setpoint range and a full scale.

    Examples
    --------
    >>> setpoint_scale(["0 V", "10 V"], (1e5, 7e5), 1e5).setpoint_unit
    'V'
    """
    if given is None:
        low, high = full_scale if unit == "Pa" else ELECTRIC[unit]
        return Scale(low, high, unit, *full_scale)
    if not isinstance(given, list | tuple) or len(given) != 2:
        raise InputError("bench.range.setpoint", "setpoint_range", given=given)
    (low, unit), (high, other) = (_setpoint(each, ambient) for each in given)
    if unit != other:
        raise InputError("bench.range.two_quantities", "setpoint_range", given=given)
    return Scale(low, high, unit, *full_scale)


def _setpoint(given: Any, ambient: float) -> tuple[float, str]:
    """Value and SI unit of a setpoint: of the first quantity that it can be read as."""
    problem: InputError | None = None
    for unit in ("Pa", *ELECTRIC) if isinstance(given, str) else ("1",):
        try:
            read = quantity(given, unit, kind="pressure" if unit == "Pa" else "plain", name="setpoint_range")
        except InputError as error:
            problem = problem or error
        else:
            return _absolute(read, ambient), unit
    assert problem is not None
    raise problem


def listed(given: str, unit: str, name: str) -> tuple[float, ...]:
    """Positive values of a list, `"1 l, 5 l"`.

    Examples
    --------
    >>> listed("1 l, 5 l", "m^3", "--volume")
    (0.001, 0.005)
    """
    values = []
    for part in given.split(","):
        number: Any = (text := part.strip())
        with suppress(ValueError):  # a bare number is in the SI unit
            number = float(text)
        value = quantity(number, unit, name=name).value
        if not (math.isfinite(value) and value > 0.0):
            raise InputError("bench.range.not_positive", name, given=text)
        values.append(value)
    return tuple(values)
