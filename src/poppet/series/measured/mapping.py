"""The `[recordings.NAME]` table: which column of which file is which signal of a circuit, in what unit."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from poppet.ground.codes import Note
from poppet.ground.errors import InputError, Near, UnitError, collect
from poppet.ground.units import Kind, check_unit, convert, quantity, same_dimension
from poppet.series.measured.clocks import LEAST_SAMPLES, Samples, from_first, ordered
from poppet.series.measured.measurement import Channel, InputChannel, Measurement
from poppet.series.measured.noise import quantum_of
from poppet.series.measured.verdicts import heading_verdicts, verdicts
from poppet.series.tables.reading import Table, read_table

_OF_FILE = ("file", "group", "time", "separator", "header_rows", "decimal")
_FIELDS = (*_OF_FILE, "skip", "until", "ambient_pressure", "inputs", "start")
_OF_CHANNEL = ("column", "unit", "noise", "lag", *_OF_FILE)
_OF_INPUT = ("column", "unit", "delay", "lag", "hold", "before", *_OF_FILE)
_INSTANT = 1e-6
"""Time before the first sample at which the value `before` ends [s]."""

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
_DIFFERENCE: dict[str, Kind] = {"Pa": "pressure_difference", "K": "temperature_difference", "kg/s": "mass_flow"}
_T = TypeVar("_T")


def read_measurement(name: str, table: Mapping[str, Any], folder: Path, *, ambient_pressure: float) -> Measurement:
    """Read one `[recordings.NAME]` table with the files it names.

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
    return _Reader(name, table, folder).measurement(ambient_pressure)


@dataclass(frozen=True)
class _Column:
    """A column of a file with what the table says about it."""

    address: str
    where: str
    unit: str
    written: str
    samples: Samples
    fields: Mapping[str, Any]

    @property
    def is_gauge(self) -> bool:
        return self.unit == "Pa" and convert(0.0, self.written, "Pa", ambient_pressure=1.0) != 0.0


