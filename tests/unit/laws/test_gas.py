"""Ideal gas and the closed forms of charging and discharging."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from poppet.core.errors import OutOfRangeError
from poppet.core.units import ANR
from poppet.laws.physics import gas, tanks
from refusals import refused

R, KAPPA = 287.05, 1.4
C, B = 1.650097e-8, 0.427355  # the poppet of Varga & Keski-Honkola 2012 at 0.5 mm
SUPPLY, START, ROOM, VOLUME = 7e5, 1e5, 293.15, 0.2


def test_mass_and_temperature_are_inverse():
    m = gas.mass(3e5, 0.2, 310.0)
    assert gas.temperature(3e5, 0.2, m) == pytest.approx(310.0, rel=1e-15)
    assert gas.density(3e5, 310.0) * 0.2 == pytest.approx(m, rel=1e-15)


def test_heat_capacities():
    assert gas.isobaric_heat_capacity() - gas.isochoric_heat_capacity() == pytest.approx(R, rel=1e-14)
    assert gas.isobaric_heat_capacity() / gas.isochoric_heat_capacity() == pytest.approx(KAPPA, rel=1e-15)


def test_internal_energy_is_that_of_pressure_and_volume():
    m = gas.mass(3e5, 0.2, 310.0)
    assert gas.internal_energy(m, 310.0) == pytest.approx(3e5 * 0.2 / (KAPPA - 1.0), rel=1e-14)


def test_enthalpy_flow_has_the_sign_of_the_mass_flow():
    assert gas.enthalpy_flow(-0.01, 300.0) == -gas.enthalpy_flow(0.01, 300.0) < 0.0


def test_another_gas():
    helium = 8.314462618 / 4.0026e-3
    assert gas.mass(1e5, 1.0, 300.0, helium) == pytest.approx(0.16047, rel=1e-4)
    assert gas.isochoric_heat_capacity(helium, 5 / 3) == pytest.approx(1.5 * helium, rel=1e-14)


# --- closed forms, against the balances they solve ---


def inflow(pressure: float) -> float:
    """Mass flow rate of ISO 6358 into the tank [kg/s]."""
    ratio = pressure / SUPPLY
    fraction = 1.0 if ratio <= B else np.sqrt(1.0 - ((ratio - B) / (1.0 - B)) ** 2)
    return C * SUPPLY * ANR.density * np.sqrt(ANR.temperature / ROOM) * fraction


def time_by_quadrature(pressure: float, heat: float) -> float:
    """Time to a pressure from p' = heat * R Ts q(p) / V, by quadrature."""
    parts = sorted({START, min(max(B * SUPPLY, START), pressure), pressure})
    return sum(
        quad(lambda p: VOLUME / (heat * R * ROOM * inflow(p)), low, high, epsabs=0.0, epsrel=1e-12)[0]
        for low, high in pairwise(parts)
    )


RATE = tanks.charging_rate(VOLUME, C, ROOM, ROOM)


@pytest.mark.parametrize("pressure", [1.5e5, B * SUPPLY, 4e5, 5e5, 6.9e5])
@pytest.mark.parametrize("heat", [1.0, KAPPA])
def test_charging_time_solves_the_balance(pressure, heat):
    closed = tanks.charging_time(pressure, START, SUPPLY, B, heat * RATE)
    assert closed == pytest.approx(time_by_quadrature(pressure, heat), rel=1e-10)


@pytest.mark.parametrize(("heat", "seconds"), [(1.0, 71.11), (KAPPA, 50.79)])
def test_charging_time_to_five_bar(heat, seconds):
    assert tanks.charging_time(5e5, START, SUPPLY, B, heat * RATE) == pytest.approx(seconds, abs=0.005)


@pytest.mark.parametrize("start", [0.5e5, 1e5, 4e5])
def test_charging_pressure_and_time_are_inverse(start):
    pressure = np.linspace(start, 0.999 * SUPPLY, 50)
    time = tanks.charging_time(pressure, start, SUPPLY, B, RATE)
    back = tanks.charging_pressure(time, start, SUPPLY, B, RATE)
    assert np.max(np.abs(back - pressure)) < 1e-8 * SUPPLY


def test_the_supply_pressure_is_reached_in_finite_time_and_kept():
    full = tanks.charging_time(SUPPLY, START, SUPPLY, B, RATE)
    choked = (B - START / SUPPLY) / RATE
    assert full == pytest.approx(choked + (1.0 - B) * np.pi / (2.0 * RATE), rel=1e-14)
    kept = tanks.charging_pressure(np.array([1.0, 2.0]) * full, START, SUPPLY, B, RATE)
    assert kept == pytest.approx(SUPPLY, rel=1e-14)


