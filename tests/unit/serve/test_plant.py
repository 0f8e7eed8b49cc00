"""Plants beside simulations: signals of all kinds, delays, positions of a guide, and long runs."""

from __future__ import annotations

import numpy as np
import pytest

import poppet
from poppet import Chamber, CheckValve, Circuit, Cylinder, Guide, Orifice, Reservoir
from poppet.serve.courses import WINDOW
from poppet.serve.plant import FAULT_CODES, ServedPlant, initial_commands
from poppet.serve.points import ServedCircuit
from poppet.serve.snapshot import MachineState
from poppet.signals import Chirp, Points, Prbs, Pwm, Sine, Square, Steps

TANK = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"

[parts.fill]
kind = "directional_valve"
supply = "supply"
outlet = "tank"
exhaust = "ambient"
sonic_conductance = "1e-8 m^3/(s Pa)"
critical_ratio = 0.3
delay = "13 ms"

[parts.tank]
kind = "chamber"
volume = "5 l"

[run]
duration = "5 s"
"""
DRIVES = {
    "prbs": Prbs(0.0, 1.0, 0.037, seed=5),
    "square": Square(0.0, 1.0, 3.7, duty=0.4),
    "pwm": Pwm(23.0, Sine(0.5, 0.4, 0.3)),
    "chirp": Chirp(0.5, 0.5, 0.5, 5.0),
    "points": Points([0.5, 1.7, 3.1], [0.0, 1.0, 0.2]),
    "steps": Steps([0.0, 0.5, 0.505, 3.0], [0.0, 1.0, 0.0, 1.0]),
}


def rows_of(plant: ServedPlant, count: int, commands: np.ndarray) -> np.ndarray:
    rows = []
    for _ in range(count):
        plant.begin(commands)
        rows.append(plant.outputs.copy())
        plant.advance()
        assert plant.failure is None
    return np.array(rows)


@pytest.mark.parametrize("name", DRIVES)
def test_signals_are_exact(name):
    circuit = poppet.loads(TANK).with_signals({"fill.command": DRIVES[name]})
    expected = circuit.simulate("5 s", "10 ms")
    served = ServedCircuit.of(circuit)
    rows = rows_of(ServedPlant(served, 0.01), 500, initial_commands(served))
    for address in ("tank.pressure", "fill.position"):
        values = rows[:, served.columns.index(address)]
        assert np.allclose(values, expected[address][:500], rtol=2e-5, atol=2e-5), address


def test_a_fault_of_the_file_begins_at_its_time_until_another_is_set():
    circuit = poppet.loads(TANK.replace('delay = "13 ms"', 'fault = "stuck_open"\nfault_start = "0.1 s"'))
    expected = circuit.simulate("0.5 s", "10 ms")
    served = ServedCircuit.of(circuit)
    commands, plant = initial_commands(served), ServedPlant(served, 0.01)
    rows = rows_of(plant, 50, commands)
    pressure = served.columns.index("tank.pressure")
    assert np.allclose(rows[:, pressure], expected["tank.pressure"][:50], rtol=1e-5)
    assert served.initial_faults == {"fill": "stuck_open"}
    assert commands[-1] == FAULT_CODES["stuck_open"]
    commands[-1] = FAULT_CODES["none"]
    repaired = rows_of(plant, 100, commands)[:, pressure]
    # The valve without a command exhausts the tank.
    assert repaired[0] > repaired[20] > repaired[-1] > 1e5


def test_a_written_position_moves_over_one_period():
    text = """
    [parts.rod]
    kind = "guide"
    position = "20 mm"

    [parts.cylinder]
    kind = "cylinder"
    body = "rod"
    bore = "32 mm"
    rod_diameter = "12 mm"
    stroke_length = "100 mm"
    cap = { dead_volume = "10 cm^3" }
    rod = { dead_volume = "10 cm^3" }
    """
    circuit = poppet.loads(text)
    served = ServedCircuit.of(circuit)
    assert served.writable == ("rod.position",)
    plant, commands = ServedPlant(served, 0.01), initial_commands(served)
    first = rows_of(plant, 3, commands)
    commands[0] = 0.021
    rows = np.concatenate([first, rows_of(plant, 5, commands)])
    moved = circuit.with_signals({"rod.position": Points([0.03, 0.04], [0.02, 0.021])}).simulate("0.1 s", "10 ms")
    for address in ("rod.position", "cylinder.cap.pressure", "cylinder.rod.pressure"):
        values = rows[:, served.columns.index(address)]
        assert np.allclose(values, moved[address][:8], rtol=1e-6), address
    assert np.ptp(rows[:, served.columns.index("cylinder.cap.pressure")]) > 1000.0


def test_positions_that_are_written_in_each_period_form_one_line():
    rod = Guide(position="20 mm")
    chamber = {"dead_volume": "10 cm^3"}
    cylinder = Cylinder(
        body="rod", bore="32 mm", rod_diameter="12 mm", stroke_length="100 mm", cap=chamber, rod=chamber
    )
    circuit = Circuit({"rod": rod, "cylinder": cylinder})
    served = ServedCircuit.of(circuit)
    plant, commands = ServedPlant(served, 0.01), initial_commands(served)
    rows = []
    for k in range(12):
        commands[0] = 0.02 + 0.001 * min(max(k - 2, 0), 5)
        rows.append(rows_of(plant, 1, commands)[0])
    moved = circuit.with_signals({"rod.position": Points([0.03, 0.08], [0.02, 0.025])}).simulate("0.2 s", "10 ms")
    for address in ("rod.position", "cylinder.cap.pressure", "cylinder.rod.pressure"):
        values = np.array(rows)[:, served.columns.index(address)]
        assert np.allclose(values, moved[address][:12], rtol=1e-6), address


def test_a_machine_of_days_needs_constant_memory_and_keeps_its_time():
    circuit = poppet.loads(TANK).with_signals({"fill.command": Square(0.0, 1.0, 5.0)})
    served = ServedCircuit.of(circuit)
    plant, commands = ServedPlant(served, 0.01), initial_commands(served)
    rows_of(plant, 100, commands)
    # Ten days later, as if all periods had been run.
    plant.count = 86_400_000
    plant.t = plant.time_of(plant.count)
    rows = rows_of(plant, 200, commands)
    assert plant.t == 864_002.0
    command = rows[:, served.columns.index("fill.command")]
    # The delay of 13 ms is between two periods.
    assert np.array_equal(command[:20], [0.0, 0.0, *[1.0] * 10, *[0.0] * 8])
    assert np.array_equal(command, np.tile(command[:20], 10))
    (course,) = plant._courses.values()
    assert len(course._starts) < 4 * 5.0 * WINDOW


def test_a_stroke_outside_the_domain_of_its_characteristic_is_a_failure():
    table = {
        "kind": "table",
        "stroke": ["0 mm", "1 mm"],
        "sonic_conductance": ["1e-9 m^3/(s Pa)", "1e-8 m^3/(s Pa)"],
        "critical_ratio": [0.3, 0.3],
        "edge": "error",
    }
    circuit = Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "fill": Orifice(from_="supply", to="tank", characteristic=table),
            "tank": Chamber(volume="10 l"),
        }
    )
    with circuit.serve(clock=False) as machine:
        machine.write({"fill.stroke": "1 mm"})
        assert machine.advance("0.1 s").note is None
        machine.write({"fill.stroke": "1.1 mm"})
        snapshot = machine.advance("0.1 s")
    assert snapshot.state is MachineState.FAILED
    assert (snapshot.note.code, snapshot.note.address) == ("run.left_domain", "fill.stroke")
    assert snapshot.time == pytest.approx(0.11)


def test_a_circuit_without_inputs_and_faults():
    circuit = Circuit(
        {
            "tank": Chamber(volume="1 l", initial_pressure="3 bar"),
            "other": Chamber(volume="1 l"),
            "pipe": CheckValve(from_="tank", to="other", sonic_conductance=1e-8, critical_ratio=0.3),
        }
    )
    with circuit.serve(clock=False) as machine:
        machine.advance("1 s")
        recording = machine.recording()
    expected = circuit.simulate("1 s", "10 ms")
    assert np.allclose(recording["tank.pressure"], expected["tank.pressure"], rtol=1e-5)
