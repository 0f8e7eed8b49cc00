"""Where the numbers of a flow law may lie, and what is said when one does not.

Symbols are never checked: their values are unknown when a model is traced. Floats cost a comparison, arrays
two reductions.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.core.errors import OutOfRangeError, collect
from poppet.core.symbolic import is_symbolic


@dataclass(frozen=True)
class Domain:
    """The interval in which one argument may lie, ends included unless `open_low` or `open_high`.

    `code` names the mistake of a value outside: what is wrong with it and what to do.
    """

    code: str
    unit: str
    low: float = 0.0
    high: float = float("inf")
    open_low: bool = False
    open_high: bool = True

    def holds(self, value: Any) -> Any:
        """True inside; not-a-number is outside."""
        above = value > self.low if self.open_low else value >= self.low
        below = value < self.high if self.open_high else value <= self.high
        return above & below


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
    # Above 3 the regularised law would no longer be monotone.
    "subsonic_index": Domain("iso6358.subsonic_index", "", high=3.0, open_low=True, open_high=False),
    "cracking_pressure": Domain("iso6358.cracking_pressure", "Pa"),
    "laminar_ratio": Domain("iso6358.laminar_ratio", "", high=1.0, open_low=True),
}


def problem(name: str, value: Any, domain: Domain) -> OutOfRangeError | None:
    """The mistake in `value`, or None; for an array the first element outside is named."""
    if type(value) is float:  # by far the most frequent: no further questions
        return None if domain.holds(value) else _outside(name, value, domain)
    if value is None or is_symbolic(value):
        return None
    values = np.asarray(value, dtype=float)
    # One element that is not a number makes both extremes so: two reductions find it as well.
    if values.size == 0 or (domain.holds(values.min()) and domain.holds(values.max())):
        return None
    where = np.unravel_index(int(np.argmin(domain.holds(values))), values.shape)
    return _outside(f"{name}{_index(where)}", float(values[where]), domain)


def check(values: dict[str, Any], domains: dict[str, Domain] = DOMAINS) -> None:
    """Raise `OutOfRangeError` for every value outside the domain of its name, all at once."""
    found = (problem(name, value, domains[name]) for name, value in values.items())
    collect([each for each in found if each is not None])


def refuse_where(bad: Any, name: str, value: Any, unit: str, code: str) -> None:
    """Raise `OutOfRangeError` for the first element at which `bad` is true."""
    flags, values = np.broadcast_arrays(np.asarray(bad), np.asarray(value, dtype=float))
    if not flags.any():
        return
    where = np.unravel_index(int(np.argmax(flags)), flags.shape)
    raise OutOfRangeError(code, f"{name}{_index(where)}", value=float(values[where]), unit=unit)


def _index(where: tuple[Any, ...]) -> str:
    return f"[{', '.join(str(i) for i in where)}]" if where else ""


def _outside(name: str, value: float, domain: Domain) -> OutOfRangeError:
    return OutOfRangeError(domain.code, name, value=value, unit=domain.unit)
