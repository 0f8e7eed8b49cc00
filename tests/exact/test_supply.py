"""Regulators and compressors against closed forms and against SciPy code that shares nothing with the package."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from poppet import Chamber, Circuit, Compressor, FlowSource, Orifice, PressureRegulator, Reservoir, load
from poppet.signals import Points, Steps

ROOT = Path(__file__).parents[2]
RHO, R, KAPPA, T0, BAR = 1.185, 287.05, 1.4, 293.15, 1e5
CP = KAPPA * R / (KAPPA - 1.0)
C, B = 2e-8, 0.35
DROOP, LOOP, RELIEF, LAG = 0.4 * BAR, 0.12 * BAR, 0.25 * BAR, 5e-3
REGULATOR: dict[str, Any] = {
    "setpoint": 5 * BAR, "droop": DROOP, "hysteresis": LOOP, "relief_offset": RELIEF, "lag": LAG,
    "sonic_conductance": C, "critical_ratio": B, "exhaust_conductance": 0.5 * C, "exhaust_ratio": 0.2,
}  # fmt: skip


def choked_or_not(upstream: float, downstream: float, conductance: float, ratio: float) -> float:
    """The ellipse of ISO 6358:1989, far from equal pressures."""
    r = downstream / upstream
    phi = 1.0 if r <= ratio else math.sqrt(1.0 - ((r - ratio) / (1.0 - ratio)) ** 2)
    return conductance * RHO * upstream * phi


def at_prescribed_pressure(pressure: Any) -> Circuit:
    """A regulator between a supply of 8 bar and an outlet whose pressure a signal prescribes."""
    parts = {
        "supply": Reservoir(pressure=8 * BAR),
        "outlet": Reservoir(pressure=5 * BAR),
        "regulator": PressureRegulator(supply="supply", outlet="outlet", **REGULATOR),
    }
    return Circuit(parts, {"outlet.pressure": pressure})


def test_steady_positions_are_those_of_a_play_operator() -> None:
    generator = np.random.default_rng(26)
    pressures = 5 * BAR + generator.uniform(-1.5 * DROOP, RELIEF + 1.5 * DROOP, 200)
    pressures[0] = 5 * BAR
    times = 40.0 * LAG * np.arange(200)
    run = at_prescribed_pressure(Steps(times, pressures)).simulate(times[-1] + 40.0 * LAG, LAG, 1e-10)
    position, opened, relieved = 0.0, 0, 0
    for k, pressure in enumerate(pressures):
        demand = (5 * BAR - pressure) / DROOP
        # Friction keeps the position; between the stops, only half the loop separates it from the demand.
        low, high = min(demand - 0.5 * LOOP / DROOP, 1.0), max(demand + 0.5 * LOOP / DROOP, -RELIEF / DROOP - 1.0)
        position = min(max(position, low), high)
        row = int(np.searchsorted(run.time, times[k] + 38.5 * LAG))
        assert run["regulator.position"][row] == pytest.approx(position, abs=1e-8)
        opening, relief = min(max(position, 0.0), 1.0), min(max(-position - RELIEF / DROOP, 0.0), 1.0)
        forward = choked_or_not(8 * BAR, pressure, C * opening, B)
        relieving = choked_or_not(pressure, BAR, 0.5 * C * relief, 0.2)
        assert run["regulator.supply_mass_flow_rate"][row] == pytest.approx(forward, abs=1e-8 * C * RHO * 8 * BAR)
        assert run["regulator.exhaust_mass_flow_rate"][row] == pytest.approx(relieving, abs=1e-8 * C * RHO * 8 * BAR)
        assert opening * relief == 0.0
        opened, relieved = opened + (opening > 0.0), relieved + (relief > 0.0)
    assert min(opened, relieved) > 20


@pytest.mark.parametrize("output", ["supply_opening", "exhaust_opening"])
def test_the_loop_is_as_wide_as_stated(output: str) -> None:
    """A slow triangle of the outlet pressure; the lag of the ramp is exactly its rate times the time constant."""
    top, rate = RELIEF + 1.5 * DROOP, 0.01 * BAR
    period = (top + 1.5 * DROOP) / rate
    signal = Points([0.0, period, 2 * period, 3 * period], 5 * BAR + np.array([top, -1.5 * DROOP, top, -1.5 * DROOP]))
    run = at_prescribed_pressure(signal).simulate(3 * period, period / 2000, 1e-9)
    opening, pressure = run[f"regulator.{output}"], run["outlet.pressure"]
    falling, rising = run.time >= 2 * period, (run.time >= period) & (run.time <= 2 * period)
    sign = -1.0 if output == "supply_opening" else 1.0  # towards rising openings
    for level in (0.1, 0.5, 0.9):
        there = [
            np.interp(level, np.sort(opening[leg]), pressure[leg][np.argsort(opening[leg], kind="stable")])
            for leg in (falling, rising)
        ]
        width = there[1] - there[0]
        assert width == pytest.approx(LOOP + 2.0 * rate * LAG, rel=1e-4)
        centre = 5 * BAR + (-level * DROOP if sign < 0.0 else RELIEF + level * DROOP)
        assert np.mean(there) == pytest.approx(centre, abs=1e-4 * BAR)


@pytest.mark.parametrize("drain", [0.05, 0.2, 0.6])
def test_regulated_pressure_under_flow(drain: float) -> None:
    """The pressure falls from above, so the position is on the branch of a rising opening."""
    parts = {
        "supply": Reservoir(pressure=8 * BAR),
        "regulator": PressureRegulator(supply="supply", outlet="line", **REGULATOR),
        "line": Chamber(volume=2e-3, thermal="isothermal", initial_pressure=5.2 * BAR),
        "tool": Orifice(from_="line", to="ambient", sonic_conductance=drain * C, critical_ratio=B),
    }
    run = Circuit(parts).simulate(20.0, 0.1, 1e-10)

    def surplus(pressure: float) -> float:
        opening = min(max((5 * BAR - 0.5 * LOOP - pressure) / DROOP, 0.0), 1.0)
        return choked_or_not(8 * BAR, pressure, C * opening, B) - choked_or_not(pressure, BAR, drain * C, B)

    assert run["line.pressure"][-1] == pytest.approx(brentq(surplus, 3 * BAR, 5 * BAR), rel=1e-7)


def test_a_setpoint_above_the_supply_gives_the_supply_pressure() -> None:
    parts = {
        "supply": Reservoir(pressure=3 * BAR),
        "regulator": PressureRegulator(supply="supply", outlet="line", **REGULATOR),
        "line": Chamber(volume=1e-3, thermal="isothermal"),
    }
    run = Circuit(parts).simulate(10.0)
    assert run["line.pressure"][-1] == pytest.approx(3 * BAR, rel=1e-5)
    assert run["regulator.position"][-1] == pytest.approx(1.0)
    (note,) = [note for note in run.remarks if note.code == "supply.setpoint_above_supply"]
    assert (note.address, note.facts["excess"], note.facts["time"]) == ("regulator.setpoint", 2 * BAR, 0.0)


# --- Compressor ---

DELIVERY, START, STOP, EFFICIENCY, VOLUME, DRAIN = 4e-3, 6 * BAR, 8 * BAR, 0.7, 0.01, 2e-3
DELIVERED = DELIVERY * RHO


def supplied(thermal: str, switching_time: float = 2e-5, **compressor: Any) -> Circuit:
    """A compressor and a tank from which a constant mass flow is drawn."""
    fields = {"free_air_delivery": DELIVERY, "start_pressure": START, "stop_pressure": STOP, **compressor}
    parts = {
        "compressor": Compressor("tank", efficiency=EFFICIENCY, switching_time=switching_time, **fields),
        "tank": Chamber(volume=VOLUME, thermal=thermal, initial_pressure=7 * BAR),
        "consumer": FlowSource(to="tank", mass_flow_rate=-DRAIN),
    }
    return Circuit(parts)


def switching_times(run: Any) -> tuple[list[float], list[float]]:
    """Times at which the motor has half its speed, when it starts and when it stops."""
    speed = run["compressor.position"] - 0.5
    rows = np.flatnonzero(speed[1:] * speed[:-1] < 0.0)
    times = run.time[rows] - speed[rows] * (run.time[rows + 1] - run.time[rows]) / (speed[rows + 1] - speed[rows])
    return [*times[::2]], [*times[1::2]]


def test_times_of_start_and_stop_of_an_isothermal_tank() -> None:
    run = supplied("isothermal").simulate(150.0, 1e-3, 1e-9)
    starts, stops = switching_times(run)
    first = VOLUME * (7 * BAR - START) / (R * T0 * DRAIN)
    on = VOLUME * (STOP - START) / (R * T0 * (DELIVERED - DRAIN))
    off = VOLUME * (STOP - START) / (R * T0 * DRAIN)
    count = len(starts)
    assert count >= 6
    np.testing.assert_allclose(starts, first + (on + off) * np.arange(count), atol=1e-3)
    np.testing.assert_allclose(stops, first + on + (on + off) * np.arange(len(stops)), atol=1e-3)
    assert on / (on + off) == pytest.approx(DRAIN / DELIVERED)  # the duty cycle


def test_times_of_start_and_stop_of_an_adiabatic_tank() -> None:
    def rates(on: float) -> Any:
        def rate(_: float, x: Any) -> Any:
            pressure, mass = x
            delivered = on * DELIVERED
            temperature = pressure * VOLUME / (mass * R)
            return [KAPPA * R / VOLUME * (delivered * T0 - DRAIN * temperature), delivered - DRAIN]

        return rate

    time, state, on, expected = 0.0, [7 * BAR, 7 * BAR * VOLUME / (R * T0)], 0.0, []
    while time < 100.0:

        def limit(_: float, x: Any, level: float = STOP if on else START) -> float:
            return float(x[0] - level)

        limit.terminal = True  # type: ignore[attr-defined]
        leg = solve_ivp(rates(on), (time, 200.0), state, "DOP853", events=limit, rtol=1e-11, atol=1e-9)
        time, state, on = leg.t[-1], leg.y[:, -1], 1.0 - on
        expected.append(time)
    run = supplied("energy").simulate(100.0, 1e-3, 1e-9)
    starts, stops = switching_times(run)
    assert len(starts) + len(stops) == len(expected) - 1 >= 8
    np.testing.assert_allclose(starts, expected[:-1][::2], atol=2e-3)
    np.testing.assert_allclose(stops, expected[:-1][1::2], atol=2e-3)


@pytest.mark.parametrize("cooling", ["aftercooler", "none"])
def test_work_of_a_cycle_is_the_isentropic_one_divided_by_the_efficiency(cooling: str) -> None:
    run = supplied("isothermal", cooling=cooling).simulate(60.0, 1e-3, 1e-9)
    starts, stops = switching_times(run)
    work = np.interp([starts[0] - 0.5, stops[0] + 0.5], run.time, run["compressor.work"])
    k, slope = (KAPPA - 1.0) / KAPPA, R * T0 * (DELIVERED - DRAIN) / VOLUME
    integral = BAR / (k + 1.0) * ((STOP / BAR) ** (k + 1.0) - (START / BAR) ** (k + 1.0)) - (STOP - START)
    assert work[1] - work[0] == pytest.approx(DELIVERED * CP * T0 / EFFICIENCY * integral / slope, rel=1e-4)
    assert work[0] == 0.0


def test_a_slow_motor_delays_the_limits() -> None:
    """The run-down delivers half of the rated flow, on average, for the time of the run-down."""
    run = supplied("isothermal", switching_time=0.5).simulate(20.0, 1e-3, 1e-9)
    pressure = run["tank.pressure"]
    excess = R * T0 / VOLUME * _surplus_of_run_down(0.5)
    assert pressure.max() - STOP == pytest.approx(excess, rel=0.03)
    assert pressure.min() < START - 0.2 * R * T0 / VOLUME * DRAIN * 0.5


def _surplus_of_run_down(time: float) -> float:
    """Mass that a motor with a linear run-down delivers until its flow equals the drain."""
    end = 1.0 - DRAIN / DELIVERED
    return time * (DELIVERED * (end - 0.5 * end**2) - DRAIN * end)


def test_results_of_the_page() -> None:
    run = load(ROOT / "examples" / "compressed_air.toml").simulate()
    starts, _ = switching_times(run)
    cycles = (run.time >= starts[0]) & (run.time <= starts[2])
    span = starts[2] - starts[0]
    air = np.trapezoid(run["compressor.mass_flow_rate"][cycles], run.time[cycles]) / RHO
    work = np.ptp(run["compressor.work"][cycles]) / 3600.0
    results = {
        "time between two starts": (0.5 * span, 1.0),
        "duty cycle": (100.0 * np.mean(run["compressor.position"][cycles] > 0.5), 0.1),
        "consumption of the tool": (
            np.trapezoid(run["tool.mass_flow_rate"][cycles], run.time[cycles]) / RHO / span * 60e3,
            0.1,
        ),
        "work of the motor per cycle": (0.5 * work, 0.1),
        "work of the motor per m": (work / air, 1.0),
    }
    page = (ROOT / "docs" / "supply.md").read_text(encoding="utf-8")
    for name, (value, step) in results.items():
        (stated,) = re.findall(rf"^\| {name}.*? \| ([\d.]+) ", page, re.MULTILINE)
        assert float(stated) == pytest.approx(value, abs=0.6 * step), name
