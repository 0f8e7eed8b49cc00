"""The page of the editor around the drawing: runs, curves, errors, files, conflicts and layout."""

from __future__ import annotations

import math
import re

import pytest

from circuits_of_exports import EXAMPLES
from poppet.circuit.file import loads
from poppet.timeseries.plotting.tube_bands import band_outputs, cell_range

VENT = """\
title = "Vented tank"

[parts.tank]
kind = "chamber"
volume = "10 l"
initial_pressure = "5 bar g"

[parts.bleed]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = "2 dm^3/(s bar)"
critical_ratio = 0.3

[run]
duration = "4 s"
output_step = "10 ms"
"""
CONTRAST = 4.5
"""Smallest contrast of text and background, WCAG 2 level AA."""


def evaluate(editor, body, *values):
    """Return the value of an asynchronous function of the page, which has the state as `store`."""
    return editor.page.evaluate(f"async values => {{ const store = window.poppet.store; {body} }}", list(values))


def apply(editor, *operations):
    evaluate(editor, "await store.apply(values); await window.poppet.ready;", *operations)


def setting(address, value):
    return {"op": "set", "address": address, "value": value}


def pressure_of(circuit):
    """Return the pressure of the tank of a run of the library [Pa]."""
    recording = loads(circuit).simulate()
    return recording.interpolate("tank.pressure", recording.time)


@pytest.fixture
def vent(start_editor):
    return start_editor(VENT)


# --- Runs ---


def test_errors_of_the_table_modbus_do_not_stop_the_run(start_editor):
    text = VENT + '\n[modbus.registers]\n"tank.presure" = { input = 0 }\n'
    editor = start_editor(text)
    button = editor.page.locator('#problems [data-address="modbus.registers.tank.presure"]')
    assert "tank.pressure" in button.inner_text()
    assert editor.page.locator("#problems h2").inner_text().startswith("Errors of the table modbus")
    apply(editor, setting("tank.volume", "20 l"))
    assert editor.recording()["tank.pressure"][-1] == pytest.approx(pressure_of(VENT.replace("10 l", "20 l"))[-1])
    assert not editor.page.locator('[data-task="report"]').is_disabled()
    assert button.is_visible()
    button.click()
    line = text.splitlines().index('"tank.presure" = { input = 0 }') + 1
    assert editor.page.locator(".editor b.mark").inner_text() == str(line)
    apply(editor, setting("run.duration", "x"))
    assert editor.page.locator("#problems h2").inner_text() == "One error keeps the circuit from running"


def test_the_run_is_that_of_the_library(vent):
    recording = vent.recording()
    assert recording["time"] == pytest.approx(list(loads(VENT).simulate().time))
    assert recording["tank.pressure"] == pytest.approx(list(pressure_of(VENT)), rel=1e-6)


def test_ready_is_replaced_by_each_edit(vent):
    body = """
      const before = window.poppet.ready;
      store.apply(values);
      const after = window.poppet.ready;
      const isOther = before !== after;
      await after;
      return [isOther, store.recording()["tank.pressure"].at(-1)];
    """
    is_other, last = evaluate(vent, body, setting("bleed.sonic_conductance", "0.2 dm^3/(s bar)"))
    expected = pressure_of(VENT.replace("2 dm^3", "0.2 dm^3"))[-1]
    assert is_other
    assert last == pytest.approx(expected, rel=1e-6)


def test_a_dragged_number_is_simulated_without_the_text(vent):
    body = """
      const text = store.text(), numbers = [];
      for (const value of values) numbers.push(store.number("tank.volume", value));
      await window.poppet.ready;
      return [numbers, store.text() === text, store.recording()["tank.pressure"].at(-1), store.run.isShort];
    """
    volumes = [0.010 + 0.001 * k for k in range(11)]
    is_known, is_same, last, is_short = evaluate(vent, body, *volumes)
    expected = pressure_of(VENT.replace("10 l", "20 l"))[-1]
    assert is_known == [True] * len(volumes)
    assert is_same
    assert not is_short
    assert last == pytest.approx(expected, rel=1e-6)


