"""Tests of systems of FMUs: the schema of SSP, and runs in FMPy beside the simulation of the closed circuit."""

from __future__ import annotations

import contextlib
import zipfile
from collections.abc import Iterator
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet import Circuit, load
from poppet.cli.main import run as run_command
from poppet.deploy.fmu import binaries
from poppet.deploy.ssp import divide_circuit
from poppet.deploy.targets import TARGETS
from unit.deploy.fmus import COMPILER, EXAMPLES, FOLDER, Host

pytest.importorskip("fmpy", reason="FMPy is not installed")


@cache
def circuit_of(name: str, duration: float) -> Circuit:
    return load(EXAMPLES / f"{name}.toml").with_values({"run.duration": duration})


@cache
def system_of(name: str, duration: float, fmi: int = 2) -> Path:
    """The system of an example."""
    if COMPILER is None:
        pytest.skip("no C compiler here")
    path = FOLDER / f"{name}{fmi}{duration}.ssp"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(binaries, "has_zig", lambda: False)
        TARGETS["ssp"].write(circuit_of(name, duration), path, fmi=str(fmi))
    return path


def read(path: Path) -> Any:
    """The structure of a system, which FMPy checks against the schema of SSP 1.0."""
    from fmpy.ssp.ssd import read_ssd

    return read_ssd(str(path), validate=True)


@contextlib.contextmanager
def opened(path: Path, folder: Path) -> Iterator[dict[str, Host]]:
    """The FMUs of a system, with their names and start values."""
    with contextlib.ExitStack() as stack, zipfile.ZipFile(path) as archive:
        archive.extractall(folder)
        yield {
            component.name: stack.enter_context(Host(folder / component.source, follows=False)).begin()
            for component in read(path).system.elements
        }


def closed_loop(path: Path, folder: Path, points: list[float], *outputs: tuple[str, str]) -> np.ndarray:
    """Outputs at each point after the first, by a master that passes values from the outputs to the inputs in order.

    At each point, the plant comes first: its measured quantities do not depend on its inputs.
    """
    system = read(path).system
    order = sorted(system.connections, key=lambda connection: connection.endElement == "plant")
    rows = []
    with opened(path, folder) as hosts:
        for begin, end in pairwise(points):
            for c in order:
                hosts[c.endElement].set(c.endConnector, hosts[c.startElement].get(c.startConnector)[0])
            for host in hosts.values():
                host.step(begin, end - begin)
            rows.append([hosts[component].get(name)[0] for component, name in outputs])
    return np.array(rows)


@pytest.mark.parametrize(
    ("name", "fmi"), [("pressure_control", 2), ("pressure_control", 3), ("cylinder_position", 2), ("two_tanks", 2)]
)
def test_the_structure_is_valid_and_names_variables_of_its_fmus(name: str, fmi: int, tmp_path: Path) -> None:
    import fmpy

    path = system_of(name, 1.0, fmi)
    structure = read(path)
    circuit = circuit_of(name, 1.0)
    assert len(structure.system.connections) == len(divide_circuit(circuit).connections)
    with zipfile.ZipFile(path) as archive:
        archive.extractall(tmp_path)
    variables = {}
    for component in structure.system.elements:
        description = fmpy.read_model_description(str(tmp_path / component.source))
        assert description.fmiVersion[0] == str(fmi)
        variables[component.name] = {v.name: v for v in description.modelVariables}
        connectors = {c.name: c.kind for c in component.connectors}
        assert connectors
        assert all(variables[component.name][k].causality == kind for k, kind in connectors.items())
    units = {unit.name for unit in structure.units}
    for c in structure.system.connections:
        start, end = variables[c.startElement][c.startConnector], variables[c.endElement][c.endConnector]
        assert (start.causality, end.causality, start.unit) == ("output", "input", end.unit)
        assert start.unit is None or start.unit in units
    # Each input of a component that is a connector is connected exactly once.
    ends = sorted((c.endElement, c.endConnector) for c in structure.system.connections)
    assert ends == sorted(
        (e.name, c.name) for e in structure.system.elements for c in e.connectors if c.kind == "input"
    )


def test_controllers_are_components_and_the_rest_is_the_plant() -> None:
    one, other = divide_circuit(circuit_of("pressure_control", 1.0)), divide_circuit(circuit_of("two_tanks", 1.0))
    assert [component.name for component in one.components] == ["regulator", "plant"]
    assert one.connections == {
        "regulator.measurement": "tank.pressure",
        "fill.opening": "regulator.fill_command",
        "vent.opening": "regulator.vent_command",
    }
    assert [component.name for component in other.components] == ["plant"]
    assert other.components[0].circuit is circuit_of("two_tanks", 1.0)


