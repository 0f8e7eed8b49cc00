"""The peer of `joint.py`: both muscle joints with their valves in SciPy, right-hand side in plain floats.

The valve and its electronics are those of `sampled_peer.py`, whose tank is the tube's first cell or a muscle here. It
imports nothing of poppet; its numbers come by their addresses.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from scipy.integrate import odeint

from sampled_peer import SIZES, Rates, controller, valve_rates

CELLS = 4
GAS, KAPPA, WARM = 287.05, 1.4, 293.15
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


class Muscle:
    """One muscle: what its states and the body make of it."""

    def __init__(self, number: dict[str, float], name: str) -> None:
        self.line = law_of(number, name)
        a1, a3, a4, a5 = (number[f"{name}.sarosi.a{k}"] for k in (1, 3, 4, 5))
        length, dead, still = (number[f"{name}.{each}"] for each in ("nominal_length", "dead_volume", "nominal_volume"))
        self.length, self.offset, self.direction = length, number[f"{name}.offset"], number[f"{name}.direction"]
        damping, slack, self.h_a = (number[f"{name}.{each}"] for each in ("damping", "slack_force", "wall_conductance"))
        threads = ("force", "force_per_pressure", "reach")
        rub, rub_p, self.reach = (number[f"{name}.hysteresis.{each}"] for each in threads)
        self.pressure, line = number[f"{name}.initial_pressure"], self.line

        def volume(contraction: float) -> float:
            grown = a1 * (math.exp(a3 * contraction) - 1.0) / a3 + (0.5 * a4 * contraction + a5) * contraction
            return dead + still + length * grown

        def at(contraction: float, way: float, gas: tuple[float, float], slip: float) -> tuple[float, ...]:
            energy, mass = gas
            slope, passive = line(contraction)
            p, temperature = (KAPPA - 1.0) * energy / volume(contraction), energy / (mass * CV)
            gauge = p - 1e5
            force = gauge * slope + passive - damping * way - (rub + rub_p * max(gauge, 0.0)) * slip
            if force <= slack:
                force = max(force + slack, 0.0) ** 2 / (4.0 * slack)
            return p, temperature, force, slope

        self.volume, self.at = volume, at

    def contraction(self, travel: float) -> float:
        """Of a travel of the body."""
        return self.direction * (travel - self.offset) / self.length

    def begin(self, travel: float) -> list[float]:
        """Energy and mass at the start."""
        volume = self.volume(self.contraction(travel))
        return [self.pressure * volume / (KAPPA - 1.0), self.pressure * volume / (GAS * WARM)]


def joint_rates(number: dict[str, float]) -> Rates:
    """Rates of the valve's eight states, the first cell's among them, three cells, the muscle, the arm, the threads."""
    first = {name: number[f"hose.1.{name}"] for name in ("volume", "wall_conductance", "wall_temperature")}
    valve = valve_rates(number | {f"tank.{name}": value for name, value in first.items()})
    names = ("hose.1_to_2", "hose.2_to_3", "hose.3_to_4", "hose.outlet")
    sizes = ("sonic_conductance", "critical_ratio", "laminar_ratio")
    flows = [segment(*(number[f"{name}.{size}"] for size in sizes)) for name in names]
    v1, v2, wall = (number[f"hose.{name}"] for name in ("1.volume", "2.volume", "2.wall_conductance"))
    muscle = Muscle(number, "muscle")
    length, offset, h_a, reach = muscle.length, muscle.offset, muscle.h_a, muscle.reach
    inertia, radius, load = (number[f"arm.{name}"] for name in ("inertia", "pulley_radius", "load_torque"))
    viscous = number["arm.friction.viscous_coefficient"]

    def rates(t: float, y: list[float], fill: float, vent: float) -> tuple[float, ...]:
        p1, m1, p2, m2, p3, m3, p4, m4, energy, m, angle, speed, slip = y[6:]
        way = radius * speed
        p, temperature, force, slope = muscle.at((radius * angle - offset) / length, way, (energy, m), slip)
        t1, t2, t3, t4 = p1 * v1 / (m1 * GAS), p2 * v2 / (m2 * GAS), p3 * v2 / (m3 * GAS), p4 * v2 / (m4 * GAS)
        q12, h12 = flows[0](p1, p2, t1, t2)
        q23, h23 = flows[1](p2, p3, t2, t3)
        q34, h34 = flows[2](p3, p4, t3, t4)
        q4m, h4m = flows[3](p4, p, t4, temperature)
        stage = valve(t, y[:8], fill, vent)
        k2 = (KAPPA - 1.0) / v2
        return (
            *stage[:6],
            stage[6] - (KAPPA - 1.0) / v1 * h12, stage[7] - q12,
            k2 * (h12 - h23 + wall * (WARM - t2)), q12 - q23,
            k2 * (h23 - h34 + wall * (WARM - t3)), q23 - q34,
            k2 * (h34 - h4m + wall * (WARM - t4)), q34 - q4m,
            h4m + h_a * (WARM - temperature) - p * slope * way, q4m,
            speed, (radius * force - load - viscous * speed) / inertia,
            (way - abs(way) * slip) / reach,
        )  # fmt: skip

    return rates


def valve_numbers(number: dict[str, float], name: str) -> dict[str, float]:
    """The numbers of one of several valves, as if it were the only one, at a tank of a cubic metre without a wall."""
    own = {f"valve.{key[len(name) + 1 :]}": value for key, value in number.items() if key.startswith(f"{name}.")}
    tank = {"tank.volume": 1.0, "tank.wall_conductance": 0.0, "tank.wall_temperature": WARM}
    return own | tank | {"supply.pressure": number["supply.pressure"]}


def pair_rates(number: dict[str, float]) -> Callable[..., tuple[float, ...]]:
    """Rates of two valves' six states each, of two muscles, the joint, and the threads of both."""
    sides = ("flexor", "extensor")
    valves = [valve_rates(valve_numbers(number, f"{side}_valve")) for side in sides]
    muscles = [Muscle(number, side) for side in sides]
    inertia, radius = (number[f"joint.{name}"] for name in ("inertia", "pulley_radius"))

    def rates(t: float, y: list[float], *held: float) -> tuple[float, ...]:
        angle, speed = y[16:18]
        found: list[float] = []
        gas: list[float] = []
        threads: list[float] = []
        torque = -held[4]
        for k, (muscle, valve) in enumerate(zip(muscles, valves, strict=True)):
            energy, m, slip = y[12 + 2 * k], y[13 + 2 * k], y[18 + k]
            contraction = muscle.direction * (radius * angle - muscle.offset) / muscle.length
            way = muscle.direction * radius * speed
            p, temperature, force, slope = muscle.at(contraction, way, (energy, m), slip)
            # In a cubic metre the same pressure and temperature need p/(R T); its rates are those of the flows.
            tank = [*y[6 * k : 6 * k + 6], p, p / (GAS * temperature)]
            stage = valve(t, tank, held[2 * k], held[2 * k + 1])
            found += stage[:6]
            gas += [stage[6] / (KAPPA - 1.0) + muscle.h_a * (WARM - temperature) - p * slope * way, stage[7]]
            threads.append((way - abs(way) * slip) / muscle.reach)
            torque += muscle.direction * radius * force
        return *found, *gas, speed, torque / inertia, *threads

    return rates


