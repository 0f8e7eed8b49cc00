"""Shared parts of the methods that read files with measured columns: fields, columns in SI units, file arguments."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from functools import wraps
from pathlib import Path
from typing import Any, NamedTuple, TypeVar, cast

import numpy as np

from poppet.circuit.options import Ambient
from poppet.core.errors import InputError, UnitError, relocated
from poppet.core.tables import Field
from poppet.core.units import Kind, convert, quantity, with_state
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.tables.reading import Table, read_table

Function = TypeVar("Function", bound=Callable[..., Any])
TABLE_OPTIONS = ("separator", "decimal", "header_rows", "group")
FILE_FIELDS = {
    "title": Field(type="text"),
    "part": Field(type="text", default="", meaning="name of the part in a circuit"),
    **dict.fromkeys((*TABLE_OPTIONS, "ambient_pressure"), Field()),
    "file": Field(is_required=True, meaning="table with the data", example='file = "points.csv"'),
}
"""Fields that each file with measured columns can have."""


class ColumnReading(NamedTuple):
    """Values of one data column in SI units, with absolute pressures."""

    values: FloatArray
    written_unit: str
    unit: str  # unit as written in the file, with the reference condition if the reader added one


def channel_field(name: str, *, is_required: bool = False) -> Field:
    """Return the declaration of the field that describes the channel `name` in a data file."""
    return Field(type="table", is_required=is_required, example=f'{name} = {{ column = "...", unit = "..." }}')


def read_ambient(fields: Mapping[str, Any]) -> float:
    """Return the ambient pressure that an input file states [Pa].

    It is the reference of gauge pressures in the file.
    """
    try:
        return float(Ambient(pressure=fields.get("ambient_pressure", "1 bar")).pressure)  # type: ignore[arg-type]
    except InputError as error:
        raise relocated(error, "ambient_{}".format) from None


def open_table(folder: Path, name: Any, fields: Mapping[str, Any]) -> Table:
    """Read the data table `name`, to which a TOML file refers.

    `folder` is the folder of the TOML file, and `fields` contains options for reading the table.
    """
    return read_table(folder / str(name), **{key: fields[key] for key in TABLE_OPTIONS if key in fields})


def read_column(
    channel: str, fields: Mapping[str, Any], table: Table, unit: str, kind: Kind, ambient_pressure: float
) -> ColumnReading:
    """Read the column of one channel, and convert it to the SI unit `unit`.

    `fields` describes the column in `table`, and `kind` is the kind of quantity, such as a pressure. `ambient_pressure`
    is the reference of gauge pressures [Pa].
    """
    try:
        index = table.index(fields["column"])
        written_unit = str(fields.get("unit", table.units[index]))
        if not written_unit and unit != "1":
            raise UnitError("flow.no_unit", channel, unit=unit)
        full_unit = with_state(written_unit)
        if full_unit:  # `convert` accepts each unit of the dimension; `quantity` rejects other quantities
            quantity(f"1 {full_unit}", unit, kind=kind, name=f"{channel}.unit")
        values = convert(table.columns[index], full_unit or "1", unit, ambient_pressure=ambient_pressure)
        return ColumnReading(np.asarray(values), written_unit, full_unit)
    except InputError as error:
        raise error.located(address=channel) from None


def or_file(read: Callable[[str | Path], tuple[Any, dict[str, Any]]]) -> Callable[[Function], Function]:
    """Return a decorator with which a function of data also accepts the path of a file.

    The function `read` reads the file and returns the data and keyword arguments. Keyword arguments of the call
    override the keyword arguments from the file.
    """

    def decorate(function: Function) -> Function:
        first = next(iter(inspect.signature(function).parameters))

        @wraps(function)
        def call(*data: Any, **keywords: Any) -> object:
            path = data[0] if data else keywords.get(first)
            if not isinstance(path, str | Path):
                return function(*data, **keywords)
            argument_from_file, options = read(path)
            return function(**{**options, **keywords, first: argument_from_file})

        return cast(Function, call)

    return decorate
