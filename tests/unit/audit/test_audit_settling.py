"""Exhaust times and travels of curves with known crossings and turning points."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.audit.settling import motion_of, sample_times, time_below


@pytest.mark.parametrize("duration", [0.3, 2.0, 10.0, 300.0])
def test_samples_end_with_the_duration_and_are_close(duration):
    time = sample_times(duration)
    assert time[0] == 0.0
    assert time[-1] == duration
    steps = np.diff(time)
    assert (steps > 0.0).all()
    assert (steps <= np.clip(1.01e-3 * time[1:], 1.0001e-4, 5.0001e-3)).all()


@pytest.mark.parametrize("constant", [1e-3, 0.02, 0.4, 3.0])
def test_the_time_below_a_threshold_of_a_decay(constant):
    time = sample_times(40.0)
    found = time_below(time, 6.0 * np.exp(-time / constant) - 0.5)
    # The shortest time constant is ten samples.
    assert found == pytest.approx(constant * np.log(12.0), rel=1e-6)


def test_only_the_last_crossing_counts():
    time = sample_times(10.0)
    # Below the threshold at 1 s, above again from 2 to 3 s.
    excess = np.interp(time, [0.0, 0.9, 1.1, 1.9, 2.1, 2.9, 3.1, 10.0], [1.0, 0.1, -0.1, -0.1, 0.1, 0.1, -0.1, -0.1])
    assert time_below(time, excess) == pytest.approx(3.0, abs=1e-4)


def test_a_volume_above_the_threshold_at_the_end_has_no_time():
    time = sample_times(1.0)
    assert time_below(time, np.where(time > 0.9999, 1.0, -1.0)) == np.inf
    assert time_below(time, np.full(time.size, -1.0)) == 0.0


def test_the_path_of_a_decaying_oscillation_includes_all_returns():
    time, damping, omega = sample_times(10.0), 3.0, 40.0
    position = np.exp(-damping * time) * np.cos(omega * time)
    velocity = -np.exp(-damping * time) * (damping * np.cos(omega * time) + omega * np.sin(omega * time))
    # Turning points at tan(omega t) = -damping / omega: the amplitudes are a geometric series.
    first = np.pi / omega - np.arctan(damping / omega) / omega
    peaks = np.exp(-damping * (first + np.pi / omega * np.arange(200))) * np.cos(np.arctan(damping / omega))
    expected = 1.0 + 2.0 * peaks.sum()
    motion = motion_of(time, position, velocity)
    assert motion.path == pytest.approx(expected, rel=1e-5)
    assert motion.net == pytest.approx(-1.0, abs=1e-9)
    assert motion.farthest == pytest.approx(1.0 + peaks[0], rel=1e-6)
    # The envelope falls below 0.1 mm at ln(1e4) / damping.
    assert np.log(1e4) / damping - np.pi / omega < motion.stop_time <= np.log(1e4) / damping


def test_a_body_that_moves_at_the_end_has_not_stopped():
    time = sample_times(10.0)
    motion = motion_of(time, 1e-3 * time, np.full(time.size, 1e-3))
    assert motion.path == pytest.approx(0.01)
    assert motion.stop_time == np.inf


def test_a_turn_between_two_samples_is_part_of_the_path():
    # x = t (1 - t): the only samples are at the ends.
    motion = motion_of(np.array([0.0, 1.0]), np.array([0.0, 0.0]), np.array([1.0, -1.0]))
    assert (motion.path, motion.farthest) == (pytest.approx(0.5), pytest.approx(0.25))
