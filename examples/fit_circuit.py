"""Fit parameters of a circuit to measured data: read a file, fit, check the result, simulate with the fitted values.

Run: python examples/fit_circuit.py
"""

from __future__ import annotations

from pathlib import Path

import poppet

FOLDER = Path(__file__).parent / "identify"

circuit = poppet.load(FOLDER / "bench.toml")
discharge, again = (
    poppet.read(FOLDER / name, time="t [s]", columns={"tank.pressure": "p_tank [bar g]"})
    for name in ("discharge.csv", "again.csv")
)

result = circuit.fit(
    {"discharge": discharge, "again": again},
    {
        "outlet.sonic_conductance": "1e-8 m^3/(s Pa)",  # start value of the search
        "outlet.critical_ratio": 0.3,
        "tank.wall_conductance": {"start": "5 W/K", "max": "100 W/K"},
    },
    start={"discharge": {"tank.initial_pressure": "free"}, "again": {"tank.initial_pressure": "first"}},
    validation=["again"],  # compared with the model, but not fitted
)
print(result.summary())

wall = result["tank.wall_conductance"]
print(f"wall conductance: {wall.value:.2f} W/K, 95 % confidence interval {wall.low:.2f} to {wall.high:.2f} W/K")

# The fitted circuit is a circuit like any other. The source of the fitted values is `fitted`.
number = result.circuit.numbers()["outlet.sonic_conductance"]
print(f"C = {number.display()} ({number.source.kind})")
run = result.circuit.simulate("60 s")
print(f"pressure after 60 s: {run.converted(['bar'])['tank.pressure'][-1]:.3f} bar")

result.save("fit_result.toml")
