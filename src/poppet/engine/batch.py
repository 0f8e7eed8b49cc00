"""Many runs of one problem that differ in some of its numbers, on threads that do not hold the interpreter's lock.

This is what ensembles stand on. A batch is plain arrays: a problem, the places of the varied numbers in p, and a row of
values for each run. Threads take slices of the runs from one queue; what a run gives depends on its numbers alone, not
on its neighbours, on the number of threads, or on the slice that it came in.

Curves are not kept. The rows of a slice are handed to a function, `reduce`, as soon as they are there, and their memory
is used again. Who wants a time of rise or an overshoot chooses the outputs with `Kernel.observing`, reads them off the
rows of all runs of a slice at once (NumPy lets go of the lock in large arrays), and keeps a few numbers a run; who
wants curves returns a copy. What needs no rows is there anyway: states and outputs at the end, extremes and total
change of every state over all steps, statistics, residuals. With a grid of the end alone a run writes one row.
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
from poppet.engine.balances import allowed, missing
from poppet.engine.call import Call
from poppet.engine.lane_kernel import Lanes, lane_functions, usual_width
from poppet.engine.members import Batch, Ends, Integers
from poppet.engine.problem import Array, Outcome
from poppet.engine.solve import solve

ROWS_BYTES = 1 << 25
"""Memory for the rows of a slice in each thread [B]; a slice has one run at least."""
_OUTCOMES = tuple(Outcome)


class Rows(NamedTuple):
    """The rows of a slice of the runs, in memory that is used again."""

    runs: Integers  # (m,) which runs these are
    time: Array  # (n_times,) the grid [s]
    values: Array  # (m, n_outputs, n_times) outputs; NaN behind the last row of a run
    counts: Integers  # (m,) rows of each run
    reached: Array  # (m,) time of the last row of each run [s], which is not in the grid where a condition stopped it


Reduce = Callable[[Rows], Array]
"""From the rows of m runs to what is kept of them, (m, ...); called on several threads, and for any slice of the runs,
so it must look at each alone. It sees a run that is handed over twice, and the second time counts."""


@dataclass(frozen=True)
class BatchRun:
    """What a batch came to."""

    batch: Batch
    ends: Ends
    reduced: Array | None  # (n_runs, ...) what `reduce` gave
    notes: dict[int, tuple[Note, ...]]  # of each run on which the kernel stalled: what a single run would say
    width: int  # of the lanes; 1 where the scalar kernel ran one after the other
    threads: int

    def residuals(self) -> dict[str, Array]:
        """Balances of every run: store and quantity, `tank mass`, to error in parts of what is allowed, (n_runs,).

        Up to 1 a balance is kept, as in `poppet.engine.balances`.
        """
        e = self.ends
        found: dict[str, Array] = {}
        for b in self.batch.problem.kernel.model.balances:
            start, end = (e.x0.T, e.x.T) if b.quantity == "mass" else (e.before.T, e.after.T)
            error, gross = missing(b, start, end, e.x.T, e.through.T)
            inventory = np.maximum(start[b.inventory], end[b.inventory])
            found[f"{b.store} {b.quantity}"] = error / allowed(b.quantity, gross, inventory)
        return found


class Worker(Protocol):
    """Runs slices of a batch, in one thread at a time."""

    most: int  # runs in a slice

    def run(self, first: int, last: int, table: Array | None) -> None:
        """Runs from `first` up to `last`; rows into `table`, (last - first, n_outputs, n_times), where wanted."""

    def halt(self) -> None:
        """Ask, from another thread, that it end soon."""


class Scalar:
    """A worker that runs one after the other with the scalar kernel."""

    most = 16

    def __init__(self, batch: Batch, ends: Ends) -> None:
        problem, kernel = batch.problem, batch.problem.kernel
        self.batch, self.ends, self._is_halted = batch, ends, False
        own = replace(problem, p=problem.p.copy(), x0=problem.x0.copy(), coefficients=problem.coefficients.copy())
        self._call = Call(own)
        self._start = kernel.caller("start", own.p, own.x0, own.p[len(kernel.model.parameters) :])

    def run(self, first: int, last: int, table: Array | None) -> None:
        """One after the other."""
        problem = self._call.problem
        for run in range(first, last):
            if self._is_halted:
                return
            self.batch.write(run, problem.p, problem.coefficients)
            self._start()
            self.ends.write(run, problem, self._call.found(self._call.again()))
            if table is not None:
                table[run - first] = self._call.table

    def halt(self) -> None:
        """Ask, from another thread, that it end soon."""
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
    """Run a batch.

    Parameters
    ----------
    batch : Batch
        Problem and numbers.
    reduce : callable, optional
        From the rows of some runs to what is kept of them; without it no rows are kept.
    threads : int, optional
        At most so many; default one for each processor that this process may use.
    lanes : int, optional
        Runs that a thread computes side by side: 1, 2, 4 or 8; default what fills the registers of the processor, or
        what `POPPET_LANES` says. 1 is the scalar kernel. A circuit without states has no lanes.
    progress : callable, optional
        Called in this thread, some times a second, with the number of runs that are done.

    Returns
    -------
    BatchRun
        Ends, statistics and residuals of all runs, and what `reduce` gave.

    Notes
    -----
    A run on which the kernel stalls is handed over as `poppet.engine.solve` does it, when all others are done. An
    interruption ends all threads before it goes on; the runs of other outcomes than `INTERRUPTED` are done by then, but
    nothing is handed back.
    """
    if reduce is None:
        batch = replace(batch, problem=replace(batch.problem, grid=batch.problem.grid[-1:].copy()))
    ends = Ends.of(batch)
    width = (lanes or usual_width()) if batch.problem.x0.size else 1
    threads = max(1, min(threads or usable_cores(), batch.size // width))
    pool = _Pool(batch, ends, reduce, _workers(batch, ends, width, threads))
    pool.run(progress)
    stalled = np.flatnonzero(ends.counts[:, 5] == _OUTCOMES.index(Outcome.STALLED)).tolist()
    notes = {run: pool.hand_over(run) for run in stalled}
    return BatchRun(batch, ends, pool.kept, notes, width, threads)


def _workers(batch: Batch, ends: Ends, width: int, count: int) -> list[Worker]:
    if width == 1:
        return [Scalar(batch, ends) for _ in range(count)]
    functions = lane_functions(batch.problem.kernel, width)
    return [Lanes(batch, ends, functions, width) for _ in range(count)]


def usable_cores() -> int:
    """Processors that this process may use."""
    # Not on every system.
    own = getattr(os, "sched_getaffinity", None)
    return len(own(0)) if own else os.cpu_count() or 1


class _Pool:
    """Workers on threads, each of which takes the next slice when it has finished one."""

    def __init__(self, batch: Batch, ends: Ends, reduce: Reduce | None, workers: Sequence[Worker]) -> None:
        self.batch, self.ends, self.reduce, self.workers = batch, ends, reduce, workers
        self.kept: Array | None = None
        self.shape = len(batch.problem.kernel.model.outputs), batch.problem.grid.size
        fitting = ROWS_BYTES // (8 * self.shape[0] * self.shape[1] or 1) if reduce else batch.size
        self.size = max(1, min(workers[0].most, fitting, -(-batch.size // len(workers))))
        # One step of the interpreter takes the next number: no two threads get the same.
        self._slices, self._is_halted, self._lock = count(), False, Lock()
        self.done = 0

    def run(self, progress: Callable[[int], Any] | None) -> None:
        """Run all."""
        if len(self.workers) == 1 and progress is None and current_thread() is not main_thread():
            # Nobody interrupts another thread than the main one, so that there is nothing to stand by for.
            self._work(self.workers[0])
            return
        with ThreadPoolExecutor(len(self.workers)) as threads:
            futures = [threads.submit(self._work, worker) for worker in self.workers]
            try:
                while wait(futures, 0.1).not_done:
                    if progress is not None:
                        progress(self.done)
            finally:
                # After an interruption, for what they write into must outlive them.
                self._is_halted = True
                for worker in self.workers:
                    worker.halt()
        for future in futures:
            future.result()
        if progress is not None:
            progress(self.done)

    def _work(self, worker: Worker) -> None:
        table = None if self.reduce is None else np.empty((self.size, *self.shape))
        for number in self._slices:
            first = number * self.size
            last = min(first + self.size, self.batch.size)
            if first >= last or self._is_halted:
                return
            worker.run(first, last, table)
            if table is not None and not self._is_halted:
                self._keep(np.arange(first, last), table[: last - first])
            with self._lock:
                self.done += last - first

    def _keep(self, runs: Integers, table: Array) -> None:
        assert self.reduce is not None
        ends = self.ends
        rows = Rows(runs, self.batch.problem.grid, table, ends.counts[runs, 2], ends.reached[runs, 0])
        found = np.asarray(self.reduce(rows))
        with self._lock:
            if self.kept is None:
                self.kept = np.empty((self.batch.size, *found.shape[1:]), dtype=found.dtype)
        self.kept[runs] = found

    def hand_over(self, run: int) -> tuple[Note, ...]:
        """Repeat a run that stalled."""
        problem = self.batch.member(run)
        found = solve(problem)
        self.ends.write(run, problem, found)
        if self.reduce is not None:
            table = np.full((1, *self.shape), np.nan)
            table[0, :, : found.time.size] = found.values
            self._keep(np.array([run]), table)
        return found.notes
