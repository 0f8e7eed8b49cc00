"""Code of large models: first without optimisation, with the same bits, and replaced when runs take long."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from circuits_of_exports import TEN, chambers, example
from poppet import Circuit
from poppet.engine import call, compiled, kernel
from poppet.engine.call import Call, RepeatedCall
from poppet.engine.kernel import Kernel, compile_kernel
from poppet.engine.lru_cache import LruCache
from poppet.engine.problem import Problem
from poppet.engine.tier import Tier

CIRCUITS: dict[str, Callable[[], Circuit]] = {
    "staircase": TEN["staircase"],
    "regulator": TEN["switched"],
    "cylinder": TEN["cylinder"],
    "sequence": lambda: example("two_cylinders", "1 s"),
}


@pytest.fixture
def _all_are_large(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Treat small models as large ones, with empty caches, after the integrator is compiled."""
    compiled.integrator()
    monkeypatch.setattr(call, "INTERVAL", 0.002)
    monkeypatch.setattr(kernel, "LARGE", 0)
    monkeypatch.setattr(kernel, "KERNELS", LruCache(100))
    monkeypatch.setenv("POPPET_CACHE_DIR", str(tmp_path))


def quick_kernel(circuit: Circuit, expected: float = np.inf) -> tuple[Kernel, Tier]:
    """Return a kernel without optimisation, and its tier with another expected time of the optimisation."""
    quick = compile_kernel(circuit.model)
    assert quick.tier is not None
    quick.tier.expected = expected
    return quick, quick.tier


def problem_of(circuit: Circuit, own: Kernel) -> Problem:
    problem = circuit.problem(circuit.run)
    p = problem.p.copy()
    return replace(problem, kernel=own, x0=own.start(p), p=p)


LONG = {"run.duration": "200 s", "run.output_step": "1 ms"}


@pytest.mark.usefixtures("_all_are_large")
@pytest.mark.parametrize("name", CIRCUITS)
def test_code_without_optimisation_gives_the_bits_of_optimised_code(name):
    circuit = CIRCUITS[name]()
    quick, tier = quick_kernel(circuit)
    first = Call(problem_of(circuit, quick)).run()
    assert not tier.is_optimised
    quick.optimise()
    second = Call(problem_of(circuit, quick)).run()
    stored = compile_kernel(circuit.model)
    assert stored.tier is None, "the optimised code is on the disk"
    third = Call(problem_of(circuit, stored)).run()
    for run in (second, third):
        assert (run.accepted, run.rejected) == (first.accepted, first.rejected)
        assert np.array_equal(run.values, first.values, equal_nan=True)


@pytest.mark.usefixtures("_all_are_large")
def test_a_run_continues_with_optimised_code_when_it_takes_long():
    circuit = chambers(3).with_values(LONG)
    quick, tier = quick_kernel(circuit)
    expected = Call(problem_of(circuit, quick)).run()
    assert not tier.is_optimised
    quick, tier = quick_kernel(circuit, 0.001)
    threads = threading.active_count()
    run = Call(problem_of(circuit, quick)).run()
    assert tier.is_optimised
    assert np.array_equal(run.values, expected.values)
    assert threading.active_count() == threads


@pytest.mark.usefixtures("_all_are_large")
def test_many_runs_are_optimised():
    circuit = TEN["staircase"]()
    quick, tier = quick_kernel(circuit)
    run = Call(problem_of(circuit, quick))
    run.repeat()
    assert tier.seconds > 0.0
    assert not tier.is_optimised
    table, tier.expected = run.table.copy(), 0.5 * tier.seconds
    run.repeat()
    assert tier.is_optimised
    assert np.array_equal(run.table, table)


@pytest.mark.usefixtures("_all_are_large")
def test_fits_begin_with_optimised_code():
    circuit = TEN["staircase"]()
    quick, tier = quick_kernel(circuit)
    RepeatedCall(problem_of(circuit, quick), np.empty(0))
    assert tier.is_optimised


@pytest.mark.usefixtures("_all_are_large")
def test_an_interrupt_ends_the_run_and_its_thread(monkeypatch):
    circuit = chambers(3).with_values(LONG)
    quick, tier = quick_kernel(circuit)

    def interrupted(seconds: float = 0.0) -> None:
        if seconds:
            raise KeyboardInterrupt

    monkeypatch.setattr(tier, "review", interrupted)
    threads = threading.active_count()
    run = Call(problem_of(circuit, quick))
    with pytest.raises(KeyboardInterrupt):
        run.run()
    assert threading.active_count() == threads
    assert run.watch[0] < 200.0


def test_small_models_are_optimised_at_once(monkeypatch):
    monkeypatch.setattr(compiled, "_load_quick", None)
    assert compile_kernel(TEN["staircase"]().model).tier is None
