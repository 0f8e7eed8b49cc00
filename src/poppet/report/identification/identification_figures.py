"""Figures of an identification: measured and modelled channels, residuals, intervals and correlations.

A channel is a measured quantity of one recording or test.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.number_format import pretty, readable_unit, scaled, with_unit
from poppet.core.units import convert
from poppet.identify import Estimate, Result
from poppet.laws.iso6358 import REFERENCE_DENSITY, REFERENCE_TEMPERATURE, mass_flow_rate
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.plotting.figures import ACCENT, FAINT, GREY, INK, PALETTE, axes_in, new_figure, widest
from poppet.timeseries.plotting.panels import draw_thinned, thinned

if TYPE_CHECKING:
    from matplotlib.figure import Figure

VERDICT_COLOURS = {"determined": "#17663a", "weak": "#a15c00", "not determined": "#b3261e", "at bound": "#7d3c98"}
# Sizes in inches.
_WIDTH, _LEFT, _MAIN, _SIDE, _GAP = 10.0, 0.95, 6.35, 1.85, 0.75
_TOP, _UPPER, _LOWER, _BETWEEN, _FOOT = 0.3, 2.3, 1.35, 0.42, 0.5
_ROW = 0.46
_COLUMNS = 300  # groups of samples; the figure shows the extremes of each
MIN_SAMPLES, _MAX_LAGS = 20, 60  # minimum samples for the distribution of residuals; lags in the figure
_MODEL, _POINTS = PALETTE[1], PALETTE[0]


@dataclass(frozen=True, eq=False, kw_only=True)
class Trace:
    """Measured and modelled values of one channel, for figures.

    An array is empty if its values are not available.
    """

    name: str  # as in the result
    unit: str  # SI unit of all values
    x: FloatArray  # abscissas of the measurement, (n,)
    measured: FloatArray  # (n,)
    curve_x: FloatArray  # abscissas of the model, (m,)
    model: FloatArray  # (m,)
    low: FloatArray  # band of the model, (m,)
    high: FloatArray
    samples: FloatArray  # half the width of the band of samples with noise, (m,)
    x_unit: str  # SI
    x_name: str  # quantity of the abscissas; `time` for a recording
    error_low: FloatArray  # intervals of the points, (n,)
    error_high: FloatArray
    sigma: float = math.nan  # standard deviation of the noise; NaN if it is not known

    @property
    def is_timed(self) -> bool:
        """True if the horizontal axis is time, which is the case for recordings."""
        return self.x_name == "time"

    @property
    def quantity(self) -> str:
        """Name of the measured quantity, such as `pressure`."""
        return self.name.rpartition(".")[2].replace("_", " ")

    @property
    def residual(self) -> FloatArray:
        """Model minus measurement at each measured point, (n,).

        The array is empty without model or measurement.
        """
        if not self.model.size or not self.measured.size:
            return np.zeros(0)
        if np.array_equal(self.x, self.curve_x):
            return self.model - self.measured
        return np.interp(self.x, self.curve_x, self.model, np.nan, np.nan) - self.measured


def traces_of(result: Result) -> list[Trace]:
    """Return the measured and modelled values of all channels of a result.

    Channels without values are omitted.
    """

    def array(table: Mapping[str, Any], key: str, like: FloatArray | None = None) -> FloatArray:
        """Return the column `key` of a table as an array.

        The array is empty if the column is missing or, with `like`, has another shape than `like`.
        """
        values = np.asarray(table.get(key, ()), dtype=float)
        return values if values.ndim == 1 and (like is None or values.shape == like.shape) else np.zeros(0)

    traces = []
    for name, table in result.series.items():
        if not isinstance(table, Mapping):
            continue
        is_timed, is_curve = "time" in table, "points_x" in table
        curve_x = array(table, "time" if is_timed else "x")
        x = array(table, "points_x") if is_curve else curve_x
        residual, model = result.residuals.get(name), array(table, "y" if is_curve else "model", curve_x)
        trace = Trace(
            name=name,
            unit=str(table.get("unit") or (residual.unit if residual else "1")),
            x=x,
            measured=array(table, "points_y" if is_curve else "measured", x),
            curve_x=curve_x,
            model=model,
            low=array(table, "low", curve_x),
            high=array(table, "high", curve_x),
            samples=array(table, "samples_high", curve_x) - model if "samples_high" in table else np.zeros(0),
            x_unit="s" if is_timed else str(table.get("x_unit", "1")),
            x_name="time" if is_timed else str(table.get("x_name", "x")),
            error_low=array(table, "points_low", x),
            error_high=array(table, "points_high", x),
            sigma=float(result.conditions.get("noise", {}).get(name, math.nan)),
        )
        if trace.measured.size or trace.model.size:
            traces.append(trace)
    return traces


def channel_figure(
    trace: Trace,
    curve: tuple[FloatArray, FloatArray] | None = None,
    critical_ratio: Estimate | None = None,
    outliers: Sequence[float] = (),
) -> Figure:
    """Draw measurement, model and residuals of one channel.

    `curve` contains abscissas and ordinates of a fitted curve, and `critical_ratio` is the estimate of the critical
    ratio, which the figure marks. Rings mark the outliers, whose abscissas are `outliers`.
    """
    has_residuals, has_side = trace.residual.size > 1, trace.residual.size >= MIN_SAMPLES
    figure = new_figure(_WIDTH, _TOP + _UPPER + _FOOT + has_residuals * (_BETWEEN + _LOWER))
    figure.set_label(trace.name)
    width = _MAIN if has_side else _MAIN + _GAP + _SIDE
    upper = axes_in(figure, _LEFT, _TOP, width, _UPPER)
    _draw_channel(upper, trace, curve)
    if critical_ratio is not None:
        colour = VERDICT_COLOURS[critical_ratio.verdict]
        ends = max(critical_ratio.low, 0.0), min(critical_ratio.high, 1.0)
        upper.axvspan(*ends, color=colour, alpha=0.13, linewidth=0)
        if math.isfinite(critical_ratio.value):
            line = {"color": colour, "linewidth": 1.2, "linestyle": (0, (4, 2))}
            upper.axvline(critical_ratio.value, label="critical ratio", **line)
    indices = [int(np.argmin(np.abs(trace.x - x))) for x in outliers]
    _draw_rings(upper, trace, trace.measured, _y_unit(trace), indices)
    legend_above(upper, 4, markerscale=1.5)
    lower = upper
    if has_residuals:
        lower = axes_in(figure, _LEFT, _TOP + _UPPER + _BETWEEN, width, _LOWER, sharex=upper)
        unit, x_unit = residual_unit(trace), _x_unit(trace)
        if trace.samples.size:
            rows = _visible_rows(trace.curve_x, trace.samples)
            x, styles = convert(trace.curve_x[rows], trace.x_unit, x_unit), ((FAINT, 0.6), (_MODEL, 0.35))
            for half, (colour, alpha) in zip((trace.samples, trace.high - trace.model), styles, strict=True):
                end = convert(half[rows], trace.unit, unit)
                lower.fill_between(x, -end, end, color=colour, alpha=alpha, linewidth=0)
        else:
            two_sigmas = 2.0 * scaled(residual_deviation(trace)[0], trace.unit, unit)
            lower.axhspan(-two_sigmas, two_sigmas, color=FAINT, alpha=0.6, linewidth=0)
        lower.axhline(0.0, color=GREY, linewidth=0.8)
        rows, size = _visible_rows(trace.x, trace.residual), 2.2 if trace.x.size > 150 else 4.0
        x, y = convert(trace.x, trace.x_unit, x_unit), convert(trace.residual, trace.unit, unit)
        marker = {"marker": "o", "linestyle": "none", "markersize": size, "markeredgewidth": 0}
        draw_thinned(lower, x, y, rows, color=INK, alpha=0.6, label="residual", **marker)
        lower.set_ylabel(f"model - measured\n[{pretty(unit)}]", parse_math=False)
        lower.margins(y=0.12)
        _draw_rings(lower, trace, trace.residual, unit, indices)
    lower.set_xlabel(_label(trace.x_name, _x_unit(trace)), parse_math=False)
    if has_side:
        _draw_statistics(figure, trace, lower)
    return figure


def _readable(unit: str, *series: FloatArray) -> str:
    sizes = np.abs(np.concatenate(series))
    return readable_unit(unit, float(np.max(sizes, where=np.isfinite(sizes), initial=0.0)))


def _x_unit(trace: Trace) -> str:
    return _readable(trace.x_unit, trace.x, trace.curve_x)


def _label(quantity: str, unit: str) -> str:
    return f"{quantity} [{pretty(unit)}]" if unit not in ("1", "") else f"{quantity} [1]"


def _y_unit(trace: Trace) -> str:
    return "degC" if trace.unit == "K" else _readable(trace.unit, trace.measured, trace.model)


def _visible_rows(x: FloatArray, y: FloatArray) -> NDArray[np.int_]:
    return thinned(x, y, _COLUMNS) if np.all(np.diff(x) > 0.0) else np.arange(x.size)


def _draw_channel(axes: Any, trace: Trace, curve: tuple[FloatArray, FloatArray] | None) -> None:
    unit, x_unit = _y_unit(trace), _x_unit(trace)

    def x(values: FloatArray) -> FloatArray:
        return convert(values, trace.x_unit, x_unit)

    def y(values: FloatArray) -> FloatArray:
        return convert(values, trace.unit, unit)

    if trace.low.size:
        rows = _visible_rows(trace.curve_x, trace.high)
        if trace.samples.size:
            ends = (y(trace.model[rows] + sign * trace.samples[rows]) for sign in (-1.0, 1.0))
            x_and_edges = x(trace.curve_x[rows]), *ends
            axes.fill_between(*x_and_edges, color=GREY, alpha=0.25, linewidth=0, label="95 % of samples")
        label = "95 % of the model" if trace.samples.size else "95 % band"
        x_and_edges = x(trace.curve_x[rows]), y(trace.low[rows]), y(trace.high[rows])
        axes.fill_between(*x_and_edges, color=_MODEL, alpha=0.16, linewidth=0, label=label)
    if trace.measured.size:
        rows = _visible_rows(trace.x, trace.measured)
        size = 3.0 if trace.x.size > 150 else 4.5
        marker = {"marker": "o", "linestyle": "none", "markersize": size, "markeredgewidth": 0}
        draw_thinned(axes, x(trace.x), y(trace.measured), rows, color=_POINTS, alpha=0.75, label="measured", **marker)
    if trace.error_low.size and trace.error_low.shape == trace.error_high.shape:
        axes.vlines(x(trace.x), y(trace.error_low), y(trace.error_high), color=_POINTS, linewidth=1.0)
    curve_x, model = curve or (trace.curve_x, trace.model)
    if model.size:
        rows = _visible_rows(curve_x, model) if trace.is_timed else np.argsort(curve_x, kind="stable")
        draw_thinned(axes, x(curve_x), y(model), rows, color=_MODEL, linewidth=1.1, label="model")
    axes.set_ylabel(_label(trace.quantity, unit), parse_math=False)
    axes.tick_params(labelbottom=not trace.residual.size)


def _draw_rings(axes: Any, trace: Trace, values: FloatArray, unit: str, indices: Sequence[int]) -> None:
    """Draw rings around the points with the given indices, which are outliers."""
    if indices:
        x, y = convert(trace.x[indices], trace.x_unit, _x_unit(trace)), convert(values[indices], trace.unit, unit)
        axes.plot(x, y, "o", markersize=11, markerfacecolor="none", color=ACCENT, label="off the law")


def legend_above(axes: Any, columns: int, **options: Any) -> None:
    """Draw the legend above the axes in a given number of columns."""
    anchor = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0)}
    axes.legend(**anchor, ncols=columns, borderpad=0.2, borderaxespad=0.1, **options)


def residual_deviation(trace: Trace) -> tuple[float, str]:
    """Return the standard deviation for a figure of residuals, and its source.

    The source is `noise` if the standard deviation of the noise is known. Otherwise it is `rms`, the root mean square
    of the residuals.
    """
    if math.isfinite(trace.sigma) and trace.sigma > 0.0:
        return trace.sigma, "noise"
    finite = trace.residual[np.isfinite(trace.residual)]
    return (float(np.sqrt(np.mean(finite**2))) if finite.size else 0.0), "rms"


def residual_unit(trace: Trace) -> str:
    """Return a readable unit for the residuals of a channel."""
    return _readable(trace.unit, trace.residual)


def _draw_statistics(figure: Figure, trace: Trace, residual_axes: Any) -> None:
    """Draw the histogram and the autocorrelation of the residuals.

    The histogram is at the right of `residual_axes`, and the autocorrelation is above the histogram.
    """
    left, unit, finite = _LEFT + _MAIN + _GAP, residual_unit(trace), trace.residual[np.isfinite(trace.residual)]
    axes = axes_in(figure, left, _TOP + _UPPER + _BETWEEN, _SIDE, _LOWER, sharey=residual_axes)
    if finite.size:
        # Rice's rule.
        bins, ends = int(np.clip(round(2.0 * finite.size ** (1.0 / 3.0)), 5, 40)), axes.get_ylim()
        bars = {"range": ends, "orientation": "horizontal", "color": "#9aa3ad", "linewidth": 0}
        counts, edges, _ = axes.hist(convert(finite, trace.unit, unit), bins=bins, **bars)
        sigma = scaled(residual_deviation(trace)[0], trace.unit, unit)
        if sigma > 0.0:
            level = np.linspace(ends[0], ends[1], 200)
            size = finite.size * (edges[1] - edges[0]) / (sigma * math.sqrt(2.0 * math.pi))
            bell = size * np.exp(-0.5 * (level / sigma) ** 2)
            axes.plot(bell, level, color=_MODEL, linewidth=1.2)
            axes.set_xlim(0.0, 1.1 * max(float(np.max(counts)), float(np.max(bell))))
        axes.tick_params(labelleft=False)
        axes.set_xlabel("samples")
        axes.locator_params(axis="x", nbins=4, integer=True)
    if not trace.is_timed:
        return
    axes = axes_in(figure, left, _TOP, _SIDE, _UPPER)
    centred = finite - np.mean(finite) if finite.size > 3 else np.zeros(1)
    power = float(centred @ centred)
    if not power > 0.0:
        axes.set_axis_off()
        return
    lags = np.arange(1, min(finite.size // 3, _MAX_LAGS) + 1)
    rho = np.array([float(centred[k:] @ centred[:-k]) / power for k in lags])
    limit = 1.96 / math.sqrt(finite.size)
    axes.axhspan(-limit, limit, color=FAINT, alpha=0.6, linewidth=0)
    axes.axhline(0.0, color=GREY, linewidth=0.8)
    axes.vlines(lags, 0.0, rho, color=INK, linewidth=1.2)
    axes.set_ylim(min(-0.3, 1.1 * float(np.min(rho))), max(0.5, min(1.0, 1.15 * float(np.max(rho)))))
    axes.set_title("autocorrelation of residuals", fontsize=8.5, loc="left")
    axes.set_xlabel("lag [samples]", labelpad=1.0)
    axes.locator_params(axis="x", nbins=4, integer=True)


def interval_figure(parameters: Mapping[str, Estimate]) -> Figure:
    """Draw the 95 % confidence interval of each parameter, on an axis that includes zero."""
    left = 0.35 + widest(list(parameters), 8.5)
    figure = new_figure(_WIDTH, _ROW * len(parameters) + 0.35)
    for row, (name, e) in enumerate(parameters.items()):
        axes = axes_in(figure, left, 0.1 + _ROW * row, _WIDTH - left - 1.35, 0.2)
        low_end, high_end = interval_range(e)
        unit, colour = readable_unit(e.unit, low_end, high_end), VERDICT_COLOURS[e.verdict]
        first, last, low, high, start, value = (
            scaled(min(max(v, low_end), high_end), e.unit, unit)
            for v in (low_end, high_end, e.low, e.high, e.start, e.value)
        )
        axes.set_xlim(first, last)
        axes.set_ylim(-1.0, 1.0)
        if not (math.isnan(e.low) or math.isnan(e.high)):
            axes.barh(0.0, high - low, left=low, height=1.1, color=colour, alpha=0.3, linewidth=0)
            for end, edge, mark in ((e.low, first, "<"), (e.high, last, ">")):
                if not low_end <= end <= high_end:
                    axes.plot(edge, 0.0, mark, color=colour, markersize=7, clip_on=False, markeredgewidth=0)
        if low_end <= e.start <= high_end:
            axes.plot(start, 0.0, "o", color="white", markeredgecolor=GREY, markersize=5, clip_on=False)
        if math.isfinite(e.value):
            axes.plot([value] * 2, [-0.95, 0.95], color=colour, linewidth=2.2, clip_on=False)
        axes.set_yticks([])
        axes.spines["left"].set_visible(False)
        axes.locator_params(axis="x", nbins=6)
        axes.tick_params(axis="x", labelsize=7.5, pad=1.5, length=2.5)
        axes.set_facecolor("#f6f7f9")
        font = {"transform": axes.transAxes, "va": "center", "fontsize": 8.5, "parse_math": False}
        axes.text(-0.015, 0.5, name, ha="right", **font)
        axes.text(1.015, 0.5, with_unit("", unit).strip(), color=GREY, **font)
    return figure


def interval_range(e: Estimate) -> tuple[float, float]:
    """Return the limits of an axis for the estimate `e` and its confidence interval.

    The range includes zero. It also includes the value, the start value and the ends of the interval, unless they are
    far away.

    Examples
    --------
    >>> interval_range(Estimate(2.0, "s", 0.1, 1.8, 2.2, "determined", 100.0))
    (0.0, 2.4200000000000004)
    """
    size = next((abs(v) for v in (e.value, e.start, e.high, e.low) if math.isfinite(v) and v != 0.0), 1.0)
    values = [v for v in (e.value, e.low, e.high, e.start) if math.isfinite(v) and abs(v) <= 4.0 * size]
    low, high = min([0.0, *values]), max([0.0, *values])
    if e.unit == "1" and low >= 0.0 and high <= 1.0:
        return 0.0, 1.0
    return 1.1 * low, 1.1 * high if high > low else size


def correlation_figure(correlation: Mapping[str, Mapping[str, float]]) -> Figure:
    """Draw the correlation matrix of the estimates."""
    names = list(correlation)
    matrix = np.array([[1.0 if a == b else correlation[a].get(b, math.nan) for b in names] for a in names])
    side, left = 0.62 * len(names), 0.35 + widest(names, 8.5)
    figure = new_figure(max(left + side + 0.1, 6.0), side + 0.4)
    axes = axes_in(figure, left, 0.1, side, side)
    np.fill_diagonal(matrix, 0.0)  # the diagonal has no information and stays white
    axes.pcolormesh(matrix, cmap="RdBu_r", vmin=-1.3, vmax=1.3, edgecolors="white", linewidth=1.5)
    axes.invert_yaxis()
    for (i, j), value in np.ndenumerate(matrix):
        if i != j:
            weight = "bold" if abs(value) > 0.9 else "normal"
            text = "-" if math.isnan(value) else f"{value:+.2f}"
            colour = "white" if abs(value) > 0.7 else INK
            font = {"ha": "center", "va": "center", "color": colour}
            axes.text(j + 0.5, i + 0.5, text, fontsize=8.5, fontweight=weight, **font)
    axes.set_xticks(np.arange(len(names)) + 0.5, [str(k + 1) for k in range(len(names))])
    axes.set_yticks(np.arange(len(names)) + 0.5, [f"{name}  {k + 1}" for k, name in enumerate(names)])
    for label in axes.get_yticklabels():
        label.set_parse_math(False)
    axes.grid(visible=False)
    axes.tick_params(length=0)
    for spine in axes.spines.values():
        spine.set_visible(False)
    return figure


def flow_curve(result: Result, trace: Trace) -> tuple[FloatArray, FloatArray] | None:
    """Return the fitted flow law as a curve, in arrays of abscissas and ordinates.

    The curve is the effective conductance versus p2/p1, at the mean of the measured inlet pressures. The result is None
    if the channel is not an effective conductance, or a parameter of the flow law is not known.
    """
    numbers = dict(result.conditions.get("fixed", {}))
    numbers |= {name.rpartition(".")[2]: e.value for name, e in result.parameters.items()}
    law = ("sonic_conductance", "critical_ratio", "subsonic_index", "cracking_pressure")
    is_known = all(math.isfinite(numbers.get(k, math.nan)) for k in law)
    if not is_known or not trace.name.endswith("effective_conductance"):
        return None
    pressure = float(np.mean(result.conditions.get("pressure_1", 7e5)))
    ratio = np.linspace(0.0, 1.0, 401)[:-1]
    parameters: dict[str, Any] = {name: float(numbers[name]) for name in law}
    flow = mass_flow_rate(pressure, ratio * pressure, REFERENCE_TEMPERATURE, **parameters)
    return ratio, flow / (REFERENCE_DENSITY * pressure)
