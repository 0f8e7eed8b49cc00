"""Tables in Parquet files, those of recordings among them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from poppet.ground.errors import MissingDependencyError
from poppet.series.checks import FloatArray
from poppet.series.measured.columns import Table, seconds, table_of


def read(path: Path) -> Table:
    """Read the columns of a Parquet file."""
    try:
        import pyarrow.parquet
    except ImportError as problem:
        raise MissingDependencyError("pyarrow", "A Parquet file", "data") from problem
    with path.open("rb") as stream:
        content = pyarrow.parquet.read_table(stream)
    columns: dict[str, FloatArray] = {}
    units, skipped = {}, []
    for field, column in zip(content.schema, content.columns, strict=True):
        values = column.to_numpy()
        if values.dtype.kind == "M":
            columns[field.name] = seconds(values)
        elif values.dtype.kind in "iufb":
            columns[field.name] = np.asarray(values, dtype=float)
        else:
            skipped.append(field.name)
        units[field.name] = (field.metadata or {}).get(b"unit", b"").decode()
    return table_of(columns, units, [f'Column "{name}" holds no numbers; it was left out.' for name in skipped])
