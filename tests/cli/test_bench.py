"""Tests of `poppet bench`: exit codes, results, reports, comparison."""

from __future__ import annotations

import importlib.util
import json
import re
import shutil
import tomllib
from pathlib import Path

import numpy as np
import pytest

from poppet.bench.iso10094.bench_result import DEFINITIONS, read_bench_result
from poppet.bench.iso10094.rig import Rig
from poppet.core.codes import Note
from poppet.core.errors import SimulationError

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples" / "bench"
QUICK = ("--volume", "1 l", "--tests", "leakage")
VALVE, RECORDINGS = "examples/bench/valve.toml", "examples/bench/recordings.toml"


@pytest.fixture
def bench(tmp_path):
    """The examples under the path they have in the repository."""
    folder = tmp_path / "examples" / "bench"
    shutil.copytree(EXAMPLES, folder, ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def test_recordings_equal_the_output_of_their_script(tmp_path):
    spec = importlib.util.spec_from_file_location("make_bench_data", EXAMPLES / "make_data.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.main(tmp_path)
    names = sorted(path.name for path in EXAMPLES.glob("*.csv"))
    assert sorted(path.name for path in tmp_path.glob("*.csv")) == names
    for name in names:
        generated, stored = (np.loadtxt(folder / name, delimiter=",", skiprows=1) for folder in (tmp_path, EXAMPLES))
        np.testing.assert_allclose(generated, stored, atol=2e-3)


def test_figures_of_the_example_recordings(poppet, bench, tmp_path):
    """make_data.py knows the truth: play 0.8, dead zone 2, T = 50 ms behind 10 ms, droop 6 % FS at 10 g/s."""
    code, out, _ = poppet("bench", "iso10094", "--recording", RECORDINGS, "-o", "r.toml")
    assert code == 0
    figures = tomllib.loads((tmp_path / "r.toml").read_text())["figures"]
    truth = {"hysteresis": 0.8436, "zero_suppression": 2.4, "rise_time_up": 0.10986, "response_time_down": 0.12513}
    truth |= {"flow_droop": 3.0, "bandwidth_gain": 3.253}
    assert {name: figures[name]["value"] for name in truth} == pytest.approx(truth, rel=0.01)
    assert figures["hysteresis"]["unit"] == "% FS"
    assert figures["hysteresis"]["definition"] == DEFINITIONS["hysteresis"].full
    assert "hysteresis" in out
    assert "flow: relief_rise is not determined" in out


def test_a_json_result_equals_the_toml_result(poppet, bench, tmp_path):
    for name in ("r.toml", "r.json"):
        assert poppet("bench", "iso10094", "--recording", RECORDINGS, "-o", name, "--quiet") == (0, "", "")
    toml, js = tomllib.loads((tmp_path / "r.toml").read_text()), json.loads((tmp_path / "r.json").read_text())
    assert toml == js
    assert read_bench_result(tmp_path / "r.json").figures == read_bench_result(tmp_path / "r.toml").figures


def test_a_valve_with_a_setpoint_in_volts(poppet, bench, tmp_path):
    options = ("--set", "valve.setpoint_type=0-10 V", "-o", "r.toml", "--quiet")
    assert poppet("bench", "iso10094", VALVE, *QUICK, *options) == (0, "", "")
    conditions = tomllib.loads((tmp_path / "r.toml").read_text())["conditions"]
    assert (conditions["setpoint_unit"], conditions["setpoint_range"]) == ("V", [0.0, 10.0])
    assert conditions["full_scale"] == [1e5, 7e5]


def test_options_reach_the_bench(poppet, bench, tmp_path):
    options = (
        "--full-scale",
        "1 bar g, 4 bar g",
        "--supply",
        "9 bar",
        "--volume",
        "0.5 l",
        "--frequencies",
        "0.5 Hz, 1 Hz",
    )
    code, _, _ = poppet("bench", "iso10094", VALVE, "--tests", "frequency", *options, "-o", "r.toml")
    assert code == 0
    result = tomllib.loads((tmp_path / "r.toml").read_text())
    assert result["conditions"]["full_scale"] == pytest.approx([2e5, 5e5])
    assert (result["conditions"]["supply_pressure"], result["conditions"]["volumes"]) == (9e5, [0.0005])
    assert [row["frequency"] for row in result["frequencies"]] == pytest.approx([0.5, 1.0])


def test_comparison_with_a_circuit_and_with_a_result(poppet, bench, tmp_path):
    other = bench / "fast.toml"
    other.write_text((bench / "valve.toml").read_text().replace("universal", "fast"))
    code, out, _ = poppet("bench", "iso10094", VALVE, *QUICK, "--compare", str(other), "-o", "r.toml")
    assert code == 0
    assert "Regulator, prese" in out.splitlines()[1]
    row = tomllib.loads((tmp_path / "r.toml").read_text())["comparison"]["figures"]["leakage"]
    assert {"value", "other"} <= set(row)
    # A result is shown again, and stands beside recordings as well.
    assert poppet("bench", "iso10094", "r.toml", "--compare", "r.toml").code == 0
    assert poppet("bench", "iso10094", "--recording", RECORDINGS, "--compare", "r.toml").code == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("iso10094",), "Specify a circuit file, or --recording MAP.toml."),
        (("iso10094", VALVE, "--recording", RECORDINGS), "A circuit file and --recording are specified together"),
        (
            ("iso10094", VALVE, "--valve", "valv"),
            "valv is not the name of a pressure valve of this circuit. Did you mean valve?",
        ),
        (
            ("iso10094", VALVE, "--valve", "volume"),
            "volume is not the name of a pressure valve of this circuit. Use one of: valve.",
        ),
        (("iso10094", VALVE, "--tests", "stepp"), "tests = 'stepp' is not a valid test. Did you mean step"),
        (("iso10094", VALVE, "--tests", ""), "The list of tests is empty"),
        (("iso10094", VALVE, "--full-scale", "0 bar g"), "is not a valid range:"),
        (("iso10094", VALVE, "--full-scale", "a, b, c"), "must be one pressure, or a list"),
        (("iso10094", VALVE, "--volume", "0 l"), "the volume must be greater than 0 m^3."),
        (("iso10094", VALVE, "--volume", "1 kg"), "--volume"),
        (("iso10094", VALVE, "--rated-flow", "0 g/s"), "must be greater than 0 kg/s."),
        (("iso10094", VALVE, "--set", "valve.prset=fast"), "valve.prset"),
        (("iso10094", VALVE, "-o", "r.csv"), "is not a supported format"),
        (("iso10094", VALVE, "--report", "missing/r.html"), "does not exist"),
        (("iso10094", "nothing.toml"), "does not exist."),
        (("iso10094", "--recording", RECORDINGS, "--volume", "1 l"), "--volume has no effect with --recording"),
        (("iso10094", "--recording", VALVE), "is not a valid field of a file of recordings."),
        (("iso6953", VALVE), "iso6953"),
        (("iso10094", VALVE, "--compare", "examples/bench/sweep.csv"), "is not valid TOML"),
    ],
)
def test_invalid_input_gives_exit_code_2(poppet, bench, arguments, message):
    code, out, err = poppet("bench", *arguments)
    assert (code, out) == (2, "")
    assert message in err
    assert "Traceback" not in err


