"""Curves and characteristics: values, edges, closing, running maximum, tables of a circuit file, messages."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from poppet.core.errors import InputError, InputErrors, OutOfRangeError
from poppet.core.provenance import Number, Source, assumed
from poppet.laws.curves import (
    Characteristic,
    ConstantCurve,
    PolynomialCurve,
    TableCurve,
    characteristic_from_mapping,
    pchip_slopes,
    rising_intervals,
)
from refusals import refused

MILLIMETRE = 1e-3


def plain(*values: float, unit: str = "1") -> tuple[Number, ...]:
    return tuple(assumed(value, unit, "test") for value in values)


def table(*values: float) -> TableCurve:
    return TableCurve(tuple(MILLIMETRE * i for i in range(len(values))), plain(*values))


def characteristic(curve=None, **options) -> Characteristic:
    chosen = curve if curve is not None else PolynomialCurve(plain(1e-8, 2e-8, 1e-9))
    ratio = ConstantCurve(*plain(0.35))
    return Characteristic(chosen, ratio, **{"domain": (0.0, MILLIMETRE), "name": "bench", **options})


def symbolic_value(function, x: float, parameters: dict[str, float]) -> float:
    """The value through a CasADi function in which the stroke and every parameter are symbols."""
    stroke = ca.SX.sym("x")
    symbols = {name: ca.SX.sym(name) for name in parameters}
    traced = ca.Function("f", [stroke, *symbols.values()], [function(stroke, symbols)])
    return float(traced(x, *parameters.values()))


# --- curves ---


def test_polynomial_is_evaluated_in_millimetres():
    curve = PolynomialCurve(plain(2.0, 3.0, 4.0))
    assert curve(0.5 * MILLIMETRE) == 2.0 * 0.25 + 3.0 * 0.5 + 4.0


def test_polynomial_argument_scale():
    assert PolynomialCurve(plain(1.0, 0.0), argument_scale=1.0)(0.25) == 0.25


def test_numbers_have_the_letters_of_the_paper():
    assert list(PolynomialCurve(plain(1.0, 2.0), letter="p").numbers()) == ["p1", "p2"]
    assert list(table(1.0, 2.0, 3.0).numbers()) == ["y0", "y1", "y2"]
    assert list(ConstantCurve(*plain(1.0)).numbers()) == ["value"]


@pytest.mark.parametrize("values", [(0.0, 1.0), (0.0, 1.0, 4.0, 4.5), (3.0, 1.0, 2.0, 2.0, 5.0), (1.0, 5.0, 0.0)])
def test_table_agrees_with_scipy(values):
    curve = table(*values)
    x = np.linspace(0.0, curve.strokes[-1], 501)
    expected = PchipInterpolator(curve.strokes, values)(x)
    assert np.max(np.abs(curve(x) - expected)) <= 4e-15 * max(values)


def test_pchip_slopes_agree_with_scipy_where_ends_are_limited():
    x, y = [0.0, 1.0, 3.0, 3.5, 7.0], [0.0, 5.0, 4.9, 4.9, -20.0]
    expected = PchipInterpolator(x, y).derivative()(x)
    assert np.max(np.abs(np.array(pchip_slopes(x, y)) - expected)) <= 1e-14 * np.max(np.abs(expected))


def test_table_holds_its_ends():
    curve = table(1.0, 2.0, 5.0)
    assert curve(-1.0) == 1.0
    assert curve(1.0) == 5.0


@pytest.mark.parametrize("knot", range(5))
def test_table_has_one_derivative_on_a_knot(knot):
    """A tie of two clips neither loses nor doubles the slope; at the ends it lies between that and none."""
    values = (0.0, 2.0, 4.5, 6.0, 9.0)
    curve = table(*values)
    x = ca.SX.sym("x")
    derivative = ca.Function("slope", [x], [ca.jacobian(curve(x), x)])
    at_knot, slope = float(derivative(curve.strokes[knot])), pchip_slopes(curve.strokes, values)[knot]
    assert slope > 1000.0
    if 0 < knot < 4:
        assert at_knot == pytest.approx(slope, rel=1e-12)
    else:
        assert 0.0 <= at_knot <= slope * (1.0 + 1e-12)


@pytest.mark.parametrize(
    "curve", [ConstantCurve(*plain(2.0)), PolynomialCurve(plain(1.0, -2.0, 3.0)), table(1.0, 3.0, 2.0, 4.0)]
)
def test_curve_takes_floats_arrays_and_symbols(curve):
    x = np.array([-0.2, 0.0, 0.3, 1.0, 1.7, 3.0, 4.0]) * MILLIMETRE
    array = curve(x)
    assert array.shape == x.shape
    assert np.array_equal(array, [curve(float(each)) for each in x])
    traced = [symbolic_value(curve.evaluate, float(each), curve.parameters()) for each in x]
    assert np.max(np.abs(array - traced)) <= 1e-14 * np.max(np.abs(array))


def test_parameters_keep_their_names_when_values_change():
    for flat, hilly in ((table(1.0, 1.0, 1.0, 1.0), table(0.0, 2.0, 1.0, 3.0)),):
        assert list(flat.parameters()) == list(hilly.parameters())


def test_with_numbers_replaces_and_refuses():
    curve = PolynomialCurve(plain(1.0, 2.0))
    assert curve.with_numbers({"k2": assumed(5.0, "1", "test")})(0.0) == 5.0
    with refused("names.unknown", "k3"):
        curve.with_numbers({"k3": assumed(5.0, "1", "test")})


def test_table_reports_all_mistakes_at_once():
    with pytest.raises(InputErrors) as caught:
        TableCurve((0.0, 2e-3, 1e-3), plain(1.0, 2.0))
    assert [type(problem) for problem in caught.value.problems] == [InputError, InputError]
    assert "2 values for 3 strokes do not match" in str(caught.value)
    assert "Stroke 3 = 1 mm must be larger than the stroke before it, 2 mm." in str(caught.value)


def test_table_of_one_point_is_refused():
    with refused("curves.too_few_points", "stroke"):
        TableCurve((0.0,), plain(1.0))


def test_empty_polynomial_is_refused():
    with refused("curves.no_coefficients"):
        PolynomialCurve(())


@pytest.mark.parametrize("scale", [0.0, -1.0, math.inf, math.nan])
def test_polynomial_scale_must_be_positive(scale):
    with refused("curves.argument_scale", "argument_scale"):
        PolynomialCurve(plain(1.0), argument_scale=scale)


# --- edges ---


def test_outside_the_domain_the_edge_is_held():
    held = characteristic()
    assert held.sonic_conductance_at(-1.0) == held.sonic_conductance_at(0.0)
    assert held.sonic_conductance_at(2 * MILLIMETRE) == held.sonic_conductance_at(MILLIMETRE)


def test_error_edge_names_value_limit_source_and_cure():
    strict = characteristic(edge="error", name="varga2012", source=Source("paper", "Table 1"))
    with pytest.raises(OutOfRangeError) as caught:
        strict.sonic_conductance_at(1.2 * MILLIMETRE)
    assert str(caught.value) == (
        "stroke = 1.20 mm is outside the range 0 ... 1.00 mm, in which C(x) was fitted (varga2012, Table 1). "
        'At this stroke, the polynomial would give C = 3.94e-08 m^3/(s Pa). Limit the stroke, or set edge = "hold" '
        "to use the value at the nearest end of the range."
    )


def test_error_edge_of_a_table_promises_no_polynomial():
    strict = characteristic(table(1e-9, 2e-9), edge="error")
    with refused("curves.outside", kind=OutOfRangeError):
        strict.sonic_conductance_at(-1e-6)


def test_error_edge_names_the_worst_stroke_of_an_array():
    strict = characteristic(edge="error")
    with refused("curves.outside", kind=OutOfRangeError):
        strict.critical_ratio_at(np.array([0.5, 1.2, 1.5, -0.1]) * MILLIMETRE)


def test_error_edge_shows_digits_enough():
    with refused("curves.outside_polynomial", kind=OutOfRangeError):
        characteristic(edge="error").sonic_conductance_at(1.00001 * MILLIMETRE)


def test_error_edge_allows_the_edges_and_a_closed_passage():
    strict = characteristic(edge="error", closing=assumed(2e-5, "m", "test"))
    assert strict.sonic_conductance_at(MILLIMETRE) > 0.0
    assert strict.sonic_conductance_at(-MILLIMETRE) == 0.0


def test_error_edge_holds_on_symbols():
    strict = characteristic(edge="error")
    traced = symbolic_value(strict.sonic_conductance_at, 2 * MILLIMETRE, strict.parameters())
    assert traced == pytest.approx(strict.sonic_conductance_at(MILLIMETRE), rel=1e-15)


def test_nan_is_not_held():
    with refused("curves.not_a_number", "stroke"):
        characteristic().sonic_conductance_at(math.nan)


def test_extrapolation_is_not_offered():
    with refused("fields.not_an_option"):
        characteristic(edge="extrapolate")


@pytest.mark.parametrize(
    ("low", "high", "reported"),
    [(0.0, 1.0, False), (0.0, 1.009, False), (0.0, 1.011, True), (-0.009, 0.5, False), (-0.02, 0.5, True)],
)
def test_outside_tolerates_one_per_cent_of_the_width(low, high, reported):
    assert (characteristic().outside(low * MILLIMETRE, high * MILLIMETRE) is not None) == reported


def test_outside_says_what_was_held():
    note = characteristic().outside(0.0, 1.2 * MILLIMETRE)
    assert note.code == "curves.left_domain"
    assert (note.facts["strokes_mm"], note.facts["beyond_mm"]) == (pytest.approx((1.2,)), pytest.approx(0.2))
    assert (note.facts["domain"], note.facts["known"]) == ("0 ... 1.00 mm", "C(x) was fitted (bench)")


def test_outside_on_both_sides_says_by_how_much_the_farther_one_is_beyond():
    note = characteristic().outside(-0.1 * MILLIMETRE, 1.2 * MILLIMETRE)
    assert (note.facts["strokes_mm"], note.facts["beyond_mm"]) == (pytest.approx((-0.1, 1.2)), pytest.approx(0.2))


@pytest.mark.parametrize(
    ("stop", "high", "reported"), [(1.0, 1.04, False), (1.0, 1.06, True), (0.9, 1.02, False), (1.1, 1.04, True)]
)
def test_what_a_stop_gives_way_is_no_stroke(stop, high, reported):
    """Only of a stop that stands within the domain: behind one beyond it the plate itself is outside."""
    stops = (-MILLIMETRE, stop * MILLIMETRE)
    assert (characteristic().outside(0.0, high * MILLIMETRE, stops) is not None) == reported


def test_a_closed_passage_is_not_outside():
    assert characteristic(closing=assumed(2e-5, "m", "test")).outside(-MILLIMETRE, MILLIMETRE) is None


# --- closing ---


def test_closing_is_zero_up_to_zero_and_one_beyond_its_width():
    bare, closed = characteristic(), characteristic(closing=assumed(2e-5, "m", "test"))
    assert closed.sonic_conductance_at(0.0) == 0.0
    assert closed.sonic_conductance_at(-1e-4) == 0.0
    assert closed.sonic_conductance_at(1e-5) == pytest.approx(0.5 * bare.sonic_conductance_at(1e-5), rel=1e-14)
    assert closed.sonic_conductance_at(2e-5) == bare.sonic_conductance_at(2e-5)


def test_closing_leaves_the_ratio_alone():
    assert characteristic(closing=assumed(2e-5, "m", "test")).critical_ratio_at(0.0) == 0.35


@pytest.mark.parametrize("width", [0.0, -1e-5, math.inf])
def test_closing_must_be_a_positive_width(width):
    with refused("curves.closing"):
        characteristic(closing=assumed(width, "m", "test"))


# --- running maximum ---


def test_monotone_stays_at_each_maximum_until_it_is_passed():
    hills = table(1.0, 3.0, 2.0, 5.0, 1.0)
    run = characteristic(hills, domain=hills.support, monotone=True)
    x = np.linspace(0.0, 4 * MILLIMETRE, 4001)
    expected = np.maximum.accumulate(hills(x))
    assert np.max(np.abs(run.sonic_conductance_at(x) - expected)) <= 1e-14


def test_monotone_on_symbols():
    hills = table(1.0, 3.0, 2.0, 5.0, 1.0)
    run = characteristic(hills, domain=hills.support, monotone=True)
    for x in np.linspace(-1.0, 5.0, 61) * MILLIMETRE:
        traced = symbolic_value(run.sonic_conductance_at, float(x), run.parameters())
        assert traced == pytest.approx(run.sonic_conductance_at(float(x)), rel=1e-14)


def test_monotone_of_a_falling_curve_is_its_start():
    falling = table(3.0, 2.0, 1.0)
    run = characteristic(falling, domain=falling.support, monotone=True)
    assert run.sonic_conductance_at(2 * MILLIMETRE) == 3.0


def test_monotone_of_a_constant():
    run = characteristic(ConstantCurve(*plain(1e-8)), domain=(-math.inf, math.inf), monotone=True)
    assert run.sonic_conductance_at(3.0) == 1e-8


def test_monotone_parameters_have_the_same_names_for_any_values():
    hills, slope = table(1.0, 3.0, 2.0, 5.0, 1.0), table(1.0, 2.0, 3.0, 4.0, 5.0)
    names = [list(characteristic(c, domain=c.support, monotone=True).parameters()) for c in (hills, slope)]
    assert names[0] == names[1]


def test_rising_intervals_find_where_the_level_is_passed_again():
    cubic = PolynomialCurve(plain(1.0, -6.0, 9.0, 0.0), argument_scale=1.0)  # maximum 4 at 1, again 4 at 4
    (first, second) = rising_intervals(cubic, 0.0, 5.0)
    assert first == pytest.approx((0.0, 1.0), abs=1e-12)
    assert second == pytest.approx((4.0, 5.0), abs=1e-12)


# --- numbers ---


def test_numbers_and_parameters_are_addressed_by_curve():
    closed = characteristic(closing=assumed(2e-5, "m", "test"))
    names = [
        "sonic_conductance.k1",
        "sonic_conductance.k2",
        "sonic_conductance.k3",
        "critical_ratio.value",
        "closing",
    ]
    assert list(closed.numbers()) == names
    assert set(closed.parameters()) == {*names, "domain_start", "domain_end"}


def test_with_numbers_changes_what_is_derived():
    hills = table(1.0, 3.0, 2.0, 2.5)
    run = characteristic(hills, domain=hills.support, monotone=True)
    changed = run.with_numbers({"sonic_conductance.y3": assumed(9.0, "1", "test")})
    assert run.sonic_conductance_at(3 * MILLIMETRE) == 3.0
    assert changed.sonic_conductance_at(3 * MILLIMETRE) == pytest.approx(9.0, rel=1e-15)
    assert run.numbers()["sonic_conductance.y3"].value == 2.5


def test_with_numbers_offers_near_misses():
    with refused("names.unknown", "sonic_conductance.k4"):
        characteristic().with_numbers({"sonic_conductance.k4": assumed(1.0, "1", "test")})


def test_given_parameters_are_used():
    own = characteristic()
    doubled = {name: 2.0 * value if "conductance" in name else value for name, value in own.parameters().items()}
    assert own.sonic_conductance_at(5e-4, doubled) == pytest.approx(2.0 * own.sonic_conductance_at(5e-4), rel=1e-15)


@pytest.mark.parametrize("container", [list, tuple])
def test_sequences_of_strokes(container):
    assert characteristic().sonic_conductance_at(container([0.0, 1e-3])).shape == (2,)


def test_structure_tells_what_is_compiled_in():
    curve = PolynomialCurve(plain(1e-8, 2e-8, 1e-9))
    same = curve.with_numbers({"k1": assumed(3e-8, "1", "test")})
    assert characteristic(curve).structure() == characteristic(same, domain=(0.0, 2e-3)).structure()
    others = [
        characteristic(PolynomialCurve(curve.coefficients, argument_scale=1.0)),
        characteristic(PolynomialCurve(curve.coefficients, letter="p")),
        characteristic(PolynomialCurve(plain(1e-8, 1e-9))),
        characteristic(table(1e-9, 2e-9)),
        characteristic(monotone=True),
        characteristic(closing=assumed(2e-5, "m", "test")),
    ]
    assert len({characteristic().structure(), *(other.structure() for other in others)}) == 7


# --- values that cannot be ---


def test_negative_conductance_is_refused():
    with refused("curves.impossible_value", "sonic_conductance", kind=OutOfRangeError):
        characteristic(PolynomialCurve(plain(-2e-8, 1e-8)))


def test_ratio_of_one_is_refused_wherever_it_lies():
    bump = PolynomialCurve(plain(-4.0, 4.0, 0.0))  # 1 at 0.5 mm, 0 at both ends
    with refused("curves.impossible_value", "critical_ratio", kind=OutOfRangeError):
        Characteristic(ConstantCurve(*plain(1e-8)), bump, domain=(0.0, MILLIMETRE))


def test_a_table_may_end_at_exactly_zero():
    falling = table(1.3e-8, 0.7e-8, 0.1e-8, 0.0)
    assert abs(characteristic(falling, domain=falling.support).sonic_conductance_at(3e-3)) < 1e-22


def test_not_finite_numbers_are_refused():
    with refused("curves.not_finite", "sonic_conductance.k1"):
        characteristic(PolynomialCurve(plain(math.nan, 0.0, 1e-8)))


def test_domain_must_be_ordered():
    with refused("curves.empty_domain"):
        characteristic(domain=(MILLIMETRE, 0.0))


def test_domain_must_not_reach_beyond_a_table():
    with refused("curves.beyond_points", kind=OutOfRangeError):
        characteristic(table(1e-9, 2e-9), domain=(0.0, 2 * MILLIMETRE))


def test_a_polynomial_needs_a_domain():
    with refused("curves.no_domain"):
        characteristic(domain=(-math.inf, math.inf))


# --- tables of a circuit file ---

POLYNOMIAL = {
    "kind": "polynomial",
    "sonic_conductance": [1e-8, 1e-9],
    "critical_ratio": [0.35],
    "argument_unit": "mm",
    "domain": ["0 mm", "1 mm"],
}
TABLE = {
    "kind": "table",
    "stroke": ["0 mm", "0.5 mm", "1 mm"],
    "sonic_conductance": ["0 dm^3/(s bar)", "1.2 dm^3/(s bar)", "1.5 dm^3/(s bar)"],
    "critical_ratio": [0.4, 0.35, 0.3],
}
CONSTANT = {"kind": "constant", "sonic_conductance": "1.2 dm^3/(s bar)", "critical_ratio": 0.3}


def read(table, **changes):
    return characteristic_from_mapping({**table, **changes}, name="valve.characteristic")


def test_read_constant():
    curve = read(CONSTANT)
    assert curve.sonic_conductance_at(0.7) == pytest.approx(1.2e-8, rel=1e-15)
    assert curve.critical_ratio_at(-0.7) == 0.3
    assert curve.numbers()["sonic_conductance.value"].source == Source("given")
    assert curve.numbers()["sonic_conductance.value"].display() == "1.2 dm^3/(s bar)"


def test_read_polynomial():
    curve = read(POLYNOMIAL)
    assert curve.sonic_conductance_at(0.5 * MILLIMETRE) == pytest.approx(6e-9, rel=1e-15)
    assert curve.domain == (0.0, MILLIMETRE)
    assert list(curve.numbers()) == ["sonic_conductance.k1", "sonic_conductance.k2", "critical_ratio.p1"]


def test_read_polynomial_in_metres():
    curve = read(POLYNOMIAL, argument_unit="m", sonic_conductance=[1e-5, 1e-9])
    assert curve.sonic_conductance_at(0.5 * MILLIMETRE) == pytest.approx(6e-9, rel=1e-15)


def test_read_table_with_options():
    curve = read(
        TABLE,
        edge="error",
        closing="20 um",
        monotone=True,
        source="measured, bench 3",
        note="2 May",
        critical_ratio=0.3,
    )
    assert curve.source == Source("measured", "bench 3", "2 May")
    assert {number.source for number in curve.numbers().values()} == {curve.source}
    assert curve.edge == "error"
    assert curve.monotone
    assert curve.numbers()["closing"].value == pytest.approx(2e-5, rel=1e-15)
    assert curve.sonic_conductance_at(0.5 * MILLIMETRE) == pytest.approx(1.2e-8, rel=1e-14)
    assert curve.critical_ratio_at(0.5 * MILLIMETRE) == 0.3


@pytest.mark.parametrize(
    ("table", "changes", "message"),
    [
        (CONSTANT, {"kind": "tabel"}, "kind = 'tabel' is not a kind of characteristic. Did you mean table?"),
        (
            CONSTANT,
            {"sonic_conductanse": 1.0},
            "is not a valid field of a characteristic of kind constant. Did you mean",
        ),
        (
            CONSTANT,
            {"edge": "extrapolate"},
            "edge = 'extrapolate' is not a valid edge policy.",
        ),
        (CONSTANT, {"sonic_conductance": "1.2 kg"}, 'sonic_conductance = "1.2 kg"'),
        (CONSTANT, {"sonic_conductance": [1e-8]}, "sonic_conductance = [1e-08] must be a number"),
        (CONSTANT, {"monotone": "yes"}, "monotone = 'yes' must be true or false."),
        (
            CONSTANT,
            {"source": "messured"},
            'source = "messured" must begin with the kind of the source, for example "measured". Did you mean',
        ),
        (CONSTANT, {"source": 3}, "source = 3 must be text."),
        (
            CONSTANT,
            {"critical_ratio": 1.2},
            "critical_ratio = 1.2 at a stroke of 0 mm is physically impossible: the value of b in",
        ),
        (POLYNOMIAL, {"domain": ["0 mm"]}, "domain = ['0 mm'] must be a list of two values."),
        (POLYNOMIAL, {"argument_unit": "kg"}, "kg"),
        (POLYNOMIAL, {"sonic_conductance": [-2e-8, 1e-8]}, "sonic_conductance = -1e-08"),
        (POLYNOMIAL, {"sonic_conductance": []}, "A polynomial must have at least one coefficient."),
        (TABLE, {"stroke": ["0 mm", "1 mm", "1 mm"]}, "Stroke 3 = 1 mm must be larger than"),
        (TABLE, {"stroke": "0 mm"}, "stroke = '0 mm' must be a list of strokes."),
        (TABLE, {"stroke": ["0 mm", "x", "1 mm"]}, 'stroke[1] = "x"'),
        (TABLE, {"stroke": [], "sonic_conductance": []}, "stroke has 0 points: a table must have at least two points."),
        (TABLE, {"sonic_conductance": [1e-8, 1e-8]}, "2 values for 3 strokes do not match"),
        (TABLE, {"domain": ["0 mm", "1 mm"]}, "domain is not a valid field of a characteristic of kind table."),
    ],
)
def test_mistakes_in_a_table(table, changes, message):
    with pytest.raises(InputError) as caught:
        read(table, **changes)
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("field", "code"),
    [
        ("sonic_conductance", "fields.missing"),
        ("critical_ratio", "fields.missing"),
        ("argument_unit", "fields.missing"),
        ("domain", "fields.missing"),
    ],
)
def test_missing_field(field, code):
    with refused(code, f"bench.{field}"):
        characteristic_from_mapping({k: v for k, v in POLYNOMIAL.items() if k != field}, name="bench")


def test_missing_kind():
    with refused("curves.no_kind", "bench"):
        characteristic_from_mapping({}, name="bench")


def test_all_mistakes_at_once_each_reported_once_with_its_address():
    with pytest.raises(InputErrors) as caught:
        read(TABLE, edge="hole", stroke=["0 kg", "0.5 mm", "1 mm"], critical_ratio=["a", 0.3, 0.3])
    addresses = [problem.address for problem in caught.value.problems]
    assert sorted(addresses) == [
        f"valve.characteristic.{field}" for field in ("critical_ratio[0]", "edge", "stroke[0]")
    ]
