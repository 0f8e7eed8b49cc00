"""Reader of the circuit of an edited text, which may name files of its folder only."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from poppet.api import Circuit, loads
from poppet.core.toml_file import TomlFile
from poppet.edit.document import MARK

FILE_FIELDS = ("characteristic", "components", "file", "from_fit", "path")
"""Fields of a circuit file that can name another file."""


def read_text(text: str, folder: Path) -> Circuit:
    """Return the circuit of a text.

    Parameters
    ----------
    text : str
        Text of a circuit file.
    folder : Path
        Folder of the circuit file, to which relative paths refer.

    Raises
    ------
    InputErrors
        If the text is invalid, or names a file outside the folder, also by a symbolic link.
    """
    text = text.removeprefix(MARK)
    # Without a name: the errors of this text have no file.
    file = TomlFile(text, "", folder)
    top = os.path.realpath(folder)
    with file.errors() as errors:
        for address, path in named_files(file.tables):
            # A path with a null character cannot be resolved; the readers report it.
            if "\0" not in path and not Path(os.path.realpath(folder / path)).is_relative_to(top):
                errors.add("edit.outside", address, path=path, folder=folder.name)
    return loads(text, name="", folder=folder)


def named_files(table: Mapping[str, Any], start: str = "") -> Iterator[tuple[str, str]]:
    """Yield the addresses and the values of the fields that can name a file.

    Examples
    --------
    >>> [*named_files({"signals": {"valve.command": {"kind": "file", "path": "course.csv"}}})]
    [('signals.valve.command.path', 'course.csv')]
    """
    for key, value in table.items():
        address = f"{start}{key}"
        if isinstance(value, Mapping):
            yield from named_files(value, f"{address}.")
        elif key in FILE_FIELDS:
            yield from (
                (address, item) for item in (value if isinstance(value, list) else [value]) if isinstance(item, str)
            )
