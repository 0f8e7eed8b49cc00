"""HTML report of a fault table: the consequences of every single fault."""

from __future__ import annotations

import html
from pathlib import Path

from poppet.audit.fault_result import FaultRow, FaultTable
from poppet.report.html_page import Section, document, findings, folded, head, paragraph, write_page
from poppet.report.styles import stylesheet
from poppet.report.tables import Column, Markup, ReportTable, code

_EFFECTS = {
    "Failed runs": ("failed", "run failed", "never"),
    "The machine stops: a step waits or times out": ("stops", "stops", "falls"),
    "A body moves without a command": ("moves_without_command", "moves", "never"),
    "A body does not reach its position, or passes it": ("position", "position", "never"),
    "A volume keeps its pressure": ("pressure_stays", "pressure stays", "never"),
    "A pressure is too high": ("pressure_high", "pressure high", "never"),
    "The fault remains hidden": ("hidden", "hidden", "open"),
}
"""Lines of the summary, with effect, label and style class of the mark in the table."""


def write_faults(table: FaultTable, path: str | Path) -> Path:
    """Write the report of a fault table as a self-contained HTML page.

    Parameters
    ----------
    table : FaultTable
        Consequences of all faults.
    path : str or Path
        File name with the suffix `.html`.

    Returns
    -------
    Path
        The written file.
    """
    return write_page(path, lambda: faults_page(table))


def faults_page(table: FaultTable) -> str:
    """Return the report of a fault table as HTML."""
    title = table.title or "Single faults"
    omitted = ReportTable(("fault", "reason"), [(code(f"{o.valve}.{o.word}"), o.reason) for o in table.omitted])
    partly = "" if table.is_whole else "The runs were interrupted: the table contains the completed runs."
    sections = [
        Section("", [head(title, _lead(table)), paragraph(partly, bold=True), _summary(table), findings(table.notes)]),
        *(Section(f"Faults of {html.escape(valve)}", consequence_table(table, valve)) for valve in _valves(table)),
        Section("Faults without a run", folded(f"Omitted faults ({len(table.omitted)})", omitted)),
    ]
    return document(title, sections, style=stylesheet("audit"))


def _valves(table: FaultTable) -> list[str]:
    return list(dict.fromkeys(row.valve for row in table.rows))


def _lead(table: FaultTable) -> str:
    cycle = f" A healthy cycle takes {table.cycle_time:.4g} s." if table.cycle_time is not None else ""
    return (
        f"Consequences of {len(table.rows)} single faults of {len(_valves(table))} valves. Each fault begins at t = "
        f"{table.start:.4g} s and is compared with the healthy run until t = {table.duration:.4g} s. A pressure stays "
        f"if it remains above {table.threshold / 1e5:.4g} bar g.{cycle}"
    )


def effects_of(row: FaultRow) -> set[str]:
    """Return the effects of a fault that the summary counts, such as `stops` or `hidden`."""
    kinds = {consequence.kind for consequence in row.consequences}
    effects = kinds & {"failed", "moves_without_command", "pressure_stays", "pressure_high"}
    effects |= {"position"} if kinds & {"not_reached", "overtravel"} else set()
    effects |= {"stops"} if row.stops_machine else set()
    return effects | ({"hidden"} if row.is_hidden else set())


def _summary(table: FaultTable) -> str:
    """Return the number of faults with each effect as HTML."""
    counts = [(line, sum(effect in effects_of(row) for row in table.rows)) for line, (effect, _, _) in _EFFECTS.items()]
    rows = [(line, f"{count} of {len(table.rows)}") for line, count in counts if count]
    return f'<div class="summary">{ReportTable(("", Column("", "s")), rows).html()}</div>\n'


def consequence_table(table: FaultTable, valve: str) -> ReportTable:
    """Return the consequences of all faults of a valve."""
    rows = []
    for row in table.rows:
        if row.valve != valve:
            continue
        effects = effects_of(row)
        marks = " ".join(
            f'<span class="verdict {kind}">{label}</span>'
            for effect, label, kind in _EFFECTS.values()
            if effect in effects
        )
        texts = "".join(f"<li>{html.escape(str(consequence.note))}</li>" for consequence in row.consequences)
        rows.append((code(row.word), Markup(marks), Markup(f"<ul>{texts}</ul>")))
    return ReportTable(("fault", "", "consequences"), rows)
