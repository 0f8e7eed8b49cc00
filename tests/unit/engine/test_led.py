"""Lanes that make the steps of the first: its digits, smooth differences from it, and runs that fail."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet import Chamber, Circuit, Orifice
from poppet.circuit.options import Run
from poppet.engine.batch import run_batch
from poppet.engine.call import RepeatedCall
from poppet.engine.lane_kernel import LockstepLanes
from poppet.engine.members import Batch
from poppet.engine.problem import Problem
from poppet.signals import Chirp

NAMES = ("valve.sonic_conductance", "valve.critical_ratio", "tank.volume", "tank.initial_pressure", "ambient.pressure")


@pytest.fixture(params=[4, 8])
def width(request, monkeypatch) -> int:
    monkeypatch.setenv("POPPET_LANES", str(request.param))
    return int(request.param)


@pytest.fixture
def problem() -> Problem:
    valve = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    parts = {"tank": Chamber(volume="20 l", initial_pressure=7e5, wall_conductance=5.0), "valve": valve}
    circuit = Circuit(
        parts, {"valve.opening": Chirp(mean=0.6, amplitude=0.3, frequency=0.1, end_frequency=0.5, duration=40.0)}
    )
    return circuit.problem(Run(duration=40.0, output_step=0.25))


def places_of(problem: Problem) -> np.ndarray:
    return np.array([problem.kernel.model.parameters.index(name) for name in NAMES if "ambient" not in name])


def led(problem: Problem, factors: list[float]) -> LockstepLanes:
    """The run as it is, and one for each factor on the numbers in turn."""
    places = places_of(problem)
    found = LockstepLanes(problem, len(factors) + 1, places, ())
    found.values[:] = problem.p[places]
    for k, factor in enumerate(factors):
        found.values[k + 1, k % places.size] *= factor
    return found


@pytest.mark.parametrize("count", [0, 1, 3, 9])
def test_first_run_has_the_same_digits_with_any_followers(problem, width, count):
    tables = led(problem, [1.1] * count).run()
    batch = Batch(problem, places_of(problem), problem.p[places_of(problem)][np.newaxis])
    alone = run_batch(batch, reduce=lambda rows: rows.values.copy(), lanes=width).reduced
    assert tables.shape == (count + 1, *alone.shape[1:])
    assert np.array_equal(tables[0], alone[0])
    # Those of like numbers are alike, in whichever group of lanes.
    for k in range(5, count + 1):
        assert np.array_equal(tables[k], tables[k - 4])


def test_differences_are_those_of_replays(problem, width):
    factor = 1.0 + 1e-6
    tables = led(problem, [factor] * 4).run()
    repeated = RepeatedCall(problem, np.empty(5000))
    base = repeated.run().copy()
    assert repeated.is_scripted
    np.testing.assert_allclose(tables[0], base, rtol=1e-9)
    for k, place in enumerate(places_of(problem)):
        repeated.p[:] = problem.p
        repeated.p[place] *= factor
        known = repeated.replay() - base
        size = np.abs(known).max(axis=1, keepdims=True)
        assert np.all(
            np.abs(tables[k + 1] - tables[0] - known) <= 1e-5 * size + 1e-12 * np.abs(base).max(axis=1)[:, None]
        )


def test_a_run_that_leaves_its_domain_ends_and_the_others_do_not(problem, width):
    known, found = led(problem, [1.1, 1.1, 1.1]).run(), led(problem, [1.1, 1.1, np.nan]).run()
    assert np.isnan(found[3]).all()
    assert np.array_equal(found[:3], known[:3])
    assert np.isfinite(found[:3]).all()


def test_all_runs_end_if_the_first_run_fails(problem, width):
    tables = led(dataclasses.replace(problem, most_attempts=20), [1.1, 1.2]).run()
    reached = np.isfinite(tables).all(axis=1)
    assert 0 < reached[0].sum() < problem.grid.size
    assert np.array_equal(reached[0], reached[1])
    assert np.array_equal(reached[0], reached[2])


def test_inputs_held_at_a_number_follow_it(width):
    valve = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3, opening=0.5)
    circuit = Circuit({"tank": Chamber(volume="20 l", initial_pressure=7e5), "valve": valve})
    problem, names = circuit.problem(Run(duration=20.0, output_step=1.0)), circuit.model.parameters
    place = names.index("valve.opening")
    (held,) = (k for k, item in enumerate(circuit.model.inputs) if item.default == "valve.opening")
    both = LockstepLanes(problem, 2, np.array([place]), ((held, place),))
    both.values[:, 0] = 0.5, 0.6
    row = [name for name, _ in circuit.model.outputs].index("tank.pressure")
    known = circuit.with_values({"valve.opening": 0.6}).simulate(20.0, 1.0, 1e-9)["tank.pressure"]
    np.testing.assert_allclose(both.run()[1, row], known, rtol=1e-5)


def test_problems_that_lanes_do_not_support(problem, monkeypatch):
    examples = Path(__file__).parents[3] / "examples"
    sampled = poppet.load(examples / "pressure_control.toml")
    monkeypatch.setenv("POPPET_LANES", "8")
    assert LockstepLanes.can_run(problem)
    assert not LockstepLanes.can_run(sampled.problem(sampled.run))
    stopping = poppet.load(examples / "two_tanks.toml")
    assert not LockstepLanes.can_run(stopping.problem(stopping.run.changed(stop_when="low.pressure > 4 bar")))
    monkeypatch.setenv("POPPET_LANES", "2")
    assert not LockstepLanes.can_run(problem)
