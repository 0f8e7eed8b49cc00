"""Datasets: bit-identical shards in any order and after losses; protection of other files."""

from __future__ import annotations

import errno
import json
from concurrent.futures import Executor, Future
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from circuits_of_ensembles import LARGE, METRICS, NUMBERS, hashes, tank
from poppet import load
from poppet.engine.solve import solve
from poppet.ensemble import dataset as dataset_module
from poppet.ensemble import shards
from poppet.timeseries.tables.reading import arrow
from refusals import refused


@pytest.fixture(scope="module")
def expected_hashes(tmp_path_factory) -> dict[str, str]:
    folder = tmp_path_factory.mktemp("whole") / "one"
    tank(LARGE).ensemble(folder, workers=1)
    return hashes(folder)


class Backwards(Executor):
    """Executor that runs submitted tasks in reverse order."""

    def __init__(self) -> None:
        self.waiting: list[tuple[Future, tuple]] = []

    def submit(self, fn, /, *args, **kwargs):
        future: Future = Future()
        self.waiting.append((future, (fn, args)))
        if len(self.waiting) == 5:
            self.shutdown()
        return future

    def shutdown(self, wait=True, *, cancel_futures=False):
        for future, (fn, args) in reversed(self.waiting):
            future.set_result(fn(*args))
        self.waiting.clear()


def test_shards_do_not_depend_on_the_executor(tmp_path, expected_hashes):
    assert sum(name.startswith("runs/") for name in expected_hashes) == 5
    tank(LARGE).ensemble(tmp_path / "two", workers=2)
    assert hashes(tmp_path / "two") == expected_hashes
    # Five shards of runs and one of the tornado.
    pool = Backwards()
    pool.submit(lambda: None)
    pool.waiting.clear()
    submit = pool.submit

    def submit_and_finish(fn, /, *args, **kwargs):
        future = submit(fn, *args, **kwargs)
        if args[2] == "tornado":
            pool.shutdown()
        return future

    pool.submit = submit_and_finish  # type: ignore[method-assign]
    tank(LARGE).ensemble(tmp_path / "back", executor=pool)
    assert hashes(tmp_path / "back") == expected_hashes


def test_missing_and_damaged_shards_are_run_again(tmp_path, expected_hashes):
    folder = tmp_path / "set"
    tank(LARGE).ensemble(folder)
    (folder / "runs" / "part-00002.parquet").unlink()
    broken = folder / "runs" / "part-00004.parquet"
    broken.write_bytes(broken.read_bytes()[:-20])
    (folder / "tornado" / "part-00000.parquet").write_bytes(b"")
    manifest = folder / "manifest.json"
    manifest.write_text(json.dumps({k: v for k, v in json.loads(manifest.read_text()).items() if k != "files"}))
    done = []
    tank(LARGE).ensemble(folder, progress=lambda *arguments: done.append(arguments))
    assert hashes(folder) == expected_hashes
    assert all(runs >= 1536 for runs, _, kind in done if kind == "runs")
    # Runs and additional runs are counted separately.
    assert {arguments[1:] for arguments in done} <= {(2500, "runs"), (5, "tornado")}
    assert done[-1] == (5, 5, "tornado")


def test_complete_dataset_is_not_run_again(tmp_path, expected_hashes, monkeypatch):
    folder = tmp_path / "set"
    tank(LARGE).ensemble(folder)
    monkeypatch.setattr(shards, "shard_files", None)
    assert tank(LARGE).ensemble(folder).done == 2500
    assert hashes(folder) == expected_hashes


def test_changed_requirements_need_no_runs(tmp_path, expected_hashes, monkeypatch):
    folder = tmp_path / "set"
    tank(LARGE).ensemble(folder)
    monkeypatch.setattr(shards, "shard_files", None)
    ensemble = tank(LARGE).ensemble(folder, requirements={"none": "end < 0 bar"})
    assert [(item.name, item.good) for item in ensemble.yields()] == [("none", 0)]
    assert hashes(folder) == expected_hashes


