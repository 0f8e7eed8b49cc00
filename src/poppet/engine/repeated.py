"""One problem, run many times with other numbers: what a search does, at little more than the cost of the kernel."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from poppet.engine.call import Call
from poppet.engine.problem import Array, Problem


class Repeated:
    """A problem in arrays of its own, whose addresses are looked up once.

    Write numbers into `p` and `coefficients`, then `run`, or `replay` the steps of the last run. The initial state
    follows from `p`. Both give their own table, which the next call of the same kind writes over.

    Parameters
    ----------
    problem : Problem
        Kernel, inputs, times, tolerance, and the first numbers.
    script : (n_steps,) array
        Receives the lengths of the accepted steps of a run, as far as there is room; or holds them for a `replay`.

    Attributes
    ----------
    p : (n_parameters + n_memory,) array
        Run-time numbers, and behind them the sampled memory at the start.
    coefficients : (n_segments, n_inputs, 6) array
        Inputs on each segment.
    script : (n_steps,) array
        As it was given.
    is_scripted : bool
        The last `run` reached its end and wrote all its steps down.
    """

    def __init__(self, problem: Problem, script: Array) -> None:
        self.p, self.coefficients, self.script = problem.p.copy(), problem.coefficients.copy(), script
        own = replace(problem, p=self.p, coefficients=self.coefficients, x0=problem.x0.copy())
        self._run, self._replay = Call(own, script), Call(own, script, replay=True)
        # The initial memory goes behind the numbers.
        memory = self.p[len(problem.kernel.model.parameters) :]
        self._start = problem.kernel.caller("start", self.p, own.x0, memory)
        self.is_scripted = False

    def run(self) -> Array:
        """Outputs at the times of the grid."""
        self._start()
        outcome = self._run.again()
        self.is_scripted = outcome.is_success and 0 < int(self._run.counts[0]) <= self.script.size
        return _table(self._run)

    def replay(self) -> Array:
        """The same over the steps of the script, without error control: such runs differ smoothly in the numbers."""
        self._start()
        self._replay.again()
        return _table(self._replay)


def _table(call: Call) -> Array:
    call.table[:, call.counts[2] :] = np.nan
    return call.table
