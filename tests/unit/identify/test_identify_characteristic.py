"""Characteristics from tests: shapes, evidence, verdicts, files, bad input."""

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
    evidence_of,
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


def points(conductance, ratio, strokes=STROKES, noise=0.002, u_ratio=0.004, seed=1):
    """Tests with the given truth: C with relative noise, b with absolute noise, both stated."""
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


def rising(x):
    return 1.6e-8 * np.tanh(3e3 * x)


def level(x):
    return 0.4 + 0.0 * x


PRINTED = points(TABLE.sonic_conductance_at, TABLE.critical_ratio_at)
RISING = points(rising, level)


@pytest.fixture(scope="module")
def printed():
    """Polynomials of Table 1's points."""
    return identify_characteristic(PRINTED)


@pytest.fixture(scope="module")
def printed_spline():
    return identify_characteristic(PRINTED, form="spline")


@pytest.fixture(scope="module")
def rising_spline():
    return identify_characteristic(RISING, form="spline", part="valve")


# Shapes ------------------------------------------------------------------------------------------------------------


@HARD
@given(st.integers(0, 9), st.floats(0.0, 0.4), st.integers(0, 1000))
def test_coefficients_are_those_of_the_chebyshev_series(degree, first, seed):
    shape = PolynomialShape(degree, (first * 1e-3, 1e-3), 1e-8)
    theta = np.random.default_rng(seed).standard_normal(shape.size)
    x = np.linspace(*shape.domain, 20)
    direct = np.polyval(shape.numbers(theta), 1e3 * x)
    rounding = np.sum(np.abs(shape.numbers(theta)))
    assert np.max(np.abs(direct - shape.values(theta, x))) < 1e-13 * rounding


@HARD
@given(st.lists(st.floats(0.0, 1.0), min_size=3, max_size=8))
def test_rising_spline_rises_and_is_the_curve_of_a_table(increments):
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
def test_slopes_of_a_spline_are_its_derivatives(rises):
    shape = SplineShape((0.1e-3, 0.3e-3, 0.6e-3, 1e-3), rises, scale=2.0, last=1.2e-3)
    theta, x = np.array([0.2, 0.3, 0.25, 0.15]), np.linspace(0.1e-3, 1.2e-3, 7)
    for k, column in enumerate(shape.slopes(theta, x).T):
        step = 1e-5 * np.eye(4)[k]
        central = (shape.values(theta + step, x) - shape.values(theta - step, x)) / 2e-5
        assert np.max(np.abs(column - central)) < 1e-4


def test_spline_is_held_after_its_last_knot_and_goes_straight_on_before_its_first():
    shape = SplineShape((0.2e-3, 0.4e-3, 0.8e-3), False, first=0.1e-3, last=1e-3)
    assert shape.numbers(np.array([0.2, 0.4, 0.6])) == pytest.approx([0.1, 0.2, 0.4, 0.6, 0.6])
    assert shape.numbers(np.array([0.1, 0.4, 0.6]))[0] == 0.0


def test_pchip_passes_through_its_points():
    at = (0.0, 1.0, 3.0, 4.0)
    assert pchip(at, np.array([1.0, 3.0, 2.0, 2.5]), np.array(at)).tolist() == [1.0, 3.0, 2.0, 2.5]


# Evidence ----------------------------------------------------------------------------------------------------------


@HARD
@given(st.floats(-0.95, 0.95))
def test_evidence_keeps_the_covariance_of_a_point(correlation):
    point = StrokePoint(1e-3, 1e-8, 0.4, 1e-10, 0.02, correlation)
    scaled = evidence_of(point, "").root * np.array([1e-10, 0.02])
    expected = np.array([[1.0, correlation], [correlation, 1.0]])
    assert np.max(np.abs(np.linalg.inv(scaled.T @ scaled) - expected)) < 1e-9
    assert evidence_of(point, "").uncertainty == pytest.approx([1e-10, 0.02])


def test_a_test_without_b_counts_for_c_only():
    blind = evidence_of(StrokePoint(1e-3, 1e-8, float("nan"), 1e-10, float("inf")), "")
    assert blind.uncertainty.tolist() == [pytest.approx(1e-10), float("inf")]


