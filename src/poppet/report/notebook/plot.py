"""A small plot of a recording in a few kilobytes of SVG: panels by quantity, each line as the range of its samples."""

from __future__ import annotations

import html
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from poppet.timeseries.checks import FloatArray
from poppet.timeseries.columns import Columns
from poppet.timeseries.plotting.panels import Panel, Series, panels_of, shown_series, thinned
from poppet.timeseries.plotting.sheet import axis_unit, home_colours, panel_colours, time_unit
from poppet.timeseries.plotting.timeline import looks_of

MOST_PANELS, MOST_LINES = 4, 6
COLUMNS = 200
"""Columns of a plot, in each of which a line shows its first, last, lowest and highest sample."""
WIDTH, HEIGHT = 1000, 100
"""Of the drawing, stretched to the room that there is."""


def plot(recording: Columns) -> str:
    """Panels of what moves in a recording, or nothing where nothing does."""
    if recording.time.size < 2:
        return ""
    series = shown_series([_thin(recording, name) for name in _lines(recording)], None, None)
    panels, _ = panels_of(series)
    # Where all rest they are panels still, and there is nothing to see.
    panels = [panel for panel in panels if any(not one.is_still for one in panel.series)][:MOST_PANELS]
    homes = home_colours(panels)
    start, end = float(recording.time[0]), float(recording.time[-1])
    name, size = time_unit(end - start)
    times = "".join(f"<span>{text}</span>" for text in (f"{start / size:.5g}", f"time [{name}]", f"{end / size:.5g}"))
    shown = "".join(_panel(panel, panel_colours(panel, homes), (start, end)) for panel in panels)
    return f'{shown}<div class="poppet-time">{times}</div>' if shown else ""


def _lines(recording: Columns) -> list[str]:
    """Names of all series but codes of regimes and contacts, which are no curves, and but inner ones, if others are."""
    pairs = zip(recording.names, recording.units, strict=True)
    lines = [name for name, unit in pairs if looks_of(name, unit, recording[name]) is None]
    return [name for name in lines if name not in recording.inner] or lines


def _thin(recording: Columns, name: str) -> Columns:
    """One series with the samples that are drawn: what follows never sees a long recording."""
    kept = thinned(recording.time, recording[name], COLUMNS)
    values = recording[name][kept].reshape(1, -1)
    air = recording.ambient_pressure
    return Columns(recording.time[kept], (name,), (recording.unit(name),), values, ambient_pressure=air)


def _panel(panel: Panel, colours: dict[str, str], span: tuple[float, float]) -> str:
    """One panel: its key, the ends of its scale, its lines."""
    series = _spread(panel.series)[:MOST_LINES]
    finite = np.concatenate([one.values[np.isfinite(one.values)] for one in series])
    low, high = float(finite.min()), float(finite.max())
    paths, keys = [], []
    for one in series:
        colour = f"color-mix(in srgb, {colours[one.name]} 72%, currentColor)"
        points = path(one, span, (low, high if high > low else low + 1.0))
        # The plain colour is for browsers that cannot mix.
        paths.append(f'<path stroke="{colours[one.name]}" style="stroke:{colour}" d="{points}"/>')
        mark = f'<i style="background:{colours[one.name]};background:{colour}"></i>'
        keys.append(f"<span>{mark}{html.escape(panel.labels[one.name])}</span>")
    more = len(panel.series) - len(series)
    keys += [f'<span class="lead">and {more} more</span>'] if more else []
    label = html.escape(f"{panel.quantity} over time", quote=True)
    return (
        f'<div class="poppet-panel"><div class="poppet-key"><b>{html.escape(panel.quantity)}</b> '
        f'{html.escape(axis_unit(panel))}{"".join(keys)}</div><div class="poppet-plot"><div class="poppet-ends">'
        f"<span>{_end(high, high - low)}</span><span>{_end(low, high - low)}</span></div>"
        f'<svg role="img" aria-label="{label}" viewBox="0 -2 {WIDTH} {HEIGHT + 4}" preserveAspectRatio="none">'
        f"{''.join(paths)}</svg></div></div>"
    )


def _spread(series: Sequence[Series]) -> list[Series]:
    """The first of each part before the second of any: many signals of one valve must not hide the tank."""
    seen: dict[str, int] = {}
    rank: dict[str, int] = {}
    for one in series:
        part = one.name.partition(".")[0]
        rank[one.name] = seen[part] = seen.get(part, -1) + 1
    return sorted(series, key=lambda one: rank[one.name])


def _end(value: float, span: float) -> str:
    """An end of a scale, to about a thousandth of its span."""
    places = 3 - math.floor(math.log10(span)) if span > 0.0 else 6
    return f"{round(value, places):z.6g}"


def path(one: Series, span: tuple[float, float], scale: tuple[float, float]) -> str:
    """A line as the `d` of an SVG path, in whole thousandths of its width; what is no number is a gap.

    Examples
    --------
    >>> time, values = np.array([0.0, 1.0, 2.0]), np.array([0.0, 5.0, 10.0])
    >>> path(Series("a", 0, time, values, "1", "", 0), (0.0, 2.0), (0.0, 10.0))
    'M0 100L500 50L1000 0'
    """
    x = np.round((one.time - span[0]) / (span[1] - span[0]) * WIDTH).astype(int)
    y = np.round(HEIGHT * (1.0 - (one.values - scale[0]) / (scale[1] - scale[0])), 1)
    parts: list[str] = []
    is_down, before = False, 0.0
    for k in _kept(x, y):
        if not np.isfinite(y[k]):
            is_down = False
        elif not is_down:
            parts.append(f"M{x[k]} {y[k]:g}")
            is_down = True
        else:
            # A step goes across first.
            parts.append(f"H{x[k]}V{y[k]:g}" if one.is_staircase and y[k] != before else f"L{x[k]} {y[k]:g}")
        before = y[k]
    return "".join(parts)


def _kept(x: NDArray[np.int64], y: FloatArray) -> NDArray[np.int64]:
    """Points but those that fall on the one before, and of the rest those between two of the same height."""
    y = np.where(np.isfinite(y), y, -1e9)
    apart = np.flatnonzero((np.diff(x, prepend=-1) != 0) | (np.diff(y, prepend=np.nan) != 0.0))
    y = y[apart]
    level = (y[1:-1] == y[:-2]) & (y[1:-1] == y[2:])
    return apart[np.concatenate(([True], ~level, [True]))[: len(apart)]]
