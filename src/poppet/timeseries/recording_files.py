"""Recordings in files: CSV for everyone, Parquet for size and types, MAT for MATLAB.

How the three formats are read as tables stands in `timeseries/tables`; here is what makes a recording of a table.
"""

from __future__ import annotations

import csv
import io
import itertools
import json
import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

import numpy as np

from poppet.core.codes import Note, notes_of
from poppet.core.errors import InputError, NameSuggestion, collect
from poppet.core.files import by_suffix, write_whole
from poppet.core.units import convert
from poppet.timeseries.checks import METADATA, first_bad_time, name_problems, split_heading
from poppet.timeseries.columns import Columns

if TYPE_CHECKING:
    from poppet.timeseries.tables.table import Table


def write(recording: Columns, path: Path) -> Path:
    """Write a recording aside and put it in place as a whole."""
    writer = by_suffix(path, {".csv": _write_csv, ".parquet": _write_parquet, ".mat": _write_mat})
    if not recording.time.size:  # of a run that failed at once; nobody could read it
        raise InputError("files.no_rows", path=str(path))
    return write_whole(path, lambda stream: writer(recording, stream))


def read(path: Path, *, time: str = "time", time_unit: str = "") -> Columns:
    """Read a recording; of a CSV file, `time` names the column of times and `time_unit` its unit."""
    # Not at the top: a run that writes a file need not know how to read one.
    from poppet.timeseries.tables import mat, parquet, text
    from poppet.timeseries.tables.reading import read_with

    readers: dict[str, Callable[[Path], Table]] = {
        ".csv": text.read_exact,
        ".parquet": parquet.read,
        ".mat": mat.read,
    }
    reader = by_suffix(path, readers)
    if reader is not text.read_exact and (time, time_unit) != ("time", ""):
        raise InputError("files.time_is_fixed", path=str(path))

    def recording(path: Path) -> Columns:
        table = reader(path)
        if reader is text.read_exact:
            return _of_headings(table, path.stem, time, time_unit)
        return _of_metadata(table, path.suffix)

    return read_with(recording, path)


def _of_headings(table: Table, title: str, time_name: str, time_unit: str) -> Columns:
    """A recording whose names and units stand in the headings of its columns."""
    try:
        names, units = zip(*map(split_heading, table.names), strict=True)
        if names.count(time_name) != 1:
            absent = "series.no_time" if time_name == "time" else "series.no_column"
            code = "series.two_times" if time_name in names else absent
            raise InputError(code, column=time_name, near=NameSuggestion(time_name, names))
        collect(name_problems(names, {}))
        at = names.index(time_name)
        unit = time_unit or units[at]
        convert(0.0, unit or "s", "s")  # refuses a unit of anything else
    except InputError as problem:
        raise problem.located(line=1) from None
    time = convert(table.columns[at], unit or "s", "s")
    bad = first_bad_time(time)
    if bad:
        raise bad[1].located(line=table.lines[bad[0]])
    columns = {heading: table.columns[k] for k, heading in enumerate(table.names) if k != at}
    notes = () if unit else (Note("series.time_without_unit"),)
    return Columns.from_series(time, columns, title=title, notes=notes)


def _of_metadata(table: Table, suffix: str) -> Columns:
    """A recording that was written with what stands beside its numbers."""
    meta = table.meta
    if not meta:
        raise InputError("series.foreign", suffix=suffix)
    columns = dict(zip(table.names, table.columns, strict=True))
    # A series may have the name of the time; it then stands under that of its variable.
    given = {name: columns[variable if name == "time" else name] for variable, name in meta["columns"].items()}
    checked = Columns.from_series(columns["time"], given, units=meta["units"])
    # The sentences are for other readers; the codes behind them are what comes back.
    known = {
        "title": meta["title"],
        "notes": notes_of(meta.get("remarks", meta["notes"])),
        "outcome": next(iter(notes_of([meta["ending"]])), "") if meta.get("ending") else meta["outcome"],
        "statistics": meta["statistics"],
        "ambient_pressure": meta["ambient_pressure"],
        "inner": frozenset(meta.get("inner", ())),
    }
    return Columns(**(checked.fields() | known))


def _metadata(recording: Columns, columns: Sequence[str]) -> str:
    """What a table of numbers cannot hold, as JSON; `columns` are the names of the series in the file."""
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
    if "time" in recording:  # it would be read as a second time
        raise InputError("series.two_times", column="time")
    head = io.StringIO()
    series = zip(recording.names, recording.units, strict=True)
    headings = (f"{name} [{unit}]" if unit else name for name, unit in series)
    csv.writer(head, lineterminator="\n").writerow(["time [s]", *headings])
    # One format per row: the fastest way in Python itself, and a digit-exact one.
    line = ",".join(["%.17g"] * (len(recording) + 1)) + "\n"
    rows = np.vstack((recording.time, recording.values)).T.tolist()
    stream.write((head.getvalue() + "".join([line % tuple(row) for row in rows])).encode())


def _write_parquet(recording: Columns, stream: IO[bytes]) -> None:
    from poppet.timeseries.tables.parquet import arrow

    pa = arrow()
    variables = _apart(recording.names)
    headings = [("time", "s"), *zip(variables, recording.units, strict=True)]
    fields = [pa.field(name, pa.float64(), metadata={"unit": unit}) for name, unit in headings]
    schema = pa.schema(fields, metadata={METADATA: _metadata(recording, variables)})
    columns = [pa.array(row) for row in (recording.time, *recording.values)]
    pa.parquet.write_table(pa.Table.from_arrays(columns, schema=schema), stream)


def _write_mat(recording: Columns, stream: IO[bytes]) -> None:
    from scipy.io import savemat

    variables = _matlab_names(recording.names)
    content: dict[str, Any] = {"time": recording.time, METADATA: _metadata(recording, variables)}
    content.update(zip(variables, recording.values, strict=True))
    savemat(stream, content, oned_as="column")


def _matlab_names(names: Sequence[str]) -> list[str]:
    """Names MATLAB accepts: letters, digits and underscores, at most 63, each once; a dot becomes two."""
    # At most 58, so that there is room for a count.
    stems = (re.sub(r"\W", "_", name.replace(".", "__"), flags=re.ASCII) for name in names)
    return _apart((stem if stem[:1].isalpha() else f"x{stem}")[:58] for stem in stems)


def _apart(names: Iterable[str]) -> list[str]:
    """Names for the columns beside the time, each once."""
    given = list(names)
    taken = ["time", METADATA]
    for name in given:
        # With a count where it is taken, or would be by another that has no need of one.
        counted = (f"{name}_{count}" for count in itertools.count(2))
        free = (each for each in counted if each not in taken and each not in given)
        taken.append(name if name not in taken else next(free))
    return taken[2:]
