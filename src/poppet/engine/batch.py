"""Runs of one problem with different parameters, on threads that release the interpreter lock.

Ensembles use this module. A batch consists of a problem, the indices of the varied parameters in p, and a row of values
per run. Threads take slices of the runs from a queue. The result of a run depends only on its parameters, not on other
runs, on the number of threads or on its slice.

Rows of outputs are temporary: the function `reduce` receives the rows of a slice, whose memory is then reused. A metric
such as a rise time selects its outputs with `Kernel.observing`, and evaluates the rows of all runs of a slice together
(NumPy releases the lock for large arrays). To keep the rows, `reduce` returns a copy. Without rows, a batch provides
final states and outputs, extremes and total change of each state, statistics and residuals. If the grid contains only
the end, a run writes one row.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import dataclass, replace
from itertools import count
from threading import Lock, current_thread, main_thread
from typing import Any, NamedTuple, Protocol

import numpy as np

from poppet.core.codes import Note
from poppet.engine.balances import allowed, imbalance
from poppet.engine.call import Call
from poppet.engine.lane_kernel import Lanes, lane_functions, usual_width
from poppet.engine.members import Batch, Integers, RunEnds
from poppet.engine.problem import Array, Outcome
from poppet.engine.solve import solve

ROWS_BYTES = 1 << 25
"""Memory for the rows of a slice per thread [B]; a slice has at least one run."""
_OUTCOMES = tuple(Outcome)


class BatchRows(NamedTuple):
    """Output rows of some runs of a batch.

    The next runs overwrite the arrays.
    """

    runs: Integers  # (m,) indices of the runs in the batch
    time: Array  # (n_times,) the grid [s]
    values: Array  # (m, n_outputs, n_times) outputs; NaN after the last row of a run
    counts: Integers  # (m,) number of rows of each run
    reached: Array  # (m,) time of the last row of each run [s]; not in the grid if a condition stopped the run


Reduce = Callable[[BatchRows], Array]
"""Function from the rows of m runs to their results, (m, ...).

