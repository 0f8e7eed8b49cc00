"""How each target runs what the kernel has run: arrays in, a table of outputs and a time out, or why not."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.deploy.c.project import c_project
from poppet.deploy.controller import controller_program, controllers
from poppet.deploy.fmu.check import check_fmu
from poppet.deploy.fmu.package import fmu_of, write_fmu
from poppet.deploy.live.in_node import run_in_node
from poppet.deploy.st.block import function_block
from poppet.deploy.st.evaluator import FunctionBlock
from poppet.engine.problem import Problem, RawRun
from poppet.engine.solve import solve
from poppet.ground.codes import Note
from poppet.ground.errors import InputErrors, MissingDependencyError

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

Array = NDArray[np.float64]
MOST_INSTANTS = 3000
"""Instants of sampled memory up to which the independent solvers run: they begin anew at each."""
MOST_CALLS = 20_000
"""Calls of a controller that the evaluator of structured text makes."""
ROUNDING = 1e-14
"""By what the start is moved, to see what rounding alone becomes in a run."""
SHARPER = 0.01
"""Tolerance of the independent solvers per tolerance of the run: their errors add up over the instants."""
STEPS = {"c 1 kHz": 1e-3, "c 10 kHz": 1e-4}


class NotRun(Exception):
    """A target that could not be run, and why."""

    def __init__(self, code: str, **facts: object) -> None:
        self.note = Note(f"deploy.parity.{code}", **facts)
        super().__init__(code)


class Found(NamedTuple):
    """What a target gave: outputs, (n_outputs, n_times), and the time of the run alone [s]."""

    values: Array
    seconds: float
    differences: Mapping[str, float] | None = None  # by the size of each, of a target that compares itself


@dataclass(frozen=True, eq=False)
class Reference:
    """The kernel's run."""

    circuit: Circuit
    problem: Problem
    run: RawRun
    seconds: float
    sizes: Array  # (n_outputs,) greatest magnitude, or usual size of a state
    made: dict[Path, Path] = field(default_factory=dict)  # folder to the host that was compiled in it

    @property
    def names(self) -> tuple[str, ...]:
        """Addresses of the outputs."""
        return self.problem.kernel.model.columns[0]

    @cached_property
    def instants(self) -> int:
        """About how often the memory changes in the run."""
        model = self.problem.kernel.model
        if not model.memory:
            return 0
        try:
            cycle = controller_program(self.circuit, self.controllers).cycle
        except InputErrors:
            return MOST_INSTANTS + 1  # solenoids that switch
        return int(self.run.reached / cycle)

    @cached_property
    def controllers(self) -> tuple[str, ...]:
        """Parts that hold a sampled controller."""
        return tuple(controllers(self.circuit))


# --- The kernel itself, and other solvers ---


def kernel_moved(reference: Reference, folder: Path) -> Found:
    """The kernel from a start that differs by rounding."""
    moved = replace(reference.problem, x0=reference.problem.x0 * (1.0 + ROUNDING))
    began = time.perf_counter()
    run = solve(moved)
    return Found(run.values, time.perf_counter() - began)


def scipy(reference: Reference, folder: Path) -> Found:
    """LSODA."""
    return _otherwise(reference, "lsoda")


def cvodes(reference: Reference, folder: Path) -> Found:
    """CVODES."""
    return _otherwise(reference, "cvodes")


def _otherwise(reference: Reference, solver: str) -> Found:
    if reference.instants > MOST_INSTANTS:
        raise NotRun("instants", count=reference.instants, most=MOST_INSTANTS)
    sharp = replace(reference.problem, relative_tolerance=SHARPER * reference.problem.relative_tolerance)
    began = time.perf_counter()
    run = solve(sharp, solver)
    return Found(run.values, time.perf_counter() - began)


# --- C ---


def c_adaptive(reference: Reference, folder: Path) -> Found:
    """The kernel's method in C."""
    return _in_c(reference, folder, 0.0)


def c_slow(reference: Reference, folder: Path) -> Found:
    """A fixed step of 1 ms."""
    return _in_c(reference, folder, STEPS["c 1 kHz"])


def c_fast(reference: Reference, folder: Path) -> Found:
    """A fixed step of 0.1 ms."""
    return _in_c(reference, folder, STEPS["c 10 kHz"])


