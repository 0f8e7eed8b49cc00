"""What a sizing found, for a terminal and as a page with the curves of all metrics over the number."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.message_format import sentence
from poppet.core.number_format import number, pretty, readable_unit, scaled, with_unit
from poppet.ensemble import Sizing
from poppet.ensemble.statistics import wilson
from poppet.report.html_page import document, findings, head, picture, write_page
from poppet.report.tables import Column, Table
from poppet.timeseries.plotting.figures import ACCENT, GREY, INK, PALETTE, axes_in, new_figure, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH, _HIGH, _GAP = 10.0, 1.9, 0.35


def write_sizing(found: Sizing, path: str | Path) -> Path:
    """Write a sizing as one page that needs nothing else."""
    return write_page(path, lambda: sizing_page(found))


def sizing_page(found: Sizing) -> str:
    """The page as text."""
    which = "largest" if found.is_largest else "smallest"
    with style("A page of a sizing"):
        caption = _said("caption") + (f" {_said('share_caption')}" if found.share < 1.0 else "")
        sections = [
            ("", head(found.title, sentence("size.page.lead", {"which": which, "address": found.address}))),
            (
                "Found",
                f"<p><strong>{_headline(found)}</strong></p>\n{_margins(found).html()}" + findings(found.remarks),
            ),
            ("Over the number", picture(curve_figure(found), "curves", caption)),
            ("How to read this page", f"<p>{_said('explained')}</p>\n"),
        ]
    return document(found.title or found.address, sections)


def sizing_text(found: Sizing) -> str:
    """What a person reads in a terminal."""
    lines = [found.title] if found.title else []
    lines += [_headline(found)]
    lines += ["", _margins(found).text()] if found.is_met else []
    return "\n".join([*lines, *(f"- {remark}" for remark in found.remarks)])


def _headline(found: Sizing) -> str:
    which = "largest" if found.is_largest else "smallest"
    if not found.is_met:
        return f"{found.address}: no value in the range meets the requirements."
    text = f"{which.capitalize()} {found.address}: {_shown(found, found.value)}"
    if found.share < 1.0:
        low, high = (100.0 * end for end in found.interval)
        text += f" (yield {100.0 * found.share:g} %, 95 % interval {low:.4g} ... {high:.4g} %)"
    text += f", limited by {found.limiting}" if found.limiting else ""
    return text + (f"; of the sizes: {_shown(found, found.size)}." if math.isfinite(found.size) else ".")


def _shown(found: Sizing, value: float) -> str:
    unit = readable_unit(found.unit, value)
    return with_unit(number(scaled(value, found.unit, unit)), unit)


def _margins(found: Sizing) -> Table:
    columns = Column("requirement"), Column(""), Column("margin at the value", ".3g")
    rows = tuple((name, found.requirements[name], margin) for name, margin in found.margins.items())
    return Table("margins", "Requirements", columns, rows)


def curve_figure(found: Sizing) -> Figure:
    """Every metric, and of many runs the share of good ones, over the free number."""
    unit = readable_unit(found.unit, float(np.median(found.values)))
    x = np.array([scaled(value, found.unit, unit) for value in found.values])
    rows = [*found.metrics, *(["yield"] if found.share < 1.0 else [])]
    figure = new_figure(_WIDTH, 0.35 + len(rows) * (_HIGH + _GAP) + 0.3)
    for k, name in enumerate(rows):
        axes = axes_in(figure, 0.95, 0.25 + k * (_HIGH + _GAP), _WIDTH - 1.2, _HIGH)
        if name == "yield":
            _share(axes, found, x)
        else:
            _metric(axes, found, name, x)
        for low, high in found.holding:
            ends = [scaled(end, found.unit, unit) for end in (low, high)]
            axes.axvspan(*ends, color=PALETTE[2], alpha=0.12, linewidth=0)
        if found.is_met:
            axes.axvline(scaled(found.value, found.unit, unit), color=ACCENT, linewidth=1.4)
        if x[0] > 0.0:
            axes.set_xscale("log")
            axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        axes.set_xlim(x[0], x[-1])
        axes.tick_params(labelbottom=k == len(rows) - 1)
    axes.set_xlabel(f"{found.address} [{pretty(unit)}]".replace(" [1]", ""), parse_math=False)
    return figure


def _metric(axes: Any, found: Sizing, name: str, x: Any) -> None:
    y = np.where(np.isfinite(found.metrics[name]), found.metrics[name], np.nan)
    axes.plot(x, y, color=PALETTE[0], linewidth=1.3, marker="o", markersize=2.2, markeredgewidth=0)
    for bound in found.bounds.get(name, ()):
        axes.axhline(bound, color=INK, linewidth=1.0, linestyle=(0, (5, 3)))
    axes.set_ylabel(f"{name} [{pretty(found.units[name])}]".replace(" [1]", ""), parse_math=False)


def _share(axes: Any, found: Sizing, x: Any) -> None:
    ends = np.array([wilson(round(share * found.runs), found.runs) for share in found.shares])
    axes.fill_between(x, 100.0 * ends[:, 0], 100.0 * ends[:, 1], color=GREY, alpha=0.25, linewidth=0)
    axes.plot(x, 100.0 * found.shares, color=PALETTE[0], linewidth=1.3, marker="o", markersize=2.2, markeredgewidth=0)
    axes.axhline(100.0 * found.share, color=INK, linewidth=1.0, linestyle=(0, (5, 3)))
    axes.set_ylabel("good runs [%]")


def _said(code: str) -> str:
    return sentence(f"size.page.{code}", {})
