"""Suction of a vacuum ejector."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from poppet.core.symbolic import clip, log, maximum

MIN_LOG_RATIO = 1e-9
"""Smallest logarithm of a pressure ratio by which the limit of the second law is divided."""


def suction_flow(vacuum: Any, drive: Any, depths: Sequence[Any], flows: Sequence[Any], zone: Any) -> Any:
    r"""Return the suction flow of an ejector, from its suction curve and its drive.

    .. math:: q = s\, q_n(v / s)\, z (2 - z), \qquad
              z = \operatorname{clip}\left(\frac{s v_n - v}{w}, 0, 1\right)

    Here :math:`q_n(v)` is the suction curve at the nominal supply pressure, a polygon through points, and v_n its
    largest vacuum.

    Parameters
    ----------
    vacuum : float, array or symbol
        Vacuum v: exhaust pressure minus pressure at the vacuum port [Pa].
    drive : float, array or symbol
        Gauge supply pressure, relative to the nominal one: 0 to 1.
    depths, flows : sequence of float or symbol
        Points of the suction curve: increasing vacuum [Pa], and flow in any unit. The last flow is 0.
    zone : float or symbol
        Range w of the vacuum, below the largest one, in which the slope of the curve decreases to 0 [Pa].

    Returns
    -------
    float, array or symbol
        Suction flow, in the unit of `flows`; it is constant beyond both ends of the curve.

    Notes
    -----
    The scaling of both axes by the drive is a similarity rule: with half the gauge supply pressure, the ejector reaches
    half the vacuum, with half the flow. It is an assumption that was not measured. Without the zone, a vessel would
    come to rest at a corner of the curve, at which the integrator needs small steps.

    Examples
    --------
    >>> [suction_flow(vacuum, 1.0, [0.0, 8e4], [40.0, 0.0], 100.0) for vacuum in (0.0, 2e4, 9e4)]
    [40.0, 30.0, 0.0]
    >>> suction_flow(2e4, 0.5, [0.0, 8e4], [40.0, 0.0], 100.0)
    10.0
    """
    flow = drive * flows[0]
    # A sum over all segments, without a division by the drive, which can be 0.
    for (start, first), (end, last) in pairwise(zip(depths, flows, strict=True)):
        slope = (last - first) / (end - start)
        flow = flow + slope * (clip(vacuum, drive * start, drive * end) - drive * start)
    distance = clip((drive * depths[-1] - vacuum) / zone, 0.0, 1.0)
    return flow * distance * (2.0 - distance)


def largest_suction(motive_flow: Any, supply_pressure: Any, exhaust_pressure: Any, vacuum_pressure: Any) -> Any:
    r"""Return the suction flow at which an ejector would be reversible.

    .. math:: q_v \ln\frac{p_e}{p_v} = q_s \ln\frac{p_s}{p_e}

    Parameters
    ----------
    motive_flow : float, array or symbol
        Mass flow rate q_s through the nozzle [kg/s].
    supply_pressure, exhaust_pressure, vacuum_pressure : float, array or symbol
        Absolute pressures p_s, p_e and p_v at the three ports [Pa].

    Returns
    -------
    float, array or symbol
        Mass flow rate [kg/s]; very large if the vacuum pressure is not below the exhaust pressure.

    Notes
    -----
    The entropy that the nozzle flow gains by its expansion is the largest that the suction flow can lose by its
    compression (second law). The gas is ideal, and each flow keeps its stagnation temperature. A real ejector is far
    below this limit.

    Examples
    --------
    >>> round(largest_suction(1.0, 6e5, 1e5, 0.5e5), 2)
    2.58
    """
    expansion = log(maximum(supply_pressure / exhaust_pressure, 1.0))
    return motive_flow * expansion / maximum(log(exhaust_pressure / vacuum_pressure), MIN_LOG_RATIO)
