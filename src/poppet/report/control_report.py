"""Reports of controller tuning and of controller comparisons, with their figures and with tables for the terminal."""

from __future__ import annotations

import html
import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.control.comparison import Comparison
from poppet.control.loop import Margins
from poppet.control.loop_figures import bode_figure, disturbance_courses, step_courses, step_figure
from poppet.control.metrics import readable_metric_unit, readable_unit_of
from poppet.control.tuning import Tuning
from poppet.core.number_format import pretty, scaled
from poppet.core.units import convert
from poppet.parts.quantities import OPENING, QUANTITIES
from poppet.report.html_page import Section, document, findings, head, paragraph, picture, write_page
from poppet.report.tables import ReportTable, numeric
from poppet.timeseries.plotting.figures import (
    ACCENT,
    GREY,
    INK,
    PALETTE,
    axes_in,
    new_figure,
    save_figure,
    style,
    widest,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from poppet.circuit.circuit import BaseCircuit

_SPREAD_METRICS = ("ITAE", "settling_time", "overshoot", "travel")
MARKERS = "Dots: samples; bar: median; ring: nominal."
_LEFT, _WIDTH, _GAP, _TOP = 0.75, 3.1, 0.3, 0.62
_UPPER, _LOWER, _STRIP = 1.9, 0.9, 1.3
_SMALL_OPENING = 0.3
"""Maximum opening for an axis that is scaled to the openings."""
_STYLE = "pre { overflow-x: auto; background: var(--wash); padding: .6rem .9rem; }\n"


def margin_table(tuning: Tuning) -> ReportTable:
    """Return a table of the robustness margins of all tuned control loops.

    The last column is the lower gain margin; it is omitted if no loop has one.
    """
    return _loop_table([loop for point in tuning.points for loop in point.margins.items()])


def file_margin_table(tuning: Tuning, circuit: BaseCircuit) -> ReportTable | None:
    """Return a table of the margins of the same loops with the gains of the circuit.

    It is None if there are none. An unstable loop has no margins.
    """
    loops = tuning.margins_of(circuit)
    stable = _loop_table([loop for loop in loops.items() if loop[1].is_stable])
    missing = (None,) * (len(stable.columns) - 1)
    unstable = [(f"{name}: unstable", *missing) for name, m in loops.items() if not m.is_stable]
    return ReportTable(stable.columns, [*stable.rows, *unstable]) if loops else None


def _loop_table(loops: Sequence[tuple[str, Margins]]) -> ReportTable:
    rows: list[tuple[Any, ...]] = [
        (name, m.sensitivity, m.complementary, m.gain_margin, m.phase_margin, m.delay_margin, m.crossover)
        for name, m in loops
    ]
    headings = ["Ms", "Mt", "gain margin", "phase margin [deg]", "delay margin [s]", "crossover [Hz]"]
    if any(m.lower_gain_margin > 0.0 for _, m in loops):
        headings.append("lower gain margin")
        rows = [(*row, m.lower_gain_margin or None) for row, (_, m) in zip(rows, loops, strict=True)]
    return ReportTable(("at", *numeric(*headings, digits=".4g")), rows)


def verification_table(tuning: Tuning) -> ReportTable:
    """Return a table of simulated responses to a setpoint step and the reverse step.

    It contains step size, overshoot, settling time and remaining oscillation for each verification of the tuning. The
    simulation uses the nonlinear plant.
    """
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


def step_table(tuning: Tuning) -> ReportTable:
    """Return a table of overshoot and settling time of all linear loops, after setpoint and disturbance steps."""
    rows = [
        (
            setpoint.name,
            max(0.0, 100.0 * (float(setpoint.values[setpoint.peak]) - 1.0)),
            *(f"{c.settling_time:.3g}" if math.isfinite(c.settling_time) else "never" for c in (setpoint, disturbed)),
        )
        for setpoint, disturbed in zip(step_courses(tuning), disturbance_courses(tuning), strict=True)
    ]
    headings = "overshoot [%]", "settling [s]", "settling after a disturbance [s]"
    return ReportTable(("at", *numeric(*headings, digits=".2g")), rows)


def write_tuning(tuning: Tuning, circuit: BaseCircuit, path: str | Path, *, origin: str = "the circuit") -> Path:
    """Write the report of a controller tuning as a self-contained HTML page.

    The arguments are those of `tuning_page`.
    """
    return write_page(path, lambda: tuning_page(tuning, circuit, origin=origin))


def tuning_page(tuning: Tuning, circuit: BaseCircuit, *, origin: str = "the circuit") -> str:
    """Return the report of a controller tuning as HTML.

    It contains gains, Bode plots, margins and step responses, and the margins with the present gains of the circuit.
    `origin` is the origin of these gains, such as the name of a file.
    """
    title = f"{circuit.title or 'A circuit'}: gains of {tuning.controller}"
    bode = (
        "Bode plot of the open loops with sampling and delay. Circles: crossovers; squares: frequencies of the gain "
        "margins; lines: smallest margins. Below: sensitivity |S| = |1/(1 + L)| and its bound."
    )
    steps = (
        "Setpoint steps of the nonlinear plant. Their size makes the proportional part equal to the sine."
        if tuning.is_verified
        else "Small steps of the linear loops, without limits and dead zones of the valves. Above: setpoint; below: "
        "disturbance that is added to the command."
    )
    present, file_margins = tuning.gains_of(circuit), file_margin_table(tuning, circuit)
    bode += f" Thin dashed lines: present gains, those of {origin}." if present else ""
    lead = f"Form {tuning.form}. Bounded: {tuning.bound_text}, {tuning.command_text}."
    with style("A report of a tuning"):
        sections = [
            Section("", head(title, lead) + findings((*tuning.notes, *tuning.margin_notes(circuit)))),
            Section("Gains", f"<pre>{html.escape(tuning.text())}</pre>\n"),
            Section(
                "Margins",
                (
                    picture(bode_figure(tuning, present=present), "bode", bode),
                    margin_table(tuning),
                    *((paragraph(f"With the gains of {origin}:"), file_margins) if file_margins else ()),
                ),
            ),
            Section(
                "Steps",
                (
                    picture(step_figure(tuning), "steps", steps),
                    verification_table(tuning) if tuning.is_verified else step_table(tuning),
                ),
            ),
        ]
    return document(title, sections, style=_STYLE)


def figure_table(comparison: Comparison) -> ReportTable:
    """Return a table with the metrics of each controller on the nominal plant.

    If the plant parameters were varied, the table also contains the median and the worst value of all samples.
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
    """Return the report of a controller comparison as HTML.

    It contains metrics, and responses with their spread.
    """
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


def plot_comparison(comparison: Comparison, path: str | Path | None = None, *, title: str = "") -> Figure:
    """Draw responses, nominal commands and metrics of all controllers.

    The figure is saved if `path` is set.
    """
    with style("A picture of a comparison", path):
        width = _total_width(comparison)
        figure = new_figure(width, _TOP + _UPPER + 0.15 + _LOWER + 0.85 + _STRIP + 0.75)
        _draw_responses(figure, comparison)
        _draw_spreads(figure, comparison, _TOP + _UPPER + _LOWER + 1.15)
        height = figure.get_size_inches()[1]
        figure.text(_LEFT / width, 1.0 - 0.14 / height, title, va="top", weight="bold", fontsize=11)
        note = sample_sentence(comparison) + (f" {MARKERS}" if comparison.draws else "")
        if len(note) >= 150:
            comma = note.rfind(",", 0, len(note) // 2 + 10)
            note = f"{note[: comma + 1]}\n{note[comma + 2 :]}"
        figure.text(_LEFT / width, 0.12 / height, note, color=GREY, fontsize=7.5)
        return save_figure(figure, path)


def response_figure(comparison: Comparison) -> Figure:
    """Draw the response and the command of each controller on the nominal plant.

    A band shows the spread of the response over all samples of the plant.
    """
    figure = new_figure(_total_width(comparison), _TOP + _UPPER + 0.15 + _LOWER + 0.55)
    _draw_responses(figure, comparison)
    return figure


def spread_figure(comparison: Comparison) -> Figure:
    """Draw the metrics of each controller for all plant samples.

    Median and nominal value are marked.
    """
    figure = new_figure(_total_width(comparison), _STRIP + 1.0)
    _draw_spreads(figure, comparison, 0.45)
    return figure


def _total_width(comparison: Comparison) -> float:
    columns = max(len(comparison.responses), 2)
    return _LEFT + columns * _WIDTH + (columns - 1) * _GAP + 0.2


def _draw_responses(figure: Figure, comparison: Comparison) -> None:
    time, (unit, command_unit) = comparison.time, comparison.units
    shown_unit, shown_command_unit = map(readable_unit_of, comparison.units)
    setpoint = convert(comparison.setpoint, unit, shown_unit)
    is_opening = comparison.command_quantity == OPENING
    max_opening = max(float(np.nanmax(np.abs(command))) for command in comparison.commands.values())
    first: Any = None
    for k, name in enumerate(comparison.responses):
        left, colour = _LEFT + k * (_WIDTH + _GAP), PALETTE[k % len(PALETTE)]
        upper = axes_in(figure, left, _TOP, _WIDTH, _UPPER, sharey=first[0] if first else None)
        top = _TOP + _UPPER + 0.15
        lower = axes_in(figure, left, top, _WIDTH, _LOWER, sharex=upper, sharey=first[1] if first else None)
        upper.set_title(name, loc="left")
        rows = convert(comparison.responses[name], unit, shown_unit)
        complete = rows[~np.isnan(rows[:, -1])]
        if len(complete) > 1:
            label = f"range of {len(complete) - 1} samples"
            edges = complete.min(axis=0), complete.max(axis=0)
            upper.fill_between(time, *edges, color=colour, alpha=0.25, linewidth=0.0, label=label)
        upper.plot(time, rows[0], color=colour, label="nominal")
        upper.plot(time, setpoint, color=INK, linewidth=0.8, linestyle="--", label="setpoint", drawstyle="steps-post")
        upper.tick_params(labelbottom=False)
        commands = convert(comparison.commands[name], command_unit, shown_command_unit)
        lower.plot(time, commands, color=colour, linewidth=1.0, drawstyle="steps-post", label="command")
        if is_opening and max_opening > _SMALL_OPENING:
            lower.set_ylim(-1.1, 1.1)
        lower.set(xlabel="time [s]", xlim=(time[0], time[-1]))
        if first is not None:
            upper.tick_params(labelleft=False)
            lower.tick_params(labelleft=False)
            continue
        first = upper, lower
        reference = ", absolute" if comparison.quantity == "pressure" else ""
        upper.set_ylabel(f"{comparison.quantity.replace('_', ' ')}\n[{pretty(shown_unit)}{reference}]")
        command_label = f"{comparison.command_quantity.replace('_', ' ')}\n[{pretty(shown_command_unit)}]"
        lower.set_ylabel("opening\n(fill, -vent)" if is_opening else command_label)
        upper.legend(loc="best", fontsize=7.5)


def sample_sentence(comparison: Comparison) -> str:
    """Return a sentence on the random samples of the plant parameters in a comparison.

    It contains the number and the seed of the samples, and the ranges of the parameters.
    """
    if not comparison.draws:
        return "Nominal parameters only."
    ranges = ", ".join(f"{address} ±{100.0 * size:g} %" for address, size in comparison.ranges.items())
    return f"{comparison.draws} samples, seed {comparison.seed}: {ranges}."


def _draw_spreads(figure: Figure, comparison: Comparison, top: float) -> None:
    left = max(_LEFT, widest(list(comparison.responses), 8.5) + 0.25)
    width = (_total_width(comparison) - left - 0.2 - (len(_SPREAD_METRICS) - 1) * _GAP) / len(_SPREAD_METRICS)
    names = list(comparison.figures)
    for k, key in enumerate(_SPREAD_METRICS):
        axes = axes_in(figure, left + k * (width + _GAP), top, width, _STRIP)
        unit = readable_metric_unit(comparison.kinds[key], *comparison.units)
        factor, jitter = scaled(1.0, comparison.kinds[key].unit, unit), np.random.default_rng(0)
        for level, name in enumerate(names):
            values = factor * comparison.figures[name][key]
            samples = values[1:][np.isfinite(values[1:])]
            y, colour = len(names) - 1 - level, PALETTE[level % len(PALETTE)]
            offsets = jitter.uniform(-0.22, 0.22, len(samples))
            axes.plot(samples, y + offsets, ".", color=colour, markersize=3.0, alpha=0.6)
            if len(samples):
                axes.plot([np.median(samples)] * 2, [y - 0.34, y + 0.34], color=INK, linewidth=1.6)
            if np.isfinite(values[0]):
                axes.plot(values[0], y, "o", markersize=6.0, markerfacecolor="none", markeredgecolor=ACCENT)
            if n_failed := int(np.sum(~np.isfinite(values))):
                label = {"ha": "right", "va": "center", "fontsize": 7.0, "color": GREY}
                axes.text(1.0, y, f"{n_failed} not reached", transform=axes.get_yaxis_transform(), **label)
        axes.set_yticks(range(len(names)), list(reversed(names)) if k == 0 else [""] * len(names))
        axes.set_ylim(-0.6, len(names) - 0.4)
        axes.set_xlim(left=0.0)
        axes.set_title(key.replace("_", " ") + (f" [{pretty(unit)}]" if unit != "1" else ""), loc="left")
