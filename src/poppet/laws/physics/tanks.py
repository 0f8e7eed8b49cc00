"""Closed-form solutions for a vessel that is charged or discharged through one ISO 6358 flow path.

Simulations of the same vessel must reproduce these solutions. They assume constant supply or ambient, an ideal gas, a
subsonic index of 1/2, no cracking pressure and no regularised zone.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from poppet.core.errors import OutOfRangeError
from poppet.core.units import ANR
from poppet.laws.physics.gas import AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT


def discharge_time_constant(
    volume: Any, sonic_conductance: Any, temperature: Any, gas_constant: Any = AIR_GAS_CONSTANT
) -> Any:
    r"""Return the time constant of the pressure in a vessel during choked discharge.

    .. math:: \tau = \frac{V}{C \varrho_0 R \sqrt{T_0 T}}

    Parameters
    ----------
    volume, sonic_conductance : float or array
        Volume V [m^3], sonic conductance C of the flow path [m^3/(s Pa)].
    temperature, gas_constant : float or array
        Temperature T of the gas at the start [K], its specific gas constant R [J/(kg K)].

    Returns
    -------
    float or array
        Time constant [s].

    References
    ----------
    ISO 6358-2:2013, discharge test.

    Examples
    --------
    >>> print(f"{discharge_time_constant(0.016, 1e-8, 293.15):.2f} s")
    16.05 s
    """
    return volume / (sonic_conductance * ANR.density * gas_constant * np.sqrt(ANR.temperature * temperature))


def isothermal_discharge_pressure(time: Any, initial_pressure: Any, time_constant: Any) -> Any:
    r"""Return the pressure in a vessel during a choked discharge at constant temperature.

    .. math:: p = p_i\, e^{-t/\tau}

    Parameters
    ----------
    time, initial_pressure : float or array
        Time since opening [s], and absolute pressure at the start [Pa].
    time_constant : float or array
        Time constant :math:`\tau` from `discharge_time_constant` [s].

    Returns
    -------
    float or array
        Absolute pressure [Pa].

    Notes
    -----
    The law is valid for choked flow, until the pressure falls to the downstream pressure divided by b.

    References
    ----------
    ISO 6358-2:2013, discharge test.

    Examples
    --------
    >>> print(f"{isothermal_discharge_pressure(16.05, 7e5, 16.05) / 1e5:.3f} bar")
    2.575 bar
    """
    return initial_pressure * np.exp(-time / time_constant)


def adiabatic_discharge_pressure(
    time: Any, initial_pressure: Any, time_constant: Any, isentropic_exponent: Any = AIR_ISENTROPIC_EXPONENT
) -> Any:
    r"""Return the pressure in a vessel during a choked discharge without heat transfer.

    .. math:: p = p_i \left(1 + \frac{\kappa - 1}{2}\, \frac{t}{\tau}\right)^{-2 \kappa/(\kappa - 1)}

    Parameters
    ----------
    time, initial_pressure : float or array
        Time since opening [s], and absolute pressure at the start [Pa].
    time_constant : float or array
        Time constant :math:`\tau` from `discharge_time_constant` [s].
    isentropic_exponent : float or array
        Ratio of the heat capacities [1].

    Returns
    -------
    float or array
        Absolute pressure [Pa].

    Notes
    -----
    The law is valid for choked flow. The gas in the vessel follows the isentrope, see `isentrope_temperature`.

    Examples
    --------
    >>> print(f"{adiabatic_discharge_pressure(16.05, 7e5, 16.05) / 1e5:.3f} bar")
    1.954 bar
    """
    k = isentropic_exponent
    return initial_pressure * (1.0 + 0.5 * (k - 1.0) * time / time_constant) ** (-2.0 * k / (k - 1.0))


def charging_rate(
    volume: Any, sonic_conductance: Any, temperature: Any, supply_temperature: Any, gas_constant: Any = AIR_GAS_CONSTANT
) -> Any:
    r"""Return the rate of change of the pressure ratio p/p1 of a vessel during choked charging.

    The supply pressure p1 and the temperature in the vessel are constant.

    .. math:: K = \frac{R T C \varrho_0}{V} \sqrt{\frac{T_0}{T_s}}

    Parameters
    ----------
    volume, sonic_conductance : float or array
        Volume V [m^3], sonic conductance C of the flow path [m^3/(s Pa)].
    temperature, supply_temperature : float or array
        Temperatures T in the vessel and T_s of the supply [K].
    gas_constant : float or array
        Specific gas constant R [J/(kg K)].

    Returns
    -------
    float or array
        Rate K [1/s].

    Notes
    -----
    A vessel without heat transfer obeys the same law with kappa times the rate and with the supply temperature as T,
    because the enthalpy of the inflow depends only on the supply.

    Examples
    --------
    >>> print(f"{charging_rate(0.2, 1.650097e-8, 293.15, 293.15):.6f} 1/s")
    0.008227 1/s
    """
    inflow = sonic_conductance * ANR.density * np.sqrt(ANR.temperature / supply_temperature)
    return gas_constant * temperature * inflow / volume


def charging_pressure(time: Any, initial_pressure: Any, supply_pressure: Any, critical_ratio: Any, rate: Any) -> Any:
    r"""Return the pressure of a vessel that is charged at constant temperature.

    The state of the supply is constant. r = p/p1 is the ratio of vessel pressure to supply pressure, r_0 the initial
    ratio, and t_b the time at which subsonic flow begins.

    .. math:: r = r_0 + K t \;(r \le b),\quad
              r = b + (1-b) \sin\!\left(\frac{K (t - t_b)}{1-b}\right) \;(r > b)

    Parameters
    ----------
    time : float or array
        Time since opening [s].
    initial_pressure, supply_pressure : float or array
        Absolute pressures in the vessel at the start, and p1 of the supply [Pa].
    critical_ratio : float or array
        Critical pressure ratio b of the flow path [1].
    rate : float or array
        Rate K from `charging_rate` [1/s]. For a vessel without heat transfer, pass kappa times the rate at the supply
        temperature.

    Returns
    -------
    float or array
        Absolute pressure [Pa].

    Notes
    -----
    The pressure reaches the supply pressure in finite time and is constant afterwards.

    Examples
    --------
    >>> print(f"{charging_pressure(71.11, 1e5, 7e5, 0.4273550, 0.0082268) / 1e5:.3f} bar")
    5.000 bar
    """
    start, b = initial_pressure / supply_pressure, critical_ratio
    linear = start + rate * time
    # Subsonic charging runs evenly in angle along the ellipse, from choking or from where it starts; at the right
    # angle the supply's pressure is reached, and the sine would bring it down again.
    angle = _subsonic_angle(start, b) + rate * np.maximum(time - np.maximum(b - start, 0.0) / rate, 0.0) / (1.0 - b)
    curved = b + (1.0 - b) * np.sin(np.minimum(angle, 0.5 * np.pi))
    return supply_pressure * np.where(linear <= b, linear, curved)[()]


def charging_time(pressure: Any, initial_pressure: Any, supply_pressure: Any, critical_ratio: Any, rate: Any) -> Any:
    r"""Return the time in which a vessel of constant temperature is charged to a given pressure.

    .. math:: t = \frac{\min(r, b) - \min(r_0, b)}{K} + \frac{1-b}{K} \left[\arcsin\frac{r - b}{1-b}
              - \arcsin\frac{r_0 - b}{1-b}\right]_{r, r_0 \ge b}

    Parameters
    ----------
    pressure, initial_pressure, supply_pressure : float or array
        Absolute pressures: final pressure, pressure of the vessel at the start, and pressure p1 of the supply [Pa]. In
        the formula, r and r0 are the first two divided by p1; terms with r < b or r0 < b are zero in the bracket.
    critical_ratio : float or array
        Critical pressure ratio b of the flow path [1].
    rate : float or array
        Rate K from `charging_rate` [1/s]. For a vessel without heat transfer, pass kappa times the rate at the supply
        temperature.

    Returns
    -------
    float or array
        Time since opening [s].

    Raises
    ------
    OutOfRangeError
        If the pressure is not between the initial pressure and the supply pressure.

    Examples
    --------
    The 0.2 m3 tank of Varga & Keski-Honkola 2012 at 0.5 mm stroke from 1 to 5 bar, isothermal:

    >>> print(f"{charging_time(5e5, 1e5, 7e5, 0.4273550, 0.0082268):.2f} s")
    71.11 s
    """
    # Not `any` of the opposite, which not-a-number would pass.
    if not (np.all(pressure >= initial_pressure) and np.all(pressure <= supply_pressure)):
        ends = {"initial": initial_pressure, "supply": supply_pressure}
        raise OutOfRangeError("tanks.not_reached", "pressure", value=pressure, **ends)
    start, end, b = initial_pressure / supply_pressure, pressure / supply_pressure, critical_ratio
    linear = np.minimum(end, b) - np.minimum(start, b)
    return (linear + (1.0 - b) * (_subsonic_angle(end, b) - _subsonic_angle(start, b))) / rate


def adiabatic_charging_temperature(
    pressure: Any,
    initial_pressure: Any,
    supply_temperature: Any,
    initial_temperature: Any,
    isentropic_exponent: Any = AIR_ISENTROPIC_EXPONENT,
) -> Any:
    r"""Return the final temperature in a vessel that is charged without heat transfer.

    .. math:: T = \frac{\kappa T_s}{1 + \frac{p_0}{p} \left(\kappa \frac{T_s}{T_0} - 1\right)}

    Parameters
    ----------
    pressure, initial_pressure : float or array
        Absolute pressures: final pressure p, and pressure p0 in the vessel at the start [Pa].
    supply_temperature, initial_temperature : float or array
        Temperatures T_s of the supply and T0 in the vessel at the start [K].
    isentropic_exponent : float or array
        Ratio of the heat capacities [1].

    Returns
    -------
    float or array
        Temperature [K].

    Notes
    -----
    The result follows from the balances of mass and energy for any flow path. The temperature of a vessel that is
    evacuated before charging is kappa times the supply temperature.

    Examples
    --------
    >>> print(f"{adiabatic_charging_temperature(5e5, 1e5, 293.15, 293.15):.3f} K")
    380.009 K
    """
    hot = isentropic_exponent * supply_temperature
    return hot / (1.0 + initial_pressure / pressure * (hot / initial_temperature - 1.0))


def isentrope_temperature(
    pressure: Any, initial_pressure: Any, initial_temperature: Any, isentropic_exponent: Any = AIR_ISENTROPIC_EXPONENT
) -> Any:
    r"""Return the temperature of a constant mass of gas after a change of state without heat transfer.

    .. math:: T = T_0 \left(\frac{p}{p_0}\right)^{(\kappa - 1)/\kappa}

    Parameters
    ----------
    pressure, initial_pressure : float or array
        Absolute pressures: final pressure p, and pressure p0 at the start [Pa].
    initial_temperature : float or array
        Temperature T0 at the start [K].
    isentropic_exponent : float or array
        Ratio of the heat capacities; the polytropic exponent for a polytropic change [1].

    Returns
    -------
    float or array
        Temperature [K].

    Notes
    -----
    The law is valid for the gas that remains in a vessel during discharge. The tank model of Varga & Keski-Honkola 2012
    uses it for charging too: from 1 to 5 bar the law gives 464 K, but the energy balance gives 380 K.

    Examples
    --------
    >>> print(f"{isentrope_temperature(5e5, 1e5, 293.15):.0f} K")
    464 K
    """
    return initial_temperature * (pressure / initial_pressure) ** (1.0 - 1.0 / isentropic_exponent)


def isentrope_choked_charging_time(
    pressure: Any,
    initial_pressure: Any,
    supply_pressure: Any,
    critical_ratio: Any,
    rate: Any,
    isentropic_exponent: Any = AIR_ISENTROPIC_EXPONENT,
) -> Any:
    r"""Return the time in which choked flow charges a vessel whose gas follows an isentrope.

    This is the tank model of Varga & Keski-Honkola 2012. The energy balance of charging gives another temperature, see
    `isentrope_temperature`.

    .. math:: t = \frac{p_0}{K p_1} \left[\left(\frac{p}{p_0}\right)^{1/\kappa} - 1\right]

    Parameters
    ----------
    pressure, initial_pressure, supply_pressure : float or array
        Absolute pressures: final pressure p, at most b p1; pressure p0 in the vessel at the start; pressure p1 of the
        supply [Pa].
    critical_ratio : float or array
        Critical pressure ratio b of the flow path [1].
    rate : float or array
        Rate K from `charging_rate` at the initial temperature [1/s].
    isentropic_exponent : float or array
        Ratio of the heat capacities; the polytropic exponent for a polytropic tank [1].

    Returns
    -------
    float or array
        Time since opening [s].

    Raises
    ------
    OutOfRangeError
        If the flow is not choked at the final pressure.

    Notes
    -----
    The density increases linearly with time. There is no closed form for subsonic flow.

    Examples
    --------
    >>> print(f"{isentrope_choked_charging_time(2.9e5, 1e5, 7e5, 0.427355, 0.0082268):.2f} s")
    19.78 s
    """
    if not np.all(pressure <= critical_ratio * supply_pressure):
        limit = critical_ratio * supply_pressure
        raise OutOfRangeError("tanks.no_longer_choked", "pressure", value=pressure, limit=limit)
    growth = (pressure / initial_pressure) ** (1.0 / isentropic_exponent) - 1.0
    return initial_pressure / supply_pressure * growth / rate


def _subsonic_angle(ratio: Any, critical_ratio: Any) -> Any:
    """Return the angle that describes a pressure ratio on the quarter ellipse [rad].

    The quarter ellipse is the subsonic part of the flow law: the sine of the angle is (r - b)/(1 - b) for the pressure
    ratio r. The angle is zero for choked flow.
    """
    return np.arcsin(np.clip((ratio - critical_ratio) / (1.0 - critical_ratio), 0.0, 1.0))
