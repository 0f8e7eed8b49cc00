"""Kinds of input signals over time, for example steps, ramps, sines and pulses.

Each signal consists of segments; a segment is a straight line plus a swept sine.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, raise_errors
from poppet.timeseries.checks import not_finite, not_positive, numbers, path_problems
from poppet.timeseries.segments import DelayedSegments, Floats, SegmentTable, Signal, held, lines, merge, polyline, wave

__all__ = [
    "Chirp", "Constant", "DelayedSegments", "Points", "Prbs", "Pwm", "SampledSignal", "SegmentTable", "Signal",
    "Sine", "Square", "Steps", "merge",
]  # fmt: skip

_MAX_BITS = 10_000_000  # the start times alone take 80 MB
_MAX_PERIODS = _MAX_BITS // 2  # two edges per period


@dataclass(frozen=True, eq=False)
class _Course(Signal):
    """Base class of signals that are defined by values at strictly increasing times.

    The first time is not negative. The arrays are read-only.
    """

    times: Floats
    values: Floats

    def __post_init__(self) -> None:
        name = self.name if isinstance(self, SampledSignal) else type(self).__name__.lower()
        times, values = numbers(f"{name}: times", self.times), numbers(f"{name}: values", self.values)
        raise_errors(path_problems(name, times, values))
        for field, series in (("times", times), ("values", values)):
            series.flags.writeable = False
            object.__setattr__(self, field, series)

    def bounds(self) -> tuple[float, float]:
        return float(np.min(self.values)), float(np.max(self.values))

    def segments(self, end: float, duration: float | None) -> SegmentTable:
        return polyline(np.asarray(self.times), np.asarray(self.values), end)


@dataclass(frozen=True)
class Constant(Signal):
    """Signal with one constant value.

    Parameters
    ----------
    value : float
        Value in SI.

    Examples
    --------
    >>> float(Constant(2e5).evaluate(3.0))
    200000.0
    """

    value: float

    def __post_init__(self) -> None:
        raise_errors(not_finite(value=self.value))

    def bounds(self) -> tuple[float, float]:
        return self.value, self.value

    def segments(self, end: float, duration: float | None) -> SegmentTable:
        return held(self.value)


@dataclass(frozen=True, eq=False)
class Steps(_Course):
    """Signal that changes in steps.

    At the time of a step, the signal has the value after the step.

    Parameters
    ----------
    times : (n,) array
        Start of each value, strictly increasing from 0 [s].
    values : (n,) array
        Values in SI.

    Notes
    -----
    A step at or after the end of the run has no effect. The method `notes` then returns a note.

    Examples
    --------
    >>> Steps([0.0, 20.0, 40.0], [1e5, 2e5, 0.0]).evaluate([19.9, 20.0, 50.0]).tolist()
    [100000.0, 200000.0, 0.0]
    """

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.times[0] != 0.0:
            raise InputError("signals.no_first_step", time=float(self.times[0]))

    def segments(self, end: float, duration: float | None) -> SegmentTable:
        n = int(np.searchsorted(self.times, end, side="left"))
        start, value = np.asarray(self.times)[:n], np.asarray(self.values)[:n]
        return lines(start, value, np.zeros(n), np.diff(value, prepend=value[0]) != 0.0)

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        unused = int(np.count_nonzero(np.asarray(self.times) + shift >= duration))
        if not unused:
            return ()
        return (Note("signals.steps_unused", name, unused=unused, total=len(self.times), end=duration),)


@dataclass(frozen=True, eq=False)
class Points(_Course):
    """Signal that consists of straight lines between points.

    Before the first point, it has the first value, and after the last point the last value.

    Parameters
    ----------
    times : (n,) array
        Times, not negative, strictly increasing [s].
    values : (n,) array
        Values in SI.

    Examples
    --------
    >>> ramp = Points([1.0, 3.0], [0.0, 4e5])
    >>> ramp.evaluate([0.0, 2.0, 9.0]).tolist()
    [0.0, 200000.0, 400000.0]
    >>> print(*ramp.notes(9.0, "valve.pilot_pressure"))
    valve.pilot_pressure has no values after t = 3 s. From then on, the last value, 400000, is used.
    """

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        last, end = float(self.values[-1]), float(self.times[-1]) + shift
        if len(self.times) == 1 or end >= duration:
            return ()
        return (Note("signals.held_after", name, source="", value=last, time=end),)


@dataclass(frozen=True, eq=False)
class SampledSignal(_Course):
    """Measured signal, interpolated linearly between its samples.

    Before the first sample, it has the first value, and after the last sample the last value.

    Parameters
    ----------
    times : (n,) array
        Times, not negative, strictly increasing [s].
    values : (n,) array
        Values in SI.
    name : str
        Origin of the series, for notes.
    """

    name: str

    def notes(self, duration: float, name: str, shift: float = 0.0) -> tuple[Note, ...]:
        notes = []
        first, last = float(self.times[0]) + shift, float(self.times[-1]) + shift
        if first > 0.0:
            notes.append(Note("signals.held_before", name, source=self.name, value=float(self.values[0]), time=first))
        if last < duration:
            notes.append(Note("signals.held_after", name, source=self.name, value=float(self.values[-1]), time=last))
        return tuple(notes)


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
            elif value is not None:  # None: the sweep lasts as long as the run
                problems += not_positive("s" if name == "duration" else "Hz", **{name: value})
        raise_errors(problems)

    def bounds(self) -> tuple[float, float]:
        return self.mean - abs(self.amplitude), self.mean + abs(self.amplitude)


@dataclass(frozen=True)
class Sine(_Wave):
    r"""Sinusoidal signal about a mean value.

    .. math:: u(t) = \bar u + a \sin(2 \pi f t + \varphi)

    Parameters
    ----------
    mean : float
        Mean value in SI.
    amplitude : float
        Amplitude in SI.
    frequency : float
        Frequency, positive [Hz].
    phase : float, optional
        Phase at t = 0 [rad].
    """

    phase: float = 0.0

    def segments(self, end: float, duration: float | None) -> SegmentTable:
        return wave(self.mean, self.amplitude, self.phase, [0.0], [self.frequency], [0.0])


@dataclass(frozen=True)
class Chirp(_Wave):
    r"""Sinusoidal signal whose frequency changes linearly and then stays constant.

    .. math:: f(t) = f_0 + (f_1 - f_0) \min(t / T, 1)

    Parameters
    ----------
    mean : float
        Mean value in SI.
    amplitude : float
        Amplitude in SI.
    frequency : float
        Frequency at t = 0, positive [Hz].
    end_frequency : float
        Frequency at and after the end of the sweep, positive [Hz].
    duration : float, optional
        Duration of the sweep [s] (default: duration of the run).
    phase : float, optional
        Phase at t = 0 [rad].

    Examples
    --------
    >>> len(Chirp(0.0, 1.0, 0.5, 5.0, duration=10.0).table(20.0))
    2
    """

    end_frequency: float
    duration: float | None = None
    phase: float = 0.0

    def segments(self, end: float, duration: float | None) -> SegmentTable:
        sweep = self.duration if self.duration is not None else duration
        if sweep is None:
            raise InputError("signals.chirp_duration")
        rate = (self.end_frequency - self.frequency) / sweep
        starts, frequencies, rates = [0.0, sweep], [self.frequency, self.end_frequency], [rate, 0.0]
        n = 2 if sweep < end else 1
        return wave(self.mean, self.amplitude, self.phase, starts[:n], frequencies[:n], rates[:n])


@dataclass(frozen=True)
class Prbs(Signal):
    """Pseudo-random binary signal.

    Each bit lasts `bit_time`. Its level is low or high with equal probability.

    Parameters
    ----------
    low, high : float
        Levels in SI, low below high.
    bit_time : float
        Duration of a bit, positive [s].
    seed : int, optional
        Seed, not negative; the same seed gives the same bits.

    Notes
    -----
    The bits are the most significant bits of the raw PCG64 stream, whose values are the same in all NumPy versions.
    The first bits of a long run are equal to the bits of a shorter run.

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
        raise_errors(problems)

    def bounds(self) -> tuple[float, float]:
        return self.low, self.high

    def segments(self, end: float, duration: float | None) -> SegmentTable:
        n = end / self.bit_time
        if n > _MAX_BITS:
            raise InputError("signals.too_many_bits", bit_time=self.bit_time, bits=n, until=end, limit=_MAX_BITS)
        return self._bits(0, end)

    def window(self, begin: float, end: float, duration: float | None) -> SegmentTable:
        return self._bits(max(0, math.floor(begin / self.bit_time) - 1), end)

    def _bits(self, first: int, end: float) -> SegmentTable:
        """Return the segments from the bit with the index `first` on that begin before the time `end`."""
        last = max(first + 1, math.ceil(end / self.bit_time))
        bits = np.random.PCG64(self.seed).advance(first).random_raw(last - first)
        bits >>= np.uint64(63)
        changed = np.concatenate(([0], np.flatnonzero(np.diff(bits)) + 1))
        start = (first + changed) * self.bit_time
        changed, start = changed[start < end], start[start < end]
        value = np.where(bits[changed] == 1, self.high, self.low)
        return lines(start, value, np.zeros(len(start)), np.arange(len(start)) > 0)


