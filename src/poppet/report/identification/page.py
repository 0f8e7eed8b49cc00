"""The page of an identification: verdict, numbers with intervals, fit, residuals, comparison, conditions, sources."""

from __future__ import annotations

import html
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from poppet.ground.readable import number, readable_unit, scaled, with_unit
from poppet.identify import Estimate, Result
from poppet.identify.fit.statistics import DETERMINED, WEAK
from poppet.identify.result import VERDICTS
from poppet.report.identification.figures import (
    FEWEST,
    VERDICT_COLOURS,
    channel_figure,
    correlation_figure,
    flow_curve,
    interval_figure,
    interval_range,
    residual_unit,
    spread,
)
from poppet.report.identification.series import Trace, traces_of
from poppet.report.identification.tables import (
    budget_table,
    comparison_table,
    condition_table,
    correlation_sentence,
    estimate_text,
    parameter_table,
    residual_table,
    standard_table,
    statistics_table,
    stroke_table,
    verdict_word,
)
from poppet.report.page import document, findings, head, picture, write_page
from poppet.series.drawing.figures import style

_PALE = {"determined": "#e3f3e8", "weak": "#fdf0d9", "not determined": "#fbe4e1", "at bound": "#f1e6f6"}
_STYLE = """
.summary { border: 1px solid var(--line); border-left: .4rem solid; border-radius: .4rem; background: var(--wash);
  padding: .7rem 1.1rem; margin: 1.2rem 0 1.6rem; }
.summary > p:first-child { font-size: 1.15rem; font-weight: 600; margin: .1rem 0 .5rem; }
.summary table { margin: 0; } .summary td { border: 0; padding: .15rem 1.2rem .15rem 0; }
code { font: .92em/1.4 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
""" + "".join(
    f".verdict.{v.replace(' ', '-')} {{ background: {_PALE[v]}; color: {VERDICT_COLOURS[v]}; }}\n"
    f".summary.{v.replace(' ', '-')} {{ border-left-color: {VERDICT_COLOURS[v]}; }}\n"
    for v in VERDICTS
)
_METHODS = {
    "fit": "Numbers of a circuit fitted to recordings by weighted least squares on the integrated equations.",
    "tank": "Charge or discharge of a tank: flow characteristics from the pressure history, by fitting the "
    "integrated equations.",
    "flow": "Steady flow bench: flow characteristics from points of mass flow rate and pressures, by weighted least "
    "squares.",
    "characteristic": "Flow characteristics over the stroke from tests at known strokes.",
}
_SOURCES = {
    "fit": (),
    "tank": ("ISO 6358-2: Pneumatic fluid power, flow-rate characteristics, alternative test methods.",),
    "flow": (
        "ISO 6358-1: Pneumatic fluid power, flow-rate characteristics, general rules and test methods for steady flow.",
        "JCGM 100:2008, Guide to the expression of uncertainty in measurement (GUM).",
    ),
    "characteristic": (
        "Z. Varga, P. Keski-Honkola: Mathematical model of pneumatic proportional valve, 2012 (form of the "
        "polynomials).",
    ),
}
_STATISTICS = (
    "Runs test: Wald and Wolfowitz 1940, On a test whether two samples are from the same population, Annals of "
    "Mathematical Statistics 11, 147-162.",
    "AICc: Hurvich and Tsai 1989, Regression and time series model selection in small samples, Biometrika 76, 297-307.",
)
_NOTHING_FOUND = "<p>The checks on bounds, identifiability and residuals have nothing to object.</p>\n"
_WORST_FIRST = ("not determined", "at bound", "weak", "determined")


def write_identification(result: Result, path: str | Path) -> Path:
    """Write an identification as one page that needs nothing else.

    Notes
    -----
    The same result gives the same bytes.
    """
    return write_page(path, lambda: identification_page(result))


