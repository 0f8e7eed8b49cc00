from __future__ import annotations

import builtins
import math
import pickle
import sys
import types

import numpy as np
import pytest

from poppet.core.errors import InputError, InputErrors, MissingDependencyError, UnitError
from poppet.timeseries.checks import split_heading
from poppet.timeseries.recording import Recording
from refusals import refused

SUFFIXES = [".csv", ".parquet", ".mat"]


@pytest.fixture
def recording() -> Recording:
    time = np.array([0.0, 0.1, 0.30000000000000004])
    values = np.array([[1e5, 2e5 / 3, 3e5], [293.15, 300.0, 310.0], [0.0, -5e-324, 1.7976931348623157e308]])
    return Recording(
        time,
        ("tank.pressure", "tank.temperature", "bleed.opening"),
        ("Pa", "K", "1"),
        values,
        title="filling",
        notes=("the wall is assumed", "sampled late: 20 µs"),
        outcome="The run reached its end.",
        statistics={"steps": 12},
        ambient_pressure=95000.0,
    )


def test_series_are_found_by_name(recording):
    assert recording["tank.temperature"].tolist() == [293.15, 300.0, 310.0]
    assert recording.unit("tank.pressure") == "Pa"
    assert "tank.pressure" in recording
    assert "tank.mass" not in recording
    assert len(recording) == 3
    assert list(recording) == ["tank.pressure", "tank.temperature", "bleed.opening"]
    assert recording.last()["tank.pressure"] == 3e5


def test_unknown_name_has_a_suggestion(recording):
    with pytest.raises(InputError) as caught:
        recording["tank.presure"]
    assert caught.value.code == "names.unknown"
    assert caught.value.facts["suggestion"].names[0] == "tank.pressure"


@pytest.mark.parametrize("shown", ["time", "values"])
def test_arrays_are_read_only_views(recording, shown):
    with pytest.raises(ValueError, match="read-only"):
        getattr(recording, shown)[0] = 1.0


def test_constructor_does_not_lock_its_arguments():
    time = np.array([0.0, 1.0])
    recording = Recording(time, ("a",), ("1",), np.zeros((1, 2)))
    time[1] = 2.0
    assert recording.time[1] == 2.0


def test_repr_names_series_units_and_extent(recording):
    assert repr(recording).splitlines() == [
        "Recording 'filling': 3 times, 0 ... 0.3 s; 3 series",
        "  tank.pressure     66666.7 ... 300000 Pa",
        "  tank.temperature  293.15 ... 310 K",
        "  bleed.opening     -4.94066e-324 ... 1.79769e+308 1",
    ]
    assert repr(Recording(np.zeros(0), (), (), np.zeros((0, 0)))).endswith("no samples; 0 series")


def test_select_keeps_the_requested_order(recording):
    assert recording.select("tank.*").names == ("tank.pressure", "tank.temperature")
    selection = recording.select(["bleed.opening", "*.pressure", "tank.*"])
    assert selection.names == ("bleed.opening", "tank.pressure", "tank.temperature")
    assert selection["tank.pressure"].tolist() == recording["tank.pressure"].tolist()
    assert selection.units == ("1", "Pa", "K")
    assert selection.notes == recording.notes
    with pytest.raises(InputError) as caught:
        recording.select(["tank.*", "tank.m*"])
    assert (caught.value.code, caught.value.address) == ("names.unknown", "tank.m*")


def test_between_includes_both_ends(recording):
    assert recording.between(0.1, 0.30000000000000004).time.tolist() == [0.1, 0.30000000000000004]
    assert recording.between(0.05, 0.2)["tank.temperature"].tolist() == [300.0]
    with pytest.raises(InputError) as caught:
        recording.between(5.0, 6.0)
    assert caught.value.code == "series.window"
    assert caught.value.facts == {"start": 5.0, "stop": 6.0, "first": 0.0, "last": 0.30000000000000004}
    with pytest.raises(InputError) as caught:
        Recording(np.zeros(0), (), (), np.zeros((0, 0))).between(0.0, 1.0)
    assert caught.value.code == "series.window_of_nothing"


def test_interpolation_is_linear_without_extrapolation(recording):
    np.testing.assert_allclose(recording.interpolate("tank.temperature", [0.05, 0.2]), [296.575, 305.0])
    assert recording.interpolate("tank.temperature", 0.1) == 300.0
    for time in (-0.1, 0.5, math.nan):
        with pytest.raises(InputError) as caught:
            recording.interpolate("tank.temperature", [0.1, time])
        assert caught.value.code == "series.outside"


