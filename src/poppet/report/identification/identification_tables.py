"""Tables of an identification's page: parameters, residuals, comparison, conditions, uncertainty."""

from __future__ import annotations

import html
import math
from collections.abc import Mapping
from typing import Any

from poppet.core.number_format import (
    decimals,
    interval,
    number,
    pretty,
    readable_unit,
    scaled,
    value_with_error,
    with_unit,
)
from poppet.core.provenance import Number
from poppet.identify import Estimate, Result
from poppet.identify.friction.coordinate import COORDINATES, TURNING
from poppet.report.html_page import table

_LABELS = {
    "validation": "Held out of the fit",
    "starts": "Starts of the search",
    "evaluations": "Evaluations of the model",
    "noise": "Noise, one sigma",
    "fixed": "Fixed numbers",
    "kicks": "Rounds of new places, at most",
    "pressure_ratio": "Pressure ratio p2/p1",
    "pressure_1": "Upstream pressure",
    "temperature_1": "Upstream temperature",
    "way": "Way of the fit",
    "taut": "Taut points",
    "groups": "Groups, each held out once",
    "speed": "Speeds",
    "smoothing": "Windows of the velocities",
    "velocity_noise": "Noise of the velocities, one sigma",
    "bending_distance": "Way behind a reversal that is no steady sliding",
    "tested": "Strokes tested",
    "argument_unit": "Unit of the polynomials' argument",
    "common_uncertainty": "Uncertainty common to all tests, of C (relative) and b",
    "standard_uncertainties": "Stated standard uncertainties",
}
"""Conditions whose label is not the words of their key."""
_UNITS = {
    **dict.fromkeys(("sonic_conductance", "conductance"), "m^3/(s Pa)"),
    **dict.fromkeys(("pressure", "pressure_1", "pressure_2"), "Pa"),
    **dict.fromkeys(("temperature", "temperature_1"), "K"),
    **dict.fromkeys(("domain", "tested", "knots"), "m"),
    **dict.fromkeys(("lag", "delay", "duration", "smoothing"), "s"),
    "mass_flow_rate": "kg/s",
    **dict.fromkeys(("gauge_pressure", "pressure_difference"), "Pa"),
    **dict.fromkeys(("speed", "velocity_noise"), "m/s"),
    "bandwidth": "Hz",
    "mass": "kg",
    "inertia": "kg m^2",
    "bending_distance": "m",
    "force": "N",
    **dict.fromkeys(("nominal_length", "nominal_diameter"), "m"),
    "volume": "m^3",
    "wall_conductance": "W/K",
    **dict.fromkeys(("relative", "calibration"), "1"),
}
"""SI unit of a number without one, by the last known word of its address."""
_STATISTICS = {
    "chi_square": "Chi-square",
    "degrees_of_freedom": "Degrees of freedom",
    "chi_square_probability": "Probability of a chi-square as large",
    "runs_probability": "Runs test: probability of as few runs",
    "scatter_factor": "Factor on the stated scatter",
    "aicc": "AICc",
}
_MONOTONE = {
    "rejected": "Monotone C rejected",
    "probability": "Probability of the data if C never falls",
    "aicc_constrained": "AICc with C monotone",
    "aicc_free": "AICc with C free to fall",
    "aicc_polynomial": "AICc with polynomials",
}
_RANGES = (
    *("pressure_ratio", "pressure_1", "temperature_1", "domain", "tested"),
    *("gauge_pressure", "contraction", "force"),
    *("speed", "pressure_difference", "smoothing", "bandwidth", "velocity_noise"),
)
_SEPARATE = ("sources", "tests", "searches")
_TOLD = ("sonic_conductance", "effective_area", "critical_ratio", "wall_conductance")
"""Numbers of a circuit that tables of searches and of answers show, as far as they are free."""


def verdict_word(verdict: str) -> str:
    """A verdict as a coloured word."""
    return f'<span class="verdict {verdict.replace(" ", "-")}">{html.escape(verdict)}</span>'


def estimate_text(e: Estimate) -> str:
    """Value and standard error in the unit that fits the value."""
    unit = _unit_of(e)
    text = value_with_error(e.value, e.standard_error, e.unit, unit)
    return with_unit(text, unit) if math.isfinite(e.value) else text


