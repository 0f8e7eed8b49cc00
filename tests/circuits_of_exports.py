"""Ten circuits on which every target of an export is compared with the kernel."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from poppet import Chamber, CheckValve, Circuit, Orifice, ReliefValve, Reservoir, load
from poppet.timeseries.signals import Points

EXAMPLES = Path(__file__).parents[1] / "examples"
CONTROLLERS = {
    "pressure_control": (),
    "pressure_control_scheduled": (),
    "pressure_control_linearising": (),
    "pressure_regulator": (),
    "position_control": (),
    "muscle_joint": ("valve", "position", "inverse"),
    "two_cylinders": ("plc", "pressed"),
}
"""Exported controllers: name of the example, and of its controllers if there are several."""


def example(name: str, duration: str, **values: Any) -> Circuit:
    return load(EXAMPLES / f"{name}.toml").with_values({"run.duration": duration, **values})


def check_and_relief() -> Circuit:
    """A pump line that rises and falls fills a vessel through a check valve; a relief valve holds it."""
    valve = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}
    parts = {
        "line": Reservoir(pressure="2 bar"),
        "check": CheckValve(from_="line", to="vessel", cracking_pressure="0.1 bar", **valve),
        "vessel": Chamber(volume="1 l", wall_conductance=0.1),
        "relief": ReliefValve(from_="vessel", to="ambient", set_pressure="5 bar", **valve),
    }
    signals = {"line.pressure": Points([0.0, 2.0, 4.0], [2e5, 8e5, 1e5])}
    return Circuit(parts, signals, title="check and relief valve").with_values({"run.duration": "5 s"})


def chambers(count: int) -> Circuit:
    """A supply and chambers of one litre in a row."""
    parts: dict[str, Any] = {"supply": Reservoir(pressure="7 bar")}
    for k in range(count):
        before = f"c{k - 1}" if k else "supply"
        parts[f"o{k}"] = Orifice(from_=before, to=f"c{k}", sonic_conductance=1e-8, critical_ratio=0.3)
        parts[f"c{k}"] = Chamber(volume="1 l", wall_conductance=0.1)
    return Circuit(parts, title=f"{count} chambers").with_values({"run.duration": "20 s"})


WALL = {"high.heat_transfer": "natural", "high.wall_area": "0.5 m^2", "high.height": "0.5 m"}
TEN: dict[str, Callable[[], Circuit]] = {
    "staircase": lambda: example("fill_staircase", "60 s"),
    "two tanks": lambda: example("two_tanks", "300 s"),
    "regulator": lambda: example("pressure_regulator", "2 s"),
    "switched": lambda: example("pressure_regulator", "1 s", **{"valve.pilot.drive": "switched"}),
    "check and relief": check_and_relief,
    "32 chambers": lambda: chambers(32),
    "cylinder": lambda: example("cylinder_cushioned", "2 s"),
    "muscle joint": lambda: example("muscle_joint", "1.4 s"),
    "energy wall": lambda: example("two_tanks", "300 s", **WALL),
    "helium": lambda: example("two_tanks", "300 s", **{"gas.name": "helium"}),
}
EVERYDAY = ("two tanks",)
