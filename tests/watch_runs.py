"""Runs of a filter with its monitor over simulated readings of the tank."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from exact.independent_watch_tank import (
    ADDRESSES,
    CIRCUIT,
    HEALTHY,
    ONE_PERCENT,
    SAMPLE_TIME,
    Sensors,
    Tank,
    random_openings,
    readings,
    simulate,
    stepped_leak,
)
from poppet import loads
from poppet.monitoring.baseline import Baseline
from poppet.monitoring.filter import PlantFilter
from poppet.monitoring.plan import WatchPlan, read_plan
from poppet.monitoring.refit import WindowRefit
from poppet.monitoring.verdicts import FaultMonitor

Array = NDArray[np.float64]
SIX = {
    ADDRESSES["valve"]: {"relative_sigma": 0.05},
    ADDRESSES["wall_conductance"]: {"relative_sigma": 0.5},
    ADDRESSES["use"]: {"relative_sigma": 0.05},
    ADDRESSES["supply_pressure"]: {"sigma": "20 kPa"},
    ADDRESSES["supply_temperature"]: {"sigma": "15 K"},
}
"""Nuisances of a watch with six free numbers."""


def tank_plan(alarm: float = 0.3 * ONE_PERCENT, nuisances: dict[str, Any] = SIX, **settings: Any) -> WatchPlan:
    """Plan of a watch of the tank: its pressure, and the openings of valve and consumer."""
    measured: dict[str, Any] = {"tank.pressure": {"noise": "500 Pa"}, "valve.opening": {}, "use.opening": {}}
    faults = {"leak": {"address": ADDRESSES["leak"], "alarm": alarm, "direction": "up"}}
    return read_plan(loads(CIRCUIT), measured, faults, nuisances, {"window": "60 s"} | settings)


IDEAL = Sensors()
"""Sensors with noise only."""


@dataclass(frozen=True)
class TankWatch:
    """Results of a run at all samples."""

    time: Array
    leak: Array  # estimate of the leak of the filter alone [m^3/(s Pa)]
    sigma: Array
    nis: Array
    count: Array
    alarm: NDArray[np.bool_]
    names: frozenset[str]  # in alarms
    restarts: int

    def first_alarm(self, since: float = 0.0) -> float:
        """Time from `since` to the beginning of the first later alarm [s]."""
        rows = np.flatnonzero(self.alarm & (self.time >= since))
        return float(self.time[rows[0]]) - since if rows.size else np.inf


def watch_tank(plan: WatchPlan, values: Array, openings: Array) -> TankWatch:
    """Run a filter and a monitor over the readings of one run."""
    filter_ = PlantFilter(plan)
    refit = WindowRefit(plan, Baseline.of_circuit(plan), filter_)
    monitor = FaultMonitor(plan.faults, alarm_delay=plan.alarm_delay, window=plan.window, refit=refit)
    rows, alarm, names = np.empty((len(values), 4)), np.zeros(len(values), dtype=bool), set[str]()
    for k, (reading, opening) in enumerate(zip(values, openings, strict=True)):
        filter_.update(SAMPLE_TIME * k, reading, opening)
        posterior = filter_.fault_posterior()
        monitor.update(filter_.time, filter_.bank(), *posterior, filter_.nis, filter_.count)
        if monitor.adoption is not None:
            filter_.adopt(monitor.adoption)
            posterior = filter_.fault_posterior()
        rows[k] = filter_.theta[0], np.sqrt(posterior.covariance[0, 0]), filter_.nis, filter_.count
        alarm[k] = bool(monitor.alarm)
        names |= set(monitor.alarm)
    return TankWatch(SAMPLE_TIME * np.arange(len(values)), *rows.T, alarm, frozenset(names), filter_.restarts)


def watch_leaks(
    plan: WatchPlan, size: float, runs: int, *, start: float = 150.0, duration: float = 300.0,
    tank: Tank = HEALTHY, sensors: Sensors = IDEAL, openings: Any = random_openings,
) -> list[TankWatch]:  # fmt: skip
    """Run watches of tanks whose leak grows by `size` per cent of the valve at a time."""
    samples, seeds = round(duration / SAMPLE_TIME), range(runs)
    inputs = openings(seeds, samples)
    leak = stepped_leak(tank.leak, tank.leak + size * ONE_PERCENT, start, runs, samples)
    values = readings(tank, simulate(tank, inputs, leak), sensors, seeds)
    return [watch_tank(plan, *pair) for pair in zip(values, inputs, strict=True)]
