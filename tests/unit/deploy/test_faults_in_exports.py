"""Exports of circuits with a valve that has a fault: its start, its input, and rejected sliders."""

from __future__ import annotations

import subprocess
from pathlib import Path

import numpy as np
import pytest

from c_compiler import compile_c
from javascript import needs_node
from poppet import Circuit, load
from poppet.deploy.c.project import c_project
from poppet.deploy.export_model import build_export_model
from poppet.deploy.live.page_inputs import select_sliders
from poppet.deploy.live.page_kernel import run_in_node
from poppet.deploy.ssp import divide_circuit
from poppet.engine.call import Call
from poppet.signals import Steps
from refusals import refused
from unit.deploy.fmus import Host, build

EXAMPLES = Path(__file__).parents[3] / "examples"
START = 0.2


def faulty(fault: str = "stuck_open", **values) -> Circuit:
    """A 3/2 valve that fills a tank from 0.1 s on, and has a fault from 0.2 s on."""
    changes = {"valve.fault": fault, "valve.fault_start": START, "run.duration": 0.4, "run.output_step": 0.01}
    circuit = load(EXAMPLES / "datasheet_valve.toml").with_values(changes | values)
    return circuit.with_signals({"valve.command": Steps([0.0, 0.1, 0.15], [0.0, 1.0, 0.0])})


def test_c_has_the_fault_at_its_start(tmp_path):
    program = compile_c(c_project(faulty(), "faulty"), tmp_path, "-std=c99", "-O1")
    result = subprocess.run([program, "1e-4"], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout


@pytest.mark.parametrize("fmi", [2, 3])
def test_an_fmu_follows_the_start_or_the_importer(fmi, tmp_path):
    circuit = faulty("stuck_closed", **{"valve.fault_start": 0.13})
    path = build(circuit, fmi, tmp_path / "faulty.fmu")
    points = [0.0, 0.05, 0.12, 0.14, 0.4]
    run = circuit.simulate()
    expected = np.interp(points[1:], run.time, run["valve.position"])
    with Host(path) as host:
        values = host.begin().run(points, "valve.position")
    assert np.ravel(values) == pytest.approx(expected, abs=1e-3)
    assert expected[1] == pytest.approx(1.0, abs=1e-3)
    # Without the signals of the circuit, the importer sets both inputs.
    with Host(path, follows=False) as host:
        host.begin(valve__command=1.0, valve__fault=0.0)
        (opened,) = host.run([0.0, 0.1], "valve.position")
        host.set("valve__fault", 1.0)
        (closed,) = host.run([0.1, 0.2], "valve.position")
    assert (opened[0], closed[0]) == pytest.approx((1.0, 0.0), abs=1e-3)


@needs_node
def test_the_kernel_of_a_live_page_has_the_fault_at_its_start(tmp_path):
    reference = Call(faulty().problem(faulty().run))
    reference.repeat()
    _, table = run_in_node(reference.problem, tmp_path)
    assert np.abs(table - reference.table).max() <= 1e-9 * np.abs(reference.table).max()


def sliders(circuit: Circuit, *texts: str) -> dict:
    return {slider.address: slider for slider in select_sliders(build_export_model(circuit), circuit, texts)[0]}


def test_slider_of_a_fault_shows_its_values_over_time():
    slider = sliders(faulty(), "valve.fault")["valve.fault"]
    assert slider.course == {"kind": "steps", "times": [0.0, START], "values": [0.0, 1.0]}
    assert slider.delay == 0.0


def test_start_of_a_fault_cannot_have_a_slider():
    with refused("deploy.live.onset", "valve.fault_start", input="valve.fault"):
        sliders(faulty(), "valve.fault_start")
    assert "valve.fault_start" not in sliders(faulty())


def test_plant_of_a_system_has_the_fault():
    machine = load(EXAMPLES / "two_cylinders.toml").with_values({"valveA.fault": "stuck", "valveA.fault_start": 1.0})
    (plant,) = (component for component in divide_circuit(machine).components if component.name == "plant")
    assert "valveA.fault" not in plant.inputs
    assert plant.circuit.instance.signals["valveA.fault"].delayed(1.0).evaluate([0.9, 1.0]).tolist() == [0.0, 1.0]
