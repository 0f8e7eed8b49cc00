"""HTML report of a safety audit: exhaust times, travels and pressures after an event."""

from __future__ import annotations

import html
import math
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from poppet.audit.safety_result import ExhaustTime, Moment, SafetyAudit, SafetyCurves, Travel
from poppet.core.codes import Note
from poppet.report.html_page import Section, document, findings, folded, head, paragraph, picture, write_page
from poppet.report.styles import stylesheet
from poppet.report.tables import Column, Markup, ReportTable, code, numeric
from poppet.timeseries.plotting.figures import GREY, INK, PALETTE, axes_in, new_figure, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NORMAL = "normal operation"
MOST_CURVES = 10
"""Maximum number of volumes and of bodies in a figure: those with the longest times or the largest motion."""
SETTLED, MARGIN = 0.02, 1.25
"""Distance from its final value below which a curve has settled, and factor on this time for the end of the time axis.

The distance is relative to the largest range of a curve in the panel."""
_UNITS = {"m": ("mm", 1e3), "rad": ("deg", 180.0 / math.pi)}
_CAPTION = (
    "{kind} after the event, {case}; the event occurs {moment}.{most} Dashed: threshold of the pressure. Displacements "
    "are measured from the position at the event."
)


def write_safety(audit: SafetyAudit, path: str | Path) -> Path:
    """Write the report of a safety audit as a self-contained HTML page.

    Parameters
    ----------
    audit : SafetyAudit
        Result of the audit.
    path : str or Path
        File name with the suffix `.html`.

    Returns
    -------
    Path
        The written file.
    """
    return write_page(path, lambda: safety_page(audit))


def safety_page(audit: SafetyAudit) -> str:
    """Return the report of a safety audit as HTML."""
    title = audit.title or "Safety audit"
    with style("A report of a safety audit"):
        start = [
            head(title, _lead(audit)),
            paragraph(str(Note("safety.statement"))),
            _summary(audit),
            findings(audit.notes),
        ]
        sections = [
            Section("", start),
            Section("Exhaust times", [exhaust_table(audit), folded("All faults", fault_time_table(audit))]),
            Section("Travels", [travel_table(audit), folded("All faults", fault_travel_table(audit))]),
            Section("Curves", _curve_figures(audit)),
            Section("Moments of the event", _moment_table(audit)),
        ]
    return document(title, sections, style=stylesheet("audit"))


def _lead(audit: SafetyAudit) -> str:
    events = " and ".join(event.shown for event in audit.events)
    count = len(audit.moments)
    moments = _at(audit.moments[0]) if count == 1 else f"at {count} moments, of which each table shows the worst"
    faults = "one fault" if len(audit.faults) == 1 else f"each of {len(audit.faults)} single faults"
    text = (
        f"Safety audit: after the event {events}, {moments}. Exhausted means below {audit.threshold / 1e5:.4g} bar g "
        f"for the rest of the {audit.duration:.4g} s after the event. Simulated in {NORMAL}"
    )
    return f"{text} and with {faults}." if audit.faults else f"{text}."


def _at(moment: Moment) -> str:
    return f"at t = {moment.time:.4g} s" + (f" (step {moment.step})" if moment.step else "")


def time_text(row: ExhaustTime | None, duration: float) -> str:
    """Return an exhaust time as text, with its 95 % interval."""
    if row is None:
        return ""
    return _interval(_time(row.time, duration), row.low, row.high, lambda value: _time(value, duration))


def _time(value: float, duration: float) -> str:
    if math.isnan(value):
        return "run failed"
    return f"{value:.3g} s" if math.isfinite(value) else f"not within {duration:.4g} s"


def _interval(text: str, low: float | None, high: float | None, shown: Callable[[float], str]) -> str:
    # An interval of equal texts adds nothing, for example if no sample is exhausted.
    if low is None or high is None or (shown(low) == shown(high) and shown(low) in text):
        return text
    return f"{text} ({shown(low)} to {shown(high)})"


def distance_text(row: Travel | None) -> str:
    """Return a travel as text, with its 95 % interval."""
    if row is None:
        return ""
    unit, factor = _UNITS.get(row.unit, (row.unit, 1.0))

    def shown(value: float) -> str:
        if math.isnan(value):
            return "run failed"
        if math.isinf(value):
            return "does not stop"
        return f"{value * factor:z.3g} {unit}" if abs(value * factor) < 1e3 else f"{value * factor:.0f} {unit}"

    if math.isinf(row.distance):
        return f"does not stop: {shown(row.path)} so far"
    return _interval(shown(row.distance), row.low, row.high, shown)


