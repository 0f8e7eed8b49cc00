"""Readings of a cylinder with a five-port valve and faults, by NumPy only (compiled if Numba is present).

No code of `poppet`. The laws are those of ISO 6358 (with the cubic near equal pressures that `docs/equations.md`
states), of an ideal gas with constant heat capacities, of Canudas de Wit and Olsson for sticking friction, and of Hunt
and Crossley for the ends of the stroke. A Runge-Kutta method of fixed step integrates.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

try:
    from numba import njit
except ImportError:  # the same numbers, two hundred times slower

    def njit(function: Any) -> Any:
        return function


Array = NDArray[np.float64]

GAS_CONSTANT, KAPPA = 287.05, 1.4
DENSITY_ANR, TEMPERATURE_ANR = 1.185, 293.15
SAMPLE_TIME, SUBSTEPS = 0.01, 100
CYCLE = 6.2
"""Duration of a cycle [s]."""
EQUAL = 1e-3
"""Relative pressure drop below which a cubic replaces the ellipse."""


class Cylinder(NamedTuple):
    """True parameters in SI units, absolute pressures."""

    supply_pressure: float = 7e5
    supply_temperature: float = 293.15
    barometer: float = 1e5
    filter: float = 1.5e-8
    rail_volume: float = 1e-4
    rail_wall: float = 0.5
    valve: float = 8e-9
    exhaust_a: float = 4e-9
    exhaust_b: float = 4e-9
    spool_leak: float = 8e-12
    ratio: float = 0.3
    lag: float = 0.015
    seal_leak: float = 1.6e-11
    leak_cap: float = 8e-12
    leak_rod: float = 8e-12
    bore: float = 0.032
    rod: float = 0.012
    stroke: float = 0.2
    dead_volume: float = 1.5e-5
    wall: float = 0.3
    wall_temperature: float = 293.15
    mass: float = 5.0
    load: float = 20.0
    coulomb: float = 40.0
    static: float = 40.0
    stribeck_velocity: float = 0.02
    viscous: float = 60.0
    bristle_stiffness: float = 1e6
    bristle_damping: float = 4000.0
    stop_stiffness: float = 1e8
    stop_dissipation: float = 5.0


HEALTHY = Cylinder()
ONE_PERCENT = 0.01 * HEALTHY.valve

CIRCUIT = f"""
[parts.supply]
kind = "reservoir"
pressure = {HEALTHY.supply_pressure}
temperature = {HEALTHY.supply_temperature}

[parts.filter]
kind = "orifice"
from = "supply"
to = "rail"
sonic_conductance = {HEALTHY.filter}
critical_ratio = {HEALTHY.ratio}

[parts.rail]
kind = "chamber"
volume = {HEALTHY.rail_volume}
wall_conductance = {HEALTHY.rail_wall}
wall_temperature = {HEALTHY.wall_temperature}
initial_pressure = {HEALTHY.supply_pressure}

[parts.valve]
kind = "spool_valve"
supply = "rail"
a = "cylinder.cap"
b = "cylinder.rod"
sonic_conductance = {HEALTHY.valve}
exhaust_a_conductance = {HEALTHY.exhaust_a}
exhaust_b_conductance = {HEALTHY.exhaust_b}
leak_conductance = {HEALTHY.spool_leak}
critical_ratio = {HEALTHY.ratio}
lag = {HEALTHY.lag}
command = -1

[parts.leak_cap]
kind = "orifice"
from = "cylinder.cap"
to = "ambient"
sonic_conductance = {HEALTHY.leak_cap}
critical_ratio = {HEALTHY.ratio}

[parts.leak_rod]
kind = "orifice"
from = "cylinder.rod"
to = "ambient"
sonic_conductance = {HEALTHY.leak_rod}
critical_ratio = {HEALTHY.ratio}

[parts.cylinder]
kind = "cylinder"
body = "slide"
bore = {HEALTHY.bore}
rod_diameter = {HEALTHY.rod}
stroke_length = {HEALTHY.stroke}
leakage = {{ sonic_conductance = {HEALTHY.seal_leak}, critical_ratio = {HEALTHY.ratio} }}
end_stop = {{ stiffness = {HEALTHY.stop_stiffness}, dissipation = {HEALTHY.stop_dissipation} }}

