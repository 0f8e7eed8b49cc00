"""Comparison of a run by an export target with the same run by the kernel.

The kernel also repeats its run with slightly changed problems. The comparison ends where these repetitions diverge.
"""

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

START_CHANGE = 1e-14
"""Relative change of the start state that represents rounding errors."""
TOLERANCE_CHANGE = 1e-8
"""Relative change of the tolerance that represents rounding errors: it slightly changes the error of each step."""
TOLERANCE_FRACTIONS = (0.1, 0.03, 0.01)
"""Tolerances of the kernel divided by the limit of a check. The errors at these tolerances represent another method."""
MARGIN = 10.0
"""Maximum ratio of a difference to the effect that small changes of the problem have on the kernel."""
MAX_EFFECT = 1e-6
"""Relative effect of small changes on the kernel above which a run is no longer compared."""


class ReferenceRun(NamedTuple):
    """Run by poppet's own integrator, with which other runs are compared."""

    problem: Problem
    values: Array  # (n_outputs, n_times)
    sizes: Array  # (n_outputs,) maximum magnitude, or nominal size of a state
    accepted: int  # steps

    @property
    def gas(self) -> Flags:
        """Mask of the outputs that are states of a gas: pressures and masses."""
        return self._outputs({state.name for state in self.problem.kernel.model.states if state.positive})

    @property
    def states(self) -> Flags:
        """Mask of the outputs that are continuous states, which do not jump."""
        return self._outputs({state.name for state in self.problem.kernel.model.states})

    def _outputs(self, names: Container[str]) -> Flags:
        return np.array([name in names for name in self.problem.kernel.model.columns[0]], dtype=np.bool_)


class RunComparison(NamedTuple):
    """Differences between a run and the reference run, relative to the size of each output."""

    differences: Array  # (n_outputs, n_times)
    allowed: Array  # (n_outputs, n_times)
    is_available: Flags  # (n_outputs, n_times) cells of the run
    is_compared: Flags  # (n_outputs, n_times) cells that are compared
    n_rows: int  # up to which the states of the gas are compared

    def max_differences(self, *, whole_run: bool = False) -> Array:
        """Return the largest difference of each output at its compared times, (n_outputs,).

        If the keyword `whole_run` is True, all times of the run are compared. The result is -1 for an output that is
        not compared at any time.
        """
        cells = self.is_available if whole_run else self.is_compared
        return np.asarray(np.where(cells, self.differences, -1.0).max(axis=1, initial=-1.0))

    def max_ratios(self) -> Array:
        """Return the largest ratio of difference to permitted difference, (n_outputs,).

        The result is -1 for an output that is not compared at any time.
        """
        ratios = np.where(self.is_compared, self.differences / self.allowed, -1.0)
        return np.asarray(ratios.max(axis=1, initial=-1.0))


def without_fused_operations(problem: Problem) -> Problem:
    """Return the definition of a run whose kernel has no fused operations (FMA).

    The kernel contains the compiled model functions. Like the exported C code, it then rounds after each operation.
    """
    kernel, p = compile_kernel(problem.kernel.model, fuses=False), problem.p.copy()
    return replace(problem, kernel=kernel, p=p, x0=kernel.start(p))


def run_reference(problem: Problem, n_rows: int) -> ReferenceRun:
    """Run a problem with poppet's own integrator, as the reference for comparisons.

    Only the first `n_rows` output times are kept. If a stop condition ends the run, the last time is omitted, because
    it depends on rounding.
    """
    run = Call(problem).run()
    model = problem.kernel.model
    nominal = {state.name: state.nominal for state in model.states}
    magnitudes = np.abs(run.values).max(axis=1, initial=0.0)
    sizes = np.array([max(a, nominal.get(name, 0.0)) for name, a in zip(model.columns[0], magnitudes, strict=True)])
    # If a condition ends the run, the time of the last row depends on the code.
    n_common = run.time.size - (run.time.size < problem.grid.size)
    return ReferenceRun(problem, run.values[:, : min(n_rows, n_common)], sizes, run.accepted)


def relative_differences(values: Array, reference: ReferenceRun) -> Array:
    """Return the absolute differences of outputs from the reference, divided by their size.

    The result has shape (n_outputs, n_times). A difference that is not finite becomes infinite. If the size of an
    output is 0, its difference is not divided.
    """
    n = min(values.shape[1], reference.values.shape[1])
    differences = np.abs(values[:, :n] - reference.values[:, :n])
    np.divide(differences, reference.sizes[:, None], out=differences, where=reference.sizes[:, None] > 0.0)
    return np.where(np.isfinite(differences), differences, np.inf)


def change_effects(reference: ReferenceRun, problems: Iterable[Problem]) -> Array:
    """Return the effect of small changes of the problem on each output.

    `problems` are slightly changed copies of the problem. The result has shape (n_outputs, n_times). Each value is the
    largest relative difference of an output from the reference up to this time.
    """
    effects = np.zeros(reference.values.shape)
    for problem in problems:
        run = Call(problem).run()
        if run.outcome.is_success:
            differences = relative_differences(run.values, reference)
            n = differences.shape[1]
            effects[:, :n] = np.maximum(effects[:, :n], differences)
            effects[:, n:] = np.inf  # a run that ends earlier is not comparable
    return np.maximum.accumulate(effects, axis=1)


def rounding_changes(problem: Problem) -> list[Problem]:
    """Return three copies of a problem with changes as small as rounding errors.

    Two copies have another start state, and one has another tolerance.
    """
    starts = [replace(problem, x0=problem.x0 * (1.0 + sign * START_CHANGE)) for sign in (1.0, -1.0)]
    return [*starts, replace(problem, relative_tolerance=problem.relative_tolerance * (1.0 + TOLERANCE_CHANGE))]


def tolerance_changes(problem: Problem, limit: float) -> list[Problem]:
    """Return copies of a problem with tolerances that are fractions of `limit`.

    The errors of these runs represent the errors of another integration method.
    """
    return [replace(problem, relative_tolerance=fraction * limit) for fraction in TOLERANCE_FRACTIONS]


def compare_runs(
    values: Array, reference: ReferenceRun, effects: Array, limit: float, is_available: Flags
) -> RunComparison:
    """Compare a run with the reference run of the kernel at each output time.

    The kernel is poppet's own integrator. The permitted difference of an output is the larger of the limit and ten
    times the effect of small changes of the problem. If this effect becomes too large, the output is not compared at
    later times. If the output is a state of a gas, no output is compared at later times.

    Parameters
    ----------
    values : ndarray, shape (n_outputs, n_times)
        Values of the run.
    reference : ReferenceRun
        Run of the kernel.
    effects : ndarray, shape (n_outputs, n_times)
        Effects of small changes, from `change_effects`.
    limit : float
        Permitted difference relative to the size of an output.
    is_available : ndarray of bool, shape (n_outputs, n_times)
        True where the run has a value.

    Returns
    -------
    RunComparison
    """
    differences = relative_differences(values, reference)
    n = differences.shape[1]
    effects, is_available = effects[:, :n], is_available[:, :n]
    is_compared = effects <= max(limit / MARGIN, MAX_EFFECT)
    is_lost = ~is_compared[reference.gas].all(axis=0)
    n_rows = int(is_lost.argmax()) if is_lost.any() else n
    is_compared &= is_available
    is_compared[:, n_rows:] = False
    return RunComparison(differences, np.maximum(limit, MARGIN * effects), is_available, is_compared, n_rows)
