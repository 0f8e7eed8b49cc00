"""Lateness of periods: how long after its deadline a period begins."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass

LATE = 2e-3
"""Lateness above which a period counts as late [s]."""
BOUNDS = tuple(digit * 10.0**power for power in range(-6, 0) for digit in (1.0, 2.0, 5.0))
"""Upper bounds of the classes of the histogram [s]: 1, 2, 5 us up to 500 ms. The last class is open."""
N_CLASSES = len(BOUNDS) + 1


def class_of(lateness: float) -> int:
    """Return the index of the class of a lateness [s]."""
    return bisect_left(BOUNDS, lateness)


@dataclass(frozen=True)
class Lateness:
    """Statistics of the lateness of all periods of a machine.

    Parameters
    ----------
    histogram : sequence of int
        Number of periods in each class of `BOUNDS`, and in the open class above.
    late : int
        Number of periods that began more than `LATE` after their deadline.
    maximum : float
        Longest lateness [s].
    behind : int
        Number of times that the clock was set back because the machine was behind.
    """

    histogram: Sequence[int]
    late: int
    maximum: float
    behind: int

    @property
    def periods(self) -> int:
        """Number of periods."""
        return sum(self.histogram)

    def table(self) -> str:
        """Return the histogram as text, one line for each class that has periods."""
        from poppet.core.number_format import aligned

        lines, total = [["lateness", "periods", "cumulative"]], 0
        for k, count in enumerate(self.histogram):
            total += count
            if count:
                name = f"up to {_shown(BOUNDS[k])}" if k < len(BOUNDS) else f"above {_shown(BOUNDS[-1])}"
                lines.append([name, str(count), f"{100.0 * total / self.periods:.4f} %"])
        return aligned(lines, [1, 2])


def _shown(seconds: float) -> str:
    return f"{1e3 * seconds:g} ms" if seconds >= 1e-3 else f"{1e6 * seconds:g} us"