def _verdict(text: str, is_good: bool) -> Markup:
    """Return a cell that marks an unsafe result."""
    return Markup(html.escape(text) if is_good else f'<span class="verdict never">{html.escape(text)}</span>')


def _worst(rows: Iterable[ExhaustTime | Travel]) -> ExhaustTime | Travel | None:
    """Return the row with the largest time or distance; a failed run counts as infinite."""
    return max(rows, key=_size, default=None)


def _size(row: ExhaustTime | Travel) -> float:
    value = row.time if isinstance(row, ExhaustTime) else row.distance
    return math.inf if math.isnan(value) else value


def _summary(audit: SafetyAudit) -> str:
    """Return the longest exhaust times and travels as HTML."""
    rows = []
    for label, is_normal in ((NORMAL, True), ("a single fault", False)):
        times = [row for row in audit.exhaust if (row.fault == "") == is_normal]
        travels = [row for row in audit.travel if (row.fault == "") == is_normal]
        if (longest := _worst(times)) is not None and isinstance(longest, ExhaustTime):
            text = _verdict(time_text(longest, audit.duration), longest.is_exhausted)
            where = ", ".join(filter(None, (longest.volume, longest.fault)))
            rows.append((f"Longest exhaust, {label}", text, where))
        if (farthest := _worst(travels)) is not None and isinstance(farthest, Travel):
            text = _verdict(distance_text(farthest), farthest.is_stopped)
            where = ", ".join(filter(None, (farthest.body, farthest.fault)))
            rows.append((f"Longest travel, {label}", text, where))
    table = ReportTable(("", Column("", "s"), ""), rows).html()
    return f'<div class="summary">{table}</div>\n'


def exhaust_table(audit: SafetyAudit) -> ReportTable:
    """Return the exhaust time of each volume in normal operation and with its worst fault."""
    rows = []
    for volume in audit.volumes:
        normal = audit.exhaust_of(volume)
        worst = _worst(row for row in audit.exhaust if row.volume == volume and row.fault)
        pressures = f"{round(normal.start_pressure / 1e5, 3):z.3g} → {round(normal.end_pressure / 1e5, 3):z.3g}"
        cells = [code(volume), _verdict(time_text(normal, audit.duration), normal.is_exhausted), pressures]
        if isinstance(worst, ExhaustTime):
            cells += [_verdict(time_text(worst, audit.duration), worst.is_exhausted), code(worst.fault)]
            cells.append(_reason(worst if normal.is_exhausted else normal))
        else:
            cells += ["", "", _reason(normal)]
        rows.append(cells)
    caption = "Time until the pressure stays below the threshold, in normal operation and with the worst single fault."
    columns = numeric(NORMAL, "pressure [bar g]", "worst fault")
    return ReportTable(("volume", *columns, "fault", "reason"), rows, caption)


def _reason(row: ExhaustTime) -> str:
    return " by ".join(filter(None, (row.reason, ", ".join(row.by))))


def travel_table(audit: SafetyAudit) -> ReportTable:
    """Return the travel of each body in normal operation and with its worst fault."""
    rows = []
    for body in audit.bodies:
        normal = audit.travel_of(body)
        worst = _worst(row for row in audit.travel if row.body == body and row.fault)
        stop = "" if not math.isfinite(normal.stop_time) else f"{normal.stop_time:.3g} s"
        cells = [code(body), _verdict(distance_text(normal), normal.is_stopped), stop]
        cells += (
            [_verdict(distance_text(worst), worst.is_stopped), code(worst.fault)]
            if isinstance(worst, Travel)
            else ["", ""]
        )
        rows.append(cells)
    caption = "Distance that each body travels after the event, in normal operation and with the worst single fault."
    return ReportTable(("body", *numeric(NORMAL, "stops after", "worst fault"), "fault"), rows, caption)


def fault_time_table(audit: SafetyAudit) -> ReportTable:
    """Return the exhaust time of each volume with each fault."""
    rows = [
        (
            code(fault or NORMAL),
            *(_verdict(time_text(row, audit.duration), row.is_exhausted) for row in _of(audit, fault)),
        )
        for fault in ("", *audit.faults)
        if _of(audit, fault)
    ]
    return ReportTable(("fault", *numeric(*audit.volumes)), rows)


def _of(audit: SafetyAudit, fault: str) -> Sequence[ExhaustTime]:
    rows = {row.volume: row for row in audit.exhaust if row.fault == fault}
    return [rows[volume] for volume in audit.volumes] if len(rows) == len(audit.volumes) else []


