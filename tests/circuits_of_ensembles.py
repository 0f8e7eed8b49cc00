"""Small circuits with ensembles."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

from poppet import Circuit, loads

TANK = """
title = "A tank runs empty"

[parts.tank]
kind = "chamber"
volume = "2 l"
initial_pressure = "3 bar"
wall_conductance = "1 W/K"

[parts.hole]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = "2 dm^3/(s bar)"
critical_ratio = 0.3

[run]
duration = "1 s"
output_step = "20 ms"
"""
TABLES = """
[ensemble]
runs = 300
seed = 1

[ensemble.parameters]
"tank.volume" = { distribution = "normal", relative_sigma = 0.02 }
"hole.sonic_conductance" = { distribution = "uniform", low = "1.8 dm^3/(s bar)", high = "2.2 dm^3/(s bar)" }

[ensemble.metrics]
end = { of = "tank.pressure", metric = "final", unit = "bar" }
empty = { of = "tank.pressure", metric = "time_to", value = "0.5 bar g" }
air = { of = "hole.mass_flow_rate", metric = "integral", unit = "l ANR" }

[requirements]
fast = "empty < 0.5 s"
low = "0 bar g <= end < 1.5 bar"
"""
LARGE = TABLES.replace("runs = 300", "runs = 2500")
"""Five shards of runs."""
NUMBERS: dict[str, Any] = {
    "tank.volume": {"distribution": "normal", "relative_sigma": 0.02},
    "hole.sonic_conductance": {"distribution": "uniform", "relative_range": 0.1},
}
METRICS: dict[str, Any] = {"end": {"of": "tank.pressure", "metric": "final"}}


def tank(tables: str = TABLES, folder: Path | None = None) -> Circuit:
    """A tank that runs empty, with an ensemble."""
    return loads(TANK + tables, folder=folder)


def hashes(folder: Path) -> dict[str, str]:
    """Of every file of a dataset."""
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}
