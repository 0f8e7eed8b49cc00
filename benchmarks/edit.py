"""From the text of a circuit to the model of the editor's page, beside the module of a live page, and to its first run.

Each round does both for a new structure, so a busy machine slows both; printed are medians. A known structure needs no
code: only its arrays are made. Where node is found, the page's script loads the model and runs it twice.
"""

from __future__ import annotations

import json
import shutil
import statistics
import subprocess
import tempfile
import time
from collections.abc import Callable
from importlib.resources import files
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


if __name__ == "__main__":
    main()
