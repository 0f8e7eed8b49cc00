"""Arrays that describe a run and its result, and the possible outcomes of a run."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.engine.kernel import Kernel

Array = NDArray[np.float64]

MOST_ATTEMPTS = 20_000_000
EMPTY = 1e-6
"""Fraction of the initial content below which a gas node is empty."""


class Outcome(enum.Enum):
    """Outcome of a run, for example complete or stalled.

    The value is a message code. The function `ending` returns the message as a note with facts.
    """

    # In the order of the status values of the integrator.
    DONE = "run.done"
    STOPPED = "run.stopped"
    STALLED = "run.stalled"
    TOO_MANY = "run.too_many"
    NOT_FINITE = "run.not_finite"
    INTERRUPTED = "run.interrupted"

    @property
    def is_success(self) -> bool:
        """True if the run reached its end time or a stop condition."""
        return self in (Outcome.DONE, Outcome.STOPPED)


class StopCondition(NamedTuple):
    """Condition on one or two outputs that stops a run.

    With the vector of outputs y, the run stops if ``weights[0]*y[places[0]] + weights[1]*y[places[1]] + weights[2]`` is
    positive.
    """

    reason: Note  # `run.condition_met` or `run.left_domain`; `ending` adds the time to its facts
    places: tuple[int, int]  # indices of outputs, -1 for none
    weights: tuple[float, float, float]

    @property
    def is_failure(self) -> bool:
        """True if the stop means that a stroke has left the domain of its characteristic.

        It is False for the stop conditions of the user.
        """
        return self.reason.code == "run.left_domain"


@dataclass(frozen=True)
class Problem:
    """Complete definition of one run as arrays: model, parameters, inputs and options.

    Solvers do not change the arrays.
    """

    kernel: Kernel
    p: Array  # (n_parameters + n_memory,) parameters, then the discrete state at the start
    x0: Array  # (n_states,) initial state, quadratures included
    starts: Array  # (n_segments,) breakpoints of the inputs [s]
    courses: NDArray[np.int64]  # (n_segments,) index of the coefficients of each segment
    coefficients: Array  # (n_courses, n_inputs, 7) inputs, as `poppet.timeseries.segments` writes them
    jumps: NDArray[np.bool_]  # (n_segments,) True if an input is discontinuous at the start of the segment
    grid: Array  # (n_times,) output times, the last one is the end [s]
    relative_tolerance: float = 1e-6
    stop_conditions: tuple[StopCondition, ...] = ()
    maximum_step: float = np.inf  # longest step [s]
    most_attempts: int = MOST_ATTEMPTS  # maximum number of attempted steps


def constant_input_problem(kernel: Kernel, p: Array, x0: Array, u: Array, grid: Array, **fields: float) -> Problem:
    """Return the definition of a run from t = 0 with constant inputs u, (n_inputs,).

    p is the parameter vector, `x0` the initial state, and `grid` contains the output times. Keyword arguments are
    further fields of `Problem`.
    """
    start, course, jump = np.zeros(1), np.zeros(1, dtype=np.int64), np.zeros(1, dtype=np.bool_)
    return Problem(kernel, p, x0, start, course, constant_coefficients(u), jump, grid, **fields)  # type: ignore[arg-type]


def constant_coefficients(u: Array, begin: float = 0.0) -> Array:
    """Return the coefficients of a single segment with constant inputs u.

    The segment begins at the time `begin` [s]. Without inputs, the array has one column.
    """
    coefficients = np.zeros((1, max(1, u.size), 7))
    coefficients[0, : u.size, 0], coefficients[:, :, 6] = u, begin
    return coefficients


@dataclass(frozen=True)
class RawRun:
    """Result of a run by any solver, as plain arrays."""

    outcome: Outcome
    time: Array  # (n_times,) output times reached [s]
    values: Array  # (n_outputs, n_times) outputs
    x: Array  # (n_states,) state at the end
    extremes: Array  # (2, n_states) minimum and maximum of each state over all steps
    through: Array  # (n_states,) sum of |change| of each state over all steps
    accepted: int  # steps
    rejected: int
    stop: int = -1  # index of the stop condition that was met, or -1
    notes: tuple[Note, ...] = ()

    @property
    def attempts(self) -> int:
        """Number of accepted and rejected steps."""
        return self.accepted + self.rejected

    @property
    def reached(self) -> float:
        """Time of the last output row [s].

        The value is 0 if there are no rows.
        """
        return float(self.time[-1]) if self.time.size else 0.0


def is_failure(problem: Problem, run: RawRun) -> bool:
    """Return True if a run has failed.

    A run that reaches its end or a stop condition of the user has not failed.
    """
    return not run.outcome.is_success or (run.stop >= 0 and problem.stop_conditions[run.stop].is_failure)


def ending(problem: Problem, run: RawRun) -> Note:
    """Return a note on how a run ended, with the time and the cause."""
    if run.outcome is Outcome.STOPPED:
        reason = problem.stop_conditions[run.stop].reason
        return Note(reason.code, reason.address, **reason.facts, time=run.reached)
    if run.outcome.is_success:
        return Note(run.outcome.value)
    facts = {"time": run.reached, "attempts": run.attempts}
    states = problem.kernel.model.states
    empty = [(run.x[k], s.name) for k, s in enumerate(states) if s.positive and run.x[k] < EMPTY * problem.x0[k]]
    if empty and run.outcome in (Outcome.STALLED, Outcome.TOO_MANY):
        # The gas node with the smallest content.
        amount, name = min(empty)
        return Note(f"run.emptied.{run.outcome.name.lower()}", name, **facts, amount=float(amount))
    return Note(f"run.ended.{run.outcome.name.lower()}", **facts)
