"""What a measured point says about a passage: its conductance, effective conductance or critical ratio."""

from __future__ import annotations

from typing import Any

import numpy as np

from poppet.laws.iso6358.domain import DOMAINS, Domain, refuse_where
from poppet.laws.iso6358.evaluation import plain
from poppet.laws.iso6358.inverse import INVERSE_DOMAINS, as_given, checked_arrays
from poppet.laws.iso6358.law import LAMINAR_RATIO, REFERENCE_DENSITY, REFERENCE_TEMPERATURE
from poppet.laws.iso6358.law import mass_flow_rate as flow_law

_ROUNDING = 1e-9  # how far below zero the b of an exact point with b = 0 may come out

_FRACTION = Domain("iso6358.subsonic_point", "", high=1.0, open_low=True)


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
    r"""Sonic conductance with which a passage of known b carries a measured flow.

    .. math:: C = q_m / q_m(C = 1)

    Parameters
    ----------
    mass_flow_rate : float or array
        Measured, positive from port 1 to port 2 [kg/s].
    pressure_1 : float or array
        Absolute pressure at port 1 [Pa].
    pressure_2 : float or array
        Absolute pressure at port 2 [Pa].
    temperature_1 : float or array
        Stagnation temperature at port 1 [K].
    temperature_2 : float or array, optional
        Stagnation temperature at port 2; as `temperature_1` when not given [K].
    critical_ratio : float or array
        b; without influence on a choked point.
    subsonic_index : float or array, optional
        m.
    cracking_pressure : float or array, optional
        Pressure drop below which the passage is closed [Pa].
    laminar_ratio : float or array, optional
        Pressure ratio at which the regularised zone begins.
    one_way : bool, optional
        A check valve.
    reference_density : float or array, optional
        Density in the reference atmosphere [kg/m^3].
    reference_temperature : float or array, optional
        Temperature in the reference atmosphere [K].

    Returns
    -------
    float or array
        Sonic conductance [m^3/(s Pa)].

    Raises
    ------
    OutOfRangeError
        Where the passage is closed at these pressures, or the flow runs against the pressure drop.

    Notes
    -----
    One subsonic point cannot give both C and b: measure one choked point, or state b as assumed.

    Examples
    --------
    >>> round(sonic_conductance_from_flow(8.29327e-3, 5e5, 4e5, 293.15, critical_ratio=0.3), 13)
    2e-08
    """
    per_conductance = flow_law(
        pressure_1,
        pressure_2,
        temperature_1,
        temperature_2,
        sonic_conductance=1.0,
        critical_ratio=critical_ratio,
        subsonic_index=subsonic_index,
        cracking_pressure=cracking_pressure,
        laminar_ratio=laminar_ratio,
        one_way=one_way,
        reference_density=reference_density,
        reference_temperature=reference_temperature,
    )
    measured = np.asarray(plain(mass_flow_rate))
    refuse_where(
        per_conductance == 0.0,
        "mass_flow_rate",
        measured,
        "kg/s",
        "iso6358.closed_here",
    )
    refuse_where(
        measured * per_conductance < 0.0,
        "mass_flow_rate",
        measured,
        "kg/s",
        "iso6358.runs_uphill",
    )
    return as_given(measured / per_conductance)


def effective_conductance(
    mass_flow_rate: Any,
    pressure_1: Any,
    temperature_1: Any,
    *,
    reference_density: Any = REFERENCE_DENSITY,
    reference_temperature: Any = REFERENCE_TEMPERATURE,
) -> Any:
    r"""Conductance that would carry the flow if it were choked.

    .. math:: C_e = \frac{q_m}{\rho_0 p_1 \sqrt{T_0/T_1}}

    Parameters
    ----------
    mass_flow_rate : float or array
        From the upstream to the downstream side [kg/s].
    pressure_1 : float or array
        Absolute upstream pressure, above zero [Pa].
    temperature_1 : float or array
        Upstream stagnation temperature [K].
    reference_density : float or array, optional
        Density in the reference atmosphere [kg/m^3].
    reference_temperature : float or array, optional
        Temperature in the reference atmosphere [K].

    Returns
    -------
    float or array
        Effective conductance: C for a choked point, less for a subsonic one [m^3/(s Pa)].

    References
    ----------
    ISO 6358-1:2013, definition of the conductance.

    Examples
    --------
    >>> round(effective_conductance(8.29327e-3, 5e5, 293.15), 12)
    1.3997e-08
    """
    given = {
        "mass_flow_rate": mass_flow_rate,
        "pressure_1": pressure_1,
        "temperature_1": temperature_1,
        "reference_density": reference_density,
        "reference_temperature": reference_temperature,
    }
    upstream = {"pressure_1": Domain("iso6358.upstream", "Pa", open_low=True)}
    number = checked_arrays(given, INVERSE_DOMAINS | upstream)
    root = np.sqrt(number["reference_temperature"] / number["temperature_1"])
    return as_given(number["mass_flow_rate"] / (number["reference_density"] * number["pressure_1"] * root))


def critical_ratio_from_point(pressure_ratio: Any, flow_ratio: Any, subsonic_index: Any = 0.5) -> Any:
    r"""Critical pressure ratio from one subsonic point of a flow bench.

    .. math:: b = \frac{r - s}{1 - s} = 1 - \frac{1 - r}{1 - s}, \quad s = \sqrt{1 - \varphi^{1/m}}

    Parameters
    ----------
    pressure_ratio : float or array
        r = p2/p1 of the point, between 0 and 1.
    flow_ratio : float or array
        Flow over the saturated (choked) flow at the same upstream state, between 0 and 1.
    subsonic_index : float or array, optional
        m.

    Returns
    -------
    float or array
        Critical pressure ratio b.

    Raises
    ------
    OutOfRangeError
        For a choked or closed point, and for one that lies below every ellipse (b would be negative).

    Notes
    -----
    No cracking pressure. The uncertainty is u(b)^2 = (u_r/(1 - s))^2 + ((1 - r)/(1 - s)^2 (phi/s) u_phi)^2
    for m = 0.5: points near r = 1 and near phi = 1 say least about b.

    References
    ----------
    ISO 6358-1:2013, evaluation of the critical back-pressure ratio.

    Examples
    --------
    >>> round(critical_ratio_from_point(0.8, 0.699854), 4)
    0.3
    """
    given = {"pressure_ratio": pressure_ratio, "flow_ratio": flow_ratio, "subsonic_index": subsonic_index}
    number = checked_arrays(given, DOMAINS | {"pressure_ratio": _FRACTION, "flow_ratio": _FRACTION})
    squared = number["flow_ratio"] ** (1.0 / number["subsonic_index"])
    # 1 - s = squared/(1 + s) keeps its digits for small flows, where s is nearly 1
    ratio = 1.0 - (1.0 - number["pressure_ratio"]) * (1.0 + np.sqrt(1.0 - squared)) / squared
    refuse_where(
        ratio < -_ROUNDING,
        "flow_ratio",
        number["flow_ratio"],
        "",
        "iso6358.below_the_curve",
    )
    return as_given(np.maximum(ratio, 0.0))
