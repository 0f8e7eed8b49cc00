"""Served circuits with FMUs: the values of a simulation, written inputs, and failures of an FMU."""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
import time

import numpy as np
import pytest

from coupled_circuits import controlled_tank, oscillator
from poppet import FMU, Circuit, Recording
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.cosim import master
from poppet.serve.clocked_periods import MachineClock
from poppet.serve.machine_process import ProcessMachine
from poppet.serve.points import PointRole, ServedCircuit
from poppet.serve.snapshot import MachineState
from small_fmus import write_integrator

PATIENCE = 60.0


@pytest.fixture(scope="module")
def fmu(tmp_path_factory):
    return write_integrator(tmp_path_factory.mktemp("fmu"))


@pytest.mark.parametrize("kind", ["oscillator", "sampled", "controlled_tank"])
def test_a_served_circuit_has_the_values_of_a_simulation(fmu, kind):
    """Two communication steps in each period; signals and sample instants of the tank are between them."""
    if kind != "controlled_tank":
        circuit = oscillator(fmu, 0.005, coupling="sampled" if kind == "sampled" else "continuous")
        names = ["x.y", "v.y", "x.u"]
    else:
        circuit = controlled_tank(fmu).with_values({"meter.step": 0.005})
        names = ["tank.pressure", "tank.temperature", "regulator.fill_command", "meter.y"]
    expected = circuit.simulate("0.4 s", "10 ms", allow_native=True)
    with circuit.serve("10 ms", clock=False, allow_native=True) as machine:
        assert machine.advance("0.4 s").state is MachineState.RUNNING
        recording = machine.recording()
    assert np.allclose(recording.time, expected.time, rtol=1e-15)
    for name in names:
        size = np.abs(expected[name]).max()
        assert np.abs(recording[name] - expected[name]).max() < 1e-9 * size, name


def test_a_written_input_acts_on_the_fmu(fmu):
    circuit = Circuit({"a": FMU(fmu, start={"initial[y]": 1.0, "rate": 3.0})})
    with circuit.serve("20 ms", clock=False, allow_native=True) as machine:
        assert [point.address for point in machine.points if point.role is PointRole.INPUT] == ["a.u"]
        with pytest.raises(InputError) as error:
            machine.write({"a.y": 1.0})
        assert (error.value.code, error.value.address) == ("serve.not_writable", "a.y")
        machine.advance("0.1 s")
        machine.write({"a.u": 2.0})
        machine.advance("0.1 s")
        # The value acts from the next period on, at 0.12 s: y' = 3 u.
        assert machine.recording()["a.y"] == pytest.approx([1.0] * 7 + [1.12, 1.24, 1.36, 1.48])


def test_an_fmu_that_cannot_repeat_a_step_is_served(tmp_path):
    circuit = oscillator(write_integrator(tmp_path, rolls=False), 0.01)
    expected = circuit.simulate("0.2 s", "10 ms", allow_native=True)
    with circuit.serve("10 ms", clock=False, allow_native=True) as machine:
        machine.advance("0.2 s")
        assert np.abs(machine.recording()["x.y"] - expected["x.y"]).max() < 1e-9


def test_values_that_do_not_agree_are_noted_at_the_end(fmu, monkeypatch):
    monkeypatch.setattr(master, "MAX_PASSES", 2)
    with oscillator(fmu, 0.01).serve("10 ms", clock=False, allow_native=True) as machine:
        machine.advance("0.1 s")
        assert machine.take_notes() == []
        machine.stop()
    (note,) = machine.take_notes()
    assert (note.code, note.facts["count"], note.facts["steps"]) == ("fmu.not_converged", 10, 10)


def test_native_code_needs_permission(fmu):
    with pytest.raises(InputError) as error:
        oscillator(fmu, 0.01).serve(clock=False)
    assert (error.value.code, error.value.address) == ("fmu.native", "parts.x")


@pytest.mark.parametrize("step", [0.02, 0.004])
def test_a_period_must_consist_of_communication_steps(fmu, step):
    with pytest.raises(InputError) as error:
        oscillator(fmu, step).serve("10 ms", clock=False, allow_native=True)
    assert (error.value.code, error.value.address) == ("serve.communication_step", "period")
    assert error.value.facts["step"] == step


