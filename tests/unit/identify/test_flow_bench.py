"""Tests of `identify flow`: coverage of intervals, parameters that are not determined, invalid readings."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import binom

from poppet.core.errors import InputErrors
from poppet.identify.flow.identify_flow import identify_flow
from poppet.identify.flow.points import FlowPoints, Instrument
from poppet.identify.result import read_result
from poppet.iso6358 import mass_flow_rate
from poppet.timeseries.recording import Recording
from refusals import refused

EXACT = 1.0 - 1e-9  # law of the standard, without a regularised zone
METERS = {
    "u_mass_flow_rate": Instrument(relative=0.001, calibration=0.003),
    "u_pressure_1": Instrument(absolute=500.0, offset=500.0),
    "u_pressure_2": Instrument(absolute=500.0, offset=500.0),
}


def law_flow(pressure_1, pressure_2, conductance=2e-8, ratio=0.3, index=0.5, cracking=0.0):
    return mass_flow_rate(
        pressure_1,
        pressure_2,
        293.15,
        sonic_conductance=conductance,
        critical_ratio=ratio,
        subsonic_index=index,
        cracking_pressure=cracking,
        laminar_ratio=EXACT,
    )


def bench(ratios, *, pressure_1=7e5, noise=0.001, seed=1, meters=METERS, shift=0.0, **law):
    """Return points at pressure ratios; `shift` is an error of both pressures."""
    ratios = np.asarray(ratios, dtype=float)
    p_1 = np.broadcast_to(np.asarray(pressure_1, dtype=float), ratios.shape)
    q = law_flow(p_1, ratios * p_1, **law)
    q = q * (1.0 + noise * np.random.default_rng(seed).standard_normal(q.size))
    return FlowPoints(q, p_1 + shift, ratios * p_1 + shift, 293.15, **meters)


@cache
def plain_result(lowest, highest, count):
    """Return the result of a bench that several tests share."""
    return identify_flow(bench(np.linspace(lowest, highest, count)))


def has_finding(result, text):
    return any(text in sentence for sentence in result.findings)


# Synthetic truth


def random_bench(seed, *, scatter_stated=True, index=0.5, cracking=0.0):
    """Return true parameters and points of a random bench.

    The noise is 0.1 % of full scale in the flow and 0.05 % of 10 bar in the pressures. The instruments also have
    calibration errors and offsets.
    """
    g = np.random.default_rng(seed)
    truth = {"sonic_conductance": 10.0 ** g.uniform(-10, -7), "critical_ratio": g.uniform(0.1, 0.6)}
    truth |= {"subsonic_index": index, "cracking_pressure": cracking}
    n = int(g.integers(12, 31))
    ratios = np.linspace(0.05, 0.98, n)
    p_1 = 7e5 * (1.0 + 0.01 * g.standard_normal(n))
    q = law_flow(p_1, ratios * p_1, truth["sonic_conductance"], truth["critical_ratio"], index, cracking)
    full_scale = truth["sonic_conductance"] * 1.185 * 7e5
    calibration, offset, noise = 0.003, 300.0, 500.0
    measured = q * (1.0 + calibration * g.standard_normal()) + 0.001 * full_scale * g.standard_normal(n)
    shifts = offset * g.standard_normal(2)
    points = FlowPoints(
        measured,
        p_1 + noise * g.standard_normal(n) + shifts[0],
        ratios * p_1 + noise * g.standard_normal(n) + shifts[1],
        293.15,
        u_mass_flow_rate=Instrument(absolute=0.001 * full_scale * scatter_stated, calibration=calibration),
        u_pressure_1=Instrument(absolute=noise, offset=offset),
        u_pressure_2=Instrument(absolute=noise, offset=offset),
    )
    return truth, points


def study_benches(seeds, scatter_stated=True, index=0.5, cracking=0.0, **free):
    """Return the errors of the free parameters, and masks of the intervals that cover the truth, by name."""
    errors, covered = {}, {}
    for seed in seeds:
        truth, points = random_bench(seed, scatter_stated=scatter_stated, index=index, cracking=cracking)
        for name, e in identify_flow(points, **free).parameters.items():
            errors.setdefault(name, []).append(e.value - truth[name])
            covered.setdefault(name, []).append(e.low <= truth[name] <= e.high)
            if name == "sonic_conductance":
                errors[name][-1] /= truth[name]
    return {name: np.abs(e) for name, e in errors.items()}, {name: np.array(c) for name, c in covered.items()}


def is_covered_often_enough(covered, count):
    """Return True if the coverage agrees with 95 %; the probability of a false alarm is 1e-4."""
    return np.sum(covered) >= binom.ppf(1e-4, count, 0.95)


def test_intervals_of_benches_cover_the_truth():
    errors, covered = study_benches(range(10))
    assert np.median(errors["sonic_conductance"]) < 0.005
    assert np.median(errors["critical_ratio"]) < 0.02
    assert is_covered_often_enough(covered["sonic_conductance"], 10)
    assert is_covered_often_enough(covered["critical_ratio"], 10)


@pytest.mark.slow
@pytest.mark.parametrize("scatter_stated", [True, False])
def test_coverage_of_five_hundred_benches(scatter_stated):
    errors, covered = study_benches(range(500), scatter_stated)
    assert np.median(errors["sonic_conductance"]) < 0.005
    assert np.median(errors["critical_ratio"]) < 0.02
    assert 0.92 <= np.mean(covered["sonic_conductance"]) <= 0.98
    assert 0.92 <= np.mean(covered["critical_ratio"]) <= 0.98


def test_intervals_cover_the_truth_with_estimated_scatter():
    _, covered = study_benches(range(6), scatter_stated=False)
    assert is_covered_often_enough(covered["critical_ratio"], 6)


@pytest.mark.parametrize("count", [3, pytest.param(15, marks=pytest.mark.slow)])
@pytest.mark.parametrize(
    ("index", "cracking", "free"),
    [
        (0.6, 0.0, {"subsonic_index": "free"}),
        (0.5, 2e4, {"cracking_pressure": "free"}),
        (0.6, 1e4, {"subsonic_index": "free", "cracking_pressure": "free"}),
    ],
)
def test_free_index_and_cracking_pressure_are_identified(index, cracking, free, count):
    errors, covered = study_benches(range(count), index=index, cracking=cracking, **free)
    assert np.median(errors["critical_ratio"]) < 0.02
    if "subsonic_index" in free:
        assert np.median(errors["subsonic_index"]) < 0.02
    if "cracking_pressure" in free:
        assert np.median(errors["cracking_pressure"]) < 0.1 * cracking
    assert all(is_covered_often_enough(row, count) for row in covered.values())


def test_exact_points_give_exact_estimates():
    points = bench(np.linspace(0.1, 0.95, 15), noise=0.0, index=0.65, cracking=1.5e4)
    estimates = identify_flow(points, subsonic_index="free", cracking_pressure="free").parameters
    for name, value in {"sonic_conductance": 2e-8, "critical_ratio": 0.3, "subsonic_index": 0.65}.items():
        assert estimates[name].value == pytest.approx(value, rel=1e-6)
    assert estimates["cracking_pressure"].value == pytest.approx(1.5e4, rel=1e-5)


@given(st.floats(1e-2, 1e2), st.permutations(range(12)))
@settings(derandomize=True, deadline=None, max_examples=3)
def test_conductance_scales_with_flow_and_order_has_no_effect(factor, order):
    points = bench(np.linspace(0.1, 0.9, 12))
    order = list(order)
    scaled_points = FlowPoints(
        factor * points.mass_flow_rate[order],
        np.full(12, 7e5),
        points.pressure_2[order],
        points.temperature_1[order],
        **METERS,
    )
    estimates, scaled_estimates = identify_flow(points).parameters, identify_flow(scaled_points).parameters
    assert scaled_estimates["sonic_conductance"].value == pytest.approx(
        factor * estimates["sonic_conductance"].value, rel=1e-7
    )
    assert scaled_estimates["critical_ratio"].value == pytest.approx(estimates["critical_ratio"].value, abs=1e-7)
    assert scaled_estimates["critical_ratio"].standard_error == pytest.approx(
        estimates["critical_ratio"].standard_error, rel=1e-5
    )


# Uncertainty budget


def test_direct_fit_agrees_with_the_standard_formulas():
    result = plain_result(0.05, 0.95, 20)
    by_standard = result.comparison["standard_formulas"]
    for name in ("sonic_conductance", "critical_ratio"):
        direct = result.parameters[name]
        u = by_standard[f"u_{name}"]
        assert abs(direct.value - by_standard[name]) < 2.0 * u
        assert u == pytest.approx(direct.standard_error, rel=0.5)


def test_calibration_of_the_flow_meter_is_common_to_all_points():
    result_of_12, result_of_200 = (plain_result(0.05, 0.95, n) for n in (12, 200))
    budget = [r.comparison["uncertainty"]["sonic_conductance"] for r in (result_of_12, result_of_200)]
    for row, result in zip(budget, (result_of_12, result_of_200), strict=True):
        calibration = row["sources"]["calibration of mass_flow_rate"]
        assert calibration == pytest.approx(0.003 * result.parameters["sonic_conductance"].value, rel=0.01)
        assert math.hypot(row["type_a"], row["type_b"]) == pytest.approx(
            result.parameters["sonic_conductance"].standard_error, rel=1e-12
        )
    # The scatter falls with the square root of the number of points; the common errors stay.
    assert budget[1]["type_a"] == pytest.approx(budget[0]["type_a"] * math.sqrt(12 / 200), rel=0.2)
    assert budget[1]["type_b"] > 0.9 * budget[0]["type_b"]


def test_calibration_does_not_affect_the_critical_ratio():
    row = plain_result(0.05, 0.95, 20).comparison["uncertainty"]["critical_ratio"]
    assert row["sources"]["calibration of mass_flow_rate"] < 1e-3 * row["type_b"]


def test_few_points_use_student_t():
    points = bench([0.1, 0.3, 0.6, 0.8], meters={})
    result = identify_flow(points)
    row = result.comparison["uncertainty"]["critical_ratio"]
    assert row["degrees_of_freedom"] == pytest.approx(2.0)
    assert row["coverage_factor"] == pytest.approx(4.303, abs=1e-3)
    assert has_finding(result, "The scatter of the flow meter is not stated")
    assert has_finding(result, "No calibration error or offset")


def test_too_small_stated_scatter_is_enlarged_and_reported():
    ratios = np.linspace(0.05, 0.95, 20)
    realistic, optimistic = (
        identify_flow(bench(ratios, noise=0.01, meters={"u_mass_flow_rate": Instrument(relative=u)}))
        for u in (0.01, 0.001)
    )
    assert optimistic.comparison["chi_square_probability"] < 1e-6
    assert 5.0 < optimistic.comparison["scatter_factor"] < 20.0
    assert has_finding(optimistic, "times larger than expected from the stated scatter of the instruments")
    assert not has_finding(realistic, "times larger")
    assert optimistic.parameters["critical_ratio"].standard_error == pytest.approx(
        realistic.parameters["critical_ratio"].standard_error, rel=0.5
    )


def test_too_large_stated_scatter_is_reported():
    result = identify_flow(bench(np.linspace(0.05, 0.95, 20), meters={"u_mass_flow_rate": Instrument(relative=0.01)}))
    assert has_finding(result, "The stated scatter is probably too large")


def test_influence_equals_the_shift_of_a_refit():
    ratios = np.linspace(0.05, 0.9, 12)
    meters = {"u_mass_flow_rate": Instrument(absolute=2e-5)}
    points = bench(ratios, meters=meters)
    result = identify_flow(points)
    b = result.parameters["critical_ratio"]
    for k in (3, 6, 9, 11):
        is_kept = np.arange(12) != k
        remaining = FlowPoints(points.mass_flow_rate[is_kept], 7e5, points.pressure_2[is_kept], 293.15, **meters)
        shift = (identify_flow(remaining).parameters["critical_ratio"].value - b.value) / b.standard_error
        assert result.comparison["influence"]["critical_ratio"][k] == pytest.approx(shift, rel=0.05, abs=0.01)


def test_influential_point_is_reported():
    points = bench(np.linspace(0.05, 0.95, 20))
    points.mass_flow_rate[15] *= 1.05
    result = identify_flow(points)
    assert has_finding(result, ": point 16 (p2/p1 = ")


# Parameters that are not determined


@pytest.mark.parametrize("meters", [METERS, {}])
def test_choked_points_do_not_determine_the_critical_ratio(meters):
    result = identify_flow(replace(bench(np.linspace(0.05, 0.25, 8), meters=meters), is_absolute=True))
    b, conductance = result.parameters["critical_ratio"], result.parameters["sonic_conductance"]
    assert b.verdict == "not determined"
    assert math.isnan(b.value)
    assert b.standard_error == math.inf
    assert 0.1 < b.low < 0.25
    assert b.high == 1.0
    assert conductance.verdict == ("determined" if meters else "weak")
    assert conductance.low < 2e-8 < conductance.high
    assert has_finding(result, "(p2/p1 = 0.05 to 0.25)")
    assert has_finding(result, "Measure another point at p2/p1 of about 0.68")
    assert list(result.values()) == ["sonic_conductance"]


def test_choked_points_do_not_determine_index_and_cracking_pressure():
    points = replace(bench(np.linspace(0.05, 0.25, 8)), is_absolute=True)
    result = identify_flow(points, subsonic_index="free", cracking_pressure="free")
    assert [e.verdict for e in result.parameters.values()] == ["determined", *["not determined"] * 3]
    assert has_finding(result, "do not determine subsonic_index and cracking_pressure")


def test_suggested_point_determines_the_critical_ratio():
    result = identify_flow(replace(bench([*np.linspace(0.05, 0.25, 8), 0.68]), is_absolute=True))
    assert result.parameters["critical_ratio"].verdict == "determined"
    assert abs(result.parameters["critical_ratio"].value - 0.3) < 0.02


def test_one_pressure_ratio_leaves_a_range_of_conductances():
    result = identify_flow(bench(np.full(6, 0.6)))
    conductance, b = result.parameters["sonic_conductance"], result.parameters["critical_ratio"]
    assert b.verdict == "not determined"
    assert conductance.verdict == "weak"
    # between choked flow, C = Ce, and b = 0, C = Ce/0.8
    assert conductance.low < 2e-8 * math.sqrt(1.0 - (0.3 / 0.7) ** 2) < conductance.high
    assert conductance.high > 2e-8 * math.sqrt(1.0 - (0.3 / 0.7) ** 2) / 0.8
    assert has_finding(result, "The flow is possibly not choked at any point")


def test_missing_choked_point_is_reported_with_the_correlation():
    result = identify_flow(bench(np.linspace(0.5, 0.95, 12)))
    assert has_finding(result, "The flow is not choked at any point (lowest p2/p1: 0.5")
    correlation = result.correlation["sonic_conductance"]["critical_ratio"]
    assert correlation < -0.5
    assert has_finding(result, f"({correlation:+.3f})")
    assert result.comparison["standard_formulas"]["note"].startswith("No point is saturated")
    with_choked = plain_result(0.05, 0.95, 12)
    assert not has_finding(with_choked, "The flow is not choked at any point")
    assert with_choked.comparison["standard_formulas"]["note"] == ""


def test_points_near_equal_pressure_do_not_determine_the_law():
    result = identify_flow(bench(np.linspace(0.9, 0.99, 12)))
    assert result.parameters["critical_ratio"].verdict == "not determined"
    assert result.parameters["sonic_conductance"].verdict in ("weak", "not determined")


def test_points_near_equal_pressure_are_reported_and_have_no_effect():
    result = identify_flow(bench([*np.linspace(0.05, 0.95, 12), 0.996, 0.999, 1.0], meters=METERS))
    assert has_finding(result, ": point 13 (p2/p1 = 0.996), point 14 (p2/p1 = 0.999), point 15 (p2/p1 = 1).")
    assert abs(result.parameters["critical_ratio"].value - 0.3) < 0.02
    without_uncertainty = identify_flow(bench([*np.linspace(0.05, 0.95, 12), 0.996], meters={}))
    assert has_finding(without_uncertainty, "the uncertainty of the pressures is not stated")


def test_absent_cracking_pressure_is_at_its_bound():
    ratios = np.linspace(0.05, 0.95, 20)
    results = [identify_flow(bench(ratios, seed=seed), cracking_pressure="free") for seed in range(3)]
    at_bound = [r for r in results if r.parameters["cracking_pressure"].verdict == "at bound"]
    assert at_bound
    for result in at_bound:
        assert result.parameters["cracking_pressure"].value == 0.0
        assert 0.0 < result.parameters["cracking_pressure"].high < 5e3
        assert has_finding(result, "No cracking pressure was detected")


@pytest.mark.parametrize("law", [{"index": 0.7}, {"cracking": 3e4}])
def test_wrong_shape_of_the_law_is_reported(law):
    result = identify_flow(bench(np.linspace(0.05, 0.96, 24), **law))
    assert has_finding(result, "The residuals depend systematically on p2/p1")
    assert has_finding(result, 'Repeat the fit with subsonic_index = "free" or cracking_pressure = "free"')
    assert "determined" not in [e.verdict for e in result.parameters.values()]


def direct_law_bench(ratios, conductance, ratio, index, cracking=0.0, noise=0.003):
    """Return points at 7 bar from a separate formula of the law, without stated scatter."""
    position = np.clip((ratios - ratio) / (1.0 - cracking / 7e5 - ratio), 0.0, 1.0)
    q = conductance * 1.185 * 7e5 * (1.0 - position**2) ** index
    return FlowPoints(q * (1.0 + noise * np.random.default_rng(0).standard_normal(q.size)), 7e5, 7e5 * ratios, 293.15)


@pytest.mark.parametrize(
    ("index", "cracking", "fixed"),
    [(0.4, 0.0, "subsonic_index"), (0.6, 0.0, "subsonic_index"), (0.5, 5e3, "cracking_pressure")],
)
def test_wrong_fixed_parameter_is_reported_and_weakens_the_verdicts(index, cracking, fixed):
    """With m = 0.5, the fit gives b = 0.42 or 0.18 in place of 0.3, and the runs test does not show it."""
    result = identify_flow(direct_law_bench(np.linspace(0.15, 0.95, 13), 1e-8, 0.3, index, cracking))
    note = next(remark for remark in result.remarks if remark.code == "flow.other_law")
    assert note.address == fixed
    assert note.facts["value"] == pytest.approx(cracking or index, rel=0.15)
    for name, truth in (("sonic_conductance", 1e-8), ("critical_ratio", 0.3)):
        estimate = result.parameters[name]
        assert estimate.verdict == "weak"
        assert estimate.low < truth < estimate.high
    assert result.comparison["alternatives"][fixed]["aicc_difference"] < -6.0


def test_gauge_pressures_at_one_inlet_pressure_are_equivalent():
    ratios = np.linspace(0.5, 0.95, 13)
    points = direct_law_bench(ratios, 1e-8, 0.3, 0.5)
    gauge_points = replace(
        points, pressure_1=points.pressure_1 * 4 / 7 - 1e5, pressure_2=points.pressure_2 * 4 / 7 - 1e5
    )
    result = identify_flow(replace(gauge_points, mass_flow_rate=points.mass_flow_rate * 4 / 7))
    note = next(remark for remark in result.remarks if remark.code == "flow.gauge_twin")
    assert (note.facts["conductance"], note.facts["ratio"]) == pytest.approx((1e-8, 0.3), rel=0.05)
    assert {remark.verdict for remark in result.parameters.values()} == {"weak"}


def test_pressure_below_the_atmosphere_is_reported():
    assert has_finding(plain_result(0.05, 0.95, 12), "pressure_2 falls to 35 kPa absolute")
    assert not has_finding(identify_flow(bench(np.linspace(0.2, 0.95, 12))), "kPa absolute")


# Wrong readings


def test_gauge_read_as_absolute_is_reported():
    p_1 = np.linspace(1.3e5, 8e5, 15)
    result = identify_flow(bench(101325.0 / p_1, pressure_1=p_1, shift=-101325.0))
    assert has_finding(result, "gauge pressures that were read as absolute pressures: with +101.3 kPa")
    assert "determined" not in [e.verdict for e in result.parameters.values()]


def test_absolute_read_as_gauge_is_reported():
    result = identify_flow(bench(np.linspace(0.1, 0.95, 16), pressure_1=np.tile([4e5, 8e5], 8), shift=101325.0))
    assert has_finding(result, "absolute pressures that were read as gauge pressures: with -101.3 kPa")
    assert "determined" not in [e.verdict for e in result.parameters.values()]


def test_implausible_conductance_is_reported():
    result = identify_flow(bench(np.linspace(0.1, 0.95, 16), conductance=1e-3))
    assert has_finding(result, "is outside the usual range of pneumatic components")
    assert result.parameters["sonic_conductance"].verdict == "weak"


GOOD = {
    "mass_flow_rate": [0.0166, 0.0166, 0.0160, 0.0120],
    "pressure_1": 7e5,
    "pressure_2": [1e5, 2e5, 3e5, 5e5],
    "temperature_1": 293.15,
}


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"mass_flow_rate": [0.0166, math.nan, 0.016, 0.012]}, "flow.not_finite"),
        ({"pressure_2": [1e5, 2e5, math.inf, 5e5]}, "flow.not_finite"),
        ({"mass_flow_rate": [0.0166, 0.0166, 9e13, 0.012]}, "flow.too_large"),
        ({name: [] for name in GOOD}, "flow.no_points"),
        ({"mass_flow_rate": [0.0, 0.0, 0.0, 0.0]}, "flow.no_flow"),
        ({"mass_flow_rate": [0.0166, 0.016, -0.01, 0.012]}, "flow.backwards"),
        ({"pressure_1": -1e5}, "flow.upstream"),
        ({"pressure_2": [-1e4, 2e5, 3e5, 5e5]}, "flow.downstream"),
        ({"temperature_1": 20.0}, "flow.temperature"),
        ({"pressure_1": 2.5e5}, "flow.against"),
        ({"pressure_1": [7e5, 7e5]}, "flow.shape"),
        ({"pressure_2": ["a", 1, 2, 3]}, "series.numbers"),
    ],
)
def test_invalid_readings_are_rejected(change, message):
    with refused(message):
        FlowPoints(**{**GOOD, **change})


def test_all_errors_of_points_are_raised_together():
    with pytest.raises(InputErrors) as caught:
        FlowPoints(**{**GOOD, "temperature_1": 20.0, "pressure_2": [-1.0, 2e5, 3e5, 5e5]})
    assert len(caught.value.problems) == 2


@pytest.mark.parametrize("value", [-0.1, math.nan, math.inf])
def test_invalid_uncertainties_are_rejected(value):
    with refused("fields.out_of_range", "relative"):
        Instrument(relative=value)


def test_too_few_points_are_rejected():
    with refused("flow.too_few_points"):
        identify_flow(bench([0.1, 0.8]))
    with refused("flow.too_few_points"):
        identify_flow(bench([0.1, 0.5, 0.7, 0.8]), subsonic_index="free", cracking_pressure="free")


def test_flow_that_rises_with_the_downstream_pressure_is_rejected():
    points = bench(np.linspace(0.1, 0.95, 16))
    points.mass_flow_rate[:] = points.mass_flow_rate[::-1].copy()
    with refused("flow.rises", "mass_flow_rate"):
        identify_flow(points)


@pytest.mark.parametrize(("cracking", "ratios"), [(9e5, np.linspace(0.1, 0.9, 9)), (0.0, np.ones(5))])
def test_flow_through_a_closed_flow_path_is_rejected(cracking, ratios):
    p_2 = 7e5 * ratios
    points = FlowPoints(np.full(ratios.size, 0.01), 7e5, p_2, 293.15)
    with refused("flow.closed_everywhere", "cracking_pressure"):
        identify_flow(points, cracking_pressure=cracking)


def test_all_invalid_arguments_are_reported():
    with refused("flow.number_or_free", "subsonic_index") as caught:
        identify_flow(bench(np.linspace(0.1, 0.9, 9)), subsonic_index="frei", cracking_pressure=-1.0)
    assert "cracking_pressure = -1 Pa must be finite and at least 0" in str(caught.value)


# The result


def test_result_file_is_read_as_written(tmp_path):
    result = identify_flow(bench(np.linspace(0.05, 0.25, 8)), part="outlet", notes=("Column 3 was skipped.",))
    assert list(result.parameters) == ["outlet.sonic_conductance", "outlet.critical_ratio"]
    assert result.findings[-1] == "Column 3 was skipped."
    result.save(tmp_path / "flow.toml")
    read = read_result(tmp_path / "flow.toml")
    assert read.parameters["outlet.sonic_conductance"] == result.parameters["outlet.sonic_conductance"]
    assert read.comparison["influence"] == result.comparison["influence"]


def test_series_and_residuals_belong_to_the_points():
    points = bench(np.linspace(0.05, 0.95, 12)[::-1])
    result = identify_flow(points)
    series = result.series["points.effective_conductance"]
    assert np.all(np.diff(series["x"]) > 0.0)
    assert series["measured"] == pytest.approx(points.effective_conductance[::-1])
    assert series["model"] == pytest.approx(series["measured"], rel=0.01)
    summary = result.residuals["points.mass_flow_rate"]
    assert summary.samples == 12
    assert summary.nrmse == pytest.approx(summary.rms / np.ptp(points.mass_flow_rate))


def test_recording_with_units_gives_points():
    recording = Recording.from_series(
        [0.0, 1.0, 2.0],
        {
            "q [l/min ANR]": [600.0, 600.0, 420.0],
            "p1 [bar g]": [4.0, 4.0, 4.0],
            "p2 [bar g]": [0.0, 0.5, 3.0],
            "T [degC]": [20.0, 20.0, 20.0],
        },
    )
    points = FlowPoints.from_recording(
        recording, mass_flow_rate="q", pressure_1="p1", pressure_2="p2", temperature_1="T"
    )
    assert points.mass_flow_rate == pytest.approx([0.01185, 0.01185, 0.008295])
    assert points.pressure_ratio == pytest.approx([0.2, 0.3, 0.8])
    # Example of a catalogue: C = 2 dm3/(s bar), b = 0.3
    estimates = identify_flow(points).parameters
    assert estimates["sonic_conductance"].value == pytest.approx(2e-8, rel=1e-3)
    assert estimates["critical_ratio"].value == pytest.approx(0.3, abs=1e-3)


# Outliers


def outlier_notes(points):
    return [note for note in identify_flow(points).remarks if note.code == "flow.outlier"]


TWELVE = np.linspace(0.1, 0.9, 12)


@pytest.mark.parametrize("meters", [METERS, {}], ids=["stated", "estimated"])
@pytest.mark.parametrize("wrong", [0, 5, 9])
def test_outlier_of_six_per_cent_is_reported(meters, wrong):
    points = bench(TWELVE, noise=0.003, meters=meters, seed=wrong)
    flow = points.mass_flow_rate.copy()
    flow[wrong] *= 1.06
    (note,) = outlier_notes(replace(points, mass_flow_rate=flow, lines=range(2, 14)))
    assert (note.facts["row"], note.facts["line"]) == (wrong + 1, wrong + 2)
    assert note.facts["percent"] == pytest.approx(6.0, abs=2.0)
    assert note.facts["probability"] < 0.01


def test_tables_without_outlier_have_no_finding():
    """The probability of a finding is 1 % for a table without an outlier."""
    n_outliers = sum(bool(outlier_notes(bench(TWELVE, noise=0.003, meters={}, seed=seed))) for seed in range(200))
    print(f"{n_outliers} of 200 tables without an outlier have a finding")
    assert n_outliers <= binom.isf(0.001, 200, 0.01)
    assert outlier_notes(bench(TWELVE, noise=0.0, meters={})) == []
