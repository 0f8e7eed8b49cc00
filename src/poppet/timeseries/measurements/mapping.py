"""The `[recordings.NAME]` table: which column of which file is which signal of a circuit, in what unit."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, UnitError, collect
from poppet.core.units import Kind, check_unit, convert, quantity, same_dimension, sizes_of, with_state
from poppet.timeseries.checks import FloatArray, split_heading
from poppet.timeseries.measurements.clocks import LEAST_SAMPLES, Samples, from_first, ordered
from poppet.timeseries.measurements.measurement import Channel, InputChannel, Measurement
from poppet.timeseries.measurements.noise import quantum_of
from poppet.timeseries.measurements.verdicts import heading_verdicts, verdicts
from poppet.timeseries.recording import Recording
from poppet.timeseries.tables.reading import Table, read_table

_OF_FILE = ("file", "group", "time", "separator", "header_rows", "decimal")
_FIELDS = (*_OF_FILE, "skip", "until", "ambient_pressure", "inputs", "start")
_OF_CHANNEL = ("column", "unit", "noise", "offset", "lag", *_OF_FILE)
_OF_INPUT = ("column", "unit", "delay", "lag", "hold", "before", *_OF_FILE)
_OPTIONS: dict[str, Any] = {"separator": str, "decimal": str, "header_rows": int, "group": str | int}
_INSTANT = 1e-6  # s before the first sample, where the value `before` ends

# What a circuit records; a signal whose name says nothing takes the one of the dimension of its unit.
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
    name: str,
    table: Mapping[str, Any],
    folder: Path,
    *,
    ambient_pressure: float,
    beside: Sequence[str] = (),
    source: Table | None = None,
) -> Measurement:
    """Read one `[recordings.NAME]` table with the files it names.

    `beside` are fields that stand in the same table and are read elsewhere: what a misspelt one may mean. `source` has
    the columns of channels and inputs without a file.

    Notes
    -----
    A channel or input may name a `file` and a `time` of its own; all files of a recording share one clock.

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
    return _Reader(name, table, folder, beside, source).measurement(ambient_pressure)


@dataclass(frozen=True)
class _Column:
    """A column of a file with what the table says about it; what is free has no delay or lag."""

    address: str
    where: str
    unit: str
    written: str
    samples: Samples
    fields: Mapping[str, Any]
    delay: float | None
    lag: float | None

    @property
    def is_gauge(self) -> bool:
        return self.unit == "Pa" and convert(0.0, self.written, "Pa", ambient_pressure=1.0) != 0.0


