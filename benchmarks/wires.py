"""Wires of the editor: routes in V8 (needs node), and pictures per second while a part is dragged (needs Chromium).

Random scenes have 60 parts and 80 wires, many of them across the whole drawing; a move is a part that moves by one grid
unit. The page contains 61 parts and 82 wires; a part is dragged by the mouse, one step per picture. `work` is the time
of the thread of the page per step. Playwright drives Chromium.
"""

from __future__ import annotations

import os
import shutil
import statistics
import sys
import tempfile
from importlib import import_module
from pathlib import Path
from typing import Any

from poppet.edit.document import Document
from poppet.edit.starting_values import starting_fields

ROUTES = """
import { route } from "./router.js";
const shifted = (place, d) => ({ ...place, x: place.x + d, y: place.y + (d >> 1) });
const moved = (scene, name, d) => ({
  ...scene,
  boxes: scene.boxes.map((box) => (box.name === name ? shifted(box, d) : box)),
  nets: scene.nets.map((net) => ({ ...net, ends: net.ends.map((end) => (
    end.name.split(".")[0] !== name ? end : { ...shifted(end, d), also: end.also.map((place) => shifted(place, d)) }
  )) })),
});
const { scenes, rounds } = DATA, full = [], moves = [], cpu = [];
for (const scene of scenes) {
  let last = null;
  for (let k = 0; k < rounds; k++) {
    const begin = performance.now();
    last = route(scene);
    if (k || rounds === 1) full.push(performance.now() - begin);
  }
  for (let k = 0; k < scene.boxes.length; k += 2) {
    for (let d = 1; d <= 6; d++) {
      const next = moved(scene, `p${k}`, d), begin = performance.now(), used = process.cpuUsage();
      last = route(next, last);
      moves.push(performance.now() - begin);
      cpu.push(process.cpuUsage(used).user / 1000);
    }
  }
}
console.log(JSON.stringify({ full, moves, cpu }));
"""
FRAMES = """
async ([name, count]) => {
  const part = document.querySelector(`[data-part="${name}"]`);
  const { left, top, width, height } = part.getBoundingClientRect();
  const x = left + width / 2, y = top + height / 2, svg = document.getElementById("drawing");
  const send = (type, dx, dy) => part.dispatchEvent(new PointerEvent(type, {
    bubbles: true, cancelable: true, pointerId: 1, pointerType: "mouse", button: type === "pointermove" ? -1 : 0,
    buttons: 1, clientX: x + dx, clientY: y + dy,
  }));
  svg.setPointerCapture = () => {};
  const picture = () => new Promise((done) => requestAnimationFrame(done));
  send("pointerdown", 0, 0);
  await picture();
  const work = [], begin = performance.now(), pictures = [begin];
  for (let k = 1; k <= count; k++) {
    const start = performance.now();
    send("pointermove", 60 * Math.sin(k / 9) , 40 * Math.sin(k / 13));
    part.getBoundingClientRect();
    work.push(performance.now() - start);
    pictures.push(await picture());
  }
  const took = performance.now() - begin;
  send("pointerup", 0, 0);
  const gaps = pictures.slice(2).map((time, k) => time - pictures[k + 1]);
  return { took, work, gaps };
}
"""


