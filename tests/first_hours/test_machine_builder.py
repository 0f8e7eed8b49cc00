"""The machine builder: stroke times, air per cycle and the smallest valve, against a model in SciPy."""

from __future__ import annotations

import re
import tomllib

import pytest

from pneumatic_drive import CAP_AREA, DEAD, HALF_TUBE, ROD_AREA, STROKE, Valve, simulate

TOLERANCE = 0.01
"""Relative difference of stroke times and air to the independent model, whose tubes have no cells."""
FILE = "drive-sizing.toml"


@pytest.fixture(scope="module")
def folder(installed, tmp_path_factory):
    """Folder with the template, which the list of templates names."""
    folder = tmp_path_factory.mktemp("builder")
    assert re.search(r"^drive-sizing ", installed.run("poppet", "new", folder=folder).stdout, re.MULTILINE)
    for command in (("new", "drive-sizing"), ("check", FILE)):
        result = installed.run("poppet", *command, folder=folder)
        assert (result.returncode, result.stderr) == (0, "")
    return folder


def metrics(folder) -> dict[str, float]:
    """Return the metrics of the selected component in a result file."""
    result = tomllib.loads((folder / "valve.toml").read_text(encoding="utf-8"))
    (trial,) = [trial for trial in result["trials"] if trial["component"] == result["component"]]
    return {"component": result["component"], **trial["metrics"]}


def test_strokes_and_air_are_those_of_an_independent_model(installed, folder):
    result = installed.run("poppet", "simulate", FILE, "-o", "run.csv", folder=folder)
    assert result.returncode == 0
    assert result.stderr.count("\n") == 1  # the note on the end stops
    strokes = re.findall(r"^slide +\S+ +-?[\d.]+ mm .* ([\d.]+)  valve\.command at", result.stdout, re.MULTILINE)
    air = re.search(r"^air used +([\d.]+)  l ANR", result.stdout, re.MULTILINE)
    wanted = simulate(Valve(2e-8, 0.3, 2e-8, 0.3))
    assert [float(time) for time in strokes] == pytest.approx([wanted.extend, wanted.retract], rel=TOLERANCE)
    assert air is not None
    assert float(air[1]) == pytest.approx(wanted.air, rel=TOLERANCE)
    # By hand: both chambers and tubes are filled from 1 to 7 bar once; cold air takes up to 10 % more.
    volumes = (CAP_AREA + ROD_AREA) * STROKE + 2.0 * DEAD + 4.0 * HALF_TUBE
    assert 1.0 < float(air[1]) / (6.0 * 1e3 * volumes) < 1.1


def test_size_answers_in_the_unit_of_the_file(installed, folder):
    session = installed.on_terminal("poppet", "size", FILE, "--free", "valve.sonic_conductance", folder=folder)
    assert session.code == 0, session.text
    answer = re.search(r"Smallest valve\.sonic_conductance: ([\d.]+) dm³/\(s bar\), limited by extend", session.text)
    assert answer is not None, session.text
    conductance = float(answer[1]) * 1e-8
    assert simulate(Valve(conductance, 0.3, conductance, 0.3)).extend == pytest.approx(0.5, rel=TOLERANCE)


def test_smallest_valve_of_the_catalogue(installed, folder):
    """The valve meets the requirement in the independent model with the printed values; the smaller one fails."""
    command = ("poppet", "size", FILE, "--catalogue", "valve", "-o", "valve.toml", "--report", "valves.html")
    result = installed.run(*command, folder=folder)
    assert result.returncode == 0
    found = metrics(folder)
    assert found["component"] == "CKD M3GA2R/M4GA2R/M3GD2R/M4GD2R"
    printed = installed.run("poppet", "library", "CKD M4GA2R", folder=folder).stdout
    for value in ("2.3 dm^3/(s bar)", "0.36", "2.9 dm^3/(s bar)", "0.24"):
        assert value in printed
    wanted = simulate(Valve(2.3e-8, 0.36, 2.9e-8, 0.24))
    for name in ("extend", "retract", "air"):
        assert found[name] == pytest.approx(getattr(wanted, name), rel=TOLERANCE)
    assert max(wanted.extend, wanted.retract) < 0.5
    assert "Next smaller: SMC SY3500 ?, C = 1.4 dm³/(s bar), fails." in result.stdout
    assert simulate(Valve(1.4e-8, 0.3, 1.4e-8, 0.3)).extend > 0.5
    # The selected valve in the file gives the strokes of the search.
    text = (folder / FILE).read_text(encoding="utf-8")
    text = re.sub(r"sonic_conductance = .*\ncritical_ratio = .*", 'model = "CKD M4GA2R"', text)
    (folder / "drive.toml").write_text(text, encoding="utf-8")
    run = installed.run("poppet", "simulate", "drive.toml", "-o", "run.csv", folder=folder)
    assert run.returncode == 0
    times = re.findall(r" ([\d.]+)  valve\.command at", run.stdout)
    assert [float(time) for time in times] == pytest.approx([found["extend"], found["retract"]], rel=0.01)
