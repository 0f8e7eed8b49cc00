"""Single steps of `Circuit.stepper` beside SciPy's solvers from the same states, and beside one-step simulations.

The circuits are a tank (two states, steps of 0.1 s) and a cushioned cylinder (steps of 10 ms). SciPy gets the compiled
rates and Jacobians of poppet and the same tolerance, so the ratios compare the solvers and their overhead. Rounds take
turns, so that a busy machine slows all; printed is the best round of each, per step, and the ratio to `step`.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

from poppet import Chamber, Circuit, Orifice, Reservoir, load

EXAMPLES = Path(__file__).parents[1] / "examples"
TOLERANCE = 1e-6
LANES = 64
VALVE = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}


def tank() -> Circuit:
    """Return a tank of ten litres between a supply and a leak."""
    return Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "fill": Orifice(from_="supply", to="tank", **VALVE),
            "tank": Chamber(volume="10 l", initial_pressure="3 bar", wall_conductance=1.0),
            "leak": Orifice(from_="tank", to="ambient", sonic_conductance=4e-9, critical_ratio=0.3),
        }
    )


def best(tasks: dict[str, tuple[Callable[[], object], int]], rounds: int) -> dict[str, float]:
    """Return the shortest time of one step of each task; a task makes several steps."""
    times = dict.fromkeys(tasks, np.inf)
    for _ in range(rounds):
        for name, (task, count) in tasks.items():
            begin = time.perf_counter()
            task()
            times[name] = min(times[name], (time.perf_counter() - begin) / count)
    return times


def compare(circuit: Circuit, dt: float, free: list[str], size: float) -> None:
    """Print the time of a step, and of its alternatives, along a run with constant inputs."""
    held = circuit.with_signals({})
    stepper = held.stepper(free, outputs=["tank.pressure"] if "tank" in held.parts else [], tolerance=TOLERANCE)
    count = max(2, round(100 * size))
    states = [stepper.start()]
    for _ in range(count - 1):
        states.append(stepper.step(states[-1], dt))
    ode, n = held.to_ode(dt), len(stepper.states)
    rest = np.zeros(ode.x0.size - n)
    few = states[:: max(1, count // 10)]
    one = held.with_values({"run.duration": dt, "run.output_step": dt})
    many = np.resize(np.array(states), (LANES, n))

    def scipy_steps(method: str) -> object:
        absolute = TOLERANCE * ode.scale
        starts = [np.concatenate([x, rest]) for x in few]
        return [
            solve_ivp(ode.f, (0.0, dt), x, method, jac=ode.jac, rtol=TOLERANCE, atol=absolute).y[:, -1] for x in starts
        ]

    tasks: dict[str, tuple[Callable[[], object], int]] = {
        "step": (lambda: [stepper.step(x, dt) for x in states], count),
        f"steps, {LANES} states": (lambda: stepper.steps(many, dt), LANES),
        f"transition, {n} + {len(free)} columns": (lambda: [stepper.transition(x, dt) for x in states], count),
        "derivatives": (lambda: [stepper.derivatives(x) for x in states], count),
        "simulate, one row": (lambda: [one.simulate() for _ in few], len(few)),
        "SciPy LSODA": (lambda: scipy_steps("LSODA"), len(few)),
        "SciPy Radau": (lambda: scipy_steps("Radau"), len(few)),
    }
    times = best(tasks, max(1, round(20 * size)))
    for name, seconds in times.items():
        print(f"{name:28s} {1e6 * seconds:10.1f} us {seconds / times['step']:9.2f}")


def main(size: float = 1.0) -> None:
    print("tank, steps of 0.1 s")
    compare(tank(), 0.1, ["leak.sonic_conductance", "supply.pressure"], size)
    print("cushioned cylinder, steps of 10 ms")
    compare(load(EXAMPLES / "cylinder_cushioned.toml"), 0.01, ["valve.leak_conductance", "supply.pressure"], size)


if __name__ == "__main__":
    main()
