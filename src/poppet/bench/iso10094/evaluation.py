"""What a test of the bench is, and what it finds in its records: figures, rows for each case, curves, and notes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from poppet.bench.iso10094.bench_settings import Pace, Trial
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.uncertainty import NORMAL, Uncertainty
from poppet.core.codes import Note
from poppet.core.message_format import sentence

AT_MOST, AT_LEAST = "at most", "at least"
STATIC, DYNAMIC = "ISO 10094-1, -2: static tests", "ISO 10094-1, -2: dynamic tests"
VERIFY = "verify against the standard"
"""The standard's own wording was not at hand for any of the definitions."""
Row = dict[str, Any]


@dataclass(frozen=True)
class BenchTest:
    """One test: what is done in it, what it needs, and what is made of its records."""

    name: str  # as in `--tests`; its words stand in `core/messages/bench.toml`
    evaluate: Callable[[Evaluation, Sequence[Record]], None]  # enters into an `Evaluation` what some records show
    units: Mapping[str, str]  # figure to its unit; what they are stands in `core/messages/figure.toml`
    facts: Mapping[str, float] = field(default_factory=dict)  # numbers in those words: bands, levels, ranges
    # What is to be run, where that is known beforehand: steps and sines are led by what they find.
    trials: Callable[[Pace], list[Trial]] | None = None
    table: str = ""  # of its cases in a result; named as the test where it is empty
    part: str = STATIC  # part of the standard to which it belongs
    # Series that its records must have beside setpoint and outlet. Tests with one are done at a constant setpoint,
    # which may be written instead of recorded.
    needs: str = ""
    # Series of which a record must not have clipped samples anywhere; tests that look closer themselves name none.
    whole: tuple[str, ...] = ()
    smallest: tuple[str, ...] = ()  # figures that are the smallest of all cases, where others are the largest

    @property
    def meaning(self) -> str:
        """What is done in it."""
        return sentence(f"bench.test.{self.name}", {})

    @property
    def definitions(self) -> Mapping[str, Definition]:
        """Its figures by name."""
        return {name: Definition(name, unit, self) for name, unit in self.units.items()}

    def evaluated(self, records: Sequence[Record], scale: Scale, rated_flow: float = math.nan) -> Evaluation:
        """Everything that its records show."""
        found = Evaluation(self, scale, rated_flow)
        complete = [record for record in records if not self.needs or getattr(record, self.needs).size]
        for record in records:
            if record not in complete:
                found.note(f"unrecorded.{self.needs}", record.name)
        lost = [record for record in complete if self.whole and record.cuts(*self.whole)]
        for record in lost:
            found.note("clipped", record.name)
        self.evaluate(found, [record for record in complete if record not in lost])
        if lost:
            found.lack(*self.units)
        return found


@dataclass(frozen=True)
class Definition:
    """What a figure is, and in which test it is found."""

    name: str
    unit: str
    of: BenchTest

    @property
    def text(self) -> str:
        """What it is."""
        return sentence(f"figure.{self.name}.text", self.of.facts)

    @property
    def limits(self) -> str:
        """Rates, bands and limits on which it depends."""
        return sentence(f"figure.{self.name}.limits", self.of.facts)

    @property
    def full(self) -> str:
        """What it is, with its limits."""
        return f"{self.text} ({self.limits})"

    @property
    def standard(self) -> str:
        """Part of the standard, and that its wording has to be compared."""
        return f"{self.of.part}; {VERIFY}"


@dataclass(frozen=True)
class CharacteristicValue:
    """A figure of a valve."""

    value: float  # in `unit`; finite
    unit: str
    definition: str  # what it is, in words, with its limits
    bound: str = ""  # `at most` or `at least` where the value is a limit of what the test can tell; empty for a value
    conditions: Mapping[str, Any] = field(default_factory=dict)  # what it holds for
    # Standard uncertainty, and the interval of 95 %; None for bounds, and where it could not be determined.
    uncertainty: float | None = None
    interval: tuple[float, float] | None = None


@dataclass(frozen=True, eq=False)
class Curve:
    """A line of a picture, `x` and `y` in the units of the test's axes; curves of one `case` share axes."""

    name: str
    case: str
    x: FloatArray
    y: FloatArray


