"""The peer of `joint.py`: the muscle joint with its valve and tube in SciPy, right-hand side in plain floats.

The valve and its electronics are those of `sampled_peer.py`, whose tank is the tube's first cell here. It imports
nothing of poppet; its numbers come by their addresses.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from scipy.integrate import odeint

from sampled_peer import SIZES, Rates, controller, valve_rates

CELLS = 4
GAS, KAPPA = 287.05, 1.4
CP, CV = KAPPA * GAS / (KAPPA - 1.0), GAS / (KAPPA - 1.0)


def segment(
    conductance: float, ratio: float, edge: float
) -> Callable[[float, float, float, float], tuple[float, float]]:
    """Mass flow rate through a piece of the tube, and the enthalpy that it carries; laminar above an edge."""
    zone, u = 1.0 - edge, (edge - ratio) / (1.0 - ratio)
    g = 1.0 - u * u
    s, root, sqrt = zone * u / (g * (1.0 - ratio)), math.sqrt(g), math.sqrt

    def flow(p1: float, p2: float, t1: float, t2: float) -> tuple[float, float]:
        up, low, sign, temperature = (p1, p2, 1.0, t1) if p1 >= p2 else (p2, p1, -1.0, t2)
        r = low / up
        if r <= edge:
            w = max((r - ratio) / (1.0 - ratio), 0.0)
            q = sign * conductance * up * 1.185 * sqrt(293.15 / temperature * (1.0 - w * w))
            return q, CP * temperature * q
        z = (1.0 - r) / zone
        zs = sign * z
        part = 0.5 + 0.25 * (3.0 * zs - zs * zs * zs)
        temperature = part * t1 + (1.0 - part) * t2
        q = sign * conductance * up * 1.185 * sqrt(293.15 / temperature) * root
        q *= z * (0.5 * (3.0 - s) + z * z * 0.5 * (s - 1.0))
        return q, CP * temperature * q

    return flow


def law_of(number: dict[str, float], part: str) -> Callable[[float], tuple[float, float]]:
    """Sarosi's force per pressure and force without it."""
    a1, a2, a3, a4, a5, a6 = (number[f"{part}.sarosi.a{k}"] for k in range(1, 7))

    def line(contraction: float) -> tuple[float, float]:
        steep = math.exp(a3 * contraction)
        return a1 * steep + a4 * contraction + a5, a2 * steep + a6

    return line


def joint_rates(number: dict[str, float]) -> Rates:
    """Rates of the valve's eight states, the first cell's among them, three cells, the muscle, the arm, the threads."""
    first = {name: number[f"hose.1.{name}"] for name in ("volume", "wall_conductance", "wall_temperature")}
    valve = valve_rates(number | {f"tank.{name}": value for name, value in first.items()})
    names = ("hose.1_to_2", "hose.2_to_3", "hose.3_to_4", "hose.outlet")
    sizes = ("sonic_conductance", "critical_ratio", "laminar_ratio")
    flows = [segment(*(number[f"{name}.{size}"] for size in sizes)) for name in names]
    v1, v2 = number["hose.1.volume"], number["hose.2.volume"]
    wall, warm = number["hose.2.wall_conductance"], number["hose.2.wall_temperature"]
    a1, a3, a4, a5 = (number[f"muscle.sarosi.a{k}"] for k in (1, 3, 4, 5))
    line = law_of(number, "muscle")
    length, offset, dead, still = (
        number[f"muscle.{name}"] for name in ("nominal_length", "offset", "dead_volume", "nominal_volume")
    )
    damping, slack, h_a = (number[f"muscle.{name}"] for name in ("damping", "slack_force", "wall_conductance"))
    rub, rub_p, reach = (number[f"muscle.hysteresis.{name}"] for name in ("force", "force_per_pressure", "reach"))
    inertia, radius, load = (number[f"arm.{name}"] for name in ("inertia", "pulley_radius", "load_torque"))
    viscous = number["arm.friction.viscous_coefficient"]

    def rates(t: float, y: list[float], fill: float, vent: float) -> tuple[float, ...]:
        p1, m1, p2, m2, p3, m3, p4, m4, energy, m, angle, speed, slip = y[6:]
        contraction = (radius * angle - offset) / length
        slope, passive = line(contraction)
        grown = a1 * (math.exp(a3 * contraction) - 1.0) / a3 + (0.5 * a4 * contraction + a5) * contraction
        volume = dead + still + length * grown
        p, temperature = (KAPPA - 1.0) * energy / volume, energy / (m * CV)
        t1, t2, t3, t4 = p1 * v1 / (m1 * GAS), p2 * v2 / (m2 * GAS), p3 * v2 / (m3 * GAS), p4 * v2 / (m4 * GAS)
        q12, h12 = flows[0](p1, p2, t1, t2)
        q23, h23 = flows[1](p2, p3, t2, t3)
        q34, h34 = flows[2](p3, p4, t3, t4)
        q4m, h4m = flows[3](p4, p, t4, temperature)
        stage = valve(t, y[:8], fill, vent)
        way, gauge = radius * speed, p - 1e5
        force = gauge * slope + passive - damping * way - (rub + rub_p * max(gauge, 0.0)) * slip
        if force <= slack:
            force = max(force + slack, 0.0) ** 2 / (4.0 * slack)
        k2 = (KAPPA - 1.0) / v2
        return (
            *stage[:6],
            stage[6] - (KAPPA - 1.0) / v1 * h12, stage[7] - q12,
            k2 * (h12 - h23 + wall * (warm - t2)), q12 - q23,
            k2 * (h23 - h34 + wall * (warm - t3)), q23 - q34,
            k2 * (h34 - h4m + wall * (warm - t4)), q34 - q4m,
            h4m + h_a * (warm - temperature) - p * slope * way, q4m,
            speed, (radius * force - load - viscous * speed) / inertia,
            (way - abs(way) * slip) / reach,
        )  # fmt: skip

    return rates


