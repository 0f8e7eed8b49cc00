"""Effect of the resolution of a sensor on estimates, against many recordings with shifted steps."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.identify.fit.residuals import staircase
from poppet.identify.fit.search import Optimum
from poppet.identify.fit.statistics import ErrorModel, SensorLimits, influences

SAMPLES = 400
TIME = np.linspace(0.0, 1.0, SAMPLES)
COLUMNS = np.column_stack([np.exp(-TIME / 0.1), 1.0 + 0.3 * TIME])
"""Fast fall and slow drift, as of a tank whose valve closes."""
TRUTH = np.array([40.0, 10.0])


def fit_recording(noise: float, seed: int) -> tuple[Optimum, np.ndarray]:
    """Return the linear fit of a recording with steps of 1 at a random offset, and the modelled series."""
    generator = np.random.default_rng([26, seed])
    offset = generator.uniform()
    measured = np.round(COLUMNS @ TRUTH + generator.normal(0.0, noise, SAMPLES) + offset) - offset
    x = np.linalg.lstsq(COLUMNS, measured, rcond=None)[0]
    residual = COLUMNS @ x - measured
    sigma = float(np.sqrt(np.mean(residual**2)))
    optimum = Optimum(x, 0.0, COLUMNS / sigma, residual / sigma, [sigma], np.zeros(2, dtype=np.int64))
    return optimum, measured + residual


def rms_of_normalised_errors(noise: float, is_told: bool) -> np.ndarray:
    """Return the root mean square of error over standard error, over many recordings, for each parameter."""
    normalised_errors = []
    for seed in range(300):
        optimum, model = fit_recording(noise, seed)
        sigma = optimum.sigmas[0]
        gauge = SensorLimits(staircase(model / sigma, 1.0 / sigma, noise / sigma) if is_told else None)
        spread = ErrorModel(optimum, [SAMPLES], 1.0, gauges=[gauge])
        errors = [spread.deviation(pull) for pull in influences(optimum)]
        normalised_errors.append((optimum.x - TRUTH) / errors)
    return np.sqrt(np.mean(np.square(normalised_errors), axis=0))


def test_rounding_of_a_constant_is_one_common_error() -> None:
    """The error is q/sqrt(12) of the GUM, independent of the number of samples."""
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
def test_intervals_contain_rounding_of_a_slow_drift(noise: float) -> None:
    assert rms_of_normalised_errors(noise, is_told=True) == pytest.approx([1.0, 1.0], abs=0.2)


def test_intervals_without_rounding_are_too_narrow() -> None:
    assert np.max(rms_of_normalised_errors(0.15, is_told=False)) > 1.3
