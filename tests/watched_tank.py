"""Tank with a supply valve, a consumer and a leak, and the tables of its watch."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

from poppet import Circuit, loads
from poppet.monitoring.plan import WatchPlan, read_plan

TANK = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
temperature = "293.15 K"

[parts.valve]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "1e-8 m^3/(s Pa)"
critical_ratio = 0.3

[parts.tank]
kind = "chamber"
volume = "10 l"
thermal = "energy"
initial_pressure = "5 bar"
wall_conductance = "2 W/K"

[parts.consumer]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = "1e-8 m^3/(s Pa)"
critical_ratio = 0.3

[parts.leak]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = 0.0
critical_ratio = 0.3
"""
TABLES: dict[str, dict[str, Any]] = {
    "measured": {
        "tank.pressure": {"column": "p", "unit": "bar g", "noise": "5 mbar", "offset": "2 mbar"},
        "consumer.opening": {"column": "u", "unit": "%"},
    },
    "faults": {
        "leak": {"address": "leak.sonic_conductance", "alarm": "1e-10 m^3/(s Pa)", "direction": "up"},
        "supply_low": {"address": "supply.pressure", "alarm": "0.3 bar", "direction": "down"},
    },
    "nuisances": {
        "ambient.pressure": {"sigma": "15 mbar", "drift": "1 mbar"},
        "valve.sonic_conductance": {"relative_sigma": 0.05},
    },
    "settings": {"window": "30 s"},
}


def watched_tank(text: str = TANK) -> Circuit:
    """Circuit of the tank."""
    return loads(text)


def plan_of_tank(circuit: Circuit | None = None, **tables: Any) -> WatchPlan:
    """Plan of the tank; `tables` replaces whole tables."""
    return read_plan(circuit or watched_tank(), **(deepcopy(TABLES) | tables))
