"""Batches: every run is what a single run is, whatever its neighbours, threads and slices are."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, FlowSource, Orifice
from poppet.circuit.options import Run
from poppet.engine.balances import residuals
from poppet.engine.batch import BatchRows, BatchRun, run_batch
from poppet.engine.lane_kernel import WIDTHS
from poppet.engine.members import Batch
from poppet.engine.problem import Outcome
from poppet.engine.solve import solve

VARIED = "valve.sonic_conductance", "tank.volume", "tank.initial_pressure", "valve.opening"


def batch_of(size: int, *, stop: tuple[str, ...] = (), tolerance: float = 1e-6) -> Batch:
    """A tank that empties through a valve, four numbers of it varied, the default of an input among them."""
    valve = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    circuit = Circuit({"tank": Chamber(volume="20 l", initial_pressure=7e5, wall_conductance=5.0), "valve": valve})
    problem = circuit.problem(Run(duration=60.0, output_step=0.5, stop_when=stop, relative_tolerance=tolerance))
    places = np.array([circuit.instance.place(name) for name in VARIED])
    generator = np.random.default_rng(7)
    values = problem.p[places] * (1.0 + 0.1 * generator.uniform(-1.0, 1.0, (size, len(VARIED))))
    opening = circuit.instance.input_names.index("valve.opening")
    return Batch(problem, places, values, ((opening, int(places[3])),))


def all_rows(rows: BatchRows) -> np.ndarray:
    return rows.values.copy()


def reordered(batch: Batch, order: np.ndarray) -> Batch:
    return Batch(batch.problem, batch.places, batch.values[order], batch.held)


def same(one: BatchRun, other: BatchRun, order: Any = slice(None)) -> bool:
    """All digits are the same."""
    pairs = (one.ends.record, other.ends.record), (one.ends.counts, other.ends.counts), (one.reduced, other.reduced)
    return all(np.array_equal(a[order], b, equal_nan=True) for a, b in pairs)


@pytest.mark.parametrize("stop", [(), ("tank.pressure < 3 bar",)])
def test_a_run_gives_the_digits_of_a_single_one(stop):
    batch = batch_of(20, stop=stop)
    found = run_batch(batch, reduce=all_rows, threads=2, lanes=1)
    assert found.reduced is not None
    for k in range(batch.size):
        problem = batch.member(k)
        single = solve(problem)
        n = single.time.size
        assert found.ends.outcomes[k] is single.outcome is (Outcome.STOPPED if stop else Outcome.DONE)
        assert np.array_equal(found.reduced[k, :, :n], single.values)
        assert np.isnan(found.reduced[k, :, n:]).all()
        assert np.array_equal(found.ends.last[k], single.values[:, -1])
        assert np.array_equal(found.ends.x[k], single.x)
        assert np.array_equal([found.ends.least[k], found.ends.greatest[k]], single.extremes)
        assert (found.ends.accepted[k], found.ends.rejected[k]) == (single.accepted, single.rejected)
        assert found.ends.reached[k, 0] == single.reached
        assert {r.name: r.error / r.allowed for r in residuals(problem, single)} == {
            name: values[k] for name, values in found.residuals().items()
        }
    assert max(values.max() for values in found.residuals().values()) < 1.0


@pytest.mark.parametrize("lanes", WIDTHS)
def test_order_and_threads_change_no_digit(lanes):
    batch, order = batch_of(41), np.random.default_rng(1).permutation(41)
    alone = run_batch(batch, reduce=all_rows, threads=1, lanes=lanes)
    assert alone.width == lanes
    assert same(alone, run_batch(batch, reduce=all_rows, threads=2, lanes=lanes))
    assert same(alone, run_batch(reordered(batch, order), reduce=all_rows, threads=2, lanes=lanes), order)


@pytest.mark.parametrize("stop", [(), ("tank.pressure < 3 bar",)])
@pytest.mark.parametrize("lanes", WIDTHS[1:])
def test_lanes_give_what_single_runs_give(lanes, stop):
    batch = batch_of(20, stop=stop)
    found, scalar = (run_batch(batch, reduce=all_rows, lanes=width) for width in (lanes, 1))
    assert found.ends.outcomes == scalar.ends.outcomes
    assert np.array_equal(found.ends.counts[:, 2:4], scalar.ends.counts[:, 2:4])
    assert np.abs(found.ends.accepted - scalar.ends.accepted).max() <= 1
    assert np.array_equal(np.isnan(found.reduced), np.isnan(scalar.reduced))
    size = np.nanmax(np.abs(scalar.reduced), axis=(0, 2))[:, None]
    assert np.nanmax(np.abs(found.reduced - scalar.reduced) / size) < 1e-7
    assert max(values.max() for values in found.residuals().values()) < 1.0
    for name in ("x0", "x", "least", "greatest", "through", "initial_energies", "final_energies", "last", "reached"):
        mine, his = getattr(found.ends, name), getattr(scalar.ends, name)
        assert np.allclose(mine, his, rtol=1e-6, atol=1e-9 * np.abs(his).max()), name


def test_progress_and_interruption():
    batch, seen = batch_of(40), []
    run_batch(batch, progress=seen.append, threads=2)
    assert seen[-1] == 40

    def interrupt(done: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_batch(batch_of(100_000), progress=interrupt, threads=2)


def test_error_of_the_reduce_function_is_raised():
    def fail(rows: BatchRows) -> np.ndarray:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        run_batch(batch_of(4), reduce=fail)


@pytest.mark.parametrize("lanes", [1, 4])
def test_stalled_run_is_repeated_like_a_single_run(lanes):
    """Of three tanks the second is drawn empty, on which every method stalls."""
    circuit = Circuit({"tank": Chamber(volume="1 l"), "pull": FlowSource(to="tank", mass_flow_rate=-1e-4)})
    problem = replace(circuit.problem(Run(duration=5.0, output_step=0.5)), most_attempts=1000)
    drawn = circuit.instance.input_names.index("pull.mass_flow_rate"), circuit.instance.place("pull.mass_flow_rate")
    batch = Batch(problem, np.array(drawn[1:]), np.array([[-1e-4], [-1e-3], [1e-4]]), (drawn,))
    found = run_batch(batch, reduce=all_rows, lanes=lanes)
    single = solve(batch.member(1))
    assert [outcome.name for outcome in found.ends.outcomes] == ["DONE", "STALLED", "DONE"]
    assert found.notes == {1: single.notes}
    assert [note.code for note in single.notes] == ["run.no_way_on"]
    assert found.reduced is not None
    assert np.array_equal(found.reduced[1, :, : single.time.size], single.values)
    assert np.isnan(found.reduced[1, :, single.time.size :]).all()