def _unit_of(e: Estimate) -> str:
    if e.unit == "K":
        return "K"
    return readable_unit(e.unit, e.value) if e.value else readable_unit(e.unit, e.start, e.high)


def parameter_table(parameters: Mapping[str, Estimate]) -> str:
    """Every parameter with its value, interval and verdict."""
    headings = ["number", "verdict", "value ± error", "95 % interval", "unit", "relative", "start"]
    rows = [_parameter_row(name, e) for name, e in parameters.items()]
    if not any(math.isfinite(e.start) for e in parameters.values()):
        headings, rows = headings[:-1], [row[:-1] for row in rows]
    return table(headings, rows, numbers=(2, 3, 5, 6))


def _parameter_row(name: str, e: Estimate) -> list[str]:
    unit = _unit_of(e)
    half = 0.5 * (e.high - e.low)
    relative = half / abs(e.value) if e.value else math.nan
    value = html.escape(value_with_error(e.value, e.standard_error, e.unit, unit))
    if unit != e.unit and math.isfinite(e.value):
        value += f'<br><span class="lead">{html.escape(with_unit(f"{e.value:.6g}", e.unit))}</span>'
    cells = [
        interval(e.low, e.high, e.unit, unit),
        "-" if unit in ("1", "") else pretty(unit).replace(" ", "\N{NO-BREAK SPACE}"),
        f"± {_percent(relative)}" if relative < 10.0 else "-",
        number(scaled(e.start, e.unit, unit)) if math.isfinite(e.start) else "-",
    ]
    return [f"<code>{html.escape(name)}</code>", verdict_word(e.verdict), value, *(html.escape(cell) for cell in cells)]


def _percent(fraction: float) -> str:
    return f"{100.0 * fraction:.0f} %" if fraction >= 0.1 else f"{100.0 * fraction:.2g} %"


def residual_table(result: Result) -> str:
    """Model minus measurement of every channel."""
    noise = result.conditions.get("noise", {})
    held = result.conditions.get("validation", [])
    rows = []
    for name, r in result.residuals.items():
        unit = readable_unit(r.unit, r.rms)
        sigma = float(noise.get(name, math.nan))
        role = "held out" if name.partition(".")[0] in held else "fitted"
        texts = [
            _size(r.rms, r.unit, unit, r.rms),
            f"{100.0 * r.nrmse:.3g} %" if math.isfinite(r.nrmse) else number(r.nrmse),
            _size(r.bias, r.unit, unit, r.rms),
            _size(sigma, r.unit, unit, r.rms) if math.isfinite(sigma) else "-",
            str(r.samples),
        ]
        rows.append([f"<code>{html.escape(name)}</code>", role, *(html.escape(text) for text in texts)])
    return table(["channel", "", "rms", "NRMSE", "bias", "noise, one sigma", "samples"], rows, numbers=(2, 3, 4, 5, 6))


def _size(value: float, unit: str, shown_in: str, rms: float) -> str:
    """A value with the decimals that show three digits of the rms."""
    places = decimals(scaled(rms, unit, shown_in))
    text = number(scaled(value, unit, shown_in), None if places is None else places + 1)
    return with_unit(text, shown_in) if math.isfinite(value) else text


def comparison_table(result: Result) -> str:
    """This model beside the other, where there is one."""
    c = result.comparison
    other = c.get("other_rms", {})
    names = list(result.residuals)
    headings = ["model", "AICc", "free numbers", *(f"rms of {name}" for name in names)]
    first = [result.title, f"{c['aicc']:.1f}", str(c.get("free_numbers", "-"))]
    second = [str(c["other"]), f"{c['other_aicc']:.1f}", str(c.get("other_free_numbers", "-"))]
    for name in names:
        r = result.residuals[name]
        unit = readable_unit(r.unit, r.rms, float(other.get(name, math.nan)))
        for cells, rms in ((first, r.rms), (second, float(other.get(name, math.nan)))):
            cells.append(_size(rms, r.unit, unit, r.rms))
    rows = [[html.escape(cell) for cell in cells] for cells in (first, second)]
    return table(headings, rows, numbers=range(1, len(headings)))


