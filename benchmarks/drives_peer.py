"""The peers of `joint.py` for the drives that are switched: three cylinders and a muscle, in plain floats.

They import nothing of poppet; their numbers come by their addresses. LSODA begins anew where a signal jumps, and
nowhere else. What is shut is skipped, what does not change is worked out once.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from scipy.integrate import odeint

from joint_peer import Muscle

GAS, KAPPA, WARM, AIR = 287.05, 1.4, 293.15, 1e5
CP, CV = KAPPA * GAS / (KAPPA - 1.0), GAS / (KAPPA - 1.0)
EDGE = 0.999
Number = Mapping[str, float]
Signals = Mapping[str, Sequence[float]]
Rates = Callable[..., tuple[float, ...]]
GAS_SIZES, BODY_SIZES = [0.1, 1e-6], [1e-2, 0.1, 1e-5]
"""Of energy and mass; of position, speed and deflection."""


def stop(depth: float, speed: float, stiffness: float, loss: float) -> float:
    """An end stop after Hunt and Crossley with a bounded factor."""
    if depth <= 0.0:
        return 0.0
    s = loss * speed
    return stiffness * depth * math.sqrt(depth) * (1.0 + s / math.sqrt(1.0 + s * s))


def flow(p1: float, p2: float, t1: float, t2: float, c: float, b: float) -> tuple[float, float]:
    """Mass flow rate from 1 to 2 and the temperature that it carries, which turns over a thousandth of the zone."""
    if p1 >= p2:
        up, low, sign, temperature = p1, p2, 1.0, t1
    else:
        up, low, sign, temperature = p2, p1, -1.0, t2
    r = low / up
    if r <= EDGE:
        base = sign * c * up * 1.185 * math.sqrt(293.15 / temperature)
        if r <= b:
            return base, temperature
        u = (r - b) / (1.0 - b)
        return base * math.sqrt(1.0 - u * u), temperature
    zone, u = 1.0 - EDGE, (EDGE - b) / (1.0 - b)
    z, g = (1.0 - r) / zone, 1.0 - u * u
    if z < 1e-3:
        still = 0.5 * (t1 + t2) - (t1 - t2) * (t1 - t2) / (3.0 * (t1 + t2))
        temperature = still + 1e3 * z * (2.0 - 1e3 * z) * (temperature - still)
    s = zone * u / (g * (1.0 - b))
    shape = sign * z * (0.5 * (3.0 - s) + z * z * 0.5 * (s - 1.0))
    return c * up * 1.185 * math.sqrt(293.15 / temperature * g) * shape, temperature


def check_flow(p1: float, p2: float, t1: float, c: float, b: float, cracking: float) -> float:
    """Mass flow rate through a check valve."""
    excess = (p1 - p2 - cracking) / p1
    if excess <= 0.0:
        return 0.0
    zone, span = 1.0 - EDGE, 1.0 - cracking / p1 - b
    place = min(max(excess / span, zone / span), 1.0)
    q = c * p1 * 1.185 * math.sqrt(293.15 / t1 * place * (2.0 - place))
    if excess < zone:
        edge, z = zone / span, excess / zone
        q *= z * z * (1.0 + (1.0 - z) * (2.0 - (1.0 - edge) / (2.0 - edge)))
    return q


def gas_at(energy: float, mass: float, volume: float) -> tuple[float, float]:
    """Pressure and temperature."""
    return (KAPPA - 1.0) * energy / volume, energy / (mass * CV)


def gas_start(pressure: float, volume: float) -> list[float]:
    """Energy and mass."""
    return [pressure * volume / (KAPPA - 1.0), pressure * volume / (GAS * WARM)]


class Drive:
    """Piston and body: areas, forces, and the rates of position, speed and deflection."""

    def __init__(self, number: Number, body: str) -> None:
        piston, friction = "cylinder.piston.", f"{body}.friction."
        self.area = 0.25 * math.pi * number[f"{piston}bore"] ** 2
        self.stem = 0.25 * math.pi * number[f"{piston}rod_diameter"] ** 2
        self.ring, self.stroke = self.area - self.stem, number[f"{piston}stroke_length"]
        self.dead = [number[f"cylinder.{side}.dead_volume"] for side in ("cap", "rod")]
        self.first = [number[f"cylinder.{side}.initial_pressure"] for side in ("cap", "rod")]
        self.wall = [number[f"cylinder.{side}.wall_conductance"] for side in ("cap", "rod")]
        seal, hard, loss = (number[piston + n] for n in ("seal_friction", "end_stop.stiffness", "end_stop.dissipation"))
        mass = number[f"{body}.mass"]
        weight = mass * 9.80665 * math.sin(number[f"{body}.inclination"])
        coulomb, static, slow = (number[friction + n] for n in ("coulomb_force", "static_force", "stribeck_velocity"))
        viscous, stiff, micro = (
            number[friction + n] for n in ("viscous_coefficient", "bristle_stiffness", "bristle_damping")
        )
        stroke, stem, exp = self.stroke, self.stem, math.exp

        def moved(force: float, across: float, x: float, v: float, z: float) -> tuple[float, float, float]:
            """Rates under the gas' force on the piston, with the pressure difference across its seals."""
            level = seal * abs(across)
            fading = exp(-((v / slow) ** 2)) if abs(v) < 20.0 * slow else 0.0
            slip = v - stiff * abs(v) / (coulomb + level + (static - coulomb) * fading + 1e-9) * z
            total = force - AIR * stem - weight - (stiff * z + micro * fading * slip + viscous * v)
            if x < 0.0:
                total += stop(-x, -v, hard, loss)
            elif x > stroke:
                total -= stop(x - stroke, v, hard, loss)
            return v, total / mass, slip

        self.moved = moved

    def begin(self) -> list[float]:
        """Both chambers with the piston at the cap."""
        (d1, d2), (p1, p2) = self.dead, self.first
        return gas_start(p1, d1) + gas_start(p2, d2 + self.ring * self.stroke)


