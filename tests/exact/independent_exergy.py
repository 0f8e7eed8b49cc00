"""Exergy balances of a tank that empties or fills through one flow path, by closed forms and by SciPy quadrature only.

The reference state is that of the ambient, p_a = 1 bar and T_a = 293.15 K. With the specific flow exergy e(p, T), a
mass flow q from an upstream state (p_1, T_1) to the pressure p_2 has these terms:

    throttling   q [e(p_1, T_1) - e(p_2, T_1)]     the enthalpy, hence the temperature, does not change
    exhausted    q e(p_a, T_1)                     into the ambient: the rest is thermal
    supplied     q e(p_s, T_s)                     from a reservoir
    mixing       T_a times the entropy that arises as gas of T_1 mixes with gas of T at the same pressure
    heat         T_a times the entropy that arises as heat Q flows from a wall at T_a to gas at T: Q (T_a/T - 1)

The terms are positive losses. `supplied` equals the sum of all others and of the increase in the exergy of the gas in
the tank, m [c_v (T - T_a) - T_a (s - s_a)] + p_a (V - m R T_a/p_a).
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

from scipy.integrate import simpson, solve_ivp

sys.path.insert(0, str(Path(__file__).parent))
from independent_exhaust import Numbers, Plant, Run, elasto_plastic
from independent_sequences import AMBIENT, CP, CV, GAS, KAPPA, WARM, flow, stop_force

TERMS = "supplied", "throttling", "exhausted", "mixing", "heat"


def flow_exergy(p: float, t: float) -> float:
    """Return the specific flow exergy [J/kg]."""
    return CP * (t - WARM) - WARM * (CP * math.log(t / WARM) - GAS * math.log(p / AMBIENT))


def enclosed_exergy(p: float, t: float, volume: float) -> float:
    """Return the exergy of the gas in a volume [J]."""
    mass = p * volume / (GAS * t)
    entropy = CP * math.log(t / WARM) - GAS * math.log(p / AMBIENT)
    return mass * (CV * (t - WARM) - WARM * entropy) + AMBIENT * volume - mass * GAS * WARM


def adiabatic_discharge(volume: float, p0: float, mass_ratio: float) -> dict[str, float]:
    """Return the exergy terms of an adiabatic discharge to the ambient, from p0 and T_a, to a fraction of the mass.

    The gas in the tank expands isentropically: T = T_a r^(kappa - 1) and p = p0 r^kappa with the mass ratio r. The
    integrals over the mass do not depend on the flow path.
    """
    r, mass, k = mass_ratio, p0 * volume / (GAS * WARM), KAPPA - 1.0
    out = 1.0 - r
    logarithm = r - 1.0 - r * math.log(r)  # of -ln over the mass that leaves, negative below
    throttling = GAS * WARM * mass * (out * math.log(p0 / AMBIENT) + KAPPA * logarithm)
    warm = CP * WARM * mass * ((1.0 - r**KAPPA) / KAPPA - out)
    thermal = warm - WARM * CP * mass * k * logarithm
    t, p = WARM * r**k, p0 * r**KAPPA
    stored = enclosed_exergy(p, t, volume) - enclosed_exergy(p0, WARM, volume)
    return {"throttling": throttling, "exhausted": thermal, "stored": stored}


def tank(
    volume: float, p0: float, c: float, b: float, wall: float, duration: float, supply: float | None = None
) -> dict[str, float]:
    """Return final pressure and temperature, and the exergy terms of a tank.

    The tank empties to the ambient, or fills from a reservoir with the pressure `supply`.
    """

    def rates(_: float, y: list[float]) -> list[float]:
        energy, mass = y[:2]
        p, t = (KAPPA - 1.0) * energy / volume, energy / (mass * CV)
        heat = wall * (WARM - t)
        if supply is None:
            q, h = flow(p, AMBIENT, t, WARM, c, b)
            terms = [0.0, q * (flow_exergy(p, t) - flow_exergy(AMBIENT, t)), q * flow_exergy(AMBIENT, t), 0.0]
            q, h = -q, -h
        else:
            q, h = flow(supply, p, WARM, t, c, b)
            # Of the flow with the temperature of the supply: enthalpy over T minus the difference of the entropies.
            entropy = q * (CP * (WARM / t - 1.0) - CP * math.log(WARM / t))
            terms = [q * flow_exergy(supply, WARM), q * GAS * WARM * math.log(supply / p), 0.0, WARM * entropy]
        return [h + heat, q, *terms, heat * (WARM / t - 1.0)]

    start = [p0 * volume / (KAPPA - 1.0), p0 * volume / (GAS * WARM), *[0.0] * len(TERMS)]
    solution = solve_ivp(rates, (0.0, duration), start, "LSODA", rtol=1e-11, atol=1e-12, max_step=duration / 200.0)
    energy, mass, *terms = solution.y[:, -1]
    p, t = (KAPPA - 1.0) * energy / volume, energy / (mass * CV)
    stored = enclosed_exergy(p, t, volume) - enclosed_exergy(p0, WARM, volume)
    return dict(zip(TERMS, map(float, terms), strict=True)) | {"stored": stored, "p": float(p), "t": float(t)}


def machine_terms(machine: Numbers, run: Run, start: float, end: float) -> dict[str, float]:
    """Return the exergy terms of a machine without faults between two times of a run, by Simpson's rule over its rows.

    The keys are a term and a name: `throttling valveA.supply_a`, `mixing rail`, `friction slideA`, `supplied supply`.
    """
    plant = Plant(machine)
    rows = [k for k, time in enumerate(run.time) if start - 1e-9 <= time <= end + 1e-9]
    table = [_rates_of_terms(plant, run.states[k].tolist()) for k in rows]
    times = run.time[rows]
    terms = {key: float(simpson([row[key] for row in table], x=times)) for key in table[0]}
    first, last = (_exergies(plant, run.states[rows[k]].tolist()) for k in (0, -1))
    return terms | {f"stored {name}": last[name] - first[name] for name in first}


def _rates_of_terms(plant: Plant, y: list[float]) -> dict[str, float]:
    p, t = plant.gas(y)
    terms = dict.fromkeys((f"mixing {name}" for name in plant.volumes), 0.0)
    for passage in plant.flows(y, p, t):
        q, source, target = passage.mass, passage.source, passage.target
        temperature = passage.enthalpy / (CP * q) if q else WARM
        terms[f"throttling {passage.name}"] = GAS * WARM * q * math.log(p[source] / p[target])
        for node, sign in ((source, -1.0), (target, 1.0)):
            if node not in plant.volumes:
                name = f"exhausted {passage.name}" if node == "ambient" else f"supplied {node}"
                terms[name] = (1.0 if node == "ambient" else -1.0) * sign * q * flow_exergy(p[node], temperature)
            elif q:
                entropy = CP * (temperature / t[node] - 1.0 - math.log(temperature / t[node]))
                terms[f"mixing {node}"] += sign * q * WARM * entropy
    for name, heat in plant.heats(t).items():
        terms[f"heat {name}"] = heat * (WARM / t[name] - 1.0)
    for k, (name, drive) in enumerate(plant.machine["drives"].items()):
        x, v, z = y[plant.first_drive + 3 * k : plant.first_drive + 3 * k + 3]
        terms[f"friction slide{name}"] = elasto_plastic(drive, v, z)[0] * v
        terms[f"stops cylinder{name}"] = -(stop_force(-x, -v) - stop_force(x - drive["stroke"], v)) * v
        terms[f"work slide{name}"] = drive["load"] * v
    return terms


def _exergies(plant: Plant, y: list[float]) -> dict[str, float]:
    """Return the exergy of the gas in each volume, and the kinetic energies."""
    p, t = plant.gas(y)
    values = {}
    for k, name in enumerate(plant.volumes):
        values[name] = enclosed_exergy(p[name], t[name], y[2 * k + 1] * GAS * t[name] / p[name])
    for k, (name, drive) in enumerate(plant.machine["drives"].items()):
        values[f"motion {name}"] = 0.5 * drive["mass"] * y[plant.first_drive + 3 * k + 1] ** 2
    return values
