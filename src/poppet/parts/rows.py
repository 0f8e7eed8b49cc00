"""Tables of numbers in parts: forces of a muscle, gains over operating points."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, ClassVar, Self

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, OutOfRangeError
from poppet.core.provenance import Number, Source
from poppet.core.symbolic import clip, is_certain
from poppet.core.tables import Field, missing_field
from poppet.laws.physics.muscle import ForceTable
from poppet.parts.fields import NumberSpec, read_number
from poppet.parts.quantities import OPENING, QUANTITIES, gain_unit


@dataclass(frozen=True)
class NumberTable:
    """Base class of tables of numbers in named columns.

    The values in the first column increase from row to row.
    """

    columns: Mapping[str, tuple[Number, ...]]
    form: tuple[str, ...] = ()
    """Options that determine the columns."""

    field: ClassVar[str]
    """Field of the part that contains the table."""

    @classmethod
    def column_specs(cls, *form: str) -> Mapping[str, NumberSpec]:
        """Return the declaration of each column by name, in the order of the columns.

        The keyword arguments are options that determine the columns, such as the commanded quantity.
        """
        raise NotImplementedError

    @classmethod
    def read(cls, table: Any, *form: str) -> Self:
        """Read and check a table from a mapping of column names to lists of values.

        The keyword arguments are options that determine the columns, such as the commanded quantity.
        """
        if isinstance(table, cls):
            if table.form == form:
                return table
            table = table.columns
        field, column_specs = cls.field, cls.column_specs(*form)
        required = [name for name, spec in column_specs.items() if not spec.optional]
        if not isinstance(table, Mapping):
            raise InputError("schedule.not_a_table", field, value=table, needed=required)
        unknown, missing = [k for k in table if k not in column_specs], [k for k in required if k not in table]
        columns = {}
        with ErrorCollector() as errors:
            for key in unknown:
                near = NameSuggestion(key, column_specs)
                errors.add("fields.unknown", f"{field}.{key}", table=f"table {field}", suggestion=near)
            for key in missing:
                column = Field(meaning=f"column {key}", example="a list with one value for each row")
                errors.extend([missing_field(f"{field}.{key}", column)])
            for name, spec in column_specs.items():
                if name in table:
                    with errors.collecting():
                        values, address = table[name], f"{field}.{name}"
                        if isinstance(values, str) or not isinstance(values, Sequence):
                            raise InputError("schedule.not_a_list", address, value=values)
                        columns[name] = tuple(read_number(f"{address}_{k}", spec, v) for k, v in enumerate(values, 1))
        lengths = {name: len(column) for name, column in columns.items()}
        if len(set(lengths.values())) != 1 or lengths[required[0]] < 2:
            texts = [f"{name} {length}" for name, length in lengths.items()]
            raise InputError("schedule.unequal_lengths", field, lengths=texts)
        return cls(columns, form)

    def numbers(self) -> dict[str, Number]:
        """Return all numbers of the table, named by column and row number.

        Examples of names are `pressure_1` and `gain_1`.
        """
        return {f"{name}_{k}": n for name, column in self.columns.items() for k, n in enumerate(column, 1)}

    def number_specs(self) -> dict[str, NumberSpec]:
        """Return the declaration of each number, under the names that `numbers` returns."""
        specs = self.column_specs(*self.form)
        return {f"{name}_{k}": specs[name] for name in self.columns for k in range(1, len(self.columns[name]) + 1)}

    def ascending_numbers(self) -> tuple[tuple[str, str], ...]:
        """Return the pairs of names of consecutive numbers in the first column."""
        first = next(iter(self.columns))
        return tuple(pairwise(f"{first}_{k}" for k in range(1, len(self.columns[first]) + 1)))

    def parameters(self, ambient_pressure: float) -> dict[str, float]:
        """Return the values of all numbers of the table in SI units, with absolute pressures.

        The names are those that `numbers` returns. `ambient_pressure` is the reference of gauge values [Pa].
        """
        values = {name: number.absolute(ambient_pressure) for name, number in self.numbers().items()}
        first_column = next(iter(self.columns))
        points = self.column(first_column, values)
        if any(is_certain(a >= b) for a, b in pairwise(points)):
            raise OutOfRangeError("schedule.not_rising", f"{self.field}.{first_column}", points=points)
        return values

    def column(self, name: str, values: Mapping[str, Any]) -> list[Any]:
        """Return the values in the column `name`, one for each row.

        `values` contains the values of the complete table, under the names that `numbers` returns.
        """
        return [values[f"{name}_{k}"] for k in range(1, len(self.columns[name]) + 1)]

    def structure(self) -> Hashable:
        """Return the column names and the number of rows: tables that share them have the same equations."""
        return tuple(self.columns), len(next(iter(self.columns.values())))

    def with_numbers(self, changes: Mapping[str, Number]) -> Self:
        """Return a copy of the table in which some numbers are replaced."""
        numbers = self.numbers() | dict(changes)
        return self.read({name: self.column(name, numbers) for name in self.columns}, *self.form)


def as_numbers(values: Sequence[float], unit: str, source: Source) -> tuple[Number, ...]:
    """Convert values in SI units to `Number` objects with a unit and a source."""
    return tuple(Number(float(value), unit, source) for value in values)


_COLUMNS = {
    "contraction": NumberSpec("1", "contraction", low=-0.2, below=1.0),
    "force_per_pressure": NumberSpec("N/Pa", "force per gauge pressure"),
    "passive_force": NumberSpec("N", "force without gauge pressure"),
}


@dataclass(frozen=True)
class ForceRows(NumberTable):
    """Table of a muscle force: force per gauge pressure and passive force for each contraction.

    Values between the rows are interpolated linearly.

    Parameters
    ----------
    columns : mapping
        Mapping from the name of each column to its numbers, one for each contraction.

    Examples
    --------
    >>> rows = {"contraction": [0.0, 0.1], "force_per_pressure": ["300 N/bar", "100 N/bar"], "passive_force": [0, -99]}
    >>> table = ForceRows.read(rows)
    >>> round(table.law(table.parameters(1e5)).force(1e5, 0.1), 9)
    1.0
    """

    field: ClassVar[str] = "force_table"

    @classmethod
    def column_specs(cls, *form: str) -> Mapping[str, NumberSpec]:
        return _COLUMNS

    def law(self, values: Mapping[str, Any]) -> ForceTable:
        """Return the force law that the table defines.

        `values` contains the values of all numbers of the table, under the names that `numbers` returns.
        """
        return ForceTable(*(self.column(name, values) for name in _COLUMNS))


@dataclass(frozen=True)
class FrictionFactor(NumberTable):
    """Table of a factor on the friction of a body as a function of its position.

    Values between the rows are interpolated linearly. Beyond the ends of the table the factor is constant.

    Parameters
    ----------
    columns : mapping
        Mapping from the name of each column to its numbers, one for each position.
    form : tuple of str
        SI unit of the position.

    Examples
    --------
    >>> factor = FrictionFactor.read({"position": [0.0, "10 mm"], "factor": [1.0, 1.5]})
    >>> factor.at(0.005, factor.parameters(1e5))
    1.25
    """

    field: ClassVar[str] = "friction.position_factor"

    @classmethod
    def column_specs(cls, *form: str) -> Mapping[str, NumberSpec]:
        position = NumberSpec(form[0] if form else "m", "position of the body")
        return {"position": position, "factor": NumberSpec("1", "factor on the friction", above=0.0)}

    def at(self, position: Any, values: Mapping[str, Any]) -> Any:
        """Return the factor at a position of the body.

        `values` contains the values of all numbers of the table, under the names that `numbers` returns.
        """
        columns = {name: self.column(name, values) for name in self.columns}
        return _interpolate(position, columns.pop("position"), columns)["factor"]


_DEFAULTS = {"derivative_time": 0.0, "vent_factor": 1.0}


@dataclass(frozen=True)
class GainSchedule(NumberTable):
    """Table of controller gains for operating points.

    The gains are interpolated linearly. Beyond the ends of the table they are constant.

    Parameters
    ----------
    columns : mapping
        Mapping from the name of each column to its numbers, one for each operating point.
    form : tuple of str
        Measured quantity, which is the name of the first column, and commanded quantity.

    Examples
    --------
    >>> table = {"pressure": ["2 bar", "4 bar"], "gain": [1e-5, 3e-5], "integral_time": [0.1, 0.3]}
    >>> schedule = GainSchedule.read(table)
    >>> round(schedule.at(3e5, schedule.parameters(1e5))["gain"], 9)
    2e-05
    """

    field: ClassVar[str] = "schedule"

    @classmethod
    def column_specs(cls, *form: str) -> Mapping[str, NumberSpec]:
        quantity, command = form
        controlled = QUANTITIES[quantity]
        columns = {
            quantity: NumberSpec(controlled.unit, "operating point", kind=controlled.kind, low=controlled.low),
            "gain": NumberSpec(gain_unit(quantity, command), "gain"),
            "integral_time": NumberSpec("s", "integral time", above=0.0),
            "derivative_time": NumberSpec("s", "derivative time", low=0.0, optional=True),
        }
        factor = NumberSpec("1", "factor on commands to vent", above=0.0, optional=True)
        return columns | {"vent_factor": factor} if command == OPENING else columns

    @classmethod
    def read(cls, table: Any, *form: str) -> Self:
        return super().read(table, *(form or ("pressure", OPENING)))

    def at(self, point: Any, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return the controller gains by name at the operating point `point`, interpolated in the table.

        `values` contains the values of all numbers of the table, under the names that `numbers` returns.
        """
        columns = {name: self.column(name, values) for name in self.columns}
        points = columns.pop(self.form[0])
        return dict[str, Any](_DEFAULTS) | _interpolate(point, points, columns)


