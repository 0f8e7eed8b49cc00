"""Exported step sequences on all targets execute the steps of the simulation, for random sequences and inputs."""

from __future__ import annotations

import re
import tomllib
from functools import cache
from typing import Any

import numpy as np
import pytest

from controller_targets import (
    calls_of,
    compile_c_export,
    compile_with_matiec,
    compile_with_strucpp,
    run_evaluator,
    run_library,
    run_program,
)
from poppet import Circuit, Cylinder, Mass, Orifice, Reservoir, Sequence, SpoolValve, Switch
from poppet.deploy.c.controller import c_controller
from poppet.deploy.controller import controller_program
from poppet.deploy.controller_program import STATUS
from poppet.deploy.st.block import block_of
from poppet.signals import Steps
from source_files import ROOT as PACKAGE

ROOT = PACKAGE.parents[1]

T, N = 5e-3, 400
NAMES = ("extend A", "extend B", "press", "retract B", "retract A", "eject")
HELD, SAFE = (1 << STATUS.index(name) for name in ("input_held", "safe"))
COMPILED = {"double": 6, "single": 3, "matiec": 3, "strucpp": 2}
"""Number of random sequences that each compiler compiles."""


def random_condition(rng, names, depth=0):
    """Return a random condition of the grammar."""
    if depth < 2 and rng.random() < 0.4:
        word = rng.choice(["and", "or"])
        left, right = (random_condition(rng, names, depth + 1) for _ in range(2))
        text = f"({left} {word} {right})"
        return f"not {text}" if rng.random() < 0.3 else text
    match rng.integers(6):
        case 0:
            return f"line{rng.integers(1, 3)}.pressure {rng.choice(['<', '<=', '>', '>='])} {rng.uniform(2, 6):.2f} bar"
        case 1:
            return str(rng.choice(["start", "not stop"]))
        case 2:
            return f"elapsed {rng.choice(['>', '>='])} {rng.integers(2, 12) * 5} ms"
        case 3:
            return f'count("{rng.choice(names)}") >= {rng.integers(1, 5)}'
        case 4:
            return f"line1.pressure > line2.pressure {rng.choice(['+', '-'])} {rng.uniform(0, 1):.2f} bar"
    return f"cycles {rng.choice(['<', '>='])} {rng.integers(1, 4)}"


def random_sequence(seed: int) -> Sequence:
    """Return a random sequence in which every step is reachable."""
    rng = np.random.default_rng(seed)
    names = NAMES[: rng.integers(2, len(NAMES) + 1)]
    outputs = ("a", "b", "c")[: rng.integers(1, 4)]
    steps: dict[str, Any] = {}
    for k, name in enumerate(names):
        targets = [names[(k + 1) % len(names)]]
        others = [other for other in names if other not in (name, *targets)]
        targets += [str(other) for other in rng.permutation(others)[: rng.integers(0, 2)]]
        steps[name] = {"on": [output for output in outputs if rng.random() < 0.5]}
        steps[name]["next"] = {target: random_condition(rng, names) for target in targets}
        steps[name]["timeout"] = {"after": f"{rng.integers(4, 20) * 5} ms", "to": targets[0]}
    if rng.random() < 0.3:
        free = [output for output in outputs if output not in steps[names[0]]["on"]]
        steps[names[0]] |= {"set": dict.fromkeys(free[:1], -0.5)}
    emergency = {"emergency": names[-1]} if rng.random() < 0.5 else {}
    return Sequence(outputs, steps, names[0], ["start", "stop"], sample_time=T, fault_time=20e-3, **emergency)


def circuit_with(sequence: Sequence, **signals: Any) -> Circuit:
    parts: dict[str, Any] = {"plc": sequence}
    for k in (1, 2):
        parts[f"line{k}"] = Reservoir(pressure="4 bar")
        parts[f"leak{k}"] = Orifice(from_=f"line{k}", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3)
    return Circuit(parts, signals)


