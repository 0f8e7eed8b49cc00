"""A second fault of the independent tank, long after the first one: both are named, and a third one is not."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest

from exact.watch_batteries import successive_faults

SIZES = {"leak": 1.5, "clogged": -15.0, "supply_low": -0.5}
"""Sizes in per cent of the conductance of the valve and in bar: 3 to 5 alarm sizes."""


@pytest.mark.parametrize("names", [*permutations(SIZES, 2)], ids=" then ".join)
def test_both_faults_are_named_at_the_end(names):
    (run,) = successive_faults({name: SIZES[name] for name in names}, range(41, 42))
    outcome = run.outcome
    assert 120.0 < outcome.first < 130.0
    assert set(outcome.names) == set(names)
    # The last 30 s: the filter knows both sizes.
    assert np.mean(np.abs(run.errors[-30:]) < 4.0) > 0.9
