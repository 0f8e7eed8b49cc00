"""Class Watch: samples, recordings, baseline and memory."""

from __future__ import annotations

import contextlib
import math
import shutil
import tracemalloc
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet.core.errors import InputErrors
from poppet.monitoring.samples import Sample
from poppet.monitoring.stuck_sensors import StuckSensors
from poppet.monitoring.verdicts import VerdictKind
from refusals import refused
from watched_tank import TABLES, watched_tank

EXAMPLE = Path(__file__).parents[3] / "examples/watch"
ROWS = np.loadtxt(EXAMPLE / "healthy.csv", delimiter=",", skiprows=1)


def sample(row):
    """Return a row of the example as a sample."""
    return dict(zip("tpuw", map(float, row), strict=True))


@pytest.fixture(scope="module")
def baseline():
    return poppet.watch(EXAMPLE / "twin.toml").baseline


@pytest.fixture
def watch(baseline):
    return poppet.watch(EXAMPLE / "twin.toml", baseline=baseline)


def test_a_sample_gives_the_columns_of_the_file(watch):
    row = watch.update(sample(ROWS[0]))
    assert tuple(row) == watch.columns
    assert (row["time [s]"], row["alarm"]) == (0.0, "")
    assert all(row[f"{name}.sigma"] > 0.0 and 0.0 <= row[f"{name}.probability"] < 0.05 for name in watch.faults)


def test_states_and_faults_are_those_of_the_circuit(watch):
    for row in ROWS[:300]:
        watch.update(sample(row))
    pressure = watch.state["tank.pressure"]
    # The truth is within the noise of the gauge and the nuisance of the ambient pressure.
    assert abs(pressure.value - (1e5 * ROWS[299, 1] + 1.004e5)) < 5.0 * (pressure.sigma + 400.0)
    leak = watch.faults["leak"]
    assert leak.unit == "m^3/(s Pa)"
    assert leak.change == pytest.approx(leak.value - watch.baseline.faults[0], abs=1e-20)
    assert watch.alarms == ()
    assert watch.verdict.names == ()


def test_recordings_and_samples_give_equal_estimates(watch, baseline, tmp_path):
    rows = [watch.update(sample(row)) for row in ROWS[:200]]
    np.savetxt(tmp_path / "rows.csv", ROWS[:200], "%.3f", ",", header="t,p,u,w", comments="")
    other = poppet.watch(EXAMPLE / "twin.toml", baseline=baseline)
    record = other.run(tmp_path / "rows.csv")
    assert len(record) == 200
    assert [row["leak.sigma"] for row in rows] == pytest.approx(record.sigmas[:, 0], rel=1e-8)
    assert [row["nis"] for row in rows[1:]] == pytest.approx(record.nis[1:], rel=1e-8)
    # The first reading determines the start: the filter did not use it.
    assert rows[0]["nis"] is None
    assert math.isnan(record.nis[0])


def test_recordings_of_three_kinds(baseline):
    """A file, a recording with addresses in SI, and a data frame with the columns of the twin file."""
    pandas = pytest.importorskip("pandas", reason="pandas is not installed")
    frame = pandas.DataFrame(ROWS[:100], columns=["time", "p", "u", "w"])
    addresses = {"valve.opening": ROWS[:100, 2], "use.opening": ROWS[:100, 3]}
    recording = poppet.Recording.from_series(
        ROWS[:100, 0], {"tank.pressure [bar]": ROWS[:100, 1] + 1.0} | addresses, units=dict.fromkeys(addresses, "1")
    )
    records = [poppet.watch(EXAMPLE / "twin.toml", baseline=baseline).run(data) for data in (frame, recording)]
    assert np.allclose(records[0].readings, records[1].readings, rtol=1e-12)
    assert np.allclose(records[0].values, records[1].values, rtol=1e-6)


