"""Runs of one problem in the same arrays: the digits of a fresh run, replays over its steps, runs that fail."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice
from poppet.circuit.options import Run
from poppet.engine.call import RepeatedCall
from poppet.engine.problem import Problem
from poppet.engine.solve import solve

CONDUCTANCE, START = "valve.sonic_conductance", "tank.initial_pressure"


@pytest.fixture
def circuit() -> Circuit:
    valve = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    return Circuit({"tank": Chamber(volume="20 l", initial_pressure=7e5, wall_conductance=5.0), "valve": valve})


@pytest.fixture
def problem(circuit: Circuit) -> Problem:
    return circuit.problem(Run(duration=60.0, output_step=0.5))


def place(problem: Problem, name: str) -> int:
    return problem.kernel.model.parameters.index(name)


def with_number(problem: Problem, name: str, value: float) -> Problem:
    p = problem.p.copy()
    p[place(problem, name)] = value
    return dataclasses.replace(problem, p=p, x0=problem.kernel.start(p))


@pytest.mark.parametrize(("name", "value"), [(CONDUCTANCE, 2e-8), (START, 3e5)])
def test_a_run_gives_the_digits_of_a_fresh_one(problem, name, value):
    repeated = RepeatedCall(problem, np.empty(1000))
    assert np.array_equal(repeated.run(), solve(problem).values)
    repeated.p[place(problem, name)] = value
    assert np.array_equal(repeated.run(), solve(with_number(problem, name, value)).values)
    repeated.p[:] = problem.p
    assert np.array_equal(repeated.run(), solve(problem).values)


def test_a_replay_takes_the_steps_of_the_run_and_leaves_its_table_alone(problem):
    repeated = RepeatedCall(problem, np.empty(1000))
    table = repeated.run()
    kept = table.copy()
    assert repeated.is_scripted
    assert np.array_equal(repeated.replay(), kept)
    repeated.p[place(problem, CONDUCTANCE)] *= 1.0 + 1e-3
    assert not np.array_equal(repeated.replay(), kept)
    assert np.array_equal(table, kept)


def test_rows_that_a_failed_run_did_not_reach_are_not_a_number(problem):
    short = dataclasses.replace(problem, most_attempts=20)
    repeated, fresh = RepeatedCall(short, np.empty(1000)), solve(short)
    table, reached = repeated.run(), fresh.time.size
    assert 0 < reached < problem.grid.size
    assert np.array_equal(table[:, :reached], fresh.values)
    assert np.all(np.isnan(table[:, reached:]))
    assert not repeated.is_scripted


def test_script_with_too_many_steps_is_not_used(problem):
    repeated = RepeatedCall(problem, np.empty(5))
    assert np.array_equal(repeated.run(), solve(problem).values)
    assert not repeated.is_scripted
