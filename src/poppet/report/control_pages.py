"""Pages of tuned gains and of compared controllers, and the tables that terminals show too."""

from __future__ import annotations

import html
import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from poppet.control.comparison import Comparison
from poppet.control.loop import SampledPlant, step_response
from poppet.control.metrics import read_in, readable
from poppet.control.tuning import TunedPoint, Tuning
from poppet.core.number_format import scaled
from poppet.parts.quantities import OPENING, QUANTITIES
from poppet.report.control_figures import MARKS, response_figure, spread_figure, spread_words
from poppet.report.html_page import document, findings, head, picture, write_page
from poppet.report.tables import Column, Table
from poppet.timeseries.plotting.figures import GREY, PALETTE, axes_in, new_figure, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from poppet.circuit.circuit import Circuit

_STYLE = "pre { overflow-x: auto; background: var(--wash); padding: .6rem .9rem; }\n"
_MOST_SAMPLES = 2000
"""Samples of a step that are drawn."""


# --- Tuning ---


def margin_table(tuning: Tuning) -> Table:
    """How far each tuned loop is from trouble."""
    heads = ("Ms", "Mt", "gain margin", "phase margin [deg]", "delay margin [s]", "crossover [Hz]")
    rows = tuple(
        (name, m.sensitivity, m.complementary, m.gain_margin, m.phase_margin, m.delay_margin, m.crossover)
        for point in tuning.points
        for name, m in point.margins.items()
    )
    return Table("margins", "", (Column("at"), *(Column(text, ".4g") for text in heads)), rows)


def verification_table(tuning: Tuning) -> Table:
    """What the tuned loops do in a step there and back of the plant as it is."""
    unit = readable(QUANTITIES[tuning.quantity].unit)
    heads = f"step [{unit}]", "overshoot [%]", "settling [s]", "swing in the end [%]"
    rows = tuple(
        (
            run.at,
            scaled(run.step, QUANTITIES[tuning.quantity].unit, unit),
            run.overshoot,
            f"{run.settling_time:.3g}" if math.isfinite(run.settling_time) else "never",
            100.0 * run.swing,
        )
        for point in tuning.points
        for run in point.verified
    )
    return Table("steps", "", (Column("step there and back at"), *(Column(text, ".3g") for text in heads)), rows)


def write_tuning(tuning: Tuning, circuit: Circuit, path: str | Path) -> Path:
    """Write tuned gains as one page: gains, margins, sensitivities over the frequency, small steps."""
    return write_page(path, lambda: tuning_page(tuning, circuit))


def tuning_page(tuning: Tuning, circuit: Circuit) -> str:
    """The page as text."""
    title = f"{circuit.title or 'A circuit'}: gains of {tuning.controller}"
    gains = f"<pre>{html.escape(tuning.text())}</pre>\n"
    right = (
        "the plant as it is, in a step there and back of the size that makes the proportional part ask for the sine"
        if tuning.is_verified
        else "the linear loop after a small step of the setpoint, without limits and dead zones of the valves"
    )
    caption = (
        "Left: sensitivity |S| = |1/(1 + L)| of the tuned loops, whose greatest value is Ms, and its bound. "
        f"Right: {right}."
    )
    with style("A report of a tuning"):
        drawn = picture(loop_figure(tuning), "loops", caption)
    sections = [
        ("", head(title, f"Form {tuning.form}. Bounded: {tuning.bounded}, {tuning.held}.") + findings(tuning.notes)),
        ("Gains", gains),
        ("Loops", drawn),
        ("Margins", margin_table(tuning).html()),
    ]
    if tuning.is_verified:
        sections.append(("Steps", verification_table(tuning).html()))
    return document(title, sections, style=_STYLE)


