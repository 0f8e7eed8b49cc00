"""The independent tank of the tests of `poppet watch`: closed form, another integrator, the kernel, its readings."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exact.independent_watch_tank import (
    ADDRESSES,
    CIRCUIT,
    DENSITY_ANR,
    GAS_CONSTANT,
    HEALTHY,
    KAPPA,
    MODEL_ERRORS,
    ONE_PERCENT,
    SAMPLE_TIME,
    Sensors,
    Tank,
    duty_openings,
    paths,
    proportional_integral,
    random_openings,
    rates,
    readings,
    simulate,
    stepped_leak,
    two_point,
    walking_leak,
)
from poppet import Circuit, loads
from poppet.timeseries.signals import Steps

SAMPLES = 101


def circuit_of(tank: Tank) -> Circuit:
    """Return the circuit file with the parameters of a tank; the barometer only moves absolute pressures."""
    values = {address: getattr(tank, name) for name, address in ADDRESSES.items()}
    starts = {f"tank.{name}": getattr(tank, name) for name in ("initial_pressure", "initial_temperature")}
    return loads(CIRCUIT).with_values(values | starts)


@pytest.mark.parametrize("name", ["healthy", *MODEL_ERRORS])
def test_the_kernel_agrees(name):
    tank = MODEL_ERRORS.get(name, HEALTHY)
    openings = random_openings(range(1), SAMPLES)
    course = simulate(tank, openings)
    times = course.time
    signals = {f"{part}.opening": Steps(times, openings[0, :, k]) for k, part in enumerate(("valve", "use"))}
    recording = circuit_of(tank).with_signals(signals).simulate(10.0, SAMPLE_TIME, 1e-9)
    np.testing.assert_allclose(course.pressure[0], recording["tank.pressure"], rtol=1e-6)
    np.testing.assert_allclose(course.temperature[0], recording["tank.temperature"], rtol=1e-6)
    flow = recording["valve.mass_flow_rate"]
    np.testing.assert_allclose(course.valve_flow[0], flow, atol=1e-6 * np.abs(flow).max())


def test_a_closed_form_of_a_discharge():
    """An adiabatic tank is emptied with choked flow: p = p_i (1 + (kappa - 1) t/(2 tau))^(-2 kappa/(kappa - 1))."""
    tank = replace(HEALTHY, wall_conductance=0.0, leak=0.0, barometer=1e3)
    openings = np.tile([0.0, 1.0], (1, SAMPLES, 1))
    course = simulate(tank, openings)
    tau = tank.volume / (tank.use * DENSITY_ANR * GAS_CONSTANT * 293.15)
    exponent = -2.0 * KAPPA / (KAPPA - 1.0)
    exact = tank.initial_pressure * (1.0 + 0.5 * (KAPPA - 1.0) * course.time / tau) ** exponent
    np.testing.assert_allclose(course.pressure[0], exact, rtol=1e-9)


def test_lsoda_agrees_to_1e_9():
    openings = random_openings(range(8), SAMPLES)
    course = simulate(HEALTHY, openings)
    run = int(np.argmin(course.pressure.max(axis=1)))  # never close to the supply, where the cubic has kinks
    assert course.pressure[run].max() < 0.99 * HEALTHY.supply_pressure
    ends, state = paths(HEALTHY, 1), np.array([HEALTHY.initial_pressure, HEALTHY.initial_temperature])
    for k in range(SAMPLES - 1):
        driven = np.append(openings[run, k], HEALTHY.leak)[:, None]

        def rate(_: float, y: np.ndarray, driven: np.ndarray = driven) -> np.ndarray:
            return rates(HEALTHY, ends, y[:, None], driven)[:, 0]

        state = solve_ivp(rate, (0.0, SAMPLE_TIME), state, "LSODA", rtol=1e-12, atol=[1e-6, 1e-9]).y[:, -1]
        assert course.pressure[run, k + 1] == pytest.approx(state[0], rel=1e-9)


def test_one_run_of_many_is_the_run_alone():
    openings = random_openings(range(5), 50)
    together = simulate(replace(HEALTHY, supply_pressure=np.linspace(7e5, 8e5, 5)), openings)
    alone = simulate(replace(HEALTHY, supply_pressure=7.5e5), openings[2:3])
    np.testing.assert_array_equal(together.pressure[2], alone.pressure[0])


def test_the_errors_of_the_model_are_those_of_one_parameter():
    changed = {
        name: [f.name for f in fields(Tank) if getattr(tank, f.name) != getattr(HEALTHY, f.name)]
        for name, tank in MODEL_ERRORS.items()
    }
    assert sorted(len(names) for names in changed.values()) == [1] * 7 + [3]
    assert {name for names in changed.values() for name in names} - {"initial_temperature"} < set(ADDRESSES)


def test_readings_have_the_stated_errors():
    seeds, samples = range(8), 800
    course = simulate(HEALTHY, duty_openings(seeds, samples))
    sensors = Sensors(outliers=0.01, missing=0.5, flow_noise=1e-5)
    shown = readings(HEALTHY, course, sensors, seeds)
    assert shown.shape == (8, samples, 2)
    assert np.isnan(shown).mean(axis=1) == pytest.approx(0.5, abs=0.05)
    error = shown[:, :, 0] - course.pressure
    is_outlier = np.abs(error) > 2e4
    assert np.nanmean(np.where(np.isnan(error), np.nan, is_outlier)) == pytest.approx(0.01, abs=0.004)
    assert np.nanstd(error[~is_outlier]) == pytest.approx(500.0, rel=0.03)
    assert np.nanstd(shown[:, :, 1] - course.valve_flow) == pytest.approx(1e-5, rel=0.03)
    gauge = readings(HEALTHY, course, Sensors(noise=0.0, is_gauge=True, resolution=1e3), seeds)[:, :, 0]
    assert np.abs(gauge + HEALTHY.barometer - course.pressure).max() <= 500.0 + 1e-9


def test_leaks_and_closed_loops():
    seeds, samples = range(3), 600
    step = stepped_leak(HEALTHY.leak, HEALTHY.leak + ONE_PERCENT, 30.0, 3, samples)
    assert [step[0, 299], step[0, 300]] == pytest.approx([HEALTHY.leak, HEALTHY.leak + ONE_PERCENT])
    walk = walking_leak(HEALTHY.leak, 1e-12, seeds, samples)
    assert walk.min() >= 0.0
    assert np.all(walk[:, 0] == HEALTHY.leak)
    openings = np.zeros((3, samples, 2))
    openings[:, :, 1] = 0.5
    held = simulate(HEALTHY, openings, control=two_point(5e5, 5.5e5, 3)).pressure
    assert 4.8e5 < held[:, 50:].min() < 5e5
    assert 5.5e5 < held[:, 50:].max() < 5.7e5
    # The integral part hides a leak: the pressure returns to its setpoint.
    faulty = simulate(HEALTHY, openings, step, control=proportional_integral(5e5, 3))
    assert faulty.pressure[:, -1] == pytest.approx(5e5, rel=2e-3)
    assert faulty.openings[0, -1, 0] > faulty.openings[0, 299, 0]
