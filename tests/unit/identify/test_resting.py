"""Tests of the constant start of a recording with few samples."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.identify.tank.resting import rest_of_few_samples
from tank_discharge import REST, discharge


@pytest.mark.parametrize("step", [1.0, 2.0])
@pytest.mark.parametrize("before", [0.0, 1.9, REST])
def test_the_rest_ends_at_the_last_sample_before_the_change(step, before):
    dense_time, dense = discharge(60.0, 0.05)
    time = np.arange(REST - before, 58.0, step)
    values = np.interp(time, dense_time, dense) + np.random.default_rng(0).normal(0.0, 300.0, time.size)
    rest = rest_of_few_samples(time - time[0], values)
    if before == 0.0:
        assert rest == 0.0
    else:
        assert abs(rest - before) < step


def test_many_samples_are_left_to_the_other_method():
    time, pressure = discharge()
    assert rest_of_few_samples(time, pressure) == 0.0
