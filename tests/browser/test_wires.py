"""Wires in the drawing of the editor: kinds, selection, and segments moved by mouse, touch and keys."""

from __future__ import annotations

import tomllib

import pytest

CIRCUIT = """\
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"

[parts.valve]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3

[parts.bleed]
kind = "orifice"
from = "tank"
to = "hose"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3

[parts.hose]
kind = "tube"
from = "bleed.to"
to = "cylinder.cap"
length = "1 m"
bore = "4 mm"

[parts.tank]
kind = "chamber"
volume = "1 l"

[parts.cylinder]
kind = "cylinder"
body = "slide"
bore = "25 mm"
stroke_length = "50 mm"
acting = "single"
cap = { dead_volume = "5 cm^3" }

[parts.slide]
kind = "mass"
mass = "2 kg"

[parts.pressed]
kind = "switch"
measurement = "cylinder.cap.pressure"
on_above = "3 bar"
off_below = "2 bar"
sample_time = "1 ms"

[run]
duration = "0.2 s"

[drawing]
supply = { x = 0, y = 10 }
valve = { x = 20, y = 20 }
tank = { x = 40, y = 10 }
bleed = { x = 40, y = 22 }
hose = { x = 60, y = 22 }
cylinder = { x = 60, y = 8 }
slide = { x = 80, y = 8 }
pressed = { x = 80, y = 24 }
"""
CORNERS = """key => {
  const line = document.querySelector(`[data-wire="${key}"] .line`), { a, d, e, f } = line.getScreenCTM();
  return line.getAttribute("d").slice(1).split("L").map(point => point.split(" ").map(Number))
    .map(([x, y]) => [[x, y], [x * a + e, y * d + f]]);
}"""


@pytest.fixture
def editor(start_editor):
    return start_editor(CIRCUIT)


def wire(editor, key):
    return editor.page.locator(f'[data-wire="{key}"]')


def path(editor, key):
    """Corners of a wire in grid units."""
    return [grid for grid, _ in editor.page.evaluate(CORNERS, key)]


def middle(editor, key, k):
    """Middle of a segment of a wire on the screen."""
    (x1, y1), (x2, y2) = (screen for _, screen in editor.page.evaluate(CORNERS, key)[k : k + 2])
    return (x1 + x2) / 2.0, (y1 + y2) / 2.0


def unit(editor):
    """Length of a grid unit on the screen."""
    ((x1, _), (s1, _)), ((x2, _), (s2, _)) = editor.page.evaluate(CORNERS, "valve.from")[:2]
    return (s2 - s1) / (x2 - x1) if x1 != x2 else None


def drawing(editor):
    return tomllib.loads(editor.text())["drawing"]


def selected(editor):
    return editor.page.evaluate("() => window.poppet.store.wire")


def vertical(editor, key):
    """Index of the first vertical segment."""
    corners = path(editor, key)
    return next(k for k in range(len(corners) - 1) if corners[k][0] == corners[k + 1][0])


def test_four_kinds_of_wires_with_their_names(editor):
    names = {
        "valve.from": ("pipe", "Gas connection from valve.from to supply"),
        "hose.from": ("tube", "Connection of the tube end hose.from to bleed.to"),
        "hose.to": ("tube", "Connection of the tube end hose.to to cylinder.cap"),
        "cylinder.body": ("body", "Mechanical connection from cylinder.body to slide"),
        "pressed.measurement": ("signal", "Signal from cylinder.cap.pressure to pressed.measurement"),
    }
    assert {*editor.names("data-wire")} == {*names, "valve.to", "bleed.from"}
    looks = set()
    for key, (kind, label) in names.items():
        assert wire(editor, key).get_attribute("aria-label") == label
        assert kind in wire(editor, key).get_attribute("class").split()
        style = "e => { const s = getComputedStyle(e); return [s.strokeWidth, s.strokeDasharray].join() }"
        looks.add((kind, wire(editor, key).locator(".line").evaluate(style)))
    assert len(looks) == len({kind for kind, _ in looks}) == len({look for _, look in looks}) == 4


def test_a_click_selects_and_delete_disconnects(editor):
    editor.page.mouse.click(*middle(editor, "valve.from", vertical(editor, "valve.from")))
    assert selected(editor) == {"port": "valve.from"}
    assert wire(editor, "valve.from").get_attribute("aria-pressed") == "true"
    editor.press("Delete")
    assert "from" not in tomllib.loads(editor.text())["parts"]["valve"]
    assert wire(editor, "valve.from").count() == 0
    assert selected(editor) is None
    assert "valve.from is disconnected." in message(editor)
    assert editor.page.evaluate("() => document.activeElement.closest('#drawing') !== null")
    editor.press("Control+z")
    assert editor.text() == CIRCUIT
    editor.page.mouse.click(*middle(editor, "hose.from", 0))
    editor.press("Delete")
    parts = tomllib.loads(editor.text())["parts"]
    assert "from" not in parts["hose"]
    assert "to" not in parts["bleed"]


def test_a_dragged_segment_is_stored_and_undone(editor):
    key, step = "valve.from", unit(editor)
    k = vertical(editor, key)
    before, (x, y) = path(editor, key), middle(editor, key, k)
    editor.drag((x, y), (x + 3.0 * step, y))
    wanted = before[k][0] + 3
    assert [x for x, _ in drawing(editor)[key]["points"]] == [wanted, wanted]
    assert editor.text().startswith(CIRCUIT)
    assert editor.text().count("\n") == CIRCUIT.count("\n") + 1
    assert wanted in [x for x, _ in path(editor, key)]
    assert selected(editor) == {"port": key}
    editor.press("Control+z")
    assert editor.text() == CIRCUIT
    assert path(editor, key) == before
    editor.press("Control+y")
    editor.page.mouse.dblclick(*middle(editor, key, vertical(editor, key)))
    editor.wait()
    assert key not in drawing(editor)


