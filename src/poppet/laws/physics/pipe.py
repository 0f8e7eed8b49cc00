"""Friction of gas in a straight round tube for laminar, transitional and turbulent flow."""

from __future__ import annotations

import math
from typing import Any

from poppet.core.symbolic import log, maximum, smoothstep

LAMINAR_REYNOLDS, TURBULENT_REYNOLDS = 2000.0, 4000.0
"""Reynolds numbers up to which a flow is laminar, and from which on it is turbulent."""
AIR_VISCOSITY_ANR = 1.82e-5
"""Dynamic viscosity of air at 20 degC, by Sutherland's law with the coefficients of White [Pa s]."""


def laminar_resistance(length: Any, bore: Any, density: Any, viscosity: Any) -> Any:
    r"""Return the pressure drop per mass flow rate of laminar flow (Hagen-Poiseuille).

    .. math:: \frac{\Delta p}{q} = \frac{128\, \mu L}{\pi \varrho d^4}

    Parameters
    ----------
    length, bore : float, array or symbol
        Length L and bore d of the tube [m].
    density : float, array or symbol
        Density of the gas [kg/m^3].
    viscosity : float, array or symbol
        Dynamic viscosity [Pa s].

    Returns
    -------
    float, array or symbol
        Pressure drop per mass flow rate [Pa s/kg].

    Notes
    -----
    The law is valid for developed flow that changes slowly. In oscillations, the velocity near the wall leads the
    velocity at the centre. Above a few times the angular frequency :math:`\omega = 16 \mu/(\varrho d^2)`, the drop is
    therefore larger and has a component in phase with the acceleration (Zielke 1968, Trans. ASME J. Basic Eng. 90,
    109-115). This law neglects both effects.

    Examples
    --------
    >>> print(f"{laminar_resistance(1.0, 4e-3, 1.19, 1.82e-5):.3g} Pa s/kg")
    2.43e+06 Pa s/kg
    """
    return 128.0 * viscosity * length / (math.pi * density * bore**4)


def turbulent_factor(reynolds: Any, relative_roughness: Any) -> Any:
    r"""Return the Darcy friction factor of developed turbulent flow.

    .. math:: \frac{1}{\sqrt f} = -2 \lg\left(\frac{\varepsilon/d}{3.7} + \frac{2.51}{\mathrm{Re} \sqrt{f_H}}\right),
              \qquad \frac{1}{\sqrt{f_H}} = -1.8 \lg\left(\left(\frac{\varepsilon/d}{3.7}\right)^{1.11} +
              \frac{6.9}{\mathrm{Re}}\right)

    Parameters
    ----------
    reynolds : float, array or symbol
        Reynolds number, above zero [1].
    relative_roughness : float, array or symbol
        Height :math:`\varepsilon` of the roughness divided by the bore d [1].

    Returns
    -------
    float, array or symbol
        Darcy friction factor f [1].

    Notes
    -----
    The result is one iteration of Colebrook's equation, starting from Haaland's formula :math:`f_H`. It is within 0.3 %
    of the solution of Colebrook's equation for Reynolds numbers from 4000 to 1e8 and a relative roughness up to 0.05
    (tests/unit).

    References
    ----------
    Colebrook 1939, J. ICE 11, 133-156; Haaland 1983, Trans. ASME J. Fluids Eng. 105, 89-90.

    Examples
    --------
    >>> round(turbulent_factor(1e5, 0.0), 4)
    0.018
    """
    first = -1.8 / math.log(10.0) * log((relative_roughness / 3.7) ** 1.11 + 6.9 / reynolds)
    second = -2.0 / math.log(10.0) * log(relative_roughness / 3.7 + 2.51 * first / reynolds)
    return 1.0 / second**2


def reynolds_number(mass_flow_rate: Any, bore: Any, viscosity: Any) -> Any:
    r"""Return the Reynolds number of the flow in a round tube.

    .. math:: \mathrm{Re} = \frac{4 |q|}{\pi d \mu}

    Parameters
    ----------
    mass_flow_rate : float, array or symbol
        Mass flow rate q; its sign has no effect [kg/s].
    bore : float, array or symbol
        Bore d [m].
    viscosity : float, array or symbol
        Dynamic viscosity [Pa s].

    Returns
    -------
    float, array or symbol
        Reynolds number [1].

    Examples
    --------
    >>> round(reynolds_number(1e-3, 4e-3, 1.82e-5))
    17490
    """
    return 4.0 * abs(mass_flow_rate) / (math.pi * bore * viscosity)


def between_laminar_and_turbulent(reynolds: Any, laminar: Any, turbulent: Any) -> Any:
    """Return a pressure drop that changes smoothly from a laminar to a turbulent value.

    The result is the laminar value up to Re = 2000 and the turbulent value from Re = 4000. Its derivative is
    continuous.

    Parameters
    ----------
    reynolds : float, array or symbol
        Reynolds number of the flow [1].
    laminar, turbulent : float, array or symbol
        Pressure drops by the laws of laminar and of turbulent flow, both in the same unit.

    Returns
    -------
    float, array or symbol
        Pressure drop, in the unit of `laminar` and `turbulent`.

    Examples
    --------
    >>> [between_laminar_and_turbulent(re, 1.0, 2.0) for re in (1000.0, 3000.0, 5000.0)]
    [1.0, 1.5, 2.0]
    """
    return laminar + smoothstep(reynolds, LAMINAR_REYNOLDS, TURBULENT_REYNOLDS) * (turbulent - laminar)


def darcy_coefficient(mass_flow_rate: Any, length: Any, bore: Any, density: Any, viscosity: Any, roughness: Any) -> Any:
    r"""Return the pressure drop per squared mass flow rate of turbulent flow (Darcy-Weisbach).

    .. math:: \frac{\Delta p}{q^2} = f \frac{L}{d} \frac{1}{2 \varrho A^2}

    Parameters
    ----------
    mass_flow_rate : float, array or symbol
        Mass flow rate, on which the friction factor f depends; its sign has no effect [kg/s].
    length, bore : float, array or symbol
        Length L and bore d of the tube [m].
    density : float, array or symbol
        Density of the gas [kg/m^3]. With the mean density of both ends, the drop is that of compressible isothermal
        flow.
    viscosity : float, array or symbol
        Dynamic viscosity [Pa s].
    roughness : float, array or symbol
        Height of the roughness of the wall [m].

    Returns
    -------
    float, array or symbol
        Pressure drop per squared mass flow rate [Pa s^2/kg^2]. Below Re = 2000 the law is not valid; the friction
        factor is then that at Re = 2000.

    Examples
    --------
    >>> print(f"{darcy_coefficient(1e-3, 1.0, 4e-3, 1.19, 1.82e-5, 0.0) * 1e-6:.0f} Pa at 1 g/s")
    17808 Pa at 1 g/s
    """
    reynolds = maximum(reynolds_number(mass_flow_rate, bore, viscosity), LAMINAR_REYNOLDS)
    area = 0.25 * math.pi * bore**2
    return turbulent_factor(reynolds, roughness / bore) * length / (2.0 * density * bore * area * area)
