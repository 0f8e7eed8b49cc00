"""Every benchmark runs: its figures stand in the docs, so it has to be able to make them again."""

from __future__ import annotations

import importlib
import inspect
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[2] / "benchmarks"
SIZE = 0.01
NAMES = [path.stem for path in sorted(FOLDER.glob("*.py")) if "def main(" in path.read_text(encoding="utf-8")]


def test_each_is_called_by_make():
    makefile = (FOLDER.parent / "Makefile").read_text(encoding="utf-8")
    assert [name for name in NAMES if f"benchmarks/{name}.py" not in makefile] == []
    others = {path.stem for path in FOLDER.glob("*.py")} - set(NAMES)
    assert {name for name in others if not name.endswith("peer")} == set()


@pytest.mark.parametrize("name", NAMES)
def test_it_runs_at_a_tiny_size(name, monkeypatch, capsys):
    monkeypatch.syspath_prepend(str(FOLDER))
    main = importlib.import_module(name).main
    assert list(inspect.signature(main).parameters) == ["size"]
    main(SIZE)
    assert len(capsys.readouterr().out.splitlines()) >= 2
