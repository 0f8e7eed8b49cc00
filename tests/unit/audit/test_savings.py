"""Savings: differences of two audits, rejected measures, and the bound for exhaust air."""

from __future__ import annotations

import functools
import math
from dataclasses import replace
from pathlib import Path

import pytest

import poppet
from poppet.audit.energy import audit_energy
from poppet.audit.energy_result import BalanceRow, FlowPathAir, LeakRow
from poppet.audit.savings import REUSE, Measure, default_measures, find_savings, reuse_bound
from poppet.audit.tariff import read_tariff

EXAMPLES = Path(__file__).parents[3] / "examples"
TARIFF = read_tariff({"tariff": "0.20 EUR/kWh", "specific_energy": "0.12 kWh/m^3", "hours": "4000 h"})
run = functools.partial(audit_energy, tariff=TARIFF)


@pytest.fixture(scope="module")
def machine():
    return poppet.load(EXAMPLES / "two_cylinders.toml")


@pytest.fixture(scope="module")
def audit(machine):
    return run(machine)


def test_default_measures_are_standard_sizes(machine, audit):
    assert [measure.values for measure in default_measures(machine, audit)] == [
        {"supply.pressure": "5 bar g"},
        {"cylinderA.bore": "25 mm"},
        {"cylinderB.bore": "32 mm"},
    ]


def test_pressures_that_an_input_sets_and_low_pressures_are_not_changed(machine, audit):
    low = machine.with_values({"supply.pressure": "2.9 bar g"})
    assert not [measure for measure in default_measures(low, audit) if "supply.pressure" in measure.values]


def test_a_tube_gets_half_of_its_length():
    circuit = poppet.load(EXAMPLES / "long_tube.toml")
    (name,) = (name for name, part in circuit.parts.items() if part.kind == "tube")
    values = [measure.values for measure in default_measures(circuit, replace(EMPTY, air={}))]
    assert values == [{f"{name}.length": f"{0.5 * float(circuit.parts[name].length):g} m"}]


def test_a_saving_is_the_difference_of_two_audits(machine, audit):
    values = {"cylinderA.bore": "25 mm"}
    rows, notes = find_savings(machine, audit, run, [Measure("smaller", values)])
    smaller = run(machine.with_values(values))
    assert [row.measure for row in rows] == ["smaller", REUSE]
    assert notes == ()
    assert rows[0].air == pytest.approx(audit.air_used - smaller.air_used, rel=1e-12)
    assert rows[0].air > 0.2 * audit.air_used
    assert rows[0].cycle_time == smaller.cycle.duration < audit.cycle.duration
    # At the same number of cycles per year, although the machine would now make more cycles.
    cycles = 4000.0 * 3600.0 / audit.cycle.duration
    assert rows[0].cost_per_year == pytest.approx(rows[0].air * 0.12 * 0.20 * cycles, rel=1e-9)
    assert math.isnan(rows[0].co2_per_year)


def test_a_measure_without_a_complete_cycle_is_rejected(machine, audit):
    rows, notes = find_savings(machine, audit, run, [Measure("5 bar", {"supply.pressure": "5 bar g"})])
    assert [row.measure for row in rows] == [REUSE]
    assert [(note.code, note.address) for note in notes] == [("savings.failed", "5 bar")]


def test_a_measure_with_an_invalid_value_is_rejected(machine, audit):
    _, notes = find_savings(machine, audit, run, [Measure("no bore", {"cylinderA.bore": "0 mm"})])
    assert [note.code for note in notes] == ["savings.failed"]


def test_a_measure_that_changes_the_steps_is_rejected(machine, audit):
    changed = replace(audit, cycle=replace(audit.cycle, steps=("wait", "fault")))
    rows, notes = find_savings(machine, audit, lambda circuit: changed, [Measure("same", {})])
    assert [row.measure for row in rows] == [REUSE]
    assert [(note.code, note.facts["steps"]) for note in notes] == [("savings.steps", ("wait", "fault"))]


