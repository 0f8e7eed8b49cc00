"""Twin files: plan, clock and baseline, and all errors of a file together with their lines."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from poppet.core.errors import InputError
from poppet.monitoring.twin_file import ClockColumn, read_twin_file, twin_schema
from refusals import refused

EXAMPLE = Path(__file__).parents[3] / "examples/watch/twin.toml"
TEXT = EXAMPLE.read_text(encoding="utf-8").replace('"tank.toml"', f"'{EXAMPLE.with_name('tank.toml')}'")


@pytest.fixture
def twin(tmp_path):
    """Write the example with replaced texts, and return its path."""

    def write(*replacements):
        text = TEXT
        for old, new in replacements:
            assert old in text
            text = text.replace(old, new)
        path = tmp_path / "twin.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_the_example_is_a_plan():
    twin = read_twin_file(EXAMPLE)
    plan = twin.plan
    assert [fault.name for fault in plan.faults] == ["leak", "valve_clogged", "supply_low"]
    assert [item.column for item in (*plan.channels, *plan.inputs)] == ["p", "u", "w"]
    assert (plan.window, plan.alarm_delay, plan.hold) == (60.0, 2.0, True)
    assert (twin.clock, twin.baseline) == (ClockColumn("t", "s", 1.0), EXAMPLE.with_name("healthy.toml"))
    assert (twin.name, twin.title) == (str(EXAMPLE), "Compressed-air tank")


@pytest.mark.parametrize(
    ("time", "clock"),
    [
        ('time = "stamp"', ClockColumn("stamp", "s", 1.0)),
        ('time = { column = "t", unit = "ms" }', ClockColumn("t", "ms", 1e-3)),
        ("", ClockColumn("time", "s", 1.0)),
    ],
)
def test_forms_of_the_time(twin, time, clock):
    assert read_twin_file(twin(('time = { column = "t", unit = "s" }', time))).clock == clock


def test_values_of_the_file_replace_those_of_the_circuit(twin):
    path = twin(("[measured]", '[set]\n"tank.volume" = "12 l"\n\n[measured]'))
    assert read_twin_file(path).plan.circuit.parameters["tank.volume"] == 0.012


def test_the_title_is_that_of_the_circuit_by_default(twin):
    assert read_twin_file(twin(('title = "Compressed-air tank"\n', ""))).title == "Compressed-air tank"


def test_all_errors_have_their_lines(twin):
    path = twin(
        ("baseline", "basline"),
        ('unit = "s"', 'unit = "bar"'),
        ("tank.pressure", "tank.presure"),
        ('direction = "up"', 'direction = "upwards"'),
        ("relative_sigma = 0.05", "relative_sigma = -0.05"),
        ('window = "60 s"', 'window = "60 bar"'),
    )
    with pytest.raises(InputError) as caught:
        read_twin_file(path)
    lines = path.read_text(encoding="utf-8").splitlines()
    errors = {problem.address: problem for problem in caught.value.problems}
    words = {
        "basline": "basline",
        "time.unit": "time =",
        "measured.tank.presure": '"tank.presure" =',
        "faults.leak.direction": "upwards",
        "nuisance.use.sonic_conductance.relative_sigma": "-0.05",
        "watch.window": "60 bar",
    }
    assert errors.keys() == words.keys()
    assert [address for address, word in words.items() if word not in lines[errors[address].line - 1]] == []
    assert {problem.file for problem in errors.values()} == {str(path)}


@pytest.mark.parametrize(
    ("old", "new", "code", "address"),
    [
        ("baseline", "# baseline", "fields.missing", "baseline"),
        ('circuit = "', 'circuit = "no/', "toml.no_file", "circuit"),
        ('time = { column = "t", unit = "s" }', "time = 3", "fields.no_table", "time"),
        ("[nuisance] ", "[nuisances] ", "fields.unknown", "nuisances"),
        ("leak = {", '"my leak" = {', "watch.fault_name", "faults.my leak"),
        ("supply.pressure", "valve.sonic_conductance", "watch.same_address", "faults.supply_low.address"),
    ],
)
def test_errors_of_single_fields(twin, old, new, code, address):
    path = twin((old.replace('circuit = "', "circuit = '"), new.replace('circuit = "', "circuit = '")))
    with refused(code, address):
        read_twin_file(path)


def test_a_missing_file_suggests_twin_files(twin):
    path = twin()
    with refused("toml.no_file") as caught:
        read_twin_file(path.with_name("twn.toml"))
    assert caught.value.facts["suggestion"].names == ["twin.toml"]


def test_the_schema_accepts_the_example_and_rejects_other_fields():
    jsonschema = pytest.importorskip("jsonschema", reason="jsonschema is not installed")
    jsonschema.Draft202012Validator.check_schema(twin_schema())
    validator = jsonschema.Draft202012Validator(twin_schema())
    content = tomllib.loads(TEXT)
    assert validator.is_valid(content)
    for table, key, value in (
        ("watch", "windw", "60 s"),
        ("faults", "leak", {"alarm": 1e-9}),
        ("measured", "tank.pressure", {"columns": "p"}),
        ("nuisance", "ambient.pressure", {"relative_sigma": 0.0}),
    ):
        assert not validator.is_valid(content | {table: {key: value}}), table
