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
from poppet.identify.result import DETERMINED, VERDICTS, WEAK
from poppet.report.html_page import Section, document, findings, folded, head, items, paragraph, picture, write_page
from poppet.report.identification import identification_figures as figures
from poppet.report.identification import identification_tables as tables
from poppet.report.identification.cost_figures import contour_figure, profile_figure, starts_figure
from poppet.report.identification.headline import headline, next_step, split_notes
from poppet.report.identification.method_sections import MethodReport
from poppet.report.styles import stylesheet
from poppet.report.tables import ReportTable, code
from poppet.timeseries.plotting.figures import style

_BACKGROUNDS = {"determined": "#e3f3e8", "weak": "#fdf0d9", "not determined": "#fbe4e1", "at bound": "#f1e6f6"}
_VERDICT_STYLE = "".join(
    f".verdict.{v.replace(' ', '-')} {{ background: {_BACKGROUNDS[v]}; color: {colour}; }}\n"
    f".summary.{v.replace(' ', '-')} {{ border-left-color: {colour}; }}\n"
    for v, colour in ((verdict, figures.VERDICT_COLOURS[verdict]) for verdict in VERDICTS)
)
_WORST_FIRST = ("not determined", "at bound", "weak", "determined")


def write_identification(result: Result, path: str | Path) -> Path:
    """Write the HTML report of an identification; equal results give equal bytes."""
    return write_page(path, lambda: identification_page(result))


def identification_page(result: Result) -> str:
    """Return the report of an identification as HTML."""
    declaration = METHODS.get(result.method)
    method = (import_object(declaration.sections) if declaration else None) or MethodReport()
    with style("A report of an identification"):
        c = result.comparison
        explanation = f"<p>{_text('explained', determined=100.0 * DETERMINED, weak=100.0 * WEAK)}</p>\n"
        if declaration and declaration.intervals:
            explanation += f"<p>{declaration.intervals}</p>\n"
        sections = [
            Section("", _head(result, method)),
            Section("Findings", _findings(result)),
            Section("Equivalent optima", _optima(result)),
            Section("Thermal laws", _laws(result)),
            Section("Alternative models", tables.alternative_table(result) if c.get("alternatives") else ""),
            *method.models(result),
            Section("Fit", [_channel(result, trace, k) for k, trace in enumerate(figures.traces_of(result))]),
            Section("Parameters", _parameters(result)),
            Section("Searches", _searches(result)),
            Section("Profiles", _profiles(result)),
            Section("Conductance and wall conductance", _contour(result)),
            Section("Residuals", _residuals(result)),
            Section("Comparison", _comparison(result)),
            Section("Tests of the fit", tables.statistics_table(result)),
            *method.evidence(result),
            Section("Conditions", tables.condition_table(result)),
            Section("Explanation", explanation),
            Section("Sources", _sources(result, method)),
        ]
    return document(result.title, sections, style=stylesheet("identification") + _VERDICT_STYLE)


def _head(result: Result, method: MethodReport) -> str:
    declaration = METHODS.get(result.method)
    estimates = sorted(result.parameters.items(), key=lambda item: _WORST_FIRST.index(item[1].verdict))
    worst = estimates[0][1].verdict if estimates else "determined"
    rows = [(tables.verdict_word(e.verdict), code(name), tables.estimate_text(e)) for name, e in estimates]
    # The band of a curve has more meaning than its parameters.
    curves = [t for t in figures.traces_of(result) if method.has_bands and t.low.size and not t.is_timed]
    bands = "".join(paragraph(_band_width(trace)) for trace in curves)
    step = next_step(result)
    description = declaration.description if declaration else result.method
    next_line = f"<p><strong>Next:</strong> {html.escape(step)}</p>\n" if step else ""
    # Without headings the table of the summary is not stacked.
    summary = bands or ReportTable(("", "", ""), rows).html().replace("scroll stack", "scroll")
    kind = f"summary {worst.replace(' ', '-')}"
    return (
        f'{head(result.title, description)}<div class="{kind}"><p>{html.escape(headline(result))}</p>\n'
        f"{next_line}{summary}</div>\n"
    )


def _findings(result: Result) -> str:
    major, minor = split_notes(result.remarks)
    text = findings(major, "ol") or f"<p>{_text('nothing_found')}</p>\n"
    return text + folded(f"{len(minor)} note{'s' * (len(minor) != 1)} on reading the recordings", findings(minor))


def _band_width(trace: figures.Trace) -> str:
    """Return a sentence on the maximum half width of the uncertainty band of a curve."""
    x = trace.x if trace.x.size else trace.curve_x
    is_inside = (trace.curve_x >= np.min(x)) & (trace.curve_x <= np.max(x))
    half = 0.5 * float(np.max((trace.high - trace.low)[is_inside], initial=0.0))
    largest = float(np.max(np.abs(trace.model[is_inside]), initial=0.0))
    is_ratio = trace.unit == "1" or not largest
    size = f"{half:.2g}" if is_ratio else f"{100.0 * half / largest:.2g} % of its largest value"
    return f"The 95 % band of {trace.quantity} stays within ± {size} between the first and the last point."


