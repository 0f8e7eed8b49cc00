"""Co-simulation of FMUs with each other and with circuits, against closed forms and undivided circuits."""

from __future__ import annotations

import math
import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from coupled_circuits import OMEGA, controlled_tank, oscillator
from poppet import FMU, Circuit, Run
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.cosim import master
from small_fmus import write_integrator


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("fmus")


def rotated(angle: float, count: int) -> np.ndarray:
    """The oscillator by a method that turns (x, v) by an angle in each step."""
    return np.cos(angle * np.arange(count + 1))


def iterated(step: float, count: int) -> np.ndarray:
    """Parabolas through both ends and the middle: the Lobatto IIIA method of order 4."""
    z = OMEGA * step
    return rotated(2.0 * math.atan2(z / 2.0, 1.0 - z * z / 12.0), count)


def iterated_constant(step: float, count: int) -> np.ndarray:
    """Means of both ends: the trapezoidal rule."""
    return rotated(2.0 * math.atan(OMEGA * step / 2.0), count)


def extrapolated(step: float, count: int) -> np.ndarray:
    """One pass: each step integrates the parabola of the other side, extrapolated from its last step."""
    z, turned = OMEGA * step, np.array([1.0, -1.0])
    first = middle = last = np.array([1.0, 0.0])  # x and v
    result = [1.0]
    for k in range(count):
        ahead = (last, last) if k == 0 else (3 * last - 3 * middle + first, 6 * last - 8 * middle + 3 * first)
        f, m, e = last[::-1] * turned, ahead[0][::-1] * turned, ahead[1][::-1] * turned
        first, middle, last = last, last + z / 24.0 * (5 * f + 8 * m - e), last + z / 6.0 * (f + 4 * m + e)
        result.append(last[0])
    return np.array(result)


def held(step: float, count: int) -> np.ndarray:
    """One pass with constant inputs: the explicit Euler method."""
    return ((1.0 + 1j * OMEGA * step) ** np.arange(count + 1)).real


METHODS = {
    "iteration and interpolation": ({}, iterated),
    "iteration only": ({"interpolates": False}, iterated_constant),
    "interpolation only": ({"rolls": False}, extrapolated),
}


@pytest.mark.parametrize("method", METHODS)
def test_two_coupled_fmus_are_the_known_method(folder, method):
    flags, closed_form = METHODS[method]
    step, count = 0.0025, 60
    circuit = oscillator(write_integrator(folder, f"{'-'.join(flags) or 'plain'}.fmu", **flags), step)
    recording = circuit.simulate(step * count, step, allow_native=True)
    assert np.abs(recording["x.y"] - closed_form(step, count)).max() < 1e-10


def test_the_page_states_the_errors_of_these_methods():
    page = (Path(__file__).parents[3] / "docs" / "fmu_import.md").read_text(encoding="utf-8")
    table = page.partition("form an oscillator")[2].partition("For the two tanks")[0]
    header, _, *rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines() if "|" in line]
    forms = {name: closed_form for name, (_, closed_form) in METHODS.items()} | {"libcosim": held}
    assert len(rows) == 3
    for row in rows:
        step = 1e-3 * float(row[0])
        count = round(10.0 / step)
        exact = np.cos(OMEGA * step * np.arange(count + 1))
        for name, closed_form in forms.items():
            error = np.abs(closed_form(step, count) - exact).max()
            assert float(row[header.index(name)]) == pytest.approx(error, rel=0.05), (row, name)


def test_one_pass_is_noted(folder):
    path = write_integrator(folder, "rigid.fmu", rolls=False)
    recording = oscillator(path, 0.05).simulate(allow_native=True)
    assert [(n.code, n.address) for n in recording.remarks] == [("fmu.one_pass", "x"), ("fmu.one_pass", "v")]
    assert recording.statistics["communication_passes"] == recording.statistics["communication_steps"] == 20


@pytest.mark.parametrize(
    ("fault", "code"),
    [
        (1, "fmu.crashed"), (2, "fmu.crashed"), (3, "fmu.too_long"), (4, "fmu.failed"), (5, "fmu.not_finite"),
    ],
    ids=["segmentation fault", "exit", "endless loop", "status", "not finite"],
)  # fmt: skip
def test_a_failing_fmu_keeps_the_results(folder, fault, code):
    circuit = oscillator(write_integrator(folder), 0.01, time_limit=1.0).with_values({"x.start.fault": fault})
    with pytest.raises(SimulationError) as error:
        circuit.simulate(allow_native=True)
    assert (error.value.note.code, error.value.note.address) == (code, "x")
    recording = error.value.recording
    assert recording.time.tolist() == pytest.approx([0.0, 0.1, 0.2, 0.3, 0.4])
    assert np.abs(recording["x.y"] - np.cos(OMEGA * recording.time)).max() < 1e-6
    if fault < 3:
        assert error.value.note.facts["why"] == {1: "SIGSEGV", 2: "exit code 7"}[fault]
    if fault == 1:
        assert error.value.note.facts["log"] == "about to crash"
    assert recording.outcome == str(error.value.note)


