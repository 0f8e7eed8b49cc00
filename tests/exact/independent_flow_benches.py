"""Random steady flow benches with known truth; NumPy only, nothing of `poppet`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

DENSITY, REFERENCE = 1.185, 293.15  # of ISO 6358: kg/m^3 at 20 degC, 1 bar and 65 % humidity; K
KINDS = (
    "stated", "scatter unknown", "uncalibrated", "three times", "gauge", "ambient", "four ratios", "cracking",
    "few points", "half too small",
)  # fmt: skip
KILO = 1e3


def law(p_1, p_2, temperature, conductance, ratio, index=0.5, cracking=0.0):
    """Return the flow of ISO 6358-1 [kg/s], with a cracking pressure [Pa]."""
    position = np.clip((p_2 / p_1 - ratio) / (1.0 - cracking / p_1 - ratio), 0.0, 1.0)
    return conductance * p_1 * DENSITY * np.sqrt(REFERENCE / temperature) * (1.0 - position**2) ** index


@dataclass(frozen=True)
class FlowBench:
    """Readings of one bench, the truth, and the uncertainties that its operator states."""

    kind: str
    truth: dict[str, float]
    readings: dict[str, Any]  # mass_flow_rate, pressure_1, pressure_2, temperature_1 in SI units
    stated: dict[str, dict[str, float]]  # absolute, relative, offset, calibration by channel


def draw(seed: int, kind: str) -> FlowBench:
    """Return a random bench of one kind."""
    g = np.random.default_rng([seed, KINDS.index(kind)])
    truth = {"sonic_conductance": 10.0 ** g.uniform(-9.5, -7.5), "critical_ratio": g.uniform(0.15, 0.55)}
    n = int(g.integers(5, 9) if kind == "few points" else g.integers(10, 25))
    supply = g.uniform(4e5, 9e5)
    ambient = g.uniform(0.95e5, 1.03e5)
    if kind in ("ambient", "gauge"):  # the inlet pressure changes
        p_1 = ambient / np.linspace(g.uniform(0.12, 0.2), g.uniform(0.85, 0.95), n)
        p_2 = np.full(n, ambient)
        if kind == "gauge":  # downstream throttle, at one inlet pressure or at two
            levels = np.where(np.arange(n) % 2, supply, 0.6 * supply) if seed % 2 else np.full(n, supply)
            p_1 = levels * (1.0 + 0.01 * g.standard_normal(n))
            p_2 = np.maximum(p_1 * np.linspace(0.05, 0.93, n), ambient)
    elif kind == "four ratios":
        n, ratios = 8, np.repeat([0.2, g.uniform(0.45, 0.6), g.uniform(0.65, 0.78), g.uniform(0.82, 0.92)], 2)
        p_1 = supply * (1.0 + 0.005 * g.standard_normal(n))
        p_2 = ratios * p_1
    else:
        p_1 = supply * (1.0 + 0.005 * g.standard_normal(n))
        p_2 = np.maximum(np.linspace(0.1, g.uniform(0.88, 0.96), n) * p_1, ambient)
    cracking = g.uniform(0.01, 0.05) * supply if kind == "cracking" else 0.0
    truth["cracking_pressure"] = cracking
    temperature = 293.15 + g.uniform(-5.0, 5.0) + 0.2 * g.standard_normal(n)
    q = law(p_1, p_2, temperature, truth["sonic_conductance"], truth["critical_ratio"], cracking=cracking)
    relative, calibration = 10.0 ** g.uniform(-3.0, -2.0), 10.0 ** g.uniform(-2.5, -2.0)
    noise, offset = g.uniform(100.0, 600.0), g.uniform(200.0, 1000.0)
    stated = {
        "mass_flow_rate": {"relative": relative, "calibration": calibration},
        "pressure_1": {"absolute": noise, "offset": offset},
        "pressure_2": {"absolute": noise, "offset": offset},
        "temperature_1": {"absolute": 0.2, "offset": 0.5},
    }
    spread = {"three times": 3.0, "half too small": 1.5}.get(kind, 1.0)
    readings = {
        "mass_flow_rate": q
        * (1.0 + calibration * g.standard_normal())
        * (1.0 + spread * relative * g.standard_normal(n)),
        "pressure_1": p_1 + offset * g.standard_normal() + spread * noise * g.standard_normal(n),
        "pressure_2": p_2 + offset * g.standard_normal() + spread * noise * g.standard_normal(n),
        "temperature_1": temperature + 0.5 * g.standard_normal() + 0.2 * g.standard_normal(n),
    }
    if kind == "ambient" and seed % 2:  # the open port has no sensor: one barometer reading
        readings["pressure_2"] = ambient + noise * g.standard_normal()
        stated["pressure_2"] = {"absolute": noise}
    if kind in ("scatter unknown", "few points"):
        del stated["mass_flow_rate"]["relative"]
    if kind == "uncalibrated" or (kind == "three times" and seed % 2):
        stated = {
            channel: {key: value for key, value in row.items() if key in ("absolute", "relative")}
            for channel, row in stated.items()
        }
    if kind == "gauge":  # gauge values in the file, read as absolute
        readings["pressure_1"] = readings["pressure_1"] - ambient
        readings["pressure_2"] = np.maximum(readings["pressure_2"] - ambient, 0.0)
    return FlowBench(kind, truth, readings, stated)
