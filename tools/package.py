"""Build wheel and sdist, and try each in an empty environment: `python tools/package.py [FOLDER]`."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

from hatchling import build

ROOT = Path(__file__).resolve().parents[1]


def built(folder: Path) -> list[Path]:
    """Wheel and sdist in a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    here = Path.cwd()
    os.chdir(ROOT)
    try:
        return [folder / name for name in (build.build_wheel(str(folder)), build.build_sdist(str(folder)))]
    finally:
        os.chdir(here)


def tried(package: Path, folder: Path) -> None:
    """Install a package without extras into an empty environment in a folder, and use it; raises where that fails."""
    venv.create(folder / "venv", with_pip=True)
    python = folder / "venv" / ("Scripts" if os.name == "nt" else "bin") / "python"
    clean = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}

    def call(*arguments: str) -> None:
        subprocess.run([python, "-m", *arguments], cwd=folder, env=clean, check=True, stdout=subprocess.DEVNULL)

    call("pip", "install", "-qq", "--disable-pip-version-check", "-c", str(ROOT / "constraints.txt"), str(package))
    call("pip", "check")
    call("poppet", "new", "valve-fill")
    call("poppet", "simulate", "valve-fill.toml", "-o", "fill.csv")
    assert (folder / "fill.csv").stat().st_size > 1000


if __name__ == "__main__":
    for each in built(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "dist"):
        with tempfile.TemporaryDirectory() as empty:
            tried(each, Path(empty))
        print(f"{each}: {each.stat().st_size / 1e6:.1f} MB, installed and used in an empty environment")
