"""From an empty page to a running cylinder drive, by mouse and by keyboard alone."""

from __future__ import annotations

import tomllib

import numpy as np
import pytest

from editor_page import Editor, wait_for_text
from editor_user import KeyboardUser, MouseUser, draw_cylinder_drive
from poppet import load

EXPECTED = """
[parts.reservoir]
kind = "reservoir"
pressure = "6 bar g"

[parts.spool_valve]
kind = "spool_valve"
function = "5/2 monostable"
sonic_conductance = "2 dm^3/(s bar)"
critical_ratio = 0.3
supply = "reservoir"
a = "chamber"
b = "chamber_2"

[parts.flow_control_valve]
kind = "flow_control_valve"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
throttle_conductance = "0.2 dm^3/(s bar)"
from = "chamber"
to = "cylinder.cap"

[parts.flow_control_valve_2]
kind = "flow_control_valve"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
throttle_conductance = "0.2 dm^3/(s bar)"
from = "chamber_2"
to = "cylinder.rod"

[parts.cylinder]
kind = "cylinder"
bore = "32 mm"
rod_diameter = "12 mm"
stroke_length = "100 mm"
cap.dead_volume = "5 cm^3"
rod.dead_volume = "5 cm^3"
body = "mass"

[parts.mass]
kind = "mass"
mass = "6 kg"

[parts.chamber]
kind = "chamber"
volume = "20 cm^3"

[parts.chamber_2]
kind = "chamber"
volume = "20 cm^3"
"""
"""Circuit without the sources of the starting values, the run options and the positions."""
LIMIT = 180.0


def without_sources(value):
    """Return the values of tables with the source "assumed"."""
    if not isinstance(value, dict):
        return value
    if value.get("source") == "assumed":
        return value["value"]
    return {name: without_sources(inner) for name, inner in value.items()}


@pytest.mark.parametrize("kind_of_user", [MouseUser, KeyboardUser], ids=["mouse", "keyboard"])
def test_a_cylinder_drive_is_drawn_and_runs(start_editor, kind_of_user):
    editor: Editor = start_editor(name="drive.toml")
    editor.page.evaluate("() => { window.isTheSamePage = true; }")
    user = kind_of_user(editor)
    draw_cylinder_drive(user)
    file = editor.folder / "drive.toml"
    wait_for_text(file, editor.text())
    assert editor.page.evaluate("() => window.isTheSamePage")
    assert user.seconds < LIMIT
    saved = tomllib.loads(file.read_text())
    assert without_sources(saved["parts"]) == tomllib.loads(EXPECTED)["parts"]
    assert {*saved["drawing"]} >= {*saved["parts"]}
    assert saved["signals"] == {"spool_valve.command": {"kind": "steps", "times": ["0 s", "0.5 s"], "values": [0, 1]}}
    assert {*saved} == {"parts", "signals", "run", "drawing"}
    run, expected = editor.recording(), load(file).simulate()
    assert np.array_equal(run["time"], expected.time)
    stroke = np.asarray(run["mass.position"])
    assert stroke[-1] - stroke[0] == pytest.approx(0.1, rel=0.01)  # the stroke of the starting cylinder
    assert np.allclose(stroke, expected["mass.position"], rtol=1e-6, atol=1e-9)
    assert editor.page.locator("#curves canvas").count() >= 1
