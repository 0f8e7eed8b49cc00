"""Plugins: packages that are installed in a folder, without a network, and used from Python and the command line."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

from poppet.core.plugins import GROUPS, PluginWarning, Registry

HERE = Path(__file__).parent
TOY = {
    "poppet.parts": ["toy_membrane = toy_plugin:Membrane"],
    "poppet.library": ["toy_set = toy_plugin:SET"],
    "poppet.readers": ["toy = toy_plugin:read"],
    "poppet.targets": ["toy = toy_target:TARGET"],
    "poppet.methods": ["toy_mean = toy_method:METHOD"],
    "poppet.components": ["toy = toy_plugin:COMPONENTS"],
}
BROKEN = {
    "poppet.parts": [
        "reservoir = toy_plugin:Membrane",
        "other_name = toy_plugin:WrongKind",
        "old = old_plugin:PART",
        "broken = broken_plugin:PART",
        "absent = toy_plugin:Absent",
    ],
    "poppet.library": ["broken_set = broken_plugin:SET"],
    "poppet.readers": [".csv = toy_plugin:read"],
}
CIRCUIT = """
[parts.supply]
kind = "reservoir"
pressure = "2 bar"
[parts.skin]
kind = "toy_membrane"
from = "supply"
to = "tank"
[parts.tank]
kind = "chamber"
volume = "1 l"
thermal = "isothermal"
[run]
duration = "1 s"
"""


def install(folder: Path, name: str, entries: dict[str, list[str]]) -> None:
    """Write the metadata of an installed package, as pip does."""
    info = folder / f"{name}-1.0.dist-info"
    info.mkdir(parents=True)
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(
        "".join(f"[{group}]\n" + "".join(f"{entry}\n" for entry in lines) for group, lines in entries.items())
    )


@pytest.fixture(scope="module")
def environment(tmp_path_factory) -> dict[str, str]:
    """Environment of a process with the toy package and a package with invalid plugins."""
    folder = tmp_path_factory.mktemp("site")
    install(folder, "toy", TOY)
    install(folder, "broken", BROKEN)
    path = os.pathsep.join([str(folder), str(HERE), *sys.path])
    return os.environ | {"PYTHONPATH": path}


def run(environment: dict[str, str], *arguments: str, folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *arguments], env=environment, cwd=folder, capture_output=True, text=True, timeout=120
    )


def test_a_plugin_of_each_group_is_used(environment, tmp_path):
    (tmp_path / "circuit.toml").write_text(CIRCUIT)
    (tmp_path / "bench.toy").write_text("0|1.5\n1|2.5\n")
    script = """
import warnings, pathlib, poppet
warnings.simplefilter("ignore")
recording = poppet.load("circuit.toml").simulate()
assert recording["tank.pressure"][-1] > 1e5, recording["tank.pressure"]
from poppet.timeseries.tables.reading import read_table
assert read_table(pathlib.Path("bench.toy")).columns[1].tolist() == [1.5, 2.5]
from poppet import library
assert "toy_set" in library.sets()
assert "toy catalogue" in library.describe("toy_set")
check = poppet.CheckValve(from_="a", to="b", model="Toy works CV1")
assert check.sonic_conductance.value == 2e-8 and "toy catalogue" in check.sonic_conductance.source.locator
muscle = poppet.InverseMuscle(data="toy_set", nominal_diameter="20 mm", law="tondu_lopez", braid_angle="25 deg",
                              highest_pressure="6 bar g")
assert muscle.nominal_length.value == 0.2
assert muscle.nominal_length.source.locator == "toy catalogue"
"""
    done = run(environment, "-c", script, folder=tmp_path)
    assert done.returncode == 0, done.stderr


def test_palette_of_the_editor_has_the_kinds_of_plugins(environment, tmp_path):
    script = """
