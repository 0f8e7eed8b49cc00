"""Watch of a running plant as it is exported: the part of the filter and of its alarms that needs no fits."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import ErrorCollector
from poppet.monitoring.baseline import Baseline
from poppet.monitoring.filter import PlantFilter
from poppet.monitoring.plan import WatchPlan
from poppet.monitoring.plant_estimator import make_estimator
from poppet.monitoring.sensors import DrivenInput
from poppet.monitoring.twin_file import ClockColumn
from poppet.monitoring.verdicts import FaultMonitor

Array = NDArray[np.float64]

MOST_FAULTS = 32
PER_ALARM_DELAY = 10
"""Number of samples of the test vector within the alarm delay."""
LENGTH, ONSET = 1.6, 1.2
"""Duration of the test vector, and time at which its fault begins, in windows."""
MOST_ROWS = 1500
FAULT_SIZE = 2.0
"""Size of the fault in the test vector, in alarm sizes."""
HOLD = 20
"""Number of samples for which the inputs of the test vector are constant."""
SEED = 29


class WatchSource(NamedTuple):
    """Everything that determines an exported watch."""

    plan: WatchPlan
    baseline: Baseline
    clock: ClockColumn
    title: str


def check_watch(plan: WatchPlan) -> None:
    """Raise an error if a watch has features that an exported program does not support."""
    with ErrorCollector() as errors:
        for item in plan.inputs:
            if item.delay:
                errors.add("deploy.watch.delay", f"measured.{item.address}", delay=item.delay)
        if len(plan.faults) > MOST_FAULTS:
            errors.add("deploy.watch.faults", "faults", count=len(plan.faults), most=MOST_FAULTS)


def possible_changes(plan: WatchPlan, baseline: Baseline) -> tuple[Array, Array]:
    """Return the smallest and the largest possible change of each fault number, (f,) each [SI]."""
    f = len(plan.faults)
    return plan.free.low[:f] - baseline.faults, plan.free.high[:f] - baseline.faults


class ExportedWatch:
    """Watch with the estimates and alarms of the exported C code.

    Estimates have the same bits if the C compiler does not fuse operations.

    Parameters
    ----------
    plan : WatchPlan
        Sensors, faults and settings.
    baseline : Baseline
        Healthy state of the plant.
    """

    def __init__(self, plan: WatchPlan, baseline: Baseline) -> None:
        self.plan = plan
        self.filter = PlantFilter(plan, baseline, fuses=False, fits=False)
        self.monitor = FaultMonitor(
            plan.faults, alarm_delay=plan.alarm_delay, window=plan.window, temper=baseline.temper,
            healthy_nis=baseline.healthy_nis, bounds=possible_changes(plan, baseline),
        )  # fmt: skip

    def update(self, time: float, readings: Array, inputs: Array) -> None:
        """Use a sample in SI units."""
        self.filter.update(time, readings, inputs)
        change, covariance = self.filter.fault_posterior()
        self.monitor.update(time, self.filter.bank(), change, covariance, self.filter.nis, self.filter.count)
        if self.monitor.adoption is not None:
            self.filter.adopt(self.monitor.adoption)
        if not self.monitor.alarm:
            self.filter.end_growth()

    def row(self) -> list[float]:
        """Return estimates and standard deviations of the faults, NIS, and the alarm with one bit for each fault."""
        f = len(self.plan.faults)
        bits = sum(2.0**k for k, fault in enumerate(self.plan.faults) if fault.name in self.monitor.alarm)
        n, steps = len(self.filter.states), self.monitor.open_steps()
        variances = self.filter.covariance.diagonal()[n : n + f]
        if steps is not None:
            variances = variances + np.max(self.filter.changes_by_steps(steps) ** 2, axis=0)
        sigmas = np.sqrt(variances)
        return [*self.filter.theta[:f], *sigmas, self.filter.nis, bits]


def simulated_samples(source: WatchSource) -> list[list[float]]:
    """Return samples of a simulated plant with the expected results of the exported code.

    Each row contains time, readings and inputs in SI units, then `ExportedWatch.row`. The inputs are random steps. The
    first fault begins when the filter knows the plant.
    """
    plan, watch = source.plan, ExportedWatch(source.plan, source.baseline)
    generator = np.random.default_rng(SEED)
    plant = make_estimator(plan, False)
    x = plan.instance.start()[0][: len(watch.filter.states)]
    plant.mean[:] = [*x, *watch.filter.healthy]
    dt = max(plan.alarm_delay / PER_ALARM_DELAY, LENGTH * plan.window / MOST_ROWS)
    n_rows = round(LENGTH * plan.window / dt)
    noise = np.array([channel.noise for channel in plan.channels])
    inputs = given = np.zeros(len(plan.inputs))
    rows, indices, holds = [], [item.index for item in plan.inputs], [item.hold for item in plan.inputs]
    for row in range(n_rows):
        if row % HOLD == 0:
            given = _rounded([_random_input(generator, item, plant.u[0, item.index]) for item in plan.inputs])
        if row:
            plant.u[0, indices], plant.u[1, indices] = inputs, np.where(holds, inputs, given)
            plant.advance(dt)
        inputs = plant.u[:, indices] = given
        if row == round(ONSET * plan.window / dt):
            fault = plan.faults[0]
            plant.mean[len(x)] += (fault.direction or 1) * FAULT_SIZE * fault.alarm
        plant.correct()
        readings = _rounded(plant.expected + noise * generator.standard_normal(noise.size))
        watch.update(row * dt, readings, inputs)
        rows.append([row * dt, *readings, *inputs, *watch.row()])
    return rows


def _rounded(values: Iterable[float]) -> Array:
    return np.array([float(f"{value:.7g}") for value in values])


def _random_input(generator: np.random.Generator, item: DrivenInput, value: float) -> float:
    """Return a random value of an input within its limits, or near its value if it has none."""
    low, high = item.low, item.high
    if not (math.isfinite(low) and math.isfinite(high)):
        low, high = max(low, 0.8 * value), min(high, 1.2 * value)
    return generator.uniform(low, high)
