"""Tests of files of other people: they are only data, unless an option permits the execution of code."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from circuits_of_ensembles import TABLES, TANK

FUNCTION = "import pathlib\npathlib.Path('executed').touch()\n\n\ndef f(time, p):\n    return float(p[-1])\n"
"""Python file that leaves a trace in the present folder when it is executed."""
COMMANDS = {
    "ensemble": ("ensemble", "bench/tank.toml", "--runs", "4", "-o", "out"),
    "size": ("size", "bench/tank.toml", "--free", "tank.volume", "--meet", "own"),
}


def write_circuit(folder: Path, location: str) -> None:
    """Write a circuit file with a metric by the function at `location`."""
    tables = TABLES.replace(
        "[requirements]", f'own = {{ of = "tank.pressure", metric = "{location}" }}\n[requirements]'
    )
    folder.mkdir(exist_ok=True)
    (folder / "tank.toml").write_text(TANK + tables + 'own = "own < 3e5"\n', encoding="utf-8")


@pytest.mark.parametrize("command", COMMANDS)
def test_python_file_is_executed_only_with_permission(poppet, tmp_path, command):
    write_circuit(tmp_path / "bench", "own.py:f")
    (tmp_path / "bench" / "own.py").write_text(FUNCTION, encoding="utf-8")
    assert poppet("check", "bench/tank.toml").code == 0
    answer = poppet(*COMMANDS[command])
    assert (answer.code, answer.codes) == (2, ["ensemble.python_forbidden"])
    assert answer.errors[0].address == "ensemble.metrics.own.metric"
    assert "--allow-python" in answer.err
    assert not (tmp_path / "executed").exists()
    assert not (tmp_path / "out").exists()
    answer = poppet(*COMMANDS[command], "--allow-python")
    assert answer.code == 0
    assert (tmp_path / "executed").exists()
    assert "own.py:f" in answer.out + answer.err
    if command == "ensemble":
        assert json.loads((tmp_path / "out" / "manifest.json").read_text())["python"] == ["own.py:f"]


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("way", ["parent", "absolute", "linked file", "linked folder"])
def test_python_file_elsewhere_is_never_executed(poppet, tmp_path, command, way):
    evil = tmp_path / "evil"
    evil.mkdir()
    (evil / "own.py").write_text(FUNCTION, encoding="utf-8")
    location = {"parent": "../evil/own.py:f", "absolute": f"{evil}/own.py:f", "linked folder": "sub/own.py:f"}
    write_circuit(tmp_path / "bench", location.get(way, "own.py:f"))
    if way == "linked file":
        (tmp_path / "bench" / "own.py").symlink_to("../evil/own.py")
    if way == "linked folder":
        (tmp_path / "bench" / "sub").symlink_to(os.path.relpath(evil, tmp_path / "bench"))
    for options in ((), ("--allow-python",)):
        answer = poppet(*COMMANDS[command], *options)
        assert (answer.code, answer.codes) == (2, ["ensemble.python_elsewhere"])
    assert poppet("check", "bench/tank.toml").codes == ["ensemble.python_elsewhere"]
    assert not (tmp_path / "executed").exists()


def test_python_file_below_the_folder_and_by_a_link_in_it_is_valid(poppet, tmp_path):
    write_circuit(tmp_path / "bench", "own.py:f")
    (tmp_path / "bench" / "sub").mkdir()
    (tmp_path / "bench" / "sub" / "real.py").write_text(FUNCTION, encoding="utf-8")
    (tmp_path / "bench" / "own.py").symlink_to("sub/real.py")
    assert poppet(*COMMANDS["ensemble"], "--allow-python").code == 0
