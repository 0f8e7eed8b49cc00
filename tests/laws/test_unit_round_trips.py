from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet.core.errors import InputError
from poppet.core.unit_table import TABLE
from poppet.core.units import convert, quantity, same_dimension, sizes_of

SETTINGS = settings(derandomize=True, deadline=None, max_examples=60)
COMPOSED = [
    "bar g",
    "psi g",
    "Pa",
    "l/min ANR",
    "m^3/h N",
    "kg/s",
    "m^3/(s Pa)",
    "dm^3/(s bar)",
    "J/(kg K)",
    "m^2/(ms^2 K)",
]
UNITS = sorted(TABLE) + [unit for unit in COMPOSED if unit not in TABLE]
PAIRS = [(a, b) for a, b in combinations(UNITS, 2) if same_dimension(a, b)]
sizes = st.floats(1e-6, 1e6)


@SETTINGS
@given(pair=st.sampled_from(PAIRS), value=sizes)
def test_there_and_back(pair, value):
    source, target = pair
    back = convert(convert(value, source, target), target, source)
    # Zero of the other unit is the size of the numbers that cancel between gauge and absolute, degC and K.
    assert abs(back - value) <= 1e-14 * (value + abs(convert(0.0, target, source)))


@SETTINGS
@given(pair=st.sampled_from(PAIRS), value=sizes, factor=st.floats(1.5, 100.0))
def test_conversion_keeps_the_order(pair, value, factor):
    source, target = pair
    assert convert(factor * value, source, target) >= convert(value, source, target)


@SETTINGS
@given(pair=st.sampled_from(PAIRS), values=st.lists(sizes, min_size=1, max_size=5))
def test_arrays_convert_as_their_elements(pair, values):
    together = convert(np.array(values), *pair)
    np.testing.assert_array_equal(together, [convert(value, *pair) for value in values])


@SETTINGS
@given(part=st.floats(-1.0, 1.0), unit=st.sampled_from(["m^3", "Pa", "N s/m", "m^3/(s Pa)", "kg/s", "1"]))
def test_a_written_si_value_is_read_bit_by_bit(part, unit):
    value = part * sizes_of(unit)[1]
    assert quantity(f"{value!r} {unit}", unit).value == value


@SETTINGS
@given(value=sizes, symbol=st.sampled_from(["mbar", "kPa", "psi", "atm"]))
def test_text_and_conversion_agree(value, symbol):
    assert quantity(f"{value!r} {symbol}", "Pa").value == pytest.approx(convert(value, symbol, "Pa"), rel=1e-15)


@SETTINGS
@given(value=sizes, ambient=st.floats(5e4, 1.2e5))
def test_gauge_and_absolute_differ_by_the_ambient_pressure(value, ambient):
    absolute = convert(value, "Pa g", "Pa", ambient_pressure=ambient)
    assert absolute == pytest.approx(value + ambient, rel=1e-15)


@SETTINGS
@given(text=st.text(alphabet="mskgPabrN()^*/.-1 %dC", max_size=30))
def test_any_text_is_read_or_refused_with_three_parts(text):
    problem = _problem_of(f"1 {text}")
    assert problem is None or (problem.given and problem.reason and problem.hint)


def _problem_of(text: str) -> InputError | None:
    try:
        quantity(text, "m")
    except InputError as problem:
        return problem
    return None
