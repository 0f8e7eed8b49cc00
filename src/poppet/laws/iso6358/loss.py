"""Pressure loss of an ISO 6358 flow path for a given flow of gas with inertia."""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import clip, maximum, minimum
from poppet.laws.iso6358.regularisation import smoothed_upstream_temperature


def loss_coefficient(pressure_1: Any, pressure_2: Any, choked_flow: Any, critical_ratio: Any) -> Any:
    r"""Return the coefficient :math:`K` of the pressure loss :math:`K q |q|` of a flow path.

    The loss equals the pressure difference p1 - p2 if :math:`q` is the flow of ISO 6358 with m = 0.5.

    .. math:: K = \frac{(1 - b)\, p_1}{q_c^2} \frac{\max(1, x)}{2 - \min(1, x)}, \qquad
              x = \frac{|p_1 - p_2|}{(1 - b)\, p_1}

    with p1 the higher pressure.

    Parameters
    ----------
    pressure_1, pressure_2 : float, array or symbol
        Absolute pressures at the ports [Pa].
    choked_flow : float, array or symbol
        Choked mass flow rate with the higher pressure upstream [kg/s].
    critical_ratio : float, array or symbol
        Critical pressure ratio b [1].

    Returns
    -------
    float, array or symbol
        Coefficient K [Pa s^2/kg^2].

    Notes
    -----
    K is finite at equal pressures, although the slope of the flow law is infinite there. For choked flow (x > 1), K
    increases with the pressure drop, so the flow does not exceed the choked flow at any drop.

    Examples
    --------
    >>> q = 0.01 * (1.0 - ((0.8 - 0.3) / 0.7) ** 2) ** 0.5
    >>> round(loss_coefficient(5e5, 4e5, 0.01, 0.3) * q * q)
    100000
    """
    upstream = maximum(pressure_1, pressure_2)
    span = (1.0 - critical_ratio) * upstream
    x = abs(pressure_1 - pressure_2) / span
    return span / choked_flow**2 * maximum(x, 1.0) / (2.0 - minimum(x, 1.0))


def temperature_of_flow(mass_flow_rate: Any, choked_flow: Any, temperature_1: Any, temperature_2: Any) -> Any:
    """Return the stagnation temperature of a flow of gas with inertia.

    It is the temperature of the upstream gas, with a smooth transition at flow reversal. The mass flow rate is a state
    variable and determines which side is upstream.

    Parameters
    ----------
    mass_flow_rate, choked_flow : float, array or symbol
        Mass flow rate from port 1 to port 2, and choked mass flow rate [kg/s]. The temperature changes smoothly while
        the flow is below 1e-3 of the choked flow.
    temperature_1, temperature_2 : float, array or symbol
        Stagnation temperatures at the ports [K].

    Returns
    -------
    float, array or symbol
        Temperature [K].

    Notes
    -----
    The upstream side follows from the sign of the flow, because gas with inertia can flow against the pressure drop.
    `upstream_temperature` determines it from the pressures.

    Examples
    --------
    >>> temperature_of_flow(-1e-3, 1e-2, 300.0, 280.0)
    280.0
    """
    return smoothed_upstream_temperature(clip(mass_flow_rate / choked_flow, -1.0, 1.0), temperature_1, temperature_2)
