"""Formatting of values as text: units, digits, uncertainties and infinite values."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence

ROUNDING = 1e-12
"""Fraction of the largest value of a series below which a table shows 0."""
USUAL = {
    "Pa": "bar",
    "K": "degC",
    "m": "mm",
    "m^2": "mm^2",
    "m^3": "l",
    "m/s": "mm/s",
    "kg": "g",
    "kg/s": "g/s",
    "m^3/(s Pa)": "dm^3/(s bar)",
    "m^3/s ANR": "l/min ANR",
    "1/Pa": "1/bar",
    "Pa s": "bar s",
    "Pa s^2": "bar s^2",
}
"""Usual unit of figures, tables and terminals for each SI unit; other units stay SI."""

# Display units of each SI unit with their smallest size in SI, for sizes that differ by decades.
_LADDERS: dict[str, tuple[tuple[str, float], ...]] = {
    "Pa": (("Pa", 0.0), ("kPa", 1e3), ("bar", 1e4)),
    "m": (("um", 0.0), ("mm", 1e-5), ("m", 0.1)),
    "m^2": (("mm^2", 0.0), ("cm^2", 1e-3), ("m^2", 0.01)),
    "m^3": (("cm^3", 0.0), ("l", 1e-3), ("m^3", 0.1)),
    "kg": (("g", 0.0), ("kg", 0.1)),
    "kg/s": (("mg/s", 0.0), ("g/s", 1e-5), ("kg/s", 0.1)),
    "s": (("ms", 0.0), ("s", 0.1), ("min", 1800.0), ("h", 14400.0)),
    "m/s": (("mm/s", 0.0), ("m/s", 0.1)),
    "m^3/(s Pa)": (("cm^3/(s bar)", 0.0), ("dm^3/(s bar)", 1e-10)),
    "N/Pa": (("N/bar", 0.0),),
    "m^3/s ANR": (("l/min ANR", 0.0),),
}
_NO_CHARACTERS = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff\ufffe\uffff]")
_SMALLEST_PLAIN, _LARGEST_PLAIN = 1e-6, 1e6
"""Errors between which a value is written without an exponent."""


def printable(text: str) -> str:
    """Return a text in which each control character is replaced.

    Examples
    --------
    >>> printable("a\\x1b[31m\\tb") == "a\\ufffd[31m\\tb"
    True
    """
    return _NO_CHARACTERS.sub("\ufffd", text)


def readable_unit(unit: str, *sizes: float) -> str:
    """Return the display unit that suits the largest of several values.

    `unit` is the SI unit of the values.

    Examples
    --------
    >>> readable_unit("Pa", 7e5), readable_unit("Pa", 4500.0), readable_unit("m^3/(s Pa)", 2e-8)
    ('bar', 'kPa', 'dm^3/(s bar)')
    """
    size = max((abs(v) for v in sizes if math.isfinite(v)), default=0.0)
    if size == 0.0:
        return unit
    return next((name for name, least in reversed(_LADDERS.get(unit, ())) if size >= least), unit)


def pretty(unit: str) -> str:
    """Return a unit in print notation, with symbols such as ³ and °.

    Examples
    --------
    >>> pretty("m^3/(s Pa)"), pretty("degC")
    ('m³/(s Pa)', '°C')
    """
    return unit.replace("deg", "°").replace("^2", "²").replace("^3", "³")


def with_unit(text: str, unit: str) -> str:
    """Return the text of a value with its unit in print notation.

    A dimensionless value has no unit in the text.
    """
    return text if unit in ("1", "") else f"{text} {pretty(unit)}"


def digits_of(value: float, largest: float) -> str:
    """Return a value as text with five significant digits.

    `largest` is the largest absolute value of the series that contains the value. If the value is only a rounding error
    compared with `largest`, the text is 0.

    Examples
    --------
    >>> digits_of(1.23456789, 2.0), digits_of(-1e-15, 2.0)
    ('1.2346', '0')
    """
    return "0" if abs(value) < ROUNDING * abs(largest) else f"{value:z.5g}"


def decimals(error: float) -> int | None:
    """Return the number of decimals that shows two significant digits of `error`.

    The result is None if `error` is below 1e-6, at least 1e6, or not a number.

    Examples
    --------
    >>> decimals(0.0123), decimals(12.0), decimals(float("inf"))
    (3, 0, None)
    """
    if not _SMALLEST_PLAIN <= error < _LARGEST_PLAIN:
        return None
    return max(0, 1 - math.floor(math.log10(error)))


def number(value: float, n_decimals: int | None = None) -> str:
    """Return a value as text with `n_decimals` decimals, by default with five significant digits.

    Infinite values and NaN become words.

    Examples
    --------
    >>> number(1.23456789, 3), number(1.23456789), number(float("nan")), number(float("-inf"))
    ('1.235', '1.2346', 'not known', 'minus infinite')
    """
    if math.isnan(value):
        return "not known"
    if math.isinf(value):
        return "infinite" if value > 0.0 else "minus infinite"
    if n_decimals is None or abs(value) >= _LARGEST_PLAIN:
        return f"{value:z.5g}"
    return f"{value:z.{n_decimals}f}"


def value_with_error(value: float, error: float, unit: str, shown_in: str) -> str:
    """Return a value and its standard error as text in a display unit.

    The text is rounded to two significant digits of the error.

    Examples
    --------
    >>> value_with_error(1.23456e-8, 2.3e-11, "m^3/(s Pa)", "dm^3/(s bar)")
    '1.2346 ± 0.0023'
    >>> value_with_error(0.3, float("inf"), "1", "1")
    '0.3 (error infinite)'
    """
    value, error = scaled(value, unit, shown_in), scaled(error, unit, shown_in)
    if not math.isfinite(error):
        return f"{number(value)} (error {number(error)})"
    n_decimals = decimals(error)
    if n_decimals is None or error > abs(value):
        return f"{number(value)} ± {error:.2g}"
    return f"{number(value, n_decimals)} ± {number(error, n_decimals)}"


def interval(low: float, high: float, unit: str, shown_in: str) -> str:
    """Return an interval as text in a display unit; infinite ends become words.

    Examples
    --------
    >>> interval(0.2, 0.31, "1", "1"), interval(2e5, float("inf"), "Pa", "bar")
    ('0.200 ... 0.310', '2 ... no upper limit')
    """
    n_decimals = decimals(scaled((high - low) / 4.0, unit, shown_in))
    low_text = number(scaled(low, unit, shown_in), n_decimals) if math.isfinite(low) else ""
    high_text = number(scaled(high, unit, shown_in), n_decimals) if math.isfinite(high) else ""
    if low_text and high_text:
        return f"{low_text} ... {high_text}"
    if not low_text and not high_text:
        return "not known" if math.isnan(low) or math.isnan(high) else "no limit"
    return f"{low_text} ... no upper limit" if low_text else f"no lower limit ... {high_text}"


def scaled(difference: float, unit: str, shown_in: str) -> float:
    """Convert a difference of two values to another unit.

    `unit` and `shown_in` must have the same zero point, so degC is not supported. A value that is not finite is
    unchanged.
    """
    if unit == shown_in or not math.isfinite(difference):
        return difference
    from poppet.core.units import convert  # imports NumPy, which the help of a command does not need

    return float(convert(difference, unit, shown_in))


def aligned(rows: Sequence[Sequence[str]], numbers: Iterable[int]) -> str:
    """Return the rows of a table as text with aligned columns.

    `numbers` contains the indices of the columns that are aligned on the right.

    Examples
    --------
    >>> print(aligned([["name", "last"], ["tank.pressure", "2.5"]], [1]))
    name           last
    tank.pressure   2.5
    """
    right = set(numbers)
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = []
    for row in rows:
        cells = enumerate(zip(row, widths, strict=True))
        lines.append("  ".join(text.rjust(width) if k in right else text.ljust(width) for k, (text, width) in cells))
    return "\n".join(line.rstrip() for line in lines)
