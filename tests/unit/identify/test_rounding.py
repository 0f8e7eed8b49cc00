"""What the steps of a coarse gauge do to numbers, against many recordings with their steps elsewhere."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.identify.fit.residuals import staircase
from poppet.identify.fit.search import Optimum
from poppet.identify.fit.statistics import ErrorModel, SensorLimits, influences

SAMPLES = 400
TIME = np.linspace(0.0, 1.0, SAMPLES)
COLUMNS = np.column_stack([np.exp(-TIME / 0.1), 1.0 + 0.3 * TIME])
"""A fast fall, then a slow drift, as of a tank whose valve closes."""
TRUTH = np.array([40.0, 10.0])


def fitted(noise: float, seed: int) -> tuple[Optimum, np.ndarray]:
    """A linear fit of a recording in steps of 1, their place drawn; the second is what the model makes of it."""
    generator = np.random.default_rng([26, seed])
    place = generator.uniform()
    measured = np.round(COLUMNS @ TRUTH + generator.normal(0.0, noise, SAMPLES) + place) - place
    x = np.linalg.lstsq(COLUMNS, measured, rcond=None)[0]
    residual = COLUMNS @ x - measured
    sigma = float(np.sqrt(np.mean(residual**2)))
    optimum = Optimum(x, 0.0, COLUMNS / sigma, residual / sigma, [sigma], np.zeros(2, dtype=np.int64))
    return optimum, measured + residual


def scores(noise: float, is_told: bool) -> np.ndarray:
    """Root mean square over many recordings of error over sigma, for each number."""
    found = []
    for seed in range(300):
        optimum, model = fitted(noise, seed)
        sigma = optimum.sigmas[0]
        gauge = SensorLimits(staircase(model / sigma, 1.0 / sigma, noise / sigma) if is_told else None)
        spread = ErrorModel(optimum, [SAMPLES], 1.0, gauges=[gauge])
        errors = [spread.deviation(pull) for pull in influences(optimum)]
        found.append((optimum.x - TRUTH) / errors)
    return np.sqrt(np.mean(np.square(found), axis=0))


def test_steps_of_a_value_that_rests_are_one_error_of_all_samples() -> None:
    """The q/sqrt(12) of the GUM, whatever the number of samples."""
    steps = staircase(np.full(50, 3.21), 2.0, 0.0)
    assert steps is not None
    assert steps.excess(np.full(50, 0.02)) == pytest.approx(2.0**2 / 12.0 * (1.0 - 1.0 / 50.0), rel=0.03)


def test_noise_of_half_a_step_hides_the_steps() -> None:
    assert staircase(TIME, 0.1, 0.061) is None
    weak, strong = (staircase(TIME, 0.1, noise) for noise in (0.03, 0.0))
    assert weak is not None
    assert strong is not None
    assert weak.square < 0.05 * strong.square


@pytest.mark.parametrize("noise", [0.05, 0.15, 0.3])
def test_intervals_hold_the_steps_of_a_slow_drift(noise: float) -> None:
    assert scores(noise, is_told=True) == pytest.approx([1.0, 1.0], abs=0.2)


def test_without_their_steps_the_intervals_would_be_too_narrow() -> None:
    assert np.max(scores(0.15, is_told=False)) > 1.3
