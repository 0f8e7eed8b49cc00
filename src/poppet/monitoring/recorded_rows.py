"""Recordings of a plant as rows of values in SI units: files, recordings and data frames."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.units import convert, exact_scale, with_state
from poppet.identify.fit.fit_circuit import frame_table
from poppet.monitoring.samples import SampleReader
from poppet.monitoring.sensors import Readings
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.recording import Recording
from poppet.timeseries.tables.reading import Table, read_table


class RecordedRows(NamedTuple):
    """Samples of a recording in SI units; NaN for missing values."""

    time: FloatArray  # (n,), as recorded [s]
    values: FloatArray  # (n, n_columns) readings of the sensors, then values of the driven inputs
    notes: tuple[Note, ...] = ()  # on the reading of the file


def read_rows(recording: Any, reader: SampleReader, problems: list[InputError]) -> RecordedRows:
    """Return the samples of a recording.

    Parameters
    ----------
    recording : str, Path, Recording or DataFrame
        Path of a table with the columns of the twin file. The names of a `Recording` or of a data frame can also be
        addresses, with values in SI units or in the units that they state.
    reader : SampleReader
        Columns and units.
    problems : list of InputError
        Messages on invalid values, which are missing in the result. The function adds one per column.

    Raises
    ------
    InputErrors
        If the file cannot be read, a column is missing, or a unit differs from that of the twin file.
    """
    table = _table_of(recording)
    with ErrorCollector() as errors:
        time = _time(errors, table, reader)
        columns = [_column(errors, table, column, reader) for column in reader.columns]
    values = np.column_stack([column if column is not None else np.empty(0) for column in columns])
    assert time is not None  # otherwise an error was raised
    is_timed = np.isfinite(time)
    if not is_timed.all():
        problems.append(InputError("stream.no_time", reader.clock.column, value="nothing"))
        time, values = time[is_timed], values[is_timed]
    for k in range(len(columns)):
        values[:, k] = reader.plausible(k, values[:, k], problems)
    # The layout of the file is evident if its columns are those of the twin file.
    return RecordedRows(time, values, tuple(note for note in table.notes if note.code != "table.guessed"))


def _table_of(recording: Any) -> Table:
    if isinstance(recording, str | Path):
        return read_table(Path(recording))
    if isinstance(recording, Recording):
        names, units = ("time", *recording.names), ("s", *recording.units)
        return Table(names, (recording.time, *recording.values), units, recording.remarks)
    return frame_table(recording, "recording")


def _time(errors: ErrorCollector, table: Table, reader: SampleReader) -> FloatArray | None:
    """Return the times of all rows [s]; collect an error if there is no such column."""
    clock = reader.clock
    # The first column of recordings and data frames is always the time.
    name = clock.column if clock.column in table.names or "time" not in table.names else "time"
    with errors.collecting():
        index = _index(table, name)
        unit = table.units[index] or clock.unit
        if exact_scale(unit) != exact_scale(clock.unit) and name == clock.column:
            raise InputError("stream.other_unit", name, written=unit, unit=clock.unit)
        return np.asarray(convert(table.columns[index], unit, "s"))
    return None


def _column(errors: ErrorCollector, table: Table, column: Readings, reader: SampleReader) -> FloatArray | None:
    """Return the values of one column in SI units; collect an error if there is none."""
    by_column = any(column.column == name for name in table.names)
    name = column.column if by_column or column.address not in table.names else column.address
    with errors.collecting():
        index = _index(table, name)
        values, written = table.columns[index], table.units[index]
        if name == column.address != column.column:
            unit, ambient_pressure = with_state(written or column.si_unit), reader.ambient_pressure
            return np.asarray(convert(values, unit, column.si_unit, ambient_pressure=ambient_pressure), dtype=float)
        if written and exact_scale(with_state(written)) != exact_scale(column.unit):
            raise InputError("stream.other_unit", name, written=written, unit=column.unit)
        return column.scale * values + column.shift
    return None


def _index(table: Table, name: str) -> int:
    try:
        return table.index(name)
    except InputError:
        raise InputError("stream.no_column", name, suggestion=NameSuggestion(name, table.names)) from None


def held_values(columns: FloatArray) -> FloatArray:
    """Return columns, (n, d), in which a missing value is the last one before it, or the first one."""
    filled = columns.copy()
    for column in filled.T:
        is_present = np.isfinite(column)
        if is_present.any():
            last = np.maximum.accumulate(np.where(is_present, np.arange(column.size), -1))
            column[:] = column[np.where(last >= 0, last, int(np.argmax(is_present)))]
    return filled
