"""Laws of contact and friction: end stops, valve seats and Stribeck friction."""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import exp, maximum, smoothstep, sqrt, tanh

SMALLEST_PENETRATION = 1e-15
"""Depth below which a line replaces the power 3/2, because the derivative must be finite at first contact [m]."""


def saturation(value: Any) -> Any:
    r"""Return a smooth saturation function with values between -1 and 1.

    .. math:: \frac{s}{\sqrt{1 + s^2}}

    Parameters
    ----------
    value : float, array or symbol
        Argument s [1].

    Returns
    -------
    float, array or symbol
        Odd and increasing in s, with slope 1 at zero [1].

    Examples
    --------
    >>> saturation(0.75)
    0.6
    """
    return value / sqrt(1.0 + value * value)


def stop_force(penetration: Any, penetration_rate: Any, stiffness: Any, dissipation: Any) -> Any:
    r"""Return the contact force of an end stop on a body.

    .. math:: F = k\, d^{3/2} \left(1 + \frac{s}{\sqrt{1 + s^2}}\right),\quad s = \lambda\, \dot d

    Parameters
    ----------
    penetration, penetration_rate : float, array or symbol
        Depth d of penetration of the body into the stop, negative without contact [m], and its rate of change
        [m/s].
    stiffness, dissipation : float, array or symbol
        Contact stiffness k [N/m^1.5], and dissipation coefficient :math:`\lambda`, the inverse of the speed at which
        damping saturates [s/m].

    Returns
    -------
    float, array or symbol
        Force against the motion into the stop, never negative [N].

    Notes
    -----
    Hunt and Crossley's factor is :math:`1 + s`; it gives a pulling force if the body leaves the stop at a speed above
    the inverse of the dissipation. The factor in the parentheses above has the same slope at zero speed, is between 0
    and 2, and dissipates energy in each contact. The law is not accurate at all speeds, because it is not the law of a
    material.

    References
    ----------
    Hunt & Crossley 1975, J. Appl. Mech. 42, 440-445, for the factor without the bound.

    Examples
    --------
    A stop of 7.07e9 N/m^1.5 carries 20 N at a depth of 2 um:

    >>> round(stop_force(2e-6, 0.0, 7.07e9, 100.0), 2)
    20.0
    """
    depth = maximum(penetration, 0.0)
    # Not depth ** 1.5: a symbol's derivative of the power is not finite at zero, that of a root held above zero is.
    elastic = stiffness * depth * sqrt(maximum(depth, SMALLEST_PENETRATION))
    return elastic * (1.0 + saturation(dissipation * penetration_rate))


def seat_fraction(stroke: Any, width: Any) -> Any:
    r"""Return the fraction of the lower spring force of a main stage that acts on the plate.

    The lower spring presses the poppet on its seat. If the plate lifts the poppet, the spring acts on the plate.

    .. math:: f = 3 s^2 - 2 s^3,\quad s = \min(\max(1 + x/w, 0), 1)

    Parameters
    ----------
    stroke : float, array or symbol
        Stroke x of the plate; for positive x the poppet is lifted off its seat [m].
    width : float, array or symbol
        Width w of the range of strokes below zero in which the force changes between seat and plate [m].

    Returns
    -------
    float, array or symbol
        Fraction f: 0 for strokes up to -w, at which the seat carries the force, and 1 for strokes of 0 and above [1].

    Notes
    -----
    The ramp from -w to 0 replaces the discontinuity of a rigid seat. If the load is between the forces at both ends of
    the ramp, the plate is at rest inside it.

    Examples
    --------
    >>> seat_fraction(-2e-6, 2e-6), seat_fraction(-1e-6, 2e-6), seat_fraction(1e-4, 2e-6)
    (0.0, 0.5, 1.0)
    """
    return smoothstep(stroke, -width, 0.0)


def stribeck_friction(
    velocity: Any,
    coulomb_force: Any,
    static_force: Any,
    stribeck_velocity: Any,
    transition_velocity: Any,
    viscous_damping: Any,
) -> Any:
    r"""Return the friction force of a sliding seal by the Stribeck curve.

    .. math:: F = \left[F_c + (F_s - F_c) e^{-(v/v_s)^2}\right] \tanh(v/v_t) + \sigma_2 v

    Parameters
    ----------
    velocity : float, array or symbol
        Sliding speed v [m/s].
    coulomb_force, static_force : float, array or symbol
        Friction :math:`F_c` at moderate speed and break-away force :math:`F_s` [N].
    stribeck_velocity, transition_velocity : float, array or symbol
        Stribeck velocity :math:`v_s`, the scale of the decrease from break-away to Coulomb friction, and transition
        velocity :math:`v_t`, the scale of the change of sign near zero speed [m/s].
    viscous_damping : float, array or symbol
        Viscous coefficient :math:`\sigma_2` [N s/m].

    Returns
    -------
    float, array or symbol
        Force against the motion, odd in the speed [N].

    Notes
    -----
    At zero speed the force is zero. A body under a load below the break-away force therefore does not stick: it
    creeps at a speed of the order of the transition velocity.

    References
    ----------
    Armstrong-Helouvry, Dupont & Canudas de Wit 1994, Automatica 30, 1083-1138, for the exponential in v.

    Examples
    --------
    >>> round(stribeck_friction(0.1, 10.0, 15.0, 0.01, 1e-3, 20.0), 6)
    12.0
    """
    level = coulomb_force + (static_force - coulomb_force) * exp(-((velocity / stribeck_velocity) ** 2))
    return level * tanh(velocity / transition_velocity) + viscous_damping * velocity
