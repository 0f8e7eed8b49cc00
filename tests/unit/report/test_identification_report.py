"""Tests of identification reports: content, values without numbers, headline, figures and files."""

from __future__ import annotations

import html
import math
import re
import subprocess
import sys
from dataclasses import replace
from functools import cache
from html.parser import HTMLParser

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pages import needs_nothing_else, plots
from poppet.core.codes import Note, notes_of
from poppet.core.errors import MissingDependencyError
from poppet.core.number_format import decimals, interval, number, readable_unit, value_with_error
from poppet.identify import Estimate, ResidualSummary, Result
from poppet.identify.characteristic.identify_characteristic import identify_characteristic
from poppet.identify.characteristic.stroke_tests import StrokePoint
from poppet.identify.fit.identify_fit import compare_results
from poppet.identify.flow.identify_flow import identify_flow
from poppet.identify.flow.points import FlowPoints
from poppet.iso6358 import mass_flow_rate
from poppet.report.identification.headline import headline, next_step, verdict_counts
from poppet.report.identification.identification_figures import (
    channel_figure,
    flow_curve,
    interval_range,
    traces_of,
)
from poppet.report.identification.identification_report import identification_page, write_identification
from poppet.timeseries.plotting.figures import style
from refusals import refused

VOID = {"meta", "br", "img", "link", "input", "hr"}
INF, NAN = math.inf, math.nan
TIME = np.linspace(0.0, 20.0, 200)
MODEL = 1e5 + 6e5 * np.exp(-TIME / 5.0)
NOISE = np.random.default_rng(3).normal(0.0, 700.0, TIME.size)
SLOW = np.array([0.1, 0.5, 1.0, 2.0])


