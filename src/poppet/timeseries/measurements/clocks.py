"""Samples put in order: no empty cells, every stamp once, one clock for all channels of a recording."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.timeseries.checks import FloatArray

LEAST_SAMPLES = 8
"""Fewer cannot be judged: noise and curvature look alike."""


@dataclass(frozen=True, eq=False)
class Samples:
    """A column over its time, all finite, with what was merged or left out of it."""

    time: FloatArray  # (n,), strictly increasing [s]
    values: FloatArray  # (n,)
    notes: tuple[Note, ...] = ()  # without an address


def ordered(time: FloatArray, values: FloatArray) -> Samples:
    """The usable samples of a column.

    Examples
    --------
    >>> ordered(np.array([0.0, 1.0, 1.0, 2.0]), np.array([5.0, 6.0, 8.0, 7.0])).values.tolist()
    [5.0, 7.0, 7.0]
    """
    # A short column of a table is filled up at its end; that is no loss.
    there = np.flatnonzero(np.isfinite(time) | np.isfinite(values))
    end = int(there[-1]) + 1 if there.size else 0
    time, values = time[:end], values[:end]
    good = np.isfinite(time) & np.isfinite(values)
    lost = end - int(np.count_nonzero(good))
    notes = [Note("measured.empty_cells", lost=lost, total=end)] if lost else []
    time, values = time[good], values[good]
    if not time.size:
        raise InputError("measured.no_numbers")
    back = np.flatnonzero(np.diff(time) < 0.0)
    if back.size:
        k = int(back[0])
        raise InputError("measured.backwards", time=float(time[k]), next=float(time[k + 1]))
    stamps, place, count = np.unique(time, return_inverse=True, return_counts=True)
    if stamps.size < time.size:
        notes.append(Note("measured.repeated_stamps", count=time.size - stamps.size))
    return Samples(stamps, np.bincount(place, values) / count, tuple(notes))


def from_first(samples: list[Samples], skip: float, until: float = math.inf) -> tuple[float, list[Samples]]:
    """Channels from their first used sample on, to the last."""
    first = min(float(each.time[0]) for each in samples)
    begin = first + skip
    # A stamp at the limit counts, whatever the rounding of the sum.
    slack = 1e-9 * max(abs(begin), skip)
    kept = []
    for each in samples:
        used = (each.time >= begin - slack) & (each.time <= first + until + slack)
        kept.append(Samples(each.time[used], each.values[used], each.notes))
    origin = min((float(each.time[0]) for each in kept if each.time.size), default=begin)
    return origin, [replace(each, time=each.time - origin) for each in kept]
