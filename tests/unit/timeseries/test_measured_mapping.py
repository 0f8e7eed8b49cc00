"""Table `[recordings.NAME]`: units, times, files, and errors with their addresses."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet.core.codes import Note
from poppet.core.errors import InputError, InputErrors
from poppet.timeseries.measurements import Measurement, read_measurement

AMBIENT = 101325.0
COUNT = 40


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with files of a discharge at 10 Hz, its flow, and a temperature that starts later."""
    time = 5.0 + 0.1 * np.arange(COUNT)
    rows = [f"{t:.1f},{6.0 - 0.1 * (k // 2):.2f},{60 + k}" for k, t in enumerate(time)]
    (tmp_path / "bench.csv").write_text("t_s,p,flow [g/min]\n" + "\n".join(rows))
    rows = [f"{1000 * t + 50:.0f};{20 - 0.1 * k:.1f}".replace(".", ",") for k, t in enumerate(time)]
    (tmp_path / "gas.csv").write_text("t_ms;T\n" + "\n".join(rows))
    (tmp_path / "text.csv").write_text("t_s,p\n" + "\n".join(f"{k},high" for k in range(20)))
    return tmp_path


def table(**changes: Any) -> dict[str, Any]:
    fields = {
        "file": "bench.csv",
        "time": {"column": "t_s", "unit": "s"},
        "tank.pressure": {"column": "p", "unit": "bar g"},
    }
    return {key: value for key, value in (fields | changes).items() if value is not None}


def read(folder: Path, **changes: Any) -> Measurement:
    return read_measurement("empty", table(**changes), folder, ambient_pressure=AMBIENT)


def test_complete_table(folder: Path) -> None:
    text = """
    [recordings.empty]
    file = "bench.csv"
    time = { column = "t_s", unit = "s" }
    separator = ","
    skip = "1 s"
    ambient_pressure = "0.98 bar"
    "tank.pressure" = { column = "p", unit = "bar g", noise = "2 kPa" }
    "tank.temperature".column = "T"
    "tank.temperature".unit = "degC"
    "tank.temperature".lag = "free"
    "tank.temperature".file = "gas.csv"
    "tank.temperature".time = { column = "t_ms", unit = "ms" }
    inputs = { "outlet.mass_flow_rate" = { column = "flow [g/min]", delay = "free", lag = "20 ms" } }
    start = { "tank.initial_pressure" = "first", "tank.initial_temperature" = "293 K" }
    """
    raw = tomllib.loads(text)["recordings"]["empty"]
    measurement = read_measurement("empty", raw, folder, ambient_pressure=AMBIENT)
    pressure, temperature = measurement.channels
    assert (pressure.address, pressure.unit, pressure.noise, pressure.lag) == ("tank.pressure", "Pa", 2000.0, 0.0)
    assert pressure.time == pytest.approx(0.1 * np.arange(30), abs=1e-9)
    assert pressure.values[0] == pytest.approx(0.98e5 + 5.5e5)
    assert pressure.quantum == pytest.approx(1e4)
    assert (temperature.lag, temperature.noise) == (None, None)
    assert temperature.time[0] == pytest.approx(0.05)
    assert temperature.values[0] == pytest.approx(273.15 + 19.0)
    (flow,) = measurement.inputs
    assert (flow.address, flow.unit, flow.delay, flow.lag) == ("outlet.mass_flow_rate", "kg/s", None, 0.02)
    assert flow.time[0] == pytest.approx(-1.0)
    assert flow.values[0] == pytest.approx(1e-3)
    assert measurement.start == {"tank.initial_pressure": "first", "tank.initial_temperature": "293 K"}
    assert measurement.ambient_pressure == 0.98e5
    assert measurement.duration == pytest.approx(2.95)


def test_short_forms(folder: Path) -> None:
    measurement = read(folder, time="t_s", inputs={"outlet.mass_flow_rate": 2})
    assert measurement.channels[0].values[0] == pytest.approx(AMBIENT + 6e5)
    assert measurement.inputs[0].values[0] == pytest.approx(1e-3)
    assert measurement.inputs[0].delay == 0.0


