"""Measured flow capacities of the metering edges of a spool valve as functions of the position of the spool."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, raise_errors
from poppet.core.tables import Field, missing_field
from poppet.core.units import quantity
from poppet.laws.curves import Characteristic, characteristic_from_mapping
from poppet.parts.flow_path import read_table_file
from poppet.parts.spool_functions import SETPOINTS, position_of

CURVE_FIELDS = ("kind", "position", "command", "sonic_conductance", "critical_ratio", "source", "note")


def read_edge_curve(argument: Any, address: str, setpoint_type: str) -> Characteristic:
    """Read C and b of a metering edge as functions of the position of the spool.

    `argument` is a table with the fields `CURVE_FIELDS`, or the path of a .toml file with it. The argument of the
    returned characteristic is the position from -1 to 1 in place of a stroke. A column `command` has the unit of
    `setpoint_type`.
    """
    if isinstance(argument, Characteristic):
        if argument.domain != (-1.0, 1.0):
            raise InputError("spool.not_covered", address, low=argument.domain[0], high=argument.domain[1])
        return argument
    if isinstance(argument, str) and argument.endswith(".toml"):
        argument = read_table_file(argument, address)
    if not isinstance(argument, Mapping):
        raise InputError("spool.not_a_table", address, value=argument)
    with ErrorCollector() as errors:
        for key in argument:
            if key not in CURVE_FIELDS:
                near = NameSuggestion(key, CURVE_FIELDS)
                errors.add("fields.unknown", f"{address}.{key}", table=f"table {address}", suggestion=near)
        if (kind := argument.get("kind", "table")) != "table":
            near = NameSuggestion(str(kind), ["table"])
            errors.add("fields.not_an_option", f"{address}.kind", value=kind, meaning="kind of table", suggestion=near)
        with errors.collecting():
            positions = _read_positions(argument, address, setpoint_type)
    for name in ("sonic_conductance", "critical_ratio"):
        values = argument.get(name)
        if isinstance(values, Sequence) and not isinstance(values, str) and len(values) != len(positions):
            facts: dict[str, Any] = {"values": len(values), "positions": len(positions)}
            raise InputError("spool.unequal_lengths", f"{address}.{name}", **facts)
    table = {key: value for key, value in argument.items() if key not in ("position", "command")}
    try:
        return characteristic_from_mapping({"kind": "table", "stroke": positions} | table, name=address)
    except InputError as error:
        problems = list(error.problems)
        for k, problem in enumerate(problems):
            if problem.code == "curves.impossible_value":
                # The message contains the position of the spool in place of a stroke.
                facts = {key: problem.facts[key] for key in ("value", "unit", "symbol", "limits")}
                facts["position"] = 1e-3 * problem.facts["stroke_mm"]
                problems[k] = InputError("spool.impossible_value", problem.address, **facts)
        raise_errors(problems)
        raise


def _read_positions(table: Mapping[str, Any], address: str, setpoint_type: str) -> list[float]:
    """Return the positions of the spool in a table, which must increase from -1 to 1."""
    names = [name for name in ("position", "command") if name in table]
    if not names:
        example = "position = [-1, 0, 0.1, 1]"
        raise missing_field(f"{address}.position", Field(meaning="positions of the spool", example=example))
    if len(names) > 1:
        raise InputError("spool.two_columns", address)
    (name,) = names
    column, unit = table[name], "1"
    if name == "command" and setpoint_type in SETPOINTS:
        unit = SETPOINTS[setpoint_type][0]
    if isinstance(column, str) or not isinstance(column, Sequence) or len(column) < 2:
        raise InputError("spool.not_a_column", f"{address}.{name}", value=column)
    with ErrorCollector() as errors:
        values = []
        for k, raw in enumerate(column):
            with errors.collecting():
                values.append(quantity(raw, unit, name=f"{address}.{name}[{k}]").value)
    positions = values if unit == "1" else [position_of(value, setpoint_type) for value in values]
    for k, (left, right) in enumerate(pairwise(positions), start=2):
        if not left < right:
            facts = {"value": column[k - 1], "before": column[k - 2]}
            raise InputError("spool.not_rising", f"{address}.{name}", place=k, **facts)
    ends = positions[0], positions[-1]
    if max(abs(ends[0] + 1.0), abs(ends[1] - 1.0)) > 1e-9:
        raise InputError("spool.not_covered", f"{address}.{name}", low=ends[0], high=ends[1])
    return [-1.0, *positions[1:-1], 1.0]
