"""HTML reports of ensembles and of sizings.

The report of an ensemble has the yield, bands of outputs, metrics, the influence of parameters and the worst cases. The
report of a sizing has the value of the free parameter, margins and metrics.
"""

from __future__ import annotations

import html
import math
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.message_format import sentence
from poppet.core.number_format import USUAL, number, pretty, scaled
from poppet.core.number_format import with_unit as value_with_unit
from poppet.core.units import convert
from poppet.ensemble import Bands, Ensemble, Sizing, Yield
from poppet.ensemble.ensemble_plan import varied_specs
from poppet.ensemble.metrics import Metric
from poppet.ensemble.statistics import SobolIndex, TornadoRange, wilson
from poppet.report.html_page import Section, document, findings, head, paragraph, picture, write_page
from poppet.report.tables import Column, ReportTable, code, numeric
from poppet.timeseries.plotting.figures import ACCENT, GREY, INK, PALETTE, axes_in, new_figure, style, widest

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
WIDTH = 10.0
GOOD, BAD = PALETTE[0], ACCENT
_GAP = 0.72
_PANEL = 1.9
_STRIP = 0.32
"""Height of a bar with its gap [in]."""
MAX_POINTS = 1500
"""Maximum number of runs in a scatter plot, which limits the size of the page."""
MAX_BARS = 8
"""Maximum number of parameters in a tornado chart."""
_BANDS = (((0.01, 0.99), 0.14, "98 %"), ((0.05, 0.95), 0.22, "90 %"), ((0.25, 0.75), 0.38, "half"))
"""Quantiles of the bands, opacity and label."""
QUANTILES = (0.05, 0.5, 0.95)
"""Quantiles of a metric or a parameter that a table shows."""
_METHODS = {
    "random": "independent samples",
    "latin": "Latin hypercube",
    "sobol": "scrambled Sobol sequence",
    "grid": "grid",
    "file": "values of a file",
}


def yield_table(ensemble: Ensemble) -> ReportTable:
    """Return a table of the yields, with confidence intervals.

    A yield is the fraction of the runs that meet a requirement.
    """
    rows = [
        (y.name, y.text or "all requirements", y.good, 100.0 * y.share, f"{100.0 * y.low:.4g} ... {100.0 * y.high:.4g}")
        for y in ensemble.yields()
    ]
    return ReportTable(("requirement", "", Column("good runs", "d"), Column("yield [%]", ".4g"), "95 % [%]"), rows)


def metric_table(ensemble: Ensemble) -> ReportTable:
    """Return a table with mean, standard deviation and quantiles of each metric."""
    rows = []
    for s in ensemble.summaries():
        values = s.mean, *(s.quantiles.get(q, math.nan) for q in QUANTILES), s.least, s.greatest
        mean, *others = (_in_usual_unit(value, s.unit) for value in values)
        # The standard deviation of a temperature in degC is a difference.
        deviation = _in_usual_unit(s.mean + s.sd, s.unit) - mean
        rows.append((s.name, usual_unit(s.unit), mean, deviation, *others, s.never, s.failed))
    headings = "mean", "sd", *(f"{100 * q:g} %" for q in QUANTILES), "minimum", "maximum"
    return ReportTable(
        ("metric", "unit", *numeric(*headings, digits=".4g"), *numeric("never", "no value", digits="d")), rows
    )


def _in_usual_unit(value: float, unit: str) -> float:
    return float(scaled(value, unit, USUAL.get(unit, unit)))


def write_ensemble(ensemble: Ensemble, path: str | Path) -> Path:
    """Write the report of an ensemble as HTML.

    Equal datasets give equal bytes.
    """
    return write_page(path, lambda: ensemble_page(ensemble))