[parts.cylinder.cap]
dead_volume = {HEALTHY.dead_volume}
wall_conductance = {HEALTHY.wall}
wall_temperature = {HEALTHY.wall_temperature}
initial_pressure = {HEALTHY.barometer}

[parts.cylinder.rod]
dead_volume = {HEALTHY.dead_volume}
wall_conductance = {HEALTHY.wall}
wall_temperature = {HEALTHY.wall_temperature}
initial_pressure = {HEALTHY.supply_pressure}

[parts.slide]
kind = "mass"
mass = {HEALTHY.mass}
load_force = {HEALTHY.load}

[parts.slide.friction]
kind = "lugre"
coulomb_force = {HEALTHY.coulomb}
stribeck_velocity = {HEALTHY.stribeck_velocity}
viscous_coefficient = {HEALTHY.viscous}
bristle_stiffness = {HEALTHY.bristle_stiffness}
bristle_damping = {HEALTHY.bristle_damping}

[ambient]
pressure = {HEALTHY.barometer}

[run]
duration = {CYCLE}
output_step = {SAMPLE_TIME}
"""
"""The same machine as a circuit file. The static friction is the Coulomb friction."""


@dataclass(frozen=True)
class Fault:
    """A fault with its address in the circuit file and its unit in SI; the sign is its direction."""

    address: str
    unit: float
    names: tuple[str, ...]
    """Parameters that it changes by the unit."""

    def plant(self, size: float, healthy: Cylinder = HEALTHY) -> Cylinder:
        """Return a cylinder with a fault of some units."""
        return healthy._replace(**{name: getattr(healthy, name) + size * self.unit for name in self.names})


FAULTS = {
    "seal_leak": Fault("cylinder.leakage.sonic_conductance", ONE_PERCENT, ("seal_leak",)),
    "spool_leak": Fault("valve.leak_conductance", ONE_PERCENT, ("spool_leak",)),
    "leak_cap": Fault("leak_cap.sonic_conductance", ONE_PERCENT, ("leak_cap",)),
    "leak_rod": Fault("leak_rod.sonic_conductance", ONE_PERCENT, ("leak_rod",)),
    "filter_clogged": Fault("filter.sonic_conductance", -0.01 * HEALTHY.filter, ("filter",)),
    "valve_worn": Fault("valve.sonic_conductance", -ONE_PERCENT, ("valve",)),
    "silencer_a_clogged": Fault("valve.exhaust_a_conductance", -0.01 * HEALTHY.exhaust_a, ("exhaust_a",)),
    "silencer_b_clogged": Fault("valve.exhaust_b_conductance", -0.01 * HEALTHY.exhaust_b, ("exhaust_b",)),
    "valve_slow": Fault("valve.lag", 1e-3, ("lag",)),
    "coulomb_friction": Fault("slide.friction.coulomb_force", 0.1 * HEALTHY.coulomb, ("coulomb", "static")),
    "viscous_friction": Fault("slide.friction.viscous_coefficient", 0.1 * HEALTHY.viscous, ("viscous",)),
    "load": Fault("slide.load_force", 4.0, ("load",)),
    "mass": Fault("slide.mass", 0.1 * HEALTHY.mass, ("mass",)),
    "supply_low": Fault("supply.pressure", -7e3, ("supply_pressure",)),
}
"""Faults that parameters of the circuit file express.