class Page(HTMLParser):
    """Parser for the text and the tags of a page; it requires that all tags are closed."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.words: list[str] = []
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open and self.open[-1] not in ("style", "script"):
            self.words.append(data)

    @property
    def text(self) -> str:
        return re.sub(r"\s+", " ", " ".join(self.words))

    def count(self, tag: str) -> int:
        return sum(name == tag for name, _ in self.tags)


def example_result(**changes) -> Result:
    names = ("valve.sonic_conductance", "valve.critical_ratio", "tank.wall_conductance")
    example = Result(
        "fit",
        "Discharge of the tank",
        {
            names[0]: Estimate(1.234e-8, "m^3/(s Pa)", 2.3e-11, 1.229e-8, 1.239e-8, "determined", 1e-8),
            names[1]: Estimate(0.31, "1", 0.09, 0.13, 0.49, "weak", 0.3),
            names[2]: Estimate(0.0, "W/K", 2.0, 0.0, 4.0, "at bound", 5.0),
        },
        {"discharge.tank.pressure": ResidualSummary(690.0, 0.00115, -12.0, "Pa", TIME.size)},
        {a: {b: -0.95 for b in names if b != a} for a in names},
        remarks=notes_of(["b is weakly determined & says so.", "The wall conductance ran to its lower bound."]),
        conditions={"recordings": ["discharge"], "validation": [], "noise": {"discharge.tank.pressure": 700.0}},
        series={"discharge.tank.pressure": {"time": TIME, "measured": MODEL + NOISE, "model": MODEL, "unit": "Pa"}},
    )
    return replace(example, **changes)


@cache
def example_page() -> str:
    """Return the page of the example result."""
    return identification_page(example_result())


# --- content ---


def test_page_has_parameters_findings_and_verdicts():
    result = example_result()
    page = Page(example_page())
    assert "Of 3 parameters, 1 is determined, 1 is weakly determined, 1 is at a bound." in page.text
    for name, estimate in result.parameters.items():
        assert page.text.count(name) >= 2
        assert estimate.verdict in page.text
    positions = [page.text.index(finding) for finding in result.findings]
    assert positions == sorted(positions)
    assert page.text.index("Findings") < positions[0] < page.text.index(" Parameters parameter")


def test_page_states_reason_of_each_other_verdict():
    """A critical ratio gets the limit of its verdict, a bound its finding, a capped verdict the capping finding."""
    facts = {"value": 0.0, "unit": "W/K", "is_low": True}
    bound = Note("finding.number.bound", "tank.wall_conductance", **facts)
    text = Page(identification_page(example_result(remarks=(bound,)))).text.partition("Findings")[0]
    # The limit of the verdict, and the half width of 0.130 ... 0.490.
    assert (
        'The verdict on a critical back-pressure ratio is "determined" only if half the width of the 95 % interval is '
        "at most 5 % of the range between the bounds of the ratio (0 to 1 by default). Here, half the width is 0.18."
        in text
    )
    assert "tank.wall_conductance reached its lower bound" in text
    assert text.count("valve.sonic_conductance") == 1  # determined: only in the table
    residuals = Note("finding.residuals.large", "discharge.tank.pressure", times=6.0, noise=50.0, unit="Pa")
    conditions = {**example_result().conditions, "capped": {"valve.critical_ratio": ["finding.residuals.large"]}}
    capped = Page(identification_page(example_result(remarks=(residuals,), conditions=conditions))).text
    assert "the residuals are 6 times larger" in capped.partition("Findings")[0]


def test_values_have_readable_and_si_units():
    text = Page(example_page()).text.replace("\N{NO-BREAK SPACE}", " ")
    assert "1.2340 ± 0.0023 dm³/(s bar)" in text
    assert "1.234e-08 m³/(s Pa)" in text
    assert "1.2290 ... 1.2390" in text
    assert "0.41 %" in text
    assert "± 0.41 %" not in text
    assert "0.130 ... 0.490" in text
    assert "58 %" in text


def test_page_has_residuals_and_conditions():
    text = Page(example_page()).text
    assert "690.0 Pa 0.115 % -12.0 Pa 700.0 Pa 200" in text
    assert "Recordings discharge" in text


def test_page_has_figures_and_no_external_content():
    text = example_page()
    page = Page(text)
    assert page.count("svg") == 3  # intervals, correlation, one channel
    needs_nothing_else(text)
    assert len(plots(text)) == 1  # of the channel; intervals and correlations are still pictures
    links = [value for _, attrs in page.tags for key, value in attrs.items() if key.endswith("href")]
    assert links
    marks = [attrs["id"] for _, attrs in page.tags if "id" in attrs]
    assert len(marks) == len(set(marks))
    assert {link[1:] for link in links} <= set(marks)


def test_two_parameters_have_correlation_sentence():
    names = ("valve.sonic_conductance", "valve.critical_ratio")
    correlation = {names[0]: {names[1]: -0.93}, names[1]: {names[0]: -0.93}}
    page = Page(identification_page(example_result(correlation=correlation)))
    assert page.count("svg") == 2
    assert "valve.sonic_conductance and valve.critical_ratio have a correlation of -0.93" in page.text


def test_comparison_has_both_models_and_verdict():
    first = example_result(comparison={"aicc": 1000.0, "free_numbers": 3, "samples": 200})
    second = example_result(title="adiabatic", comparison={"aicc": 1400.0, "free_numbers": 2, "samples": 200})
    second = replace(
        second, residuals={"discharge.tank.pressure": ResidualSummary(4900.0, 0.008, 10.0, "Pa", TIME.size)}
    )
    text = Page(identification_page(compare_results(first, second, "adiabatic.toml"))).text
    assert (
        "clearly better than adiabatic (adiabatic.toml) (the model selection criterion AICc is lower by 400.0)" in text
    )
    assert "Discharge of the tank 1000.0 3 0.690 kPa" in text
    assert "adiabatic.toml 1400.0 2 4.900 kPa" in text
    assert "Comparison" not in Page(example_page()).text


def test_validation_recordings_are_marked():
    conditions = {"recordings": ["discharge"], "validation": ["discharge"]}
    text = Page(identification_page(example_result(conditions=conditions))).text
    assert "discharge.tank.pressure validation" in text
    assert "discharge.tank.pressure , used for validation" in text


def test_text_is_escaped():
    text = identification_page(example_result(title="<b>A & B</b>", remarks=notes_of(["x < 1 & y > 2"])))
    assert "<b>" not in text
    page = Page(text)
    assert "<b>A & B</b>" in page.text
    assert "x < 1 & y > 2" in page.text


def test_sources_and_fixed_parameters_are_listed():
    conditions = {
        "fixed": {"tank.volume": {"value": 0.0162, "unit": "m^3", "source": "measured"}, "valve.lag": 0.25},
        "sources": {"tank.volume": "calliper, 0.200 m by 0.515 m"},
        "seed": 7,
    }
    text = Page(identification_page(example_result(conditions=conditions, series={}))).text
    assert "tank.volume : 16.2 l, measured" in text
    assert "valve.lag : 0.25 s" in text
    assert "tank.volume: calliper, 0.200 m by 0.515 m" in text
    assert "Seed 7" in text


# --- values without numbers ---


def test_infinite_and_unknown_values_are_words():
    parameters = {
        "a.volume": Estimate(2e-2, "m^3", INF, -INF, INF, "not determined", 1e-2),
        "b.critical_ratio": Estimate(NAN, "1", INF, 0.4, 1.0, "not determined"),
        "c.rate": Estimate(5.0, "N/m", NAN, NAN, NAN, "not determined", NAN),
        "d.area": Estimate(INF, "m^2", INF, 1e-6, INF, "not determined", 1e300),
    }
    residuals = {"discharge.tank.pressure": ResidualSummary(NAN, INF, NAN, "Pa", 0)}
    text = Page(identification_page(example_result(parameters=parameters, residuals=residuals, correlation={}))).text
    assert "20 l" not in text.partition("Findings")[0].replace("(error infinite) l", "")
    assert "0.02" not in text.partition("Findings")[0]
    assert "20 (error infinite)" in text
    assert "not known (error infinite)" in text
    assert "0.400 ... 1.000" in text or "0.40 ... 1.00" in text
    assert "no upper limit" in text
    assert "no limit" in text
    assert re.findall(r"(?<![\w.])[+-]?(?:inf|nan)(?![\w])", text) == []


@given(
    value=st.floats(allow_nan=True, allow_infinity=True),
    error=st.floats(min_value=0.0, allow_infinity=True) | st.just(NAN),
    unit=st.sampled_from(["1", "Pa", "m^3/(s Pa)", "s", "K", "N/m"]),
)
@settings(max_examples=200, derandomize=True, deadline=None)
def test_any_value_has_short_text(value, error, unit):
    shown_in = readable_unit(unit, value, error)
    texts = [value_with_error(value, error, unit, shown_in), interval(value - error, value + error, unit, shown_in)]
    for text in texts:
        assert re.search(r"\b(?:inf|nan)\b", text) is None
        assert len(text) < 60


@given(value=st.floats(1e-3, 1e3), digits=st.floats(-5.0, -0.1))
@settings(max_examples=200, derandomize=True, deadline=None)
def test_texts_keep_significant_digits(value, digits):
    error = value * 10.0**digits
    text, _, written = value_with_error(value, error, "1", "1").partition(" ± ")
    assert abs(float(written) - error) <= 0.051 * error
    assert abs(float(text) - value) <= 0.051 * error * (1.0 if decimals(error) else 10.0)


def test_unit_depends_on_value():
    assert readable_unit("Pa", NAN, INF) == "Pa"
    assert readable_unit("s", 0.02) == "ms"
    assert readable_unit("W/K", 3.0) == "W/K"
    assert readable_unit("m^3", 0.0162) == "l"
    assert number(-INF) == "minus infinite"
    assert number(-1e-9, 3) == "0.000"


@pytest.mark.parametrize(
    ("estimate", "expected"),
    [
        (Estimate(0.3, "1", 0.1, 0.1, 0.5, "weak", 0.9), (0.0, 1.0)),
        (Estimate(-2.0, "K", 0.5, -3.0, -1.0, "weak", -2.0), (-3.3, 0.0)),
        (Estimate(NAN, "s", INF, -INF, INF, "not determined"), (0.0, 1.0)),
    ],
)
def test_interval_axis_includes_zero_and_near_values(estimate, expected):
    assert np.max(np.abs(np.subtract(interval_range(estimate), expected))) < 1e-12


def test_caption_lists_start_values_outside_axis():
    parameters = {"lag": Estimate(2.0, "s", 0.1, 1.8, 2.2, "determined", 100.0)}
    assert (
        "Starts outside: lag 100 s." in Page(identification_page(example_result(parameters=parameters, series={}))).text
    )


# --- headline ---


def test_headline_has_c_and_b_with_errors():
    expected = "C = 1.2340 ± 0.0023 dm³/(s bar), b = 0.310 ± 0.090 (weak)."
    assert headline(example_result()).startswith(expected)
    assert headline(example_result(), is_plain=True).isascii()
    assert expected in Page(example_page()).text
    two = {f"{part}.critical_ratio": Estimate(0.3, "1", 0.01, 0.28, 0.32, "determined") for part in ("a", "b")}
    assert headline(example_result(parameters=two)).startswith("b of a = 0.300 ± 0.010, b of b = 0.300 ± 0.010. All 2")
    lag = {"discharge.lag": Estimate(2.0, "s", 0.1, 1.8, 2.2, "determined")}  # of a recording, not of the circuit
    assert headline(example_result(parameters=lag)) == "The parameter is determined."


def test_most_urgent_finding_gives_next_step():
    weak = Note("finding.number.weak", "valve.critical_ratio", low=0.1, high=0.5, unit="1")
    choked = Note("finding.choking.throughout", "valve.critical_ratio", passage="valve")
    indistinguishable = Note("finding.tell_apart.wall", names=("C", "hA"))
    assert "longer" in next_step(example_result(remarks=(weak,)))
    assert "nearly equal" in next_step(example_result(remarks=(weak, choked)))
    assert next_step(example_result(remarks=(weak, choked, indistinguishable))) == str(indistinguishable)
    assert "not used in the fit" in next_step(example_result(remarks=()))
    assert next_step(example_result(remarks=(), conditions={"validation": ["again"]})) == ""


def test_reading_notes_are_folded():
    read = Note("measured.empty_cells", "a.tank.pressure", lost=3, total=200)
    page = identification_page(example_result(remarks=(read, *example_result().remarks)))
    assert page.count("<details>") == 1
    folded = page[page.index("<details>") : page.index("</details>")]
    assert html.escape(str(read)) in folded
    assert [remark for remark in example_result().findings if html.escape(remark) in folded] == []
    assert "<details>" not in example_page()


# --- bands ---


def result_with_bands(half: float, width: float) -> Result:
    ends = {"low": MODEL - half, "high": MODEL + half, "samples_low": MODEL - width, "samples_high": MODEL + width}
    table = {**example_result().series["discharge.tank.pressure"], **ends}
    return example_result(series={"discharge.tank.pressure": table})


def test_channel_figure_has_model_and_sample_bands():
    (trace,) = traces_of(result_with_bands(100.0, 1400.0))
    assert trace.samples == pytest.approx(1400.0)
    with style("a test"):
        upper, lower = channel_figure(trace).axes[:2]
        names = [text.get_text() for text in upper.get_legend().get_texts()]
    assert {"95 % of the model", "95 % of samples"} <= set(names)
    ends = sorted(float(np.max(band.get_paths()[0].vertices[:, 1])) for band in lower.collections)
    assert ends == pytest.approx([0.1, 1.4])  # in kPa, as the axis
    page = Page(identification_page(result_with_bands(100.0, 1400.0))).text
    percent = 100.0 * np.mean(np.abs(NOISE) <= 1400.0)
    assert f"at most ± 1.4 kPa; it contains {percent:.1f} %" in page
    assert "the coloured band is the 95 % band of the model (at most ± 0.1 kPa)" in page


# --- alternative models and outliers ---


def test_alternative_models_are_listed():
    e = {"value": 1.4e-8, "low": 1.38e-8, "high": 1.42e-8, "unit": "m^3/(s Pa)"}
    model = {"aicc_difference": -12.34, "free": {"valve.sonic_conductance": e}}
    page = Page(identification_page(example_result(comparison={"alternatives": {"wall_heat_capacity": model}}))).text
    assert "Alternative models" in page
    assert "wall heat capacity -12.3 1.4 dm³/(s bar) 1.380 ... 1.420 - -" in page
    assert "Alternative models" not in Page(example_page()).text


def test_outliers_have_rings_in_both_axes():
    x = np.linspace(0.1, 0.9, 9)
    measured, model = 1e-8 * (1.0 - 0.5 * x), 1e-8 * (1.0 - 0.4 * x)
    table = {"x": x, "measured": measured, "model": model, "unit": "m^3/(s Pa)", "x_unit": "1", "x_name": "p2/p1"}
    (trace,) = traces_of(example_result(series={"points.effective_conductance": table}))
    with style("a test"):
        upper, lower = channel_figure(trace, outliers=[0.7]).axes[:2]
    rings = [[line for line in axes.get_lines() if line.get_label() == "off the law"] for axes in (upper, lower)]
    assert [len(lines) for lines in rings] == [1, 1]
    assert [lines[0].get_xdata().tolist() for lines in rings] == [[x[6]], [x[6]]]
    assert rings[0][0].get_ydata() == pytest.approx([1e8 * measured[6]])


# --- verdict ---


@pytest.mark.parametrize(
    ("verdict_names", "expected"),
    [
        ((), "There are no free parameters."),
        (("weak",), "The parameter is weakly determined."),
        (("at bound",), "The parameter is at a bound."),
        (("not determined", "not determined"), "None of the 2 parameters is determined."),
        (("determined", "weak", "weak"), "Of 3 parameters, 1 is determined, 2 are weakly determined."),
    ],
)
def test_verdicts_are_summarised(verdict_names, expected):
    parameters = {str(k): Estimate(1.0, "s", 0.1, 0.9, 1.1, v) for k, v in enumerate(verdict_names)}
    assert verdict_counts(Result("fit", "t", parameters)) == expected


def test_worst_verdict_sets_summary_colour():
    assert '<div class="summary at-bound">' in example_page()


def test_page_without_series_has_no_fit_figures():
    page = Page(identification_page(example_result(series={}, correlation={})))
    assert page.count("svg") == 1
    assert "found no problems" not in page.text
    assert "found no problems" in Page(identification_page(Result("tank", "empty", {}))).text


# --- figures ---


def draw_channel(trace, *arguments):
    with style("A test"):
        return channel_figure(trace, *arguments)


def test_channel_figure_shows_data_of_result():
    (trace,) = traces_of(example_result())
    figure = draw_channel(trace)
    upper, lower, histogram, correlation = figure.axes
    points, line = upper.lines
    assert np.max(np.abs(points.get_ydata() - (MODEL + NOISE) / 1e5)) < 1e-12
    assert np.max(np.abs(line.get_ydata() - MODEL / 1e5)) < 1e-12
    assert upper.get_ylabel() == "pressure [bar]"
    assert np.max(np.abs(lower.lines[-1].get_ydata() + NOISE / 1e3)) < 1e-9
    band = lower.patches[0].get_extents().transformed(lower.transData.inverted())
    assert abs(band.y1 - 1.4) < 1e-9
    assert sum(bar.get_width() for bar in histogram.patches) == TIME.size
    assert correlation.get_title(loc="left") == "autocorrelation of residuals"


def test_incomplete_series_are_drawn():
    series = {
        "a.pressure": {"time": SLOW, "measured": 1e5 * SLOW, "model": 1e5 * SLOW, "unit": "Pa"},
        "b.temperature": {"time": TIME, "measured": np.full(TIME.size, 293.15), "model": np.full(TIME.size, NAN),
                          "unit": "K"},
        "c.conductance": {"x": TIME, "y": 1e-9 * TIME, "low": 0 * TIME, "high": 2e-9 * TIME, "points_x": SLOW,
                          "points_y": 1e-9 * SLOW, "points_low": 0 * SLOW, "points_high": 2e-9 * SLOW,
                          "unit": "m^3/(s Pa)", "x_unit": "m", "x_name": "stroke", "note": "text"},
        "d.long": {"time": np.arange(1e5), "measured": np.zeros(100_000), "model": np.zeros(100_000), "unit": "N"},
        "e.measured_only": {"time": TIME, "measured": MODEL, "unit": "Pa"},
        "f.nothing": {"samples": 3},
        "g.neither": 4.0,
    }  # fmt: skip
    traces = traces_of(example_result(series=series))
    assert [trace.name for trace in traces] == [
        "a.pressure",
        "b.temperature",
        "c.conductance",
        "d.long",
        "e.measured_only",
    ]
    assert [trace.residual.size for trace in traces] == [4, 200, 4, 100_000, 0]
    assert [len(draw_channel(trace).axes) for trace in traces] == [2, 4, 2, 4, 1]
    assert np.max(np.abs(traces[2].residual)) < 1e-20
    stroke = draw_channel(traces[2])
    assert stroke.axes[1].get_xlabel() == "stroke [m]"
    assert len(stroke.axes[0].collections) == 2  # the band and the intervals of the points
    assert len(draw_channel(traces[3]).axes[0].lines[0].get_xdata()) <= 1500
    assert Page(identification_page(example_result(series=series))).count("figure") == 7


def test_flow_page_shows_law_and_budget():
    down = np.linspace(0.5e5, 6.5e5, 13)
    wobble = 1.0 + 0.004 * np.cos(7.0 * np.arange(13))
    flow = wobble * mass_flow_rate(7e5, down, 293.15, sonic_conductance=2e-8, critical_ratio=0.3)
    result = identify_flow(FlowPoints(flow, 7e5, down, 293.15), part="valve", title="Flow bench")
    (trace,) = traces_of(result)
    ratio, conductance = flow_curve(result, trace)
    c = result.parameters["valve.sonic_conductance"].value
    assert abs(conductance[0] / c - 1.0) < 1e-12
    assert np.max(np.abs(np.interp(trace.x, ratio, conductance) / trace.model - 1.0)) < 1e-3
    assert draw_channel(trace).axes[1].get_xlabel() == "p2/p1 [1]"
    text = Page(identification_page(result)).text
    assert "Formulas of the standard" in text
    assert "Uncertainty budget" in text
    assert "scatter of mass_flow_rate" in text
    for finding in result.findings:
        assert finding in text


def test_choked_flow_bench_has_no_curve():
    result = identify_flow(FlowPoints(np.full(6, 0.0166), 7e5, np.linspace(1e5, 1.2e5, 6), 293.15))
    (trace,) = traces_of(result)
    assert flow_curve(result, trace) is None
    assert "not known" in Page(identification_page(result)).text


@pytest.mark.parametrize("form", ["polynomial", "spline"])
def test_characteristic_page_shows_curves_before_coefficients(form):
    strokes = np.linspace(0.05e-3, 1e-3, 12)
    conductance = 1e-8 * np.minimum(strokes / 0.4e-3, 1.5 - 0.5 * strokes / 1e-3)
    tests = [StrokePoint(x, c, 0.4, 3e-11, 0.004) for x, c in zip(strokes, conductance, strict=True)]
    result = identify_characteristic(tests, form=form)
    page = Page(identification_page(result))
    assert page.text.index(" Fit ") < page.text.index(" Parameters parameter")
    assert "The 95 % band of sonic conductance stays within ±" in page.text
    assert "between the first and the last point" in page.text
    assert "Tests at the strokes" in page.text
    assert ("AICc with C monotone" in page.text) == (form == "spline")
    for name in (*result.parameters, *result.conditions["tests"]):
        assert name in page.text
    for finding in result.findings:
        assert finding in page.text


# --- file ---


def test_equal_results_give_equal_bytes(tmp_path):
    first = write_identification(example_result(), tmp_path / "a.html")
    second = write_identification(example_result(), str(tmp_path / "b.htm"))
    assert first.name == "a.html"
    assert first.read_bytes() == second.read_bytes()
    assert first.read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


@pytest.mark.parametrize(("name", "code"), [("a.pdf", "files.suffix"), ("no/a.html", "files.no_folder")])
def test_invalid_output_files_are_rejected(tmp_path, name, code):
    with refused(code, path=str(tmp_path / name)):
        write_identification(example_result(), tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def test_missing_matplotlib_is_reported(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with refused("missing.package", kind=MissingDependencyError, package="matplotlib", extra="plot"):
        write_identification(example_result(), tmp_path / "a.html")
    assert list(tmp_path.iterdir()) == []


def test_import_does_not_load_heavy_packages():
    code = (
        "import sys, poppet.report.identification.identification_report\n"
        "print(sorted({'matplotlib', 'scipy', 'pandas'} & set(sys.modules)))"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "[]"
