"""Inputs of a plant between its samples: held or linear, with delays, limits and missing values."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.monitoring.plan import WatchPlan

Array = NDArray[np.float64]


class FilledSample(NamedTuple):
    """Sample of a plant in SI units."""

    time: float  # [s]
    readings: Array  # (c,), NaN for missing readings
    inputs: Array | None  # (d,) driven inputs, NaN for missing values; None if all are missing
    row: Array  # (d,) driven inputs that are valid at this time, without their delays


class InputPiece(NamedTuple):
    """Part of an interval in which the inputs are linear."""

    duration: float  # [s]
    begin: Array  # (n_u,) inputs at its start
    end: Array  # (n_u,) and at its end


class InputCourse:
    """Course of the input vector u over the samples of a plant."""

    def __init__(self, plan: WatchPlan) -> None:
        self.plan = plan
        model = plan.instance.model
        self._constants = plan.instance.held_inputs({})
        self._indices = np.array([item.index for item in plan.inputs], dtype=np.int64)
        self._low = np.array([item.low for item in plan.inputs])
        self._high = np.array([item.high for item in plan.inputs])
        self._holds = np.array([item.hold for item in plan.inputs], dtype=np.bool_)
        self._delays = np.array([item.delay for item in plan.inputs])
        columns = {model.inputs[item.index].name: j for j, item in enumerate(plan.inputs)}
        # Inputs that are the time derivative of a driven input.
        self._slopes = [(k, columns[item.slope_of]) for k, item in enumerate(model.inputs) if item.slope_of in columns]
        self._last: tuple[list[float], Array | None] = [], None
        self.is_held = bool(self._holds.all()) and not self._delays.any()
        """True if all inputs change at samples only."""

    def first_row(self, inputs: Array | None) -> Array:
        """Return the inputs of the first sample; missing values are those of the circuit."""
        return self.fill(inputs, self._constants[self._indices])

    def fill(self, inputs: Array | None, row: Array) -> Array:
        """Return the inputs of a sample, limited to their ranges, with values of the previous `row` for missing ones.

        The result is the object `row` if no value has changed.
        """
        if inputs is None:
            return row
        # Held inputs are mostly unchanged, and an array takes longer than a list.
        key = inputs.tolist()
        if key == self._last[0] and row is self._last[1]:
            return row
        filled = np.where(np.isnan(inputs), row, np.clip(inputs, self._low, self._high))
        row = row if np.array_equal(filled, row) else filled
        self._last = key, row
        return row

    def vector(self, samples: Sequence[FilledSample]) -> Array:
        """Return the input vector at the time of the last sample, for the corrections, (n_u,)."""
        time = samples[-1].time
        u = self._constants.copy()
        for j, k in enumerate(self._indices.tolist()):
            u[k] = self._value(samples, j, time, is_end=False)
        return u

    def pieces(self, samples: Sequence[FilledSample]) -> Iterator[InputPiece]:
        """Yield the parts of the interval between the last two samples.

        `samples` contains the present sample at its end, and earlier ones for delayed inputs.
        """
        start, stop = samples[-2].time, samples[-1].time
        breaks = {start, stop}
        for j in np.flatnonzero(self._delays).tolist():
            for sample in reversed(samples):
                moment = sample.time + self._delays[j]
                if moment <= start:
                    break
                if moment < stop:
                    breaks.add(moment)
        times = sorted(breaks)
        for begin, end in pairwise(times):
            first, last = self._constants.copy(), self._constants.copy()
            for j, k in enumerate(self._indices.tolist()):
                first[k] = self._value(samples, j, begin, is_end=False)
                last[k] = self._value(samples, j, end, is_end=True)
            for k, j in self._slopes:
                index = self._indices[j]
                first[k] = last[k] = (last[index] - first[index]) / (end - begin)
            yield InputPiece(end - begin, first, last)

    def _value(self, samples: Sequence[FilledSample], j: int, time: float, *, is_end: bool) -> float:
        """Return the value of the driven input j; at a jump, before it if `is_end`, and after it otherwise."""
        moment, later = time - self._delays[j], None
        for sample in reversed(samples):
            is_before = sample.time < moment or (sample.time == moment and not is_end)
            if is_before:
                if self._holds[j] or later is None:
                    return float(sample.row[j])
                fraction = (moment - sample.time) / (later.time - sample.time)
                return float(sample.row[j] + fraction * (later.row[j] - sample.row[j]))
            later = sample
        # The first sample is valid before its time, too.
        return float(samples[0].row[j])
