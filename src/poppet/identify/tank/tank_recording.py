"""Tank test from a recording alone: interpretation of the file, open questions, and the file of the test.

The editor and the command line use the same function, `interpret_tank`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.toml import value_text
from poppet.core.units import convert, quantity, same_dimension, stated_reference, unit_in
from poppet.identify.recorded_columns import (
    SERIAL,
    Origin,
    Question,
    RecordedColumn,
    Statements,
    UserStatement,
    find_column,
    find_pressure,
    read_pressure,
    read_time,
)
from poppet.identify.tank.identify_tank import time_unit_notes
from poppet.identify.tank.resting import rest_of_few_samples
from poppet.identify.tank.tank_plan import ONSET, STIRRED, TankRun, constant_start, index_of_change, read_runs
from poppet.identify.tank.test import DIRECTIONS, TankTest
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Channel, noise_of
from poppet.timeseries.measurements.measurement import ordered
from poppet.timeseries.tables.reading import Table, read_table
from poppet.timeseries.tables.table import heading_of

FREE, NEVER = "free", "no"
BOTH_WAYS = 0.3
"""Part of the range by which a pressure must rise and fall, so that it is no single test. After a discharge, the gas
warms and the pressure rises by less."""
MISREAD = (
    *("suspicion.below_vacuum", "suspicion.read_as_absolute", "suspicion.read_as_gauge", "suspicion.high_pressure"),
    *("suspicion.milliseconds", "suspicion.other_unit", "finding.unusual.closes", "finding.unusual.time"),
)
"""Codes of findings that contradict the interpretation of a file."""
_ASSUMED = {"ambient_temperature": "20 degC with a standard uncertainty of 3 K", "wall_conductance": "free"}
"""Fields that the file of a test can omit, and what is then assumed."""
CLOSED, ABOVE_AMBIENT = 0.01, 0.1
"""Parts of the range: rise after the minimum, and final level above ambient, of a discharge whose valve has closed."""
_TWICE = 0.05
"""Tolerance of a final pressure of twice the ambient pressure, as a fraction of the ambient pressure."""
UNSYNCHRONISED = 3.0, 0.01
"""Largest difference between the stated opening and the first change of the pressure: in samples, and as a part of the
recording."""
_SAMPLES = 20
"""Number of samples at the ends of a recording that give its first and last value, at most a fiftieth of all."""


class InterpretationItem(NamedTuple):
    """Row of the interpretation: subject, value, and sources of the value."""

    subject: str
    value: str
    origins: tuple[Origin, ...]


@dataclass(frozen=True, eq=False)
class TankInterpretation:
    """Meaning of a recording of a tank test, with the questions that are open.

    `run` is None while a question is open. The times of `curve` are in the unit of the file until its unit is known.
    """

    path: Path
    table: Table
    items: tuple[InterpretationItem, ...]
    questions: tuple[Question, ...]
    curve: tuple[FloatArray, FloatArray]  # time from the first sample, and pressure as in the file, (n,) each
    axes: tuple[str, str]  # units of the curve; empty if unknown
    rest_duration: float = 0.0  # duration of a constant start, in the unit of the curve
    moments: Mapping[str, float] = field(default_factory=dict)  # `opens` and `closes` from the first sample [s]
    fields: Mapping[str, UserStatement] = field(default_factory=dict)  # fields of the test with their sources
    recording: Mapping[str, Any] = field(default_factory=dict)  # table of the recording in the file of the test
    origins: Mapping[str, tuple[Origin, ...]] = field(default_factory=dict)  # sources of the fields in this table
    run: TankRun | None = None
    doubts: tuple[Note, ...] = ()  # findings that contradict the interpretation
    notes: tuple[Note, ...] = ()  # other findings on the samples

    @property
    def ambient(self) -> float | None:
        """Stated ambient pressure [Pa], or None."""
        statement = self.fields.get("ambient_pressure")
        return quantity(statement.text, "Pa", kind="pressure").value if statement else None

    def tank_test(self) -> TankTest:
        """Return the test that the interpretation describes; no question may be open."""
        recording = {"file": self.path.name, **self.recording}
        fields: dict[str, Any] = {key: statement.text for key, statement in self.fields.items()}
        recordings = {recording_name(self.path): recording}
        return TankTest(recordings=recordings, title=self.path.stem, **fields, folder=self.path.parent)

    def test_file(self, folder: Path) -> str:
        """Return the text of the tank test file; `folder` is the folder in which it will be written."""
        name = recording_name(self.path)
        lines = [
            f"# Tank test from {self.path.name}. Each comment states the source of the value.",
            f"title = {value_text(self.path.stem)}",
        ]
        lines += [_line(key, value_text(s.text), s.origin) for key, s in self.fields.items()]
        lines += [f"# {key}: {text} (assumed)" for key, text in _ASSUMED.items() if key not in self.fields]
        path = os.path.relpath(self.path, folder).replace(os.sep, "/")
        lines += ["", f"[recordings.{name}]", f"file = {value_text(path)}"]
        for key, value in self.recording.items():
            written = value_text(key) if "." in key else key
            lines.append(_line(written, value_text(value), ", ".join(self.origins.get(key, ()))))
        return "\n".join(lines) + "\n"


def recording_name(path: Path) -> str:
    """Return a name for the recording in a file, which is a valid key.

    Examples
    --------
    >>> recording_name(Path("Messung 12 (neu).csv"))
    'messung_12_neu'
    """
    return re.sub(r"\W+", "_", path.stem.lower(), flags=re.ASCII).strip("_") or "recording"


def interpret_tank(path: Path, statements: Statements, table: Table | None = None) -> TankInterpretation:
    """Return the interpretation of a recording of a tank test.

    Parameters
    ----------
    path : Path
        Recording in any format of `read_table`.
    statements : mapping
        Statements of the user by key: `time`, `time_unit`, `pressure`, `pressure_unit`, `reference`, `temperature`,
        `direction`, `window`, `opens`, `closes`, `volume`, `ambient`, `ambient_temperature`, `supply`,
        `wall_conductance`. The text of a column can contain its unit: `p_tank [bar g]`.
    table : Table, optional
        Content of the file, if it has already been read.

    Returns
    -------
    TankInterpretation
        Interpretation with all open questions. Without open questions, it contains the checked recording.

    Raises
    ------
    InputErrors
        If the file is invalid, or if a statement is.
    """
    table = table or read_table(path)
    reader = _TankReader(path, table, statements)
    with ErrorCollector() as errors:
        for read_column in (reader.read_time, reader.read_pressure, reader.read_temperature):
            with errors.collecting():
                read_column()
        for read_facts in (reader.read_course, reader.read_conditions):
            with errors.collecting():
                read_facts(errors)
    interpretation = reader.interpretation()
    return interpretation if interpretation.questions else _checked(interpretation)


def _checked(interpretation: TankInterpretation) -> TankInterpretation:
    """Return an interpretation with the recording in SI units and the findings on it."""
    (run,) = read_runs(interpretation.tank_test())
    measurement = run.measurement
    findings = (*measurement.findings, *time_unit_notes([run]))
    doubts = (*interpretation.doubts, *(note for note in findings if note.code in MISREAD))
    others = tuple(note for note in findings if note.code not in MISREAD)
    samples = (note for note in measurement.notes if not note.code.startswith("table."))
    return replace(interpretation, run=run, doubts=doubts, notes=(*others, *samples))


class _TankReader:
    """Reader of a recording, which collects items, fields and questions."""

    def __init__(self, path: Path, table: Table, statements: Statements) -> None:
        self.path, self.table, self.statements = path, table, statements
        self.items: list[InterpretationItem] = [*_layout_items(table)]
        self.questions: list[Question] = []
        self.fields: dict[str, UserStatement] = {}
        self.recording: dict[str, Any] = {}
        self.origins: dict[str, tuple[Origin, ...]] = {}
        self.time: RecordedColumn | None = None
        self.pressure: RecordedColumn | None = None
        self.temperature: int | None = None
        self.curve: tuple[FloatArray, FloatArray] = (np.zeros(0), np.zeros(0))
        self.rest_duration, self.begin = 0.0, 0.0
        self.moments: dict[str, float] = {}
        self.doubts: list[Note] = []
        self.is_used: set[int] = set()

    def interpretation(self) -> TankInterpretation:
        columns = zip(self.table.names, self.table.columns, strict=True)
        filled = [name if np.isfinite(column).any() else "" for name, column in columns]
        unused = [name for k, name in enumerate(filled) if name and k not in self.is_used]
        items = (*self.items, *([InterpretationItem("not used", ", ".join(unused), ("file",))] if unused else []))
        axes = ("s" if self.time and self.time.unit else "", self.pressure.unit if self.pressure else "")
        return TankInterpretation(
            self.path, self.table, items, tuple(self.questions), self.curve, axes, self.rest_duration, self.moments,
            self.fields, self.recording, self.origins, doubts=tuple(self.doubts),
        )  # fmt: skip

    def read_time(self) -> None:
        """Read the column of the time."""
        time = read_time(self.table, self.statements)
        if isinstance(time, Question):
            self.questions.append(time)
            return
        self.time = time
        self.is_used.add(time.index)
        self.questions += time.questions
        self.items.append(InterpretationItem("time", _column_text(time), time.origins))
        unit = {} if time.unit == SERIAL else {"unit": time.unit}
        self._record("time", {"column": self._column(time.index), **unit}, time.origins)

    def read_pressure(self) -> None:
        """Read the column of the tank pressure."""
        selection = find_pressure(self.table, self.time.index if self.time else None, self.statements)
        if isinstance(selection, Question):
            self.questions.append(selection)
            return
        self.pressure = pressure = read_pressure(self.table, *selection, self.statements)
        self.is_used.add(pressure.index)
        self.questions += pressure.questions
        self.items.append(InterpretationItem("tank pressure", _column_text(pressure), pressure.origins))
        channel = {"column": self._column(pressure.index), "unit": pressure.unit}
        self._record("tank.pressure", channel, pressure.origins)

    def read_temperature(self) -> None:
        """Read the column of the gas temperature, if the user states one."""
        statement, table = self.statements.get("temperature"), self.table
        if statement is None:
            return
        index, unit = find_column(table, statement.text, "temperature")
        unit = unit or table.units[index]
        if not same_dimension(unit or "1", "K"):
            raise InputError("measured.no_unit", "temperature", column=table.names[index])
        self.is_used.add(index)
        value = f"{table.names[index]} [{unit}], lag free"
        self.items.append(InterpretationItem("tank temperature", value, (statement.origin,)))
        channel = {"column": self._column(index), "unit": unit, "lag": FREE}
        self._record("tank.temperature", channel, (statement.origin,))

    def _record(self, key: str, value: Any, origins: tuple[Origin, ...]) -> None:
        self.recording[key], self.origins[key] = value, origins

    def _column(self, index: int) -> str | int:
        name = self.table.names[index]
        return name if self.table.names.count(name) == 1 else index

    def read_course(self, errors: ErrorCollector) -> None:
        """Read window, direction and opening from the course of the pressure."""
        if self.time is None or self.pressure is None:
            return
        samples = ordered(self.time.values, self.pressure.values)
        scale = _seconds(self.time.unit)
        time, values = (samples.time - samples.time[0]) * scale, samples.values
        window = None
        if statement := self.statements.get("window"):
            with errors.collecting():
                window = _read_window(statement.text)
                self.items.append(
                    InterpretationItem("window", f"{window[0]:g} s to {window[1]:g} s", (statement.origin,))
                )
                for key, end in zip(("skip", "until"), window, strict=True):
                    self._record(key, f"{end:.9g} s", (statement.origin,))
                is_inside = (time >= window[0]) & (time <= window[1])
                if np.count_nonzero(is_inside) < 3:
                    raise InputError("question.bad_window", "window", value=statement.text)
                time, values = time[is_inside], values[is_inside]
                self.begin = float(time[0])
        if not np.ptp(values) > 0.0:
            raise InputError("question.constant", "pressure", column=self.pressure.name, value=float(values[0]))
        self.curve = time, values
        self.items.append(
            InterpretationItem(
                "samples",
                f"{time.size}, {time[-1] - time[0]:.5g} {'s' if self.time.unit else 'units of the time'}",
                ("file",),
            )
        )
        course = _PressureCourse.of(values)
        if course.is_both_ways and window is None:
            facts = {"first": course.first, "low": course.low, "high": course.high, "last": course.last}
            self.questions.append(Question("window", Note("question.window", **facts)))
        self._read_direction(course, errors)
        self._read_opening(Channel("tank.pressure", time, values, ""), errors)

    def _read_direction(self, course: _PressureCourse, errors: ErrorCollector) -> None:
        statement = self.statements.get("direction")
        if statement and statement.text not in DIRECTIONS:
            suggestion = NameSuggestion(statement.text, DIRECTIONS)
            errors.add(
                "fields.not_an_option", "direction", value=statement.text, meaning="direction", suggestion=suggestion
            )
        verb = "falls" if course.last < course.first else "rises"
        by_file = UserStatement("discharge" if verb == "falls" else "charge", "file")
        self.fields["direction"] = statement or by_file
        reason = f": the pressure {verb}" if not statement else ""
        self.items.append(
            InterpretationItem(
                "direction", f"{self.fields['direction'].text}{reason}", (self.fields["direction"].origin,)
            )
        )

    def _read_opening(self, channel: Channel, errors: ErrorCollector) -> None:
        noise = 6.0 * noise_of(channel.values) / max(float(np.ptp(channel.values)), 1e-300)
        start = channel.time - channel.time[0]
        self.rest_duration = constant_start(channel) or rest_of_few_samples(start, channel.values)
        if self.rest_duration == 0.0 and noise > STIRRED:
            self.rest_duration = float(channel.time[index_of_change(channel, ONSET)])
        unit = "s" if self.time is not None and self.time.unit else "units of the time"
        if self.rest_duration > 0.0:
            self.items.append(InterpretationItem("rest before opening", f"{self.rest_duration:.3g} {unit}", ("file",)))
        statement = self.statements.get("opens")
        if statement is None and self.rest_duration > 0.0:
            self.questions.append(
                Question("opens", Note("question.opens", duration=self.rest_duration, unit=unit), default=FREE)
            )
        elif statement is None:
            self.items.append(InterpretationItem("valve opens", "at the first sample: no rest before it", ("file",)))
        elif statement.text == FREE:
            self.fields["valve_delay"] = statement
            self.items.append(InterpretationItem("valve opens", "estimated by the fit", (statement.origin,)))
        else:
            with errors.collecting():
                if heading_of(statement.text)[0] in self.table.names:
                    self._read_valve_signal(statement)
                else:
                    self._read_moment("opens", statement)
                self._check_opening(channel)
        closes = self.statements.get("closes")
        if closes is None and (self.fields["direction"].text == "charge" or self._is_closed_at_end(channel)):
            self.questions.append(Question("closes", Note("question.closes")))
        elif closes is None or closes.text == NEVER:
            origin: Origin = closes.origin if closes else "assumed"
            self.items.append(InterpretationItem("valve closes", "not in the recording", (origin,)))
        else:
            with errors.collecting():
                self._read_moment("closes", closes)

    def _is_closed_at_end(self, channel: Channel) -> bool:
        """Return True if the pressure of a discharge stops falling above the ambient pressure.

        The gas warms after the valve has closed, so the pressure rises, or it is constant in an isothermal tank.
        """
        values, range_ = channel.values, max(float(np.ptp(channel.values)), 1e-300)
        course, noise = _PressureCourse.of(values), noise_of(values)
        limit = max(CLOSED * range_, 5.0 * noise)
        if course.last - course.low > limit:
            return True
        ambient = self.statements.get("ambient")
        if ambient is None or self.pressure is None or not self.pressure.unit:
            return False
        try:
            text = self._mean_of_column(ambient, "ambient", "Pa").text
            pressure = quantity(text, "Pa", kind="pressure").value
        except InputError:  # read_conditions reports it
            return False
        unit = self.pressure.unit
        last, low, high = (convert(v, unit, "Pa", ambient_pressure=pressure) for v in course[1:])
        excess, span = last - pressure, high - low
        if abs(excess - pressure) < _TWICE * pressure:
            return False  # an absolute pressure that is read as gauge, which is a doubt of its own
        tail = values[int(0.8 * values.size) :]
        change = abs(float(np.median(tail[: max(1, tail.size // 4)])) - course.last)
        return change < 0.5 * limit and excess > ABOVE_AMBIENT * span

    def _read_moment(self, key: str, statement: UserStatement) -> None:
        """Read the time of opening or closing, which the file of the test counts from the first used sample."""
        seconds = quantity(statement.text, "s", name=key).value
        self.moments[key] = seconds
        self._record(key, f"{seconds - self.begin:.9g} s", (statement.origin,))
        self.items.append(InterpretationItem(f"valve {key}", f"{seconds:g} s", (statement.origin,)))

    def _read_valve_signal(self, statement: UserStatement) -> None:
        """Read the time of opening from a column of the valve signal: its first change after the start of the window.

        The time is that of the first sample whose value differs from the first one by more than half the range.
        """
        if self.time is None or not self.time.unit:
            return
        index, _ = find_column(self.table, statement.text, "opens")
        self.is_used.add(index)
        name = self.table.names[index]
        samples = ordered(self.time.values, self.table.columns[index])
        start = float(np.nanmin(self.time.values))
        time = (samples.time - start) * _seconds(self.time.unit)
        is_later = time >= self.begin
        time, values = time[is_later], samples.values[is_later]
        changes = np.flatnonzero(2.0 * np.abs(values - values[0]) > np.ptp(values)) if values.size else np.zeros(0, int)
        if changes.size == 0:
            raise InputError("question.no_switching", "opens", column=name)
        seconds, origins = float(time[changes[0]]), (statement.origin, *_FILE)
        self.moments["opens"] = seconds
        self._record("opens", f"{seconds - self.begin:.9g} s", origins)
        self.items.append(InterpretationItem("valve opens", f"{seconds:g} s: first change of {name}", origins))

    def _check_opening(self, channel: Channel) -> None:
        """Add a doubt if the pressure begins to change at another time than stated."""
        if self.time is None or not self.time.unit:
            return
        change, time = self.begin + self.rest_duration, channel.time
        samples, share = UNSYNCHRONISED
        tolerance = max(samples * float(np.median(np.diff(time))), share * float(np.ptp(time)))
        if abs(self.moments["opens"] - change) > tolerance:
            facts = {"opens": self.moments["opens"], "change": change}
            self.doubts.append(Note("question.unsynchronised", "opens", **facts))

    def read_conditions(self, errors: ErrorCollector) -> None:
        """Read what no recording contains: volume, ambient conditions, supply and wall."""
        self._read_value("volume", "volume", "m^3", errors)
        if "direction" in self.fields and self.fields["direction"].text == "charge":
            self._read_supply(errors)
        self._read_value("ambient_pressure", "ambient", "Pa", errors, subject="ambient pressure")
        for key, unit, default, description in (
            ("ambient_temperature", "K", "", "20 degC +/- 3 K"),
            ("wall_conductance", "W/K", FREE, "estimated by the fit"),
        ):
            subject = key.replace("_", " ")
            statement = self.statements.get(key)
            if statement is None or statement.text == default:
                origin: Origin = statement.origin if statement else "assumed"
                self.items.append(InterpretationItem(subject, description, (origin,)))
                self.fields |= {key: statement} if statement else {}
            else:
                self._read_value(key, key, unit, errors, subject=subject)

    def _read_value(self, name: str, key: str, unit: str, errors: ErrorCollector, *, subject: str = "") -> None:
        statement = self.statements.get(key)
        if statement is None:
            self.questions.append(Question(key, Note(f"question.{key}")))
            return
        kind = {"Pa": "pressure", "K": "temperature"}.get(unit, "plain")
        with errors.collecting():
            statement = self._mean_of_column(statement, key, unit)
            # A number without a unit: the usual hint would propose the SI unit, here m^3 instead of l.
            if _NUMBER.fullmatch(statement.text):
                raise InputError("question.no_unit", key, value=statement.text, examples=_with_units(key, statement))
            read = quantity(statement.text, unit, kind=kind, name=key)  # type: ignore[arg-type]
            if read.value <= 0.0 or read.reference == "gauge":
                raise InputError("question.not_above_zero", key, value=statement.text, example=_EXAMPLES[key])
            self.fields[name] = statement
            self.items.append(InterpretationItem(subject or name, statement.text, (statement.origin,)))

    def _mean_of_column(self, statement: UserStatement, key: str, unit: str) -> UserStatement:
        """Return a statement on an ambient condition; the name of a column is replaced by the mean of its values."""
        if unit not in ("Pa", "K") or heading_of(statement.text)[0] not in self.table.names:
            return statement
        index, stated = find_column(self.table, statement.text, key)
        written = stated or self.table.units[index]
        if not written:
            raise InputError("measured.no_unit", key, column=self.table.names[index])
        self.is_used.add(index)
        values = self.table.columns[index]
        return UserStatement(f"{float(np.nanmean(values)):.6g} {written}", statement.origin)

    def _read_supply(self, errors: ErrorCollector) -> None:
        statement = self.statements.get("supply")
        if statement is None:
            self.questions.append(Question("supply", Note("question.supply")))
            return
        with errors.collecting():
            try:
                quantity(statement.text, "Pa", kind="pressure", name="supply")
            except InputError as error:
                if _NUMBER.fullmatch(statement.text) and statement.text not in self.table.names:
                    examples = _with_units("supply", statement)
                    raise InputError("question.no_unit", "supply", value=statement.text, examples=examples) from error
                index, unit = find_column(self.table, statement.text, "supply")
                column = read_pressure(self.table, index, statement.origin, unit, {})
                self.is_used.add(index)
                if column.questions:
                    raise InputError("question.supply_unit", "supply", column=column.name) from None
                channel = {"column": self._column(index), "unit": column.unit}
                self._record("inputs", {"supply.pressure": channel}, (statement.origin,))
                self.items.append(InterpretationItem("supply pressure", _column_text(column), (statement.origin,)))
            else:
                if not stated_reference(unit_in(statement.text, "Pa")):
                    choices = tuple(f"{statement.text} {mark}" for mark in "ga")
                    raise InputError("question.no_answer", "supply", value=statement.text, choices=choices)
                self.fields["supply_pressure"] = statement
                self.items.append(InterpretationItem("supply pressure", statement.text, (statement.origin,)))


_NUMBER = re.compile(r"\s*[-+]?[\d.,]+\s*")
_EXAMPLES = {
    "volume": "20 l",
    "ambient": "1.013 bar",
    "ambient_temperature": "21 degC",
    "wall_conductance": "6 W/K",
}
_USUAL_UNITS = {
    "volume": ("l",),
    "ambient": ("bar", "hPa"),
    "ambient_temperature": ("degC",),
    "wall_conductance": ("W/K",),
    "supply": ("bar g", "bar a"),
}
"""Units that an error proposes for a number without a unit."""
_FILE: tuple[Origin, ...] = ("file",)


class _PressureCourse(NamedTuple):
    """First, last, lowest and highest value of a pressure, robust to single samples."""

    first: float
    last: float
    low: float
    high: float

    @classmethod
    def of(cls, values: FloatArray) -> _PressureCourse:
        count = max(1, min(_SAMPLES, values.size // 50))
        ends = float(np.median(values[:count])), float(np.median(values[-count:]))
        ranked = np.sort(values)
        return cls(*ends, float(np.median(ranked[:count])), float(np.median(ranked[-count:])))

    @property
    def is_both_ways(self) -> bool:
        """True if the pressure rises and falls by a considerable part of its range."""
        range_ = self.high - self.low
        top, bottom = max(self.first, self.last), min(self.first, self.last)
        return max(self.high - top, bottom - self.low) > BOTH_WAYS * range_ if range_ > 0.0 else False


def _with_units(key: str, statement: UserStatement) -> tuple[str, ...]:
    """Return the number of a statement with each usual unit."""
    return tuple(f"{statement.text.strip().replace(',', '.')} {unit}" for unit in _USUAL_UNITS[key])


def _read_window(text: str) -> tuple[float, float]:
    ends = [quantity(end.strip(), "s", name="window").value for end in text.split(",")]
    if len(ends) != 2 or not 0.0 <= ends[0] < ends[1]:
        raise InputError("question.bad_window", "window", value=text)
    return ends[0], ends[1]


def _seconds(unit: str) -> float:
    return 86400.0 if unit == SERIAL else convert(1.0, unit, "s") if unit else 1.0


def _layout_items(table: Table) -> Iterator[InterpretationItem]:
    """Yield the items on separator, decimal sign, headings and time stamps, from the notes of the reader."""
    facts = {note.code: note.facts for note in table.notes}
    if "table.guessed" in facts:
        yield InterpretationItem("column separator", facts["table.guessed"]["separator"], ("file",))
        yield InterpretationItem("decimal sign", facts["table.guessed"]["decimal"], ("file",))
    lines = [note.facts["number"] for note in table.notes if note.code == "table.header_line"]
    if lines:
        yield InterpretationItem("lines above the headings", ", ".join(map(str, lines)), ("file",))
    for note in table.notes:
        if note.code == "table.column_of_text":
            yield InterpretationItem("text, no numbers", f"{note.facts['column']}: {note.facts['cell']}", ("file",))
    if "table.time_stamps" in facts:
        yield InterpretationItem("first time stamp", facts["table.time_stamps"]["first"], ("file",))


def _column_text(column: RecordedColumn) -> str:
    values = column.values[np.isfinite(column.values)]
    unit = column.unit or "unit unknown"
    return f"{column.name} [{unit}], {values.min():.5g} to {values.max():.5g}"


def _line(key: str, value: str, origin: str) -> str:
    return f"{f'{key} = {value}':<33} # {origin}".rstrip("# ")
