"""What an ensemble costs over its number of runs: processor time for each run, and memory. The rows stand in docs.

The cost is a start, so much for each file, and so much for each run; the three are fitted to the rows, and printed with
the largest deviation. Files have 512 to 16384 runs, so that above 1e6 runs the cost is linear, and below it is not.

Then the paper's staircase with eight numbers varied: what reading tables, metrics and Parquet leave of the rate of the
bare lanes, in one thread and one run.
"""

from __future__ import annotations

import math
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from typing import Any

import numpy as np

from lanes import SPREAD, VARIED, batch_of, final_and_rise
from poppet import Chamber, Circuit, Orifice, Run, loads
from poppet.engine.batch import run_batch
from staircase import CIRCUIT as STAIRCASE

NUMBERS = {
    "tank.volume": {"distribution": "normal", "relative_sigma": 0.02},
    "hole.sonic_conductance": {"distribution": "uniform", "relative_range": 0.1},
}
METRICS = {
    "end": {"of": "tank.pressure", "metric": "final"},
    "empty": {"of": "tank.pressure", "metric": "time_to", "value": "1.5 bar"},
}
REQUIREMENTS = {"fast": "empty < 0.33 s"}
SIZES = (1e3, 3e3, 1e4, 3e4, 1e5, 1e6, 1e7)
TURNS = 5
"""Of up to 1e5 runs; the least counts."""


def circuit() -> Circuit:
    """A tank that runs empty."""
    parts = {
        "tank": Chamber(volume="2 l", initial_pressure="3 bar", wall_conductance="1 W/K"),
        "hole": Orifice(from_="tank", to="ambient", sonic_conductance="2 dm^3/(s bar)", critical_ratio=0.3),
    }
    return Circuit(parts, run=Run(duration="1 s", output_step="50 ms"))


def one(runs: int) -> None:
    """Run it once on one thread, all ready before, and print what it took."""
    fields: dict[str, Any] = {"sampling": "sobol", "parameters": NUMBERS, "metrics": METRICS, "workers": 1}
    tank = circuit()
    tank.ensemble(runs=64, **fields)
    wall = cpu = math.inf
    # Other seeds, for what the same ensemble has made ready is kept.
    for seed in range(1, TURNS + 1 if runs <= 1e5 else 2):
        with tempfile.TemporaryDirectory() as folder:
            begin = time.perf_counter(), time.process_time()
            found = tank.ensemble(f"{folder}/set", runs=runs, seed=seed, requirements=REQUIREMENTS, **fields)
            wall, cpu = min(wall, time.perf_counter() - begin[0]), min(cpu, time.process_time() - begin[1])
            files = len(list(found.folder.glob("runs/*.parquet")))
            found.yields(), found.summaries()
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    print(f"{runs:>10}{files:>10}{wall:>10.3f}{cpu:>10.3f}{1e6 * cpu / runs:>14.1f}{memory:>10.0f}")


def law(rows: Sequence[str]) -> None:
    """Print start, cost of a file and cost of a run that explain the rows with the least relative deviations."""
    runs, files, cpu = np.array([[float(row.split()[k]) for k in (0, 1, 3)] for row in rows]).T
    shares = np.stack([1.0 / cpu, files / cpu, runs / cpu], axis=1)
    start, file, run = found = np.linalg.lstsq(shares, np.ones(len(rows)))[0]
    deviation = np.abs(shares @ found - 1.0).max()
    print(f"{1e3 * start:.1f} ms, {1e3 * file:.2f} ms a file, {1e6 * run:.2f} us a run: ", end="")
    print(f"all rows within {deviation:.0%}")


def against_lanes(runs: int) -> None:
    """The staircase through an ensemble, and a batch of the same size before and after it without one."""
    circuit = loads(STAIRCASE)
    batch = batch_of(circuit, "tank.pressure", VARIED, max(64, runs // 10))
    metrics = {
        "final": {"of": "tank.pressure", "metric": "final"},
        "most": {"of": "tank.pressure", "metric": "max"},
        "reached": {"of": "tank.pressure", "metric": "time_to", "value": "5 bar"},
    }
    numbers = {address: {"distribution": "uniform", "relative_range": SPREAD} for address in VARIED}
    fields: dict[str, Any] = {"seed": 1, "parameters": numbers, "metrics": metrics, "workers": 1}
    circuit.ensemble(runs=64, **fields)

    def bare() -> float:
        begin = time.process_time()
        run_batch(batch, reduce=final_and_rise, threads=1)
        return batch.size / (time.process_time() - begin)

    bare()
    with tempfile.TemporaryDirectory() as folder:
        before, begin = bare(), time.process_time()
        circuit.ensemble(f"{folder}/set", runs=runs, **fields)
        rate, after = runs / (time.process_time() - begin), bare()
    share = 200.0 * rate / (before + after)
    print(f"staircase: bare lanes {before:.0f} and {after:.0f} runs/s of one core, ", end="")
    print(f"ensemble of {runs} with metrics and Parquet {rate:.0f}, {share:.0f} %")


def main(size: float = 1.0) -> None:
    """Runs of several sizes, each in a process of its own, for its memory."""
    print(f"{'runs':>10}{'files':>10}{'wall [s]':>10}{'cpu [s]':>10}{'cpu/run [us]':>14}{'RSS [MB]':>10}", flush=True)
    rows = []
    for runs in SIZES[: 1 if size < 1.0 else None]:
        row = subprocess.run([sys.executable, __file__, str(int(runs))], check=True, capture_output=True, text=True)
        rows.append(row.stdout)
        print(row.stdout, end="", flush=True)
    if len(rows) > 3:
        law(rows)
    against_lanes(round(1e5 * size) if size >= 1.0 else 64)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        one(int(sys.argv[1]))
    else:
        main()
