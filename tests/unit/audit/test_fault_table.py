"""Consequences of single faults, of the template machine and of small circuits with known behaviour."""

from __future__ import annotations

import math
import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet import Chamber, CheckValve, Circuit, DirectionalValve, Orifice, Reservoir, load
from poppet.audit.fault_result import FaultTable
from poppet.audit.fault_table import fault_table
from poppet.core.errors import InputError
from poppet.signals import Steps

MACHINE = Path(poppet.__file__).parent / "cli" / "templates" / "machine.toml"
EXAMPLES = Path(__file__).parents[3] / "examples"
AIR_DENSITY = 1e5 / (287.05287 * 293.15)  # dry, at 1 bar
FLOW = {"sonic_conductance": "1 dm^3/(s bar)", "critical_ratio": 0.3}


def kinds_of(table: FaultTable, fault: str, address: str = "") -> list[str]:
    row = table.row(fault)
    return [item.kind for item in row.consequences if address in ("", item.address)]


def consequence(table: FaultTable, fault: str, kind: str, address: str):
    row = table.row(fault)
    return next(item for item in row.consequences if (item.kind, item.address) == (kind, address))


@pytest.fixture(scope="module")
def machine() -> FaultTable:
    return fault_table(load(MACHINE))


def test_a_full_volume_that_a_fault_exhausts_is_a_consequence():
    parts = {
        "supply": Reservoir(pressure="6 bar g"),
        "tank": Chamber(volume="2 l", initial_pressure="6 bar g", thermal="isothermal"),
        "valve": DirectionalValve(
            supply="supply", outlet="tank", exhaust="ambient", command=1.0, initial_position=1.0,
            switching_time="1 ms", **FLOW,
        ),
    }  # fmt: skip
    table = fault_table(Circuit(parts), duration="1.2 s")
    falls = consequence(table, "valve.stuck_closed", "pressure_falls", "tank")
    # Choked outflow of an isothermal tank: C rho_ANR R T / V = 1e-8 / 2e-3 * 1e5 per second, within the humidity.
    assert falls.value + 1e5 == pytest.approx(7e5 * math.exp(-0.6), rel=4e-3)
    assert (falls.healthy, falls.time) == (pytest.approx(6e5), pytest.approx(1.2))
    assert kinds_of(table, "valve.stuck_open") == ["none"]
    # The leak fills nothing: without the fault, the supply delivers no air.
    assert consequence(table, "valve.leak", "air", "supply").healthy == 0.0


def test_an_unknown_fault_of_a_table_is_an_error(machine):
    with pytest.raises(InputError, match="is not the name of a fault of the table") as error:
        machine.row("valveA.stuck_opn")
    assert error.value.hint == "Did you mean valveA.stuck_open, valveB.stuck_open or valveA.stuck?"


def test_every_single_fault_of_the_machine_is_run(machine):
    words = ("stuck_open", "stuck_closed", "stuck", "slow", "leak")
    assert {f"valve{name}.{word}" for name in "AB" for word in words} <= {row.fault for row in machine.rows}
    assert machine.is_whole
    # The start button is pressed again 1.5 s after the first time.
    assert machine.cycle_time == pytest.approx(1.5, abs=1e-9)


def test_a_valve_that_opens_extends_its_cylinder_without_a_command(machine):
    for name, stroke in (("A", 0.08), ("B", 0.05)):
        moved = consequence(machine, f"valve{name}.stuck_open", "moves_without_command", f"slide{name}")
        # Before the start button is pressed; both end stops yield by some tenths of a millimetre.
        assert moved.time < 0.05
        assert stroke < moved.value < 1.03 * stroke
        stays = consequence(machine, f"valve{name}.stuck_open", "pressure_stays", f"cylinder{name}.cap")
        assert stays.value == pytest.approx(6e5, rel=0.02)
        other = "B" if name == "A" else "A"
        assert "moves_without_command" not in kinds_of(machine, f"valve{name}.stuck_open", f"slide{other}")


def test_a_valve_that_never_opens_stops_the_sequence(machine):
    # The steps A+ and B+ wait until their timeouts of 2 s.
    timeout = consequence(machine, "valveA.stuck_closed", "timed_out", "plc")
    assert (timeout.facts["step"], timeout.facts["target"]) == ("A+", "fault")
    assert timeout.time == pytest.approx(0.2 + 2.0, abs=6e-3)
    assert consequence(machine, "valveB.stuck", "timed_out", "plc").facts["step"] == "B+"
    waits = consequence(machine, "valveA.stuck", "waits", "plc")
    assert (waits.facts["step"], waits.time) == ("fault", pytest.approx(timeout.time))
    for fault in ("valveA.stuck_closed", "valveA.stuck"):
        assert consequence(machine, fault, "not_reached", "slideA").value == pytest.approx(0.0, abs=1e-4)
        # The part is not clamped: B does not punch.
        assert consequence(machine, fault, "not_reached", "slideB").healthy == pytest.approx(0.05, rel=0.01)
        assert consequence(machine, fault, "pressure_stays", "cylinderA.rod").value == pytest.approx(6e5, rel=0.02)
        assert machine.row(fault).stops_machine


