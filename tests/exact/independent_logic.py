"""Isothermal network of logic valves, written for SciPy from ISO 6358 and the description of the parts.

It shares no code with the package.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

DENSITY, TEMPERATURE, GAS_CONSTANT, AMBIENT = 1.185, 293.15, 287.05, 1e5
LINEAR = 1e-5
"""Range of 1 - p2/p1 in which the flow is linear, because its slope is infinite at zero."""


def flow(first: float, second: float, conductance: float, ratio: float, cracking: float = 0.0) -> float:
    """Mass flow rate at 20 degC by ISO 6358-1 [kg/s]; negative from the second to the first side."""
    if second > first:
        return -flow(second, first, conductance, ratio, cracking)
    quotient, closed = second / first, 1.0 - cracking / first
    if quotient >= closed:
        return 0.0
    choked = conductance * DENSITY * first
    if quotient <= ratio:
        return choked
    edge = closed - LINEAR
    fraction = np.sqrt(max(1.0 - ((min(quotient, edge) - ratio) / (closed - ratio)) ** 2, 0.0))
    return float(choked * fraction * min((closed - quotient) / LINEAR, 1.0))


def one_way(first: float, second: float, *size: float) -> float:
    return max(flow(first, second, *size), 0.0)


@dataclass
class Element:
    """Closing element with friction (0.8 of the switching pressure) that a detent (0.2) holds at its seats.

    Its speed is proportional to the remaining drive, up to 1/T. It covers the last 1/50 of its travel exponentially.
    """

    drive: Callable[[Mapping[str, float]], float]  # pressure difference towards position 1 [Pa]
    switching_pressure: float
    switching_time: float

    def speed(self, position: float, pressures: Mapping[str, float]) -> float:
        drive = self.drive(pressures) / self.switching_pressure
        excess = np.sign(drive) * max(abs(drive) - 0.8, 0.0) + 0.2 * (2.0 * position - 1.0)
        toward_0, toward_1 = min(50.0 * position, 1.0), min(50.0 * (1.0 - position), 1.0)
        return float(np.clip(excess, -toward_0, toward_1)) / self.switching_time


Flows = Callable[[Mapping[str, float], Mapping[str, float]], Mapping[str, float]]


def simulate(
    volumes: Mapping[str, float], prescribed: Mapping[str, tuple[Any, Any]], elements: Mapping[str, Element],
    flows: Flows, grid: Any,
) -> dict[str, Any]:  # fmt: skip
    """Return the pressures of all chambers, at first 1 bar, and the positions of all elements, at first 0.

    `prescribed` contains times and values of piecewise linear pressures. `flows` returns the flows into the chambers
    for pressures and positions.
    """
    names = [*volumes, *elements]
    capacity = np.array([*volumes.values()]) / (GAS_CONSTANT * TEMPERATURE)

    def rates(time: float, state: Any) -> Any:
        pressures = {name: float(np.interp(time, *table)) for name, table in prescribed.items()}
        pressures |= dict(zip(volumes, state, strict=False)) | {"ambient": AMBIENT}
        positions = dict(zip(elements, state[len(volumes) :], strict=True))
        inflow = flows(pressures, positions)
        speeds = [element.speed(positions[name], pressures) for name, element in elements.items()]
        return np.array([*(np.array([inflow[name] for name in volumes]) / capacity), *speeds])

    start = np.array([*(AMBIENT for _ in volumes), *(0.0 for _ in elements)])
    run = solve_ivp(rates, (0.0, grid[-1]), start, "LSODA", t_eval=grid, rtol=1e-8, atol=1e-6, max_step=2e-4)
    return dict(zip(names, run.y, strict=True))