def test_a_measure_that_shortens_a_stroke_is_rejected():
    """A timed valve does not notice that a weak cylinder no longer lifts its load."""
    circuit = poppet.loads(LIFT)
    lift = run(circuit)
    rows, notes = find_savings(circuit, lift, run, [Measure("weak", {"supply.pressure": "2 bar g"}),
                                                    Measure("enough", {"supply.pressure": "5 bar g"})])  # fmt: skip
    assert [(note.code, note.address, note.facts["body"]) for note in notes] == [("savings.motion", "weak", "load")]
    assert notes[0].facts["fraction"] < 0.5
    assert [row.measure for row in rows] == ["enough", REUSE]


LIFT = """
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"
[parts.valve]
kind = "spool_valve"
function = "5/2 monostable"
supply = "supply"
a = "cylinder.cap"
b = "cylinder.rod"
nominal_flow = "300 l/min ANR"
critical_ratio = 0.3
[parts.cylinder]
kind = "cylinder"
bore = "32 mm"
rod_diameter = "12 mm"
stroke_length = "100 mm"
body = "load"
cap = { dead_volume = "10 cm^3", wall_conductance = "0.2 W/K" }
rod = { dead_volume = "10 cm^3", wall_conductance = "0.2 W/K" }
[parts.load]
kind = "mass"
mass = "25 kg"
inclination = "90 deg"
friction = { kind = "viscous", viscous_coefficient = "200 N s/m" }
[signals."valve.command"]
kind = "square"
low = 0
high = 1
frequency = "0.25 Hz"
[run]
duration = "12 s"
"""


def path(name: str, source: str, target: str, forward: float, throttling: float, backward: float = 0.0) -> FlowPathAir:
    return FlowPathAir(name, name, source, target, forward - backward, forward, throttling)


class _NoStores:
    """Stand-in of a circuit whose only moving volume is the chamber of a cylinder."""

    class kernel:
        class model:
            stores = (type("Store", (), {"name": "cylinder.cap", "work": 3}),)


EMPTY = audit_energy(poppet.loads(LIFT), cycle="0 s, 0.1 s")


def test_the_bound_is_the_exergy_at_the_entry_of_the_exhaust_side():
    """A line feeds a cylinder, which vents through a volume with a throttle; neither the line nor its leak counts."""
    paths = (
        path("inlet", "supply", "line", 1e-3, 10.0),
        path("valve.supply", "line", "cylinder.cap", 9e-4, 20.0, backward=1e-5),
        path("valve.exhaust", "cylinder.cap", "vent", 9e-4, 30.0),
        path("throttle", "vent", "ambient", 9e-4, 40.0),
        path("leak", "line", "ambient", 1e-4, 5.0),
    )
    rows = (
        BalanceRow("supply", "supply", "supplied", 0.0, 200.0),
        BalanceRow("vent", "vent", "mixing", 0.0, 2.0),
        BalanceRow("cylinder.cap", "cylinder", "mixing", 0.0, 3.0),
        BalanceRow("throttle", "throttle", "exhausted", 0.0, 1.0),
    )
    leaks = (LeakRow("leak", "leak", 1e-4, 5.0, 0.0),)
    case = replace(EMPTY, air={"supply": 1e-3}, rows=rows, flow_paths=paths, leaks=leaks, tariff=TARIFF)
    (bound,) = reuse_bound(_NoStores, case)
    assert bound.is_bound
    assert bound.exergy == pytest.approx(30.0 + 40.0 + 2.0 + 1.0, rel=1e-12)
    assert bound.air == pytest.approx(1e-3 * 73.0 / 200.0, rel=1e-12)


def test_the_bound_of_the_machine_is_what_its_valves_throttle_to_the_ambient(machine, audit):
    (bound,) = reuse_bound(machine, audit)
    exhaust = [row for row in audit.rows if "exhaust" in row.name and row.category in ("throttling", "exhausted")]
    assert bound.exergy == pytest.approx(sum(row.exergy for row in exhaust), rel=1e-12)


def test_without_exhaust_air_there_is_no_bound(machine, audit):
    assert reuse_bound(machine, replace(audit, flow_paths=(), rows=())) == []


def test_a_cycle_that_does_not_repeat_with_a_measure_is_reported(machine):
    """Of the first second, in which the chambers fill."""
    first = functools.partial(run, cycle="0 s, 1 s")
    _, notes = find_savings(machine, first(machine), first, [Measure("smaller", {"cylinderA.bore": "25 mm"})])
    assert [(note.code, note.address) for note in notes] == [("savings.not_repeated", "smaller")]
