"""Files written whole or not at all, and their formats chosen by suffix."""

from __future__ import annotations

import os
import uuid
import zlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import IO, Any, TypeVar

from poppet.core.errors import InputError, NameSuggestion

Choice = TypeVar("Choice")


def write_whole(path: Path, fill: Callable[[IO[bytes]], Any]) -> Path:
    """Write any file aside and rename it: it is replaced as a whole or not at all."""
    # Through a link to the file itself: renaming onto the link would turn it into a file of its own.
    target = Path(os.path.realpath(path))
    if not target.parent.is_dir():
        raise InputError("files.no_folder", path=str(path), folder=str(target.parent))
    # In the same folder, because a rename across file systems is a copy, which can stop half way.
    aside = target.with_name(f".{target.name}.{_host()}-{os.getpid()}-{uuid.uuid4().hex[:12]}")
    for orphan in _orphans(target):
        with suppress(OSError):
            orphan.unlink()
    try:
        with aside.open("xb") as stream:
            fill(stream)
        aside.replace(target)
    except OSError as problem:
        raise InputError("files.unwritable", path=str(path), why=problem.strerror or str(problem)) from problem
    finally:
        aside.unlink(missing_ok=True)
    return path


def _host() -> str:
    """Tells machines that share a folder apart: a process of another one is not seen here, and yet may be writing."""
    return f"{zlib.crc32(os.uname().nodename.encode()) if hasattr(os, 'uname') else 0:08x}"


def _orphans(target: Path) -> Iterator[Path]:
    """What killed processes of this machine have left beside a file."""
    start = f".{target.name}.{_host()}-"
    with os.scandir(target.parent) as entries:
        names = [entry.name for entry in entries if entry.name.startswith(start)]
    for name in names:
        process = name[len(start) :].partition("-")[0]
        if process.isdigit() and not _is_running(int(process)):
            yield target.with_name(name)


def _is_running(process: int) -> bool:
    if os.name != "posix":
        return True  # where asking with signal 0 would end it
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (OSError, OverflowError):
        return True
    return True


def by_suffix(path: Path, choices: Mapping[str, Choice]) -> Choice:
    """The choice for the format that a file's suffix names."""
    suffix = path.suffix.lower()
    if suffix not in choices:
        raise InputError("files.suffix", path=str(path), suffix=path.suffix, near=NameSuggestion(suffix, choices))
    return choices[suffix]
