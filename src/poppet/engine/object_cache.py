"""Cache of machine code (object code) on disk.

The name of an entry is a hash of the source, the LLVM version and the processor. A new entry is written to a temporary
file, which is then renamed, so other processes never read an incomplete entry. An unreadable entry is compiled again.
The environment variable `POPPET_CACHE_DIR` sets the folder; the default is the user's cache folder. If the folder is
not writable, each process compiles its code.

An entry is machine code that runs with the rights of the user. Folder and entry must belong to the user, and other
users must not have write permission; otherwise they are neither read nor written. The hash in an entry detects
incomplete files, not forgeries.
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

MAX_ENTRIES = 400
"""Maximum number of entries; the oldest are deleted."""
_MARK = b"poppet1\n"


def object_code(source: str, compile_it: Callable[[str], bytes]) -> bytes:
    """Return the object code of a source text, from the cache on disk if possible.

    Otherwise, `compile_it` compiles the source, and the result is stored.
    """
    path = cache_folder() / f"{_key(source)}.o"
    stored = _stored(path)
    if stored is not None:
        return stored
    code = compile_it(source)
    # Without a usable folder, the next process compiles again.
    with contextlib.suppress(OSError):
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        _check_permissions(path.parent.stat())
        # With rights 0600.
        handle, name = tempfile.mkstemp(dir=path.parent, suffix=".new")
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(_MARK + hashlib.sha256(code).digest() + code)
            # Atomic within a folder.
            os.replace(name, path)
        except OSError:
            Path(name).unlink(missing_ok=True)
            raise
        files = sorted(path.parent.glob("*.o"), key=lambda file: file.stat().st_mtime)
        for obsolete in files[:-MAX_ENTRIES]:
            obsolete.unlink(missing_ok=True)
    return code


def stored_code(source: str) -> bytes | None:
    """Return the object code of a source text if the cache on disk contains it, otherwise None."""
    return _stored(cache_folder() / f"{_key(source)}.o")


def _stored(path: Path) -> bytes | None:
    with contextlib.suppress(OSError):
        entry = _read(path)
        digest, code = entry[len(_MARK) : len(_MARK) + 32], entry[len(_MARK) + 32 :]
        # A full disk can leave an incomplete entry.
        if entry.startswith(_MARK) and hashlib.sha256(code).digest() == digest:
            return code
    return None


def cache_folder() -> Path:
    """Return the folder of the cache on disk."""
    folder = os.environ.get("POPPET_CACHE_DIR")
    if folder:
        return Path(folder)
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
    _check_permissions(path.parent.stat())
    # The open file is checked, and links are not followed: another process could replace the path after a check.
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0))
    with os.fdopen(handle, "rb") as file:
        _check_permissions(os.fstat(file.fileno()))
        return file.read()


def _check_permissions(status: os.stat_result) -> None:
    """Raise PermissionError if another user could change a file or folder.

    `status` is the `os.stat_result` of the file or folder. On Windows, which protects the folder of the user, the check
    always passes.
    """
    if os.name == "posix" and (status.st_uid != os.geteuid() or status.st_mode & (stat.S_IWGRP | stat.S_IWOTH)):
        raise PermissionError("other users have write permission")