def test_without_a_baseline_only_commissioning_is_possible(tmp_path):
    for name in ("twin.toml", "tank.toml"):
        shutil.copy(EXAMPLE / name, tmp_path)
    watch = poppet.watch(tmp_path / "twin.toml")
    for action in (lambda: watch.update(sample(ROWS[0])), lambda: watch.faults, lambda: watch.alarms):
        with refused("twin.no_baseline"):
            action()
    baseline = watch.commission(EXAMPLE / "healthy.csv")
    assert watch.baseline is baseline
    # Within four standard deviations of the script that simulated the recording.
    truth = {"leak": 2e-11, "valve_clogged": 0.97e-8, "tank.wall_conductance": 5.0, "use.sonic_conductance": 8e-9}
    for name, value in truth.items():
        k = watch.plan.names.index(name)
        assert abs(baseline.values[k] - value) < 4.0 * baseline.sigmas[k], name
    assert watch.update(sample(ROWS[0]))["alarm"] == ""


def test_an_empty_input_of_a_healthy_recording_holds_its_value(tmp_path):
    """The baseline of a recording with inputs that are written only when they change is that of all inputs."""
    lines = (EXAMPLE / "healthy.csv").read_text().splitlines()
    sparse, last = lines[:1], ["", ""]
    for line in lines[1:]:
        *readings, u, w = line.split(",")
        inputs = ["" if new == old else new for new, old in zip((u, w), last, strict=True)]
        sparse.append(",".join([*readings, *inputs]))
        last = [u, w]
    (tmp_path / "sparse.csv").write_text("\n".join(sparse))
    baselines = [
        poppet.watch(EXAMPLE / "twin.toml").commission(path)
        for path in (EXAMPLE / "healthy.csv", tmp_path / "sparse.csv")
    ]
    assert np.array_equal(baselines[0].values, baselines[1].values)


def test_lines_and_recordings_have_the_same_times(tmp_path):
    times = ROWS[:100, 0] * 1000.0
    for name in ("tank.toml", "healthy.toml"):
        shutil.copy(EXAMPLE / name, tmp_path)
    twin = (EXAMPLE / "twin.toml").read_text().replace('column = "t", unit = "s"', 'column = "t", unit = "ms"')
    (tmp_path / "twin.toml").write_text(twin)
    rows = np.column_stack([np.round(times), ROWS[:100, 1:]])
    np.savetxt(tmp_path / "rows.csv", rows, ("%.0f", "%.3f", "%.2f", "%.2f"), ",", header="t,p,u,w", comments="")
    record = poppet.watch(tmp_path / "twin.toml").run(tmp_path / "rows.csv")
    watch = poppet.watch(tmp_path / "twin.toml")
    assert [watch.update(sample(row))["time [s]"] for row in rows] == record.time.tolist()


def test_the_times_of_a_healthy_recording_increase(watch, tmp_path):
    rows = ROWS[:1000].copy()
    rows[500, 0] = 10.0
    np.savetxt(tmp_path / "rows.csv", rows, "%.3f", ",", header="t,p,u,w", comments="")
    with refused("stream.clock_of_recording", time=10.0, last=49.9):
        watch.commission(tmp_path / "rows.csv")


def test_all_errors_of_the_arguments_together():
    with pytest.raises(InputErrors) as caught:
        poppet.watch(
            watched_tank(),
            measured={"tank.presure": {"noise": "5 mbar"}},
            faults={"leak": {"address": "leak.sonic_conductanse", "alarm": "1e-10 m^3/(s Pa)"}},
            time={"colum": "t"},
            window="-3 s",
        )
    assert {problem.address for problem in caught.value.problems} == {
        "measured.tank.presure",
        "faults.leak.address",
        "time.colum",
        "watch.window",
    }


def test_arguments_of_a_circuit():
    watch = poppet.watch(
        watched_tank(), measured=TABLES["measured"], faults=TABLES["faults"], nuisance=TABLES["nuisances"], time="t"
    )
    assert watch.columns[0] == "time [s]"
    assert watch.reader.units == {"t": "s", "p": "bar g", "u": "%"}
    with refused("twin.no_baseline"):
        watch.update({"t": 0.0})


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"p": "high"}, "stream.no_number"),
        ({"p": math.inf}, "stream.too_large"),
        ({"u": 7.0}, "stream.too_large"),
        ({"t": None}, "stream.no_time"),
        ({"t": 0.9}, "stream.clock_equal"),
        ({"t": 0.4}, "stream.clock_back"),
        ({"t": 1e6}, "stream.waiting"),
    ],
)
def test_an_invalid_sample_changes_nothing(watch, changes, code):
    for row in ROWS[:10]:
        watch.update(sample(row))
    before = watch.row()
    with refused(code):
        watch.update(sample(ROWS[10]) | changes)
    assert watch.row() == before
    watch.update(sample(ROWS[10]))