class _Pulses(Signal):
    """Base class of signals that alternate between a high and a low level.

    Each period begins with the high level. `duty` is the fraction of the period with this level.
    """

    if TYPE_CHECKING:  # declared in each subclass in its own order
        low: float
        high: float
        frequency: float
        duty: float | Signal

    def __post_init__(self) -> None:
        problems = not_finite(low=self.low, high=self.high) + not_positive("Hz", frequency=self.frequency)
        smallest, largest = self.duty.bounds() if isinstance(self.duty, Signal) else (self.duty, self.duty)
        problems += not_finite(duty=smallest)
        raise_errors(problems)
        if self.low >= self.high:
            problems.append(InputError("signals.order", low=self.low, high=self.high))
        if not 0.0 <= smallest <= largest <= 1.0:
            problems.append(InputError("signals.duty", least=smallest, most=largest))
        raise_errors(problems)

    def bounds(self) -> tuple[float, float]:
        return self.low, self.high

    def segments(self, end: float, duration: float | None) -> SegmentTable:
        if end * self.frequency > _MAX_PERIODS:
            raise InputError(
                "signals.too_many_periods", frequency=self.frequency, periods=end * self.frequency, until=end,
                limit=_MAX_PERIODS,
            )  # fmt: skip
        return self._periods(0, end, duration)

    def window(self, begin: float, end: float, duration: float | None) -> SegmentTable:
        return self._periods(max(0, math.floor(begin * self.frequency) - 1), end, duration)

    def _periods(self, first: int, end: float, duration: float | None) -> SegmentTable:
        """Return the segments from the period with the index `first` on that begin before the time `end`."""
        # The product of the smallest numbers is rounded to 0.
        number = np.arange(first, max(first + 1, math.ceil(end * self.frequency)))
        # One division per edge gives the double nearest to the intended decimal value.
        begin = number / self.frequency
        number, begin = number[begin < end], begin[begin < end]
        if isinstance(self.duty, Signal):
            # The limit of a window is exclusive, see `evaluate`.
            limit = math.nextafter(float(begin[-1]), math.inf) if begin.size else end
            duty = self.duty.window(float(begin[0]) if begin.size else 0.0, limit, duration).evaluate(begin)
        else:
            duty = np.full(len(begin), self.duty)
        fall = (number + duty) / self.frequency
        start = np.column_stack([begin, fall]).ravel()
        is_high = np.column_stack([fall > begin, duty >= 1.0]).ravel()
        # A period with duty 0 or 1 has at most one edge, and none if the level does not change.
        is_edge = np.append(True, is_high[1:] != is_high[:-1]) & (start < end)
        start, value = start[is_edge], np.where(is_high[is_edge], self.high, self.low)
        return lines(start, value, np.broadcast_to(0.0, start.shape), np.arange(len(start)) > 0)


@dataclass(frozen=True)
class Square(_Pulses):
    """Square wave, which is high at the start of each period and then low.

    Parameters
    ----------
    low, high : float
        Levels in SI, low below high.
    frequency : float
        Frequency, positive [Hz].
    duty : float, optional
        Fraction of each period at the high level, 0 to 1.

    Notes
    -----
    Period k begins at k / frequency, and its high level ends at (k + duty) / frequency. Each edge is a breakpoint of
    the integrator, so a long step does not miss a pulse.

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
    """Pulse-width modulated signal of constant frequency, with fixed or variable pulse width.

    Parameters
    ----------
    frequency : float
        Carrier frequency, positive [Hz].
    duty : float or Signal
        Fraction of each period at the high level, 0 to 1. The value of a signal at the start of a period applies to the
        whole period. A timer that loads its compare register at this time behaves in the same way.
    low, high : float, optional
        Levels in SI, low below high.

    Notes
    -----
    Period k begins at k / frequency, and its pulse ends at (k + duty) / frequency. A duty of 0 omits the pulse, and a
    duty of 1 joins it to the next pulse. Each edge is a breakpoint of the integrator, so a long step does not miss a
    pulse. A run stores 17 bytes per edge.

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