# Fits --------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("joint", [False, True])
def test_points_give_table_1_back(joint):
    series = identify_characteristic(PRINTED, joint=joint).series
    x = series["sonic_conductance"]["x"]
    assert np.max(np.abs(series["sonic_conductance"]["y"] / TABLE.sonic_conductance_at(x) - 1.0)) < 0.01
    assert np.max(np.abs(series["critical_ratio"]["y"] - TABLE.critical_ratio_at(x))) < 0.02


# The 13 coefficients of one seed err together, so that few seeds scatter widely.
@pytest.mark.parametrize(
    ("seeds", "low", "high"), [(12, 0.75, 1.0), pytest.param(60, 0.9, 0.99, marks=pytest.mark.slow)]
)
def test_intervals_of_coefficients_cover(seeds, low, high):
    """Over many seeds, 95 % intervals of all 13 coefficients."""
    truth = [float(n) for n in (*TABLE.sonic_conductance.numbers().values(), *TABLE.critical_ratio.numbers().values())]
    hits = []
    for seed in range(seeds):
        tests = points(TABLE.sonic_conductance_at, TABLE.critical_ratio_at, seed=seed)
        found = identify_characteristic(tests).parameters.values()
        hits += [e.low <= value <= e.high for e, value in zip(found, truth, strict=True)]
    assert low < np.mean(hits) < high


@pytest.mark.parametrize(("draws", "tolerance"), [(100, 0.4), pytest.param(400, 0.2, marks=pytest.mark.slow)])
def test_bands_of_bootstrap_and_delta_method_agree_for_polynomials(printed, draws, tolerance):
    bands = [r.series["critical_ratio"] for r in (printed, identify_characteristic(PRINTED, bootstrap=draws))]
    widths = [band["high"] - band["low"] for band in bands]
    assert np.max(np.abs(widths[1] / widths[0] - 1.0)) < tolerance


def test_a_rising_c_is_not_rejected(rising_spline):
    result = rising_spline
    assert not result.comparison["monotone"]["rejected"]
    assert result.findings[0].startswith("The data do not reject a C that never falls")
    curve = result.series["sonic_conductance"]
    tested = curve["x"] >= STROKES[0]
    assert np.max(np.abs(curve["y"] - rising(curve["x"]))[tested]) < 0.02 * 1.6e-8
    assert np.min(np.diff(curve["y"])) >= -1e-20


@pytest.mark.slow  # its everyday brother is the test before
@pytest.mark.parametrize("seed", range(5))
def test_false_rejections_are_rare(seed):
    result = identify_characteristic(points(rising, level, seed=100 + seed), form="spline")
    assert not result.comparison["monotone"]["rejected"]


def test_a_falling_c_is_rejected(printed_spline):
    result = printed_spline
    assert result.comparison["monotone"]["rejected"]
    assert undocumented(result) == []
    assert "never falls: C falls by" in result.findings[0]


def test_common_uncertainty_widens_the_band_without_moving_the_curve(printed):
    alone, shared = printed, identify_characteristic(PRINTED, common=(0.02, 0.03))
    first, second = alone.series["sonic_conductance"], shared.series["sonic_conductance"]
    assert np.max(np.abs(first["y"] / second["y"] - 1.0)) < 1e-12
    assert np.min((second["high"] - second["low"]) / second["y"]) > 2 * 1.95 * 0.02
    ratio = shared.series["critical_ratio"]
    assert np.min(ratio["high"] - ratio["low"]) > 2 * 1.95 * 0.03


def test_scatter_beyond_the_stated_uncertainty_widens_and_is_said(printed):
    optimistic = [replace(p, u_sonic_conductance=p.u_sonic_conductance / 10.0) for p in PRINTED]
    result = identify_characteristic(optimistic)
    assert any("times their uncertainties" in text for text in result.findings)
    wide, narrow = (r.parameters["sonic_conductance.k8"].standard_error for r in (result, printed))
    assert wide > 0.5 * narrow


def test_blind_tests_gaps_repeats_and_reach_are_said():
    tests = [replace(p, critical_ratio=float("nan"), u_critical_ratio=float("inf")) if k == 3 else p
             for k, p in enumerate(PRINTED) if k not in (8, 9, 10)]  # fmt: skip
    tests.append(replace(tests[5], sonic_conductance=1.1 * tests[5].sonic_conductance, name="again"))
    said = " ".join(identify_characteristic(tests, degree_conductance=5, domain=(0.0, 1e-3)).findings)
    assert "1 of 13 tests do not determine b (t3)" in said
    assert "No test is between" in said
    assert "(t5 and again)" in said
    assert "The domain extends to 0 mm, but the tests only to 0.05 mm" in said


