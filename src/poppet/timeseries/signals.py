"""Inputs over time. Each kind reduces to segments: a line plus a sine of linearly swept frequency."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, collect
from poppet.timeseries.checks import not_finite, not_positive, numbers, path_problems
from poppet.timeseries.segments import DelayedSegments, Floats, SegmentTable, Signal, held, lines, merge, polyline, wave

__all__ = [
    "Chirp",
    "Constant",
    "DelayedSegments",
    "Points",
    "Prbs",
    "Pwm",
    "SampledSignal",
    "SegmentTable",
    "Signal",
    "Sine",
    "Square",
    "Steps",
    "merge",
]

_MOST_BITS = 10_000_000  # of which the start times alone take 80 MB
_MOST_PERIODS = _MOST_BITS // 2  # of two edges each


@dataclass(frozen=True, eq=False)
class _Course(Signal):
    """Values at times that begin at 0 or later and increase strictly; the arrays cannot be changed."""

    times: Floats
    values: Floats

    def __post_init__(self) -> None:
        name = self.name if isinstance(self, SampledSignal) else type(self).__name__.lower()
        times, values = numbers(f"{name}: times", self.times), numbers(f"{name}: values", self.values)
        collect(path_problems(name, times, values))
        for field, series in (("times", times), ("values", values)):
            series.flags.writeable = False
            object.__setattr__(self, field, series)

    def bounds(self) -> tuple[float, float]:
        return float(np.min(self.values)), float(np.max(self.values))

    def segments(self, until: float, duration: float | None) -> SegmentTable:
        return polyline(np.asarray(self.times), np.asarray(self.values), until)


@dataclass(frozen=True)
class Constant(Signal):
    """One value throughout.

    Parameters
    ----------
    value : float
        In SI.

    Examples
    --------
    >>> float(Constant(2e5).evaluate(3.0))
    200000.0
    """

    value: float

    def __post_init__(self) -> None:
        collect(not_finite(value=self.value))

    def bounds(self) -> tuple[float, float]:
        return self.value, self.value

    def segments(self, until: float, duration: float | None) -> SegmentTable:
        return held(self.value)


@dataclass(frozen=True, eq=False)
class Steps(_Course):
    """A staircase, continuous from the right.

    Parameters
    ----------
    times : (n,) array
        When each value begins; the first is 0, strictly increasing [s].
    values : (n,) array
        In SI.

    Notes
    -----
    A step at or after the end of the run is not part of it; `notes` says so.

    Examples
    --------
    >>> Steps([0.0, 20.0, 40.0], [1e5, 2e5, 0.0]).evaluate([19.9, 20.0, 50.0]).tolist()
    [100000.0, 200000.0, 0.0]
    """

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.times[0] != 0.0:
            raise InputError("signals.no_first_step", time=float(self.times[0]))

    def segments(self, until: float, duration: float | None) -> SegmentTable:
        n = int(np.searchsorted(self.times, until, side="left"))
        start, value = np.asarray(self.times)[:n], np.asarray(self.values)[:n]
        return lines(start, value, np.zeros(n), np.diff(value, prepend=value[0]) != 0.0)

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        unused = int(np.count_nonzero(np.asarray(self.times) + shift >= duration))
        if not unused:
            return ()
        return (Note("signals.steps_unused", name, unused=unused, total=len(self.times), end=duration),)


@dataclass(frozen=True, eq=False)
class Points(_Course):
    """Straight lines between points, held at the first value before and at the last value after them.

    Parameters
    ----------
    times : (n,) array
        Not negative, strictly increasing [s].
    values : (n,) array
        In SI.

    Examples
    --------
    >>> ramp = Points([1.0, 3.0], [0.0, 4e5])
    >>> ramp.evaluate([0.0, 2.0, 9.0]).tolist()
    [0.0, 200000.0, 400000.0]
    >>> print(*ramp.notes(9.0, "valve.pilot_pressure"))
    valve.pilot_pressure is kept at its last value, 400000, after t = 3 s.
    """

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        last, end = float(self.values[-1]), float(self.times[-1]) + shift
        if len(self.times) == 1 or end >= duration:
            return ()
        return (Note("signals.held_after", name, source="", value=last, time=end),)


@dataclass(frozen=True, eq=False)
class SampledSignal(_Course):
    """A measured series, straight between its samples and held before and after them.

    Parameters
    ----------
    times : (n,) array
        Not negative, strictly increasing [s].
    values : (n,) array
        In SI.
    name : str
        Where the series comes from, for notes.
    """

    name: str

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        found = []
        first, last = float(self.times[0]) + shift, float(self.times[-1]) + shift
        if first > 0.0:
            found.append(Note("signals.held_before", name, source=self.name, value=float(self.values[0]), time=first))
        if last < duration:
            found.append(Note("signals.held_after", name, source=self.name, value=float(self.values[-1]), time=last))
        return tuple(found)


@dataclass(frozen=True)
class _Wave(Signal):
    mean: float
    amplitude: float
    frequency: float

    def __post_init__(self) -> None:
        problems = []
        for name, value in vars(self).items():
            if name in ("mean", "amplitude", "phase"):
                problems += not_finite(**{name: value})
            elif value is not None:  # a sweep may last as long as the run
                problems += not_positive("s" if name == "duration" else "Hz", **{name: value})
        collect(problems)

    def bounds(self) -> tuple[float, float]:
        return self.mean - abs(self.amplitude), self.mean + abs(self.amplitude)


@dataclass(frozen=True)
class Sine(_Wave):
    r"""A sine about a mean.

    .. math:: u(t) = \bar u + a \sin(2 \pi f t + \varphi)

    Parameters
    ----------
    mean : float
        In SI.
    amplitude : float
        In SI.
    frequency : float
        Positive [Hz].
    phase : float, optional
        At t = 0 [rad].
    """

    phase: float = 0.0

    def segments(self, until: float, duration: float | None) -> SegmentTable:
        return wave(self.mean, self.amplitude, self.phase, [0.0], [self.frequency], [0.0])


@dataclass(frozen=True)
class Chirp(_Wave):
    r"""A sine whose frequency sweeps linearly and then stays.

    .. math:: f(t) = f_0 + (f_1 - f_0) \min(t / T, 1)

    Parameters
    ----------
    mean : float
        In SI.
    amplitude : float
        In SI.
    frequency : float
        At t = 0, positive [Hz].
    end_frequency : float
        From the end of the sweep on, positive [Hz].
    duration : float, optional
        Of the sweep; the run's when not given [s].
    phase : float, optional
        At t = 0 [rad].

    Examples
    --------
    >>> len(Chirp(0.0, 1.0, 0.5, 5.0, duration=10.0).table(20.0))
    2
    """

    end_frequency: float
    duration: float | None = None
    phase: float = 0.0

    def segments(self, until: float, duration: float | None) -> SegmentTable:
        sweep = self.duration if self.duration is not None else duration
        if sweep is None:
            raise InputError("signals.chirp_duration")
        rate = (self.end_frequency - self.frequency) / sweep
        starts, frequencies, rates = [0.0, sweep], [self.frequency, self.end_frequency], [rate, 0.0]
        n = 2 if sweep < until else 1
        return wave(self.mean, self.amplitude, self.phase, starts[:n], frequencies[:n], rates[:n])


@dataclass(frozen=True)
class Prbs(Signal):
    """A pseudo-random binary signal: each bit lasts `bit_time` and is low or high with equal chance.

    Parameters
    ----------
    low, high : float
        The two levels, low below high, in SI.
    bit_time : float
        Positive [s].
    seed : int, optional
        Not negative; the same seed gives the same bits.

    Notes
    -----
    The bits are the leading ones of the raw PCG64 stream, whose values NumPy keeps from version to version; a
    longer run continues the bits of a shorter one.

    Examples
    --------
    >>> Prbs(0.0, 1.0, 0.1, seed=1).table(1.0).start.round(1).tolist()
    [0.0, 0.2, 0.3, 0.4, 0.6, 0.7, 0.8, 0.9]
    """

    low: float
    high: float
    bit_time: float
    seed: int = 0

    def __post_init__(self) -> None:
        problems = not_finite(low=self.low, high=self.high) + not_positive("s", bit_time=self.bit_time)
        if self.low >= self.high:
            problems.append(InputError("signals.order", low=self.low, high=self.high))
        if isinstance(self.seed, bool) or not isinstance(self.seed, int) or self.seed < 0:
            problems.append(InputError("signals.seed", seed=self.seed))
        collect(problems)

    def bounds(self) -> tuple[float, float]:
        return self.low, self.high

    def segments(self, until: float, duration: float | None) -> SegmentTable:
        n = until / self.bit_time
        if n > _MOST_BITS:
            raise InputError("signals.too_many_bits", bit_time=self.bit_time, bits=n, until=until, limit=_MOST_BITS)
        bits = np.random.PCG64(self.seed).random_raw(math.ceil(n)) >> np.uint64(63)
        changed = np.concatenate(([0], np.flatnonzero(np.diff(bits)) + 1))
        start = changed * self.bit_time
        changed, start = changed[start < until], start[start < until]
        value = np.where(bits[changed] == 1, self.high, self.low)
        return lines(start, value, np.zeros(len(start)), np.arange(len(start)) > 0)


class _Pulses(Signal):
    """Two levels in turn: high from the start of each period for its duty, then low."""

    if TYPE_CHECKING:  # declared below, in the order of each kind
        low: float
        high: float
        frequency: float
        duty: float | Signal

    def __post_init__(self) -> None:
        problems = not_finite(low=self.low, high=self.high) + not_positive("Hz", frequency=self.frequency)
        least, most = self.duty.bounds() if isinstance(self.duty, Signal) else (self.duty, self.duty)
        problems += not_finite(duty=least)
        collect(problems)
        if self.low >= self.high:
            problems.append(InputError("signals.order", low=self.low, high=self.high))
        if not 0.0 <= least <= most <= 1.0:
            problems.append(InputError("signals.duty", least=least, most=most))
        collect(problems)

    def bounds(self) -> tuple[float, float]:
        return self.low, self.high

    def segments(self, until: float, duration: float | None) -> SegmentTable:
        if until * self.frequency > _MOST_PERIODS:
            raise InputError(
                "signals.too_many_periods", frequency=self.frequency, periods=until * self.frequency, until=until,
                limit=_MOST_PERIODS,
            )  # fmt: skip
        number = np.arange(math.ceil(until * self.frequency))
        # Each edge is one division, so that it is the double nearest to the decimal that is meant.
        begin = number / self.frequency
        number, begin = number[begin < until], begin[begin < until]
        duty = self.duty.evaluate(begin, duration) if isinstance(self.duty, Signal) else np.full(len(begin), self.duty)
        end = (number + duty) / self.frequency
        start = np.column_stack([begin, end]).ravel()
        is_high = np.column_stack([end > begin, duty >= 1.0]).ravel()
        # A period of duty 0 or 1 has one edge at most, and none where the last one ended alike.
        is_edge = np.append(True, is_high[1:] != is_high[:-1]) & (start < until)
        start, value = start[is_edge], np.where(is_high[is_edge], self.high, self.low)
        return lines(start, value, np.broadcast_to(0.0, start.shape), np.arange(len(start)) > 0)


@dataclass(frozen=True)
class Square(_Pulses):
    """A square wave: high from the start of each period on, then low.

    Parameters
    ----------
    low, high : float
        The two levels, low below high, in SI.
    frequency : float
        Positive [Hz].
    duty : float, optional
        Part of each period that is high, 0 to 1.

    Notes
    -----
    Period k begins at k / frequency, and its high part ends at (k + duty) / frequency. Every edge is a breakpoint of
    the integrator, so that no pulse is missed, however long the steps are.

    Examples
    --------
    >>> wave = Square(0.0, 1.0, 10.0, duty=0.3)
    >>> wave.table(0.2).start.tolist(), wave.evaluate([0.1, 0.129, 0.13]).tolist()
    ([0.0, 0.03, 0.1, 0.13], [1.0, 1.0, 0.0])
    """

    low: float
    high: float
    frequency: float
    duty: float = 0.5


@dataclass(frozen=True)
class Pwm(_Pulses):
    """Pulse-width modulation: pulses of one frequency whose width is a number or another signal.

    Parameters
    ----------
    frequency : float
        Of the carrier, positive [Hz].
    duty : float or Signal
        Part of each period that is high, 0 to 1. Of a signal the value at the start of a period counts for the whole
        period, as in a timer whose compare register is loaded there.
    low, high : float, optional
        The two levels, low below high, in SI.

    Notes
    -----
    Period k begins at k / frequency, and its pulse ends at (k + duty) / frequency. A duty of 0 leaves the pulse out,
    one of 1 joins it to the next. Every edge is a breakpoint of the integrator, so that no pulse is missed, however
    long the steps are. A run keeps 17 bytes of each edge, whatever else drives the circuit.

    Examples
    --------
    >>> half_then_all = Pwm(10.0, Steps([0.0, 0.15], [0.5, 1.0]))
    >>> half_then_all.table(0.4).start.tolist()
    [0.0, 0.05, 0.1, 0.15, 0.2]
    """

    frequency: float
    duty: float | Signal
    low: float = 0.0
    high: float = 1.0

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        return self.duty.notes(duration, name, shift) if isinstance(self.duty, Signal) else ()
