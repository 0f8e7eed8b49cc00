"""A valve sampled at 1 kHz for 120 s, against the same loop around SciPy's fastest call per sample.

Complete valve (preset `universal`, hold band and converter off) on a tank of 0.2 m3, setpoint in four steps. The peer
holds the solenoids over each millisecond, integrates it with LSODA and samples; of three ways to call LSODA the fastest
is taken, at the loosest tolerance whose pressures agree with ours within 6 mbar, 0.1 % of full scale. Ours runs at its
default tolerance, writes all its outputs, and carries the integrals of the flows along. Ways and tolerances are chosen
on the first 10 s, which are timed in turn; then both sides do the whole run, the peer once.
"""

from __future__ import annotations

import platform
import statistics
import time
from collections.abc import Callable
from functools import partial

import numpy as np

import poppet
from poppet import loads
from poppet.engine.problem import Problem
from poppet.engine.solve import solve
from sampled_peer import WAYS, peer_run

TIMES, TARGETS = [0.0, 30.0, 60.0, 90.0], [2e5, 3e5, 4e5, 5e5]
AGREED = 600.0
"""6 mbar [Pa]."""
LOOSE = 1e-4
"""A tolerance at which ours is still within 6 mbar of itself."""
PART, WHOLE, ROUNDS = 10, 120, 3
CIRCUIT = """
title = "sampled valve"
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.valve]
kind = "proportional_valve"
data = "vppm_6l"
preset = "universal"
supply = "supply"
outlet = "tank"
exhaust = "ambient"
[parts.valve.electronics]
inner = { hold_band = 0 }
converter = { bits = 0 }
[parts.tank]
kind = "chamber"
volume = "0.2 m^3"
wall_conductance = "45 W/K"
[signals."valve.setpoint"]
kind = "steps"
times = [0, 30, 60, 90]
values = ["2 bar", "3 bar", "4 bar", "5 bar"]
[run]
duration = "120 s"
output_step = "0.1 s"
"""


class Bench:
    """Both sides of the comparison, over any part of the run."""

    def __init__(self, spans: tuple[int, int] = (PART, WHOLE)) -> None:
        self.circuit = loads(CIRCUIT)
        self.number = self.circuit.parameters
        self.row = [name for name, _ in self.circuit.model.outputs].index("tank.pressure")
        self.own = {span: solve(self.problem(span)).values[self.row] for span in spans}

    def problem(self, span: int, tolerance: float = 1e-6) -> Problem:
        return self.circuit.problem(
            self.circuit.run.changed(duration=span, output_step=0.1, relative_tolerance=tolerance)
        )

    def peer(self, way: str, tolerance: float, span: int) -> np.ndarray:
        return peer_run(self.number, way, tolerance, 1000 * span, TIMES, TARGETS)

    def apart(self, pressure: np.ndarray, span: int) -> float:
        """Largest distance from ours at its default tolerance [Pa]."""
        return float(np.max(np.abs(pressure - self.own[span])))

    def loosest(self, way: str, span: int, tolerance: float) -> tuple[float, float, float]:
        """Tolerance from which on a peer agrees with ours, how far apart it is then, and how long it takes."""
        while True:
            begin = time.process_time()
            try:
                distance = self.apart(self.peer(way, tolerance, span), span)
            except ValueError:  # a state has left its domain
                distance = np.inf
            seconds = time.process_time() - begin
            if distance <= AGREED:
                return tolerance, distance, seconds
            tolerance /= 10.0


def timed(run: Callable[[], object]) -> float:
    """Processor time of one run, so that other work on the machine does not count."""
    begin = time.process_time()
    run()
    return time.process_time() - begin


def first_part(bench: Bench, part: int, rounds: int) -> tuple[str, float]:
    """Compare on the first seconds; returns the fastest way and its tolerance."""
    found = {way: bench.loosest(way, part, 1e-2)[:2] for way in WAYS}
    runs: dict[str, Callable[[], object]] = {
        way: partial(bench.peer, way, tolerance, part) for way, (tolerance, _) in found.items()
    }
    for tolerance in (1e-6, LOOSE):
        problem = bench.problem(part, tolerance)
        name = "poppet" if tolerance == 1e-6 else "poppet, loose"
        found[name] = tolerance, bench.apart(solve(problem).values[bench.row], part)
        runs[name] = partial(solve, problem)
    times: dict[str, list[float]] = {name: [] for name in runs}
    for _ in range(rounds):
        for name, run in runs.items():
            times[name].append(timed(run))
    median = {name: statistics.median(values) for name, values in times.items()}
    heads = (("rtol", 7), ("apart Pa", 9), ("s", 8), ("us a sample", 12), ("times as long", 14))
    print(f"{f'first {part} s, in turn':20s}", *(f"{name:>{width}s}" for name, width in heads))
    for name, seconds in median.items():
        tolerance, distance = found[name]
        print(
            f"{name:20s} {tolerance:7.0e} {distance:9.3g} {seconds:8.4f} {1e3 * seconds / part:12.3f} "
            f"{seconds / median['poppet']:14.1f}"
        )
    fastest = min(WAYS, key=median.__getitem__)
    return fastest, found[fastest][0]


def main(size: float = 1.0) -> None:
    part, whole = max(1, round(PART * size)), max(1, round(WHOLE * size))
    bench = Bench((part, whole))
    tight = solve(bench.problem(whole, 1e-10)).values[bench.row]
    print(f"poppet {poppet.__version__}, {platform.machine()}: valve sampled at 1 kHz, {whole} s")
    print(f"ours at its default tolerance is {bench.apart(tight, whole):.3g} Pa from ours at 1e-10 over the whole run")
    way, tolerance = first_part(bench, part, max(1, round(ROUNDS * size)))
    tolerance, distance, theirs = bench.loosest(way, whole, tolerance)
    print(f"whole run, {way}: {theirs:.2f} s at rtol {tolerance:.0e}, {distance:.3g} Pa from ours")
    runs: dict[str, Callable[[], object]] = {
        "kernel with outputs": lambda: solve(bench.problem(whole)),
        f"the same at rtol {LOOSE:.0e}": lambda: solve(bench.problem(whole, LOOSE)),
        "circuit.simulate()": lambda: bench.circuit.simulate(whole),
    }
    for name, run in runs.items():
        seconds = statistics.median(timed(run) for _ in range(max(1, round(9 * size))))
        print(f"{name:24s} {1e3 * seconds:6.1f} ms, {1e6 * seconds / whole:5.0f} ns a sample, ", end="")
        print(f"{theirs / seconds:.0f} times faster")
    for tolerance in (1e-6, LOOSE):
        result = solve(bench.problem(whole, tolerance))
        distance = bench.apart(result.values[bench.row], whole)
        print(f"ours at {tolerance:.0e}: {result.attempts} steps tried, {distance:.3g} Pa from ours at 1e-06")


if __name__ == "__main__":
    main()
