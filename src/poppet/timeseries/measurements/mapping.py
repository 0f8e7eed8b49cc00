"""Reader of the `[recordings.NAME]` table, which assigns file columns to signals of a circuit."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, UnitError, raise_errors
from poppet.core.tables import Field, missing_field, read_fields
from poppet.core.units import Kind, check_unit, convert, same_dimension, sizes_of, with_state
from poppet.timeseries.checks import FloatArray, split_heading
from poppet.timeseries.measurements.measurement import (
    LEAST_SAMPLES,
    Channel,
    ColumnSamples,
    InputChannel,
    Measurement,
    cut_window,
    ordered,
    quantum_of,
)
from poppet.timeseries.measurements.verdicts import heading_verdicts, verdicts
from poppet.timeseries.recording import Recording
from poppet.timeseries.tables.reading import Table, read_table
from poppet.timeseries.tables.time_stamps import is_serial

_OPTIONS = {
    "separator": Field(type="string"),
    "decimal": Field(type="string", meaning="decimal sign"),
    "header_rows": Field(type="integer", low=0, meaning="number of header rows"),
    "group": Field(type="name", meaning="group of channels"),
}
_OF_FILE = {"file": Field(meaning="table of the recording", example='file = "bench.csv"'), "time": Field(), **_OPTIONS}
_SECONDS = Field(unit="s", low=0.0)
_FIELDS = _OF_FILE | {
    "skip": _SECONDS,
    "until": _SECONDS,
    "ambient_pressure": Field(unit="Pa", kind="pressure", above=0.0, meaning="absolute ambient pressure"),
    "inputs": Field(type="table"),
    "start": Field(type="table"),
}
_OF_TIME = {"column": Field(type="name", default="time"), "unit": Field()}
_OF_COLUMN = _OF_FILE | {
    "column": Field(type="name", is_required=True, meaning="column of the values", example='column = "p"'),
    "unit": Field(),
    "lag": Field(unit="s", low=0.0, choices=("free",)),
}
_OF_CHANNEL = _OF_COLUMN | {"noise": Field(), "offset": Field()}
_OF_INPUT = _OF_COLUMN | {
    "delay": Field(unit="s", choices=("free",)),
    "hold": Field(type="boolean", default=False),
    "before": Field(type="number", meaning="value before the first sample"),
}
_INSTANT = 1e-6  # end of the value `before`, ahead of the first sample [s]

# Units of circuit outputs. A signal with an unspecific name has the unit of its dimension.
_SI = ("Pa", "K", "kg/s", "m^3/s", "m", "m/s", "N", "V", "A", "W", "kg", "m^3", "s", "Hz", "rad", "rad/s", "1")
_SI_BY_ENDING = {
    "pressure": "Pa",
    "temperature": "K",
    "mass_flow_rate": "kg/s",
    "heat_flow_rate": "W",
    "stroke": "m",
    "velocity": "m/s",
    "force": "N",
}
DIFFERENCE_KINDS: dict[str, Kind] = {"Pa": "pressure_difference", "K": "temperature_difference", "kg/s": "mass_flow"}
_T = TypeVar("_T")


def read_measurement(
    name: str, table: Mapping[str, Any], folder: Path, *, ambient_pressure: float, other_fields: Sequence[str] = (),
    source: Table | None = None,
) -> Measurement:  # fmt: skip
    """Read one table `[recordings.NAME]` and the data files that it names.

    The keyword `other_fields` contains names that an error message can suggest for a misspelt field. The keyword
    `source` is a data file that has already been read. It contains the columns of channels and inputs without a field
    `file`.

    Notes
    -----
    A channel or input can have its own `file` and `time`. All files of a recording share one clock.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     text = "t_ms,p\\n" + "".join(f"{10 * k},{6.0 - 0.1 * k}\\n" for k in range(20))
    ...     _ = (Path(folder) / "bench.csv").write_text(text)
    ...     table = {"file": "bench.csv", "time": {"column": "t_ms", "unit": "ms"}, "skip": "20 ms"}
    ...     table["tank.pressure"] = {"column": "p", "unit": "bar g", "noise": "2 kPa"}
    ...     read = read_measurement("emptying", table, Path(folder), ambient_pressure=1e5)
    >>> read.duration, float(read.channels[0].values[0]), read.channels[0].noise
    (0.17, 680000.0, 2000.0)
    """
    if not isinstance(table, Mapping):
        raise InputError("fields.no_table", f"recordings.{name}", value=table)
    reader = _MeasurementReader(table, folder, f"recordings.{name}", source, other_fields, ambient_pressure)
    return reader.measurement(name)


@dataclass(frozen=True)
class _MappedColumn:
    """Column of a data file, and the channel or input of the model to which it belongs.

    `delay` or `lag` is None if it is a free parameter of a fit.
    """

    address: str
    location: str
    unit: str
    written: str
    samples: ColumnSamples
    fields: Mapping[str, Any]
    delay: float | None
    lag: float | None

    @property
    def is_gauge(self) -> bool:
        return self.unit == "Pa" and convert(0.0, self.written, "Pa", ambient_pressure=1.0) != 0.0


class _MeasurementReader:
    """Reader of one table `[recordings.NAME]`, whose address is `location`.

    It continues after an error, and raises all errors together at the end.
    """

    def __init__(
        self, table: Mapping[str, Any], folder: Path, location: str, source: Table | None,
        other_fields: Sequence[str] = (), ambient_pressure: float = 1e5,
    ) -> None:  # fmt: skip
        self.table, self.folder, self.location, self.source = table, folder, location, source
        self.errors = ErrorCollector()
        self.notes: dict[Note, None] = {}
        self.findings: dict[Note, None] = {}
        self.files: dict[str, Table | None] = {}
        valid = _FIELDS | dict.fromkeys(other_fields, Field())
        fields = {key: value for key, value in table.items() if "." not in key}
        if len(fields) == len(table):
            self.errors.add("measured.no_channel", location)
        for key in [key for key, value in fields.items() if key not in valid and isinstance(value, Mapping)]:
            # TOML reads tank.pressure without quotes as a table.
            self.errors.add("measured.unquoted", f"{location}.{key}", key=key)
            del fields[key]
        # A gauge value of the ambient pressure has no reference: NaN is outside its limits.
        self.fields = read_fields(self.errors, fields, valid, location, table="recording", ambient_pressure=math.nan)
        self.ambient: float = self.fields.get("ambient_pressure", ambient_pressure)

    def measurement(self, name: str) -> Measurement:
        # The first and last used times, relative to the first sample.
        skip, end = self.fields.get("skip", 0.0), self.fields.get("until", math.inf)
        if end <= skip:
            self.errors.add("measured.until_before_skip", f"{self.location}.until", value=self.table["until"])
        channels = self._columns(self.table, _OF_CHANNEL, self.location)
        inputs = self._columns(self.fields.get("inputs", {}), _OF_INPUT, f"{self.location}.inputs")
        start = dict(self.fields.get("start", {}))
        for address, value in start.items():
            location = f"{self.location}.start.{address}"
            measured = address.replace(".initial_", ".")
            if isinstance(value, bool) or not isinstance(value, str | int | float):
                self.errors.add("measured.no_start", location, value=value)
            elif value == "first" and measured == address:
                self.errors.add("measured.first_of_none", location)
            elif value == "first" and measured not in self.table:
                self.errors.add("measured.no_first_sample", location, channel=measured)
        self._reject_all()
        origin, samples = cut_window([column.samples for column in channels], skip, end)
        read, driving = [], []
        for column, shifted in zip(channels, samples, strict=True):
            time, values = shifted.time, shifted.values
            if time.size < LEAST_SAMPLES:
                self.errors.add("measured.few_samples", column.location, samples=time.size, least=LEAST_SAMPLES)
            self._check_plausibility(column, time, values)
            noise, (mean, offset) = self._deviation(column, "noise"), self._offset(column)
            quantum = quantum_of(values)
            read.append(Channel(column.address, time, values, column.unit, noise, column.lag, quantum, offset, mean))
        for column in inputs:
            time, values, fields = column.samples.time - origin, column.samples.values, column.fields
            if "before" in fields:
                # In the unit of the column.
                first = convert(float(fields["before"]), column.written, column.unit, ambient_pressure=self.ambient)
                time, values = np.append(time[0] - _INSTANT, time), np.append(first, values)
            self._check_plausibility(column, time, values)
            driving.append(
                InputChannel(column.address, time, values, column.unit, column.delay, column.lag, fields["hold"])
            )
        self._reject_all()
        gauge = frozenset(column.address for column in (*channels, *inputs) if column.is_gauge)
        return Measurement(
            name, tuple(read), tuple(driving), start, self.ambient, tuple(self.notes),
            (*self.findings, *verdicts(read, driving, self.ambient, gauge)),
            max(float(channel.time[-1]) for channel in read),
        )  # fmt: skip

    def recording(self, title: str) -> Recording:
        """Return all channels as one recording.

        Its times are the sample times of all channels together. A value is NaN if the channel has no sample at that
        time.
        """
        columns = self._columns(self.table, _OF_CHANNEL, self.location)
        self._reject_all()
        base = np.unique(np.concatenate([column.samples.time for column in columns]))
        values = np.full((len(columns), base.size), np.nan)
        for row, column in zip(values, columns, strict=True):
            row[np.searchsorted(base, column.samples.time)] = column.samples.values
        return Recording(
            base, tuple(column.address for column in columns), tuple(column.unit for column in columns), values,
            title=title, notes=(*self.findings, *(self.source.notes if self.source else ()), *self.notes),
            ambient_pressure=self.ambient,
        )  # fmt: skip

    def _reject_all(self) -> None:
        # An error of the shared file or time occurs once per channel.
        raise_errors(list({(error.code, error.address): error for error in self.errors.collected}.values()))

    def _attempt(self, location: str, action: Callable[[], _T]) -> _T | None:
        try:
            return action()
        except InputError as error:
            self.errors.extend([error.at(location)])
        return None

    def _columns(self, table: Mapping[str, Any], valid: Mapping[str, Field], location: str) -> list[_MappedColumn]:
        columns = []
        for address, value in table.items():
            if "." in address:
                fields = value if isinstance(value, Mapping) else {"column": value}
                columns.append(self._column(address, fields, valid, f"{location}.{address}"))
            elif table is not self.table:  # in self.table, a name without a dot is a field
                self.errors.add("measured.no_address", f"{location}.{address}")
        return [column for column in columns if column is not None]

    def _column(
        self, address: str, raw: Mapping[str, Any], valid: Mapping[str, Field], location: str
    ) -> _MappedColumn | None:
        # Checked before the file: these errors do not depend on its content.
        fields = read_fields(self.errors, raw, valid, location, table="channel")
        owner = location if any(key in fields for key in _OF_FILE) else self.location
        # The separator of one file does not apply to another; the name of the time column can be common.
        inherited = ("time",) if "file" in fields else _OF_FILE
        of_file = {key: self.fields[key] for key in inherited if key in self.fields} | fields
        table = self._file(of_file, owner)
        if table is None or "column" not in fields:
            return None
        time = self._time(table, of_file.get("time", "time"), f"{owner}.time")
        index = self._column_index(table, fields["column"], f"{location}.column")
        if time is None or index is None:
            return None
        written = str(fields.get("unit") or table.units[index])
        if not written:
            self.errors.add("measured.no_unit", f"{location}.unit", column=table.names[index])
            return None
        spelling, written = written, with_state(written)
        unit = self._attempt(f"{location}.unit", lambda: _si_unit(address, written))
        if unit is None:
            return None
        if spelling != written:
            self.notes[Note("doubt.read_as", address, unit=spelling, read=written)] = None
        values = convert(table.columns[index], written, unit, ambient_pressure=self.ambient)
        samples = self._attempt(location, lambda: ordered(time, values))
        if samples is None:
            return None
        self.notes |= dict.fromkeys(note.within(address) for note in samples.notes)
        self.findings |= dict.fromkeys(heading_verdicts(address, table.names[index], table.units[index], written))
        delay, lag = (None if fields.get(key) == "free" else fields.get(key, 0.0) for key in ("delay", "lag"))
        return _MappedColumn(address, location, unit, written, samples, fields, delay, lag)

    def _file(self, fields: Mapping[str, Any], location: str) -> Table | None:
        name = fields.get("file")
        if name is None and self.source is not None:
            return self.source
        if not isinstance(name, str):
            self.errors.extend([missing_field(f"{location}.file", _OF_FILE["file"])])
            return None
        options = {key: fields[key] for key in _OPTIONS if key in fields}
        key = repr((name, options))
        if key not in self.files:  # each file is read once
            read = self._attempt(f"{location}.file", lambda: read_table(self.folder / name, **options))
            self.files[key] = read
            self.notes |= dict.fromkeys(note.within(name) for note in (read.notes if read else ()))
        return self.files[key]

    def _column_index(self, table: Table, column: str | int, location: str) -> int | None:
        """Return the index of a column in a data file.

        `column` is the name or the index in the field at `location`. If there is no such numeric column, an error is
        collected and the result is None.
        """
        index = self._attempt(location, lambda: table.index(column))
        if index is not None and np.isnan(table.columns[index]).all():
            texts = {n.facts["column"]: n.facts["cell"] for n in table.notes if n.code == "table.column_of_text"}
            cell = texts.get(table.names[index])
            code = "measured.column_of_text" if cell else "measured.empty_column"
            self.errors.add(code, location, value=column, column=table.names[index], cell=cell)
            return None
        return index

    def _time(self, table: Table, value: Any, location: str) -> FloatArray | None:
        """Return the times of all samples of a data file [s].

        `value` is the field `time`, which names the time column, and `location` its address in error messages.
        """
        raw = value if isinstance(value, Mapping) else {"column": value}
        spec = read_fields(self.errors, raw, _OF_TIME, location, table="time column")
        index = self._column_index(table, spec["column"], f"{location}.column") if "column" in spec else None
        if index is None:
            return None
        unit = str(spec.get("unit") or table.units[index])
        if not unit and is_serial(table.columns[index]):
            day = float(table.columns[index][0])
            self.notes[Note("table.serial_days", f"{location}.column", column=table.names[index], first=day)] = None
            # The difference comes first: a float with the days since 1900 has a resolution of 1 us.
            return np.round((table.columns[index] - day) * 86400.0, 6)
        unit = unit or "s"
        stamps = self._attempt(f"{location}.unit", lambda: convert(table.columns[index], unit, "s"))
        if stamps is not None:
            # The caller adds the name of the recording.
            address = location.removeprefix(f"{self.location}.")
            self.findings |= dict.fromkeys(heading_verdicts(address, table.names[index], table.units[index], unit))
        return stamps

    def _check_plausibility(self, column: _MappedColumn, time: FloatArray, values: FloatArray) -> None:
        """Collect an error if samples exceed the plausible range of their quantity.

        Such samples are typing errors or faults of the recorder, and would dominate a fit.
        """
        largest = sizes_of(column.unit)[1]
        slips = np.flatnonzero(np.abs(values) > largest)
        if slips.size:
            facts = {"value": float(values[slips[0]]), "unit": column.unit, "time": float(time[slips[0]])}
            self.errors.add("measured.too_large", column.location, largest=largest, count=int(slips.size), **facts)

    def _deviation(self, column: _MappedColumn, key: str) -> float | None:
        """Return the standard deviation in the field `key` of a channel, in the unit of the channel.

        The result is None if the channel has no such field.
        """
        location, raw = f"{column.location}.{key}", column.fields.get(key)
        if raw is None:
            return None
        field = Field(unit=column.unit, kind=DIFFERENCE_KINDS.get(column.unit, "plain"), above=0.0)
        return self._attempt(location, lambda: float(field.read(raw, location)))

    def _offset(self, column: _MappedColumn) -> tuple[float, float | None]:
        """Return mean and standard deviation of the sensor offset of a channel.

        The standard deviation is None if the channel has no offset. It is infinite if the offset is a free parameter.
        """
        raw, location = column.fields.get("offset"), f"{column.location}.offset"
        if raw == "free":
            return 0.0, math.inf
        if not isinstance(raw, Mapping):
            return 0.0, self._deviation(column, "offset")
        kind = DIFFERENCE_KINDS.get(column.unit, "plain")
        fields = {
            "mean": Field(unit=column.unit, kind=kind, default=0.0, meaning="mean of the offset"),
            "sd": Field(
                unit=column.unit, kind=kind, above=0.0, is_required=True, meaning="standard deviation of the offset",
                example=f'sd = "1 {column.unit}"',
            ),
        }  # fmt: skip
        read = read_fields(self.errors, raw, fields, location, table="offset")
        return read.get("mean", 0.0), read.get("sd")


def read_recording(
    path: str | Path, *, time: str | int | Mapping[str, str] | None = None,
    columns: Mapping[str, str | int | Mapping[str, str]] | None = None, ambient_pressure: str | float = "1 bar",
    title: str | None = None, **options: Any,
) -> Recording:  # fmt: skip
    r"""Read a measured file as a recording in SI units with absolute pressures.

    Parameters
    ----------
    path : str or Path
        Table: `.csv`, `.txt`, `.tsv`, `.dat`, `.asc`, `.lvm`, `.log`, `.tdms`, `.mf4`, `.mdf`, `.mat` or `.parquet`.
    time : str, int or mapping, optional
        Column of the time with its unit, ``"t [ms]"``; its index; or a table with `column` and `unit`. Default: the
        column `time`. A time without a unit is in seconds.
    columns : mapping, optional
        Mapping from address to the column with its unit, ``{"tank.pressure": "p_tank [bar g]"}``, or to a table with
        `column` and `unit`. The default is all columns whose headings are addresses. Without a unit here, the unit in
        the heading of the file is used.
    ambient_pressure : str or float, optional
        Absolute pressure to which gauge values refer [Pa].
    title : str, optional
        Title of the recording (default: name of the file).
    **options
        Options of the file: `separator`, `decimal`, `header_rows` of a text, `group` of a TDMS or MDF file.

    Returns
    -------
    Recording
        Series in SI units. An empty cell is NaN.

    Raises
    ------
    InputErrors
        If the file cannot be read, or a column or a unit is unknown.

    Examples
    --------
    >>> import tempfile
    >>> import poppet
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     text = "t_ms,p\n" + "".join(f"{10 * k},{6.0 - 0.1 * k}\n" for k in range(20))
    ...     _ = (Path(folder) / "bench.csv").write_text(text)
    ...     recording = poppet.read(
    ...         Path(folder) / "bench.csv", time="t_ms [ms]", columns={"tank.pressure": "p [bar g]"}
    ...     )
    >>> float(recording.time[-1]), float(recording["tank.pressure"][0])
    (0.19, 700000.0)
    """
    path = Path(path)
    source = read_table(path, **options)
    if columns is None:
        columns = {name: name for name in source.names if "." in name}
    fields = {address: _column_fields(column, source) for address, column in columns.items()}
    clock = {} if time is None else {"time": _column_fields(time, source)}
    tables = {**clock, **fields, "ambient_pressure": ambient_pressure}
    reader = _MeasurementReader(tables, path.parent, "columns", source)
    return reader.recording(path.stem if title is None else title)


def _column_fields(column: str | int | Mapping[str, str], source: Table) -> Mapping[str, Any]:
    """Return the fields `column` and `unit` of a column specification.

    The text `p [bar g]` means the column `p` with the unit `bar g`, unless a heading in `source` is equal to the
    complete text. A mapping is returned unchanged.
    """
    if not isinstance(column, str) or column in source.names:
        return column if isinstance(column, Mapping) else {"column": column}
    name, unit = split_heading(column)
    return {"column": name, "unit": unit} if unit else {"column": name}


def _si_unit(address: str, written: str) -> str:
    """Return the SI unit to which a channel is converted.

    The unit follows from the ending of the address, for example `.pressure`. If the ending does not determine a unit,
    the SI unit follows from `written`, the unit in the file.
    """
    check_unit(written)
    ending = next((ending for ending in _SI_BY_ENDING if address.endswith(ending)), None)
    if ending is not None:
        convert(1.0, written, _SI_BY_ENDING[ending])
        return _SI_BY_ENDING[ending]
    unit = next((unit for unit in _SI if same_dimension(written, unit)), None)
    if unit is None:
        raise UnitError("measured.no_quantity", unit=written)
    return unit
