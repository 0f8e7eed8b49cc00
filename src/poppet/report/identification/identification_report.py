"""The page of an identification: verdict, numbers with intervals, fit, residuals, comparison, conditions, sources."""

from __future__ import annotations

import html
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.message_format import sentence
from poppet.core.number_format import number, readable_unit, scaled, with_unit
from poppet.identify import Estimate, Result
from poppet.identify.result import DETERMINED, METHODS, VERDICTS, WEAK
from poppet.report.html_page import document, findings, head, picture, write_page
from poppet.report.identification import identification_figures, identification_tables, landscape
from poppet.report.identification.headline import headline, next_step, sorted_out
from poppet.report.identification.series import Trace, traces_of
from poppet.timeseries.plotting.figures import style

_PALE = {"determined": "#e3f3e8", "weak": "#fdf0d9", "not determined": "#fbe4e1", "at bound": "#f1e6f6"}
_STYLE = """
.summary { border: 1px solid var(--line); border-left: .4rem solid; border-radius: .4rem; background: var(--wash);
  padding: .7rem 1.1rem; margin: 1.2rem 0 1.6rem; }
.summary > p:first-child { font-size: 1.15rem; font-weight: 600; margin: .1rem 0 .5rem; }
.summary table { margin: 0; } .summary td { border: 0; padding: .15rem 1.2rem .15rem 0; white-space: nowrap; }
@media (max-width: 40rem) { .summary tr, .summary td { display: block; white-space: normal; }
  .summary tr { padding: .3rem 0; } .summary td { padding: 0; } .summary td:first-child { float: right; } }
.summary .scroll { background: none; }
details { margin: .6rem 0; } summary { cursor: pointer; color: var(--soft); }
pre { white-space: pre-wrap; overflow-wrap: anywhere; }
code { font: .92em/1.4 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
""" + "".join(
    f".verdict.{v.replace(' ', '-')} {{ background: {_PALE[v]}; color: {colour}; }}\n"
    f".summary.{v.replace(' ', '-')} {{ border-left-color: {colour}; }}\n"
    for v, colour in ((verdict, identification_figures.VERDICT_COLOURS[verdict]) for verdict in VERDICTS)
)
_REFERENCES = {
    "tank": ("iso6358_2",),
    "flow": ("iso6358_1", "gum"),
    "characteristic": ("varga2012",),
    "muscle": ("muscle_laws", "jackknife"),
    "friction": ("friction_laws", "clusters", "one_error"),
}
_WORST_FIRST = ("not determined", "at bound", "weak", "determined")


def write_identification(result: Result, path: str | Path) -> Path:
    """Write an identification as one page that needs nothing else; the same result gives the same bytes."""
    return write_page(path, lambda: identification_page(result))


def identification_page(result: Result) -> str:
    """The page as text."""
    with style("A report of an identification"):
        c, verdict = result.comparison, html.escape(str(result.comparison.get("verdict", "")))
        explained = _said("explained", determined=100.0 * DETERMINED, weak=100.0 * WEAK)
        of_method = _said(f"intervals.{result.method}") if result.method in METHODS else ""
        fit = "".join(_channel(result, trace, k) for k, trace in enumerate(traces_of(result)))
        sections = [
            ("", _head(result)),
            ("Findings", _findings(result)),
            ("Answers that fit alike", _answers(result)),
            ("Thermal laws side by side", _laws(result)),
            (
                "Other models of the same recordings",
                identification_tables.alternative_table(result) if c.get("alternatives") else "",
            ),
            ("Laws of the force", identification_tables.force_table(result) if c.get("forces") else ""),
            ("Laws of friction", identification_tables.friction_table(result) if result.method == "friction" else ""),
            ("Fit", fit),
            ("Numbers", _numbers(result)),
            ("Where the searches ended", _searches(result)),
            ("Profiles", _profiles(result)),
            ("Conductance against wall heat", _contour(result)),
            (
                "Residuals",
                identification_tables.residual_table(result) + _paragraph(_said("residuals"))
                if result.residuals
                else "",
            ),
            (
                "Comparison",
                f"<p><strong>{verdict}</strong></p>\n{identification_tables.comparison_table(result)}"
                if "other" in c
                else "",
            ),
            ("Tests of the fit", identification_tables.statistics_table(result)),
            (
                "Tests at the strokes",
                identification_tables.stroke_table(result) if result.conditions.get("tests") else "",
            ),
            (
                "Formulas of the standard",
                identification_tables.standard_table(result) if c.get("standard_formulas") else "",
            ),
            ("Uncertainty budget", identification_tables.budget_table(result) if c.get("uncertainty") else ""),
            ("Conditions", identification_tables.condition_table(result)),
            ("How to read this page", _paragraph(explained) + _paragraph(of_method)),
            ("Sources", _sources(result)),
        ]
    return document(result.title, sections, style=_STYLE)


