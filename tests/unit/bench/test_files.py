"""Tests of ranges, recordings files and result files."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import numpy as np
import pytest

from poppet.bench.iso10094.bench_result import TESTS, BenchResult, compare_bench_results, is_result, read_bench_result
from poppet.bench.iso10094.evaluation import CharacteristicValue, PlottedCurve
from poppet.bench.iso10094.scale import read_pressure, read_pressure_range, read_quantity_list, setpoint_scale
from poppet.bench.iso10094.valve_recordings import read_valve_recordings
from poppet.core.codes import Note
from poppet.core.errors import InputError, InputErrors


@pytest.mark.parametrize(
    ("given", "ends"),
    [
        ("6 bar g", (1e5, 7e5)),
        ("0.5 bar g, 6 bar g", (1.5e5, 7e5)),
        (["1 bar", "7 bar"], (1e5, 7e5)),
        (7e5, (1e5, 7e5)),
    ],
)
def test_pressure_ranges_are_read(given, ends):
    assert read_pressure_range(given, 1e5) == pytest.approx(ends)


@pytest.mark.parametrize("given", ["0 bar g", "7 bar, 1 bar", ["1 bar", "2 bar", "3 bar"], "6 V"])
def test_invalid_pressure_ranges_are_rejected(given):
    with pytest.raises(InputError):
        read_pressure_range(given, 1e5)


def test_negative_absolute_pressure_is_rejected():
    with pytest.raises(InputError) as caught:
        read_pressure("-2 bar g", 1e5, "supply")
    assert caught.value.code == "fields.out_of_range"


@pytest.mark.parametrize(
    ("given", "low", "high", "unit"),
    [
        (["0 V", "10 V"], 0.0, 10.0, "V"),
        (["4 mA", "20 mA"], 0.004, 0.02, "A"),
        (["0 bar g", "6 bar g"], 1e5, 7e5, "Pa"),
        ([0.0, 1.0], 0.0, 1.0, "1"),
        (None, 1e5, 7e5, "Pa"),
    ],
)
def test_setpoint_ranges_are_read(given, low, high, unit):
    scale = setpoint_scale(given, (1e5, 7e5), 1e5)
    assert (scale.setpoint_low, scale.setpoint_high, scale.setpoint_unit) == (
        pytest.approx(low),
        pytest.approx(high),
        unit,
    )


def test_invalid_setpoint_ranges_are_rejected():
    with pytest.raises(InputError) as caught:
        setpoint_scale(["0 V", "20 mA"], (1e5, 7e5), 1e5)
    assert caught.value.code == "bench.range.two_quantities"
    with pytest.raises(InputError) as caught:
        setpoint_scale("10 V", (1e5, 7e5), 1e5)
    assert caught.value.code == "bench.range.setpoint"
    with pytest.raises(InputError):
        setpoint_scale(["0 kg", "1 kg"], (1e5, 7e5), 1e5)


def test_lists_of_positive_values_are_read():
    assert read_quantity_list("1 l, 0.005", "m^3", "--volume") == pytest.approx((0.001, 0.005))
    with pytest.raises(InputError) as caught:
        read_quantity_list("-1 Hz", "Hz", "--frequencies")
    assert (caught.value.code, caught.value.address) == ("fields.out_of_range", "--frequencies")


# Recordings --------------------------------------------------------------------------------------------------------


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    time = np.arange(0.0, 10.0, 0.01)
    columns = [time, np.where(time < 5.0, 2.0, 8.0), np.where(time < 5.0, 1.2, 4.8), np.full(time.size, 7.0)]
    np.savetxt(tmp_path / "a.csv", np.stack(columns, axis=1), "%.6g", ",", header="t,w,p,p1", comments="")
    slow = np.arange(1.0, 9.0, 0.5)
    np.savetxt(tmp_path / "b.csv", np.stack([slow, 7.0 + 0.0 * slow], axis=1), "%.6g", ",", header="t,p1", comments="")
    return tmp_path


def tables(**changes) -> dict:
    recording = {
        "test": "step", "file": "a.csv", "time": {"column": "t", "unit": "s"},
        "valve.setpoint": {"column": "w", "unit": "V"}, "outlet.pressure": {"column": "p", "unit": "bar g"},
    }  # fmt: skip
    recording |= changes.pop("recording", {})
    data = {"full_scale": "6 bar g", "setpoint_range": ["0 V", "10 V"], "ambient_pressure": "1 bar"} | changes
    return {key: value for key, value in data.items() if value is not None} | {
        "recordings": {"one": {key: value for key, value in recording.items() if value is not None}}
    }


def read(folder: Path, **changes):
    return read_valve_recordings(tables(**changes), folder / "map.toml")


def test_recording_has_si_units_and_a_common_time_base(folder):
    supply = {"supply.pressure": {"file": "b.csv", "column": "p1", "unit": "bar", "time": {"column": "t", "unit": "s"}}}
    recordings = read(folder, recording={"volume": "2 l", **supply}, rated_flow="100 l/min ANR")
    (record,) = recordings.records["step"]
    assert recordings.title == "map"
    assert recordings.scale.span == pytest.approx(6e5)
    assert (record.volume, record.is_exact) == (0.002, False)
    assert record.outlet[[0, -1]] == pytest.approx([2.2e5, 5.8e5])
    assert record.time[-1] == pytest.approx(7.5, abs=0.02)  # while all channels were recorded
    assert record.supply == pytest.approx(np.full(record.time.size, 7e5))
    assert record.flow.size == 0
    assert recordings.rated_flow == pytest.approx(100.0 / 60e3 * 1.185, rel=0.01)


@pytest.mark.parametrize(
    ("ends", "expected"), [(["2 V", "8 V"], None), (["0 V", "5 V"], (40.0, 160.0)), (["4 V", "8 V"], (-50.0, 100.0))]
)
def test_setpoint_outside_its_range_is_reported(folder, ends, expected):
    notes = [note for note in read(folder, setpoint_range=ends).notes if note.code == "recordings.beyond"]
    assert [(note.address, note.facts["low"], note.facts["high"]) for note in notes] == (
        [("one", *(pytest.approx(end) for end in expected))] if expected else []
    )


def test_constant_setpoint_is_read_from_the_file(folder):
    flow = {"test": "flow", "setpoint": "5 V", "valve.setpoint": None}
    channel = {"outlet.mass_flow_rate": {"column": "p1", "unit": "g/s"}}
    (record,) = read(folder, recording={**flow, **channel}).records["flow"]
    assert record.setpoint == pytest.approx(np.full(record.time.size, 5.0))


@pytest.mark.parametrize(
    ("changes", "code", "address"),
    [
        ({"full_scale": None}, "fields.missing", "full_scale"),
        ({"fullscale": "6 bar g"}, "fields.unknown", "fullscale"),
        ({"ambient_pressure": "1 bar g"}, "recordings.ambient", "ambient_pressure"),
        ({"setpoint_range": None}, "recordings.unit", "recordings.one.valve.setpoint"),
        ({"recording": {"test": None}}, "fields.missing", "recordings.one.test"),
        ({"recording": {"test": "steps"}}, "fields.not_an_option", "recordings.one.test"),
        ({"recording": {"outlet.pressure": None}}, "fields.missing", "recordings.one.outlet.pressure"),
        ({"recording": {"test": "flow"}}, "fields.missing", "recordings.one.outlet.mass_flow_rate"),
        ({"recording": {"outlet.presure": {"column": "p"}}}, "names.unknown", "recordings.one.outlet.presure"),
        ({"supply_pressure": "-2 bar g"}, "fields.out_of_range", "supply_pressure"),
        ({"recording": {"inputs": {}}}, "recordings.unused", "recordings.one.inputs"),
        ({"recording": {"setpoint": "5 V"}}, "recordings.setpoint_moves", "recordings.one.setpoint"),
        ({"recording": {"test": "leakage", "setpoint": "5 V"}}, "recordings.setpoint_twice", "recordings.one.setpoint"),
        ({"recording": {"file": "none.csv"}}, None, None),
        ({"recording": {"volume": "1 kg"}}, None, None),
    ],
)
def test_errors_in_recordings_files_are_reported(folder, changes, code, address):
    with pytest.raises(InputError) as caught:
        read(folder, **changes)
    assert code in (None, caught.value.code)
    assert address in (None, caught.value.address)


def test_errors_suggest_names_and_state_missing_channels(folder):
    for changes, names in (
        ({"fullscale": "6 bar g"}, ["full_scale"]),
        ({"recording": {"test": "steps"}}, ["step"]),
        ({"recording": {"outlet.presure": {"column": "p"}}}, ["outlet.pressure", "supply.pressure"]),
    ):
        with pytest.raises(InputError) as caught:
            read(folder, **changes)
        assert caught.value.facts["suggestion"].names == names
    with pytest.raises(InputError) as caught:
        read(folder, recording={"test": "flow"})
    assert caught.value.address == "recordings.one.outlet.mass_flow_rate"
    assert caught.value.facts["meaning"].startswith("mass flow rate")


def test_all_errors_are_reported_together(folder):
    with pytest.raises(InputErrors) as caught:
        read(folder, recording={"test": "steps", "inputs": {}, "valve.setpoit": "w"})
    assert len(caught.value.problems) == 3


def test_limited_setpoint_is_not_reported_as_clipped(folder):
    random = np.random.default_rng(5)
    time = np.arange(0.0, 10.0, 0.01)
    moving = np.clip(5.0 + 6.0 * np.sin(3.0 * time) + random.normal(0.0, 0.2, time.size), 0.0, 10.0)
    np.savetxt(folder / "a.csv", np.stack([time, moving, moving], axis=1), "%.6g", ",", header="t,w,p", comments="")
    clipped = [note.address for note in read(folder).notes if note.code == "recordings.clipped" and str(note)]
    assert {address.partition(".")[2] for address in clipped} == {"outlet.pressure"}


def write_staircase(folder: Path, outlet: float = 0.6) -> None:
    """Write a recording of a staircase of 1 V with an outlet that lags by 20 ms."""
    time = np.arange(0.0, 42.0, 0.01)
    setpoint = np.minimum(np.floor(time / 2.0), 20.0 - np.floor(time / 2.0))
    changes = np.diff(setpoint, prepend=0.0)
    behind = setpoint - np.convolve(changes, np.exp(-np.arange(200) / 2.0))[: time.size]
    columns = np.stack([time, setpoint, outlet * behind], axis=1)
    np.savetxt(folder / "a.csv", columns, "%.6g", ",", header="t,w,p", comments="")


def test_staircase_setpoint_is_not_reported_as_coarse(folder):
    write_staircase(folder)
    assert "suspicion.coarse" not in {note.code for note in read(folder).notes}
    time = np.arange(0.0, 42.0, 0.01)  # a ramp behind a converter of 1 V
    np.savetxt(
        folder / "a.csv", np.stack([time, np.round(time / 4.2), time / 7.0], axis=1), header="t,w,p", comments="",
        delimiter=",",
    )  # fmt: skip
    assert "suspicion.coarse" in {note.code for note in read(folder).notes}


def test_outlet_outside_full_scale_is_reported(folder):
    write_staircase(folder, outlet=14.5 * 0.6)  # psi, called bar
    (note,) = (note for note in read(folder).notes if note.code == "recordings.outlet_beyond")
    assert "psi" in str(note)
    assert (note.facts["peak"], note.facts["full"]) == (pytest.approx(87e5, rel=1e-3), pytest.approx(6e5))
    write_staircase(folder)
    assert "recordings.outlet_beyond" not in {note.code for note in read(folder).notes}


def write_series(folder: Path, time: np.ndarray, setpoint: np.ndarray, outlet: np.ndarray) -> None:
    columns = np.stack([time, setpoint, outlet], axis=1)
    np.savetxt(folder / "a.csv", columns, "%.9g", ",", header="t,w,p", comments="")


def series_of_steps() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return time [s], setpoint [V] and outlet [bar] of two steps up and two steps down, with noise of 2 mbar."""
    time = np.arange(0.0, 8.0, 0.002)
    setpoint, outlet = np.full(time.size, 1.0), np.full(time.size, 0.6)
    for start, size in ((1.0, 8.0), (3.0, -8.0), (5.0, 8.0), (7.0, -8.0)):
        setpoint += size * (time >= start)
        outlet += 0.6 * size * (1.0 - np.exp(-np.maximum(time - start - 0.01, 0.0) / 0.06))
    return time, setpoint, outlet + np.random.default_rng(5).normal(0.0, 0.002, time.size)


