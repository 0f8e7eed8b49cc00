"""Figures of an ensemble: yield, bands, histograms, scatter, what matters."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.number_format import USUAL
from poppet.core.units import convert
from poppet.ensemble import Bands, Ensemble, Yield
from poppet.ensemble.influence import SobolIndex
from poppet.ensemble.metrics import Metric
from poppet.ensemble.statistics import TornadoRange
from poppet.report.ensemble.ensemble_tables import usual
from poppet.timeseries.plotting.figures import ACCENT, GREY, INK, PALETTE, axes_in, new_figure, widest

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
WIDTH = 10.0
GOOD, BAD = PALETTE[0], ACCENT
_GAP = 0.72
_STRIP = 0.32
"""Height of a bar with its gap [in]."""
MOST_POINTS = 1500
"""Runs that a scatter shows: more make the page large and the picture black."""
MOST_BARS = 8
"""Numbers of a tornado that are shown."""


def usual_of(values: Array, unit: str) -> Array:
    """Values as people read them."""
    return values if unit not in USUAL else np.asarray(convert(values, unit, USUAL[unit]))


def yield_figure(yields: list[Yield]) -> Figure:
    """Share of good runs with its interval, a bar for each requirement."""
    names = [f"{y.name}: {y.text}" if y.text else "all together" for y in yields]
    left = widest(names, 8.5) + 0.25
    figure = new_figure(WIDTH, _STRIP * len(yields) + 0.75)
    axes = axes_in(figure, left, 0.15, WIDTH - left - 0.9, _STRIP * len(yields))
    for k, y in enumerate(yields):
        place = len(yields) - 1 - k
        axes.barh(place, 100.0 * y.share, height=0.6, color=GOOD if y.text else INK, alpha=0.85)
        axes.plot([100.0 * y.low, 100.0 * y.high], [place] * 2, color=ACCENT, linewidth=2.2, solid_capstyle="butt")
        axes.text(101.5, place, f"{100.0 * y.share:.4g} %", va="center", fontsize=8.5, clip_on=False)
    axes.set_yticks(range(len(yields)), list(reversed(names)))
    axes.set_ylim(-0.6, len(yields) - 0.4)
    axes.set_xlim(0.0, 100.0)
    axes.set_xlabel("runs that meet it [%]")
    axes.grid(visible=False, axis="y")
    return figure


def bands_figure(bands: Bands, units: Mapping[str, str], curve: str) -> Figure:
    """Quantiles of one curve over the time."""
    figure = new_figure(WIDTH, 3.4)
    axes = axes_in(figure, 0.8, 0.3, WIDTH - 1.0, 2.5)
    unit = units[curve]
    for (low, high), strength, label in (((0.01, 0.99), 0.14, "98 %"), ((0.05, 0.95), 0.22, "90 %"),
                                         ((0.25, 0.75), 0.38, "half")):  # fmt: skip
        ends = [usual_of(bands.quantile(curve, u), unit) for u in (low, high)]
        axes.fill_between(bands.time, *ends, color=GOOD, alpha=strength, linewidth=0.0, label=f"{label} of the runs")
    axes.plot(bands.time, usual_of(bands.quantile(curve, 0.5), unit), color=INK, linewidth=1.1, label="median")
    axes.set_xlim(bands.time[0], bands.time[-1])
    axes.set_xlabel("time [s]")
    axes.set_ylabel(f"{curve.replace('_', ' ')} [{usual(unit)}]".replace(" []", ""))
    figure.legend(*axes.get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(0.07, 1.0), ncols=4, fontsize=8)
    return figure


def panels(titles: list[str], draw: Callable[[int, Any], None], height: float = 1.9) -> Figure:
    """Small figures in rows of two or three."""
    columns = 2 if len(titles) in (1, 2, 4) else 3
    rows, across = -(-len(titles) // columns), (WIDTH - 0.8 - (columns - 1) * _GAP) / columns
    figure = new_figure(WIDTH, rows * (height + 0.95))
    for k, title in enumerate(titles):
        row, column = divmod(k, columns)
        axes = axes_in(figure, 0.7 + column * (across + _GAP), 0.35 + row * (height + 0.95), across, height)
        axes.set_title(title, loc="left", fontsize=9.5)
        draw(k, axes)
    return figure


def histogram_figure(found: Ensemble, rows: Mapping[str, Array]) -> Figure:
    """How every metric is spread, with the bounds of the requirements."""
    metrics = found.plan.metrics

    def draw(k: int, axes: Any) -> None:
        metric = metrics[k]
        values = usual_of(rows[metric.name][np.isfinite(rows[metric.name])], metric.unit)
        if values.size:
            axes.hist(values, bins=min(60, max(10, round(values.size**0.5))), color=GOOD, alpha=0.85)
            _bounds(found, metric, axes.axvline, axes.get_xlim())
        axes.set_xlabel(usual(metric.unit))
        axes.set_ylabel("runs")

    return panels([metric.name.replace("_", " ") for metric in metrics], draw)


def _bounds(found: Ensemble, metric: Metric, line: Callable[..., Any], limits: tuple[float, float]) -> None:
    """Bounds of requirements on a metric, where they are in or near the picture."""
    reach = limits[1] - limits[0]
    for own in found.plan.requirements:
        for _, bound in own.bounds if own.metric == metric.name else ():
            at = float(usual_of(np.array([bound]), metric.unit)[0])
            if limits[0] - reach <= at <= limits[1] + reach:
                line(at, color=ACCENT, linewidth=1.3, linestyle=(0, (4, 2)))


def scatter_figure(found: Ensemble, rows: Mapping[str, Array], units: Mapping[str, str]) -> Figure:
    """Every metric over the number that moves it most, good and bad runs apart."""
    metrics = found.plan.metrics
    strongest = {name: ranges[0].address for name, ranges in found.tornado().items() if ranges}
    is_good = np.ones(len(rows["done"]), dtype=np.bool_)
    for own in found.plan.requirements:
        is_good &= own.met(rows[own.metric])

    def draw(k: int, axes: Any) -> None:
        metric = metrics[k]
        address = strongest[metric.name]
        y = usual_of(rows[metric.name], metric.unit)
        x = usual_of(rows[address], units[address])
        for chosen, colour in ((is_good, GOOD), (~is_good, BAD)):
            shown = chosen & np.isfinite(y)
            axes.plot(x[shown], y[shown], ".", color=colour, markersize=2.6, alpha=0.55)
        if np.isfinite(y).any():
            _bounds(found, metric, axes.axhline, axes.get_ylim())
        axes.set_xlabel(f"{address} [{usual(units[address])}]".replace(" []", ""), fontsize=8.5)

    titles = [f"{m.name.replace('_', ' ')} [{usual(m.unit)}]".replace(" []", "") for m in metrics]
    return panels(titles, draw)


def tornado_figure(metric: Metric, ranges: list[TornadoRange], indices: list[SobolIndex] | None) -> Figure:
    """What each number does to a metric alone; and its Sobol indices, where there are some."""
    shown = [each for each in ranges if math.isfinite(each.size)][:MOST_BARS]
    names = [each.address for each in shown]
    left = max(widest(names, 8.5) + 0.25, 0.8)
    height = _STRIP * max(len(shown), 1)
    room = WIDTH - left - 0.3
    across = 0.56 * room if indices else room
    figure = new_figure(WIDTH, height + 1.0)
    axes = axes_in(figure, left, 0.35, across, height)
    for k, each in enumerate(shown):
        middle, low, high = usual_of(np.array([each.middle, each.low, each.high]), metric.unit)
        for end, colour in ((low, PALETTE[5]), (high, PALETTE[4])):
            axes.barh(len(shown) - 1 - k, end - middle, left=middle, height=0.6, color=colour)
    if shown:
        axes.axvline(float(usual_of(np.array([shown[0].middle]), metric.unit)[0]), color=INK, linewidth=0.9)
    axes.set_yticks(range(len(shown)), list(reversed(names)))
    axes.set_ylim(-0.6, len(shown) - 0.4)
    axes.set_xlabel(f"{metric.name.replace('_', ' ')} [{usual(metric.unit)}]".replace(" []", ""))
    axes.grid(visible=False, axis="y")
    if indices:
        beside = axes_in(figure, left + across + 0.35, 0.35, room - across - 0.35, height)
        _draw_indices(beside, names, {each.factor: each for each in indices})
    return figure


def _draw_indices(axes: Any, names: list[str], indices: Mapping[str, SobolIndex]) -> None:
    """First and total index of each number, with their intervals."""
    for k, name in enumerate(names):
        # Joint numbers are one factor.
        own, place = indices.get(name, indices.get("from_fit")), len(names) - 1 - k
        if own is None:
            continue
        for at, value, low, high, colour in (
            (place + 0.16, own.first, own.first_low, own.first_high, PALETTE[0]),
            (place - 0.16, own.total, own.total_low, own.total_high, PALETTE[3]),
        ):
            axes.plot([low, high], [at, at], color=colour, linewidth=1.4)
            axes.plot([value], [at], "o", color=colour, markersize=4.0)
    axes.plot([], [], "o-", color=PALETTE[0], label="first")
    axes.plot([], [], "o-", color=PALETTE[3], label="total")
    axes.set_yticks(range(len(names)), [""] * len(names))
    axes.set_ylim(-0.6, len(names) - 0.4)
    axes.set_xlim(min(0.0, axes.get_xlim()[0]), max(1.0, axes.get_xlim()[1]))
    axes.axvline(0.0, color=GREY, linewidth=0.8)
    axes.set_xlabel("Sobol index [1]")
    axes.grid(visible=False, axis="y")
    axes.legend(loc="lower right", fontsize=7.5)
