"""The watch on the DAMADICS benchmark: three scenarios, and all 27 in the long run.

The truth has another flow law than the twin. `exact.damadics_watch` prints the table of the documentation.
"""

from __future__ import annotations

import numpy as np
import pytest

from exact import damadics_watch
from exact.damadics_watch import DIAGNOSES, WITHOUT_EFFECT, evaluate
from exact.independent_damadics import HEALTHY, SCENARIOS, Scenario

DAY = 80000.0
SHORT = {Scenario(16, 0.75): 0.8, Scenario(12, -0.25): 0.5, Scenario(14, -0.75): 0.0}
"""Scenarios of the short run, with a lower bound of their true isolation rate."""


@pytest.mark.parametrize(("scenario", "isolated"), SHORT.items(), ids=lambda s: getattr(s, "name", ""))
def test_three_scenarios(scenario, isolated):
    found = evaluate(scenario).indices
    assert found.r_fd <= 0.01
    if scenario.fault in WITHOUT_EFFECT:
        # No reading differs from its healthy value by more than the noise.
        assert found.r_td == 0.0
    else:
        assert found.t_dt <= 60.0
        assert found.r_td >= 0.9
    assert found.r_ti >= isolated


@pytest.mark.slow
def test_all_scenarios():
    results = [evaluate(scenario) for scenario in SCENARIOS if scenario.development < DAY]
    by_name = {result.scenario.name: result.indices for result in results}
    assert max(found.r_fd for found in by_name.values()) <= 0.01
    detected = {name for name, found in by_name.items() if found.r_td > 0.5}
    without = {f"f{fault} {size}" for fault in WITHOUT_EFFECT for size in ("small", "medium", "big")}
    assert not detected & without
    assert len(detected) >= 15


@pytest.mark.slow
@pytest.mark.parametrize("scenario", [s for s in SCENARIOS if s.development > DAY], ids=lambda s: s.name)
def test_a_day(scenario):
    assert evaluate(scenario).indices.r_fd <= 0.01


@pytest.mark.slow
def test_healthy_hours():
    found = evaluate(Scenario(HEALTHY.fault, development=4 * 3600.0), seed=11)
    assert found.indices.r_fd == 0.0
    assert found.indices.r_td == 0.0
    assert np.isnan(found.indices.t_dt)
    assert set(DIAGNOSES.values()) == set(damadics_watch.FAULTS)
