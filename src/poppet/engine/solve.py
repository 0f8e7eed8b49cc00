"""Run a compiled model: signals, tolerances and a time span in, series and residuals out."""

from __future__ import annotations

import enum
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.engine.kernel import Kernel
from poppet.ground.errors import InputError, suggestion

Array = NDArray[np.float64]

INTERNAL = 0.25
"""Relative tolerance inside the kernel per unit of the one asked for: it bounds the error of a step, and the errors of
steps and of the interpolant add up. Chosen so that the results, not the steps, keep the promise of `simulate`."""
MOST_ATTEMPTS = 20_000_000
TIGHTER, TIGHTEST = (0.1, 0.01), 1e-13
"""Factors on the tolerance with which a run that stalled is repeated, and the tightest tolerance: a stall is often a
step too long for a contact that opens and closes."""


class Outcome(enum.Enum):
    """How a run ended; the value is the sentence a person reads."""

    DONE = "The run reached its end."
    STOPPED = "A stop condition was met."
    STALLED = "The step size fell to nothing."
    TOO_MANY = "The run needed more steps than allowed."
    NOT_FINITE = "The model has no finite rates at the start."
    INTERRUPTED = "The run was interrupted."

    @property
    def is_success(self) -> bool:
        """True when the result is what was asked for."""
        return self in (Outcome.DONE, Outcome.STOPPED)


_OUTCOMES = tuple(Outcome)


@dataclass(frozen=True)
class StopCondition:
    """A run stops when ``sum(weights * outputs) + constant`` becomes positive.

    Parameters
    ----------
    text : str
        As it was written.
    places : tuple of int
        Two places in y, -1 for none.
    weights : tuple of float
        Two factors and the constant.
    """

    text: str
    places: tuple[int, int]
    weights: tuple[float, float, float]


