"""The call of the compiled integrator."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from poppet.engine.compiled import CompiledFunctions
from poppet.engine.problem import Array, Outcome, Problem, RawRun

_OUTCOMES = tuple(Outcome)
NO_SCRIPT = np.zeros(0)


class Call:
    """One call of the integrator: the arrays that it writes into, and the addresses of all that it is handed.

    Arrays of the problem are read where they lie: what their owner writes into them counts for the next `again`.

    Parameters
    ----------
    problem : Problem
        What it reads.
    script : (n_steps,) array
        Receives the lengths of the accepted steps, as far as there is room; or gives them, with `replay`.
    replay : bool
        Take the steps of `script` without error control: runs that share their steps differ smoothly in p.
    """

    def __init__(self, problem: Problem, script: Array = NO_SCRIPT, *, replay: bool = False) -> None:
        kernel, conditions, n = problem.kernel, problem.stop_conditions, problem.x0.size
        self.problem, self.x = problem, problem.x0.copy()
        self.table = np.empty((len(kernel.model.outputs), problem.grid.size))
        self.books, self.watch, self.counts = np.empty(3 * n), np.zeros(2), np.zeros(5, dtype=np.int64)
        # The integrator writes the sampled memory into p.
        self._p = problem.p.copy() if kernel.model.memory else problem.p
        self._tolerances = np.array(problem.tolerances())
        # In the order of the integrator's arguments, see there.
        self._arrays = (
            kernel.addresses,
            kernel.sizes(problem.starts.size, problem.grid.size, len(conditions), script.size),
            self.x,
            self._p,
            problem.starts,
            problem.coefficients,
            problem.jumps,
            problem.grid,
            self._tolerances,
            kernel.positive,
            np.array([problem.maximum_step, float(problem.most_attempts), float(replay)]),
            np.array([c.places for c in conditions], dtype=np.int64),
            np.array([c.weights for c in conditions], dtype=np.float64),
            kernel.acting,
            self.table,
            self.books,
            self.watch,
            self.counts,
            np.empty(kernel.memory_size),
            script,
        )
        self._pointers = tuple(array.ctypes.data for array in self._arrays)

    def again(self) -> Outcome:
        """Integrate from the initial state of the problem into the same arrays."""
        problem = self.problem
        self.x[:], self.counts[:], self._p[:] = problem.x0, 0, problem.p
        self._tolerances[:] = problem.tolerances()
        status: int = integrator()(*self._pointers)
        return _OUTCOMES[status]

    @property
    def memory(self) -> Array:
        """Sampled memory as the last run left it."""
        return self._p[len(self.problem.kernel.model.parameters) :]

    def made(self, progress: Callable[[float], Any] | None = None) -> RawRun:
        """Integrate, once, and hand the arrays back."""
        function, n = integrator(), self.x.size
        status = (
            function(*self._pointers) if progress is None else _watched(function, self._pointers, self.watch, progress)
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


@lru_cache(maxsize=1)
def integrator() -> Any:
    """The compiled integrator as a function of pointers; it releases the interpreter's lock while it runs."""
    from poppet.engine.compiled import compiled_integrator

    return as_function(compiled_integrator())


def as_function(compiled: CompiledFunctions) -> Any:
    """An integrator in this process."""
    import ctypes

    function: Any = ctypes.CFUNCTYPE(ctypes.c_int64, *[ctypes.c_void_p] * 20)(compiled.addresses["integrate"])
    function.owner = compiled.owner  # the code lives as long as this does
    return function


def _watched(integrate: Any, arguments: Sequence[int], watch: Array, progress: Callable[[float], Any]) -> int:
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
