"""Isentropic flow through an ideal nozzle, which the ellipse of ISO 6358 approximates."""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import clip, maximum, minimum, sqrt, where
from poppet.laws.iso6358.domain import DOMAINS, Domain
from poppet.laws.iso6358.evaluation import evaluate
from poppet.laws.physics.gas import AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT

_VACUUM = 1e-30  # upstream pressure when both sides are evacuated, so that 0/0 does not occur [Pa]

NOZZLE_DOMAINS = DOMAINS | {
    "effective_area": Domain("iso6358.area", "m^2"),
    "gas_constant": Domain("iso6358.gas_constant", "J/(kg K)", open_low=True),
    "isentropic_exponent": Domain("iso6358.isentropic_exponent", "", low=1.0, open_low=True),
}


def nozzle_critical_ratio(isentropic_exponent: float = AIR_ISENTROPIC_EXPONENT) -> float:
    r"""Return the critical pressure ratio of an ideal nozzle.

    The nozzle is choked at this ratio p2/p1 and below.

    .. math:: b = \left(\frac{2}{\kappa + 1}\right)^{\kappa/(\kappa - 1)}

    Parameters
    ----------
    isentropic_exponent : float, optional
        Ratio of specific heats, above 1.

    Returns
    -------
    float
        Critical pressure ratio.

    Examples
    --------
    >>> round(nozzle_critical_ratio(), 4)
    0.5283
    """
    kappa = isentropic_exponent
    ratio: float = (2.0 / (kappa + 1.0)) ** (kappa / (kappa - 1.0))
    return ratio


def nozzle_choked_flux(
    isentropic_exponent: float = AIR_ISENTROPIC_EXPONENT, gas_constant: float = AIR_GAS_CONSTANT
) -> float:
    r"""Return the flux function of an ideal nozzle: its normalised choked mass flow rate.

    .. math:: \frac{q_m \sqrt{T_1}}{A\,p_1} = \sqrt{\frac{\kappa}{R}}
              \left(\frac{2}{\kappa + 1}\right)^{(\kappa + 1)/(2 (\kappa - 1))}

    Parameters
    ----------
    isentropic_exponent, gas_constant : float, optional
        Ratio of specific heats, above 1, and specific gas constant [J/(kg K)].

    Returns
    -------
    float
        Choked mass flow rate times the root of the upstream temperature, divided by area and upstream pressure
        [K^0.5 s/m].

    Examples
    --------
    >>> round(nozzle_choked_flux(), 6)
    0.040415
    """
    kappa = isentropic_exponent
    exponent = (kappa + 1.0) / (2.0 * (kappa - 1.0))
    flux: float = sqrt(kappa / gas_constant) * (2.0 / (kappa + 1.0)) ** exponent
    return flux


def nozzle_mass_flow_rate(
    pressure_1: Any,
    pressure_2: Any,
    temperature_1: Any,
    temperature_2: Any = None,
    *,
    effective_area: Any,
    isentropic_exponent: float = AIR_ISENTROPIC_EXPONENT,
    gas_constant: float = AIR_GAS_CONSTANT,
) -> Any:
    r"""Return the mass flow rate of an ideal nozzle, positive from port 1 to port 2.

    .. math::

        q_m = A p_1 \sqrt{\frac{2 \kappa}{(\kappa - 1) R T_1}}
              \sqrt{r^{2/\kappa} - r^{(\kappa + 1)/\kappa}}, \quad
        r = \max\left(\frac{p_2}{p_1}, \left(\frac{2}{\kappa + 1}\right)^{\kappa/(\kappa - 1)}\right)

    Parameters
    ----------
    pressure_1, pressure_2 : float, array or symbol
        Absolute pressures at the ports [Pa].
    temperature_1 : float, array or symbol
        Stagnation temperature of the gas at port 1 [K].
    temperature_2 : float, array or symbol, optional
        Stagnation temperature of the gas at port 2 [K] (default: `temperature_1`).
    effective_area : float, array or symbol
        Area of the throat times its discharge coefficient [m^2].
    isentropic_exponent, gas_constant : float, optional
        Ratio of specific heats, above 1, and specific gas constant [J/(kg K)].

    Returns
    -------
    float, array or symbol
        Mass flow rate [kg/s].

    Notes
    -----
    The flow is isentropic, and the gas is ideal with constant specific heats. The law is not regularised, so its slope
    is infinite at equal pressures. Use it for comparisons; for a simulation, convert the area to C and b. The law of
    ISO 6358 with b = 0.5283 differs from it by at most 0.152 % of the choked flow, at p2/p1 = 0.872.

    References
    ----------
    Shapiro, The Dynamics and Thermodynamics of Compressible Fluid Flow, vol. 1, chapter 4 (isentropic flow).

    Examples
    --------
    >>> round(nozzle_mass_flow_rate(7e5, 1e5, 293.15, effective_area=1e-6), 7)
    0.0016523
    """
    return evaluate(_nozzle, dict(locals()), NOZZLE_DOMAINS)[0]


def _nozzle(
    pressure_1: Any,
    pressure_2: Any,
    temperature_1: Any,
    temperature_2: Any,
    effective_area: Any,
    isentropic_exponent: float,
    gas_constant: float,
) -> tuple[Any, ...]:
    kappa = isentropic_exponent
    upstream = maximum(pressure_1, pressure_2)
    ratio = minimum(pressure_1, pressure_2) / maximum(upstream, _VACUUM)
    # The limit of the ratio represents choking: below it the state in the throat is constant.
    ratio = clip(ratio, nozzle_critical_ratio(kappa), 1.0)
    throat = ratio ** (2.0 / kappa) * (1.0 - ratio ** ((kappa - 1.0) / kappa))
    forward = pressure_1 >= pressure_2
    temperature = temperature_1 if temperature_2 is None else where(forward, temperature_1, temperature_2)
    speed = sqrt(2.0 * kappa / ((kappa - 1.0) * gas_constant * temperature))
    return (where(forward, 1.0, -1.0) * effective_area * upstream * speed * sqrt(throat),)
