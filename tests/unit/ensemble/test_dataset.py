"""Datasets: the same bits whoever runs them, in any order, after any loss; nothing else is ever overwritten."""

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
def whole(tmp_path_factory) -> dict[str, str]:
    folder = tmp_path_factory.mktemp("whole") / "one"
    tank(LARGE).ensemble(folder, workers=1)
    return hashes(folder)


class Backwards(Executor):
    """Runs at once, but what is handed in last is done first."""

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


def test_shards_have_the_same_bits_whoever_runs_them(tmp_path, whole):
    assert sum(name.startswith("runs/") for name in whole) == 5
    tank(LARGE).ensemble(tmp_path / "two", workers=2)
    assert hashes(tmp_path / "two") == whole
    # Five shards of runs and one of the tornado.
    pool = Backwards()
    pool.submit(lambda: None)
    pool.waiting.clear()
    submit = pool.submit

    def last_too(fn, /, *args, **kwargs):
        future = submit(fn, *args, **kwargs)
        if args[2] == "tornado":
            pool.shutdown()
        return future

    pool.submit = last_too  # type: ignore[method-assign]
    tank(LARGE).ensemble(tmp_path / "back", executor=pool)
    assert hashes(tmp_path / "back") == whole


def test_what_is_lost_comes_again(tmp_path, whole):
    folder = tmp_path / "set"
    tank(LARGE).ensemble(folder)
    (folder / "runs" / "part-00002.parquet").unlink()
    broken = folder / "runs" / "part-00004.parquet"
    broken.write_bytes(broken.read_bytes()[:-20])
    (folder / "tornado" / "part-00000.parquet").write_bytes(b"")
    manifest = folder / "manifest.json"
    manifest.write_text(json.dumps({k: v for k, v in json.loads(manifest.read_text()).items() if k != "files"}))
    done = []
    tank(LARGE).ensemble(folder, progress=lambda *seen: done.append(seen))
    assert hashes(folder) == whole
    assert all(runs >= 1536 for runs, _, kind in done if kind == "runs")
    # What was asked for and what comes on top are counted apart.
    assert {seen[1:] for seen in done} <= {(2500, "runs"), (5, "tornado")}
    assert done[-1] == (5, 5, "tornado")


def test_a_whole_dataset_is_only_read(tmp_path, whole, monkeypatch):
    folder = tmp_path / "set"
    tank(LARGE).ensemble(folder)
    monkeypatch.setattr(shards, "shard_files", None)
    assert tank(LARGE).ensemble(folder).done == 2500
    assert hashes(folder) == whole


def test_requirements_may_change_without_a_run(tmp_path, whole, monkeypatch):
    folder = tmp_path / "set"
    tank(LARGE).ensemble(folder)
    monkeypatch.setattr(shards, "shard_files", None)
    found = tank(LARGE).ensemble(folder, requirements={"none": "end < 0 bar"})
    assert [(each.name, each.good) for each in found.yields()] == [("none", 0)]
    assert hashes(folder) == whole


def test_indices_may_change_and_are_made_anew(tmp_path):
    """Shards of other indices have as many rows as those that are wanted, and other numbers."""
    folder, given = tmp_path / "set", {"runs": 20, "parameters": NUMBERS, "metrics": METRICS}
    tank("").ensemble(folder, indices=512, **given)
    runs = hashes(folder / "runs")
    for indices in (256, 1024, 0):
        found = tank("").ensemble(folder, indices=indices, **given)
        tank("").ensemble(tmp_path / f"new-{indices}", indices=indices, **given)
        assert hashes(folder) == hashes(tmp_path / f"new-{indices}")
        assert len(found.indices()) == (indices > 0)
        assert hashes(folder / "runs") == runs


def test_a_shard_that_is_not_what_it_was_is_made_anew(tmp_path, whole):
    tank(LARGE).ensemble(tmp_path / "set")
    path = tmp_path / "set" / "runs" / "part-00001.parquet"
    own = path.read_bytes()
    # One that is whole, of the same runs, with another value.
    rows = arrow().parquet.read_table(path)
    rows = rows.set_column(rows.column_names.index("end"), "end", [rows["air"]])
    arrow().parquet.write_table(rows, path)
    assert path.read_bytes() != own
    tank(LARGE).ensemble(tmp_path / "set")
    assert hashes(tmp_path / "set") == whole


