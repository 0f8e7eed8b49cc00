"""HTML output in notebooks: valid self-contained HTML, values of each object, and plots that keep peaks."""

from __future__ import annotations

import re
import subprocess
import sys
from dataclasses import dataclass, field
from functools import cache
from html.parser import HTMLParser
from importlib import import_module
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Recording, Reservoir
from poppet.bench.iso10094.bench_result import DEFINITIONS, BenchResult
from poppet.bench.iso10094.evaluation import CharacteristicValue
from poppet.bench.limits.maps import LimitsResult
from poppet.core import notebook
from poppet.core.codes import Note
from poppet.core.errors import MissingDependencyError
from poppet.ensemble import Ensemble
from poppet.identify.result import Estimate, Result
from poppet.report.notebook import CARDS, html_of
from poppet.report.notebook.cards import COLUMNS, MAX_LINES, MAX_ROWS, STYLE, WIDTH, svg_path, svg_plot
from poppet.signals import Constant
from poppet.timeseries.plotting.panels import Series

TITLE = 'a <b>bold</b> & "quoted" title'
VOID = {"br", "hr", "img"}


@dataclass
class ParsedHtml(HTMLParser):
    """Parsed HTML: elements, texts, table rows, and tags that are not closed."""

    elements: list[tuple[str, dict[str, str | None]]] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    open_tags: list[str] = field(default_factory=list)
    rows: list[list[str]] = field(default_factory=list)

    def __post_init__(self) -> None:
        super().__init__()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open_tags.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open_tags.pop() == tag

    def handle_data(self, data: str) -> None:
        if "style" not in self.open_tags:
            self.texts.append(data)
        if {"td", "th"} & set(self.open_tags):
            self.rows[-1][-1] += data

    def named(self, tag: str) -> list[dict[str, str | None]]:
        return [attrs for name, attrs in self.elements if name == tag]


def parse_html(text: str) -> ParsedHtml:
    document = ParsedHtml()
    document.feed(text)
    document.close()
    assert document.open_tags == []
    return document


def circuit(title: str = TITLE) -> Circuit:
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "fill": Orifice(from_="supply", to="tank", nominal_flow="380 l/min ANR"),
        "tank": Chamber(volume="1 l", wall_conductance=1.0),
    }
    return Circuit(parts, {"fill.opening": Constant(0.5)}, title=title)


def estimates() -> dict[str, Estimate]:
    determined = Estimate(1.1e-8, "m^3/(s Pa)", 1e-11, 1.08e-8, 1.12e-8, "determined", 1e-8)
    return {
        "valve.sonic_conductance": determined,
        "valve.critical_ratio": Estimate(0.3, "1", 0.2, 0.0, 0.7, "weak", 0.4),
    }


def limits() -> LimitsResult:
    plan: Any = SimpleNamespace(
        circuit=circuit(), valve="valve", mean=3e5, volumes=(1e-3, 1e-2), amplitudes=(1e4, 1e5), springs=(), dampings=()
    )
    point: Any = SimpleNamespace(gain_frequency=12.5, limiting="solenoids", noise=0.0, gains={"solenoids": 1.6})
    return LimitsResult(plan, {(1e-3, 1e4): point})


def ensemble() -> Ensemble:
    volume = {"tank.volume": {"distribution": "uniform", "relative_range": 0.1}}
    end = {"end": {"of": "tank.pressure", "metric": "final"}}
    result = (
        circuit()
        .with_values({"run.duration": "1 s"})
        .ensemble(runs=5, parameters=volume, metrics=end, requirements={"soft": "end < 9 bar"})
    )
    assert isinstance(result, Ensemble)
    return result


@cache
def objects_by_kind() -> dict[str, Any]:
    definitions = list(DEFINITIONS.items())[:5]
    figures = {
        name: CharacteristicValue(1.5, definition.unit, "definition with < and >", conditions={})
        for name, definition in definitions
    }
    note = Note("said", text="<i>careful</i> & so on")
    return {
        "circuit": circuit(),
        "recording": circuit().simulate(duration="1 s"),
        "linear": circuit().linearise(),
        "identification": Result("fit", TITLE, estimates(), remarks=(note,)),
        "bench": BenchResult(TITLE, "circuit", figures, notes={"bench": (note,)}),
        "limits": limits(),
        "ensemble": ensemble(),
    }


