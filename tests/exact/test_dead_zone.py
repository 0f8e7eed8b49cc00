"""A cylinder behind a valve with overlap: positions with and without compensation and acceleration feedback."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import poppet

FILE = Path(__file__).parents[2] / "examples" / "position_dead_zone.toml"
NO_ZONES = ("fill_dead_zone", "vent_dead_zone", "dead_zone_smoothing")
NO_ACCELERATION = ("acceleration_time",)
GAIN, OVERLAP = 10.0, 0.06


@cache
def run(*without: str, static_friction: bool = True, **fields: str | float):
    """Return errors before each end of a step [m], overshoot of the first step [m], and late travel of the command."""
    circuit = poppet.load(FILE)
    part = replace(circuit.parts["position"], **dict.fromkeys(without), **fields)
    slide = circuit.parts["slide"]
    slide = slide if static_friction else replace(slide, friction={"viscous_coefficient": "80 N s/m"})
    circuit = replace(circuit, parts={**circuit.parts, "position": part, "slide": slide})
    recording = circuit.simulate("5 s", "1 ms")
    time, position, command = recording.time, recording["slide.position"], recording["position.command"]
    is_first, is_late = (time > 0.2) & (time < 2.0), time > 4.0
    errors = position[time < 2.0][-1] - 0.14, position[-1] - 0.1
    travel = float(np.sum(np.abs(np.diff(command[is_late]))))
    return np.abs(errors), position[is_first].max() - 0.14, np.ptp(position[is_late]), travel


@pytest.mark.parametrize("static_friction", [True, False])
def test_compensation_removes_the_error_of_the_overlap_without_a_limit_cycle(static_friction):
    plain, compensated = (run(*without, static_friction=static_friction) for without in (NO_ZONES, ()))
    # The valve closes at an error of the overlap over the gain, 6 mm; friction stops the slide a little closer.
    assert np.all(plain[0] > 0.8 * OVERLAP / GAIN)
    assert np.all(compensated[0] < 0.1 * OVERLAP / GAIN)
    assert compensated[2] < 0.05e-3
    assert compensated[3] < 1e-2
    assert compensated[1] < 0.6e-3


def test_the_remaining_dead_zone_is_that_of_the_smoothing():
    """Within h z/(h + z), the valve remains closed: with viscous friction, the slide stops at this error at most."""
    for smoothing in (0.001, 0.005, 0.01):
        errors, *_, moved, _ = run(static_friction=False, dead_zone_smoothing=smoothing)
        assert np.all(errors < 1.05 * smoothing * OVERLAP / (smoothing + OVERLAP) / GAIN)
        assert moved < 0.05e-3


def test_acceleration_feedback_damps_the_compensated_loop():
    """Without it, the same gains overshoot, and with viscous friction alone the loop oscillates."""
    assert run(*NO_ACCELERATION)[1] > 3e-3
    assert run()[1] < 0.3e-3
    assert run(*NO_ACCELERATION, static_friction=False)[2] > 1e-3
    assert run(static_friction=False)[2] < 0.05e-3


def held_tank(**fields):
    """Return a tank with a leak, whose pressure a PI controller holds with an opening of about 0.1."""
    valve = {"sonic_conductance": 5e-9, "critical_ratio": 0.3}
    parts = {
        "supply": poppet.Reservoir(pressure="7 bar"),
        "fill": poppet.Orifice(from_="supply", to="tank", **valve),
        "leak": poppet.Orifice(from_="tank", to="ambient", **valve | {"sonic_conductance": 8e-10}),
        "tank": poppet.Chamber(volume="1 l", wall_conductance=1.0),
        "c": poppet.PID(setpoint="4 bar", integral_time=0.2, **fields),
    }
    connections = {"c.measurement": "tank.pressure", "fill.opening": "c.fill_command"}
    return poppet.Circuit(parts, connections=connections)


@pytest.mark.parametrize(("smoothing", "slope"), [(0.4, 1.0 + 0.03 / 0.4), (0.01, 1.0)])
def test_linear_loop_has_the_slope_of_the_compensation(smoothing, slope):
    """The sampled linear model is that of a gain that is larger by the slope of the compensation."""
    zones = {"fill_dead_zone": 0.03, "dead_zone_smoothing": smoothing}
    circuits = held_tank(gain=5e-5, **zones), held_tank(gain=5e-5 * slope)
    models = [circuit.linearise() for circuit in circuits]
    opening, other = (circuit.steady_state().y["c.command"] for circuit in circuits)
    assert 0.05 < opening == pytest.approx(other, rel=1e-6)
    first, second = (np.sort(np.abs(model.eigenvalues()))[-3:] for model in models)
    assert first == pytest.approx(second, rel=1e-6)
    assert np.all(first[-3:] > 0.5)
