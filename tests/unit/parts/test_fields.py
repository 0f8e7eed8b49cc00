"""How parts read what is written about them: numbers, options, groups, sources."""

# ruff: noqa: RUF009 - fields are declared by calls
from __future__ import annotations

import dataclasses
import inspect
from dataclasses import dataclass
from typing import Any

import pytest

from poppet.core.errors import InputErrors, OutOfRangeError, UnitError
from poppet.core.provenance import Number, Source
from poppet.parts import KINDS, Chamber, CheckValve, MainStage, Orifice, Reservoir
from poppet.parts.fields import (
    NumberSpec,
    complete,
    declared,
    default_number,
    flatten,
    group,
    number,
    option,
    port,
    read_number,
    specs,
)
from refusals import refused

SPEC = NumberSpec("Pa", "supply pressure", kind="pressure", above=0.0)


@dataclass(frozen=True)
class Inner:
    rate: Any = number("N/m", doc="rate", low=0.0)
    preload: Any = number("m", "1 mm", doc="preload")


@dataclass(frozen=True)
class Outer:
    size: Any = number("m", doc="size", above=0.0)
    spare: Any = number("m", optional=True, doc="spare size")
    form: Any = option("round", "square", doc="form")
    to: Any = port("store it feeds")
    spring: Any = group(Inner, doc="the spring")
    extra: Any = group(Inner, doc="a second spring", optional=True)


def made(library: dict[str, Number] | None = None, **fields: Any) -> Outer:
    part = Outer(**{"to": "tank", **fields})
    complete(part, library or {})
    return part


def test_bare_number_is_si_and_given():
    result = read_number("p", SPEC, 6e5)
    assert (float(result), result.unit, result.source.kind, result.reference) == (6e5, "Pa", "given", "absolute")


def test_text_keeps_what_was_written():
    assert read_number("p", SPEC, "6 bar g") == Number(6e5, "Pa", Source("given"), "gauge", "6 bar g")


def test_table_carries_its_source():
    given = {"value": "7 bar", "source": "measured", "locator": "bench 3", "note": "mean of five"}
    result = read_number("p", SPEC, given)
    assert float(result) == 7e5
    assert result.source == Source("measured", "bench 3", "mean of five")


@pytest.mark.parametrize(
    ("given", "match"),
    [
        ({"valu": "7 bar"}, "fields.source_form"),
        ({"source": "measured"}, "fields.source_form"),
        ({"value": "7 bar", "source": "guessed"}, "fields.not_an_option"),
        ({"value": "7 bar", "sorce": "measured"}, "fields.source_form"),
    ],
)
def test_bad_table(given, match):
    with refused(match):
        read_number("p", SPEC, given)


@pytest.mark.parametrize(
    ("code", "given"),
    [
        *(("quantity.not_finite", given) for given in (float("nan"), float("inf"))),
        *(("quantity.not_a_number", given) for given in (True, [1.0], object())),
        *(("quantity.no_number", given) for given in ("nan bar", "", "bar")),
    ],
)
def test_values_other_than_finite_numbers_are_rejected(code, given):
    with refused(code, "p"):
        read_number("p", SPEC, given)


def test_number_of_another_unit_is_refused():
    with refused("fields.other_unit", "p"):
        read_number("p", SPEC, Number(1.0, "m", Source("given")))


def test_gauge_number_is_no_difference():
    spec = NumberSpec("Pa", "drop", kind="pressure_difference")
    with refused("fields.gauge_difference", "drop", kind=UnitError):
        read_number("drop", spec, Number(1e4, "Pa", Source("given"), "gauge"))


@pytest.mark.parametrize(
    ("limits", "value", "words"),
    [
        ({"low": 0.0}, -1.0, "at least 0 m"),
        ({"above": 0.0}, 0.0, "greater than 0 m"),
        ({"high": 1.0}, 1.1, "at most 1 m"),
        ({"below": 1.0}, 1.0, "less than 1 m"),
        ({"low": 0.0, "below": 1.0}, 1.0, "at least 0 and less than 1 m"),
    ],
)
def test_limits_are_named(limits, value, words):
    with refused("fields.out_of_range", "x", kind=OutOfRangeError) as caught:
        NumberSpec("m", "length", **limits).check("x", value, f"{value} m")
    assert caught.value.address == "x"
    assert caught.value.hint


def test_default_has_the_declared_source():
    spec = specs(Chamber)["initial_pressure"]
    result = default_number("p", spec)
    assert result is not None
    assert (float(result), result.source.kind) == (1e5, "standard")


def test_order_is_given_then_library_then_default():
    library = {
        "spring.rate": Number(5.0, "N/m", Source("assumed", note="a")),
        "spring.preload": Number(3.0, "m", Source("paper", "p. 1")),
    }
    part = made(library, size=1.0, spring={"rate": "7 N/m"})
    assert float(part.spring.rate) == 7.0
    assert float(part.spring.preload) == 3.0
    assert float(made(size=1.0, spring={"rate": 1.0}).spring.preload) == 1e-3


