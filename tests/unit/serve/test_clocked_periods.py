"""Periods at deadlines, which the first of two threads runs."""

from __future__ import annotations

import os
import threading
import time
from multiprocessing import Pipe
from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.serve import clocked_periods
from poppet.serve.clocked_periods import ClockedPeriods, MachineClock, two_processors
from poppet.serve.exchange import BEHIND, Exchange
from poppet.serve.machine import PeriodLoop, layout_of
from poppet.serve.plant import ServedPlant
from poppet.serve.points import ServedCircuit
from poppet.serve.priority import NORMAL


@pytest.fixture(scope="module")
def served() -> ServedCircuit:
    return ServedCircuit.of(
        Circuit({
            "supply": Reservoir(pressure="7 bar"),
            "hole": Orifice(from_="supply", to="tank", sonic_conductance=1e-9, critical_ratio=0.3),
            "tank": Chamber(volume="1 l"),
        })
    )  # fmt: skip


@pytest.fixture(autouse=True)
def normal_priority(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(clocked_periods, "raise_priority", lambda children: NORMAL)


class Run:
    """Run of a plant in this process."""

    def __init__(self, served: ServedCircuit, clock: MachineClock, kind: type[ClockedPeriods] = ClockedPeriods) -> None:
        layout = layout_of(served)
        self.plant, self.exchange = ServedPlant(served, clock.period), Exchange(layout, bytearray(layout.size))
        self.loop = PeriodLoop(self.plant, self.exchange)
        self.reports, reports = Pipe(duplex=False)
        self.periods = kind(self.loop, self.plant, self.exchange, clock, reports)


class StuckMainThread(ClockedPeriods):
    """Periods whose main thread is not woken before the end."""

    def _wait_for(self, deadline: float) -> None:
        if threading.current_thread() is threading.main_thread():
            while not self._has_ended:
                time.sleep(1e-3)
        super()._wait_for(deadline)


def test_each_period_runs_once(served: ServedCircuit) -> None:
    run = Run(served, MachineClock(1e-3, 1.0, n_periods=300))
    run.periods.run()
    first, rows = run.exchange.rows(0)
    assert first == 0
    np.testing.assert_allclose(rows[:, 0], 1e-3 * np.arange(301), rtol=1e-12)
    assert sum(run.exchange.histogram) == 301
    assert run.reports.recv() == NORMAL


def test_one_thread_is_sufficient(served: ServedCircuit, monkeypatch: pytest.MonkeyPatch) -> None:
    run = Run(served, MachineClock(1e-3, 1.0, n_periods=20), StuckMainThread)
    publish, threads = run.loop.publish, list[threading.Thread]()

    def noted(lateness: float) -> None:
        threads.append(threading.current_thread())
        publish(lateness)

    monkeypatch.setattr(run.loop, "publish", noted)
    run.periods.run()
    assert threads[0] is threading.main_thread()
    assert len(threads) == 21
    assert len({*threads[1:]}) == 1
    assert threads[1] is not threads[0]


def test_an_error_of_a_thread_ends_the_run(served: ServedCircuit, monkeypatch: pytest.MonkeyPatch) -> None:
    run = Run(served, MachineClock(1e-3), StuckMainThread)

    def fail(lateness: float) -> None:
        if threading.current_thread() is not threading.main_thread():
            raise ZeroDivisionError

    monkeypatch.setattr(run.loop, "publish", fail)
    with pytest.raises(ZeroDivisionError):
        run.periods.run()


def test_both_threads_lose_their_priority_when_the_clock_is_set_back(
    served: ServedCircuit, monkeypatch: pytest.MonkeyPatch
) -> None:
    lowered: list[Any] = []
    monkeypatch.setattr(clocked_periods, "LONGEST_BEHIND", 0.0)
    monkeypatch.setattr(clocked_periods, "lower_priority", lowered.append)
    run = Run(served, MachineClock(1e-3, 1.0, n_periods=50))
    run.periods.run()
    assert run.exchange.fields[BEHIND] > 0
    assert len(lowered[-1]) == 2
    assert threading.get_native_id() in lowered[-1]


@pytest.mark.skipif(not hasattr(os, "sched_getaffinity"), reason="this system cannot select processors")
def test_two_processors_are_available_ones() -> None:
    assert {*two_processors()} <= os.sched_getaffinity(0)
    assert len({*two_processors()}) == min(2, len(os.sched_getaffinity(0)))
