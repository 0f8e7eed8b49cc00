"""The command line called in this process, in a folder of its own."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest

from poppet.cli import main
from poppet.core.errors import InputError, PoppetError, SimulationError

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


class Mistake(NamedTuple):
    """A mistake that was told."""

    code: str
    address: str
    line: int | None
    nearest: str


class Refusal(Answer):
    """The same with what was raised on the way."""

    error: PoppetError

    @property
    def errors(self) -> list[Mistake]:
        """The mistakes, which are what was printed."""
        assert isinstance(self.error, InputError)
        said, _, more = self.err.partition("more: poppet explain ")
        assert said == "".join(f"error: {problem}\n" for problem in self.error.problems)
        assert set(more.split()) <= {problem.code for problem in self.error.problems}
        found = []
        for problem in self.error.problems:
            near = getattr(problem.facts.get("near"), "names", [])
            found.append(Mistake(problem.code, problem.address or "", problem.line, near[0] if near else ""))
        return found

    @property
    def codes(self) -> list[str]:
        """Codes of the mistakes, or of the failure."""
        if isinstance(self.error, SimulationError):
            return [self.error.note.code]
        return [mistake.code for mistake in self.errors]


@pytest.fixture
def poppet(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Callable[..., Answer]:
    """Run `poppet ARGUMENTS` in an empty folder."""
    monkeypatch.chdir(tmp_path)
    dispatch, raised = main._dispatch, []

    def recorded(arguments: list[str]) -> int:
        try:
            return dispatch(arguments)
        except PoppetError as error:
            raised.append(error)
            raise

    monkeypatch.setattr(main, "_dispatch", recorded)

    def call(*arguments: str) -> Answer:
        raised.clear()
        code = main.run(arguments)
        printed = capsys.readouterr()
        if not raised:
            return Answer(code, printed.out, printed.err)
        answer = Refusal(code, printed.out, printed.err)
        (answer.error,) = raised
        return answer

    return call


@pytest.fixture
def tanks(tmp_path: Path) -> Path:
    """A small circuit file in that folder."""
    path = tmp_path / "tanks.toml"
    path.write_text(TANKS, encoding="utf-8")
    return path
