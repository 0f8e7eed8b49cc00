"""Units and conductances from the command line."""

from __future__ import annotations

import math

import pytest

from poppet import iso6358, loads
from poppet.core.codes import Note


def value(out: str) -> float:
    """The number behind the first equals sign."""
    return float(out.split(" = ")[1].split()[0])


@pytest.mark.parametrize(
    ("given", "to", "expected"),
    [
        ("6 bar g", "Pa", 7e5),
        ("700000 Pa", "bar g", 6.0),
        ("-0.5 bar g", "Pa", 5e4),
        ("20 degC", "K", 293.15),
        ("1 kg/s", "l/min ANR", 60e3 / 1.185),
        ("1.65 dm^3/(s bar)", "m^3/(s Pa)", 1.65e-8),
        ("16 mm^2", "m^2", 16e-6),
        ("5 A", "mA", 5000.0),
    ],
)
def test_units(poppet, given, to, expected):
    code, out, err = poppet("convert", given, "--to", to)
    assert (code, err) == (0, "")
    assert value(out) == pytest.approx(expected, rel=1e-9)


def test_the_ambient_pressure_is_printed_and_can_be_set(poppet):
    _, out, _ = poppet("convert", "6 bar g", "--to", "bar")
    assert "ambient pressure of 1 bar absolute" in out
    _, out, _ = poppet("convert", "6 bar g", "--to", "bar", "--ambient", "950 hPa")
    assert value(out) == pytest.approx(6.95, rel=1e-12)
    assert "0.95 bar" in out


@pytest.mark.parametrize(
    ("given", "to", "expected"),
    [
        ("1.2 Kv", "C", iso6358.conductance_from_flow_coefficient_kv(1.2).sonic_conductance),
        ("1 Cv", "C", iso6358.conductance_from_flow_coefficient_cv(1.0).sonic_conductance),
        ("380 l/min ANR", "C", iso6358.conductance_from_nominal_flow(0.38 / 60).sonic_conductance),
        ("16 mm^2", "C", iso6358.conductance_from_effective_area(16e-6).sonic_conductance),
        ("1e-8 m^3/(s Pa)", "Kv", iso6358.flow_coefficient_kv_from_conductance(1e-8, 0.3)),
        ("1e-8 m^3/(s Pa)", "cv", iso6358.flow_coefficient_cv_from_conductance(1e-8, 0.3)),
        ("1e-8 m^3/(s Pa)", "area", 1e6 * iso6358.effective_area_from_conductance(1e-8)),
        ("1e-8 m^3/(s Pa)", "qNn", 60e3 * iso6358.nominal_flow_from_conductance(1e-8, 0.3)),
        ("1e-8 m^3/(s Pa)", "m^2", iso6358.effective_area_from_conductance(1e-8)),
        ("3 Cv", "Kv", 3 * 0.865),
    ],
)
def test_flow_capacities(poppet, given, to, expected):
    code, out, _ = poppet("convert", given, "--to", to)
    assert code == 0
    assert value(out) == pytest.approx(expected, rel=1e-6)


def test_a_given_critical_ratio_is_used_and_an_assumed_one_is_reported(poppet):
    _, assumed, _ = poppet("convert", "1.2 Kv", "--to", "C")
    assert "b = 0.3 is assumed" in assumed
    _, output, _ = poppet("convert", "1.2 Kv", "--to", "C", "--critical-ratio", "0.4")
    assert "assumed" not in output
    assert "b = 0.4" in output
    assert value(output) / value(assumed) == pytest.approx((0.6 / 0.7) ** 0.5, rel=1e-6)


