"""Count the files that a run of the library visits; `house.py measure` starts this in processes of its own."""

from __future__ import annotations

import contextlib
import io
import json
import os
import runpy
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

PACKAGE = "poppet"


class Visits:
    """Files of a package that Python calls enter, and how often the next call lies in another file than the last."""

    def __init__(self, root: Path) -> None:
        self.root, self.last, self.changes = f"{root}{os.sep}", "", 0
        self.files: set[str] = set()

    def __call__(self, frame: FrameType, event: str, _: object) -> None:
        name = frame.f_code.co_filename
        if event == "call" and name.startswith(self.root):
            self.changes += bool(self.last) and name != self.last
            self.last = name
            self.files.add(name)

    def of(self, work: Callable[[], Any]) -> str:
        sys.setprofile(self)
        try:
            work()
        finally:
            sys.setprofile(None)
        return f"{len(self.files)} / {self.changes}"


def simulate(checkout: Path) -> None:
    __import__(PACKAGE).load(checkout / "examples/fill_staircase.toml").simulate()


def fit(checkout: Path) -> None:
    sys.argv = [PACKAGE, "identify", "fit", str(checkout / "examples/identify/fit.toml")]
    with contextlib.redirect_stdout(io.StringIO()):
        try:
            runpy.run_module(PACKAGE, run_name="__main__")
        except SystemExit as end:
            if end.code:
                raise RuntimeError(f"identify fit ends with {end.code}") from end


WORK = {"simulate": simulate, "identify fit": fit}


def visit(checkout: Path, what: str) -> None:
    """The work twice, the first time with all imports."""
    root = checkout / "src" / PACKAGE
    found = Path(__import__(PACKAGE).__file__ or "").parent
    if found != root:
        raise SystemExit(f"{found} answers instead of {root}.")
    print(json.dumps([Visits(root).of(lambda: WORK[what](checkout)) for _ in range(2)]))


def visit_figures(checkout: Path) -> dict[str, str]:
    checkout = checkout.resolve()
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"PYTHONPATH": str(checkout / "src"), "POPPET_CACHE_DIR": folder}
        environment |= {"PYTHONDONTWRITEBYTECODE": "1", "PYTHONHASHSEED": "0"}
        for what in WORK:
            command = [sys.executable, str(Path(__file__).resolve()), str(checkout), what]
            for _ in range(2):  # the first one fills the cache of compiled code
                run = subprocess.run(command, env=environment, cwd=folder, capture_output=True, text=True, check=False)
            if run.returncode:
                print(run.stderr, file=sys.stderr)
            for times, seen in zip(("first", "second"), json.loads(run.stdout or "[null, null]"), strict=True):
                found[f"{times} `{what}`: files visited / changes of file"] = seen or "failed"
    return found


if __name__ == "__main__":
    visit(Path(sys.argv[1]), sys.argv[2])
