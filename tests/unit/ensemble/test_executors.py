"""The same files, bit for bit: threads, processes, Dask, and after kills at any moment."""

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
def whole(tmp_path_factory) -> dict[str, str]:
    """With bands and Sobol indices, so that every kind of file is there."""
    folder = tmp_path_factory.mktemp("whole") / "one"
    tank(SEVERAL).ensemble(folder, workers=1)
    found = hashes(folder)
    assert {name.partition("/")[0] for name in found} == {"runs", "bands", "tornado", "indices", "manifest.json"}
    return found


def test_threads_and_processes_make_the_same_files(tmp_path, whole):
    tank(SEVERAL).ensemble(tmp_path / "threads", workers=2)
    assert hashes(tmp_path / "threads") == whole
    tank(SEVERAL).ensemble(tmp_path / "processes", executor="processes", workers=2)
    assert hashes(tmp_path / "processes") == whole


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("workers", [1, 3])
def test_dask_makes_the_same_files(tmp_path, whole, workers):
    distributed = pytest.importorskip("distributed", reason="needs poppet[dask]")
    cluster = distributed.LocalCluster(
        n_workers=workers, threads_per_worker=1, processes=workers > 1, dashboard_address=None, silence_logs=50
    )
    with cluster, distributed.Client(cluster) as client:
        tank(SEVERAL).ensemble(tmp_path / "client", executor=client)
        assert hashes(tmp_path / "client") == whole
        if workers == 1:
            run_ensemble(tank(SEVERAL), tmp_path / "address", executor=cluster.scheduler_address)
            assert hashes(tmp_path / "address") == whole


def test_what_is_no_executor(tmp_path):
    with refused("fields.out_of_range", "workers"):
        tank().ensemble(tmp_path / "set", workers=0)
    for given in ("thread", 5):
        with refused("ensemble.executor"):
            tank().ensemble(tmp_path / "set", executor=given)


# Shards are far quicker than a start; a command that waits before each of them can be met between any two.
SLOW = """
import time, poppet.ensemble.shards as s
own = s.shard_files
def late(*a):
    time.sleep(0.05)
    return own(*a)
s.shard_files = late
"""


def killed(folder: Path, kills: int, seed: int) -> int:
    """Start the command and kill it at a random moment, so often; how many runs of it left something behind."""
    (folder / "tank.toml").write_text(TANK + SEVERAL, encoding="utf-8")
    moments, work = random.Random(seed), 0
    command = [sys.executable, "-m", "poppet", "ensemble", "tank.toml", "-o", "set", "--workers", "1", "--quiet"]
    command[1:3] = ["-c", f"{SLOW}import sys\nfrom poppet.cli.main import run\nsys.exit(run(sys.argv[1:]))"]
    for _ in range(kills):
        before = len(list(folder.glob("set/*/*")))
        process = subprocess.Popen(command, cwd=folder, env=os.environ | {"PYTHONUNBUFFERED": "1"})
        # Until it writes, at most; then any moment of what follows.
        end = time.monotonic() + 60.0
        while len(list(folder.glob("set/*/*"))) <= before and process.poll() is None and time.monotonic() < end:
            time.sleep(0.002)
        time.sleep(moments.uniform(0.0, 0.12))
        process.send_signal(signal.SIGKILL)
        process.wait()
        work += len(list(folder.glob("set/*/*"))) > before
        if len(list(folder.glob("set/*/part-*"))) >= 12:
            # Nearly done: begin again, in the hope of other moments.
            for path in folder.glob("set/*/part-*"):
                if moments.random() < 0.7:
                    path.unlink()
    subprocess.run([sys.executable, "-m", "poppet", *command[3:]], cwd=folder, check=True)
    return work


@pytest.mark.skipif(os.name != "posix", reason="kills as POSIX does")
@pytest.mark.parametrize("kills", [1, pytest.param(20, marks=pytest.mark.slow)])
def test_kills_leave_what_the_next_run_completes(tmp_path, whole, kills):
    assert killed(tmp_path, kills, seed=kills) >= 0.9 * kills
    assert hashes(tmp_path / "set") == whole


@pytest.mark.skipif(os.name != "posix", reason="signals as POSIX has them")
def test_an_interrupt_ends_the_command_and_keeps_what_is_done(tmp_path, whole):
    (tmp_path / "tank.toml").write_text(TANK + SEVERAL, encoding="utf-8")
    command = [sys.executable, "-c", f"{SLOW}import sys\nfrom poppet.cli.main import run\nsys.exit(run(sys.argv[1:]))"]
    command += ["ensemble", "tank.toml", "-o", "set", "--workers", "1"]
    # A shell may have told its children to ignore it.
    listens = {"preexec_fn": lambda: signal.signal(signal.SIGINT, signal.default_int_handler)}
    with subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE, **listens) as process:
        end = time.monotonic() + 60.0
        while not list(tmp_path.glob("set/runs/part-*")) and process.poll() is None and time.monotonic() < end:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate()
    assert process.returncode == 130
    assert b"Traceback" not in said
    there = hashes(tmp_path / "set")
    assert 1 < len(there) < len(whole)
    assert all(whole[name] == value for name, value in there.items() if name != "manifest.json")
    tank(SEVERAL).ensemble(tmp_path / "set")
    assert hashes(tmp_path / "set") == whole
