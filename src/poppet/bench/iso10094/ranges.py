"""Reading of full scale, setpoint range and other settings."""

from __future__ import annotations

import math
from contextlib import suppress
from typing import Any

from poppet.bench.iso10094.scale import Scale
from poppet.core.errors import InputError
from poppet.core.units import Quantity, quantity

ELECTRIC = {"V": (0.0, 10.0), "A": (0.004, 0.020), "1": (0.0, 1.0)}
"""Usual ranges of setpoints that are no pressures, by their SI unit."""


def pressure(raw: Any, ambient: float, name: str) -> float:
    """Return an absolute pressure from its text.

    Examples
    --------
    >>> pressure("6 bar g", 1e5, "supply")
    700000.0
    """
    value = _absolute(quantity(raw, "Pa", kind="pressure", name=name), ambient)
    if value < 0.0:
        raise InputError("bench.range.vacuum", name, given=raw)
    return value


def _absolute(read: Quantity, ambient: float) -> float:
    return read.value + (ambient if read.reference == "gauge" else 0.0)


def pressure_range(raw: Any, ambient: float, name: str = "full_scale") -> tuple[float, float]:
    """Return a pressure range from both ends, or from its upper end above ambient.

    Examples
    --------
    >>> pressure_range("6 bar g", 1e5), pressure_range(["1 bar g", "6 bar g"], 1e5)
    ((100000.0, 700000.0), (200000.0, 700000.0))
    """
    parts = [part.strip() for part in raw.split(",")] if isinstance(raw, str) else raw
    parts = parts if isinstance(parts, list | tuple) else [parts]
    if len(parts) not in (1, 2):
        raise InputError("bench.range.ends", name, given=raw)
    low, high = [ambient, *(pressure(part, ambient, name) for part in parts)][-2:]
    if low >= high:
        raise InputError("bench.range.falls", name, given=raw)
    return low, high


def setpoint_scale(raw: Any, full_scale: tuple[float, float], ambient: float, unit: str = "Pa") -> Scale:
    """Return the scale for a setpoint range and a full scale.

    Examples
    --------
    >>> setpoint_scale(["0 V", "10 V"], (1e5, 7e5), 1e5).setpoint_unit
    'V'
    """
    if raw is None:
        low, high = full_scale if unit == "Pa" else ELECTRIC[unit]
        return Scale(low, high, unit, *full_scale)
    if not isinstance(raw, list | tuple) or len(raw) != 2:
        raise InputError("bench.range.setpoint", "setpoint_range", given=raw)
    (low, unit), (high, high_unit) = (_setpoint(end, ambient) for end in raw)
    if unit != high_unit:
        raise InputError("bench.range.two_quantities", "setpoint_range", given=raw)
    return Scale(low, high, unit, *full_scale)


def _setpoint(raw: Any, ambient: float) -> tuple[float, str]:
    """Return value and SI unit of a setpoint, for the first matching quantity."""
    problem: InputError | None = None
    for unit in ("Pa", *ELECTRIC) if isinstance(raw, str) else ("1",):
        try:
            read = quantity(raw, unit, kind="pressure" if unit == "Pa" else "plain", name="setpoint_range")
        except InputError as error:
            problem = problem or error
        else:
            return _absolute(read, ambient), unit
    assert problem is not None
    raise problem


def listed(raw: str, unit: str, name: str) -> tuple[float, ...]:
    """Return the positive values of a list, `"1 l, 5 l"`.

    Examples
    --------
    >>> listed("1 l, 5 l", "m^3", "--volume")
    (0.001, 0.005)
    """
    values = []
    for part in raw.split(","):
        number: Any = (text := part.strip())
        with suppress(ValueError):  # a bare number is in the SI unit
            number = float(text)
        value = quantity(number, unit, name=name).value
        if not (math.isfinite(value) and value > 0.0):
            raise InputError("bench.range.not_positive", name, given=text)
        values.append(value)
    return tuple(values)
