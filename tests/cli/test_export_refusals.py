"""Tests of circuits that export targets refuse before they write a file."""

from __future__ import annotations

import sys
import zipfile
from pathlib import Path

import pytest

from poppet import Chamber, Circuit, Orifice, load
from poppet.cli.main import _dispatch
from refusals import refused

EXAMPLES = Path(__file__).parents[2] / "examples"
CONTROL, JOINT, FILL = (
    str(EXAMPLES / f"{name}.toml") for name in ("pressure_control", "muscle_joint", "fill_staircase")
)
DELAYED = str(EXAMPLES / "datasheet_valve.toml")
FOLDER, FMU, ST, PAGE = ("-o", "out"), ("-o", "out.fmu", "--platform", "linux64"), ("-o", "out.st"), ("-o", "out.html")
WHOLE = {"c": FOLDER, "fmu": FMU, "live": PAGE}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Folder with circuits that cannot be exported; a refused export adds no file."""
    monkeypatch.chdir(tmp_path)
    text = Path(CONTROL).read_text(encoding="utf-8")
    signals = text.index("[signals.")
    run = text.index("[run]")
    course = '[signals."regulator.setpoint"]\n'
    file = 'kind = "file"\npath = "bench.csv"\ncolumn = "regulator.setpoint"\n'
    files = {
        "endless.toml": text[:run],
        "measured.toml": text[:signals] + course + file + text[run:],
        "quick.toml": f"{text[:signals]}{course}"
        'kind = "square"\nlow = "2 bar"\nhigh = "3 bar"\nfrequency = "20 kHz"\n' + text[run:],
        "bench.csv": "time [s],regulator.setpoint [Pa]\n0,2e5\n1,4e5\n",
    }
    for name, content in files.items():
        (tmp_path / name).write_text(content, encoding="utf-8")
    yield tmp_path
    assert {path.name for path in tmp_path.iterdir()} == files.keys()


def command(target, file, *more):
    _dispatch([*(["live"] if target == "live" else ["export", target]), file, *more])


@pytest.mark.parametrize("target", WHOLE)
def test_every_target_exports_whole_circuits(target, folder):
    with refused("fields.missing", "run.duration"):
        command(target, "endless.toml", *WHOLE[target])
    with refused("deploy.segments", "signals", most=100_000):
        command(target, "quick.toml", *WHOLE[target])
    with refused("names.unknown"):
        command(target, CONTROL, "--set", "tank.volum=1", *WHOLE[target])


@pytest.mark.parametrize(
    ("target", "file", "given", "code"),
    [
        ("st", "measured.toml", ("--part", "controller", *ST), "deploy.file_in_block"),
        ("st", CONTROL, ("--part", "tank", *ST), "deploy.controller.other"),
        ("st", CONTROL, ST, "deploy.no_part_named"),
        ("st", FILL, ("--part", "controller", *ST), "deploy.controller.none"),
        ("st", JOINT, ("--part", "inverse", *ST), "deploy.controller.unsampled"),
        ("c", CONTROL, ("--part", "tank", *FOLDER), "deploy.controller.other"),
        ("c", JOINT, ("--part", "inverse", *FOLDER), "deploy.controller.unsampled"),
        ("c", CONTROL, ("--substeps", "0", *FOLDER), "fields.out_of_range"),
        ("fmu", FILL, ("--input", "ambient.pressure", *FMU), "deploy.fmu.fixed_input"),
        ("fmu", FILL, ("--input", "tank.volum", *FMU), "names.unknown"),
        ("fmu", FILL, ("-o", "out.fmu", "--platform", "amiga"), "fields.not_an_option"),
        ("live", FILL, ("--parameter", "run.duration", *PAGE), "deploy.live.structure"),
        ("live", FILL, ("--number", "tank.volum", *PAGE), "names.unknown"),
        ("live", DELAYED, ("--parameter", "valve.normally", *PAGE), "deploy.live.structure"),
        ("live", DELAYED, ("--parameter", "valve.sonic_conductance", *PAGE), "deploy.live.derived"),
    ],
)
def test_invalid_options_of_a_target_are_refused(target, file, given, code, folder):
    with refused(code):
        command(target, file, *given)


def test_a_python_function_as_signal_is_refused():
    """A circuit contains data only, so an export target never gets a Python function."""
    parts = {
        "tank": Chamber(volume="1 l", initial_pressure="5 bar"),
        "vent": Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3),
    }
    with refused("wiring.no_signal", "signals.vent.opening"):
        Circuit(parts, {"vent.opening": lambda t: 0.5 + 0.5 * t})


def test_sampled_circuits_are_refused_by_continuous_tools():
    for tool in ("to_casadi", "to_control"):
        with refused("tools.sampled", "regulator.sample"):
            getattr(load(CONTROL), tool)()
        with refused("fields.not_an_option", "without", value="tank"):
            getattr(load(CONTROL), tool)(without="tank")
        with refused("tools.fixed", "ambient.pressure"):
            getattr(load(FILL), tool)(numbers=["ambient.pressure"])


def test_a_missing_extra_is_named(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "control", None)
    with refused("missing.package", package="control", extra="control"):
        load(FILL).to_control()
    monkeypatch.setattr("poppet.deploy.fmu.package.link_commands", lambda platform: [])
    monkeypatch.chdir(tmp_path)
    command("fmu", FILL, *FMU)
    with zipfile.ZipFile("out.fmu") as archive:
        names = archive.namelist()
    assert "sources/model.c" in names
    assert not any(name.startswith("binaries/") for name in names)


def test_an_invalid_fmu_is_refused(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with refused("files.unreadable", path="missing.fmu"):
        command("check", "missing.fmu")
    Path("text.fmu").write_text("no archive")
    for version in ("1.0", "x"):
        with zipfile.ZipFile(f"{version}.fmu", "w") as archive:
            archive.writestr("modelDescription.xml", f'<fmiModelDescription fmiVersion="{version}"/>')
    with zipfile.ZipFile("empty.fmu", "w") as archive:
        archive.writestr("modelDescription.xml", "<")
    for name, code in (("text", "no_archive"), ("1.0", "no_fmu"), ("x", "no_fmu"), ("empty", "no_fmu")):
        with refused(f"deploy.fmu.{code}", name=f"{name}.fmu"):
            command("check", f"{name}.fmu")