SUSPICIONS = {
    "none": (lambda t, w, p: (t, w, p), "step", set()),
    "dead": (lambda t, w, p: (t, w, 3.0 + np.random.default_rng(6).normal(0.0, 0.002, t.size)), "step", {"dead"}),
    "inverted": (lambda t, w, p: (t, w, 6.0 - p), "step", {"inverted"}),
    "psi": (lambda t, w, p: (t, w, 14.5 * p), "step", {"outlet_beyond"}),
    "bar read as psi": (lambda t, w, p: (t, w, p / 14.5), "step", {"outlet_small"}),
    "exchanged": (lambda t, w, p: (t, p, w), "step", {"leads", "outlet_beyond", "clipped"}),
    "milliseconds": (lambda t, w, p: (1000.0 * t, w, p), "step", {"slow"}),
    "seconds": (lambda t, w, p: (t / 1000.0, w, p), "step", {"fast"}),
    "spike": (lambda t, w, p: (t, w, np.where(np.arange(t.size) == 777, 60.0, p)), "step", {"spikes"}),
}


@pytest.mark.parametrize("case", SUSPICIONS)
def test_probable_errors_of_recordings_are_named(folder, case):
    change, test, expected = SUSPICIONS[case]
    write_series(folder, *change(*series_of_steps()))
    notes = read(folder, recording={"test": test}).notes
    assert {n.code.partition(".")[2] for n in notes if n.code.startswith("recordings.") and str(n)} == expected


