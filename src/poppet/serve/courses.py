"""Courses of inputs over an unlimited time: signals of the circuit in windows, and written values."""

from __future__ import annotations

import heapq
import math
from dataclasses import fields

import numpy as np
from numpy.typing import NDArray

from poppet.timeseries.segments import SegmentTable, Signal

Array = NDArray[np.float64]
WINDOW = 2.0
"""Duration of the segments of a signal that are prepared at a time [s]."""
VALUE, SLOPE, ORIGIN = 0, 1, 6
"""Columns of the coefficients of an input, see `poppet.timeseries.segments.MergedSegments`."""


def same_time(earlier: float, later: float) -> bool:
    """Return True if two times differ only by rounding, so that the integrator cannot step between them."""
    return later < math.inf and later - earlier <= 4.0 * math.ulp(later)


class SignalCourse:
    """Signal that writes the coefficients of its present segment.

    Parameters
    ----------
    signal : Signal
        Signal, including its delay.
    duration : float or None
        Duration of the run for kinds of signals that depend on it [s].
    slope_of : str, optional
        Address of the input whose time derivative is written instead of the signal.
    """

    def __init__(self, signal: Signal, duration: float | None, slope_of: str = "") -> None:
        self._signal, self._duration, self._slope_of = signal, duration, slope_of
        self._end, self._k = 0.0, 0
        self._starts, self._rows, self._jumps = list[float](), np.empty((0, 7)), list[bool]()
        self.cover(0.0, 0.0)

    def cover(self, begin: float, end: float) -> None:
        """Prepare the segments from the present time `begin` until at least the time `end`."""
        if end < self._end:
            return
        self._end = end + WINDOW
        table = self._signal.window(begin, self._end, self._duration)
        if self._slope_of:
            table = table.derivative(f"signals.{self._slope_of}")
        self._starts, self._jumps = table.start.tolist(), table.jump.tolist()
        self._rows = np.column_stack([*_coefficients(table), table.start])
        self._k = max(0, int(np.searchsorted(table.start, begin, side="right")) - 1)

    def row(self) -> Array:
        """Return the coefficients of the present segment, (7,)."""
        present: Array = self._rows[self._k]
        return present

    def next(self) -> float:
        """Return the start of the next segment [s], or infinity if it is not prepared."""
        return self._starts[self._k + 1] if self._k + 1 < len(self._starts) else math.inf

    def enter(self, t: float) -> bool:
        """Make the segment at the time t the present one, and return True if the signal jumps."""
        has_jumped = False
        while self.next() <= t or same_time(t, self.next()):
            self._k += 1
            has_jumped |= self._jumps[self._k]
        return has_jumped


def _coefficients(table: SegmentTable) -> list[Array]:
    """Return value, slope, amplitude, frequency, rate of the frequency and phase of all segments."""
    return [np.asarray(getattr(table, column.name)) for column in fields(table)[1:7]]


class WrittenCourse:
    """Values of inputs that clients write, with the delays of the inputs.

    An input whose time derivative is another input of the model does not jump: it changes linearly over one period.
    """

    def __init__(self) -> None:
        self._pending: list[tuple[float, int, int, float, float]] = []
        self._count = 0

    def put(self, t: float, k: int, value: float, slope: float = 0.0) -> None:
        """Set the value and the slope of the input with the index k from the time t on."""
        self._count += 1  # the order of changes at equal times
        heapq.heappush(self._pending, (t, self._count, k, value, slope))

    def next(self) -> float:
        """Return the time of the next change [s], or infinity."""
        return self._pending[0][0] if self._pending else math.inf

    def enter(self, t: float, coefficients: Array) -> bool:
        """Write the changes up to the time t into the coefficients, (n_inputs, 7), and return True if there are any."""
        has_changed = False
        while self._pending and (self.next() <= t or same_time(t, self.next())):
            begin, _, k, value, slope = heapq.heappop(self._pending)
            coefficients[k] = 0.0
            coefficients[k, [VALUE, SLOPE, ORIGIN]] = value, slope, begin
            has_changed = True
        return has_changed