def identification_page(result: Result) -> str:
    """The page as text."""
    with style("A report of an identification"):
        order = slice(None, None, -1 if result.method == "characteristic" else 1)
        fit = "".join(_channel(result, trace, k) for k, trace in enumerate(traces_of(result)))
        sections = [
            ("", _head(result)),
            ("Findings", findings(result.findings, "ol") or _NOTHING_FOUND),
            *[("Numbers", _numbers(result)), ("Fit", fit)][order],
            ("Residuals", residual_table(result) + _RESIDUAL_WORDS if result.residuals else ""),
            ("Comparison", _comparison(result)),
            ("Tests of the fit", statistics_table(result)),
            ("Tests at the strokes", stroke_table(result) if result.conditions.get("tests") else ""),
            ("Formulas of the standard", _standard(result)),
            ("Uncertainty budget", budget_table(result) if result.comparison.get("uncertainty") else ""),
            ("Conditions", condition_table(result)),
            ("How to read this page", _EXPLAINED + _INTERVALS.get(result.method, "")),
            ("Sources", _listed(_sources(result))),
        ]
    return document(result.title, sections, style=_STYLE)


def headline(result: Result) -> str:
    """The verdict of all numbers in one sentence.

    Examples
    --------
    >>> good = Estimate(1.0, "s", 0.01, 0.98, 1.02, "determined")
    >>> poor = Estimate(1.0, "s", 9.0, 0.0, 19.0, "not determined")
    >>> headline(Result("fit", "test", {"a": good, "b": poor}))
    'Of 2 numbers 1 is determined, 1 is not.'
    >>> headline(Result("fit", "test", {"a": good}))
    'The one number sought is determined.'
    """
    verdicts = [e.verdict for e in result.parameters.values()]
    total = len(verdicts)
    if not total:
        return "No number was sought."
    counts = {verdict: verdicts.count(verdict) for verdict in VERDICTS if verdict in verdicts}
    words = {"weak": "weakly determined", "not determined": "not determined", "at bound": "at a bound"}
    if len(counts) == 1:
        (verdict,) = counts
        if verdict == "not determined" and total > 1:
            return f"None of the {total} numbers is determined."
        who = "The one number sought is" if total == 1 else f"All {total} numbers are"
        return f"{who} {words.get(verdict, verdict)}."
    texts = [
        f"{count} {'is' if count == 1 else 'are'} {words.get(verdict, verdict)}" for verdict, count in counts.items()
    ]
    if list(counts) == ["determined", "not determined"]:
        texts[1] = texts[1].removesuffix(" determined")
    return f"Of {total} numbers {', '.join(texts)}."


def _head(result: Result) -> str:
    worst = next((v for v in _WORST_FIRST if any(e.verdict == v for e in result.parameters.values())), "determined")
    rows = "".join(
        f"<tr><td>{verdict_word(e.verdict)}</td><td><code>{html.escape(name)}</code></td>"
        f"<td>{html.escape(estimate_text(e))}</td></tr>\n"
        for name, e in sorted(result.parameters.items(), key=lambda item: _WORST_FIRST.index(item[1].verdict))
    )
    bands = "".join(f"<p>{html.escape(_band_width(trace))}</p>\n" for trace in traces_of(result) if trace.low.size)
    table = f'<div class="scroll"><table><tbody>\n{rows}</tbody></table></div>\n' if rows and not bands else ""
    summary = f'<div class="summary {worst.replace(" ", "-")}"><p>{html.escape(headline(result))}</p>\n'
    return head(result.title, _METHODS.get(result.method, result.method)) + f"{summary}{bands}{table}</div>\n"


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
    text = parameter_table(result.parameters)
    text += picture(interval_figure(result.parameters), "intervals", _interval_caption(result))
    if len(result.correlation) > 2:
        caption = "Correlation of the estimates; beyond 0.9 in bold: two numbers that the data hardly tell apart."
        return text + picture(correlation_figure(result.correlation), "correlation", caption, kind="narrow")
    sentence = correlation_sentence(result.correlation)
    return text + (f"<p>{html.escape(sentence)}</p>\n" if sentence else "")


def _interval_caption(result: Result) -> str:
    text = "Bar: 95 % interval; line: value; ring: start. Every axis begins at zero, so that a short bar is a small "
    text += "relative uncertainty."
    out = [f"{name} {_start(e)}" for name, e in result.parameters.items() if _starts_outside(e)]
    return f"{text} Starts outside: {', '.join(out)}." if out else text


def _starts_outside(e: Estimate) -> bool:
    low, high = interval_range(e)
    return math.isfinite(e.start) and not low <= e.start <= high


