"""Distributions: quantiles compared with SciPy, truncation, probability of invalid values."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from circuits_of_ensembles import METRICS, tank
from poppet.core.errors import OutOfRangeError
from poppet.ensemble.distributions import Distribution
from poppet.ensemble.ensemble_plan import read_plan
from poppet.ensemble.sampling import uniform
from refusals import refused

REFERENCES = {
    "normal": (Distribution("normal", {"mean": 3.0, "sigma": 0.5}), stats.norm(3.0, 0.5)),
    "lognormal": (Distribution("lognormal", {"median": 3.0, "log_sigma": 0.5}), stats.lognorm(0.5, scale=3.0)),
    "uniform": (Distribution("uniform", {"low": 1.0, "high": 3.0}), stats.uniform(1.0, 2.0)),
    "triangular": (
        Distribution("triangular", {"low": 1.0, "mode": 1.5, "high": 3.0}),
        stats.triang(0.25, loc=1.0, scale=2.0),
    ),
    "cut": (
        Distribution("normal", {"mean": 3.0, "sigma": 0.5}, 2.5, 4.5),
        stats.truncnorm(-1.0, 3.0, loc=3.0, scale=0.5),
    ),
    "corner": (
        Distribution("triangular", {"low": 1.0, "mode": 1.0, "high": 3.0}),
        stats.triang(0.0, loc=1.0, scale=2.0),
    ),
}


@pytest.mark.parametrize("name", REFERENCES)
def test_quantiles_equal_those_of_scipy(name):
    distribution, reference = REFERENCES[name]
    u = np.linspace(1e-6, 1.0 - 1e-6, 501)
    np.testing.assert_allclose(distribution.quantile(u), reference.ppf(u), rtol=1e-9)
    assert [distribution.below(x) for x in (1.3, 2.6, 2.9)] == pytest.approx(reference.cdf([1.3, 2.6, 2.9]), rel=1e-9)


@pytest.mark.parametrize("name", REFERENCES)
def test_samples_pass_a_chi_square_test(name):
    distribution, reference = REFERENCES[name]
    sample = distribution.quantile(uniform(17, "random", 1, 0, 20_000)[:, 0])
    counts = np.histogram(sample, bins=reference.ppf(np.linspace(0.0, 1.0, 41)))[0]
    assert counts.sum() == 20_000
    assert 1e-3 < stats.chisquare(counts).pvalue < 1.0 - 1e-3


def read(numbers, **fields):
    circuit = tank("")
    return read_plan(
        circuit, {"runs": 10, "parameters": numbers, "metrics": METRICS, **fields}, {}, circuit.origin.folder
    )


def test_probable_invalid_values_are_rejected_with_their_probability():
    with refused("ensemble.impossible", "ensemble.parameters.tank.volume", kind=OutOfRangeError) as caught:
        read({"tank.volume": {"distribution": "normal", "relative_sigma": 0.25}})
    assert caught.value.facts["probability"] == pytest.approx(stats.norm.cdf(-4.0), rel=1e-6)
    plan = read({"tank.volume": {"distribution": "normal", "relative_sigma": 0.25, "low": "1 l"}})
    assert plan.alone["tank.volume"].quantile(np.array([1e-9])) == pytest.approx(1e-3, rel=1e-6)


def test_relative_spread_refers_to_the_given_mean():
    """The mean replaces the value in the circuit; for a gauge pressure, the gauge value counts."""
    plan = read({"tank.volume": {"distribution": "normal", "mean": "20 l", "relative_sigma": 0.02}})
    assert plan.alone["tank.volume"].numbers == pytest.approx({"mean": 20e-3, "sigma": 0.4e-3})
    plan = read({"tank.initial_pressure": {"distribution": "normal", "mean": "4 bar g", "relative_sigma": 0.02}})
    numbers = plan.alone["tank.initial_pressure"].numbers
    assert numbers == pytest.approx({"mean": 4e5 + plan.circuit.surroundings.pressure, "sigma": 0.08e5})


def test_ratio_above_one_is_rejected():
    with refused("ensemble.impossible", "ensemble.parameters.hole.critical_ratio") as caught:
        read({"hole.critical_ratio": {"distribution": "uniform", "low": 0.2, "high": 1.2}})
    assert caught.value.facts["probability"] == pytest.approx(0.2, rel=1e-3)


def test_relative_spread_of_a_gauge_pressure_refers_to_the_gauge_value():
    circuit = tank("").with_values({"tank.initial_pressure": "2 bar g"})
    fields = {"runs": 1, "metrics": METRICS}
    parameters = {"tank.initial_pressure": {"distribution": "uniform", "relative_range": 0.1}}
    plan = read_plan(circuit, {**fields, "parameters": parameters}, {}, circuit.origin.folder)
    assert plan.alone["tank.initial_pressure"].numbers == {"low": pytest.approx(2.8e5), "high": pytest.approx(3.2e5)}
    parameters = {"tank.initial_pressure": {"distribution": "normal", "mean": "2.5 bar g", "sigma": "0.1 bar"}}
    plan = read_plan(circuit, {**fields, "parameters": parameters}, {}, circuit.origin.folder)
    assert plan.alone["tank.initial_pressure"].numbers == {"mean": pytest.approx(3.5e5), "sigma": pytest.approx(1e4)}


@pytest.mark.parametrize(
    ("code", "fields"),
    [
        ("fields.not_an_option", {"distribution": "gauss"}),
        ("fields.missing", {"distribution": "normal"}),
        ("ensemble.given_twice", {"distribution": "normal", "relative_sigma": 0.1, "sigma": "1 l"}),
        ("ensemble.no_spread", {"distribution": "normal", "sigma": "0 l"}),
        ("ensemble.limits", {"distribution": "triangular", "low": "3 l", "high": "5 l"}),
        ("fields.unknown", {"distribution": "uniform", "relative_rang": 0.1}),
        ("quantity.other_quantity", {"distribution": "uniform", "low": "1 bar", "high": "2 l"}),
        ("fields.no_table", 0.2),
    ],
)
def test_invalid_distributions_are_rejected(code, fields):
    with refused(code):
        read({"tank.volume": fields})