def test_optional_group_is_left_out_or_completed():
    assert made(size=1.0, spring={"rate": 1.0}).extra is None
    assert float(made(size=1.0, spring={"rate": 1.0}, extra={"rate": 2.0}).extra.preload) == 1e-3
    with_library = made({"extra.rate": Number(4.0, "N/m", Source("assumed", note="a"))}, size=1.0, spring={"rate": 1.0})
    assert float(with_library.extra.rate) == 4.0


def test_errors_of_a_part_are_reported_together():
    with pytest.raises(InputErrors) as caught:
        made(size=-1.0, form="triangle", to=3, spring={"rate": "5 m", "prelod": 1}, extra="stiff")
    addresses = [problem.address for problem in caught.value.problems]
    assert addresses == ["size", "form", "to", "spring.prelod", "spring.rate", "extra"]
    assert all(problem.given and problem.reason and problem.hint for problem in caught.value.problems)


def test_missing_fields_say_how_to_give_them():
    with pytest.raises(InputErrors) as caught:
        complete(Outer(), {})
    assert [str(problem) for problem in caught.value.problems] == [
        "size is missing: the size has no default. Specify the value in m.",
        "to is missing: the store it feeds must be the name of a part. "
        'Specify the name of a reservoir or a chamber, or "ambient" for the surroundings.',
        "spring.rate is missing: the rate has no default. Specify the value in N/m.",
    ]


def test_flatten_names_groups_with_dots():
    names = [name for name, _, _ in flatten(made(size=1.0, spring={"rate": 1.0}))]
    assert names == ["size", "spring.rate", "spring.preload"]


def test_from_is_a_field_and_from_with_underscore_an_attribute():
    assert "from" in specs(Orifice)
    assert Orifice(from_="a", to="b", sonic_conductance=1e-8).ports() == {"from": "a", "to": "b"}


def test_differences_refuse_gauge():
    with refused("quantity.gauge_difference", "cracking_pressure", kind=UnitError):
        CheckValve(from_="a", to="b", sonic_conductance=1e-8, cracking_pressure="0.1 bar g")


def test_copy_keeps_what_was_written():
    supply = Reservoir(pressure="6 bar g")
    assert dataclasses.replace(supply, temperature="30 degC").pressure == supply.pressure


class TestLibraryNumbersOfACopy:
    stage = MainStage(
        supply="a", outlet="b", exhaust="c", data="varga2012", plate_area="5 cm^2", lower_spring={"rate": "1 N/mm"}
    )

    def test_another_mode_brings_its_own_numbers(self):
        copy = dataclasses.replace(self.stage, mode="regulator")
        fresh = MainStage(
            supply="a",
            outlet="b",
            exhaust="c",
            data="varga2012",
            mode="regulator",
            plate_area="5 cm^2",
            lower_spring={"rate": "1 N/mm"},
        )
        assert copy.numbers() == fresh.numbers()

    def test_there_and_back(self):
        back = dataclasses.replace(dataclasses.replace(self.stage, mode="regulator"), mode="paper")
        assert back.numbers() == self.stage.numbers()

    def test_given_numbers_stay(self):
        copy = dataclasses.replace(self.stage, mode="regulator")
        assert copy.plate_area == self.stage.plate_area
        assert copy.lower_spring.rate == self.stage.lower_spring.rate

    def test_the_original_is_unchanged(self):
        before = self.stage.numbers()
        dataclasses.replace(self.stage, mode="regulator")
        assert self.stage.numbers() == before


@pytest.mark.parametrize("kind", KINDS)
def test_docstrings_have_the_declared_parameters(kind):
    part = KINDS[kind]
    lines = inspect.getdoc(part).splitlines()
    start = lines.index("Parameters") + 2
    names = [line.partition(" : ")[0] for line in lines[start:] if " : " in line and not line.startswith(" ")]
    # An argument has the name of the field where Python permits it, also if the attribute has another name.
    arguments = inspect.signature(part).parameters
    assert names == [name if name in arguments else attribute for name, attribute, _ in declared(part)]
    assert lines.count("Parameters") == 1


def test_a_docstring_has_types_defaults_units_and_meanings():
    text = inspect.getdoc(Chamber)
    assert "thermal : {'energy', 'isothermal', 'polytropic', 'isentrope'}, default 'energy'\n    Thermal law." in text
    assert "volume : number\n    Volume [m^3]." in text
    assert "wall_conductance : number, default 0.0\n    Wall conductance h A [W/K]." in text
    assert "polytropic_exponent : number, optional\n" in text
    assert text.index("Parameters\n---") < text.index("Notes\n---") < text.index("References\n---")
    assert "upper_spring : mapping\n    Upper spring k1, h1; includes the membrane: rate, preload." in MainStage.__doc__
