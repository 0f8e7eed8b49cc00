"""Figures of recordings: drawn series, units, labels, and files."""

from __future__ import annotations

import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from functools import cache

import matplotlib as mpl
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from poppet import Chamber, Circuit, Orifice
from poppet.core.codes import Note
from poppet.core.errors import InputError, MissingDependencyError, OutOfRangeError, UnitError
from poppet.timeseries.plotting.figures import PALETTE
from poppet.timeseries.plotting.panels import bands_of, panels_of, readable, shown_series, spans_of, thinned
from poppet.timeseries.plotting.plots import COLUMNS, LINE_STYLES, MOST_RECORDINGS, home_colours, plot_recordings
from poppet.timeseries.recording import Recording

TIME = np.linspace(0.0, 10.0, 101)
STAIRS = np.where(TIME < 5.0, 2e5, 3e5)
SERIES = {
    "supply.pressure [Pa]": np.full(TIME.size, 7e5),
    "tank.pressure [Pa]": 1e5 + 1e4 * TIME,
    "valve.pilot_pressure [Pa]": STAIRS,
    "tank.temperature [K]": 293.15 + TIME,
    "valve.stroke [m]": 1e-4 * TIME,
    "valve.supply_mass_flow_rate [kg/s]": 1e-3 * TIME,
    "bleed.opening [1]": np.ones(TIME.size),
    "valve.supply_regime [1]": np.where(TIME < 4.0, 3.0, 2.0),
    "bleed.regime [1]": np.where(TIME < 6.0, -2.0, 0.0),
    "valve.contact [1]": np.where(TIME < 5.0, 1.0, -2.0),
}


@pytest.mark.parametrize(
    "title", ["bell \a", "escape \x1b[31m", "nul \0", "\ufffe", "压力试验", "a -- b --> c", "$\\frac{"]
)
def test_any_title_gives_a_valid_figure(title, tmp_path):
    titled = Recording.from_series([0.0, 1.0], {"tank.pressure [Pa]": [1e5, 2e5]}, title=title)
    plot_recordings({title: titled}, tmp_path / "title.svg")
    ElementTree.parse(tmp_path / "title.svg")


def recording(series=SERIES, **options) -> Recording:
    return Recording.from_series(TIME, series, **options)


def panel(figure, quantity: str):
    """Return the axes whose label begins with a quantity."""
    (panel_axes,) = [axes for axes in figure.axes if axes.get_ylabel().partition("\n")[0] == quantity]
    return panel_axes


def legend_texts(owner) -> list[str]:
    return [text.get_text() for text in owner.get_texts()]


def notes(figure) -> str:
    return "\n".join(text.get_text() for text in figure.texts)


@cache
def run_figure():
    """Return the figure of one run, which tests must not change."""
    return plot_recordings({"run": recording()})


# --- panels ---


def test_panels_have_usual_units():
    figure = run_figure()
    labels = [axes.get_ylabel() for axes in figure.axes if axes.get_ylabel()]
    assert labels == [
        "pressure\n[bar, absolute]",
        "temperature\n[°C]",
        "stroke\n[mm]",
        "mass flow rate\n[g/s]",
    ]
    assert figure.axes[-1].get_xlabel() == "time [s]"


def test_values_are_converted():
    figure = run_figure()
    tank = panel(figure, "pressure").lines[0]
    assert np.max(np.abs(tank.get_ydata() - (1.0 + 0.1 * TIME))) <= 1e-12
    temperature = panel(figure, "temperature").lines[0]
    assert np.max(np.abs(temperature.get_ydata() - (20.0 + TIME))) <= 1e-10


def test_gauge_recordings_are_shown_absolute():
    gauge = recording({"tank.pressure [bar g]": TIME}, ambient_pressure=0.95e5)
    line = plot_recordings({"bench": gauge}).axes[0].lines[0]
    assert np.max(np.abs(line.get_ydata() - TIME - 0.95)) <= 1e-12


