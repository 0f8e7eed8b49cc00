"""The kernel as WebAssembly in V8 beside the same kernel as machine code, on the paper's staircase; needs node.

Rounds of both take turns, so that a busy machine slows both; printed is the best run of each and their ratio.
"""

from __future__ import annotations

import shutil
import subprocess
import time
from importlib.resources import files
from pathlib import Path

from poppet import load
from poppet.deploy.live.packed import packed, run_blobs
from poppet.engine.call import Call

EXAMPLE = Path(__file__).parents[1] / "examples" / "fill_staircase.toml"
ROUND = """
unpacked(require("fs").readFileSync(0, "utf8")).then(Kernel.of).then(kernel => {
  let best = Infinity;
  for (let k = 0; k < COUNT; k++) {
    const begin = performance.now();
    kernel.run();
    if (k >= COUNT / 2) best = Math.min(best, performance.now() - begin);
  }
  console.log(best);
});
"""


def main(size: float = 1.0) -> None:
    if shutil.which("node") is None:
        print("nothing measured:\nnode is not installed")
        return
    circuit = load(EXAMPLE)
    problem = circuit.problem(circuit.run)
    call, pack, count = Call(problem), packed(*run_blobs(problem)), max(20, round(2000 * size))
    script = (files("poppet.deploy.live") / "kernel.js").read_text(encoding="utf-8") + ROUND.replace(
        "COUNT", str(count)
    )
    native, browser = [], []
    for _ in range(max(1, round(5 * size))):
        for _ in range(count):
            begin = time.perf_counter()
            call.again()
            native.append(1e3 * (time.perf_counter() - begin))
        told = subprocess.run(["node", "-e", script], input=pack, capture_output=True, text=True, check=True)
        browser.append(float(told.stdout))
    best = min(native), min(browser)
    print(f"machine code {best[0]:6.3f} ms\nWebAssembly  {best[1]:6.3f} ms, {best[1] / best[0]:.2f} times as long")


if __name__ == "__main__":
    main()
