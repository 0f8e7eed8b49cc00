"""Where the numbers of a flow law may lie, and what is said when one does not.

Symbols are never checked: their values are unknown when a model is traced. Floats cost a comparison, arrays
two reductions.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.ground.errors import InputError, OutOfRangeError, collect
from poppet.ground.symbolic import is_symbolic


@dataclass(frozen=True)
class Domain:
    """The interval in which one argument may lie, ends included unless `open_low` or `open_high`."""

    unit: str
    low: float
    high: float
    reason: str
    cure: str
    open_low: bool = False
    open_high: bool = True

    def holds(self, value: Any) -> Any:
        """True inside; not-a-number is outside."""
        above = value > self.low if self.open_low else value >= self.low
        below = value < self.high if self.open_high else value <= self.high
        return above & below


_INF = float("inf")

_PRESSURE = Domain(
    "Pa",
    0.0,
    _INF,
    "cannot be: pressures are absolute here, so they are finite and not below zero.",
    "Was a gauge pressure meant? Then add the ambient pressure to it.",
)
_TEMPERATURE = Domain(
    "K",
    0.0,
    _INF,
    "cannot be: temperatures are absolute here, so they are above 0 K.",
    "Was a temperature in degC meant? Then add 273.15.",
    open_low=True,
)
_CONDUCTANCE = Domain(
    "m^3/(s Pa)", 0.0, _INF, "cannot be: a conductance is not below zero.", "Give 0 for a closed passage."
)
_RATIO = Domain(
    "",
    0.0,
    1.0,
    "cannot be: the critical pressure ratio lies in 0 <= b < 1 (ISO 6358-1, definition of b).",
    "Typical components have 0.1 to 0.53.",
)
_INDEX = Domain(
    "",
    0.0,
    3.0,
    "cannot be: the subsonic index must be above 0, and above 3 the regularised law is no longer monotone.",
    "Use 0.5 (the 1989 edition) unless a test gave another value.",
    open_low=True,
    open_high=False,
)
_CRACKING = Domain(
    "Pa", 0.0, _INF, "cannot be: a cracking pressure is a difference not below zero.", "Give 0 for none."
)
_LAMINAR = Domain(
    "",
    0.0,
    1.0,
    "cannot be: the regularised zone runs from this pressure ratio to 1, so it lies between 0 and 1.",
    "Use 0.999 (default); 0.995 is less stiff and less exact.",
    open_low=True,
)

DOMAINS: dict[str, Domain] = {
    "pressure_1": _PRESSURE,
    "pressure_2": _PRESSURE,
    "temperature_1": _TEMPERATURE,
    "temperature_2": _TEMPERATURE,
    "reference_temperature": _TEMPERATURE,
    "reference_density": Domain(
        "kg/m^3", 0.0, _INF, "cannot be: a density is above zero.", "ANR has 1.185 (ISO 8778).", open_low=True
    ),
    "sonic_conductance": _CONDUCTANCE,
    "critical_ratio": _RATIO,
    "subsonic_index": _INDEX,
    "cracking_pressure": _CRACKING,
    "laminar_ratio": _LAMINAR,
}


def positive(unit: str, meaning: str) -> Domain:
    """The domain of a quantity that must be above zero; `meaning` completes "cannot be: ..."."""
    return Domain(unit, 0.0, _INF, f"cannot be: {meaning}", "Give a value above zero.", open_low=True)


def not_negative(unit: str, meaning: str) -> Domain:
    """The domain of a quantity that must not be below zero."""
    return Domain(unit, 0.0, _INF, f"cannot be: {meaning}", "Give zero or a value above it.")


def problem(name: str, value: Any, domain: Domain) -> OutOfRangeError | None:
    """The mistake in `value`, or None; for an array the first element outside is named."""
    if type(value) is float:  # by far the most frequent: no further questions
        return None if domain.holds(value) else _outside(name, value, domain)
    if value is None or is_symbolic(value):
        return None
    values = np.asarray(value, dtype=float)
    if values.size == 0 or (domain.holds(values.min()) and domain.holds(values.max())):
        return None
    where = np.unravel_index(int(np.argmin(domain.holds(values))), values.shape)
    index = f"[{', '.join(str(i) for i in where)}]" if where else ""
    return _outside(f"{name}{index}", float(values[where]), domain)


def check(values: dict[str, Any], domains: dict[str, Domain] = DOMAINS) -> None:
    """Raise `OutOfRangeError` for every value outside the domain of its name, all at once."""
    problems: list[InputError] = []
    for name, value in values.items():
        found = problem(name, value, domains[name])
        if found is not None:
            problems.append(found)
    collect(problems)


def refuse_where(bad: Any, name: str, value: Any, unit: str, reason: str, cure: str) -> None:
    """Raise `OutOfRangeError` for the first element at which `bad` is true."""
    flags, values = np.broadcast_arrays(np.asarray(bad), np.asarray(value, dtype=float))
    if not flags.any():
        return
    where = np.unravel_index(int(np.argmax(flags)), flags.shape)
    index = f"[{', '.join(str(i) for i in where)}]" if where else ""
    raise OutOfRangeError(f"{name}{index} = {float(values[where]):.6g} {unit}".rstrip(), reason, cure)


def _outside(name: str, value: float, domain: Domain) -> OutOfRangeError:
    return OutOfRangeError(f"{name} = {value:.6g} {domain.unit}".rstrip(), domain.reason, domain.cure)