def test_changed_number_of_indices_replaces_their_shards(tmp_path):
    """Shards of other indices have the same number of rows, but other values."""
    folder, fields = tmp_path / "set", {"runs": 20, "parameters": NUMBERS, "metrics": METRICS}
    tank("").ensemble(folder, indices=512, **fields)
    runs = hashes(folder / "runs")
    for indices in (256, 1024, 0):
        ensemble = tank("").ensemble(folder, indices=indices, **fields)
        tank("").ensemble(tmp_path / f"new-{indices}", indices=indices, **fields)
        assert hashes(folder) == hashes(tmp_path / f"new-{indices}")
        assert len(ensemble.indices()) == (indices > 0)
        assert hashes(folder / "runs") == runs


def test_changed_shard_is_run_again(tmp_path, expected_hashes):
    tank(LARGE).ensemble(tmp_path / "set")
    path = tmp_path / "set" / "runs" / "part-00001.parquet"
    original = path.read_bytes()
    # A complete shard of the same runs, with other values.
    rows = arrow().parquet.read_table(path)
    rows = rows.set_column(rows.column_names.index("end"), "end", [rows["air"]])
    arrow().parquet.write_table(rows, path)
    assert path.read_bytes() != original
    tank(LARGE).ensemble(tmp_path / "set")
    assert hashes(tmp_path / "set") == expected_hashes


def test_stray_shard_is_rejected(tmp_path, expected_hashes):
    folder = tmp_path / "set"
    tank(LARGE).ensemble(folder)
    stray = folder / "runs" / "part-00005.parquet"
    stray.write_bytes((folder / "runs" / "part-00001.parquet").read_bytes())
    with refused("ensemble.stray_file", path=str(stray)):
        tank(LARGE).ensemble(folder)
    stray.unlink()
    assert hashes(folder) == expected_hashes


def test_manifest_contains_hashes_settings_and_versions(tmp_path, expected_hashes):
    ensemble = tank(LARGE).ensemble(tmp_path / "set")
    manifest = json.loads((tmp_path / "set" / "manifest.json").read_text(encoding="utf-8"))
    assert manifest["files"] == {name: value for name, value in expected_hashes.items() if name != "manifest.json"}
    assert manifest["poppet ensemble"]["circuit"]["title"] == "A tank runs empty"
    assert manifest["poppet ensemble"]["sampling"] == {"way": "random", "runs": 2500, "seed": 1}
    assert {"poppet", "numpy", "scipy", "casadi", "llvmlite", "python", "pyarrow", "kernel"} == manifest[
        "versions"
    ].keys()
    schema = arrow().parquet.read_schema(tmp_path / "set" / "runs" / "part-00000.parquet")
    assert schema.field("air").metadata == {b"unit": b"l ANR"}
    assert schema.field("tank.volume").metadata == {b"unit": b"m^3"}
    assert ensemble.done == 2500


@pytest.mark.parametrize(
    ("differs", "values", "fields"),
    [
        (["circuit"], {"tank.wall_conductance": "2 W/K"}, {}),
        (["sampling"], {}, {"seed": 2}),
        (["sampling"], {}, {"runs": 2501}),
        (["numbers"], {}, {"parameters": NUMBERS}),
        (["metrics"], {}, {"metrics": METRICS, "requirements": {}}),
        (["kept"], {}, {"keep": "bands"}),
    ],
)
def test_other_dataset_is_not_overwritten(tmp_path, expected_hashes, differs, values, fields):
    tank(LARGE).ensemble(tmp_path / "set")
    with refused("ensemble.other_dataset", differs=differs):
        tank(LARGE).with_values(values).ensemble(tmp_path / "set", **fields)
    assert hashes(tmp_path / "set") == expected_hashes