@pytest.mark.skipif(os.name != "posix", reason="process groups are part of POSIX")
def test_programs_that_an_fmu_has_started_end_with_it(folder):
    circuit = oscillator(write_integrator(folder), 0.1).with_values({"x.start.fault": 8})
    with pytest.raises(SimulationError) as error:
        circuit.simulate(allow_native=True)
    process = error.value.note.facts["log"]
    state = subprocess.run(["ps", "-o", "stat=", "-p", process], capture_output=True, text=True, check=False).stdout
    assert not state or state.startswith("Z"), state


@pytest.mark.skipif(os.name != "posix", reason="another system has no parent of a process without one")
def test_a_process_in_an_endless_call_ends_with_its_parent():
    code = (
        "import subprocess, sys\n"
        "command = [sys.executable, '-c', 'import os, threading, time\\n'\n"
        "'from poppet.cosim.child import end_with_parent\\n'\n"
        "'threading.Thread(target=end_with_parent, args=(os.getppid(),)).start()\\n'\n"
        "'print(1, flush=True)\\ntime.sleep(3600)']\n"
        "child = subprocess.Popen(command, stdout=subprocess.PIPE)\n"
        "child.stdout.readline()\n"
        "print(child.pid, flush=True)\n"
    )
    # The standard error of the process stays open until it has ended.
    subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, timeout=60)


@pytest.mark.skipif(os.name != "posix", reason="the system has no signal that ends a process without its clean-up")
@pytest.mark.parametrize("fault", [0, 3], ids=["waiting", "endless loop"])
def test_a_killed_program_leaves_no_folder(folder, fault):
    path = write_integrator(folder)
    code = (
        "import sys, threading, time\n"
        "import numpy as np\n"
        "from poppet.cosim.description import read_fmu\n"
        "from poppet.cosim.fmu_slave import FmuSetup, FmuSlave\n"
        f"setup = FmuSetup('x', read_fmu({str(path)!r}), {{'fault': {fault}, 'fault_time': 0.0}})\n"
        "with FmuSlave(setup) as slave:\n"
        "    slave.initialise(np.zeros(1), is_last=True)\n"
        "    slave.begin_step(0.0, 1.0, np.zeros((3, 1)), is_saved=False, is_repeated=False)\n"
        "    print(slave._folder.name, flush=True)\n"
        "    time.sleep(3600)\n"
    )
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as program:
        unpacked = Path(program.stdout.readline().strip())
        assert (unpacked / "modelDescription.xml").exists()
        program.kill()
    end = time.monotonic() + 60.0
    while unpacked.exists():
        assert time.monotonic() < end
        time.sleep(0.05)


def test_an_fmu_that_cannot_be_loaded(folder):
    circuit = Circuit({"rejected": FMU(write_integrator(folder))}, run=Run(duration=1.0))
    with pytest.raises(SimulationError) as error:
        circuit.simulate(allow_native=True)
    assert (error.value.note.code, error.value.note.address) == ("fmu.not_loaded", "rejected")
    assert error.value.recording.time.size == 0


def test_values_that_do_not_agree_are_noted(folder, monkeypatch):
    monkeypatch.setattr(master, "MAX_PASSES", 2)
    recording = oscillator(write_integrator(folder), 0.05).simulate(allow_native=True)
    (note,) = recording.remarks
    assert (note.code, note.facts["count"], note.facts["steps"]) == ("fmu.not_converged", 20, 20)
    assert note.address in ("x.y", "v.y")


def test_an_fmu_can_end_the_simulation(folder):
    circuit = oscillator(write_integrator(folder), 0.04).with_values({"x.start.fault": 6, "x.start.fault_time": 0.55})
    recording = circuit.simulate(allow_native=True)
    assert recording.remarks == ()
    assert "0.55 s" in str(recording.outcome)
    assert recording.time[-1] == pytest.approx(0.5)


def test_an_fmu_can_write_to_the_standard_output(folder):
    recording = oscillator(write_integrator(folder), 0.05).with_values({"x.start.fault": 7}).simulate(allow_native=True)
    assert recording.time[-1] == 1.0


