"""A 2/2 solenoid valve under pulse-width modulation: switched, or averaged over a period."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from poppet.core.errors import OutOfRangeError
from poppet.core.symbolic import clip, where
from poppet.parts.fields import NumberLike, number
from poppet.parts.part import NEVER

TIMERS = ("period", "release", "change")
"""Beginning of a period, end of the pulse, and the armature's arrival after its delay."""
MEMORY = ("period_count", "command", "open")
SLEW_WIDTH = 1e-3
"""Distance from its goal below which a slewed opening slows down, so that it comes to rest there."""


@dataclass(frozen=True)
class Solenoid:
    """A 2/2 solenoid valve that pulse-width modulation opens."""

    sonic_conductance: NumberLike = number("m^3/(s Pa)", doc="sonic conductance C of the open valve", low=0.0)
    critical_ratio: NumberLike = number("1", 0.3, doc="critical ratio b", low=0.0, below=1.0)
    frequency: NumberLike = number("Hz", 100.0, doc="frequency of the pulse-width modulation", above=0.0, high=1e5)
    opening_delay: NumberLike = number("s", 0.0, doc="opening delay", low=0.0, note="at once")
    closing_delay: NumberLike = number("s", 0.0, doc="closing delay", low=0.0, note="at once")
    # Left out, the averaged opening follows the duty at once.
    rate_limit: NumberLike = number("1/s", optional=True, doc="fastest change of the averaged opening", above=0.0)


def check(name: str, valve: Solenoid) -> None:
    """Raise `OutOfRangeError` where the delays leave a period no room."""
    lost = (float(valve.opening_delay) + float(valve.closing_delay)) * float(valve.frequency)  # type: ignore[arg-type]
    if lost < 1.0:
        return
    shown = valve.frequency.display()  # type: ignore[union-attr]
    raise OutOfRangeError("valve.no_time_to_open", f"{name}.frequency", shown=shown, periods=lost)


def averaged_opening(duty: Any, frequency: Any, opening_delay: Any, closing_delay: Any) -> Any:
    r"""Fraction of a period that the valve is open.

    .. math:: a(d) = d + (t_c - t_o) f \quad (t_o f < d < 1 - t_c f), \qquad 0 \text{ below}, \qquad 1 \text{ above}

    Examples
    --------
    >>> averaged_opening(0.1, 100.0, 2e-3, 1e-3), round(averaged_opening(0.5, 100.0, 2e-3, 1e-3), 3)
    (0.0, 0.4)
    """
    between = clip(duty + (closing_delay - opening_delay) * frequency, 0.0, 1.0)
    # At the limits themselves the valve is shut below and open above; shut comes last, so that a duty of 0 is shut.
    held = where(duty >= 1.0 - closing_delay * frequency, where(duty > 0.0, 1.0, 0.0), between)
    return where(duty <= opening_delay * frequency, 0.0, held)


def slewed(opening: Any, goal: Any, rate_limit: Any) -> Any:
    """Rate of an opening that follows its goal no faster than `rate_limit` [1/s]."""
    return rate_limit * clip((goal - opening) / SLEW_WIDTH, -1.0, 1.0)


def at_rest() -> dict[str, float]:
    """Memory and timers of a closed valve whose first period begins at time zero."""
    return {"period": 0.0, "release": NEVER, "change": NEVER, "period_count": 0.0, "command": 0.0, "open": 0.0}


def update(
    timer: str, time: Any, own: Mapping[str, Any], duty: Any, frequency: Any, opening_delay: Any, closing_delay: Any
) -> dict[str, Any]:
    """What an instant changes in the memory of a switched valve.

    A command must last for its delay: the armature's arrival is put off by nothing, and called off when the command
    changes back before it.
    """
    if timer == "change":
        return {"change": NEVER, "open": own["command"]}
    if timer == "release":
        # A pulse shorter than the opening delay ends before the armature has moved: it never does.
        closes = where(own["open"] > 0.0, time + closing_delay, NEVER)
        return {"release": NEVER, "command": 0.0, "change": closes}
    # Counted from the start, so that the rounding of a period does not add up.
    count = own["period_count"] + 1.0
    period = 1.0 / frequency
    on = where(duty > 0.0, 1.0, 0.0)
    changes = where(on > 0.0, _armature(own, time, opening_delay, wanted=1.0), _armature(own, time, closing_delay, 0.0))
    return {
        "period": count * period,
        "period_count": count,
        "command": on,
        "release": where(duty >= 1.0, NEVER, where(duty > 0.0, time + duty * period, NEVER)),
        # A duty of 1 is no new command in each period: an armature on its way goes on.
        "change": where(on == own["command"], own["change"], changes),
    }


def _armature(own: Mapping[str, Any], time: Any, delay: Any, wanted: float) -> Any:
    """When the armature arrives after a new command: never, if it is there already."""
    return where(own["open"] == wanted, NEVER, time + delay)
