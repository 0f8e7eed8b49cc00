"""From the text of a circuit to the model of the editor's page, beside the module of a live page, and to its first run.

Each round does both for a new structure, so a busy machine slows both; printed are medians. A known structure needs no
code: only its arrays are made. Where node is found, the page's script loads the model and runs it twice. Where Chromium
and Playwright are found, the page itself is measured: from a new wire, and from a number, to the painted curve.
"""

from __future__ import annotations

import json
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from importlib import import_module
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from poppet.circuit import circuit
from poppet.circuit.file import loads
from poppet.deploy.live.page_kernel import live_module
from poppet.edit import build
from poppet.edit.build import build_payload

EXAMPLES = Path(__file__).parents[1] / "examples"
FILES = {"7 parts": "fill_staircase", "cylinder": "cylinder_meter_out", "sampled": "pressure_regulator"}
TARGETS = {"7 parts": 250, "cylinder": 250, "sampled": 500, "40 parts": 700}
"""Longest time from a new wire to the curve on two quiet cores [ms]."""
NUMBERS = {
    "7 parts": ("tank.volume", "tank"),
    "cylinder": ("supply.pressure", "cylinder.cap"),
    "sampled": ("tank.volume", "tank"),
    "40 parts": ("c3.volume", "c9"),
}
"""Number that changes in the page, and gas node to which an orifice is joined."""
PROGRAM = """
import fs from "node:fs";
import { PageModel } from "./model.js";
const integrator = await WebAssembly.compile(fs.readFileSync("integrator.wasm")), times = [];
const payload = fs.readFileSync("payload");
const begin = performance.now();
const model = await PageModel.load(payload, integrator);
for (let k = 0; k < 3; k++) {
  if (k === 1) times.push(performance.now() - begin);
  const before = performance.now();
  model.run();
  if (k === 2) times.push(performance.now() - before);
}
console.log(JSON.stringify(times));
"""
PAGE = """async ({ count, address, store: node }) => {
  const { store } = window.poppet;
  const painted = () => new Promise(done => requestAnimationFrame(() => {
    const { port1, port2 } = new MessageChannel();  // its message comes after the frame
    port1.onmessage = done;
    port2.postMessage(null);
  }));
  const apply = async (...operations) => {
    const state = await store.apply(operations);
    await window.poppet.ready;
    return state;
  };
  const wires = [], numbers = [];
  for (let k = 0; k < count; k++) {
    const fields = { sonic_conductance: "0.1 dm^3/(s bar)", critical_ratio: 0.3 };
    const { created: [name] } = await apply({ op: "add", kind: "orifice", place: { x: 20 * k, y: -30 }, fields });
    await apply({ op: "connect", port: `${name}.from`, to: "ambient" });
    const begin = performance.now();
    await apply({ op: "connect", port: `${name}.to`, to: node });
    await painted();
    wires.push(performance.now() - begin);
  }
  for (let k = 0; k < 10 * count; k++) {
    const begin = performance.now();
    const run = new Promise(done => store.addEventListener("run", done, { once: true }));
    const { value } = store.header.numbers[address];
    store.number(address, value * (1 + 0.2 * Math.random()));
    await run;
    await painted();
    numbers.push(performance.now() - begin);
  }
  return [wires, numbers];
}"""


def chain(length: int) -> str:
    """Return the text of a supply and `length` chambers in a row."""
    parts = ['[parts.supply]\nkind = "reservoir"\npressure = "7 bar"']
    for k in range(length):
        before = f"c{k - 1}" if k else "supply"
        parts.append(f'[parts.o{k}]\nkind = "orifice"\nfrom = "{before}"\nto = "c{k}"')
        parts.append(f"sonic_conductance = 1e-8\ncritical_ratio = 0.3\n[parts.c{k}]")
        parts.append('kind = "chamber"\nvolume = "1 l"\nwall_conductance = 0.1')
    return "\n".join([*parts, '[run]\nduration = "20 s"\n'])


