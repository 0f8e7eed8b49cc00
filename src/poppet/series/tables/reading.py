"""One door for all files of columns; each format has a file of its own."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TypeVar

from poppet.ground.errors import InputError
from poppet.ground.files import by_suffix
from poppet.series.tables import mat, mdf, parquet, tdms, text
from poppet.series.tables.table import Table

__all__ = ["Table", "read_table", "read_with"]

Found = TypeVar("Found")

_TEXT = (".csv", ".txt", ".tsv", ".dat", ".asc", ".lvm", ".log")


READERS: dict[str, Callable[[Path], Table]] = {".mat": mat.read, ".parquet": parquet.read}
"""By suffix, the formats that need no options; a new one is one line here."""


def read_table(
    path: Path,
    *,
    separator: str | None = None,
    decimal: str | None = None,
    header_rows: int | None = None,
    group: str | int | None = None,
) -> Table:
    r"""Read the columns of a measured file.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder) / "bench.csv"
    ...     _ = file.write_text("t(s);p [bar]\n0,0;1,5\n0,1;1,25\n")
    ...     table = read_table(file)
    >>> table.names, table.units, table.columns[1].tolist()
    (('t', 'p'), ('s', 'bar'), [1.5, 1.25])
    """
    from_text = partial(text.read, separator=separator, decimal=decimal, header_rows=header_rows)
    grouped: dict[str, Callable[[Path], Table]] = {
        ".tdms": partial(tdms.read, group=group),
        **dict.fromkeys((".mf4", ".mdf"), partial(mdf.read, group=group)),
    }
    readers: dict[str, Callable[[Path], Table]] = {**dict.fromkeys(_TEXT, from_text), **grouped, **READERS}
    reader = by_suffix(path, readers)
    of_text = {"separator": separator, "decimal": decimal, "header_rows": header_rows}
    unfit = {} if reader is from_text else of_text
    unfit |= {} if path.suffix.lower() in grouped else {"group": group}
    for name, value in unfit.items():
        if value is not None:
            raise InputError("table.no_such_option", name, value=value, suffix=path.suffix)
    return read_with(reader, path)


def read_with(reader: Callable[[Path], Found], path: Path) -> Found:
    """What one reader finds in a file, every mistake with the file's name."""
    try:
        return reader(path)
    except OSError as problem:
        raise InputError("files.unreadable", path=str(path), why=problem.strerror or str(problem)) from problem
    except InputError as problem:
        raise problem.located(file=str(path)) from problem.__cause__
    except Exception as problem:
        # Readers of binary formats end in errors of any kind when a file is damaged or of another format.
        why = f"{type(problem).__name__}: {problem}"
        raise InputError("table.unsound", file=str(path), suffix=path.suffix, why=why) from problem
