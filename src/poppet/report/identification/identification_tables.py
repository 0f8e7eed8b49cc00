"""Tables of an identification report: parameters, residuals, comparisons, conditions and searches."""

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
from poppet.identify.friction.records import TURNING
from poppet.report.tables import Column, Markup, ReportTable, code, numeric, with_detail

_LABELS = {
    "validation": "Recordings for validation",
    "starts": "Starts of the search",
    "evaluations": "Evaluations of the model",
    "noise": "Noise, standard deviation",
    "fixed": "Fixed parameters",
    "kicks": "Maximum rounds of restarts",
    "pressure_ratio": "Pressure ratio p2/p1",
    "pressure_1": "Upstream pressure",
    "temperature_1": "Upstream temperature",
    "way": "Fit method",
    "taut": "Taut points",
    "groups": "Groups of the cross-validation",
    "speed": "Speeds",
    "smoothing": "Windows of the velocities",
    "velocity_noise": "Noise of the velocities, standard deviation",
    "bending_distance": "Distance after a reversal without steady sliding",
    "tested": "Strokes tested",
    "argument_unit": "Unit of the argument of the polynomials",
    "common_uncertainty": "Uncertainty common to all tests, of C (relative) and b",
    "standard_uncertainties": "Stated standard uncertainties",
}
"""Labels of conditions that differ from the words of the key."""
_UNITS = {
    **dict.fromkeys(("sonic_conductance", "conductance"), "m^3/(s Pa)"),
    **dict.fromkeys(("pressure", "pressure_1", "pressure_2", "gauge_pressure", "pressure_difference"), "Pa"),
    **dict.fromkeys(("temperature", "temperature_1"), "K"),
    **dict.fromkeys(("domain", "tested", "knots", "bending_distance", "nominal_length", "nominal_diameter"), "m"),
    **dict.fromkeys(("lag", "delay", "duration", "smoothing"), "s"),
    **dict.fromkeys(("speed", "velocity_noise"), "m/s"),
    "mass_flow_rate": "kg/s",
    "bandwidth": "Hz",
    "mass": "kg",
    "inertia": "kg m^2",
    "force": "N",
    "volume": "m^3",
    "wall_conductance": "W/K",
    "relative": "1",
    "calibration": "1",
}
"""SI unit of a condition by the last known word of its address."""
_STATISTICS = {
    "chi_square": "Chi-square",
    "degrees_of_freedom": "Degrees of freedom",
    "chi_square_probability": "Probability of a larger chi-square",
    "runs_probability": "Runs test: probability of at most as many runs",
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
    *("pressure_ratio", "pressure_1", "temperature_1", "domain", "tested", "gauge_pressure", "contraction", "force"),
    *("speed", "pressure_difference", "smoothing", "bandwidth", "velocity_noise"),
)
_OTHER_SECTIONS = ("sources", "tests", "searches")
"""Conditions that other sections of the report show."""
_MAIN_PARAMETERS = ("sonic_conductance", "effective_area", "critical_ratio", "wall_conductance")
"""Last words of the parameters that tables of searches and optima show."""


def value_text(value: float, si_unit: str) -> str:
    """Return a value in SI units as text with a readable unit."""
    if not math.isfinite(value):
        return number(value)
    unit = readable_unit(si_unit, value)
    return with_unit(number(scaled(value, si_unit, unit)), unit)


def error_text(value: float, error: float, si_unit: str) -> str:
    """Return a value and its standard error as text with a readable unit.

    `si_unit` is the SI unit of both.
    """
    unit = readable_unit(si_unit, value)
    return with_unit(value_with_error(value, error, si_unit, unit), unit)


def verdict_word(verdict: str) -> Markup:
    """Return a verdict as HTML, with the colour of this verdict."""
    return Markup(f'<span class="verdict {verdict.replace(" ", "-")}">{html.escape(verdict)}</span>')


def estimate_text(e: Estimate) -> str:
    """Return the estimate `e` as text: value, standard error and readable unit."""
    unit = _unit_of(e)
    text = value_with_error(e.value, e.standard_error, e.unit, unit)
    return with_unit(text, unit) if math.isfinite(e.value) else text


def _unit_of(e: Estimate) -> str:
    if e.unit == "K":
        return "K"
    return readable_unit(e.unit, e.value) if e.value else readable_unit(e.unit, e.start, e.high)


def parameter_table(parameters: Mapping[str, Estimate]) -> ReportTable:
    """Return a table of the parameters: value, confidence interval and verdict."""
    estimate, start = numeric("value ± standard uncertainty", "95 % interval"), numeric("half interval", "start")
    columns: list[Column | str] = ["parameter", "verdict", *estimate, "unit", *start]
    rows = []
    for name, e in parameters.items():
        unit = _unit_of(e)
        relative = 100.0 * 0.5 * (e.high - e.low) / abs(e.value) if e.value else math.nan
        si_value = with_unit(f"{e.value:.6g}", e.unit) if unit != e.unit and math.isfinite(e.value) else ""
        row = [
            code(name),
            verdict_word(e.verdict),
            with_detail(value_with_error(e.value, e.standard_error, e.unit, unit), si_value),
            interval(e.low, e.high, e.unit, unit),
            "-" if unit in ("1", "") else pretty(unit).replace(" ", "\N{NO-BREAK SPACE}"),
            f"{relative:{'.0f' if relative >= 10.0 else '.2g'}} %" if relative < 1000.0 else "-",
            number(scaled(e.start, e.unit, unit)) if math.isfinite(e.start) else "-",
        ]
        rows.append(row)
    if any(math.isfinite(e.start) for e in parameters.values()):
        return ReportTable(columns, rows)
    return ReportTable(columns[:-1], [row[:-1] for row in rows])


