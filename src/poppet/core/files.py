"""Atomic writing of files, and selection of a format by the file extension."""

from __future__ import annotations

import os
import uuid
import zlib
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import IO, Any, TypeVar

from poppet.core.errors import InputError, NameSuggestion

Choice = TypeVar("Choice")


def write_whole(path: Path, fill: Callable[[IO[bytes]], Any]) -> Path:
    """Write a file completely or not at all.

    The function `fill` receives a temporary file and writes the content into it. The temporary file then replaces the
    file at `path`.
    """
    # Resolve links: renaming onto a link would replace the link.
    target = Path(os.path.realpath(path))
    if not target.parent.is_dir():
        raise InputError("files.no_folder", path=str(path), folder=str(target.parent))
    # Processes of other hosts can write to a shared folder, but this host cannot detect whether they run.
    host = zlib.crc32(os.uname().nodename.encode()) if hasattr(os, "uname") else 0
    start = f".{target.name}.{host:08x}-"
    # In the same folder: a rename across file systems is a copy, which is not atomic.
    aside = target.with_name(f"{start}{os.getpid()}-{uuid.uuid4().hex[:12]}")
    with os.scandir(target.parent) as entries:
        names = [entry.name for entry in entries if entry.name.startswith(start)]
    for name in names:
        # Killed processes of this host have not deleted their temporary files.
        process = name[len(start) :].partition("-")[0]
        if process.isdigit() and not _is_running(int(process)):
            with suppress(OSError):
                target.with_name(name).unlink()
    try:
        with aside.open("xb") as stream:
            fill(stream)
        aside.replace(target)
    except OSError as problem:
        raise InputError("files.unwritable", path=str(path), why=problem.strerror or str(problem)) from problem
    finally:
        aside.unlink(missing_ok=True)
    return path


def _is_running(process: int) -> bool:
    if os.name != "posix":
        return True  # signal 0 would end the process
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (OSError, OverflowError):
        pass
    return True


def by_suffix(path: Path, choices: Mapping[str, Choice]) -> Choice:
    """Return the entry of `choices` that belongs to the file extension of a path.

    The keys of `choices` are file extensions. An unknown extension raises an error.
    """
    suffix = path.suffix.lower()
    if suffix not in choices:
        raise InputError("files.suffix", path=str(path), suffix=path.suffix, suggestion=NameSuggestion(suffix, choices))
    return choices[suffix]
