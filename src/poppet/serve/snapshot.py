"""Values of a machine at one period."""

from __future__ import annotations

import enum
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note


class MachineState(enum.Enum):
    """State of a machine. The values of a machine that has failed or stopped are those of its last period."""

    STARTING = 0
    RUNNING = 1
    FAILED = 2
    STOPPED = 3


class PointValues(Mapping[str, float]):
    """Values of points by address, in SI units.

    Parameters
    ----------
    array : (n_points,) array
        Values.
    indices : mapping
        Mapping from addresses to indices in the array.
    """

    def __init__(self, array: NDArray[np.float64], indices: Mapping[str, int]) -> None:
        self._array, self._indices = array, indices

    def __getitem__(self, address: str) -> float:
        return float(self._array[self._indices[address]])

    def __iter__(self) -> Iterator[str]:
        return iter(self._indices)

    def __len__(self) -> int:
        return len(self._indices)


@dataclass(frozen=True, eq=False)
class Snapshot:
    """Values of all points at one period. The value of an input is the last one that was written.

    Parameters
    ----------
    time : float
        Time of the machine [s].
    values : PointValues
        Mapping from addresses to values in SI units.
    array : (n_points,) array
        The same values in the order of `Machine.points`.
    period : int
        Number of the period, from 0; -1 before the first one.
    late : int
        Number of periods that began more than 2 ms after their deadline.
    state : MachineState
        State of the machine.
    note : Note or None
        Reason of a failure.
    """

    time: float
    values: PointValues
    array: NDArray[np.float64]
    period: int
    late: int
    state: MachineState
    note: Note | None

    def __getitem__(self, address: str) -> float:
        return self.values[address]
