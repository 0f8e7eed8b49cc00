"""The page on imported models: its files and commands, from the export of an FMU to the table of the coupled run."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from c_compiler import COMPILER
from poppet.cli import main
from poppet.timeseries.recording import Recording
from small_fmus import write_integrator

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples" / "fmu_import"


@pytest.fixture
def near_side(tmp_path, monkeypatch):
    """The circuit of the page, beside the FMU that its command exports."""
    pytest.importorskip("fmpy", reason="running an FMU needs FMPy")
    if COMPILER is None:
        pytest.skip("an exported FMU needs a C compiler")
    monkeypatch.chdir(tmp_path)
    inputs = ["--input", "near.pressure", "--input", "near.temperature"]
    platform = ["--platform", "linux64"]
    assert main.run(["export", "fmu", str(EXAMPLES / "far_side.toml"), *inputs, *platform, "-o", "far_side.fmu"]) == 0
    page = (ROOT / "docs" / "fmu_import.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"^```text sketch\n(title = .*?)^```$", page, re.MULTILINE | re.DOTALL)
    (tmp_path / "near_side.toml").write_text(text, encoding="utf-8")
    return tmp_path / "near_side.toml"


def test_the_divided_circuit_is_the_undivided_one(near_side, capsys):
    assert main.run(["check", "near_side.toml"]) == 0
    assert "second: far_side.fmu, FMI 2.0, 2 inputs, 6 outputs" in capsys.readouterr().out
    assert main.run(["show", "near_side.toml"]) == 0
    assert "second.near_pressure" in capsys.readouterr().out
    assert main.run(["simulate", "near_side.toml", "--allow-native", "-o", "divided.csv", "--quiet"]) == 0
    assert main.run(["simulate", str(EXAMPLES / "whole.toml"), "-o", "whole.csv", "--quiet"]) == 0
    divided, whole = Recording.read("divided.csv"), Recording.read("whole.csv")
    for name, other in {"near.pressure": "near.pressure", "second.far_pressure": "far.pressure"}.items():
        assert np.abs(divided[name] / whole[other] - 1.0).max() < 5e-6, name
    assert np.abs(divided["far.pressure"] - divided["second.far_pressure"]).max() == 0.0


def test_fmi_3_without_interpolation(near_side):
    inputs = ["--input", "near.pressure", "--input", "near.temperature", "--fmi", "3", "--platform", "linux64"]
    assert main.run(["export", "fmu", str(EXAMPLES / "far_side.toml"), *inputs, "-o", "far_side.fmu"]) == 0
    assert main.run(["simulate", "near_side.toml", "--allow-native", "-o", "divided.csv", "--quiet"]) == 0
    assert main.run(["simulate", str(EXAMPLES / "whole.toml"), "-o", "whole.csv", "--quiet"]) == 0
    divided, whole = Recording.read("divided.csv"), Recording.read("whole.csv")
    assert np.abs(divided["near.pressure"] / whole["near.pressure"] - 1.0).max() < 2e-4


def test_a_crash_ends_the_command_and_keeps_the_table(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    write_integrator(tmp_path)
    text = '[parts.a]\nkind = "fmu"\npath = "integrator.fmu"\nstart = { fault = 1, u = 2.0 }\n'
    Path("a.toml").write_text(text + '[run]\nduration = "1 s"\noutput_step = "0.1 s"\n', encoding="utf-8")
    assert main.run(["simulate", "a.toml", "--allow-native", "-o", "a.csv"]) == 1
    output = capsys.readouterr()
    assert "SIGSEGV" in output.err
    table = Recording.read("a.csv")
    assert table.time.tolist() == pytest.approx([0.0, 0.1, 0.2, 0.3, 0.4])
    assert table["a.y"].tolist() == pytest.approx((2.0 * table.time).tolist())


def test_a_sampled_controller(near_side):
    """The controller of an example as an FMU, with commands that follow one sample after their measurements."""
    example = (ROOT / "examples" / "pressure_control.toml").read_text(encoding="utf-8")
    whole = example.replace('"6.5 s"', '"0.7 s"').replace('lag = "3 ms"', "lag = 0")
    Path("whole.toml").write_text(whole, encoding="utf-8")
    platform = ["--platform", "linux64"]
    assert main.run(["export", "fmu", "whole.toml", "--part", "regulator", *platform, "-o", "regulator.fmu"]) == 0
    start, end = whole.index("[parts.regulator]"), whole.index("[connections]")
    fmu = '[parts.r]\nkind = "fmu"\npath = "regulator.fmu"\nstep = "2 ms"\ncoupling = "sampled"\n\n'
    divided = (
        (whole[:start] + fmu + whole[end:])
        .replace("regulator.", "r.regulator_")
        .replace("r.regulator_fmu", "regulator.fmu")
    )
    # A jump between two sample instants: at an instant, the order would matter.
    for name, text in {"whole": whole, "divided": divided}.items():
        Path(f"{name}.toml").write_text(text.replace('"0.5 s"', '"0.501 s"'), encoding="utf-8")
        arguments = ["--allow-native"] if name == "divided" else []
        assert main.run(["simulate", f"{name}.toml", "-o", f"{name}.csv", "--quiet", *arguments]) == 0
    pressures = [Recording.read(f"{name}.csv")["tank.pressure"] for name in ("whole", "divided")]
    assert np.abs(pressures[1] / pressures[0] - 1.0).max() < 1e-6
