"""The peer of the benchmarks: the paper's staircase in SciPy, right-hand side in plain floats, as a careful user would.

It imports nothing of poppet; its numbers stand here as printed by `circuit.parameters`.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp

TIMES = [0.0, 20.0, 40.0, 60.0, 80.0, 100.0]
PILOT = [1e5, 2e5, 3e5, 4e5, 5e5, 0.0]
START = [0.0, 0.0, 1e5, 1e5 * 0.2 / (287.05 * 293.15), 0.0]
NUMBERS: dict[str, float] = {
    "valve.plate_area": 0.0004909,
    "valve.moving_mass": 0.02,
    "valve.emptying_mass": 0.012,
    "valve.damping": 106.0,
    "valve.upper_spring.rate": 255000.0,
    "valve.upper_spring.preload": 2e-05,
    "valve.lower_spring.rate": 30000.0,
    "valve.lower_spring.preload": 0.000157,
    "valve.overlap": 5e-06,
    "valve.exhaust_seat.sonic_conductance": 9.3e-09,
    "valve.exhaust_seat.critical_ratio": 0.35,
    "valve.exhaust_seat.opening": 1e-05,
    "valve.upper_stop.position": 0.001,
    "valve.upper_stop.stiffness": 7070000000.0,
    "valve.upper_stop.dissipation": 300.0,
    "valve.lower_stop.position": -5e-05,
    "valve.lower_stop.stiffness": 7070000000.0,
    "valve.lower_stop.dissipation": 300.0,
    "valve.contact.width": 2e-06,
    "valve.contact.dissipation": 300.0,
    "valve.characteristic.sonic_conductance.k1": -1.1858e-06,
    "valve.characteristic.sonic_conductance.k2": 4.5064e-06,
    "valve.characteristic.sonic_conductance.k3": -6.9209e-06,
    "valve.characteristic.sonic_conductance.k4": 5.4385e-06,
    "valve.characteristic.sonic_conductance.k5": -2.2269e-06,
    "valve.characteristic.sonic_conductance.k6": 3.7653e-07,
    "valve.characteristic.sonic_conductance.k7": 2.1902e-08,
    "valve.characteristic.sonic_conductance.k8": 5.0034e-09,
    "valve.characteristic.critical_ratio.p1": 3.1618,
    "valve.characteristic.critical_ratio.p2": -8.3177,
    "valve.characteristic.critical_ratio.p3": 7.6847,
    "valve.characteristic.critical_ratio.p4": -2.7384,
    "valve.characteristic.critical_ratio.p5": 0.71748,
    "tank.volume": 0.2,
    "tank.wall_conductance": 45.0,
    "tank.wall_temperature": 293.15,
}


def peer_rates(number: dict[str, float]) -> Callable[..., tuple[float, ...]]:
    """The same physics in plain floats; numbers are bound once, powers are Horner sums, the law is branched."""
    k = [number[f"valve.characteristic.sonic_conductance.k{i}"] for i in range(1, 9)]
    q = [number[f"valve.characteristic.critical_ratio.p{i}"] for i in range(1, 6)]
    area, k1, h1 = (number[f"valve.{n}"] for n in ("plate_area", "upper_spring.rate", "upper_spring.preload"))
    k2, h2 = number["valve.lower_spring.rate"], number["valve.lower_spring.preload"]
    m_fill, m_empty, damping = (number[f"valve.{n}"] for n in ("moving_mass", "emptying_mass", "damping"))
    width, contact = number["valve.contact.width"], number["valve.contact.dissipation"]
    up_x, up_k, up_d = (number[f"valve.upper_stop.{n}"] for n in ("position", "stiffness", "dissipation"))
    low_x, low_k, low_d = (number[f"valve.lower_stop.{n}"] for n in ("position", "stiffness", "dissipation"))
    c_ex, b_ex = number["valve.exhaust_seat.sonic_conductance"], number["valve.exhaust_seat.critical_ratio"]
    overlap, opening = number["valve.overlap"], number["valve.exhaust_seat.opening"]
    volume, h_a, t_wall = number["tank.volume"], number["tank.wall_conductance"], number["tank.wall_temperature"]
    closing = 2e-5
    gas, kappa, p_amb, p_sup, t_sup = 287.05, 1.4, 1e5, 7e5, 293.15
    cp = kappa * gas / (kappa - 1.0)
    sqrt, lam, zone = math.sqrt, 0.999, 1.0 - 0.999

    def flow(p1: float, p2: float, t1: float, t2: float, c: float, b: float) -> tuple[float, float]:
        if p1 >= p2:
            up, low, sign = p1, p2, 1.0
        else:
            up, low, sign = p2, p1, -1.0
        r = low / up
        if r <= lam:
            temperature = t1 if sign > 0.0 else t2
            base = sign * c * up * 1.185 * sqrt(293.15 / temperature)
            if r <= b:
                return base, temperature
            u = (r - b) / (1.0 - b)
            return base * sqrt(1.0 - u * u), temperature
        u = (lam - b) / (1.0 - b)
        g = 1.0 - u * u
        s = zone * u / (g * (1.0 - b))
        z = (1.0 - r) / zone
        zs = sign * z
        w = 0.5 + 0.25 * (3.0 * zs - zs * zs * zs)
        temperature = w * t1 + (1.0 - w) * t2
        shape = z * (0.5 * (3.0 - s) + z * z * 0.5 * (s - 1.0))
        return sign * c * up * 1.185 * sqrt(293.15 / temperature) * sqrt(g) * shape, temperature

    def rates(t: float, y: list[float], pilot: float) -> tuple[float, ...]:
        x, v, p, m, _ = y
        temperature = p * volume / (m * gas)
        s = 1.0 + x / width
        lifted = 0.0 if s <= 0.0 else 1.0 if s >= 1.0 else s * s * (3.0 - 2.0 * s)
        force = area * pilot - k1 * (h1 + x) - damping * v
        if lifted > 0.0:
            held = 4.0 * lifted * (1.0 - lifted)
            cv = contact * v
            force -= lifted * k2 * (h2 + (x if x > 0.0 else 0.0)) * (1.0 + held * cv / sqrt(1.0 + cv * cv))
        if x > up_x:
            d, cv = x - up_x, up_d * v
            force -= up_k * d * sqrt(d) * (1.0 + cv / sqrt(1.0 + cv * cv))
        elif x < low_x:
            d, cv = low_x - x, -low_d * v
            force += low_k * d * sqrt(d) * (1.0 + cv / sqrt(1.0 + cv * cv))
        q1 = q2 = h_in = h_out = 0.0
        if x > 0.0:
            mm = 1e3 * (x if x < 1e-3 else 1e-3)
            c = ((((((k[0] * mm + k[1]) * mm + k[2]) * mm + k[3]) * mm + k[4]) * mm + k[5]) * mm + k[6]) * mm + k[7]
            b = (((q[0] * mm + q[1]) * mm + q[2]) * mm + q[3]) * mm + q[4]
            if x < closing:
                e = x / closing
                c *= e * e * (3.0 - 2.0 * e)
            q1, t1 = flow(p_sup, p, t_sup, temperature, c, b)
            h_in = cp * t1 * q1
        below = -x - overlap
        if below > 0.0:
            e = below / opening if below < opening else 1.0
            q2, t2 = flow(p, p_amb, temperature, t_sup, c_ex * e * e * (3.0 - 2.0 * e), b_ex)
            h_out = cp * t2 * q2
        heat = h_a * (t_wall - temperature)
        mass = m_empty + (m_fill - m_empty) * lifted
        return v, force / mass, (kappa - 1.0) / volume * (h_in - h_out + heat), q1 - q2, heat

    return rates


def peer_run(rates: Callable[..., tuple[float, ...]], start: list[float], tolerance: float) -> np.ndarray:
    """LSODA from step to step; rows of the five states at the output times."""
    grid = np.arange(1201) * 0.1
    sizes = np.array([1e-3, 0.1, start[2], start[3], 1e4])
    atol = tolerance * sizes * np.array([0.1, 1.0, 1e-3, 1e-3, 1.0])
    rows: list[np.ndarray] = []
    y = np.array(start)
    for k, (begin, pilot) in enumerate(zip(TIMES, PILOT, strict=True)):
        end = TIMES[k + 1] if k + 1 < len(TIMES) else 120.0
        inside = grid[(grid >= begin - 1e-9) & (grid < end - 1e-9)]
        times = np.append(np.maximum(inside, begin), end)
        result = solve_ivp(
            rates, (begin, end), y, method="LSODA", t_eval=times, rtol=tolerance, atol=atol, args=(pilot,)
        )
        rows.append(result.y[:, :-1])
        y = result.y[:, -1]
    return np.hstack([*rows, y[:, None]])
