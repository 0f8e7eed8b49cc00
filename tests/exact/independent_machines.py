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


def boost(law, end, step):
    """Return times, outlet pressure and times of reversal of a booster that fills a tank, until a time.

    Both pistons have one coordinate. At the distance `trip` from an end, the valve begins to move and needs the time T
    from one side to the other; its edges are proportional to the deviation from the middle. `law` has the areas A
    (drive) and B (boost), the stroke L, the dead volumes as a fraction f, the mass m, the viscous coefficient d, the
    contact stiffness k and its dissipation, the supply p, the tank volume V and the conductance C and ratio b of all
    paths. The pistons start at position 0, all volumes with 1 bar.
    """
    area = np.array([law["A"], law["A"], law["B"], law["B"]])
    ambient, supply = (1e5, WARM), (law["p"], WARM)
    heat = KAPPA / (KAPPA - 1.0) * GAS

    def volumes(x):
        depth = np.array([x, law["L"] - x, x, law["L"] - x])
        return np.append(area * (depth + law["f"] * law["L"]), law["V"])

    def contact(depth, speed):
        s = law["dissipation"] * speed
        return law["k"] * max(depth, 0.0) ** 1.5 * (1.0 + s / math.sqrt(1.0 + s * s))

    def rates(t, y, start, target):
        x, speed, masses, energies = y[0], y[1], y[2:7], y[7:12]
        volume = volumes(x)
        states = [gas(*values) for values in zip(masses, energies, volume, strict=True)]
        moved = min((t - start) / law["T"], 1.0)
        position = moved if target else 1.0 - moved
        ahead, back = max(1.0 - 2.0 * position, 0.0), max(2.0 * position - 1.0, 0.0)
        mass_rates, energy_rates = np.zeros(5), np.zeros(5)

        def pipe(first, second, conductance, one_way=False):
            one, two = (states[end] if isinstance(end, int) else end for end in (first, second))
            flow, warm = mass_flow(one, two, conductance, law["b"])
            if one_way and flow < 0.0:
                return
            for node, sign in ((first, -1.0), (second, 1.0)):
                if isinstance(node, int):
                    mass_rates[node] += sign * flow
                    energy_rates[node] += sign * flow * heat * warm

        pipe(supply, 0, law["C"] * ahead)
        pipe(1, ambient, law["C"] * ahead)
        pipe(supply, 1, law["C"] * back)
        pipe(0, ambient, law["C"] * back)
        for node in (2, 3):
            pipe(supply, node, law["C"], one_way=True)
            pipe(node, 4, law["C"], one_way=True)
        pressure = [state[0] for state in states]
        growth = np.append(area * np.array([1.0, -1.0, 1.0, -1.0]) * speed, 0.0)
        energy_rates -= pressure * growth
        force = law["A"] * (pressure[0] - pressure[1]) + law["B"] * (pressure[2] - pressure[3]) - law["d"] * speed
        force += contact(-x, -speed) - contact(x - law["L"], speed)
        return np.concatenate([[speed, force / law["m"]], mass_rates, energy_rates])

    volume = volumes(0.0)
    y = np.concatenate([[0.0, 0.0], 1e5 * volume / (GAS * WARM), 1e5 * volume / (KAPPA - 1.0)])
    now, start, target, reversals = 0.0, -1.0, 0, []
    times, outlet = [], []
    while now < end:
        limit = law["trip"] if target else law["L"] - law["trip"]

        def tripped(t, y, start, target, limit=limit):
            return y[0] - limit

        tripped.terminal, tripped.direction = True, -1.0 if target else 1.0
        grid = np.arange(0.0, end, step)
        solution = solve_ivp(
            rates, (now, end), y, "LSODA", grid[grid >= now], events=tripped,
            args=(start, target), rtol=1e-7, atol=1e-10, max_step=2e-3,
        )  # fmt: skip
        if len(solution.t):
            times.append(solution.t)
            outlet.append((KAPPA - 1.0) * solution.y[11] / law["V"])
        if not solution.t_events[0].size:
            break
        now, y = float(solution.t_events[0][0]), solution.y_events[0][0]
        start, target = now, 1 - target
        reversals.append(now)
    return np.concatenate(times), np.concatenate(outlet), np.array(reversals)
