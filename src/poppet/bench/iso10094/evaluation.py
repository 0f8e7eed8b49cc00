"""Tests of the bench, and the evaluation of their records.

An evaluation collects characteristic values, one row per case, curves and notes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, Protocol

import numpy as np

from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.uncertainty import NORMAL, Uncertainty, greatest
from poppet.core.codes import Note
from poppet.core.message_format import sentence
from poppet.timeseries.segments import Signal
from poppet.timeseries.signals import Constant

ROWS = 4000  # rows of a sweep over the full range


@dataclass(frozen=True)
class Trial:
    """One run of a test valve on the bench: its inputs and durations."""

    kind: str  # name of the test
    name: str
    setpoint: Signal  # in the unit of the scale
    duration: float  # [s]
    lead: float  # initial part, in which the test valve settles [s]
    step: float  # time between rows [s]
    volume: float  # at the outlet [m^3]
    supply: Signal | None = None  # absolute pressure, None for a constant supply [Pa]
    # From 1 (maximum forward flow) to -1 (maximum relief flow); None for no flow.
    load: Signal | None = None


class Specimen(Protocol):
    """Interface of a test valve, which is a circuit model or a virtual valve."""

    @property
    def title(self) -> str:
        """Title of the test valve for reports."""

    @property
    def scale(self) -> Scale:
        """Range of the setpoint, and the range of the outlet pressure to which it corresponds."""

    @property
    def supply(self) -> float:
        """Absolute supply pressure [Pa]."""

    def respond(self, trial: Trial) -> Record:
        """Run a trial, and return the recorded channels."""


@dataclass(frozen=True)
class BenchSettings:
    """Settings of the bench: volumes, amplitudes, frequencies, setpoints and times.

    Every field has a default.
    """

    volumes: tuple[float, ...] = (1e-3, 5e-3)  # static tests use the first one [m^3]
    amplitudes: tuple[float, ...] = (80.0, 50.0, 10.0)  # steps about the middle of the range [% FS]
    sine_amplitude: float = 5.0  # [% FS]
    sine_mean: float = 50.0  # [% FS]
    frequencies: tuple[float, ...] = ()  # if empty, the bench selects them from the response time [Hz]
    setpoints: tuple[float, ...] = (25.0, 50.0, 75.0)  # for the tests of flow, supply and leakage [% FS]
    sweep_time: float = math.nan  # full range; NaN: the bench selects it from the response time [s]
    rated_flow: float = math.nan  # flow for droop and rise; NaN if not specified [kg/s]
    longest_hold: float = 300.0  # time limit for settling [s]


class Pace(NamedTuple):
    """Settling time and sweep time of a test valve, which determine the durations of trials.

    Both times are valid for the first volume of the settings.
    """

    specimen: Specimen
    settings: BenchSettings
    hold: float  # settling time [s]
    sweep: Callable[[], float]  # duration of a slow sweep over the full range [s]

    @property
    def volume(self) -> float:
        """Volume at the outlet during the trials [m^3]."""
        return self.settings.volumes[0]


def constant_setpoint(scale: Scale, setpoint: float) -> Constant:
    """Return a signal with a constant setpoint.

    `setpoint` is in % FS, and the signal in the unit of the scale.
    """
    return Constant(float(scale.setpoint(setpoint)))


AT_MOST, AT_LEAST = "at most", "at least"
STATIC, DYNAMIC = "ISO 10094-1, -2: static tests", "ISO 10094-1, -2: dynamic tests"
VERIFY = "verify against the standard"  # the text of the standard was not available for the definitions
Row = dict[str, Any]


@dataclass(frozen=True)
class BenchTest:
    """Type of test on the bench: its trials, its required channels and its evaluation."""

    name: str  # as in `--tests`; its texts are in `core/messages/bench.toml`
    evaluate: Callable[[Evaluation, Sequence[Record]], None]  # adds results of records to an `Evaluation`
    units: Mapping[str, str]  # units by characteristic value; descriptions are in `core/messages/figure.toml`
    facts: Mapping[str, float] = field(default_factory=dict)  # numbers in these texts: bands, levels, ranges
    # Trials that are known in advance; those of steps and sines depend on previous results.
    trials: Callable[[Pace], list[Trial]] | None = None
    table: str = ""  # name of the table of cases in a result; by default the name of the test
    part: str = STATIC  # part of the standard
    # Required series in addition to setpoint and outlet. Such tests have a constant setpoint, which can be stated
    # instead of recorded.
    needs: str = ""
    # Series without any clipped samples; tests with their own check name none.
    whole: tuple[str, ...] = ()
    smallest: tuple[str, ...] = ()  # values that are the smallest of all cases; others are the largest

    @property
    def meaning(self) -> str:
        """Description of the test for reports."""
        return sentence(f"bench.test.{self.name}", {})

    @property
    def definitions(self) -> Mapping[str, Definition]:
        """Definitions of the characteristic values of this test, by name."""
        return {name: Definition(name, unit, self) for name, unit in self.units.items()}

    def evaluate_records(self, records: Sequence[Record], scale: Scale, rated_flow: float = math.nan) -> Evaluation:
        """Evaluate the records of this test.

        A record is omitted, with a note, if a required channel is missing or has clipped samples. `rated_flow` is the
        mass flow rate [kg/s] at which the pressure changes due to forward flow (droop) and relief flow (rise) are
        evaluated.
        """
        evaluation = Evaluation(self, scale, rated_flow)
        complete = [record for record in records if not self.needs or getattr(record, self.needs).size]
        for record in records:
            if record not in complete:
                evaluation.note(f"unrecorded.{self.needs}", record.name)
        clipped = [record for record in complete if self.whole and record.has_clipped_samples(*self.whole)]
        for record in clipped:
            evaluation.note("clipped", record.name)
        self.evaluate(evaluation, [record for record in complete if record not in clipped])
        if clipped:
            evaluation.limit_to_bounds(*self.units)
        return evaluation


@dataclass(frozen=True)
class Definition:
    """Definition of one characteristic value: its name, unit and test."""

    name: str
    unit: str
    of: BenchTest

    @property
    def text(self) -> str:
        """Description of the characteristic value, without the numbers in `limits`."""
        return sentence(f"figure.{self.name}.text", self.of.facts)

    @property
    def limits(self) -> str:
        """Numbers of the definition as text, for example the width of the settling band."""
        return sentence(f"figure.{self.name}.limits", self.of.facts)

    @property
    def full(self) -> str:
        """Description of the characteristic value, followed by the text of `limits`."""
        return f"{self.text} {self.limits}"

    @property
    def standard(self) -> str:
        """Part of ISO 10094 that defines the value, as text.

        The text advises the reader to verify the definition against the standard.
        """
        return f"{self.of.part}; {VERIFY}"


@dataclass(frozen=True)
class CharacteristicValue:
    """Measured characteristic value, with its unit, definition, operating conditions and uncertainty."""

    value: float  # in `unit`; finite
    unit: str
    definition: str  # description with its limits
    bound: str = ""  # `at most` or `at least` if the value is a limit of the test, else empty
    conditions: Mapping[str, Any] = field(default_factory=dict)  # conditions of the value
    # Standard uncertainty and 95 % confidence interval; None for bounds, or if not determined.
    uncertainty: float | None = None
    interval: tuple[float, float] | None = None


@dataclass(frozen=True, eq=False)
class PlottedCurve:
    """Curve `y` versus `x` for the figures, in the units of the axes.

    Curves with the same `case` are drawn in the same axes.
    """

    name: str
    case: str
    x: FloatArray
    y: FloatArray


@dataclass
class Evaluation:
    """Results of one type of test.

    They are the characteristic values, a table with one row per case, curves, notes and conditions. A case is, for
    example, one step or one sine.
    """

    test: BenchTest
    scale: Scale
    rated_flow: float = math.nan  # flow for droop and rise; NaN if not specified [kg/s]
    figures: dict[str, CharacteristicValue] = field(default_factory=dict)
    rows: list[Row] = field(default_factory=list)  # one per case
    curves: list[PlottedCurve] = field(default_factory=list)  # for pictures
    notes: list[Note] = field(default_factory=list)  # findings, and the reason of each absent value
    conditions: dict[str, Any] = field(default_factory=dict)
    uncertainties: dict[tuple[int, str], Uncertainty] = field(default_factory=dict)  # by the id of a row and its key

    def set_value(self, row: Row, key: str, value: float, uncertainty: Uncertainty) -> None:
        """Store a value with its uncertainty in a row of the results table.

        `key` is the column of the value. The standard uncertainty is stored in the column `key` with the ending
        `_uncertainty`.
        """
        row |= {key: value, f"{key}_uncertainty": uncertainty.standard}
        self.uncertainties[id(row), key] = uncertainty

    def values_of(self, rows: Sequence[Row], key: str) -> tuple[list[float], list[Uncertainty]]:
        """Return one column of some rows of the results table, and its uncertainties.

        `key` is the name of the column.
        """
        return [row[key] for row in rows], [self.uncertainties[id(row), key] for row in rows]

    def add_curve(self, name: str, case: str, x: FloatArray, y: FloatArray) -> None:
        """Add a curve `y` versus `x` for the figures, without points whose `y` is undefined."""
        is_known = np.isfinite(y)
        self.curves.append(PlottedCurve(name, case, x[is_known], y[is_known]))

    def note(self, code: str, address: str = "", /, **facts: Any) -> None:
        """Add a note, unless an equal note exists.

        `code` is the note code without the prefix `bench.`, and the keyword arguments are the values in the text of the
        note.
        """
        note = Note(f"bench.{code}", address, **facts)
        if note not in self.notes:
            self.notes.append(note)

    def note_absence(self, reason: str, *names: str, **facts: Any) -> None:
        """Add a note for each characteristic value that could not be determined.

        The further arguments are the names of these values, and `reason` is the last part of the note code.
        """
        for name in names:
            self.note(f"absent.{reason}", name, **facts)

    def limit_to_bounds(self, *names: str) -> None:
        """Replace characteristic values by bounds, because clipped cases were omitted.

        The arguments are the names of these values. A value that is the maximum of all cases becomes a lower bound,
        because an omitted case could be larger. A value that is the minimum becomes an upper bound. Other values are
        removed, with a note.
        """
        for name in names:
            bound = AT_MOST if name in self.test.smallest else AT_LEAST
            figure = self.figures.get(name)
            if figure is not None and figure.bound in ("", bound) and figure.value >= 0.0:
                self.figures[name] = replace(figure, bound=bound, uncertainty=None, interval=None)
            else:
                self.remove_values(name)

    def remove_values(self, *names: str) -> None:
        """Remove characteristic values that clipped samples make invalid, and add a note for each."""
        for name in names:
            self.figures.pop(name, None)
            self.notes = [n for n in self.notes if not (n.address == name and n.code.startswith("bench.absent."))]
            self.note_absence("clipped", name)

    def add(
        self, name: str, value: float, uncertainty: Uncertainty | None = None, *, bound: str = "", **conditions: Any
    ) -> None:
        """Add a characteristic value with its uncertainty and operating conditions.

        If the value is only a bound, the keyword `bound` is `at most` or `at least`. A note reports a value without a
        finite uncertainty.
        """
        definition = self.test.definitions[name]
        figure = CharacteristicValue(float(value), definition.unit, definition.full, bound, conditions)
        if not bound and uncertainty is not None and math.isfinite(uncertainty.standard):
            low, high = uncertainty.interval(float(value))
            figure = replace(figure, uncertainty=uncertainty.standard, interval=(float(low), float(high)))
        elif not bound:
            self.note("doubtful", name)
        self.figures[name] = figure

    def add_or_bound(
        self, name: str, value: float, limit: float, uncertainty: Uncertainty | None = None, **conditions: Any
    ) -> None:
        """Add a characteristic value, or an upper bound if noise hides it.

        `limit` is the smallest magnitude that can be distinguished from noise. If the value is smaller than `limit`,
        `limit` is added as the upper bound.
        """
        if abs(value) >= limit:
            self.add(name, value, uncertainty, **conditions)
            return
        self.note("below_noise", name, least=limit, unit=self.test.units[name])
        self.add(name, limit, bound=AT_MOST, **conditions)

    def add_nonnegative(self, name: str, value: float, uncertainty: Uncertainty, **conditions: Any) -> None:
        """Add a nonnegative characteristic value, or an upper bound if noise alone explains it."""
        half = NORMAL * uncertainty.standard
        self.add_or_bound(name, value, 0.0 if value > half else max(value, 0.0) + half, uncertainty, **conditions)

    def add_greatest(
        self, name: str, key: str, reason: str = "", *, rows: Sequence[Row] | None = None,
        conditions: Sequence[str] = (), is_nonnegative: bool = False, **facts: Any,
    ) -> Row | None:  # fmt: skip
        """Add the largest value of a table column as a characteristic value.

        `name` is the characteristic value, and `key` the column. By default, all rows of the evaluation are compared.
        The keyword `conditions` contains the columns that are stored as operating conditions. The result is the row of
        the largest value. If no row has the value, the result is None, and a note with the code `reason` is added
        unless `reason` is empty.
        """
        rows = [row for row in (self.rows if rows is None else rows) if key in row]
        if not rows:
            self.note_absence(reason, *[name] * bool(reason))
            return None
        value, uncertainty, k = greatest(*self.values_of(rows, key))
        case = {condition: rows[k][condition] for condition in conditions if condition in rows[k]} | facts
        (self.add_nonnegative if is_nonnegative else self.add)(name, value, uncertainty, **case)
        return rows[k]


def largest(rows: Sequence[Row], key: str) -> Row | None:
    """Return the row with the largest value in the column `key`.

    The result is None if no row has a value in this column.
    """
    return max((row for row in rows if key in row), key=lambda row: float(row[key]), default=None)