def random_inputs(program, seed: int) -> np.ndarray:
    """Return inputs of each call: pressures that jump, buttons, and rarely halt, reset, emergency and a fault."""
    rng = np.random.default_rng(seed)
    rates = {"halt": 0.05, "reset": 0.01, "emergency": 0.01, "input_fault": 0.03, "start": 0.4, "stop": 0.3}
    columns = []
    for item in program.inputs:
        name = item.address.partition(".")[2]
        if name in rates:
            values = (rng.random(N) < rates[name]).astype(float)
            # A fault lasts longer than the fault time, a halt for several samples.
            if name in ("input_fault", "halt"):
                values = np.convolve(values, np.ones(8))[:N].clip(0.0, 1.0) * (np.arange(N) > 60)
        else:
            values = 1e5 * np.repeat(rng.uniform(1.5, 6.5, -(-N // 3)), 3)[:N].round(3)
        columns.append(values)
    return np.array(columns).T.astype(np.float32).astype(float)


@cache
def case_of(seed: int):
    circuit = circuit_with(random_sequence(seed))
    return circuit, controller_program(circuit, ["plc"])


def test_names_of_the_program_itself_are_free(tmp_path):
    names = ["in", "param", "is_started", "is_late", "fired", "z", "new_a", "a"]
    steps = {
        "one": {"on": names[::2], "next": {"two": 'run and count("one") < 90'}},
        "two": {"on": names[1::2], "next": {"one": "not run"}},
    }
    circuit = circuit_with(Sequence(names, steps, "one", ["run"], sample_time=T))
    program = controller_program(circuit, ("plc",))
    calls = calls_of(program, random_inputs(program, 1))
    expected = run_program(program, calls)
    assert np.all(np.ptp(expected[0][:, : len(names)], axis=0) == 1.0)
    library = compile_c_export(circuit, ("plc",), tmp_path, "double")
    for results in (run_evaluator(program, calls), run_library(library, program, calls)):
        assert np.array_equal(results[0], expected[0])
        assert np.array_equal(results[1], expected[1])


@pytest.mark.parametrize("seed", range(20))
def test_program_executes_the_steps_of_the_simulation(seed):
    program = case_of(seed)[1]
    inputs = random_inputs(program, seed)
    times = np.concatenate([[0.0], T * (np.arange(1, N) - 0.5)])
    addresses = {"plc.line1_pressure": "line1.pressure", "plc.line2_pressure": "line2.pressure"}
    signals = {
        addresses.get(item.address, item.address): Steps(times.tolist(), column.tolist())
        for item, column in zip(program.inputs, inputs.T, strict=True)
    }
    run = circuit_with(random_sequence(seed), **signals).simulate(N * T, T / 2)
    outputs, status = run_program(program, calls_of(program, inputs))
    names = [output.address for output in program.outputs]
    for name in names:
        if name != "plc.elapsed":
            assert np.array_equal(outputs[:, names.index(name)], run[name][1::2]), name
    # Between two samples, the time in the step continues unless the sequence is held.
    later = run["plc.elapsed"][1::2] - outputs[:, names.index("plc.elapsed")]
    assert np.all((np.abs(later) < 1e-9) | (np.abs(later - T / 2) < 1e-9))
    assert np.count_nonzero(np.diff(outputs[:, names.index("plc.step")])) >= 8
    assert np.any(status & SAFE)


def fault_inputs(program, seed):
    """Return inputs some of which are not finite, with jitter of the calls."""
    rng = np.random.default_rng(seed + 100)
    inputs = random_inputs(program, seed)
    numeric = [k for k, item in enumerate(program.inputs) if item.address not in program.flags]
    for k in numeric:
        inputs[rng.random(N) < 0.02, k] = rng.choice([np.nan, np.inf, -np.inf])
    if numeric:
        inputs[200:240, numeric[0]] = np.nan
    return inputs, T * (1.0 + rng.uniform(-0.4, 0.4, N))


def times_and_parameters(program, seed):
    """Return calls with late and invalid times, and with invalid and changed parameters."""
    intervals = np.full(N, T)
    intervals[0], intervals[40], intervals[80], intervals[120] = 1e3, 10.0, -1.0, np.nan
    intervals[160:170], intervals[200:220] = 0.0, 1.29 * T
    parameters = np.tile([parameter.value for parameter in program.parameters], (N, 1))
    for k, parameter in enumerate(program.parameters):
        parameters[10 + 5 * k : 13 + 5 * k, k] = (np.nan, parameter.low - 1.0, parameter.high * 2.0 + 1.0)
        if parameter.address.endswith(".timeout.after"):
            parameters[N // 2 :, k] *= 2.0
    return calls_of(program, random_inputs(program, seed), parameters, intervals)


def check_target(run, seed, target):
    """Compare outputs and status of each call with the traced program, without and with faults and jitter."""
    program = case_of(seed)[1]
    wrong, intervals = fault_inputs(program, seed)
    many_calls = [calls_of(program, random_inputs(program, seed)), times_and_parameters(program, seed)]
    for calls in (*many_calls, calls_of(program, wrong, intervals=intervals)):
        expected, bits = run_program(program, calls)
        outputs, status = run(program, calls)
        elapsed = [output.address for output in program.outputs].index("plc.elapsed")
        others = [k for k in range(expected.shape[1]) if k != elapsed]
        assert np.array_equal(outputs[:, others], expected[:, others])
        tolerance = 1e-6 if target == "single" else 0.0
        assert np.max(np.abs(outputs[:, elapsed] - expected[:, elapsed])) <= tolerance
        assert np.array_equal(status, bits)
    assert np.any(bits & HELD) == (len(program.flags) < len(program.inputs))


@pytest.mark.parametrize("seed", range(20))
def test_structured_text_executes_the_steps(seed):
    check_target(run_evaluator, seed, "evaluator")


@pytest.mark.parametrize("has_emergency", [False, True])
def test_an_invalid_input_ends_in_the_safe_state(has_emergency):
    """After the fault time, all outputs are 0, or the emergency step begins; a shorter fault has no effect."""
    seed = next(k for k in range(20) if bool(random_sequence(k).program.form.emergency) == has_emergency)
    program = case_of(seed)[1]
    inputs = random_inputs(program, seed)
    for k, item in enumerate(program.inputs):
        if item.address.rpartition(".")[2] in ("halt", "reset", "emergency", "input_fault"):
            inputs[:, k] = 0.0
    pressure = next(k for k, item in enumerate(program.inputs) if item.address not in program.flags)
    inputs[100:103, pressure] = inputs[200:240, pressure] = np.nan
    outputs, status = run_evaluator(program, calls_of(program, inputs))
    names = [output.address.partition(".")[2] for output in program.outputs]
    commands = [k for k, name in enumerate(names) if name not in ("step", "elapsed", "cycles")]
    # Four samples of 5 ms are the fault time.
    assert np.array_equal(np.flatnonzero(status & SAFE), np.arange(204, 240))
    assert np.array_equal(np.flatnonzero(status & HELD), [100, 101, 102, *range(200, 240)])
    steps = outputs[204:240, names.index("step")]
    if has_emergency:
        last = len(case_of(seed)[0].parts["plc"].program.steps)
        assert np.all(steps == last)
    else:
        assert np.all(outputs[204:240, commands] == 0.0)
        assert np.all(steps == steps[0])
    assert np.any(outputs[:200, commands] != 0.0)


def test_a_restart_executes_the_first_step(tmp_path):
    """C and structured text start again at the same calls, and keep the last valid inputs."""
    circuit, program = case_of(0)
    restarts = np.zeros(N, dtype=bool)
    restarts[[100, 101, 250]] = True
    calls = calls_of(program, random_inputs(program, 0), restarts=restarts)
    (outputs, status), (expected, bits) = (
        run_library(compile_c_export(circuit, ("plc",), tmp_path, "double"), program, calls),
        run_evaluator(program, calls),
    )
    assert np.array_equal(outputs, expected)
    assert np.array_equal(status, bits)
    names = [output.address for output in program.outputs]
    assert np.all(outputs[100:101, names.index("plc.elapsed")] == 0.0)
    assert np.all(np.diff(outputs[:, names.index("plc.cycles")])[[99, 249]] < 0.0)


@pytest.mark.parametrize(("target", "seed"), [(target, seed) for target, n in COMPILED.items() for seed in range(n)])
def test_compiled_text_executes_the_steps(target, seed, tmp_path):
    circuit, program = case_of(seed)
    if target in ("double", "single"):
        library = compile_c_export(circuit, ("plc",), tmp_path / "c", target)
    else:
        library = {"matiec": compile_with_matiec, "strucpp": compile_with_strucpp}[target](program, tmp_path / "st")
    check_target(lambda program, calls: run_library(library, program, calls), seed, target)


def coupled_circuit(**signals: Any) -> Circuit:
    """Return two sequences that read each other at equal instants, and a pressure switch with a shorter sample time."""
    filling = {
        "wait": {"next": {"fill": 'start and other.step == "idle"'}},
        "fill": {"on": ["valve"], "next": {"done": "full.state == 1"}, "timeout": {"after": "60 ms", "to": "wait"}},
        "done": {"next": {"wait": 'other.step == "empty" and elapsed > 10 ms'}},
    }
    emptying = {
        "idle": {"next": {"empty": 'plc.step == "done"'}},
        "empty": {"on": ["vent"], "next": {"idle": "full.state == 0"}, "timeout": {"after": "50 ms", "to": "idle"}},
    }
    parts = {
        "plc": Sequence(["valve"], filling, "wait", ["start"], sample_time=T),
        "other": Sequence(["vent"], emptying, "idle", sample_time=T),
        "full": Switch(measurement="line1.pressure", on_above="4 bar", off_below="3 bar", sample_time=T / 5),
        "line1": Reservoir(pressure="2 bar"),
        "leak1": Orifice(from_="line1", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3),
    }
    return Circuit(parts, signals)


COUPLED = ("plc", "other", "full")


def test_coupled_sequences_and_switches_are_one_program(tmp_path):
    program = controller_program(coupled_circuit(), COUPLED)
    assert [item.address for item in program.inputs if item.address not in program.flags] == ["full.measurement"]
    assert program.output_flags == {"plc.valve", "other.vent", "full.state"}
    assert program.cycle == T / 5
    n, rng = 5 * N, np.random.default_rng(3)
    inputs = np.zeros((n, len(program.inputs)))
    for k, item in enumerate(program.inputs):
        if item.address == "full.measurement":
            inputs[:, k] = 1e5 * np.repeat(rng.uniform(2, 5, -(-n // 20)), 20)[:n].round(3)
        elif item.address == "plc.start":
            inputs[:, k] = np.repeat(rng.random(n // 20) < 0.7, 20)
    times = np.concatenate([[0.0], T / 5 * (np.arange(1, n) - 0.5)])
    addresses = {"full.measurement": "line1.pressure"}
    signals = {
        addresses.get(item.address, item.address): Steps(times.tolist(), column.tolist())
        for item, column in zip(program.inputs, inputs.T, strict=True)
    }
    run = coupled_circuit(**signals).simulate(n * T / 5, T / 10)
    calls = calls_of(program, inputs)
    expected, bits = run_program(program, calls)
    names = [output.address for output in program.outputs]
    for name in ("plc.valve", "plc.step", "plc.cycles", "other.vent", "other.step", "full.state"):
        assert np.array_equal(expected[:, names.index(name)], run[name][1::2]), name
    assert run["plc.cycles"][-1] >= 3.0
    assert run["other.cycles"][-1] >= 3.0
    library = compile_c_export(coupled_circuit(), COUPLED, tmp_path, "double")
    for target in (run_evaluator, lambda program, calls: run_library(library, program, calls)):
        outputs, status = target(program, calls)
        assert np.allclose(outputs, expected, rtol=0.0, atol=1e-12)
        assert np.array_equal(status, bits)


def test_pages_show_the_printed_statements():
    """The pages on structured text and on C show statements of the sequence in the first page."""
    pages = {name: (ROOT / "docs" / f"{name}.md").read_text(encoding="utf-8") for name in ("plc", "export_c")}
    blocks = re.findall(r"^```(\w+)[^\n]*\n(.*?)^```$", "\n".join(pages.values()), re.MULTILINE | re.DOTALL)
    (table,) = [
        tomllib.loads(block)["parts"]["plc"] for kind, block in blocks if kind == "toml" and "sequence" in block
    ]
    assert table.pop("kind") == "sequence"
    shown = [block for _, block in blocks if "next_step" in block or "new_a" in block]
    parts: dict[str, Any] = {"supply": Reservoir(pressure="7 bar"), "plc": Sequence(**table)}
    for letter in "AB":
        ends = {"a": f"cylinder{letter}.cap", "b": f"cylinder{letter}.rod"}
        parts[f"valve{letter}"] = SpoolValve(supply="supply", **ends, sonic_conductance=1e-8, critical_ratio=0.3)
        parts[f"cylinder{letter}"] = Cylinder(
            bore="25 mm", stroke_length="100 mm", body=f"slide{letter}", cap={"dead_volume": 1e-5},
            rod={"dead_volume": 1e-5},
        )  # fmt: skip
        parts[f"slide{letter}"] = Mass(mass="1 kg")
    circuit = Circuit(parts)
    printed = block_of(circuit, ["plc"]) + c_controller(circuit, ["plc"])["plc.c"]
    assert len(shown) == 3
    assert all(block in printed for block in shown)
