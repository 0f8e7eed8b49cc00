"""The linearising controller with an exact model: the loop is the lag of first order that was asked for."""

from __future__ import annotations

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.parts import PressureController
from poppet.signals import Steps

T, TAU = 1e-3, 0.05
VALVE = {"sonic_conductance": 5e-8, "critical_ratio": 0.3}


def loop(thermal="isothermal", exponent=1.0, begin=2e5, levels=((0.0,), (2.6e5,)), leak=0.0, chamber=None, **fields):
    names = {"fill": VALVE, "vent": VALVE, "volume": 2e-3, "supply_pressure": "10 bar", "exhaust_pressure": "0.5 bar"}
    names |= {"time_constant": TAU, "sample_time": T, "polytropic_exponent": exponent}
    part = PressureController(**{**names, **fields})
    return Circuit(
        {
            "supply": Reservoir(pressure="10 bar"),
            "sink": Reservoir(pressure="0.5 bar"),
            "fill": Orifice(from_="supply", to="tank", **VALVE),
            "vent": Orifice(from_="tank", to="sink", **VALVE),
            "leak": Orifice(from_="tank", to="sink", sonic_conductance=leak, critical_ratio=0.3),
            "tank": Chamber(volume="2 l", thermal=thermal, initial_pressure=begin, **(chamber or {})),
            "c": part,
        },
        {"c.setpoint": Steps(*levels)},
        connections={
            "c.measurement": "tank.pressure",
            "fill.opening": "c.fill_command",
            "vent.opening": "c.vent_command",
            "c.gas_temperature": "tank.temperature",
        },
    )


@pytest.mark.parametrize(("thermal", "exponent"), [("isothermal", 1.0), ("energy", 1.4)])
@pytest.mark.parametrize("observer", [0.0, 0.1])
def test_choked_filling_lies_on_the_exponential_at_every_sample(thermal, exponent, observer):
    """Between two samples the pressure rises straight, so that the sampled law is exact."""
    recording = loop(thermal, exponent, observer_time=observer).simulate("0.4 s", T, 1e-9)
    wanted = 2.6e5 - 0.6e5 * np.exp(-recording.time / TAU)
    assert np.max(np.abs(recording["tank.pressure"] - wanted)) < 1e-2
    assert np.max(recording["c.fill_command"]) < 1.0
    assert np.max(np.abs(recording["c.disturbance"])) < 20.0


@pytest.mark.parametrize("sample_time", [2e-3, 1e-3, 5e-4])
def test_venting_comes_as_near_as_the_sample_is_short(sample_time):
    """The flow falls between two samples: an error of first order in T/tau, here T/tau times 0.3 of the step."""
    circuit = loop(begin=4e5, levels=((0.0,), (3.6e5,)), sample_time=sample_time)
    recording = circuit.simulate("0.4 s", sample_time, 1e-9)
    wanted = 3.6e5 + 0.4e5 * np.exp(-recording.time / TAU)
    error = np.max(np.abs(recording["tank.pressure"] - wanted))
    assert 0.001 * sample_time / TAU < error / 0.4e5 < 0.1 * sample_time / TAU


def test_a_command_one_sample_late_delays_the_exponential_by_one_sample():
    recording = loop(acts="next_sample").simulate("0.4 s", T, 1e-9)
    wanted = 2.6e5 - 0.6e5 * np.exp(-np.maximum(recording.time - T, 0.0) / TAU)
    assert np.max(np.abs(recording["tank.pressure"] - wanted)) < 1e-2


def test_limits_hold_the_fastest_rate_and_leave_no_trace():
    """From far away the valve is open; where the law takes over the exponential begins, without overshoot."""
    recording = loop(levels=((0.0,), (2.9e5,)), fill_limit=0.2, observer_time=0.1).simulate("0.8 s", T, 1e-9)
    pressure = recording["tank.pressure"]
    rate = 287.05 * 293.15 / 2e-3 * 0.2 * 5e-8 * 1.185 * 10e5
    assert np.max(np.diff(pressure)) / T == pytest.approx(rate, rel=1e-6)
    assert np.max(pressure) < 2.9e5
    open_until = int(np.argmax(recording["c.fill_command"] < 0.2))
    left = 2.9e5 - pressure[open_until]
    wanted = 2.9e5 - left * np.exp(-(recording.time[open_until:] - recording.time[open_until]) / TAU)
    assert np.max(np.abs(pressure[open_until:] - wanted)) < 1.0


def test_the_observer_learns_what_the_model_does_not_know():
    """A leak, a volume 30 % larger, heat from the wall: without the observer an error stays, with it none."""
    wrong = {"leak": 1e-9, "volume": 2.6e-3, "thermal": "energy", "exponent": 1.2, "chamber": {"wall_conductance": 2.0}}
    without = loop(**wrong).simulate("3 s", "10 ms")
    learning = loop(**wrong, observer_time=0.1).simulate("3 s", "10 ms")
    assert abs(without["tank.pressure"][-1] - 2.6e5) > 500.0
    assert abs(learning["tank.pressure"][-1] - 2.6e5) < 5.0
    assert np.max(learning["tank.pressure"]) < 2.6e5 + 0.05 * 0.6e5


def test_inside_the_hold_band_both_valves_stay_closed():
    recording = loop(hold_band="0.02 bar").simulate("1 s", T)
    assert recording["c.fill_command"][-1] == recording["c.vent_command"][-1] == 0.0
    assert 2e3 * 0.9 < 2.6e5 - recording["tank.pressure"][-1] <= 2e3


def test_a_supply_that_is_too_low_opens_nothing():
    recording = loop(supply_pressure="2.1 bar", levels=((0.0,), (4e5,)), begin=2.2e5).simulate("0.1 s", T)
    assert np.all(recording["c.fill_command"] == 0.0)
