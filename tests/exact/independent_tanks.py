"""Tank tests from a second hand: charge and discharge through a passage of ISO 6358, nothing taken from the library.

The flow law stands here as it is printed, without a smooth zone near equal pressures. Its slope is infinite there, so
the run is cut in three: a stiff solver on the pressure difference itself; the valve against equal pressures, where only
heat moves gas; and the closed tank, which has a closed form.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

Array = NDArray[np.float64]

GAS_CONSTANT, KAPPA = 287.05, 1.4
CP, CV = GAS_CONSTANT * KAPPA / (KAPPA - 1.0), GAS_CONSTANT / (KAPPA - 1.0)
DENSITY_ANR, TEMPERATURE_ANR = 1.185, 293.15
ROOM, AIR = 293.15, 1e5
"""Temperature of wall, supply and room [K], and pressure of the room [Pa]."""
FULL_SCALE, BITS = 1e6, 10
EQUAL = 1e-8
"""Pressure drop over the pressure below which only heat moves gas: 0.01 Pa, a ten thousandth of the least noise."""
SAMPLES = 600


@dataclass(frozen=True)
class Tank:
    """What is true of one test; SI units, absolute pressures."""

    is_charge: bool
    volume: float
    conductance: float
    ratio: float
    wall: float
    begin: float
    outside: float
    """Pressure of the supply of a charge, of the room else."""
    closes: float
    duration: float
    noise: float = 0.0
    is_coarse: bool = False
    offset: float = 0.0
    temperature_noise: float | None = None
    """None where only the pressure was recorded."""
    source: float = ROOM
    """Temperature of the supply."""

    @property
    def has_twin(self) -> bool:
        """An adiabatic charge and an isothermal one with kappa C have the same pressure at all times."""
        return self.is_charge and self.wall == 0.0 and self.temperature_noise is None


def mass_flow(tank: Tank, drop: float, upstream: float, temperature: float) -> float:
    """Into a tank that charges, out of one that discharges; `drop` is p1 - p2, so that no digits are lost."""
    if drop <= 0.0:
        return 0.0
    choked = tank.conductance * DENSITY_ANR * upstream * np.sqrt(TEMPERATURE_ANR / temperature)
    distance = (1.0 - drop / upstream - tank.ratio) / (1.0 - tank.ratio)
    return float(choked if distance <= 0.0 else choked * np.sqrt((1.0 - distance) * (1.0 + distance)))


def course(tank: Tank, time: Array) -> tuple[Array, Array, Array]:
    """Pressure, temperature and mass in the tank at some times, the first of them 0."""
    sign = 1.0 if tank.is_charge else -1.0
    grow = (KAPPA - 1.0) / tank.volume

    def state(y: Array) -> tuple[float, float]:
        """Pressure and temperature from the drop and the mass."""
        pressure = tank.outside - sign * float(y[0])
        return pressure, pressure * tank.volume / (float(y[1]) * GAS_CONSTANT)

    def rates(_: float, y: Array) -> list[float]:
        pressure, gas = state(y)
        upstream, hot = (tank.outside, tank.source) if tank.is_charge else (pressure, gas)
        flow = sign * mass_flow(tank, float(y[0]), upstream, hot)
        return [-sign * grow * (CP * hot * flow + tank.wall * (ROOM - gas)), flow]

    def is_equal(_: float, y: Array) -> float:
        return float(y[0]) / tank.outside - EQUAL

    is_equal.terminal = True  # type: ignore[attr-defined]
    first = [sign * (tank.outside - tank.begin), tank.begin * tank.volume / (GAS_CONSTANT * ROOM)]
    result = np.empty((2, time.size))
    open_until = min(tank.closes, float(time[-1]))
    scale = [1e-10 * tank.outside, 1e-10 * first[1]]
    run = solve_ivp(rates, (0.0, open_until), first, "Radau", rtol=1e-9, atol=scale, events=is_equal, dense_output=True)
    assert run.success, run.message
    before = time <= run.t[-1]
    result[:, before] = run.sol(time[before])
    begin, last = float(run.t[-1]), run.y[:, -1]
    if run.status == 1:
        begin, last = open_until, _at_equal(tank, state(last)[1], begin, open_until, time, result)
    after = time > begin
    pressure, mass = tank.outside - sign * result[0], result[1]
    # Closed: m cv T' = h A (T_w - T).
    mass[after] = last[1]
    gas = ROOM + (state(last)[1] - ROOM) * np.exp(-tank.wall * (time[after] - begin) / (last[1] * CV))
    pressure[after] = last[1] * GAS_CONSTANT * gas / tank.volume
    return pressure, pressure * tank.volume / (mass * GAS_CONSTANT), mass


def _at_equal(tank: Tank, gas: float, begin: float, end: float, time: Array, result: Array) -> Array:
    """Fills the rows of an open valve at equal pressures: V p' = 0, so c_p T_1 q = h A (T_w - T); the last state."""
    content = tank.outside * tank.volume / GAS_CONSTANT
    if tank.wall == 0.0:
        held = np.array([0.0, content / gas])
        result[:, (time > begin) & (time <= end)] = held[:, None]
        return held

    def rates(_: float, mass: Array) -> Array:
        own = content / mass
        return tank.wall * (own - ROOM) / (CP * (tank.source if tank.is_charge else own))

    run = solve_ivp(rates, (begin, end), [content / gas], "Radau", rtol=1e-10, atol=1e-12, dense_output=True)
    assert run.success, run.message
    rows = (time > begin) & (time <= end)
    result[0, rows] = 0.0
    if rows.any():
        result[1, rows] = run.sol(time[rows])[0]
    return np.array([0.0, float(run.y[0, -1])])