def test_a_missing_input_holds_its_value(watch, baseline):
    other = poppet.watch(EXAMPLE / "twin.toml", baseline=baseline)
    inputs: dict[str, float] = {}
    for row in ROWS[:100]:
        full = sample(row)
        sparse = {key: value for key, value in full.items() if key in "tp" or inputs.get(key) != value}
        inputs |= full
        assert watch.update(full) == other.update(sparse)


def test_a_late_sensor_does_not_turn_the_clock_back(watch, baseline):
    """The pressure comes 0.3 s after the commands: the estimates are those of complete samples."""
    late = poppet.watch(EXAMPLE / "twin.toml", baseline=baseline)
    for k, row in enumerate(ROWS[:600]):
        full = sample(row)
        watch.update(full)
        times = [late.update({key: full[key] for key in "tuw"})["time [s]"]]
        if k >= 3:
            times.append(late.update({key: sample(ROWS[k - 3])[key] for key in "tp"})["time [s]"])
        assert times == [row[0]] * len(times)
    for name, fault in watch.faults.items():
        assert abs(late.faults[name].change - fault.change) < 0.5 * fault.sigma, name
    assert late.verdict.kind is watch.verdict.kind


def test_messages_on_used_samples_are_kept(watch):
    for row in ROWS[:50]:
        watch.update(sample(row))
    for k, row in enumerate(ROWS[:5]):
        values = sample(row) | {"t": 500.0 + 0.1 * k}
        if k == 0:
            with refused("stream.waiting"):
                watch.update(values)
        else:
            watch.update(values)
    assert [message.code for message in watch.messages] == ["stream.gap"]


@pytest.mark.parametrize("columns", ["p", "u", "w", "t"])
def test_a_recording_needs_all_columns(watch, tmp_path, columns):
    header = "t,p,u,w".replace(columns, "x")
    np.savetxt(tmp_path / "rows.csv", ROWS[:20], "%.3f", ",", header=header, comments="")
    with refused("stream.no_column", columns):
        watch.run(tmp_path / "rows.csv")


def test_invalid_inputs_are_unknown_until_a_valid_value(watch, baseline):
    """The opening in percent instead of 1: only zero is valid. The verdict names the columns, and no fault."""
    problems = []
    for k, row in enumerate(ROWS[:1500]):
        watch.process(watch.reader.read(sample(row) | {"u": 100.0 * row[2]}, problems), problems)
        assert watch.alarms == ()
        is_unknown = watch.verdict.kind is VerdictKind.UNKNOWN_INPUT
        assert is_unknown == (row[2] != 0.0), k
        assert math.isnan(watch.nis) or not is_unknown
    assert {problem.code for problem in problems} == {"stream.too_large"}
    before = watch.faults
    # The plant is healthy: what has been learned is right.
    assert all(abs(fault.change) < 4.0 * fault.sigma for fault in before.values())


def test_an_input_of_a_rejected_sample_is_unknown(watch):
    for row in ROWS[:20]:
        watch.update(sample(row))
    with refused("stream.too_large"):
        watch.update(sample(ROWS[20]) | {"u": 50.0})
    assert watch.verdict.note.facts == {"columns": ("u",)}
    assert watch.update({key: value for key, value in sample(ROWS[21]).items() if key != "u"})["nis"] is None
    watch.update(sample(ROWS[22]))
    assert watch.running_filter.restarts == 1
    assert watch.verdict.kind is not VerdictKind.UNKNOWN_INPUT


