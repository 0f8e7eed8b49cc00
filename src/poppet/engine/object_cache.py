"""Object code on disk: what was compiled once on this machine is not compiled again.

Entries are files named by a hash of everything that decides the code: its source, the version of LLVM, and the
processor. They are written aside and renamed, so that two processes never read half an entry; one that cannot be read
is made anew. `POPPET_CACHE_DIR` names the folder; without it the user's cache folder is taken. If the folder cannot be
written, everything works, only slower.

An entry is machine code that will run with the user's rights. What is trusted is the file system alone: folder and
entry must belong to the user, and nobody else may write them; else they are neither read nor written. The hash in front
of an entry finds halves, not forgeries.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import stat
import sys
import tempfile
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

MOST_ENTRIES = 400
"""Entries kept; the oldest go first."""
_MARK = b"poppet1\n"


def object_code(source: str, compile_it: Callable[[str], bytes]) -> bytes:
    """Code from the cache, or freshly compiled and kept."""
    path = cache_folder() / f"{_key(source)}.o"
    with contextlib.suppress(OSError):
        entry = _read(path)
        digest, code = entry[len(_MARK) : len(_MARK) + 32], entry[len(_MARK) + 32 :]
        # Half an entry that a full disk left behind must not be run.
        if entry.startswith(_MARK) and hashlib.sha256(code).digest() == digest:
            return code
    code = compile_it(source)
    # A folder that is full, read-only or open to others costs time at the next start, no more.
    with contextlib.suppress(OSError):
        _keep(path, _MARK + hashlib.sha256(code).digest() + code)
    return code


def cache_folder() -> Path:
    """Where the entries lie."""
    named = os.environ.get("POPPET_CACHE_DIR")
    if named:
        return Path(named)
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData" / "Local")) / "poppet" / "cache"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "poppet"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "poppet"


@lru_cache(maxsize=1)
def _machine() -> str:
    import llvmlite
    import llvmlite.binding as llvm

    processor = llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()
    return "|".join((llvmlite.__version__, llvm.get_process_triple(), *processor))


def _key(source: str) -> str:
    return hashlib.sha256(f"{_machine()}\n{source}".encode()).hexdigest()[:40]


def _read(path: Path) -> bytes:
    _check(path.parent.stat())
    # The opened file is looked at, not its name, and no link is followed: between two looks a name may change hands.
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0))
    with os.fdopen(handle, "rb") as file:
        _check(os.fstat(file.fileno()))
        return file.read()


def _check(found: os.stat_result) -> None:
    """Refuse what somebody else owns or may write; Windows keeps the user's folder to the user itself."""
    if os.name == "posix" and (found.st_uid != os.geteuid() or found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)):
        raise PermissionError("others may write here")


def _keep(path: Path, entry: bytes) -> None:
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    _check(path.parent.stat())
    # With rights 0600.
    handle, name = tempfile.mkstemp(dir=path.parent, suffix=".new")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(entry)
        # Renaming is atomic within a folder: others see the old entry, the new one, or none.
        os.replace(name, path)
    except OSError:
        Path(name).unlink(missing_ok=True)
        raise
    # Only where something new was written: reading stays free of it.
    _forget_oldest(path.parent)


def _forget_oldest(folder: Path) -> None:
    entries = sorted(folder.glob("*.o"), key=lambda entry: entry.stat().st_mtime)
    for entry in entries[:-MOST_ENTRIES]:
        entry.unlink(missing_ok=True)
