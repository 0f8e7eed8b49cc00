"""Texts for assistants: they are those of the present declarations, and their example is valid."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import poppet
from poppet.assist.arguments import declared_arguments
from poppet.assist.catalogue import find_components
from poppet.assist.circuits import check
from poppet.assist.folder import Folder
from poppet.assist.functions import FUNCTIONS
from poppet.assist.kinds import SERIES, built_in_kinds, describe_kind, explain, list_kinds
from poppet.assist.studies import METHODS
from poppet.circuit.schema import circuit_schema
from poppet.identify.methods import BUILT_IN
from poppet.parts import KINDS

ROOT = Path(__file__).parents[2]
SPEC = importlib.util.spec_from_file_location("assistant_reference", ROOT / "tools" / "assistant_reference.py")
reference = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(reference)
ADVICE = "run python tools/assistant_reference.py"


def test_the_inputs_and_outputs_are_those_of_the_examples():
    assert SERIES.read_text(encoding="utf-8") == reference.series_json(), ADVICE


def test_the_texts_are_those_of_the_declarations():
    for path, text in reference.texts().items():
        assert path.read_text(encoding="utf-8") == text, ADVICE


def test_the_example_of_the_guide_is_valid():
    assert reference.EXAMPLE in reference.guide_text()
    assert poppet.loads(reference.EXAMPLE).simulate()["tank.pressure"][-1] > 1.5e5


def test_each_kind_has_all_fields_of_the_schema(tmp_path):
    folder = Folder.of(tmp_path)
    definitions = circuit_schema()["$defs"]
    for kind in built_in_kinds():
        fields = {name.partition(".")[0] for name in describe_kind(folder, kind)["fields"]}
        assert fields == definitions[kind]["properties"].keys() - {"kind"}, kind
    assert list(list_kinds(folder)["kinds"]) == list(built_in_kinds())
    assert describe_kind(folder, "steps")["fields"]["times"] == {"is_required": True}
    cylinder = describe_kind(folder, "cylinder")["fields"]
    assert cylinder["rod_cushion.length"]["is_required"] == "with rod_cushion"
    assert cylinder["body"]["is_required"] is True
    assert describe_kind(folder, "metric max")["fields"]["of"]["is_required"]
    assert "relative_sigma" in describe_kind(folder, "distribution normal")["fields"]
    assert {f"identify {method}" for method in METHODS} <= {*list_kinds(folder)["described_tables"]}
    assert all(describe_kind(folder, table)["fields"] for table in list_kinds(folder)["described_tables"])
    assert describe_kind(folder, "run")["fields"]["duration"]["unit"] == "s"


VALVE = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"

[parts.valve]
kind = "spool_valve"
model = "{model}"
function = "5/2 monostable"
supply = "supply"
a = "first"
b = "second"

[parts.first]
kind = "chamber"
volume = "1 l"

[parts.second]
kind = "chamber"
volume = "1 l"
"""


def test_a_component_that_is_found_is_a_model_of_a_part(tmp_path):
    folder = Folder.of(tmp_path)
    result = find_components(folder, "5/2, C > 3 dm^3/(s bar)")
    assert result["count"] >= len(result["components"]) > 0
    assert all(row["document"] and row["kinds"] == ["spool_valve"] for row in result["components"])
    assert check(folder, text=VALVE.format(model=result["components"][0]["model"]))["is_valid"]


def test_a_code_and_a_kind_are_explained(tmp_path):
    folder = Folder.of(tmp_path)
    assert explain(folder, "fields.missing").keys() == {"code", "message", "cause", "example", "remedy"}
    assert "fields.missing" in explain(folder, "fields")["codes"]
    assert explain(folder, "wiring.no_input")["code"] == "names.unknown"
    assert explain(folder, "orifice")["exactly_one_of"]


def test_kinds_of_plugins_are_not_listed(monkeypatch):
    monkeypatch.setitem(KINDS.data, "gadget", KINDS["orifice"])
    assert "gadget" in KINDS
    assert "gadget" not in built_in_kinds()


def test_the_methods_are_those_of_the_package():
    assert tuple(method.name for method in BUILT_IN) == METHODS


def test_every_function_has_a_summary_and_meanings():
    for name, function in FUNCTIONS.items():
        assert function.summary.endswith("."), name
        assert all(argument.argument.meaning for argument in declared_arguments(function.run)), name
        assert function.schema["additionalProperties"] is False
