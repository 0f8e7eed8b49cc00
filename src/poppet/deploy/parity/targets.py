"""How each target runs what the kernel has run: arrays in, a table of outputs and a time out, or why not."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import InputErrors, MissingDependencyError
from poppet.deploy.c.project import c_project
from poppet.deploy.comparison import ROUNDING, ReferenceRun, beside, separate
from poppet.deploy.controller import controller_program, controllers
from poppet.deploy.fmu.fmu_layout import structured
from poppet.deploy.fmu.hosts import EXCHANGE_TOLERANCE, Hosted, described, in_fmpy, in_libcosim
from poppet.deploy.fmu.package import fmu_of, write_fmu
from poppet.deploy.live.node_runner import run_in_node
from poppet.deploy.st.block import function_block
from poppet.deploy.st.evaluator import FunctionBlock
from poppet.engine.problem import Problem, RawRun
from poppet.engine.solve import solve

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

Array = NDArray[np.float64]
MOST_INSTANTS = 3000
"""Instants of sampled memory up to which the independent solvers run: they begin anew at each."""
MOST_CALLS = 20_000
"""Calls of a controller that the evaluator of structured text makes."""
SHARPER = 0.01
"""Tolerance of the independent solvers per tolerance of the run: their errors add up over the instants."""


class NotRun(Exception):
    """A target that could not be run, and why."""

    def __init__(self, code: str, **facts: object) -> None:
        self.note = Note(f"deploy.parity.{code}", **facts)
        super().__init__(code)


class TargetResult(NamedTuple):
    """What a target gave: outputs, (n_outputs, n_times), and the time of the run alone [s]."""

    values: Array
    seconds: float
    points: Array | None = None  # (n_times,) where the steps of a host ended [s]
    first: int = 0  # row that is shown first
    outputs: tuple[int, ...] = ()  # places of those that it has; none for all
    differences: Mapping[str, float] | None = None  # by the size of each, of a target that compares itself


@dataclass(frozen=True, eq=False)
class Reference:
    """The kernel's run."""

    circuit: Circuit
    problem: Problem  # as `simulate` has it
    run: RawRun
    seconds: float
    fmu: Path | None = None  # that is to be run, in place of those that are made
    made: dict[Path, Path] = field(default_factory=dict)  # folder to the host that was compiled in it

    @property
    def names(self) -> tuple[str, ...]:
        """Addresses of the outputs."""
        return self.problem.kernel.model.columns[0]

    # What a run is held beside ------------------------------------------------------------------------------------

    @cached_property
    def separate(self) -> Problem:
        """The problem with a kernel that fuses no multiplication with an addition, as sources in C have it."""
        return separate(self.problem)

    @cached_property
    def rows(self) -> ReferenceRun:
        """The run that separate multiplications and additions give."""
        # A row on which an instant falls is after it, the last one of a run before it.
        return beside(self.separate, self.problem.grid.size - bool(self.problem.kernel.model.memory))

    def meeting(self, points: Array) -> ReferenceRun:
        """The same with steps that end where a host communicates, and rows there."""
        return beside(with_points(self.separate, _further(points)), points.size)

    @cached_property
    def sharp(self) -> ReferenceRun:
        """The same at the tolerance that the host of a model exchange has."""
        grid = self.problem.grid
        return beside(replace(self.separate, grid=_further(grid), relative_tolerance=EXCHANGE_TOLERANCE), grid.size)

    # Its memory ---------------------------------------------------------------------------------------------------

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


def _further(points: Array) -> Array:
    """Rows and one more, so that of the last one, too, what comes after it is shown, as hosts have it."""
    return np.append(points, 2.0 * points[-1] - points[-2])


def with_points(problem: Problem, points: Array) -> Problem:
    """The same problem, whose steps end where a host communicates, with a row there."""
    starts = np.union1d(problem.starts, points[:-1])
    # A point beside a breakpoint is the breakpoint, as the FMU takes it.
    near = np.searchsorted(problem.starts, starts - 1e-12 * (1.0 + starts))
    near = np.minimum(near, problem.starts.size - 1)
    beside = np.abs(problem.starts[near] - starts) <= 1e-9 * np.diff(points).min()
    starts = np.unique(np.where(beside, problem.starts[near], starts))
    places = np.searchsorted(problem.starts, starts, side="right") - 1
    jumps = problem.jumps[places] & np.isin(starts, problem.starts)
    return replace(problem, starts=starts, courses=problem.courses[places].copy(), jumps=jumps, grid=points)


# --- The kernel itself, and other solvers ---


def kernel_fused(reference: Reference, folder: Path) -> TargetResult:
    """The kernel as `simulate` runs it, with multiplications and additions at once where the processor has them."""
    return TargetResult(reference.run.values, reference.seconds)


def kernel_moved(reference: Reference, folder: Path) -> TargetResult:
    """The kernel from a start that differs by rounding."""
    moved = replace(reference.separate, x0=reference.separate.x0 * (1.0 + ROUNDING))
    began = time.perf_counter()
    run = solve(moved)
    return TargetResult(run.values, time.perf_counter() - began)


def scipy(reference: Reference, folder: Path) -> TargetResult:
    """LSODA."""
    return _otherwise(reference, "lsoda")


