"""Conversions between sonic conductance and catalogue values: effective area, Kv, Cv and nominal flow qNn.

A single catalogue value cannot determine both C and b. If b is assumed, the result has a note.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

from poppet.core.errors import InputError, NameSuggestion
from poppet.core.symbolic import is_symbolic, sqrt
from poppet.core.units import ANR, ReferenceAtmosphere
from poppet.laws.iso6358.domain import DOMAINS, Domain, check
from poppet.laws.iso6358.law import mass_flow_rate as flow_law
from poppet.laws.iso6358.nozzle import NOZZLE_DOMAINS, nozzle_choked_flux, nozzle_critical_ratio
from poppet.laws.physics.gas import AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT

Definition = Literal["pneumatic", "small_dp"]

ASSUMED_CRITICAL_RATIO = 0.3
"""b of a typical valve or fitting, assumed where a catalogue prints one flow only."""

KV_PER_CV = 0.865
"""Kv [m^3/h, bar] of a valve with Cv = 1 [US gal/min, psi] (IEC 60534-1)."""

_PNEUMATIC_CV = 114.5e-8
"""Factor of the pneumatic Cv in SI: Q = 114.5 Cv sqrt(dp p2/T1) with Q in dm3/s ANR, pressures in bar."""

NOMINAL_INLET_GAUGE = 6e5
"""Gauge pressure before the component at which the nominal flow qNn is stated [Pa]."""

NOMINAL_OUTLET_GAUGE = 5e5
"""Gauge pressure behind the component at which the nominal flow qNn is stated [Pa]."""

STANDARD_ATMOSPHERE = 101325.0
"""Atmosphere to which the gauge pressures of the nominal flow refer unless another is given [Pa]."""

_DOMAINS = NOZZLE_DOMAINS | {
    "sonic_conductance": DOMAINS["sonic_conductance"],
    "nominal_flow": Domain("iso6358.nominal_flow", "m^3/s ANR"),
    "atmosphere": Domain("iso6358.atmosphere", "Pa", open_low=True),
    "flow_coefficient_kv": Domain("iso6358.flow_coefficient", ""),
    "flow_coefficient_cv": Domain("iso6358.flow_coefficient", ""),
}


@dataclass(frozen=True)
class Conductance:
    """Sonic conductance and critical pressure ratio that result from a conversion.

    Parameters
    ----------
    sonic_conductance : float
        Sonic conductance C [m^3/(s Pa)].
    critical_ratio : float
        Critical pressure ratio b [1].
    note : str
        Text with the definition of the converted value, and assumptions.
    critical_ratio_assumed : bool
        True if b is an assumption, not an argument of the conversion.

    Examples
    --------
    >>> conductance_from_effective_area(16e-6).note
    'isentropic nozzle with exponent 1.4; b = 0.5283 is its critical ratio, assumed'
    """

    sonic_conductance: float
    critical_ratio: float
    note: str
    critical_ratio_assumed: bool


def conductance_from_effective_area(
    effective_area: float,
    *,
    critical_ratio: float | None = None,
    isentropic_exponent: float = AIR_ISENTROPIC_EXPONENT,
    gas_constant: float = AIR_GAS_CONSTANT,
) -> Conductance:
    r"""Return the sonic conductance that corresponds to an effective area.

    A flow path with this conductance has the same choked flow as an ideal nozzle with the effective area.

    .. math::

        C = \frac{A}{\rho_0 \sqrt{T_0}} \sqrt{\frac{\kappa}{R}}
            \left(\frac{2}{\kappa + 1}\right)^{(\kappa + 1)/(2 (\kappa - 1))}

    Here :math:`\rho_0` and :math:`T_0` are density and temperature of the reference atmosphere ANR (20 degC, 1 bar).

    Parameters
    ----------
    effective_area : float
        Area of the ideal nozzle with the same choked flow [m^2].
    critical_ratio : float, optional
        Critical pressure ratio b [1]; default: value of the isentropic nozzle (0.5283 for air).
    isentropic_exponent, gas_constant : float, optional
        Ratio of specific heats, above 1, and specific gas constant [J/(kg K)].

    Returns
    -------
    Conductance
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1].

    Notes
    -----
    For air, C is 0.1992 dm3/(s bar) for each square millimetre. Real valves choke at lower pressure ratios than a
    nozzle, so the subsonic flow with b = 0.5283 is too large.

    Examples
    --------
    >>> round(conductance_from_effective_area(1e-6).sonic_conductance * 1e8, 4)
    0.1992
    """
    check(dict(locals()), _DOMAINS)
    note = f"isentropic nozzle with exponent {_text(isentropic_exponent)}"
    conductance = effective_area * _conductance_per_area(isentropic_exponent, gas_constant)
    # The choked flow alone determines C; a given b has no effect on C.
    if critical_ratio is not None:
        return Conductance(conductance, critical_ratio, note, False)
    ratio = nozzle_critical_ratio(isentropic_exponent)
    return Conductance(conductance, ratio, f"{note}; b = {_text(ratio, '.4f')} is its critical ratio, assumed", True)


def effective_area_from_conductance(
    sonic_conductance: float,
    *,
    isentropic_exponent: float = AIR_ISENTROPIC_EXPONENT,
    gas_constant: float = AIR_GAS_CONSTANT,
) -> float:
    r"""Return the effective area of a flow path.

    It is the area of the ideal nozzle with the same choked flow.

    .. math::

        A = C \rho_0 \sqrt{T_0} \Big/ \left[\sqrt{\frac{\kappa}{R}}
            \left(\frac{2}{\kappa + 1}\right)^{(\kappa + 1)/(2 (\kappa - 1))}\right]

    Parameters
    ----------
    sonic_conductance : float
        Sonic conductance C [m^3/(s Pa)].
    isentropic_exponent, gas_constant : float, optional
        Ratio of specific heats, above 1, and specific gas constant [J/(kg K)].

    Returns
    -------
    float
        Effective area [m^2].

    Examples
    --------
    >>> round(effective_area_from_conductance(1e-8) * 1e6, 3)
    5.02
    """
    check(dict(locals()), _DOMAINS)
    return sonic_conductance / _conductance_per_area(isentropic_exponent, gas_constant)


def factors_from_air(isentropic_exponent: float, gas_constant: float) -> tuple[float, float]:
    r"""Return factors that convert sonic conductance C and critical ratio b from air to another gas.

    .. math::

        \frac{C'}{C} = \frac{\psi(\kappa)}{\psi(1.4)} \sqrt{\frac{R_{air}}{R}}, \qquad
        \frac{1 - b'}{1 - b} = \left(\frac{\psi(\kappa)}{\psi(1.4)}\right)^2, \qquad
        \psi = \sqrt{\kappa} \left(\frac{2}{\kappa + 1}\right)^{(\kappa + 1)/(2 (\kappa - 1))}

    Parameters
    ----------
    isentropic_exponent, gas_constant : float
        Ratio of specific heats, above 1, and specific gas constant of the other gas [J/(kg K)].

    Returns
    -------
    conductance_factor, ratio_shift : float
        Factor C'/C [1], and shift s [1] in b' = b + (1 - b) s. For air they are 1 and 0.

    Notes
    -----
    C' and b' are the values for the other gas. The first equation holds because the choked flow is proportional to that
    of a nozzle. At small pressure drops, the flow is that of a liquid with the density of the gas, q^2 = 2 C^2 rho_0^2
    T_0 p dp/((1 - b) T). It does not depend on kappa, which gives the second equation. The contraction of the jet is
    assumed to be the same as with air.

    For an ideal nozzle with C and b (0.5283) for air, the error of the flow is up to 0.6 % of the choked flow for
    helium and 0.2 % for carbon dioxide and methane. With an unchanged b, the errors would be 3.1 %, 1.7 % and 1.5 %.

    Examples
    --------
    Helium:

    >>> factor, shift = factors_from_air(5 / 3, 2077.26)
    >>> round(factor, 4), round(0.3 + (1.0 - 0.3) * shift, 4)
    (0.3942, 0.2127)
    """
    check({"isentropic_exponent": isentropic_exponent, "gas_constant": gas_constant}, _DOMAINS)
    factor = nozzle_choked_flux(isentropic_exponent, gas_constant) / nozzle_choked_flux()
    return factor, 1.0 - factor**2 * gas_constant / AIR_GAS_CONSTANT


def conductance_from_flow_coefficient_cv(
    flow_coefficient_cv: float, *, critical_ratio: float | None = None, definition: Definition = "pneumatic"
) -> Conductance:
    r"""Return the sonic conductance that corresponds to the flow coefficient Cv.

    A flow path with this conductance has the flow that Cv defines at small pressure drops.

    .. math::

        C = 114.5 \cdot 10^{-8} \sqrt{\frac{1 - b}{2 T_0}}\, C_v \ \text{(pneumatic)}, \qquad
        C = \frac{10^{-1} \cdot 0.865}{3600\, \rho_0} \sqrt{\frac{1 - b}{2 R T_0}}\, C_v \ \text{(small\_dp)}

    Parameters
    ----------
    flow_coefficient_cv : float
        Flow coefficient Cv: flow of water in US gal/min at a pressure drop of 1 psi.
    critical_ratio : float, optional
        Critical pressure ratio b [1]. The default is 0.3; the note of the result states that this value is assumed.
    definition : str, optional
        "pneumatic": Cv of a pneumatic catalogue, Q = 114.5 Cv sqrt(dp p2/T1), with Q in dm3/s ANR, pressures in bar and
        temperature in K. "small_dp": Cv of a liquid test, which is valid for a gas at pressure drops at which its
        density is nearly constant.

    Returns
    -------
    Conductance
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1].

    Notes
    -----
    C and b are valid for air. For another gas see `factors_from_air`.

    The results of the two definitions differ by 4.5 %: C/Cv = 4.73 sqrt(1 - b) (pneumatic) and 4.94 sqrt(1 - b)
    (small_dp), with C in dm3/(s bar). The pneumatic definition is the default because valve catalogues use it.

    Examples
    --------
    >>> round(conductance_from_flow_coefficient_cv(1.0, critical_ratio=0.2).sonic_conductance * 1e8, 2)
    4.23
    """
    check({"flow_coefficient_cv": flow_coefficient_cv, "critical_ratio": critical_ratio}, _DOMAINS)
    return _from_cv(flow_coefficient_cv, critical_ratio, definition, "Cv")


def conductance_from_flow_coefficient_kv(
    flow_coefficient_kv: float, *, critical_ratio: float | None = None, definition: Definition = "pneumatic"
) -> Conductance:
    r"""Return the sonic conductance that corresponds to the flow coefficient Kv.

    Kv is converted to Cv. For the conversion from Cv to C see `conductance_from_flow_coefficient_cv`.

    .. math:: C = C(C_v), \quad C_v = K_v/0.865

    Parameters
    ----------
    flow_coefficient_kv : float
        Flow coefficient Kv: flow of water in m^3/h at a pressure drop of 1 bar.
    critical_ratio : float, optional
        Critical pressure ratio b [1]. The default is 0.3; the note of the result states that this value is assumed.
    definition : str, optional
        "pneumatic" or "small_dp", see `conductance_from_flow_coefficient_cv`.

    Returns
    -------
    Conductance
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1].

    Examples
    --------
    >>> round(conductance_from_flow_coefficient_kv(0.865, critical_ratio=0.2).sonic_conductance * 1e8, 2)
    4.23
    """
    # Checked by its own name, so an error refers to the argument and not to Cv.
    check({"flow_coefficient_kv": flow_coefficient_kv, "critical_ratio": critical_ratio}, _DOMAINS)
    return _from_cv(flow_coefficient_kv / KV_PER_CV, critical_ratio, definition, "Kv")


def flow_coefficient_cv_from_conductance(
    sonic_conductance: float, critical_ratio: float, *, definition: Definition = "pneumatic"
) -> float:
    r"""Return the flow coefficient Cv of a flow path from sonic conductance and critical ratio.

    .. math:: C_v = C/c(b)

    Here c(b) is the sonic conductance of a flow path with Cv = 1, see `conductance_from_flow_coefficient_cv`.

    Parameters
    ----------
    sonic_conductance, critical_ratio : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1].
    definition : str, optional
        "pneumatic" or "small_dp", see `conductance_from_flow_coefficient_cv`.

    Returns
    -------
    float
        Flow coefficient Cv: flow of water in US gal/min at a pressure drop of 1 psi.

    Examples
    --------
    >>> round(flow_coefficient_cv_from_conductance(3.956e-8, 0.3), 3)
    1.0
    """
    check({"sonic_conductance": sonic_conductance, "critical_ratio": critical_ratio}, _DOMAINS)
    return sonic_conductance / _conductance_per_cv(critical_ratio, definition)


def flow_coefficient_kv_from_conductance(
    sonic_conductance: float, critical_ratio: float, *, definition: Definition = "pneumatic"
) -> float:
    r"""Return the flow coefficient Kv of a flow path from sonic conductance and critical ratio.

    .. math:: K_v = 0.865\, C_v

    Parameters
    ----------
    sonic_conductance, critical_ratio : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1].
    definition : str, optional
        "pneumatic" or "small_dp", see `conductance_from_flow_coefficient_cv`.

    Returns
    -------
    float
        Flow coefficient Kv: flow of water in m^3/h at a pressure drop of 1 bar.

    Examples
    --------
    >>> round(flow_coefficient_kv_from_conductance(3.956e-8, 0.3), 3)
    0.865
    """
    return KV_PER_CV * flow_coefficient_cv_from_conductance(sonic_conductance, critical_ratio, definition=definition)


def conductance_from_nominal_flow(
    nominal_flow: float,
    *,
    critical_ratio: float | None = None,
    subsonic_index: float = 0.5,
    atmosphere: float = STANDARD_ATMOSPHERE,
) -> Conductance:
    r"""Return the sonic conductance that corresponds to the nominal flow qNn.

    The nominal flow is the flow from 6 bar to 5 bar gauge at 20 degC.

    .. math:: C = q_{Nn} \Big/ \frac{q_m(C = 1;\ 6\,\text{bar g},\ 5\,\text{bar g},\ T_0)}{\rho_0}

    Parameters
    ----------
    nominal_flow : float
        Volume flow rate at the reference atmosphere ANR, 20 degC and 1 bar [m^3/s].
    critical_ratio : float, optional
        Critical pressure ratio b [1]. The default is 0.3; the note of the result states that this value is assumed.
    subsonic_index, atmosphere : float, optional
        Subsonic index m [1], and absolute ambient pressure to which the gauge pressures of 6 and 5 bar refer [Pa].

    Returns
    -------
    Conductance
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1].

    Notes
    -----
    C and b are valid for air. For another gas see `factors_from_air`.

    Catalogues seldom state the ambient pressure to which the gauge pressures refer. C changes by 0.1 % between ambient
    pressures of 1.0 and 1.01325 bar. The assumed b has a larger effect: from b = 0.2 to 0.5, C decreases by 18 %.

    References
    ----------
    VDI 3290 and manufacturers' practice: nominal flow from 6 to 5 bar gauge.

    Examples
    --------
    >>> given = conductance_from_nominal_flow(380e-3 / 60)
    >>> round(given.sonic_conductance * 1e8, 3), given.critical_ratio, given.critical_ratio_assumed
    (1.493, 0.3, True)
    """
    check({"nominal_flow": nominal_flow, "critical_ratio": critical_ratio, "atmosphere": atmosphere}, _DOMAINS)
    ratio, assumed = _ratio_or_default(critical_ratio)
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
    r"""Return the nominal flow qNn of a flow path.

    The nominal flow is the flow from 6 bar to 5 bar gauge at 20 degC.

    .. math:: q_{Nn} = q_m(6\,\text{bar g},\ 5\,\text{bar g},\ T_0)/\rho_0

    Parameters
    ----------
    sonic_conductance, critical_ratio : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1].
    subsonic_index, atmosphere : float, optional
        Subsonic index m [1], and absolute ambient pressure to which the gauge pressures of 6 and 5 bar refer [Pa].

    Returns
    -------
    float
        Volume flow rate at the reference atmosphere ANR, 20 degC and 1 bar [m^3/s].

    Examples
    --------
    >>> round(nominal_flow_from_conductance(1e-8, 0.3, atmosphere=1e5) * 60e3, 1)
    254.3
    """
    check({"sonic_conductance": sonic_conductance, "atmosphere": atmosphere}, _DOMAINS)
    return sonic_conductance * _nominal_flow_per_conductance(critical_ratio, subsonic_index, atmosphere)


def volume_from_mass_flow_rate(mass_flow_rate: float, atmosphere: ReferenceAtmosphere = ANR) -> float:
    r"""Convert a mass flow rate to a volume flow rate at a reference atmosphere.

    .. math:: Q = q_m/\rho_\mathrm{ref}

    Parameters
    ----------
    mass_flow_rate : float or array
        Mass flow rate [kg/s].
    atmosphere : ReferenceAtmosphere, optional
        `poppet.core.units.ANR` (20 degC, 1 bar) or `poppet.core.units.NORMAL` (0 degC, 1.01325 bar).

    Returns
    -------
    float or array
        Volume flow rate at the reference atmosphere [m^3/s].

    Notes
    -----
    The same moist air has a volume of 1 m3 in ANR and of 0.9196 m3 in the normal atmosphere. Dry air would have
    densities of 1.1884 and 1.2929 kg/m3.

    Examples
    --------
    >>> round(volume_from_mass_flow_rate(1.185) * 1e3)
    1000
    """
    return mass_flow_rate / atmosphere.density


def mass_from_volume_flow_rate(volume_flow_rate: float, atmosphere: ReferenceAtmosphere = ANR) -> float:
    r"""Convert a volume flow rate at a reference atmosphere to a mass flow rate.

    .. math:: q_m = \rho_\mathrm{ref} Q

    Parameters
    ----------
    volume_flow_rate : float or array
        Volume flow rate at the reference atmosphere [m^3/s].
    atmosphere : ReferenceAtmosphere, optional
        `poppet.core.units.ANR` (20 degC, 1 bar) or `poppet.core.units.NORMAL` (0 degC, 1.01325 bar).

    Returns
    -------
    float or array
        Mass flow rate [kg/s].

    Examples
    --------
    >>> round(mass_from_volume_flow_rate(600e-3 / 60), 5)
    0.01185
    """
    return volume_flow_rate * atmosphere.density


_DEFINITIONS: dict[str, str] = {
    "pneumatic": "pneumatic definition (114.5)",
    "small_dp": "liquid definition (equal at small pressure drops)",
}


def _ratio_or_default(critical_ratio: float | None) -> tuple[float, str]:
    """Return the critical pressure ratio, and a text for the note of the conversion.

    If `critical_ratio` is None, the result is 0.3, and the text states that this is assumed. Otherwise the text is
    empty.
    """
    if critical_ratio is not None:
        return critical_ratio, ""
    return ASSUMED_CRITICAL_RATIO, f"; b = {ASSUMED_CRITICAL_RATIO} is assumed: one number cannot give C and b"


def _from_cv(cv: float, critical_ratio: float | None, definition: Definition, coefficient: str) -> Conductance:
    ratio, note = _ratio_or_default(critical_ratio)
    conductance = cv * _conductance_per_cv(ratio, definition)
    return Conductance(conductance, ratio, f"{_DEFINITIONS[definition]} of {coefficient}{note}", critical_ratio is None)


def _text(value: Any, form: str = "g") -> str:
    """Return a value as text. A symbol is shown by its name."""
    return str(value) if is_symbolic(value) else format(value, form)


def _conductance_per_area(isentropic_exponent: float, gas_constant: float) -> float:
    return nozzle_choked_flux(isentropic_exponent, gas_constant) / (ANR.density * math.sqrt(ANR.temperature))


def _conductance_per_cv(critical_ratio: float, definition: Definition) -> float:
    """Return the sonic conductance for a flow coefficient Cv of 1 [m^3/(s Pa)].

    The value is valid for small pressure drops, where the ellipse of the flow law gives q = C rho0 sqrt(T0/T1) sqrt(2
    dp p/(1 - b)).
    """
    root: float = sqrt((1.0 - critical_ratio) / (2.0 * ANR.temperature))
    if definition == "pneumatic":
        return _PNEUMATIC_CV * root
    if definition == "small_dp":
        # Q = Kv/3600 sqrt((dp/1e5) (1000/rho)), so q = rho Q = Kv/3600 sqrt(0.01 dp rho), rho = p/(R T)
        return KV_PER_CV / 3600.0 * 0.1 * root / (ANR.density * math.sqrt(AIR_GAS_CONSTANT))
    near, meaning = NameSuggestion(definition, _DEFINITIONS), "definition of the flow coefficient"
    raise InputError("fields.not_an_option", "definition", value=definition, meaning=meaning, suggestion=near)


def _nominal_flow_per_conductance(critical_ratio: float, subsonic_index: float, atmosphere: float) -> float:
    """Return the nominal flow qNn of a flow path divided by its sonic conductance [Pa]."""
    # The law is linear in C, and both nominal pressures lie well outside the regularised zone.
    pressures = NOMINAL_INLET_GAUGE + atmosphere, NOMINAL_OUTLET_GAUGE + atmosphere
    size: dict[str, Any] = {
        "sonic_conductance": 1.0,
        "critical_ratio": critical_ratio,
        "subsonic_index": subsonic_index,
    }
    flow: float = flow_law(*pressures, ANR.temperature, **size)
    return flow / ANR.density
