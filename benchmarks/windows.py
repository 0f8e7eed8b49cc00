"""Time of the fit of one window, against a fit of `poppet identify` to the same data.

The window contains 60 s of a tank with valve, consumer and leak at 10 Hz. Free are the two states at its start, and two
or six numbers: leak and valve, or also consumer, wall, supply pressure and supply temperature. The window has an
arrival prior. The other fit has the same free numbers with the same priors, a free initial pressure and a free initial
temperature, no restarts, and prepared runs. Both are timed in turn, without reading of files. Times are processor time.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import poppet
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.search import SearchSettings, optimise
from poppet.identify.free_parameter import read_free
from poppet.monitoring.plan import WatchPlan, read_plan
from poppet.monitoring.window_model import Samples
from poppet.monitoring.windows import Arrival, Window
from poppet.signals import Steps
from poppet.timeseries.measurements import Channel, Measurement

NOISE, INTERVAL, LEAK = 500.0, 0.1, 1e-10
CIRCUIT = f"""
[parts.supply]
kind = "reservoir"
pressure = "7 bar g"
[parts.valve]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = 1e-8
critical_ratio = 0.3
opening = 0
[parts.tank]
kind = "chamber"
volume = "10 l"
initial_pressure = 5.5e5
wall_conductance = 2.0
[parts.consumer]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = 6e-9
critical_ratio = 0.35
opening = 0
[parts.leak]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = {LEAK}
critical_ratio = 0.3
"""
NUISANCES = {
    "valve.sonic_conductance": {"relative_sigma": 0.05},
    "consumer.sonic_conductance": {"relative_sigma": 0.05},
    "tank.wall_conductance": {"relative_sigma": 0.3},
    "supply.pressure": {"sigma": "10 kPa"},
    "supply.temperature": {"sigma": "10 K"},
}


def recording(samples: int) -> Samples:
    """Readings of the tank, and openings of valve and consumer that change every 2 s."""
    generator = np.random.default_rng(3)
    levels = generator.uniform(0.0, 1.0, (samples // 20 + 1, 2)).repeat(20, axis=0)[:samples]
    times = INTERVAL * np.arange(samples, dtype=np.float64)
    signals = {"valve.opening": Steps(times, levels[:, 0]), "consumer.opening": Steps(times, levels[:, 1])}
    run = poppet.loads(CIRCUIT).with_signals(signals).simulate(times[-1], INTERVAL, 1e-9)
    readings = run["tank.pressure"][:samples] + generator.normal(0.0, NOISE, samples)
    return Samples(times, readings[:, None], levels)


def plan_of(count: int) -> WatchPlan:
    """Plan with the leak and the first nuisances, `count` free numbers in total."""
    measured = {"tank.pressure": {"noise": NOISE}, "valve.opening": {}, "consumer.opening": {}}
    faults = {"leak": {"address": "leak.sonic_conductance", "alarm": 1e-10}}
    nuisances = {name: NUISANCES[name] for name in list(NUISANCES)[: count - 1]}
    return read_plan(poppet.loads(CIRCUIT), measured, faults, nuisances)


def window_fit(plan: WatchPlan, samples: Samples) -> Callable[[], np.ndarray]:
    """Function that fits the window and returns the leak and its standard deviation."""
    window = Window(plan)
    state = plan.instance.start()[0][: window.model.n_states]
    spread = np.append([2e3, 0.01 * state[1]], plan.prior)
    arrival = Arrival(0.0, np.append(state, plan.reference), np.diag(spread**2))

    def fit() -> np.ndarray:
        result = window.fit(samples, arrival)
        return np.array([result.theta[0], result.sigmas[0]])

    return fit


def identify_fit(plan: WatchPlan, samples: Samples) -> Callable[[], np.ndarray]:
    """Function that fits the same data like `poppet identify`, and returns the leak."""
    columns = zip(("valve.opening", "consumer.opening"), samples.inputs.T, strict=True)
    circuit = plan.circuit.with_signals({name: Steps(samples.times, values) for name, values in columns})
    channel = Channel("tank.pressure", samples.times, samples.readings[:, 0], "Pa", NOISE)
    measurement = Measurement("window", (channel,), duration=float(samples.times[-1]))
    tables: dict[str, Any] = {
        "tank.initial_pressure": {"start": "5.5 bar"},
        "tank.initial_temperature": {"start": "20 degC"},
    }
    for address, value, sigma in zip(plan.free.addresses, plan.reference, plan.prior, strict=True):
        tables[address] = {"start": float(value), "prior": {"mean": float(value), "sd": float(sigma)}}
    free = tuple(read_free(name, table, circuit) for name, table in tables.items())
    experiment = Experiment(circuit.instance, measurement, free)
    settings = SearchSettings(kicks=0)

    def fit() -> np.ndarray:
        experiment._last = None
        return optimise([experiment], free, settings).x[2:3]

    return fit


def main(size: float = 1.0) -> None:
    """Print the times of both fits; a smaller size has fewer samples and repetitions."""
    samples = recording(max(60, round(600 * size)) + 1)
    print(f"poppet {poppet.__version__}; window of {samples.times[-1]:.0f} s, {samples.times.size} samples")
    for count in (2, 6):
        plan = plan_of(count)
        fits = window_fit(plan, samples), identify_fit(plan, samples)
        results = [fit() for fit in fits]
        times: list[list[float]] = [[], []]
        for _ in range(max(3, round(40 * size))):
            for column, fit in zip(times, fits, strict=True):
                begin = time.process_time()
                fit()
                column.append(time.process_time() - begin)
        ours, theirs = (1e3 * statistics.median(column) for column in times)
        leak, sigma = results[0]
        apart = abs(results[1][0] - leak) / sigma
        print(f"  2 + {count} free: window {ours:.2f} ms (least {1e3 * min(times[0]):.2f}), ", end="")
        print(f"identify {theirs:.2f} ms, leak {leak / LEAK:.3f} +/- {sigma / LEAK:.3f} of the truth, ", end="")
        print(f"{apart:.2f} standard deviations apart")


if __name__ == "__main__":
    main()
