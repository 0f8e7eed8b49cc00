"""What a signal is: segments, on each a line plus a sine whose frequency sweeps linearly."""

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
    r"""A signal in segments; all arrays have the shape (n,).

    .. math::
        u(t) = v + s\,\tau + a \sin\!\left(2\pi \left(f + \tfrac{1}{2} c\,\tau\right) \tau + \varphi\right),
        \qquad \tau = t - t_k, \quad t_k \le t < t_{k+1}

    Parameters
    ----------
    start : (n,) array
        Where each segment begins; the first is 0, strictly increasing [s].
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
        True where the signal is discontinuous at the start of the segment.
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
        """The signal, from the right where it jumps; the last segment goes on.

        Parameters
        ----------
        times : float or (...) array
            Not negative [s].

        Returns
        -------
        (...) array
            In the unit of the signal.
        """
        t = np.asarray(times, dtype=float)
        k = np.searchsorted(self.start, t, side="right") - 1
        tau = t - self.start[k]
        turns = (self.frequency[k] + 0.5 * self.chirp_rate[k] * tau) * tau
        wave = self.amplitude[k] * np.sin(2.0 * np.pi * turns + self.phase[k])
        return np.asarray(self.value[k] + self.slope[k] * tau + wave)

    def derivative(self, name: str) -> SegmentTable:
        """The time derivative, which jumps where the slope does.

        Parameters
        ----------
        name : str
            Of the signal, for an error.

        Returns
        -------
        SegmentTable
            In the unit of the signal per second.

        Raises
        ------
        InputError
            Where the signal jumps, or sweeps its frequency, whose derivative is no segment.
        """
        if self.jump.any():
            raise InputError("signals.jumps", name, time=float(self.start[self.jump.argmax()]))
        if (self.chirp_rate * self.amplitude).any():
            raise InputError("signals.swept", name)
        pulse, none = 2.0 * np.pi * self.frequency, np.zeros(len(self))
        bends = np.concatenate([[False], np.ones(len(self) - 1, dtype=bool)])
        waves = self.amplitude * pulse, self.frequency, none, self.phase + 0.5 * np.pi
        return SegmentTable(self.start, self.slope, none, *waves, bends)


def lines(start: FloatArray, value: FloatArray, slope: FloatArray, jump: NDArray[np.bool_]) -> SegmentTable:
    """Segments without a wave."""
    zero = np.broadcast_to(0.0, start.shape)  # which takes no room
    return SegmentTable(start, value, slope, zero, zero, zero, zero, jump)


def held(value: float) -> SegmentTable:
    """One value from the start on."""
    return lines(np.zeros(1), np.array([float(value)]), np.zeros(1), np.zeros(1, dtype=bool))


def polyline(times: FloatArray, values: FloatArray, until: float) -> SegmentTable:
    """Straight lines between points, the first and the last value held."""
    slope = np.append(np.diff(values) / np.diff(times), 0.0)
    if times[0] > 0.0:  # every table begins at 0
        times = np.concatenate(([0.0], times))
        values = np.concatenate((values[:1], values))
        slope = np.concatenate(([0.0], slope))
    n = int(np.searchsorted(times, until, side="left"))
    return lines(times[:n], values[:n], slope[:n], np.zeros(n, dtype=bool))


def wave(
    mean: float, amplitude: float, phase: float, starts: Floats, frequencies: Floats, rates: Floats
) -> SegmentTable:
    """A sine of which each segment goes on in phase from the one before."""
    start, frequency, rate = (np.array(series, dtype=float) for series in (starts, frequencies, rates))
    turns = np.append(0.0, _turns(frequency[:-1], rate[:-1], np.diff(start)))
    phases = phase + 2.0 * np.pi * np.cumsum(turns)
    zero, one = np.zeros_like(start), np.ones_like(start)
    return SegmentTable(
        start, mean * one, zero, amplitude * one, frequency, rate, phases, np.zeros(len(start), dtype=bool)
    )


class Signal(ABC):
    """An input over time. A new kind says only what its segments are."""

    remarks: tuple[Note, ...] = ()
    """How the values of a file were read, where a reader of any result has to know."""

    @abstractmethod
    def segments(self, until: float, duration: float | None) -> SegmentTable:
        """All segments that begin before `until`.

        Parameters
        ----------
        until : float
            End of the time asked for, positive [s].
        duration : float or None
            Duration of the run, for kinds that stretch over it [s].

        Returns
        -------
        SegmentTable
        """

    def table(self, duration: float) -> SegmentTable:
        """The segments of a run.

        Parameters
        ----------
        duration : float
            Of the run, positive [s].

        Returns
        -------
        SegmentTable
            All segments that begin before the end of the run.
        """
        if not (math.isfinite(duration) and duration > 0.0):
            raise InputError("signals.duration", duration=duration)
        return self.segments(duration, duration)

    def evaluate(self, times: float | Floats, duration: float | None = None) -> FloatArray:
        """The signal at given times, from the right where it jumps.

        Parameters
        ----------
        times : float or (...) array
            Finite, not negative, in any order [s].
        duration : float, optional
            Duration of the run; needed only by a chirp without a duration of its own [s].

        Returns
        -------
        (...) array
            In the unit of the signal.
        """
        t = np.asarray(times, dtype=float)
        if not np.all(np.isfinite(t)) or np.any(t < 0.0):
            raise InputError("signals.times")
        # Segments that begin before the next number are those that begin at the last time or before it.
        last = float(np.max(t, initial=0.0))
        return self.segments(math.nextafter(last, math.inf), duration).evaluate(t)

    @abstractmethod
    def bounds(self) -> tuple[float, float]:
        """Smallest and largest value the signal can take.

        Returns
        -------
        tuple of float
            In the unit of the signal.
        """

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        """What a reader of the run should know about this signal.

        Parameters
        ----------
        duration : float
            Of the run [s].
        name : str
            Address of the input, `valve.pilot_pressure`.
        shift : float, optional
            By which the signal comes later than its own times say [s].

        Returns
        -------
        tuple of Note
            About the input; empty when there is nothing to say.
        """
        return ()

    def delayed(self, delay: float) -> Signal:
        """The same signal later, holding its first value before.

        Parameters
        ----------
        delay : float
            Not negative [s].

        Returns
        -------
        Signal
        """
        return self if delay == 0.0 else DelayedSegments(self, delay)


@dataclass(frozen=True)
class DelayedSegments(Signal):
    """Another signal later, holding its first value before.

    Parameters
    ----------
    signal : Signal
        What is delayed.
    delay : float
        Positive [s].

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

    def segments(self, until: float, duration: float | None) -> SegmentTable:
        if until <= self.delay:
            return held(float(self.signal.evaluate(0.0, duration)))
        # A hair more than needed, since the difference is rounded; what that lets in too late is cut again.
        table = self.signal.segments(until - self.delay + 2.0 * math.ulp(until), duration)
        before = held(float(table.evaluate(0.0)))
        start = np.append(0.0, table.start + self.delay)
        n = int(np.searchsorted(start, until, side="left"))
        # All fields but the first, `start`, in the order of the class; the held value brings no jump of its own.
        joined = (np.append(getattr(before, each.name), getattr(table, each.name))[:n] for each in fields(table)[1:])
        return SegmentTable(start[:n], *joined)

    def bounds(self) -> tuple[float, float]:
        return self.signal.bounds()

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        return self.signal.notes(duration, name, shift + self.delay)


