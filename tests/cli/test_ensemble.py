"""Tests of `poppet ensemble`: dataset, errors with their lines, interruption."""

from __future__ import annotations

from pathlib import Path

import pytest

from circuits_of_ensembles import LARGE, TABLES, TANK


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "tank.toml"
    path.write_text(TANK + TABLES, encoding="utf-8")
    return path


def test_a_file_becomes_a_dataset(poppet, file, tmp_path):
    file.write_text(TANK + LARGE, encoding="utf-8")
    answer = poppet("ensemble", "tank.toml")
    assert answer.code == 0
    lines = answer.out.splitlines()
    assert lines[0] == "A tank runs empty"
    assert [line.split()[0] for line in lines if line.startswith(("fast", "low", "all", "end", "empty", "air"))] == [
        "fast", "low", "all", "end", "empty", "air",
    ]  # fmt: skip
    assert len([*(tmp_path / "tank.ensemble" / "runs").iterdir()]) == 5
    second = poppet("ensemble", "tank.toml")
    assert (second.code, second.out) == (0, answer.out)
    assert poppet("ensemble", "tank.toml", "--quiet").out == ""


def test_another_dataset_is_refused(poppet, file):
    assert poppet("ensemble", "tank.toml", "--runs", "10").code == 0
    answer = poppet("ensemble", "tank.toml", "--runs", "11")
    assert (answer.code, answer.codes) == (2, ["ensemble.other_dataset"])
    assert poppet("ensemble", "tank.toml", "--runs", "11", "-o", "other").code == 0


def test_errors_have_line_numbers(poppet, file):
    changes = {
        "runs = 300": "runs = 0",
        '"tank.volume"': '"tank.volum"',
        'metric = "final"': 'metric = "finale"',
        'value = "0.5 bar g"': 'value = "0.5 kg"',
        "empty < 0.5 s": "empti < 0.5 s",
    }
    text = TANK + TABLES
    for old, new in changes.items():
        text = text.replace(old, new)
    file.write_text(text, encoding="utf-8")
    answer = poppet("ensemble", "tank.toml")
    assert answer.code == 2
    lines = [1 + text.splitlines().index(next(line for line in text.splitlines() if new in line)) for new in (
        changes.values())]  # fmt: skip
    assert [error.line for error in answer.errors] == lines
    assert [error.nearest for error in answer.errors] == ["", "tank.volume", "final", "", "empty"]
    checked = poppet("check", "tank.toml")
    assert (checked.code, [error.line for error in checked.errors]) == (2, lines)
    # Other commands leave these tables aside.
    assert poppet("simulate", "tank.toml").code == 0


def test_invalid_values_are_reported_before_the_first_run(poppet, file, tmp_path):
    file.write_text((TANK + TABLES).replace("relative_sigma = 0.02", "relative_sigma = 0.3"), encoding="utf-8")
    answer = poppet("ensemble", "tank.toml")
    assert (answer.code, answer.codes) == (2, ["ensemble.impossible"])
    assert "0.00043" in answer.err
    assert not (tmp_path / "tank.ensemble").exists()


def test_an_interruption_keeps_completed_runs(poppet, file, monkeypatch):
    from poppet.cli import progress

    def interrupt(self, done, total, kind):
        if done:
            raise KeyboardInterrupt

    monkeypatch.setattr(progress.EnsembleProgress, "__call__", interrupt)
    answer = poppet("ensemble", "tank.toml", "--workers", "1")
    assert (answer.code, answer.out) == (130, "")
    assert "300" in answer.err
    monkeypatch.undo()


def test_the_example_runs(poppet, monkeypatch):
    example = Path(__file__).parents[2] / "examples" / "ensemble.toml"
    answer = poppet("ensemble", str(example), "--runs", "64", "-o", "found")
    assert answer.code == 0
    assert "overshoot" in answer.out