def test_converted_by_name(recording):
    converted = recording.converted({"tank.pressure": "bar g", "*.temperature": "degC"})
    assert converted.units == ("bar g", "degC", "1")
    assert converted["tank.pressure"][0] == pytest.approx(0.05)
    assert converted["tank.temperature"][0] == 20.0
    assert recording.units == ("Pa", "K", "1")
    assert recording["tank.pressure"][0] == 1e5


def test_converted_by_unit_alone(recording):
    converted = recording.converted(["bar", "degC"])
    assert converted.units == ("bar", "degC", "1")
    assert converted["tank.pressure"].tolist() == pytest.approx([1.0, 2 / 3, 3.0])
    assert recording.converted("bar").units == ("bar", "K", "1")


def test_converted_refuses_other_quantities(recording):
    with pytest.raises(UnitError) as caught:
        recording.converted({"tank.pressure": "degC"})
    assert caught.value.code == "series.other_quantity"
    assert caught.value.facts == {"name": "tank.pressure", "unit": "Pa", "asked": "degC"}
    with refused("unit.misspelt", kind=UnitError):
        recording.converted(["bars"])
    with pytest.raises(InputError) as caught:
        recording.converted(["kg"])
    assert caught.value.code == "series.no_such_quantity"
    assert caught.value.facts["units"] == ("Pa", "K", "1")


def test_from_series_reads_units_of_headings_and_arguments():
    recording = Recording.from_series([0, 1], {"a [Pa]": [1, 2], "b": [3, 4], "c": [5, 6]}, units={"b": "K"})
    assert recording.names == ("a", "b", "c")
    assert recording.units == ("Pa", "K", "")
    assert recording["b"].tolist() == [3.0, 4.0]
    assert recording.time.dtype == float


def test_from_series_without_series():
    assert Recording.from_series([0.0, 1.0], {}).values.shape == (0, 2)


@pytest.mark.parametrize(
    ("time", "series", "units", "code", "facts"),
    [
        ([0.0, 0.0], {"a": [1, 2]}, {}, "series.time.not_increasing", {"place": 0, "time": 0.0, "next": 0.0}),
        ([0.0, math.inf], {"a": [1, 2]}, {}, "series.time.not_finite", {"place": 1, "time": math.inf}),
        ([], {}, {}, "series.time.shape", {"shape": (0,)}),
        ([[0.0, 1.0]], {}, {}, "series.time.shape", {"shape": (1, 2)}),
        ([0.0, 1.0], {"a": [1, 2, 3]}, {}, "series.length", {"name": "a", "shape": (3,), "times": 2}),
        ([0.0, 1.0], {"a": ["x", "y"]}, {}, "series.numbers", {"name": "a"}),
        ([0.0, 1.0], {"a [Pa]": [1, 2], "a [bar]": [1, 2]}, {}, "series.twice", {"name": "a"}),
        ([0.0, 1.0], {"a": [1, 2]}, {"b": "Pa"}, "series.no_unit_of", {"name": "b"}),
        ([0.0, 1.0], {"[Pa]": [1, 2]}, {}, "series.heading", {"heading": "[Pa]"}),
    ],
)
def test_from_series_checks(time, series, units, code, facts):
    with pytest.raises(InputError) as caught:
        Recording.from_series(time, series, units=units)
    assert caught.value.code == code
    assert facts.items() <= caught.value.facts.items()


def test_from_series_reports_all_errors():
    with pytest.raises(InputErrors) as caught:
        Recording.from_series([1.0, 0.0], {"a": [1], "b": [1, 2, 3]})
    assert len(caught.value.problems) == 3


@pytest.mark.parametrize(
    ("heading", "expected"),
    [
        ("tank.pressure [Pa]", ("tank.pressure", "Pa")),
        (" a b [m^3/(s Pa)] ", ("a b", "m^3/(s Pa)")),
        ("time", ("time", "")),
        ("x []", ("x", "")),
    ],
)
def test_split_heading(heading, expected):
    assert split_heading(heading) == expected


def test_pandas_has_time_as_index(recording):
    frame = recording.to_pandas()
    assert frame.index.name == "time"
    assert frame.index.tolist() == recording.time.tolist()
    assert frame["tank.pressure"].tolist() == recording["tank.pressure"].tolist()
    assert frame.attrs["units"]["tank.temperature"] == "K"