class _Reader:
    """Reads one table, and goes on behind a mistake, so that all are told at once."""

    def __init__(
        self, name: str, table: Mapping[str, Any], folder: Path, beside: Sequence[str], source: Table | None = None
    ) -> None:
        self.name, self.table, self.folder, self.beside, self.source = name, table, folder, beside, source
        self.where = f"recordings.{name}"
        self.errors = ErrorCollector()
        self.notes: dict[Note, None] = {}
        self.findings: dict[Note, None] = {}
        self.files: dict[str, Table | None] = {}

    def measurement(self, ambient_pressure: float) -> Measurement:
        self._check_keys()
        self.ambient = self._ambient(ambient_pressure)
        skip, until = self._window()
        channels = self._columns(self.table, _OF_CHANNEL, self.where)
        inputs = self._columns(self._mapping("inputs"), _OF_INPUT, f"{self.where}.inputs")
        start = self._start()
        self._refuse_all()
        origin, samples = from_first([column.samples for column in channels], skip, until)
        read = tuple(self._channel(column, each) for column, each in zip(channels, samples, strict=True))
        driving = tuple(self._input(column, origin) for column in inputs)
        self._refuse_all()
        gauge = frozenset(column.address for column in (*channels, *inputs) if column.is_gauge)
        return Measurement(
            self.name,
            read,
            driving,
            start,
            self.ambient,
            tuple(self.notes),
            (*self.findings, *verdicts(read, driving, self.ambient, gauge)),
            max(float(channel.time[-1]) for channel in read),
        )

    def recording(self, ambient_pressure: str | float, title: str) -> Recording:
        """Return the channels over their common time base; missing samples are NaN."""
        self.where = "columns"
        self._check_keys()
        self.table = {**self.table, "ambient_pressure": ambient_pressure}
        self.ambient = self._ambient(1e5)
        columns = self._columns(self.table, _OF_CHANNEL, self.where)
        self._refuse_all()
        base = np.unique(np.concatenate([column.samples.time for column in columns]))
        values = np.full((len(columns), base.size), np.nan)
        for row, column in zip(values, columns, strict=True):
            row[np.searchsorted(base, column.samples.time)] = column.samples.values
        return Recording(
            base,
            tuple(column.address for column in columns),
            tuple(column.unit for column in columns),
            values,
            title=title,
            notes=(*self.findings, *(self.source.notes if self.source else ()), *self.notes),
            ambient_pressure=self.ambient,
        )

    def _refuse_all(self) -> None:
        # A mistake of the file or the time, which all channels share, is found with each of them.
        collect(list({(each.code, each.address): each for each in self.errors.collected}.values()))

    def _attempt(self, where: str, action: Callable[[], _T]) -> _T | None:
        try:
            return action()
        except InputError as error:
            self.errors.extend([error.at(where)])
        return None

    def _check_keys(self) -> None:
        unknown = [key for key in self.table if "." not in key and key not in _FIELDS]
        for key in unknown:
            where = f"{self.where}.{key}"
            if isinstance(self.table[key], Mapping):  # TOML makes tables of tank.pressure without quotes
                self.errors.add("measured.unquoted", where, key=key)
            else:
                self.errors.add("measured.unknown_field", where, near=NameSuggestion(key, (*_FIELDS, *self.beside)))
        if not any("." in key for key in self.table):
            self.errors.add("measured.no_channel", self.where)

    def _mapping(self, key: str) -> Mapping[str, Any]:
        given = self.table.get(key, {})
        if isinstance(given, Mapping):
            return given
        self.errors.add("measured.no_table", f"{self.where}.{key}", value=given, key=key)
        return {}

    def _ambient(self, default: float) -> float:
        where = f"{self.where}.ambient_pressure"
        given = self.table.get("ambient_pressure", default)
        read = self._attempt(where, lambda: quantity(given, "Pa", kind="pressure", name=where))
        if read is not None and (read.reference == "gauge" or read.value <= 0.0):
            self.errors.add("measured.ambient_pressure", where, value=given)
        return read.value if read is not None else default

    def _seconds(
        self, fields: Mapping[str, Any], key: str, where: str, default: float = 0.0, *, signed: bool = False
    ) -> float:
        if key not in fields:
            return default
        where = f"{where}.{key}"
        read = self._attempt(where, lambda: quantity(fields[key], "s", name=where))
        if read is not None and read.value < 0.0 and not signed:
            self.errors.add("measured.negative_time", where, value=fields[key])
        return read.value if read is not None else default

    def _window(self) -> tuple[float, float]:
        """First and last time that are used, from the first sample on [s]."""
        skip = self._seconds(self.table, "skip", self.where)
        until = self._seconds(self.table, "until", self.where, math.inf)
        if until <= skip:
            self.errors.add("measured.until_before_skip", f"{self.where}.until", value=self.table["until"])
        return skip, until

    def _start(self) -> dict[str, str | float]:
        start = dict(self._mapping("start"))
        for address, given in start.items():
            where = f"{self.where}.start.{address}"
            measured = address.replace(".initial_", ".")
            if isinstance(given, bool) or not isinstance(given, str | int | float):
                self.errors.add("measured.no_start", where, value=given)
            elif given == "first" and measured == address:
                self.errors.add("measured.first_of_none", where)
            elif given == "first" and measured not in self.table:
                self.errors.add("measured.no_first_sample", where, channel=measured)
        return start

    def _columns(self, table: Mapping[str, Any], known: tuple[str, ...], where: str) -> list[_Column]:
        found = []
        for address, given in table.items():
            if "." in address:
                fields = given if isinstance(given, Mapping) else {"column": given}
                found.append(self._column(address, fields, known, f"{where}.{address}"))
            elif table is not self.table:  # where a name without a point is a field
                self.errors.add("measured.no_address", f"{where}.{address}")
        return [column for column in found if column is not None]

    def _column(self, address: str, fields: Mapping[str, Any], known: tuple[str, ...], where: str) -> _Column | None:
        for key in (each for each in fields if each not in known):
            self.errors.add("measured.no_field", f"{where}.{key}", near=NameSuggestion(key, known))
        # Before the file is looked at: these are of no use whatever it holds.
        lag = None if fields.get("lag") == "free" else self._seconds(fields, "lag", where)
        is_free = "delay" not in known or fields.get("delay") == "free"
        delay = None if is_free else self._seconds(fields, "delay", where, signed=True)
        owner = where if any(key in fields for key in _OF_FILE) else self.where
        # What separates the columns of one file says nothing about another; the clock's name may be the same.
        inherited = ("time",) if "file" in fields else _OF_FILE
        of_file = {key: self.table[key] for key in inherited if key in self.table} | dict(fields)
        table = self._file(of_file, owner)
        if "column" not in fields:
            self.errors.add("measured.no_column", f"{where}.column")
        if table is None or "column" not in fields:
            return None
        time = self._time(table, of_file.get("time", "time"), f"{owner}.time")
        place = self._named(table, fields["column"], f"{where}.column")
        if time is None or place is None:
            return None
        written = str(fields.get("unit") or table.units[place])
        if not written:
            self.errors.add("measured.no_unit", f"{where}.unit", column=table.names[place])
            return None
        given, written = written, with_state(written)
        unit = self._attempt(f"{where}.unit", lambda: _si_unit(address, written))
        if unit is None:
            return None
        if given != written:
            self.notes[Note("doubt.read_as", address, unit=given, read=written)] = None
        values = convert(table.columns[place], written, unit, ambient_pressure=self.ambient)
        samples = self._attempt(where, lambda: ordered(time, values))
        if samples is None:
            return None
        self.notes |= dict.fromkeys(note.within(address) for note in samples.notes)
        self.findings |= dict.fromkeys(heading_verdicts(address, table.names[place], table.units[place], written))
        return _Column(address, where, unit, written, samples, fields, delay, lag)

    def _file(self, fields: Mapping[str, Any], where: str) -> Table | None:
        name = fields.get("file")
        if name is None and self.source is not None:
            return self.source
        if not isinstance(name, str):
            self.errors.add("measured.no_file", f"{where}.file")
            return None
        options = {key: fields[key] for key in _OPTIONS if key in fields}
        for option, value in options.items():
            if isinstance(value, bool) or not isinstance(value, _OPTIONS[option]):
                self.errors.add("measured.option", f"{where}.{option}", value=value, option=option)
                return None
        key = repr((name, options))
        if key not in self.files:  # all columns of a file are read in one go
            read = self._attempt(f"{where}.file", lambda: read_table(self.folder / name, **options))
            self.files[key] = read
            self.notes |= dict.fromkeys(note.within(name) for note in (read.notes if read else ()))
        return self.files[key]

    def _named(self, table: Table, wanted: Any, where: str) -> int | None:
        """Where a column stands that holds numbers."""
        if isinstance(wanted, bool) or not isinstance(wanted, str | int):
            self.errors.add("measured.column", where, value=wanted)
            return None
        place = self._attempt(where, lambda: table.index(wanted))
        if place is not None and np.isnan(table.columns[place]).all():
            texts = {n.facts["column"]: n.facts["cell"] for n in table.notes if n.code == "table.column_of_text"}
            cell = texts.get(table.names[place])
            code = "measured.column_of_text" if cell else "measured.empty_column"
            self.errors.add(code, where, value=wanted, column=table.names[place], cell=cell)
            return None
        return place

    def _time(self, table: Table, given: Any, where: str) -> Any:
        """The time of a table's samples [s]."""
        spec = given if isinstance(given, Mapping) else {"column": given}
        for key in (each for each in spec if each not in ("column", "unit")):
            self.errors.add("measured.no_field", f"{where}.{key}", near=NameSuggestion(key, ("column", "unit")))
        place = self._named(table, spec.get("column", "time"), f"{where}.column")
        if place is None:
            return None
        unit = str(spec.get("unit") or table.units[place] or "s")
        stamps = self._attempt(f"{where}.unit", lambda: convert(table.columns[place], unit, "s"))
        if stamps is not None:
            # Whoever has several recordings puts the name of this one before what was found in it.
            address = where.removeprefix(f"{self.where}.")
            self.findings |= dict.fromkeys(heading_verdicts(address, table.names[place], table.units[place], unit))
        return stamps

    def _channel(self, column: _Column, samples: Samples) -> Channel:
        count = samples.time.size
        if count < LEAST_SAMPLES:
            self.errors.add("measured.few_samples", column.where, samples=count, least=LEAST_SAMPLES)
        self._refuse_slips(column, samples.time, samples.values)
        noise, offset = self._deviation(column, "noise"), self._deviation(column, "offset")
        quantum = quantum_of(samples.values)
        return Channel(column.address, samples.time, samples.values, column.unit, noise, column.lag, quantum, offset)

    def _refuse_slips(self, column: _Column, time: FloatArray, values: FloatArray) -> None:
        """What no bench holds is a slip of a hand or a recorder, and would weigh more than all the rest."""
        largest = sizes_of(column.unit)[1]
        slips = np.flatnonzero(np.abs(values) > largest)
        if slips.size:
            facts = {"value": float(values[slips[0]]), "unit": column.unit, "time": float(time[slips[0]])}
            self.errors.add("measured.too_large", column.where, largest=largest, count=int(slips.size), **facts)

    def _deviation(self, column: _Column, key: str) -> float | None:
        """One standard deviation of a channel as stated."""
        where, given = f"{column.where}.{key}", column.fields.get(key)
        if given is None:
            return None
        kind = DIFFERENCE_KINDS.get(column.unit, "plain")
        value = self._attempt(where, lambda: quantity(given, column.unit, kind=kind, name=where).value)
        if value is not None and value <= 0.0:
            self.errors.add("measured.noise", where, value=given)
        return value

    def _input(self, column: _Column, origin: float) -> InputChannel:
        time, values, fields = column.samples.time - origin, column.samples.values, column.fields
        hold = fields.get("hold", False)
        if not isinstance(hold, bool):
            self.errors.add("measured.hold", f"{column.where}.hold", value=hold)
        if "before" in fields:
            given = fields["before"]  # a number in the unit of the record
            if isinstance(given, bool) or not isinstance(given, int | float) or not math.isfinite(given):
                self.errors.add("measured.before", f"{column.where}.before", value=given)
                given = math.nan
            first = convert(float(given), column.written, column.unit, ambient_pressure=self.ambient)
            time, values = np.append(time[0] - _INSTANT, time), np.append(first, values)
        self._refuse_slips(column, time, values)
        return InputChannel(column.address, time, values, column.unit, column.delay, column.lag, hold is True)