def plant() -> str:
    """Return a circuit of seven axes with valve, lines, flow controls, cylinder, mass and switch, and four bleeds."""
    operations: list[dict[str, Any]] = []
    links: list[dict[str, Any]] = []

    def add(name: str, kind: str, x: int, y: int, **ports: str) -> None:
        fields = {**ports, **starting_fields(kind)}
        operations.append({"op": "add", "kind": kind, "name": name, "place": {"x": x, "y": y}, "fields": fields})

    add("supply", "reservoir", 0, 60)
    for k in range(7):
        x, y = 20 + 90 * (k % 2), 34 * (k // 2)
        ports = {"supply": "supply", "a": f"line_a{k}", "b": f"line_b{k}"}
        add(f"valve{k}", "spool_valve", x, y + 4, **ports, exhaust_a="ambient", exhaust_b="ambient")
        for side, end, dy in (("a", "cap", -8), ("b", "rod", 12)):
            add(f"line_{side}{k}", "chamber", x + 20, y + dy + 2)
            ports = {"from": f"line_{side}{k}", "to": f"cylinder{k}.{end}"}
            add(f"control_{side}{k}", "flow_control_valve", x + 34, y + dy + 2, **ports)
        add(f"cylinder{k}", "cylinder", x + 52, y + 2, body=f"mass{k}")
        add(f"mass{k}", "mass", x + 70, y + 2)
        add(f"switch{k}", "switch", x + 70, y + 14, measurement=f"line_a{k}.pressure")
        links.append({"op": "link", "input": f"valve{k}.command", "output": f"switch{(k + 1) % 7}.state"})
    for k in range(4):
        add(f"bleed{k}", "orifice", 110 + 20 * k, 120, **{"from": f"line_a{k}", "to": f"line_b{k}"})
        links.append({"op": "link", "input": f"bleed{k}.opening", "output": f"switch{k}.state"})
    return Document('[run]\nduration = "1 s"\n').apply([*operations, *links]).text


def routes(size: float) -> None:
    scenes = import_module("wire_scenes")
    javascript = import_module("javascript")
    data = {
        "scenes": [scenes.random_scene(seed, parts=60, wires=80) for seed in range(max(1, round(8 * size)))],
        "rounds": max(1, round(5 * size)),
    }
    with tempfile.TemporaryDirectory() as folder:
        result = javascript.run_module(Path(folder), ROUTES, data=data)
    for name, key in (("all wires", "full"), ("one move", "moves"), ("its processor time", "cpu")):
        times = sorted(result[key])
        print(f"{name:18} {quantiles(times)} ms")


def quantiles(times: list[float]) -> str:
    """Return the median, the 90 % quantile and the largest of some times."""
    times = sorted(times)
    return f"{statistics.median(times):.1f} (90 % {times[round(0.9 * (len(times) - 1))]:.1f}, all {times[-1]:.1f})"


def frames(size: float) -> None:
    program = import_module("chromium").found()
    try:
        playwright = import_module("playwright.sync_api")
    except ImportError:
        playwright = None
    if program is None or playwright is None:
        print("no browser: no page was measured")
        return
    page_of = import_module("editor_page")
    with tempfile.TemporaryDirectory() as folder, playwright.sync_playwright() as driver:
        Path(folder, "work").mkdir()
        Path(folder, "work", "plant.toml").write_text(plant(), encoding="utf-8")
        server = page_of.Server(Path(folder, "work"), "plant.toml")
        browser = driver.chromium.launch(executable_path=program, args=list(page_of.FLAGS))
        try:
            editor = page_of.Editor(server, browser.new_page(viewport={"width": 1600, "height": 1000})).open()
            editor.page.wait_for_timeout(1000)
            wires = len(editor.names("data-wire"))
            devtools = editor.page.context.new_cdp_session(editor.page)
            devtools.send("Performance.enable", {"timeDomain": "threadTicks"})

            def worked() -> float:
                metrics = devtools.send("Performance.getMetrics")["metrics"]
                return next(float(metric["value"]) for metric in metrics if metric["name"] == "TaskDuration")

            for part in ("line_a2", "cylinder3", "valve4"):
                steps, before = max(10, round(240 * size)), worked()
                result = editor.page.evaluate(FRAMES, [part, steps])
                processor = 1e3 * (worked() - before) / steps
                rate, parts = 1e3 * steps / result["took"], len(editor.names())
                print(f"{part} of {parts} parts, {wires} wires: {rate:.1f} pictures a second")
                print(f"  step {quantiles(result['work'])} ms, between pictures {quantiles(result['gaps'])} ms")
                print(f"  processor time of the page {processor:.1f} ms per step, load {os.getloadavg()[0]:.1f}")
            if editor.problems:
                print(*editor.problems, sep="\n")
        finally:
            browser.close()
            server.stop()


def main(size: float = 1.0) -> None:
    if shutil.which("node") is None:
        print("nothing measured:\nnode is not installed")
        return
    sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
    routes(size)
    frames(size)


if __name__ == "__main__":
    main()
