"""Form of the selected part in Chromium: fields, units, sliders, sizes, models, connections, signals and texts."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from editor_page import Editor

EXAMPLES = Path(__file__).parents[2] / "examples"
BENCH = """\
# a bench
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"  # gauge

[parts.hole]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "0.5 dm^3/(s bar)"  # measured
critical_ratio = 0.35

[parts.tank]
kind = "chamber"
volume = "10 l"

[run]
duration = "2 s"
"""


def part(editor: Editor, name: str) -> dict:
    return tomllib.loads(editor.text())["parts"][name]


@pytest.fixture
def bench(start_editor) -> Editor:
    editor = start_editor(BENCH, "bench.toml")
    editor.select("hole")
    return editor


def test_a_new_orifice_shows_its_fields(editor):
    editor.add("orifice")
    editor.type("orifice.sonic_conductance", "0.5 dm^3/(s bar)")
    editor.type("orifice.critical_ratio", "0.4")
    values = part(editor, "orifice")
    assert (values["sonic_conductance"], values["critical_ratio"]) == ("0.5 dm^3/(s bar)", 0.4)


def test_a_number_without_a_unit_gets_the_unit_beside_it(bench):
    bench.type("hole.sonic_conductance", "0.7")
    assert bench.text() == BENCH.replace("0.5 dm", "0.7 dm")
    assert bench.field("hole.sonic_conductance").input_value() == "0.7 dm^3/(s bar)"


def test_another_unit_leaves_the_simulation_unchanged(bench):
    before = bench.recording()["tank.pressure"]
    bench.page.get_by_label("Unit of sonic conductance").select_option("l/(min bar)")
    bench.wait()
    assert bench.text() == BENCH.replace("0.5 dm^3/(s bar)", "30 l/(min bar)")
    assert bench.recording()["tank.pressure"] == before


def test_an_empty_field_removes_the_value(bench):
    bench.type("hole.critical_ratio", "")
    assert bench.text() == BENCH.replace("critical_ratio = 0.35\n", "")
    # The assumed value without a critical ratio is 0.3.
    assert bench.field("hole.critical_ratio").get_attribute("placeholder") == "0.3 (used in the run)"


def test_escape_restores_the_value(bench):
    field = bench.field("hole.critical_ratio")
    field.fill("0.9")
    field.press("Escape")
    assert field.input_value() == "0.35"
    assert bench.text() == BENCH


def test_an_error_is_displayed_at_its_field(bench):
    bench.type("hole.critical_ratio", "1.5")
    field = bench.field("hole.critical_ratio")
    assert field.get_attribute("aria-invalid") == "true"
    message = bench.page.locator('#form [data-address="parts.hole.critical_ratio"]')
    assert "less than 1" in message.inner_text()
    assert message.get_attribute("id") in field.get_attribute("aria-describedby").split()
    bench.type("hole.critical_ratio", "0.35")
    assert field.get_attribute("aria-invalid") == "false"
    assert message.count() == 0


def test_save_applies_the_text_that_is_being_typed(bench):
    bench.field("hole.critical_ratio").fill("0.2")
    bench.field("hole.critical_ratio").press("Control+s")
    bench.wait()
    bench.page.wait_for_function("() => !document.getElementById('name').textContent.includes('*')")
    assert (bench.folder / "bench.toml").read_text() == BENCH.replace("0.35", "0.2")


def test_a_slider_changes_the_curve_and_makes_one_step_of_the_history(bench):
    former = bench.recording()["tank.pressure"][-1]
    slider = bench.page.locator('[data-slider="hole.sonic_conductance"]')
    left, top, right, bottom = bench.box(slider)
    middle = (top + bottom) / 2
    bench.drag(((left + right) / 2, middle), (left + 0.9 * (right - left), middle), steps=12)
    typed = part(bench, "hole")["sonic_conductance"]
    assert typed.endswith(" dm^3/(s bar)")
    assert 0.5 < float(typed.split()[0]) <= 1.5
    assert bench.recording()["tank.pressure"][-1] > former
    bench.button("Undo").click()
    bench.wait()
    assert bench.text() == BENCH
    assert bench.recording()["tank.pressure"][-1] == former


def test_a_slider_works_by_keys(bench):
    bench.page.locator('[data-slider="hole.critical_ratio"]').focus()
    for _ in range(20):
        bench.page.keyboard.press("ArrowRight")
    bench.page.keyboard.press("Tab")
    bench.wait()
    assert part(bench, "hole")["critical_ratio"] == pytest.approx(0.37, abs=0.001)
    bench.button("Undo").click()
    bench.wait()
    assert bench.text() == BENCH


def test_a_size_is_replaced_in_one_step(bench):
    bench.page.get_by_label("Size given as").select_option("nominal_flow")
    bench.wait()
    values = part(bench, "hole")
    assert "sonic_conductance" not in values
    # 0.5 dm^3/(s bar) with b = 0.3 carry 127 l/min ANR from 6 to 5 bar g; the start value is near it.
    assert values["nominal_flow"]["source"] == "assumed"
    assert 100 < float(values["nominal_flow"]["value"].split()[0]) < 150
    bench.button("Undo").click()
    bench.wait()
    assert bench.text() == BENCH
    bench.type("hole.effective_area", "3 mm^2")  # it determines the critical ratio too
    values = part(bench, "hole")
    assert {"effective_area", "sonic_conductance", "critical_ratio"} & values.keys() == {"effective_area"}
    assert bench.page.locator("#problems li").count() == 0
    bench.button("Undo").click()
    bench.wait()
    assert bench.text() == BENCH


def test_the_source_of_a_value_can_be_stated(bench):
    bench.page.get_by_role("button", name="Source of critical ratio: given").click()
    form = bench.page.locator("#form")
    form.get_by_label("Kind of source for critical ratio").select_option("measured")
    bench.wait()
    form.get_by_label("Page or table in the source of critical ratio").fill("bench 3")
    form.get_by_label("Page or table in the source of critical ratio").press("Tab")
    bench.wait()
    assert part(bench, "hole")["critical_ratio"] == {"value": 0.35, "source": "measured", "locator": "bench 3"}


def test_a_model_replaces_the_starting_values(editor):
    editor.add("spool_valve")
    editor.type("spool_valve.model", "SMC SY5000")
    values = part(editor, "spool_valve")
    assert values["model"] == "SMC SY5000"
    assert not {"sonic_conductance", "critical_ratio"} & values.keys()
    # Catalogue CAT.EUS11-83: C = 2.8 dm^3/(s bar)
    assert "2.8 dm^3/(s bar)" in editor.page.locator("#form .sets").inner_text()


def test_a_kind_without_models_says_so(bench):
    bench.add("flow_control_valve")
    assert "no models" in bench.field("flow_control_valve.model").get_attribute("placeholder")
    bench.add("spool_valve")
    assert "no models" not in bench.field("spool_valve.model").get_attribute("placeholder")


def test_a_part_is_renamed(bench):
    name = bench.page.locator("#form").get_by_label("Name", exact=True)
    name.fill("throttle")
    name.press("Enter")
    bench.wait()
    assert bench.text() == BENCH.replace("parts.hole", "parts.throttle")
    assert bench.field("throttle.critical_ratio").input_value() == "0.35"
    assert bench.page.evaluate("() => document.activeElement.value") == "throttle"


@pytest.mark.parametrize("name", ["tank", "2nd", "run", ""])
def test_a_name_that_is_not_possible_stays_in_the_field(bench, name):
    field = bench.page.locator("#form").get_by_label("Name", exact=True)
    field.fill(name)
    field.press("Enter")
    bench.wait()
    assert bench.text() == BENCH
    assert field.input_value() == name
    assert field.get_attribute("aria-invalid") == "true"
    field.press("Escape")
    assert field.input_value() == "hole"


def test_ports_are_connected_as_texts(editor):
    for kind in ("reservoir", "chamber", "orifice"):
        editor.add(kind)
    editor.type("orifice.from", "reservoir")
    editor.type("orifice.to", "chamber")
    assert len(editor.recording()["time"]) > 10
    editor.type("orifice.to", "ambient")
    assert part(editor, "orifice")["to"] == "ambient"
    editor.type("orifice.to", "")
    assert "to" not in part(editor, "orifice")
    editor.type("orifice.to", "chamer")
    assert "No part" in editor.page.locator("#form .bad:visible").first.inner_text()
    assert "to" not in part(editor, "orifice")


def test_a_chamber_is_inserted_between_two_ports(bench):
    bench.add("orifice")
    bench.type("orifice.to", "hole.to")  # joins the gas node of the other port
    assert part(bench, "orifice")["to"] == "tank"
    bench.add("silencer")
    bench.type("silencer.from", "orifice.from")
    assert (part(bench, "silencer")["from"], part(bench, "orifice")["from"]) == ("chamber", "chamber")
    assert part(bench, "chamber")["volume"]["value"] == "20 cm^3"
    bench.type("silencer.to", "silencer.from")
    assert "to" not in part(bench, "silencer")


def test_an_input_is_connected_to_an_output(start_editor):
    editor = start_editor((EXAMPLES / "two_cylinders.toml").read_text(), "two_cylinders.toml")
    editor.select("valveA")
    driver = editor.page.get_by_label("Output that drives command", exact=True)
    assert driver.input_value() == "plc.a"
    driver.fill("plc.b")
    driver.press("Enter")
    editor.wait()
    assert tomllib.loads(editor.text())["connections"]["valveA.command"] == "plc.b"
    driver.fill("")
    driver.press("Enter")
    editor.wait()
    assert "valveA.command" not in tomllib.loads(editor.text())["connections"]


def test_values_beside_fields_are_applied_before_they_are_saved(bench):
    """Ctrl+S in a field of a signal or of a source."""
    file = bench.folder / "bench.toml"
    bench.page.get_by_label("Signal of hole.opening").select_option("sine")
    bench.wait()
    field = bench.page.get_by_label("frequency of the signal of hole.opening")
    field.fill("7 Hz")
    field.press("Control+s")
    bench.wait()
    assert tomllib.loads(file.read_text(encoding="utf-8"))["signals"]["hole.opening"]["frequency"] == "7 Hz"
    bench.page.get_by_label("Source of critical ratio").click()
    note = bench.page.get_by_label("Note on critical ratio")
    note.fill("bench 3")
    note.press("Control+s")
    bench.wait()
    assert tomllib.loads(file.read_text(encoding="utf-8"))["parts"]["hole"]["critical_ratio"]["note"] == "bench 3"


def test_points_of_a_signal_are_dragged_and_typed(bench):
    bench.page.get_by_label("Signal of hole.opening").select_option("steps")
    bench.wait()
    signal = lambda: tomllib.loads(bench.text())["signals"]["hole.opening"]  # noqa: E731
    assert signal() == {"kind": "steps", "times": ["0 s", "0.5 s"], "values": [0, 1]}
    point = bench.page.locator("#form .curve-plot .handle").nth(1)
    bench.page.locator("#form .curve-plot").scroll_into_view_if_needed()
    x, y = bench.centre(point)
    bench.drag((x, y), (x + 40, y + 10))
    assert 0.6 < float(signal()["times"][1].removesuffix(" s")) < 1.5
    assert 0.7 < signal()["values"][1] < 1.0
    point.press("ArrowLeft")
    cell = bench.page.get_by_label("value, point 2")
    cell.fill("0.25")
    cell.press("Enter")
    bench.wait()
    assert signal()["values"] == [0, 0.25]
    assert bench.recording()["hole.opening"][-1] == 0.25
    bench.page.get_by_role("button", name="Add a point").click()
    bench.wait()
    assert len(signal()["times"]) == 3
    bench.page.get_by_label("Signal of hole.opening").select_option("")
    bench.wait()
    assert "hole.opening" not in tomllib.loads(bench.text()).get("signals", {})


def test_steps_of_a_sequence_are_lines(start_editor):
    text = (EXAMPLES / "two_cylinders.toml").read_text()
    editor = start_editor(text, "two_cylinders.toml")
    editor.select("plc")
    area = editor.page.locator('textarea[name="plc.steps"]')
    area.fill(area.input_value().replace("98 mm", "97 mm"))
    area.press("Control+Enter")
    editor.wait()
    assert editor.text() == text.replace('slideA.position > 98 mm"', 'slideA.position > 97 mm"')
    given = editor.field("plc.slideA_position")
    assert (given.input_value(), given.is_editable()) == ("slideA.position", False)
    editor.select("pressed")
    assert editor.field("pressed.measurement").input_value() == "cylinderB.cap.pressure"
    editor.type("pressed.measurement", "cylinderA.cap.pressure")
    assert part(editor, "pressed")["measurement"] == "cylinderA.cap.pressure"


def test_the_text_panel_applies_the_text_and_marks_errors(bench):
    bench.page.get_by_role("tab", name="Text").click()
    area = bench.page.get_by_label("Text of the circuit file")
    area.fill(BENCH.replace("10 l", "5 l"))
    area.press("Control+Enter")
    bench.wait()
    assert part(bench, "tank")["volume"] == "5 l"
    area.fill(BENCH.replace('kind = "chamber"', 'kind = "chambre"'))
    area.press("Control+Enter")
    bench.wait()
    assert bench.page.locator("#text .mark").all_inner_texts() == ["14"]
    bench.page.locator("#text").get_by_role("button", name="Line 14").click()
    selected = bench.page.evaluate(
        "() => { const e = document.activeElement; return e.value.slice(e.selectionStart, e.selectionEnd); }"
    )
    assert selected == 'kind = "chambre"'
    area.fill("broken = [\n")
    area.press("Control+Enter")
    bench.wait()
    assert area.input_value() == "broken = [\n"
    assert bench.page.locator("#text .mark").count() == 1


def test_the_circuit_panel_sets_options(bench):
    bench.page.get_by_role("tab", name="Circuit").click()
    bench.type("title", "Filling")
    bench.type("run.duration", "3")
    bench.type("gas.name", "nitrogen")
    stop = bench.page.locator('textarea[name="run.stop_when"]')
    stop.fill("tank.pressure > 2 bar")
    stop.press("Control+Enter")
    bench.wait()
    content = tomllib.loads(bench.text())
    assert (content["title"], content["gas"]) == ("Filling", {"name": "nitrogen"})
    assert content["run"] == {"duration": "3 s", "stop_when": "tank.pressure > 2 bar"}
    assert bench.recording()["tank.pressure"][-1] == pytest.approx(2e5, rel=1e-3)


@pytest.mark.parametrize("kind", ["orifice", "pid", "pressure_booster", "proportional_valve", "sequence"])
def test_each_field_has_one_input_with_a_name(editor, kind):
    editor.add(kind)
    names = editor.page.eval_on_selector_all(
        "#form input[type=text][name], #form textarea", "all => all.map(e => e.name)"
    )
    assert len(names) == len(set(names))
    assert all(editor.field(name).is_visible() for name in names if name != f"{kind}.steps")
    declared = editor.page.evaluate(
        "async kind => (await (await fetch('/palette')).json()).kinds.find(e => e.kind === kind)", kind
    )
    assert {f"{kind}.{field['name']}" for field in declared["fields"]} <= {*names}
    unnamed = editor.page.eval_on_selector_all(
        "#form :is(input, select, textarea)",
        "all => all.filter(e => !e.labels.length && !e.getAttribute('aria-label')).map(e => e.outerHTML)",
    )
    assert unnamed == []


def test_the_form_fits_into_a_narrow_page(start_editor):
    editor = start_editor(BENCH, "bench.toml", width=360, height=700)
    editor.select("hole")
    editor.page.locator("#panel-tabs").get_by_role("tab", name="Details").click()
    editor.type("hole.critical_ratio", "0.2")
    assert part(editor, "hole")["critical_ratio"] == 0.2
    assert editor.page.evaluate("() => document.documentElement.scrollWidth <= innerWidth")
    assert editor.page.evaluate(
        "() => { const e = document.getElementById('form'); return e.scrollWidth <= e.clientWidth; }"
    )


def test_several_parts_get_the_same_value(start_editor):
    editor = start_editor((EXAMPLES / "two_cylinders.toml").read_text(), "two_cylinders.toml")
    editor.select("cylinderA")
    editor.page.keyboard.down("Shift")
    editor.select("cylinderB")
    editor.page.keyboard.up("Shift")
    bore = editor.page.get_by_label("bore", exact=True)
    assert (bore.input_value(), bore.get_attribute("placeholder")) == ("", "various")
    bore.fill("50")
    bore.press("Enter")
    editor.wait()
    assert [part(editor, name)["bore"] for name in ("cylinderA", "cylinderB")] == ["50 mm", "50 mm"]
    editor.button("Undo").click()
    editor.wait()
    assert [part(editor, name)["bore"] for name in ("cylinderA", "cylinderB")] == ["32 mm", "40 mm"]


def test_the_form_without_a_selection(editor, start_editor):
    assert "Click parts in the palette" in editor.page.locator("#form").inner_text()
    bench = start_editor(BENCH, "bench.toml")
    bench.page.locator("#form").get_by_role("button", name="tank").click()
    assert bench.field("tank.volume").input_value() == "10 l"


def test_a_selected_wire_can_be_disconnected(bench):
    bench.page.evaluate("() => document.querySelector('[data-wire=\"hole.to\"]').focus()")
    bench.page.keyboard.press("Enter")
    bench.page.locator("#form").get_by_role("button", name="Disconnect").click()
    bench.wait()
    assert bench.text() == BENCH.replace('to = "tank"\n', "")


def test_the_kind_of_a_part_is_corrected(start_editor):
    editor = start_editor(BENCH.replace('"chamber"', '"chambre"'), "bench.toml")
    editor.select("tank")
    editor.type("tank.kind", "chamber")
    assert editor.text() == BENCH
    assert editor.field("tank.volume").input_value() == "10 l"


def test_a_unit_of_another_quantity_is_refused(start_editor):
    text = BENCH + '\n[parts.loop]\nkind = "pid"\nquantity = "position"\nsetpoint = "50 mm"\n'
    editor = start_editor(text, "bench.toml")
    editor.select("loop")
    editor.page.get_by_label("Unit of setpoint", exact=True).select_option("bar g")
    editor.wait()
    assert editor.text() == text
    assert "cannot be converted" in editor.page.locator("#form .bad:visible").first.inner_text()


def test_a_wrong_unit_does_not_stay(bench):
    bench.select("tank")
    unit = bench.page.get_by_label("Unit of volume", exact=True)
    bench.type("tank.volume", "5 bar")
    assert unit.input_value() == "l"
    bench.type("tank.volume", "")
    assert bench.field("tank.volume").get_attribute("placeholder") == "required"
    assert (unit.input_value(), unit.locator("option").all_inner_texts()) == ("l", ["l", "cm^3", "m^3"])
    bench.type("tank.volume", "3")
    assert part(bench, "tank")["volume"] == "3 l"


@pytest.mark.parametrize("kind", ["orifice", "spool_valve"])
def test_a_characteristic_is_entered_as_a_table(start_editor, kind):
    ports = 'from = "supply"\nto = "tank"' if kind == "orifice" else 'supply = "supply"\na = "tank"\nb = "other"'
    text = BENCH + (
        '\n[parts.other]\nkind = "chamber"\nvolume = "1 l"\n'
        '[parts.drain]\nkind = "orifice"\nfrom = "other"\nto = "ambient"\n'
        f'sonic_conductance = "1 dm^3/(s bar)"\ncritical_ratio = 0.3\n[parts.valve]\nkind = "{kind}"\n{ports}\n'
        'sonic_conductance = "1 dm^3/(s bar)"\ncritical_ratio = 0.3\n'
    )
    editor = start_editor(text, "bench.toml")
    editor.select("valve")
    editor.page.get_by_label("Size given as").select_option("characteristic")
    editor.wait()
    assert editor.page.locator("#problems li").count() == 0
    table = part(editor, "valve")["characteristic"]
    last = len(table["sonic_conductance"])
    cell = editor.page.get_by_label(f"sonic conductance, point {last}")
    cell.fill("3")
    cell.press("Enter")
    editor.wait()
    changed = part(editor, "valve")["characteristic"]
    assert changed == {**table, "sonic_conductance": [*table["sonic_conductance"][:-1], "3 dm^3/(s bar)"]}
    assert editor.page.locator("#form .curve-plot .handle").count() >= last