KINDS = ("circuit", "recording", "linear", "identification", "bench", "limits", "ensemble")
every_kind = pytest.mark.parametrize("kind", KINDS)


@every_kind
def test_card_is_valid_and_self_contained_html(kind):
    text = objects_by_kind()[kind]._repr_html_()
    document = parse_html(text)
    names = {name for name, _ in document.elements}
    assert not names & {"script", "link", "img", "iframe", "b>bold<", "i>careful<"}
    assert not re.search(r"https?://|@import|url\((?!#)", text)
    assert not any(key.startswith("on") for _, attrs in document.elements for key in attrs)
    assert len(text) < 120_000
    if kind != "linear":
        assert TITLE in document.texts


@every_kind
def test_colours_follow_the_notebook(kind):
    """All colours of the schematic are replaced by colours of JupyterLab, VS Code or the page."""
    text = objects_by_kind()[kind]._repr_html_()
    body = text.partition("</style>")[2]
    assert not re.search(r"(?:fill|stroke): (?:#|white|black)", body)
    assert "currentColor" in STYLE
    assert "--vscode-editor-foreground" in STYLE
    assert "--jp-content-font-color1" in STYLE


def test_every_class_with_html_output_has_a_card():
    for name in CARDS:
        module, _, kind = name.rpartition(".")
        assert issubclass(getattr(import_module(module), kind), notebook.HtmlMixin)
    kinds = {cls.__name__ for cls in notebook.HtmlMixin.__subclasses__()}
    results = {"Result", "BenchResult", "LimitsResult", "Ensemble", "Tuning"}
    assert kinds == {"Columns", "BaseCircuit", "LinearModel"} | results
    assert html_of(3.0) is None


def test_without_a_renderer_the_result_is_none(monkeypatch):
    monkeypatch.setattr(notebook.HtmlMixin, "renderer", None)
    assert circuit()._repr_html_() is None


# --- circuit ---


def test_circuit_card_has_schematic_and_assumed_values():
    document = parse_html(objects_by_kind()["circuit"]._repr_html_())
    (svg,) = document.named("svg")
    assert TITLE in (svg["aria-label"] or "")
    assumed = [a for a, n in circuit().numbers().items() if n.source.kind == "assumed"]
    assert [row[0] for row in document.rows[1:]] == assumed
    assert "fill.critical_ratio" in assumed
    assert ("open" in document.named("details")[0]) == (len(assumed) <= MAX_ROWS)


def test_two_schematics_share_no_identifiers():
    circuits = (circuit(), circuit().with_values({"tank.volume": "2 l"}))
    first, second = (
        {attrs["id"] for _, attrs in parse_html(shown_circuit._repr_html_() or "").elements if "id" in attrs}
        for shown_circuit in circuits
    )
    assert first
    assert not first & second


