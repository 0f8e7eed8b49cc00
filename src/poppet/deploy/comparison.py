"""How far a run is from the kernel's, as far as that means anything: while the kernel agrees with itself."""

from __future__ import annotations

from collections.abc import Container, Iterable
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.engine.call import Call
from poppet.engine.kernel import compile_kernel
from poppet.engine.problem import Problem

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

ROUNDING = 1e-14
"""By what a start is moved, to see what rounding alone becomes in a run."""
ROUNDED_STEPS = 1e-8
"""By what a tolerance is moved, which moves the error of each step by rounding."""
LOOSER = (0.1, 0.03, 0.01)
"""Tolerances of the kernel, by the limit of another method, whose errors stand for those of that method."""
GROWN = 10.0
"""Times what the kernel makes of such a change, that another code may make of its own."""
FOLLOWED = 1e-6
"""What such a change may have become for a run to be followed still."""


class ReferenceRun(NamedTuple):
    """A run of the kernel that others are held beside."""

    problem: Problem
    values: Array  # (n_outputs, n_times)
    sizes: Array  # (n_outputs,) greatest magnitude, or usual size of a state
    accepted: int  # steps

    @property
    def gas(self) -> Flags:
        """Outputs that are pressures and masses: states that are always positive."""
        return self._outputs({state.name for state in self.problem.kernel.model.states if state.positive})

    @property
    def states(self) -> Flags:
        """Outputs that are states: they do not jump."""
        return self._outputs({state.name for state in self.problem.kernel.model.states})

    def _outputs(self, names: Container[str]) -> Flags:
        return np.array([name in names for name in self.problem.kernel.model.columns[0]], dtype=np.bool_)


class RunComparison(NamedTuple):
    """What a comparison has found."""

    apart: Array  # (n_outputs, n_times) differences by the size of each output
    allowed: Array  # (n_outputs, n_times)
    counted: Flags  # (n_outputs, n_times) what the run has
    is_followed: Flags  # (n_outputs, n_times) where they are compared
    rows: int  # up to which the states of gas are followed

    def greatest(self, *, is_all: bool = False) -> Array:
        """Greatest difference of each output that is compared, or in the whole run; -1 where there is none."""
        where = self.counted if is_all else self.is_followed
        return np.asarray(np.where(where, self.apart, -1.0).max(axis=1, initial=-1.0))

    def ratios(self) -> Array:
        """Greatest difference of each output by what is allowed where it lies; -1 where nothing is compared."""
        return np.asarray(np.where(self.is_followed, self.apart / self.allowed, -1.0).max(axis=1, initial=-1.0))


def separate(problem: Problem) -> Problem:
    """The problem with a kernel that fuses no multiplication with an addition, as sources in C have it."""
    kernel, p = compile_kernel(problem.kernel.model, fuses=False), problem.p.copy()
    return replace(problem, kernel=kernel, p=p, x0=kernel.start(p))


def beside(problem: Problem, rows: int) -> ReferenceRun:
    """The kernel's run of a problem, of whose grid so many rows count."""
    run = Call(problem).run()
    model = problem.kernel.model
    nominal = {state.name: state.nominal for state in model.states}
    greatest = np.abs(run.values).max(axis=1, initial=0.0)
    sizes = np.array([max(a, nominal.get(name, 0.0)) for name, a in zip(model.columns[0], greatest, strict=True)])
    # The last row of a run that a condition ends lies where each code finds it.
    reached = run.time.size - (run.time.size < problem.grid.size)
    return ReferenceRun(problem, run.values[:, : min(rows, reached)], sizes, run.accepted)


def apart(values: Array, of: ReferenceRun) -> Array:
    """Differences by the size of each output, (n_outputs, n_times); of what is no number infinite."""
    n = min(values.shape[1], of.values.shape[1])
    found = np.abs(values[:, :n] - of.values[:, :n])
    np.divide(found, of.sizes[:, None], out=found, where=of.sizes[:, None] > 0.0)
    return np.where(np.isfinite(found), found, np.inf)


def grown(of: ReferenceRun, problems: Iterable[Problem]) -> Array:
    """What the kernel has made of small changes of its problem up to each row, (n_outputs, n_times)."""
    found = np.zeros(of.values.shape)
    for problem in problems:
        run = Call(problem).run()
        if run.outcome.is_success:
            moved = apart(run.values, of)
            found[:, : moved.shape[1]] = np.maximum(found[:, : moved.shape[1]], moved)
            found[:, moved.shape[1] :] = np.inf  # a run that ends earlier is another one
    return np.maximum.accumulate(found, axis=1)


def rounded(problem: Problem) -> list[Problem]:
    """The same problem, otherwise rounded."""
    starts = [replace(problem, x0=problem.x0 * (1.0 + sign * ROUNDING)) for sign in (1.0, -1.0)]
    return [*starts, replace(problem, relative_tolerance=problem.relative_tolerance * (1.0 + ROUNDED_STEPS))]


def loosened(problem: Problem, limit: float) -> list[Problem]:
    """The same problem to tolerances as other methods have them."""
    return [replace(problem, relative_tolerance=share * limit) for share in LOOSER]


def compare(values: Array, of: ReferenceRun, grown: Array, limit: float, counted: Flags) -> RunComparison:
    """Hold a run beside the kernel's, row by row, as long as that is followed.

    An output may differ by the limit, or by `GROWN` times what small changes have become in it. Where these are more
    than can be followed, the output is left alone from there on, and once that is so of a state of gas, all are.

    Parameters
    ----------
    values : ndarray, shape (n_outputs, n_times)
        Of the run.
    of : Beside
    grown : ndarray, shape (n_outputs, n_times)
        What small changes become.
    limit : float
        By the size of an output.
    counted : ndarray of bool, shape (n_outputs, n_times)
        What is compared.

    Returns
    -------
    Compared
    """
    found = apart(values, of)
    n = found.shape[1]
    grown, counted = grown[:, :n], counted[:, :n]
    is_followed = grown <= max(limit / GROWN, FOLLOWED)
    lost = ~is_followed[of.gas].all(axis=0)
    rows = int(lost.argmax()) if lost.any() else n
    is_followed &= counted
    is_followed[:, rows:] = False
    return RunComparison(found, np.maximum(limit, GROWN * grown), counted, is_followed, rows)
