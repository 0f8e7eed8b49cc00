"""Contract for automation, as a program outside uses it: palette, parts, ports, fields, keys, `window.poppet`."""

from __future__ import annotations

import math
import os
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import pytest

from editor_page import Editor, Server, overlaps, wait_for_text
from poppet.circuit.file import loads
from poppet.core.errors import InputErrors
from poppet.parts import KINDS

PLANT = """title = "A tank is filled"

[parts.supply]
kind = "reservoir"
pressure = "6 bar g"

[parts.hole]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "1 dm^3/(s bar)"   # of the data sheet
critical_ratio = 0.3

[parts.tank]
kind = "chamber"
volume = "1 l"

[run]
duration = "1 s"
output_step = "10 ms"
"""
TWO_STORES = PLANT.replace('from = "supply"\nto = "tank"\n', "")
COVERED = """attribute => [...document.querySelectorAll(`[${attribute}]`)].filter(element => {
  const box = element.getBoundingClientRect();
  const top = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
  return top === null || top.closest(`[${attribute}]`) !== element;
}).map(element => element.getAttribute(attribute))"""
BOXES = """() => [...document.querySelectorAll("[data-part]")].map(element => {
  const box = element.getBoundingClientRect();
  return [box.left, box.top, box.right, box.bottom];
})"""


def covered(editor: Editor, attribute: str) -> list[str]:
    """Return the elements with an attribute that a click on their centre does not reach."""
    return editor.page.evaluate(COVERED, attribute)


def boxes(editor: Editor) -> list[list[float]]:
    """Return left, top, right and bottom of all parts."""
    return editor.page.evaluate(BOXES)


def parts(editor: Editor) -> dict:
    """Tables of the parts in the text of the page."""
    return tomllib.loads(editor.text()).get("parts", {})


def problems(text: str) -> list[str]:
    """Addresses of the errors that `poppet check` reports."""
    with pytest.raises(InputErrors) as caught:
        loads(text)
    return [problem.address for problem in caught.value.problems]


# --- the server ---


def test_the_address_is_printed_at_once_and_sigterm_ends_the_server(tmp_path):
    folder = tmp_path / "work"
    folder.mkdir()
    server = Server(folder)  # reads one line from a pipe: it comes only if the server flushes it
    assert server.process.poll() is None
    assert server.address.startswith("http://127.0.0.1:")
    assert server.stop() == 0
    assert server.errors() == ""


def test_ctrl_c_ends_the_server(tmp_path):
    folder = tmp_path / "work"
    folder.mkdir()
    server = Server(folder)
    os.kill(server.process.pid, signal.SIGINT)
    assert server.process.wait(30) in (0, 130)
    assert "Traceback" not in server.errors()
    server.stop()


def test_neither_matplotlib_nor_pandas_is_needed(browser, tmp_path, monkeypatch):
    barred = tmp_path / "barred"
    barred.mkdir()
    for name in ("matplotlib", "pandas", "pyarrow", "xarray"):
        (barred / f"{name}.py").write_text(f"raise ImportError('{name} is barred')\n")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(barred), os.environ.get("PYTHONPATH", "")]))
    probe = subprocess.run([sys.executable, "-c", "import pandas"], capture_output=True, text=True, check=False)
    assert "is barred" in probe.stderr
    folder = tmp_path / "work"
    folder.mkdir()
    (folder / "plant.toml").write_text(PLANT)
    server = Server(folder, "plant.toml")
    context = browser.new_context(viewport={"width": 1280, "height": 900})
    try:
        editor = Editor(server, context.new_page()).open()
        assert editor.recording()["tank.pressure"][-1] > 5e5
        editor.add("orifice")
        editor.press("Control+z")
        editor.save()
        assert (editor.problems, server.errors()) == ([], "")
    finally:
        context.close()
        assert server.stop() == 0


# --- palette ---


def test_every_kind_has_one_visible_button(editor):
    buttons = editor.names("data-kind")
    assert sorted(buttons) == sorted(KINDS)
    for kind in buttons:
        button = editor.palette(kind)
        left, top, right, bottom = editor.box(button)
        assert min(left, top) >= 0, kind
        assert (right <= 1280, bottom <= 900) == (True, True), kind
        assert button.evaluate("e => e.tagName") == "BUTTON"
        assert button.evaluate("e => e.innerText || e.getAttribute('aria-label')")
    assert covered(editor, "data-kind") == []


