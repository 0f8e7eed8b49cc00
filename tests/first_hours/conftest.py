"""The wheel, installed once for all scripts of first hours, also with several workers of pytest-xdist."""

from __future__ import annotations

import fcntl
import os
import runpy
from pathlib import Path

import pytest

import clean_environment

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="session")
def installed(tmp_path_factory):
    """Clean environment with the wheel of the checkout and the extra `all`.

    Its method `run` runs a command without a terminal, `on_terminal` with one, and `start` starts a server. The folder
    of a command is an argument: `tmp_path` is an empty one.
    """
    pytest.importorskip("hatchling")
    pytest.importorskip("pip")
    shared = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        shared = shared.parent  # each worker has a folder of its own in that of the session
    folder, failed, done = (shared / name for name in ("first-hours", "first-hours.offline", "first-hours.done"))
    with (shared / "first-hours.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # other workers wait until the environment is complete
        if not done.exists() and not failed.exists():
            wheel = runpy.run_path(str(ROOT / "tools" / "package.py"))["built"](shared / "dist")[0]
            try:
                clean_environment.install(wheel, folder)
                done.touch()
            except clean_environment.OfflineError as problem:
                failed.write_text(str(problem), encoding="utf-8")
    if failed.exists():
        pytest.skip(f"pip has no package index: {failed.read_text(encoding='utf-8')}")
    return clean_environment.CleanEnvironment(folder)
