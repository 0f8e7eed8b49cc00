"""Inverse flow law: pressures from a flow, and flow parameters from a measured point.

The functions accept floats and arrays. They use closed forms where these exist. The regularised zone, subsonic indices
other than 0.5 and cracking pressures need bisection, because the law is monotone in each pressure.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.laws.iso6358.domain import DOMAINS, Domain, check, reject_where
from poppet.laws.iso6358.evaluation import plain
from poppet.laws.iso6358.law import LAMINAR_RATIO, REFERENCE_DENSITY, REFERENCE_TEMPERATURE
from poppet.laws.iso6358.law import mass_flow_rate as flow_law
from poppet.laws.iso6358.regularisation import closing, edge_of_zone, ellipse, mass_flow_and_temperature, through_zero

Array = NDArray[np.float64]

_ROUNDING = 1e-9  # rounding error of b for an exact point with b = 0
_FRACTION = Domain("iso6358.subsonic_point", "", high=1.0, open_low=True)
_DOMAINS = DOMAINS | {
    "mass_flow_rate": Domain("iso6358.flow_backwards", "kg/s"),
    "sonic_conductance": Domain("iso6358.fixes_no_pressure", "m^3/(s Pa)", open_low=True),
}


def downstream_pressure(
    mass_flow_rate: Any,
    pressure_1: Any,
    temperature_1: Any,
    *,
    sonic_conductance: Any,
    critical_ratio: Any,
    subsonic_index: Any = 0.5,
    cracking_pressure: Any = 0.0,
    laminar_ratio: Any = LAMINAR_RATIO,
    one_way: bool = False,
    reference_density: Any = REFERENCE_DENSITY,
    reference_temperature: Any = REFERENCE_TEMPERATURE,
) -> Any:
    r"""Return the downstream pressure at which a flow path has a given flow.

    .. math::

        p_2 = p_1 \left[b + (1 - b - \Delta p_c/p_1) \sqrt{1 - \varphi^{1/m}}\right], \quad
        \varphi = \frac{q_m}{C \rho_0 p_1 \sqrt{T_0/T_1}} < 1

    Parameters
    ----------
    mass_flow_rate : float or array
        Mass flow rate from port 1 to port 2, not negative [kg/s].
    pressure_1, temperature_1 : float or array
        Absolute pressure [Pa] and stagnation temperature [K] upstream.
    sonic_conductance, critical_ratio : float or array
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1].
    subsonic_index, cracking_pressure : float or array, optional
        Subsonic index m [1], and pressure drop below which the flow path is closed [Pa].
    laminar_ratio : float or array, optional
        Pressure ratio p2/p1 above which the flow law is regularised [1]; there, the regularised law is inverted.
    one_way : bool, optional
        True for a check valve: no flow from port 2 to port 1.
    reference_density, reference_temperature : float or array, optional
        Density [kg/m^3] and temperature [K] of the reference atmosphere.

    Returns
    -------
    float or array
        Absolute downstream pressure; for zero flow, the lowest pressure at which the flow is zero [Pa].

    Raises
    ------
    OutOfRangeError
        If the flow equals or exceeds the choked flow. At choked flow, p2 can have any value from 0 to b p1.

    Notes
    -----
    Close to choking, the flow is insensitive to p2: a relative error e of the flow causes a relative error of
    about sqrt(2 e) of p2/p1.

    Examples
    --------
    >>> round(downstream_pressure(8.29327e-3, 5e5, 293.15, sonic_conductance=2e-8, critical_ratio=0.3))
    400000
    """
    arguments = dict(locals())
    del arguments["one_way"]
    number = _checked_arrays(arguments)
    choked = _choked_flow_per_pressure(number) * number["pressure_1"]
    reject_where(choked <= 0.0, "pressure_1", number["pressure_1"], "Pa", "iso6358.no_upstream")
    ratio = number["mass_flow_rate"] / choked
    reject_where(ratio >= 1.0, "mass_flow_rate", number["mass_flow_rate"], "kg/s", "iso6358.choked")
    downstream = number["pressure_1"] - _drop_for_ratio(ratio, number, one_way)
    too_much = (downstream < 0.0) & (ratio > 0.0)
    reject_where(too_much, "mass_flow_rate", number["mass_flow_rate"], "kg/s", "iso6358.below_vacuum")
    return plain(np.maximum(downstream, 0.0))


def upstream_pressure(
    mass_flow_rate: Any,
    pressure_2: Any,
    temperature_1: Any,
    *,
    sonic_conductance: Any,
    critical_ratio: Any,
    subsonic_index: Any = 0.5,
    cracking_pressure: Any = 0.0,
    laminar_ratio: Any = LAMINAR_RATIO,
    one_way: bool = False,
    reference_density: Any = REFERENCE_DENSITY,
    reference_temperature: Any = REFERENCE_TEMPERATURE,
) -> Any:
    r"""Return the upstream pressure for a given flow and downstream pressure of a flow path.

    For a subsonic index of m = 0.5 and no cracking pressure, with :math:`\pi = q_m/(C \rho_0 \sqrt{T_0/T_1})`, it is

    .. math::

        p_1 = \max\left(\pi,\ \frac{p_2^2 + (1-b)^2 \pi^2}{b p_2 + (1-b) \sqrt{p_2^2 + (1 - 2b) \pi^2}}\right)

    Parameters
    ----------
    mass_flow_rate : float or array
        Mass flow rate from the upstream port 1 to the downstream port 2, not negative [kg/s].
    pressure_2, temperature_1 : float or array
        Absolute pressure downstream [Pa], stagnation temperature upstream [K].
    sonic_conductance, critical_ratio : float or array
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1].
    subsonic_index, cracking_pressure : float or array, optional
        Subsonic index m [1], and pressure drop below which the flow path is closed [Pa].
    laminar_ratio : float or array, optional
        Pressure ratio p2/p1 above which the flow law is regularised [1]; there, the regularised law is inverted.
    one_way : bool, optional
        True for a check valve: no flow from port 2 to port 1.
    reference_density, reference_temperature : float or array, optional
        Density [kg/m^3] and temperature [K] of the reference atmosphere.

    Returns
    -------
    float or array
        Absolute upstream pressure; for zero flow, the highest pressure at which the flow is zero [Pa].

    Notes
    -----
    The upstream pressure is unique for each flow, because choked flow is proportional to it.

    Examples
    --------
    >>> round(upstream_pressure(8.29327e-3, 4e5, 293.15, sonic_conductance=2e-8, critical_ratio=0.3))
    500000
    """
    arguments = dict(locals())
    del arguments["one_way"]
    number = _checked_arrays(arguments)
    choking = number["mass_flow_rate"] / _choked_flow_per_pressure(number)
    if np.any(number["subsonic_index"] != 0.5) or np.any(number["cracking_pressure"] != 0.0):
        return plain(_upstream_by_bisection(choking, number, one_way))
    # At the edge of the zone both laws agree; this closed form of the ellipse is faster than the bisection.
    b = number["critical_ratio"]
    # at p2 = b choking the formula gives just `choking`, so raising p2 to it covers the choked branch
    downstream = np.maximum(number["pressure_2"], b * choking)
    root = np.sqrt(np.maximum(downstream**2 + (1.0 - 2.0 * b) * choking**2, 0.0))
    divisor = b * downstream + (1.0 - b) * root
    upstream = (downstream**2 + ((1.0 - b) * choking) ** 2) / np.where(divisor > 0.0, divisor, 1.0)
    in_zone = number["pressure_2"] > number["laminar_ratio"] * upstream
    if in_zone.any():
        upstream = np.where(in_zone, _upstream_by_bisection(choking, number, one_way), upstream)
    return plain(upstream)


def sonic_conductance_from_flow(
    mass_flow_rate: Any,
    pressure_1: Any,
    pressure_2: Any,
    temperature_1: Any,
    temperature_2: Any = None,
    *,
    critical_ratio: Any,
    subsonic_index: Any = 0.5,
    cracking_pressure: Any = 0.0,
    laminar_ratio: Any = LAMINAR_RATIO,
    one_way: bool = False,
    reference_density: Any = REFERENCE_DENSITY,
    reference_temperature: Any = REFERENCE_TEMPERATURE,
) -> Any:
    r"""Return the sonic conductance of a flow path with known b from a measured flow.

    .. math:: C = q_m / q_m(C = 1)

    Parameters
    ----------
    mass_flow_rate : float or array
        Measured mass flow rate, positive from port 1 to port 2 [kg/s].
    pressure_1, pressure_2 : float or array
        Absolute pressures at the ports [Pa].
    temperature_1 : float or array
        Stagnation temperature at port 1 [K].
    temperature_2 : float or array, optional
        Stagnation temperature at port 2 [K] (default: `temperature_1`).
    critical_ratio : float or array
        Critical pressure ratio b, which has no effect if the flow is choked [1].
    subsonic_index, cracking_pressure : float or array, optional
        Subsonic index m [1], and pressure drop below which the flow path is closed [Pa].
    laminar_ratio : float or array, optional
        Pressure ratio p2/p1 above which the flow law is regularised [1].
    one_way : bool, optional
        True for a check valve: no flow from port 2 to port 1.
    reference_density, reference_temperature : float or array, optional
        Density [kg/m^3] and temperature [K] of the reference atmosphere.

    Returns
    -------
    float or array
        Sonic conductance [m^3/(s Pa)].

    Raises
    ------
    OutOfRangeError
        If the flow path is closed at these pressures, or the flow is opposite to the pressure drop.

    Notes
    -----
    One measured point of subsonic flow does not determine both C and b: measure a choked flow, or assume b.

    Examples
    --------
    >>> round(sonic_conductance_from_flow(8.29327e-3, 5e5, 4e5, 293.15, critical_ratio=0.3), 13)
    2e-08
    """
    arguments = dict(locals())
    del arguments["mass_flow_rate"]
    per_conductance = flow_law(**arguments, sonic_conductance=1.0)
    measured = np.asarray(plain(mass_flow_rate))
    reject_where(per_conductance == 0.0, "mass_flow_rate", measured, "kg/s", "iso6358.closed_here")
    reject_where(measured * per_conductance < 0.0, "mass_flow_rate", measured, "kg/s", "iso6358.runs_uphill")
    return plain(measured / per_conductance)


def effective_conductance(
    mass_flow_rate: Any,
    pressure_1: Any,
    temperature_1: Any,
    *,
    reference_density: Any = REFERENCE_DENSITY,
    reference_temperature: Any = REFERENCE_TEMPERATURE,
) -> Any:
    r"""Return the sonic conductance of a flow path for which a measured flow would be choked.

    .. math:: C_e = \frac{q_m}{\rho_0 p_1 \sqrt{T_0/T_1}}

    Parameters
    ----------
    mass_flow_rate : float or array
        Mass flow rate from the upstream to the downstream side [kg/s].
    pressure_1, temperature_1 : float or array
        Absolute pressure, above zero [Pa], and stagnation temperature [K] upstream.
    reference_density, reference_temperature : float or array, optional
        Density [kg/m^3] and temperature [K] of the reference atmosphere.

    Returns
    -------
    float or array
        Effective conductance: it equals C if the flow is choked, and is less than C otherwise [m^3/(s Pa)].

    References
    ----------
    ISO 6358-1:2013, definition of the conductance.

    Examples
    --------
    >>> round(effective_conductance(8.29327e-3, 5e5, 293.15), 12)
    1.3997e-08
    """
    arguments = dict(locals())
    upstream = {"pressure_1": Domain("iso6358.upstream", "Pa", open_low=True)}
    number = _checked_arrays(arguments, _DOMAINS | upstream)
    root = np.sqrt(number["reference_temperature"] / number["temperature_1"])
    return plain(number["mass_flow_rate"] / (number["reference_density"] * number["pressure_1"] * root))


def critical_ratio_from_point(pressure_ratio: Any, flow_ratio: Any, subsonic_index: Any = 0.5) -> Any:
    r"""Return the critical pressure ratio b from one measured point of subsonic flow.

    .. math:: b = \frac{r - s}{1 - s} = 1 - \frac{1 - r}{1 - s}, \quad s = \sqrt{1 - \varphi^{1/m}}

    Parameters
    ----------
    pressure_ratio, flow_ratio : float or array
        Pressure ratio r = p2/p1, and flow divided by the choked flow at the same upstream state, :math:`\varphi`; both
        between 0 and 1.
    subsonic_index : float or array, optional
        Subsonic index m [1].

    Returns
    -------
    float or array
        Critical pressure ratio b.

    Raises
    ------
    OutOfRangeError
        If the point is choked or closed, or if b would be negative.

    Notes ----- The cracking pressure is assumed to be zero. For m = 0.5, the standard uncertainty u(b) follows from the
    standard uncertainties of r and phi: u(b)^2 = (u_r/(1 - s))^2 + ((1 - r)/(1 - s)^2 (phi/s) u_phi)^2. Points near r =
    1 or phi = 1 contain the least information on b.

    References
    ----------
    ISO 6358-1:2013, evaluation of the critical back-pressure ratio.

    Examples
    --------
    >>> round(critical_ratio_from_point(0.8, 0.699854), 4)
    0.3
    """
    number = _checked_arrays(dict(locals()), DOMAINS | {"pressure_ratio": _FRACTION, "flow_ratio": _FRACTION})
    squared = number["flow_ratio"] ** (1.0 / number["subsonic_index"])
    # 1 - s = squared/(1 + s) keeps its digits for small flows, where s is nearly 1
    ratio = 1.0 - (1.0 - number["pressure_ratio"]) * (1.0 + np.sqrt(1.0 - squared)) / squared
    reject_where(ratio < -_ROUNDING, "flow_ratio", number["flow_ratio"], "", "iso6358.below_the_curve")
    return plain(np.maximum(ratio, 0.0))


def _checked_arrays(arguments: dict[str, Any], domains: dict[str, Domain] = _DOMAINS) -> dict[str, Array]:
    """Check all arguments and return them as float arrays.

    A float becomes a zero-dimensional array.
    """
    check(arguments, domains)
    return {name: np.asarray(value, dtype=float) for name, value in arguments.items()}


def _choked_flow_per_pressure(number: dict[str, Array]) -> Array:
    root = np.sqrt(number["reference_temperature"] / number["temperature_1"])
    return number["sonic_conductance"] * number["reference_density"] * root


def _drop_for_ratio(ratio: Array, number: dict[str, Array], one_way: bool) -> Array:
    """Return the pressure drop for a given fraction of the choked flow [Pa].

    `ratio` is this fraction, below 1. `number` contains the upstream pressure and the parameters of the flow path by
    name.
    """
    width = 1.0 - number["laminar_ratio"]
    cracking = number["cracking_pressure"] / number["pressure_1"]
    span, edge, slope = edge_of_zone(number["critical_ratio"], number["subsonic_index"], cracking, width)
    at_edge = ellipse(edge, number["subsonic_index"])
    squared = ratio ** (1.0 / number["subsonic_index"])
    # 1 - sqrt(1 - s) = s/(1 + sqrt(1 - s)), which loses no digits for small flows.
    excess = span * squared / (1.0 + np.sqrt(1.0 - squared))
    if np.any(ratio < at_edge):
        odd = (number["cracking_pressure"] == 0.0) & (not one_way)

        def shape(z: Array) -> Array:
            ratio_in_zone: Array = np.where(odd, through_zero(z, slope), closing(z, slope))
            return ratio_in_zone

        within = np.minimum(ratio / at_edge, 1.0)
        zone = width * _rising_root(shape, within, np.zeros_like(within), np.ones_like(within))
        excess = np.where(ratio < at_edge, zone, excess)
    drop: Array = number["pressure_1"] * (cracking + excess)
    return drop


def _upstream_by_bisection(choking: Array, number: dict[str, Array], one_way: bool) -> Array:
    names = ("critical_ratio", "subsonic_index", "cracking_pressure", "laminar_ratio")
    shape: dict[str, Any] = {name: number[name] for name in names}
    # With ones for all that scales the flow, what is left is the driving pressure.
    shape |= {"sonic_conductance": 1.0, "reference_density": 1.0, "reference_temperature": 1.0}

    def driven(pressure_1: Array) -> Array:
        flow, _ = mass_flow_and_temperature(pressure_1, number["pressure_2"], 1.0, None, one_way=one_way, **shape)
        return np.asarray(flow)

    low = number["pressure_2"] + number["cracking_pressure"] + np.zeros_like(choking)
    # The choking pressure is a lower bound; doubling finds an upper bound for subsonic flow.
    high = np.maximum(low, choking)
    while np.any(driven(high) < choking):
        high = np.where(driven(high) < choking, 2.0 * high, high)
    return np.where(choking > 0.0, _rising_root(driven, choking, low, high), low)


def _rising_root(function: Callable[[Array], Array], target: Array, low: Array, high: Array) -> Array:
    """Return the argument at which an increasing function has the value `target`.

    The search is a bisection between `low` and `high`.
    """
    # Not Newton's method: the slope of the law is zero where a flow path closes.
    for _ in range(60):
        middle = 0.5 * (low + high)
        is_below = function(middle) < target
        low, high = np.where(is_below, middle, low), np.where(is_below, high, middle)
    return 0.5 * (low + high)
