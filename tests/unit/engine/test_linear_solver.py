"""The printed sparse elimination against a dense solver."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from poppet.engine.elimination import eliminate, solver_functions


def random_jacobian(size: int, density: float, seed: int) -> np.ndarray:
    generator = np.random.default_rng(seed)
    matrix = generator.normal(size=(size, size)) * (generator.random((size, size)) < density)
    return np.asarray(matrix * 10.0 ** generator.uniform(-3.0, 3.0, size)[:, None])


def solved(jacobian: np.ndarray, shift: float, right: np.ndarray) -> np.ndarray:
    sparsity = ca.sparsify(ca.DM(jacobian)).sparsity()
    rows, columns = sparsity.get_triplet()
    factor, solve = solver_functions(sparsity)
    return np.array(solve(factor(jacobian[rows, columns], shift), right)).ravel()


@pytest.mark.parametrize("size", [1, 2, 3, 8, 20])
@pytest.mark.parametrize("density", [0.0, 0.1, 0.4, 1.0])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_against_a_dense_solver(size, density, seed):
    jacobian = random_jacobian(size, density, seed)
    shift = 2.0 * np.abs(jacobian).sum(axis=1).max() + 1.0
    right = np.random.default_rng(seed).normal(size=size)
    known = np.linalg.solve(shift * np.eye(size) - jacobian, right)
    assert np.abs(solved(jacobian, shift, right) - known).max() <= 1e-13 * np.abs(known).max()


def test_stiff_chain():
    """A bidiagonal chain of widely different rates, the form of tanks in a row."""
    rates = 10.0 ** np.arange(0.0, 10.0)
    jacobian = np.diag(-rates) + np.diag(rates[:-1], -1)
    right = np.ones(10)
    known = np.linalg.solve(100.0 * np.eye(10) - jacobian, right)
    assert np.abs(solved(jacobian, 100.0, right) / known - 1.0).max() <= 1e-13


def test_quadratures_are_eliminated_without_fill():
    """States 0..2 are coupled, 3..6 only read them: the factors hold no more entries than the matrix."""
    pattern = {(i, j) for i in range(3) for j in range(3) if i != j} | {(k, j) for k in range(3, 7) for j in range(3)}
    plan = eliminate(pattern, 7)
    assert set(plan.order[:4]) == {3, 4, 5, 6}
    assert sum(map(len, plan.rows.values())) + sum(map(len, plan.columns.values())) == len(pattern)


def test_an_arrow_is_eliminated_from_its_tips():
    pattern = {(0, k) for k in range(1, 6)} | {(k, 0) for k in range(1, 6)}
    plan = eliminate(pattern, 6)
    assert plan.order.index(0) >= 4
    assert sum(map(len, plan.rows.values())) + sum(map(len, plan.columns.values())) == len(pattern)


def test_order_is_a_permutation():
    jacobian = random_jacobian(15, 0.2, 5)
    plan = eliminate(set(zip(*map(list, np.nonzero(jacobian)), strict=True)), 15)
    assert sorted(plan.order) == list(range(15))


def test_a_vanishing_pivot_is_not_finite():
    """W = 0: the step is rejected because its result is not finite."""
    assert not np.all(np.isfinite(solved(np.array([[2.0]]), 2.0, np.array([1.0]))))
