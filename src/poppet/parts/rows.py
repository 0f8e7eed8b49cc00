"""A table of a part whose every entry is a number of the circuit: gains over operating points, forces of a muscle."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, ClassVar, Self

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, OutOfRangeError
from poppet.core.provenance import Number, Source
from poppet.parts.fields import NumberSpec, read_number


@dataclass(frozen=True)
class NumberTable:
    """Columns of numbers, of which the first rises from row to row."""

    columns: Mapping[str, tuple[Number, ...]]
    form: tuple[str, ...] = ()
    """What its columns depend on."""

    field: ClassVar[str]
    """The field of the part that takes the table."""

    @classmethod
    def known(cls, *form: str) -> Mapping[str, NumberSpec]:
        """Columns, the rising one first; no table can do without those that are not optional."""
        raise NotImplementedError

    @classmethod
    def read(cls, given: Any, *form: str) -> Self:
        """Of a table of lists."""
        if isinstance(given, cls):
            if given.form == form:
                return given
            given = given.columns
        field, known = cls.field, cls.known(*form)
        needed = [name for name, spec in known.items() if not spec.optional]
        if not isinstance(given, Mapping):
            raise InputError("schedule.not_a_table", field, value=given, needed=needed)
        unknown, missing = [k for k in given if k not in known], [k for k in needed if k not in given]
        columns = {}
        with ErrorCollector() as errors:
            errors.extend(
                InputError("schedule.unknown", f"{field}.{key}", near=NameSuggestion(key, known)) for key in unknown
            )
            errors.extend(InputError("schedule.missing", f"{field}.{key}") for key in missing)
            for name, spec in known.items():
                if name in given:
                    with errors.collecting():
                        columns[name] = cls._column(name, spec, given[name])
        lengths = {name: len(column) for name, column in columns.items()}
        if len(set(lengths.values())) != 1 or lengths[needed[0]] < 2:
            shown = [f"{name} {length}" for name, length in lengths.items()]
            raise InputError("schedule.unequal_lengths", field, lengths=shown)
        return cls(columns, form)

    @classmethod
    def _column(cls, name: str, spec: NumberSpec, given: Any) -> tuple[Number, ...]:
        if isinstance(given, str) or not isinstance(given, Sequence):
            raise InputError("schedule.not_a_list", f"{cls.field}.{name}", value=given)
        return tuple(read_number(f"{cls.field}.{name}_{k}", spec, value) for k, value in enumerate(given, 1))

    def numbers(self) -> dict[str, Number]:
        """Every number: `pressure_1`, `gain_1`, ..."""
        return {f"{name}_{k}": n for name, column in self.columns.items() for k, n in enumerate(column, 1)}

    def parameters(self, ambient_pressure: float) -> dict[str, float]:
        """Run-time values under the names of `numbers`."""
        values = {name: number.absolute(ambient_pressure) for name, number in self.numbers().items()}
        rising = next(iter(self.columns))
        points = self.column(rising, values)
        if any(a >= b for a, b in pairwise(points)):
            raise OutOfRangeError("schedule.not_rising", f"{self.field}.{rising}", points=points)
        return values

    def column(self, name: str, values: Mapping[str, Any]) -> list[Any]:
        """A column of run-time values, floats or symbols."""
        return [values[f"{name}_{k}"] for k in range(1, len(self.columns[name]) + 1)]

    def structure(self) -> Hashable:
        """Columns and number of rows."""
        return tuple(self.columns), len(next(iter(self.columns.values())))

    def with_numbers(self, changes: Mapping[str, Number]) -> Self:
        """The same table with some numbers replaced."""
        given = {
            name: [changes.get(f"{name}_{k}", n) for k, n in enumerate(column, 1)]
            for name, column in self.columns.items()
        }
        return self.read(given, *self.form)


def as_numbers(values: Sequence[float], unit: str, source: Source) -> tuple[Number, ...]:
    """Plain values as numbers of a column, with where they come from."""
    return tuple(Number(float(value), unit, source) for value in values)