def _interpolate(point: Any, points: Sequence[Any], columns: Mapping[str, Sequence[Any]]) -> dict[str, Any]:
    """Return the value of each column at a point by linear interpolation.

    `points` contains the increasing points of the rows. Beyond its ends, the values are constant.
    """
    # The fraction of each gap below the point: a sum, which is traced without a branch.
    fractions = [clip((point - low) / (high - low), 0.0, 1.0) for low, high in pairwise(points)]
    return {
        name: column[0] + sum(a * (high - low) for a, (low, high) in zip(fractions, pairwise(column), strict=True))
        for name, column in columns.items()
    }


_SUCTION_COLUMNS = {
    "pressure": NumberSpec("Pa", "pressure at the vacuum port", kind="pressure", low=0.0),
    "suction_flow": NumberSpec("m^3/s ANR", "suction flow", kind="volume_flow_anr", low=0.0),
}


@dataclass(frozen=True)
class SuctionRows(NumberTable):
    """Suction curve of an ejector: suction flow for each pressure at the vacuum port.

    Values between the rows are interpolated linearly. The first row is the lowest pressure, at which the flow is 0.

    Parameters
    ----------
    columns : mapping
        Mapping from the name of each column to its numbers, one for each pressure.

    Examples
    --------
    >>> rows = {"pressure": ["-0.8 bar g", "0 bar g"], "suction_flow": [0, "30 l/min ANR"]}
    >>> curve = SuctionRows.read(rows)
    >>> depths, flows = curve.points(curve.parameters(1e5), 1e5)
    >>> [round(depth) for depth in depths], [round(flow * 60e3) for flow in flows]
    ([0, 80000], [30, 0])
    """

    field: ClassVar[str] = "suction_curve"

    @classmethod
    def column_specs(cls, *form: str) -> Mapping[str, NumberSpec]:
        return _SUCTION_COLUMNS

    @classmethod
    def read(cls, table: Any, *form: str) -> Self:
        result = super().read(table, *form)
        last = result.columns["suction_flow"][0]
        if is_certain(last.value != 0.0):
            raise InputError("vacuum.open_curve", "suction_curve.suction_flow_1", shown=last.display())
        return result

    def points(self, values: Mapping[str, Any], ambient_pressure: Any) -> tuple[list[Any], list[Any]]:
        """Return the vacuum [Pa] and the suction flow [m^3/s ANR] of all rows, in the order of increasing vacuum.

        `values` contains the values of all numbers of the table, under the names that `numbers` returns.
        """
        depths = [ambient_pressure - pressure for pressure in self.column("pressure", values)]
        return depths[::-1], self.column("suction_flow", values)[::-1]
