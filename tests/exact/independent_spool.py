"""Switched spool valves from the rules of a catalogue, without code of the package.

A spool moves at constant speed to the position that the commands select; gas follows the ellipse of ISO 6358.
"""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp

GAS, KAPPA, WARM, NORMAL_DENSITY = 287.05, 1.4, 293.15, 1.185
KNOTS = [-1.0, -0.5, 0.0, 0.5, 1.0]
CLOSED = {
    "supply_a": [0.0, 0.0, 0.0, 0.5, 1.0], "supply_b": [1.0, 0.5, 0.0, 0.0, 0.0],
    "exhaust_a": [1.0, 0.5, 0.0, 0.0, 0.0], "exhaust_b": [0.0, 0.0, 0.0, 0.5, 1.0],
}  # fmt: skip
OPENINGS = {
    "5/2 monostable": CLOSED, "5/2 bistable": CLOSED, "5/3 closed": CLOSED,
    "5/3 exhausted": {
        "supply_a": [0.0, 0.0, 0.0, 0.0, 1.0], "supply_b": [1.0, 0.0, 0.0, 0.0, 0.0],
        "exhaust_a": [1.0, 1.0, 1.0, 0.0, 0.0], "exhaust_b": [0.0, 0.0, 1.0, 1.0, 1.0],
    },
    "5/3 pressurised": {
        "supply_a": [0.0, 0.0, 1.0, 1.0, 1.0], "supply_b": [1.0, 1.0, 1.0, 0.0, 0.0],
        "exhaust_a": [1.0, 0.0, 0.0, 0.0, 0.0], "exhaust_b": [0.0, 0.0, 0.0, 0.0, 1.0],
    },
}  # fmt: skip
"""Openings of the edges at the positions `KNOTS`, linear between them."""


def selected_position(function: str, a: bool, b: bool, previous: float) -> float:
    """Return the position that two commands select; a monostable valve has command a only."""
    if function == "5/2 monostable":
        return 1.0 if a else -1.0
    if a != b:
        return 1.0 if a else -1.0
    return previous if function == "5/2 bistable" else 0.0


def spool_path(function, instants, commands, start, on_time, off_time):
    """Return knots (time, position) of a spool whose commands (a, b) change at instants.

    The last instant is the end. With three positions, the times are those between the centre and an end.
    """
    times, path, target = [instants[0]], [start], start
    for begin, end, (a, b) in zip(instants, instants[1:], commands, strict=False):
        target = selected_position(function, a, b, target)
        now, position = begin, path[-1]
        while now < end and position != target:
            upwards = target > position
            if function.startswith("5/2"):
                goal, speed = target, 2.0 / (on_time if upwards else off_time)
            else:
                leaves = position == 0.0 or (position > 0.0) == upwards
                goal = target if leaves or target * position > 0.0 else 0.0
                speed = 1.0 / (on_time if leaves else off_time)
            arrival = now + abs(goal - position) / speed
            if arrival > end:
                position += (1.0 if upwards else -1.0) * speed * (end - now)
                now = end
            else:
                now, position = arrival, goal
            times.append(now)
            path.append(position)
        times.append(end)
        path.append(position)
    return np.array(times), np.array(path)


def mass_flow(p1, t1, p2, t2, conductance, ratio):
    """Return the mass flow rate from 1 to 2 [kg/s]."""
    if p2 > p1:
        return -mass_flow(p2, t2, p1, t1, conductance, ratio)
    choked = conductance * NORMAL_DENSITY * p1 * np.sqrt(WARM / t1)
    if p2 <= ratio * p1:
        return choked
    return choked * np.sqrt(max(0.0, 1.0 - ((p2 / p1 - ratio) / (1.0 - ratio)) ** 2))


def chamber_pressures(function, knots, volumes, conductance, ratio, supply, ambient, times):
    """Return the pressures of two adiabatic chambers at ports a and b, shape (2, n_times)."""

    def rates(t, y):
        position, result = np.interp(t, *knots), []
        for port, (p, temperature), volume in zip("ab", y.reshape(2, 2), volumes, strict=True):
            mass, enthalpy = 0.0, 0.0
            for edge, outer in (("supply", supply), ("exhaust", ambient)):
                opening = np.interp(position, KNOTS, OPENINGS[function][f"{edge}_{port}"])
                flow = mass_flow(outer, WARM, p, temperature, conductance * opening, ratio)
                mass += flow
                enthalpy += flow * (WARM if flow > 0.0 else temperature)
            # p V = m R T and U = c_v m T
            pressure_rate = KAPPA * GAS * enthalpy / volume
            result += [pressure_rate, temperature * (pressure_rate / p - mass * GAS * temperature / (p * volume))]
        return result

    start = [ambient, WARM, ambient, WARM]
    solution = solve_ivp(rates, (0.0, times[-1]), start, t_eval=times, rtol=1e-7, atol=1e-3, max_step=2e-4)
    return solution.y[[0, 2]]
