"""Varga & Keski-Honkola 2012 recomputed: figures, tables, and every statement of the paper checked."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.ground.errors import InputError
from poppet.ground.files import write_whole
from poppet.ground.version import __version__
from poppet.report.tables import Column, Table
from poppet.report.varga2012.circuits import REPORTED_RISE, START_TEMPERATURE, STROKES, staircase_circuit
from poppet.report.varga2012.page import page
from poppet.report.varga2012.runs import Findings, find
from poppet.report.varga2012.statements import Statement, statements
from poppet.series.drawing.figures import figure_bytes, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FOLDER = "paper"


@dataclass(frozen=True)
class PaperResult:
    """What `write_paper` found and wrote.

    Parameters
    ----------
    folder : Path
        Where the files are.
    files : tuple of Path
        All of them; `report.html` first.
    findings : Findings
        The numbers, SI.
    tables : dict
        From name to table: strokes, tank_laws, wall_conductances, statements.
    statements : tuple of Statement
        With their verdicts.
    """

    folder: Path
    files: tuple[Path, ...]
    findings: Findings
    tables: dict[str, Table]
    statements: tuple[Statement, ...]

    def table(self) -> str:
        """Everything a terminal should show."""
        shown = [f"{table.title}\n\n{table.text()}" for name, table in self.tables.items() if name != "statements"]
        width = max(len(one.verdict.value) for one in self.statements)
        lines = [f"{one.verdict.value:<{width}}  {one.text} ({one.place})" for one in self.statements]
        return "\n\n".join([*shown, "Statements of the paper\n\n" + "\n".join(lines), f"Read {self.files[0]}"])


def write_paper(folder: str | Path = FOLDER, progress: Callable[[str], Any] | None = None) -> PaperResult:
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
    with style("The report on the paper"):
        _make(place)
        found = find(progress or _silent)
        (progress or _silent)("figures")
        pictures = dict(_figures(found))
        checked = statements(found)
        tables = _tables(found, checked)
        files = dict(_files(found, pictures, tables, checked))
    written = tuple(_written(place / name, content) for name, content in files.items())
    return PaperResult(place, written, found, tables, checked)


def _written(path: Path, content: bytes) -> Path:
    return write_whole(path, lambda stream: stream.write(content))


def _silent(text: str) -> None:
    """No progress."""


def _make(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as problem:
        reason = f"cannot be made a folder: {problem.strerror or problem}."
        raise InputError(f"folder {folder}", reason, "Choose another one.") from problem


def _figures(found: Findings) -> Iterator[tuple[str, Figure]]:
    from poppet.report.circuit.picture import draw_circuit
    from poppet.report.varga2012.figures import figure_3, figure_4, figure_6

    yield "fig3", figure_3()
    yield "fig4", figure_4()
    yield "fig6", figure_6(found)
    yield "circuit", draw_circuit(staircase_circuit(wall_conductance=round(found.wall.for_peak, 1)))


def _files(
    found: Findings, pictures: dict[str, Figure], tables: dict[str, Table], checked: tuple[Statement, ...]
) -> Iterator[tuple[str, bytes]]:
    drawn = {name: figure_bytes(figure, "svg", name) for name, figure in pictures.items()}
    yield "report.html", page({name: svg.decode() for name, svg in drawn.items()}, tables, checked).encode()
    yield "results.json", (json.dumps(_numbers(found, checked), indent=1) + "\n").encode()
    for name, figure in pictures.items():
        yield f"{name}.svg", drawn[name]
        yield f"{name}.png", figure_bytes(figure, "png", name)
    for name, table in tables.items():
        yield f"{name}.csv", table.csv().encode()
    yield "fig6.csv", _staircase_table(found).csv().encode()


def _numbers(found: Findings, checked: tuple[Statement, ...]) -> dict[str, Any]:
    numbers = {
        field.name: getattr(found, field.name)
        for field in dataclasses.fields(found)
        if field.name not in ("staircase", "fillings", "walls")
    }
    return {
        "paper": "Varga & Keski-Honkola 2012",
        "poppet": __version__,
        "units": "SI: Pa, K, s, m, kg/s, W/K, m^3/(s Pa); pressures absolute",
        "numbers": {"strokes": STROKES} | numbers,
        "tank_laws": {key: dataclasses.asdict(filling) for key, filling in found.fillings.items()},
        "wall_conductances": [dataclasses.asdict(wall) for wall in found.walls],
        "statements": [dataclasses.asdict(one) | {"verdict": one.verdict.value} for one in checked],
    }


def _tables(found: Findings, checked: tuple[Statement, ...]) -> dict[str, Table]:
    made = (_strokes(found), _tank_laws(found), _walls(found), _statement_table(checked))
    return {table.name: table for table in made}


def _strokes(found: Findings) -> Table:
    columns = Column("x [mm]", ".1f"), Column("C [1e-8 m^3/(s Pa)]", ".5f"), Column("b [1]", ".5f")
    rows = zip((1e3 * x for x in STROKES), (1e8 * c for c in found.conductances), found.ratios, strict=True)
    title = "Sonic conductance and critical pressure ratio, polynomials of Table 1 as printed"
    return Table("strokes", title, columns, tuple(rows))


def _tank_laws(found: Findings) -> Table:
    columns = (
        Column("tank law"),
        Column("time to 5 bar [s]", ".2f"),
        Column("ratio to isentrope [1]", ".2f"),
        Column("end [K]", ".2f"),
        Column("rise [K]", ".1f"),
        Column("peak [K]", ".2f"),
        Column("peak at [s]", ".1f"),
    )
    shortest = found.fillings["isentrope"].time
    rows = tuple(
        (
            one.law,
            one.time,
            one.time / shortest,
            one.end_temperature,
            one.end_temperature - START_TEMPERATURE,
            one.peak_temperature,
            one.peak_time if one.peak_temperature > START_TEMPERATURE else None,
        )
        for one in found.fillings.values()
    )
    title = "Filling the 0.2 m³ tank from 1 to 5 bar at 0.5 mm stroke; supply 7 bar, 293.15 K"
    return Table("tank_laws", title, columns, rows)


def _walls(found: Findings) -> Table:
    columns = (
        Column("supply [bar]", ".1f"),
        Column(f"h A, {REPORTED_RISE:.0f} K is the peak [W/K]", ".1f"),
        Column("peak at [s]", ".1f"),
        Column(f"h A, {REPORTED_RISE:.0f} K at 5 bar [W/K]", ".1f"),
    )
    rows = tuple((1e-5 * one.supply, one.for_peak, one.peak_time, one.for_end) for one in found.walls)
    title = f"Wall conductance that explains the reported rise of {REPORTED_RISE:.0f} K; wall at 293.15 K"
    return Table("wall_conductances", title, columns, rows)


def _statement_table(checked: tuple[Statement, ...]) -> Table:
    columns = Column("statement"), Column("where"), Column("finding"), Column("verdict")
    rows = tuple((one.text, one.place, one.finding, one.verdict.value) for one in checked)
    return Table("statements", "Statements of the paper", columns, rows)


def _staircase_table(found: Findings) -> Table:
    run = found.staircase
    headings = [f"{name} [{unit}]" for name, unit in zip(run.names, run.units, strict=True)]
    columns = Column("time [s]"), *(Column(heading) for heading in headings)
    rows = tuple(tuple(float(v) for v in row) for row in zip(run.time, *run.values, strict=True))
    return Table("fig6", "Figure 6", columns, rows)
