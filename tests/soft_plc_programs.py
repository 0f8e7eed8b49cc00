"""Soft PLC for tests: a C program that scans an exported controller and reads and writes a served machine.

The controller is structured text, compiled by MATIEC as a complete program with located variables, or the C export of
the same controller. Both have the same host, `tests/soft_plc/host.c`, which runs as a process of its own.
"""

from __future__ import annotations

import csv
import re
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from controller_targets import C_COMPILER, MATIEC, members
from poppet.deploy.c.controller import c_controller
from poppet.deploy.controller import controller_program
from poppet.deploy.st.block import function_block
from structured_text import FunctionBlock

HOST = Path(__file__).with_name("soft_plc") / "host.c"
Steps = Sequence[tuple[float, float]]
"""Times of the machine [s] and values of an input of the program, from 0."""


@dataclass(frozen=True)
class PlcProgram:
    """Controller of a circuit, with the Modbus addresses of its inputs and outputs.

    The first four input registers of the machine contain its time. Bits and float32 numbers follow one another.
    """

    circuit: Any  # with the controller
    part: str
    scan: float  # [s]
    discrete: tuple[str, ...] = ()  # input of the block for each bit
    inputs: tuple[str, ...] = ()  # input of the block for each number
    coils: tuple[str, ...] = ()  # output of the block for each bit
    holding: tuple[str, ...] = ()
    signals: Mapping[str, Steps] = field(default_factory=dict)  # inputs of the block that follow the time

    @property
    def image(self) -> str:
        """Declarations that program and host share."""
        sizes = {"DISCRETE": len(self.discrete), "INPUT": 4 + 2 * len(self.inputs), "COIL": len(self.coils),
                 "HOLDING": 2 * len(self.holding)}  # fmt: skip
        macros = "".join(f"#define N_{name} {size}\n" for name, size in sizes.items())
        # An array has one element at least.
        return f"""#include <stdint.h>
{macros}struct image {{
  int discrete[N_DISCRETE + 1], coil[N_COIL + 1];
  uint16_t input[N_INPUT], holding[N_HOLDING + 1];
}};
void plc_init(void);
void plc_scan(struct image *image, unsigned long tick);
double get_float32(const uint16_t *words);
double get_float64(const uint16_t *words);
void put_float32(uint16_t *words, double value);
"""


def compile_matiec_program(program: PlcProgram, folder: Path) -> Path:
    """Compile the structured text of a controller as a program of a PLC, and return the executable."""
    if not MATIEC or C_COMPILER is None:
        pytest.skip("POPPET_MATIEC names no folder of MATIEC")
    folder.mkdir(exist_ok=True)
    (folder / "program.st").write_text(_structured_text(program), encoding="ascii")
    compiler, lib = Path(MATIEC) / "iec2c", Path(MATIEC) / "lib"
    subprocess.run([compiler, "-I", lib, "-T", folder, folder / "program.st"], check=True, capture_output=True)
    read = [f"*__IX0_{k} = image->discrete[{k}];" for k in range(len(program.discrete))]
    read += [f"*__IL{1 + k} = get_float32(image->input + {4 + 2 * k});" for k in range(len(program.inputs))]
    write = [f"image->coil[{k}] = *__QX0_{k};" for k in range(len(program.coils))]
    write += [f"put_float32(image->holding + {2 * k}, *__QL{k});" for k in range(len(program.holding))]
    (folder / "plc.c").write_text(f"""#include "iec_std_lib.h"
#include "image.h"
TIME __CURRENT_TIME;
#define __LOCATED_VAR(type, name, ...) static type value##name; type *name = &value##name;
#include "LOCATED_VARIABLES.h"
void config_init__(void);
void config_run__(unsigned long tick);
void plc_init(void) {{ config_init__(); }}
void plc_scan(struct image *image, unsigned long tick) {{
  *__IL0 = get_float64(image->input);
  {" ".join(read)}
  config_run__(tick);
  {" ".join(write)}
}}
""")
    return _link(program, folder, ["plc.c", "machine.c", "resource1.c"], [f"-I{lib / 'C'}", f"-I{lib}"])