def test_units_can_be_chosen():
    by_unit = plot_recordings({"run": recording()}, units=["bar g", "K"])
    assert panel(by_unit, "pressure").get_ylabel() == "pressure\n[bar g]"
    assert panel(by_unit, "temperature").get_ylabel() == "temperature\n[K]"
    by_name = plot_recordings({"run": recording()}, units={"tank.pressure": "kPa"})
    labels = [axes.get_ylabel() for axes in by_name.axes]
    assert "pressure\n[kPa, absolute]" in labels
    assert "pressure\n[bar, absolute]" in labels


def test_series_of_an_unknown_unit_have_a_separate_panel():
    counts = recording({"sensor.raw [counts]": TIME, "sensor.pressure [bar]": TIME})
    labels = [axes.get_ylabel() for axes in plot_recordings({"bench": counts}).axes]
    assert labels == ["pressure\n[bar, absolute]", "raw\n[counts]"]


def test_mass_flow_has_a_second_axis_of_air():
    flow = panel(run_figure(), "mass flow rate")
    (second,) = flow.child_axes
    assert second.get_ylabel() == "l/min ANR"
    flow.set_ylim(0.0, 1.185)
    flow.figure.canvas.draw()
    assert second.get_ylim()[1] == pytest.approx(60.0, rel=1e-12)


def test_mass_flow_of_another_gas_has_no_axis_of_air():
    helium_run = recording(SERIES)
    helium = Recording(
        helium_run.time,
        helium_run.names,
        helium_run.units,
        helium_run.values,
        notes=[Note("options.conductances_as_given", "gas")],
    )
    assert panel(plot_recordings({"run": helium}), "mass flow rate").child_axes == []


def test_constant_series_are_omitted_with_a_note():
    figure = run_figure()
    assert legend_texts(panel(figure, "pressure").get_legend()) == ["tank", "valve: pilot"]
    assert "These outputs are constant and were not drawn: supply.pressure 7 bar, bleed.opening 1." in notes(figure)


def test_constant_series_are_drawn_if_selected_or_alone():
    figure = plot_recordings({"run": recording()}, select=["supply.*", "tank.pressure"])
    assert legend_texts(figure.axes[0].get_legend()) == ["supply", "tank"]
    still = recording({"supply.pressure [Pa]": np.full(TIME.size, 7e5)})
    assert len(plot_recordings({"run": still}).axes[0].lines) == 1


def test_staircase_series_are_drawn_as_steps():
    tank, pilot = panel(run_figure(), "pressure").lines
    assert (tank.get_drawstyle(), pilot.get_drawstyle()) == ("default", "steps-post")


def test_names_are_shortened_if_they_remain_distinct():
    names = ["tank.pressure", "valve.pilot_pressure", "a.b.pressure"]
    assert list(readable(names, "pressure").values()) == ["tank", "valve: pilot", "a: b"]
    twins = ["valve.flow", "valve.flow_pressure"]
    assert list(readable(twins, "pressure").values()) == twins


def test_dollars_and_underscores_in_names_are_plain_text(tmp_path):
    odd = recording({"a$_x^$.pressure [bar]": TIME}, title="cost $5_{}$")
    plot_recordings({"$\\alpha$": odd, "b": odd}, tmp_path / "odd.svg")
    assert ElementTree.parse(tmp_path / "odd.svg").getroot().tag.endswith("svg")


# --- several recordings ---


def test_recordings_share_colours_and_differ_in_line_style():
    figure = plot_recordings({"model": recording(), "bench": recording()}, title="Two")
    lines = panel(figure, "temperature").lines
    assert len({line.get_color() for line in lines}) == 1
    assert lines[0].get_linestyle() == "-"
    assert lines[1].get_linestyle() == "--"
    assert legend_texts(figure.legends[0]) == ["model", "bench"]
    assert notes(figure).startswith("Two")


def test_recordings_may_have_different_series():
    bench = recording({"tank.pressure [bar]": 1.0 + 0.1 * TIME})
    figure = plot_recordings({"model": recording(), "bench": bench})
    assert len(panel(figure, "pressure").lines) == 3
    assert len(panel(figure, "temperature").lines) == 1


