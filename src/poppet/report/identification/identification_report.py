"""HTML report of an identification: verdict, parameters, fit, residuals, conditions and sources."""

from __future__ import annotations

import html
import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from poppet.core.message_format import sentence
from poppet.core.number_format import scaled, with_unit
from poppet.core.plugins import import_object
from poppet.identify import Estimate, Result
from poppet.identify.methods import METHODS
from poppet.identify.result import VERDICTS
from poppet.report.html_page import (
    Content,
    Section,
    document,
    findings,
    folded,
    head,
    items,
    paragraph,
    picture,
    write_page,
)
from poppet.report.identification import identification_figures as figures
from poppet.report.identification import identification_tables as tables
from poppet.report.identification.cost_figures import contour_figure, profile_figure, search_figure
from poppet.report.identification.headline import headline, next_step, split_notes
from poppet.report.identification.method_sections import MethodReport
from poppet.report.identification.verdict_reasons import verdict_limits, verdict_reasons
from poppet.report.styles import stylesheet
from poppet.report.tables import ReportTable, code
from poppet.timeseries.plotting.figures import style

_BACKGROUNDS = {"determined": "#e3f3e8", "weak": "#fdf0d9", "not determined": "#fbe4e1", "at bound": "#f1e6f6"}
_VERDICT_STYLE = "".join(
    f".verdict.{v.replace(' ', '-')} {{ background: {_BACKGROUNDS[v]}; color: {figures.VERDICT_COLOURS[v]}; }}\n"
    f".summary.{v.replace(' ', '-')} {{ border-left-color: {figures.VERDICT_COLOURS[v]}; }}\n"
    for v in VERDICTS
)
_WORST_FIRST = ("not determined", "at bound", "weak", "determined")


def write_identification(result: Result, path: str | Path) -> Path:
    """Write the report of an identification as HTML.

    Equal results give equal bytes.
    """
    return write_page(path, lambda: identification_page(result))


def identification_page(result: Result) -> str:
    """Return the report of an identification as HTML."""
    declaration = METHODS.get(result.method)
    method = (import_object(declaration.sections) if declaration else None) or MethodReport()
    with style("A report of an identification"):
        c = result.comparison
        explanation = f"<p>{_report_text('explained', **verdict_limits(result))}</p>\n"
        if declaration and declaration.intervals:
            explanation += f"<p>{declaration.intervals}</p>\n"
        major, minor = split_notes(result.remarks)
        notes = findings(major, "ol") or f"<p>{_report_text('nothing_found')}</p>\n"
        notes += folded(f"{len(minor)} note{'s' * (len(minor) != 1)} on reading the recordings", findings(minor))
        optima: Content = ""
        if len(result.optima) > 1:
            optima = [tables.optimum_table(result), f"<p>{_report_text('answers')}</p>\n"]
        laws: Content = ""
        if "thermal_laws" in c:
            conductances: dict[str, Estimate] = {}
            for law, fit in c["thermal_laws"].items():
                estimates = [e for name, e in fit["numbers"].items() if name.endswith(".sonic_conductance")]
                if estimates:
                    conductances[law] = Estimate(**estimates[0])
            bars = figures.interval_figure(conductances) if conductances else None
            caption = _report_text("caption.laws")
            laws = [tables.law_table(result), picture(bars, "laws", caption, is_still=True) if bars else ""]
        residuals: Content = ""
        if result.residuals:
            residuals = [tables.residual_table(result), f"<p>{_report_text('residuals')}</p>\n"]
        comparison: Content = ""
        if "other" in c:
            comparison = [paragraph(str(c.get("verdict", "")), bold=True), tables.comparison_table(result)]
        sources = result.conditions.get("sources", ())
        if isinstance(sources, Mapping):
            sources = [f"{name}: {text}" for name, text in sources.items()]
        source_texts = [sources] if isinstance(sources, str) else sources
        sections = [
            Section("", _title_and_results(result, method)),
            Section("Findings", notes),
            Section("Equivalent optima", optima),
            Section("Thermal laws", laws),
            Section("Alternative models", tables.alternative_table(result) if c.get("alternatives") else ""),
            *method.models(result),
            Section("Fit", [_channel_content(result, *numbered) for numbered in enumerate(figures.traces_of(result))]),
            Section("Parameters", _parameters(result)),
            *_search_sections(result),
            Section("Residuals", residuals),
            Section("Comparison", comparison),
            Section("Tests of the fit", tables.statistics_table(result)),
            *method.evidence(result),
            Section("Conditions", tables.condition_table(result)),
            Section("Explanation", explanation),
            Section(
                "Sources", items([*source_texts, *(_report_text(f"reference.{name}") for name in method.references)])
            ),
        ]
    return document(result.title, sections, style=stylesheet("identification") + _VERDICT_STYLE)


