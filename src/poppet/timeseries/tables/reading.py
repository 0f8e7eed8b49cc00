"""Selection of the reader by file suffix, and readers of TDMS, MDF, MAT and Parquet files."""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, needed
from poppet.core.files import by_suffix, check_path
from poppet.core.plugins import Registry
from poppet.core.units import LARGEST
from poppet.timeseries.checks import METADATA, FloatArray
from poppet.timeseries.tables import text
from poppet.timeseries.tables.formulas import formulas_of, is_arithmetic
from poppet.timeseries.tables.table import Table, groups_of, seconds, table_of

if TYPE_CHECKING:
    import pyarrow
    from numpy.typing import NDArray

__all__ = ["Table", "read_table", "read_with"]

Found = TypeVar("Found")

_UNIT_PROPERTIES = ("unit_string", "NI_UnitDescription", "Unit", "unit")


def read_tdms(path: Path, *, group: str | int | None = None) -> Table:
    """Read the channels of a TDMS file as columns.

    The keyword `group` is the name or index of a group; by default, all groups are read.
    """
    with needed("npTDMS", "A TDMS file", "measured"):
        from nptdms import TdmsFile
    file = TdmsFile.read(path)
    groups: dict[str, dict[str, FloatArray]] = {}
    units: dict[str, str] = {}
    notes: list[Note] = []
    for channel_group in file.groups():
        columns: dict[str, FloatArray] = {}
        clocks: dict[str, tuple[float, float, int]] = {}
        for channel in channel_group.channels():
            unit = next((str(channel.properties[key]) for key in _UNIT_PROPERTIES if key in channel.properties), "")
            units[channel.name] = units[f"{channel_group.name}/{channel.name}"] = unit
            values: Any = np.asarray(channel[:])
            if not values.size or values.dtype.kind not in "iufbM":
                facts = {"channel": channel.name, "group": channel_group.name}
                notes.append(Note("table.channel_without_numbers", **facts))
                continue
            columns[channel.name] = seconds(values) if values.dtype.kind == "M" else values.astype(float)
            if "wf_increment" in channel.properties:
                # The offset can be absent; time_track() of the package raises an error in this case.
                offset = float(channel.properties.get("wf_start_offset", 0.0))
                clocks[channel.name] = (offset, float(channel.properties["wf_increment"]), values.size)
        # Each waveform has a clock; if all clocks are equal, they are the time of the group.
        is_common = len(set(clocks.values())) == 1 and "time" not in columns
        for name, (offset, increment, count) in clocks.items():
            columns["time" if is_common else f"{name} time"] = np.asarray(
                offset + increment * np.arange(count), dtype=float
            )
        if columns:
            groups[channel_group.name] = columns
    columns_of_file = groups_of(groups, group) if groups else {}
    stamps = {name: "s" for name in columns_of_file if name.rpartition("/")[2].rpartition(" ")[2] == "time"}
    return table_of(columns_of_file, stamps | {name: unit for name, unit in units.items() if unit}, notes)


def read_mdf(path: Path, *, group: str | int | None = None) -> Table:
    """Read the channels of a MDF file as columns.

    The keyword `group` is the name or index of a group; by default, all groups are read.
    """
    with needed("asammdf", "An MDF file", "measured"):
        from asammdf import MDF
    path.open("rb").close()  # gives the usual error for a missing file
    groups: dict[str, dict[str, FloatArray]] = {}
    units: dict[str, str] = {}
    notes: list[Note] = []
    with MDF(path) as file:
        for k in range(len(file.groups)):
            name = str(getattr(file.groups[k].channel_group, "acq_name", "") or "")
            name = name if name and name not in groups else f"group {k}"
            columns: dict[str, FloatArray] = {}
            for channel in file.groups[k].channels:
                for formula in formulas_of(channel.conversion):
                    if not is_arithmetic(formula):
                        raise InputError("table.formula", channel=channel.name, formula=formula)
            # Without the master channel, which is the time.
            indices = [i for i in range(len(file.groups[k].channels)) if i != file.masters_db.get(k)]
            for signal in file.select([(None, k, i) for i in indices]) if indices else ():
                if signal.samples.dtype.kind not in "iufb" or signal.samples.ndim != 1:
                    notes.append(Note("table.channel_without_numbers", channel=signal.name, group=name))
                    continue
                # All channels of a group share its clock.
                columns.setdefault("time", np.asarray(signal.timestamps, dtype=float))
                columns[signal.name] = signal.samples.astype(float)
                units[signal.name] = units[f"{name}/{signal.name}"] = signal.unit or ""
            if columns.get("time", np.empty(0)).size:
                groups[name] = columns
    selected = groups_of(groups, group) if groups else {}
    stamps = {name: "s" for name in selected if name.rpartition("/")[2] == "time"}
    return table_of(selected, units | stamps, notes)