def drawn(seed: int, *, stream: int = 6358) -> Tank:
    """One of many tests: charges where the seed is even, and a quarter without wall heat."""
    generator = np.random.default_rng([stream, seed])
    is_charge = seed % 2 == 0
    volume = 10.0 ** generator.uniform(np.log10(0.002), np.log10(0.1))
    duration = 10.0 ** generator.uniform(np.log10(5.0), np.log10(100.0))
    closes = duration * generator.uniform(0.5, 0.8)
    # tau = V/(C rho0 R T0) of an isothermal tank; so many of them choke the flow and all but end it.
    depth = generator.uniform(0.7, 1.3) * (1.8 if is_charge else 3.0)
    high = generator.uniform(5e5, 8e5)
    wall = 0.0 if seed // 2 % 4 == 0 else generator.uniform(0.5, 60.0)
    return Tank(
        is_charge=is_charge,
        volume=volume,
        conductance=depth * volume / (closes * DENSITY_ANR * GAS_CONSTANT * TEMPERATURE_ANR),
        ratio=generator.uniform(0.1, 0.55),
        wall=wall,
        begin=AIR if is_charge else high,
        outside=high if is_charge else AIR,
        closes=closes,
        duration=duration,
        noise=10.0 ** generator.uniform(2.0, np.log10(3e3)),
        is_coarse=bool(generator.random() < 0.3),
        offset=generator.uniform(-3e3, 3e3) if generator.random() < 0.25 else 0.0,
        temperature_noise=generator.uniform(0.1, 0.5) if generator.random() < 0.35 else None,
    )


def recorded(tank: Tank, seed: int) -> dict[str, Array]:
    """Time [s], pressure [Pa] and perhaps temperature [K], as gauges show them."""
    generator = np.random.default_rng([6358, 1, seed])
    time = np.linspace(0.0, tank.duration, SAMPLES)
    pressure, temperature, _ = course(tank, time)
    shown = pressure + tank.offset + generator.normal(0.0, tank.noise, SAMPLES)
    step = FULL_SCALE / 2**BITS
    result = {"time": time, "pressure": step * np.round(shown / step) if tank.is_coarse else shown}
    if tank.temperature_noise is not None:
        result["temperature"] = temperature + generator.normal(0.0, tank.temperature_noise, SAMPLES)
    return result
