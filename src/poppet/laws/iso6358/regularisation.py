"""Formulas of the flow law for floats, arrays and symbols; arguments are not checked.

Near closing, all formulas depend on one quantity, `(|p1 - p2| - cracking_pressure)/p_up`. It is the excess pressure
drop divided by the upstream pressure. The ellipse `1 - u^2` is then `x (2 - x)`. This form loses no digits near equal
pressures and keeps the traced expression small.
"""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import clip, is_array, is_symbolic, maximum, minimum, sqrt, where

_VACUUM = 1e-30
"""Upstream pressure if both sides are evacuated, to avoid 0/0 [Pa]."""

TURN = 1e-3
"""Fraction of the width of the zone in which the temperature of the flow changes at flow reversal.

Slow flows stay in the zone for long (end of filling, leaks, cooling tanks). Smoothing over the complete zone gave an
error of 1.4 K in a 2 l tank after 10 s. Without smoothing, some stiff networks chatter at zero flow.
"""


def upstream_pressure_and_drop(pressure_1: Any, pressure_2: Any) -> tuple[Any, Any]:
    """Return the upstream pressure [Pa], and the relative pressure drop.

    The relative drop is the signed pressure drop divided by the upstream pressure, between -1 and 1. It is 0 if both
    pressures are 0.
    """
    upstream = maximum(maximum(pressure_1, pressure_2), _VACUUM)
    return upstream, (pressure_1 - pressure_2) / upstream


def edge_of_zone(critical_ratio: Any, subsonic_index: Any, cracking: Any, width: Any) -> tuple[Any, Any, Any]:
    """Return properties of the flow law at the edge of the regularised zone.

    The zone is the range of pressure ratios near zero flow in which a polynomial replaces the law. The properties are
    the span of p2/p1 from choked flow to zero flow, the position of the edge within this span, and the logarithmic
    slope of the law at the edge.

    If b is inside the zone, the span is the width of the zone, the edge is 1 and the slope is 0. The flow is then
    choked up to the edge of the zone.

    Parameters
    ----------
    critical_ratio : float, array or symbol
        Critical pressure ratio b [1].
    subsonic_index : float, array or symbol
        Subsonic index m [1].
    cracking : float, array or symbol
        Cracking pressure divided by the upstream pressure.
    width : float, array or symbol
        Width of the zone in p2/p1.

    Returns
    -------
    span, edge, slope : float, array or symbol
        Span in p2/p1, distance of the edge from zero flow as a fraction of the span, and slope at the edge [1].
    """
    span = maximum(1.0 - cracking - critical_ratio, width)
    edge = width / span
    return span, edge, 2.0 * subsonic_index * (1.0 - edge) / (2.0 - edge)


def ellipse(position: Any, subsonic_index: Any) -> Any:
    """Return `(1 - u^2)^m`, the elliptic part of the flow law.

    The argument `position` is `1 - u`, and `subsonic_index` is m. For floats, a square root replaces the power if m =
    0.5; for symbols, the generator of the compiled code does this.
    """
    base = position * (2.0 - position)
    if not is_symbolic(base, subsonic_index) and not is_array(subsonic_index) and subsonic_index == 0.5:
        return sqrt(base)
    return base**subsonic_index


def through_zero(z: Any, slope: Any) -> Any:
    """Return an odd cubic polynomial of z with the slope `slope` at z = 1.

    Its value is 0 at z = 0 and 1 at z = 1. It regularises flow in both directions.
    """
    return z * (1.0 + (1.0 - z * z) * (0.5 - 0.5 * slope))


def closing(z: Any, slope: Any) -> Any:
    """Return a cubic polynomial of z whose value and slope are zero at z = 0.

    At z = 1 its value is 1, and its slope is `slope`. It regularises a flow path that closes, such as a check valve.
    """
    return z * z * (1.0 + (1.0 - z) * (2.0 - slope))


