"""The peer of a served machine: a process that only waits, with the same priority.

A host halts a virtual computer from time to time. If this process and a machine are late at the same time, the cause
is the computer, and not the machine.
"""

from __future__ import annotations

import multiprocessing
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.serve.lateness import LATE
from poppet.serve.machine import Machine
from poppet.serve.priority import raise_priority

INTERVAL = 1e-3
"""Time between two wake-ups of the peer [s]."""
NOTED = 0.5 * LATE
"""Lateness of the peer from which it is recorded [s]."""


def wait_repeatedly(stop: Any, results: Any) -> None:
    """Wait for absolute deadlines until the event `stop`, and put the times and the lateness of late wake-ups [s]."""
    raise_priority()
    late: list[tuple[float, float]] = []
    deadline = time.perf_counter()
    results.put(None)
    while not stop.is_set():
        deadline = max(deadline + INTERVAL, time.perf_counter())
        time.sleep(max(0.0, deadline - time.perf_counter()))
        now = time.perf_counter()
        if now - deadline > NOTED:
            late.append((now, now - deadline))
    results.put(late)


class WakeupPeer:
    """Late wake-ups of a process that only waits.

    Attributes
    ----------
    late : (n, 2) array
        Time of each late wake-up on the clock of `time.perf_counter`, and its lateness [s].
    stolen : float
        Time for which the host of a virtual computer halted its processors, summed over them [s].
    """

    late: NDArray[np.float64]
    stolen: float

    def explain(self, late: NDArray[np.float64]) -> str:
        """Return a line for each late period of a machine, see `LatePeriods`."""
        lines = [f"peer: {len(self.late)} wake-ups more than {1e3 * NOTED:g} ms late; halted {self.stolen:.2f} s"]
        for began, now, lateness in late:
            near = self.late[(self.late[:, 0] > now - lateness) & (self.late[:, 0] - self.late[:, 1] < now)]
            peer = f"{1e3 * near[:, 1].max():.1f} ms late" if len(near) else "not late"
            lines.append(f"{began:9.2f} s: {1e3 * lateness:5.1f} ms late, peer {peer}")
        return "\n".join(lines)


class LatePeriods:
    """Late periods of a machine with a clock.

    Parameters
    ----------
    machine : Machine
        Machine.

    Attributes
    ----------
    late : (n, 3) array
        Deadline of each late period in real time since the start, its begin on the clock of `time.perf_counter`, with
        an error of about 1 ms, and its lateness [s].
    """

    def __init__(self, machine: Machine) -> None:
        self._machine, self._index = machine, 0
        self.late = np.empty((0, 3))
        starts = []
        for _ in range(50):
            starts.append(time.perf_counter() - machine.snapshot().time / machine.speed)
            time.sleep(1.1e-3)
        self._start = min(starts)

    def collect(self) -> None:
        """Add the late ones of the periods since the last call; the machine keeps more than 1000 periods."""
        first, rows = self._machine.rows(self._index)
        self._index = first + len(rows)
        late = rows[rows[:, -1] > LATE]
        deadlines, lateness = late[:, 0] / self._machine.speed, late[:, -1]
        self.late = np.vstack((self.late, np.column_stack((deadlines, self._start + deadlines + lateness, lateness))))


@contextmanager
def peer_running() -> Iterator[WakeupPeer]:
    """Run the peer; its results are complete at the end."""
    context = multiprocessing.get_context("spawn")
    stop, results, peer = context.Event(), context.Queue(), WakeupPeer()
    process = context.Process(target=wait_repeatedly, args=(stop, results), daemon=True)
    process.start()
    results.get()
    before = _stolen()
    try:
        yield peer
    finally:
        peer.stolen = _stolen() - before
        stop.set()
        peer.late = np.array(results.get(), dtype=float).reshape(-1, 2)
        process.join()


def _stolen() -> float:
    """Return the time for which the host has halted the processors since their start [s]; 0 if it is not known."""
    path = Path("/proc/stat")
    if not path.exists():
        return 0.0
    return int(path.read_text().split()[8]) / os.sysconf("SC_CLK_TCK")
