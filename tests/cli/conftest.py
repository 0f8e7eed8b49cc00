"""The command line called in this process, in a folder of its own."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest

from poppet.cli.main import run

TANKS = """
title = "Two tanks"

[parts.high]
kind = "chamber"
volume = "10 l"
initial_pressure = "6 bar g"

[parts.hole]
kind = "orifice"
from = "high"
to = "low"
sonic_conductance = "0.5 dm^3/(s bar)"
critical_ratio = 0.3

[parts.low]
kind = "chamber"
volume = "20 l"

[signals."hole.opening"]
kind = "steps"
times = ["0 s", "1 s"]
values = [0, 1]

[run]
duration = "5 s"
output_step = "0.5 s"
"""


class Answer(NamedTuple):
    """What a command returned and printed."""

    code: int
    out: str
    err: str


@pytest.fixture
def poppet(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Callable[..., Answer]:
    """Run `poppet ARGUMENTS` in an empty folder."""
    monkeypatch.chdir(tmp_path)

    def call(*arguments: str) -> Answer:
        code = run(arguments)
        printed = capsys.readouterr()
        return Answer(code, printed.out, printed.err)

    return call


@pytest.fixture
def tanks(tmp_path: Path) -> Path:
    """A small circuit file in that folder."""
    path = tmp_path / "tanks.toml"
    path.write_text(TANKS, encoding="utf-8")
    return path