def test_spike_is_replaced(folder):
    time, setpoint, outlet = series_of_steps()
    outlet[1777] = 60.0
    write_series(folder, time, setpoint, outlet)
    (record,) = read(folder).records["step"]
    assert float(np.max(record.outlet)) < 6.6e5


def test_steps_declared_as_characteristic_give_no_values(folder):
    write_series(folder, *series_of_steps())
    recordings = read(folder, recording={"test": "characteristic"})
    evaluation = TESTS["characteristic"].evaluate_records(recordings.records["characteristic"], recordings.scale)
    assert not {"hysteresis", "linearity", "accuracy", "repeatability"} & set(evaluation.figures)
    assert "bench.characteristic.jumps" in {note.code for note in evaluation.notes if str(note)}


@pytest.mark.parametrize("value", [0.0, 2.1])
def test_dead_sensor_gives_no_frequency_response(folder, value):
    time = np.arange(0.0, 8.0, 0.005)
    write_series(folder, time, 5.0 + np.sin(2.0 * np.pi * time), np.full(time.size, value))
    recordings = read(folder, recording={"test": "frequency"})
    evaluation = TESTS["frequency"].evaluate_records(recordings.records["frequency"], recordings.scale)
    assert evaluation.figures == {}
    assert "bench.frequency.lost" in {note.code for note in evaluation.notes}