def test_parts_are_named_after_their_kind(editor):
    for _ in range(3):
        editor.add("orifice")
    editor.add("chamber")
    assert list(parts(editor)) == ["orifice", "orifice_2", "orifice_3", "chamber"]
    assert editor.names() == ["orifice", "orifice_2", "orifice_3", "chamber"]
    assert {table["kind"] for table in parts(editor).values()} == {"orifice", "chamber"}


def test_thirty_new_parts_cover_nothing(editor):
    for _ in range(30):
        editor.add("orifice")
    names = editor.names()
    assert sorted(names) == sorted(["orifice", *(f"orifice_{k}" for k in range(2, 31))])
    assert overlaps(boxes(editor)) == []
    assert covered(editor, "data-part") == []


def test_one_part_of_each_kind_covers_nothing(editor):
    for kind in KINDS:
        editor.palette(kind).click()
    editor.wait()
    names = editor.names()
    assert sorted(names) == sorted(KINDS)
    assert overlaps(boxes(editor)) == []
    assert covered(editor, "data-part") == []
    ports = editor.names("data-port")
    assert len(set(ports)) == len(ports)
    assert covered(editor, "data-port") == []


def test_a_new_part_covers_none_of_an_open_file(start_editor):
    editor = start_editor(PLANT)
    for kind in ("chamber", "cylinder", "spool_valve", "orifice"):
        editor.add(kind)
    names = editor.names()
    assert sorted(names) == ["chamber", "cylinder", "hole", "orifice", "spool_valve", "supply", "tank"]
    assert overlaps(boxes(editor)) == []


# --- connections ---


@pytest.mark.parametrize("way", ["click", "drag"])
def test_a_port_is_connected_to_a_part(start_editor, way):
    editor = start_editor(TWO_STORES)
    if way == "click":
        editor.connect("hole.from", "supply")
        editor.connect("hole.to", "tank")
    else:
        editor.drag(editor.centre(editor.port("hole.from")), editor.centre(editor.part("supply")))
        editor.drag(editor.centre(editor.port("hole.to")), editor.centre(editor.part("tank")))
    hole = parts(editor)["hole"]
    assert (hole["from"], hole["to"]) == ("supply", "tank")
    assert editor.recording()["tank.pressure"][-1] > 5e5


@pytest.mark.parametrize("way", ["click", "drag"])
def test_a_port_is_connected_to_a_port(editor, way):
    for kind in ("orifice", "cylinder", "mass"):
        editor.add(kind)
    for start, end in (("orifice.to", "cylinder.cap"), ("cylinder.body", "mass")):
        if way == "click":
            editor.connect(start, end)
        else:
            target = editor.port(end) if "." in end else editor.part(end)
            editor.drag(editor.centre(editor.port(start)), editor.centre(target))
    assert parts(editor)["orifice"]["to"] == "cylinder.cap"
    assert parts(editor)["cylinder"]["body"] == "mass"


def test_two_ports_of_passages_are_joined_through_a_gas_node(editor):
    editor.add("orifice")
    editor.add("orifice")
    editor.connect("orifice.to", "orifice_2.from")
    tables = parts(editor)
    (node,) = {*tables} - {"orifice", "orifice_2"}
    assert tables["orifice"]["to"] == node == tables["orifice_2"]["from"]
    assert tables[node]["kind"] in ("chamber", "tube")
    assert overlaps(boxes(editor)) == []


def test_the_wire_is_the_same_from_either_end(editor):
    editor.add("orifice")
    editor.add("cylinder")
    editor.connect("cylinder.cap", "orifice.to")
    assert parts(editor)["orifice"]["to"] == "cylinder.cap"


# --- fields ---


def test_a_new_orifice_shows_its_fields(editor):
    editor.add("orifice")
    for name in ("sonic_conductance", "critical_ratio", "opening"):
        field = editor.field(f"orifice.{name}")
        assert field.count() == 1, name
        assert field.get_attribute("type") == "text"
    assert editor.field("orifice.sonic_conductance").is_visible()
    assert editor.field("orifice.critical_ratio").is_visible()


def test_enter_applies_a_value(start_editor):
    editor = start_editor(PLANT)
    before = editor.recording()["tank.pressure"]
    editor.select("hole")
    assert editor.field("hole.sonic_conductance").input_value() == "1 dm^3/(s bar)"
    editor.type("hole.sonic_conductance", "0.1 dm^3/(s bar)")
    editor.type("hole.critical_ratio", "0.4")
    expected = PLANT.replace("1 dm^3", "0.1 dm^3").replace("0.3", "0.4")
    assert tomllib.loads(editor.text()) == tomllib.loads(expected)
    assert "# of the data sheet" in editor.text()
    assert editor.recording()["tank.pressure"][-1] < before[-1]


