"""The kernel against CVODES, LSODA, BDF and Radau on the complete valve: two clocks of 1 kHz, averaged and switched."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from poppet import Circuit
from poppet.engine.reference_solvers.solvers import SOLVERS
from poppet.parts import Chamber, ProportionalValve, Reservoir
from poppet.signals import Steps
from poppet.timeseries.recording import Recording

LIMITS = {"tank.pressure": 0.05, "valve.pilot_pressure": 0.1, "valve.integral": 2e-3, "valve.stroke": 2e-9}
"""Pa, and m of stroke: the full scale of pressures is 7e5."""
EVERY_DAY = (("averaged", "lsoda"), ("switched", "cvodes"))


def valve(drive: str) -> Circuit:
    """A valve on a litre, near the setpoint from the start, and without the steps of the converter."""
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": ProportionalValve(
            data="vppm_6l", supply="supply", outlet="tank", exhaust="ambient",
            pilot={"drive": drive, "initial_pressure": "2.113 bar"},
            electronics={"converter": {"bits": 0}, "outer": {"sample_time": "1.3 ms"}},
        ),
        "tank": Chamber(volume="1 l", wall_conductance=1.0, initial_pressure="2 bar"),
    }  # fmt: skip
    return Circuit(parts, {"valve.setpoint": Steps([0.0, 0.1], [2.2e5, 2e5])})


@cache
def kernel_run(drive: str) -> Recording:
    return valve(drive).simulate(0.2, 1e-3, 1e-10)


PAIRS = [
    # One of each kind is enough for every day; the others restart at thousands of instants.
    pytest.param(drive, solver, marks=[pytest.mark.slow] * ((drive, solver) not in EVERY_DAY))
    for drive in ("averaged", "switched")
    for solver in SOLVERS
]


@pytest.mark.parametrize(("drive", "solver"), PAIRS)
def test_every_solver_finds_the_same_run(drive, solver):
    own = kernel_run(drive)
    other = valve(drive).simulate(0.2, 1e-3, 1e-8, solver=solver)
    for name, limit in LIMITS.items():
        assert np.max(np.abs(other[name] - own[name])) < limit
    for residual in other.residuals:
        assert residual.is_kept
    # The loops are at work, not at their limits.
    assert np.unique(own["valve.fill_duty"]).size > 20
    assert 2.1e5 < own["tank.pressure"].max() < 2.3e5
