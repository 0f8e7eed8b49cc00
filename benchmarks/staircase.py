"""Speed on the paper's staircase against SciPy's LSODA, side by side in one run.

Both simulate the main stage of the paper filling and emptying a 0.2 m3 tank with wall heat: 120 s, pilot pressure in
six steps, rows every 0.1 s, five states (stroke, velocity, tank pressure and mass, heat). LSODA gets a right-hand side
in plain floats, written as a careful user would, restarted at every step of the pilot pressure, with tolerances per
state. Both must be within 1e-6 of a tight reference in pressure; ours runs at its default tolerance.
"""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp

import poppet
from poppet.simulate import solve

TIMES = [0.0, 20.0, 40.0, 60.0, 80.0, 100.0]
PILOT = [1e5, 2e5, 3e5, 4e5, 5e5, 0.0]
CIRCUIT = """
title = "paper staircase"
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.room]
kind = "reservoir"
pressure = "1 bar"
[parts.valve]
kind = "main_stage"
data = "varga2012"
supply = "supply"
outlet = "tank"
exhaust = "room"
[parts.tank]
kind = "chamber"
volume = "0.2 m^3"
wall_conductance = "45 W/K"
[signals."valve.pilot_pressure"]
kind = "steps"
times = [0, 20, 40, 60, 80, 100]
values = ["1 bar g", "2 bar g", "3 bar g", "4 bar g", "5 bar g", "0 bar g"]
[run]
duration = "120 s"
output_step = "0.1 s"
"""


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
    rows, y = [], start
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


def interleaved(contestants: dict[str, Callable[[], object]], rounds: int) -> dict[str, float]:
    """Median wall time of each contestant, taken in turns."""
    times: dict[str, list[float]] = {name: [] for name in contestants}
    for _ in range(rounds):
        for name, run in contestants.items():
            begin = time.perf_counter()
            run()
            times[name].append(time.perf_counter() - begin)
    return {name: statistics.median(values) for name, values in times.items()}


def main() -> None:
    from poppet.circuit_file import loads

    circuit = loads(CIRCUIT)
    tight = circuit.simulate(relative_tolerance=1e-12)["tank.pressure"]
    rates = peer_rates(circuit.parameters)
    start = [0.0, 0.0, 1e5, 1e5 * 0.2 / (287.05 * 293.15), 0.0]

    def error(pressure: np.ndarray) -> float:
        return float(np.max(np.abs(pressure / tight - 1.0)))

    tolerance = 1e-5
    while error(peer_run(rates, start, tolerance)[2]) > 1e-6:
        tolerance /= 2.0
    problem = circuit.problem(circuit.run)
    volumes = [0.2 * (1.0 + 1e-3 * k) for k in range(1000)]

    def changed() -> None:
        circuit.with_values({"tank.volume": volumes.pop()}).simulate()

    recording = circuit.simulate()
    contestants = {
        "SciPy LSODA": lambda: peer_run(rates, start, tolerance),
        "circuit.simulate()": circuit.simulate,
        "kernel with outputs": lambda: solve(problem),
        "a number changed, simulate()": changed,
    }
    interleaved(contestants, 2)
    times = interleaved(contestants, 21)
    base = times["SciPy LSODA"]
    print(f"poppet {poppet.__version__}; paper staircase, 120 s, 1201 rows, {len(recording)} outputs")
    print(f"error in pressure: LSODA {error(peer_run(rates, start, tolerance)[2]):.2g} (rtol {tolerance:.2g}), ", end="")
    print(f"poppet {error(recording['tank.pressure']):.2g} (default tolerance)")
    print(f"steps: {recording.statistics}")
    print(f"{'':30s} {'median ms':>10s} {'times faster':>13s}")
    for name, seconds in times.items():
        print(f"{name:30s} {1e3 * seconds:10.3f} {base / seconds:13.1f}")


if __name__ == "__main__":
    main()
