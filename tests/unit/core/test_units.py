from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest

from poppet.core.errors import InputError, OutOfRangeError, UnitError
from poppet.core.unit_table import _SYMBOLS, TABLE, read_unit
from poppet.core.units import (
    ANR,
    NORMAL,
    check_unit,
    convert,
    counted_at,
    is_known,
    quantity,
    same_dimension,
    with_state,
)


def refused(argument, unit, **options):
    with pytest.raises(InputError) as caught:
        quantity(argument, unit, **options)
    return caught.value


@pytest.mark.parametrize(
    ("argument", "unit", "value"),
    [
        ("0.2 m^3", "m^3", 0.2),
        ("5 cm^3", "m^3", 5e-6),
        ("5 cm**3", "m^3", 5e-6),
        ("200 l", "m^3", 0.2),
        ("200 L", "m^3", 0.2),
        ("3 ml", "m^3", 3e-6),
        ("16 mm^2", "m^2", 1.6e-5),
        ("16 mm²", "m^2", 1.6e-5),
        ("20 µm", "m", 2e-5),
        ("1 in", "m", 0.0254),
        ("1.65 dm^3/(s bar)", "m^3/(s Pa)", 1.65e-8),
        ("1.65 dm^3/s/bar", "m^3/(s Pa)", 1.65e-8),
        ("12 N s/mm", "N s/m", 12000.0),
        ("12 N*s/mm", "N s/m", 12000.0),
        ("12 N.s/mm", "N s/m", 12000.0),
        ("45 W/K", "W/K", 45.0),
        ("20 kJ/K", "J/K", 20000.0),
        ("50 bar^-1", "1/Pa", 5e-4),
        ("2 Pa^0.5", "Pa^(1/2)", 2.0),
        ("2 kPa^(2/2)", "Pa", 2000.0),
        ("30 %", "1", 0.3),
        ("0.3", "1", 0.3),
        ("0.3 -", "1", 0.3),
        ("2 h", "s", 7200.0),
        ("2 min", "s", 120.0),
        ("3 ms", "s", 0.003),
        ("3min", "s", 180.0),
        ("5 Hz", "1/s", 5.0),
        ("200 g", "kg", 0.2),
        ("1 t", "kg", 1000.0),
        ("4 mA", "A", 0.004),
        ("1 V A", "W", 1.0),
        ("+1e-3 m", "m", 0.001),
        (".5 m", "m", 0.5),
        ("5. m", "m", 5.0),
        (7, "Pa", 7.0),
        (np.float64(7.5), "Pa", 7.5),
        (np.int64(7), "Pa", 7.0),
    ],
)
def test_values(argument, unit, value):
    assert quantity(argument, unit).value == value


@pytest.mark.parametrize(
    ("symbol", "pascal"),
    # NIST SP 811, appendix B.8, to the digits printed there.
    [("psi", 6.894757e3), ("torr", 1.333224e2), ("atm", 1.01325e5), ("inHg", 3.386389e3)],
)
def test_customary_pressure_units(symbol, pascal):
    assert quantity(f"1 {symbol}", "Pa").value == pytest.approx(pascal, rel=1e-6)


def test_angle_is_not_a_ratio_and_not_a_frequency():
    assert quantity("90 deg", "rad").value == math.pi / 2
    assert refused("10 rad/s", "Hz").code == "quantity.other_quantity"
    assert refused("30 deg", "1").code == "quantity.other_quantity"


@pytest.mark.parametrize(
    "argument",
    ["6 bar g", "6 bar(g)", "6 bar (g)", "6 barg", "6 bar gauge", "6 bar (gauge)", "600 kPa g", "0.6 MPa(g)"],
)
def test_gauge_pressures(argument):
    result = quantity(argument, "Pa", kind="pressure")
    assert (result.value, result.unit, result.reference) == (600000.0, "Pa", "gauge")


def test_psig():
    result = quantity("87 psig", "Pa", kind="pressure")
    assert result.value == quantity("87 psi", "Pa", kind="pressure").value
    assert result.reference == "gauge"


