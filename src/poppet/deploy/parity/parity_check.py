"""Parity check of an export target.

A check has a function that runs the target, a limit of the differences, and a reference run of the kernel.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import InputErrors
from poppet.deploy.comparison import ReferenceRun, run_reference, without_fused_operations
from poppet.deploy.controller import controller_program, find_controllers
from poppet.deploy.fmu.importers import EXCHANGE_TOLERANCE
from poppet.engine.problem import Problem, RawRun

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

Array = NDArray[np.float64]
MAX_INSTANTS = 3000
"""Maximum number of sample instants for the reference solvers, which restart at each sample instant."""


class NotRunError(Exception):
    """Error that states why an export target cannot run the circuit."""

    def __init__(self, code: str, **facts: object) -> None:
        self.note = Note(f"deploy.parity.{code}", **facts)
        super().__init__(code)


class TargetResult(NamedTuple):
    """Outputs of one export target, (n_outputs, n_times), and its computing time [s]."""

    values: Array
    seconds: float
    points: Array | None = None  # (n_times,) ends of the importer's steps [s]
    first: int = 0  # first available row
    outputs: tuple[int, ...] = ()  # indices of the available outputs; empty for all
    differences: Mapping[str, float] | None = None  # relative to the size of each output, if the target compares itself


class ParityCheck(NamedTuple):
    """Comparison of one export target with the simulation.

    It gives one row of the table that `poppet export check` prints.
    """

    name: str
    description: str
    # Maximum difference relative to the size of an output: rounding for the same method and tolerance, the tolerances
    # for another method.
    limit: float
    scope: str  # `all` outputs, or `gas`: positive states, which are pressures and masses
    run: Callable[[KernelReference, Path], TargetResult]
    reference: str = "rows"  # run of the kernel for comparison: `rows`, `points` or `sharp`
    # Cause of the differences: `rounding`, the errors of the `method`, the length of a `step`, or `anything`.
    cause: str = "rounding"
    fmi: int = 0  # version of FMI of a check that runs an FMU


@dataclass(frozen=True, eq=False)
class KernelReference:
    """Reference run of a circuit, and variants of it, with which targets are compared.

    The runs are those of the kernel, poppet's own integrator.
    """

    circuit: BaseCircuit
    problem: Problem  # of `simulate`
    run: RawRun
    seconds: float
    fmu: Path | None = None  # an FMU that runs instead of new ones
    programs: dict[Path, Path] = field(default_factory=dict)  # folder to the host program that was compiled in it

    @property
    def names(self) -> tuple[str, ...]:
        """Addresses of the outputs of the circuit."""
        return self.problem.kernel.model.columns[0]

    @cached_property
    def unfused_problem(self) -> Problem:
        """Definition of the run with a kernel without fused operations (FMA), which the targets do not use either."""
        return without_fused_operations(self.problem)

    @cached_property
    def rows(self) -> ReferenceRun:
        """Reference run at the output times of the circuit, without fused operations."""
        # A row at a sample instant has the values after it; the last row of a run has the values before it.
        return run_reference(self.unfused_problem, self.problem.grid.size - bool(self.problem.kernel.model.memory))

    def at_points(self, points: Array) -> ReferenceRun:
        """Return the reference run for an importer that communicates at given times [s].

        The steps of the run end at these times. The kernel has no fused operations.
        """
        return run_reference(with_points(self.unfused_problem, _with_next_row(points)), points.size)

    @cached_property
    def exchange_run(self) -> ReferenceRun:
        """Reference run with the smaller tolerance of FMI model exchange, without fused operations."""
        grid = _with_next_row(self.problem.grid)
        sharp = replace(self.unfused_problem, grid=grid, relative_tolerance=EXCHANGE_TOLERANCE)
        return run_reference(sharp, grid.size - 1)

    @cached_property
    def n_instants(self) -> int:
        """Approximate number of sample instants in the run."""
        if not self.problem.kernel.model.memory:
            return 0
        try:
            cycle = controller_program(self.circuit, self.controllers).cycle
        except InputErrors:
            return MAX_INSTANTS + 1  # switching solenoids
        return int(self.run.reached / cycle)

    @cached_property
    def controllers(self) -> tuple[str, ...]:
        """Names of the sampled controllers of the circuit."""
        return tuple(find_controllers(self.circuit))


def _with_next_row(points: Array) -> Array:
    """Return increasing times, followed by one later time.

    Because of the later time, the values at the last given time are the values after an event. Importers return the
    same values.
    """
    return np.append(points, 2.0 * points[-1] - points[-2])


def with_points(problem: Problem, points: Array) -> Problem:
    """Return the definition of a run for an importer that communicates at given times [s].

    These times are the output times of the run, and steps end at them.
    """
    starts = np.union1d(problem.starts, points[:-1])
    # A point next to a breakpoint is replaced by the breakpoint, as in the FMU.
    nearest = np.searchsorted(problem.starts, starts - 1e-12 * (1.0 + starts))
    nearest = np.minimum(nearest, problem.starts.size - 1)
    is_close = np.abs(problem.starts[nearest] - starts) <= 1e-9 * np.diff(points).min()
    starts = np.unique(np.where(is_close, problem.starts[nearest], starts))
    segments = np.searchsorted(problem.starts, starts, side="right") - 1
    jumps = problem.jumps[segments] & np.isin(starts, problem.starts)
    return replace(problem, starts=starts, courses=problem.courses[segments].copy(), jumps=jumps, grid=points)