def ensemble_page(ensemble: Ensemble) -> str:
    """Return the report of an ensemble as HTML."""
    plan = ensemble.plan
    units = {address: spec.unit for address, spec in varied_specs(plan.circuit).items()}
    rows = ensemble.dataset.columns("runs", max_rows=MAX_POINTS * 40)
    title = plan.circuit.title or "An ensemble"
    lead = (
        f"{ensemble.done} runs, {len(plan.addresses)} uncertain parameters, sampling: {_METHODS[plan.sampling]}, "
        f"seed {plan.seed}."
    )
    parameter_rows = []
    for address in plan.addresses:
        distribution, unit = plan.alone.get(address), units[address]
        kind = distribution.kind if distribution else "file" if plan.table else "joint normal, from the fit"
        quantiles = (_in_usual_unit(plan.quantile(address, u), unit) for u in QUANTILES)
        parameter_rows.append((code(address), kind, *quantiles, usual_unit(unit)))
    quantile_columns = numeric("5 %", "median", "95 %", digits=".4g")
    parameters = ReportTable(("parameter", "distribution", *quantile_columns, "unit"), parameter_rows)
    with style("A report of an ensemble"):
        runs = ""
        if plan.metrics:
            sample = {name: values[:MAX_POINTS] for name, values in rows.items()}
            n_points = len(sample["run"])
            caption = "Each metric versus the parameter with the largest effect; orange: runs that miss a requirement"
            caption += f". Only the first {n_points} runs are shown." if ensemble.done > n_points else "."
            runs = picture(scatter_figure(ensemble, sample, units), "scatter", caption, is_still=True)
        sections = [
            Section("", head(title, lead) + findings(ensemble.remarks())),
            Section("Yield", _yield(ensemble)),
            Section("Curves", _curves(ensemble)),
            Section("Metrics", _metrics(ensemble, rows)),
            Section("Influence of the parameters", _influence(ensemble)),
            Section("Runs", runs),
            Section("Worst cases", _worst_cases(ensemble, units)),
            Section("Parameters", parameters),
        ]
    return document(title, sections)


def _yield(ensemble: Ensemble) -> list[str | ReportTable]:
    yields, sampling = ensemble.yields(), ensemble.plan.sampling
    if not yields:
        return []
    caption = "Bars: fraction of the runs that meet a requirement."
    if sampling in ("grid", "file"):
        caption += " The runs are not a random sample, so the interval has little meaning."
    else:
        caption += " Lines: 95 % confidence intervals by Wilson's method."
    if sampling in ("latin", "sobol"):
        caption += " The method assumes independent samples; with this sampling method the intervals are too wide."
    return [picture(yield_figure(yields), "yield", caption, is_still=True), yield_table(ensemble)]


def _curves(ensemble: Ensemble) -> list[str]:
    if (bands := ensemble.bands()) is None:
        return []
    units = dict(ensemble.plan.circuit.model.outputs)
    caption = "the bands contain 50 %, 90 % and 98 % of the runs at each time. A band edge is not one run."
    return [
        picture(bands_figure(bands, units, curve), f"bands-{k}", f"{curve}: {caption}")
        for k, curve in enumerate(bands.curves)
    ]


def _metrics(ensemble: Ensemble, rows: Mapping[str, Array]) -> list[str | ReportTable]:
    if not ensemble.plan.metrics:
        return []
    caption = "Distribution of each metric; dashed lines: bounds of requirements."
    figure = picture(histogram_figure(ensemble, rows), "metrics", caption, is_still=True)
    note = "never: runs in which the event does not occur; no value: the run failed, or the metric is not defined."
    return [figure, metric_table(ensemble), paragraph(note, css_class="lead")]


def _influence(ensemble: Ensemble) -> str:
    indices, tornado, text = ensemble.indices(), ensemble.tornado(), ""
    for k, metric in enumerate(ensemble.plan.metrics):
        ranges, sobol = tornado.get(metric.name, []), indices.get(metric.name)
        if not any(0.0 < effect.size < math.inf for effect in ranges):
            continue
        caption = "One parameter at its 5 % quantile (teal) and its 95 % quantile (amber), the others at their medians."
        if sobol:
            caption += (
                " Right: fraction of the variance from the parameter alone (first) and with its interactions (total); "
                "95 % intervals."
            )
        figure = picture(tornado_figure(metric, ranges, sobol), f"tornado-{k}", caption, is_still=True)
        text += f"<h3>{html.escape(metric.name)}</h3>\n{figure}"
    return text


