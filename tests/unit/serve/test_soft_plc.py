"""Exported controllers in a soft PLC, which drives a served machine over Modbus, against the closed simulation.

The soft PLC is a process of its own with an unsynchronised scan. A change of a sensor waits for the next scan, for up
to one scan. The scan reads values of the last period, and its commands act at the next one: two periods more at most.
The machine runs at a quarter of real time, so that other work on the computer does not delay the scans; if a scan was
late nevertheless, the run is repeated more slowly.
"""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

pytest.importorskip("pymodbus", reason="the extra serve is not installed")

import poppet
from served_process import serve_process
from soft_plc_programs import PlcProgram, ScanLog, compile_c_program, compile_matiec_program, read_log

FOLDER = Path(__file__).parents[3] / "examples" / "serve"
SCAN, PERIOD = 0.01, 0.002
SPEEDS = (0.25, 0.1)
"""Speeds of the machine, of which the first without a late scan is sufficient."""
LATE_SCAN = 2.0 * SCAN
"""Time between two scans above which the second one is late: the loop then has another delay [s]."""
BEGIN = 0.5
"""Time of the machine at which the program begins to act: the soft PLC runs by then [s]."""
Compiler = Callable[[PlcProgram, Path], Path]
COMPILERS = pytest.mark.parametrize("compiler", [compile_matiec_program, compile_c_program], ids=["MATIEC", "C"])


class PlcRun(NamedTuple):
    """Recording of a machine that a soft PLC has driven, and the log of its scans."""

    time: Any
    series: Any
    log: ScanLog

    @property
    def longest_delay(self) -> float:
        """Longest time from a change of a sensor to the action of the command [s]."""
        return float(np.diff(self.log.machine_time).max()) + 2.0 * PERIOD


def drive(machine_file: str, program: Path, end: float, folder: Path) -> PlcRun:
    """Serve a machine with `poppet serve`, and let a soft PLC drive it, if possible without a late scan."""
    for speed in SPEEDS:
        run = drive_at(speed, machine_file, program, end, folder)
        if np.diff(run.log.machine_time).max() <= LATE_SCAN:
            break
    return run


def drive_at(speed: float, machine_file: str, program: Path, end: float, folder: Path) -> PlcRun:
    """Serve a machine at a speed, and let a soft PLC drive it."""
    record, log = folder / "run.csv", folder / "scans.csv"
    options = ["--period", f"{PERIOD} s", "--speed", str(speed), "--modbus", "127.0.0.1:0", "--record", record]
    with serve_process(FOLDER / machine_file, *options) as served:
        arguments = [str(served.modbus_port()), str(SCAN / speed), str(end), log]
        subprocess.run([program, *arguments], check=True, timeout=end / speed + 60.0)
        assert served.interrupt() == 0
    recording = poppet.Recording.read(record)
    return PlcRun(recording.time, recording, read_log(log))


def commands_of(time: Any, series: Any) -> list[tuple[float, str, float]]:
    """Return time, valve and value of each change of a command."""
    changes = []
    for valve in ("valveA.command", "valveB.command"):
        values = series[valve]
        changes += [(float(time[k + 1]), valve, float(values[k + 1])) for k in np.flatnonzero(np.diff(values))]
    return sorted(changes)


@COMPILERS
def test_a_sequence_in_a_soft_plc_equals_the_closed_simulation(compiler: Compiler, tmp_path: Path) -> None:
    circuit = poppet.load(FOLDER / "two_cylinders.toml")
    program = PlcProgram(
        circuit, "plc", SCAN, discrete=("a_back", "a_out", "b_back", "b_out", "pressed"), coils=("a", "b"),
        signals={"run": ((BEGIN, 1.0), (BEGIN + 1.0, 0.0))},
    )  # fmt: skip
    run = drive("two_cylinders_machine.toml", compiler(program, tmp_path / "plc"), BEGIN + 2.0, tmp_path)
    signal = poppet.signals.Steps((0.0, BEGIN, BEGIN + 1.0), (0.0, 1.0, 0.0))
    closed = circuit.with_signals({"plc.run": signal}).simulate(duration=BEGIN + 2.0, output_step=0.001)

    actual, expected = commands_of(run.time, run.series), commands_of(closed.time, closed)
    assert [change[1:] for change in actual] == [change[1:] for change in expected]
    assert len(expected) == 4  # A+ B+ B- A-
    shifts = np.array([a[0] - e[0] for a, e in zip(actual, expected, strict=True)])
    # The first command waits for a scan, and each step is longer or shorter by one delay at most.
    assert -1e-9 <= shifts[0] <= run.longest_delay
    assert np.abs(np.diff(shifts)).max() <= run.longest_delay
    for body in ("slideA", "slideB"):
        fastest = np.abs(closed[f"{body}.velocity"]).max()
        for k, (begin, *_) in enumerate(expected):
            duration = (expected[k + 1][0] if k + 1 < len(expected) else closed.time[-1] - 0.1) - begin
            grid = np.arange(0.0, duration, PERIOD)
            served = np.interp(actual[k][0] + grid, run.time, run.series[f"{body}.position"])
            simulated = np.interp(begin + grid, closed.time, closed[f"{body}.position"])
            assert np.abs(served - simulated).max() <= fastest * run.longest_delay


@COMPILERS
def test_a_pressure_controller_in_a_soft_plc_equals_the_closed_simulation(compiler: Compiler, tmp_path: Path) -> None:
    circuit = poppet.load(FOLDER / "pressure_control.toml")
    steps = ((0.0, 2e5), (BEGIN, 3e5), (BEGIN + 1.2, 2.5e5))
    program = PlcProgram(
        circuit, "regulator", SCAN, inputs=("measurement",), holding=("fill_command", "vent_command"),
        signals={"setpoint": steps},
    )  # fmt: skip
    end = BEGIN + 2.0
    run = drive("pressure_machine.toml", compiler(program, tmp_path / "plc"), end, tmp_path)
    signal = poppet.signals.Steps(*zip(*steps, strict=True))
    # The delay in the loop is between zero and one scan: both are limits of the recording.
    tubes = []
    for acts in ("at_once", "next_sample"):
        closed = circuit.with_values({"regulator.acts": acts}).with_signals({"regulator.setpoint": signal})
        recording = closed.simulate(duration=end, output_step=PERIOD)
        tubes.append(recording["tank.pressure"])
    n = int(np.ceil(run.longest_delay / PERIOD))
    windows = [np.lib.stride_tricks.sliding_window_view(np.pad(tube, (n, 0), mode="edge"), n + 1) for tube in tubes]
    window = np.concatenate(windows, axis=1)
    low, high = window.min(axis=1), window.max(axis=1)
    pressure = run.series["tank.pressure"][: low.size]
    excess = np.maximum(low[: pressure.size] - pressure, pressure - high[: pressure.size])
    assert excess.max() <= 20.0