def test_a_slow_valve_and_a_leak_do_not_stop_the_machine(machine):
    for name in "AB":
        slow = machine.row(f"valve{name}.slow")
        assert not slow.stops_machine
        stroke = consequence(machine, f"valve{name}.slow", "stroke_time", f"slide{name}")
        # Switching takes 100 ms in place of 10 ms, and the air flows from about its middle on.
        assert 0.02 < stroke.value - stroke.healthy < 0.1
        leak = consequence(machine, f"valve{name}.leak", "air", "supply")
        assert leak.value > leak.healthy > 0.0
        assert not machine.row(f"valve{name}.leak").stops_machine


def test_cycles_of_equal_number_are_compared():
    """With the regulator closed, the machine completes only its first cycle, which includes waiting for the button."""
    circuit = load(MACHINE)
    recording = circuit.simulate(3.2, 1e-3)
    is_first = recording["plc.step"] == recording["plc.step"][0]
    returned = recording.time[np.flatnonzero(is_first & (np.cumsum(~is_first) > 0))[0]]
    table = fault_table(circuit, kinds=("stuck_closed",), start="0.3 s")
    cycle = consequence(table, "regulator.stuck_closed", "cycle_time", "plc")
    assert cycle.healthy == pytest.approx(returned, abs=1.5e-3)
    assert table.cycle_time < returned - 0.02


def test_the_arm_of_the_example_waits():
    table = fault_table(load(EXAMPLES / "pick_and_place.toml"))
    waits = consequence(table, "swing.stuck_closed", "waits", "plc")
    assert (waits.facts["step"], waits.healthy) == ("there", pytest.approx(1.29, abs=0.02))
    assert consequence(table, "swing.stuck_closed", "not_reached", "arm.shaft").unit == "rad"
    # The third workpiece is missing in every run: this timeout is no consequence of a fault.
    assert "timed_out" not in kinds_of(table, "grip.leak") + kinds_of(table, "swing.slow")
    # Without a grip, the first step already ends by its timeout.
    assert consequence(table, "grip.stuck", "timed_out", "plc").time == pytest.approx(1.0, abs=6e-3)
    # The closed gripper cannot move when the workpiece vanishes from a signal.
    assert "moves_without_command" not in kinds_of(table, "grip.stuck_open")


def test_a_cup_without_its_ejector_has_no_vacuum():
    table = fault_table(load(EXAMPLES / "vacuum.toml"), kinds=["stuck_closed", "stuck_open"])
    missing = consequence(table, "valve.stuck_closed", "vacuum_missing", "cup")
    assert missing.value == pytest.approx(0.0, abs=1e3)
    assert 1e4 < missing.healthy < 1e5
    assert "vacuum_missing" not in kinds_of(table, "valve.stuck_open")


def simple_circuit() -> Circuit:
    """A 3/2 valve fills and vents a tank behind a check valve that the run never needs."""
    parts = {
        "supply": Reservoir(pressure="6 bar g"),
        "check": CheckValve(from_="supply", to="line", cracking_pressure=0.0, **FLOW),
        "line": Chamber(volume="0.5 l", initial_pressure="6 bar g", thermal="isothermal"),
        "valve": DirectionalValve(
            supply="line", outlet="tank", exhaust="ambient", exhaust_conductance="1 dm^3/(s bar)", exhaust_ratio=0.3,
            switching_time="10 ms", **FLOW,
        ),
        "tank": Chamber(volume="0.2 l", initial_pressure="0 bar g", thermal="isothermal"),
    }  # fmt: skip
    signal = Steps([0.0, 0.5, 1.5], [0.0, 1.0, 0.0])
    return Circuit(parts, signals={"valve.command": signal}, title="Tank").with_values({"run.duration": "4 s"})


def test_pressures_of_a_tank():
    table = fault_table(simple_circuit())
    stays = consequence(table, "valve.stuck_open", "pressure_stays", "tank")
    assert (stays.value, stays.healthy) == (pytest.approx(6e5, rel=1e-3), pytest.approx(0.0, abs=1e3))
    missing = consequence(table, "valve.stuck_closed", "pressure_missing", "tank")
    assert (missing.value, missing.healthy) == (pytest.approx(0.0, abs=1e3), pytest.approx(6e5, rel=0.01))
    assert kinds_of(table, "check.stuck_open") == ["none"]
    assert table.row("check.stuck_open").is_hidden
    assert {(fault.valve, fault.word) for fault in table.omitted} == {("check", "stuck"), ("check", "slow")}
    # Without the fault, the tank takes 0.2 l at 6 bar. During 4 s, 5 % of C passes the closed inlet or exhaust: choked
    # flow from 7 bar absolute, less than that by the pressure loss before the exhaust.
    leak = consequence(table, "valve.leak", "air", "supply")
    assert leak.healthy == pytest.approx(1.2e-3 * AIR_DENSITY / 1.185, rel=0.01)
    assert leak.value - leak.healthy == pytest.approx(0.05 * 7.0 * 4.0 * 1e-3, rel=0.06)