def _worst_cases(ensemble: Ensemble, units: Mapping[str, str]) -> list[str | ReportTable]:
    plan = ensemble.plan
    if not plan.requirements:
        return []
    metric_units = {metric.name: metric.unit for metric in plan.metrics}
    rows = []
    for requirement in plan.requirements:
        unit = metric_units[requirement.metric]
        for case in ensemble.worst()[requirement.name]:
            value = f"{_in_usual_unit(case.value, unit):.4g}\N{NO-BREAK SPACE}{usual_unit(unit)}".strip()
            if case.value == math.inf:
                value = "never"
            elif not math.isfinite(case.margin):
                value = "failed"
            parameters = (_in_usual_unit(number, units[address]) for address, number in case.numbers.items())
            rows.append((requirement.name, case.run, value, *parameters))
    headings = (with_unit(address, units[address]) for address in plan.addresses)
    text = "<p>Runs with the smallest margins. <code>poppet ensemble FILE --worst FOLDER</code> writes files.</p>\n"
    return [text, ReportTable(("requirement", Column("run", "d"), "metric", *numeric(*headings, digits=".4g")), rows)]


def in_usual_unit(values: Array, unit: str) -> Array:
    """Convert values from an SI unit to the unit that reports use for it."""
    return values if unit not in USUAL else np.asarray(convert(values, unit, USUAL[unit]))


def usual_unit(unit: str) -> str:
    """Return the unit that reports use for an SI unit.

    The text is empty for a dimensionless quantity.
    """
    return "" if unit == "1" else pretty(USUAL.get(unit, unit))


def with_unit(name: str, unit: str) -> str:
    """Return a label with its usual unit in brackets.

    `unit` is an SI unit. A label of a dimensionless quantity has no brackets.
    """
    return f"{name} [{usual_unit(unit)}]".replace(" []", "")


def yield_figure(yields: list[Yield]) -> Figure:
    """Draw the yield of each requirement as a bar with its confidence interval."""
    names = [f"{y.name}: {y.text}" if y.text else "all together" for y in yields]
    left = widest(names, 8.5) + 0.25
    figure = new_figure(WIDTH, _STRIP * len(yields) + 0.75)
    axes = axes_in(figure, left, 0.15, WIDTH - left - 0.9, _STRIP * len(yields))
    for level, y in enumerate(reversed(yields)):
        axes.barh(level, 100.0 * y.share, height=0.6, color=GOOD if y.text else INK, alpha=0.85)
        axes.plot([100.0 * y.low, 100.0 * y.high], [level] * 2, color=ACCENT, linewidth=2.2, solid_capstyle="butt")
        axes.text(101.5, level, f"{100.0 * y.share:.4g} %", va="center", fontsize=8.5, clip_on=False)
    _label_rows(axes, names)
    axes.set(xlim=(0.0, 100.0), xlabel="runs that meet it [%]")
    return figure


def _label_rows(axes: Any, names: list[str], *, is_labelled: bool = True) -> None:
    """Set the tick labels of horizontal bars, from top to bottom.

    If the keyword `is_labelled` is False, the ticks have no labels.
    """
    axes.set_yticks(range(len(names)), list(reversed(names)) if is_labelled else [""] * len(names))
    axes.set_ylim(-0.6, len(names) - 0.4)
    axes.grid(visible=False, axis="y")


def bands_figure(bands: Bands, units: Mapping[str, str], curve: str) -> Figure:
    """Draw quantiles of one output over all runs versus time.

    `curve` is the address of the output, and `units` maps addresses to SI units.
    """
    figure = new_figure(WIDTH, 3.4)
    axes = axes_in(figure, 0.8, 0.3, WIDTH - 1.0, 2.5)
    unit = units[curve]
    for quantiles, alpha, label in _BANDS:
        edges = [in_usual_unit(bands.quantile(curve, u), unit) for u in quantiles]
        axes.fill_between(bands.time, *edges, color=GOOD, alpha=alpha, linewidth=0.0, label=f"{label} of the runs")
    axes.plot(bands.time, in_usual_unit(bands.quantile(curve, 0.5), unit), color=INK, linewidth=1.1, label="median")
    label = with_unit(curve.replace("_", " "), unit)
    axes.set(xlim=(bands.time[0], bands.time[-1]), xlabel="time [s]", ylabel=label)
    figure.legend(*axes.get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(0.07, 1.0), ncols=4, fontsize=8)
    return figure


