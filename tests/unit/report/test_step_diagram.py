"""Displacement-step diagrams: steps and displacements of a recording, the figure, and rejected input."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import poppet
from poppet.core.errors import InputError
from poppet.report.step_diagram import MOST_COLUMNS, draw_step_diagram, step_run
from poppet.timeseries.recording import Recording

TWO_TANKS = Path(__file__).parents[3] / "examples" / "two_tanks.toml"
DRIVE = """
[parts.valve{name}]
kind = "spool_valve"
supply = "supply"
a = "cylinder{name}.cap"
b = "cylinder{name}.rod"
sonic_conductance = 1e-8
critical_ratio = 0.3
[parts.cylinder{name}]
kind = "cylinder"
bore = "25 mm"
stroke_length = "{stroke} mm"
body = "slide{name}"
cap = {{dead_volume = "5 cm^3"}}
rod = {{dead_volume = "5 cm^3"}}
[parts.slide{name}]
kind = "mass"
mass = "2 kg"
"""
PLC = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.plc]
kind = "sequence"
outputs = ["a", "b"]
start = "A+"
steps."A+" = { set = {a = 1, b = -1}, next = { "B+" = "slideA.position > 98 mm" } }
steps."B+" = { set = {a = 1, b = 1}, next = { "B-" = "slideB.position > 48 mm" } }
steps."B-" = { set = {a = 1, b = -1}, next = { "A-" = "slideB.position < 2 mm" } }
steps."A-" = { set = {a = -1, b = -1}, next = { "A+" = "slideA.position < 2 mm" } }
[connections]
"valveA.command" = "plc.a"
"valveB.command" = "plc.b"
"""
TEXT = PLC + DRIVE.format(name="A", stroke=100) + DRIVE.format(name="B", stroke=50)
SERIES = ("plc.step", "plc.a", "plc.b", "cylinderA.piston_position", "cylinderB.piston_position")
# Number of the step, outputs, and both positions [m] at its start.
STARTS = ((1, 1, -1, 0.0, 0.0), (2, 1, 1, 0.1, 0.0), (3, 1, -1, 0.1, 0.05), (4, -1, -1, 0.1, 0.0))


@pytest.fixture(scope="module")
def circuit() -> poppet.Circuit:
    return poppet.loads(TEXT)


def recording(*starts: Any) -> Recording:
    """A recording with ten rows per step, in which positions change linearly."""
    rows = []
    for k, row in enumerate(starts):
        following = starts[min(k + 1, len(starts) - 1)]
        for fraction in np.arange(10) / 10:
            positions = [(1.0 - fraction) * a + fraction * b for a, b in zip(row[3:], following[3:], strict=True)]
            rows.append([*row[:3], *positions])
    values = np.array(rows).T
    return Recording(0.01 * np.arange(len(rows)), SERIES, ("1", "1", "1", "m", "m"), values)


def texts(figure: Any) -> list[str]:
    return [text.get_text() for axes in figure.axes for text in axes.texts] + [text.get_text() for text in figure.texts]


def test_steps_and_displacements_of_a_recording(circuit: poppet.Circuit) -> None:
    run = step_run(circuit, recording(*STARTS, *STARTS[:2]))
    assert run.names == ("A+", "B+", "B-", "A-")
    assert run.numbers == (1, 2, 3, 4, 1, 2)
    assert run.times == pytest.approx([0.0, 0.1, 0.2, 0.3, 0.4, 0.5])
    assert run.cycle() == (0, 4)
    assert list(run.displacements) == ["cylinderA", "cylinderB"]
    assert run.displacements["cylinderB"].max() == pytest.approx(1.0)
    assert list(run.outputs) == ["a", "b"]


def test_the_last_complete_cycle_or_all_steps(circuit: poppet.Circuit) -> None:
    assert step_run(circuit, recording(*STARTS, *STARTS, *STARTS[:1])).cycle() == (4, 8)
    assert step_run(circuit, recording(*STARTS[:3])).cycle() == (0, 3)


def test_the_diagram_connects_the_displacements_at_the_starts_of_the_steps(circuit: poppet.Circuit) -> None:
    figure = draw_step_diagram(circuit, recording(*STARTS, *STARTS[:1]))
    assert len(figure.axes) == 8
    line = max(figure.axes[1].lines, key=lambda line: len(line.get_xdata()) if line.get_linewidth() > 1.5 else 0)
    assert list(line.get_xdata()) == [1, 2, 3, 4, 5]
    assert list(line.get_ydata()) == pytest.approx([0.0, 0.0, 1.0, 0.0, 0.0])
    written = texts(figure)
    assert [name for name in ("A+", "B+", "B-", "A-", "cylinderA", "cylinderB", "a", "b") if name not in written] == []
    assert "Displacement-step diagram: last complete cycle" in written