@dataclass(frozen=True)
class Problem:
    """All that one run needs, in plain arrays.

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
    script : (n_steps,) array
        Receives the lengths of the accepted steps, as far as there is room; or gives them, with `replay`.
    replay : bool
        Take the steps of `script` without error control: runs that share their steps differ smoothly in p.
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
    script: Array = field(default_factory=lambda: np.zeros(0))
    replay: bool = False

    @cached_property
    def _arrays(self) -> tuple[NDArray[Any], ...]:
        """What the integrator reads and does not change, in its order."""
        kernel, conditions = self.kernel, self.stop_conditions
        return (
            kernel.addresses,
            kernel.sizes(self.starts.size, self.grid.size, len(conditions), self.script.size),
            self.p,
            self.starts,
            self.coefficients,
            self.jumps,
            self.grid,
            self.tolerance_table,
            kernel.positive,
            np.array([self.maximum_step, float(self.most_attempts), float(self.replay)]),
            np.array([c.places for c in conditions], dtype=np.int64),
            np.array([c.weights for c in conditions], dtype=np.float64),
            kernel.acting,
        )

    @cached_property
    def pointers(self) -> tuple[int, ...]:
        """Addresses of the arrays that the integrator only reads."""
        return tuple(array.ctypes.data for array in self._arrays)

    @cached_property
    def tolerance_table(self) -> Array:
        """`tolerances` as the integrator reads them, a (3, n) array."""
        return np.array(self.tolerances())

    def tolerances(self) -> tuple[Array, Array, Array]:
        """Relative and absolute tolerance and size of each controlled state, (n,) arrays each."""
        states = self.kernel.model.states
        initial = np.abs(self.x0[: len(states)])
        # What is never zero has a size of its own; a plate that happens to start near rest has not.
        scale = np.array([x if s.positive and x > 0.0 else s.nominal for x, s in zip(initial, states, strict=True)])
        rtol = INTERNAL * self.relative_tolerance * np.array([s.tolerance for s in states])
        return rtol, rtol * np.array([s.floor for s in states]) * scale, scale


@dataclass(frozen=True)
class Residual:
    """Conservation over a run.

    Parameters
    ----------
    name : str
        Store and quantity, `tank mass`.
    unit : str
        Its unit.
    error : float
        |change of inventory - integral of the flows|.
    through : float
        Integral of |flows|.
    inventory : float
        Largest inventory of start and end.
    """

    name: str
    unit: str
    error: float
    through: float
    inventory: float

    @property
    def allowed(self) -> float:
        """What a correct run may show: 1e-9 of the mass and 1e-7 of the energy that went through, and 1e-12 of the
        inventory."""
        return (1e-9 if self.unit == "kg" else 1e-7) * self.through + 1e-12 * self.inventory

    @property
    def is_kept(self) -> bool:
        """True when the balance holds."""
        return self.error <= self.allowed


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
    notes : tuple of str
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
    notes: tuple[str, ...] = field(default=())

    @property
    def attempts(self) -> int:
        """Accepted and rejected steps."""
        return self.accepted + self.rejected


def solve(
    problem: Problem,
    solver: str = "rosenbrock",
    progress: Callable[[float], Any] | None = None,
    *,
    hands_over: bool = True,
) -> RawRun:
    """Run a problem."""
    if solver == "rosenbrock":
        run = _rosenbrock(problem, progress)
        if run.outcome is Outcome.STALLED and hands_over:
            return _handed_over(problem, run, progress)
        return run
    from poppet.engine.checks.solvers import SOLVERS, solve_otherwise

    if solver not in SOLVERS:
        raise InputError(f"solver = {solver!r}", "is unknown.", suggestion(solver, ("rosenbrock", *SOLVERS)))
    return solve_otherwise(problem, solver, progress)


class Call:
    """One call of the integrator: the arrays that it writes into, and the addresses of all that it is handed.

    Parameters
    ----------
    problem : Problem
        What it reads; arrays of it that are changed in place count for the next call.
    """

    def __init__(self, problem: Problem) -> None:
        self.problem, n = problem, problem.x0.size
        self.x = problem.x0.copy()
        self.table = np.empty((len(problem.kernel.model.outputs), problem.grid.size))
        self.books, self.watch, self.counts = np.empty(3 * n), np.zeros(2), np.zeros(5, dtype=np.int64)
        self._memory = np.empty(problem.kernel.memory_size)
        written = (self.x, self.table, self.books, self.watch, self.counts, self._memory, problem.script)
        first, *others = (array.ctypes.data for array in written)
        # The integrator writes the sampled memory into p.
        self._p = problem.p.copy() if problem.kernel.model.memory else problem.p
        given = problem.pointers
        self.pointers = (*given[:2], first, self._p.ctypes.data, *given[3:], *others)

    def again(self) -> Outcome:
        """Integrate from the initial state of the problem into the same arrays."""
        self.x[:], self.counts[:], self._p[:] = self.problem.x0, 0, self.problem.p
        status: int = _integrator()(*self.pointers)
        return _OUTCOMES[status]

    @property
    def memory(self) -> Array:
        """Sampled memory as the last run left it."""
        return self._p[len(self.problem.kernel.model.parameters) :]

    def made(self, progress: Callable[[float], Any] | None = None) -> RawRun:
        """Integrate, once, and hand the arrays back."""
        function, n = _integrator(), self.x.size
        status = (
            function(*self.pointers) if progress is None else _watched(function, self.pointers, self.watch, progress)
        )
        accepted, attempts, rows, stop, _ = self.counts.tolist()
        time = self.problem.grid[:rows]
        if _OUTCOMES[status] is Outcome.STOPPED:
            time = np.append(time[:-1], self.watch[0])
        extremes, through = self.books[: 2 * n].reshape(2, n), self.books[2 * n :]
        return RawRun(
            _OUTCOMES[status], time, self.table[:, :rows], self.x, extremes, through,
            accepted, attempts - accepted, stop,
        )  # fmt: skip


def _rosenbrock(problem: Problem, progress: Callable[[float], Any] | None) -> RawRun:
    return Call(problem).made(progress)


@lru_cache(maxsize=1)
def _integrator() -> Any:
    """The compiled integrator as a function of pointers; it releases the interpreter's lock while it runs."""
    import ctypes

    from poppet.engine.compiled import integrator_address

    return ctypes.CFUNCTYPE(ctypes.c_int64, *[ctypes.c_void_p] * 20)(integrator_address())