def stored_metadata(metadata: Any) -> dict[str, Any]:
    """Return the metadata that poppet has stored in a file, from its JSON text.

    The result is empty if another program wrote the file.
    """
    try:
        content = json.loads(metadata) if isinstance(metadata, str) else {}
    except ValueError:
        content = {}
    return content if isinstance(content, dict) and "columns" in content and "units" in content else {}


def read_mat(path: Path) -> Table:
    """Read all vectors of a MATLAB file as columns."""
    from scipy.io import loadmat
    from scipy.io.matlab import matfile_version

    with path.open("rb") as stream:
        is_hdf5 = matfile_version(stream)[0] == 2  # format -v7.3, which SciPy cannot read_mat
        content = {} if is_hdf5 else loadmat(stream, squeeze_me=True, simplify_cells=True)
    if is_hdf5:
        with needed("h5py", "A MAT file of version 7.3", "measured"):
            import h5py
        with h5py.File(path, "r") as file:
            content = {name: item for name, item in _hdf5_content(file, h5py.HardLink).items() if name[0] != "#"}
    meta = stored_metadata(content.pop(METADATA, ""))
    columns = dict(_vectors(content))
    if any(values.size > 1 for values in columns.values()):
        # Single numbers in a file with vectors are settings.
        columns = {name: values for name, values in columns.items() if values.size > 1}
    return table_of(columns, {}, meta=meta)


def _hdf5_content(group: Any, hard_link: type) -> dict[str, Any]:
    """Return the content of a group, without links to other files and without data in other files."""
    content: dict[str, Any] = {}
    for name in group:
        if isinstance(group.get(name, getlink=True), hard_link):
            item = group[name]
            content[name] = _hdf5_content(item, hard_link) if hasattr(item, "items") else _hdf5_values(item)
    return content


def _hdf5_values(item: Any) -> NDArray[Any] | None:
    is_text = item.dtype.kind not in "iufb" or item.attrs.get("MATLAB_class", b"") in (b"char", b"cell")
    if is_text or item.external or item.is_virtual:
        return None
    return np.squeeze(np.asarray(item).T)  # MATLAB stores axes in reverse order


def _vectors(content: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, FloatArray]]:
    for name, value in content.items():
        if isinstance(value, Mapping):
            yield from _vectors(value, f"{prefix}{name}.")
        elif isinstance(value, np.ndarray | float | int) and not name.startswith("__"):
            array: Any = np.asarray(value)
            if array.dtype.kind not in "iufb" or not array.size:
                continue
            if array.ndim <= 1:
                yield f"{prefix}{name}", np.atleast_1d(array).astype(float)
            elif array.ndim == 2:
                for k, column in enumerate(array.T, start=1):
                    yield f"{prefix}{name}(:,{k})", column.astype(float)


def arrow() -> ModuleType:
    """Import pyarrow with its Parquet functions, and return the package."""
    with needed("pyarrow", "A Parquet file", "data"):
        import pyarrow
        import pyarrow.parquet
    package: ModuleType = pyarrow
    return package


def table_in(path: Path, columns: list[str] | None = None) -> pyarrow.Table:
    """Return the content of a Parquet file as a pyarrow table.

    `columns` selects columns; by default, the result contains all columns.
    """
    package = arrow()
    path.open("rb").close()  # gives the usual error for a missing file
    # Arrow must open the file itself: its threads would call a Python stream, and a thread that still runs at the end
    # of the interpreter aborts the process.
    with package.OSFile(str(path)) as source:
        return package.parquet.ParquetFile(source).read(columns)


def read_parquet(path: Path) -> Table:
    """Read the numeric columns of a Parquet file."""
    content = table_in(path)
    meta = stored_metadata((content.schema.metadata or {}).get(METADATA.encode(), b"").decode())
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


# Selection of the reader ------------------------------------------------------------------------------------------

READERS: Registry[Callable[..., Table]] = Registry(
    "poppet.readers",
    {
        **dict.fromkeys((".csv", ".txt", ".tsv", ".dat", ".asc", ".lvm", ".log"), text.read),
        ".tdms": read_tdms,
        **dict.fromkeys((".mf4", ".mdf"), read_mdf),
        ".mat": read_mat,
        ".parquet": read_parquet,
    },
    lambda suffix, reader: callable(reader),
    prefix=".",
)
"""Mapping from file suffix to reader. The arguments of a reader are a path and the options of its format."""


def read_table(
    path: Path, *, separator: str | None = None, decimal: str | None = None, header_rows: int | None = None,
    group: str | int | None = None,
) -> Table:  # fmt: skip
    r"""Read the columns of a measured file, in the format of the file suffix.

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
    check_path(path)
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
    """Call the function `reader` with a path, and add the file name to each error."""
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
