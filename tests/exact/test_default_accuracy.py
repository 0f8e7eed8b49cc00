"""What the default tolerance promises: p within 1e-5 and T within 3e-5 of a run at 1e-11, on seeded networks."""

from __future__ import annotations

import dataclasses
import sys
from pathlib import Path

import numpy as np
import pytest

from poppet.engine.problem import Outcome
from poppet.engine.solve import solve

sys.path.insert(0, str(Path(__file__).parents[1] / "laws"))
from seeded_networks import problems, random_topology, rows_of, two_chambers


@pytest.mark.parametrize("each", [3, pytest.param(20, marks=pytest.mark.slow)])
def test_ten_networks_at_the_default_tolerance(each: int) -> None:
    generator = np.random.default_rng(10094)
    errors_p, errors_t = [], []
    circuits = [two_chambers(), *(random_topology(generator, ("energy", "energy", "isothermal")) for _ in range(9))]
    for circuit in circuits:
        pressure, temperature = rows_of(circuit, ".pressure"), rows_of(circuit, ".temperature")
        for problem in problems(circuit, generator, each, rows=101, decades=2.0):
            assert problem.relative_tolerance == 1e-6
            run = solve(problem)
            tight = solve(dataclasses.replace(problem, relative_tolerance=1e-11))
            assert run.outcome is tight.outcome is Outcome.DONE
            relative = np.abs(run.values / np.where(tight.values == 0.0, 1.0, tight.values) - 1.0)
            errors_p.append(relative[pressure].max())
            errors_t.append(relative[temperature].max())
    assert len(errors_p) == 10 * each
    assert max(errors_p) <= 1e-5, np.sort(errors_p)[-5:]
    assert max(errors_t) <= 3e-5, np.sort(errors_t)[-5:]
