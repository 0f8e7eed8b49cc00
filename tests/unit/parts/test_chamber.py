"""The chamber: states, thermal laws, wall, contradictions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from poppet.core.codes import Note
from poppet.parts import Chamber
from poppet.parts.part import GasState, Scope, Surroundings
from refusals import refused

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
INFLOW = 0.01  # kg/s
SUPPLY_ENTHALPY = AIR.heat_capacity_pressure * 320.0 * INFLOW


def scope_of(chamber: Chamber, **states: float) -> Scope:
    scope = Scope(chamber.parameters(AIR), {}, {}, AIR)
    return Scope(scope.numbers, {**chamber.start(scope), **states}, {}, AIR)


def chamber(**fields: Any) -> Chamber:
    return Chamber(volume="2 l", initial_pressure="3 bar", initial_temperature="300 K", **fields)


LAWS = [
    {"thermal": "energy"},
    {"thermal": "isothermal"},
    {"thermal": "polytropic", "polytropic_exponent": 1.2},
    {"thermal": "isentrope"},
]


@pytest.mark.parametrize("law", LAWS)
def test_starts_at_its_initial_state(law):
    part = chamber(**law)
    gas = part.gas(scope_of(part))
    assert gas.pressure == pytest.approx(3e5, rel=1e-14)
    assert gas.temperature == pytest.approx(300.0, rel=1e-14)


@pytest.mark.parametrize("law", LAWS)
def test_mass_is_the_sum_of_flows(law):
    part = chamber(**law)
    flows = ((INFLOW, SUPPLY_ENTHALPY), (-0.004, -1.0))
    assert part.balance(scope_of(part), flows).rates["mass"] == pytest.approx(0.006, rel=1e-14)


@pytest.mark.parametrize(("law", "exponent"), list(zip(LAWS[1:], (1.0, 1.2, 1.4), strict=True)))
def test_prescribed_laws_follow_their_exponent(law, exponent):
    """p ~ m^n at constant volume."""
    part = chamber(**law)
    mass = scope_of(part).states["mass"]
    gas = part.gas(scope_of(part, mass=2.0 * mass))
    assert gas.pressure == pytest.approx(3e5 * 2.0**exponent, rel=1e-13)
    assert gas.temperature == pytest.approx(300.0 * 2.0 ** (exponent - 1.0), rel=1e-13)


def test_energy_balance_raises_pressure_by_the_enthalpy():
    """V p'/(kappa - 1) = H."""
    part = chamber()
    rate = part.balance(scope_of(part), ((INFLOW, SUPPLY_ENTHALPY),)).rates["pressure"]
    assert rate == pytest.approx(0.4 * SUPPLY_ENTHALPY / 2e-3, rel=1e-14)


@pytest.mark.parametrize("law", LAWS[1:])
def test_heat_of_a_prescribed_law_closes_the_energy_balance(law):
    """U' = H + Q, with U = p V/(kappa - 1)."""
    part = chamber(**law)
    scope = scope_of(part)
    heat = part.balance(scope, ((INFLOW, SUPPLY_ENTHALPY),)).heat
    mass, step = scope.states["mass"], 1e-7
    ends = [part.gas(scope_of(part, mass=mass + sign * step)).pressure * 2e-3 / 0.4 for sign in (-1.0, 1.0)]
    energy_rate = (ends[1] - ends[0]) / (2.0 * step) * INFLOW
    assert heat == pytest.approx(energy_rate - SUPPLY_ENTHALPY, rel=1e-6)


def test_wall_heats_a_colder_gas():
    part = chamber(wall_conductance="5 W/K", wall_temperature="320 K")
    balance = part.balance(scope_of(part), ())
    assert balance.outputs["heat_flow_rate"][0] == pytest.approx(100.0)
    assert balance.rates["pressure"] == pytest.approx(0.4 / 2e-3 * 100.0)


def test_wall_temperature_defaults_to_ambient():
    part = chamber(wall_conductance="5 W/K")
    assert part.parameters(AIR)["wall_temperature"] == 293.15


def test_wall_with_heat_capacity_is_a_state():
    part = chamber(
        wall_conductance="5 W/K",
        wall_temperature="320 K",
        wall_heat_capacity="2 kJ/K",
        outer_conductance="3 W/K",
        ambient_temperature="290 K",
    )
    assert [state.name for state in part.states()] == ["pressure", "mass", "wall_temperature"]
    balance = part.balance(scope_of(part), ())
    assert balance.rates["wall_temperature"] == pytest.approx((3.0 * (290.0 - 320.0) - 100.0) / 2e3)
    assert balance.outputs["wall_temperature"] == (320.0, "K")


def test_wall_capacity_changes_the_structure_and_its_value_does_not():
    bare, light, heavy = (chamber(**more) for more in ({}, {"wall_heat_capacity": 1.0}, {"wall_heat_capacity": 9.0}))
    assert light.structure() == heavy.structure() != bare.structure()


