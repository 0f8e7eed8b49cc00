"""Files of recordings: CSV for exchange, Parquet for large data, MAT for MATLAB.

The modules in `timeseries/tables` read the three formats as tables. This module converts these tables to recordings.
"""

from __future__ import annotations

import itertools
import json
import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

import numpy as np

from poppet.core.codes import Note, notes_of
from poppet.core.csv_cells import csv_text
from poppet.core.errors import InputError, NameSuggestion, raise_errors
from poppet.core.files import by_suffix, check_path, write_whole
from poppet.core.units import convert
from poppet.timeseries.checks import METADATA, first_bad_time, name_problems, split_heading
from poppet.timeseries.columns import Columns

if TYPE_CHECKING:
    from poppet.timeseries.tables.table import Table


def write(recording: Columns, path: Path) -> Path:
    """Write a recording to a file, whose suffix determines the format.

    The file is replaced completely or not at all, so a failure leaves no incomplete file.
    """
    writer = by_suffix(path, {".csv": _write_csv, ".parquet": _write_parquet, ".mat": _write_mat})
    if not recording.time.size:  # the run failed at its start; no reader accepts an empty file
        raise InputError("files.no_rows", path=str(path))
    return write_whole(path, lambda stream: writer(recording, stream))


def read(path: Path, *, time: str = "time", time_unit: str = "") -> Columns:
    """Read a recording from a file, whose suffix determines the format.

    The keywords apply only to CSV files: `time` is the name of the time column, and `time_unit` the unit of the time.
    """
    # Imported here: writing a file does not need the readers.
    from poppet.timeseries.tables.reading import read_mat, read_parquet, read_with
    from poppet.timeseries.tables.text import read_exact

    readers: dict[str, Callable[[Path], Table]] = {".csv": read_exact, ".parquet": read_parquet, ".mat": read_mat}
    check_path(path)
    reader = by_suffix(path, readers)
    if reader is not read_exact and (time, time_unit) != ("time", ""):
        raise InputError("files.time_is_fixed", path=str(path))

    def recording(path: Path) -> Columns:
        is_csv = reader is read_exact
        table = reader(path)
        return (
            _recording_from_headings(table, path.stem, time, time_unit)
            if is_csv
            else _recording_from_metadata(table, path.suffix)
        )

    return read_with(recording, path)


def _recording_from_headings(table: Table, title: str, time_name: str, time_unit: str) -> Columns:
    """Convert a CSV table, whose headings contain names and units, to a recording.

    `title` is the title of the recording. `time_name` and `time_unit` are the name and the unit of the time column.
    """
    try:
        names, units = zip(*map(split_heading, table.names), strict=True)
        if names.count(time_name) != 1:
            absent = "series.no_time" if time_name == "time" else "series.no_column"
            code = "series.two_times" if time_name in names else absent
            raise InputError(code, column=time_name, suggestion=NameSuggestion(time_name, names))
        raise_errors(name_problems(names, {}))
        time_index = names.index(time_name)
        unit = time_unit or units[time_index]
        convert(0.0, unit or "s", "s")  # rejects a unit that is not a time
    except InputError as problem:
        raise problem.located(line=1) from None
    time = convert(table.columns[time_index], unit or "s", "s")
    invalid = first_bad_time(time)
    if invalid:
        raise invalid[1].located(line=table.lines[invalid[0]])
    columns = {heading: table.columns[k] for k, heading in enumerate(table.names) if k != time_index}
    notes = () if unit else (Note("series.time_without_unit"),)
    return Columns.from_series(time, columns, title=title, notes=notes)