def test_notes_on_the_results_follow_the_run(start_editor):
    """They come from the server; without an answer, the notes that need no run remain."""
    editor = start_editor((EXAMPLES / "cylinder_cushioned.toml").read_text(encoding="utf-8"))
    notes = editor.page.locator("#curves details li")
    notes.filter(has_text="hit its end stops").wait_for(state="attached")
    assert notes.filter(has_text="valve.critical_ratio = 0.3 is assumed").count() == 1
    editor.page.route("**/notes?*", lambda route: route.fulfill(status=204))
    with editor.page.expect_request("**/notes?*"):
        apply(editor, setting("slide.mass", "11 kg"))
    assert notes.filter(has_text="is assumed").count() == 1
    assert notes.filter(has_text="hit its end stops").count() == 0


def test_no_notes_are_asked_for_while_a_number_is_dragged(vent):
    body = """
      const asked = [], send = window.fetch;
      window.fetch = (path, options) => { asked.push(path); return send(path, options); };
      store.number("tank.volume", 0.02);
      await window.poppet.ready;
      await new Promise(resolve => setTimeout(resolve, 1000));
      const dragged = asked.filter(path => path.startsWith("/notes")).length;
      await store.apply([{ op: "set", address: "tank.volume", value: "20 l" }]);
      await new Promise(resolve => store.addEventListener("notes", resolve, { once: true }));
      window.fetch = send;
      return [dragged, asked.filter(path => path.startsWith("/notes")).length];
    """
    assert evaluate(vent, body) == [0, 1]


def test_the_worker_has_one_run_at_most(vent):
    """Values that arrive during a run are merged: the last one wins."""
    body = """
      let started = 0, sent = 0;
      const post = Worker.prototype.postMessage;
      Worker.prototype.postMessage = function (message, ...others) {
        started++;
        sent = message.numbers[0][1];
        post.call(this, message, ...others);
      };
      for (const value of values) store.number("tank.volume", value);
      await window.poppet.ready;
      Worker.prototype.postMessage = post;
      return [started, sent];
    """
    started, sent = evaluate(vent, body, *[0.01 + 0.0001 * k for k in range(50)])
    assert started == 2
    assert sent == pytest.approx(0.0149)


def test_a_long_run_is_short_while_a_number_is_dragged(start_editor):
    editor = start_editor(VENT)
    body = """
      store.simulation.seconds = 2;  // as if the run took 2 s
      store.number("tank.volume", 0.02);
      await new Promise(resolve => store.addEventListener("run", resolve, { once: true }));
      const first = [store.run.isShort, store.run.time.at(-1)];
      await window.poppet.ready;
      return [first, [store.run.isShort, store.run.time.at(-1)]];
    """
    (is_first_short, reached), (is_short, end) = evaluate(editor, body)
    assert is_first_short
    assert reached < 1.0
    assert not is_short
    assert end == pytest.approx(4.0)


def test_the_range_of_a_slider_is_constant_during_a_drag(start_editor):
    """Each value of a number that the server computes changes the text; the range follows after the drag."""
    size = 'sonic_conductance = "2 dm^3/(s bar)"\ncritical_ratio = 0.3\n'
    editor = start_editor(VENT.replace(size, 'nominal_flow = "400 l/min ANR"\n'))
    editor.select("bleed")
    slider = editor.page.locator('[data-slider="bleed.nominal_flow"]')
    x, y = editor.centre(slider)
    editor.page.mouse.move(x, y)
    editor.page.mouse.down()
    for k in range(1, 31):
        editor.page.mouse.move(x + 2 * k, y)
        editor.wait()
    editor.page.mouse.up()
    editor.wait()
    flow = evaluate(editor, "return parseFloat(store.state.view.parts.bleed.fields.nominal_flow);")
    assert 400.0 < flow < 1200.0


def test_a_moved_part_is_not_simulated_again(vent):
    body = """
      const { run } = store;
      await store.apply([{ op: "place", part: "tank", x: 20, y: 30 }]);
      await window.poppet.ready;
      return store.run === run && !store.isStale;
    """
    assert evaluate(vent, body)


def test_a_worker_that_fails_is_replaced(vent):
    body = """
      const post = Worker.prototype.postMessage;
      Worker.prototype.postMessage = function () {
        Worker.prototype.postMessage = post;
        this.dispatchEvent(new ErrorEvent("error", { message: "out of memory", cancelable: true }));
      };
      store.number("tank.volume", 0.02);
      await window.poppet.ready;
      return [store.errors.length, store.isStale, store.recording()["tank.pressure"].at(-1)];
    """
    errors, is_stale, last = evaluate(vent, body)
    expected = pressure_of(VENT.replace("10 l", "20 l"))[-1]
    assert (errors, is_stale) == (0, False)
    assert last == pytest.approx(expected, rel=1e-6)


