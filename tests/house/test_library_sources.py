"""Every number of the library says where it comes from, and every published set is named after its source."""

from __future__ import annotations

import pytest

from poppet import library
from poppet.ground.provenance import SOURCE_KINDS, Number

VARIANTS = {
    "varga2012": {"main_stage": ("paper", "regulator")},
    "vppm_6l": {
        "main_stage": ("regulator",),
        "pilot_stage": ("",),
        "electronics": ("universal", "fast", "precise"),
    },
}


def every_number() -> dict[str, Number]:
    named: dict[str, Number] = {}
    for name in library.characteristics():
        named |= {f"{name}: {key}": number for key, number in library.characteristic(name).numbers().items()}
    for name, kinds in VARIANTS.items():
        for kind, variant in ((kind, variant) for kind, variants in kinds.items() for variant in variants):
            own = library.numbers(name, kind, variant)
            named |= {f"{name} {kind} {variant}: {key}": number for key, number in own.items()}
    for name in library.gas_names():
        named |= {f"{name}: {key}": number for key, number in library.gas(name).numbers().items()}
    return named


NUMBERS = every_number()


def test_every_valve_of_the_library_is_looked_at():
    assert set(library.sets()) == {"gases", *VARIANTS}


@pytest.mark.parametrize("name", NUMBERS)
def test_number_has_a_source(name):
    source = NUMBERS[name].source
    assert source.kind in SOURCE_KINDS
    assert source.kind != "given", "a number of the library is not typed by a user"
    assert source.note if source.kind == "assumed" else source.locator


@pytest.mark.parametrize("name", NUMBERS)
def test_number_has_a_unit(name):
    assert NUMBERS[name].unit


@pytest.mark.parametrize("name", library.characteristics())
def test_characteristic_has_a_source(name):
    source = library.characteristic(name).source
    assert source.kind == "paper"
    assert source.locator


def test_nothing_mechanical_is_called_published():
    """The paper prints no mechanical number."""
    for name, kinds in VARIANTS.items():
        for mode in kinds["main_stage"]:
            assert {number.source.kind for number in library.main_stage(name, mode).values()} == {"assumed"}
