"""What files that name measured columns share: the options of a table, its surroundings, and a column in SI units."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from poppet.circuit.options import Ambient
from poppet.core.errors import InputError, UnitError, relocated
from poppet.core.tables import Field
from poppet.core.units import Kind, convert, quantity, with_state
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.tables.reading import Table, read_table

TABLE_OPTIONS = ("separator", "decimal", "header_rows", "group")
TOP_LEVEL = {
    **dict.fromkeys(("title", "part", *TABLE_OPTIONS, "ambient_pressure"), Field()),
    "file": Field(is_required=True, meaning="table with the data", example='file = "points.csv"'),
}
"""Fields of all these files."""


def ambient_of(data: Mapping[str, Any]) -> float:
    """What gauge pressures of a file refer to [Pa]."""
    try:
        return float(Ambient(pressure=data.get("ambient_pressure", "1 bar")).pressure)  # type: ignore[arg-type]
    except InputError as error:
        raise relocated(error, "ambient_{}".format) from None


def table_of(folder: Any, name: Any, data: Mapping[str, Any]) -> Table:
    """A table beside the file, read as it says."""
    return read_table(folder / str(name), **{each: data[each] for each in TABLE_OPTIONS if each in data})


def column(
    channel: str, own: Mapping[str, Any], table: Table, unit: str, kind: Kind, ambient: float
) -> tuple[FloatArray, str, str]:
    """Readings of a channel in SI, pressures absolute; their unit as it was written, and as it was read."""
    try:
        place = table.index(own["column"])
        written = str(own.get("unit", table.units[place]))
        if not written and unit != "1":
            raise UnitError("flow.no_unit", channel, unit=unit)
        stated = with_state(written)
        if stated:  # converting takes any unit of the dimension; this refuses what is another quantity
            quantity(f"1 {stated}", unit, kind=kind, name=f"{channel}.unit")
        return np.asarray(convert(table.columns[place], stated or "1", unit, ambient_pressure=ambient)), written, stated
    except InputError as problem:
        raise problem.located(address=channel) from None
