"""The model of the editor's page in node, as the page's worker runs it."""

from __future__ import annotations

import json
import shutil
import subprocess
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

_PROGRAM = """
import fs from "node:fs";
import { PageModel } from "./model.js";
const [payloads, runs] = JSON.parse(process.argv[2]);
const integrator = await WebAssembly.compile(fs.readFileSync("integrator.wasm"));
let model;
for (const path of payloads) model = await PageModel.load(fs.readFileSync(path), integrator, model);
const results = runs.map((options, k) => {
  const { series, time, ...result } = model.run(options);
  const columns = model.header.columns.map(({ name }) => series(name));
  const bytes = [time, ...columns].map(one => Buffer.from(one.buffer, one.byteOffset, one.byteLength));
  fs.writeFileSync(`table${k}.bin`, Buffer.concat(bytes));
  return { ...model.kernel.ended, ...result };
});
console.log(JSON.stringify(results));
"""


def run_payloads(
    payloads: list[bytes], folder: Path, runs: list[dict[str, Any]] | None = None
) -> list[tuple[dict[str, Any], NDArray[np.float64]]]:
    """Load payloads one after another, and run the last model; each result has a table of time and all columns."""
    runs = runs or [{}]
    for name in ("edit/www/model.js", "edit/www/integrator.wasm", "deploy/live/kernel.js"):
        shutil.copy(str(files("poppet") / name), folder)
    (folder / "package.json").write_text('{"type": "module"}', encoding="utf-8")
    (folder / "main.js").write_text(_PROGRAM, encoding="utf-8")
    names = [f"payload{k}" for k in range(len(payloads))]
    for name, payload in zip(names, payloads, strict=True):
        (folder / name).write_bytes(payload)
    command = ["node", "main.js", json.dumps([names, runs])]
    output = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300, check=False)
    assert output.returncode == 0, output.stderr
    return [
        (ended, np.fromfile(folder / f"table{k}.bin").reshape(-1, ended["rows"]))
        for k, ended in enumerate(json.loads(output.stdout))
    ]
