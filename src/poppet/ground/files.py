"""Files written whole or not at all, and their formats chosen by suffix."""

from __future__ import annotations

import os
import uuid
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import IO, Any, TypeVar

from poppet.ground.errors import InputError, Near

Choice = TypeVar("Choice")


def write_whole(path: Path, fill: Callable[[IO[bytes]], Any]) -> Path:
    """Write any file aside and rename it: it is replaced as a whole or not at all."""
    # Through a link to the file itself: renaming onto the link would turn it into a file of its own.
    target = Path(os.path.realpath(path))
    if not target.parent.is_dir():
        raise InputError("files.no_folder", path=str(path), folder=str(target.parent))
    # In the same folder, because a rename across file systems is a copy, which can stop half way.
    aside = target.with_name(f".{target.name}.{uuid.uuid4().hex}")
    try:
        with aside.open("xb") as stream:
            fill(stream)
        aside.replace(target)
    except OSError as problem:
        raise InputError("files.unwritable", path=str(path), why=problem.strerror or str(problem)) from problem
    finally:
        aside.unlink(missing_ok=True)
    return path


def by_suffix(path: Path, choices: Mapping[str, Choice]) -> Choice:
    """The choice for the format that a file's suffix names."""
    suffix = path.suffix.lower()
    if suffix not in choices:
        raise InputError("files.suffix", path=str(path), suffix=path.suffix, near=Near(suffix, choices))
    return choices[suffix]