def test_charging_pressure_of_a_float_is_a_float():
    assert np.ndim(tanks.charging_pressure(1.0, START, SUPPLY, B, RATE)) == 0


@pytest.mark.parametrize("pressure", [0.9e5, 7.1e5])
def test_pressures_that_charging_does_not_reach(pressure):
    with refused("tanks.not_reached", "pressure", kind=OutOfRangeError):
        tanks.charging_time(pressure, START, SUPPLY, B, RATE)


def test_discharge_starts_with_the_slope_of_the_balance():
    tau = tanks.discharge_time_constant(0.016, C, 300.0)
    flow = C * 6e5 * ANR.density * np.sqrt(ANR.temperature / 300.0)
    step = 1e-6 * tau
    isothermal = (tanks.isothermal_discharge_pressure(step, 6e5, tau) - 6e5) / step
    adiabatic = (tanks.adiabatic_discharge_pressure(step, 6e5, tau) - 6e5) / step
    assert isothermal == pytest.approx(-R * 300.0 * flow / 0.016, rel=1e-5)
    assert adiabatic == pytest.approx(KAPPA * isothermal, rel=1e-5)


def test_adiabatic_discharge_solves_its_balance():
    """V rho' = -C p rho0 sqrt(T0/T) with the gas on its isentrope."""
    tau, time = tanks.discharge_time_constant(0.016, C, 300.0), 7.0
    step = 1e-4
    pressures = [tanks.adiabatic_discharge_pressure(t, 6e5, tau) for t in (time - step, time, time + step)]
    temperatures = [tanks.isentrope_temperature(p, 6e5, 300.0) for p in pressures]
    density = [gas.density(p, t) for p, t in zip(pressures, temperatures, strict=True)]
    flow = C * pressures[1] * ANR.density * np.sqrt(ANR.temperature / temperatures[1])
    assert 0.016 * (density[2] - density[0]) / (2.0 * step) == pytest.approx(-flow, rel=1e-8)


def test_adiabatic_charging_temperature():
    assert tanks.adiabatic_charging_temperature(5e5, 1e5, ROOM, ROOM) == pytest.approx(380.009, abs=5e-4)
    assert tanks.adiabatic_charging_temperature(1e5, 1e5, ROOM, 310.0) == pytest.approx(310.0, rel=1e-14)
    vacuum = tanks.adiabatic_charging_temperature(5e5, 0.0, ROOM, ROOM)
    assert vacuum == pytest.approx(KAPPA * ROOM, rel=1e-15)


def test_adiabatic_charging_conserves_energy():
    end = tanks.adiabatic_charging_temperature(5e5, 1e5, 300.0, 280.0)
    before, after = gas.mass(1e5, VOLUME, 280.0), gas.mass(5e5, VOLUME, end)
    gain = gas.internal_energy(after, end) - gas.internal_energy(before, 280.0)
    assert gain == pytest.approx(gas.enthalpy_flow(after - before, 300.0), rel=1e-13)


def test_the_isentrope_of_the_paper_is_171_kelvin_too_hot():
    assert tanks.isentrope_temperature(5e5, 1e5, ROOM) - ROOM == pytest.approx(171.0, abs=0.2)


def test_a_rise_of_18_kelvin_is_a_polytropic_exponent_of_1_038():
    assert tanks.isentrope_temperature(5e5, 1e5, ROOM, 1.038) - ROOM == pytest.approx(18.0, abs=0.25)


def test_isentrope_charging_solves_its_balance():
    def rate(pressure: float) -> float:
        return KAPPA * R * tanks.isentrope_temperature(pressure, START, ROOM) * inflow(pressure) / VOLUME

    expected = quad(lambda p: 1.0 / rate(p), START, 2.9e5, epsabs=0.0, epsrel=1e-12)[0]
    closed = tanks.isentrope_choked_charging_time(2.9e5, START, SUPPLY, B, RATE)
    assert closed == pytest.approx(expected, rel=1e-11)


def test_isentrope_charging_ends_where_choking_ends():
    with refused("tanks.no_longer_choked", "pressure", kind=OutOfRangeError):
        tanks.isentrope_choked_charging_time(5e5, START, SUPPLY, B, RATE)
