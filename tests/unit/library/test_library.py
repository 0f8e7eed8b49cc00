"""The library: names, near misses, sets, gases, what the command line shows."""

from __future__ import annotations

import math

import pytest

from poppet import library
from poppet.laws.curves import Characteristic
from poppet.laws.physics.contact import stop_force
from refusals import refused

FIELDS = {
    "plate_area": "m^2",
    "moving_mass": "kg",
    "emptying_mass": "kg",
    "damping": "N s/m",
    "upper_spring.rate": "N/m",
    "upper_spring.preload": "m",
    "lower_spring.rate": "N/m",
    "lower_spring.preload": "m",
    "seat_area": "m^2",
    "seat_balance": "1",
    "overlap": "m",
    "exhaust_seat.sonic_conductance": "m^3/(s Pa)",
    "exhaust_seat.critical_ratio": "1",
    "exhaust_seat.opening": "m",
    "upper_stop.position": "m",
    "upper_stop.stiffness": "N/m^1.5",
    "upper_stop.dissipation": "s/m",
    "lower_stop.position": "m",
    "lower_stop.stiffness": "N/m^1.5",
    "lower_stop.dissipation": "s/m",
    "contact.width": "m",
    "contact.dissipation": "s/m",
}
MODES = ["paper", "regulator"]


def values(mode: str) -> dict[str, float]:
    return {name: float(number) for name, number in library.main_stage("varga2012", mode).items()}


def test_names():
    assert library.sets() == ("gases", "dmsp_10_250", "dmsp_20_300", "dmsp_40_300", "varga2012", "vppm_6l")
    assert set(library.characteristics()) == {
        "varga2012",
        "varga2012.printed",
        "varga2012.closed",
        "varga2012.monotone",
        "varga2012.table",
        "vppm_6l.closed",
    }


@pytest.mark.parametrize("name", library.characteristics())
def test_characteristics_have_their_name(name):
    curve = library.characteristic(name)
    assert isinstance(curve, Characteristic)
    assert curve.name == name
    assert curve.domain == pytest.approx((0.0, 1e-3), rel=1e-15)
    assert curve.edge == "hold"


def test_the_bare_name_selects_the_printed_polynomials():
    default, printed = library.characteristic("varga2012"), library.characteristic("varga2012.printed")
    assert default.numbers() == printed.numbers()
    assert default.closing is None
    assert not default.monotone


@pytest.mark.parametrize(
    ("call", "arguments", "message"),
    [
        (library.characteristic, ["varga2012.close"], "library.unknown"),
        (
            library.main_stage,
            ["varga2021", "paper"],
            "library.unknown",
        ),
        (
            library.main_stage,
            ["varga2012", "papers"],
            "library.unknown",
        ),
        (library.gas, ["nitrogene"], "library.unknown"),
        (library.describe, ["varga"], "library.unknown"),
    ],
)
def test_unknown_names_have_a_suggestion(call, arguments, message):
    with refused(message):
        call(*arguments)


@pytest.mark.parametrize("mode", MODES)
def test_a_main_stage_has_every_field_in_its_unit(mode):
    stage = library.main_stage("varga2012", mode)
    assert {name: number.unit for name, number in stage.items()} == FIELDS


@pytest.mark.parametrize(
    ("bar", "millimetres"), [(1, 0.138), (2, 0.310), (3, 0.482), (4, 0.655), (5, 0.827), (6, 0.999)]
)
def test_static_map_of_the_paper_set(bar, millimetres):
    """Eq. (5) at rest: k1 (h1 + x) + k2 (h2 + x) = S p."""
    v = values("paper")
    preload = v["upper_spring.rate"] * v["upper_spring.preload"] + v["lower_spring.rate"] * v["lower_spring.preload"]
    stroke = (v["plate_area"] * bar * 1e5 - preload) / (v["upper_spring.rate"] + v["lower_spring.rate"])
    assert 1e3 * stroke == pytest.approx(millimetres, abs=6e-4)


def test_natural_frequency_of_the_paper_set():
    v = values("paper")
    omega = math.sqrt((v["upper_spring.rate"] + v["lower_spring.rate"]) / v["moving_mass"])
    assert omega / (2 * math.pi) == pytest.approx(600.0, abs=1.0)


