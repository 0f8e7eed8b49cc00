"""Signals as a circuit file writes them: units at the door, SI behind it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from poppet.circuit.placed_part import open_flow
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.units import Kind, quantity
from poppet.parts.part import Input
from poppet.timeseries.signals import Chirp, Constant, Points, Prbs, Pwm, SampledSignal, Signal, Sine, Square, Steps

_DIFFERENCE: dict[str, Kind] = {"pressure": "pressure_difference", "temperature": "temperature_difference"}
_REQUIRED = {
    "constant": ("value",),
    "steps": ("times", "values"),
    "points": ("times", "values"),
    "sine": ("mean", "amplitude", "frequency"),
    "chirp": ("mean", "amplitude", "frequency", "end_frequency"),
    "prbs": ("low", "high", "bit_time", "seed"),
    "square": ("low", "high", "frequency"),
    "pwm": ("frequency", "duty"),
    "file": ("path", "column"),
}
_OPTIONAL = {
    "sine": ("phase",),
    "chirp": ("phase", "duration"),
    "square": ("duty",),
    "pwm": ("low", "high"),
    "file": ("unit", "time"),
}
KINDS = tuple(_REQUIRED)


def fields_of(kind: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Required and optional fields of a kind of signal."""
    return _REQUIRED[kind], _OPTIONAL.get(kind, ())


def read_signal(table: Any, item: Input, ambient_pressure: float, folder: Path) -> Signal:
    """Make a signal of a table."""
    table = checked_table(table)
    reader = _Reader(table, item, ambient_pressure, folder)
    signal = _READERS[table["kind"]](reader)
    # The only way to set a field of a frozen dataclass.
    object.__setattr__(signal, "remarks", tuple(reader.remarks.values()))
    return signal


def checked_table(table: Any) -> Mapping[str, Any]:
    """A table whose kind and fields are right; its values are read later."""
    if not isinstance(table, Mapping):
        table = {"kind": "constant", "value": table}
    kind = table.get("kind")
    if not isinstance(kind, str) or kind not in _REQUIRED:
        code = "inputs.unknown_kind" if "kind" in table else "inputs.no_kind"
        raise InputError(code, "kind", value=kind, near=NameSuggestion(str(kind), KINDS))
    required, optional = fields_of(kind)
    known = (*required, *optional)
    unknown = [key for key in table if key not in ("kind", *known)]
    with ErrorCollector() as errors:
        for key in required:
            if key not in table and not get_close_matches(key, unknown, n=1):  # a misspelt field is one mistake
                errors.add("inputs.missing", key, kind=kind, fields=required)
        for key in unknown:
            errors.add("inputs.unknown_field", key, kind=kind, near=NameSuggestion(key, known))
    return dict(table)


class _Reader:
    """Reads the fields of one table in the units of one input."""

    def __init__(self, table: Mapping[str, Any], item: Input, ambient_pressure: float, folder: Path) -> None:
        self.table, self.item, self.ambient_pressure, self.folder = table, item, ambient_pressure, folder
        self.remarks: dict[str, Note] = {}  # the first of each code stands for all values

    def absolute(self, given: Any, name: str) -> float:
        """A value of the input itself."""
        # Inputs are absolute: a gauge value in the file means the ambient pressure of that file.
        read = quantity(given, self.item.unit, kind=self.item.kind, name=name, is_told=True)  # type: ignore[arg-type]
        if self.item.kind == "mass_flow" and isinstance(given, str):
            for note in open_flow(given, read.value, read.unit):
                self.remarks.setdefault(note.code, note)
        return read.value + (self.ambient_pressure if read.reference == "gauge" else 0.0)

    def value(self, name: str) -> float:
        return self.absolute(self.table[name], name)

    def difference(self, name: str) -> float:
        """A difference of two values of the input, as an amplitude is."""
        kind = _DIFFERENCE.get(self.item.kind, self.item.kind)
        return quantity(self.table[name], self.item.unit, kind=kind, name=name).value  # type: ignore[arg-type]

    def plain(self, name: str, unit: str, default: float | None = None) -> float:
        given = self.table.get(name, default)
        return quantity(given, unit, name=name).value

    def list_of(self, name: str, read: Callable[[Any, str], float]) -> list[float]:
        given = self.table[name]
        if not isinstance(given, list) or not given:
            raise InputError("inputs.no_list", name, value=given)
        values = []
        with ErrorCollector() as errors:
            for k, entry in enumerate(given):
                with errors.collecting():
                    values.append(read(entry, f"{name}[{k}]"))
        return values

    def path(self, kind: Callable[..., Signal]) -> Signal:
        """A signal of times and values."""
        times = self.list_of("times", lambda given, name: quantity(given, "s", name=name).value)
        values = self.list_of("values", self.absolute)
        try:
            return kind(times, values)
        except InputError as error:
            # The signal cannot know which field of the table its mistake is in; order and length belong to the times.
            raise error.located(address="times") from None


