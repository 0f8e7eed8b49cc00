"""Part with the complete addresses of its parameters, inputs and outputs in a circuit."""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from poppet.circuit.wiring import PartWiring
from poppet.core.codes import Note
from poppet.core.provenance import ComponentSource, Number
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
"""Mapping from SI units to the range of usual values and a common unit.

The common unit is probably meant if a value without a unit is outside the range."""
_UPPER_LIMITS = {"length": 200.0, "nominal_length": 20.0, "height": 20.0, "wall_area": 100.0}
"""Upper limits of fields of tubes, muscles and vessels with larger usual values."""


@dataclass(frozen=True, slots=True, eq=False)
class PlacedPart:
    """Part of a circuit, with properties that depend on its name and the surroundings.

    Copies of a circuit share this object if the part is unchanged.
    """

    part: Part
    wired: PartWiring
    # By address; `parameters` are run-time values, `domains` are characteristics with a limited domain and end stops.
    inputs: Mapping[str, Input]
    numbers: Mapping[str, Number]
    parameters: Mapping[str, float]
    domains: Mapping[str, tuple[Any, tuple[float, float]]]
    initial: Mapping[str, str]  # address of an output to the parameter of its start value
    inner: frozenset[str]  # addresses of internal outputs
    structure: Hashable  # key of its equations and of the addresses of its parameters
    notes: tuple[Note, ...]  # notes on its values

    @classmethod
    def of(cls, name: str, part: Part, surroundings: Surroundings) -> PlacedPart:
        """Return a part with the addresses and values of its parameters in a circuit.

        The addresses begin with the name of the part; gauge pressures become absolute. A gauge value below vacuum
        raises InputError.
        """
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
            (
                *(note.within(name) for note in part.notes()),
                *(note.within(name) for note in doubt_notes(numbers.values())),
                *value_notes(numbers),
                *(
                    note.within(address)
                    for address, number in numbers.items()
                    if number.unit in ("kg/s", "m^3/s ANR")
                    for note in volume_flow_note(number.text, number.value, number.unit)
                ),
            ),
        )


def doubt_notes(numbers: Iterable[Number]) -> tuple[Note, ...]:
    """Return a note for each doubt about the numbers of a component that a part uses."""
    sources = (number.source for number in numbers)
    doubts = {
        (source.component, doubt): None
        for source in sources
        if isinstance(source, ComponentSource)
        for doubt in source.doubts
    }
    return tuple(Note("components.doubt", "model", name=name, doubt=doubt) for name, doubt in doubts)


def value_notes(numbers: Mapping[str, Number]) -> Iterator[Note]:
    """Yield notes on values without a unit that were probably meant in another unit.

    For example, a pressure of 6 is read as 6 Pa, although 6 bar is probably intended.
    """
    for address, number in numbers.items():
        low, high, intended_unit = _USUAL.get(number.unit, (0.0, math.inf, ""))
        high = _UPPER_LIMITS.get(address.rpartition(".")[2], high)
        # A gauge value has a unit in its text, and a difference has no usual range.
        if number.reference in ("difference", "gauge") or low <= number.value <= high or number.value <= 0.0:
            continue
        if number.source.kind not in ("given", "measured"):  # not from this file or program
            continue
        if "characteristic." in address:  # coefficients have the unit of C, but other ranges
            continue
        if number.display() != number.text:  # the text has no unit
            yield Note("doubt.bare_number", address, value=number.value, unit=number.unit, meant=intended_unit)


def volume_flow_note(text: str, value: float, unit: str) -> Iterator[Note]:
    """Yield a note if a volume flow has no reference state, such as ANR, in its text.

    The note contains the assumed reference state.
    """
    state = counted_at(text) if text else ""
    if state in ("open", "standard"):
        yield Note(f"doubt.{state}_flow", shown=text, stated=with_state(text), value=value, unit=unit)


def signal_notes(signals: Mapping[str, Signal], inputs: Mapping[str, Input]) -> Iterator[Note]:
    """Yield notes on the signals of a circuit.

    They contain the notes made when the signals were read, and a note for each pressure or temperature whose maximum is
    so low that its unit is probably wrong. `inputs` maps addresses to inputs.
    """
    for address, signal in signals.items():
        yield from (note.within(f"signals.{address}") for note in signal.remarks)
        unit = inputs[address].unit
        low, _, intended_unit = _USUAL.get(unit, (-math.inf, math.inf, ""))
        # The maximum, because a pulse train can be zero most of the time.
        highest = signal.bounds()[1]
        if 0.0 < highest < low:
            yield Note("doubt.low_signal", address, highest=highest, unit=unit, meant=intended_unit)
