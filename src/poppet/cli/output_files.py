"""Files that commands write: checked before the work begins, written aside and put in place as a whole."""

from __future__ import annotations

import os
import uuid
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from poppet.errors import InputError, suggestion

RECORDINGS = (".csv", ".parquet", ".mat")
PICTURES = (".png", ".svg")


def output_path(text: str | None, suffixes: Sequence[str]) -> Path | None:
    """A file to be written, checked before anything is computed for it.

    Parameters
    ----------
    text : str or None
        As typed.
    suffixes : sequence of str
        Formats that can be written.

    Returns
    -------
    Path or None
        None when nothing was given.

    Raises
    ------
    InputError
        The suffix names no format, the folder is missing, or it is a folder.
    """
    if text is None:
        return None
    path = Path(text)
    if path.suffix.lower() not in suffixes:
        given = f'has the suffix "{path.suffix}"' if path.suffix else "has no suffix"
        raise InputError(
            f"file {path}", f"{given}, which names no format.", suggestion(path.suffix, suffixes)
        )
    if not path.parent.is_dir():
        raise InputError(
            f"file {path}", "lies in a folder that does not exist.", f"Create {path.parent} first."
        )
    if path.is_dir():
        raise InputError(f"file {path}", "is a folder.", "Name a file.")
    return path


def write_aside(path: Path, write: Callable[[Path], Any]) -> None:
    """Let something be written under another name and put it in place as a whole.

    Parameters
    ----------
    path : Path
        Where it belongs; an existing file is replaced, or stays as it is when the writing fails.
    write : callable
        Gets the path to write to, which has the same suffix.
    """
    target = Path(os.path.realpath(path))
    aside = target.with_name(f".{target.stem}.{uuid.uuid4().hex}{target.suffix}")
    try:
        write(aside)
        aside.replace(target)
    except OSError as error:
        reason = f"cannot be written: {error.strerror or error}."
        raise InputError(f"file {path}", reason, "Choose a file in a folder you may write to.") from error
    finally:
        aside.unlink(missing_ok=True)


def write_text(path: Path, text: str) -> None:
    """Write a text file as a whole or not at all.

    Parameters
    ----------
    path : Path
        Where to.
    text : str
        Written as UTF-8 with line feeds.
    """
    write_aside(path, lambda aside: aside.write_text(text, encoding="utf-8", newline="\n"))
