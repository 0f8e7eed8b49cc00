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
    """Exit code and output of a command."""

    code: int
    out: str
    err: str


class ReportedError(NamedTuple):
    """Error that a command reported."""

    code: str
    address: str
    line: int | None
    nearest: str


class Refusal(Answer):
    """Answer with the error that was raised."""

    error: PoppetError

    @property
    def errors(self) -> list[ReportedError]:
        """Errors, which equal the printed ones."""
        assert isinstance(self.error, InputError)
        printed, _, codes = self.err.partition("more: poppet explain ")
        assert printed == "".join(f"error: {problem}\n" for problem in self.error.problems)
        assert set(codes.split()) <= {problem.code for problem in self.error.problems}
        reported = []
        for problem in self.error.problems:
            near = getattr(problem.facts.get("suggestion"), "names", [])
            reported.append(ReportedError(problem.code, problem.address or "", problem.line, near[0] if near else ""))
        return reported

    @property
    def codes(self) -> list[str]:
        """Codes of the errors, or of the failure."""
        if isinstance(self.error, SimulationError):
            return [self.error.note.code]
        return [error.code for error in self.errors]


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