def _parameters(result: Result) -> list[str | ReportTable]:
    if not result.parameters:
        return []
    outside = []
    for name, e in result.parameters.items():
        low, high = figures.interval_range(e)
        if math.isfinite(e.start) and not low <= e.start <= high:
            outside.append(f"{name} {tables.value_text(e.start, e.unit)}")
    caption = _text("caption.intervals") + (f" Starts outside: {', '.join(outside)}." if outside else "")
    content: list[str | ReportTable] = [
        tables.parameter_table(result.parameters),
        picture(figures.interval_figure(result.parameters), "intervals", caption, is_still=True),
    ]
    if len(result.correlation) > 2:
        matrix = figures.correlation_figure(result.correlation)
        return [*content, picture(matrix, "correlation", _text("caption.correlation"), kind="narrow")]
    return [*content, paragraph(tables.correlation_sentence(result.correlation))]


def _laws(result: Result) -> list[str | ReportTable]:
    """Return the estimates under each thermal law as a table, and the conductances as bars."""
    if "thermal_laws" not in result.comparison:
        return []
    conductances: dict[str, Estimate] = {}
    for law, fit in result.comparison["thermal_laws"].items():
        for name, estimate in fit["numbers"].items():
            if name.endswith(".sonic_conductance"):
                conductances.setdefault(law, Estimate(**estimate))
    figure = figures.interval_figure(conductances) if conductances else None
    drawing = picture(figure, "laws", _text("caption.laws"), is_still=True) if figure is not None else ""
    return [tables.law_table(result), drawing]


def _optima(result: Result) -> list[str | ReportTable]:
    return [tables.optimum_table(result), f"<p>{_text('answers')}</p>\n"] if len(result.optima) > 1 else []


def _searches(result: Result) -> list[str | ReportTable]:
    searches = result.conditions.get("searches", ())
    if len(searches) < 2:
        return []
    pair = []
    for field in (".sonic_conductance", ".wall_conductance"):
        pair += [(name, e.unit) for name, e in result.parameters.items() if name.endswith(field)][:1]
    figure = starts_figure(searches, pair if len(pair) == 2 else ())
    return [tables.search_table(result), picture(figure, "searches", _text("caption.searches"))]


def _profiles(result: Result) -> list[str]:
    profiles = {name.partition(".")[2]: t for name, t in result.series.items() if name.startswith("profile.")}
    return [
        picture(profile_figure(t, name), f"profile{k}", f"{name}. {_text('caption.profile')}", kind="narrow")
        for k, (name, t) in enumerate(profiles.items())
    ]


def _residuals(result: Result) -> list[str | ReportTable]:
    return [tables.residual_table(result), f"<p>{_text('residuals')}</p>\n"] if result.residuals else []


def _comparison(result: Result) -> list[str | ReportTable]:
    if "other" not in result.comparison:
        return []
    conclusion = str(result.comparison.get("verdict", ""))
    return [paragraph(conclusion, bold=True), tables.comparison_table(result)]


def _contour(result: Result) -> str:
    if "contour" not in result.series:
        return ""
    return picture(contour_figure(result.series["contour"]), "contour", _text("caption.contour"))


def _channel(result: Result, trace: figures.Trace, index: int) -> str:
    is_flow = trace.name.endswith("effective_conductance")
    curve = figures.flow_curve(result, trace) if is_flow else None
    ratios = [e for name, e in result.parameters.items() if is_flow and name.rpartition(".")[2] == "critical_ratio"]
    is_validation = trace.name.partition(".")[0] in result.conditions.get("validation", ())
    caption = _channel_caption(trace) + (f" {_text('caption.conductance')}" if is_flow else "")
    outliers = [float(note.facts["ratio"]) for note in result.remarks if is_flow and note.code == "flow.outlier"]
    figure = figures.channel_figure(trace, curve, ratios[0] if ratios else None, outliers)
    heading = f"<h3>{code(trace.name)}{', used for validation' if is_validation else ''}</h3>\n"
    return heading + picture(figure, f"channel{index}", caption)


def _channel_caption(trace: figures.Trace) -> str:
    text = "Points: measured; line: model." if trace.model.size else "Points: measured."
    if trace.low.size and not trace.samples.size:
        text += " Band: 95 %."
    if trace.residual.size > 1:
        text += f" Lower axes: model minus measurement; {_residual_bands(trace)}"
    if trace.residual.size >= figures.MIN_SAMPLES:
        text += " The curve in the histogram is the normal distribution of that width."
        if trace.is_timed:
            text += " For white residuals, 95 % of the autocorrelations are within the band."
    return text


def _residual_bands(trace: figures.Trace) -> str:
    unit = figures.residual_unit(trace)

    def size(value: float) -> str:
        return with_unit(f"{scaled(value, trace.unit, unit):.3g}", unit)

    if trace.samples.size:
        half, fraction = np.max(trace.high - trace.model), np.mean(np.abs(trace.residual) <= trace.samples)
        return (
            f"the grey band contains 95 % of the samples if the model is correct (at most ± "
            f"{size(float(np.max(trace.samples)))}; it contains {100.0 * fraction:.1f} %); the coloured band is the "
            f"95 % band of the model (at most ± {size(float(half))})."
        )
    sigma, origin = figures.residual_deviation(trace)
    basis = "twice the noise" if origin == "noise" else "twice the rms of the residuals"
    return f"the grey band is {basis}, ± {size(2.0 * sigma)}."


def _sources(result: Result, method: MethodReport) -> str:
    sources = result.conditions.get("sources", ())
    if isinstance(sources, Mapping):
        sources = [f"{name}: {text}" for name, text in sources.items()]
    texts = [sources] if isinstance(sources, str) else sources
    return items([*texts, *(_text(f"reference.{name}") for name in method.references)])


def _text(code: str, **facts: float | str) -> str:
    """Return a text of the report by its message code.

    `facts` are the values that are inserted into the text.
    """
    return sentence(f"identification.{code}", facts)
