"""Readings of a tank with valve, consumer and leak, simulated by NumPy only: no code of `poppet`.

The flow law is the ellipse of ISO 6358 with the cubic near equal pressures that `docs/equations.md` states, the gas is
air with constant heat capacities, and the wall has a constant temperature. Many runs are simulated together with a
Runge-Kutta method of fixed step; all arrays have the runs along their first axis.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

GAS_CONSTANT, KAPPA = 287.05, 1.4
DENSITY_ANR, TEMPERATURE_ANR = 1.185, 293.15
SAMPLE_TIME = 0.1
SUBSTEPS = 4
"""Steps of the integration per sample."""
EQUAL = 1e-3
"""Relative pressure drop below which the cubic replaces the ellipse."""


@dataclass(frozen=True)
class Tank:
    """True parameters in SI units, absolute pressures; each is a number or one value per run."""

    volume: Any = 0.01
    wall_conductance: Any = 4.0
    wall_temperature: Any = 293.15
    supply_pressure: Any = 8e5
    supply_temperature: Any = 293.15
    barometer: Any = 1e5
    valve: Any = 1e-8
    valve_ratio: Any = 0.3
    use: Any = 8e-9
    use_ratio: Any = 0.35
    leak: Any = 2e-11
    leak_ratio: Any = 0.3
    initial_pressure: Any = 5.5e5
    initial_temperature: Any = 293.15


HEALTHY = Tank()
ONE_PERCENT = 0.01 * HEALTHY.valve
"""One per cent of the sonic conductance of the valve, the unit of leaks."""

CIRCUIT = f"""
[parts.supply]
kind = "reservoir"
pressure = {HEALTHY.supply_pressure}
temperature = {HEALTHY.supply_temperature}

[parts.valve]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = {HEALTHY.valve}
critical_ratio = {HEALTHY.valve_ratio}
opening = 0

[parts.tank]
kind = "chamber"
volume = {HEALTHY.volume}
wall_conductance = {HEALTHY.wall_conductance}
wall_temperature = {HEALTHY.wall_temperature}
initial_pressure = {HEALTHY.initial_pressure}
initial_temperature = {HEALTHY.initial_temperature}

[parts.use]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = {HEALTHY.use}
critical_ratio = {HEALTHY.use_ratio}
opening = 0

[parts.leak]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = {HEALTHY.leak}
critical_ratio = {HEALTHY.leak_ratio}

[ambient]
pressure = {HEALTHY.barometer}

