"""Energy audits against independent calculations: tanks, a double stroke by hand, and each row of a machine cycle."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

import poppet
from poppet import Circuit
from poppet.audit.energy import audit_energy
from poppet.audit.energy_result import BalanceRow
from poppet.parts import Chamber, Orifice, Reservoir

sys.path.insert(0, str(Path(__file__).parent))
from hand_double_stroke import AIR_L_ANR, EXERGY_J, PERIOD, circuit_text, double_stroke
from independent_exergy import TERMS, flow_exergy, machine_terms, tank
from independent_exhaust import WARM, simulate, two_cylinders

MACHINE = Path(poppet.__file__).parent / "cli" / "templates" / "machine.toml"


@pytest.mark.parametrize("wall", [0.0, 1.5])
@pytest.mark.parametrize(("start", "supply"), [(7e5, None), (1e5, 8e5)])
def test_rows_of_a_tank(start: float, supply: float | None, wall: float) -> None:
    ends = {"from_": "tank", "to": "ambient"} if supply is None else {"from_": "supply", "to": "tank"}
    parts = {
        "tank": Chamber(volume=5e-3, initial_pressure=start, wall_conductance=wall),
        "path": Orifice(sonic_conductance=2e-8, critical_ratio=0.3, **ends),
    }
    audit = audit_energy(
        Circuit(parts | ({} if supply is None else {"supply": Reservoir(pressure=supply)})),
        duration=4.0,
        cycle="0 s, 4 s",
    )
    expected = tank(5e-3, start, 2e-8, 0.3, wall, 4.0, supply)
    for name in (*TERMS, "stored"):
        scale = abs(expected["stored"])
        assert audit.total(name) == pytest.approx(expected[name], rel=1e-6, abs=1e-7 * scale), name
    assert abs(audit.residual()) < 1e-9 > abs(audit.residual("energy"))


@pytest.mark.parametrize("ambient", [1e5, 101325.0])
def test_the_double_stroke_agrees_with_the_hand_calculation(ambient: float) -> None:
    audit = audit_energy(poppet.loads(circuit_text(ambient)), cycle=f"{0.5 + PERIOD} s, {0.5 + 2.0 * PERIOD} s")
    values = audit.content()["cycle"]
    for key, by_hand, expected in zip(
        ("air_l_anr", "exergy_supplied_j"), double_stroke(ambient), (AIR_L_ANR, EXERGY_J), strict=True
    ):
        assert values[key] == pytest.approx(by_hand, rel=5e-3)
        assert values[key] == pytest.approx(expected, rel=5e-3)
    assert values["duration_s"] == PERIOD
    assert abs(audit.residual()) < 1e-9 > abs(audit.residual("energy"))


def _key_of(row: BalanceRow) -> str:
    """Return the key of a row in the independent calculation."""
    owner = row.name.partition(".")[0]
    if row.name.endswith(".end_stop"):
        return f"stops {owner}"
    if row.name.endswith(".motion"):
        return f"stored motion {owner.removeprefix('slide')}"
    name = row.name.removesuffix("_mass_flow_rate").removesuffix(".friction")
    return f"{row.category} {name}".replace("filter.mass_flow_rate", "supply to bowl")


def test_each_row_of_a_machine_cycle() -> None:
    start, end = 0.2, 1.7
    expected = machine_terms(two_cylinders(), simulate(two_cylinders(), 1.75, rows_per_ms=5), start, end)
    audit = audit_energy(poppet.load(MACHINE), cycle=f"{start} s, {end} s")
    found = {_key_of(row): row.exergy for row in audit.rows if row.category != "integration"}
    supplied = expected["supplied supply"]
    assert found["supplied supply"] == pytest.approx(supplied, rel=1e-5)
    assert set(found) <= set(expected)
    for key, value in expected.items():
        assert found.get(key, 0.0) == pytest.approx(value, abs=1e-5 * supplied), key
    # All air comes from the reservoir at 9 bar.
    assert audit.air_used == pytest.approx(supplied / (1.185 * flow_exergy(9e5, WARM)), rel=1e-5)
