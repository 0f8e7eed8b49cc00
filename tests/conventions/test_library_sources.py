"""Every number of the library says where it comes from, and every published set is named after its source."""

from __future__ import annotations

from poppet import library
from poppet.core.provenance import SOURCE_KINDS, Number

VARIANTS = {
    "varga2012": {"main_stage": ("paper", "regulator")},
    "vppm_6l": {
        "main_stage": ("regulator",),
        "pilot_stage": ("",),
        "electronics": ("universal", "fast", "precise"),
    },
    **{name: {"muscle": ("",)} for name in ("dmsp_10_250", "dmsp_20_300", "dmsp_40_300")},
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


def test_every_number_has_a_source():
    # A number of the library is not typed by a user.
    kinds = set(SOURCE_KINDS) - {"given"}
    assert [name for name, number in NUMBERS.items() if number.source.kind not in kinds] == []
    sources = {name: number.source for name, number in NUMBERS.items()}
    assert [name for name, s in sources.items() if not (s.note if s.kind == "assumed" else s.locator)] == []


def test_every_number_has_a_unit():
    assert [name for name, number in NUMBERS.items() if not number.unit] == []


def test_every_characteristic_has_a_source():
    sources = {name: library.characteristic(name).source for name in library.characteristics()}
    assert [name for name, source in sources.items() if source.kind != "paper" or not source.locator] == []


def test_nothing_mechanical_is_called_published():
    """The paper prints no mechanical number."""
    for name, kinds in VARIANTS.items():
        for mode in kinds.get("main_stage", ()):
            assert {number.source.kind for number in library.main_stage(name, mode).values()} == {"assumed"}
