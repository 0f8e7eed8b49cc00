"""Lateness of the periods of a served circuit, on a quiet computer and under load.

Each busy process computes without a pause, with the priority of usual programs. The circuit is a machine of two
cylinders with its step sequence. Each late period is printed, with the lateness of a process that only waits.
`python benchmarks/serve.py --minutes 10 --busy 2` is the long test of the documentation.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import time
from contextlib import ExitStack
from pathlib import Path

from poppet import load
from poppet.serve.clocked_periods import MachineClock
from poppet.serve.lateness import LATE
from poppet.serve.machine_process import ProcessMachine
from poppet.serve.points import ServedCircuit
from wakeup_peer import LatePeriods, peer_running

CIRCUIT = Path(__file__).parents[1] / "examples" / "two_cylinders.toml"
PERIOD = 0.01
COLLECTION = 2.0
"""Time between two collections of late periods [s]."""


def keep_busy() -> None:
    """Compute until the process is ended."""
    while True:
        pass


def measure(seconds: float, busy: int, period: float = PERIOD) -> None:
    """Serve the circuit for a duration beside busy processes, and print the histogram of the lateness."""
    served = ServedCircuit.of(load(CIRCUIT))
    context = multiprocessing.get_context("spawn")
    with ExitStack() as stack:
        for _ in range(busy):
            process = context.Process(target=keep_busy, daemon=True)
            process.start()
            stack.callback(process.kill)
        peer = stack.enter_context(peer_running())
        machine = stack.enter_context(ProcessMachine(served, MachineClock(period, 1.0)))
        late, end = LatePeriods(machine), time.monotonic() + seconds
        while (remaining := end - time.monotonic()) > 0.0:
            time.sleep(min(remaining, COLLECTION))
            late.collect()
        machine.stop()
    lateness = machine.lateness()
    on_time = 100.0 * (1.0 - lateness.late / lateness.periods)
    print(
        f"period {1e3 * period:g} ms, {seconds:g} s, {busy} busy processes on {os.cpu_count()} processors, "
        f"priority {machine.priority}:\n{on_time:.3f} % of {lateness.periods} periods at most {1e3 * LATE:g} ms late, "
        f"{lateness.late} late, the latest {1e3 * lateness.maximum:.3g} ms, clock set back {lateness.behind} times"
    )
    print(lateness.table())
    print(peer.explain(late.late), flush=True)


def main(size: float = 1.0) -> None:
    for busy in (0, 2):
        measure(10.0 * size, busy)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, help="duration of one test, instead of two short ones")
    parser.add_argument("--busy", type=int, default=2, help="number of busy processes (default: 2)")
    parser.add_argument("--period", type=float, default=PERIOD, help="period [s] (default: 0.01)")
    options = parser.parse_args()
    if options.minutes is None:
        main()
    else:
        measure(60.0 * options.minutes, options.busy, options.period)