def test_native_code_needs_permission(folder):
    with pytest.raises(InputError) as error:
        oscillator(write_integrator(folder), 0.05).simulate()
    assert (error.value.code, error.value.address) == ("fmu.native", "parts.x")


def test_equal_steps_if_the_fmu_requires_them(folder):
    path = write_integrator(folder, "constant.fmu", variable=False)
    with pytest.raises(InputError) as error:
        oscillator(path, 0.3).simulate(allow_native=True)
    assert (error.value.code, error.value.address) == ("fmu.constant_step", "run.duration")
    assert oscillator(path, 0.25).simulate(allow_native=True).time[-1] == 1.0


def test_a_loop_of_direct_dependences_is_solved(folder):
    """z = gain u in both FMUs: a = 0.5 b + s, where the sum is that of a controller without dynamics."""
    path = write_integrator(folder)
    parts = {"a": FMU(path, step=0.1, start={"gain": 0.5, "u": 2.0}), "b": FMU(path, step=0.1, start={"gain": -0.5})}
    circuit = Circuit(parts, connections={"a.u": "b.z", "b.u": "a.z"}, run=Run(duration=0.3, output_step=0.1))
    recording = circuit.simulate(allow_native=True)
    assert np.abs(recording["a.z"]).max() < 1e-8
    (note,) = recording.remarks
    assert note.code == "fmu.loop"
    assert set(note.facts["names"]) == {"a.u", "a.z", "b.u", "b.z"}


def test_a_circuit_is_the_same_beside_an_fmu(folder):
    """Signals, sample instants and balances do not depend on communication points."""
    alone, beside = controlled_tank(None).simulate(), controlled_tank(write_integrator(folder)).simulate(
        allow_native=True
    )  # fmt: skip
    assert np.array_equal(alone.time, beside.time)
    for name in ("tank.pressure", "tank.temperature", "tank.mass"):
        assert np.abs(beside[name] / alone[name] - 1.0).max() < 1e-6, name
    assert len(beside.residuals) == len(alone.residuals)
    assert all(residual.is_kept for residual in beside.residuals)
    # The FMU has integrated the pressure: against the trapezoidal rule of the rows.
    exact = np.concatenate([[0.0], np.cumsum(0.005 * (alone["tank.pressure"][1:] + alone["tank.pressure"][:-1]))])
    assert np.abs(beside["meter.y"] - exact).max() < 1e-3 * exact[-1]


def test_stop_conditions_end_the_run(folder):
    recording = controlled_tank(write_integrator(folder)).simulate(
        allow_native=True, stop_when="tank.pressure > 1.3 bar"
    )  # fmt: skip
    assert recording["tank.pressure"][-1] == pytest.approx(1.3e5, rel=1e-6)
    assert recording.time[-1] < 0.3


@pytest.mark.parametrize(
    "analysis",
    [
        lambda c: c.steady_state(),
        lambda c: c.linearise(),
        lambda c: c.stepper(),
        lambda c: c.to_ode(),
        lambda c: c.to_casadi(),
        lambda c: c.to_control(),
        lambda c: c.fit({}, ["tank.volume"]),
        lambda c: c.ensemble(
            runs=2, parameters={"tank.volume": {"distribution": "uniform", "relative_range": 0.1}},
            metrics={"end": {"of": "tank.pressure", "metric": "final"}},
        ),
    ],
    ids=["steady_state", "linearise", "stepper", "to_ode", "to_casadi", "to_control", "fit", "ensemble"],
)  # fmt: skip
def test_analyses_that_need_the_equations(folder, analysis):
    with pytest.raises(InputError) as error:
        analysis(controlled_tank(write_integrator(folder)))
    assert (error.value.code, error.value.address) == ("fmu.unavailable", "parts.meter")


def test_other_solvers_are_not_available(folder):
    with pytest.raises(InputError) as error:
        controlled_tank(write_integrator(folder)).simulate(solver="cvodes", allow_native=True)
    assert (error.value.code, error.value.address) == ("fmu.solver", "run.solver")


def test_progress_and_interruption(folder):
    times = []

    def report(time: float) -> None:
        times.append(time)
        if time > 0.2:
            raise KeyboardInterrupt

    circuit = controlled_tank(write_integrator(folder))
    recording = circuit.simulate(allow_native=True, progress=report, throw=False)
    assert times == sorted(times)
    assert recording.time[-1] == pytest.approx(0.2)
    attempts = sum(recording.statistics[key] for key in ("accepted_steps", "rejected_steps"))
    assert recording.outcome == str(Note("run.ended.interrupted", time=recording.time[-1], attempts=attempts))