def pair_of(number: dict[str, float]) -> Callable[[float, float, tuple[float, float]], tuple[float, float]]:
    """Two pressures of a torque and a mean pressure, within their limits."""
    line, radius = law_of(number, "pair"), number["pair.pulley_radius"]
    low, high = number["pair.lowest_pressure"] - 1e5, number["pair.highest_pressure"] - 1e5

    def pressures(torque: float, mean: float, contractions: tuple[float, float]) -> tuple[float, float]:
        (s1, f1), (s2, f2) = (line(each) for each in contractions)
        pull, gauge = torque / radius, mean - 1e5
        half = (pull - gauge * (s1 - s2) - f1 + f2) / (s1 + s2)
        least1, least2 = max(min(-f1 / s1, gauge), low), max(min(-f2 / s2, gauge), low)
        pulled = max(min(max(gauge + half, least1), high) * s1 + f1, 0.0)
        yielded = max(min(max(gauge - half, least2), high) * s2 + f2, 0.0)
        first = min(max((yielded + pull - f1) / s1, least1), high)
        second = min(max((pulled - pull - f2) / s2, least2), high)
        return 1e5 + first, 1e5 + second

    return pressures


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
    """The states of the muscle joint at the start."""
    cells = []
    for k in range(1, CELLS + 1):
        p = number[f"hose.{k}.initial_pressure"]
        cells += [p, p * number[f"hose.{k}.volume"] / (GAS * WARM)]
    angle, pilot = number["arm.initial_position"], number["valve.pilot.initial_pressure"]
    stage = [0.0, 0.0, pilot, pilot * number["valve.pilot.volume"] / (GAS * WARM), cells[0], pilot]
    return [*stage, *cells, *Muscle(number, "muscle").begin(number["arm.pulley_radius"] * angle), angle, 0.0, 0.0]