def message(editor):
    return editor.page.locator("#announce").inner_text()


def test_escape_ends_the_drag_of_a_segment(editor):
    key, step = "valve.from", unit(editor)
    before, (x, y) = path(editor, key), middle(editor, key, vertical(editor, key))
    mouse = editor.page.mouse
    mouse.move(x, y)
    mouse.down()
    mouse.move(x + 3.0 * step, y, steps=3)
    assert path(editor, key) != before
    editor.press("Escape")
    assert path(editor, key) == before
    mouse.up()
    assert editor.text() == CIRCUIT


def test_a_segment_is_moved_by_touch(start_editor):
    editor = start_editor(CIRCUIT, touch=True)
    key, step = "valve.from", unit(editor)
    x, y = middle(editor, key, vertical(editor, key))
    session = editor.page.context.new_cdp_session(editor.page)

    def send(kind, *places):
        points = [{"x": left, "y": top, "id": 1} for left, top in places]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    send("touchStart", (x, y))
    for k in range(1, 5):
        send("touchMove", (x + k * step, y))
    send("touchEnd")
    editor.page.wait_for_function("() => window.poppet.text().includes('points')")
    editor.wait()
    assert len(drawing(editor)[key]["points"]) == 2


def test_a_wire_with_keys_only(editor):
    """W goes to the wire of the selected part, arrows move its segment, as one step of undo; R removes the points."""
    editor.part("valve").focus()
    editor.press("Enter", "w")
    key = selected(editor)["port"]
    assert editor.page.evaluate("() => document.activeElement.dataset.wire") == key
    before = path(editor, key)
    for _ in range(len(before)):  # to a vertical segment
        if path(editor, key) == before:
            editor.press("ArrowRight")
    assert path(editor, key) != before
    assert "has moved" in message(editor)
    editor.press("ArrowRight", "ArrowRight")
    assert len(drawing(editor)[key]["points"]) == 2
    assert editor.page.evaluate("() => document.activeElement.dataset.wire") == key
    x = path(editor, key)
    editor.press("Control+z")
    assert editor.text() == CIRCUIT
    editor.press("Control+y")
    assert path(editor, key) == x
    editor.press("r")
    assert editor.text().strip() == CIRCUIT.strip()
    editor.press("Delete")
    assert editor.page.evaluate("() => document.activeElement.closest('#drawing') !== null")
    owner, port = key.split(".")
    assert port not in tomllib.loads(editor.text())["parts"][owner]


def test_points_move_with_both_ends(editor):
    key, step = "valve.from", unit(editor)
    x, y = middle(editor, key, vertical(editor, key))
    editor.drag((x, y), (x + 3.0 * step, y))
    points, before = drawing(editor)[key]["points"], path(editor, key)
    editor.page.locator("#drawing").focus()
    editor.press("Control+a", "ArrowDown", "Shift+ArrowRight")
    assert drawing(editor)[key]["points"] == [[x + 4, y + 1] for x, y in points]
    assert path(editor, key) == [[x + 4, y + 1] for x, y in before]
    editor.press("Control+z")
    assert drawing(editor)[key]["points"] == points
    # One end alone: the points stay.
    editor.part("valve").focus()
    editor.press("Enter", "ArrowDown")
    assert drawing(editor)[key]["points"] == points


def test_copies_have_the_points_of_their_wires(editor):
    key, step = "valve.from", unit(editor)
    x, y = middle(editor, key, vertical(editor, key))
    editor.drag((x, y), (x + 3.0 * step, y))
    editor.page.locator("#drawing").focus()
    editor.press("Control+a", "Control+c", "Control+v")
    places = drawing(editor)
    shift = places["valve_2"]["x"] - places["valve"]["x"]
    assert shift > 0
    assert places["valve_2.from"]["points"] == [[x + shift, y + shift] for x, y in places[key]["points"]]


def test_wires_follow_a_dragged_part(editor):
    """All nodes of wires stay, and wires without a connection to the part do not move."""
    editor.page.evaluate("() => { window.kept = [...document.querySelectorAll('[data-wire]')]; }")
    still = {key: path(editor, key) for key in ("cylinder.body", "pressed.measurement")}
    before = path(editor, "valve.from")
    x, y = editor.centre(editor.part("valve"))
    editor.drag((x, y), (x, y + 4.0 * unit(editor)))
    assert path(editor, "valve.from")[0] == [before[0][0], before[0][1] + 4]
    assert still == {key: path(editor, key) for key in still}
    assert editor.page.evaluate("() => window.kept.every(node => node.isConnected)")


def test_a_port_that_is_dropped_on_a_wire_joins_its_node(editor):
    editor.palette("orifice").click()
    editor.wait()
    editor.drag(
        editor.centre(editor.port("orifice.from")), middle(editor, "valve.from", vertical(editor, "valve.from"))
    )
    assert tomllib.loads(editor.text())["parts"]["orifice"]["from"] == "supply"
    assert editor.page.locator('[data-wire="orifice.from"] .junction, [data-wire="valve.from"] .junction').count() == 1
