"""Texts of the command `poppet watch` for the terminal: baseline, and summary of a record."""

from __future__ import annotations

import numpy as np

from poppet.core.number_format import aligned, digits_of, readable_unit, scaled, value_with_error
from poppet.monitoring.baseline import Baseline
from poppet.monitoring.record import WatchRecord

MOST_ROWS = 20
"""Maximum number of rows of the table of alarms in the summary of a record."""


def baseline_summary(baseline: Baseline) -> str:
    """Return a table of the healthy values of a baseline, and the lack of fit of its sensors, as text."""
    plan = baseline.plan
    rows = [["parameter", "unit", "healthy value", "in the circuit"]]
    columns = zip(plan.names, plan.units, baseline.values, baseline.sigmas, plan.reference, strict=True)
    for name, unit, value, sigma, reference in columns:
        shown_in = readable_unit(unit, value, sigma)
        healthy = value_with_error(float(value), float(sigma), unit, shown_in).replace("±", "+/-")
        reference_text = digits_of(scaled(float(reference), unit, shown_in), abs(scaled(float(value), unit, shown_in)))
        rows.append([name, "" if unit == "1" else shown_in, healthy, reference_text])
    lines = [
        f"Baseline of {baseline.recording}: {baseline.readings} readings in {baseline.duration:.4g} s.",
        aligned(rows, (2, 3)),
        "Residuals in standard deviations of the noise: "
        + ", ".join(f"{c.address} {m.ratio:.3g}" for c, m in zip(plan.channels, baseline.misfit, strict=True))
        + ".",
    ]
    return "\n".join(lines)


def record_summary(record: WatchRecord, baseline: Baseline) -> str:
    """Return the alarms, the last estimates and the verdict of a record as text."""
    lines = [record.title] if record.title else []
    if not len(record):
        return "\n".join([*lines, "No sample could be used."])
    alarms, n = alarm_rows(record, baseline), len(record.episodes)
    count = f"{n} {'alarm' if n == 1 else 'alarms'}" if n else "no alarm"
    lines.append(f"{len(record)} samples, {record.time[0]:.6g} ... {record.time[-1]:.6g} s: {count}.")
    if alarms:
        heading = ["fault", "from [s]", "to [s]", "change", "alarm size", "probability"]
        lines += ["", aligned([heading, *alarms[:MOST_ROWS]], (1, 2, 5))]
        lines += [f"and {len(alarms) - MOST_ROWS} more rows"] if len(alarms) > MOST_ROWS else []
    lines += ["", "Last estimates:", aligned(estimate_rows(record, baseline), (2, 3, 4)), ""]
    n_used = int(record.counts.sum())
    nis = float(np.nansum(record.nis)) / n_used if n_used else float("nan")
    missing, gated = int(np.count_nonzero(np.isnan(record.readings))), int(np.count_nonzero(record.used == -1))
    lines.append(
        f"Readings: {n_used} used, {missing} missing, {gated} outliers; mean squared innovation {nis:.3g} "
        f"({baseline.healthy_nis:.3g} in the healthy recording)."
    )
    failed = [str(note) for note in record.notes if note.code == "stream.failed"]
    time, note = record.verdicts[-1]
    return "\n".join([*lines, f"Last verdict, at {time:.6g} s: {note}", *failed])


def alarm_rows(record: WatchRecord, baseline: Baseline) -> list[list[str]]:
    """Return one row for each fault of each alarm: fault, start, end, change, alarm size and probability.

    Only the first row of an alarm has a start and an end; the other faults are its other possible causes.
    """
    faults = {fault.name: k for k, fault in enumerate(record.plan.faults)}
    rows = []
    for episode in record.episodes:
        joint = "and" if episode.are_joint else "or"
        begin, end = f"{episode.start:.6g}", "-" if episode.is_open else f"{episode.end:.6g}"
        for name in episode.faults:
            i = faults[name]
            fault, change = record.plan.faults[i], float(record.values[episode.last, i] - baseline.faults[i])
            probability = f"{record.probabilities[episode.last, i]:.2f}"
            unit = readable_unit(fault.unit, change, fault.alarm)
            sizes = size_text(change, fault.unit, "+", unit), size_text(fault.alarm, fault.unit, "", unit)
            rows.append([name if begin else f"{joint} {name}", begin, end, *sizes, probability])
            begin = end = ""
    return rows


def size_text(size: float, unit: str, sign: str = "", shown_in: str = "") -> str:
    """Return a difference of values in a readable unit or in `shown_in`; with the keyword `sign` "+", with its sign."""
    shown_in = shown_in or readable_unit(unit, size)
    return f"{scaled(size, unit, shown_in):{sign}.3g}{'' if unit == '1' else f' {shown_in}'}"


def estimate_rows(record: WatchRecord, baseline: Baseline) -> list[list[str]]:
    """Return a table of the last estimates of all faults, beginning with its heading."""
    rows = [["fault", "unit", "baseline", "estimate", "probability"]]
    for k, fault in enumerate(record.plan.faults):
        value, sigma, healthy = float(record.values[-1, k]), float(record.sigmas[-1, k]), float(baseline.faults[k])
        unit = readable_unit(fault.unit, value, healthy)
        estimate = value_with_error(value, sigma, fault.unit, unit).replace("±", "+/-")
        baseline_text = digits_of(scaled(healthy, fault.unit, unit), abs(scaled(value, fault.unit, unit)))
        rows.append([
            fault.name, "" if unit == "1" else unit, baseline_text, estimate, f"{record.probabilities[-1, k]:.2f}"
        ])  # fmt: skip
    return rows