@pytest.mark.parametrize(
    ("fault", "code"),
    [(1, "fmu.crashed"), (3, "fmu.too_long"), (5, "fmu.not_finite"), (6, "fmu.ended")],
    ids=["segmentation fault", "endless loop", "not finite", "end of the simulation"],
)
def test_an_fmu_that_fails_ends_the_machine(fmu, fault, code):
    values = {"x.start.fault": fault, "x.start.fault_time": 0.2, "x.time_limit": 0.5}
    with oscillator(fmu, 0.01).with_values(values).serve("10 ms", clock=False, allow_native=True) as machine:
        snapshot = machine.advance("1 s")
        assert (snapshot.state, snapshot.note.code, snapshot.note.address) == (MachineState.FAILED, code, "x")
        recording = machine.recording()
    # The values up to the last whole period are kept.
    assert recording.time[-1] == pytest.approx(0.2)
    assert np.abs(recording["x.y"] - np.cos(2.0 * math.pi * recording.time)).max() < 1e-6


def test_an_fmu_that_cannot_be_loaded_raises_an_error(fmu):
    with pytest.raises(SimulationError) as error:
        Circuit({"rejected": FMU(fmu)}).serve(allow_native=True)
    assert (error.value.note.code, error.value.note.address) == ("fmu.not_loaded", "rejected")


def test_a_circuit_that_fails_beside_an_fmu(fmu):
    with controlled_tank(fmu).with_values({"meter.step": 0.01}).serve(clock=False, allow_native=True) as machine:
        machine.advance("50 ms")
        machine._plant._call.limits[1] = 0.0  # the maximum number of attempts
        snapshot = machine.advance("1 s")
        assert (snapshot.state, snapshot.note.code) == (MachineState.FAILED, "run.ended.too_many")
        assert snapshot.time == pytest.approx(0.05)


@pytest.mark.skipif(os.name != "posix", reason="states of processes are those of ps")
def test_the_processes_of_the_fmus_end_with_the_machine(fmu):
    served = ServedCircuit.of(oscillator(fmu, 0.01), allow_native=True)
    machine = ProcessMachine(served, MachineClock(0.01, math.inf))
    try:
        identifier = str(machine._process.pid)
        command = ["ps", "-o", "pid=", "--ppid", identifier]
        children = subprocess.run(command, capture_output=True, text=True, check=False).stdout.split()
    finally:
        machine.stop()
    assert len(children) >= 2
    end = time.monotonic() + PATIENCE
    while subprocess.run(["ps", "-o", "pid=", "-p", ",".join(children)], capture_output=True, check=False).stdout:
        assert time.monotonic() < end
        time.sleep(0.05)


def test_a_crash_keeps_the_program_and_its_recording(tmp_path):
    fmu = write_integrator(tmp_path, rolls=False)
    file, table = tmp_path / "a.toml", tmp_path / "run.csv"
    start = "{ fault = 1, fault_time = 0.2, u = 2.0 }"
    file.write_text(f'[parts.a]\nkind = "fmu"\npath = "{fmu}"\nstart = {start}\n', encoding="utf-8")
    command = [sys.executable, "-m", "poppet", "serve", str(file), "--lines", "0.05", "--record", str(table)]
    refused = subprocess.run(command, input="", capture_output=True, text=True, check=False)
    assert refused.returncode == 2
    assert "fmu.native" in refused.stderr
    process = subprocess.Popen(
        [*command, "--allow-native"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    while json.loads(process.stdout.readline())["state"] != "failed":
        pass
    # The program still answers.
    out, err = process.communicate('{"get": ["a.y"]}\n{"stop": true}\n', timeout=PATIENCE)
    reply = next(reply for reply in map(json.loads, out.splitlines()) if reply.get("ok"))
    assert (reply["state"], reply["code"]) == ("failed", "serve.failed")
    assert reply["values"]["a.y"] == pytest.approx(0.4)
    assert process.returncode == 1
    assert str(Note("fmu.one_pass", "a", step=0.01)) in err
    assert "SIGSEGV" in err
    recording = Recording.read(table)
    assert recording.time == pytest.approx(0.01 * np.arange(21))
    assert recording["a.y"] == pytest.approx(2.0 * recording.time)
