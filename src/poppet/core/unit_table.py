"""Table of units, and reader of unit expressions.

Products by a space, `*` or `.`, division by `/`, powers by `^` or `**` with integer or fractional exponents,
parentheses. Factors are exact rational numbers, so that a conversion is rounded once.
"""

from __future__ import annotations

import difflib
import math
import re
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from poppet.core.errors import UnitError

Dimension = tuple[Fraction, ...]  # exponents of m, kg, s, K, A, rad; the angle keeps rad/s apart from Hz


@dataclass(frozen=True, slots=True)
class Unit:
    """Unit of measurement: value in SI = scale * (value + offset).

    Parameters
    ----------
    dimension : tuple of Fraction
        Exponents of m, kg, s, K, A, rad.
    scale : Fraction
        Factor to the SI unit.
    offset : Fraction, optional
        Value that is added before the multiplication, for example 273.15 for degC.
    """

    dimension: Dimension
    scale: Fraction
    offset: Fraction = Fraction(0)


def _dimension(*exponents: int) -> Dimension:
    return tuple(Fraction(exponent) for exponent in (*exponents, *(0,) * (6 - len(exponents))))


ONE = _dimension()
_LENGTH, _MASS, _TIME, _TEMPERATURE, _CURRENT, _ANGLE = (_dimension(*(0,) * k, 1) for k in range(6))
_VOLUME, _FREQUENCY = _dimension(3), _dimension(0, 0, -1)
_FORCE, PRESSURE = _dimension(1, 1, -2), _dimension(-1, 1, -2)
_ENERGY, _POWER, _VOLTAGE = _dimension(2, 1, -2), _dimension(2, 1, -3), _dimension(2, 1, -3, 0, -1)
VOLUME_FLOW, MASS_FLOW = _dimension(3, 0, -1), _dimension(0, 1, -1)
CONDUCTANCE = _dimension(4, -1, 1)  # m^3/(s Pa)

_PREFIXES = {"G": 9, "M": 6, "k": 3, "h": 2, "d": -1, "c": -2, "m": -3, "u": -6, "n": -9, "": 0}

# symbol: (dimension, factor to SI, prefixes in use). Factors are exact definitions unless a source is named.
_SYMBOLS: dict[str, tuple[Dimension, str | Fraction, str]] = {
    "m": (_LENGTH, "1", "kdcmun"),
    "in": (_LENGTH, "0.0254", ""),
    "l": (_VOLUME, "0.001", "hdcmu"),
    "L": (_VOLUME, "0.001", "dcmu"),
    "s": (_TIME, "1", "mun"),
    "min": (_TIME, "60", ""),
    "h": (_TIME, "3600", ""),
    "Hz": (_FREQUENCY, "1", "kM"),
    "g": (_MASS, "0.001", "kmu"),
    "t": (_MASS, "1000", ""),
    "N": (_FORCE, "1", "mkM"),
    "Pa": (PRESSURE, "1", "GMkhm"),
    "bar": (PRESSURE, "100000", "m"),
    "atm": (PRESSURE, "101325", ""),
    "torr": (PRESSURE, Fraction(101325, 760), ""),
    "psi": (PRESSURE, Fraction("0.45359237") * Fraction("9.80665") / Fraction("0.0254") ** 2, ""),
    "cmH2O": (PRESSURE, "98.0665", ""),  # conventional centimetre of water, NIST SP 811, appendix B
    "inHg": (PRESSURE, "3386.389", ""),  # conventional inch of mercury, NIST SP 811, appendix B
    "J": (_ENERGY, "1", "mkM"),
    "Nm": (_ENERGY, "1", "mk"),  # a torque, as its sensors write it
    "Wh": (_ENERGY, "3600", "kMG"),
    "W": (_POWER, "1", "mkM"),
    "K": (_TEMPERATURE, "1", "m"),
    "rad": (_ANGLE, "1", "m"),
    "deg": (_ANGLE, Fraction(math.pi) / 180, ""),
    "rpm": (_dimension(0, 0, -1, 0, 0, 1), Fraction(math.pi) / 30, ""),
    "V": (_VOLTAGE, "1", "umk"),
    "A": (_CURRENT, "1", "um"),
    "%": (ONE, "0.01", ""),
}


def _table() -> dict[str, Unit]:
    table = {
        prefix + symbol: Unit(dimension, Fraction(factor) * Fraction(10) ** _PREFIXES[prefix])
        for symbol, (dimension, factor, prefixes) in _SYMBOLS.items()
        for prefix in ("", *prefixes)
    }
    table["degC"] = Unit(_TEMPERATURE, Fraction(1), Fraction("273.15"))
    table["degF"] = Unit(_TEMPERATURE, Fraction(5, 9), Fraction("459.67"))
    return table


TABLE = _table()

# Spellings of instruments in column headings.
SPELLINGS = str.maketrans({"°": "deg", "µ": "u", "μ": "u", "²": "^2", "³": "^3", "·": "*"})


_TOKEN = re.compile(r"\s*(\*\*|[A-Za-z%][A-Za-z0-9_%]*|\d+(?:\.\d+)?|[*./^()+-])")
_LONGEST = 100  # characters; a unit is short, and a limit keeps hostile input cheap
_LARGEST_EXPONENT = 12
_LARGEST_DECADE = 200  # of a factor, so that no power of ten overflows a float


