"""Statistics and probabilities of single faults: dense least squares, quantiles of SciPy, hit rates of draws."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize_scalar
from scipy.stats import chi2, norm

from poppet.monitoring.fault_statistics import (
    CEILING,
    SCATTER,
    FaultStatistics,
    chi_square_limit,
    fault_probabilities,
    fault_statistics,
    fits_of_pairs,
    probable_set,
)

ALARMS = np.array([2e-9, 3e4, 5.0, 0.1])
DIRECTIONS = np.array([1, -1, 0, 1])
ROOT = np.random.default_rng(8).normal(size=(4, 4)) * 0.1
COVARIANCE = (ROOT @ ROOT.T) * np.outer(ALARMS, ALARMS)
CHANGE = np.array([1.1, -0.8, 0.4, 0.2]) * ALARMS
BOTH = np.zeros(4, dtype=int)


def statistics_of(
    change: np.ndarray, covariance: np.ndarray, alarms: np.ndarray, directions: np.ndarray, temper: float = 1.0
) -> FaultStatistics:
    """Return the statistics of one estimate."""
    information = np.linalg.inv(covariance)
    return fault_statistics((information @ change)[None], information[None], alarms, directions, temper)


def statistics() -> FaultStatistics:
    return statistics_of(CHANGE, COVARIANCE, ALARMS, DIRECTIONS)


def test_each_rest_is_the_least_square_over_the_size_of_one_fault() -> None:
    s, inverse = statistics(), np.linalg.inv(COVARIANCE / np.outer(ALARMS, ALARMS) + SCATTER**2 * np.eye(4))
    for k in range(4):

        def square(size: float, k: int = k) -> float:
            rest = CHANGE / ALARMS - size * np.eye(4)[k]
            return float(rest @ inverse @ rest)

        least = minimize_scalar(square, bracket=(-2.0, 2.0))
        assert s.rests[k] == pytest.approx(least.fun, rel=1e-3)
        assert s.sizes[k] == pytest.approx(least.x, rel=1e-3)
        # The evidence is the size in standard deviations, in the direction of the fault.
        z = least.x * np.sqrt(inverse[k, k])
        assert s.z[k] == pytest.approx(DIRECTIONS[k] * z if DIRECTIONS[k] else abs(z), rel=1e-3)
    assert s.joint == pytest.approx(square(0.0), rel=1e-3)


def test_rests_of_pairs_are_least_squares_over_two_sizes() -> None:
    inverse, changes = np.linalg.inv(COVARIANCE / np.outer(ALARMS, ALARMS) + SCATTER**2 * np.eye(4)), CHANGE / ALARMS
    root = np.linalg.cholesky(inverse).T
    pairs = fits_of_pairs(statistics(), BOTH)
    assert len(pairs) == 6
    for pair, fit in pairs.items():
        sizes, squares, *_ = np.linalg.lstsq(root[:, pair], root @ changes, rcond=None)
        assert fit.rest == pytest.approx(float(squares[0]), rel=1e-2)
        assert fit.sizes == pytest.approx(sizes, rel=1e-2)


def test_each_fault_has_its_best_onset() -> None:
    """Two onsets with independent evidence, and an unused one."""
    information = np.array([np.diag([400.0, 100.0]), np.diag([100.0, 400.0]), np.zeros((2, 2))])
    sizes = np.array([[2.0, 0.0], [0.0, 1.0], [0.0, 0.0]])
    evidence = np.einsum("oij,oj->oi", information, sizes)
    s = fault_statistics(evidence, information, np.ones(2), np.ones(2))
    assert s.onsets.tolist() == [0, 1]
    assert s.joint_onset == 0
    assert s.sizes == pytest.approx([2.0, 1.0], rel=1e-3)
    sd = np.sqrt(1.0 / 400.0 + SCATTER**2)
    assert s.z == pytest.approx([2.0 / sd, 1.0 / sd], rel=1e-3)
    assert s.rests == pytest.approx([0.0, 3.0 / sd**2], abs=0.1)


def test_pairs_with_a_wrong_sign_are_omitted() -> None:
    change = np.array([1.0, 1.0, 0.0, 1.0]) * ALARMS
    narrow = 1e-4 * np.diag(ALARMS**2)
    pairs = fits_of_pairs(statistics_of(change, narrow, ALARMS, DIRECTIONS), DIRECTIONS)
    # Fault 1 only goes down.
    assert (0, 3) in pairs
    assert not any(1 in pair for pair in pairs)


def test_temper_divides_the_evidence() -> None:
    covariance = np.diag(ALARMS**2)  # so large that the scatter of healthy plants does not matter
    plain = statistics_of(CHANGE, covariance, ALARMS, DIRECTIONS)
    tempered = statistics_of(CHANGE, covariance, ALARMS, DIRECTIONS, 4.0)
    assert tempered.joint == pytest.approx(plain.joint / 4.0, rel=1e-2)


@pytest.mark.parametrize("freedom", [1, 2, 5, 11])
@pytest.mark.parametrize("quantile", [3.09, 3.719])
def test_limits_agree_with_the_chi_square_distribution(freedom: int, quantile: float) -> None:
    assert chi_square_limit(freedom, quantile) == pytest.approx(chi2.isf(norm.sf(quantile), freedom), rel=0.08)
    assert chi_square_limit(0) == 0.0


def test_probabilities_without_evidence_are_below_the_prior() -> None:
    probabilities = fault_probabilities(np.zeros(4), 0.0, np.zeros(4))
    assert 0.0 < np.sum(probabilities) < 2e-3


def test_evidence_of_any_size_leaves_room_for_an_unknown_cause() -> None:
    first, second = fault_probabilities(np.array([1e8, -3.0]), 1e16, np.array([0.0, 1e16]))
    assert 0.98 < first < CEILING
    assert second == 0.0
    # No fault explains the evidence.
    assert np.all(fault_probabilities(np.array([30.0, 30.0]), 1e3, np.array([500.0, 500.0])) < 1e-9)


def test_set_of_95_percent_contains_as_few_faults_as_possible() -> None:
    assert probable_set(np.array([0.3, 0.0, 0.6, 0.04])) == [2, 0]
    assert probable_set(np.array([0.3, 0.0, 0.599, 0.0501])) == [2, 0, 3]
    assert probable_set(np.array([0.0, 0.9])) == [1]
    assert probable_set(np.zeros(2)) == []


def test_no_probability_exceeds_its_hit_rate_by_more_than_five_percent() -> None:
    """Draws of single faults whose effects are 10 to 30 degrees apart, with sizes over a decade; half are healthy."""
    generator = np.random.default_rng(12)
    effects = generator.normal(size=(6, 4)) * 0.3 + np.array([1.0, 1.0, 0.0, 0.0, 0.0, 0.0])[:, np.newaxis]
    effects *= 6.0 / np.linalg.norm(effects, axis=0)
    covariance = np.linalg.inv(effects.T @ effects)
    stated, hits, contained = [], [], []
    for k in range(4000):
        truth = np.zeros(4)
        fault = int(generator.integers(4)) if k % 2 else -1
        if fault >= 0:
            truth[fault] = 10.0 ** generator.uniform(-0.3, 0.7)
        change = truth + SCATTER * generator.normal(size=4) + generator.multivariate_normal(np.zeros(4), covariance)
        s = statistics_of(change, covariance, np.ones(4), np.ones(4))
        probabilities = fault_probabilities(s.z, s.joint, s.rests)
        stated.append(probabilities)
        hits.append(np.arange(4) == fault)
        if np.max(s.z) > 5.0:
            contained.append(fault in probable_set(probabilities))
    flat, hit = np.concatenate(stated), np.concatenate(hits)
    for low in np.arange(0.1, 1.0, 0.1):
        members = (flat >= low) & (flat < low + 0.1)
        assert np.mean(flat[members]) <= np.mean(hit[members]) + 0.05
        assert np.count_nonzero(members) > 20
    assert np.mean(contained) >= 0.93