def test_the_definition_and_the_atmosphere_are_printed(poppet):
    _, out, _ = poppet("convert", "1 Cv", "--to", "qNn")
    assert "pneumatic definition (114.5) of Cv" in out
    assert "atmosphere of 1.01325 bar" in out
    assert "ISO 8778" in out
    _, out, _ = poppet("convert", "1 Cv", "--to", "qNn", "--definition", "small_dp", "--ambient", "1 bar")
    assert "liquid definition" in out
    assert "atmosphere of 1 bar" in out


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("6 bra", "--to", "Pa"), "unit.misspelt"),
        (("6 bar", "--to", "m"), "unit.other_quantity"),
        (("6", "--to", "Pa"), "convert.no_unit"),
        (("6 bar", "--to", " "), "convert.no_target"),
        (("1e400 bar", "--to", "Pa"), "convert.too_large"),
        (("1e308 bar", "--to", "Pa"), "convert.too_large_in"),
        (("six bar", "--to", "Pa"), "convert.no_number"),
        (("6,5 bar", "--to", "Pa"), "convert.decimal_comma"),
        (("6", "bar", "--to", "Pa"), "cli.argument.extra"),
        (("nan bar", "--to", "Pa"), "convert.no_number"),
        (("-2 bar g", "--to", "Pa"), "convert.below_zero"),
        (("-300 degC", "--to", "K"), "convert.below_zero"),
        (("20 C", "--to", "K"), "convert.name_or_celsius"),
        (("20 K", "--to", "C"), "convert.apart"),
        (("1.2 Kv", "--to", "bar"), "convert.apart"),
        (("1.2 Kv", "--to", "C", "--critical-ratio", "1"), "fields.out_of_range"),
        (("-1 Kv", "--to", "C"), "iso6358.flow_coefficient"),
        (("1 bar g", "--to", "Pa", "--ambient", "1 bar g"), "convert.gauge_ambient"),
        (("1 Kv", "--to", "C", "--definition", "loose"), "cli.usage"),
    ],
)
def test_refusals(poppet, arguments, code):
    answer = poppet("convert", *arguments)
    assert (answer.code, answer.out, answer.codes) == (2, "", [code])


def test_an_assumed_reference_state_is_reported(poppet):
    assumed, stated = (poppet("convert", f"380 {unit}", "--to", "C") for unit in ("l/min", "l/min ANR"))
    assert (assumed.code, value(assumed.out)) == (0, value(stated.out))
    assert str(Note("doubt.read_as", unit="l/min", read="l/min ANR")) in assumed.out
    standard = poppet("convert", "1 slpm", "--to", "kg/s")
    assert value(standard.out) == pytest.approx(1.185 * 293.15 / 273.15 * 1.01325 / 60e3)
    assert str(Note("doubt.read_as", unit="slpm", read="l/min N")) in standard.out
    assert len(poppet("convert", "1 l/min", "--to", "m^3/h").out.splitlines()) == 1


def test_areas_use_the_nozzle_flow_of_the_gas(poppet):
    n, gas_constant, inlet = 5.0 / 3.0, 8.314462618 / 4.002602e-3, 7e5
    choked = inlet * math.sqrt(n / (gas_constant * 293.15)) * (2.0 / (n + 1.0)) ** ((n + 1.0) / (2.0 * (n - 1.0)))
    _, out, _ = poppet("convert", "1 mm^2", "--to", "C", "--gas", "Helium")
    conductance = value(out)
    assert conductance * 1.185 * inlet == pytest.approx(1e-6 * choked, rel=1e-4)
    _, back, _ = poppet("convert", f"{conductance!r} m^3/(s Pa)", "--to", "area", "--gas", "helium")
    assert value(back) == pytest.approx(1.0, rel=1e-6)


def test_catalogue_capacities_are_converted_to_the_gas(poppet):
    _, out, _ = poppet("convert", "1.2 Kv", "--to", "C", "--gas", "helium")
    valve = loads(
        """
        gas = "helium"
        [parts.valve]
        kind = "orifice"
        from = "ambient"
        to = "tank"
        flow_coefficient_kv = 1.2
        [parts.tank]
        kind = "chamber"
        volume = "1 l"
        """
    )
    assert value(out) == pytest.approx(valve.parameters["valve.sonic_conductance"], rel=1e-7)
    _, back, _ = poppet("convert", out.split(" = ")[1], "--to", "Kv", "--gas", "helium", "--critical-ratio", "0.21271")
    assert value(back) == pytest.approx(1.2, rel=1e-4)
    assert poppet("convert", "1 mm^2", "--to", "C", "--gas", "xenon")[0] == 2
