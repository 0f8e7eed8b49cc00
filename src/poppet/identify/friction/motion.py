"""What a recording of a motion says of friction: velocity over stated windows, strokes, reversals, the rows of a fit.

A stroke is a stretch of one direction between two reversals. It is cut into blocks one window long, and each block is
one row: the slope of a straight line through its positions, and the means of the rest. So velocity and force are
smoothed alike, and the noise of no two rows has a sample in common.
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
"""Noise of a velocity, over the usual speed of its stroke, that a window is made for."""
SHORTEST, FEWEST = 5, 4
"""Samples of the shortest window, and windows that a stroke has at least."""
TURNS = 8.0
"""Noises of a smoothed position by which it has to go back before it counts as a reversal."""
MOVING = 3.0
"""Noises of a velocity above which a body moves."""
CREEPS = 0.005
"""Part of the usual speed of a stroke below which it does not."""
HALF_POWER = 0.5777
"""Frequency times window at which the slope of a line through a window has lost half of its power: with u = pi f W the
slope of a sine is 3 (sin u - u cos u)/u^3 of the true one."""
BENT, WAYS = 0.9, 3.0
"""Part of the way from one sliding force to the other, and how many distances to there are no steady sliding: of
bristles that bend as exp(-d/delta) 0.1 % of the change is left then."""
CHANGED = 2.0
"""Speed over that on the way before it beyond which a row is no steady sliding."""
SMALL = 0.1
"""Part of the longest stroke below which one says nothing of the way that bristles take."""
PARABOLA = np.array([-3.0, 12.0, 17.0, 12.0, -3.0]) / 35.0
"""Weights of five samples in the value of a parabola through them, in their middle (Savitzky & Golay 1964)."""
ROUNDED = 12.0 / 35.0
"""Ways of one sample by which that parabola rounds off the corner of a sudden reversal."""


@dataclass(frozen=True, eq=False)
class Rows:
    """What a law is fitted to: points of a table, or blocks of recordings; arrays of shape (n,)."""

    velocity: FloatArray  # [m/s]
    friction: FloatArray  # force against the motion, signed as the velocity, with whatever offset the gauge has [N]
    pressure: FloatArray  # difference across the seals, without its sign [Pa]
    force: FloatArray  # as measured [N]
    weight: FloatArray
    time: FloatArray  # not-a-number in a table
    position: FloatArray  # not-a-number where none is known
    distance: FloatArray  # since the last stop or reversal; infinite in a table [m]
    record: NDArray[np.int_]
    stroke: NDArray[np.int_]  # counted over all recordings; -1 in a table

    def __len__(self) -> int:
        return int(self.velocity.size)

    def of(self, which: NDArray[np.bool_]) -> Rows:
        """Some of them."""
        return Rows(*(getattr(self, each.name)[which] for each in fields(self)))

    @property
    def sign(self) -> FloatArray:
        """Direction of the motion; at a velocity of zero that of the friction."""
        return np.where(self.velocity != 0.0, np.sign(self.velocity), np.sign(self.friction))


@dataclass(frozen=True, eq=False)
class Reversal:
    """The samples of a stroke behind a reversal, on which bristles bend over; arrays of shape (n,)."""

    distance: FloatArray  # [m]
    friction: FloatArray  # [N]
    velocity: FloatArray  # [m/s]
    pressure: FloatArray  # [Pa]
    record: int
    stroke: int
    sign: float
    before: float  # length of the stroke the other way before it [m]
    rounding: float  # of the corner, by smoothing [m]
    step: float  # from sample to sample [s]
    window: float  # of the velocity [s]
    last: Reversal | None  # the stroke before it, however that began


@dataclass(frozen=True, eq=False)
class RecordedMotion:
    """One recording, smoothed and cut into strokes."""

    rows: Rows
    reversals: tuple[Reversal, ...]
    windows: tuple[float, ...] = ()  # of each stroke [s]
    velocity_noise: tuple[float, ...] = ()  # one sigma of the velocity of a row of each stroke [m/s]
    resolution: float = 0.0  # of a smoothed position, one sigma [m]
    smear: float = 1.0  # misfit of straight lines over the windows, in noises
    left_out: int = 0  # strokes that are too short


def of_table(record: FrictionRecord, place: int) -> RecordedMotion:
    """The points of a table as they are."""
    assert record.velocity is not None
    n, nothing = len(record), np.full(len(record), math.nan)
    weight = np.ones(n) if record.uncertainty is None else record.uncertainty**-2.0
    position = nothing if record.position is None else record.position
    friction, pressure = _friction(record), _pressure(record)
    ends = np.full(n, math.inf), np.full(n, place), np.full(n, -1)
    return RecordedMotion(Rows(record.velocity, friction, pressure, record.force, weight, nothing, position, *ends), ())


def of_motion(
    record: FrictionRecord, place: int, first_stroke: int, window: float | None, mass: float
) -> RecordedMotion:
    """A recording cut into strokes and blocks; each stroke has a window by its own speed where none is given."""
    time = record.time
    assert time is not None
    step = float(np.median(np.diff(time)))
    position = record.position
    if position is None:
        assert record.velocity is not None
        ways = 0.5 * (record.velocity[1:] + record.velocity[:-1]) * np.diff(time)
        position = np.concatenate([[0.0], np.cumsum(ways)])
    noise = _noise(time, position)
    # The window of a velocity would round the corner of a reversal off.
    smooth = position.copy()
    smooth[2:-2] = np.convolve(position, PARABOLA, "valid")
    resolution = noise * float(np.linalg.norm(PARABOLA))
    pieces, left_out = _pieces(time, position, smooth, max(TURNS * resolution, 1e-3 * float(np.ptp(smooth))))
    rows, reversals = [], []
    told: list[tuple[float, float, float]] = []
    last: Reversal | None = None
    for k, piece in enumerate(pieces):
        own = slice(piece.first, piece.end)
        width = max(window, 3.0 * step) if window else _window(time[own], position[own], noise, step)
        sigma = noise * math.sqrt(12.0 / (width / step) ** 3) / step
        _, speed, misfit = _lines(time[own], position[own], 0.5 * width)
        friction = _friction(record)[own] - (mass * np.gradient(speed, time[own]) if mass else 0.0)
        series = time[own], position[own], smooth[own], speed, friction, _pressure(record)[own], record.force[own]
        stroke = _Stroke(*series, piece.sign, piece.before, place, first_stroke + k)
        rows.append(stroke.blocks(width, sigma))
        last = stroke.reversal(step, width, last if piece.before > 0.0 else None)
        if piece.before > 0.0:
            reversals.append(last)
        told.append((width, sigma, misfit))
    windows, noises, misfits = np.array(told).reshape(-1, 3).T.tolist()
    smear = float(np.median(misfits)) / noise if noise > 0.0 and misfits else 1.0
    return RecordedMotion(stacked(rows), tuple(reversals), tuple(windows), tuple(noises), resolution, smear, left_out)


def stacked(rows: Sequence[Rows]) -> Rows:
    """Rows behind each other."""
    return Rows(*(np.concatenate([getattr(r, e.name) for r in rows] or [np.zeros(0)]) for e in fields(Rows)))


@dataclass(frozen=True)
class _Piece:
    """A stretch of one direction."""

    first: int  # sample
    end: int  # behind the last
    sign: float
    before: float = 0.0  # length of the one before it, the other way; zero where there is none [m]


@dataclass(frozen=True, eq=False)
class _Stroke:
    """The samples of a stroke, shape (n,)."""

    time: FloatArray
    position: FloatArray
    smooth: FloatArray  # position
    speed: FloatArray
    friction: FloatArray
    pressure: FloatArray
    force: FloatArray
    sign: float
    before: float
    place: int
    number: int

    @property
    def distance(self) -> FloatArray:
        """Way since the reversal before it."""
        return np.asarray(np.maximum(self.sign * (self.smooth - self.smooth[0]), 0.0))

    def reversal(self, step: float, window: float, last: Reversal | None) -> Reversal:
        """What tells of bristles."""
        series = self.sign * (self.smooth - self.smooth[0]), self.friction, self.speed, self.pressure
        rounding = ROUNDED * step * float(np.median(np.abs(self.speed)))
        return Reversal(
            *series,
            self.place,
            self.number,
            self.sign,
            self.before,
            rounding,
            step,
            window,
            last and replace(last, last=None),
        )

    def blocks(self, width: float, sigma: float) -> Rows:
        """Blocks one window long: the slope of the positions, the means of the rest.

        The first and the last are left out, in which the body turns round, and those in which it rests.
        """
        block = np.floor((self.time - self.time[0]) / width + 1e-9).astype(int)
        starts = np.flatnonzero(np.diff(block, prepend=-1))
        count = np.diff([*starts, self.time.size])

        def mean(values: FloatArray) -> FloatArray:
            return np.asarray(np.add.reduceat(values, starts) / count)

        t = self.time - np.repeat(mean(self.time), count)
        x = self.position - np.repeat(mean(self.position), count)
        spread = np.add.reduceat(t * t, starts)
        slope = np.add.reduceat(t * x, starts) / np.where(spread > 0.0, spread, 1.0)
        usual = float(np.quantile(np.abs(slope), 0.75))
        kept = self.sign * slope > max(MOVING * sigma, CREEPS * usual)
        kept[[0, -1]] = False
        means = [mean(each) for each in (self.friction, self.pressure, self.force)]
        places = [mean(each) for each in (self.time, self.position, self.distance)]
        whose = (np.full(count.size, each) for each in (self.place, self.number))
        return Rows(*(each[kept] for each in (slope, *means, count.astype(float), *places, *whose)))


def _friction(record: FrictionRecord) -> FloatArray:
    return record.force if record.pressure_force is None else record.force + record.pressure_force


def _pressure(record: FrictionRecord) -> FloatArray:
    return np.zeros(len(record)) if record.pressure is None else np.abs(record.pressure)


def _lines(time: FloatArray, position: FloatArray, half: float) -> tuple[FloatArray, FloatArray, float]:
    """Straight lines through the samples up to `half` away: their values, slopes, and rms misfit."""
    first = np.searchsorted(time, time - half * (1.0 + 1e-9))
    end = np.searchsorted(time, time + half * (1.0 + 1e-9), side="right")
    # At the ends the window becomes one-sided, not shorter than three samples.
    first, end = np.minimum(first, np.maximum(end - 3, 0)), np.maximum(end, np.minimum(first + 3, time.size))
    t, x = (np.asarray(each - each.mean(), dtype=np.longdouble) for each in (time, position))

    def total(values: NDArray[np.longdouble]) -> NDArray[np.longdouble]:
        sums = np.concatenate([[0.0], np.cumsum(values)])
        return np.asarray(sums[end] - sums[first])

    n = (end - first).astype(float)
    mean_t, mean_x = total(t) / n, total(x) / n
    spread = total(t * t) - n * mean_t**2
    slope = (total(t * x) - n * mean_t * mean_x) / spread
    left = np.maximum(total(x * x) - n * mean_x**2 - slope**2 * spread, 0.0) / np.maximum(n - 2.0, 1.0)
    value = mean_x + slope * (t - mean_t) + position.mean()
    return np.asarray(value, float), np.asarray(slope, float), math.sqrt(float(np.mean(left)))


def _noise(time: FloatArray, position: FloatArray) -> float:
    """One sigma of single positions: misfit of lines over five samples, and not below the resolution."""
    levels = np.unique(position)
    steps = np.diff(levels)
    # Of a position in steps, many samples share a level; else the least difference is chance.
    resolution = float(steps.min()) / math.sqrt(12.0) if 0 < steps.size < 0.8 * position.size else 0.0
    half = 2.0 * float(np.median(np.diff(time)))
    return max(_lines(time, position, half)[2], resolution)


def _window(time: FloatArray, position: FloatArray, noise: float, step: float) -> float:
    """The shortest window at which the velocities of a stroke are known to `STEADY` of its usual one."""
    samples, longest = float(SHORTEST), max(time.size / FEWEST, SHORTEST)
    while True:
        usual = float(np.quantile(np.abs(_lines(time, position, 0.5 * samples * step)[1]), 0.75))
        if noise * math.sqrt(12.0 / samples**3) / step <= STEADY * usual or 1.3 * samples > longest:
            return samples * step
        samples *= 1.3


def _pieces(time: FloatArray, position: FloatArray, smooth: FloatArray, back: float) -> tuple[list[_Piece], int]:
    """Stretches between reversals, where the body goes back by more than noise does; how many are too short."""
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
    turns.append(time.size - 1)
    found: list[_Piece] = []
    left_out = 0
    for first, last in itertools.pairwise(turns):
        way = float(smooth[last] - smooth[first])
        if abs(way) > back and last + 1 - first < FEWEST * SHORTEST:
            left_out += 1
        elif abs(way) > back:
            is_turn = bool(found) and found[-1].end == first + 1 and found[-1].sign != math.copysign(1.0, way)
            before = abs(float(smooth[first] - smooth[found[-1].first])) if is_turn else 0.0
            found.append(_Piece(first, last + 1, math.copysign(1.0, way), before))
    return found, left_out


def bending_distances(motions: Sequence[RecordedMotion]) -> dict[int, float]:
    """Way at the begin of each stroke that is no steady sliding [m], by its number.

    Where a stroke does not show it, that of the others.
    """
    ways = {}
    # On strokes far shorter than the others bristles bend, and nothing slides.
    long = SMALL * max((each.before for motion in motions for each in motion.reversals), default=0.0)
    for motion in motions:
        rows = motion.rows
        for each in motion.reversals:
            if min(each.before, float(np.max(each.distance, initial=0.0))) < long:
                continue
            own, last = rows.stroke == each.stroke, rows.stroke == each.stroke - 1
            if own.sum() < 4 or last.sum() < 4:
                continue
            after, before = (float(np.median(rows.friction[which])) for which in (own, last))
            if each.sign * (after - before) <= 0.0:
                continue
            there = np.flatnonzero((each.friction - before) / (after - before) >= BENT)
            if there.size:
                ways[each.stroke] = WAYS * max(float(each.distance[there[0]]), 0.0)
    usual = float(np.median(list(ways.values()))) if ways else 0.0
    strokes = {int(k) for motion in motions for k in motion.rows.stroke}
    return {k: max(ways.get(k, usual), usual) for k in strokes}


def is_steady(rows: Rows, behind: FloatArray) -> NDArray[np.bool_]:
    """False for rows before which the speed was another on the way that bristles need to follow, behind a stop, say."""
    result, speed = np.ones(len(rows), dtype=bool), np.abs(rows.velocity)
    for k in np.unique(rows.stroke[rows.stroke >= 0]):
        own = np.flatnonzero(rows.stroke == k)
        first = np.searchsorted(rows.distance[own], rows.distance[own] - behind[own])
        for place, begin in enumerate(first.tolist()):
            before = speed[own[begin : place + 1]]
            result[own[place]] = before.max() < CHANGED * before[-1] and before[-1] < CHANGED * before.min()
    return result
