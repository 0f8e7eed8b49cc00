"""Solenoid valve (2/2) with pulse-width modulation, either switched or averaged over a period."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from poppet.core.errors import OutOfRangeError
from poppet.core.symbolic import clip, where
from poppet.parts.fields import NumberLike, number
from poppet.parts.part import NEVER

TIMERS = ("period", "release", "change")
"""Start of a period, end of a pulse, and arrival of the armature after its delay."""
MEMORY = ("period_count", "command", "open")
SLEW_WIDTH = 1e-3
"""Distance from the target below which a rate-limited opening decelerates."""


@dataclass(frozen=True)
class Solenoid:
    """Parameters of a 2/2 solenoid valve with pulse-width modulation."""

    sonic_conductance: NumberLike = number("m^3/(s Pa)", doc="sonic conductance C of the open valve", low=0.0)
    critical_ratio: NumberLike = number("1", 0.3, doc="critical ratio b", low=0.0, below=1.0)
    frequency: NumberLike = number("Hz", 100.0, doc="frequency of the pulse-width modulation", above=0.0, high=1e5)
    opening_delay: NumberLike = number("s", 0.0, doc="opening delay", low=0.0, note="at once")
    closing_delay: NumberLike = number("s", 0.0, doc="closing delay", low=0.0, note="at once")
    # Without it, the averaged opening follows the duty without delay.
    rate_limit: NumberLike = number("1/s", optional=True, doc="rate limit of the averaged opening", above=0.0)


def check(name: str, valve: Solenoid) -> None:
    """Raise `OutOfRangeError` if a valve cannot open and close within one modulation period.

    The sum of opening delay and closing delay must be shorter than the period. `name` is the prefix of the address in
    the error.
    """
    fraction = (float(valve.opening_delay) + float(valve.closing_delay)) * float(valve.frequency)  # type: ignore[arg-type]
    if fraction >= 1.0:
        text = valve.frequency.display()  # type: ignore[union-attr]
        raise OutOfRangeError("valve.no_time_to_open", f"{name}.frequency", shown=text, periods=fraction)


def averaged_opening(duty: Any, frequency: Any, opening_delay: Any, closing_delay: Any) -> Any:
    r"""Return the fraction of a modulation period in which the valve is open.

    It depends on the duty d [1], the modulation frequency f [Hz], the opening delay t_o [s] and the closing delay t_c
    [s].

    .. math:: a(d) = d + (t_c - t_o) f \quad (t_o f < d < 1 - t_c f), \qquad 0 \text{ below}, \qquad 1 \text{ above}

    Examples
    --------
    >>> averaged_opening(0.1, 100.0, 2e-3, 1e-3), round(averaged_opening(0.5, 100.0, 2e-3, 1e-3), 3)
    (0.0, 0.4)
    """
    partial = clip(duty + (closing_delay - opening_delay) * frequency, 0.0, 1.0)
    # At the limits the valve is closed below and open above. Closed takes precedence: a duty of 0 is closed.
    opening = where(duty >= 1.0 - closing_delay * frequency, where(duty > 0.0, 1.0, 0.0), partial)
    return where(duty <= opening_delay * frequency, 0.0, opening)


def slew_rate(opening: Any, target: Any, rate_limit: Any) -> Any:
    """Return the rate of change of a valve opening that follows `target` at most with `rate_limit` [1/s]."""
    return rate_limit * clip((target - opening) / SLEW_WIDTH, -1.0, 1.0)


def initial_states() -> dict[str, float]:
    """Return the initial discrete states and timers of a closed solenoid valve.

    The first modulation period begins at time zero.
    """
    return {"period": 0.0, "release": NEVER, "change": NEVER, "period_count": 0.0, "command": 0.0, "open": 0.0}


def update(
    timer: str, time: Any, states: Mapping[str, Any], duty: Any, frequency: Any, opening_delay: Any, closing_delay: Any
) -> dict[str, Any]:
    """Return the changed discrete states of a switched valve at a sample instant.

    `timer` is the timer that is due: `period` (a period begins), `release` (the pulse ends) or `change` (the valve has
    opened or closed). The armature of the valve moves only if a command lasts longer than its delay.
    """
    if timer == "change":
        return {"change": NEVER, "open": states["command"]}
    if timer == "release":
        # A pulse shorter than the opening delay does not move the armature.
        closes = where(states["open"] > 0.0, time + closing_delay, NEVER)
        return {"release": NEVER, "command": 0.0, "change": closes}
    # Counted from the start to avoid accumulated rounding.
    count = states["period_count"] + 1.0
    period = 1.0 / frequency
    on = where(duty > 0.0, 1.0, 0.0)
    opens = where(states["open"] == 1.0, NEVER, time + opening_delay)
    closes = where(states["open"] == 0.0, NEVER, time + closing_delay)
    return {
        "period": count * period,
        "period_count": count,
        "command": on,
        "release": where(duty >= 1.0, NEVER, where(duty > 0.0, time + duty * period, NEVER)),
        # A duty of 1 is not a new command in each period: a moving armature continues.
        "change": where(on == states["command"], states["change"], where(on > 0.0, opens, closes)),
    }
