"""Run of a healthy plant, with its derivatives by faults, nuisances and initial states."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import SimulationError
from poppet.engine.call import NOTHING, Call
from poppet.engine.problem import Problem, ending
from poppet.monitoring.plan import WatchPlan

Array = NDArray[np.float64]

DIFFERENCE = 1e-3
"""Step of the forward differences over a shared step sequence, in alarm sizes or prior standard deviations."""
START_DIFFERENCE = 1e-5
"""Step of the forward differences in an initial state, in nominal sizes of the state."""
SCRIPT_LENGTH = 1_000_000


class Sensitivities(NamedTuple):
    """Outputs of one run, and their derivatives."""

    time: Array  # (n,)
    outputs: Array  # (n_outputs, n)
    by_free: Array  # (m, n_outputs, n) by the faults and nuisances of a plan
    by_start: Array  # (n_states, n_outputs, n) by the initial states, for a change of the nominal size


def sensitivities(plan: WatchPlan, problem: Problem, sizes: Array) -> Sensitivities:
    """Simulate a run and its derivatives by the free numbers and by the initial states.

    Each derivative is the difference to a run with one shifted value over the same steps. In circuits with sampled
    controllers, runs are not smooth functions: there each run chooses its steps, and the shift of a fault is its alarm
    size. `sizes` contains the alarm sizes and the standard deviations of the nuisances, (m,).
    """
    is_sampled = problem.kernel.model.n_timers > 0
    script = NOTHING if is_sampled else np.empty(SCRIPT_LENGTH)
    base = Call(problem, script)
    outcome = base.repeat()
    if not outcome.is_success:
        raise SimulationError(ending(problem, base.result(outcome)))
    script = script[: int(base.counts[0])]
    outputs = base.table.copy()

    def shifted_outputs(shifted: Problem) -> Array:
        call = Call(shifted, script, replay=not is_sampled)
        call.repeat()
        return call.table

    free, k = plan.free, len(plan.free.places)
    by_free = np.empty((len(free.addresses), *outputs.shape))
    for j, directions in enumerate(plan.directions[:, : len(free.addresses)].T):
        step = (1.0 if is_sampled else DIFFERENCE) * sizes[j]
        step = -step if free.values[j] + step > free.high[j] else step
        p, coefficients = problem.p.copy(), problem.coefficients.copy()
        p[free.places] += step * directions[:k]
        coefficients[:, plan.touched_inputs, 0] += step * directions[k:]
        # The initial state can depend on the number.
        x0 = problem.kernel.start(p)
        by_free[j] = (shifted_outputs(replace(problem, p=p, x0=x0, coefficients=coefficients)) - outputs) / step
    states = problem.kernel.model.states
    by_start = np.empty((len(states), *outputs.shape))
    for j, state in enumerate(states):
        step = START_DIFFERENCE * state.nominal
        x0 = problem.x0.copy()
        x0[j] += step
        by_start[j] = (shifted_outputs(replace(problem, x0=x0)) - outputs) * (state.nominal / step)
    return Sensitivities(problem.grid, outputs, by_free, by_start)
