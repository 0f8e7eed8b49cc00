"""Seeded random machines: none fails, and mass, gas energy with work, and the energy of bodies are kept."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parent))
from seeded_machines import random_machine


@pytest.mark.parametrize("count", [15, pytest.param(1000, marks=pytest.mark.slow)])
def test_random_machines_never_fail_and_keep_their_balances(count: int) -> None:
    generator = np.random.default_rng(1093)
    moved = 0
    for number in range(count):
        recording = random_machine(generator).simulate(1.0, 0.01)
        assert np.isfinite(recording.values).all(), number
        assert min(recording[name].min() for name in recording.names if name.endswith((".pressure", ".mass"))) > 0.0
        lost = [residual for residual in recording.residuals if not residual.is_kept]
        assert not lost, (number, lost)
        assert {residual.quantity for residual in recording.residuals} == {"mass", "energy", "motion"}
        moved += np.ptp(recording["body0.position"]) > 1e-3
    assert moved > 0.4 * count