@pytest.mark.parametrize("argument", ["7 bar", "7 bar a", "7 bar(a)", "7 bara", "7 bar abs", "7 bar absolute", 7e5])
def test_absolute_pressures(argument):
    result = quantity(argument, "Pa", kind="pressure")
    assert (result.value, result.reference) == (700000.0, "absolute")


def test_negative_gauge_is_fine_and_negative_absolute_is_not():
    assert quantity("-0.5 bar g", "Pa", kind="pressure").value == -50000.0
    for argument in ("-0.5 bar", -0.5e5):
        error = refused(argument, "Pa", kind="pressure")
        assert isinstance(error, OutOfRangeError)
        assert error.code == "quantity.pressure_below_zero"


@pytest.mark.parametrize("kind", ["pressure_difference", "plain"])
@pytest.mark.parametrize(
    ("argument", "code"), [("0.2 bar g", "gauge"), ("0.2 barg", "gauge"), ("0.2 bar a", "absolute")]
)
def test_differences_refuse_a_reference(argument, code, kind):
    assert refused(argument, "Pa", kind=kind).code == f"quantity.{code}_difference"


def test_pressure_difference():
    assert quantity("0.2 bar", "Pa", kind="pressure_difference").reference == "difference"


@pytest.mark.parametrize("argument", ["20 degC", "68 degF", "293.15 K", "20 °C", 293.15])
def test_temperatures(argument):
    result = quantity(argument, "K", kind="temperature")
    assert (result.value, result.unit, result.reference) == (293.15, "K", "absolute")


def test_temperature_below_absolute_zero():
    error = refused("-300 degC", "K", kind="temperature")
    assert isinstance(error, OutOfRangeError)
    assert error.code == "quantity.temperature_below_zero"


@pytest.mark.parametrize("kind", ["temperature_difference", "plain"])
def test_degrees_of_a_scale_are_refused_as_difference(kind):
    assert refused("20 degC", "K", kind=kind).code == "quantity.point_of_scale"
    assert quantity("20 K", "K", kind=kind).value == 20.0


def test_degrees_in_a_product_are_refused():
    assert refused("50 W/degC", "W/K").facts["cause"].code == "unit.scale_in_product"


def test_reference_atmospheres():
    assert ANR.density / NORMAL.density == pytest.approx(0.9196, abs=5e-5)
    assert (ANR.temperature, ANR.pressure, NORMAL.temperature, NORMAL.pressure) == (
        293.15,
        1e5,
        273.15,
        101325,
    )


@pytest.mark.parametrize(
    ("argument", "value"),
    [
        ("0.01 kg/s", 0.01),
        ("60 g/min", 0.001),
        ("380 l/min ANR", 380e-3 / 60 * 1.185),
        ("380 l/min (ANR)", 380e-3 / 60 * 1.185),
        ("1 m^3/h N", NORMAL.density / 3600),
        (0.01, 0.01),
    ],
)
def test_mass_flow(argument, value):
    assert quantity(argument, "kg/s", kind="mass_flow").value == pytest.approx(value, rel=1e-15)


def test_volume_flow_at_the_reference_atmosphere():
    flow = quantity("600 l/min ANR", "m^3/s ANR", kind="volume_flow_anr")
    assert (flow.value, flow.unit) == (0.01, "m^3/s ANR")
    normal = quantity("1 m^3/s N", "m^3/s ANR", kind="volume_flow_anr")
    assert 1.0 / normal.value == pytest.approx(0.9196, abs=5e-5)


@pytest.mark.parametrize(("kind", "unit"), [("mass_flow", "kg/s"), ("volume_flow_anr", "m^3/s ANR")])
def test_a_bare_volume_flow_needs_its_state(kind, unit):
    error = refused("380 l/min", unit, kind=kind)
    assert (error.code, error.facts["flow"]) == ("quantity.flow_without_state", "380 l/min")
    error = refused("380 slpm", unit, kind=kind)
    assert (error.code, error.facts["stated"]) == ("quantity.standard_flow", "380 l/min N")


