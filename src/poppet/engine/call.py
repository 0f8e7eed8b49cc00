"""Calls of the compiled integrator with little overhead."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from dataclasses import replace
from itertools import accumulate, pairwise
from time import perf_counter
from typing import Any

import numpy as np

from poppet.engine.compiled import integrator
from poppet.engine.job import Job, address
from poppet.engine.problem import Array, Outcome, Problem, RawRun
from poppet.engine.tier import Tier

_OUTCOMES = tuple(Outcome)
NOTHING = np.zeros(0)
INTERVAL = 0.1
"""Time between two reports of progress [s]."""


class Call:
    """Prepared call of the compiled integrator for one problem, with the arrays for its results.

    The arrays of the problem are not copied, so `repeat` uses their present values. The integrator writes the lengths
    of the accepted steps into the array `script`, up to its size. If `replay` is True, the integrator instead takes the
    steps in `script`, without error control. The result is then a smooth function of p.

    `limits` contains the maximum step, the maximum number of attempts, `replay` and the tolerance. With the tolerance
    0, `proceed` continues with the tolerances of the states and the length of the step of the last call.
    """

    def __init__(self, problem: Problem, script: Array = NOTHING, *, replay: bool = False) -> None:
        kernel, conditions, n = problem.kernel, problem.stop_conditions, problem.x0.size
        self.problem, self.table = problem, np.empty((len(kernel.model.outputs), problem.grid.size))
        # Small arrays share one block: addresses of arrays are the most expensive part of this method.
        offsets = list(accumulate((5, 2, n, 3 * n, 4, kernel.memory_size), initial=0))
        self._block = block = np.empty(offsets[-1])
        counts, self.watch, self.x, self.books, self.limits, _ = (block[a:b] for a, b in pairwise(offsets))
        self.counts = counts.view(np.int64)
        # All values are doubles; a flag is 0 or 1.
        self.limits[:] = problem.maximum_step, problem.most_attempts, replay, problem.relative_tolerance
        self._places = np.array([c.places for c in conditions], dtype=np.int64) if conditions else NOTHING
        self._weights = np.array([c.weights for c in conditions], dtype=np.float64) if conditions else NOTHING
        # The integrator writes the discrete state into p.
        self.p = problem.p.copy() if kernel.model.memory else problem.p
        self._script, first = script, address(block)
        addresses = [first + 8 * offset for offset in offsets]
        job = Job(
            **kernel.job,
            n_segments=problem.starts.size, n_courses=len(problem.coefficients), n_rows=problem.grid.size,
            n_conditions=len(conditions), n_script=script.size, p=address(self.p),
            starts=address(problem.starts), courses=address(problem.courses),
            coefficients=address(problem.coefficients), jumps=address(problem.jumps), grid=address(problem.grid),
            places=address(self._places), weights=address(self._weights), script=address(script),
            table=address(self.table),
            **dict(zip(("counts", "watch", "x", "books", "limits", "memory"), addresses[:6], strict=True)),
        )  # fmt: skip
        self._job = np.array(job, dtype=np.int64)
        self._address = address(self._job)
        self._reset()

    def _reset(self) -> None:
        self.x[:], self.watch[:], self.counts[:] = self.problem.x0, 0.0, 0
        if self.p is not self.problem.p:
            self.p[:] = self.problem.p

    def repeat(self) -> Outcome:
        """Run the problem from its initial state, and return the outcome.

        The results overwrite the results of the last run. Output rows that the run does not reach are NaN.
        """
        self._reset()
        function, tier = integrator(), self.problem.kernel.tier
        status = function(self._address) if tier is None else tier.timed(lambda: function(self._address))
        outcome: Outcome = _OUTCOMES[status]
        self.table[:, self.counts[2] :] = np.nan
        return outcome

    def proceed(self) -> Outcome:
        """Run the problem from the present state `x` and vector `p`, and return the outcome.

        Both arrays then contain the values at the end. The code of the kernel must be optimised.
        """
        self.counts[:] = 0
        outcome: Outcome = _OUTCOMES[integrator()(self._address)]
        return outcome

    def save(self) -> tuple[Array, Array]:
        """Return a copy of everything from which `proceed` continues, for `restore`."""
        return self._block.copy(), self.p.copy()

    def restore(self, saved: tuple[Array, Array]) -> None:
        """Return to the state that `save` has returned."""
        self._block[:] = saved[0]
        if self.p is not self.problem.p:
            self.p[:] = saved[1]

    def halt(self) -> None:
        """Stop the run as soon as possible.

        Another thread calls this method.
        """
        self.watch[1] = 1.0

    @property
    def memory(self) -> Array:
        """Discrete states at the end of the last run."""
        return self.p[len(self.problem.kernel.model.parameters) :]

    def run(self, progress: Callable[[float], Any] | None = None) -> RawRun:
        """Integrate the problem once, and return the result.

        For several runs, use `repeat`. `progress` is called with the time reached [s].
        """
        function, tier = integrator(), self.problem.kernel.tier
        if tier is not None and not tier.is_optimised:
            status = tier.timed(lambda: self._run_in_thread(function, progress, tier))
        elif progress is not None:
            status = self._run_in_thread(function, progress)
        else:
            # No thread: its start takes longer than a short run.
            status = function(self._address)
        return self.result(_OUTCOMES[status])

    def result(self, outcome: Outcome) -> RawRun:
        """Return the results of the last run as an object, which contains the given outcome."""
        n, (accepted, attempts, rows, stop, _) = self.x.size, self.counts.tolist()
        time = self.problem.grid[:rows]
        # The last row of a stopped run is at the stop time, which is not in the grid.
        if outcome is Outcome.STOPPED:
            time = np.append(time[:-1], self.watch[0])
        extremes, through = self.books[: 2 * n].reshape(2, n), self.books[2 * n :]
        return RawRun(
            outcome, time, self.table[:, :rows], self.x, extremes, through, accepted, attempts - accepted, stop
        )

    def _run_in_thread(self, integrate: Any, progress: Callable[[float], Any] | None, tier: Tier | None = None) -> int:
        """Call the function `integrate` in another thread, and return its status.

        Meanwhile the calling thread reports progress, optimises the code of a long run, and handles Ctrl-C.
        """
        import threading

        result: list[int] = []
        # Not `Thread.join`: after an interruption, it regards a running thread as ended.
        has_ended = threading.Event()

        def work() -> None:
            try:
                result.append(integrate(self._address))
            finally:
                has_ended.set()

        def stop() -> None:
            # The thread must end before its arrays are freed.
            self.halt()
            while not has_ended.is_set():
                with contextlib.suppress(KeyboardInterrupt):
                    has_ended.wait()

        # Daemon: the interpreter can exit without waiting for the run.
        threading.Thread(target=work, daemon=True).start()
        begin = perf_counter()
        try:
            while not has_ended.wait(INTERVAL):
                if progress is not None:
                    progress(float(self.watch[0]))
                if tier is not None:
                    tier.review(perf_counter() - begin)
            if progress is not None:
                progress(float(self.watch[0]))
        except KeyboardInterrupt:
            stop()
            if progress is None:
                raise
        except BaseException:
            stop()
            raise
        return result[0]


class RepeatedCall:
    """Repeated runs of one problem with changed parameters and little overhead.

    Write values into `p` and `coefficients`, then call `run`, or `replay` to use the steps of the last run. The initial
    state is computed from `p`. Both methods return the table of their outputs, (n_outputs, n_times), which their next
    call overwrites.

    A run writes the lengths of its accepted steps into `script`, up to its size. `is_scripted` is True if the last run
    reached its end and `script` contains all its steps.
    """

    def __init__(self, problem: Problem, script: Array) -> None:
        problem.kernel.optimise()
        self.p, self.coefficients, self.script = problem.p.copy(), problem.coefficients.copy(), script
        copy = replace(problem, p=self.p, coefficients=self.coefficients, x0=problem.x0.copy())
        self._run, self._replay = Call(copy, script), Call(copy, script, replay=True)
        memory = self.p[len(problem.kernel.model.parameters) :]
        self._start = problem.kernel.caller("start", self.p, copy.x0, memory)
        self.is_scripted = False

    @property
    def memory(self) -> Array:
        """Discrete states at the end of the last run."""
        return self._run.memory

    def run(self) -> Array:
        """Run the problem with error control, and return the outputs, (n_outputs, n_times)."""
        self._start()
        outcome = self._run.repeat()
        self.is_scripted = outcome.is_success and 0 < int(self._run.counts[0]) <= self.script.size
        return self._run.table

    def replay(self) -> Array:
        """Run the problem with the steps of the last run, and return the outputs, (n_outputs, n_times).

        Without error control, the outputs are smooth functions of p.
        """
        self._start()
        self._replay.repeat()
        return self._replay.table