@pytest.mark.parametrize(
    ("unit", "expected"),
    [("bar", 6e5), ("bar g", 6e5 + AMBIENT), ("psi g", 6 * 6894.757293168 + AMBIENT), ("bar a", 6e5), ("kPa", 6e3)],
)
def test_pressures_are_absolute(folder: Path, unit: str, expected: float) -> None:
    channel = read(folder, **{"tank.pressure": {"column": "p", "unit": unit}}).channels[0]
    assert channel.values[0] == pytest.approx(expected)


def test_a_volume_flow_of_air_is_a_mass_flow(folder: Path) -> None:
    item = read(folder, inputs={"in.mass_flow_rate": {"column": 2, "unit": "l/min ANR"}}).inputs[0]
    assert item.values[0] == pytest.approx(1.185e-3)


@pytest.mark.parametrize(
    ("unit", "density", "stated"),
    [("l/min", 1.185, "l/min ANR"), ("slpm", 1.185 * 293.15 / 273.15 * 1.01325, "l/min N")],
)
def test_volume_flow_without_reference_state_gives_a_note(folder: Path, unit: str, density: float, stated: str) -> None:
    measurement = read(folder, inputs={"in.mass_flow_rate": {"column": 2, "unit": unit}})
    assert measurement.inputs[0].values[0] == pytest.approx(1e-3 * density)
    assert Note("doubt.read_as", "in.mass_flow_rate", unit=unit, read=stated) in measurement.notes


def test_time_counts_from_the_first_used_sample_of_all(folder: Path) -> None:
    gas = {"column": "T", "unit": "degC", "file": "gas.csv", "time": {"column": "t_ms", "unit": "ms"}}
    for skip, first, second in (("0 s", 0.0, 0.05), ("0.03 s", 0.05, 0.0)):
        measurement = read(folder, **{"skip": skip, "tank.temperature": gas})
        assert measurement.channels[0].time[0] == pytest.approx(first, abs=1e-9)
        assert measurement.channels[1].time[0] == pytest.approx(second, abs=1e-9)


def test_until_ends_the_recording(folder: Path) -> None:
    measurement = read(folder, skip="1 s", until="2 s")
    assert measurement.channels[0].time == pytest.approx(0.1 * np.arange(11), abs=1e-9)
    assert measurement.duration == pytest.approx(1.0)


def bench(folder: Path, rows: str) -> dict[str, Any]:
    (folder / "odd.csv").write_text("t_s,p\n" + rows)
    return {"file": "odd.csv"}


def test_repeated_stamps_are_merged_and_counted(folder: Path) -> None:
    rows = "\n".join(f"{k // 2},{k}" for k in range(20))
    measurement = read(folder, **bench(folder, rows))
    assert measurement.channels[0].time.tolist() == list(range(10))
    assert measurement.channels[0].values[:2] == pytest.approx([AMBIENT + 0.5e5, AMBIENT + 2.5e5])
    assert Note("measured.repeated_stamps", "tank.pressure", count=10) in measurement.notes


def test_empty_cells_are_omitted_and_counted(folder: Path) -> None:
    rows = "\n".join(f"{k},{'' if k in (3, 4) else k}" for k in range(20))
    measurement = read(folder, **bench(folder, rows))
    assert measurement.channels[0].time.size == 18
    assert Note("measured.empty_cells", "tank.pressure", lost=2, total=20) in measurement.notes


def test_a_constant_channel_is_a_finding(folder: Path) -> None:
    measurement = read(folder, **bench(folder, "\n".join(f"{k},2" for k in range(20))))
    (constant,) = [note for note in measurement.findings if note.code == "suspicion.constant"]
    assert (constant.address, constant.facts["samples"]) == ("tank.pressure", 20)


