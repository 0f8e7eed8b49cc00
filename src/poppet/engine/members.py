"""Parameter values and results of the runs of a batch."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import accumulate

import numpy as np
from numpy.typing import NDArray

from poppet.engine.balances import energies
from poppet.engine.problem import Array, Outcome, Problem, RawRun

Integers = NDArray[np.int64]
_OUTCOMES = tuple(Outcome)


@dataclass(frozen=True)
class Batch:
    """Runs of one problem that differ only in their parameter values.

    They share segments of the inputs, output times, tolerance and stop conditions. Delays move breakpoints, so each
    value of a delay needs its own batch. If other parameters depend on a varied one, `values` must also contain their
    columns.
    """

    problem: Problem
    places: Integers  # (n_varied,) indices of the varied parameters in p
    values: Array  # (n_runs, n_varied) SI, absolute
    held: tuple[tuple[int, int], ...] = ()  # indices of inputs without a signal, and of the parameters of their values

    @property
    def size(self) -> int:
        """Number of runs."""
        return len(self.values)

    def write(self, run: int, p: Array, coefficients: Array) -> None:
        """Write the parameter values of one run into the arrays `p` and `coefficients`.

        `run` is the index of the run. Both arrays must be copies of the arrays of the problem.
        """
        p[self.places] = self.values[run]
        for k, index in self.held:
            coefficients[:, k, 0] = p[index]

    def member(self, run: int) -> Problem:
        """Return the complete problem of one run.

        `run` is the index of the run.
        """
        p, coefficients = self.problem.p.copy(), self.problem.coefficients.copy()
        self.write(run, p, coefficients)
        return replace(self.problem, p=p, x0=self.problem.kernel.start(p), coefficients=coefficients)


@dataclass(frozen=True)
class RunEnds:
    """Results at the end of each run of a batch.

    Row k of each array belongs to run k.
    """

    # Written by compiled code. `record` contains the arrays below; `counts` contains accepted steps, attempts, rows,
    # stop condition, scratch, index of the outcome in `Outcome`.
    record: Array
    counts: Integers
    x0: Array  # (n_runs, n_states) states at the start, quadratures included
    x: Array  # at the end
    least: Array  # over all steps
    greatest: Array
    through: Array  # sum of |change|
    initial_energies: Array  # (n_runs, n_energies) energies of `poppet.engine.balances` at the start [J]
    final_energies: Array  # at the end
    last: Array  # (n_runs, n_outputs) outputs at the end
    reached: Array  # (n_runs, 1) time at the end [s]

    @staticmethod
    def of(batch: Batch) -> RunEnds:
        """Create arrays for the results of a batch."""
        n, model = batch.problem.x0.size, batch.problem.kernel.model
        offsets = list(accumulate([n, n, n, n, n, model.n_energies, model.n_energies, len(model.outputs), 1]))
        record, counts = np.full((batch.size, offsets[-1]), np.nan), np.zeros((batch.size, 6), dtype=np.int64)
        counts[:, 5] = _OUTCOMES.index(Outcome.INTERRUPTED)
        return RunEnds(record, counts, *np.split(record, offsets[:-1], axis=1))

    def write(self, run: int, problem: Problem, raw: RawRun) -> None:
        """Store the result `raw` of one run that another solver has computed.

        `run` is the index of the run.
        """
        rows = raw.time.size
        self.counts[run] = raw.accepted, raw.attempts, rows, raw.stop, 0, _OUTCOMES.index(raw.outcome)
        last = raw.values[:, -1] if rows else np.full(len(raw.values), np.nan)
        states = problem.x0, raw.x, *raw.extremes, raw.through, *energies(problem, problem.x0, raw.x)
        self.record[run] = np.concatenate([*states, last, [raw.reached]])

    @property
    def accepted(self) -> Integers:
        """Number of accepted steps, (n_runs,)."""
        return self.counts[:, 0]

    @property
    def rejected(self) -> Integers:
        """Number of rejected steps, (n_runs,)."""
        return self.counts[:, 1] - self.counts[:, 0]

    @property
    def stops(self) -> Integers:
        """Index of the stop condition that ended each run, (n_runs,).

        The index is -1 for a run without a stop.
        """
        return self.counts[:, 3]

    @property
    def outcomes(self) -> list[Outcome]:
        """Outcome of each run, for example a complete run or a stall."""
        return [_OUTCOMES[k] for k in self.counts[:, 5]]
