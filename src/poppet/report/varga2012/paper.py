"""Report on Varga & Keski-Honkola 2012: recomputed figures and tables, and a check of every statement.

The texts of the statements are in `messages/paper.toml`.
"""

from __future__ import annotations

import dataclasses
import enum
import json
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from operator import methodcaller
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet import library
from poppet.core.errors import InputError
from poppet.core.files import write_whole
from poppet.core.message_format import sentence
from poppet.core.version import __version__
from poppet.report.html_page import Section, document, head, paragraph, picture
from poppet.report.styles import stylesheet
from poppet.report.tables import Column, Markup, ReportTable, numeric
from poppet.report.varga2012 import runs
from poppet.timeseries.plotting.figures import FAINT, GREY, INK, PALETTE, axes_in, figure_bytes, new_figure, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FOLDER = "paper"
_NARROW = ("fig3", "fig4")

# Axes as in the figures of the paper.
FIG3_AXES = (0.0, 1.0, 0.4, 2.0)  # stroke [mm], C [1e-8 m^3/(s Pa)]
FIG4_AXES = (0.0, 1.0, 0.35, 0.75)  # stroke [mm], b [1]
FIG6_AXES = (0.0, runs.STEPS_END, 1.0, 5.5)  # time [s], pressure [bar]

_BLUE, _RED, _GREEN, _VIOLET, _AMBER = PALETTE[:5]
_TANKS = (
    ("isentrope", "isentrope (the paper's tank)", _RED, "-"),
    ("adiabatic", "energy balance, adiabatic", _AMBER, (0, (5, 2))),
    ("wall", "energy balance with wall heat", _BLUE, "-"),
    ("isothermal", "isothermal", _GREEN, (0, (1.2, 1.4))),
)


class Verdict(enum.Enum):
    """Verdict on a statement of the paper.

    The value is the text of the verdict.
    """

    HOLDS = "holds"
    FAILS = "does not hold"
    OPEN = "cannot be told"


@dataclass(frozen=True)
class Statement:
    """Statement of the paper, with the result of its check.

    `holds` is True if the statement holds, False if not, and None if it cannot be checked. `facts` contains the values
    in the text of the finding, in the units of that text.
    """

    code: str
    holds: bool | None
    facts: Mapping[str, Any]

    @property
    def verdict(self) -> Verdict:
        """Verdict on the statement."""
        return Verdict.OPEN if self.holds is None else Verdict.HOLDS if self.holds else Verdict.FAILS

    @property
    def text(self) -> str:
        """Text of the statement in the report."""
        return sentence(f"{self.code}.text", {})

    @property
    def place(self) -> str:
        """Location of the statement in the paper."""
        return sentence(f"{self.code}.place", {})

    @property
    def finding(self) -> str:
        """Sentence on the simulation result from which the verdict follows."""
        return sentence(f"{self.code}.finding", self.facts)


@dataclass(frozen=True)
class PaperResult:
    """Result of `write_paper`: findings, tables, statements and written files."""

    folder: Path
    files: tuple[Path, ...]  # `report.html` first
    findings: runs.Findings  # values in SI units
    tables: dict[str, ReportTable]  # by name: strokes, tank_laws, wall_conductances, statements
    statements: tuple[Statement, ...]  # with their verdicts

    def table(self) -> str:
        """Return all tables and statements of the reproduction as text for a terminal."""
        tables = [f"{table.caption}\n\n{table.text()}" for name, table in self.tables.items() if name != "statements"]
        width = max(len(item.verdict.value) for item in self.statements)
        lines = [f"{item.verdict.value:<{width}}  {item.text} {item.place}" for item in self.statements]
        return "\n\n".join([*tables, "Statements of the paper\n\n" + "\n".join(lines), f"Read {self.files[0]}"])


