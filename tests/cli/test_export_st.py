"""Tests of `poppet export st`: output file, terminal, invalid input."""

from __future__ import annotations

from pathlib import Path

from poppet.cli.main import _dispatch, run
from refusals import refused
from structured_text import FunctionBlock

EXAMPLES = Path(__file__).parents[2] / "examples"
CONTROL, JOINT = (str(EXAMPLES / f"{name}.toml") for name in ("pressure_control", "muscle_joint"))


def test_a_block_is_written_or_printed(tmp_path, capsys):
    file = tmp_path / "controller.st"
    assert run(["export", "st", CONTROL, "--part", "controller", "--set", "regulator.gain=5e-5", "-o", str(file)]) == 0
    capsys.readouterr()
    text = file.read_text(encoding="ascii")
    assert FunctionBlock(text).values["gain"] == 5e-5
    assert run(["export", "st", CONTROL, "--part", "regulator", "--set", "regulator.gain=5e-5"]) == 0
    assert capsys.readouterr().out == text
    assert run(["export", "st", JOINT, "--part", "position,inverse,valve", "--quiet", "-o", str(file)]) == 0
    assert capsys.readouterr().out == ""
    assert "valve_setpoint" not in FunctionBlock(file.read_text(encoding="ascii")).names("VAR_INPUT")


def test_errors_prevent_the_output_file(tmp_path, capsys):
    file = tmp_path / "controller.st"
    for parts, code in (
        ("tank", "deploy.controller.other"),
        ("", "deploy.no_part_named"),
        ("regulater", "names.unknown"),
    ):
        with refused(code):
            _execute(["--part", parts] if parts else [], file)
    assert run(["export", "st", JOINT, "--part", "controller", "-o", str(file)]) == 2
    assert "position" in capsys.readouterr().err
    assert not file.exists()


def _execute(options, file):
    _dispatch(["export", "st", CONTROL, *options, "-o", str(file)])


def test_a_circuit_without_a_controller_is_refused(tmp_path):
    assert run(["new", "valve-fill", "-o", str(tmp_path / "fill.toml")]) == 0
    with refused("deploy.controller.none"):
        _dispatch(["export", "st", str(tmp_path / "fill.toml")])
