"""Speed on the paper's staircase against SciPy's LSODA, side by side in one run.

Both simulate the main stage of the paper filling and emptying a 0.2 m3 tank with wall heat: 120 s, pilot pressure in
six steps, rows every 0.1 s, five states (stroke, velocity, tank pressure and mass, heat). LSODA gets a right-hand side
in plain floats, written as a careful user would, restarted at every step of the pilot pressure, with tolerances per
state. Both must be within 1e-6 of a tight reference in pressure; ours runs at its default tolerance.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from itertools import count

import numpy as np

import poppet
from peer import START, peer_rates, peer_run
from poppet import loads
from poppet.engine.call import Call
from poppet.engine.solve import solve

CIRCUIT = """
title = "paper staircase"
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.room]
kind = "reservoir"
pressure = "1 bar"
[parts.valve]
kind = "main_stage"
data = "varga2012"
supply = "supply"
outlet = "tank"
exhaust = "room"
[parts.tank]
kind = "chamber"
volume = "0.2 m^3"
wall_conductance = "45 W/K"
[signals."valve.pilot_pressure"]
kind = "steps"
times = [0, 20, 40, 60, 80, 100]
values = ["1 bar g", "2 bar g", "3 bar g", "4 bar g", "5 bar g", "0 bar g"]
[run]
duration = "120 s"
output_step = "0.1 s"
"""


def interleaved(contestants: dict[str, Callable[[], object]], rounds: int) -> dict[str, list[float]]:
    """Wall times of each contestant, taken in turns."""
    times: dict[str, list[float]] = {name: [] for name in contestants}
    for _ in range(rounds):
        for name, run in contestants.items():
            begin = time.perf_counter()
            run()
            times[name].append(time.perf_counter() - begin)
    return times


def main(size: float = 1.0) -> None:
    """Print times and ratios; `size` scales the number of rounds."""
    circuit = loads(CIRCUIT)
    tight = circuit.simulate(relative_tolerance=1e-12)["tank.pressure"]
    rates = peer_rates(circuit.parameters)

    def error(pressure: np.ndarray) -> float:
        return float(np.max(np.abs(pressure / tight - 1.0)))

    tolerance = 1e-5
    while error(peer_run(rates, START, tolerance)[2]) > 1e-6:
        tolerance /= 2.0
    problem = circuit.problem(circuit.run)
    call, volumes = Call(problem), (0.2 * (1.0 + 1e-6 * k) for k in count())

    def changed() -> None:
        circuit.with_values({"tank.volume": next(volumes)}).simulate()

    recording = circuit.simulate()
    lsoda, simulate, other = "SciPy LSODA", "circuit.simulate()", "a number changed, simulate()"
    contestants: dict[str, Callable[[], object]] = {
        lsoda: lambda: peer_run(rates, START, tolerance),
        "kernel, again in its arrays": call.repeat,
        "kernel, new arrays": lambda: solve(problem),
        simulate: circuit.simulate,
        other: changed,
    }
    interleaved(contestants, 2)
    times = interleaved(contestants, max(1, round(41 * size)))
    print(f"poppet {poppet.__version__}; paper staircase, 120 s, 1201 rows, {len(recording)} outputs")
    print(
        f"error in pressure: LSODA {error(peer_run(rates, START, tolerance)[2]):.2g} (rtol {tolerance:.2g}), ", end=""
    )
    print(f"poppet {error(recording['tank.pressure']):.2g} (default tolerance)")
    print(f"steps: {recording.statistics}")
    fastest = {name: min(found) for name, found in times.items()}
    heads = "median ms", "times faster", "fastest ms", "times faster"
    print(f"{'':30s}", *(f"{head:>12s}" for head in heads))
    for name, found in times.items():
        median, least = statistics.median(found), fastest[name]
        ratios = statistics.median(times[lsoda]) / median, fastest[lsoda] / least
        print(f"{name:30s} {1e3 * median:12.3f} {ratios[0]:12.1f} {1e3 * least:12.3f} {ratios[1]:12.1f}")
    print(f"a changed number costs {fastest[other] / fastest[simulate]:.2f} times a repeated simulate(),", end=" ")
    print(f"and that {fastest[simulate] / fastest['kernel, new arrays']:.2f} times the kernel")


if __name__ == "__main__":
    main()
