"""Leaks of the independent tank: time to the alarm, size, and no alarm of a healthy plant."""

from __future__ import annotations

import numpy as np
import pytest

from exact.independent_watch_tank import ONE_PERCENT, Sensors
from watch_runs import tank_plan, watch_leaks

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(("size", "longest"), [(1.0, 6.0), (0.3, 31.0)])
def test_a_leak_is_found_in_time_and_measured(size, longest):
    runs = watch_leaks(tank_plan(), size, 4)
    assert max(run.first_alarm(150.0) for run in runs) <= longest
    assert max(abs(run.leak[-1] / ONE_PERCENT - 0.2 - size) for run in runs) < 0.1
    assert {name for run in runs for name in run.names} == {"leak"}
    assert all(run.first_alarm() >= 150.0 for run in runs)


@pytest.mark.parametrize("sensors", [Sensors(), Sensors(outliers=0.01), Sensors(missing=0.5)])
def test_a_healthy_tank_has_no_alarm(sensors):
    runs = watch_leaks(tank_plan(), 0.0, 3, sensors=sensors)
    assert not any(run.alarm.any() for run in runs)


def test_innovations_are_those_of_a_correct_model():
    runs = watch_leaks(tank_plan(), 0.0, 3)
    nis = np.mean([np.nansum(run.nis[100:]) / run.count[100:].sum() for run in runs])
    assert abs(nis - 1.0) < 0.05
