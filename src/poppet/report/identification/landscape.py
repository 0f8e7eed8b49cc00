"""Figures of the misfit: over conductance and wall heat, along one number, where searches ended."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.number_format import pretty, readable_unit
from poppet.core.units import convert
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.plotting.figures import GREY, INK, PALETTE, axes_in, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH, _LEFT, _WIDE, _HIGH = 10.0, 0.95, 7.2, 3.6
_SHADES = (PALETTE[0], PALETTE[10])
WIDE = 100.0
"""Ratio of wall heats from which their axis shows decades."""
TALLEST = 3.0
"""Times its limit up to which a profile is drawn."""
ONE_NUMBER = 3.841
"""Chi-square of one number at 95 %."""
LEVELS = (2.296, 5.991)
"""Chi-square of two numbers at 68 and 95 %."""


def contour_figure(table: Mapping[str, Any]) -> Figure:
    """Regions of 68 and 95 % over conductance and wall heat, and the valley between them."""
    x, y, rise = (np.asarray(table[key], dtype=float) for key in ("x", "y", "rise"))
    unit = readable_unit(table["x_unit"], float(np.max(np.abs(x))))
    across = convert(x, table["x_unit"], unit)
    figure = new_figure(_WIDTH, _HIGH + 0.95)
    axes = axes_in(figure, _LEFT, 0.35, _WIDE, _HIGH)
    up = _heights(axes, y)
    column = np.broadcast_to(up[:, None], across.shape)
    axes.contourf(across, column, rise, levels=[-1e-9, *LEVELS], colors=_SHADES, alpha=0.75)
    axes.contour(across, column, rise, levels=LEVELS, colors=INK, linewidths=(0.9, 0.6))
    floor = across[np.arange(up.size), np.argmin(rise, axis=1)]
    axes.plot(floor, up, color=GREY, linewidth=0.9, linestyle=(0, (4, 3)), label="best conductance at each wall heat")
    best = convert(np.array([table["best"][0]]), table["x_unit"], unit)
    axes.plot(best, np.interp([table["best"][1]], y, up), "+", color=PALETTE[1], markersize=11, label="the estimate")
    for shade, part in zip(_SHADES, ("68 %", "95 %"), strict=True):
        axes.fill_between([], [], [], color=shade, alpha=0.75, linewidth=0, label=part)
    axes.set_xlabel(f"{table['x_name']} [{pretty(unit)}]", parse_math=False)
    axes.set_ylabel(f"{table['y_name']} [{pretty(table['y_unit'])}]", parse_math=False)
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=4, borderpad=0.2, borderaxespad=0.1)
    return figure


def profile_figure(table: Mapping[str, Any], name: str) -> Figure:
    """The rise of chi-square along one number, all others fitted anew, with its limit and what a parabola would be."""
    x, rise, limit = np.asarray(table["x"]), np.asarray(table["rise"]), float(table["limit"])
    unit = readable_unit(table["unit"], float(np.max(np.abs(x))))

    def at(values: Any) -> FloatArray:
        return np.asarray(convert(np.asarray(values, dtype=float), table["unit"], unit))

    figure = new_figure(0.6 * _WIDTH, 2.6)
    axes = axes_in(figure, 0.75, 0.35, 0.6 * _WIDTH - 1.0, 1.7)
    # A number without an upper end is followed far beyond what there is to see.
    drawn = x <= WIDE * max(map(abs, table["answers"]))
    places, ticks = _decades(at(x[drawn]))
    ends = np.interp([table["low"], table["high"]], x[drawn], places)
    for answer in table["answers"][1:]:
        axes.axvline(np.interp(answer, x[drawn], places), color=PALETTE[1], linewidth=0.9)
    axes.axvspan(*ends, color=_SHADES[1], alpha=0.3, linewidth=0, label="95 % interval")
    axes.axhline(limit, color=GREY, linewidth=0.9, linestyle=(0, (4, 3)), label="limit")
    error = (table["linear_high"] - table["linear_low"]) / (2.0 * limit**0.5)
    if 0.0 < error < np.inf and not ticks:
        reach = np.linspace(-1.0, 1.0, 81) * error * (TALLEST * limit) ** 0.5
        reach = reach[(table["best"] + reach >= x[0]) & (table["best"] + reach <= x[-1])]
        axes.plot(at(table["best"] + reach), (reach / error) ** 2, color=GREY, linewidth=0.8, label="linear model")
    # What leaves the picture leaves it upwards, and does not cut it.
    axes.plot(places, rise[drawn], "o-", color=PALETTE[0], markersize=3.0, linewidth=1.2, label="profile")
    if ticks:
        axes.set_xticks(*ticks)
    top = float(np.max(rise[drawn], initial=0.0))
    axes.set_ylim(0.0, min(TALLEST * limit, max(1.5 * limit, 1.05 * top)))
    axes.set_xlabel(f"{name} [{pretty(unit)}]", parse_math=False)
    axes.set_ylabel("rise of chi-square")
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=4, borderpad=0.2, borderaxespad=0.1)
    return figure


def starts_figure(searches: Sequence[Mapping[str, Any]], pair: Sequence[tuple[str, str]]) -> Figure:
    """The misfit at the end of every search, and the ways there over a `pair` of numbers with their units."""
    costs = np.array([each["cost"] for each in searches])
    rise = 2.0 * (np.sort(costs) - costs.min())
    figure = new_figure(_WIDTH, 3.4)
    axes = axes_in(figure, _LEFT, 0.35, 3.1 if pair else 6.2, 2.5)
    axes.axhline(ONE_NUMBER, color=GREY, linewidth=0.9, linestyle=(0, (4, 3)))
    axes.plot(np.arange(1, rise.size + 1), rise, "o", color=PALETTE[0], markersize=5)
    axes.set_yscale("symlog", linthresh=1.0)
    axes.set_ylim(-0.4, max(10.0, 3.0 * float(rise[-1])))
    axes.set_xlabel("searches, the best first")
    axes.set_ylabel("rise of chi-square")
    axes.locator_params(axis="x", integer=True)
    if not pair:
        return figure
    (across, across_unit), (up, up_unit) = pair
    ends = np.array([[each[key][name] for name in (across, up)] for each in searches for key in ("start", "end")])
    unit = readable_unit(across_unit, float(np.max(np.abs(ends[:, 0]))))
    axes = axes_in(figure, _LEFT + 4.3, 0.35, 4.4, 2.5)
    order = np.argsort(ends[:, 1])
    heights = np.empty(order.size)
    heights[order] = _heights(axes, ends[order, 1])
    place = convert(ends[:, 0], across_unit, unit)
    for begin, end in zip(range(0, order.size, 2), range(1, order.size, 2), strict=True):
        axes.plot(place[[begin, end]], heights[[begin, end]], color=GREY, linewidth=0.7)
    axes.plot(place[::2], heights[::2], "o", color="white", markeredgecolor=GREY, markersize=5, label="start")
    axes.plot(place[1::2], heights[1::2], "o", color=PALETTE[0], markersize=5, alpha=0.8, label="end")
    axes.set_xlabel(f"{across} [{pretty(unit)}]", parse_math=False)
    axes.set_ylabel(f"{up} [{pretty(up_unit)}]", parse_math=False)
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=2, borderpad=0.2, borderaxespad=0.1)
    return figure


def _heights(axes: Any, values: FloatArray) -> FloatArray:
    """Where values stand on a vertical axis, and its ticks."""
    found, ticks = _decades(values)
    if ticks:
        axes.set_yticks(*ticks)
    return found


def _decades(values: FloatArray) -> tuple[FloatArray, tuple[FloatArray, list[str]] | None]:
    """Where sorted values stand, with ticks: decades where they span many, with zero below them; else as they are."""
    positive = values[values > 0.0]
    if not positive.size or positive[-1] < WIDE * positive[0]:
        return values, None
    exponents = np.log10(np.where(values > 0.0, values, positive[0]))
    places = np.where(values > 0.0, exponents, exponents.min() - 1.0)
    first, last = np.ceil(exponents.min()), np.floor(exponents.max())
    ticks = np.arange(first, last + 1.0, max(1.0, np.ceil((last - first) / 8.0)))
    labels = [f"{10.0**tick:g}" for tick in ticks]
    if values[0] == 0.0:
        ticks, labels = np.append(places[0], ticks), ["0", *labels]
    return places, (ticks, labels)
