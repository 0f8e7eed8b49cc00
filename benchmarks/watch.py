"""Updates of a watch and of its filter beside an extended Kalman filter in NumPy, and filterpy's if it is installed.

The circuits are a tank with its pressure at 10 Hz and two or six free parameters, a plain and a cushioned cylinder with
two pressures and the position at 100 Hz and five free parameters, and the tank of `examples/watch` with three faults
and four nuisances. The other filters get prediction and transition from `Circuit.stepper`, so the ratios compare the
filters: `Filter` also has gates, a bank of 24 onsets of faults, and keeps its estimates for late samples. `Watch` also
reads each sample by its columns, places it on its clock, decides on alarms, and returns a row. Times are processor
time; the starts with their fits are excluded.
"""

from __future__ import annotations

import csv
import importlib.util
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

import poppet
from poppet import Chamber, Circuit, Orifice, Reservoir, loads
from poppet.circuit.stepper import Stepper
from poppet.monitoring.filter import PlantFilter
from poppet.monitoring.plan import WatchPlan, read_plan

EXAMPLES = Path(__file__).parents[1] / "examples"
NUISANCES: dict[str, dict[str, Any]] = {
    "valve.sonic_conductance": {"relative_sigma": 0.05},
    "use.sonic_conductance": {"relative_sigma": 0.05},
    "tank.wall_conductance": {"relative_sigma": 0.3},
    "supply.pressure": {"sigma": "20 kPa"},
    "supply.temperature": {"sigma": "15 K"},
}


def tank_plan(nuisances: int) -> WatchPlan:
    """Return the plan of a tank between a valve and a consumer, whose leak is the fault."""
    circuit = Circuit(
        {
            "supply": Reservoir(pressure="8 bar"),
            "valve": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
            "tank": Chamber(volume="10 l", initial_pressure="5 bar", wall_conductance=4.0),
            "use": Orifice(from_="tank", to="ambient", sonic_conductance=8e-9, critical_ratio=0.3),
            "leak": Orifice(from_="tank", to="ambient", sonic_conductance=2e-11, critical_ratio=0.3),
        }
    )
    measured = {"tank.pressure": {"noise": "500 Pa"}, "valve.opening": {}, "use.opening": {}}
    faults = {"leak": {"address": "leak.sonic_conductance", "alarm": 3e-11, "direction": "up"}}
    return read_plan(circuit, measured, faults, dict(list(NUISANCES.items())[:nuisances]), {})


def cylinder_plan(*, has_cushions: bool) -> WatchPlan:
    """Return the plan of a cylinder with a directional valve."""
    text = (EXAMPLES / "cylinder_cushioned.toml").read_text(encoding="utf-8")
    if not has_cushions:
        before, _, after = text.partition("[parts.cylinder.cap_cushion]")
        text = before + after[after.index("[parts.slide]") :]
    circuit = loads(text)
    measured = {
        "cylinder.cap.pressure": {"noise": "1 kPa"},
        "cylinder.rod.pressure": {"noise": "1 kPa"},
        "slide.position": {"noise": "0.1 mm"},
        "valve.command": {},
    }
    faults = {
        "spool_leak": {"address": "valve.leak_conductance", "alarm": 1e-10},
        "clogged_silencer": {"address": "valve.exhaust_a_conductance", "alarm": 1e-10, "direction": "down"},
    }
    nuisances: dict[str, Any] = {"supply.pressure": {"sigma": "20 kPa"}, "supply.temperature": {"sigma": "5 K"}}
    nuisances["slide.friction.viscous_coefficient"] = {"relative_sigma": 0.2}
    return read_plan(circuit, measured, faults, nuisances, {"window": "10 s"})


def stepper_of(plan: WatchPlan, free: Sequence[str]) -> Stepper:
    """Return the stepper of a circuit whose outputs are the measured ones."""
    return Stepper(plan.instance, free, [channel.address for channel in plan.channels], plan.tolerance)