def test_a_late_value_of_an_unknown_input_starts_the_states_again(watch):
    for k, row in enumerate(ROWS[:60]):
        watch.process(watch.reader.read({key: sample(row)[key] for key in "tpu"}, []), [])
        late = {"t": float(ROWS[max(k - 1, 0), 0]), "w": 70.0 if 20 <= k < 40 else float(ROWS[max(k - 1, 0), 3])}
        watch.process(watch.reader.read(late, []), [])
        assert (watch.verdict.kind is VerdictKind.UNKNOWN_INPUT) == (20 <= k < 40)
        assert watch.running_filter.restarts == (k > 40)


def test_lost_samples_give_a_message_and_no_fault(baseline):
    generator = np.random.default_rng(3)
    watch, problems = poppet.watch(EXAMPLE / "twin.toml", baseline=baseline), []
    for row in ROWS[generator.random(len(ROWS)) < 0.5]:
        watch.process(watch.reader.read(sample(row), []), problems)
        assert watch.alarms == ()
    assert {problem.code for problem in problems} == {"stream.lost_change"}


def test_a_late_input_has_no_innovation(watch):
    for row in ROWS[:100]:
        watch.update({key: value for key, value in sample(row).items() if key != "w"})
    row = watch.update({"t": float(ROWS[98, 0]), "w": 0.0})
    assert row["time [s]"] == ROWS[99, 0]
    assert row["nis"] is None


def test_a_sensor_that_was_stuck_leaves_no_trace(baseline):
    watch, other = (poppet.watch(EXAMPLE / "twin.toml", baseline=baseline) for _ in range(2))
    for k, row in enumerate(ROWS[:1200]):
        is_stuck = 760 < k < 860
        values = sample(row) | ({"p": ROWS[760, 1]} if is_stuck else {})
        watch.process(watch.reader.read(values, []), [])
        other.process(other.reader.read(sample(row) | ({"p": None} if is_stuck else {}), []), [])
        assert watch.alarms == ()
    assert watch.running_filter.restarts == 0
    for name, fault in other.faults.items():
        assert abs(watch.faults[name].value - fault.value) < 1e-3 * fault.sigma, name


def test_nothing_is_judged_with_a_stuck_sensor_and_the_filter_then_starts_again(baseline):
    watch, verdicts, restarts = poppet.watch(EXAMPLE / "twin.toml", baseline=baseline), [], []
    for k, row in enumerate(ROWS[:400]):
        pressure = ROWS[200, 1] if 200 <= k < 300 else row[1]
        watch.process(watch.reader.read(sample(row) | {"p": pressure}, []), [])
        verdicts.append(watch.verdict)
        restarts.append(watch.running_filter.restarts)
    assert len({id(verdict) for verdict in verdicts[250:300]}) == 1
    assert restarts[299] == restarts[200]
    assert restarts[-1] == restarts[299] + 1
    assert watch.alarms == ()


def test_a_sensor_that_is_stuck_is_missing(baseline):
    rows = ROWS[:400].copy()
    rows[200:, 1] = rows[200, 1]
    watch, problems = poppet.watch(EXAMPLE / "twin.toml", baseline=baseline), []
    frame = pytest.importorskip("pandas", reason="pandas is not installed").DataFrame(rows, columns=["time", *"puw"])
    record = watch.run(frame, problems=problems)
    assert [problem.code for problem in problems] == ["stream.stuck"]
    assert f"p has had the value {rows[200, 1]:g} bar g" in str(problems[0])
    assert record.used[-1, 0] == 0
    assert set(record.alarms) == {""}


def test_columns_without_values_are_reported_once(baseline):
    watch, codes = poppet.watch(EXAMPLE / "twin.toml", baseline=baseline), []
    for row in ROWS[:1800]:
        problems = []
        values = row[1:].tolist()
        values[2] = math.nan  # never
        values[0] = math.nan if 30.0 <= row[0] < 120.0 or row[0] >= 130.0 else values[0]
        watch.process(Sample(float(row[0]), values), problems)
        codes += [(problem.code, problem.address, row[0]) for problem in problems]
    # A window is 60 s.
    assert [code[:2] for code in codes] == [("stream.no_input", "w"), ("stream.absent", "p")]
    assert [code[2] for code in codes] == pytest.approx([60.1, 90.0], abs=0.11)