def write_paper(folder: str | Path = FOLDER, progress: Callable[[str], Any] = lambda step: None) -> PaperResult:
    """Recompute the paper and write a report with figures, tables and values.

    Notes
    -----
    All values are simulated when the report is written. Quantities that the paper does not state (supply pressure,
    required values, mechanics, exhaust) are assumed and marked in the report.

    References
    ----------
    Varga & Keski-Honkola 2012, J. Appl. Sci. Thermodyn. Fluid Mech. 1(1), ISSN 1802-9388.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     result = write_paper(folder)
    >>> print(f"{result.findings.fillings['isothermal'].time:.2f} s")
    71.11 s
    """
    target = Path(folder)
    with style("The report on the paper"):  # first: matplotlib may not be installed
        try:
            target.mkdir(parents=True, exist_ok=True)
        except OSError as problem:
            raise InputError("paper.folder", path=str(target), why=problem.strerror or str(problem)) from problem
        results = runs.run_simulations(progress)
        progress("figures")
        checked = tuple(statements(results))
        tables = {table.name: table for table in _tables(results, checked)}
        pictures = dict(_figures(results))
        svgs = {f"{name}.svg": figure_bytes(figure, "svg", name) for name, figure in pictures.items()}
        files = {"report.html": _report_html(results, pictures, tables, checked).encode()}
        files["results.json"] = (json.dumps(_numbers(results, checked), indent=1) + "\n").encode()
        for name, figure in pictures.items():
            files[f"{name}.svg"] = svgs[f"{name}.svg"]
            files[f"{name}.png"] = figure_bytes(figure, "png", name)
    run = results.staircase
    headings = ["time [s]", *(f"{name} [{unit}]" for name, unit in zip(run.names, run.units, strict=True))]
    rows = [tuple(map(float, row)) for row in zip(run.time, *run.values, strict=True)]
    for name, table in {**tables, "fig6": ReportTable(headings, rows)}.items():
        files[f"{name}.csv"] = table.csv().encode()
    paths = tuple(write_whole(target / name, methodcaller("write", content)) for name, content in files.items())
    return PaperResult(target, paths, results, tables, checked)


def _numbers(results: runs.Findings, checked: Sequence[Statement]) -> dict[str, Any]:
    names = [field.name for field in dataclasses.fields(results)]
    numbers = {name: getattr(results, name) for name in names if name not in ("staircase", "fillings", "walls")}
    return {
        "paper": "Varga & Keski-Honkola 2012",
        "poppet": __version__,
        "units": "SI: Pa, K, s, m, kg/s, W/K, m^3/(s Pa); pressures absolute",
        "numbers": {"strokes": runs.STROKES} | numbers,
        "tank_laws": {key: dataclasses.asdict(filling) for key, filling in results.fillings.items()},
        "wall_conductances": [dataclasses.asdict(wall) for wall in results.walls],
        "statements": [
            {key: getattr(item, key) for key in ("code", "text", "place", "finding")} | {"verdict": item.verdict.value}
            for item in checked
        ],
    }


# --- Statements ---


