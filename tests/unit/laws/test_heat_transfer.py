"""Heat transfer at the wall: properties of air, both correlations, behaviour at zero."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np
import pytest

from poppet.laws.physics.heat_transfer import (
    AIR_CONDUCTIVITY,
    AIR_VISCOSITY,
    charging_conductance,
    natural_conductance,
    sutherland,
)

TANK = {"pressure": 3e5, "temperature": 310.0, "wall_temperature": 293.15, "area": 2.06, "height": 0.6}
JET = {"inlet_mass_flow_rate": 5e-3, "inlet_diameter": 6e-3}


def test_properties_of_air_against_tables():
    """Incropera et al. 2007, Table A.4: air at 250, 300 and 400 K."""
    temperature = np.array([250.0, 300.0, 400.0])
    viscosity, conductivity = np.array([159.6, 184.6, 230.1]) * 1e-7, np.array([22.3, 26.3, 33.8]) * 1e-3
    assert np.max(np.abs(sutherland(temperature, AIR_VISCOSITY) / viscosity - 1.0)) < 0.01
    assert np.max(np.abs(sutherland(temperature, AIR_CONDUCTIVITY) / conductivity - 1.0)) < 0.01


def test_sutherland_gives_its_reference():
    assert sutherland(273.0, AIR_VISCOSITY) == pytest.approx(1.716e-5, rel=1e-15)


def rayleigh_by_hand(temperature: float = 310.0) -> tuple[float, float]:
    film = 0.5 * (temperature + 293.15)
    density = 3e5 / (287.05 * film)
    viscosity, conductivity = sutherland(film, AIR_VISCOSITY), sutherland(film, AIR_CONDUCTIVITY)
    capacity = 1.4 / 0.4 * 287.05
    prandtl = viscosity * capacity / conductivity
    grashof = 9.80665 / film * (temperature - 293.15) * 0.6**3 * density**2 / viscosity**2
    return grashof * prandtl, conductivity


def test_natural_convection_is_its_nusselt_number():
    rayleigh, conductivity = rayleigh_by_hand()
    expected = 0.13 * rayleigh ** (1 / 3) * conductivity * 2.06 / 0.6
    assert natural_conductance(**TANK) == pytest.approx(expected, rel=1e-6)


def test_charging_is_its_nusselt_number():
    rayleigh, conductivity = rayleigh_by_hand()
    reynolds = 4 * 5e-3 / (math.pi * 6e-3 * sutherland(0.5 * (310.0 + 293.15), AIR_VISCOSITY))
    expected = (0.56 * reynolds**0.67 + 0.104 * rayleigh**0.352) * conductivity * 2.06 / 0.6
    assert charging_conductance(**TANK, **JET) == pytest.approx(expected, rel=1e-6)


def test_the_height_cancels_out_of_natural_convection():
    assert natural_conductance(**TANK | {"height": 1.7}) == pytest.approx(natural_conductance(**TANK), rel=1e-13)


@pytest.mark.parametrize(("name", "power"), [("pressure", 2 / 3), ("area", 1.0), ("prefactor", 1.0)])
def test_natural_convection_is_homogeneous(name, power):
    base = {**TANK, "prefactor": 0.13}
    doubled = natural_conductance(**base | {name: 2.0 * base[name]})
    assert doubled == pytest.approx(2.0**power * natural_conductance(**base), rel=1e-13)


def test_warm_and_cold_gas_lose_and_gain_alike():
    """Same film temperature, opposite differences."""
    warm = natural_conductance(**TANK | {"temperature": 310.0, "wall_temperature": 290.0})
    cold = natural_conductance(**TANK | {"temperature": 290.0, "wall_temperature": 310.0})
    assert warm == cold


@pytest.mark.parametrize("difference", [-1e-12, 0.0, 1e-12])
@pytest.mark.parametrize("flow", [-1e-3, 0.0, 1e-12, 1e-3])
def test_derivatives_are_finite_at_zero_difference_and_zero_flow(difference, flow):
    temperature, inflow = ca.SX.sym("T"), ca.SX.sym("q")
    vessel = TANK | {"temperature": temperature}
    laws = ca.vertcat(
        natural_conductance(**vessel),
        charging_conductance(**vessel, inlet_mass_flow_rate=inflow, inlet_diameter=6e-3),
    )
    gradient = ca.jacobian(laws, ca.vertcat(temperature, inflow))
    values = ca.Function("g", [temperature, inflow], [laws, gradient])(293.15 + difference, flow)
    assert np.all(np.isfinite(np.array(values[0])))
    assert np.all(np.isfinite(np.array(values[1])))


def test_without_a_jet_only_natural_convection_is_left():
    """Either sign of the flow through the inlet: a vessel that is emptied has no jet."""
    still = charging_conductance(**TANK | JET | {"inlet_mass_flow_rate": 0.0})
    assert charging_conductance(**TANK | JET | {"inlet_mass_flow_rate": -1e-2}) == still
    assert 0.0 < still < charging_conductance(**TANK, **JET)


def test_rounding_off_is_small_where_it_should_be():
    rayleigh, conductivity = rayleigh_by_hand(294.15)
    expected = 0.13 * rayleigh ** (1 / 3) * conductivity * 2.06 / 0.6
    assert natural_conductance(**TANK | {"temperature": 294.15}) == pytest.approx(expected, rel=5e-5)


def test_floats_arrays_and_symbols_agree():
    temperatures = np.array([280.0, 293.15, 320.0])
    array = charging_conductance(**TANK | JET | {"temperature": temperatures})
    symbol = ca.SX.sym("T")
    traced = ca.Function("f", [symbol], [charging_conductance(**TANK | JET | {"temperature": symbol})])
    for temperature, value in zip(temperatures, array, strict=True):
        assert charging_conductance(**TANK | JET | {"temperature": float(temperature)}) == pytest.approx(
            value, rel=1e-14
        )
        assert float(traced(temperature)) == pytest.approx(value, rel=1e-14)
