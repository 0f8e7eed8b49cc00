"""Laws of an ideal gas with constant heat capacities."""

from __future__ import annotations

from typing import Any

# Values of air for all laws, parts and library sets.
AIR_GAS_CONSTANT = 287.05
"""Specific gas constant of dry air, ISO 2533:1975, rounded from 287.05287 [J/(kg K)]."""
AIR_ISENTROPIC_EXPONENT = 1.4
"""Ratio of the heat capacities of air, ISO 2533:1975 [1]."""


def mass(pressure: Any, volume: Any, temperature: Any, gas_constant: Any = AIR_GAS_CONSTANT) -> Any:
    r"""Return the mass of an ideal gas in a volume.

    .. math:: m = \frac{p V}{R T}

    Parameters
    ----------
    pressure, volume, temperature : float, array or symbol
        Absolute pressure p [Pa], volume V [m^3], temperature T [K].
    gas_constant : float, array or symbol
        Specific gas constant R [J/(kg K)] (default: value of air).

    Returns
    -------
    float, array or symbol
        Mass [kg].

    Notes
    -----
    The laws of the module `poppet.laws.physics.gas` are accurate within 1 % for air up to about 20 bar at room
    temperature.

    Examples
    --------
    >>> print(f"{mass(1e5, 0.2, 293.15):.4f} kg")
    0.2377 kg
    """
    return pressure * volume / (gas_constant * temperature)


def temperature(pressure: Any, volume: Any, mass: Any, gas_constant: Any = AIR_GAS_CONSTANT) -> Any:
    r"""Return the temperature of an ideal gas of given mass in a volume.

    .. math:: T = \frac{p V}{m R}

    Parameters
    ----------
    pressure, volume, mass : float, array or symbol
        Absolute pressure p [Pa], volume V [m^3], mass m of the gas [kg].
    gas_constant : float, array or symbol
        Specific gas constant R [J/(kg K)] (default: value of air).

    Returns
    -------
    float, array or symbol
        Temperature [K].

    Examples
    --------
    >>> print(f"{temperature(1e5, 0.2, 0.2377):.2f} K")
    293.12 K
    """
    return pressure * volume / (mass * gas_constant)


def density(pressure: Any, temperature: Any, gas_constant: Any = AIR_GAS_CONSTANT) -> Any:
    r"""Return the density of an ideal gas.

    .. math:: \varrho = \frac{p}{R T}

    Parameters
    ----------
    pressure, temperature : float, array or symbol
        Absolute pressure p [Pa], temperature T [K].
    gas_constant : float, array or symbol
        Specific gas constant R [J/(kg K)] (default: value of air).

    Returns
    -------
    float, array or symbol
        Density [kg/m^3].

    Examples
    --------
    Dry air at 20 degC and 100 kPa (the moist air of the reference atmosphere ANR has 1.185 kg/m^3):

    >>> print(f"{density(1e5, 293.15):.4f} kg/m^3")
    1.1884 kg/m^3
    """
    return pressure / (gas_constant * temperature)


def isochoric_heat_capacity(
    gas_constant: Any = AIR_GAS_CONSTANT, isentropic_exponent: Any = AIR_ISENTROPIC_EXPONENT
) -> Any:
    r"""Return the specific heat capacity at constant volume.

    .. math:: c_v = \frac{R}{\kappa - 1}

    Parameters
    ----------
    gas_constant, isentropic_exponent : float, array or symbol
        Specific gas constant R [J/(kg K)] and ratio of the heat capacities [1].

    Returns
    -------
    float, array or symbol
        Specific heat capacity [J/(kg K)].

    Examples
    --------
    >>> print(f"{isochoric_heat_capacity():.2f} J/(kg K)")
    717.63 J/(kg K)
    """
    return gas_constant / (isentropic_exponent - 1.0)


def isobaric_heat_capacity(
    gas_constant: Any = AIR_GAS_CONSTANT, isentropic_exponent: Any = AIR_ISENTROPIC_EXPONENT
) -> Any:
    r"""Return the specific heat capacity at constant pressure.

    .. math:: c_p = \frac{\kappa R}{\kappa - 1}

    Parameters
    ----------
    gas_constant, isentropic_exponent : float, array or symbol
        Specific gas constant R [J/(kg K)] and ratio of the heat capacities [1].

    Returns
    -------
    float, array or symbol
        Specific heat capacity [J/(kg K)].

    Examples
    --------
    >>> print(f"{isobaric_heat_capacity():.1f} J/(kg K)")
    1004.7 J/(kg K)
    """
    return isentropic_exponent * gas_constant / (isentropic_exponent - 1.0)


def internal_energy(
    mass: Any,
    temperature: Any,
    gas_constant: Any = AIR_GAS_CONSTANT,
    isentropic_exponent: Any = AIR_ISENTROPIC_EXPONENT,
) -> Any:
    r"""Return the internal energy of an ideal gas relative to its energy at 0 K.

    .. math:: U = m c_v T = \frac{p V}{\kappa - 1}

    Parameters
    ----------
    mass, temperature : float, array or symbol
        Mass m [kg], temperature T [K].
    gas_constant, isentropic_exponent : float, array or symbol
        Specific gas constant R [J/(kg K)] and ratio of the heat capacities [1].

    Returns
    -------
    float, array or symbol
        Internal energy [J].

    Examples
    --------
    >>> print(f"{internal_energy(0.2377, 293.15) / 1e3:.1f} kJ")
    50.0 kJ
    """
    return mass * isochoric_heat_capacity(gas_constant, isentropic_exponent) * temperature


def enthalpy_flow(
    mass_flow_rate: Any,
    temperature: Any,
    gas_constant: Any = AIR_GAS_CONSTANT,
    isentropic_exponent: Any = AIR_ISENTROPIC_EXPONENT,
) -> Any:
    r"""Return the enthalpy flow rate of an ideal gas relative to its enthalpy at 0 K.

    .. math:: \dot H = q_m c_p T

    Parameters
    ----------
    mass_flow_rate, temperature : float, array or symbol
        Mass flow rate q_m [kg/s], and upstream stagnation temperature T of the gas [K].
    gas_constant, isentropic_exponent : float, array or symbol
        Specific gas constant R [J/(kg K)] and ratio of the heat capacities [1].

    Returns
    -------
    float, array or symbol
        Enthalpy flow rate [W], with the sign of the mass flow rate.

    Examples
    --------
    >>> print(f"{enthalpy_flow(0.01, 293.15) / 1e3:.3f} kW")
    2.945 kW
    """
    return mass_flow_rate * isobaric_heat_capacity(gas_constant, isentropic_exponent) * temperature
