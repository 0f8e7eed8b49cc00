"""Tests of FMUs of controllers: with the inputs of the closed circuit, they give its commands."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet import Circuit, Recording, load
from poppet.cli.main import run as run_command
from poppet.deploy.fmu import binaries
from poppet.deploy.targets import TARGETS
from refusals import refused
from unit.deploy.fmus import COMPILER, EXAMPLES, FOLDER, Host

pytest.importorskip("fmpy", reason="FMPy is not installed")
NO_LAG: dict[str, dict[str, float]] = {
    "pressure_control": {"regulator.sensor.lag": 0.0},
    "muscle_joint": {"position.sensor.lag": 0.0},
}


@cache
def circuit_of(name: str, duration: float) -> Circuit:
    return load(EXAMPLES / f"{name}.toml").with_values({"run.duration": duration, **NO_LAG.get(name, {})})


@cache
def part_of(name: str, part: str, fmi: int, duration: float) -> Path:
    """The FMU of controllers of an example."""
    if COMPILER is None:
        pytest.skip("no C compiler here")
    path = FOLDER / f"{name}-{part}{fmi}.fmu"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(binaries, "has_zig", lambda: False)
        TARGETS["fmu"].write(circuit_of(name, duration), path, part=part, fmi=str(fmi))
    return path


@cache
def recorded(name: str, duration: float, step: float) -> Recording:
    """The closed circuit, with rows at the sample instants and half way between them."""
    return circuit_of(name, duration).with_values({"run.output_step": 0.5 * step}).simulate()


def commands(host: Host, run: Recording, step: float, inputs: dict[str, str], outputs: list[str]) -> np.ndarray:
    """Outputs half a sample time after each sample instant.

    The inputs are set at the instants, and in co-simulation also half way between them.
    """
    rows = []
    for k in range((len(run.time) - 1) // 2):
        time = k * step
        if host.kind == "ModelExchange" and k:
            host.fmu.setTime(time)
            host.fmu.enterEventMode()
        for name, source in inputs.items():
            host.set(name, run[source][2 * k])
        if host.kind == "ModelExchange":
            (host.fmu.newDiscreteStates if host.is_2 else host.fmu.updateDiscreteStates)()
            host.fmu.enterContinuousTimeMode()
            rows.append(host.get(*outputs))
        else:
            host.step(time, 0.5 * step)
            for name, source in inputs.items():
                host.set(name, run[source][2 * k + 1])
            rows.append(host.get(*outputs))
            host.step(time + 0.5 * step, 0.5 * step)
    return np.array(rows)


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_commands_of_a_controller_are_those_of_the_closed_circuit(fmi: int, kind: str) -> None:
    run, step = recorded("pressure_control", 0.7, 2e-3), 2e-3
    outputs = ["regulator.command", "regulator.fill_command", "regulator.vent_command", "regulator.integral"]
    inputs = {"regulator.measurement": "tank.pressure", "regulator.setpoint": "regulator.setpoint"}
    with Host(part_of("pressure_control", "regulator", fmi, 0.7), kind, follows=False).begin() as host:
        values = commands(host, run, step, inputs, outputs)
    expected = np.array([run[name][1::2] for name in outputs]).T
    assert np.ptp(expected[:, 0]) > 0.5
    np.testing.assert_allclose(values, expected, rtol=0.0, atol=1e-9)


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_steps_of_a_sequence_are_those_of_the_closed_circuit(fmi: int, kind: str) -> None:
    run, step = recorded("two_cylinders", 1.5, 5e-3), 5e-3
    outputs = ["plc.a", "plc.b", "plc.step", "plc.cycles"]
    with Host(part_of("two_cylinders", "plc", fmi, 1.5), kind, follows=False).begin() as host:
        inputs = {v.name: v.name for v in host.description.modelVariables if v.causality == "input"}
        values = commands(host, run, step, inputs, outputs)
    expected = np.array([run[name][1::2] for name in outputs]).T
    assert len(np.unique(expected[:, 2])) >= 4
    assert np.array_equal(values, expected)


def test_dead_zone_and_acceleration_feedback_are_those_of_the_closed_circuit() -> None:
    run, step = recorded("position_dead_zone", 0.7, 1e-3), 1e-3
    outputs = [f"position.{name}" for name in ("command", "uncompensated_command", "acceleration_feedback")]
    inputs = {f"position.{name}": f"position.{name}" for name in ("measurement", "setpoint")}
    with Host(part_of("position_dead_zone", "position", 2, 0.7), follows=False).begin() as host:
        values = commands(host, run, step, inputs, outputs)
    expected = np.array([run[name][1::2] for name in outputs]).T
    assert np.all(np.ptp(expected, axis=0) > 0.1)
    np.testing.assert_allclose(values, expected, rtol=0.0, atol=1e-9)


def test_connected_controllers_are_one_fmu() -> None:
    """The loop of the position in `muscle_joint`, and the law of the muscle that follows it."""
    run, step = recorded("muscle_joint", 1.2, 2e-3), 2e-3
    outputs = ["position.command", "position.integral", "inverse.pressure"]
    inputs = {
        "position.measurement": "arm.position", "position.setpoint": "position.setpoint",
        "inverse.contraction": "muscle.contraction",
    }  # fmt: skip
    with Host(part_of("muscle_joint", "position,inverse", 2, 1.2), follows=False).begin() as host:
        assert "inverse.force" not in {v.name for v in host.description.modelVariables if v.causality == "input"}
        values = commands(host, run, step, inputs, outputs)
    expected = np.array([run[name][1::2] for name in outputs]).T
    size = np.max(np.abs(expected), axis=0)
    assert np.all(np.ptp(expected, axis=0) > 0.01 * size)
    assert np.max(np.abs(values - expected) / size) < 1e-9


def test_of_a_valve_the_electronics_are_exported() -> None:
    with Host(part_of("muscle_joint", "valve", 2, 1.2), follows=False).begin() as host:
        kinds = {v.name: v.causality for v in host.description.modelVariables}
        inputs = {name for name, causality in kinds.items() if causality == "input"}
        assert inputs == {
            f"valve.{n}" for n in ("setpoint", "power", "outlet_pressure", "pilot_pressure", "input_fault")
        }
        assert kinds["valve.fill_duty"] == "output"
        host.set("valve.setpoint", 5e5)
        host.set("valve.outlet_pressure", 1e5)
        host.set("valve.pilot_pressure", 1e5)
        for k in range(20):
            host.step(k * 1e-3, 1e-3)
        assert host.get("valve.fill_duty") == [1.0]


def test_signals_and_names_of_the_fmu_of_a_controller(tmp_path: Path) -> None:
    """All inputs are inputs of the FMU, which can follow the signals of the circuit."""
    path = part_of("pressure_control", "regulator", 2, 0.7)
    with Host(path).begin() as host:
        kinds = {v.name: v.causality for v in host.description.modelVariables}
        inputs = {name for name, causality in kinds.items() if causality == "input"}
        local = {"setpoint", "measurement", "input_fault", "automatic", "manual_command"}
        assert inputs == {f"regulator.{name}" for name in local}
        assert {"regulator.command", "regulator.fill_command", "regulator.vent_command"} <= {
            name for name, causality in kinds.items() if causality == "output"
        }
        host.step(0.0, 0.6)
        assert host.get("regulator.setpoint") == [4e5]
        assert host.description.modelName == "regulator"


def test_the_option_part_of_the_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(binaries, "has_zig", lambda: False)
    file, path = str(EXAMPLES / "pressure_control.toml"), tmp_path / "regulator.fmu"
    assert run_command(["export", "fmu", file, "--part", "controller", "-o", str(path)]) == 0
    assert path.exists()
    circuit: Any = circuit_of("pressure_control", 0.7)
    with refused("names.unknown", "regulatr"):
        TARGETS["fmu"].make(circuit, part="regulatr")
    with refused("deploy.controller.other", "tank"):
        TARGETS["fmu"].make(circuit, part="tank")