def test_a_worker_that_always_fails_is_reported(vent):
    body = """
      const post = Worker.prototype.postMessage;
      Worker.prototype.postMessage = function () {
        this.dispatchEvent(new ErrorEvent("error", { message: "out of memory", cancelable: true }));
      };
      store.number("tank.volume", 0.02);
      await window.poppet.ready;
      Worker.prototype.postMessage = post;
      const codes = store.errors.map(error => error.code);
      await store.apply(values);
      await window.poppet.ready;
      return [codes, store.errors.length, store.isStale];
    """
    codes, errors, is_stale = evaluate(vent, body, setting("tank.volume", "30 l"))
    assert codes == ["page.crashed"]
    assert (errors, is_stale) == (0, False)


def test_a_worker_that_hangs_is_ended(vent):
    body = """
      const post = Worker.prototype.postMessage;
      Worker.prototype.postMessage = () => {};
      store.simulation.limit = 0.2;
      store.number("tank.volume", 0.02);
      await window.poppet.ready;
      Worker.prototype.postMessage = post;
      store.simulation.limit = 20;
      const codes = store.errors.map(error => error.code);
      await store.apply(values);
      await window.poppet.ready;
      return [codes, store.errors.length, store.recording()["tank.pressure"].at(-1)];
    """
    codes, errors, last = evaluate(vent, body, setting("tank.volume", "30 l"))
    assert (codes, errors) == (["page.hangs"], 0)
    assert last == pytest.approx(pressure_of(VENT.replace("10 l", "30 l"))[-1], rel=1e-6)


def test_a_refused_number_returns_to_that_of_the_text(vent):
    body = """
      store.number("tank.volume", 0.02);
      const state = await store.apply([...values, { op: "set", address: "none.volume", value: 1 }]);
      await window.poppet.ready;
      return [state, store.isStale, store.recording()["tank.pressure"].at(-1)];
    """
    state, is_stale, last = evaluate(vent, body, setting("tank.volume", "20 l"))
    assert (state, is_stale) == (None, False)
    assert last == pytest.approx(pressure_of(VENT)[-1], rel=1e-6)


def test_a_model_that_does_not_arrive_is_asked_for_again(vent):
    body = """
      const real = window.fetch;
      window.fetch = (path, ...others) => {
        if (path.startsWith("/model")) return Promise.reject(new TypeError("lost"));
        return real(path, ...others);
      };
      await store.apply(values);
      await window.poppet.ready;
      const lost = [store.connection, store.isStale];
      window.fetch = real;
      const found = new Promise(resolve => store.addEventListener("run", resolve, { once: true }));
      await store.retry();
      await found;
      return [lost, [store.connection, store.isStale], store.recording()["tank.pressure"].at(-1)];
    """
    lost, found, last = evaluate(vent, body, setting("tank.volume", "20 l"))
    assert lost == ["lost", True]
    assert found == ["ok", False]
    assert last == pytest.approx(pressure_of(VENT.replace("10 l", "20 l"))[-1], rel=1e-6)


def test_a_typed_text_keeps_changes_elsewhere(vent):
    """A change that is under way, and one of another page, remain when the text is applied."""
    body = """
      const area = document.querySelector("#text textarea");
      area.value = area.value.replace("4 s", "3 s");
      store.apply(values);
      area.dispatchEvent(new Event("change"));
      await window.poppet.ready;
      const { revision } = store.state;
      const body = JSON.stringify({ revision, operations: [{ op: "place", part: "tank", x: 7, y: 9 }] });
      await fetch("/apply", { method: "POST", headers: { "Content-Type": "application/json" }, body });
      area.value = area.value.replace("3 s", "2 s");
      area.dispatchEvent(new Event("change"));
      await window.poppet.ready;
      return [store.text(), area.value];
    """
    text, shown = evaluate(vent, body, setting("tank.volume", "20 l"))
    assert text == shown
    assert all(piece in text for piece in ("20 l", '"2 s"', "x = 7"))


