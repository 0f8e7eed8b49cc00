"""Lanes: what they compute with, circuits of every kind in them, and that no lane sees another."""

from __future__ import annotations

import ctypes
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest

import poppet
from poppet import Chamber, Circuit, Orifice, Reservoir, loads
from poppet.circuit.options import Run
from poppet.engine.batch import BatchRows, BatchRun, run_batch
from poppet.engine.job import LaneJob
from poppet.engine.lane_kernel import WIDTHS, Lanes, _compile, lane_functions, usual_width
from poppet.engine.members import Batch, RunEnds
from poppet.engine.printers import llvm_lanes
from poppet.engine.printers.llvm import OF_ONE, OF_TWO, Kind, print_function
from poppet.engine.problem import Outcome
from poppet.engine.solve import solve
from poppet.signals import Chirp, Points, Steps

sys.path.insert(0, str(Path(__file__).parents[2] / "laws"))
sys.path.insert(0, str(Path(__file__).parent))
from seeded_networks import random_topology
from test_printer import BINARY, UNARY, VALUES, A, B

VECTORS = WIDTHS[1:]
EXAMPLES = Path(__file__).parents[3] / "examples"


def aligned(*shape: int) -> np.ndarray:
    """Zeros that begin where the widest element may."""
    size = int(np.prod(shape))
    block = np.zeros(size + 8)
    first = -block.ctypes.data % 64 // 8
    return block[first : first + size].reshape(shape)


def in_lanes(expressions: list[Any], width: int, *columns: np.ndarray) -> np.ndarray:
    """Values of expressions in A and B for rows of numbers, (n_expressions, n_rows), `width` rows at a time."""
    kind, names = Kind(width), [A, B][: len(columns)]
    function = ca.Function("f", names, [ca.densify(ca.vertcat(*expressions))])
    code = _compile(kind, [print_function(function, "f", kind)], ("f",))
    call = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * (len(columns) + 1))(code.addresses["f"])
    given, found, out = aligned(len(columns), width), aligned(len(expressions), width), []
    for k in range(0, len(columns[0]), width):
        rest = min(width, len(columns[0]) - k)
        for row, column in zip(given, columns, strict=True):
            row[:rest] = column[k : k + rest]
        call(*(row.ctypes.data for row in given), found.ctypes.data)
        out.append(found[:, :rest].copy())
    return np.concatenate(out, axis=1)


@pytest.fixture(params=["library", "one by one"])
def functions(request, monkeypatch):
    """With the functions of a vector library, and without."""
    if request.param == "one by one":
        monkeypatch.setattr(llvm_lanes, "vector_functions", lambda width: {})


@pytest.mark.usefixtures("functions")
@pytest.mark.parametrize("width", VECTORS)
def test_operations(width):
    """All of them in one function each of one and of two, against CasADi, for values in every place of the lanes."""
    every = [(a, b) for a in VALUES for b in VALUES if abs(b) < 100.0 and a != 0.0 and b != 0.0]
    pairs, expressions = np.random.default_rng(3).permutation(np.array(every)), {**UNARY, **BINARY}
    found = in_lanes([ca.densify(each) for each in expressions.values()], width, *pairs.T)
    for name, expression, values in zip(expressions, expressions.values(), found, strict=True):
        function = ca.Function("f", [A, B], [ca.densify(expression)])
        known = np.array([float(function(*pair)) for pair in pairs])
        np.testing.assert_allclose(values, known, rtol=2e-15, atol=0.0, err_msg=name)


@pytest.mark.parametrize("width", VECTORS)
def test_roots_and_inverses_of_any_size(width):
    values = np.concatenate([10.0 ** np.linspace(-300, 300, 400), [0.0, np.inf, np.nan, -1.0]])
    with np.errstate(all="ignore"):
        every = np.array([np.sqrt(values), 1.0 / values])
    for found, known in zip(in_lanes([ca.sqrt(A), 1.0 / A], width, values), every, strict=True):
        finite = np.isfinite(known)
        np.testing.assert_allclose(found[finite], known[finite], rtol=4e-16, atol=0.0)
        assert not np.isfinite(found[~finite]).any()


@pytest.mark.parametrize("width", VECTORS)
def test_an_exponent_of_a_half_is_a_root_whatever_the_neighbours_have(width):
    bases, halves = np.linspace(0.1, 9.0, 40), np.full(40, 0.5)
    mixed = np.where(np.arange(40) % 3 == 1, 0.7, np.where(np.arange(40) % 5 == 1, -0.5, 0.5))
    alone, among = (in_lanes([A**B], width, bases, exponents)[0] for exponents in (halves, mixed))
    assert np.array_equal(alone[mixed == 0.5], among[mixed == 0.5])
    assert np.allclose(among, bases**mixed, rtol=1e-15)


def test_vector_library_is_found_if_available():
    if sys.platform != "linux" or usual_width() < 4:
        pytest.skip("no vector library is looked for")
    pytest.importorskip("ctypes").CDLL("libmvec.so.1")
    assert set(llvm_lanes.vector_functions(4)) >= {"exp", "log", "sin", "cos", "pow"}
    assert set(llvm_lanes.vector_functions(4)) <= {*OF_ONE, *OF_TWO}


