"""Bounded least squares against SciPy, on problems with known solutions and on random ones."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import pytest
from scipy.optimize import lsq_linear

from poppet.identify.fit.residuals import LOSSES, costs_of, curvatures_of, weights_of
from poppet.identify.least_squares import _solve_step
from searches import Array, Problem, found, found_by_scipy, unbounded

SAMPLES = np.linspace(0.0, 1.0, 60)


def test_search_follows_a_curved_valley_to_its_end() -> None:
    for unit in (1.0, 1e-9, 1e6):
        valley = unbounded(
            lambda b, u=unit: np.array([10.0 * (b[1] / u - (b[0] / u) ** 2), 1.0 - b[0] / u]), [-1.2 * unit, unit]
        )
        end = found(valley)
        assert end.x == pytest.approx([unit, unit], rel=1e-6)
        assert end.evaluations < 20


def test_linear_problem_ends_exactly_at_active_bounds() -> None:
    generator = np.random.default_rng(2)
    for _ in range(15):
        matrix, right = generator.normal(size=(15, 5)), generator.normal(size=15)
        low, high = -generator.uniform(0.05, 0.6, 5), generator.uniform(0.05, 0.6, 5)
        expected = lsq_linear(matrix, right, (low, high), tol=1e-14)
        end = found(Problem(lambda b, m=matrix, r=right: m @ b - r, 0.5 * (low + high), low, high))
        assert end.x == pytest.approx(expected.x, abs=1e-6)
        for bound in (low, high):
            assert np.array_equal(end.x == bound, np.abs(expected.x - bound) < 1e-9)


def test_search_leaves_a_corner_of_the_bounds() -> None:
    corner = np.array([0.0, 2.0])
    end = found(Problem(lambda b: np.array([b[0] - 1.0, b[1] - 1.0]), corner, np.zeros(2), np.full(2, 2.0)))
    assert end.x == pytest.approx([1.0, 1.0], abs=1e-9)


def test_parameters_without_effect_do_not_change() -> None:
    # The residuals depend only on the sum of the first two parameters.
    end = found(
        unbounded(lambda b: np.array([b[0] + b[1] - 3.0, 2.0 * (b[0] + b[1]) - 5.0, 1.0 + 0.0 * b[2]]), np.ones(3))
    )
    assert end.x == pytest.approx([1.3, 1.3, 1.0], abs=1e-9)


def test_step_decreases_a_concave_cost() -> None:
    slopes, wide = np.array([[1e-3]]), (np.array([-2.0]), np.array([2.0]))
    for bend in (-5.0, -1e-3):
        assert _solve_step(slopes, np.array([1.0]), np.array([[bend]]), wide, 0.5, 1e-10) == pytest.approx(
            [-0.5], rel=0.05
        )


def test_step_limits_the_relative_change_of_parameters() -> None:
    evaluated_points: list[Array] = []

    def residual(b: Array) -> Array:
        if not np.iscomplexobj(b):
            evaluated_points.append(b)
        return np.array([b[0] - 100.0, b[1] - 0.01])

    assert found(unbounded(residual, [1.0, 1.0])).x == pytest.approx([100.0, 0.01], rel=1e-6)
    points = np.array(evaluated_points)
    factors = points[1:] / points[:-1]
    # A tenth of a usual size is small, and may be left in one step.
    assert factors.max() < 3.0 + 1e-9
    assert factors[points[:-1] > 0.1].min() > 0.5 - 1e-9


def test_search_ends_at_the_maximum_number_of_evaluations() -> None:
    end = found(unbounded(lambda b: np.array([10.0 * (b[1] - b[0] ** 2), 1.0 - b[0]]), [-1.2, 1.0]), most=4)
    assert (end.evaluations, end.reason) == (4, "evaluations")
    assert end.cost < 12.1  # half the squares at the begin


@pytest.mark.parametrize("loss", LOSSES)
def test_weights_and_curvatures_are_derivatives_of_the_cost(loss: str) -> None:
    residual, step = np.array([-3.0, -0.7, 0.0, 0.2, 0.9, 1.4, 8.0]), 1e-5
    before, after = costs_of(residual - step, loss), costs_of(residual + step, loss)
    assert weights_of(residual, loss) * residual == pytest.approx((after - before) / (2.0 * step), abs=1e-8)
    second = (after - 2.0 * costs_of(residual, loss) + before) / step**2
    assert curvatures_of(residual, loss) == pytest.approx(np.maximum(second, 0.0), abs=1e-4)


@pytest.mark.parametrize("loss", LOSSES)
def test_robust_losses_agree_with_scipy(loss: str) -> None:
    generator = np.random.default_rng(4)
    values = 2.0 * np.exp(-3.0 * SAMPLES) + 0.5 + generator.normal(0.0, 0.01, SAMPLES.size)
    values[::9] += 0.4
    problem = unbounded(lambda b: (b[0] * np.exp(-b[1] * SAMPLES) + b[2] - values) / 0.01, [1.0, 2.0, 1.0])
    ours, theirs = found(problem, loss), found_by_scipy(problem, loss, 1e-14, 500)
    assert ours.cost == pytest.approx(theirs.cost, rel=1e-9)
    assert ours.x == pytest.approx(theirs.x, rel=1e-4)


Model = Callable[[Array], Array]


def exponentials(generator: np.random.Generator) -> tuple[Model, Array]:
    count = int(generator.integers(1, 4))
    truth = np.concatenate([10 ** generator.uniform(-1, 1, count), 10 ** generator.uniform(-0.5, 1.5, count)])
    return lambda b: (b[:count] * np.exp(-np.outer(SAMPLES, b[count:]))).sum(axis=1), truth


def valleys(generator: np.random.Generator) -> tuple[Model, Array]:
    """Return Rosenbrock functions with parameters of any size."""
    units = 10 ** generator.uniform(-6, 6, int(generator.integers(2, 7)))
    return lambda b: np.append(
        10.0 * (b[1:] / units[1:] - (b[:-1] / units[:-1]) ** 2), 1.0 - b[:-1] / units[:-1]
    ), units


def bumpy(generator: np.random.Generator) -> tuple[Model, Array]:
    count = int(generator.integers(2, 10))
    straight, wavy = generator.normal(size=(2, 40, count))
    return lambda b: straight @ b + 0.5 * np.sin(wavy @ b), generator.normal(size=count)


def deficient(generator: np.random.Generator) -> tuple[Model, Array]:
    """Return a model that does not depend on one direction of the parameters."""
    count = int(generator.integers(3, 7))
    projection, matrix = generator.normal(size=(count - 1, count)), generator.normal(size=(30, count - 1))

    def model(b: Array) -> Array:
        linear = matrix @ (projection @ b)
        return linear + 0.2 * linear**2

    return model, generator.normal(size=count)


def fractions(generator: np.random.Generator) -> tuple[Model, Array]:
    x = 4.0 * SAMPLES + 0.1
    truth = generator.uniform((0.5, 0.1, 0.1, 0.1), (2.0, 3.0, 3.0, 2.0))
    return lambda b: b[0] * (x**2 + x * b[1]) / (x**2 + x * b[2] + b[3]), truth


def badly_scaled(generator: np.random.Generator) -> tuple[Model, Array]:
    truth = np.array([1e5, 1e-3, 1.0, 1e-8]) * generator.uniform(0.5, 2.0, 4)
    return lambda b: b[0] * (1.0 - np.exp(-SAMPLES * 1e-2 / b[1])) ** b[2] + b[3] * 1e12 * SAMPLES, truth


SINGLE, SEVERAL = (valleys, bumpy, deficient, badly_scaled), (exponentials, fractions)
"""Families of models with one minimum, and with several."""


def problems(
    families: tuple[Callable[[np.random.Generator], tuple[Model, Array]], ...], count: int
) -> Iterator[Problem]:
    """Yield problems with noise, start values up to a factor of two off, and often active bounds."""
    generator = np.random.default_rng(0)
    for k in range(count):
        model, truth = families[k % len(families)](generator)
        exact = model(truth)
        noise = 10 ** generator.uniform(-5, -1) * max(float(np.std(exact)), 1e-3)
        values = exact + generator.normal(0.0, noise, exact.size)
        low, high = np.full(truth.size, -np.inf), np.full(truth.size, np.inf)
        begin = truth * generator.uniform(0.5, 1.8, truth.size)
        if generator.random() < 0.6:
            span = np.abs(truth) * generator.uniform(0.05, 3.0, truth.size)
            bounded, reach = generator.random((2, truth.size)) < 0.6, generator.uniform(-0.15, 1.0, truth.size)
            low = np.where(bounded[0], truth - reach * span, low)
            high = np.where(bounded[1], np.maximum(truth, low) + span, high)
            begin = np.clip(begin, low + 1e-3 * span, high - 1e-3 * span)
        yield Problem(lambda b, m=model, v=values, s=noise: (m(b) - v) / s, begin, low, high)


@pytest.mark.parametrize("count", [40, pytest.param(400, marks=pytest.mark.slow)])
def test_search_needs_fewer_evaluations_than_scipy(count: int) -> None:
    ours = theirs = 0
    for problem in problems(SINGLE, count):
        end, scipy_result = found(problem), found_by_scipy(problem)
        least = min(scipy_result.cost, found_by_scipy(problem, precision=1e-13, most=1000).cost)
        assert end.cost <= least * (1.0 + 1e-9) + 1e-9
        ours, theirs = ours + end.evaluations, theirs + scipy_result.nfev
    assert ours < 0.8 * theirs


@pytest.mark.parametrize("count", [8, pytest.param(200, marks=pytest.mark.slow)])
def test_search_and_scipy_reach_equally_low_minima(count: int) -> None:
    ours = theirs = worse = better = 0
    for problem in problems(SEVERAL, count):
        end, scipy_result = found(problem), found_by_scipy(problem)
        ours, theirs = ours + end.evaluations, theirs + scipy_result.nfev
        worse += end.cost > scipy_result.cost * (1.0 + 1e-6) + 1e-9
        better += scipy_result.cost > end.cost * (1.0 + 1e-6) + 1e-9
    assert worse <= better + 2 + 0.02 * count
    assert ours < 0.7 * theirs
