"""Error model of a fit, on linear models: noise, lack of fit and offsets."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import lsq_linear, minimize

from poppet.identify.fit.search import Optimum
from poppet.identify.fit.statistics import ErrorModel, SensorLimits, confidence_bands, estimates, influences
from poppet.identify.free_parameter import FreeParameter
from poppet.identify.result import Estimate

SAMPLES, SEEDS = 200, 400
X = np.linspace(0.0, 1.0, SAMPLES)
TWO = np.vstack([np.column_stack([X, X**2])] * 2)
"""Jacobian of two channels that depend on the same two parameters; a constant is not a combination of its columns."""


def fit_linear(jacobian: np.ndarray, values: np.ndarray, active: tuple[int, ...] | None = None) -> Optimum:
    """Return the optimum of a linear model whose true parameters are 1."""
    measured = jacobian.sum(axis=1) + values
    x = np.linalg.lstsq(jacobian, measured, rcond=None)[0]
    residual = jacobian @ x - measured
    bounds = np.array(active or (0,) * x.size)
    return Optimum(x, 0.5 * float(residual @ residual), jacobian, residual, [1.0], bounds)


def noise(seed: int, size: int) -> np.ndarray:
    return np.random.default_rng([2012, seed]).normal(0.0, 1.0, size)


def intervals_cover(optimum: Optimum, spread: ErrorModel) -> np.ndarray:
    return np.array(
        [abs(x - 1.0) <= 1.96 * spread.deviation(p) for x, p in zip(optimum.x, influences(optimum), strict=True)]
    )


def test_influences_are_changes_of_the_estimates():
    jacobian = np.column_stack([np.ones(SAMPLES), X, X**2])
    values = noise(0, SAMPLES)
    base, shifted = fit_linear(jacobian, values), fit_linear(jacobian, values + np.eye(SAMPLES)[7])
    assert influences(base)[:, 7] == pytest.approx(shifted.x - base.x, rel=1e-6)


def test_parameter_at_its_bound_is_fixed_for_the_others():
    jacobian = np.column_stack([X, X**2, X**3])
    rows = influences(fit_linear(jacobian, noise(0, SAMPLES), active=(0, 0, 1)))
    assert rows[:2] == pytest.approx(np.linalg.pinv(jacobian[:, :2]), rel=1e-6)
    assert rows[2] == pytest.approx(np.linalg.pinv(jacobian)[2], rel=1e-6)


def test_parameter_without_effect_is_infinitely_uncertain_and_does_not_affect_others():
    jacobian = np.column_stack([X, np.zeros(SAMPLES), X**2])
    optimum = fit_linear(jacobian, noise(0, SAMPLES))
    optimum.x[1] = 1.0
    spread = ErrorModel(optimum, [SAMPLES], 1.0)
    rows = influences(optimum)
    assert spread.deviation(rows[1]) == np.inf
    assert spread.factor(rows[1]) == 1.0
    assert rows[[0, 2]] == pytest.approx(np.linalg.pinv(jacobian[:, [0, 2]]), rel=1e-6)


def test_white_noise_gives_no_variance_factor_and_no_offset():
    optima = [fit_linear(TWO, noise(seed, 2 * SAMPLES)) for seed in range(SEEDS)]
    spreads = [ErrorModel(optimum, [SAMPLES, SAMPLES], 1.0) for optimum in optima]
    assert [offset for spread in spreads for offset in spread.offsets] == []
    factors = [spread.factor(pull) for spread, o in zip(spreads, optima, strict=True) for pull in influences(o)]
    assert np.mean(np.sqrt(factors)) < 1.05
    covered = np.mean([intervals_cover(o, s) for o, s in zip(optima, spreads, strict=True)], axis=0)
    assert np.all((covered >= 0.92) & (covered <= 0.98))


def test_offset_has_its_size_and_standard_error():
    truth, is_covered, shifts = 0.8, [], []
    values = np.concatenate([np.full(SAMPLES, truth), np.zeros(SAMPLES)])
    for seed in range(SEEDS):
        optimum = fit_linear(TWO, values + noise(seed, 2 * SAMPLES))
        offset = next(o for o in ErrorModel(optimum, [SAMPLES, SAMPLES], 1.0).offsets if o.channel == 0)
        assert offset.rows == slice(0, SAMPLES)
        is_covered.append(abs(offset.size - truth) <= 1.96 * offset.error)
        shifts.append(offset.size)
    assert np.mean(shifts) == pytest.approx(truth, abs=0.02)
    assert 0.92 <= np.mean(is_covered) <= 0.98


def test_shift_is_the_change_of_estimates_by_a_fitted_offset():
    values = noise(3, 2 * SAMPLES) + np.concatenate([np.full(SAMPLES, 2.0), np.zeros(SAMPLES)])
    optimum = fit_linear(TWO, values)
    constant = np.concatenate([np.ones(SAMPLES), np.zeros(SAMPLES)])[:, None]
    estimates_with_offset = np.linalg.lstsq(np.hstack([TWO, constant]), TWO.sum(axis=1) + values, rcond=None)[0]
    spread = ErrorModel(optimum, [SAMPLES, SAMPLES], 1.0)
    offset = spread.offsets[0]
    assert offset.size == pytest.approx(estimates_with_offset[2], rel=1e-9)
    for pull, estimate, estimate_with_offset in zip(
        influences(optimum), optimum.x, estimates_with_offset[:2], strict=True
    ):
        error_with_offset, error_without_offset = (
            spread.deviation(pull, offsets=offsets) for offsets in ((offset,), ())
        )
        ratio = offset.error / offset.size
        assert np.sqrt(error_with_offset**2 - error_without_offset**2) == pytest.approx(
            abs(estimate - estimate_with_offset) * np.hypot(1.0, ratio), rel=1e-6
        )


def test_intervals_contain_the_effect_of_an_offset():
    values = np.concatenate([np.full(SAMPLES, 1.5), np.zeros(SAMPLES)])
    optima = [fit_linear(TWO, values + noise(seed, 2 * SAMPLES)) for seed in range(100)]
    spreads = [ErrorModel(o, [SAMPLES, SAMPLES], 1.0) for o in optima]
    assert np.mean([intervals_cover(o, s) for o, s in zip(optima, spreads, strict=True)]) > 0.95
    white_intervals_cover = [1.96 * np.linalg.norm(influences(o), axis=1) >= abs(o.x - 1.0) for o in optima]
    assert np.mean(white_intervals_cover) < 0.5


def test_free_offset_is_not_counted_twice():
    jacobian = np.column_stack([X, np.ones(SAMPLES)])
    assert ErrorModel(fit_linear(jacobian, 5.0 + noise(1, SAMPLES)), [SAMPLES], 1.0).offsets == []


def test_offset_is_limited_by_its_sensor():
    """The parameters nearly imitate a constant: the small remainder would give a large offset."""
    nearly = np.column_stack([1.0 + 1e-2 * np.sin(40.0 * X), X])
    optimum = fit_linear(nearly, 1000.0 + noise(1, SAMPLES))
    (free,) = ErrorModel(optimum, [SAMPLES], 1.0).offsets
    assert free.size == pytest.approx(1000.0, rel=0.1)
    (bounded,) = ErrorModel(optimum, [SAMPLES], 1.0, gauges=[SensorLimits(largest=5.0)]).offsets
    assert (bounded.size, bounded.error, bounded.is_possible) == (5.0, 5.0, False)


def test_local_lack_of_fit_widens_the_interval_of_its_parameter():
    """Only five samples depend on the first parameter, and their noise is above the mean."""
    jacobian = np.zeros((SAMPLES, 2))
    jacobian[:5, 0], jacobian[5:, 1] = 1.0, X[5:]
    sigma = np.ones(SAMPLES)
    sigma[:5] = 10.0
    optima = [fit_linear(jacobian, sigma * noise(seed, SAMPLES)) for seed in range(SEEDS)]
    spreads = [ErrorModel(o, [SAMPLES], max(1.0, float(np.mean(o.residual**2)))) for o in optima]
    covered = np.mean([intervals_cover(o, s) for o, s in zip(optima, spreads, strict=True)], axis=0)
    # Five samples estimate their noise roughly: with four degrees of freedom, 88 % are within 1.96.
    assert covered[0] > 0.8
    assert covered[1] >= 0.92
    assert np.mean([s.is_local(influences(o)[0], 1.5) for o, s in zip(optima, spreads, strict=True)]) > 0.9
    assert not any(s.is_local(influences(o)[1], 1.5) for o, s in zip(optima, spreads, strict=True))


def test_correlated_lack_of_fit_widens_intervals():
    """First-order noise with a correlation time of nine samples affects a slope."""
    covered = []
    for seed in range(SEEDS):
        series, state = noise(seed, SAMPLES) * np.sqrt(1.0 - 0.8**2), 0.0
        for k in range(SAMPLES):
            state = series[k] = 0.8 * state + series[k]
        optimum = fit_linear(X[:, None], series)
        covered.append(intervals_cover(optimum, ErrorModel(optimum, [SAMPLES], 1.0))[0])
    assert np.mean(covered) > 0.85


@pytest.mark.parametrize("loss", ["soft_l1", "huber", "cauchy"])
def test_robust_loss_reduces_the_weight_of_an_outlier(loss):
    values = noise(5, SAMPLES)
    values[-1] = 100.0
    optimum = fit_linear(X[:, None], values)
    pull = influences(optimum)[0]
    robust, linear = (ErrorModel(optimum, [SAMPLES], 1.0, name).deviation(pull) for name in (loss, "linear"))
    assert robust < 0.5 * linear


def test_prior_counts_as_one_sigma():
    jacobian = np.vstack([np.zeros((SAMPLES, 1)), [[2.0]]])
    optimum = Optimum(np.ones(1), 0.0, jacobian, np.zeros(SAMPLES + 1), [1.0], np.zeros(1, dtype=np.int64))
    assert ErrorModel(optimum, [SAMPLES], 0.5).deviation(influences(optimum)[0]) == pytest.approx(0.5)


# Parameters at a bound ----------------------------------------------------------------------------------------------


def fit_bounded(
    jacobian: np.ndarray, measured: np.ndarray, lows: list[float]
) -> tuple[Optimum, tuple[FreeParameter, ...]]:
    """Return the optimum of a linear model with lower bounds, and its free parameters."""
    x = lsq_linear(jacobian, measured, (lows, np.inf), method="bvls").x
    free = tuple(FreeParameter(f"x{k}", f"x{k}", "m", 1.0, low) for k, low in enumerate(lows))
    residual = jacobian @ x - measured
    return Optimum(
        x, 0.5 * float(residual @ residual), jacobian, residual, [1.0], -(x <= np.array(lows)).astype(int)
    ), free


def farthest(optimum: Optimum, lows: list[float], k: int, side: float) -> float:
    """Return the distance of the farthest value of a parameter in the confidence region within the bounds."""
    excess = {
        "type": "ineq",
        "fun": lambda d: (
            1.96**2
            - float(np.sum((optimum.residual + optimum.jacobian @ d) ** 2) - optimum.residual @ optimum.residual)
        ),
    }
    ends = [
        minimize(
            lambda d: -side * d[k],
            start * side * np.eye(optimum.x.size)[k],
            method="SLSQP",
            bounds=[(low - x, None) for low, x in zip(lows, optimum.x, strict=True)],
            constraints=excess,
            options={"maxiter": 500, "ftol": 1e-12},
        )
        for start in (0.0, 0.1)
    ]
    return max(side * float(end.x[k]) for end in ends if end.success)


@pytest.mark.parametrize("effect", [(1.0, 1.0), (1.0, -1.0), (-3.0, 0.2)])
@pytest.mark.parametrize("push", [0.05, 2.0])
def test_intervals_are_the_ends_of_the_region_within_bounds(monkeypatch, effect, push):
    """Two parameters at a bound imitate the first parameter; the noise pushes both towards their bounds."""
    wave = np.column_stack([np.sin(9.0 * X), np.cos(9.0 * X)])
    jacobian = np.column_stack([X, X**2, 0.2 * wave + X[:, None] * effect])
    lows = [-np.inf, -np.inf, 0.0, 0.0]
    outward = (
        jacobian[:, 2:].sum(axis=1)
        - TWO[:SAMPLES] @ np.linalg.lstsq(TWO[:SAMPLES], jacobian[:, 2:].sum(axis=1), rcond=None)[0]
    )
    optimum, free = fit_bounded(jacobian, X + X**2 - push * outward / np.linalg.norm(outward), lows)
    assert optimum.active.tolist() == [0, 0, -1, -1]
    spread = ErrorModel(optimum, [SAMPLES], 1.0)
    monkeypatch.setattr(spread, "factor", lambda weights: 1.0)
    monkeypatch.setattr(spread, "deviation", lambda weights: float(np.linalg.norm(weights)))
    table = estimates(free, optimum, spread)
    for k in (0, 1):
        e = table[f"x{k}"]
        assert e.value - e.low == pytest.approx(farthest(optimum, lows, k, -1.0), rel=0.01)
        assert e.high - e.value == pytest.approx(farthest(optimum, lows, k, 1.0), rel=0.01)
        assert e.standard_error == pytest.approx(max(e.value - e.low, e.high - e.value) / 1.96, rel=0.01)


@pytest.mark.parametrize("truth", [0.0, 1.0, 2.0])
def test_coverage_if_a_nuisance_is_near_its_bound(truth):
    """The true value of the nuisance is 0 to 2 standard errors inside; the search ends at the bound in up to half."""
    jacobian = np.column_stack([X, X + 0.2 * np.sin(9.0 * X)])
    error = float(np.linalg.norm(np.linalg.pinv(jacobian)[1]))
    held: dict[bool, list[bool]] = {False: [], True: []}
    for seed in range(SEEDS // 2):
        optimum, free = fit_bounded(jacobian, X + truth * error * jacobian[:, 1] + noise(seed, SAMPLES), [-np.inf, 0.0])
        spread = ErrorModel(optimum, [SAMPLES], 1.0)

        def covers(e: Estimate) -> bool:
            return e.low <= 1.0 <= e.high

        for is_conditional, covered in held.items():
            covered.append(covers(estimates(free, optimum, spread, is_conditional=is_conditional)["x0"]))
    assert np.mean(held[False]) >= 0.92
    if truth:
        assert np.mean(held[True]) < np.mean(held[False])


def test_data_that_require_a_bound_leave_narrow_intervals(monkeypatch):
    """Ten standard errors beyond its bound, other values of the nuisance are almost excluded."""
    jacobian = np.column_stack([X, X + 0.2 * np.sin(9.0 * X)])
    error = float(np.linalg.norm(np.linalg.pinv(jacobian)[1]))
    extensions = []
    for excess in (0.01, 10.0):
        optimum, free = fit_bounded(jacobian, X - excess * error * jacobian[:, 1], [-np.inf, 0.0])
        spread = ErrorModel(optimum, [SAMPLES], 1.0)
        monkeypatch.setattr(spread, "factor", lambda weights: 1.0)
        narrow, wide = (estimates(free, optimum, spread, is_conditional=flag)["x0"] for flag in (True, False))
        extensions.append(narrow.low - wide.low)
    assert 0.0 <= extensions[1] < 0.2 * extensions[0]


def test_intervals_without_a_bound_are_identical():
    optimum, free = fit_bounded(TWO, TWO.sum(axis=1) + noise(0, 2 * SAMPLES), [0.0, 0.0])
    spread = ErrorModel(optimum, [SAMPLES, SAMPLES], 1.0)
    assert not optimum.active.any()
    assert estimates(free, optimum, spread) == estimates(free, optimum, spread, is_conditional=True)


# The band of the model ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["white", "correlated", "offset"])
def test_band_of_the_model_is_the_deviation_of_its_samples(kind):
    values = noise(3, 2 * SAMPLES)
    if kind == "correlated":
        values = np.convolve(np.concatenate([noise(4, 29), values]), np.full(30, 0.4), "valid")
    if kind == "offset":
        values = values + np.concatenate([np.full(SAMPLES, 1.5), np.zeros(SAMPLES)])
    spread = ErrorModel(fit_linear(TWO, values), [SAMPLES, SAMPLES], 1.3)
    hat = TWO @ np.linalg.pinv(TWO)
    assert spread.model_deviation() == pytest.approx([spread.deviation(row) for row in hat], rel=1e-6)


def test_direction_without_effect_does_not_change_the_band():
    three = np.column_stack([TWO, TWO[:, 0] * (1.0 + 1e-9 * np.sin(np.arange(2 * SAMPLES)))])
    values = noise(0, 2 * SAMPLES)
    band_of_two, band_of_three = (
        ErrorModel(fit_linear(j, values), [SAMPLES, SAMPLES], 1.0).model_deviation() for j in (TWO, three)
    )
    assert np.sum(band_of_three**2) == pytest.approx(np.sum(band_of_two**2) + 1.0, rel=0.1)


@pytest.mark.parametrize(("sigmas", "level"), [(1.0, 0.683), (1.96, 0.95)])
def test_bands_have_their_stated_coverage(sigmas, level):
    """The coverage is pointwise over repeated noise; the 95 % width is scaled to other levels."""
    truth, coverage_of_truth, coverage_of_samples = TWO.sum(axis=1), [], []
    for seed in range(SEEDS):
        optimum = fit_linear(TWO, noise(seed, 2 * SAMPLES))
        optimum.sigmas = [1.0, 1.0]
        bands = confidence_bands(optimum, ErrorModel(optimum, [SAMPLES, SAMPLES], 1.0))
        model, samples = (np.concatenate(half_widths) * sigmas / 1.96 for half_widths in zip(*bands, strict=True))
        error = TWO @ optimum.x - truth
        coverage_of_truth.append(np.mean(np.abs(error) <= model))
        coverage_of_samples.append(np.mean(np.abs(error - noise(SEEDS + seed, 2 * SAMPLES)) <= samples))
    # Each fit has at least two independent draws: this is the standard deviation of 2 SEEDS draws.
    assert np.mean(coverage_of_truth) == pytest.approx(level, abs=3.0 * np.sqrt(level * (1.0 - level) / (2 * SEEDS)))
    assert np.mean(coverage_of_samples) == pytest.approx(level, abs=0.01)