def _figure_with_panels(titles: list[str], draw: Callable[[int, Any], None], height: float = _PANEL) -> Figure:
    """Return a figure with a small panel for each title.

    The function `draw` draws a panel; its arguments are the index of the panel in `titles` and the axes of the panel.
    `height` is the height of a panel [in]. There are at most three panels in a row.
    """
    columns = 2 if len(titles) in (1, 2, 4) else 3
    rows, width = -(-len(titles) // columns), (WIDTH - 0.8 - (columns - 1) * _GAP) / columns
    figure = new_figure(WIDTH, rows * (height + 0.95))
    for k, title in enumerate(titles):
        row, column = divmod(k, columns)
        axes = axes_in(figure, 0.7 + column * (width + _GAP), 0.35 + row * (height + 0.95), width, height)
        axes.set_title(title, loc="left", fontsize=9.5)
        draw(k, axes)
    return figure


def histogram_figure(ensemble: Ensemble, rows: Mapping[str, Array]) -> Figure:
    """Draw the histogram of each metric, with the bounds of the requirements.

    `rows` maps each metric to its values in all runs.
    """
    metrics = ensemble.plan.metrics

    def draw(k: int, axes: Any) -> None:
        metric = metrics[k]
        values = in_usual_unit(rows[metric.name][np.isfinite(rows[metric.name])], metric.unit)
        if values.size:
            axes.hist(values, bins=min(60, max(10, round(values.size**0.5))), color=GOOD, alpha=0.85)
            _draw_bounds(ensemble, metric, axes.axvline, axes.get_xlim())
        axes.set(xlabel=usual_unit(metric.unit), ylabel="runs")

    return _figure_with_panels([metric.name.replace("_", " ") for metric in metrics], draw)


def _draw_bounds(ensemble: Ensemble, metric: Metric, line: Callable[..., Any], limits: tuple[float, float]) -> None:
    """Draw the bounds of all requirements on a metric into a panel.

    `line` is the method of the axes that draws one line, and `limits` are the limits of the axis. Bounds far outside
    them are omitted.
    """
    span = limits[1] - limits[0]
    for requirement in ensemble.plan.requirements:
        for _, bound in requirement.bounds if requirement.metric == metric.name else ():
            level = float(in_usual_unit(np.array([bound]), metric.unit)[0])
            if limits[0] - span <= level <= limits[1] + span:
                line(level, color=ACCENT, linewidth=1.3, linestyle=(0, (4, 2)))


def scatter_figure(ensemble: Ensemble, rows: Mapping[str, Array], units: Mapping[str, str]) -> Figure:
    """Draw each metric versus the parameter that affects it most.

    `rows` maps metrics and parameters to their values in all runs, and `units` maps parameters to SI units.
    """
    metrics = ensemble.plan.metrics
    strongest = {name: ranges[0].address for name, ranges in ensemble.tornado().items() if ranges}
    is_good = np.ones(len(rows["done"]), dtype=np.bool_)
    for requirement in ensemble.plan.requirements:
        is_good &= requirement.met(rows[requirement.metric])

    def draw(k: int, axes: Any) -> None:
        metric, address = metrics[k], strongest[metrics[k].name]
        y = in_usual_unit(rows[metric.name], metric.unit)
        x = in_usual_unit(rows[address], units[address])
        for mask, colour in ((is_good, GOOD), (~is_good, BAD)):
            is_visible = mask & np.isfinite(y)
            axes.plot(x[is_visible], y[is_visible], ".", color=colour, markersize=2.6, alpha=0.55)
        if np.isfinite(y).any():
            _draw_bounds(ensemble, metric, axes.axhline, axes.get_ylim())
        axes.set_xlabel(with_unit(address, units[address]), fontsize=8.5)

    return _figure_with_panels([with_unit(metric.name.replace("_", " "), metric.unit) for metric in metrics], draw)


def tornado_figure(metric: Metric, ranges: list[TornadoRange], indices: list[SobolIndex] | None) -> Figure:
    """Draw the effect of each parameter on a metric as a tornado chart.

    The bars show the metric at a low and at a high value of each parameter. Sobol indices, if available, are drawn
    beside the chart.
    """
    effects = [effect for effect in ranges if math.isfinite(effect.size)][:MAX_BARS]
    names = [effect.address for effect in effects]
    left = max(widest(names, 8.5) + 0.25, 0.8)
    height, total_width = _STRIP * max(len(effects), 1), WIDTH - left - 0.3
    width = 0.56 * total_width if indices else total_width
    figure = new_figure(WIDTH, height + 1.0)
    axes = axes_in(figure, left, 0.35, width, height)
    for level, effect in enumerate(reversed(effects)):
        middle, low, high = in_usual_unit(np.array([effect.middle, effect.low, effect.high]), metric.unit)
        for end, colour in ((low, PALETTE[5]), (high, PALETTE[4])):
            axes.barh(level, end - middle, left=middle, height=0.6, color=colour)
    if effects:
        median = float(in_usual_unit(np.array([effects[0].middle]), metric.unit)[0])
        axes.axvline(median, color=INK, linewidth=0.9)
    _label_rows(axes, names)
    axes.set_xlabel(with_unit(metric.name.replace("_", " "), metric.unit))
    if indices:
        axes = axes_in(figure, left + width + 0.35, 0.35, total_width - width - 0.35, height)
        by_factor = {index.factor: index for index in indices}
        for level, name in enumerate(reversed(names)):
            # All parameters of a fit are one factor.
            index = by_factor.get(name, by_factor.get("from_fit"))
            if index is None:
                continue
            for y, value, low, high, colour in (
                (level + 0.16, index.first, index.first_low, index.first_high, PALETTE[0]),
                (level - 0.16, index.total, index.total_low, index.total_high, PALETTE[3]),
            ):
                axes.plot([low, high], [y, y], color=colour, linewidth=1.4)
                axes.plot([value], [y], "o", color=colour, markersize=4.0)
        axes.plot([], [], "o-", color=PALETTE[0], label="first")
        axes.plot([], [], "o-", color=PALETTE[3], label="total")
        _label_rows(axes, names, is_labelled=False)
        axes.set_xlim(min(0.0, axes.get_xlim()[0]), max(1.0, axes.get_xlim()[1]))
        axes.axvline(0.0, color=GREY, linewidth=0.8)
        axes.set_xlabel("Sobol index [1]")
        axes.legend(loc="lower right", fontsize=7.5)
    return figure


def write_sizing(sizing: Sizing, path: str | Path) -> Path:
    """Write the report of a sizing as a self-contained HTML page."""
    return write_page(path, lambda: sizing_page(sizing))


def sizing_page(sizing: Sizing) -> str:
    """Return the report of a sizing as HTML."""
    caption, lead, share_caption, explanation = (
        sentence(f"size.page.{key}", {"which": _extreme(sizing), "address": sizing.address} if key == "lead" else {})
        for key in ("caption", "lead", "share_caption", "explained")
    )
    with style("A page of a sizing"):
        caption += f" {share_caption}" if sizing.share < 1.0 else ""
        line = paragraph(_metric_line(sizing) if sizing.is_met else "")
        result = (paragraph(_headline(sizing), bold=True), line, _margin_table(sizing), findings(sizing.remarks))
        sections = [
            Section("", head(sizing.title, lead)),
            Section("Result", result),
            Section("Metrics versus the parameter", picture(curve_figure(sizing), "curves", caption)),
            Section("Explanation", f"<p>{explanation}</p>\n"),
        ]
    return document(sizing.title or sizing.address, sections)


def sizing_text(sizing: Sizing) -> str:
    """Return the result of a sizing as text for a terminal."""
    lines = [sizing.title] if sizing.title else []
    lines.append(_headline(sizing))
    lines += ["", _margin_table(sizing).text(), "", _metric_line(sizing)] if sizing.is_met else []
    return "\n".join([*lines, *(f"- {remark}" for remark in sizing.remarks)])


def _extreme(sizing: Sizing) -> str:
    return "largest" if sizing.is_largest else "smallest"


def _headline(sizing: Sizing) -> str:
    if not sizing.is_met:
        return f"{sizing.address}: no value in the range meets the requirements."
    text = f"{_extreme(sizing).capitalize()} {sizing.address}: {_value_text(sizing, sizing.value)}"
    if sizing.share < 1.0:
        low, high = (100.0 * end for end in sizing.interval)
        text += f" (yield {100.0 * sizing.share:g} %, 95 % interval {low:.4g} ... {high:.4g} %)"
    text += f", limited by {sizing.limiting}" if sizing.limiting else ""
    if sizing.has_nominal_flow:
        flow = 6e4 * sizing.nominal_flow  # [l/min ANR]
        text += f"; nominal flow {flow:.4g} l/min ANR with b = {sizing.critical_ratio:.3g}"
    return text + (f"; of the sizes: {_value_text(sizing, sizing.size)}." if math.isfinite(sizing.size) else ".")


def _value_text(sizing: Sizing, value: float) -> str:
    return value_with_unit(number(sizing.shown(value)), sizing.shown_unit)


def _margin_table(sizing: Sizing) -> ReportTable:
    units = {name: sizing.units[metric] for name, metric in sizing.bounded.items()}
    rows = [
        (name, sizing.requirements[name], value_with_unit(f"{margin:.3g}", units[name]))
        for name, margin in sizing.margins.items()
    ]
    return ReportTable(("requirement", "", *numeric("margin at the value")), rows, "Requirements")


def _metric_line(sizing: Sizing) -> str:
    """Return the metrics at the value of the parameter as text; for several runs, they are means."""
    values = sizing.metrics_at_value.items()
    texts = (f"{name} {value_with_unit(f'{value:.4g}', sizing.units[name])}" for name, value in values)
    return f"{'Means' if sizing.share < 1.0 else 'Metrics'} at this value: {', '.join(texts)}."


def curve_figure(sizing: Sizing) -> Figure:
    """Draw each metric versus the parameter that is sized.

    If there are several runs at each value of the parameter, the yield is also drawn.
    """
    unit = sizing.shown_unit
    x = np.array([sizing.shown(value) for value in sizing.values])
    rows = [*sizing.metrics, *(["yield"] if sizing.share < 1.0 else [])]
    figure = new_figure(WIDTH, 0.35 + len(rows) * (_PANEL + 0.35) + 0.3)
    for k, name in enumerate(rows):
        bounds: tuple[float, ...]
        axes = axes_in(figure, 0.95, 0.25 + k * (_PANEL + 0.35), WIDTH - 1.2, _PANEL)
        if name == "yield":
            ends = np.array([wilson(round(share * sizing.runs), sizing.runs) for share in sizing.shares])
            axes.fill_between(x, 100.0 * ends[:, 0], 100.0 * ends[:, 1], color=GREY, alpha=0.25, linewidth=0)
            y, bounds, label = 100.0 * sizing.shares, (100.0 * sizing.share,), "good runs [%]"
        else:
            y = np.where(np.isfinite(sizing.metrics[name]), sizing.metrics[name], np.nan)
            bounds, label = sizing.bounds.get(name, ()), f"{name} [{pretty(sizing.units[name])}]".replace(" [1]", "")
        axes.plot(x, y, color=PALETTE[0], linewidth=1.3, marker="o", markersize=2.2, markeredgewidth=0)
        for bound in bounds:
            axes.axhline(bound, color=INK, linewidth=1.0, linestyle=(0, (5, 3)))
        axes.set_ylabel(label, parse_math=False)
        for interval in sizing.holding:
            first, last = (sizing.shown(end) for end in interval)
            axes.axvspan(first, last, color=PALETTE[2], alpha=0.12, linewidth=0)
        if sizing.is_met:
            axes.axvline(sizing.shown(sizing.value), color=ACCENT, linewidth=1.4)
        if x[0] > 0.0:
            axes.set_xscale("log")
            axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        axes.set_xlim(x[0], x[-1])
        axes.tick_params(labelbottom=k == len(rows) - 1)
    axes.set_xlabel(f"{sizing.address} [{pretty(unit)}]".replace(" [1]", ""), parse_math=False)
    return figure
