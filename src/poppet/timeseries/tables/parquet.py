"""Tables in Parquet files, including recordings of poppet."""

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
    """Return the package pyarrow."""
    with needed("pyarrow", "A Parquet file", "data"):
        import pyarrow
        import pyarrow.parquet
    return pyarrow


def table_in(path: Path, columns: list[str] | None = None) -> Any:
    """Return the table of a file, or selected columns of it."""
    package = arrow()
    path.open("rb").close()  # gives the usual error for a missing file
    # Arrow must open the file itself: its threads would call a Python stream, and a thread that still runs at the end
    # of the interpreter aborts the process.
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