def test_natural_convection_follows_its_prefactor():
    tank = {"heat_transfer": "natural", "wall_area": "1 m^2", "height": "0.5 m", "wall_temperature": "320 K"}
    one, two = chamber(**tank), chamber(**tank, nusselt_prefactor=0.26)
    heats = [part.balance(scope_of(part), ()).heat for part in (one, two)]
    assert heats[0] > 0.0
    assert heats[1] == pytest.approx(2.0 * heats[0], rel=1e-6)


def test_charging_jet_transfers_more_than_rest():
    part = chamber(
        heat_transfer="woodfield", wall_area="0.1 m^2", height="0.2 m", inlet_diameter="4 mm", wall_temperature="320 K"
    )
    rest, charged, drained = (
        part.balance(scope_of(part), flows).heat for flows in ((), ((0.01, 0.0),), ((-0.01, 0.0),))
    )
    assert charged > rest > 0.0
    assert drained == pytest.approx(rest, rel=1e-12)


@pytest.mark.parametrize(
    ("fields", "match"),
    [
        ({"thermal": "polytropic"}, "chamber.no_exponent"),
        ({"heat_transfer": "natural", "wall_area": 1.0}, "chamber.correlation_needs"),
        ({"heat_transfer": "woodfield", "wall_area": 1.0, "height": 1.0}, "chamber.correlation_needs"),
        ({"outer_conductance": "3 W/K"}, "chamber.no_wall_heat_capacity"),
        ({"thermal": "adiabatic"}, "fields.not_an_option"),
        ({"volume": "0 l"}, "fields.out_of_range"),
        ({"volume": "-1 l"}, "fields.out_of_range"),
        ({"wall_conductance": "-1 W/K"}, "fields.out_of_range"),
        ({"initial_temperature": "-300 degC"}, "quantity.temperature_below_zero"),
        ({"thermal": "polytropic", "polytropic_exponent": 3.0}, "fields.out_of_range"),
    ],
)
def test_contradictions(fields, match):
    with refused(match) as caught:
        Chamber(**{"volume": "2 l", **fields})
    # What is missing is no field that was given.
    assert caught.value.address in fields or match in ("chamber.no_exponent", "chamber.correlation_needs")
    assert caught.value.hint.endswith((".", '"'))


@pytest.mark.parametrize(
    ("fields", "note"),
    [
        ({"thermal": "energy", "wall_conductance": "4 W/K", "wall_heat_capacity": 9.0, "outer_conductance": 1.0}, None),
        ({"thermal": "isothermal", "wall_conductance": 0.0}, None),
        (
            {"thermal": "isothermal", "wall_conductance": "4 W/K", "wall_temperature": "4 degC"},
            ("wall_conductance", ["wall_temperature"], "thermal", "isothermal"),
        ),
        (
            {"thermal": "isentrope", "wall_heat_capacity": 9.0, "outer_conductance": 1.0},
            ("wall_heat_capacity", ["outer_conductance"], "thermal", "isentrope"),
        ),
        (
            {"thermal": "isentrope", "heat_transfer": "natural", "wall_area": 1.0},
            ("wall_area", [], "thermal", "isentrope"),
        ),
        ({"polytropic_exponent": 1.1}, ("polytropic_exponent", [], "thermal", "energy")),
        (
            {"wall_area": 1.0, "nusselt_prefactor": 0.1},
            ("wall_area", ["nusselt_prefactor"], "heat_transfer", "constant"),
        ),
        (
            {"heat_transfer": "natural", "wall_area": 1.0, "height": 1.0, "inlet_diameter": 1.0, "wall_conductance": 5},
            ("wall_conductance", ["inlet_diameter"], "heat_transfer", "natural"),
        ),
    ],
)
def test_fields_of_another_law_are_noted(fields, note):
    notes = chamber(**fields).notes()
    if note is None:
        assert notes == ()
    else:
        first, others, option, law = note
        assert notes == (Note("chamber.no_effect", first, others=others, option=option, law=law),)


def test_a_wall_that_has_no_effect_is_no_state():
    with_wall = chamber(thermal="isothermal", wall_conductance=5.0, wall_heat_capacity=9.0)
    assert [state.name for state in with_wall.states()] == ["mass"]
    assert with_wall.structure() == chamber(thermal="isothermal").structure()


def test_gauge_start_is_checked_once_the_ambient_is_known():
    part = Chamber(volume="1 l", initial_pressure="-0.95 bar g")
    assert part.parameters(AIR)["initial_pressure"] == pytest.approx(5e3)
    with refused("numbers.below_vacuum", "initial_pressure"):
        part.parameters(Surroundings(9e4, 293.15, 287.05, 1.4, 1.0))


def test_start_mass_is_that_of_an_ideal_gas():
    part = chamber(thermal="isothermal")
    assert scope_of(part).states["mass"] == pytest.approx(3e5 * 2e-3 / (287.05 * 300.0), rel=1e-14)
    assert isinstance(part.gas(scope_of(part)), GasState)


def test_every_state_is_positive_and_has_a_size():
    part = chamber(wall_heat_capacity=1.0)
    assert all(state.positive and state.nominal > 0.0 and np.isfinite(state.nominal) for state in part.states())
