"""Exported controllers on Cortex-M cores: sizes by the GNU compiler, and instruction counts in QEMU.

The example program of the export runs on the emulated core and compares outputs and status with the expected values.
QEMU advances its clock by a constant time per instruction (`-icount`), so the SysTick timer counts instructions.
`python tests/cortex_m.py` prints the tables of docs/export_c.md.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

COMPILER = shutil.which("arm-none-eabi-gcc")
EMULATOR = shutil.which("qemu-system-arm")
OPTIONS = ("-Os", "-std=c99", "-mthumb", "-ffp-contract=off", "-ffunction-sections", "-fdata-sections")
SHIFT = 8
"""Base-2 logarithm of the emulated time of an instruction [ns]; a tick of the timer is then shorter."""


class Core(NamedTuple):
    """Core with its compiler options and a machine that QEMU emulates."""

    name: str
    options: tuple[str, ...]
    machine: str
    tick: float  # of the SysTick timer [ns]


M0 = Core("M0", ("-mcpu=cortex-m0", "-mfloat-abi=soft"), "microbit", 62.5)
M4F = Core("M4F", ("-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"), "mps2-an386", 40.0)
M7 = Core("M7", ("-mcpu=cortex-m7", "-mfpu=fpv5-d16", "-mfloat-abi=hard"), "mps2-an500", 40.0)
COLUMNS = ((M0, "single"), (M0, "double"), (M4F, "single"), (M7, "double"))

SCRIPT = """
MEMORY { code (rx) : ORIGIN = 0, LENGTH = 256K  ram (rwx) : ORIGIN = 0x20000000, LENGTH = 16K }
SECTIONS {
  .text : { KEEP(*(.vectors)) *(.text*) *(.rodata*) } > code
  .ARM.exidx : { *(.ARM.exidx*) } > code
  .data : { *(.data*) } > ram
  .bss : { *(.bss*) *(COMMON) } > ram
  end = .;
}
"""
START = """
#include <stdint.h>
void reset(void);
__attribute__((section(".vectors"), used)) static void *const vectors[] = {(void *)0x20004000, (void *)reset};
"""
SIZE = START + '#include "ctl.h"\nstatic ctl_t r;\nvoid reset(void) {%s for (;;) { } }\n'
RUN = (
    START
    + """
#include <stdio.h>
#include "ctl.h"
#define SYST ((volatile uint32_t *)0xE000E010u)
static uint32_t n_calls, largest, total;
static uint32_t elapsed(uint32_t before) { return (before - SYST[2]) & 0xFFFFFFu; }
static ctl_status_t timed_step(ctl_t *r) {
  uint32_t before = SYST[2], empty = elapsed(before), ticks;
  ctl_status_t status;
  before = SYST[2];
  status = ctl_step(r);
  ticks = elapsed(before) - empty;
  n_calls++;
  total += ticks;
  if (ticks > largest) largest = ticks;
  return status;
}
#define ctl_step timed_step
#define main host
#define printf(...)
#include "ctl_host.c"
#undef main
static void call(uint32_t operation, const void *argument) {
  register uint32_t r0 __asm__("r0") = operation;
  register const void *r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}
