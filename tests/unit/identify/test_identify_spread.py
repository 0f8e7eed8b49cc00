"""What moves the numbers of a fit: noise, misfit where it lies, constant offsets. On linear models."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.identify.fit.search import Optimum
from poppet.identify.fit.statistics import ErrorModel, SensorLimits, confidence_bands, influences

SAMPLES, SEEDS = 200, 400
X = np.linspace(0.0, 1.0, SAMPLES)
TWO = np.vstack([np.column_stack([X, X**2])] * 2)
"""Two channels that see the same two numbers; a constant is neither."""


def fitted(jacobian: np.ndarray, values: np.ndarray, active: tuple[int, ...] | None = None) -> Optimum:
    """Least squares of a linear model, its truth 1 for every number."""
    measured = jacobian.sum(axis=1) + values
    x = np.linalg.lstsq(jacobian, measured, rcond=None)[0]
    residual = jacobian @ x - measured
    bounds = np.array(active or (0,) * x.size)
    return Optimum(x, 0.5 * float(residual @ residual), jacobian, residual, [1.0], bounds)


def noise(seed: int, size: int) -> np.ndarray:
    return np.random.default_rng([2012, seed]).normal(0.0, 1.0, size)


def within(optimum: Optimum, spread: ErrorModel) -> np.ndarray:
    return np.array(
        [abs(x - 1.0) <= 1.96 * spread.deviation(p) for x, p in zip(optimum.x, influences(optimum), strict=True)]
    )


def test_pulls_are_the_changes_that_samples_make():
    jacobian = np.column_stack([np.ones(SAMPLES), X, X**2])
    values = noise(0, SAMPLES)
    base, moved = fitted(jacobian, values), fitted(jacobian, values + np.eye(SAMPLES)[7])
    assert influences(base)[:, 7] == pytest.approx(moved.x - base.x, rel=1e-6)


def test_a_number_at_its_bound_is_held_for_the_others():
    jacobian = np.column_stack([X, X**2, X**3])
    rows = influences(fitted(jacobian, noise(0, SAMPLES), active=(0, 0, 1)))
    assert rows[:2] == pytest.approx(np.linalg.pinv(jacobian[:, :2]), rel=1e-6)
    assert rows[2] == pytest.approx(np.linalg.pinv(jacobian)[2], rel=1e-6)


def test_a_number_that_is_not_felt_is_infinitely_uncertain_and_spoils_no_other():
    jacobian = np.column_stack([X, np.zeros(SAMPLES), X**2])
    optimum = fitted(jacobian, noise(0, SAMPLES))
    optimum.x[1] = 1.0
    spread = ErrorModel(optimum, [SAMPLES], 1.0)
    rows = influences(optimum)
    assert spread.deviation(rows[1]) == np.inf
    assert spread.factor(rows[1]) == 1.0
    assert rows[[0, 2]] == pytest.approx(np.linalg.pinv(jacobian[:, [0, 2]]), rel=1e-6)


def test_white_noise_is_not_widened_and_has_no_offset():
    optima = [fitted(TWO, noise(seed, 2 * SAMPLES)) for seed in range(SEEDS)]
    spreads = [ErrorModel(optimum, [SAMPLES, SAMPLES], 1.0) for optimum in optima]
    assert [offset for spread in spreads for offset in spread.offsets] == []
    factors = [spread.factor(pull) for spread, o in zip(spreads, optima, strict=True) for pull in influences(o)]
    assert np.mean(np.sqrt(factors)) < 1.05
    covered = np.mean([within(o, s) for o, s in zip(optima, spreads, strict=True)], axis=0)
    assert np.all((covered >= 0.92) & (covered <= 0.98))


def test_an_offset_is_found_with_its_size_and_error():
    truth, found, shifts = 0.8, [], []
    values = np.concatenate([np.full(SAMPLES, truth), np.zeros(SAMPLES)])
    for seed in range(SEEDS):
        optimum = fitted(TWO, values + noise(seed, 2 * SAMPLES))
        offset = next(o for o in ErrorModel(optimum, [SAMPLES, SAMPLES], 1.0).offsets if o.channel == 0)
        assert offset.rows == slice(0, SAMPLES)
        found.append(abs(offset.size - truth) <= 1.96 * offset.error)
        shifts.append(offset.size)
    assert np.mean(shifts) == pytest.approx(truth, abs=0.02)
    assert 0.92 <= np.mean(found) <= 0.98


def test_the_shift_is_the_change_of_the_numbers_with_the_offset_fitted_along():
    values = noise(3, 2 * SAMPLES) + np.concatenate([np.full(SAMPLES, 2.0), np.zeros(SAMPLES)])
    optimum = fitted(TWO, values)
    constant = np.concatenate([np.ones(SAMPLES), np.zeros(SAMPLES)])[:, None]
    along = np.linalg.lstsq(np.hstack([TWO, constant]), TWO.sum(axis=1) + values, rcond=None)[0]
    spread = ErrorModel(optimum, [SAMPLES, SAMPLES], 1.0)
    offset = spread.offsets[0]
    assert offset.size == pytest.approx(along[2], rel=1e-9)
    for pull, alone, both in zip(influences(optimum), optimum.x, along[:2], strict=True):
        with_it, without = (spread.deviation(pull, offsets=each) for each in ((offset,), ()))
        ratio = offset.error / offset.size
        assert np.sqrt(with_it**2 - without**2) == pytest.approx(abs(alone - both) * np.hypot(1.0, ratio), rel=1e-6)


def test_intervals_hold_an_offset_that_noise_alone_does_not():
    values = np.concatenate([np.full(SAMPLES, 1.5), np.zeros(SAMPLES)])
    optima = [fitted(TWO, values + noise(seed, 2 * SAMPLES)) for seed in range(100)]
    spreads = [ErrorModel(o, [SAMPLES, SAMPLES], 1.0) for o in optima]
    assert np.mean([within(o, s) for o, s in zip(optima, spreads, strict=True)]) > 0.95
    plain = [1.96 * np.linalg.norm(influences(o), axis=1) >= abs(o.x - 1.0) for o in optima]
    assert np.mean(plain) < 0.5


def test_an_offset_that_is_free_is_not_counted_again():
    jacobian = np.column_stack([X, np.ones(SAMPLES)])
    assert ErrorModel(fitted(jacobian, 5.0 + noise(1, SAMPLES)), [SAMPLES], 1.0).offsets == []


def test_an_offset_is_no_larger_than_its_sensor_may_be_off():
    """The numbers all but imitate a constant: the little that they leave over of it asks for a large one."""
    nearly = np.column_stack([1.0 + 1e-2 * np.sin(40.0 * X), X])
    optimum = fitted(nearly, 1000.0 + noise(1, SAMPLES))
    (free,) = ErrorModel(optimum, [SAMPLES], 1.0).offsets
    assert free.size == pytest.approx(1000.0, rel=0.1)
    (bounded,) = ErrorModel(optimum, [SAMPLES], 1.0, gauges=[SensorLimits(largest=5.0)]).offsets
    assert (bounded.size, bounded.error, bounded.is_possible) == (5.0, 5.0, False)


def test_misfit_where_a_number_is_determined_widens_its_interval():
    """Five samples see the first number, all others the second; the five are noisier than the mean says."""
    jacobian = np.zeros((SAMPLES, 2))
    jacobian[:5, 0], jacobian[5:, 1] = 1.0, X[5:]
    sigma = np.ones(SAMPLES)
    sigma[:5] = 10.0
    optima = [fitted(jacobian, sigma * noise(seed, SAMPLES)) for seed in range(SEEDS)]
    spreads = [ErrorModel(o, [SAMPLES], max(1.0, float(np.mean(o.residual**2)))) for o in optima]
    covered = np.mean([within(o, s) for o, s in zip(optima, spreads, strict=True)], axis=0)
    # Five samples say little about their own noise: Student with four degrees of freedom leaves 88 % within 1.96.
    assert covered[0] > 0.8
    assert covered[1] >= 0.92
    assert np.mean([s.is_local(influences(o)[0], 1.5) for o, s in zip(optima, spreads, strict=True)]) > 0.9
    assert not any(s.is_local(influences(o)[1], 1.5) for o, s in zip(optima, spreads, strict=True))


def test_misfit_that_lasts_widens_what_it_moves():
    """First-order noise that remembers ten samples, against a slope."""
    covered = []
    for seed in range(SEEDS):
        series, state = noise(seed, SAMPLES) * np.sqrt(1.0 - 0.8**2), 0.0
        for k in range(SAMPLES):
            state = series[k] = 0.8 * state + series[k]
        optimum = fitted(X[:, None], series)
        covered.append(within(optimum, ErrorModel(optimum, [SAMPLES], 1.0))[0])
    assert np.mean(covered) > 0.85


@pytest.mark.parametrize("loss", ["soft_l1", "huber", "cauchy"])
def test_a_robust_loss_counts_an_outlier_less(loss):
    values = noise(5, SAMPLES)
    values[-1] = 100.0
    optimum = fitted(X[:, None], values)
    pull = influences(optimum)[0]
    robust, plain = (ErrorModel(optimum, [SAMPLES], 1.0, each).deviation(pull) for each in (loss, "linear"))
    assert robust < 0.5 * plain


def test_a_prior_counts_as_one_sigma_however_well_it_is_met():
    jacobian = np.vstack([np.zeros((SAMPLES, 1)), [[2.0]]])
    optimum = Optimum(np.ones(1), 0.0, jacobian, np.zeros(SAMPLES + 1), [1.0], np.zeros(1, dtype=np.int64))
    assert ErrorModel(optimum, [SAMPLES], 0.5).deviation(influences(optimum)[0]) == pytest.approx(0.5)


# The band of the model ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["white", "correlated", "offset"])
def test_the_band_of_the_model_is_the_deviation_of_every_sample_of_it(kind):
    values = noise(3, 2 * SAMPLES)
    if kind == "correlated":
        values = np.convolve(np.concatenate([noise(4, 29), values]), np.full(30, 0.4), "valid")
    if kind == "offset":
        values = values + np.concatenate([np.full(SAMPLES, 1.5), np.zeros(SAMPLES)])
    spread = ErrorModel(fitted(TWO, values), [SAMPLES, SAMPLES], 1.3)
    hat = TWO @ np.linalg.pinv(TWO)
    assert spread.model_deviation() == pytest.approx([spread.deviation(row) for row in hat], rel=1e-6)


def test_a_direction_that_no_sample_sees_leaves_the_band_as_it_is():
    three = np.column_stack([TWO, TWO[:, 0] * (1.0 + 1e-9 * np.sin(np.arange(2 * SAMPLES)))])
    values = noise(0, 2 * SAMPLES)
    plain, more = (ErrorModel(fitted(j, values), [SAMPLES, SAMPLES], 1.0).model_deviation() for j in (TWO, three))
    assert np.sum(more**2) == pytest.approx(np.sum(plain**2) + 1.0, rel=0.1)


@pytest.mark.parametrize(("sigmas", "part"), [(1.0, 0.683), (1.96, 0.95)])
def test_bands_hold_the_truth_and_new_samples_as_often_as_they_say(sigmas, part):
    """Pointwise over repeated draws of the noise, the width of 95 % scaled to that of other parts."""
    truth, held, new = TWO.sum(axis=1), [], []
    for seed in range(SEEDS):
        optimum = fitted(TWO, noise(seed, 2 * SAMPLES))
        optimum.sigmas = [1.0, 1.0]
        found = confidence_bands(optimum, ErrorModel(optimum, [SAMPLES, SAMPLES], 1.0))
        model, samples = (np.concatenate(each) * sigmas / 1.96 for each in zip(*found, strict=True))
        off = TWO @ optimum.x - truth
        held.append(np.mean(np.abs(off) <= model))
        new.append(np.mean(np.abs(off - noise(SEEDS + seed, 2 * SAMPLES)) <= samples))
    # Four numbers' worth of independent draws for each fit at the least: 2 SEEDS of them have this spread.
    assert np.mean(held) == pytest.approx(part, abs=3.0 * np.sqrt(part * (1.0 - part) / (2 * SEEDS)))
    assert np.mean(new) == pytest.approx(part, abs=0.01)
