"""Cells of a tube in figures: one band from minimum to maximum, or each cell if it is wanted."""

from __future__ import annotations

import re

import numpy as np
import pytest

from poppet import Recording
from poppet.report.plots.interactive import plot_data
from poppet.timeseries.plotting.figures import style
from poppet.timeseries.plotting.plots import plot_recordings

TIME = np.linspace(0.0, 1.0, 8001)
CELLS = [1e5 * (2.0 + k * np.sin(7.0 * TIME) + (np.abs(TIME - 0.3) < 1e-4) * k) for k in (1.0, -0.4, 0.2)]


@pytest.fixture(scope="module")
def recording() -> Recording:
    series = {f"hose.{k + 1}.pressure [Pa]": cell for k, cell in enumerate(CELLS)}
    series |= {"tank.pressure [Pa]": 1e5 * (1.0 + TIME), "pipe.1.pressure [Pa]": 1e5 * (2.0 - TIME)}
    return Recording.from_series(TIME, series)


def legend(axes) -> list[str]:
    return [text.get_text() for text in axes.get_legend().get_texts()]


def test_band_has_the_extremes_of_all_cells(recording: Recording) -> None:
    figure = plot_recordings({"run": recording})
    (axes,) = figure.axes
    assert legend(axes) == ["hose", "tank", "pipe: 1"]
    (band,) = axes.collections
    (path,) = band.get_paths()
    rows = np.array(CELLS) / 1e5
    low, high = path.vertices[:, 1].min(), path.vertices[:, 1].max()
    assert (low, high) == (pytest.approx(rows.min()), pytest.approx(rows.max()))
    # The short peak of one cell at 0.3 s is not lost by thinning.
    at_peak = path.vertices[np.abs(path.vertices[:, 0] - 0.3) < 1e-4, 1]
    assert at_peak.max() == pytest.approx(rows[:, 2400].max())
    assert any("hose" in text.get_text() and "--all" in text.get_text() for text in figure.texts)


@pytest.mark.parametrize("options", [{"inner": True}, {"select": "*.pressure"}])
def test_cells_are_drawn_on_request(recording: Recording, options: dict) -> None:
    (axes,) = plot_recordings({"run": recording}, **options).axes
    assert not axes.collections
    assert {"hose: 1", "hose: 2", "hose: 3"} <= set(legend(axes))


def test_overlay_has_a_band_for_each_recording(recording: Recording) -> None:
    other = Recording.from_series(TIME, {f"hose.{k}.pressure [Pa]": 3e5 + 1e4 * k * TIME for k in (1, 2)})
    (axes,) = plot_recordings({"a": recording, "b": other}).axes
    assert len(axes.collections) == 2
    assert legend(axes).count("hose") == 1


def test_interactive_plot_has_the_band(recording: Recording) -> None:
    with style("test"):
        data = plot_data(plot_recordings({"run": recording}))
    assert data is not None
    (panel,) = data["panels"]
    (band,) = panel["bands"]
    assert band["label"] == "hose"
    assert max(v for v in data["columns"][band["high"]] if v is not None) == pytest.approx(
        np.max(CELLS) / 1e5, rel=1e-4
    )


def test_notebook_has_the_band(recording: Recording) -> None:
    text = recording._repr_html_() or ""
    plot = text.partition("<table")[0]
    assert re.findall(r"</i>([^<]*)</span>", plot) == ["hose", "tank", "pipe: 1"]
    assert plot.count("fill-opacity") == 1