def test_a_shard_of_others_is_not_counted(tmp_path, whole):
    folder = tmp_path / "set"
    tank(LARGE).ensemble(folder)
    stray = folder / "runs" / "part-00005.parquet"
    stray.write_bytes((folder / "runs" / "part-00001.parquet").read_bytes())
    with refused("ensemble.stray_file", path=str(stray)):
        tank(LARGE).ensemble(folder)
    stray.unlink()
    assert hashes(folder) == whole


def test_a_manifest_says_what_the_shards_are(tmp_path, whole):
    found = tank(LARGE).ensemble(tmp_path / "set")
    manifest = json.loads((tmp_path / "set" / "manifest.json").read_text(encoding="utf-8"))
    assert manifest["files"] == {name: value for name, value in whole.items() if name != "manifest.json"}
    assert manifest["poppet ensemble"]["circuit"]["title"] == "A tank runs empty"
    assert manifest["poppet ensemble"]["sampling"] == {"way": "random", "runs": 2500, "seed": 1}
    assert {"poppet", "numpy", "scipy", "casadi", "llvmlite", "python", "pyarrow", "kernel"} == manifest[
        "versions"
    ].keys()
    schema = arrow().parquet.read_schema(tmp_path / "set" / "runs" / "part-00000.parquet")
    assert schema.field("air").metadata == {b"unit": b"l ANR"}
    assert schema.field("tank.volume").metadata == {b"unit": b"m^3"}
    assert found.done == 2500


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
def test_another_dataset_is_never_overwritten(tmp_path, whole, differs, values, fields):
    tank(LARGE).ensemble(tmp_path / "set")
    with refused("ensemble.other_dataset", differs=differs):
        tank(LARGE).with_values(values).ensemble(tmp_path / "set", **fields)
    assert hashes(tmp_path / "set") == whole


def test_other_versions_are_never_mixed_in(tmp_path, whole, monkeypatch):
    tank(LARGE).ensemble(tmp_path / "set")
    monkeypatch.setattr(dataset_module, "__version__", "0.0.0")
    with refused("ensemble.other_versions"):
        tank(LARGE).ensemble(tmp_path / "set")
    assert hashes(tmp_path / "set") == whole