def test_without_readings_there_is_no_verdict(watch):
    for row in ROWS[:900]:
        values = sample(row) | ({"p": None} if row[0] > 20.0 else {})
        watch.update(values)
        assert (watch.verdict.kind is VerdictKind.NO_READINGS) == (row[0] > 80.05), row[0]
    watch.update(sample(ROWS[900]))
    assert watch.verdict.kind is not VerdictKind.NO_READINGS


def test_many_missing_readings_are_noted(watch, tmp_path):
    rows = ROWS[:600].copy()
    rows[np.random.default_rng(1).permutation(600)[:360], 1] = math.nan
    np.savetxt(tmp_path / "rows.csv", rows, "%.3f", ",", header="t,p,u,w", comments="")
    (note,) = watch.run(tmp_path / "rows.csv").notes
    assert (note.code, note.address, note.facts) == ("stream.missing", "tank.pressure", {"fraction": 0.6})


def test_a_slow_sensor_has_no_missing_readings(watch, tmp_path):
    rows = ROWS[:600].copy()
    rows[np.arange(600) % 7 != 3, 1] = math.nan
    np.savetxt(tmp_path / "rows.csv", rows, "%.3f", ",", header="t,p,u,w", comments="")
    assert watch.run(tmp_path / "rows.csv").notes == ()


def test_a_sensor_that_fails_is_noted(watch, tmp_path):
    rows = ROWS[:1200].copy()
    rows[400:, 1] = math.nan
    np.savetxt(tmp_path / "rows.csv", rows, "%.3f", ",", header="t,p,u,w", comments="")
    record = watch.run(tmp_path / "rows.csv")
    (note,) = record.notes
    assert (note.code, note.address, note.facts) == ("stream.failed", "tank.pressure", {"since": 39.9})
    assert set(record.alarms) == {""}


def test_many_outliers_are_noted(watch, tmp_path):
    rows = ROWS[:1200].copy()
    rows[300::20, 1] += 0.6
    np.savetxt(tmp_path / "rows.csv", rows, "%.3f", ",", header="t,p,u,w", comments="")
    (note,) = watch.run(tmp_path / "rows.csv").notes
    # 45 of 1200 readings.
    assert (note.code, note.facts["fraction"]) == ("stream.outliers", pytest.approx(0.0375, abs=0.002))


def test_a_coarse_sensor_at_rest_is_not_stuck(watch):
    guard, problems = StuckSensors(watch.plan.channels), []
    for k in range(100):
        expected = np.array([5e5 + 100.0 * math.sin(k)])
        assert guard.without_stuck(0.1 * k, [5e5], expected, problems) == [5e5]
    assert problems == []


@pytest.mark.parametrize("value", [[1.0, 2.0], None, "t=1"])
def test_a_sample_is_a_table(watch, value):
    with refused("stream.no_table", value=type(value).__name__):
        watch.update(value)


def test_an_interrupted_run_keeps_its_rows(watch):
    def interrupt(fraction):
        if fraction > 0.3:
            raise KeyboardInterrupt

    record = watch.run(EXAMPLE / "healthy.csv", progress=interrupt)
    assert not record.is_complete
    assert 700 < len(record) < 2400
    assert len(record.alarms) == len(record.values) == len(record)


def measured_growth(watch, count):
    """Return the growth of the memory of Python in the second half of a number of updates [bytes]."""
    tracemalloc.start()
    half = 0
    for k in range(count):
        row = ROWS[k % len(ROWS)]
        # A gap before each repetition of the recording, because the pressure jumps there.
        with contextlib.suppress(poppet.InputError):
            watch.update(sample(row) | {"t": row[0] + 400.0 * (k // len(ROWS))})
        if k == count // 2:
            half = tracemalloc.get_traced_memory()[0]
    growth = tracemalloc.get_traced_memory()[0] - half
    tracemalloc.stop()
    return growth


@pytest.mark.parametrize("count", [8_000, pytest.param(1_000_000, marks=pytest.mark.slow)])
def test_updates_do_not_increase_the_memory(watch, count):
    assert measured_growth(watch, count) < 200_000