RANDOM = """
  const [seed, kinds] = values;
  let state = seed;
  const random = () => (state = (state * 16807) % 2147483647) / 2147483647;
  const pick = list => list[Math.floor(random() * list.length)];
  const volume = () => `${5 + Math.floor(20 * random())} l`;
  const part = () => pick(Object.keys(store.state.view.parts));
  const set = options => store.apply([{ op: "set", address: "tank.volume", value: volume() }], options);
  const actions = [
    () => store.number("tank.volume", 0.005 + 0.02 * random()),
    () => set({}),
    () => { for (let k = 0; k < 10; k++) set({ continues: true }); },
    () => store.apply([{ op: "add", kind: pick(kinds) }]),
    () => store.apply([{ op: "place", part: part(), x: Math.round(40 * random()), y: Math.round(30 * random()) }]),
    () => store.apply([{ op: "remove", parts: [part()] }]),
    () => store.undo(),
    () => store.redo(),
    () => store.replaceText(`${store.text()}# note\\n`),
    () => new Promise(resolve => setTimeout(resolve, 50 * random())),
  ];
  const text = store.text();
  for (let k = 0; k < 80; k++) {
    const waited = pick(actions)();
    if (random() < 0.2) await waited;
    if (random() < 0.3) await window.poppet.ready;
  }
  store.number("tank.volume", 0.03);
  store.replaceText(text);
  await window.poppet.ready;
  return [store.isStale, store.errors.length, store.text() === text, store.recording()["tank.pressure"].at(-1)];
"""


@pytest.mark.parametrize("seed", [7, 11, 23])
def test_random_edits_end_in_the_run_of_the_text(vent, seed):
    """Edits that do not wait for each other: each is simulated or refused, and the last text has its own run."""
    is_stale, errors, is_same, last = evaluate(vent, RANDOM, seed, ["orifice", "chamber", "mass"])
    assert (is_stale, errors, is_same) == (False, 0, True)
    assert last == pytest.approx(pressure_of(VENT)[-1], rel=1e-6)


# --- Errors ---


def test_errors_are_listed_and_the_curves_stay_greyed(vent):
    last = vent.recording()["tank.pressure"][-1]
    apply(vent, {"op": "disconnect", "port": "bleed.to"})
    problems = vent.page.locator("#problems")
    item = problems.locator('[data-address="parts.bleed.to"]')
    assert "parts.bleed.to" in item.text_content()
    vent.page.locator(".plots.is-stale").wait_for()
    assert vent.recording()["tank.pressure"][-1] == last
    evaluate(vent, "store.select([]);")
    item.click()
    assert evaluate(vent, "return [...store.selection];") == ["bleed"]
    assert vent.page.evaluate("() => document.activeElement.name") == "bleed.to"
    vent.press("Escape", "Control+z")
    assert problems.is_hidden()
    vent.page.locator(".plots:not(.is-stale)").wait_for()


def test_a_text_that_is_not_toml_keeps_the_drawing(vent):
    evaluate(vent, "await store.replaceText(values[0]); await window.poppet.ready;", VENT.replace("volume =", "volume"))
    assert evaluate(vent, "return [Object.keys(store.state.view.parts), store.isStale];") == [["tank", "bleed"], True]
    vent.page.locator("#problems button").click()
    area = vent.page.locator("#text textarea")
    assert area.is_visible()
    assert area.evaluate("area => area.value.slice(0, area.selectionStart).split('\\n').length") == 5
    evaluate(vent, "await store.undo(); await window.poppet.ready;")
    assert vent.text() == VENT
    assert not evaluate(vent, "return store.isStale;")


def test_a_refused_operation_is_announced(vent):
    apply(vent, {"op": "rename", "part": "tank", "name": "bleed"})
    vent.page.locator("#announce", has_text="bleed").wait_for()
    assert vent.text() == VENT


# --- Curves ---


def test_curves_of_the_selected_part_come_first(vent):
    first = vent.page.locator("#curves .plot:first-child")
    first.filter(has_text="tank.pressure").wait_for()
    vent.select("bleed")
    first.filter(has_text="bleed.mass_flow").wait_for()


def test_noise_is_no_curve(start_editor):
    """A mass at rest in a closed cylinder moves by rounding errors only."""
    drive = """
[parts.cylinder]
kind = "cylinder"
bore = "32 mm"
stroke_length = "100 mm"
cap.dead_volume = "5 cm^3"
rod.dead_volume = "5 cm^3"
body = "mass"

[parts.mass]
kind = "mass"
mass = "5 kg"

[parts.plug]
kind = "orifice"
from = "cylinder.cap"
to = "cylinder.rod"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3

[run]"""
    editor = start_editor(VENT.replace("[run]", drive))
    editor.page.locator("#curves .plot", has_text="tank.pressure").wait_for()
    assert editor.page.locator("#curves .plot", has_text="mass.").count() == 0


