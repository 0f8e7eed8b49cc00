"""Interactive plots: data of figures, and behaviour of the page in a browser."""

from __future__ import annotations

import hashlib
import re
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

from chromium import Browser, found
from pages import column, lines, needs_nothing_else, plots
from poppet.report.html_page import document, head, picture
from poppet.report.plots.interactive import DIGITS, MAX_POINTS, data_element, plot_data
from poppet.report.tables import ReportTable, numeric
from poppet.timeseries.plotting.figures import axes_in, new_figure, style
from poppet.timeseries.plotting.plots import plot_recordings
from poppet.timeseries.recording import Recording

TIME = np.linspace(0.0, 120.0, 1201)
PRESSURE = 1e5 + 4e5 * (1.0 - np.exp(-TIME / 20.0))
REGIME = np.where(TIME < 40.0, 3.0, np.where(TIME < 90.0, 2.0, -1.0))
SERIES = {
    "tank.pressure [Pa]": PRESSURE,
    "valve.setpoint [Pa]": np.where(TIME < 60.0, 2e5, 4e5),
    "tank.temperature [K]": 293.15 + 20.0 * np.sin(TIME / 10.0),
    "valve.mass_flow_rate [kg/s]": 1e-2 * np.cos(TIME / 10.0),
    "valve.regime [1]": REGIME,
}
UPLOT = {
    "uPlot.iife.min.js": "19c8d4c6ad88929a79f4ae49d6f7161566dfd0ba3d15cc495e974f787eb78f1f",
    "uPlot.min.css": "df630c6a8d6f8eeaff264b50f73ce5b114f646ffd9a0bb74f049b0a00135fa04",
}


def recording(**changed) -> Recording:
    return Recording.from_series(TIME, SERIES | changed)


def page_of(figure) -> str:
    with style("test"):
        return document("Plots", [("", head("Plots", "A page.")), ("Run", picture(figure, "run", "The run."))])


def data_of_axes(draw) -> dict:
    with style("test"):
        figure = new_figure(6.0, 4.0)
        draw(axes_in(figure, 1.0, 0.5, 4.5, 3.0))
        data = plot_data(figure)
    assert data is not None
    return data


# --- data ---


def test_plot_contains_the_recorded_values():
    text = page_of(plot_recordings({"": recording()}))
    (plot,) = plots(text)
    lines_by_label = lines(plot)
    expected = {
        "pressure [bar, absolute]: tank": PRESSURE / 1e5,
        "pressure [bar, absolute]: valve: setpoint": SERIES["valve.setpoint [Pa]"] / 1e5,
        "temperature [°C]: tank": SERIES["tank.temperature [K]"] - 273.15,
        "mass flow rate [g/s]: valve": 1e3 * SERIES["valve.mass_flow_rate [kg/s]"],
    }
    assert set(lines_by_label) == set(expected)
    for name, values in expected.items():
        time, shown_values = lines_by_label[name]
        assert np.allclose(time, TIME, rtol=0.0, atol=1e-9 * TIME[-1])
        assert np.max(np.abs(shown_values - values)) <= 10.0**-DIGITS * np.ptp(values)
    assert text.count("<svg") == 1
    needs_nothing_else(text)


def test_regimes_are_boxes_along_the_time_axis():
    (plot,) = plots(page_of(plot_recordings({"": recording()})))
    (panel,) = [panel for panel in plot["panels"] if "rows" in panel]
    assert panel["rows"] == [[0.0, "valve"]]
    spans = {box["label"]: (box["at"][0], box["at"][2], box.get("hatch", False)) for box in panel["boxes"]}
    assert list(spans.values()) == [(0.0, 40.0, False), (40.0, 90.0, False), (90.0, 120.0, True)]
    assert {panel["group"] for panel in plot["panels"]} == {0}


def test_second_axis_has_a_factor():
    (plot,) = plots(page_of(plot_recordings({"": recording()})))
    (second,) = [panel["y"]["second"] for panel in plot["panels"] if "second" in panel["y"]]
    assert second == {"label": "l/min ANR", "factor": pytest.approx(60e3 / 1.185e3, rel=2e-3)}


def test_thinned_line_keeps_its_extremes():
    values = np.zeros(20_000)
    values[12_345] = 1.0
    data = data_of_axes(lambda axes: axes.plot(np.arange(20_000.0), values, label="peak"))
    ((x, y),) = lines(data).values()
    assert data["panels"][0]["lines"][0]["of"] == 20_000
    assert x.size <= MAX_POINTS
    assert x[np.argmax(y)] == 12_345


