"""Small SVG plot of a recording: one panel for each quantity."""

from __future__ import annotations

import html
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from poppet.timeseries.checks import FloatArray
from poppet.timeseries.columns import Columns
from poppet.timeseries.plotting.panels import Panel, Series, looks_of, panels_of, shown_series, thinned
from poppet.timeseries.plotting.plots import axis_unit, home_colours, panel_colours, time_unit

MAX_PANELS, MAX_LINES = 4, 6
COLUMNS = 200
"""Columns of a plot; a line has the first, last, lowest and highest sample of each."""
WIDTH, HEIGHT = 1000, 100
"""Size of the drawing, which is stretched to the available width."""


def plot(recording: Columns) -> str:
    """Return an SVG plot of the outputs that change, or an empty text if all are constant."""
    if recording.time.size < 2:
        return ""
    panels, _ = panels_of(shown_series([_thin(recording, name) for name in _lines(recording)], None, None))
    panels = [panel for panel in panels if any(not line.is_still for line in panel.series)][:MAX_PANELS]
    homes = home_colours(panels)
    start, end = float(recording.time[0]), float(recording.time[-1])
    name, size = time_unit(end - start)
    times = "".join(f"<span>{text}</span>" for text in (f"{start / size:.5g}", f"time [{name}]", f"{end / size:.5g}"))
    body = "".join(_panel(panel, panel_colours(panel, homes), (start, end)) for panel in panels)
    return f'{body}<div class="poppet-time">{times}</div>' if body else ""


def _lines(recording: Columns) -> list[str]:
    """Return the names of the outputs to plot.

    Codes are omitted. Internal outputs are omitted if there are other outputs.
    """
    pairs = zip(recording.names, recording.units, strict=True)
    lines = [name for name, unit in pairs if looks_of(name, unit, recording[name]) is None]
    return [name for name in lines if name not in recording.inner] or lines


def _thin(recording: Columns, name: str) -> Columns:
    """Return one output with only the samples that the plot shows."""
    rows = thinned(recording.time, recording[name], COLUMNS)
    values = recording[name][rows].reshape(1, -1)
    air = recording.ambient_pressure
    return Columns(recording.time[rows], (name,), (recording.unit(name),), values, ambient_pressure=air)


def _panel(panel: Panel, colours: dict[str, str], span: tuple[float, float]) -> str:
    """Return one panel of the plot as HTML: legend, limits of the scale and lines."""
    series = _sort_by_part(panel.series)[:MAX_LINES]
    finite = np.concatenate([line.values[np.isfinite(line.values)] for line in series])
    low, high = float(finite.min()), float(finite.max())
    paths, keys = [], []
    for line in series:
        colour = f"color-mix(in srgb, {colours[line.name]} 72%, currentColor)"
        points = path(line, span, (low, high if high > low else low + 1.0))
        # The first colour is for browsers without `color-mix`.
        paths.append(f'<path stroke="{colours[line.name]}" style="stroke:{colour}" d="{points}"/>')
        mark = f'<i style="background:{colours[line.name]};background:{colour}"></i>'
        keys.append(f"<span>{mark}{html.escape(panel.labels[line.name])}</span>")
    n_omitted = len(panel.series) - len(series)
    keys += [f'<span class="lead">and {n_omitted} more</span>'] if n_omitted else []
    label = html.escape(f"{panel.quantity} over time", quote=True)
    return (
        f'<div class="poppet-panel"><div class="poppet-key"><b>{html.escape(panel.quantity)}</b> '
        f'{html.escape(axis_unit(panel))}{"".join(keys)}</div><div class="poppet-plot"><div class="poppet-ends">'
        f"<span>{_end(high, high - low)}</span><span>{_end(low, high - low)}</span></div>"
        f'<svg role="img" aria-label="{label}" viewBox="0 -2 {WIDTH} {HEIGHT + 4}" preserveAspectRatio="none">'
        f"{''.join(paths)}</svg></div></div>"
    )


def _sort_by_part(series: Sequence[Series]) -> list[Series]:
    """Sort lines by their rank within a part: first the first lines of all parts, then the second lines."""
    counts: dict[str, int] = {}
    rank: dict[str, int] = {}
    for line in series:
        part = line.name.partition(".")[0]
        rank[line.name] = counts[part] = counts.get(part, -1) + 1
    return sorted(series, key=lambda line: rank[line.name])


def _end(value: float, span: float) -> str:
    """Return the value at one end of a scale as text, rounded to about a thousandth of the span."""
    decimals = 3 - math.floor(math.log10(span)) if span > 0.0 else 6
    return f"{round(value, decimals):z.6g}"


def path(series: Series, span: tuple[float, float], scale: tuple[float, float]) -> str:
    """Return a line as the attribute `d` of an SVG path.

    Abscissas are in thousandths of the width. NaN interrupts the line.

    Examples
    --------
    >>> time, values = np.array([0.0, 1.0, 2.0]), np.array([0.0, 5.0, 10.0])
    >>> path(Series("a", 0, time, values, "1", "", 0), (0.0, 2.0), (0.0, 10.0))
    'M0 100L500 50L1000 0'
    """
    x = np.round((series.time - span[0]) / (span[1] - span[0]) * WIDTH).astype(int)
    y = np.round(HEIGHT * (1.0 - (series.values - scale[0]) / (scale[1] - scale[0])), 1)
    parts: list[str] = []
    is_down, previous = False, 0.0
    for k in _visible_points(x, y):
        if not np.isfinite(y[k]):
            is_down = False
        elif not is_down:
            parts.append(f"M{x[k]} {y[k]:g}")
            is_down = True
        else:
            # A step is horizontal first.
            parts.append(f"H{x[k]}V{y[k]:g}" if series.is_staircase and y[k] != previous else f"L{x[k]} {y[k]:g}")
        previous = y[k]
    return "".join(parts)


def _visible_points(x: NDArray[np.int64], y: FloatArray) -> NDArray[np.int64]:
    """Return the indices of the points that determine a line.

    Repeated points and inner points of horizontal lines are omitted.
    """
    y = np.where(np.isfinite(y), y, -1e9)
    distinct = np.flatnonzero((np.diff(x, prepend=-1) != 0) | (np.diff(y, prepend=np.nan) != 0.0))
    y = y[distinct]
    level = (y[1:-1] == y[:-2]) & (y[1:-1] == y[2:])
    return distinct[np.concatenate(([True], ~level, [True]))[: len(distinct)]]