def test_other_versions_are_rejected(tmp_path, expected_hashes, monkeypatch):
    tank(LARGE).ensemble(tmp_path / "set")
    monkeypatch.setattr(dataset_module, "__version__", "0.0.0")
    with refused("ensemble.other_versions"):
        tank(LARGE).ensemble(tmp_path / "set")
    assert hashes(tmp_path / "set") == expected_hashes


def test_folder_with_other_files_is_rejected(tmp_path):
    (tmp_path / "thesis.tex").write_text("years", encoding="utf-8")
    with refused("ensemble.folder_taken"):
        tank(LARGE).ensemble(tmp_path)
    (tmp_path / "manifest.json").write_text("{}", encoding="utf-8")
    with refused("ensemble.folder_taken"):
        tank(LARGE).ensemble(tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["manifest.json", "thesis.tex"]


def test_full_disk_keeps_completed_shards(tmp_path, expected_hashes, monkeypatch):
    folder, write, count = tmp_path / "set", dataset_module.write_whole, []

    def write_on_full_disk(path, fill):
        if path.parent.name == "runs":
            count.append(path)
        if len(count) > 3:

            def fill(stream):
                stream.write(b"PAR1")
                raise OSError(errno.ENOSPC, "No space left on device")

        return write(path, fill)

    monkeypatch.setattr(dataset_module, "write_whole", write_on_full_disk)
    with refused("files.full"):
        tank(LARGE).ensemble(folder, workers=1)
    stored_hashes = hashes(folder)
    assert len([name for name in stored_hashes if name.startswith("runs/")]) == 3
    assert all(expected_hashes[name] == value for name, value in stored_hashes.items() if name != "manifest.json")
    monkeypatch.undo()
    tank(LARGE).ensemble(folder)
    assert hashes(folder) == expected_hashes


def test_interruption_keeps_completed_shards(tmp_path, expected_hashes):
    def interrupt(done, total, kind):
        if done > 1000:
            raise KeyboardInterrupt

    ensemble = tank(LARGE).ensemble(tmp_path / "set", workers=1, progress=interrupt)
    assert not ensemble.is_whole
    assert 1000 < ensemble.done < 2500
    assert tank(LARGE).ensemble(tmp_path / "set").is_whole
    assert hashes(tmp_path / "set") == expected_hashes


def test_failed_runs_are_rows_without_metrics(monkeypatch):
    """The limit of steps is that of the run with the parameters of the circuit; other runs need more."""
    circuit = tank("")
    problem = circuit.problem(circuit.run)
    limited = replace(problem, most_attempts=solve(problem).attempts)
    monkeypatch.setattr(type(circuit), "problem", lambda self, run: limited)
    ensemble = circuit.ensemble(runs=40, parameters=NUMBERS, metrics=METRICS, requirements={"any": "end < 9 bar"})
    rows = ensemble.dataset.columns("runs")
    is_failed = rows["outcome"] == "run.too_many"
    assert 0 < is_failed.sum() < 40
    assert (np.isnan(rows["end"]) == is_failed).all()
    assert (rows["done"] == ~is_failed).all()
    assert ensemble.yields()[0].good == 40 - is_failed.sum()
    assert [note.code for note in ensemble.remarks()] == ["ensemble.failed"]
    assert ensemble.worst(1)["any"][0].run == int(np.flatnonzero(is_failed)[0])


def missing_metric(time: np.ndarray, pressure: np.ndarray) -> float:
    """Return NaN for tanks with a high pressure."""
    return float("nan") if pressure[16] > 1.95e5 else 1.0


def test_runs_without_a_metric_value_give_a_remark():
    metrics = METRICS | {"own": {"of": "tank.pressure", "metric": missing_metric}}
    ensemble = tank("").ensemble(runs=64, parameters=NUMBERS, metrics=metrics, requirements={"one": "own > 0"})
    n_undefined = int(np.count_nonzero(np.isnan(ensemble.to_pandas()["own"])))
    assert 0 < n_undefined < 64
    remarks = [(note.code, note.facts["metric"], note.facts["count"]) for note in ensemble.remarks()]
    assert remarks == [("ensemble.undefined", "own", n_undefined)]
    assert [item.good for item in ensemble.yields()] == [64 - n_undefined]


def test_stopped_runs_have_metrics_up_to_the_stop(tmp_path):
    circuit = tank("").with_values({"run.stop_when": "tank.pressure < 1.2 bar"})
    ensemble = circuit.ensemble(runs=20, parameters=NUMBERS, metrics=METRICS)
    rows = ensemble.dataset.columns("runs")
    # The last row is the time of the stop.
    assert set(rows["outcome"]) == {"run.stopped"}
    np.testing.assert_allclose(rows["end"], 1.2e5, rtol=1e-6)


def test_balances_of_all_runs_are_within_tolerance():
    assert tank().ensemble(runs=64).dataset.columns("runs")["balance"].max() <= 1.0


def test_dependent_parameters_follow_the_ambient_pressure(tmp_path):
    """Gauge pressures, open ends and walls depend on the ambient pressure."""
    circuit = tank("").with_values({"tank.initial_pressure": "2 bar g"})
    parameters = {"ambient.pressure": {"distribution": "uniform", "low": "0.8 bar", "high": "1.05 bar"}}
    rows = circuit.ensemble(runs=5, parameters=parameters, metrics=METRICS).dataset.columns("runs")
    for k in range(5):
        single = circuit.with_values({"ambient.pressure": float(rows["ambient.pressure"][k])}).simulate()
        assert rows["end"][k] == pytest.approx(single["tank.pressure"][-1], rel=1e-12)


def test_uncertain_delay_shifts_breakpoints(tmp_path):
    circuit = load(Path(__file__).parents[3] / "examples" / "datasheet_valve.toml")
    parameters = {"valve.switching_time": {"distribution": "uniform", "relative_range": 0.2}}
    metrics = {"end": {"of": "chamber.pressure", "metric": "mean"}}
    rows = circuit.ensemble(runs=3, parameters=parameters, metrics=metrics).dataset.columns("runs")
    assert len(set(rows["end"])) == 3
    for k in range(3):
        single = circuit.with_values({"valve.switching_time": float(rows["valve.switching_time"][k])}).simulate()
        p = single["chamber.pressure"]
        assert rows["end"][k] == pytest.approx(np.trapezoid(p, single.time) / single.time[-1], rel=1e-9)


def test_bands_are_quantiles_of_curves(tmp_path):
    fields = {"runs": 700, "curves": ["tank.pressure"]}
    bands = tank().ensemble(tmp_path / "bands", keep="bands", **fields).bands()
    curves = tank().ensemble(tmp_path / "all", keep="all", **fields).dataset.columns("curves")["tank.pressure"]
    rows = np.stack(list(curves))
    assert rows.shape == (700, 51)
    for u in (0.05, 0.5, 0.95):
        exact = np.quantile(rows, u, axis=0)
        estimate = bands.quantile("tank.pressure", u)
        spread = np.ptp(rows, axis=0)
        assert np.all(np.abs(estimate - exact) <= 0.03 * spread + 1e-6 * exact)


def test_missing_bands_are_run_again(tmp_path):
    folder = tmp_path / "set"
    tank(LARGE).ensemble(folder, keep="bands")
    original_hashes = hashes(folder)
    (folder / "bands" / "part-00001.parquet").unlink()
    tank(LARGE).ensemble(folder, keep="bands")
    assert hashes(folder) == original_hashes


def test_worker_with_another_kernel_is_rejected(tmp_path, expected_hashes, monkeypatch):
    monkeypatch.setattr(shards, "kernel_of_this_machine", lambda: "i486, 1 lanes")
    with refused("ensemble.other_kernel", own="i486, 1 lanes"):
        tank().ensemble(tmp_path / "set")
    assert not list((tmp_path / "set").glob("runs/*"))
    monkeypatch.undo()
    monkeypatch.setenv("POPPET_LANES", "2")
    with refused("ensemble.other_versions"):
        tank().ensemble(tmp_path / "set")