def position_loop(number: dict[str, float], start: float) -> Callable[[float, float], float]:
    """The controller of the angle: the force that a sample of it asks for."""
    gain, lead, lag = (number[f"position.{name}"] for name in ("gain", "derivative_time", "derivative_filter"))
    slow, weight, step = (number[f"position.{name}"] for name in ("integral_time", "setpoint_weight", "sample_time"))
    low, high, bias = (number[f"position.{name}"] for name in ("lower_limit", "upper_limit", "bias"))
    integral, derivative, before, origin = 0.0, 0.0, start, start

    def sample(wanted: float, angle: float) -> float:
        nonlocal integral, derivative, before
        error = wanted - angle
        derivative = (lag * derivative - gain * lead * (angle - before)) / (lag + step)
        before = angle
        rest = bias + gain * (error - (1.0 - weight) * (wanted - origin)) + derivative
        given = min(max(rest + integral, low), high)
        integral += step / slow * (gain * error + given - rest - integral)
        return given

    return sample


def begin(number: dict[str, float]) -> list[float]:
    """The states at the start."""
    cells = []
    for k in range(1, CELLS + 1):
        p = number[f"hose.{k}.initial_pressure"]
        cells += [p, p * number[f"hose.{k}.volume"] / (GAS * number[f"hose.{k}.initial_temperature"])]
    angle, pilot, p = (
        number[name] for name in ("arm.initial_position", "valve.pilot.initial_pressure", "muscle.initial_pressure")
    )
    contraction = (number["arm.pulley_radius"] * angle - number["muscle.offset"]) / number["muscle.nominal_length"]
    a1, a3, a4, a5 = (number[f"muscle.sarosi.a{k}"] for k in (1, 3, 4, 5))
    grown = a1 * (math.exp(a3 * contraction) - 1.0) / a3 + (0.5 * a4 * contraction + a5) * contraction
    volume = number["muscle.dead_volume"] + number["muscle.nominal_volume"] + number["muscle.nominal_length"] * grown
    density = 1.0 / (GAS * 293.15)
    stage = [0.0, 0.0, pilot, pilot * number["valve.pilot.volume"] * density, cells[0], pilot]
    return [*stage, *cells, p * volume / (KAPPA - 1.0), p * volume * density, angle, 0.0, 0.0]


def peer_run(number: dict[str, float], tolerance: float, samples: int, wanted: Callable[[float], float]) -> np.ndarray:
    """The angle at every fifth sample of the valve."""
    rates, control, y = joint_rates(number), controller(number), begin(number)
    position, line = position_loop(number, y[16]), law_of(number, "inverse")
    absolute = tolerance * np.array([*SIZES[:6], *([1e5, 1e-5] * CELLS), 50.0, 1e-4, 1.0, 1.0, 1.0])
    step, force, angles = number["valve.electronics.outer.sample_time"], number["position.bias"], []
    lowest, highest = number["inverse.lowest_pressure"], number["inverse.highest_pressure"]
    radius, offset, length = number["arm.pulley_radius"], number["muscle.offset"], number["muscle.nominal_length"]

    def plain(t: float, y: np.ndarray, fill: float, vent: float) -> tuple[float, ...]:
        return rates(t, y.tolist(), fill, vent)

    for k in range(samples):
        t = k * step
        if k % 5 == 0:
            angles.append(y[16])
        slope, passive = line((radius * y[16] - offset) / length)
        target = min(max(1e5 + (force - passive) / slope, lowest), highest)
        fill, vent = control(target, y[4], y[5])
        if k % 2 == 0:
            force = position(wanted(t), y[16])
        found = odeint(plain, y, (t, t + step), (fill, vent), rtol=tolerance, atol=absolute, tfirst=True)
        y = [float(value) for value in found[1]]
    return np.array([*angles, y[16]])
