"""The call of the compiled integrator."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from functools import lru_cache
from itertools import accumulate, pairwise
from typing import Any

import numpy as np

from poppet.engine.compiled import CompiledFunctions
from poppet.engine.job import Job, address
from poppet.engine.problem import Array, Outcome, Problem, RawRun

_OUTCOMES = tuple(Outcome)
NOTHING = np.zeros(0)


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

    def __init__(self, problem: Problem, script: Array = NOTHING, *, replay: bool = False) -> None:
        kernel, conditions, n = problem.kernel, problem.stop_conditions, problem.x0.size
        self.problem, self.table = problem, np.empty((len(kernel.model.outputs), problem.grid.size))
        # Asking arrays for their addresses takes longer than anything else here, so small ones share one.
        places = list(accumulate((5, 2, n, 3 * n, 4, kernel.memory_size), initial=0))
        own = np.empty(places[-1])
        counts, self.watch, self.x, self.books, limits, _ = (own[a:b] for a, b in pairwise(places))
        self.counts = counts.view(np.int64)
        limits[:] = problem.maximum_step, problem.most_attempts, replay, problem.relative_tolerance
        self._places = np.array([c.places for c in conditions], dtype=np.int64) if conditions else NOTHING
        self._weights = np.array([c.weights for c in conditions], dtype=np.float64) if conditions else NOTHING
        # The integrator writes the sampled memory into p.
        self._p = problem.p.copy() if kernel.model.memory else problem.p
        self._script, first = script, address(own)
        at = [first + 8 * place for place in places]
        job = Job(
            **kernel.job,
            n_segments=problem.starts.size, n_rows=problem.grid.size, n_conditions=len(conditions),
            n_script=script.size, p=address(self._p), starts=address(problem.starts),
            coefficients=address(problem.coefficients), jumps=address(problem.jumps), grid=address(problem.grid),
            places=address(self._places), weights=address(self._weights), script=address(script),
            table=address(self.table), counts=at[0], watch=at[1], x=at[2], books=at[3], limits=at[4], memory=at[5],
        )  # fmt: skip
        self._job = np.array(job, dtype=np.int64)
        self._address = address(self._job)
        self._reset()

    def _reset(self) -> None:
        self.x[:], self.watch[:], self.counts[:] = self.problem.x0, 0.0, 0
        if self._p is not self.problem.p:
            self._p[:] = self.problem.p

    def again(self) -> Outcome:
        """Integrate from the initial state of the problem into the same arrays."""
        self._reset()
        status: int = integrator()(self._address)
        return _OUTCOMES[status]

    @property
    def memory(self) -> Array:
        """Sampled memory as the last run left it."""
        return self._p[len(self.problem.kernel.model.parameters) :]

    def made(self, progress: Callable[[float], Any] | None = None) -> RawRun:
        """Integrate, once, and hand the arrays back."""
        function, n = integrator(), self.x.size
        status = function(self._address) if progress is None else self._watched(function, progress)
        accepted, attempts, rows, stop, _ = self.counts.tolist()
        time = self.problem.grid[:rows]
        if _OUTCOMES[status] is Outcome.STOPPED:
            time = np.append(time[:-1], self.watch[0])
        extremes, through = self.books[: 2 * n].reshape(2, n), self.books[2 * n :]
        return RawRun(
            _OUTCOMES[status], time, self.table[:, :rows], self.x, extremes, through,
            accepted, attempts - accepted, stop,
        )  # fmt: skip

    def _watched(self, integrate: Any, progress: Callable[[float], Any]) -> int:
        """Integrate in a thread, so that this one can show progress and take Ctrl-C."""
        import threading

        result: list[int] = []
        # `Thread.join` is not waited on: interrupted, it takes a running thread for one that has ended.
        has_ended = threading.Event()

        def work() -> None:
            try:
                result.append(integrate(self._address))
            finally:
                has_ended.set()

        def stop() -> None:
            # The thread writes into the arrays of this call, so it must not outlive it.
            self.watch[1] = 1.0
            while not has_ended.is_set():
                with contextlib.suppress(KeyboardInterrupt):
                    has_ended.wait()

        threading.Thread(target=work, daemon=True).start()
        try:
            is_over = False
            while not is_over:
                is_over = has_ended.wait(0.1)
                progress(float(self.watch[0]))
        except KeyboardInterrupt:
            stop()
        except BaseException:
            stop()
            raise
        return result[0]


@lru_cache(maxsize=1)
def integrator() -> Any:
    """The compiled integrator, a function of a `Job`'s address; it releases the interpreter's lock while it runs."""
    from poppet.engine.compiled import compiled_integrator

    return as_function(compiled_integrator())


def as_function(compiled: CompiledFunctions) -> Any:
    """An integrator in this process."""
    import ctypes

    function: Any = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_void_p)(compiled.addresses["integrate"])
    function.owner = compiled.owner  # the code lives as long as this does
    return function