def _read_file(reader: _Reader) -> Signal:
    from poppet.timeseries.recording_files import read

    table = reader.table
    path = reader.folder / str(table["path"])
    time_table = table.get("time", {})
    time_table = {"column": time_table} if isinstance(time_table, str) else time_table
    if not isinstance(time_table, Mapping) or not set(time_table) <= {"column", "unit"}:
        raise InputError("inputs.no_column", "time", value=table["time"])
    time = {"time": str(time_table.get("column", "time")), "time_unit": str(time_table.get("unit", ""))}
    recording = read(path, **time)
    name = str(table["column"])
    values = recording[name]
    unit = table.get("unit") or recording.unit(name)
    if not unit:
        raise InputError("inputs.no_unit", "unit", column=name, path=str(path))
    # Through text, so that units and gauge pressures are read as everywhere; 17 digits lose nothing.
    one = [reader.absolute(f"{v:.17g} {unit}" if unit != "1" else float(v), name) for v in values]
    return SampledSignal(tuple(recording.time), tuple(one), str(path))


def _prbs(reader: _Reader) -> Signal:
    seed = reader.table["seed"]
    # True is an int in Python, and TOML has both.
    if isinstance(seed, bool) or not isinstance(seed, int):
        raise InputError("inputs.no_seed", "seed", value=seed)
    return Prbs(reader.value("low"), reader.value("high"), reader.plain("bit_time", "s"), seed)


def _pwm(reader: _Reader) -> Signal:
    given, levels = reader.table["duty"], {"low": 0.0, "high": 1.0}
    duty: float | Signal
    with ErrorCollector() as errors:
        # The defaults mean something where the input is a part of a whole, as an opening is, and only there.
        for name in levels if reader.item.unit != "1" else ():
            if name not in reader.table:
                errors.add("inputs.missing", name, kind="pwm", fields=("frequency", "duty", *levels))
        with errors.collecting("duty" if isinstance(given, Mapping) else ""):
            if isinstance(given, Mapping):
                duty = read_signal(given, Input("duty", "1", 0.0), reader.ambient_pressure, reader.folder)
            else:
                duty = reader.plain("duty", "1")
    low, high = (reader.value(name) if name in reader.table else default for name, default in levels.items())
    return Pwm(reader.plain("frequency", "Hz"), duty, low, high)


_READERS: dict[str, Callable[[_Reader], Signal]] = {
    "constant": lambda r: Constant(r.value("value")),
    "steps": lambda r: r.path(Steps),
    "points": lambda r: r.path(Points),
    "sine": lambda r: Sine(
        r.value("mean"), r.difference("amplitude"), r.plain("frequency", "Hz"), r.plain("phase", "rad", 0.0)
    ),
    "chirp": lambda r: Chirp(
        r.value("mean"),
        r.difference("amplitude"),
        r.plain("frequency", "Hz"),
        r.plain("end_frequency", "Hz"),
        r.plain("duration", "s") if "duration" in r.table else None,
        r.plain("phase", "rad", 0.0),
    ),
    "prbs": _prbs,
    "square": lambda r: Square(r.value("low"), r.value("high"), r.plain("frequency", "Hz"), r.plain("duty", "1", 0.5)),
    "pwm": _pwm,
    "file": _read_file,
}
