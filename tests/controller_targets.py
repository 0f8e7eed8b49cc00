"""Runs of an exported controller on all targets: C in two precisions, structured text in an evaluator and compiled.

A run returns the outputs and the status bits of all calls. MATIEC and STruC++ are used if the environment
variables name their folders; no registry has them.
"""

from __future__ import annotations

import ctypes
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from poppet.deploy.c.controller import c_controller
from poppet.deploy.controller import controller_program
from poppet.deploy.controller_program import STATUS, ControllerProgram
from poppet.deploy.st.block import function_block
from structured_text import FunctionBlock

CONTROLLERS = {
    "pid": ("pressure_control", ()),
    "schedule": ("pressure_control_scheduled", ()),
    "feedback linearisation": ("pressure_control_linearising", ()),
    "position": ("position_control", ()),
    "dead zone": ("position_dead_zone", ()),
    "electronics": ("pressure_regulator", ()),
    "cascade": ("muscle_joint", ("position", "inverse", "valve")),
}
"""Example file and exported parts of each controller that the tests run."""
MATIEC, STRUCPP = (os.environ.get(name, "") for name in ("POPPET_MATIEC", "POPPET_STRUCPP"))
C_COMPILER = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
CPP_COMPILER = shutil.which("g++") or shutil.which("clang++")
STRICT = ("-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wdouble-promotion", "-Werror")


class Calls(NamedTuple):
    """Inputs (n_calls, n_inputs), parameters (n_calls, n_parameters), intervals [s] and restarts of all calls."""

    inputs: Any
    parameters: Any
    intervals: Any
    restarts: Any


def calls_of(
    program: ControllerProgram, inputs: Any, parameters: Any = None, intervals: Any = None, restarts: Any = None
) -> Calls:
    """Complete the arguments of calls: parameters of the circuit, nominal cycle, no restart."""
    n = len(inputs)
    defaults = np.array([parameter.value for parameter in program.parameters])
    return Calls(
        np.ascontiguousarray(inputs, dtype=float),
        np.ascontiguousarray(np.broadcast_to(defaults if parameters is None else parameters, (n, defaults.size))),
        np.full(n, program.cycle) if intervals is None else np.ascontiguousarray(intervals, dtype=float),
        np.zeros(n, dtype=bool) if restarts is None else np.asarray(restarts),
    )


def run_program(program: ControllerProgram, calls: Calls) -> tuple[Any, Any]:
    """Run the traced program: CasADi evaluates the equations of the simulation. It does not restart."""
    assert not calls.restarts.any()
    return tuple(program.run(*calls[:3]))


C_HOST = """
#include "ctl.h"
#include "ctl.c"
void run(int n, const double *u, const double *p, const double *dt, const unsigned char *restart, double *y, int *s) {
  static ctl_t r;
  ctl_init(&r);
  for (int k = 0; k < n; k++) {
    %(read)s
    if (restart[k]) ctl_reset(&r);
    s[k] = (int)ctl_step_dt(&r, (%(real)s)dt[k]);
    %(write)s
    u += %(n_u)d; p += %(n_p)d; y += %(n_y)d;
  }
}
"""


def compile_c_export(circuit: Any, parts: tuple[str, ...], folder: Path, precision: str) -> Path:
    """Compile the C export without warnings, as a library."""
    if C_COMPILER is None:
        pytest.skip("no C compiler")
    program = controller_program(circuit, parts)
    folder.mkdir(exist_ok=True)
    files = c_controller(circuit, parts, name="ctl", precision=precision)
    for name, text in files.items():
        (folder / name).write_text(text)
    subprocess.run([C_COMPILER, *STRICT, "-O1", "-c", "-o", "ctl.o", "ctl.c"], cwd=folder, check=True)
    real = "float" if precision == "single" else "double"
    names = {group: members(program, group) for group in ("in", "param", "out")}
    flags = [item.address in program.flags for item in program.inputs]
    read = [
        f"r.in.{m} = {f'u[{k}] > 0.5' if flag else f'({real})u[{k}]'};"
        for k, (m, flag) in enumerate(zip(names["in"], flags, strict=True))
    ]
    read += [f"r.param.{m} = ({real})p[{k}];" for k, m in enumerate(names["param"])]
    fields = {
        "read": " ".join(read), "write": " ".join(f"y[{k}] = r.out.{m};" for k, m in enumerate(names["out"])),
        "real": real, "n_u": len(program.inputs), "n_p": len(program.parameters), "n_y": len(program.outputs),
    }  # fmt: skip
    (folder / "host.c").write_text(C_HOST % fields)
    options = ["-std=c99", "-w", "-O1", "-ffp-contract=off", "-shared", "-fPIC"]
    subprocess.run([C_COMPILER, *options, "-o", "host.so", "host.c", "-lm"], cwd=folder, check=True)
    return folder / "host.so"


def members(program: ControllerProgram, group: str) -> list[str]:
    """Return the members of a struct of the C interface, as a user derives them from the addresses."""
    items = {"in": program.inputs, "param": program.parameters, "out": program.outputs}[group]
    result = []
    for item in items:
        part, _, local = item.address.partition(".")
        # A step A+ is A_plus; a word of a language has a suffix.
        local = re.sub(r"[+-](?=\.|$)", lambda sign: "_plus" if sign[0] == "+" else "_minus", local)
        local = "step_v" if local == "step" else re.sub(r"\W+", "_", local)
        alone = local if part == program.parts[0] else f"{part}_{local}"
        result.append(alone if len(program.parts) == 1 else f"{part}.{local}")
    return result