def payload_of(text: str) -> bytes:
    return build_payload(loads(text, folder=EXAMPLES))


def live_module_of(text: str) -> Any:
    return live_module(loads(text, folder=EXAMPLES).symbolic_model)


def timed(action: Callable[[str], Any], text: str) -> float:
    """Return the time of a call [ms]."""
    begin = time.perf_counter()
    action(text)
    return 1e3 * (time.perf_counter() - begin)


def in_node(payload: bytes) -> list[float]:
    """Return the times from the payload to the first run, and of a later run [ms]."""
    with tempfile.TemporaryDirectory() as folder:
        for name in ("edit/www/model.js", "edit/www/integrator.wasm", "deploy/live/kernel.js"):
            shutil.copy(str(files("poppet") / name), folder)
        contents = {"main.js": PROGRAM.encode(), "package.json": b'{"type": "module"}', "payload": payload}
        for name, content in contents.items():
            Path(folder, name).write_bytes(content)
        told = subprocess.run(["node", "main.js"], cwd=folder, capture_output=True, text=True, check=True)
        times: list[float] = json.loads(told.stdout)
        return times


def in_page(texts: Mapping[str, str], count: int) -> None:
    """Print the times in the page from a new wire and from a number to the painted curve [ms], `count` wires each."""
    sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
    program = import_module("chromium").found()
    if program is None or find_spec("playwright") is None:
        print("no page was looked at: Chromium or Playwright is missing")
        return
    editor_page, playwright = import_module("editor_page"), import_module("playwright.sync_api")
    with playwright.sync_playwright() as driver, tempfile.TemporaryDirectory() as folder:
        browser = driver.chromium.launch(executable_path=program, args=list(editor_page.FLAGS))
        for title, text in texts.items():
            place, (address, store) = Path(folder, title.replace(" ", "_")), NUMBERS[title]
            place.mkdir()
            (place / "plant.toml").write_text(text, encoding="utf-8")
            server = editor_page.Server(place, "plant.toml")
            try:
                page = editor_page.Editor(server, browser.new_page()).open().page
                wires, numbers = page.evaluate(PAGE, {"count": count, "address": address, "store": store})
            finally:
                server.stop()
            found = f"wire {statistics.median(wires):.0f} ms of {TARGETS[title]}"
            print(f"{title:9s} in the page: {found}, number {statistics.median(numbers):.0f} ms of 25")
        browser.close()


def main(size: float = 1.0) -> None:
    texts = {title: (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8") for title, name in FILES.items()}
    texts["40 parts"] = chain(20)
    has_node = shutil.which("node") is not None
    print(f"{'':9s} {'new ms':>7s} {'live ms':>8s} {'ratio':>6s} {'known ms':>9s} {'first run':>10s} {'later':>6s}")
    for title, text in texts.items():
        rounds: list[tuple[float, ...]] = []
        for _ in range(max(2, round(9 * size))):
            for cache in (build.PAGE_KERNELS, circuit.MODELS):
                cache.clear()
            new, known = timed(payload_of, text), timed(payload_of, text)
            circuit.MODELS.clear()
            live = timed(live_module_of, text)
            rounds.append((new, live, live / new, known))
        new, live, ratio, known = (statistics.median(column) for column in zip(*rounds, strict=True))
        line = f"{title:9s} {new:7.0f} {live:8.0f} {ratio:6.1f} {known:9.1f}"
        if has_node:
            runs = [in_node(payload_of(text)) for _ in range(max(1, round(3 * size)))]
            first, later = (statistics.median(column) for column in zip(*runs, strict=True))
            line += f" {first:10.0f} {later:6.1f}   {new + first:.0f} ms of {TARGETS[title]}"
        print(line)
    in_page(dict([*texts.items()][: max(1, round(4 * size))]), max(1, round(7 * size)))


if __name__ == "__main__":
    main()
