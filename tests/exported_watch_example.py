"""Watches for tests of exports: the tank of `examples/watch` with its true healthy values, and other plants."""

from __future__ import annotations

import csv
import re
import sys
from pathlib import Path

import numpy as np

from poppet import loads
from poppet.deploy.exported_watch import ExportedWatch, WatchSource
from poppet.monitoring.baseline import Baseline, ChannelMisfit
from poppet.monitoring.plan import WatchPlan, read_plan
from poppet.monitoring.twin_file import ClockColumn, read_twin_file
from watch_example import PLANT
from watched_tank import TABLES, TANK

sys.path.insert(0, str(Path(__file__).with_name("exact")))
from independent_watch_cylinder import CIRCUIT

FOLDER = Path(__file__).parents[1] / "examples" / "watch"
TRUTH = {
    "leak": PLANT.leak, "valve_clogged": PLANT.valve, "ambient.pressure": PLANT.barometer,
    "supply.temperature": PLANT.supply_temperature, "tank.wall_conductance": PLANT.wall_conductance,
    "use.sonic_conductance": PLANT.use,
}  # fmt: skip


def tank_watch() -> WatchSource:
    """The tank of the example with a baseline that contains the values of the simulated plant."""
    twin = read_twin_file(FOLDER / "twin.toml")
    plan = twin.plan
    values = np.array(
        [TRUTH.get(name, value) for name, value in zip(plan.names, plan.reference, strict=True)], dtype=float
    )
    misfit = tuple(ChannelMisfit(1.0, 1.0) for _ in plan.channels)
    return WatchSource(
        plan, Baseline(plan, values, 0.02 * plan.prior, misfit, duration=240.0, readings=2400), twin.clock, "Tank"
    )


def offset_watch() -> WatchSource:
    """A tank with an offset of its gauge, a fault of an input, and an input that changes linearly."""
    tables = {**TABLES, "settings": {"window": "30 s", "hold": False}}
    plan = read_plan(loads(TANK), **tables)
    return WatchSource(plan, Baseline.of_circuit(plan), ClockColumn(), "Offset tank")


def cylinder_watch() -> WatchSource:
    """A cylinder whose two chambers and piston are measured."""
    plan = read_plan(
        loads(CIRCUIT),
        {
            "cylinder.cap.pressure": {"noise": "5 mbar"},
            "cylinder.rod.pressure": {"noise": "5 mbar"},
            "slide.position": {"noise": "0.2 mm"},
            "valve.command": {},
        },
        {
            "clogged": {"address": "valve.sonic_conductance", "alarm": "2e-10 m^3/(s Pa)", "direction": "down"},
            "leak": {"address": "cylinder.leakage.sonic_conductance", "alarm": "2e-11 m^3/(s Pa)"},
        },
        {"supply.pressure": {"sigma": "0.1 bar", "drift": "0.01 bar"}},
        {"window": "20 s", "alarm_delay": "0.5 s"},
    )
    return WatchSource(plan, Baseline.of_circuit(plan), ClockColumn(), "Cylinder")


def recorded(source: WatchSource, path: Path) -> list[tuple[float, np.ndarray, np.ndarray]]:
    """Time, readings and inputs of a recording in SI."""
    plan, samples = source.plan, []
    with path.open() as stream:
        for row in csv.DictReader(stream):
            readings, inputs = (
                np.array([item.to_si(float(row[item.column] or "nan")) for item in items])
                for items in (plan.channels, plan.inputs)
            )
            samples.append((float(row[source.clock.column]), readings, inputs))
    return samples


def expected_rows(source: WatchSource, path: Path) -> list[list[float]]:
    """Results of the exported watch in Python for a recording."""
    watch, rows = ExportedWatch(source.plan, source.baseline), []
    for time, readings, inputs in recorded(source, path):
        watch.update(time, readings, inputs)
        rows.append(watch.row())
    return rows


def bits_of(names: str, plan: WatchPlan) -> float:
    """An alarm as one bit for each fault."""
    present = re.split(" or | and ", names)
    return float(sum(2**k for k, fault in enumerate(plan.faults) if fault.name in present))
