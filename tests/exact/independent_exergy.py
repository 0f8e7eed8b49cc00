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

from scipy.integrate import solve_ivp

sys.path.insert(0, str(Path(__file__).parent))
from independent_sequences import AMBIENT, CP, CV, GAS, KAPPA, WARM, flow

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