def statements(results: runs.Findings) -> Iterator[Statement]:
    """Yield all statements of the paper with their verdicts."""
    c, b, (stroke, largest) = results.conductances, results.ratios, results.largest
    smallest_stroke, smallest = results.smallest_ratio
    fill = results.fillings
    isentrope, adiabatic, walled = fill["isentrope"], fill["adiabatic"], fill["wall of the peak"]
    isothermal, polytropic = fill["isothermal"].time, fill["polytropic"].time
    settling = {"settling": 1e3 * results.settling_time}
    first, greatest = {"first": 1e8 * c[0]}, {"largest": 1e8 * largest}

    # The flow law.
    yield Statement("paper.law", results.law_deviation < 1e-9, {"deviation": results.law_deviation})
    error = results.downstream_error
    yield Statement("paper.downstream", abs(error) < 1e-3, {"per_cent": 100.0 * error})
    is_physical = min(c) > 0.0 and min(b) > 0.0 and max(b) < 1.0
    beyond = {"zero": 1e3 * results.zero_beyond, "beyond": 1e8 * results.conductance_beyond}
    yield Statement("paper.range", is_physical, beyond)

    # The characteristic.
    ratios = {"lowest_ratio": smallest, "lowest_stroke": 1e3 * smallest_stroke, "first_ratio": b[0]}
    spread = {**first, **greatest, **ratios, "growth": largest / c[0], "stroke": 1e3 * stroke}
    yield Statement("paper.nonlinear", largest > 1.1 * c[0] and b[0] > 1.1 * smallest, spread)
    hump = {"fall": 100.0 * (1.0 - c[-1] / largest), "suspected": 1e8 * results.suspected_largest}
    yield Statement("paper.drawn", None, greatest | hump)  # the points of the figure are not in the text
    leak = {"share": 100.0 * c[0] / largest, "leak": 1e3 * results.leak}
    yield Statement("paper.closing", c[0] < 1e-3 * largest, first | leak)

    # Mechanics.
    strokes = results.exhaust_strokes
    yield Statement("paper.emptying", max(strokes) - min(strokes) < 1e-9, {"strokes": [1e6 * x for x in strokes]})
    printed, drawn = results.stroke_printed, results.stroke_fig5
    is_equal = abs(drawn - printed) < 1e-3 * printed
    yield Statement("paper.fig5", is_equal, {"printed": 1e3 * printed, "drawn": 1e3 * drawn})
    low, high = results.open_end
    yield Statement("paper.following", max(low, high) < 0.99 * runs.SUPPLY, {"low": 1e-5 * low, "high": 1e-5 * high})
    yield Statement("paper.slow", results.settling_time < 1e-2 * walled.time, settling | {"filling": walled.time})
    yield Statement("paper.faster", None, settling)  # no response of the real valve is given

    # The tank.
    rise = isentrope.end_temperature - runs.START_TEMPERATURE
    warmed = {"isentrope": rise, "adiabatic": adiabatic.end_temperature - runs.START_TEMPERATURE}
    walls = {"walls": [wall.for_peak for wall in results.walls], "supplies": [1e-5 * p for p in runs.SUPPLIES]}
    reported = {"reported": runs.REPORTED_RISE, "exponent": results.exponent}
    is_near = abs(rise - runs.REPORTED_RISE) < 0.5 * runs.REPORTED_RISE
    yield Statement("paper.warming", is_near, warmed | reported | walls)
    times = {"isentrope": isentrope.time, "adiabatic": adiabatic.time}
    ends = {"isentrope_end": isentrope.end_temperature, "adiabatic_end": adiabatic.end_temperature}
    yield Statement("paper.no_heat", abs(isentrope.time - adiabatic.time) < 1e-2 * adiabatic.time, times | ends)
    times = {"isentrope": isentrope.time, "walled": walled.time, "isothermal": isothermal}
    excess = {"least": walled.time / isentrope.time, "most": isothermal / isentrope.time, "wall": results.wall.for_peak}
    yield Statement("paper.measured_slower", walled.time > isentrope.time, times | excess)

    # Conclusions.
    by_heat, by_law = walled.time - adiabatic.time, adiabatic.time - isentrope.time
    drop = results.pressure_drop
    shares = {"difference": walled.time - isentrope.time, "by_heat": by_heat, "by_law": by_law, "drop": 1e-5 * drop}
    yield Statement("paper.heat", by_heat > by_law and drop > 0.0, shares)
    times = {"polytropic": polytropic, "walled": walled.time, "isentrope": isentrope.time}
    is_near = abs(polytropic - walled.time) < 0.1 * abs(isentrope.time - walled.time)
    yield Statement("paper.polytropic", is_near, times | {"exponent": results.exponent})
    slow, constant = results.slow_time, results.slow_time_constant
    yield Statement("paper.precise", slow > 1.1 * constant, {"slow": slow, "constant": constant})
    # The error is the largest relative difference from the setpoint at the end of a step, for all thermal laws.
    staircase = results.staircase
    required = staircase["required.pressure"]
    last_rows = np.append(np.flatnonzero(np.diff(required)), required.size - 1)
    pressures = np.array([staircase[f"{tank}.pressure"] for tank in runs.TANKS])
    miss = float(np.max(np.abs(pressures[:, last_rows] / required[last_rows] - 1.0)))
    lowest, highest = 1e-5 * float(pressures.min()), 1e-5 * float(pressures.max())
    facts = {"low": lowest, "high": highest, "miss": 100.0 * miss}
    yield Statement("paper.staircase", miss < 1e-2 and lowest > 0.999 and highest < 5.5, facts)
    yield Statement("paper.works_well", None, {})  # the points of fig. 6 are not in the text


# --- Tables ---