The units are 1 % of a conductance (leaks: of that of the valve), 1 ms, 10 % of friction and mass, 4 N and 7 kPa."""

CHANNELS = {
    "cap": "cylinder.cap.pressure",
    "rod": "cylinder.rod.pressure",
    "position": "slide.position",
    "rail": "rail.pressure",
    "flow": "filter.mass_flow_rate",
}
"""Sensors with their addresses in the circuit file."""


# Laws -----------------------------------------------------------------------------------------------------------------


@njit
def flow(p_1, t_1, p_2, t_2, conductance, ratio):
    """Return the mass flow rate from side 1 to side 2, and its upstream temperature."""
    forward = p_1 >= p_2
    upstream, warm = (p_1, t_1) if forward else (p_2, t_2)
    drop = abs(p_1 - p_2) / upstream
    distance = min(max(drop, EQUAL) / (1.0 - ratio), 1.0)  # from the closed state to choked flow
    fraction = math.sqrt(distance * (2.0 - distance))
    if drop < EQUAL:
        edge, z = EQUAL / (1.0 - ratio), drop / EQUAL
        fraction *= z * (1.0 + 0.5 * (1.0 - z * z) * (1.0 - (1.0 - edge) / (2.0 - edge)))
    result = conductance * DENSITY_ANR * upstream * math.sqrt(TEMPERATURE_ANR / warm) * fraction
    return (result if forward else -result), warm


@njit
def contact(depth, speed, stiffness, dissipation):
    """Return the force of an end of the stroke on the piston."""
    if depth <= 0.0:
        return 0.0
    s = dissipation * speed
    return stiffness * depth**1.5 * (1.0 + s / math.sqrt(1.0 + s * s))


@njit
def rates(y, command, c, out):
    """Write the time derivatives of the ten states to `out`.

    The states are mass and energy of the gas in the rail, at the cap and at the rod, the position, the speed, the
    deflection of the seals, and the position of the spool.
    """
    x, v, z, spool = y[6], y[7], y[8], y[9]
    area = 0.25 * math.pi * c.bore**2
    ring = area - 0.25 * math.pi * c.rod**2
    v_cap, v_rod = c.dead_volume + area * x, c.dead_volume + ring * (c.stroke - x)
    p_r, t_r = (KAPPA - 1.0) * y[1] / c.rail_volume, (KAPPA - 1.0) * y[1] / (y[0] * GAS_CONSTANT)
    p_a, t_a = (KAPPA - 1.0) * y[3] / v_cap, (KAPPA - 1.0) * y[3] / (y[2] * GAS_CONSTANT)
    p_b, t_b = (KAPPA - 1.0) * y[5] / v_rod, (KAPPA - 1.0) * y[5] / (y[4] * GAS_CONSTANT)
    leak, plus, minus = c.spool_leak, max(spool, 0.0), max(-spool, 0.0)
    q_s, t_s = flow(c.supply_pressure, c.supply_temperature, p_r, t_r, c.filter, c.ratio)
    q_ra, t_ra = flow(p_r, t_r, p_a, t_a, leak + (c.valve - leak) * plus, c.ratio)
    q_rb, t_rb = flow(p_r, t_r, p_b, t_b, leak + (c.valve - leak) * minus, c.ratio)
    out_a = leak + (c.exhaust_a - leak) * minus + c.leak_cap  # both end in the ambient
    out_b = leak + (c.exhaust_b - leak) * plus + c.leak_rod
    q_ae, t_ae = flow(p_a, t_a, c.barometer, TEMPERATURE_ANR, out_a, c.ratio)
    q_be, t_be = flow(p_b, t_b, c.barometer, TEMPERATURE_ANR, out_b, c.ratio)
    q_ab, t_ab = flow(p_a, t_a, p_b, t_b, c.seal_leak, c.ratio)
    heat = KAPPA * GAS_CONSTANT / (KAPPA - 1.0)
    out[0] = q_s - q_ra - q_rb
    out[1] = heat * (q_s * t_s - q_ra * t_ra - q_rb * t_rb) + c.rail_wall * (c.wall_temperature - t_r)
    out[2] = q_ra - q_ae - q_ab
    out[3] = heat * (q_ra * t_ra - q_ae * t_ae - q_ab * t_ab) + c.wall * (c.wall_temperature - t_a) - p_a * area * v
    out[4] = q_rb - q_be + q_ab
    out[5] = heat * (q_rb * t_rb - q_be * t_be + q_ab * t_ab) + c.wall * (c.wall_temperature - t_b) + p_b * ring * v
    fading = math.exp(-((v / c.stribeck_velocity) ** 2))
    deflection_rate = v - c.bristle_stiffness * abs(v) / (c.coulomb + (c.static - c.coulomb) * fading) * z
    friction = c.bristle_stiffness * z + c.bristle_damping * fading * deflection_rate + c.viscous * v
    stops = contact(-x, -v, c.stop_stiffness, c.stop_dissipation)
    stops -= contact(x - c.stroke, v, c.stop_stiffness, c.stop_dissipation)
    force = p_a * area - p_b * ring - c.barometer * (area - ring)
    out[6], out[7], out[8] = v, (force + stops - friction - c.load) / c.mass, deflection_rate
    out[9] = (command - spool) / c.lag


@njit
def integrate(y, commands, c, substeps, states):
    """Write the states at the beginning of each sample to `states`; `y` is advanced to the end of the last one."""
    step = SAMPLE_TIME / substeps
    n = y.size
    first, second, third, fourth = np.empty(n), np.empty(n), np.empty(n), np.empty(n)
    for k in range(commands.size):
        states[k] = y
        for _ in range(substeps):
            rates(y, commands[k], c, first)
            rates(y + 0.5 * step * first, commands[k], c, second)
            rates(y + 0.5 * step * second, commands[k], c, third)
            rates(y + step * third, commands[k], c, fourth)
            for i in range(n):
                y[i] += step / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i])


def start_state(
    plant: Cylinder, barometer: float = HEALTHY.barometer, supply: float = HEALTHY.supply_pressure
) -> Array:
    """Return the states at rest at the cap: the rod side is filled, the cap side is vented."""
    area = 0.25 * math.pi * plant.bore**2
    ring = area - 0.25 * math.pi * plant.rod**2
    volumes = plant.rail_volume, plant.dead_volume, plant.dead_volume + ring * plant.stroke
    pressures = supply, barometer, supply
    gas: list[float] = []
    for volume, pressure in zip(volumes, pressures, strict=True):
        gas += [pressure * volume / (GAS_CONSTANT * TEMPERATURE_ANR), pressure * volume / (KAPPA - 1.0)]
    return np.array([*gas, 0.0, 0.0, 0.0, -1.0])


# Runs -----------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Course:
    """Truth at the samples; a command holds from its sample to the next."""

    time: Array
    command: Array
    states: Array
    """(samples, 10), in the order of `rates`."""
    channels: dict[str, Array] = field(repr=False)


def simulate(
    plant: Cylinder,
    commands: Array,
    *,
    change: tuple[float, Cylinder] | None = None,
    courses: dict[str, Array] | None = None,
    control: Callable[[int, dict[str, float]], float] | None = None,
    substeps: int = SUBSTEPS,
) -> Course:
    """Simulate a run with commands of the spool from -1 to 1, one per sample.

    `change` is a time and the plant from then on. `courses` are parameters by name with one value per sample. `control`
    gets the index of the sample and the values of all sensors without errors, and returns the command: a closed loop.
    """
    samples = commands.size
    commands, states, y = commands.astype(float), np.empty((samples, 10)), start_state(plant)
    turn = samples if change is None else min(samples, round(change[0] / SAMPLE_TIME))
    pieces = [(0, turn), (turn, samples)]
    if courses or control:
        pieces = [(k, k + 1) for k in range(samples)]
    flows = np.empty(samples)
    for first, last in pieces:
        now = plant if first < turn or change is None else change[1]
        if courses:
            now = now._replace(**{name: float(values[first]) for name, values in courses.items()})
        if control is not None:
            values = {name: float(values[0]) for name, values in channels(now, y[None, :]).items()}
            commands[first] = control(first, values)
        integrate(y, commands[first:last], now, substeps, states[first:last])
        flows[first:last] = channels(now, states[first:last])["flow"]
    result = channels(plant, states) | {"flow": flows}
    return Course(SAMPLE_TIME * np.arange(samples), commands, states, result)


def channels(plant: Cylinder, states: Array) -> dict[str, Array]:
    """Return the values of all sensors without errors."""
    area = 0.25 * math.pi * plant.bore**2
    ring = area - 0.25 * math.pi * plant.rod**2
    x = states[:, 6]
    rail = (KAPPA - 1.0) * states[:, 1] / plant.rail_volume
    warm = (KAPPA - 1.0) * states[:, 1] / (states[:, 0] * GAS_CONSTANT)
    supply = plant.supply_pressure, plant.supply_temperature
    return {
        "cap": (KAPPA - 1.0) * states[:, 3] / (plant.dead_volume + area * x),
        "rod": (KAPPA - 1.0) * states[:, 5] / (plant.dead_volume + ring * (plant.stroke - x)),
        "position": x.copy(),
        "rail": rail,
        "flow": np.array([flow(*supply, p, t, plant.filter, plant.ratio)[0] for p, t in zip(rail, warm, strict=True)]),
    }


# Inputs ---------------------------------------------------------------------------------------------------------------


def cycles(count: int, *, seed: int | None = None) -> Array:
    """Return commands of cycles of 6.2 s: out from 0.1 s, back from 3.1 s; with a seed, both times vary by 0.1 s."""
    per_cycle = round(CYCLE / SAMPLE_TIME)
    result = np.full(count * per_cycle, -1.0)
    generator = None if seed is None else np.random.default_rng([33, seed])
    for cycle in range(count):
        shifts = (0, 0) if generator is None else generator.integers(-10, 11, 2)
        begin = cycle * per_cycle
        result[begin + 20 + shifts[0] : begin + 310 + shifts[1]] = 1.0
    return result


def varied(
    count: int, seed: int, plant: Cylinder = HEALTHY, *, supply: float = 0.005, load: float = 2.0
) -> dict[str, Array]:
    """Return courses of supply pressure and load that are redrawn in each cycle.

    `supply` is a relative standard deviation, `load` a standard deviation [N].
    """
    generator, per_cycle = np.random.default_rng([34, seed]), round(CYCLE / SAMPLE_TIME)
    pressures = plant.supply_pressure * (1.0 + supply * generator.normal(size=count))
    loads = plant.load + load * generator.normal(size=count)
    return {"supply_pressure": np.repeat(pressures, per_cycle), "load": np.repeat(loads, per_cycle)}


def position_loop(
    setpoint: Callable[[float], float], *, gain: float = 20.0
) -> Callable[[int, dict[str, float]], float]:
    """Return a proportional controller of the position; gain in 1/m."""
    return lambda k, values: min(max(gain * (setpoint(k * SAMPLE_TIME) - values["position"]), -1.0), 1.0)


def pressure_loop(
    setpoint: float, *, gain: float = 3e-6, time: float = 1.0
) -> Callable[[int, dict[str, float]], float]:
    """Return a controller that holds the pressure at the cap and hides a leak; gain [1/Pa] and integral time [s]."""
    total = 0.0

    def control(_: int, values: dict[str, float]) -> float:
        nonlocal total
        error = setpoint - values["cap"]
        command = min(max(gain * error + total, -1.0), 1.0)
        if command == gain * error + total:  # no windup at the limits
            total += gain * error * SAMPLE_TIME / time
        return command

    return control


# Readings -------------------------------------------------------------------------------------------------------------

NOISE = {"cap": 500.0, "rod": 500.0, "position": 5e-5, "rail": 500.0, "flow": 2e-5}
"""Standard deviations of the readings in SI units."""


@dataclass(frozen=True)
class Sensors:
    """Sensors and their errors, by name of the channel."""

    names: tuple[str, ...] = ("cap", "rod", "position")
    offsets: dict[str, float] = field(default_factory=dict)
    outliers: float = 0.0
    missing: float = 0.0


def readings(course: Course, sensors: Sensors, seed: int) -> Array:
    """Return absolute readings, (samples, channels), with NaN for missing samples; an outlier is off by 100 sigma."""
    generator, columns = np.random.default_rng([35, seed]), []
    for name in sensors.names:
        size = course.time.size
        shown = course.channels[name] + sensors.offsets.get(name, 0.0) + generator.normal(0.0, NOISE[name], size)
        signs = np.where(generator.random(size) < 0.5, -1.0, 1.0)
        shown += np.where(generator.random(size) < sensors.outliers, 100.0 * NOISE[name] * signs, 0.0)
        columns.append(np.where(generator.random(size) < sensors.missing, np.nan, shown))
    return np.stack(columns, axis=-1)
