"""Uncertainty: published values, exact combinatorics and limits."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet.identify.gum import (
    chi_square_probability,
    coverage_factor,
    effective_degrees_of_freedom,
    few_runs_probability,
    gain,
    leave_one_out,
)


@pytest.mark.parametrize(("freedom", "factor"), [(1, 12.71), (4, 2.78), (10, 2.23), (50, 2.01), (math.inf, 1.96)])
def test_coverage_factors_agree_with_the_gum(freedom, factor):
    assert coverage_factor(float(freedom)) == pytest.approx(factor, abs=0.005)


def test_effective_degrees_of_freedom_agree_with_the_gum():
    # example H.1.6: 25, 9.7 and 6.7 nm with 18, 25.6 and 8 degrees of freedom, 2.9 and 16.6 nm with 50 and 2
    components = [(25.0, 18.0), (9.7, 25.6), (2.9, 50.0), (16.6, 2.0)]
    assert int(effective_degrees_of_freedom(components)) == 16


def test_known_components_have_infinite_degrees_of_freedom():
    assert effective_degrees_of_freedom([(1.0, math.inf), (2.0, math.inf)]) == math.inf


@given(st.lists(st.tuples(st.floats(0.01, 10.0), st.floats(1.0, 100.0)), min_size=1, max_size=5))
@settings(derandomize=True, deadline=None)
def test_effective_degrees_of_freedom_are_between_minimum_and_sum(components):
    freedom = effective_degrees_of_freedom(components)
    assert min(nu for _, nu in components) * (1 - 1e-12) <= freedom
    assert freedom <= sum(nu for _, nu in components) * (1 + 1e-12)


def test_chi_square_probability_without_degrees_of_freedom_is_not_a_number():
    assert math.isnan(chi_square_probability(1.0, 0))
    assert chi_square_probability(0.0, 3) == 1.0


def count_runs(signs):
    return 1 + sum(a != b for a, b in itertools.pairwise(signs))


@pytest.mark.parametrize("signs", ["+++---", "++-+--", "+-+-+-", "++++-", "+--++-+", "-+++++++"])
def test_runs_probability_agrees_with_enumeration_of_all_orders(signs):
    orders = set(itertools.permutations(signs))
    as_few = sum(count_runs(order) <= count_runs(signs) for order in orders)
    residuals = np.array([1.0 if sign == "+" else -1.0 for sign in signs])
    assert few_runs_probability(residuals) == pytest.approx(as_few / len(orders), rel=1e-12)


def test_runs_probability_of_one_sign_is_one():
    assert few_runs_probability(np.ones(8)) == 1.0
    assert few_runs_probability(np.zeros(8)) == 1.0


def test_gain_marks_a_direction_without_effect_as_not_determined():
    jacobian = np.array([[1.0, 1.0, 0.0], [2.0, 2.0, 0.0], [0.0, 0.0, 3.0]])
    matrix, determined = gain(jacobian)
    assert determined.tolist() == [False, False, True]
    assert matrix @ jacobian @ matrix == pytest.approx(matrix)


def test_leave_one_out_of_a_linear_model_is_exact():
    generator = np.random.default_rng(5)
    jacobian = generator.standard_normal((9, 2))
    data = generator.standard_normal(9)
    full = np.linalg.lstsq(jacobian, data, rcond=None)[0]
    shifts = leave_one_out(jacobian, jacobian @ full - data, gain(jacobian)[0])
    for k in range(9):
        is_used = np.arange(9) != k
        without = np.linalg.lstsq(jacobian[is_used], data[is_used], rcond=None)[0]
        assert shifts[:, k] == pytest.approx(without - full, rel=1e-10, abs=1e-13)


def test_influence_of_a_point_that_alone_determines_a_parameter_is_not_a_number():
    jacobian = np.array([[1.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    assert np.isnan(leave_one_out(jacobian, np.array([0.1, -0.1, 0.0]), gain(jacobian)[0])[:, 2]).all()
