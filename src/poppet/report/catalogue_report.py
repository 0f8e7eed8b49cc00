"""Text and HTML report of a search in the catalogue of components."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from poppet.core.message_format import sentence
from poppet.core.number_format import number, pretty, readable_unit, scaled, with_unit
from poppet.ensemble.catalogue_sizing import CatalogueSizing, CatalogueTrial
from poppet.report.ensemble_report import BAD, GOOD, WIDTH
from poppet.report.html_page import Section, document, findings, head, paragraph, picture, write_page
from poppet.report.tables import Column, ReportTable, numeric
from poppet.timeseries.plotting.figures import ACCENT, INK, axes_in, new_figure, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_LABELS = {"sonic_conductance": "C", "bore": "bore", "volume": "volume"}
_PANEL, _GAP = 2.0, 0.45


def catalogue_text(sizing: CatalogueSizing) -> str:
    """Return the result of a search as text for a terminal."""
    lines = [sizing.title] if sizing.title else []
    lines += [*_headlines(sizing), "", trial_table(sizing).text()]
    return "\n".join([*lines, *(f"- {remark}" for remark in sizing.remarks)])


def trial_table(sizing: CatalogueSizing) -> ReportTable:
    """Return a table of all components in ascending order: size, metrics, and whether all requirements are met."""
    unit = _unit(sizing)
    metrics = [with_brackets(name, metric_unit) for name, metric_unit in sizing.units.items()]
    rows = [
        (
            _name(trial),
            f"{scaled(trial.size, sizing.unit, unit):.4g}",
            *("never" if value == math.inf else f"{value:.4g}" for value in trial.metrics.values()),
            "yes" if trial.is_met else "no: " + ", ".join(name for name, m in trial.margins.items() if not m >= 0.0),
        )
        for trial in sizing.trials
    ]
    headings = numeric(with_brackets(_LABELS[sizing.measure], unit), *metrics)
    has_doubts = any(trial.component.doubts for trial in sizing.trials)
    first = "component (?: with doubts)" if has_doubts else "component"
    return ReportTable((first, *headings, Column("meets all requirements")), rows)


def with_brackets(name: str, unit: str) -> str:
    """Return a heading with its unit in brackets; a dimensionless quantity has none."""
    return f"{name} [{pretty(unit)}]".replace(" [1]", "")


def write_catalogue_sizing(sizing: CatalogueSizing, path: str | Path) -> Path:
    """Write the report of a search in the catalogue as a self-contained HTML page."""
    return write_page(path, lambda: catalogue_page(sizing))


def catalogue_page(sizing: CatalogueSizing) -> str:
    """Return the report of a search in the catalogue as HTML."""
    which = "largest" if sizing.is_largest else "smallest"
    lead, caption = (sentence(f"size.page.{key}", {"which": which, "part": sizing.part}) for key in ("part", "trials"))
    with style("A page of a sizing"):
        headlines = "".join(paragraph(line, bold=k == 0) for k, line in enumerate(_headlines(sizing)))
        sections = [
            Section("", head(sizing.title, lead)),
            Section("Result", (headlines, findings(sizing.remarks))),
            Section("Metrics of the components", picture(trial_figure(sizing), "trials", caption, is_still=True)),
            Section("Components", trial_table(sizing)),
        ]
    return document(sizing.title or sizing.part, sections)


def trial_figure(sizing: CatalogueSizing) -> Figure:
    """Draw each metric that has a requirement versus the size of the components."""
    unit = _unit(sizing)
    sizes = np.array([scaled(trial.size, sizing.unit, unit) for trial in sizing.trials])
    is_met = np.array([trial.is_met for trial in sizing.trials])
    names = [name for name in sizing.units if name in sizing.bounds]
    figure = new_figure(WIDTH, len(names) * (_PANEL + _GAP) + 0.55)
    axes = None
    for k, name in enumerate(names):
        axes = axes_in(figure, 0.95, 0.35 + k * (_PANEL + _GAP), WIDTH - 1.2, _PANEL, sharex=axes)
        values = np.array([trial.metrics[name] for trial in sizing.trials])
        for mask, colour, label in ((is_met, GOOD, "meets all requirements"), (~is_met, BAD, "does not")):
            is_visible = mask & np.isfinite(values)
            axes.plot(sizes[is_visible], values[is_visible], "o", color=colour, markersize=5.0, label=label)
        for bound in sizing.bounds[name]:
            axes.axhline(bound, color=INK, linewidth=1.0, linestyle=(0, (5, 3)))
        if sizing.selected is not None:
            axes.axvline(scaled(sizing.selected.size, sizing.unit, unit), color=ACCENT, linewidth=1.2)
        axes.set_ylabel(with_brackets(name, sizing.units[name]), parse_math=False)
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        axes.tick_params(labelbottom=k == len(names) - 1)
    if axes is not None:
        axes.set_xlabel(with_brackets(_LABELS[sizing.measure], unit), parse_math=False)
        handles = axes.get_legend_handles_labels()
        figure.legend(*handles, loc="upper left", bbox_to_anchor=(0.08, 1.0), ncols=2, fontsize=8)
    return figure


def _headlines(sizing: CatalogueSizing) -> list[str]:
    """Return a sentence on the selected component, and one on the next component that fails."""
    which, other = ("Largest", "larger") if sizing.is_largest else ("Smallest", "smaller")
    selected, neighbour = sizing.selected, sizing.neighbour
    if selected is None:
        return [f"No component of the catalogue for {sizing.part} meets the requirements."]
    text = f"{which} {sizing.part} of the catalogue: {_name(selected)}, {_size_text(sizing, selected)}."
    lines = [f"{text} {_margins(sizing, selected)}"]
    if neighbour is not None:
        text = f"Next {other}: {_name(neighbour)}, {_size_text(sizing, neighbour)}, fails."
        lines.append(f"{text} {_margins(sizing, neighbour)}")
    return lines


def _margins(sizing: CatalogueSizing, trial: CatalogueTrial) -> str:
    """Return the margins of a trial as a sentence."""
    texts = (
        f"{name} {with_unit(f'{margin:+.3g}', sizing.units[sizing.bounded[name]])}"
        for name, margin in trial.margins.items()
    )
    return f"Margins: {', '.join(texts)}."


def _name(trial: CatalogueTrial) -> str:
    return f"{trial.component.name}{' ?' if trial.component.doubts else ''}"


def _unit(sizing: CatalogueSizing) -> str:
    return readable_unit(sizing.unit, float(np.median([trial.size for trial in sizing.trials])))


def _size_text(sizing: CatalogueSizing, trial: CatalogueTrial) -> str:
    unit = _unit(sizing)
    return f"{_LABELS[sizing.measure]} = {with_unit(number(scaled(trial.size, sizing.unit, unit)), unit)}"
