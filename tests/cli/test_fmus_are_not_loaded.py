"""Commands, the editor and its tasks never load the library of an FMU without permission, and name the reason."""

from __future__ import annotations

import io
import json
import os

import pytest

from c_compiler import compile_c
from poppet import load
from poppet.cli import main
from poppet.core.errors import InputError, SimulationError
from poppet.cosim.description import present_platform
from poppet.edit.build import build_payload
from poppet.edit.session import Session
from poppet.edit.tasks import process
from poppet.edit.tasks.kinds import TASKS
from small_fmus import DESCRIPTION, write_fmu

TRAP = """
#include <stdio.h>
__attribute__((constructor)) static void loaded(void) {{
    FILE *mark = fopen("{mark}", "w");
    if (mark) fclose(mark);
}}
"""
CIRCUIT = """\
title = "Tank beside an FMU"

[parts.supply]
kind = "reservoir"
pressure = "7 bar"

[parts.valve]
kind = "directional_valve"
supply = "supply"
outlet = "tank"
exhaust = "ambient"
sonic_conductance = "1e-8 m^3/(s Pa)"
critical_ratio = 0.3

[parts.tank]
kind = "chamber"
volume = "1 l"

[parts.regulator]
kind = "pid"
gain = "2 1/bar"
setpoint = "3 bar g"
sample_time = "5 ms"

[parts.meter]
kind = "fmu"
path = "trap.fmu"
units = { u = "Pa" }

[connections]
"meter.u" = "tank.pressure"
"regulator.measurement" = "tank.pressure"
"valve.command" = "regulator.fill_command"

[ensemble]
runs = 3
[ensemble.parameters]
"tank.volume" = { distribution = "uniform", relative_range = 0.1 }
[ensemble.metrics]
end = { of = "tank.pressure", metric = "final", unit = "bar" }
[requirements]
enough = "end > 2 bar"

[run]
duration = "1 s"
"""


@pytest.fixture
def mark(tmp_path, monkeypatch):
    """File that exists after the library of the FMU has been loaded."""
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "loaded"
    build = tmp_path / "build"
    build.mkdir()
    library = compile_c({"trap.c": TRAP.format(mark=path.as_posix())}, build, "-std=gnu99", "-shared", "-fPIC")
    text = DESCRIPTION.format(variable="true", interpolates="true", rolls="true")
    write_fmu(tmp_path / "trap.fmu", text, {f"binaries/{present_platform(2)}/integrator.so": library.read_bytes()})
    (tmp_path / "plant.toml").write_text(CIRCUIT, encoding="utf-8")
    return path


def test_a_permitted_run_loads_the_library(mark):
    """The trap works: without the functions of FMI, loading fails after the constructor."""
    pytest.importorskip("fmpy", reason="running an FMU needs FMPy")
    with pytest.raises(SimulationError) as error:
        load("plant.toml").simulate(allow_native=True)
    assert error.value.note.code == "fmu.not_loaded"
    assert mark.exists()


COMMANDS = {
    "check": "",
    "show": "",
    "draw -o x.svg": "",
    "simulate": "fmu.native",
    "serve --duration 1": "fmu.native",
    "linearise": "fmu.unavailable",
    "live -o x.html": "fmu.unavailable",
    "export c -o folder": "fmu.unavailable",
    "export fmu -o x.fmu": "fmu.unavailable",
    "export ssp -o x.ssp": "fmu.unavailable",
    "export check": "fmu.unavailable",
    # A controller does not need the equations of the plant.
    "export fmu --part regulator --platform linux64 -o x.fmu": "",
    "export st --part regulator -o x.st": "",
    "ensemble": "fmu.unavailable",
    "size --free tank.volume": "fmu.unavailable",
    "control compare": "fmu.unavailable",
    "audit energy": "fmu.unavailable",
    "audit safety --event supply.pressure=1e5": "fmu.unavailable",
    "faults": "fmu.unavailable",
}
GROUPS = ("export", "audit", "control")


def test_commands(mark, capsys):
    for command, code in COMMANDS.items():
        words = command.split()
        n = 2 if words[0] in GROUPS else 1
        status = main.run([*words[:n], "plant.toml", *words[n:]])
        error = capsys.readouterr().err
        assert status == (2 if code else 0), (command, error)
        if code:
            assert code in error, command
            assert "parts.meter" in error, command
    assert not mark.exists()


def test_the_editor(mark, tmp_path):
    session = Session(tmp_path / "plant.toml")
    state = session.state()
    assert state["errors"] == []
    with pytest.raises(InputError) as error:
        build_payload(session.circuit())
    assert (error.value.code, error.value.address) == ("fmu.unavailable", "parts.meter")
    options = {
        "size": {"address": "tank.volume", "low": "1 l", "high": "2 l"},
        "safety": {"event": {"supply.pressure": 1e5}},
        "export": {"target": "fmu"},
    }
    folders = {name: str(tmp_path / name) for name in ("output", "uploads")}
    for folder in folders.values():
        os.mkdir(folder)
    order = {"text": CIRCUIT, "name": "plant", "folder": str(tmp_path), **folders}
    # The other tasks read a recording first.
    for task in TASKS.keys() - {"columns", "identify", "interpret", "tank"}:
        stream = io.StringIO()
        process.run_task({"task": task, "options": options.get(task, {}), **order}, stream)
        last = json.loads(stream.getvalue().splitlines()[-1])
        assert [row["address"] for row in last["errors"]] == ["parts.meter"], (task, last)
        assert last["errors"][0]["code"] == "fmu.unavailable", task
    assert not mark.exists()
