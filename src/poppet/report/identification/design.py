"""Tests that could be made, for a terminal and as a page: which to make, and what each would tell."""

from __future__ import annotations

import html
import math
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.core.message_format import sentence
from poppet.core.number_format import pretty, readable_unit, scaled
from poppet.identify import Design, Prediction
from poppet.report.html_page import document, findings, head, picture, write_page
from poppet.report.identification.identification_figures import VERDICT_COLOURS
from poppet.report.tables import Column, Table
from poppet.timeseries.plotting.figures import axes_in, new_figure, style, widest

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SHOWN = 12
"""Candidates that a terminal and a picture show."""
_ROW = 0.27


def write_design(design: Design, path: str | Path) -> Path:
    """Write a design as one page that needs nothing else."""
    return write_page(path, lambda: design_page(design))


def design_page(design: Design) -> str:
    """The page as text."""
    with style("A page of tests that could be made"):
        chosen = "".join(f"<li>{html.escape(name)}</li>\n" for name in design.chosen)
        sections = [
            ("", head(design.title, _said("lead"))),
            ("Make", f"<ol>\n{chosen}</ol>\n{_together(design).html()}" + findings(design.remarks)),
            (
                "What each test alone would tell",
                picture(error_figure(design), "errors", _said("caption"), is_still=True),
            ),
            ("All tests", _ranking(design, len(design.tests)).html()),
            ("How to read this page", f"<p>{_said('explained')}</p>\n"),
            ("Sources", f"<ul><li>{_said('reference')}</li></ul>\n"),
        ]
    return document(design.title, sections)


def design_text(design: Design) -> str:
    """What a person reads in a terminal."""
    left = len(design.tests) - SHOWN
    lines = [design.title, "Make:", *(f"  {k}. {name}" for k, name in enumerate(design.chosen, start=1)), ""]
    lines += [_together(design).text(), "", _ranking(design, SHOWN).text()]
    lines += [f"  ({left} more: the page and the result file)"] if left > 0 else []
    return "\n".join([*lines, *(f"- {remark}" for remark in design.remarks)])


def _together(design: Design) -> Table:
    """Numbers after the chosen tests."""
    columns = Column("number"), Column("about", ".4g"), Column("unit"), Column("+/- 95 %", ".2g"), Column("verdict")
    rows = []
    for name, p in design.together.items():
        unit = readable_unit(p.unit, p.value)
        half = scaled(p.value + p.half, p.unit, unit) - scaled(p.value, p.unit, unit)
        rows.append((name, scaled(p.value, p.unit, unit), "" if unit == "1" else unit, half, p.verdict))
    return Table("together", "After these tests, if the circuit is right", columns, tuple(rows))


def _ranking(design: Design, most: int) -> Table:
    """The best candidates alone: half of each 95 % interval in per cent of the number."""
    names = next(iter(design.tests.values())).keys()
    columns = Column("test"), *(Column(f"{name} [%]", ".2g") for name in names)
    rows = [(test, *(_percent(row[name]) for name in names)) for test, row in design.tests.items()]
    return Table("tests", "Each test alone, +/- 95 % of the number", columns, tuple(rows[:most]))


def _percent(p: Prediction) -> float:
    return 100.0 * p.half / (abs(p.value) or 1.0)


def error_figure(design: Design) -> Figure:
    """Half of each 95 % interval over the number, a row for each of the best candidates, a panel for each number."""
    tests = dict(list(design.tests.items())[:SHOWN])
    names = list(next(iter(tests.values())))
    left, width, gap = 0.3 + widest([*tests], 8.0), 1.75, 0.2
    figure = new_figure(left + len(names) * (width + gap) + 0.2, 0.85 + _ROW * len(tests))
    for k, name in enumerate(names):
        axes = axes_in(figure, left + k * (width + gap), 0.35, width, _ROW * len(tests))
        for row, (test, found) in enumerate(tests.items()):
            p = found[name]
            colour = VERDICT_COLOURS[p.verdict]
            ends = [_percent(p), 100.0 * p.half_at_most / (abs(p.value) or 1.0)]
            axes.plot(ends, [row, row], color=colour, linewidth=3, alpha=0.35, solid_capstyle="butt")
            axes.plot(ends[0], row, "o", color=colour, markersize=5.5, markeredgewidth=0)
            if k == 0:
                weight = "bold" if test in design.chosen else "normal"
                label = {"ha": "right", "va": "center", "fontsize": 8, "fontweight": weight, "parse_math": False}
                axes.text(-0.04, row, test, transform=axes.get_yaxis_transform(), **label)
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter(lambda x, _: f"{x:g}")
        axes.xaxis.set_minor_formatter(lambda x, _: "")
        low, high = axes.get_xlim()
        axes.set_xlim(10.0 ** math.floor(math.log10(low)), 10.0 ** math.ceil(math.log10(high)))
        axes.set_ylim(len(tests) - 0.5, -0.5)
        axes.set_yticks([])
        axes.grid(axis="x", alpha=0.4)
        axes.set_title(name, fontsize=8, parse_math=False)
        axes.set_xlabel(pretty("± % of it"), fontsize=8)
    return figure


def _said(code: str) -> str:
    return sentence(f"identification.design.{code}", {})