def series_of_sines() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return time [s], setpoint [V] and outlet [bar] of sines behind a lag of 60 ms, with noise of 2 mbar."""
    setpoints, outlets = [], []
    for frequency in (0.5, 1.0, 2.0, 4.0):
        turn = 2.0 * np.pi * frequency * np.arange(0.0, 6.0 / frequency, 0.002)
        response = 1.0 / (1.0 + 2j * np.pi * frequency * 0.06)
        setpoints.append(5.0 + np.sin(turn))
        outlets.append(3.0 + 0.6 * np.imag(response * np.exp(1j * turn)))
    setpoint, outlet = np.concatenate(setpoints), np.concatenate(outlets)
    noise = np.random.default_rng(7).normal(0.0, 0.002, outlet.size)
    return 0.002 * np.arange(outlet.size), setpoint, outlet + noise


SINES = {
    "none": (lambda t, w, p: (t, w, p), set()),
    "dead": (lambda t, w, p: (t, w, 3.0 + np.random.default_rng(8).normal(0.0, 0.002, t.size)), {"frequency.dead"}),
    "inverted": (lambda t, w, p: (t, w, 6.0 - p), {"frequency.opposite"}),
    "exchanged": (lambda t, w, p: (t, p, w), {"frequency.leads"}),
    "psi": (lambda t, w, p: (t, w, 14.5 * p), {"recordings.outlet_beyond"}),
    "milliseconds": (lambda t, w, p: (1000.0 * t, w, p), {"recordings.slow"}),
    "seconds": (lambda t, w, p: (t / 1000.0, w, p), {"recordings.fast"}),
}


@pytest.mark.parametrize("case", SINES)
def test_probable_errors_of_sines_are_named(folder, case):
    change, expected = SINES[case]
    write_series(folder, *change(*series_of_sines()))
    recordings = read(folder, recording={"test": "frequency"})
    evaluation = TESTS["frequency"].evaluate_records(recordings.records["frequency"], recordings.scale)
    codes = {note.code.removeprefix("bench.") for note in (*recordings.notes, *evaluation.notes) if str(note)}
    suspicions = {"frequency.dead", "frequency.opposite", "frequency.leads", "frequency.not_low"}
    assert {code for code in codes if code in suspicions or code.startswith("recordings.")} == expected


def test_dead_sensor_has_no_step_to_evaluate(folder):
    time, setpoint, outlet = series_of_steps()
    write_series(folder, time, setpoint, np.full(outlet.size, 3.0))
    recordings = read(folder)
    evaluation = TESTS["step"].evaluate_records(recordings.records["step"], recordings.scale)
    reasons = {note.code for note in evaluation.notes if note.code.startswith("bench.absent.")}
    assert reasons == {"bench.absent.no_step"}


def test_lag_of_sensor_is_reported(folder):
    channel = {"outlet.pressure": {"column": "p", "unit": "bar g", "lag": "20 ms"}}
    assert Note("recordings.lag", "one", channel="outlet.pressure") in read(folder, recording=channel).notes


# Results -----------------------------------------------------------------------------------------------------------

RESULT = BenchResult(
    "a valve",
    "circuit",
    {
        "hysteresis": CharacteristicValue(0.5, "% FS", "d", "at most", {"at": 50.0}),
        "delay": CharacteristicValue(0.01, "s", "d"),
    },
    {"step": [{"record": "r", "from": 10.0, "to": 90.0, "is_settled": True}]},
    {"step": [PlottedCurve("outlet", "+80 % FS, 1 l", np.linspace(0.0, 1.0, 1000), np.linspace(0.0, 100.0, 1000))]},
    {"bench": (Note("said", text="note: with a colon."),), "step": (Note("bench.step.none", "r", least=2.0),)},
    {"full_scale": [1e5, 7e5], "volumes": [1e-3], "step": {"x": 1.0}},
    {},
)


@pytest.mark.parametrize("name", ["r.toml", "r.json"])
def test_result_files_preserve_the_result(tmp_path, name):
    RESULT.save(tmp_path / name)
    copy = read_bench_result(tmp_path / name)
    assert (copy.title, copy.source, copy.figures, copy.notes) == (
        RESULT.title,
        "circuit",
        RESULT.figures,
        RESULT.notes,
    )
    assert copy.rows == {"step": [{"record": "r", "from": 10.0, "to": 90.0, "is_settled": True}]}
    (curve,) = copy.curves["step"]
    assert (curve.name, curve.case, curve.x.size) == ("outlet", "+80 % FS, 1 l", 240)
    assert (curve.y[0], curve.y[-1]) == (0.0, 100.0)
    text = (tmp_path / name).read_text(encoding="utf-8")
    data = tomllib.loads(text) if name.endswith("toml") else json.loads(text)
    assert is_result(data)
    assert data["figures"]["hysteresis"]["standard"].endswith("verify against the standard")
    assert data["notes"] == ["bench: note: with a colon.", "step: r: the setpoint contains no step of 2 % FS or more."]
    copy.save(tmp_path / f"again-{name}")
    assert (tmp_path / f"again-{name}").read_text(encoding="utf-8") == text


@pytest.mark.parametrize(
    "text", ['method = "fit"\n', 'method = "iso10094"\n', "[[", '{"method": "iso10094", "figures": {"x": {}}}']
)
def test_other_files_are_rejected_as_results(tmp_path, text):
    path = tmp_path / ("r.json" if text.startswith("{") else "r.toml")
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read_bench_result(path)
    assert caught.value.code == "bench.no_result"


def test_result_without_codes_has_notes(tmp_path):
    RESULT.save(tmp_path / "r.json")
    data = json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))
    del data["codes"]
    (tmp_path / "r.json").write_text(json.dumps(data), encoding="utf-8")
    copy = read_bench_result(tmp_path / "r.json")
    assert copy.content()["notes"] == data["notes"]
    assert list(copy.notes) == ["bench", "step"]


def test_comparison_reports_different_conditions():
    reference = BenchResult(
        "b", "recordings",
        {"delay": CharacteristicValue(0.02, "s", "d"), "hysteresis": CharacteristicValue(0.4, "% FS", "d")},
        conditions={"full_scale": [1e5, 5e5], "volumes": [1e-3]},
    )  # fmt: skip
    comparison = compare_bench_results(RESULT, reference)
    assert comparison["figures"]["delay"]["difference"] == pytest.approx(-0.01)
    assert "difference" not in comparison["figures"]["hysteresis"]
    assert comparison["figures"]["hysteresis"]["value_bound"] == "at most"
    assert comparison["notes"] == [Note("bench.differs.full_scale", here=[1e5, 7e5], there=[1e5, 5e5])]