def meter_out(number: Number) -> tuple[Rates, list[float], list[float]]:
    """Two switched valves, two lines, one-way flow controls, a cylinder on a mass."""
    drive = Drive(number, "slide")
    (d1, d2), (w1, w2) = drive.dead, drive.wall
    area, ring, stroke, moved = drive.area, drive.ring, drive.stroke, drive.moved
    supply, time = number["supply.pressure"], number["valve_cap.switching_time"]
    fill, vent = number["valve_cap.sonic_conductance"], number["valve_cap.exhaust_conductance"]
    line, warm = number["line_cap.volume"], number["line_cap.wall_conductance"]
    check, cracking = number["check_cap.sonic_conductance"], number["check_cap.cracking_pressure"]
    throttle, b = number["throttle_cap.sonic_conductance"], number["throttle_cap.critical_ratio"]
    k = (KAPPA - 1.0) / line

    def valve(s: float, p: float, t: float) -> tuple[float, float]:
        """Mass and enthalpy into a line through its valve."""
        if s > 0.5:
            q, at = flow(supply, p, WARM, t, fill * min(2.0 * s - 1.0, 1.0), b)
            return q, CP * at * q
        if s < 0.5:
            q, at = flow(p, AIR, t, WARM, vent * min(1.0 - 2.0 * s, 1.0), b)
            return -q, -CP * at * q
        return 0.0, 0.0

    def control(p1: float, p2: float, t1: float, t2: float) -> tuple[float, float]:
        """Mass and enthalpy from a line into its chamber."""
        q, at = flow(p1, p2, t1, t2, throttle, b)
        free = check_flow(p1, p2, t1, check, b, cracking)
        return q + free, CP * (at * q + t1 * free)

    def rates(y: list[float], command: float, other: float) -> tuple[float, ...]:
        s1, s2, pa, ma, pb, mb, u1, m1, u2, m2, x, v, z = y
        p1, t1 = gas_at(u1, m1, d1 + area * x)
        p2, t2 = gas_at(u2, m2, d2 + ring * (stroke - x))
        ta, tb = pa * line / (ma * GAS), pb * line / (mb * GAS)
        qa, ha = valve(s1, pa, ta)
        qb, hb = valve(s2, pb, tb)
        q1, h1 = control(pa, p1, ta, t1)
        q2, h2 = control(pb, p2, tb, t2)
        return (
            min(max(50.0 * (command - s1), -1.0), 1.0) / time, min(max(50.0 * (1.0 - other - s2), -1.0), 1.0) / time,
            k * (ha - h1 + warm * (WARM - ta)), qa - q1, k * (hb - h2 + warm * (WARM - tb)), qb - q2,
            h1 + w1 * (WARM - t1) - p1 * area * v, q1, h2 + w2 * (WARM - t2) + p2 * ring * v, q2,
            *moved(p1 * area - p2 * ring, p1 - p2, x, v, z),
        )  # fmt: skip

    lines = [number[f"{name}.initial_pressure"] for name in ("line_cap", "line_rod")]
    start = [0.0, 1.0, *(each for p in lines for each in (p, p * line / (GAS * WARM)))]
    sizes = [1e-3, 1e-3, 100.0, 1e-6, 100.0, 1e-6, *GAS_SIZES * 2, *BODY_SIZES]
    return rates, [*start, *drive.begin(), 0.0, 0.0, 0.0], sizes


