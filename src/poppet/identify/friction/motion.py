"""Evaluation of recorded motions, which gives velocities, strokes, reversals and rows for friction laws.

A stroke is the motion in one direction between two reversals. It is divided into blocks of one window. Each block gives
one row: the slope of a line through its positions, and the means of the other channels. Velocity and force therefore
have equal smoothing, and two rows have no sample in common.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace

import numpy as np
from numpy.typing import NDArray

from poppet.identify.friction.records import FrictionRecord
from poppet.timeseries.checks import FloatArray

STEADY = 0.03
"""Noise of a velocity, relative to the typical speed of its stroke, for which a window is chosen."""
SHORTEST, FEWEST = 5, 4
"""Minimum number of samples of a window, and minimum number of windows of a stroke."""
TURNS = 8.0
"""Minimum travel after a reversal, in standard deviations of the smoothed position."""
MOVING = 3.0
"""Velocity above which a body moves, in standard deviations."""
CREEPS = 0.005
"""Speed below which a body is at rest, as a fraction of the typical speed of a stroke."""
HALF_POWER = 0.5777
"""Frequency times window at which the power of a slope is halved.

With u = pi f W, the slope of a sine is 3 (sin u - u cos u)/u^3 of the true slope."""
BENT, WAYS = 0.9, 3.0
"""Fraction of the change between two sliding forces, and factor on the distance of that fraction.

