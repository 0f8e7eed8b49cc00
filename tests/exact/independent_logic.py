"""Isothermal network of logic valves, written for SciPy from ISO 6358 and the description of the parts.

It shares no code with the package. The closing elements are discrete: an element at a seat leaves it at an event of
the pressures, and then moves at constant speed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
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
    """Closing element: its drive for pressures by name, switching pressure and time, and direction of its motion."""

    drive: Callable[[dict[str, float]], float]  # pressure difference towards position 1 [Pa]
    switching_pressure: float
    switching_time: float
    position: float = 0.0
    direction: int = 0


@dataclass
class Network:
    """Chambers, prescribed pressures, closing elements, and a function that returns the flows into the chambers."""

    volumes: dict[str, float]
    prescribed: dict[str, tuple[Any, Any]]  # times and values of piecewise linear pressures
    elements: dict[str, Element]
    flows: Callable[[dict[str, float], dict[str, float]], dict[str, float]]
    switching: list[tuple[float, str, int]] = field(default_factory=list)  # time, element, direction

    def run(self, start: dict[str, float], grid: Any) -> dict[str, Any]:
        """Return the pressures and positions on a grid of times [s]."""
        names, moving = list(self.volumes), list(self.elements)
        capacity = np.array([self.volumes[name] for name in names]) / (GAS_CONSTANT * TEMPERATURE)
        state = np.array([*(start[name] for name in names), *(e.position for e in self.elements.values())])
        corners = {float(t) for times, _ in self.prescribed.values() for t in times} | {float(grid[-1])}
        time, rows = 0.0, {0.0: state}

        def pressures(t: float, y: Any) -> dict[str, float]:
            known = {name: float(np.interp(t, *table)) for name, table in self.prescribed.items()}
            return known | dict(zip(names, y, strict=False)) | {"ambient": AMBIENT}

        def rates(t: float, y: Any) -> Any:
            positions = dict(zip(moving, y[len(names) :], strict=True))
            inflow = self.flows(pressures(t, y), positions)
            speeds = [self.elements[name].direction / self.elements[name].switching_time for name in moving]
            return np.array([*(np.array([inflow[name] for name in names]) / capacity), *speeds])

        def event(name: str, k: int) -> Any:
            element = self.elements[name]

            def value(t: float, y: Any) -> float:
                position, drive = y[len(names) + k], element.drive(pressures(t, y)) / element.switching_pressure
                if element.direction == 0:
                    return drive - 1.0 if position < 0.5 else -1.0 - drive
                end = position - 1.0 if element.direction > 0 else -position
                # It turns back if the drive no longer exceeds the balance at its position.
                return max(end, -(drive + 2.0 * position - 1.0) * element.direction - 1e-3)

            value.terminal, value.direction = True, 1.0  # type: ignore[attr-defined]
            return value

        for corner in sorted(corners):
            while corner > time:
                times = grid[(grid > time) & (grid <= corner)]
                events = [event(name, k) for k, name in enumerate(moving)]
                # An event that is due at the start of an interval has no crossing in it.
                due = [k for k, e in enumerate(events) if e(time, state) >= 0.0]
                if not due:
                    run = solve_ivp(
                        rates, (time, corner), state, "LSODA", dense_output=True, events=events, rtol=1e-8, atol=1e-6,
                        max_step=1e-3,
                    )  # fmt: skip
                    rows |= {t: run.sol(t) for t in times[times <= run.t[-1]]}
                    due = [k for k, crossings in enumerate(run.t_events) if len(crossings)]
                    time = run.t_events[due[0]][0] if due else corner
                    state = (run.y_events[due[0]][0] if due else run.y[:, -1]).copy()
                for k in due:
                    self._switch(moving[k], state, len(names) + k, time)
        table = np.array([rows[t] for t in grid])
        return dict(zip([*names, *moving], table.T, strict=True))

    def _switch(self, name: str, state: Any, row: int, time: float) -> None:
        element = self.elements[name]
        if element.direction == 0:
            element.direction = 1 if state[row] < 0.5 else -1
            self.switching.append((time, name, element.direction))
        elif min(abs(state[row]), abs(state[row] - 1.0)) < 1e-9:
            state[row], element.direction = round(state[row]), 0
        else:
            element.direction = -element.direction
