"""Opening of input files, atomic writing of files, and selection of a format by the file extension."""

from __future__ import annotations

import errno
import os
import stat
import uuid
import zlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from pathlib import Path
from typing import IO, Any, BinaryIO, TypeVar

from poppet.core.errors import InputError, NameSuggestion
from poppet.core.number_format import printable

Choice = TypeVar("Choice")

_KINDS = {stat.S_ISDIR: "folder", stat.S_ISFIFO: "pipe", stat.S_ISSOCK: "socket"}
"""Kinds of paths that are not files. All others are devices."""


def check_characters(path: str | Path) -> None:
    """Raise an error if a path contains a control character, which messages and other programs cannot show."""
    name = str(path)
    if "\n" in name or "\t" in name or printable(name) != name:
        raise InputError("files.control_character", path=name)


_FOLDERS: ContextVar[tuple[Path, ...]] = ContextVar("folders", default=())


@contextmanager
def confined_to(*folders: Path) -> Iterator[None]:
    """Limit the files that a `with` block reads and writes to folders; without folders, remove the limit.

    `check_path` rejects all other paths, also those of links that lead out of the folders. The limit does not apply to
    threads that the block starts.
    """
    token = _FOLDERS.set(tuple(Path(os.path.realpath(folder)) for folder in folders))
    try:
        yield
    finally:
        _FOLDERS.reset(token)


def check_path(path: str | Path) -> None:
    """Raise an error if a path contains a control character, or leads to a folder, pipe, socket or device.

    A missing file is valid. Reading a pipe or a device could wait without end, and writing would replace it. A path
    outside the folders of `confined_to` is also an error.
    """
    check_characters(path)
    folders = _FOLDERS.get()
    if folders and not any(Path(os.path.realpath(path)).is_relative_to(folder) for folder in folders):
        raise InputError("files.outside", path=str(path), folder=str(folders[0]))
    try:
        mode = os.stat(path).st_mode
    except OSError:  # opening the file gives the usual error
        return
    if not stat.S_ISREG(mode):
        kind = next((kind for is_kind, kind in _KINDS.items() if is_kind(mode)), "device")
        raise InputError("files.no_file", path=str(path), kind=kind)


def open_input(path: str | Path) -> BinaryIO:
    """Open a file for reading.

    An error is raised if the path does not lead to a regular file.
    """
    check_path(path)
    # Without O_NONBLOCK, opening a pipe waits for a writer.
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    if not stat.S_ISREG(os.fstat(handle).st_mode):  # replaced after the check
        os.close(handle)
        raise InputError("files.no_file", path=str(path), kind="pipe")
    return os.fdopen(handle, "rb")


def unwritable(path: str | Path, problem: OSError) -> InputError:
    """Convert an error of the operating system to an error for a file that cannot be written."""
    code = "files.full" if problem.errno in _FULL else "files.unwritable"
    return InputError(code, path=str(path), why=problem.strerror or str(problem))


_FULL = (errno.ENOSPC, errno.EFBIG, getattr(errno, "EDQUOT", errno.ENOSPC))
"""Errors of the system if there is no space for a file."""


def make_folder(folder: Path) -> None:
    """Create a folder and its parents.

    A folder that already exists is unchanged.
    """
    check_characters(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as problem:
        raise unwritable(folder, problem) from problem


def write_whole(path: Path, fill: Callable[[IO[bytes]], Any]) -> Path:
    """Write a file completely or not at all.

    The function `fill` receives a temporary file and writes the content into it. The temporary file then replaces the
    file at `path`.
    """
    check_path(path)
    # Resolve links: renaming onto a link would replace the link.
    target = Path(os.path.realpath(path))
    check_folder(path, target.parent)
    # Processes of other hosts can write to a shared folder, but this host cannot detect whether they run.
    host = zlib.crc32(os.uname().nodename.encode()) if hasattr(os, "uname") else 0
    start = f".{target.name}.{host:08x}-"
    # In the same folder: a rename across file systems is a copy, which is not atomic.
    aside = target.with_name(f"{start}{os.getpid()}-{uuid.uuid4().hex[:12]}")
    names: list[str] = []
    with suppress(OSError), os.scandir(target.parent) as entries:  # the folder can be unreadable
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
        raise unwritable(path, problem) from problem
    finally:
        with suppress(OSError):
            aside.unlink(missing_ok=True)
    return path


def check_folder(path: str | Path, folder: Path) -> None:
    """Raise an error if the folder of the output file `path` does not exist or is a file."""
    if not folder.is_dir():
        file = next((parent for parent in (folder, *folder.parents) if parent.exists() and not parent.is_dir()), None)
        if file is not None:
            raise InputError("files.below_file", path=str(path), obstacle=str(file))
        raise InputError("files.no_folder", path=str(path), folder=str(folder))


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
