"""Signals in segments; each segment is a straight line plus a sine with linearly swept frequency."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import InputError

FloatArray = NDArray[np.float64]
Floats = Sequence[float] | FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class SegmentTable:
    r"""Coefficients of a signal that consists of segments.

    .. math::
        u(t) = v + s\,\tau + a \sin\!\left(2\pi \left(f + \tfrac{1}{2} c\,\tau\right) \tau + \varphi\right),
        \qquad \tau = t - t_k, \quad t_k \le t < t_{k+1}

    Parameters
    ----------
    start : (n,) array
        t_k, the start of each segment, strictly increasing from 0 [s].
    value : (n,) array
        v, in the unit of the signal.
    slope : (n,) array
        s, in the unit of the signal per second.
    amplitude : (n,) array
        a, in the unit of the signal.
    frequency : (n,) array
        f at the start of the segment [Hz].
    chirp_rate : (n,) array
        c [Hz/s].
    phase : (n,) array
        phi at the start of the segment [rad].
    jump : (n,) array of bool
        True if the signal is discontinuous at the start of the segment.
    """

    start: FloatArray
    value: FloatArray
    slope: FloatArray
    amplitude: FloatArray
    frequency: FloatArray
    chirp_rate: FloatArray
    phase: FloatArray
    jump: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.start)

    def evaluate(self, times: float | Floats) -> FloatArray:
        """Return the values of the signal at given times.

        At a jump, the result is the value after the jump. The last segment has no end.

        Parameters
        ----------
        times : float or (...) array
            Times, not negative [s].

        Returns
        -------
        (...) array
            Values in the unit of the signal.
        """
        t = np.asarray(times, dtype=float)
        k = np.searchsorted(self.start, t, side="right") - 1
        tau = t - self.start[k]
        turns = (self.frequency[k] + 0.5 * self.chirp_rate[k] * tau) * tau
        wave = self.amplitude[k] * np.sin(2.0 * np.pi * turns + self.phase[k])
        return np.asarray(self.value[k] + self.slope[k] * tau + wave)

    def derivative(self, name: str) -> SegmentTable:
        """Return the time derivative of the signal as segments.

        Parameters
        ----------
        name : str
            Name of the signal for error messages.

        Returns
        -------
        SegmentTable
            Derivative in the unit of the signal per second.

        Raises
        ------
        InputError
            If the signal jumps or sweeps its frequency. The derivative of a sweep cannot be written as segments.
        """
        if self.jump.any():
            raise InputError("signals.jumps", name, time=float(self.start[self.jump.argmax()]))
        if (self.chirp_rate * self.amplitude).any():
            raise InputError("signals.swept", name)
        pulse, zeros = 2.0 * np.pi * self.frequency, np.zeros(len(self))
        bends = np.concatenate([[False], np.ones(len(self) - 1, dtype=bool)])
        waves = self.amplitude * pulse, self.frequency, zeros, self.phase + 0.5 * np.pi
        return SegmentTable(self.start, self.slope, zeros, *waves, bends)


def lines(start: FloatArray, value: FloatArray, slope: FloatArray, jump: NDArray[np.bool_]) -> SegmentTable:
    """Return a signal of straight lines as segments.

    `start`, `value` and `slope` describe each line. The elements of `jump` are True if the signal jumps at the start of
    the line.
    """
    zero = np.broadcast_to(0.0, start.shape)  # takes no memory
    return SegmentTable(start, value, slope, zero, zero, zero, zero, jump)


def held(value: float) -> SegmentTable:
    """Return a signal with one constant value as a single segment."""
    return lines(np.zeros(1), np.array([float(value)]), np.zeros(1), np.zeros(1, dtype=bool))


def polyline(times: FloatArray, values: FloatArray, end: float) -> SegmentTable:
    """Return straight lines between given points as segments.

    Before the first point, the signal has the first value, and after the last point the last value. Segments that would
    start at or after the time `end` are omitted.
    """
    slope = np.append(np.diff(values) / np.diff(times), 0.0)
    if times[0] > 0.0:  # each table starts at 0
        times = np.concatenate(([0.0], times))
        values = np.concatenate((values[:1], values))
        slope = np.concatenate(([0.0], slope))
    n = int(np.searchsorted(times, end, side="left"))
    return lines(times[:n], values[:n], slope[:n], np.zeros(n, dtype=bool))


def wave(
    mean: float, amplitude: float, phase: float, starts: Floats, frequencies: Floats, rates: Floats
) -> SegmentTable:
    """Return a sine with variable frequency as segments, without jumps of the phase.

    `starts`, `frequencies` and `rates` are the start of each segment [s], its frequency [Hz], and the rate of change of
    the frequency [Hz/s].
    """
    start, frequency, rate = (np.array(series, dtype=float) for series in (starts, frequencies, rates))
    tau = np.diff(start)
    # Without whole turns: a large number of turns would reduce the accuracy of the phase.
    turns = np.append(0.0, np.remainder((frequency[:-1] + 0.5 * rate[:-1] * tau) * tau, 1.0))
    phases = phase + 2.0 * np.pi * np.cumsum(turns)
    zeros, ones = np.zeros_like(start), np.ones_like(start)
    return SegmentTable(
        start, mean * ones, zeros, amplitude * ones, frequency, rate, phases, np.zeros(len(start), dtype=bool)
    )


class Signal(ABC):
    """Base class of signals over time.

    Each subclass defines how its signal is divided into segments (`SegmentTable`).
    """

    remarks: tuple[Note, ...] = ()
    """Notes on the file from which the signal was read. They are part of each result with this signal."""

    @abstractmethod
    def segments(self, end: float, duration: float | None) -> SegmentTable:
        """Return all segments that start before the time `end`.

        Parameters
        ----------
        end : float
            End of the requested time, positive [s].
        duration : float or None
            Duration of the run, for kinds of signals that depend on the duration [s].

        Returns
        -------
        SegmentTable
        """

    def table(self, duration: float) -> SegmentTable:
        """Return the segments of the signal for a run of given duration.

        Parameters
        ----------
        duration : float
            Duration of the run, positive [s].

        Returns
        -------
        SegmentTable
            All segments that begin before the end of the run.
        """
        if not (math.isfinite(duration) and duration > 0.0):
            raise InputError("signals.duration", duration=duration)
        return self.segments(duration, duration)

    def window(self, begin: float, end: float, duration: float | None) -> SegmentTable:
        """Return the segments of a time window, for runs without an end.

        Parameters
        ----------
        begin, end : float
            Time window, not negative [s].
        duration : float or None
            Duration for kinds of signals that depend on the duration [s].

        Returns
        -------
        SegmentTable
            Segments of `segments` that begin before `end`, from one that is valid at `begin` on. Periodic signals need
            memory for the window only.
        """
        table = self.segments(end, duration)
        first = max(0, int(np.searchsorted(table.start, begin, side="right")) - 1)
        return SegmentTable(*(getattr(table, column.name)[first:] for column in fields(table)))

    def evaluate(self, times: float | Floats, duration: float | None = None) -> FloatArray:
        """Return the values of the signal at given times.

        At a jump, the result is the value after the jump.

        Parameters
        ----------
        times : float or (...) array
            Times, finite and not negative, in any order [s].
        duration : float, optional
            Duration of the run, which only a chirp without its own duration needs [s].

        Returns
        -------
        (...) array
            Values in the unit of the signal.
        """
        t = np.asarray(times, dtype=float)
        if not np.all(np.isfinite(t)) or np.any(t < 0.0):
            raise InputError("signals.times")
        # The limit is exclusive: the next floating-point number includes a segment at the last time.
        last = float(np.max(t, initial=0.0))
        return self.segments(math.nextafter(last, math.inf), duration).evaluate(t)

    @abstractmethod
    def bounds(self) -> tuple[float, float]:
        """Return the lower and the upper limit of all values of the signal.

        Returns
        -------
        tuple of float
            Minimum and maximum in the unit of the signal.
        """

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        """Return notes on the use of this signal in a run, for example on its last value.

        Parameters
        ----------
        duration : float
            Duration of the run [s].
        name : str
            Address of the input, `valve.pilot_pressure`.
        shift : float, optional
            Delay of the signal [s].

        Returns
        -------
        tuple of Note
            Notes on the input.
        """
        return ()

    def delayed(self, delay: float) -> Signal:
        """Return the signal delayed by a given time.

        Until the delayed signal starts, its value is the first value.

        Parameters
        ----------
        delay : float
            Delay, not negative [s].

        Returns
        -------
        Signal
        """
        return self if delay == 0.0 else DelayedSegments(self, delay)


@dataclass(frozen=True)
class DelayedSegments(Signal):
    """Signal that is delayed by a given time.

    Until the delayed signal starts, its value is the first value.

    Parameters
    ----------
    signal : Signal
        Signal before the delay.
    delay : float
        Delay, positive [s].

    Examples
    --------
    >>> from poppet.timeseries.signals import Steps
    >>> DelayedSegments(Steps([0.0, 1.0], [0.0, 5.0]), 0.5).evaluate([1.0, 1.5]).tolist()
    [0.0, 5.0]
    """

    signal: Signal
    delay: float

    def __post_init__(self) -> None:
        if not (math.isfinite(self.delay) and self.delay > 0.0):
            raise InputError("signals.delay", delay=self.delay)

    def segments(self, end: float, duration: float | None) -> SegmentTable:
        if end <= self.delay:
            return held(float(self.signal.evaluate(0.0, duration)))
        # The difference is rounded, so the limit has a margin; segments beyond `until` are removed below.
        table = self.signal.segments(end - self.delay + 2.0 * math.ulp(end), duration)
        initial = held(float(table.evaluate(0.0)))
        start = np.append(0.0, table.start + self.delay)
        n = int(np.searchsorted(start, end, side="left"))
        # All fields except the first, `start`, in the order of the class. The held value does not jump.
        joined = (
            np.append(getattr(initial, column.name), getattr(table, column.name))[:n] for column in fields(table)[1:]
        )
        return SegmentTable(start[:n], *joined)

    def window(self, begin: float, end: float, duration: float | None) -> SegmentTable:
        if begin <= self.delay:
            return super().window(begin, end, duration)
        # As in `segments`, the limits have a margin for rounding.
        margin = 2.0 * math.ulp(end)
        table = self.signal.window(max(0.0, begin - self.delay - margin), end - self.delay + margin, duration)
        start = table.start + self.delay
        n = int(np.searchsorted(start, end, side="left"))
        return SegmentTable(start[:n], *(getattr(table, column.name)[:n] for column in fields(table)[1:]))

    def bounds(self) -> tuple[float, float]:
        return self.signal.bounds()

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        return self.signal.notes(duration, name, shift + self.delay)


class MergedSegments(NamedTuple):
    """Segments of all inputs, divided at common start times.

    Equal coefficients are stored only once: a million equal pulses need memory only for their start times.
    """

    starts: FloatArray  # (n,) start of each segment [s]
    courses: NDArray[np.int64]  # (n,) index of the coefficients of each segment
    # (n_courses, n_inputs, 7) value, slope, amplitude, frequency, chirp_rate, phase of each input, and the origin of
    # its time tau [s]
    coefficients: FloatArray
    jumps: NDArray[np.bool_]  # (n,) true if the value of any input is discontinuous at the start


def merge(tables: Sequence[SegmentTable]) -> MergedSegments:
    """Divide the segments of all inputs at common start times.

    Parameters
    ----------
    tables : sequence of SegmentTable
        Segments, one table per input.

    Returns
    -------
    MergedSegments

    Notes
    -----
    Starts that differ only by rounding (4 units in the last place) become one start, the earliest of them, because
    an integrator cannot step between them.

    Examples
    --------
    >>> ramp = polyline(np.array([0.0, 3.0]), np.array([0.0, 6.0]), end=5.0)
    >>> merged = merge([ramp, wave(0.0, 1.0, 0.0, [0.0, 2.0], [1.0, 2.0], [0.0, 0.0])])
    >>> merged.starts.tolist(), merged.coefficients[merged.courses, 1, 6].tolist()
    ([0.0, 2.0, 3.0], [0.0, 2.0, 2.0])
    """
    # After a start, the segment of an input is the last one that begins within the rounding of this start.
    all_starts = np.unique(np.concatenate([np.zeros(1), *(table.start for table in tables)]))
    first_of_group = np.concatenate(([True], np.diff(all_starts) > 4.0 * np.spacing(all_starts[1:])))
    starts = all_starts[first_of_group]
    last_of_group = all_starts[np.append(first_of_group[1:], True)]
    jumps, courses = np.zeros(len(starts), dtype=bool), np.zeros(len(starts), dtype=np.int64)
    rows: list[NDArray[np.int64]] = []  # for each input so far: its coefficient row in every course
    distinct_coefficients: list[FloatArray] = []  # of each input, (m, 7)
    names = ("value", "slope", "amplitude", "frequency", "chirp_rate", "phase", "start")
    for table in tables:
        # Constant segments with equal values share their coefficients.
        constant = np.flatnonzero((table.slope == 0.0) & (table.amplitude == 0.0))
        of_segment = np.arange(len(table))
        _, first, same = np.unique(table.value[constant], return_index=True, return_inverse=True)
        of_segment[constant] = constant[first[same]]
        distinct_rows, of_segment = np.unique(of_segment, return_inverse=True)
        distinct_coefficients.append(np.column_stack([getattr(table, name)[distinct_rows] for name in names]))
        k = np.searchsorted(table.start, last_of_group, side="right") - 1
        # The count of jumps increases at a start that has a jump.
        jumps[1:] |= np.diff(np.cumsum(table.jump)[k]) > 0
        n = len(distinct_rows)
        if n == 1:
            rows.append(np.zeros(int(courses.max()) + 1, dtype=np.int64))
            continue
        distinct, courses = np.unique(courses * n + of_segment[k], return_inverse=True)
        rows = [*(row[distinct // n] for row in rows), distinct % n]
    sets = [coefficients[row] for coefficients, row in zip(distinct_coefficients, rows, strict=True)]
    joined = np.stack(sets, axis=1) if sets else np.empty((1, 0, 7))
    return MergedSegments(starts, courses, np.ascontiguousarray(joined), jumps)
