"""The independent cylinder of the tests of `poppet watch`: kernel, step size, faults, closed loops, readings."""

from __future__ import annotations

import numpy as np
import pytest

from exact.independent_watch_cylinder import (
    CHANNELS,
    CIRCUIT,
    CYCLE,
    FAULTS,
    HEALTHY,
    NOISE,
    SAMPLE_TIME,
    Course,
    Cylinder,
    Sensors,
    cycles,
    position_loop,
    pressure_loop,
    readings,
    simulate,
    varied,
)
from poppet import Circuit, Recording, loads
from poppet.timeseries.signals import Steps

LARGE = 10.0
"""Size of the faults in these tests, in units: an address of another parameter would be seen."""


def kernel(values: dict[str, float], course: Course) -> Recording:
    """Return the recording of the circuit file with other parameters and the commands of a course."""
    changed = np.append(True, np.diff(course.command) != 0.0)
    signal = Steps(course.time[changed], course.command[changed])
    circuit: Circuit = loads(CIRCUIT).with_values(values).with_signals({"valve.command": signal})
    return circuit.simulate(float(course.time[-1]), SAMPLE_TIME, 1e-9)


def errors(course: Course, recording: Recording) -> dict[str, float]:
    """Return the largest difference of each channel as a fraction of its largest value."""
    pairs = {name: (course.channels[name], recording[address]) for name, address in CHANNELS.items()}
    return {name: float(np.abs(one - two).max() / np.abs(two).max()) for name, (one, two) in pairs.items()}


def test_the_kernel_agrees():
    course = simulate(HEALTHY, cycles(1), substeps=400)
    assert max(errors(course, kernel({}, course)).values()) < 1e-6


@pytest.mark.parametrize("name", FAULTS)
def test_the_kernel_agrees_on_each_fault(name):
    fault = FAULTS[name]
    course = simulate(fault.plant(LARGE), cycles(1))
    value = getattr(HEALTHY, fault.names[0]) + LARGE * fault.unit
    assert max(errors(course, kernel({fault.address: value}, course)).values()) < 1e-5
    healthy = simulate(HEALTHY, cycles(1))
    names = ("cap", "rod", "position")
    seen = max(np.abs(course.channels[name] - healthy.channels[name]).max() / NOISE[name] for name in names)
    assert seen > 2.0  # a fault of this size moves a reading by more than its noise


def test_the_step_is_small_enough():
    """The error is below a fiftieth of the noise."""
    coarse, fine = (simulate(HEALTHY, cycles(1), substeps=n) for n in (100, 800))
    for name, noise in NOISE.items():
        assert np.abs(coarse.channels[name] - fine.channels[name]).max() < 0.05 * noise


def test_a_change_during_a_run_keeps_the_states():
    faulty = FAULTS["seal_leak"].plant(1.0)
    before, after, both = (
        simulate(HEALTHY, cycles(1)),
        simulate(faulty, cycles(1)),
        simulate(HEALTHY, cycles(1), change=(2.0, faulty)),
    )
    np.testing.assert_array_equal(both.states[:201], before.states[:201])
    assert not np.allclose(both.states[250], before.states[250], rtol=1e-6)
    assert not np.array_equal(both.states[250], after.states[250])


def test_courses_of_supply_and_load():
    constant = {"supply_pressure": np.full(620, HEALTHY.supply_pressure)}
    np.testing.assert_array_equal(
        simulate(HEALTHY, cycles(1), courses=constant).states, simulate(HEALTHY, cycles(1)).states
    )
    courses = varied(20, 1)
    assert np.std(courses["load"]) == pytest.approx(2.0, rel=0.5)
    assert np.std(courses["supply_pressure"]) == pytest.approx(3500.0, rel=0.5)
    assert np.unique(courses["load"]).size == 20


def test_cycles_vary_with_a_seed():
    plain, other = cycles(3), cycles(3, seed=1)
    assert plain.size == other.size == round(3 * CYCLE / SAMPLE_TIME)
    rises = [np.flatnonzero(np.diff(commands) > 0.0) for commands in (plain, other)]
    assert len(set(np.diff(rises[0]))) == 1
    assert len(set(np.diff(rises[1]))) == 2
    assert np.abs(rises[0] - rises[1]).max() <= 10


@pytest.mark.parametrize("leak", ["seal_leak", "leak_cap"])
def test_closed_loops_hide_leaks(leak):
    faulty = FAULTS[leak].plant(2.0)
    commands = np.zeros(600)

    def setpoint(time: float) -> float:
        return 0.1 if time < 3.0 else 0.12

    # A proportional spool leaks at its centre: the position settles by the controller.
    for plant in (HEALTHY, faulty):
        run = simulate(plant, commands, control=position_loop(setpoint))
        assert run.channels["position"][-1] == pytest.approx(0.12, abs=2e-3)
    held: list[Course] = [simulate(plant, commands, control=pressure_loop(4e5)) for plant in (HEALTHY, faulty)]
    for run in held:
        assert run.channels["cap"][-1] == pytest.approx(4e5, rel=1e-3)
    assert abs(held[1].command[-1] - held[0].command[-1]) > 0.01  # only the command shows the leak


def test_readings_have_the_stated_errors():
    course = simulate(Cylinder(), cycles(2))
    names = ("cap", "rod", "position", "rail", "flow")
    shown = readings(course, Sensors(names=names, offsets={"cap": 7e3}, outliers=0.01, missing=0.3), 1)
    assert shown.shape == (course.time.size, 5)
    assert np.isnan(shown).mean(axis=0) == pytest.approx(0.3, abs=0.06)
    for k, name in enumerate(names):
        error = shown[:, k] - course.channels[name]
        is_outlier = np.abs(error) > 50.0 * NOISE[name]
        assert 0 < is_outlier.sum() < 30
        assert np.nanmedian(error) == pytest.approx(7e3 if name == "cap" else 0.0, abs=0.2 * NOISE[name])
        assert np.nanstd(error[~is_outlier]) == pytest.approx(NOISE[name], rel=0.1)
    # An independent stream: another seed has other errors.
    assert not np.array_equal(shown, readings(course, Sensors(names=names), 2), equal_nan=True)
