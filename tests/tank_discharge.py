"""Discharge of a tank through a valve by ISO 6358, with SciPy alone, and files of it as loggers write them."""

from __future__ import annotations

from datetime import datetime, timedelta
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

R, KAPPA, RHO0, T0 = 287.05, 1.4, 1.185, 293.15
CV = R / (KAPPA - 1.0)
TRUTH = {"C": 1.1e-8, "b": 0.32, "wall": 6.0}
VOLUME, AMBIENT, ROOM = 0.020, 98700.0, 294.15
REST = 2.3
"""Time before the valve opens [s]."""


def flow(p: float, temperature: float, ambient: float, c: float, b: float) -> float:
    """Mass flow rate from pressure p to the ambient [kg/s]."""
    ratio = ambient / p
    if ratio >= 1.0:
        return 0.0
    subsonic = 1.0 if ratio <= b else np.sqrt(1.0 - ((ratio - b) / (1.0 - b)) ** 2)
    return float(c * p * RHO0 * np.sqrt(T0 / temperature) * subsonic)


def discharge(
    duration: float = 40.0, step: float = 0.1, start: float = 7.0e5, closes: float = np.inf, wall: float = TRUTH["wall"]
) -> tuple[np.ndarray, np.ndarray]:
    """Time from the first sample [s], and absolute pressure [Pa].

    The valve opens after `REST`, and closes at a time from the first sample.
    """

    def rates(t: float, state: np.ndarray) -> list[float]:
        mass, energy = state
        temperature = energy / (mass * CV)
        q = flow(mass * R * temperature / VOLUME, temperature, AMBIENT, TRUTH["C"], TRUTH["b"])
        q = q if t < closes - REST else 0.0
        return [-q, -q * KAPPA * CV * temperature + wall * (ROOM - temperature)]

    time = np.arange(0.0, duration, step)
    after = time[time >= REST] - REST
    mass = start * VOLUME / (R * ROOM)
    solution = solve_ivp(
        rates, (0.0, after[-1]), [mass, mass * CV * ROOM], "LSODA", after, rtol=1e-9, atol=1e-12, max_step=0.5
    )
    emptying = solution.y[1] * (KAPPA - 1.0) / VOLUME
    return time, np.concatenate([np.full(np.count_nonzero(time < REST), start), emptying])


def noisy_gauge(seed: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """Time [s] and gauge pressure [bar] with a noise of 3 mbar."""
    time, pressure = discharge()
    gauge = (pressure - AMBIENT) / 1e5
    return time, gauge + np.random.default_rng(seed).normal(0.0, 0.003, gauge.size)


def excel_export(path: Path, heading: str = "Druck Kessel", unit: str = "[bar]") -> Path:
    """Write an export as of a German spreadsheet, over midnight.

    It has a byte order mark, semicolons, decimal commas, clock times, a title, and a line with the units.
    """
    time, gauge = noisy_gauge()
    start = datetime(2026, 11, 28, 23, 59, 50, 200000)
    rows = ["Prüfstand 3;;;", f"Uhrzeit;{heading};Temperatur Raum;Bemerkung", f";{unit};[°C];"]
    for t, p in zip(time, gauge, strict=True):
        moment = start + timedelta(seconds=float(t))
        stamp = f"{moment:%H:%M:%S},{moment.microsecond // 1000:03d}"
        rows.append(f"{stamp};{p:.4f};{21.0:.1f};".replace(".", ","))
    path.write_text("\r\n".join(rows) + "\r\n", encoding="utf-8-sig", newline="")
    return path


def logger_file(path: Path) -> Path:
    """Write a file of a logger with times in milliseconds under a heading without a unit, and pressures in mbar."""
    time, gauge = noisy_gauge()
    rows = [f"{1e3 * t + 5000:.0f},{1e3 * p:.1f}" for t, p in zip(time, gauge, strict=True)]
    path.write_text("\n".join(["Zeit,p1", *rows]) + "\n")
    return path
