"""Varga & Keski-Honkola 2012 recomputed: a page with figures, tables and every statement of the paper checked."""

from __future__ import annotations

import dataclasses
import html
import json
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet import library
from poppet.core.errors import InputError
from poppet.core.files import write_whole
from poppet.core.message_format import sentence
from poppet.core.version import __version__
from poppet.report.html_page import document, head, picture, table
from poppet.report.tables import Column, Table
from poppet.report.varga2012 import runs
from poppet.report.varga2012.statements import Statement, Verdict, statements
from poppet.timeseries.plotting.figures import FAINT, GREY, INK, PALETTE, axes_in, figure_bytes, new_figure, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FOLDER = "paper"

# Axes as the tick labels of the figures print them.
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
_STYLE = """
main { max-width: 58rem; } p, figcaption { max-width: 46rem; }
.headline { font-size: 1.15rem; font-weight: 600; border-left: .4rem solid #1f5fa8; padding: .4rem 0 .4rem 1rem; }
.plain td:first-child { white-space: nowrap; } .plain th.number { max-width: 10rem; }
.statements table { width: 100%; } .statements td:nth-child(1) { width: 30%; }
.statements td:nth-child(2) { width: 15%; color: var(--soft); }
.holds { background: #e3f3e8; color: #14532d; }
.fails { background: #fbe6e1; color: #8a2411; }
.open { background: #eceef1; color: #3f4852; }
"""


@dataclass(frozen=True)
class PaperResult:
    """What `write_paper` found and wrote."""

    folder: Path
    files: tuple[Path, ...]  # `report.html` first
    findings: runs.Findings  # the numbers, SI
    tables: dict[str, Table]  # by name: strokes, tank_laws, wall_conductances, statements
    statements: tuple[Statement, ...]  # with their verdicts

    def table(self) -> str:
        """Everything a terminal should show."""
        shown = [f"{one.title}\n\n{one.text()}" for name, one in self.tables.items() if name != "statements"]
        width = max(len(one.verdict.value) for one in self.statements)
        lines = [f"{one.verdict.value:<{width}}  {one.text} ({one.place})" for one in self.statements]
        return "\n\n".join([*shown, "Statements of the paper\n\n" + "\n".join(lines), f"Read {self.files[0]}"])


