"""Leaks of a circuit: leakage past pistons, named flow paths, and valves that do not close."""

from __future__ import annotations

import functools
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet.audit.circuit_leaks import find_leaks
from poppet.audit.energy import audit_energy
from poppet.audit.tariff import read_tariff
from refusals import refused

EXAMPLES = Path(__file__).parents[3] / "examples"
TARIFF = read_tariff({"tariff": "0.02 EUR/m^3", "hours": "1000 h"})
run = functools.partial(audit_energy, tariff=TARIFF)
LEAKY = """
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"
[parts.valve]
kind = "directional_valve"
supply = "supply"
outlet = "outlet"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
fault = "leak"
leak_fraction = 0.02
[parts.outlet]
kind = "chamber"
volume = "1 cm^3"
initial_pressure = "0 bar g"
thermal = "isothermal"
[parts.vent]
kind = "orifice"
from = "outlet"
to = "ambient"
sonic_conductance = "20 dm^3/(s bar)"
critical_ratio = 0.3
[run]
duration = "3 s"
"""


@pytest.fixture(scope="module")
def machine():
    leakage = {"cylinderA.leakage.sonic_conductance": "2 cm^3/(s bar)", "cylinderA.leakage.critical_ratio": 0.3}
    return poppet.load(EXAMPLES / "two_cylinders.toml").with_values(leakage)


@pytest.fixture(scope="module")
def audit(machine):
    return run(machine)


def test_leakage_past_a_piston_is_the_integral_of_its_flow(machine, audit):
    (leak,), notes = find_leaks(machine, audit, run)
    recording, cycle = audit.recording, audit.cycle
    window = (recording.time >= cycle.start) & (recording.time <= cycle.end)
    flow = np.abs(recording["cylinderA.leakage_mass_flow_rate"][window])
    expected = np.trapezoid(flow, recording.time[window]) / 1.185
    assert (leak.part, leak.flow_path, notes) == ("cylinderA", "cylinderA.leakage_mass_flow_rate", ())
    assert leak.air == pytest.approx(expected, rel=2e-3)
    assert leak.cost_per_year == pytest.approx(leak.air * 0.02 * 1000.0 * 3600.0 / cycle.duration, rel=1e-12)


def test_a_tight_machine_has_no_leaks():
    circuit = poppet.load(EXAMPLES / "two_cylinders.toml")
    assert find_leaks(circuit, run(circuit), run) == ((), ())


def test_the_user_names_leaks_by_part_or_flow_path(machine, audit):
    names = [row.flow_path for row in find_leaks(machine, audit, run, ["valveB", "valveA.exhaust_a"])[0]]
    paths = {f"valveB.{side}_{end}_mass_flow_rate" for side in ("supply", "exhaust") for end in "ab"}
    assert set(names) == paths | {"valveA.exhaust_a_mass_flow_rate", "cylinderA.leakage_mass_flow_rate"}


def test_an_unknown_address_is_rejected_with_the_nearest_names(machine, audit):
    with refused("names.unknown", "valveA.exaust_a") as caught:
        find_leaks(machine, audit, run, ["valveA.exaust_a"])
    assert "valveA.exhaust_a" in caught.value.facts["suggestion"].names


def test_a_valve_that_does_not_close_leaks_its_choked_flow():
    """C p_1 at 20 degC, with 2 % of C = 1 dm^3/(s bar) and 7 bar for a second."""
    circuit = poppet.loads(LEAKY)
    audit = run(circuit, cycle="1 s, 2 s")
    (leak,), _ = find_leaks(circuit, audit, functools.partial(run, cycle="1 s, 2 s"))
    assert (leak.part, leak.flow_path) == ("valve", "valve")
    assert leak.air == pytest.approx(0.02 * 1e-3 * 7.0, rel=1e-6)
    # Flow exergy of ideal air, R T ln(p/p_0); the density of ANR is that of moist air.
    assert leak.exergy == pytest.approx(leak.air * 1.185 * 287.05 * 293.15 * math.log(7.0), rel=1e-3)


def test_a_leak_is_listed_even_if_the_tight_circuit_cannot_be_audited():
    circuit = poppet.loads(LEAKY)
    audit = run(circuit, cycle="1 s, 2 s")
    rows, notes = find_leaks(circuit, audit, run)  # no cycle is stated for the tight circuit
    assert rows == ()
    assert [(note.code, note.address) for note in notes] == [("leaks.no_result", "valve")]


def test_the_leak_of_a_member_belongs_to_its_part():
    circuit = poppet.load(EXAMPLES / "pressure_regulator.toml")
    circuit = circuit.with_values({"valve.main_stage.leak_conductance": "0.05 dm^3/(s bar)"})
    audit = run(poppet.loads(LEAKY), cycle="1 s, 2 s")  # stands for the audit of the circuit
    (leak,), _ = find_leaks(circuit, audit, lambda tight: replace(audit, air={"supply": 0.0}))
    assert (leak.part, leak.flow_path) == ("valve", "valve.main_stage")