def test_only_the_selected_part_has_fields(start_editor):
    editor = start_editor(PLANT)
    editor.select("hole")
    assert editor.field("tank.volume").count() == 0
    editor.select("tank")
    assert editor.field("tank.volume").input_value() == "1 l"
    assert editor.field("hole.critical_ratio").count() == 0


def test_an_invalid_value_is_shown_at_its_address_and_loses_nothing(start_editor):
    editor = start_editor(PLANT)
    run = editor.recording()
    editor.select("tank")
    editor.type("tank.volume", "1 m")
    assert editor.page.locator('[data-address="tank.volume"], [data-address="parts.tank.volume"]').count() >= 1
    assert editor.recording() == run
    editor.type("tank.volume", "2 l")
    assert editor.page.locator('[data-address="tank.volume"], [data-address="parts.tank.volume"]').count() == 0
    assert editor.recording()["tank.pressure"] != run["tank.pressure"]


def test_errors_have_the_addresses_of_the_command_line(editor):
    editor.add("orifice")
    expected = problems(editor.text())
    assert expected
    for address in expected:
        shown = editor.page.locator(f'[data-address="{address}"]')
        assert shown.count() >= 1, address
        assert any(shown.nth(k).is_visible() for k in range(shown.count())), address


# --- buttons and keys ---


def test_the_buttons_have_their_names(editor):
    for name in ("Save", "Undo", "Redo", "Delete", "Rotate"):
        button = editor.page.get_by_role("button", name=name)
        assert button.count() == 1, name
        assert button.is_visible(), name


def test_undo_and_redo_by_buttons_and_keys(start_editor):
    editor = start_editor(PLANT)
    run = editor.recording()
    editor.select("tank")
    editor.type("tank.volume", "2 l")
    changed, second = editor.text(), editor.recording()
    editor.button("Undo").click()
    editor.wait()
    assert (editor.text(), editor.recording()) == (PLANT, run)
    editor.button("Redo").click()
    editor.wait()
    assert (editor.text(), editor.recording()) == (changed, second)
    editor.press("Escape", "Control+z")
    assert editor.text() == PLANT
    editor.press("Control+y")
    assert editor.text() == changed


def test_delete_by_button_and_key(start_editor):
    editor = start_editor(PLANT)
    editor.select("hole")
    editor.button("Delete").click()
    editor.wait()
    assert list(parts(editor)) == ["supply", "tank"]
    editor.select("tank")
    editor.press("Delete")
    assert list(parts(editor)) == ["supply"]
    assert editor.names() == ["supply"]
    editor.press("Control+z", "Control+z")
    assert editor.text() == PLANT


def test_rotate_by_button_and_key(start_editor):
    editor = start_editor(PLANT)
    editor.select("hole")
    editor.button("Rotate").click()
    editor.wait()
    assert tomllib.loads(editor.text())["drawing"]["hole"]["rotation"] == 90
    editor.press("r")
    assert tomllib.loads(editor.text())["drawing"]["hole"]["rotation"] == 180
    assert covered(editor, "data-part") == []


@pytest.mark.parametrize("way", ["button", "key", "key in a field"])
def test_save(start_editor, way):
    editor = start_editor(PLANT)
    file = editor.folder / "plant.toml"
    editor.select("tank")
    editor.type("tank.volume", "2 l")
    assert file.read_text() == PLANT  # only Save writes
    if way == "button":
        editor.button("Save").click()
    else:
        editor.press(*(["Escape"] if way == "key" else []))
        if way == "key in a field":
            editor.field("tank.volume").focus()
        editor.press("Control+s")
    wait_for_text(file, editor.text())
    assert tomllib.loads(file.read_text())["parts"]["tank"]["volume"] == "2 l"


def test_save_in_a_field_applies_what_was_typed(start_editor):
    editor = start_editor(PLANT)
    editor.select("tank")
    editor.field("tank.volume").fill("3 l")
    editor.page.keyboard.press("Control+s")
    editor.wait()
    wait_for_text(editor.folder / "plant.toml", editor.text())
    assert parts(editor)["tank"]["volume"] == "3 l"


def test_keys_of_the_drawing_do_nothing_in_a_field(start_editor):
    editor = start_editor(PLANT)
    editor.select("tank")
    field = editor.field("tank.volume")
    field.fill("12 l")
    field.press("Home")
    editor.page.keyboard.press("Delete")
    editor.page.keyboard.press("r")
    assert field.input_value() == "r2 l"
    assert list(parts(editor)) == ["supply", "hole", "tank"]
    assert "drawing" not in tomllib.loads(editor.text())


