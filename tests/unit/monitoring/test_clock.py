"""Clock of a stream: late, repeated and lost samples, and clocks that are set."""

from __future__ import annotations

import math

import numpy as np
import pytest

from poppet.monitoring.clock import StreamClock

ALL = (1.0, 1.0)
NAN = math.nan


def placed(times, *, gap=60.0, rows=None):
    """Return times on the clock of the filter, None for skipped samples, and the codes of messages."""
    clock, problems = StreamClock(2, gap), []
    results = [clock.place(time, ALL if rows is None else rows[k], problems) for k, time in enumerate(times)]
    return [None if result is None else result.time for result in results], [problem.code for problem in problems]


def test_increasing_times_are_unchanged():
    assert placed([5.0, 5.1, 5.3, 60.0]) == ([5.0, 5.1, 5.3, 60.0], [])


def test_a_repeated_time_is_skipped():
    assert placed([0.0, 1.0, 1.0, 2.0]) == ([0.0, 1.0, None, 2.0], ["stream.clock_equal"])


def test_columns_of_one_time_can_come_in_several_samples():
    rows = [(1.0, NAN), (NAN, 1.0), (1.0, NAN), (NAN, 1.0)]
    assert placed([0.0, 0.0, 1.0, 0.5], rows=rows) == ([0.0, 0.0, 1.0, 0.5], [])


def test_old_values_of_a_sample_are_not_used_again():
    clock, problems = StreamClock(2, 60.0), []
    for time, values in ((0.0, ALL), (1.0, (1.0, NAN))):
        clock.place(time, values, problems)
    result = clock.place(0.5, ALL, problems)
    assert result.time == 0.5
    assert [math.isnan(value) for value in result.values] == [True, False]
    assert [problem.code for problem in problems] == ["stream.clock_partly"]


def test_a_single_earlier_time_is_skipped():
    assert placed([10.0, 11.0, 3.0, 12.0, 13.0]) == ([10.0, 11.0, None, 12.0, 13.0], ["stream.clock_back"])


def test_a_clock_that_is_set_back_continues():
    times, codes = placed([100.0, 101.0, 102.0, 0.0, 1.0, 2.0, 3.0, 4.5])
    # The time that has passed is unknown: a gap of 60 s.
    assert times == [100.0, 101.0, 102.0, None, None, 162.0, 163.0, 164.5]
    assert codes == ["stream.clock_back", "stream.clock_back", "stream.clock_set"]


def test_a_single_time_far_ahead_is_skipped():
    assert placed([0.0, 1.0, 1e9, 2.0, 3.0]) == ([0.0, 1.0, None, 2.0, 3.0], ["stream.clock_ahead"])


def test_a_gap_is_confirmed_by_the_next_sample():
    clock, problems = StreamClock(2, 60.0), []
    results = [clock.place(time, ALL, problems) for time in (0.0, 1.0, 5000.0, 5001.0, 5002.0)]
    assert [result and result.time for result in results] == [0.0, 1.0, None, 5001.0, 5002.0]
    (problem,) = problems
    assert (problem.code, problem.facts["gap"]) == ("stream.gap", 5000.0)


def test_slow_samples_are_no_gaps():
    times = [3600.0 * k for k in range(6)]
    assert placed(times, gap=3600.0) == (times, [])


@pytest.mark.parametrize("seed", range(5))
def test_the_clock_of_the_filter_never_stops_and_rarely_steps_back(seed):
    generator = np.random.default_rng(seed)
    times = np.cumsum(generator.exponential(1.0, 400))
    times[generator.integers(0, 400, 40)] += generator.choice([-1e9, -50.0, 0.0, 50.0, 1e6], 40)
    clock, problems = StreamClock(2, 60.0), []
    results = [clock.place(float(time), ALL, problems) for time in times]
    used = [result.time for result in results if result is not None]
    assert all(np.diff(used) > 0.0)
    assert len(used) > 250
