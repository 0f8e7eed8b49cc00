"""Tests of calendar times in text files."""

from __future__ import annotations

from datetime import datetime, timedelta

import numpy as np
import pytest

from poppet.timeseries.measurements import read_measurement
from poppet.timeseries.tables.reading import read_table
from poppet.timeseries.tables.table import heading_of
from refusals import refused

START = datetime(2026, 11, 23, 23, 59, 58, 500000)  # crosses midnight
SECONDS = np.arange(40) * 0.125
PRESSURE = 1.0 + 0.1 * np.arange(40)


def german(moment):
    return f"{moment:%d.%m.%Y %H:%M:%S},{moment.microsecond // 1000:03d}"


def iso(moment):
    return moment.isoformat(timespec="milliseconds")


FORMS = {
    "german": (";", ",", german),
    "german with tabs": ("\t", ",", german),
    "iso": (",", ".", iso),
    "iso with space and zone": (";", ".", lambda m: f"{m.isoformat(' ', 'milliseconds')}+01:00"),
    "iso with Z and a decimal comma": (";", ",", lambda m: f"{iso(m)}Z"),
    "quoted": (",", ".", lambda m: f'"{german(m)}"'),
    "spaces": (" ", ".", lambda m: m.isoformat(" ", "milliseconds")),
}


def stamped_file(folder, form, *, heading=("Zeit", "p [bar]")):
    """Write a file with time stamps, and return its path."""
    separator, decimal, write = FORMS[form]
    rows = [separator.join(heading)] if heading else []
    for seconds, pressure in zip(SECONDS, PRESSURE, strict=True):
        moment = START + timedelta(seconds=float(seconds))
        rows.append(f"{write(moment)}{separator}{f'{pressure:.2f}'.replace('.', decimal)}")
    path = folder / "log.csv"
    path.write_text("\n".join(rows) + "\n")
    return path


@pytest.mark.parametrize("form", FORMS)
def test_time_stamps_are_seconds_since_the_first_one(tmp_path, form):
    heading = ("Zeit", "p[bar]") if form == "spaces" else ("Zeit", "p [bar]")
    table = read_table(stamped_file(tmp_path, form, heading=heading))
    assert table.names == ("Zeit", "p")
    assert table.units == ("s", "bar")
    assert table.columns[0] == pytest.approx(SECONDS, abs=1e-12)
    assert table.columns[1] == pytest.approx(PRESSURE)
    (note,) = [note for note in table.notes if note.code == "table.time_stamps"]
    assert note.facts["column"] == "Zeit"
    assert "2026" in note.facts["first"]


def test_time_stamps_without_headings(tmp_path):
    table = read_table(stamped_file(tmp_path, "german", heading=()))
    assert table.names == ("column 0", "column 1")
    assert table.columns[0] == pytest.approx(SECONDS, abs=1e-12)


def test_invalid_dates_are_no_times(tmp_path):
    path = stamped_file(tmp_path, "iso")
    path.write_text(path.read_text().replace("2026-11", "2026-13"))
    assert any(note.code == "table.column_of_text" for note in read_table(path).notes)


def test_a_comma_before_another_column_separates(tmp_path):
    """`10:00:00,500,1.5` has two readings: the comma that separates the columns is not a decimal sign."""
    path = tmp_path / "log.csv"
    path.write_text("t,raw,p\n" + "".join(f"2026-11-23 10:00:{k:02d},{500 + k},1.5\n" for k in range(9)))
    table = read_table(path)
    assert table.columns[0] == pytest.approx(np.arange(9.0))
    assert table.columns[1] == pytest.approx(500 + np.arange(9.0))


def recording_of(folder, times, **time):
    path = folder / "serial.csv"
    lines = [f"{t:.12f};{p:.2f}" for t, p in zip(times, PRESSURE, strict=True)]
    path.write_text("\n".join(["t;p [bar]", *lines]) + "\n")
    table = {"file": path.name, "time": {"column": "t", **time}, "tank.pressure": {"column": "p"}}
    return read_measurement("test", table, folder, ambient_pressure=1e5)