static void write(uint32_t value) {
  char text[12], *p = text + 11;
  *p = 0;
  *--p = ' ';
  do { *--p = (char)('0' + value % 10u); value /= 10u; } while (value);
  call(4, p);
}
void reset(void) {
#ifdef __ARM_FP
  *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20;
  __asm__ volatile("dsb\\n isb");
#endif
  SYST[1] = 0xFFFFFFu;
  SYST[2] = 0;
  SYST[0] = 5;
  {
    uint32_t before = SYST[2], empty = elapsed(before);
    before = SYST[2];
    /* one instruction before the loop, two in each pass */
    __asm__ volatile(".syntax unified\\n movs r3, #200\\n1: subs r3, #1\\n bne 1b" : : : "r3", "cc");
    write(elapsed(before) - empty);
  }
  write((uint32_t)host());
  write(n_calls);
  write(total);
  write(largest);
  write(sizeof(ctl_t));
  call(0x18, (void *)0x20026);
}
"""
)


class Sizes(NamedTuple):
    """Sizes of an exported controller [bytes]."""

    controller: int  # code and constants
    linked: int  # of the controller with the library functions that it calls
    stack: int  # of a step, without library functions


class Counts(NamedTuple):
    """Instructions of a step, and size of the struct [bytes]."""

    mean: float
    largest: float
    struct: int


def compile_controller(files: Mapping[str, str], core: Core, folder: Path) -> Path:
    """Compile the controller `ctl`; return the object file."""
    assert COMPILER is not None
    folder.mkdir(exist_ok=True, parents=True)
    for name, text in {**files, "link.ld": SCRIPT}.items():
        (folder / name).write_text(text)
    command = [COMPILER, *core.options, *OPTIONS, "-fstack-usage", "-c", "ctl.c", "-o", "ctl.o"]
    subprocess.run(command, cwd=folder, check=True)
    return folder / "ctl.o"


def link(source: str, core: Core, folder: Path, name: str) -> Path:
    """Link a program with the controller; return the executable."""
    assert COMPILER is not None
    (folder / f"{name}.c").write_text(source)
    options = [
        "-nostartfiles",
        "-specs=nosys.specs",
        "-Wl,--gc-sections",
        "-Wl,--no-warn-rwx-segments",
        "-T",
        "link.ld",
    ]
    command = [COMPILER, *core.options, *OPTIONS, *options, f"{name}.c", "ctl.o", "-lm", "-o", f"{name}.elf"]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    return folder / f"{name}.elf"


def size_of(path: Path) -> int:
    """Return the size of code and data of a file [bytes]."""
    text = subprocess.run(["arm-none-eabi-size", path], capture_output=True, text=True, check=True).stdout
    code, data = text.splitlines()[1].split()[:2]
    return int(code) + int(data)


def symbols_of(path: Path) -> set[str]:
    """Return the names of all functions in a file, also those that it only calls."""
    text = subprocess.run(["arm-none-eabi-nm", path], capture_output=True, text=True, check=True).stdout
    return {line.split()[-1] for line in text.splitlines() if line}


def sizes_of(files: Mapping[str, str], core: Core, folder: Path) -> Sizes:
    """Return the sizes of a controller."""
    controller = size_of(compile_controller(files, core, folder))
    calls = "ctl_init(&r); for (;;) { (void)ctl_step_dt(&r, 0); }"
    linked = size_of(link(SIZE % calls, core, folder, "linked")) - size_of(link(SIZE % "", core, folder, "empty"))
    usage = [line.split("\t") for line in (folder / "ctl.su").read_text().splitlines()]
    stack = {fields[0].rpartition(":")[2]: int(fields[1]) for fields in usage}
    inner = max(stack.get(name, 0) for name in ("accept", "start", "advance", "update", "outputs"))
    return Sizes(controller, linked, stack["ctl_step_dt"] + inner)


def count_instructions(files: Mapping[str, str], core: Core, folder: Path) -> Counts:
    """Run the example program on an emulated core; return the instructions of a step."""
    assert EMULATOR is not None
    compile_controller(files, core, folder)
    executable = link(RUN, core, folder, "run")
    options = f"-nographic -monitor none -serial none -icount shift={SHIFT},align=off,sleep=off".split()
    options += ["-semihosting-config", "enable=on,target=native"]
    command = [EMULATOR, "-M", core.machine, *options, "-kernel", str(executable)]
    run = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
    known, failed, n_calls, total, largest, struct = map(int, re.findall(r"\d+", run.stdout + run.stderr))
    assert not failed, "outputs or status differ from the expected ones"
    per_tick = core.tick / 2**SHIFT
    assert abs(known * per_tick - 401) < 2.0, f"the timer counts {known * per_tick} instead of 401 instructions"
    return Counts(total * per_tick / n_calls, largest * per_tick, struct)


def main() -> None:
    """Print the tables of docs/export_c.md: sizes and instruction counts of the exported controllers."""
    import tempfile

    from circuits_of_exports import CONTROLLERS, EXAMPLES
    from poppet import load
    from poppet.deploy.c.controller import c_controller

    print("| controller |", " | ".join(f"{core.name}, {precision}" for core, precision in COLUMNS), "|")
    with tempfile.TemporaryDirectory() as folder:
        for name, parts in CONTROLLERS.items():
            sizes, counts = [], []
            for core, precision in COLUMNS:
                files = c_controller(load(EXAMPLES / f"{name}.toml"), parts, name="ctl", precision=precision)
                place = Path(folder) / f"{name}_{core.name}_{precision}"
                sizes.append(sizes_of(files, core, place))
                counts.append(count_instructions(files, core, place))
            print(f"| {name} |", " | ".join(f"{s.controller / 1000:.1f} ({s.linked / 1000:.1f})" for s in sizes), "|")
            print(
                "| RAM, stack |", " | ".join(f"{c.struct}, {s.stack}" for s, c in zip(sizes, counts, strict=True)), "|"
            )
            print("| instructions |", " | ".join(f"{c.mean:.0f} ({c.largest:.0f})" for c in counts), "|")


if __name__ == "__main__":
    main()
