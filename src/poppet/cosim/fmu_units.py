"""Units of FMU variables in SI units of circuits."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache

from poppet.core.units import exact_scale, is_known

BASE = ("m", "kg", "s", "K", "A", "rad")
"""Base units in the order of the dimensions of `poppet.core.units`."""
SI_UNITS = (
    "1", "m", "m^2", "m^3", "kg", "s", "m/s", "m/s^2", "N", "N m", "J", "Pa", "W", "kg/s", "m^3/s", "kg/m^3", "K",
    "W/K", "J/K", "J/kg", "J/(kg K)", "W/(m^2 K)", "N/m", "N s/m", "rad", "rad/s", "rad/s^2", "Hz", "Pa/s", "Pa s",
    "K/s", "V", "A", "m^3/(s Pa)", "kg m^2", "N m/rad", "N m s/rad", "1/Pa", "1/m",
)  # fmt: skip
"""Units of the outputs and inputs of parts; FMU variables have the first unit of their dimension."""


@dataclass(frozen=True)
class FmuUnit:
    """Unit of an FMU variable: value in SI = factor * value + offset.

    `name` is the name of the SI unit in circuits.
    """

    name: str
    factor: float = 1.0
    offset: float = 0.0

    def to_si(self, value: float) -> float:
        """Convert a value of the FMU to SI."""
        return self.factor * value + self.offset

    def from_si(self, value: float) -> float:
        """Convert a value in SI to that of the FMU."""
        return (value - self.offset) / self.factor

    def difference(self) -> FmuUnit:
        """Return the unit for differences, such as those of temperatures."""
        return FmuUnit(self.name, self.factor)


NUMBER = FmuUnit("1")


def unit_of_text(text: str) -> FmuUnit:
    """Return the unit that a text such as `bar` or `m^3/(s Pa)` states; an unknown unit raises a UnitError."""
    scale, _ = exact_scale(text)
    factor = float(scale.scale)
    return FmuUnit(_si_name(scale.dimension, text), factor, float(scale.scale * scale.offset))


def unit_of_description(name: str, exponents: Mapping[str, str] | None) -> FmuUnit:
    """Return the unit of the element `Unit` with a name and the attributes of its `BaseUnit`.

    A unit without a `BaseUnit` has the meaning of its name in poppet. If poppet does not know the unit, its values
    are numbers.
    """
    text = name.replace(".", " ")
    if exponents is None:
        return unit_of_text(text) if is_known(text) else NUMBER
    if any(int(exponents.get(base, 0)) for base in ("mol", "cd")):
        return NUMBER
    dimension = tuple(Fraction(int(exponents.get(base, 0))) for base in BASE)
    factor, offset = (float(exponents.get(key, value)) for key, value in (("factor", 1.0), ("offset", 0.0)))
    return FmuUnit(_si_name(dimension, text), factor, offset)


def _si_name(dimension: tuple[Fraction, ...], text: str) -> str:
    """Return the SI unit of a dimension; a text that is such a unit itself distinguishes N m and J."""
    names = _names().get(dimension, ())
    if text in names:
        return text
    if names:
        return names[0]
    over = " ".join(_power(base, e) for base, e in zip(BASE, dimension, strict=True) if e > 0) or "1"
    under = [_power(base, -e) for base, e in zip(BASE, dimension, strict=True) if e < 0]
    return f"{over}/({' '.join(under)})" if len(under) > 1 else f"{over}/{under[0]}" if under else over


def _power(base: str, exponent: Fraction) -> str:
    return base if exponent == 1 else f"{base}^{exponent}"


@cache
def _names() -> dict[tuple[Fraction, ...], tuple[str, ...]]:
    names: dict[tuple[Fraction, ...], tuple[str, ...]] = {}
    for unit in SI_UNITS:
        scale, _ = exact_scale(unit)
        names[scale.dimension] = (*names.get(scale.dimension, ()), unit)
    return names