def _recording_from_metadata(table: Table, suffix: str) -> Columns:
    """Convert a Parquet or MAT table that `write` has written to a recording.

    The metadata in the file contains title, notes, names and units.
    """
    meta = table.meta
    if not meta:
        raise InputError("series.foreign", suffix=suffix)
    columns = dict(zip(table.names, table.columns, strict=True))
    # A series with the name `time` is stored under the name of its variable.
    series = {name: columns[variable if name == "time" else name] for variable, name in meta["columns"].items()}
    checked = Columns.from_series(columns["time"], series, units=meta["units"])
    # Other programs read the texts; this function restores the notes from their codes.
    metadata = {
        "title": meta["title"],
        "notes": notes_of(meta.get("remarks", meta["notes"])),
        "outcome": next(iter(notes_of([meta["ending"]])), "") if meta.get("ending") else meta["outcome"],
        "statistics": meta["statistics"],
        "ambient_pressure": meta["ambient_pressure"],
        "inner": frozenset(meta.get("inner", ())),
    }
    return Columns(**(checked.fields() | metadata))


def _metadata_text(recording: Columns, columns: Sequence[str]) -> str:
    """Return the metadata of a recording as JSON text: title, notes, names and units.

    `columns` are the names of the columns in the file, in the order of the series.
    """
    return json.dumps(
        {
            "columns": dict(zip(columns, recording.names, strict=True)),
            "units": dict(zip(recording.names, recording.units, strict=True)),
            "title": recording.title,
            "notes": list(recording.notes),
            "outcome": recording.outcome,
            "remarks": [note.plain() for note in recording.remarks],
            "ending": recording.ending.plain() if recording.ending else "",
            "statistics": {name: float(value) for name, value in recording.statistics.items()},
            "ambient_pressure": float(recording.ambient_pressure),
            "inner": [name for name in recording.names if name in recording.inner],
        },
        ensure_ascii=False,
    )


def _write_csv(recording: Columns, stream: IO[bytes]) -> None:
    if "time" in recording:  # a reader would find two time columns
        raise InputError("series.two_times", column="time")
    series = zip(recording.names, recording.units, strict=True)
    headings = (f"{name} [{unit}]" if unit else name for name, unit in series)
    head = csv_text([["time [s]", *headings]])
    # One format per row is the fastest exact method in pure Python.
    line = ",".join(["%.17g"] * (len(recording) + 1)) + "\n"
    rows = np.vstack((recording.time, recording.values)).T.tolist()
    stream.write((head + "".join([line % tuple(row) for row in rows])).encode())


def _write_parquet(recording: Columns, stream: IO[bytes]) -> None:
    from poppet.timeseries.tables.reading import arrow

    pa = arrow()
    variables = _unique_column_names(recording.names)
    headings = [("time", "s"), *zip(variables, recording.units, strict=True)]
    fields = [pa.field(name, pa.float64(), metadata={"unit": unit}) for name, unit in headings]
    schema = pa.schema(fields, metadata={METADATA: _metadata_text(recording, variables)})
    columns = [pa.array(row) for row in (recording.time, *recording.values)]
    pa.parquet.write_table(pa.Table.from_arrays(columns, schema=schema), stream)


def _write_mat(recording: Columns, stream: IO[bytes]) -> None:
    from scipy.io import savemat

    # Names for MATLAB have letters, digits and underscores, and at most 63 characters: 58 leave space for a counter.
    stems = (re.sub(r"\W", "_", name.replace(".", "__"), flags=re.ASCII) for name in recording.names)
    variables = _unique_column_names((stem if stem[:1].isalpha() else f"x{stem}")[:58] for stem in stems)
    content: dict[str, Any] = {"time": recording.time, METADATA: _metadata_text(recording, variables)}
    content.update(zip(variables, recording.values, strict=True))
    savemat(stream, content, oned_as="column")


def _unique_column_names(names: Iterable[str]) -> list[str]:
    """Make column names unique, and different from `time`.

    A number is added to a repeated name.
    """
    plain_names = list(names)
    assigned = ["time", METADATA]
    for name in plain_names:
        # A counter is added if the name is in use or is the plain name of another column.
        counted = (f"{name}_{count}" for count in itertools.count(2))
        free = (candidate for candidate in counted if candidate not in assigned and candidate not in plain_names)
        assigned.append(name if name not in assigned else next(free))
    return assigned[2:]
