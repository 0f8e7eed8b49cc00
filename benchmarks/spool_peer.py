"""The peer of `joint.py` for the positioned cylinder: valve, cylinder, friction and controller, in plain floats.

It imports nothing of poppet; its numbers come by their addresses.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from scipy.integrate import odeint

from sampled_peer import flow_law

GAS, KAPPA, WARM, AIR = 287.05, 1.4, 293.15, 1e5
CP, CV = KAPPA * GAS / (KAPPA - 1.0), GAS / (KAPPA - 1.0)
SIZES = np.array([100.0, 1e-3, 100.0, 1e-3, 0.1, 1.0, 1e-5, 1.0, 100.0])


def spool_rates(number: dict[str, float]) -> Callable[[float, list[float], float], tuple[float, ...]]:
    """Rates of energy and mass of both chambers, of position, speed, bristles, spool and its speed."""
    flow, supply = flow_law(), number["supply.pressure"]
    c1, b1 = number["valve.sonic_conductance"], number["valve.critical_ratio"]
    c2, c3, c4 = (number[f"valve.{name}_conductance"] for name in ("supply_b", "exhaust_a", "exhaust_b"))
    b2, b3, b4 = (number[f"valve.{name}_ratio"] for name in ("supply_b", "exhaust_a", "exhaust_b"))
    lap, turn = number["valve.overlap"], 2.0 * math.pi * number["valve.natural_frequency"]
    damping = 2.0 * number["valve.damping"] * turn
    area = 0.25 * math.pi * number["cylinder.piston.bore"] ** 2
    rod = 0.25 * math.pi * number["cylinder.piston.rod_diameter"] ** 2
    ring, stroke = area - rod, number["cylinder.piston.stroke_length"]
    dead1, dead2 = number["cylinder.cap.dead_volume"], number["cylinder.rod.dead_volume"]
    wall1, wall2 = number["cylinder.cap.wall_conductance"], number["cylinder.rod.wall_conductance"]
    friction = "slide.friction."
    coulomb, static, slow = (number[friction + n] for n in ("coulomb_force", "static_force", "stribeck_velocity"))
    viscous, stiff, micro = (
        number[friction + n] for n in ("viscous_coefficient", "bristle_stiffness", "bristle_damping")
    )
    mass = number["slide.mass"]

    def rates(t: float, y: list[float], command: float) -> tuple[float, ...]:
        u1, m1, u2, m2, x, v, z, s, w = y
        v1, v2 = dead1 + area * x, dead2 + ring * (stroke - x)
        p1, p2, t1, t2 = (KAPPA - 1.0) * u1 / v1, (KAPPA - 1.0) * u2 / v2, u1 / (m1 * CV), u2 / (m2 * CV)
        n1 = n2 = h1 = h2 = 0.0
        opening = min((abs(s) - lap) / (1.0 - lap), 1.0)
        if opening > 0.0 and s > 0.0:
            n1, at = flow(supply, p1, WARM, t1, c1 * opening, b1)
            h1 = CP * at * n1
            n2, at = flow(AIR, p2, WARM, t2, c4 * opening, b4)
            h2 = CP * at * n2
        elif opening > 0.0:
            n2, at = flow(supply, p2, WARM, t2, c2 * opening, b2)
            h2 = CP * at * n2
            n1, at = flow(AIR, p1, WARM, t1, c3 * opening, b3)
            h1 = CP * at * n1
        fading = math.exp(-((v / slow) ** 2))
        slip = v - stiff * abs(v) / (coulomb + (static - coulomb) * fading + 1e-9) * z
        rubbing = stiff * z + micro * fading * slip + viscous * v
        force = p1 * area - p2 * ring - AIR * rod - rubbing
        return (
            h1 + wall1 * (WARM - t1) - p1 * area * v, n1,
            h2 + wall2 * (WARM - t2) + p2 * ring * v, n2,
            v, force / mass, slip, w, turn * turn * (command - s) - damping * w,
        )  # fmt: skip

    return rates


def spool_run(number: dict[str, float], tolerance: float, signals: Mapping[str, Sequence[float]]) -> np.ndarray:
    """The position at every second sample of the controller."""
    gain, lead, lag = (number[f"position.{name}"] for name in ("gain", "derivative_time", "derivative_filter"))
    step, x = number["position.sample_time"], number["slide.initial_position"]
    area = 0.25 * math.pi * number["cylinder.piston.bore"] ** 2
    ring = area - 0.25 * math.pi * number["cylinder.piston.rod_diameter"] ** 2
    volumes = area * x, ring * (number["cylinder.piston.stroke_length"] - x)
    y: list[float] = []
    for side, swept in zip(("cap", "rod"), volumes, strict=True):
        p, volume = number[f"cylinder.{side}.initial_pressure"], number[f"cylinder.{side}.dead_volume"] + swept
        y += [p * volume / (KAPPA - 1.0), p * volume / (GAS * WARM)]
    y += [x, 0.0, 0.0, number["valve.initial_position"], 0.0]
    rates, absolute, derivative, before, positions = spool_rates(number), tolerance * SIZES, 0.0, x, []

    def plain(t: float, y: np.ndarray, command: float) -> tuple[float, ...]:
        return rates(t, y.tolist(), command)

    for k, (wanted, fed) in enumerate(zip(signals["position.setpoint"], signals["position.feedforward"], strict=True)):
        if k % 2 == 0:
            positions.append(y[4])
        derivative = (lag * derivative - gain * lead * (y[4] - before)) / (lag + step)
        before = y[4]
        command = min(max(gain * (wanted - before) + derivative + fed, -1.0), 1.0)
        t = k * step
        found = odeint(plain, y, (t, t + step), (command,), rtol=tolerance, atol=absolute, tfirst=True)
        y = [float(value) for value in found[1]]
    return np.array([*positions, y[4]])
