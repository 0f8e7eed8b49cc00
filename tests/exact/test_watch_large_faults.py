"""Large leaks of the independent cylinder, whose effects are not linear: soon named alone, with the right size."""

from __future__ import annotations

import numpy as np
import pytest

from exact import independent_watch_cylinder as cylinder
from exact.watch_batteries import cylinder_outcome, cylinder_plan, cylinder_run, cylinder_start

FIVE = ("seal_leak", "spool_leak", "leak_cap", "leak_rod", "coulomb_friction")


@pytest.mark.parametrize(("fault", "seed"), [("seal_leak", 3), ("leak_cap", 5)])
def test_a_leak_of_eight_alarm_sizes_is_named_within_five_seconds(fault, seed):
    """The onset of the first one is between those of the bank, whose neighbours fit with large residuals."""
    begin = cylinder_start(seed)
    outcome = cylinder_outcome(cylinder_run({fault: 4.0}, seed, 6), seed, plan=cylinder_plan(FIVE))
    assert begin < outcome.first < begin + 2.5
    assert all(fault in alarm.names for alarm in outcome.alarms)
    assert outcome.names == (fault,)
    assert outcome.alarms[-1].time < begin + 5.0
    k = FIVE.index(fault)
    healthy, unit = getattr(cylinder.HEALTHY, fault), cylinder.FAULTS[fault].unit
    size = (outcome.values[-1, k] - healthy) / unit
    assert size == pytest.approx(4.0, rel=0.02)
    assert abs(size - 4.0) * unit < 4.0 * outcome.sigmas[-1, k]
    assert np.all(np.isfinite(outcome.sigmas[outcome.times > begin]))