def test_a_part_keeps_its_colour_and_parts_of_a_panel_differ():
    figure = run_figure()
    tank, _ = panel(figure, "pressure").lines
    assert panel(figure, "temperature").lines[0].get_color() == tank.get_color()
    tanks = recording({f"tank_{k}.pressure [bar]": TIME + k for k in range(len(PALETTE))})
    colours = [line.get_color() for line in plot_recordings({"run": tanks}).axes[0].lines]
    assert len(set(colours)) == len(PALETTE)


def test_colours_repeat_if_necessary():
    tanks = recording({f"tank_{k}.pressure [bar]": TIME + k for k in range(len(PALETTE) + 5)})
    assert len(plot_recordings({"run": tanks}).axes[0].lines) == len(PALETTE) + 5
    assert home_colours([]) == {}


def test_there_are_line_styles_for_all_recordings():
    assert len(LINE_STYLES) == MOST_RECORDINGS


# --- timeline ---


def test_timeline_shows_regimes_then_contacts():
    axes = run_figure().axes[-1]
    labels = [text.get_text() for text in axes.texts]
    assert labels == ["valve: supply", "bleed", "valve", "flow\nregime", "contact"]


def test_timeline_colours_are_explained_and_reversed_flow_is_hatched():
    figure = run_figure()
    regimes, contacts = figure.legends
    assert legend_texts(regimes) == ["choked", "subsonic", "no flow", "subsonic, reversed"]
    assert [bool(patch.get_hatch()) for patch in regimes.get_patches()] == [False, False, False, True]
    assert legend_texts(contacts) == ["supply open", "lower stop"]


def test_a_band_contains_the_output_with_its_name():
    """The mass flow rate at the start of a tube has the address of the tube, those of the cells have numbers."""
    names = ("hose.mass_flow_rate", "hose.1.mass_flow_rate", "hose.2.mass_flow_rate")
    flows = {f"{name} [g/s]": (k + 1.0) * TIME for k, name in enumerate(names)}
    axes = panel(plot_recordings({"": recording(flows)}), "mass flow rate")
    (area,) = axes.collections
    heights = area.get_paths()[0].vertices[:, 1]
    assert heights.max() == pytest.approx(3.0 * TIME.max(), rel=1e-9)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["hose"]


@pytest.mark.parametrize("tolerance", [1e-4, 1e-3])
def test_timeline_ignores_small_flows(tolerance):
    """Near equal pressures, solver noise changes the flow direction at every step, and with it the regime."""
    tanks = {
        name: Chamber(volume=size, thermal="isothermal", initial_pressure=start)
        for name, size, start in (("one", "1 l", "3 bar"), ("two", "2 l", "1 bar"), ("three", "0.5 l", "1 bar"))
    }
    size = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}
    pipes = {"pipe": Orifice(from_="one", to="two", **size), "hose": Orifice(from_="two", to="three", **size)}
    run = Circuit(tanks | pipes).simulate(duration=600.0, relative_tolerance=tolerance)
    is_late = run.time > 60.0
    changes = sum(np.count_nonzero(np.diff(run[f"{name}.regime"][is_late])) for name in pipes)
    assert changes > 0  # else there is nothing to see here
    for band in bands_of([run], None, COLUMNS):
        assert [span.code for span in band.spans if span.start + span.width > 60.0] == [0]
        assert {span.code for span in band.spans} > {0}


def test_constant_series_of_no_size_have_no_sign():
    rec = Recording.from_series(
        [0.0, 1.0], {"tank.heat_flow_rate [W]": [-0.0, -0.0], "tank.pressure [bar]": [1.0, 2.0]}
    )
    figure = plot_recordings({"": rec})
    (note,) = (text.get_text() for text in figure.texts if "heat" in text.get_text())
    assert "-0" not in note
    assert "0 W" in note


def test_timeline_labels_contain_the_recording():
    axes = plot_recordings({"a": recording(), "b": recording()}).axes[-1]
    labels = [text.get_text() for text in axes.texts][:2]
    assert labels == ["valve: supply (a)", "valve: supply (b)"]


def test_selection_applies_to_the_timeline():
    figure = plot_recordings({"run": recording()}, select=["tank.pressure", "valve.contact"])
    assert [text.get_text() for text in figure.axes[-1].texts] == ["valve", "contact"]
    assert len(plot_recordings({"run": recording()}, select="tank.*").axes) == 2


