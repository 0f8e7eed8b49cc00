"""A part at its place in a circuit: what the circuit asks of it again and again, with whole addresses."""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from poppet.circuit.wiring import PartWiring
from poppet.core.codes import Note
from poppet.core.provenance import Number
from poppet.core.units import counted_at, with_state
from poppet.parts.part import Input, Part, Surroundings
from poppet.timeseries.signals import Signal

_USUAL = {
    "Pa": (1e3, math.inf, "bar"),
    "K": (150.0, math.inf, "degC"),
    "m^3": (0.0, 5.0, "l"),
    "m^3/(s Pa)": (0.0, 1e-4, "dm^3/(s bar)"),
    "m": (0.0, 2.0, "mm"),
    "m^2": (0.0, 0.5, "mm^2"),
    "kg": (0.0, 5e3, "g"),
    "rad": (0.0, 7.0, "deg"),
}
"""Unit to the range of usual values, and the unit in which numbers outside it are usually meant."""
_LARGER = {"length": 200.0, "nominal_length": 20.0, "height": 20.0, "wall_area": 100.0}
"""Fields, of tubes, muscles and vessels, whose usual values go further."""


@dataclass(frozen=True, slots=True, eq=False)
class PlacedPart:
    """What a part says of itself, asked once: circuits that differ in other parts share it."""

    part: Part
    wired: PartWiring
    # By address; parameters are the run-time values of numbers, domains the characteristics that hold over a range,
    # and end stops.
    inputs: Mapping[str, Input]
    numbers: Mapping[str, Number]
    parameters: Mapping[str, float]
    domains: Mapping[str, tuple[Any, tuple[float, float]]]
    initial: Mapping[str, str]  # address of an output to the number that it begins at
    inner: frozenset[str]  # addresses of series that show how it works inside
    structure: Hashable  # what decides its equations and the addresses of its numbers
    notes: tuple[Note, ...]  # what a reader of any result has to know about its numbers

    @classmethod
    def of(cls, name: str, part: Part, surroundings: Surroundings) -> PlacedPart:
        """A part under its name; its gauge values are referred to the surroundings, which may lie below vacuum."""
        numbers = {f"{name}.{key}": number for key, number in part.numbers().items()}
        parameters = {f"{name}.{key}": value for key, value in part.parameters(surroundings).items()}
        return cls(
            part,
            PartWiring.of(part),
            {f"{name}.{item.name}": item for item in part.inputs()},
            numbers,
            parameters,
            {f"{name}.{key}": curve for key, curve in part.domains().items()},
            {f"{name}.{output}": f"{name}.{key}" for output, key in part.resume.items()},
            frozenset(f"{name}.{series}" for series in part.list_internal_outputs()),
            (name, part.structure(), tuple(parameters)),
            (*(note.within(name) for note in part.notes()), *doubtful_numbers(numbers), *open_flows(numbers)),
        )


def doubtful_numbers(numbers: Mapping[str, Number]) -> Iterator[Note]:
    """Notes on bare numbers that look as if their unit had been left out: a bare 6 is 6 Pa, not 6 bar."""
    for address, number in numbers.items():
        low, high, meant = _USUAL.get(number.unit, (0.0, math.inf, ""))
        high = _LARGER.get(address.rpartition(".")[2], high)
        # A gauge value was written with its unit, and differences have no usual size.
        if number.reference in ("difference", "gauge") or low <= number.value <= high or number.value <= 0.0:
            continue
        if number.source.kind not in ("given", "measured"):  # nobody typed it here
            continue
        if ".characteristic." in address:  # coefficients have the unit of C without being one
            continue
        if number.display() != number.text:  # without a unit of its own
            yield Note("doubt.bare_number", address, value=number.value, unit=number.unit, meant=meant)


def open_flows(numbers: Mapping[str, Number]) -> Iterator[Note]:
    """Notes on volume flows that leave open at which state they are counted."""
    for address, number in numbers.items():
        if number.unit in ("kg/s", "m^3/s ANR"):
            yield from (note.within(address) for note in open_flow(number.text, number.value, number.unit))


def open_flow(text: str, value: float, unit: str) -> Iterator[Note]:
    """How a volume flow was read that leaves open at which state it is counted."""
    state = counted_at(text) if text else ""
    if state in ("open", "standard"):
        yield Note(f"doubt.{state}_flow", shown=text, stated=with_state(text), value=value, unit=unit)


def doubtful_signals(signals: Mapping[str, Signal], inputs: Mapping[str, Input]) -> Iterator[Note]:
    """Notes on signals of pressures and temperatures that stay unusually low, and on how their values were read."""
    for address, signal in signals.items():
        yield from (note.within(f"signals.{address}") for note in signal.remarks)
        unit = inputs[address].unit
        low, _, meant = _USUAL.get(unit, (-math.inf, math.inf, ""))
        # The highest, for a pulse train may well be zero most of the time.
        highest = signal.bounds()[1]
        if 0.0 < highest < low:
            yield Note("doubt.low_signal", address, highest=highest, unit=unit, meant=meant)
