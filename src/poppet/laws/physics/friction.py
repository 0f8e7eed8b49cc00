"""Dry friction with sticking: the LuGre and the elasto-plastic model, and their steady friction."""

from __future__ import annotations

import math
from typing import Any

from poppet.core.symbolic import clip, cos, exp, minimum, where

MAX_ELASTIC = 0.98
"""Maximum of the break-away deflection, as a fraction of the steady deflection."""


def sliding_level(velocity: Any, coulomb_force: Any, static_force: Any, stribeck_velocity: Any) -> Any:
    r"""Return the magnitude of dry friction at a constant sliding speed.

    .. math:: g(v) = F_c + (F_s - F_c)\, e^{-(v/v_s)^2}

    Parameters
    ----------
    velocity : float, array or symbol
        Sliding speed v [m/s], or angular speed [rad/s] if the friction is a torque.
    coulomb_force, static_force : float, array or symbol
        Coulomb friction :math:`F_c` at moderate speed and break-away force :math:`F_s` [N], or torques [N m].
    stribeck_velocity : float, array or symbol
        Stribeck velocity :math:`v_s`, the scale of the decrease from break-away to Coulomb friction [m/s] or [rad/s].

    Returns
    -------
    float, array or symbol
        Magnitude of the friction [N] or [N m].

    References
    ----------
    Armstrong-Helouvry, Dupont & Canudas de Wit 1994, Automatica 30, 1083-1138.

    Examples
    --------
    >>> sliding_level(0.0, 20.0, 30.0, 0.02)
    30.0
    """
    return coulomb_force + (static_force - coulomb_force) * exp(-((velocity / stribeck_velocity) ** 2))


def bristle_rate(deflection: Any, velocity: Any, level: Any, stiffness: Any) -> Any:
    r"""Return the rate of change of the bristle deflection in the LuGre model.

    .. math:: \dot z = v - \frac{\sigma_0 |v|}{g(v)}\, z

    Parameters
    ----------
    deflection, velocity : float, array or symbol
        Deflection z [m] and sliding speed v [m/s].
    level : float, array or symbol
        Friction g at this speed by `sliding_level`, above zero [N].
    stiffness : float, array or symbol
        Bristle stiffness :math:`\sigma_0` [N/m].

    Returns
    -------
    float, array or symbol
        Rate of change [m/s], which is zero at the deflection of steady sliding, |z| = g/sigma_0.

    References
    ----------
    Canudas de Wit, Olsson, Astrom & Lischinsky 1995, IEEE Trans. Automatic Control 40, 419-425.

    Examples
    --------
    >>> bristle_rate(1e-5, 0.1, 9.0, 9e5)
    0.0
    """
    return velocity - stiffness * abs(velocity) / level * deflection


def elasto_plastic_rate(deflection: Any, velocity: Any, level: Any, stiffness: Any, breakaway: Any) -> Any:
    r"""Return the rate of change of the bristle deflection in the elasto-plastic model.

    .. math:: \dot z = v \left(1 - \alpha(z, v)\, \frac{z}{z_{ss}}\right) \text{ for } v z > 0, \qquad
              \dot z = v \text{ otherwise}, \qquad z_{ss} = \frac{g(v)}{\sigma_0} \operatorname{sgn} v

    .. math:: \alpha = \begin{cases} 0 & |z| \le z_{ba} \\
              \tfrac{1}{2} + \tfrac{1}{2} \sin\left(\pi\, \frac{|z| - (z_{max} + z_{ba})/2}{z_{max} - z_{ba}}\right)
              & z_{ba} < |z| < z_{max} \\ 1 & |z| \ge z_{max} = |z_{ss}| \end{cases}

    Parameters
    ----------
    deflection, velocity : float, array or symbol
        Deflection z [m] and sliding speed v [m/s].
    level : float, array or symbol
        Friction g at this speed by `sliding_level`, above zero [N].
    stiffness : float, array or symbol
        Bristle stiffness :math:`\sigma_0` [N/m].
    breakaway : float, array or symbol
        Deflection :math:`z_{ba}` up to which the motion is elastic [m].

    Returns
    -------
    float, array or symbol
        Rate of change [m/s], which is zero at the deflection of steady sliding, |z| = g/sigma_0.

    Notes
    -----
    Up to the break-away deflection, the position follows the load reversibly: the body does not drift under loads below
    :math:`\sigma_0 z_{ba}`. The model requires :math:`z_{ba} < |z_{ss}|` at all speeds, so :math:`z_{ba}` is limited to
    98 % of :math:`|z_{ss}|`.

    References
    ----------
    Dupont, Hayward, Armstrong & Altpeter 2002, IEEE Trans. Automatic Control 47, 787-792.

    Examples
    --------
    >>> elasto_plastic_rate(5e-6, 0.1, 9.0, 9e5, 7e-6)
    0.1
    >>> elasto_plastic_rate(1e-5, 0.1, 9.0, 9e5, 7e-6)
    0.0
    """
    steady = level / stiffness
    elastic = minimum(breakaway, MAX_ELASTIC * steady)
    # The sine of the reference, with its argument shifted by a quarter of a period.
    plastic = 0.5 - 0.5 * cos(math.pi * clip((abs(deflection) - elastic) / (steady - elastic), 0.0, 1.0))
    return where(velocity * deflection > 0.0, velocity - plastic * abs(velocity) * deflection / steady, velocity)


def lugre_force(
    deflection: Any, deflection_rate: Any, velocity: Any, stiffness: Any, damping: Any, stribeck_velocity: Any
) -> Any:
    r"""Return the friction force of a bristle model without the viscous term.

    .. math:: F = \sigma_0 z + \sigma_1 e^{-(v/v_s)^2}\, \dot z

    Parameters
    ----------
    deflection, deflection_rate, velocity : float, array or symbol
        Deflection z [m] of the bristles, its rate [m/s], and the sliding speed v [m/s].
    stiffness, damping : float, array or symbol
        Bristle stiffness :math:`\sigma_0` [N/m] and damping :math:`\sigma_1` [N s/m].
    stribeck_velocity : float, array or symbol
        Stribeck velocity :math:`v_s`, the scale of the decrease of the damping with the speed [m/s].

    Returns
    -------
    float, array or symbol
        Force against the motion [N].

    Notes
    -----
    With constant damping, the LuGre model generates energy at moderate speeds. With the decreasing damping it generates
    none if :math:`\sigma_1 e^{-(v/v_s)^2} \le 4 g(v)/|v|`, where g is the friction of `sliding_level`. The
    elasto-plastic model needs this condition only while the deflection exceeds the deflection of steady sliding.

    References
    ----------
    Olsson 1996, thesis, Lund, for the decreasing damping; Barahona & Canudas de Wit 2002, ACC, for its passivity.

    Examples
    --------
    >>> lugre_force(1e-5, 0.0, 0.1, 9e5, 100.0, 0.01)
    9.0
    """
    fading = exp(-((velocity / stribeck_velocity) ** 2))
    return stiffness * deflection + damping * fading * deflection_rate