def test_series_without_valid_codes_are_drawn_as_lines():
    voltage = recording({"switch.contact [V]": TIME, "x.regime [1]": 0.5 * TIME})
    figure = plot_recordings({"bench": voltage})
    assert len(figure.axes) == 2
    assert figure.legends == []


@settings(derandomize=True, deadline=None, max_examples=60)
@given(codes=arrays(float, st.integers(2, 60), elements=st.sampled_from([-3.0, 0.0, 2.0, 3.0])))
def test_spans_cover_the_time_once_and_hold_the_codes(codes):
    time = np.cumsum(np.linspace(0.1, 1.0, codes.size))
    spans, is_thinned = spans_of(time, codes, 1000)
    assert not is_thinned
    assert spans[0].start == time[0]
    assert abs(sum(span.width for span in spans) - (time[-1] - time[0])) <= 1e-12 * time[-1]
    middles = 0.5 * (time[1:] + time[:-1])
    starts = np.array([span.start for span in spans])
    drawn_codes = [spans[k].code for k in np.searchsorted(starts, middles, side="right") - 1]
    assert drawn_codes == codes[:-1].tolist()


def test_fast_codes_are_replaced_by_the_most_frequent_code():
    time = np.arange(10_000.0)
    codes = np.where(np.arange(time.size) % 3 == 0, 3.0, 2.0)
    spans, is_thinned = spans_of(time, codes, 500)
    assert is_thinned
    assert {span.code for span in spans} == {2}
    chatter = Recording.from_series(time, {"pipe.regime [1]": codes, "pipe.flow [kg/s]": time})
    assert "most frequent" in notes(plot_recordings({"run": chatter}))


def test_gaps_in_codes_stay_empty():
    spans, _ = spans_of(np.arange(4.0), np.array([3.0, np.nan, 2.0, 2.0]), 100)
    assert [(span.start, span.width, span.code) for span in spans] == [(0.0, 1.0, 3), (2.0, 1.0, 2)]


# --- many samples ---


@settings(derandomize=True, deadline=None, max_examples=60)
@given(
    values=arrays(float, st.integers(1, 400), elements=st.floats(-1e3, 1e3)),
    columns=st.integers(1, 30),
)
def test_thinning_keeps_ends_and_extremes(values, columns):
    indices = thinned(np.arange(float(values.size)), values, columns)
    assert (indices[0], indices[-1]) == (0, values.size - 1)
    assert np.all(np.diff(indices) > 0)
    assert len(indices) <= 5 * columns
    assert (values[indices].min(), values[indices].max()) == (values.min(), values.max())


def test_thinning_keeps_gaps():
    values = np.sin(np.arange(10_000.0))
    values[4000:4100] = np.nan
    assert np.isnan(values[thinned(np.arange(10_000.0), values, 50)]).any()


def test_long_recording_is_thinned_without_lost_peaks():
    time = np.arange(100_000.0)
    values = np.random.default_rng(7).normal(size=time.size)
    values[54_321] = 50.0
    (line,) = plot_recordings({"run": Recording.from_series(time, {"p.pressure [bar]": values})}).axes[0].lines
    assert len(line.get_xdata()) <= 5 * COLUMNS
    assert np.max(line.get_ydata()) == 50.0


@pytest.mark.parametrize(
    ("end", "label", "shown"),
    [
        (0.5, "time [ms]", 500.0),
        (90.0, "time [s]", 90.0),
        (3600.0, "time [min]", 60.0),
        (36000.0, "time [h]", 10.0),
    ],
)
def test_time_has_a_readable_unit(end, label, shown):
    run = Recording.from_series([0.0, end], {"tank.pressure [bar]": [1.0, 2.0]})
    axes = plot_recordings({"run": run}).axes[-1]
    assert axes.get_xlabel() == label
    assert axes.get_xlim()[1] == pytest.approx(shown, rel=1e-12)


def test_one_sample_is_a_marker():
    run = Recording.from_series([1.0], {"tank.pressure [bar]": [2.0]})
    assert plot_recordings({"run": run}).axes[0].lines[0].get_marker() == "o"


# --- files ---


