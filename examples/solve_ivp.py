"""A circuit in SciPy's `solve_ivp`, compared with the integrator of poppet.

Run: python examples/solve_ivp.py

Run: python examples/solve_ivp.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

import poppet

FOLDER = Path(__file__).parent


def signals_only(duration: str = "120 s") -> float:
    """Compare a circuit without sampled parts; return the largest difference of the tank pressure [bar]."""
    circuit = poppet.load(FOLDER / "fill_staircase.toml")
    ode, known = circuit.to_ode(duration), circuit.simulate(duration, relative_tolerance=1e-9)
    found, x = np.empty(0), ode.x0
    # A signal jumps at a breakpoint; a restart of the solver preserves its accuracy.
    for begin, end in zip(ode.breakpoints, [*ode.breakpoints[1:], ode.end], strict=True):
        stretch = ode.stretch(begin, x)
        rows = known.time[(known.time >= begin) & (known.time < end)]
        run = solve_ivp(
            stretch.f, (begin, end), x, "LSODA", jac=stretch.jac,
            rtol=1e-9, atol=1e-9 * ode.scale, t_eval=[*rows, end],
        )  # fmt: skip
        x = run.y[:, -1]
        found = np.append(found, stretch.outputs(run.t[:-1], run.y[:, :-1])["tank.pressure"])
    return float(np.abs(found - known["tank.pressure"][: found.size]).max()) / 1e5


def with_instants(duration: str = "0.7 s") -> float:
    """Compare a circuit with a sampled controller; return the final difference of the pressure [bar]."""
    circuit = poppet.load(FOLDER / "pressure_control.toml")
    ode, t, memory = circuit.to_ode(duration), 0.0, None
    x = ode.x0
    while t < ode.end:
        stretch = ode.stretch(t, x, memory)
        run = solve_ivp(stretch.f, (t, stretch.end), x, "LSODA", jac=stretch.jac, rtol=1e-9, atol=1e-9 * ode.scale)
        t, x, memory = stretch.end, run.y[:, -1], stretch.memory
    known = circuit.simulate(duration, relative_tolerance=1e-9)["tank.pressure"][-1]
    return float(abs(stretch.outputs(t, x)["tank.pressure"] - known)) / 1e5


if __name__ == "__main__":
    print(f"staircase: greatest difference {signals_only():.1e} bar")
    print(f"sampled controller: difference at the end {with_instants():.1e} bar")
