"""Indices of the DAMADICS benchmark for signals drawn by hand, whose integrals are known."""

from __future__ import annotations

import numpy as np
import pytest

from exact.damadics_indices import indices

TIME = np.arange(1501.0)


def between(*spans):
    """Return a signal that is 1 in the spans and 0 elsewhere."""
    return sum(((start <= TIME) & (end > TIME)).astype(int) for start, end in spans)


def score(detection, primary=None, other=None, indicated=None, strength=None, t_hor=1500.0):
    zero = np.zeros(TIME.size)
    signals = [zero if signal is None else signal for signal in (detection, primary, other, indicated)]
    return indices(TIME, zero if strength is None else strength, *signals, t_hor)


def test_a_fault_that_is_found_after_a_false_alarm():
    # Appendix II: 60 s of 600 s before the fault; 30 s and then 480 s of 600 s after it; the last edge counts.
    found = score(between((400, 460), (950, 980), (1020, 1500)), between((1100, 1500)), between((400, 460)))
    assert found.r_fd == pytest.approx(60 / 600)
    assert found.r_td == pytest.approx((30 + 480) / 600)
    assert found.t_dt == 1020 - 900
    assert (found.t_it, found.r_fi, found.r_ti) == pytest.approx((200, 0, 400 / 600))
    assert found.r_mi == pytest.approx(60 / 1200)


def test_the_set_up_zone_does_not_count():
    found = score(between((0, 300)), between((0, 300)), between((0, 300)))
    assert (found.r_fd, found.r_td, found.r_fi, found.r_mi) == (0, 0, 0, 0)


def test_a_fault_that_is_not_found_has_no_times():
    found = score(between((310, 320)))
    assert np.isnan([found.t_dt, found.fs_d, found.t_it, found.fs_i, found.d_acc]).all()
    assert (found.r_td, found.r_ti) == (0, 0)


def test_the_strength_at_the_last_edge():
    strength = np.clip((TIME - 900) / 300, 0, 1)
    found = score(between((960, 1500)), between((1050, 1500)), strength=-strength)
    assert (found.fs_d, found.fs_i) == pytest.approx((60 / 300, 150 / 300))


def test_the_mismatch_counts_every_other_diagnosis():
    # Two other diagnoses for 120 s, one for 60 s.
    found = score(between((900, 1500)), other=2 * between((900, 1020)) + between((1020, 1080)))
    assert found.r_mi == pytest.approx((2 * 120 + 60) / 1200)


def test_the_accuracy_is_that_of_the_last_isolation():
    indicated = 3 * between((900, 1000)) + 2 * between((1000, 1500))
    primary = between((900, 990), (1000, 1500))
    assert score(between((900, 1500)), primary, indicated=indicated).d_acc == pytest.approx(1 / 2)


def test_nothing_after_the_horizon_counts():
    found = score(between((1000, 1100), (1300, 1400)), t_hor=1200.0)
    assert (found.t_dt, found.r_td) == pytest.approx((100, 100 / 300))
