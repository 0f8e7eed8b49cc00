"""A run that goes on from the one before, as hosts ask for it step by step, takes the steps of a run in one piece."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from poppet import load
from poppet.engine.call import Call
from poppet.engine.compiled import integrator
from poppet.engine.job import Job, address
from poppet.engine.problem import Outcome

EXAMPLES = Path(__file__).parents[3] / "examples"
LIMITS = Job._fields.index("limits")


@pytest.mark.parametrize("example", ["fill_staircase", "pressure_control"])
def test_blocks_have_the_bits_of_the_whole_function(example: str) -> None:
    circuit = load(EXAMPLES / f"{example}.toml").with_values({"run.duration": 0.6})
    problem = circuit.problem(circuit.run)
    ends = np.linspace(0.0, 0.6, 7)
    held = problem.coefficients[:1]
    whole = replace(
        problem, starts=ends[:-1], courses=np.zeros(6, dtype=np.int64), coefficients=held, grid=ends,
        jumps=np.zeros(6, dtype=np.bool_),
    )  # fmt: skip
    run = Call(whole).run()
    assert run.outcome is Outcome.DONE

    start, course, jump = np.zeros(1), np.zeros(1, dtype=np.int64), np.zeros(1, dtype=np.bool_)
    piece = replace(problem, starts=start, courses=course, coefficients=held, jumps=jump, grid=ends[1:2].copy())
    call, found = Call(piece), []
    limits = np.array([problem.maximum_step, problem.most_attempts, 0.0, problem.relative_tolerance])
    call._job[LIMITS] = address(limits)
    for begin, end in pairwise(ends):
        start[:], piece.grid[:], call.watch[:], call.counts[:] = begin, end, 0.0, 0
        assert integrator()(address(call._job)) == 0
        found.append((call.x.copy(), call.counts[:2].copy()))
        limits[3] = 0.0
    np.testing.assert_array_equal(found[-1][0], run.x)
    assert sum(int(counts[1]) for _, counts in found) == run.attempts
