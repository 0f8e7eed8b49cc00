"""Tables of measured columns: all formats, layouts of text files, and rejected files."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet import Recording
from poppet.core.codes import Note
from poppet.core.errors import InputError, MissingDependencyError
from poppet.timeseries.tables.reading import Table, read_table
from poppet.timeseries.tables.table import heading_of

TIME = [0.0, 0.1, 0.2, 0.3]
PRESSURE = [7.5, 6.25, 5.0, 4.125]


def written(folder: Path, text: str | bytes, name: str = "bench.csv") -> Path:
    file = folder / name
    file.write_bytes(text.encode() if isinstance(text, str) else text)
    return file


def refused(file: Path, **options: Any) -> InputError:
    with pytest.raises(InputError) as caught:
        read_table(file, **options)
    return caught.value


def body(separator: str, decimal: str) -> str:
    rows = [f"{t}{separator}{p}".replace(".", decimal) for t, p in zip(TIME, PRESSURE, strict=True)]
    return "\n".join(rows) + "\n"


def assert_bench(table: Table, names: tuple[str, ...] = ("t", "p"), units: tuple[str, ...] = ("s", "bar")) -> None:
    assert table.names == names
    assert table.units == units
    assert table.columns[0].tolist() == TIME
    assert table.columns[1].tolist() == PRESSURE


@pytest.mark.parametrize(
    ("separator", "decimal"), [(",", "."), (";", "."), (";", ","), ("\t", "."), ("\t", ","), (" ", "."), ("  ", ",")]
)
def test_guessed_layout_gives_a_note(tmp_path: Path, separator: str, decimal: str) -> None:
    head = separator.join(("t(s)", "p[bar]")) + "\n"
    table = read_table(written(tmp_path, head + body(separator, decimal)))
    assert_bench(table)
    assert (table.notes[0].code, table.notes[0].facts["decimal"]) == ("table.guessed", decimal)


@pytest.mark.parametrize("options", [{}, {"separator": ","}, {"decimal": ","}, {"separator": ",", "decimal": ","}])
def test_quoted_numbers_with_decimal_commas(tmp_path: Path, options: dict[str, Any]) -> None:
    rows = [f'"{t}"|"{p}"'.replace(".", ",").replace("|", ",") for t, p in zip(TIME, PRESSURE, strict=True)]
    text = "\n".join(['"t (s)","p (bar)"', *rows])
    table = read_table(written(tmp_path, text), **options)
    assert_bench(table)


def test_points_between_thousands_are_no_decimal_points(tmp_path: Path) -> None:
    text = "t;p\n100;1.026\n200;1.013\n300;993\n400;987\n"
    problem = refused(written(tmp_path, text))
    assert (problem.code, problem.line) == ("table.thousands", 3)
    assert problem.facts == {"column": "p", "before": "1.013", "after": "993"}
    # A stated decimal point, a smaller jump, another number of decimals, and zeros leave no doubt.
    assert read_table(written(tmp_path, text), decimal=".").columns[1].tolist() == [1.026, 1.013, 993.0, 987.0]
    for change in (("1.026", "1.02"), ("1.026", "0.026"), ("1.013", "10.013"), ("993", "0"), ("993", "993.5")):
        read_table(written(tmp_path, text.replace(*change)))


def test_stated_layout_gives_no_note(tmp_path: Path) -> None:
    file = written(tmp_path, "t [s];p [bar]\n" + body(";", ","))
    table = read_table(file, separator=";", decimal=",", header_rows=1)
    assert_bench(table)
    assert table.notes == ()


@pytest.mark.parametrize("word", ["tab", "\t", "\\t"])
def test_a_tab_may_be_named(tmp_path: Path, word: str) -> None:
    assert_bench(read_table(written(tmp_path, "t [s]\tp [bar]\n" + body("\t", ".")), separator=word))


@pytest.mark.parametrize("header_rows", [None, 2, 3, 4])
def test_lines_above_the_headings_and_a_blank_one_below(tmp_path: Path, header_rows: int | None) -> None:
    head = "Ambient Temperature(C): 23.8\nAmbient Pressure(in Hg): \nt(s)\tp(bar)\n\n"
    table = read_table(written(tmp_path, head + body("\t", "."), "log.txt"), header_rows=header_rows)
    assert_bench(table)
    assert Note("table.header_line", number=1, text="Ambient Temperature(C): 23.8") in table.notes


def test_key_and_value_separated_like_the_columns_are_header(tmp_path: Path) -> None:
    assert_bench(read_table(written(tmp_path, "Ambient;23,8\nt [s];p [bar]\n" + body(";", ","))))


def test_a_line_of_units_below_the_names(tmp_path: Path) -> None:
    assert_bench(read_table(written(tmp_path, "t;p\n[s];[bar]\n" + body(";", "."))))


def test_without_headings_the_columns_are_counted(tmp_path: Path) -> None:
    table = read_table(written(tmp_path, body(",", ".")))
    assert_bench(table, ("column 0", "column 1"), ("", ""))
    assert table.index(1) == 1
    assert Note("table.no_headings", last=1) in table.notes


def test_comments_are_notes_and_can_contain_headings(tmp_path: Path) -> None:
    table = read_table(written(tmp_path, "# bench 3, Monday, tank B\nt [s],p [bar]\n" + body(",", ".")))
    assert_bench(table)
    assert Note("table.comment", text="bench 3, Monday, tank B") in table.notes
    assert_bench(read_table(written(tmp_path, "# t [s] , p [bar]\n" + body(",", "."))))


@pytest.mark.parametrize(
    "encoded",
    [
        b"\xef\xbb\xbf" + ("t [s],p [bar]\r\n" + body(",", ".").replace("\n", "\r\n")).encode(),
        ("t [s],p [bar]\n" + body(",", ".")).encode("utf-16"),
        ("t [s],p [bar]\r" + body(",", ".").replace("\n", "\r")).encode(),
    ],
    ids=["UTF-8 mark and CRLF", "UTF-16", "CR"],
)
def test_encodings_and_line_ends(tmp_path: Path, encoded: bytes) -> None:
    assert_bench(read_table(written(tmp_path, encoded)))


def test_latin_1_gives_a_note(tmp_path: Path) -> None:
    table = read_table(written(tmp_path, "t [s];T [°C]\n0;20\n1;21\n".encode("latin-1")))
    assert table.units == ("s", "degC")
    assert table.notes[0].code == "table.latin_1"


def test_empty_cells_are_nan(tmp_path: Path) -> None:
    table = read_table(written(tmp_path, "t,p,T\n0,,20\n1,2,nan\n2,3,n/a\n3,4,\n"))
    assert np.isnan(table.columns[1]).tolist() == [True, False, False, False]
    assert np.isnan(table.columns[2]).tolist() == [False, True, True, True]


def test_separator_at_the_end_of_lines_adds_no_column(tmp_path: Path) -> None:
    table = read_table(written(tmp_path, "t;p;\n0;1;\n1;2;\n2;3;\n"))
    assert table.names == ("t", "p")


def test_column_of_text_is_empty_with_a_note(tmp_path: Path) -> None:
    table = read_table(written(tmp_path, "when;t;p\n2026-01-05;0;1,5\n2026-01-05;1;2,5\n"))
    assert np.isnan(table.columns[0]).all()
    assert table.columns[2].tolist() == [1.5, 2.5]
    assert Note("table.column_of_text", column="when", cell="2026-01-05") in table.notes


def test_incomplete_last_line_is_omitted_with_a_note(tmp_path: Path) -> None:
    table = read_table(written(tmp_path, "t,p,T\n0,1,20\n1,2,21\n2,3\n"))
    assert table.columns[0].tolist() == [0.0, 1.0]
    assert Note("table.cut_off", number=4) in table.notes


@pytest.mark.parametrize(
    ("text", "code", "line", "facts"),
    [
        ("", "empty", None, {}),
        ("# only a comment\n", "empty", None, {}),
        ("t,p\n", "no_lines_of_numbers", None, {}),
        ("t,p\n0,1\n1,oops\n2,3\n", "cell", 3, {"cell": "oops", "column": "p"}),
        ("t,p\n0,oops\n1,2\n2,3\n3,4\n", "cell", 2, {"cell": "oops", "column": "p"}),
        ("t,p\n0,1\n1,2,3\n2,3\n", "cells", 3, {"cells": 3, "columns": 2}),
        ("t,p\n0,1\n1\n2,3\n", "cells", 3, {"cells": 1, "columns": 2}),
        (b"t,p\n\0\0", "binary", None, {}),
    ],
)
def test_invalid_texts_are_rejected_with_the_line(
    tmp_path: Path, text: str | bytes, code: str, line: int | None, facts: dict[str, Any]
) -> None:
    file = written(tmp_path, text)
    error = refused(file)
    assert (error.code, error.file, error.line, error.facts) == (f"table.{code}", str(file), line, facts)


@pytest.mark.parametrize(
    ("options", "code", "address"),
    [
        ({"separator": "::"}, "separator", "separator"),
        ({"decimal": ":"}, "decimal", "decimal"),
        ({"separator": ",", "decimal": ","}, "same_sign", "separator"),
        ({"header_rows": -1}, "header_rows", "header_rows"),
        ({"header_rows": 99}, "no_samples", None),
        ({"group": "fast"}, "no_such_option", "group"),
    ],
)
def test_invalid_options_are_rejected(tmp_path: Path, options: dict[str, Any], code: str, address: str | None) -> None:
    error = refused(written(tmp_path, "t,p\n" + body(",", ".")), **options)
    assert (error.code, error.address) == (f"table.{code}", address)


def test_files_that_cannot_be_opened(tmp_path: Path) -> None:
    assert refused(tmp_path / "missing.csv").code == "files.unreadable"
    assert refused(written(tmp_path, "x", "bench.xlsx")).code == "files.suffix"
    assert refused(tmp_path / "bench.mat", separator=",").code == "table.no_such_option"


def test_columns_by_name_heading_or_index(tmp_path: Path) -> None:
    table = read_table(written(tmp_path, "Time(s),P1(PSI),flow (raw),P1(bar)\n0,1,2,3\n1,2,3,4\n"))
    assert table.units == ("s", "psi", "", "bar")
    assert [table.index(column) for column in ("Time", "Time(s)", "flow (raw)", 3)] == [0, 0, 2, 3]
    for column, code, facts in (
        ("P1", "ambiguous", {"places": (1, 3)}),
        ("Tine", "misspelt", {"names": table.names}),
        ("zzz", "unknown", {"column": "zzz"}),
        (4, "no_place", {"count": 4}),
    ):
        with pytest.raises(InputError) as caught:
            table.index(column)
        assert caught.value.code == f"table.{code}"
        assert facts.items() <= caught.value.facts.items()


@pytest.mark.parametrize(
    ("heading", "expected"),
    [
        ("T1(Deg C)", ("T1", "degC")),
        ("p [bar g]", ("p", "bar g")),
        ("time(sec)", ("time", "s")),
        ("Mass Flowrate(g/min)", ("Mass Flowrate", "g/min")),
        ("Ambient Pressure (in Hg)", ("Ambient Pressure", "inHg")),
        ("ratio []", ("ratio", "")),
        ("run (1)", ("run (1)", "")),
        ("ratio [1]", ("ratio", "1")),
    ],
)
def test_headings_of_instruments(heading: str, expected: tuple[str, str]) -> None:
    assert heading_of(heading) == expected


@settings(derandomize=True, deadline=None, max_examples=60)
@given(
    rows=st.lists(
        st.tuples(*3 * [st.floats(-1e6, 1e6, allow_nan=False).map(lambda x: round(x, 4))]), min_size=2, max_size=30
    ),
    layout=st.sampled_from([(",", "."), (";", ","), (";", "."), ("\t", ","), (" ", ".")]),
    heading=st.booleans(),
)
def test_written_tables_are_read(
    tmp_path_factory: Any, rows: list[Any], layout: tuple[str, str], heading: bool
) -> None:
    separator, decimal = layout
    lines = ["a,b,c".replace(",", separator)] if heading else []
    lines += [separator.join(f"{x:.4f}".replace(".", decimal) for x in row) for row in rows]
    table = read_table(written(tmp_path_factory.mktemp("any"), "\n".join(lines)))
    assert np.array_equal(np.array(table.columns).T, np.array(rows))


# Other formats


@pytest.mark.parametrize("suffix", ["csv", "parquet", "mat"])
def test_recordings_of_poppet_are_tables(tmp_path: Path, suffix: str) -> None:
    recording = Recording.from_series(TIME, {"tank.pressure [bar]": PRESSURE, "tank.wall [1]": [0, 1, 0, 1]})
    recording.save(tmp_path / f"run.{suffix}")
    table = read_table(tmp_path / f"run.{suffix}")
    assert table.columns[table.index("time")].tolist() == TIME
    assert table.columns[table.index("tank.pressure")].tolist() == PRESSURE
    assert table.units[table.index("tank.pressure")] == "bar"


def test_parquet_of_other_programs(tmp_path: Path) -> None:
    pa = pytest.importorskip("pyarrow")
    import pyarrow.parquet as pq

    stamps = pa.array([0, 100, 200, 300], pa.timestamp("ms"))
    columns = {"when": stamps, "p [bar]": [7.5, None, 5.0, 4.125], "valve": ["on", "on", "off", "off"]}
    pq.write_table(pa.table(columns), tmp_path / "bench.parquet")
    table = read_table(tmp_path / "bench.parquet")
    assert table.names == ("when", "p")
    assert table.columns[0] == pytest.approx(TIME)
    assert np.isnan(table.columns[1]).tolist() == [False, True, False, False]
    assert table.notes == (Note("table.column_without_numbers", column="valve"),)
    assert refused(written(tmp_path, "t,p\n", "text.parquet")).code == "table.unsound"


def test_mat_of_other_programs(tmp_path: Path) -> None:
    from scipy.io import savemat

    content = {"t": TIME, "test": {"p": PRESSURE}, "both": np.array([TIME, PRESSURE]).T, "fs": 10.0, "rig": "bench 3"}
    savemat(tmp_path / "bench.mat", content)
    table = read_table(tmp_path / "bench.mat")
    assert set(table.names) == {"t", "test.p", "both(:,1)", "both(:,2)"}
    for name, values in (("t", TIME), ("test.p", PRESSURE), ("both(:,2)", PRESSURE)):
        assert table.columns[table.index(name)].tolist() == values
    assert refused(written(tmp_path, "t,p\n" * 100, "text.mat")).code == "table.unsound"


def mat_7_3(file: Path, h5py: Any) -> Path:
    """Write a MAT file of version 7.3: HDF5 with a header of 512 bytes that contains the version."""
    with h5py.File(file, "w", userblock_size=512) as content:
        content["t"] = np.array([TIME])
        content["test/p"] = np.array([PRESSURE])
        content["rig"] = np.frombuffer("bench".encode("utf-16-le"), dtype=np.uint16)
        content["rig"].attrs["MATLAB_class"] = np.bytes_("char")
    with file.open("r+b") as stream:
        stream.write(b"MATLAB 7.3 MAT-file".ljust(116) + bytes(8) + b"\x00\x02IM")
    return file


def test_mat_7_3(tmp_path: Path) -> None:
    table = read_table(mat_7_3(tmp_path / "bench.mat", pytest.importorskip("h5py")))
    assert_bench(table, ("t", "test.p"), ("", ""))


def test_mat_7_3_reads_no_other_files(tmp_path: Path) -> None:
    h5py = pytest.importorskip("h5py")
    secret = tmp_path / "secret.h5"
    with h5py.File(secret, "w") as content:
        content["p"] = np.array([PRESSURE])
    file = mat_7_3(tmp_path / "bench.mat", h5py)
    size = 8 * len(PRESSURE)
    with h5py.File(file, "r+") as content:
        content["linked"] = h5py.ExternalLink(str(secret), "/p")
        content["soft"] = h5py.SoftLink("/linked")
        content.create_dataset("raw", (len(PRESSURE),), "f8", external=[(str(secret), 0, size)])
        layout = h5py.VirtualLayout((1, len(PRESSURE)), "f8")
        layout[:] = h5py.VirtualSource(str(secret), "p", (1, len(PRESSURE)))
        content.create_virtual_dataset("virtual", layout)
    assert_bench(read_table(file), ("t", "test.p"), ("", ""))


def test_tdms(tmp_path: Path) -> None:
    nptdms = pytest.importorskip("nptdms")
    wave = {"wf_increment": 0.1, "unit_string": "bar"}  # no wf_start_offset, as many writers leave it
    channels = [
        nptdms.ChannelObject("fast", "p", np.array(PRESSURE), properties=wave),
        nptdms.ChannelObject("fast", "remark", ["a", "b"]),
        nptdms.ChannelObject("slow", "t", np.array([0.0, 1.0]), properties={"unit_string": "s"}),
        nptdms.ChannelObject("slow", "T", np.array([20.0, 21.0]), properties={"NI_UnitDescription": "Deg C"}),
    ]
    with nptdms.TdmsWriter(tmp_path / "bench.tdms") as writer:
        writer.write_segment(channels)
    table = read_table(tmp_path / "bench.tdms", group="fast")
    assert table.columns[table.index("time")] == pytest.approx(TIME)
    assert table.columns[table.index("p")].tolist() == PRESSURE
    assert table.units[table.index("p")] == "bar"
    assert table.notes == (Note("table.channel_without_numbers", channel="remark", group="fast"),)
    everything = read_table(tmp_path / "bench.tdms")
    assert set(everything.names) == {"fast/p", "fast/time", "slow/t", "slow/T"}
    assert everything.units[everything.index("slow/T")] == "degC"
    assert np.isnan(everything.columns[everything.index("slow/T")][2:]).all()
    error = refused(tmp_path / "bench.tdms", group="fats")
    assert (error.code, error.address, error.facts["suggestion"].names) == ("fields.not_an_option", "group", ["fast"])
    assert refused(written(tmp_path, "no such thing", "text.tdms")).code == "table.no_columns"


def test_tdms_waveforms_of_two_rates_in_one_group(tmp_path: Path) -> None:
    nptdms = pytest.importorskip("nptdms")
    with nptdms.TdmsWriter(tmp_path / "bench.tdms") as writer:
        for name, step in (("p", 0.1), ("T", 0.2)):
            properties = {"wf_increment": step, "wf_start_offset": 1.0}
            writer.write_segment([nptdms.ChannelObject("g", name, np.arange(3.0), properties=properties)])
    table = read_table(tmp_path / "bench.tdms")
    assert table.columns[table.index("p time")] == pytest.approx([1.0, 1.1, 1.2])
    assert table.columns[table.index("T time")] == pytest.approx([1.0, 1.2, 1.4])
    assert table.units[table.index("T time")] == "s"


@pytest.mark.filterwarnings("default")
def test_mdf(tmp_path: Path) -> None:
    asammdf = pytest.importorskip("asammdf")
    with asammdf.MDF(version="4.10") as file:
        signal = asammdf.Signal(np.array(PRESSURE), np.array(TIME), unit="bar", name="p")
        file.append([signal], acq_name="fast")
        file.append([asammdf.Signal(np.array([20.0, 21.0]), np.array([0.0, 1.0]), unit="°C", name="T")])
        file.save(tmp_path / "bench.mf4")
    table = read_table(tmp_path / "bench.mf4", group=0)
    assert table.columns[table.index("time")].tolist() == TIME
    assert table.columns[table.index("p")].tolist() == PRESSURE
    assert table.units == ("s", "bar")
    everything = read_table(tmp_path / "bench.mf4")
    assert len(everything.names) == 4
    assert "degC" in everything.units
    assert refused(written(tmp_path, "no such thing" * 50, "text.mf4")).code == "table.unsound"


@pytest.mark.parametrize(
    ("package", "name", "extra"),
    [
        ("nptdms", "bench.tdms", "measured"),
        ("asammdf", "bench.mf4", "measured"),
        ("pyarrow", "bench.parquet", "data"),
    ],
)
def test_missing_package_is_reported_with_its_extra(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, package: str, name: str, extra: str
) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    error = refused(written(tmp_path, "x", name))
    assert isinstance(error, MissingDependencyError)
    assert error.extra == extra


def test_mat_7_3_without_h5py(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = written(tmp_path, b"MATLAB 7.3 MAT-file".ljust(116) + bytes(8) + b"\x00\x02IM" + bytes(400), "bench.mat")
    monkeypatch.setitem(sys.modules, "h5py", None)
    error = refused(file)
    assert isinstance(error, MissingDependencyError)
    assert (error.package, error.extra) == ("h5py", "measured")


def test_implausible_number_is_rejected_with_its_line(tmp_path):
    error = refused(written(tmp_path, "t,p\n0,1\n1,-1e308\n"))
    assert (error.code, error.facts["column"], error.facts["value"], error.line) == ("table.huge", "p", -1e308, 3)


def test_too_large_file_is_rejected(tmp_path, monkeypatch):
    monkeypatch.setattr("poppet.timeseries.tables.text.LARGEST_TEXT", 100)
    assert refused(written(tmp_path, "t,p\n" + "0,1\n" * 100)).code == "table.too_large"
