"""Report of a sizing: value of the free parameter, margins and metrics."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from poppet.core.message_format import sentence
from poppet.core.number_format import number, pretty, readable_unit, scaled, with_unit
from poppet.ensemble import Sizing
from poppet.ensemble.statistics import wilson
from poppet.report.html_page import Section, document, findings, head, paragraph, picture, write_page
from poppet.report.tables import Column, ReportTable
from poppet.timeseries.plotting.figures import ACCENT, GREY, INK, PALETTE, axes_in, new_figure, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH, _HEIGHT, _GAP = 10.0, 1.9, 0.35


def write_sizing(sizing: Sizing, path: str | Path) -> Path:
    """Write the report of a sizing as a self-contained HTML page."""
    return write_page(path, lambda: sizing_page(sizing))


def sizing_page(sizing: Sizing) -> str:
    """Return the report of a sizing as HTML."""
    caption, lead, share_caption, explanation = (
        sentence(f"size.page.{key}", {"which": _extreme(sizing), "address": sizing.address} if key == "lead" else {})
        for key in ("caption", "lead", "share_caption", "explained")
    )
    with style("A page of a sizing"):
        caption += f" {share_caption}" if sizing.share < 1.0 else ""
        result = (paragraph(_headline(sizing), bold=True), _margin_table(sizing), findings(sizing.remarks))
        sections = [
            Section("", head(sizing.title, lead)),
            Section("Result", result),
            Section("Metrics versus the parameter", picture(curve_figure(sizing), "curves", caption)),
            Section("Explanation", f"<p>{explanation}</p>\n"),
        ]
    return document(sizing.title or sizing.address, sections)


def sizing_text(sizing: Sizing) -> str:
    """Return the result of a sizing as text for a terminal."""
    lines = [sizing.title] if sizing.title else []
    lines.append(_headline(sizing))
    lines += ["", _margin_table(sizing).text()] if sizing.is_met else []
    return "\n".join([*lines, *(f"- {remark}" for remark in sizing.remarks)])


def _extreme(sizing: Sizing) -> str:
    return "largest" if sizing.is_largest else "smallest"


def _headline(sizing: Sizing) -> str:
    if not sizing.is_met:
        return f"{sizing.address}: no value in the range meets the requirements."
    text = f"{_extreme(sizing).capitalize()} {sizing.address}: {_value_text(sizing, sizing.value)}"
    if sizing.share < 1.0:
        low, high = (100.0 * end for end in sizing.interval)
        text += f" (yield {100.0 * sizing.share:g} %, 95 % interval {low:.4g} ... {high:.4g} %)"
    text += f", limited by {sizing.limiting}" if sizing.limiting else ""
    return text + (f"; of the sizes: {_value_text(sizing, sizing.size)}." if math.isfinite(sizing.size) else ".")


def _value_text(sizing: Sizing, value: float) -> str:
    unit = readable_unit(sizing.unit, value)
    return with_unit(number(scaled(value, sizing.unit, unit)), unit)


def _margin_table(sizing: Sizing) -> ReportTable:
    rows = [(name, sizing.requirements[name], margin) for name, margin in sizing.margins.items()]
    return ReportTable(("requirement", "", Column("margin at the value", ".3g")), rows, "Requirements")


def curve_figure(sizing: Sizing) -> Figure:
    """Draw every metric versus the free parameter.

    The yield is also drawn if there are several runs at each value.
    """
    unit = readable_unit(sizing.unit, float(np.median(sizing.values)))
    x = np.array([scaled(value, sizing.unit, unit) for value in sizing.values])
    rows = [*sizing.metrics, *(["yield"] if sizing.share < 1.0 else [])]
    figure = new_figure(_WIDTH, 0.35 + len(rows) * (_HEIGHT + _GAP) + 0.3)
    for k, name in enumerate(rows):
        bounds: tuple[float, ...]
        axes = axes_in(figure, 0.95, 0.25 + k * (_HEIGHT + _GAP), _WIDTH - 1.2, _HEIGHT)
        if name == "yield":
            ends = np.array([wilson(round(share * sizing.runs), sizing.runs) for share in sizing.shares])
            axes.fill_between(x, 100.0 * ends[:, 0], 100.0 * ends[:, 1], color=GREY, alpha=0.25, linewidth=0)
            y, bounds, label = 100.0 * sizing.shares, (100.0 * sizing.share,), "good runs [%]"
        else:
            y = np.where(np.isfinite(sizing.metrics[name]), sizing.metrics[name], np.nan)
            bounds, label = sizing.bounds.get(name, ()), f"{name} [{pretty(sizing.units[name])}]".replace(" [1]", "")
        axes.plot(x, y, color=PALETTE[0], linewidth=1.3, marker="o", markersize=2.2, markeredgewidth=0)
        for bound in bounds:
            axes.axhline(bound, color=INK, linewidth=1.0, linestyle=(0, (5, 3)))
        axes.set_ylabel(label, parse_math=False)
        for interval in sizing.holding:
            first, last = (scaled(end, sizing.unit, unit) for end in interval)
            axes.axvspan(first, last, color=PALETTE[2], alpha=0.12, linewidth=0)
        if sizing.is_met:
            axes.axvline(scaled(sizing.value, sizing.unit, unit), color=ACCENT, linewidth=1.4)
        if x[0] > 0.0:
            axes.set_xscale("log")
            axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        axes.set_xlim(x[0], x[-1])
        axes.tick_params(labelbottom=k == len(rows) - 1)
    axes.set_xlabel(f"{sizing.address} [{pretty(unit)}]".replace(" [1]", ""), parse_math=False)
    return figure