@pytest.mark.parametrize(("suffix", "head"), [("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF")])
def test_files_are_the_same_every_time(tmp_path, suffix, head):
    contents = []
    for folder in ("one", "two"):
        path = tmp_path / folder / f"run.{suffix}"
        path.parent.mkdir()
        recording().plot(path)
        contents.append(path.read_bytes())
    assert contents[0].startswith(head)
    assert contents[0] == contents[1]
    assert b"<dc:date>" not in contents[0]
    assert [file.name for file in (tmp_path / "one").iterdir()] == [f"run.{suffix}"]


def test_unknown_format_is_rejected_before_drawing(tmp_path):
    with pytest.raises(InputError) as caught:
        plot_recordings({}, tmp_path / "run.bmp")
    assert caught.value.code == "files.suffix"


def test_a_missing_folder_is_named(tmp_path):
    with pytest.raises(InputError) as caught:
        recording().plot(tmp_path / "nowhere" / "run.png")
    assert caught.value.code == "files.no_folder"


def test_settings_of_matplotlib_do_not_change(tmp_path):
    settings = dict(mpl.rcParams)
    recording().plot(tmp_path / "run.svg")
    assert dict(mpl.rcParams) == settings


def test_no_window_system_is_used():
    program = (
        "import sys; from poppet.timeseries.recording import Recording\n"
        "Recording.from_series([0.0, 1.0], {'tank.pressure [bar]': [1.0, 2.0]}).plot()\n"
        "print('matplotlib.pyplot' in sys.modules)"
    )
    result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert result.stdout == "False\n"