def _title_and_results(result: Result, method: MethodReport) -> str:
    """Return the title of the report and its main results as HTML.

    The main results are the band of a fitted curve, or the parameters, the least certain first.
    """
    declaration = METHODS.get(result.method)
    estimates = sorted(result.parameters.items(), key=lambda item: _WORST_FIRST.index(item[1].verdict))
    worst = estimates[0][1].verdict if estimates else "determined"
    # The band of a curve has more meaning than its parameters.
    bands = ""
    for trace in figures.traces_of(result) if method.has_bands else ():
        if trace.is_timed or not trace.low.size:
            continue
        x = trace.x if trace.x.size else trace.curve_x
        is_inside = (trace.curve_x >= np.min(x)) & (trace.curve_x <= np.max(x))
        half = 0.5 * float(np.max((trace.high - trace.low)[is_inside], initial=0.0))
        largest = float(np.max(np.abs(trace.model[is_inside]), initial=0.0))
        is_ratio = trace.unit == "1" or not largest
        size = f"{half:.2g}" if is_ratio else f"{100.0 * half / largest:.2g} % of its largest value"
        band = f"The 95 % band of {trace.quantity} stays within ± {size} between the first and the last point."
        bands += paragraph(band)
    rows = [(tables.verdict_word(e.verdict), code(name), tables.estimate_text(e)) for name, e in estimates]
    # Without headings the table of the summary is not stacked.
    summary = bands or ReportTable(("", "", ""), rows).html().replace("scroll stack", "scroll")
    reasons = "" if bands else "".join(map(paragraph, verdict_reasons(result)))
    step = next_step(result)
    next_line = f"<p><strong>Next:</strong> {html.escape(step)}</p>\n" if step else ""
    return (
        f"{head(result.title, declaration.description if declaration else result.method)}"
        f'<div class="summary {worst.replace(" ", "-")}"><p>{html.escape(headline(result))}</p>\n'
        f"{next_line}{summary}{reasons}</div>\n"
    )


def _parameters(result: Result) -> list[str | ReportTable]:
    if not result.parameters:
        return []
    outside = []
    for name, e in result.parameters.items():
        low, high = figures.interval_range(e)
        if math.isfinite(e.start) and not low <= e.start <= high:
            outside.append(f"{name} {tables.value_text(e.start, e.unit)}")
    caption = _report_text("caption.intervals") + (f" Starts outside: {', '.join(outside)}." if outside else "")
    intervals = picture(figures.interval_figure(result.parameters), "intervals", caption, is_still=True)
    correlation = paragraph(tables.correlation_sentence(result.correlation))
    if len(result.correlation) > 2:
        matrix = figures.correlation_figure(result.correlation)
        correlation = picture(matrix, "correlation", _report_text("caption.correlation"), kind="narrow")
    return [tables.parameter_table(result.parameters), intervals, correlation]


def _search_sections(result: Result) -> list[Section]:
    """Return the sections on the searches and on chi-square near the optimum."""
    searches, series, content = result.conditions.get("searches", ()), result.series, list[str | ReportTable]()
    if len(searches) > 1:
        pair = []
        for field in (".sonic_conductance", ".wall_conductance"):
            pair += [(name, e.unit) for name, e in result.parameters.items() if name.endswith(field)][:1]
        figure = search_figure(searches, pair if len(pair) == 2 else ())
        content = [tables.search_table(result), picture(figure, "searches", _report_text("caption.searches"))]
    profiles = {name.partition(".")[2]: table for name, table in series.items() if name.startswith("profile.")}
    pictures = [
        picture(profile_figure(table, name), f"profile{k}", f"{name}. {_report_text('caption.profile')}", kind="narrow")
        for k, (name, table) in enumerate(profiles.items())
    ]
    contour = ""
    if "contour" in series:
        contour = picture(contour_figure(series["contour"]), "contour", _report_text("caption.contour"))
    return [
        Section("Searches", content),
        Section("Profiles", pictures),
        Section("Conductance and wall conductance", contour),
    ]


def _channel_content(result: Result, index: int, trace: figures.Trace) -> str:
    """Return the heading, the figure and the caption for one channel as HTML.

    `index` is the index of the channel.
    """
    unit = figures.residual_unit(trace)

    def size(value: float) -> str:
        return with_unit(f"{scaled(value, trace.unit, unit):.3g}", unit)

    caption = "Points: measured; line: model." if trace.model.size else "Points: measured."
    if trace.low.size and not trace.samples.size:
        caption += " Band: 95 %."
    if trace.residual.size > 1 and trace.samples.size:
        half, fraction = np.max(trace.high - trace.model), np.mean(np.abs(trace.residual) <= trace.samples)
        caption += (
            " Lower axes: model minus measurement; the grey band contains 95 % of the samples if the model is correct "
            f"(at most ± {size(float(np.max(trace.samples)))}; it contains {100.0 * fraction:.1f} %); the coloured "
            f"band is the 95 % band of the model (at most ± {size(float(half))})."
        )
    elif trace.residual.size > 1:
        sigma, origin = figures.residual_deviation(trace)
        basis = "twice the noise" if origin == "noise" else "twice the rms of the residuals"
        caption += f" Lower axes: model minus measurement; the grey band is {basis}, ± {size(2.0 * sigma)}."
    if trace.residual.size >= figures.MIN_SAMPLES:
        caption += " The curve in the histogram is the normal distribution of that width."
        if trace.is_timed:
            caption += " For white residuals, 95 % of the autocorrelations are within the band."
    curve, ratio, outliers = None, None, list[float]()
    if trace.name.endswith("effective_conductance"):
        caption += f" {_report_text('caption.conductance')}"
        curve = figures.flow_curve(result, trace)
        ratio = next((e for key, e in result.parameters.items() if key.rpartition(".")[2] == "critical_ratio"), None)
        outliers = [float(note.facts["ratio"]) for note in result.remarks if note.code == "flow.outlier"]
    figure = figures.channel_figure(trace, curve, ratio, outliers)
    is_validation = trace.name.partition(".")[0] in result.conditions.get("validation", ())
    heading = f"<h3>{code(trace.name)}{', used for validation' if is_validation else ''}</h3>\n"
    return heading + picture(figure, f"channel{index}", caption)


def _report_text(code: str, **facts: float | str) -> str:
    """Return a text of the report from the message catalogue.

    `code` is the code of the message without the prefix `identification.`, and the keyword arguments are the values in
    its text.
    """
    return sentence(f"identification.{code}", facts)
