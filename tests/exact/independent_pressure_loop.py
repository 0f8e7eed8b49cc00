"""Independent simulation of a sampled pressure loop: an isothermal tank, two valves and a leak (no code of poppet)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

GAS_CONSTANT, TEMPERATURE = 287.05, 293.15
DENSITY_ANR = 1e5 / (287.05 * 293.15)
"""Density at 100 kPa and 20 degC; the relative humidity has no effect here [kg/m^3]."""
AMBIENT = 1e5
SUBSTEPS = 16


@dataclass(frozen=True)
class SaggingSupply:
    """Case in which the supply sags while the setpoint is high, and the setpoint falls after a dwell."""

    volume: float  # [m^3]
    conductance: float  # of each valve [m^3/(s Pa)]
    leak: float  # conductance of the leak [m^3/(s Pa)]
    critical_ratio: float
    sagged: float  # supply pressure after the sag [Pa]
    target: float  # setpoint after the dwell [Pa]
    dwell: float  # [s]
    gain: float  # [1/Pa]
    integral_time: float  # [s]
    setpoint_weight: float
    sample_time: float  # [s]
    supply: float = 7e5
    setpoint: float = 6e5
    sag_time: float = 0.2


def draw_case(rng: np.random.Generator) -> SaggingSupply:
    """Draw a tank, valves and gains of a usual size: a crossover of 20 to 45 rad/s at 7 bar."""
    volume, conductance = 10 ** rng.uniform(-3.5, -2.5), 10 ** rng.uniform(-8.7, -8.1)
    rate = conductance * DENSITY_ANR * GAS_CONSTANT * TEMPERATURE * 7e5 / volume
    crossover, sagged = rng.uniform(20.0, 45.0), rng.uniform(2e5, 4e5)
    return SaggingSupply(
        volume, conductance, rng.uniform(0.02, 0.1) * conductance, rng.uniform(0.2, 0.5), sagged,
        sagged - rng.uniform(0.1e5, 0.6e5), rng.uniform(0.5, 4.0), crossover / rate, rng.uniform(2.0, 6.0) / crossover,
        float(rng.choice([0.0, 0.2, 0.4])), 2e-3,
    )  # fmt: skip


def flow(conductance: float, critical_ratio: float, upstream: float, downstream: float) -> float:
    """Mass flow rate of ISO 6358, negative for a reverse flow [kg/s]."""
    if upstream < downstream:
        return -flow(conductance, critical_ratio, downstream, upstream)
    excess = max(downstream / upstream - critical_ratio, 0.0) / (1.0 - critical_ratio)
    return conductance * DENSITY_ANR * upstream * math.sqrt(max(1.0 - excess**2, 0.0))


def closing_time(case: SaggingSupply, is_conditional: bool, duration: float = 1.5) -> float:
    """Time from the fall of the setpoint until the fill valve is closed [s].

    The law is a PI controller with back-calculation over its integral time. With `is_conditional`, the error moves the
    command at most to a margin beyond its limits.
    """
    time, pressure, origin, integral = case.sample_time, case.setpoint, case.setpoint, 0.0
    falls = case.sag_time + case.dwell
    for k in range(round((falls + duration) / time)):
        now = k * time
        setpoint = case.setpoint if now < falls - 1e-9 else case.target
        supply = case.supply if now < case.sag_time - 1e-9 else case.sagged
        error = setpoint - pressure
        wanted = case.gain * (error - (1.0 - case.setpoint_weight) * (setpoint - origin)) + integral
        command = min(max(wanted, -1.0), 1.0)
        if now >= falls - 1e-9 and command <= 0.0:
            return now - falls
        increment = case.gain * time / case.integral_time * error
        if is_conditional:
            margin = min(abs(increment), 0.1 * 2.0)
            increment = min(increment, max(1.0 + margin - wanted, 0.0)) if increment > 0.0 else increment
            increment = max(increment, min(-1.0 - margin - wanted, 0.0)) if increment < 0.0 else increment
        integral += increment + time / case.integral_time * (command - wanted)
        for _ in range(SUBSTEPS):
            fill = flow(case.conductance * max(command, 0.0), case.critical_ratio, supply, pressure)
            vent = flow(case.conductance * max(-command, 0.0) + case.leak, case.critical_ratio, pressure, AMBIENT)
            pressure += time / SUBSTEPS * GAS_CONSTANT * TEMPERATURE / case.volume * (fill - vent)
    return math.inf
