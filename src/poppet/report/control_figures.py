"""The picture of a comparison of controllers: responses above, spread of their figures below."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.control.comparison import Comparison
from poppet.control.metrics import read_in, readable
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

_SPREAD = ("ITAE", "settling_time", "overshoot", "travel")
"""Figures whose spread is shown."""
MARKS = "Dots: draws; bar: median; ring: nominal."
_LEFT, _WIDTH, _GAP, _TOP = 0.75, 3.1, 0.3, 0.62
_HIGH, _LOW, _STRIP = 1.9, 0.9, 1.3
_SMALL = 0.3
"""Openings all below it have an axis of their own size."""


def plot_comparison(comparison: Comparison, path: str | Path | None = None, *, title: str = "") -> Figure:
    """Draw a comparison: for each controller the response with its spread and the nominal command, then figures."""
    if path is not None:
        check_format(path)
    with style("A picture of a comparison"):
        figure = _draw(comparison, title)
    if path is not None:
        save_figure(figure, path)
    return figure


def response_figure(comparison: Comparison) -> Figure:
    """For each controller the response with its spread, and the nominal command."""
    width, high = _across(comparison), _TOP + _HIGH + 0.15 + _LOW + 0.55
    figure = new_figure(width, high)
    _responses(figure, comparison)
    return figure


def spread_figure(comparison: Comparison) -> Figure:
    """Figures of every controller: draws, median, nominal."""
    figure = new_figure(_across(comparison), _STRIP + 1.0)
    _spreads(figure, comparison, 0.45)
    return figure


def _across(comparison: Comparison) -> float:
    columns = max(len(comparison.responses), 2)
    return _LEFT + columns * _WIDTH + (columns - 1) * _GAP + 0.2


def _draw(comparison: Comparison, title: str) -> Figure:
    width = _across(comparison)
    figure = new_figure(width, _TOP + _HIGH + 0.15 + _LOW + 0.85 + _STRIP + 0.75)
    _responses(figure, comparison)
    _spreads(figure, comparison, _TOP + _HIGH + _LOW + 1.15)
    figure.text(_LEFT / width, 1.0 - 0.14 / figure.get_size_inches()[1], title, va="top", weight="bold", fontsize=11)
    words = _two_lines(f"{spread_words(comparison)} {MARKS}" if comparison.draws else spread_words(comparison))
    figure.text(_LEFT / width, 0.12 / figure.get_size_inches()[1], words, color=GREY, fontsize=7.5)
    return figure


def _responses(figure: Figure, comparison: Comparison) -> None:
    first: Any = None
    for k, name in enumerate(comparison.responses):
        left, colour = _LEFT + k * (_WIDTH + _GAP), PALETTE[k % len(PALETTE)]
        upper = axes_in(figure, left, _TOP, _WIDTH, _HIGH, sharey=first[0] if first else None)
        lower = axes_in(
            figure, left, _TOP + _HIGH + 0.15, _WIDTH, _LOW, sharex=upper, sharey=first[1] if first else None
        )
        _response(upper, lower, comparison, name, colour)
        if first is None:
            first = upper, lower
            upper.set_ylabel(f"{words(comparison.quantity)}\n[{_shown(comparison)}]")
            unit = pretty(readable(comparison.units[1]))
            is_opening = comparison.command_quantity == OPENING
            lower.set_ylabel(
                "opening\n(fill, -vent)" if is_opening else f"{words(comparison.command_quantity)}\n[{unit}]"
            )
            upper.legend(loc="best", fontsize=7.5)
        else:
            upper.tick_params(labelleft=False)
            lower.tick_params(labelleft=False)


def words(quantity: str) -> str:
    """A quantity as a label has it."""
    return quantity.replace("_", " ")


def _shown(comparison: Comparison) -> str:
    unit = pretty(readable(comparison.units[0]))
    return f"{unit}, absolute" if comparison.quantity == "pressure" else unit


def _spreads(figure: Figure, comparison: Comparison, top: float) -> None:
    begin = max(_LEFT, widest(list(comparison.responses), 8.5) + 0.25)
    span = (_across(comparison) - begin - 0.2 - (len(_SPREAD) - 1) * _GAP) / len(_SPREAD)
    for k, key in enumerate(_SPREAD):
        axes = axes_in(figure, begin + k * (span + _GAP), top, span, _STRIP)
        _spread(axes, comparison, key, is_first=k == 0)


def spread_words(comparison: Comparison) -> str:
    """What was drawn."""
    if not comparison.draws:
        return "Nominal numbers only."
    ranges = ", ".join(f"{address} ±{100.0 * size:g} %" for address, size in comparison.ranges.items())
    return f"{comparison.draws} draws, seed {comparison.seed}: {ranges}."


def _two_lines(text: str) -> str:
    half = text.rfind(",", 0, len(text) // 2 + 10)
    return text if len(text) < 150 else f"{text[: half + 1]}\n{text[half + 2 :]}"


def _response(upper: Any, lower: Any, comparison: Comparison, name: str, colour: str) -> None:
    (unit, command_unit), time = comparison.units, comparison.time
    rows = convert(comparison.responses[name], unit, readable(unit))
    upper.set_title(name, loc="left")
    whole = rows[~np.isnan(rows[:, -1])]
    if len(whole) > 1:
        label = f"range of {len(whole) - 1} draws"
        upper.fill_between(
            time, whole.min(axis=0), whole.max(axis=0), color=colour, alpha=0.25, linewidth=0.0, label=label
        )
    upper.plot(time, rows[0], color=colour, label="nominal")
    wanted = convert(comparison.setpoint, unit, readable(unit))
    upper.plot(time, wanted, color=INK, linewidth=0.8, linestyle="--", label="setpoint", drawstyle="steps-post")
    upper.tick_params(labelbottom=False)
    commands = convert(comparison.commands[name], command_unit, readable(command_unit))
    lower.plot(time, commands, color=colour, linewidth=1.0, drawstyle="steps-post",
               label="command")  # fmt: skip
    widest_opening = max(float(np.nanmax(np.abs(each))) for each in comparison.commands.values())
    if comparison.command_quantity == OPENING and widest_opening > _SMALL:
        lower.set_ylim(-1.1, 1.1)
    lower.set_xlabel("time [s]")
    lower.set_xlim(time[0], time[-1])


def _spread(axes: Any, comparison: Comparison, key: str, *, is_first: bool) -> None:
    given = comparison.kinds[key].unit
    unit = read_in(comparison.kinds[key], *comparison.units)
    names = list(comparison.figures)
    scatter = np.random.default_rng(0)
    for k, name in enumerate(names):
        values = scaled(1.0, given, unit) * comparison.figures[name][key]
        drawn = values[1:][np.isfinite(values[1:])]
        y = len(names) - 1 - k
        colour = PALETTE[k % len(PALETTE)]
        axes.plot(drawn, y + scatter.uniform(-0.22, 0.22, len(drawn)), ".", color=colour, markersize=3.0, alpha=0.6)
        if len(drawn):
            axes.plot([np.median(drawn)] * 2, [y - 0.34, y + 0.34], color=INK, linewidth=1.6)
        if np.isfinite(values[0]):
            axes.plot(values[0], y, "o", markersize=6.0, markerfacecolor="none", markeredgecolor=ACCENT)
        lost = int(np.sum(~np.isfinite(values)))
        if lost:
            axes.text(1.0, y, f"{lost} not reached", transform=axes.get_yaxis_transform(), ha="right", va="center",
                      fontsize=7.0, color=GREY)  # fmt: skip
    axes.set_yticks(range(len(names)), list(reversed(names)) if is_first else [""] * len(names))
    axes.set_ylim(-0.6, len(names) - 0.4)
    axes.set_xlim(left=0.0)
    axes.set_title(key.replace("_", " ") + (f" [{pretty(unit)}]" if unit != "1" else ""), loc="left")
