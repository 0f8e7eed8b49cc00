"""Figures by which responses to steps of a setpoint are compared."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from poppet.core.number_format import USUAL

Array = NDArray[np.float64]

SETTLED = 0.02
"""Part of a step within which it counts as settled."""
_READ = {"rad": "deg", "rad/s": "deg/s"}
"""Beside what is read in a usual unit everywhere."""
OPEN = 1e-3
"""Opening above which a valve counts as open."""


@dataclass(frozen=True)
class StepMetric:
    """A figure: its unit, and what it says. Less is better in all of them."""

    unit: str
    meaning: str


METRICS = {
    "IAE": StepMetric("Pa s", "integral of |w - y|"),
    "ITAE": StepMetric("Pa s^2", "integral of |w - y| times the time since the last step"),
    "rise_time": StepMetric("s", "from 10 to 90 % of a step, mean of the steps"),
    "settling_time": StepMetric("s", "until y stays within 2 % of a step, the longest"),
    "overshoot": StepMetric("%", "beyond the setpoint, of a step, the greatest"),
    "travel": StepMetric("1", "sum of all changes of the command, or of both openings"),
    "switches": StepMetric("1", "changes between filling, holding and venting"),
}
"""Of a pressure that openings control; of other loops `metrics_in` says the units."""


def readable(unit: str) -> str:
    """The unit in which people read what has an SI unit."""
    return _READ.get(unit) or USUAL.get(unit, unit)


def metrics_in(unit: str, command_unit: str = "1") -> dict[str, StepMetric]:
    """Figures of a loop, with the SI units that follow from those of what it measures and commands.

    Parameters
    ----------
    unit, command_unit : str
        SI units of the quantity and of the command; `1` is an opening.

    Returns
    -------
    dict
        As `METRICS`; only openings fill, hold and vent.

    Examples
    --------
    >>> metrics_in("m", "Pa")["IAE"].unit, metrics_in("m", "Pa")["travel"].unit, "switches" in metrics_in("m", "Pa")
    ('m s', 'Pa', False)
    """
    units = {"IAE": f"{unit} s", "ITAE": f"{unit} s^2", "travel": command_unit}
    if "/" in unit:  # m/s s would be read in two ways
        units |= {"IAE": f"({unit}) s", "ITAE": f"({unit}) s^2"}
    found = {name: replace(figure, unit=units.get(name, figure.unit)) for name, figure in METRICS.items()}
    if command_unit != "1":
        del found["switches"]
    return found


def read_in(figure: StepMetric, unit: str, command_unit: str = "1") -> str:
    """The unit in which people read a figure of a loop."""
    shown = {unit: readable(unit), command_unit: readable(command_unit)}
    if figure.unit in shown:
        return shown[figure.unit]
    for power in (" s^2", " s"):
        if figure.unit.endswith(power) and figure.unit.removesuffix(power).strip("()") == unit:
            # A difference of temperatures is one in kelvin.
            inner = unit if unit == "K" else shown[unit]
            return f"({inner}){power}" if "/" in inner else f"{inner}{power}"
    return figure.unit


def step_metrics(
    time: Array, setpoint: Array, measured: Array, fill: Array, vent: Array | None = None
) -> dict[str, float]:
    r"""Figures of a response to a staircase of the setpoint.

    .. math:: \mathrm{IAE} = \int |w - y|\,dt, \qquad \mathrm{ITAE} = \int (t - t_\mathrm{step}) |w - y|\,dt

    Parameters
    ----------
    time : (n,) array
        Rising [s].
    setpoint, measured : (n,) array
        In one unit.
    fill, vent : (n,) array
        Openings, 0..1; a command that is none stands alone.

    Returns
    -------
    dict
        A value for each of `metrics_in`; the rise and settling time of a step that does not get there before the next
        one are infinite.

    Examples
    --------
    >>> time = np.linspace(0.0, 1.0, 1001)
    >>> target = np.where(time < 0.1, 0.0, 1.0)
    >>> pressure = np.where(time < 0.1, 0.0, 1.0 - np.exp(-(time - 0.1) / 0.05))
    >>> found = step_metrics(time, target, pressure, 0.0 * time, 0.0 * time)
    >>> [round(found[name], 3) for name in ("IAE", "rise_time", "settling_time", "overshoot")]
    [0.051, 0.11, 0.196, 0.0]
    """
    begins = np.flatnonzero(np.diff(setpoint) != 0.0) + 1
    error = np.abs(setpoint - measured)
    last = np.zeros_like(time)
    last[begins] = time[begins]
    since = time - np.maximum.accumulate(last)
    steps = [
        _step(time[a:b], measured[a:b], float(measured[a - 1]), float(setpoint[a]))
        for a, b in pairwise([*begins, len(time)])
    ]
    rises, settlings, overshoots = zip(*steps, strict=True) if steps else ((0.0,), (0.0,), (0.0,))
    found = {
        "IAE": _integral(time, error),
        "ITAE": _integral(time, since * error),
        "rise_time": float(np.mean(rises)),
        "settling_time": float(np.max(settlings)),
        "overshoot": float(np.max(overshoots)),
        "travel": float(np.sum(np.abs(np.diff(fill)))),
    }
    if vent is not None:
        acting = np.where(fill > OPEN, 1, np.where(vent > OPEN, -1, 0))
        found["travel"] += float(np.sum(np.abs(np.diff(vent))))
        found["switches"] = float(np.count_nonzero(np.diff(acting)))
    return found


def _integral(time: Array, values: Array) -> float:
    return float(np.sum(0.5 * (values[1:] + values[:-1]) * np.diff(time)))


def _step(time: Array, measured: Array, begin: float, end: float) -> tuple[float, float, float]:
    """Rise time, settling time [s] and overshoot [%] of one step."""
    share = (measured - begin) / (end - begin)
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
