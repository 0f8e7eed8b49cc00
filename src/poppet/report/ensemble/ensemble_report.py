"""HTML report of an ensemble: yield, bands of outputs, metrics, influence of parameters and worst cases."""

from __future__ import annotations

import html
import math
from collections.abc import Mapping
from pathlib import Path

from poppet.core.number_format import USUAL, scaled
from poppet.ensemble import Ensemble
from poppet.ensemble.ensemble_plan import varied_specs
from poppet.report.ensemble.ensemble_figures import (
    MAX_POINTS,
    Array,
    bands_figure,
    histogram_figure,
    scatter_figure,
    tornado_figure,
    usual_unit,
    with_unit,
    yield_figure,
)
from poppet.report.html_page import Section, document, findings, head, paragraph, picture, write_page
from poppet.report.tables import Column, ReportTable, code, numeric
from poppet.timeseries.plotting.figures import style

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
    """Return the yield of each requirement (fraction of good runs) with its confidence interval."""
    rows = [
        (y.name, y.text or "all requirements", y.good, 100.0 * y.share, f"{100.0 * y.low:.4g} ... {100.0 * y.high:.4g}")
        for y in ensemble.yields()
    ]
    return ReportTable(("requirement", "", Column("good runs", "d"), Column("yield [%]", ".4g"), "95 % [%]"), rows)


def metric_table(ensemble: Ensemble) -> ReportTable:
    """Return the mean, the standard deviation and quantiles of every metric."""
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
    """Write the HTML report of an ensemble; equal datasets give equal bytes."""
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
    with style("A report of an ensemble"):
        sections = [
            Section("", head(title, lead) + findings(ensemble.remarks())),
            Section("Yield", _yield(ensemble)),
            Section("Curves", _curves(ensemble)),
            Section("Metrics", _metrics(ensemble, rows)),
            Section("Influence of the parameters", _influence(ensemble)),
            Section("Runs", _scatter(ensemble, rows, units)),
            Section("Worst cases", _worst_cases(ensemble, units)),
            Section("Parameters", _parameter_table(ensemble, units)),
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


def _scatter(ensemble: Ensemble, rows: Mapping[str, Array], units: Mapping[str, str]) -> str:
    if not ensemble.plan.metrics:
        return ""
    sample = {name: values[:MAX_POINTS] for name, values in rows.items()}
    n_points = len(sample["run"])
    caption = "Each metric versus the parameter with the largest effect; orange: runs that miss a requirement"
    caption += f". Only the first {n_points} runs are shown." if ensemble.done > n_points else "."
    return picture(scatter_figure(ensemble, sample, units), "scatter", caption, is_still=True)


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


def _parameter_table(ensemble: Ensemble, units: Mapping[str, str]) -> ReportTable:
    plan, rows = ensemble.plan, []
    for address in plan.addresses:
        distribution = plan.alone.get(address)
        kind = distribution.kind if distribution else "file" if plan.table else "joint normal, from the fit"
        values = (_in_usual_unit(plan.quantile(address, u), units[address]) for u in QUANTILES)
        rows.append((code(address), kind, *values, usual_unit(units[address])))
    return ReportTable(("parameter", "distribution", *numeric("5 %", "median", "95 %", digits=".4g"), "unit"), rows)