def test_circuit_card_without_matplotlib_names_the_missing_package(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    document = parse_html(circuit()._repr_html_() or "")
    assert document.named("svg") == []
    assert str(MissingDependencyError("matplotlib", "A picture of a circuit", "plot")) in document.texts
    assert len(document.rows) > 1


# --- recording ---


def points(d: str) -> list[tuple[float, float]]:
    """Return the points of an SVG path of the commands M, L, H and V."""
    positions: list[tuple[float, float]] = []
    for command, numbers in re.findall(r"([MLHV])([^MLHV]*)", d):
        values = [float(v) for v in numbers.split()]
        x, y = positions[-1] if positions else (0.0, 0.0)
        positions.append({"H": (values[0], y), "V": (x, values[0])}.get(command) or (values[0], values[1]))
    return positions


def test_card_of_a_long_recording_is_small_and_keeps_peaks():
    time = np.linspace(0.0, 100.0, 1_000_001)
    noise = np.random.default_rng(1).normal(size=(3, time.size))
    series = {f"tank{k}.pressure [Pa]": 2e5 + 1e3 * row for k, row in enumerate(noise)}
    series["tank0.pressure [Pa]"][432_100] = 9e5
    text = Recording.from_series(time, series)._repr_html_() or ""
    assert len(text) < 40_000
    paths = [points(element["d"] or "") for element in parse_html(text).named("path")]
    assert [len(path_points) <= 4 * COLUMNS + 2 for path_points in paths] == [True] * 3
    top = min(paths[0], key=lambda point: point[1])
    assert top == (round(0.4321 * WIDTH), 0.0)
    lowest = max(y for path_points in paths for _, y in path_points)
    assert lowest == 100.0


def test_series_table_has_end_and_extreme_values_in_usual_units():
    series = {"tank.pressure [Pa]": [1e5, 3e5, 2e5], "valve.command": [0.0, 1.0, -0.0]}
    rec = Recording.from_series([0.0, 1.0, 2.0], series)
    rows = parse_html(rec._repr_html_() or "").rows
    assert rows[0] == ["series", "unit", "first", "last", "min", "max"]
    assert rows[1:] == [["tank.pressure", "bar", "1", "2", "1", "3"], ["valve.command", "", "0", "0", "0", "1"]]


def test_recordings_without_a_curve_have_a_card():
    empty = Recording(np.zeros(0), ("a.pressure",), ("Pa",), np.zeros((1, 0)))  # a run that failed at the start
    single_sample = Recording.from_series([0.0], {"a.pressure [Pa]": [1e5]})
    constant = Recording.from_series([0.0, 1.0], {"a.pressure [Pa]": [1e5, 1e5]})
    without_series = Recording.from_series([0.0, 1.0], {})
    with_gap = Recording(np.arange(3.0), ("a.x",), ("m",), np.array([[0.0, np.nan, 1.0]]))
    without_values = Recording(np.arange(3.0), ("a.x",), ("m",), np.full((1, 3), np.nan))
    recordings = (empty, single_sample, constant, without_series, with_gap, without_values)
    counts = [len(parse_html(rec._repr_html_() or "").named("path")) for rec in recordings]
    assert counts == [0, 0, 0, 0, 1, 0]


def test_every_part_has_a_line_before_a_second_line_of_a_part():
    time = np.linspace(0.0, 1.0, 11)
    names = [f"valve.p{k}" for k in range(MAX_LINES + 3)] + ["tank.pressure"]
    rec = Recording.from_series(time, {f"{name} [Pa]": 1e5 * (1.0 + time) for name in names})
    document = parse_html(svg_plot(rec))
    assert len(document.named("path")) == MAX_LINES
    assert "tank" in document.texts
    assert f"and {len(names) - MAX_LINES} more" in document.texts


def test_steps_are_horizontal_first_and_nan_is_a_gap():
    def drawn(values: list[float]) -> str:
        time = np.arange(float(len(values)))
        series = Series("a", 0, time, np.array(values), "1", "", 0)
        return svg_path(series, (0.0, float(len(values) - 1)), (0.0, 1.0))

    assert drawn([0.0, 0.0, 0.0, 1.0, 1.0, 1.0]) == "M0 100L400 100H600V0L1000 0"
    assert drawn([0.0, 1.0, np.nan, 0.5, 1.0]) == "M0 100L250 0M750 50L1000 0"


def test_horizontal_line_that_ends_within_a_column_stays_horizontal():
    """The last point of a horizontal line stays in the path, even if points before it are repeated."""
    time = np.linspace(0.0, 1.0, 4001)
    values = np.where(time < 0.5, 1.0, 0.0) + np.where(time > 0.9, 0.3 * (time - 0.9), 0.0)
    positions = points(svg_path(Series("a", 0, time, values, "1", "", 0), (0.0, 1.0), (0.0, 1.0)))
    heights = np.interp([100, 300, 490, 600, 800], *zip(*positions, strict=True))
    assert heights.tolist() == [0.0, 0.0, 0.0, 100.0, 100.0]


def test_recording_card_does_not_import_matplotlib():
    code = (
        "import sys, poppet\n"
        "rec = poppet.Recording.from_series([0.0, 1.0], {'tank.pressure [Pa]': [1e5, 2e5]})\n"
        "assert '<path' in rec._repr_html_()\n"
        "assert 'matplotlib' not in sys.modules and 'casadi' not in sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


# --- linear models and results ---


def test_linear_card_has_modes_and_operating_point():
    model = objects_by_kind()["linear"]
    rows = parse_html(model._repr_html_()).rows
    modes = [row for row in rows if row[0].replace(".", "").replace("-", "").replace("e", "").isdigit()]
    assert len(modes) == sum(value.imag >= 0.0 for value in model.poles())
    point = {row[1]: float(row[2]) for row in rows if row[0] == "state"}
    assert list(point) == list(model.states)
    assert list(point.values()) == pytest.approx(model.x, rel=1e-5)


def test_result_cards_have_their_values():
    document = parse_html(objects_by_kind()["identification"]._repr_html_())
    assert [row[:2] for row in document.rows[1:]] == [[name, e.verdict] for name, e in estimates().items()]
    assert "<i>careful</i> & so on" in document.texts
    figures = list(objects_by_kind()["bench"].figures)
    shown_figures = [row[0].replace(" ", "_") for row in parse_html(objects_by_kind()["bench"]._repr_html_()).rows]
    assert [name for name in shown_figures if name in figures] == figures
    rows = parse_html(objects_by_kind()["limits"]._repr_html_()).rows
    assert [row[0] for row in rows] == ["volume", "1 l", "10 l"]
    assert rows[1][1:] == ["12.5 Hz, solenoids", "-"]


# --- editors ---


def test_series_names_are_completed():
    rec = objects_by_kind()["recording"]
    assert rec._ipython_key_completions_() == list(rec.names)


def test_dir_lists_only_the_public_api():
    shown_circuit = circuit()
    names = dir(shown_circuit)
    assert dir(type(shown_circuit)) == names
    assert all(not name.startswith("_") and hasattr(shown_circuit, name) for name in names)
    assert {"simulate", "with_values", "linearise", "steady_state", "numbers", "parts", "title"} <= set(names)
    assert not {"like", "kernel", "instance", "problem", "structure", "domains"} & set(names)


class _Dataset:
    def __init__(self, series: Any, coordinates: Any, attrs: Any) -> None:
        self.series, self.coordinates, self.attrs = series, coordinates, attrs


def test_xarray_dataset_has_series_units_and_time(monkeypatch):
    stand_in = ModuleType("xarray")
    stand_in.Dataset = _Dataset  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "xarray", stand_in)
    rec = objects_by_kind()["recording"]
    data = rec.to_xarray()
    assert list(data.series) == list(rec.names)
    dimension, values, attrs = data.series["tank.pressure"]
    assert (dimension, attrs) == ("time", {"units": "Pa"})
    np.testing.assert_array_equal(values, rec["tank.pressure"])
    values[0] = 0.0  # a copy
    assert rec["tank.pressure"][0] != 0.0
    np.testing.assert_array_equal(data.coordinates["time"][1], rec.time)
    assert data.attrs["title"] == TITLE
    assert data.attrs["ambient_pressure"] == rec.ambient_pressure


def test_missing_xarray_is_reported(monkeypatch):
    monkeypatch.setitem(sys.modules, "xarray", None)
    with pytest.raises(MissingDependencyError) as caught:
        objects_by_kind()["recording"].to_xarray()
    assert caught.value.facts["package"] == "xarray"


def test_xarray_dataset_of_the_real_package():
    pytest.importorskip("xarray")
    rec = objects_by_kind()["recording"]
    data = rec.to_xarray()
    assert data["tank.pressure"].attrs["units"] == "Pa"
    assert float(data["tank.pressure"].sel(time=0.5, method="nearest")) == rec.interpolate("tank.pressure", 0.5)