def test_width_is_selectable(monkeypatch):
    assert usual_width() in WIDTHS
    monkeypatch.setenv("POPPET_LANES", "2")
    assert usual_width() == 2


# --- Circuits ---

SEEN = ".volume", "sonic_conductance", "wall_conductance", "damping", ".mass", "rate", ".pressure"


def varied(circuit: Circuit, runs: int, *, part: float = 0.02, run: Run | None = None, seed: int = 5) -> Batch:
    """Runs of a circuit with sizes that differ by some per cent, and its inputs with them."""
    problem, names = circuit.problem(run or circuit.run), circuit.model.parameters
    places = np.array([k for k, name in enumerate(names) if name.endswith(SEEN) and problem.p[k] != 0.0])
    factors = 1.0 + part * np.random.default_rng(seed).uniform(-1.0, 1.0, (runs, places.size))
    held = tuple(
        (k, names.index(item.default))
        for k, item in enumerate(circuit.model.inputs)
        if isinstance(item.default, str) and item.name not in circuit.signals and not item.slope_of
    )
    return Batch(problem, places, problem.p[places] * factors, held)


def all_rows(rows: BatchRows) -> np.ndarray:
    return rows.values.copy()


def apart(circuit: Circuit, one: BatchRun, other: BatchRun, ending: str) -> float:
    """Largest difference of outputs in parts of their size."""
    places = [k for k, (name, _) in enumerate(circuit.model.outputs) if name.endswith(ending)]
    assert places
    assert one.reduced is not None
    assert other.reduced is not None
    a, b = one.reduced[:, places], other.reduced[:, places]
    return float(np.nanmax(np.abs(a - b)) / np.nanmax(np.abs(b)))


@pytest.mark.parametrize(
    ("name", "bound"),
    [
        ("two_tanks", 1e-9),
        ("emptying", 1e-6),
        ("pressure_control", 1e-9),
        ("datasheet_valve", 2e-4),
        ("muscle_lift", 1e-4),
        ("vertical_load", 1e-3),
    ],
)
def test_examples(name, bound):
    """Stop conditions, sampled memory, moving inputs, bodies: pressures as those of single runs."""
    circuit = poppet.load(EXAMPLES / f"{name}.toml")
    batch = varied(circuit, 11)
    scalar, found = (run_batch(batch, reduce=all_rows, threads=1, lanes=width) for width in (1, 4))
    assert found.ends.outcomes == scalar.ends.outcomes
    assert apart(circuit, found, scalar, ".pressure") < bound
    assert max(values.max() for values in found.residuals().values()) < 1.0
    assert not found.notes


def test_sampled_memory_is_that_of_a_lane_alone():
    """Of the same runs in another order every digit is the same, memory, stop conditions and rows among them."""
    circuit = poppet.load(EXAMPLES / "pressure_control.toml")
    batch, order = varied(circuit, 13, run=circuit.run.changed(stop_when="tank.pressure > 4 bar")), np.arange(13)[::-1]
    one = run_batch(batch, reduce=all_rows, threads=1, lanes=4)
    other = run_batch(Batch(batch.problem, batch.places, batch.values[order], batch.held), reduce=all_rows, lanes=4)
    assert np.array_equal(one.ends.record[order], other.ends.record, equal_nan=True)
    assert np.array_equal(one.ends.counts[order], other.ends.counts)
    assert np.array_equal(one.reduced[order], other.reduced, equal_nan=True)


@pytest.mark.parametrize(("topologies", "each"), [(2, 24), pytest.param(40, 200, marks=pytest.mark.slow)])
def test_random_networks(topologies, each):
    """Sizes that differ threefold: every run is done, finite, as the scalar one, and its balances are kept."""
    generator = np.random.default_rng(17)
    broken = 0
    for _ in range(topologies):
        circuit = random_topology(generator, ("energy", "isothermal", "isentrope"))
        grid_end = 10.0 ** generator.uniform(-1.0, 2.0)
        batch = varied(circuit, each, part=0.5, run=Run(duration=grid_end, output_step=grid_end / 30), seed=23)
        found, scalar = (run_batch(batch, reduce=all_rows, lanes=width) for width in (usual_width(), 1))
        assert all(outcome.is_success for outcome in found.ends.outcomes)
        assert np.isfinite(found.reduced).all()
        assert apart(circuit, found, scalar, ".pressure") < 1e-5
        broken += sum(int((values > 1.0).sum()) for values in found.residuals().values())
    assert broken <= 0.01 * topologies * each


