"""Report of an experiment design: recommended tests and expected confidence intervals."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.core.message_format import sentence
from poppet.core.note_groups import explain_command
from poppet.core.number_format import readable_unit, scaled
from poppet.identify import Design, Prediction
from poppet.identify.design.identify_design import TWO_SIDED
from poppet.report.html_page import Section, document, findings, head, items, picture, write_page
from poppet.report.identification.identification_figures import VERDICT_COLOURS
from poppet.report.tables import Column, ReportTable, numeric
from poppet.timeseries.plotting.figures import axes_in, new_figure, style, widest

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MAX_CANDIDATES = 12
"""Maximum number of candidates in a terminal and in the figure."""
_ROW = 0.27


def write_design(design: Design, path: str | Path) -> Path:
    """Write the report of an experiment design as a self-contained HTML page."""
    return write_page(path, lambda: design_page(design))


def design_page(design: Design) -> str:
    """Return the report of an experiment design as HTML."""
    lead, caption, explanation, reference = (
        sentence(f"identification.design.{key}", {}) for key in ("lead", "caption", "explained", "reference")
    )
    with style("A page of tests that could be made"):
        sections = [
            Section("", head(design.title, lead)),
            Section("Recommended tests", [items(design.chosen, "ol"), _joint_table(design), findings(design.remarks)]),
            Section("Candidates, each alone", picture(error_figure(design), "errors", caption, is_still=True)),
            Section("All candidates", _candidate_table(design, len(design.tests))),
            Section("Explanation", f"<p>{explanation}</p>\n"),
            Section("Sources", items([reference])),
        ]
    return document(design.title, sections)


def design_text(design: Design, max_findings: int | None = None) -> str:
    """Return an experiment design as text for a terminal.

    All findings are included. `max_findings` has no effect; the summaries of other methods use it.
    """
    n_omitted = len(design.tests) - MAX_CANDIDATES
    lines = [design.title, "Make:", *(f"  {k}. {name}" for k, name in enumerate(design.chosen, start=1)), ""]
    lines += [_joint_table(design).text(), "", _ranking_caption(design)]
    lines += [_candidate_table(design, MAX_CANDIDATES).text()]
    lines += [f"  ({n_omitted} more: the page and the result file)"] if n_omitted > 0 else []
    command = explain_command(remark.code for remark in design.remarks)
    return "\n".join([*lines, *(f"- {remark}" for remark in design.remarks), *[f"more: {command}"] * bool(command)])


def _joint_table(design: Design) -> ReportTable:
    """Return a table of the expected confidence intervals after all recommended tests."""
    rows = []
    for name, p in design.together.items():
        unit = readable_unit(p.unit, p.value)

        def width(half: float, p: Prediction = p, unit: str = unit) -> float:
            return scaled(p.value + half, p.unit, unit) - scaled(p.value, p.unit, unit)

        fitted = design.simulated.get(name)
        row = (name, scaled(p.value, p.unit, unit), "" if unit == "1" else unit, width(p.half), p.verdict)
        rows.append((*row, width(TWO_SIDED * fitted.standard_error), fitted.verdict) if fitted else row)
    columns: list[Column | str] = [
        "parameter",
        Column("about", ".4g"),
        "unit",
        Column("half interval", ".2g"),
        "verdict",
    ]
    if design.simulated:
        columns += [Column("simulated fits: half interval", ".2g"), "their verdict"]
    return ReportTable(tuple(columns), rows, "After these tests, if the circuit is correct")


def _candidate_table(design: Design, n_max: int) -> ReportTable:
    """Return a table of the expected errors of the parameters after each single test.

    The relative error of a parameter is half the width of the 95 % interval, divided by the value of the parameter. The
    table contains geometric means of this error over all assumed values and samples of the priors, and the criterion
    that is computed from these means. `n_max` is the maximum number of tests.
    """
    names, ranked_by = next(iter(design.tests.values())).keys(), design.ranked_by()
    rows = [
        (test, *(_percent(row[name], row[name].typical_half_width) for name in names), ranked_by[test])
        for test, row in design.tests.items()
    ]
    columns = numeric(*(f"{name} [%]" for name in names), "criterion [%]", digits=".2g")
    return ReportTable(("test", *columns), rows[:n_max], _ranking_caption(design))


def _percent(p: Prediction, half: float) -> float:
    return 100.0 * half / p.scale


def _ranking_caption(design: Design) -> str:
    return str(sentence(f"identification.design.ranking.{design.criterion}", {}))


def error_figure(design: Design) -> Figure:
    """Draw the relative 95 % confidence intervals after each of the best tests.

    Each parameter has one panel.
    """
    tests = dict(list(design.tests.items())[:MAX_CANDIDATES])
    names = list(next(iter(tests.values())))
    left, width, gap = 0.3 + widest([*tests], 8.0), 1.75, 0.2
    figure = new_figure(left + len(names) * (width + gap) + 0.2, 0.85 + _ROW * len(tests))
    for k, name in enumerate(names):
        axes = axes_in(figure, left + k * (width + gap), 0.35, width, _ROW * len(tests))
        for row, (test, predictions) in enumerate(tests.items()):
            p = predictions[name]
            colour = VERDICT_COLOURS[p.verdict]
            ends = [_percent(p, p.half), _percent(p, p.largest_half_width)]
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
        axes.set_xlabel("half interval [% of value]", fontsize=8)
    return figure
