"""Batteries of `poppet watch`: many seeded runs of the independent tank and cylinder, and their scores."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from exact import independent_watch_cylinder as cylinder
from exact import independent_watch_tank as tank
from poppet import loads
from poppet.monitoring.baseline import Baseline
from poppet.monitoring.plan import WatchPlan, read_plan
from poppet.monitoring.samples import Sample
from poppet.monitoring.verdicts import VerdictKind
from poppet.monitoring.watch import Watch

Array = NDArray[np.float64]

TANK_TABLES: dict[str, dict[str, Any]] = {
    "measured": {
        "tank.pressure": {"column": "p", "unit": "Pa", "noise": 500.0},
        "valve.opening": {"column": "valve"},
        "use.opening": {"column": "use"},
    },
    "faults": {"leak": {"address": "leak.sonic_conductance", "direction": "up", "alarm": 0.3 * tank.ONE_PERCENT}},
    "nuisances": {
        "valve.sonic_conductance": {"relative_sigma": 0.05},
        "tank.wall_conductance": {"relative_sigma": 0.5},
        "use.sonic_conductance": {"relative_sigma": 0.05},
        "supply.pressure": {"sigma": 2e4},
        "supply.temperature": {"sigma": 15.0},
    },
    "settings": {"window": 60.0, "alarm_delay": 2.0},
}
"""Tables of the watch of the tank: one fault, and five nuisances."""
WALL = {"tank.wall_temperature": {"sigma": 10.0}}
"""Nuisance of plants whose surroundings are not at the temperature of the circuit file."""


class Alarm(NamedTuple):
    """Beginning of an alarm, or change of its names."""

    time: float
    names: tuple[str, ...]
    probabilities: Array
    """(f,)"""


@dataclass(frozen=True)
class Outcome:
    """Result of the watch of one run."""

    alarms: tuple[Alarm, ...]
    misfits: tuple[float, ...]
    """Times [s] at which the watch began to state that none of the hypotheses fits."""
    nis: Array
    """Normalised squared innovations per reading, (samples,)."""
    times: Array
    """Times of the estimates [s], one per second."""
    values: Array
    """Estimates of the fault numbers, (times, f)."""
    sigmas: Array
    free: Array
    """Estimates of all free numbers by the filter, (times, m)."""
    free_sigmas: Array
    names: tuple[str, ...]
    """Names of the alarm at the end."""

    @property
    def first(self) -> float:
        """Time of the first alarm [s], infinite without an alarm."""
        return self.alarms[0].time if self.alarms else np.inf


def watched(plan: WatchPlan, baseline: Baseline, time: Array, samples: Array) -> Outcome:
    """Return the outcome of the watch of one run; the columns of `samples` are sensors and inputs in SI units."""
    watch = Watch(plan, baseline)
    every = max(1, round(1.0 / (time[1] - time[0])))
    nis, alarms, misfits = np.full(time.size, np.nan), list[Alarm](), list[float]()
    estimates, free, n_states = list[Any](), list[Any](), len(plan.instance.model.states)
    verdict, names = watch.verdict, watch.alarms
    for k, row in enumerate(samples):
        watch.process(Sample(float(time[k]), row), [])
        if count := watch.running_filter.count:
            nis[k] = watch.running_filter.nis / count
        if k % every == 0:
            estimates.append(watch.fault_numbers())
            variances = np.diag(watch.running_filter.covariance)
            free.append((watch.running_filter.mean[n_states:].copy(), np.sqrt(variances[n_states:])))
        if watch.verdict is verdict:
            continue
        verdict = watch.verdict
        if verdict.kind is VerdictKind.NONE_FITS:
            misfits.append(float(time[k]))
        if watch.alarms != names:
            names = watch.alarms
            if names:
                alarms.append(Alarm(float(time[k]), names, watch.monitor.probabilities.copy()))
    columns = (array for pairs in (estimates, free) for array in np.array(pairs).transpose(1, 0, 2))
    return Outcome(tuple(alarms), tuple(misfits), nis, time[::every], *columns, watch.alarms)


# Tank -----------------------------------------------------------------------------------------------------------------


@cache
def tank_plan(has_wall: bool = True) -> WatchPlan:
    """Return the plan of the tank, with or without the wall temperature as a nuisance."""
    nuisances = TANK_TABLES["nuisances"] | (WALL if has_wall else {})
    return read_plan(loads(tank.CIRCUIT), **(TANK_TABLES | {"nuisances": nuisances}))


@cache
def gauge_plan(has_ambient: bool = True) -> WatchPlan:
    """Return the plan of a tank whose sensor is a gauge; the ambient pressure is a nuisance if `has_ambient`."""
    gauge = {"tank.pressure": {"column": "p", "unit": "bar g", "noise": "5 mbar"}}
    nuisances = TANK_TABLES["nuisances"] | ({"ambient.pressure": {"sigma": "15 mbar"}} if has_ambient else {})
    tables = TANK_TABLES | {"measured": TANK_TABLES["measured"] | gauge, "nuisances": nuisances}
    return read_plan(loads(tank.CIRCUIT), **tables)


def tank_outcomes(
    plant: tank.Tank,
    openings: Array,
    seeds: range,
    *,
    leak: Array | None = None,
    sensors: tank.Sensors = tank.Sensors(),  # noqa: B008
    control: Callable[[int, Array], Array] | None = None,
    plan: WatchPlan | None = None,
    baseline: Baseline | None = None,
) -> Iterator[Outcome]:
    """Yield the outcome of each run; `control` closes the loop of the valve."""
    plan = plan or tank_plan()
    course = tank.simulate(plant, openings, leak, control=control)
    shown = tank.readings(plant, course, sensors, seeds)
    for run in range(len(seeds)):
        pressure = shown[run, :, :1] + (plan.instance.surroundings.pressure if sensors.is_gauge else 0.0)
        samples = np.concatenate([pressure, course.openings[run]], axis=1)
        yield watched(plan, baseline or Baseline.of_circuit(plan), course.time, samples)


def drawn_tanks(seeds: range) -> tank.Tank:
    """Return tanks whose nuisances are drawn from the distributions in the plan."""
    draws = np.array([np.random.default_rng([37, seed]).normal(size=5) for seed in seeds])
    healthy = tank.HEALTHY
    return replace(
        healthy,
        valve=healthy.valve * (1.0 + 0.05 * draws[:, 0]),
        wall_conductance=np.maximum(healthy.wall_conductance * (1.0 + 0.5 * draws[:, 1]), 0.0),
        use=healthy.use * (1.0 + 0.05 * draws[:, 2]),
        supply_pressure=healthy.supply_pressure + 2e4 * draws[:, 3],
        supply_temperature=healthy.supply_temperature + 15.0 * draws[:, 4],
    )


@dataclass(frozen=True)
class Detection:
    """Scores of runs with a fault that begins at a time."""

    delays: Array
    """Times from the fault to its alarm [s], infinite if it was not found."""
    early: int
    """Number of runs with an alarm before the fault."""
    sizes: Array
    """Estimates of the fault number at the end of each run, as changes from the baseline."""


def leak_steps(
    size: float, seeds: range, *, start: float = 150.0, duration: float = 300.0, duty: bool = False, **options: Any
) -> Detection:
    """Return the scores of leaks that begin at a time; size in per cent of the conductance of the valve."""
    samples = round(duration / tank.SAMPLE_TIME)
    openings = (tank.duty_openings if duty else tank.random_openings)(seeds, samples)
    healthy = tank.HEALTHY.leak
    leak = tank.stepped_leak(healthy, healthy + size * tank.ONE_PERCENT, start, len(seeds), samples)
    outcomes = list(tank_outcomes(tank.HEALTHY, openings, seeds, leak=leak, **options))
    first = [next((alarm.time for alarm in o.alarms if alarm.time >= start), np.inf) for o in outcomes]
    return Detection(
        np.array(first) - start,
        sum(o.first < start for o in outcomes),
        np.array([o.values[-1, 0] - healthy for o in outcomes]),
    )


def healthy_runs(batch: int, runs: int, duration: float, **options: Any) -> Iterator[Outcome]:
    """Yield the outcomes of a batch of healthy runs: even batches have random inputs, odd ones duty cycles."""
    seeds = range(1000 + batch * runs, 1000 + (batch + 1) * runs)
    openings = (tank.duty_openings if batch % 2 else tank.random_openings)(seeds, round(duration / tank.SAMPLE_TIME))
    return tank_outcomes(tank.HEALTHY, openings, seeds, **options)


def silent_runs(sensors: tank.Sensors, seeds: range, duration: float) -> list[Outcome]:
    """Return the outcomes of healthy runs with other errors of the readings."""
    openings = tank.random_openings(seeds, round(duration / tank.SAMPLE_TIME))
    return list(tank_outcomes(tank.HEALTHY, openings, seeds, sensors=sensors))


def masked_leaks(size: float, seeds: range, duration: float = 300.0, start: float = 150.0) -> list[Outcome]:
    """Return the outcomes of leaks that a controller of the pressure hides; size in per cent, 0 for a healthy plant."""
    samples = round(duration / tank.SAMPLE_TIME)
    healthy = tank.HEALTHY.leak
    leak = tank.stepped_leak(healthy, healthy + size * tank.ONE_PERCENT, start, len(seeds), samples)
    control = tank.proportional_integral(5.5e5, len(seeds))
    openings = tank.random_openings(seeds, samples)
    return list(tank_outcomes(tank.HEALTHY, openings, seeds, leak=leak, control=control))


def model_errors(
    names: Sequence[str], seeds: range, *, duration: float = 300.0, duty: bool = False, **options: Any
) -> dict[str, list[Outcome]]:
    """Return the outcomes of healthy plants that differ from the circuit file."""
    samples = round(duration / tank.SAMPLE_TIME)
    openings = (tank.duty_openings if duty else tank.random_openings)(seeds, samples)
    return {name: list(tank_outcomes(tank.MODEL_ERRORS[name], openings, seeds, **options)) for name in names}


# Bands of the sizes ---------------------------------------------------------------------------------------------------

BAND_FAULTS = {
    "leak": {"address": "leak.sonic_conductance", "direction": "up", "alarm": 0.5 * tank.ONE_PERCENT},
    "clogged": {"address": "valve.sonic_conductance", "direction": "down", "alarm": 3.0 * tank.ONE_PERCENT},
    "supply_low": {"address": "supply.pressure", "direction": "down", "alarm": 1e4},
}
"""Faults of the tank whose sizes are compared with their standard deviations."""


@cache
def bands_plan() -> WatchPlan:
    """Return the plan of a tank with three faults and three nuisances."""
    nuisances = {
        "tank.wall_conductance": {"relative_sigma": 0.3},
        "use.sonic_conductance": {"relative_sigma": 0.05},
        "supply.temperature": {"sigma": 10.0},
    }
    return read_plan(loads(tank.CIRCUIT), **(TANK_TABLES | {"faults": BAND_FAULTS, "nuisances": nuisances}))


@dataclass(frozen=True)
class Bands:
    """Sizes of all faults in one run with one fault."""

    outcome: Outcome
    errors: Array
    """Errors in standard deviations, (times, f)."""

    @property
    def in_alarm(self) -> Array:
        """Errors after the first alarm, (times, f)."""
        return self.errors[self.outcome.times > self.outcome.first]


BAND_UNITS = {"leak": tank.ONE_PERCENT, "clogged": tank.ONE_PERCENT, "supply_low": 1e5}
"""Units of the sizes: per cent of the conductance of the valve, and bar."""


def bands(
    fault: str, size: float, seeds: range, *, start: float = 120.0, growth: float = 0.0, duration: float = 240.0
) -> list[Bands]:
    """Return the errors of all sizes in runs with a fault that begins at a time and grows for a time [s].

    The size is in per cent of the conductance of the valve, or in bar.
    """
    time = tank.SAMPLE_TIME * np.arange(round(duration / tank.SAMPLE_TIME))
    course = np.clip((time - start) / growth, 0.0, 1.0) if growth else (time >= start).astype(float)
    return faulty_tanks({fault: course * size}, seeds)


def successive_faults(
    sizes: Mapping[str, float], seeds: range, *, starts: Sequence[float] = (120.0, 220.0), duration: float = 400.0
) -> list[Bands]:
    """Return the errors of all sizes in runs with several faults that begin at different times [s] and remain."""
    time = tank.SAMPLE_TIME * np.arange(round(duration / tank.SAMPLE_TIME))
    cases = zip(sizes.items(), starts, strict=True)
    return faulty_tanks({fault: (time >= start) * size for (fault, size), start in cases}, seeds)


def faulty_tanks(changes: Mapping[str, Array], seeds: range) -> list[Bands]:
    """Return the errors of all sizes in runs with the changes of some faults, (samples,) each."""
    healthy, names = tank.HEALTHY, list(BAND_FAULTS)
    samples = next(iter(changes.values())).size
    none = np.zeros(samples)
    change = np.stack([changes.get(name, none) * BAND_UNITS[name] for name in names], axis=1)
    truth = np.array([healthy.leak, healthy.valve, healthy.supply_pressure]) + change
    commands = tank.random_openings(seeds, samples)
    openings = commands.copy()
    openings[:, :, 0] *= 1.0 + change[:, names.index("clogged")] / healthy.valve
    leak, supply = (np.tile(truth[:, names.index(name)], (len(seeds), 1)) for name in ("leak", "supply_low"))
    simulated = tank.simulate(healthy, openings, leak, supply=supply)
    shown = tank.readings(healthy, simulated, tank.Sensors(), seeds)
    plan, time, results = bands_plan(), tank.SAMPLE_TIME * np.arange(samples), []
    for run in range(len(seeds)):
        table = np.concatenate([shown[run], commands[run]], axis=1)
        outcome = watched(plan, Baseline.of_circuit(plan), time, table)
        errors = (outcome.values - truth[:: round(1.0 / tank.SAMPLE_TIME)]) / outcome.sigmas
        results.append(Bands(outcome, errors))
    return results


# Cylinder -------------------------------------------------------------------------------------------------------------

NUISANCES = {"supply.pressure": {"sigma": 3.5e3}, "slide.load_force": {"sigma": 2.0}}
"""Nuisances of the cylinder: supply and load are no faults in its batteries."""
NAMES = tuple(name for name, fault in cylinder.FAULTS.items() if fault.address not in NUISANCES)
HEALTHY_CYCLES = 4


@cache
def cylinder_plan(names: tuple[str, ...] = NAMES, sensors: tuple[str, ...] = ("cap", "rod", "position")) -> WatchPlan:
    """Return the plan of the cylinder with some of its faults; alarms begin at half a unit."""
    measured: dict[str, Any] = {
        cylinder.CHANNELS[name]: {"column": name, "noise": cylinder.NOISE[name]} for name in sensors
    }
    measured["valve.command"] = {"column": "u"}
    faults = {
        name: {
            "address": cylinder.FAULTS[name].address,
            "direction": "up" if cylinder.FAULTS[name].unit > 0.0 else "down",
            "alarm": 0.5 * abs(cylinder.FAULTS[name].unit),
        }
        for name in names
    }
    settings = {"window": 5.0 * cylinder.CYCLE, "alarm_delay": 2.0}
    return read_plan(loads(cylinder.CIRCUIT), measured, faults, NUISANCES, settings)


def cylinder_start(seed: int) -> float:
    """Return the time at which the faults of a run begin, within the cycle after the healthy ones [s]."""
    return float((HEALTHY_CYCLES + np.random.default_rng([36, seed]).uniform()) * cylinder.CYCLE)


def cylinder_run(
    faults: Mapping[str, float], seed: int, count: int = 10, *, varies: bool = False, **options: Any
) -> cylinder.Course:
    """Return a run whose faults, by name with their sizes in units, begin within the cycle after four healthy ones.

    Supply and load differ from the circuit file, by constants or, if `varies` is true, in each cycle. `options` are
    those of `cylinder.simulate`.
    """
    courses = cylinder.varied(count if varies else 1, seed)
    healthy = cylinder.HEALTHY
    if not varies:
        healthy, courses = healthy._replace(**{name: float(values[0]) for name, values in courses.items()}), {}
    faulty = healthy
    for name, size in faults.items():
        faulty = cylinder.FAULTS[name].plant(size, faulty)
    commands = cylinder.cycles(count, seed=seed)
    return cylinder.simulate(healthy, commands, change=(cylinder_start(seed), faulty), courses=courses, **options)


def cylinder_outcome(
    course: cylinder.Course,
    seed: int,
    *,
    plan: WatchPlan | None = None,
    baseline: Baseline | None = None,
    sensors: cylinder.Sensors = cylinder.Sensors(),  # noqa: B008
) -> Outcome:
    """Return the outcome of one run of the cylinder."""
    plan = plan or cylinder_plan()
    shown = cylinder.readings(course, sensors, seed)
    samples = np.concatenate([shown, course.command[:, None]], axis=1)
    return watched(plan, baseline or Baseline.of_circuit(plan), course.time, samples)


def percentiles(values: Array, levels: Sequence[float] = (50.0, 95.0)) -> list[float]:
    """Return percentiles, for which an infinite value is the largest."""
    ordered = np.sort(values)
    return [float(ordered[min(int(np.ceil(level / 100.0 * ordered.size)), ordered.size) - 1]) for level in levels]
