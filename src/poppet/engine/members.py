"""Runs that differ in numbers, in plain arrays: what they are handed, and how each of them ended."""

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
    """Runs of a problem with other numbers.

    Everything but the numbers is shared: segments of the inputs, grid, tolerance, stop conditions. Numbers that move
    breakpoints (delays) or from which others follow are the caller's: the first want a batch for each value, the second
    columns for all that follow.
    """

    problem: Problem
    places: Integers  # (n_varied,) places of the varied numbers in p
    values: Array  # (n_runs, n_varied) SI, absolute
    held: tuple[tuple[int, int], ...] = ()  # inputs without a signal, each with the place of the number it is held at

    @property
    def size(self) -> int:
        """Number of runs."""
        return len(self.values)

    def write(self, run: int, p: Array, coefficients: Array) -> None:
        """Write the numbers of a run into arrays like those of the problem."""
        p[self.places] = self.values[run]
        for k, place in self.held:
            coefficients[:, k, 0] = p[place]

    def member(self, run: int) -> Problem:
        """The problem of one run, as a single run would be handed it."""
        p, coefficients = self.problem.p.copy(), self.problem.coefficients.copy()
        self.write(run, p, coefficients)
        return replace(self.problem, p=p, x0=self.problem.kernel.start(p), coefficients=coefficients)


@dataclass(frozen=True)
class Ends:
    """How runs ended; row k of every array is of run k."""

    # What compiled code writes: a record for each run, of which the arrays below are views; and accepted steps,
    # attempts, rows, stop condition, scratch, place of the outcome in `Outcome`.
    record: Array
    counts: Integers
    x0: Array  # (n_runs, n_states) states at the start, quadratures included
    x: Array  # at the end
    least: Array  # over all steps
    greatest: Array
    through: Array  # sum of |change|
    before: Array  # (n_runs, n_energies) energies of `poppet.engine.balances` at the start [J]
    after: Array  # at the end
    last: Array  # (n_runs, n_outputs) outputs at the end
    reached: Array  # (n_runs, 1) time at the end [s]

    @staticmethod
    def of(batch: Batch) -> Ends:
        """Room for the ends of a batch, none of which has been run."""
        n, model = batch.problem.x0.size, batch.problem.kernel.model
        places = list(accumulate([n, n, n, n, n, model.n_energies, model.n_energies, len(model.outputs), 1]))
        record, counts = np.full((batch.size, places[-1]), np.nan), np.zeros((batch.size, 6), dtype=np.int64)
        counts[:, 5] = _OUTCOMES.index(Outcome.INTERRUPTED)
        return Ends(record, counts, *np.split(record, places[:-1], axis=1))

    def write(self, run: int, problem: Problem, found: RawRun) -> None:
        """Write what a solver has handed back."""
        rows = found.time.size
        self.counts[run] = found.accepted, found.attempts, rows, found.stop, 0, _OUTCOMES.index(found.outcome)
        last = found.values[:, -1] if rows else np.full(len(found.values), np.nan)
        weighed = energies(problem, problem.x0, found.x)
        states = problem.x0, found.x, *found.extremes, found.through
        self.record[run] = np.concatenate([*states, *weighed, last, [found.reached]])

    @property
    def accepted(self) -> Integers:
        """Accepted steps, (n_runs,)."""
        return self.counts[:, 0]

    @property
    def rejected(self) -> Integers:
        """Rejected steps, (n_runs,)."""
        return self.counts[:, 1] - self.counts[:, 0]

    @property
    def stops(self) -> Integers:
        """Index of the stop condition that ended a run, or -1, (n_runs,)."""
        return self.counts[:, 3]

    @property
    def outcomes(self) -> list[Outcome]:
        """How each run ended."""
        return [_OUTCOMES[k] for k in self.counts[:, 5]]
