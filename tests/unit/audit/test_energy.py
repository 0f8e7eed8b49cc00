"""Energy audits: air of parts, categories of rows, files and the command."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

import poppet
from poppet.audit.energy import audit_energy
from poppet.audit.energy_result import CATEGORIES, EnergyAudit
from poppet.audit.energy_run import run_energy
from poppet.engine.lru_cache import LruCache
from poppet.parts.cylinder import Piston

NOZZLE = """
[parts.nozzle]
kind = "orifice"
from = "rail"
to = "ambient"
sonic_conductance = "0.2 dm^3/(s bar)"
critical_ratio = 0.3
"""
MACHINE = """
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"
[parts.inlet]
kind = "orifice"
from = "supply"
to = "rail"
sonic_conductance = "8 dm^3/(s bar)"
critical_ratio = 0.3
[parts.rail]
kind = "chamber"
volume = "1 l"
initial_pressure = "6 bar g"
[parts.valve]
kind = "directional_valve"
supply = "rail"
outlet = "hose.1"
exhaust = "damper"
sonic_conductance = "2 dm^3/(s bar)"
critical_ratio = 0.3
[parts.hose]
kind = "tube"
from = "tank"
length = "1 m"
bore = "4 mm"
cells = 2
[parts.tank]
kind = "chamber"
volume = "0.2 l"
[parts.damper]
kind = "chamber"
volume = "10 cm^3"
[parts.silencer]
kind = "orifice"
from = "damper"
to = "ambient"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
[signals."valve.command"]
kind = "square"
low = 0
high = 1
frequency = "1 Hz"
[run]
duration = "4 s"
"""


def audit(text: str = MACHINE, **options) -> EnergyAudit:
    return audit_energy(poppet.loads(text), **options)


def test_the_consumer_of_air_is_the_volume_that_is_emptied():
    """Neither the rail, from which the air comes, nor the damper through which it leaves."""
    result = audit()
    air = {row.part: row.air for row in result.parts}
    volumes = {"tank": 0.2e-3, "hose": 0.25 * 3.14159265 * 4e-3**2}
    assert air["tank"] + air["hose"] == pytest.approx(result.air_used, rel=3e-3)
    assert air["hose"] / air["tank"] == pytest.approx(volumes["hose"] / volumes["tank"], rel=0.2)
    assert abs(air["damper"]) + abs(air["rail"]) < 3e-3 * result.air_used
    assert sum(air.values()) == pytest.approx(result.air_used, rel=1e-9)


def test_air_that_passes_a_volume_is_that_of_its_nozzle():
    without, result = audit(), audit(MACHINE + NOZZLE)
    air = {row.part: row.air for row in result.parts}
    (path,) = [path for path in result.flow_paths if path.part == "nozzle"]
    assert air["nozzle"] == pytest.approx(path.air, rel=2e-2)
    assert air["tank"] + air["hose"] == pytest.approx(without.air_used, rel=2e-2)


def test_a_cycle_can_start_at_an_edge_with_a_rounding_error():
    """5 / 3 s as a multiple of the period and as a sum of edges differ in their last digit."""
    pwm = 'kind = "pwm"\nduty = 0.3\nfrequency = "3 Hz"'
    text = MACHINE.replace('kind = "square"\nlow = 0\nhigh = 1\nfrequency = "1 Hz"', pwm).replace('"4 s"', '"2 s"')
    result = audit(text)
    assert (result.cycle.start, result.cycle.end) == pytest.approx((5.0 / 3.0, 2.0), rel=1e-12)
    assert abs(result.residual()) < 1e-12


DOUBLE_STROKE = Path(__file__).parents[3] / "examples" / "double_stroke.toml"
SILENCER_VOLUME = """
[parts.damper]
kind = "chamber"
volume = "20 cm^3"
[parts.silencer]
kind = "silencer"
from = "damper"
to = "ambient"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
"""


def test_air_past_a_piston_is_that_of_the_cylinder():
    """Both chambers exchange air through the leak, but they are not one volume through which the valve blows."""
    text = DOUBLE_STROKE.read_text(encoding="utf-8")
    leakage = 'body = "slide"\nleakage = { sonic_conductance = "0.005 dm^3/(s bar)" }'
    result = audit(text.replace('body = "slide"', leakage), cycle="8 s, 16 s")
    air = {row.part: row.air for row in result.parts}
    lines = 2.0 * 12.6e-6 * 6.0  # 6 bar above ambient
    assert air["cylinder"] == pytest.approx(result.air_used - lines, rel=0.01)
    assert abs(air.get("valve", 0.0)) < 1e-3 * result.air_used


def test_a_leak_into_a_silencer_volume_is_that_of_the_valve():
    text = DOUBLE_STROKE.read_text(encoding="utf-8") + SILENCER_VOLUME
    text = text.replace("[parts.valve]", '[parts.valve]\nexhaust_a = "damper"\nexhaust_b = "damper"')
    faulty = text.replace("[parts.valve]", '[parts.valve]\nfault = "leak"\nleak_fraction = 0.01')
    healthy, leaking = (audit(each, cycle="8 s, 16 s") for each in (text, faulty))
    air = {row.part: row.air for row in leaking.parts}
    assert air["valve"] == pytest.approx(leaking.air_used - healthy.air_used, rel=0.01)


def test_rows_have_a_part_and_a_category():
    result = audit()
    assert {row.category for row in result.rows} <= set(CATEGORIES)
    assert {row.part for row in result.rows} <= {*poppet.loads(MACHINE).parts, ""}
    throttling = {path.name: path.throttling for path in result.flow_paths}
    assert sum(throttling.values()) == pytest.approx(result.total("throttling"), rel=1e-12)


def test_a_vacuum_reservoir_supplies_exergy():
    """Air from the ambient into a vacuum: the exergy R T_a ln(p_a/p) per mass is lost in the orifice."""
    text = """