def test_a_sequence_is_a_component(tmp_path: Path) -> None:
    """With two communication steps in a sample time, its steps are those of the run."""
    count = 200
    circuit = circuit_of("two_cylinders", 1.0)
    assert [component.name for component in divide_circuit(circuit).components] == ["plc", "pressed", "plant"]
    half = float(circuit.parameters["plc.sample_time"]) / 2.0
    outputs = ("plant", "slideA.position"), ("plc", "plc.step")
    points = [k * half for k in range(2 * count + 1)]
    values = closed_loop(system_of("two_cylinders", 1.0), tmp_path, points, *outputs)
    run = circuit.with_values({"run.output_step": half}).simulate()
    assert np.max(np.abs(values[:, 0] - run["slideA.position"][1 : 2 * count + 1])) < 1e-6
    # Between two sample instants: at an instant, the importer can still change the inputs.
    assert np.array_equal(values[::2, 1], run["plc.step"][1 : 2 * count : 2])
    assert len(set(values[:, 1])) >= 4


@pytest.mark.parametrize(
    ("name", "controller", "output", "values", "limit"),
    [
        ("pressure_control", "regulator", "tank.pressure", {"regulator.sensor.lag": 0.0}, 1e-6),
        ("pressure_control", "regulator", "tank.pressure", {}, 1e-3),
        ("cylinder_position", "position", "slide.position", {}, 1e-6),
    ],
)
def test_a_master_that_resolves_the_loop_gives_the_simulation(
    name: str, controller: str, output: str, values: dict[str, float], limit: float, tmp_path: Path
) -> None:
    """With steps of one sample time; a lag of the sensor integrates a measurement that is constant during a step."""
    circuit = circuit_of(name, 1.0).with_values(values)
    step = float(circuit.parameters[f"{controller}.sample_time"])
    circuit = circuit.with_values({"run.output_step": step})
    path = tmp_path / "system.ssp"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(binaries, "has_zig", lambda: False)
        TARGETS["ssp"].write(circuit, path)
    points = [k * step for k in range(round(1.0 / step) + 1)]
    results = closed_loop(path, tmp_path, points, ("plant", output))[:, 0]
    expected = circuit.simulate()[output][1:]
    assert np.ptp(expected) > 0.1 * np.max(expected)
    difference = np.max(np.abs(results - expected)) / np.max(np.abs(expected))
    assert difference < limit


def test_fmpy_simulates_the_system() -> None:
    """FMPy passes values after each step, and its inputs are 0 in the first: the difference decreases with the step."""
    from fmpy.ssp.simulation import simulate_ssp

    circuit = circuit_of("pressure_control", 1.0).with_values({"run.output_step": "0.1 ms"})
    run, differences = circuit.simulate(), []
    for step in (2e-3, 2e-4):
        rows = simulate_ssp(str(system_of("pressure_control", 1.0)), stop_time=1.0 - 0.5 * step, step_size=step)
        expected = np.interp(rows["time"] + step, run.time, run["tank.pressure"])
        differences.append(np.max(np.abs(rows["plant.tank.pressure"] - expected)) / np.max(expected))
    assert differences[0] < 0.02
    assert differences[1] < differences[0] / 2.0


def test_a_stop_condition_is_omitted_with_a_note(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(binaries, "has_zig", lambda: False)
    circuit = circuit_of("pressure_control", 1.0).with_values({"run.stop_when": "regulator.command > 0.5"})
    export = TARGETS["ssp"].make(circuit)
    assert [(note.code, note.address) for note in export.notes] == [("deploy.ssp.no_stop", "run.stop_when")]
    whole = circuit_of("two_tanks", 10.0).with_values({"run.stop_when": "low.pressure > 2 bar"})
    assert TARGETS["ssp"].make(whole).notes == ()


def test_the_command_writes_a_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(binaries, "has_zig", lambda: False)
    path = tmp_path / "system.ssp"
    assert run_command(["export", "ssp", str(EXAMPLES / "pressure_control.toml"), "-o", str(path)]) == 0
    assert "0.002 s" in capsys.readouterr().out
    assert [component.name for component in read(path).system.elements] == ["regulator", "plant"]