# Recordings --------------------------------------------------------------------------------------------------------

BENCH = Circuit(
    {
        "tank": Chamber(volume="10 l", wall_conductance=8.0, initial_pressure="7 bar"),
        "room": Reservoir(pressure="1 bar"),
        "valve": Orifice(from_="tank", to="room", sonic_conductance=1e-8, critical_ratio=0.3),
    }
)


def recording(stroke, seed, free=()):
    truth = BENCH.with_values({"valve.sonic_conductance": 1e-8 * (0.5 + 1e3 * stroke), "valve.critical_ratio": 0.4})
    run = truth.simulate(duration=30.0, output_step=0.1)
    noise = 300.0 * np.random.default_rng(seed).standard_normal(run.time.size)
    channel = Channel("tank.pressure", run.time, run["tank.pressure"] + noise, "Pa", noise=300.0)
    stated = dict.fromkeys(("tank.initial_temperature", "room.temperature", "ambient.temperature"), "20 degC")
    bench = BENCH.with_values({"tank.wall_conductance": 5.0, **stated})
    return StrokeRecording(stroke, bench, Measurement(f"r{seed}", (channel,), duration=30.0), free=free)


def test_numbers_among_recordings_are_said_to_count_as_numbers_only():
    tests = [recording(x, k) for k, x in enumerate((0.2e-3, 0.5e-3, 0.8e-3))]
    number = StrokePoint(1e-3, 1.5e-8, 0.4, 1.5e-10, 0.01, name="flow bench")
    mixed = identify_characteristic([*tests, number], degree_conductance=1, degree_ratio=0, joint=False)
    said = [sentence for sentence in mixed.findings if "1 of 4 tests contribute only C and b" in sentence]
    assert len(said) == 1
    assert "(flow bench)" in said[0]
    alone = identify_characteristic(tests, degree_conductance=1, degree_ratio=0, joint=False)
    assert not any("enter through C and b" in sentence for sentence in alone.findings)


def test_joint_fit_shares_the_bench_among_the_tests():
    wall = (read_free("tank.wall_conductance", {}, BENCH),)
    tests = [recording(x, k, wall) for k, x in enumerate((0.2e-3, 0.5e-3, 0.8e-3, 1e-3))]
    result = identify_characteristic(tests, degree_conductance=1, degree_ratio=0)
    shared = result.parameters["tank.wall_conductance"]
    assert shared.low < 8.0 < shared.high
    alone = min(float(np.sqrt(np.diag(np.linalg.inv(o.jacobian.T @ o.jacobian)))[2])
                for o in (evidence_of(t, "").optimum for t in tests))  # fmt: skip
    assert shared.standard_error < alone
    assert result.parameters["sonic_conductance.k1"].value == pytest.approx(1e-8, rel=0.02)
    assert result.comparison["degrees_of_freedom"] == 8 - 3 + 3


def test_evidence_of_a_recording_agrees_with_its_own_fit():
    wall = (read_free("tank.wall_conductance", {}, BENCH),)
    found = evidence_of(recording(0.5e-3, 7, wall), "r")
    inverse = np.linalg.inv(found.optimum.jacobian.T @ found.optimum.jacobian)
    assert found.uncertainty == pytest.approx(np.sqrt(np.diag(inverse)[:2] * found.widening), rel=1e-6)
    assert np.max(np.abs(found.centre - [1e-8, 0.4]) / found.uncertainty) < 4.0


def test_free_lags_and_unknown_passages_are_refused():
    test = recording(0.5e-3, 7)
    lagging = replace(test.measurement, channels=(replace(test.measurement.channels[0], lag=None),))
    with refused("stroke.free_sensor", "tank.pressure"):
        identify_characteristic([replace(test, measurement=lagging)])
    with refused("stroke.unknown_passage"):
        identify_characteristic([replace(test, passage="value")])
    with refused("stroke.no_own_numbers"):
        identify_characteristic([replace(test, passage="tank")])


# Bad input ---------------------------------------------------------------------------------------------------------


