"""The kernel of a page, run by node instead of a browser."""

from __future__ import annotations

import json
import subprocess
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.deploy.live.packing import packed, run_blobs
from poppet.engine.problem import Problem

_MAIN = """
const fs = require("fs");
(async () => {
  const kernel = await Kernel.of(await unpacked(fs.readFileSync(0, "utf8")));
  const numbers = JSON.parse(process.argv[3]);
  kernel.run(...numbers);
  // The second run finds its code compiled.
  const begin = performance.now();
  const ended = kernel.run(...numbers);
  const seconds = 1e-3 * (performance.now() - begin);
  fs.writeFileSync(process.argv[2], Buffer.from(kernel.table.buffer, kernel.table.byteOffset, kernel.table.byteLength));
  console.log(JSON.stringify({ ...ended, seconds }));
})();
"""


def run_in_node(problem: Problem, folder: Path, *numbers: Any) -> tuple[dict[str, Any], NDArray[np.float64]]:
    """How a run ended and how long it took [s], and its table; `numbers` are places in p and values."""
    script, table = folder / "run.js", folder / "table.bin"
    kernel = (files("poppet.deploy.live") / "kernel.js").read_text(encoding="utf-8")
    script.write_text(kernel + _MAIN, encoding="utf-8")
    command = ["node", str(script), str(table), json.dumps([numbers])]
    text = packed(*run_blobs(problem))
    told = subprocess.run(command, input=text, capture_output=True, text=True, check=True, timeout=300)
    return json.loads(told.stdout), np.fromfile(table).reshape(-1, problem.grid.size)