def _head(result: Result) -> str:
    worst = next((v for v in _WORST_FIRST if any(e.verdict == v for e in result.parameters.values())), "determined")
    rows = "".join(
        f"<tr><td>{identification_tables.verdict_word(e.verdict)}</td><td><code>{html.escape(name)}</code></td>"
        f"<td>{html.escape(identification_tables.estimate_text(e))}</td></tr>\n"
        for name, e in sorted(result.parameters.items(), key=lambda item: _WORST_FIRST.index(item[1].verdict))
    )
    # Numbers of a curve mean little one by one, its band does; of friction they are what was sought.
    is_sought = result.method == "friction"
    curves = [t for t in traces_of(result) if t.low.size and not t.is_timed and not is_sought]
    bands = "".join(_paragraph(html.escape(_band_width(trace))) for trace in curves)
    table = f'<div class="scroll" tabindex="0"><table><tbody>\n{rows}</tbody></table></div>\n'
    shown = bands or (table if rows else "")
    summary = f'<div class="summary {worst.replace(" ", "-")}"><p>{html.escape(headline(result))}</p>\n'
    if step := next_step(result):
        summary += f"<p><strong>Next:</strong> {html.escape(step)}</p>\n"
    method = _said(f"method.{result.method}") if result.method in METHODS else result.method
    return f"{head(result.title, method)}{summary}{shown}</div>\n"


def _findings(result: Result) -> str:
    """What a reader has to know; how the recordings were read is folded."""
    major, minor = sorted_out(result.remarks)
    text = findings(major, "ol") or _paragraph(_said("nothing_found"))
    if not minor:
        return text
    count = f"{len(minor)} note{'s' * (len(minor) != 1)} on reading the recordings"
    return f"{text}<details><summary>{count}</summary>\n{findings(minor)}</details>\n"


def _band_width(trace: Trace) -> str:
    """How well a curve is known where it was measured."""
    place = trace.x if trace.x.size else trace.curve_x
    inside = (trace.curve_x >= np.min(place)) & (trace.curve_x <= np.max(place))
    half = 0.5 * float(np.max((trace.high - trace.low)[inside], initial=0.0))
    largest = float(np.max(np.abs(trace.model[inside]), initial=0.0))
    is_ratio = trace.unit == "1" or not largest
    size = f"{half:.2g}" if is_ratio else f"{100.0 * half / largest:.2g} % of its largest value"
    return f"The 95 % band of {trace.quantity} stays within ± {size} between the first and the last point."


def _numbers(result: Result) -> str:
    if not result.parameters:
        return ""
    text = identification_tables.parameter_table(result.parameters)
    text += picture(
        identification_figures.interval_figure(result.parameters), "intervals", _interval_caption(result), is_still=True
    )
    if len(result.correlation) > 2:
        drawn = identification_figures.correlation_figure(result.correlation)
        return text + picture(drawn, "correlation", _said("caption.correlation"), kind="narrow")
    return text + _paragraph(html.escape(identification_tables.correlation_sentence(result.correlation)))


def _laws(result: Result) -> str:
    """The numbers of every law, and its conductance as a bar."""
    if "thermal_laws" not in result.comparison:
        return ""
    rows = [(law, e) for law, t in result.comparison["thermal_laws"].items() for e in _conductances(t["numbers"])]
    text = identification_tables.law_table(result)
    if rows:
        text += picture(
            identification_figures.interval_figure(dict(rows)), "laws", _said("caption.laws"), is_still=True
        )
    return text


def _conductances(numbers: Mapping[str, Any]) -> list[Estimate]:
    return [Estimate(**e) for name, e in numbers.items() if name.endswith(".sonic_conductance")][:1]


def _answers(result: Result) -> str:
    return identification_tables.answer_table(result) + _paragraph(_said("answers")) if len(result.optima) > 1 else ""


