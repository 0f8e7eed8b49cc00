"""Compensation of the dead zone of a valve, and its inverse, for floats, arrays and symbols."""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import maximum, minimum


def add_dead_zone(command: Any, positive: Any, negative: Any, smoothing: Any) -> Any:
    r"""Return the command that compensates the dead zone of a valve (smoothed inverse of a dead zone).

    .. math:: u = v + z_+ \operatorname{clip}\left(\frac{v}{h}, 0, 1\right)
              - z_- \operatorname{clip}\left(-\frac{v}{h}, 0, 1\right)

    Parameters
    ----------
    command : float, array or symbol
        Command v of the control law [1].
    positive, negative : float or symbol
        Dead zones :math:`z_+` of positive and :math:`z_-` of negative commands, not below 0 [1].
    smoothing : float or symbol
        Magnitude h of the command at which the compensation is complete, above 0 [1].

    Returns
    -------
    float, array or symbol
        Command u of the valve [1].

    Notes
    -----
    The result is continuous and strictly increasing. If the valve opens by u - :math:`z_+` for u > :math:`z_+`, it
    opens by exactly v for every v >= h. Below h, the slope is :math:`1 + z_+/h`, and the valve opens for v >
    :math:`h z_+/(h + z_+)`. A dead zone remains near zero, so sensor noise does not open the valve.

    References
    ----------
    Tao & Kokotovic, Adaptive control of plants with unknown dead-zones, IEEE Trans. Automatic Control 39 (1994) 59-68:
    inverse of a dead zone. Andrighetto, Valdiero & Bavaresco, Dead zone compensation in pneumatic servo systems, ABCM
    Symposium Series in Mechatronics 3 (2008) 501-509: its line through zero.

    Examples
    --------
    >>> [add_dead_zone(v, 0.1, 0.2, 0.02) for v in (0.0, 0.01, 0.02, 0.5, -0.5)]
    [0.0, 0.060000000000000005, 0.12000000000000001, 0.6, -0.7]
    """
    rising = positive * minimum(maximum(command, 0.0) / smoothing, 1.0)
    falling = negative * minimum(maximum(-command, 0.0) / smoothing, 1.0)
    return command + rising - falling


def remove_dead_zone(command: Any, positive: Any, negative: Any, smoothing: Any) -> Any:
    r"""Return the command before dead-zone compensation, from the compensated command.

    It is the inverse of `add_dead_zone`.

    .. math:: v = \max\left(\frac{h u}{h + z_+}, u - z_+\right), \quad u \ge 0

    Parameters
    ----------
    command : float, array or symbol
        Command u of the valve [1].
    positive, negative : float or symbol
        Dead zones :math:`z_+` of positive and :math:`z_-` of negative commands, not below 0 [1].
    smoothing : float or symbol
        Magnitude h of the command v at which the compensation is complete, above 0 [1].

    Returns
    -------
    float, array or symbol
        Command v of the control law [1].

    Notes
    -----
    The result is exact for all finite commands. For negative commands, the law has the opposite signs and
    :math:`z_-`.

    Examples
    --------
    >>> [round(remove_dead_zone(u, 0.1, 0.2, 0.02), 12) for u in (0.0, 0.06, 0.12, 0.6, -0.7)]
    [0.0, 0.01, 0.02, 0.5, -0.5]
    """
    rising, falling = maximum(command, 0.0), maximum(-command, 0.0)
    return maximum(rising * smoothing / (smoothing + positive), rising - positive) - maximum(
        falling * smoothing / (smoothing + negative), falling - negative
    )