class MergedSegments(NamedTuple):
    """All inputs on one set of segments; what repeats is kept once, so that a million pulses are a million times."""

    starts: FloatArray  # (n,) where each segment begins [s]
    courses: NDArray[np.int64]  # (n,) which set of coefficients holds on it
    # (n_courses, n_inputs, 7) value, slope, amplitude, frequency, chirp_rate, phase of each input, and where its own
    # time tau begins [s]
    coefficients: FloatArray
    jumps: NDArray[np.bool_]  # (n,) true where the value of any input is discontinuous


def merge(tables: Sequence[SegmentTable]) -> MergedSegments:
    """All inputs on one set of segments.

    Parameters
    ----------
    tables : sequence of SegmentTable
        One per input.

    Returns
    -------
    Merged

    Notes
    -----
    Starts that differ by rounding only (4 units in the last place) are one start, the earliest of them: no
    integrator can step between them.

    Examples
    --------
    >>> ramp = polyline(np.array([0.0, 3.0]), np.array([0.0, 6.0]), until=5.0)
    >>> merged = merge([ramp, wave(0.0, 1.0, 0.0, [0.0, 2.0], [1.0, 2.0], [0.0, 0.0])])
    >>> merged.starts.tolist(), merged.coefficients[merged.courses, 1, 6].tolist()
    ([0.0, 2.0, 3.0], [0.0, 2.0, 2.0])
    """
    # Behind a start, an input is in that segment of its own which begins last within the rounding of it.
    every = np.unique(np.concatenate([np.zeros(1), *(table.start for table in tables)]))
    first_of_group = np.concatenate(([True], np.diff(every) > 4.0 * np.spacing(every[1:])))
    starts = every[first_of_group]
    last_of_group = every[np.append(first_of_group[1:], True)]
    jumps, courses = np.zeros(len(starts), dtype=bool), np.zeros(len(starts), dtype=np.int64)
    rows: list[NDArray[np.int64]] = []  # of each input so far, for every course
    own = [_own_courses(table) for table in tables]
    for table, (coefficients, of_segment) in zip(tables, own, strict=True):
        k = np.searchsorted(table.start, last_of_group, side="right") - 1
        # More jumps up to here than up to the start before: one of them is at this start.
        jumps[1:] |= np.diff(np.cumsum(table.jump)[k]) > 0
        n = len(coefficients)
        if n == 1:
            rows.append(np.zeros(int(courses.max()) + 1, dtype=np.int64))
            continue
        distinct, courses = np.unique(courses * n + of_segment[k], return_inverse=True)
        rows = [*(row[distinct // n] for row in rows), distinct % n]
    sets = [coefficients[row] for (coefficients, _), row in zip(own, rows, strict=True)]
    joined = np.stack(sets, axis=1) if sets else np.empty((1, 0, 7))
    return MergedSegments(starts, courses, np.ascontiguousarray(joined), jumps)


def _own_courses(table: SegmentTable) -> tuple[FloatArray, NDArray[np.int64]]:
    """Coefficients that differ, (m, 7), and which of them hold on each segment; equal values at rest are one."""
    still = np.flatnonzero((table.slope == 0.0) & (table.amplitude == 0.0))
    which = np.arange(len(table))
    _, first, same = np.unique(table.value[still], return_index=True, return_inverse=True)
    which[still] = still[first[same]]
    rows, which = np.unique(which, return_inverse=True)
    names = ("value", "slope", "amplitude", "frequency", "chirp_rate", "phase", "start")
    return np.column_stack([getattr(table, name)[rows] for name in names]), which


def _turns(frequency: FloatArray, rate: FloatArray, tau: FloatArray) -> FloatArray:
    """Turns after the time tau; whole ones are dropped, which keeps the digits of a late phase."""
    return np.remainder((frequency + 0.5 * rate * tau) * tau, 1.0)
