"""Numbers inside a complete valve, with sampling, hold band and converter, are found from noisy steps."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from poppet.circuit.file import loads
from poppet.identify import identify_fit

BENCH = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.valve]
kind = "proportional_valve"
data = "vppm_6l"
preset = "fast"
supply = "supply"
outlet = "tank"
exhaust = "ambient"
[parts.tank]
kind = "chamber"
volume = "1 l"
wall_conductance = "1 W/K"
[signals."valve.setpoint"]
kind = "steps"
times = [0, 1, 2]
values = ["3 bar", "5 bar", "2 bar"]
[run]
duration = "3 s"
output_step = "5 ms"
"""
FIT = """
circuit = "bench.toml"
[recordings.steps]
file = "steps.csv"
time = { column = "t", unit = "s" }
"tank.pressure" = { column = "p", unit = "Pa", noise = "500 Pa" }
"valve.pilot_pressure" = { column = "pilot", unit = "Pa", noise = "500 Pa" }
[free]
"valve.pilot.fill.sonic_conductance" = { start = "1e-10 m^3/(s Pa)" }
"valve.pilot.vent.sonic_conductance" = { start = "3.5e-10 m^3/(s Pa)" }
"valve.pilot.volume" = { start = "8 cm^3" }
"valve.main_stage.exhaust_seat.sonic_conductance" = { start = "0.5e-8 m^3/(s Pa)" }
"""


@pytest.mark.slow  # every day, tests/unit/identify/test_experiment.py finds two numbers of a smaller program
@pytest.mark.parametrize("seed", [1, 2])
def test_numbers_of_pilot_and_main_stage_are_found(tmp_path: Path, seed: int) -> None:
    circuit = loads(BENCH)
    run = circuit.simulate()
    noisy = [run[name] + np.random.default_rng([seed, k]).normal(0.0, 500.0, run.time.size)
             for k, name in enumerate(("tank.pressure", "valve.pilot_pressure"))]  # fmt: skip
    np.savetxt(
        tmp_path / "steps.csv", np.column_stack([run.time, *noisy]), delimiter=",", header="t,p,pilot", comments=""
    )
    (tmp_path / "bench.toml").write_text(BENCH)
    (tmp_path / "fit.toml").write_text(FIT)
    result = identify_fit(tmp_path / "fit.toml")
    for address, estimate in result.parameters.items():
        truth = float(circuit.numbers()[address])
        assert estimate.value == pytest.approx(truth, rel=0.015), address
    assert any("a program samples in the circuit" in sentence for sentence in result.findings)
    assert all(residual.nrmse < 0.003 for residual in result.residuals.values())
