"""The peer of `loads.py`: a cylinder that lifts a mass in SciPy, right-hand side in plain floats.

It is written as a careful user would, and imports nothing of poppet; its numbers stand here as in the circuit.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp

GAS, KAPPA, AMBIENT, SUPPLY, ROOM = 287.05, 1.4, 1e5, 7e5, 293.15
CP, CV = KAPPA * GAS / (KAPPA - 1.0), GAS / (KAPPA - 1.0)
BORE, ROD, STROKE, DEAD, WALL = 0.025, 0.01, 0.16, 5e-6, 0.5
AREA, RING = math.pi / 4 * BORE**2, math.pi / 4 * (BORE**2 - ROD**2)
MASS, WEIGHT, COULOMB, STATIC, STRIBECK, VISCOUS = 4.0, 4.0 * 9.80665, 20.0, 30.0, 0.01, 50.0
BRISTLE = STATIC / 1e-5
MICRO = 2.0 * math.sqrt(BRISTLE * MASS)
STOP, LOSS = 1e8, 5.0
FILL, VENT, RATIO = 3e-9, 1e-9, 0.3
EDGE = 0.999


def flow(p1: float, p2: float, t1: float, t2: float, c: float) -> tuple[float, float]:
    """Mass flow and the temperature it carries: ISO 6358 with the C1 zone, heat from the upstream side."""
    forward = p1 >= p2
    up, low, temperature = (p1, p2, t1) if forward else (p2, p1, t2)
    r = low / up
    q = c * up * 1.185 * math.sqrt(293.15 / temperature)
    if r > EDGE:
        u = (EDGE - RATIO) / (1.0 - RATIO)
        g, zone = 1.0 - u * u, 1.0 - EDGE
        s, z = zone * u / (g * (1.0 - RATIO)), (1.0 - r) / zone
        q *= math.sqrt(g) * z * (0.5 * (3.0 - s) + z * z * 0.5 * (s - 1.0))
    elif r > RATIO:
        u = (r - RATIO) / (1.0 - RATIO)
        q *= math.sqrt(1.0 - u * u)
    return (q if forward else -q), temperature


def stop(depth: float, speed: float) -> float:
    """The covers, after Hunt and Crossley with a bounded factor."""
    if depth <= 0.0:
        return 0.0
    s = LOSS * speed
    return STOP * depth * math.sqrt(depth) * (1.0 + s / math.sqrt(1.0 + s * s))


def rates(t: float, y: list[float]) -> tuple[float, ...]:
    """Energy and mass of both chambers, position, speed, deflection of the bristles."""
    u1, m1, u2, m2, x, v, z = y
    v1, v2 = DEAD + AREA * x, DEAD + RING * (STROKE - x)
    p1, p2, t1, t2 = (KAPPA - 1.0) * u1 / v1, (KAPPA - 1.0) * u2 / v2, u1 / (m1 * CV), u2 / (m2 * CV)
    q1, carried1 = flow(SUPPLY, p1, ROOM, t1, FILL)
    q2, carried2 = flow(p2, AMBIENT, t2, ROOM, VENT)
    fading = math.exp(-((v / STRIBECK) ** 2))
    slip = v - BRISTLE * abs(v) / (COULOMB + (STATIC - COULOMB) * fading) * z
    force = p1 * AREA - p2 * RING - AMBIENT * (AREA - RING) + stop(-x, -v) - stop(x - STROKE, v) - WEIGHT
    force -= BRISTLE * z + MICRO * fading * slip + VISCOUS * v
    work1, work2 = -p1 * AREA * v, p2 * RING * v
    first = CP * carried1 * q1 + WALL * (ROOM - t1) + work1
    second = -CP * carried2 * q2 + WALL * (ROOM - t2) + work2
    return first, q1, second, -q2, v, force / MASS, slip


def start() -> np.ndarray:
    """Both chambers at 1 bar, the piston at the cap."""
    small, large = DEAD, DEAD + RING * STROKE
    gas = [each * volume for volume in (small, large) for each in (AMBIENT / (KAPPA - 1.0), AMBIENT / (GAS * ROOM))]
    return np.array([*gas, 0.0, 0.0, 0.0])


def peer_run(tolerance: float, method: str = "LSODA") -> np.ndarray:
    """Rows of the seven states every 2 ms for 2 s."""
    sizes = np.array([100.0, 1e-3, 100.0, 1e-3, 0.1, 1.0, 1e-5])
    atol = tolerance * sizes * np.array([1e-3, 1e-3, 1e-3, 1e-3, 1.0, 0.1, 1.0])
    grid = np.arange(1001) * 0.002
    result = solve_ivp(rates, (0.0, 2.0), start(), method=method, t_eval=grid, rtol=tolerance, atol=atol)
    return np.asarray(result.y)
