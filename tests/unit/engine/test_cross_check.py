"""The independent solvers: where runs stop, fail, or have little to solve."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from poppet import Circuit
from poppet.engine.problem import Outcome, Problem
from poppet.engine.reference_solvers.solvers import SOLVERS, solve_with_reference
from poppet.engine.solve import solve
from poppet.parts import Chamber, FlowSource, Orifice, Reservoir
from poppet.signals import Chirp, Steps
from refusals import refused

SIZE = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}


def filling(signals=None, **tank) -> Circuit:
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "fill": Orifice(from_="supply", to="tank", **SIZE),
        "tank": Chamber(**{"volume": "10 l", **tank}),
    }
    return Circuit(parts, signals or {})


def problem_of(circuit: Circuit, duration: float, step: float, tolerance: float = 1e-6, stop_when=None) -> Problem:
    return circuit.problem(
        circuit.run.changed(duration=duration, output_step=step, relative_tolerance=tolerance, stop_when=stop_when)
    )


@pytest.mark.parametrize("solver", SOLVERS)
class TestStopping:
    def test_at_the_instant_the_kernel_finds(self, solver):
        problem = problem_of(filling(), 20.0, 0.5, 1e-9, ["tank.temperature > 900 K", "tank.pressure > 5 bar"])
        kernel, other = solve(problem), solve(problem, solver)
        assert (other.outcome, other.stop) == (Outcome.STOPPED, 1)
        assert other.time.size == kernel.time.size
        assert other.time[-1] == pytest.approx(kernel.time[-1], rel=1e-7)
        row = [name for name, _ in problem.kernel.model.outputs].index("tank.pressure")
        assert other.values[row, -1] == pytest.approx(5e5, rel=1e-7)
        np.testing.assert_allclose(other.x, kernel.x, rtol=1e-6, atol=1e-6)

    def test_at_once_when_the_condition_holds_at_the_start(self, solver):
        run = solve(problem_of(filling(), 20.0, 0.5, stop_when="tank.pressure < 2 bar"), solver)
        assert (run.outcome, run.time.tolist(), run.values.shape[1]) == (Outcome.STOPPED, [0.0], 1)

    def test_on_the_jump_of_an_input(self, solver):
        circuit = filling({"supply.pressure": Steps([0.0, 1.25], [7e5, 3e5])})
        run = solve(problem_of(circuit, 5.0, 0.5, stop_when="supply.pressure < 4 bar"), solver)
        assert (run.outcome, run.time.tolist()) == (Outcome.STOPPED, [0.0, 0.5, 1.0, 1.25])


@pytest.mark.parametrize("solver", SOLVERS)
class TestFailing:
    def test_emptied_gas_node_stalls_and_keeps_the_rows(self, solver):
        parts = {"tank": Chamber(volume="1 l"), "pull": FlowSource(to="tank", mass_flow_rate=-1e-3)}
        problem = problem_of(Circuit(parts), 5.0, 0.05)
        empty = problem.x0[1] / 1e-3
        run = solve_with_reference(problem, solver)
        assert run.outcome is Outcome.STALLED
        assert empty - 0.2 < run.time[-1] < empty
        assert np.array_equal(run.time, problem.grid[: run.time.size])
        assert np.all(np.isfinite(run.values))
        assert np.all(run.x[:2] > 0.0)

    def test_rates_that_are_not_finite_leave_no_rows(self, solver):
        problem = problem_of(filling(), 1.0, 0.1)
        run = solve_with_reference(replace(problem, x0=problem.x0 * np.nan), solver)
        assert (run.outcome, run.time.size) == (Outcome.NOT_FINITE, 0)
        assert run.values.shape == (len(problem.kernel.model.outputs), 0)

    def test_too_many_steps_keep_the_rows_so_far(self, solver):
        problem = problem_of(filling({"supply.pressure": Chirp(5e5, 1e5, 1.0, 20.0)}), 10.0, 0.05)
        run = solve_with_reference(replace(problem, most_attempts=100), solver)
        assert run.outcome is Outcome.TOO_MANY
        assert 0 < run.time.size < problem.grid.size
        assert np.array_equal(run.time, problem.grid[: run.time.size])


@pytest.mark.parametrize("solver", SOLVERS)
def test_reservoirs_alone_have_integrals_only(solver):
    parts = {"supply": Reservoir(pressure="7 bar"), "leak": Orifice(from_="supply", to="ambient", **SIZE)}
    problem = problem_of(Circuit(parts, {"supply.pressure": Steps([0.0, 1.0], [7e5, 14e5])}), 3.0, 0.5)
    assert problem.kernel.model.states == ()
    run = solve(problem, solver)
    choked = 1e-8 * 1.185 * 7e5
    assert run.outcome is Outcome.DONE
    assert run.x[0] == pytest.approx(choked * (1.0 + 2.0 * 2.0), rel=1e-9)
    assert run.through[0] == pytest.approx(run.x[0], rel=1e-12)


@pytest.mark.parametrize("solver", SOLVERS)
def test_rows_at_arbitrary_times(solver):
    problem = problem_of(filling({"supply.pressure": Steps([0.0, 2.0], [7e5, 3e5])}), 5.0, 1.0, 1e-9)
    times = np.sort(np.random.default_rng(3).uniform(0.0, 5.0, 100))
    problem = replace(problem, grid=np.concatenate([[0.0], times, [5.0]]))
    kernel, other = solve(problem), solve(problem, solver)
    assert np.array_equal(other.time, problem.grid)
    rows = [k for k, (_, unit) in enumerate(problem.kernel.model.outputs) if unit in ("Pa", "K", "kg")]
    np.testing.assert_allclose(other.values[rows], kernel.values[rows], rtol=1e-7)


@pytest.mark.parametrize("solver", SOLVERS)
def test_extremes_and_total_change(solver):
    problem = problem_of(filling({"supply.pressure": Steps([0.0, 2.0], [7e5, 1e5])}), 6.0, 0.01, 1e-8)
    kernel, other = solve(problem), solve(problem, solver)
    np.testing.assert_allclose(other.extremes, kernel.extremes, rtol=1e-4, atol=1e-9)
    np.testing.assert_allclose(other.through, kernel.through, rtol=1e-3)


@pytest.mark.parametrize("solver", SOLVERS)
def test_longest_step_is_kept(solver):
    problem = replace(problem_of(filling(), 1.0, 0.5), maximum_step=1e-3)
    assert solve_with_reference(problem, solver).accepted >= 1000


def test_unknown_solver():
    with refused("fields.not_an_option", "run.solver", value="cvode") as caught:
        solve(problem_of(filling(), 1.0, 0.5), "cvode")
    assert caught.value.facts["suggestion"].names[0] == "cvodes"


def test_tolerance_tightens_the_solution():
    reference = solve(problem_of(filling(), 5.0, 0.1, 1e-11))
    for solver in SOLVERS:
        coarse, fine = (solve(problem_of(filling(), 5.0, 0.1, tol), solver) for tol in (1e-4, 1e-8))
        errors = [np.max(np.abs(run.x[:2] / reference.x[:2] - 1.0)) for run in (coarse, fine)]
        assert errors[1] < 1e-7
        assert errors[1] < 0.1 * errors[0]
