"""The peer of `machine.py`: two cylinders, 5/2 valves and a step sequence in SciPy, as a careful user would write it.

It imports nothing of poppet; its numbers stand here as in the circuit. The right-hand side is plain floats in locals,
closed edges are skipped. The integration restarts only at the transitions of the sequence; between them, `odeint`
returns the states at all sample instants, at which the conditions are evaluated.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from scipy.integrate import odeint, solve_ivp

GAS, KAPPA, AMBIENT, SUPPLY, WARM = 287.05, 1.4, 1e5, 7e5, 293.15
CV = GAS / (KAPPA - 1.0)
CP = KAPPA * CV
RAIL, FEED, FEED_RATIO = 0.5e-3, 3e-8, 0.4
STOP, LOSS, EDGE = 1e8, 5.0, 0.999
SWITCHING, SAMPLE = 0.012, 0.005
SIZES = np.array([100.0, 1e-3, *([100.0, 1e-3, 100.0, 1e-3, 0.1, 1.0, 1.0, 1e-5] * 2)])
"""Of energy and mass of the rail; per drive of both chambers, position, velocity, spool and bristles."""

Rates = Callable[[list[float], float, float, float], tuple[float, ...]]


def flow(p1: float, p2: float, t1: float, t2: float, c: float, b: float) -> tuple[float, float]:
    """Mass flow rate and enthalpy flow: ISO 6358 with the cubic near equal pressures."""
    if p1 >= p2:
        up, low, sign, t = p1, p2, 1.185, t1
    else:
        up, low, sign, t = p2, p1, -1.185, t2
    q = sign * c * up * math.sqrt(293.15 / t)
    r = low / up
    if r > EDGE:
        u = (EDGE - b) / (1.0 - b)
        g, zone = 1.0 - u * u, 1.0 - EDGE
        s, z = zone * u / (g * (1.0 - b)), (1.0 - r) / zone
        q *= math.sqrt(g) * z * (0.5 * (3.0 - s) + z * z * 0.5 * (s - 1.0))
    elif r > b:
        u = (r - b) / (1.0 - b)
        q *= math.sqrt(1.0 - u * u)
    return q, CP * t * q


def stop(depth: float, speed: float) -> float:
    """The covers, after Hunt and Crossley with a bounded factor."""
    if depth <= 0.0:
        return 0.0
    s = LOSS * speed
    return STOP * depth * math.sqrt(depth) * (1.0 + s / math.sqrt(1.0 + s * s))


def drive_rates(bore: float, rod: float, stroke: float, mass: float, c: float, c_out: float) -> Rates:
    """Rates of the eight states of a drive, and mass and enthalpy flow out of the rail."""
    area, rod_area = math.pi / 4 * bore**2, math.pi / 4 * rod**2
    ring, dead, wall, b = area - rod_area, 5e-6, 0.5, 0.3
    coulomb, static, slow, viscous = 20.0, 30.0, 0.01, 50.0
    bristle = static / 1e-5
    micro, exp = 2.0 * math.sqrt(bristle * mass), math.exp

    def rates(y: list[float], p0: float, t0: float, command: float) -> tuple[float, ...]:
        u1, m1, u2, m2, x, v, s, z = y
        v1, v2 = dead + area * x, dead + ring * (stroke - x)
        p1, p2, t1, t2 = (KAPPA - 1.0) * u1 / v1, (KAPPA - 1.0) * u2 / v2, u1 / (m1 * CV), u2 / (m2 * CV)
        if s > 0.0:
            q1, h1 = flow(p0, p1, t0, t1, c * s, b)
            q2, h2 = flow(AMBIENT, p2, WARM, t2, c_out * s, b)
            q0, h0 = q1, h1
        else:
            q1, h1 = flow(AMBIENT, p1, WARM, t1, -c_out * s, b)
            q2, h2 = flow(p0, p2, t0, t2, -c * s, b)
            q0, h0 = q2, h2
        fading = exp(-((v / slow) ** 2))
        slip = v - bristle * abs(v) / (coulomb + (static - coulomb) * fading) * z
        force = p1 * area - p2 * ring - AMBIENT * rod_area - bristle * z - micro * fading * slip - viscous * v
        if x <= 0.0:
            force += stop(-x, -v)
        elif x >= stroke:
            force -= stop(x - stroke, v)
        wanted = 25.0 * ((1.0 if command > 0.5 else -1.0) - s)
        speed = 2.0 / SWITCHING * (1.0 if wanted > 1.0 else -1.0 if wanted < -1.0 else wanted)
        return (
            h1 + wall * (WARM - t1) - p1 * area * v, q1, h2 + wall * (WARM - t2) + p2 * ring * v, q2,
            v, force / mass, speed, slip, q0, h0,
        )  # fmt: skip

    return rates


DRIVES = (drive_rates(0.025, 0.01, 0.1, 2.0, 1e-8, 6e-9), drive_rates(0.032, 0.012, 0.05, 3.0, 1e-8, 6e-9))
AREAS = tuple(
    (math.pi / 4 * bore**2, math.pi / 4 * (bore**2 - rod**2)) for bore, rod in ((0.025, 0.01), (0.032, 0.012))
)
STROKES = (0.1, 0.05)


def machine_rates(y: list[float], a: float, b: float) -> list[float]:
    """Rates of the rail and of both drives for the commands a and b."""
    energy, mass = y[0], y[1]
    p0, t0 = (KAPPA - 1.0) * energy / RAIL, energy / (mass * CV)
    q, h = flow(SUPPLY, p0, WARM, t0, FEED, FEED_RATIO)
    *first, q1, h1 = DRIVES[0](y[2:10], p0, t0, a)
    *second, q2, h2 = DRIVES[1](y[10:18], p0, t0, b)
    return [h - h1 - h2, q - q1 - q2, *first, *second]


def start() -> np.ndarray:
    """The rail at its pressure, both pistons at the cap, the rod sides at the pressure of the rail."""
    y = [SUPPLY * RAIL / (KAPPA - 1.0), SUPPLY * RAIL / (GAS * WARM)]
    for (_, ring), stroke in zip(AREAS, STROKES, strict=True):
        for p, volume in ((AMBIENT, 5e-6), (SUPPLY, 5e-6 + ring * stroke)):
            y += [p * volume / (KAPPA - 1.0), p * volume / (GAS * WARM)]
        y += [0.0, 0.0, -1.0, 0.0]
    return np.array(y)


# Commands of a and b in each step, and the state, direction and limit of its condition.
STEPS = (
    ((1.0, 0.0), 6, 1.0, 0.098),
    ((1.0, 1.0), 14, 1.0, 0.048),
    ((1.0, 0.0), 14, -1.0, 0.002),
    ((0.0, 0.0), 6, -1.0, 0.002),
)


def with_odeint(tolerance: float, y: np.ndarray, times: np.ndarray, commands: tuple[float, float]) -> np.ndarray:
    """States at the given times by `odeint`."""
    a, b = commands
    found = odeint(
        lambda t, y: machine_rates(y.tolist(), a, b), y, times, rtol=tolerance, atol=tolerance * SIZES, tfirst=True
    )
    return np.asarray(found)


def with_solve_ivp(tolerance: float, y: np.ndarray, times: np.ndarray, commands: tuple[float, float]) -> np.ndarray:
    """States at the given times by `solve_ivp(method="LSODA")`."""
    a, b = commands
    found = solve_ivp(
        lambda t, y: machine_rates(y.tolist(), a, b), (times[0], times[-1]), y, "LSODA", t_eval=times, rtol=tolerance,
        atol=tolerance * SIZES,
    )  # fmt: skip
    return np.asarray(found.y.T)


WAYS = {"odeint": with_odeint, "solve_ivp(LSODA)": with_solve_ivp}


def peer_run(way: str, tolerance: float, samples: int) -> tuple[np.ndarray, list[int]]:
    """Both positions at all sample instants, and the samples of the transitions."""
    integrate, y, step, rows, transitions, k, chunk = WAYS[way], start(), 0, [], [], 0, 16
    rows.append(y)
    while k < samples:
        ahead = min(chunk, samples - k)
        commands, index, sign, limit = STEPS[step]
        found = integrate(tolerance, y, SAMPLE * np.arange(k, k + ahead + 1), commands)
        reached = np.flatnonzero(sign * (found[1:, index] - limit) > 0.0)
        used = int(reached[0]) + 1 if reached.size else ahead
        rows.extend(found[1 : used + 1])
        k, y = k + used, found[used]
        if reached.size and k < samples:
            step = (step + 1) % len(STEPS)
            transitions.append(k)
    return np.array(rows)[:, [6, 14]], transitions