import json, warnings
warnings.simplefilter("ignore")
from poppet.edit.palette import palette
print(json.dumps(palette()[-1]))
"""
    done = run(environment, "-c", script, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    entry = json.loads(done.stdout)
    assert (entry["kind"], entry["group"]) == ("toy_membrane", "other")
    assert [(port["name"], port["side"], port["required"]) for port in entry["ports"]] == [
        ("from", "left", True),
        ("to", "right", True),
    ]
    assert entry["svg"].startswith("<path ")
    assert entry["fields"][0]["unit"] == "kg/(s Pa)"


def test_the_command_line_lists_plugins_and_notes_those_that_it_ignores(environment, tmp_path):
    (tmp_path / "circuit.toml").write_text(CIRCUIT)
    shown = run(environment, "-m", "poppet", "show", "circuit.toml", folder=tmp_path)
    assert shown.returncode == 0
    assert "skin.permeance" in shown.stdout
    notes = [line for line in shown.stderr.splitlines() if line.startswith("note: ")]
    assert [line.split('"')[1] for line in notes] == ["reservoir", "other_name", "old", "broken", "absent"]
    assert "a_package_that_is_not_installed" in shown.stderr
    listed = run(environment, "-m", "poppet", "library", folder=tmp_path)
    assert "toy_set" in listed.stdout
    assert "broken_set" in listed.stderr
    schema = run(environment, "-m", "poppet", "schema", folder=tmp_path)
    assert '"toy_membrane"' in schema.stdout
    assert '"toy_set"' in schema.stdout


def test_an_export_target_is_a_command(environment, tmp_path):
    (tmp_path / "circuit.toml").write_text(CIRCUIT)
    listed = run(environment, "-m", "poppet", "--help", folder=tmp_path)
    assert "numbers of a circuit as text" in listed.stdout
    done = run(environment, "-m", "poppet", "export", "toy", "circuit.toml", "-o", "numbers.txt", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "tank.volume = 1 l" in (tmp_path / "numbers.txt").read_text()


@pytest.mark.skipif(find_spec("poppet.identify.methods") is None, reason="methods are not in a registry")
def test_an_identification_method_is_a_command(environment, tmp_path):
    (tmp_path / "values.txt").write_text("1.0\n3.0\n")
    listed = run(environment, "-m", "poppet", "identify", "--help", folder=tmp_path)
    assert "toy_mean" in listed.stdout
    done = run(environment, "-m", "poppet", "identify", "toy_mean", "values.txt", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "mean 2" in done.stdout


def test_invalid_plugins_are_ignored_with_a_warning(tmp_path, monkeypatch):
    install(tmp_path, "toy", TOY)
    install(tmp_path, "broken", BROKEN)
    monkeypatch.syspath_prepend(str(HERE))
    monkeypatch.syspath_prepend(str(tmp_path))
    kinds = Registry("poppet.parts", {"reservoir": "poppet.parts.sources:Reservoir"}, lambda n, v: v.kind == n)
    assert kinds["reservoir"].kind == "reservoir"
    assert not kinds.is_extended
    with pytest.warns(PluginWarning) as caught:
        assert "toy_membrane" in kinds
    codes = {warning.message.note.address: warning.message.note.code for warning in caught}
    assert codes == {
        "reservoir": "plugins.duplicate",
        "other_name": "plugins.invalid",
        "old": "plugins.version",
        "broken": "plugins.failed",
        "absent": "plugins.failed",
    }
    assert {warning.message.note.facts["package"] for warning in caught} == {"broken"}
    assert [*kinds] == ["reservoir", "toy_membrane"]
    assert kinds["toy_membrane"].kind == "toy_membrane"
    with pytest.raises(KeyError):
        kinds["broken"]


def test_the_import_does_not_read_plugins(environment, tmp_path):
    script = "import sys, poppet, poppet.parts; assert not {'importlib.metadata', 'toy_plugin'} & set(sys.modules)"
    done = run(environment, "-c", script, folder=tmp_path)
    assert done.returncode == 0, done.stderr


def test_the_groups_are_those_of_the_page():
    page = (HERE.parents[1] / "docs" / "plugins.md").read_text(encoding="utf-8")
    assert [group for group in GROUPS if f'"{group}"' not in page] == []
