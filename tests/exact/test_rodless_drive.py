"""A rodless cylinder at a proportional valve with tables, hysteresis and a setpoint in volts: the model in SciPy."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import PchipInterpolator

import poppet
from exact.independent_spool import GAS, KAPPA, WARM, mass_flow

EXAMPLE = Path(__file__).parents[2] / "examples" / "rodless_cylinder.toml"
VISCOUS = {"kind": "viscous", "viscous_coefficient": "200 N s/m"}


def number(text):
    return float(text.split()[0])


def tables():
    """C [m^3/(s Pa)] and b versus the position of the spool, of the supply edge of a and of its exhaust edge."""
    valve = tomllib.loads(EXAMPLE.read_text(encoding="utf-8"))["parts"]["valve"]
    result = []
    for field in ("characteristic", "exhaust_a_characteristic"):
        positions = [(number(text) - 5.0) / 5.0 for text in valve[field]["command"]]
        conductances = [1e-8 * number(text) for text in valve[field]["sonic_conductance"]]
        result.append(
            (PchipInterpolator(positions, conductances), PchipInterpolator(positions, valve[field]["critical_ratio"]))
        )
    return result


def solved(times, volts, output):
    """Position and speed of the carriage, and pressures; adiabatic chambers and viscous friction."""
    (supply_size, supply_ratio), (exhaust_size, exhaust_ratio) = tables()
    area, stroke, dead, mass, viscous = np.pi / 4.0 * 0.025**2, 0.5, 20e-6, 3.0, 200.0
    omega, damping, half_loop, supply, ambient = 2.0 * np.pi * 95.0, 0.7, 0.004, 7e5, 1e5

    def rates(t, y, command):
        spool, spool_speed, x, v, *gas = y
        error = command - spool
        error -= np.clip(error, -half_loop, half_loop)
        result = [spool_speed, omega**2 * error - 2.0 * damping * omega * spool_speed, v, 0.0]
        for side, (p, temperature) in zip((1.0, -1.0), (gas[:2], gas[2:]), strict=True):
            s = float(np.clip(side * spool, -1.0, 1.0))
            flows = (
                mass_flow(supply, WARM, p, temperature, float(supply_size(s)), float(supply_ratio(s))),
                mass_flow(ambient, WARM, p, temperature, float(exhaust_size(s)), float(exhaust_ratio(s))),
            )
            volume = dead + area * (x if side > 0.0 else stroke - x)
            growth, net = side * area * v, sum(flows)
            enthalpy = sum(flow * (WARM if flow > 0.0 else temperature) for flow in flows)
            pressure_rate = KAPPA * (GAS * enthalpy - p * growth) / volume
            # T = p V / (m R)
            content = p * volume / (GAS * temperature)
            result += [pressure_rate, temperature * (pressure_rate / p + growth / volume - net / content)]
        result[3] = (area * (gas[0] - gas[2]) - viscous * v) / mass
        return result

    state, pieces = [0.0, 0.0, 0.25, 0.0, 5e5, WARM, 5e5, WARM], []
    for start, end, volt in zip(times, [*times[1:], output[-1]], volts, strict=True):
        rows = output[(output >= start - 1e-12) & (output < end - 1e-12)]
        part = solve_ivp(
            rates, (start, end), state, args=((volt - 5.0) / 5.0,), t_eval=[*rows, end], method="LSODA",
            rtol=1e-8, atol=[1e-9, 1e-6, 1e-9, 1e-9, 1e-2, 1e-6, 1e-2, 1e-6], max_step=1e-3,
        )  # fmt: skip
        pieces.append(part.y[:, :-1])
        state = part.y[:, -1]
    return np.concatenate([*pieces, np.array(state)[:, None]], axis=1)


def test_rodless_cylinder_and_valve_with_tables():
    circuit = poppet.load(EXAMPLE).with_values(
        {"carriage.friction": VISCOUS, "cylinder.cap.wall_conductance": 0.0, "cylinder.rod.wall_conductance": 0.0}
    )
    run = circuit.simulate(1.2, 2e-3)
    expected = solved([0.0, 0.2, 0.7], [5.0, 5.6, 5.0], run.time)
    assert np.abs(run["valve.position"] - expected[0]).max() < 1e-4
    travel = np.ptp(expected[2])
    assert travel > 0.1
    assert np.abs(run["carriage.position"] - expected[2]).max() < 1e-4 * travel
    assert run["cylinder.cap.pressure"] == pytest.approx(expected[4], rel=1e-4)
    assert run["cylinder.rod.pressure"] == pytest.approx(expected[6], rel=1e-4)
    assert run["cylinder.cap.temperature"] == pytest.approx(expected[5], rel=1e-4)


def test_catalogue_values_of_the_example():
    valve = poppet.load(EXAMPLE).parts["valve"]
    assert valve.numbers()["hysteresis"].source.kind == "datasheet"
    assert valve.numbers()["natural_frequency"].source.kind == "datasheet"
    # Nominal flow rate of 700 l/min at the standard state of DIN 1343, from 6 to 5 bar gauge.
    nominal = poppet.SpoolValve(
        supply="rail", a="first", b="second", nominal_flow="700 l/min N", critical_ratio=0.25
    ).parameters(poppet.load(EXAMPLE).surroundings)
    table = valve.numbers()["characteristic.sonic_conductance.y8"].value
    assert table == pytest.approx(nominal["sonic_conductance"], rel=5e-3)


def test_nominal_flow_of_a_larger_valve_agrees_with_its_conductance():
    # Festo, data sheet of the MPYE-5-1/4-420-B (161980): C = 6.25 l/(s bar), b = 0.23, 1400 l/min (DIN 1343).
    valve = poppet.SpoolValve(supply="rail", a="first", b="second", nominal_flow="1400 l/min N", critical_ratio=0.23)
    values = valve.parameters(poppet.load(EXAMPLE).surroundings)
    assert values["sonic_conductance"] == pytest.approx(6.25e-8, rel=2e-3)
