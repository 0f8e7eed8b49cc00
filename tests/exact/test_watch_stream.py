"""Lines of garbage on the standard input of `poppet watch`: the estimates continue, and the memory does not grow."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples" / "watch"
HEADING, *ROWS = (EXAMPLES / "healthy.csv").read_bytes().splitlines(keepends=True)[:101]


def garbage(count: int) -> bytes:
    """Return lines that are no samples: bytes, text, wrong numbers of cells, invalid values and old times."""
    generator = np.random.default_rng(41)
    kinds = [
        generator.integers(0, 256, 80, dtype=np.uint8).tobytes().replace(b"\n", b"?"),
        b"hello", b"", b"1,2", b"1,2,3,4,5,6,7", b"{", b"[1, 2]", b'{"t": "x"}', b'{"t": null, "p": 3}',
        b"nan,nan,nan,nan", b"-1e300,6,0.5,0.5", b"1e999,6,0.5,0.5", b"0.05,1e300,-5,7", b",,,",
    ]  # fmt: skip
    return b"\n".join(kinds[k] for k in generator.integers(0, len(kinds), count)) + b"\n"


def watched(folder: Path, *pieces: bytes) -> tuple[list[dict], int]:
    """Return the rows of the command for lines on its standard input, and its largest memory [bytes]."""
    command = [sys.executable, "-m", "poppet", "watch", str(folder / "twin.toml")]
    with (folder / "out.jsonl").open("wb") as out, (folder / "messages.txt").open("wb") as messages:
        process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=out, stderr=messages)
        assert process.stdin is not None
        with process.stdin:
            for piece in pieces:
                process.stdin.write(piece)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 0, (folder / "messages.txt").read_text()
    rows = [json.loads(line) for line in (folder / "out.jsonl").read_text().splitlines()]
    return rows, 1024 * usage.ru_maxrss


@pytest.mark.skipif(not hasattr(os, "wait4") or sys.platform != "linux", reason="the memory is that of Linux [kB]")
@pytest.mark.parametrize("count", [5_000, pytest.param(1_000_000, marks=pytest.mark.slow)])
def test_garbage_keeps_the_estimates_and_the_memory(tmp_path, count):
    for file in EXAMPLES.iterdir():
        shutil.copy(file, tmp_path)
    clean, memory = watched(tmp_path, HEADING, *ROWS)
    disturbed, later = watched(tmp_path, HEADING, *ROWS[:50], garbage(count), *ROWS[50:])
    assert disturbed == clean
    assert later - memory < 30e6
    # The first message of each kind, and each tenfold number of them.
    assert len((tmp_path / "messages.txt").read_bytes().splitlines()) < 200
