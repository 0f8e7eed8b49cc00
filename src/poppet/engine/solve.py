"""Run a problem: with the kernel, and where that stalls with tighter tolerances and other methods."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.engine.call import Call
from poppet.engine.problem import Outcome, Problem, RawRun

TIGHTER, TIGHTEST = (0.1, 0.01, 1e-3, 1e-4), 1e-13
"""Factors on the tolerance with which a run that stalled is repeated, and the tightest tolerance: a stall is often a
step too long for a contact or a check valve that opens and closes. Milliseconds each, where what comes after them may
take minutes."""
DEARER, MOST_DEAR = 50, 20_000
"""Attempts of the kernel for which there is one of Radau, the last resort, and how many at most: a minute of them."""


def solve(
    problem: Problem,
    solver: str = "rosenbrock",
    progress: Callable[[float], Any] | None = None,
    *,
    hands_over: bool = True,
) -> RawRun:
    """Run a problem."""
    if solver == "rosenbrock":
        run = kernel_run(problem, progress)
        if run.outcome is Outcome.STALLED and hands_over:
            return _handed_over(problem, run, progress)
        return run
    from poppet.engine.reference_solvers.solvers import SOLVERS, solve_otherwise

    if solver not in SOLVERS:
        raise InputError(
            "fields.not_an_option",
            "run.solver",
            value=solver,
            meaning="solver",
            near=NameSuggestion(solver, ("rosenbrock", *SOLVERS)),
        )
    return solve_otherwise(problem, solver, progress)


def kernel_run(problem: Problem, progress: Callable[[float], Any] | None = None) -> RawRun:
    """Run a problem with the Rosenbrock kernel, whatever comes of it."""
    return Call(problem).made(progress)


def _handed_over(problem: Problem, stalled: RawRun, progress: Callable[[float], Any] | None) -> RawRun:
    """Repeat a run that stalled, with tighter tolerances first and a Newton-based method then, and say so."""
    from poppet.engine.reference_solvers.solvers import solve_otherwise

    # From the first numbers each time: where the stalled run has got to may be wrong already.
    for tolerance in dict.fromkeys(max(factor * problem.relative_tolerance, TIGHTEST) for factor in TIGHTER):
        run = kernel_run(replace(problem, relative_tolerance=tolerance), progress)
        if run.outcome is Outcome.TOO_MANY:
            break  # more digits want more attempts still
        if run.outcome is not Outcome.STALLED:
            return _with_note(run, Note("run.repeated", time=stalled.reached, tolerance=tolerance))
    most = problem.most_attempts
    for solver, attempts in (("cvodes", most), ("radau", min(most // DEARER, MOST_DEAR))):
        run = solve_otherwise(replace(problem, most_attempts=attempts), solver)
        if run.outcome.is_success:
            return _with_note(run, Note("run.handed_over", time=stalled.reached, solver=solver))
    return _with_note(stalled, Note("run.no_way_on"))


def _with_note(run: RawRun, note: Note) -> RawRun:
    return replace(run, notes=(*run.notes, note))