def read_recording(
    path: str | Path,
    *,
    time: str | int | Mapping[str, Any] | None = None,
    columns: Mapping[str, str | int | Mapping[str, Any]] | None = None,
    ambient_pressure: str | float = "1 bar",
    title: str | None = None,
    **options: Any,
) -> Recording:
    r"""Read a measured file as a recording in SI units, pressures absolute.

    Parameters
    ----------
    path : str or Path
        Table: `.csv`, `.txt`, `.tsv`, `.dat`, `.asc`, `.lvm`, `.log`, `.tdms`, `.mf4`, `.mdf`, `.mat` or `.parquet`.
    time : str, int or mapping, optional
        Column of the time with its unit, ``"t [ms]"``; its index; or a table with `column` and `unit`. Default: the
        column `time`. A time without a unit is in seconds.
    columns : mapping, optional
        Address to column with its unit, ``{"tank.pressure": "p_tank [bar g]"}``, or to a table with `column` and `unit`.
        The default is all columns whose headings are addresses. A unit in the heading of the file is used if none is
        given here.
    ambient_pressure : str or float, optional
        Absolute pressure to which gauge values refer [Pa].
    title : str, optional
        Title of the recording; default the name of the file.
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
    reader = _Reader("columns", {**clock, **fields}, path.parent, (), source)
    return reader.recording(ambient_pressure, path.stem if title is None else title)


def _column_fields(column: str | int | Mapping[str, Any], source: Table) -> Mapping[str, Any]:
    """Return the table of a column: `p [bar g]` is the column `p` in gauge pressure."""
    if not isinstance(column, str) or column in source.names:
        return column if isinstance(column, Mapping) else {"column": column}
    name, unit = split_heading(column)
    return {"column": name, "unit": unit} if unit else {"column": name}


def _si_unit(address: str, written: str) -> str:
    """The SI unit of a signal: what its name says, else what its unit says."""
    check_unit(written)
    ending = next((ending for ending in _SI_BY_ENDING if address.endswith(ending)), None)
    if ending is not None:
        convert(1.0, written, _SI_BY_ENDING[ending])
        return _SI_BY_ENDING[ending]
    unit = next((unit for unit in _SI if same_dimension(written, unit)), None)
    if unit is None:
        raise UnitError("measured.no_quantity", unit=written)
    return unit
