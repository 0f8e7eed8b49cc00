"""Speed on a cylinder that lifts a mass with dry friction against SciPy's LSODA, side by side in one run.

LSODA gets a right-hand side of the same equations in plain floats (`loads_peer.py`) and the loosest tolerance with
which its position stays within 1e-6 of the stroke to a tight reference; ours runs at its default tolerance.
"""

from __future__ import annotations

import statistics
import time

import numpy as np

from loads_peer import peer_run
from poppet import loads

CIRCUIT = """
title = "a cylinder lifts 4 kg"
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.extend]
kind = "orifice"
from = "supply"
to = "cylinder.cap"
sonic_conductance = 3e-9
critical_ratio = 0.3
[parts.vent]
kind = "orifice"
from = "cylinder.rod"
to = "ambient"
sonic_conductance = 1e-9
critical_ratio = 0.3
[parts.cylinder]
kind = "cylinder"
bore = "25 mm"
rod_diameter = "10 mm"
stroke_length = "160 mm"
body = "slide"
cap = {dead_volume = "5 cm^3", wall_conductance = "0.5 W/K"}
rod = {dead_volume = "5 cm^3", wall_conductance = "0.5 W/K"}
[parts.slide]
kind = "mass"
mass = "4 kg"
inclination = "90 deg"
friction = {kind = "lugre", coulomb_force = 20, static_force = 30, viscous_coefficient = 50}
[run]
duration = "2 s"
output_step = "2 ms"
"""
STROKE, WANTED = 0.16, 1e-6


def main(size: float = 1.0) -> None:
    """Print times, errors and ratios; `size` scales the number of rounds."""
    circuit = loads(CIRCUIT)
    tight = circuit.simulate(relative_tolerance=1e-10)["slide.position"]

    def error(position: np.ndarray) -> float:
        return float(np.max(np.abs(position - tight))) / STROKE

    ours = error(circuit.simulate()["slide.position"])
    tolerance = 1e-4
    while error(peer_run(tolerance)[4]) > max(ours, WANTED):
        tolerance /= 2.0
    times: dict[str, list[float]] = {"SciPy LSODA": [], "circuit.simulate()": []}
    for _ in range(max(1, round(40 * size))):
        begin = time.perf_counter()
        peer_run(tolerance)
        times["SciPy LSODA"].append(time.perf_counter() - begin)
        for _ in range(10):
            begin = time.perf_counter()
            circuit.simulate()
            times["circuit.simulate()"].append(time.perf_counter() - begin)
    print(f"{'2 s of a cylinder':24s} {'median ms':>10s} {'fastest ms':>11s} {'times real time':>16s}")
    for name, each in times.items():
        print(f"{name:24s} {1e3 * statistics.median(each):10.3f} {1e3 * min(each):11.3f} {2.0 / min(each):16.0f}")
    ratio = min(times["SciPy LSODA"]) / min(times["circuit.simulate()"])
    print(f"ratio of the fastest {ratio:.0f}; error of position over stroke {ours:.1e}, LSODA at rtol {tolerance:.1e}")


if __name__ == "__main__":
    main()
