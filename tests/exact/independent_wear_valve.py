"""A pneumatic valve that wears, rebuilt from its published equations; shares no code with the package.

A piston with a return spring opens a valve for a liquid. Its chambers are connected to supply or atmosphere. The
equations are those of M. Daigle, K. Goebel, "A model-based prognostics approach applied to pneumatic valves",
International Journal of Prognostics and Health Management 2 (2), 2011; the values are the defaults of the model
`PneumaticValveWithWear` of ProgPy 1.9. That model starts with leaks to the atmosphere as large as the inlets; here,
the leaks are arguments.

The gas is isothermal nitrogen, and passages are ideal nozzles with a discharge coefficient. Leaks have none.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit

GAS_CONSTANT, TEMPERATURE, EXPONENT = 8.314 / 28.01e-3, 293.0, 1.4
ATMOSPHERE, SUPPLY = 101325.0, 5.272420892278395e6  # [Pa]
MASS, GRAVITY = 50.0, 9.81
SPRING, PRELOAD, STROKE = 48000.0, 0.254, 0.0381  # [N/m], [m], [m]
FRICTION = 6000.0  # viscous [N s/m]
AREA, DEAD_VOLUME = 8.1073196655599634694e-3, 8.107319665559963e-4  # of the piston [m^2], of each chamber [m^3]
PORT_AREA, DISCHARGE = 1e-5, 0.62
STEP = 1e-3  # [s]


@dataclass(frozen=True)
class Wear:
    """Leak areas [m^2] at the start, and their growth [m^2/s] from a time [s]; stiffness and friction as factors."""

    bottom: float = 0.0
    top: float = 0.0
    internal: float = 0.0
    bottom_growth: float = 0.0
    top_growth: float = 0.0
    internal_growth: float = 0.0
    start: float = 0.0
    spring: float = 1.0
    friction: float = 1.0


def record(opens: np.ndarray, period: float, wear: Wear = Wear()) -> dict[str, np.ndarray]:
    """Simulate the valve with one command per period, 1 to open and 0 to close, and return one row per period.

    The bottom chamber is connected to the supply by 1, and to the atmosphere by 0. The top chamber is always connected
    to the atmosphere: the spring closes the valve.
    """
    per_row = round(period / STEP)
    out = np.empty((opens.size, 6))
    numbers = np.array([
        wear.bottom, wear.top, wear.internal, wear.bottom_growth, wear.top_growth, wear.internal_growth, wear.start,
        wear.spring * SPRING, wear.friction * FRICTION,
    ])  # fmt: skip
    _simulate(opens.astype(float), per_row, numbers, out)
    return dict(zip(("x", "bottom", "top", "bottom_leak", "top_leak", "internal_leak"), out.T, strict=True))


@njit(cache=True)
def _nozzle(p_in, p_out, area):
    """Return the mass flow [kg/s] through an ideal nozzle, in both directions."""
    high, low = max(p_in, p_out), min(p_in, p_out)
    ratio = max(low / high, (2.0 / (EXPONENT + 1.0)) ** (EXPONENT / (EXPONENT - 1.0)))
    root = ratio ** (2.0 / EXPONENT) - ratio ** ((EXPONENT + 1.0) / EXPONENT)
    flow = area * high * np.sqrt(2.0 * EXPONENT / (EXPONENT - 1.0) / (GAS_CONSTANT * TEMPERATURE) * max(root, 0.0))
    return flow if p_in >= p_out else -flow


@njit(cache=True)
def _rates(y, source, leaks, spring, friction, rate):
    x, v, bottom, top = y
    volume_bottom, volume_top = DEAD_VOLUME + AREA * x, DEAD_VOLUME + AREA * (STROKE - x)
    p_bottom = bottom * GAS_CONSTANT * TEMPERATURE / volume_bottom
    p_top = top * GAS_CONSTANT * TEMPERATURE / volume_top
    inner = _nozzle(p_top, p_bottom, leaks[2])
    force = (p_bottom - p_top) * AREA - MASS * GRAVITY - friction * v - spring * (PRELOAD + x)
    if (x <= 0.0 and force < 0.0) or (x >= STROKE and force > 0.0):
        force, v = 0.0, 0.0
    rate[0], rate[1] = v, force / MASS
    rate[2] = _nozzle(source, p_bottom, DISCHARGE * PORT_AREA) + inner - _nozzle(p_bottom, ATMOSPHERE, leaks[0])
    rate[3] = _nozzle(ATMOSPHERE, p_top, DISCHARGE * PORT_AREA) - inner - _nozzle(p_top, ATMOSPHERE, leaks[1])
    return p_bottom, p_top


@njit(cache=True)
def _simulate(opens, per_row, numbers, out):
    gas = ATMOSPHERE / (GAS_CONSTANT * TEMPERATURE)
    y = np.array([0.0, 0.0, gas * DEAD_VOLUME, gas * (DEAD_VOLUME + AREA * STROKE)])
    rate, stage, total, leaks = np.empty(4), np.empty(4), np.empty(4), np.empty(3)
    for row in range(opens.size):
        source = SUPPLY if opens[row] > 0.5 else ATMOSPHERE
        for step in range(per_row):
            t = (row * per_row + step) * STEP
            for k in range(3):
                leaks[k] = numbers[k] + numbers[3 + k] * max(t - numbers[6], 0.0)
            if step == 0:
                p_bottom, p_top = _rates(y, source, leaks, numbers[7], numbers[8], rate)
                out[row, 0], out[row, 1], out[row, 2] = y[0], p_bottom, p_top
                out[row, 3:] = leaks
            total[:] = 0.0
            for k in range(4):
                if k == 0:
                    stage[:] = y
                else:
                    stage[:] = y + (STEP if k == 3 else STEP / 2.0) * rate
                _rates(stage, source, leaks, numbers[7], numbers[8], rate)
                total += rate * (1.0 if k == 0 or k == 3 else 2.0)
            y += STEP / 6.0 * total
            if y[0] <= 0.0 or y[0] >= STROKE:  # an inelastic stop
                y[0] = min(max(y[0], 0.0), STROKE)
                y[1] = 0.0