def test_too_few_strokes_for_the_degree():
    with refused("characteristic.too_few_for_polynomial", tests=8, strokes=8, degrees=(7, 4)):
        identify_characteristic(PRINTED[:8])


@pytest.mark.parametrize("form", ["polynomial", "spline"])
def test_a_ratio_that_no_test_tells_is_refused(form):
    """All recordings choked: there is no curve of b."""
    blind = [StrokePoint(x, 1e-8, math.nan, 1e-10, math.inf) for x in np.linspace(1e-4, 9e-4, 6)]
    with refused("characteristic.ratio_unseen", strokes=0, of=6):
        identify_characteristic(blind, form=form, degree_conductance=2, degree_ratio=1)


def test_one_recording_is_one_stroke():
    one = recording(3e-4, 1)
    with refused("stroke.same_twice", test="r1", other="r1"):
        identify_characteristic([one, replace(one, stroke=5e-4)])


def test_repeated_strokes_count_once():
    with refused("characteristic.too_few_for_polynomial", tests=16, strokes=8):
        identify_characteristic(PRINTED[:8] * 2)


def test_repeated_names_are_kept_apart():
    assert len(identify_characteristic([*PRINTED, PRINTED[3]]).conditions["tests"]) == 16


def test_no_tests():
    with refused("characteristic.too_few_for_polynomial", tests=0, strokes=0):
        identify_characteristic([])


def test_strokes_outside_the_domain():
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
def test_impossible_points(field, value):
    with refused(f"stroke.{field}" if field != "stroke" else "stroke.not_finite", test="t4"):
        identify_characteristic([*PRINTED[:4], replace(PRINTED[4], **{field: value}), *PRINTED[5:]])


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"form": "splne"}, "fields.not_an_option"),
        ({"degree_conductance": -1}, "characteristic.degree"),
        ({"degree_ratio": 2.5}, "characteristic.degree"),
        ({"domain": (1e-3, 0.0)}, "characteristic.empty_domain"),
        ({"domain": (float("nan"), 1.0)}, "characteristic.empty_domain"),
        ({"common": (-0.1, 0.0)}, "characteristic.common"),
        ({"bootstrap": 10}, "characteristic.bootstrap"),
        ({"form": "spline", "knots": (1e-3, 0.5e-3)}, "characteristic.knots"),
        ({"form": "spline", "knots": (0.1e-3, 2e-3)}, "characteristic.knots"),
    ],
)
def test_impossible_options(options, message):
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


def test_result_of_a_flow_bench_is_split_into_own_and_common_uncertainty():
    point = point_of_result(flow_result(), 0.5e-3, part="valve", name="a")
    assert (point.u_sonic_conductance, point.u_critical_ratio) == (1e-10, 0.01)
    assert common_of_result(flow_result(), part="valve") == pytest.approx((0.017, 0.015))


def test_result_without_b_gives_a_blind_point():
    lost = {"valve.critical_ratio": Estimate(float("nan"), "1", float("inf"), 0.3, 1.0, "not determined")}
    point = point_of_result(flow_result(**lost), 0.5e-3, part="valve")
    assert np.isnan(point.critical_ratio)
    assert np.isinf(point.u_critical_ratio)
    with refused("stroke.not_in_result", "sonic_conductance"):
        point_of_result(flow_result(), 0.5e-3)


# Files -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("form", ["polynomial", "spline"])
def test_written_characteristic_is_the_fitted_one(form, rising_spline, tmp_path):
    result = rising_spline if form == "spline" else identify_characteristic(RISING, part="valve")
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


def test_a_spline_holds_where_it_was_tested(printed_spline):
    assert printed_spline.conditions["domain"] == pytest.approx([STROKES[0], STROKES[-1]])
    assert not [note for note in printed_spline.remarks if note.code == "characteristic.continued"]


def test_every_tested_stroke_may_be_a_knot():
    strokes = np.linspace(0.05e-3, 1e-3, 12)
    tests = points(rising, lambda x: 0.4 - 100.0 * x, strokes)
    found = identify_characteristic(tests, form="spline", knots=tuple(strokes))
    values = [found.parameters[f"sonic_conductance.y{k}"].value for k in range(12)]
    assert values == pytest.approx([test.sonic_conductance for test in tests], rel=0.005)
    halves = [(e.high - e.value) / e.value for e in found.parameters.values() if e.unit != "1"]
    assert max(halves) < 0.02
    with refused("characteristic.too_few_for_spline"):
        identify_characteristic(tests[:-1], form="spline", knots=(*strokes[:-1], 0.97e-3))


