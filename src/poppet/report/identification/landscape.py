"""Figures of the misfit: over conductance and wall heat, along one number, where searches ended."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.ground.readable import pretty, readable_unit
from poppet.ground.units import convert
from poppet.series.checks import FloatArray
from poppet.series.drawing.figures import GREY, INK, PALETTE, axes_in, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH, _LEFT, _WIDE, _HIGH = 10.0, 0.95, 7.2, 3.6
_SHADES = (PALETTE[0], PALETTE[10])
WIDE = 100.0
"""Ratio of wall heats from which their axis shows decades."""
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


def _heights(axes: Any, values: FloatArray) -> FloatArray:
    """Where values stand on an axis: decades where they span many, with zero below them."""
    positive = values[values > 0.0]
    if not positive.size or positive[-1] < WIDE * positive[0]:
        return values
    exponents = np.log10(np.where(values > 0.0, values, positive[0]))
    heights = np.where(values > 0.0, exponents, exponents.min() - 1.0)
    ticks = np.arange(np.ceil(exponents.min()), np.floor(exponents.max()) + 1.0)
    labels = [f"{10.0**tick:g}" for tick in ticks]
    if values[0] == 0.0:
        ticks, labels = np.append(heights[0], ticks), ["0", *labels]
    axes.set_yticks(ticks, labels)
    return np.asarray(heights)
