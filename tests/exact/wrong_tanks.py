"""Tank tests that are not as simple as a fit takes them: a light wall, another m, a leak, a slow gauge.

As in `independent_tanks`, nothing is taken from the library; here a run is one solution of all balances, with a linear
law within a millionth of equal pressures, which is less than 1 Pa.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.integrate import solve_ivp

from exact.independent_tanks import AIR, CP, GAS_CONSTANT, KAPPA, ROOM, Array, Tank, drawn

DENSITY_ANR, TEMPERATURE_ANR = 1.185, 293.15
LINEAR = 1e-6
SAMPLES = 600


@dataclass(frozen=True)
class Flaw:
    """What the tank has that the fit does not know of; the default is a tank without flaw."""

    wall_capacity: float = np.inf
    """J/K; the wall starts at the room's temperature and loses nothing to it."""
    index: float = 0.5
    leak: float = 0.0
    """Sonic conductance of a hole to the room, b = 0.3 [m^3/(s Pa)]."""
    supply_error: float = 0.0
    """By which the supply's pressure is told too high, as a part of it."""
    lag: float = 0.0
    """Of the gauge [s]."""


def flow(size: tuple[float, float, float], upstream: float, drop: float, temperature: float) -> float:
    """Mass flow of a passage of C, b and m."""
    conductance, ratio, index = size
    if drop <= 0.0:
        return 0.0
    part = drop / upstream
    if part < LINEAR:
        return flow(size, upstream, LINEAR * upstream, temperature) * part / LINEAR
    choked = conductance * DENSITY_ANR * upstream * np.sqrt(TEMPERATURE_ANR / temperature)
    distance = (1.0 - part - ratio) / (1.0 - ratio)
    return float(choked if distance <= 0.0 else choked * ((1.0 - distance) * (1.0 + distance)) ** index)


def course(tank: Tank, flaw: Flaw, time: Array) -> tuple[Array, Array, Array]:
    """Pressure and temperature of the gas, and temperature of the wall."""
    sign = 1.0 if tank.is_charge else -1.0
    grow, size = (KAPPA - 1.0) / tank.volume, (tank.conductance, tank.ratio, flaw.index)

    def rates(y: Array, is_open: bool) -> list[float]:
        pressure = tank.outside - sign * float(y[0])
        gas = pressure * tank.volume / (float(y[1]) * GAS_CONSTANT)
        upstream, hot = (tank.outside, tank.source) if tank.is_charge else (pressure, gas)
        through = sign * flow(size, upstream, float(y[0]), hot) if is_open else 0.0
        lost = flow((flaw.leak, 0.3, 0.5), pressure, pressure - AIR, gas) if flaw.leak else 0.0
        heat = tank.wall * (float(y[2]) - gas)
        return [
            -sign * grow * (CP * hot * through - CP * gas * lost + heat),
            through - lost,
            -heat / flaw.wall_capacity,
        ]

    y = np.array([sign * (tank.outside - tank.begin), tank.begin * tank.volume / (GAS_CONSTANT * ROOM), ROOM])
    result, begin = np.empty((3, time.size)), 0.0
    scale = [1e-9 * tank.outside, 1e-9 * y[1], 1e-7]
    for end, is_open in ((tank.closes, True), (tank.duration, False)):
        run = solve_ivp(
            lambda _, y, o=is_open: rates(y, o), (begin, end), y, "LSODA", rtol=1e-8, atol=scale, dense_output=True
        )
        assert run.success, run.message
        rows = (time >= begin) & (time <= end)
        result[:, rows] = run.sol(time[rows])
        begin, y = end, run.y[:, -1]
    pressure = tank.outside - sign * result[0]
    return pressure, pressure * tank.volume / (result[1] * GAS_CONSTANT), result[2]


def recorded(tank: Tank, flaw: Flaw, seed: int) -> dict[str, Array]:
    """Time [s], pressure [Pa] and perhaps temperature [K], as gauges show them."""
    generator = np.random.default_rng([6358, 2, seed])
    time = np.linspace(0.0, tank.duration, SAMPLES)
    fine = np.linspace(0.0, tank.duration, 20 * SAMPLES)
    pressure, temperature, _ = course(tank, flaw, fine)
    if flaw.lag:
        # Exact between fine rows, where the pressure is straight: 1/20 of a sample.
        decay, shown = np.exp(-(fine[1] - fine[0]) / flaw.lag), pressure.copy()
        for k in range(1, fine.size):
            shown[k] = decay * shown[k - 1] + (1.0 - decay) * 0.5 * (pressure[k] + pressure[k - 1])
        pressure = shown
    result = {"time": time, "pressure": np.interp(time, fine, pressure) + generator.normal(0.0, tank.noise, SAMPLES)}
    if tank.temperature_noise is not None:
        result["temperature"] = np.interp(time, fine, temperature) + generator.normal(
            0.0, tank.temperature_noise, SAMPLES
        )
    return result


def flawed(kind: str, seed: int) -> tuple[Tank, Flaw]:
    """A tank test and its one flaw; `none` has none."""
    generator = np.random.default_rng([6358, 3, seed])
    tank = replace(drawn(seed, stream=6359), offset=0.0, is_coarse=False)
    content = max(tank.begin, tank.outside) * tank.volume / (GAS_CONSTANT * ROOM) * CP / KAPPA
    size = generator.uniform()
    flaws = {
        "none": Flaw(),
        # A tenth to the whole of the heat capacity of the gas at its fullest.
        "light wall": Flaw(wall_capacity=content * 10.0 ** (size - 0.5)),
        "other m": Flaw(index=0.55),
        "leak": Flaw(leak=tank.conductance * (0.005 + 0.02 * size)),
        "wrong supply": Flaw(supply_error=0.01 + 0.02 * size),
        "slow gauge": Flaw(lag=tank.closes * (0.005 + 0.02 * size)),
    }
    if kind == "leak" and not tank.is_charge:
        # What has emptied says nothing of a leak beside the passage: their conductances add up.
        tank = replace(tank, closes=0.3 * tank.closes)
    if (kind == "light wall" and tank.wall == 0.0) or (kind != "none" and tank.has_twin):
        # Of an adiabatic charge nobody can tell C, whatever the flaw.
        tank = replace(tank, wall=generator.uniform(5.0, 60.0))
    if kind == "wrong supply" and not tank.is_charge:
        return flawed(kind, seed + 1)
    return tank, flaws[kind]