def test_curves_by_the_checklist(vent):
    vent.page.locator(".choice summary").click()
    box = vent.page.locator(".choice fieldset", has_text="tank").get_by_label("temperature", exact=True)
    box.check()
    plot = vent.page.locator("#curves .plot", has_text="tank.temperature")
    plot.wait_for()
    box.uncheck()
    plot.wait_for(state="detached")


def test_values_as_a_table_and_announced(vent):
    vent.page.locator("#announce", has_text="tank.pressure ends at").wait_for()
    vent.page.get_by_text("Table of values").click()
    vent.page.locator(".below table").wait_for()
    cells = vent.page.locator(".below table tbody tr").last.locator("td").all_text_contents()
    assert float(cells[0]) == 4.0
    assert float(cells[1]) == pytest.approx(pressure_of(VENT)[-1] / 1e5, rel=1e-3)


def test_the_time_cursor_plays(vent):
    vent.page.get_by_role("button", name="Play").click()
    vent.page.wait_for_function("() => window.poppet.store.cursor > 0.1")
    vent.page.get_by_role("button", name="Pause").click()
    slider = vent.page.get_by_role("slider", name="time shown in the drawing")
    slider.press("End")
    assert evaluate(vent, "return store.cursor;") == pytest.approx(4.0)


def test_the_legend_has_the_values_of_its_curves(vent):
    """The values at the time cursor follow each run, also if the axes stay as they are."""
    body = """
      store.setCursor(2);
      await store.apply(values);
      await window.poppet.ready;
      await new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      const keys = [...document.querySelectorAll("#curves .key")];
      const key = keys.find(item => item.textContent.startsWith("tank.pressure"));
      return parseFloat(key.querySelector("output").textContent);
    """
    for volume in ("10.1 l", "11 l", "30 l"):
        curve = pressure_of(VENT.replace("10 l", volume))
        assert evaluate(vent, body, setting("tank.volume", volume)) == pytest.approx(curve[200] / 1e5, rel=0.01)
    apply(vent, {"op": "remove", "parts": ["tank", "bleed"]})
    vent.page.locator(".clock button:disabled").wait_for()


def test_two_variants(vent):
    vent.page.get_by_role("button", name="Keep as A").click()
    apply(vent, setting("tank.volume", "20 l"))
    vent.page.locator("#curves .key.is-kept", has_text="A: tank.pressure").wait_for()
    vent.page.get_by_text("Differences from A").click()
    assert vent.page.locator(".below li").first.text_content() == "tank.volume: 10 l in A, now 20 l"
    vent.page.get_by_role("button", name="Back to A").click()
    vent.page.get_by_role("button", name="Forget A").click()
    vent.wait()
    assert vent.text() == VENT
    vent.page.locator("#curves .key.is-kept").wait_for(state="detached")


TUBE = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"

[parts.hose]
kind = "tube"
from = "supply"
to = "tank"
length = "4 m"
bore = "4 mm"
cells = 3

[parts.tank]
kind = "chamber"
volume = "0.2 l"