def test_notes_of_a_file_have_its_name(folder: Path) -> None:
    (guessed,) = [note for note in read(folder).notes if note.code == "table.guessed"]
    assert (guessed.address, guessed.within("sweep").address) == ("bench.csv", "sweep: bench.csv")


def test_a_heading_of_another_unit_of_time_is_a_finding(folder: Path) -> None:
    (folder / "ms.csv").write_text("t [ms],p\n" + "\n".join(f"{k},{k % 3}" for k in range(20)))
    measurement = read(folder, file="ms.csv", time={"column": "t", "unit": "s"})
    (unit_note,) = [note for note in measurement.findings if note.code == "suspicion.other_unit"]
    assert unit_note.within("empty").address == "empty.time"


def test_a_heading_of_another_unit_is_a_finding(folder: Path) -> None:
    measurement = read(folder, inputs={"in.mass_flow_rate": {"column": 2, "unit": "g/s"}})
    (unit_note,) = [note for note in measurement.findings if note.code == "suspicion.other_unit"]
    assert (unit_note.address, unit_note.facts["unit"], unit_note.facts["heading"]) == (
        "in.mass_flow_rate",
        "g/s",
        "g/min",
    )


@pytest.mark.parametrize(
    ("rows", "code"),
    [
        ("\n".join(f"{k},1" for k in range(7)), "measured.few_samples"),
        ("\n".join(f"{k if k < 9 else 3},1" for k in range(20)), "measured.backwards"),
        ("\n".join(f"{k}," for k in range(20)), "measured.empty_column"),
        ("\n".join(f"{k},{1e18 if k == 5 else 1}" for k in range(20)), "measured.too_large"),
        ("", "table.no_lines_of_numbers"),
    ],
)
def test_unusable_recordings_are_rejected(folder: Path, rows: str, code: str) -> None:
    with pytest.raises(InputError) as caught:
        read(folder, **bench(folder, rows))
    assert caught.value.code == code
    assert str(caught.value.address).startswith("recordings.empty")


PRESSURE = {"column": "p", "unit": "bar g"}


