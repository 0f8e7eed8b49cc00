"""Tables in MAT files: vectors of MATLAB and recordings of poppet."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.errors import needed
from poppet.timeseries.checks import METADATA, FloatArray
from poppet.timeseries.tables.table import Table, table_of


def known(metadata: Any) -> dict[str, Any]:
    """Return the metadata of a recording, empty for files of other programs."""
    try:
        content = json.loads(metadata) if isinstance(metadata, str) else {}
    except ValueError:
        content = {}
    return content if isinstance(content, dict) and "columns" in content and "units" in content else {}


def read(path: Path) -> Table:
    """Read the vectors of a MAT file."""
    from scipy.io import loadmat
    from scipy.io.matlab import matfile_version

    with path.open("rb") as stream:
        is_hdf5 = matfile_version(stream)[0] == 2  # format -v7.3, which SciPy cannot read
        content = {} if is_hdf5 else loadmat(stream, squeeze_me=True, simplify_cells=True)
    if is_hdf5:
        content = _hdf5(path)
    meta = known(content.pop(METADATA, ""))
    columns = dict(_vectors(content))
    if any(values.size > 1 for values in columns.values()):
        # Single numbers in a file with vectors are settings.
        columns = {name: values for name, values in columns.items() if values.size > 1}
    return table_of(columns, {}, meta=meta)


def _hdf5(path: Path) -> dict[str, Any]:
    with needed("h5py", "A MAT file of version 7.3", "measured"):
        import h5py
    with h5py.File(path, "r") as file:
        return {name: _hdf5_item(item) for name, item in file.items() if not name.startswith("#")}


def _hdf5_item(item: Any) -> Any:
    if hasattr(item, "items"):
        return {name: _hdf5_item(inner) for name, inner in item.items()}
    if item.dtype.kind not in "iufb" or item.attrs.get("MATLAB_class", b"") in (b"char", b"cell"):
        return None
    return np.squeeze(np.asarray(item).T)  # MATLAB stores axes in reverse order


def _vectors(content: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, FloatArray]]:
    for name, value in content.items():
        if isinstance(value, Mapping):
            yield from _vectors(value, f"{prefix}{name}.")
        elif isinstance(value, np.ndarray | float | int) and not name.startswith("__"):
            yield from _columns(prefix + name, np.asarray(value))


def _columns(name: str, value: Any) -> Iterator[tuple[str, FloatArray]]:
    if value.dtype.kind not in "iufb" or not value.size:
        return
    if value.ndim <= 1:
        yield name, np.atleast_1d(value).astype(float)
    elif value.ndim == 2:
        for k, column in enumerate(value.T, start=1):
            yield f"{name}(:,{k})", column.astype(float)
