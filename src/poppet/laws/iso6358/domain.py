"""Valid ranges of the arguments of the flow law.

Symbols are not checked, because their values are unknown while a model is traced. The check costs one comparison for a
float and two reductions for an array.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import OutOfRangeError, raise_errors
from poppet.core.symbolic import is_symbolic


@dataclass(frozen=True)
class Domain:
    """Interval of valid values of an argument.

    `low` is a valid value unless `open_low` is True, and `high` unless `open_high` is True. `code` is the code of the
    error for a value outside the interval.
    """

    code: str
    unit: str
    low: float = 0.0
    high: float = float("inf")
    open_low: bool = False
    open_high: bool = True

    def contains(self, value: Any) -> bool | NDArray[np.bool_]:
        """Return True for a value inside the interval, and False for NaN.

        For an array, the result is an array of booleans.
        """
        is_above = value > self.low if self.open_low else value >= self.low
        is_below = value < self.high if self.open_high else value <= self.high
        is_inside: bool | NDArray[np.bool_] = is_above & is_below
        return is_inside


_PRESSURE = Domain("iso6358.pressure", "Pa")
_TEMPERATURE = Domain("iso6358.temperature", "K", open_low=True)

DOMAINS: dict[str, Domain] = {
    "pressure_1": _PRESSURE,
    "pressure_2": _PRESSURE,
    "temperature_1": _TEMPERATURE,
    "temperature_2": _TEMPERATURE,
    "reference_temperature": _TEMPERATURE,
    "reference_density": Domain("iso6358.reference_density", "kg/m^3", open_low=True),
    "sonic_conductance": Domain("iso6358.sonic_conductance", "m^3/(s Pa)"),
    "critical_ratio": Domain("iso6358.critical_ratio", "", high=1.0),
    # Above 3, the regularised law is not monotone.
    "subsonic_index": Domain("iso6358.subsonic_index", "", high=3.0, open_low=True, open_high=False),
    "cracking_pressure": Domain("iso6358.cracking_pressure", "Pa"),
    "laminar_ratio": Domain("iso6358.laminar_ratio", "", high=1.0, open_low=True),
}


def problem(name: str, value: Any, domain: Domain) -> OutOfRangeError | None:
    """Return an error if a value is outside its valid interval.

    For an array, the error describes the first invalid element. The result is None if there is no error, or if the
    value is a symbol or None. `name` is the name of the argument.
    """
    if type(value) is float:  # fast path for the most frequent type
        return None if domain.contains(value) else _outside(name, value, domain)
    if value is None or is_symbolic(value):
        return None
    values = np.asarray(value, dtype=float)
    # One NaN makes both extremes NaN, so two reductions are sufficient.
    if values.size == 0 or (domain.contains(values.min()) and domain.contains(values.max())):
        return None
    index = np.unravel_index(int(np.argmin(domain.contains(values))), values.shape)
    return _outside(f"{name}{_index(index)}", float(values[index]), domain)


def check(values: dict[str, Any], domains: dict[str, Domain] = DOMAINS) -> None:
    """Raise `OutOfRangeError` if any of several values is outside its valid interval.

    `domains` contains the interval for each value by name. All errors are reported together.
    """
    errors = (problem(name, value, domains[name]) for name, value in values.items())
    raise_errors([error for error in errors if error is not None])


def reject_where(is_invalid: Any, name: str, value: Any, unit: str, code: str) -> None:
    """Raise `OutOfRangeError` if any element of the mask `is_invalid` is True.

    The error has the code `code` and contains the first element of `value` for which the mask is True.
    """
    flags, values = np.broadcast_arrays(np.asarray(is_invalid), np.asarray(value, dtype=float))
    if not flags.any():
        return
    index = np.unravel_index(int(np.argmax(flags)), flags.shape)
    raise OutOfRangeError(code, f"{name}{_index(index)}", value=float(values[index]), unit=unit)


def _index(index: tuple[Any, ...]) -> str:
    return f"[{', '.join(str(i) for i in index)}]" if index else ""


def _outside(name: str, value: float, domain: Domain) -> OutOfRangeError:
    return OutOfRangeError(domain.code, name, value=value, unit=domain.unit)
