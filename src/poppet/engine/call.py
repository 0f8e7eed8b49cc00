"""Calls of the compiled integrator: one, or with other numbers many, at little more than the cost of the kernel."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from dataclasses import replace
from itertools import accumulate, pairwise
from typing import Any

import numpy as np

from poppet.engine.compiled import integrator
from poppet.engine.job import Job, address
from poppet.engine.problem import Array, Outcome, Problem, RawRun

_OUTCOMES = tuple(Outcome)
NOTHING = np.zeros(0)


class Call:
    """One call of the integrator: the arrays that it writes into, and the addresses of all that it is handed.

    Arrays of the problem are read where they lie: what their owner writes into them counts for the next `again`.
    `script` receives the lengths of the accepted steps, as far as there is room. With `replay` the run takes them from
    there, without error control: runs that share their steps differ smoothly in p.
    """

    def __init__(self, problem: Problem, script: Array = NOTHING, *, replay: bool = False) -> None:
        kernel, conditions, n = problem.kernel, problem.stop_conditions, problem.x0.size
        self.problem, self.table = problem, np.empty((len(kernel.model.outputs), problem.grid.size))
        # Asking arrays for their addresses takes longer than anything else here, so small ones share one.
        places = list(accumulate((5, 2, n, 3 * n, 4, kernel.memory_size), initial=0))
        own = np.empty(places[-1])
        counts, self.watch, self.x, self.books, limits, _ = (own[a:b] for a, b in pairwise(places))
        self.counts = counts.view(np.int64)
        # Doubles all of them, for they share one row; a flag is 0 or 1.
        limits[:] = problem.maximum_step, problem.most_attempts, replay, problem.relative_tolerance
        self._places = np.array([c.places for c in conditions], dtype=np.int64) if conditions else NOTHING
        self._weights = np.array([c.weights for c in conditions], dtype=np.float64) if conditions else NOTHING
        # The integrator writes the sampled memory into p.
        self._p = problem.p.copy() if kernel.model.memory else problem.p
        self._script, first = script, address(own)
        at = [first + 8 * place for place in places]
        job = Job(
            **kernel.job,
            n_segments=problem.starts.size, n_courses=len(problem.coefficients), n_rows=problem.grid.size,
            n_conditions=len(conditions), n_script=script.size, p=address(self._p),
            starts=address(problem.starts), courses=address(problem.courses),
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
        """Integrate from the initial state of the problem into the same arrays; rows that are not reached are NaN."""
        self._reset()
        outcome: Outcome = _OUTCOMES[integrator()(self._address)]
        self.table[:, self.counts[2] :] = np.nan
        return outcome

    def halt(self) -> None:
        """Ask, from another thread, that the run end soon."""
        self.watch[1] = 1.0

    @property
    def memory(self) -> Array:
        """Sampled memory as the last run left it."""
        return self._p[len(self.problem.kernel.model.parameters) :]

    def made(self, progress: Callable[[float], Any] | None = None) -> RawRun:
        """Integrate, once, and hand the arrays back."""
        function = integrator()
        # Without a listener no thread: starting one takes longer than a short run.
        status = function(self._address) if progress is None else self._watched(function, progress)
        return self.found(_OUTCOMES[status])

    def found(self, outcome: Outcome) -> RawRun:
        """The arrays as the last run left them, which ended so."""
        n, (accepted, attempts, rows, stop, _) = self.x.size, self.counts.tolist()
        time = self.problem.grid[:rows]
        # The last row of a run that stopped is the stop itself, between the times of the grid.
        if outcome is Outcome.STOPPED:
            time = np.append(time[:-1], self.watch[0])
        extremes, through = self.books[: 2 * n].reshape(2, n), self.books[2 * n :]
        return RawRun(
            outcome, time, self.table[:, :rows], self.x, extremes, through, accepted, attempts - accepted, stop
        )

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
            self.halt()
            while not has_ended.is_set():
                with contextlib.suppress(KeyboardInterrupt):
                    has_ended.wait()

        # A daemon, so that an interpreter that is told to end does not wait for the run.
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


class RepeatedCall:
    """A problem in arrays of its own, whose addresses are looked up once.

    Write numbers into `p` and `coefficients`, then `run`, or `replay` the steps of the last run. The initial state
    follows from `p`. Both give their own table, which the next call of the same kind writes over.

    A run writes the lengths of its accepted steps into `script`, as far as there is room; a replay takes them from
    there. `is_scripted` says that the last run reached its end and wrote all of them down.
    """

    def __init__(self, problem: Problem, script: Array) -> None:
        self.p, self.coefficients, self.script = problem.p.copy(), problem.coefficients.copy(), script
        own = replace(problem, p=self.p, coefficients=self.coefficients, x0=problem.x0.copy())
        self._run, self._replay = Call(own, script), Call(own, script, replay=True)
        memory = self.p[len(problem.kernel.model.parameters) :]
        self._start = problem.kernel.caller("start", self.p, own.x0, memory)
        self.is_scripted = False

    def run(self) -> Array:
        """Outputs at the times of the grid."""
        self._start()
        outcome = self._run.again()
        self.is_scripted = outcome.is_success and 0 < int(self._run.counts[0]) <= self.script.size
        return self._run.table

    def replay(self) -> Array:
        """The same over the steps of the script, without error control: such runs differ smoothly in the numbers."""
        self._start()
        self._replay.again()
        return self._replay.table