def standard_table(result: Result) -> str:
    """What the formulas of ISO 6358-1 give, beside the direct fit."""
    formulas = result.comparison["standard_formulas"]
    rows = []
    for name in ("sonic_conductance", "critical_ratio", "subsonic_index", "cracking_pressure"):
        if name not in formulas:
            continue
        value, error = float(formulas[name]), float(formulas.get(f"u_{name}", math.nan))
        si = "Pa" if name == "cracking_pressure" else _UNITS.get(name, "1")
        fit = next((e for key, e in result.parameters.items() if key.rpartition(".")[2] == name), None)
        fixed = number(float(result.conditions.get("fixed", {}).get(name, math.nan)))
        unit = readable_unit(si, value)
        text = with_unit(value_with_error(value, error, si, unit), unit) if error > 0.0 else number(value)
        direct = estimate_text(fit) if fit else f"{fixed}, fixed"
        rows.append([f"<code>{name}</code>", html.escape(text), html.escape(direct)])
    note = "<p>The errors are standard uncertainties.</p>\n"
    return table(["number", "formulas of the standard", "direct fit"], rows) + note


def budget_table(result: Result) -> str:
    """Where the standard errors come from."""
    rows = []
    for name, budget in result.comparison["uncertainty"].items():
        si = result.parameters[name].unit if name in result.parameters else "1"
        total = math.hypot(*budget["sources"].values())
        for source, size in sorted(budget["sources"].items(), key=lambda pair: -pair[1]):
            unit = readable_unit(si, total)
            share = f"{100.0 * (size / total) ** 2:.0f} %" if 0.0 < total < math.inf else "-"
            text = with_unit(f"{scaled(size, si, unit):.2g}", unit) if math.isfinite(size) else number(size)
            rows.append([f"<code>{html.escape(name)}</code>", *map(html.escape, (source, text, share))])
    return table(["number", "source", "standard uncertainty", "share of the variance"], rows, numbers=(2, 3))


def condition_table(result: Result) -> str:
    """What held during test and fit."""
    rows = []
    for key, value in result.conditions.items():
        is_empty = value is None or (isinstance(value, (str, list, tuple, Mapping)) and not value)
        if key in _SEPARATE or is_empty:
            continue
        label = _LABELS.get(key, key.replace("_", " ").capitalize())
        rows.append([html.escape(label), _condition(result, key, value)])
    return table((), rows) if rows else ""


def _condition(result: Result, name: str, value: Any) -> str:
    if isinstance(value, Mapping):
        if "value" in value and not isinstance(value["value"], Mapping):
            notes = [str(v) for k, v in value.items() if k not in ("value", "unit") and v]
            text = _plain(value["value"], str(value.get("unit", "1")))
            return html.escape(", ".join([text, *notes]))
        pairs = [(html.escape(str(k)), _condition(result, f"{name}.{k}", v)) for k, v in value.items()]
        return "<br>".join(f"<code>{key}</code>: {text}" for key, text in pairs)
    unit = _condition_unit(result, name)
    if not isinstance(value, (list, tuple)):
        return html.escape(_plain(value, unit))
    texts = [_plain(v, unit) for v in value]
    if name in _RANGES and len(value) == 2:
        return html.escape(" ... ".join(texts) if value[0] < value[1] else texts[0])
    return html.escape(", ".join(texts))


def _condition_unit(result: Result, name: str) -> str:
    """Unit of a number whose place is `fixed.tank.volume`, `noise.discharge.tank.pressure`."""
    place = name.partition(".")[2]
    if place in result.residuals:
        return result.residuals[place].unit
    unit = next((_UNITS[word] for word in reversed(name.split(".")) if word in _UNITS), "1")
    turns = result.comparison.get("body") == TURNING.body
    return {"m": TURNING.length, "m/s": TURNING.speed}.get(unit, unit) if turns else unit


def _plain(value: Any, unit: str) -> str:
    if isinstance(value, Number):
        text = value.display()
        return ": ".join(filter(None, (f"{text}, {value.source.kind}", value.source.locator)))
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        if not math.isfinite(value):
            return number(value)
        shown_in = readable_unit(unit, value)
        return with_unit(number(scaled(value, unit, shown_in)), shown_in)
    return str(value)


