"""Figures of controller tuning and of controller comparisons."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.control.comparison import Comparison
from poppet.control.loop import SampledPlant, step_response
from poppet.control.metrics import readable_metric_unit, readable_unit_of
from poppet.control.tuning import TunedPoint, Tuning
from poppet.core.number_format import pretty, scaled
from poppet.core.units import convert
from poppet.parts.quantities import OPENING
from poppet.timeseries.plotting.figures import (
    ACCENT,
    GREY,
    INK,
    PALETTE,
    axes_in,
    check_format,
    new_figure,
    save_figure,
    style,
    widest,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SPREAD_METRICS = ("ITAE", "settling_time", "overshoot", "travel")
MARKERS = "Dots: samples; bar: median; ring: nominal."
_LEFT, _WIDTH, _GAP, _TOP = 0.75, 3.1, 0.3, 0.62
_UPPER, _LOWER, _STRIP = 1.9, 0.9, 1.3
_SMALL_OPENING = 0.3
"""Maximum opening for an axis that is scaled to the openings."""
_MAX_SAMPLES = 2000
"""Maximum number of samples of a step response."""


def loop_figure(tuning: Tuning) -> Figure:
    """Draw sensitivity versus frequency and the step response of a tuned control loop.

    Each plant for which the sensitivity is bounded has its own curves.
    """
    figure = new_figure(10.0, 3.9)
    left, right = (axes_in(figure, edge, 0.75, 4.0, 2.5) for edge in (0.75, 5.75))
    left.axhline(tuning.sensitivity, color=GREY, linewidth=0.9, linestyle=(0, (2, 2)), label="bound")
    colours = iter(PALETTE * 4)
    for point in tuning.points:
        runs = {run.at: run for run in point.verified}
        for name, plant in point.plants.items():
            line = {"color": next(colours), "linewidth": 1.2, "label": name}
            z = plant.at(plant.frequencies)
            loop = point.gains.response(z, plant.sample_time) * plant.response(z)
            left.semilogx(plant.frequencies[::8], np.abs(1.0 / (1.0 + loop))[::8], **line)
            if isinstance(plant, SampledPlant):
                step = _step(plant, point)
                right.plot(plant.sample_time * np.arange(step.size), step, **line)
            elif name in runs:
                run = runs[name]
                right.plot(run.time - run.time[0], (run.measured - run.setpoint[0]) / run.step, **line)
    left.set_xlabel("frequency [Hz]")
    left.set_ylabel("sensitivity [1]")
    right.axhline(1.0, color=GREY, linewidth=0.8)
    right.set_xlabel("time [s]")
    right.set_ylabel("measurement per step [1]")
    handles, labels = left.get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper left", bbox_to_anchor=(0.07, 0.99), ncols=4, fontsize=7.5)
    return figure


def _step(plant: SampledPlant, point: TunedPoint) -> np.ndarray:
    crossover = max(margins.crossover for margins in point.margins.values())
    length = max(point.gains.integral_time, 1.0 / (2.0 * np.pi * max(crossover, 1e-9)))
    samples = min(_MAX_SAMPLES, int(12.0 * length / plant.sample_time))
    return step_response(plant, point.gains, point.setpoint_weight, max(samples, 2))


def plot_comparison(comparison: Comparison, path: str | Path | None = None, *, title: str = "") -> Figure:
    """Draw responses, nominal commands and metrics of all controllers.

    The figure is saved if `path` is set.
    """
    if path is not None:
        check_format(path)
    with style("A picture of a comparison"):
        width = _total_width(comparison)
        figure = new_figure(width, _TOP + _UPPER + 0.15 + _LOWER + 0.85 + _STRIP + 0.75)
        _draw_responses(figure, comparison)
        _draw_spreads(figure, comparison, _TOP + _UPPER + _LOWER + 1.15)
        height = figure.get_size_inches()[1]
        figure.text(_LEFT / width, 1.0 - 0.14 / height, title, va="top", weight="bold", fontsize=11)
        note = sample_sentence(comparison) + (f" {MARKERS}" if comparison.draws else "")
        if len(note) >= 150:
            comma = note.rfind(",", 0, len(note) // 2 + 10)
            note = f"{note[: comma + 1]}\n{note[comma + 2 :]}"
        figure.text(_LEFT / width, 0.12 / height, note, color=GREY, fontsize=7.5)
    if path is not None:
        save_figure(figure, path)
    return figure


def response_figure(comparison: Comparison) -> Figure:
    """Draw the response and the nominal command for every controller.

    A band shows the spread of the response over all samples of the plant.
    """
    figure = new_figure(_total_width(comparison), _TOP + _UPPER + 0.15 + _LOWER + 0.55)
    _draw_responses(figure, comparison)
    return figure


def spread_figure(comparison: Comparison) -> Figure:
    """Draw the metrics of every controller: samples, median and nominal value."""
    figure = new_figure(_total_width(comparison), _STRIP + 1.0)
    _draw_spreads(figure, comparison, 0.45)
    return figure


def _total_width(comparison: Comparison) -> float:
    columns = max(len(comparison.responses), 2)
    return _LEFT + columns * _WIDTH + (columns - 1) * _GAP + 0.2


def _draw_responses(figure: Figure, comparison: Comparison) -> None:
    first: Any = None
    for k, name in enumerate(comparison.responses):
        left, colour = _LEFT + k * (_WIDTH + _GAP), PALETTE[k % len(PALETTE)]
        upper = axes_in(figure, left, _TOP, _WIDTH, _UPPER, sharey=first[0] if first else None)
        top = _TOP + _UPPER + 0.15
        lower = axes_in(figure, left, top, _WIDTH, _LOWER, sharex=upper, sharey=first[1] if first else None)
        _draw_response(upper, lower, comparison, name, colour)
        if first is not None:
            upper.tick_params(labelleft=False)
            lower.tick_params(labelleft=False)
            continue
        first = upper, lower
        units = [pretty(readable_unit_of(unit)) for unit in comparison.units]
        reference = ", absolute" if comparison.quantity == "pressure" else ""
        upper.set_ylabel(f"{comparison.quantity.replace('_', ' ')}\n[{units[0]}{reference}]")
        is_opening = comparison.command_quantity == OPENING
        command = f"{comparison.command_quantity.replace('_', ' ')}\n[{units[1]}]"
        lower.set_ylabel("opening\n(fill, -vent)" if is_opening else command)
        upper.legend(loc="best", fontsize=7.5)


def _draw_response(upper: Any, lower: Any, comparison: Comparison, name: str, colour: str) -> None:
    (unit, command_unit), time = comparison.units, comparison.time
    rows = convert(comparison.responses[name], unit, readable_unit_of(unit))
    upper.set_title(name, loc="left")
    complete = rows[~np.isnan(rows[:, -1])]
    if len(complete) > 1:
        label = f"range of {len(complete) - 1} samples"
        edges = complete.min(axis=0), complete.max(axis=0)
        upper.fill_between(time, *edges, color=colour, alpha=0.25, linewidth=0.0, label=label)
    upper.plot(time, rows[0], color=colour, label="nominal")
    setpoint = convert(comparison.setpoint, unit, readable_unit_of(unit))
    upper.plot(time, setpoint, color=INK, linewidth=0.8, linestyle="--", label="setpoint", drawstyle="steps-post")
    upper.tick_params(labelbottom=False)
    commands = convert(comparison.commands[name], command_unit, readable_unit_of(command_unit))
    lower.plot(time, commands, color=colour, linewidth=1.0, drawstyle="steps-post", label="command")
    max_opening = max(float(np.nanmax(np.abs(command))) for command in comparison.commands.values())
    if comparison.command_quantity == OPENING and max_opening > _SMALL_OPENING:
        lower.set_ylim(-1.1, 1.1)
    lower.set_xlabel("time [s]")
    lower.set_xlim(time[0], time[-1])


def sample_sentence(comparison: Comparison) -> str:
    """Return a sentence with the number, the seed and the parameter ranges of the plant samples."""
    if not comparison.draws:
        return "Nominal parameters only."
    ranges = ", ".join(f"{address} ±{100.0 * size:g} %" for address, size in comparison.ranges.items())
    return f"{comparison.draws} samples, seed {comparison.seed}: {ranges}."


def _draw_spreads(figure: Figure, comparison: Comparison, top: float) -> None:
    left = max(_LEFT, widest(list(comparison.responses), 8.5) + 0.25)
    width = (_total_width(comparison) - left - 0.2 - (len(_SPREAD_METRICS) - 1) * _GAP) / len(_SPREAD_METRICS)
    for k, key in enumerate(_SPREAD_METRICS):
        axes = axes_in(figure, left + k * (width + _GAP), top, width, _STRIP)
        _draw_spread(axes, comparison, key, is_first=k == 0)


def _draw_spread(axes: Any, comparison: Comparison, key: str, *, is_first: bool) -> None:
    unit = readable_metric_unit(comparison.kinds[key], *comparison.units)
    factor, names = scaled(1.0, comparison.kinds[key].unit, unit), list(comparison.figures)
    jitter = np.random.default_rng(0)
    for k, name in enumerate(names):
        values = factor * comparison.figures[name][key]
        samples = values[1:][np.isfinite(values[1:])]
        y, colour = len(names) - 1 - k, PALETTE[k % len(PALETTE)]
        axes.plot(samples, y + jitter.uniform(-0.22, 0.22, len(samples)), ".", color=colour, markersize=3.0, alpha=0.6)
        if len(samples):
            axes.plot([np.median(samples)] * 2, [y - 0.34, y + 0.34], color=INK, linewidth=1.6)
        if np.isfinite(values[0]):
            axes.plot(values[0], y, "o", markersize=6.0, markerfacecolor="none", markeredgecolor=ACCENT)
        if n_failed := int(np.sum(~np.isfinite(values))):
            label = {"ha": "right", "va": "center", "fontsize": 7.0, "color": GREY}
            axes.text(1.0, y, f"{n_failed} not reached", transform=axes.get_yaxis_transform(), **label)
    axes.set_yticks(range(len(names)), list(reversed(names)) if is_first else [""] * len(names))
    axes.set_ylim(-0.6, len(names) - 0.4)
    axes.set_xlim(left=0.0)
    axes.set_title(key.replace("_", " ") + (f" [{pretty(unit)}]" if unit != "1" else ""), loc="left")
