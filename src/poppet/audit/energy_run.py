"""Run of a circuit with the integrals of an energy audit."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.energy_trace import EnergyModel, trace_energy
from poppet.circuit.instance import Array
from poppet.circuit.options import Run
from poppet.core.errors import SimulationError
from poppet.engine.kernel import Kernel, compile_kernel
from poppet.engine.lru_cache import LruCache
from poppet.engine.problem import Outcome, Problem, RawRun, ending, is_failure
from poppet.engine.solve import run_kernel

ROWS = 2000
"""Number of output times in the period of an audit, which determine only the division of air between parts."""
MIN_STEPS = 200
"""Minimum number of integration steps in the period.

The integrals are not part of the error control. Steps can be long while all states change linearly, for example during
choked flow into a tank."""
ROUNDING = 1e-12
"""Relative difference of two times that are equal except for rounding errors."""
FACTORS, TIGHTEST = (1.0, 0.1, 0.01, 1e-3), 1e-13
"""Factors on the tolerance, and tightest tolerance. A run that stalls is repeated with the next factor."""


class EnergyKernel(NamedTuple):
    """Model of an energy audit and its compiled functions."""

    energy: EnergyModel
    kernel: Kernel


_KERNELS: LruCache[EnergyKernel] = LruCache(20)


def energy_kernel(circuit: BaseCircuit) -> EnergyKernel:
    """Return the compiled model of the energy audit of a circuit.

    Circuits that differ only in values share it.
    """

    def compile_energy() -> EnergyKernel:
        model = trace_energy(circuit.parts, tuple(circuit.parameters), circuit.connections)
        return EnergyKernel(model, compile_kernel(model.model))

    return _KERNELS.get(circuit.structure, compile_energy)


@dataclass(frozen=True)
class EnergyRun:
    """Integrals of the model of an energy audit over one period, and its outputs in this period.

    The period contains `count` cycles. `integrals`, (n_states,), contains the changes per cycle in the order of the
    state vector. `values`, (n_outputs, n_times), contains the outputs.
    """

    energy: EnergyModel
    count: int
    integrals: Array
    time: Array
    values: Array

    def integral(self, index: int | None) -> float:
        """Return an integral per cycle; 0 if the index is None."""
        return 0.0 if index is None else float(self.integrals[index])

    def change(self, index: int) -> float:
        """Return the change of an output per cycle."""
        return float(self.values[index, -1] - self.values[index, 0]) / self.count


def run_energy(
    circuit: BaseCircuit, run: Run, period: tuple[float, float], count: int = 1,
    progress: Callable[[float], Any] | None = None,
) -> EnergyRun:  # fmt: skip
    """Run a circuit until the end of a period, and return its energy integrals and outputs in this period.

    `count` is the number of cycles in the period. `progress` is called with the time reached [s].

    Notes
    -----
    Integrals are available at the end of a run only. Two runs with equal integration steps are therefore necessary: one
    ends at the start of the period, the other at its end.
    """
    energy, kernel = energy_kernel(circuit)
    problem = replace(circuit.instance, kernel=kernel).problem(run)
    start, end = _breakpoint_at(problem, period[0]), period[1]
    failures = tuple(condition for condition in problem.stop_conditions if condition.is_failure)
    longest = min(problem.maximum_step, (end - start) / MIN_STEPS)
    problem = replace(_with_breakpoint(problem, start), stop_conditions=failures, maximum_step=longest)
    # The first row of a run is its initial state.
    before = [] if start == 0.0 else [0.0]
    rows = np.linspace(start, end, ROWS + 1)
    for factor in FACTORS:
        problem = replace(problem, relative_tolerance=max(factor * run.tolerance, TIGHTEST))
        whole = _run_until(problem, [*before, *rows], progress)
        if whole.outcome is not Outcome.STALLED:
            break
    if is_failure(problem, whole):
        raise SimulationError(ending(problem, whole), None)
    values, initial = whole.values[:, len(before) :], problem.x0
    if before:
        first, states = _run_until(problem, [0.0, start], progress), list(energy.states)
        assert np.array_equal(first.values[states, -1], values[states, 0]), "two runs have different steps"
        initial = first.x
    return EnergyRun(energy, count, (whole.x - initial) / count, rows, values)


def _run_until(problem: Problem, grid: Sequence[float], progress: Callable[[float], Any] | None) -> RawRun:
    """Run a problem until the last of other output times."""
    # The segments of the inputs determine where a run ends.
    n = int(np.searchsorted(problem.starts, grid[-1]))
    segments = {name: getattr(problem, name)[:n] for name in ("starts", "courses", "jumps")}
    return run_kernel(replace(problem, grid=np.array(grid), **segments), progress)


def _breakpoint_at(problem: Problem, time: float) -> float:
    """Return the time of a breakpoint that differs from a time only by rounding errors, or else this time [s]."""
    near = float(problem.starts[np.argmin(np.abs(problem.starts - time))])
    return near if abs(near - time) <= ROUNDING * time else time


def _with_breakpoint(problem: Problem, time: float) -> Problem:
    """Return a problem in which an integration step ends exactly at a given time [s]."""
    k = int(np.searchsorted(problem.starts, time))
    if k < problem.starts.size and problem.starts[k] == time:
        return problem
    return replace(
        problem,
        starts=np.insert(problem.starts, k, time),
        courses=np.insert(problem.courses, k, problem.courses[k - 1]),
        jumps=np.insert(problem.jumps, k, False),
    )
