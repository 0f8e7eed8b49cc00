"""Checks of parity: runs by the reference solvers and the export targets."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from dataclasses import replace
from functools import partial
from importlib.resources import files
from pathlib import Path

import numpy as np

from poppet.core.errors import MissingDependencyError
from poppet.deploy.c.project import c_project
from poppet.deploy.comparison import START_CHANGE
from poppet.deploy.controller import controller_program
from poppet.deploy.fmu.fmu_layout import structured_name
from poppet.deploy.fmu.importers import read_description, run_in_fmpy, run_in_libcosim
from poppet.deploy.fmu.package import build_fmu, zip_bytes
from poppet.deploy.live.page_kernel import run_in_node
from poppet.deploy.parity.parity_check import MAX_INSTANTS, KernelReference, NotRunError, ParityCheck, TargetResult
from poppet.engine.solve import solve

MAX_CALLS = 20_000
"""Maximum number of calls of a controller program in a check."""
TOLERANCE_FRACTION = 0.01
"""Ratio of the reference solvers' tolerance to that of the run. It is small, because errors add up over restarts."""

STEPS = (1e-10, "all", "points", "rounding")
EXCHANGE = (1e-5, "gas", "sharp", "method")
"""Limit, scope, reference and cause of the checks of co-simulation, and of model exchange."""

# Kernel and reference solvers ---------------------------------------------------------------------------------------


def _run_solver(reference: KernelReference, folder: Path, solver: str) -> TargetResult:
    """Run a circuit with one solver, for comparison with the reference run.

    `solver` is the name of a reference solver, or `rosenbrock` for poppet's own integrator with a slightly changed
    start state. If the name is empty, the existing run by poppet's own integrator is returned. `folder` is unused.
    """
    if not solver:
        return TargetResult(reference.run.values, reference.seconds)
    if solver == "rosenbrock":
        problem = replace(reference.unfused_problem, x0=reference.unfused_problem.x0 * (1.0 + START_CHANGE))
    elif reference.n_instants > MAX_INSTANTS:
        raise NotRunError("instants", count=reference.n_instants, most=MAX_INSTANTS)
    else:
        tolerance = TOLERANCE_FRACTION * reference.problem.relative_tolerance
        problem = replace(reference.problem, relative_tolerance=tolerance)
    start_time = time.perf_counter()
    values = solve(problem, solver).values
    return TargetResult(values, time.perf_counter() - start_time)


def kernel_checks() -> list[ParityCheck]:
    """Return the parity checks of poppet's own integrator and of the reference solvers.

    A parity check compares the results of two programs.
    """
    # No target can agree better with the kernel than the kernel with itself: a limit cycle amplifies rounding.
    fused, moved, lsoda, cvodes = (
        partial(_run_solver, solver=solver) for solver in ("", "rosenbrock", "lsoda", "cvodes")
    )
    return [
        ParityCheck("kernel fused", "the kernel as `simulate` runs it", np.inf, "all", fused, cause="anything"),
        ParityCheck("kernel moved", "the kernel, its start moved by 1e-14", np.inf, "all", moved, cause="anything"),
        ParityCheck("scipy", "LSODA of SciPy on the compiled functions", 1e-5, "gas", lsoda, cause="method"),
        ParityCheck("cvodes", "CVODES of SUNDIALS on the traced expressions", 1e-5, "gas", cvodes, cause="method"),
    ]


# C --------------------------------------------------------------------------------------------------------------------


def _run_c(reference: KernelReference, folder: Path, step: float = 0.0, substeps: int = 1) -> TargetResult:
    """Compile the exported C code in `folder`, and run it.

    `step` is the fixed step [s], or 0 for error control. `substeps` is the number of integration steps in a fixed step.
    """
    compiler = shutil.which(os.environ.get("CC", "cc")) or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        raise NotRunError("no_compiler")
    if folder not in reference.programs:
        host = files("poppet.deploy.parity").joinpath("host.c").read_text(encoding="utf-8")
        texts = {**c_project(reference.circuit, "model"), "parity_host.c": host}
        for name, text in texts.items():
            (folder / name).write_text(text, encoding="utf-8")
        sources = sorted(name for name in texts if name.endswith(".c") and name != "model_host.c")
        command = [compiler, "-std=c99", "-O2", "-w", "-D_POSIX_C_SOURCE=199309L", "-o", "host", *sources, "-lm"]
        compilation = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        if compilation.returncode:
            raise NotRunError("not_compiled", compiler=Path(compiler).name, told=compilation.stderr[-300:])
        reference.programs[folder] = folder / "host"
    grid = reference.run.time
    grid.tofile(folder / "times")
    command = [str(reference.programs[folder]), repr(step), str(substeps), "times", "table"]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if run.returncode:
        raise NotRunError("ended", status=run.returncode, told=run.stdout[-200:])
    values = np.fromfile(folder / "table").reshape(len(reference.names), grid.size)
    return TargetResult(values, float(run.stdout.split()[0]))


def c_checks() -> list[ParityCheck]:
    """Return the parity checks of the exported C code."""

    steps = {
        "c 1 kHz": ("1 ms", 1e-3, 1e-3, 1),
        "c 10 kHz": ("0.1 ms", 1e-4, 1e-4, 1),
        "c 1 kHz / 100": ("1 ms in a hundred", 1e-4, 1e-3, 100),
    }
    return [
        ParityCheck("c adaptive", "the exported C, with error control", 1e-9, "all", _run_c),
        *(
            ParityCheck(
                name, f"the exported C, fixed step of {text}", limit, "gas",
                partial(_run_c, step=step, substeps=substeps), cause="step",
            )
            for name, (text, limit, step, substeps) in steps.items()
        ),
    ]  # fmt: skip