def test_plot_calls_the_report(recording, monkeypatch):
    call = {}
    plots = types.ModuleType("poppet.timeseries.plotting.plots")
    plots.plot_recordings = lambda *given, **options: call.update(given=given, options=options)
    monkeypatch.setitem(sys.modules, "poppet.timeseries.plotting.plots", plots)
    recording.plot("out.svg", select=["tank.*"])
    assert call == {"given": ({"filling": recording}, "out.svg"), "options": {"select": ["tank.*"]}}


def test_a_recording_can_be_sent_to_another_process(recording):
    restored = pickle.loads(pickle.dumps(recording))
    np.testing.assert_array_equal(restored.values, recording.values)
    assert restored.notes == recording.notes


def test_csv_is_the_public_contract(recording, tmp_path):
    recording.select(["tank.pressure", "bleed.opening"]).save(tmp_path / "out.csv")
    assert (tmp_path / "out.csv").read_bytes() == (
        b"time [s],tank.pressure [Pa],bleed.opening [1]\n"
        b"0,100000,0\n"
        b"0.10000000000000001,66666.666666666672,-4.9406564584124654e-324\n"
        b"0.30000000000000004,300000,1.7976931348623157e+308\n"
    )


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_written_files_are_read_without_changes(recording, tmp_path, suffix):
    path = recording.save(tmp_path / f"out{suffix}")
    restored = Recording.read(path)
    assert restored.names == recording.names
    assert restored.units == recording.units
    np.testing.assert_array_equal(restored.time, recording.time)
    np.testing.assert_array_equal(restored.values, recording.values)


@pytest.mark.parametrize("suffix", [".parquet", ".mat"])
def test_parquet_and_mat_keep_the_metadata(recording, tmp_path, suffix):
    restored = Recording.read(recording.save(tmp_path / f"out{suffix}"))
    assert restored.title == "filling"
    assert restored.notes == recording.notes
    assert restored.outcome == recording.outcome
    assert restored.statistics == {"steps": 12.0}
    assert restored.ambient_pressure == 95000.0


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_one_sample_of_one_series_and_missing_values(tmp_path, suffix):
    single = Recording.from_series([2.0], {"a [Pa]": [math.nan]})
    restored = Recording.read(single.save(tmp_path / f"out{suffix}"))
    assert restored.time.tolist() == [2.0]
    assert np.isnan(restored["a"]).tolist() == [True]


def test_csv_headings_with_commas_are_quoted(tmp_path):
    recording = Recording.from_series([0.0, 1.0], {'the "a", first [Pa]': [1.0, 2.0]})
    assert Recording.read(recording.save(tmp_path / "out.csv")).names == ('the "a", first',)


def test_mat_names_are_valid_and_restored(tmp_path):
    from scipy.io import loadmat

    names = ["tank.pressure", "tank__pressure", "time", "1st", "a-b", "x" * 80, "x" * 81]
    recording = Recording.from_series([0.0, 1.0], {name: [float(i), 0.0] for i, name in enumerate(names)})
    path = recording.save(tmp_path / "out.mat")
    variables = [name for name in loadmat(path) if not name.startswith("__")]
    assert {"time", "tank__pressure", "tank__pressure_2", "time_2", "x1st", "a_b"} <= set(variables)
    assert all(name.isidentifier() and len(name) <= 63 for name in variables)
    restored = Recording.read(path)
    assert list(restored.names) == names
    assert [restored[name][0] for name in names] == list(range(len(names)))