Several threads call it with arbitrary slices, so the result of a run must not depend on other runs. A run that is
repeated with another solver is passed twice; the second result is valid."""


@dataclass(frozen=True)
class BatchRun:
    """Results of all runs of a batch."""

    batch: Batch
    ends: RunEnds
    reduced: Array | None  # (n_runs, ...) results of `reduce`
    notes: dict[int, tuple[Note, ...]]  # index of each run on which the kernel stalled to its notes
    width: int  # number of lanes; 1 for the scalar kernel
    threads: int

    def residuals(self) -> dict[str, Array]:
        """Return the relative balance errors of all runs, (n_runs,) for each balance.

        The keys are names of balances, for example `tank mass`. A relative error is the error divided by its permitted
        maximum, so values up to 1 are correct.
        """
        e = self.ends
        result: dict[str, Array] = {}
        for b in self.batch.problem.kernel.model.balances:
            start, end = (e.x0.T, e.x.T) if b.quantity == "mass" else (e.initial_energies.T, e.final_energies.T)
            error, gross = imbalance(b, start, end, e.x.T, e.through.T)
            inventory = np.maximum(start[b.inventory], end[b.inventory])
            result[f"{b.store} {b.quantity}"] = error / allowed(b.quantity, gross, inventory)
        return result


class Worker(Protocol):
    """Interface of an object that computes some runs of a batch in one thread."""

    max_runs: int  # of a slice

    def run(self, first: int, last: int, table: Array | None) -> None:
        """Compute the runs `first` to `last` - 1 and write their output rows.

        The rows are written into `table`, which has the shape (last - first, n_outputs, n_times). If it is None, no
        rows are written.
        """

    def halt(self) -> None:
        """Stop the current run as soon as possible.

        Another thread calls this method.
        """


class ScalarWorker:
    """Worker that computes one run after the other with the compiled model."""

    max_runs = 16

    def __init__(self, batch: Batch, ends: RunEnds) -> None:
        problem, kernel = batch.problem, batch.problem.kernel
        kernel.optimise()
        self.batch, self.ends, self._is_halted = batch, ends, False
        copy = replace(problem, p=problem.p.copy(), x0=problem.x0.copy(), coefficients=problem.coefficients.copy())
        self._call = Call(copy)
        self._start = kernel.caller("start", copy.p, copy.x0, copy.p[len(kernel.model.parameters) :])

    def run(self, first: int, last: int, table: Array | None) -> None:
        """Compute the runs `first` to `last` - 1, one after the other."""
        problem = self._call.problem
        for run in range(first, last):
            if self._is_halted:
                return
            self.batch.write(run, problem.p, problem.coefficients)
            self._start()
            self.ends.write(run, problem, self._call.result(self._call.repeat()))
            if table is not None:
                table[run - first] = self._call.table

    def halt(self) -> None:
        """Stop the current run as soon as possible.

        Another thread calls this method.
        """
        self._is_halted = True
        self._call.halt()


def run_batch(
    batch: Batch,
    *,
    reduce: Reduce | None = None,
    threads: int | None = None,
    lanes: int | None = None,
    progress: Callable[[int], Any] | None = None,
) -> BatchRun:
    """Compute all runs of a batch on several threads.

    Parameters
    ----------
    batch : Batch
        Problem and parameter values.
    reduce : callable, optional
        Function that converts the rows of some runs to results. If it is omitted, the rows are discarded.
    threads : int, optional
        Maximum number of threads (default: one per processor that is available to this process).
    lanes : int, optional
        Number of runs that a thread computes simultaneously: 1, 2, 4 or 8. The default is the environment variable
        `POPPET_LANES`, or the width of the registers of the processor. 1 selects the scalar kernel, which also runs
        circuits without states.
    progress : callable, optional
        Called in this thread, several times per second, with the number of completed runs.

    Returns
    -------
    BatchRun
        Final states, statistics and residuals of all runs, and the results of `reduce`.

    Notes
    -----
    A run on which the kernel stalls is repeated with other solvers (`poppet.engine.solve`) after all other runs. An
    interruption ends all threads and is then raised again, without a result.
    """
    if reduce is None:
        batch = replace(batch, problem=replace(batch.problem, grid=batch.problem.grid[-1:].copy()))
    ends = RunEnds.of(batch)
    width = (lanes or usual_width()) if batch.problem.x0.size else 1
    threads = max(1, min(threads or usable_cores(), batch.size // width))
    workers: list[Worker]
    if width == 1:
        workers = [ScalarWorker(batch, ends) for _ in range(threads)]
    else:
        functions = lane_functions(batch.problem.kernel, width)
        workers = [Lanes(batch, ends, functions, width) for _ in range(threads)]
    pool = _Pool(batch, ends, reduce, workers)
    pool.run(progress)
    stalled = np.flatnonzero(ends.counts[:, 5] == _OUTCOMES.index(Outcome.STALLED)).tolist()
    notes = {run: pool.repeat_stalled(run) for run in stalled}
    return BatchRun(batch, ends, pool.reduced, notes, width, threads)


def usable_cores() -> int:
    """Return the number of processors that are available to this process."""
    # Not available on all systems.
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1


class _Pool:
    """Pool of threads, each with one worker, which share the runs of a batch.

    Each worker computes some runs, and then takes the next ones.
    """

    def __init__(self, batch: Batch, ends: RunEnds, reduce: Reduce | None, workers: Sequence[Worker]) -> None:
        self.batch, self.ends, self.reduce, self.workers = batch, ends, reduce, workers
        self.reduced: Array | None = None
        self.shape = len(batch.problem.kernel.model.outputs), batch.problem.grid.size
        memory_limit = ROWS_BYTES // (8 * self.shape[0] * self.shape[1] or 1) if reduce else batch.size
        self.size = max(1, min(workers[0].max_runs, memory_limit, -(-batch.size // len(workers))))
        # `next` of a counter is atomic: each thread gets another slice.
        self._slices, self._is_halted, self._lock = count(), False, Lock()
        self.n_completed = 0

    def run(self, progress: Callable[[int], Any] | None) -> None:
        """Compute all runs of the batch.

        `progress` is called with the number of completed runs.
        """
        if len(self.workers) == 1 and progress is None and current_thread() is not main_thread():
            # Only the main thread can be interrupted: no second thread is necessary.
            self._run_slices(self.workers[0])
            return
        with ThreadPoolExecutor(len(self.workers)) as threads:
            try:
                futures = [threads.submit(self._run_slices, worker) for worker in self.workers]
                while wait(futures, 0.1).not_done:
                    if progress is not None:
                        progress(self.n_completed)
            finally:
                # Also after an interruption: the threads must end before their arrays are freed.
                self._is_halted = True
                for worker in self.workers:
                    worker.halt()
        for future in futures:
            future.result()
        if progress is not None:
            progress(self.n_completed)

    def _run_slices(self, worker: Worker) -> None:
        table = None if self.reduce is None else np.empty((self.size, *self.shape))
        for number in self._slices:
            first = number * self.size
            last = min(first + self.size, self.batch.size)
            if first >= last or self._is_halted:
                return
            worker.run(first, last, table)
            if table is not None and not self._is_halted:
                self._reduce(np.arange(first, last), table[: last - first])
            with self._lock:
                self.n_completed += last - first

    def _reduce(self, runs: Integers, table: Array) -> None:
        assert self.reduce is not None
        ends = self.ends
        rows = BatchRows(runs, self.batch.problem.grid, table, ends.counts[runs, 2], ends.reached[runs, 0])
        results = np.asarray(self.reduce(rows))
        with self._lock:
            if self.reduced is None:
                self.reduced = np.empty((self.batch.size, *results.shape[1:]), dtype=results.dtype)
        self.reduced[runs] = results

    def repeat_stalled(self, run: int) -> tuple[Note, ...]:
        """Repeat a stalled run with other solvers, and return notes on these attempts.

        `run` is the index of the run.
        """
        problem = self.batch.member(run)
        raw = solve(problem)
        self.ends.write(run, problem, raw)
        if self.reduce is not None:
            table = np.full((1, *self.shape), np.nan)
            table[0, :, : raw.time.size] = raw.values
            self._reduce(np.array([run]), table)
        return raw.notes
