"""Fields of all file formats that name a file: such a file is read as data and never executed.

The fields are collected from the declarations. Each one receives the names of hostile files. The fields whose files are
opened must be those of the list below, so a new one is noticed.
"""

from __future__ import annotations

import importlib
import pkgutil
import shutil
import sys
import tomllib
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest

import poppet
from circuits_of_ensembles import TABLES, TANK
from poppet.bench.iso10094.valve_recordings import read_valve_recordings
from poppet.core.errors import PoppetError
from poppet.core.tables import Field
from poppet.core.toml import toml_text
from poppet.ensemble import plan_of
from poppet.ensemble.ensemble_schema import file_schema
from poppet.identify.characteristic.characteristic_file import read_characteristic_file
from poppet.identify.design.design_file import read_design_file
from poppet.identify.fit.fit_plan import read_fit_file
from poppet.identify.flow.flow_file import read_flow_file
from poppet.identify.friction.friction_file import read_friction_file
from poppet.identify.muscle.muscle_file import read_muscle_file
from poppet.identify.tank.tank_plan import read_runs
from poppet.identify.tank.test import read_tank_file

EXAMPLES = Path(__file__).parents[2] / "examples"
PROBES = ("probe.toml", "probe.csv", "probe.py")
"""Files with Python code, under names that readers of a circuit, of a table and of a function could select."""
CODE = "import pathlib\npathlib.Path('executed').touch()\nf = len\n"
FILES = {
    "circuit": {"parts.*.characteristic", "parts.*.main_stage.characteristic", "parts.*.path", "signals.*.path",
                "ensemble.file", "components", "ensemble.parameters.from_fit"},
    "fit": {"circuit", "recordings.*.file", "recordings.*.*.file"},
    "design": {"circuit", "known"},
    "characteristic": {"circuit", "tests.file", "tests.result"},
    "flow": {"file"},
    "muscle": {"file"},
    "friction": {"file"},
    "tank": {"recordings.*.file", "recordings.*.*.file"},
    "bench": {"recordings.*.file", "recordings.*.*.file"},
}  # fmt: skip
"""Fields that name a file, by file format. Documented in SECURITY.md: these files are only data.

The field `metric` of the ensemble, which can name a Python file, is rejected without a permission.
"""
NOT_IN_FILES = {"mean", "volumes", "amplitudes", "springs", "dampings"}
"""Declared fields of options of commands, which are not in files."""


def _field_tables() -> Iterator[dict[str, Field]]:
    for module in pkgutil.walk_packages(poppet.__path__, "poppet."):
        if not module.name.endswith("__main__"):
            for value in vars(importlib.import_module(module.name)).values():
                if isinstance(value, dict) and value and all(isinstance(item, Field) for item in value.values()):
                    yield value


DECLARED = sorted(
    {
        name
        for table in _field_tables()
        for name, field in table.items()
        if not field.unit and not field.choices and field.type in ("value", "text", "string", "name")
    }
    - NOT_IN_FILES
)
"""Names of all fields of files except circuit files, without those that are numbers, choices or tables."""


def _can_be_a_path(schema: Mapping[str, Any]) -> bool:
    """Return True if a field of a circuit file accepts any text, but no number."""
    kinds = [schema, *schema.get("anyOf", ())]
    types = [kind.get("type") for kind in kinds]
    return any(kind.get("type") == "string" and "enum" not in kind for kind in kinds) and "number" not in types


def _properties(
    schema: Mapping[str, Any], definitions: Mapping[str, Any], path: tuple[str, ...]
) -> Iterator[tuple[str, ...]]:
    """Yield the paths of all fields of a JSON schema."""
    if "$ref" in schema:
        schema = definitions[schema["$ref"].rpartition("/")[2]]
    for name, inner in schema.get("properties", {}).items():
        if name != "kind":
            if _can_be_a_path(inner):
                yield (*path, name)
            yield from _properties(inner, definitions, (*path, name))


def _circuit_cases() -> Iterator[tuple[str, dict[str, Any], tuple[str, ...]]]:
    """Yield label, tables and path of each field of a circuit file."""
    schema = file_schema()
    definitions = schema["$defs"]
    base = tomllib.loads(TANK + TABLES)
    for kind in poppet.parts.KINDS:
        for path in _properties(definitions[kind], definitions, ()):
            tables = deepcopy(base)
            required = [key for key in definitions[kind].get("required", ()) if key != "kind"]
            texts = [key for key in required if _can_be_a_path(definitions[kind]["properties"][key])]
            tables["parts"]["probed"] = {"kind": kind, **{k: "tank" if k in texts else 1e-3 for k in required}}
            if kind == "proportional_valve":  # its members have the values of a library set
                tables["parts"]["probed"]["data"] = "varga2012"
            yield ".".join(("parts", "*", *path)), tables, ("parts", "probed", *path)
    for name, definition in definitions.items():
        if name.startswith("signal_"):
            names = [path[0] for path in _properties(definition, definitions, ())]
            for field in names:
                tables = deepcopy(base)
                values = dict.fromkeys(names, "pressure")
                tables["signals"] = {"hole.opening": {"kind": name.removeprefix("signal_"), **values}}
                required = definition.get("required", [])
                table = tables["signals"]["hole.opening"]
                tables["signals"]["hole.opening"] = {k: v for k, v in table.items() if k in required or k == "kind"}
                yield f"signals.*.{field}", tables, ("signals", "hole.opening", field)
        if name.startswith(("metric", "distribution")):
            owner, key = ("metrics", "end") if name.startswith("metric") else ("parameters", "tank.volume")
            for path in _properties(definition, definitions, ()):
                yield f"ensemble.{owner}.*.{path[0]}", base, ("ensemble", owner, key, path[0])
    for top in (
        "title",
        "components",
        "ambient",
        "gas",
        "run",
        "ensemble",
        "requirements",
        "connections",
        "parts",
        "signals",
    ):
        yield top, base, (top,)
        for path in _properties(schema["properties"][top], definitions, (top,)):
            tables = deepcopy(base)
            if path == ("ensemble", "file"):
                tables["ensemble"] = {"sampling": "file", "metrics": tables["ensemble"]["metrics"]}
            yield ".".join(path), tables, path
    yield "ensemble.parameters.from_fit", base, ("ensemble", "parameters", "from_fit")
    yield "ensemble.metrics.*.metric", base, ("ensemble", "metrics", "end", "metric")