def test_names_of_many_steps_are_upright_and_their_number_is_limited(circuit: poppet.Circuit) -> None:
    alternating = [STARTS[0], *[STARTS[1 + k % 2] for k in range(MOST_COLUMNS + 10)]]
    figure = draw_step_diagram(circuit, recording(*alternating))
    assert {text.get_rotation() for text in figure.axes[0].texts if text.get_text() == "B+"} == {90.0}
    assert figure.axes[0].get_xlim() == (1.0, MOST_COLUMNS + 1.0)
    assert f"Displacement-step diagram: all steps, first {MOST_COLUMNS} steps" in texts(figure)


def test_a_switch_leads_to_the_body_that_it_measures() -> None:
    text = TEXT.replace("slideB.position > 48 mm", "reed.state")
    text = text.replace("slideB.position < 2 mm", "elapsed > 1 s")
    text += '[parts.reed]\nkind = "switch"\nmeasurement = "slideB.position"\non_above = "48 mm"\noff_below = "47 mm"\n'
    assert list(step_run(poppet.loads(text), recording(*STARTS)).displacements) == ["cylinderA", "cylinderB"]


def test_a_body_without_cylinder_uses_its_stops_or_its_range(circuit: poppet.Circuit) -> None:
    text = TEXT
    text = text.replace("slideB.position > 48 mm", "table.position > 20 mm").replace(
        "slideB.position < 2 mm", "elapsed > 1 s"
    )
    text += '[parts.table]\nkind = "guide"\n[parts.flexor]\nkind = "muscle"\nbody = "table"\ndata = "dmsp_20_300"\n'
    text += '[parts.hole]\nkind = "orifice"\nfrom = "flexor"\nto = "ambient"\nsonic_conductance = 1e-9\n'
    result = recording(*STARTS)
    names, units = (*result.names, "table.position"), ("1", "1", "1", "m", "m", "m")
    moved = np.vstack([result.values, np.linspace(0.01, 0.03, result.time.size)])
    run = step_run(poppet.loads(text), Recording(result.time, names, units, moved))
    assert [run.displacements["table"][k] for k in (0, -1)] == pytest.approx([0.0, 1.0])


def test_a_gripper_uses_the_stroke_of_its_jaws() -> None:
    text = TEXT.replace("slideB.position > 48 mm", "gripper.jaws.position > 4 mm")
    text = text.replace("slideB.position < 2 mm", "elapsed > 1 s")
    text += '[parts.gripper]\nkind = "gripper"\nbore = "20 mm"\njaw_stroke = "5 mm"\njaws = {mass = "0.2 kg"}\n'
    text += 'cap = {dead_volume = "2 cm^3"}\nrod = {dead_volume = "2 cm^3"}\n'
    for side in ("cap", "rod"):
        text += f'[parts.{side}_hole]\nkind = "orifice"\nfrom = "gripper.{side}"\nto = "ambient"\n'
        text += "sonic_conductance = 1e-9\ncritical_ratio = 0.3\n"
    result = recording(*STARTS)
    moved = np.vstack([result.values, np.linspace(0.0, 0.004, result.time.size)])
    names, units = (*result.names, "gripper.jaws.position"), ("1", "1", "1", "m", "m", "m")
    run = step_run(poppet.loads(text), Recording(result.time, names, units, moved))
    assert list(run.displacements) == ["cylinderA", "gripper"]
    assert run.displacements["gripper"][-1] == pytest.approx(0.8)


def test_rejected_input(circuit: poppet.Circuit) -> None:
    with pytest.raises(InputError) as error:
        draw_step_diagram(poppet.load(TWO_TANKS), recording(*STARTS))
    assert error.value.code == "drawing.no_sequence"
    with pytest.raises(InputError) as error:
        draw_step_diagram(circuit, recording(*STARTS), sequence="plb")
    assert (error.value.code, error.value.address) == ("names.unknown", "plb")
    with pytest.raises(InputError) as error:
        draw_step_diagram(circuit, Recording(np.zeros(0), SERIES, ("1", "1", "1", "m", "m"), np.zeros((5, 0))))
    assert error.value.code == "drawing.no_samples"