def run_evaluator(program: ControllerProgram, calls: Calls) -> tuple[Any, Any]:
    """Run the structured text with the evaluator of the tests."""
    block = FunctionBlock(function_block(program))
    names = block.names("VAR_INPUT")
    inputs = names[: len(program.inputs)]
    parameters = names[len(inputs) + 2 :]
    outputs = block.names("VAR_OUTPUT")[: len(program.outputs)]
    rows, status = [], []
    for u, p, dt, restart in zip(*calls, strict=True):
        values = {
            name: bool(value > 0.5) if item.address in program.flags else float(value)
            for name, item, value in zip(inputs, program.inputs, u, strict=True)
        }
        values |= {name: float(value) for name, value in zip(parameters, p, strict=True)}
        result = block(**values, cycle_time=float(dt), restart=bool(restart))
        rows.append([result[name] for name in outputs])
        status.append(sum(1 << k for k, name in enumerate(STATUS) if result[name]))
    return np.array(rows), np.array(status)


MATIEC_HOST = """
#include "iec_std_lib.h"
TIME __CURRENT_TIME;
#include "POUS.h"
#include "POUS.c"
void run(int n, const double *u, const double *p, const double *dt, const unsigned char *restart, double *y, int *s) {
  /* A host has it in memory of zeros: the flags of its variables have no other start. */
  static %(block)s b;
  %(block)s_init__(&b, 0);
  for (int k = 0; k < n; k++) {
    %(read)s
    %(block)s_body__(&b);
    %(write)s
    u += %(n_u)d; p += %(n_p)d; y += %(n_y)d;
  }
}
"""
STRUCPP_HOST = """
#include "block.cpp"
extern "C" void run(int n, const double *u, const double *p, const double *dt, const unsigned char *restart, double *y,
                    int *s) {
  strucpp::%(block)s b;
  for (int k = 0; k < n; k++) {
    %(read)s
    b();
    %(write)s
    u += %(n_u)d; p += %(n_p)d; y += %(n_y)d;
  }
}
"""


def compile_with_matiec(program: ControllerProgram, folder: Path) -> Path:
    """Compile the structured text with MATIEC, as a library."""
    if not MATIEC or C_COMPILER is None:
        pytest.skip("POPPET_MATIEC names no folder of MATIEC")
    folder.mkdir(exist_ok=True)
    lib = Path(MATIEC) / "lib"
    (folder / "block.st").write_text(function_block(program), encoding="ascii")
    subprocess.run([Path(MATIEC) / "iec2c", "-I", lib, "-T", folder, folder / "block.st"], check=True)
    (folder / "host.c").write_text(MATIEC_HOST % _st_fields(program, "b.{0}.value"), encoding="ascii")
    options = ["-w", "-O1", "-ffp-contract=off", "-shared", "-fPIC", f"-I{lib / 'C'}", f"-I{folder}"]
    subprocess.run([C_COMPILER, *options, "-o", folder / "host.so", folder / "host.c", "-lm"], check=True)
    return folder / "host.so"


def compile_with_strucpp(program: ControllerProgram, folder: Path) -> Path:
    """Compile the structured text with STruC++, as a library."""
    if not STRUCPP or CPP_COMPILER is None:
        pytest.skip("POPPET_STRUCPP names no folder of STruC++")
    folder.mkdir(exist_ok=True)
    (folder / "block.st").write_text(function_block(program), encoding="ascii")
    compiler = Path(STRUCPP) / "dist" / "node" / "cli.js"
    subprocess.run(["node", compiler, folder / "block.st", "-o", folder / "block.cpp"], check=True)
    (folder / "host.cpp").write_text(STRUCPP_HOST % _st_fields(program, "b.{0}"), encoding="ascii")
    options = ["-std=c++17", "-w", "-O1", "-ffp-contract=off", "-shared", "-fPIC"]
    include = f"-I{Path(STRUCPP) / 'src' / 'runtime' / 'include'}"
    subprocess.run([CPP_COMPILER, *options, include, "-o", folder / "host.so", folder / "host.cpp"], check=True)
    return folder / "host.so"


def _st_fields(program: ControllerProgram, member: str) -> dict[str, Any]:
    block = FunctionBlock(function_block(program))
    names = block.names("VAR_INPUT")
    inputs, parameters = names[: len(program.inputs)], names[len(program.inputs) + 2 :]
    outputs = block.names("VAR_OUTPUT")

    def place(name: str) -> str:
        return member.format(name.upper())

    flags = [item.address in program.flags for item in program.inputs]
    read = [f"{place(n)} = u[{k}]{' > 0.5' * flag};" for k, (n, flag) in enumerate(zip(inputs, flags, strict=True))]
    read += [f"{place(n)} = p[{k}];" for k, n in enumerate(parameters)]
    read += [f"{place('cycle_time')} = dt[k]; {place('restart')} = restart[k];"]
    write = [f"y[{k}] = {place(n)};" for k, n in enumerate(outputs[: len(program.outputs)])]
    bits = " + ".join(f"(({place(name)}) ? {1 << k} : 0)" for k, name in enumerate(STATUS))
    return {
        "block": block.name.upper(), "read": " ".join(read), "write": " ".join([*write, f"s[k] = {bits};"]),
        "n_u": len(program.inputs), "n_p": len(program.parameters), "n_y": len(program.outputs),
    }  # fmt: skip


def run_library(path: Path, program: ControllerProgram, calls: Calls) -> tuple[Any, Any]:
    """Call a compiled library."""
    n = len(calls.inputs)
    outputs, status = np.zeros((n, len(program.outputs))), np.zeros(n, dtype=np.int32)
    restarts = np.ascontiguousarray(calls.restarts, dtype=np.uint8)
    arrays = (*calls[:3], restarts, outputs, status)
    ctypes.CDLL(str(path)).run(n, *(ctypes.c_void_p(array.ctypes.data) for array in arrays))
    return outputs, status
