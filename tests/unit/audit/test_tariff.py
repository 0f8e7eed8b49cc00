"""Tariff of compressed air: units, defaults with sources, and invalid input."""

from __future__ import annotations

import math

import pytest

from poppet.audit.tariff import read_tariff
from poppet.core.errors import InputError
from refusals import refused


@pytest.mark.parametrize(
    ("price", "cost"),
    [
        ("0.20 EUR/kWh", 0.20 * 0.12 * 50.0),
        ("200 EUR / MWh", 0.20 * 0.12 * 50.0),
        ("2e-2 EUR/m^3", 0.02 * 50.0),
        ("0.02 EUR/m³ ANR", 0.02 * 50.0),
        ("0.00002 €/l", 0.02 * 50.0),
    ],
)
def test_prices_of_electricity_and_of_air(price, cost):
    tariff = read_tariff({"tariff": price, "specific_energy": "0.12 kWh/m^3"})
    assert tariff.cost(50.0) == pytest.approx(cost, rel=1e-12)
    assert tariff.currency == ("€" if "€" in price else "EUR")


def test_co2_and_cycles():
    tariff = read_tariff({"specific_energy": "6 kW/(m^3/min)", "emission": "400 g/kWh", "hours": "2000 h"})
    assert tariff.co2(1.0) == pytest.approx(0.1 * 0.4, rel=1e-12)
    assert tariff.cycles_per_year(7.2) == pytest.approx(1e6, rel=1e-12)


def test_nothing_is_priced_without_a_price():
    tariff = read_tariff()
    assert math.isnan(tariff.cost(1.0))
    assert math.isnan(tariff.co2(1.0))
    assert tariff.currency == ""


def test_defaults_are_assumptions_and_sources_are_kept():
    table = {"tariff": {"value": "0.2 EUR/kWh", "source": "measured", "locator": "bill of May"}}
    sources = {name: (number.source.kind, number.source.locator) for name, number in read_tariff(table).numbers()}
    expected = {"tariff": ("measured", "bill of May"), "specific_energy": ("assumed", ""), "hours": ("assumed", "")}
    assert sources == expected
    content = read_tariff(table).content()
    assert content["tariff"] == {"value": "0.2 EUR/kWh", "source": "measured: bill of May"}
    assert content["hours"]["value"] == "4000 h"


@pytest.mark.parametrize("price", ["0.20", 0.2, "0.20 EUR", "0,20 EUR/kWh", "EUR/kWh", "0.20/kWh", "0.2 EUR/"])
def test_a_price_without_unit_is_rejected(price):
    with refused("tariff.no_unit", "audit.tariff"):
        read_tariff({"tariff": price}, "audit")


@pytest.mark.parametrize("unit", ["kW", "furlong", "kg", "m^3/h"])
def test_a_price_per_another_quantity_is_rejected(unit):
    with refused("tariff.other_unit", "tariff"):
        read_tariff({"tariff": f"0.2 EUR/{unit}"})


def test_a_negative_price_is_rejected():
    with refused("tariff.negative", "tariff"):
        read_tariff({"tariff": "-0.2 EUR/kWh"})


@pytest.mark.parametrize(("field", "value"), [("specific_energy", 0.12), ("emission", 0.4), ("hours", 4000)])
def test_a_number_without_a_unit_is_rejected(field, value):
    """0.12 J/m^3 instead of 0.12 kWh/m^3 would be wrong by a factor of 3.6 million."""
    for argument in (value, {"value": value, "source": "measured"}):
        with refused("tariff.bare_number", f"audit.{field}"):
            read_tariff({field: argument}, "audit")


def test_an_infinite_price_is_rejected():
    with refused("quantity.not_finite", "tariff"):
        read_tariff({"tariff": "1e999 EUR/kWh"})


def test_all_errors_of_a_table_are_reported():
    with refused("fields.unknown", "audit.tarif") as caught:
        read_tariff(
            {"tarif": "1 EUR/kWh", "hours": "9000 h", "emission": "0.4 kg", "specific_energy": "0 kWh/m^3"}, "audit"
        )
    problems = {(problem.code, problem.address) for problem in caught.value.problems}
    assert problems == {
        ("fields.unknown", "audit.tarif"),
        ("fields.out_of_range", "audit.hours"),
        ("quantity.other_quantity", "audit.emission"),
        ("fields.out_of_range", "audit.specific_energy"),
    }


def test_a_tariff_is_a_table():
    with refused("fields.no_table", "audit"):
        read_tariff("0.2 EUR/kWh", "audit")


@pytest.mark.parametrize(
    ("table", "texts"),
    [
        ({"hours": "9000 h"}, ["9000 h", "at most 8784 h"]),
        ({"hours": "4000"}, ['"4000 h"']),
        ({"hours": "4000 kg"}, ['converted to "h"', '"4000 h"']),
        ({"emission": "0.4"}, ['"0.4 kg/kWh"']),
        ({"emission": "-1 kg/kWh"}, ["at least 0 kg/kWh"]),
        ({"emission": "4 kg"}, ['converted to "kg/kWh"', '"0.4 kg/kWh"']),
        ({"specific_energy": "0 kWh/m^3"}, ["greater than 0 kWh/m^3"]),
    ],
)
def test_limits_and_hints_have_usual_units(table, texts):
    with pytest.raises(InputError) as caught:
        read_tariff(table)
    assert [text for text in texts if text not in str(caught.value)] == []
