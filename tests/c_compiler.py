"""C for tests: compiled as strictly as anybody may, loaded into this process, and a kernel that runs it."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from collections.abc import Mapping
from pathlib import Path

import pytest

COMPILER = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
STRICT = ("-pedantic", "-Wall", "-Wextra", "-Werror")


def compile_c(sources: Mapping[str, str], folder: Path, *options: str) -> Path:
    """A program or library of C sources, in a folder."""
    if COMPILER is None:
        pytest.skip("there is no C compiler on this machine")
    for name, text in sources.items():
        (folder / name).write_text(text, encoding="utf-8")
    out = folder / "made"
    paths = [str(folder / name) for name in sources if name.endswith(".c")]
    subprocess.run([COMPILER, *STRICT, *options, "-o", str(out), *paths, "-lm"], check=True)
    return out


def shared_library(sources: Mapping[str, str], folder: Path, *options: str) -> ctypes.CDLL:
    """Functions of C in this process; without fused operations unless the options say otherwise."""
    options = options or ("-std=c99", "-O1", "-ffp-contract=off")
    return ctypes.CDLL(str(compile_c(sources, folder, *options, "-shared", "-fPIC")))
