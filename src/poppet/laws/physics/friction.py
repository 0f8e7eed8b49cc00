"""Dry friction that sticks: the LuGre model, and the level that it slides at."""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import exp


def sliding_level(velocity: Any, coulomb_force: Any, static_force: Any, stribeck_velocity: Any) -> Any:
    r"""Return the dry friction at a steady speed, without its sign.

    .. math:: g(v) = F_c + (F_s - F_c)\, e^{-(v/v_s)^2}

    Parameters
    ----------
    velocity : float, array or symbol
        Sliding speed v [m/s], or [rad/s] with torques.
    coulomb_force, static_force : float, array or symbol
        Friction at moderate speed and break-away force [N], or torques [N m].
    stribeck_velocity : float, array or symbol
        Speed over which friction falls from the one to the other [m/s] or [rad/s].

    Returns
    -------
    float, array or symbol
        [N] or [N m].

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
    r"""Return the rate of the bristle deflection of the LuGre model.

    .. math:: \dot z = v - \frac{\sigma_0 |v|}{g(v)}\, z

    Parameters
    ----------
    deflection, velocity : float, array or symbol
        Deflection z [m] and sliding speed v [m/s].
    level : float, array or symbol
        Friction g at this speed, above zero [N].
    stiffness : float, array or symbol
        Bristle stiffness :math:`\sigma_0` [N/m].

    Returns
    -------
    float, array or symbol
        [m/s]; zero where the bristles are bent as far as the speed bends them, z = g/sigma_0.

    References
    ----------
    Canudas de Wit, Olsson, Astrom & Lischinsky 1995, IEEE Trans. Automatic Control 40, 419-425.

    Examples
    --------
    >>> bristle_rate(1e-5, 0.1, 9.0, 9e5)
    0.0
    """
    return velocity - stiffness * abs(velocity) / level * deflection


def lugre_force(
    deflection: Any, deflection_rate: Any, velocity: Any, stiffness: Any, damping: Any, stribeck_velocity: Any
) -> Any:
    r"""Return the friction of the LuGre model without its viscous part.

    .. math:: F = \sigma_0 z + \sigma_1 e^{-(v/v_s)^2}\, \dot z

    Parameters
    ----------
    deflection, deflection_rate, velocity : float, array or symbol
        Deflection z [m] of the bristles, its rate [m/s], and the sliding speed v [m/s].
    stiffness, damping : float, array or symbol
        Bristle stiffness :math:`\sigma_0` [N/m] and damping :math:`\sigma_1` [N s/m].
    stribeck_velocity : float, array or symbol
        Speed over which the damping fades [m/s].

    Returns
    -------
    float, array or symbol
        Force against the motion [N].

    Notes
    -----
    With a constant damping the model gives energy out at moderate speeds; one that fades with the speed does not as
    long as :math:`\sigma_1 e^{-(v/v_s)^2} \le 4 g(v)/|v|`.

    References
    ----------
    Olsson 1996, thesis, Lund, for the damping that fades; Barahona & Canudas de Wit 2002, ACC, for its passivity.

    Examples
    --------
    >>> lugre_force(1e-5, 0.0, 0.1, 9e5, 100.0, 0.01)
    9.0
    """
    fading = exp(-((velocity / stribeck_velocity) ** 2))
    return stiffness * deflection + damping * fading * deflection_rate
