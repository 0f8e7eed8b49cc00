"""Openings undo the law of the pressure's rate, for floats and symbols alike."""

from __future__ import annotations

import sys
from pathlib import Path

import casadi as ca
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet import iso6358
from poppet.laws.physics.pressure_rates import open_rates, openings_for_rate, pressure_rate

sys.path.insert(0, str(Path(__file__).parent))
from repeated_laws import law

pressures = st.floats(0.2e5, 12e5)
ratios = st.floats(0.05, 0.6)
sizes = st.floats(1e-10, 1e-7)
VESSEL = {"volume": 1e-3, "exponent": 1.3, "gas_constant": 287.05}


def rates(p, supply, exhaust, fill, vent):
    return open_rates(
        p, supply, exhaust, gas_temperature=310.0, supply_temperature=290.0, fill=fill, vent=vent, **VESSEL
    )


@law(pressures, pressures, pressures, sizes, sizes, ratios, ratios, st.floats(-2e6, 2e6), few=40, many=200)
def test_the_opening_gives_the_rate_that_was_wanted(p, supply, exhaust, big, other, b, b2, wanted):
    filling, venting = rates(p, supply, exhaust, (big, b), (other, b2))
    fill, vent = openings_for_rate(wanted, filling, venting)
    assert 0.0 <= fill <= 1.0
    assert 0.0 <= vent <= 1.0
    assert fill == 0.0 or vent == 0.0
    # What really flows through valves that are so far open, by the law of the passage itself.
    inflow = (
        iso6358.mass_flow_rate(supply, p, 290.0, 310.0, sonic_conductance=big * fill, critical_ratio=b) if fill else 0.0
    )
    outflow = iso6358.mass_flow_rate(p, exhaust, 310.0, 290.0, sonic_conductance=other * vent, critical_ratio=b2)
    outflow = outflow if vent else 0.0
    reached = pressure_rate(inflow, 290.0, **VESSEL) - pressure_rate(outflow, 310.0, **VESSEL)
    possible = min(max(wanted, -venting), filling)
    near_equal = min(abs(supply / p - 1.0), abs(p / exhaust - 1.0)) < 2e-3
    # In the zone near equal pressures the gas that flows is a blend of both temperatures.
    assert abs(reached - possible) <= (0.05 if near_equal else 1e-9) * abs(possible) + 1e-6


@settings(derandomize=True, deadline=None, max_examples=50)
@given(pressures, pressures, pressures, st.floats(-2e6, 2e6))
def test_symbols_give_what_floats_give(p, supply, exhaust, wanted):
    x = ca.SX.sym("x", 4)
    symbolic = openings_for_rate(x[3], *rates(x[0], x[1], x[2], (1e-8, 0.3), (2e-8, 0.4)))
    found = ca.Function("f", [x], list(symbolic))([p, supply, exhaust, wanted])
    plain = openings_for_rate(wanted, *rates(p, supply, exhaust, (1e-8, 0.3), (2e-8, 0.4)))
    for one, other in zip(found, plain, strict=True):
        assert abs(float(one) - other) < 1e-9


@settings(derandomize=True, deadline=None)
@given(pressures, pressures)
def test_a_valve_without_a_drop_moves_nothing(p, supply):
    filling, venting = rates(p, min(supply, p), p, (1e-8, 0.3), (1e-8, 0.3))
    assert filling == 0.0
    assert venting == 0.0
    assert openings_for_rate(1e5, filling, venting) == (0.0, 0.0)
