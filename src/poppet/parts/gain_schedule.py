"""Gains of a controller over operating points, interpolated."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from poppet.ground.errors import InputError, Mistakes, Near, OutOfRangeError
from poppet.ground.provenance import Number, Source
from poppet.ground.symbolic import clip
from poppet.parts.fields import NumberSpec, read_number

COLUMNS = {
    "pressure": NumberSpec("Pa", "operating point", kind="pressure", low=0.0),
    "gain": NumberSpec("1/Pa", "gain"),
    "integral_time": NumberSpec("s", "integral time", above=0.0),
    "derivative_time": NumberSpec("s", "derivative time", low=0.0),
    "vent_factor": NumberSpec("1", "factor on commands to vent", above=0.0),
}
NEEDED = ("pressure", "gain", "integral_time")
_OTHERWISE = {"derivative_time": 0.0, "vent_factor": 1.0}


@dataclass(frozen=True)
class GainSchedule:
    """Gains at operating points; between them straight lines, beyond them those of the last point.

    Parameters
    ----------
    columns : mapping
        Name of each column to its numbers, one per operating point.

    Examples
    --------
    >>> table = {"pressure": ["2 bar", "4 bar"], "gain": [1e-5, 3e-5], "integral_time": [0.1, 0.3]}
    >>> schedule = read_schedule(table)
    >>> round(schedule.at(3e5, schedule.parameters(1e5))["gain"], 9)
    2e-05
    """

    columns: Mapping[str, tuple[Number, ...]]

    def numbers(self) -> dict[str, Number]:
        """Every number: `pressure_1`, `gain_1`, ..."""
        return {f"{name}_{k}": n for name, column in self.columns.items() for k, n in enumerate(column, 1)}

    def parameters(self, ambient_pressure: float) -> dict[str, float]:
        """Run-time values under the names of `numbers`."""
        values = {name: number.absolute(ambient_pressure) for name, number in self.numbers().items()}
        points = [values[f"pressure_{k}"] for k in range(1, len(self.columns["pressure"]) + 1)]
        if any(a >= b for a, b in pairwise(points)):
            raise OutOfRangeError("schedule.not_rising", "schedule.pressure", points=points)
        return values

    def structure(self) -> Hashable:
        """Columns and number of points."""
        return tuple(self.columns), len(self.columns["pressure"])

    def with_numbers(self, changes: Mapping[str, Number]) -> GainSchedule:
        """The same schedule with some numbers replaced."""
        given = {
            name: [changes.get(f"{name}_{k}", n) for k, n in enumerate(column, 1)]
            for name, column in self.columns.items()
        }
        return read_schedule(given)

    def at(self, pressure: Any, values: Mapping[str, Any]) -> dict[str, Any]:
        """Gains at an operating point."""
        gaps = range(1, len(self.columns["pressure"]))
        steps = {name: [values[f"{name}_{k + 1}"] - values[f"{name}_{k}"] for k in gaps] for name in self.columns}
        # The part of each gap that lies below the operating point, 0..1: a sum, so that it traces without a branch.
        widths = zip(gaps, steps.pop("pressure"), strict=True)
        shares = [clip((pressure - values[f"pressure_{k}"]) / width, 0.0, 1.0) for k, width in widths]
        found: dict[str, Any] = dict(_OTHERWISE)
        for name, heights in steps.items():
            found[name] = values[f"{name}_1"] + sum(a * b for a, b in zip(shares, heights, strict=True))
        return found


def read_schedule(given: Any) -> GainSchedule:
    """A schedule from a table of lists."""
    if isinstance(given, GainSchedule):
        return given
    if not isinstance(given, Mapping):
        raise InputError("schedule.not_a_table", "schedule", value=given)
    unknown, missing = [key for key in given if key not in COLUMNS], [key for key in NEEDED if key not in given]
    columns = {}
    with Mistakes() as mistakes:
        mistakes.take(InputError("schedule.unknown", f"schedule.{key}", near=Near(key, COLUMNS)) for key in unknown)
        mistakes.take(InputError("schedule.missing", f"schedule.{key}") for key in missing)
        for name in [each for each in COLUMNS if each in given]:
            with mistakes.kept():
                columns[name] = _column(name, given[name])
    lengths = {name: len(column) for name, column in columns.items()}
    if len(set(lengths.values())) != 1 or lengths["pressure"] < 2:
        shown = [f"{name} {length}" for name, length in lengths.items()]
        raise InputError("schedule.unequal_lengths", "schedule", lengths=shown)
    return GainSchedule(columns)


def _column(name: str, given: Any) -> tuple[Number, ...]:
    if isinstance(given, str) or not isinstance(given, Sequence):
        raise InputError("schedule.not_a_list", f"schedule.{name}", value=given)
    spec = COLUMNS[name]
    return tuple(read_number(f"schedule.{name}_{k}", spec, value) for k, value in enumerate(given, 1))


def as_numbers(values: Sequence[float], unit: str, source: Source) -> tuple[Number, ...]:
    """Plain values as numbers of a column, with where they come from."""
    return tuple(Number(float(value), unit, source) for value in values)
