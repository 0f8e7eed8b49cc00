"""Points of a muscle's measured force, of a map or of recordings, and what is held out of them together."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import ErrorCollector, InputError
from poppet.timeseries.checks import FloatArray, numbers

CHANNELS = {"pressure": "Pa", "contraction": "1", "force": "N"}
SLACK = 0.002
"""Part of the largest force up to which a point counts as slack, unless a force is given."""
SAME = 0.005
"""Part of the range within which pressures, or contractions, are one level."""
BLOCKS = 10
"""Blocks of a recording in which neither pressure nor contraction has levels."""
STILL = 0.1
"""Part of the usual speed of contraction below which a muscle counts as at rest."""
STIFF = 1e-3
"""Contraction over which a recording has to go for its motion to count: less is noise of an isometric one."""
LEAST_GROUPS = 3


@dataclass(frozen=True, eq=False)
class MusclePoints:
    """Measured force of a muscle over pressure and contraction.

    Parameters
    ----------
    pressure : (n,) array
        Gauge pressure [Pa].
    contraction : (n,) array
        (L0 - L)/L0 [1].
    force : (n,) array
        Pull [N].
    nominal_length, nominal_diameter : float
        Length and inner diameter without pressure and load [m].
    recording : (n,) array of int, optional
        Number of the recording of each point; one table without it.
    time : (n,) array, optional
        Of recordings: the direction of the motion then tells the width of the hysteresis [s].
    slack_below : float, optional
        Force up to which a point counts as slack; default 0.2 % of the largest [N].

    Raises
    ------
    InputErrors
        Lengths that differ, values that are not finite, contractions that look like per cent, no taut points.

    Examples
    --------
    >>> points = MusclePoints([2e5, 2e5, 4e5], [0.0, 0.2, 0.1], [500.0, 0.0, 600.0], 0.3, 0.02)
    >>> points.taut.tolist()
    [True, False, True]
    """

    pressure: FloatArray
    contraction: FloatArray
    force: FloatArray
    nominal_length: float
    nominal_diameter: float
    recording: NDArray[np.int_] | None = None
    time: FloatArray | None = None
    slack_below: float | None = None

    def __post_init__(self) -> None:
        given = {name: np.atleast_1d(numbers(name, getattr(self, name))) for name in CHANNELS}
        size = given["force"].size
        with ErrorCollector() as errors:
            for name, array in given.items():
                if array.shape != (size,):
                    errors.add("force_map.shape", name, shape=str(array.shape), points=size)
                elif not np.isfinite(array).all():
                    errors.add("force_map.not_finite", name, place=int(np.argmin(np.isfinite(array))))
            # In per cent nearly every muscle is above 1.
            largest = float(np.max(np.abs(given["contraction"]), initial=0.0))
            if largest >= 1.0:
                errors.add("force_map.per_cent", "contraction", value=largest)
            force = given["force"]
            most, least = float(np.max(force, initial=0.0)), float(np.min(force, initial=0.0))
            if not most > 0.0:
                errors.add("force_map.no_pull", "force")
            elif -least > most:
                errors.add("force_map.pushes", "force", most=most, least=least)
            elif size > 1 and not np.ptp(force):
                errors.add("force_map.still", "force", value=most)
        for name, array in given.items():
            object.__setattr__(self, name, array)

    def __len__(self) -> int:
        return int(self.force.size)

    @cached_property
    def slack_force(self) -> float:
        """Force up to which a point is slack [N]."""
        return SLACK * float(np.max(self.force)) if self.slack_below is None else self.slack_below

    @cached_property
    def taut(self) -> NDArray[np.bool_]:
        """Points at which the muscle pulls, shape (n,)."""
        return np.asarray(self.force > self.slack_force)

    @cached_property
    def direction(self) -> FloatArray | None:
        """1 while it contracts, -1 while it is drawn out, 0 at rest; None without a time, and where nothing moves."""
        if self.time is None:
            return None
        speed = np.zeros(len(self))
        for k in np.unique(self._recordings):
            own = np.flatnonzero(self._recordings == k)
            if own.size > 1 and np.ptp(self.contraction[own]) > STIFF:
                speed[own] = np.gradient(self.contraction[own], self.time[own])
        usual = float(np.quantile(np.abs(speed), 0.9))
        way = np.where(np.abs(speed) > STILL * usual, np.sign(speed), 0.0)
        return np.asarray(way) if way[self.taut].any() else None

    @property
    def _recordings(self) -> NDArray[np.int_]:
        return np.zeros(len(self), dtype=int) if self.recording is None else np.asarray(self.recording)

    @cached_property
    def groups(self) -> tuple[str, NDArray[np.int_]]:
        """What is held out together, and the number of its group for each point, shape (n,).

        Recordings where there are several; else levels of pressure, or of contraction; else blocks in order.
        """
        if self._enough(self._recordings):
            return "recording", self._recordings
        if self.time is None or len(self) < 5 * BLOCKS:
            for name in ("pressure", "contraction"):
                level = levels(getattr(self, name))
                if self._enough(level) and int(level.max()) + 1 <= 0.6 * len(self):
                    return name, level
        block = np.minimum(np.arange(len(self)) * BLOCKS // len(self), BLOCKS - 1)
        if len(self) < 5 * BLOCKS or not self._enough(block):
            raise InputError("force_map.too_few", "force", count=int(self.taut.sum()), least=LEAST_GROUPS)
        return "block", block

    @cached_property
    def crossed(self) -> tuple[str, NDArray[np.int_]] | None:
        """The other axis of a map, whose inner levels are held out as well: a law is used between them too.

        Group -1 is never held out: beyond the ends of a map a law would be asked for what it never saw.
        """
        name = {"pressure": "contraction", "contraction": "pressure"}.get(self.groups[0])
        if name is None:
            return None
        level = levels(getattr(self, name))
        known = np.unique(level[self.taut])
        if known.size < LEAST_GROUPS or known.size > 0.6 * len(self):
            return None
        return name, np.asarray(np.where((level > known[0]) & (level < known[-1]), level, -1))

    def _enough(self, group: NDArray[np.int_]) -> bool:
        return np.unique(group[self.taut]).size >= LEAST_GROUPS


def levels(values: FloatArray) -> NDArray[np.int_]:
    """Number of the level of each value: a new one begins where the next value lies further away than the same do."""
    order = np.argsort(values, kind="stable")
    steps = np.diff(values[order], prepend=values[order][:1]) > SAME * float(np.ptp(values))
    result = np.empty(values.size, dtype=int)
    result[order] = np.cumsum(steps)
    return result


def joined(tables: Sequence[MusclePoints]) -> MusclePoints:
    """Several recordings of one muscle as one."""
    with ErrorCollector() as errors:
        for (k, one), (n, other) in itertools.combinations(enumerate(tables), 2):
            if all(np.array_equal(getattr(one, name), getattr(other, name)) for name in CHANNELS):
                errors.add("force_map.same_twice", "file", first=k + 1, second=n + 1)
    first = tables[0]
    columns = {name: np.concatenate([getattr(each, name) for each in tables]) for name in CHANNELS}
    times = [each.time for each in tables]
    return MusclePoints(
        **columns,
        nominal_length=first.nominal_length,
        nominal_diameter=first.nominal_diameter,
        recording=np.repeat(np.arange(len(tables)), [len(each) for each in tables]),
        time=None if any(t is None for t in times) else np.concatenate([t for t in times if t is not None]),
        slack_below=first.slack_below,
    )
