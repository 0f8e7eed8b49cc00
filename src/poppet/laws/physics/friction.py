"""Dry friction with sticking: the LuGre model and its steady friction."""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import exp


def sliding_level(velocity: Any, coulomb_force: Any, static_force: Any, stribeck_velocity: Any) -> Any:
    r"""Return the magnitude of dry friction at a constant sliding speed.

    .. math:: g(v) = F_c + (F_s - F_c)\, e^{-(v/v_s)^2}

    Parameters
    ----------
    velocity : float, array or symbol
        Sliding speed v [m/s], or [rad/s] with torques.
    coulomb_force, static_force : float, array or symbol
        Friction at moderate speed and break-away force [N], or torques [N m].
    stribeck_velocity : float, array or symbol
        Speed over which friction falls from the break-away to the Coulomb value [m/s] or [rad/s].

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
        Friction g at this speed, above zero [N].
    stiffness : float, array or symbol
        Bristle stiffness :math:`\sigma_0` [N/m].

    Returns
    -------
    float, array or symbol
        Rate [m/s]; zero at the steady deflection, |z| = g/sigma_0.

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
    r"""Return the friction force of the LuGre model without the viscous term.

    .. math:: F = \sigma_0 z + \sigma_1 e^{-(v/v_s)^2}\, \dot z

    Parameters
    ----------
    deflection, deflection_rate, velocity : float, array or symbol
        Deflection z [m] of the bristles, its rate [m/s], and the sliding speed v [m/s].
    stiffness, damping : float, array or symbol
        Bristle stiffness :math:`\sigma_0` [N/m] and damping :math:`\sigma_1` [N s/m].
    stribeck_velocity : float, array or symbol
        Speed over which the damping decreases [m/s].

    Returns
    -------
    float, array or symbol
        Force against the motion [N].

    Notes
    -----
    With a constant damping the model generates energy at moderate speeds. With the decreasing damping it does not if
    :math:`\sigma_1 e^{-(v/v_s)^2} \le 4 g(v)/|v|`.

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
