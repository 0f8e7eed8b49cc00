"""Solution of a problem with the Rosenbrock kernel or another solver.

If the kernel stalls, the run is repeated with tighter tolerances, then with other solvers.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.engine.call import Call
from poppet.engine.problem import Outcome, Problem, RawRun

TIGHTER, TIGHTEST = (0.1, 0.01, 1e-3, 1e-4), 1e-13
"""Factors on the tolerance for repeated runs, and the tightest tolerance.

A run often stalls because a step is too long for a contact or check valve that opens and closes. A repeated run takes
milliseconds, other solvers can take minutes."""
RADAU_COST, MAX_RADAU_ATTEMPTS = 50, 20_000
"""Kernel attempts per attempt of Radau, the last resort, and the maximum of Radau: about a minute."""


def solve(
    problem: Problem,
    solver: str = "rosenbrock",
    progress: Callable[[float], Any] | None = None,
    *,
    repeats_stalled: bool = True,
) -> RawRun:
    """Run a problem with the selected solver.

    If the Rosenbrock kernel stalls, the run is repeated with tighter tolerances, then with other solvers. The result
    then contains a note on the repetition. The keyword `repeats_stalled` can prevent the repetition.
    """
    stalled = run_kernel(problem, progress) if solver == "rosenbrock" else None
    if stalled is not None and (stalled.outcome is not Outcome.STALLED or not repeats_stalled):
        return stalled
    from poppet.engine.reference_solvers.solvers import SOLVERS, solve_with_reference

    if stalled is None:
        if solver not in SOLVERS:
            near = NameSuggestion(solver, ("rosenbrock", *SOLVERS))
            raise InputError("fields.not_an_option", "run.solver", value=solver, meaning="solver", suggestion=near)
        return solve_with_reference(problem, solver, progress)
    # From the initial state, because the end of the stalled run can be inaccurate.
    for tolerance in dict.fromkeys(max(factor * problem.relative_tolerance, TIGHTEST) for factor in TIGHTER):
        run = run_kernel(replace(problem, relative_tolerance=tolerance), progress)
        if run.outcome is Outcome.TOO_MANY:
            break  # tighter tolerances need more attempts
        if run.outcome is not Outcome.STALLED:
            return replace(run, notes=(*run.notes, Note("run.repeated", time=stalled.reached, tolerance=tolerance)))
    max_attempts = problem.most_attempts
    for fallback, attempts in (
        ("cvodes", max_attempts),
        ("radau", min(max_attempts // RADAU_COST, MAX_RADAU_ATTEMPTS)),
    ):
        run = solve_with_reference(replace(problem, most_attempts=attempts), fallback, progress)
        if run.outcome.is_success or run.outcome is Outcome.INTERRUPTED:
            return replace(run, notes=(*run.notes, Note("run.handed_over", time=stalled.reached, solver=fallback)))
    return replace(stalled, notes=(*stalled.notes, Note("run.no_way_on")))


def run_kernel(problem: Problem, progress: Callable[[float], Any] | None = None) -> RawRun:
    """Run a problem with the compiled Rosenbrock integrator of poppet.

    A run that stalls is not repeated with another solver.
    """
    return Call(problem).run(progress)
