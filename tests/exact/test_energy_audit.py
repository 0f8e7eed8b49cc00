"""Energy audit against closed forms, independent quadrature of tanks, and a double stroke calculated by hand."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import pytest

import poppet
from poppet import Chamber, Circuit, Cylinder, Guide, Mass, Orifice, Reservoir
from poppet.audit.energy import audit_energy
from poppet.audit.energy_result import CATEGORIES, EnergyAudit
from poppet.signals import Points

sys.path.insert(0, str(Path(__file__).parent))
from hand_double_stroke import AIR_L_ANR, EXERGY_J, PERIOD, circuit_text, double_stroke
from independent_exergy import AMBIENT, GAS, WARM, adiabatic_discharge, tank

VOLUME, C, B = 5e-3, 2e-8, 0.3
TIGHT = {"relative_tolerance": 1e-10}


def tank_audit(start: float, wall: float, supply: float | None, duration: float, **options: str) -> EnergyAudit:
    """Audit a tank that empties to the ambient, or fills from a supply."""
    vessel = Chamber(volume=VOLUME, initial_pressure=start, wall_conductance=wall, **options)
    parts = {"tank": vessel}
    if supply is not None:
        parts["supply"] = Reservoir(pressure=supply)
    ends = {"from_": "tank", "to": "ambient"} if supply is None else {"from_": "supply", "to": "tank"}
    parts["path"] = Orifice(sonic_conductance=C, critical_ratio=B, **ends)
    circuit = Circuit(parts, run=poppet.Run(duration=duration, **TIGHT))
    return audit_energy(circuit, cycle=f"0 s, {duration} s")


@pytest.mark.parametrize(
    ("start", "wall", "supply"), [(7e5, 0.0, None), (7e5, 1.5, None), (1e5, 0.0, 8e5), (1e5, 1.5, 8e5)]
)
def test_a_tank_has_the_terms_of_an_independent_quadrature(start: float, wall: float, supply: float | None) -> None:
    audit, expected = tank_audit(start, wall, supply, 1.5), tank(VOLUME, start, C, B, wall, 1.5, supply)
    scale = abs(expected["stored"])
    for category in ("supplied", "throttling", "exhausted", "mixing", "heat", "stored"):
        assert audit.total(category) == pytest.approx(expected[category], rel=1e-6, abs=1e-6 * scale), category
    assert abs(audit.residual()) < 1e-12
    assert abs(audit.residual("energy")) < 1e-12


def test_an_adiabatic_discharge_has_the_closed_form() -> None:
    audit = tank_audit(7e5, 0.0, None, 0.5)
    masses = audit.recording["tank.mass"]
    closed = adiabatic_discharge(VOLUME, 7e5, float(masses[-1] / masses[0]))
    for category, value in closed.items():
        assert audit.total(category) == pytest.approx(value, rel=1e-7), category


def test_an_isothermal_discharge_loses_the_exergy_of_its_pressure() -> None:
    r"""The gas of a mass m at T_a has the exergy m R T_a [ln(p/p_a) - 1] + p_a V, and its exhaust none."""
    audit = tank_audit(7e5, 0.0, None, 0.5, thermal="isothermal")
    pressure = float(audit.recording["tank.pressure"][-1])

    def stored(p: float) -> float:
        return p * VOLUME * (math.log(p / AMBIENT) - 1.0) + AMBIENT * VOLUME

    assert audit.total("stored") == pytest.approx(stored(pressure) - stored(7e5), rel=1e-9)
    assert audit.total("throttling") == pytest.approx(stored(7e5) - stored(pressure), rel=1e-7)
    for category in ("heat", "exhausted", "mixing"):
        assert abs(audit.total(category)) < 1e-12 * stored(7e5)
    # The wall delivers the enthalpy that the air takes with it, minus its internal energy.
    heat = GAS * WARM * (7e5 - pressure) * VOLUME / (GAS * WARM)
    assert audit.total("heat", quantity="energy") == pytest.approx(-heat, rel=1e-7)
    assert [note.code for note in audit.notes if note.address == "tank"] == ["energy.implied_heat"]


def test_an_isothermal_compression_by_a_guide_stores_its_work() -> None:
    """A piston compresses gas slowly, with a wall that keeps it at ambient temperature."""
    area, stroke, dead = 1e-3, 0.1, 2e-5
    side = {"dead_volume": dead, "wall_conductance": 1e3}
    cylinder = Cylinder(
        body="guide", bore=math.sqrt(4.0 * area / math.pi), stroke_length=stroke, cap=side, acting="single"
    )
    guide = Guide(position=stroke)
    signals = {"guide.position": Points([0.0, 10.0], [stroke, 0.5 * stroke])}
    circuit = Circuit({"guide": guide, "cylinder": cylinder}, signals, run=poppet.Run(duration=10.0, **TIGHT))
    audit = audit_energy(circuit, cycle="0 s, 10 s")
    first, last = dead + area * stroke, dead + 0.5 * area * stroke
    work = AMBIENT * first * math.log(first / last) - AMBIENT * (first - last)
    assert audit.work == pytest.approx(-work, rel=1e-4)
    assert audit.total("stored") == pytest.approx(work, rel=1e-4)


def test_the_work_of_a_cylinder_is_that_on_its_load_and_weight() -> None:
    """The terms of a vertical cylinder: load force, weight, viscous friction and kinetic energy."""
    parts = {
        "supply": Reservoir(pressure="6 bar g"),
        "fill": Orifice(from_="supply", to="cylinder.cap", sonic_conductance=1e-8, critical_ratio=0.3),
        "cylinder": Cylinder(
            body="slide", bore="32 mm", stroke_length="1 m", cap={"dead_volume": "10 cm^3"}, acting="single"
        ),
        "slide": Mass(mass=5.0, inclination="90 deg", load_force=100.0, friction={"viscous_coefficient": 40.0}),
    }  # fmt: skip
    audit = audit_energy(Circuit(parts, run=poppet.Run(duration=0.5, output_step=1e-5, **TIGHT)), cycle="0 s, 0.5 s")
    position, velocity = audit.recording["slide.position"], audit.recording["slide.velocity"]
    rows = {row.name: row.exergy for row in audit.rows}
    assert rows["slide.load"] == pytest.approx(100.0 * (position[-1] - position[0]), rel=1e-9)
    assert rows["slide.weight"] == pytest.approx(5.0 * 9.80665 * (position[-1] - position[0]), rel=1e-9)
    assert rows["slide.motion"] == pytest.approx(2.5 * velocity[-1] ** 2, rel=1e-9)
    # The trapezoidal rule over rows, which are 10 us apart.
    lost = 40.0 * float((0.5 * (velocity[1:] ** 2 + velocity[:-1] ** 2)).sum()) * 1e-5
    assert rows["slide.friction"] == pytest.approx(lost, rel=1e-6)


@pytest.mark.parametrize("ambient", [1e5, 101325.0])
def test_a_double_stroke_has_the_air_and_exergy_of_the_hand_calculation(ambient: float) -> None:
    circuit = poppet.loads(circuit_text(ambient))
    audit = audit_energy(circuit, cycle=f"0.4 s, {0.4 + PERIOD} s")
    air, exergy = double_stroke(ambient)
    assert 1e3 * audit.air_used == pytest.approx(air, rel=5e-3)
    assert 1e3 * audit.air_used == pytest.approx(AIR_L_ANR, rel=5e-3)
    assert audit.exergy_supplied == pytest.approx(exergy, rel=5e-3)
    assert audit.exergy_supplied == pytest.approx(EXERGY_J, rel=5e-3)
    assert abs(audit.residual()) < 1e-9
    assert abs(audit.residual("energy")) < 1e-9
    assert {row.part: row.air for row in audit.parts}["cylinder"] == pytest.approx(audit.air_used, rel=1e-9)


def test_the_rows_of_two_periods_add_up() -> None:
    """The rows of two successive parts of a run add up to those of the whole run."""
    circuit = poppet.loads(circuit_text())
    whole = audit_energy(circuit, cycle="0 s, 6 s")
    parts = [audit_energy(circuit, cycle=cycle) for cycle in ("0 s, 0.73 s", "0.73 s, 6 s")]
    for category in CATEGORIES[:-1]:
        total = sum(audit.total(category) for audit in parts)
        assert total == pytest.approx(whole.total(category), rel=1e-6, abs=1e-6), category
