"""Samples of a plant: values by column in their units, converted to SI, and invalid values."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from poppet.monitoring.samples import SampleReader
from poppet.monitoring.twin_file import ClockColumn, read_twin_file
from refusals import refused

EXAMPLE = Path(__file__).parents[3] / "examples/watch/twin.toml"
PLAN = read_twin_file(EXAMPLE).plan
MINUTES = ClockColumn("t", "min", 60.0)


def codes(values, reader=None):
    """Return the SI values of a sample, and the codes of its problems."""
    problems = []
    sample = (reader or SampleReader(PLAN, MINUTES)).read({"t": 0.0} | values, problems)
    return list(sample.values), [problem.code for problem in problems]


def test_values_are_converted_to_si():
    problems = []
    sample = SampleReader(PLAN, MINUTES).read({"t": 1.5, "p": 6, "u": True, "w": 0.25, "x": "note"}, problems)
    assert (sample.time, list(sample.values), problems) == (90.0, [7e5, 1.0, 0.25], [])


@pytest.mark.parametrize("raw", [None, math.nan])
def test_missing_values_are_no_problem(raw):
    values, problems = codes({"p": raw, "u": 0.5})
    assert np.isnan(values).tolist() == [True, False, True]
    assert problems == []


@pytest.mark.parametrize("raw", ["6.1 bar", [1.0], {"a": 1}, "NaN?"])
def test_other_types_are_no_numbers(raw):
    values, problems = codes({"p": raw})
    assert math.isnan(values[0])
    assert problems == ["stream.no_number"]


@pytest.mark.parametrize("raw", [math.inf, -math.inf, 1e300, 10**400, -1.01])
def test_impossible_values_are_missing(raw):
    values, problems = codes({"p": raw})
    assert math.isnan(values[0])
    assert problems == ["stream.too_large"]


@pytest.mark.parametrize("raw", ["open", 50.0, -1.0, math.inf])
def test_invalid_inputs_are_infinite(raw):
    values, problems = codes({"u": raw})
    assert values[1] == math.inf
    assert len(problems) == 1


@pytest.mark.parametrize("time", [None, math.nan, math.inf, "today", [1], True, 1e15])
def test_a_sample_needs_a_time(time):
    with refused("stream.no_time", "t"):
        SampleReader(PLAN, MINUTES).read({"t": time, "p": 6.0}, [])


def test_time_stamps_are_seconds_since_the_first():
    stamps = "2026-03-01T12:00:00.250Z", "2026-03-01T13:00:01.5+01:00", "2026-03-01T12:03:23.350Z"
    reader = SampleReader(PLAN, MINUTES)
    assert [reader.read({"t": stamp}, []).time for stamp in stamps] == [0.0, 1.25, 203.1]


@pytest.mark.parametrize("factor", [1e3, 100.0, 1e5], ids=["mbar", "kPa", "Pa"])
def test_a_unit_that_becomes_smaller_is_noticed(factor):
    reader = SampleReader(PLAN, MINUTES)
    for pressure in (6.0, 6.02, 5.95):
        assert codes({"p": pressure}, reader)[1] == []
    found = [codes({"p": pressure * factor}, reader) for pressure in np.linspace(5.9, 2.0, 20)]
    assert [code for _, problems in found for code in problems] == ["stream.unit_changed"]
    assert all(math.isnan(values[0]) for values, _ in found)
    # The old unit is accepted again.
    assert codes({"p": 2.0}, reader)[0][0] == 3e5


def test_a_single_reading_in_another_unit_is_missing():
    reader = SampleReader(PLAN, MINUTES)
    found = [codes({"p": pressure}, reader) for pressure in (6.0, 6000.0, 6.1)]
    assert [problems for _, problems in found] == [[]] * 3
    assert [math.isnan(values[0]) for values, _ in found] == [False, True, False]


def test_filling_and_exhausting_are_no_changes_of_the_unit():
    reader = SampleReader(PLAN, MINUTES)
    pressures = (6.0, 0.06, 0.006, 6.0, -0.002, 0.05, 5.0, 0.08725, 6.0)
    assert [math.isnan(codes({"p": pressure}, reader)[0][0]) for pressure in pressures] == [False] * len(pressures)