def _read_circuit(path: Path) -> None:
    circuit = poppet.load(path)
    if "probe" in repr(circuit.origin[0].get("ensemble")):  # the model is traced: slow
        plan_of(circuit)


READERS: dict[str, tuple[str, Callable[[Path], Any]]] = {
    "fit": ("identify/fit.toml", read_fit_file),
    "design": ("identify/design.toml", read_design_file),
    "characteristic": ("identify/characteristic.toml", read_characteristic_file),
    "flow": ("identify/flow.toml", read_flow_file),
    "muscle": ("identify/muscle.toml", read_muscle_file),
    "friction": ("identify/friction.toml", read_friction_file),
    "tank": ("identify/tank.toml", lambda path: read_runs(read_tank_file(path))),
    "bench": ("bench/recordings.toml", lambda path: read_valve_recordings(tomllib.loads(path.read_text()), path)),
}


def _other_cases(name: str) -> Iterator[tuple[str, dict[str, Any], tuple[Any, ...]]]:
    """Yield label, tables and path of each declared field in each table of an example."""
    base = tomllib.loads((EXAMPLES / READERS[name][0]).read_text(encoding="utf-8"))
    if "recordings" in base:  # one is sufficient
        base["recordings"] = dict(list(base["recordings"].items())[:1])
    if name == "characteristic":
        base["tests"] = base["tests"][:1]
        del base["tests"][0]["file"]

    def tables_in(
        table: Any, path: tuple[Any, ...], label: tuple[str, ...]
    ) -> Iterator[tuple[tuple[Any, ...], tuple[str, ...]]]:
        yield path, label
        items = table.items() if isinstance(table, dict) else ()
        for key, value in items:
            if isinstance(value, dict):
                yield from tables_in(value, (*path, key), (*label, key if not label else "*"))
        if "tests" in table and isinstance(table["tests"], list):
            yield ("tests", 0), ("tests",)

    for path, label in tables_in(base, (), ()):
        for field in DECLARED:
            yield ".".join((*label, field)), base, (*path, field)


opened: list[str] | None = None


def _audit(event: str, arguments: tuple[Any, ...]) -> None:
    if opened is not None and event == "open" and isinstance(arguments[0], str) and "probe" in Path(arguments[0]).name:
        opened.append(arguments[0])


sys.addaudithook(_audit)


def fields_that_open_files(folder: Path, name: str) -> set[str]:
    """Return the fields of a format whose files are opened; each field receives the names of hostile files."""
    global opened
    file, reader = ("circuit.toml", _read_circuit) if name == "circuit" else READERS[name]
    path = folder / Path(file).name
    found = set()
    for label, base, address in _circuit_cases() if name == "circuit" else _other_cases(name):
        if label in found:
            continue
        for probe in PROBES:
            tables = deepcopy(base)
            table: Any = tables
            for key in address[:-1]:
                table = table.setdefault(key, {}) if isinstance(table, dict) else table[key]
                if not isinstance(table, dict | list):
                    break
            else:
                table[address[-1]] = [probe] if address == ("components",) else probe
                path.write_text(toml_text(tables), encoding="utf-8")
                opened = []
                with suppress(PoppetError):
                    reader(path)
                if opened:
                    found.add(label)
                opened = None
    return found


@pytest.mark.parametrize("name", FILES)
def test_fields_that_name_a_file_never_execute_it(tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "files"
    shutil.copytree(EXAMPLES / Path("bench" if name == "bench" else "identify"), folder)
    for probe in PROBES:
        (folder / probe.partition(":")[0]).write_text(CODE, encoding="utf-8")
    found = fields_that_open_files(folder, name)
    assert not (tmp_path / "executed").exists()
    assert not (folder / "executed").exists()
    assert {label for label in found if not label.startswith("ensemble.metrics")} == FILES[name]
    assert not any(label.startswith("ensemble.metrics") for label in found)


def test_the_probe_is_executed_where_python_is_permitted(tmp_path, monkeypatch):
    """The test above can fail."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "probe.py").write_text(CODE, encoding="utf-8")
    text = TANK + TABLES.partition("[requirements]")[0].replace('metric = "final"', 'metric = "probe.py:f"')
    (tmp_path / "circuit.toml").write_text(text, encoding="utf-8")
    plan = plan_of(poppet.load(tmp_path / "circuit.toml"), allow_python=True)
    assert not (tmp_path / "executed").exists()
    plan.metrics[0].callable()
    assert (tmp_path / "executed").exists()