def _structured_text(program: PlcProgram) -> str:
    """Return the block, a program that connects it to located variables, and a configuration."""
    text = function_block(controller_program(program.circuit, (program.part,)))
    block = FunctionBlock(text)
    located = [f"in_{name} AT %IX0.{k} : BOOL;" for k, name in enumerate(program.discrete)]
    located += ["machine_time AT %IL0 : LREAL;"]
    located += [f"in_{name} AT %IL{1 + k} : LREAL;" for k, name in enumerate(program.inputs)]
    located += [f"out_{name} AT %QX0.{k} : BOOL;" for k, name in enumerate(program.coils)]
    located += [f"out_{name} AT %QL{k} : LREAL;" for k, name in enumerate(program.holding)]
    local, body = ["block : " + block.name + ";"], []
    for name, steps in program.signals.items():
        kind = {bool: "BOOL", float: "LREAL"}[block.kinds[name][1]]
        local.append(f"in_{name} : {kind};")
        for time, value in steps:
            shown = ("TRUE" if value else "FALSE") if kind == "BOOL" else f"{value:.1f}"
            body.append(f"IF machine_time >= {time:.6f} THEN in_{name} := {shown}; END_IF;")
    names = [*program.discrete, *program.inputs, *program.signals]
    arguments = [f"{name} := in_{name}" for name in names] + [f"cycle_time := {program.scan:.6f}"]
    body.append(f"block({', '.join(arguments)});")
    body += [f"out_{name} := block.{name};" for name in (*program.coils, *program.holding)]
    lines = "\n".join
    return f"""{text}
PROGRAM main
VAR
{lines(local)}
END_VAR
VAR
{lines(located)}
END_VAR
{lines(body)}
END_PROGRAM
CONFIGURATION machine
  RESOURCE resource1 ON PC
    TASK scan(INTERVAL := T#{program.scan * 1e3:.0f}ms, PRIORITY := 0);
    PROGRAM instance WITH scan : main;
  END_RESOURCE
END_CONFIGURATION
"""


def compile_c_program(program: PlcProgram, folder: Path) -> Path:
    """Compile the C export of the same controller, and return the executable."""
    if C_COMPILER is None:
        pytest.skip("no C compiler")
    folder.mkdir(exist_ok=True)
    exported = controller_program(program.circuit, (program.part,))
    for name, text in c_controller(program.circuit, (program.part,), name="ctl", precision="double").items():
        (folder / name).write_text(text)
    names = {item.address: member for item, member in zip(exported.inputs, members(exported, "in"), strict=True)}
    inputs = {re.sub(r"\W", "_", address.partition(".")[2]): member for address, member in names.items()}
    outputs = dict(
        zip((item.address.partition(".")[2] for item in exported.outputs), members(exported, "out"), strict=True)
    )
    body = ["double time = get_float64(image->input);"]
    body += [f"r.in.{inputs[name]} = image->discrete[{k}] != 0;" for k, name in enumerate(program.discrete)]
    body += [f"r.in.{inputs[name]} = get_float32(image->input + {4 + 2 * k});" for k, name in enumerate(program.inputs)]
    for name, steps in program.signals.items():
        body += [f"if (time >= {time!r}) r.in.{inputs[name]} = {value!r};" for time, value in steps]
    body.append(f"(void)tick; (void)time; ctl_step_dt(&r, {program.scan!r});")
    body += [f"image->coil[{k}] = r.out.{outputs[name]} > 0.5;" for k, name in enumerate(program.coils)]
    body += [f"put_float32(image->holding + {2 * k}, r.out.{outputs[name]});" for k, name in enumerate(program.holding)]
    lines = "\n  ".join(body)
    (folder / "plc.c").write_text(f"""#include "image.h"
#include "ctl.h"
static ctl_t r;
void plc_init(void) {{ ctl_init(&r); }}
void plc_scan(struct image *image, unsigned long tick) {{
  {lines}
}}
""")
    return _link(program, folder, ["plc.c", "ctl.c"], [])


def _link(program: PlcProgram, folder: Path, sources: Sequence[str], options: Sequence[str]) -> Path:
    (folder / "image.h").write_text(program.image)
    shutil.copy(HOST, folder / "host.c")
    assert C_COMPILER is not None
    command = [C_COMPILER, "-std=gnu99", "-O1", "-w", "-ffp-contract=off", *options, "-I.", "-o", "soft_plc"]
    subprocess.run([*command, "host.c", *sources, "-lm", "-lrt"], cwd=folder, check=True)
    return folder / "soft_plc"


@dataclass(frozen=True)
class ScanLog:
    """Scans of a soft PLC: times of the machine that it read, lateness and duration of each scan [s]."""

    machine_time: list[float]
    lateness: list[float]
    duration: list[float]


def read_log(path: Path) -> ScanLog:
    """Read the log of a soft PLC."""
    with path.open(encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    return ScanLog(
        [float(row["machine_time"]) for row in rows],
        [float(row["lateness"]) for row in rows],
        [float(row["end"]) - float(row["begin"]) for row in rows],
    )