# FMU ------------------------------------------------------------------------------------------------------------------


def _run_fmu(reference: KernelReference, folder: Path, kind: str, fmi: int) -> TargetResult:
    """Run an exported FMU in one importer.

    `kind` is `libcosim`, or, for the importer FMPy, `CoSimulation` or `ModelExchange`. `fmi` is the FMI version, 2 or
    3.
    """
    if not sys.platform.startswith("linux"):
        raise NotRunError("other_system", system=sys.platform)
    grid = reference.run.time
    nanoseconds = 1e9 * (grid[1] - grid[0])
    if kind == "libcosim" and abs(nanoseconds - round(nanoseconds)) > 1e-6:
        raise NotRunError("no_nanoseconds", step=grid[1] - grid[0])
    file = reference.fmu or folder / f"model{fmi}.fmu"
    try:
        if not file.exists():
            fmu = build_fmu(reference.circuit, "model", fmi=fmi)
            if not fmu.platforms:
                raise NotRunError("because", why=str(fmu.notes[0]))
            file.write_bytes(zip_bytes(fmu.content))
        variables, problems = read_description(file)
        if problems:
            raise NotRunError("because", why="; ".join(problems))
        names = [structured_name(name) for name in reference.names]
        indices = tuple(k for k, name in enumerate(names) if name in variables)
        selected = [names[k] for k in indices]
        run = run_in_libcosim(file, grid, selected) if kind == "libcosim" else run_in_fmpy(file, kind, grid, selected)
    except MissingDependencyError as missing:
        raise NotRunError("because", why=str(missing)) from missing
    except (RuntimeError, OSError) as error:  # of the importer: its solver failed, or it rejects the file
        raise NotRunError("because", why=str(error)) from error
    values = np.full((len(names), run.values.shape[1]), np.nan)
    values[list(indices)] = run.values
    return TargetResult(values, run.seconds, run.points, run.first, indices)


def fmu_checks() -> list[ParityCheck]:
    """Return the parity checks of the exported FMU."""
    return [
        ParityCheck(name, text, limit, scope, partial(_run_fmu, kind=kind, fmi=fmi), rows, cause, fmi)
        for name, text, kind, fmi, (limit, scope, rows, cause) in (
            ("fmu cs", "FMI 2.0 co-simulation in FMPy, which meets the kernel at every row", "CoSimulation", 2, STEPS),
            ("fmu 3 cs", "the same with FMI 3.0", "CoSimulation", 3, STEPS),
            ("fmu cs (second host)", "FMI 2.0 co-simulation in libcosim", "libcosim", 2, STEPS),
            ("fmu me", "FMI 2.0 model exchange, by CVODE of FMPy; the kernel at 1e-9", "ModelExchange", 2, EXCHANGE),
            ("fmu 3 me", "the same with FMI 3.0", "ModelExchange", 3, EXCHANGE),
        )
    ]


# WebAssembly and controllers ------------------------------------------------------------------------------------------


def _run_page_kernel(reference: KernelReference, folder: Path) -> TargetResult:
    """Run the WebAssembly model of a live page in Node.js.

    `folder` is a folder for temporary files.
    """
    if shutil.which("node") is None:
        raise NotRunError("no_node")
    try:
        outcome, values = run_in_node(reference.problem, folder)
    except subprocess.CalledProcessError as error:
        raise NotRunError("ended", status=error.returncode, told=str(error.stderr)[-200:]) from error
    return TargetResult(values[:, : reference.run.time.size], float(outcome["seconds"]))


def live_checks() -> list[ParityCheck]:
    """Return the parity check of the live page."""
    return [ParityCheck("wasm", "WebAssembly of the live page, in node", 1e-9, "all", _run_page_kernel)]


def _run_controllers(reference: KernelReference, folder: Path) -> TargetResult:
    """Run the exported program of all controllers with sensor values from a simulation.

    The result contains the differences of its outputs from the simulation.
    """
    if not reference.controllers:
        raise NotRunError("no_controller")
    circuit = reference.circuit
    program = controller_program(circuit, reference.controllers)
    duration = min(reference.run.reached, MAX_CALLS * program.cycle)
    # Steps that end at every sample instant: a row has the values that the program reads.
    step_limited = circuit.with_values({"run.maximum_step": program.cycle / 2.0})
    recording = step_limited.simulate(duration, program.cycle)
    columns = []
    for item in program.inputs:
        address, offset = program.sensed.get(item.address, (item.address, 0.0))
        columns.append(recording[address][:-1] + offset)
    inputs = np.array(columns).T
    start_time = time.perf_counter()
    outputs = program.run(inputs).outputs
    seconds = time.perf_counter() - start_time
    differences = {}
    for k, output in enumerate(program.outputs):
        expected = recording[output.address][:-1]
        size = float(np.abs(expected).max(initial=0.0)) or 1.0
        differences[output.address] = float(np.abs(outputs[:, k] - expected).max(initial=0.0)) / size
    return TargetResult(np.empty((0, 0)), seconds, differences=differences)


def controller_checks() -> list[ParityCheck]:
    """Return a list with the parity check of exported controllers.

    This check runs the program of the controllers, from which the exporters print structured text and C.
    """
    text = "the program of the controllers, which structured text and C print"
    return [ParityCheck("controllers", text, 1e-9, "all", _run_controllers)]