def cvodes(reference: Reference, folder: Path) -> TargetResult:
    """CVODES."""
    return _otherwise(reference, "cvodes")


def _otherwise(reference: Reference, solver: str) -> TargetResult:
    if reference.instants > MOST_INSTANTS:
        raise NotRun("instants", count=reference.instants, most=MOST_INSTANTS)
    sharp = replace(reference.problem, relative_tolerance=SHARPER * reference.problem.relative_tolerance)
    began = time.perf_counter()
    run = solve(sharp, solver)
    return TargetResult(run.values, time.perf_counter() - began)


# --- C ---


def c_adaptive(reference: Reference, folder: Path) -> TargetResult:
    """The kernel's method in C."""
    return _in_c(reference, folder)


def c_slow(reference: Reference, folder: Path) -> TargetResult:
    """A fixed step of 1 ms."""
    return _in_c(reference, folder, 1e-3)


def c_fast(reference: Reference, folder: Path) -> TargetResult:
    """A fixed step of 0.1 ms."""
    return _in_c(reference, folder, 1e-4)


def c_parted(reference: Reference, folder: Path) -> TargetResult:
    """A fixed step of 1 ms in a hundred parts."""
    return _in_c(reference, folder, 1e-3, 100)


def _in_c(reference: Reference, folder: Path, step: float = 0.0, substeps: int = 1) -> TargetResult:
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
    command = [str(reference.made[folder]), repr(step), str(substeps), "times", "table"]
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if ran.returncode:
        raise NotRun("ended", status=ran.returncode, told=ran.stdout[-200:])
    table = np.fromfile(folder / "table").reshape(len(reference.names), grid.size)
    return TargetResult(table, float(ran.stdout.split()[0]))


# --- FMU ---


def fmu_co_simulation(reference: Reference, folder: Path) -> TargetResult:
    """Co-simulation in FMPy."""
    return _in_fmpy(reference, folder, "CoSimulation", 2)


def fmu_model_exchange(reference: Reference, folder: Path) -> TargetResult:
    """Model exchange in FMPy, integrated by its CVODE."""
    return _in_fmpy(reference, folder, "ModelExchange", 2)


def fmu_3_co_simulation(reference: Reference, folder: Path) -> TargetResult:
    """Co-simulation in FMPy, FMI 3.0."""
    return _in_fmpy(reference, folder, "CoSimulation", 3)


def fmu_3_model_exchange(reference: Reference, folder: Path) -> TargetResult:
    """Model exchange in FMPy, FMI 3.0."""
    return _in_fmpy(reference, folder, "ModelExchange", 3)


def fmu_second_host(reference: Reference, folder: Path) -> TargetResult:
    """Co-simulation in libcosim."""
    grid = reference.run.time
    nanoseconds = 1e9 * (grid[1] - grid[0])
    if abs(nanoseconds - round(nanoseconds)) > 1e-6:
        raise NotRun("no_nanoseconds", step=grid[1] - grid[0])
    return _hosted(reference, folder, 2, lambda file, names: in_libcosim(file, grid, names))


def _in_fmpy(reference: Reference, folder: Path, kind: str, fmi: int) -> TargetResult:
    return _hosted(reference, folder, fmi, lambda file, names: in_fmpy(file, kind, reference.run.time, names))


def _hosted(
    reference: Reference, folder: Path, fmi: int, host: Callable[[Path, Sequence[str]], Hosted]
) -> TargetResult:
    if not sys.platform.startswith("linux"):
        raise NotRun("other_system", system=sys.platform)
    try:
        file = reference.fmu or _made_fmu(reference, folder, fmi)
        own, problems = described(file)
        if problems:
            raise NotRun("because", why="; ".join(problems))
        names = [structured(name) for name in reference.names]
        places = tuple(k for k, name in enumerate(names) if name in own)
        hosted = host(file, [names[k] for k in places])
    except MissingDependencyError as missing:
        raise NotRun("because", why=str(missing)) from missing
    except (RuntimeError, OSError) as failed:  # of the host: its solver gave up, or it does not take the file
        raise NotRun("because", why=str(failed)) from failed
    values = np.full((len(names), hosted.values.shape[1]), np.nan)
    values[list(places)] = hosted.values
    return TargetResult(values, hosted.seconds, hosted.points, hosted.first, places)


def _made_fmu(reference: Reference, folder: Path, fmi: int) -> Path:
    file = folder / f"model{fmi}.fmu"
    if not file.exists():
        made = fmu_of(reference.circuit, "model", fmi=fmi)
        if not made.platforms:
            raise NotRun("because", why=str(made.notes[0]))
        write_fmu(made, file)
    return file


# --- WebAssembly ---


def web_assembly(reference: Reference, folder: Path) -> TargetResult:
    """The kernel of a live page."""
    if shutil.which("node") is None:
        raise NotRun("no_node")
    try:
        ended, table = run_in_node(reference.problem, folder)
    except subprocess.CalledProcessError as failed:
        raise NotRun("ended", status=failed.returncode, told=str(failed.stderr)[-200:]) from failed
    return TargetResult(table[:, : reference.run.time.size], float(ended["seconds"]))


# --- Structured text ---


def structured_text(reference: Reference, folder: Path) -> TargetResult:
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
    return TargetResult(np.empty((0, 0)), seconds, differences=differences)