def test_serial_numbers_of_excel_are_days(tmp_path):
    measurement = recording_of(tmp_path, 46349.75 + SECONDS / 86400.0)
    assert measurement.channels[0].time == pytest.approx(SECONDS, abs=2e-6)
    assert any(note.code == "table.serial_days" for note in measurement.notes)


@pytest.mark.parametrize(("times", "time"), [(46349.75 + SECONDS, {}), (46349.75 + SECONDS / 86400.0, {"unit": "s"})])
def test_seconds_in_the_range_of_serial_numbers_stay(tmp_path, times, time):
    measurement = recording_of(tmp_path, times, **time)
    assert measurement.channels[0].time[-1] == pytest.approx(times[-1] - times[0], rel=1e-5)
    assert not any(note.code == "table.serial_days" for note in measurement.notes)


def test_recordings_with_time_stamps_are_read(tmp_path):
    path = stamped_file(tmp_path, "german")
    table = {"file": path.name, "time": "Zeit", "tank.pressure": {"column": "p", "unit": "bar g"}}
    channel = read_measurement("test", table, tmp_path, ambient_pressure=1e5).channels[0]
    assert channel.time == pytest.approx(SECONDS, abs=1e-9)
    assert channel.values == pytest.approx(1e5 * (PRESSURE + 1.0))


def test_text_is_still_no_time(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("t,p [bar]\n" + "".join(f"step {k},{k}.5\n" for k in range(9)))
    table = {"file": path.name, "time": "t", "tank.pressure": {"column": "p"}}
    with refused("measured.column_of_text"):
        read_measurement("test", table, tmp_path, ambient_pressure=1e5)


@pytest.mark.parametrize("date", ["", "28.11.2026;"])
def test_clock_times_cross_midnight(tmp_path, date):
    rows = [f"{date}{START + timedelta(seconds=float(t)):%H:%M:%S,%f}".rstrip("0") for t in SECONDS]
    path = tmp_path / "log.csv"
    path.write_text("\n".join([f"{'Datum;' if date else ''}Uhrzeit;p [bar_rel]", *(f"{row}0;1,5" for row in rows)]))
    table = read_table(path)
    index = table.names.index("Uhrzeit")
    assert table.columns[index] == pytest.approx(SECONDS, abs=1e-12)
    assert table.units[index:] == ("s", "bar g")


def test_a_clock_time_in_a_comment_is_no_stamp(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("t;p\n" + "".join(f"{k};1,5\n" for k in range(10)) + "11;1,5\n")
    assert [note.code for note in read_table(path).notes] == ["table.guessed"]
    path.write_text("start 12:00:01;\nt;p\n" + "".join(f"{k};1,5\n" for k in range(10)))
    assert "table.time_stamps" not in {note.code for note in read_table(path).notes}


def test_clock_times_with_am_and_pm(tmp_path):
    hours = [("11:59:59 AM", 0.0), ("12:00:00 PM", 1.0), ("12:59:59 pm", 3600.0), ("1:00:00PM", 3601.0)]
    path = tmp_path / "log.csv"
    path.write_text("\n".join(["time;p", *(f"{text};1.5" for text, _ in hours)]))
    assert read_table(path).columns[0].tolist() == [seconds for _, seconds in hours]


def test_a_comma_after_the_seconds_separates_the_only_other_column(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("\n".join(["time,p", *(f"12:00:{k:02d},{6000 - k}" for k in range(20))]))
    table = read_table(path)
    assert table.columns[0].tolist() == [*range(20)]
    assert table.columns[1].tolist() == [6000 - k for k in range(20)]


@pytest.mark.parametrize(
    ("heading", "name", "unit"),
    [
        ("Durchfluss in l / min", "Durchfluss", "l/min"),
        ("Zyklen / h", "Zyklen / h", ""),  # a rate, and no time in hours
        ("Drehzahl 1 / min", "Drehzahl 1 / min", ""),
        ("Zeit t / ms", "Zeit t", "ms"),
        ("t/s", "t", "s"),
    ],
)
def test_a_unit_of_time_after_a_stroke_can_be_a_rate(heading, name, unit):
    assert heading_of(heading) == (name, unit)