def residual_table(result: Result) -> ReportTable:
    """Return a table with statistics of the residuals of each channel.

    A residual is model minus measurement.
    """
    noise, validation = (result.conditions.get(key, default) for key, default in (("noise", {}), ("validation", [])))
    rows = []
    for name, r in result.residuals.items():
        sigma = float(noise.get(name, math.nan))
        rms, bias = (_residual_text(value, r.unit, r.rms) for value in (r.rms, r.bias))
        noise_text = _residual_text(sigma, r.unit, r.rms) if math.isfinite(sigma) else "-"
        role = "validation" if name.partition(".")[0] in validation else "fitted"
        nrmse = f"{100.0 * r.nrmse:.3g} %" if math.isfinite(r.nrmse) else number(r.nrmse)
        rows.append((code(name), role, rms, nrmse, bias, noise_text, str(r.samples)))
    return ReportTable(("channel", "", *numeric("rms", "NRMSE", "bias", "noise, one sigma", "samples")), rows)


def _residual_text(value: float, si_unit: str, rms: float, unit: str = "") -> str:
    """Return a residual in SI units as text with a readable unit.

    The text has the number of decimals with which the rms value has three digits.
    """
    unit = unit or readable_unit(si_unit, rms)
    places = decimals(scaled(rms, si_unit, unit))
    text = number(scaled(value, si_unit, unit), None if places is None else places + 1)
    return with_unit(text, unit) if math.isfinite(value) else text


def comparison_table(result: Result) -> ReportTable:
    """Return a table that compares the model of the result with another model.

    The table contains AICc, the number of free parameters, and residuals.
    """
    c = result.comparison
    rows = [
        [result.title, f"{c['aicc']:.1f}", str(c.get("free_numbers", "-"))],
        [str(c["other"]), f"{c['other_aicc']:.1f}", str(c.get("other_free_numbers", "-"))],
    ]
    for name, r in result.residuals.items():
        sizes = r.rms, float(c.get("other_rms", {}).get(name, math.nan))
        unit = readable_unit(r.unit, *sizes)
        for row, rms in zip(rows, sizes, strict=True):
            row.append(_residual_text(rms, r.unit, r.rms, unit))
    headings = "AICc", "free parameters", *(f"rms of {name}" for name in result.residuals)
    return ReportTable(("model", *numeric(*headings)), rows)


def condition_table(result: Result) -> ReportTable:
    """Return a table of the test conditions and of the settings of the fit."""
    rows = [
        (_LABELS.get(key, key.replace("_", " ").capitalize()), _condition(result, key, value))
        for key, value in result.conditions.items()
        if key not in _OTHER_SECTIONS and value is not None
        if not isinstance(value, str | list | tuple | Mapping) or value
    ]
    return ReportTable(("", ""), rows)


def _condition(result: Result, name: str, value: Any) -> str:
    if isinstance(value, Mapping):
        if "value" in value and not isinstance(value["value"], Mapping):
            notes = [str(v) for k, v in value.items() if k not in ("value", "unit") and v]
            return ", ".join([plain_text(value["value"], str(value.get("unit", "1"))), *notes])
        pairs = [(code(k, ": "), _condition(result, f"{name}.{k}", v)) for k, v in value.items()]
        return Markup("<br>".join(key + (v if isinstance(v, Markup) else html.escape(v)) for key, v in pairs))
    # An address such as `fixed.tank.volume` or `noise.discharge.tank.pressure`.
    channel = name.partition(".")[2]
    if channel in result.residuals:
        unit = result.residuals[channel].unit
    else:
        unit = next((_UNITS[word] for word in reversed(name.split(".")) if word in _UNITS), "1")
        if result.comparison.get("body") == TURNING.body:
            unit = {"m": TURNING.length, "m/s": TURNING.speed}.get(unit, unit)
    if not isinstance(value, (list, tuple)):
        return plain_text(value, unit)
    texts = [plain_text(v, unit) for v in value]
    if name in _RANGES and len(value) == 2:
        return " ... ".join(texts) if value[0] < value[1] else texts[0]
    return ", ".join(texts)


def plain_text(value: Any, unit: str) -> str:
    """Return the value of a test condition as text.

    Numbers in SI units have a readable unit. Truth values become `yes` or `no`.
    """
    if isinstance(value, Number):
        text = value.display()
        return ": ".join(filter(None, (f"{text}, {value.source.kind}", value.source.locator)))
    if isinstance(value, bool):
        return "yes" if value else "no"
    return value_text(value, unit) if isinstance(value, float) else str(value)


