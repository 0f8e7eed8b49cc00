"""Exported watches on a Cortex-M7: sizes by the GNU compiler, and instruction counts of updates in QEMU.

`python tests/cortex_m_watch.py` prints the table of docs/export_watch.md; see `cortex_m` for the method.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from cortex_m import COMPILER, EMULATOR, M7, OPTIONS, RUN, SCRIPT, size_of

SHIFT = 1
"""Base-2 logarithm of the emulated time of an instruction [ns]: an update must not exceed the range of the timer."""
STACK = 0x20100000


class WatchCounts(NamedTuple):
    """Sizes of an exported watch [bytes], and instructions of its updates."""

    code: int  # code and constants
    struct: int
    stack: int  # largest frame of a function
    mean: float  # instructions of an update
    largest: float


def program_of(files: Mapping[str, str]) -> str:
    """Return a program that runs the samples of the host program and prints the counts."""
    check = files["tank_host.c"].partition("/* Divide a line")[0]
    # A separate function: `reset` must enable the floating-point unit before its registers are saved.
    check = check.replace("static int check(void)", "__attribute__((noinline)) static int check(void)")
    lines = (
        RUN.replace('#include "ctl.h"', '#include "tank.h"')
        .replace("ctl_status_t", "int")
        .replace("0x20004000", hex(STACK))
    )
    lines = lines.replace("timed_step(ctl_t *r)", "timed(tank_watch *w, double t, const double *r, const double *u)")
    lines = lines.replace("ctl_step(r)", "tank_update(w, t, r, u)").replace(
        "#define ctl_step timed_step", "#define tank_update timed"
    )
    lines = lines.replace("#define main host", "").replace("#undef main", "").replace("host()", "check()")
    return lines.replace('#include "ctl_host.c"', check.partition('#include "tank.h"')[2]).replace(
        "ctl_t", "tank_watch"
    )


def measure(files: Mapping[str, str], folder: Path) -> WatchCounts:
    """Compile a watch with the name `tank`, run it on the emulated core, and return sizes and counts."""
    assert COMPILER is not None
    assert EMULATOR is not None
    script = SCRIPT.replace("256K", "1M").replace("16K", "1M")
    for name, text in {**files, "link.ld": script, "run.c": program_of(files)}.items():
        (folder / name).write_text(text)
    sources = ["tank.c", "tank_model.c", "tank_estimator.c"]
    compiler = [COMPILER, *M7.options, *OPTIONS, "-fstack-usage"]
    subprocess.run([*compiler, "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-c", *sources], cwd=folder, check=True)
    objects = [source.replace(".c", ".o") for source in sources]
    options = [
        "-nostartfiles",
        "-specs=nosys.specs",
        "-Wl,--gc-sections",
        "-Wl,--no-warn-rwx-segments",
        "-T",
        "link.ld",
    ]
    subprocess.run(
        [*compiler, *options, "run.c", *objects, "-lm", "-o", "run.elf"], cwd=folder, check=True, capture_output=True
    )
    emulator = [
        EMULATOR,
        "-M",
        M7.machine,
        *f"-nographic -monitor none -serial none -icount shift={SHIFT},align=off,sleep=off".split(),
    ]
    emulator += ["-semihosting-config", "enable=on,target=native", "-kernel", "run.elf"]
    run = subprocess.run(emulator, cwd=folder, capture_output=True, text=True, check=False, timeout=300)
    known, failed, n_calls, total, largest, struct = map(int, re.findall(r"\d+", run.stdout + run.stderr))
    per_tick = M7.tick / 2**SHIFT
    assert abs(known * per_tick - 401) < 1.5 * per_tick + 2.0, (
        f"the timer counts {known * per_tick} instead of 401 instructions"
    )
    assert largest < 0.9 * 2**24, "an update exceeds the range of the timer"
    assert not failed, "results differ from the expected ones"
    frames = [int(line.split("\t")[1]) for path in folder.glob("tank*.su") for line in path.read_text().splitlines()]
    code = sum(size_of(folder / path) for path in objects)
    return WatchCounts(code, struct, max(frames), total * per_tick / n_calls, largest * per_tick)


def main() -> None:
    """Print the table of docs/export_watch.md."""
    import tempfile

    from exported_watch_example import cylinder_watch, tank_watch
    from poppet.deploy.c.watch_project import watch_project

    for watch in (tank_watch(), cylinder_watch()):
        with tempfile.TemporaryDirectory() as folder:
            counts = measure(watch_project(watch, "tank"), Path(folder))
        n, f = len(watch.plan.instance.model.states), len(watch.plan.faults)
        sizes = f"{counts.code / 1000:.1f} | {counts.struct / 1000:.1f} | {counts.stack / 1000:.1f}"
        print(f"| {n} | {f} | {len(watch.plan.names)} | {sizes} | {counts.mean:.0f} | {counts.largest:.0f} |")


if __name__ == "__main__":
    main()
