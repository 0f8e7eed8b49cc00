"""Watch of the pneumatic valve that wears: a leak at the bottom port that grows, and its size by the twin."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

import poppet
from exact.independent_wear_valve import GAS_CONSTANT, TEMPERATURE, Wear, record
from exact.wear_valve_twin import twin
from poppet.timeseries.recording import Recording

PERIOD = 0.1  # of the samples [s]
CYCLE = 20.0  # the valve opens and closes once [s]
NOISE = {"stem.position": 1e-4, "actuator.cap.pressure": 1e4, "actuator.rod.pressure": 1e3}  # [m], [Pa], [Pa]
PORT = 0.62e-5  # effective area of a port [m^2]
FAULTS: dict[str, Any] = {
    "bottom_leak": {"address": "bottom_leak.sonic_conductance", "direction": "up", "alarm": 1e-10},
    "seal_leak": {"address": "actuator.leakage.sonic_conductance", "direction": "up", "alarm": 1e-10},
    "spring": {"address": "actuator.spring.rate", "direction": "down", "alarm": "500 N/m"},
}
NUISANCE: dict[str, Any] = {
    "supply.pressure": {"relative_sigma": 0.002},
    "open.sonic_conductance": {"relative_sigma": 0.02},
    "close.sonic_conductance": {"relative_sigma": 0.02},
}


class Result(NamedTuple):
    """Watched growth of a leak; sizes as effective areas [m^2]."""

    time: np.ndarray
    true: np.ndarray
    size: np.ndarray
    sigma: np.ndarray
    alarms: tuple[str, ...]


def conductance_per_area() -> float:
    """Return C per effective area of a nozzle with nitrogen at 293 K, in C of ISO 6358 (rho_0 = 1.185 kg/m^3)."""
    choked = np.sqrt(1.4 / (GAS_CONSTANT * TEMPERATURE)) * (2 / 2.4) ** 3
    return float(choked / 1.185)


def rows(duration: float, wear: Wear, seed: int) -> tuple[np.ndarray, dict[str, np.ndarray], Recording]:
    """Return time, true values and noisy readings of a valve that opens and closes."""
    time = PERIOD * np.arange(round(duration / PERIOD))
    opens = (time % CYCLE < CYCLE / 2).astype(float)
    true = record(opens, PERIOD, wear)
    generator = np.random.default_rng(seed)
    readings = [true[k] + sigma * generator.standard_normal(time.size)
                for k, sigma in zip(("x", "bottom", "top"), NOISE.values(), strict=True)]  # fmt: skip
    names = (*NOISE, "open.opening", "close.opening")
    units = ("m", "Pa", "Pa", "1", "1")
    return time, true, Recording(time, names, units, np.array([*readings, opens, 1.0 - opens]))


def new_watch(baseline: Any = None, nuisance: dict[str, Any] = NUISANCE) -> Any:
    """Return the watch of the valve."""
    conductance = PORT * conductance_per_area()
    circuit = twin({"sonic_conductance": conductance, "critical_ratio": 0.528}, 1e6)
    measured: dict[str, Any] = {name: {"noise": noise} for name, noise in NOISE.items()}
    measured |= {"open.opening": {}, "close.opening": {}}
    settings = {"window": "40 s", "alarm_delay": "1 s"}
    return poppet.watch(circuit, measured=measured, faults=FAULTS, nuisance=nuisance, baseline=baseline, **settings)


def evaluate(
    growth: float,
    start: float = 200.0,
    duration: float = 600.0,
    seed: int = 3,
    nuisance: dict[str, Any] = NUISANCE,
) -> Result:
    """Watch a leak that grows from a time [m^2/s], with a baseline from 200 s of another healthy recording."""
    watch = new_watch(nuisance=nuisance)
    watch.commission(rows(200.0, Wear(), seed=1000)[2])
    time, true, recording = rows(duration, Wear(bottom_growth=growth, start=start), seed)
    result = watch.run(recording)
    factor = 1.0 / conductance_per_area()
    size, sigma = result.values[:, 0] * factor, result.sigmas[:, 0] * factor
    leak = np.interp(result.time, time, true["bottom_leak"])
    return Result(result.time, leak, size, sigma, result.alarms)