@pytest.mark.parametrize(
    ("argument", "like", "state"),
    [
        ("380 Nl/min", "380 l/min N", "normal"),
        ("380 NL/min", "380 l/min N", "normal"),
        ("22.8 Nm3/h", "380 l/min N", "normal"),
        ("22.8 Nm^3/h", "380 l/min N", "normal"),
        ("380 nlpm", "380 l/min N", "normal"),
        ("380 slpm", "380 l/min N", "standard"),
        ("380 SLPM", "380 l/min N", "standard"),
        ("380000 sccm", "380 l/min N", "standard"),
        ("380 l/min", "380 l/min ANR", "open"),
        ("380 lpm", "380 l/min ANR", "open"),
    ],
)
def test_abbreviated_volume_flows(argument, like, state):
    """By hand: 380 l/min of 1.185 kg/m3 at ANR, and of 1.185 293.15/273.15 1.01325 at the normal state."""
    assert counted_at(argument) == state
    density = 1.185 if state == "open" else 1.185 * 293.15 / 273.15 * 1.01325
    read = quantity(argument, "kg/s", kind="mass_flow", is_told=True).value
    assert read == pytest.approx(0.38 / 60.0 * density, rel=1e-12)
    assert read == pytest.approx(quantity(like, "kg/s", kind="mass_flow").value, rel=1e-14)
    if state != "normal":
        assert quantity(with_state(argument), "kg/s", kind="mass_flow").value == pytest.approx(read, rel=1e-14)


def test_standard_litres_of_a_column_are_refused():
    with pytest.raises(UnitError) as caught:
        convert(1.0, "slpm", "kg/s")
    assert (caught.value.code, caught.value.facts["unit"]) == ("unit.standard_flow", "slpm")
    assert convert(1.0, "Nl/min", "l/min N") == 1.0
    assert same_dimension("slpm", "kg/s")


def test_anr_is_refused_where_a_plain_flow_is_meant():
    for error in (refused("380 l/min ANR", "m^3/s"), refused("5 kg/s", "m^3/s ANR", kind="volume_flow_anr")):
        assert isinstance(error, UnitError)
        assert error.code == "quantity.other_quantity"


@pytest.mark.parametrize(
    ("argument", "unit", "code", "facts"),
    [
        ("0.2", "m^3", "no_unit", {"number": "0.2", "unit": "m^3"}),
        ("600,000 Pa", "Pa", "comma", {"with_point": "600.000 Pa", "without": "600000 Pa"}),
        ("3,16 bar", "Pa", "decimal_comma", {"with_point": "3.16 bar"}),
        ("1_000 Pa", "Pa", "underscore", {}),
        ("nan Pa", "Pa", "no_number", {}),
        ("inf", "1", "no_number", {"example": '"0.2"'}),
        ("1e400 Pa", "Pa", "not_finite", {}),
        ("1e999999999 Pa", "Pa", "not_finite", {}),
        ("1e308 GPa", "Pa", "not_finite", {}),
        ("", "m", "no_number", {"example": '"0.2 m"'}),
        ("bar", "Pa", "no_number", {}),
        ("5 m", "Pa", "other_quantity", {"unit": "Pa"}),
        ("5 bar g", "m", "other_quantity", {"unit": "m"}),
    ],
)
def test_refused_texts_have_a_reason_and_a_hint(argument, unit, code, facts):
    error = refused(argument, unit, name="tank.volume")
    assert (error.code, error.address, error.facts["shown"]) == (f"quantity.{code}", "tank.volume", f'"{argument}"')
    assert facts.items() <= error.facts.items()


@pytest.mark.parametrize(
    ("unit", "code", "facts"),
    [
        ("m3", "power", {"base": "m", "exponent": "3"}),
        ("Bar", "misspelt", {"suggestion": ("bar",)}),
        ("C", "misspelt", {"suggestion": ("degC",)}),
        ("Nl/(min bar)", "normal", {"base": "l"}),
        ("l/(min bar) ANR", "conductance_marked", {"plain": "l/(min bar)"}),
        ("dm^3/(s bar) (ANR)", "conductance_marked", {"plain": "dm^3/(s bar)"}),
        ("furlong", "unknown", {"symbol": "furlong"}),
        ("J/kg K", "two_ways", {}),
        ("m^", "ends_early", {}),
        ("(m", "ends_early", {}),
        ("(m s", "ends_early", {}),
        ("m)", "unreadable", {"at": ")"}),
        ("m^(2", "ends_early", {}),
        ("m^(2 s", "parenthesis", {}),
        ("m^x", "exponent", {"exponent": "x"}),
        ("m^(1/0)", "exponent_by_zero", {}),
        ("m^99", "too_high", {}),
        ("((mm^12)^12)^12", "too_high", {}),
        ("((%^12)^12)^12", "too_high", {}),
        ("2 m", "unreadable", {"at": "2"}),
        (".3 m", "unreadable", {}),
        ("m#", "character", {"character": "#"}),
        ("m" * 101, "too_long", {"limit": 100}),
    ],
)
def test_units_that_cannot_be_read(unit, code, facts):
    error = refused(f"1.2 {unit}", "m")
    assert isinstance(error, UnitError)
    assert error.code == "quantity.unreadable_unit"
    assert error.facts["cause"].code == f"unit.{code}"
    assert facts.items() <= error.facts["cause"].facts.items()


