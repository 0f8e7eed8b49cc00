"""The flow law solved for one of its pressures.

Floats and arrays only. Closed forms where they exist; the regularised zone, exponents other than 0.5 and
cracking pressures are solved by bisection, because the law is monotone in each pressure.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from poppet.laws.iso6358.domain import DOMAINS, Domain, check, refuse_where
from poppet.laws.iso6358.law import LAMINAR_RATIO, REFERENCE_DENSITY, REFERENCE_TEMPERATURE
from poppet.laws.iso6358.regularisation import (
    closing,
    edge_of_zone,
    ellipse,
    mass_flow_and_temperature,
    through_zero,
)

INVERSE_DOMAINS = DOMAINS | {
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
    r"""Pressure behind a passage that carries a given flow.

    .. math::

        p_2 = p_1 \left[b + (1 - b - \Delta p_c/p_1) \sqrt{1 - \varphi^{1/m}}\right], \quad
        \varphi = \frac{q_m}{C \rho_0 p_1 \sqrt{T_0/T_1}} < 1

    Parameters
    ----------
    mass_flow_rate : float or array
        From the upstream side 1 to the downstream side 2, not below zero [kg/s].
    pressure_1 : float or array
        Absolute upstream pressure [Pa].
    temperature_1 : float or array
        Upstream stagnation temperature [K].
    sonic_conductance : float or array
        C [m^3/(s Pa)].
    critical_ratio : float or array
        b.
    subsonic_index : float or array, optional
        m.
    cracking_pressure : float or array, optional
        Pressure drop below which the passage is closed [Pa].
    laminar_ratio : float or array, optional
        Pressure ratio at which the regularised zone begins; inside it the regularised law is inverted.
    one_way : bool, optional
        A check valve.
    reference_density : float or array, optional
        Density in the reference atmosphere [kg/m^3].
    reference_temperature : float or array, optional
        Temperature in the reference atmosphere [K].

    Returns
    -------
    float or array
        Absolute downstream pressure; for zero flow the lowest one that stops it [Pa].

    Raises
    ------
    OutOfRangeError
        For a choked flow, which leaves p2 undetermined (anything from 0 to b p1), and for more than that.

    Notes
    -----
    Close to choking the flow hardly depends on p2: a relative error e of the flow becomes one of about sqrt(2
    e) in p2/p1.

    Examples
    --------
    >>> round(downstream_pressure(8.29327e-3, 5e5, 293.15, sonic_conductance=2e-8, critical_ratio=0.3))
    400000
    """
    given = {
        "mass_flow_rate": mass_flow_rate,
        "pressure_1": pressure_1,
        "temperature_1": temperature_1,
        "sonic_conductance": sonic_conductance,
        "critical_ratio": critical_ratio,
        "subsonic_index": subsonic_index,
        "cracking_pressure": cracking_pressure,
        "laminar_ratio": laminar_ratio,
        "reference_density": reference_density,
        "reference_temperature": reference_temperature,
    }
    number = checked_arrays(given)
    choked = _choked_flow_per_pressure(number) * number["pressure_1"]
    refuse_where(choked <= 0.0, "pressure_1", number["pressure_1"], "Pa", "iso6358.no_upstream")
    ratio = number["mass_flow_rate"] / choked
    refuse_where(ratio >= 1.0, "mass_flow_rate", number["mass_flow_rate"], "kg/s", "iso6358.choked")
    downstream = number["pressure_1"] - _drop_for_ratio(ratio, number, one_way)
    refuse_where(
        (downstream < 0.0) & (ratio > 0.0),
        "mass_flow_rate",
        number["mass_flow_rate"],
        "kg/s",
        "iso6358.below_vacuum",
    )
    return as_given(np.maximum(downstream, 0.0))


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
    r"""Pressure before a passage that drives a given flow against a downstream pressure.

    With :math:`\pi = q_m/(C \rho_0 \sqrt{T_0/T_1})`, m = 0.5 and no cracking pressure

    .. math::

        p_1 = \max\left(\pi,\ \frac{p_2^2 + (1-b)^2 \pi^2}{b p_2 + (1-b) \sqrt{p_2^2 + (1 - 2b) \pi^2}}\right)

    Parameters
    ----------
    mass_flow_rate : float or array
        From the upstream side 1 to the downstream side 2, not below zero [kg/s].
    pressure_2 : float or array
        Absolute downstream pressure [Pa].
    temperature_1 : float or array
        Upstream stagnation temperature [K].
    sonic_conductance : float or array
        C [m^3/(s Pa)].
    critical_ratio : float or array
        b.
    subsonic_index : float or array, optional
        m.
    cracking_pressure : float or array, optional
        Pressure drop below which the passage is closed [Pa].
    laminar_ratio : float or array, optional
        Pressure ratio at which the regularised zone begins; inside it the regularised law is inverted.
    one_way : bool, optional
        A check valve.
    reference_density : float or array, optional
        Density in the reference atmosphere [kg/m^3].
    reference_temperature : float or array, optional
        Temperature in the reference atmosphere [K].

    Returns
    -------
    float or array
        Absolute upstream pressure; for zero flow the highest one that does not start it [Pa].

    Notes
    -----
    Unlike the downstream pressure it is determined by every flow: a choked flow is proportional to it.

    Examples
    --------
    >>> round(upstream_pressure(8.29327e-3, 4e5, 293.15, sonic_conductance=2e-8, critical_ratio=0.3))
    500000
    """
    given = {
        "mass_flow_rate": mass_flow_rate,
        "pressure_2": pressure_2,
        "temperature_1": temperature_1,
        "sonic_conductance": sonic_conductance,
        "critical_ratio": critical_ratio,
        "subsonic_index": subsonic_index,
        "cracking_pressure": cracking_pressure,
        "laminar_ratio": laminar_ratio,
        "reference_density": reference_density,
        "reference_temperature": reference_temperature,
    }
    number = checked_arrays(given)
    choking = number["mass_flow_rate"] / _choked_flow_per_pressure(number)
    if np.any(number["subsonic_index"] != 0.5) or np.any(number["cracking_pressure"] != 0.0):
        return as_given(_upstream_by_bisection(choking, number, one_way))
    upstream = _upstream_in_closed_form(choking, number)
    in_zone = number["pressure_2"] > number["laminar_ratio"] * upstream
    if in_zone.any():
        upstream = np.where(in_zone, _upstream_by_bisection(choking, number, one_way), upstream)
    return as_given(upstream)


def checked_arrays(given: dict[str, Any], domains: dict[str, Domain] = INVERSE_DOMAINS) -> dict[str, Any]:
    """All numbers checked and as float arrays, zero-dimensional for floats."""
    check(given, domains)
    return {name: np.asarray(value, dtype=float) for name, value in given.items()}


def as_given(value: Any) -> Any:
    """A float for zero-dimensional results, else the array."""
    array = np.asarray(value)
    return array if array.ndim else float(array)


def _choked_flow_per_pressure(number: dict[str, Any]) -> Any:
    root = np.sqrt(number["reference_temperature"] / number["temperature_1"])
    return number["sonic_conductance"] * number["reference_density"] * root


def _drop_for_ratio(ratio: Any, number: dict[str, Any], one_way: bool) -> Any:
    """Pressure drop that carries the fraction `ratio` < 1 of the choked flow [Pa]."""
    width = 1.0 - number["laminar_ratio"]
    cracking = number["cracking_pressure"] / number["pressure_1"]
    span, edge, slope = edge_of_zone(number["critical_ratio"], number["subsonic_index"], cracking, width)
    at_edge = ellipse(edge, number["subsonic_index"])
    squared = ratio ** (1.0 / number["subsonic_index"])
    excess = span * squared / (1.0 + np.sqrt(1.0 - squared))
    if np.any(ratio < at_edge):
        odd = (number["cracking_pressure"] == 0.0) & (not one_way)

        def shape(z: Any) -> Any:
            return np.where(odd, through_zero(z, slope), closing(z, slope))

        within = np.minimum(ratio / at_edge, 1.0)
        zone = width * _rising_root(shape, within, np.zeros_like(within), np.ones_like(within))
        excess = np.where(ratio < at_edge, zone, excess)
    return number["pressure_1"] * (cracking + excess)


def _upstream_in_closed_form(choking: Any, number: dict[str, Any]) -> Any:
    """Upstream pressure outside the zone for m = 0.5; `choking` is what would carry the flow choked [Pa]."""
    b = number["critical_ratio"]
    # at p2 = b choking the formula gives just `choking`, so raising p2 to it covers the choked branch
    pressure_2 = np.maximum(number["pressure_2"], b * choking)
    root = np.sqrt(np.maximum(pressure_2**2 + (1.0 - 2.0 * b) * choking**2, 0.0))
    divisor = b * pressure_2 + (1.0 - b) * root
    return (pressure_2**2 + ((1.0 - b) * choking) ** 2) / np.where(divisor > 0.0, divisor, 1.0)


def _upstream_by_bisection(choking: Any, number: dict[str, Any], one_way: bool) -> Any:
    shape = {name: number[name] for name in ("critical_ratio", "subsonic_index", "cracking_pressure", "laminar_ratio")}
    # With ones for all that scales the flow, what is left is the driving pressure.
    shape |= {"sonic_conductance": 1.0, "reference_density": 1.0, "reference_temperature": 1.0}

    def driven(pressure_1: Any) -> Any:
        return mass_flow_and_temperature(pressure_1, number["pressure_2"], 1.0, None, one_way=one_way, **shape)[0]

    low = number["pressure_2"] + number["cracking_pressure"] + np.zeros_like(choking)
    high = np.maximum(low, choking)
    while np.any(driven(high) < choking):
        high = np.where(driven(high) < choking, 2.0 * high, high)
    return np.where(choking > 0.0, _rising_root(driven, choking, low, high), low)


def _rising_root(function: Callable[[Any], Any], target: Any, low: Any, high: Any) -> Any:
    """Where a rising function meets `target`: halved until a double holds no more digits."""
    for _ in range(60):
        middle = 0.5 * (low + high)
        below = function(middle) < target
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return 0.5 * (low + high)
