"""Safety audits and fault tables as text for terminals."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import TypeVar

from poppet.audit.fault_result import FaultTable
from poppet.audit.safety_result import ExhaustTime, SafetyAudit, Travel
from poppet.core.codes import Note
from poppet.report.audit.safety_report import NORMAL, distance_text, time_text
from poppet.report.tables import ReportTable, numeric

Row = TypeVar("Row", ExhaustTime, Travel)


def safety_text(audit: SafetyAudit) -> str:
    """Return the worst exhaust times and travels of an audit, in normal operation and with one fault."""
    events = " and ".join(event.shown for event in audit.events)
    count = len(audit.moments)
    moments = f"at t = {audit.moments[0].time:.6g} s" if count == 1 else f"at {count} moments; each row has the worst"
    lines = [audit.title] if audit.title else []
    lines += [f"Event {events}, {moments}.", ""]
    tables = (
        (f"Time until the pressure remains below {audit.threshold / 1e5:.4g} bar g:", _times(audit)),
        ("Distance that each body still travels:", _travels(audit)),
    )
    for title, table in tables:
        lines += [title, table.text(), ""] if table else []
    return "\n".join([*lines, str(Note("safety.statement"))])


def _times(audit: SafetyAudit) -> ReportTable:
    rows = []
    for normal, worst in _with_worst(audit.exhaust, lambda row: row.volume, lambda row: row.time):
        cells = [normal.volume, time_text(normal, audit.duration), _when(normal)]
        shown = worst if worst and normal.is_exhausted else normal
        cells += [time_text(worst, audit.duration), worst.fault] if worst else ["", ""]
        reason = {"trapped": "trapped by", "supplied": "supplied by", "falling": "still falling through"}
        rows.append([*cells, f"{reason[shown.reason]} {', '.join(shown.by)}" if shown.reason else ""])
    return ReportTable(("volume", *numeric(NORMAL), "event at", *numeric("one fault"), "fault", "cause"), rows)


def _travels(audit: SafetyAudit) -> ReportTable:
    rows = []
    for normal, worst in _with_worst(audit.travel, lambda row: row.body, lambda row: row.distance):
        rows.append(
            [normal.body, distance_text(normal), _when(normal), distance_text(worst), worst.fault if worst else ""]
        )
    return ReportTable(("body", *numeric(NORMAL), "event at", *numeric("one fault"), "fault"), rows)


def _when(row: ExhaustTime | Travel) -> str:
    return f"{row.moment.time:.4g} s" + (f", step {row.moment.step}" if row.moment.step else "")


def _with_worst(
    rows: Iterable[Row], name_of: Callable[[Row], str], value_of: Callable[[Row], float]
) -> list[tuple[Row, Row | None]]:
    """Return each row of normal operation, with the row of its worst fault; an unknown value is the worst."""

    def size(row: Row) -> tuple[bool, float]:
        return math.isnan(value_of(row)), value_of(row)

    by_name: dict[str, list[Row]] = {}
    for row in rows:
        by_name.setdefault(name_of(row), []).append(row)
    return [
        (normal, max((row for row in group if row.fault), key=size, default=None))
        for group in by_name.values()
        for normal in group
        if not normal.fault
    ]


def faults_text(table: FaultTable) -> str:
    """Return the consequences of all faults."""
    lines = [table.title] if table.title else []
    lines += [f"Each fault begins at t = {table.start:.6g} s; each run ends at t = {table.duration:.6g} s."]
    for row in table.rows:
        lines += ["", row.fault, *(f"- {consequence.note}" for consequence in row.consequences)]
    if table.omitted:
        names = ", ".join(f"{fault.valve}.{fault.word}" for fault in table.omitted)
        lines += ["", f"Not possible: {names}."]
    hidden = sum(row.is_hidden for row in table.rows)
    stopped = sum(row.stops_machine for row in table.rows)
    lines += ["", f"{len(table.rows)} faults: {stopped} stop a step sequence, {hidden} remain hidden."]
    return "\n".join(lines)
