"""Error of the fit to a flow bench versus the noise of the readings, which is of first order."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.identify.flow.identify_flow import identify_flow
from poppet.identify.flow.points import FlowPoints
from poppet.iso6358 import mass_flow_rate

NOISE = np.array([1e-5, 1e-4, 1e-3, 4e-3])
LAW = {"sonic_conductance": 2e-8, "critical_ratio": 0.35}


def fit_errors(noise, seed):
    """Return the relative errors of C and b for scaled noise."""
    generator = np.random.default_rng(seed)
    p_2 = 7e5 * np.linspace(0.05, 0.95, 20)
    q = mass_flow_rate(7e5, p_2, 293.15, laminar_ratio=1 - 1e-9, **LAW)
    errors = generator.standard_normal((2, 20))
    points = FlowPoints(q + noise * np.max(q) * errors[0], 7e5, p_2 * (1.0 + noise * errors[1]), 293.15)
    estimates = identify_flow(points).parameters
    return [estimates[name].value / value - 1.0 for name, value in LAW.items()]


@pytest.mark.parametrize("number", [0, 1])
def test_error_is_first_order_in_the_noise(number):
    rms = [np.sqrt(np.mean([fit_errors(noise, seed)[number] ** 2 for seed in range(8)])) for noise in NOISE]
    slopes = np.diff(np.log(rms)) / np.diff(np.log(NOISE))
    assert np.all(np.abs(slopes - 1.0) < 0.05)


def test_exact_readings_give_no_error():
    assert np.max(np.abs(fit_errors(0.0, 0))) < 1e-9