def test_page_states_the_number_of_samples_of_a_thinned_line():
    time = np.linspace(0.0, 1.0, 3 * MAX_POINTS)
    run = Recording.from_series(time, {"a.pressure [Pa]": 1e5 * (2.0 + np.sin(500.0 * time))})
    (plot,) = plots(page_of(plot_recordings({"": run})))
    assert plot["panels"][0]["lines"][0]["of"] == time.size


def test_nan_interrupts_a_line():
    data = data_of_axes(lambda axes: axes.plot([0.0, 1.0, 3.0], [1.0, np.nan, 2.0]))
    ((_, y),) = lines(data).values()
    assert np.isnan(y).tolist() == [False, True, False]


def test_bands_boxes_rules_segments_and_texts_are_converted():
    x = np.array([1.0, 10.0, 1000.0])

    def draw(axes):
        axes.semilogx(x, x, marker="o", label="a", drawstyle="steps-post", linestyle=(0, (5, 2)))
        axes.fill_between(x, x - 1.0, x + 2.0, label="band", alpha=0.3)
        axes.axhline(3.0, label="limit")
        axes.axvspan(2.0, 5.0)
        axes.vlines(x, x - 1.0, x + 1.0)
        axes.text(10.0, 5.0, "here")

    data = data_of_axes(draw)
    (panel,) = data["panels"]
    assert panel["x"]["log"]
    (line,), (band,), (rule,), (box,) = (panel[key] for key in ("lines", "bands", "rules", "boxes"))
    assert (line["step"], line["marker"], len(line["dash"])) == (True, "o", 2)
    assert column(data, band["low"]).tolist() == [0.0, 9.0, 999.0]
    assert column(data, band["high"]).tolist() == [3.0, 12.0, 1002.0]
    assert (rule["axis"], rule["at"], rule["label"]) == ("y", 3.0, "limit")
    assert box["at"] == [2.0, None, 5.0, None]
    assert panel["segments"][0]["at"] == [1.0, 0.0, 1.0, 2.0, 10.0, 9.0, 10.0, 11.0, 1000.0, 999.0, 1000.0, 1001.0]
    assert panel["texts"][0][:3] == [10.0, 5.0, "here"]


def test_tick_labels_are_converted():
    data = data_of_axes(lambda axes: (axes.plot([0.0, 2.0], [1.0, 2.0]), axes.set_xticks([0.0, 2.0], ["low", "high"])))
    assert data["panels"][0]["x"]["ticks"] == [[0.0, 2.0], ["low", "high"]]


@pytest.mark.parametrize(
    "draw",
    [
        lambda axes: axes.pcolormesh(np.eye(3)),
        lambda axes: axes.contourf(np.eye(3)),
        lambda axes: axes.imshow(np.eye(3)),
        lambda axes: axes.set_axis_off(),
        lambda axes: axes.set_yscale("symlog"),
    ],
)
def test_maps_and_drawings_have_no_plot_data(draw):
    with style("test"):
        figure = new_figure(4.0, 3.0)
        draw(axes_in(figure, 0.5, 0.5, 3.0, 2.0))
        assert plot_data(figure) is None


def test_labels_are_escaped_in_the_data_element():
    element = data_element({"label": "</script><script>alert(1)</script> & <!--"})
    assert element.count("</script>") == 1
    assert plots(element) == [{"label": "</script><script>alert(1)</script> & <!--"}]


def test_page_without_plots_has_no_script():
    text = document("a", [("", "<p>b</p>")])
    needs_nothing_else(text)
    assert "<script" not in text


def test_uplot_files_are_the_published_ones():
    folder = files("poppet.report.plots") / "uplot"
    assert "MIT" in (folder / "LICENSE").read_text(encoding="utf-8")
    assert "1.6.32" in (folder / "VERSION.txt").read_text(encoding="utf-8")
    for name, digest in UPLOT.items():
        assert hashlib.sha256((folder / name).read_bytes()).hexdigest() == digest


# --- in a browser ---


@pytest.fixture(scope="module")
def browser():
    program = found()
    if program is None:
        pytest.skip("no browser was found; set POPPET_BROWSER")
    with Browser(program) as instance:
        yield instance


