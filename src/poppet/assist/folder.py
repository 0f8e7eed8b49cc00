"""Files of the one folder that the functions read and write."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from poppet.assist.limits import FILES, TEXT, VISITED
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.files import check_characters, check_folder, check_path, confined_to, open_input, write_whole

TEXTS = (".toml", ".csv", ".json", ".md", ".txt", ".st")
"""Suffixes of files that can be read."""
WRITTEN = (".toml", ".csv", ".json", ".md", ".txt")
"""Suffixes of files that can be written: none is executed."""
DATA = (".parquet", ".mat", ".mf4", ".mdf", ".tdms", ".png", ".svg")
"""Suffixes of further files that are listed."""
DEPTH = 4
"""Largest number of nested folders that are listed."""
_DEVICES = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)


@dataclass(frozen=True)
class Folder:
    """Folder to which all file access is confined, also after links are resolved.

    Names of files are relative, with `/` between folders. Names that begin with a dot, such as `.git`, are not valid.
    """

    path: Path

    @classmethod
    def of(cls, path: str | Path) -> Folder:
        """Return a folder after a check that it exists."""
        check_characters(path)
        if not Path(path).is_dir():
            raise InputError("assist.no_folder", path=str(path))
        return cls(Path(os.path.realpath(path)))

    def file(self, name: str, address: str, suffixes: Iterable[str] = TEXTS) -> Path:
        """Return the path of a file after a check of its name; the file does not have to exist.

        `address` is the name of the argument, for errors.
        """
        check_name(name, address)
        path = self.path / name
        if path.suffix.lower() not in suffixes:
            suggestion = NameSuggestion(path.suffix.lower(), suffixes)
            raise InputError("files.suffix", address, path=name, suffix=path.suffix, suggestion=suggestion)
        with confined_to(self.path):
            try:
                check_path(path)
            except InputError as error:
                raise self._shown(error, name, address) from None
        return path

    def existing(self, name: str, address: str, suffixes: Iterable[str] = TEXTS) -> Path:
        """Return the path of a file that exists."""
        path = self.file(name, address, suffixes)
        if not path.exists():
            suggestion = NameSuggestion(name, [row["name"] for row in self.files()[0]])
            raise InputError("names.unknown", name, meaning="a file of the folder", suggestion=suggestion)
        return path

    def target(self, name: str, address: str, replace: bool, suffixes: Iterable[str] = WRITTEN) -> Path:
        """Return the path of a file that a function writes; an existing one must not be there without `replace`."""
        path = self.file(name, address, suffixes)
        if not replace and (path.exists() or path.is_symlink()):
            raise InputError("assist.exists", address, path=name)
        try:
            check_folder(name, path.parent)
        except InputError as error:
            raise self._shown(error, name, address) from None
        return path

    def read(self, name: str, address: str) -> str:
        """Return the text of a file."""
        path = self.existing(name, address)
        try:
            with confined_to(self.path), open_input(path) as stream:
                data = stream.read(TEXT + 1)
        except OSError as error:
            raise InputError("files.unreadable", address, path=name, why=error.strerror or str(error)) from None
        if len(data) > TEXT:
            raise InputError("assist.large_file", address, path=name, most=TEXT)
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = "\0"
        if "\0" in text:
            raise InputError("assist.no_text", name)
        return text

    def write(self, name: str, address: str, text: str, replace: bool) -> int:
        """Write a text to a file completely or not at all, and return its size."""
        path, data = self.target(name, address, replace), text.encode("utf-8")
        with confined_to(self.path):
            write_whole(path, lambda stream: stream.write(data))
        return len(data)

    def files(self) -> tuple[list[dict[str, Any]], bool]:
        """Return names, sizes and times of the files with known suffixes, and True if there are more."""
        rows: list[dict[str, Any]] = []
        count = 0
        for folder, folders, names in os.walk(self.path):
            count += len(names) + 1
            if count > VISITED:
                return rows, True
            depth = len(Path(folder).relative_to(self.path).parts)
            folders[:] = sorted(name for name in folders if not name.startswith(".")) if depth < DEPTH else []
            for name in sorted(names):
                path = Path(folder, name)
                if name.startswith(".") or path.suffix.lower() not in (*TEXTS, *DATA) or path.is_symlink():
                    continue
                if len(rows) == FILES:
                    return rows, True
                with suppress(OSError):  # deleted after it was listed
                    rows.append({"name": path.relative_to(self.path).as_posix(), "bytes": path.stat().st_size})
        return rows, False

    def shown(self, text: str) -> str:
        """Return a text in which paths are relative to the folder."""
        return text.replace(f"{self.path}{os.sep}", "").replace(str(self.path), ".")

    def _shown(self, error: InputError, name: str, address: str) -> InputError:
        """Return an error with the name of the file as the user wrote it."""
        facts: dict[str, Any] = {**error.facts, "path": name}
        if "folder" in facts:
            folder = Path(str(facts["folder"]))
            facts["folder"] = self.shown(str(folder)) if folder.is_relative_to(self.path) else "."
        return InputError(error.code, error.address or address, **facts)


def check_name(name: str, address: str) -> None:
    """Raise an error if a name is not that of a file in the folder or below it.

    Absolute paths, `..`, hidden files, devices of Windows and special characters are not valid.
    """
    pieces = name.split("/")
    is_valid = 0 < len(name) <= 200 and name.isprintable() and not any(letter in name for letter in '\\:*?"<>|')
    for piece in pieces:
        is_valid &= bool(piece) and not piece.startswith(".") and not piece.endswith((".", " "))
        is_valid &= not _DEVICES.fullmatch(piece)
    if not is_valid:
        raise InputError("assist.file_name", address, name=name if len(name) <= 100 else f"{name[:100]}...")
