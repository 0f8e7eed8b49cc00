"""What a run is handed and what it hands back, in plain arrays; and how a run can end, as codes."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.engine.kernel import Kernel
from poppet.ground.codes import Note

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
    """A run stops when ``weights[0]*y[places[0]] + weights[1]*y[places[1]] + weights[2]`` becomes positive.

    Parameters
    ----------
    reason : Note
        Why the run ends here, `run.condition_met` or `run.left_domain`; the time is added to its facts.
    places : tuple of int
        Two places in y, -1 for none.
    weights : tuple of float
        Two factors and the constant.
    """

    reason: Note
    places: tuple[int, int]
    weights: tuple[float, float, float]

    @property
    def is_failure(self) -> bool:
        """True for a condition that nobody asked for: the run left the domain of a characteristic."""
        return self.reason.code == "run.left_domain"


@dataclass(frozen=True)
class Problem:
    """All that one run needs, in plain arrays, which no solver writes into.

    Parameters
    ----------
    kernel : Kernel
        Compiled model.
    p : (n_parameters + n_memory,) array
        Run-time numbers, and behind them the sampled memory at the start.
    x0 : (n_states,) array
        Initial state, quadratures included.
    starts : (n_segments,) array
        Breakpoints of the inputs [s].
    coefficients : (n_segments, n_inputs, 6) array
        Inputs on each segment, as `poppet.series.segments` writes them.
    jumps : (n_segments,) array of bool
        True where an input is discontinuous.
    grid : (n_times,) array
        Output times, the last one is the end [s].
    relative_tolerance : float
        Tolerance of the run.
    stop_conditions : tuple of StopCondition
        Reasons to end early.
    maximum_step : float
        Longest step [s].
    most_attempts : int
        Step attempts allowed.
    """

    kernel: Kernel
    p: Array
    x0: Array
    starts: Array
    coefficients: Array
    jumps: NDArray[np.bool_]
    grid: Array
    relative_tolerance: float = 1e-6
    stop_conditions: tuple[StopCondition, ...] = ()
    maximum_step: float = np.inf
    most_attempts: int = MOST_ATTEMPTS


@dataclass(frozen=True)
class RawRun:
    """What a solver hands back.

    Parameters
    ----------
    outcome : Outcome
        How it ended.
    time : (n_times,) array
        Output times reached [s].
    values : (n_outputs, n_times) array
        Outputs.
    x : (n_states,) array
        State at the end.
    extremes : (2, n_states) array
        Least and greatest value of each state over all steps.
    through : (n_states,) array
        Sum of |change| of each state over all steps.
    accepted, rejected : int
        Steps.
    stop : int
        Index of the stop condition that was met, or -1.
    notes : tuple of Note
        What the user has to know.
    """

    outcome: Outcome
    time: Array
    values: Array
    x: Array
    extremes: Array
    through: Array
    accepted: int
    rejected: int
    stop: int = -1
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
        amount, name = min(low)
        return Note(f"run.emptied.{run.outcome.name.lower()}", name, **after, amount=float(amount))
    return Note(f"run.ended.{run.outcome.name.lower()}", **after)
