"""Report of the dynamic limits of a valve."""

from __future__ import annotations

import math
from pathlib import Path

from poppet.bench.limits.bandwidth import WORTH
from poppet.bench.limits.maps import INTERRUPTED, LOAD, PARTS, LimitsResult
from poppet.report.bench import limits_figures as figures
from poppet.report.html_page import Section, document, findings, folded, head, paragraph, picture, write_page
from poppet.report.tables import ReportTable, numeric
from poppet.timeseries.plotting.figures import style

_IDEALISATIONS = {
    "solenoids": "ten times the sonic conductance of both solenoids",
    "pilot volume": "a tenth of it",
    "poppet": "a tenth of the moving masses, the damping at the same ratio to the critical one",
    "sonic conductance": "ten times C of supply and exhaust seat over the whole stroke",
    "sensors and sampling": "a tenth of both sensors' lags and of both sample times",
    "load volume": "a tenth of it",
}
_EXPLANATION = (
    "<p>Bandwidth: the setpoint is a sine about the mean, and the full model is simulated. A regression over whole "
    "periods after the transient gives the fundamental of the outlet pressure. The bandwidth is the frequency at which "
    "the fundamental is -3 dB of the amplitude of the setpoint, or lags by 90 degrees. Steps go from mean minus "
    "amplitude to mean plus amplitude, and back. Their time is that to 90 % of the change.</p>\n"
    "<p>One part at a time is ideal, and the parameters of the controller do not change. A faster part increases the "
    "gain of its loop: a ratio below one means that the loop is less damped.</p>\n"
    "<p>Growth is the real part of the dominant pole of the linear model over one sample at rest. The linear model has "
    "no hold and dead bands, least duties, delays and quantisation. The second line of each cell shows the full model "
    "without these effects in the two seconds after a disturbance of a few Pa. The last map shows the complete valve."
    "</p>\n"
)


def write_limits(result: LimitsResult, path: str | Path) -> Path:
    """Write the report of the dynamic limits of a valve as a self-contained HTML page."""
    return write_page(path, lambda: limits_page(result))


def limits_page(result: LimitsResult) -> str:
    """Return the report of the dynamic limits of a valve as HTML."""
    plan = result.plan
    title = f"{plan.circuit.title or plan.valve}: dynamic limits"
    lead = (
        f"Valve {plan.valve} at {plan.mean / 1e5:.3g} bar, filling {plan.outlet}: the limiting part by load volume and "
        "amplitude, and limit cycles."
    )
    is_stopped = result.outcome == INTERRUPTED
    with style("A report of dynamic limits"):
        sections = [
            Section("", head(title, lead) + paragraph("Interrupted: missing points are grey." if is_stopped else "")),
            Section("Findings", findings(result.findings)),
            Section("Bandwidth", _bandwidth(result) if result.points else ""),
            Section("Ideal parts", _ideal_parts(result) if result.points else ""),
            Section("Stability", _stability(result) if result.stability else ""),
            Section("Explanation", _EXPLANATION),
        ]
    return document(title, sections, style="details { margin: .6rem 0; } summary { cursor: pointer; }\n")


def _bandwidth(result: LimitsResult) -> list[str]:
    caption = (
        "-3 dB frequency of the full model. Second line: the part whose ideal form increases the bandwidth most "
        "(behind the load, the second part of the valve), or controller if no part increases it by "
        f"{100.0 * (WORTH - 1.0):.0f} %. The sign ~ marks points at which the rest of the motion is more than half of "
        "the fundamental."
    )
    response_caption = "Frequency of 90 degrees of lag, and times to 90 % of a step of twice the amplitude."
    return [
        picture(figures.bandwidth_figure(result), "bandwidth", caption),
        picture(figures.response_figure(result), "response", response_caption),
        folded("The values as a table", _point_table(result)),
    ]


def _point_table(result: LimitsResult) -> ReportTable:
    rows = []
    for (volume, amplitude), p in result.points.items():
        frequencies = (
            "-" if math.isnan(value) else figures.frequency_text(result.plan, value)
            for value in (p.gain_frequency, p.phase_frequency)
        )
        times = ("-" if math.isnan(value) else figures.time_text(value) for value in (p.rise_up, p.rise_down))
        noise = "-" if math.isnan(p.noise) else f"{100.0 * p.noise:.2g}"
        case = f"{volume * 1e3:.3g} l, {amplitude / 1e3:.3g} kPa"
        rows.append((case, *frequencies, *times, noise, p.limiting or "-"))
    headings = "-3 dB [Hz]", "-90 deg [Hz]", "step up [ms]", "step down [ms]", "residual motion [%]"
    return ReportTable(("load, amplitude", *numeric(*headings), "limited by"), rows)


def _ideal_parts(result: LimitsResult) -> list[str | ReportTable]:
    rows = []
    for part in (*PARTS, LOAD):
        gains = [value for row in result.gains(part) for value in row if math.isfinite(value)]
        n_limited = sum(point.limiting == part for point in result.points.values())
        span = f"{min(gains):.2g} to {max(gains):.2g}" if gains else "-"
        rows.append((part, _IDEALISATIONS[part], span, str(n_limited)))
    table = ReportTable(("part", "ideal form", *numeric("bandwidth, ideal / real", "limits at points")), rows)
    caption = "Bandwidth with one ideal part divided by that of the real valve; blue: larger, red: smaller."
    return [table, picture(figures.ideal_figure(result), "ideal", caption)]


def _stability(result: LimitsResult) -> list[str | ReportTable]:
    caption = (
        "Growth rate of the linear model; red: unstable. Second line: full model without bands after a small "
        "disturbance: calm, or the frequency of its limit cycle."
    )
    cycle_caption = "The complete valve at a constant setpoint: amplitude and frequency of the outlet pressure."
    rows = [
        (
            f"x {s:g}, x {d:g}, {v * 1e3:.3g} l",
            f"{point.growth:.3g}" if math.isfinite(point.growth) else "?",
            figures.motion_text(point.smooth, point.smooth_frequency),
            figures.swing_text(point.amplitude),
            f"{point.frequency:.3g}" if math.isfinite(point.frequency) else "-",
        )
        for (s, d, v), point in result.stability.items()
    ]
    cases, motion = numeric("growth [1/s]"), numeric("complete valve [Pa]", "at [Hz]")
    values = ReportTable(("spring, damping, volume", *cases, "after a disturbance", *motion), rows)
    differing = [
        (f"{s:g}", f"{d:g}", f"{v * 1e3:.3g} l", point.word)
        for (s, d, v), point in result.stability.items()
        if not point.agrees
    ]
    text = "<p>Cases in which the linear model and the full model without bands disagree:</p>\n" if differing else ""
    return [
        picture(figures.stability_figure(result), "stability", caption),
        picture(figures.hum_figure(result), "hum", cycle_caption),
        folded("The values as a table", values),
        text,
        ReportTable((*numeric("spring", "damping", "volume"), "reason"), differing),
    ]
