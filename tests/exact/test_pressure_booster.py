"""Pressure booster: stall pressure, an independent simulation, delivered mass, balances and exergy."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest

from exact.independent_machines import boost
from poppet import Chamber, Circuit, InputErrors, Orifice, PressureBooster, Reservoir
from refusals import refused

PATH = {"sonic_conductance": 2e-8, "critical_ratio": 0.3}
BORE, STROKE = 0.04, 0.04
AREA = 0.25 * math.pi * BORE**2


def booster(**fields: Any) -> PressureBooster:
    common = {"supply": "rail", "outlet": "tank", "pressure_ratio": 2.0, "bore": BORE, "stroke_length": STROKE}
    return PressureBooster(**{**common, "piston": {"mass": 0.5}, "valve": PATH, "checks": PATH, **fields})


def driven(volume: float = 2e-3, pressure: float = 6e5, tank: Any = None, **fields: Any) -> Circuit:
    parts = {
        "rail": Reservoir(pressure=pressure),
        "booster": booster(**fields),
        "tank": Chamber(volume=volume, **(tank or {})),
    }
    return Circuit(parts)


@pytest.mark.parametrize(("ratio", "bore"), [(2.0, 0.04), (1.5, 0.04), (4.0, 0.03)])
def test_the_outlet_stalls_at_the_pressure_ratio(ratio, bore):
    """In gauge pressures p_2 = r p_1; from below, because the pistons are slow near the stall."""
    circuit = driven(
        1e-3, pressure_ratio=ratio, bore=bore, piston={"mass": 0.5, "friction": {"viscous_coefficient": 20.0}}
    )
    last = circuit.simulate(60.0).last()
    assert last["tank.pressure"] - 1e5 == pytest.approx(ratio * 5e5, rel=1e-3)
    assert abs(last["booster.piston.velocity"]) < 1e-4
    assert abs(last["booster.force"]) < 1.0


def test_a_regulated_drive_limits_the_outlet():
    """p_2 = p_1 + (r - 1) p_d."""
    piston = {"mass": 0.5, "friction": {"viscous_coefficient": 20.0}}
    parts = {
        "rail": Reservoir(pressure=6e5), "low": Reservoir(pressure=3e5), "tank": Chamber(volume=1e-3),
        "booster": booster(drive_supply="low", piston=piston),
    }  # fmt: skip
    assert Circuit(parts).simulate(60.0).last()["tank.pressure"] - 1e5 == pytest.approx(5e5 + 2e5, rel=1e-3)


def test_friction_reduces_the_stall_pressure():
    friction = {"kind": "lugre", "coulomb_force": 50.0}
    last = driven(1e-3, piston={"mass": 0.5, "friction": friction}).simulate(60.0).last()
    assert last["tank.pressure"] - 1e5 == pytest.approx(2.0 * 5e5 - 50.0 / AREA, rel=2e-3)


def test_outlet_and_reversals_agree_with_an_independent_simulation():
    law = {
        "A": AREA, "B": AREA, "L": STROKE, "f": 0.1, "m": 0.5, "d": 100.0, "k": 1e8, "dissipation": 5.0, "p": 6e5,
        "V": 1e-3, "C": 1e-8, "b": 0.3, "T": 0.01, "trip": 0.05 * STROKE,
    }  # fmt: skip
    times, outlet, reversals = boost(law, 1.5, 0.005)
    path = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}
    piston = {"mass": 0.5, "friction": {"viscous_coefficient": 100.0}}
    recording = driven(1e-3, piston=piston, valve=path, checks=path).simulate(1.5, 0.005, 1e-7)
    pressure = np.interp(times, recording.time, recording["tank.pressure"])
    assert outlet.max() > 8e5  # above the supply
    assert np.abs(pressure - outlet).max() < 1e-3 * outlet.max()
    position = recording["booster.valve_position"] - 0.5
    assert abs(np.count_nonzero(np.diff(np.sign(position))) - reversals.size) <= 1
    assert reversals.size > 15


def test_delivered_mass_per_stroke_at_a_constant_outlet_pressure():
    """With isothermal chambers, a stroke delivers the swept mass minus the expansion of the dead volume."""
    warm = {"wall_conductance": 1e4}
    chambers = dict.fromkeys(("drive_a", "drive_b", "boost_a", "boost_b"), warm)
    small, wide = ({"sonic_conductance": c, "critical_ratio": 0.3} for c in (2e-9, 2e-7))
    parts = {
        "rail": Reservoir(pressure=6e5), "tank": Reservoir(pressure=8e5),
        "booster": booster(valve=small, checks=wide, dead_fraction=0.05, **chambers),
    }  # fmt: skip
    recording = Circuit(parts).simulate(20.0, 0.002, 1e-7)
    position = recording["booster.piston.position"]
    # Between two passages of the middle in the same direction.
    rows = np.flatnonzero((position[:-1] < STROKE / 2) & (position[1:] >= STROKE / 2))[2:]
    delivered = np.concatenate([[0.0], np.cumsum(recording["booster.outlet_mass_flow_rate"][1:] * 0.002)])
    each = (delivered[rows[-1]] - delivered[rows[0]]) / (2 * (rows.size - 1))
    swept = np.mean([np.ptp(position[a:b]) for a, b in itertools.pairwise(rows)])
    # The compressed dead volume remains in the chamber and expands to the supply pressure.
    left = 0.05 * STROKE + (STROKE - swept) / 2.0
    expected = AREA * ((left + swept) * 6e5 - left * 8e5) / (287.05 * 293.15)
    assert rows.size > 4
    assert each == pytest.approx(expected, rel=0.02)


def test_balances_and_exergy():
    circuit = driven(1e-3, piston={"mass": 0.5, "friction": {"kind": "lugre", "coulomb_force": 10.0}})
    circuit = Circuit(
        {**circuit.parts, "tool": Orifice(from_="tank", to="ambient", sonic_conductance=2e-9, critical_ratio=0.3)}
    )
    recording = circuit.simulate(3.0, 1e-3)
    assert [residual for residual in recording.residuals if not residual.is_kept] == []
    assert {residual.quantity for residual in recording.residuals} == {"mass", "energy", "motion"}
    figures = recording.figures
    assert len(figures.strokes) > 20
    assert 0.0 < figures.stored < figures.exergy
    consumption = recording["booster.intake_mass_flow_rate"] + recording["booster.supply_a_mass_flow_rate"]
    consumption = consumption + recording["booster.supply_b_mass_flow_rate"]
    assert np.abs(consumption - recording["rail.mass_flow_rate"]).max() < 1e-12


def test_total_entropy_of_a_closed_booster_rises():
    """Supply, exhaust and outlet are adiabatic tanks: no step of the run reduces the entropy."""
    parts = {
        "rail": Chamber(volume=5e-3, initial_pressure=7e5), "tank": Chamber(volume=1e-3), "out": Chamber(volume=5e-3),
        "booster": booster(exhaust="out"),
    }  # fmt: skip
    recording = Circuit(parts).simulate(4.0, 0.01, 1e-7)
    total = np.zeros(recording.time.size)
    names = ["rail", "tank", "out", *(f"booster.{side}" for side in ("drive_a", "drive_b", "boost_a", "boost_b"))]
    for name in names:
        mass, temperature, pressure = (recording[f"{name}.{key}"] for key in ("mass", "temperature", "pressure"))
        total += mass * (1004.675 * np.log(temperature / 293.15) - 287.05 * np.log(pressure / 1e5))
    assert np.diff(total).min() > -1e-6 * np.ptp(total)
    assert recording["tank.pressure"][-1] > recording["rail.pressure"][-1]


def test_a_stalled_booster_takes_large_steps():
    circuit = driven(1e-4, piston={"mass": 0.5, "friction": {"kind": "lugre", "coulomb_force": 20.0}})
    short, long = (circuit.simulate(duration).statistics["accepted_steps"] for duration in (30.0, 3000.0))
    assert long < short + 100


def test_a_run_continues_another_run():
    circuit = driven()
    first = circuit.simulate(0.5)
    again = circuit.resumed(first).simulate(0.01)
    for name in ("piston.position", "piston.velocity", "valve_position", "boost_a.pressure", "drive_b.temperature"):
        assert again[f"booster.{name}"][0] == pytest.approx(first[f"booster.{name}"][-1], rel=1e-9, abs=1e-12)


def test_sizes_of_the_members():
    circuit = driven(pressure_ratio=4.0, dead_fraction=0.2)
    values = circuit.parameters
    assert values["booster.drive_a.outer_diameter"] == pytest.approx(BORE * math.sqrt(3.0))
    assert values["booster.boost_b.dead_volume"] == pytest.approx(0.2 * AREA * STROKE)
    assert values["booster.drive_b.dead_volume"] == pytest.approx(0.6 * AREA * STROKE)
    assert values["booster.valve.trip_distance"] == pytest.approx(0.002)
    changed = circuit.with_values({"booster.stroke_length": "60 mm", "booster.trip_distance": "5 mm"})
    assert changed.parameters["booster.piston.upper_stop.position"] == 0.06
    assert changed.parameters["booster.valve.trip_distance"] == 0.005


def test_invalid_boosters_are_rejected():
    with refused("compounds.trip_distance", "trip_distance"):
        booster(trip_distance="20 mm")
    with refused("fields.out_of_range", "pressure_ratio"):
        booster(pressure_ratio=1.0)
    with refused("fields.not_a_table", "end_stop"):
        booster(end_stop="stiff")
    with refused("bodies.beyond_stop", "piston.initial_position"):
        booster(piston={"mass": 1.0, "initial_position": "50 mm"})
    with pytest.raises(InputErrors) as caught:
        PressureBooster()
    addresses = {problem.address for problem in caught.value.problems}
    assert addresses == {
        "supply", "outlet", "pressure_ratio", "bore", "stroke_length", "piston.mass", "checks.sonic_conductance"
    }  # fmt: skip