def write_paper(folder: str | Path = FOLDER, progress: Callable[[str], Any] = lambda step: None) -> PaperResult:
    """Recompute the paper and write a report: a page, figures, tables, numbers.

    Notes
    -----
    Nothing is read from a table of results: every number is simulated while the report is written. What the
    paper does not print (supply pressure, required values, mechanics, exhaust) is assumed, and the page says
    so.

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
    place = Path(folder)
    with style("The report on the paper"):  # before anything is run: drawing may not be installed
        try:
            place.mkdir(parents=True, exist_ok=True)
        except OSError as problem:
            raise InputError("paper.folder", path=str(place), why=problem.strerror or str(problem)) from problem
        found = runs.find(progress)
        progress("figures")
        checked = statements(found)
        tables = {one.name: one for one in _tables(found, checked)}
        files = dict(_files(found, dict(_pictures(found)), tables, checked))
    written = tuple(_written(place / name, content) for name, content in files.items())
    return PaperResult(place, written, found, tables, checked)


def _written(path: Path, content: bytes) -> Path:
    return write_whole(path, lambda stream: stream.write(content))


def _files(
    found: runs.Findings, pictures: Mapping[str, Figure], tables: Mapping[str, Table], checked: Sequence[Statement]
) -> Iterator[tuple[str, bytes]]:
    """Name and content of every file, the page first."""
    drawn = {name: figure_bytes(figure, "svg", name) for name, figure in pictures.items()}
    yield "report.html", _page(found, pictures, tables, checked).encode()
    yield "results.json", (json.dumps(_numbers(found, checked), indent=1) + "\n").encode()
    for name, figure in pictures.items():
        yield f"{name}.svg", drawn[name]
        yield f"{name}.png", figure_bytes(figure, "png", name)
    for name, listed in tables.items():
        yield f"{name}.csv", listed.csv().encode()
    run = found.staircase
    headings = ["time [s]", *(f"{name} [{unit}]" for name, unit in zip(run.names, run.units, strict=True))]
    rows = tuple(tuple(map(float, row)) for row in zip(run.time, *run.values, strict=True))
    yield "fig6.csv", Table("fig6", "Figure 6", tuple(map(Column, headings)), rows).csv().encode()


def _numbers(found: runs.Findings, checked: Sequence[Statement]) -> dict[str, Any]:
    names = [field.name for field in dataclasses.fields(found)]
    numbers = {name: getattr(found, name) for name in names if name not in ("staircase", "fillings", "walls")}
    return {
        "paper": "Varga & Keski-Honkola 2012",
        "poppet": __version__,
        "units": "SI: Pa, K, s, m, kg/s, W/K, m^3/(s Pa); pressures absolute",
        "numbers": {"strokes": runs.STROKES} | numbers,
        "tank_laws": {key: dataclasses.asdict(filling) for key, filling in found.fillings.items()},
        "wall_conductances": [dataclasses.asdict(wall) for wall in found.walls],
        "statements": [
            {key: getattr(one, key) for key in ("code", "text", "place", "finding")} | {"verdict": one.verdict.value}
            for one in checked
        ],
    }


# --- Tables ---


def _tables(found: runs.Findings, checked: Sequence[Statement]) -> Iterator[Table]:
    yield Table(
        "strokes",
        "Sonic conductance and critical pressure ratio, polynomials of Table 1 as printed",
        (Column("x [mm]", ".1f"), Column("C [1e-8 m^3/(s Pa)]", ".5f"), Column("b [1]", ".5f")),
        tuple(zip((1e3 * x for x in runs.STROKES), (1e8 * c for c in found.conductances), found.ratios, strict=True)),
    )
    start, shortest = runs.START_TEMPERATURE, found.fillings["isentrope"].time
    heads = ("time to 5 bar [s]", ".2f"), ("ratio to isentrope [1]", ".2f"), ("end [K]", ".2f"), ("rise [K]", ".1f")
    yield Table(
        "tank_laws",
        "Filling the 0.2 m³ tank from 1 to 5 bar at 0.5 mm stroke; supply 7 bar, 293.15 K",
        (Column("tank law"), *(Column(*h) for h in heads), Column("peak [K]", ".2f"), Column("peak at [s]", ".1f")),
        tuple(
            (
                one.law, one.time, one.time / shortest, one.end_temperature, one.end_temperature - start,
                one.peak_temperature, one.peak_time if one.peak_temperature > start else None,
            )
            for one in found.fillings.values()
        ),
    )  # fmt: skip
    yield Table(
        "wall_conductances",
        f"Wall conductance that explains the reported rise of {runs.REPORTED_RISE:.0f} K; wall at 293.15 K",
        (
            Column("supply [bar]", ".1f"), Column(f"h A, {runs.REPORTED_RISE:.0f} K is the peak [W/K]", ".1f"),
            Column("peak at [s]", ".1f"), Column(f"h A, {runs.REPORTED_RISE:.0f} K at 5 bar [W/K]", ".1f"),
        ),
        tuple((1e-5 * one.supply, one.for_peak, one.peak_time, one.for_end) for one in found.walls),
    )  # fmt: skip
    yield Table(
        "statements",
        "Statements of the paper",
        (Column("statement"), Column("where"), Column("finding"), Column("verdict")),
        tuple((one.text, one.place, one.finding, one.verdict.value) for one in checked),
    )


# --- Page ---


def _headline(found: runs.Findings, checked: Sequence[Statement]) -> str:
    """What became of the paper, in a line, and the numbers that matter most."""
    counts, times = Counter(one.verdict for one in checked), found.fillings
    tally = {"holds": counts[Verdict.HOLDS], "fails": counts[Verdict.FAILS], "unknown": counts[Verdict.OPEN]}
    facts = {
        "isentrope": times["isentrope"].time,
        "adiabatic": times["adiabatic"].time,
        "walled": times["wall of the peak"].time,
        "reported": runs.REPORTED_RISE,
        "share": 100.0 * found.conductances[0] / found.largest[1],
    }
    first = html.escape(sentence("paper.page.headline", {"count": len(checked), **tally}))
    return f'<p class="headline">{first}</p>\n<p>{html.escape(sentence("paper.page.main", facts))}</p>\n'


def _page(
    found: runs.Findings, pictures: Mapping[str, Figure], tables: Mapping[str, Table], checked: Sequence[Statement]
) -> str:
    """Headline and the three figures first, then every statement, then tables and circuit."""
    words = {name: sentence(f"paper.page.{name}", {}) for name in ("title", "source", "choices", "tanks")}
    mark = '<span class="verdict {}">{}</span>'
    verdicts = [mark.format(one.verdict.name.lower(), one.verdict.value) for one in checked]
    texts = [map(html.escape, (one.text, one.place, one.finding)) for one in checked]
    rows = [[*text, verdict] for text, verdict in zip(texts, verdicts, strict=True)]
    statement_table = table(["The paper says", "Where", "What we find", "Verdict"], rows, kind="statements")
    tank_tables = tables["tank_laws"].html() + tables["wall_conductances"].html()

    def shown(name: str, kind: str = "") -> str:
        return picture(pictures[name], name, sentence(f"paper.caption.{name}", {}), kind=kind)

    sections = [
        ("", head(words["title"], words["source"]) + _headline(found, checked)),
        ("The three figures of the paper", shown("fig3", "narrow") + shown("fig4", "narrow") + shown("fig6")),
        ("Statements of the paper", statement_table),
        ("Flow characteristic", tables["strokes"].html()),
        ("Tank laws", f"<p>{words['tanks']}</p>\n{tank_tables}"),
        ("What was simulated", f"<p>{words['choices']}</p>\n" + shown("circuit")),
    ]
    return document(words["title"], sections, style=_STYLE)


# --- Figures ---


def _pictures(found: runs.Findings) -> Iterator[tuple[str, Figure]]:
    from poppet.report.circuit.schematic import draw_circuit

    yield "fig3", figure_3()
    yield "fig4", figure_4()
    yield "fig6", figure_6(found)
    yield "circuit", draw_circuit(runs.staircase_circuit(wall_conductance=round(found.wall.for_peak, 1)))


def figure_3() -> Figure:
    """Sonic conductance over the stroke."""
    figure, axes = _sheet(FIG3_AXES, "sonic conductance C  [1e-8 m³/(s Pa)]")
    strokes = np.concatenate((np.linspace(0.0, 0.03e-3, 121), np.linspace(0.03e-3, 1e-3, 400)))
    printed, closed = library.characteristic("varga2012"), library.characteristic("varga2012.closed")
    alternative = 1e8 * np.asarray(runs.suspected().sonic_conductance_at(strokes))
    axes.plot(1e3 * strokes, alternative, color="#b9bec7", linestyle=(0, (5, 2.5)), linewidth=1.3, label="k5 changed")
    axes.plot(
        1e3 * strokes, 1e8 * printed.sonic_conductance_at(strokes), color=_BLUE, linewidth=2.0, label="as printed"
    )
    # The two differ only where the closed one closes.
    near = strokes[strokes <= closed.numbers()["closing"].value]
    axes.plot(
        1e3 * near, 1e8 * closed.sonic_conductance_at(near), color=_RED, linestyle=(0, (2.2, 1.2)), label="closed"
    )
    _points(axes, [1e8 * float(printed.sonic_conductance_at(x)) for x in runs.STROKES])
    axes.text(0.985, 1.925, "hypothesis: k5 = -2.2229e-6", ha="right", color=GREY, fontsize=8.5)
    axes.text(0.44, 1.52, "polynomial of Table 1 as printed", color=_BLUE, fontsize=8.5, va="top")
    note = "closed variant: C = 0 at x = 0,\nas printed from 0.02 mm on"
    arrow = {"arrowstyle": "-", "color": _RED, "linewidth": 0.8, "shrinkB": 2}
    axes.annotate(note, (0.0135, 0.45), (0.09, 0.56), color=_RED, fontsize=8.5, va="center", arrowprops=arrow)
    return figure


def figure_4() -> Figure:
    """Critical pressure ratio over the stroke."""
    figure, axes = _sheet(FIG4_AXES, "critical pressure ratio b  [1]")
    strokes = np.linspace(0.0, 1e-3, 500)
    printed = library.characteristic("varga2012")
    axes.plot(1e3 * strokes, printed.critical_ratio_at(strokes), color=_BLUE, linewidth=2.0, label="as printed")
    _points(axes, [float(printed.critical_ratio_at(x)) for x in runs.STROKES])
    axes.text(0.1, 0.57, "polynomial of Table 1 as printed", color=_BLUE, fontsize=8.5)
    return figure


def figure_6(findings: runs.Findings) -> Figure:
    """Tank pressure over time on the axes of fig. 6, and below it the temperature of the gas."""
    figure = new_figure(7.4, 5.9)
    upper = axes_in(figure, 0.75, 0.15, 6.45, 3.3)
    lower = axes_in(figure, 0.75, 3.65, 6.45, 1.7, sharex=upper)
    run = findings.staircase
    look: dict[str, Any] = {"color": INK, "linewidth": 1.2, "drawstyle": "steps-post"}
    upper.plot(run.time, 1e-5 * run["required.pressure"], label="required value", **look)
    for name, label, colour, line in _TANKS:
        note = f" ({findings.wall.for_peak:.1f} W/K)" if name == "wall" else ""
        look = {"color": colour, "linestyle": line, "linewidth": 1.5}
        upper.plot(run.time, 1e-5 * run[f"{name}.pressure"], label=label + note, **look)
        lower.plot(run.time, run[f"{name}.temperature"] - 273.15, label=label, **look)
    lower.axhline(20.0 + 18.0, color=GREY, linewidth=0.8, linestyle=(0, (2, 2)))
    lower.text(119.0, 43.0, "20 °C + 18 °C, the rise the paper reports", color=GREY, fontsize=8, ha="right")
    upper.axis(FIG6_AXES)
    upper.set_yticks(np.arange(1.0, 5.6, 0.5))
    upper.tick_params(labelbottom=False)
    upper.legend(loc="lower right", fontsize=8.5, facecolor="white", frameon=True, edgecolor=FAINT, framealpha=1.0)
    upper.set_ylabel("tank pressure  [bar, absolute]")
    lower.set_ylabel("gas temperature  [°C]")
    lower.set_xlabel("time  [s]")
    figure.align_ylabels([upper, lower])
    return figure


def _sheet(limits: tuple[float, float, float, float], label: str) -> tuple[Figure, Any]:
    figure = new_figure(6.2, 3.9)
    axes = axes_in(figure, 0.7, 0.15, 5.3, 3.2)
    axes.axis(limits)
    axes.set_xticks(np.arange(0.0, 1.01, 0.1))
    axes.set_xlabel("stroke of the poppet x  [mm]")
    axes.set_ylabel(label)
    return figure, axes


def _points(axes: Any, values: list[float]) -> None:
    strokes = [1e3 * x for x in runs.STROKES]
    axes.plot(
        strokes,
        values,
        "o",
        color=_BLUE,
        markerfacecolor="white",
        markersize=4.5,
        clip_on=False,
        zorder=4,
        label="table",
    )