@pytest.fixture(scope="module")
def page(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("page") / "page.html"
    path.write_text(page_of(plot_recordings({"": recording()})), encoding="utf-8")
    return path


@pytest.fixture
def screen(browser, page):
    browser.events.clear()
    browser.open(page)
    return browser


def panel_area(browser, panel: int = 0) -> tuple[float, float, float, float]:
    """Return the position of a panel on the screen: left, top, width and height."""
    return tuple(
        browser(
            f"(r => [r.left, r.top, r.width, r.height])(document.querySelectorAll('.u-over')[{panel}]"
            ".getBoundingClientRect())"
        )
    )


def legend_texts(browser) -> list[str]:
    browser.settle()
    return browser("[...document.querySelectorAll('.keys')].map(each => each.innerText.replace(/\\s+/g, ' '))")


def point(browser, share: float) -> None:
    left, top, wide, high = panel_area(browser)
    browser.mouse("Moved", left + share * wide, top + 0.5 * high)


def drag(browser, start: float, end: float) -> None:
    left, top, wide, high = panel_area(browser)
    y = top + 0.5 * high
    browser.mouse("Moved", left + start * wide, y)
    browser.mouse("Pressed", left + start * wide, y, is_down=True, clicks=1)
    for share in np.linspace(start, end, 6):
        browser.mouse("Moved", left + share * wide, y, is_down=True)
    browser.mouse("Released", left + end * wide, y, clicks=1)
    browser.settle()


def times_in_legends(texts: list[str]) -> list[float]:
    return [float(re.search(r"time \[s\] (-?[\d.]+)", text)[1]) for text in texts]


def test_browser_shows_plots_without_other_requests(screen, page):
    assert screen("document.querySelectorAll('figure.is-live canvas').length") == 4
    assert screen("getComputedStyle(document.querySelector('.still')).display") == "none"
    addresses = [e["params"]["request"]["url"] for e in screen.events if e.get("method") == "Network.requestWillBeSent"]
    assert addresses == [page.as_uri()]


def test_pointer_reads_values_in_all_panels(screen):
    point(screen, 0.25)
    texts = legend_texts(screen)
    assert times_in_legends(texts) == pytest.approx([30.0] * 4, abs=0.2)
    time = times_in_legends(texts)[0]
    shown_pressure = float(re.search(r"tank ([\d.]+)", texts[0])[1])
    assert shown_pressure == pytest.approx(np.interp(time, TIME, PRESSURE) / 1e5, abs=2e-3)
    assert "valve: setpoint 2.000" in texts[0]
    assert texts[3].count("choked") >= 2  # the legend entry and the value at the pointer


def test_drag_enlarges_all_panels_and_double_click_resets_them(screen):
    drag(screen, 0.25, 0.5)
    point(screen, 0.5)
    assert times_in_legends(legend_texts(screen)) == pytest.approx([45.0] * 4, abs=0.3)
    assert not screen("document.querySelector('.foot button').hidden")
    left, top, wide, high = panel_area(screen, 1)
    for clicks in (1, 2):
        for kind in ("Pressed", "Released"):
            screen.mouse(kind, left + 0.5 * wide, top + 0.5 * high, is_down=kind == "Pressed", clicks=clicks)
    point(screen, 0.5)
    assert times_in_legends(legend_texts(screen)) == pytest.approx([60.0] * 4, abs=0.3)
    assert screen("document.querySelector('.foot button').hidden")


def test_click_on_a_legend_entry_hides_its_line(screen):
    count_pixels = (
        "(c => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.reduce((n, v, k) => n + (k % 4 == 3 && v),"
        " 0))(document.querySelector('canvas'))"
    )
    n_pixels_before = screen(count_pixels)
    screen("document.querySelector('.key').click()")
    screen.settle()
    assert screen(count_pixels) < n_pixels_before
    assert screen("document.querySelector('.key').getAttribute('aria-pressed')") == "false"


def test_a_band_of_cells_is_read_and_hidden_with_its_edges(browser, tmp_path):
    cells = {f"hose.{k}.pressure [Pa]": 1e5 * (1.0 + k * TIME / 120.0) for k in (1, 2, 3)}
    path = tmp_path / "cells.html"
    path.write_text(page_of(plot_recordings({"": Recording.from_series(TIME, cells)})), encoding="utf-8")
    browser.open(path)
    point(browser, 0.5)
    (text,) = legend_texts(browser)
    assert [float(value) for value in re.search(r"hose (.+) to (.+)", text).groups()] == pytest.approx(
        [1.5, 2.5], abs=0.02
    )
    coloured = """[...document.querySelector('canvas').getContext('2d').getImageData(0, 0, 800, 200).data].filter(
        (v, k, all) => k % 4 === 2 && v > all[k - 2] + 40 && all[k + 1]).length"""
    assert browser(coloured) > 5000
    browser("document.querySelector('.key').click()")
    browser.settle()
    assert browser(coloured) == 0


def test_enlarged_thinned_line_shows_a_note(browser, tmp_path):
    time = np.linspace(0.0, 10.0, 20_001)
    run = Recording.from_series(time, {"a.pressure [Pa]": 1e5 * (2.0 + np.sin(300.0 * time))})
    path = tmp_path / "fine.html"
    path.write_text(page_of(plot_recordings({"": run})), encoding="utf-8")
    browser.open(path)
    note = "document.querySelector('.foot strong').textContent"
    drag(browser, 0.2, 0.8)
    assert browser(note) == ""
    for _ in range(3):
        drag(browser, 0.4, 0.6)
    assert "20001" in browser(note)


def test_page_without_scripts_shows_the_pictures(browser, page, tmp_path):
    path = tmp_path / "bare.html"
    text = page.read_text(encoding="utf-8")
    path.write_text(re.sub(r"<script>.*?</script>", "", text, flags=re.DOTALL), encoding="utf-8")
    browser.open(path)
    assert browser("document.querySelector('.still svg').getBoundingClientRect().width") > 500


def test_inserted_script_does_not_run(browser, page, tmp_path):
    path = tmp_path / "foreign.html"
    text = page.read_text(encoding="utf-8")
    path.write_text(text.replace("</main>", "<script>document.title = 'foreign'</script></main>"), encoding="utf-8")
    browser.open(path)
    assert browser("document.title") == "Plots"
    assert browser("document.querySelectorAll('figure.is-live').length") == 1


def test_print_shows_the_pictures(browser, page):
    browser.open(page, media="print")
    displays = browser("['.live', '.still'].map(each => getComputedStyle(document.querySelector(each)).display)")
    assert displays == ["none", "block"]


def test_dark_page_inverts_background_and_plots(browser, page):
    browser.open(page, scheme="dark")
    assert browser("getComputedStyle(document.body).backgroundColor") == "rgb(18, 18, 18)"
    assert "invert" in browser("getComputedStyle(document.querySelector('canvas')).filter")


def test_narrow_screen_shows_all_values_of_a_table(browser, tmp_path):
    cells = [f"{10.0**k:.4f} dm³/(s bar)" for k in range(8)]
    wide = ReportTable(
        ("heading 0", *numeric(*(f"heading {k}" for k in range(1, 8)))), [["valve.sonic_conductance", *cells[1:]]] * 3
    )
    path = tmp_path / "table.html"
    path.write_text(document("a_title_" * 12, [("", head("a_title_" * 12, "Table")), ("", wide)]), encoding="utf-8")
    browser.open(path, 360)
    assert browser("document.documentElement.scrollWidth") == 360
    ends = browser("[...document.querySelectorAll('td, h1')].map(each => each.getBoundingClientRect().right)")
    assert len(ends) == 25
    assert max(ends) <= 360
    browser.open(path, 1200)
    assert browser("getComputedStyle(document.querySelector('tr')).display") == "table-row"


def test_touch_screen_reads_values_and_enlarges_with_two_fingers(browser, page):
    browser.open(page, 360)
    assert browser("document.documentElement.scrollWidth") == 360
    left, top, wide, high = panel_area(browser)
    assert wide > 250
    y = top + 0.5 * high
    browser.fingers("Start", (left + 0.5 * wide, y))
    browser.fingers("Move", (left + 0.25 * wide, y))
    assert times_in_legends(legend_texts(browser)) == pytest.approx([30.0] * 4, abs=0.5)
    browser.fingers("End")
    browser.fingers("Start", (left + 0.4 * wide, y), (left + 0.6 * wide, y))
    for spread in (0.2, 0.3, 0.4):
        browser.fingers("Move", (left + (0.5 - spread) * wide, y), (left + (0.5 + spread) * wide, y))
    browser.fingers("End")
    assert not browser("document.querySelector('.foot button').hidden")
    browser.fingers("Start", (left + 0.5 * wide, y))
    browser.fingers("End")
    browser("document.querySelector('.foot button').click()")
    assert browser("document.querySelector('.foot button').hidden")
