"""Format of numbers in the captions of a schematic."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from poppet.core.number_format import USUAL, readable_unit, with_unit
from poppet.core.provenance import Number
from poppet.core.units import convert
from poppet.parts.fields import NumberLike

ASSUMED = "*"
"""Mark behind a number that is assumed."""


def format_value(value: float, unit: str) -> str:
    """Format an SI value in a practical unit, such as bar, with four digits.

    Examples
    --------
    >>> format_value(7e5, "Pa"), format_value(0.2, "m^3"), format_value(0.3, "1")
    ('7 bar', '0.2 m³', '0.3')
    """
    # Volumes and masses of one circuit differ by decades. Other quantities have one readable unit.
    target = readable_unit(unit, value) if unit in ("m^3", "kg") else USUAL.get(unit, unit)
    return with_unit(f"{convert(value, unit, target):z.4g}", target)


@dataclass(frozen=True)
class CaptionNumbers:
    """Formatter of the numbers in the caption of a part in a schematic.

    Parameters
    ----------
    parameter : callable
        Function from the name of a parameter of the part to its value in a run [SI].
    signals : frozenset of str
        Names of the inputs of the part that a signal drives.
    ambient_pressure : float
        Absolute ambient pressure to which gauge pressures refer [Pa].
    """

    parameter: Callable[[str], float]
    signals: frozenset[str] = frozenset()
    ambient_pressure: float = 1e5

    def text(self, number: NumberLike) -> str:
        """Format a number of the part in a practical unit.

        Parameters
        ----------
        number : Number
            Number with a source.

        Returns
        -------
        str
            Value and unit, followed by an asterisk if the source of the number is `assumed`.

        Examples
        --------
        >>> from poppet.core.provenance import assumed
        >>> CaptionNumbers({}.__getitem__).text(assumed(2e-4, "m^3", "a guess"))
        '200 cm³*'
        """
        assert isinstance(number, Number)
        mark = ASSUMED if number.source.kind == "assumed" else ""
        if number.reference == "gauge":
            return number.display() + mark
        return format_value(number.absolute(self.ambient_pressure), number.unit) + mark
