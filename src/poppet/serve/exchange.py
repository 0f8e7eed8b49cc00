"""Exchange of values between the machine and the protocols, in one block of memory without locks.

The protocols write commands (inputs and faults) under a version that is odd while they write. The machine reads them
at each period; if a write is in progress, it takes the previous values. The machine writes rows into a ring and then
counts them, so a reader detects the rows that were overwritten while it copied them.
"""

from __future__ import annotations

import threading
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.serve.lateness import LATE, N_CLASSES, Lateness, class_of

Array = NDArray[np.float64]
STATE, ROWS, VERSION, STOP, LATE_COUNT, LONGEST, BEHIND, RECORDED, N_FIELDS = range(9)
"""Indices of the integers in the exchange: state, number of published rows, version of the commands, request to stop,
number of late periods, longest lateness [ns], number of times that the clock was set back, number of recorded rows for
which a machine that does not wait for time waits, or -1."""
FEWEST_ROWS, MOST_ROWS, MOST_DOUBLES = 1024, 2**14, 2**20
"""Fewest and most rows of the ring, and the number of its values up to which it has more than the fewest (8 MiB)."""
RETRIES = 3
"""Attempts to read commands while they change."""


@dataclass(frozen=True)
class ExchangeLayout:
    """Sizes of an exchange.

    Parameters
    ----------
    n_commands : int
        Number of inputs and faults.
    n_columns : int
        Number of values of a row.
    """

    n_commands: int
    n_columns: int

    @property
    def n_rows(self) -> int:
        """Number of rows of the ring."""
        return max(FEWEST_ROWS, min(MOST_ROWS, MOST_DOUBLES // self.n_columns))

    @property
    def size(self) -> int:
        """Size of the block [byte]."""
        return 8 * (N_FIELDS + N_CLASSES + self.n_commands + self.n_rows * self.n_columns)


class Exchange:
    """Views of a block of memory that the machine and the protocols share.

    Parameters
    ----------
    layout : ExchangeLayout
        Sizes.
    buffer : object with the buffer protocol
        Block of at least `layout.size` bytes, which is zero at the start.
    """

    def __init__(self, layout: ExchangeLayout, buffer: Any) -> None:
        self.layout = layout
        integers = np.frombuffer(buffer, dtype=np.int64, count=N_FIELDS + N_CLASSES)
        self.fields, self.histogram = integers[:N_FIELDS], integers[N_FIELDS:]
        doubles = np.frombuffer(
            buffer, dtype=np.float64, offset=8 * integers.size, count=layout.size // 8 - integers.size
        )
        self.commands = doubles[: layout.n_commands]
        self.ring = doubles[layout.n_commands :].reshape(layout.n_rows, layout.n_columns)
        self._barrier = threading.Lock()

    @property
    def is_full(self) -> bool:
        """True if the next row would replace one that is not recorded yet."""
        recorded = int(self.fields[RECORDED])
        return 0 <= recorded <= self.n_published - self.layout.n_rows + 1

    def copy(self) -> Exchange:
        """Return a copy in a block of its own."""
        copy = Exchange(self.layout, bytearray(self.layout.size))
        for source, target in zip(self._arrays(), copy._arrays(), strict=True):
            target[:] = source
        return copy

    def _arrays(self) -> tuple[NDArray[Any], ...]:
        return self.fields, self.histogram, self.commands, self.ring

    def _order(self) -> None:
        """Order the accesses to memory before and after this call, on all processors."""
        with self._barrier:
            pass

    # Commands ----------------------------------------------------------------------------------------------------

    def put_commands(self, values: Array) -> None:
        """Replace all commands; one thread at a time calls this method."""
        self.fields[VERSION] += 1
        self._order()
        self.commands[:] = values
        self._order()
        self.fields[VERSION] += 1

    def take_commands(self, into: Array, version: int) -> int:
        """Copy the commands if they are newer than a version, and return their version.

        If the protocols write during all attempts, the result is the old version, and `into` is unchanged.
        """
        for _ in range(RETRIES):
            present = int(self.fields[VERSION])
            if present == version:
                return version
            if present % 2 == 0:
                self._order()
                copy = self.commands.copy()
                self._order()
                if int(self.fields[VERSION]) == present:
                    into[:] = copy
                    return present
        return version

    # Rows --------------------------------------------------------------------------------------------------------

    @property
    def n_published(self) -> int:
        """Number of rows since the start."""
        return int(self.fields[ROWS])

    def publish(self, row: Array) -> None:
        """Write the next row into the ring."""
        count = int(self.fields[ROWS])
        self.ring[count % self.layout.n_rows] = row
        self._order()
        self.fields[ROWS] = count + 1

    def last_row(self) -> tuple[int, Array]:
        """Return the number of rows since the start and a copy of the last one, NaN if there is none."""
        while True:
            count = self.n_published
            if count == 0:
                return 0, np.full(self.layout.n_columns, np.nan)
            self._order()
            row = self.ring[(count - 1) % self.layout.n_rows].copy()
            self._order()
            if self.n_published - count < self.layout.n_rows - 1:
                return count, row

    def rows(self, since: int) -> tuple[int, Array]:
        """Return the rows from a number on that are still in the ring, and the number of the first of them."""
        count, size = self.n_published, self.layout.n_rows
        first = max(since, count - size + 1, 0)
        if first >= count:
            return count, np.empty((0, self.layout.n_columns))
        self._order()
        copy = self.ring[np.arange(first, count) % size]
        self._order()
        # Rows that the machine has overwritten meanwhile; it can be writing the next one.
        n_overwritten = max(0, self.n_published + 1 - size - first)
        return first + min(n_overwritten, len(copy)), copy[n_overwritten:]

    # Clock -------------------------------------------------------------------------------------------------------

    def count_lateness(self, seconds: float) -> None:
        """Count the lateness of a period."""
        self.histogram[class_of(seconds)] += 1
        self.fields[LATE_COUNT] += seconds > LATE
        self.fields[LONGEST] = max(int(self.fields[LONGEST]), round(1e9 * seconds))

    def lateness(self) -> Lateness:
        """Return the statistics of the lateness."""
        fields = self.fields
        return Lateness(
            tuple(self.histogram.tolist()), int(fields[LATE_COUNT]), 1e-9 * int(fields[LONGEST]), int(fields[BEHIND])
        )
