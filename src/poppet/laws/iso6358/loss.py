"""The law of ISO 6358 read the other way: the drop that belongs to a flow, for gas that has inertia."""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import clip, maximum, minimum
from poppet.laws.iso6358.regularisation import carried_temperature


def loss_coefficient(pressure_1: Any, pressure_2: Any, choked_flow: Any, critical_ratio: Any) -> Any:
    r"""Return K, the coefficient of the loss :math:`K q |q|` that equals p1 - p2.

    The flow is that of ISO 6358 with m = 0.5.

    .. math:: K = \frac{(1 - b)\, p_1}{q_c^2} \frac{\max(1, x)}{2 - \min(1, x)}, \qquad
              x = \frac{|p_1 - p_2|}{(1 - b)\, p_1}

    with p1 the higher pressure.

    Parameters
    ----------
    pressure_1, pressure_2 : float, array or symbol
        Absolute pressures at the ports [Pa].
    choked_flow : float, array or symbol
        Mass flow rate when choked with the higher pressure upstream [kg/s].
    critical_ratio : float, array or symbol
        b.

    Returns
    -------
    float, array or symbol
        [Pa s^2/kg^2].

    Notes
    -----
    Finite at equal pressures, where the flow law itself has an infinite slope. Beyond choking (x > 1) it grows with
    the drop, so that no drop holds a flow above the choked one for long.

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
    """Return the stagnation temperature of a flow that is a state.

    It is the temperature of the upstream side, smoothed at flow reversal.

    Parameters
    ----------
    mass_flow_rate, choked_flow : float, array or symbol
        Flow from 1 to 2, and the choked flow, to which the width of the turn refers: 1e-3 of it [kg/s].
    temperature_1, temperature_2 : float, array or symbol
        Stagnation temperatures at the ports [K].

    Returns
    -------
    float, array or symbol
        [K].

    Notes
    -----
    As `upstream_temperature`, which goes by the pressures: gas with inertia flows on against them.

    Examples
    --------
    >>> temperature_of_flow(-1e-3, 1e-2, 300.0, 280.0)
    280.0
    """
    return carried_temperature(clip(mass_flow_rate / choked_flow, -1.0, 1.0), temperature_1, temperature_2)
