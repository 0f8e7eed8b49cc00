"""Notes on numbers that look as if their unit had been left out: a bare 6 is 6 Pa, not 6 bar."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from poppet.ground.provenance import Number
from poppet.series.signals import Signal

_USUAL = {
    "Pa": (1e3, math.inf, "bar"),
    "K": (150.0, math.inf, "degC"),
    "m^3": (0.0, 5.0, "l"),
    "m^3/(s Pa)": (0.0, 1e-4, "dm^3/(s bar)"),
}
"""Unit to the range of usual values, and the unit in which numbers outside it are usually meant."""


def doubtful_numbers(numbers: Mapping[str, Number]) -> Iterator[str]:
    """Sentences on bare numbers of unusual size."""
    for address, number in numbers.items():
        low, high, meant = _USUAL.get(number.unit, (0.0, math.inf, ""))
        if number.reference in ("difference", "gauge") or low <= number.value <= high or number.value <= 0.0:
            continue
        if number.source.kind not in ("given", "measured"):  # nobody typed it here
            continue
        if ".characteristic." in address:  # coefficients have the unit of C without being one
            continue
        if number.display() != number.text:  # without a unit of its own
            yield (
                f"{address} = {number.value:g} {number.unit}, since a bare number is in {number.unit}. "
                f'Write "{number.value:g} {meant}" if {meant} was meant.'
            )


def doubtful_signals(signals: Mapping[str, Signal], inputs: Mapping[str, Any]) -> Iterator[str]:
    """Sentences on signals of pressures and temperatures that stay unusually low."""
    for address, signal in signals.items():
        unit = inputs[address].unit
        low, _, meant = _USUAL.get(unit, (-math.inf, math.inf, ""))
        highest = signal.bounds()[1]
        if 0.0 < highest < low:
            yield (
                f"signals.{address} stays at or below {highest:g} {unit}: bare numbers are in {unit}. "
                f'Write values such as "{highest:g} {meant}" if {meant} was meant (in Python, signals are in SI).'
            )
