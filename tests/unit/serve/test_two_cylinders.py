"""Two cylinders, driven by a scripted Modbus client, compared with the closed simulation."""

from __future__ import annotations

import itertools
import re
import runpy
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("pymodbus", reason="the extra serve is not installed")
from pymodbus.client import ModbusTcpClient

import poppet
from modbus_stub import serving
from poppet.serve.modbus_map import map_of_circuit
from served_process import serve_process

FOLDER = Path(__file__).parents[3] / "examples" / "serve"
SCAN, PERIOD = 0.01, 0.002
SCRIPT: Any = runpy.run_path(str(FOLDER / "two_cylinders_client.py"))


@pytest.fixture
def machine() -> Iterator[Any]:
    with poppet.load(FOLDER / "two_cylinders_machine.toml").serve(PERIOD, clock=False) as running:
        running.advance(0.1)
        yield running


@pytest.fixture
def client(machine: Any) -> Iterator[ModbusTcpClient]:
    modbus_map = map_of_circuit(machine.served)
    with serving(machine, modbus_map) as server, ModbusTcpClient("127.0.0.1", port=server.port) as connected:
        yield connected


def steps_of(recording: Any) -> list[tuple[float, int]]:
    """Return time and number of each new step of the sequence."""
    steps = recording["plc.step"]
    return [(float(recording.time[k + 1]), int(steps[k + 1])) for k in np.flatnonzero(np.diff(steps))]


def closed_simulation(**values: Any) -> Any:
    circuit = poppet.load(FOLDER / "two_cylinders.toml").with_values(values)
    return circuit.simulate(duration=8.0, output_step=PERIOD)


@pytest.mark.parametrize(("machine_file", "closed_file"), [
    ("two_cylinders_machine.toml", "two_cylinders.toml"), ("pressure_machine.toml", "pressure_control.toml"),
])  # fmt: skip
def test_the_machine_is_the_closed_circuit_without_its_controller(machine_file: str, closed_file: str) -> None:
    plant, closed = poppet.load(FOLDER / machine_file), poppet.load(FOLDER / closed_file)
    (controller,) = set(closed.parts) - set(plant.parts)
    assert set(plant.parts) < set(closed.parts)
    for address, number in closed.numbers().items():
        if not address.startswith(f"{controller}.") and not address.endswith(".opening"):
            assert plant.numbers()[address].value == number.value, address
    written = {target for target, source in closed.connections.items() if source.startswith(f"{controller}.")}
    registers = plant.origin.tables["modbus"]["registers"]
    assert {address for address in registers if address in plant.inputs} == written


def test_the_client_drives_the_cycle_as_in_the_simulation(machine: Any, client: ModbusTcpClient) -> None:
    durations = SCRIPT["run_cycle"](client, machine.advance)
    steps = steps_of(closed_simulation())[:5]
    assert [number for _, number in steps] == [2, 3, 4, 5, 1]
    expected = [later - earlier for (earlier, _), (later, _) in itertools.pairwise(steps)]
    assert [*durations] == ["A+", "B+", "B-", "A-"]
    # The client reads every 10 ms, and a command acts one period later.
    assert np.abs(np.array([*durations.values()]) - expected).max() <= SCAN + PERIOD


def test_a_valve_that_sticks_while_it_runs_causes_the_timeout_of_the_simulation(
    machine: Any, client: ModbusTcpClient
) -> None:
    begin = 0.1 + 0.5  # during B+: the stamp stops on its way
    events: dict[str, float] = {}

    def wait(duration: float) -> None:
        if not events and machine.snapshot().time >= begin - PERIOD:
            assert not client.write_coil(SCRIPT["B_STUCK_CLOSED"], True).isError()
            events["fault"] = machine.snapshot().time + PERIOD
        machine.advance(duration)

    with pytest.raises(TimeoutError, match=r"step B\+") as caught:
        SCRIPT["run_cycle"](client, wait)
    timeout = machine.snapshot().time
    fault = {"valveB.fault": "stuck_closed", "valveB.fault_start": events["fault"]}
    recording = closed_simulation(**fault)
    (note,) = (note for note in recording.remarks if note.code == "sequence.timed_out")
    assert note.facts["name"] == "B+"
    assert abs(timeout - note.facts["time"]) <= 2 * (SCAN + PERIOD)
    assert str(caught.value).endswith("s")
    # Both cylinders are at the same places at the timeout.
    row = int(np.searchsorted(recording.time, note.facts["time"]))
    for name in ("slideA.position", "slideB.position"):
        assert machine.snapshot()[name] == pytest.approx(recording[name][row], abs=1e-5)
    # The repaired machine runs again.
    client.write_coil(SCRIPT["B_STUCK_CLOSED"], False)
    client.write_coils(0, [False, False])
    machine.advance(1.0)
    assert [*SCRIPT["run_cycle"](client, machine.advance)] == ["A+", "B+", "B-", "A-"]


def test_the_script_of_the_guide_runs_against_the_command() -> None:
    with serve_process(FOLDER / "two_cylinders_machine.toml", "--modbus", "127.0.0.1:0") as served:
        script = [sys.executable, FOLDER / "two_cylinders_client.py", str(served.modbus_port())]
        result = subprocess.run(script, capture_output=True, text=True, timeout=120.0)
        assert served.interrupt() == 0
    assert result.returncode == 0, result.stderr
    first, stuck, repaired = result.stdout.splitlines()
    steps = r"A\+ \d+\.\d\d s, B\+ \d+\.\d\d s, B- \d+\.\d\d s, A- \d+\.\d\d s"
    assert re.fullmatch(f"cycle: {steps}", first)
    assert re.fullmatch(r"valve B is stuck: step B\+ has not ended after 2\.\d\d s", stuck)
    assert re.fullmatch(f"repaired: {steps}", repaired)
    assert re.search(r"Modbus: 1 client, \d+ requests, 0 of them with an exception\.", served.output)