[run]
duration = 10
"""
"""The same plant as a circuit file."""

ADDRESSES = {
    "volume": "tank.volume",
    "wall_conductance": "tank.wall_conductance",
    "wall_temperature": "tank.wall_temperature",
    "supply_pressure": "supply.pressure",
    "supply_temperature": "supply.temperature",
    "barometer": "ambient.pressure",
    "valve": "valve.sonic_conductance",
    "use": "use.sonic_conductance",
    "leak": "leak.sonic_conductance",
}
"""Address in the circuit file of each parameter that a fault or an error of the model changes."""

MODEL_ERRORS = {
    "volume +3 %": replace(HEALTHY, volume=1.03 * HEALTHY.volume),
    "supply gas +15 K": replace(HEALTHY, supply_temperature=HEALTHY.supply_temperature + 15.0),
    "gas and wall +15 K": replace(
        HEALTHY,
        supply_temperature=HEALTHY.supply_temperature + 15.0,
        wall_temperature=HEALTHY.wall_temperature + 15.0,
        initial_temperature=HEALTHY.initial_temperature + 15.0,
    ),
    "wall conductance twice": replace(HEALTHY, wall_conductance=2.0 * HEALTHY.wall_conductance),
    "valve C -5 %": replace(HEALTHY, valve=0.95 * HEALTHY.valve),
    "supply -10 kPa": replace(HEALTHY, supply_pressure=HEALTHY.supply_pressure - 1e4),
    "use C +3 %": replace(HEALTHY, use=1.03 * HEALTHY.use),
    "barometer +1.3 kPa": replace(HEALTHY, barometer=HEALTHY.barometer + 1.3e3),
}
"""Healthy plants that differ from the circuit file."""


def flow_and_temperature(
    first: tuple[Any, Any], second: tuple[Any, Any], conductance: Any, ratio: Any
) -> tuple[Array, Array]:
    """Return the mass flow rate from the first side and its upstream temperature.

    A side has pressure and temperature.
    """
    forward = first[0] >= second[0]
    upstream, warm = np.where(forward, first[0], second[0]), np.where(forward, first[1], second[1])
    drop = (first[0] - second[0]) / upstream  # signed
    edge = EQUAL / (1.0 - ratio)
    distance = np.clip(np.abs(drop) / (1.0 - ratio), edge, 1.0)  # from the closed state to choked flow
    z, slope = np.clip(drop / EQUAL, -1.0, 1.0), (1.0 - edge) / (2.0 - edge)
    fraction = np.sqrt(distance * (2.0 - distance)) * z * (1.0 + 0.5 * (1.0 - z * z) * (1.0 - slope))
    return conductance * DENSITY_ANR * upstream * np.sqrt(TEMPERATURE_ANR / warm) * fraction, warm


def paths(tank: Tank, runs: int) -> tuple[Array, ...]:
    """Return pressure, temperature, conductance and ratio of valve, consumer and leak at their other ends, (3, runs).

    The conductance of the leak is 1: its course is an input.
    """
    rows = (
        (tank.supply_pressure, tank.barometer, tank.barometer),
        (tank.supply_temperature, TEMPERATURE_ANR, TEMPERATURE_ANR),
        (tank.valve, tank.use, 1.0),
        (tank.valve_ratio, tank.use_ratio, tank.leak_ratio),
    )
    return tuple(np.array([np.broadcast_to(value, runs) for value in row], float) for row in rows)


def rates(tank: Tank, ends: tuple[Array, ...], state: Array, openings: Array) -> Array:
    """Return the time derivatives of pressure and temperature, (2, runs).

    `openings` are those of valve and consumer, and the conductance of the leak, (3, runs).
    """
    pressure, temperature = state
    outside_pressure, outside_temperature, conductance, ratio = ends
    outside = outside_pressure, outside_temperature
    flow, warm = flow_and_temperature(outside, (pressure, temperature), conductance * openings, ratio)
    heat = tank.wall_conductance * (tank.wall_temperature - temperature)
    rise = (KAPPA * GAS_CONSTANT * (flow * warm).sum(axis=0) + (KAPPA - 1.0) * heat) / tank.volume
    relative_growth = flow.sum(axis=0) * GAS_CONSTANT * temperature / (pressure * tank.volume)
    return np.array([rise, temperature * (rise / pressure - relative_growth)])


@dataclass(frozen=True)
class Course:
    """Truth at the samples: (runs, samples); openings and leaks hold from their sample to the next."""

    time: Array
    pressure: Array
    temperature: Array
    valve_flow: Array
    openings: Array
    leak: Array


def simulate(
    tank: Tank,
    openings: Array,
    leak: Array | None = None,
    *,
    supply: Array | None = None,
    control: Callable[[int, Array], Array] | None = None,
    substeps: int = SUBSTEPS,
) -> Course:
    """Simulate runs with the openings of valve and consumer, (runs, samples, 2), and the leak conductance.

    `leak` and the pressure of the supply are (runs, samples), by default those of the tank. `control` gets the index of
    the sample and the pressures, and returns the openings of the valve: a closed loop.
    """
    runs, samples, _ = openings.shape
    leak = np.broadcast_to(np.asarray(tank.leak, float).reshape(-1, 1), (runs, samples)) if leak is None else leak
    driven = np.ascontiguousarray(np.concatenate([openings, leak[:, :, None]], axis=2).transpose(1, 2, 0))
    state = np.empty((2, runs))
    state[:] = np.reshape(tank.initial_pressure, -1), np.reshape(tank.initial_temperature, -1)
    ends, step = paths(tank, runs), SAMPLE_TIME / substeps
    states = np.empty((samples, 2, runs))
    for k, now in enumerate(driven):
        states[k] = state
        if supply is not None:
            ends[0][0] = supply[:, k]
        if control is not None:
            now[0] = control(k, state[0])
        for _ in range(substeps):
            first = rates(tank, ends, state, now)
            second = rates(tank, ends, state + 0.5 * step * first, now)
            third = rates(tank, ends, state + 0.5 * step * second, now)
            fourth = rates(tank, ends, state + step * third, now)
            state = state + step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth)
    pressure, temperature = states[:, 0], states[:, 1]
    upstream = ends[0][0] if supply is None else supply.T
    conductance = ends[2][0] * driven[:, 0]
    flow, _ = flow_and_temperature((upstream, ends[1][0]), (pressure, temperature), conductance, ends[3][0])
    time = SAMPLE_TIME * np.arange(samples)
    return Course(time, pressure.T, temperature.T, flow.T, driven[:, :2].transpose(2, 0, 1), driven[:, 2].T)


# Inputs ---------------------------------------------------------------------------------------------------------------


def random_openings(seeds: range, samples: int, *, mean_dwell: float = 2.0) -> Array:
    """Return openings of valve and consumer, (runs, samples, 2): each is redrawn after random times.

    The valve is closed in 40 % of the intervals, the consumer in 25 %. Otherwise, the openings are uniform from 0.3
    to 1.
    """
    return np.array([_random_openings(np.random.default_rng([29, seed]), samples, mean_dwell) for seed in seeds])


def _random_openings(generator: np.random.Generator, samples: int, mean_dwell: float) -> Array:
    result = np.empty((samples, 2))
    for column, closed in ((0, 0.4), (1, 0.25)):
        k = 0
        while k < samples:
            dwell = 1 + int(generator.exponential(mean_dwell) / SAMPLE_TIME)
            result[k : k + dwell, column] = 0.0 if generator.random() < closed else generator.uniform(0.3, 1.0)
            k += dwell
    return result


def duty_openings(seeds: range, samples: int, *, period: float = 10.0, duty: float = 0.5) -> Array:
    """Return openings of valve and consumer: both open for a fraction of a period, the consumer with another phase."""
    time = SAMPLE_TIME * np.arange(samples)
    phase = np.array([np.random.default_rng([30, seed]).uniform(0.0, period, 2) for seed in seeds])
    return ((time[None, :, None] + phase[:, None, :]) % period < duty * period).astype(float)


def two_point(low: float, high: float, runs: int) -> Callable[[int, Array], Array]:
    """Return a controller that opens the valve below the pressure `low` and closes it above `high`."""
    opening = np.ones(runs)

    def control(_: int, pressure: Array) -> Array:
        opening[pressure < low] = 1.0
        opening[pressure > high] = 0.0
        return opening

    return control


def proportional_integral(
    setpoint: float, runs: int, *, gain: float = 1e-5, time: float = 10.0
) -> Callable[[int, Array], Array]:
    """Return a controller of the valve that hides a leak: it holds the pressure; gain [1/Pa] and integral time [s]."""
    total = np.zeros(runs)

    def control(_: int, pressure: Array) -> Array:
        error = setpoint - pressure
        opening = np.clip(gain * error + total, 0.0, 1.0)
        free = opening == gain * error + total  # no windup at the limits
        total[free] += gain * error[free] * SAMPLE_TIME / time
        return opening

    return control


def stepped_leak(healthy: float, faulty: float, start: float, runs: int, samples: int) -> Array:
    """Return leaks that change at a time [s]."""
    return np.tile(np.where(SAMPLE_TIME * np.arange(samples) >= start, faulty, healthy), (runs, 1))


def walking_leak(start: float, deviation: float, seeds: range, samples: int) -> Array:
    """Return leaks on a random walk, reflected at zero; `deviation` is the standard deviation after one second."""
    scale = deviation * SAMPLE_TIME**0.5
    steps = np.array([np.random.default_rng([31, seed]).normal(0.0, scale, samples) for seed in seeds])
    steps[:, 0] = 0.0
    return np.abs(start + np.cumsum(steps, axis=1))


# Readings -------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Sensors:
    """Errors of the readings; pressures in Pa, flows in kg/s."""

    noise: float = 500.0
    offset: float = 0.0
    is_gauge: bool = False
    resolution: float = 0.0
    outliers: float = 0.0
    outlier_size: float = 5e4
    missing: float = 0.0
    flow_noise: float | None = None
    """None without a flow sensor."""


def readings(tank: Tank, course: Course, sensors: Sensors, seeds: range) -> Array:
    """Return the readings of all runs, (runs, samples, channels), with NaN for missing samples."""
    return np.array([_readings(tank, course, sensors, run, seed) for run, seed in enumerate(seeds)])


def _readings(tank: Tank, course: Course, sensors: Sensors, run: int, seed: int) -> Array:
    generator = np.random.default_rng([32, seed])
    shape = course.time.shape
    barometer = float(np.broadcast_to(tank.barometer, course.pressure.shape[:1])[run]) if sensors.is_gauge else 0.0
    pressure = course.pressure[run] - barometer + sensors.offset + generator.normal(0.0, sensors.noise, shape)
    spikes = np.where(generator.random(shape) < 0.5, -1.0, 1.0) * sensors.outlier_size
    pressure += np.where(generator.random(shape) < sensors.outliers, spikes, 0.0)
    if sensors.resolution > 0.0:
        pressure = sensors.resolution * np.round(pressure / sensors.resolution)
    channels = [np.where(generator.random(shape) < sensors.missing, np.nan, pressure)]
    if sensors.flow_noise is not None:
        flow = course.valve_flow[run] + generator.normal(0.0, sensors.flow_noise, shape)
        channels.append(np.where(generator.random(shape) < sensors.missing, np.nan, flow))
    return np.stack(channels, axis=-1)
