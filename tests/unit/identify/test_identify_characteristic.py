"""Tests of `identify characteristic`: shapes, evidence, verdicts, files and invalid input."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.core.errors import OutOfRangeError
from poppet.core.provenance import Number, Source
from poppet.identify.characteristic.characteristic_file import (
    characteristic_table,
    read_characteristic_file,
    write_characteristic,
)
from poppet.identify.characteristic.characteristic_shapes import PolynomialShape, SplineShape, pchip
from poppet.identify.characteristic.identify_characteristic import identify_characteristic
from poppet.identify.characteristic.stroke_tests import (
    StrokePoint,
    StrokeRecording,
    common_of_result,
    evaluate_test,
    point_of_result,
)
from poppet.identify.free_parameter import read_free
from poppet.identify.result import Estimate, Result, read_result
from poppet.laws.curves import TableCurve, characteristic_from_mapping
from poppet.library.varga2012 import printed_characteristic
from poppet.timeseries.measurements import Channel, Measurement
from refusals import refused
from result_keys import undocumented

TABLE = printed_characteristic()
STROKES = np.linspace(0.05e-3, 1e-3, 15)
HARD = settings(derandomize=True, deadline=None, max_examples=50)


def simulate_tests(conductance, ratio, strokes=STROKES, noise=0.002, u_ratio=0.004, seed=1):
    """Return tests of known curves: C with relative noise, b with absolute noise, both stated."""
    generator = np.random.default_rng(seed)
    return [
        StrokePoint(
            float(x),
            conductance(x) * (1.0 + noise * generator.standard_normal()),
            ratio(x) + u_ratio * generator.standard_normal(),
            noise * conductance(x),
            u_ratio,
            name=f"t{k}",
        )
        for k, x in enumerate(strokes)
    ]


def rising_conductance(x):
    return 1.6e-8 * np.tanh(3e3 * x)


def constant_ratio(x):
    return 0.4 + 0.0 * x


PRINTED = simulate_tests(TABLE.sonic_conductance_at, TABLE.critical_ratio_at)
RISING = simulate_tests(rising_conductance, constant_ratio)


@pytest.fixture(scope="module")
def printed_fit():
    """Return the polynomials fitted to the points of Table 1."""
    return identify_characteristic(PRINTED)


@pytest.fixture(scope="module")
def printed_spline_fit():
    return identify_characteristic(PRINTED, form="spline")


@pytest.fixture(scope="module")
def rising_spline_fit():
    return identify_characteristic(RISING, form="spline", part="valve")


# Shapes ------------------------------------------------------------------------------------------------------------


@HARD
@given(st.integers(0, 9), st.floats(0.0, 0.4), st.integers(0, 1000))
def test_power_and_chebyshev_coefficients_agree(degree, first, seed):
    shape = PolynomialShape(degree, (first * 1e-3, 1e-3), 1e-8)
    theta = np.random.default_rng(seed).standard_normal(shape.size)
    x = np.linspace(*shape.domain, 20)
    direct = np.polyval(shape.numbers(theta), 1e3 * x)
    rounding = np.sum(np.abs(shape.numbers(theta)))
    assert np.max(np.abs(direct - shape.values(theta, x))) < 1e-13 * rounding


@HARD
@given(st.lists(st.floats(0.0, 1.0), min_size=3, max_size=8))
def test_rising_spline_rises_and_equals_table_curve(increments):
    knots = tuple(np.linspace(0.1e-3, 1e-3, len(increments)).tolist())
    shape = SplineShape(knots, True, scale=1e-8, first=0.0)
    theta, x = np.array(increments), np.linspace(0.0, 1e-3, 101)
    values = shape.values(theta, x)
    assert np.min(np.diff(values)) >= -1e-20
    assert np.min(values) >= -1e-20
    numbers = tuple(Number(float(v), "m^3/(s Pa)", Source("given")) for v in shape.numbers(theta))
    curve = TableCurve(shape.table_knots, numbers)
    assert np.max(np.abs(curve.evaluate(x, curve.parameters()) - values)) < 1e-20


@pytest.mark.parametrize("rises", [True, False])
def test_spline_slopes_equal_central_differences(rises):
    shape = SplineShape((0.1e-3, 0.3e-3, 0.6e-3, 1e-3), rises, scale=2.0, last=1.2e-3)
    theta, x = np.array([0.2, 0.3, 0.25, 0.15]), np.linspace(0.1e-3, 1.2e-3, 7)
    for k, column in enumerate(shape.slopes(theta, x).T):
        step = 1e-5 * np.eye(4)[k]
        central = (shape.values(theta + step, x) - shape.values(theta - step, x)) / 2e-5
        assert np.max(np.abs(column - central)) < 1e-4


def test_spline_is_linear_before_and_constant_after_its_knots():
    shape = SplineShape((0.2e-3, 0.4e-3, 0.8e-3), False, first=0.1e-3, last=1e-3)
    assert shape.numbers(np.array([0.2, 0.4, 0.6])) == pytest.approx([0.1, 0.2, 0.4, 0.6, 0.6])
    assert shape.numbers(np.array([0.1, 0.4, 0.6]))[0] == 0.0


def test_pchip_interpolates_its_points():
    knots = (0.0, 1.0, 3.0, 4.0)
    assert pchip(knots, np.array([1.0, 3.0, 2.0, 2.5]), np.array(knots)).tolist() == [1.0, 3.0, 2.0, 2.5]


# Evidence ----------------------------------------------------------------------------------------------------------


@HARD
@given(st.floats(-0.95, 0.95))
def test_evidence_has_covariance_of_point(correlation):
    point = StrokePoint(1e-3, 1e-8, 0.4, 1e-10, 0.02, correlation)
    scaled = evaluate_test(point, "").root * np.array([1e-10, 0.02])
    expected = np.array([[1.0, correlation], [correlation, 1.0]])
    assert np.max(np.abs(np.linalg.inv(scaled.T @ scaled) - expected)) < 1e-9
    assert evaluate_test(point, "").uncertainty == pytest.approx([1e-10, 0.02])


def test_evidence_without_b_determines_c_only():
    blind = evaluate_test(StrokePoint(1e-3, 1e-8, float("nan"), 1e-10, float("inf")), "")
    assert blind.uncertainty.tolist() == [pytest.approx(1e-10), float("inf")]


# Fits --------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("joint", [False, True])
def test_fit_recovers_table_1(joint):
    series = identify_characteristic(PRINTED, joint=joint).series
    x = series["sonic_conductance"]["x"]
    assert np.max(np.abs(series["sonic_conductance"]["y"] / TABLE.sonic_conductance_at(x) - 1.0)) < 0.01
    assert np.max(np.abs(series["critical_ratio"]["y"] - TABLE.critical_ratio_at(x))) < 0.02


# The errors of the 13 coefficients of one seed are correlated: the coverage of few seeds scatters.
@pytest.mark.parametrize(
    ("seeds", "low", "high"), [(12, 0.75, 1.0), pytest.param(60, 0.9, 0.99, marks=pytest.mark.slow)]
)
def test_coverage_of_coefficient_intervals(seeds, low, high):
    """Check the coverage of the 95 % intervals of all 13 coefficients over many seeds."""
    truth = [float(n) for n in (*TABLE.sonic_conductance.numbers().values(), *TABLE.critical_ratio.numbers().values())]
    hits = []
    for seed in range(seeds):
        tests = simulate_tests(TABLE.sonic_conductance_at, TABLE.critical_ratio_at, seed=seed)
        estimates = identify_characteristic(tests).parameters.values()
        hits += [e.low <= value <= e.high for e, value in zip(estimates, truth, strict=True)]
    assert low < np.mean(hits) < high


@pytest.mark.parametrize(("draws", "tolerance"), [(100, 0.4), pytest.param(400, 0.2, marks=pytest.mark.slow)])
def test_bootstrap_and_delta_method_bands_agree(printed_fit, draws, tolerance):
    bands = [r.series["critical_ratio"] for r in (printed_fit, identify_characteristic(PRINTED, bootstrap=draws))]
    widths = [band["high"] - band["low"] for band in bands]
    assert np.max(np.abs(widths[1] / widths[0] - 1.0)) < tolerance


def test_monotone_constraint_is_kept_for_rising_c(rising_spline_fit):
    result = rising_spline_fit
    assert not result.comparison["monotone"]["rejected"]
    assert "the data agree with this constraint" in result.findings[0]
    curve = result.series["sonic_conductance"]
    tested = curve["x"] >= STROKES[0]
    assert np.max(np.abs(curve["y"] - rising_conductance(curve["x"]))[tested]) < 0.02 * 1.6e-8
    assert np.min(np.diff(curve["y"])) >= -1e-20


@pytest.mark.slow  # the previous test is the fast version
@pytest.mark.parametrize("seed", range(5))
def test_monotone_constraint_is_kept_for_other_seeds(seed):
    result = identify_characteristic(simulate_tests(rising_conductance, constant_ratio, seed=100 + seed), form="spline")
    assert not result.comparison["monotone"]["rejected"]


def test_monotone_constraint_is_rejected_for_falling_c(printed_spline_fit):
    result = printed_spline_fit
    assert result.comparison["monotone"]["rejected"]
    assert undocumented(result) == []
    assert "the data contradict this constraint" in result.findings[0]


def test_common_uncertainty_widens_band_only(printed_fit):
    independent, shared = printed_fit, identify_characteristic(PRINTED, common=(0.02, 0.03))
    first, second = independent.series["sonic_conductance"], shared.series["sonic_conductance"]
    assert np.max(np.abs(first["y"] / second["y"] - 1.0)) < 1e-12
    assert np.min((second["high"] - second["low"]) / second["y"]) > 2 * 1.95 * 0.02
    ratio = shared.series["critical_ratio"]
    assert np.min(ratio["high"] - ratio["low"]) > 2 * 1.95 * 0.03


def test_large_scatter_widens_intervals_and_is_reported(printed_fit):
    optimistic = [replace(p, u_sonic_conductance=p.u_sonic_conductance / 10.0) for p in PRINTED]
    result = identify_characteristic(optimistic)
    assert any("times their uncertainties" in text for text in result.findings)
    wide, narrow = (r.parameters["sonic_conductance.k8"].standard_error for r in (result, printed_fit))
    assert wide > 0.5 * narrow


def test_gaps_repeats_extrapolation_and_missing_b_are_reported():
    tests = [replace(p, critical_ratio=float("nan"), u_critical_ratio=float("inf")) if k == 3 else p
             for k, p in enumerate(PRINTED) if k not in (8, 9, 10)]  # fmt: skip
    tests.append(replace(tests[5], sonic_conductance=1.1 * tests[5].sonic_conductance, name="again"))
    text = " ".join(identify_characteristic(tests, degree_conductance=5, domain=(0.0, 1e-3)).findings)
    assert "1 of 13 tests (t3) do not determine b" in text
    assert "the curves C(x) and b(x) are interpolated" in text
    assert "The repeated tests t5 and again at" in text
    assert "from 0.05 mm, the tested stroke nearest to this end of the domain, to 0 mm" in text


# Recordings --------------------------------------------------------------------------------------------------------

BENCH = Circuit(
    {
        "tank": Chamber(volume="10 l", wall_conductance=8.0, initial_pressure="7 bar"),
        "room": Reservoir(pressure="1 bar"),
        "valve": Orifice(from_="tank", to="room", sonic_conductance=1e-8, critical_ratio=0.3),
    }
)


def simulate_recording(stroke, seed, free=()):
    truth = BENCH.with_values({"valve.sonic_conductance": 1e-8 * (0.5 + 1e3 * stroke), "valve.critical_ratio": 0.4})
    run = truth.simulate(duration=30.0, output_step=0.1)
    noise = 300.0 * np.random.default_rng(seed).standard_normal(run.time.size)
    channel = Channel("tank.pressure", run.time, run["tank.pressure"] + noise, "Pa", noise=300.0)
    stated = dict.fromkeys(("tank.initial_temperature", "room.temperature", "ambient.temperature"), "20 degC")
    bench = BENCH.with_values({"tank.wall_conductance": 5.0, **stated})
    return StrokeRecording(stroke, bench, Measurement(f"r{seed}", (channel,), duration=30.0), free=free)


def test_points_among_recordings_are_reported():
    tests = [simulate_recording(x, k) for k, x in enumerate((0.2e-3, 0.5e-3, 0.8e-3))]
    number = StrokePoint(1e-3, 1.5e-8, 0.4, 1.5e-10, 0.01, name="flow bench")
    mixed = identify_characteristic([*tests, number], degree_conductance=1, degree_ratio=0, joint=False)
    sentences = [
        sentence
        for sentence in mixed.findings
        if sentence.startswith("For 1 of 4 tests") and "the fit uses only the values of C and b" in sentence
    ]
    assert len(sentences) == 1
    assert "(flow bench)" in sentences[0]
    recordings_only = identify_characteristic(tests, degree_conductance=1, degree_ratio=0, joint=False)
    assert not any("the fit uses only the values of C and b" in sentence for sentence in recordings_only.findings)


def test_joint_fit_shares_bench_parameters():
    wall = (read_free("tank.wall_conductance", {}, BENCH),)
    tests = [simulate_recording(x, k, wall) for k, x in enumerate((0.2e-3, 0.5e-3, 0.8e-3, 1e-3))]
    result = identify_characteristic(tests, degree_conductance=1, degree_ratio=0)
    shared = result.parameters["tank.wall_conductance"]
    assert shared.low < 8.0 < shared.high
    smallest_error = min(float(np.sqrt(np.diag(np.linalg.inv(o.jacobian.T @ o.jacobian)))[2])
                for o in (evaluate_test(t, "").optimum for t in tests))  # fmt: skip
    assert shared.standard_error < smallest_error
    assert result.parameters["sonic_conductance.k1"].value == pytest.approx(1e-8, rel=0.02)
    assert result.comparison["degrees_of_freedom"] == 8 - 3 + 3


def test_evidence_of_recording_equals_its_fit():
    wall = (read_free("tank.wall_conductance", {}, BENCH),)
    evidence = evaluate_test(simulate_recording(0.5e-3, 7, wall), "r")
    inverse = np.linalg.inv(evidence.optimum.jacobian.T @ evidence.optimum.jacobian)
    assert evidence.uncertainty == pytest.approx(np.sqrt(np.diag(inverse)[:2] * evidence.widening), rel=1e-6)
    assert np.max(np.abs(evidence.centre - [1e-8, 0.4]) / evidence.uncertainty) < 4.0


def test_free_lags_and_unknown_flow_paths_are_rejected():
    test = simulate_recording(0.5e-3, 7)
    lagging = replace(test.measurement, channels=(replace(test.measurement.channels[0], lag=None),))
    with refused("stroke.free_sensor", "tank.pressure"):
        identify_characteristic([replace(test, measurement=lagging)])
    with refused("names.unknown", "tests.r7.passage"):
        identify_characteristic([replace(test, passage="value")])
    with refused("stroke.no_own_numbers"):
        identify_characteristic([replace(test, passage="tank")])


# Invalid input -------------------------------------------------------------------------------------------------------


def test_too_few_strokes_are_rejected():
    with refused("characteristic.too_few_for_polynomial", tests=8, strokes=8, degrees=(7, 4)):
        identify_characteristic(PRINTED[:8])


@pytest.mark.parametrize("form", ["polynomial", "spline"])
def test_tests_without_b_are_rejected(form):
    """Use choked flow only, which does not determine b."""
    blind = [StrokePoint(x, 1e-8, math.nan, 1e-10, math.inf) for x in np.linspace(1e-4, 9e-4, 6)]
    with refused("characteristic.ratio_unseen", strokes=0, of=6):
        identify_characteristic(blind, form=form, degree_conductance=2, degree_ratio=1)


def test_recording_at_two_strokes_is_rejected():
    recording = simulate_recording(3e-4, 1)
    with refused("stroke.same_twice", test="r1", other="r1"):
        identify_characteristic([recording, replace(recording, stroke=5e-4)])


def test_repeated_strokes_count_once():
    with refused("characteristic.too_few_for_polynomial", tests=16, strokes=8):
        identify_characteristic(PRINTED[:8] * 2)


def test_repeated_names_are_numbered():
    assert len(identify_characteristic([*PRINTED, PRINTED[3]]).conditions["tests"]) == 16


def test_empty_list_of_tests_is_rejected():
    with refused("characteristic.too_few_for_polynomial", tests=0, strokes=0):
        identify_characteristic([])


def test_strokes_outside_domain_are_rejected():
    with refused("stroke.outside", test="t14", low_mm=0.0, high_mm=0.9) as caught:
        identify_characteristic(PRINTED, domain=(0.0, 0.9e-3))
    assert "t13" in str(caught.value)


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("stroke", float("nan")),
        ("sonic_conductance", float("nan")),
        ("sonic_conductance", 0.0),
        ("critical_ratio", float("nan")),
        ("critical_ratio", 1.0),
        ("u_sonic_conductance", 0.0),
        ("u_sonic_conductance", float("inf")),
        ("u_critical_ratio", float("nan")),
        ("correlation", 1.0),
    ],
)
def test_invalid_points_are_rejected(field, value):
    with refused("numbers.not_finite" if field == "stroke" else "fields.out_of_range", f"tests.t4.{field}"):
        identify_characteristic([*PRINTED[:4], replace(PRINTED[4], **{field: value}), *PRINTED[5:]])


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"form": "splne"}, "fields.not_an_option"),
        ({"degree_conductance": -1}, "fields.out_of_range"),
        ({"degree_ratio": 2.5}, "fields.out_of_range"),
        ({"domain": (1e-3, 0.0)}, "characteristic.empty_domain"),
        ({"domain": (float("nan"), 1.0)}, "characteristic.empty_domain"),
        ({"common": (-0.1, 0.0)}, "characteristic.common"),
        ({"bootstrap": 10}, "characteristic.bootstrap"),
        ({"form": "spline", "knots": (1e-3, 0.5e-3)}, "characteristic.knots"),
        ({"form": "spline", "knots": (0.1e-3, 2e-3)}, "characteristic.knots"),
    ],
)
def test_invalid_options_are_rejected(options, message):
    with refused(message):
        identify_characteristic(PRINTED, **options)


# Results of other identifications ----------------------------------------------------------------------------------


def flow_result(**changes):
    parameters = {
        "valve.sonic_conductance": Estimate(1e-8, "m^3/(s Pa)", 2e-10, 0.0, 1.0, "determined"),
        "valve.critical_ratio": Estimate(0.4, "1", 0.02, 0.3, 0.5, "determined"),
    }
    budget = {
        "valve.sonic_conductance": {"type_a": 1e-10, "type_b": 1.7e-10},
        "valve.critical_ratio": {"type_a": 0.01, "type_b": 0.015},
    }
    return Result("flow", "bench", parameters | changes, comparison={"uncertainty": budget})


def test_flow_result_has_independent_and_common_uncertainty():
    point = point_of_result(flow_result(), 0.5e-3, part="valve", name="a")
    assert (point.u_sonic_conductance, point.u_critical_ratio) == (1e-10, 0.01)
    assert common_of_result(flow_result(), part="valve") == pytest.approx((0.017, 0.015))


def test_result_without_b_gives_point_without_b():
    estimates = {"valve.critical_ratio": Estimate(float("nan"), "1", float("inf"), 0.3, 1.0, "not determined")}
    point = point_of_result(flow_result(**estimates), 0.5e-3, part="valve")
    assert np.isnan(point.critical_ratio)
    assert np.isinf(point.u_critical_ratio)
    with refused("stroke.not_in_result", "sonic_conductance"):
        point_of_result(flow_result(), 0.5e-3)


# Files -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("form", ["polynomial", "spline"])
def test_written_characteristic_equals_fit(form, rising_spline_fit, tmp_path):
    result = rising_spline_fit if form == "spline" else identify_characteristic(RISING, part="valve")
    write_characteristic(result, tmp_path / "mine.toml")
    result.save(tmp_path / "result.toml")
    write_characteristic(read_result(tmp_path / "result.toml"), tmp_path / "again.toml")
    assert (tmp_path / "mine.toml").read_text() == (tmp_path / "again.toml").read_text()
    read = Orifice(from_="a", to="b", characteristic=str(tmp_path / "mine.toml"), stroke=1e-3).characteristic
    for name, curve in (("sonic_conductance", read.sonic_conductance_at), ("critical_ratio", read.critical_ratio_at)):
        x, y = result.series[name]["x"], result.series[name]["y"]
        open_ = x > 2.1e-5
        assert np.max(np.abs(np.asarray(curve(x)) - y)[open_]) < 1e-9 * np.max(y)
    assert read.source.kind == "fitted"
    assert {n.source.kind for n in read.numbers().values()} == {"fitted"}


def test_default_domain_is_tested_range(printed_spline_fit):
    assert printed_spline_fit.conditions["domain"] == pytest.approx([STROKES[0], STROKES[-1]])
    assert not [note for note in printed_spline_fit.remarks if note.code == "characteristic.continued"]


def test_all_tested_strokes_can_be_knots():
    strokes = np.linspace(0.05e-3, 1e-3, 12)
    tests = simulate_tests(rising_conductance, lambda x: 0.4 - 100.0 * x, strokes)
    result = identify_characteristic(tests, form="spline", knots=tuple(strokes))
    values = [result.parameters[f"sonic_conductance.y{k}"].value for k in range(12)]
    assert values == pytest.approx([test.sonic_conductance for test in tests], rel=0.005)
    halves = [(e.high - e.value) / e.value for e in result.parameters.values() if e.unit != "1"]
    assert max(halves) < 0.02
    with refused("characteristic.too_few_for_spline"):
        identify_characteristic(tests[:-1], form="spline", knots=(*strokes[:-1], 0.97e-3))


def test_band_of_few_tests_agrees_with_scatter_of_fits():
    """Check the band at the strokes with six knots and seven strokes, which have one degree of freedom."""
    strokes = np.linspace(0.05e-3, 1e-3, 7)
    knots = tuple(strokes[[0, 1, 2, 3, 5, 6]])
    # The spline can represent this truth.
    truth = identify_characteristic(
        simulate_tests(rising_conductance, lambda _: 0.4, strokes), form="spline", knots=knots
    ).series

    def curve(name):
        return lambda strokes_of_tests: np.interp(strokes_of_tests, truth[name]["x"], truth[name]["y"])

    curves, halves = [], []
    for seed in range(30):
        tests = simulate_tests(curve("sonic_conductance"), curve("critical_ratio"), strokes, noise=0.01, seed=seed)
        band = identify_characteristic(tests, form="spline", knots=knots).series["sonic_conductance"]
        curves.append(np.interp(strokes, band["x"], band["y"]))
        halves.append(np.interp(strokes, band["x"], 0.5 * (band["high"] - band["low"])))
    ratio = np.array(halves) / (1.96 * np.std(curves, axis=0))
    print(f"band over scatter: median {np.median(ratio):.2f}, worst {np.max(ratio):.1f}")
    assert 0.8 < np.median(ratio) < 1.3
    # With Student's factor 12.7 for one degree of freedom, the maximum ratio was larger by a factor of 6.5.
    assert np.max(ratio) < 6.0


def test_spline_file_closes_at_zero_and_notes_rejection(printed_spline_fit):
    table = characteristic_table(printed_spline_fit)
    assert "the data contradict a C(x) that never falls" in table["note"]
    assert characteristic_from_mapping(table, name="mine").sonic_conductance_at(0.0) == 0.0


def test_closing_beyond_first_test_is_rejected(printed_fit, tmp_path):
    result = printed_fit
    with refused("characteristic.closing", "closing", kind=OutOfRangeError):
        characteristic_table(result, closing=1e-4)
    assert characteristic_table(result, closing=2e-5)["closing"] == "0.02 mm"
    with refused("characteristic.other_method"):
        write_characteristic(flow_result(), tmp_path / "mine.toml")


def test_invalid_curves_are_reported_and_not_written(tmp_path):
    tests = simulate_tests(rising_conductance, lambda x: 0.4 - 300.0 * x, u_ratio=0.001)
    result = identify_characteristic(tests, domain=(0.0, 1.5e-3), degree_conductance=3, degree_ratio=1)
    assert any("b is negative" in text for text in result.findings)
    with refused("curves.impossible_value", "characteristic.critical_ratio"):
        write_characteristic(result, tmp_path / "mine.toml")
    assert not (tmp_path / "mine.toml").exists()


LIST = """
circuit = "bench.toml"
title = "bench 3"
domain = ["0 mm", "1 mm"]
[recording]
time = { column = "t", unit = "s" }
"tank.pressure" = { column = "p", unit = "bar" }
start = { "tank.initial_pressure" = "first" }
[free]
"tank.wall_conductance" = { start = "5 W/K" }
[[tests]]
stroke = "0.5 mm"
file = "a.csv"
[[tests]]
stroke = "0.6 mm"
result = "flow.toml"
[[tests]]
stroke = "0.7 mm"
sonic_conductance = "1.2 dm^3/(s bar)"
u_sonic_conductance = "0.01 dm^3/(s bar)"
critical_ratio = 0.4
u_critical_ratio = 0.01
"""
CIRCUIT = """
[parts.tank]
kind = "chamber"
volume = "10 l"
[parts.valve]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = 1e-8
critical_ratio = 0.3
"""


@pytest.fixture
def file_folder(tmp_path):
    (tmp_path / "tests.toml").write_text(LIST)
    (tmp_path / "bench.toml").write_text(CIRCUIT)
    flow_result().save(tmp_path / "flow.toml")
    rows = "".join(f"{0.1 * k:.1f},{7.0 * 0.97**k:.5f}\n" for k in range(40))
    (tmp_path / "a.csv").write_text("t,p\n" + rows)
    return tmp_path


def test_file_is_read_to_tests_and_options(file_folder):
    tests, options = read_characteristic_file(file_folder / "tests.toml")
    assert [type(t) for t in tests] == [StrokeRecording, StrokePoint, StrokePoint]
    assert tests[0].measurement.channels[0].values[0] == pytest.approx(7e5)
    assert [f.name for f in tests[0].free] == ["tank.wall_conductance"]
    assert tests[1].u_sonic_conductance == 1e-10
    assert tests[2].sonic_conductance == pytest.approx(1.2e-8)
    assert options["domain"] == (0.0, 1e-3)
    assert options["common"] == pytest.approx((0.017, 0.015))
    assert options["title"] == "bench 3"
    (file_folder / "tests.toml").write_text(LIST.replace('"bench 3"', "inf"))
    assert read_characteristic_file(file_folder / "tests.toml")[1]["title"] == "inf"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('title = "bench 3"', 'titel = "bench 3"', "fields.unknown"),
        ('stroke = "0.5 mm"', "", "fields.missing"),
        ('file = "a.csv"', 'file = "a.csv"\nresult = "flow.toml"', "stroke.one_way"),
        ('file = "a.csv"', "", "stroke.one_way"),
        ("u_critical_ratio = 0.01", "", "fields.missing"),
        ("u_critical_ratio = 0.01", "u_critical = 0.01", "fields.unknown"),
        ('circuit = "bench.toml"', "", "characteristic.free_without_circuit"),
        ('domain = ["0 mm", "1 mm"]', "domain = 1", "characteristic.no_strokes"),
        ("[[tests]]", "[[test]]", "characteristic.no_tests"),
        ('title = "bench 3"', "title = bench", "toml.invalid"),
    ],
)
def test_invalid_files_are_rejected(file_folder, old, new, message):
    (file_folder / "tests.toml").write_text(LIST.replace(old, new))
    with refused(message):
        read_characteristic_file(file_folder / "tests.toml")
