"""Tables in Parquet files, those of recordings among them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import needed
from poppet.timeseries.checks import METADATA, FloatArray
from poppet.timeseries.tables.mat import known
from poppet.timeseries.tables.table import Table, seconds, table_of


def arrow() -> Any:
    """The package that reads and writes them."""
    with needed("pyarrow", "A Parquet file", "data"):
        import pyarrow
        import pyarrow.parquet
    return pyarrow


def table_in(path: Path, columns: list[str] | None = None) -> Any:
    """The table in a file, or some of its columns."""
    package = arrow()
    path.open("rb").close()  # a file that is not there is refused in the words of all files
    # Arrow opens the file itself: a stream of Python is called from its threads, and one of them that is left when
    # the interpreter ends aborts the process.
    with package.OSFile(str(path)) as source:
        return package.parquet.ParquetFile(source).read(columns)


def read(path: Path) -> Table:
    """Read the columns of a Parquet file."""
    content = table_in(path)
    meta = known((content.schema.metadata or {}).get(METADATA.encode(), b"").decode())
    columns: dict[str, FloatArray] = {}
    units, notes = {}, []
    for field, column in zip(content.schema, content.columns, strict=True):
        values = column.to_numpy()
        if values.dtype.kind == "M":
            columns[field.name] = seconds(values)
        elif values.dtype.kind in "iufb":
            columns[field.name] = np.asarray(values, dtype=float)
        else:
            notes.append(Note("table.column_without_numbers", column=field.name))
        units[field.name] = (field.metadata or {}).get(b"unit", b"").decode()
    return table_of(columns, units, notes, meta)