def test_dead_zone_of_the_paper_set():
    """At rest the plate lies 20 um below the seat; 0.104..0.200 bar g hold it on the seat."""
    v = values("paper")
    lifts = v["upper_spring.rate"] * v["upper_spring.preload"] / v["plate_area"]
    opens = lifts + v["lower_spring.rate"] * v["lower_spring.preload"] / v["plate_area"]
    assert lifts / 1e5 == pytest.approx(0.104, abs=5e-4)
    assert opens / 1e5 == pytest.approx(0.200, abs=5e-4)
    assert v["lower_stop.position"] < -v["upper_spring.preload"]


def test_preload_of_the_regulator_set_is_14_newton():
    v = values("regulator")
    upper = v["upper_spring.rate"] * v["upper_spring.preload"]
    lower = v["lower_spring.rate"] * v["lower_spring.preload"]
    assert (upper, lower) == pytest.approx((2.0, 12.0), rel=1e-14)


@pytest.mark.parametrize("mode", MODES)
def test_stops_deflect_by_two_micrometres_under_20_newton(mode):
    stage = library.main_stage("varga2012", mode)
    for stop in ("upper_stop", "lower_stop"):
        assert stop_force(2e-6, 0.0, float(stage[f"{stop}.stiffness"]), 0.0) == pytest.approx(20.0, rel=1e-3)


# --- gases ---


@pytest.mark.parametrize(
    ("name", "gas_constant", "exponent"),
    [
        ("air", 287.05, 1.4),
        ("nitrogen", 296.80, 1.400),
        ("oxygen", 259.84, 1.395),
        ("argon", 208.1, 1.667),
        ("helium", 2077.3, 1.667),
        ("hydrogen", 4124.2, 1.406),
        ("carbon dioxide", 188.92, 1.291),
        ("methane", 518.3, 1.306),
    ],
)
def test_gases(name, gas_constant, exponent):
    gas = library.gas(name)
    assert float(gas.gas_constant) == pytest.approx(gas_constant, rel=2e-4)
    assert float(gas.isentropic_exponent) == pytest.approx(exponent, abs=6e-4)


@pytest.mark.parametrize("name", ["nitrogen", "oxygen", "argon", "helium", "hydrogen", "carbon dioxide", "methane"])
def test_gases_against_cantera(name):
    cantera = pytest.importorskip("cantera", reason="Cantera has the NASA polynomials to compare with")
    formula = {"nitrogen": "N2", "oxygen": "O2", "argon": "Ar", "helium": "He", "hydrogen": "H2"}
    formula |= {"carbon dioxide": "CO2", "methane": "CH4"}
    species = {species_entry.name: species_entry for species_entry in cantera.Species.list_from_file("nasa_gas.yaml")}[
        formula[name]
    ]
    heat_capacity = species.thermo.cp(293.15) / cantera.gas_constant
    gas = library.gas(name)
    assert float(gas.gas_constant) == pytest.approx(cantera.gas_constant / species.molecular_weight, rel=1e-5)
    assert float(gas.isentropic_exponent) == pytest.approx(heat_capacity / (heat_capacity - 1.0), abs=5e-5)


def test_spelling_of_gases():
    assert library.gas("Carbon_Dioxide") is library.gas("carbon dioxide")
    assert library.gas("dry air") is library.gas("air")


def test_gases_have_a_note_on_valid_laws():
    assert "do not hold" in library.gas("helium").note
    assert "within a few per cent" in library.gas("nitrogen").note


# --- what the command line shows ---


@pytest.mark.parametrize("name", [*library.sets(), *library.characteristics(), *library.gas_names()])
def test_describe_shows_every_parameter_with_its_source(name):
    text = library.describe(name)
    assert text.startswith(f"{name}:" if name != "gases" else "air:")
    assert all(line == line.rstrip() for line in text.splitlines())


def test_describe_shows_assumed_parameters():
    text = library.describe("varga2012")
    assert "Varga & Keski-Honkola 2012" in text
    for mode in MODES:
        assert f'mode = "{mode}"' in text
        for name, number in library.main_stage("varga2012", mode).items():
            assert any(name in line and number.display() in line and "assumed" in line for line in text.splitlines())