STAIRCASE = """
[parts]
supply = { kind = "reservoir", pressure = "7 bar" }
room = { kind = "reservoir", pressure = "1 bar" }
valve = { kind = "main_stage", data = "varga2012", supply = "supply", outlet = "tank", exhaust = "room" }
tank = { kind = "chamber", volume = "0.2 m^3", wall_conductance = "45 W/K" }
[signals."valve.pilot_pressure"]
kind = "steps"
times = [0, 20, 40, 60, 80, 100]
values = ["1 bar g", "2 bar g", "3 bar g", "4 bar g", "5 bar g", "0 bar g"]
[run]
duration = "120 s"
output_step = "0.1 s"
"""
EIGHT = (
    *("tank.volume", "tank.wall_conductance", "supply.pressure", "valve.plate_area", "valve.damping"),
    *("valve.upper_spring.rate", "valve.lower_spring.rate", "valve.moving_mass"),
)


@pytest.mark.parametrize("count", [10, pytest.param(500, marks=pytest.mark.slow)])
def test_the_paper_staircase_against_tight_single_runs(count):
    """Eight numbers varied by 10 %: pressures within 2e-5 of single runs at 1e-9, balances kept."""
    circuit = loads(STAIRCASE)
    names = circuit.model.parameters
    problem = circuit.problem(circuit.run)
    kernel = problem.kernel.observing([[name for name, _ in circuit.model.outputs].index("tank.pressure")])
    places = np.array([names.index(name) for name in EIGHT])
    values = problem.p[places] * (1.0 + 0.1 * np.random.default_rng(1).uniform(-1.0, 1.0, (count, 8)))
    loose = run_batch(Batch(replace(problem, kernel=kernel), places, values), reduce=all_rows)
    fine = replace(problem, kernel=kernel, relative_tolerance=1e-9)
    tight = run_batch(Batch(fine, places, values), reduce=all_rows, lanes=1)
    assert np.max(np.abs(loose.reduced / tight.reduced - 1.0)) < 2e-5
    assert max(each.max() for each in loose.residuals().values()) < 1.0
    assert not loose.notes


def test_inputs_that_move_and_jump():
    """A chirp on the opening of a valve, and another that jumps: rows lie where inputs are in the midst of moving."""
    parts = {
        "supply": Reservoir(pressure=6e5),
        "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
        "tank": Chamber(volume="5 l", wall_conductance=2.0),
        "drain": Orifice(from_="tank", to="ambient", sonic_conductance=4e-9, critical_ratio=0.3),
    }
    signals = {
        "fill.opening": Chirp(mean=0.5, amplitude=0.4, frequency=0.2, end_frequency=2.0, duration=8.0),
        "drain.opening": Steps([0.0, 3.0, 6.0], [1.0, 0.2, 0.7]),
    }
    circuit = Circuit(parts, signals)
    batch = varied(circuit, 11, run=Run(duration=8.0, output_step=0.01))
    scalar, found = (run_batch(batch, reduce=all_rows, lanes=width) for width in (1, 4))
    assert apart(circuit, found, scalar, ".pressure") < 1e-6
    assert apart(circuit, found, scalar, ".opening") < 1e-13
    assert np.array_equal(found.ends.counts[:, 2], scalar.ends.counts[:, 2])


def test_inputs_that_vary_for_a_time_do_not_change_digits_of_other_lanes():
    """Lanes come to the ends of ramps at different steps; whoever is beside a lane, it calls the same functions."""
    parts = {
        "supply": Reservoir(pressure=6e5),
        "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
        "tank": Chamber(volume="5 l", wall_conductance=2.0),
    }
    circuit = Circuit(parts, {"fill.opening": Points([0.0, 1.0, 3.0, 4.0], [0.0, 1.0, 1.0, 0.3])})
    batch = varied(circuit, 20, part=0.5, run=Run(duration=8.0, output_step=0.1))
    order = np.random.default_rng(4).permutation(20)
    one, other = (run_batch(each, reduce=all_rows) for each in (batch, replace(batch, values=batch.values[order])))
    assert np.array_equal(one.reduced[order], other.reduced)
    worker = Lanes(batch, RunEnds.of(batch), lane_functions(batch.problem.kernel, 4), 4)
    job = LaneJob(*worker._job.tolist())
    assert job.jacobian_held == job.jacobian


def test_a_lane_that_stalls_leaves_its_run_to_the_scalar_kernel(monkeypatch):
    """The lane is made to: its run has then every digit of a single one, and its neighbours have theirs."""
    circuit = poppet.load(EXAMPLES / "two_tanks.toml")
    batch, step = varied(circuit, 9), Lanes.run
    known = run_batch(batch, reduce=all_rows, lanes=4)

    def run(self: Lanes, first: int, last: int, table: Any) -> None:
        step(self, first, last, table)
        self.ends.counts[first:last][np.arange(first, last) == 5, 5] = tuple(Outcome).index(Outcome.STALLED)

    monkeypatch.setattr(Lanes, "run", run)
    found, single = run_batch(batch, reduce=all_rows, lanes=4, threads=1), solve(batch.member(5))
    assert found.notes == {5: ()}
    assert found.ends.outcomes[5] is Outcome.DONE
    assert np.array_equal(found.reduced[5], single.values)
    assert np.array_equal(found.ends.x[5], single.x)
    others = np.arange(9) != 5
    assert np.array_equal(found.reduced[others], known.reduced[others])