def _tables(results: runs.Findings, checked: Sequence[Statement]) -> Iterator[ReportTable]:
    conductances = zip(results.conductances, results.ratios, strict=True)
    yield ReportTable(
        (Column("x [mm]", ".1f"), *numeric("C [1e-8 m^3/(s Pa)]", "b [1]", digits=".5f")),
        [(1e3 * x, 1e8 * c, b) for x, (c, b) in zip(runs.STROKES, conductances, strict=True)],
        "Sonic conductance and critical pressure ratio, polynomials of Table 1 as printed",
        "strokes",
        "plain",
    )
    start, shortest = runs.START_TEMPERATURE, results.fillings["isentrope"].time
    headings = numeric("time to 5 bar [s]", "ratio to isentrope [1]", "end [K]", digits=".2f")
    yield ReportTable(
        ("tank law", *headings, Column("rise [K]", ".1f"), Column("peak [K]", ".2f"), Column("peak at [s]", ".1f")),
        [
            (
                item.law, item.time, item.time / shortest, item.end_temperature, item.end_temperature - start,
                item.peak_temperature, item.peak_time if item.peak_temperature > start else None,
            )
            for item in results.fillings.values()
        ],
        "Filling the 0.2 m³ tank from 1 to 5 bar at 0.5 mm stroke; supply 7 bar, 293.15 K",
        "tank_laws",
        "plain",
    )  # fmt: skip
    rise = f"{runs.REPORTED_RISE:.0f} K"
    yield ReportTable(
        numeric(
            "supply [bar]", f"h A, {rise} is the peak [W/K]", "peak at [s]", f"h A, {rise} at 5 bar [W/K]", digits=".1f"
        ),
        [(1e-5 * item.supply, item.for_peak, item.peak_time, item.for_end) for item in results.walls],
        f"Wall conductance that explains the reported rise of {rise}; wall at 293.15 K",
        "wall_conductances",
        "plain",
    )
    yield ReportTable(
        ("statement", "where", "finding", "verdict"),
        [(item.text, item.place, item.finding, item.verdict.value) for item in checked],
        "Statements of the paper",
        "statements",
    )


# --- Page ---


def _report_html(
    results: runs.Findings,
    pictures: Mapping[str, Figure],
    tables: Mapping[str, ReportTable],
    checked: Sequence[Statement],
) -> str:
    """Return the report as HTML: headline, figures, statements, tables and circuit."""
    texts = {name: sentence(f"paper.page.{name}", {}) for name in ("title", "source", "choices", "tanks")}
    verdict = '<span class="verdict {}">{}</span>'
    rows = [
        (item.text, item.place, item.finding, Markup(verdict.format(item.verdict.name.lower(), item.verdict.value)))
        for item in checked
    ]
    statement_table = ReportTable(("Statement", "Location", "Finding", "Verdict"), rows, css_class="statements")
    figures = {
        name: picture(figure, name, sentence(f"paper.caption.{name}", {}), kind="narrow" if name in _NARROW else "")
        for name, figure in pictures.items()
    }
    counts, times = Counter(item.verdict for item in checked), results.fillings
    tally = {"holds": counts[Verdict.HOLDS], "fails": counts[Verdict.FAILS], "unknown": counts[Verdict.OPEN]}
    facts = {
        "isentrope": times["isentrope"].time,
        "adiabatic": times["adiabatic"].time,
        "walled": times["wall of the peak"].time,
        "reported": runs.REPORTED_RISE,
        "share": 100.0 * results.conductances[0] / results.largest[1],
    }
    counts_text = sentence("paper.page.headline", {"count": len(checked), **tally})
    main_results = paragraph(sentence("paper.page.main", facts))
    sections = [
        Section(
            "", head(texts["title"], texts["source"]) + paragraph(counts_text, css_class="headline") + main_results
        ),
        Section("The three figures of the paper", [figures["fig3"], figures["fig4"], figures["fig6"]]),
        Section("Statements of the paper", statement_table),
        Section("Flow characteristic", tables["strokes"]),
        Section("Tank laws", [f"<p>{texts['tanks']}</p>\n", tables["tank_laws"], tables["wall_conductances"]]),
        Section("Simulated circuit", [f"<p>{texts['choices']}</p>\n", figures["circuit"]]),
    ]
    return document(texts["title"], sections, style=stylesheet("paper"))


# --- Figures ---


def _figures(results: runs.Findings) -> Iterator[tuple[str, Figure]]:
    from poppet.report.circuit.schematic import draw_circuit

    yield "fig3", figure_3()
    yield "fig4", figure_4()
    yield "fig6", figure_6(results)
    yield "circuit", draw_circuit(runs.staircase_circuit(wall_conductance=round(results.wall.for_peak, 1)))


