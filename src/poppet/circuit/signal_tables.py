"""Reader of the signals of circuit files, which converts all values to SI."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from difflib import get_close_matches
from pathlib import Path
from typing import Any, NamedTuple

from poppet.circuit.placed_part import volume_flow_note
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.files import check_path
from poppet.core.tables import Field, missing_field
from poppet.core.units import Kind, quantity
from poppet.engine.lru_cache import LruCache
from poppet.parts.part import Input
from poppet.timeseries.signals import Chirp, Constant, Points, Prbs, Pwm, SampledSignal, Signal, Sine, Square, Steps

_DIFFERENCE: dict[str, Kind] = {"pressure": "pressure_difference", "temperature": "temperature_difference"}


def fields_of(kind: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the required and the optional field names of a kind of signal."""
    return _KINDS[kind].required, _KINDS[kind].optional


def read_signal(table: Any, item: Input, ambient_pressure: float, folder: Path) -> Signal:
    """Convert a table of a circuit file to the signal that it declares.

    `item` is the declaration of the input. Gauge values refer to `ambient_pressure`, and relative file names to
    `folder`.
    """
    table = check_signal_table(table)
    reader = _SignalReader(table, item, ambient_pressure, folder)
    signal = _KINDS[table["kind"]].read(reader)
    # The dataclass is frozen.
    object.__setattr__(signal, "remarks", tuple(reader.remarks.values()))
    return signal


def _missing(field: str, kind: str) -> InputError:
    return missing_field(field, Field(meaning=f"{field} of a {kind} signal"))


def check_signal_table(table: Any) -> Mapping[str, Any]:
    """Check the kind and the field names of a signal table, and return the table.

    The values of the fields are not checked.
    """
    if not isinstance(table, Mapping):
        table = {"kind": "constant", "value": table}
    kind = table.get("kind")
    if not isinstance(kind, str) or kind not in KINDS:
        code = "fields.not_an_option" if "kind" in table else "inputs.no_kind"
        raise InputError(
            code, "kind", value=kind, meaning="kind of signal", suggestion=NameSuggestion(str(kind), KINDS)
        )
    required, optional = fields_of(kind)
    valid = (*required, *optional)
    unknown = [key for key in table if key not in ("kind", *valid)]
    with ErrorCollector() as errors:
        for key in required:
            if key not in table and not get_close_matches(key, unknown, n=1):  # a misspelt field is one error
                errors.extend([_missing(key, kind)])
        for key in unknown:
            errors.add("fields.unknown", key, table=f"{kind} signal", suggestion=NameSuggestion(key, valid))
    return dict(table)


class _SignalReader:
    """Reader of the fields of one signal table, whose values belong to one input."""

    def __init__(self, table: Mapping[str, Any], item: Input, ambient_pressure: float, folder: Path) -> None:
        self.table, self.item, self.ambient_pressure, self.folder = table, item, ambient_pressure, folder
        self.remarks: dict[str, Note] = {}  # the first note of each code

    def absolute(self, argument: Any, name: str) -> float:
        """Return a value of the input in SI units.

        A gauge pressure becomes absolute. `name` is the name of the field that contains the value.
        """
        # A gauge value refers to the ambient pressure of the file.
        read = quantity(argument, self.item.unit, kind=self.item.kind, name=name, is_told=True)  # type: ignore[arg-type]
        if self.item.kind == "mass_flow" and isinstance(argument, str):
            for note in volume_flow_note(argument, read.value, read.unit):
                self.remarks.setdefault(note.code, note)
        return read.value + (self.ambient_pressure if read.reference == "gauge" else 0.0)

    def value(self, name: str) -> float:
        return self.absolute(self.table[name], name)

    def difference(self, name: str) -> float:
        """Return the field `name`, which is a difference such as an amplitude, in SI units."""
        kind = _DIFFERENCE.get(self.item.kind, self.item.kind)
        return quantity(self.table[name], self.item.unit, kind=kind, name=name).value  # type: ignore[arg-type]

    def plain(self, name: str, unit: str, default: float | None = None) -> float:
        return quantity(self.table.get(name, default), unit, name=name).value

    def integer(self, name: str) -> int:
        value = self.table[name]
        # In Python, True is an int.
        if isinstance(value, bool) or not isinstance(value, int):
            raise InputError("inputs.no_seed", name, value=value)
        return value

    def list_of(self, name: str, read: Callable[[Any, str], float]) -> list[float]:
        elements = self.table[name]
        if not isinstance(elements, list) or not elements:
            raise InputError("inputs.no_list", name, value=elements)
        values = []
        with ErrorCollector() as errors:
            for k, element in enumerate(elements):
                with errors.collecting():
                    values.append(read(element, f"{name}[{k}]"))
        return values

    def course(self, kind: Callable[..., Signal]) -> Signal:
        """Return a signal of the class `kind` from the fields `times` and `values` of the table."""
        times = self.list_of("times", lambda argument, name: quantity(argument, "s", name=name).value)
        values = self.list_of("values", self.absolute)
        try:
            return kind(times, values)
        except InputError as error:
            # Errors of order and length are errors of the times.
            raise error.located(address="times") from None


