"""Independent simulations of rotary actuators, grippers and boosters, by NumPy and SciPy only: no code of `poppet`.

The flow law is that of ISO 6358, the gas is air with constant heat capacities, and walls are adiabatic.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp

GAS, KAPPA, DENSITY, WARM = 287.05, 1.4, 1.185, 293.15


def mass_flow(first, second, conductance, ratio):
    """Return mass flow and its upstream temperature between two states (pressure, temperature), positive from first."""
    (high, warm), (low, _) = (first, second) if first[0] >= second[0] else (second, first)
    x = low / high
    subsonic = 1.0 if x <= ratio else math.sqrt(max(1.0 - ((x - ratio) / (1.0 - ratio)) ** 2, 0.0))
    flow = conductance * high * DENSITY * math.sqrt(293.15 / warm) * subsonic
    return (flow, warm) if first[0] >= second[0] else (-flow, warm)


def gas(mass, energy, volume):
    """Return pressure and temperature of gas with a mass and an internal energy in a volume."""
    pressure = (KAPPA - 1.0) * energy / volume
    return pressure, pressure * volume / (mass * GAS)


def swing(law, times):
    """Return angle, speed and the pressures of both chambers of a rotary actuator, (4, n), at the given times.

    The forward chamber is filled from a supply, the backward chamber is vented. `law` has the displacement D, the
    swivel angle, the dead volume, the inertia J, the viscous coefficient d, the load torque M, the supply p and the
    conductance C and the ratio b of both ports.
    """

    def volumes(angle):
        return law["V"] + law["D"] * angle, law["V"] + law["D"] * (law["swivel"] - angle)

    def rates(_, y):
        angle, speed, m1, e1, m2, e2 = y
        v1, v2 = volumes(angle)
        one, two = gas(m1, e1, v1), gas(m2, e2, v2)
        q1, t1 = mass_flow((law["p"], WARM), one, law["C"], law["b"])
        q2, t2 = mass_flow(two, (1e5, WARM), law["C"], law["b"])
        torque = law["D"] * (one[0] - two[0]) - law["d"] * speed - law["M"]
        heat = KAPPA / (KAPPA - 1.0) * GAS
        work1, work2 = -one[0] * law["D"] * speed, two[0] * law["D"] * speed
        return [speed, torque / law["J"], q1, heat * t1 * q1 + work1, -q2, -heat * t2 * q2 + work2]

    start = [0.5, 0.0]
    for volume in volumes(start[0]):
        start += [1e5 * volume / (GAS * WARM), 1e5 * volume / (KAPPA - 1.0)]
    solution = solve_ivp(rates, (0.0, times[-1]), start, "LSODA", times, rtol=1e-9, atol=1e-12, max_step=1e-3)
    angle, speed, _, e1, _, e2 = solution.y
    v1, v2 = volumes(angle)
    return np.array([angle, speed, (KAPPA - 1.0) * e1 / v1, (KAPPA - 1.0) * e2 / v2])
