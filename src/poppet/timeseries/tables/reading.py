"""Reader of column files; each format has its own module."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import numpy as np

from poppet.core.errors import InputError
from poppet.core.files import by_suffix
from poppet.core.plugins import Registry
from poppet.core.units import LARGEST
from poppet.timeseries.tables import mat, mdf, parquet, tdms, text
from poppet.timeseries.tables.table import Table

__all__ = ["Table", "read_table", "read_with"]

Found = TypeVar("Found")

READERS: Registry[Callable[..., Table]] = Registry(
    "poppet.readers",
    {
        **dict.fromkeys((".csv", ".txt", ".tsv", ".dat", ".asc", ".lvm", ".log"), text.read),
        ".tdms": tdms.read,
        **dict.fromkeys((".mf4", ".mdf"), mdf.read),
        ".mat": mat.read,
        ".parquet": parquet.read,
    },
    lambda suffix, reader: callable(reader),
    prefix=".",
)
"""Suffix to reader. A reader takes a path and those options that its format needs."""


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
    options = {"separator": separator, "decimal": decimal, "header_rows": header_rows, "group": group}
    selected = {name: value for name, value in options.items() if value is not None}
    reader = by_suffix(path, READERS)
    for name in selected.keys() - inspect.signature(reader).parameters:
        raise InputError("table.no_such_option", name, value=selected[name], suffix=path.suffix)

    def plausible(path: Path) -> Table:
        table = reader(path, **selected)
        for name, column in zip(table.names, table.columns, strict=True):
            implausible = np.flatnonzero(np.isfinite(column) & (np.abs(column) > LARGEST))
            if implausible.size:
                k = int(implausible[0])
                line = table.lines[k] if len(table.lines) else None
                raise InputError("table.huge", column=name, value=float(column[k]), most=LARGEST, line=line)
        return table

    return read_with(plausible, path)


def read_with(reader: Callable[[Path], Found], path: Path) -> Found:
    """Return the result of a reader; every error contains the name of the file."""
    try:
        return reader(path)
    except OSError as problem:
        raise InputError("files.unreadable", path=str(path), why=problem.strerror or str(problem)) from problem
    except InputError as problem:
        raise problem.located(file=str(path)) from problem.__cause__
    except Exception as problem:
        # Readers of binary formats raise errors of many types for a damaged file or another format.
        why = f"{type(problem).__name__}: {problem}"
        raise InputError("table.unsound", file=str(path), suffix=path.suffix, why=why) from problem
