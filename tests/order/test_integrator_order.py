"""Orders of convergence of the integrator: two-sided, so that neither a loss nor a lucky test passes."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir, Run
from poppet.engine.problem import Outcome
from poppet.engine.solve import solve
from poppet.signals import Sine


@pytest.fixture(scope="module")
def smooth() -> Circuit:
    """A vessel that follows a swinging supply, subsonic throughout: rates with many derivatives."""
    return Circuit(
        {
            "supply": Reservoir(pressure="4 bar"),
            "valve": Orifice(from_="supply", to="tank", sonic_conductance=2e-8, critical_ratio=0.1),
            "tank": Chamber(volume="10 l", initial_pressure="2.5 bar", wall_conductance=1.0, wall_temperature="320 K"),
            "bleed": Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.1),
        },
        {"supply.pressure": Sine(4e5, 0.3e5, 0.5)},
    )


def pressures(circuit: Circuit, step: float, times: np.ndarray) -> np.ndarray:
    """Tank pressure with steps of a fixed length: the error control is switched off by a huge tolerance."""
    problem = circuit.problem(Run(duration=float(times[-1]), relative_tolerance=0.1))
    problem = dataclasses.replace(problem, grid=times, relative_tolerance=1e9, maximum_step=step)
    run = solve(problem)
    assert run.outcome is Outcome.DONE
    assert run.rejected == 0
    return run.values[[name for name, _ in circuit.model.outputs].index("tank.pressure")]


def slopes(errors: list[float]) -> np.ndarray:
    return -np.diff(np.log2(errors))


def reference(circuit: Circuit, times: np.ndarray) -> np.ndarray:
    problem = circuit.problem(Run(duration=float(times[-1]), relative_tolerance=1e-13))
    problem = dataclasses.replace(problem, grid=times)
    return solve(problem).values[[name for name, _ in circuit.model.outputs].index("tank.pressure")]


def test_steps_are_of_order_four(smooth: Circuit) -> None:
    ends = np.array([0.0, 1.6])
    exact = reference(smooth, ends)[-1]
    errors = [abs(pressures(smooth, 0.2 / 2**k, ends)[-1] / exact - 1.0) for k in range(5)]
    found = slopes(errors)
    assert np.all(found > 3.6), (errors, found)
    assert np.all(found < 4.8), (errors, found)


def test_rows_between_steps_are_of_order_four_in_the_step(smooth: Circuit) -> None:
    """The interpolant is of order 3: its error over one step falls with the fourth power of the step."""
    times = np.linspace(0.0, 1.6, 1001)
    exact = reference(smooth, times)
    errors = [float(np.max(np.abs(pressures(smooth, 0.2 / 2**k, times) / exact - 1.0))) for k in range(5)]
    found = slopes(errors)
    assert np.all(found > 3.4), (errors, found)
    assert np.all(found < 4.8), (errors, found)


def test_the_error_follows_the_tolerance(smooth: Circuit) -> None:
    times = np.linspace(0.0, 1.6, 201)
    exact = reference(smooth, times)
    place = [name for name, _ in smooth.model.outputs].index("tank.pressure")
    errors = []
    for tolerance in (1e-4, 1e-6, 1e-8, 1e-10):
        problem = smooth.problem(Run(duration=1.6, relative_tolerance=tolerance))
        run = solve(dataclasses.replace(problem, grid=times))
        errors.append(float(np.max(np.abs(run.values[place] / exact - 1.0))))
    assert all(error < 5.0 * tolerance for error, tolerance in zip(errors, (1e-4, 1e-6, 1e-8, 1e-10), strict=True)), (
        errors
    )
    found = -np.diff(np.log10(errors)) / 2.0
    assert np.all(found > 0.7), (errors, found)
    assert np.all(found < 1.3), (errors, found)