def recording(plan: WatchPlan, dt: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return readings with noise, (count, c), and driven inputs, (count, d), which change at random."""
    generator = np.random.default_rng(1)
    stepper = stepper_of(plan, ())
    u, x = stepper.default_inputs(), stepper.start()
    readings, inputs = np.empty((count, len(plan.channels))), np.empty((count, len(plan.inputs)))
    for k in range(count):
        for item in plan.inputs if k % round(1.0 / dt) == 0 else ():
            low = max(item.low, -1.0)
            u[item.index] = generator.choice([low, 1.0])
        readings[k] = stepper.outputs_at(x, u=u)
        inputs[k] = [u[item.index] for item in plan.inputs]
        x = stepper.step(x, dt, u=u)
    return readings + generator.normal(size=readings.shape) * [channel.noise for channel in plan.channels], inputs


class NumpyFilter:
    """Extended Kalman filter in NumPy; `correct` may be replaced."""

    def __init__(self, plan: WatchPlan, start: PlantFilter) -> None:
        self.plan, self.mean, self.covariance = plan, start.mean, start.covariance
        self.stepper = stepper_of(plan, plan.free.addresses)
        self.n, self.noise = len(self.stepper.states), np.diag([channel.noise**2 for channel in plan.channels])
        self.walk = np.diag(np.append((plan.state_noise * self.mean[: self.n]) ** 2, plan.walk))
        self.u = self.stepper.default_inputs()
        self.indices = [item.index for item in plan.inputs]

    def update(self, dt: float, readings: np.ndarray, inputs: np.ndarray) -> None:
        x, free = np.split(np.maximum(self.mean, np.append(np.full(self.n, -np.inf), self.plan.free.low)), [self.n])
        step = self.stepper.transition(x, dt, u=self.u, free=free)
        matrix = np.eye(self.mean.size)
        matrix[: self.n] = np.hstack([step.by_state, step.by_free])
        self.mean[: self.n] = step.state
        self.covariance = matrix @ self.covariance @ matrix.T + self.walk * dt
        self.u[self.indices] = inputs
        slopes = self.stepper.derivatives(self.mean[: self.n], u=self.u, free=free)
        self.correct(readings, slopes.outputs, np.hstack([slopes.outputs_by_state, slopes.outputs_by_free]))

    def correct(self, readings: np.ndarray, expected: np.ndarray, slopes: np.ndarray) -> None:
        gain = np.linalg.solve(slopes @ self.covariance @ slopes.T + self.noise, slopes @ self.covariance).T
        self.mean = self.mean + gain @ (readings - expected)
        rest = np.eye(self.mean.size) - gain @ slopes
        self.covariance = rest @ self.covariance @ rest.T + gain @ self.noise @ gain.T


class FilterpyFilter(NumpyFilter):
    """The same with the correction of `filterpy.kalman.ExtendedKalmanFilter`."""

    def correct(self, readings: np.ndarray, expected: np.ndarray, slopes: np.ndarray) -> None:
        if not hasattr(self, "peer"):
            kalman: Any = importlib.import_module("filterpy.kalman")
            self.peer = kalman.ExtendedKalmanFilter(self.mean.size, readings.size)
            self.peer.R = self.noise
        self.peer.x, self.peer.P = self.mean, self.covariance
        self.peer.update(readings, lambda _: slopes, lambda _: expected)
        self.mean, self.covariance = self.peer.x, self.peer.P


def compare(name: str, plan: WatchPlan, dt: float, size: float) -> None:
    """Print updates per second of the filter and its peers."""
    warm, count = round(1.1 * plan.window / dt), max(5, round(5000 * size))
    warm = warm if size >= 1.0 else 5
    readings, inputs = recording(plan, dt, warm + count)
    filter_ = PlantFilter(plan)
    for k in range(warm):
        filter_.update(k * dt, readings[k], inputs[k])
    peers = peers_of(plan, filter_, dt, readings[warm:], inputs[warm:])

    def run_filter() -> int:
        for k in range(warm, warm + count):
            filter_.update(k * dt, readings[k], inputs[k])
        return count

    print_rates(name, plan, {"Filter": run_filter, **peers})


def compare_watch(size: float) -> None:
    """Print updates per second of the watch of `examples/watch` and of the peers of its filter."""
    watch = poppet.watch(EXAMPLES / "watch" / "twin.toml")
    with (EXAMPLES / "watch" / "healthy.csv").open(encoding="utf-8") as stream:
        samples = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(stream)]
    warm, count = (700, len(samples) - 700) if size >= 1.0 else (5, 5)
    for sample in samples[:warm]:
        watch.update(sample)
    read = [watch.reader.read(sample, []) for sample in samples[warm : warm + count]]
    values, n = np.array([sample.values for sample in read]), len(watch.plan.channels)
    peers = peers_of(watch.plan, watch.running_filter, read[1].time - read[0].time, values[:, :n], values[:, n:])

    def run_watch() -> int:
        for sample in samples[warm : warm + count]:
            watch.update(sample)
        return count

    print_rates("Watch of a tank", watch.plan, {"Watch": run_watch, **peers})


def peers_of(
    plan: WatchPlan, start: PlantFilter, dt: float, readings: np.ndarray, inputs: np.ndarray
) -> dict[str, Callable[[], int]]:
    """Return runs of all peers from an estimate, over a tenth of the samples. They return the number of updates."""
    NumpyFilter(plan, start).update(dt, readings[0], inputs[0])  # compiles the functions of the stepper
    peers: dict[str, NumpyFilter] = {"NumPy": NumpyFilter(plan, start)}
    if importlib.util.find_spec("filterpy") is not None:
        peers["filterpy"] = FilterpyFilter(plan, start)
    some = max(2, len(readings) // 10)

    def run_of(peer: NumpyFilter) -> Callable[[], int]:
        def run() -> int:
            for k in range(some):
                peer.update(dt, readings[k], inputs[k])
            return some

        return run

    return {label: run_of(peer) for label, peer in peers.items()}


def print_rates(name: str, plan: WatchPlan, tasks: dict[str, Callable[[], int]]) -> None:
    """Run all tasks, and print their updates per second and the ratios to the NumPy filter."""
    rates = {}
    for label, task in tasks.items():
        begin = time.process_time()
        updates = task()
        rates[label] = updates / max(time.process_time() - begin, 1e-9)
    n_states = len(plan.instance.model.states)
    print(f"{name}: {n_states} states, {len(plan.names)} free, {len(plan.channels)} sensors")
    for label, rate in rates.items():
        print(f"{label:12s} {rate:10.0f} updates/s {rate / rates['NumPy']:8.1f}")


def main(size: float = 1.0) -> None:
    compare("Tank", tank_plan(1), 0.1, size)
    compare("Tank", tank_plan(5), 0.1, size)
    compare("Plain cylinder", cylinder_plan(has_cushions=False), 0.01, size)
    compare("Cushioned cylinder", cylinder_plan(has_cushions=True), 0.01, size)
    compare_watch(size)


if __name__ == "__main__":
    main()
