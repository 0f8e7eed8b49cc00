"""The wheel holds what the program needs, and nothing else is needed to use it."""

from __future__ import annotations

import runpy
import tarfile
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
pytest.importorskip("hatchling")
TOOL = runpy.run_path(str(ROOT / "tools" / "package.py"))


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    return TOOL["built"](tmp_path_factory.mktemp("dist"))


def test_the_wheel_holds_every_file_of_the_sources(files):
    inside = set(zipfile.ZipFile(files[0]).namelist())
    sources = {
        path.relative_to(ROOT / "src").as_posix()
        for path in (ROOT / "src" / "poppet").rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    assert {name for name in inside if name.startswith("poppet/")} == sources


def test_the_sdist_holds_no_measured_data_and_no_build(files):
    with tarfile.open(files[1]) as archive:
        names = [name.partition("/")[2] for name in archive.getnames()]
    assert "pyproject.toml" in names
    assert [name for name in names if name.startswith((".venv", "build/", "dist/", "paper/"))] == []


def test_an_empty_environment_is_enough(files, tmp_path):
    for each in files[:1]:
        TOOL["tried"](each, tmp_path)