[run]
duration = "0.5 s"
output_step = "5 ms"
"""


def legend(editor):
    return evaluate(editor, "return [...document.querySelectorAll('#curves .key')].map(key => key.childNodes[1].data);")


@pytest.mark.parametrize(("width", "scheme"), [(1280, "light"), (360, "dark")])
def test_the_cells_of_a_tube_are_one_band(start_editor, width, scheme):
    editor = start_editor(TUBE, width=width, scheme=scheme)
    band = "hose.pressure, cells 1 to 3"
    editor.page.locator("#curves .key.is-band").first.wait_for(state="attached")
    assert legend(editor) == [band, "tank.pressure"]
    shown, cells = evaluate(
        editor,
        """store.setCursor(0.1);
        await new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve)));
        const row = store.run.time.findIndex(time => time > 0.0999);
        const cells = [1, 2, 3].map(k => store.run.series.get(`hose.${k}.pressure`)[row] / 1e5);
        return [document.querySelector("#curves .is-band output").textContent, cells];""",
    )
    assert [float(text) for text in shown.split(" to ")] == pytest.approx([min(cells), max(cells)], abs=0.01)
    editor.page.locator("#announce", has_text="Simulated. tank.pressure ends at").wait_for(state="attached")


def test_a_band_is_kept_and_its_cells_are_selected(start_editor):
    editor = start_editor(TUBE)
    band = "hose.pressure, cells 1 to 3"
    editor.page.get_by_role("button", name="Keep as A").click()
    apply(editor, setting("hose.bore", "2 mm"))
    editor.page.locator("#curves .key.is-kept", has_text=f"A: {band}").wait_for()
    editor.page.locator(".choice summary").click()
    boxes = editor.page.locator(".choice fieldset", has_text="hose")
    names = {f"hose.{label}" for label in boxes.locator("label", has_text=", cells").all_text_contents()}
    bands = band_outputs(loads(TUBE).simulate().names)
    assert names == {f"{name}, {cell_range(outputs)}" for name, outputs in bands.items()}
    assert boxes.get_by_label("pressure, cells 1 to 3", exact=True).is_checked()
    boxes.get_by_label("2.pressure", exact=True).check()
    editor.page.locator("#curves .key", has_text="hose.2.pressure").first.wait_for()
    assert legend(editor)[:2] == [band, f"A: {band}"]
    boxes.get_by_label("pressure, cells 1 to 3", exact=True).uncheck()
    editor.page.locator("#curves .key.is-band").first.wait_for(state="detached")
    assert "hose.2.pressure" in legend(editor)


def test_measured_values_beside_the_curves(start_editor):
    high = f'{VENT}\n[ambient]\npressure = "0.9 bar"\n'
    vent = start_editor(high)
    pairs = zip(loads(high).simulate().time, pressure_of(high), strict=True)
    rows = "\n".join(f"{1e3 * t};{p / 1e5 - 0.9 - 0.5}".replace(".", ",") for t, p in pairs)
    content = f"t [ms];gauge [bar g]\n{rows}\n"
    file = {"name": "run.csv", "mimeType": "text/csv", "buffer": content.encode()}
    vent.page.locator('#curves input[type="file"]').set_input_files(file)
    row = vent.page.locator(".measured p")
    row.get_by_label("gauge corresponds to").select_option("tank.pressure")
    vent.page.locator("#curves .key.is-measured", has_text="gauge").wait_for()
    # The gauge reads 0.5 bar too little.
    vent.page.locator(".measured output", has_text=re.compile(r"RMS deviation 0\.50+ bar")).wait_for()
    row.get_by_label("Unit of gauge").select_option("bar")
    vent.page.locator(".measured output", has_text=re.compile(r"RMS deviation 1\.40+ bar")).wait_for()
    vent.page.get_by_role("button", name="Remove gauge").click()
    row.wait_for(state="detached")


def test_a_dropped_file(vent):
    """A file that is dropped anywhere is read, and the browser does not open it instead of the page."""
    content = "time [s],tank.pressure [bar]\n0,6\n1,5\n2,4\n"
    body = """
      const data = new DataTransfer();
      data.items.add(new File([values[0]], "run.csv", { type: "text/csv" }));
      const event = name => new DragEvent(name, { dataTransfer: data, bubbles: true, cancelable: true });
      const drawing = document.getElementById("drawing");
      return ["dragover", "drop"].map(name => drawing.dispatchEvent(event(name)));
    """
    assert evaluate(vent, body, content) == [False, False]
    vent.page.locator("#curves .key.is-measured", has_text="tank.pressure").wait_for()


def test_files_that_are_no_recordings(vent):
    """Each file gets a message with its reason, and nothing is drawn."""
    for content, reason in (
        (b"\x00\x01\x02\nrandom\nbytes\n", "not a text file"),
        (b"t [s],p [bar]\n0,1\n", "fewer than two rows"),
        (b"t [s],p [bar]\n0,1\n2,2\n1,3\n", "the time decreases"),
        (b"t [s],p [bar]\n0,1\nx,2\n1,3\n", "not a number"),
    ):
        file = {"name": "run.csv", "mimeType": "text/csv", "buffer": content}
        vent.page.locator('#curves input[type="file"]').set_input_files(file)
        vent.page.locator("#announce", has_text=reason).wait_for()
    assert vent.page.locator(".measured p").count() == 0
    unknown = {"name": "run.csv", "mimeType": "text/csv", "buffer": b"t,p [furlong]\n0,1\n1,2\n"}
    vent.page.locator('#curves input[type="file"]').set_input_files(unknown)
    vent.page.locator(".measured .why", has_text="furlong").wait_for()
    vent.page.locator("#announce", has_text="read in seconds").wait_for()


def test_a_stop_condition_ends_the_run(start_editor):
    editor = start_editor(VENT + 'stop_when = "tank.pressure < 4 bar"\n')
    editor.page.locator("#curves .status", has_text="tank.pressure < 4 bar").wait_for()
    assert editor.recording()["time"][-1] < 4.0


# --- Files ---


def test_save_and_title(vent):
    apply(vent, setting("tank.volume", "20 l"))
    assert vent.page.title().startswith("* plant.toml")
    is_held = "() => !dispatchEvent(new Event('beforeunload', { cancelable: true }))"
    assert vent.page.evaluate(is_held)
    vent.save()
    assert (vent.folder / "plant.toml").read_text() == vent.text() == VENT.replace("10 l", "20 l")
    assert vent.page.title().startswith("plant.toml")
    assert not vent.page.evaluate(is_held)


def test_save_under_another_name(vent):
    vent.page.locator("#file-menu summary").click()
    vent.page.locator("#save-as").click()
    vent.page.get_by_label("File name").fill("copy")
    vent.page.locator("dialog").get_by_role("button", name="Save").click()
    vent.page.locator("#name", has_text="copy.toml").wait_for()
    assert (vent.folder / "copy.toml").read_text() == VENT


def test_a_template_of_the_start_page(editor):
    start = editor.page.locator("#start")
    start.wait_for()
    start.locator("section").first.get_by_role("button").first.click()
    editor.page.wait_for_function("() => Object.keys(window.poppet.store.state.view.parts).length > 0")
    editor.wait()
    assert start.is_hidden()
    assert len(editor.recording()["time"]) > 1


def test_another_file_asks_for_unsaved_changes(start_editor):
    editor = start_editor(VENT, files={"other.toml": VENT.replace("Vented", "Other")})
    apply(editor, setting("tank.volume", "20 l"))
    for answer, title in (("Cancel", "Vented tank"), ("Open without them", "Other tank")):
        editor.page.locator("#file-menu summary").click()
        editor.page.locator("#open").click()
        editor.page.locator("#start").get_by_role("button", name="other.toml").click()
        editor.page.get_by_role("button", name=answer).click()
        editor.page.wait_for_function("title => window.poppet.store.state.view.title === title", arg=title)
    editor.wait()
    assert editor.text() == VENT.replace("Vented", "Other")


# --- Conflicts ---


def test_two_pages_of_one_circuit(vent):
    other = vent.page.context.new_page()
    other.goto(vent.page.url)
    other.wait_for_function("() => window.poppet?.store.state")
    apply(vent, setting("tank.volume", "20 l"))
    body = "async values => { await poppet.store.apply(values); await poppet.ready; return poppet.text(); }"
    merged = other.evaluate(body, [setting("bleed.critical_ratio", 0.4)])
    assert merged == VENT.replace("10 l", "20 l").replace("0.3", "0.4")
    # An operation that does not apply any more changes nothing.
    apply(vent, {"op": "remove", "parts": ["bleed"]})
    text = vent.text()
    assert text != merged
    vent.page.wait_for_function("text => window.poppet.text() === text", arg=text)
    assert other.evaluate(body, [setting("bleed.critical_ratio", 0.2)]) == vent.text()
    other.close()


def test_the_file_changes_on_disk(vent):
    banner = vent.page.locator(".banner")
    path = vent.folder / "plant.toml"
    path.write_text(VENT.replace("10 l", "30 l"))
    banner.wait_for()
    vent.page.get_by_role("button", name="Load the file").click()
    vent.page.wait_for_function("() => window.poppet.text().includes('30 l')")
    vent.wait()
    path.write_text(VENT.replace("10 l", "40 l"))
    vent.page.get_by_role("button", name="Keep my text").click()
    apply(vent, setting("tank.volume", "50 l"))
    vent.button("Save").click()
    vent.page.get_by_role("button", name="Replace the file").click()
    vent.page.locator("#announce", has_text="is saved").wait_for()
    assert path.read_text() == VENT.replace("10 l", "50 l")


def test_without_the_server_nothing_is_lost(vent):
    apply(vent, setting("tank.volume", "20 l"))
    vent.server.stop()
    body = "const state = await store.apply(values); await window.poppet.ready; return [state, store.text()];"
    state, text = evaluate(vent, body, setting("tank.volume", "30 l"))
    assert (state, text) == (None, VENT.replace("10 l", "20 l"))
    assert "does not answer" in vent.page.locator(".banner").text_content()
    assert vent.page.get_by_role("button", name="Copy the text").is_visible()
    # The browser reports each request that had no answer.
    vent.problems[:] = [problem for problem in vent.problems if "ERR_CONNECTION_REFUSED" not in problem]


def test_the_session_is_over(vent):
    vent.page.context.clear_cookies()
    assert evaluate(vent, "const state = await store.apply(values); await window.poppet.ready; return state;") is None
    assert "no longer connected" in vent.page.locator(".banner").text_content()
    assert vent.text() == VENT
    vent.problems[:] = [problem for problem in vent.problems if "403" not in problem]


# --- Keys and layout ---


def test_keys_of_the_page(vent):
    apply(vent, setting("tank.volume", "20 l"))
    vent.page.locator("#drawing").focus()
    vent.press("Control+z")
    assert vent.text() == VENT
    vent.press("Control+y")
    assert vent.text() != VENT
    vent.press("Control+z", "Control+Shift+Z", "?")
    dialog = vent.page.get_by_role("dialog", name="Help")
    dialog.wait_for()
    vent.press("Escape")
    dialog.wait_for(state="detached")
    assert vent.text() != VENT
    vent.press("/")
    assert vent.page.evaluate("() => document.activeElement.closest('#palette') !== null")


def test_tabs_of_a_narrow_page(start_editor):
    editor = start_editor(VENT, width=360, height=740)
    for tab, panel in (("Parts", "#palette"), ("Curves", "#curves"), ("Details", "#side"), ("Drawing", "#drawing")):
        editor.page.get_by_role("tab", name=tab).click()
        assert editor.page.locator(panel).is_visible()
        assert editor.page.evaluate("() => document.documentElement.scrollWidth <= innerWidth"), tab
    editor.page.get_by_role("tab", name="Parts").click()
    editor.add("orifice")
    assert editor.page.locator("#drawing").is_visible()


def test_all_palette_buttons_are_visible(editor):
    sizes = editor.page.eval_on_selector_all(
        "[data-kind]", "all => all.map(e => e.getBoundingClientRect()).map(r => [r.left, r.top, r.right, r.bottom])"
    )
    assert len(sizes) >= 38
    for left, top, right, bottom in sizes:
        assert 0 <= left < right <= 1280
        assert 0 <= top < bottom <= 900


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_contrast_of_the_colours(start_editor, scheme):
    editor = start_editor(scheme=scheme)
    body = """
      const context = new OffscreenCanvas(1, 1).getContext("2d"), style = getComputedStyle(document.documentElement);
      return values.map(name => {
        context.fillStyle = style.getPropertyValue(name).trim();
        context.fillRect(0, 0, 1, 1);
        return Array.from(context.getImageData(0, 0, 1, 1).data.slice(0, 3));
      });
    """
    texts = ["--ink", "--soft", "--accent", "--bad", *(f"--curve-{k + 1}" for k in range(8))]
    pairs = [(name, "--paper") for name in texts]
    pairs += [("--ink", "--wash"), ("--soft", "--wash"), ("--ink", "--bad-wash"), ("--ink", "--warn-wash")]
    pairs += [("--on-accent", "--accent")]
    names = sorted({name for pair in pairs for name in pair})
    colours = dict(zip(names, evaluate(editor, body, *names), strict=True))
    for pair in pairs:
        light, dark = sorted((luminance(colours[name]) for name in pair), reverse=True)
        least = 3.0 if "--curve" in pair[0] else CONTRAST
        assert (light + 0.05) / (dark + 0.05) >= least, pair


def luminance(colour):
    """Return the relative luminance of WCAG 2."""
    linear = [c / 12.92 if c <= 0.04045 else math.pow((c + 0.055) / 1.055, 2.4) for c in (v / 255 for v in colour)]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def test_the_page_is_small(vent):
    """The transfer of the page, its model included, is at most 600 kB."""
    body = "return performance.getEntriesByType('resource').map(entry => [entry.name, entry.transferSize]);"
    sizes = evaluate(vent, body)
    document = vent.page.evaluate("() => performance.getEntriesByType('navigation')[0].transferSize")
    assert document + sum(size for _, size in sizes) < 600_000, sizes


def test_buttons_have_unique_names(vent):
    """A program finds the buttons of the toolbar by a part of their names."""
    vent.select("bleed")
    for name in ("Save", "Undo", "Redo", "Delete", "Rotate"):
        assert vent.page.get_by_role("button", name=name).count() == 1, name
