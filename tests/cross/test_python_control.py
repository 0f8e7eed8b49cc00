"""Margins, responses and designs against python-control."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet.control import Gains, SampledPlant, margins, plant_of, tune
from poppet.control import python_control as adapter
from poppet.control.loop import disturbance_response, step_response
from poppet.core.errors import InputError

T = 2e-3
GAINS = [Gains(3.0), Gains(2.0, 0.1), Gains(2.0, 0.1, 0.02, 4e-3), Gains(1.0, 0.0, 0.01, 1e-3)]


@pytest.fixture(scope="module")
def control():
    """Imported when it is used: it takes seconds, and every worker collects every test."""
    return pytest.importorskip("control", reason="python-control is not installed")


@pytest.fixture(scope="module")
def tuned():
    return tuned_loop()


def tuned_loop():
    """A sampled plant and its gains."""
    circuit = poppet.load(Path(__file__).parents[2] / "examples" / "pressure_control.toml")
    (point,) = tune(circuit, at=["3 bar"]).points
    plant = plant_of(circuit)
    return plant.sampled(plant.operating_point("3 bar"), "fill"), point.gains


def their_margins(control, plant, gains):
    """Gain and phase margin, their frequencies [rad/s], and the response of the loop."""
    loop = adapter.plant_to_control(plant) * adapter.gains_to_control(gains, T)
    omega = 2.0 * np.pi * np.geomspace(1e-2, 249.9, 5000)
    data = control.frequency_response(loop, omega)
    gain, phase, _, gain_frequency, crossover, _ = control.stability_margins(control.frd(data.complex.ravel(), omega))
    return gain, phase, gain_frequency, crossover, data.complex.ravel()


def test_margins_agree(control, tuned):
    gain, phase, gain_frequency, crossover, response = their_margins(control, *tuned)
    found = margins(*tuned)
    assert found.gain_margin == pytest.approx(gain, rel=1e-3)
    assert found.phase_margin == pytest.approx(phase, rel=1e-3)
    assert found.crossover == pytest.approx(crossover / (2.0 * np.pi), rel=1e-3)
    assert found.phase_frequency == pytest.approx(crossover / (2.0 * np.pi), rel=1e-3)
    assert found.gain_frequency == pytest.approx(gain_frequency / (2.0 * np.pi), rel=1e-3)
    assert found.sensitivity == pytest.approx(np.max(1.0 / np.abs(1.0 + response)), rel=1e-3)
    assert found.complementary == pytest.approx(np.max(np.abs(response / (1.0 + response))), rel=1e-3)


def test_lower_gain_margin_of_a_conditionally_stable_loop_agrees(control):
    """A double integrator with an integral part is stable only above a gain and below another one."""
    a = np.array([[1.0, T], [0.0, 1.0]])
    plant = SampledPlant(a, np.array([T**2 / 2.0, T]), np.array([1.0, 0.0]), T, 3)
    gains = Gains(30.0, 0.5, 0.5, 0.01)
    found = margins(plant, gains)
    loop = adapter.plant_to_control(plant) * adapter.gains_to_control(gains, T)
    omega = 2.0 * np.pi * np.geomspace(1e-2, 249.9, 5000)
    response = control.frequency_response(loop, omega).complex.ravel()
    theirs, _, _, frequencies, _, _ = control.stability_margins(control.frd(response, omega), returnall=True)
    k = np.flatnonzero(theirs < 1.0)[np.argmax(theirs[theirs < 1.0])]
    assert found.is_stable
    assert found.lower_gain_margin == pytest.approx(theirs[k], rel=1e-3)
    assert found.lower_gain_frequency == pytest.approx(frequencies[k] / (2.0 * np.pi), rel=1e-3)
    assert found.gain_margin == pytest.approx(np.min(theirs[theirs > 1.0]), rel=1e-3)
    for factor, is_stable in ((0.99, False), (1.01, True)):
        scaled = replace(gains, gain=factor * found.lower_gain_margin * gains.gain)
        assert margins(plant, scaled).is_stable is is_stable


def test_steps_agree(control, tuned):
    plant, gains = tuned
    loop = adapter.plant_to_control(plant) * adapter.gains_to_control(gains, T)
    wanted = control.step_response(control.feedback(loop, 1), np.arange(400) * T).outputs
    assert np.max(np.abs(step_response(plant, gains, 1.0, 400) - wanted)) < 1e-6


def test_disturbances_agree(control, tuned):
    plant, gains = tuned
    model, controller = adapter.plant_to_control(plant), adapter.gains_to_control(gains, T)
    # The disturbance acts behind the delay, at the plant itself.
    undelayed = adapter.plant_to_control(replace(plant, delay=0))
    sensitivity = control.feedback(control.ss([], [], [], [[1.0]], T), model * controller)
    wanted = control.step_response(undelayed * sensitivity, np.arange(400) * T).outputs
    assert np.max(np.abs(wanted)) > 0.0
    assert np.max(np.abs(disturbance_response(plant, gains, 400) - wanted)) < 1e-6 * np.max(np.abs(wanted))


@pytest.mark.parametrize("gains", GAINS)
def test_gains_make_the_way_there_and_back(gains):
    system = adapter.gains_to_control(gains, T)
    z = np.exp(2j * np.pi * np.array([0.1, 1.0, 20.0, 240.0]) * T)
    assert np.max(np.abs(system(z) / gains.response(z, T) - 1.0)) < 1e-6
    back = adapter.gains_from_control(system)
    assert np.max(np.abs(back.response(z, T) / gains.response(z, T) - 1.0)) < 1e-6


def test_a_design_of_python_control_becomes_a_pid(control):
    s = control.tf("s")
    back = adapter.gains_from_control(control.c2d(2.0 * (1.0 + 1.0 / (0.2 * s)), T, "forward_diff"))
    assert back.gain == pytest.approx(2.0)
    assert back.integral_time == pytest.approx(0.2)


@pytest.mark.parametrize(
    ("numerator", "denominator", "sample_time", "code"),
    [
        ([1.0], [1.0, 1.0], 0.0, "no_sample_time"),
        ([1.0], np.poly([0.3, 0.5, 1.0]), T, "poles"),
        ([1.0, 0.0], [1.0, 0.5], T, "no_filter"),
        ([1.0, 0.0], [1.0], T, "looks_ahead"),
        ([1.0, -2.0], [1.0, -1.0], T, "signs"),
    ],
)
def test_what_is_no_pid_is_refused(control, numerator, denominator, sample_time, code):
    with pytest.raises(InputError) as caught:
        adapter.gains_from_control(control.tf(numerator, denominator, sample_time))
    assert caught.value.code == f"control.{code}"
    assert str(caught.value)


def test_linear_models_make_the_way_there_and_back(control):
    circuit = poppet.load(Path(__file__).parents[2] / "examples" / "pressure_control.toml")
    model = plant_of(circuit).operating_point("3 bar").models["fill"]
    back = adapter.model_from_control(model.to_control())
    assert (back.states, back.inputs, back.outputs) == (model.states, model.inputs, model.outputs)
    for name in "ABCD":
        assert np.array_equal(getattr(back, name), getattr(model, name))
    with pytest.raises(InputError) as caught:
        adapter.model_from_control(control.ss([[1.0]], [[1.0]], [[1.0]], [[0.0]], T))
    assert caught.value.code == "control.discrete"
