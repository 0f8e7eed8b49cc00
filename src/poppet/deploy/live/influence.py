"""Influence of the numbers of a circuit file on the curves of a page."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import InputError
from poppet.engine.call import Call
from poppet.engine.problem import Problem

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

STEP = 0.02
"""Change of a number, divided by the range of its slider."""
MAX_WORK = 8_000_000
"""Largest number of solver steps of all runs times states; a run that is too long is compared over its first part."""
_TOLERANCE = 1e-5


def influences(
    circuit: BaseCircuit, variants: Sequence[Iterable[BaseCircuit]], outputs: Sequence[int]
) -> NDArray[np.float64]:
    """Return the influence of each change of a circuit on its outputs.

    Parameters
    ----------
    circuit : Circuit
        Circuit with a duration.
    variants : sequence of iterable of Circuit
        Copies of the circuit for each change, of which the first valid one is used.
    outputs : sequence of int
        Indices of the outputs.

    Returns
    -------
    (n,) array
        Root mean square of the change of the outputs over time, each divided by its range in the run of `circuit`, for
        each change. It is 0 if there is no valid copy.
    """
    problem = circuit.problem(circuit.run)
    most = max(300, MAX_WORK // (problem.x0.size * (1 + len(variants))))
    base = _rows(problem, outputs, most)
    sizes = np.ptp(base, axis=1) if base.size else np.zeros(len(outputs))
    is_moving = sizes > 0.0
    result = np.zeros(len(variants))
    for k, copies in enumerate(variants):
        try:
            changed = next(iter(copies))
        except (StopIteration, InputError):
            continue
        rows = _rows(changed.problem(changed.run), outputs, most)
        n = min(rows.shape[1], base.shape[1])
        if n and is_moving.any():
            change = (rows[is_moving, :n] - base[is_moving, :n]) / sizes[is_moving, None]
            result[k] = np.sqrt(np.mean(change**2))
    return result


def _rows(problem: Problem, outputs: Sequence[int], max_attempts: int) -> NDArray[np.float64]:
    """Return the values of selected outputs in a run, shape (n_outputs, n_times).

    `outputs` contains the indices of the outputs. The run ends after `max_attempts` attempted steps at the latest.
    """
    call = Call(
        replace(problem, relative_tolerance=max(_TOLERANCE, problem.relative_tolerance), most_attempts=max_attempts)
    )
    call.repeat()
    return np.array(call.table[list(outputs), : int(call.counts[2])])
