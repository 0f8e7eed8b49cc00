"""Flow law of ISO 6358 for both directions, regularised (C1) near equal pressures."""

from __future__ import annotations

from typing import Any

import numpy as np

from poppet.core.units import ANR
from poppet.laws.iso6358.evaluation import evaluate
from poppet.laws.iso6358.regularisation import mass_flow_and_temperature, regime_code, upstream_temperature_between

REFERENCE_DENSITY = ANR.density
"""Density of air in ANR, 1.185: 20 degC, 100 kPa, 65 % relative humidity (ISO 8778) [kg/m^3]."""

REFERENCE_TEMPERATURE = ANR.temperature
"""Temperature of ANR, 293.15 (ISO 8778) [K]."""

LAMINAR_RATIO = 0.999
"""Pressure ratio above which the law is regularised; vendors use 0.995 to 0.999."""


def mass_flow_rate(
    pressure_1: Any,
    pressure_2: Any,
    temperature_1: Any,
    temperature_2: Any = None,
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
    r"""Return the mass flow rate of an ISO 6358 flow path, positive from port 1 to port 2.

    .. math::

        q_m = C \rho_0 p_1 \sqrt{T_0/T_1}\,
              \left[1 - \left(\frac{p_2/p_1 - b}{1 - \Delta p_c/p_1 - b}\right)^2\right]^m
        \quad\text{for}\quad b < p_2/p_1 < 1 - \Delta p_c/p_1

    The bracket is 1 for :math:`p_2/p_1 \le b` (choked flow), and the flow is 0 for
    :math:`p_2/p_1 \ge 1 - \Delta p_c/p_1` (closed). For :math:`p_2 > p_1` the ports are exchanged and the flow is
    negative. All arguments except `one_way` can be floats, arrays that broadcast, or CasADi symbols.

    Parameters
    ----------
    pressure_1 : float, array or symbol
        Absolute pressure at port 1 [Pa].
    pressure_2 : float, array or symbol
        Absolute pressure at port 2 [Pa].
    temperature_1 : float, array or symbol
        Stagnation temperature of the gas at port 1 [K].
    temperature_2 : float, array or symbol, optional
        Stagnation temperature of the gas at port 2 [K] (default: `temperature_1`).
    sonic_conductance : float, array or symbol
        Sonic conductance C: choked mass flow rate divided by reference density and upstream pressure [m^3/(s Pa)].
    critical_ratio : float, array or symbol
        Critical pressure ratio b, at and below which the flow is choked, 0 <= b < 1.
    subsonic_index : float, array or symbol, optional
        Exponent m of the subsonic law, 0 < m <= 3; 0.5 is the ellipse of the 1989 edition.
    cracking_pressure : float, array or symbol, optional
        Pressure drop below which the flow path is closed, in both directions unless `one_way` [Pa].
    laminar_ratio : float, array or symbol, optional
        Pressure ratio p2/p1 above which the law is regularised [1]; a cracking pressure reduces it by
        :math:`\Delta p_c/p_1`.
    one_way : bool, optional
        True for a check valve: no flow from port 2 to port 1.
    reference_density : float, array or symbol, optional
        Density of the reference atmosphere, by default ANR (20 degC, 1 bar) [kg/m^3].
    reference_temperature : float, array or symbol, optional
        Temperature of the reference atmosphere [K].

    Returns
    -------
    float, array or symbol
        Mass flow rate [kg/s].

    Raises
    ------
    OutOfRangeError
        If a float or array is outside its domain, for example a negative (gauge) pressure. Symbols are not
        checked.

    Notes
    -----
    The slope of the law of the standard is infinite at zero flow. It is therefore regularised in a zone of pressure
    ratios near zero flow. In this zone, the result is the flow at the edge of the zone, multiplied by a cubic
    polynomial of z; z is 0 at zero flow and 1 at the edge, and s is the logarithmic slope of the law at the edge. The
    first polynomial is for flow in both directions and is odd. The second one is for a cracking pressure or `one_way`,
    and has zero slope at zero flow. With both, the law is continuously differentiable.

    .. math::

        z \left[1 + (1 - z^2)\,\tfrac{1 - s}{2}\right], \qquad z^2 \left[1 + (1 - z)(2 - s)\right]

    The width of the zone in p2/p1 is 1 - laminar_ratio. If b is above laminar_ratio, the flow is choked up to the edge
    of the zone.

    The following errors were computed for b = 0.3 and m = 0.5 (tests/order). The pressure error of a tank that is
    filled isothermally is at most 0.112 (1 - laminar_ratio) of the supply pressure. Inside the zone, the error of the
    flow is at most 1.1 % of the choked flow for a laminar_ratio of 0.999, and 2.4 % for 0.995; it decreases with the
    square root of the width. Outside the zone there is no error.

    The gas is ideal and the flow quasi-steady. The standard excludes components with internal feedback, such as
    regulators: their C and b are valid for one fixed opening only.

    References
    ----------
    ISO 6358-1:2013, Pneumatic fluid power - Determination of flow-rate characteristics, with C, b, m and the
    cracking pressure; ISO 6358:1989 is m = 0.5. Varga & Keski-Honkola 2012, eqs. (1)-(2).

    Examples
    --------
    The example of a catalogue states 420 l/min ANR for C = 2 dm3/(s bar), b = 0.3, and 4 to 3 bar gauge at an ambient
    pressure of 1.0 bar:

    >>> q = mass_flow_rate(5e5, 4e5, 293.15, sonic_conductance=2e-8, critical_ratio=0.3)
    >>> round(q / 1.185 * 60e3, 2)
    419.91
    """
    numbers = dict(locals())
    del numbers["one_way"]
    (mass_flow,) = evaluate(lambda **values: mass_flow_and_temperature(one_way=one_way, **values)[:1], numbers)
    return mass_flow


def flow(
    pressure_1: Any,
    pressure_2: Any,
    temperature_1: Any,
    temperature_2: Any = None,
    *,
    sonic_conductance: Any,
    critical_ratio: Any,
    subsonic_index: Any = 0.5,
    cracking_pressure: Any = 0.0,
    laminar_ratio: Any = LAMINAR_RATIO,
    one_way: bool = False,
    reference_density: Any = REFERENCE_DENSITY,
    reference_temperature: Any = REFERENCE_TEMPERATURE,
) -> tuple[Any, Any]:
    r"""Return the mass flow rate and the stagnation temperature of the flow.

    .. math:: (q_m, T_\mathrm{up})

    Parameters
    ----------
    pressure_1 : float, array or symbol
        Absolute pressure at port 1 [Pa].
    pressure_2 : float, array or symbol
        Absolute pressure at port 2 [Pa].
    temperature_1 : float, array or symbol
        Stagnation temperature of the gas at port 1 [K].
    temperature_2 : float, array or symbol, optional
        Stagnation temperature of the gas at port 2 [K] (default: `temperature_1`).
    sonic_conductance : float, array or symbol
        Sonic conductance C: choked mass flow rate divided by reference density and upstream pressure [m^3/(s Pa)].
    critical_ratio : float, array or symbol
        Critical pressure ratio b, at and below which the flow is choked, 0 <= b < 1.
    subsonic_index : float, array or symbol, optional
        Exponent m of the subsonic law, 0 < m <= 3.
    cracking_pressure : float, array or symbol, optional
        Pressure drop below which the flow path is closed, in both directions unless `one_way` [Pa].
    laminar_ratio : float, array or symbol, optional
        Pressure ratio p2/p1 above which the flow law is regularised [1].
    one_way : bool, optional
        True for a check valve: no flow from port 2 to port 1, and the temperature of the flow is always that of port 1.
    reference_density : float, array or symbol, optional
        Density of the reference atmosphere, by default ANR (20 degC, 1 bar) [kg/m^3].
    reference_temperature : float, array or symbol, optional
        Temperature of the reference atmosphere [K].

    Returns
    -------
    mass_flow_rate : float, array or symbol
        Positive from port 1 to port 2 [kg/s].
    upstream_temperature : float, array or symbol
        Stagnation temperature of the flow: temperature of the upstream port, smoothed at flow reversal [K].

    Notes ----- The functions `mass_flow_rate` and `upstream_temperature` describe the laws and their limits.

    Examples
    --------
    >>> q, temperature = flow(1e5, 7e5, 293.15, 320.0, sonic_conductance=1e-8, critical_ratio=0.4)
    >>> round(q, 7), temperature
    (-0.0079394, 320.0)
    """
    numbers = dict(locals())
    del numbers["one_way"]
    mass_flow, temperature = evaluate(lambda **values: mass_flow_and_temperature(one_way=one_way, **values), numbers)
    return mass_flow, temperature


def upstream_temperature(
    pressure_1: Any, pressure_2: Any, temperature_1: Any, temperature_2: Any, *, laminar_ratio: Any = LAMINAR_RATIO
) -> Any:
    r"""Return the stagnation temperature of the gas that flows through a flow path.

    It is the temperature of the upstream side, smoothed at flow reversal.

    .. math::

        T = T_\mathrm{still} + s (2 - s) (T_\mathrm{up} - T_\mathrm{still}), \quad
        T_\mathrm{still} = \frac{T_1 + T_2}{2} - \frac{(T_1 - T_2)^2}{3 (T_1 + T_2)}, \quad
        s = \min\!\left(1, \frac{1000\,|p_1 - p_2|}{(1 - r_l) \max(p_1, p_2)}\right)

    Parameters
    ----------
    pressure_1 : float, array or symbol
        Absolute pressure at port 1 [Pa].
    pressure_2 : float, array or symbol
        Absolute pressure at port 2 [Pa].
    temperature_1 : float, array or symbol
        Stagnation temperature of the gas at port 1 [K].
    temperature_2 : float, array or symbol
        Stagnation temperature of the gas at port 2 [K].
    laminar_ratio : float, array or symbol, optional
        Pressure ratio p2/p1 above which the flow law is regularised [1].

    Returns
    -------
    float, array or symbol
        Upstream temperature [K].

    Notes
    -----
    :math:`T_\mathrm{up}` is the temperature of the port with the higher pressure, :math:`T_\mathrm{still}` that of the
    flow at equal pressures, and :math:`r_l` the laminar ratio. The temperature changes within a range of pressure
    differences that is a thousandth of the regularised zone of `mass_flow_rate`, by default 1e-6 of the pressure. With
    the complete zone as range, the temperature in a 2 l tank that is filled in 10 s had an error of 1.4 K, because slow
    flows remain in the zone for long. Without smoothing, 1 of 1000 random stiff networks with very different
    temperatures chattered at zero flow.

    Only one temperature of the flow between equal pressures does not decrease the entropy in either direction.
    :math:`T_\mathrm{still}` approximates it to the fourth order in (T1 - T2)/(T1 + T2). The second law of
    thermodynamics is therefore also fulfilled at flow reversal (tests/laws).

    Examples
    --------
    >>> upstream_temperature(2e5, 1e5, 300.0, 280.0)
    300.0
    >>> round(upstream_temperature(1e5, 1e5, 300.0, 280.0), 3)
    289.77
    """
    (temperature,) = evaluate(upstream_temperature_between, dict(locals()))
    return temperature


REGIMES: dict[int, str] = {
    -3: "choked, reversed",
    -2: "subsonic, reversed",
    -1: "laminar, reversed",
    0: "closed",
    1: "laminar",
    2: "subsonic",
    3: "choked",
}
"""Meaning of the codes of `flow_regime`; "laminar" is the regularised zone at any Reynolds number."""


def flow_regime(
    pressure_1: Any,
    pressure_2: Any,
    *,
    critical_ratio: Any,
    cracking_pressure: Any = 0.0,
    laminar_ratio: Any = LAMINAR_RATIO,
    one_way: bool = False,
) -> Any:
    r"""Return the regime of the flow (choked, subsonic, laminar or closed) as an integer code.

    The dictionary `REGIMES` contains the meaning of all codes.

    .. math::

        p_2 \le b\,p_1:\ 3 \qquad b\,p_1 < p_2 \le r_l p_1 - \Delta p_c:\ 2 \qquad
        r_l p_1 - \Delta p_c < p_2 < p_1 - \Delta p_c:\ 1 \qquad p_2 \ge p_1 - \Delta p_c:\ 0

    Parameters
    ----------
    pressure_1 : float, array or symbol
        Absolute pressure at port 1 [Pa].
    pressure_2 : float, array or symbol
        Absolute pressure at port 2 [Pa].
    critical_ratio : float, array or symbol
        Critical pressure ratio b, at and below which the flow is choked.
    cracking_pressure : float, array or symbol, optional
        Pressure drop below which the flow path is closed [Pa].
    laminar_ratio : float, array or symbol, optional
        Pressure ratio p2/p1 above which the flow law is regularised [1].
    one_way : bool, optional
        True for a check valve: closed from port 2 to port 1.

    Returns
    -------
    int, array of int or symbol
        3 choked, 2 subsonic, 1 laminar, 0 closed; negative for flow from port 2 to port 1.

    Notes
    -----
    "laminar" is the regularised zone of `mass_flow_rate`, at any Reynolds number. If b exceeds laminar_ratio, the
    regime in this zone is laminar, although the flow is choked up to its edge.

    Examples
    --------
    >>> REGIMES[flow_regime(7e5, 1e5, critical_ratio=0.3)]
    'choked'
    >>> flow_regime(1e5, [0.0, 0.9e5, 1e5, 1.1e5], critical_ratio=0.3).tolist()
    [3, 2, 0, -2]
    """
    numbers = dict(locals())
    del numbers["one_way"]
    (code,) = evaluate(lambda **values: regime_code(one_way=one_way, **values), numbers)
    return code.astype(int) if isinstance(code, np.ndarray) else code
