"""Notes on numbers that look as if their unit had been left out: a bare 6 is 6 Pa, not 6 bar."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from poppet.ground.codes import Note
from poppet.ground.provenance import Number
from poppet.parts.part import Input
from poppet.series.signals import Signal

_USUAL = {
    "Pa": (1e3, math.inf, "bar"),
    "K": (150.0, math.inf, "degC"),
    "m^3": (0.0, 5.0, "l"),
    "m^3/(s Pa)": (0.0, 1e-4, "dm^3/(s bar)"),
}
"""Unit to the range of usual values, and the unit in which numbers outside it are usually meant."""


def doubtful_numbers(numbers: Mapping[str, Number]) -> Iterator[Note]:
    """Notes on bare numbers of unusual size."""
    for address, number in numbers.items():
        low, high, meant = _USUAL.get(number.unit, (0.0, math.inf, ""))
        if number.reference in ("difference", "gauge") or low <= number.value <= high or number.value <= 0.0:
            continue
        if number.source.kind not in ("given", "measured"):  # nobody typed it here
            continue
        if ".characteristic." in address:  # coefficients have the unit of C without being one
            continue
        if number.display() != number.text:  # without a unit of its own
            yield Note("doubt.bare_number", address, value=number.value, unit=number.unit, meant=meant)


def doubtful_signals(signals: Mapping[str, Signal], inputs: Mapping[str, Input]) -> Iterator[Note]:
    """Notes on signals of pressures and temperatures that stay unusually low."""
    for address, signal in signals.items():
        unit = inputs[address].unit
        low, _, meant = _USUAL.get(unit, (-math.inf, math.inf, ""))
        highest = signal.bounds()[1]
        if 0.0 < highest < low:
            yield Note("doubt.low_signal", address, highest=highest, unit=unit, meant=meant)
