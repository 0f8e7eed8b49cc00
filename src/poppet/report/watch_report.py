"""HTML report of a watch: alarms, faults over time, residuals, baseline, and what the sensors can distinguish."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from poppet.core.message_format import sentence
from poppet.core.number_format import digits_of, readable_unit, scaled, value_with_error
from poppet.monitoring.baseline import Baseline
from poppet.monitoring.isolable import Isolability
from poppet.monitoring.record import WatchRecord
from poppet.report.html_page import Section, document, findings, folded, head, paragraph, picture, write_page
from poppet.report.tables import Column, ReportTable, code, numeric
from poppet.report.watch_figures import faults_figure, probabilities_figure, residuals_figure, signatures_figure
from poppet.report.watch_text import alarm_rows, estimate_rows, size_text
from poppet.timeseries.plotting.figures import style


def write_watch(
    record: WatchRecord, baseline: Baseline, path: str | Path, isolability: Isolability | None = None
) -> Path:
    """Write the report of a watch as a self-contained HTML page.

    Parameters
    ----------
    record : WatchRecord
        Estimates of all samples of a recording.
    baseline : Baseline
        Healthy state of the plant.
    path : str or Path
        File name with the suffix `.html`.
    isolability : Isolability, optional
        Faults that the sensors can distinguish.

    Returns
    -------
    Path
        The written file.
    """
    return write_page(path, lambda: watch_page(record, baseline, isolability))


def watch_page(record: WatchRecord, baseline: Baseline, isolability: Isolability | None = None) -> str:
    """Return the report of a watch as HTML.

    Equal records give equal bytes.
    """
    with style("A report of a watch"):
        sections = [
            Section("", [_head(record), findings(record.notes)]),
            Section("Alarms", _alarms(record, baseline)),
            Section("Faults over time", _faults(record, baseline)),
            Section("Residuals", _residuals(record, baseline)),
            Section("Distinguishable faults", _isolability(isolability)),
            Section("Baseline", _baseline(baseline)),
            Section("Limits", paragraph(sentence("watch.page.limits", {}))),
        ]
    return document(record.title or "Condition monitoring", sections)


def _head(record: WatchRecord) -> str:
    title = record.title or "Condition monitoring"
    if not len(record):
        return head(title, "No sample could be used.")
    count = len(record.episodes)
    alarms = f"{count} alarm{'s' * (count > 1)}" if count else "no alarm"
    text = head(title, f"{len(record)} samples from {record.time[0]:.6g} to {record.time[-1]:.6g} s: {alarms}.")
    if not record.is_complete:
        text += paragraph("The evaluation was interrupted. Later samples are missing.", bold=True)
    if record.verdicts:
        time, note = record.verdicts[-1]
        text += paragraph(f"Last verdict, at {time:.6g} s: {note}")
    return text


def _alarms(record: WatchRecord, baseline: Baseline) -> list[str | ReportTable]:
    headings: list[Column | str] = ["fault", *numeric("from [s]", "to [s]", "change", "alarm size", "probability")]
    rows = alarm_rows(record, baseline)
    changes = ReportTable((*numeric("time [s]"), "verdict"), [(f"{t:.6g}", str(note)) for t, note in record.verdicts])
    return [
        ReportTable(headings, rows) if rows else paragraph("No alarm."),
        folded(f"All verdicts ({len(changes.rows)})", changes),
    ]


def _faults(record: WatchRecord, baseline: Baseline) -> list[str | ReportTable]:
    if not len(record):
        return []
    heading, *rows = estimate_rows(record, baseline)
    return [
        picture(faults_figure(record, baseline), "faults", sentence("watch.page.faults", {})),
        picture(probabilities_figure(record), "probabilities", sentence("watch.page.probabilities", {})),
        ReportTable((*heading[:2], *numeric(*heading[2:])), rows, caption="Estimates at the end"),
    ]


def _residuals(record: WatchRecord, baseline: Baseline) -> list[str | ReportTable]:
    if not len(record):
        return []
    rows = []
    for k, channel in enumerate(record.plan.channels):
        used = record.used[:, k] > 0
        residual = ((record.readings[:, k] - record.expected[:, k]) / record.deviations[:, k])[used]
        rms = float(np.sqrt(np.mean(residual**2))) if residual.size else None
        missing = np.isnan(record.readings[:, k])
        counts = (int(np.count_nonzero(which)) for which in (used, missing, record.used[:, k] == -1))
        rows.append((code(channel.address), *counts, rms))
    n_used = int(record.counts.sum())
    nis = f"{float(np.nansum(record.nis)) / n_used:.3g}" if n_used else "not defined"
    facts = {"nis": nis, "healthy": f"{baseline.healthy_nis:.3g}"}
    return [
        picture(residuals_figure(record), "residuals", sentence("watch.page.residuals", {})),
        ReportTable(
            ("sensor", *numeric("used", "missing", "outliers", digits="d"), *numeric("rms [sd]", digits=".3g")), rows
        ),
        paragraph(sentence("watch.page.nis", facts)),
    ]


def _isolability(isolability: Isolability | None) -> list[str | ReportTable]:
    if isolability is None:
        return []
    rows = []
    for fault in isolability.faults.values():
        sds = (f"{sd / fault.alarm:.2g}" if np.isfinite(sd) else "infinite" for sd in (fault.sd_alone, fault.sd_free))
        angle = f"{fault.angle:.3g}" if fault.nearest else "-"
        rows.append(
            (fault.name, size_text(fault.alarm, fault.unit), *sds, fault.nearest or "-", angle, str(fault.note))
        )
    headings: list[Column | str] = [
        "fault", *numeric("alarm size", "sd alone [alarm size]", "sd if all are free [alarm size]"), "nearest fault",
        *numeric("angle [deg]"), "verdict",
    ]  # fmt: skip
    return [
        picture(signatures_figure(isolability), "signatures", sentence("watch.page.signatures", {})),
        ReportTable(headings, rows),
    ]


def _baseline(baseline: Baseline) -> list[str | ReportTable]:
    plan, rows = baseline.plan, []
    columns = zip(plan.names, plan.units, baseline.values, baseline.sigmas, plan.reference, strict=True)
    for name, unit, value, sigma, reference in columns:
        shown_in = readable_unit(unit, value, sigma)
        healthy = value_with_error(float(value), float(sigma), unit, shown_in)
        given = digits_of(scaled(float(reference), unit, shown_in), abs(scaled(float(value), unit, shown_in)))
        rows.append((name, healthy, given, "" if unit == "1" else shown_in, "fitted"))
    sensors = [
        (code(channel.address), misfit.ratio, misfit.factor)
        for channel, misfit in zip(plan.channels, baseline.misfit, strict=True)
    ]
    lead = f"{baseline.readings} readings in {baseline.duration:.4g} s" if baseline.readings else "the circuit file"
    lead += f" of {baseline.recording}" if baseline.recording else ""
    return [
        paragraph(f"From {lead}."),
        ReportTable(("parameter", *numeric("healthy value", "in the circuit file"), "unit", "source"), rows),
        ReportTable(("sensor", *numeric("residual [sd of the noise]", "factor on its noise", digits=".3g")), sensors),
        findings(baseline.remarks),
    ]
