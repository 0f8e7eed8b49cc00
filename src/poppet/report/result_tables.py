"""Tables of runs and of linear models, for terminals, pages and notebooks."""

from __future__ import annotations

import math

import numpy as np

from poppet.circuit.linear_model import LinearModel
from poppet.circuit.load_metrics import LoadMetrics
from poppet.core.number_format import USUAL, digits_of, pretty
from poppet.report.tables import Column, ReportTable, numeric
from poppet.timeseries.recording import Recording

MAX_STROKES = 12
ROUNDING = 1e-13
"""Fraction of the largest eigenvalue below which a real eigenvalue is zero."""
STROKES = (
    "Strokes; the time is from 2 % of the travel, or from the last jump or beginning of a ramp of a command, to 98 %."
)
ENERGY = "Air, work and efficiency: work of the actuators divided by the exergy of the supplied air."
_UNITS = {"m": ("mm", 1e3), "rad": ("deg", 180.0 / math.pi), "m/s": ("mm/s", 1e3), "rad/s": ("deg/s", 180.0 / math.pi)}
_CODES = "regime", "contact", "friction_state"
"""Last words of the names of codes, for which extremes have no meaning."""


def stroke_table(metrics: LoadMetrics) -> ReportTable:
    """Return a table of metrics for the first strokes of all moving bodies."""
    rows = []
    for stroke in metrics.strokes[:MAX_STROKES]:
        speed_unit, arrival = f"{stroke.unit}/s", metrics.met(stroke)
        end = _motion_text(abs(arrival.velocity), arrival.unit) if arrival else "none met"
        travel = _motion_text(stroke.travel, stroke.unit)
        speeds = (_motion_text(speed, speed_unit) for speed in (stroke.mean_speed, stroke.peak_speed))
        command = "none" if stroke.command is None else f"{stroke.command} at {stroke.command_time:.4g} s"
        from_command = "" if stroke.from_command is None else f"{stroke.from_command:.4g}"
        times = f"{stroke.start:.4g}", travel, f"{stroke.duration:.4g}"
        rows.append([stroke.body, *times, *speeds, end, from_command, command])
    n_omitted = len(metrics.strokes) - len(rows)
    rows += [[f"and {n_omitted} more", *[""] * 8]] if n_omitted > 0 else []
    headings = "begins [s]", "travel", "time [s]", "mean speed", "peak speed", "at the end stop", "from command [s]"
    return ReportTable(("body", *numeric(*headings), "command"), rows)


def _motion_text(value: float, unit: str) -> str:
    usual_unit, factor = _UNITS[unit]
    return f"{value * factor:.4g} {usual_unit}"


def energy_table(metrics: LoadMetrics) -> ReportTable:
    """Return a table of the air consumption, the work and the efficiency of a run.

    Quantities that are not available are omitted.
    """
    rows = [
        ("air used", f"{metrics.air_used * 1e3:.4g}", "l ANR"),
        ("exergy of the supplied air", f"{metrics.exergy:.4g}", "J"),
        ("work of the actuators", f"{metrics.work:.4g}", "J"),
        ("efficiency", f"{100.0 * metrics.efficiency:.3g}", "%"),
    ]
    rows = [row for row in rows if row[1] != "nan"]
    for work in metrics.works:
        terms = {"on the load": work.on_load, "lost in friction and end stops": work.lost, "given back": work.returned}
        threshold = 1e-6 * (metrics.work + abs(work.on_load))
        rows += [(f"{work.body}: {name}", f"{v:.4g}", "J") for name, v in terms.items() if abs(v) > threshold]
    if not math.isnan(metrics.stored):
        rows.append(("increase in the exergy of the volumes", f"{metrics.stored:.4g}", "J"))
    return ReportTable(("", Column("", "s"), ""), rows)


def mode_table(linear: LinearModel) -> ReportTable:
    """Return a table of the modes of a linear model.

    A mode is a real eigenvalue or a conjugate pair. The poles of a sampled model are converted to continuous time.
    """
    is_sampled = bool(getattr(linear, "sample_time", 0.0))
    modes = [complex(value) for value in linear.poles()]
    threshold = ROUNDING * max(map(abs, modes), default=0.0)
    columns = Column("pole [1/s]" if is_sampled else "eigenvalue [1/s]"), *numeric("time constant [s]",
                     "frequency [Hz]", "damping")  # fmt: skip
    rows = []
    for value in modes:
        if value.imag < 0.0:  # one row for each conjugate pair
            continue
        size, time_constant = abs(value), -1.0 / value.real if value.real else math.inf
        if value.imag != 0.0:
            text = f"{time_constant:.5g}" if value.real < 0.0 else "unstable"
            pair = f"{value.real:.6g} +- {value.imag:.6g}i"
            rows.append([pair, text, f"{size / (2.0 * math.pi):.5g}", f"{-value.real / size:.4g}"])
        elif size <= threshold:
            rows.append(["0", "integrates", "", ""])
        else:
            text = f"{time_constant:.5g}" if value.real < 0.0 else f"unstable, {-time_constant:.5g}"
            rows.append([f"{value.real:.6g}", text, "", ""])
    return ReportTable(columns, rows)


def extreme_table(recording: Recording) -> ReportTable:
    """Return a table of the first, last, minimum and maximum value of each output.

    Outputs that contain codes, such as a flow regime, are omitted. Internal outputs come last.
    """
    units = {
        name: USUAL.get(unit, unit)
        for name, unit in zip(recording.names, recording.units, strict=True)
        if not name.endswith(_CODES)
    }
    series = recording.select(list(units)).converted(units)
    rows = []
    for name, unit in sorted(zip(series.names, series.units, strict=True), key=lambda pair: pair[0] in series.inner):
        values = series[name]
        low, high = int(np.argmin(values)), int(np.argmax(values))
        size = float(np.max(np.abs(values)))
        first, last, minimum, maximum = (digits_of(float(values[k]), size) for k in (0, -1, low, high))
        low_time, high_time = (f"{series.time[k]:.5g}" for k in (low, high))
        rows.append((name, pretty(unit) if unit != "1" else "", first, last, minimum, low_time, maximum, high_time))
    columns = numeric("first", "last", "lowest", "at [s]", "highest", "at [s]")
    return ReportTable(("series", "unit", *columns), rows, name="values")