def stroke_table(result: Result) -> str:
    """The tests behind a characteristic: stroke, C and b of each."""
    rows = []
    for name, (stroke, c, b, u_c, u_b) in result.conditions["tests"].items():
        unit = readable_unit(_UNITS["conductance"], c)
        texts = [
            _plain(stroke, "m"),
            with_unit(value_with_error(c, u_c, _UNITS["conductance"], unit), unit),
            value_with_error(b, u_b, "1", "1"),
        ]
        rows.append([html.escape(text) for text in (str(name), *texts)])
    return table(["test", "stroke", "C ± error", "b ± error"], rows, numbers=(1, 2, 3))


def told_numbers(result: Result) -> list[str]:
    """Addresses of the numbers that tables of searches and answers show; where none is known, the first ones."""
    found = [name for name in result.parameters if name.rpartition(".")[2] in _TOLD]
    return (found or list(result.parameters))[:4]


def search_table(result: Result) -> str:
    """Every search: where it began, where it ended, and how much worse than the best."""
    searches, names = result.conditions["searches"], told_numbers(result)
    least = min(each["cost"] for each in searches)
    rows = []
    for each in sorted(searches, key=lambda search: float(search["cost"])):
        cells = [str(each["name"]).replace("_", " "), f"{2.0 * (each['cost'] - least):.3g}"]
        for name in names:
            si, (begin, end) = result.parameters[name].unit, (float(each[key][name]) for key in ("start", "end"))
            unit = readable_unit(si, begin, end)
            first, last = (number(scaled(value, si, unit)) for value in (begin, end))
            cells.append(with_unit(f"{first} → {last}", unit))
        rows.append([html.escape(cell) for cell in cells])
    return table(["start", "rise of chi-square", *names], rows, numbers=range(1, len(names) + 2))


def answer_table(result: Result) -> str:
    """Every answer that fits alike, with its own intervals."""
    names = told_numbers(result)
    rows = []
    for place, each in enumerate(result.optima, 1):
        cells = [html.escape(f"{place}, from {str(each['name']).replace('_', ' ')}"), f"{2.0 * each['excess']:.2g}"]
        for name in names:
            si, value = result.parameters[name].unit, float(each["values"][name])
            unit = readable_unit(si, value)
            low, high = (float(each[end][name]) for end in ("low", "high"))
            size = html.escape(with_unit(number(scaled(value, si, unit)), unit))
            cells.append(f'{size}<br><span class="lead">{html.escape(interval(low, high, si, unit))}</span>')
        rows.append(cells)
    return table(["answer", "rise of chi-square", *names], rows, numbers=range(1, len(names) + 2))


def law_table(result: Result) -> str:
    """The same recordings under several thermal laws; differences to the best."""
    laws, names = result.comparison["thermal_laws"], told_numbers(result)
    least = min(float(law["aicc"]) for law in laws.values())
    channels = list(next(iter(laws.values()))["rms"])
    rows = []
    for label, law in laws.items():
        cells = [html.escape(label), f"{float(law['aicc']) - least:.1f}"]
        for name in names:
            e = law["numbers"].get(name)
            if e is None:
                cells.append("held" if name.endswith(".wall_conductance") and label == "adiabatic" else "-")
                continue
            unit = readable_unit(e["unit"], e["value"])
            size = value_with_error(e["value"], e["standard_error"], e["unit"], unit)
            cells.append(html.escape(with_unit(size, unit)))
        for channel in channels:
            si = result.residuals[channel].unit
            unit = readable_unit(si, law["rms"][channel])
            cells.append(html.escape(_size(law["rms"][channel], si, unit, law["rms"][channel])))
        rows.append(cells)
    headings = ["thermal law", "AICc above the best", *names, *(f"rms of {channel}" for channel in channels)]
    return table(headings, rows, numbers=range(1, len(headings)))