def _read_file(reader: _SignalReader) -> Signal:
    table, item = reader.table, reader.item
    path = reader.folder / str(table["path"])
    time_table = table.get("time", {})
    time_table = {"column": time_table} if isinstance(time_table, str) else time_table
    if not isinstance(time_table, Mapping) or not set(time_table) <= {"column", "unit"}:
        raise InputError("inputs.no_column", "time", value=table["time"])
    time = (str(time_table.get("column", "time")), str(time_table.get("unit", "")))
    name, unit = str(table["column"]), table.get("unit")
    check_path(path)
    key: Any = None
    with suppress(OSError):  # a missing file, which the reader reports
        status = path.stat()
        version = (status.st_ino, status.st_size, status.st_mtime_ns)
        key = (path, version, time, name, repr(unit), item.unit, item.kind, reader.ambient_pressure)
    signal, remarks = _FILES.get(key, lambda: _signal_of_file(reader, path, time, name, unit))
    reader.remarks |= remarks
    return signal


_FILES: LruCache[tuple[Signal, dict[str, Note]]] = LruCache(8)
"""Signals of files: a circuit that is edited is read again after each change."""


def _signal_of_file(
    reader: _SignalReader, path: Path, time: tuple[str, str], name: str, unit: Any
) -> tuple[Signal, dict[str, Note]]:
    """Return the signal in a column of a file, and the notes on its values."""
    from poppet.timeseries.recording_files import read

    recording = read(path, time=time[0], time_unit=time[1])
    unit = unit or recording.unit(name)
    if not unit:
        raise InputError("inputs.no_unit", "unit", column=name, path=str(path))
    # Through text: units and gauge pressures are read as in files; 17 digits preserve the value.
    values = [reader.absolute(f"{v:.17g} {unit}" if unit != "1" else float(v), name) for v in recording[name]]
    return SampledSignal(tuple(recording.time), tuple(values), str(path)), dict(reader.remarks)


def _read_pwm(reader: _SignalReader) -> Signal:
    duty_entry, levels = reader.table["duty"], {"low": 0.0, "high": 1.0}
    duty: float | Signal
    with ErrorCollector() as errors:
        # The default levels are meaningful only for a fraction, such as an opening.
        for name in levels if reader.item.unit != "1" else ():
            if name not in reader.table:
                errors.extend([_missing(name, "pwm")])
        with errors.collecting("duty" if isinstance(duty_entry, Mapping) else ""):
            if isinstance(duty_entry, Mapping):
                duty = read_signal(duty_entry, Input("duty", "1", 0.0), reader.ambient_pressure, reader.folder)
            else:
                duty = reader.plain("duty", "1")
    low, high = (reader.value(name) if name in reader.table else default for name, default in levels.items())
    return Pwm(reader.plain("frequency", "Hz"), duty, low, high)


class _SignalKind(NamedTuple):
    """Required and optional fields of one kind of signal, with the function that reads them."""

    required: tuple[str, ...]
    optional: tuple[str, ...]
    read: Callable[[_SignalReader], Signal]


_KINDS = {
    "constant": _SignalKind(("value",), (), lambda r: Constant(r.value("value"))),
    "steps": _SignalKind(("times", "values"), (), lambda r: r.course(Steps)),
    "points": _SignalKind(("times", "values"), (), lambda r: r.course(Points)),
    "sine": _SignalKind(
        ("mean", "amplitude", "frequency"),
        ("phase",),
        lambda r: Sine(
            r.value("mean"), r.difference("amplitude"), r.plain("frequency", "Hz"), r.plain("phase", "rad", 0.0)
        ),
    ),
    "chirp": _SignalKind(
        ("mean", "amplitude", "frequency", "end_frequency"),
        ("phase", "duration"),
        lambda r: Chirp(
            r.value("mean"),
            r.difference("amplitude"),
            r.plain("frequency", "Hz"),
            r.plain("end_frequency", "Hz"),
            r.plain("duration", "s") if "duration" in r.table else None,
            r.plain("phase", "rad", 0.0),
        ),
    ),
    "prbs": _SignalKind(
        ("low", "high", "bit_time", "seed"),
        (),
        lambda r: Prbs(r.value("low"), r.value("high"), r.plain("bit_time", "s"), r.integer("seed")),
    ),
    "square": _SignalKind(
        ("low", "high", "frequency"),
        ("duty",),
        lambda r: Square(r.value("low"), r.value("high"), r.plain("frequency", "Hz"), r.plain("duty", "1", 0.5)),
    ),
    "pwm": _SignalKind(("frequency", "duty"), ("low", "high"), _read_pwm),
    "file": _SignalKind(("path", "column"), ("unit", "time"), _read_file),
}
KINDS = tuple(_KINDS)
