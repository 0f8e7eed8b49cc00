"""Figures of the cost of a fit: contour, profiles and searches."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.number_format import pretty, readable_unit
from poppet.core.units import convert
from poppet.report.identification.identification_figures import legend_above
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.plotting.figures import GREY, INK, PALETTE, axes_in, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH, _LEFT, _CONTOUR_WIDTH, _CONTOUR_HEIGHT = 10.0, 0.95, 7.2, 3.6
_SHADES = (PALETTE[0], PALETTE[10])
MIN_DECADES_RATIO = 100.0
"""Minimum ratio of positive values for an axis of decades."""
MAX_RISE = 3.0
"""Maximum of a profile figure, relative to the limit of chi-square."""
ONE_PARAMETER = 3.841
"""Limit of chi-square for one parameter at 95 %."""
LEVELS = (2.296, 5.991)
"""Limits of chi-square for two parameters at 68 and 95 %."""


def contour_figure(table: Mapping[str, Any]) -> Figure:
    """Draw the joint confidence regions of sonic conductance and wall conductance."""
    x, y, rise = (np.asarray(table[key], dtype=float) for key in ("x", "y", "rise"))
    unit = readable_unit(table["x_unit"], float(np.max(np.abs(x))))
    x_values = convert(x, table["x_unit"], unit)
    figure = new_figure(_WIDTH, _CONTOUR_HEIGHT + 0.95)
    axes = axes_in(figure, _LEFT, 0.35, _CONTOUR_WIDTH, _CONTOUR_HEIGHT)
    y_values = _set_y_ticks(axes, y)
    grid_y = np.broadcast_to(y_values[:, None], x_values.shape)
    axes.contourf(x_values, grid_y, rise, levels=[-1e-9, *LEVELS], colors=_SHADES, alpha=0.75)
    axes.contour(x_values, grid_y, rise, levels=LEVELS, colors=INK, linewidths=(0.9, 0.6))
    valley = x_values[np.arange(y_values.size), np.argmin(rise, axis=1)]
    dashed = {"color": GREY, "linewidth": 0.9, "linestyle": (0, (4, 3))}
    axes.plot(valley, y_values, label="best conductance at each wall conductance", **dashed)
    best = convert(np.array([table["best"][0]]), table["x_unit"], unit)
    best_y = np.interp([table["best"][1]], y, y_values)
    axes.plot(best, best_y, "+", color=PALETTE[1], markersize=11, label="the estimate")
    for shade, level in zip(_SHADES, ("68 %", "95 %"), strict=True):
        axes.fill_between([], [], [], color=shade, alpha=0.75, linewidth=0, label=level)
    axes.set_xlabel(f"{table['x_name']} [{pretty(unit)}]", parse_math=False)
    axes.set_ylabel(f"{table['y_name']} [{pretty(table['y_unit'])}]", parse_math=False)
    legend_above(axes, 4)
    return figure


def profile_figure(table: Mapping[str, Any], name: str) -> Figure:
    """Draw the profile of a parameter: the increase of chi-square versus its value.

    `table` contains the profile of the parameter `name`. The figure also shows the limit of the 95 % confidence
    interval and the parabola of the linear model.
    """
    x, rise, limit = np.asarray(table["x"]), np.asarray(table["rise"]), float(table["limit"])
    unit = readable_unit(table["unit"], float(np.max(np.abs(x))))

    def at(values: Any) -> FloatArray:
        return np.asarray(convert(np.asarray(values, dtype=float), table["unit"], unit))

    figure = new_figure(0.6 * _WIDTH, 2.6)
    axes = axes_in(figure, 0.75, 0.35, 0.6 * _WIDTH - 1.0, 1.7)
    # The profile of a parameter without an upper limit extends far to the right.
    is_visible = x <= MIN_DECADES_RATIO * max(map(abs, table["answers"]))
    positions, ticks = _logarithmic_positions(at(x[is_visible]))
    ends = np.interp([table["low"], table["high"]], x[is_visible], positions)
    for answer in table["answers"][1:]:
        axes.axvline(np.interp(answer, x[is_visible], positions), color=PALETTE[1], linewidth=0.9)
    axes.axvspan(*ends, color=_SHADES[1], alpha=0.3, linewidth=0, label="95 % interval")
    axes.axhline(limit, color=GREY, linewidth=0.9, linestyle=(0, (4, 3)), label="limit")
    error = (table["linear_high"] - table["linear_low"]) / (2.0 * limit**0.5)
    if 0.0 < error < np.inf and not ticks:
        offsets = np.linspace(-1.0, 1.0, 81) * error * (MAX_RISE * limit) ** 0.5
        offsets = offsets[(table["best"] + offsets >= x[0]) & (table["best"] + offsets <= x[-1])]
        axes.plot(at(table["best"] + offsets), (offsets / error) ** 2, color=GREY, linewidth=0.8, label="linear model")
    axes.plot(positions, rise[is_visible], "o-", color=PALETTE[0], markersize=3.0, linewidth=1.2, label="profile")
    if ticks:
        axes.set_xticks(*ticks)
    top = float(np.max(rise[is_visible], initial=0.0))
    axes.set_ylim(0.0, min(MAX_RISE * limit, max(1.5 * limit, 1.05 * top)))
    axes.set_xlabel(f"{name} [{pretty(unit)}]", parse_math=False)
    axes.set_ylabel("increase in chi-square")
    legend_above(axes, 4)
    return figure


def search_figure(searches: Sequence[Mapping[str, Any]], pair: Sequence[tuple[str, str]]) -> Figure:
    """Draw the final costs of all searches, and their start and end points.

    `pair` contains names and SI units of the two parameters that span the plane of the points. If it is empty, the
    points are omitted.
    """
    costs = np.array([search["cost"] for search in searches])
    rise = 2.0 * (np.sort(costs) - costs.min())
    figure = new_figure(_WIDTH, 3.4)
    axes = axes_in(figure, _LEFT, 0.35, 3.1 if pair else 6.2, 2.5)
    axes.axhline(ONE_PARAMETER, color=GREY, linewidth=0.9, linestyle=(0, (4, 3)))
    axes.plot(np.arange(1, rise.size + 1), rise, "o", color=PALETTE[0], markersize=5)
    axes.set_yscale("symlog", linthresh=1.0)
    axes.set_ylim(-0.4, max(10.0, 3.0 * float(rise[-1])))
    axes.set_xlabel("searches, the best first")
    axes.set_ylabel("increase in chi-square")
    axes.locator_params(axis="x", integer=True)
    if not pair:
        return figure
    (x_name, x_unit), (y_name, y_unit) = pair
    points = [search[key] for search in searches for key in ("start", "end")]
    ends = np.array([[point[name] for name in (x_name, y_name)] for point in points])
    unit = readable_unit(x_unit, float(np.max(np.abs(ends[:, 0]))))
    axes = axes_in(figure, _LEFT + 4.3, 0.35, 4.4, 2.5)
    order = np.argsort(ends[:, 1])
    heights = np.empty(order.size)
    heights[order] = _set_y_ticks(axes, ends[order, 1])
    x = convert(ends[:, 0], x_unit, unit)
    for first, last in zip(range(0, order.size, 2), range(1, order.size, 2), strict=True):
        axes.plot(x[[first, last]], heights[[first, last]], color=GREY, linewidth=0.7)
    axes.plot(x[::2], heights[::2], "o", color="white", markeredgecolor=GREY, markersize=5, label="start")
    axes.plot(x[1::2], heights[1::2], "o", color=PALETTE[0], markersize=5, alpha=0.8, label="end")
    axes.set_xlabel(f"{x_name} [{pretty(unit)}]", parse_math=False)
    axes.set_ylabel(f"{y_name} [{pretty(y_unit)}]", parse_math=False)
    legend_above(axes, 2)
    return figure


def _set_y_ticks(axes: Any, values: FloatArray) -> FloatArray:
    """Set the ticks of a vertical axis, and return the positions of sorted values.

    The axis is logarithmic if the values span several decades.
    """
    positions, ticks = _logarithmic_positions(values)
    if ticks:
        axes.set_yticks(*ticks)
    return positions


def _logarithmic_positions(values: FloatArray) -> tuple[FloatArray, tuple[FloatArray, list[str]] | None]:
    """Return the positions of sorted values on a logarithmic axis, and its ticks.

    The positions are decimal logarithms; zero is one decade below the smallest positive value. Values that do not span
    several decades are returned unchanged, with None for the ticks.
    """
    positive = values[values > 0.0]
    if not positive.size or positive[-1] < MIN_DECADES_RATIO * positive[0]:
        return values, None
    exponents = np.log10(np.where(values > 0.0, values, positive[0]))
    positions = np.where(values > 0.0, exponents, exponents.min() - 1.0)
    first, last = np.ceil(exponents.min()), np.floor(exponents.max())
    ticks = np.arange(first, last + 1.0, max(1.0, np.ceil((last - first) / 8.0)))
    labels = [f"{10.0**tick:g}" for tick in ticks]
    if values[0] == 0.0:
        ticks, labels = np.append(positions[0], ticks), ["0", *labels]
    return positions, (ticks, labels)
