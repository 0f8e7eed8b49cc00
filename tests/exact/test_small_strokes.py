"""Strokes of 5 to 15 % after a long one, on closed forms of the position."""

from __future__ import annotations

import numpy as np
import pytest

from exact.independent_motion import draw_motion
from poppet.circuit.load_metrics import find_strokes

SEEDS = range(40)


@pytest.mark.parametrize("noise", [0.0, 5e-4])
def test_commanded_strokes_are_found(noise):
    for seed in SEEDS:
        time, position, speed, commands, travels = draw_motion(seed, alternate=False, noise=noise)
        rows = find_strokes(time, position, speed, commands)
        assert len(rows) == len(travels), seed
        for (first, last), command, travel in zip(rows, commands, travels, strict=True):
            # Beyond the target by an overshoot, and between the highest and lowest of 1,000 normal deviates.
            slack = 0.13 * abs(travel) + 8.0 * noise * np.abs(travels).max()
            assert position[last] - position[first] == pytest.approx(travel, abs=slack), seed
            assert time[first] <= command + 0.7 < time[last] + 0.7, seed


@pytest.mark.parametrize(
    ("target", "changes"),
    [(0.81, [0.15, 0.68]), (0.81, [0.1]), (0.9, [0.1]), (1.15, [0.15, 0.68]), (0.81, [-5.0]), (0.81, [-5.0, 0.68])],
)
def test_a_move_after_a_long_rest_is_a_stroke_also_if_its_command_came_early(target, changes):
    time = np.linspace(0.0, 3.0, 301)
    position = np.interp(time, [0.2, 0.7, 1.5, 1.8], [0.0, 1.0, 1.0, target])
    rows = find_strokes(time, position, np.abs(np.gradient(position, time)), changes)
    assert [position[last] - position[first] for first, last in rows] == pytest.approx([1.0, target - 1.0])


@pytest.mark.parametrize("noise", [0.0, 5e-4])
def test_strokes_without_commands_are_returns_after_a_standstill(noise):
    for seed in SEEDS:
        time, position, speed, _, travels = draw_motion(seed, alternate=True, noise=noise)
        for changes in ([], [0.05]):
            rows = find_strokes(time, position, speed, changes)
            found = [position[last] - position[first] for first, last in rows]
            assert np.sign(found).tolist() == np.sign(travels).tolist(), seed
