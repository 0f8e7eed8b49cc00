"""The table of what was made lately: bounded, and what it forgets lives on where it is used."""

from __future__ import annotations

import gc

import numpy as np

from poppet import Chamber, Circuit, Orifice
from poppet.circuit.options import Run
from poppet.engine import kernel
from poppet.engine.lru_cache import LruCache
from poppet.engine.solve import solve


def test_least_recently_used_entry_is_removed_first():
    table: LruCache[str] = LruCache(2)
    made: list[str] = []

    def get(key: str) -> str:
        return table.get(key, lambda: made.append(key) or key.upper())  # type: ignore[func-returns-value]

    assert [get(key) for key in "abacab"] == list("ABACAB")
    assert made == ["a", "b", "c", "b"]
    assert len(table) == 2


def test_outputs_are_chosen_once():
    circuit = Circuit(
        {
            "tank": Chamber(volume="1 l", initial_pressure="3 bar"),
            "vent": Orifice(from_="tank", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3),
        }
    )
    assert circuit.kernel.observing([1, 0]) is circuit.kernel.observing((1, 0))
    assert circuit.kernel.observing([1]).model.outputs == circuit.kernel.model.outputs[1:2]


def test_code_of_a_removed_entry_still_runs(monkeypatch):
    monkeypatch.setattr(kernel, "KERNELS", LruCache(1))

    def emptied(name: str) -> Circuit:
        return Circuit(
            {
                name: Chamber(volume="1 l", initial_pressure="3 bar"),
                "vent": Orifice(from_=name, to="ambient", sonic_conductance=1e-9, critical_ratio=0.3),
            }
        )

    problem = emptied("first").problem(Run(duration="1 s"))
    p, x, memory = problem.p.copy(), np.empty(problem.x0.size), np.empty(0)
    start = problem.kernel.caller("start", p, x, memory)
    known = solve(problem)
    emptied("second").simulate("1 s")
    gc.collect()
    assert len(kernel.KERNELS) == 1
    assert np.array_equal(solve(problem).values, known.values)
    assert emptied("first").kernel is not problem.kernel
    x0 = problem.x0
    del problem, known
    gc.collect()
    start()
    assert np.array_equal(x, x0)
