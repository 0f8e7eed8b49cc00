"""Recordings in files: CSV for everyone, Parquet for size and types, MAT for MATLAB."""

from __future__ import annotations

import csv
import io
import json
import re
from functools import partial
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

import numpy as np

from poppet.ground.codes import notes_of
from poppet.ground.errors import InputError, MissingDependencyError, collect, suggestion
from poppet.ground.files import by_suffix, write_whole
from poppet.ground.units import convert
from poppet.series.checks import FloatArray, first_bad_time, name_problems, split_heading
from poppet.series.columns import Columns

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

_METADATA = "poppet"  # key in a Parquet schema, variable in a MAT file; holds JSON


def write(recording: Columns, path: Path) -> Path:
    """Write a recording aside and put it in place as a whole."""
    writer = by_suffix(path, {".csv": _write_csv, ".parquet": _write_parquet, ".mat": _write_mat})
    return write_whole(path, lambda stream: writer(recording, stream))


def read(path: Path, *, time: str = "time", time_unit: str = "") -> Columns:
    """Read a recording."""
    from_csv = partial(_read_csv, time_name=time, time_unit=time_unit)
    readers: dict[str, Callable[[Path], Columns]] = {".csv": from_csv, ".parquet": _read_parquet, ".mat": _read_mat}
    reader = by_suffix(path, readers)
    if reader is not from_csv and (time, time_unit) != ("time", ""):
        raise InputError(f"time of {path}", "is fixed by the file.", "Name a time column of CSV files only.")
    try:
        return reader(path)
    except OSError as problem:
        raise InputError("files.unreadable", path=str(path), why=problem.strerror or str(problem)) from problem
    except InputError as problem:
        problem.located(file=str(path))
        raise


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
        },
        ensure_ascii=False,
    )


def _known(metadata: str, format_name: str) -> dict[str, Any]:
    try:
        known: dict[str, Any] = json.loads(metadata or "{}")
    except ValueError:
        known = {}
    if not known:
        raise InputError(
            f"the {format_name} file",
            "was not written as a recording: it names no series and no units.",
            "Build it with Recording.from_series, or save it as CSV with headings like tank.pressure [Pa].",
        )
    return known


def _restored(time: FloatArray, columns: Mapping[str, FloatArray], metadata: Mapping[str, Any]) -> Columns:
    checked = Columns.from_series(time, columns, units=metadata["units"])
    return Columns(
        checked.time,
        checked.names,
        checked.units,
        checked.values,
        title=metadata["title"],
        # The sentences are for other readers; the codes behind them are what comes back.
        notes=notes_of(metadata.get("remarks", metadata["notes"])),
        outcome=next(iter(notes_of([metadata["ending"]])), "") if metadata.get("ending") else metadata["outcome"],
        statistics=metadata["statistics"],
        ambient_pressure=metadata["ambient_pressure"],
    )


# CSV


def _write_csv(recording: Columns, stream: IO[bytes]) -> None:
    head = io.StringIO()
    series = zip(recording.names, recording.units, strict=True)
    csv.writer(head, lineterminator="\n").writerow(["time [s]", *(_heading(*pair) for pair in series)])
    # One format per row: the fastest way in Python itself, and a digit-exact one.
    line = ",".join(["%.17g"] * (len(recording) + 1)) + "\n"
    rows = np.vstack((recording.time, recording.values)).T.tolist()
    stream.write((head.getvalue() + "".join([line % tuple(row) for row in rows])).encode())


