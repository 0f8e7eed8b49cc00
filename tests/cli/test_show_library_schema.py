"""Tests of `poppet show`, `poppet library` and `poppet schema`."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest

from poppet import library
from poppet.cli.circuit_files import TEMPLATES
from poppet.ensemble.ensemble_schema import file_schema
from poppet.parts import KINDS
from poppet.parts.fields import specs

FOLDER = Path(__file__).parents[2] / "examples"
EXAMPLES = sorted([*FOLDER.glob("*.toml"), *FOLDER.glob("serve/*.toml")])


def test_show_lists_assumed_parameters_first(poppet):
    poppet("new", "datasheet-valve")
    code, out, _ = poppet("show", "datasheet-valve.toml")
    headings = [line.split(" (")[0] for line in out.splitlines() if line and not line.startswith(" ")]
    assert code == 0
    assert headings[1:] == ["assumed", "datasheet", "given", "standard"]
    rows = [line.split() for line in out.splitlines()]
    assert [
        "valve.nominal_flow",
        "380",
        "l/min",
        "ANR",
        "0.00633333",
        "m^3/s",
        "ANR",
        "catalogue,",
        "page",
        "...",
    ] in rows


def test_show_one_kind(poppet):
    poppet("new", "datasheet-valve")
    _, out, _ = poppet("show", "datasheet-valve.toml", "--kind", "datasheet")
    assert "datasheet (4)" in out
    assert "assumed" not in out
    _, out, _ = poppet("show", "datasheet-valve.toml", "--kind", "measured")
    assert out.endswith("measured: none\n")


def test_show_json_has_absolute_values(poppet, tanks):
    code, out, _ = poppet("show", "tanks.toml", "--json", "--set", "high.initial_pressure=5 bar g")
    assert code == 0
    numbers = {entry["address"]: entry for entry in json.loads(out)["numbers"]}
    pressure = numbers["high.initial_pressure"]
    assert (pressure["written"], pressure["value"], pressure["unit"], pressure["source"]) == (
        "5 bar g",
        6e5,
        "Pa",
        "given",
    )
    assert numbers["gas.gas_constant"]["source"] == "standard"
    assert {"hole.sonic_conductance", "low.volume", "ambient.temperature"} <= set(numbers)


def test_show_refuses_an_unknown_kind(poppet, tanks):
    answer = poppet("show", "tanks.toml", "--kind", "asumed")
    assert (answer.code, answer.errors) == (2, [("fields.not_an_option", "--kind", None, "assumed")])


def test_library_lists_and_describes(poppet):
    code, out, _ = poppet("library")
    assert code == 0
    names = [*library.sets(), *library.characteristics(), *library.gas_names()]
    assert [name for name in names if name not in out] == []
    assert poppet("library", "argon").out == library.describe("argon") + "\n"
    assert [name for name in names if poppet("library", name).code != 0] == []
    answer = poppet("library", "varga2021")
    assert (answer.code, answer.errors) == (2, [("library.unknown", "", None, "varga2012")])


def test_library_prints_the_passport_of_a_component(poppet):
    code, out, _ = poppet("library", "SMC SY5000")
    assert code == 0
    assert "746 l/min ANR" in out
    assert "flow path and configuration not stated" in out
    for name in ("SMC SY500", "SY5000"):
        answer = poppet("library", name)
        assert (answer.code, answer.errors[0][0]) == (2, "components.unknown")


def test_library_lists_components_and_finds_some(poppet, tmp_path):
    assert "Festo CRVZS-0.1" in poppet("library", "--components").out
    found = poppet("library", "--find", "cylinder, bore > 100 mm").out
    assert [line.split("  ")[0] for line in found.splitlines()[1:]] == ["Camozzi 63M.6/7 bore 125 ?"]
    assert poppet("library", "--find", "cylinder, bore > 1 m").out == "No component fulfils all conditions.\n"
    path = tmp_path / "own.toml"
    path.write_text(
        'manufacturer = "Acme"\n[components.V1]\nkinds = ["orifice"]\ndocument = "sheet"\n'
        'fields = { sonic_conductance = "1 dm^3/(s bar)" }\n'
    )
    assert "Acme V1" in poppet("library", "--components", str(path)).out
    assert "1 dm^3/(s bar)" in poppet("library", "Acme V1", "--components", str(path)).out
    path.write_text("manufacturer = 3\n")
    assert poppet("library", "--components", str(path)).code == 2


def test_schema_is_printed_or_written(poppet, tmp_path):
    assert json.loads(poppet("schema").out) == file_schema()
    code, out, _ = poppet("schema", "-o", "circuit.schema.json")
    assert code == 0
    assert out.startswith("circuit.schema.json: written.")
    assert json.loads((tmp_path / "circuit.schema.json").read_text()) == file_schema()
    assert poppet("schema", "-o", "circuit.yaml").code == 2


@pytest.mark.parametrize("kind", KINDS)
def test_schema_has_every_field_of_every_part_and_no_other(kind):
    part = file_schema()["$defs"][kind]
    assert set(part["properties"]) == {"kind", *specs(KINDS[kind])}
    assert part["additionalProperties"] is False


@pytest.fixture(scope="module")
def validator():
    """A validator for circuit files; the schema itself is checked on the way."""
    jsonschema = pytest.importorskip("jsonschema", reason="jsonschema is not installed")
    jsonschema.Draft202012Validator.check_schema(file_schema())
    return jsonschema.Draft202012Validator(file_schema())


@pytest.mark.parametrize("path", [*TEMPLATES.values(), *EXAMPLES], ids=lambda path: path.stem)
def test_schema_accepts_templates_and_examples(validator, path):
    table = tomllib.loads(path.read_text(encoding="utf-8"))
    assert [error.message for error in validator.iter_errors(table)] == []


@pytest.mark.parametrize(
    ("good", "bad"),
    [
        ("volume =", "volmue ="),
        ('kind = "chamber"', 'kind = "chambre"'),
        ("times =", "time ="),
        ("critical_ratio = 0.3", "critical_ratio = 1.3"),
        ("duration =", "duratoin ="),
        ('thermal = "energy"', 'thermal = "enrgy"'),
        ('kind = "steps"', 'kind = "stpes"'),
        ("title =", "titel ="),
        ('data = "varga2012"', 'data = "varga2021"'),
        ('from = "tank"', 'form = "tank"'),
        ('"0.2 m^3"', "{ vlaue = 0.2 }"),
    ],
)
def test_schema_refuses_a_misspelling(validator, good, bad):
    text = TEMPLATES["valve-fill"].read_text(encoding="utf-8")
    assert good in text
    assert not validator.is_valid(tomllib.loads(text.replace(good, bad, 1)))


def test_schema_accepts_nested_and_bare_signals(validator):
    text = TEMPLATES["valve-fill"].read_text(encoding="utf-8")
    nested = text.replace('[signals."valve.pilot_pressure"]', "[signals.valve.pilot_pressure]")
    assert validator.is_valid(tomllib.loads(nested))
    assert not validator.is_valid(tomllib.loads(nested.replace("times =", "tmies =")))
    table = tomllib.loads(text)
    table["signals"] = {"valve.pilot_pressure": "2 bar g"}
    assert validator.is_valid(table)


def test_schema_tells_parts_and_wires_of_a_drawing_apart(validator):
    text = TEMPLATES["valve-fill"].read_text(encoding="utf-8")
    for entry, is_valid in [
        ("tank = { x = 1, y = 2.5, rotation = 90 }", True),
        ('"valve.outlet" = { points = [[1, 2], [1, 4.5]] }', True),
        ("tank = { points = [[1, 2]] }", False),
        ('"valve.outlet" = { x = 1, y = 2 }', False),
        ('"valve.outlet" = { points = [[1, 2, 3]] }', False),
        ('"valve.outlet" = { points = [] }', False),
    ]:
        assert validator.is_valid(tomllib.loads(f"{text}\n[drawing]\n{entry}\n")) == is_valid, entry
