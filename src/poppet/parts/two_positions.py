"""Elements with two stable positions and hysteresis: closing elements, bistable spools, and relays."""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import clip, maximum, minimum

END_GAIN = 50.0
"""Gain of the position; the element covers the last 1/50 of its travel exponentially."""
DRIVE_GAIN = 10.0
"""Gain of the drive: the element has its full speed from a drive that exceeds the limit by 0.2 %."""

FULL_DRIVE = 2.0
"""Drive from which an element that friction holds has its full speed in all positions."""
FRICTION = 0.8
"""Fraction of the half width of the hysteresis that is friction of a gradual element; the rest holds it at its seat."""


def switching_rate(position: Any, drive: Any, switching_time: Any) -> Any:
    r"""Return the speed [1/s] of an element that switches between the positions 0 and 1.

    .. math:: \dot x = \frac{1}{T} \operatorname{clip}\bigl(g_e (x_w - x), -1, 1\bigr), \qquad
              x_w = \operatorname{clip}\bigl(x + g_d (d + 2 x - 1), 0, 1\bigr)

    `drive` d is the driving quantity per half width of the hysteresis, for example a pressure difference divided by the
    switching pressure. The element moves to 1 if the drive exceeds 1, and to 0 if it is below -1. Between these limits,
    it keeps its end position. `switching_time` T is the time from one end to the other [s].
    """
    return clip(END_GAIN * (switching_target(position, drive) - position), -1.0, 1.0) / switching_time


def switching_target(position: Any, drive: Any) -> Any:
    """Return the position towards which an element that switches between the positions 0 and 1 moves.

    The function `switching_rate` describes the arguments. Beyond the hysteresis, the result is 0 or 1.
    """
    return clip(position + DRIVE_GAIN * (drive + 2.0 * position - 1.0), 0.0, 1.0)


def gradual_switching_rate(position: Any, drive: Any, switching_time: Any) -> Any:
    r"""Return the speed [1/s] of an element between two seats that friction holds in any position.

    .. math:: T \dot x = \operatorname{clip}\bigl(d - \operatorname{clip}(d, -d_f, d_f) + (1 - d_f) (2 x - 1),
              \max(-1, -g x), \min(1, g (1 - x))\bigr)

    The arguments and the hysteresis are those of `switching_rate`; :math:`d_f` is `FRICTION` and g `END_GAIN`. The
    element has its full speed if the drive exceeds 2 or is below -2. Elements whose flow changes their drive need this
    law: with that of `switching_rate`, they oscillate so fast that a run can need a hundred times as many steps.
    """
    low, high = maximum(-1.0, -END_GAIN * position), minimum(1.0, END_GAIN * (1.0 - position))
    beyond_friction = drive - clip(drive, -FRICTION, FRICTION)
    return clip(beyond_friction + (1.0 - FRICTION) * (2.0 * position - 1.0), low, high) / switching_time