Steady sliding starts at this multiple of the distance. If the change decays as exp(-d/delta), 0.1 % then remains."""
CHANGED = 2.0
"""Ratio of speeds within the bending distance above which a row is not steady sliding."""
SMALL = 0.1
"""Length below which a stroke is ignored for the bending distance, as a fraction of the longest stroke."""
PARABOLA = np.array([-3.0, 12.0, 17.0, 12.0, -3.0]) / 35.0
"""Weights of five samples for the value of a parabola in their middle (Savitzky & Golay 1964)."""
ROUNDED = 12.0 / 35.0
"""Rounding of the corner of a sudden reversal by that parabola, in distances between samples."""


@dataclass(frozen=True, eq=False)
class SlidingRows:
    """Samples of velocity and friction for the fit of a friction law.

    A sample is a point of a table, or the mean of a block of a recording. All arrays have the shape (n,).
    """

    velocity: FloatArray  # [m/s]
    friction: FloatArray  # force against the motion, with the sign of the velocity and the offset of the sensor [N]
    pressure: FloatArray  # magnitude of the difference across the seals [Pa]
    force: FloatArray  # as measured [N]
    weight: FloatArray
    time: FloatArray  # NaN in a table
    position: FloatArray  # NaN if it is unknown
    distance: FloatArray  # distance since the last stop or reversal; infinite in a table [m]
    record: NDArray[np.int_]
    stroke: NDArray[np.int_]  # index of the stroke, counted over all recordings; -1 in a table

    def __len__(self) -> int:
        return int(self.velocity.size)

    def of(self, selected: NDArray[np.bool_]) -> SlidingRows:
        """Return the samples that the mask or index array `selected` selects."""
        return SlidingRows(*(getattr(self, field.name)[selected] for field in fields(self)))

    @property
    def sign(self) -> FloatArray:
        """Direction of the friction at each sample: the sign of the velocity.

        If the velocity is zero, it is the sign of the friction.
        """
        return np.where(self.velocity != 0.0, np.sign(self.velocity), np.sign(self.friction))


@dataclass(frozen=True, eq=False)
class Reversal:
    """Stroke of a recording that begins with a reversal of the motion.

    Its samples contain the deflection of the bristles, the elastic contact in the friction model. Arrays have the shape
    (n,).
    """

    distance: FloatArray  # from the start of the stroke [m]
    friction: FloatArray  # [N]
    velocity: FloatArray  # [m/s]
    pressure: FloatArray  # [Pa]
    record: int
    stroke: int
    sign: float
    previous_length: float  # length of the previous stroke, in the opposite direction; 0 if there is none [m]
    rounding: float  # rounding of the corner by smoothing [m]
    step: float  # time between samples [s]
    window: float  # window of the velocity [s]
    last: Reversal | None  # previous stroke, in the opposite direction

    def blocks(self, time: FloatArray, position: FloatArray, force: FloatArray, sigma: float) -> SlidingRows:
        """Divide the stroke into blocks of equal duration, and return one sample for each block.

        The velocity is the slope of a line through the positions of the block. The other channels are mean values.
        `sigma` is the standard deviation of a velocity.

        The first and the last block are omitted, because they contain reversals. Blocks at rest are also omitted.
        """
        block = np.floor((time - time[0]) / self.window + 1e-9).astype(int)
        starts = np.flatnonzero(np.diff(block, prepend=-1))
        count = np.diff([*starts, time.size])

        def mean(values: FloatArray) -> FloatArray:
            return np.asarray(np.add.reduceat(values, starts) / count)

        t, x = time - np.repeat(mean(time), count), position - np.repeat(mean(position), count)
        spread = np.add.reduceat(t * t, starts)
        slope = np.add.reduceat(t * x, starts) / np.where(spread > 0.0, spread, 1.0)
        typical = float(np.quantile(np.abs(slope), 0.75))
        is_sliding = self.sign * slope > max(MOVING * sigma, CREEPS * typical)
        is_sliding[[0, -1]] = False
        means = [mean(values) for values in (self.friction, self.pressure, force)]
        coordinates = [mean(values) for values in (time, position, np.maximum(self.distance, 0.0))]
        indices = (np.full(count.size, value) for value in (self.record, self.stroke))
        columns = slope, *means, count.astype(float), *coordinates, *indices
        return SlidingRows(*(values[is_sliding] for values in columns))


@dataclass(frozen=True, eq=False)
class RecordedMotion:
    """Smoothed recording of a moving body, divided into strokes, or the points of a friction table."""

    rows: SlidingRows
    reversals: tuple[Reversal, ...]
    windows: tuple[float, ...] = ()  # window of each stroke [s]
    velocity_noise: tuple[float, ...] = ()  # standard deviation of a velocity of each stroke [m/s]
    resolution: float = 0.0  # standard deviation of a smoothed position [m]
    smear: float = 1.0  # rms residual of the lines through the windows, in standard deviations
    left_out: int = 0  # number of omitted strokes, which are too short


def rows_of_table(record: FrictionRecord, index: int) -> RecordedMotion:
    """Return the points of a friction table as samples for a fit.

    `index` is the index of the table.
    """
    assert record.velocity is not None
    n, unknown = len(record), np.full(len(record), math.nan)
    weight = np.ones(n) if record.uncertainty is None else record.uncertainty**-2.0
    position = unknown if record.position is None else record.position
    ends = np.full(n, math.inf), np.full(n, index), np.full(n, -1)
    series = record.velocity, _friction(record), _pressure(record), record.force, weight, unknown, position
    return RecordedMotion(SlidingRows(*series, *ends), ())


def rows_of_recording(
    record: FrictionRecord, index: int, first_stroke: int, window: float | None, mass: float
) -> RecordedMotion:
    """Divide the recording of a moving body into strokes, and each stroke into blocks.

    The result contains samples of steady motion and reversals. `index` is the index of the recording, and
    `first_stroke` the index of its first stroke. If `window`, the duration of a block, is None, it depends on the speed
    of each stroke. `mass` is the mass of the body.
    """
    time, position = record.time, record.position
    assert time is not None
    step = float(np.median(np.diff(time)))
    if position is None:
        assert record.velocity is not None
        steps = 0.5 * (record.velocity[1:] + record.velocity[:-1]) * np.diff(time)
        position = np.concatenate([[0.0], np.cumsum(steps)])
    # Many samples of a quantised position are equal; otherwise the minimum difference is random.
    levels = np.diff(np.unique(position))
    resolution = float(levels.min()) / math.sqrt(12.0) if 0 < levels.size < 0.8 * position.size else 0.0
    # The noise is the residual of lines through five samples, and at least that of the resolution.
    noise = max(_fit_lines(time, position, 2.0 * step)[2], resolution)
    # The window of a velocity would round the corner of a reversal.
    smooth = position.copy()
    smooth[2:-2] = np.convolve(position, PARABOLA, "valid")
    resolution = noise * float(np.linalg.norm(PARABOLA))
    ranges, left_out = _split_strokes(smooth, max(TURNS * resolution, 1e-3 * float(np.ptp(smooth))))
    friction, pressure = _friction(record), _pressure(record)
    rows, strokes = [], list[Reversal]()
    statistics: list[tuple[float, float, float]] = []
    for k, (samples, sign, previous_length) in enumerate(ranges):
        t, x = time[samples], position[samples]
        width = max(window, 3.0 * step) if window else SHORTEST * step
        while True:
            _, speed, misfit = _fit_lines(t, x, 0.5 * width)
            sigma = noise * math.sqrt(12.0 / (width / step) ** 3) / step
            is_steady_enough = sigma <= STEADY * float(np.quantile(np.abs(speed), 0.75))
            if window or is_steady_enough or 1.3 * width > max(t.size / FEWEST, SHORTEST) * step:
                break
            width *= 1.3
        stroke = Reversal(
            distance=sign * (smooth[samples] - smooth[samples][0]),
            friction=friction[samples] - (mass * np.gradient(speed, t) if mass else 0.0),
            velocity=speed,
            pressure=pressure[samples],
            record=index,
            stroke=first_stroke + k,
            sign=sign,
            previous_length=previous_length,
            rounding=ROUNDED * step * float(np.median(np.abs(speed))),
            step=step,
            window=width,
            last=replace(strokes[-1], last=None) if previous_length > 0.0 else None,
        )
        strokes.append(stroke)
        rows.append(stroke.blocks(t, x, record.force[samples], sigma))
        statistics.append((width, sigma, misfit))
    windows, noises, misfits = np.array(statistics).reshape(-1, 3).T.tolist()
    smear = float(np.median(misfits)) / noise if noise > 0.0 and misfits else 1.0
    reversals = tuple(stroke for stroke in strokes if stroke.last is not None)
    return RecordedMotion(stack_rows(rows), reversals, tuple(windows), tuple(noises), resolution, smear, left_out)


def stack_rows(rows: Sequence[SlidingRows]) -> SlidingRows:
    """Join the samples of several recordings into one object."""
    return SlidingRows(
        *(
            np.concatenate([getattr(part, field.name) for part in rows] or [np.zeros(0)])
            for field in fields(SlidingRows)
        )
    )


def _friction(record: FrictionRecord) -> FloatArray:
    return record.force if record.pressure_force is None else record.force + record.pressure_force


def _pressure(record: FrictionRecord) -> FloatArray:
    return np.zeros(len(record)) if record.pressure is None else np.abs(record.pressure)


def _fit_lines(time: FloatArray, position: FloatArray, half: float) -> tuple[FloatArray, FloatArray, float]:
    """Fit a straight line near each time, and return its value and slope there, (n,) each.

    A line is fitted to the samples within `half` of the time. The third item is the rms residual of all lines.
    """
    first = np.searchsorted(time, time - half * (1.0 + 1e-9))
    end = np.searchsorted(time, time + half * (1.0 + 1e-9), side="right")
    # At the ends the window is one-sided, with at least three samples.
    first, end = np.minimum(first, np.maximum(end - 3, 0)), np.maximum(end, np.minimum(first + 3, time.size))
    t, x = (np.asarray(series - series.mean(), dtype=np.longdouble) for series in (time, position))

    def total(values: NDArray[np.longdouble]) -> NDArray[np.longdouble]:
        sums = np.concatenate([[0.0], np.cumsum(values)])
        return np.asarray(sums[end] - sums[first])

    n = (end - first).astype(float)
    mean_t, mean_x = total(t) / n, total(x) / n
    spread = total(t * t) - n * mean_t**2
    slope = (total(t * x) - n * mean_t * mean_x) / spread
    mean_squares = np.maximum(total(x * x) - n * mean_x**2 - slope**2 * spread, 0.0) / np.maximum(n - 2.0, 1.0)
    value = mean_x + slope * (t - mean_t) + position.mean()
    return np.asarray(value, float), np.asarray(slope, float), math.sqrt(float(np.mean(mean_squares)))


def _split_strokes(smooth: FloatArray, back: float) -> tuple[list[tuple[slice, float, float]], int]:
    """Divide smoothed positions into strokes between reversals, and count the omitted short strokes.

    A reversal counts if the travel after it exceeds `back`. A stroke consists of a slice of samples, a direction, and
    the length of the previous stroke, which is 0 if there is none [m].
    """
    turns, sign = [0], 0.0
    lowest = highest = 0
    for k, x in enumerate(smooth.tolist()):
        lowest, highest = (k if x < smooth[lowest] else lowest), (k if x > smooth[highest] else highest)
        if sign >= 0.0 and smooth[highest] - x > back:
            turns += [highest] if sign else []
            sign, lowest = -1.0, k
        elif sign <= 0.0 and x - smooth[lowest] > back:
            turns += [lowest] if sign else []
            sign, highest = 1.0, k
    strokes: list[tuple[slice, float, float]] = []
    left_out, previous = 0, 0.0  # signed length of the previous range, if it is a stroke
    for first, last in itertools.pairwise([*turns, smooth.size - 1]):
        distance = float(smooth[last] - smooth[first])
        is_long = last + 1 - first >= FEWEST * SHORTEST
        left_out += abs(distance) > back and not is_long
        is_stroke = abs(distance) > back and is_long
        if is_stroke:
            previous_length = abs(previous) if previous * distance < 0.0 else 0.0
            strokes.append((slice(first, last + 1), math.copysign(1.0, distance), previous_length))
        previous = distance if is_stroke else 0.0
    return strokes, left_out


def bending_distances(motions: Sequence[RecordedMotion]) -> dict[int, float]:
    """Return, by index of the stroke, the distance after its reversal from which the body slides [m].

    Before it, the bristles deflect. The distance of a stroke is at least the median over all strokes for which it can
    be measured.
    """
    distances = {}
    # On strokes that are much shorter than the others, bristles deflect without sliding.
    min_length = SMALL * max(
        (reversal.previous_length for motion in motions for reversal in motion.reversals), default=0.0
    )
    for motion in motions:
        rows = motion.rows
        for reversal in motion.reversals:
            if min(reversal.previous_length, float(np.max(reversal.distance, initial=0.0))) < min_length:
                continue
            is_stroke, is_previous = rows.stroke == reversal.stroke, rows.stroke == reversal.stroke - 1
            if is_stroke.sum() < 4 or is_previous.sum() < 4:
                continue
            force_after, force_before = (float(np.median(rows.friction[mask])) for mask in (is_stroke, is_previous))
            if reversal.sign * (force_after - force_before) <= 0.0:
                continue
            indices = np.flatnonzero((reversal.friction - force_before) / (force_after - force_before) >= BENT)
            if indices.size:
                distances[reversal.stroke] = WAYS * max(float(reversal.distance[indices[0]]), 0.0)
    typical = float(np.median(list(distances.values()))) if distances else 0.0
    strokes = {int(k) for motion in motions for k in motion.rows.stroke}
    return {k: max(distances.get(k, typical), typical) for k in strokes}


def is_steady(rows: SlidingRows, distance_of_row: FloatArray) -> NDArray[np.bool_]:
    """Return a mask of the samples at which the body slides at a steady speed.

    `distance_of_row` contains the distance that the bristles need to deflect, for each sample. The speed must be almost
    constant within this distance before the sample.
    """
    result, speed = np.ones(len(rows), dtype=bool), np.abs(rows.velocity)
    for k in np.unique(rows.stroke[rows.stroke >= 0]):
        indices = np.flatnonzero(rows.stroke == k)
        first = np.searchsorted(rows.distance[indices], rows.distance[indices] - distance_of_row[indices])
        for k_row, start in enumerate(first.tolist()):
            speeds = speed[indices[start : k_row + 1]]
            result[indices[k_row]] = speeds.max() < CHANGED * speeds[-1] and speeds[-1] < CHANGED * speeds.min()
    return result