def test_missing_package_has_an_installation_hint(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(MissingDependencyError) as caught:
        plot_recordings({"run": recording()})
    assert (caught.value.package, caught.value.extra) == ("matplotlib", "plot")


# --- what cannot be drawn ---


@pytest.mark.parametrize(
    ("recordings", "options", "error", "code", "name"),
    [
        ({}, {}, InputError, "drawing.nothing", None),
        (
            {"run": Recording(np.empty(0), ("a",), ("1",), np.empty((1, 0)))},
            {},
            InputError,
            "drawing.no_samples",
            "run",
        ),
        ({"run": Recording.from_series([0.0], {})}, {}, InputError, "drawing.no_samples", "run"),
        ({"run": recording()}, {"select": "tnak.pressure"}, InputError, "names.unknown", "tnak.pressure"),
        ({"run": recording()}, {"select": ["tank.*", "x*"]}, InputError, "names.unknown", "x*"),
        ({"run": recording()}, {"units": ["N"]}, InputError, "drawing.unused_unit", "N"),
        ({"run": recording()}, {"units": {"tank.mass": "g"}}, InputError, "drawing.unused_unit", "tank.mass"),
        (
            {"run": recording()},
            {"units": {"tank.pressure": "K"}},
            UnitError,
            "series.other_quantity",
            "tank.pressure",
        ),
        ({"run": recording()}, {"units": ["bra"]}, UnitError, "unit.misspelt", None),
        ({str(k): recording() for k in range(MOST_RECORDINGS + 1)}, {}, OutOfRangeError, "drawing.too_many", None),
    ],
)
def test_invalid_arguments_are_rejected(recordings, options, error, code, name):
    with pytest.raises(error) as caught:
        plot_recordings(recordings, **options)
    assert (caught.value.code, caught.value.facts.get("name", caught.value.address)) == (code, name)


# --- nothing is cut ---


def test_long_names_widen_the_figure():
    keys = [
        "a first run with a long name, as people give them",
        "another run with a name that is longer still",
    ]
    figure = plot_recordings(dict.fromkeys(keys, recording()), title="a title " * 30)
    figure.canvas.draw()  # legends find their places
    renderer = figure.canvas.get_renderer()
    texts = [text for axes in figure.axes for text in axes.texts] + list(figure.texts)
    texts += [text for legend in figure.legends for text in legend.get_texts()]
    for box in (text.get_window_extent(renderer) for text in texts):
        assert figure.bbox.x0 <= box.x0 <= box.x1 <= figure.bbox.x1
        assert figure.bbox.y0 <= box.y0 <= box.y1 <= figure.bbox.y1


def test_codes_of_one_sample_have_no_duration():
    assert spans_of(np.zeros(1), np.array([3.0]), 100) == ((), False)
    start = recording().between(0.0, 0.0)
    assert len(plot_recordings({"run": start}, select="*regime").axes) == 1


# --- inner series ---


def hiding(*names: str) -> Recording:
    recording = Recording.from_series(TIME, SERIES)
    return Recording(**(recording.fields() | {"inner": frozenset(names)}))


def test_internal_series_are_drawn_if_selected():
    recording = hiding("valve.stroke", "bleed.regime")
    default_labels = [axes.get_ylabel().partition("\n")[0] for axes in plot_recordings({"": recording}).axes]
    assert "stroke" not in default_labels
    all_labels = [axes.get_ylabel().partition("\n")[0] for axes in plot_recordings({"": recording}, inner=True).axes]
    assert "stroke" in all_labels
    assert len(plot_recordings({"": recording}, select="valve.stroke").axes) == 1
    notes = " ".join(" ".join(text.get_text() for text in plot_recordings({"": recording}).texts).split())
    assert str(Note("drawing.inner", count=2, first=["bleed.regime", "valve.stroke"])) in notes


def test_internal_series_are_drawn_if_no_others_exist():
    assert plot_recordings({"": hiding(*Recording.from_series(TIME, SERIES).names)}).axes


def test_files_keep_internal_series(tmp_path):
    recording = hiding("valve.stroke")
    assert Recording.read(recording.save(tmp_path / "run.parquet")).inner == {"valve.stroke"}
    assert Recording.read(recording.save(tmp_path / "run.csv")).inner == set()


def moving_load() -> Recording:
    """Return a recording of a body that sticks, slips and sticks, and of its chamber."""
    time = np.linspace(0.0, 1.0, 101)
    series = {
        "cap.pressure [Pa]": 1e5 + 1e5 * time,
        "cap.temperature [K]": 293.0 + time,
        "valve.stroke [m]": 1e-3 * time,
        "slide.position [m]": np.clip(time - 0.5, 0.0, 0.25),
        "slide.velocity [m/s]": ((time > 0.5) & (time < 0.75)).astype(float),
        "slide.acceleration [m/s^2]": np.zeros(101),
        "slide.friction_force [N]": 20.0 + time,
        "slide.friction_state [1]": ((time > 0.5) & (time < 0.75)).astype(float),
    }
    return Recording.from_series(time, series)


def test_motion_is_the_first_panel_and_friction_is_on_the_timeline():
    figure = plot_recordings({"": moving_load()})
    names = [axes.get_ylabel().partition("\n")[0] for axes in figure.axes]
    assert names == ["position", "velocity", "pressure", "force", ""]
    (rows,) = [axes for axes in figure.axes if not axes.get_ylabel()]
    spans = {collection.get_label(): collection.get_paths()[0].get_extents() for collection in rows.collections}
    assert set(spans) == {"sticks", "slips"}
    assert (spans["slips"].x0, spans["slips"].x1) == pytest.approx((0.51, 0.75), abs=0.011)
    complete = plot_recordings({"": moving_load()}, inner=True)
    assert "temperature" in [axes.get_ylabel().partition("\n")[0] for axes in complete.axes]


def test_steps_and_cycles_have_a_panel_beside_that_of_flags():
    from poppet import Reservoir, Sequence

    steps = {"one": {"on": ["a"], "next": {"two": "elapsed > 30 ms"}}, "two": {"next": {"one": "elapsed > 30 ms"}}}
    plc = Sequence(outputs=["a"], start="one", steps=steps)
    vent = Orifice(from_="supply", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3)
    parts = {"plc": plc, "supply": Reservoir(pressure="5 bar"), "vent": vent}
    recording = Circuit(parts, connections={"vent.opening": "plc.a"}).simulate(0.2, output_step=5e-3)
    panels, _ = panels_of(shown_series([recording], None, None))
    names = {panel.quantity: panel.names for panel in panels}
    # Regimes are drawn as bands, not in panels.
    assert set(names["number"]) - {"vent.regime"} == {"plc.step", "plc.cycles"}
    assert "plc.a" in names["ratio"]
