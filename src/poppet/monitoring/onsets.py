"""Schedule of the onsets of a filter: times at which a fault may have begun.

A fault changes slowly, or in a step at an unknown time. A filter whose random walk is fast enough for a step never
knows the fault well, so its walk is slow, and the bank of onsets (`poppet.monitoring.fault_statistics.OnsetBank`) finds
the steps.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ONSETS = 24
"""Number of onsets."""
PER_DELAY = 4
"""Number of new onsets within the alarm delay."""


def oldest_first(times: Array) -> NDArray[np.int64]:
    """Return the indices of the used onsets, the oldest first; an unused one has the time NaN."""
    order = np.argsort(times, kind="stable")
    return order[: np.count_nonzero(np.isfinite(times))]


def slot_to_renew(times: Array, now: float, window: float) -> int:
    """Return the index of the onset that a new one replaces.

    It is an unused one, or the oldest one if it is older than the window. Otherwise it is the one whose neighbours are
    closest, relative to their age: the density of the onsets then decreases with their age.

    Parameters
    ----------
    times : ndarray
        Times of the onsets, (o,), NaN for unused ones [s].
    now : float
        Present time [s].
    window : float
        Largest useful age [s].

    Examples
    --------
    >>> slot_to_renew(np.array([0.0, np.nan, 5.0]), 6.0, 10.0)
    1
    >>> slot_to_renew(np.array([0.0, 3.0, 5.0, 5.9]), 6.0, 60.0)
    1
    """
    order = oldest_first(times)
    if order.size < times.size:
        return int(np.flatnonzero(np.isnan(times))[0])
    ages = now - times[order]
    if ages[0] > window:
        return int(order[0])
    # The oldest and the newest one remain.
    ratios = ages[:-2] / np.maximum(ages[2:], 1e-9 * window)
    return int(order[1 + int(np.argmin(ratios))])
