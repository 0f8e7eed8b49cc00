"""Metrics of responses to setpoint steps."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from poppet.core.number_format import USUAL

Array = NDArray[np.float64]

SETTLED = 0.02
"""Half width of the settling band about the setpoint, as a fraction of the step."""
_READ = {"rad": "deg", "rad/s": "deg/s"}
"""Readable units in addition to `USUAL`."""
OPEN = 1e-3
"""Opening above which a valve counts as open."""


@dataclass(frozen=True)
class StepMetric:
    """Unit and meaning of one metric of a step response.

    Smaller values are better.
    """

    unit: str
    meaning: str


METRICS = {
    "IAE": StepMetric("Pa s", "integral of |w - y|"),
    "ITAE": StepMetric("Pa s^2", "integral of |w - y| times the time since the last step"),
    "rise_time": StepMetric("s", "time from 10 to 90 % of a step, mean of the steps"),
    "settling_time": StepMetric("s", "time until y remains within 2 % of a step, maximum"),
    "overshoot": StepMetric("%", "overshoot of a step, maximum"),
    "travel": StepMetric("1", "sum of all changes of the command, or of both openings"),
    "switches": StepMetric("1", "changes between filling, holding and venting"),
}
"""Metrics of a pressure that openings control; `metrics_in` returns the units of other loops."""


def readable_unit_of(unit: str) -> str:
    """Return the unit in which values are displayed, for example bar for values in Pa."""
    return _READ.get(unit) or USUAL.get(unit, unit)


def metrics_in(unit: str, command_unit: str = "1") -> dict[str, StepMetric]:
    """Return the unit and the meaning of each metric of a control loop.

    `unit` is the SI unit of the measured quantity, and `command_unit` the SI unit of the command.

    Parameters
    ----------
    unit, command_unit : str
        SI units of the measured quantity and of the command; `1` is an opening.

    Returns
    -------
    dict
        Metrics under the names in `METRICS`. The metric `switches` is included for openings only.

    Examples
    --------
    >>> metrics_in("m", "Pa")["IAE"].unit, metrics_in("m", "Pa")["travel"].unit, "switches" in metrics_in("m", "Pa")
    ('m s', 'Pa', False)
    """
    units = {"IAE": f"{unit} s", "ITAE": f"{unit} s^2", "travel": command_unit}
    if "/" in unit:  # m/s s is ambiguous
        units |= {"IAE": f"({unit}) s", "ITAE": f"({unit}) s^2"}
    metrics = {name: replace(metric, unit=units.get(name, metric.unit)) for name, metric in METRICS.items()}
    if command_unit != "1":
        del metrics["switches"]
    return metrics


def readable_metric_unit(metric: StepMetric, unit: str, command_unit: str = "1") -> str:
    """Return the display unit of a metric.

    `unit` and `command_unit` are the SI units of the measured quantity and of the command.
    """
    readable_units = {unit: readable_unit_of(unit), command_unit: readable_unit_of(command_unit)}
    if metric.unit in readable_units:
        return readable_units[metric.unit]
    for power in (" s^2", " s"):
        if metric.unit.endswith(power) and metric.unit.removesuffix(power).strip("()") == unit:
            # A difference of temperatures is in kelvin.
            inner = unit if unit == "K" else readable_units[unit]
            return f"({inner}){power}" if "/" in inner else f"{inner}{power}"
    return metric.unit


def step_metrics(
    time: Array, setpoint: Array, measured: Array, fill: Array, vent: Array | None = None
) -> dict[str, float]:
    r"""Return the metrics of a measured response to a series of setpoint steps.

    .. math:: \mathrm{IAE} = \int |w - y|\,dt, \qquad \mathrm{ITAE} = \int (t - t_\mathrm{step}) |w - y|\,dt

    Parameters
    ----------
    time : (n,) array
        Increasing times [s].
    setpoint, measured : (n,) array
        Setpoint and measurement in the same unit.
    fill, vent : (n,) array
        Openings, 0..1. For a command of another quantity, `fill` is the command and `vent` is None.

    Returns
    -------
    dict
        Value of each metric of `metrics_in`. Rise and settling time are infinite if a step does not reach its setpoint
        before the next step.

    Examples
    --------
    >>> time = np.linspace(0.0, 1.0, 1001)
    >>> target = np.where(time < 0.1, 0.0, 1.0)
    >>> pressure = np.where(time < 0.1, 0.0, 1.0 - np.exp(-(time - 0.1) / 0.05))
    >>> found = step_metrics(time, target, pressure, 0.0 * time, 0.0 * time)
    >>> [round(found[name], 3) for name in ("IAE", "rise_time", "settling_time", "overshoot")]
    [0.051, 0.11, 0.196, 0.0]
    """
    starts = np.flatnonzero(np.diff(setpoint) != 0.0) + 1
    error = np.abs(setpoint - measured)
    step_times = np.zeros_like(time)
    step_times[starts] = time[starts]
    elapsed = time - np.maximum.accumulate(step_times)
    steps = []  # rise time [s], settling time [s] and overshoot [%] of each step
    for first, end in pairwise([*starts, len(time)]):
        initial, t = float(measured[first - 1]), time[first:end]
        progress = (measured[first:end] - initial) / (float(setpoint[first]) - initial)
        if not np.all(np.isfinite(progress)):
            steps.append((np.inf, np.inf, np.inf))
            continue
        rise_time = _time_of_first_crossing(t, progress, 0.9) - _time_of_first_crossing(t, progress, 0.1)
        unsettled_rows = np.flatnonzero(np.abs(progress - 1.0) > SETTLED)
        settled_row = int(unsettled_rows[-1]) + 1 if unsettled_rows.size else 0
        settling_time = float(t[settled_row] - t[0]) if settled_row < len(t) else np.inf
        steps.append((rise_time, settling_time, 100.0 * max(0.0, float(np.max(progress)) - 1.0)))
    rises, settlings, overshoots = zip(*steps, strict=True) if steps else ((0.0,), (0.0,), (0.0,))
    metrics = {
        "IAE": _integral(time, error),
        "ITAE": _integral(time, elapsed * error),
        "rise_time": float(np.mean(rises)),
        "settling_time": float(np.max(settlings)),
        "overshoot": float(np.max(overshoots)),
        "travel": float(np.sum(np.abs(np.diff(fill)))),
    }
    if vent is not None:
        actions = np.where(fill > OPEN, 1, np.where(vent > OPEN, -1, 0))
        metrics["travel"] += float(np.sum(np.abs(np.diff(vent))))
        metrics["switches"] = float(np.count_nonzero(np.diff(actions)))
    return metrics


def _integral(time: Array, values: Array) -> float:
    return float(np.sum(0.5 * (values[1:] + values[:-1]) * np.diff(time)))


def _time_of_first_crossing(time: Array, progress: Array, level: float) -> float:
    """Return the time at which a step response first reaches a level [s].

    `progress` is the response, interpolated linearly between samples. The result is infinite if the level is not
    reached.
    """
    rows_above = np.flatnonzero(progress >= level)
    if not rows_above.size:
        return np.inf
    k = int(rows_above[0])
    if k == 0:
        return float(time[0])
    fraction = (level - progress[k - 1]) / (progress[k] - progress[k - 1])
    return float(time[k - 1] + fraction * (time[k] - time[k - 1]))
