"""Volume flow rates of catalogues: the nominal flow qNn of a passage, and what a volume flow rate weighs."""

from __future__ import annotations

from poppet.ground.units import ANR, ReferenceAtmosphere
from poppet.laws.iso6358.conversion import Conductance, given_or_assumed
from poppet.laws.iso6358.domain import DOMAINS, Domain, check
from poppet.laws.iso6358.law import mass_flow_rate as flow_law

NOMINAL_INLET_GAUGE = 6e5
"""Gauge pressure before the component at which the nominal flow qNn is stated [Pa]."""

NOMINAL_OUTLET_GAUGE = 5e5
"""Gauge pressure behind the component at which the nominal flow qNn is stated [Pa]."""

STANDARD_ATMOSPHERE = 101325.0
"""Atmosphere to which the gauge pressures of the nominal flow refer unless another is given [Pa]."""

_DOMAINS = DOMAINS | {
    "sonic_conductance": DOMAINS["sonic_conductance"],
    "nominal_flow": Domain("iso6358.nominal_flow", "m^3/s ANR"),
    "atmosphere": Domain("iso6358.atmosphere", "Pa", open_low=True),
}


def conductance_from_nominal_flow(
    nominal_flow: float,
    *,
    critical_ratio: float | None = None,
    subsonic_index: float = 0.5,
    atmosphere: float = STANDARD_ATMOSPHERE,
) -> Conductance:
    r"""Sonic conductance from the nominal flow qNn, stated from 6 bar to 5 bar gauge at 20 degC.

    .. math:: C = q_{Nn} \Big/ \frac{q_m(C = 1;\ 6\,\text{bar g},\ 5\,\text{bar g},\ T_0)}{\rho_0}

    Parameters
    ----------
    nominal_flow : float
        Volume flow rate referred to ANR [m^3/s].
    critical_ratio : float, optional
        b; 0.3 is assumed when not given, and the result says so.
    subsonic_index : float, optional
        m.
    atmosphere : float, optional
        Absolute pressure of the atmosphere to which the gauge pressures refer [Pa].

    Returns
    -------
    Conductance
        C [m^3/(s Pa)] and b.

    Notes
    -----
    Catalogues seldom state their atmosphere; between 1.0 and 1.01325 bar C differs by 0.1 %. The assumed b
    weighs more: from b = 0.2 to 0.5 C falls by 18 %.

    References
    ----------
    VDI 3290 and manufacturers' practice: nominal flow from 6 to 5 bar gauge.

    Examples
    --------
    >>> given = conductance_from_nominal_flow(380e-3 / 60)
    >>> round(given.sonic_conductance * 1e8, 3), given.critical_ratio, given.critical_ratio_assumed
    (1.493, 0.3, True)
    """
    check(
        {"nominal_flow": nominal_flow, "critical_ratio": critical_ratio, "atmosphere": atmosphere},
        _DOMAINS,
    )
    ratio, assumed = given_or_assumed(critical_ratio)
    note = f"nominal flow from 6 to 5 bar gauge at an atmosphere of {atmosphere / 1e5:g} bar{assumed}"
    conductance = nominal_flow / _nominal_flow_per_conductance(ratio, subsonic_index, atmosphere)
    return Conductance(conductance, ratio, note, critical_ratio is None)


def nominal_flow_from_conductance(
    sonic_conductance: float,
    critical_ratio: float,
    *,
    subsonic_index: float = 0.5,
    atmosphere: float = STANDARD_ATMOSPHERE,
) -> float:
    r"""Nominal flow qNn of a passage, from 6 bar to 5 bar gauge at 20 degC.

    .. math:: q_{Nn} = q_m(6\,\text{bar g},\ 5\,\text{bar g},\ T_0)/\rho_0

    Parameters
    ----------
    sonic_conductance : float
        C [m^3/(s Pa)].
    critical_ratio : float
        b.
    subsonic_index : float, optional
        m.
    atmosphere : float, optional
        Absolute pressure of the atmosphere to which the gauge pressures refer [Pa].

    Returns
    -------
    float
        Volume flow rate referred to ANR [m^3/s].

    Examples
    --------
    >>> round(nominal_flow_from_conductance(1e-8, 0.3, atmosphere=1e5) * 60e3, 1)
    254.3
    """
    check({"sonic_conductance": sonic_conductance, "atmosphere": atmosphere}, _DOMAINS)
    return sonic_conductance * _nominal_flow_per_conductance(critical_ratio, subsonic_index, atmosphere)


def volume_from_mass_flow_rate(mass_flow_rate: float, atmosphere: ReferenceAtmosphere = ANR) -> float:
    r"""Volume flow rate of a mass flow rate, referred to a stated atmosphere.

    .. math:: Q = q_m/\rho_\mathrm{ref}

    Parameters
    ----------
    mass_flow_rate : float or array
        Mass flow rate [kg/s].
    atmosphere : ReferenceAtmosphere, optional
        `poppet.ground.units.ANR` (20 degC, 1 bar) or `poppet.ground.units.NORMAL` (0 degC, 1.01325 bar).

    Returns
    -------
    float or array
        Volume flow rate in that atmosphere [m^3/s].

    Notes
    -----
    The same air in both atmospheres: 1 m3 ANR = 0.9196 m3 normal. Dry air would be 1.1884 and 1.2929 kg/m3.

    Examples
    --------
    >>> round(volume_from_mass_flow_rate(1.185) * 1e3)
    1000
    """
    return mass_flow_rate / atmosphere.density


def mass_from_volume_flow_rate(volume_flow_rate: float, atmosphere: ReferenceAtmosphere = ANR) -> float:
    r"""Mass flow rate of a volume flow rate that is referred to a stated atmosphere.

    .. math:: q_m = \rho_\mathrm{ref} Q

    Parameters
    ----------
    volume_flow_rate : float or array
        Volume flow rate in the atmosphere [m^3/s].
    atmosphere : ReferenceAtmosphere, optional
        `poppet.ground.units.ANR` (20 degC, 1 bar) or `poppet.ground.units.NORMAL` (0 degC, 1.01325 bar).

    Returns
    -------
    float or array
        Mass flow rate [kg/s].

    Notes
    -----
    As for `volume_from_mass_flow_rate`.

    Examples
    --------
    >>> round(mass_from_volume_flow_rate(600e-3 / 60), 5)
    0.01185
    """
    return volume_flow_rate * atmosphere.density


def _nominal_flow_per_conductance(critical_ratio: float, subsonic_index: float, atmosphere: float) -> float:
    """Volume flow rate ANR of a passage with C = 1 at the nominal pressures [Pa]."""
    flow = flow_law(
        NOMINAL_INLET_GAUGE + atmosphere,
        NOMINAL_OUTLET_GAUGE + atmosphere,
        ANR.temperature,
        sonic_conductance=1.0,
        critical_ratio=critical_ratio,
        subsonic_index=subsonic_index,
    )
    return float(flow / ANR.density)