class _Reader:
    """Reads one table and keeps its mistakes until all are known."""

    def __init__(self, name: str, table: Mapping[str, Any], folder: Path) -> None:
        self.name, self.table, self.folder = name, table, folder
        self.where = f"recordings.{name}"
        self.problems: list[InputError] = []
        self.notes: dict[Note, None] = {}
        self.findings: list[Note] = []
        self.files: dict[tuple[Any, ...], Table | None] = {}

    def measurement(self, ambient_pressure: float) -> Measurement:
        self._check_keys()
        ambient = self._ambient(ambient_pressure)
        skip, until = self._window()
        channels = self._columns(self.table, _OF_CHANNEL, self.where, ambient)
        inputs = self._columns(self._mapping("inputs"), _OF_INPUT, f"{self.where}.inputs", ambient)
        start = self._start([key for key in self.table if "." in key])
        collect(self.problems)
        origin, samples = from_first([column.samples for column in channels], skip, until)
        read = tuple(
            self._channel(column, each)
            for column, each in zip(channels, samples, strict=True)
            if self._enough(column, each)
        )
        driving = tuple(self._input(column, origin, ambient) for column in inputs)
        collect(self.problems)
        gauge = frozenset(column.address for column in (*channels, *inputs) if column.is_gauge)
        return Measurement(
            self.name,
            read,
            driving,
            start,
            ambient,
            tuple(self.notes),
            (*self.findings, *verdicts(read, driving, ambient, gauge)),
            max(float(channel.time[-1]) for channel in read),
        )

    def _attempt(self, where: str, action: Callable[[], _T]) -> _T | None:
        try:
            return action()
        except InputError as error:
            for problem in error.at(where).problems:
                self._keep(problem)
        return None

    def _refuse(self, code: str, where: str, **facts: Any) -> None:
        self._keep(InputError(code, where, **facts))

    def _keep(self, problem: InputError) -> None:
        """Note a mistake; one of the time, which all channels share, is one mistake."""
        if not any((known.code, known.address) == (problem.code, problem.address) for known in self.problems):
            self.problems.append(problem)

    def _check_keys(self) -> None:
        for key in self.table:
            if "." not in key and key not in _FIELDS:
                where = f"{self.where}.{key}"
                if isinstance(self.table[key], Mapping):
                    self._refuse("measured.unquoted", where, key=key)
                else:
                    self._refuse("measured.unknown_field", where, near=Near(key, _FIELDS))
        if not any("." in key for key in self.table):
            self._refuse("measured.no_channel", self.where)

    def _mapping(self, key: str) -> Mapping[str, Any]:
        given = self.table.get(key, {})
        if isinstance(given, Mapping):
            return given
        self._refuse("measured.no_table", f"{self.where}.{key}", value=given, key=key)
        return {}

    def _ambient(self, default: float) -> float:
        where = f"{self.where}.ambient_pressure"
        given = self.table.get("ambient_pressure", default)
        read = self._attempt(where, lambda: quantity(given, "Pa", kind="pressure", name=where))
        if read is not None and (read.reference == "gauge" or read.value <= 0.0):
            self._refuse("measured.ambient_pressure", where, value=given)
        return read.value if read is not None else default

    def _duration(self, fields: Mapping[str, Any], key: str, where: str, *, signed: bool = False) -> float | None:
        """A time of a table, 0 where it is not given, None where it is `free`."""
        given, where = fields.get(key, 0.0), f"{where}.{key}"
        if given == "free" and key not in ("skip", "until"):
            return None
        read = self._attempt(where, lambda: quantity(given, "s", name=where))
        if read is not None and read.value < 0.0 and not signed:
            self._refuse("measured.negative_time", where, value=given)
        return read.value if read is not None else 0.0

    def _window(self) -> tuple[float, float]:
        """First and last time that are used, from the first sample on [s]."""
        skip = self._duration(self.table, "skip", self.where) or 0.0
        until = self._duration(self.table, "until", self.where) if "until" in self.table else math.inf
        until = math.inf if until is None else until
        if until <= skip:
            self._refuse("measured.until_before_skip", f"{self.where}.until", value=self.table["until"])
        return skip, until

    def _start(self, channels: list[str]) -> dict[str, str | float]:
        start: dict[str, str | float] = {}
        for address, given in self._mapping("start").items():
            where = f"{self.where}.start.{address}"
            measured = address.replace(".initial_", ".")
            if isinstance(given, bool) or not isinstance(given, str | int | float):
                self._refuse("measured.no_start", where, value=given)
            elif given == "first" and (measured == address or measured not in channels):
                self._refuse("measured.no_first_sample", where, channel=measured)
            start[address] = given
        return start

    def _columns(self, table: Mapping[str, Any], known: tuple[str, ...], where: str, ambient: float) -> list[_Column]:
        found = []
        for address, given in table.items():
            if "." not in address:
                if table is not self.table:
                    self._refuse("measured.no_address", f"{where}.{address}")
                continue
            fields = given if isinstance(given, Mapping) else {"column": given}
            column = self._column(address, fields, known, f"{where}.{address}", ambient)
            if column is not None:
                found.append(column)
        return found

    def _column(
        self, address: str, fields: Mapping[str, Any], known: tuple[str, ...], where: str, ambient: float
    ) -> _Column | None:
        before = len(self.problems)
        for key in fields:
            if key not in known:
                self._refuse("measured.no_field", f"{where}.{key}", near=Near(key, known))
        # What is of no use whatever the file holds.
        self._duration(fields, "lag", where)
        if "delay" in known:
            self._duration(fields, "delay", where, signed=True)
        own = any(key in fields for key in _OF_FILE)
        # What separates the columns of one file says nothing about another; the clock's name may be the same.
        inherited = ("time",) if "file" in fields else _OF_FILE
        file = {**{key: self.table[key] for key in inherited if key in self.table}, **fields}
        table = self._file(file, where if own else self.where)
        if "column" not in fields:
            self._refuse("measured.no_column", f"{where}.column")
        if table is None or "column" not in fields:
            return None
        time = self._time(table, file, where if own else self.where)
        values = self._named(table, fields["column"], f"{where}.column")
        if time is None or values is None:
            return None
        written = self._unit(table, values, fields, address, where)
        if written is None or len(self.problems) > before:
            return None
        unit, spelled = written
        in_si = convert(table.columns[values], spelled, unit, ambient_pressure=ambient)
        samples = self._attempt(where, lambda: ordered(time, in_si))
        if samples is None:
            return None
        self.notes.update(dict.fromkeys(note.within(address) for note in samples.notes))
        self.findings += heading_verdicts(address, table.names[values], table.units[values], spelled)
        return _Column(address, where, unit, spelled, samples, fields)

    def _file(self, fields: Mapping[str, Any], where: str) -> Table | None:
        name = fields.get("file")
        if not isinstance(name, str):
            self._refuse("measured.no_file", f"{where}.file")
            return None
        options = {key: fields[key] for key in ("separator", "decimal", "header_rows", "group") if key in fields}
        key = (name, *sorted((option, repr(value)) for option, value in options.items()))
        if key not in self.files:
            self.files[key] = self._read(name, options, where)
        return self.files[key]

    def _read(self, name: str, options: dict[str, Any], where: str) -> Table | None:
        kinds = {"header_rows": int, "group": str | int, "separator": str, "decimal": str}
        for option, value in options.items():
            if isinstance(value, bool) or not isinstance(value, kinds[option]):
                self._refuse("measured.option", f"{where}.{option}", value=value, option=option)
                return None
        table = self._attempt(f"{where}.file", lambda: read_table(self.folder / name, **options))
        if table is not None:
            self.notes.update(dict.fromkeys(note.within(name) for note in table.notes))
        return table

    def _named(self, table: Table, wanted: Any, where: str) -> int | None:
        """Where a column stands that holds numbers."""
        if isinstance(wanted, bool) or not isinstance(wanted, str | int):
            self._refuse("measured.column", where, value=wanted)
            return None
        place = self._attempt(where, lambda: table.index(wanted))
        if place is not None and np.isnan(table.columns[place]).all():
            texts = {n.facts["column"]: n.facts["cell"] for n in table.notes if n.code == "table.column_of_text"}
            cell = texts.get(table.names[place])
            code = "measured.column_of_text" if cell else "measured.empty_column"
            self._refuse(code, where, value=wanted, column=table.names[place], cell=cell)
            return None
        return place

    def _time(self, table: Table, fields: Mapping[str, Any], where: str) -> Any:
        """The time of a table's samples [s]."""
        given, where = fields.get("time", "time"), f"{where}.time"
        spec = given if isinstance(given, Mapping) else {"column": given}
        for key in spec:
            if key not in ("column", "unit"):
                self._refuse("measured.no_field", f"{where}.{key}", near=Near(key, ("column", "unit")))
        place = self._named(table, spec.get("column", "time"), f"{where}.column")
        if place is None:
            return None
        unit = str(spec.get("unit") or table.units[place] or "s")
        stamps = self._attempt(f"{where}.unit", lambda: convert(table.columns[place], unit, "s"))
        if stamps is not None:
            found = heading_verdicts(where, table.names[place], table.units[place], unit)
            self.findings += [each for each in found if each not in self.findings]
        return stamps

    def _unit(
        self, table: Table, place: int, fields: Mapping[str, Any], address: str, where: str
    ) -> tuple[str, str] | None:
        """The SI unit of a channel, and the unit in which it is recorded."""
        written, where = str(fields.get("unit") or table.units[place]), f"{where}.unit"
        if not written:
            self._refuse("measured.no_unit", where, column=table.names[place])
            return None
        unit = self._attempt(where, lambda: _si_unit(address, written))
        return (unit, written) if unit is not None else None

    def _enough(self, column: _Column, samples: Samples) -> bool:
        count = samples.time.size
        if count < LEAST_SAMPLES:
            self._refuse("measured.few_samples", column.where, samples=count, least=LEAST_SAMPLES)
        return count >= LEAST_SAMPLES

    def _channel(self, column: _Column, samples: Samples) -> Channel:
        where, given = f"{column.where}.noise", column.fields.get("noise")
        noise = None
        if given is not None:
            kind = _DIFFERENCE.get(column.unit, "plain")
            noise = self._attempt(where, lambda: quantity(given, column.unit, kind=kind, name=where).value)
            if noise is not None and noise <= 0.0:
                self._refuse("measured.noise", where, value=given)
        lag = self._duration(column.fields, "lag", column.where)
        quantum = quantum_of(samples.values)
        return Channel(column.address, samples.time, samples.values, column.unit, noise, lag, quantum)

    def _input(self, column: _Column, origin: float, ambient: float) -> InputChannel:
        samples = replace(column.samples, time=column.samples.time - origin)
        delay = self._duration(column.fields, "delay", column.where, signed=True)
        lag = self._duration(column.fields, "lag", column.where)
        hold = column.fields.get("hold", False)
        if not isinstance(hold, bool):
            self._refuse("measured.hold", f"{column.where}.hold", value=hold)
        time, values = samples.time, samples.values
        if "before" in column.fields:
            time = np.concatenate([time[:1] - _INSTANT, time])
            values = np.concatenate([[self._before(column, ambient)], values])
        return InputChannel(column.address, time, values, column.unit, delay, lag, hold is True)

    def _before(self, column: _Column, ambient: float) -> float:
        """What an input was before its record begins; written as a number in the unit of the record."""
        given, where = column.fields["before"], f"{column.where}.before"
        if isinstance(given, bool) or not isinstance(given, int | float) or not math.isfinite(given):
            self._refuse("measured.before", where, value=given)
            return math.nan
        return float(convert(float(given), column.written, column.unit, ambient_pressure=ambient))


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
