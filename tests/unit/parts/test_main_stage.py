"""The main stage: static map of the paper mode, balance of the regulator mode, seats, stops, contradictions."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

from poppet import Circuit, iso6358, library
from poppet.core.errors import InputErrors
from poppet.parts import Chamber, Contact, Exhaust, MainStage, Reservoir, Spring, Stop
from poppet.parts.part import GasState, Scope, Surroundings
from poppet.signals import Steps
from refusals import refused

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
PORTS = {"supply": "supply", "outlet": "tank", "exhaust": "room"}
CLOSED = -4e-6
"""Stroke of varga2012 at which both seats are closed [m]."""
GAS = {"supply": GasState(7e5, 293.15), "outlet": GasState(2e5, 293.15), "exhaust": GasState(1e5, 293.15)}


def stage(**fields: Any) -> MainStage:
    return MainStage(**PORTS, **{"data": "varga2012", **fields})


def passing(part: MainStage, pilot: float, stroke: float, velocity: float = 0.0) -> Any:
    scope = Scope(part.parameters(AIR), {"stroke": stroke, "velocity": velocity}, {"pilot_pressure": pilot}, AIR)
    return part.flows(scope, GAS)


def force(part: MainStage, pilot: float, stroke: float, velocity: float = 0.0) -> float:
    result = passing(part, pilot, stroke, velocity)
    mass = part.moving_mass if stroke > 0.0 else part.emptying_mass
    return result.rates["velocity"] * float(mass)


def settled(pilot: float, **fields: Any) -> Any:
    """The plate after a second at a pilot pressure, tank and supply held."""
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "room": Reservoir(pressure="1 bar"),
        "valve": stage(pilot_pressure=pilot, **fields),
        "tank": Reservoir(pressure="2 bar"),
    }
    return Circuit(parts).simulate(1.0).last()


@pytest.mark.parametrize(
    ("gauge", "stroke"), [(1.0, 0.138), (2.0, 0.310), (3.0, 0.482), (4.0, 0.655), (5.0, 0.827), (6.0, 0.999)]
)
def test_static_map_of_the_paper_mode(gauge, stroke):
    """Balance of eq. (5): S p_p = k1 (h1 + x) + k2 (h2 + x), with the assumed set A."""
    assert settled(1e5 * (1.0 + gauge))["valve.stroke"] == pytest.approx(stroke * 1e-3, abs=0.6e-6)


def test_eq_5_balances_where_it_should():
    part = stage()
    stroke = (4.909e-4 * 3e5 - 2.55e5 * 2e-5 - 3e4 * 1.57e-4) / (2.55e5 + 3e4)
    assert force(part, 4e5, stroke) == pytest.approx(0.0, abs=1e-9)


def test_damping_and_spring_rate_are_those_of_eq_5():
    part = stage()
    assert force(part, 4e5, 0.4e-3, 0.1) - force(part, 4e5, 0.4e-3) == pytest.approx(-106.0 * 0.1, rel=1e-9)
    slope = (force(part, 4e5, 0.5e-3) - force(part, 4e5, 0.4e-3)) / 1e-4
    assert slope == pytest.approx(-(2.55e5 + 3e4), rel=1e-9)


def test_emptying_leaves_the_lower_spring_out():
    """Eq. (6): k1 (h1 + x) = S p_o below zero."""
    part = stage()
    stroke = -1.2e-5
    known = 4.909e-4 * 0.0 - 2.55e5 * (2e-5 + stroke)
    assert force(part, 1e5, stroke) == pytest.approx(known, rel=1e-6)


def test_rests_at_minus_the_preload_without_pilot_pressure():
    last = settled(1e5)
    assert last["valve.stroke"] == pytest.approx(-20e-6, abs=0.5e-6)
    assert last["valve.contact"] in (-1.0, -2.0)
    assert last["valve.exhaust_mass_flow_rate"] > 0.0
    assert last["valve.supply_mass_flow_rate"] == 0.0


@pytest.mark.parametrize("gauge", [0.12, 0.18])
def test_dead_zone_keeps_both_seats_closed(gauge):
    last = settled(1e5 * (1.0 + gauge))
    assert abs(last["valve.stroke"]) < 5e-6
    assert last["valve.exhaust_mass_flow_rate"] == 0.0
    assert last["valve.supply_mass_flow_rate"] == pytest.approx(0.0, abs=1e-6)


def test_paper_mode_knows_no_outlet_pressure():
    part = stage()
    scope = Scope(part.parameters(AIR), {"stroke": 3e-4, "velocity": 0.0}, {"pilot_pressure": 4e5}, AIR)
    rates = [part.flows(scope, GAS | {"outlet": GasState(p, 293.15)}).rates["velocity"] for p in (1e5, 6e5)]
    assert rates[0] == rates[1]


def test_regulator_mode_feels_the_outlet_pressure():
    """S (p2 difference), less the unbalanced seat area that p2 relieves."""
    part = stage(mode="regulator", seat_balance=1.0)
    scope = Scope(part.parameters(AIR), {"stroke": 3e-4, "velocity": 0.0}, {"pilot_pressure": 4e5}, AIR)
    forces = [part.flows(scope, GAS | {"outlet": GasState(p, 293.15)}).rates["velocity"] * 0.020 for p in (1e5, 2e5)]
    assert forces[1] - forces[0] == pytest.approx(-(7.07e-4 - 3.3e-5) * 1e5, rel=1e-9)


@pytest.mark.parametrize(("seat_balance", "end"), [(0.0, 5.20e5), (1.0, 5.11e5)])
def test_regulator_settles_where_pilot_and_outlet_balance(seat_balance, end):
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "room": Reservoir(pressure="1 bar"),
        "valve": stage(mode="regulator", seat_balance=seat_balance, pilot_pressure="4.4 bar g"),
        "tank": Chamber(volume="0.02 m^3", thermal="polytropic", polytropic_exponent=1.04),
    }
    assert Circuit(parts).simulate(60.0).last()["tank.pressure"] == pytest.approx(end, abs=0.015e5)


def test_supply_flow_follows_the_closed_characteristic():
    part, curve = stage(), library.characteristic("varga2012.closed")
    for stroke in (0.01e-3, 0.3e-3, 0.9e-3):
        known = iso6358.mass_flow_rate(
            7e5,
            2e5,
            293.15,
            sonic_conductance=curve.sonic_conductance_at(stroke),
            critical_ratio=curve.critical_ratio_at(stroke),
        )
        assert passing(part, 4e5, stroke).outputs["supply_mass_flow_rate"][0] == pytest.approx(known, rel=1e-12)
    assert passing(part, 4e5, -1e-6).outputs["supply_mass_flow_rate"][0] == 0.0


def test_printed_characteristic_is_taken_as_it_is():
    part = stage(characteristic="varga2012.printed")
    assert passing(part, 1e5, 0.0).outputs["supply_mass_flow_rate"][0] == pytest.approx(
        iso6358.mass_flow_rate(7e5, 2e5, 293.15, sonic_conductance=5.0034e-9, critical_ratio=0.71748), rel=1e-12
    )


def test_exhaust_opens_below_the_overlap():
    part = stage()
    overlap, opening = float(part.overlap), float(part.exhaust_seat.opening)
    flows = [
        passing(part, 1e5, -overlap - x).outputs["exhaust_mass_flow_rate"][0] for x in (0.0, 0.5 * opening, opening)
    ]
    full = iso6358.mass_flow_rate(2e5, 1e5, 293.15, sonic_conductance=0.93e-8, critical_ratio=0.35)
    assert flows == pytest.approx([0.0, 0.5 * full, full], rel=1e-12)


@pytest.mark.parametrize(("stroke", "code"), [(2e-4, 1.0), (-2e-6, 0.0), (-1e-5, -1.0), (1.2e-3, 2.0), (-1e-3, -2.0)])
def test_contact_code(stroke, code):
    assert passing(stage(), 1e5, stroke).outputs["contact"][0] == code


def test_stops_hold_the_plate():
    assert settled(20e5)["valve.stroke"] == pytest.approx(float(stage().upper_stop.position), abs=30e-6)


def test_friction_opposes_the_motion_and_changes_the_structure():
    plain, rough = stage(), stage(friction={"coulomb": "5 N", "viscous": "20 N s/m"})
    for velocity in (-0.5, 0.5):
        more = force(rough, 4e5, 4e-4, velocity) - force(plain, 4e5, 4e-4, velocity)
        assert more == pytest.approx(-np.sign(velocity) * (5.0 + 20.0 * 0.5), rel=1e-6)
    assert rough.structure() != plain.structure()
    assert rough.parameters(AIR)["friction.static"] == 5.0


def test_pilot_pressure_defaults_to_the_ambient():
    assert stage().parameters(dataclasses.replace(AIR, pressure=9e4))["pilot_pressure"] == 9e4


def test_pilot_signal_moves_the_plate():
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "room": Reservoir(pressure="1 bar"),
        "valve": stage(),
        "tank": Chamber(volume="0.2 m^3"),
    }
    recording = Circuit(parts, {"valve.pilot_pressure": Steps([0.0, 1.0], [1e5, 4e5])}).simulate(2.0, 0.1)
    assert recording["valve.stroke"][9] < 0.0 < recording["valve.stroke"][-1]
    assert {name for name in recording if name.startswith("valve.")} >= {
        "valve.stroke",
        "valve.velocity",
        "valve.supply_mass_flow_rate",
        "valve.exhaust_mass_flow_rate",
    }


def own_valve(**fields: Any) -> MainStage:
    """Every number given, no library."""
    given: dict[str, Any] = {
        "plate_area": "5 cm^2",
        "moving_mass": "20 g",
        "emptying_mass": "12 g",
        "damping": "50 N s/m",
        "upper_spring": Spring("20 N/mm", "0.1 mm"),
        "lower_spring": {"rate": "5 N/mm", "preload": "1 mm"},
        "overlap": "5 um",
        "exhaust_seat": Exhaust("1e-8 m^3/(s Pa)", 0.3, "10 um"),
        "upper_stop": Stop("1 mm", 1e9, 10.0),
        "lower_stop": Stop("-0.1 mm", 1e9, 10.0),
        "contact": Contact("1 um", 10.0),
        "characteristic": "varga2012.closed",
    }
    return MainStage(**PORTS, **(given | fields))


def test_a_valve_of_ones_own():
    part = own_valve()
    assert part.parameters(AIR)["lower_spring.preload"] == 1e-3
    assert {
        number.source.kind for name, number in part.numbers().items() if not name.startswith("characteristic.")
    } <= {"given", "assumed", "paper"}


@pytest.mark.parametrize(
    ("fields", "match"),
    [
        ({"data": "varga2021"}, "library.unknown"),
        ({"mode": "papr"}, "fields.not_an_option"),
        ({"lower_spring": {"rat": 1.0}}, "fields.unknown"),
        ({"lower_spring": {"rate": "3 m"}}, "quantity.other_quantity"),
        ({"lower_spring": 5.0}, "fields.not_a_table"),
        ({"exhaust_seat": {"critical_ratio": 1.0}}, "fields.out_of_range"),
        ({"lower_stop": {"position": "2 mm"}}, "parts.stops_exchanged"),
        ({"seat_balance": 1.5}, "fields.out_of_range"),
        ({"pilot_pressure": "-2 bar"}, "quantity.pressure_below_zero"),
    ],
)
def test_contradictions(fields, match):
    with refused(match):
        stage(**fields)


def test_without_data_everything_missing_is_named_at_once():
    with pytest.raises(InputErrors) as caught:
        MainStage(**PORTS)
    missing = {problem.address for problem in caught.value.problems}
    assert {"plate_area", "moving_mass", "damping", "upper_spring.rate", "contact.width", "overlap"} <= missing


def test_without_data_the_characteristic_is_missing():
    with refused("parts.no_characteristic", "characteristic"):
        own_valve(characteristic=None)


def test_assumed_numbers_are_shown_as_such():
    numbers = stage().numbers()
    assert numbers["plate_area"].source.kind == "assumed"
    assert numbers["characteristic.sonic_conductance.k1"].source.kind == "paper"


@pytest.mark.parametrize("fields", [{}, {"exhaust_leak_conductance": "0.002 dm^3/(s bar)"}])
def test_leaks_of_closed_seats_follow_iso_6358(fields):
    part = stage(leak_conductance="0.001 dm^3/(s bar)", **fields)
    ratio, conductance = part.curve.critical_ratio_at(CLOSED, part.curve.parameters()), 1e-11
    outputs = passing(part, 1e5, CLOSED).outputs
    closed = passing(stage(), 1e5, CLOSED).outputs
    supply = iso6358.mass_flow_rate(7e5, 2e5, 293.15, sonic_conductance=conductance, critical_ratio=ratio)
    ratio = float(part.exhaust_seat.critical_ratio)
    conductance = 2e-11 if fields else 1e-11  # 0.002 and 0.001 dm^3/(s bar)
    exhaust = iso6358.mass_flow_rate(2e5, 1e5, 293.15, sonic_conductance=conductance, critical_ratio=ratio)
    assert outputs["supply_mass_flow_rate"][0] == pytest.approx(supply, rel=1e-12)
    assert outputs["exhaust_mass_flow_rate"][0] == pytest.approx(exhaust, rel=1e-12)
    assert closed["supply_mass_flow_rate"][0] == closed["exhaust_mass_flow_rate"][0] == 0.0


def test_a_leak_is_parallel_to_an_open_seat():
    open_flow, with_leak = (
        passing(stage(leak_conductance=leak), 1e5, 5e-4).outputs["supply_mass_flow_rate"][0] for leak in (0.0, 1e-11)
    )
    density = 1.185  # of the reference atmosphere
    assert with_leak - open_flow == pytest.approx(1e-11 * 7e5 * density, rel=2e-3)


def test_a_tank_at_a_leaking_valve_settles_between_supply_and_exhaust():
    """Both leaks choked: C p_1 = C_x p_2 gives the ratio of the pressures."""
    parts = {
        "supply": Reservoir(pressure="8 bar"), "room": Reservoir(pressure="0.2 bar"),
        "valve": stage(leak_conductance=2e-11, exhaust_leak_conductance=8e-11, pilot_pressure="0.09 bar g"),
        "tank": Chamber(volume="10 cm^3", thermal="isothermal"),
    }  # fmt: skip
    recording = Circuit(parts).simulate(200.0)
    assert recording["valve.contact"][-1] == 0.0
    assert recording["tank.pressure"][-1] == pytest.approx(2e5, rel=1e-6)
