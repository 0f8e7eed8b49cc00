from __future__ import annotations

import pytest

from poppet.core.errors import InputError, OutOfRangeError, UnitError
from poppet.core.provenance import SOURCE_KINDS, Number, Source, assumed, printed


def test_source_shows_kind_locator_and_note():
    assert str(Source("paper", "Varga & Keski-Honkola 2012, eq. (5)", "read")) == (
        "paper: Varga & Keski-Honkola 2012, eq. (5) (read)"
    )
    assert str(Source("given")) == "given"


def test_unknown_source_kind_offers_the_near_one():
    with pytest.raises(InputError) as caught:
        Source("asumed")
    assert (caught.value.code, caught.value.facts["suggestion"].names[0]) == ("fields.not_an_option", "assumed")


def test_every_kind_is_accepted():
    assert [Source(kind).kind for kind in SOURCE_KINDS] == list(SOURCE_KINDS)


def test_unknown_reference_is_refused():
    with pytest.raises(InputError) as caught:
        Number(1.0, "Pa", Source("given"), "abslute")
    assert (caught.value.code, caught.value.facts["suggestion"].names) == ("fields.not_an_option", ["absolute"])


def test_float_gives_the_value():
    assert float(Number(0.2, "m^3", Source("given"))) == 0.2


def test_float_of_a_gauge_pressure_is_refused():
    with pytest.raises(UnitError) as caught:
        float(Number(6e5, "Pa", Source("given"), "gauge", "6 bar g"))
    assert (caught.value.code, caught.value.facts["shown"]) == ("numbers.gauge", "6 bar g")


@pytest.mark.parametrize(("reference", "expected"), [("gauge", 7e5), ("absolute", 6e5), ("difference", 6e5)])
def test_absolute_adds_the_ambient_pressure_to_gauge_only(reference, expected):
    assert Number(6e5, "Pa", Source("given"), reference).absolute(1e5) == expected


def test_absolute_below_vacuum_is_refused():
    number = Number(-1.2e5, "Pa", Source("given"), "gauge", "-1.2 bar g")
    with pytest.raises(OutOfRangeError) as caught:
        number.absolute(1e5)
    assert (caught.value.code, caught.value.facts) == ("numbers.below_vacuum", {"shown": "-1.2 bar g", "lowest": -1e5})


@pytest.mark.parametrize(
    ("number", "shown"),
    [
        (Number(0.2, "m^3", Source("given"), text="200 l"), "200 l"),
        (Number(0.2, "m^3", Source("given"), text="0.2"), "0.2 m^3"),
        (Number(0.3, "1", Source("given")), "0.3"),
        (Number(6e5, "Pa", Source("given"), "gauge"), "600000 Pa g"),
        (Number(5.0034e-9, "m^3/(s Pa)", Source("given")), "5.0034e-09 m^3/(s Pa)"),
        (Number(0.1 + 0.2, "m", Source("given")), "0.3 m"),
    ],
)
def test_display(number, shown):
    assert number.display() == str(number) == shown


def test_helpers_set_the_source():
    assert assumed(0.35, "1", "none printed").source == Source("assumed", note="none printed")
    assert printed(1.0, "m", "Table 1", "as read", reference="absolute") == Number(
        1.0, "m", Source("paper", "Table 1", "as read"), "absolute"
    )