def test_a_folder_of_other_files_is_left_alone(tmp_path):
    (tmp_path / "thesis.tex").write_text("years", encoding="utf-8")
    with refused("ensemble.folder_taken"):
        tank(LARGE).ensemble(tmp_path)
    (tmp_path / "manifest.json").write_text("{}", encoding="utf-8")
    with refused("ensemble.folder_taken"):
        tank(LARGE).ensemble(tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["manifest.json", "thesis.tex"]


def test_of_a_full_disk_what_is_done_stays(tmp_path, whole, monkeypatch):
    folder, write, count = tmp_path / "set", dataset_module.write_whole, []

    def full(path, fill):
        if path.parent.name == "runs":
            count.append(path)
        if len(count) > 3:

            def fill(stream):
                stream.write(b"PAR1")
                raise OSError(errno.ENOSPC, "No space left on device")

        return write(path, fill)

    monkeypatch.setattr(dataset_module, "write_whole", full)
    with refused("files.unwritable"):
        tank(LARGE).ensemble(folder, workers=1)
    there = hashes(folder)
    assert len([name for name in there if name.startswith("runs/")]) == 3
    assert all(whole[name] == value for name, value in there.items() if name != "manifest.json")
    monkeypatch.undo()
    tank(LARGE).ensemble(folder)
    assert hashes(folder) == whole


def test_an_interruption_keeps_what_is_done(tmp_path, whole):
    def interrupt(done, total, kind):
        if done > 1000:
            raise KeyboardInterrupt

    found = tank(LARGE).ensemble(tmp_path / "set", workers=1, progress=interrupt)
    assert not found.is_whole
    assert 1000 < found.done < 2500
    assert tank(LARGE).ensemble(tmp_path / "set").is_whole
    assert hashes(tmp_path / "set") == whole


def test_failed_runs_are_rows_without_metrics(monkeypatch):
    """Steps as the run with the numbers of the circuit needs them: some others need more."""
    circuit = tank("")
    problem = circuit.problem(circuit.run)
    few = replace(problem, most_attempts=solve(problem).attempts)
    monkeypatch.setattr(type(circuit), "problem", lambda self, run: few)
    found = circuit.ensemble(runs=40, parameters=NUMBERS, metrics=METRICS, requirements={"any": "end < 9 bar"})
    rows = found.dataset.columns("runs")
    lost = rows["outcome"] == "run.too_many"
    assert 0 < lost.sum() < 40
    assert (np.isnan(rows["end"]) == lost).all()
    assert (rows["done"] == ~lost).all()
    assert found.yields()[0].good == 40 - lost.sum()
    assert [note.code for note in found.remarks()] == ["ensemble.failed"]
    assert found.worst(1)["any"][0].run == int(np.flatnonzero(lost)[0])


def nothing(time: np.ndarray, pressure: np.ndarray) -> float:
    """Of some of the tanks."""
    return float("nan") if pressure[16] > 1.95e5 else 1.0


def test_runs_without_a_value_are_said():
    metrics = METRICS | {"own": {"of": "tank.pressure", "metric": nothing}}
    found = tank("").ensemble(runs=64, parameters=NUMBERS, metrics=metrics, requirements={"one": "own > 0"})
    without = int(np.count_nonzero(np.isnan(found.to_pandas()["own"])))
    assert 0 < without < 64
    said = [(note.code, note.facts["metric"], note.facts["count"]) for note in found.remarks()]
    assert said == [("ensemble.undefined", "own", without)]
    assert [each.good for each in found.yields()] == [64 - without]


def test_stopped_runs_are_measured_up_to_their_stop(tmp_path):
    circuit = tank("").with_values({"run.stop_when": "tank.pressure < 1.2 bar"})
    found = circuit.ensemble(runs=20, parameters=NUMBERS, metrics=METRICS)
    rows = found.dataset.columns("runs")
    # Stopped as it was asked to: the last row is the stop itself.
    assert set(rows["outcome"]) == {"run.stopped"}
    np.testing.assert_allclose(rows["end"], 1.2e5, rtol=1e-6)


def test_every_run_keeps_its_balances():
    assert tank().ensemble(runs=64).dataset.columns("runs")["balance"].max() <= 1.0


def test_numbers_that_others_follow_from(tmp_path):
    """With the ambient pressure move gauge pressures, open ends and walls."""
    circuit = tank("").with_values({"tank.initial_pressure": "2 bar g"})
    given = {"ambient.pressure": {"distribution": "uniform", "low": "0.8 bar", "high": "1.05 bar"}}
    rows = circuit.ensemble(runs=5, parameters=given, metrics=METRICS).dataset.columns("runs")
    for k in range(5):
        single = circuit.with_values({"ambient.pressure": float(rows["ambient.pressure"][k])}).simulate()
        assert rows["end"][k] == pytest.approx(single["tank.pressure"][-1], rel=1e-12)


def test_a_delay_moves_breakpoints(tmp_path):
    circuit = load(Path(__file__).parents[3] / "examples" / "datasheet_valve.toml")
    given = {"valve.switching_time": {"distribution": "uniform", "relative_range": 0.2}}
    metrics = {"end": {"of": "chamber.pressure", "metric": "mean"}}
    rows = circuit.ensemble(runs=3, parameters=given, metrics=metrics).dataset.columns("runs")
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
        found = bands.quantile("tank.pressure", u)
        spread = np.ptp(rows, axis=0)
        assert np.all(np.abs(found - exact) <= 0.03 * spread + 1e-6 * exact)


def test_bands_that_are_lost_come_again(tmp_path):
    folder = tmp_path / "set"
    tank(LARGE).ensemble(folder, keep="bands")
    before = hashes(folder)
    (folder / "bands" / "part-00001.parquet").unlink()
    tank(LARGE).ensemble(folder, keep="bands")
    assert hashes(folder) == before


def test_a_worker_of_another_kind_makes_no_shard(tmp_path, whole, monkeypatch):
    monkeypatch.setattr(shards, "kernel_of_this_machine", lambda: "i486, 1 lanes")
    with refused("ensemble.other_kernel", own="i486, 1 lanes"):
        tank().ensemble(tmp_path / "set")
    assert not list((tmp_path / "set").glob("runs/*"))
    monkeypatch.undo()
    monkeypatch.setenv("POPPET_LANES", "2")
    with refused("ensemble.other_versions"):
        tank().ensemble(tmp_path / "set")
