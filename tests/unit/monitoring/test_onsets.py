"""Schedule of the onsets of a filter."""

from __future__ import annotations

import numpy as np

from poppet.monitoring.onsets import slot_to_renew


def ages_after(steps: int, slots: int, spacing: float, window: float) -> np.ndarray:
    """Ages of the onsets after regular renewals, the youngest first."""
    times = np.full(slots, np.nan)
    for k in range(steps):
        times[slot_to_renew(times, k * spacing, window)] = k * spacing
    return np.sort((steps - 1) * spacing - times)


def test_unused_slots_come_first():
    times = np.full(3, np.nan)
    slots = []
    for now in (0.0, 1.0, 2.0):
        slots.append(slot_to_renew(times, now, 10.0))
        times[slots[-1]] = now
    assert sorted(slots) == [0, 1, 2]


def test_onsets_cover_the_window_more_densely_when_young():
    ages = ages_after(2000, 24, 0.5, 60.0)
    assert ages[0] == 0.0
    assert 40.0 <= ages[-1] <= 60.5
    gaps = np.diff(ages)
    # Relative to the age, a step lies no further than 30 % from an onset; the next ones are one spacing apart.
    assert gaps[0] == 0.5
    assert (gaps[2:] <= 0.35 * ages[3:]).all()


def test_too_old_onsets_are_replaced():
    times = np.array([0.0, 50.0, 99.0])
    assert slot_to_renew(times, 100.0, 60.0) == 0
