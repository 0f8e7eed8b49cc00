"""Heat transfer between the gas in a vessel and its wall.

Each law gives the wall conductance h A; the heat flow into the gas is h A (T_wall - T). Properties are those
of air at the film temperature, the mean of gas and wall.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from poppet.core.symbolic import maximum, sqrt
from poppet.laws.physics.gas import AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT, density, isobaric_heat_capacity

GRAVITY = 9.80665
"""Standard acceleration of free fall, ISO 80000-3 [m/s^2]."""
SMALLEST_DIFFERENCE = 0.01
"""Smoothing of |T - T_wall| near zero, where its powers have infinite slopes; 5e-5 of the value at 1 K [K]."""
SMALLEST_REYNOLDS = 10.0
"""Smoothing of the Reynolds number of the jet near zero flow; 7e-5 of the value at Re = 1000 [1]."""


class Sutherland(NamedTuple):
    """Coefficients of Sutherland's law for viscosity or thermal conductivity of a gas.

    Parameters
    ----------
    reference_value : float
        Viscosity [Pa s] or conductivity [W/(m K)] at the reference temperature.
    reference_temperature, sutherland_temperature : float
        Temperature of the reference value, and Sutherland's constant [K].
    source : str
        Title and table of the source.
    """

    reference_value: float
    reference_temperature: float
    sutherland_temperature: float
    source: str


AIR_VISCOSITY = Sutherland(1.716e-5, 273.0, 111.0, "White, Viscous Fluid Flow, 2nd ed. 1991, Table 1-2")
AIR_CONDUCTIVITY = Sutherland(0.0241, 273.0, 194.0, "White, Viscous Fluid Flow, 2nd ed. 1991, Table 1-3")


def sutherland(temperature: Any, law: Sutherland) -> Any:
    r"""Return the viscosity or thermal conductivity of a gas at low pressure.

    .. math:: y = y_0 \left(\frac{T}{T_0}\right)^{3/2} \frac{T_0 + S}{T + S}

    Parameters
    ----------
    temperature : float, array or symbol
        Temperature T [K].
    law : Sutherland
        Coefficients of the gas.

    Returns
    -------
    float, array or symbol
        Viscosity [Pa s] or thermal conductivity [W/(m K)], depending on the coefficients.

    Notes
    -----
    For air, the error is within 2 % for the viscosity from 170 to 1900 K and for the conductivity from 160 to 2000 K,
    at pressures up to some tens of bar. Other gases require their own coefficients.

    References
    ----------
    White, Viscous Fluid Flow, 2nd ed. 1991, Tables 1-2 and 1-3.

    Examples
    --------
    >>> print(f"{sutherland(300.0, AIR_VISCOSITY):.3e} Pa s")
    1.847e-05 Pa s
    """
    t0, s = law.reference_temperature, law.sutherland_temperature
    ratio = temperature / t0
    return law.reference_value * ratio * sqrt(ratio) * (t0 + s) / (temperature + s)


def natural_conductance(
    pressure: Any,
    temperature: Any,
    wall_temperature: Any,
    area: Any,
    height: Any,
    prefactor: Any = 0.13,
    gas_constant: Any = AIR_GAS_CONSTANT,
    isentropic_exponent: Any = AIR_ISENTROPIC_EXPONENT,
) -> Any:
    r"""Return the wall conductance h A of a vessel with natural convection.

    .. math:: \mathrm{Nu} = c\, \mathrm{Ra}_H^{1/3},\quad h A = \mathrm{Nu}\, \frac{\lambda A}{H}

    Parameters
    ----------
    pressure, temperature, wall_temperature : float, array or symbol
        Absolute pressure [Pa] and temperature [K] of the gas, temperature of the wall [K].
    area, height : float, array or symbol
        Wetted area A of the wall [m^2], and height H of the vessel [m]. The height cancels out, because the exponent is
        1/3.
    prefactor : float, array or symbol
        Prefactor c of the Nusselt number [1].
    gas_constant, isentropic_exponent : float, array or symbol
        Specific gas constant [J/(kg K)] and ratio of the heat capacities [1].

    Returns
    -------
    float, array or symbol
        Wall conductance h A [W/K].

    Notes
    -----
    The law is valid for turbulent natural convection of air (Rayleigh numbers of about 1e9 to 1e13) in a vessel that is
    discharged or closed, without a jet. Fits to measured tanks gave prefactors of 0.135 to 0.141. The temperature
    difference is smoothed near zero, so the conductance is positive and its slope finite.

    References
    ----------
    McAdams 1954, Heat Transmission, 3rd ed., chapter 7 (0.13 for turbulent air on vertical surfaces).

    Examples
    --------
    Air at 5 bar, 10 K warmer than the wall, loses about 10 W/(m2 K):

    >>> print(f"{natural_conductance(5e5, 303.15, 293.15, 1.0, 0.6):.1f} W/K")
    9.7 W/K
    """
    rayleigh, conductivity = _rayleigh(
        pressure, temperature, wall_temperature, height, gas_constant, isentropic_exponent
    )
    return prefactor * rayleigh ** (1.0 / 3.0) * conductivity * area / height


def charging_conductance(
    pressure: Any,
    temperature: Any,
    wall_temperature: Any,
    area: Any,
    height: Any,
    inlet_mass_flow_rate: Any,
    inlet_diameter: Any,
    *,
    gas_constant: Any = AIR_GAS_CONSTANT,
    isentropic_exponent: Any = AIR_ISENTROPIC_EXPONENT,
) -> Any:
    r"""Return the wall conductance h A of a vessel that is charged through a jet.

    .. math:: \mathrm{Nu}_H = 0.56\, \mathrm{Re}_d^{0.67} + 0.104\, \mathrm{Ra}_H^{0.352},\quad
              \mathrm{Re}_d = \frac{4 q_m}{\pi d \mu},\quad h A = \mathrm{Nu}_H\, \frac{\lambda A}{H}

    Parameters
    ----------
    pressure, temperature, wall_temperature : float, array or symbol
        Absolute pressure [Pa] and temperature [K] of the gas, temperature of the wall [K].
    area, height : float, array or symbol
        Wetted area A of the wall [m^2], and height H of the vessel [m].
    inlet_mass_flow_rate, inlet_diameter : float, array or symbol
        Mass flow rate into the vessel [kg/s], and bore d of the inlet [m]. A negative flow rate causes no jet.
    gas_constant, isentropic_exponent : float, array or symbol
        Specific gas constant [J/(kg K)] and ratio of the heat capacities [1].

    Returns
    -------
    float, array or symbol
        Wall conductance h A [W/K].

    Notes
    -----
    The law was fitted to vessels of some litres that were charged with hydrogen, nitrogen and argon by a single axial
    jet. It gives a mean over the wall. It is not valid for several inlets, diffusers or a jet that hits the wall.
    Both terms are smoothed near zero flow and zero temperature difference, so their slopes are finite.

    References
    ----------
    Woodfield, Monde & Mitsutake 2007, J. Therm. Sci. Technol. 2, 180-191.

    Examples
    --------
    >>> print(f"{charging_conductance(3e5, 310.0, 293.15, 1.0, 0.6, 5e-3, 6e-3):.1f} W/K")
    47.7 W/K
    """
    rayleigh, conductivity = _rayleigh(
        pressure, temperature, wall_temperature, height, gas_constant, isentropic_exponent
    )
    viscosity = sutherland(0.5 * (temperature + wall_temperature), AIR_VISCOSITY)
    reynolds = 4.0 * maximum(inlet_mass_flow_rate, 0.0) / (math.pi * inlet_diameter * viscosity)
    # Re^0.67 for a jet; near zero flow Re^2 replaces it, whose slope is finite.
    jet = reynolds**2 * (reynolds**2 + SMALLEST_REYNOLDS**2) ** (0.335 - 1.0)
    return (0.56 * jet + 0.104 * rayleigh**0.352) * conductivity * area / height


def _rayleigh(
    pressure: Any, temperature: Any, wall_temperature: Any, height: Any, gas_constant: Any, isentropic_exponent: Any
) -> tuple[Any, Any]:
    """Return the Rayleigh number for the length `height`, and the thermal conductivity of air [W/(m K)].

    The gas properties are evaluated at the mean of gas temperature and wall temperature.
    """
    film = 0.5 * (temperature + wall_temperature)
    difference = temperature - wall_temperature
    rounded = sqrt(difference * difference + SMALLEST_DIFFERENCE**2)
    viscosity, conductivity = sutherland(film, AIR_VISCOSITY), sutherland(film, AIR_CONDUCTIVITY)
    # An ideal gas expands by 1/T per kelvin: hence the film temperature under the acceleration.
    grashof = GRAVITY / film * rounded * height**3 * (density(pressure, film, gas_constant) / viscosity) ** 2
    prandtl = viscosity * isobaric_heat_capacity(gas_constant, isentropic_exponent) / conductivity
    return grashof * prandtl, conductivity