def read_unit(text: str) -> Unit:
    """Read a unit expression; `-` alone is a ratio.

    Parameters
    ----------
    text : str
        For example `m^3/(s Pa)`.

    Returns
    -------
    Unit

    Raises
    ------
    UnitError
        If the expression is invalid or contains an unknown symbol.

    Examples
    --------
    >>> read_unit("l/min").scale
    Fraction(1, 60000)
    """
    return Unit(ONE, Fraction(1)) if text == "-" else _Expression(text).read()


class _Expression:
    """Parser of one unit expression, from left to right."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens: list[str] = []
        self.at = 0
        if len(text) > _LONGEST:
            raise UnitError("unit.too_long", start=text[:20], limit=_LONGEST)
        end = len(text.rstrip())
        position = 0
        while position < end:
            match = _TOKEN.match(text, position)
            if match is None:
                raise UnitError("unit.character", unit=text, character=text[position:].strip()[0])
            self.tokens.append(match.group(1))
            position = match.end()

    def read(self) -> Unit:
        unit = self.product()
        if self.next is not None:
            raise self.refused("unit.unreadable", at=self.next)
        return unit

    @property
    def next(self) -> str | None:
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def take(self) -> str:
        token = self.next
        if token is None:
            raise self.refused("unit.ends_early")
        self.at += 1
        return token

    def refused(self, code: str, **facts: Any) -> UnitError:
        return UnitError(code, unit=self.text, **facts)

    def product(self) -> Unit:
        unit, divided = self.power(), False
        while self.next not in (None, ")"):
            operator = self.take() if self.next in ("*", ".", "/") else "*"
            # J/kg K is ambiguous: J/(kg K) or (J/kg) K; a/b/c is not.
            if divided and operator != "/":
                raise self.refused("unit.two_ways")
            divided = operator == "/"
            unit = self.times(unit, self.power(), Fraction(-1 if divided else 1))
        return unit

    def power(self) -> Unit:
        unit = self.factor()
        if self.next not in ("^", "**"):
            return unit
        self.take()
        return self.times(Unit(ONE, Fraction(1)), unit, self.exponent())

    def factor(self) -> Unit:
        token = self.take()
        if token == "(":
            unit = self.product()
            self.take()  # a product ends at a parenthesis or at the end, which `take` refuses
            return unit
        if token == "1":
            return Unit(ONE, Fraction(1))
        if token in TABLE:
            return TABLE[token]
        if token[0].isalpha():
            raise _unknown_symbol_error(self.text, token)
        raise self.refused("unit.unreadable", at=token)

    def exponent(self) -> Fraction:
        token = self.take()
        if token == "(":
            value = self.exponent()
            if self.next == "/":
                self.take()
                divisor = self.exponent()
                if not divisor:
                    raise self.refused("unit.exponent_by_zero")
                value /= divisor
            if self.take() != ")":
                raise self.refused("unit.parenthesis")
            return value
        if token in ("+", "-"):
            return self.exponent() * (-1 if token == "-" else 1)
        if not token[0].isdigit():
            raise self.refused("unit.exponent", exponent=token)
        return Fraction(token)

    def times(self, unit: Unit, factor: Unit, exponent: Fraction) -> Unit:
        """Return the unit that results from `unit * factor**exponent`.

        The result is exact if the exponent is an integer.
        """
        if unit.offset or factor.offset:
            raise self.refused("unit.scale_in_product")
        # Looked at before the power is taken: ((mm^12)^12)^12 would be a number of thousands of digits.
        decades = abs(_decades(unit.scale) + _decades(factor.scale) * float(exponent))
        dimension = tuple(a + b * exponent for a, b in zip(unit.dimension, factor.dimension, strict=True))
        if decades > _LARGEST_DECADE or max(map(abs, (*dimension, exponent))) > _LARGEST_EXPONENT:
            raise self.refused("unit.too_high")
        return Unit(dimension, unit.scale * Fraction(factor.scale**exponent))


def _decades(scale: Fraction) -> float:
    return math.log10(scale.numerator) - math.log10(scale.denominator)


_MEANT = {"C": "degC", "F": "degF", "sec": "s", "lpm": "l/min", "liter": "l", "litre": "l"}


def _unknown_symbol_error(text: str, symbol: str) -> UnitError:
    """Return the error for a symbol that is not a unit.

    The error contains the most specific hint that is available, for example a similar unit.
    """
    facts: dict[str, Any] = {"unit": text, "symbol": symbol}
    powered = re.fullmatch(r"([A-Za-z]+)([2-6])", symbol)
    if powered and powered[1] in TABLE:
        return UnitError("unit.power", base=powered[1], exponent=powered[2], **facts)
    if symbol[0] == "N" and symbol[1:] in TABLE:  # Nl/min: a normal litre, not a newton
        return UnitError("unit.normal", base=symbol[1:], **facts)
    same_letters = [symbol_of_table for symbol_of_table in TABLE if symbol_of_table.lower() == symbol.lower()]
    similar = [_MEANT[symbol]] if symbol in _MEANT else same_letters or difflib.get_close_matches(symbol, TABLE)
    return (
        UnitError("unit.misspelt", suggestion=tuple(similar), **facts)
        if similar
        else UnitError("unit.unknown", **facts)
    )
