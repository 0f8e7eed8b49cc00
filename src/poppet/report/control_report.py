"""Reports of controller tuning and of controller comparisons, with tables for the terminal."""

from __future__ import annotations

import html
import math
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.control.comparison import Comparison
from poppet.control.metrics import readable_metric_unit, readable_unit_of
from poppet.control.tuning import Tuning
from poppet.core.number_format import scaled
from poppet.parts.quantities import OPENING, QUANTITIES
from poppet.report.control_figures import MARKERS, loop_figure, response_figure, sample_sentence, spread_figure
from poppet.report.html_page import Section, document, findings, head, paragraph, picture, write_page
from poppet.report.tables import ReportTable, numeric
from poppet.timeseries.plotting.figures import style

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

_STYLE = "pre { overflow-x: auto; background: var(--wash); padding: .6rem .9rem; }\n"


def margin_table(tuning: Tuning) -> ReportTable:
    """Return the robustness margins of every tuned control loop."""
    rows = [
        (name, m.sensitivity, m.complementary, m.gain_margin, m.phase_margin, m.delay_margin, m.crossover)
        for point in tuning.points
        for name, m in point.margins.items()
    ]
    headings = "Ms", "Mt", "gain margin", "phase margin [deg]", "delay margin [s]", "crossover [Hz]"
    return ReportTable(("at", *numeric(*headings, digits=".4g")), rows)


def verification_table(tuning: Tuning) -> ReportTable:
    """Return metrics of the nonlinear plant's response to a step up and back."""
    si_unit = QUANTITIES[tuning.quantity].unit
    unit = readable_unit_of(si_unit)
    rows = [
        (
            run.at,
            scaled(run.step, si_unit, unit),
            run.overshoot,
            f"{run.settling_time:.3g}" if math.isfinite(run.settling_time) else "never",
            100.0 * run.swing,
        )
        for point in tuning.points
        for run in point.verified
    ]
    headings = f"step [{unit}]", "overshoot [%]", "settling [s]", "swing in the end [%]"
    return ReportTable(("step there and back at", *numeric(*headings, digits=".3g")), rows)


def write_tuning(tuning: Tuning, circuit: BaseCircuit, path: str | Path) -> Path:
    """Write the report of a controller tuning as a self-contained HTML page."""
    return write_page(path, lambda: tuning_page(tuning, circuit))


def tuning_page(tuning: Tuning, circuit: BaseCircuit) -> str:
    """Return the report of a controller tuning as HTML: gains, sensitivities, steps and margins."""
    title = f"{circuit.title or 'A circuit'}: gains of {tuning.controller}"
    step = (
        "step up and back of the nonlinear plant; its size makes the proportional part equal to the sine"
        if tuning.is_verified
        else "small setpoint step of the linear loop, without limits and dead zones of the valves"
    )
    caption = f"Left: sensitivity |S| = |1/(1 + L)| of the tuned loops, its maximum Ms and its bound. Right: {step}."
    lead = f"Form {tuning.form}. Bounded: {tuning.bounded}, {tuning.held}."
    with style("A report of a tuning"):
        sections = [
            Section("", head(title, lead) + findings(tuning.notes)),
            Section("Gains", f"<pre>{html.escape(tuning.text())}</pre>\n"),
            Section("Loops", picture(loop_figure(tuning), "loops", caption)),
            Section("Margins", margin_table(tuning)),
            Section("Steps", verification_table(tuning) if tuning.is_verified else ""),
        ]
    return document(title, sections, style=_STYLE)


def figure_table(comparison: Comparison) -> ReportTable:
    """Return the metrics of every controller on the nominal plant.

    If the plant was sampled, the median and the worst value of all samples follow.
    """
    kinds = comparison.kinds
    units = {key: readable_metric_unit(kind, *comparison.units) for key, kind in kinds.items()}
    headings = [key.replace("_", " ") + (f" [{unit}]" if unit != "1" else "") for key, unit in units.items()]
    rows = []
    plants = ("nominal", "median", "worst") if comparison.draws else ("nominal",)
    for name, summary in comparison.summary().items():
        for k, plant in enumerate(plants):
            metrics = (scaled(summary[key][k], kinds[key].unit, unit) for key, unit in units.items())
            cells = ("never" if metric == math.inf else f"{metric:.4g}" for metric in metrics)
            rows.append((name if k == 0 else "", plant, *cells))
    return ReportTable(("controller", "plant", *numeric(*headings)), rows)


def write_comparison(comparison: Comparison, path: str | Path, *, title: str = "Controllers on one plant") -> Path:
    """Write the report of a controller comparison as a self-contained HTML page."""
    return write_page(path, lambda: comparison_page(comparison, title))


def comparison_page(comparison: Comparison, title: str) -> str:
    """Return the report of a controller comparison as HTML: metrics and responses with their spread."""
    failures = [f"{name}: {n} runs did not reach their end." for name, n in comparison.failed.items() if n]
    warnings = "".join(paragraph(text, bold=True) for text in failures)
    sign = "; positive values fill" if comparison.command_quantity == OPENING else ""
    caption = f"Upper axes: nominal response and range of the samples; lower axes: command{sign}."
    with style("A report of a comparison"):
        sections = [
            Section("", head(title, sample_sentence(comparison)) + warnings),
            Section("Metrics", figure_table(comparison)),
            Section("Responses", picture(response_figure(comparison), "responses", caption)),
            Section("Spread", picture(spread_figure(comparison), "spread", MARKERS, is_still=True)),
        ]
    return document(title, sections, style=_STYLE)
