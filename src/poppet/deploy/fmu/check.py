"""An FMU against Python: the same run by a host (FMPy) and by the kernel, and how far their outputs are apart."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.deploy.fmu.plan import FOLLOWS, structured
from poppet.engine.call import Call
from poppet.engine.problem import Problem, RawRun
from poppet.ground.errors import needed

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

Array = NDArray[np.float64]
EXCHANGE_TOLERANCE = 1e-9
"""Relative tolerance of the host's CVODE, whose errors add up over a run."""


class Difference(NamedTuple):
    """How far an output is from Python's."""

    kind: str  # CoSimulation or ModelExchange
    output: str
    greatest: float  # in the unit of the output
    size: float  # greatest magnitude of the output, or its usual size
    when: float  # [s]

    @property
    def relative(self) -> float:
        """Greatest difference over the size."""
        return self.greatest / self.size if self.size else self.greatest


class Checked(NamedTuple):
    """What a check has found."""

    differences: tuple[Difference, ...]
    seconds: dict[str, float]  # of each kind, and of the kernel
    problems: tuple[str, ...]  # of the description, as FMPy's validation says


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


def kernel_run(circuit: Circuit, *, meets: bool) -> RawRun:
    """The run of a circuit by the kernel, which `meets` a host at every row, and one row further.

    The last row of a run shows its memory before an instant that falls on it, all others after it, as hosts have it.
    """
    problem = circuit.problem(circuit.run)
    points = np.append(problem.grid, 2.0 * problem.grid[-1] - problem.grid[-2])
    return Call(with_points(problem, points) if meets else replace(problem, grid=points)).made()


def check_fmu(path: Path, circuit: Circuit, kinds: Sequence[str] = ("CoSimulation", "ModelExchange")) -> Checked:
    """Run an FMU in FMPy and its circuit in Python, over the circuit's own run and with its signals.

    Parameters
    ----------
    path : Path
        An FMU.
    circuit : Circuit
        That it was made of.
    kinds : sequence of str, optional
        `CoSimulation`, which is compared with the kernel that ends its steps at the same points, and `ModelExchange`,
        which FMPy integrates with CVODE; with the kernel at a tolerance of 1e-9. There outputs of whole numbers, as
        regimes, are left out: they change a hair sooner or later.

    Returns
    -------
    Checked
    """
    with needed("FMPy", "running an FMU", "check"):
        import fmpy as host
        from fmpy.validation import validate_fmu

    description = host.read_model_description(str(path))
    own = {v.name: v for v in description.modelVariables}
    addresses = [(k, a) for k, (a, _) in enumerate(circuit.model.outputs) if structured(a) in own]
    grid = circuit.run.grid()
    found: list[Difference] = []
    seconds: dict[str, float] = {}
    for kind in kinds:
        sharp = (
            circuit if kind == "CoSimulation" else circuit.with_values({"run.relative_tolerance": EXCHANGE_TOLERANCE})
        )
        began = time.perf_counter()
        run = kernel_run(sharp, meets=kind == "CoSimulation")
        seconds["kernel"] = time.perf_counter() - began
        rows, seconds[kind] = _hosted(host, path, kind, grid, [structured(a) for _, a in addresses], FOLLOWS in own)
        for k, address in addresses:
            # A run that a stop condition ends has fewer rows, the last of which no grid has.
            n = min(grid.size, run.time.size - 1, len(rows))
            ours, theirs = run.values[k, :n], rows[structured(address)][:n]
            if kind != "CoSimulation" and not np.any(ours % 1.0):
                continue
            apart = np.abs(ours - theirs)
            at = int(apart.argmax())
            size = max(float(np.abs(ours).max()), _usual(circuit, address))
            found.append(Difference(kind, address, float(apart[at]), size, float(grid[at])))
    return Checked(tuple(found), seconds, tuple(validate_fmu(str(path))))


def _usual(circuit: Circuit, address: str) -> float:
    return next((s.nominal for s in circuit.model.states if s.name == address), 0.0)


def _hosted(host: Any, path: Path, kind: str, grid: Array, names: list[str], follows: bool) -> tuple[Any, float]:
    """Rows of a run by FMPy at the times of the grid, and how long it took."""
    values = {FOLLOWS: True} if follows else {}
    step = float(grid[1] - grid[0])
    more = {} if kind == "CoSimulation" else {"solver": "CVode", "relative_tolerance": EXCHANGE_TOLERANCE}
    began = time.perf_counter()
    rows = host.simulate_fmu(
        str(path), fmi_type=kind, start_time=0.0, stop_time=float(grid[-1]), output_interval=step,
        start_values=values, output=names, **more,
    )  # fmt: skip
    took = time.perf_counter() - began
    # Of rows at one time, before and after an event, the last.
    times = rows["time"]
    grid = grid[grid <= times[-1] + 1e-6 * step]
    places = np.searchsorted(times, grid + 1e-6 * step, side="right") - 1
    return rows[places], took