@pytest.mark.parametrize("argument", [True, np.True_, None, [1.0], 1j])
def test_value_that_is_not_a_number_is_refused(argument):
    assert refused(argument, "m").code == "quantity.not_a_number"


@pytest.mark.parametrize("argument", [math.nan, math.inf, -math.inf, 10**400])
def test_bare_numbers_must_be_finite(argument):
    assert refused(argument, "m").code == "quantity.not_finite"


def test_error_is_not_cached_with_the_text():
    for name in ("a", "b"):
        assert refused("0.2", "m", name=name).address == name


def test_no_prefix_makes_a_symbol_of_another_unit():
    spelled = [prefix + symbol for symbol, row in _SYMBOLS.items() for prefix in ("", *row[2])]
    assert len(spelled) == len(set(spelled)) == len(TABLE) - len(["degC", "degF"])


def test_scales_are_exact():
    assert read_unit("dm^3/(s bar)").scale == Fraction(1, 10**8)


def test_known_units():
    assert is_known("m^3/(s Pa)")
    assert is_known("l/min ANR")
    assert is_known("bar (g)")
    assert not is_known("bars")
    assert not is_known("")
    check_unit("bar g")
    with pytest.raises(UnitError) as caught:
        check_unit("bars")
    assert caught.value.facts["suggestion"][0] == "bar"


def test_newton_and_gram_are_marks_only_behind_their_quantity():
    assert convert(1.0, "m N", "J") == 1.0
    assert convert(1.0, "m g", "m kg") == 0.001
    assert same_dimension("bar g", "Pa")
    assert same_dimension("m^3/h N", "g/s")
    assert not same_dimension("m^3/h", "g/s")
    assert not same_dimension("nonsense", "nonsense")


@pytest.mark.parametrize(
    ("value", "source", "target", "expected"),
    [
        (3e5, "Pa", "bar", 3.0),
        (3e5, "Pa", "bar g", 2.0),
        (2.0, "bar g", "Pa", 3e5),
        (5.0, "bar g", "kPa g", 500.0),
        (20.0, "degC", "degF", 68.0),
        (20.0, "degC", "K", 293.15),
        (293.15, "K", "degC", 20.0),
        (1.0, "kg/s", "m^3/s ANR", 1 / 1.185),
        (12.0, "l/min", "l/min", 12.0),
    ],
)
def test_convert(value, source, target, expected):
    assert convert(value, source, target) == pytest.approx(expected, rel=1e-15)


def test_convert_refers_gauge_to_the_given_ambient_pressure():
    assert convert(0.0, "bar g", "Pa", ambient_pressure=95000.0) == 95000.0


def test_convert_does_not_change_its_array():
    argument = np.array([1e5, 2e5])
    np.testing.assert_array_equal(convert(argument, "Pa", "bar"), [1.0, 2.0])
    np.testing.assert_array_equal(argument, [1e5, 2e5])


def test_convert_refuses_another_quantity():
    with pytest.raises(UnitError) as caught:
        convert(1.0, "m", "Pa")
    assert (caught.value.code, caught.value.facts) == ("unit.other_quantity", {"unit": "m", "asked": "Pa"})
    with pytest.raises(UnitError) as caught:
        convert(1.0, "l/min", "kg/s")
    assert caught.value.code == "unit.flow_without_state"