def test_parquet_carries_the_unit_of_each_column(recording, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    schema = parquet.read_schema(recording.save(tmp_path / "out.parquet"))
    assert schema.field("tank.pressure").metadata == {b"unit": b"Pa"}
    assert schema.field("time").metadata == {b"unit": b"s"}


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_failed_write_keeps_the_old_file(recording, tmp_path, suffix, monkeypatch):
    path = tmp_path / f"out{suffix}"
    path.write_bytes(b"old")
    broken = recording.select("*")
    monkeypatch.setattr(broken, "names", (*broken.names, "one too many"))
    with pytest.raises(ValueError, match="zip"):
        broken.save(path)
    assert path.read_bytes() == b"old"
    assert [file.name for file in tmp_path.iterdir()] == [path.name]


def test_a_full_disk_is_an_input_error_and_leaves_nothing(recording, tmp_path, monkeypatch):
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("poppet.timeseries.recording_files._write_csv", full)
    with pytest.raises(InputError) as caught:
        recording.save(tmp_path / "out.csv")
    assert (caught.value.code, caught.value.facts["why"]) == ("files.full", "No space left on device")
    assert list(tmp_path.iterdir()) == []


def test_a_link_stays_a_link(recording, tmp_path):
    (tmp_path / "real.csv").write_text("old")
    (tmp_path / "link.csv").symlink_to(tmp_path / "real.csv")
    recording.save(tmp_path / "link.csv")
    assert (tmp_path / "link.csv").is_symlink()
    assert (tmp_path / "real.csv").read_text().startswith("time [s]")


def test_unwritable_paths_are_rejected(recording, tmp_path):
    with pytest.raises(InputError) as caught:
        recording.save(tmp_path / "missing" / "out.csv")
    assert (caught.value.code, caught.value.facts["folder"]) == ("files.no_folder", str(tmp_path / "missing"))
    (tmp_path / "folder.csv").mkdir()
    with pytest.raises(InputError) as caught:
        recording.save(tmp_path / "folder.csv")
    assert (caught.value.code, caught.value.facts["kind"]) == ("files.no_file", "folder")
    assert [file.name for file in tmp_path.iterdir()] == ["folder.csv"]


@pytest.mark.parametrize("name", ["out.xlsx", "out", "out.cvs"])
def test_unknown_suffixes(recording, tmp_path, name):
    for attempt in (recording.save, Recording.read):
        with pytest.raises(InputError) as caught:
            attempt(tmp_path / name)
        assert caught.value.code == "files.suffix"
        assert ".csv" in (caught.value.facts["suggestion"].names or caught.value.facts["suggestion"].valid_names)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_missing_file(tmp_path, suffix):
    with pytest.raises(InputError) as caught:
        Recording.read(tmp_path / f"none{suffix}")
    assert (caught.value.code, caught.value.facts["why"]) == ("files.unreadable", "No such file or directory")


@pytest.mark.parametrize(
    ("content", "line", "code", "facts"),
    [
        (b"", None, "table.empty", {}),
        (b"  \n\n", None, "table.empty", {}),
        (b"time [s],a\n", None, "table.no_samples", {}),
        (b"time [s],a\n0,\x00\n", None, "table.binary", {}),
        (b"time [s],a\n0,1\n1,\xb0C\n", 3, "table.not_utf_8", {}),
        (b"a,b\n0,1\n", 1, "series.no_time", {"column": "time"}),
        (b"time,time [s]\n0,1\n", 1, "series.two_times", {"column": "time"}),
        (b"time [s];a\n0;1\n", 1, "table.semicolons", {}),
        (b"time [s],a,a\n0,1,2\n", 1, "series.twice", {"name": "a"}),
        (b"time [s],a [Pa],a [bar]\n0,1,2\n", 1, "series.twice", {"name": "a"}),
        (b"time [s],a [Pa]\n0,1\n\n1,x\n", 4, "table.cell_of_recording", {"cell": "x", "column": "a [Pa]"}),
        (b"time [s],a\n0,1_0\n", 2, "table.cell_of_recording", {"cell": "1_0", "column": "a"}),
        (b"time [s],a\n0,1d3\n", 2, "table.cell_of_recording", {"cell": "1d3", "column": "a"}),
        (b"time [s],a\n0,\n", 2, "table.cell_of_recording", {"cell": "", "column": "a"}),
        (b"time [s],a\n0,1\n1,2,3\n", 3, "table.cells", {"cells": 3, "columns": 2}),
        (b"time [s],a\n0,1,2\n1,2,3\n", 2, "table.cells", {"cells": 3, "columns": 2}),
        (b"time [s],a\n0,1\nnan,2\n", 3, "series.time.not_finite", {"place": 1}),
        (b"time [s],a\n0,1\n\n2,2\n1,3\n", 5, "series.time.not_increasing", {"place": 1, "time": 2.0, "next": 1.0}),
        (b"time [bars],a\n0,1\n", 1, "unit.misspelt", {"symbol": "bars"}),
        (b"time [Pa],a\n0,1\n", 1, "unit.other_quantity", {"asked": "s"}),
        (b"time [s],[Pa]\n0,1\n", 1, "series.heading", {"heading": "[Pa]"}),
    ],
)
def test_bad_csv_files_name_file_and_line(tmp_path, content, line, code, facts):
    path = tmp_path / "bad.csv"
    path.write_bytes(content)
    with pytest.raises(InputError) as caught:
        Recording.read(path)
    assert (caught.value.code, caught.value.line) == (code, line)
    assert facts.items() <= caught.value.facts.items()
    assert str(caught.value).startswith(f"{path}:{line}: " if line else f"{path}: ")


def test_csv_of_other_programs(tmp_path):
    path = tmp_path / "bench.csv"
    path.write_bytes(b"\xef\xbb\xbfpressure [bar], time [ms] ,count\r\n1.5,0,3\r\n\r\n2.5,100,nan\r\n")
    bench = Recording.read(path)
    assert bench.time.tolist() == [0.0, 0.1]
    assert bench.units == ("bar", "")
    assert bench["pressure"].tolist() == [1.5, 2.5]
    assert bench.title == "bench"
    assert bench.notes == ()


def test_a_time_column_without_unit_is_noted(tmp_path):
    (tmp_path / "a.csv").write_text("time,a\n0,1\n")
    assert [note.code for note in Recording.read(tmp_path / "a.csv").remarks] == ["series.time_without_unit"]


@pytest.mark.parametrize("suffix", [".parquet", ".mat"])
def test_files_of_another_kind(tmp_path, suffix):
    path = tmp_path / f"bad{suffix}"
    path.write_bytes(b"this is neither a table nor a matrix, but long enough to be read as a heading" * 4)
    with pytest.raises(InputError) as caught:
        Recording.read(path)
    assert (caught.value.code, caught.value.file) == ("table.unsound", str(path))


def test_files_of_other_programs(tmp_path):
    from scipy.io import savemat

    savemat(tmp_path / "other.mat", {"time": [0.0, 1.0], "a": [1.0, 2.0]})
    with pytest.raises(InputError) as caught:
        Recording.read(tmp_path / "other.mat")
    assert caught.value.code == "series.foreign"
    pa = pytest.importorskip("pyarrow")
    parquet = pytest.importorskip("pyarrow.parquet")
    parquet.write_table(pa.table({"time": [0.0, 1.0]}), tmp_path / "other.parquet")
    with pytest.raises(InputError) as caught:
        Recording.read(tmp_path / "other.parquet")
    assert caught.value.code == "series.foreign"


@pytest.mark.parametrize("suffix", [".parquet", ".mat"])
def test_series_with_the_name_of_the_time(tmp_path, suffix):
    recording = Recording.from_series([0.0, 1.0], {"time [V]": [5.0, 6.0], "time_2": [7.0, 8.0], "poppet": [9.0, 0.0]})
    restored = Recording.read(recording.save(tmp_path / f"out{suffix}"))
    assert (restored.names, restored.units) == (recording.names, recording.units)
    assert restored.time.tolist() == [0.0, 1.0]
    np.testing.assert_array_equal(restored.values, recording.values)


def test_a_csv_file_has_one_time(tmp_path):
    with pytest.raises(InputError) as caught:
        Recording.from_series([0.0, 1.0], {"time [V]": [5.0, 6.0]}).save(tmp_path / "out.csv")
    assert (caught.value.code, caught.value.facts) == ("series.two_times", {"column": "time"})
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("package", ["pandas", "pyarrow"])
def test_missing_package_has_a_hint(recording, tmp_path, monkeypatch, package):
    real = builtins.__import__

    def without(name: str, *rest: object, **options: object) -> object:
        if name.split(".")[0] == package:
            raise ImportError(name)
        return real(name, *rest, **options)

    monkeypatch.setattr(builtins, "__import__", without)
    use = recording.to_pandas if package == "pandas" else lambda: recording.save(tmp_path / "out.parquet")
    with pytest.raises(MissingDependencyError) as caught:
        use()
    assert (caught.value.package, caught.value.extra) == (package, "data")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("key", "kind"),
    [("time", "time"), (slice(1, 3), "slice"), (["a"], "list"), (0, "int")],
)
def test_invalid_keys_have_a_hint(key, kind):
    recording = Recording.from_series([0.0, 1.0], {"a [Pa]": [1.0, 2.0]})
    with pytest.raises(InputError) as caught:
        recording[key]
    assert caught.value.code == f"series.key.{kind}"


@pytest.mark.parametrize("suffix", [".csv", ".parquet", ".mat"])
def test_a_recording_without_rows_is_not_written(suffix, tmp_path):
    nothing = Recording(np.zeros(0), ("p",), ("Pa",), np.zeros((1, 0)))
    with refused("files.no_rows"):
        nothing.save(tmp_path / f"nothing{suffix}")
    assert not list(tmp_path.iterdir())
