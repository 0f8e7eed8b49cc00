"""Order of samples: no empty cells, unique time stamps, one clock for all channels."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.timeseries.checks import FloatArray

LEAST_SAMPLES = 8
"""With fewer samples, noise and curvature cannot be distinguished."""


@dataclass(frozen=True, eq=False)
class Samples:
    """Finite samples of a column over time, with notes on merged and omitted samples."""

    time: FloatArray  # (n,), strictly increasing [s]
    values: FloatArray  # (n,)
    notes: tuple[Note, ...] = ()  # without an address


def ordered(time: FloatArray, values: FloatArray) -> Samples:
    """Return the usable samples of a column.

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
    return Samples(stamps, np.bincount(stamp_index, values) / count, tuple(notes))


def from_first(samples: list[Samples], skip: float, end: float = math.inf) -> tuple[float, list[Samples]]:
    """Shift the channels to start at their first used sample, and cut the end."""
    first = min(float(column.time[0]) for column in samples)
    begin = first + skip
    # The tolerance includes a stamp at the limit despite rounding.
    slack = 1e-9 * max(abs(begin), skip)
    windows = []
    for column in samples:
        is_used = (column.time >= begin - slack) & (column.time <= first + end + slack)
        windows.append(Samples(column.time[is_used], column.values[is_used], column.notes))
    origin = min((float(column.time[0]) for column in windows if column.time.size), default=begin)
    return origin, [replace(column, time=column.time - origin) for column in windows]
