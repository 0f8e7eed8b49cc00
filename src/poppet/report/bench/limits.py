"""The page of a valve's dynamic limits."""

from __future__ import annotations

import html
import math
from pathlib import Path

from poppet.bench.limits.bandwidth import WORTH
from poppet.bench.limits.maps import INTERRUPTED, LOAD, PARTS, LimitsResult
from poppet.report.bench import limits_figures
from poppet.report.html_page import document, findings, head, picture, table, write_page
from poppet.timeseries.plotting.figures import style

_MADE_IDEAL = {
    "solenoids": "ten times the sonic conductance of both solenoids",
    "pilot volume": "a tenth of it",
    "poppet": "a tenth of the moving masses, the damping at the same ratio to the critical one",
    "sonic conductance": "ten times C of supply and exhaust seat over the whole stroke",
    "sensors and sampling": "a tenth of both sensors' lags and of both sample times",
    "load volume": "a tenth of it",
}
_EXPLAINED = (
    "<p>Bandwidth: a sine of the setpoint about the mean, run with the full model; the fundamental of the outlet "
    "pressure by regression over whole periods after the transient. Its end is where the fundamental has fallen to "
    "-3 dB of the setpoint's amplitude, or lags by 90 degrees. Steps go from mean minus amplitude to mean plus "
    "amplitude, and back; the time ends at nine tenths.</p>\n"
    "<p>Only one part is made ideal at a time, and the controller keeps its numbers: a faster part raises the gain of "
    "its loop, so that a ratio below one means that the loop got too lively for it.</p>\n"
    "<p>Growth is the real part of the pole that decides, of the linear model over one sample at rest without hold and "
    "dead bands, least duties, delays and quantisation. Below it stands what the full model without these does within "
    "two seconds after a push of a few Pa. The last map shows the valve as it is.</p>\n"
)


def write_limits(result: LimitsResult, path: str | Path) -> Path:
    """Write the limits of a valve as one page that needs nothing else."""
    return write_page(path, lambda: limits_page(result))


def limits_page(result: LimitsResult) -> str:
    """The page as text."""
    plan = result.plan
    title = f"{plan.circuit.title or plan.valve}: dynamic limits"
    text = (
        f"Valve {plan.valve} at {plan.mean / 1e5:.3g} bar, filling {plan.outlet}: which part limits it, by load volume "
        "and amplitude, and where it hums."
    )
    stopped = "<p>It was interrupted: points that are missing stay grey.</p>\n" if result.outcome == INTERRUPTED else ""
    with style("A report of dynamic limits"):
        sections = [
            ("", head(title, text) + stopped),
            ("Findings", findings(result.findings)),
            ("Bandwidth", _bandwidth(result) if result.points else ""),
            ("Ideal parts", _ideal(result) if result.points else ""),
            ("Stability", _stability(result) if result.stability else ""),
            ("How to read this page", _EXPLAINED),
        ]
    return document(title, sections, style="details { margin: .6rem 0; } summary { cursor: pointer; }\n")


def _bandwidth(result: LimitsResult) -> str:
    first = (
        "-3 dB frequency of the full model; below it the part whose ideal form widens the bandwidth most (behind the "
        "load the part of the valve that comes next), controller where none widens it by "
        f"{100.0 * (WORTH - 1.0):.0f} %; ~ where what the valve does beside the sine is more than half of it."
    )
    second = "Frequency of 90 degrees of lag, and times to nine tenths of a step of twice the amplitude."
    maps = picture(limits_figures.bandwidth_figure(result), "bandwidth", first)
    maps += picture(limits_figures.response_figure(result), "response", second)
    return maps + _folded(_point_table(result))


def _folded(values: str) -> str:
    """What a map says, as a table for those who cannot see the whole of it."""
    return f"<details><summary>The values as a table</summary>\n{values}</details>\n"


def _point_table(result: LimitsResult) -> str:
    def frequency(value: float) -> str:
        return "-" if math.isnan(value) else limits_figures.frequency_text(result.plan, value)

    def time(value: float) -> str:
        return "-" if math.isnan(value) else limits_figures.time_text(value)

    heads = [
        "load, amplitude", "-3 dB [Hz]", "-90 deg [Hz]", "step up [ms]", "step down [ms]", "beside the sine [%]",
        "limited by",
    ]  # fmt: skip
    rows = [
        [f"{volume * 1e3:.3g} l, {amplitude / 1e3:.3g} kPa", frequency(p.gain_frequency), frequency(p.phase_frequency),
         time(p.rise_up), time(p.rise_down), "-" if math.isnan(p.noise) else f"{100.0 * p.noise:.2g}",
         p.limiting or "-"]
        for (volume, amplitude), p in result.points.items()
    ]  # fmt: skip
    return table(heads, [list(map(html.escape, row)) for row in rows], numbers=range(1, 6))


def _stability_table(result: LimitsResult) -> str:
    heads = ["spring, damping, volume", "growth [1/s]", "after a push", "as it is [Pa]", "at [Hz]"]
    rows = [
        [f"x {s:g}, x {d:g}, {v * 1e3:.3g} l", f"{each.growth:.3g}" if math.isfinite(each.growth) else "?",
         html.escape(limits_figures.motion_text(each.smooth, each.smooth_frequency)),
         limits_figures.swing_text(each.amplitude),
         f"{each.frequency:.3g}" if math.isfinite(each.frequency) else "-"]
        for (s, d, v), each in result.stability.items()
    ]  # fmt: skip
    return table(heads, rows, numbers=(1, 3, 4))


def _ideal(result: LimitsResult) -> str:
    rows = []
    for part in (*PARTS, LOAD):
        known = [value for row in result.gains(part) for value in row if math.isfinite(value)]
        limits = sum(point.limiting == part for point in result.points.values())
        span = f"{min(known):.2g} to {max(known):.2g}" if known else "-"
        rows.append([html.escape(part), html.escape(_MADE_IDEAL[part]), span, str(limits)])
    words = ["part", "made ideal", "bandwidth, ideal / real", "limits at points"]
    caption = "Bandwidth with one part ideal over that of the real valve: blue gains, red loses."
    return table(words, rows, numbers=(2, 3)) + picture(limits_figures.ideal_figure(result), "ideal", caption)


def _stability(result: LimitsResult) -> str:
    first = (
        "Growth rate of the linear model, red where it is unstable; below it what the full model without bands does "
        "after a small push: calm, or the frequency of its limit cycle."
    )
    second = "The valve as it is, with held setpoint: amplitude and frequency of what the outlet pressure does."
    differing = [
        [f"{s:g}", f"{d:g}", f"{v * 1e3:.3g} l", html.escape(each.word)]
        for (s, d, v), each in result.stability.items()
        if not each.agrees
    ]
    text = picture(limits_figures.stability_figure(result), "stability", first)
    text += picture(limits_figures.hum_figure(result), "hum", second) + _folded(_stability_table(result))
    if differing:
        text += "<p>Where linear and full model without bands do not say the same:</p>\n"
        text += table(["spring", "damping", "volume", "why"], differing, numbers=(0, 1, 2))
    return text