def flow_ratio(
    upstream: Any,
    drop: Any,
    z: Any,
    width: Any,
    critical_ratio: Any,
    subsonic_index: Any,
    cracking_pressure: Any,
    one_way: bool,
) -> Any:
    """Return the signed mass flow rate as a fraction of the choked flow.

    The result is between -1 and 1. `drop` is the signed pressure drop divided by the pressure `upstream`. `width` is
    the width of the regularised zone in p2/p1. `z` is drop divided by width, limited to -1 to 1.
    """
    never_cracks = isinstance(cracking_pressure, float) and cracking_pressure == 0.0
    cracking = 0.0 if never_cracks else cracking_pressure / upstream
    span, edge, slope = edge_of_zone(critical_ratio, subsonic_index, cracking, width)
    excess = drop if one_way else abs(drop)
    if not never_cracks:
        excess = excess - cracking
    # Limited to the edge of the zone: symbols evaluate both branches, and the root has no slope at zero.
    subsonic = ellipse(clip(excess / span, edge, 1.0), subsonic_index)
    if never_cracks and not one_way:
        return subsonic * through_zero(z, slope)
    shut = closing(clip(excess / width, 0.0, 1.0), slope)
    if one_way:
        return subsonic * shut
    both_ways = where(drop < 0.0, -shut, shut)
    if not isinstance(cracking_pressure, float):
        # A symbol or an array can be zero; the flow then passes through zero.
        both_ways = where(cracking_pressure > 0.0, both_ways, through_zero(z, slope))
    return subsonic * both_ways


def mass_flow_and_temperature(
    pressure_1: Any,
    pressure_2: Any,
    temperature_1: Any,
    temperature_2: Any,
    *,
    sonic_conductance: Any,
    critical_ratio: Any,
    subsonic_index: Any,
    cracking_pressure: Any,
    laminar_ratio: Any,
    reference_density: Any,
    reference_temperature: Any,
    one_way: bool,
) -> tuple[Any, ...]:
    """Return mass flow rate [kg/s] and temperature of the flow [K] by the regularised flow law.

    The function `flow` describes the arguments. They are not checked.
    """
    width = 1.0 - laminar_ratio
    upstream, drop = upstream_pressure_and_drop(pressure_1, pressure_2)
    z = clip(drop / width, -1.0, 1.0)
    ratio = flow_ratio(upstream, drop, z, width, critical_ratio, subsonic_index, cracking_pressure, one_way)
    temperature = temperature_1
    if temperature_2 is not None and not one_way:
        temperature = smoothed_upstream_temperature(z, temperature_1, temperature_2)
    choked_per_pressure = sonic_conductance * reference_density * sqrt(reference_temperature / temperature)
    return choked_per_pressure * upstream * ratio, temperature


def smoothed_upstream_temperature(z: Any, temperature_1: Any, temperature_2: Any) -> Any:
    """Return the temperature of the upstream gas [K], smoothed at flow reversal.

    `z` is the relative pressure drop, divided by the width of the regularised zone and limited to -1 to 1.
    """
    turning = minimum(abs(z) * (1.0 / TURN), 1.0)
    upstream = where(z < 0.0, temperature_2, temperature_1)
    total, gap = temperature_1 + temperature_2, temperature_1 - temperature_2
    # At equal pressures, only one temperature T avoids a loss of entropy in both directions. A flow q from 1 to 2
    # increases the entropy by q cp [ln(T2/T1) + T (1/T2 - 1/T1)], which is zero at T = ln(T1/T2)/(1/T2 - 1/T1).
    # These are the first two terms of its series in gap/total; a logarithm would cost a third of the simulation.
    still = 0.5 * total - gap * gap / (3.0 * total)
    # The kink at z = 0 is harmless: flow times temperature is C1 if the temperature is continuous.
    return still + turning * (2.0 - turning) * (upstream - still)


def upstream_temperature_between(
    pressure_1: Any, pressure_2: Any, temperature_1: Any, temperature_2: Any, laminar_ratio: Any
) -> tuple[Any, ...]:
    """Return the temperature of the flow between two ports [K], as a tuple of one value.

    The function `upstream_temperature` describes the arguments. They are not checked.
    """
    _, drop = upstream_pressure_and_drop(pressure_1, pressure_2)
    return (smoothed_upstream_temperature(clip(drop / (1.0 - laminar_ratio), -1.0, 1.0), temperature_1, temperature_2),)


def regime_code(
    pressure_1: Any, pressure_2: Any, critical_ratio: Any, cracking_pressure: Any, laminar_ratio: Any, one_way: bool
) -> tuple[Any, ...]:
    """Return the code of the flow regime, as a tuple of one value.

    The function `flow_regime` describes the arguments and the code. The arguments are not checked. The conditions
    compare products instead of ratios, so a vacuum needs no special case.
    """
    upstream = pressure_1 if one_way else maximum(pressure_1, pressure_2)
    downstream = pressure_2 if one_way else minimum(pressure_1, pressure_2)
    edge = laminar_ratio * upstream - cracking_pressure
    beyond_edge = downstream <= edge
    choked = downstream <= minimum(critical_ratio * upstream, edge)
    # Strict inequality: the flow path is closed at equal pressures.
    code = where(downstream < upstream - cracking_pressure, 1 + beyond_edge + choked, 0)
    return (code if one_way else where(pressure_1 < pressure_2, -code, code),)