def _start(e: Estimate) -> str:
    unit = readable_unit(e.unit, e.start)
    return with_unit(number(scaled(e.start, e.unit, unit)), unit)


def _channel(result: Result, trace: Trace, place: int) -> str:
    is_flow = trace.name.endswith("effective_conductance")
    curve = flow_curve(result, trace) if is_flow else None
    ratios = [e for name, e in result.parameters.items() if is_flow and name.rpartition(".")[2] == "critical_ratio"]
    held = ", held out of the fit" if trace.name.partition(".")[0] in result.conditions.get("validation", ()) else ""
    caption = _channel_caption(trace) + (_FLOW_CAPTION if is_flow else "")
    heading = f"<h3><code>{html.escape(trace.name)}</code>{held}</h3>\n"
    return heading + picture(channel_figure(trace, curve, *ratios[:1]), f"channel{place}", caption)


def _channel_caption(trace: Trace) -> str:
    text = "Points: measured; line: model." if trace.model.size else "Points: measured."
    if trace.low.size:
        text += " Band: 95 %."
    if trace.residual.size > 1:
        sigma, origin = spread(trace)
        unit = residual_unit(trace)
        size = with_unit(f"{scaled(2.0 * sigma, trace.unit, unit):.3g}", unit)
        basis = "twice the noise" if origin == "noise" else "twice the rms of the residuals"
        text += f" Below: model minus measurement; the grey band is {basis}, ± {size}."
    if trace.residual.size >= FEWEST:
        text += " The curve beside it is the normal distribution of that width."
        if trace.is_timed:
            text += " White residuals have 95 % of their autocorrelations within its band."
    return text


def _comparison(result: Result) -> str:
    if "other" not in result.comparison:
        return ""
    verdict = html.escape(str(result.comparison.get("verdict", "")))
    return f"<p><strong>{verdict}</strong></p>\n{comparison_table(result)}"


def _standard(result: Result) -> str:
    if not result.comparison.get("standard_formulas"):
        return ""
    return f"{standard_table(result)}<p>The errors are standard uncertainties.</p>\n"


_RESIDUAL_WORDS = (
    "<p>rms and bias are of model minus measurement; NRMSE is the rms over the range, largest minus smallest, of the "
    "measurement.</p>\n"
)


_FLOW_CAPTION = (
    " The effective conductance is the mass flow rate over the upstream pressure, so that points of all upstream "
    "pressures share one curve; shaded: 95 % interval of the critical ratio, choked to its left."
)
_EXPLAINED = (
    f"<p>A number is <em>determined</em> when half its 95 % interval is at most {100 * DETERMINED:.0f} % of it (of its "
    f"whole range, for a ratio), <em>weak</em> up to {100 * WEAK:.0f} %, and <em>not determined</em> beyond: the data "
    "would fit about as well with quite another value. <em>At bound</em> means that the search ended on a limit, "
    "physical or given, and the value says more about the limit than about the part.</p>\n"
)
_WIDENED = (
    "<p>Intervals follow from the slopes of the model at the best fit; where residuals exceed the noise or follow each "
    "other they are widened by as much.</p>\n"
)
_INTERVALS = {
    "fit": _WIDENED,
    "tank": _WIDENED,
    "characteristic": "<p>The numbers of a curve are strongly correlated, those of a polynomial most of all: the band "
    "says how well the curve is known, the verdicts on its numbers do not. The result file has all their digits.</p>\n",
    "flow": "<p>Intervals contain the scatter and the errors that all points share, as far as these were stated; "
    "scatter that was not stated is estimated from the residuals and widens them by Student's t.</p>\n",
}


def _sources(result: Result) -> list[str]:
    own = result.conditions.get("sources", ())
    given = [f"{k}: {v}" for k, v in own.items()] if hasattr(own, "items") else [str(s) for s in _as_list(own)]
    statistics = _STATISTICS if result.method != "flow" else _STATISTICS[1:]
    return [*given, *_SOURCES.get(result.method, ()), *statistics]


def _as_list(own: str | Sequence[str]) -> Sequence[str]:
    return [own] if isinstance(own, str) else own


def _listed(texts: Sequence[str]) -> str:
    return "<ul>\n" + "".join(f"<li>{html.escape(text)}</li>\n" for text in texts) + "</ul>\n" if texts else ""
