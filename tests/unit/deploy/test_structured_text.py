"""Tests of function blocks: the evaluator gives the same bits as the program; names and text are valid.

`tests/cross/test_controller_faults.py` compares blocks that two compilers have compiled.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from controller_targets import CONTROLLERS as CASES
from poppet import Circuit, load
from poppet.cli.main import run
from poppet.deploy.controller import controller_program
from poppet.deploy.st.block import BlockNames, block_of, function_block
from poppet.engine.printers.instructions import instructions
from poppet.engine.printers.st import STRUCTURED_TEXT
from poppet.engine.printers.statements import ResultVariable, Statements, UnsupportedOperationError, Value
from refusals import refused
from structured_text import FunctionBlock

EXAMPLES = Path(__file__).parents[3] / "examples"


@cache
def program(case):
    file, parts = CASES[case]
    return controller_program(load(EXAMPLES / f"{file}.toml"), parts)


def inputs_of(case, rows=400):
    """Inputs that wander about their values, with steps: every branch of a controller is taken."""
    generator = np.random.default_rng(5)
    values = np.array([each.value for each in program(case).inputs])
    slow = np.repeat(generator.uniform(0.6, 1.6, (rows // 40, values.size)), 40, axis=0)
    inputs = np.where(values == 0.0, generator.uniform(-0.05, 0.05, (rows, values.size)), values * slow)
    flags = [item.address in program(case).flags for item in program(case).inputs]
    inputs[:, flags] = values[flags]
    return inputs


@pytest.mark.parametrize("case", CASES)
def test_block_gives_the_same_bits_as_the_program(case):
    one, given = program(case), inputs_of(case)
    block = FunctionBlock(function_block(one))
    names = block.names("VAR_INPUT")[: len(one.inputs)]
    found = []
    flags = [item.address in one.flags for item in one.inputs]
    for row in given:
        values = [bool(value) if flag else value for flag, value in zip(flags, row, strict=True)]
        outputs = block(**dict(zip(names, values, strict=True)))
        found.append([*outputs.values()][: len(one.outputs)])
    known = one.run(given).outputs
    assert np.array_equal(np.array(found), known)
    assert np.ptp(known, axis=0).astype(bool).sum() >= 2


@pytest.mark.parametrize("case", ["pid", "electronics"])
def test_block_gives_the_commands_of_the_run(case):
    """Compare the text with a run of the circuit, without the program in between."""
    file, _ = CASES[case]
    controller, circuit = program(case), load(EXAMPLES / f"{file}.toml")
    run = circuit.with_values({"run.maximum_step": controller.cycle / 2.0}).simulate(0.5, controller.cycle)
    shown = {
        "measurement": "sensor_pressure",
        "outlet_pressure": "outlet_sensor_pressure",
        "pilot_pressure": "pilot_sensor_pressure",
    }
    block = FunctionBlock(function_block(controller))
    commands = []
    for k in range(run.time.size - 1):
        addresses = {item.address.partition(".")[2]: item.address for item in controller.inputs}
        values = {
            name: float(run[f"{a.partition('.')[0]}.{shown.get(name, name)}"][k]) for name, a in addresses.items()
        }
        flags = {item.address.partition(".")[2] for item in controller.inputs if item.address in controller.flags}
        values |= {name: bool(values[name]) for name in flags}
        commands.append([*block(**values).values()][: len(controller.outputs)])
    for k, output in enumerate(controller.outputs):
        expected = run[output.address][:-1]
        assert np.allclose(np.array(commands)[:, k], expected, rtol=1e-11, atol=1e-11 * np.abs(expected).max()), (
            output.address
        )


def test_parameters_are_inputs_and_restart_resets_the_block():
    controller = program("pid")
    block, changed = (
        FunctionBlock(function_block(controller)),
        load(EXAMPLES / "pressure_control.toml").with_values({"regulator.gain": "4 1/bar"}),
    )
    inputs = inputs_of("pid", 80)
    names = block.names("VAR_INPUT")[: len(controller.inputs)]
    flags = [item.address in controller.flags for item in controller.inputs]
    for gain, one in ((9.21e-5, controller), (4e-5, controller_program(changed))):
        outputs = []
        for k, row in enumerate(inputs):
            values = [bool(value) if flag else value for flag, value in zip(flags, row, strict=True)]
            outputs.append(block(**dict(zip(names, values, strict=True)), gain=gain, restart=not k)["command"])
        assert np.array_equal(outputs, one.run(inputs).outputs[:, 0])


def test_block_measures_time_and_reports_invalid_parameters():
    block = FunctionBlock(function_block(program("pid")))
    integrals = [block(setpoint=4e5, measurement=3e5 + 1e3 * k, cycle_time=5e-4)["integral_1"] for k in range(5)]
    assert integrals[:4] == [integrals[0]] * 4 != [integrals[4]] * 4
    results = block(sample_time=0.0)
    assert results["parameter_held"] is True
    assert results["integral_1"] == integrals[4]


def test_variables_are_declared_in_their_sections():
    """Flags are Boolean inputs, and intermediate values are temporary."""
    text = function_block(program("pid"))
    temporary = text.partition("VAR_TEMP")[2].partition("END_VAR")[0]
    stored = text.partition("\nVAR\n")[2].partition("END_VAR")[0]
    assert "automatic : BOOL := TRUE;" in text.partition("VAR_OUTPUT")[0]
    assert "error : LREAL;" in temporary
    assert "is_started : BOOL := FALSE;" in stored
    assert "held_gain : LREAL := 9.21E-05;" in stored


def test_special_names_become_valid_and_distinct():
    names = BlockNames()
    texts = [
        "a.b", "A_B", "a__b_", "end_if", "INTEGRAL", "Is_Late", "safe", "never", "1st", "größe", "(* x *)", "x" * 50,
        "x" * 60, "'; DROP", "end_if_", "", "END_FUNCTION_BLOCK",
    ]  # fmt: skip
    identifiers = [names.add(text) for text in texts]
    assert len({text.lower() for text in identifiers}) == len(texts)
    # As the standard writes identifiers: no underline at the end, and no two of them.
    assert all(re.fullmatch(r"[A-Za-z](_?[A-Za-z0-9])*", text) and len(text) <= 32 for text in identifiers)
    assert not {text.lower() for text in identifiers} & {
        "end_if",
        "integral",
        "is_late",
        "safe",
        "never",
        "end_function_block",
    }


def test_special_characters_in_titles_stay_in_the_comment():
    circuit = load(EXAMPLES / "pressure_control.toml")
    hostile = "x *) END_FUNCTION_BLOCK (* ü\nVAR\n" + "y" * 30
    parts = {("Pid" + "a" * 60): circuit.parts["regulator"]}
    text = function_block(controller_program(Circuit(parts, title=hostile)))
    assert text.isascii()
    assert text.count("END_FUNCTION_BLOCK") == text.replace(text.splitlines()[0], "").count("END_FUNCTION_BLOCK") + 1
    FunctionBlock(text)
    assert re.search(r"FUNCTION_BLOCK (\w{1,32})\n", text)


def test_unsupported_operations_are_refused(monkeypatch):
    x = ca.SX.sym("x")
    for expression in (ca.erf(x), x + ca.SX(float("inf"))):
        statements = Statements(STRUCTURED_TEXT, [[Value("x")]], [[ResultVariable("y")]], str)
        with pytest.raises(UnsupportedOperationError):
            statements.read(instructions(ca.Function("f", [x], [expression])))
    controller = program("pid")
    monkeypatch.setitem(
        controller.functions, "outputs", ca.Function("outputs", *_with_erf(controller.functions["outputs"]))
    )
    with refused("deploy.no_structured_text", "regulator", what="erf"):
        function_block(controller)


def test_a_signal_from_a_file_is_refused_before_anything_is_written(tmp_path, capsys):
    """A block has no file to read; the same input with a value is an input of the block."""
    text = (EXAMPLES / "pressure_control.toml").read_text(encoding="utf-8")
    begin = text.index('[signals."regulator.setpoint"]')
    end = text.index("\n[", begin)
    signal = '[signals."regulator.setpoint"]\nkind = "file"\npath = "wish.csv"\ncolumn = "wish"\nunit = "bar"\n'
    (tmp_path / "wish.csv").write_text("time [s],wish [bar]\n0,2\n1,3\n", encoding="utf-8")
    file, out = tmp_path / "loop.toml", tmp_path / "block.st"
    file.write_text(text[:begin] + signal + text[end:], encoding="utf-8")
    with refused("deploy.file_in_block", "regulator.setpoint"):
        block_of(load(file))
    command = ["export", "st", str(file), "--part", "regulator", "-o", str(out)]
    assert run(command) == 2
    assert not out.exists()
    assert "regulator.setpoint" in capsys.readouterr().err
    assert run([*command, "--set", "regulator.setpoint=4 bar"]) == 0
    assert "setpoint" in out.read_text(encoding="utf-8")


def _with_erf(function):
    arguments = function.sx_in()
    outputs, status = function(*arguments)
    return arguments, [ca.erf(outputs), status]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("x := 1.0;", SyntaxError), ("y := TRUE;", TypeError), ("y := 1.0 / (z - z);", ZeroDivisionError),
        ("y := SQRT(-1.0 - z);", ValueError), ("y := z AND TRUE;", TypeError), ("y := 'a';", SyntaxError),
        ("y := 1.0", SyntaxError), ("y := 1;", TypeError),
    ],
)  # fmt: skip
def test_evaluator_refuses_invalid_structured_text(text, kind):
    head = "FUNCTION_BLOCK b VAR_OUTPUT y : LREAL; END_VAR VAR z : LREAL; END_VAR "
    with pytest.raises(kind):
        FunctionBlock(f"{head}{text} END_FUNCTION_BLOCK")()