def fault_travel_table(audit: SafetyAudit) -> ReportTable:
    """Return the travel of each body with each fault."""
    rows = []
    for fault in ("", *audit.faults):
        travels = {row.body: row for row in audit.travel if row.fault == fault}
        if travels and len(travels) == len(audit.bodies):
            cells = [_verdict(distance_text(travels[body]), travels[body].is_stopped) for body in audit.bodies]
            rows.append((code(fault or NORMAL), *cells))
    return ReportTable(("fault", *numeric(*audit.bodies)), rows)


def _moment_table(audit: SafetyAudit) -> ReportTable | str:
    if len(audit.moments) < 2:
        return ""
    rows = [(f"{moment.time:.5g}", moment.step) for moment in audit.moments]
    return ReportTable((Column("time [s]", "s"), "step"), rows)


def _curve_figures(audit: SafetyAudit) -> str:
    """Return figures of normal operation and of the fault with the longest exhaust, as HTML."""
    worst = _worst(row for row in audit.exhaust if row.fault)
    faults = ["", worst.fault] if worst is not None else [""]
    figures = ""
    for number, fault in enumerate(faults):
        curves = next((curves for curves in audit.curves if curves.fault == fault), None)
        if curves is None or not curves.time.size:
            continue
        case = f"with {fault}" if fault else f"in {NORMAL}"
        series = len(curves.pressures), len(curves.positions)
        is_reduced = max(series) > MOST_CURVES
        most = f" Only {MOST_CURVES} are drawn: the slowest volumes, and the largest motions." if is_reduced else ""
        kind = "Pressures and positions" if curves.positions else "Pressures"
        caption = _CAPTION.format(kind=kind, case=case, moment=_at(curves.moment), most=most)
        figures += picture(curve_figure(audit, curves), f"curves-{number}", caption)
    return figures


def curve_figure(audit: SafetyAudit, curves: SafetyCurves) -> Figure:
    """Draw the pressures and the displacements of one case versus the time from the event."""
    times = {row.volume: _size(row) for row in audit.exhaust if row.fault == curves.fault}
    volumes = sorted(curves.pressures, key=lambda name: -times.get(name, 0.0))[:MOST_CURVES]
    bodies = sorted(curves.positions, key=lambda name: -float(np.ptp(curves.positions[name])))[:MOST_CURVES]
    units = list(dict.fromkeys(row.unit for row in audit.travel if row.body in bodies))
    unit_of = {row.body: row.unit for row in audit.travel}
    panels: list[tuple[str, list[tuple[str, np.ndarray]]]] = [
        ("pressure [bar g]", [(name, curves.pressures[name] / 1e5) for name in volumes])
    ]
    for unit in units:
        shown, factor = _UNITS.get(unit, (unit, 1.0))
        lines = [
            (name, (curves.positions[name] - curves.positions[name][0]) * factor)
            for name in bodies
            if unit_of[name] == unit
        ]
        panels.append((f"displacement [{shown}]", lines))
    end = _shown_duration(audit, curves, [[values for _, values in lines] for _, lines in panels])
    height, gap = 2.4, 0.3
    figure = new_figure(9.0, 0.3 + len(panels) * (height + gap) + 0.3)
    for k, (label, lines) in enumerate(panels):
        axes = axes_in(figure, 0.8, 0.2 + k * (height + gap), 6.0, height)
        for n, (name, values) in enumerate(lines):
            axes.plot(curves.time, values, color=PALETTE[n % len(PALETTE)], label=name)
        if k == 0:
            axes.axhline(audit.threshold / 1e5, color=INK, linewidth=1.0, linestyle=(0, (5, 3)))
        else:
            axes.axhline(0.0, color=GREY, linewidth=0.8)
        axes.set_ylabel(label)
        axes.set_xlim(0.0, end)
        axes.tick_params(labelbottom=k == len(panels) - 1)
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0)
    axes.set_xlabel("time from the event [s]")
    return figure


def _shown_duration(audit: SafetyAudit, curves: SafetyCurves, panels: Iterable[Sequence[np.ndarray]]) -> float:
    """Return the time until all curves have settled and all exhaust times are over, with a margin."""
    times = [
        row.time
        for row in audit.exhaust
        if (row.fault, row.moment) == (curves.fault, curves.moment) and math.isfinite(row.time)
    ]
    for panel in panels:
        size = max((float(np.ptp(values)) for values in panel), default=0.0)
        for values in panel:
            moving = np.flatnonzero(np.abs(values - values[-1]) > SETTLED * size)
            times += [float(curves.time[moving[-1]])] if moving.size else []
    end = float(curves.time[-1])
    return min(MARGIN * max(times, default=0.0), end) or end