@dataclass
class Evaluation:
    """All that is found in the records of one test."""

    test: BenchTest
    scale: Scale
    rated_flow: float = math.nan  # at which droop and rise are read; NaN where none was given [kg/s]
    figures: dict[str, CharacteristicValue] = field(default_factory=dict)
    rows: list[Row] = field(default_factory=list)  # one per case
    curves: list[Curve] = field(default_factory=list)  # for pictures
    notes: list[Note] = field(default_factory=list)  # findings, and the reason of each figure that is absent
    conditions: dict[str, Any] = field(default_factory=dict)
    doubts: dict[tuple[int, str], Uncertainty] = field(default_factory=dict)  # by the place of a row and its key

    def know(self, row: Row, key: str, value: float, doubt: Uncertainty) -> None:
        """Enter a value of a row with its uncertainty."""
        row |= {key: value, f"{key}_uncertainty": doubt.standard}
        self.doubts[id(row), key] = doubt

    def known(self, rows: Sequence[Row], key: str) -> tuple[list[float], list[Uncertainty]]:
        """Values of rows with their doubts."""
        return [row[key] for row in rows], [self.doubts[id(row), key] for row in rows]

    def note(self, code: str, address: str = "", /, **facts: Any) -> None:
        """Enter a finding once."""
        note = Note(f"bench.{code}", address, **facts)
        if note not in self.notes:
            self.notes.append(note)

    def absent(self, reason: str, *names: str, **facts: Any) -> None:
        """Enter why figures are not there."""
        for name in names:
            self.note(f"absent.{reason}", name, **facts)

    def lack(self, *names: str) -> None:
        """Some cases rest on clipped samples: figures that are the largest or smallest of the others are bounds."""
        for name in names:
            bound = AT_MOST if name in self.test.smallest else AT_LEAST
            figure = self.figures.get(name)
            if figure is not None and figure.bound in ("", bound) and figure.value >= 0.0:
                self.figures[name] = replace(figure, bound=bound, uncertainty=None, interval=None)
            else:
                self.withhold(name)

    def withhold(self, *names: str) -> None:
        """Take figures back that rest on clipped samples."""
        for name in names:
            self.figures.pop(name, None)
            self.notes = [n for n in self.notes if not (n.address == name and n.code.startswith("bench.absent."))]
            self.absent("clipped", name)

    def add(
        self, name: str, value: float, doubt: Uncertainty | None = None, *, bound: str = "", **conditions: Any
    ) -> None:
        """Enter a figure, with what is not known of it."""
        definition = self.test.definitions[name]
        figure = CharacteristicValue(float(value), definition.unit, definition.full, bound, conditions)
        if not bound and doubt is not None and math.isfinite(doubt.standard):
            figure = replace(figure, uncertainty=doubt.standard, interval=_floats(doubt.interval(float(value))))
        elif not bound:
            self.note("doubtful", name)
        self.figures[name] = figure

    def add_seen(
        self, name: str, value: float, least: float, doubt: Uncertainty | None = None, **conditions: Any
    ) -> None:
        """Enter a figure, or a bound where it is smaller than what noise alone would make."""
        if abs(value) >= least:
            self.add(name, value, doubt, **conditions)
            return
        self.note("below_noise", name, least=least, unit=self.test.units[name])
        self.add(name, least, bound=AT_MOST, **conditions)

    def add_judged(self, name: str, value: float, doubt: Uncertainty, **conditions: Any) -> None:
        """Enter a figure that is never below zero, or a bound where noise does not tell it from nothing."""
        half = NORMAL * doubt.standard
        self.add_seen(name, value, 0.0 if value > half else max(value, 0.0) + half, doubt, **conditions)

    def add_largest(
        self, name: str, key: str, reason: str, *, rows: Sequence[Row] | None = None, **conditions: str
    ) -> None:
        """Enter the largest value that rows have under a key, with its bound there; else the reason why there is none.

        A condition is given by the key under which the row has it, and left out where it has none.
        """
        row = largest(self.rows if rows is None else rows, key)
        if row is None:
            self.absent(reason, name)
            return
        known = {condition: row[source] for condition, source in conditions.items() if source in row}
        self.add(name, row[key], bound=row.get(f"{key}_bound", ""), **known)


def _floats(ends: tuple[float, float]) -> tuple[float, float]:
    return float(ends[0]), float(ends[1])


def largest(rows: Sequence[Row], key: str) -> Row | None:
    """The row with the largest value of a key; None where no row has one."""
    return max((row for row in rows if key in row), key=lambda row: float(row[key]), default=None)
