"""Reports of controller tunings and of controller comparisons."""

from __future__ import annotations

import numpy as np
import pytest

import poppet
from pages import lines, needs_nothing_else, plots
from poppet.control import compare, tune
from poppet.report.control_report import (
    comparison_page,
    figure_table,
    loop_figure,
    margin_table,
    tuning_page,
    write_comparison,
    write_tuning,
)
from poppet.timeseries.plotting.figures import style
from source_files import ROOT

EXAMPLES = ROOT.parents[1] / "examples"


@pytest.fixture(scope="module")
def circuit():
    return poppet.load(EXAMPLES / "pressure_control.toml")


@pytest.fixture(scope="module")
def tuning(circuit):
    return tune(circuit, at=["3 bar"])


@pytest.fixture(scope="module")
def comparison(circuit):
    other = poppet.load(EXAMPLES / "pressure_control_linearising.toml")
    return compare({"pid": circuit, "<law>": other}, vary={"tank.volume": 0.2}, draws=2)


def test_loop_figure_shows_the_loops_of_the_margins(tuning, circuit):
    (point,) = tuning.points
    with style("test"):
        left, right = loop_figure(tuning).axes
    sensitivities = {line.get_label(): line.get_ydata() for line in left.lines}
    for name, margins in point.margins.items():
        assert np.max(sensitivities[name]) == pytest.approx(margins.sensitivity, rel=2e-3)
    steps = {line.get_label(): line.get_ydata() for line in right.lines}
    highest = max(np.max(steps[name]) for name in point.margins)
    assert highest - 1.0 == pytest.approx(point.overshoot, abs=2e-3)
    assert all(abs(steps[name][-1] - 1.0) < 0.01 for name in point.margins)


def test_tuning_page_has_plot_gains_and_margins(tuning, circuit, tmp_path):
    text = tuning_page(tuning, circuit)
    needs_nothing_else(text)
    (plot,) = plots(text)
    assert plot["panels"][0]["x"]["log"]
    assert "gain = " in text
    for row in margin_table(tuning).cells():
        assert all(cell in text for cell in row)
    assert write_tuning(tuning, circuit, tmp_path / "tuning.html").read_text(encoding="utf-8") == text


def test_comparison_page_has_responses_and_metrics(comparison, tmp_path):
    text = comparison_page(comparison, "two")
    needs_nothing_else(text)
    (plot,) = plots(text)
    assert text.count("<svg") == 2
    assert [panel["title"] for panel in plot["panels"] if "title" in panel] == ["pid", "<law>"]
    time, pressure = lines(plot)["pressure [bar, absolute]: nominal"]
    assert np.allclose(time, comparison.time, atol=1e-9)
    assert np.allclose(pressure, comparison.responses["pid"][0] / 1e5, atol=1e-4)
    assert "&lt;law&gt;" in text
    for row in figure_table(comparison).cells():
        assert all(cell in text for cell in row[1:])
    assert write_comparison(comparison, tmp_path / "page.html", title="two").read_text(encoding="utf-8") == text
