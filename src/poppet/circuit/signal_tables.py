"""Signals as a circuit file writes them: units at the door, SI behind it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from poppet.ground.errors import InputError, collect, suggestion
from poppet.ground.units import Kind, quantity
from poppet.parts.part import Input
from poppet.series.signals import Chirp, Constant, Points, Prbs, Sampled, Signal, Sine, Steps

_DIFFERENCE: dict[str, Kind] = {"pressure": "pressure_difference", "temperature": "temperature_difference"}
_REQUIRED = {
    "constant": ("value",),
    "steps": ("times", "values"),
    "points": ("times", "values"),
    "sine": ("mean", "amplitude", "frequency"),
    "chirp": ("mean", "amplitude", "frequency", "end_frequency"),
    "prbs": ("low", "high", "bit_time", "seed"),
    "file": ("path", "column"),
}
_OPTIONAL = {"sine": ("phase",), "chirp": ("phase", "duration"), "file": ("unit", "time")}
KINDS = tuple(_REQUIRED)


def fields_of(kind: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Required and optional fields of a kind of signal."""
    return _REQUIRED[kind], _OPTIONAL.get(kind, ())


def read_signal(table: Any, item: Input, ambient_pressure: float, folder: Path) -> Signal:
    """Make a signal of a table."""
    table = checked_table(table)
    return _READERS[table["kind"]](_Reader(table, item, ambient_pressure, folder))


def checked_table(table: Any) -> Mapping[str, Any]:
    """A table whose kind and fields are right; its values are read later."""
    if not isinstance(table, Mapping):
        table = {"kind": "constant", "value": table}
    kind = table.get("kind")
    if not isinstance(kind, str) or kind not in _REQUIRED:
        given = f"kind = {kind!r}" if "kind" in table else "kind is missing:"
        raise InputError(
            given, "is unknown." if "kind" in table else "nothing says what it is.", suggestion(str(kind), KINDS)
        )
    required, optional = fields_of(kind)
    known = ("kind", *required, *optional)
    unknown = [key for key in table if key not in known]
    problems = [
        InputError(f"{key} is missing:", f"a {kind} signal needs it.", f"Fields: {', '.join(required)}.", address=key)
        for key in required
        if key not in table and not get_close_matches(key, unknown, n=1)  # a misspelt field is one mistake
    ]
    problems += [
        InputError(key, f"is not a field of a {kind} signal.", suggestion(key, known[1:]), address=key)
        for key in unknown
    ]
    collect(problems)
    return dict(table)


class _Reader:
    """Reads the fields of one table in the units of one input."""

    def __init__(self, table: Mapping[str, Any], item: Input, ambient_pressure: float, folder: Path) -> None:
        self.table, self.item, self.ambient_pressure, self.folder = table, item, ambient_pressure, folder

    def absolute(self, given: Any, name: str) -> float:
        """A value of the input itself."""
        read = quantity(given, self.item.unit, kind=self.item.kind, name=name)  # type: ignore[arg-type]
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
            raise InputError(f"{name} = {given!r}", "is not a list.", 'Write ["0 s", "20 s"], say.', address=name)
        problems, values = [], []
        for k, entry in enumerate(given):
            try:
                values.append(read(entry, f"{name}[{k}]"))
            except InputError as error:
                problems.append(error.located(address=name))
        collect(problems)
        return values

    def path(self) -> tuple[list[float], list[float]]:
        times = self.list_of("times", lambda given, name: quantity(given, "s", name=name).value)
        return times, self.list_of("values", self.absolute)


def _path(kind: Callable[..., Signal], reader: _Reader) -> Signal:
    times, values = reader.path()
    try:
        return kind(times, values)
    except InputError as error:
        raise error.located(address="times") from None


def _read_file(reader: _Reader) -> Signal:
    from poppet.series.files import read

    table = reader.table
    path = reader.folder / str(table["path"])
    time_table = table.get("time", {})
    time_table = {"column": time_table} if isinstance(time_table, str) else time_table
    if not isinstance(time_table, Mapping) or not set(time_table) <= {"column", "unit"}:
        given = f"time = {table['time']!r}"
        raise InputError(
            given, "does not name a column.", 'Write time = { column = "t", unit = "ms" }.', address="time"
        )
    time = {"time": str(time_table.get("column", "time")), "time_unit": str(time_table.get("unit", ""))}
    recording = read(path, **time)
    name = str(table["column"])
    values = recording[name]
    unit = table.get("unit") or recording.unit(name)
    if not unit:
        raise InputError(f'column = "{name}"', f"of {path} has no unit.", 'Add unit = "bar g", say.', address="unit")
    one = [reader.absolute(f"{v:.17g} {unit}" if unit != "1" else float(v), name) for v in values]
    return Sampled(tuple(recording.time), tuple(one), str(path))


def _prbs(reader: _Reader) -> Signal:
    seed = reader.table["seed"]
    if isinstance(seed, bool) or not isinstance(seed, int):
        raise InputError(f"seed = {seed!r}", "is not a whole number.", "Write seed = 1, say.", address="seed")
    return Prbs(reader.value("low"), reader.value("high"), reader.plain("bit_time", "s"), seed)


_READERS: dict[str, Callable[[_Reader], Signal]] = {
    "constant": lambda r: Constant(r.value("value")),
    "steps": lambda r: _path(Steps, r),
    "points": lambda r: _path(Points, r),
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
    "file": _read_file,
}