def loop_figure(tuning: Tuning) -> Figure:
    """Sensitivity over the frequency, and the response to a step, of every plant that was bounded."""
    figure = new_figure(10.0, 3.9)
    left, right = (axes_in(figure, edge, 0.75, 4.0, 2.5) for edge in (0.75, 5.75))
    left.axhline(tuning.sensitivity, color=GREY, linewidth=0.9, linestyle=(0, (2, 2)), label="bound")
    colours = iter(PALETTE * 4)
    for point in tuning.points:
        runs = {run.at: run for run in point.verified}
        for name, plant in point.plants.items():
            look = {"color": next(colours), "linewidth": 1.2, "label": name}
            z = plant.at(plant.frequencies)
            loop = point.gains.response(z, plant.sample_time) * plant.response(z)
            left.semilogx(plant.frequencies[::8], np.abs(1.0 / (1.0 + loop))[::8], **look)
            if isinstance(plant, SampledPlant):
                step = _step(plant, point)
                right.plot(plant.sample_time * np.arange(step.size), step, **look)
            elif name in runs:
                run = runs[name]
                right.plot(run.time - run.time[0], (run.measured - run.setpoint[0]) / run.step, **look)
    left.set_xlabel("frequency [Hz]")
    left.set_ylabel("sensitivity [1]")
    right.axhline(1.0, color=GREY, linewidth=0.8)
    right.set_xlabel("time [s]")
    right.set_ylabel("measurement per step [1]")
    handles, labels = left.get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper left", bbox_to_anchor=(0.07, 0.99), ncols=4, fontsize=7.5)
    return figure


def _step(plant: SampledPlant, point: TunedPoint) -> np.ndarray:
    crossover = max(each.crossover for each in point.margins.values())
    length = max(point.gains.integral_time, 1.0 / (2.0 * np.pi * max(crossover, 1e-9)))
    samples = min(_MOST_SAMPLES, int(12.0 * length / plant.sample_time))
    return step_response(plant, point.gains, point.setpoint_weight, max(samples, 2))


# --- Comparison ---


def figure_table(comparison: Comparison) -> Table:
    """Figures of every controller: nominal, and where numbers are uncertain median and worst."""
    kinds = comparison.kinds
    units = {key: read_in(figure, *comparison.units) for key, figure in kinds.items()}
    heads = [key.replace("_", " ") + (f" [{unit}]" if unit != "1" else "") for key, unit in units.items()]
    rows = []
    # Without draws the other two would say the same.
    plants = ("nominal", "median", "worst") if comparison.draws else ("nominal",)
    for name, own in comparison.summary().items():
        for k, kind in enumerate(plants):
            figures = (scaled(own[key][k], kinds[key].unit, unit) for key, unit in units.items())
            cells = ("never" if figure == math.inf else f"{figure:.4g}" for figure in figures)
            rows.append((name if k == 0 else "", kind, *cells))
    columns = Column("controller"), Column("plant"), *(Column(text, ".4g") for text in heads)
    return Table("figures", "", columns, tuple(rows))


def write_comparison(comparison: Comparison, path: str | Path, *, title: str = "Controllers on one plant") -> Path:
    """Write a comparison as one page: figures, responses, spread."""
    return write_page(path, lambda: comparison_page(comparison, title))


def comparison_page(comparison: Comparison, title: str) -> str:
    """The page as text."""
    failed = [f"{name}: {n} runs did not reach their end." for name, n in comparison.failed.items() if n]
    lost = "".join(f"<p><strong>{html.escape(text)}</strong></p>\n" for text in failed)
    fills = ", positive where it fills" if comparison.command_quantity == OPENING else ""
    above = f"Above: the nominal response, with the range of the draws; below: the command{fills}."
    with style("A report of a comparison"):
        sections = [
            ("", head(title, spread_words(comparison)) + lost),
            ("Figures", figure_table(comparison).html()),
            ("Responses", picture(response_figure(comparison), "responses", above)),
            ("Spread", picture(spread_figure(comparison), "spread", MARKS, is_still=True)),
        ]
    return document(title, sections, style=_STYLE)
