"""Circuit files of the figures of Varga & Keski-Honkola 2012."""

from __future__ import annotations

from operator import methodcaller
from pathlib import Path

from poppet.core.errors import ErrorCollector
from poppet.core.files import make_folder, write_whole

CIRCUITS = {path.name: path for path in sorted(Path(__file__).with_name("circuits").glob("figure*.toml"))}
"""Circuit files by name; figures 1 and 2 of the paper are drawings, and figure 6 is the last one."""


def write_circuits(folder: Path, *, is_forced: bool = False) -> list[Path]:
    """Write the circuits of figures 3 to 6 to a folder, and return their paths.

    A changed file in the folder is an error unless `is_forced` is True; no file is then written.
    """
    make_folder(folder)
    texts = {folder / name: path.read_bytes() for name, path in CIRCUITS.items()}
    with ErrorCollector() as errors:
        for path, text in texts.items():
            if path.exists() and not is_forced and not (path.is_file() and path.read_bytes() == text):
                errors.add("paper.circuit_exists", path=str(path))
    for path, text in texts.items():
        write_whole(path, methodcaller("write", text))
    return [*texts]