def test_escape_leaves_a_field(start_editor):
    editor = start_editor(PLANT)
    editor.select("tank")
    editor.field("tank.volume").fill("77 l")
    editor.press("Escape")
    focused = editor.page.evaluate("() => document.activeElement.getAttribute('name')")
    assert focused != "tank.volume"
    assert editor.text() == PLANT


def test_escape_leaves_a_wire(start_editor):
    editor = start_editor(TWO_STORES)
    editor.page.mouse.click(*editor.centre(editor.port("hole.from")))
    editor.press("Escape")
    editor.select("supply")
    editor.wait()
    assert editor.text() == TWO_STORES


def test_escape_leaves_the_selection(start_editor):
    editor = start_editor(PLANT)
    editor.select("tank")
    assert editor.field("tank.volume").count() == 1
    editor.press("Escape")
    assert editor.field("tank.volume").count() == 0
    editor.press("Delete")
    assert editor.text() == PLANT


# --- window.poppet ---


def test_text_and_recording_of_an_open_file(start_editor):
    editor = start_editor(PLANT)
    assert editor.text() == PLANT
    run = editor.recording()
    expected = loads(PLANT).simulate()
    assert run["time"] == expected.time.tolist()
    assert all(len(values) == len(run["time"]) for values in run.values())
    assert all(math.isfinite(value) for values in run.values() for value in values)
    assert run["tank.pressure"] == pytest.approx(expected["tank.pressure"].tolist(), rel=1e-9)


@pytest.mark.parametrize(
    "edit",
    [
        "document.querySelector('[data-kind=\"chamber\"]').click()",
        "[...document.querySelectorAll('button')].find(b => /^Undo/.test(b.innerText || b.ariaLabel)).click()",
        "document.body.dispatchEvent(new KeyboardEvent('keydown', {key: 'z', ctrlKey: true, bubbles: true}))",
    ],
    ids=["palette", "undo", "key"],
)
def test_ready_is_replaced_before_the_edit_returns(start_editor, edit):
    editor = start_editor(PLANT)
    editor.add("orifice")
    text = editor.text()
    is_new = editor.page.evaluate(
        f"async () => {{ const old = window.poppet.ready; {edit}; const now = window.poppet.ready; await now;"
        "return [now !== old, window.poppet.text()]; }"
    )
    assert is_new[0]
    assert is_new[1] != text


def test_ready_is_replaced_by_enter_in_a_field(start_editor):
    editor = start_editor(PLANT)
    editor.select("tank")
    editor.field("tank.volume").fill("2 l")
    editor.page.evaluate("() => { window.old = window.poppet.ready; }")
    editor.page.keyboard.press("Enter")
    last = editor.page.evaluate(
        "async () => { const now = window.poppet.ready; await now;"
        "return [now !== window.old, window.poppet.recording()['tank.pressure'].at(-1)]; }"
    )
    assert last[0]
    expected = loads(PLANT.replace('"1 l"', '"2 l"')).simulate()
    assert last[1] == pytest.approx(expected["tank.pressure"][-1], rel=1e-9)


def test_ready_resolves_also_after_refusals(editor):
    editor.add("orifice")  # no circuit that can run
    editor.add("mass")
    editor.connect("orifice.to", "mass")  # impossible: a mass contains no gas
    editor.press("Escape")
    editor.select("orifice")
    editor.type("orifice.critical_ratio", "7")
    editor.type("orifice.critical_ratio", "nonsense")
    editor.press("Escape", "Control+y", "Control+y")
    assert editor.page.evaluate("() => window.poppet.ready.then(() => true)")


def test_a_burst_of_edits_ends_with_the_last_one(start_editor):
    editor = start_editor(PLANT)
    for _ in range(8):
        editor.palette("chamber").click()  # without waiting
    editor.wait()
    assert len(parts(editor)) == 11
    for _ in range(8):
        editor.page.keyboard.press("Control+z")
    editor.wait()
    assert editor.text() == PLANT
    assert editor.recording()["tank.pressure"][-1] > 5e5


def test_a_change_on_disk_is_noticed(start_editor):
    editor = start_editor(PLANT)
    file = Path(editor.folder) / "plant.toml"
    other = PLANT.replace('"1 l"', '"5 l"')
    file.write_text(other)
    os.utime(file, (time.time() + 5, time.time() + 5))
    editor.page.wait_for_function("() => /disk/i.test(document.body.innerText)")
    editor.add("chamber")
    editor.button("Save").click()
    editor.wait()
    assert file.read_text() == other  # Save does not overwrite it without a question