@pytest.mark.parametrize(
    ("changes", "address", "code"),
    [
        ({"file": None}, "file", "fields.missing"),
        ({"file": "bemch.csv"}, "file", "files.unreadable"),
        ({"time": None}, "time.column", "table.unknown"),
        ({"time": {"column": "t_s", "unit": "bar"}}, "time.unit", "unit.other_quantity"),
        ({"time": {"column": "t_s", "units": "s"}}, "time.units", "fields.unknown"),
        ({"skip": "1 bar"}, "skip", "quantity.other_quantity"),
        ({"skip": "-1 s"}, "skip", "fields.out_of_range"),
        ({"skip": "60 s"}, "tank.pressure", "measured.few_samples"),
        ({"skip": "1 s", "until": "0.5 s"}, "until", "measured.until_before_skip"),
        ({"separator": 3}, "separator", "fields.other_type"),
        ({"header_rows": "two"}, "header_rows", "fields.other_type"),
        ({"ambient_pressure": "1 bar g"}, "ambient_pressure", "fields.out_of_range"),
        ({"skp": "1 s"}, "skp", "fields.unknown"),
        ({"tank": {"pressure": PRESSURE}}, "tank", "measured.unquoted"),
        ({"tank.pressure": None}, "", "measured.no_channel"),
        ({"tank.pressure": {"column": "q", "unit": "bar"}}, "tank.pressure.column", "table.unknown"),
        ({"tank.pressure": {"column": "flw", "unit": "bar"}}, "tank.pressure.column", "table.misspelt"),
        ({"tank.pressure": {"column": 9, "unit": "bar"}}, "tank.pressure.column", "table.no_place"),
        ({"tank.pressure": {"column": 1.5, "unit": "bar"}}, "tank.pressure.column", "fields.other_type"),
        ({"file": "text.csv"}, "tank.pressure.column", "measured.column_of_text"),
        ({"tank.pressure": {"unit": "bar"}}, "tank.pressure.column", "fields.missing"),
        ({"tank.pressure": "p"}, "tank.pressure.unit", "measured.no_unit"),
        ({"tank.pressure": {"column": "p", "unit": "K"}}, "tank.pressure.unit", "unit.other_quantity"),
        ({"tank.pressure": {"column": "p", "unit": "barr"}}, "tank.pressure.unit", "unit.misspelt"),
        ({"tank.pressure": PRESSURE | {"noise": "2 kPa g"}}, "tank.pressure.noise", "quantity.gauge_difference"),
        ({"tank.pressure": PRESSURE | {"noise": "0 Pa"}}, "tank.pressure.noise", "fields.out_of_range"),
        ({"tank.pressure": PRESSURE | {"lag": "-1 s"}}, "tank.pressure.lag", "fields.out_of_range"),
        ({"tank.pressure": PRESSURE | {"lag": "loose"}}, "tank.pressure.lag", "quantity.no_number"),
        ({"tank.pressure": PRESSURE | {"delay": "1 s"}}, "tank.pressure.delay", "fields.unknown"),
        (
            {"inputs": {"in.mass_flow_rate": {"column": 2, "unit": "l"}}},
            "inputs.in.mass_flow_rate.unit",
            "unit.other_quantity",
        ),
        ({"inputs": {"flow": {"column": 2}}}, "inputs.flow", "measured.no_address"),
        ({"inputs": 3}, "inputs", "fields.no_table"),
        (
            {"start": {"tank.initial_temperature": "first"}},
            "start.tank.initial_temperature",
            "measured.no_first_sample",
        ),
        ({"start": {"tank.volume": "first"}}, "start.tank.volume", "measured.first_of_none"),
        ({"start": {"tank.initial_pressure": True}}, "start.tank.initial_pressure", "measured.no_start"),
    ],
)
def test_errors_have_an_address(folder: Path, changes: dict[str, Any], address: str, code: str) -> None:
    with pytest.raises(InputError) as caught:
        read(folder, **changes)
    expected = ".".join(filter(None, ("recordings.empty", address)))
    assert (code, expected) in {(problem.code, problem.address) for problem in caught.value.problems}
    assert expected in str(caught.value)


def test_error_of_the_shared_time_is_reported_once(folder: Path) -> None:
    flow = {"outlet.mass_flow_rate": 2}
    with pytest.raises(InputError) as caught:
        read(folder, time={"column": "t"}, inputs=flow, **{"other.pressure": {"column": "p", "unit": "bar"}})
    assert not isinstance(caught.value, InputErrors)
    assert caught.value.address == "recordings.empty.time.column"


def test_second_file_inherits_the_time_column(folder: Path) -> None:
    (folder / "wall.txt").write_text("t_s;T\n" + "\n".join(f"{5 + k},5;20,5" for k in range(9)))
    measurement = read(
        folder, separator=",", **{"wall.temperature": {"column": "T", "unit": "degC", "file": "wall.txt"}}
    )
    assert measurement.channels[1].time == pytest.approx(0.5 + np.arange(9))
    gas = {"column": "T", "unit": "degC", "file": "gas.csv"}
    with pytest.raises(InputError) as caught:
        read(folder, **{"tank.temperature": gas})
    assert caught.value.address == "recordings.empty.tank.temperature.time.column"
    assert caught.value.facts["names"] == ("t_ms", "T")


def test_all_errors_are_reported_together(folder: Path) -> None:
    changes = {
        "skip": "1 bar",
        "tank.pressure": {"column": "q", "unit": "bar"},
        "tank.temperature": {"column": "p", "unit": "bar"},
        "inputs": {"in.mass_flow_rate": {"column": "z"}},
    }
    with pytest.raises(InputErrors) as caught:
        read(folder, **changes)
    assert {problem.address for problem in caught.value.problems} == {
        "recordings.empty.skip",
        "recordings.empty.tank.pressure.column",
        "recordings.empty.tank.temperature.unit",
        "recordings.empty.inputs.in.mass_flow_rate.column",
    }
