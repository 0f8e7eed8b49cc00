"""Tests of controller programs: commands equal those of a simulation; invalid parts are refused."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet import Circuit, load
from poppet.deploy.controller import controller_program
from poppet.deploy.controller_program import SIGNATURES
from poppet.parts.part import ControlOutputs, Scope, State
from refusals import refused

sys.path.insert(0, str(Path(__file__).parents[1]))
from sampled_parts import Proportional

EXAMPLES = Path(__file__).parents[3] / "examples"
SENSOR = {"regulator.measurement": "regulator.sensor_pressure"}
OUTLET = {
    "valve.outlet_pressure": "valve.outlet_sensor_pressure",
    "valve.pilot_pressure": "valve.pilot_sensor_pressure",
}
POSITION, ANGLE = ({"position.measurement": f"position.sensor_{name}"} for name in ("position", "angle"))
CASES = {
    "pid": ("pressure_control", (), SENSOR, 1.0),
    "schedule": ("pressure_control_scheduled", (), SENSOR, 1.0),
    "feedback linearisation": ("pressure_control_linearising", (), SENSOR, 1.0),
    "position": ("position_control", (), POSITION, 0.5),
    "dead zone": ("position_dead_zone", (), POSITION, 0.5),
    "electronics": ("pressure_regulator", (), OUTLET, 0.5),
    "sequence": ("two_cylinders", ("plc", "pressed"), {}, 2.0),
    "cascade": ("muscle_joint", ("position", "inverse", "valve"), {**ANGLE, **OUTLET}, 1.2),
}
"""File, parts, what their sensors show, and length of the run [s]."""


@pytest.mark.parametrize("case", CASES)
def test_program_gives_the_commands_of_the_run(case):
    file, parts, sensors, duration = CASES[case]
    circuit = load(EXAMPLES / f"{file}.toml")
    program = controller_program(circuit, parts)
    # A row then shows what the program saw at its instant: no step passes over one.
    step_limited = circuit.with_values({"run.maximum_step": program.cycle / 2.0})
    run = step_limited.simulate(duration, program.cycle)
    u = np.array([run[sensors.get(item.address, item.address)] for item in program.inputs]).T[:-1]
    commands = program.run(u).outputs
    assert len(program.outputs) >= 2
    for k, output in enumerate(program.outputs):
        expected = run[output.address][:-1]
        assert np.allclose(commands[:, k], expected, rtol=1e-11, atol=1e-11 * np.abs(expected).max()), output.address
    assert np.ptp(commands, axis=0).astype(bool).sum() >= 2


def test_program_excludes_sensors_and_includes_connections():
    program = controller_program(load(EXAMPLES / "muscle_joint.toml"), ["position", "inverse", "valve"])
    inputs = [quantity.address for quantity in program.inputs]
    assert "position.setpoint" in inputs
    assert not {"inverse.force", "valve.setpoint"} & set(inputs)
    assert not any("sensor" in quantity.address for quantity in (*program.parameters, *program.outputs))
    n_in = {name: f.n_in() for name, f in program.functions.items()}
    assert n_in == {"accept": 3, "start": 1, "advance": 2, "update": 2, "outputs": 1}
    assert [*program.functions] == [*SIGNATURES]


def test_sensor_offset_is_part_of_the_input():
    circuit = load(EXAMPLES / "pressure_control.toml")
    offset_circuit = circuit.with_values({"regulator.sensor.offset": "0.2 bar"})
    u = np.array([[4e5, 3e5, 0.0, 1.0, 0.0], [4e5, 3.1e5, 0.0, 1.0, 0.0]])
    outputs = [controller_program(one).run(u).outputs for one in (circuit, offset_circuit)]
    assert np.array_equal(*outputs)


def test_parameters_are_free_and_the_cycle_is_the_shortest_sample_time():
    circuit = load(EXAMPLES / "pressure_control.toml").with_values({"regulator.acts": "at_once"})
    program = controller_program(circuit)
    assert program.cycle == 2e-3
    indices = {parameter.address: k for k, parameter in enumerate(program.parameters)}
    p = np.array([parameter.value for parameter in program.parameters])
    # Held between samples: called four times in each sample time.
    u = np.array([[4e5, 3e5 + 1e3 * k, 0.0, 1.0, 0.0] for k in range(12)])
    slow = program.run(u, intervals=np.full(12, program.cycle / 4.0)).outputs
    assert np.array_equal(slow[:4], np.repeat(slow[:1], 4, axis=0))
    assert np.array_equal(slow[::4], program.run(u[::4]).outputs)
    p[indices["regulator.gain"]] *= 0.5
    changed = controller_program(circuit.with_values({"regulator.gain": "4.605 1/bar"})).run(u).outputs
    assert np.allclose(program.run(u, p).outputs, changed, rtol=1e-15)


def test_parts_without_a_program_are_refused():
    control, joint = load(EXAMPLES / "pressure_control.toml"), load(EXAMPLES / "muscle_joint.toml")
    with refused("deploy.controller.none"):
        controller_program(load(EXAMPLES / "two_tanks.toml"))
    with refused("deploy.controller.several", known=["valve", "position", "inverse"]):
        controller_program(joint)
    with refused("names.unknown", "regulater"):
        controller_program(control, ["regulater"])
    with refused("deploy.controller.other", "tank", known=["regulator"]):
        controller_program(control, ["tank"])
    with refused("deploy.controller.unsampled", "inverse"):
        controller_program(joint, ["inverse"])


def test_an_undriven_input_has_its_default_value():
    """Its default is a value of its own; the note that nobody drives it shows that."""
    circuit = load(EXAMPLES / "muscle_joint.toml")
    inverse_only = Circuit({"inverse": circuit.parts["inverse"]})
    defaults = {
        note.address: note.facts["value"] for note in inverse_only.static_notes if note.code == "circuit.uncontrolled"
    }
    assert defaults["inverse.contraction"] == 0.0


class Slow(Proportional):
    """Controller with a filter that has a continuous state."""

    def states(self) -> tuple[State, ...]:
        return (State("filtered", "1", 1.0),)

    def start(self, scope: Scope) -> dict[str, Any]:
        return super().start(scope) | {"filtered": 0.0}

    def control(self, scope: Scope) -> ControlOutputs:
        rate = scope.inputs["measured"] - scope.states["filtered"]
        return ControlOutputs(super().control(scope).outputs, {"filtered": rate})


def test_a_controller_with_continuous_states_is_refused():
    with refused("deploy.controller.continuous", "slow.filtered"):
        controller_program(Circuit({"slow": Slow()}))
