"""How the flow law costs next to the textbook formula, measured side by side in one run."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np

from poppet.iso6358 import flow, flow_regime, mass_flow_rate

CONDUCTANCE, RATIO, TEMPERATURE = 1.65e-8, 0.43, 293.15
VALVE: dict[str, Any] = {"sonic_conductance": CONDUCTANCE, "critical_ratio": RATIO}
REPEATS = 15


def textbook(pressure_1: Any, pressure_2: Any) -> Any:
    """Forward flow only, no zone, no checks: the formula as one would type it."""
    r = pressure_2 / pressure_1
    choked = CONDUCTANCE * 1.185 * np.sqrt(293.15 / TEMPERATURE) * pressure_1
    return np.where(r <= RATIO, choked, choked * np.sqrt(1 - ((r - RATIO) / (1 - RATIO)) ** 2))


def medians(candidates: dict[str, Callable[[], Any]], repeats: int = REPEATS) -> dict[str, float]:
    """Median seconds of each, taken in turns so that a slow moment hits all alike."""
    times: dict[str, list[float]] = {name: [] for name in candidates}
    for _ in range(repeats):
        for name, call in candidates.items():
            start = time.perf_counter()
            call()
            times[name].append(time.perf_counter() - start)
    return {name: statistics.median(values) for name, values in times.items()}


def report_arrays(points: int) -> None:
    generator = np.random.default_rng(6358)
    p1 = generator.uniform(5e5, 7e5, points)
    p2 = p1 * generator.uniform(0.1, 0.99, points)
    t1, t2 = generator.uniform(280.0, 320.0, (2, points))
    found = medians(
        {
            "textbook": lambda: textbook(p1, p2),
            "mass_flow_rate": lambda: mass_flow_rate(p1, p2, TEMPERATURE, **VALVE),
            "mass_flow_rate, two temperatures": lambda: mass_flow_rate(p1, p2, 300.0, 290.0, **VALVE),
            "mass_flow_rate, m = 0.55": lambda: mass_flow_rate(p1, p2, TEMPERATURE, subsonic_index=0.55, **VALVE),
            "mass_flow_rate, cracking pressure": lambda: mass_flow_rate(
                p1, p2, TEMPERATURE, cracking_pressure=1e4, **VALVE
            ),
            "flow, arrays of temperatures": lambda: flow(p1, p2, t1, t2, **VALVE),
            "flow_regime": lambda: flow_regime(p1, p2, critical_ratio=RATIO),
        }
    )
    print(f"{points} points")
    for name, seconds in found.items():
        print(f"  {name:36s} {seconds * 1e3:8.2f} ms   {seconds / found['textbook']:5.2f} x textbook")


def report_floats(count: int) -> None:
    calls = range(count)
    found = medians(
        {
            "textbook": lambda: [textbook(7e5, 5e5) for _ in calls],
            "mass_flow_rate": lambda: [mass_flow_rate(7e5, 5e5, 293.15, **VALVE) for _ in calls],
        },
        repeats=9,
    )
    print("one float")
    for name, seconds in found.items():
        per_call = seconds / len(calls) * 1e6
        print(f"  {name:36s} {per_call:8.2f} us   {seconds / found['textbook']:5.2f} x textbook")


def report_graph() -> None:
    symbols = [ca.SX.sym(name) for name in ("p1", "p2", "T1", "T2", "C", "b")]
    results = flow(*symbols[:4], sonic_conductance=symbols[4], critical_ratio=symbols[5])
    jacobian = ca.jacobian(ca.vertcat(*results), ca.vertcat(*symbols[:4]))
    print("traced flow (mass flow rate and temperature)")
    for name, outputs in (("law", list(results)), ("law and Jacobian", [*results, jacobian])):
        count = ca.Function("f", symbols, outputs, {"cse": True}).n_instructions()
        print(f"  {name:36s} {count:8d} instructions, arguments and results included")


def main(size: float = 1.0) -> None:
    report_arrays(max(2, round(1e6 * size)))
    report_floats(max(2, round(2e3 * size)))
    report_graph()


if __name__ == "__main__":
    main()
