"""Exported controllers with invalid inputs, wrong times and wrong parameters, on all targets.

The targets are C in double and single precision, structured text by the evaluator of the tests and by two compilers,
and the traced program, which contains the equations of the simulation.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from controller_targets import (
    CONTROLLERS,
    calls_of,
    compile_c_export,
    compile_with_matiec,
    compile_with_strucpp,
    run_evaluator,
    run_library,
    run_program,
)
from poppet import load
from poppet.deploy.controller import controller_program
from poppet.deploy.controller_program import STATUS
from poppet.timeseries.signals import Steps

EXAMPLES = Path(__file__).parents[2] / "examples"
HELD, SAFE, SATURATED, LATE, PARAMETER = (1 << k for k in range(len(STATUS)))
TARGETS = ("double", "single", "evaluator", "matiec", "strucpp")


@cache
def circuit_of(case):
    return load(EXAMPLES / f"{CONTROLLERS[case][0]}.toml")


@cache
def program_of(case):
    return controller_program(circuit_of(case), CONTROLLERS[case][1])


def usual_inputs(case, n, seed=5):
    """Inputs that wander about their values, with steps: every branch of a controller is taken."""
    generator = np.random.default_rng(seed)
    values = np.array([item.value for item in program_of(case).inputs])
    slow = np.repeat(generator.uniform(0.6, 1.6, (-(-n // 40), values.size)), 40, axis=0)[:n]
    inputs = np.where(values == 0.0, generator.uniform(-0.05, 0.05, (n, values.size)), values * slow)
    for k, item in enumerate(program_of(case).inputs):
        if item.address in program_of(case).flags:
            inputs[:, k] = item.value
    return inputs.astype(np.float32).astype(float)


@cache
def library_of(target, case, folder):
    """Compile a target once for all tests of this process."""
    folder = folder / f"{target}_{case.replace(' ', '_')}"
    if target in ("double", "single"):
        return compile_c_export(circuit_of(case), CONTROLLERS[case][1], folder, target)
    return {"matiec": compile_with_matiec, "strucpp": compile_with_strucpp}[target](program_of(case), folder)


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("controllers")


def run_on(target, case, calls, folder):
    if target == "evaluator":
        return run_evaluator(program_of(case), calls)
    return run_library(library_of(target, case, folder), program_of(case), calls)


def check_equal(target, case, calls, folder):
    """Compare a target with the traced program: outputs and status of each call."""
    expected, bits = run_program(program_of(case), calls)
    outputs, status = run_on(target, case, calls, folder)
    size = np.abs(expected).max(axis=0)
    tolerance = {"single": 2e-4, "matiec": 1e-13, "strucpp": 1e-13}.get(target, 1e-15)
    differences = np.abs(outputs - expected).max(axis=1) if not size.any() else np.abs(outputs - expected)
    assert np.isfinite(outputs).all()
    assert (differences <= tolerance * np.where(size > 0.0, size, 1.0)).all(), np.max(
        differences / np.maximum(size, 1e-300)
    )
    if target == "single":
        # A command at the border of its limits can be cut in one precision only.
        assert np.mean((status | SATURATED) == (bits | SATURATED)) == 1.0
        assert np.mean(status == bits) > 0.98
    else:
        assert np.array_equal(status, bits)
    return expected, bits


def numeric(case):
    return [k for k, item in enumerate(program_of(case).inputs) if item.address not in program_of(case).flags]


def fault_calls(case, name):
    """Return the calls of a fault by its name."""
    program = program_of(case)
    n = 300
    inputs, generator = usual_inputs(case, n), np.random.default_rng(11)
    parameters = np.tile([parameter.value for parameter in program.parameters], (n, 1))
    intervals = np.full(n, program.cycle)
    if name == "inputs":
        # Each input is invalid for a short and for a long time, and one from the first call.
        inputs[:3, numeric(case)[0]] = np.nan
        for place, k in enumerate(numeric(case)):
            invalid = (np.nan, np.inf, -np.inf, 1e30)[place % 4]
            inputs[20 + 30 * place : 22 + 30 * place, k] = invalid
        inputs[180:280, numeric(case)[-1]] = np.nan
    elif name == "jitter":
        instants = program.cycle * (np.arange(n) + generator.uniform(-0.5, 0.5, n))
        intervals = np.diff(instants, prepend=0.0)
    elif name == "times":
        intervals[0], intervals[40], intervals[80], intervals[120] = 1e3, 10.0, -1.0, np.nan
        intervals[160:170], intervals[200:220] = 0.0, 1.29 * program.cycle
    elif name == "parameters":
        for k, parameter in enumerate(program.parameters):
            if k % 3 == 0:
                parameters[10 + 5 * k : 13 + 5 * k, k] = (np.nan, parameter.low - 1.0, parameter.high * 2.0 + 1.0)
    elif name == "random":
        n = 2000
        inputs = usual_inputs(case, n, 7)
        scale = 10.0 ** generator.uniform(-2, 8, (n, inputs.shape[1])) * generator.choice([-1.0, 1.0], inputs.shape)
        wild = generator.random(inputs.shape) < 0.02
        inputs = np.where(wild, scale * (1.0 + np.abs(inputs)), inputs)
        inputs[generator.random(inputs.shape) < 0.02] = np.nan
        for k, item in enumerate(program.inputs):
            if item.address in program.flags:
                inputs[:, k] = np.repeat(generator.integers(0, 2, -(-n // 25)), 25)[:n]
        inputs = inputs.astype(np.float32).astype(float)
        parameters = np.tile(parameters[0], (n, 1))
        intervals = program.cycle * generator.choice([0.5, 1.0, 1.0, 1.0, 1.5, 3.0], n)
    return calls_of(program, inputs, parameters, intervals)


FAULTS = {"inputs": HELD | SAFE, "jitter": 0, "times": LATE, "parameters": PARAMETER, "random": HELD}
"""Bits that each fault must set in some call."""


@pytest.mark.parametrize("case", CONTROLLERS)
@pytest.mark.parametrize("target", TARGETS)
def test_target_reacts_to_faults_like_the_program(target, case, folder):
    for fault, expected in FAULTS.items():
        if target == "single" and fault == "random":
            continue  # decisions near a threshold differ in single precision; the bounds are tested below
        _, bits = check_equal(target, case, fault_calls(case, fault), folder)
        assert (np.bitwise_or.reduce(bits) & expected) == expected, fault


@pytest.mark.slow
@pytest.mark.parametrize("case", CONTROLLERS)
@pytest.mark.parametrize("target", ["matiec", "strucpp"])
def test_compiled_text_equals_compiled_c_in_20000_calls(target, case, folder):
    """Random and invalid inputs, parameters and times, long faults and restarts: all bits are equal."""
    program, n, generator = program_of(case), 20_000, np.random.default_rng(3)
    inputs = usual_inputs(case, n, 7)
    scale = 10.0 ** generator.uniform(-2, 8, inputs.shape) * generator.choice([-1.0, 1.0], inputs.shape)
    inputs = np.where(generator.random(inputs.shape) < 0.02, scale * (1.0 + np.abs(inputs)), inputs)
    inputs[generator.random(inputs.shape) < 0.02] = np.nan
    for place, first in enumerate(range(500, n, 2000)):
        inputs[first : first + 400, numeric(case)[place % len(numeric(case))]] = np.nan
    for k, item in enumerate(program.inputs):
        if item.address in program.flags:
            inputs[:, k] = np.repeat(generator.integers(0, 2, n // 25), 25)
    parameters = np.tile([parameter.value for parameter in program.parameters], (n, 1))
    for first in range(0, n, 400):
        wrong = generator.choice([np.nan, np.inf, -1e30])
        parameters[first : first + 5, generator.integers(parameters.shape[1])] = wrong
    intervals = program.cycle * generator.choice([0.5, 1.0, 1.0, 1.0, 1.5, 3.0], n)
    intervals[generator.random(n) < 0.002] = -1.0
    calls = calls_of(program, inputs, parameters, intervals, generator.random(n) < 0.001)
    expected, bits = run_on("double", case, calls, folder)
    outputs, status = run_on(target, case, calls, folder)
    assert np.array_equal(outputs, expected)
    assert np.array_equal(status, bits)
    assert np.bitwise_or.reduce(bits) == HELD | SAFE | SATURATED | LATE | PARAMETER


@pytest.mark.parametrize("target", ["double", "single", "evaluator", "matiec", "strucpp"])
def test_restart_resets_the_memory(target, folder):
    program = program_of("pid")
    inputs = usual_inputs("pid", 60)
    restarts = np.arange(60) == 30
    outputs, status = run_on(target, "pid", calls_of(program, inputs, restarts=restarts), folder)
    fresh, bits = run_program(program, calls_of(program, inputs[30:]))
    tolerance = 1e-5 if target == "single" else 1e-13
    assert np.allclose(outputs[30:], fresh, rtol=0.0, atol=tolerance * np.abs(fresh).max())
    assert np.array_equal(status[30:], bits)


@pytest.mark.parametrize("precision", ["double", "single"])
@pytest.mark.parametrize("case", CONTROLLERS)
def test_no_valve_opens_without_reason(case, precision, folder):
    """Random and invalid inputs: commands are finite and within limits, and safe commands close the valves."""
    calls = fault_calls(case, "random")
    outputs, status = run_on(precision, case, calls, folder)
    assert np.isfinite(outputs).all()
    names = [output.address.rpartition(".")[2] for output in program_of(case).outputs]
    for k, name in enumerate(names):
        if name in ("fill_command", "vent_command", "fill_duty", "vent_duty"):
            assert outputs[:, k].min() >= 0.0
            assert outputs[:, k].max() <= 1.0
    # All controllers have had an invalid input for the fault time: every valve is closed.
    longest = 0.1 + 2.0 * program_of(case).cycle
    invalid = calls_of(program_of(case), np.where(np.arange(400)[:, None] > 50, np.nan, usual_inputs(case, 400)))
    outputs, status = run_on(precision, case, invalid, folder)
    late = 52 + int(np.ceil(longest / program_of(case).cycle))
    assert (status[late:] & SAFE).all()
    for k, name in enumerate(names):
        if name in ("fill_command", "vent_command", "fill_duty", "vent_duty"):
            assert not outputs[late:, k].any()


@pytest.mark.parametrize("case", CONTROLLERS)
def test_held_inputs_equal_their_last_valid_values(case):
    """A short fault acts as the last valid value with the flag `input_fault`; it never acts as zero or as a jump."""
    program = program_of(case)
    inputs = usual_inputs(case, 200)
    repeated = inputs.copy()
    flag = [k for k, item in enumerate(program.inputs) if item.address.endswith("input_fault")]
    for k in numeric(case):
        inputs[60:64, k] = np.nan
        repeated[60:64, k] = repeated[59, k]
    repeated[60:64, flag] = 1.0
    outputs, status = program.run(inputs)
    assert np.array_equal(outputs, program.run(repeated).outputs)
    assert [*np.flatnonzero(status & HELD)] == [60, 61, 62, 63]


@pytest.mark.parametrize(("case", "command", "measurement"), [("pid", 0, 1), ("position", 0, 1)])
def test_recovery_is_bumpless(case, command, measurement):
    """After a long fault, the command starts at the safe command and moves by one increment of the integral."""
    program = program_of(case)
    values = np.array([item.value for item in program.inputs])
    inputs = np.tile(values, (400, 1))
    inputs[:, 0] = values[0] * 1.2 if values[0] else 0.02
    inputs[100:300, measurement] = np.nan
    # Meanwhile the measurement has changed.
    inputs[300:, measurement] = values[measurement] * 1.1 if values[measurement] else 0.015
    outputs, status = program.run(inputs)
    safe = outputs[298, command]
    assert status[298] & SAFE
    assert not status[300] & (HELD | SAFE)
    before = np.abs(np.diff(outputs[1:100, command])).max()
    assert abs(outputs[300, command] - safe) <= 1e-12 + before


def index_of(items, name):
    return next(k for k, item in enumerate(items) if item.address.partition(".")[2] == name)


def interrupted(program, measurement, *, n_faulty, change):
    """Inputs of 300 calls: from call 100, a measurement is invalid, and afterwards it has changed."""
    values = np.array([item.value for item in program.inputs])
    k = index_of(program.inputs, measurement)
    inputs = np.tile(values, (300, 1))
    inputs[100 : 100 + n_faulty, k] = np.nan
    inputs[100 + n_faulty :, k] = values[k] + change
    return inputs


@pytest.mark.parametrize(
    ("case", "values", "output"),
    [
        ("pid", {"regulator.derivative_time": "20 ms"}, "derivative"),
        ("feedback linearisation", {}, "disturbance"),
    ],
)
@pytest.mark.parametrize("n_faulty", [10, 80])
def test_change_during_a_fault_is_no_derivative(case, values, output, n_faulty):
    """Derivative and observer do not attribute the change of a measurement during a fault to one sample."""
    program = controller_program(circuit_of(case).with_values(values), CONTROLLERS[case][1])
    outputs, status = program.run(interrupted(program, "measurement", n_faulty=n_faulty, change=5e4))
    assert bool(status[99 + n_faulty] & SAFE) == (n_faulty > 50)
    assert not status[100 + n_faulty] & HELD
    column = outputs[:, index_of(program.outputs, output)]
    # Without a fault, the same change has an effect.
    plain = interrupted(program, "measurement", n_faulty=0, change=5e4)
    kick = np.abs(np.diff(program.run(plain).outputs[:, index_of(program.outputs, output)])).max()
    assert kick > 0.0
    assert abs(column[100 + n_faulty] - column[99 + n_faulty]) <= 1e-9 * kick + np.abs(np.diff(column[50:100])).max()


@pytest.mark.parametrize("outer", ["1 ms", "5 ms"])
@pytest.mark.parametrize("n_faulty", [20, 120, 122])
def test_change_during_a_fault_is_no_derivative_of_electronics(outer, n_faulty):
    """The pilot setpoint after a fault does not depend on the derivative time, for any ratio of the sample times."""
    values = {"valve.electronics.outer.sample_time": outer}

    def pilot_setpoints(derivative_time, n_faulty):
        changed = values | {"valve.electronics.outer.derivative_time": derivative_time}
        program = controller_program(circuit_of("electronics").with_values(changed))
        inputs = interrupted(program, "outlet_pressure", n_faulty=n_faulty, change=2e4)
        inputs[:, index_of(program.inputs, "setpoint")] = 1.3e5
        return program.run(inputs).outputs[:, index_of(program.outputs, "pilot_setpoint")]

    assert np.array_equal(pilot_setpoints("0 ms", n_faulty), pilot_setpoints("50 ms", n_faulty))
    # Without a fault, the same change has an effect.
    assert not np.array_equal(pilot_setpoints("0 ms", 0), pilot_setpoints("50 ms", 0))


@pytest.mark.parametrize("case", ["pid", "feedback linearisation"])
@pytest.mark.parametrize(("safe", "expected"), [(1.0, 0.4), (-1.0, -0.3)])
def test_safe_opening_is_limited(case, safe, expected):
    """A safe command that opens a valve beyond its limit opens it to the limit. It does not open the other valve."""
    program = program_of(case)
    parameters = np.array([parameter.value for parameter in program.parameters])
    for name, value in {"safe_command": safe, "fill_limit": 0.4, "vent_limit": 0.3}.items():
        parameters[index_of(program.parameters, name)] = value
    outputs, status = program.run(np.full((5, len(program.inputs)), np.nan), parameters)
    assert (status & SAFE).all()
    fill, vent = (outputs[:, index_of(program.outputs, name)] for name in ("fill_command", "vent_command"))
    assert fill - vent == pytest.approx(np.full(5, expected), abs=1e-15)


@pytest.mark.parametrize(
    ("case", "name", "value"),
    [
        ("schedule", "schedule.vent_factor_2", 0.0),
        ("schedule", "schedule.integral_time_1", 0.0),
        ("schedule", "schedule.pressure_2", 2e5),
        ("schedule", "schedule.pressure_2", 4.5e5),
        ("cascade", "highest_pressure", 0.9e5),
    ],
)
def test_parameters_of_tables_and_crossed_limits_are_checked(case, name, value):
    """A table that is not valid, or crossed limits, have no effect."""
    program, inputs = program_of(case), usual_inputs(case, 60)
    parameters = np.tile([parameter.value for parameter in program.parameters], (60, 1))
    parameters[20:40, index_of(program.parameters, name)] = value
    outputs, status = program.run(inputs, parameters)
    assert [*np.flatnonzero(status & PARAMETER)] == [*range(20, 40)]
    assert np.array_equal(outputs, program.run(inputs).outputs)


@pytest.mark.parametrize("target", TARGETS)
def test_wrong_sample_time_of_one_sample_does_not_stop_the_controller(target, folder):
    """After one sample with a sample time of 1000 s, the next call uses the correct sample time."""
    program, n = program_of("pid"), 60
    parameters = np.tile([parameter.value for parameter in program.parameters], (n, 1))
    parameters[30, index_of(program.parameters, "sample_time")] = 1e3
    outputs, status = run_on(target, "pid", calls_of(program, manual_inputs(n), parameters), folder)
    assert np.allclose(outputs[1:, 0], manual_inputs(n)[:-1, -1], rtol=1e-6, atol=0.0)
    assert not status.any()


@pytest.mark.parametrize("case", CONTROLLERS)
def test_program_gives_the_commands_of_a_run_with_faults(case):
    """A closed loop has a short and a long input fault; with its recorded inputs, the program agrees."""
    program, cycle = program_of(case), program_of(case).cycle
    # Between two sample instants: the recorded fault at an instant is that of the sample.
    times = np.array([0.0, 0.3 + 0.5 * cycle, 0.34 + 0.5 * cycle, 0.6 + 0.5 * cycle, 0.8 + 0.5 * cycle])
    fault = Steps(times=times, values=np.array([0.0, 1.0, 0.0, 1.0, 0.0]))
    circuit = circuit_of(case)
    faults = {item.address: fault for item in program.inputs if item.address.endswith(".input_fault")}
    circuit = circuit.with_signals({**circuit.signals, **faults}).with_values({"run.maximum_step": cycle / 2.0})
    run = circuit.simulate(1.0, cycle)
    sensed = [program.sensed.get(item.address, (item.address, 0.0)) for item in program.inputs]
    outputs, status = program.run(np.array([run[address][:-1] + offset for address, offset in sensed]).T)
    safe_times = run.time[:-1][(status & SAFE) > 0]
    assert safe_times[0] == pytest.approx(0.7, abs=6.0 * cycle)
    assert safe_times[-1] == pytest.approx(0.8, abs=6.0 * cycle)
    for k, output in enumerate(program.outputs):
        expected = run[output.address][:-1]
        assert outputs[:, k] == pytest.approx(expected, rel=0.0, abs=1e-9 * np.abs(expected).max() + 1e-15)


@pytest.mark.parametrize("case", CONTROLLERS)
@pytest.mark.parametrize("factor", [0.2, 1.0, 2.0, 7.0])
def test_fault_time_is_measured_time(case, factor):
    """A host that calls too rarely, so that samples are dropped, gets the safe command after the same time."""
    program, n = program_of(case), 1000
    inputs, interval = usual_inputs(case, n), factor * program.cycle
    inputs[20:, numeric(case)[0]] = np.nan
    _, status = program.run(inputs, intervals=np.full(n, interval))
    first = next(k for k in range(n) if status[k] & SAFE)
    assert (first - 20) * interval == pytest.approx(0.1, abs=3.0 * interval + 5e-3)


@pytest.mark.parametrize("target", TARGETS)
def test_pause_during_a_fault_counts_for_the_fault_time(target, folder):
    program, n = program_of("pid"), 60
    inputs, intervals = usual_inputs("pid", n), np.full(n, program.cycle)
    inputs[20:, numeric("pid")[0]], intervals[22] = np.nan, 5.0
    _, status = run_on(target, "pid", calls_of(program, inputs, intervals=intervals), folder)
    assert [*np.flatnonzero(status & SAFE)] == [*range(23, n)]


def manual_inputs(n):
    """Inputs of the PID in manual mode: each sample has another command, which acts in the next sample."""
    program = program_of("pid")
    names = [item.address.rpartition(".")[2] for item in program.inputs]
    inputs = np.tile([item.value for item in program.inputs], (n, 1))
    inputs[:, names.index("automatic")] = 0.0
    inputs[:, names.index("manual_command")] = (np.arange(n) % 97 + 1.0) / 200.0
    return inputs


@pytest.mark.parametrize("precision", ["double", "single"])
def test_clock_follows_the_grid_with_jitter(precision, folder):
    """10^6 calls whose instants jitter by half a cycle about a grid: as many samples as instants of the grid."""
    n, program = 1_000_000, program_of("pid")
    instants = program.cycle * (np.arange(n) + np.random.default_rng(3).uniform(-0.5, 0.5, n))
    calls = calls_of(program, manual_inputs(n), intervals=np.diff(instants, prepend=0.0))
    outputs, _ = run_on(precision, "pid", calls, folder)
    # The first two samples give zero: the command acts one sample later.
    executed = 1 + np.cumsum(np.diff(outputs[:, 0], prepend=0.0) != 0.0)
    due = np.floor((instants - instants[0]) / program.cycle + 1e-9) + 1.0
    assert abs(executed[-1] - n) <= 1
    assert (due - executed).max() <= 1.0
    assert (executed - due).max() <= 1.0


@pytest.mark.parametrize("interval", [0.0021, 0.0019])
def test_one_wrong_interval_neither_freezes_nor_bursts(interval, folder):
    """After 200 s, one cycle is reported wrongly: every later call still executes a sample, or the next one does."""
    program = program_of("pid")
    n = 100_500
    inputs = manual_inputs(n)
    intervals = np.full(n, program.cycle)
    intervals[100_000] = interval
    outputs, status = run_on("double", "pid", calls_of(program, inputs, intervals=intervals), folder)
    changes = np.diff(outputs[:, 0]) != 0.0
    assert np.count_nonzero(~changes[1:]) <= 1
    assert not (status & LATE).any()


def test_late_first_call_and_long_pause_execute_one_sample(folder):
    """A first call with a long time, and a pause of 10 s, do not cause a burst of samples."""
    program, n = program_of("pid"), 60
    intervals = np.full(n, program.cycle)
    intervals[0], intervals[30] = 1e3, 10.0
    outputs, status = run_on("double", "pid", calls_of(program, manual_inputs(n), intervals=intervals), folder)
    # The command of each call is that of the call before: exactly one sample in each call.
    assert np.array_equal(outputs[1:, 0], manual_inputs(n)[:-1, -1])
    assert [*np.flatnonzero(status & LATE)] == [30]
