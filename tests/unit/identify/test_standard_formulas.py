"""Tests of the formulas of ISO 6358-1: exact points, and uncertainties compared with Monte Carlo."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.identify.flow.points import FlowPoints, Instrument
from poppet.identify.flow.standard_formulas import (
    conductance_uncertainty,
    critical_ratio_uncertainty,
    evaluate_by_standard,
    standard_uncertainties,
)
from poppet.iso6358 import effective_conductance, mass_flow_rate

LAW = {"sonic_conductance": 2e-8, "critical_ratio": 0.35}


def bench(ratios, cracking_pressure=0.0, subsonic_index=0.5, **uncertainties):
    ratios = np.asarray(ratios)
    flow = mass_flow_rate(
        7e5,
        7e5 * ratios,
        300.0,
        subsonic_index=subsonic_index,
        cracking_pressure=cracking_pressure,
        laminar_ratio=1 - 1e-9,
        **LAW,
    )
    return FlowPoints(flow, 7e5, 7e5 * ratios, 300.0, **uncertainties)


RATIOS = [0.1, 0.2, 0.3, 0.5, 0.6, 0.7, 0.8, 0.9]


def test_exact_points_give_exact_results():
    evaluation = evaluate_by_standard(bench(RATIOS))
    assert evaluation.saturated == (0, 1, 2)
    assert evaluation.subsonic == (3, 4, 5, 6, 7)
    assert evaluation.numbers == pytest.approx([2e-8, 0.35, 0.5, 0.0], rel=1e-12)


def test_stated_index_and_cracking_pressure_are_used():
    points = bench(RATIOS, cracking_pressure=2e4, subsonic_index=0.6)
    assert evaluate_by_standard(points, 0.6, 2e4).critical_ratio == pytest.approx(0.35, rel=1e-12)
    assert abs(evaluate_by_standard(points).critical_ratio - 0.35) > 0.02


@pytest.mark.parametrize(("index", "cracking"), [(0.6, 0.0), (0.5, 2e4), (0.7, 1e4)])
def test_free_parameters_are_fitted(index, cracking):
    points = bench(RATIOS, cracking_pressure=cracking, subsonic_index=index)
    evaluation = evaluate_by_standard(points, "free", "free")
    assert evaluation.numbers == pytest.approx([2e-8, 0.35, index, cracking], rel=1e-5, abs=1.0)


def test_closed_points_and_too_few_subsonic_points_are_omitted():
    evaluation = evaluate_by_standard(bench([0.1, 0.2, 0.8, 1.0]), "free")
    assert evaluation.subsonic == (2,)
    assert np.isnan(evaluation.critical_ratio)


def test_order_of_the_points_does_not_matter():
    points = bench(RATIOS)
    shuffled = bench(RATIOS[::-1])
    assert evaluate_by_standard(shuffled).numbers == pytest.approx(evaluate_by_standard(points).numbers, rel=1e-14)
    assert evaluate_by_standard(shuffled).saturated == (7, 6, 5)


def test_uncertainty_of_one_conductance_against_monte_carlo():
    generator = np.random.default_rng(2)
    q, p, t = 1.0 + np.array([[0.004], [0.003], [0.008]]) * generator.standard_normal((3, 100_000))
    spread = np.std(effective_conductance(0.01 * q, 7e5 * p, 300.0 * t)) / effective_conductance(0.01, 7e5, 300.0)
    # The relative standard error of a standard deviation from 1e5 samples is 1/sqrt(2e5) = 0.0022.
    assert conductance_uncertainty(0.004, 0.003, 0.008) == pytest.approx(spread, rel=0.01)


@pytest.mark.parametrize("index", [0.5, 0.7])
@pytest.mark.parametrize("ratio", [0.5, 0.7, 0.9])
def test_uncertainty_of_one_critical_ratio_against_monte_carlo(ratio, index):
    generator = np.random.default_rng(3)
    b, u_ratio, u_flow = 0.3, 1e-4, 2e-4
    phi = (1.0 - ((ratio - b) / (1.0 - b)) ** 2) ** index
    r, f = ratio + u_ratio * generator.standard_normal(100_000), phi + u_flow * generator.standard_normal(100_000)
    s = np.sqrt(1.0 - f ** (1.0 / index))
    spread = np.std((r - s) / (1.0 - s))
    assert critical_ratio_uncertainty(ratio, phi, u_ratio, u_flow, index) == pytest.approx(spread, rel=0.015)


def test_points_near_one_and_near_choking_have_the_largest_uncertainty():
    b, ratio = 0.3, np.array([0.32, 0.6, 0.8, 0.95, 0.995])
    phi = np.sqrt(1.0 - ((ratio - b) / (1.0 - b)) ** 2)
    spread = critical_ratio_uncertainty(ratio, phi, 1e-3, 1e-3)
    assert spread[0] > 3.0 * spread[1]
    assert spread[-1] > spread[-2] > spread[2]


@pytest.mark.parametrize(("draws", "tolerance"), [(400, 0.12), pytest.param(2000, 0.06, marks=pytest.mark.slow)])
def test_combined_uncertainty_against_monte_carlo(draws, tolerance):
    meters = {
        "u_mass_flow_rate": Instrument(relative=0.001, calibration=0.004),
        "u_pressure_1": Instrument(absolute=500.0, offset=800.0),
        "u_pressure_2": Instrument(absolute=500.0, offset=800.0),
        "u_temperature_1": Instrument(offset=1.0),
    }
    exact = bench([0.05, 0.1, 0.2, 0.55, 0.65, 0.75, 0.85, 0.92], **meters)  # the plateau ends clearly
    evaluation = evaluate_by_standard(exact)
    stated = standard_uncertainties(exact, evaluation)[:2]
    generator = np.random.default_rng(4)
    results = []
    for _ in range(draws):
        noise, common = generator.standard_normal((3, 8)), generator.standard_normal(4)
        q = exact.mass_flow_rate * (1.0 + 0.001 * noise[0] + 0.004 * common[0])
        p_1 = exact.pressure_1 + 500.0 * noise[1] + 800.0 * common[1]
        p_2 = exact.pressure_2 + 500.0 * noise[2] + 800.0 * common[2]
        noisy = evaluate_by_standard(FlowPoints(q, p_1, p_2, 300.0 + common[3], **meters))
        results.append(noisy.numbers[:2])
    # The standard deviation of 2000 samples has a relative standard error of 1.6 %; the formulas are of first order.
    assert stated == pytest.approx(np.std(results, axis=0), rel=tolerance)
