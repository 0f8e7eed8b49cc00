"""Elements with two stable positions and hysteresis: closing elements, bistable spools, and relays."""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import clip

END_GAIN = 50.0
"""Gain of the position; the element covers the last 1/50 of its travel exponentially.

At an end, it has its full speed from a drive that exceeds the limit by 1/50."""


def switching_rate(position: Any, drive: Any, switching_time: Any) -> Any:
    r"""Return the speed [1/s] of an element that switches between the positions 0 and 1.

    .. math:: \dot x = \frac{1}{T} \operatorname{clip}\bigl(g_e (x_w - x), -1, 1\bigr), \qquad
              x_w = \operatorname{clip}(d + 3 x - 1, 0, 1)

    `drive` d is the driving quantity per half width of the hysteresis, for example a pressure difference divided by the
    switching pressure. The element moves to 1 if the drive exceeds 1, and to 0 if it is below -1. Between these limits,
    it keeps its end position. `switching_time` T is the time from one end to the other [s], and :math:`g_e` `END_GAIN`.
    A larger gain of the drive would let an element between its ends oscillate fast, if the drive depends on its flow.
    """
    target = clip(drive + 3.0 * position - 1.0, 0.0, 1.0)
    return clip(END_GAIN * (target - position), -1.0, 1.0) / switching_time
