"""Figures of the condition monitoring: faults, probabilities and residuals over time, and signatures of faults."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.number_format import pretty, readable_unit, scaled
from poppet.monitoring.baseline import Baseline
from poppet.monitoring.isolable import Isolability
from poppet.monitoring.record import WatchRecord
from poppet.timeseries.plotting.figures import ACCENT, GREY, PALETTE, axes_in, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

WIDTH = 10.0
PANEL, GAP = 1.7, 0.75
"""Height of a panel and distance between panels [in]."""
MOST_INTERVALS = 1200
"""Maximum number of intervals in which the samples of a record are drawn."""
NORMAL_95 = 1.959963984540054
"""Half width of the 95 % interval of a normal distribution, in standard deviations."""
MOST_LINES = 10
"""Number of lines with different colours."""


class Intervals(NamedTuple):
    """Samples of a record, combined in at most `MOST_INTERVALS` consecutive groups of equal number."""

    time: Array  # (n,) first time of each group [s]
    starts: NDArray[np.int64]  # (n,) index of its first sample

    def lowest(self, values: Array) -> Array:
        """Return the smallest value of each group; NaN only if the group has no other values."""
        return np.fmin.reduceat(values, self.starts)

    def highest(self, values: Array) -> Array:
        """Return the greatest value of each group; NaN only if the group has no other values."""
        return np.fmax.reduceat(values, self.starts)


def intervals_of(record: WatchRecord) -> Intervals:
    """Return the groups of samples that a figure of a record shows as one point."""
    starts = np.unique(np.linspace(0.0, len(record), MOST_INTERVALS, endpoint=False).astype(np.int64))
    starts = starts[starts < len(record)]
    return Intervals(record.time[starts], starts)


def faults_figure(record: WatchRecord, baseline: Baseline) -> Figure:
    """Draw the value of each fault number over time, with its 95 % band, its baseline and its alarm size."""
    faults, intervals = record.plan.faults, intervals_of(record)
    figure = new_figure(WIDTH, 0.45 + len(faults) * (PANEL + GAP))
    for k, fault in enumerate(faults):
        axes = _panel(figure, k, len(faults), f"{fault.name}: {fault.address}")
        healthy = float(baseline.faults[k])
        unit = readable_unit(fault.unit, healthy, healthy + fault.alarm)
        value, sigma = record.values[:, k], record.sigmas[:, k]
        low, high = (
            scaled_all(edge, fault.unit, unit)
            for edge in (
                intervals.lowest(value - NORMAL_95 * sigma),
                intervals.highest(value + NORMAL_95 * sigma),
            )
        )
        color = PALETTE[k % MOST_LINES]
        axes.fill_between(intervals.time, low, high, color=color, alpha=0.22, linewidth=0.0)
        axes.plot(intervals.time, scaled_all(value[intervals.starts], fault.unit, unit), color=color)
        axes.axhline(float(scaled(healthy, fault.unit, unit)), color=GREY, linewidth=1.0)
        for sign in (1, -1):
            if fault.direction in (0, sign):
                level = float(scaled(healthy + sign * fault.alarm, fault.unit, unit))
                axes.axhline(level, color=ACCENT, linewidth=1.0, linestyle=(0, (4, 2)))
        _shade_alarms(record, axes, fault.name)
        shown = np.concatenate([low, high, [float(scaled(healthy + fault.alarm, fault.unit, unit))]])
        axes.set(ylabel=pretty(unit) if unit != "1" else "", ylim=_limits(shown))
        _set_time(axes, record.time, is_last=k == len(faults) - 1)
    return figure


def probabilities_figure(record: WatchRecord) -> Figure:
    """Draw the probability of each fault over time; in each interval, the largest one."""
    faults, intervals = record.plan.faults, intervals_of(record)
    figure = new_figure(WIDTH, 0.45 + PANEL + GAP)
    axes = _panel(figure, 0, 1, "")
    for k, fault in enumerate(faults):
        probability = intervals.highest(record.probabilities[:, k])
        axes.plot(intervals.time, probability, color=PALETTE[k % len(PALETTE)], label=fault.name)
    axes.set(ylim=(-0.03, 1.03), ylabel="probability")
    _set_time(axes, record.time, is_last=True)
    figure.legend(*axes.get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(0.07, 1.0), ncols=5, fontsize=8)
    return figure


def residuals_figure(record: WatchRecord) -> Figure:
    """Draw the differences of readings and predictions of each sensor over time, in standard deviations."""
    channels, intervals = record.plan.channels, intervals_of(record)
    figure = new_figure(WIDTH, 0.45 + len(channels) * (PANEL + GAP))
    for k, channel in enumerate(channels):
        axes = _panel(figure, k, len(channels), channel.address)
        residual = (record.readings[:, k] - record.expected[:, k]) / record.deviations[:, k]
        used = np.where(record.used[:, k] > 0, residual, np.nan)
        low, high = intervals.lowest(used), intervals.highest(used)
        axes.fill_between(intervals.time, low, high, color=PALETTE[0], alpha=0.6, linewidth=0.6)
        # A group of one reading has no area.
        axes.plot(intervals.time, 0.5 * (low + high), color=PALETTE[0], linewidth=0.7)
        for level in (-NORMAL_95, NORMAL_95):
            axes.axhline(level, color=GREY, linewidth=0.8, linestyle=(0, (4, 2)))
        limit = max(4.0, float(np.nanmax(np.abs(np.concatenate([low, high, [0.0]])))) * 1.1)
        outliers = np.flatnonzero(record.used[:, k] < 0)[:: max(1, record.time.size // MOST_INTERVALS)]
        if outliers.size:
            sides = np.sign(residual[outliers]) * 0.96 * limit
            axes.plot(record.time[outliers], sides, linestyle="", marker="x", markersize=4.0, color=ACCENT)
        axes.set(ylim=(-limit, limit), ylabel="sd")
        _set_time(axes, record.time, is_last=k == len(channels) - 1)
    return figure


def signatures_figure(isolability: Isolability) -> Figure:
    """Draw the effect of each fault at its alarm size on the readings of each sensor, in standard deviations."""
    sensors, names = isolability.sensors, list(isolability.signatures)
    figure = new_figure(WIDTH, 0.75 + len(sensors) * (PANEL + GAP))
    step = max(1, isolability.time.size // MOST_INTERVALS)
    for k, sensor in enumerate(sensors):
        axes = _panel(figure, k, len(sensors), sensor, top=0.65)
        for j, name in enumerate(names):
            effect = isolability.signatures[name][k, ::step] / isolability.noise[k]
            axes.plot(isolability.time[::step], effect, color=PALETTE[j % len(PALETTE)], label=name, linewidth=1.1)
        axes.set(ylabel="sd")
        _set_time(axes, isolability.time, is_last=k == len(sensors) - 1)
    handles = figure.axes[0].get_legend_handles_labels()
    figure.legend(*handles, loc="upper left", bbox_to_anchor=(0.07, 1.0), ncols=5, fontsize=8)
    return figure


def scaled_all(values: Array, unit: str, shown_in: str) -> Array:
    """Convert values from an SI unit to another one."""
    zero = float(scaled(0.0, unit, shown_in))
    return np.asarray(zero + values * (float(scaled(1.0, unit, shown_in)) - zero))


def _panel(figure: Figure, k: int, count: int, title: str, top: float = 0.35) -> Any:
    """Add the panel k of `count` panels, one below the other."""
    axes = axes_in(figure, 0.85, top + k * (PANEL + GAP), WIDTH - 1.05, PANEL)
    axes.set_title(title, loc="left", fontsize=9.5)
    return axes


def _set_time(axes: Any, time: Array, *, is_last: bool) -> None:
    if time.size > 1:
        axes.set_xlim(float(time[0]), float(time[-1]))
    if is_last:
        axes.set_xlabel("time [s]")


def _shade_alarms(record: WatchRecord, axes: Any, name: str) -> None:
    """Shade the times at which a fault is named in an alarm."""
    for episode in record.episodes:
        if name in episode.faults:
            axes.axvspan(episode.start, max(episode.end, episode.start), color=ACCENT, alpha=0.13, linewidth=0.6)


def _limits(values: Array) -> tuple[float, float]:
    """Return the limits of an axis that shows all finite values.

    Wide bands, for example at the start, are cut at the quantiles 1 % and 99 %.
    """
    finite = values[np.isfinite(values)]
    low, high = (float(np.quantile(finite, q)) for q in (0.01, 0.99)) if finite.size else (0.0, 1.0)
    low, high = min(low, float(values[-1])), max(high, float(values[-1]))
    margin = 0.08 * (high - low) or 0.1 * abs(high) or 1.0
    return low - margin, high + margin