[parts.pump]
kind = "reservoir"
pressure = "0.5 bar"
[parts.leak]
kind = "orifice"
from = "ambient"
to = "pump"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
[run]
duration = "1 s"
"""
    result = audit(text, cycle="0 s, 1 s")
    assert result.exergy_supplied == pytest.approx(result.total("throttling"), rel=1e-12)
    assert result.exergy_supplied > 0.0
    assert result.air_used == 0.0  # a vacuum supplies no air


def test_a_compressor_has_a_note():
    text = """
[parts.compressor]
kind = "compressor"
outlet = "tank"
free_air_delivery = "100 l/min ANR"
start_pressure = "6 bar g"
stop_pressure = "8 bar g"
[parts.tank]
kind = "chamber"
volume = "10 l"
[run]
duration = "5 s"
"""
    result = audit(text, cycle="1 s, 5 s")
    assert [note.address for note in result.notes if note.code == "energy.compressor"] == ["compressor"]
    assert result.air["compressor"] == pytest.approx(100e-3 / 60.0 * 4.0, rel=1e-6)
    assert result.exergy_supplied > 0.0


def test_the_run_of_an_audit_has_the_states_of_a_simulation():
    circuit = poppet.loads(MACHINE)
    run = run_energy(circuit, circuit.run, (1.0, 3.0))
    names = [state.name for state in run.energy.model.states]
    recording = circuit.simulate(3.0, relative_tolerance=1e-8)
    for name in names:
        values = run.values[run.energy.states[names.index(name)]]
        assert values[-1] == pytest.approx(recording[name][-1], rel=1e-4), name


CYLINDER = """
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"
[parts.fill]
kind = "orifice"
from = "supply"
to = "cylinder.cap"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
[parts.cylinder]
kind = "cylinder"
acting = "single"
body = "slide"
bore = "32 mm"
stroke_length = "20 mm"
cap = { dead_volume = "5 cm^3" }
spring = { rate = "2 N/mm", preload = "5 mm" }
[parts.slide]
kind = "mass"
mass = "1 kg"
[run]
duration = "0.2 s"
"""


def test_an_undeclared_loss_is_reported(monkeypatch):
    """The impact on the cover is a loss of the piston. A part that does not declare its loss leaves a residual."""
    assert abs(audit(CYLINDER, cycle="0 s, 0.2 s").residual()) < 1e-12
    original = Piston.actuator_force
    monkeypatch.setattr(Piston, "actuator_force", lambda *arguments: replace(original(*arguments), losses={}))
    monkeypatch.setattr("poppet.audit.energy_run._KERNELS", LruCache(1))
    result = audit(CYLINDER, cycle="0 s, 0.2 s")
    assert [note.code for note in result.notes][-1] == "energy.not_closed"


def test_a_spring_stores_its_energy():
    result = audit(CYLINDER, cycle="0 s, 0.2 s")
    rows = {row.name: row.exergy for row in result.rows}
    positions = result.recording["cylinder.piston_position"][[0, -1]] + 5e-3
    assert rows["cylinder.piston.spring"] == pytest.approx(1e3 * float(positions[1] ** 2 - positions[0] ** 2), rel=1e-9)


def test_inaccurate_integrals_are_reported():
    circuit = poppet.loads(CYLINDER)
    rough = replace(circuit, run=circuit.run.changed(relative_tolerance=0.05))
    assert "energy.inaccurate" in [note.code for note in audit_energy(rough, cycle="0 s, 0.2 s").notes]


def test_unknown_work_on_a_pilot_volume_is_named():
    text = """
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"
[parts.pilot]
kind = "pilot_stage"
data = "vppm_6l"
thermal = "polytropic"
supply = "supply"
exhaust = "ambient"
[signals."pilot.displacement"]
kind = "sine"
mean = "0 cm^3"
amplitude = "0.1 cm^3"
frequency = "2 Hz"
[signals."pilot.fill_duty"]
kind = "square"
low = 0
high = 1
frequency = "1 Hz"
[run]
duration = "2 s"
"""
    notes = {note.code: note.address for note in audit(text).notes}
    assert notes["energy.unknown_work"] == notes["energy.implied_heat"] == "pilot"
