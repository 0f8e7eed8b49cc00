"""Files that commands write, checked before the work begins."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from poppet.ground.errors import InputError, suggestion

RECORDINGS = (".csv", ".parquet", ".mat")
PICTURES = (".png", ".svg", ".pdf")


def output_path(text: str | None, suffixes: Sequence[str]) -> Path | None:
    """A file to be written, checked before anything is computed for it."""
    if text is None:
        return None
    path = Path(text)
    if path.suffix.lower() not in suffixes:
        given = f'has the suffix "{path.suffix}"' if path.suffix else "has no suffix"
        raise InputError(f"file {path}", f"{given}, which names no format.", suggestion(path.suffix, suffixes))
    if not path.parent.is_dir():
        raise InputError(f"file {path}", "lies in a folder that does not exist.", f"Create {path.parent} first.")
    if path.is_dir():
        raise InputError(f"file {path}", "is a folder.", "Name a file.")
    return path


def write_text(path: Path, text: str) -> None:
    """Write a text file as a whole or not at all."""
    from poppet.ground.files import write_whole

    write_whole(path, lambda stream: stream.write(text.encode()))
