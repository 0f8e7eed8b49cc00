"""Machines with a clock, in a process of their own."""

from __future__ import annotations

import math
import os
import signal
import threading
import time

import numpy as np
import pytest

import poppet
from poppet.core.errors import InputError
from poppet.serve.clocked_periods import MachineClock
from poppet.serve.exchange import STATE
from poppet.serve.lateness import BOUNDS, LATE, N_CLASSES, class_of
from poppet.serve.machine_process import ProcessMachine
from poppet.serve.points import ServedCircuit
from poppet.serve.snapshot import MachineState
from served_tanks import EMPTIED_TANK, FILLED_TANK

PATIENCE = 60.0


@pytest.fixture(scope="module")
def circuit() -> poppet.Circuit:
    return poppet.loads(FILLED_TANK)


def wait_until(condition):
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


def test_a_machine_that_does_not_wait_equals_the_simulation(circuit):
    machine = ProcessMachine(ServedCircuit.of(circuit), MachineClock(0.01, math.inf, n_periods=500))
    wait_until(lambda: machine.state is MachineState.STOPPED)
    machine.stop()
    first, rows = machine.rows()
    expected = circuit.simulate("5 s", "10 ms")
    assert first == 0
    assert np.allclose(rows[:, 0], expected.time, rtol=1e-15)
    assert np.allclose(rows[:, machine.row_names.index("tank.pressure")], expected["tank.pressure"], rtol=1e-5)
    assert machine.lateness().periods == 501


def test_signals_to_all_processes_of_a_program_do_not_end_the_machine(circuit):
    with circuit.serve("5 ms") as machine:
        count = machine.snapshot().period
        for number in (signal.SIGINT, signal.SIGTERM):
            os.kill(machine._process.pid, number)
        wait_until(lambda: machine.snapshot().period >= count + 20)
        assert machine.state is MachineState.RUNNING


def test_a_machine_in_real_time_counts_each_period(circuit):
    with circuit.serve("5 ms", speed=2.0) as machine:
        machine.write({"supply.pressure": "3 bar"})
        wait_until(lambda: machine.snapshot().period >= 100)
        assert machine.note is None
    assert machine.state is MachineState.STOPPED
    _, rows = machine.rows()
    lateness = machine.lateness()
    # Each row contains the lateness of its period.
    assert lateness.periods == len(rows)
    assert lateness.late == np.count_nonzero(rows[:, -1] > LATE)
    assert lateness.maximum == pytest.approx(rows[:, -1].max(), abs=1e-9)
    classes = [class_of(late) for late in rows[:, -1]]
    assert lateness.histogram == tuple(np.bincount(classes, minlength=N_CLASSES))
    assert "periods" in lateness.table()
    assert machine.snapshot()["supply.pressure"] == 3e5
    assert rows[-1, machine.row_names.index("supply.pressure")] == 3e5


def test_classes_of_lateness():
    assert [class_of(bound) for bound in BOUNDS] == list(range(len(BOUNDS)))
    assert class_of(0.0) == 0
    assert class_of(10.0) == N_CLASSES - 1


def test_a_process_that_ends_is_noticed(circuit):
    with circuit.serve() as machine:
        last = machine.snapshot()["tank.pressure"]
        machine._process.kill()
        wait_until(lambda: machine.state is MachineState.FAILED)
        assert machine.note is not None
        assert machine.note.code == "serve.lost"
        assert machine.snapshot()["tank.pressure"] >= last


def test_threads_close_the_pipe_of_a_machine_once(circuit, monkeypatch):
    """A second call would close a file that was opened meanwhile."""
    closed = []

    class Pipe:
        closed = False

        def poll(self):
            raise EOFError

        def close(self):
            closed.append(threading.current_thread())
            time.sleep(0.05)
            self.closed = True

    with circuit.serve() as machine:
        monkeypatch.setattr(machine, "_reports", Pipe())
        threads = [threading.Thread(target=machine.take_notes) for _ in range(4)]
        machine._process.kill()
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert machine.state is MachineState.FAILED
    assert len(closed) == 1


@pytest.mark.skipif(not hasattr(signal, "SIGSTOP"), reason="this system cannot suspend a process")
def test_a_machine_that_is_far_behind_sets_its_clock_back(circuit):
    with circuit.serve() as machine:
        os.kill(machine._process.pid, signal.SIGSTOP)
        time.sleep(1.2)
        os.kill(machine._process.pid, signal.SIGCONT)
        notes = []
        wait_until(lambda: notes.extend(machine.take_notes()) or notes)
        assert [note.code for note in notes] == ["serve.behind"]
        assert notes[0].facts["seconds"] > 1.0
        assert "behind its clock" in str(notes[0])
        assert machine.lateness().behind == 1
        wait_until(lambda: machine.lateness().late >= 1)


def test_a_failure_of_the_integration_is_reported():
    machine = ProcessMachine(ServedCircuit.of(poppet.loads(EMPTIED_TANK)), MachineClock(0.01, math.inf))
    wait_until(lambda: machine.state is MachineState.FAILED)
    wait_until(lambda: machine.note is not None)
    assert machine.note.code == "serve.failed"
    assert 0.0 <= machine.note.facts["time"] - machine.snapshot().time <= 0.01
    assert machine.note.facts["reason"] in str(machine.note)
    machine.stop()
    assert MachineState(int(machine.exchange.fields[STATE])) is MachineState.FAILED
    assert math.isfinite(machine.snapshot()["tank.pressure"])


def test_invalid_clocks(circuit):
    for speed in (0.0, -1.0, math.nan):
        with pytest.raises(InputError) as caught:
            circuit.serve(speed=speed)
        assert (caught.value.code, caught.value.address) == ("serve.speed", "speed")
    for period, speed in (("0.09 ms", 1.0), ("1e-9 s", 1.0), ("0.09 ms", 100.0), ("9 us", 0.1)):
        with pytest.raises(InputError) as caught:
            circuit.serve(period, speed=speed)
        assert (caught.value.code, caught.value.address) == ("serve.short_period", "period")
    assert MachineClock(1e-9, math.inf).shortest_period == 0.0
    assert MachineClock(1e-3, 0.1).shortest_period == pytest.approx(1e-5)
    with circuit.serve() as machine, pytest.raises(InputError) as caught:
        machine.advance("1 s")
    assert caught.value.code == "serve.clocked"
