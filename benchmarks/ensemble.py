"""What an ensemble costs over its number of runs: processor time for each run, and memory. The rows stand in docs.

Then the paper's staircase with eight numbers varied: what reading tables, metrics and Parquet leave of the rate of the
bare lanes, in one thread and one run.
"""

from __future__ import annotations

import resource
import subprocess
import sys
import tempfile
import time
from typing import Any

from lanes import SPREAD, VARIED, batch_of, final_and_rise
from poppet import Chamber, Circuit, Orifice, Run
from poppet.circuit.file import loads
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
SIZES = (1e3, 1e4, 1e5, 1e6, 1e7)


def circuit() -> Circuit:
    """A tank that runs empty."""
    parts = {
        "tank": Chamber(volume="2 l", initial_pressure="3 bar", wall_conductance="1 W/K"),
        "hole": Orifice(from_="tank", to="ambient", sonic_conductance="2 dm^3/(s bar)", critical_ratio=0.3),
    }
    return Circuit(parts, run=Run(duration="1 s", output_step="50 ms"))


def one(runs: int) -> None:
    """Run it once on one thread, all ready before, and print what it took."""
    fields: dict[str, Any] = {"seed": 1, "sampling": "sobol", "numbers": NUMBERS, "metrics": METRICS}
    tank = circuit()
    tank.ensemble(runs=64, workers=1, **fields)
    with tempfile.TemporaryDirectory() as folder:
        wall, cpu = time.perf_counter(), time.process_time()
        found = tank.ensemble(f"{folder}/set", runs=runs, workers=1, requirements={"fast": "empty < 0.33 s"}, **fields)
        wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
        found.yields(), found.summaries()
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    print(f"{runs:>10}{wall:>10.2f}{cpu:>10.2f}{1e6 * cpu / runs:>14.1f}{memory:>10.0f}")


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
    fields: dict[str, Any] = {"seed": 1, "numbers": numbers, "metrics": metrics, "workers": 1}
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
    print(f"{'runs':>10}{'wall [s]':>10}{'cpu [s]':>10}{'cpu/run [us]':>14}{'RSS [MB]':>10}", flush=True)
    for runs in SIZES[: 1 if size < 1.0 else None]:
        row = subprocess.run([sys.executable, __file__, str(int(runs))], check=True, capture_output=True, text=True)
        print(row.stdout, end="", flush=True)
    against_lanes(round(1e5 * size) if size >= 1.0 else 64)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        one(int(sys.argv[1]))
    else:
        main()