def test_a_fault_begins_at_its_start():
    early, late = (fault_table(simple_circuit(), kinds=["stuck_closed"], start=start) for start in ("0 s", "1 s"))
    assert "pressure_missing" in kinds_of(early, "valve.stuck_closed")
    # From 1 s on, the tank empties; at 1.5 s, it would do so anyway.
    assert "pressure_stays" not in kinds_of(late, "valve.stuck_closed")
    stuck = fault_table(simple_circuit(), kinds=["stuck"], start="1 s")
    stays = consequence(stuck, "valve.stuck", "pressure_stays", "tank")
    assert stays.time == pytest.approx(1.0, abs=2e-3)


def test_the_table_does_not_depend_on_the_output_step():
    tables = [fault_table(simple_circuit().with_values({"run.output_step": step})) for step in ("1 s", "10 ms")]
    assert tables[0].rows == tables[1].rows


def test_all_faults_share_one_compiled_model():
    from poppet.audit.valve_faults import split_faults, valves_of, with_idle_faults

    circuit = simple_circuit()
    faults, _ = split_faults(valves_of(circuit), ("stuck_open", "stuck", "slow", "leak"))
    base = with_idle_faults(circuit, faults)
    assert {base.with_values(fault.values(0.5)).structure for fault in faults} == {base.structure}
    # A fault that never begins changes nothing.
    healthy, idle = (run.simulate("4 s", "1 ms") for run in (circuit, base))
    for address in ("tank.pressure", "line.pressure", "valve.position"):
        assert idle[address] == pytest.approx(healthy[address], rel=1e-9, abs=1e-9)


def test_a_valve_that_already_has_a_fault_has_no_second_one():
    circuit = simple_circuit().with_values({"valve.fault": "leak"})
    assert {row.valve for row in fault_table(circuit).rows} == {"check"}


def test_keys_of_the_result_file(tmp_path, machine):
    machine.save(tmp_path / "faults.toml")
    content = tomllib.loads((tmp_path / "faults.toml").read_text())
    assert {"title", "start_s", "duration_s", "threshold_pa", "faults", "omitted", "is_whole"} <= content.keys()
    first = next(row for row in content["faults"] if row["fault"] == "valveA.stuck_open")
    assert (first["valve"], first["word"]) == ("valveA", "stuck_open")
    assert {"kind", "address", "text"} <= first["consequences"][0].keys()


def test_a_failed_run_is_a_consequence(monkeypatch):
    real = Circuit.simulate

    def fail(self, *arguments, **options):
        recording = real(self, *arguments, **options)
        if options.get("throw", True):
            return recording
        return recording.between(0.0, 0.7)

    monkeypatch.setattr(Circuit, "simulate", fail)
    table = fault_table(simple_circuit(), kinds=["leak"])
    assert kinds_of(table, "valve.leak") == ["failed"]
    assert table.row("valve.leak").consequences[0].time == pytest.approx(0.7)
    assert not table.row("valve.leak").is_hidden


def test_an_interrupted_table_keeps_completed_runs():
    def progress(done: int, total: int, last: str) -> None:
        assert total == 8
        if done == 2:
            raise KeyboardInterrupt

    table = fault_table(simple_circuit(), progress=progress)
    assert not table.is_whole
    assert len(table.rows) == 2


@pytest.mark.parametrize(
    ("options", "code", "address"),
    [
        ({"kinds": ["open"]}, "fields.not_an_option", "kinds"),
        ({"kinds": []}, "safety.no_kinds", "kinds"),
        ({"start": "9 s"}, "safety.outside_run", "start"),
        ({"start": "-1 s"}, "safety.outside_run", "start"),
        ({"threshold": "-1 bar"}, "safety.not_positive", "threshold"),
        ({"duration": "0 s"}, "safety.not_positive", "duration"),
    ],
)
def test_invalid_arguments(options, code, address):
    with pytest.raises(InputError) as caught:
        fault_table(simple_circuit(), **options)
    assert (caught.value.code, caught.value.address) == (code, address)


def test_a_circuit_without_valves_or_without_a_duration():
    parts = {"tank": Chamber(volume="1 l"), "leak": Orifice(from_="tank", to="ambient", **FLOW)}
    with pytest.raises(InputError) as caught:
        fault_table(Circuit(parts), duration="1 s")
    assert caught.value.code == "safety.no_valve"
    with pytest.raises(InputError) as caught:
        fault_table(replace(simple_circuit(), run=poppet.Run()))
    assert caught.value.address == "run.duration"
