"""Cost against the number of chambers: a chain of 2, 8, 32, 128 chambers with wall heat, filled from a supply.

Printed for each: tracing and compiling, one warm run of 20 s with 201 rows, and both per chamber. A large model is
first compiled without optimisation: then follow the time of the optimisation and of the runs after it. The cache on
disk is empty.
"""

from __future__ import annotations

import os
import statistics
import tempfile
import time

from poppet import Chamber, Circuit, Orifice, Reservoir


def chain(length: int) -> Circuit:
    """A supply and `length` chambers of one litre in a row."""
    parts: dict[str, object] = {"supply": Reservoir(pressure="7 bar")}
    before = "supply"
    for k in range(length):
        parts[f"o{k}"] = Orifice(from_=before, to=f"c{k}", sonic_conductance=1e-8, critical_ratio=0.3)
        parts[f"c{k}"] = Chamber(volume="1 l", wall_conductance=0.1)
        before = f"c{k}"
    return Circuit(parts)  # type: ignore[arg-type]


def run_time(circuit: Circuit, rounds: int) -> tuple[float, int]:
    """Return the median time of a run, and the number of its steps."""
    runs = []
    for _ in range(rounds):
        begin = time.perf_counter()
        recording = circuit.simulate("20 s", "0.1 s")
        runs.append(time.perf_counter() - begin)
    return statistics.median(runs), int(sum(recording.statistics.values()))


def main(size: float = 1.0) -> None:
    chain(1).simulate(1.0)
    rounds = max(1, round(9 * size))
    print(
        f"{'chambers':>8s} {'ready s':>8s} {'per chamber ms':>15s} {'run ms':>8s} {'per chamber us':>15s} {'steps':>6s}"
        f" {'optimised s':>12s} {'run ms':>8s}"
    )
    with tempfile.TemporaryDirectory() as folder:
        os.environ["POPPET_CACHE_DIR"] = folder
        for length in (2, 8, 32, 128)[: max(1, round(4 * size))]:
            circuit = chain(length)
            begin = time.perf_counter()
            kernel = circuit.kernel
            ready = time.perf_counter() - begin
            circuit.simulate("20 s", "0.1 s")
            run, steps = run_time(circuit, rounds)
            line = f"{length:8d} {ready:8.2f} {1e3 * ready / length:15.1f} {1e3 * run:8.2f} {1e6 * run / length:15.1f}"
            if kernel.tier is not None:
                begin = time.perf_counter()
                kernel.optimise()
                optimised = time.perf_counter() - begin
                line += f" {steps:6d} {optimised:12.2f} {1e3 * run_time(circuit, rounds)[0]:8.2f}"
            else:
                line += f" {steps:6d}"
            print(line)


if __name__ == "__main__":
    main()