def _in_c(reference: Reference, folder: Path, step: float) -> Found:
    compiler = shutil.which(os.environ.get("CC", "cc")) or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        raise NotRun("no_compiler")
    if folder not in reference.made:
        project = c_project(reference.circuit, "model")
        host = files("poppet.deploy.parity").joinpath("host.c").read_text(encoding="utf-8")
        texts = {**project, "parity_host.c": host}
        for name, text in texts.items():
            (folder / name).write_text(text, encoding="utf-8")
        sources = sorted(name for name in texts if name.endswith(".c") and name != "model_host.c")
        command = [compiler, "-std=c99", "-O2", "-w", "-D_POSIX_C_SOURCE=199309L", "-o", "host", *sources, "-lm"]
        made = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        if made.returncode:
            raise NotRun("not_compiled", compiler=Path(compiler).name, told=made.stderr[-300:])
        reference.made[folder] = folder / "host"
    grid = reference.run.time
    grid.tofile(folder / "times")
    command = [str(reference.made[folder]), repr(step), "times", "table"]
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if ran.returncode:
        raise NotRun("ended", status=ran.returncode, told=ran.stdout[-200:])
    table = np.fromfile(folder / "table").reshape(len(reference.names), grid.size)
    return Found(table, float(ran.stdout.split()[0]))


# --- FMU ---


def fmu_co_simulation(reference: Reference, folder: Path) -> Found:
    """Co-simulation in FMPy."""
    return _in_fmpy(reference, folder, "CoSimulation")


def fmu_model_exchange(reference: Reference, folder: Path) -> Found:
    """Model exchange in FMPy, integrated by its CVODE."""
    return _in_fmpy(reference, folder, "ModelExchange")


def _in_fmpy(reference: Reference, folder: Path, kind: str) -> Found:
    file = folder / "model.fmu"
    if not sys.platform.startswith("linux"):
        raise NotRun("other_system", system=sys.platform)
    try:
        if not file.exists():
            made = fmu_of(reference.circuit, "model")
            if not made.platforms:
                raise NotRun("because", why=str(made.notes[0]))
            write_fmu(made, file)
        checked = check_fmu(file, reference.circuit, (kind,))
    except MissingDependencyError as missing:
        raise NotRun("because", why=str(missing)) from missing
    if checked.problems:
        raise NotRun("because", why="; ".join(checked.problems))
    differences = {each.output: each.relative for each in checked.differences}
    return Found(np.empty((0, 0)), checked.seconds[kind], differences)


# --- WebAssembly ---


def web_assembly(reference: Reference, folder: Path) -> Found:
    """The kernel of a live page."""
    if shutil.which("node") is None:
        raise NotRun("no_node")
    try:
        ended, table = run_in_node(reference.problem, folder)
    except subprocess.CalledProcessError as failed:
        raise NotRun("ended", status=failed.returncode, told=str(failed.stderr)[-200:]) from failed
    return Found(table[:, : reference.run.time.size], float(ended["seconds"]))


# --- Structured text ---


def structured_text(reference: Reference, folder: Path) -> Found:
    """The controllers of the circuit as one block, fed with what their sensors show in a run."""
    if not reference.controllers:
        raise NotRun("no_controller")
    circuit = reference.circuit
    program = controller_program(circuit, reference.controllers)
    duration = min(reference.run.reached, MOST_CALLS * program.cycle)
    # Steps that end at every instant: a row then shows what the program saw.
    near = circuit.with_values({"run.maximum_step": program.cycle / 2.0}).simulate(duration, program.cycle)
    block = FunctionBlock(function_block(program))
    names = block.names("VAR_INPUT")[: len(program.inputs)]
    fed = []
    for each in program.inputs:
        shown, offset = program.sensed.get(each.address, (each.address, 0.0))
        fed.append(near[shown][:-1] + offset)
    rows = np.array(fed).T.tolist()
    began = time.perf_counter()
    found = [[v for n, v in block(**dict(zip(names, row, strict=True))).items() if n != "overrun"] for row in rows]
    seconds = time.perf_counter() - began
    differences = {}
    for k, output in enumerate(program.outputs):
        known = near[output.address][:-1]
        size = float(np.abs(known).max(initial=0.0)) or 1.0
        differences[output.address] = float(np.abs(np.array(found)[:, k] - known).max(initial=0.0)) / size
    return Found(np.empty((0, 0)), seconds, differences)