def vertical(number: Number) -> tuple[Rates, list[float], list[float]]:
    """An inlet, a silencer and a leak, a cylinder that carries a load."""
    drive = Drive(number, "load")
    (d1, d2), (w1, w2) = drive.dead, drive.wall
    area, ring, stroke, moved = drive.area, drive.ring, drive.stroke, drive.moved
    inlet, out, leak = (number[f"{n}.sonic_conductance"] for n in ("inlet", "silencer", "cylinder.piston.leakage"))
    supply, b = number["supply.pressure"], number["inlet.critical_ratio"]

    def rates(y: list[float], opening: float) -> tuple[float, ...]:
        u1, m1, u2, m2, x, v, z = y
        p1, t1 = gas_at(u1, m1, d1 + area * x)
        p2, t2 = gas_at(u2, m2, d2 + ring * (stroke - x))
        ql, at = flow(p1, p2, t1, t2, leak, b)
        hl = CP * at * ql
        qo, at = flow(p2, AIR, t2, WARM, out, b)
        ho = CP * at * qo
        qi = hi = 0.0
        if opening:
            qi, at = flow(supply, p1, WARM, t1, inlet * opening, b)
            hi = CP * at * qi
        return (
            hi - hl + w1 * (WARM - t1) - p1 * area * v, qi - ql,
            hl - ho + w2 * (WARM - t2) + p2 * ring * v, ql - qo,
            *moved(p1 * area - p2 * ring, p1 - p2, x, v, z),
        )  # fmt: skip

    return rates, [*drive.begin(), 0.0, 0.0, 0.0], [*GAS_SIZES * 2, *BODY_SIZES]


def cushioned(number: Number) -> tuple[Rates, list[float], list[float]]:
    """A 5/3 valve and a cylinder whose sides are two volumes each."""
    drive = Drive(number, "slide")
    area, ring, stroke, moved = drive.area, drive.ring, drive.stroke, drive.moved
    supply, lag, b = number["supply.pressure"], number["valve.lag"], number["valve.critical_ratio"]
    c1, c2, c3, c4 = (number[f"valve.{n}_conductance"] for n in ("sonic", "supply_b", "exhaust_a", "exhaust_b"))
    names = [f"cylinder.{side}_cushion." for side in ("cap", "rod")]
    (l1, l2), (e1, e2) = ([number[n + each] for n in names] for each in ("length", "closing_length"))
    (a1, a2), (w1, w2) = ([number[n + each] for n in names] for each in ("spear_area", "wall_conductance"))
    (k1, k2), (o1, o2) = ([number[n + each] for n in names] for each in ("sonic_conductance", "open_conductance"))
    (r1, r2), (n1, n2) = ([number[n + each] for n in names] for each in ("check_conductance", "dead_volume"))
    d1, d2 = drive.dead

    def spear(y: float, length: float, closing: float) -> tuple[float, float]:
        """Its way in the bore, and the part of the bore that it closes."""
        if y <= length:
            return y, 1.0
        if y >= length + closing:
            return length + 0.5 * closing, 0.0
        s = (y - length) / closing
        return length + closing * s * (1.0 - s * s * (1.0 - 0.5 * s)), 1.0 - s * s * (3.0 - 2.0 * s)

    def rates(y: list[float], command: float) -> tuple[float, ...]:
        s, u1, m1, u2, m2, u3, m3, u4, m4, x, v, z = y
        way1, shut1 = spear(x, l1, e1)
        way2, shut2 = spear(stroke - x, l2, e2)
        # Ports of cap and rod, and the gas that their cushions trap.
        p1, t1 = gas_at(u1, m1, d1 + a1 * way1)
        p2, t2 = gas_at(u2, m2, d2 + a2 * way2)
        p3, t3 = gas_at(u3, m3, n1 + area * x - a1 * way1)
        p4, t4 = gas_at(u4, m4, n2 + ring * (stroke - x) - a2 * way2)
        q1 = q2 = h1 = h2 = 0.0
        if s > 0.0:
            q1, at = flow(supply, p1, WARM, t1, c1 * min(s, 1.0), b)
            h1 = CP * at * q1
            q2, at = flow(AIR, p2, WARM, t2, c4 * min(s, 1.0), b)
            h2 = CP * at * q2
        elif s < 0.0:
            q2, at = flow(supply, p2, WARM, t2, c2 * min(-s, 1.0), b)
            h2 = CP * at * q2
            q1, at = flow(AIR, p1, WARM, t1, c3 * min(-s, 1.0), b)
            h1 = CP * at * q1
        q3, at = flow(p1, p3, t1, t3, k1 + (1.0 - shut1) * o1 + (r1 if p1 > p3 else 0.0), b)
        h3 = CP * at * q3
        q4, at = flow(p2, p4, t2, t4, k2 + (1.0 - shut2) * o2 + (r2 if p2 > p4 else 0.0), b)
        h4 = CP * at * q4
        b1, b2 = a1 * shut1, a2 * shut2
        force = p3 * (area - b1) + p1 * b1 - p4 * (ring - b2) - p2 * b2
        return (
            (command - s) / lag, h1 - h3 - p1 * b1 * v, q1 - q3, h2 - h4 + p2 * b2 * v, q2 - q4,
            h3 + w1 * (WARM - t3) - p3 * (area - b1) * v, q3, h4 + w2 * (WARM - t4) + p4 * (ring - b2) * v, q4,
            *moved(force, p3 - p4, x, v, z),
        )  # fmt: skip

    (f1, f2), way2 = drive.first, spear(stroke, l2, e2)[0]
    gas = gas_start(f1, d1) + gas_start(f2, d2 + a2 * way2)
    gas += gas_start(f1, n1) + gas_start(f2, n2 + ring * stroke - a2 * way2)
    return rates, [number["valve.initial_position"], *gas, 0.0, 0.0, 0.0], [1e-3, *GAS_SIZES * 4, *BODY_SIZES]


