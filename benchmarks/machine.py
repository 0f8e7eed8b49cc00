"""Speed of a machine with two cylinders and a step sequence against SciPy's LSODA, side by side in one run.

LSODA gets a right-hand side of the same equations in plain floats (`machine_peer.py`), the faster of two ways to call
it, and the loosest tolerance with which both positions stay within the error of ours, or 1e-6 m if that is larger.
"""

from __future__ import annotations

import statistics
import time

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


def peer_error(way: str, tolerance: float, tight: np.ndarray) -> float:
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
    limit = max(float(np.max(np.abs(run() - tight))), WANTED)
    tolerance = 1e-3
    while np.max(np.abs(run(tolerance) - tight)) > limit:
        tolerance /= 2.0
    cases: dict[str, float | None] = {"default": None, "loosest": tolerance}
    ways: dict[str, float] = {}
    for way in WAYS:
        ways[way] = 1e-3
        while peer_error(way, ways[way], tight) > limit:
            ways[way] /= 2.0
    rounds = max(1, round(7 * size))
    times: dict[str, list[float]] = {}
    for _ in range(rounds):
        for way, rtol in ways.items():
            begin = time.process_time()
            _, transitions = peer_run(way, rtol, samples)
            times.setdefault(f"SciPy {way}", []).append(time.process_time() - begin)
        for case, allowed in cases.items():
            for _ in range(5):
                begin = time.process_time()
                run(allowed)
                times.setdefault(f"simulate(), {case} tolerance", []).append(time.process_time() - begin)
    print(f"{samples * SAMPLE:g} s of two cylinders, {len(transitions)} transitions; processor times")
    for name, values in times.items():
        print(f"{name:34s} median {1e3 * statistics.median(values):9.2f} ms, fastest {1e3 * min(values):9.2f} ms")
    fastest = min(min(values) for name, values in times.items() if name.startswith("SciPy"))
    for case in cases:
        ratio = fastest / min(times[f"simulate(), {case} tolerance"])
        print(f"ratio with the {case} tolerance {ratio:.0f}")
    shown = ", ".join(f"{way} at rtol {value:.1e}" for way, value in ways.items())
    print(f"error of the positions at most {limit:.1e} m; ours at {tolerance:.1e}, {shown}")


if __name__ == "__main__":
    main()
