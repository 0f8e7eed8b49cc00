"""Figures by which responses to steps of a setpoint are compared."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

SETTLED = 0.02
"""Part of a step within which it counts as settled."""
OPEN = 1e-3
"""Opening above which a valve counts as open."""


@dataclass(frozen=True)
class Figure:
    """A figure: its unit, and what it says. Less is better in all of them."""

    unit: str
    meaning: str


FIGURES = {
    "IAE": Figure("Pa s", "integral of |w - p|"),
    "ITAE": Figure("Pa s^2", "integral of |w - p| times the time since the last step"),
    "rise_time": Figure("s", "from 10 to 90 % of a step, mean of the steps"),
    "settling_time": Figure("s", "until p stays within 2 % of a step, the longest"),
    "overshoot": Figure("%", "beyond the setpoint, of a step, the greatest"),
    "travel": Figure("1", "sum of all changes of both openings"),
    "switches": Figure("1", "changes between filling, holding and venting"),
}


def figures_of(time: Array, setpoint: Array, pressure: Array, fill: Array, vent: Array) -> dict[str, float]:
    r"""Figures of a response to a staircase of the setpoint.

    .. math:: \mathrm{IAE} = \int |w - p|\,dt, \qquad \mathrm{ITAE} = \int (t - t_\mathrm{step}) |w - p|\,dt

    Parameters
    ----------
    time : (n,) array
        Rising [s].
    setpoint, pressure : (n,) array
        In one unit [Pa].
    fill, vent : (n,) array
        Openings, 0..1.

    Returns
    -------
    dict
        A value for each of `FIGURES`; the rise and settling time of a step that does not get there before the next one
        are infinite.

    Examples
    --------
    >>> time = np.linspace(0.0, 1.0, 1001)
    >>> target = np.where(time < 0.1, 0.0, 1.0)
    >>> pressure = np.where(time < 0.1, 0.0, 1.0 - np.exp(-(time - 0.1) / 0.05))
    >>> found = figures_of(time, target, pressure, 0.0 * time, 0.0 * time)
    >>> [round(found[name], 3) for name in ("IAE", "rise_time", "settling_time", "overshoot")]
    [0.051, 0.11, 0.196, 0.0]
    """
    begins = np.flatnonzero(np.diff(setpoint) != 0.0) + 1
    error = np.abs(setpoint - pressure)
    last = np.zeros_like(time)
    last[begins] = time[begins]
    since = time - np.maximum.accumulate(last)
    steps = [
        _step(time[a:b], pressure[a:b], float(pressure[a - 1]), float(setpoint[a]))
        for a, b in pairwise([*begins, len(time)])
    ]
    rises, settlings, overshoots = zip(*steps, strict=True) if steps else ((0.0,), (0.0,), (0.0,))
    acting = np.where(fill > OPEN, 1, np.where(vent > OPEN, -1, 0))
    return {
        "IAE": _integral(time, error),
        "ITAE": _integral(time, since * error),
        "rise_time": float(np.mean(rises)),
        "settling_time": float(np.max(settlings)),
        "overshoot": float(np.max(overshoots)),
        "travel": float(np.sum(np.abs(np.diff(fill))) + np.sum(np.abs(np.diff(vent)))),
        "switches": float(np.count_nonzero(np.diff(acting))),
    }


def _integral(time: Array, values: Array) -> float:
    return float(np.sum(0.5 * (values[1:] + values[:-1]) * np.diff(time)))


def _step(time: Array, pressure: Array, begin: float, end: float) -> tuple[float, float, float]:
    """Rise time, settling time [s] and overshoot [%] of one step."""
    share = (pressure - begin) / (end - begin)
    if not np.all(np.isfinite(share)):
        return np.inf, np.inf, np.inf
    rise = _first(time, share, 0.9) - _first(time, share, 0.1)
    outside = np.flatnonzero(np.abs(share - 1.0) > SETTLED)
    settled = 0.0 if not outside.size else np.inf if outside[-1] + 1 == len(time) else time[outside[-1] + 1] - time[0]
    return rise, float(settled), 100.0 * max(0.0, float(np.max(share)) - 1.0)


def _first(time: Array, share: Array, level: float) -> float:
    """When a level is first reached, straight between two rows [s]."""
    above = np.flatnonzero(share >= level)
    if not above.size:
        return np.inf
    k = int(above[0])
    if k == 0:
        return float(time[0])
    part = (level - share[k - 1]) / (share[k] - share[k - 1])
    return float(time[k - 1] + part * (time[k] - time[k - 1]))