def _watched(integrate: Any, arguments: Sequence[Any], watch: Array, progress: Callable[[float], Any]) -> int:
    """Integrate in a thread, so that this one can show progress and take Ctrl-C."""
    import threading

    result: list[int] = []
    # `Thread.join` is not waited on: interrupted, it takes a running thread for one that has ended.
    has_ended = threading.Event()

    def work() -> None:
        try:
            result.append(integrate(*arguments))
        finally:
            has_ended.set()

    threading.Thread(target=work, daemon=True).start()
    try:
        while True:
            is_over = has_ended.wait(0.1)
            progress(float(watch[0]))
            if is_over:
                break
    except KeyboardInterrupt:
        _ask_to_stop(has_ended, watch)
    except BaseException:
        _ask_to_stop(has_ended, watch)
        raise
    return result[0]


def _ask_to_stop(has_ended: Any, watch: Array) -> None:
    """Stop the integrator; its thread writes into this run's arrays, so it must not outlive the call."""
    import contextlib

    watch[1] = 1.0
    while not has_ended.is_set():
        with contextlib.suppress(KeyboardInterrupt):
            has_ended.wait()


def _handed_over(problem: Problem, stalled: RawRun, progress: Callable[[float], Any] | None) -> RawRun:
    """Repeat a run that stalled, with tighter tolerances first and a Newton-based method then, and say so."""
    from dataclasses import replace

    from poppet.engine.checks.solvers import solve_otherwise

    where = f"t = {stalled.time[-1]:.6g} s" if stalled.time.size else "the start"
    stall = f"The Rosenbrock method stalled after {where}; the run was"
    for tolerance in (max(factor * problem.relative_tolerance, TIGHTEST) for factor in TIGHTER):
        run = _rosenbrock(replace(problem, relative_tolerance=tolerance), progress)
        if run.outcome is not Outcome.STALLED:
            return _with_notes(run, f"{stall} repeated with the relative tolerance {tolerance:.1g}.")
    for solver in ("cvodes", "radau"):
        run = solve_otherwise(problem, solver)
        if run.outcome.is_success:
            return _with_notes(run, f"{stall} handed over to {solver}.")
    return _with_notes(stalled, "CVODES and Radau were tried after the stall and failed as well.")


def _with_notes(run: RawRun, *notes: str) -> RawRun:
    from dataclasses import replace

    return replace(run, notes=(*run.notes, *notes))


def residuals(problem: Problem, run: RawRun) -> tuple[Residual, ...]:
    """Mass residual of every store with a mass and energy residual of every store with an energy balance."""
    model = problem.kernel.model
    x0, x, through = problem.x0.tolist(), run.x.tolist(), run.through.tolist()
    before, after = _energies(problem, problem.x0), _energies(problem, run.x)
    result = []
    place = 0
    for store, ends in zip(model.stores, model.ends, strict=True):
        net = sum(sign * x[flow.mass] for flow, sign in ends)
        gross = sum(through[flow.mass] for flow, _ in ends)
        start, end = x0[store.mass], x[store.mass]
        result.append(Residual(f"{store.name} mass", "kg", abs(end - start - net), gross, max(start, end)))
        if store.has_energy:
            net = sum(sign * x[flow.enthalpy] for flow, sign in ends) + x[store.heat]
            gross = sum(through[flow.enthalpy] for flow, _ in ends) + through[store.heat]
            start, end = before[place], after[place]
            place += 1
            result.append(Residual(f"{store.name} energy", "J", abs(end - start - net), gross, max(start, end)))
    return tuple(result)


def _energies(problem: Problem, x: Array) -> list[float]:
    model = problem.kernel.model
    energy = np.empty(sum(store.has_energy for store in model.stores))
    if energy.size:
        u = np.zeros(max(1, len(model.inputs)))
        problem.kernel.call("energy", np.zeros(1), x, u, problem.p, energy)
    return energy.tolist()