def force_table(result: Result) -> str:
    """Laws of a muscle's force, the best first."""
    rows = [
        [
            f"<code>{html.escape(law['law'])}</code>",
            f"{law['held_out']:.3g} N",
            f"{100.0 * law['held_out_of_largest']:.2g} %",
            *(f"{law[f'held_out_by_{axis}']:.3g} N" for axis in result.comparison["held_out_by"]),
            f"{law['rms']:.3g} N",
            f"{100.0 * law['rms_of_largest']:.2g} %",
            f"{law['worst']:.3g} N",
            str(law["numbers"]),
        ]
        for law in result.comparison["forces"]
    ]
    axes = [f"held out by {axis}" for axis in result.comparison["held_out_by"]]
    heads = [
        "law",
        "held out",
        "of the largest force",
        *axes,
        "rms of the fit",
        "of the largest force",
        "worst",
        "numbers",
    ]
    return table(heads, rows, numbers=range(1, len(heads)))


def friction_table(result: Result) -> str:
    """Laws of friction, the best first; what each recording says for itself; the numbers as a circuit takes them."""
    c = result.comparison
    coordinate = COORDINATES[c["body"]]
    unit, effort = coordinate.effort_unit, coordinate.effort
    rows = [
        [
            f"<code>{html.escape(law['law'])}</code>",
            f"{law['held_out']:.3g} {unit}",
            f"{law['rms']:.3g} {unit}",
            str(law["numbers"]),
            "supported" if law["law"] == c["supported"] else "not told apart" if law["alike"] else "worse",
        ]
        for law in c["laws"]
    ]
    text = table(["law", f"held out by {c['held_out_by']}", "rms of the fit", "numbers", ""], rows, numbers=(1, 2, 3))
    rows = [
        [
            html.escape(each["name"]),
            _plain(float(f"{each['pressure']:.3g}"), "Pa") if each["pressure"] else "-",
            html.escape(" / ".join(_plain(float(f"{speed:.3g}"), coordinate.speed) for speed in each["speeds"])),
            *(
                f"{each[name]:.3g} {unit}" if name in each else "-"
                for name in ("level", "line", "offset", "half_of_force")
            ),
        ]
        for each in c["recordings"]
    ]
    heads = [
        "recording",
        "pressure",
        "mean speeds",
        "friction",
        "by the law",
        f"zero of the {effort}",
        f"half of the {effort}s",
    ]
    text += table(heads, rows, numbers=range(1, len(heads)))
    return text + f"<p>In a circuit file:</p>\n<pre>{html.escape(c['ready'])}</pre>\n"


def alternative_table(result: Result) -> str:
    """Models with other numbers free, and what they make of the numbers of this fit."""
    names = told_numbers(result)
    rows = []
    for label, model in result.comparison["alternatives"].items():
        cells = [html.escape(label.replace("_", " ")), f"{model['aicc_difference']:+.1f}"]
        for name in names:
            e = model["free"].get(name)
            if e is None:
                cells.append("-")
                continue
            unit = readable_unit(e["unit"], e["value"])
            size = html.escape(with_unit(number(scaled(e["value"], e["unit"], unit)), unit))
            ends = html.escape(interval(e["low"], e["high"], e["unit"], unit))
            cells.append(f'{size}<br><span class="lead">{ends}</span>')
        rows.append(cells)
    return table(["free in addition", "AICc against this fit", *names], rows, numbers=range(1, len(names) + 2))


def statistics_table(result: Result) -> str:
    """Tests on the residuals, as far as the method made them."""
    found = [(label, result.comparison[key]) for key, label in _STATISTICS.items() if key in result.comparison]
    monotone = result.comparison.get("monotone")
    if isinstance(monotone, Mapping):
        found += [(label, monotone[key]) for key, label in _MONOTONE.items() if monotone.get(key) is not None]
    rows = [[label, html.escape(_statistic(value))] for label, value in found]
    return table((), rows, numbers=(1,)) if len(found) > 1 else ""


def _statistic(value: Any) -> str:
    if isinstance(value, (list, tuple)):
        return ", ".join(_statistic(v) for v in value)
    return f"{value:.4g}" if isinstance(value, float) and math.isfinite(value) else _plain(value, "1")


def correlation_sentence(correlation: Mapping[str, Mapping[str, float]]) -> str:
    """The correlation of two parameters in words; empty for none."""
    pairs = [(a, b, r) for a, row in correlation.items() for b, r in row.items()]
    if not pairs:
        return ""
    a, b, r = pairs[0]
    return f"The estimates of {pretty(a)} and {pretty(b)} have a correlation of {r:+.2f}."
