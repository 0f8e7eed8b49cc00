"""The bank of onsets against differences of two filters, and gates that let lasting changes pass."""

from __future__ import annotations

import numpy as np
import pytest

from estimators import estimator_of
from poppet import Chamber, Circuit, Orifice
from poppet.engine.estimator_call import EstimatorCall
from poppet.engine.problem import Outcome

FREE = ["leak.sonic_conductance", "use.sonic_conductance", "tank.wall_conductance"]
SIZES = np.array([1e-10, 1e-9, 2.0])


def tank(onsets: int, faults: int) -> EstimatorCall:
    circuit = Circuit(
        {
            "tank": Chamber(volume=0.01, thermal="energy", wall_conductance=8.0, initial_pressure=6e5),
            "use": Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3),
            "leak": Orifice(from_="tank", to="ambient", sonic_conductance=2e-10, critical_ratio=0.3),
        }
    )
    call = estimator_of(circuit, FREE, ["tank.pressure"], onsets=onsets, faults=faults)
    n = call.mean.size - len(FREE)
    call.covariance[:] = 0.0
    np.fill_diagonal(call.covariance[:n, :n], (1e-3 * call.mean[:n]) ** 2)
    np.fill_diagonal(call.covariance[n:, n:], SIZES**2)
    call.noise[:] = 500.0**2
    # A limit would make the filter nonlinear.
    call.low[:], call.high[:] = -np.inf, np.inf
    return call


def run(call: EstimatorCall, readings: np.ndarray, onset: int, step: np.ndarray) -> tuple[list[float], list[float]]:
    """Innovations and their deviations; at the sample `onset`, the estimate misses a step of the free numbers."""
    innovations, deviations = [], []
    for k, reading in enumerate(readings):
        if k == onset:
            call.mean[-len(FREE) :] -= step
            if call.numerators.size:
                call.renew(1)
        call.readings[0] = reading
        assert call.update(0.1) is Outcome.DONE
        innovations.append(float(call.innovations[0]))
        deviations.append(float(call.deviations[0]))
    return innovations, deviations


@pytest.fixture(scope="module")
def readings() -> np.ndarray:
    """Readings so near to the expected ones that the gains do not depend on the step."""
    generator, call, values = np.random.default_rng(3), tank(0, 0), []
    for k in range(100):
        call.readings[0] = np.nan
        assert call.update(0.1) is Outcome.DONE
        call.readings[0] = np.nan if 60 <= k < 63 else call.expected[0] + generator.normal(0.0, 0.5)
        assert call.correct() is Outcome.DONE
        values.append(float(call.readings[0]))
    return np.array(values)


def test_signatures_and_evidence_are_the_differences_of_two_filters(readings: np.ndarray) -> None:
    onset, bank = 30, tank(3, 2)
    innovations, deviations = run(bank, readings, onset, np.zeros(3))
    effects = []
    for fault in range(2):
        # The same filter, with an estimate that misses a small step.
        step = 1e-5 * SIZES * (np.arange(3) == fault)
        one, other = tank(0, 0), tank(0, 0)
        difference = np.array(run(other, readings, onset, step)[0]) - run(one, readings, onset, np.zeros(3))[0]
        effects.append(difference[onset:] / step[fault])
        expected = (one.mean - other.mean) / step[fault]
        assert bank.signatures[:, 2 + fault] == pytest.approx(expected, rel=2e-3, abs=1e-6 * abs(expected).max())
    h, s = np.array(effects), np.array(deviations[onset:]) ** 2
    v = np.array(innovations[onset:])
    seen = np.isfinite(v)
    assert seen.sum() == readings.size - onset - 3
    h, s, v = h[:, seen], s[seen], v[seen]
    assert bank.numerators[1] == pytest.approx((h * v / s).sum(axis=1), rel=5e-3)
    assert bank.gram[1] == pytest.approx((h / s) @ h.T, rel=5e-3)
    # Other onsets have not begun.
    assert not bank.gram[[0, 2]].any()
    assert not bank.signatures[:, [0, 1, 4, 5]].any()


def test_the_bank_does_not_change_the_filter(readings: np.ndarray) -> None:
    one, other = tank(0, 0), tank(3, 2)
    run(one, readings, 30, np.zeros(3))
    run(other, readings, 30, np.zeros(3))
    assert np.array_equal(one.mean, other.mean)
    assert np.array_equal(one.covariance, other.covariance)


def test_a_failed_prediction_leaves_the_bank_unchanged(readings: np.ndarray) -> None:
    call = tank(3, 2)
    run(call, readings[:40], 30, np.zeros(3))
    before = call.signatures.copy(), call.numerators.copy(), call.gram.copy()
    assert call.update(-1.0) is not Outcome.DONE
    assert all(np.array_equal(a, b) for a, b in zip(before, (call.signatures, call.numerators, call.gram), strict=True))


def test_the_third_reading_on_one_side_of_the_gate_is_used() -> None:
    call, used, rejected = tank(0, 0), [], []
    call.gates[:] = 10.8
    for offset in (0.0, 1.0, 0.0, 1.0, -1.0, -1.0, np.nan, -1.0, -1.0, 0.0, -1.0):
        # Relative to the expected reading, in deviations far outside the gate.
        assert call.advance(1e-3) is Outcome.DONE
        call.readings[0] = np.nan
        call.correct()
        call.readings[0] = call.expected[0] + 10.0 * offset * call.deviations[0]
        if np.isfinite(offset):
            assert call.correct() is Outcome.DONE
        used.append(float(call.used[0]))
        rejected.append(float(call.rejected[0]))
    assert used == [1, -1, 1, -1, -1, -1, 0, 1, 1, 1, -1]
    assert rejected == [0, 1, 0, 1, -1, -2, -2, -2, -2, 0, -1]


def test_an_outlier_among_lasting_changes_is_rejected() -> None:
    call, used = tank(0, 0), []
    call.gates[:] = 10.8
    for deviations in (10.0, 10.0, 10.0, 90.0, 10.0, 10.0):
        assert call.advance(1e-3) is Outcome.DONE
        # The noise is the largest part of the deviation.
        call.covariance[:] = 1e-6 * call.covariance
        call.readings[0] = np.nan
        call.correct()
        call.readings[0] = call.expected[0] + deviations * 500.0
        assert call.correct() is Outcome.DONE
        used.append(float(call.used[0]))
    # After the outlier, the next reading has nothing with which it agrees.
    assert used == [-1, -1, 1, -1, -1, 1]
