"""Folder of circuits for the tests of the functions for assistants."""

from __future__ import annotations

import re
from importlib.resources import files

import pytest


def tank() -> str:
    """Circuit of the guide for assistants, whose valve is open from the start."""
    guide = (files("poppet.assist") / "llms.txt").read_text(encoding="utf-8")
    (example,) = re.findall(r"^```toml\n(.*?)^```$", guide, re.MULTILINE | re.DOTALL)
    return re.sub(r"^\[signals\..*?\n\n", "", example, flags=re.MULTILINE | re.DOTALL)


@pytest.fixture
def folder(tmp_path):
    """Folder with a circuit, inside a folder with a secret."""
    (tmp_path / "secret.toml").write_text("key = 1\n")
    inside = tmp_path / "circuits"
    inside.mkdir()
    (inside / "tank.toml").write_text(tank())
    return inside
