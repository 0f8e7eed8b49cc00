"""Commands `poppet audit safety` and `poppet faults`: tables, files, progress and errors."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest

import poppet
from poppet.audit import safety_runs
from poppet.audit.fault_result import FaultTable
from poppet.cli.main import run
from poppet.core.errors import InputError

MACHINE = str(Path(poppet.__file__).parent / "cli" / "templates" / "machine.toml")
AUDIT = ["audit", "safety", MACHINE, "--event", "supply.pressure=0 bar g"]


def test_the_audit_prints_the_worst_and_writes_all(tmp_path, capsys):
    result, page = tmp_path / "safety.toml", tmp_path / "safety.html"
    options = ["--at", "1.6 s", "--duration", "2 s", "--kinds", "stuck", "-o", str(result), "--report", str(page)]
    assert run([*AUDIT, *options]) == 0
    text = capsys.readouterr().out
    assert "Event supply.pressure = 0 bar g, at t = 1.6 s." in text
    assert "remains below 0.5 bar g" in text
    assert "not within 2 s" in text
    assert "trapped by" in text
    assert "ISO 13849" in text
    content = tomllib.loads(result.read_text())
    assert {row["fault"] for row in content["exhaust"]} >= {"", "valveA.stuck", "valveB.stuck"}
    assert {row["body"] for row in content["travel"]} == {"slideA", "slideB"}
    assert "<html" in page.read_text()


def test_moments_of_the_steps_without_faults(tmp_path, capsys):
    path = tmp_path / "safety.json"
    options = ["--at", "steps", "--duration", "0.5 s", "--kinds", "", "-o", str(path)]
    assert run([*AUDIT, *options]) == 0
    captured = capsys.readouterr()
    assert "at 20 moments; each row has the worst" in captured.out
    assert "No fault was simulated" in captured.err
    assert len(json.loads(path.read_text())["moments"]) == 20


def test_an_interrupted_audit_keeps_what_is_complete(tmp_path, monkeypatch, capsys):
    def run_all(self, cases):
        yield cases[0], self.run(cases[0])
        raise KeyboardInterrupt

    monkeypatch.setattr(safety_runs.SafetyRuns, "run_all", run_all)
    path = tmp_path / "safety.toml"
    assert run([*AUDIT, "--at", "1.6 s", "--duration", "1 s", "-o", str(path)]) == 130
    content = tomllib.loads(path.read_text())
    assert content["is_whole"] is False
    assert {row["fault"] for row in content["exhaust"]} == {""}
    assert "interrupted" in capsys.readouterr().err


def test_a_file_that_cannot_be_written_does_not_lose_the_table(tmp_path, monkeypatch, capsys):
    def save(self, path):
        raise InputError("files.unwritable", path=str(path), why="read-only")

    monkeypatch.setattr(FaultTable, "save", save)
    assert run(["faults", MACHINE, "--kinds", "stuck_open", "-o", str(tmp_path / "faults.toml")]) == 2
    captured = capsys.readouterr()
    assert "valveA.stuck_open" in captured.out
    assert "cannot be written" in captured.err


def test_the_fault_table(tmp_path, capsys):
    result, page = tmp_path / "faults.toml", tmp_path / "faults.html"
    assert run(["faults", MACHINE, "--kinds", "stuck_open,leak", "-o", str(result), "--report", str(page)]) == 0
    text = capsys.readouterr().out
    assert "valveA.stuck_open" in text
    assert "slideA moves by" in text
    assert "stop a step sequence" in text
    words = [row["word"] for row in tomllib.loads(result.read_text())["faults"] if row["valve"] == "valveA"]
    assert words == ["stuck_open", "leak"]
    assert "<html" in page.read_text()


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (["audit", "safety", MACHINE], "The event has no input"),
        (["audit", "safety", MACHINE, "--event", "supply.presure=0 bar g"], "Did you mean supply.pressure"),
        (["audit", "safety", MACHINE, "--event", "supply.pressure"], "--event"),
        ([*AUDIT, "--at", "9 s"], "--at = 9 s is not within the run, which ends at 3.2 s, so the event never happens"),
        (["audit", "safety", MACHINE, "--event", "supply.pressure=8 bar g", "--at", "1 s"], "changes nothing"),
        ([*AUDIT, "--threshold", "5 mm"], "--threshold = "),
        ([*AUDIT, "--duration", "0 s"], "--duration = 0 s"),
        ([*AUDIT, "--samples", "-1"], "--samples = -1"),
        ([*AUDIT, "--kinds", "stuk"], "--kinds = 'stuk' is not a valid fault. Did you mean stuck"),
        (["audit", "safety", MACHINE, "--event", "threshold=1"], "error: threshold is not"),
        ([*AUDIT, "--samples", "5"], "has no table ensemble"),
        (["audit", "safety", MACHINE, "--event", "supply.pressure"], 'Write, for example, --event supply.pressure="0'),
        ([*AUDIT, "--event", "supply.pressure=0"], "--event supply.pressure is specified twice"),
        ([*AUDIT, "--at", "step"], "Did you mean steps"),
        (["faults", MACHINE, "--at", "4 s"], "--at = 4 s is not within the run"),
        (["faults", MACHINE, "--kinds", ""], "--kinds contains no fault"),
        (["faults", MACHINE, "--duration", "2"], "duration"),
    ],
)
def test_invalid_arguments(arguments, text, capsys):
    assert run(arguments) == 2
    assert text in capsys.readouterr().err
