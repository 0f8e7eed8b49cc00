"""Machines without a clock: values, writes and faults, compared with simulations."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import poppet
from poppet.core.errors import InputError, InputErrors
from poppet.serve.machine import Machine
from poppet.serve.points import PointRole, ServedCircuit
from poppet.serve.snapshot import MachineState
from poppet.signals import Steps
from served_tanks import DELAYED_TANK


@pytest.fixture(scope="module")
def circuit() -> poppet.Circuit:
    return poppet.loads(DELAYED_TANK)


@pytest.fixture
def machine(circuit):
    with circuit.serve("10 ms", clock=False) as machine:
        yield machine


def test_points(circuit):
    served = pickle.loads(pickle.dumps(ServedCircuit.of(circuit)))
    points = {point.address: point for point in served.points}
    assert len(points) == len(served.points)
    assert served.writable == ("supply.pressure", "supply.temperature", "valve.command")
    assert {a for a, p in points.items() if p.role is not PointRole.PARAMETER} == set(circuit.model.columns[0])
    command, volume = points["valve.command"], points["tank.volume"]
    assert (command.low, command.high, command.initial, command.role) == (0.0, 1.0, 0.0, PointRole.INPUT)
    assert (volume.initial, volume.unit, volume.role) == (0.002, "m^3", PointRole.PARAMETER)
    assert served.faults == {"valve": ("stuck_open", "stuck_closed", "stuck", "slow", "leak")}


def test_written_values_act_after_the_delay_of_the_input(circuit, machine):
    machine.write({"valve.command": 1})
    machine.advance("0.1 s")
    machine.write({"valve.command": 0, "supply.pressure": "5 bar g"})
    machine.advance("0.1 s")
    recording = machine.recording()
    # A write acts at the next period, here 0.11 s.
    signals = {
        "valve.command": Steps([0.0, 1e-9, 0.11], [0.0, 1.0, 0.0]),
        "supply.pressure": Steps([0.0, 0.11], [7e5, 6e5]),
    }
    expected = circuit.with_signals(signals).simulate("0.2 s", "10 ms")
    assert np.allclose(recording.time, expected.time, rtol=1e-15)
    for name in ("tank.pressure", "valve.position", "supply.pressure"):
        assert np.allclose(recording[name], expected[name], rtol=1e-5, atol=1e-6)


def test_faults_are_switched_while_it_runs(circuit, machine):
    machine.write({"valve.command": 1})
    machine.set_fault("valve", "stuck_closed")
    assert machine.fault_of("valve") == "stuck_closed"
    machine.advance("0.1 s")
    assert machine.snapshot()["tank.pressure"] == pytest.approx(1e5)
    machine.set_fault("valve", "none")
    machine.advance("0.1 s")
    healthy = circuit.with_signals({"valve.command": Steps([0.0], [1.0])}).simulate("90 ms")
    assert machine.snapshot()["tank.pressure"] == pytest.approx(healthy["tank.pressure"][-1], rel=1e-5)
    machine.set_fault("valve", "slow")
    assert machine.fault_of("valve") == "slow"


def test_invalid_writes_change_nothing(machine):
    with pytest.raises(InputErrors) as caught:
        machine.write(
            {
                "valve.command": 1.0,
                "supply.pressure": -1.0,
                "supply.temperature": float("nan"),
                "tank.pressure": 1e5,
                "tank.volume": 1.0,
                "valve.comand": 1.0,
            },
            "test",
        )
    codes = {error.address: error.code for error in caught.value.problems}
    assert codes == {
        "supply.pressure": "inputs.outside",
        "supply.temperature": "quantity.not_finite",
        "tank.pressure": "serve.not_writable",
        "tank.volume": "serve.not_writable",
        "valve.comand": "names.unknown",
    }
    machine.advance("20 ms")
    assert machine.snapshot()["valve.command"] == 0.0


def test_an_implausible_number_is_rejected(machine):
    # 6 bar as a float32 with exchanged words
    with pytest.raises(InputError) as caught:
        machine.write({"supply.pressure": 2.66e36})
    assert (caught.value.code, caught.value.facts["most"]) == ("quantity.too_large", 1e12)


def test_a_truth_value_is_a_command_but_no_pressure(machine):
    machine.write({"valve.command": True})
    with pytest.raises(InputError) as caught:
        machine.write({"supply.pressure": True})
    assert caught.value.code == "quantity.not_a_number"
    assert machine.advance("20 ms")["valve.command"] == 1.0


def test_driven_inputs_cannot_be_written(circuit):
    driven = circuit.with_signals({"valve.command": Steps([0.0], [1.0])})
    with driven.serve(clock=False) as machine, pytest.raises(InputError) as caught:
        machine.write({"valve.command": 0.0})
    assert (caught.value.code, caught.value.address) == ("serve.driven", "valve.command")


def test_invalid_faults(machine):
    with pytest.raises(InputError) as caught:
        machine.set_fault("valve", "stuk")
    assert (caught.value.code, caught.value.facts["suggestion"].names[0]) == ("fields.not_an_option", "stuck")
    with pytest.raises(InputError) as caught:
        machine.set_fault("tank", "stuck")
    assert (caught.value.code, caught.value.address) == ("names.unknown", "tank")
    assert machine.fault_of("valve") == "none"


def test_a_snapshot_shows_written_values_before_they_act(machine):
    machine.write({"valve.command": 1})
    snapshot = machine.snapshot()
    assert (snapshot.period, snapshot["valve.command"], snapshot["tank.volume"]) == (-1, 1.0, 0.002)
    assert np.isnan(snapshot["tank.pressure"])
    assert machine.advance("10 ms").period == 1
    assert len(machine.snapshot().array) == len(machine.points)


def test_rows_that_are_overwritten_are_skipped(circuit):
    with circuit.serve("1 ms", clock=False) as machine:
        size = machine.exchange.layout.n_rows
        machine.advance(0.001 * (size + 99))
        first, rows = machine.rows(10)
        assert first + len(rows) == size + 100
        assert np.allclose(rows[:, 0], 1e-3 * np.arange(first, size + 100))
        assert 101 <= first <= 102
        assert machine.rows(size + 100)[1].shape == (0, len(machine.row_names))


def test_invalid_periods(circuit):
    for period in (0.0, -1.0):
        with pytest.raises(InputError) as caught:
            circuit.serve(period, clock=False)
        assert (caught.value.code, caught.value.address) == ("serve.period", "period")


def test_a_failed_machine_keeps_its_last_values():
    circuit = poppet.loads(DELAYED_TANK.replace('volume = "2 l"', 'volume = "2 l"\nthermal = "isothermal"'))
    machine = Machine(ServedCircuit.of(circuit), 0.01)
    machine.advance("50 ms")
    machine._plant._call.limits[1] = 0.0  # the maximum number of attempts
    machine.write({"valve.command": 1})
    snapshot = machine.advance("1 s")
    assert snapshot.state is MachineState.FAILED
    assert snapshot.note is not None
    assert snapshot.note.code == "run.ended.too_many"
    assert snapshot["tank.pressure"] == pytest.approx(1e5)
    assert machine.advance("1 s").period == snapshot.period
    for command in ({"valve.command": 0}, {}), ({}, {"valve": "leak"}):
        with pytest.raises(InputError) as caught:
            machine.command(*command)
        assert (caught.value.code, caught.value.facts) == ("serve.not_running", {"state": "failed"})
    assert machine.snapshot()["valve.command"] == 1.0
