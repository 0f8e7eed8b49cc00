"""The Rosenbrock kernel against CVODES, LSODA, BDF and Radau on six circuits that differ in kind."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from poppet import Circuit
from poppet.circuit.options import Run
from poppet.engine.reference_solvers.solvers import SOLVERS
from poppet.parts import Chamber, DirectionalValve, MainStage, Orifice, Reservoir
from poppet.signals import Points, Pwm, Sine, Steps
from poppet.timeseries.recording import Recording

SIZE = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}
SUPPLY, ROOM = Reservoir(pressure="7 bar"), Reservoir(pressure="1 bar")
TOLERANCE = 1e-8


def stage(mode: str) -> MainStage:
    return MainStage(supply="supply", outlet="tank", exhaust="room", data="varga2012", mode=mode)


def paper_staircase() -> Circuit:
    tank = Chamber(volume="0.2 m^3", wall_conductance="45 W/K")
    parts = {"supply": SUPPLY, "room": ROOM, "valve": stage("paper"), "tank": tank}
    pilot = Steps([0.0, 20.0, 40.0, 60.0], [2e5, 4e5, 1e5, 2e5])
    return Circuit(parts, {"valve.pilot_pressure": pilot}, Run(duration="80 s", output_step="0.5 s"))


def two_tanks() -> Circuit:
    parts = {
        "full": Chamber(volume="2 l", initial_pressure="7 bar"),
        "warm": Chamber(volume="5 l", initial_temperature="320 K"),
        "bridge": Orifice(from_="full", to="warm", **SIZE),
    }
    return Circuit(parts, run=Run(duration="2 s", output_step="10 ms"))


def tank_with_wall() -> Circuit:
    wall = {"wall_conductance": 2.0, "wall_heat_capacity": 500.0, "outer_conductance": 1.0}
    parts = {
        "supply": SUPPLY,
        "tank": Chamber(volume="5 l", **wall),
        "fill": Orifice(from_="supply", to="tank", **SIZE),
    }
    return Circuit(parts, run=Run(duration="20 s", output_step="0.1 s"))


def pulsed_tank() -> Circuit:
    parts = {"supply": SUPPLY, "room": ROOM, "tank": Chamber(volume="1 l", wall_conductance=1.0)}
    parts |= {"fill": Orifice(from_="supply", to="tank", **SIZE), "vent": Orifice(from_="tank", to="room", **SIZE)}
    duty = Points([0.0, 1.0], [0.1, 0.9])
    signals = {"fill.opening": Pwm(20.0, duty), "vent.opening": Sine(0.5, 0.4, 3.0, 0.2)}
    return Circuit(parts, signals, Run(duration="1 s", output_step="7 ms"))


def directional_valve() -> Circuit:
    valve = DirectionalValve(
        supply="supply", outlet="tank", exhaust="room", delay="15 ms", exhaust_conductance=2e-8, **SIZE
    )
    parts = {"supply": SUPPLY, "room": ROOM, "valve": valve, "tank": Chamber(volume="1 l")}
    command = Steps([0.0, 0.1, 0.4, 0.7], [0.0, 1.0, 0.0, 1.0])
    return Circuit(parts, {"valve.command": command}, Run(duration="1 s", output_step="2 ms"))


def sine_driven_regulator() -> Circuit:
    parts = {
        "supply": SUPPLY,
        "room": ROOM,
        "valve": stage("regulator"),
        "tank": Chamber(volume="20 l", wall_conductance="5 W/K", initial_pressure="3 bar"),
        "load": Orifice(from_="tank", to="room", **SIZE),
    }
    pilot = Sine(4e5, 0.5e5, 2.0)
    return Circuit(parts, {"valve.pilot_pressure": pilot}, Run(duration="2 s", output_step="10 ms"))


CIRCUITS = (paper_staircase, two_tanks, tank_with_wall, pulsed_tank, directional_valve, sine_driven_regulator)
PAIRS = [
    # Fast mechanics under a sine take the solvers that are called from Python many seconds.
    pytest.param(circuit, solver, marks=[pytest.mark.slow] * (circuit is sine_driven_regulator and solver != "cvodes"))
    for circuit in CIRCUITS
    for solver in SOLVERS
]


@cache
def kernel_run(circuit) -> Recording:
    return circuit().simulate(relative_tolerance=TOLERANCE)


@pytest.mark.parametrize(("circuit", "solver"), PAIRS, ids=lambda each: getattr(each, "__name__", each))
def test_gas_states_agree(circuit, solver):
    kernel, other = kernel_run(circuit), circuit().simulate(relative_tolerance=TOLERANCE, solver=solver)
    assert np.array_equal(other.time, kernel.time)
    for name, unit in zip(kernel.names, kernel.units, strict=True):
        if unit in ("Pa", "K", "kg"):
            np.testing.assert_allclose(other[name], kernel[name], rtol=1e-6, err_msg=name)
        elif unit == "kg/s":
            largest = np.max(np.abs(kernel[name]))
            np.testing.assert_allclose(other[name], kernel[name], rtol=0.0, atol=1e-4 * largest, err_msg=name)
        elif unit == "m":
            np.testing.assert_allclose(other[name], kernel[name], rtol=0.0, atol=1e-7, err_msg=name)


@pytest.mark.parametrize(("circuit", "solver"), PAIRS, ids=lambda each: getattr(each, "__name__", each))
def test_mass_and_energy_are_conserved_by_every_solver(circuit, solver):
    other = circuit().simulate(relative_tolerance=1e-6, solver=solver)
    assert other.residuals
    assert [residual for residual in other.residuals if not residual.is_kept] == []


@pytest.mark.parametrize(
    "solver", [pytest.param(s, marks=[pytest.mark.slow] * (s in ("bdf", "radau"))) for s in SOLVERS]
)
def test_inputs_are_the_kernel_s_to_the_last_digits(solver):
    for circuit, name in ((paper_staircase, "valve.pilot_pressure"), (sine_driven_regulator, "valve.pilot_pressure")):
        other = circuit().simulate(relative_tolerance=1e-4, solver=solver)
        np.testing.assert_allclose(other[name], kernel_run(circuit)[name], rtol=1e-14)
