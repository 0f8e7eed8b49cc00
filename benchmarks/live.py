"""The kernel as WebAssembly in V8 beside the same kernel as machine code, on the paper's staircase; needs node.

Rounds of both take turns, so that a busy machine slows both; printed is the best run of each and their ratio. Where a
browser is found (`POPPET_BROWSER` names one), updates of its page are counted beside the frames of an empty page.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import time
from importlib import import_module
from pathlib import Path

from poppet import load
from poppet.deploy.live.page_kernel import kernel_script, pack_base64, run_data
from poppet.deploy.targets import TARGETS
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
FRAMES = """
new Promise(done => {
  const begin = performance.now();
  let n = 0;
  const step = () => {
    if (n++ === COUNT) return done(performance.now() - begin);
    globalThis.live?.change("tank.volume", .1 + .3 * n / COUNT);
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
})
"""


def frames(rounds: int, count: int) -> None:
    """Print what pages do in a browser: frames a second, and what the thread of the page works for each."""
    sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
    browsers = import_module("chromium")
    program = browsers.found()
    if program is None:
        print("no browser here: no page was looked at")
        return
    with tempfile.TemporaryDirectory() as folder, browsers.Browser(program) as browser:
        pages = {name: Path(folder, f"{name}.html") for name in ("empty", "live")}
        TARGETS["live"].write(load(EXAMPLE), pages["live"])
        pages["empty"].write_text("<!doctype html><title>empty</title>", encoding="utf-8")
        browser.call("Performance.enable", timeDomain="threadTicks")

        def worked() -> float:
            told = browser.call("Performance.getMetrics")["metrics"]
            return next(float(each["value"]) for each in told if each["name"] == "TaskDuration")

        for _ in range(rounds):
            for name, path in pages.items():
                browser.open(path)
                browser("new Promise(done => setTimeout(done, 500))")
                browser(FRAMES.replace("COUNT", "30"))  # compiled by then
                before = worked()
                took = browser(FRAMES.replace("COUNT", str(count)))
                work, jobs = 1e3 * (worked() - before) / count, os.getloadavg()[0]
                print(f"{name:5} {1e3 * count / took:5.1f} a second, {work:5.2f} ms of work each, load {jobs:.1f}")


def main(size: float = 1.0) -> None:
    if shutil.which("node") is None:
        print("nothing measured:\nnode is not installed")
        return
    circuit = load(EXAMPLE)
    problem = circuit.problem(circuit.run)
    call, data, count = Call(problem), pack_base64(*run_data(problem)), max(20, round(2000 * size))
    script = kernel_script() + ROUND.replace("COUNT", str(count))
    native, browser = [], []
    for _ in range(max(1, round(5 * size))):
        for _ in range(count):
            begin = time.perf_counter()
            call.repeat()
            native.append(1e3 * (time.perf_counter() - begin))
        told = subprocess.run(["node", "-e", script], input=data, capture_output=True, text=True, check=True)
        browser.append(float(told.stdout))
    best = min(native), min(browser)
    print(f"machine code {best[0]:6.3f} ms\nWebAssembly  {best[1]:6.3f} ms, {best[1] / best[0]:.2f} times as long")
    frames(max(1, round(3 * size)), max(60, round(240 * size)))


if __name__ == "__main__":
    main()