def test_errors_of_a_recordings_file_have_line_numbers(poppet, bench):
    path = bench / "recordings.toml"
    text = (
        path.read_text().replace('test = "step"', 'test = "steps"').replace('"outlet.mass_flow_rate"', '"outlet.flow"')
    )
    path.write_text(text)
    code, _, err = poppet("bench", "iso10094", "--recording", RECORDINGS)
    assert code == 2
    assert "recordings.steps.test = 'steps' is not a valid test. Did you mean step?" in err
    assert "recordings.draw.outlet.flow is not the name of a channel of the bench." in err
    assert re.search(r"recordings\.toml:\d+", err)


ENDING = ("--volume", "1 l", "--tests", "leakage,frequency", "--frequencies", "5 Hz", "-o", "r.toml")


@pytest.fixture
def ends(monkeypatch):
    """Lets a test of the bench end with an error."""

    def patch(kind: str, error: BaseException) -> None:
        respond = Rig.respond

        def failing(self, trial):
            if trial.kind == kind:
                raise error
            return respond(self, trial)

        monkeypatch.setattr(Rig, "respond", failing)

    return patch


def test_a_failed_test_does_not_affect_the_others(poppet, bench, tmp_path, ends):
    ends("leakage", SimulationError("The run ended at t = 1 s: it diverged."))
    code, out, err = poppet("bench", "iso10094", VALVE, *ENDING)
    assert (code, err) == (1, "")
    result = read_bench_result(tmp_path / "r.toml")
    assert result.outcome == "failed"
    assert [row["frequency"] for row in result.rows["frequency"]] == pytest.approx([5.0])
    assert "leakage" not in result.figures
    assert result.notes["leakage"][-1] == Note("bench.absent.not_run", "leakage")
    assert "leakage: This test of the bench could not be run: The run ended at t = 1 s: it diverged." in out


def test_an_interrupt_keeps_completed_tests(poppet, bench, tmp_path, ends):
    ends("frequency", KeyboardInterrupt())
    code, _, _ = poppet("bench", "iso10094", VALVE, *ENDING)
    assert code == 130
    result = read_bench_result(tmp_path / "r.toml")
    assert (result.outcome, list(result.figures)) == ("interrupted", ["leakage"])