def integrated(
    rates: Callable[..., tuple[float, ...]], sizes: np.ndarray, tolerance: float, step: float
) -> Callable[..., list[float]]:
    """LSODA over one sample; what is sampled comes behind the states."""
    absolute = tolerance * sizes

    def plain(t: float, y: np.ndarray, *held: float) -> tuple[float, ...]:
        return rates(t, y.tolist(), *held)

    def sample(t: float, y: list[float], *held: float) -> list[float]:
        found = odeint(plain, y, (t, t + step), held, rtol=tolerance, atol=absolute, tfirst=True)
        return [float(value) for value in found[1]]

    return sample


def joint_run(number: dict[str, float], tolerance: float, signals: Mapping[str, Sequence[float]]) -> np.ndarray:
    """The angle at every fifth sample of the valve."""
    control, y = controller(number), begin(number)
    position, line = position_loop(number, y[16]), law_of(number, "inverse")
    sizes = np.array([*SIZES[:6], *([1e5, 1e-5] * CELLS), 50.0, 1e-4, 1.0, 1.0, 1.0])
    step, force, angles = number["valve.electronics.outer.sample_time"], number["position.bias"], []
    sample = integrated(joint_rates(number), sizes, tolerance, step)
    lowest, highest = number["inverse.lowest_pressure"], number["inverse.highest_pressure"]
    radius, offset, length = number["arm.pulley_radius"], number["muscle.offset"], number["muscle.nominal_length"]
    for k, wanted in enumerate(signals["position.setpoint"]):
        if k % 5 == 0:
            angles.append(y[16])
        slope, passive = line((radius * y[16] - offset) / length)
        target = min(max(1e5 + (force - passive) / slope, lowest), highest)
        fill, vent = control(target, y[4], y[5])
        if k % 2 == 0:
            force = position(wanted, y[16])
        y = sample(k * step, y, fill, vent)
    return np.array([*angles, y[16]])


def pair_run(number: dict[str, float], tolerance: float, signals: Mapping[str, Sequence[float]]) -> np.ndarray:
    """The angle of the antagonistic joint at every fifth sample of the valves."""
    sides = ("flexor", "extensor")
    muscles, radius = [Muscle(number, side) for side in sides], number["joint.pulley_radius"]
    controls = [controller(valve_numbers(number, f"{side}_valve")) for side in sides]
    angle, y = number["joint.initial_position"], list[float]()
    for side, muscle in zip(sides, muscles, strict=True):
        pilot, volume = (number[f"{side}_valve.pilot.{name}"] for name in ("initial_pressure", "volume"))
        y += [0.0, 0.0, pilot, pilot * volume / (GAS * WARM), muscle.pressure, pilot]
    y += [each for muscle in muscles for each in muscle.begin(radius * angle)]
    y += [angle, 0.0, 0.0, 0.0]
    position, pressures = position_loop(number, angle), pair_of(number)
    sizes = np.array([*SIZES[:6], *SIZES[:6], 50.0, 1e-4, 50.0, 1e-4, 1.0, 1.0, 1.0, 1.0])
    step, torque, angles = number["flexor_valve.electronics.outer.sample_time"], number["position.bias"], []
    sample = integrated(pair_rates(number), sizes, tolerance, step)
    every = zip(*(signals[n] for n in ("position.setpoint", "pair.mean_pressure", "joint.load_torque")), strict=True)
    for k, (wanted, mean, load) in enumerate(every):
        if k % 5 == 0:
            angles.append(y[16])
        first, second = (muscle.contraction(radius * y[16]) for muscle in muscles)
        targets = pressures(torque, mean, (first, second))
        fill, vent = controls[0](targets[0], y[4], y[5])
        other_fill, other_vent = controls[1](targets[1], y[10], y[11])
        if k % 2 == 0:
            torque = position(wanted, y[16])
        y = sample(k * step, y, fill, vent, other_fill, other_vent, load)
    return np.array([*angles, y[16]])
