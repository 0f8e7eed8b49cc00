"""Tests of branches, stairs, jumps and the lag of a sweep, with and without noise."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.bench.iso10094.shapes import (
    Branch,
    branches,
    constant_sections,
    delay_by_lags,
    find_jumps,
    lag_of,
    steady_part,
    values_at_points,
)
from poppet.bench.iso10094.step import detect_limit_cycle

RANDOM = np.random.default_rng(7)


def triangle(cycles: int, noise: float) -> np.ndarray:
    period = np.concatenate([np.linspace(0.0, 100.0, 500), np.linspace(100.0, 0.0, 500)])
    return np.tile(period, cycles) + RANDOM.normal(0.0, noise, 1000 * cycles)


@pytest.mark.parametrize("noise", [0.0, 0.5])
def test_branches_of_a_triangle(noise):
    detected = branches(triangle(3, noise), 5.0)
    assert [branch.sign for branch in detected] == [1, -1, 1, -1, 1, -1]
    assert np.allclose([branch.first for branch in detected], np.arange(6) * 500, atol=20)
    assert detected[-1].end == pytest.approx(3000, abs=20)


def test_small_reversal_does_not_end_a_branch():
    values = np.array([0.0, 10.0, 8.0, 20.0, 0.0])
    assert [b.sign for b in branches(values, 5.0)] == [1, -1]
    assert [b.sign for b in branches(values, 1.0)] == [1, -1, 1, -1]
    assert branches(np.full(50, 3.0), 1.0) == []


def test_points_outside_the_samples_are_nan():
    value, count = values_at_points(
        np.linspace(20.0, 80.0, 500), np.linspace(0.0, 60.0, 500), np.array([10.0, 50.0, 90.0]), 1.0
    )
    assert np.isnan(value[[0, 2]]).all()
    assert value[1] == pytest.approx(30.0)
    assert count[1] > 5


def test_interpolation_averages_the_noise():
    x = np.linspace(0.0, 100.0, 20_000)
    y = 0.5 * x + RANDOM.normal(0.0, 1.0, x.size)
    value, count = values_at_points(x, y, np.linspace(10.0, 90.0, 41), 1.0)
    assert np.std(value - 0.5 * np.linspace(10.0, 90.0, 41)) == pytest.approx(1.0 / np.sqrt(count[5]), rel=0.5)


def test_jumps_between_and_at_samples():
    time = np.arange(0.0, 3.0, 0.01)
    setpoint = np.where(time < 1.0, 10.0, np.where(time < 2.0, 60.0, 20.0))
    exact = find_jumps(time, setpoint, 2.0, is_exact=True)
    assert [jump.time for jump in exact] == pytest.approx([1.0, 2.0])
    measured = find_jumps(time, setpoint + RANDOM.normal(0.0, 0.05, time.size), 2.0, is_exact=False)
    assert [jump.time for jump in measured] == pytest.approx([0.995, 1.995], abs=1e-3)
    assert find_jumps(time, setpoint, 70.0, is_exact=True) == []


def test_slow_step_has_the_time_of_its_middle():
    time = np.arange(0.0, 2.0, 0.01)
    setpoint = np.clip((time - 1.0) / 0.1, 0.0, 1.0) * 80.0
    (jump,) = find_jumps(time, setpoint, 2.0, is_exact=False)
    assert (jump.time, jump.duration) == pytest.approx((1.05, 0.1), abs=0.011)


@pytest.mark.parametrize("noise", [0.0, 0.01])
def test_ramps_are_not_staircases(noise):
    staircase = np.repeat(np.arange(10.0) * 0.2, 60) + RANDOM.normal(0.0, noise, 600)
    assert [(s.start, s.stop) for s in constant_sections(staircase)] == [(60 * k, 60 * k + 60) for k in range(10)]
    assert len(constant_sections(np.linspace(0.0, 100.0, 600) + RANDOM.normal(0.0, noise, 600))) <= 1


def test_final_part_of_a_hold():
    time = np.arange(0.0, 10.0, 0.1)
    part = steady_part(time, slice(20, 70), 0.2)
    assert time[part][[0, -1]] == pytest.approx([6.0, 6.9], abs=0.15)


@pytest.mark.parametrize("noise", [0.0, 0.02])
def test_lag_of_a_sweep_equals_the_dead_time(noise):
    time = np.arange(0.0, 130.0, 0.02)
    x = np.interp(time, [0.0, 60.0, 65.0, 125.0, 130.0], [0.0, 100.0, 100.0, 0.0, 0.0])
    y = 2.0 + 0.9 * np.interp(time - 0.3, time, x) + RANDOM.normal(0.0, noise, time.size)
    x = x + RANDOM.normal(0.0, noise, time.size)
    up, down = branches(x, 5.0)
    lag = lag_of(time, x, y, up, down)
    assert lag is not None
    assert lag.time == pytest.approx(0.3, abs=0.01)
    assert lag.moved == pytest.approx(0.9 * 100.0 / 60.0 * 0.3, abs=0.02)
    assert np.interp(30.0, time, delay_by_lags(time, x, [lag])) == pytest.approx(np.interp(29.7, time, x), abs=0.05)


def test_no_lag_without_a_sufficient_hold():
    time = np.arange(0.0, 120.0, 0.05)
    x = 100.0 - np.abs(time - 60.0) * 100.0 / 60.0
    assert lag_of(time, x, x, *branches(x, 5.0)) is None
    setpoint = np.interp(time, [0.0, 60.0, 120.0], [0.0, 100.0, 100.0])
    collapsed = np.where(time < 60.5, setpoint, 20.0)
    assert lag_of(time, setpoint, collapsed, Branch(0, time.size, 1), None) is None


def test_limit_cycle_is_distinguished_from_noise_and_settling():
    time = np.arange(0.0, 4.0, 0.002)
    noise = RANDOM.normal(0.0, 0.05, time.size)
    assert detect_limit_cycle(time, 50.0 + noise) is None
    assert detect_limit_cycle(time, 50.0 + np.exp(-time)) is None
    hum = detect_limit_cycle(time, 50.0 + noise + 0.1 * np.sin(2.0 * np.pi * 13.7 * time))
    assert hum is not None
    assert (hum.amplitude, hum.frequency) == pytest.approx((0.1, 13.7), rel=0.1)
    assert detect_limit_cycle(time[:10], time[:10]) is None


def test_noise_is_rarely_detected_as_limit_cycle():
    time = np.arange(0.0, 1.0, 0.001)
    hums = [detect_limit_cycle(time, np.random.default_rng(seed).normal(0.0, 1.0, time.size)) for seed in range(300)]
    assert [hum for hum in hums if hum is not None] == []


def test_amplitude_of_non_sinusoidal_limit_cycle():
    time = np.arange(0.0, 5.0, 0.001)
    saw = 0.5 * np.abs(((time * 4.0) % 1.0) * 4.0 - 2.0)  # a triangle between 0 and 1
    hum = detect_limit_cycle(time, saw)
    assert hum is not None
    assert (hum.amplitude, hum.frequency) == pytest.approx((0.5, 4.0), rel=0.05)  # ten harmonics of it
