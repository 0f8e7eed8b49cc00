"""Measurement after reading: channels and inputs in SI units with one common time origin."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.timeseries.checks import FloatArray


@dataclass(frozen=True, eq=False)
class Channel:
    """Measured signal with which an output of the model is compared.

    The values are in SI units, and pressures are absolute.
    """

    address: str  # `tank.pressure`
    time: FloatArray  # (n,), strictly increasing, from 0 at the first used sample of the recording [s]
    values: FloatArray  # (n,), in `unit`
    unit: str
    noise: float | None = None  # stated standard deviation; None: to be estimated
    lag: float | None = 0.0  # time constant of the sensor; None if free [s]
    quantum: float = 0.0  # resolution of the recording; 0 if unknown
    # Standard deviation of the sensor offset: None if not stated, infinite for a free offset without prior.
    offset: float | None = None
    offset_mean: float = 0.0  # expected value of the sensor offset


@dataclass(frozen=True, eq=False)
class InputChannel:
    """Measured signal that drives an input of the model.

    The values are in SI units, and pressures are absolute.
    """

    address: str  # `inlet.mass_flow_rate`
    # (n,), on the clock of the channels; samples before their first used sample have negative times [s]
    time: FloatArray
    values: FloatArray  # (n,), in `unit`
    unit: str
    delay: float | None = 0.0  # an event at t was recorded at t + delay; None if free [s]
    lag: float | None = 0.0  # time constant of the sensor; None if free [s]
    hold: bool = False  # True: constant until the next sample (a sampled command); False: linear interpolation


@dataclass(frozen=True, eq=False)
class Measurement:
    """Recording of one test: measured channels and inputs, initial values and notes."""

    name: str
    channels: tuple[Channel, ...]  # compared with the model
    inputs: tuple[InputChannel, ...] = ()  # drive the model
    # Map from the address of an initial value to `first`, `free`, or the value as written.
    start: Mapping[str, str | float] = field(default_factory=dict)
    ambient_pressure: float = 101325.0  # absolute, to which gauge values refer [Pa]
    notes: tuple[Note, ...] = ()  # guesses, merged and omitted samples
    findings: tuple[Note, ...] = ()  # suspicions with their evidence
    duration: float = 0.0  # time of the last sample of a channel [s]


_MIN_LEVELS = 4  # distinct values needed to find a resolution
_MAX_DISTINCT = 0.9  # limit of distinct values, relative to the samples: a ramp has equal steps but no repeated value
_ROUNDS = 6
_WITHIN = 3.0  # limit of noise in standard deviations; larger deviations are jumps of the signal
# A normal distribution truncated at three standard deviations has 0.9866 times the standard deviation.
_CUT = math.sqrt(
    1.0 - 2.0 * _WITHIN * math.exp(-0.5 * _WITHIN**2) / math.sqrt(2.0 * math.pi) / math.erf(_WITHIN / 2**0.5)
)


def quantum_of(values: FloatArray) -> float:
    """Estimate the resolution of recorded values: their smallest step.

    The result is 0 if the values are not multiples of a common step.

    Examples
    --------
    >>> round(quantum_of(np.array([0.1, 0.3, 0.4, 0.4, 0.7, 0.6])), 9)
    0.1
    >>> quantum_of(np.sin(np.arange(50.0)))
    0.0
    """
    levels = np.unique(values)
    if levels.size < _MIN_LEVELS or levels.size > _MAX_DISTINCT * values.size:
        return 0.0
    steps = np.diff(levels)
    steps = steps[steps > 1e-9 * float(np.max(np.abs(levels)))]  # smaller steps are rounding errors of a conversion
    if steps.size < _MIN_LEVELS - 1:
        return 0.0
    step = float(np.min(steps))
    counts = np.rint(steps / step)
    if np.mean(np.abs(steps / step - counts) < 0.05) < 0.95:
        return 0.0
    return float(np.sum(steps) / np.sum(counts))


def noise_of(values: FloatArray, time: FloatArray | None = None) -> float:
    r"""Estimate the standard deviation of the noise from differences between neighbouring samples.

    .. math:: e_k = x_k - \frac{x_{k-1} + x_{k+1}}{2}, \qquad
        \sigma^2 = \tfrac{2}{3}\,\overline{e_k^2}

    Notes
    -----
    Rare jumps are excluded. Filtered noise is underestimated, and curvature within three samples counts as noise.

    Examples
    --------
    >>> x = 5.0 * np.arange(2000.0) + np.random.default_rng(1).normal(0.0, 0.3, 2000)
    >>> abs(noise_of(x) - 0.3) < 0.02
    True
    """
    floor = quantum_of(values) / math.sqrt(12.0)
    if values.size < 3:
        return floor
    base = np.arange(values.size, dtype=float) if time is None else time
    # Weights of linear interpolation between the neighbours.
    weight = (base[2:] - base[1:-1]) / (base[2:] - base[:-2])
    scatter = values[1:-1] - weight * values[:-2] - (1.0 - weight) * values[2:]
    scatter = np.abs(scatter) / np.sqrt(1.0 + weight**2 + (1.0 - weight) ** 2)
    # Start with the median, which is robust to jumps; for normal noise, sigma is 1.4826 times the median.
    sigma = max(1.4826 * float(np.median(scatter)), floor)
    for _ in range(_ROUNDS):
        inliers = scatter[scatter <= _WITHIN * sigma]
        if not inliers.size:
            break
        sigma = max(float(np.sqrt(np.mean(inliers**2))) / _CUT, floor)
    return sigma


LEAST_SAMPLES = 8  # with fewer samples, noise and curvature cannot be distinguished


@dataclass(frozen=True, eq=False)
class ColumnSamples:
    """Samples of a column without NaN, with notes on merged and omitted samples."""

    time: FloatArray  # (n,), strictly increasing [s]
    values: FloatArray  # (n,)
    notes: tuple[Note, ...] = ()  # without an address


def ordered(time: FloatArray, values: FloatArray) -> ColumnSamples:
    """Return the finite samples of a column, with strictly increasing times.

    Samples with equal times become one sample with their mean. Times that decrease raise an error.

    Examples
    --------
    >>> ordered(np.array([0.0, 1.0, 1.0, 2.0]), np.array([5.0, 6.0, 8.0, 7.0])).values.tolist()
    [5.0, 7.0, 7.0]
    """
    # A short column of a table is padded at its end; the padding is not counted as lost.
    is_filled = np.flatnonzero(np.isfinite(time) | np.isfinite(values))
    end = int(is_filled[-1]) + 1 if is_filled.size else 0
    time, values = time[:end], values[:end]
    is_finite = np.isfinite(time) & np.isfinite(values)
    n_lost = end - int(np.count_nonzero(is_finite))
    notes = [Note("measured.empty_cells", lost=n_lost, total=end)] if n_lost else []
    time, values = time[is_finite], values[is_finite]
    if not time.size:
        raise InputError("measured.no_numbers")
    reversals = np.flatnonzero(np.diff(time) < 0.0)
    if reversals.size:
        k = int(reversals[0])
        raise InputError("measured.backwards", time=float(time[k]), next=float(time[k + 1]))
    stamps, stamp_index, count = np.unique(time, return_inverse=True, return_counts=True)
    if stamps.size < time.size:
        notes.append(Note("measured.repeated_stamps", count=time.size - stamps.size))
    return ColumnSamples(stamps, np.bincount(stamp_index, values) / count, tuple(notes))


def cut_window(samples: list[ColumnSamples], skip: float, end: float = math.inf) -> tuple[float, list[ColumnSamples]]:
    """Return the start of a time window, and the samples of all channels in this window.

    The limits `skip` and `end` are relative to the first sample of all channels [s]. The start is the first sample time
    in the window [s]. It is subtracted from the times of the samples.
    """
    first = min(float(column.time[0]) for column in samples)
    begin = first + skip
    # The tolerance includes a stamp at the limit despite rounding.
    slack = 1e-9 * max(abs(begin), skip)
    windows = []
    for column in samples:
        is_used = (column.time >= begin - slack) & (column.time <= first + end + slack)
        windows.append(ColumnSamples(column.time[is_used], column.values[is_used], column.notes))
    origin = min((float(column.time[0]) for column in windows if column.time.size), default=begin)
    return origin, [replace(column, time=column.time - origin) for column in windows]
