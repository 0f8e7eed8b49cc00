"""Drawing and palette of the editor: what a user does with mouse, touch and keys, and what is then in the file."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
PROBLEMS = """() => {
  const at = (x, y, name) => document.elementFromPoint(x, y)?.closest(`[${name}]`), found = [];
  const view = document.getElementById("drawing").getBoundingClientRect();
  for (const name of ["data-part", "data-port"]) {
    const seen = new Set(), all = [...document.querySelectorAll(`[${name}]`)].map(e => [e, e.getBoundingClientRect()]);
    for (const [element, { left, top, right, bottom }] of all) {
      const label = element.getAttribute(name);
      if (seen.has(label)) found.push(`${label} twice`);
      seen.add(label);
      const isSeen = left >= view.left && right <= view.right && top >= view.top && bottom <= view.bottom;
      if (!isSeen) found.push(`${label} outside`);
      if (at((left + right) / 2, (top + bottom) / 2, name) !== element) found.push(`${label} covered`);
      if (name === "data-port") continue;
      for (const [other, box] of all) {
        const isApart = left >= box.right || box.left >= right || top >= box.bottom || box.top >= bottom;
        if (other !== element && !isApart) found.push(`${label} on ${other.dataset.part}`);
      }
    }
  }
  return found;
}"""
"""Parts and ports that are not visible, covered at their centre, or on another part."""


def content(editor):
    return tomllib.loads(editor.text())


def place(editor, part):
    return content(editor)["drawing"][part]


def message(editor):
    return editor.page.locator("#announce").inner_text()


def add(editor, *kinds):
    for kind in kinds:
        editor.palette(kind).click()
        editor.wait()


# --- Palette ---


def test_parts_of_all_kinds_are_visible_and_cover_nothing(editor):
    kinds = editor.names("data-kind")
    assert len(kinds) == len(set(kinds)) >= 38
    for kind in kinds:
        add(editor, kind)
        assert editor.page.evaluate(PROBLEMS) == []
    assert [*content(editor)["parts"]] == kinds


def test_many_parts_of_one_kind_stay_in_view(editor):
    add(editor, *["orifice"] * 20)
    assert editor.page.evaluate(PROBLEMS) == []
    editor.page.locator("#drawing").focus()
    editor.press("Control+a", "r")
    assert editor.page.evaluate(PROBLEMS) == []
    assert {part["rotation"] for part in content(editor)["drawing"].values()} == {90}


def test_fast_clicks_add_parts_side_by_side(editor):
    for _ in range(4):
        editor.palette("tube").click()
    editor.wait()
    assert [*content(editor)["parts"]] == ["tube", "tube_2", "tube_3", "tube_4"]
    assert editor.page.evaluate(PROBLEMS) == []


def test_search_of_the_palette(editor):
    editor.page.locator("#drawing").focus()
    editor.press("/")
    editor.page.keyboard.type("check pilot")
    shown = editor.page.locator("[data-kind]:visible")
    assert [button.get_attribute("data-kind") for button in shown.all()] == ["piloted_check_valve"]
    editor.press("Enter")
    assert [*content(editor)["parts"]] == ["piloted_check_valve"]
    editor.press("Escape")
    editor.page.keyboard.type("zzz")
    assert shown.count() == 0
    assert editor.page.get_by_text("No part has this name.").is_visible()


def test_arrow_keys_in_the_palette(editor):
    editor.palette("reservoir").focus()
    editor.press("ArrowDown", "ArrowRight", "ArrowUp", "ArrowUp")
    assert editor.page.evaluate("() => document.activeElement.type") == "search"
    editor.press("ArrowDown", "End", "Enter")
    assert len(content(editor)["parts"]) == 1


def test_drag_from_the_palette(editor):
    left, top, right, bottom = editor.box(editor.page.locator("#drawing"))
    wanted = left + 0.75 * (right - left), top + 0.25 * (bottom - top)
    editor.drag(editor.centre(editor.palette("chamber")), wanted)
    x, y = editor.centre(editor.part("chamber"))
    assert abs(x - wanted[0]) < 12.0
    assert abs(y - wanted[1]) < 12.0
    assert [*content(editor)["parts"]] == ["chamber"]


# --- Places ---


def test_a_drag_is_one_step_on_the_grid(editor):
    add(editor, "chamber")
    before, (x, y) = place(editor, "chamber"), editor.centre(editor.part("chamber"))
    editor.drag((x, y), (x + 52.0, y - 31.0), steps=12)
    after = place(editor, "chamber")
    assert (after["x"] - before["x"], after["y"] - before["y"]) == (5, -3)
    editor.press("Control+z")
    assert place(editor, "chamber") == before


def test_escape_ends_a_drag(editor):
    add(editor, "chamber")
    before, (x, y) = editor.text(), editor.centre(editor.part("chamber"))
    editor.page.mouse.move(x, y)
    editor.page.mouse.down()
    editor.page.mouse.move(x + 80.0, y, steps=4)
    assert editor.centre(editor.part("chamber")) != (x, y)
    editor.press("Escape")
    editor.page.mouse.up()
    editor.wait()
    assert editor.text() == before
    assert editor.centre(editor.part("chamber")) == pytest.approx((x, y), abs=0.1)


def test_arrow_keys_move_the_selection_as_one_step(editor):
    add(editor, "orifice", "chamber")
    before = content(editor)["drawing"]
    editor.page.locator("#drawing").focus()
    editor.press("Control+a", "ArrowRight", "ArrowRight", "Shift+ArrowDown")
    after = content(editor)["drawing"]
    for part in before:
        assert (after[part]["x"] - before[part]["x"], after[part]["y"] - before[part]["y"]) == (2, 4)
    editor.press("Control+z")
    assert content(editor)["drawing"] == before


def test_rotate_and_mirror_by_keys(editor):
    add(editor, "check_valve")
    left = editor.centre(editor.port("check_valve.from"))
    centre = editor.centre(editor.part("check_valve"))
    assert left[0] < centre[0]
    editor.part("check_valve").focus()
    editor.press("m")
    assert editor.centre(editor.port("check_valve.from"))[0] > centre[0]
    editor.press("r")
    assert editor.centre(editor.port("check_valve.from"))[1] > centre[1]
    assert place(editor, "check_valve")["mirror"] is True
    editor.press("m", "r")
    assert "mirror" not in place(editor, "check_valve")
    editor.press("r", "r")
    start = place(editor, "check_valve")
    editor.press("r", "r", "r", "r")
    assert place(editor, "check_valve") == start


def test_two_turns_of_several_parts_about_their_centre(editor):
    add(editor, "orifice", "chamber")
    before = content(editor)["drawing"]
    editor.page.locator("#drawing").focus()
    editor.press("Control+a", "m", "m")
    assert content(editor)["drawing"] == before


def test_moving_a_part_changes_positions_only(start_editor):
    text = (EXAMPLES / "cylinder_meter_out.toml").read_text(encoding="utf-8")
    editor = start_editor(text)
    shown = {name: editor.centre(editor.part(name)) for name in editor.names()}
    x, y = shown["slide"]
    editor.drag((x, y), (x, y + 60.0))
    assert editor.text().startswith(text.rstrip("\n"))
    assert set(content(editor)) - set(tomllib.loads(text)) == {"drawing"}
    moved = {name for name in shown if editor.centre(editor.part(name)) != pytest.approx(shown[name], abs=0.5)}
    assert moved == {"slide"}


# --- Selection ---


def test_band_and_shift_click(editor):
    add(editor, "reservoir", "orifice", "chamber")
    view = editor.box(editor.page.locator("#drawing"))
    first, second = editor.box(editor.part("reservoir")), editor.box(editor.part("orifice"))
    editor.drag((first[0] - 15.0, view[1] + 3.0), (second[0] + 15.0, view[3] - 3.0))
    selected = editor.page.locator("[data-part][aria-pressed=true]")
    names = {part.get_attribute("data-part") for part in selected.all()}
    assert names == {"reservoir", "orifice"}
    editor.page.keyboard.down("Shift")
    editor.select("orifice")
    editor.select("chamber")
    editor.page.keyboard.up("Shift")
    assert {part.get_attribute("data-part") for part in selected.all()} == {"reservoir", "chamber"}
    editor.press("Delete")
    assert [*content(editor)["parts"]] == ["orifice"]
    editor.press("Control+z")
    assert [*content(editor)["parts"]] == ["reservoir", "orifice", "chamber"]


def test_escape_empties_the_selection(editor):
    add(editor, "chamber")
    editor.part("chamber").focus()
    editor.press("Escape")
    assert editor.part("chamber").get_attribute("aria-pressed") == "false"


# --- Connections ---


def test_a_port_and_a_part(editor):
    add(editor, "orifice", "chamber")
    editor.connect("orifice.to", "chamber")
    assert content(editor)["parts"]["orifice"]["to"] == "chamber"


def test_a_drag_from_a_port_to_a_port(editor):
    add(editor, "spool_valve", "cylinder")
    editor.drag(editor.centre(editor.port("spool_valve.a")), editor.centre(editor.port("cylinder.cap")))
    assert content(editor)["parts"]["spool_valve"]["a"] == "cylinder.cap"


def test_two_ports_get_a_chamber_or_a_tube(editor):
    add(editor, "orifice", "orifice")
    editor.connect("orifice.to", "orifice_2.from")
    parts = content(editor)["parts"]
    assert (parts["orifice"]["to"], parts["orifice_2"]["from"]) == ("chamber", "chamber")
    assert parts["chamber"]["volume"]["value"] == "20 cm^3"
    assert editor.page.evaluate(PROBLEMS) == []
    editor.button("Use a tube instead").click()
    editor.wait()
    parts = content(editor)["parts"]
    assert "chamber" not in parts
    assert (parts["orifice"]["to"], parts["orifice_2"]["from"]) == ("tube", "tube")
    assert (parts["tube"]["from"], parts["tube"]["to"]) == ("orifice.to", "orifice_2.from")


def test_the_offer_can_take_a_chamber_back(editor):
    add(editor, "orifice", "orifice")
    before = editor.text()
    editor.connect("orifice.to", "orifice_2.from")
    editor.button("Revert").click()
    editor.wait()
    assert editor.text() == before


def test_a_third_port_joins_the_chamber_of_two(editor):
    add(editor, "orifice", "orifice", "orifice")
    editor.connect("orifice.to", "orifice_2.from")
    editor.connect("orifice_3.from", "orifice_2.from")
    parts = content(editor)["parts"]
    assert [parts[name][port] for name, port in (("orifice", "to"), ("orifice_2", "from"), ("orifice_3", "from"))] == [
        "chamber"
    ] * 3


def test_a_wire_dropped_on_a_wire_joins_its_gas_node(editor):
    add(editor, "reservoir", "orifice", "orifice")
    editor.connect("orifice.from", "reservoir")
    x, y = editor.centre(editor.part("orifice_2"))
    editor.drag((x, y), (x, y + 90.0))
    wire = editor.page.locator('[data-wire="orifice.from"]')
    editor.drag(editor.centre(editor.port("orifice_2.from")), editor.centre(wire.locator(".line")))
    assert content(editor)["parts"]["orifice_2"]["from"] == "reservoir"
    assert editor.page.locator(".junction:visible").count() == 1
    editor.port("orifice_2.from").focus()
    editor.press("w", "Delete")
    assert "from" not in content(editor)["parts"]["orifice_2"]
    assert content(editor)["parts"]["orifice"]["from"] == "reservoir"


def test_names_for_screen_readers(editor):
    add(editor, "orifice", "chamber")
    editor.connect("orifice.to", "chamber")
    drawing = editor.page.get_by_role("application")
    assert "2 parts" in drawing.get_attribute("aria-label")
    assert drawing.get_by_role("button", name="chamber, chamber").count() == 1
    assert drawing.get_by_role("button", name="orifice.to, gas port, connected to chamber.").count() == 1
    start = drawing.get_by_role("button", name="orifice.from, gas port, not connected (required).")
    assert "Specify" in start.get_attribute("aria-label")
    start.focus()
    editor.press("Enter")
    assert message(editor) == "Connect orifice.from: choose a port or a part. Escape cancels."
    editor.press("a")
    assert message(editor) == "orifice.from is connected to ambient."


def test_rod_and_body(editor):
    add(editor, "cylinder", "mass")
    editor.connect("cylinder.body", "mass")
    assert content(editor)["parts"]["cylinder"]["body"] == "mass"


def test_the_atmosphere_by_button_and_by_key(editor):
    add(editor, "orifice")
    editor.page.mouse.click(*editor.centre(editor.port("orifice.from")))
    editor.button("Atmosphere").click()
    editor.wait()
    editor.port("orifice.to").focus()
    editor.press("a")
    parts = content(editor)["parts"]
    assert (parts["orifice"]["from"], parts["orifice"]["to"]) == ("ambient", "ambient")


def test_an_output_drives_an_input(editor):
    add(editor, "pid", "orifice", "chamber")
    editor.connect("pid.output", "orifice.opening")
    assert content(editor)["connections"] == {"orifice.opening": "pid.command"}
    editor.page.get_by_label("Output that drives orifice.opening").last.select_option("pid.fill_command")
    editor.wait()
    assert content(editor)["connections"] == {"orifice.opening": "pid.fill_command"}
    editor.connect("pid.measurement", "chamber")
    assert content(editor)["connections"]["pid.measurement"] == "chamber.pressure"


@pytest.mark.parametrize(
    ("kinds", "start", "end", "reason"),
    [
        (("orifice", "mass"), "orifice.to", "mass", "neither a gas node nor a free gas port"),
        (("orifice", "mass"), "orifice.to", "orifice", "A part cannot be connected to itself"),
        (("orifice", "mass"), "orifice.to", "orifice.from", "A part cannot be connected to itself"),
        (("cylinder", "chamber"), "cylinder.body", "chamber", "neither a body nor a free mechanical port"),
        (("pid", "switch"), "pid.output", "switch.output", "An output can be connected to an input only"),
        (("pid", "chamber"), "pid.output", "chamber", "no input for an output"),
    ],
)
def test_impossible_ends_are_grey_and_say_why(editor, kinds, start, end, reason):
    add(editor, *kinds)
    before = editor.text()
    editor.page.mouse.click(*editor.centre(editor.port(start)))
    target = editor.port(end) if "." in end else editor.part(end)
    assert target.locator("xpath=ancestor-or-self::*[contains(@class, 'is-impossible')]").count() > 0
    editor.page.mouse.click(*editor.centre(target))
    assert reason in message(editor)
    assert reason in editor.page.locator(".connect-bar").inner_text()
    editor.press("Escape")
    assert not editor.page.locator(".connect-bar").is_visible()
    assert editor.text() == before


def test_errors_are_at_their_ports_and_parts(editor):
    add(editor, "orifice", "chamber")
    port = editor.port("orifice.to")
    assert port.get_attribute("data-address") == "parts.orifice.to"
    assert "Specify" in port.locator("title").text_content()
    editor.connect("orifice.to", "chamber")
    assert port.get_attribute("data-address") is None
    editor.select("chamber")
    editor.type("chamber.volume", "-1 l")
    mark = editor.page.locator('.mark[data-address="parts.chamber.volume"]')
    assert mark.count() == 1
    assert "volume" in mark.locator("title").text_content()


# --- Keys alone ---


def test_a_connection_with_keys_only(editor):
    editor.palette("chamber").focus()
    editor.press("Enter")
    editor.palette("orifice").focus()
    editor.press("Enter")
    editor.page.locator("#drawing").focus()
    editor.press("Tab", "Tab")
    assert editor.page.evaluate("() => document.activeElement.dataset.part") == "orifice"
    editor.press("p", "ArrowRight")
    assert editor.page.evaluate("() => document.activeElement.dataset.port") == "orifice.to"
    editor.press("Enter", "Shift+Tab")
    assert editor.page.evaluate("() => document.activeElement.dataset.part") == "chamber"
    editor.press("Enter")
    assert content(editor)["parts"]["orifice"]["to"] == "chamber"


def test_the_list_of_all_possible_ends(editor):
    add(editor, "orifice", "chamber", "mass")
    editor.port("orifice.from").focus()
    editor.press("Enter")
    targets = editor.page.get_by_label("All possible targets")
    assert targets.locator("option").all_text_contents() == ["All possible targets", "chamber"]
    targets.select_option("chamber")
    editor.button("Connect").click()
    editor.wait()
    assert content(editor)["parts"]["orifice"]["from"] == "chamber"


def test_the_focus_stays_where_it_is(editor):
    add(editor, "orifice", "chamber")
    editor.part("chamber").focus()
    editor.press("ArrowLeft", "ArrowLeft", "r")
    assert editor.page.evaluate("() => document.activeElement.dataset.part") == "chamber"
    editor.press("Shift+ArrowLeft", "Shift+ArrowLeft", "Shift+ArrowLeft", "Shift+ArrowLeft", "Shift+ArrowLeft")
    assert editor.page.evaluate("() => document.activeElement.dataset.part") == "chamber"
    assert editor.names() == ["chamber", "orifice"]  # the Tab key follows the drawing


# --- Clipboard ---


def test_copy_and_paste_between_windows(start_editor):
    text = (EXAMPLES / "pressure_control.toml").read_text(encoding="utf-8")
    first, second = start_editor(text), start_editor()
    first.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    first.page.locator("#drawing").focus()
    first.press("Control+a", "Control+c")
    copied = first.page.evaluate("() => navigator.clipboard.readText()")
    for _ in range(2):
        second.page.evaluate(
            """text => { const data = new DataTransfer(); data.setData("text/plain", text);
               document.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data })); }""",
            copied,
        )
        second.wait()
    wanted, pasted = tomllib.loads(text), content(second)
    for name, part in wanted["parts"].items():
        assert pasted["parts"][name] == part
        assert pasted["parts"][f"{name}_2"]["kind"] == part["kind"]
    assert pasted["parts"]["fill_2"]["to"] == "tank_2"
    assert pasted["connections"]["fill_2.opening"] == "regulator_2.fill_command"
    assert pasted["signals"]["regulator_2.setpoint"] == wanted["signals"]["regulator.setpoint"]
    assert second.page.evaluate(PROBLEMS) == []


def test_a_copy_with_the_keys(editor):
    add(editor, "chamber")
    editor.part("chamber").focus()
    editor.press("Control+c", "Control+v")
    editor.part("chamber_2").wait_for()
    editor.wait()
    assert [*content(editor)["parts"]] == ["chamber", "chamber_2"]
    editor.press("Control+x")
    assert len(content(editor)["parts"]) == 1


# --- View ---


def test_the_wheel_zooms_about_the_pointer(editor):
    add(editor, "orifice", "chamber")
    x, y = editor.centre(editor.part("chamber"))
    before = editor.box(editor.part("chamber"))
    editor.page.mouse.move(x, y)
    editor.page.mouse.wheel(0, -300)
    after = editor.box(editor.part("chamber"))
    assert editor.centre(editor.part("chamber")) == pytest.approx((x, y), abs=1.0)
    assert after[2] - after[0] > 1.3 * (before[2] - before[0])
    for _ in range(30):
        editor.page.mouse.wheel(0, 500)
    least = editor.box(editor.part("chamber"))
    assert least[2] - least[0] == pytest.approx(0.2 * 10.0 * 8.0, rel=0.1)
    editor.press("0")
    assert editor.page.evaluate(PROBLEMS) == []


def test_the_drawing_cannot_be_lost(editor):
    add(editor, "chamber")
    view = editor.box(editor.page.locator("#drawing"))
    middle = (view[0] + view[2]) / 2.0, view[3] - 20.0
    for _ in range(4):
        editor.page.mouse.move(*middle)
        editor.page.mouse.down(button="right")
        editor.page.mouse.move(middle[0] + 600.0, middle[1] - 300.0, steps=3)
        editor.page.mouse.up(button="right")
    box = editor.box(editor.part("chamber"))
    assert box[0] < view[2]
    assert box[3] > view[1]


def test_touch(start_editor):
    editor = start_editor(width=360, height=740, touch=True)
    editor.page.get_by_role("tab", name="Parts").tap()
    editor.palette("orifice").tap()
    editor.wait()
    editor.page.get_by_role("tab", name="Parts").tap()
    editor.palette("chamber").tap()
    editor.wait()
    editor.page.get_by_role("tab", name="Drawing").tap()
    editor.page.touchscreen.tap(*editor.centre(editor.port("orifice.to")))
    editor.page.touchscreen.tap(*editor.centre(editor.part("chamber")))
    editor.wait()
    assert content(editor)["parts"]["orifice"]["to"] == "chamber"
    editor.page.get_by_role("tab", name="Parts").tap()
    editor.palette("reservoir").tap()
    editor.wait()
    editor.page.touchscreen.tap(*editor.centre(editor.port("orifice.from")))
    editor.page.touchscreen.tap(*editor.centre(editor.part("reservoir")))
    editor.wait()
    assert content(editor)["parts"]["orifice"]["from"] == "reservoir"
    before = editor.box(editor.part("chamber"))
    pinch(editor, editor.centre(editor.part("chamber")), 40.0, 90.0)
    after = editor.box(editor.part("chamber"))
    assert (after[2] - after[0]) / (before[2] - before[0]) == pytest.approx(90.0 / 40.0, rel=0.1)


def pinch(editor, centre, start, end):
    session = editor.page.context.new_cdp_session(editor.page)

    def send(kind, distance):
        points = (
            []
            if distance is None
            else [{"x": centre[0] + sign * distance / 2.0, "y": centre[1], "id": k} for k, sign in enumerate((-1, 1))]
        )
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    send("touchStart", start)
    for k in range(1, 6):
        send("touchMove", start + (end - start) * k / 5.0)
    send("touchEnd", None)


# --- State of a run ---


def test_the_state_at_the_time_cursor(start_editor):
    editor = start_editor((EXAMPLES / "cylinder_meter_out.toml").read_text(encoding="utf-8"))
    slider = editor.page.locator("#curves input[type=range]")
    recording = editor.recording()

    def at(time):
        move = "(element, time) => { element.value = time; time = +element.value; element.oninput(); return time; }"
        time = slider.evaluate(move, time)
        row = min(range(len(recording["time"])), key=lambda k: abs(recording["time"][k] - time))
        editor.page.wait_for_function(
            "text => [...document.querySelectorAll('.value')].some(e => e.textContent === text)",
            arg=f"{1e3 * recording['slide.position'][row]:.1f} mm",
        )
        piston = editor.part("cylinder").locator(".symbol > .line").first.get_attribute("d")
        return float(piston.removeprefix("M").split()[0]), {
            e.get_attribute("transform") for e in editor.page.locator(".flow:visible").all()
        }

    start, still = at(0.05)
    end, _ = at(1.5)
    middle, moving = at(0.25)
    assert start < middle < end
    assert len(moving) > len(still)


def test_a_hidden_drawing_keeps_its_view(start_editor):
    editor = start_editor((EXAMPLES / "pressure_control.toml").read_text(encoding="utf-8"), width=360, height=740)
    before = editor.box(editor.part("tank"))
    editor.page.get_by_role("tab", name="Parts").click()
    editor.page.get_by_role("tab", name="Drawing").click()
    assert editor.box(editor.part("tank")) == pytest.approx(before, abs=0.5)
    assert editor.page.evaluate(PROBLEMS) == []


def test_arrow_keys_move_the_view_if_nothing_is_selected(editor):
    add(editor, "chamber")
    editor.page.locator("#drawing").focus()
    editor.press("Escape")
    before, text = editor.centre(editor.part("chamber")), editor.text()
    editor.press("ArrowRight")
    assert editor.centre(editor.part("chamber")) == pytest.approx((before[0] - 40.0, before[1]), abs=0.5)
    assert editor.text() == text


def test_names_of_ports_are_visible_at_a_selected_part(editor):
    add(editor, "spool_valve", "chamber")
    names = editor.page.locator(".port-name:visible")
    assert names.count() == 0
    editor.select("spool_valve")
    assert {"supply", "exhaust a", "pilot b"} <= {*names.all_text_contents()}


def test_a_long_chain_fits_into_the_view(start_editor):
    chain = "".join(
        f'[parts.tank_{k}]\nkind = "chamber"\nvolume = "1 l"\n\n[parts.hole_{k}]\nkind = "orifice"\n'
        f'from = "{"supply" if k == 0 else f"tank_{k - 1}"}"\nto = "tank_{k}"\n'
        'sonic_conductance = "1 dm^3/(s bar)"\ncritical_ratio = 0.3\n\n'
        for k in range(25)
    )
    editor = start_editor(
        f'[run]\nduration = "1 s"\n\n[parts.supply]\nkind = "reservoir"\npressure = "6 bar g"\n\n{chain}'
    )
    assert [problem for problem in editor.page.evaluate(PROBLEMS) if "outside" in problem] == []
    editor.select("hole_24")
    assert editor.part("hole_24").get_attribute("aria-pressed") == "true"


def test_a_piston_at_rest_is_at_its_end(start_editor):
    text = (EXAMPLES / "cylinder_meter_out.toml").read_text(encoding="utf-8")
    at_rest = text.replace("values = [0, 1, 0]", "values = [0, 0, 0]")
    assert at_rest != text
    places = []
    for content_ in (text, at_rest):
        editor = start_editor(content_)
        editor.page.wait_for_function("() => document.querySelector('.value').textContent !== ''")
        piston = editor.part("cylinder").locator(".symbol > .line").first.get_attribute("d")
        places.append(float(piston.removeprefix("M").split()[0]))
    assert places[1] == pytest.approx(places[0], abs=0.05)


def test_a_port_that_loses_its_gas_node_says_so(editor):
    add(editor, "orifice", "chamber", "chamber")
    editor.connect("orifice.to", "chamber")
    before = editor.text()
    editor.connect("orifice.to", "chamber_2")
    assert "orifice.to is connected to chamber_2, and no longer to chamber." in message(editor)
    editor.page.locator(".offer button").first.click()
    editor.wait()
    assert editor.text() == before