def figure_3() -> Figure:
    """Draw the sonic conductance versus the stroke (fig. 3 of the paper)."""
    figure, axes = _sheet(FIG3_AXES, "sonic conductance C  [1e-8 m³/(s Pa)]")
    strokes = np.concatenate((np.linspace(0.0, 0.03e-3, 121), np.linspace(0.03e-3, 1e-3, 400)))
    printed, closed = library.characteristic("varga2012"), library.characteristic("varga2012.closed")
    alternative = 1e8 * np.asarray(runs.suspected_characteristic().sonic_conductance_at(strokes))
    axes.plot(1e3 * strokes, alternative, color="#b9bec7", linestyle=(0, (5, 2.5)), linewidth=1.3, label="k5 changed")
    axes.plot(
        1e3 * strokes, 1e8 * printed.sonic_conductance_at(strokes), color=_BLUE, linewidth=2.0, label="as printed"
    )
    # The variants differ only near the closed position.
    closing = strokes[strokes <= closed.numbers()["closing"].value]
    axes.plot(
        1e3 * closing, 1e8 * closed.sonic_conductance_at(closing), color=_RED, linestyle=(0, (2.2, 1.2)), label="closed"
    )
    _points(axes, [1e8 * float(printed.sonic_conductance_at(x)) for x in runs.STROKES])
    axes.text(0.985, 1.925, "hypothesis: k5 = -2.2229e-6", ha="right", color=GREY, fontsize=8.5)
    axes.text(0.44, 1.52, "polynomial of Table 1 as printed", color=_BLUE, fontsize=8.5, va="top")
    note = "closed variant: C = 0 at x = 0,\nas printed from 0.02 mm on"
    arrow = {"arrowstyle": "-", "color": _RED, "linewidth": 0.8, "shrinkB": 2}
    axes.annotate(note, (0.0135, 0.45), (0.09, 0.56), color=_RED, fontsize=8.5, va="center", arrowprops=arrow)
    return figure


def figure_4() -> Figure:
    """Draw the critical pressure ratio versus the stroke (fig. 4 of the paper)."""
    figure, axes = _sheet(FIG4_AXES, "critical pressure ratio b  [1]")
    strokes = np.linspace(0.0, 1e-3, 500)
    printed = library.characteristic("varga2012")
    axes.plot(1e3 * strokes, printed.critical_ratio_at(strokes), color=_BLUE, linewidth=2.0, label="as printed")
    _points(axes, [float(printed.critical_ratio_at(x)) for x in runs.STROKES])
    axes.text(0.1, 0.57, "polynomial of Table 1 as printed", color=_BLUE, fontsize=8.5)
    return figure


def figure_6(findings: runs.Findings) -> Figure:
    """Draw tank pressure and gas temperature versus time (fig. 6 of the paper)."""
    figure = new_figure(7.4, 5.9)
    upper = axes_in(figure, 0.75, 0.15, 6.45, 3.3)
    lower = axes_in(figure, 0.75, 3.65, 6.45, 1.7, sharex=upper)
    run = findings.staircase
    line_style: dict[str, Any] = {"color": INK, "linewidth": 1.2, "drawstyle": "steps-post"}
    upper.plot(run.time, 1e-5 * run["required.pressure"], label="required value", **line_style)
    for name, label, colour, line in _TANKS:
        note = f" ({findings.wall.for_peak:.1f} W/K)" if name == "wall" else ""
        line_style = {"color": colour, "linestyle": line, "linewidth": 1.5}
        upper.plot(run.time, 1e-5 * run[f"{name}.pressure"], label=label + note, **line_style)
        lower.plot(run.time, run[f"{name}.temperature"] - 273.15, label=label, **line_style)
    lower.axhline(20.0 + 18.0, color=GREY, linewidth=0.8, linestyle=(0, (2, 2)))
    lower.text(119.0, 43.0, "20 °C + 18 °C, the rise the paper reports", color=GREY, fontsize=8, ha="right")
    upper.axis(FIG6_AXES)
    upper.set_yticks(np.arange(1.0, 5.6, 0.5))
    upper.tick_params(labelbottom=False)
    upper.legend(loc="lower right", fontsize=8.5, facecolor="white", frameon=True, edgecolor=FAINT, framealpha=1.0)
    upper.set_ylabel("tank pressure  [bar, absolute]")
    lower.set(xlabel="time  [s]", ylabel="gas temperature  [°C]")
    figure.align_ylabels([upper, lower])
    return figure


def _sheet(limits: tuple[float, float, float, float], label: str) -> tuple[Figure, Any]:
    figure = new_figure(6.2, 3.9)
    axes = axes_in(figure, 0.7, 0.15, 5.3, 3.2)
    axes.axis(limits)
    axes.set(xticks=np.arange(0.0, 1.01, 0.1), xlabel="stroke of the poppet x  [mm]", ylabel=label)
    return figure, axes


def _points(axes: Any, values: list[float]) -> None:
    strokes = [1e3 * x for x in runs.STROKES]
    marker = {"marker": "o", "linestyle": "none", "markerfacecolor": "white", "markersize": 4.5, "clip_on": False}
    axes.plot(strokes, values, color=_BLUE, zorder=4, label="table", **marker)
