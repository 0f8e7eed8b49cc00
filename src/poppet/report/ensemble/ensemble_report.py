"""An ensemble as one page that needs nothing else: yield, curves, metrics, what matters, worst cases."""

from __future__ import annotations

import html
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from poppet.ensemble import Ensemble
from poppet.ensemble.ensemble_plan import varied_specs
from poppet.report.ensemble import ensemble_figures
from poppet.report.ensemble.ensemble_tables import in_usual, metric_table, usual, worst_table, yield_table
from poppet.report.html_page import document, findings, head, picture, table, write_page
from poppet.timeseries.plotting.figures import style

_WAYS = {
    "random": "independent draws",
    "latin": "a Latin hypercube",
    "sobol": "a scrambled Sobol sequence",
    "grid": "a grid",
    "file": "numbers of a file",
}
_EVEN = (
    "The interval, of 95 %, is Wilson's for independent draws; these points spread more evenly than such draws do, so "
    "that it is wider than it need be."
)
_PLAIN = "The interval, of 95 %, is Wilson's."


def write_ensemble(found: Ensemble, path: str | Path) -> Path:
    """Write an ensemble as one page; the same dataset gives the same bytes."""
    return write_page(path, lambda: ensemble_page(found))


def ensemble_page(found: Ensemble) -> str:
    """The page as text."""
    plan = found.plan
    units = {address: spec.unit for address, spec in varied_specs(plan.circuit).items()}
    rows = found.dataset.columns("runs", most=ensemble_figures.MOST_POINTS * 40)
    few = {name: values[: ensemble_figures.MOST_POINTS] for name, values in rows.items()}
    title = plan.circuit.title or "An ensemble"
    draws = f"{found.done} runs, {len(plan.addresses)} uncertain numbers, {_WAYS[plan.sampling]}, seed {plan.seed}."
    with style("A report of an ensemble"):
        sections = [
            ("", head(title, draws) + findings(found.remarks())),
            ("Yield", _yield(found)),
            ("Curves", _curves(found)),
            ("Metrics", _metrics(found, rows)),
            ("What matters", _influence(found)),
            ("Runs", _scatter(found, few, units)),
            ("Worst cases", _worst(found, units)),
            ("Numbers", _numbers(found, units)),
        ]
    return document(title, sections)


def _yield(found: Ensemble) -> str:
    yields = found.yields()
    if not yields:
        return ""
    even = found.plan.sampling in ("latin", "sobol")
    words = f"Bars: share of the runs that meet a requirement; line: its interval. {_EVEN if even else _PLAIN}"
    if found.plan.sampling in ("grid", "file"):
        words = "Share of the runs that meet a requirement. The points are chosen, not drawn: the interval says little."
    return picture(ensemble_figures.yield_figure(yields), "yield", words, is_still=True) + yield_table(found).html()


def _curves(found: Ensemble) -> str:
    bands = found.bands()
    outputs = dict(found.plan.circuit.model.outputs)
    text = ""
    for k, curve in enumerate(bands.curves if bands is not None else ()):
        assert bands is not None
        words = f"{curve}: at each time half, 90 % and 98 % of the runs lie within the bands; no run need follow one."
        text += picture(ensemble_figures.bands_figure(bands, outputs, curve), f"bands-{k}", words)
    return text


def _metrics(found: Ensemble, rows: Mapping[str, Any]) -> str:
    if not found.plan.metrics:
        return ""
    lost = "never: runs in which what is asked for does not happen; no value: it failed, or the metric is not defined."
    words = "How metrics are spread; broken lines: bounds of requirements."
    drawn = picture(ensemble_figures.histogram_figure(found, rows), "metrics", words, is_still=True)
    return drawn + metric_table(found).html() + f'<p class="lead">{lost}</p>\n'


def _influence(found: Ensemble) -> str:
    indices = found.indices()
    text = ""
    for k, metric in enumerate(found.plan.metrics):
        ranges = found.tornado().get(metric.name, [])
        if not any(0.0 < each.size < float("inf") for each in ranges):
            continue
        own = indices.get(metric.name)
        words = "Each number at its 5 % (teal) and 95 % quantile (amber), the others at their medians."
        if own:
            words += " Right: part of the variance that it makes by itself (first) and with others (total), 95 %."
        drawn = ensemble_figures.tornado_figure(metric, ranges, own)
        text += f"<h3>{html.escape(metric.name)}</h3>\n" + picture(drawn, f"tornado-{k}", words, is_still=True)
    return text


def _scatter(found: Ensemble, few: Mapping[str, Any], units: Mapping[str, str]) -> str:
    if not found.plan.metrics:
        return ""
    words = "Each metric over the number that moves it most; orange: runs that miss a requirement"
    words += f", the first {len(few['run'])} runs." if found.done > len(few["run"]) else "."
    return picture(ensemble_figures.scatter_figure(found, few, units), "scatter", words, is_still=True)


def _worst(found: Ensemble, units: dict[str, str]) -> str:
    if not found.plan.requirements:
        return ""
    words = "The runs with the smallest margins. <code>poppet ensemble FILE --worst FOLDER</code> writes them as files."
    return f"<p>{words}</p>\n" + worst_table(found, units).html()


def _numbers(found: Ensemble, units: Mapping[str, str]) -> str:
    """What was uncertain, and how."""
    plan, rows = found.plan, []
    for address in plan.addresses:
        own = plan.alone.get(address)
        kind = own.kind if own else "of the file" if plan.table else "joint normal, of the fit"
        ends = (f"{in_usual(plan.quantile(address, u), units[address]):.4g}" for u in (0.05, 0.5, 0.95))
        rows.append([f"<code>{html.escape(address)}</code>", kind, *ends, html.escape(usual(units[address]))])
    return table(["number", "distribution", "5 %", "median", "95 %", "unit"], rows, numbers=(2, 3, 4))