def _searches(result: Result) -> str:
    searches = result.conditions.get("searches", ())
    if len(searches) < 2:
        return ""
    pair = [
        next((name, e.unit) for name, e in result.parameters.items() if name.endswith(word))
        for word in (".sonic_conductance", ".wall_conductance")
        if any(name.endswith(word) for name in result.parameters)
    ]
    drawn = landscape.starts_figure(searches, pair if len(pair) == 2 else ())
    return identification_tables.search_table(result) + picture(drawn, "searches", _said("caption.searches"))


def _profiles(result: Result) -> str:
    found = {name.partition(".")[2]: t for name, t in result.series.items() if name.startswith("profile.")}
    return "".join(
        picture(landscape.profile_figure(t, name), f"profile{k}", f"{name}. {_said('caption.profile')}", kind="narrow")
        for k, (name, t) in enumerate(found.items())
    )


def _contour(result: Result) -> str:
    if "contour" not in result.series:
        return ""
    drawn = landscape.contour_figure(result.series["contour"])
    return picture(drawn, "contour", _said("caption.contour"))


def _interval_caption(result: Result) -> str:
    outside = []
    for name, e in result.parameters.items():
        low, high = identification_figures.interval_range(e)
        if math.isfinite(e.start) and not low <= e.start <= high:
            unit = readable_unit(e.unit, e.start)
            outside.append(f"{name} {with_unit(number(scaled(e.start, e.unit, unit)), unit)}")
    return _said("caption.intervals") + (f" Starts outside: {', '.join(outside)}." if outside else "")


def _channel(result: Result, trace: Trace, place: int) -> str:
    is_flow = trace.name.endswith("effective_conductance")
    curve = identification_figures.flow_curve(result, trace) if is_flow else None
    ratios = [e for name, e in result.parameters.items() if is_flow and name.rpartition(".")[2] == "critical_ratio"]
    held = ", held out of the fit" if trace.name.partition(".")[0] in result.conditions.get("validation", ()) else ""
    caption = _channel_caption(trace) + (f" {_said('caption.conductance')}" if is_flow else "")
    outliers = [float(each.facts["ratio"]) for each in result.remarks if is_flow and each.code == "flow.outlier"]
    drawn = identification_figures.channel_figure(trace, curve, ratios[0] if ratios else None, outliers)
    heading = f"<h3><code>{html.escape(trace.name)}</code>{held}</h3>\n"
    return heading + picture(drawn, f"channel{place}", caption)


def _channel_caption(trace: Trace) -> str:
    text = "Points: measured; line: model." if trace.model.size else "Points: measured."
    if trace.low.size and not trace.samples.size:
        text += " Band: 95 %."
    if trace.residual.size > 1:
        text += f" Below: model minus measurement; {_residual_bands(trace)}"
    if trace.residual.size >= identification_figures.FEWEST:
        text += " The curve beside it is the normal distribution of that width."
        if trace.is_timed:
            text += " White residuals have 95 % of their autocorrelations within its band."
    return text


def _residual_bands(trace: Trace) -> str:
    unit = identification_figures.residual_unit(trace)

    def size(value: float) -> str:
        return with_unit(f"{scaled(value, trace.unit, unit):.3g}", unit)

    if trace.samples.size:
        own, share = np.max(trace.high - trace.model), np.mean(np.abs(trace.residual) <= trace.samples)
        return (
            "the grey band holds 95 % of the samples if the model is right, "
            f"± {size(float(np.max(trace.samples)))} at most, and {100.0 * share:.1f} % lie in it; "
            f"the coloured one 95 % of the model, ± {size(float(own))} at most."
        )
    sigma, origin = identification_figures.spread(trace)
    basis = "twice the noise" if origin == "noise" else "twice the rms of the residuals"
    return f"the grey band is {basis}, ± {size(2.0 * sigma)}."


def _sources(result: Result) -> str:
    own = result.conditions.get("sources", ())
    given = [f"{name}: {text}" for name, text in own.items()] if isinstance(own, Mapping) else own
    tests = {"flow": ("aicc",), "muscle": (), "friction": ()}.get(result.method, ("runs", "aicc"))
    books = [_said(f"reference.{name}") for name in (*_REFERENCES.get(result.method, ()), *tests)]
    rows = [str(each) for each in ([given] if isinstance(given, str) else given)]
    return "<ul>\n" + "".join(f"<li>{html.escape(text)}</li>\n" for text in (*rows, *books)) + "</ul>\n"


def _said(code: str, **facts: float | str) -> str:
    """Words of the page."""
    return sentence(f"identification.{code}", facts)


def _paragraph(text: str) -> str:
    return f"<p>{text}</p>\n" if text else ""
