"""Bit-identical files of threads, processes and Dask, and after kills."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from circuits_of_ensembles import LARGE, TANK, hashes, tank
from poppet.ensemble import run_ensemble
from refusals import refused

SEVERAL = LARGE.replace("seed = 1", 'seed = 1\nsampling = "sobol"\nkeep = "bands"\nindices = 512')


@pytest.fixture(scope="module")
def expected_hashes(tmp_path_factory) -> dict[str, str]:
    """Hashes of an ensemble with bands and Sobol indices, which has files of all kinds."""
    folder = tmp_path_factory.mktemp("whole") / "one"
    tank(SEVERAL).ensemble(folder, workers=1)
    result_hashes = hashes(folder)
    assert {name.partition("/")[0] for name in result_hashes} == {
        "runs",
        "bands",
        "tornado",
        "indices",
        "manifest.json",
    }
    return result_hashes


def test_threads_and_processes_write_identical_files(tmp_path, expected_hashes):
    tank(SEVERAL).ensemble(tmp_path / "threads", workers=2)
    assert hashes(tmp_path / "threads") == expected_hashes
    tank(SEVERAL).ensemble(tmp_path / "processes", executor="processes", workers=2)
    assert hashes(tmp_path / "processes") == expected_hashes


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("workers", [1, 3])
def test_dask_writes_identical_files(tmp_path, expected_hashes, workers):
    distributed = pytest.importorskip("distributed", reason="needs poppet[dask]")
    cluster = distributed.LocalCluster(
        n_workers=workers, threads_per_worker=1, processes=workers > 1, dashboard_address=None, silence_logs=50
    )
    with cluster, distributed.Client(cluster) as client:
        tank(SEVERAL).ensemble(tmp_path / "client", executor=client)
        assert hashes(tmp_path / "client") == expected_hashes
        if workers == 1:
            run_ensemble(tank(SEVERAL), tmp_path / "address", executor=cluster.scheduler_address)
            assert hashes(tmp_path / "address") == expected_hashes


def test_invalid_executors_are_rejected(tmp_path):
    with refused("fields.out_of_range", "workers"):
        tank().ensemble(tmp_path / "set", workers=0)
    for executor in ("thread", 5):
        with refused("ensemble.executor"):
            tank().ensemble(tmp_path / "set", executor=executor)


# Shards are much faster than a start: the command waits before each shard, so it can be killed between any two.
SLOW = """
import time, poppet.ensemble.shards as s
own = s.shard_files
def late(*a):
    time.sleep(0.05)
    return own(*a)
s.shard_files = late
"""


def kill_repeatedly(folder: Path, kills: int, seed: int) -> int:
    """Kill the command several times at random times; return the number of runs that wrote files."""
    (folder / "tank.toml").write_text(TANK + SEVERAL, encoding="utf-8")
    random_source, work = random.Random(seed), 0
    command = [sys.executable, "-m", "poppet", "ensemble", "tank.toml", "-o", "set", "--workers", "1", "--quiet"]
    command[1:3] = ["-c", f"{SLOW}import sys\nfrom poppet.cli.main import run\nsys.exit(run(sys.argv[1:]))"]
    for _ in range(kills):
        n_files = len(list(folder.glob("set/*/*")))
        process = subprocess.Popen(command, cwd=folder, env=os.environ | {"PYTHONUNBUFFERED": "1"})
        # Wait for the first new file, then for a random time.
        end = time.monotonic() + 60.0
        while len(list(folder.glob("set/*/*"))) <= n_files and process.poll() is None and time.monotonic() < end:
            time.sleep(0.002)
        time.sleep(random_source.uniform(0.0, 0.12))
        process.send_signal(signal.SIGKILL)
        process.wait()
        work += len(list(folder.glob("set/*/*"))) > n_files
        if len(list(folder.glob("set/*/part-*"))) >= 12:
            # Nearly complete: delete shards for further kills.
            for path in folder.glob("set/*/part-*"):
                if random_source.random() < 0.7:
                    path.unlink()
    subprocess.run([sys.executable, "-m", "poppet", *command[3:]], cwd=folder, check=True)
    return work


@pytest.mark.skipif(os.name != "posix", reason="kills as POSIX does")
@pytest.mark.parametrize("kills", [1, pytest.param(20, marks=pytest.mark.slow)])
def test_killed_ensemble_is_completed_by_the_next_run(tmp_path, expected_hashes, kills):
    assert kill_repeatedly(tmp_path, kills, seed=kills) >= 0.9 * kills
    assert hashes(tmp_path / "set") == expected_hashes


@pytest.mark.skipif(os.name != "posix", reason="signals as POSIX has them")
def test_interrupted_command_keeps_completed_shards(tmp_path, expected_hashes):
    (tmp_path / "tank.toml").write_text(TANK + SEVERAL, encoding="utf-8")
    command = [sys.executable, "-c", f"{SLOW}import sys\nfrom poppet.cli.main import run\nsys.exit(run(sys.argv[1:]))"]
    command += ["ensemble", "tank.toml", "-o", "set", "--workers", "1"]
    # A shell can start its children with the signal ignored.
    signal_options = {"preexec_fn": lambda: signal.signal(signal.SIGINT, signal.default_int_handler)}
    with subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE, **signal_options) as process:
        end = time.monotonic() + 60.0
        while not list(tmp_path.glob("set/runs/part-*")) and process.poll() is None and time.monotonic() < end:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, stderr = process.communicate()
    assert process.returncode == 130
    assert b"Traceback" not in stderr
    stored_hashes = hashes(tmp_path / "set")
    assert 1 < len(stored_hashes) < len(expected_hashes)
    assert all(expected_hashes[name] == value for name, value in stored_hashes.items() if name != "manifest.json")
    tank(SEVERAL).ensemble(tmp_path / "set")
    assert hashes(tmp_path / "set") == expected_hashes