def lift(number: Number) -> tuple[Rates, list[float], list[float]]:
    """A muscle with four slipping threads between fill and vent, and a weight on its table."""
    muscle = Muscle(dict(number), "muscle")
    supply, b = number["supply.pressure"], number["fill.critical_ratio"]
    fill, vent = number["fill.sonic_conductance"], number["vent.sonic_conductance"]
    mass, hard, loss = (number[f"weight.{n}"] for n in ("mass", "lower_stop.stiffness", "lower_stop.dissipation"))
    weight, length, warm = mass * 9.80665 * math.sin(number["weight.inclination"]), muscle.length, muscle.h_a
    reaches = [0.25 * k * muscle.reach for k in (1, 2, 3, 4)]

    def rates(y: list[float], filling: float, venting: float) -> tuple[float, ...]:
        energy, m, s1, s2, s3, s4, x, v = y
        p, t, force, slope = muscle.at(x / length, v, (energy, m), 0.25 * (s1 + s2 + s3 + s4))
        q = h = 0.0
        if filling:
            q, at = flow(supply, p, WARM, t, fill * filling, b)
            h = CP * at * q
        if venting:
            out, at = flow(p, AIR, t, WARM, vent * venting, b)
            q, h = q - out, h - CP * at * out
        slips = (
            v / reach * (1.0 - (s**16 if v * s > 0.0 else 0.0))
            for reach, s in zip(reaches, (s1, s2, s3, s4), strict=True)
        )
        held = stop(-x, -v, hard, loss)
        return h + warm * (WARM - t) - p * slope * v, q, *slips, v, (force + held - weight) / mass

    return rates, [*muscle.begin(0.0), *[0.0] * 6], [0.1, 1e-6, 1.0, 1.0, 1.0, 1.0, 1e-2, 0.1]


def run_of(
    drive: Callable[[Number], tuple[Rates, list[float], list[float]]], names: Sequence[str], place: int, rows: int
) -> Callable[[dict[str, float], float, Signals], np.ndarray]:
    """The state at a place, at every so many milliseconds, under signals of these names; infinite where it fails."""

    def run(number: dict[str, float], tolerance: float, signals: Signals) -> np.ndarray:
        try:
            return course(number, tolerance, signals)
        except (ValueError, OverflowError, ZeroDivisionError):  # a step too bold ends at a negative temperature
            return np.array([math.inf])

    def course(number: dict[str, float], tolerance: float, signals: Signals) -> np.ndarray:
        rates, y, sizes = drive(number)
        driven = list(zip(*(signals[name] for name in names), strict=True))
        jumps = [k for k in range(1, len(driven)) if driven[k] != driven[k - 1]]
        absolute, found = tolerance * np.array(sizes), list[np.ndarray]()

        def plain(t: float, y: np.ndarray, *held: float) -> tuple[float, ...]:
            return rates(y.tolist(), *held)

        for begin, end in zip([0, *jumps], [*jumps, len(driven)], strict=True):
            at = [begin, *(k for k in range(begin + 1, end) if k % rows == 0), end]
            each = odeint(plain, y, 1e-3 * np.array(at), driven[begin], rtol=tolerance, atol=absolute, tfirst=True,
                          mxstep=100000)  # fmt: skip
            found += [row for k, row in zip(at, each, strict=True) if k % rows == 0 and k < end]
            y = each[-1].tolist()
        return np.array([*(row[place] for row in found), y[place]])

    return run


METER_OUT = run_of(meter_out, ("valve_cap.command", "valve_rod.command"), 10, 2)
VERTICAL = run_of(vertical, ("inlet.opening",), 4, 10)
CUSHIONED = run_of(cushioned, ("valve.command",), 9, 1)
LIFT = run_of(lift, ("fill.opening", "vent.opening"), 6, 5)
