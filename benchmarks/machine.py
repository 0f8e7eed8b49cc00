"""Speed of a machine with two cylinders and a step sequence against SciPy's LSODA, side by side in one run.

LSODA gets a right-hand side of the same equations in plain floats (`machine_peer.py`), and the faster of two ways to
call it. Each comparison has one accuracy of both positions: that of our default tolerance, or 1e-6 m, for which both
programs use the loosest tolerance.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from functools import partial

import numpy as np

from machine_peer import SAMPLE, WAYS, peer_run
from poppet import loads

CIRCUIT = """
title = "Two cylinders: A+ B+ B- A-"
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.feed]
kind = "orifice"
from = "supply"
to = "rail"
sonic_conductance = 3e-8
critical_ratio = 0.4
[parts.rail]
kind = "chamber"
volume = "0.5 l"
initial_pressure = "7 bar"
[parts.plc]
kind = "sequence"
sample_time = "5 ms"
outputs = ["a", "b"]
start = "A+"
[parts.plc.steps."A+"]
on = ["a"]
next = { "B+" = "slideA.position > 98 mm" }
[parts.plc.steps."B+"]
on = ["a", "b"]
next = { "B-" = "slideB.position > 48 mm" }
[parts.plc.steps."B-"]
on = ["a"]
next = { "A-" = "slideB.position < 2 mm" }
[parts.plc.steps."A-"]
on = []
next = { "A+" = "slideA.position < 2 mm" }
[connections]
"valveA.command" = "plc.a"
"valveB.command" = "plc.b"
[run]
output_step = "5 ms"
"""
DRIVE = """
[parts.valve{name}]
kind = "spool_valve"
function = "5/2 monostable"
supply = "rail"
a = "cylinder{name}.cap"
b = "cylinder{name}.rod"
sonic_conductance = 1e-8
critical_ratio = 0.3
supply_b_conductance = 1e-8
exhaust_a_conductance = 6e-9
switching_time = "12 ms"
initial_position = -1
[parts.cylinder{name}]
kind = "cylinder"
bore = "{bore} mm"
rod_diameter = "{rod} mm"
stroke_length = "{stroke} mm"
body = "slide{name}"
cap = {{dead_volume = "5 cm^3", wall_conductance = "0.5 W/K"}}
rod = {{dead_volume = "5 cm^3", wall_conductance = "0.5 W/K", initial_pressure = "7 bar"}}
[parts.slide{name}]
kind = "mass"
mass = "{mass} kg"
friction = {{kind = "lugre", coulomb_force = 20, static_force = 30, viscous_coefficient = 50}}
"""
DRIVES = (
    {"name": "A", "bore": 25, "rod": 10, "stroke": 100, "mass": 2},
    {"name": "B", "bore": 32, "rod": 12, "stroke": 50, "mass": 3},
)
DURATION, WANTED = 5.0, 1e-6


def loosest(error: Callable[[float], float], limit: float) -> float:
    """Largest tolerance 1e-3 / 2^n whose error is within a limit."""
    tolerance = 1e-3
    while error(tolerance) > limit:
        tolerance /= 2.0
    return tolerance


def peer_error(way: str, tight: np.ndarray, tolerance: float) -> float:
    """Largest error of both positions; infinite if the run fails."""
    try:
        positions, _ = peer_run(way, tolerance, len(tight) - 1)
    except ValueError:  # a negative pressure between the steps
        return float("inf")
    return float(np.max(np.abs(positions - tight)))


def main(size: float = 1.0) -> None:
    """Print times, errors and ratios; `size` scales the duration and the number of rounds."""
    samples = max(100, round(DURATION * size / SAMPLE))
    circuit = loads(CIRCUIT + "\n".join(DRIVE.format(**drive) for drive in DRIVES))

    def run(tolerance: float | None = None) -> np.ndarray:
        recording = circuit.simulate(samples * SAMPLE, relative_tolerance=tolerance)
        return np.array([recording[f"slide{drive['name']}.position"] for drive in DRIVES]).T

    tight = run(1e-10)

    def error(tolerance: float | None) -> float:
        return float(np.max(np.abs(run(tolerance) - tight)))

    limits = {"default": error(None), "loosest": WANTED}
    tolerances: dict[str, float | None] = {"default": None, "loosest": loosest(error, WANTED)}
    times: dict[str, dict[str, list[float]]] = {}
    for case, limit in limits.items():
        ways = {way: loosest(partial(peer_error, way, tight), limit) for way in WAYS}
        found: dict[str, list[float]] = {}
        for _ in range(max(1, round(5 * size))):
            for way, rtol in ways.items():
                begin = time.process_time()
                _, transitions = peer_run(way, rtol, samples)
                found.setdefault(f"SciPy {way} at rtol {rtol:.1e}", []).append(time.process_time() - begin)
            for _ in range(5):
                begin = time.process_time()
                run(tolerances[case])
                found.setdefault("circuit.simulate()", []).append(time.process_time() - begin)
        times[case] = found
    print(f"{samples * SAMPLE:g} s of two cylinders, {len(transitions)} transitions; processor times")
    for case, found in times.items():
        print(f"{case} tolerance, error of the positions at most {limits[case]:.1e} m")
        for name, values in found.items():
            print(f"  {name:40s} median {1e3 * statistics.median(values):8.2f} ms, fastest {1e3 * min(values):8.2f} ms")
        fastest = min(min(values) for name, values in found.items() if name.startswith("SciPy"))
        print(f"  ratio of the fastest {fastest / min(found['circuit.simulate()']):.0f}")


if __name__ == "__main__":
    main()
