"""Picture of the interpretation of a recording: the curve in both references, its marks, and a table of sources."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.units import convert
from poppet.identify.tank.tank_recording import TankInterpretation
from poppet.timeseries.plotting.figures import (
    ACCENT,
    FAINT,
    GREY,
    INK,
    PALETTE,
    axes_in,
    new_figure,
    save_figure,
    style,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

WIDTH, PLOT, ROW = 8.2, 3.0, 0.2
"""Width of the figure, height of the plot and of a row of the table [in]."""
SMALL = 4.8, 3.0
"""Size of the picture without the table [in]; its text is readable on a phone."""
MOST_POINTS = 4000
"""Points of the drawn curve; more are thinned out."""


def draw_interpretation(interpretation: TankInterpretation, path: str | Path | None = None) -> Figure:
    """Draw the recorded pressure as it is interpreted, with a table of the items and their sources.

    The left axis has the unit of the file, and the right axis shows the absolute pressure in bar if it is known. The
    rest before the opening is shaded.
    """
    with style("A picture of the interpretation", path):
        height = 0.75 + PLOT + 0.65 + ROW * (len(interpretation.items) + 1) + 0.15
        figure = new_figure(WIDTH, height)
        axes = axes_in(figure, 0.75, 0.55, WIDTH - 1.5, PLOT)
        _draw_curve(axes, interpretation)
        figure.text(0.75 / WIDTH, 1.0 - 0.3 / height, interpretation.path.name, fontsize=11, weight="bold", color=INK)
        _draw_table(figure, interpretation, 0.55 + PLOT + 0.75, height)
        return save_figure(figure, path)


def curve_picture(interpretation: TankInterpretation) -> bytes:
    """Return a small PNG picture of the curve alone, with a transparent background for light and dark pages."""
    with style("A picture of the interpretation"):
        figure = new_figure(*SMALL)
        axes = axes_in(figure, 0.6, 0.1, SMALL[0] - 1.2, SMALL[1] - 0.65)
        axes.patch.set_alpha(0.0)
        _draw_curve(axes, interpretation)
        stream = io.BytesIO()
        figure.savefig(stream, format="png", dpi=220, facecolor="none", metadata={"Software": None})
    return stream.getvalue()


def _draw_curve(axes: Any, interpretation: TankInterpretation) -> None:
    time, values = interpretation.curve
    if not time.size:
        return
    step = 1 + time.size // MOST_POINTS
    axes.plot(time[::step], values[::step], color=PALETTE[0], linewidth=1.3)
    axes.margins(x=0.0)
    time_unit, unit = interpretation.axes
    axes.set(xlabel=f"time from the first sample  [{time_unit or 'unit unknown'}]")
    axes.set_ylabel(f"tank pressure  [{unit or 'unit unknown'}]")
    if interpretation.rest_duration > 0.0:
        axes.axvspan(time[0], time[0] + interpretation.rest_duration, color=FAINT, alpha=0.6, linewidth=0.0)
        _mark(axes, "rest", (time[0], 0.5), ("data", "axes fraction"), GREY, align="left")
    for key, moment in interpretation.moments.items():
        axes.axvline(moment, color=ACCENT, linewidth=1.0)
        _mark(axes, key, (moment, 0.95), ("data", "axes fraction"), ACCENT)
    ambient = interpretation.ambient
    if not unit or ambient is None:
        return
    level = convert(ambient, "Pa", unit, ambient_pressure=ambient)
    low, high = min(float(np.min(values)), level), max(float(np.max(values)), level)
    axes.set_ylim(low - 0.06 * (high - low), high + 0.06 * (high - low))
    axes.axhline(level, color=GREY, linewidth=1.0, linestyle=(0, (4, 3)))
    _mark(axes, "ambient", (0.5, level), ("axes fraction", "data"), GREY)
    right = axes.twinx()
    right.set_ylim(*(convert(end, unit, "bar", ambient_pressure=ambient) for end in axes.get_ylim()))
    right.set_ylabel("[bar, absolute]")
    right.grid(visible=False)
    right.spines["right"].set_visible(True)


def _mark(
    axes: Any,
    text: str,
    point: tuple[float, float],
    coordinates: tuple[str, str],
    colour: str,
    *,
    align: str = "center",
) -> None:
    """Write a text above a point."""
    axes.annotate(
        text, point, xycoords=coordinates, xytext=(3 * (align == "left"), 3), textcoords="offset points", ha=align,
        color=colour,
    )  # fmt: skip


def _draw_table(figure: Figure, interpretation: TankInterpretation, top: float, height: float) -> None:
    """Draw the items below the plot; assumed values have the colour of a mark."""
    columns = (0.75, 2.6, WIDTH - 1.45)
    rows = [("item", "value", "source"), *((i.subject, i.value, ", ".join(i.origins)) for i in interpretation.items)]
    for number, row in enumerate(rows):
        y = 1.0 - (top + ROW * number) / height
        colour = GREY if number == 0 else ACCENT if row[2] == "assumed" else INK
        for x, text in zip(columns, row, strict=True):
            label = text if len(text) < 72 else f"{text[:70]}..."
            figure.text(x / WIDTH, y, label.replace("$", r"\$"), fontsize=8.5, va="center", color=colour)