def main_parameters(result: Result) -> list[str]:
    """Return the addresses of at most four parameters, for tables of searches and optima.

    They are conductances and the critical ratio, or, if none of them was fitted, the first parameters of the result.
    """
    names = [name for name in result.parameters if name.rpartition(".")[2] in _MAIN_PARAMETERS]
    return (names or list(result.parameters))[:4]


def search_table(result: Result) -> ReportTable:
    """Return a table of the searches: start point, end point and increase in chi-square.

    The increase is relative to the best search.
    """
    searches, names = result.conditions["searches"], main_parameters(result)
    min_cost = min(search["cost"] for search in searches)
    rows = []
    for search in sorted(searches, key=lambda search: float(search["cost"])):
        cells = [str(search["name"]).replace("_", " "), f"{2.0 * (search['cost'] - min_cost):.3g}"]
        for name in names:
            si_unit, ends = result.parameters[name].unit, [float(search[key][name]) for key in ("start", "end")]
            unit = readable_unit(si_unit, *ends)
            cells.append(with_unit(" → ".join(number(scaled(value, si_unit, unit)) for value in ends), unit))
        rows.append(cells)
    return ReportTable(("start", *numeric("increase in chi-square", *names)), rows)


def optimum_table(result: Result) -> ReportTable:
    """Return a table of the equivalent optima: values and confidence intervals."""
    names, rows = main_parameters(result), []
    for index, optimum in enumerate(result.optima, 1):
        cells = [f"{index}, from {str(optimum['name']).replace('_', ' ')}", f"{2.0 * optimum['excess']:.2g}"]
        for name in names:
            value, low, high = (float(optimum[key][name]) for key in ("values", "low", "high"))
            cells.append(_interval_cell(value, low, high, result.parameters[name].unit))
        rows.append(cells)
    return ReportTable(("optimum", *numeric("increase in chi-square", *names)), rows)


def alternative_table(result: Result) -> ReportTable:
    """Return a table of the alternative models, which have further free parameters.

    It contains the difference in AICc and the estimates.
    """
    names, rows = main_parameters(result), []
    for label, model in result.comparison["alternatives"].items():
        estimates = (model["free"].get(name) for name in names)
        cells = ("-" if e is None else _interval_cell(e["value"], e["low"], e["high"], e["unit"]) for e in estimates)
        rows.append((label.replace("_", " "), f"{model['aicc_difference']:+.1f}", *cells))
    return ReportTable(("free in addition", *numeric("AICc minus this fit", *names)), rows)


def _interval_cell(value: float, low: float, high: float, si_unit: str) -> Markup:
    unit = readable_unit(si_unit, value)
    return with_detail(with_unit(number(scaled(value, si_unit, unit)), unit), interval(low, high, si_unit, unit))


def law_table(result: Result) -> ReportTable:
    """Return a table that compares the fits of different thermal laws, one row per law.

    A row contains the difference in AICc from the best law, the estimates and the residuals.
    """
    laws, names = result.comparison["thermal_laws"], main_parameters(result)
    min_aicc = min(float(law["aicc"]) for law in laws.values())
    channels = list(next(iter(laws.values()))["rms"])
    rows = []
    for label, law in laws.items():
        cells = [label, f"{float(law['aicc']) - min_aicc:.1f}"]
        for name in names:
            if e := law["numbers"].get(name):
                cells.append(error_text(e["value"], e["standard_error"], e["unit"]))
            else:
                cells.append("fixed" if name.endswith(".wall_conductance") and label == "adiabatic" else "-")
        cells += [_residual_text(law["rms"][name], result.residuals[name].unit, law["rms"][name]) for name in channels]
        rows.append(cells)
    headings = "AICc above the best", *names, *(f"rms of {channel}" for channel in channels)
    return ReportTable(("thermal law", *numeric(*headings)), rows)


def statistics_table(result: Result) -> ReportTable:
    """Return a table of the statistical tests on the residuals.

    The table is empty if the method made fewer than two tests.
    """
    values = [(label, result.comparison[key]) for key, label in _STATISTICS.items() if key in result.comparison]
    monotone = result.comparison.get("monotone")
    if isinstance(monotone, Mapping):
        values += [(label, monotone[key]) for key, label in _MONOTONE.items() if monotone.get(key) is not None]
    rows = [(label, _statistic(value)) for label, value in values]
    return ReportTable(("", Column("", "s")), rows if len(rows) > 1 else ())


def _statistic(value: Any) -> str:
    if isinstance(value, (list, tuple)):
        return ", ".join(_statistic(v) for v in value)
    return f"{value:.4g}" if isinstance(value, float) and math.isfinite(value) else plain_text(value, "1")


def correlation_sentence(correlation: Mapping[str, Mapping[str, float]]) -> str:
    """Return a sentence on the correlation between the first two parameters.

    The text is empty if the result has no correlations.
    """
    pairs = [(a, b, r) for a, row in correlation.items() for b, r in row.items()]
    if not pairs:
        return ""
    a, b, r = pairs[0]
    return f"The estimates of {pretty(a)} and {pretty(b)} have a correlation of {r:+.2f}."
