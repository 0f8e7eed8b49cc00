"""Independent simulator of tank tests with a leak, and random tests at the limits of identification.

The module shares no code with `poppet`. The flow law is that of ISO 6358 without a laminar zone. The state is the
pressure difference across the valve and the mass of the gas, so that no digits are lost near equal pressures.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

Array = NDArray[np.float64]
R, KAPPA = 287.05, 1.4
CP, CV = R * KAPPA / (KAPPA - 1.0), R / (KAPPA - 1.0)
DENSITY_ANR, TEMPERATURE_ANR = 1.185, 293.15
EQUAL = 1e-8


@dataclass(frozen=True)
class EdgeTank:
    """True parameters of a tank test in SI units, with absolute pressures."""

    is_charge: bool
    volume: float
    conductance: float
    ratio: float
    wall: float
    begin: float
    outside: float
    room: float
    temperature: float
    closes: float
    duration: float
    samples: int
    noise: float
    step: float = 0.0  # resolution of the sensor; 0 without rounding
    leak: float = 0.0  # sonic conductance of the leak to the room
    stated_supply: float | None = None  # supply pressure of the test file; the true one by default


def flow(conductance: float, ratio: float, drop: float, upstream: float, temperature: float) -> float:
    """Return the mass flow rate at a pressure difference `drop` [kg/s]."""
    if drop <= 0.0:
        return 0.0
    if drop < EQUAL * upstream:
        # Linear to 0: the solver stalls at the infinite slope of equal pressures.
        return flow(conductance, ratio, EQUAL * upstream, upstream, temperature) * drop / (EQUAL * upstream)
    choked = conductance * DENSITY_ANR * upstream * np.sqrt(TEMPERATURE_ANR / temperature)
    distance = (1.0 - drop / upstream - ratio) / (1.0 - ratio)
    return float(choked if distance <= 0.0 else choked * np.sqrt((1.0 - distance) * (1.0 + distance)))


def simulate(tank: EdgeTank, time: Array) -> Array:
    """Return the true pressure at the times, the first of which is 0."""
    sign = 1.0 if tank.is_charge else -1.0

    def state(y: Array) -> tuple[float, float]:
        pressure = tank.outside - sign * float(y[0])
        return pressure, pressure * tank.volume / (float(y[1]) * R)

    def rates(_: float, y: Array, is_open: bool = True) -> list[float]:
        pressure, gas = state(y)
        upstream, hot = (tank.outside, tank.temperature) if tank.is_charge else (pressure, gas)
        inflow = sign * flow(tank.conductance, tank.ratio, float(y[0]), upstream, hot) if is_open else 0.0
        leak = flow(tank.leak, 0.5, pressure - tank.room, pressure, gas) if tank.leak else 0.0
        energy = CP * (hot * inflow - gas * leak) + tank.wall * (tank.temperature - gas)
        return [-sign * (KAPPA - 1.0) / tank.volume * energy, inflow - leak]

    def is_equal(_: float, y: Array) -> float:
        return float(y[0]) / tank.outside - EQUAL

    is_equal.terminal = True  # type: ignore[attr-defined]
    mass = tank.begin * tank.volume / (R * tank.temperature)
    first = np.array([sign * (tank.outside - tank.begin), mass])
    scale = [1e-10 * tank.outside, 1e-10 * mass]
    result = np.empty(time.size)
    end = min(tank.closes, float(time[-1]))
    run = solve_ivp(
        rates,
        (0.0, end),
        first,
        "Radau",
        rtol=1e-9,
        atol=scale,
        dense_output=True,
        events=None if tank.leak else is_equal,
    )
    assert run.success, run.message
    before = time <= run.t[-1]
    result[before] = tank.outside - sign * run.sol(time[before])[0]
    last, begin = run.y[:, -1], float(run.t[-1])
    if run.status == 1:  # equal pressures, and an open valve: only the heat of the wall moves gas
        between = (time > begin) & (time <= end)
        result[between] = tank.outside

        def warming(_: float, m: Array) -> Array:
            gas = tank.outside * tank.volume / (R * m)
            return tank.wall * (gas - tank.temperature) / (CP * (tank.temperature if tank.is_charge else gas))

        start = [tank.outside * tank.volume / (R * state(last)[1])]
        held = solve_ivp(warming, (begin, end), start, "Radau", rtol=1e-10, atol=1e-12)
        last, begin = np.array([0.0, held.y[0, -1]]), end
    after = time > begin
    if tank.leak:
        closed = solve_ivp(
            lambda t, y: rates(t, y, False),
            (begin, float(time[-1])),
            last,
            "Radau",
            rtol=1e-9,
            atol=scale,
            dense_output=True,
        )
        assert closed.success
        result[after] = tank.outside - sign * closed.sol(time[after])[0]
    else:
        gas = tank.temperature + (state(last)[1] - tank.temperature) * np.exp(
            -tank.wall * (time[after] - begin) / (last[1] * CV)
        )
        result[after] = last[1] * R * gas / tank.volume
    return result


def record(tank: EdgeTank, seed: int) -> tuple[Array, Array]:
    """Return the times and the readings of the sensor."""
    time = np.linspace(0.0, tank.duration, tank.samples)
    shown = simulate(tank, time) + np.random.default_rng([24, seed]).normal(0.0, tank.noise, time.size)
    return time, tank.step * np.round(shown / tank.step) if tank.step else shown


def draw(seed: int, stream: int = 2400) -> EdgeTank:
    """Return a random test: pressure only, sensors of 10 to 16 bits, leaks up to 3 %, supplies off by up to 0.5 %."""
    g = np.random.default_rng([stream, seed])
    is_charge = bool(g.random() < 0.6)
    volume = 10.0 ** g.uniform(np.log10(0.002), np.log10(0.1))
    duration = 10.0 ** g.uniform(np.log10(5.0), np.log10(100.0))
    closes = duration * g.uniform(0.5, 0.8)
    room, temperature = g.uniform(0.97e5, 1.03e5), g.uniform(288.0, 303.0)
    high = g.uniform(5e5, 9e5)
    depth = g.uniform(0.7, 1.3) * (1.8 if is_charge else 3.0)
    conductance = depth * volume / (closes * DENSITY_ANR * R * TEMPERATURE_ANR)
    # NTU spans both limits: a fifth exactly adiabatic, the others from 0.1 to 300.
    units = 0.0 if g.random() < 0.2 else 10.0 ** g.uniform(-1.0, 2.5)
    wall = units * 0.5 * (high + room) * volume / (R * temperature) * CV / closes
    bits = int(g.integers(10, 17))
    step = 1.05e6 / 2**bits
    noise = 10.0 ** g.uniform(np.log10(50.0), np.log10(2e3))
    leak = conductance * g.uniform(0.0, 0.03) if g.random() < 0.5 else 0.0
    tank = EdgeTank(
        is_charge,
        volume,
        conductance,
        g.uniform(0.1, 0.55),
        wall,
        room if is_charge else high,
        high if is_charge else room,
        room,
        temperature,
        closes,
        duration,
        int(g.integers(300, 1200)),
        noise,
        step,
        leak,
    )
    return (
        replace(tank, stated_supply=high * (1.0 + g.uniform(-0.005, 0.005))) if is_charge and g.random() < 0.5 else tank
    )


COARSE_CHARGE = EdgeTank(
    True, 23.998e-3, 1.01693e-8, 0.3919, 0.0, 98181.0, 838539.0, 98181.0, 296.69, 44.93, 71.89, 800, 148.0, 1025.4
)
"""Adiabatic charge that is recorded with a 10-bit sensor."""
LEAKY_ISOTHERMAL = EdgeTank(
    *(True, 2.1456e-3, 1.35435e-9, 0.5177, 56.16, 101762.0, 615958.0, 101762.0, 291.9, 32.42, 51.9, 400, 964.0),
    leak=9.25e-12,
)
"""Isothermal charge with a leak of 0.7 % of C."""
