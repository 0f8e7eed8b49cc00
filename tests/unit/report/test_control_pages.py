"""Reports of controller tunings and of controller comparisons."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import poppet
from pages import lines, needs_nothing_else, plots
from poppet.control import compare, tune
from poppet.control.loop_figures import phase_of
from poppet.report.control_report import (
    comparison_page,
    figure_table,
    margin_table,
    tuning_page,
    write_comparison,
    write_tuning,
)
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


def test_bode_plot_shows_the_loops_and_margins(tuning, tmp_path):
    """The curves have |L| = 1 at the crossover, |L| = 1/gain margin at -180 degrees, and the tabulated sensitivity."""
    (point,) = tuning.points
    upper, middle, lower = tuning.plot_bode(tmp_path / "bode.svg").axes
    assert (tmp_path / "bode.svg").is_file()
    curves = [{line.get_label(): line.get_data() for line in axes.lines} for axes in (upper, middle, lower)]
    for name, margins in point.margins.items():
        (frequency, level), (_, phase), (_, sensitivity) = (curve[name] for curve in curves)
        logarithm = np.log(frequency)
        assert np.interp(np.log(margins.crossover), logarithm, level) == pytest.approx(0.0, abs=0.02)
        at_crossover = np.interp(np.log(margins.phase_frequency), logarithm, phase)
        assert at_crossover + 180.0 == pytest.approx(margins.phase_margin, abs=0.1)
        assert np.interp(np.log(margins.gain_frequency), logarithm, phase) == pytest.approx(-180.0, abs=0.2)
        decibels = np.interp(np.log(margins.gain_frequency), logarithm, level)
        assert decibels == pytest.approx(-20.0 * np.log10(margins.gain_margin), abs=0.02)
        assert np.max(sensitivity) == pytest.approx(margins.sensitivity, rel=2e-3)
    gain, phase = (min(getattr(m, key) for m in point.margins.values()) for key in ("gain_margin", "phase_margin"))
    (gain_text,), (phase_text,) = ([text.get_text() for text in axes.texts] for axes in (upper, middle))
    assert f"gain margin {gain:.3g} " in gain_text
    assert f"phase margin {phase:.3g}°" in phase_text


def test_lower_gain_margins_are_in_the_table_and_the_bode_plot(tuning):
    (point,) = tuning.points
    assert "lower gain margin" not in margin_table(tuning).text()
    first, *others = point.margins
    lower = replace(point.margins[first], lower_gain_margin=0.25, lower_gain_frequency=0.5)
    conditional = replace(tuning, points=(replace(point, margins={**point.margins, first: lower}),))
    table = margin_table(conditional)
    assert table.columns[-1].heading == "lower gain margin"
    assert [row[-1] for row in table.rows] == [0.25, *(None for _ in others)]
    upper = conditional.plot_bode().axes[0]
    assert upper.texts[0].get_text().rstrip().endswith(", lower 0.25")
    squares = [line.get_data() for line in upper.lines if line.get_marker() == "s"]
    assert any(x[0] == 0.5 and y[0] == pytest.approx(12.04, abs=0.01) for x, y in squares)


def test_step_plot_marks_overshoot_and_settling(tuning):
    (point,) = tuning.points
    upper, lower = tuning.plot_steps().axes
    steps = {line.get_label(): line.get_data() for line in upper.lines}
    overshoot = max(np.max(steps[name][1]) for name in point.margins) - 1.0
    assert overshoot == pytest.approx(point.overshoot, abs=2e-3)
    settled = 0.0
    for name in point.margins:
        time, values = steps[name]
        last = np.flatnonzero(np.abs(values - 1.0) > 0.02)[-1]
        settled = max(settled, time[last + 1])
    assert any(f"after {settled:.3g} s" in text.get_text() for text in upper.texts)
    disturbed = {line.get_label(): line.get_data() for line in lower.lines}
    assert all(abs(disturbed[name][1][-1]) < 0.01 * np.max(disturbed[name][1]) for name in point.margins)


def test_tuning_has_a_card_in_notebooks(tuning):
    text = tuning._repr_html_()
    assert text.count("<svg") == 2
    assert all(colour not in text for colour in ("#1b1f24", "#6b7280", "#e6e8ec"))
    for row in margin_table(tuning).cells():
        assert all(cell in text for cell in row)


def test_tuning_page_has_plot_gains_and_margins(tuning, circuit, tmp_path):
    text = tuning_page(tuning, circuit)
    needs_nothing_else(text)
    bode, steps = plots(text)
    assert all(panel["x"]["log"] for panel in bode["panels"])
    assert not any("log" in panel["x"] for panel in steps["panels"])
    assert "gain = " in text
    for row in margin_table(tuning).cells():
        assert all(cell in text for cell in row)
    assert write_tuning(tuning, circuit, tmp_path / "tuning.html").read_text(encoding="utf-8") == text


def test_bode_plot_of_the_page_has_dashed_lines_of_the_present_gains(tuning, circuit):
    """A factor of 0.5 on the gain is -6.02 dB; an unstable loop has no sensitivity and no margins."""
    tuned = tuning.applied(circuit)
    gain = tuned.parameters["regulator.gain"]
    for factor, is_stable in ((0.5, True), (20.0, False)):
        present = tuned.with_values({"regulator.gain": factor * gain})
        page = tuning_page(tuning, present, origin="a < b")
        curves = lines(plots(page)[0])
        for name in tuning.points[0].margins:
            (_, present_level), (_, level) = (
                curves[f"magnitude |L| [dB]: {name}{end}"] for end in (", present gains", "")
            )
            assert np.allclose(present_level - level, 20.0 * np.log10(factor), atol=0.02)
            assert (f"sensitivity |S| [1]: {name}, present gains" in curves) == is_stable
        assert "With the gains of a &lt; b:" in page
        assert ("3 bar, fill: unstable" in page) != is_stable


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


@pytest.mark.parametrize(
    ("first", "low"), [(5.0, 0.0), (-1.0, -10.0), (-179.0, -190.0), (-270.5, -280.0), (179.5, -190.0)]
)
def test_phase_of_a_bode_plot_begins_near_the_frequency_response_without_delay(first, low):
    """A small lead stays above 0, and two integrations of a PI loop begin at -180 or -270 degrees."""
    course = np.linspace(first, first - 400.0, 200)
    phase = phase_of(np.exp(1j * np.radians(course)))
    assert low <= phase[0] <= low + 15.0
    assert np.diff(phase) == pytest.approx(np.diff(course))