def _heading(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit else name


def _read_csv(path: Path, time_name: str, time_unit: str) -> Columns:
    lines = _text_lines(path)
    headings = [cell.strip() for cell in next(csv.reader(lines[:1]), [])]
    try:
        at, unit = _time_column(headings, time_name, time_unit)
    except InputError as problem:
        problem.located(line=1)
        raise
    table = _numbers(lines, headings)
    time = convert(table[:, at], unit or "s", "s")
    bad = first_bad_time(time)
    if bad:
        raise bad[1].located(line=_data_lines(lines)[bad[0]])
    columns = {heading: table[:, i] for i, heading in enumerate(headings) if i != at}
    notes = () if unit else ("The time column names no unit; it was read as seconds.",)
    return Columns.from_series(time, columns, title=path.stem, notes=notes)


def _text_lines(path: Path) -> list[str]:
    content = path.read_bytes()
    if b"\0" in content:
        raise InputError("the file", "is binary.", "Save it as UTF-8 text.")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        line = content.count(b"\n", 0, problem.start) + 1
        raise InputError("the file", "is not UTF-8 text.", "Save it as UTF-8 text.", line=line) from problem
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    if not any(line.strip() for line in lines[1:]):
        reason = "is empty." if not text.strip() else "holds no samples."
        raise InputError("the file", reason, "Give a heading line and one line per time.")
    return lines


def _time_column(headings: list[str], name: str, time_unit: str) -> tuple[int, str]:
    """Where the time stands and in what unit; refuses headings that cannot be told apart."""
    if len(headings) == 1 and ";" in headings[0]:
        raise InputError("the file", "separates its columns by semicolons.", "Use commas.")
    names, units = zip(*map(split_heading, headings), strict=True)
    if names.count(name) != 1:
        found = "names more than one" if name in names else "names no"
        cure = 'Call the one with the time base "time [s]".' if name == "time" else suggestion(name, names)
        raise InputError("the heading line", f'{found} column "{name}".', cure)
    collect(name_problems(names, {}))
    at = names.index(name)
    unit = time_unit or units[at]
    convert(0.0, unit or "s", "s")
    return at, unit


def _numbers(lines: list[str], headings: list[str]) -> FloatArray:
    try:
        table = np.loadtxt(lines[1:], delimiter=",", comments=None, quotechar='"', ndmin=2)
    except ValueError as problem:
        raise _bad_cell(lines, headings) from problem
    if table.shape[1] != len(headings):
        raise _bad_cell(lines, headings)
    return table


def _data_lines(lines: list[str]) -> list[int]:
    """Numbers of the lines that hold samples, counted from 1; blank ones hold none."""
    return [number for number, line in enumerate(lines[1:], start=2) if line.strip()]


def _bad_cell(lines: list[str], headings: list[str]) -> InputError:
    for number in _data_lines(lines):
        cells = next(csv.reader([lines[number - 1]]))
        if len(cells) != len(headings):
            reason = f"do not fit the {len(headings)} columns of the heading line."
            cure = "Give one number per column, with a decimal point."
            return InputError(f"{len(cells)} cells", reason, cure, line=number)
        for heading, cell in zip(headings, cells, strict=True):
            if not _is_number(cell):
                cure = "Write a number with a decimal point, or nan where nothing was measured."
                return InputError(f'cell "{cell}" of column "{heading}"', "is not a number.", cure, line=number)
    return InputError("the file", "is not a table of numbers.", "Give one number per column.")


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return "_" not in cell


# Parquet


def _pyarrow() -> Any:
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError as problem:
        raise MissingDependencyError("pyarrow", "A Parquet file", "data") from problem
    return pyarrow


def _write_parquet(recording: Columns, stream: IO[bytes]) -> None:
    pa = _pyarrow()
    headings = [("time", "s"), *zip(recording.names, recording.units, strict=True)]
    fields = [pa.field(name, pa.float64(), metadata={"unit": unit}) for name, unit in headings]
    schema = pa.schema(fields, metadata={_METADATA: _metadata(recording, recording.names)})
    columns = [pa.array(row) for row in (recording.time, *recording.values)]
    pa.parquet.write_table(pa.Table.from_arrays(columns, schema=schema), stream)


def _read_parquet(path: Path) -> Columns:
    pa = _pyarrow()
    with path.open("rb") as stream:
        try:
            table = pa.parquet.read_table(stream)
        except pa.ArrowInvalid as problem:
            raise InputError("the file", "is not a Parquet file.", "Check what wrote it.") from problem
    metadata = (table.schema.metadata or {}).get(_METADATA.encode(), b"")
    known = _known(metadata.decode(), "Parquet")
    columns = {name: table[column].to_numpy() for column, name in known["columns"].items()}
    return _restored(table["time"].to_numpy(), columns, known)


# MAT


def _write_mat(recording: Columns, stream: IO[bytes]) -> None:
    from scipy.io import savemat

    variables = _matlab_names(recording.names)
    content: dict[str, Any] = {"time": recording.time, _METADATA: _metadata(recording, variables)}
    content.update(zip(variables, recording.values, strict=True))
    savemat(stream, content, oned_as="column")


def _matlab_names(names: Sequence[str]) -> list[str]:
    """Names MATLAB accepts: letters, digits and underscores, at most 63, each once; a dot becomes two."""
    taken = {"time", _METADATA}
    result = []
    for name in names:
        stem = re.sub(r"\W", "_", name.replace(".", "__"), flags=re.ASCII)
        stem = (stem if stem[:1].isalpha() else f"x{stem}")[:58]
        variable, count = stem, 1
        while variable in taken:
            count += 1
            variable = f"{stem}_{count}"
        taken.add(variable)
        result.append(variable)
    return result


def _read_mat(path: Path) -> Columns:
    from scipy.io import loadmat

    with path.open("rb") as stream:
        try:
            content = loadmat(stream, squeeze_me=True)
        except (ValueError, TypeError, NotImplementedError) as problem:
            cure = "Save it from MATLAB with -v7."
            raise InputError("the file", "is not a MAT file of version 4 to 7.2.", cure) from problem
    known = _known(str(content.get(_METADATA, "")), "MAT")
    columns = {name: np.atleast_1d(content[variable]) for variable, name in known["columns"].items()}
    return _restored(np.atleast_1d(content["time"]), columns, known)
