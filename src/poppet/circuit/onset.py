"""Inputs that jump at a time of their own, such as the fault of a valve."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector
from poppet.parts.part import Input
from poppet.timeseries.segments import SegmentTable, Signal, held
from poppet.timeseries.signals import Steps


@dataclass(frozen=True)
class Onset(Signal):
    """Signal of an input without a signal: 0 before the delay of the input, and 1 afterwards."""

    def segments(self, end: float, duration: float | None) -> SegmentTable:
        return held(1.0)

    def bounds(self) -> tuple[float, float]:
        return 0.0, 1.0

    def delayed(self, delay: float) -> Signal:
        return self if delay == 0.0 else Steps([0.0, delay], [0.0, 1.0])

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        return (Note("faults.after_end", name, time=shift, duration=duration),) if shift >= duration else ()


ONSET = Onset()


def onset_inputs(inputs: Mapping[str, Input], signals: Collection[str], connections: Collection[str]) -> list[str]:
    """Return the addresses of the inputs that have the signal `ONSET`: those without a signal and a connection."""
    return [a for a, item in inputs.items() if item.is_onset and a not in signals and a not in connections]


def onset_field(address: str, item: Input) -> str:
    """Return the address of the field with the time at which an input jumps.

    The parameter of this time can belong to a member of a compound part, but the field belongs to the part.
    """
    return f"{address.partition('.')[0]}.{item.delay.rpartition('.')[2]}"


def check_onsets(
    errors: ErrorCollector, inputs: Mapping[str, Input], driven: Collection[str], parameters: Mapping[str, float]
) -> None:
    """Collect an error for each input with a time of its own and also a signal or a connection.

    `driven` contains the addresses of all inputs with a signal or a connection.
    """
    for address in driven:
        item = inputs.get(address)
        if item is not None and item.is_onset:
            start = parameters.get(f"{address.partition('.')[0]}.{item.delay}")
            if start:
                errors.add("faults.two_starts", onset_field(address, item), input=address, time=start)
