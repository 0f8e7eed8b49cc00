"""Periods of a machine at absolute deadlines.

Two threads wait for each deadline, and the first that wakes up runs the period. A processor that is within a long
system call of another program cannot wake a thread for some milliseconds, whatever its priority. With real-time
priority, each thread therefore has a processor of its own.
"""

from __future__ import annotations

import contextlib
import math
import multiprocessing
import os
import threading
import time
from multiprocessing.connection import Connection
from typing import NamedTuple

from poppet.core.codes import Note
from poppet.serve.exchange import BEHIND, STATE, STOP, Exchange
from poppet.serve.machine import PeriodLoop
from poppet.serve.plant import ServedPlant
from poppet.serve.priority import NORMAL, REAL_TIME, lower_priority, raise_priority
from poppet.serve.snapshot import MachineState

LONGEST_BEHIND = 1.0
"""Lateness above which the clock of the machine is set back [s]."""
LONGEST_SLEEP = 0.1
"""Longest time between two checks of the request to stop [s]."""
SHORT_SLEEP = 1e-3
"""Time between two checks of the recorder [s]."""
SHORTEST_PERIOD = 1e-4
"""Smallest period in real time [s]; a thread wakes up 0.02 to 0.05 ms after its deadline."""


class MachineClock(NamedTuple):
    """Clock of a machine.

    Parameters
    ----------
    period : float
        Duration of a period in the time of the machine [s].
    speed : float
        Ratio of the time of the machine to real time; infinite for a machine that does not wait.
    n_periods : int
        Number of periods after which the machine stops, or -1.
    is_recorded : bool
        True if a machine that does not wait for time waits for a recorder, see `poppet.serve.recorder`.
    """

    period: float
    speed: float = 1.0
    n_periods: int = -1
    is_recorded: bool = False

    @property
    def is_real(self) -> bool:
        """True if the machine waits for real time."""
        return math.isfinite(self.speed)

    @property
    def shortest_period(self) -> float:
        """Smallest period that the machine accepts [s]; 0 if it does not wait for real time."""
        return SHORTEST_PERIOD * min(self.speed, 1.0) if self.is_real else 0.0


class ClockedPeriods:
    """Periods of a plant at the deadlines begin + count * period / speed, until the end or a request to stop.

    Parameters
    ----------
    loop : PeriodLoop
        Periods.
    plant : ServedPlant
        Model.
    exchange : Exchange
        Exchange with the protocols.
    clock : MachineClock
        Clock.
    reports : Connection
        Pipe for the priority, which is sent after the first period, and for notes.
    """

    def __init__(
        self, loop: PeriodLoop, plant: ServedPlant, exchange: Exchange, clock: MachineClock, reports: Connection
    ) -> None:
        self._loop, self._plant, self._exchange, self._clock, self._reports = loop, plant, exchange, clock, reports
        self._fields, self._parent = exchange.fields, multiprocessing.parent_process()
        self._begin, self._first, self._checked = 0.0, 0, 0.0
        self._deadline, self._has_ended = 0.0, False
        self._lock = threading.Lock()  # of the thread that runs a period
        self._error: BaseException | None = None
        self._threads: list[int] = []

    def run(self) -> None:
        """Run all periods."""
        self._fields[STATE] = MachineState.RUNNING.value
        # A machine that does not wait would leave no time to others.
        priority = raise_priority(self._plant.children) if self._clock.is_real else NORMAL
        if not self._run_period(0.0):
            return
        # The clock starts after the first period, which also loads the code.
        self._reports.send(priority)
        self._begin = time.perf_counter()
        self._set_deadline()
        processors = two_processors() if priority == REAL_TIME else (None, None)
        second = threading.Thread(target=self._wait_and_run, args=(processors[1],), daemon=True)
        if self._clock.is_real:
            second.start()
        self._wait_and_run(processors[0])
        if second.ident is not None:
            second.join()
        if self._error is not None:
            raise self._error

    def _wait_and_run(self, processor: int | None) -> None:
        """Wait for each deadline, and run the period if no other thread has begun it."""
        self._threads.append(threading.get_native_id())
        if processor is not None:
            with contextlib.suppress(OSError):
                os.sched_setaffinity(0, {processor})
        try:
            while not self._has_ended:
                deadline = self._deadline
                self._wait_for(deadline)
                with self._lock:
                    if deadline == self._deadline and not self._has_ended:
                        self._has_ended = not self._run_late_period()
        except BaseException as error:
            self._error, self._has_ended = error, True

    def _wait_for(self, deadline: float) -> None:
        """Sleep until a deadline, or until the machine ends."""
        while (remaining := deadline - time.perf_counter()) > 0.0 and not (self._fields[STOP] or self._has_ended):
            time.sleep(min(remaining, LONGEST_SLEEP))

    def _run_late_period(self) -> bool:
        """Run the period of the present deadline, and return False at the end of the machine."""
        now = time.perf_counter()
        lateness = max(0.0, now - self._deadline) if self._clock.is_real else 0.0
        if lateness > LONGEST_BEHIND:
            self._set_back(now, lateness)
        if self._fields[STOP] or not self._run_period(lateness):
            return False
        while self._exchange.is_full and not self._fields[STOP] and self._has_parent():
            time.sleep(SHORT_SLEEP)
        self._set_deadline()
        if now - self._checked > LONGEST_SLEEP:
            self._checked = now
            return self._has_parent()
        return True

    def _run_period(self, lateness: float) -> bool:
        self._loop.publish(lateness)
        self._exchange.count_lateness(lateness)
        return self._plant.count != self._clock.n_periods and self._loop.advance()

    def _set_deadline(self) -> None:
        self._deadline = self._begin + (self._plant.count - self._first) * self._clock.period / self._clock.speed

    def _set_back(self, now: float, lateness: float) -> None:
        """Continue from now on, without real-time priority."""
        self._fields[BEHIND] += 1
        self._reports.send(Note("serve.behind", time=self._plant.t, seconds=lateness))
        self._begin, self._first = now, self._plant.count
        lower_priority((*self._plant.children, *self._threads))

    def _has_parent(self) -> bool:
        """Return False if the main process has been killed."""
        return self._parent is None or self._parent.is_alive()


def two_processors() -> tuple[int | None, int | None]:
    """Return two processors that this process may use, or None if they cannot be selected.

    The first and the last one are usually not two threads of one core.
    """
    if not hasattr(os, "sched_getaffinity"):
        return None, None
    processors = sorted(os.sched_getaffinity(0))
    return processors[0], processors[-1]