def test_the_band_of_few_tests_is_as_wide_as_their_fits_scatter():
    """Six knots for seven strokes leave one degree of freedom: neither it nor chance may blow the band up."""
    strokes = np.linspace(0.05e-3, 1e-3, 7)
    knots, x = tuple(strokes[[0, 1, 2, 3, 5, 6]]), np.linspace(0.1e-3, 0.95e-3, 30)
    # A truth that the spline can follow.
    truth = identify_characteristic(points(rising, lambda _: 0.4, strokes), form="spline", knots=knots).series

    def curve(name):
        return lambda at: np.interp(at, truth[name]["x"], truth[name]["y"])

    drawn, halves = [], []
    for seed in range(30):
        tests = points(curve("sonic_conductance"), curve("critical_ratio"), strokes, noise=0.01, seed=seed)
        band = identify_characteristic(tests, form="spline", knots=knots).series["sonic_conductance"]
        drawn.append(np.interp(x, band["x"], band["y"]))
        halves.append(np.interp(x, band["x"], 0.5 * (band["high"] - band["low"])))
    ratio = np.array(halves) / (1.96 * np.std(drawn, axis=0))
    print(f"band over scatter: median {np.median(ratio):.2f}, worst {np.max(ratio):.1f}")
    assert 0.8 < np.median(ratio) < 1.3
    # Where chance makes the misfit look too large: 12.7 of Student with one degree of freedom made it 6.5 times more.
    assert np.max(ratio) < 6.0


def test_spline_file_is_closed_at_zero_and_says_what_was_rejected(printed_spline):
    table = characteristic_table(printed_spline)
    assert "the data reject a C that never falls" in table["note"]
    assert characteristic_from_mapping(table, name="mine").sonic_conductance_at(0.0) == 0.0


def test_closing_must_not_reach_into_the_tests(printed, tmp_path):
    result = printed
    with refused("characteristic.closing", "closing", kind=OutOfRangeError):
        characteristic_table(result, closing=1e-4)
    assert characteristic_table(result, closing=2e-5)["closing"] == "0.02 mm"
    with refused("characteristic.other_method"):
        write_characteristic(flow_result(), tmp_path / "mine.toml")


def test_impossible_curves_are_said_and_not_written(tmp_path):
    result = identify_characteristic(points(rising, lambda x: 0.4 - 300.0 * x, u_ratio=0.001), domain=(0.0, 1.5e-3),
                                     degree_conductance=3, degree_ratio=1)  # fmt: skip
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
def folder(tmp_path):
    (tmp_path / "tests.toml").write_text(LIST)
    (tmp_path / "bench.toml").write_text(CIRCUIT)
    flow_result().save(tmp_path / "flow.toml")
    rows = "".join(f"{0.1 * k:.1f},{7.0 * 0.97**k:.5f}\n" for k in range(40))
    (tmp_path / "a.csv").write_text("t,p\n" + rows)
    return tmp_path


def test_list_of_tests(folder):
    tests, options = read_characteristic_file(folder / "tests.toml")
    assert [type(t) for t in tests] == [StrokeRecording, StrokePoint, StrokePoint]
    assert tests[0].measurement.channels[0].values[0] == pytest.approx(7e5)
    assert [f.name for f in tests[0].free] == ["tank.wall_conductance"]
    assert tests[1].u_sonic_conductance == 1e-10
    assert tests[2].sonic_conductance == pytest.approx(1.2e-8)
    assert options["domain"] == (0.0, 1e-3)
    assert options["common"] == pytest.approx((0.017, 0.015))
    assert options["title"] == "bench 3"
    (folder / "tests.toml").write_text(LIST.replace('"bench 3"', "inf"))
    assert read_characteristic_file(folder / "tests.toml")[1]["title"] == "inf"


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
def test_mistakes_in_a_list_of_tests(folder, old, new, message):
    (folder / "tests.toml").write_text(LIST.replace(old, new))
    with refused(message):
        read_characteristic_file(folder / "tests.toml")
