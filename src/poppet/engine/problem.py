"""What a run is handed and what it hands back, in plain arrays; and how a run can end, as codes."""

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
"""A store that has fallen to this part of what it held at the start counts as emptied."""


class Outcome(enum.Enum):
    """How a run ended; the value is its code, and `ending` says more."""

    # In the order of the integrator's status.
    DONE = "run.done"
    STOPPED = "run.stopped"
    STALLED = "run.stalled"
    TOO_MANY = "run.too_many"
    NOT_FINITE = "run.not_finite"
    INTERRUPTED = "run.interrupted"

    @property
    def is_success(self) -> bool:
        """True when the result is what was asked for."""
        return self in (Outcome.DONE, Outcome.STOPPED)


class StopCondition(NamedTuple):
    """A run stops when ``weights[0]*y[places[0]] + weights[1]*y[places[1]] + weights[2]`` becomes positive."""

    reason: Note  # why the run ends here, `run.condition_met` or `run.left_domain`; the time is added to its facts
    places: tuple[int, int]  # -1 for none
    weights: tuple[float, float, float]

    @property
    def is_failure(self) -> bool:
        """True for a condition that nobody asked for: the run left the domain of a characteristic."""
        return self.reason.code == "run.left_domain"


@dataclass(frozen=True)
class Problem:
    """All that one run needs, in plain arrays, which no solver writes into."""

    kernel: Kernel
    p: Array  # (n_parameters + n_memory,) run-time numbers, and behind them the sampled memory at the start
    x0: Array  # (n_states,) initial state, quadratures included
    starts: Array  # (n_segments,) breakpoints of the inputs [s]
    courses: NDArray[np.int64]  # (n_segments,) which set of coefficients holds on each segment
    coefficients: Array  # (n_courses, n_inputs, 7) inputs, as `poppet.timeseries.segments` writes them
    jumps: NDArray[np.bool_]  # (n_segments,) true where an input is discontinuous
    grid: Array  # (n_times,) output times, the last one is the end [s]
    relative_tolerance: float = 1e-6
    stop_conditions: tuple[StopCondition, ...] = ()
    maximum_step: float = np.inf  # longest step [s]
    most_attempts: int = MOST_ATTEMPTS  # of steps


def constant_input_problem(kernel: Kernel, p: Array, x0: Array, u: Array, grid: Array, **more: float) -> Problem:
    """A run from t = 0 on whose inputs u, (n_inputs,), are held; `more` are further fields of a problem."""
    start, course, jump = np.zeros(1), np.zeros(1, dtype=np.int64), np.zeros(1, dtype=np.bool_)
    return Problem(kernel, p, x0, start, course, constant_coefficients(u), jump, grid, **more)  # type: ignore[arg-type]


def constant_coefficients(u: Array, begin: float = 0.0) -> Array:
    """Coefficients of one segment from `begin` on, on which inputs are held; without inputs there is room for one."""
    held = np.zeros((1, max(1, u.size), 7))
    held[0, : u.size, 0], held[:, :, 6] = u, begin
    return held


@dataclass(frozen=True)
class RawRun:
    """What a solver hands back."""

    outcome: Outcome
    time: Array  # (n_times,) output times reached [s]
    values: Array  # (n_outputs, n_times) outputs
    x: Array  # (n_states,) state at the end
    extremes: Array  # (2, n_states) least and greatest value of each state over all steps
    through: Array  # (n_states,) sum of |change| of each state over all steps
    accepted: int  # steps
    rejected: int
    stop: int = -1  # index of the stop condition that was met, or -1
    notes: tuple[Note, ...] = ()

    @property
    def attempts(self) -> int:
        """Accepted and rejected steps."""
        return self.accepted + self.rejected

    @property
    def reached(self) -> float:
        """Time of the last row, 0 without rows [s]."""
        return float(self.time[-1]) if self.time.size else 0.0


def is_failure(problem: Problem, run: RawRun) -> bool:
    """True when a run is not what was asked for: it ended before its time, or left the domain of a characteristic."""
    return not run.outcome.is_success or (run.stop >= 0 and problem.stop_conditions[run.stop].is_failure)


def ending(problem: Problem, run: RawRun) -> Note:
    """How a run ended, and what to try where it failed."""
    if run.outcome is Outcome.STOPPED:
        reason = problem.stop_conditions[run.stop].reason
        return Note(reason.code, reason.address, **reason.facts, time=run.reached)
    if run.outcome.is_success:
        return Note(run.outcome.value)
    after = {"time": run.reached, "attempts": run.attempts}
    states = problem.kernel.model.states
    low = [(run.x[k], s.name) for k, s in enumerate(states) if s.positive and run.x[k] < EMPTY * problem.x0[k]]
    if low and run.outcome in (Outcome.STALLED, Outcome.TOO_MANY):
        # Of several emptied stores the one with least left.
        amount, name = min(low)
        return Note(f"run.emptied.{run.outcome.name.lower()}", name, **after, amount=float(amount))
    return Note(f"run.ended.{run.outcome.name.lower()}", **after)
