"""Circuits with FMUs for tests: an oscillator of two FMUs, and a controlled tank beside one."""

from __future__ import annotations

import math
from pathlib import Path

from poppet import FMU, PID, Chamber, Circuit, Orifice, Reservoir, Run
from poppet.signals import Steps

OMEGA = 2.0 * math.pi


def oscillator(path: Path, step: float, **fields) -> Circuit:
    """Two integrators with x' = w v, v' = -w x, whose solution is x = cos(w t)."""
    parts = {
        "x": FMU(path, step=step, start={"initial[y]": 1.0, "rate": OMEGA}, **fields),
        "v": FMU(path, step=step, start={"rate": -OMEGA}),
    }
    run = Run(duration=1.0, output_step=0.1, relative_tolerance=1e-9)
    return Circuit(parts, connections={"x.u": "v.y", "v.u": "x.y"}, run=run)


def controlled_tank(fmu: Path) -> Circuit:
    """A sampled controller fills a tank, beside an FMU that only integrates the pressure."""
    size = {"sonic_conductance": "0.2 dm^3/(s bar)", "critical_ratio": 0.3}
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "fill": Orifice(from_="supply", to="tank", **size),
        "vent": Orifice(from_="tank", to="ambient", **size),
        "tank": Chamber(volume="1 l", wall_conductance=1.0),
        "regulator": PID(gain="2 1/bar", integral_time="0.2 s", setpoint="3 bar g", sample_time="5 ms"),
    }
    connections = {
        "regulator.measurement": "tank.pressure",
        "fill.opening": "regulator.fill_command",
        "vent.opening": "regulator.vent_command",
    }
    signals = {"regulator.setpoint": Steps([0.0, 0.3], [4e5, 2e5])}
    if fmu is not None:
        parts["meter"] = FMU(fmu, step=0.0123, units={"u": "Pa"})
        connections["meter.u"] = "tank.pressure"
    return Circuit(
        parts, signals, Run(duration=0.6, output_step=0.01, relative_tolerance=1e-8), connections=connections
    )
