"""Rates of the pressure in a chamber with open valves, and valve openings for a required rate.

The laws accept floats and symbols. The flow of ISO 6358 is proportional to the conductance. The inverse for the
opening is therefore a quotient in every regime: choked, subsonic, and the regularised zone near equal pressures.
"""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import clip, maximum, minimum, where
from poppet.laws import iso6358

_NO_RATE = 1e-9
"""Pressure rate below which an open valve has no effect on a chamber [Pa/s]."""


def pressure_rate(mass_flow_rate: Any, temperature: Any, *, volume: Any, exponent: Any, gas_constant: Any) -> Any:
    r"""Return the rate of change of the pressure in a chamber with one gas flow.

    .. math:: \dot p = \frac{n R T}{V} q

    Parameters
    ----------
    mass_flow_rate : float or symbol
        Mass flow rate q into the chamber [kg/s].
    temperature : float or symbol
        Temperature T of the gas upstream of the flow [K].
    volume : float or symbol
        Volume V of the chamber [m^3].
    exponent : float or symbol
        Exponent n [1]: the isentropic exponent for an adiabatic chamber, 1 for an isothermal chamber.
    gas_constant : float or symbol
        Specific gas constant [J/(kg K)].

    Returns
    -------
    float or symbol
        Rate of change of the pressure [Pa/s].

    Notes
    -----
    The law is exact for an adiabatic chamber (n = kappa), and for an isothermal chamber (n = 1) whose temperature is
    that of the inflow. Heat flow from the wall is not included.

    Examples
    --------
    >>> round(pressure_rate(1e-3, 293.15, volume=1e-3, exponent=1.0, gas_constant=287.05))
    84149
    """
    return exponent * gas_constant * temperature / volume * mass_flow_rate


def open_rates(
    pressure: Any,
    supply_pressure: Any,
    exhaust_pressure: Any,
    *,
    gas_temperature: Any,
    supply_temperature: Any,
    fill: tuple[Any, Any],
    vent: tuple[Any, Any],
    volume: Any,
    exponent: Any,
    gas_constant: Any,
    subsonic_index: Any = 0.5,
    laminar_ratio: Any = iso6358.LAMINAR_RATIO,
) -> tuple[Any, Any]:
    r"""Return the pressure rates of a chamber with only its fill valve or only its vent valve fully open.

    .. math:: r_f = \frac{n R T_s}{V} q(p_s, p), \qquad r_v = \frac{n R T}{V} q(p, p_e)

    Parameters
    ----------
    pressure, supply_pressure, exhaust_pressure : float or symbol
        Absolute pressures of chamber, supply and exhaust [Pa].
    gas_temperature, supply_temperature : float or symbol
        Temperatures T of the gas in the chamber and :math:`T_s` in the supply [K].
    fill, vent : tuple of float or symbol, shape (2,)
        Sonic conductance [m^3/(s Pa)] and critical pressure ratio [1] of the open fill valve and of the open vent
        valve.
    volume : float or symbol
        Volume of the chamber [m^3].
    exponent : float or symbol
        Exponent n of `pressure_rate` [1].
    gas_constant : float or symbol
        Specific gas constant [J/(kg K)].
    subsonic_index, laminar_ratio : float or symbol, optional
        Subsonic index m and laminar ratio of both valves, see `poppet.laws.iso6358.mass_flow_rate` [1].

    Returns
    -------
    fill_rate, vent_rate : float or symbol
        Rate of increase with the fill valve open, and rate of decrease with the vent valve open [Pa/s]. They are not
        negative: if the supply pressure is below the chamber pressure, the fill rate is 0.

    References
    ----------
    ISO 6358-1:2013, the law of `poppet.laws.iso6358.mass_flow_rate`.

    Examples
    --------
    >>> valves = {"fill": (1e-8, 0.3), "vent": (1e-8, 0.3), "volume": 1e-3, "exponent": 1.0, "gas_constant": 287.05}
    >>> rates = open_rates(2e5, 7e5, 1e5, gas_temperature=293.15, supply_temperature=293.15, **valves)
    >>> [round(rate) for rate in rates]
    [698014, 191119]
    """
    shape = {"subsonic_index": subsonic_index, "laminar_ratio": laminar_ratio}
    vessel = {"volume": volume, "exponent": exponent, "gas_constant": gas_constant}

    def rate(ends: tuple[Any, Any], temperature: Any, size: tuple[Any, Any]) -> Any:
        flow = iso6358.mass_flow_rate(*ends, temperature, sonic_conductance=size[0], critical_ratio=size[1], **shape)
        # The flow law has both directions; a flow against the purpose of the valve gives a rate of 0.
        return maximum(pressure_rate(flow, temperature, **vessel), 0.0)

    return rate((supply_pressure, pressure), supply_temperature, fill), rate(
        (pressure, exhaust_pressure), gas_temperature, vent
    )


def openings_for_rate(
    rate: Any, fill_rate: Any, vent_rate: Any, *, fill_limit: Any = 1.0, vent_limit: Any = 1.0
) -> tuple[Any, Any]:
    r"""Return the openings of fill and vent valve that give a required pressure rate.

    .. math:: a_f = \operatorname{clip}(r/r_f, 0, a_{f,max}), \qquad a_v = \operatorname{clip}(-r/r_v, 0, a_{v,max})

    Parameters
    ----------
    rate : float or symbol
        Required rate of change r of the pressure [Pa/s].
    fill_rate, vent_rate : float or symbol
        Rates :math:`r_f` and :math:`r_v` with one valve fully open, from `open_rates` [Pa/s].
    fill_limit, vent_limit : float or symbol, optional
        Maximum openings, from 0 to 1 [1].

    Returns
    -------
    fill, vent : float or symbol
        Openings of the fill and the vent valve [1]. At least one is zero. A valve whose rate is zero remains closed.

    Examples
    --------
    >>> openings_for_rate(1e5, 4e5, 2e5), openings_for_rate(-1e5, 4e5, 2e5), openings_for_rate(9e5, 4e5, 2e5)
    ((0.25, 0.0), (0.0, 0.5), (1.0, 0.0))
    """

    def opening(requested: Any, possible: Any, limit: Any) -> Any:
        # Symbols evaluate both branches of a choice, so the quotient must always be finite.
        share = clip(requested / maximum(possible, _NO_RATE), 0.0, 1.0)
        return where(possible > _NO_RATE, minimum(share, limit), 0.0)

    return opening(rate, fill_rate, fill_limit), opening(-rate, vent_rate, vent_limit)
